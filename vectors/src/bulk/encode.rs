//! What encoders of blocks write, and what they refuse.

use super::build::{Block, Column, f32s, f64s, golden, i32s, i64s, number};
use super::directory::ALIKE;
use super::values::extreme_columns;
use super::{columns_json, many};
use crate::case::Role::Server;
use crate::case::{Case, File};
use crate::json::{Json, object};
use crate::names;
use crate::template::Text;
use crate::trace::{any, some_text};

pub(super) fn file() -> File {
    let mut cases = vec![
        encode("golden", &["NCP-BULK-035", "NCP-BULK-032"], golden().columns())
            .gives_bytes(&golden().bytes())
            .title("The columns of the golden block are written as its 104 bytes.")
            .flags(&["byte-order"])
            .because("The text prints the bytes."),
    ];
    cases.extend(round_trips());
    cases.extend(alignment());
    cases.extend(rounded());
    cases.extend(long());
    cases.extend(refused());
    File::new("bulk", "encode", "What an encoder of BulkBlocks writes, and what it refuses.", cases)
}

fn encode(what: impl Into<String>, rules: &[&'static str], columns: Json) -> Case {
    Case::new(what, rules, &[Server]).call("bulk.encode", object! { "columns" => columns })
}

fn round_trips() -> Vec<Case> {
    let mut table: Vec<(String, Vec<Column>, String)> = extreme_columns()
        .into_iter()
        .map(|(what, column, says)| (what.to_owned(), vec![column], format!("A column of {says}")))
        .collect();
    let many: Vec<Column> = (0..20).map(|nth| f64s(&format!("column {nth}"), [f64::from(nth)])).collect();
    let long: Vec<f64> = (0..1000).map(|nth| f64::from(nth) * 0.1).collect();
    table.extend([
        ("no-columns".to_owned(), vec![], "No column at all".to_owned()),
        (
            "no-rows".to_owned(),
            vec![f32s("a", []), f64s("b", []), i32s("c", []), i64s("d", [])],
            "Columns of each dtype without rows".to_owned(),
        ),
        (
            "no-rows-among-others".to_owned(),
            vec![f64s("a", [1.5]), f64s("b", []), f64s("c", [2.5])],
            "A column without rows among others".to_owned(),
        ),
        (
            "each-dtype".to_owned(),
            vec![f32s("a", [1.5]), f64s("b", [2.5]), i32s("c", [3]), i64s("d", [4])],
            "A column of each dtype".to_owned(),
        ),
        (
            "other-lengths".to_owned(),
            vec![f64s("a", [1.5]), f64s("b", [2.5, 3.5, 4.5]), i32s("c", [5, 6])],
            "Columns of different lengths".to_owned(),
        ),
        (
            "unsorted".to_owned(),
            vec![f64s("z", [1.5]), f64s("a", [2.5]), f64s("9", [3.5]), f64s("10", [4.5])],
            "Columns whose names are not sorted".to_owned(),
        ),
        (
            "names".to_owned(),
            vec![f64s("caf\u{e9}", [1.5]), f64s("\u{1f9e0}", [2.5]), f64s("__proto__", [3.5])],
            "Columns whose names are not in ASCII".to_owned(),
        ),
        (
            "values-alike".to_owned(),
            vec![
                f64s("a", [0.0]),
                f64s("b", [-0.0]),
                f64s("c", [0.0, -0.0]),
                f64s("d", [-0.0, 0.0]),
                f32s("e", [0.0]),
                f32s("f", [-0.0]),
                i32s("g", [0]),
                i64s("h", [0]),
                f64s("i", [1.0]),
                f32s("j", [1.0]),
                i32s("k", [1]),
                i64s("l", [1]),
            ],
            "Columns whose values are equal as numbers".to_owned(),
        ),
        ("many".to_owned(), many, "Twenty columns".to_owned()),
        (
            "name-at-the-end-of-another".to_owned(),
            vec![f64s("V_m", [1.5]), f64s("m", [2.5])],
            "A column whose name ends that of the one before".to_owned(),
        ),
        (
            "name-at-the-beginning-of-another".to_owned(),
            vec![f64s("senders", [1.5]), f64s("send", [2.5])],
            "A column whose name begins that of the one before".to_owned(),
        ),
        (
            "name-within-a-later-one".to_owned(),
            vec![f64s("e", [1.5]), i64s("times", [2]), f32s("im", [3.5])],
            "Columns whose names stand within a later and an earlier one".to_owned(),
        ),
        (
            "name-across-two-others".to_owned(),
            vec![f64s("ab", [1.5]), f64s("cd", [2.5]), f64s("bc", [3.5]), f64s("abcd", [4.5])],
            "Columns whose names stand across two others side by side".to_owned(),
        ),
        (
            "names-of-one-letter".to_owned(),
            (1..=12).rev().map(|times| f64s(&"a".repeat(times), [1.5])).collect(),
            "Twelve columns whose names are one letter ever fewer times".to_owned(),
        ),
        (
            "name-in-the-header".to_owned(),
            vec![f64s("NCPB", [1.5]), f64s("CP", [2.5]), f64s("\u{1}", [3.5])],
            "Columns whose names are bytes of the header".to_owned(),
        ),
        (
            "name-of-a-part-of-characters".to_owned(),
            vec![f64s("a\u{e9}", [1.5]), f64s("\u{e9}", [2.5]), f64s("\u{1f9e0}\u{e9}a", [3.5])],
            "Columns whose names share characters of several bytes".to_owned(),
        ),
        (
            "name-in-the-data".to_owned(),
            vec![i64s("abcdefgh", [0x6867_6665_6463_6261]), i32s("cdef", [0x6665_6463]), f64s("z", [1.5])],
            "Columns whose names are also the bytes of their values".to_owned(),
        ),
        ("long".to_owned(), vec![f64s("a", long)], "A column of a thousand rows".to_owned()),
        (
            "odd-bytes".to_owned(),
            vec![f32s("abc", [1.5]), i32s("d", [1, 2, 3]), f64s("efghi", [2.5])],
            "Columns of which no part ends at a multiple of eight".to_owned(),
        ),
    ]);
    let all = (1_u32..).zip(names::alike()).map(|(nth, (name, _))| f64s(name, [f64::from(nth)]));
    table.push(("names-alike/all".to_owned(), all.collect(), "Columns whose names are alike".to_owned()));
    table.extend(ALIKE.map(|(what, [one, other], says)| {
        let columns = vec![f64s(one, [1.5]), f64s(other, [2.5])];
        (format!("names-alike/{what}"), columns, format!("Two columns whose names differ {says}"))
    }));
    table.extend(["ab\0", " a\n"].into_iter().enumerate().map(|(nth, name)| {
        let says = "A column whose name begins or ends with U+0000, a space or a line feed";
        (format!("name-of-white-space/{nth}"), vec![f64s(name, [1.5])], format!("{says} ({nth})"))
    }));
    let mut cases: Vec<Case> = table
        .into_iter()
        .map(|(what, columns, says)| {
            let columns = columns_json(&columns);
            encode(format!("round-trip/{what}"), &["NCP-BULK-030"], columns.clone())
                .gives_columns(columns)
                .title(format!("{says} is written as a block that holds just that."))
                .flags(&["lossy-blocks"])
                .because("A decoder by the rules accepts the block, and it holds the same columns in the same order.")
        })
        .collect();
    for (what, name, says) in [
        (
            "two",
            Text::concat([Text::repeat("\u{e9}", 32_767), "x".into()]),
            "32,768 characters of two bytes, but for one",
        ),
        ("three", Text::repeat("\u{20ac}", 21_845), "21,845 characters of three bytes"),
        (
            "four",
            Text::concat([Text::repeat("\u{1f681}", 16_383), "\u{20ac}".into()]),
            "16,384 characters of four bytes, but for one",
        ),
    ] {
        let columns = named([name]);
        cases.push(
            encode(format!("round-trip/longest-name-of-{what}-bytes"), &["NCP-BULK-030"], columns.clone())
                .gives_columns(columns)
                .title(format!(
                    "A column with a name of 65,535 bytes, {says}, is written as a block that holds just that."
                ))
                .flags(&["low-limits", "bytes-not-characters"])
                .because("The field name_len has 16 bits and counts bytes, so the name fits."),
        );
    }
    let table = [
        (
            "longest-name",
            named([Text::repeat("x", 65535)]),
            "A column with a name of 65,535 bytes is written as a block that holds just that.",
            "The field name_len has 16 bits, so the name fits.",
        ),
        (
            "names-of-80001-bytes",
            named([Text::repeat("x", 40_000), Text::repeat("y", 40_001)]),
            "Two columns whose names have 80,001 bytes together are written as a block that holds just them.",
            "The length of each name has 16 bits, and nothing bounds that of all together but the block.",
        ),
        (
            "names-of-120005-bytes",
            named([Text::repeat("x", 40_000), Text::repeat("y", 40_001), Text::repeat("z", 40_003), "a".into()]),
            "Four columns of which the names of three have 120,004 bytes together are written as a block that holds \
             just them.",
            "The length of each name has 16 bits, and where it begins has 32.",
        ),
    ];
    cases.extend(table.map(|(what, columns, title, why)| {
        encode(format!("round-trip/{what}"), &["NCP-BULK-030"], columns.clone())
            .gives_columns(columns)
            .title(title)
            .flags(&["low-limits"])
            .because(why)
    }));
    cases
}

fn alignment() -> Vec<Case> {
    let table = [
        ("names-of-three-bytes", vec![f64s("abc", [1.5]), f64s("d", [2.5])]),
        ("odd-f32", vec![f32s("a", [1.5]), f64s("b", [2.5])]),
        ("odd-i32", vec![i32s("a", [1, 2, 3]), i64s("b", [4]), f32s("c", [5.5])]),
    ];
    table
        .into_iter()
        .map(|(what, columns)| {
            let block = Block::new(columns);
            encode(format!("alignment/{what}"), &["NCP-BULK-033"], block.columns())
                .gives_bytes(&block.bytes())
                .title("A column's data should begin at the next multiple of eight, behind zeros.")
                .flags(&["alignment"])
                .because("Then a reader can use the values where they lie.")
        })
        .collect()
}

/// Numbers that are no f32.
fn rounded() -> Vec<Case> {
    let table: [(&str, &[f64], &str); 4] = [
        ("tenths", &[0.7, 0.1, -0.1, 1e10, -65.3], "numbers of few digits"),
        ("ties", &[16_777_217.0, 16_777_219.0, -16_777_217.0, 1.0 + 2.0_f64.powi(-24)], "numbers halfway between two"),
        (
            "next-to-ties",
            &[1.000_000_059_604_645, 1.000_000_059_604_644_5, 16_777_219.000_000_004],
            "numbers next to halfway between two",
        ),
        ("small", &[1e-46, -1e-46, 7.1e-46, 1e-40, 1.175_494_3e-38], "numbers below the least normal one"),
    ];
    let one = |(what, values, says): (&str, &[f64], &str)| {
        #[expect(clippy::cast_possible_truncation, reason = "it rounds to the nearest, ties to even")]
        let nearest: Vec<f32> = values.iter().map(|value| *value as f32).collect();
        // Its name ends where data may begin for all who align it by up to 32 bytes.
        let block = Block::new([f32s("data", nearest)]);
        let further = [64, 128].map(|at| block.clone().laid_out(&block.names, &[at], at + 4 * values.len()));
        let bytes = std::iter::once(&block).chain(&further).map(|block| Text::base64_of(&block.bytes()).json());
        let column = object! { "name" => "data", "dtype" => "f32",
        "data" => values.iter().copied().map(number).collect::<Json>() };
        encode(format!("rounded/{what}"), &["NCP-BULK-030"], Json::Array(vec![column]))
            .shows_or_refuses(object! { "block" => any(bytes.collect()) })
            .title(format!("A column of f32 that is given {says} is refused, or holds the nearest f32, ties to even."))
            .flags(&["lossy-doubles"])
            .because("A number that is none of the dtype's may be refused, or be written as the nearest one.")
    };
    table.map(one).into()
}

/// Columns of many rows.
fn long() -> Vec<Case> {
    let mut cases: Vec<Case> = [("i32", 262_145), ("f64", 262_145)]
        .into_iter()
        .map(|(dtype, rows)| {
            let column = object! { "name" => "v", "dtype" => dtype, "data" => many(Json::literal("0"), rows) };
            let columns = Json::Array(vec![column]);
            encode(format!("round-trip/long/{dtype}"), &["NCP-BULK-030"], columns.clone())
                .gives_columns(columns)
                .title(format!("A column of {rows} rows of {dtype} is written as a block that holds just that."))
                .flags(&["low-limits"])
                .because("A block may have 64 MiB; a column has no limit of its own.")
        })
        .collect();
    // A writer that saves room would write equal data once, and let both entries name it.
    let column = |name: &str, dtype: &str| {
        object! { "name" => name, "dtype" => dtype, "data" => many(Json::literal("0"), 3_000) }
    };
    let columns = || Json::Array(vec![column("a", "f64"), column("b", "i32"), column("c", "f64"), column("d", "i32")]);
    cases.push(
        encode("round-trip/long/equal-columns", &["NCP-BULK-030"], columns())
            .gives_columns(columns())
            .title("Columns of 3,000 rows whose data is equal in pairs are written as a block that holds just that.")
            .flags(&["overlapping-regions"])
            .because("A decoder by the rules accepts the block, and so no two regions of it share a byte."),
    );
    cases
}

fn refused() -> Vec<Case> {
    let column = |name: String| object! { "name" => name, "dtype" => "f32", "data" => Json::Array(Vec::new()) };
    // Names whose numbers grow as a run writes them.
    let columns = |count: usize| (0..count).map(|nth| column(format!("{{\"c\":{nth}}}"))).collect::<Json>();
    let mut cases = vec![
        encode("written/4096-columns", &["NCP-BULK-030"], columns(4096))
            .shows(object! { "block" => some_text() })
            .title("4,096 columns are written.")
            .flags(&["low-limits"])
            .because("A block may have 4,096 columns, so a decoder by the rules accepts the block."),
        encode("refused/4097-columns", &["NCP-BULK-031"], columns(4097))
            .rejects("limit")
            .title("4,097 columns are refused.")
            .flags(&["L21", "truncated-counts"])
            .because("A block may have 4,096 columns, and a count beyond a limit is an error."),
    ];
    for (what, bytes, says) in [
        ("name-of-65536-bytes", 65_536, "which 16 bits wrap to 0"),
        ("name-of-65537-bytes", 65_537, "which 16 bits wrap to 1"),
        ("name-of-131072-bytes", 131_072, "twice what 16 bits hold"),
    ] {
        cases.push(
            encode(format!("refused/{what}"), &["NCP-BULK-031"], named([Text::repeat("x", bytes)]))
                .rejects("block")
                .title(format!("A name of {bytes} bytes, {says}, is refused."))
                .flags(&["L21", "truncated-counts"])
                .because("The field name_len has 16 bits, and a length that does not fit is an error, never cut."),
        );
    }
    for (times, character, shown, bytes) in [
        (32_768, "\u{e9}", "32,768", "65,536"),
        (32_769, "\u{e9}", "32,769", "65,538"),
        (21_846, "\u{20ac}", "21,846", "65,538"),
        (16_384, "\u{1f681}", "16,384", "65,536"),
        (21_845, "\u{1f681}", "21,845", "87,380"),
    ] {
        let of = character.len();
        let name = match of {
            2 => format!("refused/name-of-{times}-characters"),
            _ => format!("refused/name-of-{times}-characters-of-{of}"),
        };
        cases.push(
            encode(name, &["NCP-BULK-031"], named([Text::repeat(character, times)]))
                .rejects("block")
                .title(format!("A name of {bytes} bytes in {shown} characters is refused."))
                .flags(&["L21", "bytes-not-characters"])
                .because("The field name_len counts bytes."),
        );
    }
    // The values alone are 64 MiB, to which the header and the directory come.
    let values = many(Json::literal("0"), 8_388_608);
    let long = object! { "name" => "v", "dtype" => "f64", "data" => values };
    cases.push(
        encode("refused/more-than-64-mib", &["NCP-BULK-031"], Json::Array(vec![long]))
            .rejects("limit")
            .title("A column of 8,388,608 doubles is refused: no decoder accepts a block of more than 64 MiB.")
            .flags(&["L21", "truncated-counts"])
            .because("A block may have 64 MiB, and a length beyond a limit is an error."),
    );
    let twice = columns_json(&[f64s("times", [1.5]), f64s("times", [2.5])]);
    cases.push(
        encode("refused/repeated-name", &["NCP-BULK-034"], twice)
            .rejects("block")
            .title("Two columns of one name should be refused.")
            .flags(&["duplicate-columns"])
            .because("Decoders should reject such a block."),
    );
    cases
}

/// Columns of one value with those names.
fn named<const N: usize>(names: [Text; N]) -> Json {
    let column =
        |name: Text| object! { "name" => name, "dtype" => "f64", "data" => Json::Array(vec![Json::literal("1.5")]) };
    names.map(column).into_iter().collect()
}
