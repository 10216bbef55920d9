//! Frames of all kinds: the first byte chooses the kind, the rest is the frame.

use ncp_spec::ErrorCode;
use ncp_spec::version::check_version;
use ncp_spec::wire::{
    DecodeError, DecodeProblem, JsonType, Kind, Message, NESTED, build, decode, decode_any, decode_any_strict,
    decode_strict,
};
use serde_json::Value;

use crate::message;

/// The kind and the frame of an input.
#[must_use]
pub fn split(input: &[u8]) -> (Kind, &[u8]) {
    let (first, frame) = input.split_first().unwrap_or((&0, &[]));
    (Kind::ALL[usize::from(*first) % Kind::ALL.len()], frame)
}

/// The input of a kind and a frame.
#[must_use]
pub fn join(kind: Kind, frame: &[u8]) -> Vec<u8> {
    let at = Kind::ALL.iter().position(|other| *other == kind);
    let mut input = vec![u8::try_from(at.unwrap_or_default()).unwrap_or_default()];
    input.extend(frame);
    input
}

/// The input as a person reads it.
#[must_use]
pub fn show(input: &[u8]) -> String {
    let (kind, frame) = split(input);
    format!("{kind}: {}", String::from_utf8_lossy(frame))
}

/// Decoding ends with a message or an error, whatever the bytes, and a frame that is read is what
/// another JSON reader takes for an object of that kind, with its pins in place. An error says what
/// stands at its place. The strict profile refuses what it has to, and nothing else.
///
/// It would find a panic, an endless loop, a lax grammar, a kind that is not looked at, a way around
/// a pin, and an error that points elsewhere.
// [NCP-WIRE-001] [NCP-WIRE-002] [NCP-WIRE-003] [NCP-WIRE-004] [NCP-WIRE-006] [NCP-WIRE-028]
// [NCP-WIRE-030] [NCP-WIRE-060] [NCP-PROV-001] [NCP-PROV-002] [NCP-PROV-003] [NCP-PROV-004]
// [NCP-PROV-006] [NCP-STRICT-002] [NCP-STRICT-003] [NCP-STRICT-004]
pub fn frame_decode(input: &[u8]) {
    let (kind, frame) = split(input);
    let decoded = decode(kind, frame);
    let of_any = decode_any(frame);
    let message = match decoded {
        Ok(message) => message,
        Err(error) => {
            judge_error(&error, frame, &of_any);
            assert!(decode_strict(kind, frame).is_err());
            return;
        }
    };
    assert_eq!(message.kind(), kind);
    assert_eq!(of_any.as_ref(), Ok(&message));
    assert!(frame.len() <= kind.max_bytes());
    for other in Kind::ALL {
        assert!(other == kind || other.decode_fails(frame), "{other} is read from a {kind}");
    }
    let value: Value = serde_json::from_slice(frame).expect("what is read is JSON");
    assert!(value.is_object());
    assert_eq!(value["kind"], kind.as_str());
    let pinned = match kind {
        Kind::ObservationFrame => Some(&value),
        Kind::SessionOpened => value.get("provenance").filter(|value| !value.is_null()),
        _ => None,
    };
    judge_strictness(&message, frame, &value);
    judge_length(kind, frame);
    if let Some(pinned) = pinned {
        let is = |pin: &str, at| pinned.get(pin).is_none_or(|value| *value == Value::Bool(at));
        assert!(is("calibrated_posterior", false) && is("is_simulation_output", true));
    }
}

