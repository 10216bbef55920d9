//! Every case against the executable specification, in process.
//!
//! The generator knows the text and not `ncp-spec`, and `ncp-spec` knows the text and not the
//! generator. Where the two disagree, one of them has misread it.

#![expect(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test that cannot go on has failed")]

mod answer;
mod relation;
mod template;

use ncp_vectors::generate;
use serde_json::Value;

/// The cases of an area, their templates expanded one at a time, and what is wrong with each.
fn disagreements(area: &str) -> (usize, Vec<String>) {
    let mut count = 0;
    let mut wrong = Vec::new();
    let files = generate().into_iter().filter(|(path, _)| path.starts_with(area));
    for (_, text) in files {
        let file: Value = serde_json::from_str(&text).unwrap();
        for case in file["cases"].as_array().unwrap() {
            count += 1;
            let args = template::expanded(&case["args"]);
            let expect = template::expanded(&case["expect"]);
            let answer = answer::answer(case["call"].as_str().unwrap(), &args);
            if let Err(why) = relation::judge(&expect, answer) {
                wrong.push(format!("{}: {why}", case["id"].as_str().unwrap()));
            }
        }
    }
    (count, wrong)
}

fn agrees(area: &str) {
    let (count, wrong) = disagreements(area);
    assert!(count > 0);
    assert!(wrong.is_empty(), "{} of {count} cases:\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn the_spec_agrees_with_every_case_of_the_wire() {
    agrees("wire/");
}

#[test]
fn the_spec_agrees_with_every_case_of_the_version() {
    agrees("version/");
}

#[test]
fn the_spec_agrees_with_every_case_of_the_keys() {
    agrees("keys/");
}

#[test]
fn the_spec_agrees_with_every_case_of_bulk() {
    agrees("bulk/");
}

/// Those of the plant and the server are traces, which the peers are asked.
#[test]
fn the_spec_agrees_with_every_strict_case_without_a_trace() {
    for file in ["strict/frames", "strict/keys", "strict/replies"] {
        agrees(file);
    }
}

#[test]
fn the_spec_agrees_with_every_hostile_case() {
    agrees("hostile/");
}
