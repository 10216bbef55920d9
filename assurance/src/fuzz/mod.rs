//! The fuzz targets: built once, run side by side, measured.
//!
//! | module | what it does |
//! |---|---|
//! | `engine` | which toolchain and sanitizer there are, and how targets are built and started |
//! | `coverage` | which lines of the decoders the corpora reach |
//! | `report` | keeps what was measured, and makes the page of it |

mod coverage;
mod engine;
mod report;

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

use clap::Args;
use ncp_defects::{Defect, TableError};
use serde::Deserialize;
use thiserror::Error;
use xtask::project::Project;
use xtask::setup::{self, SetupError};

use self::engine::{Engine, Run};
use self::report::Report;
use crate::lock::LockError;
use crate::planted::{self, PlantedError};
use crate::reports::ReportError;

/// What each target checks, and the replay of the corpora.
const BODIES: &str = "ncp-fuzz-bodies";
const CORPUS: &str = "fuzz/corpus";
/// What the targets have to find.
const DEFECTS: &str = "defects/fuzz.toml";
/// Where the sources with these defects are, and what of the project is there.
const COPY: &str = ".tools/planted-fuzz";
const COPIED: [&str; 13] = [
    "Cargo.toml",
    "proto",
    "schemas",
    "spec",
    "vectors/corpus",
    "vectors/MANIFEST.sha256",
    "vectors/findings.toml",
    "vectors/flags.toml",
    "verifier",
    "fuzz/Cargo.toml",
    "fuzz/Cargo.lock",
    "fuzz/bodies",
    "fuzz/fuzz_targets",
];
/// The most inputs of a committed corpus, unless more of them stay whatever they reach: it is replayed with every
/// change.
const MOST_INPUTS: usize = 120;
/// Within this every planted defect has to be found.
const PLANTED_LIMIT: Duration = Duration::from_secs(120);

pub(crate) const EXAMPLES: &str = "\
Examples:
  cargo assure fuzz                                       all targets, 30 seconds each
  cargo assure fuzz --target bulk_decode --time 10m
  cargo assure fuzz --replay                              the committed inputs, without a fuzzer
  cargo assure fuzz --planted --report                    does each target find its planted defects?
  cargo assure fuzz --coverage --llvm-path /usr/lib/llvm-22/bin";

#[derive(Debug, Args)]
pub(crate) struct FuzzArgs {
    /// Only this target; may be given again
    #[arg(long = "target", value_name = "NAME")]
    targets: Vec<String>,
    /// How long each target is fuzzed: 30s, 10m
    #[arg(long, value_name = "TIME", default_value = "30s", value_parser = seconds)]
    time: Duration,
    /// Only replay the committed inputs, without a fuzzer
    #[arg(long, group = "mode", conflicts_with_all = ["targets", "report"])]
    replay: bool,
    /// Hunt planted defects: each has to be found within two minutes by the targets that its table names
    #[arg(long, group = "mode")]
    planted: bool,
    /// Count the lines of the decoders that the committed inputs reach
    #[arg(long, group = "mode")]
    coverage: bool,
    /// Make the corpora anew, of themselves, the vectors, and what was learned
    #[arg(long, group = "mode", conflicts_with = "report")]
    minimise: bool,
    /// Build with the stable toolchain and no sanitizer, even if there is a nightly one
    #[arg(long)]
    stable: bool,
    /// Where llvm-cov and llvm-profdata are
    #[arg(long, value_name = "FOLDER", requires = "coverage")]
    llvm_path: Option<PathBuf>,
    /// Write what was measured into reports/
    #[arg(long)]
    report: bool,
}

/// Drives the targets; `false` if something was found, a planted defect was not, or too few lines are reached.
///
/// # Errors
/// A target that there is not, a tool that is missing, a build that fails.
pub(crate) fn run(project: &Project, args: &FuzzArgs) -> Result<bool, FuzzError> {
    if args.replay {
        let status = project.cargo(&["test", "--quiet", "-p", BODIES]).status();
        let start = |source| SetupError::Start { command: format!("cargo test -p {BODIES}"), source };
        return Ok(status.map_err(start)?.success());
    }
    let targets = targets(project, &args.targets)?;
    let defects = ncp_defects::read(&project.path(DEFECTS))?;
    let mut report = Report::read(project, &targets)?;
    let is_right = if args.coverage {
        let (is_enough, coverage) = coverage::measure(project, args.llvm_path.as_deref())?;
        report.covered(coverage);
        is_enough
    } else if args.minimise {
        minimise(project, args, &targets)?
    } else if args.planted {
        hunt(project, args, &targets, &defects, &mut report)?
    } else {
        fuzz(project, args, &targets, &mut report)?
    };
    if args.report {
        report.write(project, &defects)?;
    }
    Ok(is_right)
}

