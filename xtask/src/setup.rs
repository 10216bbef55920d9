//! Tools and packages, into folders that git ignores. Each step says what it installs,
//! and does nothing when that is there already.

use std::fs;
use std::io::{self, Write};
use std::path::PathBuf;
use std::process::Command;

use thiserror::Error;

use crate::Error as XtaskError;
use crate::project::{self, Project};

/// The version of the buf CLI, as the package `buf-bin` of PyPI has it.
const BUF_VERSION: &str = "1.75.0";
const VENV: &str = ".tools/venv";
const SOLVERS_VENV: &str = ".tools/proofs-venv";
const SOLVERS: [&str; 2] = ["bitwuzla==0.9.1", "z3-solver==5.4.0.0"];
const ANGR_VENV: &str = ".tools/machine-venv";
const ANGR: [&str; 4] = [
    "angr==9.2.213",
    "bitstring==4.4.0",
    "pycparser==3.0",
    "bitwuzla==0.9.1",
];
const TYPESCRIPT: &str = "peers/typescript";

/// Tells the person who waits what is being installed.
pub(crate) type Say<'a> = &'a mut dyn FnMut(&str);

/// Sets up everything.
///
/// # Errors
/// The first thing that could not be installed.
pub(crate) fn all(project: &Project) -> Result<bool, XtaskError> {
    let mut say = |line: &str| println!("{line}");
    buf(project, &mut say)?;
    typescript(project, &mut say)?;
    println!("ready: buf {BUF_VERSION} in {VENV}, the packages of {TYPESCRIPT}");
    Ok(true)
}

/// Installs the buf CLI, and returns its path.
///
/// # Errors
/// No Python, or one that cannot make a virtual environment, or no PyPI.
pub(crate) fn buf(project: &Project, say: Say<'_>) -> Result<PathBuf, SetupError> {
    let bin = project
        .path(VENV)
        .join(if cfg!(windows) { "Scripts" } else { "bin" });
    let buf = bin.join("buf");
    if version(&mut Command::new(&buf)).is_some_and(|version| version == BUF_VERSION) {
        return Ok(buf);
    }
    let python = ["python3", "python"]
        .into_iter()
        .find(|python| version(&mut Command::new(python)).is_some())
        .ok_or(SetupError::Missing {
            tool: "python3",
            remedy: "install Python 3.9 or later",
        })?;
    say(&format!(
        "installing buf {BUF_VERSION} (buf-bin, from PyPI) into {VENV}"
    ));
    carry_out(project.program(python, &["-m", "venv", "--clear", VENV], "")).map_err(
        |failure| SetupError::Venv {
            failure: Box::new(failure),
        },
    )?;
    let package = format!("buf-bin=={BUF_VERSION}");
    let pip = [
        "-m",
        "pip",
        "install",
        "--quiet",
        "--disable-pip-version-check",
        &package,
    ];
    carry_out(project.program(bin.join("python"), &pip, ""))?;
    Ok(buf)
}

/// Installs the solvers of the proofs.
///
/// # Errors
/// No Python, or one that cannot make a virtual environment, or no PyPI.
pub(crate) fn solvers(project: &Project, say: Say<'_>) -> Result<(), SetupError> {
    python_packages(project, SOLVERS_VENV, "bitwuzla, z3", &SOLVERS, say)
}

/// Installs what explores the machine code of the kernel.
///
/// # Errors
/// As [`solvers`].
pub(crate) fn angr(project: &Project, say: Say<'_>) -> Result<(), SetupError> {
    python_packages(project, ANGR_VENV, "angr, bitwuzla", &ANGR, say)
}

