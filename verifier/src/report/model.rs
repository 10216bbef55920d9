//! The one model of a result. Its JSON form is that of `schemas/result.schema.json`.

use std::collections::{BTreeSet, HashMap};
use std::time::{Duration, SystemTime, UNIX_EPOCH};

use ncp_text::catalogue::{Keyword, Level, Role};
use ncp_text::{CONTRACT_HASH, WIRE_VERSION};
use serde::{Serialize, Serializer};

use crate::check::{Differences, in_words};
use crate::diagnosis::{self, Suspect};
use crate::dictionary::{CaseKey, Dictionary, Explained, Explanation, Observed};
use crate::peer::{Call, Description, excerpt};
use crate::run::{CrashLog, Outcome, OutcomeKind, RunRecord};
use crate::severity::Severity;
use crate::suite::{Case, Suite};
use crate::verdict::{Conclusion, Excuse, Judged, LevelVerdict, RoleVerdict, Status, Tally, Verdict, is_unsupported};

/// The format of the result file.
const FORMAT: u32 = 1;
/// How much of a request is kept for a case that did not pass.
const KEPT_BYTES: usize = 16_000;

/// How the program ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Exit {
    /// Every peer that was checked conforms, or does exactly what its list of expected failures says.
    Conformant,
    /// A peer does not conform.
    NotConformant,
    /// The command line asks for nothing that can be done.
    Usage,
    /// A peer could not be started.
    NotStarted,
    /// The suite itself is at fault.
    Harness,
    /// Ctrl-C.
    Interrupted,
}

impl Exit {
    /// The exit code.
    #[must_use]
    pub fn code(self) -> u8 {
        match self {
            Self::Conformant => 0,
            Self::NotConformant => 1,
            Self::Usage => 2,
            Self::NotStarted => 3,
            Self::Harness => 4,
            Self::Interrupted => 130,
        }
    }
}

/// What a run of the program found.
#[derive(Debug, Serialize)]
pub struct Report {
    /// The format of this model.
    pub format: u32,
    /// What made it.
    pub tool: Tool,
    /// When it began, RFC 3339 in UTC.
    pub started: String,
    /// How long it took, in seconds.
    pub elapsed_s: f64,
    /// The wire version of the text.
    pub wire_version: &'static str,
    /// The contract hash of the text.
    pub contract_hash: &'static str,
    /// The cases.
    pub corpus: Corpus,
    /// What was asked for.
    pub asked: Asked,
    /// Whether it was interrupted.
    pub interrupted: bool,
    /// The rules that the cases cite.
    pub rules: Vec<Rule>,
    /// The peers.
    pub peers: Vec<PeerReport>,
    /// The exit code of the program.
    pub exit_code: u8,
}

/// What made a report.
#[derive(Debug, Serialize)]
pub struct Tool {
    /// The program.
    pub name: &'static str,
    /// Its version.
    pub version: &'static str,
}

/// The cases that a run could draw on.
#[derive(Debug, Serialize)]
pub struct Corpus {
    /// How many files.
    pub files: usize,
    /// How many cases.
    pub cases: usize,
    /// The SHA-256 of `vectors/MANIFEST.sha256`.
    pub sha256: String,
}

/// What was asked for.
#[derive(Debug, Clone, Serialize)]
pub struct Asked {
    /// The highest level that was judged.
    #[serde(serialize_with = "by_name")]
    pub level: Level,
    /// The roles that were asked for; empty: those that each peer claims.
    #[serde(serialize_with = "by_names")]
    pub roles: Vec<Role>,
    /// The filters; empty: all cases.
    pub filters: Vec<String>,
    /// Of how many files cases are meant.
    pub files: usize,
    /// How many cases are meant, by level, roles and filters.
    pub cases: usize,
    /// How often each case was run.
    pub repeat: u32,
    /// Whether the filters left cases out, so that a pass is no conformance.
    pub partial: bool,
}

