//! The contract's identity and negotiation (chapters 2.2 and 2.3).

use std::fmt;

use thiserror::Error;

use crate::ErrorCode;
use crate::version::{VersionError, check_version};

/// The contract hash of the wire: [`hash_of`] its `ncp.proto`. `// [NCP-VER-020]`
pub use ncp_text::CONTRACT_HASH;

/// How a peer's contract hash compares with one's own.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ContractStatus {
    /// The same hash, letter for letter.
    Match,
    /// Another hash.
    Mismatch,
    /// The peer gave none.
    NotAdvertised,
}

impl ContractStatus {
    /// The status as the text spells it: `match`, `mismatch`, `not_advertised`.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Match => "match",
            Self::Mismatch => "mismatch",
            Self::NotAdvertised => "not_advertised",
        }
    }
}

impl fmt::Display for ContractStatus {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

/// Compares a peer's contract hash with [`CONTRACT_HASH`]. Advisory: a mismatch alone is no reason
/// to reject a peer (`NCP-VER-025`).
#[must_use]
pub fn contract_status(peer_hash: Option<&str>) -> ContractStatus {
    match peer_hash {
        None => ContractStatus::NotAdvertised,        // [NCP-VER-022]
        Some(CONTRACT_HASH) => ContractStatus::Match, // [NCP-VER-023]
        Some(_) => ContractStatus::Mismatch,          // [NCP-VER-024]
    }
}

/// Accepts only a peer with the same contract hash: the strict opt-in.
///
/// # Errors
///
/// [`ContractError`] for another hash (`NCP-VER-026`) and for none (`NCP-VER-028`).
pub fn verify_contract(peer_hash: Option<&str>) -> Result<(), ContractError> {
    match contract_status(peer_hash) {
        ContractStatus::Match => Ok(()), // [NCP-VER-027]
        ContractStatus::Mismatch => Err(ContractError::Mismatch),
        ContractStatus::NotAdvertised => Err(ContractError::NotAdvertised),
    }
}

/// The version guard, strict, and then the contract status.
///
/// # Errors
///
/// [`NegotiateError`] for a malformed or incompatible version, whatever the hash (`NCP-VER-030`).
pub fn negotiate(version: &str, peer_hash: Option<&str>) -> Result<ContractStatus, NegotiateError> {
    check_version(version, true)?;
    Ok(contract_status(peer_hash)) // [NCP-VER-031]
}

/// Why [`verify_contract`] rejects a peer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum ContractError {
    /// The peer has another contract.
    #[error("the peer's contract hash is not {CONTRACT_HASH}")]
    Mismatch,
    /// The peer gave no contract hash.
    #[error("the peer gave no contract hash")]
    NotAdvertised,
}

impl ContractError {
    /// Always [`ErrorCode::Contract`].
    #[must_use]
    pub const fn code(self) -> ErrorCode {
        ErrorCode::Contract
    }
}

