//! Writes the JSON projection, from the proto and the tables of the text.
//!
//! The proto says which messages and constants there are and in which order, the text which type and default a field
//! has on JSON. What the tables do not say is here, each with the rule that does.

use std::fmt::Write as _;

use ncp_text::tables::{Default, Field, Message, Shape, Unknown, tables};
use ncp_text::{CONTRACT_HASH, WIRE_VERSION, limits};
use prost::Message as _;
use prost_types::{DescriptorProto, EnumDescriptorProto, FileDescriptorSet, field_descriptor_proto::Type};

/// The text of `projection.json` for an encoded descriptor set of `ncp.proto`.
///
/// # Errors
/// When the bytes are not a descriptor set.
pub fn projection(descriptor_set: &[u8]) -> Result<String, prost::DecodeError> {
    let file = FileDescriptorSet::decode(descriptor_set)?.file.into_iter().next().unwrap_or_default();
    let enums: Vec<_> = file.enum_type.iter().filter_map(enumeration).collect();
    let messages: Vec<_> = file.message_type.iter().map(|message| projected(message, "  ")).collect();
    let error_frame = tables().kind("error").map(|error| fields(error, None, " ")).unwrap_or_default();
    Ok(format!(
        r#"{{
 "about": "{ABOUT}",
 "format": 1,
 "wire": "{WIRE_VERSION}",
 "package": "{package}",
 "contract_hash": "{CONTRACT_HASH}",
 "limits": {{
  "integer": {integer},
  "entries": {entries},
  "items": {items},
  "levels": {levels},
  "segment_bytes": {segment_bytes},
  "frame_bytes": {frame_bytes},
  "frame_bytes_of": {{"observation_frame": {observation_frame_bytes}}},
  "block_bytes": {block_bytes}
 }},
 "enums": {{
{enums}
 }},
 "messages": {{
{messages}
 }},
 "error_frame": {{
{error_frame}
 }}
}}
"#,
        package = file.package(),
        integer = limits::INTEGER,
        entries = limits::ENTRIES,
        items = limits::ITEMS,
        levels = limits::LEVELS,
        segment_bytes = limits::SEGMENT_BYTES,
        frame_bytes = limits::FRAME_BYTES,
        observation_frame_bytes = limits::OBSERVATION_FRAME_BYTES,
        block_bytes = limits::BLOCK_BYTES,
        enums = enums.join(",\n"),
        messages = messages.join(",\n"),
    ))
}

const ABOUT: &str = "How the messages of ncp.proto travel as JSON: generated from the proto and the tables of the \
                     text. The order of fields and of enum values is the proto's.";

/// An enum; its constants are its wire strings in capitals.
fn enumeration(proto: &EnumDescriptorProto) -> Option<String> {
    let known = tables().enumeration(proto.name())?;
    let unknown = match &known.unknown {
        Unknown::Kept => "\"keep\"".to_owned(),
        Unknown::ReadsAs(string) => format!("{{\"read_as\": \"{string}\"}}"),
        Unknown::Rejected => "\"reject\"".to_owned(),
    };
    let values = proto.value.iter().filter_map(|value| {
        let string = known.strings.iter().find(|string| string.eq_ignore_ascii_case(value.name()))?;
        Some(format!("\"{}\": \"{string}\"", value.name()))
    });
    let values = values.collect::<Vec<_>>().join(", ");
    Some(format!("  \"{}\": {{\"unknown\": {unknown}, \"values\": {{{values}}}}}", known.name))
}

fn projected(proto: &DescriptorProto, indent: &str) -> String {
    let body = match tables().message(proto.name()) {
        Some(message) => fields(message, Some(proto), indent),
        // The text has no table for it: on JSON its one field stands in its place. [NCP-WIRE-051]
        None => {
            let names = proto.field.iter().map(|field| field.name());
            let fields = names.map(|name| format!("{indent}  \"{name}\": {{\"type\": \"{{string: ChannelValue}}\"}}"));
            let fields = fields.collect::<Vec<_>>().join(",\n");
            format!("{indent} \"transparent\": true,\n{indent} \"fields\": {{\n{fields}\n{indent} }}")
        }
    };
    format!("{indent}\"{}\": {{\n{body}\n{indent}}}", proto.name())
}

