//! The maintainers' command, `cargo assure`: what shows each rule, what notices each planted defect, what is proved and
//! fuzzed, and which artefact is stale.
//!
//! It sees every room of the house, and no room sees it.
//!
//! | module | what it does |
//! |---|---|
//! | `artefact` | the one table: what is made, of which sources, by which command |
//! | `status` | says what is stale, and makes just that anew |
//! | `trace` | leads from every rule to what shows it, and back |
//! | `mutants` | holds the suite against peers with planted defects |
//! | `deep` | chooses the deep set from what the search draws |
//! | `dictionary` | makes the fault dictionary, and measures what a diagnosis by it is worth |
//! | `mutate` | changes the kernel token by token, and the specification by cargo-mutants, and asks who notices |
//! | `proofs` | what git keeps of what the engines found |
//! | `live` | what the scenarios of `live/` say of our own system |
//! | `prove` | drives the engines of `proofs/` |
//! | `fuzz` | drives the targets of `fuzz/` |
//! | `lock` | what git keeps of what was found: digests, counts, and fates by id |
//! | `reports` | where the short pages and the long reports go |
//! | `document` | one document, written as Markdown and as HTML |
//! | `planted` | copies the project's sources with planted defects |
//! | `console` | colours, widths and Ctrl-C |

#![forbid(unsafe_code)]

mod artefact;
mod console;
mod deep;
mod dictionary;
mod document;
mod fuzz;
mod live;
mod lock;
mod mutants;
mod mutate;
mod planted;
mod proofs;
mod prove;
mod reports;
mod status;
mod trace;

use std::io;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, Subcommand};
use thiserror::Error;
use xtask::project::{NoProject, Project};
use xtask::setup::SetupError;

/// What shows each rule, what notices each planted defect, and which artefact is stale.
#[derive(Debug, Parser)]
#[command(name = "cargo assure", bin_name = "cargo assure", version)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Say of every artefact whether it is fresh, and if not, what changed since it was made
    Status(status::StatusArgs),
    /// Make what is stale anew, in order, and nothing else
    Refresh(status::RefreshArgs),
    /// Trace every rule to what shows it, and back, in the source tree
    Trace(trace::command::TraceArgs),
    /// Measure what the suite detects: run it against the Rust peer with one planted defect after the other
    Mutants(mutants::command::MutantsArgs),
    /// Choose the deep set anew, from what the generators of the search draw
    Deep(deep::DeepArgs),
    /// Make the fault dictionary of the verifier, and measure what a diagnosis by it is worth
    Dictionary(dictionary::DictionaryArgs),
    /// Change the kernel or the specification, and ask who notices
    #[command(subcommand)]
    Mutate(mutate::Mutate),
    /// Prove the kernel, its readers and the protocol anew
    #[command(after_help = prove::EXAMPLES)]
    Prove(prove::ProveArgs),
    /// Run the live scenarios on our own system, and with each planted defect; Zenoh takes minutes to compile
    Live(live::LiveArgs),
    /// Fuzz every target for a while, replay its inputs, or ask what it finds and reaches
    #[command(after_help = fuzz::EXAMPLES)]
    Fuzz(fuzz::FuzzArgs),
}

fn main() -> ExitCode {
    match run(&Cli::parse()) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: {error}");
            let is_usage = matches!(error, Error::Usage { .. } | Error::Fuzz(fuzz::FuzzError::NoTarget { .. }));
            ExitCode::from(if is_usage { 2 } else { 4 })
        }
    }
}

/// Carries out a command line; `false` is a command that ran and found something wrong.
fn run(cli: &Cli) -> Result<bool, Error> {
    let project = Project::find()?;
    match &cli.command {
        Command::Status(args) => Ok(status::status(&project, args)?),
        Command::Refresh(args) => Ok(status::refresh(&project, args)?),
        Command::Trace(args) => trace::command::trace(&project, args),
        Command::Mutants(args) => mutants::command::mutants(&project, args),
        Command::Deep(args) => deep::deep(&project, args),
        Command::Dictionary(args) => dictionary::dictionary(&project, args),
        Command::Mutate(command) => Ok(mutate::run(&project, command)?),
        Command::Prove(args) if args.page => Ok(proofs::render(&project).map(|()| true)?),
        Command::Prove(args) if args.fast => {
            let held = proofs::Aside::put(&project)?;
            let good = prove::run(&project, args);
            let differing = good.map(|_| proofs::differing(&project));
            drop(held);
            let differing = differing??;
            differing.iter().for_each(|line| println!("DIFFERS: {line}"));
            Ok(differing.is_empty())
        }
        Command::Prove(args) => {
            let before = proofs::Before::of(&project)?;
            let good = prove::run(&project, args)?;
            let before = if args.pin { before.pinned(&project)? } else { before };
            proofs::keep(&project, args.engines(), &before, args.report)?;
            Ok(good)
        }
        Command::Live(args) => Ok(live::run(&project, args)?),
        Command::Fuzz(args) => Ok(fuzz::run(&project, args)?),
    }
}

/// Why a command could not do its work.
#[derive(Debug, Error)]
enum Error {
    #[error("{what}")]
    Usage { what: String },
    #[error(transparent)]
    NoProject(#[from] NoProject),
    #[error("{0}")]
    Setup(#[from] SetupError),
    #[error(transparent)]
    Trace(#[from] trace::TraceError),
    #[error(transparent)]
    Hunt(#[from] mutants::MutantsError),
    #[error(transparent)]
    Deep(#[from] ncp_verifier::fuzz::FuzzError),
    #[error(transparent)]
    Court(#[from] ncp_verifier::fuzz::CourtError),
    #[error(transparent)]
    Manifest(#[from] ncp_verifier::peer::ManifestError),
    #[error("the suite: {0}")]
    Suite(#[from] ncp_verifier::suite::SuiteError),
    #[error(transparent)]
    Dictionary(#[from] ncp_verifier::dictionary::DictionaryError),
    #[error(transparent)]
    Status(#[from] status::StatusError),
    #[error(transparent)]
    Proofs(#[from] proofs::ProofsError),
    #[error(transparent)]
    Lock(#[from] lock::LockError),
    #[error(transparent)]
    Report(#[from] reports::ReportError),
    #[error("signals cannot be handled: {0}")]
    Signals(io::Error),
    #[error(transparent)]
    Mutate(#[from] mutate::MutateError),
    #[error(transparent)]
    Prove(#[from] prove::ProveError),
    #[error(transparent)]
    Live(#[from] live::LiveError),
    #[error(transparent)]
    Fuzz(#[from] fuzz::FuzzError),
    #[error("{}: {source}", path.display())]
    File { path: PathBuf, source: io::Error },
}
