//! Regions that share bytes, and regions that only touch.

use super::build::{Block, f32s, f64s, i32s, i64s};
use super::header::short_name;
use super::{advised, read, read_if_at_all, rejected};
use crate::case::{Case, File};

pub(super) fn file() -> File {
    let mut cases = shared();
    cases.extend(among_many());
    cases.extend(names_within_data());
    cases.extend(names_within_data_of_many());
    cases.extend(among_hundreds());
    cases.extend(amplified());
    cases.extend(apart());
    let about = "Regions of a BulkBlock that share bytes, which no block may have, and regions that only touch.";
    File::new("bulk", "overlap", about, cases)
}

/// Two columns of two doubles each, with room around every part: names at 48 and 56, data at 64
/// and 88, 112 bytes in all.
fn roomy() -> Block {
    Block::new([f64s("ab", [1.5, 2.5]), f64s("cd", [3.5, 4.5])]).laid_out(&[48, 56], &[64, 88], 112)
}

fn shared() -> Vec<Case> {
    let at = |names: [usize; 2], data: [usize; 2]| roomy().laid_out(&names, &data, 112).bytes();
    let one_row = |nth: usize, bytes: &[u8]| {
        // A single row, so that one region lies within the other.
        let mut bytes = bytes.to_vec();
        bytes[12 + 16 * nth + 8] = 1;
        bytes
    };
    let narrow = Block::new([f64s("ab", [1.5, 2.5]), f32s("cd", [3.5])]);
    let integers = Block::new([f64s("ab", [1.5]), i64s("cd", [7])]);
    let name_in_name = Block::new([f64s("abc", [1.5]), f64s("b", [2.5])]);
    let ends =
        |name: &str, at| Block::new([f64s("abc", [1.5]), f64s(name, [2.5])]).laid_out(&[44, at], &[48, 56], 64).bytes();
    let three = Block::new([f64s("ab", [1.5]), f64s("cd", [2.5]), f64s("ef", [3.5])]);
    let apart = Block::new([f64s("ab", [1.5, 2.5]), i32s("no", []), f64s("cd", [3.5])]);
    let table: Vec<(&str, Vec<u8>, &str)> = vec![
        (
            "data-data/first-and-third",
            three.clone().laid_out(&[60, 62, 64], &[72, 80, 72], 88).bytes(),
            "the data of the first of three columns and of the third",
        ),
        (
            "name-name/first-and-third",
            three.laid_out(&[60, 62, 60], &[72, 80, 88], 96).bytes(),
            "the names of the first of three columns and of the third",
        ),
        (
            "data-data/behind-an-empty-column",
            apart.clone().laid_out(&[60, 62, 64], &[72, 80, 80], 96).bytes(),
            "the data of two columns, with an empty column where the second begins,",
        ),
        (
            "data-data/around-an-empty-column",
            apart.laid_out(&[60, 62, 64], &[72, 76, 80], 96).bytes(),
            "the data of two columns, with an empty column within the first,",
        ),
        ("data-data/same", at([48, 56], [64, 64]), "the data of two columns at the same place"),
        (
            "data-data/same-of-other-dtype",
            integers.clone().laid_out(&[44, 46], &[48, 48], 56).bytes(),
            "the data of a column of doubles and of one of integers at the same place",
        ),
        (
            "data-data/by-one-byte",
            at([48, 56], [64, 79]),
            "the last byte of one column's data and the first of another's",
        ),
        (
            "data-data/by-one-byte-before",
            at([48, 56], [80, 65]),
            "the first byte of one column's data and the last of another's",
        ),
        ("data-data/by-one-row", at([48, 56], [64, 72]), "the last row of one column and the first of another"),
        ("data-data/within", one_row(1, &at([48, 56], [64, 68])), "the data of one column within another's"),
        ("data-data/around", one_row(0, &at([48, 56], [68, 64])), "the data of one column around another's"),
        (
            "data-data/same-beginning",
            one_row(1, &at([48, 56], [64, 64])),
            "the data of one column at the beginning of another's",
        ),
        ("data-data/same-end", one_row(1, &at([48, 56], [64, 72])), "the data of one column at the end of another's"),
        (
            "data-data/narrow-within-wide",
            narrow.clone().laid_out(&[44, 46], &[48, 52], 64).bytes(),
            "four bytes within the data of another column",
        ),
        ("name-name/same", at([48, 48], [64, 88]), "the names of two columns at the same place"),
        ("name-name/by-one-byte", at([48, 49], [64, 88]), "the last byte of one name and the first of another"),
        ("name-name/end", ends("c", 46), "a name and the end of another, which reads the same"),
        ("name-name/beginning", ends("ab", 44), "a name and the beginning of another, which reads the same"),
        ("name-name/letter", ends("a", 44), "a name and the first letter of another, which reads the same"),
        ("name-name/within", name_in_name.laid_out(&[44, 45], &[48, 56], 64).bytes(), "one name within another"),
        ("name-data/first-byte", at([48, 63], [64, 88]), "a name's last byte and the first of another column's data"),
        ("name-data/last-byte", at([79, 56], [64, 88]), "a name's first byte and the last of its column's own data"),
        ("name-data/other-column", at([48, 66], [64, 88]), "a name within another column's data"),
        ("name-header/magic", at([0, 56], [64, 88]), "a name and the magic"),
        ("name-header/last-byte", at([11, 56], [64, 88]), "a name's first byte and the header's last"),
        ("name-directory/first-entry", at([12, 56], [64, 88]), "a name and its own directory entry"),
        ("name-directory/last-byte", at([43, 56], [64, 88]), "a name's first byte and the directory's last"),
        ("data-header/magic", at([48, 56], [0, 88]), "a column's data and the header"),
        (
            "data-header/last-byte",
            one_row(0, &at([48, 56], [11, 88])),
            "a column's data from the header's last byte on",
        ),
        ("data-directory/first-entry", at([48, 56], [12, 88]), "a column's data and its own directory entry"),
        ("data-directory/last-entry", at([48, 56], [28, 88]), "a column's data and the entry of another column"),
        (
            "data-directory/last-byte",
            one_row(0, &at([52, 56], [43, 88])),
            "a column's data from the directory's last byte on",
        ),
        (
            "data-name/same",
            Block::new([f64s("position", [1.5])]).laid_out(&[28], &[28], 36).bytes(),
            "a column's data and its own name, which is as long and lies at the same place,",
        ),
        ("data-name/before", one_row(0, &at([48, 56], [45, 88])), "a column's data around its own name"),
        ("data-name/other-column", one_row(0, &at([48, 56], [50, 88])), "a column's data and another column's name"),
    ];
    table
        .into_iter()
        .map(|(what, bytes, says)| {
            rejected(what, &["NCP-BULK-012"], &bytes)
                .title(format!("A block in which {says} share a byte is rejected."))
                .flags(&["L01", "overlapping-regions"])
                .because("Header with directory, names and data are regions, and no two may share a byte.")
        })
        .collect()
}

