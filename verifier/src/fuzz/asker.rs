//! One peer that is asked many things: requests in flight, and what becomes of each, faults included.

use std::collections::HashMap;
use std::time::{Duration, Instant};

use crate::peer::{Connection, Incoming, Launch, Reply, ReplyFault, StartError, excerpt, handshake, write_request};
use crate::stop::Stop;

/// How many bytes of requests may be in flight.
const WINDOW_BYTES: usize = 1 << 20;
/// How long an answer may be, beside what its request explains ([`longest_answer`]).
const ANSWER_BYTES: usize = 16 << 20;
/// How long any answer may be.
const LONGEST_ANSWER: usize = 512 << 20;
/// How often we look up from waiting.
const TICK: Duration = Duration::from_millis(20);
/// How long a process may take to end after the end of its input.
const END_GRACE: Duration = Duration::from_secs(3);
/// How often in a row a process may fail to start.
const STARTS: usize = 3;
/// How much of a log is kept.
const LOG_CHARS: usize = 2000;

/// By what a peer is asked.
#[derive(Debug, Clone)]
pub(crate) struct Patience {
    /// How long it may be silent while a request is in flight.
    pub(crate) silence: Duration,
    /// How long until its first answer.
    pub(crate) start: Duration,
    /// How many bytes of memory it may hold.
    pub(crate) memory: u64,
}

/// What a peer said to one request.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Said {
    /// A line, which is an answer.
    Line(Vec<u8>),
    /// It broke off.
    Fault(Fault),
    /// Nothing, since the run is over.
    Nothing,
}

/// How a peer breaks off.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    /// In a word: `crash`, `hang`, `memory` or `protocol`.
    pub kind: &'static str,
    /// What was seen.
    pub what: String,
    /// The end of its log.
    pub log: String,
}

/// A peer, started as often as it takes.
#[derive(Debug)]
pub(crate) struct Asker<'a> {
    launch: &'a Launch,
    patience: Patience,
    stop: &'a Stop,
    connection: Option<Connection>,
    next: u64,
    /// How many processes ended in a fault.
    pub(crate) faults: usize,
}

/// What one process left of the requests that it was given.
struct Batch {
    said: HashMap<u64, Said>,
    fault: Option<Fault>,
}

impl<'a> Asker<'a> {
    pub(crate) fn new(launch: &'a Launch, patience: Patience, stop: &'a Stop, first: Option<Connection>) -> Self {
        Self { launch, patience, stop, connection: first, next: 1, faults: 0 }
    }

    /// Asks everything. The answers come in the order of the requests.
    ///
    /// # Errors
    /// The process can no longer be started.
    pub(crate) fn ask_all(&mut self, bodies: &[String]) -> Result<Vec<Said>, StartError> {
        self.begin(bodies)?.finish(self, bodies)
    }

    /// Asks one thing.
    ///
    /// # Errors
    /// The process can no longer be started.
    pub(crate) fn ask(&mut self, body: &str) -> Result<Said, StartError> {
        let said = self.ask_all(std::slice::from_ref(&body.to_owned()))?;
        Ok(said.into_iter().next().unwrap_or(Said::Nothing))
    }

    /// Sends the requests, as many as may be in flight, so that something else can be done meanwhile.
    ///
    /// # Errors
    /// The process can no longer be started.
    pub(crate) fn begin(&mut self, bodies: &[String]) -> Result<Flight, StartError> {
        self.ready()?;
        let mut flight = Flight { first: self.next, sent: 0 };
        flight.send_more(self, bodies);
        Ok(flight)
    }

    /// Lets the process end by itself at the end of its input, so that what it writes at its end is written.
    pub(crate) fn end_in_peace(&mut self) {
        if let Some(mut connection) = self.connection.take().filter(|_| !self.stop.is_set()) {
            connection.close_requests();
            connection.wait(END_GRACE);
        }
    }

    fn ready(&mut self) -> Result<(), StartError> {
        let mut last = None;
        for _ in 0..STARTS {
            if self.connection.is_some() {
                return Ok(());
            }
            let started = Connection::open(self.launch).and_then(|mut connection| {
                handshake(&mut connection, self.patience.start, self.stop)?;
                Ok(connection)
            });
            match started {
                Ok(connection) => {
                    self.connection = Some(connection);
                    self.next = 1;
                }
                Err(StartError::Interrupted) => return Err(StartError::Interrupted),
                Err(error) => last = Some(error),
            }
        }
        match (self.connection.is_some(), last) {
            (false, Some(error)) => Err(error),
            _ => Ok(()),
        }
    }

    /// Ends the process, and says what that was.
    fn end(&mut self, kind: &'static str, what: impl FnOnce(String) -> String) -> Fault {
        self.faults += 1;
        let Some(mut connection) = self.connection.take() else {
            return Fault { kind, what: what(String::new()), log: String::new() };
        };
        let ending = connection.kill().describe();
        Fault { kind, what: what(ending), log: excerpt(connection.log().as_bytes(), LOG_CHARS) }
    }

    /// How many bytes the process holds at most, if it is more than it may.
    fn excess(&self) -> Option<u64> {
        self.connection.as_ref().and_then(Connection::memory).filter(|bytes| *bytes > self.patience.memory)
    }
}

