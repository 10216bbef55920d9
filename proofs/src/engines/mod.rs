//! The engines: each a way to hold the kernel against the properties.

mod ends;
pub mod enumeration;
pub mod native;
pub mod standin;
pub mod symbolic;

use std::any::Any;
use std::collections::BTreeSet;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

pub use ends::ENDS;
use native::{Draw, Drawn, Native, Replay, Source};

use crate::properties::Harness;

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
    pub(crate) fn new(began: Instant) -> Self {
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

/// How long an engine goes on.
#[derive(Debug)]
pub struct Patience {
    until: Instant,
    is_over: AtomicBool,
}

impl Patience {
    /// For so long from now on.
    #[must_use]
    pub fn of(time: Duration) -> Self {
        Self { until: Instant::now() + time, is_over: AtomicBool::new(false) }
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

    /// What is left of it.
    ///
    /// # Errors
    /// Nothing; and why.
    pub(crate) fn left(&self) -> Result<Duration, String> {
        let left = self.until.saturating_duration_since(Instant::now());
        if self.is_over() {
            Err("ended, as the kernel is refuted".to_owned())
        } else if left.is_zero() {
            Err("not decided in time".to_owned())
        } else {
            Ok(left)
        }
    }
}

/// The check that fails where the kernel panics.
const NO_PANIC: &str = "the kernel does not panic";

/// Runs a harness once on doubles. A panic is a failure.
fn run_once<D: Draw>(harness: fn(&mut Native<D>), native: &mut Native<D>) {
    if catch_unwind(AssertUnwindSafe(|| harness(native))).is_err() {
        native.failed.get_or_insert(NO_PANIC);
    }
}

/// What a panic says.
fn said(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    let text = text.or_else(|| panic.downcast_ref::<&str>().copied());
    format!("the kernel panics: {}", text.unwrap_or_default())
}

/// What the kernel answers to a counterexample and what the text says, where the check compares the two.
#[must_use]
pub fn compared(harness: &Harness, found: &Counterexample, length: usize) -> Option<String> {
    if found.check == ENDS {
        return Some("the text has an answer, the kernel never gives one".to_owned());
    }
    let mut replay = Replay { length, ..Replay::default() };
    for (_, drawn) in &found.inputs {
        match *drawn {
            Drawn::Scalar(value) => replay.scalars.push_back(value),
            Drawn::Seq(value) => replay.seqs.push_back(value),
            Drawn::Choice(value) => replay.choices.push_back(value),
        }
    }
    let mut native = Native::new(Source::Replay(replay));
    run_once(harness.native, &mut native);
    native.compared.filter(|compared| !compared.is_empty())
}
