//! Drives the proofs: sets the solvers up, and runs the engines.

use std::ffi::OsString;
use std::fs;
use std::io;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::thread;
use std::time::Instant;

use clap::Args;
use clap::builder::PossibleValuesParser;
use ncp_proofs::report::Answer;
use thiserror::Error;
use xtask::project::Project;
use xtask::setup::{self, SetupError};

use crate::proofs::theorem::{CLAIMS, Claims, THEOREMS};

/// Whether the machine code of this machine can be explored.
const RUNS_MACHINE: bool = cfg!(all(target_os = "linux", target_arch = "x86_64"));
/// The engines, as `proofs/README.md` describes them.
const ENGINES: [&str; 9] =
    ["symbolic", "enumeration", "machine", "model", "readers", "path", "theorem", "kani-stand-in", "kani"];
/// The engines that are done within a minute, and need nothing but cargo.
pub(crate) const QUICK: [&str; 4] = ["enumeration", "kani-stand-in", "model", "readers"];
/// What the first stage finds out about the kernel, for the second.
const KERNEL: &str = ".tools/proofs-kernel.json";
/// With the broken kernels.
const BROKEN: &[&str] = &["--features", "broken"];
/// Where the engines that are programs of their own leave their results.
const MACHINE: &str = ".tools/machine.json";
const MODEL: &str = ".tools/model.json";
const READERS: &str = ".tools/readers.json";
const PATH: &str = ".tools/path.json";
const THEOREM: &str = ".tools/theorem.json";
/// How `check.sh` ends where Coq cannot be had.
const NO_COQ: i32 = 3;

pub(crate) const EXAMPLES: &str = "\
Examples:
  cargo assure prove                               all engines: ten minutes, and three for Coq
  cargo assure prove --engine theorem              the theorem, from a fresh clone: Coq comes from Debian
  cargo assure prove --fast                        the quick engines once more, held against the locks
  cargo assure prove --engine symbolic --engine model
  cargo assure prove --sabotage all                does the symbolic engine notice defects of its own?";

#[derive(Debug, Args)]
pub(crate) struct ProveArgs {
    /// Only this engine; may be given again. What the others said of the same sources stays
    #[arg(long = "engine", value_name = "NAME", value_parser = PossibleValuesParser::new(ENGINES))]
    engines: Vec<String>,
    /// The quick engines only, whose words have to be those of the locks; nothing is written into the tree
    #[arg(long, conflicts_with_all = ["engines", "report", "page"])]
    pub(crate) fast: bool,
    /// Run no engine: only render reports/proofs.md from the locks
    #[arg(long, conflicts_with_all = ["engines", "report"])]
    pub(crate) page: bool,
    /// Hold the run of the symbolic engine against an engine with this defect of its own (`defects/engine.toml`), or
    /// against each of them: `all`. Each has to end with an error
    #[arg(long, value_name = "NAME", conflicts_with_all = ["engines", "report", "page", "fast"])]
    sabotage: Option<String>,
    /// Pin how much the symbolic engine explores, after a look at what has changed: proofs/explored.json
    #[arg(long)]
    pub(crate) pin: bool,
    /// Also write the long report, with every claim in words and symbols: reports/full/proofs.md and .html
    #[arg(long)]
    pub(crate) report: bool,
}

impl ProveArgs {
    /// The engines that were named; empty: all.
    pub(crate) fn engines(&self) -> &[String] {
        &self.engines
    }

    fn chosen(&self) -> Vec<&str> {
        if self.fast { QUICK.to_vec() } else { self.engines.iter().map(String::as_str).collect() }
    }

    fn wants(&self, engine: &str) -> bool {
        let chosen = self.chosen();
        chosen.is_empty() || chosen.contains(&engine)
    }
}

