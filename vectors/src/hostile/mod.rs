//! Area `hostile`: bytes that are no frame, and frames that are too large, too deep or too wide.

mod encoding;
mod grammar;
mod limits;

use crate::case::File;
use crate::scenario::ScenarioError;

pub(crate) fn files() -> Result<Vec<File>, ScenarioError> {
    Ok(vec![encoding::file(), grammar::structure_file()?, grammar::token_file()?, limits::file()])
}

/// Kinds that between them every role reads: where nothing but the bytes matters, one of each.
const CARRIERS: [&str; 2] = ["capabilities", "close_session"];

/// The frame with a member more, whose text is put in as it is.
fn with_raw(frame: &str, member: &str) -> String {
    match frame.strip_suffix('}') {
        Some(open) => format!("{open},{member}}}"),
        None => frame.to_owned(),
    }
}
