//! One result from those of the shards of a run, as the run itself would have written it.
//!
//! A shard judges its own cases alone; which rule a case is charged to, and what the peer is found to be, follows from
//! all of them. So [`merge`] takes of each shard only what became of the cases, and judges anew.

use std::collections::{HashMap, HashSet};
use std::time::Duration;

use crate::conclude::{Checked, Extent, not_asked, opened, own_notes, roles, selected};
use crate::peer::{Description, ExpectedFailure};
use crate::report::{Asked, CrashLogReport, PeerReport, RateReport, Report, RunReport, State};
use crate::run::{CaseRun, OutcomeKind};
use crate::suite::{Case, DESCRIBE, Pattern, Selection, Suite};
use crate::verdict::{Baseline, BaselineError};

/// Why results cannot be merged, or judged anew.
#[derive(Debug, thiserror::Error)]
pub enum MergeError {
    /// There is no result.
    #[error("there is no result to merge")]
    Nothing,
    /// A result is not that of a shard.
    #[error("the result that was begun at {0} is not that of a shard: it is whole already")]
    Whole(String),
    /// The shards are not all of one run.
    #[error("the results are not of one run: {0} differs")]
    Differ(&'static str),
    /// A shard is there twice.
    #[error("the shard {0} is there twice")]
    Twice(String),
    /// Shards are missing.
    #[error("these shards are missing: {0}")]
    Missing(String),
    /// The cases are not those of this program.
    #[error("the result is of other vectors than those at hand: {result}, and here {here}")]
    Corpus {
        /// The digest that the result names.
        result: String,
        /// That of the suite at hand.
        here: String,
    },
    /// A case is not one of the suite, or not of this peer's roles and level.
    #[error("{peer}: the suite has no case {case}")]
    Case {
        /// The peer.
        peer: String,
        /// The case.
        case: String,
    },
    /// A case is missing, or is there without having been meant.
    #[error("{peer}: the cases are not those that were to be asked: {case}")]
    Asked {
        /// The peer.
        peer: String,
        /// The case.
        case: String,
    },
    /// A case stands twice.
    #[error("{peer}: the case {case} is there twice")]
    CaseTwice {
        /// The peer.
        peer: String,
        /// The case.
        case: String,
    },
    /// A checked peer lacks what it is judged by.
    #[error("{0}: the result does not say what it was judged by")]
    Unsaid(String),
    /// The expected failures do not fit the suite.
    #[error("{peer}: {source}")]
    Baseline {
        /// The peer.
        peer: String,
        /// What is wrong.
        source: BaselineError,
    },
}

/// Merges the results of all shards of one run.
///
/// # Errors
/// [`MergeError`] if they are not that.
pub fn merge(mut shards: Vec<Report>, suite: &Suite) -> Result<Report, MergeError> {
    shards.sort_by_key(|report| report.asked.shard.map(|shard| shard.index));
    let first = shards.first().ok_or(MergeError::Nothing)?;
    is_of(first, suite)?;
    all_there(&shards)?;
    let asked = whole(&first.asked);
    for report in &shards {
        let differs = [
            ("the version of ncp-verify", report.tool.version != first.tool.version),
            ("the corpus", report.corpus.sha256 != first.corpus.sha256),
            ("what was asked for", whole(&report.asked) != asked),
            ("the peers", report.peers.len() != first.peers.len()),
        ];
        if let Some((what, _)) = differs.iter().find(|(_, differs)| *differs) {
            return Err(MergeError::Differ(what));
        }
    }
    let started = shards.iter().map(|report| report.started.clone()).min().unwrap_or_default();
    let mut merged = Report { started, ..Report::new(suite, asked, std::time::SystemTime::UNIX_EPOCH) };
    for place in 0..first.peers.len() {
        let parts: Vec<&PeerReport> = shards.iter().filter_map(|report| report.peers.get(place)).collect();
        merged.peers.push(merge_peer(&parts, &merged, suite)?);
    }
    let elapsed = shards.iter().map(|report| report.elapsed_s).sum();
    merged.close(seconds(elapsed), shards.iter().any(|report| report.interrupted));
    Ok(merged)
}

/// Judges a result anew, from what became of its cases.
///
/// # Errors
/// [`MergeError`] if its cases are not those of the suite.
pub fn judged_anew(report: &Report, suite: &Suite) -> Result<Report, MergeError> {
    is_of(report, suite)?;
    let mut anew = Report::new(suite, asked_anew(report, suite), std::time::SystemTime::UNIX_EPOCH);
    anew.tool = report.tool.clone();
    anew.started.clone_from(&report.started);
    for peer in &report.peers {
        anew.peers.push(merge_peer(&[peer], &anew, suite)?);
    }
    anew.close(seconds(report.elapsed_s), report.interrupted);
    // Seconds are not made of nanoseconds alone.
    anew.elapsed_s = report.elapsed_s;
    Ok(anew)
}

/// What was asked for, with all that follows from the rest of it.
fn asked_anew(report: &Report, suite: &Suite) -> Asked {
    let asked = &report.asked;
    let levels = || report.peers.iter().map(|peer| peer.level);
    // The level of a peer that was not checked is not known.
    let level = if levels().all(|level| level.is_some()) { levels().flatten().max() } else { None };
    let level = level.unwrap_or(asked.level);
    let selection = Selection { patterns: patterns(asked), roles: asked.roles.clone(), level: Some(level) };
    let selected = || suite.cases().iter().filter(|case| selection.meets(case));
    let files: HashSet<&str> = selected().map(|case| &*case.file).collect();
    Asked {
        level,
        files: files.len(),
        cases: selected().count(),
        partial: asked.shard.is_some() || asked.rerun || !asked.filters.is_empty(),
        ..asked.clone()
    }
}

fn patterns(asked: &Asked) -> Vec<Pattern> {
    asked.filters.iter().map(|pattern| Pattern::new(pattern)).collect()
}

fn seconds(seconds: f64) -> Duration {
    Duration::try_from_secs_f64(seconds).unwrap_or_default()
}

/// Makes sure that a result draws on the cases of the suite.
fn is_of(report: &Report, suite: &Suite) -> Result<(), MergeError> {
    let (result, here) = (&report.corpus.sha256, suite.digest());
    if result == here { Ok(()) } else { Err(MergeError::Corpus { result: result.clone(), here: here.to_owned() }) }
}

/// Makes sure that each shard is there once.
fn all_there(sorted: &[Report]) -> Result<(), MergeError> {
    let mut indices = Vec::new();
    let mut of = 0;
    for report in sorted {
        let shard = report.asked.shard.ok_or_else(|| MergeError::Whole(report.started.clone()))?;
        if of != 0 && shard.of != of {
            return Err(MergeError::Differ("the number of shards"));
        }
        of = shard.of;
        if indices.last() == Some(&shard.index) {
            return Err(MergeError::Twice(shard.to_string()));
        }
        indices.push(shard.index);
    }
    let missing: Vec<String> = (1..=of).filter(|index| !indices.contains(index)).map(|i| format!("{i}/{of}")).collect();
    if missing.is_empty() { Ok(()) } else { Err(MergeError::Missing(missing.join(", "))) }
}

/// What was asked for, if it was not asked in shards.
fn whole(asked: &Asked) -> Asked {
    Asked { shard: None, partial: asked.rerun || !asked.filters.is_empty(), ..asked.clone() }
}

/// One peer, from what each shard says of it.
fn merge_peer(parts: &[&PeerReport], of: &Report, suite: &Suite) -> Result<PeerReport, MergeError> {
    let first = *parts.first().ok_or(MergeError::Nothing)?;
    if parts.iter().any(|part| part.source != first.source || part.name != first.name) {
        return Err(MergeError::Differ("the peers"));
    }
    for state in [State::NotStarted, State::Skipped] {
        if let Some(part) = parts.iter().find(|part| part.state == state) {
            let reason = part.reason.clone().unwrap_or_default();
            return Ok(PeerReport::unchecked(part.name.clone(), part.source.clone(), state, reason));
        }
    }
    let unsaid = || MergeError::Unsaid(first.name.clone());
    let description = first.description.as_ref().ok_or_else(unsaid)?;
    let level = first.level.ok_or_else(unsaid)?;
    let says = |part: &PeerReport| part.expected_failures.iter().map(|excuse| excuse.says.clone()).collect();
    let entries: Vec<ExpectedFailure> = says(first);
    let (day, _) = of.started.split_at_checked(10).unwrap_or((&of.started, ""));
    let baseline = Baseline::new(entries.clone(), suite, day)
        .map_err(|source| MergeError::Baseline { peer: first.name.clone(), source })?;
    for part in parts {
        let differs = [
            ("how a peer describes itself", part.description.as_ref() != Some(description)),
            ("the level of a peer", part.level != Some(level)),
            ("the list of expected failures", says(part) != entries),
        ];
        if let Some((what, _)) = differs.iter().find(|(_, differs)| *differs) {
            return Err(MergeError::Differ(what));
        }
    }
    let cases = cases(parts, suite)?;
    let asked = &of.asked;
    let about = Description::from(description);
    let (mut meant, kept_back) = selected(suite, &roles(&asked.roles, &about), level, &patterns(asked), &about);
    if let Some(shard) = asked.shard {
        meant = shard.pick(&meant);
    }
    all_asked(&first.name, &cases, &meant, asked.rerun)?;
    let not_asked = match asked.shard {
        _ if asked.rerun => Vec::new(),
        // What no shard asks is told by the first.
        Some(shard) if shard.index != 1 => Vec::new(),
        _ => not_asked(&kept_back),
    };
    let checked = Checked {
        name: first.name.clone(),
        source: first.source.clone(),
        description: about,
        level,
        asked: &asked.roles,
        entries: &entries,
        baseline: &baseline,
        extent: match asked.shard {
            Some(_) => Extent::Shard,
            None if asked.partial => Extent::Picked,
            None => Extent::Whole,
        },
        run: run(parts, &cases),
        cases,
        opened: parts.iter().filter_map(|part| opened(part)).reduce(|one, other| one || other),
        not_asked,
    };
    Ok(checked.conclude(suite))
}

/// Makes sure that no case was left out, and none put in.
fn all_asked(peer: &str, cases: &[(&Case, CaseRun)], meant: &[&Case], rerun: bool) -> Result<(), MergeError> {
    let found: HashSet<&str> = cases.iter().map(|(case, _)| case.id.as_str()).collect();
    let due: HashSet<&str> = meant.iter().map(|case| case.id.as_str()).collect();
    let mut wrong: Vec<&str> = found.difference(&due).copied().collect();
    // Which cases failed before, only the earlier result knows.
    wrong.extend(due.difference(&found).filter(|_| !rerun));
    match wrong.iter().min() {
        None => Ok(()),
        Some(case) => Err(MergeError::Asked { peer: peer.to_owned(), case: (*case).to_owned() }),
    }
}

/// What became of each case, in the order of the suite.
fn cases<'s>(parts: &[&PeerReport], suite: &'s Suite) -> Result<Vec<(&'s Case, CaseRun)>, MergeError> {
    let mut runs: HashMap<&str, CaseRun> = HashMap::new();
    for part in parts {
        let mut described = false;
        for case in &part.cases {
            let twice = || MergeError::CaseTwice { peer: part.name.clone(), case: case.id.clone() };
            if case.id == DESCRIBE {
                if std::mem::replace(&mut described, true) {
                    return Err(twice());
                }
            } else if runs.insert(&case.id, case.run()).is_some() {
                return Err(twice());
            }
        }
    }
    let ordered = suite.cases().iter().filter_map(|case| Some((case, runs.remove(case.id.as_str())?)));
    let ordered: Vec<_> = ordered.collect();
    match (runs.keys().min(), parts.first()) {
        (Some(stranger), Some(part)) => Err(MergeError::Case { peer: part.name.clone(), case: (*stranger).to_owned() }),
        _ => Ok(ordered),
    }
}

