//! The defects of the Rust peer: known rules and findings, and the classes that the suite is meant to detect.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::collections::HashSet;
use std::path::Path;

use ncp_defects::{Defect, read};
use ncp_text::Catalogue;

/// The audited findings that a call of the peer protocol shows; the others are about memory, transports and
/// deployments.
const OBSERVABLE: [&str; 20] = [
    "L01", "L02", "L03", "L04", "L06", "L07", "L08", "L09", "L10", "L11", "L12", "L13", "L14", "L15", "L21", "L22",
    "L24", "L25", "L27", "L28",
];

fn defects() -> Vec<Defect> {
    read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("peer")).unwrap()
}

#[test]
fn there_are_at_least_a_hundred() {
    assert!(defects().len() >= 100);
}

#[test]
fn names_are_of_lower_case_words_and_every_edit_is_of_a_source_of_the_peer() {
    for Defect { name, about, edit, .. } in defects() {
        let is_word =
            |word: &str| !word.is_empty() && word.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit());
        assert!(name.split('-').all(is_word), "{name}");
        assert!(about.contains(' '), "{name}: {about}");
        for edit in edit {
            let folders = ["spec/kernel/src/", "spec/src/", "peers/adapter/src/", "peers/rust/src/"];
            assert!(folders.iter().any(|folder| edit.file.starts_with(folder)), "{name}");
            assert_ne!(edit.after.as_deref(), Some(""), "{name} has an anchor that stands everywhere");
        }
    }
}

#[test]
fn every_rule_is_one_of_the_text() {
    let catalogue = Catalogue::load().unwrap();
    for Defect { name, rules, .. } in defects() {
        assert!(!rules.is_empty(), "{name} breaks no rule");
        for rule in rules {
            assert!(catalogue.get(&rule).is_some(), "{name}: there is no rule {rule}");
        }
    }
}

#[test]
fn every_observable_finding_is_brought_back_and_every_defect_is_of_a_known_class() {
    let found: HashSet<String> = defects().into_iter().map(|defect| defect.finding).collect();
    for finding in OBSERVABLE {
        assert!(found.contains(finding), "no defect brings back {finding}");
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
fn every_rule_of_the_strict_profile_is_broken_by_a_defect() {
    let broken: HashSet<String> = defects().into_iter().filter_map(|defect| defect.rules.into_iter().next()).collect();
    let catalogue = Catalogue::load().unwrap();
    let strict = catalogue.iter().filter(|rule| rule.id.starts_with("NCP-STRICT-"));
    let mut rules = 0;
    for rule in strict {
        assert!(broken.contains(&rule.id), "no defect breaks {}", rule.id);
        rules += 1;
    }
    assert_eq!(rules, 13);
}

#[test]
fn a_name_that_stands_twice_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let one = "[[defect]]\nname = \"twin\"\nabout = \"\"\nrules = []\n\
               [[defect.edit]]\nfile = \"\"\ncode = \"\"\nwith = \"\"\n";
    for file in ["a.toml", "b.toml"] {
        std::fs::write(folder.path().join(file), one).unwrap();
    }
    let error = read(folder.path()).unwrap_err();
    assert_eq!(error.to_string(), "two defects are called twin");
}
