//! Every combination of the values that a property lists, on doubles.

use std::time::Instant;

use super::bounds::{self, Values};
use super::ends::{self, Progress};
use super::outcome::{Outcome, Verdict};
use crate::counterexample::Counterexample;
use crate::harness::{Harness, run_once};
use crate::properties::Property;
use crate::provers::native::{Enumerate, Native, Source};

/// Runs the harness on every combination, in sequences of at most this length; none for a property that lists
/// no values.
#[must_use]
pub fn run(property: &Property, harness: &Harness, length: usize) -> Option<Outcome> {
    let values = bounds::of(property.id).values?;
    let copy = *harness;
    Some(ends::watched(harness, move |progress| try_all(&copy, values, length, progress)))
}

fn try_all(harness: &Harness, values: Values, length: usize, progress: &Progress) -> Outcome {
    let began = Instant::now();
    let mut native =
        Native::new(Source::Enumerate(Enumerate::new(values.scalars, values.seqs, length.min(values.length))));
    let mut outcome = Outcome::new(began);
    loop {
        native.again();
        progress.begins(&native.draw);
        run_once(harness.native, &mut native);
        outcome.runs += 1;
        if let Some(check) = native.failed {
            // Once more, to note what was drawn.
            native.keep = true;
            native.draw.restart();
            native.again();
            run_once(harness.native, &mut native);
            outcome.verdict = Verdict::Refuted;
            outcome.counterexample =
                Some(Counterexample { check: check.to_owned(), inputs: std::mem::take(&mut native.drawn) });
            break;
        }
        if !native.draw.advance() {
            outcome.verdict = Verdict::Proved;
            break;
        }
    }
    outcome.reached = native.reached.into_keys().collect();
    outcome.seconds = began.elapsed().as_secs_f64();
    outcome
}
