//! A peer under test: how it is found, started, spoken to and stopped.
//!
//! A peer is any program that speaks the protocol of `peers/PROTOCOL.md`, on its standard streams or as a server over
//! TCP or WebSocket. This room knows processes, connections and lines; it knows nothing of cases and verdicts.
//!
//! - [`Manifest`] reads a `peer.toml`; [`Launch`] is what it, a bare command or an [`Address`] comes down to.
//! - [`Connection`] is one conversation, whatever the road: bounded lines in, batched requests out, nothing that the
//!   peer does can block us.
//! - [`describe`](handshake) is the first exchange with every process.
//! - [`Reply`] is one line of its answers, taken apart.

mod address;
mod connection;
mod expected;
mod handshake;
mod manifest;
mod protocol;
mod socket;

pub use address::{Address, AddressError};
pub use connection::{Connection, Ending, Incoming};
pub use expected::{ExpectedFailure, ExpectedFailures};
pub use handshake::{Description, handshake};
pub use manifest::{Manifest, ManifestError, Setup};
pub(crate) use protocol::put_request;
pub use protocol::{Answer, Call, MAX_REQUEST_BYTES, Reply, ReplyFault, write_request};

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

/// How to come by a peer: a program to start, with its arguments and the folder to start it in; the address of a server
/// to connect to; or a program that is such a server.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Launch {
    /// Empty: nothing is started.
    argv: Vec<String>,
    /// None: the program is spoken to on its standard streams.
    address: Option<Address>,
    folder: PathBuf,
    backtraces: bool,
    patience: Duration,
}

/// How long a server that we start may take until it listens, unless it is told otherwise.
const PATIENCE: Duration = Duration::from_secs(30);
/// How long one that we do not start may take at most: it is there, or somebody starts it anew.
const RETURN: Duration = Duration::from_secs(5);

/// What makes runtimes write long logs when they crash, each with its values for a short one and for a whole one.
const BACKTRACES: [(&str, &str, &str); 5] = [
    ("RUST_BACKTRACE", "0", "1"),
    ("RUST_LIB_BACKTRACE", "0", "1"),
    ("GOTRACEBACK", "none", "all"),
    ("DOTNET_DbgEnableMiniDump", "0", "0"),
    ("PYTHONFAULTHANDLER", "", "1"),
];

/// Why a peer could not be started, or did not introduce itself. Ends in exit code 3.
#[derive(Debug, thiserror::Error)]
pub enum StartError {
    /// The command is empty, or its quotes do not match.
    #[error("the command {0:?} cannot be taken apart into a program and its arguments")]
    Command(String),
    /// There is no such program.
    #[error("there is no program `{program}`{}", if program.contains('/') { "" } else { " on PATH" })]
    NotFound {
        /// The program as it was named.
        program: String,
    },
    /// The program is there but may not be executed.
    #[error("`{program}` is not executable")]
    NotExecutable {
        /// The program as it was named.
        program: String,
    },
    /// The operating system refused for another reason.
    #[error("`{program}` cannot be started: {source}")]
    Spawn {
        /// The program as it was named.
        program: String,
        /// What the operating system said.
        source: std::io::Error,
    },
    /// There is no server where it should be.
    #[error("`{command}` cannot be reached: {why}{}{}", advice(command), last_words(stderr))]
    Unreachable {
        /// The address, or the command that starts the server.
        command: String,
        /// Why.
        why: String,
        /// The end of its log.
        stderr: String,
    },
    /// Where the server is to listen that is about to be started, another one does.
    #[error("something listens already at {address}")]
    Taken {
        /// The address.
        address: String,
    },
    /// No port is free for the server, or the name of its host means nothing.
    #[error("there is no free port for {address}: {source}")]
    NoPort {
        /// The address.
        address: String,
        /// What the operating system said.
        source: std::io::Error,
    },
    /// It ended before it answered `describe`.
    #[error("`{command}` {ending} before it answered `describe`{}", last_words(stderr))]
    Ended {
        /// The whole command.
        command: String,
        /// How it ended.
        ending: String,
        /// The end of its log.
        stderr: String,
    },
    /// It printed something that is no answer.
    #[error("`{command}` does not speak the peer protocol: {why}; its first line: {line}{}", last_words(stderr))]
    NotAnAnswer {
        /// The whole command.
        command: String,
        /// What is wrong with the line.
        why: String,
        /// The line, shortened.
        line: String,
        /// The end of its log.
        stderr: String,
    },
    /// It said nothing.
    #[error("`{command}` did not answer `describe` within {} s{}", waited.as_secs_f64(), last_words(stderr))]
    Silent {
        /// The whole command.
        command: String,
        /// How long it was given.
        waited: Duration,
        /// The end of its log.
        stderr: String,
    },
    /// It refused to describe itself, or the description lacks something.
    #[error("`{command}` answered `describe`, but {why}: {line}")]
    Description {
        /// The whole command.
        command: String,
        /// What is wrong with it.
        why: String,
        /// The line, shortened.
        line: String,
    },
    /// A command that has to run before the first start failed.
    #[error("its set-up failed: `{command}` {ending}{}", last_words(output))]
    Setup {
        /// The whole command.
        command: String,
        /// How it ended.
        ending: String,
        /// The end of what it printed.
        output: String,
    },
    /// Ctrl-C, while it was being started.
    #[error("interrupted before it answered")]
    Interrupted,
}

