//! Runs of any size: shards and their merger, a run that was killed and is taken up again, only what failed.

#![cfg(unix)]
#![expect(clippy::unwrap_used, reason = "a test may fail that way")]

use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

use serde_json::{Value, json};

mod common;
mod made;
#[path = "made/versions.rs"]
mod versions;

fn program() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ncp-verify"));
    command.stdin(Stdio::null()).env("COLUMNS", "100");
    command
}

fn peer(mode: &str) -> String {
    let examples = Path::new(env!("CARGO_BIN_EXE_ncp-verify")).parent().unwrap().join("examples");
    format!("{} {mode}", examples.join("hostile-peer").display())
}

/// Runs the program on a peer, with its result in a file.
fn run(vectors: &str, mode: &str, file: &Path, args: &[&str]) -> Output {
    let mut command = program();
    command.args(["run", "--vectors", vectors, "--peer-cmd", &peer(mode), "--json"]).arg(file).args(args);
    command.output().unwrap()
}

fn read(file: &Path) -> Value {
    common::read_result(&std::fs::read_to_string(file).unwrap())
}

/// A result as text, with all that is a time set to nothing, and of a peer that dies what it took to find that out.
fn timeless(file: &Path, dies: bool) -> String {
    let mut result = read(file);
    (result["started"], result["elapsed_s"]) = (Value::Null, Value::Null);
    for peer in result["peers"].as_array_mut().unwrap() {
        (peer["run"]["elapsed_s"], peer["run"]["rate"]) = (Value::Null, Value::Null);
        if dies {
            (peer["run"]["answers"], peer["run"]["faults"]) = (Value::Null, Value::Null);
        }
    }
    serde_json::to_string_pretty(&result).unwrap()
}

fn shards(folder: &Path, vectors: &str, mode: &str, of: usize, args: &[&str]) -> Vec<PathBuf> {
    let shard = |index: usize| {
        let file = folder.join(format!("{index}-of-{of}.json"));
        let part = format!("{index}/{of}");
        let exit = run(vectors, mode, &file, &[&["--shard", &part], args].concat()).status.code().unwrap();
        assert!(exit <= 1, "{mode} {part}: {exit}");
        file
    };
    (1..=of).map(shard).collect()
}

fn merge(vectors: &str, results: &[PathBuf], file: &Path) -> Output {
    program().args(["merge", "--vectors", vectors, "--json"]).arg(file).args(results).output().unwrap()
}

#[test]
fn merged_shards_are_byte_for_byte_the_result_of_one_run() {
    let folder = tempfile::tempdir().unwrap();
    let [whole, merged] = ["whole.json", "merged.json"].map(|name| folder.path().join(name));
    let vectors = "tests/data/vectors";
    for (mode, dies) in
        [("honest", false), ("wrong-answer", false), ("unsupported", false), ("panics", false), ("die-on-target", true)]
    {
        let one = run(vectors, mode, &whole, &[]);
        // More shards than cases, too.
        for of in [1, 2, 3, 20] {
            let mut parts = shards(folder.path(), vectors, mode, of, &["--jobs", "2"]);
            parts.reverse();
            let made = merge(vectors, &parts, &merged);
            assert_eq!(made.status.code(), one.status.code(), "{}", String::from_utf8_lossy(&made.stderr));
            assert_eq!(timeless(&merged, dies), timeless(&whole, dies), "{mode} in {of}");
        }
    }
}

#[test]
fn what_rests_on_a_case_of_another_shard_is_judged_by_it() {
    let folder = tempfile::tempdir().unwrap();
    let script = std::path::absolute("tests/data/defective.py").unwrap();
    let peer = format!("python3 '{}' estop-not-latched", script.display());
    let known = folder.path().join("known.toml");
    let entry = "[[expected-failures]]\nrequirement = \"NCP-SAFE-004\"\nexcuses = 2\nreason = \"issue 7\"\n";
    std::fs::write(&known, entry).unwrap();
    let check = |file: &Path, args: &[&str]| {
        let mut command = program();
        command.args(["run", "--filter", "safety/latch", "--peer-cmd", &peer, "--expected"]).arg(&known);
        assert!(command.arg("--json").arg(file).args(args).output().unwrap().status.code().unwrap() <= 1);
    };
    let [whole, merged] = ["whole.json", "merged.json"].map(|name| folder.path().join(name));
    check(&whole, &[]);
    let parts: Vec<PathBuf> = (1..=2).map(|index| folder.path().join(format!("{index}.json"))).collect();
    for (index, part) in (1..).zip(&parts) {
        check(part, &["--shard", &format!("{index}/2")]);
    }
    let made = program().args(["merge", "--json"]).arg(&merged).args(&parts).output().unwrap();
    assert_eq!(made.status.code(), Some(read(&whole)["exit_code"].as_i64().unwrap().try_into().unwrap()));
    assert_eq!(timeless(&merged, false), timeless(&whole, false));
    let rulings = |file: &Path| {
        let result = read(file);
        let cases = result["peers"][0]["cases"].as_array().unwrap().clone();
        cases.iter().filter(|case| case["ruling"] == "inconclusive").count()
    };
    assert!(rulings(&whole) > 0, "no case waits for another: the test shows nothing");
}

