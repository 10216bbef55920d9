//! The closed list of reasons for a refusal.

use std::fmt;

/// Why something was refused, as the peer protocol names it.
///
/// Every error of this crate has one; the message beside it says the rest. The code informs and is
/// never judged, since one input can be wrong in two ways.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum ErrorCode {
    /// The bytes are not one JSON object in UTF-8 without a repeated member.
    Malformed,
    /// A field has the wrong JSON type, is `null` where it may not, or is an integer in another
    /// spelling.
    Type,
    /// The kind is missing, unknown, or not the expected one.
    Kind,
    /// A required field is missing.
    Missing,
    /// A value is not allowed: an integer out of range, an unknown `SimMode`, an invalid id, a
    /// nested frame that does not fit.
    Value,
    /// An epistemic pin does not hold.
    Provenance,
    /// A limit is exceeded.
    Limit,
    /// The version is malformed or incompatible.
    Version,
    /// The contract hash is rejected.
    Contract,
    /// A segment, a realm or a key expression is invalid.
    Key,
    /// A BulkBlock or its columns are invalid.
    Block,
    /// An encoder was given a number that JSON lacks.
    NonFinite,
    /// A reply does not fit its request, or reports a failure.
    Reply,
    /// Refused, for a reason that the peer does not tell. Only peers use it.
    Invalid,
    /// The peer crashed, which is never a refusal. Only peers use it.
    Internal,
}

impl ErrorCode {
    /// All codes.
    pub const ALL: [Self; 15] = [
        Self::Malformed,
        Self::Type,
        Self::Kind,
        Self::Missing,
        Self::Value,
        Self::Provenance,
        Self::Limit,
        Self::Version,
        Self::Contract,
        Self::Key,
        Self::Block,
        Self::NonFinite,
        Self::Reply,
        Self::Invalid,
        Self::Internal,
    ];

    /// The code as the peer protocol spells it.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Malformed => "malformed",
            Self::Type => "type",
            Self::Kind => "kind",
            Self::Missing => "missing",
            Self::Value => "value",
            Self::Provenance => "provenance",
            Self::Limit => "limit",
            Self::Version => "version",
            Self::Contract => "contract",
            Self::Key => "key",
            Self::Block => "block",
            Self::NonFinite => "non_finite",
            Self::Reply => "reply",
            Self::Invalid => "invalid",
            Self::Internal => "internal",
        }
    }

    /// The code of that spelling.
    #[must_use]
    pub fn parse(code: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|known| known.as_str() == code)
    }
}

impl fmt::Display for ErrorCode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_code_is_found_by_its_spelling_and_no_other_is() {
        for code in ErrorCode::ALL {
            assert_eq!(ErrorCode::parse(code.as_str()), Some(code));
        }
        assert_eq!(ErrorCode::parse("Malformed"), None);
        assert_eq!(ErrorCode::parse(""), None);
    }
}
