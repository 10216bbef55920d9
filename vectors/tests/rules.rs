//! The corpus and the rules of the text: every rule that is cited exists and binds who is asked,
//! and every rule that an answer can show has a case.

#![expect(clippy::unwrap_used, clippy::expect_used, reason = "a test that cannot go on has failed")]

mod on_disk;

use std::collections::{BTreeMap, BTreeSet};
use std::sync::LazyLock;

use ncp_text::catalogue::{Catalogue, Level, Requirement, Role};
use ncp_text::citations::cited as cited_in;
use ncp_text::exclusions::{Exclusions, Lack};
use serde_json::Value;

/// The cases of the corpus.
fn cases() -> Vec<Value> {
    static CASES: LazyLock<Vec<Value>> = LazyLock::new(|| {
        let files = on_disk::corpus().into_iter();
        let files = files.map(|(_, text)| serde_json::from_str::<Value>(&text).unwrap());
        files.flat_map(|file| file["cases"].as_array().unwrap().clone()).collect()
    });
    CASES.clone()
}

fn strings(list: &Value) -> Vec<&str> {
    let items = list.as_array().expect("a list");
    items.iter().map(|item| item.as_str().expect("a string")).collect()
}

/// The rules that a case cites; every one has to exist.
fn rules<'a>(case: &Value, catalogue: &'a Catalogue) -> Vec<&'a Requirement> {
    let ids = strings(&case["requirements"]);
    assert!(!ids.is_empty(), "{} cites no rule", case["id"]);
    let find = |id: &str| {
        catalogue.get(id).unwrap_or_else(|| panic_with(&format!("{} cites {id}, which is no rule", case["id"])))
    };
    ids.into_iter().map(find).collect()
}

#[expect(clippy::panic, reason = "a test that cannot go on has failed")]
fn panic_with(message: &str) -> ! {
    panic!("{message}")
}

#[test]
fn every_cited_rule_exists_and_is_cited_once_by_a_case() {
    let catalogue = Catalogue::load().unwrap();
    for case in cases() {
        let ids: Vec<_> = rules(&case, &catalogue).into_iter().map(|rule| &rule.id).collect();
        let different: BTreeSet<_> = ids.iter().collect();
        assert_eq!(different.len(), ids.len(), "{}", case["id"]);
    }
}

#[test]
fn a_case_is_asked_only_of_roles_that_its_rules_bind() {
    let catalogue = Catalogue::load().unwrap();
    for case in cases() {
        let rules = rules(&case, &catalogue);
        let roles = strings(&case["roles"]);
        assert!(!roles.is_empty(), "{} is asked of nobody", case["id"]);
        for role in roles {
            let role = Role::parse(role).unwrap();
            assert!(rules.iter().any(|rule| rule.binds(role)), "{}: no cited rule binds {role}", case["id"]);
        }
    }
}

#[test]
fn what_another_rule_decides_is_decided_by_a_rule_of_the_text_and_no_rule_from_above_the_case() {
    let catalogue = Catalogue::load().unwrap();
    for case in cases() {
        let own = rules(&case, &catalogue);
        let level = own.iter().map(|rule| rule.level).max();
        let others: Vec<(&String, &Value)> = case["by"].as_object().into_iter().flatten().collect();
        for &(place, id) in &others {
            let id = id.as_str().unwrap();
            let rule = catalogue.get(id);
            let rule = rule.unwrap_or_else(|| panic_with(&format!("{} names {id}, which is no rule", case["id"])));
            // Its own rule is named only within what another decides.
            let is_around = |around: &str| around == "within" || place.starts_with(&format!("{around}/"));
            let is_within = others.iter().any(|(around, other)| *other != id && is_around(around));
            assert!(rule.id != own[0].id || is_within, "{} names its own rule at {place}", case["id"]);
            assert!(Some(rule.level) <= level, "{} is judged at {place} by {id} of a higher level", case["id"]);
            let steps = case["args"]["steps"].as_array().or(case["args"]["requests"].as_array());
            let step = place.split('/').nth(2).and_then(|step| step.parse::<u64>().ok());
            // A run of equal steps is written once, and so are rounds of several.
            let round = |step: &Value| match step.get("$items") {
                Some(items) => items.as_array().map(|items| items.len() as u64),
                None => step.get("$item").map(|_| 1),
            };
            let count = |step: &Value| round(step).map_or(1, |round| round * step["times"].as_u64().unwrap_or(1));
            let steps = steps.map_or(1, |steps| steps.iter().map(count).sum());
            assert!(step.is_none_or(|step| step < steps), "{} has no {place}", case["id"]);
        }
    }
}

