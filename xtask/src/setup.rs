//! Tools and packages, into folders that git ignores. Each step says what it installs,
//! and does nothing when that is there already.

use std::env;
use std::fs;
use std::io::{self, Write};
use std::path::PathBuf;
use std::process::Command;

use thiserror::Error;

use crate::project::{self, Project};

/// The version of the buf CLI, as the package `buf-bin` of PyPI has it.
const BUF_VERSION: &str = "1.75.0";
/// The version of cargo-nextest that is installed where there is none.
const NEXTEST_VERSION: &str = "0.9.143";
/// The version of cargo-deny that is installed where there is none.
const DENY_VERSION: &str = "0.20.2";
const VENV: &str = ".tools/venv";
/// Where programs of crates.io are installed.
const CARGO_ROOT: &str = ".tools";
const SOLVERS_VENV: &str = ".tools/proofs-venv";
/// The solvers of the proofs, as PyPI has them.
pub const SOLVERS: [&str; 2] = ["bitwuzla==0.9.1", "z3-solver==5.4.0.0"];
const ANGR_VENV: &str = ".tools/machine-venv";
/// What explores the machine code of the kernel, as PyPI has it.
pub const ANGR: [&str; 4] = ["angr==9.2.213", "bitstring==4.4.0", "pycparser==3.0", "bitwuzla==0.9.1"];
const MATURIN_VENV: &str = ".tools/maturin-venv";
/// What makes the wheel, as PyPI has it; `packages/pypi/pyproject.toml` names the same.
const MATURIN: [&str; 1] = ["maturin==1.16.0"];
const TYPESCRIPT: &str = "peers/typescript";
const SITE: &str = "site";
const PYTHON: &str = "peers/python";
/// Where its `build.py` installs it.
const PYTHON_VENV: &str = ".tools/python-venv";

/// Tells the person who waits what is being installed.
pub type Say<'a> = &'a mut dyn FnMut(&str);

/// Sets up everything.
///
/// # Errors
/// The first thing that could not be installed.
pub fn all(project: &Project) -> Result<(), SetupError> {
    let mut say = |line: &str| println!("{line}");
    nextest(project, &mut say)?;
    buf(project, &mut say)?;
    browser(project, &mut say)?;
    site(project, &mut say)?;
    cpp(project, &mut say)?;
    python(project, &mut say)?;
    println!(
        "ready: cargo-nextest, buf {BUF_VERSION} in {VENV}, the packages of {TYPESCRIPT} and {SITE}, the module of \
         {PYTHON}, a C++ compiler, valgrind, Chromium"
    );
    Ok(())
}

/// Installs cargo-nextest, unless there is one, and returns its path.
///
/// # Errors
/// As [`program`].
pub fn nextest(project: &Project, say: Say<'_>) -> Result<PathBuf, SetupError> {
    subcommand(project, "cargo-nextest", NEXTEST_VERSION, say)
}

/// Installs cargo-deny, unless there is one, and returns its path. It takes some minutes to build.
///
/// # Errors
/// As [`program`].
pub fn deny(project: &Project, say: Say<'_>) -> Result<PathBuf, SetupError> {
    subcommand(project, "cargo-deny", DENY_VERSION, say)
}

/// Whether [`deny`] has nothing to install.
#[must_use]
pub fn has_deny(project: &Project) -> bool {
    ["cargo-deny".into(), project.path(CARGO_ROOT).join("bin/cargo-deny")].iter().any(runs_as_subcommand)
}

/// A subcommand of cargo: the one on the path, whatever its version, or else the pinned one.
fn subcommand(project: &Project, name: &str, pinned: &str, say: Say<'_>) -> Result<PathBuf, SetupError> {
    let on_path = PathBuf::from(name);
    if runs_as_subcommand(&on_path) { Ok(on_path) } else { program(project, name, pinned, say) }
}

fn runs_as_subcommand(program: &PathBuf) -> bool {
    let name = program.file_name().map(|name| name.to_string_lossy().replace("cargo-", "")).unwrap_or_default();
    version(Command::new(program).arg(name)).is_some()
}

/// Installs the buf CLI, and returns its path.
///
/// # Errors
/// No Python, or one that cannot make a virtual environment, or no PyPI.
pub fn buf(project: &Project, say: Say<'_>) -> Result<PathBuf, SetupError> {
    let buf = buf_path(project);
    let bin = project.path(VENV).join(if cfg!(windows) { "Scripts" } else { "bin" });
    if version(&mut Command::new(&buf)).is_some_and(|version| version == BUF_VERSION) {
        return Ok(buf);
    }
    let python = find_python()?;
    say(&format!("installing buf {BUF_VERSION} (buf-bin, from PyPI) into {VENV}"));
    carry_out(project.program(python, &["-m", "venv", "--clear", VENV], ""))
        .map_err(|failure| SetupError::Venv { failure: Box::new(failure) })?;
    let package = format!("buf-bin=={BUF_VERSION}");
    let pip = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check", &package];
    carry_out(project.program(bin.join("python"), &pip, ""))?;
    Ok(buf)
}