/// A rule that a case cites.
#[derive(Debug, Serialize)]
pub struct Rule {
    /// Its id.
    pub id: String,
    /// Identifies its sentence.
    pub digest: String,
    /// Its keyword.
    #[serde(serialize_with = "by_name")]
    pub keyword: Keyword,
    /// Its level.
    #[serde(serialize_with = "by_name")]
    pub level: Level,
    /// The roles that it binds.
    #[serde(serialize_with = "by_names")]
    pub roles: Vec<Role>,
    /// Its sentence.
    pub sentence: String,
    /// File and line.
    pub place: String,
    /// What it costs to break it.
    pub severity: Severity,
    /// How many cases of the corpus are about it, of all roles.
    pub cases: usize,
}

/// Whether a peer was checked.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum State {
    /// It was.
    Checked,
    /// It was not, since a tool that it needs is not here.
    Skipped,
    /// It could not be started.
    NotStarted,
}

/// What was found about one peer.
#[derive(Debug, Serialize)]
pub struct PeerReport {
    /// Its name, as its `peer.toml` or it itself says.
    pub name: String,
    /// Where it comes from: its folder, or the command.
    pub source: String,
    /// Whether it was checked.
    pub state: State,
    /// Why not, if not.
    pub reason: Option<String>,
    /// What it says about itself.
    pub description: Option<DescriptionReport>,
    /// The verdict, if it was checked.
    #[serde(serialize_with = "by_name_or_null")]
    pub conclusion: Option<Conclusion>,
    /// The roles that were judged.
    pub roles: Vec<RoleReport>,
    /// All cases, whatever their role.
    pub totals: TallyReport,
    /// Cases of its roles and level that it was not asked, since it does not claim what they need.
    pub not_asked: Vec<NotAsked>,
    /// What became of its expected failures.
    pub expected_failures: Vec<ExcuseReport>,
    /// How the run went.
    pub run: Option<RunReport>,
    /// Every case.
    pub cases: Vec<CaseReport>,
    /// The known defects that explain its failing cases; none: nobody was asked.
    pub diagnosis: Option<DiagnosisReport>,
    /// The rules of its cases that fail but the unsupported ones, those that it most likely breaks first.
    #[serde(skip)]
    pub broken: Vec<Suspect>,
    /// The rules of the cases that differ from advice, but the unsupported ones.
    #[serde(skip)]
    pub advised: Vec<Suspect>,
}

/// The fewest known defects that explain the failing cases of a peer.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize)]
pub struct DiagnosisReport {
    /// The defects, most severe first.
    pub defects: Vec<DefectReport>,
    /// The failing cases that no known defect explains.
    pub unexplained: Vec<String>,
}

/// One known defect, and what it explains.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct DefectReport {
    /// The id of the defect.
    pub defect: String,
    /// What it is, in words; of defects that no case tells apart, in the words of each.
    pub words: String,
    /// What it costs.
    pub severity: Severity,
    /// The failing cases that it explains, never none.
    pub explained: Vec<String>,
    /// How many cases such a defect would also fail, but pass: the more, the less sure.
    pub passing: usize,
    /// The explained case with the shortest request.
    pub shortest: String,
}

/// What became of an entry of a peer's expected failures.
#[derive(Debug, Serialize)]
pub struct ExcuseReport {
    /// What it is called.
    pub entry: String,
    /// Why its cases fail.
    pub reason: String,
    /// How many cases it excuses.
    pub cases: usize,
    /// How many it excused when it was written, if it says so.
    pub written: Option<usize>,
    /// Whether that is fewer.
    pub too_broad: bool,
    /// The day on which it expired, if it has.
    pub expired: Option<String>,
    /// Whether none of its cases fails any more as it says.
    pub stale: bool,
    /// The cases that it names and that no longer fail as it says.
    pub stale_cases: Vec<String>,
}

/// Cases that a peer was not asked.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct NotAsked {
    /// What they need.
    pub needs: &'static str,
    /// How many there are.
    pub cases: usize,
}

