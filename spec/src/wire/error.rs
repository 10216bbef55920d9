//! Why a frame is rejected, and why a message is not written. `[NCP-WIRE-020] [NCP-WIRE-086]`

use std::fmt;

use thiserror::Error;

use super::Kind;
use super::limits::{MAX_ENTRIES, MAX_INTEGER, MAX_ITEMS, MAX_LEVELS};
use super::table::JsonType;
use crate::ErrorCode;
use crate::keys::SegmentProblem;

/// How many characters of what was read an error shows at most.
const SHOWN: usize = 64;

/// Why a frame is rejected: what is wrong, in which field, at which byte.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DecodeError(Box<Details>);

#[derive(Debug, Clone, PartialEq, Eq)]
struct Details {
    problem: DecodeProblem,
    path: Path,
    offset: Option<usize>,
}

impl DecodeError {
    /// What is wrong.
    #[must_use]
    pub const fn problem(&self) -> &DecodeProblem {
        &self.0.problem
    }

    /// The field that it concerns, such as `channels.pose_position.data[2]`; empty for the frame.
    #[must_use]
    pub fn path(&self) -> &str {
        &self.0.path.0
    }

    /// The byte of the frame at which it was noticed, if it was at one.
    #[must_use]
    pub const fn offset(&self) -> Option<usize> {
        self.0.offset
    }

    /// The reason in one word.
    #[must_use]
    pub const fn code(&self) -> ErrorCode {
        self.0.problem.code()
    }

    #[cold]
    pub(crate) fn new(problem: DecodeProblem, offset: usize) -> Self {
        Self(Box::new(Details { problem, path: Path::default(), offset: Some(offset) }))
    }

    /// The same error, seen from the object that has `name` as a member.
    #[cold]
    pub(crate) fn inside(mut self, name: &str) -> Self {
        self.0.path.prepend_member(name);
        self
    }

    /// The same error, seen from the array.
    #[cold]
    pub(crate) fn inside_item(mut self, nth: usize) -> Self {
        self.0.path.prepend_item(nth);
        self
    }
}

impl From<Breach> for DecodeError {
    #[cold]
    fn from(breach: Breach) -> Self {
        let path = Path(breach.field.to_owned());
        Self(Box::new(Details { problem: breach.rule.into(), path, offset: None }))
    }
}

impl fmt::Display for DecodeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Details { problem, path, offset } = &*self.0;
        if !path.0.is_empty() {
            write!(f, "{}: ", path.0)?;
        }
        write!(f, "{problem}")?;
        match offset {
            Some(offset) => write!(f, " (byte {offset})"),
            None => Ok(()),
        }
    }
}

impl std::error::Error for DecodeError {}

