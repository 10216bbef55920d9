//! One conversation with a peer: with a process that was started for it, with a server, or with both.
//!
//! Three threads serve a connection, so that nothing a peer does can block the run: one writes requests, one
//! cuts answers into lines, one drains the log. A peer that does not read, prints without end or floods
//! its log costs bounded memory, and [`Connection::kill`] always ends it, the children of a process included.

use std::collections::VecDeque;
use std::io::{self, BufWriter, Read, Write};
use std::process::{Child, ChildStderr, ChildStdin, ExitStatus, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, SyncSender, channel, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use super::address::Framing;
use super::socket::{Fragments, Service, Socket, close_frame, frame, is_taken};
use super::{Launch, StartError, excerpt};

/// How much of the log is kept.
const LOG_BYTES: usize = 64 << 10;
/// How many lines of the log are shown.
const LOG_LINES: usize = 20;
/// Reads and writes go in pieces of this size: what a pipe holds on Linux.
pub(super) const PIECE: usize = 64 << 10;
/// How many batches of lines may wait for us before the peer has to wait.
const WAITING_BATCHES: usize = 16;
/// How long the exit status and the end of the log may take to arrive after the end of the answers.
const SETTLE: Duration = Duration::from_millis(300);
/// How much of an overlong line is kept, to be shown.
const OVERLONG_SHOWN: usize = 2 << 10;

/// What goes to the peer: whole lines, or whole frames.
pub(super) enum Outgoing {
    /// At hand.
    Bytes(Vec<u8>),
    /// Made while it is sent.
    Large(Large),
}

/// Writes them.
type Large = Box<dyn FnOnce(&mut dyn Write) -> io::Result<()> + Send>;

/// What came from the peer.
#[derive(Debug)]
pub enum Incoming {
    /// One or more whole lines, each with its line feed.
    Lines(Vec<u8>),
    /// The start of a line that is longer than an answer may be. Nothing more will be read.
    Overlong(Vec<u8>),
    /// The end of its answers, in the midst of a line. [`Incoming::End`] follows.
    Partial(Vec<u8>),
    /// The end of its answers.
    End,
    /// It no longer takes requests.
    Deaf,
    /// Nothing, in the time given.
    Nothing,
}

/// How a peer ended.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Ending {
    /// Its process, by itself.
    Exited(ExitStatus),
    /// Its process closed its standard output but kept running, until it was killed.
    ClosedOutput,
    /// The server closed the connection, or lost it, and why, if it said so.
    Disconnected(Option<String>),
    /// There never was a connection to the server, and why.
    Unreachable(String),
    /// Its process was still there, until it was killed.
    Killed,
    /// The connection to the server was still there, until it was dropped.
    Dropped,
}

/// A peer that is spoken to. Dropping it ends its process with all its children, and the connection to a server.
#[derive(Debug)]
pub struct Connection {
    /// The process that was started for it.
    child: Option<Child>,
    /// The connection to a server.
    server: Option<(Framing, Arc<Socket>)>,
    command: String,
    requests: Option<Sender<Outgoing>>,
    incoming: Receiver<Incoming>,
    unread: VecDeque<Incoming>,
    line_limit: Arc<AtomicUsize>,
    log: Arc<Mutex<VecDeque<u8>>>,
    log_done: Receiver<()>,
    ended: bool,
    ending: Option<Ending>,
}

