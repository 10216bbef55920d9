//! The tables of fields and enums: sections 1.4 and 1.8, and the one of section 5.3.
//!
//! What a field's type and default are, which fields are required, how an enum is spelled. The reader is total; a test
//! makes sure that no row of the text escapes it.

use std::fmt;
use std::sync::LazyLock;

use crate::chapters::{OBSERVATIONS_AND_BULK, WIRE};
use crate::identity::WIRE_VERSION;
use crate::markdown::cells;

/// The tables of the text, read once.
pub fn tables() -> &'static Tables {
    static TABLES: LazyLock<Tables> = LazyLock::new(|| Tables::read(WIRE.text, OBSERVATIONS_AND_BULK.text));
    &TABLES
}

/// The enums and messages of the text.
#[derive(Debug)]
pub struct Tables {
    /// Section 1.4.
    pub enums: Vec<Enum>,
    /// Section 1.8, in its order, the RPC error frame last.
    pub messages: Vec<Message>,
    /// Section 5.3. It stands apart because no peer has to speak its JSON form.
    pub bulk_observation: Message,
}

impl Tables {
    /// The message of that name.
    #[must_use]
    pub fn message(&self, name: &str) -> Option<&Message> {
        self.all_messages().find(|message| message.name == name)
    }

    /// The message of that kind.
    #[must_use]
    pub fn kind(&self, kind: &str) -> Option<&Message> {
        self.all_messages().find(|message| message.kind.as_deref() == Some(kind))
    }

    /// The enum of that name.
    #[must_use]
    pub fn enumeration(&self, name: &str) -> Option<&Enum> {
        self.enums.iter().find(|known| known.name == name)
    }

    /// The messages, that of section 5.3 last.
    pub fn all_messages(&self) -> impl Iterator<Item = &Message> {
        self.messages.iter().chain([&self.bulk_observation])
    }
}

/// An enum.
#[derive(Debug, PartialEq, Eq)]
pub struct Enum {
    /// Its name, such as `Mode`.
    pub name: String,
    /// Its wire strings.
    pub strings: Vec<String>,
    /// What a receiver does with another string.
    pub unknown: Unknown,
}

/// What a receiver does with an enum string that it does not know.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Unknown {
    /// Keeps it. `// [NCP-WIRE-042]`
    Kept,
    /// Reads it as this one. `// [NCP-WIRE-041]`
    ReadsAs(String),
    /// Rejects the frame. `// [NCP-WIRE-044]`
    Rejected,
}

/// A message.
#[derive(Debug, PartialEq, Eq)]
pub struct Message {
    /// Its name, such as `CommandFrame`; the error frame's is `ErrorFrame`.
    pub name: String,
    /// Its `kind`, if it travels by itself.
    pub kind: Option<String>,
    /// Its fields, in order.
    pub fields: Vec<Field>,
}

impl Message {
    /// The field of that name.
    #[must_use]
    pub fn field(&self, name: &str) -> Option<&Field> {
        self.fields.iter().find(|field| field.name == name)
    }
}

/// A field.
#[derive(Debug, PartialEq, Eq)]
pub struct Field {
    /// Its member name.
    pub name: String,
    /// Its JSON type.
    pub shape: Shape,
    /// Whether `null` stands for absent. `// [NCP-WIRE-022]`
    pub optional: bool,
    /// What it is when it is absent. `// [NCP-WIRE-023]`
    pub default: Default,
}

impl Field {
    /// Whether a frame without it is rejected. `// [NCP-WIRE-027] [NCP-WIRE-028]`
    #[must_use]
    pub fn is_required(&self) -> bool {
        matches!(self.default, Default::Required | Default::Kind)
    }

    /// Its type as the text writes it, such as `string|null`.
    #[must_use]
    pub fn json_type(&self) -> String {
        format!("{}{}", self.shape, if self.optional { "|null" } else { "" })
    }
}

