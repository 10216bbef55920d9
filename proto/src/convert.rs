//! Protobuf binary ↔ the messages of `ncp-spec`.
//!
//! JSON is what travels; this is for storing frames, and for tools that speak protobuf.
//! [`to_binary`] and [`from_binary`] work on whole frames, [`Convert`] on the prost types.
//!
//! # What crosses, and what does not
//!
//! Every field is carried as its value. The defaults of JSON play no part: a `frame_id` of `world`
//! is written as `world`, and an empty one is read as empty. So a program that writes protobuf by
//! hand must set every field; one that leaves `is_simulation_output` out has said `false`, and its
//! frame is rejected.
//!
//! proto3 has no `null`. An unset optional field is written as the empty value of its type and the
//! empty value is read as unset, so an optional field that is *set* to its empty value cannot
//! cross. That and two more are a [`Loss`], which [`to_binary`] refuses and [`Convert::to_proto`]
//! lists:
//!
//! | in the message | in protobuf | read back as |
//! |---|---|---|
//! | an optional string that is set to `""` | `""` | unset |
//! | an optional number that is set to 0 (a seed, a limit, a duration) | 0 | unset |
//! | −0.0 in a field or in a map (in an array it crosses) | nothing: prost leaves zeros out | 0.0 |
//! | an unknown string of a descriptive enum | the zero constant | an error |
//!
//! The other way, [`Convert::from_proto`] gives only messages that a sender may send. What protobuf
//! can hold and a frame cannot is a [`FromProtoError`]: the wrong `kind`, a number of an enum that
//! has no wire string (but see below), a missing `network`, a non-finite double, an integer beyond
//! ±(2^53 − 1), a pin that does not hold, an invalid session id, anything over a limit. Of the
//! rest, this is normalised:
//!
//! | in protobuf | in the message |
//! |---|---|
//! | a `Mode` that is unset or not known | `hold` [NCP-WIRE-041] |
//! | an absent `record`, `stimulus` spec, `sim`, `safety` or `entity` | the message of all defaults [NCP-WIRE-023] |
//! | an empty `kind`, `ncp_version` or `session_id` of a stimulus inside a request | the request's [NCP-WIRE-035] |
//! | unknown fields | nothing [NCP-WIRE-026] |
//!
//! A message without a loss comes back as it was, bit for bit, and so does a protobuf message that
//! needs no normalising. The RPC error frame has no message in the proto and does not cross.
//!
//! ```
//! use ncp_proto::convert::{from_binary, to_binary};
//! use ncp_spec::wire::{Kind, decode};
//!
//! let frame = br#"{"kind":"sensor_frame","seq":7,"channels":{"height":{"data":[1.5],"unit":"m"}}}"#;
//! let message = decode(Kind::SensorFrame, frame)?;
//! let binary = to_binary(&message)?;
//! assert_eq!(from_binary(Kind::SensorFrame, &binary)?, message);
//!
//! let unit_set_to_nothing = br#"{"kind":"sensor_frame","channels":{"height":{"data":[1.5],"unit":""}}}"#;
//! let error = to_binary(&decode(Kind::SensorFrame, unit_set_to_nothing)?).unwrap_err();
//! let told = "protobuf cannot carry: channels.height.unit is set to \"\", which reads back as unset";
//! assert_eq!(error.to_string(), told);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod fields;
mod messages;

use std::fmt;

use ncp_spec::wire::{EncodeError, Frame, Kind, Message};
use thiserror::Error;

/// Encodes a frame as protobuf, if protobuf can carry all of it.
///
/// The message is not judged: [`from_binary`] does that.
///
/// # Errors
/// [`ToProtoError::Lossy`] with everything that would be lost, or [`ToProtoError::ErrorFrame`].
pub fn to_binary(message: &Message) -> Result<Vec<u8>, ToProtoError> {
    messages::to_binary(message)
}

/// Decodes a frame of a kind from protobuf.
///
/// # Errors
/// When the bytes are not the protobuf form of that kind, or hold what no frame may.
pub fn from_binary(kind: Kind, bytes: &[u8]) -> Result<Message, FromProtoError> {
    messages::from_binary(kind, bytes)
}

/// A frame that has a message in the proto: all kinds but the error frame.
pub trait Convert: Frame {
    /// Its prost type.
    type Proto: prost::Message + Default + PartialEq;

    /// The protobuf form, and what of the frame it does not carry.
    fn to_proto(&self) -> (Self::Proto, Vec<Loss>);

    /// The frame of a protobuf form: one that can be sent.
    ///
    /// # Errors
    /// When the protobuf form holds what no frame may.
    fn from_proto(proto: Self::Proto) -> Result<Self, FromProtoError>;
}

/// Something that protobuf does not carry, and where it stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Loss {
    /// The field, as a program would write it: `channels.height.unit`.
    pub path: String,
    /// What is lost.
    pub what: Lost,
}

/// What protobuf does not carry.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Lost {
    /// An optional string is set, and empty.
    EmptyString,
    /// An optional number is set, and zero.
    Zero,
    /// A zero has a sign.
    ZeroSign,
    /// An enum has a wire string that this build does not know.
    UnknownString(String),
}

/// Why a message has no protobuf form.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum ToProtoError {
    /// It holds what protobuf cannot carry. Never empty.
    #[error("protobuf cannot carry: {}", .0.iter().map(Loss::to_string).collect::<Vec<_>>().join("; "))]
    Lossy(Vec<Loss>),
    /// The RPC error frame is no message of the proto.
    #[error("the RPC error frame has no protobuf form")]
    ErrorFrame,
}

/// Why a protobuf form is no frame.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum FromProtoError {
    /// The bytes are not protobuf, or not of this message.
    #[error("not the protobuf form of {kind}: {source}")]
    Binary {
        /// The kind that was expected.
        kind: Kind,
        /// What prost says.
        source: prost::DecodeError,
    },
    /// The field `kind` says otherwise. [NCP-WIRE-028] [NCP-WIRE-030]
    #[error("{path}: expected {expected:?}, found {found:?}")]
    Kind {
        /// The field.
        path: String,
        /// The kind that was expected.
        expected: &'static str,
        /// What it says.
        found: String,
    },
    /// A required message is absent. [NCP-WIRE-027]
    #[error("{path} is required")]
    Missing {
        /// The field.
        path: String,
    },
    /// A number that stands for no wire string of its enum. [NCP-WIRE-044] [NCP-WIRE-045]
    #[error("{path}: {number} stands for no wire string of {of}")]
    EnumNumber {
        /// The field.
        path: String,
        /// The number.
        number: i32,
        /// The enum.
        of: &'static str,
    },
    /// It could not be sent: every receiver would reject it. [NCP-WIRE-091]
    #[error(transparent)]
    Unsendable(#[from] EncodeError),
    /// The RPC error frame is no message of the proto.
    #[error("the RPC error frame has no protobuf form")]
    ErrorFrame,
}

impl fmt::Display for Loss {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { path, what } = self;
        match what {
            Lost::EmptyString => write!(f, "{path} is set to \"\", which reads back as unset"),
            Lost::Zero => write!(f, "{path} is set to 0, which reads back as unset"),
            Lost::ZeroSign => write!(f, "{path} is -0.0, which reads back as 0.0"),
            Lost::UnknownString(string) => {
                write!(f, "{path} is {string:?}, for which there is no number")
            }
        }
    }
}
