//! The planted changes of `breaking_changes.toml`, and texts made into contracts.

#![allow(dead_code, reason = "each test program uses its part")]

pub(crate) mod frames;

use ncp_proto::{PROJECTION_TEXT, PROTO_TEXT, contract::Contract};
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
        edit(&plain_proto(), &self.before)
    }

    /// The changed proto.
    pub(crate) fn changed_proto(&self) -> String {
        edit(&plain_proto(), &self.proto)
    }

    /// The changed projection.
    pub(crate) fn changed_projection(&self) -> String {
        edit(PROJECTION_TEXT, &self.projection)
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
