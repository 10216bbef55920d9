//! The gate of a release: what has to hold of a tree before it goes out, held against what went out before.
//!
//! A gate is a [table of rows](ROWS). Each asks one question of the tree, by code of its own or by a command of the
//! project, and says what is wrong, where, and what to do. All of it is one [`GateReport`], which `report` renders.
//!
//! | module | what it does |
//! |---|---|
//! | `model` | the result: rows, findings, and whether the gate is open |
//! | `against` | what went out before: a tag, a folder, an image, or the baseline |
//! | `rows` | the one table of rows, and what carries each out |
//! | `identity` | wire version and contract hash, by the policy of chapter 2 |
//! | `corpus` | the cases, which stay as they were frozen |
//! | `peers` | what a run over the bundled peers says |
//! | `tools` | programs, which end when the gate is told to |

mod against;
mod corpus;
mod identity;
mod model;
mod peers;
mod rows;
mod tools;

use std::io;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant, SystemTime};

pub use against::Kind;
pub use model::{Against, Finding, GateReport, RowReport, RowState, Verdict};
pub use rows::{ROWS, Row};

use crate::stop::Stop;
use against::Base;
use rows::{Found, Unrun};
use tools::{Scratch, Tools};

/// What a gate is asked.
#[derive(Debug, Clone, Default)]
pub struct Asked {
    /// A git ref, a folder or an image; none: the latest tag, and without one the baseline.
    pub against: Option<String>,
    /// Only these rows; none: all.
    pub only: Vec<String>,
    /// But for these.
    pub skip: Vec<String>,
    /// The rows that need not be run for the gate to be open.
    pub allow_missing: Vec<String>,
}

/// Why a gate cannot be asked at all.
#[derive(Debug, thiserror::Error)]
pub enum GateError {
    /// Nothing at or above the folder has a contract and a text.
    #[error("there is no folder with proto/ncp.proto and spec/text at or above this one: a gate is that of a tree")]
    NoTree,
    /// `--against` names nothing.
    #[error("--against {0}: neither a folder nor a file, and no commit of git")]
    NoSuch(String),
    /// What went out before holds no contract.
    #[error("--against {name}: it has no {what}")]
    Lacks {
        /// What was asked for.
        name: String,
        /// What it lacks.
        what: &'static str,
    },
    /// A program that reads what went out before did not succeed.
    #[error("{command}: {output}")]
    Program {
        /// The program and its arguments.
        command: String,
        /// What it said.
        output: String,
    },
    /// A file cannot be read or written.
    #[error("{}: {source}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// A file is not of its form.
    #[error("{}: {problem}", path.display())]
    Form {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        problem: String,
    },
    /// Everything is to end.
    #[error("interrupted")]
    Interrupted,
}

/// The tree of a folder: the nearest at or above it with a contract and a text.
///
/// # Errors
/// There is none.
pub fn root(from: &Path) -> Result<PathBuf, GateError> {
    let is_tree = |folder: &&Path| folder.join(PROTO).is_file() && folder.join(TEXT).is_dir();
    from.ancestors().find(is_tree).map(Path::to_owned).ok_or(GateError::NoTree)
}

/// Asks every row of a tree, each in its turn, and tells the listener when one begins and ends.
///
/// # Errors
/// What the tree is to be held against cannot be read. What is wrong with the tree is in the report.
pub fn ask(root: &Path, asked: &Asked, stop: &Stop, listener: &mut dyn Listener) -> Result<GateReport, GateError> {
    let (clock, started) = (Instant::now(), SystemTime::now());
    let scratch = Scratch::make(root)?;
    let tools = Tools::new(root, &scratch, stop);
    let base = Base::find(root, asked.against.as_deref(), &tools)?;
    let gate = Gate { root, tools: &tools, base: &base };
    let rows = ROWS.iter().map(|row| gate.row(row, asked, stop, listener)).collect();
    Ok(GateReport::new(base.told(), rows, stop.is_set(), (started, clock.elapsed())))
}

/// Who is told how a gate goes on.
pub trait Listener {
    /// A row begins.
    fn begins(&mut self, row: &Row);
    /// It has ended.
    fn ends(&mut self, row: &RowReport);
}

