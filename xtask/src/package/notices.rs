//! The licences of the packages that are built into the program, as each brings them along.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use serde_json::Value;

use super::{PackageError, files};
use xtask::project::{self, Project};

/// Their names, licences and the texts of these, for the program on this machine.
pub(super) fn of_program(project: &Project) -> Result<String, PackageError> {
    let tree = ["tree", "-p", "ncp-verifier", "-e", "normal", "--prefix", "none", "--format", "{p}"];
    let built_in: BTreeSet<(String, String)> = printed(project, &tree)?
        .lines()
        .filter_map(|line| {
            let mut words = line.split(' ');
            Some((words.next()?.to_owned(), words.next()?.trim_start_matches('v').to_owned()))
        })
        .collect();
    let metadata = printed(project, &["metadata", "--format-version", "1"])?;
    let wrong =
        |error: serde_json::Error| PackageError::Json { what: "cargo metadata".to_owned(), message: error.to_string() };
    let metadata: Value = serde_json::from_str(&metadata).map_err(wrong)?;
    let text = |package: &Value, member: &str| package[member].as_str().unwrap_or_default().to_owned();
    let mut packages = BTreeMap::new();
    for package in metadata["packages"].as_array().into_iter().flatten() {
        let id = (text(package, "name"), text(package, "version"));
        // A package without a source is our own.
        if !package["source"].is_null() && built_in.contains(&id) {
            packages.insert(id, (text(package, "license"), text(package, "manifest_path")));
        }
    }
    let mut out = "ncp-verify is built with these packages, under these licences.\n".to_owned();
    for ((name, version), (licence, manifest)) in packages {
        out += &format!("\n{:=<100}\n{name} {version}: {licence}\n", "");
        for file in files(Path::new(&manifest).parent().unwrap_or(Path::new("")))? {
            let name = file.file_name().unwrap_or_default().to_string_lossy().to_ascii_uppercase();
            let is_licence =
                ["LICENSE", "LICENCE", "COPYING", "NOTICE", "COPYRIGHT"].iter().any(|of| name.starts_with(of));
            // The Apache licence is the one that stands beside this file; its text says nothing of the package.
            if is_licence && !name.contains("APACHE") && file.is_file() {
                let text = fs::read(&file).map_err(|source| PackageError::File { path: file.clone(), source })?;
                out += &format!("\n{}\n", String::from_utf8_lossy(&text).trim());
            }
        }
    }
    Ok(out)
}

/// What cargo prints.
fn printed(project: &Project, args: &[&str]) -> Result<String, PackageError> {
    let mut cargo = project.cargo(args);
    let shown = project::shown(&cargo);
    let failed = |why: String| PackageError::Build(format!("{shown}: {why}"));
    let output = cargo.output().map_err(|error| failed(error.to_string()))?;
    if !output.status.success() {
        return Err(failed(String::from_utf8_lossy(&output.stderr).into_owned()));
    }
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}
