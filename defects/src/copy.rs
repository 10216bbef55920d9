//! Copies of sources with one defect in them, for a build script to compile as they are.

use std::path::{Path, PathBuf};
use std::{fs, io};

use thiserror::Error;

use crate::place::{self, PlaceError};
use crate::table::Defect;

/// Why there is no copy.
#[derive(Debug, Error)]
pub enum CopyError {
    /// The defect has no place in the sources.
    #[error(transparent)]
    Place(#[from] PlaceError),
    /// The defect changes a file that is not copied.
    #[error("{defect}: {file} is not among the sources")]
    Elsewhere {
        /// The defect's name.
        defect: String,
        /// The file.
        file: String,
    },
    /// A file or a folder cannot be read or written.
    #[error("{}: {source}", path.display())]
    File {
        /// Which.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
}

/// Copies `source`, a file or a folder of files from `root` on, into the folder `to`, without unit tests and with the
/// defect planted. The copy's path.
///
/// # Errors
/// The defect has no place there, or a file fails.
pub fn planted(root: &Path, source: &str, to: &Path, defect: &Defect) -> Result<PathBuf, CopyError> {
    let failed = |path: &Path| {
        let path = path.to_owned();
        move |source| CopyError::File { path, source }
    };
    let (from, base) = (root.join(source), Path::new(source).parent().unwrap_or(Path::new("")));
    let mut files = vec![source.to_owned()];
    if from.is_dir() {
        let entries = fs::read_dir(&from).and_then(Iterator::collect::<io::Result<Vec<_>>>);
        let entries = entries.map_err(failed(&from))?;
        files = entries.iter().map(|entry| format!("{source}/{}", entry.file_name().to_string_lossy())).collect();
    }
    if let Some(edit) = defect.edit.iter().find(|edit| !files.contains(&edit.file)) {
        return Err(CopyError::Elsewhere { defect: defect.name.clone(), file: edit.file.clone() });
    }
    for file in files {
        let path = root.join(&file);
        let text = fs::read_to_string(&path).map_err(failed(&path))?.replace("\r\n", "\n");
        let text = place::plant(place::without_tests(&text), &file, defect)?;
        let copy = to.join(Path::new(&file).strip_prefix(base).unwrap_or(Path::new(&file)));
        let folder = copy.parent().unwrap_or(to);
        fs::create_dir_all(folder).map_err(failed(folder))?;
        fs::write(&copy, text).map_err(failed(&copy))?;
    }
    Ok(to.join(from.file_name().unwrap_or_default()))
}
