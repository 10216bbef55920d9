//! The real program against peers that do what a peer may not: each ends in bounded time, with the right exit code
//! and the right case named.

#![cfg(unix)]
#![expect(clippy::unwrap_used, reason = "a test may fail that way")]

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

use ncp_text::{CONTRACT_HASH, WIRE_VERSION};
use serde_json::{Value, json};

mod common;
mod made;
#[path = "made/versions.rs"]
mod versions;

const TARGET: &str = "version/tiny/07-target";
/// Far more than any of these runs may take, far less than a peer that hangs.
const BOUND: Duration = Duration::from_secs(45);

/// What a run of the program left.
struct Run {
    exit: i32,
    stdout: String,
    stderr: String,
    result: Option<Value>,
}

impl Run {
    /// The cases that did not pass: id and outcome.
    fn faults(&self) -> BTreeMap<String, String> {
        let cases = self.result.as_ref().unwrap()["peers"][0]["cases"].as_array().unwrap();
        let text = |value: &Value| value.as_str().unwrap().to_owned();
        cases.iter().filter(|c| c["outcome"] != "pass").map(|c| (text(&c["id"]), text(&c["outcome"]))).collect()
    }

    fn case(&self, id: &str) -> &Value {
        let cases = self.result.as_ref().unwrap()["peers"][0]["cases"].as_array().unwrap();
        cases.iter().find(|case| case["id"] == id).unwrap()
    }
}

fn example(name: &str) -> PathBuf {
    Path::new(env!("CARGO_BIN_EXE_ncp-verify")).parent().unwrap().join("examples").join(name)
}

fn verify(args: &[&str]) -> Run {
    verify_by("tests/data/vectors", args)
}

/// Runs the program by the vectors of a folder.
fn verify_by(vectors: &str, args: &[&str]) -> Run {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("result.json");
    let start = Instant::now();
    let output: Output = Command::new(env!("CARGO_BIN_EXE_ncp-verify"))
        .env("COLUMNS", "200")
        .args(["run", "--vectors", vectors, "--start-timeout", "2", "--json"])
        .arg(&file)
        .args(args)
        .stdin(Stdio::null())
        .output()
        .unwrap();
    assert!(start.elapsed() < BOUND, "{args:?} took {:?}", start.elapsed());
    let result = std::fs::read_to_string(&file).ok().map(|text| common::read_result(&text));
    Run {
        exit: output.status.code().unwrap(),
        stdout: String::from_utf8(output.stdout).unwrap(),
        stderr: String::from_utf8(output.stderr).unwrap(),
        result,
    }
}

/// Runs the hostile peer in a mode.
fn hostile(mode: &str, args: &[&str]) -> Run {
    let command = format!("{} {mode}", example("hostile-peer").display());
    // Short only where it is waited for, so that a busy machine makes no peer look slow.
    let hangs = ["sleep", "skips", "stops"].iter().any(|word| mode.contains(word));
    verify(&[&["--peer-cmd", &command, "--timeout", if hangs { "1" } else { "10" }], args].concat())
}

fn thousands(number: u64) -> String {
    if number < 1000 { number.to_string() } else { format!("{},{:03}", number / 1000, number % 1000) }
}

const BODY: &str = r#""roles":["body"]"#;

