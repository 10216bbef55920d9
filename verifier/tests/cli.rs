//! The real program as people use it: what it prints, what it writes, how it ends.

#![cfg(unix)]
#![expect(clippy::unwrap_used, reason = "a test may fail that way")]

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use ncp_text::WIRE_VERSION;
use serde_json::Value;

mod common;

struct Run {
    exit: i32,
    stdout: String,
    stderr: String,
}

fn program() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ncp-verify"));
    command.stdin(Stdio::null()).env_remove("NO_COLOR").env_remove("COLUMNS");
    command
}

fn run(command: &mut Command) -> Run {
    let output = command.output().unwrap();
    Run {
        exit: output.status.code().unwrap(),
        stdout: String::from_utf8(output.stdout).unwrap(),
        stderr: String::from_utf8(output.stderr).unwrap(),
    }
}

/// Runs a subcommand on the test vectors.
fn verify(args: &[&str]) -> Run {
    run(program().args(args).args(["--vectors", "tests/data/vectors"]))
}

fn peer(mode: &str) -> String {
    let examples = Path::new(env!("CARGO_BIN_EXE_ncp-verify")).parent().unwrap().join("examples");
    format!("{} {mode}", examples.join("hostile-peer").display())
}

/// A report on the hostile peer in a mode, as wide as `columns`, with what differs from run to run made even.
fn report(mode: &str, columns: &str, args: &[&str]) -> String {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("result.json");
    let run = run(program()
        .env("COLUMNS", columns)
        .args(["run", "--vectors", "tests/data/vectors", "--peer-cmd", &peer(mode), "--json"])
        .arg(&file)
        .args(args));
    let text = run.stdout.replace(&file.display().to_string(), "RESULT");
    without_lines(&text.replace(&format!("NCP {WIRE_VERSION}"), "NCP VERSION"))
}

/// The lines of the text on which its rules stand are none of this test's business.
fn without_lines(text: &str) -> String {
    let mut parts = text.split(".md:");
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        out.push_str(".md:LINE");
        out.push_str(part.trim_start_matches(|c: char| c.is_ascii_digit()));
    }
    out
}

/// An explanation as it is outside of the source tree, whose code is none of a snapshot's business.
fn explained(id: &str) -> String {
    let elsewhere = tempfile::tempdir().unwrap();
    let vectors = std::path::absolute("tests/data/vectors").unwrap();
    let run = run(program().current_dir(elsewhere.path()).args(["explain", id, "--vectors"]).arg(vectors));
    without_lines(&run.stdout)
}

#[test]
fn bash_completes_commands_options_and_values() {
    let script = verify(&["completions", "bash"]).stdout;
    for (words, completed) in [
        ("expl", "explain"),
        ("run --peer-c", "--peer-cmd"),
        ("check-report --k", "--key"),
        ("list --color al", "always"),
    ] {
        let last = words.split(' ').next_back().unwrap();
        let before = words.split(' ').rev().nth(1).unwrap_or("ncp-verify");
        // As bash calls it: the program, the word that is completed, and the word before.
        let ask = format!(
            "{script}\nCOMP_WORDS=(ncp-verify {words}); COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1))\n\
             $(complete -p ncp-verify | sed 's/.*-F \\([^ ]*\\).*/\\1/') ncp-verify '{last}' '{before}'\n\
             echo \"${{COMPREPLY[@]}}\""
        );
        let asked = run(Command::new("bash").arg("-c").arg(ask));
        assert_eq!(asked.stdout.trim(), completed, "{words}: {}", asked.stderr);
    }
}

#[test]
fn the_version_says_by_what_is_judged() {
    let version = run(program().arg("--version")).stdout;
    let lines: Vec<&str> = version.lines().collect();
    assert_eq!(lines[0], format!("ncp-verify {}", env!("CARGO_PKG_VERSION")));
    assert_eq!(lines[1], format!("wire version   {WIRE_VERSION}"));
    assert_eq!(lines[2], format!("contract hash  {}", ncp_text::CONTRACT_HASH));
    let digest = lines[3].strip_prefix("corpus         sha256:").unwrap();
    assert!(digest.len() == 64 && digest.bytes().all(|byte| byte.is_ascii_hexdigit()), "{version}");
}

