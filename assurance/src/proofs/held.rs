//! What a lock has to say, whatever a report says: its entries are held against the tables of claims and defects, its
//! counts against its entries, and its questions against the files of the evidence.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::ErrorKind;
use std::path::Path;

use ncp_proofs::engines::bounds;
use ncp_proofs::properties::PROPERTIES;
use ncp_proofs::report;

use super::theorem::{CLAIMS, Claims};
use super::{Lock, ProofsError};

/// The word for a claim that an engine tried on values that a table lists.
pub(super) const LISTED: &str = "holds on the listed values";
/// The word for a defect that an engine does not see.
pub(super) const MISSED: &str = "NOT refuted";
const EVIDENCE: &str = "proofs/evidence";
/// What stands in a file of the evidence for each of its questions.
const QUESTION: &str = "(check-sat";

/// Whether an engine only tries a claim on values that a table lists: an enumeration always, and any engine where the
/// harness itself draws nothing else.
pub(super) fn is_listed(engine: &str, claim: &str) -> bool {
    engine == "enumeration" || claim.starts_with("number/")
}

/// The entry of a defect: an id is one of a family, and each property has a word of its own.
pub(super) fn defect(engine: &str, family: &str, id: &str, property: &str) -> String {
    let id = id.strip_prefix(&format!("{family}/")).unwrap_or(id);
    format!("{engine} defect {family}/{id} by {property}")
}

/// How many entries came to which end, by engine.
pub(super) fn counts(fates: &BTreeMap<String, String>) -> BTreeMap<String, u64> {
    let mut counts = BTreeMap::new();
    for (id, fate) in fates {
        let (engine, of) = id.split_once(' ').unwrap_or((id, ""));
        let end = match (fate.as_str(), of.starts_with("defect ")) {
            (LISTED, _) => "listed",
            (MISSED, _) => "missed",
            ("refuted", false) => "claims-refuted",
            (fate, _) => fate,
        };
        *counts.entry(format!("{engine}-{end}")).or_default() += 1;
    }
    counts
}

/// Why a lock of the proofs is not to be believed.
///
/// # Errors
/// A table, or a file of the evidence, cannot be read.
pub(crate) fn wrong(root: &Path, artefact: &str) -> Result<Vec<String>, ProofsError> {
    let Some(lock) = Lock::read(root, artefact)? else { return Ok(Vec::new()) };
    let mut wrong = Vec::new();
    if counts(&lock.fates) != lock.counts {
        wrong.push("the counts are not those of the entries".to_owned());
    }
    wrong.extend(lock.fates.iter().filter(|(id, fate)| !is_good(id, fate)).map(|(id, fate)| format!("{id}: {fate}")));
    let due = due(root, artefact)?;
    let missing = due.iter().filter(|due| !lock.fates.keys().any(|id| due.is(id)));
    wrong.extend(missing.map(|Due { engine, what, by }| format!("{engine} has no word on {what}{}", shown(by))));
    if artefact == "proofs-kernel" {
        let strange = lock.fates.keys().filter(|id| !due.iter().any(|due| due.is(id)));
        wrong.extend(strange.map(|id| format!("{id} is in no table")));
        for claim in report::properties() {
            let rules: BTreeSet<&String> = claim.words.rules.iter().collect();
            let (kept, scope) = (lock.rules.get(&claim.id), lock.claims.get(&claim.id));
            let is_same = kept.is_some_and(|kept| kept.iter().collect::<BTreeSet<_>>() == rules)
                && scope.is_some_and(|scope| scope.bounds == claim.words.bounds)
                && scope.is_some_and(|scope| scope.assumptions == claim.words.assumptions);
            wrong.extend((!is_same).then(|| format!("{}: rules, bounds or assumptions are not its table's", claim.id)));
            let asked = lock.asked.get(&format!("symbolic {}", claim.id)).and_then(|asked| asked.questions);
            let (asked, filed) = (asked.unwrap_or_default(), questions(&root.join(EVIDENCE).join(&claim.id))?);
            let line = || format!("{}: {asked} questions were asked, and {filed} are in {EVIDENCE}", claim.id);
            wrong.extend((asked != filed).then(line));
        }
    }
    Ok(wrong)
}

