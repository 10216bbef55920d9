//! SARIF 2.1.0, for the pages of code hosts that show findings of tools.

use serde_json::{Value, json};

use super::model::{CaseReport, PeerReport, Report, Rule, State};
use crate::severity::Severity;
use crate::verdict::Status;

/// Where its schema is found.
pub(super) const SCHEMA: &str = "https://json.schemastore.org/sarif-2.1.0.json";
/// The rule of the results that are about the list of expected failures.
const LIST: &str = "expected-failures";

/// Renders a report as SARIF: a run a peer, a result a case that does not pass. What is expected to fail is suppressed;
/// what was not run, and a peer that was not checked, is told as a notification.
///
/// # Errors
/// If the JSON cannot be written, which does not occur.
pub(super) fn sarif(report: &Report) -> Result<String, serde_json::Error> {
    let runs: Vec<Value> = report.peers.iter().map(|peer| run(report, peer)).collect();
    let sarif = json!({"$schema": SCHEMA, "version": "2.1.0", "runs": runs});
    Ok(serde_json::to_string_pretty(&sarif)? + "\n")
}

fn run(report: &Report, peer: &PeerReport) -> Value {
    let place = location(peer);
    let is_result =
        |case: &&CaseReport| !matches!(case.status, Status::Passed | Status::UnexpectedPass | Status::NotRun);
    let cases: Vec<&CaseReport> = peer.cases.iter().filter(is_result).collect();
    let broken = |rule: &&Rule| cases.iter().any(|case| case.rule() == rule.id);
    let rules: Vec<&Rule> = report.rules.iter().filter(broken).collect();
    let mut results: Vec<Value> = cases.iter().map(|case| result(case, &rules, &place)).collect();
    let untrue: Vec<String> = peer.expected_failures.iter().flat_map(super::ExcuseReport::untrue).collect();
    results.extend(
        untrue
            .iter()
            .map(|text| json!({"ruleId": LIST, "level": "error", "message": {"text": text}, "locations": [place]})),
    );
    let mut described: Vec<Value> = rules.iter().map(|rule| describe(rule)).collect();
    if !untrue.is_empty() {
        described.push(json!({
            "id": LIST, "shortDescription": {"text": "A list of expected failures says what is so."}
        }));
    }
    json!({
        "tool": {"driver": {
            "name": report.tool.name, "version": report.tool.version, "rules": described,
        }},
        "automationDetails": {"id": format!("ncp-verify/{}/", peer.name)},
        "invocations": [invocation(report, peer)],
        "results": results,
        "properties": {
            "peer": peer.name, "verdict": peer.verdict(), "wireVersion": report.wire_version,
            "corpus": report.corpus.sha256, "partial": report.asked.partial,
        },
    })
}

fn invocation(report: &Report, peer: &PeerReport) -> Value {
    let mut told: Vec<String> = peer.reason.iter().cloned().collect();
    told.extend(peer.run.iter().flat_map(|run| run.given_up.iter().chain(&run.notes).cloned()));
    if peer.totals.not_run > 0 {
        told.push(format!("{} cases were not run", peer.totals.not_run));
    }
    let successful = peer.state == State::Checked && peer.totals.not_run == 0;
    let level = if successful { "note" } else { "error" };
    let notifications: Vec<Value> =
        told.iter().map(|text| json!({"level": level, "message": {"text": text}})).collect();
    json!({
        "executionSuccessful": successful, "startTimeUtc": report.started,
        "toolExecutionNotifications": notifications,
    })
}

fn describe(rule: &Rule) -> Value {
    let level = match rule.severity {
        Severity::Plant | Severity::Data => "error",
        Severity::Acceptance | Severity::Form => "warning",
    };
    // GitHub sorts by this number.
    let weight = match rule.severity {
        Severity::Plant => "9.0",
        Severity::Data => "7.0",
        Severity::Acceptance => "5.0",
        Severity::Form => "3.0",
    };
    json!({
        "id": rule.id,
        "shortDescription": {"text": rule.sentence},
        "help": {"text": format!("{} Run `ncp-verify explain {}` for its cases.", rule.sentence, rule.id)},
        "defaultConfiguration": {"level": level},
        "properties": {
            "keyword": rule.keyword.as_str(), "level": rule.level.as_str(), "place": rule.place,
            "security-severity": weight, "tags": ["ncp", rule.severity],
        },
    })
}

fn result(case: &CaseReport, rules: &[&Rule], place: &Value) -> Value {
    let level = if case.status == Status::Advice { "note" } else { "error" };
    let text = format!("{} {}", case.title, case.in_brief());
    let mut result = json!({
        "ruleId": case.rule(), "level": level, "message": {"text": text}, "locations": [place],
        "partialFingerprints": {"ncpCase/v1": case.id},
        "properties": {
            "case": case.id, "call": case.call.as_str(), "outcome": case.outcome.as_str(),
            "status": case.status.as_str(), "ruling": &*case.ruling,
        },
    });
    if let Some(index) = rules.iter().position(|rule| rule.id == case.rule()) {
        result["ruleIndex"] = json!(index);
    }
    if case.status == Status::ExpectedFailure {
        let reason = case.reason.as_deref().unwrap_or_default();
        result["suppressions"] = json!([{"kind": "external", "justification": reason}]);
    }
    result
}

/// Where a code host shows a result: no line of the peer is known, so that it is the place that names the peer.
fn location(peer: &PeerReport) -> Value {
    let is_command = peer.source.contains(char::is_whitespace);
    let uri =
        if is_command { "peer.toml".to_owned() } else { format!("{}/peer.toml", peer.source.trim_end_matches('/')) };
    let uri: String = uri.bytes().flat_map(encode).map(char::from).collect();
    json!({"physicalLocation": {
        "artifactLocation": {"uri": uri.trim_start_matches('/')}, "region": {"startLine": 1},
    }})
}

/// A byte within a URI.
fn encode(byte: u8) -> Vec<u8> {
    match byte {
        b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' | b'/' => vec![byte],
        _ => format!("%{byte:02X}").into_bytes(),
    }
}
