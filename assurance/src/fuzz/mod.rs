//! The fuzz targets: built once, run side by side, measured.
//!
//! - `engine`: which toolchain and sanitizer there are, and how targets are built and started.
//! - `coverage`: which lines of the decoders the corpora reach.
//! - `report`: `reports/fuzz.json`, and the page that is made of it.

mod coverage;
mod engine;
mod report;

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::Duration;

use serde_json::Value;

use crate::Error;
use engine::{Engine, Run};
use report::Report;
use xtask::project::Project;
use xtask::setup::{self, SetupError};

/// What each target checks, and the replay of the corpora.
const BODIES: &str = "ncp-fuzz-bodies";
const CORPUS: &str = "fuzz/corpus";
/// The most inputs of a committed corpus, unless more of them stay whatever they reach: it is replayed
/// with every change.
const MOST_INPUTS: usize = 120;
/// Within this every planted bug has to be found.
const PLANTED_LIMIT: Duration = Duration::from_secs(120);

/// Carries out `cargo xtask fuzz`; `false` if something was found, or a planted bug was not.
///
/// # Errors
/// A wrong command line, a tool that is missing, a build that fails.
pub(crate) fn run(project: &Project, args: &[&str]) -> Result<bool, Error> {
    let options = Options::parse(args)?;
    if options.mode == Mode::Replay {
        let replay = ["test", "--quiet", "-p", BODIES];
        let status = project.cargo(&replay).status();
        return Ok(status.is_ok_and(|status| status.success()));
    }
    let mut targets = targets(project)?;
    if let Some(unknown) = options.targets.iter().find(|name| !targets.iter().any(|t| t.name == **name)) {
        let names: Vec<_> = targets.iter().map(|target| target.name.as_str()).collect();
        return Err(usage(&format!("`{unknown}` is no target; there are {}", names.join(", "))));
    }
    targets.retain(|target| options.targets.is_empty() || options.targets.contains(&target.name));
    let mut report = Report::read(project, &targets);
    let right = match options.mode {
        Mode::Coverage => coverage::measure(project, options.llvm_path.as_deref(), &mut report)?,
        Mode::Minimise => minimise(project, &options, &targets)?,
        Mode::Fuzz => fuzz(project, &options, &targets, &mut report)?,
        Mode::Planted => planted(project, &options, &targets, &mut report)?,
        Mode::Replay => true,
    };
    if options.report {
        report.write(project)?;
    }
    Ok(right)
}

/// A target, as `ncp-fuzz list --json` has it.
struct Target {
    name: String,
    finds: String,
    planted: String,
}