impl Connection {
    /// Starts the process, or begins to connect to the server, or both.
    ///
    /// # Errors
    /// [`StartError`] if the operating system refuses. That a server is not there shows in the first answer.
    pub fn open(launch: &Launch) -> Result<Self, StartError> {
        let launch = launch.placed()?;
        let (requests, to_write) = channel();
        let (events, incoming) = sync_channel(WAITING_BATCHES);
        let (log_end, log_done) = channel();
        let mut connection = Self {
            child: None,
            server: None,
            command: launch.display(),
            requests: Some(requests.clone()),
            incoming,
            unread: VecDeque::new(),
            line_limit: Arc::new(AtomicUsize::new(1 << 20)),
            log: Arc::new(Mutex::new(VecDeque::new())),
            log_done,
            ended: false,
            ending: None,
        };
        if let Some(address) = launch.address().filter(|address| launch.has_command() && is_taken(address)) {
            return Err(StartError::Taken { address: address.to_string() });
        }
        let limit = Arc::clone(&connection.line_limit);
        if launch.has_command() {
            let mut command = launch.peer_command();
            let stream = || if launch.address().is_some() { Stdio::null() } else { Stdio::piped() };
            command.stdin(stream()).stdout(stream()).stderr(Stdio::piped());
            let child = command.spawn().map_err(|source| launch.refused(source))?;
            let child = connection.child.insert(child);
            let kept = Arc::clone(&connection.log);
            if let Some(stderr) = child.stderr.take() {
                thread::spawn(move || {
                    keep_log(stderr, &kept);
                    drop(log_end);
                });
            }
            if let (Some(stdin), Some(stdout)) = (child.stdin.take(), child.stdout.take()) {
                let deaf = events.clone();
                thread::spawn(move || write_requests(stdin, &to_write, &deaf));
                thread::spawn(move || read_lines(stdout, &limit, &events));
                return Ok(connection);
            }
        }
        if let Some(address) = launch.address().cloned() {
            connection.serve(Service {
                patience: launch.until_it_listens(),
                socket: Arc::new(Socket::default()),
                to_write,
                replies: requests,
                line_limit: limit,
                events,
                address,
            });
        }
        Ok(connection)
    }

    fn serve(&mut self, service: Service) {
        self.server = Some((service.address.framing, Arc::clone(&service.socket)));
        thread::spawn(move || service.serve());
    }

    /// The command that was started, or the address of the server.
    #[must_use]
    pub fn command(&self) -> &str {
        &self.command
    }

    /// Hands over whole request lines. Never blocks; the caller bounds what is in flight.
    pub fn send(&self, lines: Vec<u8>) {
        let Some(requests) = &self.requests else { return };
        // A writer that is gone has said so: `Incoming::Deaf`, or the end of a connection.
        if self.has_frames() {
            let lines = lines.split(|byte| *byte == b'\n').filter(|line| !line.is_empty());
            lines.for_each(|line| drop(requests.send(Outgoing::Bytes(frame(line)))));
        } else {
            let _ = requests.send(Outgoing::Bytes(lines));
        }
    }

    /// Hands over a request that is so large that it is made only while it is sent: a line that `write` writes.
    pub fn send_large(&self, write: impl FnOnce(&mut dyn Write) -> io::Result<()> + Send + 'static) {
        let Some(requests) = &self.requests else { return };
        let large: Large = if self.has_frames() {
            // The length of a frame stands at its start, so that the line goes in many.
            Box::new(|out| {
                let mut fragments = Fragments::new(out);
                write(&mut fragments)?;
                fragments.finish()
            })
        } else {
            Box::new(write)
        };
        let _ = requests.send(Outgoing::Large(large));
    }

    /// Allows answers of up to this many bytes. Only ever raised within one process.
    pub fn allow_line(&self, bytes: usize) {
        self.line_limit.fetch_max(bytes, Ordering::Relaxed);
    }

    /// The next event, waiting for it at most `patience`.
    pub fn receive(&mut self, patience: Duration) -> Incoming {
        if let Some(event) = self.unread.pop_front() {
            return event;
        }
        if self.ended {
            return Incoming::End;
        }
        let event = match self.incoming.recv_timeout(patience) {
            Ok(event) => event,
            Err(RecvTimeoutError::Disconnected) => Incoming::End,
            Err(RecvTimeoutError::Timeout) => match self.exited() {
                // It is gone, yet a child of its own may hold the pipe open: what has arrived by now is all.
                Some(status) => {
                    self.ending = Some(Ending::Exited(status));
                    self.incoming.recv_timeout(SETTLE).unwrap_or(Incoming::End)
                }
                _ => Incoming::Nothing,
            },
        };
        self.ended |= matches!(event, Incoming::End);
        event
    }

    /// Gives back lines that were received but not looked at.
    pub fn unread(&mut self, lines: Vec<u8>) {
        if !lines.is_empty() {
            self.unread.push_front(Incoming::Lines(lines));
        }
    }

    /// Whether its process, if it has one, is still running.
    pub fn is_alive(&mut self) -> bool {
        self.exited().is_none()
    }

