//! libFuzzer, by way of cargo-fuzz: which toolchain, how targets are built, started and read.

use std::fmt;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};

use xtask::project::{self, Project};
use xtask::setup::{self, Say, SetupError};

use super::{FuzzError, Hunt};
use crate::planted::SWITCH;

/// The version of cargo-fuzz.
pub(super) const CARGO_FUZZ: &str = "0.13.2";

/// With what the targets are built and run.
pub(super) struct Engine {
    /// The nightly toolchain with AddressSanitizer; else the toolchain that builds all the rest, without.
    address: bool,
    rustc: String,
    host: String,
    cargo_fuzz: PathBuf,
    /// Where it builds, and keeps what it finds.
    folder: PathBuf,
}

/// How a target ran.
pub(super) struct Run {
    pub(super) executions: u64,
    /// Edges of the program's flow that were reached.
    pub(super) edges: u64,
    pub(super) seconds: f64,
    /// What was found, if anything was.
    pub(super) crash: Option<Crash>,
    /// It was found before anything was mutated.
    pub(super) from_corpus: bool,
    pub(super) log: PathBuf,
}

/// An input with which something is wrong.
pub(super) struct Crash {
    pub(super) input: PathBuf,
    /// What the target said to it.
    pub(super) said: String,
}

impl Engine {
    /// Nightly and AddressSanitizer if they are there, else stable; cargo-fuzz is installed.
    ///
    /// # Errors
    /// No compiler, or cargo-fuzz cannot be installed.
    pub(super) fn find(project: &Project, stable: bool, say: Say<'_>) -> Result<Self, SetupError> {
        let nightly = if stable { None } else { nightly() };
        let address = nightly.is_some();
        let (rustc, host) = nightly
            .or_else(|| compiler(Command::new("rustc")))
            .ok_or(SetupError::Missing { tool: "rustc", remedy: "install Rust" })?;
        let target = std::env::var_os("CARGO_TARGET_DIR");
        let target = target.map_or_else(|| project.path("target"), PathBuf::from);
        Ok(Self {
            address,
            rustc,
            host,
            cargo_fuzz: setup::program(project, "cargo-fuzz", CARGO_FUZZ, say)?,
            folder: target.join(if address { "fuzz-address" } else { "fuzz-plain" }),
        })
    }

    /// The same for a copy of the project, whose builds and results are kept apart.
    pub(super) fn of_the_copy(mut self) -> Self {
        self.folder.push("planted");
        self
    }

    /// Builds all targets of a project.
    ///
    /// # Errors
    /// What the compiler says.
    pub(super) fn build(&self, project: &Project, say: Say<'_>) -> Result<(), SetupError> {
        say(&format!("building the fuzz targets ({self})"));
        let folder = self.folder.to_string_lossy();
        let mut args = vec!["build", "--codegen-units", "16", "--target-dir", &folder];
        if !self.address {
            args.extend(["--sanitizer", "none"]);
        }
        let mut build = project.program(&self.cargo_fuzz, &args, "fuzz");
        // It is to find the toolchain's own cargo, not the one that started this program.
        build.env_remove("CARGO").env_remove("CARGO_MANIFEST_DIR");
        if self.address {
            build.env("RUSTUP_TOOLCHAIN", "nightly");
        } else {
            build.env("RUSTC_BOOTSTRAP", "1");
        }
        setup::carry_out(build)
    }

    /// Fuzzes a target from its corpus on; what it learns stays in [`work`](Self::work).
    ///
    /// # Errors
    /// It cannot be started.
    pub(super) fn fuzz(&self, project: &Project, name: &str, time: Duration) -> Result<Run, FuzzError> {
        let work = self.work(name);
        super::create(&work)?;
        self.start(project, self.target(project, name), name, name, &work, time)
    }

    /// Fuzzes a target from its corpus on until it finds a planted defect, and forgets what it learned.
    ///
    /// # Errors
    /// It cannot be started.
    pub(super) fn hunt(&self, project: &Project, hunt: &Hunt<'_>, time: Duration) -> Result<Run, FuzzError> {
        let label = format!("{}-{}", hunt.target, hunt.defect.name);
        let work = self.fresh("hunt", &label)?;
        let mut target = self.target(project, hunt.target);
        target.env(SWITCH, hunt.number.to_string());
        self.start(project, target, hunt.target, &label, &work, time)
    }

