//! `cargo assure deep --keep`: the cases of the set, in the contract as it is now.
//!
//! Cases name the wire version and the contract hash. Where these have changed since the set was written, its cases
//! take the new ones, and what they expect is asked of the specification and of the second sources once more.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use ncp_text::{CONTRACT_HASH, WIRE_VERSION};
use ncp_verifier::fuzz::deep::{Deep, Rules};
use ncp_verifier::peer::Call;
use ncp_verifier::stop::Stop;
use ncp_verifier::suite::Suite;
use serde::{Deserialize, Serialize};
use xtask::project::Project;

use super::{FOLDER, Pool, WORK, agreed, kept, write};
use crate::Error;
use crate::artefact::Artefact;
use crate::console::counted;
use crate::lock::{self, LockError};
use crate::status::StatusError;

/// Its artefact.
const NAME: &str = "deep";

/// The lock of the set.
#[derive(Debug, Serialize, Deserialize)]
struct Spoken {
    sources: BTreeMap<String, String>,
    contract: Contract,
}

/// What the cases name.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
struct Contract {
    wire_version: String,
    contract_hash: String,
}

impl Contract {
    fn of_the_text() -> Self {
        Self { wire_version: WIRE_VERSION.to_owned(), contract_hash: CONTRACT_HASH.to_owned() }
    }
}

/// Writes every case of the set anew; `false` if sources disagree about one, which is left out.
pub(super) fn keep(project: &Project, out: &Path, stop: &Stop) -> Result<bool, Error> {
    let root = project.path("");
    let now = Contract::of_the_text();
    let was = lock::read::<Spoken>(&root, NAME)?.map_or_else(|| now.clone(), |lock| lock.contract);
    let work = project.path(WORK).join("kept");
    let files = speak(&root.join(FOLDER), &work.join("deep"), &was, &now)?;
    let cases = Suite::load(&work)?;
    let suite = Suite::embedded()?;
    let deep = Deep::new(&suite, 0)?;
    let mut rules = Rules::new(&suite);
    let mut pool = Pool::new();
    for case in cases.cases() {
        if let Some(candidate) = deep.kept(case)
            && let Some(kept) = kept(&deep, &mut rules, candidate, BTreeSet::new())
        {
            pool.insert((case.call, kept.candidate.number), kept);
        }
    }
    let open = cases.cases().len() - pool.len();
    let (pool, disputes) = agreed(project, &deep, pool, stop)?;
    for dispute in &disputes {
        println!("{dispute}");
    }
    let all: Vec<(Call, u64)> = pool.keys().copied().collect();
    write(&root.join(out), &pool, &all, Call::ALL)?;
    if out == Path::new(FOLDER) {
        note(&root)?;
    }
    println!(
        "{} of {} in {}; {open} whose answer the text leaves open, or that PROTOCOL.md has no request for; {}",
        pool.len(),
        counted(cases.cases().len(), "case"),
        counted(files, "file"),
        counted(disputes.len(), "dispute")
    );
    Ok(disputes.is_empty())
}

/// Writes the lock of the set: in what contract it speaks, and of which sources.
pub(super) fn note(root: &Path) -> Result<(), Error> {
    let artefact = Artefact::named(NAME).ok_or_else(|| Error::Usage { what: format!("{NAME} is no artefact") })?;
    let digests = artefact.digests(root);
    let sources = digests.map_err(|source| StatusError::Digest { name: NAME, source })?;
    let text = lock::text(NAME, &Spoken { sources, contract: Contract::of_the_text() })?;
    let path = lock::path(root, NAME);
    fs::write(&path, text).map_err(|source| LockError::File { path, source }.into())
}

