//! The kernels of a hostile auditor: of every class, single and in combination, each of rules of the text.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use ncp_defects::{Defect, place, read};
use ncp_text::Catalogue;

const CLASSES: [&str; 10] =
    ["frame", "horizon", "compose", "counter", "width", "channel", "number", "magic", "time", "watchdog"];

fn hostile() -> Vec<Defect> {
    read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("hostile.toml")).unwrap()
}

#[test]
fn every_class_has_kernels_and_one_is_a_composite_of_at_least_seventeen() {
    let kernels = hostile();
    let (single, combined): (Vec<_>, Vec<_>) = kernels.iter().partition(|defect| defect.of.is_empty());
    assert!(single.len() >= 60 && combined.len() >= 10, "{} and {}", single.len(), combined.len());
    for class in CLASSES {
        assert!(single.iter().any(|defect| defect.name.starts_with(class)), "no kernel of the class {class}");
    }
    assert!(combined.iter().any(|defect| defect.of.len() >= 17));
}

#[test]
fn the_edits_of_each_kernel_have_places_of_their_own_and_can_be_made_one_behind_the_other() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    for defect in hostile() {
        let files: BTreeSet<&str> = defect.edit.iter().map(|edit| edit.file.as_str()).collect();
        for file in files {
            let source = fs::read_to_string(root.join(file)).unwrap();
            let source = place::without_tests(&source);
            place::plant(source, file, &defect).unwrap();
            let edits = defect.edit.iter().filter(|edit| edit.file == file);
            let mut places: Vec<_> = edits.map(|edit| place::find(source, &defect.name, edit).unwrap()).collect();
            places.sort_by_key(|place| place.start);
            for pair in places.windows(2) {
                assert!(pair[0].end <= pair[1].start, "{}: {}", defect.name, &source[pair[1].clone()]);
            }
        }
    }
}

#[test]
fn every_rule_is_one_of_the_text() {
    let catalogue = Catalogue::load().unwrap();
    for Defect { name, rules, .. } in hostile() {
        assert!(!rules.is_empty(), "{name} breaks no rule");
        for rule in rules {
            assert!(catalogue.get(&rule).is_some(), "{name}: there is no rule {rule}");
        }
    }
}