    /// The fewest inputs of some folders that reach what all reach, in a folder of their own.
    ///
    /// # Errors
    /// It cannot be started, or finds an input with which something is wrong.
    pub(super) fn merge(&self, project: &Project, name: &str, from: &[&Path]) -> Result<PathBuf, FuzzError> {
        let merged = self.fresh("merged", name)?;
        let mut merge = self.target(project, name);
        // Edges without the counts of their passes: a small set that reaches every line.
        merge.args(["-merge=1", "-use_counters=0", "-max_len=4096"]).arg(&merged);
        merge.args(from.iter().filter(|folder| folder.is_dir()));
        setup::carry_out(merge)?;
        Ok(merged)
    }

    /// What a target learned in earlier runs.
    pub(super) fn work(&self, name: &str) -> PathBuf {
        self.folder("work").join(name)
    }

    /// A folder for what is no part of the project.
    pub(super) fn folder(&self, name: &str) -> PathBuf {
        self.folder.join(name)
    }

    /// A folder that is there and empty.
    fn fresh(&self, what: &str, name: &str) -> Result<PathBuf, FuzzError> {
        let folder = self.folder(what).join(name);
        super::create(&folder)?;
        for file in super::files(&folder)? {
            super::remove(&file)?;
        }
        Ok(folder)
    }

    fn target(&self, project: &Project, name: &str) -> Command {
        let program = self.folder.join(&self.host).join("release").join(name);
        let mut target = project.program(program, &[], "");
        // What is freed at the end of a run is no leak of one input.
        target.env("ASAN_OPTIONS", "detect_leaks=0:detect_odr_violation=0");
        target.env("RUST_BACKTRACE", "0");
        target
    }

    /// Starts a target, and keeps what it says and finds under a label.
    fn start(
        &self,
        project: &Project,
        mut target: Command,
        name: &str,
        label: &str,
        work: &Path,
        time: Duration,
    ) -> Result<Run, FuzzError> {
        let artifacts = self.folder("artifacts").join(label);
        let logs = self.folder("logs");
        super::create(&artifacts)?;
        super::create(&logs)?;
        let log = logs.join(format!("{label}.log"));
        let unusable = |source| FuzzError::File { path: log.clone(), source };
        target
            .arg(format!("-max_total_time={}", time.as_secs()))
            .arg(format!("-artifact_prefix={}/", artifacts.display()))
            .args(["-max_len=4096", "-timeout=20", "-rss_limit_mb=2560", "-print_final_stats=1"]);
        if ["frame_", "validate", "session", "peer"].iter().any(|start| name.starts_with(start)) {
            target.arg(format!("-dict={}", project.path("fuzz/dict/frame.dict").display()));
        }
        let corpus = project.path(super::CORPUS).join(name);
        target.arg(work).args(corpus.is_dir().then_some(corpus));
        let out = File::create(&log).map_err(unusable)?;
        let err = out.try_clone().map_err(unusable)?;
        let shown = project::shown(&target);
        let start = Instant::now();
        let status = target.stdout(out).stderr(err).status();
        let status = status.map_err(|source| SetupError::Start { command: shown.clone(), source })?;
        let seconds = start.elapsed().as_secs_f64();
        let printed = fs::read(&log).map_err(unusable)?;
        let printed = String::from_utf8_lossy(&printed);
        let crash = crash(&printed);
        if crash.is_none() && !status.success() {
            return Err(FuzzError::Setup(SetupError::Failed {
                command: shown,
                status: status.to_string(),
                output: printed.into_owned(),
            }));
        }
        Ok(Run {
            executions: executions(&printed),
            edges: edges(&printed),
            seconds,
            from_corpus: crash.is_some() && !printed.contains("INITED"),
            crash,
            log,
        })
    }
}

impl fmt::Display for Engine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sanitizer = if self.address { "AddressSanitizer" } else { "no sanitizer" };
        write!(f, "{}, cargo-fuzz {CARGO_FUZZ}, {sanitizer}", self.rustc)
    }
}

