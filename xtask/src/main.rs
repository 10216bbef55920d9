//! The project's own commands: `cargo xtask <command>`.
//!
//! - `project`: where things are, and how programs are started.
//! - `setup`: tools and packages, into folders that git ignores.
//! - `generate`: the files that are made from others, and whether they are fresh.
//! - `checks`: what `cargo xtask test` checks, in order.
//! - `test`: carries the checks out and shows them.
//! - `fuzz`: builds the fuzz targets, runs them, and measures what they reach.
//! - `mutate_kernel`: changes one token of the kernel at a time, and asks whether the proofs notice.
//! - `mutate_spec`: mutants of the specification, and what notices them.
//! - `prove`: the proofs, and whether their report is fresh.
//! - `count`: finds the number of tests in what a test program printed.

#![forbid(unsafe_code)]

mod checks;
mod count;
mod fuzz;
mod generate;
mod mutate_kernel;
mod mutate_spec;
mod project;
mod prove;
mod setup;
mod test;

use std::io;
use std::path::PathBuf;
use std::process::ExitCode;

use thiserror::Error;

use crate::project::Project;

const USAGE: &str = "\
Usage: cargo xtask <command>

Commands:
  test [--only <check>]…  Set up what is missing, then check everything
  test --list             List the checks
  generate                Write the generated files anew: schemas, vectors, their manifest, the C header
  generate --check        Only say which of them are stale
  fuzz [--time 30s] [--target <name>]…
                          Fuzz every target for so long; fuzz/README.md has the other modes:
                          --replay, --planted, --coverage, --minimise
  prove [--engine <name>]…
                          Prove the kernel anew, and write reports/proofs.{json,md,html}
  prove --mutate <N> [--seed <S>]
                          Change one token of the kernel, N times, and hold each changed one against the
                          properties; writes reports/mutations.{json,md}
  mutate-spec [--module <name>]…
                          Mutate the specification by cargo-mutants, and write reports/cargo-mutants.{json,md}
  mutate-spec --missed    Only what no run has seen noticed so far
  mutate-spec --report    Only write the report of what the last runs left in .tools
  mutate-spec --check     Only say whether that report is about the sources as they are
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
        ["fuzz", options @ ..] => fuzz::run(&project, options),
        ["prove", options @ ..] if options.contains(&"--mutate") => mutate_kernel::run(&project, options),
        ["prove", engines @ ..] => prove::run(&project, engines),
        ["mutate-spec", options @ ..] => mutate_spec::run(&project, options),
        ["setup"] => setup::all(&project),
        _ => Err(Error::Usage { what: format!("`{}` is no command", args.join(" ")) }),
    }
}

/// Why a command could not do its work.
#[derive(Debug, Error)]
enum Error {
    #[error("{what}\n\n{USAGE}")]
    Usage { what: String },
    #[error("not started by cargo: CARGO_MANIFEST_DIR is not set")]
    NoProject,
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
}
