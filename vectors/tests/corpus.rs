//! The corpus on disk: that it is what the generator makes, and that it is in order.

#![expect(clippy::expect_used, reason = "a test that cannot go on has failed")]

mod on_disk;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use ncp_vectors::{generate, manifest};
use serde_json::Value;

/// The folder of the crate.
fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The files on disk, parsed.
fn files() -> Vec<(String, Value)> {
    let parse = |text: String| serde_json::from_str(&text).expect("a file is JSON");
    on_disk::corpus().into_iter().map(|(path, text)| (path, parse(text))).collect()
}

fn cases(file: &Value) -> &[Value] {
    file["cases"].as_array().expect("a file has cases")
}

fn strings(list: &Value) -> Vec<&str> {
    let items = list.as_array().expect("a list");
    items.iter().map(|item| item.as_str().expect("a string")).collect()
}

/// It was made in another process, so that this shows as well that the generator makes the same files each time.
#[test]
fn the_corpus_on_disk_is_what_the_generator_makes() {
    const REMEDY: &str = "run `cargo run -p ncp-vectors --example generate`";
    let (on_disk, made) = (on_disk::corpus(), generate().expect("the scenario text is in order"));
    for (path, made) in &made {
        let Some((_, found)) = on_disk.iter().find(|(found, _)| found == path) else {
            panic!("the manifest lists no vectors/corpus/{path}; {REMEDY}");
        };
        if found == made {
            continue;
        }
        let parsed = |text: &str| serde_json::from_str::<Value>(text);
        let (Ok(found), Ok(made)) = (parsed(found), parsed(made)) else {
            panic!("vectors/corpus/{path} is no JSON");
        };
        let pairs = cases(&made).iter().zip(found["cases"].as_array().into_iter().flatten());
        let first = pairs.map(|(made, found)| (&made["id"], made == found)).find(|(_, same)| !same);
        let id = first.map_or("the number of cases, or something beside them".to_owned(), |(id, _)| id.to_string());
        panic!("vectors/corpus/{path} differs from what the generator makes, first at {id}; {REMEDY}");
    }
    assert_eq!(on_disk.len(), made.len(), "the manifest lists files that the generator does not make; {REMEDY}");
}

#[test]
fn nothing_but_the_corpus_lies_in_its_folders() {
    let listed: BTreeSet<PathBuf> =
        on_disk::corpus().into_iter().map(|(path, _)| root().join("corpus").join(path)).collect();
    let areas: BTreeSet<&Path> = listed.iter().filter_map(|path| path.parent()).collect();
    for area in areas {
        for entry in fs::read_dir(area).unwrap() {
            let path = entry.unwrap().path();
            assert!(listed.contains(&path), "{} is no file of the corpus", path.display());
        }
    }
}

#[test]
fn the_manifest_freezes_every_file() {
    let frozen = fs::read_to_string(root().join("MANIFEST.sha256")).unwrap();
    let found = manifest(&on_disk::corpus());
    let differing = frozen.lines().zip(found.lines()).find(|(frozen, found)| frozen != found);
    assert_eq!(frozen, found, "vectors/MANIFEST.sha256 differs, first at {differing:?}");
}

#[test]
fn a_changed_character_changes_the_manifest() {
    let mut files = on_disk::corpus();
    let before = manifest(&files);
    files[0].1.push(' ');
    assert_ne!(manifest(&files), before);
}

#[test]
fn there_are_at_least_1200_cases() {
    let count: usize = files().iter().map(|(_, file)| cases(file).len()).sum();
    assert!(count >= 1200, "{count}");
}

#[test]
fn every_id_is_unique_and_begins_with_its_file() {
    let mut seen = BTreeSet::new();
    for (path, file) in files() {
        let prefix = format!("{}/", path.strip_suffix(".json").unwrap());
        assert_eq!(prefix, format!("{}/{}/", file["area"].as_str().unwrap(), file["name"].as_str().unwrap()));
        for case in cases(&file) {
            let id = case["id"].as_str().unwrap();
            assert!(id.starts_with(&prefix), "{id} stands in {path}");
            assert!(seen.insert(id.to_owned()), "{id} occurs twice");
        }
    }
}

#[test]
fn no_case_repeats_another_under_the_same_rule() {
    let mut seen = BTreeMap::new();
    let mut repeated = Vec::new();
    for (_, file) in files() {
        for case in cases(&file) {
            let id = case["id"].as_str().unwrap().to_owned();
            let question = (
                case["call"].to_string(),
                case["args"].to_string(),
                case["expect"].to_string(),
                case["requirements"][0].to_string(),
            );
            if let Some(other) = seen.insert(question, id.clone()) {
                repeated.push(format!("{id} repeats {other}"));
            }
        }
    }
    assert!(repeated.is_empty(), "{}", repeated.join("\n"));
}

#[test]
fn every_flag_is_explained_where_it_is_used_and_every_note_is_needed() {
    for (path, file) in files() {
        let used: BTreeSet<&str> = cases(&file).iter().flat_map(|case| strings(&case["flags"])).collect();
        let notes = file["notes"].as_object().unwrap();
        let noted: BTreeSet<&str> = notes.keys().map(String::as_str).collect();
        assert_eq!(used, noted, "{path}");
        assert!(notes.values().all(|note| note.as_str().unwrap().len() > 20), "{path}");
    }
}

#[test]
fn every_title_and_every_reason_is_a_sentence() {
    for (_, file) in files() {
        for case in cases(&file) {
            for member in ["title", "why"] {
                let text = case[member].as_str().unwrap();
                let first = text.chars().next().unwrap();
                let begins = first.is_uppercase() || !first.is_alphabetic();
                assert!(begins && text.ends_with('.'), "{}: {text:?}", case["id"]);
                assert!(!text.contains("  "), "{}: {text:?}", case["id"]);
            }
        }
    }
}

#[test]
fn a_file_stays_below_2_mib_and_the_corpus_below_24() {
    let sizes: Vec<_> = on_disk::corpus().into_iter().map(|(path, text)| (text.len(), path)).collect();
    let largest = sizes.iter().max().unwrap();
    assert!(largest.0 < 2 << 20, "{largest:?}");
    // Maps of as many entries as a frame may have, long waits, and every rule at several sizes, on several roads and in
    // each mode have to be written out.
    assert!(sizes.iter().map(|(size, _)| size).sum::<usize>() < 24 << 20);
}