/// What a peer says about itself.
#[derive(Debug, Serialize)]
pub struct DescriptionReport {
    /// The implementation's name.
    pub name: String,
    /// Its own version.
    pub version: String,
    /// Its language.
    pub language: String,
    /// The wire version that it states.
    pub wire_version: String,
    /// The contract hash that it states.
    pub contract_hash: String,
    /// The roles that it claims.
    pub roles: Vec<String>,
    /// Whether it claims the reference networks.
    pub reference_networks: bool,
}

/// One role of a peer.
#[derive(Debug, Serialize)]
pub struct RoleReport {
    /// The role.
    #[serde(serialize_with = "by_name")]
    pub role: Role,
    /// Whether the peer claims it.
    pub claimed: bool,
    /// The levels from the lowest that has a case of the role; one above it may have none.
    pub levels: Vec<LevelReport>,
}

/// One level of a role.
#[derive(Debug, Serialize)]
pub struct LevelReport {
    /// The level.
    #[serde(serialize_with = "by_name")]
    pub level: Level,
    /// Whether the role conforms at it.
    pub conformant: bool,
    /// Whether nothing failed that was not expected to.
    pub as_expected: bool,
    /// The cases of exactly this level.
    pub cases: TallyReport,
    /// How many of them are binding: a rule that they cite is a MUST or MUST NOT.
    pub binding: usize,
    /// How many of the binding ones pass.
    pub binding_passed: usize,
}

/// How many cases count for what.
#[derive(Debug, Default, Clone, Copy, Serialize)]
pub struct TallyReport {
    /// All.
    pub total: usize,
    /// Passed.
    pub passed: usize,
    /// Failed.
    pub failed: usize,
    /// Differ from advice.
    pub advice: usize,
    /// Failed as expected.
    pub expected_failures: usize,
    /// Not run.
    pub not_run: usize,
}

/// How a run went.
#[derive(Debug, Serialize)]
pub struct RunReport {
    /// How many answers were judged.
    pub answers: u64,
    /// How long that took, in seconds.
    pub elapsed_s: f64,
    /// How fast the cases with requests of up to 64 KiB were answered, if all were.
    pub rate: Option<RateReport>,
    /// How many processes ended in a fault, each of which was replaced.
    pub faults: u32,
    /// The whole log of one crash, with all backtraces.
    pub crash_log: Option<CrashLogReport>,
    /// Why the peer was given up, if it was.
    pub given_up: Option<String>,
    /// What else was noticed.
    pub notes: Vec<String>,
}

/// The whole log of one crash.
#[derive(Debug, Serialize)]
pub struct CrashLogReport {
    /// The case.
    pub case: String,
    /// What the process wrote to its standard error.
    pub log: String,
}

/// So many answers in so much time.
#[derive(Debug, Serialize)]
pub struct RateReport {
    /// How many answers were judged.
    pub answers: u64,
    /// How long that took, in seconds.
    pub elapsed_s: f64,
    /// How many that makes a second.
    pub per_second: f64,
}

/// What became of one case.
#[derive(Debug, Clone, Serialize)]
pub struct CaseReport {
    /// Its id.
    pub id: String,
    /// What it shows.
    pub title: String,
    /// The rules that it cites.
    pub rules: Vec<String>,
    /// The roles that need it.
    #[serde(serialize_with = "by_names")]
    pub roles: Vec<Role>,
    /// Its level.
    #[serde(serialize_with = "by_name")]
    pub level: Level,
    /// Whether it decides the verdict.
    pub binding: bool,
    /// The call.
    #[serde(serialize_with = "by_name")]
    pub call: Call,
    /// What became of it.
    #[serde(serialize_with = "by_name")]
    pub outcome: OutcomeKind,
    /// What it counts for.
    #[serde(serialize_with = "by_name")]
    pub status: Status,
    /// What it says of the first of its rules: `passed`, `failed`, `inconclusive`, `unsupported` or `not run`.
    pub ruling: &'static str,
    /// The rule that it is charged to; of an inconclusive case the one that it waits for, and of a trace with a step
    /// that the peer cannot do the one of that step.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub charged: Option<String>,
    /// What was expected, in words, unless it passed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub expected: Option<String>,
    /// What differs.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub differences: Vec<DifferenceReport>,
    /// How many more differences there are.
    #[serde(skip_serializing_if = "is_zero")]
    pub more_differences: usize,
    /// What happened, for a case without a proper answer.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub what: Option<String>,
    /// What was sent, shortened, without its id, unless it passed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub request: Option<String>,
    /// What came back, shortened.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub answer: Option<String>,
    /// The end of the peer's log.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub log: Option<String>,
    /// What else is worth knowing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub note: Option<String>,
    /// Why it was expected to fail.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
}

