//! The scenario text: that it is laid out as the formatter lays it out, and that every file of it is used.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on has failed")]

use std::fs;
use std::path::{Path, PathBuf};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn entries(folder: &Path) -> Vec<PathBuf> {
    let mut paths: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    paths
}

/// Every scenario file, as `area/name`, and its text.
fn scenarios() -> Vec<(String, String)> {
    let files = entries(&root().join("scenarios")).into_iter().flat_map(|area| entries(&area));
    let name = |path: &Path| {
        let path = path.strip_prefix(root().join("scenarios")).unwrap().with_extension("");
        path.to_string_lossy().replace('\\', "/")
    };
    files.map(|path| (name(&path), fs::read_to_string(&path).unwrap())).collect()
}

#[test]
fn every_scenario_file_is_laid_out_by_the_formatter() {
    for (name, text) in scenarios() {
        let formatted = ncp_vectors::formatted(&text);
        assert!(text == formatted, "vectors/scenarios/{name}.txt: run `cargo run -p ncp-vectors --example format`");
    }
}

#[test]
fn every_scenario_file_is_read_by_its_area() {
    for (name, _) in scenarios() {
        let (area, _) = name.split_once('/').unwrap();
        let reads = |path: &PathBuf| fs::read_to_string(path).unwrap().contains(&format!("source!(\"{name}\")"));
        assert!(entries(&root().join("src").join(area)).iter().any(reads), "nothing reads {name}");
    }
}

#[test]
fn the_readme_lists_every_area_of_the_corpus_and_no_other() {
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    let listed: Vec<&str> =
        readme.lines().filter_map(|line| line.strip_prefix("| [`")?.split_once("`](corpus/")).map(|(a, _)| a).collect();
    let areas: Vec<String> =
        entries(&root().join("corpus")).iter().map(|path| path.file_name().unwrap().to_string_lossy().into()).collect();
    let mut sorted = listed.clone();
    sorted.sort_unstable();
    assert_eq!(sorted, areas);
}