/// Only the last two of many columns share bytes.
fn among_many() -> Vec<Case> {
    let block = |count: usize| {
        let columns: Vec<_> = (0..count).map(|nth| f64s(&short_name(nth), [1.5])).collect();
        Block::new(columns)
    };
    let mut cases = Vec::new();
    for count in [8, 9, 10, 17, 64] {
        let block = block(count);
        let (mut data, mut names) = (block.data.clone(), block.names.clone());
        data[count - 1] = data[count - 2];
        names[count - 1] = names[count - 2];
        for (part, bytes) in [
            ("data", block.clone().laid_out(&block.names, &data, block.len).bytes()),
            ("name", block.clone().laid_out(&names, &block.data, block.len).bytes()),
        ] {
            cases.push(
                rejected(format!("last-two-of/{count}-columns/{part}"), &["NCP-BULK-012"], &bytes)
                    .title(format!(
                        "A block of {count} columns in which only the {part} of the last two share bytes is rejected."
                    ))
                    .flags(&["L01", "overlapping-regions"])
                    .because("No two regions may share a byte, however many columns come before them."),
            );
        }
    }
    cases
}

/// A name that lies within the data of a column, whichever name it is and whichever data.
fn names_within_data() -> Vec<Case> {
    const WORDS: [[u8; 8]; 5] = [*b"abcdefgh", *b"ijklmnop", *b"qrstuvwx", *b"ABCDEFGH", *b"IJKLMNOP"];
    let mut cases = Vec::new();
    for (count, name, data) in [(3, 1, 0), (3, 1, 1), (3, 1, 2), (4, 2, 0), (5, 1, 4), (5, 2, 2), (5, 3, 0), (5, 3, 2)]
    {
        let words = WORDS.iter().take(count).enumerate();
        let columns = words.map(|(nth, word)| f64s(&short_name(nth), [f64::from_le_bytes(*word)]));
        let block = Block::new(columns.collect::<Vec<_>>());
        let mut names = block.names.clone();
        names[name] = block.data[data] + 3;
        let bytes = block.clone().laid_out(&names, &block.data, block.len).bytes();
        cases.push(
            rejected(format!("name-within-data/{name}-of-{count}-in-{data}"), &["NCP-BULK-012"], &bytes)
                .title(format!(
                    "A block of {count} columns in which the name of number {name} lies within the data of number \
                     {data} is rejected."
                ))
                .flags(&["L01", "overlapping-regions"])
                .because("No two regions may share a byte, whichever columns they are of."),
        );
    }
    cases
}