/// One difference.
#[derive(Debug, Clone, Serialize)]
pub struct DifferenceReport {
    /// Where, as a JSON pointer.
    pub at: String,
    /// What was expected there; `null`: nothing.
    pub expected: Option<String>,
    /// What was there; `null`: nothing.
    pub got: Option<String>,
    /// What else there is to say.
    pub hint: Option<String>,
    /// The whole in one line.
    pub text: String,
}

impl Report {
    /// Begins a report.
    #[must_use]
    pub fn new(suite: &Suite, asked: Asked, started: SystemTime) -> Self {
        let corpus = Corpus { files: suite.files(), cases: suite.cases().len(), sha256: suite.digest().to_owned() };
        Self {
            format: FORMAT,
            tool: Tool { name: "ncp-verify", version: env!("CARGO_PKG_VERSION") },
            started: rfc3339(started),
            elapsed_s: 0.0,
            wire_version: WIRE_VERSION,
            contract_hash: CONTRACT_HASH,
            corpus,
            asked,
            interrupted: false,
            rules: rules(suite),
            peers: Vec::new(),
            exit_code: Exit::Conformant.code(),
        }
    }

    /// Ends a report: the exit code follows from the peers.
    pub fn close(&mut self, elapsed: Duration, interrupted: bool) -> Exit {
        let states = |state: State| self.peers.iter().any(|peer| peer.state == state);
        let exit = if interrupted {
            Exit::Interrupted
        } else if states(State::NotStarted) {
            Exit::NotStarted
        } else if self.peers.iter().any(|peer| peer.conclusion == Some(Conclusion::NotConformant))
            || !states(State::Checked)
        {
            // With every peer skipped, nothing was shown to conform.
            Exit::NotConformant
        } else {
            Exit::Conformant
        };
        self.elapsed_s = elapsed.as_secs_f64();
        self.interrupted = interrupted;
        self.exit_code = exit.code();
        exit
    }

    /// The JSON result file.
    ///
    /// # Errors
    /// Only if a number in it cannot be written, which does not occur.
    pub fn to_json(&self) -> Result<String, serde_json::Error> {
        let mut text = serde_json::to_string_pretty(self)?;
        text.push('\n');
        Ok(text)
    }
}

impl PeerReport {
    /// A peer that was not checked.
    #[must_use]
    pub fn unchecked(name: String, source: String, state: State, reason: String) -> Self {
        Self {
            name,
            source,
            state,
            reason: Some(reason),
            description: None,
            conclusion: None,
            roles: Vec::new(),
            totals: TallyReport::default(),
            not_asked: Vec::new(),
            expected_failures: Vec::new(),
            run: None,
            cases: Vec::new(),
            diagnosis: None,
            broken: Vec::new(),
            advised: Vec::new(),
        }
    }

