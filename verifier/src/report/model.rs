//! The one model of a result. Its JSON form is that of `schemas/result.schema.json`.

use std::collections::{BTreeSet, HashMap};
use std::fs::File;
use std::io::{self, BufReader, BufWriter, Read as _, Seek as _, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, SystemTime, UNIX_EPOCH};

use ncp_text::catalogue::{Keyword, Level, Role};
use ncp_text::{CONTRACT_HASH, WIRE_VERSION};
use serde::{Deserialize, Serialize};

use super::named::{by_name, by_name_or_null, by_names};
use super::shared;
use crate::check::{Difference, Differences, Manner, in_words};
use crate::diagnosis::{self, Suspect};
use crate::dictionary::{CaseKey, Dictionary, Explained, Explanation, Observed, Seen, Symptom};
use crate::peer::{Call, Description, ExpectedFailure, excerpt};
use crate::run::{CaseRun, CrashLog, Outcome, OutcomeKind, RunRecord};
use crate::severity::Severity;
use crate::shard::Shard;
use crate::suite::{Case, Suite};
use crate::verdict::{Conclusion, Excuse, Judged, LevelVerdict, RoleVerdict, Status, Tally, Verdict, is_unsupported};

/// The format of the result file.
const FORMAT: u32 = 1;
/// A result file is read and written in pieces of so many bytes.
const BUFFER: usize = 64 << 10;
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
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
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
    pub wire_version: String,
    /// The contract hash of the text.
    pub contract_hash: String,
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
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Tool {
    /// The program.
    pub name: String,
    /// Its version.
    pub version: String,
}

impl Tool {
    /// This program.
    #[must_use]
    pub fn this() -> Self {
        Self { name: "ncp-verify".to_owned(), version: env!("CARGO_PKG_VERSION").to_owned() }
    }
}

/// The cases that a run could draw on.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Corpus {
    /// How many files.
    pub files: usize,
    /// How many cases.
    pub cases: usize,
    /// The SHA-256 of `vectors/MANIFEST.sha256`.
    pub sha256: String,
}

/// What was asked for.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Asked {
    /// The highest level that was judged.
    #[serde(with = "by_name")]
    pub level: Level,
    /// The roles that were asked for; empty: those that each peer claims.
    #[serde(with = "by_names")]
    pub roles: Vec<Role>,
    /// The filters; empty: all cases.
    pub filters: Vec<String>,
    /// Of how many files cases are meant.
    pub files: usize,
    /// How many cases are meant, by level, roles and filters.
    pub cases: usize,
    /// How often each case was run.
    pub repeat: u32,
    /// Whether cases were left out, by filters or since this is a shard or a rerun, so that a pass is no conformance.
    pub partial: bool,
    /// Which part of the cases that are meant was run; none: all of them.
    pub shard: Option<Shard>,
    /// Whether only those cases are meant that failed in an earlier result.
    pub rerun: bool,
    /// How many of the cases are of the deep set; left out where it is not run.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub deep: usize,
}

/// A rule that a case cites.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rule {
    /// Its id.
    pub id: String,
    /// Identifies its sentence.
    pub digest: String,
    /// Its keyword.
    #[serde(with = "by_name")]
    pub keyword: Keyword,
    /// Its level.
    #[serde(with = "by_name")]
    pub level: Level,
    /// The roles that it binds.
    #[serde(with = "by_names")]
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
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
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
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
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
    /// The level that it is held to, if it was checked.
    #[serde(default, with = "by_name_or_null")]
    pub level: Option<Level>,
    /// The verdict, if it was checked.
    #[serde(default, with = "by_name_or_null")]
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
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DiagnosisReport {
    /// The defects, most severe first.
    pub defects: Vec<DefectReport>,
    /// The failing cases that no known defect explains.
    pub unexplained: Vec<String>,
}

/// One known defect, and what it explains.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
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
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
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
    /// The entry itself, so that the verdict can be computed anew.
    pub says: ExpectedFailure,
}

/// Cases that a peer was not asked.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NotAsked {
    /// What they need.
    pub needs: String,
    /// How many there are.
    pub cases: usize,
}

