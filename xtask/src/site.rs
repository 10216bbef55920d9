//! `cargo xtask site`: the project's public site, made from its sources.

use std::path::{self, Path};
use std::process::Command;

use crate::project::Project;
use crate::setup::{self, SetupError};

/// Where the site is made, unless somewhere else is named.
const MADE: &str = "reports/site";
/// What shows each rule, as `cargo assure trace` finds it: the site leads from each rule to all of it.
const MATRIX: &str = ".tools/site/matrix.json";

/// Makes the site, and says where.
///
/// # Errors
/// The generator cannot be installed, or does not succeed.
pub(crate) fn make(project: &Project, output: Option<&Path>) -> Result<(), SetupError> {
    let mut say = |line: &str| println!("{line}");
    setup::site(project, &mut say)?;
    say("tracing every rule to what shows it");
    setup::carry_out(matrix(project))?;
    say("making the pages");
    let absolute =
        |path: &Path| path::absolute(path).map_err(|source| SetupError::File { path: path.to_owned(), source });
    let folder = output.map_or_else(|| Ok(project.path(MADE)), absolute)?;
    let mut npm = project.program(setup::NPM, &["run", "build", "--silent", "--", "--quiet"], "site");
    npm.arg(format!("--output={}", folder.display()));
    setup::carry_out(npm)?;
    let shown = output.unwrap_or(Path::new(MADE)).join("index.html");
    println!("site: {}", shown.display());
    Ok(())
}

/// Writes the matrix of rules and evidence, from which pages are made.
pub(crate) fn matrix(project: &Project) -> Command {
    let assure = ["run", "--quiet", "--profile", "verify", "-p", "ncp-assurance", "--"];
    project.cargo(&[&assure[..], &["trace", "--matrix", MATRIX]].concat())
}