    /// A peer that was checked.
    #[must_use]
    pub fn checked(
        name: String,
        source: String,
        description: &Description,
        verdict: &Verdict<'_>,
        run: &RunRecord,
        not_asked: Vec<NotAsked>,
    ) -> Self {
        let mut totals = TallyReport::default();
        for judged in &verdict.cases {
            totals.count(judged.status);
        }
        let of = |status| {
            move |judged: &Judged<'_>| judged.status == status && !is_unsupported(judged.run.outcome.kind(), status)
        };
        Self {
            name,
            source,
            state: State::Checked,
            reason: None,
            description: Some(DescriptionReport {
                name: description.name.clone(),
                version: description.version.clone(),
                language: description.language.clone(),
                wire_version: description.wire_version.clone(),
                contract_hash: description.contract_hash.clone(),
                roles: description.roles.clone(),
                reference_networks: description.reference_networks,
            }),
            conclusion: Some(verdict.conclusion),
            roles: verdict.roles.iter().map(|role| RoleReport::new(role, &verdict.cases)).collect(),
            totals,
            not_asked,
            expected_failures: verdict.excuses.iter().map(ExcuseReport::new).collect(),
            run: Some(RunReport {
                answers: run.answers,
                elapsed_s: run.elapsed.as_secs_f64(),
                rate: run.rate.map(|rate| {
                    let elapsed_s = rate.elapsed.as_secs_f64().max(1e-9);
                    RateReport { answers: rate.answers, elapsed_s, per_second: rate.answers as f64 / elapsed_s }
                }),
                faults: run.faults,
                crash_log: run.crash_log.clone().map(|CrashLog { case, log }| CrashLogReport { case, log }),
                given_up: run.given_up.clone(),
                notes: run.notes.clone(),
            }),
            cases: verdict.cases.iter().map(CaseReport::new).collect(),
            diagnosis: None,
            broken: diagnosis::likeliest_first(&verdict.cases, of(Status::Failed)),
            advised: diagnosis::by_rule(&verdict.cases, of(Status::Advice)),
        }
    }
}

impl PeerReport {
    /// Explains the failing cases by the fewest known defects; none if the dictionary knows none of the cases.
    pub fn diagnose(&mut self, dictionary: &Dictionary, verdict: &Verdict<'_>) {
        let observed = Observed::of(verdict.cases.iter().map(|judged| (judged.case, &judged.run.outcome)));
        if !dictionary.knows(&observed) {
            return;
        }
        let fails = |judged: &&Judged<'_>| {
            let Judged { run, status, .. } = judged;
            matches!(status, Status::Failed | Status::ExpectedFailure)
                && !matches!(run.outcome, Outcome::Unsupported { .. })
        };
        let failing: HashMap<CaseKey, &Case> =
            verdict.cases.iter().filter(fails).map(|judged| (CaseKey::of(&judged.case.id), judged.case)).collect();
        let cases = |keys: &[CaseKey]| keys.iter().filter_map(|key| failing.get(key).copied()).collect::<Vec<_>>();
        let ids = |cases: &[&Case]| cases.iter().map(|case| case.id.clone()).collect::<Vec<_>>();
        let Explanation { defects, unexplained } = dictionary.explain(&observed);
        let report = |found: &Explained| {
            let explained = cases(&found.cases);
            let shortest = explained.iter().min_by_key(|case| (case.request_bytes(), &case.id))?;
            let entries: Vec<_> = found.entries.iter().filter_map(|entry| dictionary.entries.get(*entry)).collect();
            let first = entries.first()?;
            Some(DefectReport {
                defect: first.name.clone(),
                words: entries.iter().map(|entry| entry.words.as_str()).collect::<Vec<_>>().join(" Or: "),
                severity: Severity::of(first.rules.first()?),
                explained: ids(&explained),
                passing: found.missed,
                shortest: shortest.id.clone(),
            })
        };
        let mut defects: Vec<DefectReport> = defects.iter().filter_map(report).collect();
        defects.sort_by_key(|found| (found.severity, std::cmp::Reverse(found.explained.len())));
        self.diagnosis = Some(DiagnosisReport { defects, unexplained: ids(&cases(&unexplained)) });
    }
}

impl ExcuseReport {
    fn new(excuse: &Excuse) -> Self {
        let too_broad = excuse.is_too_broad();
        let Excuse { entry, reason, cases, written, expired, stale_cases, stale } = excuse.clone();
        Self { entry, reason, cases, written, too_broad, expired, stale, stale_cases }
    }

