//! The program itself, over a link on which much happens in little time.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test that cannot go on has failed")]

use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use serde_json::Value;

const DENSE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/dense.toml");

fn soak(time: &str, report: &Path, more: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ncp-live"));
    command.args(["soak", "--schedule", DENSE, "--time", time, "--report"]).arg(report).args(more);
    command.stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

fn read(report: &Path, output: &Output) -> Value {
    let text = fs::read_to_string(report);
    serde_json::from_str(&text.unwrap_or_else(|error| panic!("{error}\n{output:?}"))).unwrap()
}

/// The rules that a report says failed.
fn failed(report: &Value) -> Vec<&str> {
    let rulings = report["rulings"].as_array().unwrap().iter();
    rulings.filter(|one| one["verdict"] == "failed").map(|one| one["rule"].as_str().unwrap()).collect()
}

#[test]
fn a_sound_system_holds_and_everything_is_reported() {
    let folder = tempfile::tempdir().unwrap();
    let (file, plot) = (folder.path().join("soak.json"), folder.path().join("soak.svg"));
    let output = soak("12s", &file, &["--plot", plot.to_str().unwrap()]).output().unwrap();
    let report = read(&file, &output);
    assert_eq!(failed(&report), [""; 0], "{}", String::from_utf8_lossy(&output.stdout));
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stdout));
    let checks = |rule: &str| {
        let rulings = report["rulings"].as_array().unwrap();
        rulings.iter().find(|one| one["rule"] == rule).unwrap()["observed"].as_u64().unwrap()
    };
    for rule in ["NCP-RES-002", "NCP-RES-009", "NCP-RES-026", "NCP-PLANE-006", "NCP-SESS-027"] {
        assert!(checks(rule) > 0, "{rule} was never judged");
    }
    for kind in ["duplicated", "corrupted", "burst", "flooded", "cut"] {
        assert!(report["faults"]["action"][kind].as_u64().unwrap() > 0, "{kind}");
    }
    assert!(report["ended"].as_bool().unwrap() && report["seconds"].as_array().unwrap().len() > 5);
    assert!(fs::read_to_string(plot).unwrap().trim_end().ends_with("</svg>"));
}

#[test]
fn a_planted_defect_breaks_the_rule_that_it_is_about() {
    let folder = tempfile::tempdir().unwrap();
    for (defect, rule) in
        [("ttl-unchecked", "NCP-RES-002"), ("latch-forgets", "NCP-RES-025"), ("duplicate-renews", "NCP-RES-009")]
    {
        let file = folder.path().join("soak.json");
        let output = soak("15s", &file, &["--defect", defect]).output().unwrap();
        let report = read(&file, &output);
        assert!(failed(&report).contains(&rule), "{defect}: {:?}", failed(&report));
        assert_eq!(output.status.code(), Some(1), "{defect}");
    }
}

#[test]
fn a_soak_that_is_interrupted_leaves_its_report() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("soak.json");
    let mut child = soak("10m", &file, &[]).spawn().unwrap();
    thread::sleep(Duration::from_secs(4));
    let interrupt = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(interrupt.success());
    let began = Instant::now();
    while child.try_wait().unwrap().is_none() {
        if began.elapsed() > Duration::from_secs(60) {
            child.kill().unwrap();
        }
        thread::sleep(Duration::from_millis(20));
    }
    let output = child.wait_with_output().unwrap();
    let report = read(&file, &output);
    assert!(report["time_s"].as_f64().unwrap() < 60.0 && report["ended"].as_bool().unwrap());
}

#[test]
fn an_unknown_defect_and_a_schedule_that_is_none_cannot_be_judged() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("soak.json");
    assert_eq!(soak("1s", &file, &["--defect", "none-such"]).output().unwrap().status.code(), Some(3));
    let schedule = folder.path().join("schedule.toml");
    fs::write(&schedule, "[action]\nlose = 2.0").unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_ncp-live"));
    let output = command.args(["soak", "--time", "1s", "--schedule"]).arg(&schedule).output().unwrap();
    assert_eq!(output.status.code(), Some(3));
    assert_eq!(soak("soon", &file, &[]).output().unwrap().status.code(), Some(2));
}
