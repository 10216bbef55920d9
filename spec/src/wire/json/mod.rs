//! Strict JSON (RFC 8259), just what the messages need: one pass in, one pass out.

mod reader;
mod writer;

pub(crate) use reader::{LeftOut, Purpose, Reader};
pub(crate) use writer::Writer;

/// How many bytes lead up to the first that a string cannot hold as it is: a quotation mark, a
/// backslash or an ASCII control character.
#[inline]
fn plain_len(bytes: &[u8]) -> usize {
    let mut at = 0;
    while let Some(word) = bytes.get(at..).and_then(|rest| rest.first_chunk::<8>()) {
        let special = special_bytes(u64::from_le_bytes(*word));
        if special != 0 {
            return at + (special.trailing_zeros() / 8) as usize;
        }
        at += 8;
    }
    let tail = bytes.get(at..).unwrap_or_default();
    at + tail.iter().position(|b| matches!(b, b'"' | b'\\' | 0..=0x1f)).unwrap_or(tail.len())
}

/// Marks the special bytes of a word by their highest bit. Above the lowest mark others may be
/// wrong, since the subtractions borrow; the lowest is right.
#[inline]
const fn special_bytes(word: u64) -> u64 {
    const ONES: u64 = u64::MAX / 0xff;
    const HIGHS: u64 = ONES << 7;
    let quote = word ^ (ONES * b'"' as u64);
    let backslash = word ^ (ONES * b'\\' as u64);
    let is_zero = (quote.wrapping_sub(ONES) & !quote) | (backslash.wrapping_sub(ONES) & !backslash);
    let is_control = word.wrapping_sub(ONES * 0x20) & !word;
    (is_zero | is_control) & HIGHS
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn plain_len_bytewise(bytes: &[u8]) -> usize {
        bytes.iter().take_while(|b| !matches!(b, b'"' | b'\\' | 0..=0x1f)).count()
    }

    #[test]
    fn every_byte_is_judged_alike_at_every_place() {
        for byte in 0..=u8::MAX {
            for place in 0..20 {
                for filler in [b'a', 0x7f, 0x80, 0xff, b'!', b'#', b' ', b'[', b']'] {
                    let mut bytes = [filler; 20];
                    bytes[place] = byte;
                    assert_eq!(plain_len(&bytes), plain_len_bytewise(&bytes), "{byte} at {place}");
                }
            }
        }
    }

    proptest! {
        /// [NCP-WIRE-002]
        #[test]
        fn whole_words_find_what_single_bytes_find(bytes in proptest::collection::vec(any::<u8>(), 0..64)) {
            prop_assert_eq!(plain_len(&bytes), plain_len_bytewise(&bytes));
        }
    }
}
