//! The messages are those of the text's tables and of the contract's projection.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests may panic as tests may")]

use ncp_spec::wire::{self, Kind, NESTED, Table, build, decode_any};
use ncp_spec::{CONTRACT_HASH, bulk, keys};
use ncp_text::limits;
use ncp_text::tables::{Default, Message, Shape, Tables};
use serde_json::{Value, json};

/// The tables of the text.
fn text() -> &'static Tables {
    ncp_text::tables()
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
    for table in tables() {
        let message = text().message(table.message).unwrap_or_else(|| panic!("no table of {}", table.message));
        assert_eq!(message.kind.as_deref(), table.kind.map(Kind::as_str), "{}", table.message);
        let rows = message.fields.iter();
        let of_text: Vec<_> = rows.map(|row| (&*row.name, row.json_type(), row.is_required())).collect();
        let fields = table.fields.iter();
        let here: Vec<_> = fields.map(|field| (field.name, field.json.to_string(), field.required)).collect();
        assert_eq!(here, of_text, "{}", table.message);
    }
    assert_eq!(tables().count(), text().all_messages().count());
}

#[test]
fn an_absent_field_is_read_as_the_text_says() {
    for table in tables() {
        let read = read_defaults(table);
        for row in &text().message(table.message).unwrap().fields {
            let value = read.get(&row.name).cloned().unwrap_or_default();
            let expected = match &row.default {
                Default::Required => continue,
                Default::Absent => Value::Null,
                Default::Kind => json!(table.kind.unwrap().as_str()),
                Default::Message => {
                    let nested = NESTED.into_iter().find(|t| t.message == row.shape.to_string()).unwrap();
                    read_defaults(nested)
                }
                Default::Value(value) => serde_json::from_str(&value.to_string()).unwrap(),
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
            assert_eq!(built["contract_hash"].take(), json!(CONTRACT_HASH));
            assert_eq!(read["contract_hash"], Value::Null);
        }
        if kind == Kind::CommandFrame {
            assert_eq!(built["mode"].take(), json!("active"));
            assert_eq!(read["mode"].take(), json!("hold"));
        }
        assert_eq!(built, read, "{kind}");
    }
}

/// `[NCP-WIRE-080] [NCP-WIRE-081] [NCP-WIRE-082]`
#[test]
fn every_field_is_written_in_order_with_null_for_what_is_unset() {
    for kind in Kind::ALL.into_iter().filter(|kind| *kind != Kind::Error) {
        let fields = if kind.table().fields.iter().any(|field| field.name == "session_id" && field.required) {
            r#"{"session_id":"s"}"#
        } else {
            "{}"
        };
        let built = build(kind, fields.as_bytes()).unwrap().encode().unwrap();
        assert_eq!(built, spelled_out(text().kind(kind.as_str()).unwrap()));
    }
}

/// What a program's message looks like that names nothing but a session.
fn spelled_out(message: &Message) -> String {
    let members = message.fields.iter().map(|field| {
        let value = match (&field.default, &*field.name) {
            (Default::Value(_), "mode") if message.name == "CommandFrame" => json!("active").to_string(),
            (Default::Absent, "contract_hash") => json!(CONTRACT_HASH).to_string(),
            (Default::Value(value), _) => value.to_string(),
            (Default::Absent, _) => "null".to_owned(),
            (Default::Kind, _) => json!(message.kind).to_string(),
            (Default::Required, "session_id") => json!("s").to_string(),
            (Default::Required | Default::Message, _) => match &field.shape {
                Shape::String => json!("").to_string(),
                Shape::Number => json!(0.0).to_string(),
                nested => spelled_out(text().message(&nested.to_string()).unwrap()),
            },
        };
        format!("\"{}\":{value}", field.name)
    });
    format!("{{{}}}", members.collect::<Vec<_>>().join(","))
}

#[test]
fn the_limits_are_those_of_the_text() {
    assert_eq!(wire::MAX_FRAME_BYTES, limits::FRAME_BYTES);
    assert_eq!(keys::MAX_SEGMENT_BYTES, limits::SEGMENT_BYTES);
    assert_eq!(bulk::MAX_BLOCK_LEN, limits::BLOCK_BYTES);
    assert_eq!(bulk::MAX_COLUMNS, limits::BLOCK_COLUMNS);
    for kind in Kind::ALL {
        let is_large = kind == Kind::ObservationFrame;
        let expected = if is_large { limits::OBSERVATION_FRAME_BYTES } else { limits::FRAME_BYTES };
        assert_eq!(kind.max_bytes(), expected, "{kind}");
    }
}
