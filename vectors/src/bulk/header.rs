//! The header, field by field, and the length of the whole.

use super::build::{Block, HEADER, f32s, golden, i32s, le16, le32};
use super::{READERS, decode, read, rejected};
use crate::case::{Case, File};
use crate::json::Json;
use crate::json::object;
use crate::template::Text;

pub(super) fn file() -> File {
    let mut cases = vec![
        read("golden", &["NCP-BULK-022", "NCP-BULK-023"], &golden())
            .title("The golden block is read as its two columns.")
            .flags(&["byte-order"])
            .because("The text prints the block and its values."),
        read("no-columns", &["NCP-BULK-019"], &Block::new([]))
            .title("A block of a header alone is read as no columns.")
            .flags(&["empty-blocks"])
            .because("A block may have no columns."),
    ];
    cases.extend(short());
    cases.extend(magic_version_flags());
    cases.extend(lengths());
    cases.extend(directory_size());
    cases.extend(many_columns());
    cases.extend(sizes());
    File::new("bulk", "header", "The header of a BulkBlock, field by field, and the length of the block.", cases)
}

fn short() -> Vec<Case> {
    let block = Block::new([]).bytes();
    [0, 1, 4, 11]
        .into_iter()
        .map(|length| {
            rejected(format!("short/{length}"), &["NCP-BULK-001"], &block[..length])
                .title(format!("A block of {length} bytes is rejected."))
                .flags(&["truncated-input"])
                .because("The header alone has 12 bytes.")
        })
        .collect()
}

fn magic_version_flags() -> Vec<Case> {
    let golden = golden();
    let mut cases = Vec::new();
    let magics: [(&str, &[u8]); 7] = [
        ("first", b"nCPB"),
        ("second", b"NcPB"),
        ("third", b"NCpB"),
        ("fourth", b"NCPb"),
        ("digit", b"NCP1"),
        ("reversed", b"BPCN"),
        ("zeros", b"\0\0\0\0"),
    ];
    cases.extend(magics.into_iter().map(|(what, magic)| {
        rejected(format!("magic/{what}"), &["NCP-BULK-002"], &golden.patched(0, magic))
            .title(format!("A block that begins with {} is rejected.", String::from_utf8_lossy(magic).escape_default()))
            .flags(&["unchecked-header"])
            .because("The magic is `NCPB`, all four letters.")
    }));
    cases.extend([0, 2, 3, 0x81, 255].into_iter().map(|version| {
        rejected(format!("version/{version}"), &["NCP-BULK-003"], &golden.patched(4, &[version]))
            .title(format!("A block of version {version} is rejected."))
            .flags(&["unchecked-header"])
            .because("The version is 1.")
    }));
    let bits = (0..8).map(|bit| 1 << bit).chain([255]);
    cases.extend(bits.map(|flags: u8| {
        rejected(format!("flags/{flags}"), &["NCP-BULK-004"], &golden.patched(5, &[flags]))
            .title(format!("A block with the flags {flags:#04x} is rejected."))
            .flags(&["unchecked-header"])
            .because("No flag has a meaning, so none may be set.")
    }));
    // Both bytes read as one number, in the other byte order.
    cases.push(
        rejected("version/0-of-flags-1", &["NCP-BULK-003", "NCP-BULK-004"], &golden.patched(4, &[0, 1]))
            .title("A block of version 0 with the flags 1 is rejected.")
            .flags(&["unchecked-header"])
            .because("The version is 1, and no flag has a meaning."),
    );
    cases
}

/// total_len and the length of the buffer.
fn lengths() -> Vec<Case> {
    let golden = golden();
    let len = golden.len;
    let claims = [
        ("less-by-1", len - 1, "one less than the buffer has"),
        ("more-by-1", len + 1, "one more than the buffer has"),
        ("zero", 0, "0"),
        ("header", HEADER, "12, the header's"),
        ("half", len / 2, "half of what the buffer has"),
        ("largest", u32::MAX as usize, "2^32 - 1"),
        ("sign-bit", len | 1 << 31, "the buffer's with the sign bit set"),
        ("other-byte-order", (len as u32).swap_bytes() as usize, "the buffer's in the other byte order"),
    ];
    let mut cases: Vec<Case> = claims
        .into_iter()
        .map(|(what, claim, says)| {
            rejected(format!("total-len/{what}"), &["NCP-BULK-005"], &golden.patched(8, &le32(claim)))
                .title(format!("A block whose total_len is {says} is rejected."))
                .flags(&["trusted-lengths"])
                .because("The field total_len is the length of the buffer, no more and no less.")
        })
        .collect();
    for (what, extra) in [("byte", &b"\0"[..]), ("eight-bytes", &[0; 8]), ("second-block", &golden.bytes())] {
        cases.push(
            rejected(format!("trailing/{what}"), &["NCP-BULK-005"], &[&golden.bytes(), extra].concat())
                .title(format!(
                    "A block that is followed by {} bytes that total_len does not count is rejected.",
                    extra.len()
                ))
                .flags(&["trailing-input"])
                .because("The field total_len is not the length of the buffer."),
        );
    }
    // Zeros that fill a buffer up to a multiple of its word.
    for rows in 1..=4_usize {
        let block = Block::new([i32s("v", vec![7; rows])]).bytes();
        for word in [8, 16] {
            let filled = block.len().next_multiple_of(word);
            if filled == block.len() || (word == 16 && filled == block.len().next_multiple_of(8)) {
                continue;
            }
            let mut bytes = block.clone();
            bytes.resize(filled, 0);
            cases.push(
                rejected(format!("trailing/to-a-multiple-of-{word}/{rows}-rows"), &["NCP-BULK-005"], &bytes)
                    .title(format!(
                        "A block of {} bytes that zeros fill up to {filled} bytes is rejected.",
                        block.len()
                    ))
                    .flags(&["trailing-input"])
                    .because("The field total_len is not the length of the buffer."),
            );
        }
    }
    let cuts = [
        (HEADER, "header"),
        (20, "within-directory"),
        (44, "directory"),
        (47, "within-name"),
        (56, "names"),
        (60, "within-first-column"),
        (80, "first-column"),
        (103, "last-byte"),
    ];
    cases.extend(cuts.into_iter().map(|(at, what)| {
        rejected(format!("truncated/{what}"), &["NCP-BULK-005"], &golden.bytes()[..at])
            .title(format!("A block of which only the first {at} of 104 bytes are there is rejected."))
            .flags(&["truncated-input"])
            .because("The field total_len is not the length of the buffer.")
    }));
    cases
}

