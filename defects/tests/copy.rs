//! Copies: what is copied, and what is refused.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;

use ncp_defects::copy::{CopyError, planted};
use ncp_defects::{Defect, read};
use tempfile::TempDir;

const SOURCE: &str = "fn f() -> bool {\n    a < b\n}\n\n#[cfg(test)]\nmod tests {\n    use super::f;\n}\n";

/// A tree with a folder of two sources, and a defect of one file.
fn tree(file: &str, code: &str) -> (TempDir, Defect) {
    let tree = tempfile::tempdir().unwrap();
    fs::create_dir_all(tree.path().join("src/part")).unwrap();
    fs::write(tree.path().join("src/part/mod.rs"), "mod f;\n").unwrap();
    fs::write(tree.path().join("src/part/f.rs"), SOURCE).unwrap();
    let table = format!(
        "[[defect]]\nname = \"late\"\nabout = \"It is late.\"\n\
         [[defect.edit]]\nfile = \"{file}\"\ncode = \"{code}\"\nwith = \"a <= b\"\n"
    );
    fs::write(tree.path().join("table.toml"), table).unwrap();
    let defect = read(&tree.path().join("table.toml")).unwrap().remove(0);
    (tree, defect)
}

#[test]
fn a_folder_is_copied_with_the_defect_and_without_unit_tests() {
    let (tree, defect) = tree("src/part/f.rs", "a < b");
    let copy = planted(tree.path(), "src/part", &tree.path().join("out"), &defect).unwrap();
    assert_eq!(copy, tree.path().join("out/part"));
    assert_eq!(fs::read_to_string(copy.join("mod.rs")).unwrap(), "mod f;\n");
    assert_eq!(fs::read_to_string(copy.join("f.rs")).unwrap(), "fn f() -> bool {\n    a <= b\n}\n");
}

#[test]
fn a_file_is_copied_alone() {
    let (tree, defect) = tree("src/part/f.rs", "a < b");
    let copy = planted(tree.path(), "src/part/f.rs", &tree.path().join("out"), &defect).unwrap();
    assert_eq!(copy, tree.path().join("out/f.rs"));
    assert!(fs::read_to_string(copy).unwrap().contains("a <= b"));
}

#[test]
fn a_defect_without_a_place_in_the_sources_is_refused() {
    let (tree, defect) = tree("src/part/f.rs", "b < a");
    let refused = planted(tree.path(), "src/part", &tree.path().join("out"), &defect);
    assert!(matches!(refused, Err(CopyError::Place(_))), "{refused:?}");
    let (tree, defect) = self::tree("src/other.rs", "a < b");
    let refused = planted(tree.path(), "src/part", &tree.path().join("out"), &defect);
    assert!(matches!(refused, Err(CopyError::Elsewhere { .. })), "{refused:?}");
}
