//! Attestations: what was signed holds, and nothing that was tampered with does.

#![cfg(unix)]
#![expect(clippy::unwrap_used, reason = "a test may fail that way")]

use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use ncp_verifier::attest::{Artefact, AttestError, Believed, Key, Statement, open, seal, seal_bytes};
use ncp_verifier::report::Report;
use ncp_verifier::suite::Suite;
use serde_json::{Value, json};

const VECTORS: &str = "tests/data/vectors";

fn program(args: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ncp-verify"));
    command.stdin(Stdio::null()).args(args).args(["--vectors", VECTORS]).output().unwrap()
}

fn hostile() -> PathBuf {
    Path::new(env!("CARGO_BIN_EXE_ncp-verify")).parent().unwrap().join("examples/hostile-peer")
}

/// The result of the hostile peer in a mode, with an expected failure.
fn result(folder: &Path, mode: &str) -> PathBuf {
    let (file, list) = (folder.join(format!("{mode}.json")), folder.join("known.toml"));
    let known = "[[expected-failures]]\nrequirement = \"NCP-VER-004\"\nexcuses = 1\nreason = \"issue 7\"\n";
    std::fs::write(&list, known).unwrap();
    let peer = format!("{} {mode}", hostile().display());
    let list = list.to_str().unwrap();
    let run = program(&["run", "--peer-cmd", &peer, "--expected", list, "--json", file.to_str().unwrap()]);
    assert!(run.status.code().unwrap() <= 1, "{}", String::from_utf8_lossy(&run.stderr));
    file
}

/// A statement about the hostile peer in a mode.
fn statement(mode: &str, suite: &Suite) -> Statement {
    let folder = tempfile::tempdir().unwrap();
    let report = Report::read(&result(folder.path(), mode)).unwrap();
    Statement::new(vec![Artefact::new("peer", b"1")], Artefact::new("ncp-verify", b"2"), report, suite).unwrap()
}

/// Each value with one leaf changed, and where that is.
fn tampered(value: &Value) -> Vec<(String, Value)> {
    match value {
        Value::Object(members) => {
            let inner = members.iter().flat_map(|(name, member)| {
                tampered(member).into_iter().map(move |(place, changed)| {
                    let mut members = members.clone();
                    members.insert(name.clone(), changed);
                    (format!("/{name}{place}"), Value::Object(members))
                })
            });
            let gone = members.keys().map(|name| {
                let mut members = members.clone();
                // Nothing and null say the same.
                let what =
                    if members.shift_remove(name).is_some_and(|value| value.is_null()) { "null" } else { "gone" };
                (format!("/{name} ({what})"), Value::Object(members))
            });
            inner.chain(gone).collect()
        }
        Value::Array(items) => {
            let inner = items.iter().enumerate().flat_map(|(at, item)| {
                tampered(item).into_iter().map(move |(place, changed)| {
                    let mut items = items.clone();
                    items[at] = changed;
                    (format!("/{at}{place}"), Value::Array(items))
                })
            });
            let mut longer = items.clone();
            longer.push(items.last().cloned().unwrap_or(Value::Null));
            inner.chain([("/-".to_owned(), Value::Array(longer))]).collect()
        }
        Value::String(text) => vec![(String::new(), json!(format!("{text}x")))],
        Value::Number(number) => vec![(String::new(), json!(number.as_f64().unwrap() + 1.0))],
        Value::Bool(flag) => vec![(String::new(), json!(!flag))],
        Value::Null => vec![(String::new(), json!("x"))],
    }
}

#[test]
fn an_envelope_or_a_statement_that_was_changed_anywhere_is_refused() {
    let suite = Suite::load(Path::new(VECTORS)).unwrap();
    let key = Key::generate().unwrap();
    for mode in ["wrong-answer", "die-on-target"] {
        let sealed = seal(&statement(mode, &suite), &key).unwrap();
        open(&sealed, &key.public(), &suite).unwrap();
        let envelope: Value = serde_json::from_str(&sealed).unwrap();
        for (place, changed) in tampered(&envelope) {
            assert!(open(&changed.to_string(), &key.public(), &suite).is_err(), "{place}");
        }
        let payload = STANDARD.decode(envelope["payload"].as_str().unwrap()).unwrap();
        let stated: Value = serde_json::from_slice(&payload).unwrap();
        let all = tampered(&stated);
        assert!(all.len() > 500, "{}", all.len());
        for (place, changed) in all {
            let mut envelope = envelope.clone();
            envelope["payload"] = json!(STANDARD.encode(changed.to_string()));
            let refusal = open(&envelope.to_string(), &key.public(), &suite).unwrap_err();
            assert!(matches!(refusal, AttestError::Signature), "{place}: {refusal}");
        }
    }
}

/// What a run observes, and nothing follows from: a signer can state it as they like.
fn is_observed(place: &str) -> bool {
    let ends = [
        "/subject/0/name",
        "/subject/0/digest/sha256",
        "/subject/-",
        "/predicate/verifier/digest/sha256",
        "/tool/version",
        "/started",
        "/elapsed_s",
        "/interrupted",
        "/run/answers",
        "/run/elapsed_s",
        "/run/faults",
        "/run/rate/answers",
        "/run/rate/elapsed_s",
        " (null)",
        "/description/roles/-",
        "/expected_failures/-",
        "/differences/-",
        "/differences (gone)",
        "/place",
        "/place (gone)",
        "/peers/-",
        "/run/rate/per_second",
        "/run/rate",
        "/run/rate (gone)",
        "/run/given_up",
        "/run/given_up (gone)",
        "/run/crash_log/log",
        "/run/crash_log (gone)",
        "/run/notes/-",
        "/name",
        "/source",
        "/description/name",
        "/description/version",
        "/description/language",
        "/description/reference_networks",
        "/says/reason",
        "/answer",
        "/answer (gone)",
        "/log",
        "/log (gone)",
        "/note",
        "/what",
        "/asked/repeat",
        "/reason (gone)",
    ];
    ends.iter().any(|end| place.ends_with(end))
}

