//! The limits: the table of section 1.6, and the range of integers of section 1.2, read at compile time.

use crate::chapters::WIRE;
use crate::identity::behind;

/// The longest frame in bytes, an `observation_frame` aside. `// [NCP-WIRE-060]`
pub const FRAME_BYTES: usize = count("| bytes of a frame | 1 MiB = ");

/// The longest `observation_frame` in bytes. `// [NCP-WIRE-062]`
pub const OBSERVATION_FRAME_BYTES: usize = count("; 64 MiB = ");

/// Levels of nested objects and arrays, the top-level object included. `// [NCP-WIRE-064]`
pub const LEVELS: usize = count("| levels of nested objects and arrays | ");

/// Entries of one map. `// [NCP-WIRE-066]`
pub const ENTRIES: usize = count("| entries of one map | ");

/// Items of one array whose items are not numbers. `// [NCP-WIRE-067]`
pub const ITEMS: usize = count("| items of one array whose items are not numbers | ");

/// Bytes of an id segment. `// [NCP-KEY-017]`
pub const SEGMENT_BYTES: usize = count("| bytes of an id segment | ");

/// Bytes of a BulkBlock. `// [NCP-BULK-015]`
pub const BLOCK_BYTES: usize = count("| bytes and columns of a BulkBlock | ") << 20;

/// Columns of a BulkBlock. `// [NCP-BULK-016]`
pub const BLOCK_COLUMNS: usize = count("| bytes and columns of a BulkBlock | 64 MiB and ");

/// The largest magnitude of an integer. `// [NCP-WIRE-011]`
pub const INTEGER: i64 = number("within ±(2^53 − 1) = ±");

/// The count behind the first `lead`.
const fn count(lead: &str) -> usize {
    number(lead) as usize
}

/// The number behind the first `lead`, commas left out.
const fn number(lead: &str) -> i64 {
    let digits = behind(WIRE.text, lead).as_bytes();
    let (mut value, mut at) = (0, 0);
    while digits[at] == b',' || digits[at].is_ascii_digit() {
        if digits[at] != b',' {
            value = value * 10 + (digits[at] - b'0') as i64;
        }
        at += 1;
    }
    assert!(at > 0, "a limit begins with a digit");
    value
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_limits_are_those_that_the_rules_name() {
        assert_eq!([FRAME_BYTES, OBSERVATION_FRAME_BYTES, BLOCK_BYTES], [1 << 20, 64 << 20, 64 << 20]);
        assert_eq!([LEVELS, ENTRIES, ITEMS, SEGMENT_BYTES, BLOCK_COLUMNS], [64, 4_096, 4_096, 256, 4_096]);
        assert_eq!(INTEGER, (1 << 53) - 1);
    }
}
