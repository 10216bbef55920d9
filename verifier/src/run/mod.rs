//! Running cases against a peer.
//!
//! [`run`] keeps many requests in flight and charges every fault to the case that causes it. It emits [`Event`]s as it
//! goes and returns a [`RunRecord`]; it renders nothing and knows no verdict.
//!
//! # Faults
//! When a peer dies, falls silent or prints something that is no answer, its process is ended, and the cases that
//! were in flight are run again, one at a time, in a fresh process. The one that does it again is the guilty one; if
//! none does, the fault is charged to the oldest request that was without an answer. A case that is the only one of
//! its process needs no second death. A process is started anew as often as it takes, or [`Settings::max_restarts`]
//! times. Whoever answers nothing any more, not even what it has answered before, is given up, and what is left is
//! *not run*.
//!
//! Several connections to one server may all end by the fault of one case. So a fault while there are several is
//! charged to nobody: the worker gives its cases back and leaves, and the last one that is left finds the guilty.
//!
//! A peer that dies again and again is asked one case at a time, until it is calm, and its next processes are started
//! ahead of need. So that a death is cheap, processes are started without backtraces; the first case that was charged
//! with a crash is run once more with them, and [that log](CrashLog) is kept whole.

mod worker;

use std::collections::{HashSet, VecDeque};
use std::sync::atomic::{AtomicBool, AtomicU32, AtomicU64, AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use crate::check::Differences;
use crate::json::Json;
use crate::peer::{Answer, Call, Connection, Launch};
use crate::suite::Case;

pub use crate::stop::Stop;
use worker::Worker;

/// After this many faults without an answer between them, a peer that has never answered is asked for a sign of life.
const FRUITLESS_AT_FIRST: u32 = 3;
/// The same for a peer that has answered before: cases that crash may well stand side by side.
const FRUITLESS_LATER: u32 = 8;

/// How to run.
#[derive(Debug, Clone)]
pub struct Settings {
    /// How many processes of the peer, or connections to its server, work side by side.
    pub jobs: usize,
    /// How long a peer may be silent while a request is in flight. A large request is given a second more a MiB.
    pub timeout: Duration,
    /// How long a process may take to answer `describe`.
    pub start_timeout: Duration,
    /// How often a process may be started anew after a fault; none: as often as it takes.
    pub max_restarts: Option<u32>,
    /// How often every case is run. The [large](Case::is_large) ones are run once, after the others.
    pub repeat: u32,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            jobs: 1,
            timeout: Duration::from_secs(10),
            start_timeout: Duration::from_secs(30),
            max_restarts: None,
            repeat: 1,
        }
    }
}

/// What happened to one case.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CaseRun {
    /// What became of it.
    pub outcome: Outcome,
    /// The line that came back, shortened, unless the case passed.
    pub answer: Option<String>,
    /// What is worth knowing beside the outcome.
    pub note: Option<String>,
}

/// What became of one case.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Outcome {
    /// The answer is right.
    Pass,
    /// The answer is wrong.
    Fail(Differences),
    /// The peer has no such function, or cannot do a step of a trace.
    Unsupported {
        /// Where that step is, as a JSON pointer; none: the whole call.
        step: Option<String>,
    },
    /// The peer ended while it worked on the case.
    Crash {
        /// How.
        what: String,
        /// The end of its log.
        log: String,
    },
    /// No answer came in time.
    Timeout {
        /// What was seen.
        what: String,
        /// The end of its log.
        log: String,
    },
    /// What came broke the peer protocol.
    Protocol {
        /// How.
        what: String,
        /// The end of its log.
        log: String,
    },
    /// The case was not run.
    NotRun {
        /// Why.
        why: String,
    },
}

impl Outcome {
    /// Which it is, whatever came with it.
    #[must_use]
    pub fn kind(&self) -> OutcomeKind {
        match self {
            Self::NotRun { .. } => OutcomeKind::NotRun,
            Self::Pass => OutcomeKind::Pass,
            Self::Unsupported { .. } => OutcomeKind::Unsupported,
            Self::Fail(_) => OutcomeKind::Fail,
            Self::Protocol { .. } => OutcomeKind::Protocol,
            Self::Timeout { .. } => OutcomeKind::Timeout,
            Self::Crash { .. } => OutcomeKind::Crash,
        }
    }
}

/// The kinds of [`Outcome`], by how much they weigh when a case was run more than once: the worst counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum OutcomeKind {
    /// [`Outcome::NotRun`].
    NotRun,
    /// [`Outcome::Pass`].
    Pass,
    /// [`Outcome::Unsupported`].
    Unsupported,
    /// [`Outcome::Fail`].
    Fail,
    /// [`Outcome::Protocol`].
    Protocol,
    /// [`Outcome::Timeout`].
    Timeout,
    /// [`Outcome::Crash`].
    Crash,
}

