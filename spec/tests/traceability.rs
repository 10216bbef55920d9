//! Code and text name the same rules.
#![allow(clippy::unwrap_used, reason = "helpers of tests may panic as tests may")]

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use ncp_text::Catalogue;
use ncp_text::citations::cited;
use ncp_text::exclusions::{Exclusions, Lack};

/// Every id of a rule in the sources.
fn named_in_the_code() -> BTreeSet<String> {
    let mut ids = BTreeSet::new();
    for file in sources(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/src"))) {
        let code = std::fs::read_to_string(file).unwrap();
        ids.extend(cited(&code).into_iter().map(|citation| citation.id));
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
    // What only running programs can do, the live judge holds them to.
    let live = cited(include_str!("../../live/scenarios.toml"));
    let live: BTreeSet<&str> = live.iter().map(|citation| citation.id.as_str()).collect();
    let catalogue = Catalogue::load().unwrap();
    let unnamed: BTreeSet<_> = catalogue
        .iter()
        .filter(|rule| areas.contains(&rule.area()) && rule.keyword.is_binding())
        .map(|rule| rule.id.as_str())
        .filter(|id| !named.contains(*id) && !live.contains(*id))
        .collect();
    let exclusions = Exclusions::load().unwrap();
    assert_eq!(unnamed, exclusions.without(Lack::Code).map(|(id, _)| id).collect());
}