/// Runs the engines; `false` if a property is not proved or a broken kernel not refuted.
///
/// # Errors
/// The solvers cannot be set up, or a program cannot be started.
pub(crate) fn run(project: &Project, args: &ProveArgs) -> Result<bool, ProveError> {
    if let Some(name) = &args.sabotage {
        setup::solvers(project, &mut |line| println!("{line}"))?;
        return sabotage(project, name);
    }
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
    // The engine of the path asks them of the link monitor's detector.
    if args.wants("symbolic") || args.wants("path") {
        part("the solvers");
        setup::solvers(project, &mut |line| println!("{line}"))?;
    }
    // First the kernel itself, without the broken ones: whoever has changed it wants to hear that at once.
    forget(project, KERNEL);
    for (engine, file) in
        [("model", MODEL), ("machine", MACHINE), ("readers", READERS), ("path", PATH), ("theorem", THEOREM)]
    {
        if args.wants(engine) {
            forget(project, file);
        }
    }
    let chosen: Vec<&str> = args.chosen().into_iter().flat_map(|engine| ["--engine", engine]).collect();
    // What the quick engines build takes longer than what they run: in the check, all of it is built once, by the
    // profile of the other checks.
    let profile = if args.fast { "--profile=verify" } else { "--profile=release" };
    let first: &[&str] = if args.fast { BROKEN } else { &[] };
    let program = |options: &[&str], stage: &str| {
        let start = ["run", "--quiet", profile, "-p", "ncp-proofs"];
        project.cargo(&[&start[..], options, &["--", "--stage", stage], &chosen].concat())
    };
    part("the kernel: on values, on samples, and for all doubles by the solvers");
    if !start(program(first, "kernel"))? {
        return Ok(false);
    }
    let mut good = true;
    if args.wants("model") {
        part("the protocol over a bad network, by model checking");
        let words = ["run", "--quiet", profile, "-p", "ncp-model", "--", "--json", MODEL];
        good &= start(project.cargo(&words))?;
    }
    if args.wants("readers") {
        part("what reads blocks, versions and keys, on every input within the bounds");
        let program = ["-p", "ncp-readers", "--features", "broken", "--", "--json", READERS];
        good &= start(project.cargo(&[&["run", "--quiet", profile], &program[..]].concat()))?;
    }
    if args.wants("path") {
        part("the safety path around the kernel: the scanner for ESTOPs, the governor, the link monitor, the loop");
        let words = ["run", "--quiet", profile, "-p", "ncp-path", "--", "--json", PATH];
        good &= start(project.cargo(&words))?;
    }
    if args.wants("machine") {
        part("the machine code of the kernel, by symbolic execution");
        good &= machine(project, angr)?;
    }
    if args.wants("theorem") {
        part("the theorem from the command to the plant, by Coq");
        good &= theorem(project)?;
    }
    if args.engines.is_empty() && !args.fast {
        part("engines with a defect of their own, each of which its run has to notice");
        good &= sabotage(project, "all")?;
    }
    part("broken kernels, which each engine has to refute, and the report");
    let mut rest = program(BROKEN, "rest");
    if args.pin {
        rest.arg("--pin");
    }
    good &= start(rest)?;
    part(if good { "done" } else { "FAILED" });
    Ok(good)
}

/// Runs the symbolic engine with a defect of its own, or with each of them.
fn sabotage(project: &Project, name: &str) -> Result<bool, ProveError> {
    let program =
        ["run", "--quiet", "--release", "-p", "ncp-proofs", "--features", "sabotage", "--", "--sabotage", name];
    start(project.cargo(&program))
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

/// Has Coq check the theorem, where it can be had, and leaves what it says as the results of an engine.
fn theorem(project: &Project) -> Result<bool, ProveError> {
    let read = |file: &str| {
        let path = project.path(file);
        fs::read_to_string(&path).map_err(|source| ProveError::File { path, source })
    };
    let claims: Claims = toml::from_str(&read(CLAIMS)?).map_err(|source| ProveError::Claims { source })?;
    let mut check = project.program("bash", &["proofs/theorem/check.sh"], "");
    let output = check.stderr(Stdio::inherit()).output();
    let output = output.map_err(|source| ProveError::Start { program: "bash".into(), source })?;
    let printed = String::from_utf8_lossy(&output.stdout);
    if output.status.code() == Some(NO_COQ) {
        println!("the theorem: not run here");
        return Ok(true);
    }
    let summary = ["versions: ", "exported: ", "tie: ", "theorem: "];
    printed
        .lines()
        .filter(|line| summary.iter().any(|kind| line.starts_with(kind)))
        .for_each(|line| println!("{line}"));
    let engine = claims.engine(&read(THEOREMS)?, &printed, output.status.success());
    let json = serde_json::to_string_pretty(&engine).map_err(|source| ProveError::Json { source })?;
    let path = project.path(THEOREM);
    fs::write(&path, json + "\n").map_err(|source| ProveError::File { path, source })?;
    for answer in &engine.results {
        println!("{:8} {}  {}", answer.verdict.as_str(), answer.property, answer.detail);
    }
    Ok(output.status.success() && engine.results.iter().all(Answer::is_proved))
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
    #[error("{}: {source}", path.display())]
    File { path: PathBuf, source: io::Error },
    #[error("{CLAIMS}: {source}")]
    Claims { source: toml::de::Error },
    #[error("what the theorem says: {source}")]
    Json { source: serde_json::Error },
}
