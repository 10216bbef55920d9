//! The golden block of section 5.1.

use crate::chapters::OBSERVATIONS_AND_BULK;

/// The bytes of the golden block, as the chapter prints them. `// [NCP-BULK-035]`
#[must_use]
pub fn golden_block() -> Vec<u8> {
    let mut dumps = OBSERVATIONS_AND_BULK.text.split("```").map(str::trim);
    let dump = dumps.find(|part| part.starts_with("00  4e 43 50 42")).unwrap_or_default();
    dump.lines().flat_map(bytes).collect()
}

/// The bytes of a line, between its offset and its remark.
fn bytes(line: &str) -> impl Iterator<Item = u8> {
    let (_offset, rest) = line.split_once("  ").unwrap_or_default();
    let bytes = rest.split("   ").next().unwrap_or_default();
    bytes.split_whitespace().map_while(|byte| u8::from_str_radix(byte, 16).ok())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_golden_block_has_the_length_that_its_header_and_the_text_state() {
        let block = golden_block();
        assert!(block.starts_with(b"NCPB"));
        assert_eq!(block.len(), 104);
        assert_eq!(block[8..12], 104_u32.to_le_bytes());
    }
}