/// The contract, from the root of a tree.
const PROTO: &str = "proto/ncp.proto";
/// Its projection.
const PROJECTION: &str = "proto/projection.json";
/// The normative text.
const TEXT: &str = "spec/text";
/// The chapter that states wire version and contract hash.
const IDENTITY: &str = "spec/text/02-version-and-identity.md";
/// The cases.
const CORPUS: &str = "vectors/corpus";

/// What to do where a tree lacks what a row is about.
const NO_SUCH_ROOM: &str = "bring back what the tree lacks";

/// What the rows work with.
struct Gate<'g> {
    root: &'g Path,
    tools: &'g Tools<'g>,
    base: &'g Base,
}

impl Gate<'_> {
    fn row(&self, row: &Row, asked: &Asked, stop: &Stop, listener: &mut dyn Listener) -> RowReport {
        let names = |list: &[String]| list.iter().any(|name| name == row.name);
        if (!asked.only.is_empty() && !names(&asked.only)) || names(&asked.skip) {
            return RowReport::unrun(row, RowState::LeftOut, "by --only or --skip".to_owned(), None, Duration::ZERO);
        }
        let interrupted = |time| {
            let remedy = Some("ask again".to_owned());
            RowReport::unrun(row, RowState::NotRun, "interrupted".to_owned(), remedy, time)
        };
        if stop.is_set() {
            return interrupted(Duration::ZERO);
        }
        listener.begins(row);
        let clock = Instant::now();
        let missing = self.missing(row);
        let to_run = if missing.is_some() { NO_SUCH_ROOM } else { row.to_run };
        let outcome = missing.map_or_else(|| (row.run)(self), |why| Err(Unrun::Missing(why)));
        let time = clock.elapsed();
        let report = match outcome {
            _ if stop.is_set() => interrupted(time),
            Ok(Found { said, findings }) => RowReport::ran(row, said, findings, time),
            Err(Unrun::Interrupted) => interrupted(time),
            Err(Unrun::Missing(why)) => {
                let state = if names(&asked.allow_missing) { RowState::Allowed } else { RowState::NotRun };
                let remedy = (state == RowState::NotRun).then(|| format!("{to_run}; or --allow-missing {}", row.name));
                RowReport::unrun(row, state, why, remedy, time)
            }
            Err(Unrun::Broken(finding)) => RowReport::ran(row, String::new(), vec![*finding], time),
        };
        listener.ends(&report);
        report
    }

    /// A path of the tree.
    fn path(&self, relative: &str) -> PathBuf {
        self.root.join(relative)
    }

    /// The text of a file of the tree.
    fn read(&self, relative: &str) -> Result<String, Unrun> {
        let failed = |error: io::Error| Finding::at(relative, None, format!("cannot be read: {error}"));
        std::fs::read_to_string(self.path(relative)).map_err(|error| Unrun::Broken(Box::new(failed(error))))
    }

    /// What a row needs and this tree or this machine lacks.
    fn missing(&self, row: &Row) -> Option<String> {
        let crates = row.needs.iter().find(|needed| !self.path(needed).exists());
        crates.map(|needed| format!("this tree has no {needed}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tree_of_a_folder_is_the_nearest_above_that_has_a_contract_and_a_text() {
        let folder = tempfile::tempdir().unwrap();
        let deep = folder.path().join("proto/baseline");
        std::fs::create_dir_all(&deep).unwrap();
        std::fs::write(folder.path().join(PROTO), "").unwrap();
        assert!(matches!(root(&deep), Err(GateError::NoTree)));
        std::fs::create_dir_all(folder.path().join(TEXT)).unwrap();
        assert_eq!(root(&deep).unwrap(), folder.path());
    }

    #[test]
    fn every_row_has_a_name_of_its_own_and_says_what_to_do() {
        let names: std::collections::BTreeSet<_> = ROWS.iter().map(|row| row.name).collect();
        assert_eq!(names.len(), ROWS.len());
        assert!(ROWS.iter().all(|row| !row.remedy.is_empty() && !row.command.is_empty() && !row.about.is_empty()));
    }
}
