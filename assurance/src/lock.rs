//! What git keeps of what a command found: `reports/lock/<artefact>.toml`, short enough to be reviewed.
//!
//! The long reports are made by the command, into a folder that git ignores.

use std::collections::BTreeMap;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

use serde::de::DeserializeOwned;
use serde::ser::Error as _;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use thiserror::Error;
use toml::ser;

/// Where the locks are, from the root of the project.
pub(crate) const FOLDER: &str = "reports/lock";

/// What was found, and of which sources.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Lock {
    /// The digest that each source had.
    #[serde(default)]
    pub(crate) sources: BTreeMap<String, String>,
    /// How many came to which end.
    #[serde(default)]
    pub(crate) counts: BTreeMap<String, u64>,
    /// What became of each, by its id.
    #[serde(default)]
    pub(crate) fates: BTreeMap<String, String>,
    /// What is wrong with what was found; empty where all is as it has to be.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(crate) problems: Vec<String>,
    /// The rules that a proved claim shows, by the claim's id.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub(crate) rules: BTreeMap<String, Vec<String>>,
    /// The engines of proofs that found it.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub(crate) engines: BTreeMap<String, Prover>,
    /// How far the engines go with a claim, by its id.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub(crate) claims: BTreeMap<String, Scope>,
    /// How much an engine asked of a claim, by engine and id.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub(crate) asked: BTreeMap<String, Asked>,
}

/// An engine of the proofs.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Prover {
    pub(crate) version: String,
    /// What it does, in a sentence.
    pub(crate) about: String,
    /// The digest of the library whose machine code it explored.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) library_sha256: Option<String>,
    /// What it does not show.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(crate) not_proved: Vec<String>,
}

/// How far a claim goes.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Scope {
    pub(crate) family: String,
    /// Within what it is claimed.
    pub(crate) bounds: String,
    /// What Coq says that it rests on, of a theorem.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub(crate) rests_on: String,
    /// What is assumed, beside what is trusted.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(crate) assumptions: Vec<String>,
}

/// How much was asked of a claim.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Asked {
    /// Paths, states, inputs or runs: whatever the engine counts.
    pub(crate) cases: u64,
    /// Questions that went to a solver.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) questions: Option<u64>,
    /// Those of them whose answer is the same with every operation and comparison of doubles uninterpreted.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) without_arithmetic: Option<u64>,
}

/// What every lock has, whatever else it keeps.
#[derive(Debug, Default, Deserialize)]
pub(crate) struct Standing {
    /// The digest that each source had.
    #[serde(default)]
    pub(crate) sources: BTreeMap<String, String>,
    /// What is wrong with what was found.
    #[serde(default)]
    pub(crate) problems: Vec<String>,
}

/// Why a lock cannot be read or written.
#[derive(Debug, Error)]
pub(crate) enum LockError {
    #[error("{}: {source}", path.display())]
    File { path: PathBuf, source: io::Error },
    #[error("{}: {source}", path.display())]
    Form { path: PathBuf, source: Box<toml::de::Error> },
    #[error("the lock of {name} cannot be written: {source}")]
    Write { name: String, source: ser::Error },
}

impl Lock {
    /// The lock of an artefact; none where nothing was ever made.
    ///
    /// # Errors
    /// A lock that cannot be read.
    pub(crate) fn read(root: &Path, name: &str) -> Result<Option<Self>, LockError> {
        read(root, name)
    }

    /// Writes the lock of an artefact.
    ///
    /// # Errors
    /// It cannot be written.
    pub(crate) fn write(&self, root: &Path, name: &str) -> Result<(), LockError> {
        let text = text(name, self)?;
        let path = path(root, name);
        let made = path.parent().map_or(Ok(()), fs::create_dir_all).and_then(|()| fs::write(&path, text));
        made.map_err(|source| LockError::File { path, source })
    }
}

/// Where a lock is.
pub(crate) fn path(root: &Path, name: &str) -> PathBuf {
    root.join(FOLDER).join(format!("{name}.toml"))
}

/// A lock of any form.
///
/// # Errors
/// One that is there and cannot be read.
pub(crate) fn read<T: DeserializeOwned>(root: &Path, name: &str) -> Result<Option<T>, LockError> {
    let path = path(root, name);
    match fs::read_to_string(&path) {
        Ok(text) => {
            toml::from_str(&text).map(Some).map_err(|source| LockError::Form { path, source: Box::new(source) })
        }
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
        Err(source) => Err(LockError::File { path, source }),
    }
}

