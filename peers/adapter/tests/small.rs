//! The example, judged by the verifier; and what the skeleton brings into the program of its author.

#![expect(clippy::unwrap_used, reason = "a test may fail that way")]

use std::collections::BTreeMap;
use std::process::Command;

use ncp_verifier::peer::{Call, Connection, Launch, handshake};
use ncp_verifier::run::{Deaf, OutcomeKind, Settings, Stop, run};
use ncp_verifier::suite::{Case, Suite};

/// What the verifier says of the example: how many cases of each call had which outcome.
fn outcomes() -> BTreeMap<(Call, &'static str), usize> {
    let small = std::env::current_exe().unwrap().parent().unwrap().parent().unwrap().join("examples/small");
    let launch = Launch::new(vec![small.to_str().unwrap().to_owned()], ".");
    let (settings, stop) = (Settings::default(), Stop::default());
    let mut connection = Connection::open(&launch).unwrap();
    assert_eq!(handshake(&mut connection, settings.start_timeout, &stop).unwrap().roles, ["body"]);
    let suite = Suite::embedded().unwrap();
    let cases: Vec<&Case> = suite.cases().iter().filter(|case| !case.is_large()).collect();
    let record = run(&launch, connection, &cases, &settings, &Deaf, &stop);
    assert_eq!((record.faults, &record.notes), (0, &Vec::new()));
    let mut outcomes = BTreeMap::new();
    for (case, run) in cases.iter().zip(&record.cases) {
        *outcomes.entry((case.call, run.outcome.kind().as_str())).or_default() += 1;
    }
    outcomes
}

#[test]
fn the_example_passes_every_case_of_the_calls_that_it_answers_and_lacks_all_others() {
    let outcomes = outcomes();
    let answered = [Call::VersionCheck, Call::ContractStatus, Call::WatchdogRun];
    for ((call, outcome), count) in &outcomes {
        let expected = if answered.contains(call) { OutcomeKind::Pass } else { OutcomeKind::Unsupported };
        assert_eq!((*outcome, *count > 0), (expected.as_str(), true), "{call:?}");
    }
    assert!(outcomes[&(Call::WatchdogRun, "pass")] > 100 && outcomes[&(Call::Decode, "unsupported")] > 1000);
}

#[test]
fn the_skeleton_brings_no_json_library_into_the_implementation_that_it_tests() {
    let tree = Command::new(env!("CARGO"))
        .args(["tree", "--offline", "--package", "ncp-adapter", "--edges", "normal", "--prefix", "none"])
        .output()
        .unwrap();
    let tree = String::from_utf8(tree.stdout).unwrap();
    let names: Vec<&str> = tree.lines().filter_map(|line| line.split(' ').next()).collect();
    assert!(names.contains(&"serde") && names.contains(&"base64"), "{tree}");
    assert!(!names.iter().any(|name| name.contains("json") || name.starts_with("ncp-spec")), "{tree}");
}
