//! Area `keys`: planes, key builders, segments, matching.

mod build;
mod matching;
mod planes;
pub(crate) mod segments;

use crate::case::File;
use crate::scenario::ScenarioError;

pub(crate) fn files() -> Result<Vec<File>, ScenarioError> {
    let mut files = build::files()?;
    files.extend([matching::file()?, planes::file()?]);
    Ok(files)
}
