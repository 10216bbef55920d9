//! One worker: it keeps a process of the peer busy, and finds out which case a fault belongs to.

use std::collections::{HashSet, VecDeque};
use std::sync::atomic::Ordering;
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use super::{CaseRun, CrashLog, Event, Outcome, Settings, Shared, Stop, keep_worst};
use crate::check::{Judgement, judge};
use crate::peer::{
    Answer, Call, Connection, Ending, Incoming, Reply, ReplyFault, StartError, excerpt, handshake, put_request,
};
use crate::suite::Case;

/// How many requests may be in flight.
const WINDOW: usize = 256;
/// How many bytes of requests may be in flight, unless a single one is larger.
const WINDOW_BYTES: usize = 1 << 20;
/// How long an answer may be, beside eight times the largest request.
const ANSWER_BYTES: usize = 16 << 20;
/// How often we look up from waiting.
const TICK: Duration = Duration::from_millis(50);
/// How long a peer that no longer takes requests may go on answering.
const DEAF_GRACE: Duration = Duration::from_secs(1);
/// How long a process may take to end after the end of its input.
const END_GRACE: Duration = Duration::from_secs(2);
/// How long we listen, after the answer of a case that runs alone, for what does not belong there.
const LINGER: Duration = Duration::from_millis(20);
/// How long we listen for words that came after an answer, and may come again: the road may be slow, the machine busy.
const LISTEN: Duration = Duration::from_millis(500);
/// How many answers to requests that are long answered one process may give.
const MAX_STRAYS: usize = 256;
/// How often in a row a process may fail to start anew.
const STARTS: u32 = 3;
/// How long a server that somebody else starts is left alone after such a failure: what stands before it may accept
/// connections for it while it is gone.
const RETURN: Duration = Duration::from_secs(2);
/// After so many faults, processes are started ahead of need.
const SPARES_AFTER: u32 = 3;
/// How many of them there may be.
const MOST_SPARES: usize = 4;
/// How many cases in a row a peer has to answer one at a time, after a crash, until many are in flight again.
const CALM: usize = 256;
/// Of so many calls a way to end has to be known until it is believed of the others.
const CALLS_THAT_TELL: usize = 3;
/// How much of an answer is kept.
const KEPT_BYTES: usize = 16_000;

/// What a worker leaves.
pub(super) struct Report {
    pub(super) cases: Vec<Option<CaseRun>>,
    pub(super) notes: Vec<String>,
}

pub(super) struct Worker<'r> {
    shared: &'r Shared<'r>,
    process: Option<Process>,
    /// Cases to be run again, before new ones are taken.
    again: VecDeque<usize>,
    /// How processes were seen to end, again and again, on cases of a call.
    known: HashSet<(Call, String)>,
    spares: Spares,
    /// How many bytes the last batch of requests had.
    batch: usize,
    report: Report,
}

/// Processes that are started ahead of need: where a peer dies often, starting it is most of the time of a run.
struct Spares {
    starting: VecDeque<JoinHandle<Option<Process>>>,
    wanted: usize,
    /// Nobody waits for them any more.
    enough: Stop,
}

/// A process, and what is in flight to it.
struct Process {
    connection: Connection,
    /// Whether others were connected to the same server when it was opened.
    crowded: bool,
    /// By request id less one: the case, and whether it was answered.
    sent: Vec<(usize, bool)>,
    /// Everything before this is answered.
    low: usize,
    waiting: usize,
    waiting_bytes: usize,
    last_answered: Option<usize>,
    strays: usize,
    /// When a request or an answer last passed.
    progress: Instant,
    /// Until when a peer that no longer takes requests may go on.
    deaf_until: Option<Instant>,
}

/// What can go wrong with a process.
enum Fault {
    /// Its answers ended; how, is known once it is killed.
    Ended,
    /// It takes no more requests.
    Deaf,
    /// It was silent for too long.
    Silent(Duration),
    /// A line was no answer.
    Garbage { why: String, line: Vec<u8> },
    /// It answered again and again what was answered.
    Strays,
}

/// A fault of a process that is gone by now.
struct Post {
    fault: Fault,
    ending: Ending,
    log: String,
}

