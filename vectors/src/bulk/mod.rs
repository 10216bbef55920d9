//! Area `bulk`: BulkBlocks, and the observations packed in them.

mod build;
mod directory;
mod encode;
mod header;
mod observation;
mod overlap;
mod values;

use crate::case::Case;
use crate::case::File;
use crate::case::Role::{self, Commander, Observer};
use crate::json::{Json, object};
use crate::template::Text;
use build::Block;

pub(crate) fn files() -> Vec<File> {
    vec![header::file(), directory::file(), overlap::file(), values::file(), encode::file(), observation::file()]
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
