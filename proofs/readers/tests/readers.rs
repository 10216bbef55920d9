//! The exhaustive engine on smaller bounds: the readers hold, the broken ones do not.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::collections::BTreeSet;

use ncp_proofs::engines::native::{Native, Sample};
use ncp_readers::broken::BROKEN;
use ncp_readers::exhaustive;
use ncp_readers::properties::keys::CLASSES as KEYS;
use ncp_readers::properties::strings::{Alphabet, LONGEST, canonical};
use ncp_readers::properties::version::CLASSES as VERSIONS;
use ncp_readers::properties::{PROPERTIES, Property, harness};
use ncp_text::catalogue::Catalogue;

/// Bounds that a build without optimisation works off in a moment.
fn short(property: &Property) -> usize {
    match property.id {
        "version/classes" | "keys/segment" | "keys/realm" => 4,
        "version/scalars" | "keys/scalars" => 0,
        "bulk/directories" => 1,
        _ => 2,
    }
}

#[test]
fn the_readers_hold_within_shorter_bounds() {
    for property in PROPERTIES {
        let harness = harness(property.id).unwrap();
        let outcome = exhaustive::run(property, harness.enumerate, Some(short(property)));
        assert!(outcome.is_proved(), "{}: {outcome:?}", property.id);
        assert!(outcome.inputs > 5, "{}", property.id);
    }
}

#[test]
fn the_readers_hold_on_samples_of_the_whole_bounds() {
    for property in PROPERTIES {
        let harness = harness(property.id).unwrap();
        let mut native = Native::new(Sample::new(0, LONGEST));
        for seed in 0..5_000 {
            native.draw = Sample::new(seed, LONGEST);
            native.again();
            (harness.sample)(&mut native);
        }
        assert_eq!(native.failed, None, "{}", property.id);
        assert!(!native.reached.is_empty(), "{}", property.id);
    }
}

#[cfg(feature = "broken")]
mod broken_ones {
    use ncp_proofs::engines::native::Replay;
    use ncp_readers::broken;
    use ncp_readers::properties::{is_shown, vector};

    use super::*;

    /// What only strings and directories beyond the short bounds refute.
    const LONGER: [&str; 6] = [
        "version_trimmed",
        "version_five_digits",
        "keys_short",
        "keys_unchecked_glob",
        "bulk_unsorted_names",
        "bulk_encoder_duplicates",
    ];

    #[test]
    fn every_one_is_refuted_by_a_vector_that_the_sound_one_keeps() {
        for broken in BROKEN.iter().filter(|b| !LONGER.contains(&b.id)) {
            let property = PROPERTIES.iter().find(|p| p.id == broken.property).unwrap();
            let enumerate = broken::harness(broken.id, broken.property).unwrap();
            let bound = Some(short(property).max(2));
            let outcome = exhaustive::run(property, enumerate, bound);
            assert!(!outcome.is_proved(), "{}", broken.id);
            let found = outcome.counterexample.unwrap();
            assert!(is_shown(property, found.check), "{}: {found:?}", broken.id);
            let choices = found.ways();
            let case = vector(property, broken.id, &choices).unwrap();
            for member in ["id", "title", "requirements", "roles", "call", "args", "expect", "why"] {
                assert!(!case[member].is_null(), "{}: {member}", broken.id);
            }
            let mut sound = Native::new(Replay { choices: choices.into(), length: LONGEST, ..Replay::default() });
            (harness(property.id).unwrap().replay)(&mut sound);
            assert_eq!(sound.failed, None, "{}", broken.id);
            assert!(!sound.reached.is_empty(), "{}", broken.id);
        }
    }

    #[test]
    fn one_that_panics_is_refuted_by_that() {
        let broken = BROKEN.iter().find(|b| b.id == "bulk_panics").unwrap();
        let property = PROPERTIES.iter().find(|p| p.id == broken.property).unwrap();
        let enumerate = broken::harness(broken.id, broken.property).unwrap();
        let found = exhaustive::run(property, enumerate, None).counterexample.unwrap();
        assert_eq!(found.check, exhaustive::PANICS);
    }
}

#[test]
fn each_family_of_readers_has_five_broken_ones_and_names_its_rules() {
    let catalogue = Catalogue::load().unwrap();
    for property in PROPERTIES {
        let family = property.family.as_str();
        assert!(BROKEN.iter().filter(|b| b.id.starts_with(family)).count() >= 5, "{family}");
        for rule in property.rules {
            assert!(catalogue.get(rule).is_some(), "{}: {rule}", property.id);
        }
    }
    let ids: BTreeSet<_> = BROKEN.iter().map(|broken| broken.id).collect();
    assert_eq!(ids.len(), BROKEN.len());
}

#[test]
fn the_classes_part_all_characters() {
    let is_sound = |alphabet: Alphabet| {
        for c in '\0'..=char::MAX {
            let class = alphabet.iter().find(|class| (class.holds)(c));
            assert_eq!(class.map(|class| class.width), Some(c.len_utf8()), "{c:?}");
        }
        for class in alphabet {
            for member in class.members {
                let first = class.members.first().unwrap().to_string();
                assert_eq!(canonical(&member.to_string(), alphabet), first, "{member:?}");
            }
        }
        assert!(alphabet.is_sorted_by_key(|class| class.width));
    };
    is_sound(KEYS);
    is_sound(VERSIONS);
}
