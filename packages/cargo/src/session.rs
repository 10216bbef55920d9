//! One peer, its tests, and the one run that says what becomes of them.

use std::collections::{HashMap, HashSet};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use std::time::{Duration, Instant, SystemTime};

use libtest_mimic::{Arguments, Completion, Failed, Trial};
use ncp_text::catalogue::{Level, Role};
use ncp_verifier::conclude::{Checked, Extent, not_asked, roles, selected};
use ncp_verifier::peer::{Connection, Description, ExpectedFailure, ExpectedFailures, Launch, handshake};
use ncp_verifier::report::{Asked, CaseReport, Detail, NotAsked, Report, RunReport, Style, day_of, example, terminal};
use ncp_verifier::run::{self, Deaf, OutcomeKind, Settings};
use ncp_verifier::stop::Stop;
use ncp_verifier::suite::{Case, Pattern, Suite};
use ncp_verifier::verdict::{Baseline, Status};

use crate::{Conformance, HarnessError};

/// The test of what the peer says about itself.
const DESCRIBE: &str = "describe";
/// The test of the whole.
const VERDICT: &str = "verdict";
/// How long a peer may take to describe itself.
const START: Duration = Duration::from_secs(30);
/// How failures are shown.
const STYLE: Style = Style { colour: false, width: 100 };
/// The page without examples: each failing case is a test of its own.
const DETAIL: Detail = Detail { examples: 0, verbose: false };

/// A peer that has described itself, and what it is judged by.
pub(crate) struct Session {
    suite: Suite,
    launch: Launch,
    source: String,
    description: Description,
    level: Level,
    filters: Vec<String>,
    entries: Vec<ExpectedFailure>,
    baseline: Baseline,
    settings: Settings,
    started: SystemTime,
    /// The conversation in which it described itself.
    first: Mutex<Option<Connection>>,
    /// The tests that are meant; empty: nothing was said.
    meant: OnceLock<HashSet<String>>,
    judged: OnceLock<Judged>,
}

/// What became of the run.
struct Judged {
    report: Report,
    /// Where each case stands in the report on the peer.
    places: HashMap<String, usize>,
}

impl Session {
    /// Reads the suite, and lets the peer describe itself.
    pub(crate) fn begin(conformance: Conformance) -> Result<Self, HarnessError> {
        let Conformance { peer, level, filters, expected, vectors, deep, jobs, timeout } = conformance;
        let suite = match vectors {
            Some(folder) => Suite::load(&folder)?,
            None if deep => Suite::with_deep()?,
            None => Suite::embedded()?,
        };
        let started = SystemTime::now();
        let entries = expected.map_or(Ok(Vec::new()), |file| ExpectedFailures::load(&file).map(|list| list.entries))?;
        let baseline = Baseline::new(entries.clone(), &suite, &day_of(started))?;
        let (launch, source) = peer.launch()?;
        let mut connection = Connection::open(&launch)?;
        let description = handshake(&mut connection, START, &Stop::default())?;
        let session = Self {
            suite,
            launch,
            source,
            description,
            level,
            filters,
            entries,
            baseline,
            settings: Settings { jobs, timeout, start_timeout: START, ..Settings::default() },
            started,
            first: Mutex::new(Some(connection)),
            meant: OnceLock::new(),
            judged: OnceLock::new(),
        };
        match session.selected().0.is_empty() {
            true => Err(HarnessError::Nothing(session.description.name)),
            false => Ok(session),
        }
    }

    fn roles(&self) -> Vec<(Role, bool)> {
        roles(&[], &self.description)
    }

    /// The cases that the peer is to be asked, and what it is not asked.
    fn selected(&self) -> (Vec<&Case>, Vec<NotAsked>) {
        let patterns: Vec<Pattern> = self.filters.iter().map(|filter| Pattern::new(filter)).collect();
        let (cases, kept) = selected(&self.suite, &self.roles(), self.level, &patterns, &self.description);
        (cases, not_asked(&kept))
    }

    /// What became of the cases: those that are meant are run when the first test asks.
    fn judged(&self) -> &Judged {
        self.judged.get_or_init(|| self.run())
    }