/// What is read is written, and is then read as the same message, with every value that the frame
/// gave, in the order of the tables.
///
/// It would find a digit or a sign that is lost, a map entry that is dropped, two fields that are
/// swapped, an encoder whose frames its own decoder refuses, one that sends what nobody may, and a
/// map that loses what a program puts into it.
// [NCP-WIRE-015] [NCP-WIRE-034] [NCP-WIRE-041] [NCP-WIRE-043] [NCP-WIRE-080] [NCP-WIRE-081]
// [NCP-WIRE-083] [NCP-WIRE-084] [NCP-WIRE-085] [NCP-WIRE-086] [NCP-WIRE-091] [NCP-WIRE-093] [NCP-WIRE-102]
// [NCP-PROV-008]
pub fn frame_roundtrip(input: &[u8]) {
    let (kind, frame) = split(input);
    let Ok(message) = ncp_spec::wire::decode(kind, frame) else {
        return;
    };
    message::has_maps_like_trees(&message);
    message::refuses_one_too_many(&message);
    let text = match message.encode() {
        Ok(text) => text,
        // What was read can be sent, unless the fields that it left out make it too long.
        Err(error) => {
            assert!(message.fields().len() > kind.max_bytes(), "{error}");
            assert_eq!((error.code(), error.path()), (ErrorCode::Limit, ""));
            return message::tells(&error);
        }
    };
    message::refuses_what_is_spoilt(&message);
    let again = kind.read(text.as_bytes());
    assert_eq!(again, message);
    assert_eq!(again.encode().as_deref(), Ok(text.as_str()));
    // As an adapter sees the fields, and sets them.
    let built = build(kind, message.fields().as_bytes()).expect("its own fields are known");
    assert_eq!(built.encode().as_deref(), Ok(text.as_str()));
    if let Err(error) = build(kind, frame) {
        assert_eq!(error.code(), ErrorCode::Invalid, "{error}");
        assert_eq!(error.offset().and_then(|at| frame.get(at)), Some(&b'"'));
    }

    let given: Value = serde_json::from_slice(frame).expect("what is read is JSON");
    let written: Value = serde_json::from_str(&text).expect("what is written is JSON");
    keeps(&given, &written, "");
    let members = written.as_object().into_iter().flatten();
    for (_, word) in members {
        message::is_a_word_of_no_other_value(word.as_str().unwrap_or_default());
    }
    let written = written.as_object().expect("a frame is an object");
    if kind == Kind::Error {
        let known = ["kind", "error", "session_id"];
        assert!(written.keys().all(|name| known.contains(&name.as_str())));
    } else {
        let fields: Vec<_> = kind.table().fields.iter().map(|field| field.name).collect();
        assert_eq!(written.keys().collect::<Vec<_>>(), fields);
    }
}

/// An error has a reason, a place and a text that tells both; where the kind was right, the frame is
/// refused by its own kind too.
fn judge_error(error: &DecodeError, frame: &[u8], of_any: &Result<Message, DecodeError>) {
    assert!(!matches!(error.code(), ErrorCode::Internal | ErrorCode::Invalid));
    let (text, problem) = (error.to_string(), error.problem().to_string());
    assert!(text.starts_with(error.path()) && text.contains(&problem) && !problem.is_empty());
    assert!(error.offset().is_none_or(|at| at <= frame.len()));
    let place = error.offset().map(|at| format!("(byte {at})"));
    assert!(place.is_none_or(|place| text.ends_with(&place)), "{text}");
    assert_eq!(error.code(), error.problem().code());
    assert!(format!("{error:?}").contains(&format!("{:?}", error.problem())));
    let here = error.offset().and_then(|at| frame.get(at));
    match error.problem() {
        DecodeProblem::WrongType { expected, found } => {
            let is_found = match here {
                Some(b'"') => *found == JsonType::String,
                Some(b'{') => matches!(found, JsonType::Object(_)),
                Some(b'[') => matches!(found, JsonType::Array(_)),
                Some(b't' | b'f') => *found == JsonType::Boolean,
                Some(b'-' | b'0'..=b'9') => *found == JsonType::Number,
                _ => false,
            };
            assert!(is_found, "{error}");
            assert!(is_type_of(error.path(), *expected), "{error}");
        }
        DecodeProblem::Null { expected } => {
            assert_eq!(here, Some(&b'n'));
            assert!(is_type_of(error.path(), *expected), "{error}");
        }
        _ => {}
    }
    if let Ok(message) = of_any {
        assert_eq!(error.code(), ErrorCode::Kind, "{}", message.kind());
    }
}

