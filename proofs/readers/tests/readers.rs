//! The exhaustive engine on smaller bounds: the readers hold, the broken ones do not.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use ncp_proofs::provers::native::{Native, Sample};
use ncp_readers::broken::defects;
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
    use ncp_proofs::provers::native::Replay;
    use ncp_readers::broken;
    use ncp_readers::properties::{is_shown, vector};

    use super::*;

    /// What only strings and directories beyond the short bounds refute.
    const LONGER: [&str; 6] = [
        "version-trimmed",
        "version-five-digits",
        "keys-short",
        "keys-unchecked-glob",
        "bulk-unsorted-names",
        "bulk-encoder-duplicates",
    ];

    #[test]
    fn every_one_is_refuted_by_a_vector_that_the_sound_one_keeps() {
        for defect in defects().unwrap().iter().filter(|defect| !LONGER.contains(&&*defect.name)) {
            let (name, id) = (&*defect.name, &*defect.properties[0]);
            let property = PROPERTIES.iter().find(|property| property.id == id).unwrap();
            let enumerate = broken::harness(name, id).unwrap();
            let bound = Some(short(property).max(2));
            let outcome = exhaustive::run(property, enumerate, bound);
            assert!(!outcome.is_proved(), "{name}");
            let found = outcome.counterexample.unwrap();
            assert!(is_shown(property, found.check), "{name}: {found:?}");
            let choices = found.ways();
            let case = vector(property, name, &choices).unwrap();
            for member in ["id", "title", "requirements", "roles", "call", "args", "expect", "why"] {
                assert!(!case[member].is_null(), "{name}: {member}");
            }
            let mut sound = Native::new(Replay { choices: choices.into(), length: LONGEST, ..Replay::default() });
            (harness(property.id).unwrap().replay)(&mut sound);
            assert_eq!(sound.failed, None, "{name}");
            assert!(!sound.reached.is_empty(), "{name}");
        }
    }

    #[test]
    fn one_that_panics_is_refuted_by_that() {
        let (name, id) = ("bulk-panics", "bulk/entry");
        let property = PROPERTIES.iter().find(|property| property.id == id).unwrap();
        let enumerate = broken::harness(name, id).unwrap();
        let found = exhaustive::run(property, enumerate, None).counterexample.unwrap();
        assert_eq!(found.check, exhaustive::PANICS);
    }
}

#[test]
fn each_family_of_readers_has_five_broken_ones_and_names_its_rules() {
    let (catalogue, defects) = (Catalogue::load().unwrap(), defects().unwrap());
    let breaks = |id: &str| PROPERTIES.iter().find(|property| property.id == id);
    for property in PROPERTIES {
        let is_mine = |id: &String| breaks(id).is_some_and(|other| other.family == property.family);
        assert!(defects.iter().filter(|defect| defect.properties.iter().any(is_mine)).count() >= 5, "{}", property.id);
        for rule in property.rules {
            assert!(catalogue.get(rule).is_some(), "{}: {rule}", property.id);
        }
    }
    for defect in &defects {
        let properties: Vec<_> = defect.properties.iter().map(|id| breaks(id).unwrap()).collect();
        assert!(!properties.is_empty(), "{}", defect.name);
        for rule in properties.iter().flat_map(|property| property.rules) {
            assert!(defect.rules.iter().any(|known| known == rule), "{}: {rule}", defect.name);
        }
    }
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
