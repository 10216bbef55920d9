//! Cases that differ in their number alone.

use std::path::Path;

use serde_json::{Value, json};

use crate::made;

/// A folder of vectors that asks for the versions 9.0 to 9.n, less one.
pub(crate) fn many(folder: &Path, n: usize) -> String {
    let case = |i: usize| {
        json!({
            "id": format!("version/many/{i}"), "title": "Another version is incompatible.", "why": "W.",
            "requirements": ["NCP-VER-004"], "flags": ["lenient-reader"], "roles": ["body"], "call": "version.check",
            "args": {"version": format!("9.{i}"), "strict": false},
            "expect": {"relation": "json", "value": {"compatible": false}}
        })
    };
    let cases: Vec<Value> = (0..n).map(case).collect();
    made::vectors(folder, "version", "many", "lenient-reader", &cases)
}
