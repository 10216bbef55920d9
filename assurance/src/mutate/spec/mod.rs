//! Mutants of the specification, made by cargo-mutants: held against the golden cases, and what these miss against the
//! tests of the crate.
//!
//! | module | what it does |
//! |---|---|
//! | `outcome` | reads what cargo-mutants leaves behind of a run |
//! | `report` | keeps what was tried, and makes the page of it |

mod outcome;
mod report;

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;

use clap::Args;
use clap::builder::PossibleValuesParser;
use xtask::project::Project;
use xtask::setup::{self, SetupError};

use self::outcome::{By, Mutant, Outcome};
use self::report::Report;
use super::{MutateError, cargo};

/// The version of cargo-mutants.
const CARGO_MUTANTS: &str = "27.1.0";
/// The crates that are mutated.
const MUTATED: [&str; 2] = [SPEC, "ncp-kernel"];
/// The crate whose tests are held against what the golden cases miss.
const SPEC: &str = "ncp-spec";
/// The crate whose one test holds a mutant against the golden cases.
const CASES: &str = "ncp-mutated";
/// Where the runs are kept, a folder a module.
const RUNS: &str = ".tools/mutate-spec";
/// The file of such a folder that holds the digest of the sources that were mutated.
const NOTE: &str = "sources.sha256";
/// A build and a test of a mutant may each take so many seconds.
const TIMEOUT: &str = "120";
/// More jobs at a time want more memory than they save time.
const MOST_JOBS: usize = 4;

/// A part of the specification whose mutants are tried together.
struct Module {
    name: &'static str,
    /// Its files, as patterns of cargo-mutants.
    files: &'static [&'static str],
    /// The cases that reach it, as patterns of `ncp-verify run --filter`. What stands after a `;` is judged
    /// only when all that stands before it passes.
    cases: &'static str,
    /// The test programs of the specification that are about it, besides its unit tests.
    tests: &'static [&'static str],
}

/// The modules, what weighs most for safety first. `.cargo/mutants.toml` names the same files.
const MODULES: [Module; 6] = [
    Module {
        name: "safety",
        files: &["spec/src/safety/**/*.rs", "spec/kernel/src/**/*.rs"],
        cases: PLANT,
        tests: &["governor", "safety_properties", "resilience"],
    },
    Module {
        name: "resilience",
        files: &["spec/src/resilience/*.rs"],
        cases: PLANT,
        tests: &["resilience", "safety_properties", "control_loop"],
    },
    Module {
        name: "bulk",
        files: &["spec/src/bulk/*.rs"],
        cases: "bulk/values/* bulk/directory/* bulk/observation/*; bulk/* session/*",
        tests: &["bulk_format", "bulk_model", "bulk_memory"],
    },
    Module { name: "wire", files: &["spec/src/wire/*.rs"], cases: FRAMES, tests: WIRE },
    Module { name: "json", files: &["spec/src/wire/json/*.rs"], cases: FRAMES, tests: WIRE },
    Module { name: "codec", files: &["spec/src/codec.rs"], cases: "codec/* control/*", tests: &["codec"] },
];

/// The cases that reach what moves a plant.
const PLANT: &str = "safety/* resilience/* control/* strict/* session/*";
/// All cases, those first that are about frames and small.
const FRAMES: &str = "wire/* hostile/s* hostile/t* hostile/e*; *";
/// The tests that are about frames.
const WIRE: &[&str] = &["wire_rules", "wire_properties", "wire_tables", "wire_memory"];

pub(super) const EXAMPLES: &str = "\
Examples:
  cargo assure mutate spec --module codec   the mutants of one module, and the report of it anew
  cargo assure mutate spec --missed         after new cases or tests: only what nothing noticed so far
  cargo assure mutate spec --check          only: is the report about the sources as they are?";

#[derive(Debug, Args)]
pub(crate) struct SpecArgs {
    /// Only this module of the specification; may be given again
    #[arg(long = "module", value_name = "NAME", value_parser = names())]
    modules: Vec<String>,
    /// Only what the last run did not see noticed
    #[arg(long)]
    missed: bool,
    /// Run nothing: report what the last runs left
    #[arg(long, conflicts_with = "missed")]
    report: bool,
    /// Run nothing: only say whether the report is about the sources as they are
    #[arg(long, conflicts_with_all = ["modules", "missed", "report"])]
    check: bool,
}

/// Has the modules mutated; `false` if a mutant is missed and not explained, an explanation is stale, or a mutant was
/// not tried.
///
/// # Errors
/// A tool that is missing, tests that fail without a mutation.
pub(crate) fn run(project: &Project, args: &SpecArgs) -> Result<bool, MutateError> {
    let mut report = Report::read(project)?;
    if !args.check {
        carry_out(project, args, &mut report)?;
        println!("{}", report.summary());
    }
    let problems = report.problems(project)?;
    problems.iter().for_each(|problem| println!("{problem}"));
    Ok(problems.is_empty())
}

