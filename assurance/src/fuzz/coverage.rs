//! Which lines of the decoders the committed corpora reach, by LLVM's source-based coverage.

use std::path::{Path, PathBuf};
use std::process::Command;

use serde::Deserialize;
use xtask::project::Project;
use xtask::setup::{self, SetupError};

use super::report::{Coverage, Lines};
use super::{BODIES, FuzzError, say};

/// The version of cargo-llvm-cov.
const CARGO_LLVM_COV: &str = "0.9.1";
/// What is to be covered, and to how many hundredths.
const FOLDERS: [&str; 2] = ["spec/src/wire/", "spec/src/bulk/"];
const ENOUGH: f64 = 95.0;

/// Replays the corpora, and nothing else, and counts the lines that ran; `false` if too few did.
///
/// # Errors
/// No LLVM tools that read what this compiler writes.
pub(super) fn measure(project: &Project, llvm_path: Option<&Path>) -> Result<(bool, Coverage), FuzzError> {
    let (cov, profdata) = llvm(llvm_path)?;
    let cargo_llvm_cov = setup::program(project, "cargo-llvm-cov", CARGO_LLVM_COV, &mut say)?;
    println!("replaying the corpora with coverage");
    let output = project.path(".tools/logs/fuzz-coverage.json");
    super::create(output.parent().unwrap_or(Path::new(".")))?;
    let output_text = output.to_string_lossy().into_owned();
    // What an earlier replay reached, of other inputs, does not count.
    let forget = ["llvm-cov", "clean", "--profraw-only"];
    let replay = ["llvm-cov", "test", "-p", BODIES, "--test", "replay", "--no-report", "--", "the_corpus_of"];
    // The one command names what runs, the other whose lines count.
    let count = ["llvm-cov", "report", "-p", "ncp-spec", "--json", "--summary-only", "--output-path", &output_text];
    for args in [&forget[..], &replay, &count] {
        let mut program = project.program(&cargo_llvm_cov, args, "");
        program.env("LLVM_COV", &cov).env("LLVM_PROFDATA", &profdata).env("CARGO_LLVM_COV_SETUP", "no");
        setup::carry_out(program)?;
    }

    let text = std::fs::read(&output).map_err(|source| FuzzError::File { path: output.clone(), source })?;
    let exported = serde_json::from_slice(&text).map_err(|source| FuzzError::Form { path: output, source })?;
    let files = lines(exported, project);
    let mut is_enough = true;
    let mut folders = Vec::new();
    for folder in FOLDERS {
        let within = || files.iter().filter(|lines| lines.place.starts_with(folder));
        let (count, covered) = (within().map(|lines| lines.count).sum(), within().map(|lines| lines.covered).sum());
        let percent = percent(count, covered);
        is_enough &= count > 0 && percent >= ENOUGH;
        println!("{folder:16} {covered:>5} of {count:>5} lines, {percent:.1} %");
        folders.push(Lines { place: folder.to_owned(), count, covered });
    }
    for Lines { place, count, covered } in &files {
        println!("  {place:36} {covered:>5} of {count:>5}");
    }
    let tool = format!("cargo-llvm-cov {CARGO_LLVM_COV}, {}", version(&cov).unwrap_or_default());
    Ok((is_enough, Coverage { tool, folders, files }))
}

pub(super) fn percent(count: u64, covered: u64) -> f64 {
    #[expect(clippy::cast_precision_loss, reason = "numbers of lines are small")]
    if count == 0 { 0.0 } else { 100.0 * covered as f64 / count as f64 }
}

/// What `llvm-cov export` writes: the members that are asked for.
#[derive(Deserialize)]
struct Exported {
    data: Vec<Data>,
}

#[derive(Deserialize)]
struct Data {
    files: Vec<File>,
}

#[derive(Deserialize)]
struct File {
    filename: String,
    summary: Summary,
}

#[derive(Deserialize)]
struct Summary {
    lines: Counts,
}

#[derive(Deserialize)]
struct Counts {
    count: u64,
    covered: u64,
}