impl OutcomeKind {
    /// As reports write it.
    #[must_use]
    pub fn as_str(self) -> &'static str {
        match self {
            Self::NotRun => "not run",
            Self::Pass => "pass",
            Self::Unsupported => "unsupported",
            Self::Fail => "fail",
            Self::Protocol => "protocol",
            Self::Timeout => "timeout",
            Self::Crash => "crash",
        }
    }

    /// Whether the peer did not answer as the protocol wants it, rather than wrongly.
    #[must_use]
    pub fn is_fault(self) -> bool {
        matches!(self, Self::Crash | Self::Timeout | Self::Protocol)
    }
}

/// What a run tells while it goes on.
#[derive(Debug, Clone, Copy)]
pub enum Event<'e> {
    /// This many more answers were judged, of which so many were not right.
    Judged {
        /// How many.
        answers: u64,
        /// How many of them were not right.
        wrong: u64,
    },
    /// What became of a case. Of a case that is told more than once, the [worst](keep_worst) counts.
    Recorded {
        /// The case.
        case: &'e str,
        /// What became of it.
        run: &'e CaseRun,
    },
    /// An answer to `session.run` opened a session, for the first time in the run.
    Opened,
    /// A fault was charged to a case.
    Fault {
        /// The case.
        case: &'e str,
        /// What happened.
        what: &'e str,
    },
    /// The peer was given up.
    GivenUp {
        /// Why.
        why: &'e str,
    },
}

/// Listens to a run. Called from the run's own threads.
pub trait Listener: Sync {
    /// Takes an event.
    fn on(&self, event: Event<'_>);
}

/// Listens to nothing.
#[derive(Debug, Clone, Copy)]
pub struct Deaf;

impl Listener for Deaf {
    fn on(&self, _: Event<'_>) {}
}

/// What a run leaves.
#[derive(Debug)]
pub struct RunRecord {
    /// What became of each case, in the order in which they were given.
    pub cases: Vec<CaseRun>,
    /// How many answers were judged.
    pub answers: u64,
    /// How long that took, without starting the first process.
    pub elapsed: Duration,
    /// How fast the cases that are not [large](Case::is_large) were answered, if all of them were.
    pub rate: Option<Rate>,
    /// How many processes ended in a fault.
    pub faults: u32,
    /// The whole log of one crash, if there was one and it happened again.
    pub crash_log: Option<CrashLog>,
    /// Why the peer was given up, if it was.
    pub given_up: Option<String>,
    /// Whether any answer to `session.run` opened a session; none: nothing was asked of sessions.
    pub opened: Option<bool>,
    /// What else was noticed about the peer.
    pub notes: Vec<String>,
}

/// The log of a process that was given one case and died of it, with all backtraces.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CrashLog {
    /// The case.
    pub case: String,
    /// What the process wrote to its standard error.
    pub log: String,
}

/// So many answers in so much time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rate {
    /// How many answers were judged.
    pub answers: u64,
    /// How long that took.
    pub elapsed: Duration,
}

/// Runs cases against a peer whose first process, `connection`, has already described itself.
#[must_use]
pub fn run(
    launch: &Launch,
    connection: Connection,
    cases: &[&Case],
    settings: &Settings,
    listener: &dyn Listener,
    stop: &Stop,
) -> RunRecord {
    let shared = Shared::new(launch, cases, settings, listener, stop);
    let jobs = jobs(settings, cases);
    let mut first = Some(connection);
    let reports: Vec<_> = thread::scope(|scope| {
        let workers: Vec<_> = (0..jobs)
            .map(|_| {
                let worker = Worker::new(&shared, first.take());
                scope.spawn(move || worker.work())
            })
            .collect();
        workers.into_iter().filter_map(|worker| worker.join().ok()).collect()
    });
    let mut merged: Vec<Option<CaseRun>> = vec![None; cases.len()];
    let mut notes = Vec::new();
    for report in reports {
        for (mine, theirs) in merged.iter_mut().zip(report.cases) {
            if let Some(theirs) = theirs {
                keep_worst(mine, theirs);
            }
        }
        notes.extend(report.notes);
    }
    notes.dedup();
    let given_up = shared.given_up();
    let why = match &given_up {
        _ if stop.is_set() => "the run was interrupted".to_owned(),
        Some(why) => format!("the peer was given up: {why}"),
        None => "its worker came to an end".to_owned(),
    };
    let not_run = || CaseRun { outcome: Outcome::NotRun { why: why.clone() }, answer: None, note: None };
    let elapsed = shared.start.elapsed();
    let cases_run: Vec<CaseRun> = merged.into_iter().map(|case| case.unwrap_or_else(not_run)).collect();
    let reproducible = |run: &CaseRun| run.outcome.kind() == OutcomeKind::Crash && run.note.is_none();
    let crash_log = cases_run.iter().position(reproducible).and_then(|place| worker::crash_log(&shared, place));
    RunRecord {
        cases: cases_run,
        answers: shared.answers.load(Ordering::Relaxed),
        elapsed,
        rate: shared.rate.get().copied(),
        faults: shared.faults.load(Ordering::Relaxed),
        crash_log,
        given_up,
        opened: cases.iter().any(|case| case.call == Call::SessionRun).then(|| shared.opened.load(Ordering::Relaxed)),
        notes,
    }
}

