//! The packages by which others get `ncp-verify` without a toolchain, for the machine on which they are made.
//!
//! - `archive`: a plain archive.
//! - `notices`: the licences of what is built in.
//! - `npm`: the package of npm, and that of the platform.

mod archive;
mod notices;
mod npm;

use std::env;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Stdio;

use clap::ValueEnum;
use thiserror::Error;

use crate::process;
use xtask::project::{self, Project};
use xtask::setup::{self, SetupError, carry_out};

/// Where the packages go.
pub(crate) const PACKAGES: &str = "target/packages";
/// The version of each.
const VERSION: &str = env!("CARGO_PKG_VERSION");
const PYPI: &str = "packages/pypi";
const PROGRAM: &str = if cfg!(windows) { "ncp-verify.exe" } else { "ncp-verify" };

/// A kind of package.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Kind {
    /// For pip
    Wheel,
    /// For npm: the launcher, and the program for this platform
    Npm,
    /// A tar.gz
    Archive,
}

/// Why a package could not be made.
#[derive(Debug, Error)]
pub(crate) enum PackageError {
    #[error(transparent)]
    Setup(#[from] SetupError),
    #[error("{}: {source}", path.display())]
    File { path: PathBuf, source: io::Error },
    #[error("the program does not build: {0}")]
    Build(String),
    #[error("{0} left no file in {PACKAGES}")]
    Nothing(&'static str),
    #[error("{what}: {message}")]
    Json { what: String, message: String },
    #[error(
        "npm knows no platform {}-{} of ours: add it to PLATFORMS in xtask/src/package/npm.rs",
        env::consts::OS,
        env::consts::ARCH
    )]
    Platform,
}

/// What goes into packages.
struct Contents<'p> {
    project: &'p Project,
    program: PathBuf,
    /// Files by their place below a prefix such as `/usr/local`: manual pages, completions, licences, the protocol.
    shared: PathBuf,
}

/// Makes the packages of some kinds, or of all, and returns their files.
///
/// # Errors
/// Something that they need is missing, or does not build.
pub(crate) fn make(project: &Project, only: &[Kind], say: setup::Say<'_>) -> Result<Vec<PathBuf>, PackageError> {
    let asked = |kind: Kind| only.is_empty() || only.contains(&kind);
    let folder = project.path(PACKAGES);
    remove(&folder)?;
    create(&folder)?;
    say("building ncp-verify by the profile dist, which takes some minutes");
    let program = build(project)?;
    say("writing manual pages, completions and licences");
    let contents = Contents { project, program, shared: project.path("target/packaged/share") };
    contents.write_shared()?;
    let mut made = Vec::new();
    if asked(Kind::Archive) {
        say("packing the archive");
        made.push(archive::make(&contents, &folder)?);
    }
    if asked(Kind::Npm) {
        say("packing for npm");
        made.extend(npm::make(&contents, &folder)?);
    }
    if asked(Kind::Wheel) {
        let maturin = setup::maturin(project, say)?;
        say("packing the wheel");
        made.push(wheel(&contents, &maturin, &folder)?);
    }
    Ok(made)
}

/// Makes the packages and says how large they are.
///
/// # Errors
/// As [`make`].
pub(crate) fn report(project: &Project, only: &[Kind]) -> Result<(), PackageError> {
    let made = make(project, only, &mut |line| eprintln!("{line}"))?;
    let program = project.path("target/dist").join(PROGRAM);
    for file in made.iter().chain([&program]) {
        let bytes = fs::metadata(file).map_err(|source| PackageError::File { path: file.clone(), source })?.len();
        let shown = file.strip_prefix(project.path("")).unwrap_or(file);
        println!("{:>6.1} MB  {}", bytes as f64 / 1e6, shown.display());
    }
    Ok(())
}

/// Builds the program, and shows what cargo says.
fn build(project: &Project) -> Result<PathBuf, PackageError> {
    let mut cargo = project.cargo(&["build", "--profile", "dist", "-p", "ncp-verifier", "--bin", "ncp-verify"]);
    cargo.env("CARGO_ENCODED_RUSTFLAGS", flags(project)).env("CARGO_TARGET_DIR", project.path("target"));
    let shown = project::shown(&cargo);
    let status = process::run(cargo.stdout(Stdio::null()));
    match status {
        Ok(status) if status.success() => Ok(project.path("target/dist").join(PROGRAM)),
        Ok(status) => Err(PackageError::Build(format!("{shown} ended with {status}"))),
        Err(error) => Err(PackageError::Build(format!("{shown} could not be started: {error}"))),
    }
}

