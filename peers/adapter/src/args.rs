//! What each call is given (PROTOCOL.md, sections 3 and 4), in the members that the page lists with it.
//!
//! A message, a codec or a configuration stays the JSON text that it is: an adapter hands it on, or parses it with
//! [`parse`].

use std::borrow::Cow;

use serde::Deserialize;

use crate::error::CallError;
use crate::json::{self, Raw};
use crate::value::{Bytes, Column, Double, Long};

/// A part of a request, in the form in which the adapter wants it.
///
/// # Errors
/// It is of another form than PROTOCOL.md allows.
pub fn parse<'a, T: Deserialize<'a>>(text: Raw<'a>) -> Result<T, CallError> {
    json::read(text.get()).map_err(CallError::misfit)
}

/// The arguments of `decode`.
#[derive(Debug, Deserialize)]
pub struct Decode<'a> {
    /// The kind that is expected.
    #[serde(borrow)]
    pub kind: Cow<'a, str>,
    #[serde(borrow)]
    text: Option<Cow<'a, str>>,
    base64: Option<Bytes>,
    /// Whether the receiver is strict.
    #[serde(default)]
    pub strict: bool,
}

impl Decode<'_> {
    /// The frame as it arrives, which need not be UTF-8.
    ///
    /// # Errors
    /// The arguments hold no frame, or two.
    pub fn frame(&self) -> Result<&[u8], CallError> {
        frame(self.text.as_deref(), self.base64.as_ref())
    }
}

/// The bytes of a frame that is given either as text or as bytes.
pub(crate) fn frame<'f>(text: Option<&'f str>, base64: Option<&'f Bytes>) -> Result<&'f [u8], CallError> {
    match (text, base64) {
        (Some(text), None) => Ok(text.as_bytes()),
        (None, Some(Bytes(bytes))) => Ok(bytes),
        _ => Err(CallError::misfit("a frame is either text or base64")),
    }
}

/// The arguments of `encode`.
#[derive(Debug, Deserialize)]
pub struct Encode<'a> {
    /// The kind of the message.
    #[serde(borrow)]
    pub kind: Cow<'a, str>,
    /// The fields that are set.
    #[serde(borrow)]
    pub fields: Raw<'a>,
}

/// The arguments of `version.check`.
#[derive(Debug, Deserialize)]
pub struct VersionCheck<'a> {
    /// The other side's version.
    #[serde(borrow)]
    pub version: Cow<'a, str>,
    /// Whether a mismatch is an error.
    pub strict: bool,
}

/// The arguments of `contract.status` and `contract.verify`.
#[derive(Debug, Deserialize)]
pub struct Contract<'a> {
    /// The hash that the other side advertises, if it does.
    #[serde(borrow)]
    pub peer_hash: Option<Cow<'a, str>>,
}

/// The arguments of `negotiate`.
#[derive(Debug, Deserialize)]
pub struct Negotiate<'a> {
    /// The other side's version.
    #[serde(borrow)]
    pub version: Cow<'a, str>,
    /// The hash that the other side advertises, if it does.
    #[serde(borrow)]
    pub contract_hash: Option<Cow<'a, str>>,
}

/// The arguments of `key.build`.
#[derive(Debug, Deserialize)]
pub struct KeyBuild<'a> {
    /// Which key.
    pub key: KeyKind,
    /// The realm, if it is not the default one.
    #[serde(borrow)]
    pub realm: Option<Cow<'a, str>>,
    /// The kind of a strict control key.
    #[serde(borrow)]
    pub verb: Option<Cow<'a, str>>,
    /// The session.
    #[serde(borrow)]
    pub session: Option<Cow<'a, str>>,
    /// The name of a sensor or a command stream.
    #[serde(borrow)]
    pub name: Option<Cow<'a, str>>,
}

impl KeyBuild<'_> {
    /// The session of a key that has one.
    ///
    /// # Errors
    /// None is given.
    pub fn session(&self) -> Result<&str, CallError> {
        self.session.as_deref().ok_or_else(|| CallError::misfit("this key is built from a session"))
    }
}

/// The keys that can be built.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
#[expect(missing_docs, reason = "PROTOCOL.md lists them")]
pub enum KeyKind {
    Rpc,
    Sensor,
    Command,
    Observation,
    SensorGlob,
    CommandGlob,
    SessionGlob,
    FleetGlob,
}

impl KeyKind {
    /// Its name in the protocol.
    #[must_use]
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Rpc => "rpc",
            Self::Sensor => "sensor",
            Self::Command => "command",
            Self::Observation => "observation",
            Self::SensorGlob => "sensor_glob",
            Self::CommandGlob => "command_glob",
            Self::SessionGlob => "session_glob",
            Self::FleetGlob => "fleet_glob",
        }
    }
}

/// The arguments of `key.match`.
#[derive(Debug, Deserialize)]
pub struct KeyMatch<'a> {
    /// A key expression.
    #[serde(borrow)]
    pub pattern: Cow<'a, str>,
    /// A key without wildcards.
    #[serde(borrow)]
    pub key: Cow<'a, str>,
}

/// The arguments of `plane.qos`.
#[derive(Debug, Deserialize)]
pub struct PlaneQos<'a> {
    /// The plane's name.
    #[serde(borrow)]
    pub plane: Cow<'a, str>,
}

/// The arguments of `bulk.decode` and `observation.unpack`.
#[derive(Debug, Deserialize)]
pub struct Block {
    /// The block.
    pub block: Bytes,
}