/// A target, as `ncp-fuzz list --json` has it.
#[derive(Debug, Deserialize)]
struct Target {
    name: String,
    finds: String,
}

/// A target that has to find a planted defect.
struct Hunt<'d> {
    /// Its number in the table.
    number: usize,
    defect: &'d Defect,
    target: &'d str,
}

/// Fuzzes each target for a while, from its corpus on.
fn fuzz(project: &Project, args: &FuzzArgs, targets: &[Target], report: &mut Report) -> Result<bool, FuzzError> {
    let engine = Engine::find(project, args.stable, &mut say)?;
    engine.build(project, &mut say)?;
    println!("{engine}, {} s a target", args.time.as_secs());
    let runs = side_by_side(targets, |target| {
        let run = engine.fuzz(project, &target.name, args.time)?;
        show(target, &run);
        Ok(run)
    })?;
    let found: Vec<_> = runs.iter().filter(|(_, run)| run.crash.is_some()).collect();
    for (target, run) in &found {
        explain(project, target, run);
    }
    let executions: u64 = runs.iter().map(|(_, run)| run.executions).sum();
    println!("{} targets, {} executions, {} found something", runs.len(), grouped(executions), found.len());
    let is_right = found.is_empty();
    report.ran(&engine, &runs);
    Ok(is_right)
}

/// Runs targets against a build with the planted defects, each with the one that it has to find.
fn hunt(
    project: &Project,
    args: &FuzzArgs,
    targets: &[Target],
    defects: &[Defect],
    report: &mut Report,
) -> Result<bool, FuzzError> {
    let is_wanted = |name: &str| targets.iter().any(|target| target.name == name);
    let hunts = defects
        .iter()
        .enumerate()
        .flat_map(|(number, defect)| defect.targets.iter().map(move |target| Hunt { number, defect, target }));
    let hunts: Vec<Hunt<'_>> = hunts.filter(|hunt| is_wanted(hunt.target)).collect();
    let engine = Engine::find(project, args.stable, &mut say)?.of_the_copy();
    engine.build(&planted::copy(project, &COPIED, COPY, defects)?, &mut say)?;
    println!("{engine}, one planted defect at a time, at most {} s each", PLANTED_LIMIT.as_secs());
    let runs = side_by_side(&hunts, |hunt| {
        let run = engine.hunt(project, hunt, PLANTED_LIMIT)?;
        let verdict = match (&run.crash, run.from_corpus) {
            (None, _) => "NOT FOUND",
            (Some(_), true) => "found by the corpus",
            (Some(_), false) => "found",
        };
        println!(
            "{:20} {verdict:20} {:>6.1} s {:>12} executions   {}",
            hunt.target,
            run.seconds,
            grouped(run.executions),
            hunt.defect.about
        );
        Ok(run)
    })?;
    let missed = runs.iter().filter(|(_, run)| run.crash.is_none()).count();
    println!("{} planted defects, {missed} not found", runs.len());
    report.hunted(&engine, &runs);
    Ok(missed == 0)
}

/// Makes each corpus anew: the fewest of its inputs, the seeds and what fuzzing left behind that reach
/// what all of them reach.
fn minimise(project: &Project, args: &FuzzArgs, targets: &[Target]) -> Result<bool, FuzzError> {
    let engine = Engine::find(project, args.stable, &mut say)?;
    engine.build(project, &mut say)?;
    let seeds = engine.folder("seeds");
    let seed = ["run", "--quiet", "-p", BODIES, "--", "seed", &seeds.to_string_lossy()];
    setup::carry_out(project.cargo(&seed))?;
    side_by_side(targets, |target| {
        let name = &target.name;
        let kept = project.path(CORPUS).join(name);
        create(&kept)?;
        let merged = engine.merge(project, name, &[&kept, &seeds.join("all").join(name), &engine.work(name)])?;
        for file in files(&kept)? {
            remove(&file)?;
        }
        // libFuzzer writes first what reaches most that nothing before it reached.
        let mut inputs = files(&merged)?;
        inputs.sort_by_key(|file| file.metadata().and_then(|file| file.modified()).ok());
        let rules = files(&seeds.join("rules").join(name))?;
        inputs.truncate(MOST_INPUTS.saturating_sub(rules.len()).max(MOST_INPUTS / 3));
        inputs.extend(rules);
        let mut bytes = 0;
        for input in &inputs {
            let to = kept.join(input.file_name().unwrap_or_default());
            bytes += fs::copy(input, &to).map_err(|source| FuzzError::File { path: to, source })?;
        }
        println!("{name:20} {:>5} inputs, {bytes:>8} bytes", inputs.len());
        Ok(())
    })?;
    Ok(true)
}