    fn run(&self) -> Judged {
        let clock = Instant::now();
        let (mut cases, not_asked) = self.selected();
        if let Some(meant) = self.meant.get().filter(|meant| !meant.contains(VERDICT)) {
            cases.retain(|case| meant.contains(&case.id));
        }
        let partial = !self.filters.is_empty() || cases.len() < self.selected().0.len();
        let files: HashSet<&str> = cases.iter().map(|case| &*case.file).collect();
        let asked = Asked {
            level: self.level,
            roles: Vec::new(),
            filters: self.filters.clone(),
            files: files.len(),
            cases: cases.len(),
            repeat: 1,
            partial,
            shard: None,
            rerun: false,
            deep: cases.iter().filter(|case| case.is_deep()).count(),
        };
        let first = self.first.lock().unwrap_or_else(PoisonError::into_inner).take();
        // It was kept since the peer described itself; without it a new one would be opened, and tell why it cannot.
        let record = first.map(|first| run::run(&self.launch, first, &cases, &self.settings, &Deaf, &Stop::default()));
        let mut report = Report::new(&self.suite, asked, self.started);
        if let Some(record) = record {
            let checked = Checked {
                name: self.description.name.clone(),
                source: self.source.clone(),
                description: self.description.clone(),
                level: self.level,
                asked: &[],
                entries: &self.entries,
                baseline: &self.baseline,
                extent: if partial { Extent::Picked } else { Extent::Whole },
                cases: cases.into_iter().zip(record.cases.iter().cloned()).collect(),
                run: RunReport::from(&record),
                opened: record.opened,
                not_asked,
            };
            report.peers.push(checked.conclude(&self.suite));
        }
        report.close(clock.elapsed(), false);
        let cases = report.peers.iter().flat_map(|peer| &peer.cases);
        let places = cases.enumerate().map(|(place, case)| (case.id.clone(), place)).collect();
        Judged { report, places }
    }

    /// What the test of a case says.
    fn tell(&self, id: &str) -> Result<Completion, Failed> {
        let Judged { report, places } = self.judged();
        let found = places.get(id).and_then(|place| report.peers.first()?.cases.get(*place));
        let Some(case) = found else { return Err("it was not run".into()) };
        match case.status {
            Status::Passed | Status::Advice | Status::ExpectedFailure => Ok(Completion::Completed),
            Status::Failed if case.outcome == OutcomeKind::Unsupported => {
                Ok(Completion::ignored_with(format!("unsupported: the peer has no {} for this", case.call.as_str())))
            }
            Status::Failed => Err(example(report, case, STYLE, DETAIL).into()),
            Status::UnexpectedPass => Err(unexpected(case).into()),
            Status::NotRun => Err(format!("not run: {}", case.what.as_deref().unwrap_or_default()).into()),
        }
    }

    /// What the test of the whole says.
    fn verdict(&self) -> Result<(), Failed> {
        let Judged { report, .. } = self.judged();
        if report.exit_code == 0 { Ok(()) } else { Err(terminal(report, STYLE, DETAIL).into()) }
    }
}

/// The tests of a session: `describe`, one a case, and `verdict`. Remembers which of them the command line means.
pub(crate) fn tests(session: &Arc<Session>, args: &Arguments) -> Vec<Trial> {
    let (cases, _) = session.selected();
    let ids = std::iter::once(DESCRIBE).chain(cases.iter().map(|case| case.id.as_str()));
    let mut tests: Vec<Trial> = ids
        .map(|id| {
            let (session, id) = (Arc::clone(session), id.to_owned());
            Trial::ignorable_test(id.clone(), move || session.tell(&id))
        })
        .collect();
    let whole = Arc::clone(session);
    tests.push(Trial::test(VERDICT, move || whole.verdict()));
    let meant = tests.iter().filter(|test| !args.is_filtered_out(test)).map(|test| test.name().to_owned());
    session.meant.get_or_init(|| meant.collect());
    tests
}

fn unexpected(case: &CaseReport) -> String {
    let Some(reason) = &case.reason else { return UNEXPECTED.to_owned() };
    format!("{UNEXPECTED} ({reason})")
}

const UNEXPECTED: &str = "unexpected pass: it is listed as an expected failure, and passes: take it out of the list";
