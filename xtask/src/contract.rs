//! What of a contract that went out this one breaks: the check that sees what buf does not, against any contract.

use std::fs;
use std::path::Path;

use ncp_proto::compat::{self, Violation};
use serde_json::{Value, json};

use crate::Error;

/// Says what breaks an image and its projection, or the frozen contract; `false` if anything does.
///
/// # Errors
/// A file cannot be read.
pub(crate) fn report(against: Option<(&Path, &Path)>, as_json: bool) -> Result<bool, Error> {
    let found = match against {
        Some((image, projection)) => {
            let failed = |path: &Path| {
                let path = path.to_owned();
                |source| Error::File { path, source }
            };
            let image = fs::read(image).map_err(failed(image))?;
            compat::check_against(&image, &fs::read_to_string(projection).map_err(failed(projection))?)
        }
        None => compat::check_current(),
    };
    if as_json {
        println!("{:#}", Value::from_iter(found.iter().map(in_json)));
    } else {
        found.iter().for_each(|violation| println!("{violation}"));
        println!("{} breaking changes", found.len());
    }
    Ok(found.is_empty())
}

fn in_json(violation: &Violation) -> Value {
    let Violation { rule, place, was, is } = violation;
    json!({"rule": rule.code(), "place": place, "was": was, "is": is, "why": rule.why()})
}