#[derive(Debug, PartialEq, Eq)]
struct Options {
    mode: Mode,
    time: Duration,
    targets: Vec<String>,
    /// The stable toolchain without a sanitizer, whatever there is.
    stable: bool,
    llvm_path: Option<PathBuf>,
    /// Write what was measured into `reports/`.
    report: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Mode {
    Fuzz,
    Replay,
    Planted,
    Coverage,
    Minimise,
}

impl Options {
    fn parse(mut args: &[&str]) -> Result<Self, Error> {
        let mut options = Self {
            mode: Mode::Fuzz,
            time: Duration::from_secs(30),
            targets: Vec::new(),
            stable: false,
            llvm_path: None,
            report: false,
        };
        loop {
            args = match args {
                [] => return Ok(options),
                ["--time", time, rest @ ..] => {
                    options.time = seconds(time)?;
                    rest
                }
                ["--target", name, rest @ ..] => {
                    options.targets.push((*name).to_owned());
                    rest
                }
                ["--llvm-path", path, rest @ ..] => {
                    options.llvm_path = Some(PathBuf::from(path));
                    rest
                }
                ["--stable", rest @ ..] => {
                    options.stable = true;
                    rest
                }
                ["--report", rest @ ..] => {
                    options.report = true;
                    rest
                }
                [mode, rest @ ..] => {
                    options.mode = match *mode {
                        "--replay" => Mode::Replay,
                        "--planted" => Mode::Planted,
                        "--coverage" => Mode::Coverage,
                        "--minimise" => Mode::Minimise,
                        other => return Err(usage(&format!("`{other}` is no option of `fuzz`"))),
                    };
                    rest
                }
            };
        }
    }
}

/// Fuzzes each target for a while, from its corpus on.
fn fuzz(project: &Project, options: &Options, targets: &[Target], report: &mut Report) -> Result<bool, Error> {
    let engine = Engine::find(project, options.stable, &mut say)?;
    engine.build(project, false, &mut say)?;
    println!("{engine}, {} s a target", options.time.as_secs());
    let runs = side_by_side(targets, |target| {
        let run = engine.fuzz(project, &target.name, options.time)?;
        show(target, &run);
        Ok(run)
    })?;
    let found: Vec<_> = targets.iter().zip(&runs).filter(|(_, run)| run.crash.is_some()).collect();
    for (target, run) in &found {
        explain(project, target, run);
    }
    let executions: u64 = runs.iter().map(|run| run.executions).sum();
    println!("{} targets, {} executions, {} found something", runs.len(), grouped(executions), found.len());
    let right = found.is_empty();
    report.ran(&engine, targets, &runs);
    Ok(right)
}

/// Runs each target against a build with a bug for it, until it is found.
fn planted(project: &Project, options: &Options, targets: &[Target], report: &mut Report) -> Result<bool, Error> {
    let engine = Engine::find(project, options.stable, &mut say)?;
    engine.build(project, true, &mut say)?;
    println!("{engine}, with a planted bug a target, at most {} s each", PLANTED_LIMIT.as_secs());
    let runs = side_by_side(targets, |target| {
        let run = engine.hunt(project, &target.name, PLANTED_LIMIT)?;
        let verdict = match (&run.crash, run.from_corpus) {
            (None, _) => "NOT FOUND",
            (Some(_), true) => "found by the corpus",
            (Some(_), false) => "found",
        };
        println!(
            "{:20} {verdict:20} {:>6.1} s {:>12} executions   {}",
            target.name,
            run.seconds,
            grouped(run.executions),
            target.planted
        );
        Ok(run)
    })?;
    let missed = runs.iter().filter(|run| run.crash.is_none()).count();
    println!("{} planted bugs, {missed} not found", runs.len());
    report.hunted(&engine, targets, &runs);
    Ok(missed == 0)
}

/// Makes each corpus anew: the fewest of its inputs, the seeds and what fuzzing left behind that reach
/// what all of them reach.
fn minimise(project: &Project, options: &Options, targets: &[Target]) -> Result<bool, Error> {
    let engine = Engine::find(project, options.stable, &mut say)?;
    engine.build(project, false, &mut say)?;
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
            bytes += fs::copy(input, &to).map_err(|source| Error::File { path: to, source })?;
        }
        println!("{name:20} {:>5} inputs, {bytes:>8} bytes", inputs.len());
        Ok(())
    })?;
    Ok(true)
}

/// The targets that there are.
fn targets(project: &Project) -> Result<Vec<Target>, Error> {
    let mut cargo = project.cargo(&["run", "--quiet", "-p", BODIES, "--", "list", "--json"]);
    let failed = |output: String| SetupError::Failed {
        command: "ncp-fuzz list --json".to_owned(),
        status: "an error".to_owned(),
        output,
    };
    let output = cargo.output().map_err(|error| failed(error.to_string()))?;
    let listed: Value = serde_json::from_slice(&output.stdout)
        .map_err(|_| failed(String::from_utf8_lossy(&output.stderr).into_owned()))?;
    let text = |target: &Value, name: &str| target[name].as_str().unwrap_or_default().to_owned();
    let targets = listed.as_array().into_iter().flatten().map(|target| Target {
        name: text(target, "name"),
        finds: text(target, "finds"),
        planted: text(target, "planted"),
    });
    Ok(targets.collect())
}

