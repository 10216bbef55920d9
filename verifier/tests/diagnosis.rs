//! The real program, with the fault dictionary, on a peer in another language than that in which it was made.

#![cfg(unix)]
#![expect(clippy::unwrap_used, reason = "a test may fail that way")]

use std::process::{Command, Stdio};

use serde_json::Value;

mod common;

/// What a run on the Python peer with some defects prints, and its result.
fn run(defects: &[&str], args: &[&str]) -> (String, Value) {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("result.json");
    let script = std::path::absolute("tests/data/defective.py").unwrap();
    let peer = format!("python3 '{}' {}", script.display(), defects.join(" "));
    let mut command = Command::new(env!("CARGO_BIN_EXE_ncp-verify"));
    command
        .stdin(Stdio::null())
        .env("COLUMNS", "100")
        .args(["run", "--peer-cmd", &peer, "--json"])
        .arg(&file)
        .args(args);
    let output = command.output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(file.exists(), "{text}{}", String::from_utf8_lossy(&output.stderr));
    (text, common::read_result(&std::fs::read_to_string(&file).unwrap()))
}

fn named(result: &Value) -> Vec<&str> {
    let defects = result["peers"][0]["diagnosis"]["defects"].as_array().unwrap();
    defects.iter().map(|defect| defect["defect"].as_str().unwrap()).collect()
}

fn unexplained(result: &Value) -> usize {
    result["peers"][0]["diagnosis"]["unexplained"].as_array().unwrap().len()
}

const ESTOP: &str = "estop-not-latched";
const RESET: &str = "governor-reset-ignored";
const REPEATED: &str = "repeated-member-anywhere";
/// The calls that show them.
const CALLS: &[&str] = &["--level", "safety", "--filter", "governor.run", "--filter", "decode"];

#[test]
fn three_defects_of_which_one_hides_another_are_named_in_words_in_the_first_screen() {
    let (text, result) = run(&[ESTOP, RESET, REPEATED], CALLS);
    let all = named(&result);
    assert_eq!(all, [ESTOP, REPEATED, RESET]);
    assert_eq!(unexplained(&result), 0);
    let screen: Vec<&str> = text.lines().take(40).map(str::trim).collect();
    for words in [
        "• An inbound ESTOP is passed on but not latched.",
        "• reset does not clear the latch.",
        "• Of two members of one name the last counts, wherever they stand.",
    ] {
        assert!(screen.contains(&words), "{text}");
    }
    // The one does hide the other: alone, it breaks more cases than are left to it.
    let cases = |result: &Value, place: usize| {
        result["peers"][0]["diagnosis"]["defects"][place]["explained"].as_array().unwrap().len()
    };
    let of_reset = all.iter().position(|defect| *defect == RESET).unwrap();
    let (_, alone) = run(&[RESET], CALLS);
    assert_eq!(named(&alone), [RESET]);
    assert!(cases(&result, of_reset) < cases(&alone, 0));
}

#[test]
fn a_defect_that_no_entry_is_about_stays_unexplained() {
    let (text, result) = run(&["half-speed"], CALLS);
    assert_eq!(named(&result), Vec::<&str>::new());
    let failing = result["peers"][0]["totals"]["failed"].as_u64().unwrap();
    assert!(failing > 0);
    assert_eq!(unexplained(&result) as u64, failing);
    assert!(text.contains("no known defect explains"), "{text}");
}

#[test]
fn a_part_of_the_cases_is_enough_to_name_a_defect() {
    let (_, result) = run(&[ESTOP], &["--filter", "safety/latch", "--role", "commander"]);
    assert_eq!((named(&result), unexplained(&result)), (vec![ESTOP], 0));
    let (_, result) = run(&[REPEATED], &["--level", "wire", "--role", "observer"]);
    assert_eq!((named(&result), unexplained(&result)), (vec![REPEATED], 0));
}

#[test]
fn a_peer_without_a_defect_has_none() {
    let (text, result) = run(&[], &["--filter", "safety/latch"]);
    assert_eq!((named(&result), unexplained(&result)), (Vec::new(), 0));
    assert!(!text.contains("known defect"), "{text}");
}