/// A directory that does not fit.
fn directory_size() -> Vec<Case> {
    let header = |n_cols: usize, len: usize| {
        let mut bytes = [b"NCPB", &[1, 0][..], &le16(n_cols), &le32(len)].concat();
        bytes.resize(len, 0);
        bytes
    };
    let table = [
        ("one-of-none", 1, HEADER),
        ("one-byte-short", 1, HEADER + 15),
        ("second-missing", 2, HEADER + 16),
        ("second-one-byte-short", 2, HEADER + 31),
        ("largest-count", 4096, HEADER),
        ("largest-count-one-byte-short", 4096, HEADER + 16 * 4096 - 1),
    ];
    table
        .into_iter()
        .map(|(what, n_cols, len)| {
            // Entries that are there have no name, no rows, and the dtype f32: they hold nothing.
            let mut bytes = header(n_cols, len);
            for entry in bytes[HEADER..].chunks_exact_mut(16) {
                entry[6] = 1;
            }
            rejected(format!("directory/{what}"), &["NCP-BULK-006"], &bytes)
                .title(format!("A block of {len} bytes that claims {n_cols} columns is rejected."))
                .flags(&["trusted-lengths"])
                .because("The directory takes 16 bytes a column behind the header.")
        })
        .collect()
}

/// 4,096 columns and one more, none of them with a row.
fn many_columns() -> Vec<Case> {
    let columns = |count: usize| Block::new((0..count).map(|nth| f32s(&short_name(nth), [])).collect::<Vec<_>>());
    vec![
        decode("columns/4096", &["NCP-BULK-017"], &columns(4096).bytes())
            .accepts()
            .title("A block of 4,096 columns without rows is read.")
            .flags(&["low-limits"])
            .because("A block may have 4,096 columns."),
        decode("columns/4097", &["NCP-BULK-016"], &columns(4097).bytes())
            .rejects("limit")
            .title("A block of 4,097 columns without rows is rejected.")
            .flags(&["missing-limits"])
            .because("A block may have 4,096 columns."),
    ]
}

/// A different name of two letters for each of 4,096 columns, and of three from there on.
pub(super) fn short_name(nth: usize) -> String {
    let letters: Vec<char> = ('0'..='9').chain('A'..='Z').chain('a'..='z').chain(['-', '_']).collect();
    let letter = |n: usize| letters.get(n % letters.len()).copied().unwrap_or('0');
    let mut name = String::from_iter([letter(nth / 64), letter(nth)]);
    if nth >= 4096 {
        name.push('+');
    }
    name
}

/// Blocks without columns at the limit of their length, far below it and beyond it.
fn sizes() -> [Case; 3] {
    const LIMIT: usize = 64 << 20;
    let decode = |name, rule, len| {
        Case::new(format!("size/{name}"), &[rule], READERS)
            .call("bulk.decode", object! { "block" => empty(len) })
            .because("A block may have 64 MiB.")
    };
    let nothing = || object! { "columns" => Json::Array(Vec::new()) };
    [
        decode("above-a-frame", "NCP-BULK-025", (1 << 20) + 1)
            .title("A block of 1 MiB and a byte, more than a frame may have, is read.")
            .flags(&["low-limits"])
            .gives(nothing()),
        decode("limit", "NCP-BULK-025", LIMIT)
            .title("A block of 64 MiB is read.")
            .flags(&["low-limits", "slow"])
            .gives(nothing()),
        decode("beyond-limit", "NCP-BULK-015", LIMIT + 1)
            .title("A block of 64 MiB and a byte is rejected.")
            .flags(&["missing-limits", "slow"])
            .rejects("limit"),
    ]
}

/// A block without columns, in whose bytes behind the header nothing lies. Every byte of the header
/// has to be ASCII, so that the block can be a template.
fn empty(len: usize) -> Text {
    let header: String = [b"NCPB", &[1, 0][..], &le16(0), &le32(len)].concat().into_iter().map(char::from).collect();
    Text::Base64(Box::new(Text::concat([header.into(), Text::repeat("x", len - HEADER)])))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_names_are_different() {
        let mut names: Vec<_> = (0..4097).map(short_name).collect();
        names.sort();
        names.dedup();
        assert_eq!(names.len(), 4097);
    }
}
