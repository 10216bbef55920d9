//! The stand-in for Kani's API: the same harnesses on edges and random values. It proves nothing; it shows
//! that the harnesses run, reach their checks, and notice a broken kernel.

use std::time::Instant;

use super::ends::{self, Progress};
use super::outcome::{Outcome, Verdict};
use crate::counterexample::Counterexample;
use crate::harness::{Harness, run_once};
use crate::provers::native::{Native, Sample, Source};

/// Runs the harness on so many samples, in sequences of at most this length.
#[must_use]
pub fn run(harness: &Harness, samples: u64, length: usize) -> Outcome {
    let copy = *harness;
    ends::watched(harness, move |progress| try_samples(&copy, samples, length, progress))
}

fn try_samples(harness: &Harness, samples: u64, length: usize, progress: &Progress) -> Outcome {
    let began = Instant::now();
    let sample = |seed| Source::Sample(Sample::new(seed, length));
    let mut native = Native::new(sample(0));
    let mut outcome = Outcome::new(began);
    for nth in 0..samples {
        native.draw = sample(nth);
        native.again();
        progress.begins(&native.draw);
        run_once(harness.native, &mut native);
        outcome.runs += 1;
        if let Some(check) = native.failed {
            native.keep = true;
            native.draw = sample(nth);
            native.again();
            run_once(harness.native, &mut native);
            outcome.verdict = Verdict::Refuted;
            outcome.counterexample =
                Some(Counterexample { check: check.to_owned(), inputs: std::mem::take(&mut native.drawn) });
            break;
        }
    }
    outcome.reached = native.reached.into_keys().collect();
    outcome.seconds = began.elapsed().as_secs_f64();
    outcome
}
