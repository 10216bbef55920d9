//! A copy of the project's sources with planted defects, each behind a switch.
//!
//! Whole crates are copied, with their places relative to each other, so that no path in them changes. A file is
//! written only where its text is another one, so that cargo builds anew what depends on it and no more.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use ncp_defects::weave::{Site, WeaveError, weave};
use ncp_defects::{Defect, TableError};
use thiserror::Error;
use xtask::project::Project;

/// Names the defect that is switched on, by its number in the table.
pub(crate) const SWITCH: &str = "NCP_DEFECT";

/// Added to every crate with a defect: whether the defect of a number is switched on.
const SWITCHED: &str = r#"
/// The planted defect that is switched on.
#[doc(hidden)]
#[allow(missing_docs, clippy::all)]
pub mod planted {
    extern crate std;
    pub fn is(number: usize) -> bool {
        static CHOSEN: std::sync::OnceLock<Option<usize>> = std::sync::OnceLock::new();
        *CHOSEN.get_or_init(|| std::env::var("NCP_DEFECT").ok()?.parse().ok()) == Some(number)
    }
}
"#;

/// Copies the files of git under some folders, and single files, into a folder of the project, with every defect woven
/// in behind a switch of its number; a `const fn` has no place for one. What an earlier copy has and this one lacks is
/// removed.
///
/// # Errors
/// A file, or a defect that does not fit.
pub(crate) fn copy(project: &Project, from: &[&str], to: &str, defects: &[Defect]) -> Result<Project, PlantedError> {
    let mut sites: BTreeMap<&str, Vec<Site<'_>>> = BTreeMap::new();
    for (number, defect) in defects.iter().enumerate() {
        for edit in &defect.edit {
            sites.entry(&edit.file).or_default().push(Site { number, name: &defect.name, edit });
        }
    }
    let roots: BTreeSet<String> = sites.keys().filter_map(|file| crate_root(file)).collect();
    let copy = project.path(to);
    let files = tracked(project, from)?;
    if let Some(file) = sites.keys().find(|file| !files.iter().any(|tracked| tracked == *file)) {
        return Err(PlantedError::NotCopied { file: (*file).to_owned() });
    }
    for file in &files {
        let path = project.path(file);
        let mut content = fs::read(&path).map_err(|source| PlantedError::File { path, source })?;
        if let Some(sites) = sites.get(file.as_str()) {
            let text = String::from_utf8_lossy(&content).replace("\r\n", "\n");
            let woven = weave(&text, "crate::planted::is", sites);
            let woven = woven.map_err(|source| PlantedError::Weave { file: file.clone(), source })?;
            content = woven.into_bytes();
        }
        if roots.contains(file) {
            content.extend_from_slice(SWITCHED.as_bytes());
        }
        save(&copy.join(file), &content)?;
    }
    remove_others(&copy, &copy, &files.into_iter().collect())?;
    Ok(Project::at(&copy))
}

/// The root module of the crate to which a file belongs.
fn crate_root(file: &str) -> Option<String> {
    let (folder, _) = file.split_once("/src/")?;
    Some(format!("{folder}/src/lib.rs"))
}

/// The files that git tracks, or would, under some paths.
fn tracked(project: &Project, under: &[&str]) -> Result<Vec<String>, PlantedError> {
    let args = ["ls-files", "-z", "--cached", "--others", "--exclude-standard", "--deduplicate", "--"];
    let output = project.program("git", &[&args[..], under].concat(), "").output();
    let output = output.map_err(|source| PlantedError::Git { said: source.to_string() })?;
    if !output.status.success() {
        return Err(PlantedError::Git { said: String::from_utf8_lossy(&output.stderr).into_owned() });
    }
    let names = String::from_utf8_lossy(&output.stdout);
    // A file that was just removed is still tracked.
    let files = names.split('\0').filter(|file| !file.is_empty() && project.path(file).is_file());
    Ok(files.map(str::to_owned).collect())
}

fn save(path: &Path, content: &[u8]) -> Result<(), PlantedError> {
    if fs::read(path).is_ok_and(|before| before == content) {
        return Ok(());
    }
    let folder = path.parent().map_or(Ok(()), fs::create_dir_all);
    let written = folder.and_then(|()| fs::write(path, content));
    written.map_err(|source| PlantedError::File { path: path.to_owned(), source })
}

/// Removes the files of a copy that are not among `files`; what cargo builds there stays.
fn remove_others(root: &Path, folder: &Path, files: &BTreeSet<String>) -> Result<(), PlantedError> {
    let failed = |source| PlantedError::File { path: folder.to_owned(), source };
    for entry in fs::read_dir(folder).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        let name = path.strip_prefix(root).unwrap_or(&path).to_string_lossy().replace('\\', "/");
        if path.is_dir() {
            if name != "target" {
                remove_others(root, &path, files)?;
            }
        } else if !files.contains(&name) {
            fs::remove_file(&path).map_err(failed)?;
        }
    }
    Ok(())
}

/// Why defects could not be planted.
#[derive(Debug, Error)]
pub(crate) enum PlantedError {
    #[error(transparent)]
    Table(#[from] TableError),
    #[error("{}: {source}", path.display())]
    File { path: PathBuf, source: io::Error },
    #[error("git ls-files: {said}")]
    Git { said: String },
    #[error("{file} has a defect, and is no file of the copy")]
    NotCopied { file: String },
    #[error("{file}: {source}")]
    Weave { file: String, source: WeaveError },
}

#[cfg(test)]
mod tests {
    use std::process::Command;

    use super::*;

    #[test]
    fn a_copy_has_the_defects_behind_their_switches_and_nothing_of_an_earlier_copy() {
        let folder = tempfile::tempdir().unwrap();
        let (root, project) = (folder.path(), Project::at(folder.path()));
        assert!(Command::new("git").arg("init").arg("-q").current_dir(root).status().unwrap().success());
        for (file, text) in [("a/src/lib.rs", "fn f() -> u8 { 1 }\n"), ("a/src/b.rs", "fn g() {}\n"), ("c.txt", "c")] {
            save(&root.join(file), text.as_bytes()).unwrap();
        }
        save(&root.join("to/a/src/old.rs"), b"old").unwrap();
        save(&root.join(".gitignore"), b"/to/\n").unwrap();
        let edit = "[[defect.edit]]\nfile = \"a/src/lib.rs\"\ncode = \"1\"\nwith = \"2\"\n";
        let table = format!("[[defect]]\nname = \"two\"\nabout = \"It is 2.\"\n{edit}");
        save(&root.join("table.toml"), table.as_bytes()).unwrap();
        let defects = ncp_defects::read(&root.join("table.toml")).unwrap();
        let copied = copy(&project, &["a"], "to", &defects).unwrap();
        let text = fs::read_to_string(copied.path("a/src/lib.rs")).unwrap();
        assert!(text.starts_with("fn f() -> u8 { (if crate::planted::is(0) { 2 } else { 1 }) }"), "{text}");
        assert!(text.contains("pub mod planted") && text.contains(SWITCH));
        assert!(copied.path("a/src/b.rs").is_file() && !copied.path("c.txt").exists());
        assert!(!copied.path("a/src/old.rs").exists());
        assert!(matches!(copy(&project, &["c.txt"], "to", &defects), Err(PlantedError::NotCopied { .. })));
    }
}