/// How the runs went, all in all.
fn run(parts: &[&PeerReport], cases: &[(&Case, CaseRun)]) -> RunReport {
    let runs = || parts.iter().filter_map(|part| part.run.as_ref());
    let mut notes: Vec<String> = Vec::new();
    for note in parts.iter().flat_map(|part| own_notes(part)) {
        if !notes.contains(&note) {
            notes.push(note);
        }
    }
    let first_crash = cases.iter().find(|(_, run)| run.outcome.kind() == OutcomeKind::Crash && run.note.is_none());
    let is_of_it = |log: &&CrashLogReport| first_crash.is_some_and(|(case, _)| case.id == log.case);
    // One rate is kept to the letter.
    let rates: Option<Vec<&RateReport>> = runs().map(|run| run.rate.as_ref()).collect();
    let rate = match rates.as_deref() {
        None | Some([]) => None,
        Some([one]) => Some((*one).clone()),
        Some(rates) => {
            let answers = rates.iter().map(|rate| rate.answers).sum();
            Some(RateReport::new(answers, rates.iter().map(|rate| rate.elapsed_s).sum()))
        }
    };
    RunReport {
        answers: runs().map(|run| run.answers).sum(),
        elapsed_s: runs().map(|run| run.elapsed_s).sum(),
        rate,
        faults: runs().map(|run| run.faults).sum(),
        crash_log: runs().filter_map(|run| run.crash_log.as_ref()).find(is_of_it).cloned(),
        given_up: runs().find_map(|run| run.given_up.clone()),
        notes,
    }
}
