//! The messages are those of the text's tables and of the contract's projection.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests may panic as tests may")]

use std::collections::BTreeMap;

use ncp_spec::WIRE_VERSION;
use ncp_spec::wire::{self, Kind, NESTED, Table, build, decode_any};
use serde_json::{Value, json};

/// A row of a table in the text.
#[derive(Debug, PartialEq)]
struct Row {
    name: String,
    json: String,
    default: String,
}

/// The tables of sections 1.8 and 5.3, by the message's name.
fn tables_of_the_text() -> BTreeMap<String, Vec<Row>> {
    let mut tables = BTreeMap::new();
    let mut message = String::new();
    for line in include_str!("../text/01-wire.md").lines() {
        if let Some(heading) = line.strip_prefix("### ") {
            message = match heading.split(' ').next() {
                Some("The") => "ErrorFrame".to_owned(),
                name => name.unwrap_or_default().to_owned(),
            };
        } else if let Some(row) = row(line).filter(|_| !message.is_empty()) {
            tables.entry(message.clone()).or_insert_with(Vec::new).push(row);
        }
    }
    let bulk = include_str!("../text/05-observations-and-bulk.md");
    let (_, bulk) = bulk.split_once("`bulk_observation`").expect("section 5.3");
    tables.insert("BulkObservation".to_owned(), bulk.lines().filter_map(row).collect());
    tables
}

fn row(line: &str) -> Option<Row> {
    let line = line.strip_prefix("| `")?.replace("\\|", "\u{1}");
    let cells: Vec<_> = line.split('|').map(|cell| cell.trim().replace('\u{1}', "|")).collect();
    let [name, json, default, ..] = &cells[..] else {
        return None;
    };
    Some(Row {
        name: name.trim_end_matches('`').to_owned(),
        json: json.clone(),
        default: default.trim_matches('`').to_owned(),
    })
}

fn tables() -> impl Iterator<Item = Table> {
    Kind::ALL.into_iter().map(Kind::table).chain(NESTED)
}