#[test]
fn outside_of_a_checkout_a_run_without_a_peer_says_what_to_do() {
    let folder = tempfile::tempdir().unwrap();
    for (args, command) in [(&[][..], "run"), (&["fuzz"], "fuzz")] {
        let run = run(program().args(args).current_dir(folder.path()));
        assert_eq!((run.exit, run.stdout.as_str()), (2, ""));
        let advice = format!("ncp-verify {command} --peer-cmd 'python3 my_adapter.py'");
        assert!(run.stderr.contains(&advice) && run.stderr.contains("ncp-verify starter"), "{}", run.stderr);
    }
}

#[test]
fn the_starter_that_is_printed_is_a_peer() {
    let folder = tempfile::tempdir().unwrap();
    let starter = run(program().arg("starter")).stdout;
    std::fs::write(folder.path().join("adapter.py"), starter).unwrap();
    let vectors = Path::new("tests/data/vectors").canonicalize().unwrap();
    let args = ["run", "--peer-cmd", "python3 adapter.py", "--vectors", vectors.to_str().unwrap()];
    let run = run(program().args(args).current_dir(folder.path()));
    assert_eq!(run.exit, 1, "{}{}", run.stdout, run.stderr);
    assert!(run.stdout.contains("starter"), "{}", run.stdout);
}

#[test]
fn a_report_on_a_conformant_peer_is_a_table_and_a_verdict() {
    insta::assert_snapshot!(report("honest", "100", &[]));
}

#[test]
fn a_report_names_each_failing_case_under_its_rule() {
    insta::assert_snapshot!("report_wide", report("wrong-answer", "100", &[]));
}

#[test]
fn a_report_fits_a_narrow_terminal() {
    let text = report("unsupported", "60", &["--role", "body", "--role", "server"]);
    assert!(text.lines().all(|line| line.chars().count() <= 60), "{text}");
    insta::assert_snapshot!("report_narrow", text);
    let text = report("panics", "60", &[]);
    assert!(text.lines().all(|line| line.chars().count() <= 60), "{text}");
}

#[test]
fn a_crash_is_reported_with_the_end_of_the_log() {
    insta::assert_snapshot!("report_crash", report("die-on-target", "80", &[]));
}

/// The result of the hostile peer in a mode.
fn result_of(folder: &Path, mode: &str) -> PathBuf {
    let file = folder.join(format!("{mode}.json"));
    verify(&["run", "--peer-cmd", &peer(mode), "--json", file.to_str().unwrap()]);
    file
}

#[test]
fn two_results_are_compared_case_by_case_and_a_regression_fails() {
    let folder = tempfile::tempdir().unwrap();
    let [honest, wrong, dead] = ["honest", "wrong-answer", "die-on-target"].map(|mode| result_of(folder.path(), mode));
    let diff = |old: &PathBuf, new: &PathBuf, args: &[&str]| {
        run(program().env("COLUMNS", "80").arg("diff").args([old, new]).args(args))
    };
    let worse = diff(&honest, &wrong, &[]);
    assert_eq!(worse.exit, 1);
    insta::assert_snapshot!("diff_worse", worse.stdout);
    assert!(worse.stdout.lines().all(|line| line.chars().count() <= 80), "{}", worse.stdout);
    let better = diff(&wrong, &honest, &["--markdown"]);
    assert_eq!(better.exit, 0);
    insta::assert_snapshot!("diff_better", better.stdout);
    let other = diff(&wrong, &dead, &["--json"]);
    assert_eq!(other.exit, 0, "a case that failed and now crashes is no regression");
    let compared: Value = serde_json::from_str(&other.stdout).unwrap();
    let change = &compared["peers"][0]["changed"][0];
    assert_eq!((&change["case"], &change["new"]), (&"version/tiny/07-target".into(), &"crash".into()));
    let none = diff(&honest, &folder.path().join("none.json"), &[]);
    assert_eq!((none.exit, none.stdout.as_str()), (2, ""));
    assert!(none.stderr.contains("none.json: No such file"), "{}", none.stderr);
}

