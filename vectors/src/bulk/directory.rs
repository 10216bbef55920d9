//! The entries of the directory, field by field.

use super::build::{Block, Part, f32s, f64s, golden, i64s};
use super::{advised, decode, read, read_if_at_all, rejected};
use crate::case::{Case, File};
use crate::json::object;
use crate::names::{self, LONG_NAMES};

pub(super) fn file() -> File {
    let mut cases = dtypes();
    cases.extend(names());
    cases.extend(data());
    cases.extend(empty_regions());
    cases.extend(name_bytes());
    cases.push(divided_name());
    cases.extend(last_of_many());
    cases.extend(behind_an_observation());
    File::new("bulk", "directory", "The directory of a BulkBlock: types, names, and where the data lies.", cases)
}

const LARGEST: usize = u32::MAX as usize;

fn dtypes() -> Vec<Case> {
    let golden = golden();
    let mut cases = Vec::new();
    for dtype in [0, 5, 6, 0x12, 128, 255] {
        for nth in [0, 1] {
            cases.push(
                rejected(
                    format!("dtype/{dtype}-of-column-{nth}"),
                    &["NCP-BULK-007"],
                    &golden.entry(nth, Part::Dtype, dtype),
                )
                .title(format!("A block whose column {nth} has the dtype {dtype} is rejected."))
                .flags(&["unchecked-header"])
                .because("The dtypes are 1 to 4."),
            );
        }
    }
    let empty = Block::new([f64s("times", [])]);
    cases.push(
        rejected("dtype/0-of-empty-column", &["NCP-BULK-007"], &empty.entry(0, Part::Dtype, 0))
            .title("A block whose column without rows has the dtype 0 is rejected.")
            .flags(&["unchecked-header"])
            .because("The dtypes are 1 to 4, for a column without rows as well."),
    );
    cases.extend([1, 128, 255].into_iter().map(|pad| {
        rejected(format!("pad/{pad}"), &["NCP-BULK-008"], &golden.entry(0, Part::Pad, pad))
            .title(format!("A block whose pad byte is {pad} should be rejected."))
            .flags(&["unchecked-header"])
            .because("The pad byte is 0.")
    }));
    cases
}

/// A block whose names are the last thing in it, so that one byte more is beyond the buffer.
fn names_last() -> Block {
    Block::new([f64s("times", [1.5]), f64s("values", [2.5])]).laid_out(&[60, 65], &[44, 52], 71)
}

/// A block whose data is the last thing in it.
fn data_last() -> Block {
    Block::new([f64s("times", [1.5]), f64s("values", [2.5])])
}

