//! What calls and steps give, in the members that PROTOCOL.md lists with them.

use std::borrow::Cow;

use serde::Serialize;

use crate::value::{Bytes, Column, Double, Fields, Long};

/// What a peer says about itself.
#[derive(Debug, Serialize)]
pub struct Description<'a> {
    /// Its name.
    pub name: Cow<'a, str>,
    /// The implementation's own version.
    pub version: Cow<'a, str>,
    /// The language that it is written in.
    pub language: Cow<'a, str>,
    /// The wire version, as the implementation states it.
    pub wire_version: Cow<'a, str>,
    /// The contract hash, as the implementation states it.
    pub contract_hash: Cow<'a, str>,
    /// The roles that it claims.
    pub roles: Vec<Cow<'a, str>>,
    /// Whether its server has the reference networks.
    pub reference_networks: bool,
}

/// How a plane is sent.
#[derive(Debug, Serialize)]
#[expect(missing_docs, reason = "PROTOCOL.md describes them")]
pub struct Qos<'a> {
    pub congestion: Cow<'a, str>,
    pub priority: Cow<'a, str>,
    pub express: bool,
}

/// The arrays of an observation.
#[derive(Debug, Serialize)]
#[expect(missing_docs, reason = "PROTOCOL.md describes them")]
pub struct Arrays {
    pub times: Vec<Double>,
    pub values: Vec<Double>,
    pub senders: Vec<Long>,
}

/// What a step gives.
#[derive(Debug, Serialize)]
#[serde(untagged)]
#[expect(missing_docs, reason = "PROTOCOL.md describes them")]
pub enum StepReply {
    Frame {
        frame: Fields,
    },
    Hold {
        hold: bool,
    },
    Active {
        channels: Option<Fields>,
    },
    Link {
        last_seq: i64,
        received: i64,
        lost: i64,
        loss_rate: Double,
        burst: bool,
    },
    Tick {
        command: Fields,
        status: Fields,
    },
    Refused {
        error: Refusal,
    },
    /// Always true: the peer cannot do the step.
    Unsupported {
        unsupported: bool,
    },
    Nothing {},
}

/// Why a step was refused.
#[derive(Debug, Serialize)]
pub struct Refusal {
    pub(crate) code: Cow<'static, str>,
    pub(crate) message: String,
}

/// What a call gives.
#[derive(Debug, Serialize)]
#[serde(untagged)]
pub(crate) enum Reply<'a> {
    Description(Description<'a>),
    Frame { text: String },
    Compatible { compatible: bool },
    Status { status: &'static str },
    Negotiated { contract: &'static str },
    Key { key: String },
    Matches { matches: bool },
    Qos(Qos<'a>),
    Columns { columns: Vec<Column> },
    Block { block: Bytes },
    Arrays(Arrays),
    Steps { steps: Vec<StepReply> },
    Len { len: usize },
    Rates { rates: Fields },
    Command { command: Fields },
    Replies { replies: Vec<String> },
    Nothing {},
}