impl<'r> Worker<'r> {
    pub(super) fn new(shared: &'r Shared<'r>, connection: Option<Connection>) -> Self {
        let report = Report { cases: vec![None; shared.cases.len()], notes: Vec::new() };
        let process = connection.map(|connection| Process::new(connection, shared.is_crowded()));
        let spares = Spares::new(shared);
        Self { shared, process, again: VecDeque::new(), known: HashSet::new(), spares, batch: 0, report }
    }

    /// Runs cases until there are no more.
    pub(super) fn work(mut self) -> Report {
        while !self.shared.is_over() {
            if self.process.is_none() && self.again.is_empty() {
                match self.shared.take() {
                    Some(case) => self.again.push_back(case),
                    None if self.shared.may_leave() => break,
                    None => continue,
                }
            }
            self.look_for_life();
            let Some(mut process) = self.ready() else {
                if self.shared.give_back(self.again.drain(..)) {
                    break;
                }
                // The last one tries on, until the peer is given up.
                continue;
            };
            match self.pipeline(&mut process) {
                Ok(true) => {
                    self.finish(process);
                    if self.shared.may_leave() {
                        break;
                    }
                }
                Ok(false) => break,
                Err(fault) if process.crowded => {
                    if self.leave(process, fault) {
                        break;
                    }
                }
                Err(fault) => self.isolate(process, fault),
            }
        }
        self.report
    }

    /// The process, started anew if there is none. `None` when the peer is given up or the run is over.
    fn ready(&mut self) -> Option<Process> {
        if let Some(process) = self.process.take() {
            return Some(process);
        }
        if self.shared.faults.load(Ordering::Relaxed) >= SPARES_AFTER {
            let spare = self.spares.take(self.shared);
            if spare.is_some() {
                return spare;
            }
        }
        let mut refusal = None;
        for attempt in 0..STARTS {
            let again =
                Instant::now() + if attempt > 0 && self.shared.launch.is_shared() { RETURN } else { Duration::ZERO };
            while Instant::now() < again && !self.shared.is_over() {
                thread::sleep(TICK);
            }
            if self.shared.is_over() {
                return None;
            }
            let crowded = self.shared.is_crowded();
            let started = Connection::open(self.shared.launch).and_then(|mut connection| {
                handshake(&mut connection, self.shared.settings.start_timeout, self.shared.stop)?;
                Ok(Process::new(connection, crowded))
            });
            match started {
                Ok(process) => return Some(process),
                Err(StartError::Interrupted) => return None,
                // It may serve fewer connections at a time; those that it serves do the work.
                Err(error) if crowded => {
                    self.report.notes.push(format!("it served fewer connections than --jobs: {error}"));
                    return None;
                }
                Err(error) => {
                    let what = format!("could not be started again: {error}");
                    self.shared.count_fault(&what);
                    refusal = Some(what);
                }
            }
        }
        if let Some(what) = refusal.filter(|_| !self.shared.is_over()) {
            self.shared.give_up(format!("{STARTS} times it {what}"));
        }
        None
    }

    /// After a fault by the side of other connections to the same server: leaves it to the last one that is left to
    /// find out whose it is. Whether this is another one.
    fn leave(&mut self, process: Process, fault: Fault) -> bool {
        let waiting: Vec<usize> = process.waiting_cases().collect();
        self.shared.count_fault(&process.end(fault).what());
        self.shared.give_back(waiting.into_iter().chain(self.again.drain(..)))
    }

    /// Keeps requests in flight until all cases are answered (`true`) or the run is over (`false`).
    fn pipeline(&mut self, process: &mut Process) -> Result<bool, Fault> {
        loop {
            if self.shared.is_over() {
                return Ok(false);
            }
            self.fill(process, 0);
            if process.waiting == 0 {
                return Ok(true);
            }
            let event = process.connection.receive(TICK);
            if let Incoming::Lines(lines) = &event {
                // What comes next is sent before these are judged, so that the peer has work meanwhile.
                self.fill(process, lines.iter().filter(|byte| **byte == b'\n').count());
            }
            self.take_event(process, event)?;
        }
    }

