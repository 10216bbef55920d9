//! The breaking check, on planted changes.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that cannot go on has failed")]

mod common;

use std::collections::BTreeSet;

use common::{changes, contract, frozen_proto};
use ncp_proto::{
    BASELINE_PROJECTION, PROJECTION_TEXT,
    compat::{Rule, check, check_current},
    contract::Contract,
};

#[test]
fn the_contract_of_this_build_breaks_nothing_of_the_frozen_one() {
    assert_eq!(check_current(), []);
}

#[test]
fn every_planted_change_is_reported_with_its_rule_and_place_and_nothing_else_is() {
    let mut wrong = String::new();
    for change in changes() {
        let frozen = contract(&change.frozen_proto(), BASELINE_PROJECTION);
        let changed = contract(&change.changed_proto(), &change.changed_projection());
        let violations = check(&frozen, &changed);
        let reports: Vec<_> =
            violations.iter().map(|found| format!("{} in {}", found.rule.code(), found.place)).collect();
        if reports != change.reports {
            wrong += &format!("{}\n  expected {:#?}\n  found {reports:#?}\n", change.name, change.reports);
        }
        assert!(violations.iter().all(|found| found.was != found.is), "{}", change.name);
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn every_change_of_a_declaration_changes_the_contract_hash() {
    let hash = ncp_spec::contract::hash_of(&frozen_proto());
    for change in changes() {
        let only_layout = change.name == "comments and indentation change";
        let untouched = change.changed_proto() == frozen_proto();
        // The canonical text leaves the package out: the check, not the hash, guards its name.
        let package = change.name == "the package gets another name";
        let same = ncp_spec::contract::hash_of(&change.changed_proto()) == hash;
        assert_eq!(same, only_layout || untouched || package, "{}", change.name);
    }
}

#[test]
fn a_wire_of_another_version_and_hash_may_add_and_may_take_nothing_away() {
    let frozen = Contract::baseline().unwrap();
    let next = |projection: &str| {
        let own = projection.replace(&format!("\"{}\"", frozen.projection.wire), "\"0.999\"");
        contract(&frozen_proto(), &own.replace(&frozen.projection.contract_hash, "0123456789abcdef"))
    };
    assert_eq!(check(&frozen, &next(BASELINE_PROJECTION)), []);
    let narrower = BASELINE_PROJECTION.replacen("\"default\": 200.0", "\"default\": 100.0", 1);
    let found: Vec<_> = check(&frozen, &next(&narrower)).iter().map(|found| found.rule).collect();
    assert_eq!(found, [Rule::DefaultChanged]);
}

#[test]
fn each_rule_has_a_planted_change_or_a_test_below() {
    let planted: BTreeSet<_> = changes()
        .iter()
        .flat_map(|change| change.reports.clone())
        .map(|report| report.split(' ').next().unwrap().to_owned())
        .collect();
    let unplanted: Vec<_> = Rule::ALL.iter().map(|rule| rule.code()).filter(|code| !planted.contains(*code)).collect();
    assert_eq!(unplanted, ["unreadable", "syntax-changed"]);
}

#[test]
fn another_syntax_is_reported() {
    let frozen = Contract::baseline().unwrap();
    let mut changed = frozen.clone();
    changed.syntax = "proto2".to_owned();
    let violations = check(&frozen, &changed);
    assert_eq!(violations.iter().map(|found| found.rule).collect::<Vec<_>>(), [Rule::SyntaxChanged]);
}

#[test]
fn a_contract_that_cannot_be_read_is_an_error() {
    let descriptor = ncp_proto::DESCRIPTOR_SET;
    assert!(Contract::new(&descriptor[..descriptor.len() - 1], &PROJECTION_TEXT).is_err());
    assert!(Contract::new(&[], &PROJECTION_TEXT).is_err(), "no file");
    assert!(Contract::new(&[descriptor, descriptor].concat(), &PROJECTION_TEXT).is_err(), "two files");
    assert!(Contract::new(descriptor, "{}").is_err());
    let misspelt = PROJECTION_TEXT.replacen("\"pinned\"", "\"pined\"", 1);
    assert!(Contract::new(descriptor, &misspelt).is_err());
}

#[test]
fn a_violation_says_what_where_what_was_what_is_and_why() {
    let chosen = [
        "an int64 becomes an int32",
        "a wire string changes one letter",
        "an RPC's answer becomes a stream",
        "an absent mode is read as active",
    ];
    let shown: Vec<_> = changes()
        .into_iter()
        .filter(|change| chosen.contains(&change.name.as_str()))
        .flat_map(|change| {
            check(
                &contract(&change.frozen_proto(), BASELINE_PROJECTION),
                &contract(&change.changed_proto(), &change.changed_projection()),
            )
        })
        .map(|found| found.to_string())
        .collect();
    insta::assert_snapshot!(shown.join("\n\n"));
}
