//! Area `keys`: planes, key builders, segments, matching.

mod build;
mod matching;
mod planes;
pub(crate) mod segments;

use crate::case::File;

pub(crate) fn files() -> Vec<File> {
    let mut files = build::files();
    files.extend([matching::file(), planes::file()]);
    files
}
