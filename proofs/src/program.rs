//! What the programs of the engines share: how one leaves its result, and how it ends.

use std::fmt::Display;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{fs, io};

use thiserror::Error;

use crate::report::Engine;

/// A result that cannot be left.
#[derive(Debug, Error)]
pub enum WriteError {
    /// It has no form as JSON.
    #[error("cannot write the result: {0}")]
    Json(#[from] serde_json::Error),
    /// The file cannot be written.
    #[error("cannot write {0}: {1}")]
    File(PathBuf, io::Error),
}

/// Writes a result as JSON.
///
/// # Errors
/// [`WriteError`].
pub fn write(result: &Engine, file: &Path) -> Result<(), WriteError> {
    let text = serde_json::to_string_pretty(result)? + "\n";
    fs::write(file, text).map_err(|error| WriteError::File(file.to_owned(), error))
}

/// The code with which a program ends; what went wrong is said on its standard error.
#[must_use]
pub fn end(name: &str, ran: Result<(), impl Display>) -> ExitCode {
    match ran {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("{name}: {failure}");
            ExitCode::FAILURE
        }
    }
}
