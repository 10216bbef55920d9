//! The deep set as it lies in git: frozen, within its bounds, and apart from the corpus.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;
use std::path::Path;

use ncp_verifier::suite::{DEEP, Suite};
use sha2::{Digest as _, Sha256};

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../vectors/deep");
/// How many bytes all files may have.
const MOST: u64 = 20 << 20;

#[test]
fn the_manifest_names_every_file_by_its_digest() {
    let mut lines = Vec::new();
    for entry in fs::read_dir(FOLDER).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|extension| extension == "json") {
            let digest: String = Sha256::digest(fs::read(&path).unwrap()).iter().map(|b| format!("{b:02x}")).collect();
            lines.push(format!("{digest}  deep/{}\n", path.file_name().unwrap().to_str().unwrap()));
        }
    }
    lines.sort_by(|a, b| a[64..].cmp(&b[64..]));
    let manifest = fs::read_to_string(Path::new(FOLDER).join("MANIFEST.sha256")).unwrap();
    assert_eq!(lines.concat(), manifest, "a frozen case changed: cargo assure deep chooses the set anew");
}

#[test]
fn its_files_stay_small_and_every_case_is_known_by_its_id() {
    let files = fs::read_dir(FOLDER).unwrap();
    let bytes: u64 = files.map(|entry| entry.unwrap().metadata().unwrap().len()).sum();
    assert!(bytes < MOST, "{bytes}");
    let deep = Suite::deep().unwrap();
    assert!(deep.cases().len() > 300 && deep.cases().iter().all(|case| case.is_deep() && case.id.starts_with(DEEP)));
}

#[test]
fn it_stands_besides_the_corpus_and_the_corpus_without_it() {
    let (corpus, both) = (Suite::embedded().unwrap(), Suite::with_deep().unwrap());
    let deep = Suite::deep().unwrap();
    assert!(corpus.cases().iter().all(|case| !case.is_deep()));
    assert_eq!(both.cases().len(), corpus.cases().len() + deep.cases().len());
    assert_ne!(both.digest(), corpus.digest());
}
