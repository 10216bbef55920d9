//! Writes the export to a file: `ncp-theorem Exported.v`.

use std::path::PathBuf;
use std::process::ExitCode;
use std::{env, fs, io};

use ncp_theorem::coq;
use ncp_theorem::source::{self, SourceError};

/// Why there is no export.
#[derive(Debug, thiserror::Error)]
enum ExportError {
    #[error("usage: ncp-theorem FILE")]
    Usage,
    #[error("the kernel does what the export cannot say: {0}")]
    Source(#[from] SourceError),
    #[error("{0}: {1}")]
    File(PathBuf, io::Error),
}

fn main() -> ExitCode {
    match export() {
        Ok(said) => {
            println!("{said}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("ncp-theorem: {error}");
            ExitCode::FAILURE
        }
    }
}

fn export() -> Result<String, ExportError> {
    let path = PathBuf::from(env::args_os().nth(1).ok_or(ExportError::Usage)?);
    let exports = source::all()?;
    let paths: usize = exports.iter().map(|export| export.tree.paths()).sum();
    fs::write(&path, coq::file(&exports)).map_err(|error| ExportError::File(path, error))?;
    Ok(format!("exported: {} functions and states of the kernel, {paths} paths", exports.len()))
}
