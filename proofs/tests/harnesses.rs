//! The harnesses run everywhere, and reach what they check.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::collections::BTreeSet;

use ncp_proofs::broken::{self, BROKEN};
use ncp_proofs::engines::{Verdict, standin};
use ncp_proofs::kernel::Production;
use ncp_proofs::properties::{Family, PROPERTIES, harness};
use ncp_spec::catalogue::Catalogue;

#[test]
fn every_harness_holds_on_samples_and_reaches_a_check() {
    for property in PROPERTIES {
        let harness = harness::<Production>(property.id).unwrap();
        let (outcome, reached) = standin::run(&harness, 5_000);
        assert_eq!(
            outcome.verdict,
            Verdict::Tried,
            "{}: {outcome:?}",
            property.id
        );
        assert!(!reached.is_empty(), "{}", property.id);
    }
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

#[test]
fn every_family_has_five_broken_kernels_and_each_a_harness() {
    let families = [
        Family::Watchdog,
        Family::Geofence,
        Family::Clamp,
        Family::Latch,
    ];
    for family in families {
        let mine = BROKEN.iter().filter(|b| b.id.starts_with(family.as_str()));
        assert!(mine.count() >= 5, "{family:?}");
    }
    let ids: BTreeSet<_> = BROKEN.iter().map(|broken| broken.id).collect();
    assert_eq!(ids.len(), BROKEN.len());
    for broken in BROKEN {
        assert!(
            broken::harness(broken.id, broken.property).is_some(),
            "{}",
            broken.id
        );
    }
}