    /// The most bytes of memory that the process has held, where the operating system tells.
    #[must_use]
    pub fn memory(&self) -> Option<u64> {
        let status = std::fs::read_to_string(format!("/proc/{}/status", self.child.as_ref()?.id())).ok()?;
        let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
        let kilobytes: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
        Some(kilobytes << 10)
    }

    /// Tells the peer that no more requests will come.
    pub fn close_requests(&mut self) {
        let requests = self.requests.take();
        if self.has_frames() {
            requests.map(|requests| requests.send(Outgoing::Bytes(close_frame())));
        }
    }

    /// Waits for the process to end by itself, or for the server to close the connection, then ends whatever is left.
    pub fn wait(&mut self, patience: Duration) -> Ending {
        if self.server.is_some() {
            let deadline = Instant::now() + patience;
            while !self.ended && Instant::now() < deadline {
                self.receive(deadline.saturating_duration_since(Instant::now()));
            }
        } else {
            self.wait_for_exit(patience);
        }
        self.end(false)
    }

    /// Ends at once the process and its children, and the connection to a server, unless they ended by themselves.
    pub fn kill(&mut self) -> Ending {
        // Its answers have ended, so most likely it is ending too: its own status says more than our signal.
        let is_ending = self.ended;
        self.end(is_ending)
    }

    fn end(&mut self, is_ending: bool) -> Ending {
        let unreachable = self.server.as_ref().and_then(|(_, socket)| socket.unreachable());
        if is_ending && unreachable.is_none() {
            self.wait_for_exit(SETTLE);
        }
        self.finish();
        self.requests = None;
        let closed = match (unreachable, self.ended, &self.server) {
            (Some(why), ..) => Ending::Unreachable(why),
            (_, true, None) => Ending::ClosedOutput,
            (_, true, Some((_, socket))) => Ending::Disconnected(socket.last_words()),
            (_, false, Some(_)) if self.child.is_none() => Ending::Dropped,
            (_, false, _) => Ending::Killed,
        };
        self.ending.get_or_insert(closed).clone()
    }

    /// The end of the process's log.
    #[must_use]
    pub fn log(&self) -> String {
        let text = self.whole_log();
        let lines: Vec<&str> = text.lines().collect();
        lines[lines.len().saturating_sub(LOG_LINES)..].join("\n")
    }

    /// All that is kept of the process's log, made harmless.
    #[must_use]
    pub fn whole_log(&self) -> String {
        // After a kill the log ends at once, unless a process that escaped still holds it.
        if self.child.is_some() {
            let _ = self.log_done.recv_timeout(SETTLE);
        }
        let bytes: Vec<u8> = self.log.lock().unwrap_or_else(PoisonError::into_inner).iter().copied().collect();
        let text = String::from_utf8_lossy(&bytes);
        text.lines().map(|line| excerpt(line.as_bytes(), 500)).collect::<Vec<_>>().join("\n")
    }

    /// Ends the process and says what it printed instead of an answer.
    pub(super) fn no_answer(&mut self, why: &str, line: &[u8]) -> StartError {
        self.kill();
        StartError::NotAnAnswer {
            command: self.command.clone(),
            why: why.to_owned(),
            line: excerpt(line, 200),
            stderr: self.log(),
        }
    }

    fn wait_for_exit(&mut self, patience: Duration) {
        let deadline = Instant::now() + patience;
        while self.ending.is_none() && self.child.is_some() {
            match self.exited() {
                Some(status) => self.ending = Some(Ending::Exited(status)),
                None if Instant::now() < deadline => thread::sleep(Duration::from_millis(2)),
                None => return,
            }
        }
    }

    /// How its process has ended, if it has.
    fn exited(&mut self) -> Option<ExitStatus> {
        self.child.as_mut().and_then(|child| child.try_wait().ok().flatten())
    }

    fn has_frames(&self) -> bool {
        matches!(self.server, Some((Framing::WebSocket, _)))
    }

    /// Ends what has not ended by itself.
    fn finish(&mut self) {
        if let Some((_, socket)) = &self.server {
            socket.close();
        }
        if let Some(child) = &mut self.child {
            end_group(child);
        }
    }
}

impl Drop for Connection {
    fn drop(&mut self) {
        self.finish();
    }
}