/// What is wrong with a frame.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum DecodeProblem {
    /// The frame is longer than its kind may be (`NCP-WIRE-060`, `NCP-WIRE-062`).
    #[error("a frame of {len} bytes is over the limit of {limit}")]
    TooLong {
        /// Bytes of the frame.
        len: usize,
        /// Bytes that it may have.
        limit: usize,
    },
    /// `NCP-WIRE-001`.
    #[error("the frame is not UTF-8")]
    NotUtf8,
    /// `NCP-WIRE-006`.
    #[error("the frame begins with a byte order mark")]
    ByteOrderMark,
    /// `NCP-WIRE-002`; what the grammar wants instead.
    #[error("not JSON: expected {0}")]
    Syntax(&'static str),
    /// `NCP-WIRE-003`.
    #[error("a frame is an object")]
    NotAnObject,
    /// `NCP-WIRE-004`.
    #[error("something follows the frame")]
    Trailing,
    /// `NCP-WIRE-007`.
    #[error("the member occurs twice")]
    Repeated,
    /// `NCP-WIRE-008`.
    #[error("an escaped surrogate lacks its partner")]
    LoneSurrogate,
    /// `NCP-WIRE-013`.
    #[error("the number is beyond the largest double")]
    NumberTooLarge,
    /// More than [`MAX_LEVELS`] levels (`NCP-WIRE-064`).
    #[error("more than {MAX_LEVELS} levels of nesting")]
    TooDeep,
    /// More than [`MAX_ENTRIES`] entries of a map (`NCP-WIRE-066`).
    #[error("more than {MAX_ENTRIES} entries")]
    TooManyEntries,
    /// More than [`MAX_ITEMS`] items of an array that is not numeric (`NCP-WIRE-067`).
    #[error("more than {MAX_ITEMS} items")]
    TooManyItems,
    /// `NCP-WIRE-020`.
    #[error("expected {}, found {}", .expected.in_words(), .found.in_words())]
    WrongType {
        /// The type of the tables.
        expected: JsonType,
        /// The type found, as far as its first byte tells.
        found: JsonType,
    },
    /// `NCP-WIRE-021`.
    #[error("expected {}, found null", .expected.in_words())]
    Null {
        /// The type of the tables.
        expected: JsonType,
    },
    /// `NCP-WIRE-010`.
    #[error("an integer is spelled without fraction, exponent and negative zero")]
    IntegerSpelling,
    /// `NCP-WIRE-011`.
    #[error("an integer is within ±{MAX_INTEGER}")]
    IntegerRange,
    /// `NCP-WIRE-028`.
    #[error("the member is missing")]
    KindMissing,
    /// `NCP-WIRE-029`.
    #[error("{0:?} is not a kind")]
    KindUnknown(String),
    /// `NCP-WIRE-030`.
    #[error("expected {expected}, found {found}")]
    KindOther {
        /// The kind that the receiver expects.
        expected: Kind,
        /// The kind of the frame.
        found: Kind,
    },
    /// `NCP-WIRE-027`.
    #[error("the member is required")]
    Missing,
    /// `NCP-WIRE-044`.
    #[error("{0:?} is not a SimMode")]
    UnknownSimMode(String),
    /// The string is not base64 by RFC 4648 section 4, padded (`NCP-OBS-012`).
    #[error("the string is not base64")]
    NotBase64,
    /// The message breaks a rule that its types do not express.
    #[error(transparent)]
    Rule(#[from] Rule),
    /// A program names a field that the message does not have; no frame gives this error.
    #[error("the message has no such field")]
    NoSuchField,
}

impl DecodeProblem {
    /// The reason in one word.
    #[must_use]
    pub const fn code(&self) -> ErrorCode {
        match self {
            Self::NotUtf8
            | Self::ByteOrderMark
            | Self::Syntax(_)
            | Self::NotAnObject
            | Self::Trailing
            | Self::Repeated
            | Self::LoneSurrogate
            | Self::NumberTooLarge => ErrorCode::Malformed,
            Self::TooLong { .. } | Self::TooDeep | Self::TooManyEntries | Self::TooManyItems => ErrorCode::Limit,
            Self::WrongType { .. } | Self::Null { .. } | Self::IntegerSpelling => ErrorCode::Type,
            Self::KindMissing | Self::KindUnknown(_) | Self::KindOther { .. } => ErrorCode::Kind,
            Self::Missing => ErrorCode::Missing,
            Self::IntegerRange | Self::UnknownSimMode(_) | Self::NotBase64 => ErrorCode::Value,
            Self::Rule(rule) => rule.code(),
            Self::NoSuchField => ErrorCode::Invalid,
        }
    }

    pub(crate) fn kind_unknown(found: &str) -> Self {
        Self::KindUnknown(shown(found))
    }

    pub(crate) fn unknown_sim_mode(found: &str) -> Self {
        Self::UnknownSimMode(shown(found))
    }
}

/// Why a message is not written: what is wrong, and in which field.
#[derive(Debug, Clone, PartialEq)]
pub struct EncodeError(Box<(EncodeProblem, Path)>);

impl EncodeError {
    /// What is wrong.
    #[must_use]
    pub const fn problem(&self) -> &EncodeProblem {
        &self.0.0
    }

    /// The field that it concerns, such as `channels.pose_position.data[2]`; empty for the frame.
    #[must_use]
    pub fn path(&self) -> &str {
        &self.0.1.0
    }

    /// The reason in one word.
    #[must_use]
    pub const fn code(&self) -> ErrorCode {
        self.0.0.code()
    }

    #[cold]
    pub(crate) fn new(problem: EncodeProblem) -> Self {
        Self(Box::new((problem, Path::default())))
    }

    #[cold]
    pub(crate) fn inside(mut self, name: &str) -> Self {
        self.0.1.prepend_member(name);
        self
    }

    #[cold]
    pub(crate) fn inside_item(mut self, nth: usize) -> Self {
        self.0.1.prepend_item(nth);
        self
    }
}

impl From<Breach> for EncodeError {
    #[cold]
    fn from(breach: Breach) -> Self {
        Self(Box::new((breach.rule.into(), Path(breach.field.to_owned()))))
    }
}

impl fmt::Display for EncodeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (problem, path) = &*self.0;
        if !path.0.is_empty() {
            write!(f, "{}: ", path.0)?;
        }
        write!(f, "{problem}")
    }
}

impl std::error::Error for EncodeError {}

