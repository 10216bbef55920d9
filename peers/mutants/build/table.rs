//! The table of mutants: `mutants/*.toml`.

use std::collections::HashSet;
use std::path::Path;
use std::{fs, io};

use serde::Deserialize;
use thiserror::Error;

/// One mutant, as its file describes it.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Mutant {
    /// Its name, in lower case with hyphens.
    pub(crate) name: String,
    /// The defect, in a sentence.
    pub(crate) about: String,
    /// The audited finding (`L01` …) that it brings back, `decision` for a decision that it inverts, or `classic`.
    pub(crate) finding: String,
    /// The rules that it breaks; the suite must name the first.
    pub(crate) rules: Vec<String>,
    /// What makes it: mostly one edit.
    pub(crate) edit: Vec<Edit>,
}

/// One place that a mutant changes.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Edit {
    /// The source file, from the root of the repository.
    pub(crate) file: String,
    /// Where the code stands more than once: a text that stands once, and has the code behind it.
    pub(crate) after: Option<String>,
    /// The expression that is replaced.
    pub(crate) code: String,
    /// What replaces it.
    pub(crate) with: String,
}

/// Why the table cannot be used.
#[derive(Debug, Error)]
pub(crate) enum TableError {
    #[error("{file}: {source}")]
    Read { file: String, source: io::Error },
    #[error("{file}: {message}")]
    Form { file: String, message: String },
    #[error("two mutants are called {0}")]
    Repeated(String),
}

/// Reads every file of the folder, in the order of their names.
///
/// # Errors
/// A file that cannot be read or is not of this form, and a name that stands twice.
pub(crate) fn read(folder: &Path) -> Result<Vec<Mutant>, TableError> {
    #[derive(Deserialize)]
    #[serde(deny_unknown_fields)]
    struct File {
        mutant: Vec<Mutant>,
    }

    let unreadable = |file: &Path, source| TableError::Read { file: file.display().to_string(), source };
    let mut paths = fs::read_dir(folder)
        .and_then(|entries| entries.map(|entry| Ok(entry?.path())).collect::<io::Result<Vec<_>>>())
        .map_err(|source| unreadable(folder, source))?;
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "toml"));
    paths.sort();
    let mut mutants = Vec::new();
    for path in paths {
        let text = fs::read_to_string(&path).map_err(|source| unreadable(&path, source))?;
        let file: File = toml::from_str(&text)
            .map_err(|error| TableError::Form { file: path.display().to_string(), message: error.to_string() })?;
        mutants.extend(file.mutant);
    }
    let mut seen = HashSet::new();
    match mutants.iter().find(|mutant| !seen.insert(&mutant.name)) {
        Some(twice) => Err(TableError::Repeated(twice.name.clone())),
        None => Ok(mutants),
    }
}