/// The members of a message's entry.
fn fields(message: &Message, proto: Option<&DescriptorProto>, indent: &str) -> String {
    let mut out = String::new();
    let mut member = |name: &str, value: &str| {
        // Writing to a string does not fail.
        let _ = writeln!(out, "{indent} \"{name}\": {value},");
    };
    if let Some(kind) = &message.kind {
        member("kind", &format!("\"{kind}\""));
        if message == &tables().bulk_observation {
            member("json_form", "\"optional\""); // [NCP-OBS-012]
        }
        let required = message.fields.iter().filter(|field| field.is_required());
        let required = required.map(|field| format!("\"{}\"", field.name)).collect::<Vec<_>>().join(", ");
        member("required", &format!("[{required}]"));
        if kind == "stimulus_frame" {
            // [NCP-WIRE-035] [NCP-WIRE-037] [NCP-WIRE-038]
            let may_be_absent = r#"["ncp_version", "kind", "session_id"]"#;
            let same = r#"["ncp_version", "session_id"]"#;
            member("inside_request", &format!("{{\"may_be_absent\": {may_be_absent}, \"same_as_request\": {same}}}"));
        }
    }
    let fields = message.fields.iter().map(|field| {
        let is_bytes = proto.is_some_and(|proto| {
            proto.field.iter().any(|known| known.name() == field.name && known.r#type() == Type::Bytes)
        });
        format!("{indent}  \"{}\": {{{}}}", field.name, field_members(message, field, is_bytes))
    });
    let fields = fields.collect::<Vec<_>>().join(",\n");
    format!("{out}{indent} \"fields\": {{\n{fields}\n{indent} }}")
}

fn field_members(message: &Message, field: &Field, is_bytes: bool) -> String {
    let mut members = format!("\"type\": \"{}\"", field.json_type());
    let mut add = |name: &str, value: String| {
        let _ = write!(members, ", \"{name}\": {value}");
    };
    if is_bytes {
        add("encoding", "\"base64\"".to_owned()); // [NCP-OBS-012]
    }
    if field.name == "session_id" && field.default == Default::Required {
        add("segment", "true".to_owned()); // [NCP-WIRE-031]
    }
    if let Some(default) = default(field) {
        add("default", default.clone());
        // [NCP-PROV-001] [NCP-PROV-002] [NCP-PROV-003] [NCP-PROV-004]
        if matches!(&*field.name, "calibrated_posterior" | "is_simulation_output") {
            add("pinned", default);
        }
    }
    match (&*message.name, &*field.name) {
        ("CommandFrame", "mode") => add("built", "\"active\"".to_owned()), // [NCP-WIRE-088]
        (_, "contract_hash") => add("built", format!("\"{CONTRACT_HASH}\"")), // [NCP-WIRE-089]
        _ if field.default == Default::Required => add("built", empty(&field.shape)),
        _ => {}
    }
    match &message.kind {
        Some(kind) if field.default == Default::Kind => add("pinned", format!("\"{kind}\"")),
        Some(kind) if kind == "error" && field.optional => add("unset", "\"omit\"".to_owned()), // [NCP-WIRE-102]
        _ => {}
    }
    members
}

/// What an absent field is read as; nothing for one that must be there.
fn default(field: &Field) -> Option<String> {
    match &field.default {
        Default::Value(value) => Some(value.to_string()),
        Default::Absent => Some("null".to_owned()),
        Default::Message => Some(empty(&field.shape)),
        Default::Required | Default::Kind => None,
    }
}

/// The empty value of a type; of a message, all its defaults, sorted by their names.
fn empty(shape: &Shape) -> String {
    match shape {
        Shape::String | Shape::Enum(_) => "\"\"".to_owned(),
        Shape::Boolean => "false".to_owned(),
        Shape::Integer => "0".to_owned(),
        Shape::Number => "0.0".to_owned(),
        Shape::List(_) => "[]".to_owned(),
        Shape::Map(_) => "{}".to_owned(),
        Shape::Message(name) => {
            let fields = tables().message(name).into_iter().flat_map(|message| &message.fields);
            let members = fields.filter_map(|field| Some(format!("\"{}\": {}", field.name, default(field)?)));
            let mut members: Vec<_> = members.collect();
            members.sort();
            format!("{{{}}}", members.join(", "))
        }
    }
}