/// The targets that there are, or those of them that are wanted.
fn targets(project: &Project, wanted: &[String]) -> Result<Vec<Target>, FuzzError> {
    let mut cargo = project.cargo(&["run", "--quiet", "-p", BODIES, "--", "list", "--json"]);
    let failed = |output: String| SetupError::Failed {
        command: "ncp-fuzz list --json".to_owned(),
        status: "an error".to_owned(),
        output,
    };
    let output = cargo.output().map_err(|error| failed(error.to_string()))?;
    let mut targets: Vec<Target> = serde_json::from_slice(&output.stdout)
        .map_err(|_| failed(String::from_utf8_lossy(&output.stderr).into_owned()))?;
    if let Some(unknown) = wanted.iter().find(|name| !targets.iter().any(|target| target.name == **name)) {
        let known = targets.into_iter().map(|target| target.name).collect();
        return Err(FuzzError::NoTarget { name: unknown.clone(), known });
    }
    targets.retain(|target| wanted.is_empty() || wanted.contains(&target.name));
    Ok(targets)
}

/// Does something for every item, on as many threads as there are processors.
fn side_by_side<'i, I: Sync, T: Send>(
    items: &'i [I],
    work: impl Fn(&'i I) -> Result<T, FuzzError> + Sync,
) -> Result<Vec<(&'i I, T)>, FuzzError> {
    let workers = std::thread::available_parallelism().map_or(1, usize::from);
    let waiting = Mutex::new(items.iter().enumerate());
    let done = Mutex::new(Vec::new());
    std::thread::scope(|scope| {
        for _ in 0..workers.min(items.len()) {
            scope.spawn(|| {
                loop {
                    let next = waiting.lock().unwrap_or_else(PoisonError::into_inner).next();
                    let Some((nth, item)) = next else { break };
                    let result = work(item).map(|result| (item, result));
                    done.lock().unwrap_or_else(PoisonError::into_inner).push((nth, result));
                }
            });
        }
    });
    let mut done = done.into_inner().unwrap_or_else(PoisonError::into_inner);
    done.sort_by_key(|(nth, _)| *nth);
    done.into_iter().map(|(_, result)| result).collect()
}

fn show(target: &Target, run: &Run) {
    let state = if run.crash.is_some() { "FOUND" } else { "ok" };
    println!(
        "{state:6} {:20} {:>12} executions {:>7} edges {:>6.1} s",
        target.name,
        grouped(run.executions),
        run.edges,
        run.seconds
    );
}

/// Says what was found, where it lies, and what to do with it.
fn explain(project: &Project, target: &Target, run: &Run) {
    let (name, Some(crash)) = (&target.name, &run.crash) else {
        return;
    };
    let file = crash.input.strip_prefix(project.path("")).unwrap_or(&crash.input).display().to_string();
    println!(
        "\n{name} found something:\n{}\n  the input      {file}\n  its log        {}\n  \
         read it        cargo run -p {BODIES} -- show {name} {file}\n  \
         once more      cargo run -p {BODIES} -- replay {name} {file}\n  \
         shorten it     cargo fuzz tmin {name} {file}   (in fuzz/)\n  \
         keep it        mend the specification, copy the input to {CORPUS}/{name}/, and write what\n                 \
         `show` prints as a case of vectors/, so that every peer is asked too\n",
        indented(&crash.said),
        run.log.display(),
    );
}

fn say(line: &str) {
    println!("{line}");
}

/// A time such as `30s`, `2m` or `30`.
fn seconds(text: &str) -> Result<Duration, NoTime> {
    let (digits, factor) = match text.strip_suffix('m') {
        Some(minutes) => (minutes, 60),
        None => (text.strip_suffix('s').unwrap_or(text), 1),
    };
    match digits.parse::<u64>() {
        Ok(count) if count > 0 && count < 1 << 32 => Ok(Duration::from_secs(count * factor)),
        _ => Err(NoTime),
    }
}

/// A word is no time.
#[derive(Debug, Error)]
#[error("a time such as 30s or 5m is meant")]
struct NoTime;