/// Installs pinned packages of PyPI into a virtual environment, unless it has their modules.
fn python_packages(
    project: &Project,
    venv: &str,
    modules: &str,
    packages: &[&str],
    say: Say<'_>,
) -> Result<(), SetupError> {
    let bin = project
        .path(venv)
        .join(if cfg!(windows) { "Scripts" } else { "bin" });
    let python = bin.join("python");
    // What was installed is noted beside it: other pins are another environment.
    let (note, pins) = (project.path(venv).join("packages.txt"), packages.join("\n"));
    let has_modules = || {
        let import = Command::new(&python)
            .args(["-c", &format!("import {modules}")])
            .output();
        import.is_ok_and(|output| output.status.success())
    };
    if fs::read_to_string(&note).is_ok_and(|noted| noted == pins) && has_modules() {
        return Ok(());
    }
    let system = ["python3", "python"]
        .into_iter()
        .find(|python| version(&mut Command::new(python)).is_some())
        .ok_or(SetupError::Missing {
            tool: "python3",
            remedy: "install Python 3.9 or later",
        })?;
    say(&format!("installing {modules} (from PyPI) into {venv}"));
    let failed = |failure| SetupError::Venv {
        failure: Box::new(failure),
    };
    carry_out(project.program(system, &["-m", "venv", "--clear", venv], "")).map_err(failed)?;
    let pip = [
        "-m",
        "pip",
        "install",
        "--quiet",
        "--disable-pip-version-check",
    ];
    carry_out(project.program(&python, &[&pip[..], packages].concat(), ""))?;
    fs::write(&note, pins).map_err(|source| SetupError::File { path: note, source })
}

/// Installs the packages of the TypeScript peer, as its lock file has them.
///
/// # Errors
/// No npm, or no registry.
pub(crate) fn typescript(project: &Project, say: Say<'_>) -> Result<(), SetupError> {
    let folder = project.path(TYPESCRIPT);
    // npm leaves a copy of the lock file when it has installed everything.
    let changed = |file: &str| fs::metadata(folder.join(file)).and_then(|file| file.modified());
    let wanted = changed("package-lock.json").map_err(|source| SetupError::File {
        path: folder.join("package-lock.json"),
        source,
    })?;
    if changed("node_modules/.package-lock.json").is_ok_and(|installed| installed >= wanted) {
        return Ok(());
    }
    if version(&mut Command::new(NPM)).is_none() {
        return Err(SetupError::Missing {
            tool: "npm",
            remedy: "install Node.js 20 or later",
        });
    }
    say(&format!(
        "installing the packages of {TYPESCRIPT} (npm ci) into its node_modules"
    ));
    carry_out(project.program(NPM, &["ci", "--no-audit", "--no-fund"], TYPESCRIPT))
}

/// The program npm, by the name under which it can be started.
pub(crate) const NPM: &str = if cfg!(windows) { "npm.cmd" } else { "npm" };

/// Why something could not be set up.
#[derive(Debug, Error)]
pub(crate) enum SetupError {
    #[error("{tool} is missing: {remedy}")]
    Missing {
        tool: &'static str,
        remedy: &'static str,
    },
    #[error("cannot make a virtual environment (on Debian: install python3-venv)\n{failure}")]
    Venv { failure: Box<SetupError> },
    #[error("{command} ended with {status}\n{output}")]
    Failed {
        command: String,
        status: String,
        output: String,
    },
    #[error("{command} could not be started: {source}")]
    Start { command: String, source: io::Error },
    #[error("{}: {source}", path.display())]
    File { path: PathBuf, source: io::Error },
}

fn carry_out(mut command: Command) -> Result<(), SetupError> {
    io::stdout().flush().ok();
    let shown = project::shown(&command);
    let result = command.output();
    let output = result.map_err(|source| SetupError::Start {
        command: shown.clone(),
        source,
    })?;
    if output.status.success() {
        return Ok(());
    }
    let printed = [output.stdout, output.stderr].concat();
    Err(SetupError::Failed {
        command: shown,
        status: output.status.to_string(),
        output: String::from_utf8_lossy(&printed).trim_end().to_owned(),
    })
}

/// What a program prints for `--version`, or `None` when it cannot be run.
fn version(program: &mut Command) -> Option<String> {
    let output = program.arg("--version").output().ok()?;
    output
        .status
        .success()
        .then(|| String::from_utf8_lossy(&output.stdout).trim().to_owned())
}