#[test]
fn colours_are_written_when_asked_for_and_not_into_a_pipe() {
    assert!(report("wrong-answer", "100", &["--color", "always"]).contains("\u{1b}[1;31m"));
    assert!(!report("wrong-answer", "100", &[]).contains('\u{1b}'));
}

#[test]
fn a_case_is_explained_with_rule_input_expectation_and_reason() {
    insta::assert_snapshot!("explain_case", explained("wire/tiny/02-seq-string"));
    insta::assert_snapshot!("explain_message", explained("wire/tiny/01-whole"));
}

#[test]
fn a_long_input_is_explained_abbreviated() {
    let text = verify(&["explain", "wire/tiny/05-long"]).stdout;
    assert!(text.contains("… (10486"), "{text}");
    let made = text.split_whitespace().collect::<String>();
    assert!(made.contains(r#"madeof{"kind":"sensor_frame","text":{"$concat":["#), "{text}");
    assert!(text.len() < 4000, "{}", text.len());
}

#[test]
fn a_rule_and_a_flag_are_explained_with_their_cases() {
    insta::assert_snapshot!("explain_rule", explained("ncp-ver-004"));
    insta::assert_snapshot!("explain_flag", explained("lenient-reader"));
}

#[test]
fn an_explanation_within_the_source_tree_leads_to_code_and_tests() {
    for (id, wanted) in [
        ("NCP-SAFE-040", ["Code\n", "  spec/src/safety/governor.rs:", "Tests\n", "  spec/tests/governor.rs:"]),
        ("L03", ["NCP-SAFE-040 MUST", "  spec/src/safety/governor.rs:", " cases\n", "  safety/fence/channel/empty\n"]),
        ("l18", ["No case is flagged", "NCP-TRANS-008 MUST", "Code\n", "  spec/src/bus.rs:"]),
        ("safety/fence/channel/empty", ["Expected\n", "Rule\n", "Code\n", "  spec/src/safety/governor.rs:"]),
    ] {
        let text = run(program().args(["explain", id])).stdout;
        for wanted in wanted {
            assert!(text.contains(wanted), "{id} lacks {wanted:?}: {text}");
        }
    }
}

#[test]
fn a_misspelt_id_is_answered_with_the_nearest_ones() {
    let run = verify(&["explain", "wire/tiny/02-seq-strnig"]);
    assert_eq!(run.exit, 2);
    assert!(run.stderr.contains("do you mean one of these?\n  wire/tiny/02-seq-string"), "{}", run.stderr);
    let run = verify(&["explain", "NCP-WIER-007"]);
    assert!(run.stderr.contains("NCP-WIRE-007"), "{}", run.stderr);
    let run = verify(&["explain", "qqqqqqqq"]);
    assert!(run.stderr.contains("ncp-verify list shows all"), "{}", run.stderr);
}

#[test]
fn cases_are_listed_by_filter_role_and_flag() {
    insta::assert_snapshot!("list", verify(&["list"]).stdout);
    let ids = |args: &[&str]| {
        verify(args).stdout.lines().map(|l| l.split(' ').next().unwrap().to_owned()).collect::<Vec<_>>()
    };
    assert_eq!(ids(&["list", "--filter", "NCP-WIRE-007"]), ["wire/tiny/03-twice"]);
    assert_eq!(ids(&["list", "--filter", "*-strict"]), ["version/tiny/02-same-strict", "version/tiny/04-older-strict"]);
    assert_eq!(ids(&["list", "--filter", "lenient-reader"]).len(), 6);
    let none = verify(&["list", "--role", "server"]);
    assert_eq!((none.exit, none.stdout.as_str()), (2, ""));
}

#[test]
fn lists_are_printed_as_json_on_request() {
    let cases: Value = serde_json::from_str(&verify(&["list", "--json"]).stdout).unwrap();
    assert_eq!(cases.as_array().unwrap().len(), 16);
    assert_eq!(cases[0]["id"], "version/tiny/01-same");
    let rules: Value = serde_json::from_str(&verify(&["list", "--requirements", "--json"]).stdout).unwrap();
    let rule = rules.as_array().unwrap().iter().find(|rule| rule["id"] == "NCP-VER-001").unwrap();
    assert_eq!((rule["cases"].as_u64(), rule["keyword"].as_str()), (Some(3), Some("MUST")));
}

#[test]
fn rules_are_listed_with_the_number_of_their_cases() {
    insta::assert_snapshot!("list_rules", verify(&["list", "--requirements", "--filter", "NCP-VER-00?"]).stdout);
}

#[test]
fn what_cannot_be_done_is_a_usage_error_with_one_message() {
    for (args, message) in [
        (&["run"][..], "name a peer: --peer"),
        (&["run", "--peer-cmd", "true", "--filter", "nonsense"], "no case fits --filter nonsense; see ncp-verify list"),
        (&["run", "--peer", "tests/data"], "tests/data/peer.toml: "),
        (
            &["run", "--peer-cmd", "true", "--level", "safety"],
            "there is no case of level safety yet; the highest is wire",
        ),
        (&["run", "--peer-cmd", "true", "--level", "highest"], "invalid value 'highest'"),
        (&["frobnicate"], "unrecognized subcommand"),
    ] {
        let run = verify(args);
        assert_eq!((run.exit, run.stdout.as_str()), (2, ""), "{args:?}");
        assert!(run.stderr.contains(message), "{args:?}: {}", run.stderr);
    }
    let missing = run(program().args(["list", "--vectors", "no/such/folder"]));
    assert_eq!(missing.exit, 2);
}

#[test]
fn a_filter_that_leaves_a_peer_without_a_case_is_a_usage_error() {
    let run = verify(&["run", "--peer-cmd", &peer("honest"), "--filter", "tiny", "--role", "server"]);
    assert_eq!(run.exit, 2, "{}", run.stdout);
}

#[test]
fn a_filtered_run_claims_no_conformance() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("result.json");
    let run =
        verify(&["run", "--peer-cmd", &peer("wrong-answer"), "--filter", "wire/*", "--json", file.to_str().unwrap()]);
    assert_eq!(run.exit, 0, "{}", run.stdout);
    assert!(run.stdout.contains("of all cases only a part was run"), "{}", run.stdout);
    let result = common::read_result(&std::fs::read_to_string(file).unwrap());
    assert_eq!(result["asked"]["partial"], true);
}

#[test]
fn a_faulty_vector_file_is_the_suites_own_fault() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("wire")).unwrap();
    let text = std::fs::read_to_string("tests/data/vectors/wire/tiny.json").unwrap();
    std::fs::write(folder.path().join("wire/tiny.json"), text.replacen("NCP-WIRE-015", "NCP-WIRE-999", 1)).unwrap();
    let run = run(program().args(["list", "--vectors"]).arg(folder.path()));
    assert_eq!(run.exit, 4);
    assert!(
        run.stderr.contains("wire/tiny.json: the case wire/tiny/01-whole: the text has no rule NCP-WIRE-999"),
        "{}",
        run.stderr
    );
}

