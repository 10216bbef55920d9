//! Folders of vectors that a test makes for itself.

#![expect(clippy::unwrap_used, reason = "a test may fail that way")]

use std::path::Path;

use serde_json::{Value, json};

/// A folder of one file, `area/name`, with cases that all carry a flag; its path.
pub(crate) fn vectors(folder: &Path, area: &str, name: &str, flag: &str, cases: &[Value]) -> String {
    let file = json!({"format": 1, "area": area, "name": name, "about": "A.", "notes": {flag: "N."}, "cases": cases});
    let vectors = folder.join("vectors");
    std::fs::create_dir_all(vectors.join(area)).unwrap();
    std::fs::write(vectors.join(area).join(format!("{name}.json")), file.to_string()).unwrap();
    vectors.display().to_string()
}
