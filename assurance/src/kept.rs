//! What is kept of a measurement: the lock and the page, which stand in git, and the whole of it, which does not.
//!
//! | file | what |
//! |---|---|
//! | `reports/lock/<name>.toml` | digests, counts, and fates by id |
//! | `reports/<name>.md` | what people read of it |
//! | `reports/full/<name>.json` | everything; ignored by git, made anew with each measurement |

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use serde::Serialize;
use serde::de::DeserializeOwned;
use thiserror::Error;
use xtask::project::Project;

/// The file in which the lock of a measurement stands.
pub(crate) fn lock_file(name: &str) -> String {
    format!("reports/lock/{name}.toml")
}

/// The file in which the page of a measurement stands.
pub(crate) fn page_file(name: &str) -> String {
    format!("reports/{name}.md")
}

/// The lock of a measurement; none where none was made.
///
/// # Errors
/// It is not of the form.
pub(crate) fn read<T: DeserializeOwned>(project: &Project, name: &str) -> Result<Option<T>, KeptError> {
    let path = project.path(&lock_file(name));
    match fs::read_to_string(&path) {
        Ok(text) => match toml::from_str(&text) {
            Ok(lock) => Ok(Some(lock)),
            Err(source) => Err(KeptError::Form { path, source: Box::new(source) }),
        },
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(source) => Err(KeptError::File { path, source }),
    }
}

/// The page of a measurement; empty where there is none.
pub(crate) fn read_page(project: &Project, name: &str) -> String {
    fs::read_to_string(project.path(&page_file(name))).unwrap_or_default().replace("\r\n", "\n")
}

/// Writes the lock and the page of a measurement, and all of it where git does not look.
///
/// # Errors
/// A file cannot be written.
pub(crate) fn write(
    project: &Project,
    name: &str,
    lock: &impl Serialize,
    page: &str,
    full: &impl Serialize,
) -> Result<(), KeptError> {
    let lock = toml::to_string_pretty(lock).map_err(|source| KeptError::NoToml { name: name.to_owned(), source })?;
    let full =
        serde_json::to_string_pretty(full).map_err(|source| KeptError::NoJson { name: name.to_owned(), source })?;
    save(&project.path(&lock_file(name)), &lock)?;
    save(&project.path(&page_file(name)), page)?;
    save(&project.path(&format!("reports/full/{name}.json")), &(full + "\n"))
}

fn save(path: &Path, text: &str) -> Result<(), KeptError> {
    let folder = path.parent().map_or(Ok(()), fs::create_dir_all);
    let written = folder.and_then(|()| fs::write(path, text));
    written.map_err(|source| KeptError::File { path: path.to_owned(), source })
}

/// Why a measurement cannot be read or kept.
#[derive(Debug, Error)]
pub(crate) enum KeptError {
    #[error("{}: {source}", path.display())]
    File { path: PathBuf, source: io::Error },
    #[error("{}: {source}", path.display())]
    Form { path: PathBuf, source: Box<toml::de::Error> },
    #[error("{name} cannot be written as TOML: {source}")]
    NoToml { name: String, source: toml::ser::Error },
    #[error("{name} cannot be written as JSON: {source}")]
    NoJson { name: String, source: serde_json::Error },
}
