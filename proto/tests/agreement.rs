//! Three sources, made apart, that must agree: the projection (and the schemas made from it), the
//! tables of the specification, and its decoder.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that cannot go on has failed")]

mod common;

use std::{collections::BTreeMap, sync::LazyLock};

use common::frames::frame;
use jsonschema::Validator;
use ncp_proto::{contract::Contract, schema::generate};
use ncp_spec::{
    keys,
    wire::{self, DecodeProblem, Kind, NESTED, Rule, Table, decode},
};
use proptest::{prelude::*, sample::select};
use serde_json::{Value, json};

#[test]
fn the_tables_of_the_specification_are_those_of_the_projection() {
    let contract = Contract::current().unwrap();
    let tables: Vec<Table> = Kind::ALL.iter().map(|kind| kind.table()).chain(NESTED).collect();
    for table in &tables {
        let (fields, projected) = match contract.message(table.message) {
            Some(message) => {
                let names = message.fields.iter().map(|field| field.name.as_str()).collect();
                (names, &contract.projection.messages[table.message])
            }
            None => {
                assert_eq!(table.message, "ErrorFrame");
                (vec!["kind", "error", "session_id"], &contract.projection.error_frame)
            }
        };
        assert_eq!(projected.kind.as_deref(), table.kind.map(Kind::as_str), "{}", table.message);
        assert_eq!(table.fields.iter().map(|field| field.name).collect::<Vec<_>>(), fields, "{}", table.message);
        for field in table.fields {
            let place = format!("{}.{}", table.message, field.name);
            assert_eq!(projected.fields[field.name].ty.to_string(), field.json.to_string(), "{place}");
            assert_eq!(projected.required.iter().any(|name| name == field.name), field.required, "{place}");
        }
    }
    // All but the step of a horizon, which has no form of its own, and with the error frame.
    assert_eq!(tables.len(), contract.messages.len() - 1 + 1);
}

#[test]
fn the_limits_of_the_specification_are_those_of_the_projection() {
    let limits = Contract::current().unwrap().projection.limits;
    let bytes = |value: usize| u64::try_from(value).unwrap();
    assert_eq!(limits.integer, u64::try_from(wire::MAX_INTEGER).unwrap());
    assert_eq!(limits.entries, bytes(wire::MAX_ENTRIES));
    assert_eq!(limits.items, bytes(wire::MAX_ITEMS));
    assert_eq!(limits.levels, bytes(wire::MAX_LEVELS));
    for kind in Kind::ALL {
        let limit = limits.frame_bytes_of.get(kind.as_str()).unwrap_or(&limits.frame_bytes);
        assert_eq!(*limit, bytes(kind.max_bytes()), "{kind}");
    }
    let longest = "x".repeat(usize::try_from(limits.segment_bytes).unwrap());
    assert!(keys::validate_segment(&longest).is_ok());
    assert!(keys::validate_segment(&format!("{longest}x")).is_err());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2048))]

    /// [NCP-WIRE-020] [NCP-WIRE-021] [NCP-WIRE-027] [NCP-WIRE-050]
    #[test]
    fn schema_and_decoder_accept_the_same_frames((kind, text) in frame(true), place in any::<u64>(),
        value in odd_value(), change: bool) {
        let mut frame: Value = serde_json::from_str(&text).unwrap();
        if change {
            let places = count(&frame);
            plant(&mut frame, place % places, &value);
        }
        let decoded = decode(kind, frame.to_string().as_bytes());
        // The one thing that these frames can have wrong and no schema can say.
        let beyond = matches!(
            decoded.as_ref().map_err(|error| error.problem()),
            Err(DecodeProblem::Rule(Rule::StimulusSession | Rule::StimulusVersion))
        );
        prop_assume!(!beyond);
        prop_assert_eq!(SCHEMAS[kind.as_str()].is_valid(&frame), decoded.is_ok(), "{:?}\n{}", decoded, frame);
    }
}

static SCHEMAS: LazyLock<BTreeMap<String, Validator>> = LazyLock::new(|| {
    let validator = |text: &str| jsonschema::draft202012::new(&serde_json::from_str(text).unwrap()).unwrap();
    generate().into_iter().map(|(name, text)| (name.replace(".schema.json", ""), validator(&text))).collect()
});

/// A value to plant somewhere, or none: then what stands there is taken away. No double without a
/// fraction is among them, since a schema cannot tell it from an integer.
fn odd_value() -> impl Strategy<Value = Option<Value>> {
    let values = [
        json!(null),
        json!(true),
        json!(false),
        json!(0),
        json!(-3),
        json!(1.5),
        json!(9_007_199_254_740_991_i64),
        json!(9_007_199_254_740_992_i64),
        json!(u64::MAX),
        json!(1e300),
        json!(""),
        json!("s"),
        json!("hold"),
        json!("batch"),
        json!("a/b"),
        json!("@a"),
        json!("AAAA"),
        json!("stimulus_frame"),
        json!([]),
        json!([1]),
        json!([1.5]),
        json!(["a"]),
        json!([{}]),
        json!([null]),
        json!({}),
        json!({"data": []}),
        json!({"a": 1}),
        json!({"a": {}}),
        json!({"kind": "stimulus_frame"}),
        json!({"a": null}),
    ];
    prop_oneof![1 => Just(None), 9 => select(values.to_vec()).prop_map(Some)]
}

/// The number of places in a value: itself, and all within.
fn count(value: &Value) -> u64 {
    1 + match value {
        Value::Array(items) => items.iter().map(count).sum(),
        Value::Object(members) => members.values().map(count).sum::<u64>(),
        _ => 0,
    }
}

/// Puts the new value at the nth place, or takes away what stands there. The frame itself stays.
fn plant(value: &mut Value, nth: u64, new: &Option<Value>) {
    let mut left = nth;
    let children: Vec<(String, &mut Value)> = match value {
        Value::Array(items) => items.iter_mut().enumerate().map(|(nth, item)| (nth.to_string(), item)).collect(),
        Value::Object(members) => members.iter_mut().map(|(name, member)| (name.clone(), member)).collect(),
        _ => return,
    };
    let mut take_away = None;
    for (name, child) in children {
        let places = count(child);
        match (left, new) {
            (0, _) => return,
            (1, Some(new)) => return new.clone_into(child),
            (1, None) => {
                take_away = Some(name);
                break;
            }
            (left, _) if left <= places => return plant(child, left - 1, new),
            _ => left -= places,
        }
    }
    match (value, take_away) {
        (Value::Object(members), Some(name)) => _ = members.remove(&name),
        (Value::Array(items), Some(nth)) => _ = items.remove(nth.parse().unwrap()),
        _ => {}
    }
}