    /// Once a quarter of the window is free, puts as many requests in flight as it allows. Of those that count as in
    /// flight, so many have an answer that is not looked at yet.
    fn fill(&mut self, process: &mut Process, arrived: usize) {
        let window = WINDOW + arrived.min(process.waiting);
        if process.waiting > window - WINDOW / 4 {
            return;
        }
        let mut lines = Vec::with_capacity(self.batch);
        while process.waiting < window && (process.waiting_bytes < WINDOW_BYTES || process.waiting == 0) {
            let Some(index) = self.again.pop_front().or_else(|| self.shared.take()) else {
                break;
            };
            let case = self.shared.cases[index];
            if process.waiting > 0 && process.waiting_bytes + case.request_bytes() > WINDOW_BYTES {
                self.again.push_front(index);
                break;
            }
            process.put(index, case, &mut lines);
        }
        // The next batch is about as large: its buffer does not have to grow.
        self.batch = lines.len();
        process.send(lines);
    }

    /// Deals with what came from the peer, or with that nothing came.
    fn take_event(&mut self, process: &mut Process, event: Incoming) -> Result<(), Fault> {
        match event {
            Incoming::Lines(lines) => self.take_lines(process, &lines),
            Incoming::Overlong(line) => {
                Err(Fault::Garbage { why: "a line is longer than any answer may be".to_owned(), line })
            }
            Incoming::Partial(line) => Err(Fault::Garbage { why: "its last line has no line feed".to_owned(), line }),
            Incoming::End => Err(Fault::Ended),
            Incoming::Deaf => {
                process.deaf_until.get_or_insert(Instant::now() + DEAF_GRACE);
                Ok(())
            }
            Incoming::Nothing => {
                let now = Instant::now();
                let patience = process.patience(self.shared.settings.timeout);
                if process.deaf_until.is_some_and(|until| now >= until) {
                    Err(Fault::Deaf)
                } else if process.waiting > 0 && now.duration_since(process.progress) >= patience {
                    Err(Fault::Silent(patience))
                } else {
                    Ok(())
                }
            }
        }
    }

    fn take_lines(&mut self, process: &mut Process, lines: &[u8]) -> Result<(), Fault> {
        let (mut answers, mut small, mut wrong) = (0, 0, 0);
        let mut result = Ok(());
        for line in lines.split_inclusive(|byte| *byte == b'\n') {
            match self.take_line(process, line.strip_suffix(b"\n").unwrap_or(line)) {
                Ok(Some((case, right))) => {
                    answers += 1;
                    small += u64::from(!case.is_large());
                    wrong += u64::from(!right);
                }
                Ok(None) => wrong += 1,
                Err(fault) => {
                    result = Err(fault);
                    break;
                }
            }
        }
        self.shared.count_answers(answers, small);
        self.shared.listener.on(Event::Judged { answers, wrong });
        result
    }

    /// Judges one line: its case, and whether it was right. `None` if that case was answered before.
    fn take_line(&mut self, process: &mut Process, line: &[u8]) -> Result<Option<(&'r Case, bool)>, Fault> {
        let garbage = |why: String| Fault::Garbage { why, line: line[..line.len().min(KEPT_BYTES)].to_vec() };
        let parsed = Reply::parse(line);
        let id = match &parsed {
            Ok(reply) => reply.id,
            Err(ReplyFault::Shape { id, .. }) => *id,
            Err(fault) => return Err(garbage(fault.to_string())),
        };
        let slot = id.checked_sub(1).and_then(|slot| usize::try_from(slot).ok());
        let Some((slot, (index, answered))) = slot.and_then(|slot| Some((slot, process.sent.get(slot).copied()?)))
        else {
            return Err(garbage(format!("it answers the request {id}, which is not in flight")));
        };
        let case = self.shared.cases[index];
        let shown = || Some(excerpt(line, KEPT_BYTES));
        if answered {
            let outcome = Outcome::Protocol { what: "answered the request twice".to_owned(), log: String::new() };
            self.record(index, CaseRun { outcome, answer: shown(), note: None });
            process.strays += 1;
            return if process.strays > MAX_STRAYS { Err(Fault::Strays) } else { Ok(None) };
        }
        process.answered(slot, case);
        self.shared.answered(index);
        let run = match parsed {
            Ok(reply) => match self.judged(case, &reply.answer) {
                Judgement::Pass { note } => CaseRun { outcome: Outcome::Pass, answer: None, note },
                Judgement::Unsupported { step } => {
                    let note = step.as_ref().map(|step| format!("it cannot do the step {step}"));
                    CaseRun { outcome: Outcome::Unsupported { step }, answer: None, note }
                }
                Judgement::Fail(differences) => {
                    CaseRun { outcome: Outcome::Fail(differences), answer: shown(), note: None }
                }
            },
            Err(fault) => {
                let outcome = Outcome::Protocol { what: format!("gave a faulty answer: {fault}"), log: String::new() };
                CaseRun { outcome, answer: shown(), note: None }
            }
        };
        let right = run.outcome == Outcome::Pass;
        self.record(index, run);
        Ok(Some((case, right)))
    }