#[test]
fn a_result_whose_verdict_does_not_follow_is_refused_whoever_signs_it() {
    let suite = Suite::load(Path::new(VECTORS)).unwrap();
    let key = Key::generate().unwrap();
    for mode in ["wrong-answer", "die-on-target"] {
        let stated = serde_json::to_value(statement(mode, &suite)).unwrap();
        let (mut refused, mut believed) = (0, Vec::new());
        for (place, changed) in tampered(&stated) {
            let sealed = seal_bytes(changed.to_string().as_bytes(), &key).unwrap();
            let opened = open(&sealed, &key.public(), &suite);
            refused += usize::from(opened.is_err());
            believed.extend(Some(place).filter(|place| opened.is_ok() && !is_observed(place)));
        }
        assert_eq!(believed, Vec::<String>::new(), "{mode}");
        assert!(refused > 400, "{refused}");
        // Cases that are left out are missed, also where all that follows from them is left out as well.
        let folder = tempfile::tempdir().unwrap();
        let mut report = Report::read(&result(folder.path(), mode)).unwrap();
        report.peers[0].cases.retain(|case| case.outcome.as_str() == "pass");
        let short = Statement::new(vec![Artefact::new("p", b"1")], Artefact::new("ncp-verify", b"2"), report, &suite);
        assert!(matches!(short, Err(AttestError::Judge(_))));
        // All that says how it ended, changed together, is refused as well.
        let plain = stated.to_string();
        let forged = plain.replace("\"not conformant\"", "\"conformant\"").replace(":\"failed\"", ":\"passed\"");
        let sealed = seal_bytes(forged.as_bytes(), &key).unwrap();
        if forged != plain {
            assert!(matches!(open(&sealed, &key.public(), &suite), Err(AttestError::Verdict { .. })));
        }
    }
}

#[test]
fn only_the_key_that_signed_opens_and_only_for_these_vectors() {
    let suite = Suite::load(Path::new(VECTORS)).unwrap();
    let (key, other) = (Key::generate().unwrap(), Key::generate().unwrap());
    let sealed = seal(&statement("honest", &suite), &key).unwrap();
    assert!(matches!(open(&sealed, &other.public(), &suite), Err(AttestError::OtherKey(_))));
    let renamed = sealed.replace(&key.public().id(), &other.public().id());
    assert!(matches!(open(&renamed, &other.public(), &suite), Err(AttestError::Signature)));
    let built_in = Suite::embedded().unwrap();
    assert!(matches!(open(&sealed, &key.public(), &built_in), Err(AttestError::Digest { what: "corpus", .. })));
    for text in ["", "{}", "[]", "null", "nonsense"] {
        assert!(matches!(open(text, &key.public(), &suite), Err(AttestError::Form(_))), "{text}");
        assert!(Key::from_pem(text).is_err() && Believed::from_pem(text).is_err());
    }
    assert_eq!(Believed::from_pem(&key.public().to_pem()).unwrap().id(), key.public().id());
    assert_eq!(Key::from_pem(&key.to_pem()).unwrap().public().id(), key.public().id());
}

#[test]
fn the_program_makes_a_key_attests_a_result_and_checks_it() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).display().to_string();
    let (key, public, sealed) = (path("k"), path("k.pub"), path("sealed.json"));
    assert_eq!(program(&["attest", "--new-key", &key]).status.code(), Some(0));
    assert_eq!(program(&["attest", "--new-key", &key]).status.code(), Some(2), "a key is never written over");
    let mode = std::os::unix::fs::PermissionsExt::mode(&std::fs::metadata(&key).unwrap().permissions());
    assert_eq!(mode & 0o777, 0o600);
    let result = result(folder.path(), "wrong-answer");
    let made = program(&["attest", result.to_str().unwrap(), "--key", &key, "-o", &sealed]);
    assert_eq!(made.status.code(), Some(0), "{}", String::from_utf8_lossy(&made.stderr));
    let peer = hostile().display().to_string();
    let good = program(&["check-report", &sealed, "--key", &public, "--artefact", &peer]);
    let said = String::from_utf8_lossy(&good.stdout).into_owned();
    assert_eq!(good.status.code(), Some(0), "{}", String::from_utf8_lossy(&good.stderr));
    for words in ["hostile: as expected at level wire", "held against the file", "judged by this program"] {
        assert!(said.contains(words), "{said}");
    }
    let stranger = program(&["check-report", &sealed, "--key", &public, "--artefact", &key]);
    assert_eq!(stranger.status.code(), Some(1));
    let text = std::fs::read_to_string(&sealed).unwrap();
    std::fs::write(&sealed, text.replacen("\"sig\": \"", "\"sig\": \"AA", 1)).unwrap();
    let bad = program(&["check-report", &sealed, "--key", &public]);
    assert_eq!((bad.status.code(), bad.stdout.is_empty()), (Some(1), true));
    assert!(String::from_utf8_lossy(&bad.stderr).starts_with("refused: "));
    let mut report: Value = serde_json::from_str(&std::fs::read_to_string(&result).unwrap()).unwrap();
    report["peers"][0]["conclusion"] = json!("conformant");
    std::fs::write(&result, report.to_string()).unwrap();
    let made = program(&["attest", result.to_str().unwrap(), "--key", &key, "-o", &sealed]);
    assert_eq!(made.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&made.stderr).contains("its verdict does not follow from its cases"));
}
