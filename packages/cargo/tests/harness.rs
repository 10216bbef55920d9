//! The harness as a project uses it: programs with its `main`, run with the options that cargo hands on.

#![expect(clippy::unwrap_used, clippy::panic, reason = "a test may fail that way")]

use std::collections::BTreeSet;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use ncp_verifier::suite::Suite;

/// What a program left.
struct Run {
    exit: i32,
    stdout: String,
    stderr: String,
}

impl Run {
    /// The tests that ended so.
    fn tests(&self, how: &str) -> BTreeSet<&str> {
        let lines = self.stdout.lines().filter_map(|line| line.strip_prefix("test "));
        let ended = lines.filter_map(|line| line.split_once(" ... "));
        ended.filter(|(_, ended)| ended.starts_with(how)).map(|(name, _)| name.trim_end()).collect()
    }

    /// What a test that failed says.
    fn said_by(&self, test: &str) -> &str {
        let head = format!("---- {test} ----\n");
        let (_, said) = self.stdout.split_once(&head).unwrap_or_else(|| panic!("{test}: {}", self.stdout));
        said.split("\n\n\n").next().unwrap()
    }
}

fn example(name: &str) -> PathBuf {
    let tests = std::env::current_exe().unwrap();
    tests.ancestors().nth(2).unwrap().join("examples").join(name)
}

fn run(command: &mut Command) -> Run {
    let output = command.stdin(Stdio::null()).output().unwrap();
    Run {
        exit: output.status.code().unwrap(),
        stdout: String::from_utf8(output.stdout).unwrap(),
        stderr: String::from_utf8(output.stderr).unwrap(),
    }
}

/// Runs the peer with defects.
fn broken(env: &[(&str, &str)], args: &[&str]) -> Run {
    run(Command::new(example("broken")).envs(env.iter().copied()).args(args))
}

/// A list of expected failures.
fn list(entry: &str) -> tempfile::NamedTempFile {
    let file = tempfile::NamedTempFile::new().unwrap();
    std::fs::write(file.path(), format!("[[expected-failures]]\nreason = \"known\"\n{entry}\n")).unwrap();
    file
}

#[test]
fn the_specification_passes_every_case_of_the_corpus_and_each_is_a_test() {
    let run = run(&mut Command::new(example("specification")));
    assert_eq!(run.exit, 0, "{}{}", run.stdout, run.stderr);
    let suite = Suite::embedded().unwrap();
    let named: BTreeSet<&str> = suite.with_describe().map(|case| case.id.as_str()).chain(["verdict"]).collect();
    assert_eq!(run.tests("ok"), named);
}

#[test]
fn a_broken_peer_fails_by_the_cases_that_see_it_and_each_says_what_the_program_says() {
    let run = broken(&[("NCP_DEFECT", "says-yes")], &[]);
    assert_eq!(run.exit, 101);
    let failed = run.tests("FAILED");
    assert!(failed.contains("verdict") && failed.len() > 10, "{failed:?}");
    assert!(failed.iter().all(|test| test.starts_with("version/guard/lenient/") || *test == "verdict"), "{failed:?}");
    let said = run.said_by("version/guard/lenient/swapped");
    let suite = Suite::embedded().unwrap();
    let rule = suite.requirements().iter().find(|rule| rule.id == "NCP-VER-004").unwrap();
    let words: Vec<&str> = said.split_whitespace().collect();
    assert!(words.join(" ").contains(rule.sentence.as_str()), "{said}");
    for part in ["NCP-VER-004 MUST", "swapped [fail]", "/compatible: expected false, got true", "sent {", "got  {"] {
        assert!(said.contains(part), "{part}: {said}");
    }
    assert!(run.said_by("verdict").contains("the peer does not conform at level wire"), "{}", run.stdout);
}

#[test]
fn what_is_expected_to_fail_passes() {
    let file = list("cases = [\"version/guard/lenient/swapped\"]");
    let of = |file: &tempfile::NamedTempFile, args: &[&str]| {
        broken(&[("NCP_DEFECT", "says-yes"), ("NCP_EXPECTED", file.path().to_str().unwrap())], args)
    };
    assert_eq!(of(&file, &["--exact", "version/guard/lenient/swapped"]).exit, 0);
    let run = of(&file, &[]);
    assert!(run.tests("ok").contains("version/guard/lenient/swapped") && run.exit == 101, "the others fail");
    let all = run.tests("FAILED").into_iter().filter(|test| *test != "verdict");
    let cases: Vec<&str> = all.chain(["version/guard/lenient/swapped"]).collect();
    let run = of(&list(&format!("cases = {cases:?}")), &[]);
    assert_eq!((run.exit, run.tests("FAILED").len()), (0, 0), "{}", run.stdout);
}