    fn judged(&self, case: &Case, answer: &Answer<'_>) -> Judgement {
        self.shared.look_for_a_session(case, answer);
        judge(case, answer)
    }

    fn record(&mut self, index: usize, run: CaseRun) {
        self.shared.listener.on(Event::Recorded { case: &self.shared.cases[index].id, run: &run });
        if let Some(known) = self.report.cases.get_mut(index) {
            keep_worst(known, run);
        }
    }

    /// Lets a process end in peace once everything is answered, and takes note if it does not.
    fn finish(&mut self, mut process: Process) {
        process.connection.close_requests();
        let deadline = Instant::now() + END_GRACE;
        while Instant::now() < deadline && !self.shared.is_over() {
            let event = process.connection.receive(TICK);
            match self.take_event(&mut process, event) {
                Ok(()) => {}
                Err(Fault::Ended | Fault::Deaf) => break,
                Err(fault) => return self.finish_badly(process, fault),
            }
        }
        let patience = deadline.saturating_duration_since(Instant::now());
        self.report.notes.extend(process.connection.wait(patience).fault_in_peace(END_GRACE));
    }

    /// Finds out whether what a process printed when everything was answered belongs to the last answer.
    fn finish_badly(&mut self, process: Process, fault: Fault) {
        let (last, linger) = (process.last_answered, fault.linger());
        let post = process.end(fault);
        self.shared.count_fault(&post.what());
        match last.map(|case| (case, self.alone(case, linger))) {
            Some((case, Alone::Fault { post, .. })) => self.charge(case, &post, None),
            _ => self.report.notes.push(format!("at the end of its input it {}", post.what())),
        }
    }

    /// Ends a faulty process and finds the case that the fault belongs to: what was in flight is asked anew, one case
    /// at a time. A case that was the only one of its process is guilty at once, any other is tried once more.
    fn isolate(&mut self, process: Process, fault: Fault) {
        let last = process.last_answered;
        let mut waiting: VecDeque<usize> = process.waiting_cases().collect();
        let (silent, linger) = (matches!(fault, Fault::Silent(_)), fault.linger());
        let strays = matches!(fault, Fault::Strays);
        let only = waiting.len() == 1 && (silent || process.sent.len() == 1);
        let post = process.end(fault);
        self.shared.count_fault(&post.what());
        let Some(suspect) = waiting.front().copied().or(last) else {
            return;
        };
        if strays {
            // Their cases are known, and charged already.
            return self.again.extend(waiting);
        }
        if only {
            return self.charge(suspect, &post, None);
        }
        let (mut previous, mut found) = (None, false);
        while let Some(case) = waiting.pop_front() {
            self.look_for_life();
            match self.alone(case, Duration::ZERO) {
                Alone::Answered => previous = Some(case),
                Alone::Fault { post, fresh } => {
                    found |= self.blame(case, previous.take(), &post, fresh);
                }
                Alone::Over => {
                    if !found {
                        self.charge(suspect, &post, Some("it could not be tried alone"));
                    }
                    return;
                }
            }
        }
        if found {
            return self.go_carefully();
        }
        match last.filter(|_| !silent).map(|case| (case, self.alone(case, linger))) {
            Some((case, Alone::Fault { post, .. })) => self.charge(case, &post, None),
            _ => {
                let note = "it was the oldest request in flight; alone, in a fresh process, it was answered";
                self.charge(suspect, &post, Some(note));
            }
        }
    }