/// How many workers there are.
fn jobs(settings: &Settings, cases: &[&Case]) -> usize {
    settings.jobs.clamp(1, cases.len().max(1))
}

/// Keeps the worse of what is known and what is new.
pub fn keep_worst(known: &mut Option<CaseRun>, new: CaseRun) {
    if known.as_ref().is_none_or(|known| known.outcome.kind() < new.outcome.kind()) {
        *known = Some(new);
    }
}

/// Whether one of the replies in an answer to `session.run` opened a session.
fn opens_a_session(answer: &Answer<'_>) -> bool {
    let Answer::Result(result) = answer else {
        return false;
    };
    let Some(Json::Array(replies)) = result.get("replies") else {
        return false;
    };
    replies.iter().filter_map(Json::as_str).any(|reply| {
        Json::parse(reply).is_ok_and(|reply| {
            reply.get("kind").and_then(Json::as_str) == Some("session_opened")
                && !matches!(reply.get("ok"), Some(Json::Bool(false)))
        })
    })
}

/// What the workers of one run share.
struct Shared<'r> {
    launch: &'r Launch,
    cases: &'r [&'r Case],
    settings: &'r Settings,
    listener: &'r dyn Listener,
    stop: &'r Stop,
    start: Instant,
    /// The cases that are repeated, and those that are not, by their indices.
    small: Vec<usize>,
    large: Vec<usize>,
    next: AtomicUsize,
    answers: AtomicU64,
    small_answers: AtomicU64,
    rate: OnceLock<Rate>,
    faults: AtomicU32,
    /// Faults since the last answer.
    fruitless: AtomicU32,
    first_answered: OnceLock<usize>,
    opened: AtomicBool,
    given_up: Mutex<Option<String>>,
    ended: AtomicBool,
    crowd: Mutex<Crowd>,
}

/// The workers that are at work, and what those left who had a fault by the side of others.
struct Crowd {
    workers: usize,
    given_back: VecDeque<usize>,
}

