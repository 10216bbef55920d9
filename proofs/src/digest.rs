//! The digests of what is proved and of what proves it: which results are about the sources as they are.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;

use sha2::{Digest, Sha256};
use toml::{Table, Value};

/// Results of proofs, and all that they depend on: what is proved, what says it, what shows it, and what decides
/// whether it is shown. How a report looks does not count.
#[derive(Debug, Clone, Copy)]
pub struct Artefact {
    /// Its name.
    pub name: &'static str,
    /// The package that makes it: what it is built with decides, too.
    pub package: &'static str,
    /// Files and folders, from the root of the repository.
    pub sources: &'static [&'static str],
}

/// All artefacts.
pub const ARTEFACTS: [Artefact; 6] = [
    // The properties of the kernel, by symbolic execution, by enumeration and by samples.
    Artefact {
        name: "kernel",
        package: "ncp-proofs",
        sources: &[
            "spec/kernel/src",
            "defects/engine.toml",
            "defects/kernel.toml",
            "defects/src",
            "proofs/build.rs",
            "proofs/evidence/solve.py",
            "proofs/explored.json",
            "proofs/src/broken.rs",
            "proofs/src/counterexample.rs",
            "proofs/src/engines",
            "proofs/src/harness.rs",
            "proofs/src/kernel.rs",
            "proofs/src/main.rs",
            "proofs/src/pins.rs",
            "proofs/src/properties",
            "proofs/src/prover.rs",
            "proofs/src/provers",
            "proofs/src/report.rs",
            "proofs/src/sabotage.rs",
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
        package: "ncp-machine",
        sources: &[
            "spec/kernel/src",
            "defects/kernel.toml",
            "defects/src",
            "proofs/machine/broken",
            "proofs/machine/build.rs",
            "proofs/machine/choices.py",
            "proofs/machine/controls.py",
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
        package: "ncp-model",
        sources: &[
            "spec/kernel/src",
            "spec/src/contract.rs",
            "spec/src/reply.rs",
            "spec/src/resilience",
            "spec/src/safety",
            "spec/src/session",
            "spec/src/version.rs",
            "spec/src/wire",
            // What the specification takes from the text: types, defaults, limits, and the contract.
            "spec/text/01-wire.md",
            "spec/text/02-version-and-identity.md",
            "proofs/model/src",
            "proofs/src/report.rs",
        ],
    },
    Artefact {
        name: "readers",
        package: "ncp-readers",
        sources: &[
            "spec/src/bulk",
            "spec/src/keys.rs",
            "spec/src/version.rs",
            "spec/text/01-wire.md",
            "spec/text/02-version-and-identity.md",
            "defects/readers.toml",
            "defects/src",
            "proofs/readers/build.rs",
            "proofs/readers/src",
            "proofs/src/counterexample.rs",
            "proofs/src/prover.rs",
            "proofs/src/program.rs",
            "proofs/src/provers/native.rs",
            "proofs/src/report.rs",
        ],
    },
    // The safety path around the kernel.
    Artefact {
        name: "path",
        package: "ncp-path",
        sources: &[
            "spec/kernel/src",
            "spec/src/control/control_loop.rs",
            "spec/src/resilience",
            "spec/src/safety",
            "spec/src/wire",
            "spec/text/01-wire.md",
            "defects/path.toml",
            "defects/src",
            "proofs/path/build.rs",
            "proofs/path/src",
            "proofs/src/program.rs",
            "proofs/src/provers/native.rs",
            "proofs/src/report.rs",
        ],
    },
    Artefact {
        name: "theorem",
        package: "ncp-theorem",
        sources: &[
            "spec/kernel/src",
            "proofs/src/report.rs",
            "proofs/theorem/check.sh",
            "proofs/theorem/claims.toml",
            "proofs/theorem/coq",
            "proofs/theorem/src",
            "assurance/src/proofs/theorem.rs",
        ],
    },
];

/// The section of the workspace's manifest that says how what is proved is built, and what proves it.
const PROFILE: &str = "Cargo.toml [profile.release]";

impl Artefact {
    /// SHA-256 over the names and the contents of its sources, and over [its circumstances](Self::circumstances).
    ///
    /// # Errors
    /// A file cannot be read.
    pub fn digest(&self, root: &Path) -> io::Result<String> {
        let mut hash = Sha256::new();
        hash.update(of_sources(root, self.sources)?);
        for (name, value) in self.circumstances(root)? {
            hash.update(format!("{name}\0{value}\0"));
        }
        Ok(hex(hash))
    }

    /// What decides beside the sources, by name: the compiler and its target, the profile, and the packages of the
    /// lock file that are built in. What is not there has no entry.
    ///
    /// # Errors
    /// A file cannot be read, or has another form.
    pub fn circumstances(&self, root: &Path) -> io::Result<BTreeMap<String, String>> {
        let mut all = BTreeMap::new();
        all.extend(compiler(root).map(|compiler| ("rustc".to_owned(), compiler)));
        let lock = table(&root.join("Cargo.lock"))?;
        let packages = lock.as_ref().map(|lock| built_in(lock, self.package)).unwrap_or_default();
        let manifest = table(&root.join("Cargo.toml"))?;
        if let Some(profile) = manifest.as_ref().and_then(|manifest| manifest.get("profile")?.get("release")) {
            all.insert(PROFILE.to_owned(), of_text(&profile_of(profile.clone(), &packages).to_string()));
        }
        if lock.is_some() {
            all.insert(format!("Cargo.lock of {}", self.package), of_text(&packages.join("\n")));
        }
        Ok(all)
    }
}

/// The compiler and its target: `1.90.0 (1159e78c4 2025-09-14) x86_64-unknown-linux-gnu`.
fn compiler(root: &Path) -> Option<String> {
    let output = Command::new("rustc").arg("-vV").current_dir(root).output().ok()?;
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    let of = |kind: &str| said.lines().find_map(|line| line.strip_prefix(kind));
    Some(format!("{} {}", of("rustc ")?, of("host: ")?))
}

/// A profile without what it says of packages that are not built in.
fn profile_of(mut profile: Value, packages: &[String]) -> Value {
    if let Some(table) = profile.as_table_mut() {
        let is_built_in = |name: &str| packages.iter().any(|package| package.split(' ').next() == Some(name));
        if let Some(overrides) = table.get_mut("package").and_then(Value::as_table_mut) {
            overrides.retain(|name, _| is_built_in(name));
        }
        let is_empty = |overrides: &Value| overrides.as_table().is_some_and(Table::is_empty);
        if table.get("package").is_some_and(is_empty) {
            table.remove("package");
        }
    }
    profile
}

/// A file of TOML; nothing if there is none.
fn table(path: &Path) -> io::Result<Option<Table>> {
    match fs::read_to_string(path) {
        Ok(text) => text.parse().map(Some).map_err(io::Error::other),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(error),
    }
}

/// The packages of a lock file that one is built of, itself left out: name, version and checksum, in order.
fn built_in(lock: &Table, package: &str) -> Vec<String> {
    let text = |package: &'_ Value, key: &str| package.get(key).and_then(Value::as_str).unwrap_or_default().to_owned();
    let packages = lock.get("package").and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
    let (mut open, mut seen) = (vec![package.to_owned()], BTreeSet::new());
    while let Some(wanted) = open.pop() {
        // A dependency has a version where its name is not enough.
        let is_wanted = |package: &&Value| {
            let (name, version) = (text(package, "name"), text(package, "version"));
            wanted == name || wanted.starts_with(&format!("{name} {version}"))
        };
        for found in packages.iter().filter(is_wanted) {
            if seen.insert(format!("{} {} {}", text(found, "name"), text(found, "version"), text(found, "checksum"))) {
                let needs = found.get("dependencies").and_then(Value::as_array);
                open.extend(needs.into_iter().flatten().filter_map(|need| need.as_str().map(str::to_owned)));
            }
        }
    }
    seen.into_iter().filter(|one| !one.starts_with(&format!("{package} "))).collect()
}

/// The digest over all [`ARTEFACTS`].
///
/// # Errors
/// A file cannot be read.
pub fn of(root: &Path) -> io::Result<String> {
    let digests: Vec<String> = ARTEFACTS.iter().map(|artefact| artefact.digest(root)).collect::<Result<_, _>>()?;
    Ok(of_text(&digests.join("\n")))
}

/// SHA-256 over the names and the contents of files and folders.
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
    Ok(hex(hash))
}

fn of_text(text: &str) -> String {
    let mut hash = Sha256::new();
    hash.update(text);
    hex(hash)
}

fn hex(hash: Sha256) -> String {
    let bytes: [u8; 32] = hash.finalize().into();
    bytes.iter().fold(String::new(), |mut hex, byte| {
        let _ = write!(hex, "{byte:02x}");
        hex
    })
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

#[cfg(test)]
mod tests {
    use super::*;

    const LOCK: &str = "[[package]]\nname = \"a\"\nversion = \"1\"\ndependencies = [\"b 2\", \"c\"]\n\
                        [[package]]\nname = \"b\"\nversion = \"1\"\n[[package]]\nname = \"b\"\nversion = \"2\"\n\
                        [[package]]\nname = \"c\"\nversion = \"1\"\nchecksum = \"f\"\n\
                        [[package]]\nname = \"d\"\nversion = \"1\"\n";

    #[test]
    fn only_the_packages_that_are_built_in_count_by_their_versions_and_checksums() {
        assert_eq!(built_in(&LOCK.parse().unwrap(), "a"), ["b 2 ", "c 1 f"]);
    }

    #[test]
    fn of_a_profile_only_what_it_says_of_packages_that_are_built_in_counts() {
        let folder = tempfile::tempdir().unwrap();
        let artefact = Artefact { name: "a", package: "a", sources: &["Cargo.lock"] };
        let with = |package: &str| {
            let of = |package: &str| format!("[profile.release.package]\n{package}.opt-level = 3\n");
            let overrides = if package.is_empty() { String::new() } else { of(package) };
            let profiles = format!("[profile.release]\nlto = true\n{overrides}");
            fs::write(folder.path().join("Cargo.toml"), profiles).unwrap();
            fs::write(folder.path().join("Cargo.lock"), LOCK).unwrap();
            artefact.circumstances(folder.path()).unwrap().remove(PROFILE)
        };
        assert_eq!(with(""), with("d"));
        assert_ne!(with(""), with("c"));
    }

    #[test]
    fn another_profile_or_another_version_of_what_is_built_in_is_another_digest() {
        let folder = tempfile::tempdir().unwrap();
        let artefact = Artefact { name: "a", package: "a", sources: &["Cargo.lock"] };
        let with = |profile: &str, lock: &str| {
            let profiles = format!("[profile.dev]\nopt-level = 1\n[profile.release]\nlto = {profile:?}\n");
            fs::write(folder.path().join("Cargo.toml"), profiles).unwrap();
            fs::write(folder.path().join("Cargo.lock"), lock).unwrap();
            artefact.circumstances(folder.path()).unwrap()
        };
        let (thin, fat) = (with("thin", LOCK), with("fat", LOCK));
        assert_ne!(thin[PROFILE], fat[PROFILE]);
        let newer = with("thin", &LOCK.replace("\"f\"", "\"e\""));
        assert_eq!(thin[PROFILE], newer[PROFILE]);
        assert_ne!(thin["Cargo.lock of a"], newer["Cargo.lock of a"]);
        let unrelated = with("thin", &LOCK.replace("\"d\"\nversion = \"1\"", "\"d\"\nversion = \"9\""));
        assert_eq!(thin, unrelated);
        assert!(thin.contains_key("rustc"));
    }
}
