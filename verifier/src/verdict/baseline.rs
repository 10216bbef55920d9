//! A peer's expected failures.

use super::{Judged, Status};
use crate::peer::{ExpectedFailure, Target};
use crate::suite::{Case, Suite};

/// The failures that are expected of a peer, checked against the suite.
#[derive(Debug, Clone, Default)]
pub struct Baseline(Vec<ExpectedFailure>);

/// Why a list of expected failures cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum BaselineError {
    /// It names a case that there is not.
    #[error("an expected failure names the case {0}, which the suite does not have")]
    Case(String),
    /// It names a rule that the text does not have, or that no case cites.
    #[error("an expected failure names the rule {0}, which no case cites")]
    Requirement(String),
}

impl Baseline {
    /// Takes the list of a `peer.toml`.
    ///
    /// # Errors
    /// [`BaselineError`] if an entry names nothing.
    pub fn new(entries: Vec<ExpectedFailure>, suite: &Suite) -> Result<Self, BaselineError> {
        for entry in &entries {
            match &entry.target {
                Target::Case(id) if suite.case(id).is_none() => {
                    return Err(BaselineError::Case(id.clone()));
                }
                Target::Requirement(id) if !suite.with_describe().any(|case| cites(case, id)) => {
                    return Err(BaselineError::Requirement(id.clone()));
                }
                _ => {}
            }
        }
        Ok(Self(entries))
    }

    /// Why a case is expected to fail, if it is.
    pub(super) fn reason(&self, case: &Case) -> Option<&str> {
        self.0.iter().find(|entry| covers(&entry.target, case)).map(|entry| entry.reason.as_str())
    }

    /// Whether a case is expected to fail by its own id.
    pub(super) fn names(&self, case: &Case) -> bool {
        self.0.iter().any(|entry| matches!(&entry.target, Target::Case(id) if *id == case.id))
    }

    /// The entries that no longer fail. What was not run says nothing, and of a rule all cases must have been run.
    pub(super) fn stale(&self, cases: &[Judged<'_>], partial: bool) -> Vec<String> {
        let is_stale = |entry: &&ExpectedFailure| {
            let of_a_rule = matches!(entry.target, Target::Requirement(_));
            let mut covered = cases.iter().filter(|judged| covers(&entry.target, judged.case)).peekable();
            !(of_a_rule && partial)
                && covered.peek().is_some()
                && covered.all(|judged| matches!(judged.status, Status::Passed | Status::UnexpectedPass))
        };
        self.0.iter().filter(is_stale).map(|entry| name(&entry.target)).collect()
    }

    #[cfg(test)]
    pub(crate) fn unchecked(entries: Vec<ExpectedFailure>) -> Self {
        Self(entries)
    }
}

fn covers(target: &Target, case: &Case) -> bool {
    match target {
        Target::Case(id) => *id == case.id,
        Target::Requirement(id) => cites(case, id),
    }
}

fn cites(case: &Case, rule: &str) -> bool {
    case.requirements.iter().any(|cited| cited.id == rule)
}

fn name(target: &Target) -> String {
    match target {
        Target::Case(id) => format!("case {id}"),
        Target::Requirement(id) => format!("requirement {id}"),
    }
}
