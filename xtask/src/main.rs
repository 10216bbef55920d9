//! The project's own commands: `cargo xtask <command>`.
//!
//! - `generate`: the files that are made from others, and whether they are fresh.
//! - `package`: the packages by which others get `ncp-verify`.
//! - `contract`: what of a contract that went out this one breaks.
//! - `site`: the project's public site.
//! - `checks`: what `cargo xtask test` checks, in order.
//! - `test`: carries the checks out and shows them.
//! - `work`: what a check works with.
//! - `process`: runs programs that end when this one is told to.
//! - `tally`: counts tests, and reads them from JUnit files.

#![forbid(unsafe_code)]

mod checks;
mod contract;
mod generate;
mod package;
mod process;
mod site;
mod tally;
mod test;
mod work;

use std::io;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::builder::PossibleValuesParser;
use clap::{Parser, Subcommand};
use thiserror::Error;
use xtask::project::{self, NoProject, Project};
use xtask::setup;

/// The project's own commands.
#[derive(Debug, Parser)]
#[command(name = "cargo xtask", bin_name = "cargo xtask")]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Set up what is missing, then check everything
    Test {
        /// Only this check; may be given several times
        #[arg(long, value_name = "CHECK", value_parser = PossibleValuesParser::new(checks::names()))]
        #[arg(hide_possible_values = true)]
        only: Vec<String>,
        /// List the checks
        #[arg(long)]
        list: bool,
    },
    /// Write the generated files anew: schemas, vectors, their manifest, the C header
    Generate {
        /// Only say which of them are stale
        #[arg(long)]
        check: bool,
    },
    /// Say what of a contract that went out this one breaks, as buf does not see it
    Contract {
        /// The image of its proto, as buf builds it [default: the frozen one]
        #[arg(long, value_name = "IMAGE", requires = "projection")]
        against: Option<PathBuf>,
        /// Its projection
        #[arg(long, value_name = "FILE", requires = "against")]
        projection: Option<PathBuf>,
        /// Print JSON: rule, place, was, is and why of each
        #[arg(long)]
        json: bool,
    },
    /// Make the packages of ncp-verify for this machine, into target/packages
    Package {
        /// Only this kind; may be given several times
        #[arg(long, value_name = "KIND")]
        only: Vec<package::Kind>,
    },
    /// Make the project's public site: the text with its evidence, the cases, the findings, the reports
    Site {
        /// The folder to make it in [default: reports/site]
        #[arg(long, value_name = "DIR")]
        output: Option<PathBuf>,
    },
    /// Only set up what the checks need: into ignored folders, and valgrind and Chromium by apt-get
    Setup,
}

fn main() -> ExitCode {
    match run(Cli::parse().command) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(error.exit_code())
        }
    }
}

/// Carries out a command; `false` is one that ran and found something wrong.
fn run(command: Command) -> Result<bool, Error> {
    let project = Project::find()?;
    match command {
        Command::Test { list: true, .. } => {
            test::list();
            Ok(true)
        }
        Command::Test { only, .. } => test::run(&project, &test::select(&project, &only)),
        Command::Generate { check: true } => generate::report_stale(&project),
        Command::Generate { check: false } => generate::write(&project),
        Command::Contract { against, projection, json } => {
            contract::report(against.as_deref().zip(projection.as_deref()), json)
        }
        Command::Package { only } => {
            process::end_on_signal().map_err(Error::Signals)?;
            package::report(&project, &only)?;
            Ok(true)
        }
        Command::Site { output } => {
            site::make(&project, output.as_deref())?;
            Ok(true)
        }
        Command::Setup => {
            setup::all(&project)?;
            Ok(true)
        }
    }
}

/// Why a command could not do its work.
#[derive(Debug, Error)]
enum Error {
    #[error("{0}")]
    NoProject(#[from] NoProject),
    #[error("{0}")]
    Setup(#[from] setup::SetupError),
    #[error("cannot generate: {0}")]
    Generate(&'static str),
    #[error(transparent)]
    Scenario(#[from] ncp_vectors::GenerateError),
    #[error("cannot generate the C header: {0}")]
    Header(String),
    #[error("{}: {source}", path.display())]
    File { path: PathBuf, source: io::Error },
    #[error(transparent)]
    Package(#[from] package::PackageError),
    #[error("signals cannot be handled: {0}")]
    Signals(io::Error),
    #[error("interrupted")]
    Interrupted,
}

impl Error {
    fn exit_code(&self) -> u8 {
        match self {
            Self::Interrupted => 130,
            _ => 1,
        }
    }
}
