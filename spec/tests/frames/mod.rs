//! Frames of every kind, drawn at random from the tables of the messages.

use ncp_spec::WIRE_VERSION;
use ncp_spec::wire::{
    ChannelKind, EntityRole, JsonType, Kind, MAX_INTEGER, Mode, NESTED, NetworkRefKind, Observable, Role, SimMode,
    StimulusKind, Table,
};
use proptest::collection::vec;
use proptest::prelude::*;
use serde_json::{Map, Value, json};

/// A frame as its encoder would write it: every field, in order, maps sorted.
pub(crate) fn frame() -> impl Strategy<Value = (Kind, Value)> {
    proptest::sample::select(&Kind::ALL[..]).prop_flat_map(|kind| (Just(kind), object(kind.table()))).prop_map(
        |(kind, mut frame)| {
            pin(kind, &mut frame);
            (kind, frame)
        },
    )
}

/// How a text may differ from the one that an encoder writes, with the same meaning.
pub(crate) fn disguise(frame: &Value, seed: u64) -> String {
    let mut text = String::new();
    Disguise { state: seed | 1 }.write(frame, 0, &mut text);
    text
}

/// A double of any size, with an accent on those that are hard to spell.
pub(crate) fn double() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => short(),
        2 => (short(), -2i64..3).prop_map(|(d, ulps)| f64::from_bits(d.to_bits().wrapping_add_signed(ulps)))
            .prop_filter("finite", |d| d.is_finite()),
        4 => any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |d| d.is_finite()),
        1 => Just(-0.0),
        1 => Just(f64::from_bits(1)),
        1 => Just(f64::MAX),
        1 => (any::<i64>(), -30i32..30).prop_map(|(n, scale)| n as f64 * 10f64.powi(scale)),
    ]
}

/// A decimal of a few digits.
fn short() -> impl Strategy<Value = f64> {
    (-100_000_000i32..100_000_000, 0i32..6, 0u32..8)
        .prop_map(|(n, scale, digits)| f64::from(n / 10i32.pow(digits)) / 10f64.powi(scale))
}

fn object(table: Table) -> BoxedStrategy<Value> {
    let fields: Vec<_> = table
        .fields
        .iter()
        .map(|field| {
            let value = match (field.name, table.kind) {
                ("kind", Some(kind)) => Just(json!(kind.as_str())).boxed(),
                ("session_id", _) => "[a-zé🚁.:_-]{1,4}x".prop_map(Value::from).boxed(),
                ("block", _) => "([A-Za-z0-9+/]{4}){0,4}".prop_map(Value::from).boxed(),
                _ => value(field.json),
            };
            (Just(field.name.to_owned()), value)
        })
        .collect();
    let is_error = table.kind == Some(Kind::Error);
    fields
        .prop_map(move |fields| {
            // An error frame leaves out what others write as null.
            let written = fields.into_iter().filter(|(_, value)| !(is_error && value.is_null()));
            Value::Object(written.collect())
        })
        .boxed()
}

fn value(json: JsonType) -> BoxedStrategy<Value> {
    match json {
        JsonType::Number => double().prop_map(|d| json!(d)).boxed(),
        JsonType::Integer => prop_oneof![-9i64..9, -MAX_INTEGER..=MAX_INTEGER, Just(MAX_INTEGER), Just(-MAX_INTEGER),]
            .prop_map(Value::from)
            .boxed(),
        JsonType::String => text().prop_map(Value::from).boxed(),
        JsonType::Boolean => any::<bool>().prop_map(Value::from).boxed(),
        JsonType::Enum(name) => wire_string(name).prop_map(Value::from).boxed(),
        JsonType::Object("StimulusFrame") => object(Kind::StimulusFrame.table()),
        JsonType::Object(name) => {
            let table = NESTED.into_iter().find(|table| table.message == name);
            object(table.unwrap_or_else(|| panic!("no table of {name}")))
        }
        JsonType::Array(item) => vec(value(*item), 0..4).prop_map(Value::from).boxed(),
        JsonType::Map(of) => proptest::collection::btree_map(text(), value(*of), 0..4)
            .prop_map(|entries| Value::Object(Map::from_iter(entries)))
            .boxed(),
        JsonType::Optional(inner) => prop_oneof![1 => Just(Value::Null), 3 => value(*inner)].boxed(),
    }
}