#[test]
fn an_expected_failure_that_passes_is_stale_and_fails() {
    let file = list("case = \"version/guard/lenient/swapped\"");
    let run = broken(&[("NCP_EXPECTED", file.path().to_str().unwrap())], &[]);
    assert_eq!(run.exit, 101);
    assert_eq!(run.tests("FAILED"), BTreeSet::from(["verdict", "version/guard/lenient/swapped"]));
    assert!(run.said_by("version/guard/lenient/swapped").contains("unexpected pass"), "{}", run.stdout);
    assert!(run.said_by("verdict").contains("no longer fails"), "{}", run.stdout);
}

#[test]
fn what_is_not_implemented_is_ignored_but_not_by_the_verdict() {
    let run = broken(&[("NCP_DEFECT", "lacks-planes")], &[]);
    assert_eq!((run.exit, run.tests("FAILED")), (101, BTreeSet::from(["verdict"])), "{}", run.stdout);
    let ignored = run.tests("ignored");
    let suite = Suite::embedded().unwrap();
    let planes = suite.cases().iter().filter(|case| case.call.as_str() == "plane.qos");
    assert_eq!(ignored, planes.map(|case| case.id.as_str()).collect());
}

#[test]
fn a_thread_that_breaks_off_costs_the_cases_that_make_it() {
    let run = broken(&[("NCP_DEFECT", "breaks-off")], &[]);
    assert_eq!(run.exit, 101);
    let failed = run.tests("FAILED");
    assert!(failed.len() > 1 && failed.iter().all(|test| !test.starts_with("version/")), "{failed:?}");
    let first = failed.iter().find(|test| **test != "verdict").unwrap();
    assert!(run.said_by(first).contains("it closed the connection"), "{}", run.stdout);
}

#[test]
fn only_what_is_selected_is_asked() {
    let asked = |args: &[&str]| {
        let run = broken(&[("NCP_DEFECT", "tells")], args);
        assert_eq!(run.exit, 0, "{}", run.stdout);
        (run.tests("ok").len(), run.stderr.matches("asked: ").count())
    };
    assert_eq!(asked(&["--exact", "version/guard/lenient/swapped"]), (1, 2), "describe, and the case");
    let (all, _) = asked(&[]);
    assert_eq!(asked(&["--exact", "verdict"]), (1, all - 1), "describe, and every case");
    assert_eq!(asked(&["version/", "--skip", "lenient", "--skip", "describe"]).0, {
        let run = broken(&[], &["--list"]);
        let listed = run.stdout.lines().filter_map(|line| line.strip_suffix(": test"));
        listed.filter(|test| test.contains("version/") && !test.contains("lenient")).count()
    });
    assert_eq!(asked(&["--list"]).1, 1, "describe says which cases there are");
}

#[test]
fn a_program_is_tested_as_well_and_one_that_is_not_there_is_told() {
    let speak = format!("'{}' speak", example("broken").display());
    let run = broken(&[("NCP_COMMAND", &speak)], &[]);
    assert_eq!((run.exit, run.tests("FAILED").len()), (0, 0), "{}", run.stdout);
    assert_eq!(run.tests("ok").len(), broken(&[], &[]).tests("ok").len());
    for args in [&[][..], &["--list"]] {
        let run = broken(&[("NCP_COMMAND", "surely-no-such-program")], args);
        assert_eq!((run.exit, run.stdout.as_str()), (101, ""));
        assert!(run.stderr.contains("there is no program `surely-no-such-program`"), "{}", run.stderr);
    }
    let run = broken(&[("NCP_EXPECTED", "/no/such/list.toml")], &[]);
    assert!(run.exit == 101 && run.stderr.contains("/no/such/list.toml"), "{}", run.stderr);
}

#[test]
fn the_example_project_is_tested_by_cargo() {
    let run = run(Command::new(env!("CARGO")).args(["test", "--quiet", "--workspace", "--test"]).args([
        "conformance",
        "--",
        "--format",
        "pretty",
    ]));
    assert_eq!((run.exit, run.tests("FAILED").len()), (0, 0), "{}{}", run.stdout, run.stderr);
    assert!(run.tests("ok").contains("version/guard/lenient/swapped"), "{}", run.stdout);
}
