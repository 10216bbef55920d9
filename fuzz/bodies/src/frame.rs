//! Frames of all kinds: the first byte chooses the kind, the rest is the frame.

use ncp_spec::ErrorCode;
use ncp_spec::wire::{DecodeError, Kind, Message, build, decode_any};
use serde_json::Value;

#[cfg(not(feature = "planted"))]
use ncp_spec::wire::decode;

#[cfg(feature = "planted")]
use crate::planted::{decode, encode};

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
/// another JSON reader takes for an object of that kind, with its pins in place.
///
/// It would find a panic, an endless loop, a lax grammar, a kind that is not looked at, and a way
/// around a pin.
// [NCP-WIRE-001] [NCP-WIRE-002] [NCP-WIRE-003] [NCP-WIRE-004] [NCP-WIRE-006] [NCP-WIRE-028]
// [NCP-WIRE-030] [NCP-WIRE-060] [NCP-PROV-001] [NCP-PROV-002] [NCP-PROV-003] [NCP-PROV-004]
// [NCP-PROV-006]
pub fn frame_decode(input: &[u8]) {
    let (kind, frame) = split(input);
    let decoded = decode(kind, frame);
    let of_any = decode_any(frame);
    let message = match decoded {
        Ok(message) => message,
        Err(error) => return judge_error(&error, frame, &of_any),
    };
    assert_eq!(message.kind(), kind);
    assert_eq!(of_any.as_ref(), Ok(&message));
    assert!(frame.len() <= kind.max_bytes());
    for other in Kind::ALL {
        assert!(
            other == kind || other.decode_fails(frame),
            "{other} is read from a {kind}"
        );
    }
    let value: Value = serde_json::from_slice(frame).expect("what is read is JSON");
    assert!(value.is_object());
    assert_eq!(value["kind"], kind.as_str());
    let pinned = match kind {
        Kind::ObservationFrame => Some(&value),
        Kind::SessionOpened => value.get("provenance").filter(|value| !value.is_null()),
        _ => None,
    };
    if let Some(pinned) = pinned {
        let is = |pin: &str, at| {
            pinned
                .get(pin)
                .is_none_or(|value| *value == Value::Bool(at))
        };
        assert!(is("calibrated_posterior", false) && is("is_simulation_output", true));
    }
}

/// What is read is written, and is then read as the same message, with every value that the frame
/// gave, in the order of the tables.
///
/// It would find a digit or a sign that is lost, a map entry that is dropped, two fields that are
/// swapped, and an encoder whose frames its own decoder refuses.
// [NCP-WIRE-015] [NCP-WIRE-034] [NCP-WIRE-041] [NCP-WIRE-043] [NCP-WIRE-080] [NCP-WIRE-081]
// [NCP-WIRE-083] [NCP-WIRE-084] [NCP-WIRE-085] [NCP-WIRE-086] [NCP-WIRE-093] [NCP-WIRE-102]
pub fn frame_roundtrip(input: &[u8]) {
    let (kind, frame) = split(input);
    let Ok(message) = ncp_spec::wire::decode(kind, frame) else {
        return;
    };
    let text = encode(&message).expect("what was read can be sent");
    let again = kind.read(text.as_bytes());
    assert_eq!(again, message);
    assert_eq!(encode(&again).as_deref(), Ok(text.as_str()));
    // As an adapter sees the fields, and sets them.
    let built = build(kind, message.fields().as_bytes()).expect("its own fields are known");
    assert_eq!(encode(&built).as_deref(), Ok(text.as_str()));
    let unsendable = message.fields().replacen(":0.0", ":\"NaN\"", 1);
    if let Ok(message) = build(kind, unsendable.as_bytes())
        && message.fields().contains("\"NaN\"")
        && !text.contains("\"NaN\"")
    {
        let refused = message.encode().expect_err("JSON has no NaN");
        assert_eq!(refused.code(), ErrorCode::NonFinite, "{refused}");
    }

    let given: Value = serde_json::from_slice(frame).expect("what is read is JSON");
    let written: Value = serde_json::from_str(&text).expect("what is written is JSON");
    keeps(&given, &written, "");
    let written = written.as_object().expect("a frame is an object");
    if kind == Kind::Error {
        let known = ["kind", "error", "session_id"];
        assert!(written.keys().all(|name| known.contains(&name.as_str())));
    } else {
        let fields: Vec<_> = kind.table().fields.iter().map(|field| field.name).collect();
        assert_eq!(written.keys().collect::<Vec<_>>(), fields);
    }
}

#[cfg(not(feature = "planted"))]
fn encode(message: &Message) -> Result<String, ncp_spec::wire::EncodeError> {
    message.encode()
}

/// An error has a reason and a text; where the kind was right, the frame is refused by its own kind
/// too.
fn judge_error(error: &DecodeError, frame: &[u8], of_any: &Result<Message, DecodeError>) {
    assert!(!matches!(
        error.code(),
        ErrorCode::Internal | ErrorCode::Invalid
    ));
    assert!(!error.to_string().is_empty() && error.to_string().starts_with(error.path()));
    assert!(error.offset().is_none_or(|at| at <= frame.len()));
    if let Ok(message) = of_any {
        assert_eq!(error.code(), ErrorCode::Kind, "{}", message.kind());
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
const MAPS: [&str; 7] = [
    "channels",
    "horizon",
    "params",
    "population_sizes",
    "records",
    "resolved",
    "values",
];

/// Whatever is written and was given is as it was given. A field of the given frame that is not
/// written is one that the tables do not list.
fn keeps(given: &Value, written: &Value, name: &str) {
    match (given, written) {
        (Value::Object(given), Value::Object(written)) => {
            assert!(
                !MAPS.contains(&name) || written.len() == given.len(),
                "entries of {name} are lost"
            );
            assert!(
                !MAPS.contains(&name) || written.keys().is_sorted(),
                "entries of {name} are not sorted"
            );
            for (member, written) in written {
                match given.get(member) {
                    None | Some(Value::Null) => {}
                    // The entries of a map have names of their own, which mean nothing here.
                    Some(given) if MAPS.contains(&name) => keeps(given, written, ""),
                    Some(given) => keeps(given, written, member),
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
