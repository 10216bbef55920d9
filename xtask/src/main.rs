//! The project's own commands: `cargo xtask <command>`.
//!
//! - `generate`: the files that are made from others, and whether they are fresh.
//! - `checks`: what `cargo xtask test` checks, in order.
//! - `test`: carries the checks out and shows them.
//! - `count`: finds the number of tests in what a test program printed.

#![forbid(unsafe_code)]

mod checks;
mod count;
mod generate;
mod test;

use std::io;
use std::path::PathBuf;
use std::process::ExitCode;

use thiserror::Error;

use xtask::project::{NoProject, Project};
use xtask::setup;

const USAGE: &str = "\
Usage: cargo xtask <command>

Commands:
  test [--only <check>]…  Set up what is missing, then check everything
  test --list             List the checks
  generate                Write the generated files anew: schemas, vectors, their manifest, the C header
  generate --check        Only say which of them are stale
  setup                   Only set up what the checks need, into ignored folders; valgrind, Chromium
";

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let args: Vec<&str> = args.iter().map(String::as_str).collect();
    match run(&args) {
        Ok(success) if success => ExitCode::SUCCESS,
        Ok(_) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(if matches!(error, Error::Usage { .. }) { 2 } else { 1 })
        }
    }
}

/// Carries out a command line; `false` is a command that ran and found something wrong.
fn run(args: &[&str]) -> Result<bool, Error> {
    if args.is_empty() || args.iter().any(|arg| matches!(*arg, "-h" | "--help" | "help")) {
        print!("{USAGE}");
        return Ok(!args.is_empty());
    }
    let project = Project::find()?;
    match args {
        ["test", "--list"] => {
            test::list();
            Ok(true)
        }
        ["test", selection @ ..] => test::run(&project, &test::select(selection)?),
        ["generate"] => generate::write(&project),
        ["generate", "--check"] => generate::report_stale(&project),
        ["setup"] => Ok(setup::all(&project).map(|()| true)?),
        _ => Err(Error::Usage { what: format!("`{}` is no command", args.join(" ")) }),
    }
}

/// Why a command could not do its work.
#[derive(Debug, Error)]
enum Error {
    #[error("{what}\n\n{USAGE}")]
    Usage { what: String },
    #[error(transparent)]
    NoProject(#[from] NoProject),
    #[error("{0}")]
    Setup(#[from] setup::SetupError),
    #[error("cannot generate: {0}")]
    Generate(&'static str),
    #[error("cannot generate the C header: {0}")]
    Header(String),
    #[error("{}: {source}", path.display())]
    File { path: PathBuf, source: io::Error },
}