    /// Goes on one case at a time until the peer is calm: where crashes stand close together, each is then found by one
    /// death, and not by that of all that was in flight and its own.
    fn go_carefully(&mut self) {
        let (mut previous, mut calm) = (None, 0);
        while calm < CALM {
            let Some(case) = self.again.pop_front().or_else(|| self.shared.take()) else {
                return;
            };
            self.look_for_life();
            match self.alone(case, Duration::ZERO) {
                Alone::Answered => {
                    previous = Some(case);
                    calm += 1;
                }
                Alone::Fault { post, fresh } => {
                    self.blame(case, previous.take(), &post, fresh);
                    calm = 0;
                }
                Alone::Over => return self.again.push_front(case),
            }
        }
    }

    /// Charges the fault that came while a case was the only one in flight: to that case, or to the one before it, if
    /// that does it again. A way to end that is known of the call, or of several others, needs no second one. Whether
    /// it is certain.
    fn blame(&mut self, case: usize, previous: Option<usize>, post: &Post, fresh: bool) -> bool {
        let way = |case: usize, post: &Post| (self.shared.cases[case].call, post.what());
        if fresh || matches!(post.fault, Fault::Silent(_)) || self.is_known(&way(case, post)) {
            self.known.insert(way(case, post));
            self.charge(case, post, None);
            return true;
        }
        let mut note = "in a fresh process it did not happen again";
        for suspect in [Some(case), previous].into_iter().flatten() {
            match self.alone(suspect, if suspect == case { LINGER } else { post.fault.linger() }) {
                Alone::Fault { post, .. } => {
                    if suspect == case {
                        self.known.insert(way(case, &post));
                    }
                    self.charge(suspect, &post, None);
                    return true;
                }
                Alone::Answered => {}
                Alone::Over => note = "it could not be tried alone",
            }
        }
        self.charge(case, post, Some(note));
        false
    }

    fn is_known(&self, way: &(Call, String)) -> bool {
        let others = self.known.iter().filter(|(_, how)| *how == way.1).count();
        others >= CALLS_THAT_TELL || self.known.contains(way)
    }

    /// After faults without an answer between them: asks what the peer has answered before, or else a case of each
    /// call. If none is answered either, the peer is given up.
    fn look_for_life(&mut self) {
        if !self.shared.is_fruitless() {
            return;
        }
        let known = self.shared.first_answered.get().copied();
        let mut last_words = String::new();
        for case in known.map_or_else(|| self.shared.one_of_each_call(), |case| vec![case]) {
            match self.alone(case, Duration::ZERO) {
                Alone::Answered | Alone::Over => return,
                Alone::Fault { post, .. } => {
                    if known.is_none() {
                        self.charge(case, &post, None);
                    }
                    last_words = post.what();
                    if matches!(post.fault, Fault::Silent(_)) {
                        break;
                    }
                }
            }
        }
        let faults = self.shared.faults.load(Ordering::Relaxed);
        self.shared.give_up(match known {
            None => format!("it has not answered one case in {faults} attempts; at last it {last_words}"),
            Some(case) => {
                let case = &self.shared.cases[case].id;
                format!("it no longer answers what it has answered before, {case}: it {last_words}")
            }
        });
    }

    /// Runs one case with nothing else in flight.
    fn alone(&mut self, index: usize, linger: Duration) -> Alone {
        let Some(mut process) = self.ready() else {
            return Alone::Over;
        };
        let fresh = process.sent.is_empty();
        let mut lines = Vec::new();
        process.put(index, self.shared.cases[index], &mut lines);
        process.send(lines);
        let mut answered: Option<Instant> = None;
        let fault = loop {
            if self.shared.is_over() {
                return Alone::Over;
            }
            let event = process.connection.receive(TICK);
            if let Err(fault) = self.take_event(&mut process, event) {
                break fault;
            }
            if process.waiting == 0 && answered.get_or_insert_with(Instant::now).elapsed() >= linger {
                self.process = Some(process);
                return Alone::Answered;
            }
        };
        let post = process.end(fault);
        self.shared.count_fault(&post.what());
        Alone::Fault { post, fresh }
    }