/// Copies the files of a set into a folder, in another contract; how many.
fn speak(from: &Path, to: &Path, was: &Contract, now: &Contract) -> Result<usize, Error> {
    let failed = |path: &Path| {
        let path = path.to_owned();
        move |source| Error::File { path, source }
    };
    // Files of an earlier set do not mix with these.
    let _ = fs::remove_dir_all(to);
    fs::create_dir_all(to).map_err(failed(to))?;
    let mut count = 0;
    for entry in fs::read_dir(from).map_err(failed(from))? {
        let path = entry.map_err(failed(from))?.path();
        let Some(name) = path.file_name().filter(|_| path.extension().is_some_and(|e| e == "json")) else { continue };
        let text = fs::read_to_string(&path).map_err(failed(&path))?;
        fs::write(to.join(name), spoken(&text, was, now)).map_err(failed(to))?;
        count += 1;
    }
    Ok(count)
}

/// The text of a file in another contract. What named the new version before, as another one, names the old one now, so
/// that it stays another.
fn spoken(text: &str, was: &Contract, now: &Contract) -> String {
    let version = |piece: &str| {
        // A string within a string ends with an escape.
        let (bare, end) = piece.split_at(piece.trim_end_matches('\\').len());
        // No longer than with an escape for every letter.
        if bare.len() > 7 * was.wire_version.len().max(now.wire_version.len()) {
            return piece.to_owned();
        }
        let letters = letters(bare);
        let read: String = letters.iter().map(|(_, letter)| *letter).collect();
        let other = match read {
            _ if read == was.wire_version => &now.wire_version,
            _ if read == now.wire_version => &was.wire_version,
            _ => return piece.to_owned(),
        };
        // A letter that stays is spelled as it was.
        let spelled = other.chars().enumerate().map(|(at, letter)| match letters.get(at) {
            Some((spelled, same)) if *same == letter => (*spelled).to_owned(),
            _ => letter.to_string(),
        });
        format!("{}{end}", spelled.collect::<String>())
    };
    let pieces: Vec<String> = text.split('"').map(version).collect();
    pieces.join("\"").replace(&was.contract_hash, &now.contract_hash)
}

/// The letters of a string within a string, each as it is spelled and as it is read.
fn letters(mut text: &str) -> Vec<(&str, char)> {
    let mut letters = Vec::new();
    while let Some(first) = text.chars().next() {
        let escaped = text.strip_prefix(r"\\u").and_then(|rest| u32::from_str_radix(rest.get(..4)?, 16).ok());
        let (spelled, letter) = match escaped.and_then(char::from_u32) {
            Some(letter) => (text.get(..7).unwrap_or(text), letter),
            None => (text.get(..first.len_utf8()).unwrap_or(text), first),
        };
        letters.push((spelled, letter));
        text = text.get(spelled.len()..).unwrap_or_default();
    }
    letters
}

#[cfg(test)]
mod tests {
    use super::*;

    fn contract(version: &str, hash: &str) -> Contract {
        Contract { wire_version: version.to_owned(), contract_hash: hash.to_owned() }
    }

    #[test]
    fn versions_and_hashes_change_and_numbers_stay() {
        let (was, now) = (contract("0.5", "c0"), contract("0.6", "d1"));
        let text = r#"{"version":"0.5","text":"{\"ncp_version\":\"0.5\",\"t\":0.5,\"other\":\"0.6\"}","hash":"c0"}"#;
        let then = r#"{"version":"0.6","text":"{\"ncp_version\":\"0.6\",\"t\":0.5,\"other\":\"0.5\"}","hash":"d1"}"#;
        assert_eq!(spoken(text, &was, &now), then);
        assert_eq!(spoken(r#"["0.5.0","00.5","0.50"]"#, &was, &now), r#"["0.5.0","00.5","0.50"]"#);
        assert_eq!(spoken(text, &was, &was), text);
        let escaped = r#"{"text":"{\"v\":\"\\u0030\\u002E5\",\"w\":\"0.\\u0035\",\"x\":\"\\u00305\"}"}"#;
        let then = r#"{"text":"{\"v\":\"\\u0030\\u002E6\",\"w\":\"0.6\",\"x\":\"\\u00305\"}"}"#;
        assert_eq!(spoken(escaped, &was, &now), then);
    }
}