/// What a peer says about itself.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
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
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RoleReport {
    /// The role.
    #[serde(with = "by_name")]
    pub role: Role,
    /// Whether the peer claims it.
    pub claimed: bool,
    /// The levels from the lowest that has a case of the role; one above it may have none.
    pub levels: Vec<LevelReport>,
}

/// One level of a role.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LevelReport {
    /// The level.
    #[serde(with = "by_name")]
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
#[derive(Debug, Default, Clone, Copy, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
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
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
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
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CrashLogReport {
    /// The case.
    pub case: String,
    /// What the process wrote to its standard error.
    pub log: String,
}

/// So many answers in so much time.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RateReport {
    /// How many answers were judged.
    pub answers: u64,
    /// How long that took, in seconds.
    pub elapsed_s: f64,
    /// How many that makes a second.
    pub per_second: f64,
}

/// What became of one case.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CaseReport {
    /// Its id.
    pub id: String,
    /// What it shows.
    #[serde(with = "shared")]
    pub title: Arc<str>,
    /// The rules that it cites.
    #[serde(with = "shared")]
    pub rules: Arc<[String]>,
    /// The roles that need it.
    #[serde(with = "by_names")]
    pub roles: Vec<Role>,
    /// Its level.
    #[serde(with = "by_name")]
    pub level: Level,
    /// Whether it decides the verdict.
    pub binding: bool,
    /// The call.
    #[serde(with = "by_name")]
    pub call: Call,
    /// What became of it.
    #[serde(with = "by_name")]
    pub outcome: OutcomeKind,
    /// What it counts for.
    #[serde(with = "by_name")]
    pub status: Status,
    /// What it says of the first of its rules: `passed`, `failed`, `inconclusive`, `unsupported` or `not run`.
    #[serde(with = "shared")]
    pub ruling: Arc<str>,
    /// The rule that it is charged to; of an inconclusive case the one that it waits for, and of a trace with a step
    /// that the peer cannot do the one of that step.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub charged: Option<String>,
    /// What was expected, in words, unless it passed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub expected: Option<String>,
    /// What differs.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub differences: Vec<DifferenceReport>,
    /// How many more differences there are.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub more_differences: usize,
    /// Where the answer first differs, as a JSON pointer; of a trace with a step that the peer cannot do, that step.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub place: Option<String>,
    /// What the answer is there, unless another value: `refusal`, `order` or `crash`.
    #[serde(default, skip_serializing_if = "is_value", with = "by_name")]
    pub manner: Manner,
    /// What happened, for a case without a proper answer.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub what: Option<String>,
    /// What was sent, shortened, without its id, unless it passed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub request: Option<String>,
    /// What came back, shortened.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub answer: Option<String>,
    /// The end of the peer's log.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub log: Option<String>,
    /// What else is worth knowing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub note: Option<String>,
    /// Why it was expected to fail.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
}

/// One difference.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
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

/// Why a result file cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum ReadError {
    /// It cannot be read.
    #[error("{}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What the operating system said.
        source: std::io::Error,
    },
    /// It is no result.
    #[error("{}: {source}", path.display())]
    Form {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        source: FormError,
    },
}