#[test]
fn a_repeated_run_prints_its_rate() {
    let text = report("honest", "100", &["--repeat", "20", "--filter", "version/*"]);
    let rate = text.lines().find(|line| line.contains("rate:")).unwrap();
    assert!(rate.contains("200 cases of up to 64 KiB in ") && rate.ends_with(" a second"), "{rate}");
}

#[test]
fn junit_has_a_test_for_each_case() {
    let folder = tempfile::tempdir().unwrap();
    let (json, xml) = (folder.path().join("r.json"), folder.path().join("r.xml"));
    let run = verify(&[
        "run",
        "--peer-cmd",
        &peer("die-on-target"),
        "--json",
        json.to_str().unwrap(),
        "--junit",
        xml.to_str().unwrap(),
    ]);
    assert_eq!(run.exit, 1);
    let xml = std::fs::read_to_string(xml).unwrap();
    assert_eq!(xml.matches("<testcase ").count(), 17);
    assert!(
        xml.contains(r#"<testsuite name="hostile" tests="17" skipped="0" errors="1" failures="0""#),
        "{}",
        &xml[..400]
    );
    assert!(xml.contains("version/tiny/07-target"));
}

/// A workspace with bundled peers, and the program run in it.
fn bundled(peers: &[(&str, &str)], args: &[&str]) -> (Run, PathBuf, tempfile::TempDir) {
    bundled_on("tests/data/vectors", peers, args)
}

/// The same, on the vectors of another folder.
fn bundled_on(vectors: &str, peers: &[(&str, &str)], args: &[&str]) -> (Run, PathBuf, tempfile::TempDir) {
    let folder = tempfile::tempdir().unwrap();
    for (name, manifest) in peers {
        let peer = folder.path().join("peers").join(name);
        std::fs::create_dir_all(&peer).unwrap();
        std::fs::write(peer.join("peer.toml"), manifest).unwrap();
    }
    let inner = folder.path().join("peers");
    let vectors = std::path::absolute(vectors).unwrap();
    let run = run(program().current_dir(inner).args(args).arg("--vectors").arg(vectors));
    let result = folder.path().join("reports/run/result.json");
    (run, result, folder)
}

fn manifest(name: &str, mode: &str, more: &str) -> String {
    let words: Vec<String> = peer(mode).split(' ').map(|word| format!("{word:?}")).collect();
    format!("name = {name:?}\nlanguage = \"Rust\"\ncommand = [{}]\n{more}", words.join(", "))
}

#[test]
fn without_a_command_every_bundled_peer_is_set_up_and_checked() {
    let setup = "[[setup]]\nsay = \"make a file\"\ncommand = [\"sh\", \"-c\", \"echo {root} > made\"]\n";
    let (a, b) = (manifest("first", "honest", setup), manifest("second", "honest", ""));
    let (run, result, folder) = bundled(&[("b", &b), ("a", &a)], &[]);
    assert_eq!(run.exit, 0, "{}{}", run.stdout, run.stderr);
    assert!(run.stdout.contains("both peers conform at level wire"), "{}", run.stdout);
    assert!(run.stderr.contains("first: make a file"), "{}", run.stderr);
    let made = std::fs::read_to_string(folder.path().join("peers/a/made")).unwrap();
    assert_eq!(Path::new(made.trim()).canonicalize().unwrap(), folder.path().canonicalize().unwrap());
    let result = common::read_result(&std::fs::read_to_string(result).unwrap());
    assert_eq!(
        (result["peers"][0]["name"].as_str(), result["peers"][1]["name"].as_str()),
        (Some("first"), Some("second"))
    );
    assert_eq!(result["peers"][0]["source"], "peers/a");
}

#[test]
fn a_peer_whose_tool_is_missing_is_skipped_loudly_and_never_counts_as_passed() {
    let (good, lacking) =
        (manifest("good", "honest", ""), manifest("lacking", "honest", "requires = [\"surely-no-such-tool\"]"));
    let (run, result, _folder) = bundled(&[("good", &good), ("lacking", &lacking)], &[]);
    assert_eq!(run.exit, 0, "{}", run.stdout);
    assert!(run.stdout.contains("lacking  SKIPPED not on PATH: surely-no-such-tool"), "{}", run.stdout);
    assert!(run.stdout.contains("1 skipped and so not shown to conform"), "{}", run.stdout);
    assert!(run.stderr.contains("lacking: SKIPPED, not on PATH: surely-no-such-tool"), "{}", run.stderr);
    let result = common::read_result(&std::fs::read_to_string(result).unwrap());
    assert_eq!(
        (result["peers"][1]["state"].as_str(), &result["peers"][1]["conclusion"]),
        (Some("skipped"), &Value::Null)
    );
    let (run, ..) = bundled(&[("lacking", &lacking)], &[]);
    assert_eq!(run.exit, 1, "with nothing checked, nothing conforms: {}", run.stdout);
}

#[test]
fn a_peer_is_held_to_the_level_of_its_manifest_unless_the_command_line_says_another() {
    // A case of level wire that the peer passes, and one of level safety of which it has no call.
    let held = |says: &str, args: &[&str]| {
        let (run, ..) = bundled_on("tests/data/levels", &[("p", &manifest("p", "honest", says))], args);
        let head = run.stdout.lines().next().unwrap_or_default().to_owned();
        (run.exit, head)
    };
    let wire = (0, format!("NCP {WIRE_VERSION}, level wire: 1 case in 1 file"));
    let safety = (1, format!("NCP {WIRE_VERSION}, level safety: 2 cases in 2 files"));
    assert_eq!(held("", &[]), wire);
    assert_eq!(held("level = \"wire\"\n", &[]), wire);
    assert_eq!(held("level = \"safety\"\n", &[]), safety);
    assert_eq!(held("level = \"safety\"\n", &["--level", "wire"]), wire);
    assert_eq!(held("", &["--level", "safety"]), safety);
    assert_eq!(held("level = \"high\"\n", &[]).0, 2);
}

#[test]
fn each_peer_is_held_to_its_own_level() {
    let (low, high) = (manifest("low", "honest", ""), manifest("high", "honest", "level = \"safety\"\n"));
    let (run, result, _folder) = bundled_on("tests/data/levels", &[("a", &low), ("b", &high)], &[]);
    assert_eq!(run.exit, 1, "{}", run.stdout);
    let closing = "1 of 2 peers conform at the level that each claims";
    assert!(run.stdout.contains(closing), "{}", run.stdout);
    let result = common::read_result(&std::fs::read_to_string(result).unwrap());
    let conclusion = |nth: usize| result["peers"][nth]["conclusion"].clone();
    assert_eq!((conclusion(0), conclusion(1)), ("conformant".into(), "not conformant".into()));
    assert_eq!(result["peers"][0]["totals"]["total"], 2, "describe and one case");
}

#[test]
fn the_head_of_a_report_counts_the_cases_that_are_meant() {
    let head = |args: &[&str]| {
        let text = report("honest", "100", args);
        text.lines().next().unwrap_or_default().to_owned()
    };
    assert_eq!(head(&[]), "NCP VERSION, level wire: 16 cases in 2 files");
    assert_eq!(head(&["--filter", "version/*"]), "NCP VERSION, level wire: 10 cases in 1 file");
}

#[test]
fn one_peer_that_does_not_conform_fails_the_run_and_one_that_does_not_start_too() {
    let (good, bad) = (manifest("good", "honest", ""), manifest("bad", "wrong-answer", ""));
    let (run, ..) = bundled(&[("good", &good), ("bad", &bad)], &[]);
    assert_eq!(run.exit, 1);
    assert!(run.stdout.contains("1 of 2 peers conform at level wire"), "{}", run.stdout);
    let broken = "[[setup]]\nsay = \"build\"\ncommand = [\"sh\", \"-c\", \"echo undefined symbol; exit 2\"]\n";
    let (run, ..) = bundled(&[("good", &good), ("bad", &manifest("broken", "honest", broken))], &[]);
    assert_eq!(run.exit, 3);
    assert!(
        run.stderr.contains("broken: its set-up failed: ") && run.stderr.contains("| undefined symbol"),
        "{}",
        run.stderr
    );
    assert!(run.stdout.contains("broken  NOT STARTED"), "{}", run.stdout);
}

#[test]
fn an_expected_failure_passes_the_run_without_claiming_conformance() {
    let known = "[[expected-failures]]\ncase = \"version/tiny/07-target\"\nreason = \"issue 7\"\n";
    let (run, ..) = bundled(&[("p", &manifest("p", "wrong-answer", known))], &[]);
    assert_eq!(run.exit, 0, "{}", run.stdout);
    assert!(
        run.stdout.contains("the peer does not conform at level wire; 1 exactly as its expected failures say"),
        "{}",
        run.stdout
    );
    assert!(run.stdout.contains("1 case fails as expected"), "{}", run.stdout);
    assert!(run.stdout.contains("1 case version/tiny/07-target: issue 7"), "{}", run.stdout);
}

#[test]
fn an_expected_failure_that_passes_fails_the_run() {
    let known = "[[expected-failures]]\ncase = \"version/tiny/07-target\"\nreason = \"issue 7\"\n";
    let (run, ..) = bundled(&[("p", &manifest("p", "honest", known))], &[]);
    assert_eq!(run.exit, 1, "{}", run.stdout);
    assert!(
        run.stdout.contains("the expected failure of case version/tiny/07-target no longer fails"),
        "{}",
        run.stdout
    );
    let (run, ..) = bundled(&[("p", &manifest("p", "honest", &known.replace("07-target", "77")))], &[]);
    assert_eq!(run.exit, 2);
    assert!(run.stderr.contains("names the case version/tiny/77, which the suite does not have"), "{}", run.stderr);
}

#[test]
fn the_failures_of_a_peer_are_written_as_a_list_under_which_it_does_as_expected() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).display().to_string();
    let (list, result) = (path("known.toml"), path("result.json"));
    let checked =
        |mode: &str, args: &[&str]| verify(&[&["run", "--json", &result, "--peer-cmd", &peer(mode)], args].concat());
    for mode in ["wrong-answer", "die-on-target", "unsupported"] {
        assert_eq!(checked(mode, &["--write-expected", &list]).exit, 1, "{mode}");
        let run = checked(mode, &["--expected", &list]);
        assert_eq!(run.exit, 0, "{mode}: {}{}", run.stdout, run.stderr);
        assert!(run.stdout.contains("1 exactly as its expected failures say"), "{mode}: {}", run.stdout);
        assert!(run.stdout.contains("no reason is given"), "{mode}: {}", run.stdout);
        // What another peer does right, or wrong in another way, the list does not hold.
        assert_eq!(checked("honest", &["--expected", &list]).exit, 1, "{mode}");
    }
    checked("die-on-target", &["--write-expected", &list]);
    let written = std::fs::read_to_string(&list).unwrap();
    insta::assert_snapshot!("expected_list", written);
    let run = checked("wrong-answer", &["--expected", &list]);
    assert_eq!(run.exit, 1);
    assert!(run.stdout.contains("outcome crash, case version/tiny/07-target no"), "{}", run.stdout);
    // A reason that was filled in is kept when the list is written anew.
    std::fs::write(&list, written.replace("reason = \"\"", "reason = \"issue 7\"")).unwrap();
    assert_eq!(checked("die-on-target", &["--expected", &list, "--write-expected", &list]).exit, 0);
    assert!(std::fs::read_to_string(&list).unwrap().contains("reason = \"issue 7\""));
    std::fs::write(&list, format!("{written}expires = \"2020-01-31\"\n")).unwrap();
    let run = checked("die-on-target", &["--expected", &list]);
    assert_eq!(run.exit, 1);
    assert!(run.stdout.contains("expired on 2020-01-31"), "{}", run.stdout);
}

#[test]
fn an_entry_by_a_rule_that_excuses_more_than_when_it_was_written_is_said_to_be_too_broad() {
    let known = "[[expected-failures]]\nrequirement = \"NCP-VER-004\"\nexcuses = 0\nreason = \"issue 7\"\n";
    let (run, ..) = bundled(&[("p", &manifest("p", "wrong-answer", known))], &[]);
    assert_eq!(run.exit, 0, "{}", run.stdout);
    assert!(run.stdout.contains("it excused 0 cases when it was written: it is too broad"), "{}", run.stdout);
}
