//! The proofs: sets the solvers up, runs the engines, and says whether the report is about the sources.

use std::ffi::OsString;
use std::fs;
use std::path::Path;
use std::thread;
use std::time::Instant;

use serde_json::Value;

use crate::Error;
use xtask::project::Project;
use xtask::setup;

use crate::digest;

/// Whether the machine code of this machine can be explored.
const RUNS_MACHINE: bool = cfg!(all(target_os = "linux", target_arch = "x86_64"));
/// What the first stage finds out about the kernel, for the second.
const KERNEL: &str = ".tools/proofs-kernel.json";
const REPORT: &str = "reports/proofs.json";
/// Where the engines that are programs of their own leave their results.
const MACHINE: &str = ".tools/machine.json";
const MODEL: &str = ".tools/model.json";
const READERS: &str = ".tools/readers.json";

/// Runs the engines; `false` if a property is not proved or a broken kernel not refuted.
///
/// # Errors
/// The solvers cannot be set up, or a program cannot be started.
pub(crate) fn run(project: &Project, args: &[&str]) -> Result<bool, Error> {
    let is_wanted_machine = RUNS_MACHINE && (args.is_empty() || args.contains(&"machine"));
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
fn engines(project: &Project, args: &[&str], angr: impl FnOnce() -> bool) -> Result<bool, Error> {
    let is_wanted = |engine: &str| args.is_empty() || args.contains(&engine);
    let began = Instant::now();
    let part = |what: &str| {
        let seconds = began.elapsed().as_secs();
        println!("\n[{}:{:02}] {what}", seconds / 60, seconds % 60);
    };
    part("the solvers");
    setup::solvers(project, &mut |line| println!("{line}"))?;
    // First the kernel itself, without the broken ones: whoever has changed it wants to hear that at once.
    forget(project, KERNEL);
    for (engine, file) in [("model", MODEL), ("machine", MACHINE)] {
        if is_wanted(engine) {
            forget(project, file);
        }
    }
    let program = |options: &[&str], stage: &str| {
        let start = ["run", "--quiet", "--release", "-p", "ncp-proofs"];
        project.cargo(&[&start[..], options, &["--", "--stage", stage], args].concat())
    };
    part("the kernel: on values, on samples, and for all doubles by the solvers");
    if !start(program(&[], "kernel"))? {
        return Ok(false);
    }
    let mut good = true;
    if is_wanted("model") {
        part("the protocol over a bad network, by model checking");
        let words = ["run", "--quiet", "--release", "-p", "ncp-model", "--"];
        good &= start(project.cargo(&[&words[..], &["--json", MODEL]].concat()))?;
    }
    if is_wanted("readers") {
        part("what reads blocks, versions and keys, on every input within the bounds");
        forget(project, READERS);
        let program = ["-p", "ncp-readers", "--features", "broken", "--"];
        let words = [&["run", "--quiet", "--release"], &program[..]].concat();
        good &= start(project.cargo(&[&words[..], &["--json", READERS]].concat()))?;
    }
    if is_wanted("machine") {
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
fn machine(project: &Project, angr: impl FnOnce() -> bool) -> Result<bool, Error> {
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

fn start(mut command: std::process::Command) -> Result<bool, Error> {
    let status = command.status().map_err(|source| Error::File { path: command.get_program().into(), source })?;
    Ok(status.success())
}

/// What is wrong with the report: missing, or about other sources.
pub(crate) fn stale(project: &Project) -> Vec<String> {
    stale_at(&project.path("")).err().map(|why| format!("{REPORT}: {why}; cargo xtask prove")).into_iter().collect()
}

fn stale_at(root: &Path) -> Result<(), String> {
    let text = fs::read_to_string(root.join(REPORT)).map_err(|error| error.to_string())?;
    let report: Value = serde_json::from_str(&text).map_err(|error| error.to_string())?;
    let now = digest::of(root).map_err(|error| error.to_string())?;
    if report["digest"] != now.as_str() {
        return Err("the kernel or its harnesses have changed since they were proved".to_owned());
    }
    match report["problems"].as_array() {
        Some(problems) if problems.is_empty() => Ok(()),
        Some(problems) => Err(format!("not everything is shown: {problems:?}")),
        None => Err("it does not say whether everything is shown".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_change_of_the_kernel_makes_the_report_stale() {
        let folder = tempfile::tempdir().unwrap();
        let root = folder.path();
        for source in digest::ARTEFACTS.iter().flat_map(|artefact| artefact.sources) {
            let source = root.join(source);
            if source.extension().is_none() {
                fs::create_dir_all(source).unwrap();
                continue;
            }
            fs::create_dir_all(source.parent().unwrap()).unwrap();
            fs::write(source, "").unwrap();
        }
        for folder in ["spec/kernel/src/decisions", "reports"] {
            fs::create_dir_all(root.join(folder)).unwrap();
        }
        let kernel = root.join("spec/kernel/src/decisions/speed.rs");
        fs::write(&kernel, "a.le(b)").unwrap();
        assert!(stale_at(root).unwrap_err().contains("No such file"));

        let digest = digest::of(root).unwrap();
        let report = |problems: &str| {
            let text = format!("{{\"digest\":{digest:?},\"problems\":{problems}}}");
            fs::write(root.join(REPORT), text).unwrap();
        };
        report("[\"clamp/bound: no engine proves it\"]");
        assert!(stale_at(root).unwrap_err().contains("clamp/bound"));
        report("[]");
        assert_eq!(stale_at(root), Ok(()));
        fs::write(&kernel, "a.lt(b)").unwrap();
        assert!(stale_at(root).unwrap_err().contains("have changed"));
    }
}