/// The arguments of `bulk.encode`.
#[derive(Debug, Deserialize)]
pub struct Columns {
    /// The columns, in the order of the directory.
    pub columns: Vec<Column>,
}

/// The arguments of `observation.pack`.
#[derive(Debug, Deserialize)]
#[expect(missing_docs, reason = "PROTOCOL.md describes them")]
pub struct Arrays {
    pub times: Vec<Double>,
    pub values: Vec<Double>,
    pub senders: Vec<Long>,
}

/// The arguments of `reply.check`.
#[derive(Debug, Deserialize)]
pub struct ReplyCheck<'a> {
    /// The frame that was sent.
    #[serde(borrow)]
    pub request: Cow<'a, str>,
    /// The frame that came back.
    #[serde(borrow)]
    pub reply: Cow<'a, str>,
    /// Whether the client is strict.
    #[serde(default)]
    pub strict: bool,
}

/// The arguments of `governor.run`.
#[derive(Debug, Deserialize)]
pub struct Governor<'a> {
    /// The fields of the limits.
    #[serde(borrow)]
    pub limits: Raw<'a>,
    #[serde(borrow)]
    capabilities: Option<DeclaredChannels<'a>>,
    /// Read by [`GovernorStep`](crate::steps::GovernorStep).
    #[serde(borrow)]
    pub steps: Vec<Raw<'a>>,
}

#[derive(Debug, Deserialize)]
struct DeclaredChannels<'a> {
    #[serde(borrow)]
    sensor_channels: Raw<'a>,
    #[serde(borrow)]
    command_channels: Raw<'a>,
}

impl Governor<'_> {
    /// The fields of Capabilities, if the governor is not one of the canonical channels.
    #[must_use]
    pub fn capabilities(&self) -> Option<String> {
        let DeclaredChannels { sensor_channels, command_channels } = self.capabilities.as_ref()?;
        let limits = self.limits;
        Some(format!(
            r#"{{"safety":{limits},"sensor_channels":{sensor_channels},"command_channels":{command_channels}}}"#
        ))
    }
}

/// The arguments of `watchdog.run`.
#[derive(Debug, Deserialize)]
pub struct Watchdog<'a> {
    /// Read by [`WatchdogStep`](crate::steps::WatchdogStep).
    #[serde(borrow)]
    pub steps: Vec<Raw<'a>>,
}

/// The arguments of `buffer.run`.
#[derive(Debug, Deserialize)]
pub struct Buffer<'a> {
    /// Whether the plant is strict.
    #[serde(default)]
    pub strict: bool,
    /// Read by [`BufferStep`](crate::steps::BufferStep).
    #[serde(borrow)]
    pub steps: Vec<Raw<'a>>,
}

/// The arguments of `horizon.max_len`.
#[derive(Debug, Deserialize)]
pub struct Horizon {
    /// How long the command holds, in milliseconds.
    pub ttl_ms: Double,
    /// The time between two steps, in milliseconds.
    pub dt_ms: Double,
}

/// The arguments of `link.run`.
#[derive(Debug, Deserialize)]
pub struct Link<'a> {
    /// The reference loss, or the default.
    pub ref_loss: Option<Double>,
    /// The threshold, or the default.
    pub threshold: Option<Double>,
    /// Read by [`LinkStep`](crate::steps::LinkStep).
    #[serde(borrow)]
    pub steps: Vec<Raw<'a>>,
}

/// The arguments of `codec.encode`.
#[derive(Debug, Deserialize)]
pub struct CodecEncode<'a> {
    /// The name of a codec, or its mappings.
    #[serde(borrow)]
    pub codec: Raw<'a>,
    /// The fields of the sensor frame, if there is one.
    #[serde(borrow)]
    pub sensor: Option<Raw<'a>>,
}

/// The arguments of `codec.decode`.
#[derive(Debug, Deserialize)]
#[expect(missing_docs, reason = "PROTOCOL.md describes them")]
pub struct CodecDecode<'a> {
    #[serde(borrow)]
    pub codec: Raw<'a>,
    #[serde(borrow)]
    pub rates: Raw<'a>,
    pub t: Double,
    pub seq: i64,
    #[serde(borrow)]
    pub frame_id: Cow<'a, str>,
    #[serde(borrow)]
    pub mode: Cow<'a, str>,
}

/// The arguments of `reflex.step`.
#[derive(Debug, Deserialize)]
pub struct Reflex<'a> {
    /// The configuration.
    #[serde(borrow)]
    pub config: Raw<'a>,
    /// The fields of the sensor frame, if there is one.
    #[serde(borrow)]
    pub sensor: Option<Raw<'a>>,
}

/// The arguments of `loop.run`.
#[derive(Debug, Deserialize)]
pub struct Loop<'a> {
    /// The period, in milliseconds.
    pub period_ms: Double,
    /// The fields of the limits.
    #[serde(borrow)]
    pub limits: Raw<'a>,
    /// The configuration of the reflex controller.
    #[serde(borrow)]
    pub config: Raw<'a>,
    /// Read by [`LoopStep`](crate::steps::LoopStep).
    #[serde(borrow)]
    pub steps: Vec<Raw<'a>>,
}

/// The arguments of `session.run`.
#[derive(Debug, Deserialize)]
pub struct Session<'a> {
    /// The requests as they arrive.
    #[serde(borrow)]
    pub requests: Vec<Cow<'a, str>>,
    /// Whether the server is strict.
    #[serde(default)]
    pub strict: bool,
    /// At the key of which kind each request comes; without it, each comes at its own.
    #[serde(borrow)]
    pub verbs: Option<Vec<Cow<'a, str>>>,
}