/// An entry that a table asks for: an engine's word on a claim, or on a defect by a property.
struct Due {
    engine: &'static str,
    /// The id of the claim or of the defect.
    what: String,
    /// The property that has to refute the defect.
    by: Option<String>,
}

impl Due {
    fn is(&self, id: &str) -> bool {
        let Self { engine, what, by } = self;
        match by {
            None => id == format!("{engine} {what}"),
            Some(by) => id.starts_with(&format!("{engine} defect ")) && id.ends_with(&format!("/{what} by {by}")),
        }
    }
}

fn shown(by: &Option<String>) -> String {
    by.as_ref().map_or_else(String::new, |by| format!(" by {by}"))
}

/// Whether an end is as it has to be: the stand-in proves nothing, and may miss.
fn is_good(id: &str, fate: &str) -> bool {
    let (engine, of) = id.split_once(' ').unwrap_or((id, ""));
    match (engine, of.starts_with("defect ")) {
        ("kani-stand-in", false) => fate == "tried",
        ("kani-stand-in", true) => fate == "refuted" || fate == MISSED,
        (_, false) if is_listed(engine, of) => fate == LISTED,
        // What was only tried says so, and the page does, too.
        (_, false) => fate == "proved" || fate == "tried",
        (_, true) => fate == "refuted",
    }
}

