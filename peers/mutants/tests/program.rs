//! The real program: with and without a mutant.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::io::Write as _;
use std::process::{Command, Output, Stdio};

fn run(args: &[&str], input: &str) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_ncp-peer-mutants"))
        .args(args)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(input.as_bytes()).unwrap();
    child.wait_with_output().unwrap()
}

fn ask(args: &[&str], request: &str) -> String {
    String::from_utf8(run(args, &format!("{request}\n")).stdout).unwrap()
}

const PATCH_VERSION: &str = r#"{"id":1,"call":"version.check","args":{"version":"0.5.1","strict":false}}"#;

#[test]
fn without_a_mutant_it_is_the_rust_peer() {
    assert!(ask(&[], PATCH_VERSION).contains(r#""error""#));
}

#[test]
fn a_mutant_has_its_defect_and_another_has_it_not() {
    let answer = ask(&["--mutant", "version-third-component"], PATCH_VERSION);
    assert_eq!(answer, "{\"id\":1,\"result\":{\"compatible\":true}}\n");
    assert!(ask(&["--mutant", "segment-at"], PATCH_VERSION).contains(r#""error""#));
}

#[test]
fn the_list_holds_every_mutant_of_the_table() {
    let output = run(&["--list"], "");
    let list: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let names = list.as_array().unwrap().iter().map(|mutant| mutant["name"].as_str().unwrap());
    assert!(names.clone().count() >= 100);
    assert!(names.clone().any(|name| name == "version-third-component"));
}

#[test]
fn an_unknown_mutant_or_option_is_refused() {
    for args in [&["--mutant", "no-such"][..], &["--mutant"], &["nonsense"]] {
        let output = run(args, "");
        assert_eq!(output.status.code(), Some(2), "{args:?}");
        assert!(output.stdout.is_empty(), "{args:?}");
    }
}
