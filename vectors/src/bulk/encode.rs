//! What encoders of blocks write, and what they refuse.

use super::build::{Block, Column, f32s, f64s, golden, i32s, i64s};
use super::columns_json;
use super::values::extreme_columns;
use crate::case::Role::Server;
use crate::case::{Case, File};
use crate::json::{Json, object};
use crate::template::Text;

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
        ("many".to_owned(), many, "Twenty columns".to_owned()),
        ("long".to_owned(), vec![f64s("a", long)], "A column of a thousand rows".to_owned()),
        (
            "odd-bytes".to_owned(),
            vec![f32s("abc", [1.5]), i32s("d", [1, 2, 3]), f64s("efghi", [2.5])],
            "Columns of which no part ends at a multiple of eight".to_owned(),
        ),
    ]);
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
    let long_name = named(Text::repeat("x", 65535));
    cases.push(
        encode("round-trip/longest-name", &["NCP-BULK-030"], long_name.clone())
            .gives_columns(long_name)
            .title("A column with a name of 65,535 bytes is written as a block that holds just that.")
            .flags(&["low-limits"])
            .because("The field name_len has 16 bits, so the name fits."),
    );
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

fn refused() -> Vec<Case> {
    let column = |name: String| object! { "name" => name, "dtype" => "f32", "data" => Json::Array(Vec::new()) };
    let many: Json = (0..4097).map(|nth| column(format!("{nth:x}"))).collect();
    let mut cases = vec![
        encode("refused/4097-columns", &["NCP-BULK-031"], many)
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
            encode(format!("refused/{what}"), &["NCP-BULK-031"], named(Text::repeat("x", bytes)))
                .rejects("block")
                .title(format!("A name of {bytes} bytes, {says}, is refused."))
                .flags(&["L21", "truncated-counts"])
                .because("The field name_len has 16 bits, and a length that does not fit is an error, never cut."),
        );
    }
    cases.push(
        encode("refused/name-of-32769-characters", &["NCP-BULK-031"], named(Text::repeat("\u{e9}", 32_769)))
            .rejects("block")
            .title("A name of 65,538 bytes in 32,769 characters is refused.")
            .flags(&["L21", "bytes-not-characters"])
            .because("The field name_len counts bytes."),
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

/// One column of one value with that name.
fn named(name: Text) -> Json {
    let column = object! { "name" => name, "dtype" => "f64", "data" => Json::Array(vec![Json::literal("1.5")]) };
    Json::Array(vec![column])
}
