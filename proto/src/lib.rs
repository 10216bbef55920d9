//! The NCP contract as data: `ncp.proto`, its JSON projection, and what follows from the two.
//!
//! | module | answers |
//! |---|---|
//! | [`v0`] | the messages as Rust types for the protobuf binary |
//! | [`projection`] | how the messages travel as JSON |
//! | [`generate`] | the projection, written from the proto and the text |
//! | [`contract`] | what the contract says, with proto and projection side by side |
//! | [`schema`] | the JSON Schemas of every kind |
//! | [`compat`] | what of the frozen contract a change would break |
#![cfg_attr(feature = "convert", doc = "| [`convert`] | protobuf binary ↔ JSON model |")]
//!
//! The JSON form is what travels. The protobuf form is for storage and for tools, and nothing on a
//! run-time path depends on this crate. The contract hash is not computed here:
//! `ncp_spec::contract::hash_of` has the canonicaliser.
#![forbid(unsafe_code)]

pub mod compat;
pub mod contract;
#[cfg(feature = "convert")]
pub mod convert;
pub mod generate;
pub mod projection;
pub mod schema;

use std::sync::LazyLock;

/// The messages and enums of package `ncp.v0`, as prost makes them from `ncp.proto`.
#[expect(missing_docs, reason = "a message on one line has no room for its field's comment")]
pub mod v0 {
    include!(concat!(env!("OUT_DIR"), "/ncp.v0.rs"));
}

/// The text of `ncp.proto`; its contract hash is [`ncp_text::CONTRACT_HASH`].
pub const PROTO_TEXT: &str = include_str!("../ncp.proto");

/// The text of `projection.json`: what JSON adds to the proto. It is written anew from its sources, so that what
/// follows from it never lags behind the file.
pub static PROJECTION_TEXT: LazyLock<String> =
    LazyLock::new(|| generate::projection(DESCRIPTOR_SET).unwrap_or_default());

/// The encoded `FileDescriptorSet` of `ncp.proto`, with its comments.
pub const DESCRIPTOR_SET: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/ncp.binpb"));

/// The image of the proto of the frozen wire, as buf 1.75.0 built it; it reads as a `FileDescriptorSet`.
pub const BASELINE_IMAGE: &[u8] = include_bytes!("../baseline/ncp-0.5.binpb");

/// The frozen text of its projection.
pub const BASELINE_PROJECTION: &str = include_str!("../baseline/projection-0.5.json");
