//! What a frame means, by the tables of the text alone.
//!
//! This is the source of the expectations. It shares no code with `ncp-spec`; the tests of the Rust peer hold the two
//! against each other over the whole corpus.

pub(crate) use ncp_text::{CONTRACT_HASH, WIRE_VERSION};

use crate::json::Json;
use crate::scenario::beside;
use ncp_text::tables::{Default, Field, Message, Shape, Unknown, tables};

/// The frame as a decoder reads it: every field of its kind in the order of the tables, absent
/// ones at their defaults, members that the tables do not list left out. The frame has to be
/// acceptable; what the text rejects has no meaning.
pub(crate) fn meaning(kind: &str, frame: &Json) -> Json {
    let Some(message) = tables().kind(kind) else {
        return Json::Null;
    };
    let read = fields_of(message, frame).with("kind", Json::string(kind));
    if !matches!(read.get("stimulus"), Some(Json::Object(_))) || kind == "open_session" {
        return read;
    }
    // Section 1.3: what a stimulus frame leaves out, the request says.
    let said = |name: &str| frame.get("stimulus").and_then(|stimulus| stimulus.get(name)).cloned();
    let inherited = |name: &str| said(name).or_else(|| read.get(name).cloned());
    let version = inherited("ncp_version").unwrap_or(Json::Null);
    let session = inherited("session_id").unwrap_or(Json::Null);
    read.edit(&["stimulus"], |stimulus| {
        stimulus.with("ncp_version", version).with("kind", Json::string("stimulus_frame")).with("session_id", session)
    })
}

/// A frame that says only what it must: its kind and its required fields.
pub(crate) fn minimal(kind: &str) -> Json {
    let Some(message) = tables().kind(kind) else {
        return Json::Null;
    };
    let required = message.fields.iter().filter(|field| field.default == Default::Required);
    let frame = Json::object().with("kind", Json::string(kind));
    required.fold(frame, |frame, field| frame.with(&field.name, required_value(field)))
}

/// A frame that writes out every default, and leaves out only what is optional. Its
/// `contract_hash` is one's own. Used as the ground of cases that are to accept: a peer
/// whose defaults are wrong does not fail there.
pub(crate) fn explicit(kind: &str) -> Json {
    let read = without_nulls(meaning(kind, &minimal(kind)));
    let Some(message) = tables().kind(kind) else {
        return Json::Null;
    };
    match message.field("contract_hash") {
        Some(_) => read.with("contract_hash", Json::string(CONTRACT_HASH)),
        None => read,
    }
}

/// A message that stands in others, every default written out, optional fields left out.
pub(crate) fn explicit_message(name: &str) -> Json {
    tables().message(name).map_or(Json::Null, |message| {
        let read = without_nulls(fields_of(message, &Json::object()));
        if message.name == "StimulusFrame" { explicit("stimulus_frame") } else { read }
    })
}

/// A frame in which every field has a value that is not its default, but for the version and the
/// pins.
pub(crate) fn full(kind: &str) -> Json {
    let Some(message) = tables().kind(kind) else {
        return Json::Null;
    };
    full_message(&message.name)
}

/// A message in which every field has a value that is not its default, but for the version and the
/// pins.
pub(crate) fn full_message(name: &str) -> Json {
    let Some(message) = tables().message(name) else {
        return Json::Null;
    };
    let fields = message.fields.iter().map(|field| match field.name.as_str() {
        "ncp_version" => (field.name.clone(), Json::string(WIRE_VERSION)),
        _ => (field.name.clone(), sample(message, field)),
    });
    Json::Object(fields.collect())
}

/// A value of a field that is allowed and not its default.
pub(crate) fn sample(message: &Message, field: &Field) -> Json {
    if field.default == Default::Kind {
        return Json::string(message.kind.as_deref().unwrap_or_default());
    }
    if is_pin(&field.name)
        && let Some(pinned) = default_of(field)
    {
        return pinned;
    }
    match &field.shape {
        Shape::Boolean => Json::Bool(default_of(field) != Some(Json::Bool(true))),
        shape => sample_of(shape, &field.name, &field.default),
    }
}

/// What the tables write for an absent field, where that is a value.
pub(crate) fn default_of(field: &Field) -> Option<Json> {
    match &field.default {
        Default::Value(value) => Some(Json::from(value)),
        _ => None,
    }
}

/// Whether the field is one of the two that chapter 6 pins.
pub(crate) fn is_pin(field: &str) -> bool {
    matches!(field, "calibrated_posterior" | "is_simulation_output")
}

/// A double as the shortest text that reads back, always with a fraction or an exponent.
pub(crate) fn double(value: f64) -> Json {
    Json::literal(format!("{value:?}"))
}

/// The session of all samples.
pub(crate) const SESSION: &str = "s1";

fn fields_of(message: &Message, object: &Json) -> Json {
    let read = message.fields.iter().map(|field| {
        let given = object.get(&field.name).filter(|value| **value != Json::Null);
        let value = match (given, &field.default) {
            (Some(given), _) => value_of(&field.shape, given),
            (None, Default::Value(default)) => value_of(&field.shape, &Json::from(default)),
            (None, Default::Message) => value_of(&field.shape, &Json::object()),
            (None, _) => Json::Null,
        };
        (field.name.clone(), value)
    });
    Json::Object(read.collect())
}