/// What a peer that is a shell script says about itself; `more`: its roles, and what else it claims.
fn describe(more: &str) -> String {
    let said = json!({"name": "sh", "version": "1", "language": "sh", "wire_version": WIRE_VERSION});
    let said = said.to_string().replace('}', &format!(r#","contract_hash":"{CONTRACT_HASH}",{more}}}"#));
    format!(r#"echo '{{"id":0,"result":{said}}}'"#)
}

/// Runs a shell script as a peer, after it has described itself.
fn script(script: &str) -> Run {
    whole_script(&format!("read line\n{}\n{script}", describe(BODY)))
}

/// Runs a shell script as a peer, from its start.
fn whole_script(script: &str) -> Run {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("peer.sh");
    std::fs::write(&file, format!("{script}\n")).unwrap();
    verify(&["--peer-cmd", &format!("sh {}", file.display())])
}

/// Runs a server that answers every request by `ok`, and says of the reference networks what it is told to.
fn server(ok: bool, reference_networks: &str) -> Run {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("peer.sh");
    let describe = describe(&format!(r#""roles":["server"],"reference_networks":{reference_networks}"#));
    let reply = format!(r#"{{\"kind\":\"session_opened\",\"session_id\":\"a\",\"ok\":{ok}}}"#);
    let answer = format!(r#"printf '{{"id":%d,"result":{{"replies":["%s"]}}}}\n' $n '{reply}'"#);
    let script = format!("read line\n{describe}\nn=0\nwhile read line; do n=$((n+1)); {answer}; done\n");
    std::fs::write(&file, script).unwrap();
    let command = format!("sh {}", file.display());
    verify_by("tests/data/needs", &["--level", "safety", "--peer-cmd", &command])
}

#[test]
fn a_server_without_the_reference_networks_is_not_asked_of_them_and_the_report_says_so() {
    let run = server(true, "null");
    assert_eq!(run.exit, 0, "{}{}", run.stdout, run.stderr);
    assert!(run.stdout.contains("1 case was not asked"), "{}", run.stdout);
    assert!(run.stdout.contains("reference networks"), "{}", run.stdout);
    assert!(!run.stdout.contains("no session was opened"), "{}", run.stdout);
    let peer = &run.result.as_ref().unwrap()["peers"][0];
    let counted = json!([{"needs": "reference_networks", "cases": 1}]);
    assert_eq!(peer["not_asked"], counted);
    // `describe`, and the case for every server.
    assert_eq!(peer["totals"]["total"], 2);
}

#[test]
fn a_server_that_claims_the_reference_networks_must_open_them() {
    let run = server(false, "true");
    assert_eq!(run.exit, 1, "{}", run.stdout);
    let fails = run.faults();
    assert_eq!(fails.keys().collect::<Vec<_>>(), ["session/tiny/opened"]);
    let run = server(true, "true");
    assert_eq!((run.exit, run.faults().len()), (0, 0), "{}", run.stdout);
    assert_eq!(run.result.unwrap()["peers"][0]["not_asked"], json!([]));
}

#[test]
fn of_a_server_that_opens_nothing_the_report_says_that_its_passes_show_nothing() {
    let run = server(false, "false");
    assert_eq!((run.exit, run.faults().len()), (0, 0), "{}", run.stdout);
    assert!(run.stdout.contains("no session was opened"), "{}", run.stdout);
}

#[test]
fn an_honest_peer_conforms() {
    let run = hostile("honest", &[]);
    assert_eq!((run.exit, run.faults().len()), (0, 0), "{}", run.stdout);
    assert!(run.stdout.contains("the peer conforms at level wire"), "{}", run.stdout);
    assert_eq!(run.result.unwrap()["peers"][0]["conclusion"], "conformant");
}

#[test]
fn the_schema_of_the_result_rejects_what_is_no_result() {
    let result = hostile("wrong-answer", &[]).result.unwrap();
    let faults = |change: &dyn Fn(&mut Value)| {
        let mut changed = result.clone();
        change(&mut changed);
        common::schema_faults(&changed).len()
    };
    assert_eq!(faults(&|_| {}), 0);
    assert_ne!(faults(&|result| result["exit_code"] = json!(2)), 0);
    assert_ne!(faults(&|result| result["peers"][0]["cases"][3]["outcome"] = json!("passed")), 0);
    assert_ne!(faults(&|result| result["peers"][0]["roles"][0]["levels"][0]["cases"]["passed"] = json!(-1)), 0);
    assert_ne!(faults(&|result| result["more"] = json!(1)), 0);
    assert_ne!(faults(&|result| drop(result.as_object_mut().unwrap().remove("corpus"))), 0);
}

#[test]
fn a_fault_that_belongs_to_one_case_is_charged_to_that_case_alone() {
    for (mode, outcome) in [
        ("wrong-answer", "fail"),
        ("die-on-target", "crash"),
        ("die-after-target", "crash"),
        ("sleep-on-target", "timeout"),
        ("skips-target", "timeout"),
        ("binary-on-target", "protocol"),
        ("prints-after-target", "protocol"),
        ("prints-late-after-target", "protocol"),
        ("twice-on-target", "protocol"),
        ("unknown-id-on-target", "protocol"),
        ("no-result-on-target", "protocol"),
        ("huge-line-on-target", "protocol"),
        ("half-a-line-on-target", "protocol"),
    ] {
        let run = hostile(mode, &[]);
        let expected = BTreeMap::from([(TARGET.to_owned(), outcome.to_owned())]);
        assert_eq!((run.exit, run.faults()), (1, expected), "{mode}: {}", run.stdout);
        assert!(run.stdout.contains(&format!("✗ {TARGET} [{outcome}]")), "{mode}: {}", run.stdout);
    }
}

#[test]
fn a_fault_is_found_with_several_processes_and_repetitions_too() {
    let run = hostile("die-on-target", &["--jobs", "3", "--repeat", "5"]);
    assert_eq!((run.exit, run.faults().len()), (1, 1), "{}", run.stdout);
    assert_eq!(run.case(TARGET)["outcome"], "crash");
}

#[test]
fn a_peer_that_dies_on_its_7th_request_is_charged_with_the_request_that_was_open() {
    // `describe` is the first request of a process, so the seventh is the sixth case.
    for (mode, outcome) in [("die-on-7th", "crash"), ("skips-7th", "timeout")] {
        let run = hostile(mode, &[]);
        assert_eq!(run.exit, 1, "{mode}");
        assert_eq!(run.case("version/tiny/06-letter")["outcome"], outcome, "{mode}: {}", run.stdout);
    }
    let run = hostile("die-on-7th", &[]);
    let note = run.case("version/tiny/06-letter")["note"].as_str().unwrap().to_owned();
    assert!(note.contains("alone, in a fresh process, it was answered"), "{note}");
}

#[test]
fn what_a_peer_wrote_to_its_log_is_shown_with_its_crash() {
    let run = hostile("die-on-target", &[]);
    assert!(run.stdout.contains("it died of signal: 6 (SIGABRT)"), "{}", run.stdout);
    assert!(run.stdout.contains("| assertion failed: version < 9"), "{}", run.stdout);
}

#[test]
fn a_peer_that_answers_nothing_is_given_up_and_the_rest_is_not_run() {
    for mode in ["die-on-every-case", "sleep-forever", "binary-on-every-case", "stops-reading"] {
        let run = hostile(mode, &[]);
        assert_eq!(run.exit, 1, "{mode}");
        let faults = run.faults();
        assert!(faults.contains_key("version/tiny/01-same"), "{mode}: {faults:?}");
        assert_ne!(faults["version/tiny/01-same"], "not run", "{mode}");
        assert!(faults.values().filter(|outcome| *outcome == "not run").count() >= 10, "{mode}: {faults:?}");
        assert!(run.stdout.contains("it has not answered one case in "), "{mode}: {}", run.stdout);
        let faults = run.result.unwrap()["peers"][0]["run"]["faults"].as_u64().unwrap();
        assert!(faults <= 6, "{mode}: {faults}");
    }
}

/// A folder of vectors with traces of the governor: one about the latch, and one about the reset that rests on it.
fn traces(folder: &Path) -> String {
    let govern = |mode: &str| {
        let command = json!({"seq": 1, "mode": mode, "channels": {"velocity_setpoint": {"data": [1.0, 0.0, 0.0]}}});
        json!({"op": "govern", "now_s": 1.0, "last_sensor_s": 1.0, "sensor": null, "command": command})
    };
    let mode = |mode: &str| json!({"frame": {"mode": mode}});
    let case = |id: &str, rule: &str, by: Value, steps: Value, answers: Value| {
        json!({
            "id": format!("safety/trace/{id}"), "title": "A trace.", "requirements": [rule], "flags": ["latch"],
            "roles": ["commander"], "call": "governor.run",
            "args": {"limits": {}, "capabilities": null, "steps": steps},
            "expect": {"relation": "pattern", "value": {"steps": answers}}, "by": by, "why": "W."
        })
    };
    let reset = json!({"op": "reset"});
    let latch = [govern("estop"), govern("active")];
    let longer: Vec<Value> = latch.iter().cloned().chain([reset]).chain((0..9).map(|_| govern("active"))).collect();
    let answers: Vec<Value> =
        [mode("estop"), mode("estop"), json!({})].into_iter().chain((0..9).map(|_| mode("active"))).collect();
    let cases = [
        case(
            "latched",
            "NCP-SAFE-004",
            json!({"crash": "NCP-SAFE-005"}),
            json!(latch),
            json!([mode("estop"), mode("estop")]),
        ),
        case("reset", "NCP-SAFE-008", json!({"/steps/1": "NCP-SAFE-004"}), json!(longer), json!(answers)),
    ];
    made::vectors(folder, "safety", "trace", "latch", &cases)
}

#[test]
fn a_trace_is_shown_by_its_steps_and_what_rests_on_a_broken_rule_waits_for_it() {
    let folder = tempfile::tempdir().unwrap();
    let vectors = traces(folder.path());
    // Every frame is active, so that the latch is lost; both traces fail in their second step.
    let frame = format!(r#"{{"frame":{{"ncp_version":"{WIRE_VERSION}","seq":1,"mode":"active"}}}}"#);
    let first = frame.replace("active", "estop");
    let rest = [frame.as_str(); 9].join(",");
    let answers = [format!("{first},{frame}"), format!("{first},{frame},{{}},{rest}")];
    let say = |n: usize| format!("echo '{{\"id\":{n},\"result\":{{\"steps\":[{}]}}}}'", answers[n - 1]);
    let file = folder.path().join("peer.sh");
    let lines = [
        "read line".to_owned(),
        describe(BODY).replace("body", "commander"),
        "read line".to_owned(),
        say(1),
        "read line".to_owned(),
        say(2),
    ];
    std::fs::write(&file, lines.join("\n") + "\nread line\n").unwrap();
    let peer = format!("sh {}", file.display());
    for (name, columns) in [("trace_80", "80"), ("trace_200", "200")] {
        let output = Command::new(env!("CARGO_BIN_EXE_ncp-verify"))
            .env("COLUMNS", columns)
            .args(["run", "--vectors", &vectors, "--peer-cmd", &peer, "--level", "safety", "--examples", "2", "--json"])
            .arg(folder.path().join("result.json"))
            .stdin(Stdio::null())
            .output()
            .unwrap();
        assert_eq!(output.status.code(), Some(1), "{}", String::from_utf8_lossy(&output.stderr));
        let text = String::from_utf8(output.stdout).unwrap();
        let width: usize = columns.parse().unwrap();
        assert!(text.lines().all(|line| line.chars().count() <= width || line.contains("result:")), "{text}");
        let even = text.replace(&folder.path().display().to_string(), "FOLDER").replace(WIRE_VERSION, "VERSION");
        let lines: Vec<String> = even.lines().map(without_line_number).collect();
        insta::assert_snapshot!(name, lines.join("\n"));
    }
    let result = common::read_result(&std::fs::read_to_string(folder.path().join("result.json")).unwrap());
    let rules = result["rules"].as_array().unwrap();
    let of = |id: &str| rules.iter().find(|rule| rule["id"] == id).unwrap();
    assert_eq!((&of("NCP-SAFE-004")["severity"], &of("NCP-SAFE-004")["cases"]), (&json!("plant"), &json!(1)));
}

/// A line without the number of the line of the text on which a rule stands.
fn without_line_number(line: &str) -> String {
    match line.split_once(".md:") {
        Some((before, _)) => format!("{before}.md:LINE"),
        None => line.to_owned(),
    }
}

#[test]
fn a_call_that_always_crashes_costs_its_cases_and_no_others() {
    // The first ten cases, and all of its call: other calls are tried before the peer is given up.
    let run = hostile("die-on-checks", &[]);
    let faults = run.faults();
    assert_eq!((run.exit, faults.len()), (1, 10), "{}", run.stdout);
    assert!(faults.iter().all(|(case, outcome)| case.starts_with("version/") && outcome == "crash"), "{faults:?}");
}

#[test]
fn a_peer_that_breaks_for_good_is_given_up_when_it_no_longer_answers_what_it_has_answered() {
    let folder = tempfile::tempdir().unwrap();
    let vectors = versions::many(folder.path(), 100);
    let flag = folder.path().join("broken");
    let command = format!("{} die-once-broken {}", example("hostile-peer").display(), flag.display());
    let run = verify_by(&vectors, &["--peer-cmd", &command]);
    assert_eq!(run.exit, 1);
    assert!(run.stdout.contains("it no longer answers what it has answered before"), "{}", run.stdout);
    let faults = run.faults();
    let count = |wanted: &str| faults.values().filter(|outcome| *outcome == wanted).count();
    assert_eq!(faults.len(), 100 - 9, "9.0 to 9.8 are answered: {faults:?}");
    assert!(count("crash") <= 10 && count("not run") >= 80, "{faults:?}");
}

#[test]
fn a_peer_that_dies_a_thousand_times_is_run_to_its_end() {
    let folder = tempfile::tempdir().unwrap();
    let vectors = versions::many(folder.path(), 2000);
    let command = format!("{} die-on-even", example("hostile-peer").display());
    let run = verify_by(&vectors, &["--peer-cmd", &command]);
    let faults = run.faults();
    assert_eq!((run.exit, faults.len()), (1, 1000), "{}", run.stdout);
    assert!(faults.values().all(|outcome| outcome == "crash"));
    let peer = &run.result.as_ref().unwrap()["peers"][0];
    assert_eq!((&peer["totals"]["not_run"], &peer["run"]["given_up"]), (&json!(0), &Value::Null));
    // One a case, and one for each window of requests in which it is not yet known whose it was.
    let deaths = peer["run"]["faults"].as_u64().unwrap();
    assert!((1000..=1050).contains(&deaths), "{deaths}");
    assert!(
        run.stdout.contains(&format!("its process ended out of turn {} times", thousands(deaths))),
        "{}",
        run.stdout
    );
    assert!(run.stderr.lines().count() < 10, "{}", run.stderr);
}

#[test]
fn a_run_with_a_hundred_and_fifty_crashes_among_many_cases_is_complete() {
    let folder = tempfile::tempdir().unwrap();
    let vectors = versions::many(folder.path(), 8000);
    let command = format!("{} die-on-150", example("hostile-peer").display());
    let run = verify_by(&vectors, &["--peer-cmd", &command]);
    assert_eq!((run.exit, run.faults().len()), (1, 150), "{}", run.stdout);
    assert!(run.stdout.contains("complete: 8,001 cases run"), "{}", run.stdout);
}

#[test]
fn crashes_leave_short_logs_and_one_whole_one() {
    let folder = tempfile::tempdir().unwrap();
    let vectors = versions::many(folder.path(), 4);
    let command = format!("{} die-on-even", example("hostile-peer").display());
    let run = verify_by(&vectors, &["--peer-cmd", &command]);
    for case in ["version/many/0", "version/many/2"] {
        assert_eq!(run.case(case)["log"], "the minor version is even");
    }
    let kept = &run.result.as_ref().unwrap()["peers"][0]["run"]["crash_log"];
    assert_eq!(kept["case"], "version/many/0");
    let log = kept["log"].as_str().unwrap();
    assert!(log.starts_with("the minor version is even\nframe 0\n") && log.ends_with("\nframe 39"), "{log}");
}

#[test]
fn restarts_are_bounded() {
    let run = hostile("die-on-7th", &["--max-restarts", "0"]);
    assert_eq!(run.exit, 1);
    assert_eq!(run.case("version/tiny/06-letter")["outcome"], "crash");
    assert!(run.faults().values().any(|outcome| outcome == "not run"));
    assert!(run.stdout.contains("the peer was given up: after 0 restarts it exited with status 101"), "{}", run.stdout);
}

#[test]
fn a_peer_that_answers_everything_twice_is_charged_case_by_case() {
    let run = hostile("twice-always", &[]);
    assert_eq!(run.exit, 1);
    assert_eq!(run.faults().values().filter(|outcome| *outcome == "protocol").count(), 16, "{:?}", run.faults());
}

#[test]
fn what_is_odd_but_harmless_costs_nothing() {
    for mode in ["floods-stderr", "slow", "other-codes", "talkative"] {
        let run = hostile(mode, &[]);
        assert_eq!((run.exit, run.faults().len()), (0, 0), "{mode}: {}", run.stdout);
    }
    let run = hostile("unordered", &["--filter", "version/*"]);
    assert_eq!((run.exit, run.faults().len()), (0, 0), "{}", run.stdout);
}

#[test]
fn another_error_code_is_noted_and_not_judged() {
    let run = hostile("other-codes", &["--verbose"]);
    assert_eq!(run.case("version/tiny/05-empty")["note"], "refused as `limit`; the text suggests `version`");
    assert!(run.stdout.contains("refused as `limit`; the text suggests"), "{}", run.stdout);
}

#[test]
fn a_caught_crash_is_no_refusal() {
    let run = hostile("panics", &["--verbose"]);
    assert_eq!(run.case("version/tiny/05-empty")["outcome"], "fail");
    assert!(run.stdout.contains("a crash is no refusal"), "{}", run.stdout);
}

#[test]
fn how_a_peer_ends_is_noted() {
    for (mode, note) in [
        ("never-ends", "2 s after the end of its input it was still running, and was killed"),
        ("ends-badly", "at the end of its input it exited with status 5 instead of 0"),
        ("prints-at-the-end", "at the end of its input it printed something that is no answer"),
    ] {
        let run = hostile(mode, &[]);
        assert_eq!(run.exit, 0, "{mode}: {}", run.stdout);
        let notes = run.result.unwrap()["peers"][0]["run"]["notes"].to_string();
        assert!(notes.contains(note), "{mode}: {notes}");
    }
}

#[test]
fn unsupported_calls_in_a_claimed_role_fail_and_are_summed_up_by_call() {
    let run = hostile("unsupported", &[]);
    assert_eq!(run.exit, 1);
    assert!(run.stdout.contains("17 cases: 1 passing, 16 not implemented"), "{}", run.stdout);
    let lacking = "not implemented at all: decode (6 cases), version.check (10 cases)";
    assert!(run.stdout.contains(lacking), "{}", run.stdout);
}

#[test]
fn a_peer_that_cannot_be_started_is_told_at_once_in_one_message() {
    for (command, message) in [
        ("surely-no-such-program", "error: there is no program `surely-no-such-program` on PATH"),
        ("./no/such/peer", "error: there is no program `./no/such/peer`"),
        ("tests/data/vectors/wire/tiny.json", "error: `tests/data/vectors/wire/tiny.json` is not executable"),
        ("true", "error: `true` exited with status 0 before it answered `describe`"),
        ("cat", "error: `cat` does not speak the peer protocol: "),
        ("echo hello", "error: `echo hello` does not speak the peer protocol: "),
        ("sh -c 'exec >&-; sleep 60'", "closed its standard output but kept running before it answered `describe`"),
        ("sleep 60", "error: `sleep 60` did not answer `describe` within 2 s"),
        ("'unclosed", "cannot be taken apart"),
    ] {
        let start = Instant::now();
        let run = verify(&["--peer-cmd", command]);
        assert_eq!(run.exit, 3, "{command}: {}", run.stderr);
        assert!(run.stderr.contains(message), "{command}: {}", run.stderr);
        assert_eq!((run.stderr.matches("error:").count(), run.stdout.as_str()), (1, ""), "{command}");
        assert!(start.elapsed() < Duration::from_secs(10), "{command}");
    }
    for (mode, message) in [
        (
            "exits-at-once",
            "exited with status 7 before it answered `describe`\nit had written to stderr:\n  | no configuration found",
        ),
        ("says-hello", "its first line: Hello, I am a peer."),
        ("half-described", "its `roles` is null, not an array"),
    ] {
        let run = hostile(mode, &[]);
        assert_eq!(run.exit, 3, "{mode}");
        assert!(run.stderr.contains(message), "{mode}: {}", run.stderr);
    }
}

#[test]
fn a_wrong_description_fails_the_case_of_describe() {
    for mode in ["wrong-describe", "claims-nothing"] {
        let run = hostile(mode, &[]);
        assert_eq!((run.exit, run.case("describe")["outcome"].as_str()), (1, Some("fail")), "{mode}");
    }
}

#[test]
fn a_peer_that_closes_its_output_and_runs_on_is_a_crash_of_the_case() {
    let run = script("read line; exec >&-; trap '' TERM; sleep 60");
    assert_eq!(run.exit, 1);
    assert_eq!(run.case("version/tiny/01-same")["outcome"], "crash");
    assert_eq!(run.case("version/tiny/01-same")["what"], "closed its standard output but kept running");
}

#[test]
fn a_peer_that_stops_taking_requests_is_a_crash_of_the_case() {
    // It closes its input before it describes itself, and no case is sent before that: the first write is in vain.
    let run = whole_script(&format!("read line\nexec <&-\n{}\nsleep 60", describe(BODY)));
    assert_eq!(run.exit, 1);
    let case = run.case("version/tiny/01-same");
    assert_eq!((case["outcome"].as_str(), case["what"].as_str()), (Some("crash"), Some("closed its standard input")));
}

#[test]
fn a_peer_whose_child_outlives_it_is_ended_with_its_child() {
    let folder = tempfile::tempdir().unwrap();
    let pid = folder.path().join("pid");
    let run = script(&format!("sleep 300 & echo $! > {}; read line; exit 4", pid.display()));
    assert_eq!(run.case("version/tiny/01-same")["what"], "exited with status 4");
    let pid = std::fs::read_to_string(pid).unwrap();
    let stat = std::fs::read_to_string(format!("/proc/{}/stat", pid.trim())).unwrap_or_default();
    assert!(stat.is_empty() || stat.contains(") Z "), "{stat}");
}

#[test]
fn ctrl_c_ends_the_peer_and_still_writes_the_report() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("result.json");
    let mut child = Command::new(env!("CARGO_BIN_EXE_ncp-verify"))
        .args(["run", "--vectors", "tests/data/vectors", "--json"])
        .arg(&file)
        .arg("--peer-cmd")
        .arg(format!("{} sleep-on-target", example("hostile-peer").display()))
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .spawn()
        .unwrap();
    std::thread::sleep(Duration::from_secs(3));
    let pid = rustix::process::Pid::from_child(&child);
    rustix::process::kill_process(pid, rustix::process::Signal::INT).unwrap();
    let start = Instant::now();
    let status = child.wait().unwrap();
    assert!(start.elapsed() < Duration::from_secs(5));
    assert_eq!(status.code(), Some(130));
    let result = common::read_result(&std::fs::read_to_string(&file).unwrap());
    assert_eq!(result["interrupted"], true);
    let cases = result["peers"][0]["cases"].as_array().unwrap();
    let outcome = |id: &str| cases.iter().find(|case| case["id"] == id).unwrap()["outcome"].clone();
    assert_eq!((outcome("version/tiny/01-same"), outcome(TARGET)), ("pass".into(), "not run".into()));
}