/// Why a text is no result.
#[derive(Debug, thiserror::Error)]
pub enum FormError {
    /// Its JSON is not that of a result.
    #[error("this is no result of ncp-verify: {0}")]
    Json(#[from] serde_json::Error),
    /// It is a result of another format.
    #[error("its format is {0}, and this program understands {FORMAT}")]
    Format(u32),
}

impl Report {
    /// Begins a report.
    #[must_use]
    pub fn new(suite: &Suite, asked: Asked, started: SystemTime) -> Self {
        let corpus = Corpus { files: suite.files(), cases: suite.cases().len(), sha256: suite.digest().to_owned() };
        Self {
            format: FORMAT,
            tool: Tool::this(),
            started: time_of(started),
            elapsed_s: 0.0,
            wire_version: WIRE_VERSION.to_owned(),
            contract_hash: CONTRACT_HASH.to_owned(),
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

    /// How the program that wrote it ended.
    #[must_use]
    pub fn exit(&self) -> Exit {
        let all = [Exit::Conformant, Exit::NotConformant, Exit::NotStarted, Exit::Interrupted];
        all.into_iter().find(|exit| exit.code() == self.exit_code).unwrap_or(Exit::Harness)
    }

    /// Reads a result file.
    ///
    /// # Errors
    /// [`ReadError`] if it cannot be read or is no result of this format.
    pub fn read(path: &Path) -> Result<Self, ReadError> {
        let fault = |source| ReadError::Read { path: path.to_owned(), source };
        // It is large where peers are many: it is read without being held.
        let mut file = File::open(path).map_err(fault)?;
        if let Ok(report) = serde_json::from_reader::<_, Self>(BufReader::with_capacity(BUFFER, &file))
            && report.format == FORMAT
        {
            return Ok(report);
        }
        let mut text = String::new();
        file.rewind().and_then(|()| file.read_to_string(&mut text)).map_err(fault)?;
        Self::from_json(&text).map_err(|source| ReadError::Form { path: path.to_owned(), source })
    }

    /// Reads the text of a result file.
    ///
    /// # Errors
    /// [`FormError`] if it is no result of this format.
    pub fn from_json(text: &str) -> Result<Self, FormError> {
        #[derive(Deserialize)]
        struct Known {
            format: u32,
        }
        let Known { format } = serde_json::from_str(text)?;
        if format != FORMAT {
            return Err(FormError::Format(format));
        }
        Ok(serde_json::from_str(text)?)
    }

    /// Writes the JSON result file.
    ///
    /// # Errors
    /// What `out` says.
    pub fn write_json(&self, out: impl Write) -> io::Result<()> {
        let mut out = BufWriter::with_capacity(BUFFER, out);
        serde_json::to_writer_pretty(&mut out, self)?;
        out.write_all(b"\n")?;
        out.flush()
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
    /// The verdict in a word, or why there is none.
    #[must_use]
    pub fn verdict(&self) -> &'static str {
        match (self.state, self.conclusion) {
            (State::Checked, Some(conclusion)) => conclusion.as_str(),
            (State::Checked | State::NotStarted, _) => "not started",
            (State::Skipped, _) => "skipped",
        }
    }

    /// A peer that was not checked.
    #[must_use]
    pub fn unchecked(name: String, source: String, state: State, reason: String) -> Self {
        Self {
            name,
            source,
            state,
            reason: Some(reason),
            description: None,
            level: None,
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

    /// A peer that was checked. What it was held to is still to be said: its [level](Self::level), and by
    /// [`expecting`](Self::expecting) its expected failures.
    #[must_use]
    pub fn checked(
        name: String,
        source: String,
        description: &Description,
        verdict: &Verdict<'_>,
        run: impl Into<RunReport>,
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
            description: Some(DescriptionReport::from(description)),
            level: None,
            conclusion: Some(verdict.conclusion),
            roles: verdict.roles.iter().map(|role| RoleReport::new(role, &verdict.cases)).collect(),
            totals,
            not_asked,
            expected_failures: verdict.excuses.iter().map(ExcuseReport::new).collect(),
            run: Some(run.into()),
            cases: verdict.cases.iter().map(CaseReport::new).collect(),
            diagnosis: None,
            broken: diagnosis::likeliest_first(&verdict.cases, of(Status::Failed)),
            advised: diagnosis::by_rule(&verdict.cases, of(Status::Advice)),
        }
    }
}

impl From<&RunRecord> for RunReport {
    fn from(run: &RunRecord) -> Self {
        Self {
            answers: run.answers,
            elapsed_s: run.elapsed.as_secs_f64(),
            rate: run.rate.map(|rate| RateReport::new(rate.answers, rate.elapsed.as_secs_f64())),
            faults: run.faults,
            crash_log: run.crash_log.clone().map(|CrashLog { case, log }| CrashLogReport { case, log }),
            given_up: run.given_up.clone(),
            notes: run.notes.clone(),
        }
    }
}

impl RateReport {
    /// So many answers in so many seconds.
    #[must_use]
    pub fn new(answers: u64, elapsed_s: f64) -> Self {
        let elapsed_s = elapsed_s.max(1e-9);
        Self { answers, elapsed_s, per_second: answers as f64 / elapsed_s }
    }
}

impl From<&Description> for DescriptionReport {
    fn from(description: &Description) -> Self {
        let Description { name, version, language, wire_version, contract_hash, roles, reference_networks } =
            description.clone();
        Self { name, version, language, wire_version, contract_hash, roles, reference_networks }
    }
}

impl From<&DescriptionReport> for Description {
    fn from(description: &DescriptionReport) -> Self {
        let DescriptionReport { name, version, language, wire_version, contract_hash, roles, reference_networks } =
            description.clone();
        Self { name, version, language, wire_version, contract_hash, roles, reference_networks }
    }
}

impl PeerReport {
    /// Says of each expected failure which entry of the list it is; `entries` is that list.
    pub fn expecting(&mut self, entries: &[ExpectedFailure]) {
        for (excuse, entry) in self.expected_failures.iter_mut().zip(entries) {
            excuse.says = entry.clone();
        }
    }

    /// Explains the failing cases by the fewest known defects; none if the dictionary knows none of the cases.
    pub fn diagnose(&mut self, dictionary: &Dictionary, verdict: &Verdict<'_>) {
        let mut observed = Observed::of(verdict.cases.iter().map(|judged| (judged.case, &judged.run.outcome)));
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
        // Large cases are asked of a mutant only where no other fails, so few entries of the dictionary know them:
        // that no entry explains such a case speaks against none, and it belongs to the defect that breaks its rule.
        let unasked = |(key, seen): (&CaseKey, &Seen)| {
            let is_large = failing.get(key).is_some_and(|case| case.is_large());
            let known =
                |symptom: Symptom| dictionary.entries.iter().any(|entry| entry.symptoms.get(key) == Some(&symptom));
            (is_large && !seen.symptom.is_some_and(known)).then_some(*key)
        };
        let unasked: Vec<CaseKey> = observed.cases.iter().filter_map(unasked).collect();
        observed.cases.retain(|key, _| !unasked.contains(key));
        let Explanation { mut defects, mut unexplained } = dictionary.explain(&observed);
        let charged = verdict.cases.iter().filter_map(|judged| {
            let rule = judged.ruling.charged().or(judged.case.requirements.first())?;
            Some((CaseKey::of(&judged.case.id), rule.id.as_str()))
        });
        let charged: HashMap<CaseKey, &str> = charged.collect();
        for key in unasked {
            let found = defects.iter_mut().find(|found| {
                found.cases.iter().any(|other| charged.get(other).is_some_and(|rule| charged.get(&key) == Some(rule)))
            });
            found.map_or(&mut unexplained, |found| &mut found.cases).push(key);
        }
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
        let says = ExpectedFailure::default();
        Self { entry, reason, cases, written, too_broad, expired, stale, stale_cases, says }
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

    /// What is wrong, in a line. The rule that is broken comes first, so that a list of such lines is one of rules.
    #[must_use]
    pub fn in_brief(&self) -> String {
        let difference = || self.differences.first().map_or(self.outcome.as_str(), |first| &first.text).to_owned();
        let what = self.what.clone().unwrap_or_else(difference);
        match &self.charged {
            Some(rule) if self.waits() => format!("waits for {rule}: {what}"),
            Some(rule) => format!("{rule}: {what}"),
            None => what,
        }
    }

    /// The rule that it is charged to, or else is about.
    #[must_use]
    pub fn rule(&self) -> &str {
        self.charged.as_ref().or(self.rules.first()).map_or("", String::as_str)
    }

    fn new(judged: &Judged<'_>) -> Self {
        let Judged { case, run, status, ruling, reason } = judged;
        let passed = run.outcome == Outcome::Pass;
        let StoredRun { outcome, place, manner, differences, more_differences, what, answer, log, note } =
            StoredRun::from(run);
        Self {
            id: case.id.clone(),
            title: shared::shared(case.title.as_str()),
            rules: shared::shared(case.requirements.iter().map(|rule| rule.id.clone()).collect::<Vec<_>>()),
            roles: case.roles.clone(),
            level: case.level,
            binding: case.binding,
            call: case.call,
            outcome,
            status: *status,
            ruling: shared::shared(ruling.as_str()),
            charged: ruling.decided_by().map(|rule| rule.id.clone()),
            expected: (!passed).then(|| in_words(&case.expect)),
            differences,
            more_differences,
            place,
            manner,
            what,
            request: (!passed).then(|| excerpt(format!("{{{}", case.body()).as_bytes(), KEPT_BYTES)),
            answer,
            log,
            note,
            reason: reason.clone(),
        }
    }

    /// What became of it, as it was before it was judged.
    #[must_use]
    pub fn run(&self) -> CaseRun {
        let stored = StoredRun {
            outcome: self.outcome,
            place: self.place.clone(),
            manner: self.manner,
            differences: self.differences.clone(),
            more_differences: self.more_differences,
            what: self.what.clone(),
            answer: self.answer.clone(),
            log: self.log.clone(),
            note: self.note.clone(),
        };
        stored.into()
    }
}

/// What became of a case, as it is written down.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StoredRun {
    #[serde(with = "by_name")]
    pub(crate) outcome: OutcomeKind,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    place: Option<String>,
    #[serde(default, skip_serializing_if = "is_value", with = "by_name")]
    manner: Manner,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    differences: Vec<DifferenceReport>,
    #[serde(default, skip_serializing_if = "is_zero")]
    more_differences: usize,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    what: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    answer: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    log: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    note: Option<String>,
}

impl From<&CaseRun> for StoredRun {
    fn from(run: &CaseRun) -> Self {
        let mut stored = Self {
            outcome: run.outcome.kind(),
            place: None,
            manner: Manner::Value,
            differences: Vec::new(),
            more_differences: 0,
            what: None,
            answer: run.answer.as_deref().map(without_id),
            log: None,
            note: run.note.clone(),
        };
        match &run.outcome {
            Outcome::Pass => {}
            Outcome::NotRun { why } => stored.what = Some(why.clone()),
            Outcome::Unsupported { step } => stored.place.clone_from(step),
            Outcome::Crash { what, log } | Outcome::Timeout { what, log } | Outcome::Protocol { what, log } => {
                stored.what = Some(what.clone());
                stored.log = (!log.is_empty()).then(|| log.clone());
            }
            Outcome::Fail(Differences { first, more, place, manner }) => {
                stored.differences = first.iter().map(DifferenceReport::from).collect();
                stored.more_differences = *more;
                stored.place = Some(place.clone());
                stored.manner = *manner;
            }
        }
        stored
    }
}

impl From<StoredRun> for CaseRun {
    fn from(stored: StoredRun) -> Self {
        let StoredRun { outcome, place, manner, differences, more_differences, what, answer, log, note } = stored;
        let (what, log) = (what.unwrap_or_default(), log.unwrap_or_default());
        let outcome = match outcome {
            OutcomeKind::Pass => Outcome::Pass,
            OutcomeKind::NotRun => Outcome::NotRun { why: what },
            OutcomeKind::Unsupported => Outcome::Unsupported { step: place },
            OutcomeKind::Crash => Outcome::Crash { what, log },
            OutcomeKind::Timeout => Outcome::Timeout { what, log },
            OutcomeKind::Protocol => Outcome::Protocol { what, log },
            OutcomeKind::Fail => {
                let first = differences.into_iter().map(Difference::from).collect();
                Outcome::Fail(Differences { first, more: more_differences, place: place.unwrap_or_default(), manner })
            }
        };
        Self { outcome, answer, note }
    }
}

impl From<&Difference> for DifferenceReport {
    fn from(difference: &Difference) -> Self {
        let text = difference.to_string();
        let Difference { at, expected, got, hint } = difference.clone();
        Self { at, expected, got, hint, text }
    }
}

impl From<DifferenceReport> for Difference {
    fn from(DifferenceReport { at, expected, got, hint, .. }: DifferenceReport) -> Self {
        Self { at, expected, got, hint }
    }
}

/// An answer without the id of its request, which says only how many were sent to the process before.
fn without_id(answer: &str) -> String {
    let mut kept = answer.to_owned();
    // None but a faulty answer has two.
    while let Some(id) = id_member(&kept) {
        kept.replace_range(id, "");
    }
    kept
}

/// Where the member `id` of an object stands, with one comma beside it.
fn id_member(text: &str) -> Option<std::ops::Range<usize>> {
    let bytes = text.as_bytes();
    let skip = |from: usize, of: fn(u8) -> bool| {
        bytes.iter().skip(from).position(|byte| !of(*byte)).map_or(bytes.len(), |length| from + length)
    };
    let white = |byte: u8| byte.is_ascii_whitespace();
    let (mut depth, mut at, mut comma) = (0_usize, 0, None);
    while let Some(byte) = bytes.get(at) {
        match byte {
            b'{' | b'[' => depth += 1,
            b'}' | b']' => depth = depth.saturating_sub(1),
            b',' if depth == 1 => comma = Some(at),
            b'"' => {
                let start = at;
                at += 1;
                while bytes.get(at).is_some_and(|byte| *byte != b'"') {
                    at += if bytes.get(at) == Some(&b'\\') { 2 } else { 1 };
                }
                let colon = skip(at + 1, white);
                if depth == 1 && text.get(start..=at) == Some("\"id\"") && bytes.get(colon) == Some(&b':') {
                    let value = skip(colon + 1, white);
                    let end = skip(skip(value, |byte| byte.is_ascii_digit()), white);
                    return match (bytes.get(end), comma) {
                        _ if end == value => None,
                        (Some(b','), _) => Some(start..skip(end + 1, white)),
                        (_, Some(comma)) => Some(comma..end),
                        (_, None) => Some(start..end),
                    };
                }
            }
            _ => {}
        }
        at += 1;
    }
    None
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

/// The day of a time in UTC, such as `2026-12-31`.
#[must_use]
pub fn day_of(time: SystemTime) -> String {
    time_of(time).chars().take(10).collect()
}

/// A time as RFC 3339 writes it, in UTC, to the second.
#[must_use]
pub fn time_of(time: SystemTime) -> String {
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

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes a reference")]
fn is_zero(count: &usize) -> bool {
    *count == 0
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes a reference")]
fn is_value(manner: &Manner) -> bool {
    *manner == Manner::Value
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_answer_is_shown_without_the_id_of_its_request() {
        for (answer, shown) in [
            (r#"{"id":4,"result":{"id":5}}"#, r#"{"result":{"id":5}}"#),
            (r#"{ "result": [{"id": 1}], "id" : 4 }"#, r#"{ "result": [{"id": 1}]}"#),
            (r#"{"id":1,"id":2,"x":"\"id\":3"}"#, r#"{"x":"\"id\":3"}"#),
            (r#"{"id":4}"#, "{}"),
            (r#"{"id":"four"}"#, r#"{"id":"four"}"#),
            (r#"{"id":"#, r#"{"id":"#),
            (r#"{"x":"\"#, r#"{"x":"\"#),
            ("", ""),
        ] {
            assert_eq!(without_id(answer), shown);
        }
    }

    proptest::proptest! {
        #[test]
        fn an_answer_without_an_id_stays_as_it_is(text in "[{}\\[\\]\":,\\\\id0-9 ä]{0,40}") {
            let once = without_id(&text);
            proptest::prop_assert_eq!(without_id(&once), once);
        }
    }

    #[test]
    fn a_time_is_written_by_rfc_3339() {
        for (seconds, text) in [
            (0, "1970-01-01T00:00:00Z"),
            (951_782_399, "2000-02-28T23:59:59Z"),
            (951_782_400, "2000-02-29T00:00:00Z"),
            (1_709_251_199, "2024-02-29T23:59:59Z"),
            (4_107_542_400, "2100-03-01T00:00:00Z"),
        ] {
            assert_eq!(time_of(UNIX_EPOCH + Duration::from_secs(seconds)), text);
        }
    }
}