/// Requests on their way.
#[derive(Debug)]
pub(crate) struct Flight {
    first: u64,
    sent: usize,
}

impl Flight {
    /// Sends what fits into the window.
    fn send_more(&mut self, asker: &mut Asker<'_>, bodies: &[String]) {
        let Some(connection) = asker.connection.as_ref() else { return };
        let (mut lines, mut bytes) = (Vec::new(), 0);
        while let Some(body) = bodies.get(self.sent) {
            if bytes > 0 && bytes + body.len() > WINDOW_BYTES {
                break;
            }
            bytes += body.len();
            connection.allow_line(longest_answer(body));
            write_request(&mut lines, asker.next, body);
            asker.next += 1;
            self.sent += 1;
        }
        if !lines.is_empty() {
            connection.send(lines);
        }
    }

    /// Waits for all answers. What a fault leaves unanswered is asked one at a time, so that the fault finds its cause.
    ///
    /// # Errors
    /// The process can no longer be started.
    pub(crate) fn finish(mut self, asker: &mut Asker<'_>, bodies: &[String]) -> Result<Vec<Said>, StartError> {
        let mut batch = Batch { said: HashMap::new(), fault: None };
        while batch.fault.is_none() && !asker.stop.is_set() {
            if batch.said.len() >= self.sent {
                if self.sent >= bodies.len() {
                    break;
                }
                self.send_more(asker, bodies);
            }
            batch.fault = wait(asker, self.first, self.sent, &mut batch.said);
        }
        if batch.fault.is_none()
            && let Some(bytes) = asker.excess()
        {
            batch.fault = Some(asker.end("memory", |_| in_words(bytes)));
            // Which one it was, is found by asking each of a process of its own.
            batch.said.clear();
        }
        let mut answers: Vec<Said> = (0..bodies.len())
            .map(|nth| batch.said.remove(&(self.first + nth as u64)).unwrap_or(Said::Nothing))
            .collect();
        if let Some(fault) = batch.fault {
            if bodies.len() == 1 {
                return Ok(vec![Said::Fault(fault)]);
            }
            for (nth, answer) in answers.iter_mut().enumerate().filter(|(_, answer)| **answer == Said::Nothing) {
                if asker.stop.is_set() {
                    break;
                }
                if fault.kind == "memory" {
                    asker.connection = None;
                }
                *answer = asker.ask(&bodies[nth])?;
            }
        }
        Ok(answers)
    }
}

/// How many bytes the answer to a request may have: each time that a plant is asked it may answer with its command.
fn longest_answer(body: &str) -> usize {
    let asked = body.matches(r#""op":"active""#).count();
    ANSWER_BYTES.saturating_add(body.len().saturating_mul(8 + asked)).min(LONGEST_ANSWER)
}

fn in_words(bytes: u64) -> String {
    format!("held {} MiB of memory", bytes >> 20)
}

/// Takes the next event; a fault ends the process.
fn wait(asker: &mut Asker<'_>, first: u64, sent: usize, said: &mut HashMap<u64, Said>) -> Option<Fault> {
    let started = Instant::now();
    loop {
        let connection = asker.connection.as_mut()?;
        match connection.receive(TICK) {
            Incoming::Lines(lines) => {
                for line in lines.split(|byte| *byte == b'\n').filter(|line| !line.is_empty()) {
                    let id = match Reply::parse(line) {
                        Ok(reply) => reply.id,
                        Err(ReplyFault::Shape { id, .. }) => id,
                        Err(fault) => {
                            let shown = excerpt(line, 200);
                            return Some(asker.end("protocol", |_| format!("printed {shown}: {fault}")));
                        }
                    };
                    let is_ours = id >= first && id < first + sent as u64;
                    if !is_ours || said.insert(id, Said::Line(line.to_vec())).is_some() {
                        return Some(
                            asker.end("protocol", |_| format!("answered the request {id}, which does not wait")),
                        );
                    }
                }
                return None;
            }
            Incoming::End => return Some(asker.end("crash", |ending| ending)),
            Incoming::Overlong(_) => return Some(asker.end("protocol", |_| "printed a line without end".to_owned())),
            Incoming::Partial(_) | Incoming::Deaf => {}
            Incoming::Nothing if asker.stop.is_set() => return None,
            Incoming::Nothing if started.elapsed() >= asker.patience.silence => {
                let seconds = asker.patience.silence.as_secs_f64();
                return Some(asker.end("hang", |_| format!("was silent for {seconds} s")));
            }
            Incoming::Nothing => {
                if let Some(bytes) = asker.excess() {
                    return Some(asker.end("memory", |_| in_words(bytes)));
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_answer_may_have_the_command_of_a_request_as_often_as_it_is_asked_for() {
        let command = "x".repeat(300_000);
        let ask = r#"{"op":"active","now_s":1.0},"#;
        let body = format!("{command}{}", ask.repeat(100));
        assert!(longest_answer(&body) > 100 * command.len());
        assert!(longest_answer("{}") < 17 << 20);
        assert_eq!(longest_answer(&format!("{command}{}", ask.repeat(10_000))), LONGEST_ANSWER);
    }
}
