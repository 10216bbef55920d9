//! The vectors that the report of the proofs prints, against this peer, in process: each is a counterexample to a
//! broken kernel or reader, and the executable specification has to pass it.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::collections::BTreeMap;
use std::fs;
use std::io::BufReader;

use ncp_peer_rust::hold;
use ncp_verifier::check::{Judgement, judge};
use ncp_verifier::peer::{Reply, write_request};
use ncp_verifier::suite::{Case, Suite};

/// The vectors of the evidence, as a suite of one file.
fn suite() -> Suite {
    let vectors = concat!(env!("CARGO_MANIFEST_DIR"), "/../../proofs/evidence/vectors.json");
    let folder = tempfile::tempdir().unwrap();
    let area = folder.path().join("proofs");
    fs::create_dir(&area).unwrap();
    fs::copy(vectors, area.join("report.json")).unwrap();
    Suite::load(folder.path()).unwrap()
}

/// How the specification's answer to a case is judged.
fn judged(case: &Case) -> Judgement {
    let mut request = Vec::new();
    write_request(&mut request, 1, &case.body());
    let mut answer = Vec::new();
    hold(BufReader::new(&request[..]), &mut answer).unwrap();
    judge(case, &Reply::parse(answer.trim_ascii_end()).unwrap().answer)
}

#[test]
fn the_specification_passes_every_vector_that_the_proofs_print() {
    let suite = suite();
    let mut calls: BTreeMap<&str, usize> = BTreeMap::new();
    for case in suite.cases() {
        *calls.entry(case.call.as_str()).or_default() += 1;
        let judgement = judged(case);
        assert!(matches!(judgement, Judgement::Pass { .. }), "{}: {judgement:?}", case.id);
    }
    for call in ["governor.run", "buffer.run", "watchdog.run", "bulk.decode"] {
        assert!(calls.get(call).is_some_and(|count| *count > 5), "{call}: {calls:?}");
    }
}