/// What a receiver reads when all but the required fields are absent.
fn read_defaults(table: Table) -> Value {
    let in_open = |members: &str| {
        let frame = format!(r#"{{"kind":"open_session","session_id":"s","network":{{}},{members}}}"#);
        written(&decode_any(frame.as_bytes()).unwrap())
    };
    match (table.kind, table.message) {
        (Some(kind), _) => {
            let members = match kind {
                Kind::Error => r#""error":"""#,
                Kind::LinkStatus => r#""x":0"#,
                _ => r#""session_id":"s","network":{},"duration_ms":0,"controller_id":"""#,
            };
            let frame = format!(r#"{{"kind":"{kind}",{members}}}"#);
            written(&decode_any(frame.as_bytes()).unwrap())
        }
        (None, "NetworkRef") => in_open(r#""x":0"#)["network"].clone(),
        (None, "RecordSpec") => in_open(r#""record":{}"#)["record"].clone(),
        (None, "RecordTarget") => in_open(r#""record":{"targets":[{}]}"#)["record"]["targets"][0].clone(),
        (None, "StimulusSpec") => in_open(r#""stimulus":{}"#)["stimulus"].clone(),
        (None, "StimulusTarget") => in_open(r#""stimulus":{"targets":[{}]}"#)["stimulus"]["targets"][0].clone(),
        (None, "SimConfig") => in_open(r#""sim":{}"#)["sim"].clone(),
        (None, "EntityBinding") => in_open(r#""bindings":[{}]"#)["bindings"][0].clone(),
        (None, "EntityRef") => in_open(r#""bindings":[{"entity":{}}]"#)["bindings"][0]["entity"].clone(),
        (None, message) => {
            let frame = match message {
                "ChannelValue" => r#"{"kind":"sensor_frame","channels":{"x":{}}}"#,
                "SimProvenance" => r#"{"kind":"session_opened","session_id":"s","provenance":{}}"#,
                "Observation" => r#"{"kind":"observation_frame","session_id":"s","records":{"x":{}}}"#,
                "ChannelSpec" => r#"{"kind":"capabilities","controller_id":"","sensor_channels":[{}]}"#,
                "SafetyLimits" => r#"{"kind":"capabilities","controller_id":"","safety":{}}"#,
                other => panic!("where does {other} stand?"),
            };
            let frame = written(&decode_any(frame.as_bytes()).unwrap());
            let places = ["/channels/x", "/provenance", "/records/x", "/sensor_channels/0", "/safety"];
            let has_fields = |value: &&Value| value.get(table.fields[0].name).is_some();
            places.into_iter().find_map(|p| frame.pointer(p).filter(has_fields)).unwrap().clone()
        }
    }
}

fn written(message: &wire::Message) -> Value {
    serde_json::from_str(&message.encode().unwrap()).unwrap()
}

#[test]
fn every_message_has_the_fields_of_the_text_in_their_order() {
    let mut text = tables_of_the_text();
    for table in tables() {
        let rows = text.remove(table.message).unwrap_or_else(|| panic!("no table of {}", table.message));
        let of_text: Vec<_> = rows
            .iter()
            .map(|row| {
                let required = row.default == "required" || row.default.starts_with("none");
                (row.name.clone(), row.json.clone(), required)
            })
            .collect();
        let here: Vec<_> =
            table.fields.iter().map(|field| (field.name.to_owned(), field.json.to_string(), field.required)).collect();
        assert_eq!(here, of_text, "{}", table.message);
    }
    assert!(text.is_empty(), "not here: {:?}", text.keys());
}

#[test]
fn an_absent_field_is_read_as_the_text_says() {
    let text = tables_of_the_text();
    for table in tables() {
        let read = read_defaults(table);
        for row in &text[table.message] {
            let value = read.get(&row.name).cloned().unwrap_or_default();
            let expected = match row.default.as_str() {
                "required" => continue,
                "absent" | "optional" => Value::Null,
                "none: it must be there" => json!(table.kind.unwrap().as_str()),
                "all defaults" => {
                    let nested = NESTED.into_iter().find(|t| t.message == row.json).unwrap();
                    read_defaults(nested)
                }
                literal => serde_json::from_str(literal).unwrap(),
            };
            assert_eq!(value.to_string(), expected.to_string(), "{}.{}", table.message, row.name);
        }
    }
}

/// What a program gets that names no field, or at most a session or what went wrong.
fn built_defaults(kind: Kind) -> Value {
    let has_session = kind != Kind::Error && kind != Kind::LinkStatus && {
        let fields = kind.table().fields;
        fields.iter().any(|field| field.name == "session_id")
    };
    let fields = if has_session {
        r#"{"session_id":"s"}"#
    } else if kind == Kind::Error {
        r#"{"error":""}"#
    } else {
        "{}"
    };
    written(&build(kind, fields.as_bytes()).unwrap())
}

#[test]
fn a_program_gets_what_a_receiver_reads_but_for_mode_and_contract_hash() {
    for kind in Kind::ALL {
        let (mut built, mut read) = (built_defaults(kind), read_defaults(kind.table()));
        if matches!(kind, Kind::OpenSession | Kind::SessionOpened) {
            assert_eq!(built["contract_hash"].take(), json!("24e8e6e31e1dec8a"));
            assert_eq!(read["contract_hash"], Value::Null);
        }
        if kind == Kind::CommandFrame {
            assert_eq!(built["mode"].take(), json!("active"));
            assert_eq!(read["mode"].take(), json!("hold"));
        }
        assert_eq!(built, read, "{kind}");
    }
}

#[test]
fn tables_and_limits_are_those_of_the_contracts_projection() {
    let projection: Value = serde_json::from_str(include_str!("../../proto/projection.json")).unwrap();
    assert_eq!(projection["wire"], WIRE_VERSION);
    let limits = &projection["limits"];
    assert_eq!(limits["integer"], wire::MAX_INTEGER);
    assert_eq!(limits["entries"], wire::MAX_ENTRIES);
    assert_eq!(limits["items"], wire::MAX_ITEMS);
    assert_eq!(limits["levels"], wire::MAX_LEVELS);
    assert_eq!(limits["segment_bytes"], ncp_spec::keys::MAX_SEGMENT_BYTES);
    for kind in Kind::ALL {
        let special = &limits["frame_bytes_of"][kind.as_str()];
        let expected = if special.is_null() { &limits["frame_bytes"] } else { special };
        assert_eq!(expected, kind.max_bytes(), "{kind}");
    }
    for table in tables().filter(|table| table.kind != Some(Kind::Error)) {
        let message = &projection["messages"][table.message];
        let fields = message["fields"].as_object().unwrap();
        let names: Vec<_> = table.fields.iter().map(|field| field.name).collect();
        assert_eq!(names, fields.keys().collect::<Vec<_>>(), "{}", table.message);
        if let Some(kind) = table.kind {
            assert_eq!(message["kind"], kind.as_str());
        }
        let read = read_defaults(table);
        for field in table.fields {
            let (name, projected) = (field.name, &fields[field.name]);
            assert_eq!(projected["type"], field.json.to_string(), "{}.{name}", table.message);
            let listed = message["required"].as_array().is_some_and(|l| l.contains(&json!(name)));
            assert_eq!(listed, field.required, "{}.{name}", table.message);
            if let Some(default) = projected.get("default") {
                assert_eq!(default, &read[name], "{}.{name}", table.message);
            }
            if let Some(built) = projected.get("built") {
                let kind = table.kind.unwrap_or_else(|| panic!("{} is no frame", table.message));
                if name != "session_id" {
                    assert_eq!(built, &built_defaults(kind)[name], "{}.{name}", table.message);
                }
            }
        }
    }
    let enums = projection["enums"].as_object().unwrap();
    assert_eq!(enums.len(), 8);
    for (name, projected) in enums {
        let strings: Vec<_> = projected["values"].as_object().unwrap().values().collect();
        assert_eq!(strings, known(name), "{name}");
    }
}

/// The wire strings of an enum.
fn known(name: &str) -> Vec<&'static str> {
    macro_rules! known {
        ($($name:ident)*) => {
            match name {
                $(stringify!($name) => wire::$name::KNOWN.iter().map(|value| value.as_str()).collect(),)*
                other => panic!("no enum {other}"),
            }
        };
    }
    known!(Observable StimulusKind NetworkRefKind EntityRole ChannelKind Role Mode SimMode)
}