/// A JSON type of the tables.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Shape {
    /// `string`
    String,
    /// `boolean`
    Boolean,
    /// `integer`
    Integer,
    /// `number`
    Number,
    /// The name of an enum.
    Enum(String),
    /// The name of a message.
    Message(String),
    /// `[item]`
    List(Box<Shape>),
    /// `{string: value}`
    Map(Box<Shape>),
}

impl fmt::Display for Shape {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::String => f.write_str("string"),
            Self::Boolean => f.write_str("boolean"),
            Self::Integer => f.write_str("integer"),
            Self::Number => f.write_str("number"),
            Self::Enum(name) | Self::Message(name) => f.write_str(name),
            Self::List(item) => write!(f, "[{item}]"),
            Self::Map(value) => write!(f, "{{string: {value}}}"),
        }
    }
}

/// What an absent field is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Default {
    /// This value.
    Value(Value),
    /// Absent: `null` when written.
    Absent,
    /// The message with all its fields at their defaults.
    Message,
    /// An error: the field is required.
    Required,
    /// An error: the field is the frame's `kind`.
    Kind,
}

/// A default as the tables write it. Its `Display` is its JSON text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Value {
    /// `true` or `false`
    Bool(bool),
    /// A number, as it is spelled.
    Number(String),
    /// A string; none of the tables needs an escape.
    String(String),
    /// `[]`
    EmptyList,
    /// `{}`
    EmptyMap,
}

impl Value {
    /// The string, if it is one.
    #[must_use]
    pub fn as_str(&self) -> Option<&str> {
        match self {
            Self::String(text) => Some(text),
            _ => None,
        }
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Bool(value) => write!(f, "{value}"),
            Self::Number(spelled) => f.write_str(spelled),
            Self::String(text) => write!(f, "\"{text}\""),
            Self::EmptyList => f.write_str("[]"),
            Self::EmptyMap => f.write_str("{}"),
        }
    }
}

impl Tables {
    fn read(wire: &str, bulk: &str) -> Self {
        let mut enums = Vec::new();
        let mut messages: Vec<Message> = Vec::new();
        for line in wire.lines() {
            if let Some(heading) = line.strip_prefix("### ") {
                messages.push(message(heading));
            } else if line.starts_with("| `") {
                match messages.last_mut() {
                    Some(message) => message.fields.extend(field(&cells(line))),
                    None => enums.extend(enumeration(&cells(line))),
                }
            }
        }
        // The chapter's other tables do not begin with a code.
        let rows = bulk.lines().filter(|line| line.starts_with("| `"));
        let fields = rows.filter_map(|row| field(&cells(row))).collect();
        let mut bulk_observation = Message { fields, ..message("BulkObservation · `bulk_observation`") };

        let names: Vec<String> = enums.iter().map(|known: &Enum| known.name.clone()).collect();
        for field in messages.iter_mut().chain([&mut bulk_observation]).flat_map(|message| &mut message.fields) {
            name_enums(&mut field.shape, &names);
        }
        Self { enums, messages, bulk_observation }
    }
}

/// `CommandFrame · `command_frame``, `ChannelValue` or `The RPC error frame`.
fn message(heading: &str) -> Message {
    let (name, kind) = match heading.split_once(" · ") {
        Some((name, kind)) => (name, Some(kind.trim_matches('`').to_owned())),
        None if heading == "The RPC error frame" => ("ErrorFrame", Some("error".to_owned())),
        None => (heading, None),
    };
    Message { name: name.to_owned(), kind, fields: Vec::new() }
}

fn enumeration(cells: &[String]) -> Option<Enum> {
    let [name, strings, unknown] = cells else {
        return None;
    };
    let unknown = match unknown.strip_prefix("reads as ") {
        Some(value) => Unknown::ReadsAs(value.trim_matches('`').to_owned()),
        None if unknown == "the frame is rejected" => Unknown::Rejected,
        None if unknown == "descriptive: kept as it is" => Unknown::Kept,
        None => return None,
    };
    Some(Enum {
        name: name.trim_matches('`').to_owned(),
        strings: strings.split(", ").map(|s| s.trim_matches('`').to_owned()).collect(),
        unknown,
    })
}

