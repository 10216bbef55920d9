//! The whole corpus against this peer, in process: what `cargo verify` does between programs.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::io::BufReader;

use ncp_peer_rust::hold;
use ncp_verifier::check::{Judgement, judge};
use ncp_verifier::peer::{Reply, write_request};
use ncp_verifier::suite::{Case, Suite};

/// The answers to the requests of some cases, a line each.
fn answers(cases: &[&Case]) -> Vec<Vec<u8>> {
    let mut requests = Vec::new();
    for (id, case) in (0..).zip(cases) {
        write_request(&mut requests, id, &case.body());
    }
    let mut answers = Vec::new();
    hold(BufReader::new(&requests[..]), &mut answers).unwrap();
    let lines = answers.trim_ascii_end().split(|byte| *byte == b'\n');
    lines.map(<[u8]>::to_vec).collect()
}

/// What is wrong with an answer to a case, if anything.
fn fault(case: &Case, line: &[u8]) -> Option<String> {
    match judge(case, &Reply::parse(line).unwrap().answer) {
        Judgement::Pass { .. } => None,
        other => Some(format!("{}: {other:?}", case.id)),
    }
}

#[test]
fn the_executable_specification_agrees_with_every_case() {
    let suite = Suite::embedded().unwrap();
    // What is large, up to 64 MiB a case, is asked by itself.
    let (large, small): (Vec<&Case>, Vec<&Case>) = suite.cases().iter().partition(|case| case.is_large());
    assert!(small.len() > 7_500 && !large.is_empty());
    let mut wrong = Vec::new();
    for cases in std::iter::once(&small[..]).chain(large.chunks(1)) {
        let lines = answers(cases);
        assert_eq!(lines.len(), cases.len());
        wrong.extend(cases.iter().zip(&lines).filter_map(|(case, line)| fault(case, line)));
    }
    assert!(wrong.is_empty(), "{} cases:\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn the_executable_specification_agrees_with_the_deep_set() {
    let suite = Suite::deep().unwrap();
    let cases: Vec<&Case> = suite.cases().iter().collect();
    let lines = answers(&cases);
    assert_eq!(lines.len(), cases.len());
    let wrong: Vec<_> = cases.iter().zip(&lines).filter_map(|(case, line)| fault(case, line)).collect();
    assert!(wrong.is_empty(), "{} cases:\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn the_answer_to_another_case_is_noticed() {
    let suite = Suite::embedded().unwrap();
    let case = |id: &str| suite.case(id).unwrap();
    let [own, older] = ["version/guard/lenient/own", "version/guard/lenient/older-minor"].map(case);
    let line = answers(&[own]).remove(0);
    assert_eq!(fault(own, &line), None);
    assert!(fault(older, &line).is_some());
}
