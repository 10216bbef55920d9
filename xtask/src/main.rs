//! The project's own commands: `cargo xtask <command>`.
//!
//! - `generate`: the files that are made from others, and whether they are fresh.
//! - `checks`: what `cargo xtask test` checks, in order.
//! - `test`: carries the checks out and shows them.
//! - `work`: what a check works with.
//! - `process`: runs programs that end when this one is told to.
//! - `tally`: counts tests, and reads them from JUnit files.
//! - `fuzz`: builds the fuzz targets, runs them, and measures what they reach.
//! - `mutate_kernel`: changes one token of the kernel at a time, and asks whether the proofs notice.
//! - `mutate_spec`: mutants of the specification, and what notices them.
//! - `prove`: the proofs, and whether their report is fresh.

#![forbid(unsafe_code)]

mod checks;
mod fuzz;
mod generate;
mod mutate_kernel;
mod mutate_spec;
mod process;
mod prove;
mod tally;
mod test;
mod work;

use std::io;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::builder::PossibleValuesParser;
use clap::{Parser, Subcommand};
use thiserror::Error;
use xtask::project::{self, NotStartedByCargo, Project};
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
    /// Only set up what the checks need: into ignored folders, and valgrind and Chromium by apt-get
    Setup,
    /// Fuzz the targets
    Fuzz(Options),
    /// Prove the kernel, or change it and hold each changed one against the properties
    Prove(Options),
    /// Mutate the specification by cargo-mutants
    MutateSpec(Options),
}

/// What a command takes apart itself.
#[derive(Debug, clap::Args)]
struct Options {
    #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
    options: Vec<String>,
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
        Command::Setup => {
            setup::all(&project)?;
            Ok(true)
        }
        Command::Fuzz(Options { options }) => fuzz::run(&project, &words(&options)),
        Command::Prove(Options { options }) if options.iter().any(|option| option == "--mutate") => {
            mutate_kernel::run(&project, &words(&options))
        }
        Command::Prove(Options { options }) => prove::run(&project, &words(&options)),
        Command::MutateSpec(Options { options }) => mutate_spec::run(&project, &words(&options)),
    }
}

fn words(options: &[String]) -> Vec<&str> {
    options.iter().map(String::as_str).collect()
}

/// Why a command could not do its work.
#[derive(Debug, Error)]
enum Error {
    #[error("{what}")]
    Usage { what: String },
    #[error("{0}")]
    NoProject(#[from] NotStartedByCargo),
    #[error("{0}")]
    Setup(#[from] setup::SetupError),
    #[error("cannot generate: {0}")]
    Generate(&'static str),
    #[error("changed kernels: {0}")]
    Mutants(String),
    #[error("cannot generate the C header: {0}")]
    Header(String),
    #[error("{}: {source}", path.display())]
    File { path: PathBuf, source: io::Error },
    #[error("interrupted")]
    Interrupted,
}

impl Error {
    fn exit_code(&self) -> u8 {
        match self {
            Self::Usage { .. } => 2,
            Self::Interrupted => 130,
            _ => 1,
        }
    }
}
