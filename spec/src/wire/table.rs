//! The tables of section 1.8, as the messages are declared: what a message has, not what it holds.

use std::fmt;

use super::Kind;

/// A message's fields in the order in which they are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Table {
    /// The message's name, such as `CommandFrame`.
    pub message: &'static str,
    /// Its kind, if it is a frame. The field `kind` is then among the fields.
    pub kind: Option<Kind>,
    /// Its fields.
    pub fields: &'static [Field],
}

/// A field of a message.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Field {
    /// Its name on the wire.
    pub name: &'static str,
    /// Its JSON type.
    pub json: JsonType,
    /// Whether a frame without it is rejected. `kind` is required of every frame.
    pub required: bool,
}

/// A JSON type, as the tables write it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum JsonType {
    /// `number`: a double.
    Number,
    /// `integer`: an integer within ±(2^53 − 1).
    Integer,
    /// `string`.
    String,
    /// `boolean`.
    Boolean,
    /// One of an enum's wire strings.
    Enum(&'static str),
    /// A nested message.
    Object(&'static str),
    /// `[T]`.
    Array(&'static JsonType),
    /// `{string: T}`.
    Map(&'static JsonType),
    /// `T|null`.
    Optional(&'static JsonType),
}

impl JsonType {
    /// The type in words, for an error message.
    pub(crate) const fn in_words(self) -> &'static str {
        match self {
            Self::Number => "a number",
            Self::Integer => "an integer",
            Self::String | Self::Enum(_) => "a string",
            Self::Boolean => "true or false",
            Self::Object(_) | Self::Map(_) => "an object",
            Self::Array(_) => "an array",
            Self::Optional(inner) => inner.in_words(),
        }
    }
}

impl fmt::Display for JsonType {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number => f.write_str("number"),
            Self::Integer => f.write_str("integer"),
            Self::String => f.write_str("string"),
            Self::Boolean => f.write_str("boolean"),
            Self::Enum(name) | Self::Object(name) => f.write_str(name),
            Self::Array(item) => write!(f, "[{item}]"),
            Self::Map(value) => write!(f, "{{string: {value}}}"),
            Self::Optional(inner) => write!(f, "{inner}|null"),
        }
    }
}
