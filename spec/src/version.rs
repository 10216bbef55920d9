//! The version guard (chapter 2.1).

use std::cmp::Ordering;

use thiserror::Error;

use ncp_spec::ErrorCode;

/// The wire version that this crate speaks. `// [NCP-VER-021]`
pub use ncp_text::WIRE_VERSION;

/// Compares a peer's version with [`WIRE_VERSION`].
///
/// `Ok(true)`: compatible. `Ok(false)`: not compatible, when not `strict`.
///
/// ```
/// use ncp_spec::version::{WIRE_VERSION, check_version};
///
/// assert_eq!(check_version(WIRE_VERSION, true), Ok(true));
/// assert_eq!(check_version("0.4", false), Ok(false));
/// assert!(check_version("0.4", true).is_err());
/// assert!(check_version("0.4.0", false).is_err());
/// ```
///
/// # Errors
///
/// [`VersionError::Malformed`] for anything but one or two dot-separated integers, strict or not;
/// [`VersionError::Incompatible`] for an incompatible version, when `strict`.
pub fn check_version(version: &str, strict: bool) -> Result<bool, VersionError> {
    let peer = Version::parse(version).ok_or_else(|| VersionError::malformed(version))?;
    let compatible = peer.is_compatible_with(Version::OWN);
    if strict && !compatible {
        return Err(VersionError::incompatible(version)); // [NCP-VER-006]
    }
    Ok(compatible) // [NCP-VER-007] [NCP-VER-008]
}

/// Why a version is refused.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum VersionError {
    /// Not one or two dot-separated base-10 unsigned integers (`NCP-VER-001`).
    #[error("{version:?} is not a version: one or two integers with a dot between")]
    Malformed {
        /// What was given, shortened to [`VersionError::SHOWN`] characters.
        version: String,
    },
    /// Well-formed, but not compatible with [`WIRE_VERSION`] (`NCP-VER-006`).
    #[error("wire version {version} is not compatible with {WIRE_VERSION}")]
    Incompatible {
        /// What was given, shortened to [`VersionError::SHOWN`] characters.
        version: String,
    },
}

impl VersionError {
    /// How many characters of a refused version an error shows at most.
    pub const SHOWN: usize = 64;

    /// Always [`ErrorCode::Version`].
    #[must_use]
    pub const fn code(&self) -> ErrorCode {
        ErrorCode::Version
    }

    fn malformed(version: &str) -> Self {
        Self::Malformed { version: version.chars().take(Self::SHOWN).collect() }
    }

    fn incompatible(version: &str) -> Self {
        Self::Incompatible { version: version.chars().take(Self::SHOWN).collect() }
    }
}

/// Major and minor, each as its decimal digits without leading zeros, so that no number of digits
/// overflows. `// [NCP-VER-009]`
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Version<'a> {
    major: &'a str,
    minor: &'a str,
}

impl<'a> Version<'a> {
    const OWN: Version<'static> = {
        let mut dot = 0;
        while WIRE_VERSION.as_bytes()[dot] != b'.' {
            dot += 1;
        }
        let (major, rest) = WIRE_VERSION.split_at(dot);
        let (_, minor) = rest.split_at(1);
        // Neither is written with leading zeros; a zero has no significant digit.
        Version {
            major: if matches!(major.as_bytes(), [b'0']) { "" } else { major },
            minor: if matches!(minor.as_bytes(), [b'0']) { "" } else { minor },
        }
    };

    // [NCP-VER-001] [NCP-VER-002]
    fn parse(version: &'a str) -> Option<Self> {
        let (major, minor) = version.split_once('.').unwrap_or((version, "0"));
        Some(Self { major: integer(major)?, minor: integer(minor)? })
    }

    fn is_compatible_with(self, other: Version<'_>) -> bool {
        match self.major.cmp(other.major) {
            Ordering::Equal if self.major.is_empty() => self.minor == other.minor, // [NCP-VER-003]
            Ordering::Equal => true,                                               // [NCP-VER-005]
            _ => false,                                                            // [NCP-VER-004]
        }
    }
}