fn value_of(shape: &Shape, given: &Json) -> Json {
    match (shape, given) {
        (Shape::Number, Json::Literal(digits)) => digits.parse().map_or_else(|_| given.clone(), double),
        (Shape::Enum(name), Json::String(string)) => match tables().enumeration(name) {
            Some(known) if !known.strings.contains(string) => match &known.unknown {
                Unknown::ReadsAs(other) => Json::string(other),
                _ => given.clone(),
            },
            _ => given.clone(),
        },
        (Shape::Message(name), Json::Object(_)) => {
            tables().message(name).map_or(Json::Null, |message| fields_of(message, given))
        }
        (Shape::List(item), Json::Array(items)) => items.iter().map(|given| value_of(item, given)).collect(),
        (Shape::Map(value), Json::Object(members)) => {
            let mut read: Vec<_> = members.iter().map(|(key, given)| (key.clone(), value_of(value, given))).collect();
            // Strings of Rust compare by their UTF-8 bytes, which is by code point.
            read.sort_by(|(a, _), (b, _)| a.cmp(b));
            Json::Object(read)
        }
        _ => given.clone(),
    }
}

fn without_nulls(value: Json) -> Json {
    match value {
        Json::Object(members) => {
            let set = members.into_iter().filter(|(_, value)| *value != Json::Null);
            Json::Object(set.map(|(name, value)| (name, without_nulls(value))).collect())
        }
        Json::Array(items) => items.into_iter().map(without_nulls).collect(),
        scalar => scalar,
    }
}

fn required_value(field: &Field) -> Json {
    match (field.name.as_str(), &field.shape) {
        ("session_id", _) => Json::string(SESSION),
        ("error", _) => Json::string("no such session"),
        (_, Shape::Message(_)) => Json::object(),
        (_, Shape::Number) => Json::literal("100.0"),
        (_, Shape::String) => Json::string("c1"),
        _ => Json::Null,
    }
}

fn sample_of(shape: &Shape, name: &str, default: &Default) -> Json {
    match shape {
        Shape::String if name == "ncp_version" => Json::string(beside(-1)),
        Shape::String => Json::string(sample_string(name)),
        Shape::Boolean => Json::Bool(true),
        Shape::Integer => Json::literal("7"),
        Shape::Number => Json::literal("12.5"),
        Shape::Enum(name) => {
            let strings = tables().enumeration(name).map_or(&[][..], |known| &known.strings);
            let other = strings.iter().rev().find(|s| match default {
                Default::Value(value) => value.as_str() != Some(s),
                _ => true,
            });
            Json::string(other.map_or("", String::as_str))
        }
        Shape::Message(name) => full_message(name),
        Shape::List(item) => match &**item {
            Shape::Number => ["0.5", "-1.25"].into_iter().map(Json::literal).collect(),
            Shape::Integer => ["3", "-1", "2"].into_iter().map(Json::literal).collect(),
            item => Json::Array(vec![sample_of(item, name, &Default::Absent)]),
        },
        Shape::Map(value) => Json::object().with("a", sample_of(value, name, &Default::Absent)),
    }
}

fn sample_string(field: &str) -> &'static str {
    match field {
        "session_id" => SESSION,
        "contract_hash" => "2cf0763ad61e4f1c",
        "controller_id" => "c2",
        "frame_id" => "body",
        "backend" => "nest-3.8",
        "error" => "no such model",
        "note" => "first tick",
        "path" => "/world/uav3/imu",
        "direction" => "record",
        "ref" => "balanced",
        "model_name" => "iaf_psc_alpha",
        "recordables" | "recordable" => "g_ex",
        "codec_id" => "ncp.codec.rate.v0",
        "unit" => "m/s",
        "meta" => "left wing",
        "description" => "the pose error",
        "network_ref" => "builtin:balanced",
        _ => "p0",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::json::object;

    #[test]
    fn a_command_frame_without_a_mode_means_hold() {
        let text = meaning("command_frame", &minimal("command_frame")).text();
        let known = [
            &format!(r#"{{"ncp_version":"{WIRE_VERSION}","kind":"command_frame","seq":0,"t":0.0,"#),
            r#""frame_id":"world","mode":"hold","ttl_ms":200.0,"channels":{},"horizon":[],"horizon_dt_ms":null"#,
        ]
        .concat();
        // Fields of a later contract stand behind these, and have no value in the smallest frame.
        let later = text.strip_prefix(&known).and_then(|rest| rest.strip_suffix('}'));
        let later = later.unwrap_or_else(|| panic!("{text}"));
        assert!(later.split(',').skip(1).all(|member| member.ends_with(":null")), "{text}");
    }

    #[test]
    fn a_stimulus_frame_takes_from_its_request_what_it_leaves_out() {
        let request = minimal("step_request")
            .with("ncp_version", Json::string("0.6"))
            .with("stimulus", object! { "t" => Json::literal("2") });
        assert_eq!(
            meaning("step_request", &request).get("stimulus").unwrap().text(),
            concat!(r#"{"ncp_version":"0.6","kind":"stimulus_frame","session_id":"s1","#, r#""t":2.0,"values":{}}"#)
        );
    }

    #[test]
    fn a_full_frame_differs_from_every_default() {
        for kind in ["command_frame", "link_status", "capabilities"] {
            let defaults = meaning(kind, &minimal(kind));
            for (name, value) in full(kind).members() {
                let is_fixed = matches!(name.as_str(), "kind" | "ncp_version");
                assert!(is_fixed || defaults.get(name) != Some(value), "{kind}.{name}");
            }
        }
    }

    #[test]
    fn map_entries_are_sorted_by_code_point() {
        let frame = minimal("sensor_frame")
            .with("channels", object! { "\u{1f600}" => Json::object(), "\u{ff5e}" => Json::object() });
        let read = meaning("sensor_frame", &frame);
        let keys: Vec<_> = read.get("channels").unwrap().members().iter().map(|(key, _)| key.as_str()).collect();
        assert_eq!(keys, ["\u{ff5e}", "\u{1f600}"]);
    }
}
