//! Refusals as Python exceptions.

use std::fmt::Display;

use ncp_spec::ErrorCode;
use ncp_spec::bulk::BulkError;
use ncp_spec::contract::{ContractError, NegotiateError};
use ncp_spec::control::{LoopError, ReflexError};
use ncp_spec::keys::KeyError;
use ncp_spec::reply::ReplyError;
use ncp_spec::version::VersionError;
use ncp_spec::wire::{DecodeError, EncodeError};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

pyo3::create_exception!(
    ncp,
    NcpError,
    PyValueError,
    "What NCP refuses.\n\n`code` is the reason in one word, such as `type` or `non_finite`; `path` the field \
     that it concerns, such as `channels.pose_position.data[2]`, or empty."
);

/// What a function of this module gives.
pub(crate) type Result<T> = std::result::Result<T, Error>;

/// Why a function has no result.
#[derive(Debug)]
pub(crate) enum Error {
    /// `ncp-spec` refused, or the dict of a message does not fit it.
    Refused { code: ErrorCode, path: String, what: String },
    /// Python refused: an argument of another type.
    Python(PyErr),
}

impl Error {
    /// A refusal that concerns no field.
    pub(crate) fn refused(code: ErrorCode, what: &impl Display) -> Self {
        Self::at(code, String::new(), what)
    }

    /// A refusal that concerns the field at `path`.
    pub(crate) fn at(code: ErrorCode, path: String, what: &impl Display) -> Self {
        Self::Refused { code, path, what: what.to_string() }
    }
}

impl From<Error> for PyErr {
    fn from(error: Error) -> Self {
        let (code, path, what) = match error {
            Error::Refused { code, path, what } => (code, path, what),
            Error::Python(error) => return error,
        };
        // The words of a decoder begin with the path already.
        let named = path.is_empty() || what.starts_with(&path);
        let message = if named { format!("{what} [{code}]") } else { format!("{path}: {what} [{code}]") };
        Python::attach(|py| {
            let error = NcpError::new_err(message);
            let value = error.value(py);
            let told = value.setattr("code", code.as_str()).and_then(|()| value.setattr("path", path));
            told.err().unwrap_or(error)
        })
    }
}

impl From<PyErr> for Error {
    fn from(error: PyErr) -> Self {
        Self::Python(error)
    }
}

impl From<DecodeError> for Error {
    fn from(error: DecodeError) -> Self {
        Self::at(error.code(), error.path().to_owned(), &error)
    }
}

impl From<EncodeError> for Error {
    fn from(error: EncodeError) -> Self {
        Self::at(error.code(), error.path().to_owned(), &error)
    }
}

macro_rules! refusal {
    ($($error:ty),+) => {$(
        impl From<$error> for Error {
            fn from(error: $error) -> Self {
                Self::refused(error.code(), &error)
            }
        }
    )+};
}

refusal!(BulkError, ContractError, KeyError, LoopError, NegotiateError, ReflexError, ReplyError, VersionError);
