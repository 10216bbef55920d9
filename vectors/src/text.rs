//! The tables of the normative text, read from the text itself.
//!
//! What a field's default is, which fields are required, how an enum is spelled: the expectations
//! take it from the words that bind, not from an implementation. Chapter 1 is compiled in and read
//! once. The reader is total; a test makes sure that no row of the text escapes it.

use std::sync::LazyLock;

use crate::json::Json;

/// The tables of chapter 1.
pub(crate) fn tables() -> &'static Tables {
    static TABLES: LazyLock<Tables> = LazyLock::new(|| Tables::read(include_str!("../../spec/text/01-wire.md")));
    &TABLES
}

/// The enums and messages of chapter 1.
#[derive(Debug)]
pub(crate) struct Tables {
    /// Section 1.4.
    pub(crate) enums: Vec<Enum>,
    /// Section 1.8, in its order, the RPC error frame last.
    pub(crate) messages: Vec<Message>,
}

/// An enum.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Enum {
    /// Its name, such as `Mode`.
    pub(crate) name: String,
    /// Its wire strings.
    pub(crate) strings: Vec<String>,
    /// What a receiver does with another string.
    pub(crate) unknown: Unknown,
}

/// What a receiver does with an enum string that it does not know.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Unknown {
    /// Keeps it.
    Kept,
    /// Reads it as this one.
    ReadsAs(String),
    /// Rejects the frame.
    Rejected,
}

/// A message.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Message {
    /// Its name, such as `CommandFrame`; the error frame's is `ErrorFrame`.
    pub(crate) name: String,
    /// Its `kind`, if it travels by itself.
    pub(crate) kind: Option<String>,
    /// Its fields, in order.
    pub(crate) fields: Vec<Field>,
}

impl Message {
    /// The field of that name.
    pub(crate) fn field(&self, name: &str) -> Option<&Field> {
        self.fields.iter().find(|field| field.name == name)
    }
}

/// A field.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Field {
    /// Its member name.
    pub(crate) name: String,
    /// Its JSON type.
    pub(crate) shape: Shape,
    /// Whether `null` stands for absent.
    pub(crate) optional: bool,
    /// What it is when it is absent.
    pub(crate) default: Default,
}

/// A JSON type of the tables.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Shape {
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

/// What an absent field is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Default {
    /// This value.
    Value(Json),
    /// Absent: `null` when written.
    Absent,
    /// The message with all its fields at their defaults.
    Message,
    /// An error: the field is required.
    Required,
    /// An error: the field is the frame's `kind`.
    Kind,
}

impl Tables {
    /// The message of that name.
    pub(crate) fn message(&self, name: &str) -> Option<&Message> {
        self.messages.iter().find(|message| message.name == name)
    }

    /// The message of that kind.
    pub(crate) fn kind(&self, kind: &str) -> Option<&Message> {
        self.messages.iter().find(|message| message.kind.as_deref() == Some(kind))
    }

    /// The enum of that name.
    pub(crate) fn enumeration(&self, name: &str) -> Option<&Enum> {
        self.enums.iter().find(|known| known.name == name)
    }

    fn read(chapter: &str) -> Self {
        let mut tables = Self { enums: Vec::new(), messages: Vec::new() };
        for line in chapter.lines() {
            if let Some(heading) = line.strip_prefix("### ") {
                tables.messages.push(message(heading));
            } else if line.starts_with("| `") {
                let cells = cells(line);
                match tables.messages.last_mut() {
                    Some(message) => message.fields.extend(field(&cells)),
                    None => tables.enums.extend(enumeration(&cells)),
                }
            }
        }
        let names: Vec<String> = tables.enums.iter().map(|known| known.name.clone()).collect();
        for field in tables.messages.iter_mut().flat_map(|message| &mut message.fields) {
            name_enums(&mut field.shape, &names);
        }
        tables
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

/// The cells of a table row; a bar within a cell is escaped.
fn cells(row: &str) -> Vec<String> {
    let row = row.trim().trim_start_matches('|').trim_end_matches('|');
    let row = row.replace("\\|", "\u{0}");
    row.split('|').map(|cell| cell.trim().replace('\u{0}', "|")).collect()
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
        "the wire version" => Default::Value(Json::string("0.5")),
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

/// A default of the tables: a string without escapes, an empty list or map, or a literal.
fn value_of(text: &str) -> Json {
    match text {
        "[]" => Json::Array(Vec::new()),
        "{}" => Json::object(),
        "true" => Json::Bool(true),
        "false" => Json::Bool(false),
        _ => match text.strip_prefix('"').and_then(|t| t.strip_suffix('"')) {
            Some(string) => Json::string(string),
            None => Json::literal(text),
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

    const CHAPTER: &str = include_str!("../../spec/text/01-wire.md");

    #[test]
    fn every_row_of_the_chapter_is_an_enum_or_a_field() {
        // Two more tables of the chapter have rows that begin with something else than a code.
        let rows = CHAPTER.lines().filter(|line| line.starts_with("| `")).count();
        let read = tables().enums.len() + tables().messages.iter().map(|message| message.fields.len()).sum::<usize>();
        assert_eq!(read, rows);
        assert!(tables().messages.iter().all(|message| !message.fields.is_empty()));
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
        tables().messages.iter().flat_map(|m| &m.fields).for_each(|field| check(&field.shape));
    }

    #[test]
    fn a_command_frame_is_as_the_chapter_says() {
        let command = tables().kind("command_frame").unwrap();
        let names: Vec<_> = command.fields.iter().map(|field| field.name.as_str()).collect();
        assert_eq!(
            names,
            ["ncp_version", "kind", "seq", "t", "frame_id", "mode", "ttl_ms", "channels", "horizon", "horizon_dt_ms"]
        );
        assert_eq!(command.fields[5].shape, Shape::Enum("Mode".into()));
        assert_eq!(command.fields[5].default, Default::Value(Json::string("hold")));
        assert_eq!(
            command.fields[8].shape,
            Shape::List(Box::new(Shape::Map(Box::new(Shape::Message("ChannelValue".into())))))
        );
        assert!(command.fields[9].optional);
    }
}
