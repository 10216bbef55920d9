//! A peer's expected failures.

use super::{Judged, Ruling, Status};
use crate::peer::ExpectedFailure;
use crate::run::{Outcome, OutcomeKind};
use crate::suite::{Case, Suite};

/// The failures that are expected of a peer, checked against the suite.
#[derive(Debug, Clone, Default)]
pub struct Baseline {
    entries: Vec<ExpectedFailure>,
    /// The day, as `2026-12-31`; empty: nothing expires.
    today: String,
}

/// Why a list of expected failures cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum BaselineError {
    /// It names a case that there is not.
    #[error("an expected failure names the case {0}, which the suite does not have")]
    Case(String),
    /// It names a rule that the text does not have, or by which no case can fail.
    #[error("an expected failure names the rule {0}, which no case cites")]
    Requirement(String),
    /// It names an outcome that there is not.
    #[error("an expected failure names the outcome {0}; one of fail, unsupported, crash, timeout, protocol")]
    Outcome(String),
}

/// What became of an entry.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Excuse {
    /// What it is called.
    pub entry: String,
    /// Why its cases fail.
    pub reason: String,
    /// How many cases it excuses.
    pub cases: usize,
    /// How many it excused when it was written, if it says so.
    pub written: Option<usize>,
    /// The day on which it expired, if it has.
    pub expired: Option<String>,
    /// The cases that it names but does not excuse, since they no longer fail in that way.
    pub stale_cases: Vec<String>,
    /// Whether it excuses nothing at all, though its cases were run.
    pub stale: bool,
}

impl Excuse {
    /// Whether it excuses more than when it was written.
    #[must_use]
    pub fn is_too_broad(&self) -> bool {
        self.written.is_some_and(|written| self.cases > written)
    }
}

impl Baseline {
    /// Takes a list. `today`, such as `2026-12-31`, says which entries have expired.
    ///
    /// # Errors
    /// [`BaselineError`] if an entry names nothing.
    pub fn new(entries: Vec<ExpectedFailure>, suite: &Suite, today: &str) -> Result<Self, BaselineError> {
        for entry in &entries {
            if let Some(id) = entry.ids().find(|id| suite.case(id).is_none()) {
                return Err(BaselineError::Case(id.clone()));
            }
            let can_fail_by = |case: &Case, id: &str| case.requirements.iter().any(|cited| cited.id == id);
            if let Some(id) = &entry.requirement
                && !suite.with_describe().any(|case| can_fail_by(case, id))
            {
                return Err(BaselineError::Requirement(id.clone()));
            }
            if let Some(name) = &entry.outcome
                && !EXCUSABLE.iter().any(|kind| kind.as_str() == name)
            {
                return Err(BaselineError::Outcome(name.clone()));
            }
        }
        Ok(Self { entries, today: today.to_owned() })
    }

    /// Why a case that does not pass is expected to, if it is.
    pub(super) fn reason(&self, case: &Case, outcome: &Outcome, ruling: &Ruling) -> Option<&str> {
        let excuses = |entry: &&ExpectedFailure| excuses(entry, case, outcome.kind(), ruling);
        self.entries.iter().find(excuses).map(|entry| entry.reason.as_str())
    }

    /// Whether a case is expected to fail by its own id.
    pub(super) fn names(&self, case: &Case) -> bool {
        self.entries.iter().any(|entry| entry.ids().any(|id| *id == case.id))
    }

    /// What became of each entry. What was not run says nothing, and of a rule all cases must have been run.
    pub(super) fn excuses(&self, cases: &[Judged<'_>], partial: bool) -> Vec<Excuse> {
        let whole = !partial && !cases.iter().any(|judged| judged.status == Status::NotRun);
        let excuse = |entry: &ExpectedFailure| {
            let fits = |judged: &&Judged<'_>| excuses(entry, judged.case, judged.run.outcome.kind(), &judged.ruling);
            let excused = cases.iter().filter(fits).count();
            let named = cases.iter().filter(|judged| entry.ids().any(|id| *id == judged.case.id));
            let no_longer = |judged: &&Judged<'_>| judged.status != Status::NotRun && !fits(judged);
            let stale_cases: Vec<String> = named.filter(no_longer).map(|judged| judged.case.id.clone()).collect();
            Excuse {
                entry: entry.name(),
                reason: entry.reason.clone(),
                cases: excused,
                written: entry.excuses,
                expired: entry.expires.clone().filter(|day| **day < *self.today),
                stale: excused == 0 && (!stale_cases.is_empty() || (whole && entry.ids().next().is_none())),
                stale_cases,
            }
        };
        self.entries.iter().map(excuse).collect()
    }

    #[cfg(test)]
    pub(crate) fn unchecked(entries: Vec<ExpectedFailure>, today: &str) -> Self {
        Self { entries, today: today.to_owned() }
    }
}

/// What can be expected of a case instead of a pass.
const EXCUSABLE: [OutcomeKind; 5] =
    [OutcomeKind::Fail, OutcomeKind::Unsupported, OutcomeKind::Crash, OutcomeKind::Timeout, OutcomeKind::Protocol];

/// Whether an entry excuses a case: it fails, by the rule, in the way, and is one of the cases that the entry names.
fn excuses(entry: &ExpectedFailure, case: &Case, outcome: OutcomeKind, ruling: &Ruling) -> bool {
    // A call that is unsupported is charged to no rule: the one that the case is about is not kept.
    let by = ruling.decided_by().or(case.requirements.first()).map(|rule| rule.id.as_str());
    EXCUSABLE.contains(&outcome)
        && entry.requirement.as_deref().is_none_or(|rule| by == Some(rule))
        && entry.outcome.as_deref().is_none_or(|name| name == outcome.as_str())
        && (entry.ids().next().is_none() || entry.ids().any(|id| *id == case.id))
}