impl Launch {
    /// A program with its arguments, to be started in `folder`.
    #[must_use]
    pub fn new(argv: Vec<String>, folder: impl Into<PathBuf>) -> Self {
        Self { argv, address: None, folder: folder.into(), backtraces: false, patience: PATIENCE }
    }

    /// A server that is there, and that nobody starts for us.
    #[must_use]
    pub fn connect(address: Address) -> Self {
        Self { address: Some(address), ..Self::new(Vec::new(), "") }
    }

    /// The same program, spoken to at the address at which it listens. Each process serves one connection.
    #[must_use]
    pub fn listening_at(self, address: Address) -> Self {
        Self { address: Some(address), ..self }
    }

    /// The same, with this long until a server that we start listens.
    #[must_use]
    pub fn with_patience(self, patience: Duration) -> Self {
        Self { patience, ..self }
    }

    /// Takes a command line apart as a POSIX shell would, without running a shell.
    ///
    /// # Errors
    /// [`StartError::Command`] if it is empty or a quote is not closed.
    pub fn from_command_line(line: &str, folder: impl Into<PathBuf>) -> Result<Self, StartError> {
        match shlex::split(line) {
            Some(argv) if !argv.is_empty() => Ok(Self::new(argv, folder)),
            _ => Err(StartError::Command(line.to_owned())),
        }
    }

    /// The same, but a crash writes all that it can to the log.
    #[must_use]
    pub fn with_backtraces(&self) -> Self {
        Self { backtraces: true, ..self.clone() }
    }

    /// The command as a person would type it, or the address of a server that is not started.
    #[must_use]
    pub fn display(&self) -> String {
        if let Some(address) = self.address.as_ref().filter(|_| !self.has_command()) {
            return address.to_string();
        }
        shlex::try_join(self.argv.iter().map(String::as_str)).unwrap_or_else(|_| self.argv.join(" "))
    }

    /// The files that it names: the program, and each argument that is a file.
    #[must_use]
    pub fn files(&self) -> Vec<PathBuf> {
        let program = self.program();
        let on_path = || {
            let path = std::env::var_os("PATH").unwrap_or_default();
            std::env::split_paths(&path).map(|dir| dir.join(program)).find(|file| is_executable(file))
        };
        let program = if program.contains('/') { Some(self.folder.join(program)) } else { on_path() };
        let arguments = self.argv.iter().skip(1).map(|argument| self.folder.join(argument));
        program.into_iter().chain(arguments).filter(|file| file.is_file()).collect()
    }

    /// Whether all connections lead to one server, which is there whether we connect or not.
    #[must_use]
    pub fn is_shared(&self) -> bool {
        self.address.is_some() && !self.has_command()
    }

    /// Whether there can be only one connection at a time, since the server that is started for it has a fixed port.
    #[must_use]
    pub fn is_single(&self) -> bool {
        self.has_command() && self.address.as_ref().is_some_and(|address| !address.is_open())
    }

    /// The folder that it is started in.
    #[must_use]
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Whether we start it, and do not only connect to it.
    pub(crate) fn has_command(&self) -> bool {
        !self.argv.is_empty()
    }

    fn address(&self) -> Option<&Address> {
        self.address.as_ref()
    }

    fn until_it_listens(&self) -> Duration {
        // A little less than what there is until the first answer, so that the reason is told.
        let patience = self.patience * 9 / 10;
        if self.has_command() { patience } else { patience.min(RETURN) }
    }

    /// The same with a port that is free now, wherever `{port}` stands.
    fn placed(&self) -> Result<Self, StartError> {
        let Some(address) = self.address.as_ref().filter(|address| address.is_open()) else {
            return Ok(self.clone());
        };
        let no_port = |source| StartError::NoPort { address: address.to_string(), source };
        let address = address.placed().map_err(no_port)?;
        let argv = self.argv.iter().map(|word| word.replace(address::ANY_PORT, &address.port_text())).collect();
        Ok(Self { argv, address: Some(address), ..self.clone() })
    }

    fn program(&self) -> &str {
        self.argv.first().map_or("", String::as_str)
    }

