//! The JSON projection: how the messages of the proto travel as JSON.
//!
//! The proto text says nothing about wire strings, defaults, required fields, `null` or limits.
//! The text does; `projection.json` is made from both, and this module reads it. It is data for the schema generator
//! and for the breaking check; no codec uses it.

use std::{collections::BTreeMap, fmt, str::FromStr};

use serde::Deserialize;
use serde_json::Value;
use thiserror::Error;

/// All of `projection.json`.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Projection {
    /// What the file is, for people.
    pub about: String,
    /// Version of the file format; 1.
    pub format: u32,
    /// The wire version, `major.minor`.
    pub wire: String,
    /// The package of the proto that is projected.
    pub package: String,
    /// The contract hash of that proto.
    pub contract_hash: String,
    /// The bounds that every receiver keeps.
    pub limits: Limits,
    /// By enum name: the wire strings, and what an unknown one means.
    pub enums: BTreeMap<String, EnumProjection>,
    /// By message name: the fields as they stand on JSON.
    pub messages: BTreeMap<String, MessageProjection>,
    /// The RPC error frame, which has no message in the proto.
    pub error_frame: MessageProjection,
}

/// Bounds of frames. Sizes are in bytes, the rest are counts.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Limits {
    /// Integers lie within plus and minus this value. [NCP-WIRE-011]
    pub integer: u64,
    /// Entries of a map. [NCP-WIRE-066]
    pub entries: u64,
    /// Items of an array whose items are not numbers. [NCP-WIRE-067]
    pub items: u64,
    /// Levels of nested objects and arrays. [NCP-WIRE-064]
    pub levels: u64,
    /// Bytes of an id segment in UTF-8. [NCP-KEY-017]
    pub segment_bytes: u64,
    /// Bytes of a frame. [NCP-WIRE-060]
    pub frame_bytes: u64,
    /// Bytes of a frame of particular kinds. [NCP-WIRE-062]
    pub frame_bytes_of: BTreeMap<String, u64>,
    /// Bytes of a BulkBlock. [NCP-BULK-015]
    pub block_bytes: u64,
}

/// How one enum travels.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EnumProjection {
    /// What a receiver makes of a string that is not among the values.
    pub unknown: Unknown,
    /// The wire string of each proto constant, the zero constant left out.
    pub values: BTreeMap<String, String>,
}

/// What a receiver makes of a wire string that it does not know.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Unknown {
    /// Keeps it, and writes it unchanged. [NCP-WIRE-042] [NCP-WIRE-043]
    Keep,
    /// Reads it as this wire string. [NCP-WIRE-041]
    ReadAs(String),
    /// Rejects the frame. [NCP-WIRE-044]
    Reject,
}

/// How one message travels.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MessageProjection {
    /// Its kind, when it is a frame of its own.
    #[serde(default)]
    pub kind: Option<String>,
    /// Whether peers have to speak its JSON form.
    #[serde(default)]
    pub json_form: JsonForm,
    /// On JSON its one field stands in the message's place.
    #[serde(default)]
    pub transparent: bool,
    /// The fields without which a frame is rejected. [NCP-WIRE-027] [NCP-WIRE-028]
    #[serde(default)]
    pub required: Vec<String>,
    /// What changes for a frame that stands inside a request. [NCP-WIRE-035]
    #[serde(default)]
    pub inside_request: Option<InsideRequest>,
    /// The fields by name. Their order is the proto's.
    pub fields: BTreeMap<String, FieldProjection>,
}

/// Whether peers have to speak a message's JSON form.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum JsonForm {
    /// It is the form that travels.
    #[default]
    Normal,
    /// A peer may offer it. [NCP-OBS-012]
    Optional,
}

/// What changes for a frame that stands inside a request.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct InsideRequest {
    /// Fields that may be left out there. [NCP-WIRE-035]
    pub may_be_absent: Vec<String>,
    /// Fields that must equal the request's, where present. [NCP-WIRE-037] [NCP-WIRE-038]
    pub same_as_request: Vec<String>,
}

/// How one field travels.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FieldProjection {
    /// Its JSON type.
    #[serde(rename = "type")]
    pub ty: JsonType,
    /// What an absent field is read as; `None` for a field that must be there. `Some(null)` is
    /// absent.
    #[serde(default, deserialize_with = "present")]
    pub default: Option<Value>,
    /// What a program that builds the message gets, where that is not the default.
    #[serde(default, deserialize_with = "present")]
    pub built: Option<Value>,
    /// The only value that is allowed.
    #[serde(default)]
    pub pinned: Option<Value>,
    /// A string that is one segment of a key. [NCP-WIRE-031]
    #[serde(default)]
    pub segment: bool,
    /// How bytes are written in a string.
    #[serde(default)]
    pub encoding: Option<Encoding>,
    /// How an unset optional field is written.
    #[serde(default)]
    pub unset: Unset,
}

