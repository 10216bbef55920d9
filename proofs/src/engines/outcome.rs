//! What an engine finds out about a property, and how long it looks.

use std::collections::BTreeSet;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::counterexample::Counterexample;

/// What an engine found out about a property.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// How it ended.
    pub verdict: Verdict,
    /// Why it failed.
    pub detail: String,
    /// Paths explored.
    pub paths: u64,
    /// Checks that are not true by evaluation, on all paths.
    pub raised: u64,
    /// Obligations given to the solver.
    pub obligations: u64,
    /// Checks that were true on their path without a solver: their answers were constants.
    pub by_evaluation: u64,
    /// Obligations that hold with every operation and comparison of doubles uninterpreted.
    pub without_arithmetic: u64,
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
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// It holds, in all cases within the bounds.
    Proved,
    /// It held in all cases that were tried; others were not.
    Tried,
    /// There is a counterexample.
    Refuted,
    /// The engine could not decide.
    Failed,
    /// The engine did not come to an end.
    #[serde(rename = "not run")]
    NotRun,
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
            Self::NotRun => "not run",
        }
    }
}

impl Outcome {
    pub(crate) fn new(began: Instant) -> Self {
        Self {
            verdict: Verdict::Tried,
            detail: String::new(),
            paths: 0,
            raised: 0,
            obligations: 0,
            by_evaluation: 0,
            without_arithmetic: 0,
            cross_checked: 0,
            runs: 0,
            evidence: Vec::new(),
            seconds: began.elapsed().as_secs_f64(),
            counterexample: None,
            reached: BTreeSet::new(),
        }
    }
}

/// Whether an engine goes on: until its work is done, or somebody ends it.
#[derive(Debug, Default)]
pub struct Patience {
    until: Option<Instant>,
    is_over: AtomicBool,
}

/// An engine was ended.
#[derive(Debug, Error)]
pub enum Ended {
    /// By another one, which has refuted the kernel.
    #[error("ended, as the kernel is refuted")]
    Refuted,
    /// By the clock, where it was given a time.
    #[error("not decided in time")]
    Time,
}

impl Patience {
    /// For so long from now on.
    #[must_use]
    pub fn of(time: Duration) -> Self {
        Self { until: Some(Instant::now() + time), is_over: AtomicBool::new(false) }
    }

    /// Ends it.
    pub fn end(&self) {
        self.is_over.store(true, Ordering::Relaxed);
    }

    /// Whether it was ended.
    #[must_use]
    pub fn is_over(&self) -> bool {
        self.is_over.load(Ordering::Relaxed)
    }

    /// Whether something is left of it.
    ///
    /// # Errors
    /// Nothing; and why.
    pub(crate) fn left(&self) -> Result<(), Ended> {
        if self.is_over() {
            Err(Ended::Refuted)
        } else if self.until.is_some_and(|until| until <= Instant::now()) {
            Err(Ended::Time)
        } else {
            Ok(())
        }
    }
}
