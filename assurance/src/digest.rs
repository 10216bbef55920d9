//! The digest of what is proved and of what proves it; the project's own commands read it too.

use std::fmt::Write;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};

/// What the proofs are about, what says it, what shows it, and what decides whether it is shown: a change of any
/// makes the report stale. How the report looks is none of that.
pub(crate) const SOURCES: [&str; 43] = [
    // What is proved: the kernel, what the model explores around it, and what reads untrusted bytes.
    "spec/kernel/src",
    "spec/src/safety",
    "spec/src/resilience",
    "spec/src/session",
    "spec/src/wire",
    "spec/src/contract.rs",
    "spec/src/reply.rs",
    "spec/src/version.rs",
    "spec/src/keys.rs",
    "spec/src/bulk",
    // The properties of the kernel, the engines, the broken kernels, and what is a problem of a report.
    "proofs/src/properties",
    "proofs/src/engines",
    "proofs/src/kernel.rs",
    "proofs/src/prover.rs",
    "proofs/src/broken.rs",
    "proofs/src/reference.rs",
    "proofs/src/vector.rs",
    "proofs/src/report.rs",
    "proofs/src/main.rs",
    "proofs/broken.rs",
    "proofs/edit.rs",
    "proofs/build.rs",
    "proofs/evidence/solve.py",
    // Its machine code.
    "proofs/machine/src",
    "proofs/machine/broken",
    "proofs/machine/broken.json",
    "proofs/machine/build.rs",
    "proofs/machine/explore.py",
    "proofs/machine/machine.py",
    "proofs/machine/native.py",
    "proofs/machine/properties.py",
    "proofs/machine/prove.sh",
    "proofs/machine/solver.py",
    "proofs/machine/vector.py",
    // The model.
    "proofs/model/src",
    // The readers.
    "proofs/readers/src/properties",
    "proofs/readers/src/broken.rs",
    "proofs/readers/src/exhaustive.rs",
    "proofs/readers/src/lib.rs",
    "proofs/readers/src/main.rs",
    "proofs/readers/src/readers.rs",
    "proofs/readers/broken.rs",
    "proofs/readers/build.rs",
];

/// SHA-256 over the names and the contents of the [`SOURCES`].
///
/// # Errors
/// A file cannot be read.
pub(crate) fn of(root: &Path) -> io::Result<String> {
    of_sources(root, &SOURCES)
}

/// The same over other files and folders.
///
/// # Errors
/// A file cannot be read.
pub(crate) fn of_sources(root: &Path, sources: &[&str]) -> io::Result<String> {
    let mut files = Vec::new();
    for source in sources {
        collect(&root.join(source), &mut files)?;
    }
    of_files(root, files)
}

/// The same over these files, in the order of their names.
///
/// # Errors
/// A file cannot be read.
pub(crate) fn of_files(root: &Path, mut files: Vec<PathBuf>) -> io::Result<String> {
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
