//! Code and text name the same rules.
#![allow(clippy::unwrap_used, reason = "helpers of tests may panic as tests may")]

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use ncp_text::catalogue::Catalogue;

/// Rules of the chapters 1 to 6 that bind a deployment or a person, and no function of a library.
const NOT_EXECUTABLE: [&str; 4] = ["NCP-OBS-010", "NCP-PLANE-007", "NCP-PLANE-008", "NCP-PROV-009"];

/// Every id of a rule in the sources, the catalogue's own examples aside.
fn named_in_the_code() -> BTreeSet<String> {
    let mut ids = BTreeSet::new();
    for file in sources(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/src"))) {
        if file.ends_with("catalogue.rs") {
            continue;
        }
        let code = std::fs::read_to_string(file).unwrap();
        let is_id = |c: char| c.is_ascii_uppercase() || c.is_ascii_digit() || c == '-';
        ids.extend(code.split(|c| !is_id(c)).filter(|word| word.starts_with("NCP-")).map(String::from));
    }
    ids
}

fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(sources(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files
}

#[test]
fn every_rule_that_the_code_names_is_in_the_text() {
    let catalogue = Catalogue::load().unwrap();
    let unknown: Vec<_> = named_in_the_code().into_iter().filter(|id| catalogue.get(id).is_none()).collect();
    assert!(unknown.is_empty(), "{unknown:?}");
}

#[test]
fn every_rule_of_the_wire_is_named_where_the_code_executes_it() {
    let named = named_in_the_code();
    let areas = ["WIRE", "VER", "PLANE", "KEY", "BULK", "OBS", "PROV"];
    let catalogue = Catalogue::load().unwrap();
    let unnamed: Vec<_> = catalogue
        .iter()
        .filter(|rule| areas.contains(&rule.area()) && rule.keyword.is_binding())
        .map(|rule| rule.id.as_str())
        .filter(|id| !named.contains(*id))
        .collect();
    assert_eq!(unnamed.into_iter().collect::<BTreeSet<_>>(), BTreeSet::from(NOT_EXECUTABLE));
}
