//! Why a request is answered with an error frame of the gateway's own.

use std::time::Duration;

use ncp_proto::convert::FromProtoError;
use ncp_spec::wire::{DecodeError, ErrorFrame, Frame, Kind, Text};
use thiserror::Error;

/// What became of a request: the reply of the service as it came, or why there is none.
pub type Answer = Result<Vec<u8>, Refusal>;

/// The frame with which an answer travels to a client that speaks JSON.
#[must_use]
pub fn frame(answer: Answer) -> Vec<u8> {
    answer.unwrap_or_else(|refusal| refusal.frame())
}

/// A failure, and the session whose request it cost.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{failure}")]
pub struct Refusal {
    /// The session, if the request names one.
    pub session: Option<Text>,
    /// What went wrong.
    pub failure: Failure,
}

impl Refusal {
    /// The error frame that says so.
    #[must_use]
    pub fn frame(&self) -> Vec<u8> {
        let frame = ErrorFrame { error: self.failure.to_string().into(), session_id: self.session.clone() };
        // A session's id was read from a frame, so it can be written.
        frame.encode().unwrap_or_else(|_| r#"{"kind":"error","error":"the gateway failed"}"#.to_owned()).into_bytes()
    }
}

/// What went wrong. Each says whether the service may have carried the request out.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum Failure {
    /// The request has more bytes than one may have. `[NCP-WIRE-060]`
    #[error("the request has {len} bytes, more than {limit}")]
    RequestTooLong {
        /// What it has.
        len: usize,
        /// What it may have.
        limit: usize,
    },
    /// The request is no frame. `[NCP-SESS-021]`
    #[error("the request is rejected: {0}")]
    RequestRejected(#[from] DecodeError),
    /// The frame is of a kind that asks for nothing. `[NCP-SESS-022]`
    #[error("{0} is no request")]
    NotARequest(Kind),
    /// The frame has a form in which it cannot be written.
    #[error("the request cannot be forwarded: {0}")]
    Unwritable(String),
    /// The protobuf form of a request is no frame.
    #[error("the request is rejected: {0}")]
    NoFrame(#[from] FromProtoError),
    /// There are as many requests in the gateway as it takes.
    #[error("the gateway has too many requests in flight; this one was not carried out")]
    Busy,
    /// The gateway takes no more requests.
    #[error("the gateway is stopping; the request was not carried out")]
    Stopping,
    /// Its time ran out before it could be forwarded.
    #[error("the request waited for {0:?} and was not carried out")]
    Expired(Duration),
    /// Nobody answers at the address of the service.
    #[error("the simulation service cannot be reached: {0}")]
    Unreachable(String),
    /// The service did not answer in time. `[NCP-TRANS-006]`
    #[error("no reply of the simulation service within {0:?}; the request may have been carried out")]
    TimedOut(Duration),
    /// The connection ended, and with it the reply, before the line feed. `[NCP-TRANS-005]`
    #[error("the simulation service ended before its reply was whole; the request may have been carried out")]
    Cut,
    /// The reply is longer than any frame.
    #[error("the reply of the simulation service has more than {limit} bytes; the request may have been carried out")]
    ReplyTooLong {
        /// What it may have.
        limit: usize,
    },
    /// The reply is no frame. `[NCP-TRANS-005]`
    #[error("the reply of the simulation service is rejected: {0}; the request may have been carried out")]
    ReplyRejected(DecodeError),
    /// The reply answers something else.
    #[error("the reply of the simulation service is {found}, not one to this {asked}")]
    Misfit {
        /// The kind of the request.
        asked: Kind,
        /// The kind of the reply, and its session where that is what does not fit.
        found: String,
    },
    /// The gateway itself failed. `[NCP-SESS-037]`
    #[error("the gateway failed; the request may have been carried out")]
    Internal,
}

impl Failure {
    /// The cause in a word, as the metrics and the log have it.
    #[must_use]
    pub const fn cause(&self) -> &'static str {
        match self {
            Self::RequestTooLong { .. } => "request_too_long",
            Self::RequestRejected(_) => "request_rejected",
            Self::NotARequest(_) => "not_a_request",
            Self::Unwritable(_) => "unwritable",
            Self::NoFrame(_) => "request_rejected",
            Self::Busy => "busy",
            Self::Stopping => "stopping",
            Self::Expired(_) => "expired",
            Self::Unreachable(_) => "unreachable",
            Self::TimedOut(_) => "timed_out",
            Self::Cut => "cut",
            Self::ReplyTooLong { .. } => "reply_too_long",
            Self::ReplyRejected(_) => "reply_rejected",
            Self::Misfit { .. } => "misfit",
            Self::Internal => "internal",
        }
    }
}
