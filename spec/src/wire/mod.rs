//! Messages on the wire: strict decoding, encoding (chapters 1 and 6).
//!
//! A frame is one JSON object. [`decode`] reads one of the kind that is expected, [`decode_any`] one
//! of any kind; a [`Frame`] type decodes and encodes itself. There is no other way to a decoded
//! message, so the checks of [`decode`] hold of each: grammar, types, limits, required fields, the
//! kind, and the epistemic pins. `// [NCP-PROV-006]`
//!
//! ```
//! use ncp_spec::{ErrorCode, WIRE_VERSION};
//! use ncp_spec::wire::{Kind, Message, decode, decode_any};
//!
//! let frame = br#"{"kind":"session_closed","session_id":"uav3","mood":"good"}"#;
//! let Message::SessionClosed(closed) = decode_any(frame)? else { unreachable!() };
//! assert_eq!(closed.session_id, "uav3");
//! assert_eq!(
//!     Message::from(closed).encode().unwrap(),
//!     format!(r#"{{"ncp_version":"{WIRE_VERSION}","kind":"session_closed","session_id":"uav3","ok":true}}"#)
//! );
//!
//! let error = decode(Kind::SessionOpened, frame).unwrap_err();
//! assert_eq!(error.code(), ErrorCode::Kind);
//! # Ok::<(), ncp_spec::wire::DecodeError>(())
//! ```

mod enums;
mod error;
mod json;
mod limits;
mod map;
mod messages;
mod record;
mod table;
mod text;
mod value;

use std::fmt;

pub use enums::{ChannelKind, EntityRole, Mode, NetworkRefKind, Observable, Role, SimMode, StimulusKind, UnknownName};
pub use error::{DecodeError, DecodeProblem, EncodeError, EncodeProblem, Rule};
pub use limits::{MAX_ENTRIES, MAX_FRAME_BYTES, MAX_INTEGER, MAX_ITEMS, MAX_LEVELS, MAX_OBSERVATION_BYTES};
pub use map::SortedMap;
pub use messages::{
    BulkObservation, Capabilities, ChannelMap, ChannelSpec, ChannelValue, CloseSession, CommandFrame, ControlStatus,
    EntityBinding, EntityRef, ErrorFrame, LinkStatus, NetworkRef, Observation, ObservationFrame, OpenSession,
    RecordSpec, RecordTarget, RunRequest, SafetyLimits, SensorFrame, SessionClosed, SessionOpened, SimConfig,
    SimProvenance, StepRequest, StimulusFrame, StimulusSpec, StimulusTarget,
};
pub use table::{Field, JsonType, Table};
pub use text::Text;

use json::{Purpose, Reader, Writer};

/// Decodes a frame of the kind that the receiver expects: every field as the frame gives it.
/// `[NCP-WIRE-034]`
///
/// # Errors
///
/// [`DecodeError`] when the frame is rejected: it breaks a rule of chapter 1 or 6, or is of another
/// kind (`NCP-WIRE-030`).
pub fn decode(kind: Kind, frame: &[u8]) -> Result<Message, DecodeError> {
    kind.decode(frame)
}

/// Decodes a frame of any kind.
///
/// # Errors
///
/// [`DecodeError`] when the frame is rejected: it breaks a rule of chapter 1 or 6.
pub fn decode_any(frame: &[u8]) -> Result<Message, DecodeError> {
    kind_of(frame)?.decode(frame)
}

/// [`decode`] by the strict profile (chapter 12.1): the frame has a compatible `ncp_version`, and a
/// command frame a `seq` of at least 1. `[NCP-STRICT-002] [NCP-STRICT-003] [NCP-STRICT-004]`
///
/// ```
/// use ncp_spec::wire::{Kind, decode, decode_strict};
///
/// let frame = br#"{"kind":"sensor_frame","seq":1}"#;
/// assert!(decode(Kind::SensorFrame, frame).is_ok());
/// let error = decode_strict(Kind::SensorFrame, frame).unwrap_err();
/// assert_eq!(error.to_string(), "ncp_version: the member is required (byte 31)");
/// ```
///
/// # Errors
///
/// As [`decode`], and when the profile rejects the frame.
pub fn decode_strict(kind: Kind, frame: &[u8]) -> Result<Message, DecodeError> {
    kind.decode_strict(frame)
}

