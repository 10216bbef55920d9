//! The proto, its projection and the frozen baseline: they are what they claim to be, and fit each
//! other and the text.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that cannot go on has failed")]

mod common;

use std::collections::BTreeMap;

use ncp_proto::{
    BASELINE_IMAGE, BASELINE_PROJECTION, DESCRIPTOR_SET, PROJECTION_TEXT, PROTO_TEXT,
    contract::{Contract, FieldType},
    projection::{JsonForm, MessageProjection, Unknown},
};
use prost::Message;
use prost_types::{FileDescriptorProto, FileDescriptorSet};
use serde_json::{Value, json};
use sha2::{Digest, Sha256};

#[test]
fn the_proto_has_the_contract_hash_of_wire_0_5() {
    assert_eq!(ncp_spec::contract::hash_of(PROTO_TEXT), "24e8e6e31e1dec8a");
    assert_eq!(ncp_spec::CONTRACT_HASH, "24e8e6e31e1dec8a");
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
fn the_frozen_image_alone_has_the_contract_hash_of_wire_0_5() {
    let set = FileDescriptorSet::decode(BASELINE_IMAGE).unwrap();
    assert_eq!(ncp_spec::contract::hash_of(&written_out(&set.file[0])), "24e8e6e31e1dec8a");
}

#[test]
fn the_baseline_is_as_it_was_frozen() {
    let sums: BTreeMap<_, _> = include_str!("../baseline/SHA256SUMS")
        .lines()
        .map(|line| line.split_once("  ").unwrap())
        .map(|(sum, file)| (file, sum))
        .collect();
    let sum = |bytes: &[u8]| Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect::<String>();
    assert_eq!(sums["ncp-0.5.binpb"], sum(BASELINE_IMAGE));
    assert_eq!(sums["projection-0.5.json"], sum(BASELINE_PROJECTION.as_bytes()));
    assert_eq!(sums.len(), 2);
}

#[test]
fn the_embedded_descriptor_is_of_the_embedded_text() {
    // By another path: the text compiled here, without its comments.
    let from_text = common::contract(&common::plain_proto(), PROJECTION_TEXT);
    let embedded = Contract::new(DESCRIPTOR_SET, PROJECTION_TEXT).unwrap();
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
    let good: Value = serde_json::from_str(PROJECTION_TEXT).unwrap();
    assert!(
        validator.is_valid(&good),
        "{:?}",
        validator.iter_errors(&good).map(|error| error.to_string()).collect::<Vec<_>>()
    );
    for (pointer, value) in [
        ("/format", json!(2)),
        ("/contract_hash", json!("24E8E6E31E1DEC8A")),
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
    let contract = common::contract(proto, PROJECTION_TEXT);
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

#[test]
fn the_projection_says_what_the_tables_of_the_text_say() {
    let projection = Contract::current().unwrap().projection;
    let tables = tables(concat!(
        include_str!("../../spec/text/01-wire.md"),
        include_str!("../../spec/text/05-observations-and-bulk.md")
    ));

    let mut compared = 0;
    for (name, message) in projection.messages.iter().filter(|(_, message)| !message.transparent) {
        let (kind, rows) = &tables[name.as_str()];
        assert_eq!(message.kind, *kind, "{name}");
        assert_eq!(rows.len(), message.fields.len(), "{name}");
        for (field, [ty, default]) in rows {
            assert_eq!(message.fields[field].ty.to_string(), *ty, "{name}.{field}");
            assert_eq!(default_in_words(message, field), *default, "{name}.{field}");
            compared += 1;
        }
    }
    assert_eq!(compared, 156);
    let (_, rows) = &tables["The RPC error frame"];
    for (field, [ty, needed]) in rows {
        assert_eq!(projection.error_frame.fields[field].ty.to_string(), *ty, "{field}");
        assert_eq!(projection.error_frame.required.contains(field), needed == "required", "{field}");
    }
    assert_eq!(rows.len(), projection.error_frame.fields.len());
}

#[test]
fn the_projection_says_what_the_enum_table_of_the_text_says() {
    let Contract { enums, projection, .. } = Contract::current().unwrap();
    let rows: BTreeMap<_, _> = include_str!("../../spec/text/01-wire.md")
        .lines()
        .skip_while(|line| !line.starts_with("| enum |"))
        .skip(2)
        .map_while(cells)
        .map(|row| (row[0].clone(), (row[1].clone(), row[2].clone())))
        .collect();
    assert_eq!(rows.len(), enums.len());
    for item in &enums {
        let projected = &projection.enums[&item.name];
        let strings: Vec<_> = item
            .values
            .iter()
            .filter_map(|value| projected.values.get(&value.name))
            .map(|string| format!("`{string}`"))
            .collect();
        let unknown = match &projected.unknown {
            Unknown::Keep => "descriptive: kept as it is".to_owned(),
            Unknown::ReadAs(string) => format!("reads as `{string}`"),
            Unknown::Reject => "the frame is rejected".to_owned(),
        };
        assert_eq!(rows[&format!("`{}`", item.name)], (strings.join(", "), unknown), "{}", item.name);
    }
}

/// A proto's declarations from its descriptor, laid out as the canonical text is: in the order, and
/// on the lines, that the source had.
fn written_out(file: &FileDescriptorProto) -> String {
    let contract =
        Contract::new(&FileDescriptorSet { file: vec![file.clone()] }.encode_to_vec(), PROJECTION_TEXT).unwrap();
    let mut blocks = Vec::new();
    // Where a declaration stands: its line, and whether it ends on it (a span of three numbers).
    let span = |path: [i32; 2]| {
        let span = &file
            .source_code_info
            .as_ref()
            .unwrap()
            .location
            .iter()
            .find(|location| location.path == path)
            .unwrap()
            .span;
        (span[0], span.len() == 3)
    };
    for (index, message) in (0..).zip(&contract.messages) {
        let (line, one_line) = span([4, index]);
        let fields: Vec<_> =
            message.fields.iter().map(|field| format!("{} {} = {};", field.ty, field.name, field.number)).collect();
        let separator = if one_line { " " } else { "\n" };
        blocks.push((
            line,
            [&[format!("message {} {{", message.name)], &fields[..], &["}".to_owned()]].concat().join(separator),
        ));
    }
    for (index, item) in (0..).zip(&contract.enums) {
        let values: Vec<_> = item.values.iter().map(|value| format!("{} = {};", value.name, value.number)).collect();
        blocks.push((span([5, index]).0, format!("enum {} {{\n{}\n}}", item.name, values.join("\n"))));
    }
    for (index, service) in (0..).zip(&contract.services) {
        let rpcs: Vec<_> = service.rpcs.iter().map(|rpc| format!("rpc {}{};", rpc.name, rpc.signature())).collect();
        blocks.push((span([6, index]).0, format!("service {} {{\n{}\n}}", service.name, rpcs.join("\n"))));
    }
    blocks.sort();
    blocks.into_iter().map(|(_, block)| block).collect::<Vec<_>>().join("\n")
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

/// The default of a field in the words of the tables.
fn default_in_words(message: &MessageProjection, name: &str) -> String {
    let field = &message.fields[name];
    match &field.default {
        None if name == "kind" && field.pinned.is_some() => "none: it must be there".to_owned(),
        None => "required".to_owned(),
        Some(Value::Null) => "absent".to_owned(),
        Some(Value::Object(members)) if !members.is_empty() => "all defaults".to_owned(),
        Some(value) => format!("`{value}`"),
    }
}

type Table = (Option<String>, Vec<(String, [String; 2])>);

/// The field tables of the text by message: the kind, and a row a field with its type and default.
fn tables(text: &str) -> BTreeMap<String, Table> {
    let mut tables: BTreeMap<String, Table> = BTreeMap::new();
    let mut name = String::new();
    let mut in_table = false;
    for line in text.lines() {
        if let Some(heading) = line.strip_prefix("### ") {
            let (message, kind) = heading
                .split_once(" · ")
                .map_or((heading, None), |(message, kind)| (message, Some(kind.trim_matches('`').to_owned())));
            name = message.to_owned();
            tables.insert(name.clone(), (kind, Vec::new()));
        } else if line.starts_with("## ") {
            // Of the later sections only chapter 5's last has such a table, for a message without a
            // heading.
            name = "BulkObservation".to_owned();
            tables.insert(name.clone(), (Some("bulk_observation".to_owned()), Vec::new()));
        } else if line.starts_with("| field | type |") {
            in_table = true;
        } else if in_table && let Some(row) = cells(line) {
            if !row[0].starts_with("---") {
                tables
                    .get_mut(&name)
                    .unwrap()
                    .1
                    .push((row[0].trim_matches('`').to_owned(), [row[1].clone(), row[2].clone()]));
            }
        } else {
            in_table = false;
        }
    }
    tables
}

fn cells(row: &str) -> Option<Vec<String>> {
    let row = row.strip_prefix("| ").or_else(|| row.strip_prefix('|'))?.replace("\\|", "\u{0}");
    Some(row.split('|').map(|cell| cell.trim().replace('\u{0}', "|")).collect())
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
    assert_eq!(maps, 10);
}