/// How bytes are written in a string.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Encoding {
    /// RFC 4648 section 4, padded.
    Base64,
}

/// How an unset optional field is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Unset {
    /// As `null`. [NCP-WIRE-082]
    #[default]
    Null,
    /// Not at all. [NCP-WIRE-102]
    Omit,
}

/// A JSON type in the notation of the text: `integer`, `string|null`, `[RecordTarget]`,
/// `{string: ChannelValue}`.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(try_from = "String")]
pub struct JsonType {
    /// The type without `null`.
    pub shape: Shape,
    /// Whether `null` may stand for absent. [NCP-WIRE-022]
    pub nullable: bool,
}

/// A JSON type without `null`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Shape {
    /// An integer within the limits.
    Integer,
    /// A finite double.
    Number,
    /// A string.
    String,
    /// `true` or `false`.
    Boolean,
    /// A message or an enum of the proto, by name.
    Named(String),
    /// An array.
    Array(Box<Shape>),
    /// An object with free member names.
    Map(Box<Shape>),
}

impl Shape {
    /// Whether this is a numeric array, whose length only the frame's size bounds. [NCP-WIRE-069]
    pub fn is_numeric_array(&self) -> bool {
        matches!(self, Self::Array(items) if matches!(**items, Self::Integer | Self::Number))
    }
}

/// A type that is not in the notation.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error(
    "`{0}` is not a JSON type: expected integer, number, string, boolean, a name, [type] or {{string: type}}, \
     with |null or without"
)]
pub struct JsonTypeError(String);

impl FromStr for JsonType {
    type Err = JsonTypeError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        // Bounds the recursion below.
        if text.len() > 200 {
            return Err(JsonTypeError(text.to_owned()));
        }
        let (shape, nullable) = match text.strip_suffix("|null") {
            Some(shape) => (shape, true),
            None => (text, false),
        };
        Ok(Self { shape: Shape::parse(shape)?, nullable })
    }
}

impl TryFrom<String> for JsonType {
    type Error = JsonTypeError;

    fn try_from(text: String) -> Result<Self, Self::Error> {
        text.parse()
    }
}

impl Shape {
    fn parse(text: &str) -> Result<Self, JsonTypeError> {
        if let Some(items) = text.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
            return Ok(Self::Array(Box::new(Self::parse(items)?)));
        }
        if let Some(values) = text.strip_prefix("{string: ").and_then(|rest| rest.strip_suffix('}')) {
            return Ok(Self::Map(Box::new(Self::parse(values)?)));
        }
        match text {
            "integer" => Ok(Self::Integer),
            "number" => Ok(Self::Number),
            "string" => Ok(Self::String),
            "boolean" => Ok(Self::Boolean),
            name if name.starts_with(|c: char| c.is_ascii_uppercase())
                && name.bytes().all(|b| b.is_ascii_alphanumeric()) =>
            {
                Ok(Self::Named(name.to_owned()))
            }
            other => Err(JsonTypeError(other.to_owned())),
        }
    }
}

impl fmt::Display for JsonType {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.shape, if self.nullable { "|null" } else { "" })
    }
}

impl fmt::Display for Shape {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Integer => f.write_str("integer"),
            Self::Number => f.write_str("number"),
            Self::String => f.write_str("string"),
            Self::Boolean => f.write_str("boolean"),
            Self::Named(name) => f.write_str(name),
            Self::Array(items) => write!(f, "[{items}]"),
            Self::Map(values) => write!(f, "{{string: {values}}}"),
        }
    }
}

impl fmt::Display for Unknown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Keep => f.write_str("kept as it is"),
            Self::ReadAs(value) => write!(f, "read as {value:?}"),
            Self::Reject => f.write_str("rejected"),
        }
    }
}

/// Keeps a `null` that stands in the file apart from a member that does not.
fn present<'de, D: serde::Deserializer<'de>>(deserializer: D) -> Result<Option<Value>, D::Error> {
    Value::deserialize(deserializer).map(Some)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_type_reads_and_writes_in_the_notation_of_the_text() {
        for text in [
            "integer",
            "string|null",
            "[RecordTarget]",
            "[{string: ChannelValue}]",
            "{string: integer}",
            "SimProvenance|null",
        ] {
            assert_eq!(text.parse::<JsonType>().unwrap().to_string(), text);
        }
    }

    #[test]
    fn a_type_outside_the_notation_is_an_error() {
        for text in
            ["", "int", "[", "[number", "{number: string}", "string|nil", "null", "[string|null]", &"[".repeat(10_000)]
        {
            assert!(text.parse::<JsonType>().is_err(), "{text}");
        }
    }

    #[test]
    fn only_arrays_of_numbers_are_numeric() {
        let numeric = |text: &str| text.parse::<JsonType>().unwrap().shape.is_numeric_array();
        assert!(numeric("[number]") && numeric("[integer]"));
        assert!(!numeric("[string]") && !numeric("{string: number}") && !numeric("[[number]]"));
    }
}
