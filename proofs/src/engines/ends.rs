//! Whether the kernel comes to an end. A changed one may not: that refutes it, and must not hold an engine up.

use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, mpsc};
use std::thread;
use std::time::{Duration, Instant};

use super::outcome::{Outcome, Verdict};
use crate::counterexample::{Counterexample, Drawn, ENDS};
use crate::harness::{Harness, run_once, said};
use crate::provers::native::{Native, Source};

/// How often an engine is looked at.
const LOOK: Duration = Duration::from_secs(2);
/// An engine that has begun no run since so many looks may be in one without an end: a run takes microseconds.
const STILL: u32 = 4;
/// So long has the same run once more, from its last input on: far more than a busy machine holds it up.
const AGAIN: Duration = Duration::from_secs(15);

/// How far an engine is.
#[derive(Debug, Default)]
pub(super) struct Progress {
    runs: AtomicU64,
    under_way: Mutex<Option<Source>>,
}

impl Progress {
    /// A run begins, on these inputs.
    pub(super) fn begins(&self, draw: &Source) {
        self.runs.fetch_add(1, Ordering::Relaxed);
        if let Ok(mut under_way) = self.under_way.lock() {
            *under_way = Some(draw.clone());
        }
    }

    fn runs(&self) -> u64 {
        self.runs.load(Ordering::Relaxed)
    }

    fn under_way(&self) -> Option<Source> {
        self.under_way.lock().ok()?.clone()
    }
}

/// Runs an engine in a thread beside. If one of its runs does not end, neither does the thread, and that run's
/// inputs refute the kernel.
pub(super) fn watched(harness: &Harness, engine: impl FnOnce(&Progress) -> Outcome + Send + 'static) -> Outcome {
    let began = Instant::now();
    let progress = Arc::new(Progress::default());
    let (tell, told) = mpsc::channel();
    let beside = Arc::clone(&progress);
    let thread = thread::spawn(move || tell.send(engine(&beside)).ok());
    let (mut before, mut looks) = (0, 0);
    loop {
        match told.recv_timeout(LOOK) {
            Ok(outcome) => return outcome,
            Err(mpsc::RecvTimeoutError::Disconnected) => {
                let mut outcome = Outcome::new(began);
                outcome.verdict = Verdict::Failed;
                outcome.detail = thread.join().err().map(|p| said(&*p)).unwrap_or_default();
                return outcome;
            }
            Err(mpsc::RecvTimeoutError::Timeout) => {}
        }
        let now = progress.runs();
        if now != before {
            (before, looks) = (now, 0);
            continue;
        }
        looks += 1;
        if looks >= STILL
            && let Some(inputs) = progress.under_way().and_then(|d| endless(harness, d))
        {
            let mut outcome = Outcome::new(began);
            outcome.runs = now;
            outcome.verdict = Verdict::Refuted;
            outcome.counterexample = Some(Counterexample { check: ENDS.to_owned(), inputs });
            return outcome;
        }
    }
}

/// The inputs of a run that does not end; nothing if it does, as on a machine that was only held up.
fn endless(harness: &Harness, draw: Source) -> Option<Vec<(String, Drawn)>> {
    let (tell, told) = mpsc::channel();
    let run = harness.native;
    thread::spawn(move || {
        let mut native = Native::new(draw);
        native.told = Some(tell);
        run_once(run, &mut native);
    });
    let mut inputs = Vec::new();
    loop {
        match told.recv_timeout(AGAIN) {
            Ok(input) => inputs.push(input),
            Err(mpsc::RecvTimeoutError::Disconnected) => return None,
            Err(mpsc::RecvTimeoutError::Timeout) => return Some(inputs),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engines::{enumeration, standin};
    use crate::harness::harness;
    use crate::kernel::Production;
    use crate::properties::PROPERTIES;
    use crate::prover::Prover;
    use crate::provers::native::Sample;

    fn endless_at_two(native: &mut Native<Source>) {
        let way = native.choice("way", 3);
        let first = native.scalar("first");
        if way == 2 {
            loop {
                thread::park();
            }
        }
        native.check("never asked with way 2", way < 3 && first.to_bits() != 7);
    }

    fn endless() -> Harness {
        let mut harness = harness::<Production>("watchdog/step").unwrap();
        harness.native = endless_at_two;
        harness
    }

    fn assert_refuted(outcome: Outcome) {
        assert_eq!(outcome.verdict, Verdict::Refuted);
        let found = outcome.counterexample.unwrap();
        assert_eq!(found.check, ENDS);
        assert_eq!(found.inputs.len(), 2);
        assert_eq!(found.inputs[0], ("way".to_owned(), Drawn::Choice(2)));
    }

    #[test]
    fn a_sample_without_an_end_refutes_the_kernel() {
        assert_refuted(standin::run(&endless(), 1_000, usize::MAX));
    }

    #[test]
    fn a_combination_without_an_end_refutes_the_kernel() {
        let property = PROPERTIES.iter().find(|p| p.id == "watchdog/step").unwrap();
        assert_refuted(enumeration::run(property, &endless(), usize::MAX).unwrap());
    }

    #[test]
    fn a_run_that_was_only_held_up_is_no_counterexample() {
        let harness = harness::<Production>("watchdog/step").unwrap();
        let draw = Source::Sample(Sample::new(1, usize::MAX));
        assert_eq!(super::endless(&harness, draw), None);
    }
}
