//! Each case of the NCP conformance suite as a test of `cargo test`, judged in the process of the test.
//!
//! A test target without Rust's own harness holds an implementation against the suite:
//!
//! ```toml
//! [dev-dependencies]
//! ncp-harness = { path = "…/packages/cargo" }
//!
//! [[test]]
//! name = "conformance"
//! harness = false
//! ```
//!
//! ```no_run
//! use std::process::ExitCode;
//!
//! use ncp_harness::adapter::reply::Description;
//! use ncp_harness::adapter::{CallError, Peer, args};
//! use ncp_harness::{Conformance, Level};
//!
//! struct FlightStack;
//!
//! impl Peer for FlightStack {
//!     type Error = CallError;
//!
//!     fn describe(&self) -> Result<Description<'_>, CallError> {
//!         Ok(Description {
//!             name: "flight-stack".into(),
//!             version: "3.1.0".into(),
//!             language: "Rust".into(),
//!             wire_version: "0.5".into(),
//!             contract_hash: "2cf0763ad61e4f1c".into(),
//!             roles: vec!["body".into()],
//!             reference_networks: false,
//!         })
//!     }
//!
//!     fn version_check(&self, args: &args::VersionCheck<'_>) -> Result<bool, CallError> {
//!         Ok(args.version == "0.5")
//!     }
//! }
//!
//! fn main() -> ExitCode {
//!     Conformance::of(FlightStack).level(Level::Safety).expected("known.toml").run()
//! }
//! ```
//!
//! A test is named after its case, so that `cargo test --test conformance wire/members` runs those of a file, and
//! `ncp-verify explain` says more of one. `describe` stands before them and `verdict` behind them: it fails as
//! `ncp-verify` does, so also by an expected failure that no longer fails. `--list`, `--exact`, `--skip` and
//! `--test-threads` are those of every Rust test. The cases are asked in one run, when the first test wants to know;
//! without `verdict` only those that are selected.
//!
//! | the case | the test |
//! |---|---|
//! | failed, crash, timeout, unexpected pass, not run | failed, with what `ncp-verify` prints of it |
//! | unsupported | ignored; `verdict` fails |
//! | expected failure, advice | passed |
//! | of a role that the peer does not claim | no test |
//!
//! [`Conformance::of`] answers in threads of the test. What such a thread cannot survive, such as a stack that
//! overflows or a call that aborts, ends the test; a program of its own, by [`Conformance::command`], only costs the
//! case.

#![forbid(unsafe_code)]

mod service;
mod session;

use std::io;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;
use std::time::Duration;

use libtest_mimic::Arguments;
use ncp_adapter::Peer;
use ncp_verifier::peer::{Address, AddressError, Launch, ManifestError, StartError};
use ncp_verifier::suite::SuiteError;
use ncp_verifier::verdict::BaselineError;

pub use ncp_adapter as adapter;
pub use ncp_text::catalogue::Level;
pub use service::{Input, Output};

use service::{Conversation, serve};
use session::Session;

/// What `cargo test` exits with when tests fail, and so when there can be none.
const FAILED: u8 = 101;

/// A peer that is to be checked, and by what.
#[must_use = "nothing is checked until it runs"]
pub struct Conformance {
    peer: Tested,
    level: Level,
    filters: Vec<String>,
    expected: Option<PathBuf>,
    vectors: Option<PathBuf>,
    deep: bool,
    jobs: usize,
    timeout: Duration,
}

/// How the peer is reached.
enum Tested {
    /// In threads of this process.
    Here(Arc<Conversation>),
    /// By a command line.
    Command(String),
    /// Where it listens.
    Connect(String),
}

