//! The trial of one mutant.

use std::fmt;
use std::sync::mpsc;
use std::thread;
use std::time::{Duration, Instant};

use ncp_text::catalogue::{Level, Role};
use serde::{Deserialize, Serialize};

use super::{Asks, Hunt, Mutant, MutantsError};
use ncp_verifier::diagnosis;
use ncp_verifier::dictionary::Observed;
use ncp_verifier::peer::{Connection, Description, Launch, handshake};
use ncp_verifier::report::{CaseReport, PeerReport};
use ncp_verifier::run::{self, CaseRun, Deaf, Settings};
use ncp_verifier::stop::Stop;
use ncp_verifier::suite::{Case, DEEP};
use ncp_verifier::verdict::{Baseline, Status, judge, judge_description};

/// What became of a mutant.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Fate {
    /// The suite fails it and names its rule, or begins with one that it breaks as directly. A mutant that only breaks
    /// a SHOULD is told so.
    Killed,
    /// The suite fails it, but for other rules.
    Misnamed,
    /// The suite does not notice it.
    Survived,
    /// Its trial took too long.
    Unfinished,
}

impl fmt::Display for Fate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Killed => "killed",
            Self::Misnamed => "misnamed",
            Self::Survived => "survived",
            Self::Unfinished => "unfinished",
        })
    }
}

/// The trial of a mutant.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(crate) struct Trial {
    /// The mutant.
    #[serde(flatten)]
    pub(crate) mutant: Mutant,
    /// What became of it.
    pub(crate) fate: Fate,
    /// The place of its rule among those that the verdict names, from 1; of several rules, the last one's.
    pub(crate) place: Option<usize>,
    /// What became of it by the corpus alone, where the deep set was asked, too.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) by_corpus: Option<Fate>,
    /// How many cases fail.
    pub(crate) failing_cases: usize,
    /// How many of them end the process, or make it hang.
    pub(crate) crashes: usize,
    /// The rules that the verdict names, in its order.
    pub(crate) named: Vec<Named>,
    /// The case with the shortest request that fails: of those of its rule, if there are any.
    pub(crate) shortest_case: Option<String>,
    /// How long it took, in seconds.
    pub(crate) elapsed_s: f64,
}

impl Trial {
    /// The rules that the verdict names although the defect keeps their sentences.
    pub(crate) fn blamed(&self) -> Vec<&str> {
        let named = self.named.iter().map(|named| named.rule.as_str());
        named.filter(|rule| !self.mutant.breaks(rule)).collect()
    }
}

/// A rule that the verdict names.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Named {
    /// The rule.
    pub(crate) rule: String,
    /// How many failing cases are about it.
    pub(crate) cases: usize,
}

/// Makes sure that the peer conforms as long as it has no defect.
pub(super) fn healthy(hunt: &Hunt<'_>) -> Result<(), MutantsError> {
    let all: Vec<&Case> = hunt.suite.cases().iter().collect();
    let Findings { failing, .. } = failing(hunt, None, &[&all], |_| true, hunt.stop)?;
    match failing.first() {
        None if hunt.stop.is_set() => Err(MutantsError::Interrupted),
        None => Ok(()),
        Some(first) => Err(MutantsError::Sick { count: failing.len(), first: first.id.clone() }),
    }
}