#[test]
fn what_is_no_whole_set_of_shards_is_refused_by_name() {
    let folder = tempfile::tempdir().unwrap();
    let (vectors, file) = ("tests/data/vectors", folder.path().join("merged.json"));
    let parts = shards(folder.path(), vectors, "honest", 3, &[]);
    let others = shards(folder.path(), vectors, "wrong-describe", 2, &[]);
    let whole = folder.path().join("whole.json");
    run(vectors, "honest", &whole, &[]);
    let filtered = folder.path().join("filtered.json");
    run(vectors, "honest", &filtered, &["--shard", "3/3", "--filter", "tiny"]);
    for (results, message) in [
        (vec![&parts[0], &parts[2]], "these shards are missing: 2/3"),
        (vec![&parts[0], &parts[1], &parts[1], &parts[2]], "the shard 2/3 is there twice"),
        (vec![&whole], "is not that of a shard"),
        (vec![&parts[0], &others[1]], "the number of shards differs"),
        (vec![&parts[0], &parts[1], &filtered], "what was asked for differs"),
    ] {
        let results: Vec<PathBuf> = results.into_iter().cloned().collect();
        let made = merge(vectors, &results, &file);
        let said = String::from_utf8_lossy(&made.stderr);
        assert_eq!(made.status.code(), Some(2), "{said}");
        assert!(said.contains(message), "{said}");
    }
    let made = program().arg("merge").args(&parts).output().unwrap();
    assert!(String::from_utf8_lossy(&made.stderr).contains("of other vectors"), "the vectors built in are others");
    assert!(!file.exists());
}

#[test]
fn a_verifier_that_is_killed_ten_times_loses_at_most_what_was_in_flight() {
    const CASES: usize = 1500;
    /// How many requests are in flight at most, and as many again that were answered but not yet read.
    const IN_FLIGHT: usize = 256;
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let vectors = versions::many(folder.path(), CASES);
    let (undisturbed, resumed, asked) = (path("undisturbed.json"), path("resumed.json"), path("asked"));
    run(&vectors, &format!("writes-down {}", path("aside").display()), &undisturbed, &[]);
    let journal = path("resumed.json.journal");
    let size = || std::fs::metadata(&journal).map_or(0, |file| file.len());
    let mode = format!("writes-down {}", asked.display());
    for kill in 0..10_u64 {
        let before = size();
        let mut command = program();
        command.args(["run", "--resume", "--vectors", &vectors, "--peer-cmd", &peer(&mode), "--json"]).arg(&resumed);
        let mut running = command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
        let deadline = Instant::now() + Duration::from_secs(60);
        while size() < before + 3000 && Instant::now() < deadline {
            std::thread::sleep(Duration::from_millis(1 + kill % 4));
        }
        assert!(running.try_wait().unwrap().is_none(), "it was at its end before it was killed");
        running.kill().unwrap();
        running.wait().unwrap();
        assert!(!resumed.exists() && size() > before);
    }
    let last = run(&vectors, &mode, &resumed, &["--resume"]);
    assert_eq!(last.status.code(), Some(0), "{}", String::from_utf8_lossy(&last.stderr));
    assert!(!journal.exists(), "a journal is left behind");
    let normal = |file: &Path| timeless(file, false).replace("resumed", "").replace("asked", "").replace("aside", "");
    assert_eq!(normal(&resumed), normal(&undisturbed));
    let all = std::fs::read_to_string(&asked).unwrap().lines().count();
    assert!((CASES..=CASES + 10 * IN_FLIGHT).contains(&all), "{all} requests for {CASES} cases");
}

#[test]
fn a_journal_of_another_run_is_refused_and_none_is_needed_to_begin() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("result.json");
    let journal = folder.path().join("result.json.journal");
    let vectors = "tests/data/vectors";
    assert_eq!(run(vectors, "honest", &file, &["--resume"]).status.code(), Some(0));
    std::fs::write(&journal, "{\"journal\":1}\n").unwrap();
    let other = run(vectors, "honest", &file, &["--resume"]);
    assert_eq!(other.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&other.stderr).contains("is the journal of another run"));
    assert_eq!(run(vectors, "honest", &file, &[]).status.code(), Some(0));
    assert!(!journal.exists());
    let repeated = run(vectors, "honest", &file, &["--resume", "--repeat", "2"]);
    assert_eq!(repeated.status.code(), Some(2));
}

