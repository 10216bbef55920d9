//! Every format of a result, from a run and from a stored result: each as its readers want it.

#![cfg(unix)]
#![expect(clippy::unwrap_used, reason = "a test may fail that way")]

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use serde_json::Value;

mod common;

fn program() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ncp-verify"));
    command.stdin(Stdio::null());
    command
}

fn peer(mode: &str) -> String {
    let examples = Path::new(env!("CARGO_BIN_EXE_ncp-verify")).parent().unwrap().join("examples");
    format!("{} {mode}", examples.join("hostile-peer").display())
}

/// The result of the hostile peer in a mode.
fn result(folder: &Path, mode: &str, args: &[&str]) -> PathBuf {
    let file = folder.join(format!("{mode}.json"));
    let mut command = program();
    command.args(["run", "--vectors", "tests/data/vectors", "--peer-cmd", &peer(mode), "--json"]).arg(&file).args(args);
    assert!(command.output().unwrap().status.code().unwrap() <= 1);
    file
}

fn convert(file: &Path, format: &str) -> String {
    let made = program().args(["convert", "--vectors", "tests/data/vectors", "--to", format]).arg(file).output().unwrap();
    assert_eq!(made.status.code(), Some(0), "{}", String::from_utf8_lossy(&made.stderr));
    String::from_utf8(made.stdout).unwrap()
}

/// With what differs from run to run made even.
fn even(text: &str, file: &Path) -> String {
    let result: Value = serde_json::from_str(&std::fs::read_to_string(file).unwrap()).unwrap();
    let examples = Path::new(env!("CARGO_BIN_EXE_ncp-verify")).parent().unwrap().join("examples");
    let folder = examples.display().to_string();
    let mut even = text.replace(&folder, "EXAMPLES").replace(folder.trim_start_matches('/'), "EXAMPLES");
    for (of, is) in [
        (&result["started"], "STARTED"),
        (&result["corpus"]["sha256"], "CORPUS"),
        (&result["contract_hash"], "HASH"),
    ] {
        even = even.replace(of.as_str().unwrap(), is);
    }
    even.replace(&format!("NCP {}", ncp_text::WIRE_VERSION), "NCP VERSION")
}

const MODES: [&str; 5] = ["honest", "wrong-answer", "die-on-target", "unsupported", "panics"];

#[test]
fn each_format_of_a_stored_result_is_that_of_the_run() {
    let folder = tempfile::tempdir().unwrap();
    let formats = ["json", "junit", "md", "sarif", "tsv", "badge", "shields"];
    let of = |format: &str| folder.path().join(format!("of-the-run.{format}"));
    let args: Vec<String> =
        formats.iter().flat_map(|f| ["--report".to_owned(), format!("{f}={}", of(f).display())]).collect();
    let args: Vec<&str> = args.iter().map(String::as_str).collect();
    for mode in MODES {
        let file = result(folder.path(), mode, &args);
        for format in formats {
            assert_eq!(convert(&file, format), std::fs::read_to_string(of(format)).unwrap(), "{mode} as {format}");
        }
        assert_eq!(convert(&file, "json"), std::fs::read_to_string(&file).unwrap());
    }
}

#[test]
fn sarif_is_by_its_schema_and_has_a_result_for_each_case_that_does_not_pass() {
    let text = std::fs::read_to_string("tests/data/sarif-2.1.0.schema.json").unwrap();
    let schema = jsonschema::validator_for(&serde_json::from_str(&text).unwrap()).unwrap();
    let folder = tempfile::tempdir().unwrap();
    for mode in MODES {
        let file = result(folder.path(), mode, &[]);
        let sarif: Value = serde_json::from_str(&convert(&file, "sarif")).unwrap();
        let faults: Vec<String> = schema.iter_errors(&sarif).map(|e| format!("{}: {e}", e.instance_path())).collect();
        assert_eq!(faults, Vec::<String>::new());
        let found = common::read_result(&std::fs::read_to_string(&file).unwrap());
        let totals = &found["peers"][0]["totals"];
        let failing = totals["failed"].as_u64().unwrap() + totals["advice"].as_u64().unwrap();
        let results = sarif["runs"][0]["results"].as_array().unwrap();
        assert_eq!(results.len() as u64, failing, "{mode}");
        let rules = sarif["runs"][0]["tool"]["driver"]["rules"].as_array().unwrap();
        for result in results {
            let index = usize::try_from(result["ruleIndex"].as_u64().unwrap()).unwrap();
            assert_eq!(rules[index]["id"], result["ruleId"]);
        }
    }
    // The schema refuses what it has to.
    assert!(!schema.is_valid(&serde_json::json!({"version": "2.1.0"})));
}

#[test]
fn what_is_expected_is_suppressed_in_sarif_and_skipped_in_junit_and_what_is_untrue_fails() {
    let folder = tempfile::tempdir().unwrap();
    let list = folder.path().join("known.toml");
    std::fs::write(&list, "[[expected-failures]]\ncase = \"version/tiny/07-target\"\nreason = \"issue 7\"\n").unwrap();
    let args = ["--expected", list.to_str().unwrap()];
    let file = result(folder.path(), "wrong-answer", &args);
    let sarif: Value = serde_json::from_str(&convert(&file, "sarif")).unwrap();
    assert_eq!(sarif["runs"][0]["results"][0]["suppressions"][0]["justification"], "issue 7");
    let junit = convert(&file, "junit");
    assert!(junit.contains("skipped=\"1\"") && junit.contains("<skipped message=\"issue 7\"/>"), "{junit}");
    assert!(convert(&file, "shields").contains(r#""message":"as expected","color":"yellow""#));
    let file = result(folder.path(), "honest", &args);
    let sarif: Value = serde_json::from_str(&convert(&file, "sarif")).unwrap();
    assert_eq!(sarif["runs"][0]["results"][0]["ruleId"], "expected-failures");
    assert!(convert(&file, "md").contains("no longer fails: take it out"));
}

#[test]
fn markdown_tsv_and_badges_are_as_they_were_read() {
    let folder = tempfile::tempdir().unwrap();
    let file = result(folder.path(), "wrong-answer", &[]);
    insta::assert_snapshot!("markdown", even(&convert(&file, "md"), &file));
    insta::assert_snapshot!("tsv", even(&convert(&file, "tsv"), &file));
    insta::assert_snapshot!("badge", even(&convert(&file, "badge"), &file));
    insta::assert_snapshot!("shields", even(&convert(&file, "shields"), &file));
    insta::assert_snapshot!("sarif", even(&convert(&file, "sarif"), &file));
}

#[test]
fn a_file_that_is_no_result_is_a_usage_error() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("x.json");
    for (text, message) in [
        ("{}", "this is no result of ncp-verify: missing field `format`"),
        ("nonsense", "this is no result of ncp-verify"),
        (r#"{"format":2}"#, "its format is 2, and this program understands 1"),
    ] {
        std::fs::write(&file, text).unwrap();
        let made = program().args(["convert", "--to", "md"]).arg(&file).output().unwrap();
        let said = String::from_utf8_lossy(&made.stderr).into_owned();
        assert_eq!(made.status.code(), Some(2));
        assert!(said.contains(message), "{said}");
    }
}
