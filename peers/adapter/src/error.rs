//! Why a call has no result.

use std::borrow::Cow;
use std::fmt::Display;

const INTERNAL: &str = "internal";

/// Why a call has no result.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum CallError {
    /// The implementation refused.
    Refused {
        /// The reason: an error code of PROTOCOL.md, section 5.
        code: Cow<'static, str>,
        /// The reason in words.
        message: String,
    },
    /// The implementation has no such function, or its function cannot express the call.
    Unsupported,
}

impl CallError {
    /// The implementation refused, for the reason of this code.
    pub fn refused(code: impl Into<Cow<'static, str>>, message: impl Display) -> Self {
        Self::Refused { code: code.into(), message: message.to_string() }
    }

    /// The implementation, or the request, broke a rule. This never satisfies a case.
    pub fn internal(message: impl Display) -> Self {
        Self::refused(INTERNAL, message)
    }

    /// The arguments are none that PROTOCOL.md allows. Nothing was asked of the implementation, so this must not count
    /// as its refusal.
    pub fn misfit(what: impl Display) -> Self {
        Self::internal(format_args!("the arguments do not fit PROTOCOL.md: {what}"))
    }

    /// Whether a rule was broken, rather than a call refused.
    #[must_use]
    pub fn is_internal(&self) -> bool {
        matches!(self, Self::Refused { code, .. } if code == INTERNAL)
    }
}
