//! The corpus as it lies on disk. A test of `corpus.rs` holds it against what the generator makes: to make it takes
//! long, and each test is a process of its own.

use std::fs;
use std::path::Path;

/// Every file that the manifest lists, by its path within the corpus, with its text.
pub(crate) fn corpus() -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let list = fs::read_to_string(root.join("MANIFEST.sha256")).expect("the corpus has a manifest");
    let paths = list.lines().filter_map(|line| line.split_once("  corpus/")).map(|(_, path)| path.to_owned());
    let read = |path: String| {
        let text = fs::read_to_string(root.join("corpus").join(&path)).expect("a file of the manifest is there");
        (path, text)
    };
    paths.map(read).collect()
}