fn names() -> Vec<Case> {
    let block = names_last();
    let outside = [
        ("length-by-1", block.entry(1, Part::NameLen, 7), "one byte beyond the end"),
        ("length-largest", block.entry(1, Part::NameLen, 65535), "65,529 bytes beyond the end"),
        ("offset-by-1", block.entry(1, Part::NameOff, 66), "one byte beyond the end, from an offset within"),
        ("offset-at-the-end", block.entry(1, Part::NameOff, 71), "from the end on"),
        ("offset-beyond-the-end", block.entry(1, Part::NameOff, 72), "from beyond the end on"),
        ("offset-largest", block.entry(1, Part::NameOff, LARGEST), "from the offset 2^32 - 1 on"),
        ("offset-wraps-to-header", block.entry(1, Part::NameOff, LARGEST - 5), "so far that 32 bits wrap to 0"),
        ("offset-wraps-past-0", block.entry(1, Part::NameOff, LARGEST - 1), "so far that 32 bits wrap to 4"),
        ("offset-sign-bit", block.entry(1, Part::NameOff, 1 << 31 | 65), "from an offset with the sign bit set"),
    ];
    let mut cases: Vec<Case> = outside
        .into_iter()
        .map(|(what, bytes, says)| {
            rejected(format!("name/{what}"), &["NCP-BULK-009"], &bytes)
                .title(format!("A block in which a name reaches {says} is rejected."))
                .flags(&[if what.contains("wraps") || what.contains("largest") {
                    "wrapping-offsets"
                } else {
                    "trusted-lengths"
                }])
                .because("The name does not lie wholly within the buffer.")
        })
        .collect();
    let says = "whose last name ends with it, behind the data,";
    cases.extend(
        [
            read_if_at_all("name/ends-with-the-block", &block, says),
            advised("name/behind-the-data", "NCP-BULK-026", &block, says),
        ]
        .map(|case| case.flags(&["fixed-layout"])),
    );
    let golden = golden();
    cases.push(
        rejected("name/empty-beyond-the-end", &["NCP-BULK-014"], &with_name(&golden, 105, 0))
            .title("A block in which an empty name begins beyond the end should be rejected.")
            .flags(&["trusted-lengths"])
            .because("An empty region begins beyond the buffer's end."),
    );
    cases.push(
        rejected("name/repeated", &["NCP-BULK-013"], &Block::new([f64s("times", [1.5]), i64s("times", [7])]).bytes())
            .title("A block of two columns of one name should be rejected.")
            .flags(&["duplicate-columns"])
            .because("Two columns have the same name."),
    );
    let twice = Block::new([f64s("a", [1.5]), f64s("a", [2.5])]);
    cases.push(
        decode("name/repeated-keeps-both", &["NCP-BULK-021"], &twice.bytes())
            .shows_or_refuses(object! { "columns" => twice.columns() })
            .title("A block of two columns of one name is rejected, or read as both of them.")
            .flags(&["duplicate-columns"])
            .because("A decoder that takes the block gives the columns of the directory, and it has two."),
    );
    for (what, name, says) in [
        ("of-300-bytes", "n".repeat(300), "a name of 300 bytes"),
        ("with-nul", "a\0b".to_owned(), "a name that holds U+0000"),
        ("nul-last", "ab\0".to_owned(), "a name that ends with U+0000"),
        ("nul-alone", "\0".to_owned(), "a name that is U+0000"),
        ("space-first", " ab".to_owned(), "a name that begins with a space"),
        ("space-last", "ab ".to_owned(), "a name that ends with a space"),
        ("line-feed-last", "ab\n".to_owned(), "a name that ends with a line feed"),
    ] {
        cases.push(
            read(format!("name/{what}"), &["NCP-BULK-021"], &Block::new([f64s(&name, [1.5])]))
                .title(format!("A column of {says} is read with that name."))
                .flags(&["cut-names"])
                .because("A name is its name_len bytes of UTF-8, whichever they are."),
        );
    }
    let block = Block::new(
        (1_u32..).zip(names::alike()).map(|(nth, (name, _))| f64s(name, [f64::from(nth)])).collect::<Vec<_>>(),
    );
    cases.push(
        read("name/alike/all".to_owned(), &["NCP-BULK-021"], &block)
            .title("Columns whose names are alike are read each with its own.")
            .flags(&["changed-segments"])
            .because("Names are the same when their bytes are: a decoder gives each column with its name."),
    );
    for (what, [one, other], says) in ALIKE {
        let block = Block::new([f64s(one, [1.5]), f64s(other, [2.5])]);
        cases.push(
            read(format!("name/alike/{what}"), &["NCP-BULK-021"], &block)
                .title(format!("Two columns whose names differ {says} are read each with its own."))
                .flags(&["changed-segments"])
                .because("Names are the same when their bytes are: a decoder gives each column with its name."),
        );
    }
    cases
}

/// Names that are two, though they look alike or are one to who compares them otherwise than letter for letter.
pub(super) const ALIKE: [(&str, [&str; 2], &str); 6] = [
    ("cases", ["V_m", "v_m"], "by the case of a letter"),
    ("composed", ["\u{e9}", "e\u{301}"], "by their composition"),
    ("space-last", ["a", "a "], "by a space at the end"),
    ("nul-last", ["ab", "ab\0"], "by U+0000 at the end"),
    ("sharp-s", ["ss", "\u{df}"], "by a letter that is folded into two"),
    ("of-1024", LONG_NAMES, "in the last of 1,024 letters"),
];

/// The block with another place for the name of its first column.
fn with_name(block: &Block, offset: usize, length: usize) -> Vec<u8> {
    let mut bytes = block.entry(0, Part::NameLen, length);
    let offset = super::build::le32(offset);
    bytes[12..16].copy_from_slice(&offset);
    bytes
}