/// [`decode_any`] by the strict profile, as [`decode_strict`].
///
/// # Errors
///
/// As [`decode_any`], and when the profile rejects the frame.
pub fn decode_any_strict(frame: &[u8]) -> Result<Message, DecodeError> {
    kind_of(frame)?.decode_strict(frame)
}

/// Builds a message as a program would: `fields` is a JSON object of the fields that it sets, named
/// and nested as on the wire, without `kind`. Every other field is as [`Default`] makes it.
///
/// This is for adapters and tests, which get their fields as JSON; a program writes a struct. A
/// number may be spelled `"NaN"`, `"Infinity"`, `"-Infinity"` or `"-0"`. What is built is not
/// checked: encoding checks it.
///
/// # Errors
///
/// [`DecodeError`] when `fields` is not such an object, or names a field that the message lacks, and
/// for an error frame without its `error`.
pub fn build(kind: Kind, fields: &[u8]) -> Result<Message, DecodeError> {
    kind.build(fields)
}

/// A message that is a frame of its own.
pub trait Frame: Sized {
    /// Its kind.
    const KIND: Kind;

    /// Decodes a frame of this kind.
    ///
    /// # Errors
    ///
    /// [`DecodeError`] when the frame is rejected.
    fn decode(frame: &[u8]) -> Result<Self, DecodeError>;

    /// Decodes a frame of this kind by the strict profile; see [`decode_strict`].
    ///
    /// # Errors
    ///
    /// [`DecodeError`] when the frame is rejected.
    fn decode_strict(frame: &[u8]) -> Result<Self, DecodeError>;

    /// Writes the frame: fields in order, maps sorted, unset optionals as `null`.
    ///
    /// # Errors
    ///
    /// [`EncodeError`] for a number that JSON lacks (`NCP-WIRE-086`), a pin that does not hold
    /// (`NCP-PROV-008`), and for what every receiver would reject (`NCP-WIRE-091`).
    fn encode(&self) -> Result<String, EncodeError>;
}

/// A message as the fields that a program sets and sees.
trait Fields: Sized {
    /// See [`build`].
    fn build(fields: &[u8]) -> Result<Self, DecodeError>;

    /// See [`Message::fields`].
    fn show(&self, w: &mut Writer) -> Result<(), EncodeError>;
}