/// A name that lies within the data of a column, both of which stand among many.
fn names_within_data_of_many() -> Vec<Case> {
    let one = |(count, name, data): (usize, usize, usize)| {
        let column = |nth: usize| {
            // Letters that are no other name.
            let value = if nth == data { f32::from_le_bytes(*b"!?#=") } else { 1.5 };
            f32s(&short_name(nth), [value])
        };
        let block = Block::new((0..count).map(column).collect::<Vec<_>>());
        let mut names = block.names.clone();
        names[name] = block.data[data] + 1;
        let bytes = block.clone().laid_out(&names, &block.data, block.len).bytes();
        rejected(format!("name-within-data/of-{count}-columns/{name}-in-{data}"), &["NCP-BULK-012"], &bytes)
            .title(format!(
                "A block of {count} columns in which the name of number {name} lies within the data of number {data} \
                 is rejected."
            ))
            .flags(&["L01", "overlapping-regions"])
            .because("No two regions may share a byte, whichever columns they are of.")
    };
    let table =
        [(17, 2, 9), (33, 32, 0), (33, 1, 20), (40, 5, 5), (65, 64, 63), (65, 0, 64), (300, 1, 298), (300, 299, 8)];
    table.map(one).into()
}

/// Only two of hundreds of columns share bytes. The others have no rows, so that most of the block are its names.
fn among_hundreds() -> Vec<Case> {
    // Names that stay different from all others when the last one is written into another.
    let block = |count: usize| {
        let column = |nth: usize| match nth {
            0 => f32s("!?", []),
            _ if nth + 2 == count => f32s("!!", [1.5]),
            _ if nth + 1 == count => f32s("#=", [2.5]),
            _ => f32s(&short_name(nth), []),
        };
        Block::new((0..count).map(column).collect::<Vec<_>>())
    };
    let table = [
        (600, "data/last-two", "the data of the last two"),
        (600, "name/last-two", "the names of the last two"),
        (600, "name/first-and-last", "the names of the first and the last"),
        (1100, "name/last-two", "the names of the last two"),
        (4096, "data/directory", "the directory and the data of the last"),
    ];
    let one = |(count, what, says): (usize, &str, &str)| {
        let block = block(count);
        let (mut data, mut names) = (block.data.clone(), block.names.clone());
        match what {
            "data/last-two" => data[count - 1] = data[count - 2],
            "data/directory" => data[count - 1] = 12 + 16 * (count / 2),
            "name/last-two" => names[count - 1] = names[count - 2] + 1,
            _ => names[count - 1] = names[0] + 1,
        }
        let len = block.len;
        rejected(format!("of-{count}-columns/{what}"), &["NCP-BULK-012"], &block.laid_out(&names, &data, len).bytes())
            .title(format!("A block of {count} columns of which only {says} share a byte is rejected."))
            .flags(&["L01", "overlapping-regions"])
            .because("No two regions may share a byte, however many columns there are.")
    };
    table.into_iter().map(one).collect()
}