fn data() -> Vec<Case> {
    let block = data_last();
    let len = block.len;
    let narrow = Block::new([f64s("times", [1.5]), f32s("values", [2.5])]);
    let outside = [
        ("rows-by-1", block.entry(1, Part::Rows, 2), "one row beyond the end"),
        ("rows-largest", block.entry(1, Part::Rows, LARGEST), "2^32 - 1 rows of 8 bytes"),
        ("rows-wrap-to-0", block.entry(1, Part::Rows, 1 << 29), "so many rows of 8 bytes that 32 bits wrap to 0"),
        (
            "rows-wrap-to-1",
            block.entry(1, Part::Rows, (1 << 29) + 1),
            "so many rows of 8 bytes that 32 bits wrap to one row",
        ),
        ("rows-sign-bit", block.entry(1, Part::Rows, 1 << 31 | 1), "a count of rows with the sign bit set"),
        ("narrow-rows-by-1", narrow.entry(1, Part::Rows, 2), "one row of 4 bytes beyond the end"),
        (
            "narrow-rows-wrap-to-0",
            narrow.entry(1, Part::Rows, 1 << 30),
            "so many rows of 4 bytes that 32 bits wrap to 0",
        ),
        (
            "narrow-rows-wrap-to-1",
            narrow.entry(1, Part::Rows, (1 << 30) + 1),
            "so many rows of 4 bytes that 32 bits wrap to one row",
        ),
        ("wider-dtype", narrow.entry(1, Part::Dtype, 2), "four bytes beyond the end, since its dtype is wider"),
        ("offset-by-1", block.entry(1, Part::DataOff, len - 7), "one byte beyond the end"),
        ("offset-at-the-end", block.entry(1, Part::DataOff, len), "from the end on"),
        ("offset-beyond-the-end", block.entry(1, Part::DataOff, len + 1), "from beyond the end on"),
        ("offset-largest", block.entry(1, Part::DataOff, LARGEST), "from the offset 2^32 - 1 on"),
        ("offset-wraps-to-0", block.entry(1, Part::DataOff, LARGEST - 7), "so far that 32 bits wrap to 0"),
        ("offset-sign-bit", block.entry(1, Part::DataOff, 1 << 31 | (len - 8)), "from an offset with the sign bit set"),
    ];
    let mut cases: Vec<Case> = outside
        .into_iter()
        .map(|(what, bytes, says)| {
            rejected(format!("data/{what}"), &["NCP-BULK-011"], &bytes)
                .title(format!("A block in which a column's data reaches {says} is rejected."))
                .flags(&[if what.contains("wrap") || what.contains("largest") {
                    "wrapping-offsets"
                } else {
                    "trusted-lengths"
                }])
                .because("The data does not lie wholly within the buffer.")
        })
        .collect();
    let rows = [("memory-of-f64", LARGEST, 2), ("memory-of-f32", LARGEST, 1), ("memory-of-i64", 1 << 27, 4)];
    cases.extend(rows.into_iter().map(|(what, count, dtype)| {
        let empty = Block::new([f64s("times", [])]);
        let mut bytes = empty.entry(0, Part::Rows, count);
        bytes[18] = dtype;
        rejected(format!("data/{what}"), &["NCP-BULK-024", "NCP-BULK-011"], &bytes)
            .title(format!(
                "A block of {} bytes that claims {count} rows is rejected, before anything is allocated for them.",
                bytes.len()
            ))
            .flags(&["allocation-by-claim"])
            .because("The data does not lie within the buffer, and what is allocated must not exceed the block.")
    }));
    cases.extend([2, 4, 8, 16, 17, 33, 65, 129].map(data_by_turns));
    cases
}

/// So many columns of one dtype and one length side by side, whose data stands in another order than their entries.
fn data_by_turns(count: u32) -> Case {
    let block = Block::new((0..count).map(|nth| f64s(&format!("c{nth}"), [f64::from(nth) + 0.5])).collect::<Vec<_>>());
    // The first changes places with the second, and so forth.
    let data: Vec<usize> = (0..block.data.len())
        .map(|nth| block.data.get(nth ^ 1).copied())
        .zip(&block.data)
        .map(|(other, own)| other.unwrap_or(*own))
        .collect();
    let (names, len) = (block.names.clone(), block.len);
    read(format!("data/by-turns/{count}"), &["NCP-BULK-021", "NCP-BULK-018"], &block.laid_out(&names, &data, len))
        .title(format!(
            "A block of {count} columns, each two of whose data have changed places, is read by its directory."
        ))
        .flags(&["trusted-lengths"])
        .because("A column's data is where its entry says, whatever the order of the data.")
}

fn empty_regions() -> Vec<Case> {
    let block = Block::new([f64s("times", [1.5]), f64s("values", [])]);
    let len = block.len;
    let at_the_end = block.clone().laid_out(&block.names, &[block.data[0], len], len);
    vec![
        read("empty/at-the-end", &["NCP-BULK-019"], &at_the_end)
            .title("A column without rows whose data begins at the block's end is read.")
            .flags(&["empty-blocks"])
            .because("A column may have no rows, and its data does not begin beyond the end."),
        rejected("empty/beyond-the-end", &["NCP-BULK-014"], &block.entry(1, Part::DataOff, len + 1))
            .title("A block with a column without rows whose data begins a byte beyond the end should be rejected.")
            .flags(&["trusted-lengths"])
            .because("An empty region begins beyond the buffer's end."),
        rejected("empty/far-beyond-the-end", &["NCP-BULK-014"], &block.entry(1, Part::DataOff, LARGEST))
            .title("A block with a column without rows whose data begins at 2^32 - 1 should be rejected.")
            .flags(&["trusted-lengths"])
            .because("An empty region begins beyond the buffer's end."),
    ]
}

