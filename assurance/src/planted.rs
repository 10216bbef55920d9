//! A copy of the project's sources with planted defects, each behind a switch.
//!
//! Files keep their places relative to each other, so that no path in them changes. A file is written only where its
//! text is another one, so that cargo builds anew what depends on it and no more.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use ncp_defects::weave::{Site, WeaveError, weave};
use ncp_defects::{Defect, TableError};
use ncp_verifier::peer::StartError;
use thiserror::Error;
use walkdir::WalkDir;
use xtask::project::Project;

/// Names the defect that is switched on in a copy of [`copy`], by its number in the table.
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

/// What becomes of a file of the copy, by its name and its text with the defects; nothing leaves it out.
pub(crate) type Revise<'a> = dyn Fn(&str, String) -> Result<Option<String>, PlantedError> + 'a;

/// A copy to be made.
pub(crate) struct Copy<'a> {
    /// The folders and files of which all that git tracks is copied.
    pub(crate) from: Vec<String>,
    /// The folder that it is copied into.
    pub(crate) to: PathBuf,
    /// The path of the function that says whether the defect of a number is switched on.
    pub(crate) switch: &'a str,
    pub(crate) revise: &'a Revise<'a>,
    /// Files of the copy's own, with their texts.
    pub(crate) own: Vec<(String, String)>,
}

/// Copies the files of git under some folders, and single files, into a folder of the project, with every defect woven
/// in behind a switch of its number, which the environment names; a `const fn` has no place for one.
///
/// # Errors
/// A file, or a defect that does not fit.
pub(crate) fn copy(project: &Project, from: &[&str], to: &str, defects: &[Defect]) -> Result<Project, PlantedError> {
    let files = defects.iter().flat_map(|defect| &defect.edit).map(|edit| &*edit.file);
    let roots: BTreeSet<String> = files.filter_map(crate_root).collect();
    let from = from.iter().map(|path| (*path).to_owned()).collect();
    let revise = |file: &str, text: String| Ok(Some(if roots.contains(file) { text + SWITCHED } else { text }));
    let to = project.path(to);
    Copy { from, to: to.clone(), switch: "crate::planted::is", revise: &revise, own: Vec::new() }
        .make(project, defects)?;
    Ok(Project::at(&to))
}

impl Copy<'_> {
    /// Brings it up to date. What an earlier copy has and this one lacks is removed, but for what cargo builds there.
    ///
    /// # Errors
    /// A file, or a defect that does not fit.
    pub(crate) fn make(&self, project: &Project, defects: &[Defect]) -> Result<(), PlantedError> {
        let mut sites: BTreeMap<&str, Vec<Site<'_>>> = BTreeMap::new();
        for (number, defect) in defects.iter().enumerate() {
            for edit in &defect.edit {
                sites.entry(&edit.file).or_default().push(Site { number, name: &defect.name, edit });
            }
        }
        let mut files = BTreeSet::new();
        for file in tracked(project, &self.from)? {
            let path = project.path(&file);
            let bytes = fs::read(&path).map_err(|source| PlantedError::File { path, source })?;
            let copied = match String::from_utf8(bytes) {
                Ok(text) => match sites.remove(file.as_str()) {
                    Some(sites) => {
                        let woven = weave(&text.replace("\r\n", "\n"), self.switch, &sites);
                        woven.map_err(|source| PlantedError::Weave { file: file.clone(), source })?
                    }
                    None => text,
                },
                Err(binary) => {
                    files.insert(self.save(&file, binary.as_bytes())?);
                    continue;
                }
            };
            if let Some(text) = (self.revise)(&file, copied)? {
                files.insert(self.save(&file, text.as_bytes())?);
            }
        }
        if let Some((file, sites)) = sites.first_key_value() {
            let defects = sites.iter().map(|site| site.name).collect::<Vec<_>>().join(", ");
            return Err(PlantedError::NotCopied { file: (*file).to_owned(), defects });
        }
        for (file, text) in &self.own {
            files.insert(self.save(file, text.as_bytes())?);
        }
        self.remove_others(&files)
    }

    /// Writes a file if it differs.
    fn save(&self, file: &str, content: &[u8]) -> Result<PathBuf, PlantedError> {
        let path = self.to.join(file);
        if !fs::read(&path).is_ok_and(|before| before == content) {
            let written = path.parent().map_or(Ok(()), fs::create_dir_all).and_then(|()| fs::write(&path, content));
            written.map_err(|source| PlantedError::File { path: path.clone(), source })?;
        }
        Ok(path)
    }

    fn remove_others(&self, files: &BTreeSet<PathBuf>) -> Result<(), PlantedError> {
        let is_own = |path: &Path| path != self.to.join("target");
        for entry in WalkDir::new(&self.to).into_iter().filter_entry(|entry| is_own(entry.path())) {
            let path = match entry {
                Ok(entry) if entry.file_type().is_file() => entry.into_path(),
                _ => continue,
            };
            if !files.contains(&path) {
                fs::remove_file(&path).map_err(|source| PlantedError::File { path, source })?;
            }
        }
        Ok(())
    }
}

