//! `cargo assure mutants` on a program that holds some: what it says of each, what it writes, how it ends.

#![cfg(unix)]
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;
use std::os::unix::fs::PermissionsExt as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::LazyLock;

use serde_json::Value;

struct Run {
    exit: i32,
    stdout: String,
    stderr: String,
    /// The reports, if they were written.
    json: Option<Value>,
    page: Option<String>,
    full: Option<String>,
}

/// The verifier's hostile peer, whose modes are the mutants.
static HOSTILE: LazyLock<PathBuf> = LazyLock::new(|| {
    let built = Path::new(env!("CARGO_BIN_EXE_ncp-assurance")).with_file_name("examples/hostile-peer");
    // Nextest has just built it with all other programs; alone, it would be built with other features once more.
    if std::env::var_os("NEXTEST").is_none() || !built.exists() {
        let cargo = ["build", "--quiet", "-p", "ncp-verifier", "--example", "hostile-peer"];
        assert!(Command::new(env!("CARGO")).args(cargo).status().unwrap().success());
    }
    built
});

/// Runs the command on a program whose defects are modes of the hostile peer, each with the rule that it breaks, and
/// behind a space those that it breaks as directly.
fn hunt_in(healthy: &str, mutants: &[(&str, &str)], args: &[&str]) -> Run {
    let folder = tempfile::tempdir().unwrap();
    let table = |(name, rules): &(&str, &str)| {
        let rules: Vec<&str> = rules.split(' ').collect();
        let edit = "edit = [{ file = \"\", code = \"\", with = \"()\" }]";
        format!(
            "[[defect]]\nname = \"{name}\"\nabout = \"It is {name}.\"\nfinding = \"L24\"\n\
             rules = {rules:?}\nequal = {:?}\n{edit}\n",
            &rules[1..]
        )
    };
    let table: String = mutants.iter().map(table).collect();
    fs::write(folder.path().join("defects.toml"), table).unwrap();
    let program = folder.path().join("program");
    let peer = HOSTILE.display();
    // Of several defects, the hostile peer has the first.
    let script =
        format!("#!/bin/sh\ncase \"$1\" in\n--defect) exec '{peer}' \"$2\";;\n*) exec '{peer}' {healthy};;\nesac\n");
    fs::write(&program, script).unwrap();
    fs::set_permissions(&program, fs::Permissions::from_mode(0o755)).unwrap();
    let reports = folder.path().join("reports");
    let vectors = Path::new(env!("CARGO_MANIFEST_DIR")).join("../verifier/tests/data/vectors");
    let output = Command::new(env!("CARGO_BIN_EXE_ncp-assurance"))
        .args(["mutants", "--vectors"])
        .arg(vectors)
        .arg("--defects")
        .arg(folder.path().join("defects.toml"))
        .arg("--program")
        .arg(&program)
        .arg("--reports")
        .arg(&reports)
        .args(args)
        .stdin(Stdio::null())
        .output()
        .unwrap();
    let read = |name: &str| fs::read_to_string(reports.join(name)).ok();
    Run {
        exit: output.status.code().unwrap(),
        stdout: String::from_utf8(output.stdout).unwrap(),
        stderr: String::from_utf8(output.stderr).unwrap(),
        json: read("full/mutants.json").map(|text| serde_json::from_str(&text).unwrap()),
        page: read("mutants.md"),
        full: read("full/mutants.md"),
    }
}

fn hunt(mutants: &[(&str, &str)]) -> Run {
    hunt_in("honest", mutants, &[])
}