/// The files of [`FOLDERS`], how many lines of each have code, and how many of those ran.
fn lines(exported: Exported, project: &Project) -> Vec<Lines> {
    let root = project.path("").to_string_lossy().into_owned();
    let files = exported.data.into_iter().take(1).flat_map(|data| data.files);
    let mut lines: Vec<_> = files
        .filter_map(|File { filename, summary: Summary { lines: Counts { count, covered } } }| {
            let place = filename.strip_prefix(&root)?.to_owned();
            let is_wanted = FOLDERS.iter().any(|folder| place.starts_with(folder));
            is_wanted.then_some(Lines { place, count, covered })
        })
        .collect();
    lines.sort_by(|a, b| a.place.cmp(&b.place));
    lines
}

/// llvm-cov and llvm-profdata, of the version that the compiler has in it: what `--llvm-path` names, what
/// the environment names, rustup's component, or what is on PATH.
fn llvm(llvm_path: Option<&Path>) -> Result<(PathBuf, PathBuf), SetupError> {
    let wanted = compiler_llvm().unwrap_or_default();
    let pair = |folder: &Path| (folder.join("llvm-cov"), folder.join("llvm-profdata"));
    let named = |name: &str| std::env::var_os(name).map(PathBuf::from);
    let candidates = [
        llvm_path.map(pair),
        named("LLVM_COV").zip(named("LLVM_PROFDATA")),
        sysroot_tools().as_deref().map(pair),
        Some(pair(Path::new(&format!("/usr/lib/llvm-{wanted}/bin")))),
        Some((format!("llvm-cov-{wanted}").into(), format!("llvm-profdata-{wanted}").into())),
        Some(("llvm-cov".into(), "llvm-profdata".into())),
    ];
    let fits = |(cov, profdata): &(PathBuf, PathBuf)| {
        let is = |tool| version(tool).is_some_and(|version| version.contains(&format!("version {wanted}.")));
        is(cov) && is(profdata)
    };
    candidates.into_iter().flatten().find(fits).ok_or(SetupError::Missing {
        tool: "llvm-cov of the version that `rustc -vV` names",
        remedy: "`rustup component add llvm-tools`, or Debian's package llvm-22 and --llvm-path \
                 /usr/lib/llvm-22/bin",
    })
}

/// The major version of the LLVM within rustc.
fn compiler_llvm() -> Option<String> {
    let output = Command::new("rustc").arg("-vV").output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    let version = text.lines().find_map(|line| line.strip_prefix("LLVM version: "))?;
    Some(version.split('.').next()?.to_owned())
}

fn sysroot_tools() -> Option<PathBuf> {
    let output = Command::new("rustc").args(["--print", "target-libdir"]).output().ok()?;
    let libraries = String::from_utf8(output.stdout).ok()?;
    Some(Path::new(libraries.trim()).parent()?.join("bin"))
}

/// The line in which an LLVM tool says its version.
fn version(tool: &Path) -> Option<String> {
    let output = Command::new(tool).arg("--version").output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    let line = text.lines().find(|line| line.contains("LLVM version"))?;
    Some(line.trim().to_owned())
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn only_the_lines_of_the_decoders_count() {
        let project = Project::at(Path::new("/p"));
        let file =
            |name: &str, count: u64| json!({"filename": name, "summary": {"lines": {"count": count, "covered": 3}}});
        let exported = json!({"data": [{"files": [
            file("/p/spec/src/wire/map.rs", 4), file("/p/spec/src/keys.rs", 9),
            file("/q/spec/src/wire/map.rs", 9), file("/p/spec/src/bulk/block.rs", 3),
        ]}]});
        let lines = lines(serde_json::from_value(exported).unwrap(), &project);
        let lines: Vec<_> = lines.iter().map(|Lines { place, count, covered }| (&**place, *count, *covered)).collect();
        assert_eq!(lines, [("spec/src/bulk/block.rs", 3, 3), ("spec/src/wire/map.rs", 4, 3)]);
        assert!((percent(4, 3) - 75.0).abs() < 1e-9 && percent(0, 0) == 0.0);
    }
}