/// Does something for every target, on as many threads as there are processors.
fn side_by_side<T: Send>(
    targets: &[Target],
    work: impl Fn(&Target) -> Result<T, Error> + Sync,
) -> Result<Vec<T>, Error> {
    let workers = std::thread::available_parallelism().map_or(1, usize::from);
    let waiting = Mutex::new(targets.iter().enumerate());
    let done = Mutex::new(Vec::new());
    let locked = std::sync::PoisonError::into_inner;
    std::thread::scope(|scope| {
        for _ in 0..workers.min(targets.len()) {
            scope.spawn(|| {
                loop {
                    let next = waiting.lock().unwrap_or_else(locked).next();
                    let Some((nth, target)) = next else { break };
                    let result = work(target);
                    done.lock().unwrap_or_else(std::sync::PoisonError::into_inner).push((nth, result));
                }
            });
        }
    });
    let mut done = done.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
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
         keep it        mend the specification, copy the input to {CORPUS}/{name}/, and write what `show`\n                 \
         prints as a case of vectors/src, so that every peer is asked too\n",
        indented(&crash.said),
        run.log.display(),
    );
}

fn say(line: &str) {
    println!("{line}");
}

fn usage(what: &str) -> Error {
    Error::Usage { what: what.to_owned() }
}

/// A time such as `30s`, `2m` or `30`.
fn seconds(text: &str) -> Result<Duration, Error> {
    let (digits, factor) = match text.strip_suffix('m') {
        Some(minutes) => (minutes, 60),
        None => (text.strip_suffix('s').unwrap_or(text), 1),
    };
    match digits.parse::<u64>() {
        Ok(count) if count > 0 && count < 1 << 32 => Ok(Duration::from_secs(count * factor)),
        _ => Err(usage(&format!("`{text}` is no time; one such as 30s or 5m is meant"))),
    }
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

fn create(folder: &Path) -> Result<(), Error> {
    fs::create_dir_all(folder).map_err(|source| Error::File { path: folder.to_owned(), source })
}

fn remove(file: &Path) -> Result<(), Error> {
    fs::remove_file(file).map_err(|source| Error::File { path: file.to_owned(), source })
}

/// The files of a folder, sorted; none of a folder that is not there.
fn files(folder: &Path) -> Result<Vec<PathBuf>, Error> {
    if !folder.is_dir() {
        return Ok(Vec::new());
    }
    let failed = |source| Error::File { path: folder.to_owned(), source };
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
    use super::*;

    #[test]
    fn options_are_read_in_any_order() {
        let options = Options::parse(&["--target", "keys", "--time", "2m", "--report", "--target", "codec"]);
        let options = options.unwrap();
        assert_eq!(options.targets, ["keys", "codec"]);
        assert_eq!((options.time, options.mode, options.report), (Duration::from_secs(120), Mode::Fuzz, true));
        assert_eq!(Options::parse(&["--planted"]).unwrap().mode, Mode::Planted);
        for wrong in [&["--time"][..], &["--time", "0s"], &["--time", "soon"], &["keys"]] {
            assert!(matches!(Options::parse(wrong), Err(Error::Usage { .. })), "{wrong:?}");
        }
    }

    #[test]
    fn numbers_are_grouped_by_thousands() {
        assert_eq!([0, 999, 1_000, 1_234_567].map(grouped), ["0", "999", "1,000", "1,234,567"]);
    }

    #[test]
    fn every_target_is_done_once_and_an_error_is_told() {
        let target = |name: &str| Target { name: name.to_owned(), finds: String::new(), planted: String::new() };
        let targets = ["a", "b", "c", "d", "e"].map(target);
        let names = side_by_side(&targets, |target| Ok(target.name.clone())).unwrap();
        assert_eq!(names, ["a", "b", "c", "d", "e"]);
        let failed = side_by_side(&targets, |target| if target.name == "c" { Err(usage("no")) } else { Ok(()) });
        assert!(failed.is_err());
    }
}