#[test]
fn a_mutant_that_fails_by_its_rule_is_killed_and_reported() {
    let run = hunt(&[("wrong-answer", "NCP-VER-004")]);
    assert_eq!(run.exit, 0, "{}{}", run.stdout, run.stderr);
    assert!(run.stdout.contains("1 mutant: 1 killed"), "{}", run.stdout);
    let json = run.json.unwrap();
    let mutant = &json["mutants"][0];
    assert_eq!(mutant["fate"], "killed");
    assert_eq!(mutant["place"], 1);
    assert_eq!(mutant["failing_cases"], 1);
    assert_eq!(mutant["shortest_case"], "version/tiny/07-target");
    let page = run.full.unwrap();
    assert!(
        page.contains("| wrong-answer | It is wrong-answer. | L24 | NCP-VER-004 | 1 | `version/tiny/07-target` |"),
        "{page}"
    );
    assert!(page.contains("| L24 | wrong-answer |"), "{page}");
    assert!(run.page.unwrap().contains("| L24 | wrong-answer |"));
}

#[test]
fn a_mutant_that_no_case_notices_survives_and_fails_the_run() {
    let run = hunt(&[("wrong-answer", "NCP-VER-004"), ("harmless", "NCP-VER-008")]);
    assert_eq!(run.exit, 1);
    let said = "harmless survived: no case of NCP-VER-008 notices it. It is harmless.";
    assert!(run.stdout.contains(said), "{}", run.stdout);
    assert!(run.page.unwrap().contains(said));
    assert_eq!(run.json.unwrap()["totals"]["survived"], 1);
}

#[test]
fn a_mutant_that_fails_by_another_rule_is_misnamed_and_fails_the_run() {
    let run = hunt(&[("wrong-answer", "NCP-VER-001")]);
    assert_eq!(run.exit, 1);
    let said = "wrong-answer breaks NCP-VER-001, but the verdict names NCP-VER-004";
    assert!(run.stdout.contains(said), "{}", run.stdout);
}

#[test]
fn a_mutant_is_killed_too_where_the_verdict_begins_with_a_rule_that_it_breaks_as_directly() {
    let run = hunt(&[("wrong-answer", "NCP-VER-001 NCP-VER-004")]);
    assert_eq!(run.exit, 0, "{}{}", run.stdout, run.stderr);
    let totals = &run.json.unwrap()["totals"];
    let of = |name: &str| totals[name].as_u64().unwrap();
    assert_eq!([of("killed"), of("led_rightly"), of("named_first"), of("misnamed")], [1, 1, 0, 0]);
}

#[test]
fn a_mutant_in_which_a_rule_that_it_keeps_is_blamed_fails_the_run() {
    let run = hunt(&[("panics", "NCP-VER-001")]);
    assert_eq!(run.exit, 1);
    let json = run.json.unwrap();
    assert_eq!(json["mutants"][0]["fate"], "killed");
    let named = json["mutants"][0]["named"].as_array().unwrap().iter();
    let named: Vec<&str> = named.map(|named| named["rule"].as_str().unwrap()).collect();
    let (kept, own): (Vec<&str>, Vec<&str>) = named.into_iter().partition(|rule| *rule != "NCP-VER-001");
    assert_eq!((own.len(), &json["totals"]["blamed"]), (1, &1.into()));
    assert!(!kept.is_empty());
    let said = format!("panics keeps {}, but the verdict names them", kept.join(", "));
    assert!(run.stdout.contains(&said), "{}", run.stdout);
}

#[test]
fn a_mutant_that_crashes_is_named_so() {
    let run = hunt(&[("die-on-target", "NCP-VER-004")]);
    assert_eq!(run.exit, 0, "{}{}", run.stdout, run.stderr);
    assert_eq!(run.json.unwrap()["mutants"][0]["crashes"], 1);
    assert!(run.full.unwrap().contains("| 1, 1 by a crash |"));
}

#[test]
fn a_mutant_whose_trial_takes_too_long_is_not_finished() {
    let run = hunt_in("honest", &[("sleep-on-target", "NCP-VER-001")], &["--limit", "1"]);
    assert_eq!(run.exit, 1, "{}{}", run.stdout, run.stderr);
    assert!(run.stdout.contains("sleep-on-target: its trial took too long"), "{}", run.stdout);
}