impl<'r> Shared<'r> {
    fn new(
        launch: &'r Launch,
        cases: &'r [&'r Case],
        settings: &'r Settings,
        listener: &'r dyn Listener,
        stop: &'r Stop,
    ) -> Self {
        let (large, small) = (0..cases.len()).partition(|index| cases[*index].is_large());
        Self {
            launch,
            cases,
            settings,
            listener,
            stop,
            start: Instant::now(),
            small,
            large,
            small_answers: AtomicU64::new(0),
            rate: OnceLock::new(),
            next: AtomicUsize::new(0),
            answers: AtomicU64::new(0),
            faults: AtomicU32::new(0),
            fruitless: AtomicU32::new(0),
            first_answered: OnceLock::new(),
            opened: AtomicBool::new(false),
            given_up: Mutex::new(None),
            ended: AtomicBool::new(false),
            crowd: Mutex::new(Crowd { workers: jobs(settings, cases), given_back: VecDeque::new() }),
        }
    }

    /// The next case that no worker has taken, by its index.
    fn take(&self) -> Option<usize> {
        if let Some(given_back) = self.crowd().given_back.pop_front() {
            return Some(given_back);
        }
        let repeated = self.small_total();
        let total = repeated + self.large.len();
        if self.next.load(Ordering::Relaxed) >= total {
            return None;
        }
        match self.next.fetch_add(1, Ordering::Relaxed) {
            taken if taken < repeated => self.small.get(taken % self.small.len()).copied(),
            taken => self.large.get(taken - repeated).copied(),
        }
    }

    /// Whether another worker is connected to the same server.
    fn is_crowded(&self) -> bool {
        self.launch.is_shared() && self.crowd().workers > 1
    }

    /// Leaves cases to the workers that stay. Whether there are any; if not, the worker itself has to stay.
    fn give_back(&self, cases: impl Iterator<Item = usize>) -> bool {
        let mut crowd = self.crowd();
        crowd.given_back.extend(cases);
        let leaves = crowd.workers > 1;
        crowd.workers -= usize::from(leaves);
        leaves
    }

    /// Whether a worker that finds nothing to do may leave.
    fn may_leave(&self) -> bool {
        let mut crowd = self.crowd();
        let leaves = crowd.workers > 1 || crowd.given_back.is_empty();
        crowd.workers -= usize::from(leaves);
        leaves
    }

    fn crowd(&self) -> MutexGuard<'_, Crowd> {
        self.crowd.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn small_total(&self) -> usize {
        self.small.len().saturating_mul(self.settings.repeat as usize)
    }

    /// Counts answers, `small` of them to cases that are not large.
    fn count_answers(&self, answers: u64, small: u64) {
        self.answers.fetch_add(answers, Ordering::Relaxed);
        let answered = self.small_answers.fetch_add(small, Ordering::Relaxed) + small;
        if small > 0 && answered >= self.small_total() as u64 {
            // Only the first time counts: after a fault, cases are answered again.
            self.rate.get_or_init(|| Rate { answers: answered, elapsed: self.start.elapsed() });
        }
    }

    /// Takes note if an answer opens a session.
    fn look_for_a_session(&self, case: &Case, answer: &Answer<'_>) {
        if case.call == Call::SessionRun
            && !self.opened.load(Ordering::Relaxed)
            && opens_a_session(answer)
            && !self.opened.swap(true, Ordering::Relaxed)
        {
            self.listener.on(Event::Opened);
        }
    }

    /// Whether to come to an end.
    fn is_over(&self) -> bool {
        self.stop.is_set() || self.ended.load(Ordering::Relaxed)
    }

    fn given_up(&self) -> Option<String> {
        self.given_up.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    fn give_up(&self, why: String) {
        let mut given_up = self.given_up.lock().unwrap_or_else(PoisonError::into_inner);
        if given_up.is_none() {
            self.listener.on(Event::GivenUp { why: &why });
            *given_up = Some(why);
        }
        self.ended.store(true, Ordering::Relaxed);
    }

    /// Notes that a process ended in a fault, and gives the peer up if that is more often than was asked for.
    fn count_fault(&self, fault: &str) {
        let faults = self.faults.fetch_add(1, Ordering::Relaxed) + 1;
        self.fruitless.fetch_add(1, Ordering::Relaxed);
        if let Some(most) = self.settings.max_restarts.filter(|most| faults > *most) {
            self.give_up(format!("after {} it {fault}", count(most, "restart")));
        }
    }

    /// Notes that a case was answered.
    fn answered(&self, case: usize) {
        self.first_answered.get_or_init(|| case);
        self.fruitless.store(0, Ordering::Relaxed);
    }

    /// Whether there were so many faults without an answer between them that it is time to look for a sign of life.
    fn is_fruitless(&self) -> bool {
        let never = self.first_answered.get().is_none();
        !self.is_over()
            && self.fruitless.load(Ordering::Relaxed) >= if never { FRUITLESS_AT_FIRST } else { FRUITLESS_LATER }
    }

    /// The first case of each call.
    fn one_of_each_call(&self) -> Vec<usize> {
        let mut calls = HashSet::new();
        (0..self.cases.len()).filter(|index| calls.insert(self.cases[*index].call)).collect()
    }
}

/// So many of these.
fn count(number: u32, word: &str) -> String {
    format!("{number} {word}{}", if number == 1 { "" } else { "s" })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_session_is_open_when_a_reply_says_so_and_not_when_it_refuses() {
        let opens = |replies: &str| {
            let result = format!("{{\"replies\":{replies}}}");
            opens_a_session(&Answer::Result(Json::parse(&result).unwrap()))
        };
        let refused = r#""{\"kind\":\"session_opened\",\"session_id\":\"a\",\"ok\":false}""#;
        let opened = r#""{\"kind\":\"session_opened\",\"session_id\":\"a\",\"ok\":true}""#;
        let by_default = r#""{\"kind\":\"session_opened\",\"session_id\":\"a\"}""#;
        let error = r#""{\"kind\":\"error\",\"error\":\"no\"}""#;
        assert!(opens(&format!("[{error},{opened}]")));
        assert!(opens(&format!("[{by_default}]")));
        assert!(!opens(&format!("[{refused},{error},\"\"]")));
        assert!(!opens("null") && !opens_a_session(&Answer::Unsupported));
    }
}
