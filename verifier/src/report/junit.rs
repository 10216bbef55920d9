//! JUnit XML, for services that show it.

use std::time::Duration;

use quick_junit::{NonSuccessKind, Report as JunitReport, TestCase, TestCaseStatus, TestSuite};

use super::model::{CaseReport, PeerReport, Report, State};
use crate::verdict::Status;

/// Renders a report as JUnit XML: a suite a peer, a test a case. Advice passes, with its text in the output; a peer
/// that was not checked is one test, skipped or in error.
///
/// # Errors
/// If the XML cannot be written, which does not occur.
pub fn junit(report: &Report) -> Result<String, quick_junit::SerializeError> {
    let mut junit = JunitReport::new(report.tool.name.clone());
    junit.set_time(Duration::from_secs_f64(report.elapsed_s.max(0.0)));
    junit.add_test_suites(report.peers.iter().map(suite));
    junit.to_string()
}

fn suite(peer: &PeerReport) -> TestSuite {
    let mut suite = TestSuite::new(peer.name.clone());
    suite.add_test_cases(peer.cases.iter().map(|case| test(&peer.name, case)));
    let reason = peer.reason.clone().unwrap_or_default();
    let status = match peer.state {
        State::Checked => None,
        State::Skipped => {
            let mut status = TestCaseStatus::skipped();
            status.set_message(reason);
            Some(status)
        }
        State::NotStarted => Some(non_success(NonSuccessKind::Error, "not started", &reason, "")),
    };
    if let Some(status) = status {
        suite.add_test_case(TestCase::new("describe", status));
    }
    if let Some(run) = &peer.run {
        suite.set_time(Duration::from_secs_f64(run.elapsed_s.max(0.0)));
    }
    for excuse in &peer.expected_failures {
        let untrue = excuse.untrue();
        if !untrue.is_empty() {
            let status = non_success(NonSuccessKind::Failure, "expected failure", &untrue.join("; "), "");
            suite.add_test_case(TestCase::new(excuse.entry.clone(), status));
        }
    }
    suite
}

fn test(peer: &str, case: &CaseReport) -> TestCase {
    let outcome = case.outcome.as_str();
    let differences: Vec<&str> = case.differences.iter().map(|difference| difference.text.as_str()).collect();
    let what = case.in_brief();
    let status = match case.status {
        Status::Failed if case.outcome.is_fault() => {
            non_success(NonSuccessKind::Error, outcome, &what, case.log.as_deref().unwrap_or_default())
        }
        Status::Failed => non_success(NonSuccessKind::Failure, outcome, &what, &differences.join("\n")),
        Status::NotRun | Status::ExpectedFailure => {
            let mut status = TestCaseStatus::skipped();
            status.set_message(case.reason.clone().unwrap_or(what));
            status
        }
        Status::Passed | Status::UnexpectedPass | Status::Advice => TestCaseStatus::success(),
    };
    let mut test = TestCase::new(case.id.clone(), status);
    test.set_classname(format!("{peer}.{}", case.rules.join(".")));
    let mut output = vec![case.title.to_string()];
    output.extend((case.status == Status::Advice).then(|| format!("advice: {}", differences.join("; "))));
    output.extend(case.request.iter().map(|request| format!("sent: {request}")));
    output.extend(case.answer.iter().map(|answer| format!("got:  {answer}")));
    if output.len() > 1 {
        test.set_system_out(output.join("\n"));
    }
    test
}

fn non_success(kind: NonSuccessKind, name: &str, message: &str, description: &str) -> TestCaseStatus {
    let mut status = TestCaseStatus::non_success(kind);
    status.set_type(name).set_message(message);
    if !description.is_empty() {
        status.set_description(description);
    }
    status
}