impl Ending {
    /// How it ended, in words that follow a name.
    #[must_use]
    pub fn describe(&self) -> String {
        match self {
            Self::Exited(status) => describe_status(*status),
            Self::ClosedOutput => "closed its standard output but kept running".to_owned(),
            Self::Disconnected(None) => "closed the connection".to_owned(),
            Self::Disconnected(Some(why)) => format!("closed the connection ({why})"),
            Self::Unreachable(why) => format!("cannot be reached ({why})"),
            Self::Killed => "had to be killed".to_owned(),
            Self::Dropped => "kept the connection open".to_owned(),
        }
    }

    /// What is wrong with it as an end in peace, `waited` after the end of the requests, in words that follow "it".
    #[must_use]
    pub fn fault_in_peace(&self, waited: Duration) -> Option<String> {
        let seconds = waited.as_secs();
        match self {
            Self::Exited(status) if status.success() => None,
            Self::Disconnected(_) => None,
            Self::Exited(_) | Self::Unreachable(_) => {
                Some(format!("at the end of its input it {} instead of 0", self.describe()))
            }
            Self::ClosedOutput | Self::Killed => {
                Some(format!("{seconds} s after the end of its input it was still running, and was killed"))
            }
            Self::Dropped => {
                Some(format!("{seconds} s after the end of the requests it had not closed the connection"))
            }
        }
    }
}

/// How a process ended, in words that follow a name.
pub(super) fn describe_status(status: ExitStatus) -> String {
    match status.code() {
        Some(code) => format!("exited with status {code}"),
        None => format!("died of {status}"),
    }
}

/// Ends a process, and everything that it started and that has not left its group.
pub(super) fn end_group(child: &mut Child) {
    #[cfg(unix)]
    if let Some(group) = i32::try_from(child.id()).ok().and_then(rustix::process::Pid::from_raw) {
        // Nothing to do if the group is already gone.
        let _ = rustix::process::kill_process_group(group, rustix::process::Signal::KILL);
    }
    let _ = child.kill();
    let _ = child.wait();
}

fn write_requests(mut stdin: ChildStdin, requests: &Receiver<Outgoing>, events: &SyncSender<Incoming>) {
    for outgoing in requests {
        if outgoing.write_to(&mut stdin).is_err() {
            // The receiver may be gone already; then nobody needs to know.
            let _ = events.send(Incoming::Deaf);
            return;
        }
    }
}

impl Outgoing {
    pub(super) fn write_to(self, out: &mut impl Write) -> io::Result<()> {
        match self {
            Self::Bytes(bytes) => out.write_all(&bytes),
            Self::Large(write) => {
                let mut out = BufWriter::with_capacity(PIECE, out);
                write(&mut out)?;
                out.flush()
            }
        }
    }
}

pub(super) fn read_lines(mut stdout: impl Read, limit: &AtomicUsize, events: &SyncSender<Incoming>) {
    let mut piece = vec![0; PIECE];
    let mut buffer: Vec<u8> = Vec::new();
    loop {
        let start = buffer.len();
        match stdout.read(&mut piece) {
            Ok(0) => break,
            Ok(count) => buffer.extend_from_slice(&piece[..count]),
            Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
            Err(_) => break,
        }
        let Some(last) = buffer[start..].iter().rposition(|byte| *byte == b'\n') else {
            if buffer.len() > limit.load(Ordering::Relaxed) {
                buffer.truncate(OVERLONG_SHOWN);
                let _ = events.send(Incoming::Overlong(buffer));
                return;
            }
            continue;
        };
        let rest = buffer.split_off(start + last + 1);
        if events.send(Incoming::Lines(std::mem::replace(&mut buffer, rest))).is_err() {
            return;
        }
    }
    if !buffer.is_empty() && events.send(Incoming::Partial(buffer)).is_err() {
        return;
    }
    let _ = events.send(Incoming::End);
}

fn keep_log(mut stderr: ChildStderr, log: &Mutex<VecDeque<u8>>) {
    let mut piece = [0; 8 << 10];
    loop {
        let count = match stderr.read(&mut piece) {
            Ok(0) => return,
            Ok(count) => count,
            Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
            Err(_) => return,
        };
        let mut kept = log.lock().unwrap_or_else(PoisonError::into_inner);
        kept.extend(&piece[..count]);
        let surplus = kept.len().saturating_sub(LOG_BYTES);
        kept.drain(..surplus);
    }
}

