//! Drives the proofs: sets the solvers up, and runs the engines.

use std::ffi::OsString;
use std::fs;
use std::io;
use std::path::PathBuf;
use std::process::Command;
use std::thread;
use std::time::Instant;

use clap::Args;
use clap::builder::PossibleValuesParser;
use thiserror::Error;
use xtask::project::Project;
use xtask::setup::{self, SetupError};

/// Whether the machine code of this machine can be explored.
const RUNS_MACHINE: bool = cfg!(all(target_os = "linux", target_arch = "x86_64"));
/// The engines, as `proofs/README.md` describes them.
const ENGINES: [&str; 7] = ["symbolic", "enumeration", "machine", "model", "readers", "kani-stand-in", "kani"];
/// What the first stage finds out about the kernel, for the second.
const KERNEL: &str = ".tools/proofs-kernel.json";
/// Where the engines that are programs of their own leave their results.
const MACHINE: &str = ".tools/machine.json";
const MODEL: &str = ".tools/model.json";
const READERS: &str = ".tools/readers.json";

pub(crate) const EXAMPLES: &str = "\
Examples:
  cargo assure prove                               all engines: about ten minutes
  cargo assure prove --engine symbolic --engine model";

#[derive(Debug, Args)]
pub(crate) struct ProveArgs {
    /// Only this engine; may be given again. What the others said of the same sources stays
    #[arg(long = "engine", value_name = "NAME", value_parser = PossibleValuesParser::new(ENGINES))]
    engines: Vec<String>,
    /// Also write the long report, with every claim in words and symbols: reports/full/proofs.md and .html
    #[arg(long)]
    pub(crate) report: bool,
}

impl ProveArgs {
    /// The engines that were named; empty: all.
    pub(crate) fn engines(&self) -> &[String] {
        &self.engines
    }

    fn wants(&self, engine: &str) -> bool {
        self.engines.is_empty() || self.engines.iter().any(|wanted| wanted == engine)
    }
}

/// Runs the engines; `false` if a property is not proved or a broken kernel not refuted.
///
/// # Errors
/// The solvers cannot be set up, or a program cannot be started.
pub(crate) fn run(project: &Project, args: &ProveArgs) -> Result<bool, ProveError> {
    let is_wanted_machine = RUNS_MACHINE && args.wants("machine");
    thread::scope(|scope| {
        // What explores machine code takes half a minute to install, and comes late.
        let ahead = is_wanted_machine.then(|| scope.spawn(|| install_angr(project)));
        engines(project, args, || match ahead {
            Some(ahead) => ahead.join().unwrap_or(false),
            None => false,
        })
    })
}

/// Runs the engines; `angr` waits for what explores machine code, and says whether it is there.
fn engines(project: &Project, args: &ProveArgs, angr: impl FnOnce() -> bool) -> Result<bool, ProveError> {
    let began = Instant::now();
    let part = |what: &str| {
        let seconds = began.elapsed().as_secs();
        println!("\n[{}:{:02}] {what}", seconds / 60, seconds % 60);
    };
    part("the solvers");
    setup::solvers(project, &mut |line| println!("{line}"))?;
    // First the kernel itself, without the broken ones: whoever has changed it wants to hear that at once.
    forget(project, KERNEL);
    for (engine, file) in [("model", MODEL), ("machine", MACHINE), ("readers", READERS)] {
        if args.wants(engine) {
            forget(project, file);
        }
    }
    let chosen: Vec<&str> = args.engines.iter().flat_map(|engine| ["--engine", engine]).collect();
    let program = |options: &[&str], stage: &str| {
        let start = ["run", "--quiet", "--release", "-p", "ncp-proofs"];
        project.cargo(&[&start[..], options, &["--", "--stage", stage], &chosen].concat())
    };
    part("the kernel: on values, on samples, and for all doubles by the solvers");
    if !start(program(&[], "kernel"))? {
        return Ok(false);
    }
    let mut good = true;
    if args.wants("model") {
        part("the protocol over a bad network, by model checking");
        let words = ["run", "--quiet", "--release", "-p", "ncp-model", "--", "--json", MODEL];
        good &= start(project.cargo(&words))?;
    }
    if args.wants("readers") {
        part("what reads blocks, versions and keys, on every input within the bounds");
        let program = ["-p", "ncp-readers", "--features", "broken", "--", "--json", READERS];
        good &= start(project.cargo(&[&["run", "--quiet", "--release"], &program[..]].concat()))?;
    }
    if args.wants("machine") {
        part("the machine code of the kernel, by symbolic execution");
        good &= machine(project, angr)?;
    }
    part("broken kernels, which each engine has to refute, and the report");
    good &= start(program(&["--features", "broken"], "rest"))?;
    part(if good { "done" } else { "FAILED" });
    Ok(good)
}

/// Explores the machine code, where that can be done: on other machines it is not run, which is no failure,
/// and the report says so.
fn machine(project: &Project, angr: impl FnOnce() -> bool) -> Result<bool, ProveError> {
    if !RUNS_MACHINE {
        println!("machine code: not run here, as it is for x86-64 Linux");
        return Ok(true);
    }
    if !angr() {
        return Ok(true);
    }
    start(project.program(OsString::from("proofs/machine/prove.sh"), &["--json", MACHINE], ""))
}

/// Installs what explores machine code; `false`, and why, where that cannot be had.
fn install_angr(project: &Project) -> bool {
    let installed = setup::angr(project, &mut |line| println!("{line}"));
    if let Err(error) = &installed {
        println!("machine code: not run here: {error}");
    }
    installed.is_ok()
}

/// Removes the results of an earlier run.
fn forget(project: &Project, file: &str) {
    fs::remove_file(project.path(file)).ok();
}

fn start(mut command: Command) -> Result<bool, ProveError> {
    let status = command.status();
    let status = status.map_err(|source| ProveError::Start { program: command.get_program().into(), source })?;
    Ok(status.success())
}

/// Why the proofs could not be run.
#[derive(Debug, Error)]
pub(crate) enum ProveError {
    #[error(transparent)]
    Setup(#[from] SetupError),
    #[error("{} cannot be started: {source}", program.display())]
    Start { program: PathBuf, source: io::Error },
}