/// What is wrong with a message that should be written.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum EncodeProblem {
    /// `NCP-WIRE-086`.
    #[error("JSON has no {0}")]
    NonFinite(f64),
    /// Every receiver would reject it (`NCP-WIRE-011`).
    #[error("{0} is not within ±{MAX_INTEGER}")]
    IntegerRange(i64),
    /// Every receiver would reject it (`NCP-WIRE-066`).
    #[error("{0} entries are over the limit of {MAX_ENTRIES}")]
    TooManyEntries(usize),
    /// Every receiver would reject it (`NCP-WIRE-067`).
    #[error("{0} items are over the limit of {MAX_ITEMS}")]
    TooManyItems(usize),
    /// Every receiver would reject it (`NCP-WIRE-060`, `NCP-WIRE-062`).
    #[error("a frame of {len} bytes is over the limit of {limit}")]
    TooLong {
        /// Bytes that the frame would have.
        len: usize,
        /// Bytes that it may have.
        limit: usize,
    },
    /// The message breaks a rule that its types do not express.
    #[error(transparent)]
    Rule(#[from] Rule),
}

impl EncodeProblem {
    /// The reason in one word.
    #[must_use]
    pub const fn code(&self) -> ErrorCode {
        match self {
            Self::NonFinite(_) => ErrorCode::NonFinite,
            Self::IntegerRange(_) => ErrorCode::Value,
            Self::TooManyEntries(_) | Self::TooManyItems(_) | Self::TooLong { .. } => ErrorCode::Limit,
            Self::Rule(rule) => rule.code(),
        }
    }
}

/// A rule about a message that its types do not express; it holds of every message that was read,
/// and of every message that is written, those of the strict profile aside.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum Rule {
    /// A required `session_id` is a valid id segment (`NCP-WIRE-031`).
    #[error("not a valid session id: {0}")]
    SessionId(SegmentProblem),
    /// A stimulus frame within a request has the request's session (`NCP-WIRE-037`).
    #[error("the stimulus is of another session than the request")]
    StimulusSession,
    /// A stimulus frame within a request has the request's version (`NCP-WIRE-038`).
    #[error("the stimulus is of another version than the request")]
    StimulusVersion,
    /// The strict profile holds, and the version is not compatible (`NCP-STRICT-003`).
    #[error("the version is not compatible")]
    Version,
    /// The strict profile holds, and a command has no place in its stream (`NCP-STRICT-004`).
    #[error("a command is stamped from 1 on")]
    Unstamped,
    /// An epistemic pin (`NCP-PROV-001` to `NCP-PROV-004`).
    #[error("the pin is {pinned}")]
    Pin {
        /// The only value that it may have.
        pinned: bool,
    },
}

impl Rule {
    /// The reason in one word.
    #[must_use]
    pub const fn code(self) -> ErrorCode {
        match self {
            Self::SessionId(_) | Self::StimulusSession | Self::StimulusVersion | Self::Unstamped => ErrorCode::Value,
            Self::Version => ErrorCode::Version,
            Self::Pin { .. } => ErrorCode::Provenance,
        }
    }
}

/// A rule that a message breaks, and in which field.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Breach {
    pub(crate) field: &'static str,
    pub(crate) rule: Rule,
}

/// A way to a field, written as a program would: `horizon[3].velocity_setpoint.data[0]`.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
struct Path(String);

impl Path {
    fn prepend_member(&mut self, name: &str) {
        let joint = if self.0.is_empty() || self.0.starts_with('[') { "" } else { "." };
        self.0 = format!("{}{joint}{}", shown(name), self.0);
    }

    fn prepend_item(&mut self, nth: usize) {
        let joint = if self.0.is_empty() || self.0.starts_with('[') { "" } else { "." };
        self.0 = format!("[{nth}]{joint}{}", self.0);
    }
}

fn shown(text: &str) -> String {
    text.chars().take(SHOWN).collect()
}

#[cfg(test)]
mod tests {
    use super::super::{CommandFrame, Frame, SensorFrame};

    #[test]
    fn an_error_of_a_frame_says_the_field_and_the_byte() {
        let frame = r#"{"kind":"sensor_frame","channels":{"a":{"data":[1,2,true]}}}"#;
        let at = frame.find("true").unwrap();
        let error = SensorFrame::decode(frame.as_bytes()).unwrap_err();
        assert_eq!(error.path(), "channels.a.data[2]");
        assert_eq!(error.offset(), Some(at));
        let shown = error.to_string();
        assert!(shown.starts_with("channels.a.data[2]: "), "{shown}");
        assert!(shown.ends_with(&format!(" (byte {at})")), "{shown}");
    }

    #[test]
    fn an_error_of_a_whole_frame_names_no_field() {
        let error = SensorFrame::decode(b"[]").unwrap_err();
        assert_eq!((error.path(), error.offset()), ("", Some(0)));
        assert_eq!(error.to_string(), "a frame is an object (byte 0)");
    }

    #[test]
    fn an_error_of_a_message_says_the_field() {
        let command = CommandFrame { t: f64::NAN, ..CommandFrame::default() };
        let error = command.encode().unwrap_err();
        assert_eq!(error.path(), "t");
        assert_eq!(error.to_string(), "t: JSON has no NaN");
    }
}