fn text() -> impl Strategy<Value = String> {
    prop_oneof![
        3 => "[a-z_]{0,12}",
        1 => "\\PC{0,6}",
        1 => any::<String>(),
        1 => proptest::sample::select(&["world", "m/s", WIRE_VERSION, "pose_position", "\u{0}\u{1f}\"\\/"][..])
            .prop_map(str::to_owned),
    ]
}

fn wire_string(name: &str) -> BoxedStrategy<String> {
    macro_rules! known {
        ($($name:ident)*) => {
            match name {
                $(stringify!($name) => $name::KNOWN.iter().map(|value| value.to_string()).collect(),)*
                other => panic!("no enum {other}"),
            }
        };
    }
    let known: Vec<String> = known!(Observable StimulusKind NetworkRefKind EntityRole ChannelKind Role Mode SimMode);
    let known = proptest::sample::select(known);
    if matches!(name, "Mode" | "SimMode") {
        return known.boxed();
    }
    prop_oneof![4 => known, 1 => text()].boxed()
}

/// Makes true what no field can know on its own: the pins, and that a stimulus inside a request is
/// the request's.
fn pin(kind: Kind, frame: &mut Value) {
    let header = (frame["ncp_version"].clone(), frame["session_id"].clone());
    match kind {
        Kind::ObservationFrame => {
            frame["calibrated_posterior"] = json!(false);
            frame["is_simulation_output"] = json!(true);
        }
        Kind::SessionOpened if frame["provenance"].is_object() => {
            frame["provenance"]["calibrated_posterior"] = json!(false);
            frame["provenance"]["is_simulation_output"] = json!(true);
        }
        Kind::StepRequest | Kind::RunRequest if frame["stimulus"].is_object() => {
            (frame["stimulus"]["ncp_version"], frame["stimulus"]["session_id"]) = header;
        }
        _ => {}
    }
}

/// Writes a value in another order, with other spellings, white space and unknown members.
struct Disguise {
    state: u64,
}

impl Disguise {
    fn write(&mut self, value: &Value, level: usize, text: &mut String) {
        self.space(text);
        match value {
            Value::Object(members) => {
                let mut members: Vec<_> = members.iter().collect();
                for last in (1..members.len()).rev() {
                    members.swap(last, self.below(last + 1));
                }
                text.push('{');
                let mut separator = "";
                for (name, value) in members {
                    text.push_str(std::mem::replace(&mut separator, ","));
                    self.space(text);
                    self.string(name, text);
                    self.space(text);
                    text.push(':');
                    self.write(value, level + 1, text);
                }
                // Only messages ignore what they do not know, and the top is one.
                if level == 0 && self.below(2) == 0 {
                    text.push_str(separator);
                    text.push_str(r#""unknown":[{"a":{"kind":null}},1e9,"\u00e9"]"#);
                }
                text.push('}');
            }
            Value::Array(items) => {
                text.push('[');
                for (nth, item) in items.iter().enumerate() {
                    text.push_str(if nth == 0 { "" } else { "," });
                    self.write(item, level + 1, text);
                }
                text.push(']');
            }
            Value::String(string) => self.string(string, text),
            Value::Number(number) if number.is_f64() => {
                self.double(number.as_f64().unwrap_or_default(), text);
            }
            other => text.push_str(&other.to_string()),
        }
        self.space(text);
    }

    fn double(&mut self, double: f64, text: &mut String) {
        let spelled = match self.below(4) {
            0 => format!("{double:e}"),
            1 => format!("{double:E}").replace("E-", "E-00"),
            2 => format!("{double:.17e}"),
            _ => format!("{double:?}"),
        };
        text.push_str(&spelled);
    }

    fn string(&mut self, string: &str, text: &mut String) {
        text.push('"');
        for c in string.chars() {
            if matches!(c, '"' | '\\' | '\0'..='\u{1f}') || self.below(8) == 0 {
                for unit in c.encode_utf16(&mut [0; 2]) {
                    text.push_str(&format!("\\u{unit:04X}"));
                }
            } else if c == '/' && self.below(2) == 0 {
                text.push_str("\\/");
            } else {
                text.push(c);
            }
        }
        text.push('"');
    }

    fn space(&mut self, text: &mut String) {
        if self.below(4) == 0 {
            text.push_str([" ", "\n", "\t\r", "  \n "][self.below(4)]);
        }
    }

    /// A xorshift generator: the same seed, the same text.
    fn below(&mut self, limit: usize) -> usize {
        self.state ^= self.state << 13;
        self.state ^= self.state >> 7;
        self.state ^= self.state << 17;
        (self.state >> 11) as usize % limit
    }
}
