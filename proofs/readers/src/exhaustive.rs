//! Every input of a reader within the bounds of a property, natively; a panic refutes, too.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Instant;

use ncp_proofs::counterexample::Drawn;
use ncp_proofs::provers::native::{Enumerate, Native};

use crate::properties::{Enumerated, Property};

/// The check that fails where a reader panics.
pub const PANICS: &str = "nothing panics";

/// What came of all inputs of a property.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// Inputs enumerated, up to the first that refutes.
    pub inputs: u64,
    /// Those of them on which a check was reached; the others were left aside.
    pub judged: u64,
    /// The first input that refutes.
    pub counterexample: Option<Counterexample>,
    /// How long it took.
    pub seconds: f64,
}

/// An input that breaks a property.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Counterexample {
    /// The check that fails.
    pub check: &'static str,
    /// What was chosen, by name, in the order in which the harness draws it.
    pub choices: Vec<(String, usize)>,
}

impl Outcome {
    /// Whether all inputs keep the property, of which some reached a check.
    #[must_use]
    pub const fn is_proved(&self) -> bool {
        self.counterexample.is_none() && self.judged > 0
    }
}

impl Counterexample {
    /// The choices alone.
    #[must_use]
    pub fn ways(&self) -> Vec<usize> {
        self.choices.iter().map(|(_, way)| *way).collect()
    }
}

/// Runs the harness on every combination of choices, with strings and column sets of at most `length`, or of
/// the property's own bound.
#[must_use]
pub fn run(property: &Property, harness: Enumerated, length: Option<usize>) -> Outcome {
    let began = Instant::now();
    let length = length.map_or(property.length, |length| length.min(property.length));
    let mut native = Native::new(Enumerate::new(&[], &[], length));
    let mut inputs = 0;
    // One guard for all runs; behind a panic the choices still stand.
    let ended = catch_unwind(AssertUnwindSafe(|| {
        loop {
            native.again();
            inputs += 1;
            harness(&mut native);
            if native.failed.is_some() || !native.draw.advance() {
                break;
            }
        }
    }));
    // The check that was reached most often is reached by all that are not left aside.
    let judged = native.reached.values().max().copied().unwrap_or_default();
    let failed = native.failed.or_else(|| ended.is_err().then_some(PANICS));
    let counterexample = failed.map(|check| {
        // Once more, to note what was drawn.
        native.keep = true;
        native.draw.restart();
        native.again();
        let _ = catch_unwind(AssertUnwindSafe(|| harness(&mut native)));
        let choice = |(name, drawn)| match drawn {
            Drawn::Choice(way) => Some((name, way)),
            Drawn::Scalar(_) | Drawn::Seq(_) => None,
        };
        let drawn = std::mem::take(&mut native.drawn);
        let choices = drawn.into_iter().filter_map(choice).collect();
        Counterexample { check, choices }
    });
    Outcome { inputs, judged, counterexample, seconds: began.elapsed().as_secs_f64() }
}
