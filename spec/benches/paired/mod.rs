//! Two pieces of work, timed in turns, sample by sample, so that whatever slows the machine slows
//! both. What counts is the median sample.

use std::hint::black_box;
use std::time::{Duration, Instant};

/// Times pairs; without `--bench` (as under `cargo test`) everything runs once, to see that it
/// works.
pub(crate) struct Bench {
    quick: bool,
}

impl Bench {
    const SAMPLES: usize = 201;

    /// As the command line says.
    pub(crate) fn from_args() -> Self {
        Self { quick: !std::env::args().any(|arg| arg == "--bench") }
    }

    /// Prints the time of `work` as a multiple of the time of `other`, whose name is `against`.
    pub(crate) fn ratio<T, U>(
        &self,
        name: &str,
        against: &str,
        aim: &str,
        mut work: impl FnMut() -> T,
        mut other: impl FnMut() -> U,
    ) {
        let calls = self.calls(&mut work).max(self.calls(&mut other));
        let (work, other): (Vec<_>, Vec<_>) =
            (0..self.samples()).map(|_| (sample(calls, &mut work), sample(calls, &mut other))).unzip();
        let (work, other) = (median(work), median(other));
        let (work_ns, other_ns) = (work * 1e9, other * 1e9);
        println!("ratio  {name} vs {against}  {:.2} ({aim}); {work_ns:.0} ns against {other_ns:.0} ns", work / other);
    }

    /// The median time of one call, in seconds.
    #[allow(dead_code, reason = "not every bench has something to time alone")]
    pub(crate) fn time<T>(&self, mut work: impl FnMut() -> T) -> f64 {
        let calls = self.calls(&mut work);
        median((0..self.samples()).map(|_| sample(calls, &mut work)).collect())
    }

    fn samples(&self) -> usize {
        if self.quick { 1 } else { Self::SAMPLES }
    }

    /// Warms up, and says how many calls make a sample of about 2 ms.
    fn calls<T>(&self, work: &mut impl FnMut() -> T) -> u32 {
        if self.quick {
            return 1;
        }
        let (start, mut calls) = (Instant::now(), 0_u32);
        while start.elapsed() < Duration::from_millis(200) {
            black_box(work());
            calls += 1;
        }
        (calls / 100).max(1)
    }
}

/// The mean time of a call over `calls` of them, in seconds.
fn sample<T>(calls: u32, work: &mut impl FnMut() -> T) -> f64 {
    let start = Instant::now();
    for _ in 0..calls {
        black_box(work());
    }
    start.elapsed().as_secs_f64() / f64::from(calls)
}

fn median(mut samples: Vec<f64>) -> f64 {
    samples.sort_unstable_by(f64::total_cmp);
    samples[samples.len() / 2]
}