/// The root module of the crate to which a file belongs.
fn crate_root(file: &str) -> Option<String> {
    let (folder, _) = file.split_once("/src/")?;
    Some(format!("{folder}/src/lib.rs"))
}

/// The files that git tracks, or would, under some paths.
fn tracked(project: &Project, under: &[String]) -> Result<Vec<String>, PlantedError> {
    let args = ["ls-files", "-z", "--cached", "--others", "--exclude-standard", "--deduplicate", "--"];
    let output = project.program("git", &args, "").args(under).output();
    let output = output.map_err(|source| PlantedError::Git { said: source.to_string() })?;
    if !output.status.success() {
        return Err(PlantedError::Git { said: String::from_utf8_lossy(&output.stderr).trim().to_owned() });
    }
    let names = String::from_utf8_lossy(&output.stdout);
    // A file that was just removed is still tracked.
    let files = names.split_terminator('\0').filter(|file| project.path(file).is_file());
    Ok(files.map(str::to_owned).collect())
}

/// Why defects could not be planted.
#[derive(Debug, Error)]
pub(crate) enum PlantedError {
    #[error(transparent)]
    Table(#[from] TableError),
    #[error("{}: {source}", path.display())]
    File { path: PathBuf, source: io::Error },
    #[error("{}: {source}", path.display())]
    Form { path: PathBuf, source: Box<toml::de::Error> },
    #[error("the copy of {file} cannot be written: {source}")]
    Manifest { file: String, source: toml::ser::Error },
    #[error("git ls-files: {said}")]
    Git { said: String },
    #[error("{file} has a defect, and is no file of the copy: {defects}")]
    NotCopied { file: String, defects: String },
    #[error("{file}: {source}")]
    Weave { file: String, source: WeaveError },
    #[error("{peer} does not depend on {needed}")]
    Independent { peer: &'static str, needed: &'static str },
    #[error(transparent)]
    Build(#[from] StartError),
}

#[cfg(test)]
mod tests {
    use std::process::Command;

    use super::*;

    #[test]
    fn a_copy_has_the_defects_behind_their_switches_and_nothing_of_an_earlier_copy() {
        let folder = tempfile::tempdir().unwrap();
        let (root, project) = (folder.path(), Project::at(folder.path()));
        let write = |file: &str, text: &str| {
            fs::create_dir_all(root.join(file).parent().unwrap()).unwrap();
            fs::write(root.join(file), text).unwrap();
        };
        assert!(Command::new("git").arg("init").arg("-q").current_dir(root).status().unwrap().success());
        for (file, text) in [("a/src/lib.rs", "fn f() -> u8 { 1 }\n"), ("a/src/b.rs", "fn g() {}\n"), ("c.txt", "c")] {
            write(file, text);
        }
        write("to/a/src/old.rs", "old");
        write(".gitignore", "/to/\n");
        let edit = "[[defect.edit]]\nfile = \"a/src/lib.rs\"\ncode = \"1\"\nwith = \"2\"\n";
        let table = format!("[[defect]]\nname = \"two\"\nabout = \"It is 2.\"\n{edit}");
        write("table.toml", &table);
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