    /// The command, in its folder and in a process group of its own, so that all of it can be ended at once.
    fn command(&self) -> Command {
        let program = self.program();
        // A relative path counts from the folder; what a bare name means, PATH decides.
        let program =
            if program.contains('/') { self.folder.join(program).into_os_string() } else { OsString::from(program) };
        let mut command = Command::new(program);
        command.args(self.argv.iter().skip(1)).current_dir(&self.folder);
        #[cfg(unix)]
        {
            use std::os::unix::process::CommandExt as _;
            command.process_group(0);
        }
        command
    }

    /// The command of a process that may crash many times.
    fn peer_command(&self) -> Command {
        let mut command = self.command();
        command.envs(BACKTRACES.map(|(name, short, whole)| (name, if self.backtraces { whole } else { short })));
        command
    }

    fn refused(&self, source: std::io::Error) -> StartError {
        let program = self.program().to_owned();
        match source.kind() {
            std::io::ErrorKind::NotFound => StartError::NotFound { program },
            std::io::ErrorKind::PermissionDenied => StartError::NotExecutable { program },
            _ => StartError::Spawn { program, source },
        }
    }
}

/// Whether a program can be started: an executable file on PATH, or at that path if the name is one.
#[must_use]
pub fn is_on_path(program: &str) -> bool {
    if program.contains('/') {
        return is_executable(Path::new(program));
    }
    std::env::var_os("PATH")
        .is_some_and(|path| std::env::split_paths(&path).any(|dir| is_executable(&dir.join(program))))
}

/// A line as it may be shown: readable, on one line, no longer than `most` characters.
#[must_use]
pub fn excerpt(bytes: &[u8], most: usize) -> String {
    let text = String::from_utf8_lossy(&bytes[..bytes.len().min(most * 4)]);
    let mut shown: String = text.chars().take(most).flat_map(visible).collect();
    if text.chars().nth(most).is_some() || bytes.len() > most * 4 {
        shown.push_str(&format!("… ({} bytes)", bytes.len()));
    }
    shown
}

/// A character, or its escape if it would do something to a terminal.
fn visible(c: char) -> impl Iterator<Item = char> {
    let (plain, escaped) =
        if c.is_control() || is_bidi(c) { (None, Some(c.escape_default())) } else { (Some(c), None) };
    plain.into_iter().chain(escaped.into_iter().flatten())
}

/// Characters that reorder the line that they stand in.
fn is_bidi(c: char) -> bool {
    matches!(c, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

#[cfg(unix)]
fn is_executable(path: &Path) -> bool {
    use std::os::unix::fs::PermissionsExt as _;
    path.metadata().is_ok_and(|meta| meta.is_file() && meta.permissions().mode() & 0o111 != 0)
}

#[cfg(not(unix))]
fn is_executable(path: &Path) -> bool {
    path.is_file() || path.with_extension("exe").is_file()
}

/// What to do about an address at which nobody is; nothing, if a command was to start the server.
fn advice(command: &str) -> &'static str {
    match Address::parse(command) {
        Ok(_) => "\nstart the server first, or let it be started: `command` beside `connect` in a peer.toml",
        Err(_) => "",
    }
}

fn last_words(log: &str) -> String {
    if log.trim().is_empty() { String::new() } else { format!("\nit had written to stderr:\n{}", indented(log)) }
}

fn indented(text: &str) -> String {
    text.trim_end().lines().map(|line| format!("  | {line}")).collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_command_line_is_split_as_a_shell_would() {
        let launch = Launch::from_command_line("python3 'my adapter.py' --x=\"a b\"", ".").unwrap();
        assert_eq!(launch.argv, ["python3", "my adapter.py", "--x=a b"]);
        assert_eq!(Launch::from_command_line(&launch.display(), ".").unwrap(), launch);
        for line in ["", "  ", "a 'b"] {
            assert!(matches!(Launch::from_command_line(line, "."), Err(StartError::Command(_))), "{line:?}");
        }
    }

    #[test]
    fn an_excerpt_is_short_and_does_nothing_to_a_terminal() {
        assert_eq!(excerpt(b"plain", 10), "plain");
        assert_eq!(excerpt(b"\x1b[31mred\n\0", 40), "\\u{1b}[31mred\\n\\u{0}");
        assert_eq!(excerpt(&[b'x'; 1000], 3), "xxx… (1000 bytes)");
        assert_eq!(excerpt(&[0xff, b'a'], 10), "\u{fffd}a");
    }

    #[test]
    fn a_program_that_is_nowhere_is_not_on_path() {
        assert!(is_on_path("sh"));
        assert!(!is_on_path("surely-no-such-program"));
        assert!(!is_on_path("src/lib.rs"), "not executable");
    }
}