/// Whether a type is that of a field that the path names, or a part of it: an enum is a string.
fn is_type_of(path: &str, expected: JsonType) -> bool {
    let tables = Kind::ALL.into_iter().map(Kind::table).chain(NESTED);
    let mut fields = tables.flat_map(|table| table.fields);
    let is_part = |json: JsonType| json.to_string().contains(&expected.to_string());
    let is_enum = |json| matches!(json, JsonType::Enum(_)) && expected == JsonType::String;
    fields.any(|field| path.contains(field.name) && (is_part(field.json) || is_enum(field.json)))
}

/// The strict profile refuses a frame that is read without it if, and only if, the version is left
/// out or not compatible, or a command has no place in its stream.
fn judge_strictness(message: &Message, frame: &[u8], value: &Value) {
    let version = value.get("ncp_version").and_then(Value::as_str);
    let expected = if message.kind() == Kind::Error {
        Ok(())
    } else if version.is_none() {
        Err(ErrorCode::Missing)
    } else if !version.is_some_and(|version| check_version(version, false) == Ok(true)) {
        Err(ErrorCode::Version)
    } else if matches!(message, Message::CommandFrame(command) if command.seq < 1) {
        Err(ErrorCode::Value)
    } else {
        Ok(())
    };
    let strict = decode_strict(message.kind(), frame);
    assert_eq!(decode_any_strict(frame), strict);
    let judged = strict.map(|same| assert_eq!(&same, message));
    assert_eq!(judged.map_err(|error| error.code()), expected);
}

/// White space counts: a frame with one byte too many is refused.
fn judge_length(kind: Kind, frame: &[u8]) {
    if kind != Kind::ObservationFrame {
        let mut long = frame.to_vec();
        long.resize(kind.max_bytes() + 1, b' ');
        let error = ncp_spec::wire::decode(kind, &long).expect_err("it is over the limit");
        assert_eq!(error.code(), ErrorCode::Limit, "{error}");
    }
}

trait KindExt {
    fn decode_fails(self, frame: &[u8]) -> bool;
    fn read(self, frame: &[u8]) -> Message;
}

impl KindExt for Kind {
    fn decode_fails(self, frame: &[u8]) -> bool {
        ncp_spec::wire::decode(self, frame).is_err()
    }

    fn read(self, frame: &[u8]) -> Message {
        ncp_spec::wire::decode(self, frame).expect("what is written can be read")
    }
}

/// Fields that are maps: all of their entries have to be kept.
const MAPS: [&str; 8] = ["channels", "horizon", "meta", "params", "population_sizes", "records", "resolved", "values"];

/// Whatever is written and was given is as it was given. A field of the given frame that is not
/// written is one that the tables do not list.
fn keeps(given: &Value, written: &Value, name: &str) {
    match (given, written) {
        (Value::Object(given), Value::Object(written)) => {
            let is_map = MAPS.contains(&name);
            assert!(!is_map || written.len() == given.len(), "entries of {name} are lost");
            assert!(!is_map || written.keys().is_sorted(), "entries of {name} are not sorted");
            for (member, written) in written {
                // An entry may be called as a field is.
                let member_name = if is_map { "" } else { member };
                match given.get(member) {
                    None | Some(Value::Null) => {}
                    Some(given) => keeps(given, written, member_name),
                }
            }
        }
        (Value::Array(given), Value::Array(written)) => {
            assert_eq!(given.len(), written.len(), "items of {name}");
            for (given, written) in given.iter().zip(written) {
                keeps(given, written, name);
            }
        }
        (Value::Number(given), Value::Number(written)) => {
            let bits = |number: &serde_json::Number| number.as_f64().map(f64::to_bits);
            assert_eq!(bits(given), bits(written), "{name}");
        }
        (Value::String(given), Value::String(written)) if name == "mode" && given != written => {
            let known = ["init", "active", "hold", "estop", "stream", "batch"];
            assert!(written == "hold" && !known.contains(&given.as_str()));
        }
        _ => assert_eq!(given, written, "{name}"),
    }
}
