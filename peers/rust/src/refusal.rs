//! Why `ncp-spec` refused a call.

use ncp_adapter::CallError;
use ncp_spec::ErrorCode;
use ncp_spec::bulk::BulkError;
use ncp_spec::contract::{ContractError, NegotiateError};
use ncp_spec::control::{LoopError, ReflexError};
use ncp_spec::keys::KeyError;
use ncp_spec::reply::ReplyError;
use ncp_spec::version::VersionError;
use ncp_spec::wire::{DecodeError, EncodeError};

/// Why a call has no result: what `?` makes of the errors of `ncp-spec`.
#[derive(Debug)]
pub(crate) struct Refusal(CallError);

impl Refusal {
    /// The reason, and the reason in words.
    pub(crate) fn new(code: ErrorCode, message: impl std::fmt::Display) -> Self {
        Self(CallError::refused(code.as_str(), message))
    }
}

impl From<CallError> for Refusal {
    fn from(error: CallError) -> Self {
        Self(error)
    }
}

impl From<Refusal> for CallError {
    fn from(Refusal(error): Refusal) -> Self {
        error
    }
}

macro_rules! refusal {
    ($($error:ty),+) => {$(
        impl From<$error> for Refusal {
            fn from(error: $error) -> Self {
                Self::new(error.code(), error)
            }
        }
    )+};
}

refusal! {
    BulkError, ContractError, DecodeError, EncodeError, KeyError, LoopError, NegotiateError, ReflexError, ReplyError,
    VersionError
}