#[cfg(unix)]
#[cfg(test)]
mod tests {
    use super::*;

    fn shell(script: &str) -> Connection {
        Connection::open(&Launch::new(vec!["sh".into(), "-c".into(), script.into()], ".")).unwrap()
    }

    fn next(connection: &mut Connection) -> Incoming {
        let deadline = Instant::now() + Duration::from_secs(20);
        loop {
            match connection.receive(Duration::from_millis(50)) {
                Incoming::Nothing if Instant::now() < deadline => {}
                event => return event,
            }
        }
    }

    fn lines(connection: &mut Connection) -> String {
        match next(connection) {
            Incoming::Lines(lines) => String::from_utf8(lines).unwrap(),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn what_is_sent_comes_back_and_the_end_is_seen() {
        let mut connection = shell("cat");
        connection.send(b"one\ntwo\n".to_vec());
        assert_eq!(lines(&mut connection), "one\ntwo\n");
        connection.close_requests();
        assert!(matches!(next(&mut connection), Incoming::End));
        assert_eq!(connection.wait(Duration::from_secs(5)).describe(), "exited with status 0");
    }

    #[test]
    fn a_line_without_end_is_cut_off_at_the_limit() {
        let mut connection = shell("exec cat /dev/zero");
        let Incoming::Overlong(start) = next(&mut connection) else { panic!("no overlong line") };
        assert_eq!(start.len(), OVERLONG_SHOWN);
        assert_eq!(connection.kill(), Ending::Killed);
    }

    #[test]
    fn a_process_that_closes_its_output_is_ended_and_named() {
        let mut connection = shell("exec >&-; sleep 60");
        assert!(matches!(next(&mut connection), Incoming::End));
        assert_eq!(connection.kill(), Ending::ClosedOutput);
    }

    #[test]
    fn a_child_that_keeps_the_pipe_open_does_not_hide_the_death_of_its_parent() {
        let mut connection = shell("sleep 60 & exit 3");
        let start = Instant::now();
        assert!(matches!(next(&mut connection), Incoming::End));
        assert!(start.elapsed() < Duration::from_secs(10));
        assert_eq!(connection.kill().describe(), "exited with status 3");
    }

    #[test]
    fn the_end_of_a_flooded_log_is_kept() {
        let mut connection =
            shell("i=0; while [ $i -lt 3000 ]; do echo \"line $i of the log\" >&2; i=$((i+1)); done; kill -9 $$");
        assert!(matches!(next(&mut connection), Incoming::End));
        assert!(connection.kill().describe().contains("SIGKILL"));
        let log = connection.log();
        assert!(log.ends_with("line 2999 of the log"), "{log}");
        assert_eq!(log.lines().count(), LOG_LINES);
    }

    #[test]
    fn dropping_a_connection_ends_the_children_of_its_process() {
        let mut connection = shell("trap '' TERM; sleep 60 & echo $!; wait");
        let pid: i32 = lines(&mut connection).trim().parse().unwrap();
        let pid = rustix::process::Pid::from_raw(pid).unwrap();
        assert!(rustix::process::test_kill_process(pid).is_ok());
        drop(connection);
        let deadline = Instant::now() + Duration::from_secs(5);
        // An orphan is a zombie until its new parent has taken note.
        let gone = || {
            std::fs::read_to_string(format!("/proc/{}/stat", pid.as_raw_nonzero()))
                .map_or(true, |stat| stat.contains(") Z "))
        };
        while !gone() && Instant::now() < deadline {
            thread::sleep(Duration::from_millis(5));
        }
        assert!(gone());
    }

    #[test]
    fn a_peer_that_stops_reading_does_not_block_the_sender() {
        let mut connection = shell("exec <&-; sleep 0.2; echo answered; sleep 60");
        connection.send(vec![b'x'; 8 << 20]);
        let mut seen = Vec::new();
        while seen.len() < 2 {
            match next(&mut connection) {
                Incoming::Deaf => seen.push("deaf"),
                Incoming::Lines(_) => seen.push("answered"),
                other => panic!("{other:?}"),
            }
        }
        assert!(seen.contains(&"deaf") && seen.contains(&"answered"));
    }
}