/// Puts a mutant on trial.
pub(super) fn try_mutant(hunt: &Hunt<'_>, mutant: &Mutant) -> Result<Trial, MutantsError> {
    let start = Instant::now();
    let cites = |case: &&Case| case.requirements.iter().any(|cited| mutant.rules.contains(&cited.id));
    let asked = hunt.suite.cases().iter().filter(|case| hunt.asks == Asks::All || cites(case));
    let (large, small): (Vec<&Case>, Vec<&Case>) = asked.partition(|case| case.is_large());
    let of_corpus = |case: &&&CaseReport| !case.id.starts_with(DEEP);
    let names = |cases: &[&CaseReport]| mutant.owed().iter().all(|rule| cases.iter().any(|case| is_about(case, rule)));
    // What the corpus alone names is to be known, whatever the deep set names.
    let more = |cases: &[CaseReport]| {
        let all: Vec<&CaseReport> = cases.iter().collect();
        !names(&all.iter().filter(of_corpus).copied().collect::<Vec<_>>())
    };
    let (failing, in_time) = limited(hunt, |stop| failing(hunt, Some(mutant), &[&small, &large], more, stop));
    let Findings { failing, named } = failing?;
    let fate_by = |failing: &[&CaseReport]| match (in_time, failing.is_empty(), names(failing)) {
        (_, false, true) => Fate::Killed,
        (false, ..) => Fate::Unfinished,
        (true, false, false) => Fate::Misnamed,
        (true, true, _) => Fate::Survived,
    };
    let all: Vec<&CaseReport> = failing.iter().collect();
    // A rule that the defect breaks as directly stands for the one that is owed, but never for those of two defects.
    let stands_for_it = |named: &Named| mutant.owed().len() == 1 && mutant.is_led_by(&named.rule);
    let fate = match fate_by(&all) {
        Fate::Misnamed if named.first().is_some_and(stands_for_it) => Fate::Killed,
        fate => fate,
    };
    let has_deep = hunt.suite.cases().iter().any(Case::is_deep);
    let by_corpus = has_deep.then(|| fate_by(&all.iter().filter(of_corpus).copied().collect::<Vec<_>>()));
    let shortest =
        failing.iter().min_by_key(|case| (!mutant.owed().iter().any(|rule| is_about(case, rule)), request_len(case)));
    let place = |rule: &String| named.iter().position(|named| named.rule == *rule).map(|before| before + 1);
    let places: Option<Vec<usize>> = mutant.owed().iter().map(place).collect();
    Ok(Trial {
        mutant: mutant.clone(),
        fate,
        by_corpus,
        place: places.and_then(|places| places.into_iter().max()),
        failing_cases: failing.len(),
        crashes: failing.iter().filter(|case| case.outcome.is_fault()).count(),
        named,
        shortest_case: shortest.map(|case| case.id.clone()),
        elapsed_s: start.elapsed().as_secs_f64(),
    })
}

/// How each of these cases ends against the peer with these defects.
pub(crate) fn observe(hunt: &Hunt<'_>, defects: &[String], cases: &[&Case]) -> Result<Observed, MutantsError> {
    let (observed, in_time) = limited(hunt, |stop| -> Result<Observed, MutantsError> {
        let (launch, settings) = (launch(hunt, defects), Settings::default());
        let mut connection = Connection::open(&launch)?;
        let description = handshake(&mut connection, settings.start_timeout, stop)?;
        let describe = (hunt.suite.describe(&description), judge_description(&description));
        let record = run::run(&launch, connection, cases, &settings, &Deaf, stop);
        let runs: Vec<(&Case, CaseRun)> =
            std::iter::once(describe).chain(cases.iter().copied().zip(record.cases)).collect();
        Ok(Observed::of(runs.iter().map(|(case, run)| (*case, &run.outcome))))
    });
    match in_time {
        true => observed,
        false if hunt.stop.is_set() => Err(MutantsError::Interrupted),
        false => Err(MutantsError::Late { mutant: defects.join(" + ") }),
    }
}

/// The program with some defects switched on.
fn launch(hunt: &Hunt<'_>, defects: &[String]) -> Launch {
    let mut argv = vec![hunt.program.to_string_lossy().into_owned()];
    argv.extend(defects.iter().flat_map(|defect| ["--defect".to_owned(), defect.clone()]));
    Launch::new(argv, ".")
}

/// What does not pass, and the rules that the verdict names for it.
#[derive(Debug, Default)]
struct Findings {
    failing: Vec<CaseReport>,
    named: Vec<Named>,
}

