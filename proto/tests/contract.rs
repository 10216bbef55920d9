//! The proto, its projection and the frozen baseline: they are what they claim to be, and fit each
//! other and the text.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that cannot go on has failed")]

mod common;

use std::collections::BTreeMap;

use ncp_proto::{
    BASELINE_IMAGE, BASELINE_PROJECTION, DESCRIPTOR_SET, PROJECTION_TEXT, PROTO_TEXT,
    contract::{Contract, FieldType},
    projection::JsonForm,
};
use serde_json::{Value, json};
use sha2::{Digest, Sha256};

#[test]
fn the_proto_has_the_contract_hash_of_the_text() {
    assert_eq!(ncp_spec::contract::hash_of(PROTO_TEXT), ncp_spec::CONTRACT_HASH);
}

#[test]
fn changing_a_number_a_name_or_a_type_changes_the_hash_and_changing_a_comment_does_not() {
    let changed = |from: &str, to: &str| {
        assert!(PROTO_TEXT.contains(from), "{from}");
        ncp_spec::contract::hash_of(&PROTO_TEXT.replacen(from, to, 1))
    };
    let hash = ncp_spec::CONTRACT_HASH;
    assert_ne!(changed("double ttl_ms = 7;", "double ttl_ms = 8;"), hash);
    assert_ne!(changed("double ttl_ms = 7;", "double ttl = 7;"), hash);
    assert_ne!(changed("double ttl_ms = 7;", "float ttl_ms = 7;"), hash);
    assert_eq!(changed("// The contract hash is taken over", "// Somebody once took it over"), hash);
}

#[test]
fn the_frozen_image_alone_has_the_contract_hash_of_its_projection() {
    let frozen = Contract::baseline().unwrap().projection;
    assert_eq!(ncp_spec::contract::hash_of(&common::frozen_proto()), frozen.contract_hash);
}

#[test]
fn the_projection_beside_the_proto_is_the_generated_one() {
    let is = include_str!("../projection.json");
    assert!(is == *PROJECTION_TEXT, "proto/projection.json is stale; if this is meant: cargo xtask generate");
}

#[test]
fn the_baseline_is_as_it_was_frozen() {
    let sums: BTreeMap<_, _> = include_str!("../baseline/SHA256SUMS")
        .lines()
        .map(|line| line.split_once("  ").unwrap())
        .map(|(sum, file)| (file, sum))
        .collect();
    let sum = |bytes: &[u8]| Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect::<String>();
    let wire = Contract::baseline().unwrap().projection.wire;
    assert_eq!(sums[&*format!("ncp-{wire}.binpb")], sum(BASELINE_IMAGE));
    assert_eq!(sums[&*format!("projection-{wire}.json")], sum(BASELINE_PROJECTION.as_bytes()));
    assert_eq!(sums.len(), 2);
}

#[test]
fn the_embedded_descriptor_is_of_the_embedded_text() {
    // By another path: the text compiled here, without its comments.
    let from_text = common::contract(&common::plain_proto(), &PROJECTION_TEXT);
    let embedded = Contract::new(DESCRIPTOR_SET, &PROJECTION_TEXT).unwrap();
    assert_eq!(format!("{:?}", undocumented(embedded)), format!("{:?}", undocumented(from_text)));
}

#[test]
fn the_projection_fits_the_proto() {
    assert_eq!(Contract::current().unwrap().disagreements(), []);
    assert_eq!(Contract::baseline().unwrap().disagreements(), []);
}

#[test]
fn every_declaration_is_commented() {
    let Contract { messages, enums, .. } = Contract::current().unwrap();
    let mut bare = Vec::new();
    for message in &messages {
        bare.extend(message.doc.is_empty().then(|| message.name.clone()));
        bare.extend(
            message
                .fields
                .iter()
                .filter(|field| field.doc.is_empty())
                .map(|field| format!("{}.{}", message.name, field.name)),
        );
    }
    for item in &enums {
        bare.extend(item.doc.is_empty().then(|| item.name.clone()));
        bare.extend(
            item.values
                .iter()
                .filter(|value| value.doc.is_empty())
                .map(|value| format!("{}.{}", item.name, value.name)),
        );
    }
    // It stands on one line, which has no room; its message says what it is.
    assert_eq!(bare, ["SetpointStep.channels"]);
}

#[test]
fn the_projection_satisfies_its_schema_and_a_broken_one_does_not() {
    let schema = serde_json::from_str(include_str!("../projection.schema.json")).unwrap();
    let validator = jsonschema::draft202012::new(&schema).unwrap();
    let good: Value = serde_json::from_str(&PROJECTION_TEXT).unwrap();
    assert!(
        validator.is_valid(&good),
        "{:?}",
        validator.iter_errors(&good).map(|error| error.to_string()).collect::<Vec<_>>()
    );
    for (pointer, value) in [
        ("/format", json!(2)),
        ("/contract_hash", json!("0123456789ABCDEF")),
        ("/limits/levels", json!(0)),
        ("/enums/Mode/unknown", json!("hold")),
        ("/enums/Mode/values/HOLD", json!(3)),
        ("/messages/CommandFrame/required", json!(["kind", "kind"])),
        ("/messages/CommandFrame/fields/seq/type", json!("int")),
        ("/messages/CommandFrame/fields/seq", json!({"type": "integer", "defualt": 0})),
        ("/error_frame/kind", json!(null)),
    ] {
        let mut broken = good.clone();
        *broken.pointer_mut(pointer).unwrap() = value;
        assert!(!validator.is_valid(&broken), "{pointer}");
    }
}