    /// Charges a fault to a case.
    fn charge(&mut self, index: usize, post: &Post, note: Option<&str>) {
        let (what, log) = (post.what(), post.log.clone());
        let case = self.shared.cases[index];
        self.shared.listener.on(Event::Fault { case: &case.id, what: &what });
        let (outcome, answer) = match &post.fault {
            Fault::Ended | Fault::Deaf => (Outcome::Crash { what, log }, None),
            Fault::Silent(_) => (Outcome::Timeout { what, log }, None),
            Fault::Garbage { line, .. } => (Outcome::Protocol { what, log }, Some(excerpt(line, KEPT_BYTES))),
            Fault::Strays => (Outcome::Protocol { what, log }, None),
        };
        self.record(index, CaseRun { outcome, answer, note: note.map(str::to_owned) });
    }
}

/// Runs a case that crashes once more, with all backtraces; `None` if it does not crash again, or says nothing.
pub(super) fn crash_log(shared: &Shared<'_>, index: usize) -> Option<CrashLog> {
    if shared.launch.is_shared() {
        // Its log is not ours to read.
        return None;
    }
    let Settings { timeout, start_timeout, .. } = *shared.settings;
    let mut connection = Connection::open(&shared.launch.with_backtraces()).ok()?;
    handshake(&mut connection, start_timeout, shared.stop).ok()?;
    let mut process = Process::new(connection, false);
    let mut lines = Vec::new();
    process.put(index, shared.cases[index], &mut lines);
    process.send(lines);
    let deadline = Instant::now() + process.patience(timeout) + LINGER;
    while Instant::now() < deadline && !shared.stop.is_set() {
        if let Incoming::End = process.connection.receive(TICK) {
            process.connection.kill();
            let log = process.connection.whole_log();
            return (!log.is_empty()).then(|| CrashLog { case: shared.cases[index].id.clone(), log });
        }
    }
    None
}

impl Spares {
    fn new(shared: &Shared<'_>) -> Self {
        let (launch, jobs) = (shared.launch, shared.settings.jobs);
        let cores = thread::available_parallelism().map_or(1, usize::from);
        // Twice as many as can run at once, for a start is not work alone, and the machine may be busy.
        let wanted = (2 * cores / jobs.max(1)).clamp(1, MOST_SPARES);
        // Connecting is cheap, and a server with a fixed port cannot be there twice.
        let wanted = if launch.is_shared() || launch.is_single() { 0 } else { wanted };
        Self { starting: VecDeque::new(), wanted, enough: Stop::default() }
    }

    /// The process that was started first, once it has described itself. `None` if it did not: a peer that cannot be
    /// there twice, since it holds a port or a file, is from now on started when it is needed, and not before.
    fn take(&mut self, shared: &Shared<'_>) -> Option<Process> {
        while self.starting.len() <= self.wanted && self.wanted > 0 {
            let (launch, patience, enough) =
                (shared.launch.clone(), shared.settings.start_timeout, self.enough.clone());
            self.starting.push_back(thread::spawn(move || {
                let mut connection = Connection::open(&launch).ok()?;
                handshake(&mut connection, patience, &enough).ok()?;
                Some(Process::new(connection, false))
            }));
        }
        let first = self.starting.pop_front()?;
        while !first.is_finished() && !shared.is_over() {
            thread::sleep(Duration::from_millis(1));
        }
        if shared.is_over() {
            self.enough.set();
        }
        let spare = first.join().ok().flatten().and_then(|mut spare| spare.connection.is_alive().then_some(spare));
        if spare.is_none() {
            self.end();
        }
        spare
    }

    fn end(&mut self) {
        self.wanted = 0;
        self.enough.set();
        for started in self.starting.drain(..) {
            // What it started ends with it.
            drop(started.join());
        }
    }
}

impl Drop for Spares {
    fn drop(&mut self) {
        self.end();
    }
}

