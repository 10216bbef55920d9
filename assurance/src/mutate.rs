//! Changes of the sources: who notices them.
//!
//! | module | what it does |
//! |---|---|
//! | `kernel` | changes one token of the kernel at a time, and holds each changed kernel against the properties |
//! | `hostile` | holds the kernels of the hostile auditor against the properties, and against the theorem's tie |
//! | `copies` | copies of the kernel with a change each, and what the engines of the proofs say of them |
//! | `spec` | has cargo-mutants change the specification, and holds each mutant against the cases and the tests |
//! | `cargo` | reads what cargo prints for programs |

mod cargo;
mod copies;
pub(crate) mod hostile;
pub(crate) mod kernel;
pub(crate) mod spec;

use std::io;
use std::path::PathBuf;

use clap::Subcommand;
use ncp_defects::{PlaceError, TableError};
use ncp_verifier::suite::SuiteError;
use thiserror::Error;
use xtask::project::Project;
use xtask::setup::SetupError;

use crate::lock::LockError;
use crate::mutants::MutantsError;
use crate::reports::ReportError;

#[derive(Debug, Subcommand)]
pub(crate) enum Mutate {
    /// Change one token of the kernel, so many times, and hold each changed one against the properties
    #[command(after_help = kernel::EXAMPLES)]
    Kernel(kernel::KernelArgs),
    /// Hold the kernels of the hostile auditor, single and combined, against the properties and the theorem
    #[command(after_help = hostile::EXAMPLES)]
    Hostile(hostile::HostileArgs),
    /// Have cargo-mutants change the specification, and ask the golden cases and the tests who notices
    #[command(after_help = spec::EXAMPLES)]
    Spec(spec::SpecArgs),
}

/// # Errors
/// As the command has them; `false` if a change goes unnoticed and nothing says why it may.
pub(crate) fn run(project: &Project, command: &Mutate) -> Result<bool, MutateError> {
    match command {
        Mutate::Kernel(args) => kernel::run(project, args),
        Mutate::Hostile(args) => hostile::run(project, args),
        Mutate::Spec(args) => spec::run(project, args),
    }
}

/// Why changes could not be tried.
#[derive(Debug, Error)]
pub(crate) enum MutateError {
    #[error("{}: {source}", path.display())]
    File { path: PathBuf, source: io::Error },
    #[error(transparent)]
    Lock(#[from] LockError),
    #[error(transparent)]
    Report(#[from] ReportError),
    #[error(transparent)]
    Setup(#[from] SetupError),
    #[error("{}: {source}", path.display())]
    Outcomes { path: PathBuf, source: serde_json::Error },
    #[error("{}: {source}", path.display())]
    Explained { path: PathBuf, source: Box<toml::de::Error> },
    #[error("{}: no reason is given of a change in {text:?}", path.display())]
    NoReason { path: PathBuf, text: String },
    #[error("{program} cannot be started: {source}")]
    Start { program: &'static str, source: io::Error },
    #[error("changed kernels do not compile, and none of them is named:\n{said}")]
    NoCopy { said: String },
    #[error("changed kernels: the compiler finds errors without end")]
    ErrorsWithoutEnd,
    #[error(transparent)]
    Table(#[from] TableError),
    #[error(transparent)]
    Place(#[from] PlaceError),
    #[error("{}: {source}", path.display())]
    Manifest { path: PathBuf, source: Box<toml::de::Error> },
    #[error("the copy of the kernel without a change is not the model of the theorem:\n{said}")]
    NoTie { said: String },
    #[error("there is no hostile kernel of that name: {name}")]
    NoKernel { name: String },
    #[error(transparent)]
    Mutants(#[from] MutantsError),
    #[error(transparent)]
    Suite(#[from] SuiteError),
    #[error("the kernel without a change fails {failing} golden cases")]
    UnsoundKernel { failing: usize },
    #[error("signals cannot be caught: {0}")]
    Signals(io::Error),
    #[error("ncp-mutants ended with {status}")]
    Failed { status: String },
}