/// Many columns over the same bytes.
fn amplified() -> Vec<Case> {
    let shared = |count: usize, rows: usize| {
        let names: Vec<String> = (0..count).map(short_name).collect();
        let columns: Vec<_> = names.iter().map(|name| f64s(name, [])).collect();
        let block = Block::new(columns);
        let begin = block.len.next_multiple_of(8);
        let len = begin + 8 * rows;
        let block = block.clone().laid_out(&block.names, &vec![begin; count], len);
        let mut bytes = block.bytes();
        for nth in 0..count {
            let at = 12 + 16 * nth + 8;
            bytes[at..at + 4].copy_from_slice(&super::build::le32(rows));
        }
        bytes
    };
    [(16, 16), (256, 256), (4096, 512)]
        .into_iter()
        .map(|(count, rows)| {
            let bytes = shared(count, rows);
            rejected(format!("amplified/{count}-columns"), &["NCP-BULK-012", "NCP-BULK-024"], &bytes)
                .title(format!(
                    "A block of {} bytes in which {count} columns share {rows} doubles is rejected.",
                    bytes.len()
                ))
                .flags(&["L01", "amplification"])
                .because(format!(
                    "Copied, the columns would take {} bytes; that is what the rule against overlaps is for.",
                    8 * count * rows
                ))
        })
        .collect()
}

/// Regions that share nothing.
fn apart() -> Vec<Case> {
    let touching = Block::new([f64s("ab", [1.5, 2.5]), f64s("cd", [3.5, 4.5])]).laid_out(&[44, 46], &[48, 64], 80);
    let three = Block::new([i32s("a", [1]), i32s("b", [2]), i32s("c", [3])]).laid_out(&[60, 61, 62], &[71, 63, 67], 75);
    let mut cases = vec![
        read("apart/touching", &["NCP-BULK-018", "NCP-BULK-012"], &touching)
            .title("A block whose regions follow each other without a gap is read.")
            .flags(&["over-strict"])
            .because("Regions that touch share no byte."),
        read("apart/touching-in-another-order", &["NCP-BULK-018", "NCP-BULK-021"], &three)
            .title(
                "A block whose columns lie without a gap in another order than the directory's is read, in the \
                    directory's order.",
            )
            .flags(&["fixed-layout"])
            .because("Regions that touch share no byte, and the directory gives the order."),
    ];
    let empty = Block::new([f64s("ab", [1.5, 2.5]), f64s("cd", [])]);
    let empty = empty.laid_out(&[48, 56], &[64, 88], 112);
    let place = |at: usize| empty.clone().laid_out(&[48, 56], &[64, at], 112);
    cases.push(
        read("apart/empty-within-data", &["NCP-BULK-019", "NCP-BULK-012"], &place(70))
            .title("A block with a column without rows whose data begins within another column's data is read.")
            .flags(&["empty-blocks"])
            .because("An empty region shares no byte with anything."),
    );
    for (what, advice, at, says) in [
        ("header", Some("NCP-BULK-028"), 0, "the header"),
        ("directory", None, 20, "the directory"),
        ("name", None, 49, "another column's name"),
        ("own-name", None, 57, "its own name"),
    ] {
        let says = format!("with a column without rows whose data begins within {says}");
        cases.extend(lenient(&format!("empty-within-{what}"), advice, &place(at), &says));
    }
    let unnamed = Block::new([f64s("", [1.5, 2.5]), f64s("cd", [3.5])]);
    for (what, advice, at, says) in [
        ("behind-the-directory", Some("NCP-BULK-027"), 44, "behind the directory"),
        ("header", None, 0, "within the header"),
        ("data", None, 70, "within its own data"),
        ("end", None, 96, "at the block's end"),
    ] {
        let place = unnamed.clone().laid_out(&[at, 56], &[64, 88], 96);
        let says = format!("with a column of an empty name that begins {says}");
        cases.extend(lenient(&format!("empty-name-{what}"), advice, &place, &says));
    }
    cases
}

/// A block with a region of no bytes, where a decoder may not want one.
fn lenient(what: &str, advice: Option<&'static str>, block: &Block, says: &str) -> Vec<Case> {
    let case = read_if_at_all(format!("apart/{what}"), block, says);
    let advised = advice.map(|rule| advised(format!("apart/{what}/advised"), rule, block, says));
    let cases = [case].into_iter().chain(advised);
    cases.map(|case| case.flags(&["empty-blocks"])).collect()
}