    /// What is untrue about it, in words; each fails the run.
    #[must_use]
    pub fn untrue(&self) -> Vec<String> {
        let Self { entry, .. } = self;
        let mut said = Vec::new();
        match &self.stale_cases[..] {
            _ if self.stale => said.push(format!("the expected failure of {entry} no longer fails: take it out")),
            [] => {}
            [one] => said.push(format!("the expected failure of {entry}: {one} no longer fails so: take it out")),
            [first, more @ ..] => said.push(format!(
                "the expected failure of {entry}: {first} and {} more no longer fail so: take them out",
                more.len()
            )),
        }
        said.extend(self.expired.as_ref().map(|day| format!("the expected failure of {entry} expired on {day}")));
        said
    }
}

impl RoleReport {
    fn new(verdict: &RoleVerdict, cases: &[Judged<'_>]) -> Self {
        let level = |level: &LevelVerdict| {
            let is_meant = |judged: &&Judged<'_>| {
                let Judged { case, .. } = judged;
                case.binding && case.level == level.level && case.roles.contains(&verdict.role)
            };
            let binding = || cases.iter().filter(is_meant);
            LevelReport {
                level: level.level,
                conformant: level.conformant,
                as_expected: level.as_expected,
                cases: level.tally.into(),
                binding: binding().count(),
                binding_passed: binding().filter(|judged| judged.run.outcome == Outcome::Pass).count(),
            }
        };
        Self { role: verdict.role, claimed: verdict.claimed, levels: verdict.levels.iter().map(level).collect() }
    }
}

impl TallyReport {
    fn count(&mut self, status: Status) {
        self.total += 1;
        *match status {
            Status::Passed | Status::UnexpectedPass => &mut self.passed,
            Status::Failed => &mut self.failed,
            Status::Advice => &mut self.advice,
            Status::ExpectedFailure => &mut self.expected_failures,
            Status::NotRun => &mut self.not_run,
        } += 1;
    }
}

impl From<Tally> for TallyReport {
    fn from(tally: Tally) -> Self {
        Self {
            total: tally.total(),
            passed: tally.passed,
            failed: tally.failed,
            advice: tally.advice,
            expected_failures: tally.expected_failures,
            not_run: tally.not_run,
        }
    }
}

impl CaseReport {
    /// Whether it is charged to another rule than the one that it is about.
    pub(super) fn waits(&self) -> bool {
        self.outcome != OutcomeKind::Unsupported
            && matches!((&self.charged, self.rules.first()), (Some(charged), Some(own)) if charged != own)
    }

    fn new(judged: &Judged<'_>) -> Self {
        let Judged { case, run, status, ruling, reason } = judged;
        let passed = run.outcome == Outcome::Pass;
        let (what, log) = match &run.outcome {
            Outcome::Crash { what, log } | Outcome::Timeout { what, log } | Outcome::Protocol { what, log } => {
                (Some(what.clone()), (!log.is_empty()).then(|| log.clone()))
            }
            Outcome::NotRun { why } => (Some(why.clone()), None),
            Outcome::Pass | Outcome::Fail(_) | Outcome::Unsupported { .. } => (None, None),
        };
        let differences = match &run.outcome {
            Outcome::Fail(differences) => differences.clone(),
            _ => Differences::default(),
        };
        Self {
            id: case.id.clone(),
            title: case.title.clone(),
            rules: case.requirements.iter().map(|rule| rule.id.clone()).collect(),
            roles: case.roles.clone(),
            level: case.level,
            binding: case.binding,
            call: case.call,
            outcome: run.outcome.kind(),
            status: *status,
            ruling: ruling.as_str(),
            charged: ruling.decided_by().map(|rule| rule.id.clone()),
            expected: (!passed).then(|| in_words(&case.expect)),
            more_differences: differences.more,
            differences: differences
                .first
                .into_iter()
                .map(|difference| DifferenceReport {
                    text: difference.to_string(),
                    at: difference.at,
                    expected: difference.expected,
                    got: difference.got,
                    hint: difference.hint,
                })
                .collect(),
            what,
            request: (!passed).then(|| excerpt(format!("{{{}", case.body()).as_bytes(), KEPT_BYTES)),
            answer: run.answer.clone(),
            log,
            note: run.note.clone(),
            reason: reason.clone(),
        }
    }
}

