//! The table: unique names, known rules and findings, the classes that the suite is meant to detect.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::collections::HashSet;
use std::path::Path;

use ncp_text::catalogue::Catalogue;

#[path = "../build/table.rs"]
mod table;

use table::Mutant;

/// The audited findings that a call of the peer protocol shows; the others are about memory, transports and
/// deployments.
const OBSERVABLE: [&str; 20] = [
    "L01", "L02", "L03", "L04", "L06", "L07", "L08", "L09", "L10", "L11", "L12", "L13", "L14", "L15", "L21", "L22",
    "L24", "L25", "L27", "L28",
];

fn mutants() -> Vec<Mutant> {
    table::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("mutants")).unwrap()
}

#[test]
fn there_are_at_least_a_hundred_mutants() {
    assert!(mutants().len() >= 100);
}

#[test]
fn names_are_of_lower_case_words_and_descriptions_are_sentences() {
    for Mutant { name, about, edit, .. } in mutants() {
        let is_word =
            |word: &str| !word.is_empty() && word.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit());
        assert!(name.split('-').all(is_word), "{name}");
        assert!(about.ends_with('.') && about.contains(' '), "{name}: {about}");
        assert!(!edit.is_empty(), "{name} changes nothing");
        for edit in edit {
            assert_ne!(edit.code, edit.with, "{name} changes nothing");
            let folders = ["spec/src/", "peers/rust/src/"];
            assert!(folders.iter().any(|folder| edit.file.starts_with(folder)), "{name}");
            assert_ne!(edit.after.as_deref(), Some(""), "{name} has an anchor that stands everywhere");
        }
    }
}

#[test]
fn every_rule_is_one_of_the_text() {
    let catalogue = Catalogue::load().unwrap();
    for Mutant { name, rules, .. } in mutants() {
        assert!(!rules.is_empty(), "{name} breaks no rule");
        for rule in rules {
            assert!(catalogue.get(&rule).is_some(), "{name}: there is no rule {rule}");
        }
    }
}

#[test]
fn every_observable_finding_has_a_mutant_and_every_mutant_a_known_class() {
    let found: HashSet<String> = mutants().into_iter().map(|mutant| mutant.finding).collect();
    for finding in OBSERVABLE {
        assert!(found.contains(finding), "no mutant brings back {finding}");
    }
    for finding in found {
        let is_audited = finding
            .strip_prefix('L')
            .and_then(|number| number.parse().ok())
            .is_some_and(|number: u8| (1..=35).contains(&number) && finding.len() == 3);
        assert!(is_audited || finding == "decision" || finding == "classic", "{finding}");
    }
}

#[test]
fn every_rule_of_the_strict_profile_has_a_mutant() {
    let broken: HashSet<String> = mutants().into_iter().filter_map(|mutant| mutant.rules.into_iter().next()).collect();
    let catalogue = Catalogue::load().unwrap();
    let strict = catalogue.iter().filter(|rule| rule.id.starts_with("NCP-STRICT-"));
    let mut rules = 0;
    for rule in strict {
        assert!(broken.contains(&rule.id), "no mutant breaks {}", rule.id);
        rules += 1;
    }
    assert_eq!(rules, 12);
}

#[test]
fn a_name_that_stands_twice_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let one = "[[mutant]]\nname = \"twin\"\nabout = \"\"\nfinding = \"classic\"\nrules = []\n\
               [[mutant.edit]]\nfile = \"\"\ncode = \"\"\nwith = \"\"\n";
    for file in ["a.toml", "b.toml"] {
        std::fs::write(folder.path().join(file), one).unwrap();
    }
    let error = table::read(folder.path()).unwrap_err();
    assert_eq!(error.to_string(), "two mutants are called twin");
}
