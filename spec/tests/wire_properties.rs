//! What holds of every frame: drawn from the tables, disguised, damaged, or plain noise.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may panic as tests may")]

use std::collections::HashSet;
use std::fmt;

use ncp_spec::ErrorCode;
use ncp_spec::wire::{CommandFrame, Frame, Kind, Message, SensorFrame, decode, decode_any};
use proptest::collection::vec;
use proptest::prelude::*;
use serde::de::{Deserialize, Deserializer, Error, MapAccess, SeqAccess, Visitor};
use serde_json::Value;

mod frames;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2_000))]

    /// [NCP-WIRE-034] [NCP-WIRE-080] [NCP-WIRE-081] [NCP-WIRE-082] [NCP-WIRE-093]
    #[test]
    fn what_an_encoder_writes_is_read_and_written_again_byte_by_byte((kind, frame) in frames::frame()) {
        let text = frame.to_string();
        let message = decode(kind, text.as_bytes()).map_err(|e| TestCaseError::fail(format!("{e}: {text}")))?;
        prop_assert_eq!(message.kind(), kind);
        prop_assert_eq!(&message.encode().unwrap(), &text);
        prop_assert_eq!(decode_any(text.as_bytes()), Ok(message));
    }

    /// [NCP-WIRE-005] [NCP-WIRE-012] [NCP-WIRE-022] [NCP-WIRE-034]
    #[test]
    fn another_spelling_of_a_frame_is_the_same_message((kind, frame) in frames::frame(), seed: u64) {
        let text = frames::disguise(&frame, seed);
        let message = decode(kind, text.as_bytes()).map_err(|e| TestCaseError::fail(format!("{e}: {text}")))?;
        prop_assert_eq!(message.encode().unwrap(), frame.to_string());
        prop_assert_eq!(decode_any(text.as_bytes()), Ok(message));
    }

    /// [NCP-WIRE-023] [NCP-WIRE-024] [NCP-WIRE-032]
    #[test]
    fn a_frame_without_its_optional_members_means_one_with_defaults((kind, mut frame) in frames::frame(), drop: u32) {
        let required = |name: &str| kind.table().fields.iter().any(|f| f.name == name && f.required);
        let mut left_out = Vec::new();
        let members = frame.as_object_mut().unwrap();
        let names: Vec<String> = members.keys().cloned().collect();
        for (nth, name) in names.into_iter().enumerate() {
            if drop >> nth & 1 == 1 && !required(&name) {
                members.remove(&name);
                left_out.push(name);
            }
        }
        let bare = frame.to_string();
        let read = decode(kind, bare.as_bytes());
        if matches!(&read, Err(e) if e.path() == "stimulus.ncp_version") {
            return Ok(()); // A request whose version is gone no longer fits its stimulus.
        }
        let written: Value = serde_json::from_str(&read.unwrap().encode().unwrap()).unwrap();
        let members = r#""session_id":"s","network":{},"duration_ms":0,"controller_id":"","error":"""#;
        let silent = format!(r#"{{"kind":"{kind}",{members}}}"#);
        let silent = match kind {
            Kind::SessionOpened => silent.replace(r#","error":"""#, ""),
            _ => silent,
        };
        let defaults: Value = serde_json::from_str(&decode_any(silent.as_bytes()).unwrap().encode().unwrap()).unwrap();
        for name in left_out {
            // Two kinds may name a session, and the silent frame does.
            if required("session_id") || name != "session_id" {
                prop_assert_eq!(&written[&name], &defaults[&name], "{} of {}", name, kind);
            }
        }
    }

    /// [NCP-WIRE-001] [NCP-WIRE-002] [NCP-WIRE-004] [NCP-WIRE-007]
    #[test]
    fn a_damaged_frame_is_judged_as_by_a_slower_reader_and_never_crashes(
        (kind, frame) in frames::frame(),
        seed: u64,
        damages in vec(damage(), 1..4),
    ) {
        let mut bytes = frames::disguise(&frame, seed).into_bytes();
        for damage in damages {
            damage.apply(&mut bytes);
        }
        judge(kind, &bytes)?;
    }

    /// [NCP-WIRE-001] [NCP-WIRE-002] [NCP-WIRE-003] [NCP-WIRE-004] [NCP-WIRE-007]
    #[test]
    fn noise_is_judged_as_by_a_slower_reader_and_never_crashes(
        kind in proptest::sample::select(&Kind::ALL[..]),
        bytes in prop_oneof![
            vec(any::<u8>(), 0..64),
            r#"[\[\]{}":,\\ a0-9.eE+\-truefalsn\n]{0,64}"#.prop_map(String::into_bytes),
        ],
    ) {
        judge(kind, &bytes)?;
        let ignored = [br#"{"kind":"command_frame","x":"#, &bytes[..], b"}"].concat();
        judge(Kind::CommandFrame, &ignored)?;
    }

    /// [NCP-WIRE-007] [NCP-WIRE-026]
    #[test]
    fn any_json_is_ignored_in_an_unknown_member(text in json_text()) {
        let frame = format!(r#"{{"kind":"command_frame","x":{text}}}"#);
        let is_json = serde_json::from_str::<Strict>(&frame).is_ok();
        prop_assert_eq!(CommandFrame::decode(frame.as_bytes()).is_ok(), is_json, "{}", frame);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    /// [NCP-WIRE-012] [NCP-WIRE-013]
    #[test]
    fn a_number_means_the_double_that_the_standard_library_reads(
        text in "-?(0|[1-9][0-9]{0,25})(\\.[0-9]{1,25})?([eE][+-]?[0-9]{1,3})?",
    ) {
        let frame = format!(r#"{{"kind":"sensor_frame","t":{text}}}"#);
        let read = SensorFrame::decode(frame.as_bytes()).map(|frame| frame.t.to_bits());
        let expected: f64 = text.parse().unwrap();
        if expected.is_finite() {
            prop_assert_eq!(read, Ok(expected.to_bits()), "{}", text);
            let by_serde: f64 = serde_json::from_str(&text).unwrap();
            prop_assert_eq!(by_serde.to_bits(), expected.to_bits());
        } else {
            prop_assert_eq!(read.map_err(|e| e.code()), Err(ErrorCode::Malformed), "{}", text);
        }
    }

    /// [NCP-WIRE-015] [NCP-WIRE-084]
    #[test]
    fn a_double_comes_back_bit_for_bit_and_in_its_shortest_spelling(double in frames::double()) {
        let frame = SensorFrame { t: double, ..SensorFrame::default() }.encode().unwrap();
        let read = SensorFrame::decode(frame.as_bytes()).unwrap().t;
        prop_assert_eq!(read.to_bits(), double.to_bits());
        let spelled = frame.split("\"t\":").nth(1).unwrap().split(',').next().unwrap();
        prop_assert!(spelled.contains(['.', 'e']), "{}", spelled);
        let digits = |text: &str| {
            let mantissa = text.split(['e', 'E']).next().unwrap().replace(['.', '-'], "");
            mantissa.trim_matches('0').len()
        };
        prop_assert_eq!(digits(spelled), digits(&format!("{double:e}")), "{}", spelled);
    }

    /// [NCP-WIRE-010] [NCP-WIRE-011]
    #[test]
    fn an_integer_is_read_exactly_when_it_is_spelled_as_one_and_has_53_bits(
        text in prop_oneof!["-?[0-9]{1,20}", "-?[0-9]{1,3}(\\.0|e0|E1)?", "[-+0-9.eE]{1,4}"],
    ) {
        let frame = format!(r#"{{"kind":"sensor_frame","seq":{text}}}"#);
        let read = SensorFrame::decode(frame.as_bytes()).ok().map(|frame| frame.seq);
        let expected = text.parse::<i64>().ok();
        let expected = expected.filter(|n| n.to_string() == text && n.abs() < 1 << 53);
        prop_assert_eq!(read, expected, "{}", text);
    }
}

/// Compares the verdict with that of `serde_json` over a reader that refuses repeated names, and
/// an accepted frame with itself after one more round.
fn judge(kind: Kind, bytes: &[u8]) -> Result<(), TestCaseError> {
    let shown = String::from_utf8_lossy(bytes);
    let is_json_object = serde_json::from_slice::<Strict>(bytes).is_ok_and(|json| json.is_object);
    match decode(kind, bytes) {
        Ok(message) => {
            prop_assert!(is_json_object, "accepted what is no JSON object: {}", shown);
            settles(&message)?;
            prop_assert_eq!(decode_any(bytes), Ok(message));
        }
        Err(error) if error.code() == ErrorCode::Malformed => {
            let is_base64_error = error.path() == "block";
            prop_assert!(!is_json_object || is_base64_error, "{}: {}", error, shown);
        }
        Err(_) => {}
    }
    if let Ok(message) = decode_any(bytes) {
        prop_assert_eq!(decode(message.kind(), bytes), Ok(message));
    }
    Ok(())
}

/// What was read is written, and what is written is read as the same.
fn settles(message: &Message) -> Result<(), TestCaseError> {
    let text = message.encode().map_err(|e| TestCaseError::fail(format!("{e}: {message:?}")))?;
    let again = decode(message.kind(), text.as_bytes());
    let again = again.map_err(|e| TestCaseError::fail(format!("{e}: {text}")))?;
    prop_assert_eq!(&again, message);
    prop_assert_eq!(again.encode().unwrap(), text);
    Ok(())
}

#[derive(Debug, Clone)]
enum Damage {
    Remove { at: prop::sample::Index, len: usize },
    Insert { at: prop::sample::Index, what: String },
    Replace { at: prop::sample::Index, byte: u8 },
    Repeat { from: prop::sample::Index, len: usize, to: prop::sample::Index },
}

fn damage() -> impl Strategy<Value = Damage> {
    let at = || any::<prop::sample::Index>();
    let tokens = [
        "{",
        "}",
        "[",
        "]",
        ",",
        ":",
        "\"",
        "\\",
        "null",
        "true",
        "-",
        "0",
        "1e5",
        "1e999",
        " ",
        "\\ud800",
        "\\u0061",
        "{\"a\":1,\"a\":2}",
        "\"kind\":\"command_frame\",",
        "é",
        "\u{feff}",
    ];
    prop_oneof![
        (at(), 1usize..12).prop_map(|(at, len)| Damage::Remove { at, len }),
        (at(), proptest::sample::select(tokens.to_vec()))
            .prop_map(|(at, what)| Damage::Insert { at, what: what.to_owned() }),
        (at(), any::<u8>()).prop_map(|(at, byte)| Damage::Replace { at, byte }),
        (at(), 1usize..40, at()).prop_map(|(from, len, to)| Damage::Repeat { from, len, to }),
    ]
}

impl Damage {
    fn apply(self, bytes: &mut Vec<u8>) {
        if bytes.is_empty() {
            return;
        }
        match self {
            Self::Remove { at, len } => {
                let at = at.index(bytes.len());
                bytes.drain(at..bytes.len().min(at + len));
            }
            Self::Insert { at, what } => {
                let at = at.index(bytes.len());
                bytes.splice(at..at, what.into_bytes());
            }
            Self::Replace { at, byte } => {
                let at = at.index(bytes.len());
                bytes[at] = byte;
            }
            Self::Repeat { from, len, to } => {
                let from = from.index(bytes.len());
                let piece = bytes[from..bytes.len().min(from + len)].to_vec();
                let to = to.index(bytes.len());
                bytes.splice(to..to, piece);
            }
        }
    }
}

/// JSON texts, some with a repeated name.
fn json_text() -> impl Strategy<Value = String> {
    let leaf = prop_oneof![
        Just("null".to_owned()),
        Just("true".to_owned()),
        "-?[0-9]{1,3}(\\.[0-9])?(e[0-9]{1,3})?",
        r#""([a-c]|\\u006[123]|\\n|\\ud83d\\ude81|\\ud83d|é){0,3}""#,
    ];
    leaf.prop_recursive(5, 40, 5, |inner| {
        prop_oneof![
            vec(inner.clone(), 0..5).prop_map(|items| format!("[{}]", items.join(" , "))),
            vec((r#"[a-c]{1,2}|\\u006[123]"#, inner), 0..5).prop_map(|members| {
                let members: Vec<_> = members.into_iter().map(|(name, value)| format!("\"{name}\" :{value}")).collect();
                format!("{{{}}}", members.join(","))
            }),
        ]
    })
}

/// Any JSON without a repeated name.
struct Strict {
    is_object: bool,
}

impl<'de> Deserialize<'de> for Strict {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(StrictVisitor)
    }
}

struct StrictVisitor;

impl<'de> Visitor<'de> for StrictVisitor {
    type Value = Strict;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("JSON")
    }

    fn visit_bool<E>(self, _: bool) -> Result<Strict, E> {
        Ok(Strict { is_object: false })
    }

    fn visit_i64<E>(self, _: i64) -> Result<Strict, E> {
        Ok(Strict { is_object: false })
    }

    fn visit_u64<E>(self, _: u64) -> Result<Strict, E> {
        Ok(Strict { is_object: false })
    }

    fn visit_f64<E>(self, _: f64) -> Result<Strict, E> {
        Ok(Strict { is_object: false })
    }

    fn visit_str<E>(self, _: &str) -> Result<Strict, E> {
        Ok(Strict { is_object: false })
    }

    fn visit_unit<E>(self) -> Result<Strict, E> {
        Ok(Strict { is_object: false })
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Strict, A::Error> {
        while items.next_element::<Strict>()?.is_some() {}
        Ok(Strict { is_object: false })
    }

    fn visit_map<A: MapAccess<'de>>(self, mut members: A) -> Result<Strict, A::Error> {
        let mut names = HashSet::new();
        while let Some((name, _)) = members.next_entry::<String, Strict>()? {
            if !names.insert(name) {
                return Err(A::Error::custom("a repeated name"));
            }
        }
        Ok(Strict { is_object: true })
    }
}