/// Where [`buf`] installs it.
#[must_use]
pub fn buf_path(project: &Project) -> PathBuf {
    project.path(VENV).join(if cfg!(windows) { "Scripts" } else { "bin" }).join("buf")
}

/// Installs the solvers of the proofs.
///
/// # Errors
/// No Python, or one that cannot make a virtual environment, or no PyPI.
pub fn solvers(project: &Project, say: Say<'_>) -> Result<(), SetupError> {
    python_packages(project, SOLVERS_VENV, "bitwuzla, z3", &SOLVERS, say)
}

/// Installs what explores the machine code of the kernel.
///
/// # Errors
/// As [`solvers`].
pub fn angr(project: &Project, say: Say<'_>) -> Result<(), SetupError> {
    python_packages(project, ANGR_VENV, "angr, bitwuzla", &ANGR, say)
}

/// Installs maturin, and returns its path.
///
/// # Errors
/// As [`solvers`].
pub fn maturin(project: &Project, say: Say<'_>) -> Result<PathBuf, SetupError> {
    python_packages(project, MATURIN_VENV, "maturin", &MATURIN, say)?;
    Ok(project.path(MATURIN_VENV).join(if cfg!(windows) { "Scripts" } else { "bin" }).join("maturin"))
}

/// Installs pinned packages of PyPI into a virtual environment, unless it has their modules.
fn python_packages(
    project: &Project,
    venv: &str,
    modules: &str,
    packages: &[&str],
    say: Say<'_>,
) -> Result<(), SetupError> {
    let bin = project.path(venv).join(if cfg!(windows) { "Scripts" } else { "bin" });
    let python = bin.join("python");
    // What was installed is noted beside it: other pins are another environment.
    let (note, pins) = (project.path(venv).join("packages.txt"), packages.join("\n"));
    let has_modules = || {
        let import = Command::new(&python).args(["-c", &format!("import {modules}")]).output();
        import.is_ok_and(|output| output.status.success())
    };
    if fs::read_to_string(&note).is_ok_and(|noted| noted == pins) && has_modules() {
        return Ok(());
    }
    let system = ["python3", "python"]
        .into_iter()
        .find(|python| version(&mut Command::new(python)).is_some())
        .ok_or(SetupError::Missing { tool: "python3", remedy: "install Python 3.9 or later" })?;
    say(&format!("installing {modules} (from PyPI) into {venv}"));
    let failed = |failure| SetupError::Venv { failure: Box::new(failure) };
    carry_out(project.program(system, &["-m", "venv", "--clear", venv], "")).map_err(failed)?;
    let pip = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check"];
    carry_out(project.program(&python, &[&pip[..], packages].concat(), ""))?;
    fs::write(&note, pins).map_err(|source| SetupError::File { path: note, source })
}

/// Installs the packages of the TypeScript peer, as its lock file has them.
///
/// # Errors
/// No npm, or no registry.
pub fn typescript(project: &Project, say: Say<'_>) -> Result<(), SetupError> {
    node_packages(project, TYPESCRIPT, say)
}

/// Installs the generator of the site, as its lock file has it.
///
/// # Errors
/// As [`typescript`].
pub fn site(project: &Project, say: Say<'_>) -> Result<(), SetupError> {
    node_packages(project, SITE, say)
}

/// Installs the packages of a folder from npm, unless they are there.
fn node_packages(project: &Project, folder: &str, say: Say<'_>) -> Result<(), SetupError> {
    let path = project.path(folder);
    // npm leaves a copy of the lock file when it has installed everything.
    let changed = |file: &str| fs::metadata(path.join(file)).and_then(|file| file.modified());
    let wanted = changed("package-lock.json")
        .map_err(|source| SetupError::File { path: path.join("package-lock.json"), source })?;
    if changed("node_modules/.package-lock.json").is_ok_and(|installed| installed >= wanted) {
        return Ok(());
    }
    if version(&mut Command::new(NPM)).is_none() {
        return Err(SetupError::Missing { tool: "npm", remedy: "install Node.js 20 or later" });
    }
    say(&format!("installing the packages of {folder} (npm ci) into its node_modules"));
    carry_out(project.program(NPM, &["ci", "--no-audit", "--no-fund"], folder))
}

/// Installs a C++ compiler and valgrind, where Debian's apt-get can.
///
/// # Errors
/// They are missing, and cannot be installed.
pub fn cpp(project: &Project, say: Say<'_>) -> Result<(), SetupError> {
    let remedy = "install a C and C++ compiler and valgrind";
    for (tool, package) in [("cc", "gcc"), ("c++", "g++"), ("valgrind", "valgrind")] {
        debian(project, say, tool, package, remedy)?;
    }
    Ok(())
}

/// Installs the packages of the TypeScript peer and, where Debian's apt-get can, Chromium.
///
/// # Errors
/// They are missing, and cannot be installed.
pub fn browser(project: &Project, say: Say<'_>) -> Result<(), SetupError> {
    typescript(project, say)?;
    chromium(project, say)
}