/// Why [`negotiate`] rejects a peer: its version. A contract hash never is the reason.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error(transparent)]
pub struct NegotiateError(#[from] VersionError);

impl NegotiateError {
    /// Always [`ErrorCode::Version`].
    #[must_use]
    pub const fn code(&self) -> ErrorCode {
        self.0.code()
    }
}

/// The contract hash of a proto file: FNV-1a over its [`canonical_text`], 16 lower-case digits.
#[must_use]
pub fn hash_of(proto: &str) -> String {
    format!("{:016x}", fnv1a_64(canonical_text(proto).as_bytes()))
}

/// The canonical text of a proto file: without comments, blank lines, indentation, and the lines
/// that begin with `syntax`, `package `, `import ` or `option `; line feeds between lines only.
#[must_use]
pub fn canonical_text(proto: &str) -> String {
    const DROPPED: [&str; 4] = ["syntax", "package ", "import ", "option "];
    let bare = without_comments(proto);
    let lines = bare.split('\n').map(str::trim);
    let kept = lines.filter(|line| !line.is_empty() && !DROPPED.iter().any(|d| line.starts_with(d)));
    kept.collect::<Vec<_>>().join("\n")
}

/// FNV-1a, 64 bits.
#[must_use]
pub fn fnv1a_64(bytes: &[u8]) -> u64 {
    const OFFSET_BASIS: u64 = 0xcbf2_9ce4_8422_2325;
    const PRIME: u64 = 0x0000_0100_0000_01b3;
    bytes.iter().fold(OFFSET_BASIS, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(PRIME))
}

/// Takes `//` comments out up to the line feed, `/* */` comments whole; a quoted string is kept,
/// and in it a backslash escapes the character that follows.
fn without_comments(proto: &str) -> String {
    let mut bare = String::with_capacity(proto.len());
    let mut rest = proto.chars();
    while let Some(c) = rest.next() {
        if c == '"' || c == '\'' {
            bare.push(c);
            let mut escaped = false;
            for inner in rest.by_ref() {
                bare.push(inner);
                if inner == c && !escaped {
                    break;
                }
                escaped = inner == '\\' && !escaped;
            }
        } else if c == '/' && rest.as_str().starts_with('/') {
            let comment = rest.as_str().find('\n').unwrap_or(rest.as_str().len());
            rest = rest.as_str().get(comment..).unwrap_or_default().chars();
        } else if c == '/' && rest.as_str().starts_with('*') {
            let after_star = rest.as_str().get(1..).unwrap_or_default();
            rest = after_star.split_once("*/").map_or("", |(_, after)| after).chars();
        } else {
            bare.push(c);
        }
    }
    bare
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::WIRE_VERSION;

    #[test]
    fn fnv1a_gives_the_published_values() {
        // Test vectors of the FNV reference page.
        assert_eq!(fnv1a_64(b""), 0xcbf2_9ce4_8422_2325);
        assert_eq!(fnv1a_64(b"a"), 0xaf63_dc4c_8601_ec8c);
        assert_eq!(fnv1a_64(b"foobar"), 0x8594_4171_f739_67e8);
    }

    #[test]
    fn the_shipped_proto_has_the_contract_hash() {
        let proto = include_str!("../../proto/ncp.proto");
        assert_eq!(hash_of(proto), CONTRACT_HASH);
    }

    #[test]
    fn comments_blank_lines_indentation_and_file_options_do_not_count() {
        let proto = "syntax = \"proto3\";\npackage ncp.v0;\nimport \"x.proto\";\n\
            option java_package = \"x\";\n\n// about A\n\
            message A { // trailing\n\t  string a = 1;  \r\n  /* several\n     lines */\n}\n";
        assert_eq!(canonical_text(proto), "message A {\nstring a = 1;\n}");
    }

    #[test]
    fn a_comment_sign_in_a_string_is_text() {
        assert_eq!(canonical_text(r#"a = "http://x /* y */";"#), r#"a = "http://x /* y */";"#);
        assert_eq!(canonical_text(r#"a = "\"//"; // gone"#), r#"a = "\"//";"#);
        assert_eq!(canonical_text(r#"a = "\\"; // gone"#), r#"a = "\\";"#);
        assert_eq!(canonical_text("a = '\"//'; // gone"), "a = '\"//';");
    }

    #[test]
    fn a_block_comment_ends_at_its_first_end() {
        assert_eq!(canonical_text("a /* // */ b"), "a  b");
        assert_eq!(canonical_text("a /*/ b */ c"), "a  c");
        assert_eq!(canonical_text("a /* open"), "a");
        assert_eq!(canonical_text("a // b /* c\nd */"), "a\nd */");
    }

    #[test]
    fn only_the_four_beginnings_are_dropped() {
        assert_eq!(
            canonical_text("syntaxes\noptional x\npackages y\nimported z"),
            "optional x\npackages y\nimported z"
        );
    }

    #[test]
    fn a_hash_matches_letter_for_letter() {
        assert_eq!(contract_status(Some(CONTRACT_HASH)), ContractStatus::Match);
        assert_eq!(contract_status(Some(&CONTRACT_HASH.to_ascii_uppercase())), ContractStatus::Mismatch);
        assert_eq!(contract_status(Some("")), ContractStatus::Mismatch);
        assert_eq!(contract_status(None), ContractStatus::NotAdvertised);
    }

    #[test]
    fn verify_accepts_the_same_hash_only() {
        assert_eq!(verify_contract(Some(CONTRACT_HASH)), Ok(()));
        assert_eq!(verify_contract(Some("2cf0763ad61e4f1c")), Err(ContractError::Mismatch));
        assert_eq!(verify_contract(None), Err(ContractError::NotAdvertised));
    }

    #[test]
    fn negotiation_rejects_for_the_version_and_never_for_the_hash() {
        assert_eq!(negotiate(WIRE_VERSION, Some(CONTRACT_HASH)), Ok(ContractStatus::Match));
        assert_eq!(negotiate(WIRE_VERSION, Some("2cf0763ad61e4f1c")), Ok(ContractStatus::Mismatch));
        assert_eq!(negotiate(WIRE_VERSION, None), Ok(ContractStatus::NotAdvertised));
        for version in ["0.0", "99.0", "", "1.0.0"] {
            let refused = negotiate(version, Some(CONTRACT_HASH)).unwrap_err();
            assert_eq!(refused.code(), ErrorCode::Version);
        }
    }
}