fn names() -> PossibleValuesParser {
    PossibleValuesParser::new(MODULES.map(|module| module.name))
}

fn carry_out(project: &Project, args: &SpecArgs, report: &mut Report) -> Result<(), MutateError> {
    let cargo_mutants = setup::program(project, "cargo-mutants", CARGO_MUTANTS, &mut say)?;
    let verifier = if args.report {
        None
    } else {
        let verifier = verifier(project)?;
        limit_memory();
        conforms_unmutated(project, &verifier)?;
        Some(verifier)
    };
    let is_wanted = |module: &&Module| args.modules.is_empty() || args.modules.iter().any(|name| name == module.name);
    for module in MODULES.iter().filter(is_wanted) {
        let mutated = report::mutated(project, module)?;
        let run = Run { project, cargo_mutants: &cargo_mutants, module, folder: project.path(RUNS).join(module.name) };
        match &verifier {
            Some(verifier) => run.carry_out(verifier, &mutated, args.missed)?,
            None if !run.is_kept(&mutated) => continue,
            None => {}
        }
        report.ran(project, module, &run.list()?, &run.outcomes()?)?;
        report.write(project)?;
    }
    Ok(())
}

/// Builds the verifier, as it is without a mutation, and returns its path.
fn verifier(project: &Project) -> Result<PathBuf, SetupError> {
    say("building ncp-verify");
    let build = ["build", "--quiet", "--release", "-p", "ncp-verifier", "--message-format", "json-render-diagnostics"];
    let failed = |output: String| SetupError::Failed {
        command: "cargo build --release -p ncp-verifier".to_owned(),
        status: "an error".to_owned(),
        output,
    };
    let output = project.cargo(&build).output();
    let output = output.map_err(|error| failed(error.to_string()))?;
    let program = cargo::program(&cargo::lines(&output.stdout), "ncp-verify");
    program.ok_or_else(|| failed(String::from_utf8_lossy(&output.stderr).into_owned()))
}

/// Holds the specification as it is against the golden cases: else every mutant would seem to be noticed.
fn conforms_unmutated(project: &Project, verifier: &Path) -> Result<(), SetupError> {
    say("the golden cases without a mutation");
    let test = ["test", "--quiet", "--profile", "mutants", "-p", CASES, "--test", "cases"];
    let mut cargo = project.cargo(&test);
    cargo.env("NCP_VERIFIER", verifier).env("NCP_CASES", "*");
    setup::carry_out(cargo)
}

/// A mutant may ask for memory without end.
fn limit_memory() {
    #[cfg(target_os = "linux")]
    {
        use rustix::process::{Resource, Rlimit, setrlimit};
        const LIMIT: Option<u64> = Some(8 << 30);
        let limit = Rlimit { current: LIMIT, maximum: LIMIT };
        if let Err(error) = setrlimit(Resource::As, limit) {
            println!("the memory of mutants is not limited: {error}");
        }
    }
}

/// Runs of cargo-mutants over a module.
struct Run<'a> {
    project: &'a Project,
    cargo_mutants: &'a Path,
    module: &'a Module,
    /// Where they are kept.
    folder: PathBuf,
}