/// The significant digits of a base-10 unsigned integer; none for zero.
fn integer(part: &str) -> Option<&str> {
    let is_integer = !part.is_empty() && part.bytes().all(|b| b.is_ascii_digit());
    is_integer.then(|| part.trim_start_matches('0'))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// The minor of the own version, whose major is 0.
    fn own_minor() -> u64 {
        WIRE_VERSION.strip_prefix("0.").unwrap().parse().unwrap()
    }

    #[test]
    fn the_table_of_the_text_holds() {
        let own = WIRE_VERSION;
        assert_eq!(check_version(own, true), Ok(true));
        assert_eq!(check_version(own, false), Ok(true));
        let (before, after) = (format!("0.{}", own_minor() - 1), format!("0.{}", own_minor() + 1));
        for other in [&before, &after, "1.0", "1", "0"] {
            assert_eq!(check_version(other, false), Ok(false), "{other}");
            assert_eq!(check_version(other, true), Err(VersionError::incompatible(other)));
        }
        let malformed = [format!("{own}.0"), format!("v{own}"), format!(" {own}"), format!("+{own}")];
        for junk in malformed.iter().map(String::as_str).chain(["0.", ".5", ""]) {
            for strict in [false, true] {
                assert_eq!(check_version(junk, strict), Err(VersionError::malformed(junk)));
            }
        }
    }

    #[test]
    fn only_ascii_digits_make_a_number() {
        let own = WIRE_VERSION;
        let near = [format!("0_{own}"), format!("{own}\n"), format!("0x{own}"), format!("-{own}")];
        for junk in near.iter().map(String::as_str).chain(["0.５", "٠.٥", "0,5", "0.-5", ".", "..", "0..5"]) {
            assert_eq!(check_version(junk, false), Err(VersionError::malformed(junk)), "{junk:?}");
        }
    }

    #[test]
    fn leading_zeros_do_not_count() {
        let minor = own_minor();
        assert_eq!(check_version(&format!("00.0{minor}"), true), Ok(true));
        assert_eq!(check_version(&format!("0.{minor}0"), false), Ok(false));
        assert_eq!(check_version(&format!("000.000{minor}"), true), Ok(true));
    }

    #[test]
    fn a_million_digits_are_no_overflow() {
        let long = "9".repeat(1_000_000);
        assert_eq!(check_version(&format!("0.{long}"), false), Ok(false));
        assert_eq!(check_version(&format!("{long}.5"), false), Ok(false));
        assert_eq!(check_version(&format!("0.{}{}", "0".repeat(1_000_000), own_minor()), true), Ok(true));
        let shown = check_version(&format!("0.{long}"), true).unwrap_err().to_string();
        assert!(shown.len() < 200, "{}", shown.len());
    }

    /// [NCP-VER-005]
    #[test]
    fn from_major_1_on_the_minor_does_not_count() {
        let [one, other_minor] = ["1.2", "1.7"].map(|v| Version::parse(v).unwrap());
        assert!(one.is_compatible_with(other_minor));
        assert!(!one.is_compatible_with(Version::parse("2.2").unwrap()));
        assert!(!one.is_compatible_with(Version::OWN));
    }

    proptest! {
        /// [NCP-VER-003] [NCP-VER-004] [NCP-VER-009]
        #[test]
        fn numbers_are_compared_by_value(major in 0u64..4, minor in 0u64..12, zeros in 0usize..4) {
            let version = format!("{}{major}.{}{minor}", "0".repeat(zeros), "0".repeat(zeros));
            prop_assert_eq!(check_version(&version, false), Ok(major == 0 && minor == own_minor()));
        }

        /// [NCP-VER-001] [NCP-VER-006] [NCP-VER-007] [NCP-VER-008]
        #[test]
        fn strict_errs_exactly_where_lenient_errs_or_says_no(version in "[0-9.v +]{0,6}") {
            let lenient = check_version(&version, false);
            let strict = check_version(&version, true);
            prop_assert_eq!(strict.is_ok(), lenient == Ok(true));
        }
    }
}