#[test]
fn a_projection_that_does_not_fit_the_proto_is_told_where() {
    let edits = [
        ("\"format\": 1", "\"format\": 2"),
        ("\"INIT\": \"init\"", "\"MODE_UNSPECIFIED\": \"unset\", \"INIT\": \"hold\""),
        ("\"read_as\": \"hold\"", "\"read_as\": \"stop\""),
        ("\"Role\": {", "\"Rank\": {"),
        ("\"SafetyLimits\": {", "\"Limits\": {"),
        ("\"kind\": \"link_status\",", "\"kind\": \"sensor_frame\","),
        ("\"required\": [\"kind\", \"controller_id\"]", "\"required\": [\"controller\"]"),
        (
            "\"last_seq\": {\"type\": \"integer\", \"default\": -1}",
            "\"last_seq\": {\"type\": \"integer\", \"segment\": true, \"default\": -1.0}",
        ),
        ("\"same_as_request\": [\"ncp_version\",", "\"same_as_request\": [\"version\","),
        ("{\"observation_frame\": 67108864}", "{\"observation\": 67108864}"),
        ("{\"meta\": {}, \"path\": \"\", \"role\": \"sensor\"}", "{\"meta\": {}, \"path\": \"\", \"role\": \"actor\"}"),
        ("\"transparent\": true", "\"transparent\": false"),
        ("\"controller_id\": {\"type\": \"string\",", "\"controller_id\": {\"type\": \"string\", \"default\": \"me\","),
    ];
    let told = edits.map(|(from, to)| {
        assert!(PROJECTION_TEXT.contains(from), "{from}");
        let contract = Contract::new(DESCRIPTOR_SET, &PROJECTION_TEXT.replacen(from, to, 1)).unwrap();
        let found: Vec<_> = contract.disagreements().iter().map(|found| format!("  {found}\n")).collect();
        format!("{from} → {to}\n{}", found.concat())
    });
    insta::assert_snapshot!(told.concat());
}

#[test]
fn declarations_within_others_are_named_from_the_outside_in() {
    let proto = r#"
        syntax = "proto3"; package ncp.v0;
        message Outer {
            message Inner { map<string, Outer.Inner> more = 1; }
            enum Choice { NONE = 0; }
            Inner inner = 1; repeated Inner many = 2; map<int64, Choice> choices = 3;
        }"#;
    let contract = common::contract(proto, &PROJECTION_TEXT);
    let types = |name: &str| {
        contract.message(name).unwrap().fields.iter().map(|field| field.ty.to_string()).collect::<Vec<_>>()
    };
    assert_eq!(
        contract.messages.iter().map(|message| message.name.as_str()).collect::<Vec<_>>(),
        ["Outer", "Outer.Inner"]
    );
    assert_eq!(types("Outer"), ["Outer.Inner", "repeated Outer.Inner", "map<int64, Outer.Choice>"]);
    assert_eq!(types("Outer.Inner"), ["map<string, Outer.Inner>"]);
    assert!(contract.enumeration("Outer.Choice").is_some());
}

fn undocumented(mut contract: Contract) -> Contract {
    for message in &mut contract.messages {
        message.doc.clear();
        message.fields.iter_mut().for_each(|field| field.doc.clear());
    }
    for item in &mut contract.enums {
        item.doc.clear();
        item.values.iter_mut().for_each(|value| value.doc.clear());
    }
    contract
}

#[test]
fn only_a_field_type_of_bytes_has_an_encoding_and_only_one_kind_has_an_optional_form() {
    let contract = Contract::current().unwrap();
    let encoded: Vec<_> = contract
        .messages
        .iter()
        .flat_map(|message| &message.fields)
        .filter(|field| field.ty.to_string() == "bytes")
        .map(|field| &field.name)
        .collect();
    assert_eq!(encoded, ["block"]);
    let optional: Vec<_> = contract
        .kinds()
        .filter(|(_, _, projected)| projected.json_form == JsonForm::Optional)
        .map(|(kind, ..)| kind)
        .collect();
    assert_eq!(optional, ["bulk_observation"]);
    assert_eq!(contract.kinds().count(), 14);
    let maps = contract
        .messages
        .iter()
        .flat_map(|message| &message.fields)
        .filter(|field| matches!(field.ty, FieldType::Map(..)))
        .count();
    let in_text = ncp_text::tables().all_messages().flat_map(|message| &message.fields);
    let in_text = in_text.filter(|field| matches!(field.shape, ncp_text::tables::Shape::Map(_))).count();
    assert_eq!(maps, in_text + 1, "the step of a horizon has one too");
}