/// What the tables ask of an artefact; the model has its table in its program, which `cargo assure prove --fast` runs.
fn due(root: &Path, artefact: &str) -> Result<Vec<Due>, ProofsError> {
    let claim = |engine, what: &str| Due { engine, what: what.to_owned(), by: None };
    let covers = |engine: &str, property: &str| engine != "enumeration" || bounds::of(property).values.is_some();
    let mut all = Vec::new();
    let (table, engines): (&str, &[&'static str]) = match artefact {
        "proofs-kernel" => ("defects/kernel.toml", &["symbolic", "enumeration", "kani-stand-in"]),
        "proofs-machine" => ("defects/kernel.toml", &["machine"]),
        "proofs-readers" => ("defects/readers.toml", &["readers"]),
        "proofs-theorem" => {
            let path = root.join(CLAIMS);
            let text = fs::read_to_string(&path).map_err(|source| ProofsError::File { path: path.clone(), source })?;
            let claims: Claims = toml::from_str(&text).map_err(|source| ProofsError::Claims { path, source })?;
            return Ok(claims.ids().map(|id| claim("theorem", id)).collect());
        }
        _ => return Ok(all),
    };
    if artefact == "proofs-kernel" {
        for property in PROPERTIES {
            let covering = engines.iter().filter(|engine| covers(engine, property.id));
            all.extend(covering.map(|engine| claim(engine, property.id)));
        }
    }
    let mut named = BTreeSet::new();
    for defect in ncp_defects::read(&root.join(table))? {
        for engine in engines {
            let is_asked = defect.engines.is_empty() || defect.engines.iter().any(|name| name == engine);
            let knows = |property: &&String| property.starts_with("machine/") == (*engine == "machine");
            for property in defect.properties.iter().filter(knows).filter(|it| is_asked && covers(engine, it)) {
                named.insert((*engine, property.clone()));
                all.push(Due { engine, what: defect.name.clone(), by: Some(property.clone()) });
            }
        }
    }
    if artefact != "proofs-kernel" {
        // A property that has to refute something is a claim.
        all.extend(named.into_iter().map(|(engine, property)| claim(engine, &property)));
    }
    Ok(all)
}

/// How many questions stand in the files of a folder.
fn questions(folder: &Path) -> Result<u64, ProofsError> {
    let failed = |source| ProofsError::File { path: folder.to_owned(), source };
    let entries = match fs::read_dir(folder) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(0),
        entries => entries.map_err(failed)?,
    };
    let mut count = 0;
    for entry in entries {
        let text = fs::read_to_string(entry.map_err(failed)?.path()).map_err(failed)?;
        count += text.lines().filter(|line| line.starts_with(QUESTION)).map(|_| 1_u64).sum::<u64>();
    }
    Ok(count)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lock::{Asked, Scope};

    /// A project with one defect of the readers, and the lock that is due.
    fn project() -> (tempfile::TempDir, Lock) {
        let root = tempfile::tempdir().unwrap();
        fs::create_dir_all(root.path().join("defects")).unwrap();
        let table = "[[defect]]\nname = \"long\"\nabout = \"Too long.\"\nproperties = [\"keys/length\"]\n\
                     [[defect.edit]]\nfile = \"a.rs\"\ncode = \"1\"\nwith = \"2\"\n";
        fs::write(root.path().join("defects/readers.toml"), table).unwrap();
        let entries = [("readers keys/length", "proved"), ("readers defect keys/long by keys/length", "refuted")];
        let fates = entries.map(|(id, fate)| (id.to_owned(), fate.to_owned())).into();
        let lock = Lock { counts: counts(&fates), fates, ..Lock::default() };
        (root, lock)
    }

    fn said(root: &Path, lock: &Lock) -> Vec<String> {
        lock.write(root, "proofs-readers").unwrap();
        wrong(root, "proofs-readers").unwrap()
    }

    #[test]
    fn a_lock_that_says_what_the_tables_ask_for_is_believed() {
        let (root, lock) = project();
        assert_eq!(said(root.path(), &lock), [""; 0]);
    }

    #[test]
    fn a_lock_without_an_entry_or_with_another_end_or_other_counts_is_not() {
        let (root, lock) = project();
        let mut counted = lock.clone();
        counted.counts.insert("readers-proved".to_owned(), 2);
        assert_eq!(said(root.path(), &counted), ["the counts are not those of the entries"]);
        let without = |id: &str| {
            let mut lock = lock.clone();
            lock.fates.remove(id);
            lock.counts = counts(&lock.fates);
            said(root.path(), &lock)
        };
        assert_eq!(without("readers keys/length"), ["readers has no word on keys/length"]);
        assert_eq!(without("readers defect keys/long by keys/length"), ["readers has no word on long by keys/length"]);
        let mut failed = lock.clone();
        failed.fates.insert("readers keys/length".to_owned(), "failed".to_owned());
        failed.counts = counts(&failed.fates);
        assert_eq!(said(root.path(), &failed), ["readers keys/length: failed"]);
    }

    #[test]
    fn a_lock_of_the_kernel_needs_every_property_and_the_questions_of_the_evidence() {
        let root = tempfile::tempdir().unwrap();
        fs::create_dir_all(root.path().join("defects")).unwrap();
        fs::write(root.path().join("defects/kernel.toml"), "defect = []\n").unwrap();
        let mut lock = Lock::default();
        for Due { engine, what, .. } in due(root.path(), "proofs-kernel").unwrap() {
            let fate = match engine {
                "kani-stand-in" => "tried",
                _ if is_listed(engine, &what) => LISTED,
                _ => "proved",
            };
            lock.fates.insert(format!("{engine} {what}"), fate.to_owned());
        }
        lock.counts = counts(&lock.fates);
        for claim in report::properties() {
            let (bounds, assumptions) = (claim.words.bounds, claim.words.assumptions);
            lock.claims.insert(claim.id.clone(), Scope { bounds, assumptions, ..Scope::default() });
            lock.rules.insert(claim.id, claim.words.rules);
        }
        let said = |lock: &Lock| {
            lock.write(root.path(), "proofs-kernel").unwrap();
            wrong(root.path(), "proofs-kernel").unwrap()
        };
        assert_eq!(said(&lock), [""; 0]);
        let first = PROPERTIES[0].id;
        lock.asked.insert(format!("symbolic {first}"), Asked { questions: Some(7), ..Asked::default() });
        assert_eq!(said(&lock), [format!("{first}: 7 questions were asked, and 0 are in {EVIDENCE}")]);
        lock.asked.clear();
        lock.fates.remove(&format!("symbolic {first}"));
        lock.counts = counts(&lock.fates);
        assert_eq!(said(&lock), [format!("symbolic has no word on {first}")]);
    }
}