fn field(cells: &[String]) -> Option<Field> {
    let [name, shape, default, _meaning] = cells else {
        return None;
    };
    let name = name.trim_matches('`').to_owned();
    let (shape, optional) = match shape.strip_suffix("|null") {
        Some(shape) => (shape, true),
        None => (shape.as_str(), false),
    };
    let default = match default.as_str() {
        "required" if name == "kind" => Default::Kind,
        "none: it must be there" => Default::Kind,
        "required" => Default::Required,
        "absent" | "optional" => Default::Absent,
        "all defaults" => Default::Message,
        "the wire version" => Default::Value(Value::String(WIRE_VERSION.to_owned())),
        value => Default::Value(value_of(value.strip_prefix('`')?.strip_suffix('`')?)),
    };
    Some(Field { name, shape: shape_of(shape), optional, default })
}

fn shape_of(text: &str) -> Shape {
    if let Some(item) = text.strip_prefix('[').and_then(|t| t.strip_suffix(']')) {
        return Shape::List(Box::new(shape_of(item)));
    }
    if let Some(value) = text.strip_prefix("{string: ").and_then(|t| t.strip_suffix('}')) {
        return Shape::Map(Box::new(shape_of(value)));
    }
    match text {
        "string" => Shape::String,
        "boolean" => Shape::Boolean,
        "integer" => Shape::Integer,
        "number" => Shape::Number,
        name => Shape::Message(name.to_owned()),
    }
}

fn value_of(text: &str) -> Value {
    match text {
        "[]" => Value::EmptyList,
        "{}" => Value::EmptyMap,
        "true" => Value::Bool(true),
        "false" => Value::Bool(false),
        _ => match text.strip_prefix('"').and_then(|t| t.strip_suffix('"')) {
            Some(string) => Value::String(string.to_owned()),
            None => Value::Number(text.to_owned()),
        },
    }
}

/// Turns the message shapes that name an enum into enum shapes.
fn name_enums(shape: &mut Shape, enums: &[String]) {
    match shape {
        Shape::Message(name) if enums.contains(name) => *shape = Shape::Enum(std::mem::take(name)),
        Shape::List(inner) | Shape::Map(inner) => name_enums(inner, enums),
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_row_that_begins_with_a_code_is_an_enum_or_a_field() {
        let rows = |text: &str| text.lines().filter(|line| line.starts_with("| `")).count();
        let fields: usize = tables().all_messages().map(|message| message.fields.len()).sum();
        assert_eq!(tables().enums.len() + fields, rows(WIRE.text) + rows(OBSERVATIONS_AND_BULK.text));
        assert!(tables().all_messages().all(|message| !message.fields.is_empty()));
    }

    #[test]
    fn every_message_that_a_field_names_has_a_table() {
        fn check(shape: &Shape) {
            match shape {
                Shape::Message(name) => assert!(tables().message(name).is_some(), "{name}"),
                Shape::List(inner) | Shape::Map(inner) => check(inner),
                _ => {}
            }
        }
        tables().all_messages().flat_map(|m| &m.fields).for_each(|field| check(&field.shape));
    }

    #[test]
    fn a_command_frame_is_as_the_chapter_says() {
        let command = tables().kind("command_frame").unwrap();
        assert_eq!(command.name, "CommandFrame");
        assert_eq!(command.field("mode").unwrap().shape, Shape::Enum("Mode".into()));
        assert_eq!(command.field("mode").unwrap().default, Default::Value(Value::String("hold".into())));
        assert_eq!(command.field("horizon").unwrap().json_type(), "[{string: ChannelValue}]");
        assert_eq!(command.field("horizon_dt_ms").unwrap().json_type(), "number|null");
        assert!(command.field("kind").unwrap().is_required());
    }

    #[test]
    fn every_message_with_a_version_has_the_wire_version_as_its_default() {
        let versions: Vec<_> = tables().all_messages().filter_map(|message| message.field("ncp_version")).collect();
        assert!(versions.len() > 10);
        for version in versions {
            assert_eq!(version.default.clone(), Default::Value(Value::String(WIRE_VERSION.to_owned())));
        }
    }
}