/// Whether a failing case names the rule: it cites it, and is charged to it.
fn is_about(case: &CaseReport, rule: &str) -> bool {
    case.charged.as_deref() == Some(rule) && case.rules.iter().any(|cited| cited == rule)
}

fn request_len(case: &CaseReport) -> usize {
    case.request.as_ref().map_or(usize::MAX, String::len)
}

/// Runs parts of the suite one after the other as long as `more` of what fails so far, and gives what does not pass:
/// what fails, or if nothing does what is told as advice.
fn failing(
    hunt: &Hunt<'_>,
    mutant: Option<&Mutant>,
    parts: &[&[&Case]],
    more: impl Fn(&[CaseReport]) -> bool,
    stop: &Stop,
) -> Result<Findings, MutantsError> {
    let launch = launch(hunt, mutant.map_or(&[], |mutant| &mutant.defects));
    let settings = Settings {
        // A mutant that crashes is run to its end too: the time bounds it.
        max_restarts: None,
        ..Settings::default()
    };
    let mut runs = Vec::new();
    let mut findings = Findings::default();
    for part in parts {
        if stop.is_set() || (!runs.is_empty() && !more(&findings.failing)) {
            break;
        }
        let mut connection = Connection::open(&launch)?;
        let description = handshake(&mut connection, settings.start_timeout, stop)?;
        if runs.is_empty() {
            runs.push((hunt.suite.describe(&description), judge_description(&description)));
        }
        let record = run::run(&launch, connection, part, &settings, &Deaf, stop);
        runs.extend(part.iter().copied().zip(record.cases.iter().cloned()));
        findings = not_passed(hunt, &description, &runs, &record);
    }
    Ok(findings)
}

fn not_passed(
    hunt: &Hunt<'_>,
    description: &Description,
    runs: &[(&Case, CaseRun)],
    record: &run::RunRecord,
) -> Findings {
    let roles = Role::ALL.map(|role| (role, true));
    let mut runs = runs.to_vec();
    // In the order in which the suite has them, as the verdict names rules of one weight in the order of the cases.
    let place = |case: &Case| hunt.suite.cases().iter().position(|other| std::ptr::eq(other, case));
    if runs.iter().any(|(case, _)| case.is_large()) {
        runs.sort_by_cached_key(|(case, _)| place(case));
    }
    let verdict = judge(runs, &roles, Level::Strict, &Baseline::default(), false);
    let report = PeerReport::checked(String::new(), String::new(), description, &verdict, record, Vec::new());
    let of =
        |status| -> Vec<CaseReport> { report.cases.iter().filter(|case| case.status == status).cloned().collect() };
    let any_fails = verdict.cases.iter().any(|judged| judged.status == Status::Failed);
    let told = if any_fails { Status::Failed } else { Status::Advice };
    let named = diagnosis::likeliest_first(&verdict.cases, |judged| judged.status == told)
        .into_iter()
        .map(|suspect| Named { rule: suspect.rule, cases: suspect.cases.len() })
        .collect();
    Findings { failing: of(told), named }
}

/// Does the work with a `Stop` of its own, which is set when the hunt's is or the time is over; whether it was in time.
fn limited<T: Send>(hunt: &Hunt<'_>, work: impl FnOnce(&Stop) -> T) -> (T, bool) {
    let stop = Stop::default();
    let (done, ended) = mpsc::channel::<()>();
    thread::scope(|scope| {
        let expired = &stop;
        let watch = scope.spawn(move || {
            let start = Instant::now();
            while ended.recv_timeout(Duration::from_millis(20)) == Err(mpsc::RecvTimeoutError::Timeout) {
                if hunt.stop.is_set() || start.elapsed() > hunt.limit {
                    expired.set();
                    return false;
                }
            }
            true
        });
        let result = work(&stop);
        drop(done);
        (result, watch.join().unwrap_or(false))
    })
}
