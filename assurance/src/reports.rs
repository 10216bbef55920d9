//! Where reports go: a short page that git keeps, and the long forms in a folder that it ignores.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use serde::Serialize;
use thiserror::Error;

use crate::document::{self, Block};

/// The short pages, from the root of the project.
pub(crate) const PAGES: &str = "reports";
/// The long forms, within the pages' folder.
const FULL: &str = "full";

/// A report cannot be written.
#[derive(Debug, Error)]
pub(crate) enum ReportError {
    #[error("{}: {source}", path.display())]
    File { path: PathBuf, source: io::Error },
    #[error("{name}: {source}")]
    Json { name: String, source: serde_json::Error },
}

/// Writes the short page of a report: `<name>.md`.
///
/// # Errors
/// It cannot be written.
pub(crate) fn page(folder: &Path, name: &str, blocks: &[Block]) -> Result<(), ReportError> {
    write(&folder.join(format!("{name}.md")), &document::markdown(blocks))
}

/// Writes the long forms: `full/<name>.json` from the model, `.md` and `.html` from the document.
///
/// # Errors
/// One of them cannot be written.
pub(crate) fn full(folder: &Path, name: &str, model: &impl Serialize, blocks: &[Block]) -> Result<(), ReportError> {
    json(&folder.join(FULL).join(format!("{name}.json")), model)?;
    long_pages(folder, name, blocks)
}

/// Writes a model as JSON.
///
/// # Errors
/// It cannot be written.
pub(crate) fn json(file: &Path, model: &impl Serialize) -> Result<(), ReportError> {
    let json = serde_json::to_string_pretty(model);
    let json = json.map_err(|source| ReportError::Json { name: file.display().to_string(), source })?;
    write(file, &format!("{json}\n"))
}

/// Writes the long forms that people read: `full/<name>.md` and `full/<name>.html`.
///
/// # Errors
/// One of them cannot be written.
pub(crate) fn long_pages(folder: &Path, name: &str, blocks: &[Block]) -> Result<(), ReportError> {
    let full = folder.join(FULL);
    write(&full.join(format!("{name}.md")), &document::markdown(blocks))?;
    write(&full.join(format!("{name}.html")), &document::html(blocks))
}

/// Writes a file if it differs.
fn write(path: &Path, text: &str) -> Result<(), ReportError> {
    if fs::read_to_string(path).is_ok_and(|written| written == text) {
        return Ok(());
    }
    let made = path.parent().map_or(Ok(()), fs::create_dir_all).and_then(|()| fs::write(path, text));
    made.map_err(|source| ReportError::File { path: path.to_owned(), source })
}
