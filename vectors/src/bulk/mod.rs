//! Area `bulk`: BulkBlocks, and the observations packed in them.

mod build;
mod directory;
mod encode;
mod header;
mod observation;
mod overlap;
mod values;

use std::collections::BTreeMap;

use crate::case::Case;
use crate::case::File;
use crate::case::Role::{self, Commander, Observer};
use crate::json::{Json, object};
use crate::template::Text;
use build::Block;

pub(crate) fn files() -> Vec<File> {
    let read = [header::file(), directory::file(), overlap::file(), values::file()];
    let observation = observation::file(read.iter().flat_map(not_unpacked).collect());
    read.into_iter().chain([encode::file(), observation]).collect()
}

/// The blocks of a file that a decoder must reject, as unpacking is given them: all whose length is wrong, for which
/// another road may care less, and some for every other rule.
fn not_unpacked(file: &File) -> Vec<Case> {
    const ADVICE: [&str; 3] = ["NCP-BULK-008", "NCP-BULK-013", "NCP-BULK-014"];
    // Which the observations have a case of.
    const ASKED: &str = "total-len/more-by-1";
    let mut asked: BTreeMap<&str, usize> = BTreeMap::new();
    let mut cases = Vec::new();
    for case in file.cases.iter().filter(|case| case.expect.get("reject").is_some()) {
        let rule = case.requirements.first().copied().unwrap_or_default();
        let before = asked.entry(rule).or_default();
        // All of those, too, that unpacking might not come to.
        let is_last = case.path.starts_with("behind-an-observation/");
        let most = if rule == "NCP-BULK-005" || is_last { usize::MAX } else { 4 };
        let is_small = case.args.get("block").and_then(Json::as_str).is_some_and(|block| block.len() < 400);
        if case.path == ASKED || ADVICE.contains(&rule) || *before == most || !is_small {
            continue;
        }
        *before += 1;
        let path = format!("unpack/block/{}/{}", file.name, case.path);
        let case = Case { path, call: "observation.unpack", requirements: vec![rule], ..case.clone() };
        let title = case.title.replace("is rejected", "is not unpacked either");
        cases.push(case.title(title).because("Unpacking decodes first: what a decoder has to reject, it rejects."));
    }
    cases
}

/// The roles that read blocks.
const READERS: &[Role] = &[Commander, Observer];

/// A `bulk.decode` that still lacks its answer.
fn decode(what: impl Into<String>, rules: &[&'static str], bytes: &[u8]) -> Case {
    Case::new(what, rules, READERS).call("bulk.decode", object! { "block" => Text::base64_of(bytes) })
}

/// A block that is rejected.
fn rejected(what: impl Into<String>, rules: &[&'static str], bytes: &[u8]) -> Case {
    decode(what, rules, bytes).rejects("block")
}

/// A block that is read as its columns.
fn read(what: impl Into<String>, rules: &[&'static str], block: &Block) -> Case {
    decode(what, rules, &block.bytes()).gives(object! { "columns" => block.columns() })
}

/// A block that is read as its columns, or refused.
fn read_if_at_all(what: impl Into<String>, block: &Block, says: &str) -> Case {
    decode(what, &["NCP-BULK-021", "NCP-BULK-023"], &block.bytes())
        .shows_or_refuses(object! { "columns" => block.columns() })
        .title(format!("A block {says} is rejected, or read as it is."))
        .because("A decoder that takes the block gives the columns of the directory.")
}

/// A block that should be read.
fn advised(what: impl Into<String>, rule: &'static str, block: &Block, says: &str) -> Case {
    read(what, &[rule], block)
        .title(format!("A block {says} should be read."))
        .because("A decoder should go by the directory alone.")
}

/// Columns as the calls take and give them.
fn columns_json(columns: &[build::Column]) -> Json {
    columns
        .iter()
        .map(|column| {
            object! {
                "name" => column.name.as_str(),
                "dtype" => column.values.dtype(),
                "data" => column.values.json(),
            }
        })
        .collect()
}

/// A list of so many equal items.
fn many(item: Json, times: usize) -> Json {
    Json::Array(vec![object! { "$item" => item, "times" => Json::literal(times.to_string()) }])
}