/// The flags of rustc, so that no path of this machine is built in.
fn flags(project: &Project) -> String {
    let home = env::var_os("CARGO_HOME").map(PathBuf::from).or_else(|| Some(env::home_dir()?.join(".cargo")));
    let registry = home.map(|home| format!("--remap-path-prefix={}=registry", home.join("registry/src").display()));
    let root: PathBuf = project.path("").components().collect();
    let own = format!("--remap-path-prefix={}=ncp", root.display());
    let asked = env::var("RUSTFLAGS").unwrap_or_default();
    let asked = asked.split_whitespace().map(str::to_owned);
    registry.into_iter().chain([own]).chain(asked).collect::<Vec<_>>().join("\u{1f}")
}

/// The wheel: maturin builds the program once more, finds that all is built, and adds what is shared.
fn wheel(contents: &Contents<'_>, maturin: &Path, folder: &Path) -> Result<PathBuf, PackageError> {
    let project = contents.project;
    // maturin takes the licences from beside pyproject.toml, and what is shared from a folder of this name.
    let data = project.path(PYPI).join("ncp_verify.data");
    remove(&data)?;
    copy_all(&contents.shared, &data.join("data/share"))?;
    for licence in ["LICENSE-MIT", "LICENSE-APACHE"] {
        copy(&project.path(licence), &project.path(PYPI).join(licence))?;
    }
    let out = folder.display().to_string();
    let mut build = project.program(maturin, &["build", "--quiet", "--out", &out], PYPI);
    build.env("CARGO_ENCODED_RUSTFLAGS", flags(project)).env("CARGO_TARGET_DIR", project.path("target"));
    carry_out(build)?;
    files(folder)?
        .into_iter()
        .find(|file| file.extension().is_some_and(|e| e == "whl"))
        .ok_or(PackageError::Nothing("maturin"))
}

impl Contents<'_> {
    /// Writes what is shared anew.
    fn write_shared(&self) -> Result<(), PackageError> {
        remove(&self.shared)?;
        let man = self.shared.join("man/man1").display().to_string();
        carry_out(self.project.program(&self.program, &["man", &man], ""))?;
        for (shell, file) in [
            ("bash", "bash-completion/completions/ncp-verify"),
            ("zsh", "zsh/site-functions/_ncp-verify"),
            ("fish", "fish/vendor_completions.d/ncp-verify.fish"),
            ("powershell", "ncp-verify/completions/ncp-verify.ps1"),
            ("elvish", "ncp-verify/completions/ncp-verify.elv"),
        ] {
            let script = self.printed(&["completions", shell])?;
            write(&self.shared.join(file), &script)?;
        }
        let doc = self.shared.join("doc/ncp-verify");
        create(&doc)?;
        for file in ["LICENSE-MIT", "LICENSE-APACHE", "peers/PROTOCOL.md", "peers/PROTOCOL-starter.py"] {
            let from = self.project.path(file);
            copy(&from, &doc.join(from.file_name().unwrap_or_default()))?;
        }
        write(&doc.join("THIRD-PARTY.txt"), notices::of_program(self.project)?.as_bytes())
    }

    /// What the program prints.
    fn printed(&self, args: &[&str]) -> Result<Vec<u8>, PackageError> {
        let mut command = self.project.program(&self.program, args, "");
        let output = command.output().map_err(|source| PackageError::File { path: self.program.clone(), source })?;
        let failed = || PackageError::Build(format!("{} ended with {}", project::shown(&command), output.status));
        output.status.success().then_some(output.stdout.clone()).ok_or_else(failed)
    }
}

fn create(folder: &Path) -> Result<(), PackageError> {
    fs::create_dir_all(folder).map_err(|source| PackageError::File { path: folder.to_owned(), source })
}

fn remove(folder: &Path) -> Result<(), PackageError> {
    match fs::remove_dir_all(folder) {
        Err(source) if source.kind() != io::ErrorKind::NotFound => {
            Err(PackageError::File { path: folder.to_owned(), source })
        }
        _ => Ok(()),
    }
}

fn write(file: &Path, bytes: &[u8]) -> Result<(), PackageError> {
    file.parent().map_or(Ok(()), create)?;
    fs::write(file, bytes).map_err(|source| PackageError::File { path: file.to_owned(), source })
}

fn copy(from: &Path, to: &Path) -> Result<(), PackageError> {
    to.parent().map_or(Ok(()), create)?;
    fs::copy(from, to).map(drop).map_err(|source| PackageError::File { path: from.to_owned(), source })
}

/// Copies a folder with all that is in it.
fn copy_all(from: &Path, to: &Path) -> Result<(), PackageError> {
    for path in files(from)? {
        let to = to.join(path.file_name().unwrap_or_default());
        if path.is_dir() { copy_all(&path, &to)? } else { copy(&path, &to)? }
    }
    Ok(())
}

/// What is in a folder, sorted.
fn files(folder: &Path) -> Result<Vec<PathBuf>, PackageError> {
    let read = || -> io::Result<Vec<PathBuf>> {
        let mut paths = fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect::<io::Result<Vec<_>>>()?;
        paths.sort();
        Ok(paths)
    };
    read().map_err(|source| PackageError::File { path: folder.to_owned(), source })
}
