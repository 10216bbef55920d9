//! The engine on shorter bounds: the sources hold, and what is planted names its claims and rules.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::collections::{BTreeMap, BTreeSet};

use ncp_path::claims::CLAIMS;
use ncp_path::engine::Scope;
use ncp_path::subjects::{PRODUCTION, defects, harness};
use ncp_text::catalogue::Catalogue;

/// What takes minutes without optimisation even when it is short.
const LONG: [&str; 3] = ["link/step", "loop/tick", "governor/binding"];

#[test]
fn the_sources_hold_within_shorter_bounds() {
    for claim in CLAIMS.iter().filter(|claim| !LONG.contains(&claim.id)) {
        let outcome = harness(PRODUCTION, claim.id).unwrap()(Scope::Short);
        assert!(outcome.is_kept(), "{}: {outcome:?}", claim.id);
    }
}

#[test]
fn planted_defects_are_refuted_within_shorter_bounds_where_these_suffice() {
    let mut refuted = BTreeMap::<&str, usize>::new();
    for defect in defects().unwrap() {
        for id in defect.properties.iter().filter(|id| !LONG.contains(&id.as_str())) {
            let found = harness(&defect.name, id).unwrap()(Scope::Short).counterexample.is_some();
            let claim = CLAIMS.iter().find(|claim| claim.id == id).unwrap();
            *refuted.entry(claim.family()).or_default() += usize::from(found);
        }
    }
    for family in ["estop", "governor", "link", "loop", "liveness"] {
        assert!(refuted.get(family).is_some_and(|count| *count >= 5), "{family}: {refuted:?}");
    }
}

#[test]
fn every_claim_names_its_rules_and_has_a_defect_of_its_own() {
    let (catalogue, defects) = (Catalogue::load().unwrap(), defects().unwrap());
    let planted: BTreeSet<&str> = defects.iter().flat_map(|defect| &defect.properties).map(String::as_str).collect();
    for claim in CLAIMS {
        assert!(harness(PRODUCTION, claim.id).is_some(), "{}", claim.id);
        assert!(planted.contains(claim.id), "{} refutes nothing", claim.id);
        for rule in claim.rules {
            assert!(catalogue.get(rule).is_some(), "{}: {rule}", claim.id);
        }
    }
    for defect in &defects {
        assert!(!defect.rules.is_empty() && !defect.properties.is_empty(), "{}", defect.name);
        for rule in &defect.rules {
            assert!(catalogue.get(rule).is_some(), "{}: {rule}", defect.name);
        }
        for id in &defect.properties {
            assert!(CLAIMS.iter().any(|claim| claim.id == id), "{}: {id}", defect.name);
        }
    }
}