/// Installs the generator of the site and, where Debian's apt-get can, Chromium, which its tests drive.
///
/// # Errors
/// They are missing, and cannot be installed.
pub fn site_tests(project: &Project, say: Say<'_>) -> Result<(), SetupError> {
    site(project, say)?;
    chromium(project, say)
}

fn chromium(project: &Project, say: Say<'_>) -> Result<(), SetupError> {
    if env::var_os("NCP_CHROMIUM").is_some() {
        return Ok(());
    }
    let remedy = "install Chromium, or say by NCP_CHROMIUM where one is";
    debian(project, say, "chromium", "chromium", remedy)
}

/// Builds the module of the Python peer and installs it, and returns the Python that has it.
///
/// # Errors
/// No Python, one that cannot make a virtual environment, no PyPI, or code that does not compile.
pub fn python(project: &Project, say: Say<'_>) -> Result<PathBuf, SetupError> {
    let python = find_python()?;
    say(&format!("building the module of {PYTHON} (maturin, from PyPI) into {PYTHON_VENV}"));
    carry_out(project.program(python, &["build.py", "--tests"], PYTHON))?;
    let bin = if cfg!(windows) { "Scripts" } else { "bin" };
    Ok(project.path(PYTHON_VENV).join(bin).join("python"))
}

/// Installs a program of crates.io into `.tools`, and returns its path.
///
/// # Errors
/// No registry, or it does not build here.
pub fn program(project: &Project, name: &str, pinned: &str, say: Say<'_>) -> Result<PathBuf, SetupError> {
    let program = project.path(CARGO_ROOT).join("bin").join(name);
    // As a subcommand of cargo, it says its version when it gets its own name first.
    let subcommand = name.trim_start_matches("cargo-");
    let mut ask = Command::new(&program);
    if version(ask.arg(subcommand)).is_some_and(|version| version.ends_with(pinned)) {
        return Ok(program);
    }
    say(&format!("installing {name} {pinned} (from crates.io) into {CARGO_ROOT}"));
    let root = project.path(CARGO_ROOT);
    let root = root.to_string_lossy();
    let install = ["install", "--quiet", "--locked", "--force", "--version", pinned, "--root", &root, name];
    carry_out(project.cargo(&install))?;
    Ok(program)
}

/// The program npm, by the name under which it can be started.
pub const NPM: &str = if cfg!(windows) { "npm.cmd" } else { "npm" };

/// Why something could not be set up.
#[derive(Debug, Error)]
pub enum SetupError {
    /// A tool of the system is not there, and nothing here can install it.
    #[error("{tool} is missing: {remedy}")]
    Missing {
        /// The program.
        tool: &'static str,
        /// What a person can do.
        remedy: &'static str,
    },
    /// Python makes no virtual environment.
    #[error("cannot make a virtual environment (on Debian: install python3-venv)\n{failure}")]
    Venv {
        /// What failed.
        failure: Box<SetupError>,
    },
    /// A program did not succeed.
    #[error("{command} ended with {status}\n{output}")]
    Failed {
        /// The program and its arguments.
        command: String,
        /// How it ended.
        status: String,
        /// What it printed.
        output: String,
    },
    /// A program could not be started.
    #[error("{command} could not be started: {source}")]
    Start {
        /// The program and its arguments.
        command: String,
        /// Why.
        source: io::Error,
    },
    /// A file could not be read or written.
    #[error("{}: {source}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
}

/// Installs the package of a tool that is missing, by Debian's apt-get.
fn debian(
    project: &Project,
    say: Say<'_>,
    tool: &'static str,
    package: &str,
    remedy: &'static str,
) -> Result<(), SetupError> {
    let there = || version(&mut Command::new(tool)).is_some();
    if there() {
        return Ok(());
    }
    say(&format!("installing {package} (Debian, by apt-get)"));
    let install = ["apt-get", "install", "--yes", "--no-install-recommends", package];
    // As root, or as somebody who may become root without being asked.
    let as_root = |command: &[&str]| {
        carry_out(project.program(command[0], &command[1..], ""))
            .or_else(|_| carry_out(project.program("sudo", &[&["-n"][..], command].concat(), "")))
    };
    // A new machine may not know its packages yet.
    let installed = as_root(&install).or_else(|_| {
        as_root(&["apt-get", "update"])?;
        as_root(&install)
    });
    if installed.is_err() || !there() {
        return Err(SetupError::Missing { tool, remedy });
    }
    Ok(())
}

/// A Python by the name under which it can be started.
fn find_python() -> Result<&'static str, SetupError> {
    ["python3", "python"]
        .into_iter()
        .find(|python| version(&mut Command::new(python)).is_some())
        .ok_or(SetupError::Missing { tool: "python3", remedy: "install Python 3.9 or later" })
}

/// Runs a program to its end without showing what it prints, unless it fails.
///
/// # Errors
/// It could not be started, or did not succeed.
pub fn carry_out(mut command: Command) -> Result<(), SetupError> {
    io::stdout().flush().ok();
    let shown = project::shown(&command);
    let result = command.output();
    let output = result.map_err(|source| SetupError::Start { command: shown.clone(), source })?;
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
    output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().to_owned())
}