/// Names that are not UTF-8.
fn name_bytes() -> Vec<Case> {
    let table: [(&str, &[u8], &str); 9] = [
        ("ff", b"\xffimes", "the byte FF"),
        ("lone-continuation", b"\x80imes", "a continuation byte alone"),
        ("latin-1", b"tim\xe9s", "an e acute in Latin-1"),
        ("truncated", b"time\xc3", "two bytes of which the second is missing"),
        ("cut-into-the-next", b"tim\xe2\x82", "three bytes of which the third is missing"),
        ("overlong", b"\xc0\x80mes", "U+0000 in two bytes"),
        ("surrogate", b"\xed\xa0\x80es", "the surrogate U+D800"),
        ("beyond-unicode", b"\xf4\x90\x80\x80s", "U+110000"),
        ("utf-16", b"t\0\xd8\0s", "a byte that UTF-8 does not have there"),
    ];
    let golden = golden();
    table
        .into_iter()
        .map(|(what, name, says)| {
            rejected(format!("utf-8/{what}"), &["NCP-BULK-010"], &golden.patched(0x2c, name))
                .title(format!("A block with a name that has {says} is rejected."))
                .flags(&["invalid-utf8"])
                .because("The name is not well-formed UTF-8.")
        })
        .collect()
}

/// What is wrong with the last of four columns, of which the first three are all that an observation has.
fn behind_an_observation() -> Vec<Case> {
    let block = Block::new([f64s("times", [0.5]), f64s("values", [1.5]), i64s("senders", [7]), f64s("more", [2.5])]);
    wrong_last(&block)
        .into_iter()
        .map(|wrong| wrong.case("behind-an-observation", "last column, behind times, values and senders,"))
        .collect()
}

/// A character of two bytes, of which each of two names that lie side by side has one.
fn divided_name() -> Case {
    let block = Block::new([f64s("ab", [1.5]), f64s("cd", [2.5])]);
    // The names lie one behind the other.
    let first = block.names.first().copied().unwrap_or_default();
    rejected("utf-8/divided", &["NCP-BULK-010"], &block.patched(first + 1, b"\xc3\xa9"))
        .title("A block in which two names have a byte each of one character is rejected.")
        .flags(&["invalid-utf8"])
        .because("Neither name is well-formed UTF-8, though the two in a row are.")
}

/// What is wrong with the last of many columns.
fn last_of_many() -> Vec<Case> {
    let mut cases = Vec::new();
    for count in [65, 300] {
        let block = Block::new((0..count).map(|nth| f32s(&format!("c{nth:03}"), [1.5])).collect::<Vec<_>>());
        let first_data = block.data.first().copied().unwrap_or_default();
        let overlap = Wrong {
            what: "overlap",
            rule: "NCP-BULK-012",
            flag: "overlapping-regions",
            says: "shares its data with the first",
            bytes: block.entry(count - 1, Part::DataOff, first_data),
        };
        let wrong = wrong_last(&block).into_iter().chain([overlap]);
        cases.extend(wrong.map(|wrong| wrong.case(&format!("last-of-{count}"), &format!("last column of {count}"))));
    }
    cases
}

/// A block in which one column is wrong.
struct Wrong {
    what: &'static str,
    rule: &'static str,
    flag: &'static str,
    says: &'static str,
    bytes: Vec<u8>,
}

impl Wrong {
    fn case(self, path: &str, column: &str) -> Case {
        rejected(format!("{path}/{}", self.what), &[self.rule], &self.bytes)
            .title(format!("A block whose {column} {} is rejected.", self.says))
            .flags(&[self.flag])
            .because("What a decoder has to see of one column it has to see of each.")
    }
}

/// A block, with what may be wrong with its last column whatever the others are.
fn wrong_last(block: &Block) -> [Wrong; 4] {
    let last = block.names.len() - 1;
    let name_at = block.names.last().copied().unwrap_or_default();
    let wrong = |what, rule, flag, says, bytes| Wrong { what, rule, flag, says, bytes };
    [
        wrong("dtype", "NCP-BULK-007", "unchecked-header", "has the dtype 9", block.entry(last, Part::Dtype, 9)),
        wrong("utf-8", "NCP-BULK-010", "invalid-utf8", "has a name that is not UTF-8", block.patched(name_at, b"\xff")),
        wrong(
            "name",
            "NCP-BULK-009",
            "unchecked-header",
            "has a name beyond the end",
            block.entry(last, Part::NameOff, block.len),
        ),
        wrong(
            "data",
            "NCP-BULK-011",
            "unchecked-header",
            "has data beyond the end",
            block.entry(last, Part::DataOff, block.len),
        ),
    ]
}
