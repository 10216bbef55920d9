//! The digests of what is proved and of what proves it: which results are about the sources as they are.

use std::collections::BTreeSet;
use std::fmt::Write;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};

/// Results of proofs, and all that they depend on: what is proved, what says it, what shows it, and what decides
/// whether it is shown. How a report looks is none of that.
#[derive(Debug, Clone, Copy)]
pub struct Artefact {
    /// Its name.
    pub name: &'static str,
    /// Files and folders, from the root of the repository.
    pub sources: &'static [&'static str],
}

/// All artefacts.
pub const ARTEFACTS: [Artefact; 4] = [
    // The properties of the kernel, by symbolic execution, by enumeration and by samples.
    Artefact {
        name: "kernel",
        sources: &[
            "spec/kernel/src",
            "defects/kernel.toml",
            "defects/src",
            "proofs/build.rs",
            "proofs/evidence/solve.py",
            "proofs/src/broken.rs",
            "proofs/src/counterexample.rs",
            "proofs/src/engines",
            "proofs/src/harness.rs",
            "proofs/src/kernel.rs",
            "proofs/src/main.rs",
            "proofs/src/properties",
            "proofs/src/prover.rs",
            "proofs/src/provers",
            "proofs/src/report.rs",
            // What the vectors of counterexamples expect.
            "proofs/src/reference.rs",
            "proofs/src/vector",
            "proofs/src/vector.rs",
            "spec/src/resilience",
            "spec/src/safety",
        ],
    },
    Artefact {
        name: "machine",
        sources: &[
            "spec/kernel/src",
            "defects/kernel.toml",
            "defects/src",
            "proofs/machine/broken",
            "proofs/machine/build.rs",
            "proofs/machine/explore.py",
            "proofs/machine/hints.toml",
            "proofs/machine/machine.py",
            "proofs/machine/native.py",
            "proofs/machine/properties.py",
            "proofs/machine/prove.sh",
            "proofs/machine/solver.py",
            "proofs/machine/src",
            "proofs/machine/vector.py",
            "proofs/src/report.rs",
        ],
    },
    Artefact {
        name: "model",
        sources: &[
            "spec/kernel/src",
            "spec/src/contract.rs",
            "spec/src/reply.rs",
            "spec/src/resilience",
            "spec/src/safety",
            "spec/src/session",
            "spec/src/version.rs",
            "spec/src/wire",
            "proofs/model/src",
            "proofs/src/report.rs",
        ],
    },
    Artefact {
        name: "readers",
        sources: &[
            "spec/src/bulk",
            "spec/src/keys.rs",
            "spec/src/version.rs",
            "defects/readers.toml",
            "defects/src",
            "proofs/readers/build.rs",
            "proofs/readers/src",
            "proofs/src/counterexample.rs",
            "proofs/src/prover.rs",
            "proofs/src/provers/native.rs",
            "proofs/src/report.rs",
        ],
    },
];

impl Artefact {
    /// SHA-256 over the names and the contents of its sources.
    ///
    /// # Errors
    /// A file cannot be read.
    pub fn digest(&self, root: &Path) -> io::Result<String> {
        of_sources(root, self.sources)
    }
}

/// The digest over all [`ARTEFACTS`].
///
/// # Errors
/// A file cannot be read.
pub fn of(root: &Path) -> io::Result<String> {
    of_sources(root, &ARTEFACTS.map(|artefact| artefact.sources).concat())
}

/// The same over other files and folders.
///
/// # Errors
/// A file cannot be read.
pub fn of_sources(root: &Path, sources: &[&str]) -> io::Result<String> {
    let mut files = Vec::new();
    for source in sources {
        collect(&root.join(source), &mut files)?;
    }
    of_files(root, files)
}

/// The same over these files, each once, in the order of their names.
///
/// # Errors
/// A file cannot be read.
pub fn of_files(root: &Path, files: Vec<PathBuf>) -> io::Result<String> {
    let mut hash = Sha256::new();
    for file in files.into_iter().collect::<BTreeSet<_>>() {
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