/// The nightly compiler and its host, if it comes with AddressSanitizer.
fn nightly() -> Option<(String, String)> {
    let rustc = || {
        let mut rustc = Command::new("rustup");
        rustc.args(["run", "nightly", "rustc"]);
        rustc
    };
    let (version, host) = compiler(rustc())?;
    let sysroot = rustc().args(["--print", "sysroot"]).output().ok()?;
    let sysroot = String::from_utf8(sysroot.stdout).ok()?;
    let libraries = Path::new(sysroot.trim()).join("lib/rustlib").join(&host).join("lib");
    let mut libraries = fs::read_dir(libraries).ok()?.flatten();
    let has_runtime = libraries.any(|file| file.file_name().to_string_lossy().contains("rt.asan"));
    has_runtime.then_some((version, host))
}

/// What a compiler calls itself, and for what it builds.
fn compiler(mut rustc: Command) -> Option<(String, String)> {
    let output = rustc.arg("-vV").output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    let version = text.lines().next()?.to_owned();
    let host = text.lines().find_map(|line| line.strip_prefix("host: "))?;
    Some((version, host.to_owned()))
}

/// What libFuzzer says of an input that it keeps, and what the target said before.
fn crash(printed: &str) -> Option<Crash> {
    let path = printed.lines().find_map(|line| line.split_once("Test unit written to "))?.1;
    let panic = printed.lines().skip_while(|line| !line.contains("panicked at"));
    let mut said: Vec<_> = panic.take(8).take_while(|line| !line.starts_with("note: ")).collect();
    if said.is_empty() {
        said = printed.lines().filter(|line| line.contains("ERROR:")).take(2).collect();
    }
    Some(Crash { input: PathBuf::from(path.trim()), said: said.join("\n") })
}

fn executions(printed: &str) -> u64 {
    let line = printed.lines().find_map(|line| line.strip_prefix("stat::number_of_executed_units:"));
    if let Some(count) = line.and_then(|count| count.trim().parse().ok()) {
        return count;
    }
    // A target that finds something says no more than the number of its last event.
    let numbers = printed.lines().filter_map(|line| line.strip_prefix('#')?.split_ascii_whitespace().next());
    numbers.filter_map(|number| number.trim_end_matches(':').parse().ok()).max().unwrap_or(0)
}

fn edges(printed: &str) -> u64 {
    let words = printed.lines().filter_map(|line| line.split_once(" cov: ")?.1.split(' ').next());
    words.filter_map(|number| number.parse().ok()).max().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    const QUIET: &str = "\
INFO: Running with entropic power schedule (0xFF, 100).
#2\tINITED cov: 812 ft: 2401 corp: 90/9Kb exec/s: 0 rss: 60Mb
#4096\tpulse  cov: 815 ft: 2410 corp: 92/9Kb lim: 130 exec/s: 2048 rss: 66Mb
Done 9000 runs in 4 second(s)
stat::number_of_executed_units: 9000
";

    const LOUD: &str = "\
#731\tNEW    cov: 12 ft: 13 corp: 2/3b exec/s: 0 rss: 60Mb

thread '<unnamed>' (7) panicked at bodies/src/version.rs:24:5:
assertion `left == right` failed
  left: Some(true)
 right: Some(false)
note: run with `RUST_BACKTRACE=1` environment variable to display a backtrace
==7== ERROR: libFuzzer: deadly signal
artifact_prefix='/x/'; Test unit written to /x/crash-0123
";

    #[test]
    fn a_run_that_finds_nothing_is_counted() {
        assert!(crash(QUIET).is_none());
        assert_eq!((executions(QUIET), edges(QUIET)), (9_000, 815));
    }

    #[test]
    fn what_is_found_is_named_with_what_the_target_said() {
        let found = crash(LOUD).unwrap();
        assert_eq!(found.input, Path::new("/x/crash-0123"));
        assert!(found.said.ends_with("right: Some(false)"), "{}", found.said);
        assert_eq!(executions(LOUD), 731);
        let slow = "==7== ERROR: libFuzzer: timeout after 21 seconds\nTest unit written to /x/timeout-9";
        assert!(crash(slow).unwrap().said.contains("timeout after"));
    }
}