impl Run<'_> {
    /// Tries the mutants of the module, or those that were missed so far: by the golden cases, and what
    /// these miss by the tests.
    fn carry_out(&self, verifier: &Path, mutated: &str, missed: bool) -> Result<(), MutateError> {
        let Module { name, cases, tests, .. } = *self.module;
        // Of other sources nothing is kept: the lines in the names of their mutants mean others now.
        let missed = missed && self.is_kept(mutated);
        if !missed {
            fs::remove_dir_all(&self.folder).ok();
            let made = fs::create_dir_all(&self.folder);
            made.and_then(|()| fs::write(self.folder.join(NOTE), mutated)).map_err(|source| self.no_file(source))?;
        }

        println!("{name}: the golden cases");
        let mut first = self.command();
        first.args(["--test-package", CASES, "-C=--test", "-C=cases"]);
        // cargo-mutants would try the tests of the mutated crate itself without a mutation.
        first.args(["--baseline", "skip"]);
        first.env("NCP_VERIFIER", verifier).env("NCP_CASES", cases);
        if missed {
            first.arg("--iterate");
        }
        self.stage(first, By::Cases)?;
        if !self.outcomes()?.iter().any(Outcome::is_missed) {
            return Ok(());
        }

        println!("{name}: the tests of {SPEC}");
        let mut other = self.command();
        other.args(["--iterate", "--test-package", SPEC, "-C=--lib"]);
        for test in tests {
            other.args(["-C=--test".to_owned(), format!("-C={test}")]);
        }
        self.stage(other, By::Tests)
    }

    /// Whether what the last run left is about the sources as they are.
    fn is_kept(&self, mutated: &str) -> bool {
        let noted = fs::read_to_string(self.folder.join(NOTE));
        noted.is_ok_and(|noted| noted == mutated)
    }

    /// The mutants of the module.
    fn list(&self) -> Result<Vec<Mutant>, MutateError> {
        let output = self.command().args(["--list", "--json"]).output();
        let output = output.map_err(|source| self.not_started(source))?;
        outcome::listed(&output.stdout).ok_or_else(|| self.broken("--list"))
    }

    /// cargo-mutants, for this module.
    fn command(&self) -> Command {
        let mut command = self.project.program(self.cargo_mutants, &["mutants"], "");
        // Every job has a folder for what it builds.
        command.env_remove("CARGO_TARGET_DIR");
        command.args(MUTATED.iter().flat_map(|package| ["--package", package])).args(["--timeout", TIMEOUT]);
        let jobs = std::thread::available_parallelism().map_or(1, usize::from);
        command.arg("--jobs").arg(jobs.min(MOST_JOBS).to_string());
        // Its options that choose add to the files of its configuration, or let some mutants through.
        let others = MODULES.iter().filter(|other| other.name != self.module.name);
        command.args(others.flat_map(|other| other.files).flat_map(|files| ["--exclude", files]));
        command.arg("--output").arg(&self.folder);
        command
    }

    /// Runs it, and keeps what it tells.
    fn stage(&self, mut command: Command, by: By) -> Result<(), MutateError> {
        let status = command.status();
        let status = status.map_err(|source| self.not_started(source))?;
        // It tells by 2 that mutants were missed, and by 3 that they took too long.
        if !matches!(status.code(), Some(0 | 2 | 3)) {
            return Err(self.broken(&status.to_string()));
        }
        let told = self.folder.join("mutants.out/outcomes.json");
        let kept = self.folder.join(by.file(self.stages()?.len()));
        let copied = fs::copy(told, kept);
        copied.map(|_| ()).map_err(|source| self.no_file(source))
    }

    /// The files of the stages, in their order.
    fn stages(&self) -> Result<Vec<(By, PathBuf)>, MutateError> {
        let entries = fs::read_dir(&self.folder).map_err(|source| self.no_file(source))?;
        let mut files: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
        files.sort();
        let stage = |file: PathBuf| Some((By::of_file(file.file_name()?.to_str()?)?, file));
        Ok(files.into_iter().filter_map(stage).collect())
    }

    /// How the mutants fared, after all stages.
    fn outcomes(&self) -> Result<Vec<Outcome>, MutateError> {
        let mut outcomes = Vec::new();
        for (by, path) in self.stages()? {
            let text = fs::read(&path).map_err(|source| self.no_file(source))?;
            let told = outcome::told(&text, by).map_err(|source| MutateError::Outcomes { path, source })?;
            outcomes = outcome::updated(outcomes, told);
        }
        Ok(outcomes)
    }

    fn no_file(&self, source: io::Error) -> MutateError {
        MutateError::File { path: self.folder.clone(), source }
    }

    fn not_started(&self, source: io::Error) -> MutateError {
        MutateError::File { path: self.cargo_mutants.to_owned(), source }
    }

    fn broken(&self, status: &str) -> MutateError {
        MutateError::Setup(SetupError::Failed {
            command: format!("cargo mutants, for the module {}", self.module.name),
            status: status.to_owned(),
            output: format!("{RUNS}/{}/mutants.out has its logs", self.module.name),
        })
    }
}

fn say(line: &str) {
    println!("{line}");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_stages_of_a_run_are_read_in_their_order() {
        let folder = tempfile::tempdir().unwrap();
        let run = Run {
            project: &Project::at(folder.path()),
            cargo_mutants: Path::new("cargo-mutants"),
            module: &MODULES[0],
            folder: folder.path().to_owned(),
        };
        let told = |summary: &str| {
            format!(
                r#"{{"start_time":"2026-01-02T03:04:05Z","end_time":"2026-01-02T03:04:06Z","outcomes":
                [{{"scenario":{{"Mutant":{{"name":"a"}}}},"summary":{summary:?}}}]}}"#
            )
        };
        for (nth, by, summary) in
            [(10, By::Tests, "CaughtMutant"), (0, By::Cases, "MissedMutant"), (9, By::Tests, "MissedMutant")]
        {
            fs::write(folder.path().join(by.file(nth)), told(summary)).unwrap();
        }
        fs::write(folder.path().join("notes.txt"), "").unwrap();
        let outcomes = run.outcomes().unwrap();
        assert_eq!(outcomes.len(), 1);
        assert_eq!(outcomes[0].fate, outcome::Fate::CaughtBy(By::Tests));
    }

    #[test]
    fn the_configuration_names_the_files_of_the_modules() {
        let project = Project::at(Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap());
        let config = fs::read_to_string(project.path(".cargo/mutants.toml")).unwrap();
        let files: Vec<&str> = MODULES.iter().flat_map(|module| module.files).copied().collect();
        for pattern in &files {
            assert!(config.contains(&format!("{pattern:?}")), "{pattern}");
        }
        assert_eq!(config.matches("\"spec/").count(), files.len());
    }
}
