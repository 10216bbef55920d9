//! The engines: each a way to hold the kernel against the properties.

pub mod enumeration;
pub mod native;
pub mod standin;
pub mod symbolic;

use std::collections::BTreeSet;
use std::time::Instant;

use native::Drawn;

/// What an engine found out about a property.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// How it ended.
    pub verdict: Verdict,
    /// Why it failed.
    pub detail: String,
    /// Paths explored.
    pub paths: u64,
    /// Obligations given to the solver.
    pub obligations: u64,
    /// Checks that were true on their path without a solver: their answers were constants.
    pub by_evaluation: u64,
    /// Obligations that a second solver answered alike.
    pub cross_checked: u64,
    /// Runs of the harness on numbers.
    pub runs: u64,
    /// Files that were left, within the evidence.
    pub evidence: Vec<String>,
    /// How long it took.
    pub seconds: f64,
    /// Inputs that break it.
    pub counterexample: Option<Counterexample>,
    /// The checks that were reached.
    pub reached: BTreeSet<&'static str>,
}

/// How an engine ended with a property.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// It holds, in all cases within the bounds.
    Proved,
    /// It held in all cases that were tried; others were not.
    Tried,
    /// There is a counterexample.
    Refuted,
    /// The engine could not decide.
    Failed,
}

impl Verdict {
    /// Its word in reports.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Proved => "proved",
            Self::Tried => "tried",
            Self::Refuted => "refuted",
            Self::Failed => "failed",
        }
    }
}

/// Inputs that break a property, in the order in which the harness draws them.
#[derive(Debug, Clone, PartialEq)]
pub struct Counterexample {
    /// The check that fails.
    pub check: String,
    /// The inputs, by name.
    pub inputs: Vec<(String, Drawn)>,
}

impl Outcome {
    fn new(began: Instant) -> Self {
        Self {
            verdict: Verdict::Tried,
            detail: String::new(),
            paths: 0,
            obligations: 0,
            by_evaluation: 0,
            cross_checked: 0,
            runs: 0,
            evidence: Vec::new(),
            seconds: began.elapsed().as_secs_f64(),
            counterexample: None,
            reached: BTreeSet::new(),
        }
    }
}
