//! The planted changes of `breaking_changes.toml`, and texts made into contracts.

#![allow(dead_code, reason = "each test program uses its part")]

pub(crate) mod frames;

use ncp_proto::{BASELINE_IMAGE, BASELINE_PROJECTION, PROJECTION_TEXT, PROTO_TEXT, contract::Contract};
use prost::Message as _;
use prost_types::{FileDescriptorProto, FileDescriptorSet};
use protox::file::{File, FileResolver};
use serde::Deserialize;

/// A planted change, and what is to be said of it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Change {
    pub(crate) name: String,
    #[serde(default)]
    before: Vec<Edit>,
    #[serde(default)]
    proto: Vec<Edit>,
    #[serde(default)]
    projection: Vec<Edit>,
    pub(crate) reports: Vec<String>,
    #[serde(default)]
    pub(crate) buf: Buf,
}

/// The rules of buf that a change breaks, by category.
#[derive(Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "UPPERCASE", deny_unknown_fields)]
pub(crate) struct Buf {
    #[serde(default)]
    pub(crate) wire: Vec<String>,
    #[serde(default)]
    pub(crate) wire_json: Vec<String>,
    #[serde(default)]
    pub(crate) file: Vec<String>,
}

/// Replaces the first `replace` that follows `after`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Edit {
    #[serde(default)]
    after: String,
    replace: String,
    with: String,
}

/// All planted changes.
pub(crate) fn changes() -> Vec<Change> {
    #[derive(Deserialize)]
    struct Table {
        change: Vec<Change>,
    }
    toml::from_str::<Table>(include_str!("../breaking_changes.toml")).unwrap().change
}

impl Change {
    /// The proto to hold the change against.
    pub(crate) fn frozen_proto(&self) -> String {
        edit(&frozen_proto(), &self.before)
    }

    /// The changed proto.
    pub(crate) fn changed_proto(&self) -> String {
        edit(&frozen_proto(), &self.proto)
    }

    /// The changed projection.
    pub(crate) fn changed_projection(&self) -> String {
        edit(BASELINE_PROJECTION, &self.projection)
    }

    /// Whether the proto itself is changed, or compared with another.
    pub(crate) fn touches_proto(&self) -> bool {
        !self.proto.is_empty() || !self.before.is_empty()
    }
}

/// The proto as its canonical text, which compiles: a declaration a line, so that edits need no
/// whitespace.
pub(crate) fn plain_proto() -> String {
    format!("syntax = \"proto3\";\npackage ncp.v0;\n{}", ncp_spec::contract::canonical_text(PROTO_TEXT))
}

/// The frozen proto in the same form, from its image.
pub(crate) fn frozen_proto() -> String {
    let set = FileDescriptorSet::decode(BASELINE_IMAGE).unwrap();
    format!("syntax = \"proto3\";\npackage ncp.v0;\n{}", written_out(&set.file[0]))
}

/// A proto's declarations from its descriptor, laid out as the canonical text is: in the order, and
/// on the lines, that the source had.
fn written_out(file: &FileDescriptorProto) -> String {
    let contract =
        Contract::new(&FileDescriptorSet { file: vec![file.clone()] }.encode_to_vec(), &PROJECTION_TEXT).unwrap();
    let mut blocks = Vec::new();
    // Where a declaration stands: its line, and whether it ends on it (a span of three numbers).
    let span = |path: [i32; 2]| {
        let span = &file
            .source_code_info
            .as_ref()
            .unwrap()
            .location
            .iter()
            .find(|location| location.path == path)
            .unwrap()
            .span;
        (span[0], span.len() == 3)
    };
    for (index, message) in (0..).zip(&contract.messages) {
        let (line, one_line) = span([4, index]);
        let fields: Vec<_> =
            message.fields.iter().map(|field| format!("{} {} = {};", field.ty, field.name, field.number)).collect();
        let separator = if one_line { " " } else { "\n" };
        blocks.push((
            line,
            [&[format!("message {} {{", message.name)], &fields[..], &["}".to_owned()]].concat().join(separator),
        ));
    }
    for (index, item) in (0..).zip(&contract.enums) {
        let values: Vec<_> = item.values.iter().map(|value| format!("{} = {};", value.name, value.number)).collect();
        blocks.push((span([5, index]).0, format!("enum {} {{\n{}\n}}", item.name, values.join("\n"))));
    }
    for (index, service) in (0..).zip(&contract.services) {
        let rpcs: Vec<_> = service.rpcs.iter().map(|rpc| format!("rpc {}{};", rpc.name, rpc.signature())).collect();
        blocks.push((span([6, index]).0, format!("service {} {{\n{}\n}}", service.name, rpcs.join("\n"))));
    }
    blocks.sort();
    blocks.into_iter().map(|(_, block)| block).collect::<Vec<_>>().join("\n")
}

/// The contract of a proto's and a projection's text.
pub(crate) fn contract(proto: &str, projection: &str) -> Contract {
    let mut compiler = protox::Compiler::with_file_resolver(Text(proto.to_owned()));
    compiler.open_file("ncp.proto").unwrap_or_else(|error| panic!("{error}\n{proto}"));
    Contract::new(&compiler.encode_file_descriptor_set(), projection).unwrap()
}

struct Text(String);

impl FileResolver for Text {
    fn open_file(&self, name: &str) -> Result<File, protox::Error> {
        File::from_source(name, &self.0)
    }
}

fn edit(text: &str, edits: &[Edit]) -> String {
    edits.iter().fold(text.to_owned(), |text, Edit { after, replace, with }| {
        let start = text.find(after).unwrap_or_else(|| panic!("no {after:?} to edit after"));
        let at = text[start..].find(replace).unwrap_or_else(|| panic!("no {replace:?} after {after:?}"));
        let (head, tail) = text.split_at(start + at);
        format!("{head}{with}{}", &tail[replace.len()..])
    })
}
