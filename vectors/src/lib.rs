//! The golden corpus of the NCP conformance suite, and the generator that wrote it.
//!
//! The corpus is what a peer is held against: JSON files of cases in `corpus/`, one folder an area, frozen by
//! `MANIFEST.sha256`. It is made by a program so that it is systematic: every field of every message, every type, every
//! boundary. What each case expects follows from the normative text, not from an implementation: defaults, types and
//! orders are read from the tables of `spec/text/01-wire.md`, the golden block from chapter 5, and the models of this
//! crate compute the rest from scenario text. The crate knows `ncp-text` alone. `ncp-spec` is a second source and no
//! part of it; the tests of the Rust peer hold it against every case.
//!
//! | module | what it is about |
//! |---|---|
//! | `wire`, `version`, `keys`, `bulk`, `hostile` | the cases of an area, a module each: what is read and written |
//! | `safety`, `resilience`, `codec`, `control`, `session`, `strict` | likewise: what moves a plant, and sessions |
//! | `scenario`, `patch` | scenario text: the tables of cases in `scenarios/`, and changes of frames in them |
//! | `case`, `template`, `json`, `trace`, `flags`, `roles`, `runs` | what a case consists of, and how it is written |
//! | `names` | names that are hard to tell apart |
//! | `second` | the models as a second source of traces that were drawn at random |
//! | `foundations` | on which cases a case rests |
//! | `model`, `command` | what a frame means by the tables of the text, and the command frame |
//! | `on_disk` | the corpus as it lies on disk, for the tests |
//!
//! ```no_run
//! let files = ncp_vectors::generate()?;
//! let (path, text) = &files[0];
//! assert!(path.ends_with(".json") && text.starts_with('{'));
//! # Ok::<(), ncp_vectors::GenerateError>(())
//! ```

#![forbid(unsafe_code)]

mod bulk;
mod case;
mod codec;
mod command;
mod control;
mod flags;
mod foundations;
mod hostile;
mod json;
mod keys;
mod model;
mod names;
mod patch;
mod resilience;
mod roles;
mod runs;
mod safety;
mod scenario;
mod second;
mod session;
mod strict;
mod template;
mod trace;
mod version;
mod wire;

#[cfg(test)]
#[path = "../tests/on_disk/mod.rs"]
mod on_disk;

use std::fmt::Write as _;

pub use scenario::{Fault, ScenarioError, formatted};
pub use second::{Second, second};
use sha2::{Digest as _, Sha256};
use thiserror::Error;

/// Every file of the corpus: its path below `vectors/corpus/`, such as `wire/command_frame.json`, and its
/// text. Sorted by path; the same in every run.
///
/// # Errors
/// A line of the scenario text, or of `foundations.toml`, is wrong.
pub fn generate() -> Result<Vec<(String, String)>, GenerateError> {
    let areas = [
        wire::files()?,
        version::files()?,
        keys::files()?,
        bulk::files(),
        hostile::files()?,
        safety::files()?,
        resilience::files()?,
        codec::files(),
        control::files()?,
        session::files()?,
        strict::files()?,
    ];
    let files = foundations::lay(areas.into_iter().flatten().collect())?;
    let mut files: Vec<_> = files.into_iter().map(case::File::render).collect();
    files.sort();
    Ok(files)
}

/// Why the corpus cannot be made.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum GenerateError {
    /// A line of the scenario text.
    #[error(transparent)]
    Scenario(#[from] ScenarioError),
    /// What cases rest on.
    #[error("foundations.toml: {0}")]
    Foundations(#[from] toml::de::Error),
}

/// The manifest of those files, `vectors/MANIFEST.sha256`: a line `<sha256>  corpus/<path>` for each, sorted by path.
#[must_use]
pub fn manifest(files: &[(String, String)]) -> String {
    let mut files: Vec<_> = files.iter().collect();
    files.sort();
    let mut out = String::new();
    for (path, text) in files {
        for byte in Sha256::digest(text) {
            // Writing to a string does not fail.
            let _ = write!(out, "{byte:02x}");
        }
        let _ = writeln!(out, "  corpus/{path}");
    }
    out
}