/// Declares the kinds by their wire strings, in the contract's order.
macro_rules! kinds {
    ($($(#[$meta:meta])* $kind:ident($message:ident) = $wire:literal,)*) => {
        /// The name of a message type on the wire.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Kind {
            $($(#[$meta])* $kind,)*
        }

        /// A frame of any kind.
        #[derive(Debug, Clone, PartialEq)]
        pub enum Message {
            $($(#[$meta])* $kind($message),)*
        }

        impl Kind {
            /// All kinds: the 14 messages in the contract's order, then the error frame.
            pub const ALL: [Self; 15] = [$(Self::$kind),*];

            /// The wire string.
            #[must_use]
            pub const fn as_str(self) -> &'static str {
                match self {
                    $(Self::$kind => $wire,)*
                }
            }

            /// The kind of a wire string.
            #[must_use]
            pub fn parse(wire: &str) -> Option<Self> {
                match wire {
                    $($wire => Some(Self::$kind),)*
                    _ => None,
                }
            }

            /// The table of its message.
            #[must_use]
            pub const fn table(self) -> Table {
                match self {
                    $(Self::$kind => $message::TABLE,)*
                }
            }

            fn decode(self, frame: &[u8]) -> Result<Message, DecodeError> {
                match self {
                    $(Self::$kind => $message::decode(frame).map(Message::$kind),)*
                }
            }

            fn decode_strict(self, frame: &[u8]) -> Result<Message, DecodeError> {
                match self {
                    $(Self::$kind => $message::decode_strict(frame).map(Message::$kind),)*
                }
            }

            fn build(self, fields: &[u8]) -> Result<Message, DecodeError> {
                match self {
                    $(Self::$kind => $message::build(fields).map(Message::$kind),)*
                }
            }
        }

        impl Message {
            /// The kind.
            #[must_use]
            pub const fn kind(&self) -> Kind {
                match self {
                    $(Self::$kind(_) => Kind::$kind,)*
                }
            }

            /// Writes the frame; see [`Frame::encode`].
            ///
            /// # Errors
            ///
            /// As [`Frame::encode`].
            pub fn encode(&self) -> Result<String, EncodeError> {
                match self {
                    $(Self::$kind(message) => message.encode(),)*
                }
            }

            /// Every field of the message as a JSON object, whatever it holds: the opposite of
            /// [`build`].
            ///
            /// This is for adapters and tests, which show what a program holds and may not send:
            /// no rule is checked, and a number that JSON lacks is spelled `"NaN"`, `"Infinity"` or
            /// `"-Infinity"`.
            #[must_use]
            pub fn fields(&self) -> String {
                let mut w = Writer::showing();
                let shown = match self {
                    $(Self::$kind(message) => message.show(&mut w),)*
                };
                debug_assert!(shown.is_ok(), "such a writer refuses nothing");
                w.into_text()
            }
        }

        $(impl From<$message> for Message {
            fn from(message: $message) -> Self {
                Self::$kind(message)
            }
        })*
    };
}

kinds! {
    /// Control RPC: open a session.
    OpenSession(OpenSession) = "open_session",
    /// The reply to an open session.
    SessionOpened(SessionOpened) = "session_opened",
    /// Values for the stimulus ports.
    StimulusFrame(StimulusFrame) = "stimulus_frame",
    /// Control RPC: advance a session.
    StepRequest(StepRequest) = "step_request",
    /// Control RPC: run a session.
    RunRequest(RunRequest) = "run_request",
    /// Observations, asked for or published.
    ObservationFrame(ObservationFrame) = "observation_frame",
    /// One port's observations as a BulkBlock.
    BulkObservation(BulkObservation) = "bulk_observation",
    /// Control RPC: close a session.
    CloseSession(CloseSession) = "close_session",
    /// The reply to a close session.
    SessionClosed(SessionClosed) = "session_closed",
    /// What a controller or a plant offers.
    Capabilities(Capabilities) = "capabilities",
    /// What the body senses.
    SensorFrame(SensorFrame) = "sensor_frame",
    /// What the body is to do.
    CommandFrame(CommandFrame) = "command_frame",
    /// How the control loop is doing.
    ControlStatus(ControlStatus) = "control_status",
    /// How a stream arrives.
    LinkStatus(LinkStatus) = "link_status",
    /// The RPC error frame.
    Error(ErrorFrame) = "error",
}

impl Kind {
    /// Whether a frame of this kind is a request of the control plane.
    #[must_use]
    pub const fn is_request(self) -> bool {
        matches!(self, Self::OpenSession | Self::StepRequest | Self::RunRequest | Self::CloseSession)
    }

    /// The most bytes that a frame of this kind may have.
    #[must_use]
    pub const fn max_bytes(self) -> usize {
        match self {
            Self::ObservationFrame => MAX_OBSERVATION_BYTES,
            _ => MAX_FRAME_BYTES,
        }
    }

    /// `// [NCP-WIRE-060] [NCP-WIRE-061] [NCP-WIRE-062] [NCP-WIRE-063]`
    fn check_len(self, len: usize) -> Result<(), DecodeError> {
        let limit = self.max_bytes();
        if len > limit {
            return Err(DecodeError::new(DecodeProblem::TooLong { len, limit }, limit));
        }
        Ok(())
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

/// The tables of the messages that stand inside others.
pub const NESTED: [Table; 13] = [
    ChannelValue::TABLE,
    EntityRef::TABLE,
    EntityBinding::TABLE,
    NetworkRef::TABLE,
    RecordTarget::TABLE,
    RecordSpec::TABLE,
    StimulusTarget::TABLE,
    StimulusSpec::TABLE,
    SimConfig::TABLE,
    SimProvenance::TABLE,
    Observation::TABLE,
    ChannelSpec::TABLE,
    SafetyLimits::TABLE,
];

/// The kind that a frame says it is; the rest is not judged, but where it stands in the way.
fn kind_of(frame: &[u8]) -> Result<Kind, DecodeError> {
    // No kind may be longer.
    Kind::ObservationFrame.check_len(frame.len())?;
    let mut r = Reader::new(frame, Purpose::Receive)?;
    r.begin()?;
    let mut more = r.open_object(JsonType::Object("frame"))?;
    while more {
        if r.name()? == "kind" {
            let at = r.at();
            let name = r.string().map_err(|e| e.inside("kind"))?;
            return Kind::parse(&name)
                .ok_or_else(|| DecodeError::new(DecodeProblem::kind_unknown(&name), at).inside("kind"));
        }
        r.skip_value()?;
        more = r.next_member()?;
    }
    Err(r.error(DecodeProblem::KindMissing).inside("kind")) // [NCP-WIRE-028]
}
