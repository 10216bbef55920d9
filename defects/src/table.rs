//! The tables of defects: `<folder>/*.toml`.

use std::collections::{BTreeMap, HashSet};
use std::path::{Path, PathBuf};
use std::{fs, io};

use serde::{Deserialize, Serialize};
use thiserror::Error;

/// One planted defect, as its file describes it.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Defect {
    /// Its name, in lower case with hyphens.
    pub name: String,
    /// The defect, in a sentence.
    pub about: String,
    /// The audited finding (`L01` …) that it brings back, `decision` for a decision that it inverts, or `classic`.
    #[serde(default = "classic")]
    pub finding: String,
    /// The rules that it breaks; whoever notices it has to name the first.
    #[serde(default)]
    pub rules: Vec<String>,
    /// Those of the rules that it breaks as directly as the first: whoever names one of them first is right, too.
    #[serde(default)]
    pub equal: Vec<String>,
    /// Further rules whose sentence it breaks on the way, and how: whoever names them blames it rightly.
    #[serde(default)]
    pub also: BTreeMap<String, String>,
    /// The properties that have to refute it.
    #[serde(default)]
    pub properties: Vec<String>,
    /// The engines that have to refute it; empty: all that know one of the properties.
    #[serde(default)]
    pub engines: Vec<String>,
    /// The fuzz targets that have to find it.
    #[serde(default)]
    pub targets: Vec<String>,
    /// The defects of its table whose edits it has, before its own.
    #[serde(default)]
    pub of: Vec<String>,
    /// What makes it: mostly one edit.
    #[serde(default)]
    pub edit: Vec<Edit>,
}

fn classic() -> String {
    "classic".to_owned()
}

/// One place that a defect changes.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Edit {
    /// The source file, from the root of the repository.
    pub file: String,
    /// Where the code stands more than once: a text that stands once, and has the code behind it.
    pub after: Option<String>,
    /// The code that is replaced.
    pub code: String,
    /// What replaces it.
    pub with: String,
    /// Whether it is made also where the defect is switched off: a declaration that changes nothing by itself.
    #[serde(default)]
    pub always: bool,
}

/// Why a table cannot be used.
#[derive(Debug, Error)]
pub enum TableError {
    /// A file or a folder cannot be read.
    #[error("{}: {source}", path.display())]
    Read {
        /// Which.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// A file is not of the form.
    #[error("{}: {source}", path.display())]
    Form {
        /// Which.
        path: PathBuf,
        /// Where it departs from the form.
        source: Box<toml::de::Error>,
    },
    /// A name stands twice.
    #[error("two defects are called {0}")]
    Repeated(String),
    /// A defect of others, of which one does not stand before it.
    #[error("{defect} is made of {part}, which does not stand before it")]
    Part {
        /// The defect's name.
        defect: String,
        /// The other's.
        part: String,
    },
}

/// Reads a file, or every file of a folder in the order of their names.
///
/// # Errors
/// A file that cannot be read or is not of the form, and a name that stands twice.
pub fn read(path: &Path) -> Result<Vec<Defect>, TableError> {
    #[derive(Deserialize)]
    #[serde(deny_unknown_fields)]
    struct File {
        defect: Vec<Defect>,
    }

    let mut defects = Vec::new();
    for path in files(path)? {
        let text = fs::read_to_string(&path).map_err(|source| TableError::Read { path: path.clone(), source })?;
        let file: File = toml::from_str(&text).map_err(|source| TableError::Form { path, source: Box::new(source) })?;
        defects.extend(file.defect);
    }
    let mut seen = HashSet::new();
    match defects.iter().find(|defect| !seen.insert(&defect.name)) {
        Some(twice) => Err(TableError::Repeated(twice.name.clone())),
        None => composed(defects),
    }
}

/// With the edits of the parts in what is made of them, each once.
fn composed(defects: Vec<Defect>) -> Result<Vec<Defect>, TableError> {
    let mut composed: Vec<Defect> = Vec::with_capacity(defects.len());
    for mut defect in defects {
        let mut edits: Vec<Edit> = Vec::new();
        for part in &defect.of {
            let found = composed.iter().find(|known| known.name == *part);
            let found = found.ok_or_else(|| TableError::Part { defect: defect.name.clone(), part: part.clone() })?;
            edits.extend(found.edit.iter().cloned());
        }
        edits.append(&mut defect.edit);
        for edit in edits {
            if !defect.edit.contains(&edit) {
                defect.edit.push(edit);
            }
        }
        composed.push(defect);
    }
    Ok(composed)
}

fn files(path: &Path) -> Result<Vec<PathBuf>, TableError> {
    if !path.is_dir() {
        return Ok(vec![path.to_owned()]);
    }
    let entries = fs::read_dir(path).and_then(Iterator::collect::<io::Result<Vec<_>>>);
    let entries = entries.map_err(|source| TableError::Read { path: path.to_owned(), source })?;
    let mut files: Vec<_> = entries.into_iter().map(|entry| entry.path()).collect();
    files.retain(|file| file.extension().is_some_and(|extension| extension == "toml"));
    files.sort();
    Ok(files)
}