/// Why there are no tests.
#[derive(Debug, thiserror::Error)]
enum HarnessError {
    #[error(transparent)]
    Suite(#[from] SuiteError),
    #[error(transparent)]
    Start(#[from] StartError),
    #[error(transparent)]
    Address(#[from] AddressError),
    #[error("the list of expected failures: {0}")]
    Expected(#[from] ManifestError),
    #[error("the list of expected failures: {0}")]
    Baseline(#[from] BaselineError),
    #[error("no address of this machine can be listened at: {0}")]
    Listen(#[source] io::Error),
    #[error("the current folder is not known: {0}")]
    Here(#[source] io::Error),
    #[error("no case is selected for {0}: it claims no role of the text, or the filter fits nothing")]
    Nothing(String),
}

impl Conformance {
    /// An implementation behind the calls of the adapter's skeleton, answered in this process.
    pub fn of(peer: impl Peer + Send + Sync + 'static) -> Self {
        Self::conversation(move |input, output| ncp_adapter::hold(&peer, input, output))
    }

    /// An implementation that holds the conversation of `peers/PROTOCOL.md` itself, in this process: it reads requests
    /// until the input ends. It is called once a connection, each in a thread of its own.
    pub fn conversation(hold: impl Fn(Input, Output) -> io::Result<()> + Send + Sync + 'static) -> Self {
        Self::new(Tested::Here(Arc::new(hold)))
    }

    /// A program that speaks the protocol on its standard streams, by a command line with quotes as in a shell.
    pub fn command(line: impl Into<String>) -> Self {
        Self::new(Tested::Command(line.into()))
    }

    /// A peer that listens at `tcp://HOST:PORT` or `ws://HOST:PORT/PATH`.
    pub fn connect(address: impl Into<String>) -> Self {
        Self::new(Tested::Connect(address.into()))
    }

    fn new(peer: Tested) -> Self {
        Self {
            peer,
            level: Level::Wire,
            filters: Vec::new(),
            expected: None,
            vectors: None,
            deep: false,
            jobs: 1,
            timeout: Duration::from_secs(10),
        }
    }

    /// Holds it to this level, and those below; without this, to `wire`.
    pub fn level(self, level: Level) -> Self {
        Self { level, ..self }
    }

    /// Asks only the cases whose id, rule, flag or call this fits; more than once: any of them. As `--filter` of the
    /// program, and so a pass is no conformance.
    pub fn filter(mut self, pattern: impl Into<String>) -> Self {
        self.filters.push(pattern.into());
        self
    }

    /// Excuses the failures that this file lists, in the form of `ncp-verify run --write-expected`.
    pub fn expected(self, file: impl AsRef<Path>) -> Self {
        Self { expected: Some(file.as_ref().to_owned()), ..self }
    }

    /// Asks the cases of the deep set as well.
    pub fn deep(self) -> Self {
        Self { deep: true, ..self }
    }

    /// Asks the vectors of a folder in the place of those that are built in.
    pub fn vectors(self, folder: impl AsRef<Path>) -> Self {
        Self { vectors: Some(folder.as_ref().to_owned()), ..self }
    }

    /// Speaks to this many of it side by side; without this, to one.
    pub fn jobs(self, jobs: usize) -> Self {
        Self { jobs, ..self }
    }

    /// Lets it be silent for this long while a request is in flight; without this, 10 seconds.
    pub fn timeout(self, timeout: Duration) -> Self {
        Self { timeout, ..self }
    }

    /// Runs the tests that the command line of this process asks for, and says how: the whole `main` of a test target.
    #[must_use = "the exit code is how cargo learns of failures"]
    pub fn run(self) -> ExitCode {
        let args = Arguments::from_args();
        match Session::begin(self) {
            Ok(session) => {
                let session = Arc::new(session);
                let tests = session::tests(&session, &args);
                libtest_mimic::run(&args, tests).exit_code()
            }
            Err(error) => {
                eprintln!("error: {error}");
                ExitCode::from(FAILED)
            }
        }
    }
}

impl Tested {
    /// How it is reached, and what it is called in reports.
    fn launch(self) -> Result<(Launch, String), HarnessError> {
        match self {
            Self::Here(conversation) => {
                let address = serve(conversation).map_err(HarnessError::Listen)?;
                Ok((Launch::connect(Address::parse(&format!("tcp://{address}"))?), "in this process".to_owned()))
            }
            Self::Command(line) => {
                let here = std::env::current_dir().map_err(HarnessError::Here)?;
                Ok((Launch::from_command_line(&line, here)?, line))
            }
            Self::Connect(address) => Ok((Launch::connect(Address::parse(&address)?), address)),
        }
    }
}
