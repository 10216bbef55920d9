//! Area `version`: the version guard, the contract hash, negotiation.

mod contract;
mod guard;

use crate::case::File;
use crate::scenario::ScenarioError;
pub(crate) use guard::{MALFORMED, malformed};

pub(crate) fn files() -> Result<Vec<File>, ScenarioError> {
    let mut files = vec![guard::file()?];
    files.extend(contract::files()?);
    Ok(files)
}
