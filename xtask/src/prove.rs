//! The proofs: sets the solvers up, runs the engines, and says whether the report is about the sources.

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::Error;
use crate::project::Project;
use crate::setup;

#[allow(unreachable_pub, reason = "the file belongs to the proofs, too")]
#[path = "../../proofs/src/digest.rs"]
mod digest;

const REPORT: &str = "reports/proofs.json";

/// Runs the engines; `false` if a property is not proved or a broken kernel not refuted.
///
/// # Errors
/// The solvers cannot be set up, or the program cannot be started.
pub(crate) fn run(project: &Project, args: &[&str]) -> Result<bool, Error> {
    setup::solvers(project, &mut |line| println!("{line}"))?;
    let program = ["run", "--quiet", "--release", "-p", "ncp-proofs", "--features", "broken", "--"];
    let mut cargo = project.cargo(&[&program[..], args].concat());
    let status = cargo.status().map_err(|source| Error::File {
        path: project.path("proofs"),
        source,
    })?;
    Ok(status.success())
}

/// What is wrong with the report: missing, or about other sources.
pub(crate) fn stale(project: &Project) -> Vec<String> {
    stale_at(&project.path(""))
        .err()
        .map(|why| format!("{REPORT}: {why}; cargo xtask prove"))
        .into_iter()
        .collect()
}

fn stale_at(root: &Path) -> Result<(), String> {
    let text = fs::read_to_string(root.join(REPORT)).map_err(|error| error.to_string())?;
    let report: Value = serde_json::from_str(&text).map_err(|error| error.to_string())?;
    let now = digest::of(root).map_err(|error| error.to_string())?;
    if report["digest"] == now.as_str() {
        Ok(())
    } else {
        Err("the kernel or its harnesses have changed since they were proved".to_owned())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_change_of_the_kernel_makes_the_report_stale() {
        let folder = tempfile::tempdir().unwrap();
        let root = folder.path();
        for folder in ["spec/src/safety/kernel", "proofs/src", "reports"] {
            fs::create_dir_all(root.join(folder)).unwrap();
        }
        fs::write(root.join("proofs/broken.rs"), "").unwrap();
        let kernel = root.join("spec/src/safety/kernel/speed.rs");
        fs::write(&kernel, "a.le(b)").unwrap();
        assert!(stale_at(root).unwrap_err().contains("No such file"));

        let digest = digest::of(root).unwrap();
        fs::write(root.join(REPORT), format!("{{\"digest\":{digest:?}}}")).unwrap();
        assert_eq!(stale_at(root), Ok(()));
        fs::write(&kernel, "a.lt(b)").unwrap();
        assert!(stale_at(root).unwrap_err().contains("have changed"));
    }
}