#[test]
fn a_case_rests_on_other_cases_of_no_higher_level() {
    let catalogue = Catalogue::load().unwrap();
    let cases = cases();
    let level = |case: &Value| rules(case, &catalogue).iter().map(|rule| rule.level).max();
    let levels: BTreeMap<_, _> = cases.iter().map(|case| (case["id"].as_str().unwrap(), level(case))).collect();
    let resting = cases.iter().filter_map(|case| Some((case, case["rests_on"].as_array()?)));
    for (case, beneath) in resting {
        for id in beneath.iter().map(|id| id.as_str().unwrap()) {
            assert_ne!(case["id"], id);
            let beneath = levels.get(id).unwrap_or_else(|| panic_with(&format!("{} rests on {id}", case["id"])));
            assert!(*beneath <= level(case), "{} rests on {id} of a higher level", case["id"]);
        }
    }
}

#[test]
fn what_the_text_only_advises_never_binds() {
    let catalogue = Catalogue::load().unwrap();
    for case in cases() {
        let binding: BTreeSet<bool> = rules(&case, &catalogue).iter().map(|rule| rule.keyword.is_binding()).collect();
        assert_eq!(binding.len(), 1, "{} cites binding rules and advice", case["id"]);
    }
}

#[test]
fn every_case_of_the_wire_areas_is_of_level_wire() {
    let catalogue = Catalogue::load().unwrap();
    let areas = ["wire/", "version/", "keys/", "bulk/", "hostile/"];
    let is_wire = |case: &Value| areas.iter().any(|area| case["id"].as_str().unwrap().starts_with(area));
    for case in cases().into_iter().filter(is_wire) {
        assert!(rules(&case, &catalogue).iter().all(|rule| rule.level == Level::Wire), "{}", case["id"]);
    }
}

#[test]
fn every_binding_rule_of_the_wire_has_a_case_a_live_scenario_or_a_reason_for_neither() {
    let catalogue = Catalogue::load().unwrap();
    let mut cited: BTreeMap<String, usize> = BTreeMap::new();
    for case in cases() {
        for rule in rules(&case, &catalogue) {
            *cited.entry(rule.id.clone()).or_default() += 1;
        }
    }
    let exclusions = Exclusions::load().unwrap();
    let live: BTreeSet<String> =
        cited_in(include_str!("../../live/scenarios.toml")).into_iter().map(|citation| citation.id).collect();
    for rule in &catalogue {
        if rule.level != Level::Wire || !rule.keyword.is_binding() {
            continue;
        }
        if live.contains(&rule.id) {
            // What running programs show need not be shown by answers.
            continue;
        }
        let reason = exclusions.rules.get(&rule.id).filter(|excluded| excluded.without.contains(&Lack::Case));
        match (cited.get(&rule.id), reason) {
            (Some(_), None) | (None, Some(_)) => {}
            (None, None) => panic_with(&format!("no case cites {rule}")),
            (Some(count), Some(_)) => {
                panic_with(&format!("{} is listed as not shown, but {count} cases cite it", rule.id))
            }
        }
    }
}

#[test]
fn every_binding_rule_of_the_strict_profile_has_a_case_of_its_own() {
    let catalogue = Catalogue::load().unwrap();
    let decided: BTreeSet<String> = cases().iter().map(|case| rules(case, &catalogue)[0].id.clone()).collect();
    let strict = catalogue.iter().filter(|rule| rule.level == Level::Strict && rule.keyword.is_binding());
    for rule in strict {
        let by_another = rule.id == "NCP-STRICT-011"; // Decided by whichever rule rejects or drops.
        assert!(by_another || decided.contains(&rule.id), "no case is decided by {rule}");
    }
}

#[test]
fn every_advice_of_the_wire_has_a_case() {
    let catalogue = Catalogue::load().unwrap();
    let cases = cases();
    for rule in &catalogue {
        let is_advice = rule.level == Level::Wire && matches!(rule.keyword.as_str(), "SHOULD" | "SHOULD NOT");
        let is_cited = || cases.iter().any(|case| strings(&case["requirements"]).contains(&rule.id.as_str()));
        assert!(!is_advice || is_cited(), "no case cites {rule}");
    }
}

#[test]
fn every_role_is_asked_about_every_area() {
    let mut asked = BTreeSet::new();
    for case in cases() {
        let area = case["id"].as_str().unwrap().split('/').next().unwrap().to_owned();
        for role in strings(&case["roles"]) {
            asked.insert((area.clone(), role.to_owned()));
        }
    }
    for role in Role::ALL {
        for area in ["wire", "version", "keys", "hostile"] {
            assert!(asked.contains(&(area.to_owned(), role.as_str().to_owned())), "{area} {role}");
        }
    }
}
