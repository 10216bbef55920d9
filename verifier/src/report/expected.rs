//! The list of expected failures that a result amounts to.

use std::collections::BTreeMap;

use super::model::{CaseReport, PeerReport};
use crate::peer::{Call, ExpectedFailure, ExpectedFailures};
use crate::run::OutcomeKind;
use crate::verdict::Status;

/// What stands above the entries.
const HEAD: &str = "\
# Failures that are known, by the rule that is broken. Write the reason of each; an entry may also say until when it
# holds: expires = \"2026-12-31\". An entry that no longer fails, or that has expired, fails the run.
";

/// Lists every case of a peer that fails, and does not merely differ from advice, as TOML. What was expected before
/// keeps its reason.
///
/// # Errors
/// If the list cannot be written as TOML, which does not occur.
pub fn expected_list(peer: &PeerReport) -> Result<String, toml::ser::Error> {
    let mut groups: BTreeMap<(Way<'_>, &str), Vec<String>> = BTreeMap::new();
    let fails = |case: &&CaseReport| matches!(case.status, Status::Failed | Status::ExpectedFailure);
    for case in peer.cases.iter().filter(fails) {
        let way = match &case.charged {
            Some(rule) => Way::Breaks(rule, case.outcome),
            None => Way::Lacks(case.call),
        };
        groups.entry((way, case.reason.as_deref().unwrap_or_default())).or_default().push(case.id.clone());
    }
    let entries = groups.into_iter().map(|((way, reason), cases)| {
        let (requirement, outcome) = match way {
            Way::Breaks(rule, outcome) => (Some(rule.to_owned()), outcome),
            Way::Lacks(_) => (None, OutcomeKind::Unsupported),
        };
        ExpectedFailure {
            requirement,
            outcome: Some(outcome.as_str().to_owned()),
            reason: reason.to_owned(),
            excuses: Some(cases.len()),
            cases,
            ..ExpectedFailure::default()
        }
    });
    Ok(format!("{HEAD}\n{}", toml::to_string_pretty(&ExpectedFailures { entries: entries.collect() })?))
}

/// In which way cases fail.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
enum Way<'c> {
    /// They break a rule, with this outcome.
    Breaks(&'c str, OutcomeKind),
    /// They need a call that the peer does not have.
    Lacks(Call),
}