fn rules(suite: &Suite) -> Vec<Rule> {
    let cited: BTreeSet<&str> =
        suite.with_describe().flat_map(|case: &Case| case.requirements.iter().map(|rule| rule.id.as_str())).collect();
    let mut about: HashMap<&str, usize> = HashMap::new();
    for rule in suite.with_describe().filter_map(|case| case.requirements.first()) {
        *about.entry(&rule.id).or_default() += 1;
    }
    suite
        .requirements()
        .iter()
        .filter(|rule| cited.contains(rule.id.as_str()))
        .map(|rule| Rule {
            id: rule.id.clone(),
            digest: rule.digest.clone(),
            keyword: rule.keyword,
            level: rule.level,
            roles: rule.roles.clone(),
            sentence: rule.sentence.clone(),
            place: rule.place(),
            severity: Severity::of(&rule.id),
            cases: about.get(rule.id.as_str()).copied().unwrap_or_default(),
        })
        .collect()
}

/// The day on which it is now in UTC, such as `2026-12-31`.
#[must_use]
pub fn today() -> String {
    rfc3339(SystemTime::now()).chars().take(10).collect()
}

/// A time as RFC 3339 writes it, in UTC, to the second.
fn rfc3339(time: SystemTime) -> String {
    let seconds = time.duration_since(UNIX_EPOCH).unwrap_or_default().as_secs();
    let (days, second) = (seconds / 86_400, seconds % 86_400);
    // Days to a civil date, counting years from March, so that the leap day is the last of its year.
    let shifted = days + 719_468;
    let (era, day_of_era) = (shifted / 146_097, shifted % 146_097);
    let year_of_era = (day_of_era - day_of_era / 1_460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let from_march = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * from_march + 2) / 5 + 1;
    let month = if from_march < 10 { from_march + 3 } else { from_march - 9 };
    let year = year_of_era + era * 400 + u64::from(month <= 2);
    format!("{year:04}-{month:02}-{day:02}T{:02}:{:02}:{:02}Z", second / 3600, second / 60 % 60, second % 60)
}

/// What is written by its name.
trait Named {
    fn name(&self) -> &'static str;
}

macro_rules! named {
    ($($type:ty),+) => {$(
        impl Named for $type {
            fn name(&self) -> &'static str {
                self.as_str()
            }
        }
    )+};
}

named!(Call, Conclusion, Keyword, Level, OutcomeKind, Role, Status);

fn by_name<S: Serializer>(value: &impl Named, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(value.name())
}

fn by_names<S: Serializer>(values: &[impl Named], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(values.iter().map(Named::name))
}

#[expect(clippy::ref_option, reason = "serde passes a reference")]
fn by_name_or_null<S: Serializer>(value: &Option<impl Named>, serializer: S) -> Result<S::Ok, S::Error> {
    value.as_ref().map(Named::name).serialize(serializer)
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes a reference")]
fn is_zero(count: &usize) -> bool {
    *count == 0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_time_is_written_by_rfc_3339() {
        for (seconds, text) in [
            (0, "1970-01-01T00:00:00Z"),
            (951_782_399, "2000-02-28T23:59:59Z"),
            (951_782_400, "2000-02-29T00:00:00Z"),
            (1_709_251_199, "2024-02-29T23:59:59Z"),
            (4_107_542_400, "2100-03-01T00:00:00Z"),
        ] {
            assert_eq!(rfc3339(UNIX_EPOCH + Duration::from_secs(seconds)), text);
        }
    }
}
