//! The implementation of this example project: a version guard, and nothing else. Yours has more.

#![forbid(unsafe_code)]

/// What this implementation speaks. Yours has constants of its own.
pub use ncp_text::{CONTRACT_HASH, WIRE_VERSION};

/// Not a version.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Malformed;

/// Whether a peer of this version is understood. There is no strict guard yet.
///
/// # Errors
/// [`Malformed`] if the text is no version.
pub fn is_compatible(version: &str) -> Result<bool, Malformed> {
    Ok(numbers(version)? == numbers(WIRE_VERSION)?)
}

/// Major and minor, without leading zeros.
fn numbers(version: &str) -> Result<(&str, &str), Malformed> {
    let number = |part: &'_ str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
    let (major, minor) = version.split_once('.').unwrap_or((version, "0"));
    if number(major) && number(minor) {
        Ok((major.trim_start_matches('0'), minor.trim_start_matches('0')))
    } else {
        Err(Malformed)
    }
}
