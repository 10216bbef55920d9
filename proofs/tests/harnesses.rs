//! The harnesses hold on the kernel of production, and reach what they check.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::collections::BTreeSet;

use ncp_proofs::broken::{BROKEN, missing};
use ncp_proofs::engines::{Verdict, enumeration, standin};
use ncp_proofs::kernel::Production;
use ncp_proofs::properties::{Family, PROPERTIES, harness};
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
fn every_family_has_five_broken_kernels_and_each_a_property() {
    for family in Family::ALL {
        let mine = BROKEN.iter().filter(|b| b.id.starts_with(family.as_str()));
        assert!(mine.count() >= 5, "{family:?}");
    }
    let ids: BTreeSet<_> = BROKEN.iter().map(|broken| broken.id).collect();
    assert_eq!(ids.len(), BROKEN.len());
    for broken in BROKEN {
        let property = PROPERTIES.iter().find(|p| p.id == broken.property);
        assert!(property.is_some_and(|p| broken.id.starts_with(p.family.as_str())), "{}", broken.id);
    }
}

#[test]
fn every_broken_kernel_is_a_change_of_the_kernel_as_it_is() {
    assert_eq!(missing(), Vec::<String>::new());
}
