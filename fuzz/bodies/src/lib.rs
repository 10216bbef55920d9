//! What each fuzz target checks, as plain functions over bytes.
//!
//! A target reports by panicking, like a test. It needs no fuzzer: [`Target::run`] takes the bytes of
//! a file, so that a corpus or a crash can be replayed anywhere. The wrappers for libFuzzer are in
//! `fuzz/fuzz_targets`, one line each.
//!
//! | module | targets | against what it checks |
//! |---|---|---|
//! | [`frame`] | `frame_decode`, `frame_roundtrip` | serde_json, and the message itself |
//! | [`bulk`] | `bulk_decode`, `bulk_roundtrip`, `bulk_memory` | a slow decoder of its own, a counting allocator |
//! | [`schema`] | `validate_vs_schema` | the schemas, by the crate jsonschema |
//! | [`proto`] | `proto_vs_json` | the protobuf form |
//! | [`keys`] | `keys` | zenoh-keyexpr |
//! | [`version`] | `version` | a guard that compares decimal texts |
//! | [`canonical`] | `canonical_proto` | a second canonicaliser, and edits that must not count |
//! | [`governor`] | `governor_trace` | the invariants of chapter 7 |
//! | [`action_buffer`] | `action_buffer_trace` | a small model of chapter 8.2 |
//! | [`link_monitor`] | `link_monitor_trace` | an exact model of chapter 8.3 |
//! | [`codec`] | `codec` | the formulas of chapter 9 |
//! | [`session`] | `session` | a model of who is open, and the client's own check |
//! | [`peer`] | `peer_protocol` | serde_json |
//!
//! What they share:
//!
//! | module | what it holds |
//! |---|---|
//! | `edges` | frames at the edges of what may be read and written |
//! | [`memory`] | counts what is allocated |
//! | `message` | what a program does with a message that it holds |
//! | [`plain`] | structured inputs that can be written as well as read |
//! | [`seeds`] | the first inputs of every target, made of the golden vectors |

#![forbid(unsafe_code)]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a target reports by panicking")]

pub mod action_buffer;
pub mod bulk;
pub mod canonical;
pub mod codec;
mod edges;
pub mod frame;
pub mod governor;
pub mod keys;
pub mod link_monitor;
pub mod memory;
mod message;
pub mod peer;
pub mod plain;
pub mod proto;
pub mod schema;
pub mod seeds;
pub mod session;
pub mod version;

/// A fuzz target.
#[derive(Clone, Copy)]
pub struct Target {
    /// Its name: that of its function, of its wrapper and of its corpus.
    pub name: &'static str,
    /// What it would find.
    pub finds: &'static str,
    /// Checks one input, and panics when something is wrong.
    pub run: fn(&[u8]),
    /// The input as a person reads it.
    pub show: fn(&[u8]) -> String,
}

/// All targets.
pub const TARGETS: &[Target] = &[
    Target {
        name: "frame_decode",
        finds: "a frame that makes a decoder panic, that is read though it is no JSON, or past a pin",
        run: frame::frame_decode,
        show: frame::show,
    },
    Target {
        name: "frame_roundtrip",
        finds: "a field that is read as another value, or changes when it is written",
        run: frame::frame_roundtrip,
        show: frame::show,
    },
    Target {
        name: "bulk_decode",
        finds: "a block that is judged or read otherwise than byte by byte",
        run: bulk::bulk_decode,
        show: bulk::show_block,
    },
    Target {
        name: "bulk_roundtrip",
        finds: "columns that change on their way through a block",
        run: bulk::bulk_roundtrip,
        show: plain::show::<bulk::Columns>,
    },
    Target {
        name: "bulk_memory",
        finds: "a block that makes its reader allocate more than it is long",
        run: bulk::bulk_memory,
        show: bulk::show_block,
    },
    Target {
        name: "validate_vs_schema",
        finds: "a frame on which schema and decoder disagree for no stated reason",
        run: schema::validate_vs_schema,
        show: frame::show,
    },
    Target {
        name: "proto_vs_json",
        finds: "a message that changes on its way through protobuf",
        run: proto::proto_vs_json,
        show: proto::show,
    },
    Target {
        name: "keys",
        finds: "a key that matches otherwise than in Zenoh, or a segment that breaks its key",
        run: keys::keys,
        show: keys::show,
    },
    Target {
        name: "version",
        finds: "a version that is judged otherwise than by its digits",
        run: version::version,
        show: plain::show_text,
    },
    Target {
        name: "canonical_proto",
        finds: "a proto text whose hash depends on comments or layout, or misses a change",
        run: canonical::canonical_proto,
        show: plain::show_text,
    },
    Target {
        name: "governor_trace",
        finds: "a trace after which the governor lets something pass that could hurt",
        run: governor::governor_trace,
        show: plain::show::<governor::Trace>,
    },
    Target {
        name: "action_buffer_trace",
        finds: "a trace after which a plant moves, or holds, when it must not",
        run: action_buffer::action_buffer_trace,
        show: plain::show::<action_buffer::Trace>,
    },
    Target {
        name: "link_monitor_trace",
        finds: "arrivals that are counted wrongly, overflow, or hide a burst",
        run: link_monitor::link_monitor_trace,
        show: plain::show::<link_monitor::Trace>,
    },
    Target {
        name: "codec",
        finds: "a rate or a component outside its range, off its line, or extreme for want of input",
        run: codec::codec,
        show: plain::show::<codec::Run>,
    },
    Target {
        name: "session",
        finds: "requests that a server answers not at all, wrongly, or with a panic",
        run: session::session,
        show: session::show,
    },
    Target {
        name: "peer_protocol",
        finds: "a line of a peer that the verifier misreads",
        run: peer::peer_protocol,
        show: plain::show_text,
    },
];

/// The target of this name.
#[must_use]
pub fn target(name: &str) -> Option<Target> {
    TARGETS.iter().copied().find(|target| target.name == name)
}