/// The text of a lock: a line for each entry, so that a change is easily read.
///
/// # Errors
/// What TOML cannot hold.
pub(crate) fn text<T: Serialize>(name: &str, lock: &T) -> Result<String, LockError> {
    let unfit = |source| LockError::Write { name: name.to_owned(), source };
    // As a value of JSON, it keeps its order.
    let body: serde_json::Map<String, Value> = serde_json::to_value(lock)
        .map(without_nulls)
        .and_then(serde_json::from_value)
        .map_err(|source| unfit(ser::Error::custom(source)))?;
    let (mut lines, mut sections) = (Vec::new(), Vec::new());
    for (section, content) in &body {
        let Value::Object(entries) = content else {
            lines.push(line(section, content).map_err(unfit)?);
            continue;
        };
        sections.push(format!("\n[{section}]"));
        for (key, value) in entries {
            sections.push(line(key, value).map_err(unfit)?);
        }
    }
    let lines = [lines, sections].concat().join("\n");
    Ok(format!("# Written by cargo assure: what was found last, and of which sources.\n\n{}\n", lines.trim_start()))
}

/// TOML has no null: what would be one is left out.
fn without_nulls(value: Value) -> Value {
    match value {
        Value::Object(members) => {
            let there = members.into_iter().filter(|(_, member)| !member.is_null());
            Value::Object(there.map(|(name, member)| (name, without_nulls(member))).collect())
        }
        Value::Array(items) => Value::Array(items.into_iter().map(without_nulls).collect()),
        other => other,
    }
}

/// An entry as a line: what an inline table of it holds between its braces.
fn line(key: &str, value: &Value) -> Result<String, ser::Error> {
    let mut table = String::new();
    BTreeMap::from([(key, value)]).serialize(ser::ValueSerializer::new(&mut table))?;
    let entry = table.strip_prefix("{ ").and_then(|rest| rest.strip_suffix(" }"));
    Ok(entry.unwrap_or(&table).to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lock_is_read_as_it_was_written() {
        let root = tempfile::tempdir().unwrap();
        let one = |key: &str, value: &str| BTreeMap::from([(key.to_owned(), value.to_owned())]);
        let lock = Lock {
            sources: one("spec/src", "0123456789abcdef"),
            counts: BTreeMap::from([("proved".to_owned(), 1)]),
            fates: one("symbolic clamp/bound", "proved"),
            problems: vec!["clamp/tick: no engine proves it".to_owned()],
            rules: BTreeMap::from([("clamp/bound".to_owned(), vec!["NCP-SAFE-001".to_owned()])]),
            claims: BTreeMap::from([("clamp/bound".to_owned(), Scope { bounds: "3".to_owned(), ..Scope::default() })]),
            ..Lock::default()
        };
        assert_eq!(Lock::read(root.path(), "proofs").unwrap(), None);
        lock.write(root.path(), "proofs").unwrap();
        assert_eq!(Lock::read(root.path(), "proofs").unwrap(), Some(lock));
    }

    #[test]
    fn each_lock_of_the_project_is_written_as_it_stands() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let names = fs::read_dir(root.join(FOLDER)).unwrap().map(|entry| entry.unwrap().path());
        let names = names.map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned());
        let mut seen = 0;
        // Some have a form of their own.
        for (name, lock) in names.filter_map(|name| Lock::read(&root, &name).ok()?.map(|lock| (name, lock))) {
            assert_eq!(text(&name, &lock).unwrap(), fs::read_to_string(path(&root, &name)).unwrap(), "{name}");
            seen += 1;
        }
        assert!(seen > 5, "{seen}");
    }

    #[test]
    fn a_lock_of_another_form_is_refused_with_its_path() {
        let root = tempfile::tempdir().unwrap();
        Lock::default().write(root.path(), "fuzz").unwrap();
        fs::write(path(root.path(), "fuzz"), "counts = 1\n").unwrap();
        let error = Lock::read(root.path(), "fuzz").unwrap_err().to_string();
        assert!(error.contains("fuzz.toml"), "{error}");
    }
}