/// Why the targets could not be driven.
#[derive(Debug, Error)]
pub(crate) enum FuzzError {
    #[error("`{name}` is no target; there are {}", known.join(", "))]
    NoTarget { name: String, known: Vec<String> },
    #[error(transparent)]
    Setup(#[from] SetupError),
    #[error(transparent)]
    Lock(#[from] LockError),
    #[error(transparent)]
    Report(#[from] ReportError),
    #[error(transparent)]
    Table(#[from] TableError),
    #[error(transparent)]
    Planted(#[from] PlantedError),
    #[error("{}: {source}", path.display())]
    File { path: PathBuf, source: io::Error },
    #[error("{}: {source}", path.display())]
    Form { path: PathBuf, source: serde_json::Error },
}

/// A number with commas between its thousands.
fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut shown = String::new();
    for (nth, digit) in digits.chars().enumerate() {
        if nth > 0 && (digits.len() - nth).is_multiple_of(3) {
            shown.push(',');
        }
        shown.push(digit);
    }
    shown
}

fn indented(text: &str) -> String {
    text.lines().map(|line| format!("  | {line}\n")).collect::<String>().trim_end().to_owned()
}

fn create(folder: &Path) -> Result<(), FuzzError> {
    fs::create_dir_all(folder).map_err(|source| FuzzError::File { path: folder.to_owned(), source })
}

fn remove(file: &Path) -> Result<(), FuzzError> {
    fs::remove_file(file).map_err(|source| FuzzError::File { path: file.to_owned(), source })
}

/// The files of a folder, sorted; none of a folder that is not there.
fn files(folder: &Path) -> Result<Vec<PathBuf>, FuzzError> {
    if !folder.is_dir() {
        return Ok(Vec::new());
    }
    let failed = |source| FuzzError::File { path: folder.to_owned(), source };
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        if path.is_file() {
            found.push(path);
        }
    }
    found.sort();
    Ok(found)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use clap::Parser;

    use super::*;

    #[derive(Debug, Parser)]
    struct Cli {
        #[command(flatten)]
        args: FuzzArgs,
    }

    fn parsed(words: &[&str]) -> Result<FuzzArgs, clap::Error> {
        Cli::try_parse_from([&["fuzz"], words].concat()).map(|cli| cli.args)
    }

    #[test]
    fn options_are_read_in_any_order_and_modes_exclude_each_other() {
        let args = parsed(&["--target", "keys", "--time", "2m", "--report", "--target", "codec"]).unwrap();
        assert_eq!(args.targets, ["keys", "codec"]);
        assert_eq!((args.time, args.report), (Duration::from_secs(120), true));
        assert!(parsed(&["--planted", "--report"]).unwrap().planted);
        let wrong = [&["--time"][..], &["--time", "0s"], &["--time", "soon"], &["keys"], &["--planted", "--coverage"]];
        for wrong in wrong {
            assert!(parsed(wrong).is_err(), "{wrong:?}");
        }
    }

    #[test]
    fn every_target_has_a_planted_defect_and_every_defect_a_target() {
        let project = Project::at(Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap());
        let targets = files(&project.path("fuzz/fuzz_targets")).unwrap();
        let targets: BTreeSet<_> = targets.iter().map(|file| file.file_stem().unwrap().to_str().unwrap()).collect();
        let defects = ncp_defects::read(&project.path(DEFECTS)).unwrap();
        let hunted: BTreeSet<_> = defects.iter().flat_map(|defect| &defect.targets).map(String::as_str).collect();
        assert_eq!(hunted, targets);
        assert!(defects.iter().all(|defect| !defect.targets.is_empty()));
    }

    #[test]
    fn numbers_are_grouped_by_thousands() {
        assert_eq!([0, 999, 1_000, 1_234_567].map(grouped), ["0", "999", "1,000", "1,234,567"]);
    }

    #[test]
    fn every_item_is_done_once_and_an_error_is_told() {
        let items = ["a", "b", "c", "d", "e"];
        let done = side_by_side(&items, |item| Ok(item.to_uppercase())).unwrap();
        assert!(done.iter().map(|(item, done)| (**item, done.as_str())).eq([
            ("a", "A"),
            ("b", "B"),
            ("c", "C"),
            ("d", "D"),
            ("e", "E")
        ]));
        let no = || FuzzError::NoTarget { name: "c".to_owned(), known: Vec::new() };
        assert!(side_by_side(&items, |item| if *item == "c" { Err(no()) } else { Ok(()) }).is_err());
    }
}