/// How a case went that ran alone.
enum Alone {
    /// It was answered and judged.
    Answered,
    /// The process failed; `fresh` if the case was its first.
    Fault { post: Post, fresh: bool },
    /// The run is over.
    Over,
}

impl Process {
    fn new(connection: Connection, crowded: bool) -> Self {
        Self {
            connection,
            crowded,
            sent: Vec::new(),
            low: 0,
            waiting: 0,
            waiting_bytes: 0,
            last_answered: None,
            strays: 0,
            progress: Instant::now(),
            deaf_until: None,
        }
    }

    /// Appends the request of a case to `lines`, or sends these and then the request if that is large, and counts it as
    /// in flight.
    fn put(&mut self, index: usize, case: &Case, lines: &mut Vec<u8>) {
        self.sent.push((index, false));
        let id = self.sent.len() as u64;
        self.connection.allow_line(ANSWER_BYTES + 8 * case.request_bytes());
        if case.is_large() {
            self.send(std::mem::take(lines));
            let write = case.writer();
            self.connection.send_large(move |out| {
                write!(out, "{{\"id\":{id},")?;
                write(out)?;
                out.write_all(b"\n")
            });
        } else {
            put_request(lines, id, |lines| case.put_body(lines));
        }
        if self.waiting == 0 {
            self.progress = Instant::now();
        }
        self.waiting += 1;
        self.waiting_bytes += case.request_bytes();
    }

    fn send(&self, lines: Vec<u8>) {
        if !lines.is_empty() {
            self.connection.send(lines);
        }
    }

    fn answered(&mut self, slot: usize, case: &Case) {
        if let Some((index, answered)) = self.sent.get_mut(slot) {
            *answered = true;
            self.last_answered = Some(*index);
        }
        self.waiting -= 1;
        self.waiting_bytes -= case.request_bytes();
        self.progress = Instant::now();
        while self.sent.get(self.low).is_some_and(|(_, answered)| *answered) {
            self.low += 1;
        }
    }

    /// The cases in flight, the oldest first.
    fn waiting_cases(&self) -> impl Iterator<Item = usize> {
        self.sent[self.low..].iter().filter(|(_, answered)| !answered).map(|(index, _)| *index)
    }

    fn patience(&self, timeout: Duration) -> Duration {
        patience(timeout, self.waiting_bytes)
    }

    fn end(mut self, fault: Fault) -> Post {
        let ending = self.connection.kill();
        Post { fault, ending, log: self.connection.log() }
    }
}

/// How long a peer may be silent: what was asked, and four seconds more for each MiB in flight, a minute at most.
/// A long trace is a few MiB of requests, of which each step takes its time, on a slow machine above all.
fn patience(timeout: Duration, bytes_in_flight: usize) -> Duration {
    timeout + Duration::from_secs((bytes_in_flight >> 18).min(60) as u64)
}

impl Fault {
    /// How long to listen, after the answer of a suspect that runs alone, for whether it happens again.
    fn linger(&self) -> Duration {
        if matches!(self, Self::Garbage { .. }) { LISTEN } else { LINGER }
    }
}

impl Post {
    /// What happened, in words that follow "it".
    fn what(&self) -> String {
        match &self.fault {
            Fault::Ended => self.ending.describe(),
            Fault::Deaf => match self.ending {
                Ending::Exited(_) | Ending::Disconnected(_) => self.ending.describe(),
                _ => "closed its standard input".to_owned(),
            },
            Fault::Silent(patience) => {
                format!("gave no answer within {} s", patience.as_secs_f64())
            }
            Fault::Garbage { why, .. } => format!("printed something that is no answer: {why}"),
            Fault::Strays => format!("answered more than {MAX_STRAYS} requests twice"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_peer_may_be_silent_four_seconds_longer_for_each_mebibyte_and_a_minute_at_most() {
        const MIB: usize = 1 << 20;
        let more_s = |bytes| (patience(Duration::from_secs(10), bytes) - Duration::from_secs(10)).as_secs();
        assert_eq!([0, 1_000, MIB, 5 * MIB].map(more_s), [0, 0, 4, 20]);
        assert_eq!([15 * MIB, 64 * MIB, usize::MAX].map(more_s), [60; 3]);
    }
}
