//! The digest of what is proved and of what proves it; the project's own commands read it too.

use std::fmt::Write;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};

/// What the proofs are about, what says it, and what shows it: a change of any makes the report stale.
const SOURCES: [&str; 9] = [
    "spec/src/safety/kernel",
    "proofs/src/properties",
    "proofs/src/engines",
    "proofs/src/kernel.rs",
    "proofs/src/prover.rs",
    "proofs/broken.rs",
    "proofs/machine/src",
    "proofs/machine/properties.py",
    "proofs/model/src",
];

/// SHA-256 over the names and the contents of the kernel's sources and of the harnesses.
///
/// # Errors
/// A file cannot be read.
pub fn of(root: &Path) -> io::Result<String> {
    let mut files = Vec::new();
    for source in SOURCES {
        collect(&root.join(source), &mut files)?;
    }
    files.sort();
    let mut hash = Sha256::new();
    for file in files {
        let name = file.strip_prefix(root).unwrap_or(&file);
        hash.update(name.to_string_lossy().replace('\\', "/").as_bytes());
        hash.update([0]);
        let text = fs::read_to_string(&file)?.replace("\r\n", "\n");
        hash.update(text.as_bytes());
        hash.update([0]);
    }
    let bytes: [u8; 32] = hash.finalize().into();
    Ok(bytes.iter().fold(String::new(), |mut hex, byte| {
        let _ = write!(hex, "{byte:02x}");
        hex
    }))
}

fn collect(path: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    if path.is_dir() {
        for entry in fs::read_dir(path)? {
            collect(&entry?.path(), files)?;
        }
    } else {
        files.push(path.to_owned());
    }
    Ok(())
}
