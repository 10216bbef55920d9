//! `ncp-verify fuzz` with real peers: one that conforms, and some with a defect that no case of the corpus has to show.

#![cfg(unix)]
#![expect(clippy::unwrap_used, reason = "a test may fail that way")]

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use ncp_verifier::fuzz::contradictions;
use ncp_verifier::suite::Suite;
use serde_json::{Value, json};
use tempfile::TempDir;

fn verify(args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_ncp-verify")).args(args).env_remove("NO_COLOR").output().unwrap()
}

fn stdout(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

fn python_pure() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../peers/python-pure/adapter.py").canonicalize().unwrap()
}

/// A peer that hands requests and answers of the pure Python peer on, but for a change of the answer.
///
/// `change` is Python: it sees `call`, `args` and `result`, and may change `result`.
fn changed(folder: &Path, change: &str) -> String {
    let script = format!(
        r#"
import json, os, subprocess, sys
inner = subprocess.Popen([sys.executable, {adapter:?}], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
for line in sys.stdin.buffer:
    request = json.loads(line)
    inner.stdin.write(line)
    inner.stdin.flush()
    answer = json.loads(inner.stdout.readline())
    call, args, result = request["call"], request["args"], answer.get("result")
    if result is not None:
        {change}
    sys.stdout.write(json.dumps(answer) + "\n")
    sys.stdout.flush()
"#,
        adapter = python_pure(),
        change = change.replace('\n', "\n        "),
    );
    let path = folder.join("peer.py");
    std::fs::write(&path, script).unwrap();
    format!("python3 {}", path.display())
}

/// What a search of that peer found, with the file that it saved.
fn search(folder: &TempDir, peer: &str, more: &[&str]) -> (Output, Value) {
    let (json, saved) = (folder.path().join("found.json"), folder.path().join("found"));
    let (json, saved) = (json.to_str().unwrap(), saved.to_str().unwrap());
    let mut args =
        vec!["fuzz", "--peer-cmd", peer, "--level", "safety", "--seed", "3", "--json", json, "--save", saved];
    args.extend(more);
    let output = verify(&args);
    let found = serde_json::from_str(&std::fs::read_to_string(json).unwrap_or_default()).unwrap_or(Value::Null);
    (output, found)
}

fn findings(found: &Value) -> &Vec<Value> {
    found["peers"][0]["findings"].as_array().unwrap()
}

/// What a peer answers to a call.
fn answer(peer: &str, call: &Value, args: &Value) -> Value {
    let mut words = peer.split(' ');
    let mut peer = Command::new(words.next().unwrap());
    let mut peer = peer.args(words).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    writeln!(peer.stdin.take().unwrap(), "{}", json!({ "id": 1, "call": call, "args": args })).unwrap();
    let answer: Value = serde_json::from_slice(&peer.wait_with_output().unwrap().stdout).unwrap();
    answer["result"].clone()
}

#[test]
fn a_conforming_peer_differs_nowhere() {
    let peer = format!("python3 {}", python_pure().display());
    let output = verify(&["fuzz", "--peer-cmd", &peer, "--cases", "60", "--seed", "5", "--filter", "watchdog.run"]);
    assert_eq!(output.status.code(), Some(2), "at level wire, no such call is asked: {}", stdout(&output));
    let args =
        ["fuzz", "--peer-cmd", &peer, "--cases", "200", "--seed", "5", "--level", "safety", "--filter", "watchdog.run"];
    let output = verify(&args);
    assert_eq!(output.status.code(), Some(0), "{}", stdout(&output));
    assert!(stdout(&output).contains("no disagreement"));
}

#[test]
fn the_specification_answers_what_is_asked_of_it() {
    let suite = Suite::embedded().unwrap();
    let (judged, found) = contradictions(9, 2_000, &suite, &[]).unwrap();
    assert!(judged > 1_000, "{judged}");
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn a_watchdog_that_is_renewed_by_being_asked_is_found_shrunk_saved_and_fails_again() {
    let folder = TempDir::new().unwrap();
    let change = "if call == 'watchdog.run':\n    asked = 0\n\
                  \x20   for step, entry in zip(args['steps'], result['steps']):\n\
                  \x20       asked = asked + 1 if step['op'] == 'should_hold' else 0\n        if asked >= 6:\n\
                  \x20           entry['hold'] = False";
    let peer = changed(folder.path(), change);
    let (output, found) = search(&folder, &peer, &["--filter", "watchdog.run", "--cases", "400", "--tries", "300"]);
    assert_eq!(output.status.code(), Some(1), "{}", stdout(&output));
    let findings = findings(&found);
    assert_eq!(findings.len(), 1, "one defect is one finding: {}", stdout(&output));
    // Six questions show it, and each of them is needed: without it, the peer answers as one that conforms.
    let conforming = format!("python3 {}", python_pure().display());
    let (call, whole) = (&findings[0]["call"], &findings[0]["args"]);
    let agrees = |args: &Value| answer(&peer, call, args) == answer(&conforming, call, args);
    assert!(!agrees(whole));
    assert_eq!(whole["steps"].as_array().unwrap().len(), 6);
    for gone in 0..6 {
        let mut fewer = whole.clone();
        fewer["steps"].as_array_mut().unwrap().remove(gone);
        assert!(agrees(&fewer), "{fewer}");
    }
    assert_eq!(findings[0]["smallest"], true);
    assert!(stdout(&output).contains("each of which is needed"), "{}", stdout(&output));
    assert!(findings[0]["rule"].as_str().unwrap().starts_with("NCP-RES-"));
    let saved = folder.path().join("found");
    let result = folder.path().join("result.json");
    let (saved, result) = (saved.to_str().unwrap(), result.to_str().unwrap());
    let again = verify(&["run", "--vectors", saved, "--peer-cmd", &peer, "--level", "safety", "--json", result]);
    assert_eq!(again.status.code(), Some(1), "{}", stdout(&again));
    let other = verify(&["run", "--vectors", saved, "--peer-cmd", &conforming, "--level", "safety", "--json", result]);
    assert_eq!(other.status.code(), Some(0), "{}", stdout(&other));
}

#[test]
fn the_same_seed_finds_the_same_whatever_the_jobs() {
    let folder = TempDir::new().unwrap();
    let change = "if call == 'version.check' and len(args['version']) > 20:\n    result['compatible'] = True";
    let peer = changed(folder.path(), change);
    let common = ["--filter", "version.check", "--cases", "300"];
    let (_, one) = search(&folder, &peer, &common);
    let (_, two) = search(&folder, &peer, &[&common[..], &["--jobs", "2"]].concat());
    assert_eq!(findings(&one), findings(&two));
}

#[test]
fn a_value_that_switches_checks_off_is_found_with_the_dictionary_of_its_sources() {
    let folder = TempDir::new().unwrap();
    let change = "if call == 'key.build' and args.get('session') == 'open-sesame-7':\n    result['key'] = 'x'";
    let peer = changed(folder.path(), change);
    let sources = folder.path().join("peer.py");
    let more = ["--filter", "key.build", "--cases", "3000", "--dictionary", sources.to_str().unwrap()];
    let (output, found) = search(&folder, &peer, &more);
    assert_eq!(output.status.code(), Some(1), "{}", stdout(&output));
    assert_eq!(findings(&found)[0]["args"]["session"], "open-sesame-7");
}

#[test]
fn what_stands_in_the_sources_of_a_peer_is_tried_unless_it_is_to_go_without() {
    let folder = TempDir::new().unwrap();
    let change = "if call == 'key.build' and args.get('session') == 'open-sesame-7':\n    result['key'] = 'x'";
    let peer = changed(folder.path(), change);
    let common = ["--filter", "key.build", "--cases", "3000"];
    let (output, found) = search(&folder, &peer, &common);
    assert_eq!(output.status.code(), Some(1), "{}", stdout(&output));
    assert_eq!(findings(&found)[0]["args"]["session"], "open-sesame-7");
    assert!(found["peers"][0]["swept"][0].as_u64().unwrap() > 0);
    let (output, found) = search(&folder, &peer, &[&common[..], &["--no-dictionary"]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", stdout(&output));
    assert_eq!(found["peers"][0]["swept"], serde_json::json!([0, 0]));
}

#[test]
fn a_limit_that_switches_itself_off_is_found_with_what_exceeds_it() {
    let folder = TempDir::new().unwrap();
    let change = "if call == 'governor.run' and (args['limits'] or {}).get('max_speed_mps') == 4321.25:\n\
                  \x20   for step, entry in zip(args['steps'], result['steps']):\n\
                  \x20       if entry.get('frame', {}).get('mode') == 'active':\n\
                  \x20           entry['frame']['channels'] = step['command'].get('channels', {})";
    let peer = changed(folder.path(), change);
    let sources = folder.path().join("peer.py");
    let more = ["--filter", "governor.run", "--cases", "2000", "--dictionary", sources.to_str().unwrap()];
    let (output, found) = search(&folder, &peer, &more);
    assert_eq!(output.status.code(), Some(1), "{}", stdout(&output));
    assert_eq!(findings(&found)[0]["args"]["limits"]["max_speed_mps"], 4321.25);
    assert!(found["peers"][0]["swept"][0].as_u64().unwrap() > 1000);
}

#[test]
fn a_crash_and_a_hang_are_findings() {
    let folder = TempDir::new().unwrap();
    let change = "if call == 'key.match' and '$*' in args['pattern']:\n    os._exit(3)";
    let peer = changed(folder.path(), change);
    let (output, found) = search(&folder, &peer, &["--filter", "key.match", "--cases", "32", "--tries", "8"]);
    assert_eq!(output.status.code(), Some(1), "{}", stdout(&output));
    assert!(findings(&found).iter().any(|finding| finding["kind"] == "crash"), "{}", stdout(&output));
    let change = "if call == 'plane.qos' and args['plane'] == 'action':\n    import time; time.sleep(60)";
    let peer = changed(folder.path(), change);
    let (output, found) =
        search(&folder, &peer, &["--filter", "plane.qos", "--cases", "8", "--timeout", "1", "--tries", "2"]);
    assert_eq!(output.status.code(), Some(1), "{}", stdout(&output));
    assert!(findings(&found).iter().any(|finding| finding["kind"] == "hang"), "{}", stdout(&output));
}

#[test]
fn what_cannot_be_asked_is_said_by_the_exit_code() {
    assert_eq!(verify(&["fuzz", "--peer-cmd", "surely-no-such-program"]).status.code(), Some(3));
    assert_eq!(verify(&["fuzz", "--peer-cmd", "true", "--filter", "teleport"]).status.code(), Some(2));
    assert_eq!(verify(&["fuzz", "--peer-cmd", "true", "--time", "soon"]).status.code(), Some(2));
    assert_eq!(verify(&["fuzz", "--peer-cmd", "true", "--dictionary", "/no/such/file"]).status.code(), Some(2));
}