#[test]
fn only_what_failed_is_run_again() {
    let folder = tempfile::tempdir().unwrap();
    let [before, after] = ["before.json", "after.json"].map(|name| folder.path().join(name));
    let (vectors, old) = ("tests/data/vectors", before.to_str().unwrap().to_owned());
    run(vectors, "wrong-answer", &before, &[]);
    let ids = |file: &Path| {
        let result = read(file);
        let cases = result["peers"][0]["cases"].as_array().unwrap().clone();
        cases.iter().map(|case| case["id"].as_str().unwrap().to_owned()).collect::<Vec<_>>()
    };
    for (mode, exit) in [("wrong-answer", 1), ("honest", 0)] {
        let again = run(vectors, mode, &after, &["--rerun-failed", &old]);
        assert_eq!(again.status.code(), Some(exit), "{}", String::from_utf8_lossy(&again.stderr));
        assert_eq!(ids(&after), ["describe", "version/tiny/07-target"]);
        let asked = &read(&after)["asked"];
        assert_eq!((&asked["partial"], &asked["rerun"]), (&json!(true), &json!(true)));
    }
    run(vectors, "honest", &before, &[]);
    let nothing = run(vectors, "honest", &after, &["--rerun-failed", &old]);
    assert_eq!(nothing.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&nothing.stderr).contains("there is nothing to run again"));
}

/// By `NCP_DEATHS` more of them, such as the 1,000 of the acceptance.
#[test]
fn a_peer_that_is_killed_at_random_fails_no_case_but_those_that_it_died_on() {
    let deaths: usize = std::env::var("NCP_DEATHS").map_or(60, |deaths| deaths.parse().unwrap());
    let folder = tempfile::tempdir().unwrap();
    let (file, died) = (folder.path().join("result.json"), folder.path().join("died"));
    let vectors = versions::many(folder.path(), 20 * deaths);
    let run = run(&vectors, &format!("dies-at-random {} {deaths}", died.display()), &file, &[]);
    assert_eq!(run.status.code(), Some(1), "{}", String::from_utf8_lossy(&run.stderr));
    assert_eq!(std::fs::metadata(&died).unwrap().len(), deaths as u64);
    let result = read(&file);
    let cases = result["peers"][0]["cases"].as_array().unwrap();
    assert_eq!(cases.len(), 20 * deaths + 1);
    let crashed = cases.iter().filter(|case| case["outcome"] == "crash").count();
    let passed = cases.iter().filter(|case| case["outcome"] == "pass").count();
    assert_eq!(passed + crashed, cases.len());
    assert!((1..=deaths).contains(&crashed), "{crashed} cases for {deaths} deaths");
}

/// What a step of the workflow runs, by its name.
fn step(name: &str) -> String {
    let text = std::fs::read_to_string("../.github/workflows/shards.yml").unwrap();
    let of_it = text.split(&format!("- name: {name}\n")).nth(1).unwrap();
    let run = of_it.lines().find_map(|line| line.trim().strip_prefix("run: ")).unwrap();
    run.to_owned()
}

#[test]
fn the_steps_of_the_workflow_make_one_result_of_the_shards() {
    let folder = tempfile::tempdir().unwrap();
    let root = std::path::absolute("..").unwrap();
    std::os::unix::fs::symlink(root.join(".ci"), folder.path().join(".ci")).unwrap();
    let vectors = std::path::absolute("tests/data/vectors").unwrap();
    let verify = folder.path().join("verify");
    let script =
        format!("#!/bin/sh\nexec '{}' \"$@\" --vectors '{}'\n", env!("CARGO_BIN_EXE_ncp-verify"), vectors.display());
    std::fs::write(&verify, script).unwrap();
    std::fs::set_permissions(&verify, std::os::unix::fs::PermissionsExt::from_mode(0o755)).unwrap();
    for (mode, exit) in [("honest", 0), ("wrong-answer", 1)] {
        let peer_toml = format!(
            "name = \"p\"\nlanguage = \"Rust\"\ncommand = [{}]\n",
            peer(mode).split(' ').map(|word| format!("{word:?}")).collect::<Vec<_>>().join(", ")
        );
        std::fs::create_dir_all(folder.path().join("mine")).unwrap();
        std::fs::write(folder.path().join("mine/peer.toml"), peer_toml).unwrap();
        let sh = |command: &str, part: &str| {
            let mut sh = Command::new("sh");
            sh.current_dir(folder.path()).arg("-c").arg(command.replace("--level strict", "--level wire"));
            sh.env("NCP_VERIFY", &verify).env("PARTS", "4").env("PART", part).env("PEER", "mine");
            sh.env("GITHUB_STEP_SUMMARY", folder.path().join("summary")).output().unwrap()
        };
        for part in ["1", "2", "3", "4"] {
            let run = sh(&step("run"), part);
            assert_eq!(run.status.code(), Some(0), "{}", String::from_utf8_lossy(&run.stderr));
        }
        let merged = sh(&step("merge"), "");
        assert_eq!(merged.status.code(), Some(exit), "{}", String::from_utf8_lossy(&merged.stderr));
        assert!(sh(&step("show"), "").status.success());
        let result = read(&folder.path().join("shards/result.json"));
        assert_eq!((result["exit_code"].as_i64(), result["asked"]["shard"].is_null()), (Some(exit.into()), true));
        assert!(std::fs::read_to_string(folder.path().join("summary")).unwrap().contains("## NCP "));
    }
}
