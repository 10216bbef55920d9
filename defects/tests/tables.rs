//! The tables: every defect has its place in the sources, and says what it is.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;
use std::path::Path;

use ncp_defects::{Defect, place, read};

/// All defects, folder by folder and file by file.
fn all() -> Vec<Defect> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let is_table = |path: &Path| {
        path.file_name().is_some_and(|name| name != "Cargo.toml") && path.extension().is_some_and(|e| e == "toml")
    };
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let tables = entries.filter(|path| path.ends_with("peer") || path.ends_with("deep") || is_table(path));
    tables.flat_map(|table| read(&table).unwrap()).collect()
}

#[test]
fn every_edit_has_exactly_one_place_in_its_file() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut wrong = Vec::new();
    for defect in all() {
        for edit in &defect.edit {
            match fs::read_to_string(root.join(&edit.file)) {
                Ok(text) => {
                    let found = place::find(place::without_tests(&text), &defect.name, edit);
                    wrong.extend(found.err().map(|error| error.to_string()));
                }
                Err(error) => wrong.push(format!("{}: {}: {error}", defect.name, edit.file)),
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_defect_is_a_sentence_and_changes_something() {
    for Defect { name, about, edit, .. } in all() {
        assert!(name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-'), "{name}");
        assert!(about.ends_with('.'), "{name}: {about}");
        assert!(!edit.is_empty() && edit.iter().all(|edit| edit.code != edit.with), "{name} changes nothing");
    }
}

#[test]
fn a_defect_of_others_has_their_edits_once_and_before_its_own() {
    let folder = tempfile::tempdir().unwrap();
    let table = folder.path().join("table.toml");
    let defect = |name: &str, of: &str, code: &str| {
        format!(
            "[[defect]]\nname = \"{name}\"\nabout = \"\"\nof = [{of}]\n\
             [[defect.edit]]\nfile = \"f\"\ncode = \"{code}\"\nwith = \"\"\n"
        )
    };
    let (one, two) = (defect("one", "", "a"), defect("two", "", "a"));
    fs::write(&table, [one, two, defect("both", "\"one\", \"two\"", "b")].concat()).unwrap();
    let both: Vec<_> = read(&table).unwrap().remove(2).edit.into_iter().map(|edit| edit.code).collect();
    assert_eq!(both, ["a", "b"]);
    fs::write(&table, defect("both", "\"none\"", "b")).unwrap();
    let error = read(&table).unwrap_err();
    assert_eq!(error.to_string(), "both is made of none, which does not stand before it");
}
