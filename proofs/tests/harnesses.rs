//! The harnesses hold on the kernel of production, and reach what they check.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;
use std::path::Path;

use ncp_proofs::broken::{defects, missing};
use ncp_proofs::engines::{Verdict, enumeration, standin};
use ncp_proofs::harness::harness;
use ncp_proofs::kernel::Production;
use ncp_proofs::properties::{Family, PROPERTIES};
use ncp_proofs::sabotage;
use ncp_text::catalogue::Catalogue;

#[test]
fn every_harness_holds_on_samples_and_reaches_a_check() {
    for property in PROPERTIES {
        let harness = harness::<Production>(property.id).unwrap();
        let outcome = standin::run(&harness, 5_000, usize::MAX);
        assert_eq!(outcome.verdict, Verdict::Tried, "{}: {outcome:?}", property.id);
        assert!(!outcome.reached.is_empty(), "{}", property.id);
    }
}

#[test]
fn every_harness_holds_on_all_combinations_of_its_values_in_short_sequences() {
    for property in PROPERTIES {
        let harness = harness::<Production>(property.id).unwrap();
        let Some(outcome) = enumeration::run(property, &harness, 3) else {
            continue;
        };
        assert_eq!(outcome.verdict, Verdict::Proved, "{}: {outcome:?}", property.id);
    }
}

/// A harness takes the state of gates, plant and watchdog; state that is kept elsewhere it would not see.
#[test]
fn the_kernel_keeps_no_state_beside_its_structs() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../spec/kernel/src");
    let files = [root.clone(), root.join("decisions")].map(|folder| fs::read_dir(folder).unwrap());
    let files: Vec<_> = files.into_iter().flatten().map(|entry| entry.unwrap().path()).collect();
    let sources = files.iter().filter(|file| file.is_file()).map(|file| fs::read_to_string(file).unwrap());
    let text: String = sources
        .flat_map(|text| text.lines().map(str::to_owned).collect::<Vec<_>>())
        .fold(String::new(), |all, line| all + line.split("//").next().unwrap_or_default() + "\n");
    assert!(text.contains("pub struct Gates"), "{files:?}");
    let is_part = |c: char| c.is_alphanumeric() || c == '_' || c == '\'';
    let kept = |word: &&str| {
        matches!(*word, "static" | "thread_local" | "unsafe")
            || ["Atomic", "Once", "Lazy"].iter().any(|start| word.starts_with(start))
            || ["Cell", "Lock", "Mutex"].iter().any(|end| word.ends_with(end))
    };
    assert_eq!(text.split(|c| !is_part(c)).find(kept), None);
}

#[test]
fn every_property_names_rules_of_the_text() {
    let catalogue = Catalogue::load().unwrap();
    for property in PROPERTIES {
        assert!(!property.rules.is_empty(), "{}", property.id);
        for rule in property.rules {
            assert!(catalogue.get(rule).is_some(), "{}: {rule}", property.id);
        }
    }
}

/// Properties about many gates or ends at once, of which one defect breaks some.
const IN_PARTS: [&str; 2] = ["latch/closed", "latch/replay"];

#[test]
fn every_family_has_five_broken_kernels_and_each_defect_a_property_and_its_rules() {
    let defects = defects().unwrap();
    let is_machine = |id: &String| id.starts_with("machine/");
    let own = |id: &String| PROPERTIES.iter().find(|property| property.id == *id);
    for family in Family::ALL {
        let is_mine = |id: &String| own(id).is_some_and(|property| property.family == family);
        assert!(defects.iter().filter(|defect| defect.properties.iter().any(is_mine)).count() >= 5, "{family:?}");
    }
    for defect in &defects {
        assert!(!defect.properties.is_empty(), "{}", defect.name);
        for id in &defect.properties {
            assert!(is_machine(id) || own(id).is_some(), "{}: {id}", defect.name);
            let Some(property) = own(id) else { continue };
            let mut unbroken = property.rules.iter().filter(|rule| !defect.rules.iter().any(|broken| broken == *rule));
            if IN_PARTS.contains(&property.id) {
                assert!(unbroken.count() < property.rules.len(), "{}: no rule of {id}", defect.name);
            } else {
                assert_eq!(unbroken.next(), None, "{}: a rule of {id}", defect.name);
            }
        }
    }
}

#[test]
fn every_broken_kernel_is_a_change_of_the_kernel_as_it_is() {
    assert_eq!(missing(), Vec::<String>::new());
}

#[test]
fn the_engine_has_more_than_ten_defects_of_its_own_in_the_sources_that_are_woven() {
    let defects = sabotage::defects().unwrap();
    assert!(defects.len() > 10);
    for edit in defects.iter().flat_map(|defect| &defect.edit) {
        let is_woven =
            ["proofs/src/engines/", "proofs/src/provers/"].iter().any(|folder| edit.file.starts_with(folder));
        assert!(is_woven, "{}", edit.file);
    }
    // This build has no switches.
    assert!(sabotage::switch_on(&defects[0].name).is_err());
}