#[test]
fn a_peer_that_fails_without_a_mutant_ends_the_hunt() {
    let run = hunt_in("wrong-answer", &[("harmless", "NCP-VER-008")], &[]);
    assert_eq!(run.exit, 4);
    assert!(
        run.stderr.contains("without a mutant the peer fails 1 cases, version/tiny/07-target first"),
        "{}",
        run.stderr
    );
    assert!(run.json.is_none());
}

#[test]
fn a_rule_that_the_text_does_not_have_ends_the_hunt() {
    let run = hunt(&[("harmless", "NCP-VER-999")]);
    assert_eq!(run.exit, 4);
    assert!(run.stderr.contains("the mutant harmless breaks no rule of the text: \"NCP-VER-999\""), "{}", run.stderr);
}

#[test]
fn only_tries_the_named_mutant_and_writes_no_report() {
    let both = [("wrong-answer", "NCP-VER-004"), ("harmless", "NCP-VER-008")];
    let run = hunt_in("honest", &both, &["--only", "wrong-answer"]);
    assert_eq!(run.exit, 0, "{}{}", run.stdout, run.stderr);
    assert!(run.json.is_none() && run.page.is_none());
    let run = hunt_in("honest", &both, &["--only", "no-such"]);
    assert_eq!(run.exit, 2);
    assert!(run.stderr.contains("there is no mutant no-such"), "{}", run.stderr);
}

#[test]
fn quick_asks_the_cases_of_a_mutants_own_rules_alone_and_writes_no_report() {
    let run = hunt_in("honest", &[("panics", "NCP-VER-001")], &["--quick"]);
    // All cases would have other rules blamed, too.
    assert_eq!(run.exit, 0, "{}{}", run.stdout, run.stderr);
    assert!(run.stdout.contains("1 mutant: 1 killed by a case of their own rules"), "{}", run.stdout);
    assert!(run.json.is_none() && run.page.is_none());
    let run = hunt_in("honest", &[("wrong-answer", "NCP-VER-001")], &["--quick"]);
    assert_eq!(run.exit, 1);
    assert!(run.stdout.contains("wrong-answer: survived"), "{}", run.stdout);
}

#[test]
fn the_trials_are_written_as_json_where_they_are_asked_for() {
    let file = tempfile::NamedTempFile::new().unwrap();
    let run =
        hunt_in("honest", &[("wrong-answer", "NCP-VER-004")], &["--quick", "--json", file.path().to_str().unwrap()]);
    assert_eq!(run.exit, 0, "{}{}", run.stdout, run.stderr);
    let json: Value = serde_json::from_str(&fs::read_to_string(file.path()).unwrap()).unwrap();
    assert_eq!((&json["totals"]["killed"], &json["mutants"][0]["name"]), (&1.into(), &"wrong-answer".into()));
}

#[test]
fn several_defects_together_are_one_mutant_that_owes_the_rule_of_each() {
    let both = [("wrong-answer", "NCP-VER-004"), ("harmless", "NCP-VER-008")];
    let together = ["--only", "wrong-answer", "--only", "harmless", "--together"];
    let run = hunt_in("honest", &both, &together);
    assert_eq!(run.exit, 1);
    let said = "wrong-answer + harmless breaks NCP-VER-004, NCP-VER-008, but the verdict names NCP-VER-004";
    assert!(run.stdout.contains(said), "{}", run.stdout);
    let same = [("wrong-answer", "NCP-VER-004"), ("harmless", "NCP-VER-004")];
    let run = hunt_in("honest", &same, &together);
    assert_eq!(run.exit, 0, "{}", run.stdout);
    assert!(run.stdout.contains("1 mutant: 1 killed"), "{}", run.stdout);
}

#[test]
fn the_list_shows_each_mutant_with_its_rule() {
    let run = hunt_in("honest", &[("harmless", "NCP-VER-008")], &["--list"]);
    assert_eq!(run.exit, 0);
    assert_eq!(run.stdout, "harmless  L24  NCP-VER-008\n    It is harmless.\n");
}
