//! The link monitor: losses by seq, and a detector of bursts.

use std::collections::VecDeque;
use std::ops::Range;

/// The most updates of the detector that one gap makes. `[NCP-RES-047]`
const MAX_UPDATES: u64 = 256;
/// The most missing seqs that are remembered. `[NCP-RES-048] [NCP-RES-056]`
const MAX_MISSING: usize = 4_096;
/// The share of losses that is usual, unless it is said otherwise. `[NCP-RES-051]`
pub const DEFAULT_REF_LOSS: f64 = 0.05;
const MAX_REF_LOSS: f64 = 0.99;
/// The detector's threshold, unless it is said otherwise. `[NCP-RES-052]`
pub const DEFAULT_THRESHOLD: f64 = 5.0;

/// Counts what a stream loses, by the `seq` of every frame that arrives.
#[derive(Debug, Clone)]
pub struct LinkMonitor {
    ref_loss: f64,
    threshold: f64,
    /// The first seq seen and the highest.
    seen: Option<(i64, i64)>,
    received: u64,
    lost: u64,
    missing: Missing,
    cusum: f64,
}

/// What the monitor knows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinkReport {
    /// The highest seq seen; −1: none.
    pub last_seq: i64,
    /// Frames that arrived, duplicates aside.
    pub received: i64,
    /// Frames that did not.
    pub lost: i64,
    /// Lost over expected, within 0 and 1.
    pub loss_rate: f64,
    /// Whether the detector is above its threshold.
    pub burst: bool,
}

impl Default for LinkMonitor {
    fn default() -> Self {
        Self::new(DEFAULT_REF_LOSS, DEFAULT_THRESHOLD)
    }
}

impl LinkMonitor {
    /// A monitor that takes a loss of `ref_loss` for usual, and a burst for what brings its detector
    /// above `threshold`. `[NCP-RES-051] [NCP-RES-052]`
    #[must_use]
    pub fn new(ref_loss: f64, threshold: f64) -> Self {
        let ref_loss = if ref_loss.is_finite() { ref_loss.clamp(0.0, MAX_REF_LOSS) } else { DEFAULT_REF_LOSS };
        let usable = threshold.is_finite() && threshold > 0.0;
        Self {
            ref_loss,
            threshold: if usable { threshold } else { DEFAULT_THRESHOLD },
            seen: None,
            received: 0,
            lost: 0,
            missing: Missing::default(),
            cusum: 0.0,
        }
    }

    /// Takes note of a frame that arrived.
    pub fn on_frame(&mut self, seq: i64) {
        let Some((first, last)) = self.seen else {
            self.seen = Some((seq, seq));
            self.deliver();
            return;
        };
        if seq <= last {
            // [NCP-RES-041] [NCP-RES-042] [NCP-RES-043]
            if self.missing.remove(&seq) {
                self.lost = self.lost.saturating_sub(1);
                self.deliver();
            }
            return;
        }
        self.seen = Some((first, seq));
        // [NCP-RES-040] [NCP-RES-050] From `last` to `seq`, both excluded; the distance of any two i64 fits a u64.
        let gap = seq.abs_diff(last) - 1;
        self.lost = self.lost.saturating_add(gap);
        for _ in 0..gap.min(MAX_UPDATES) {
            self.step(1.0 - self.ref_loss);
        }
        self.remember(last, seq);
        self.deliver();
    }

    /// What is known by now. `[NCP-RES-044] [NCP-RES-046]`
    #[must_use]
    pub fn report(&self) -> LinkReport {
        let saturated = |count: u64| i64::try_from(count).unwrap_or(i64::MAX);
        LinkReport {
            last_seq: self.seen.map_or(-1, |(_, last)| last),
            received: saturated(self.received),
            lost: saturated(self.lost),
            loss_rate: self.loss_rate(),
            burst: self.burst(),
        }
    }

    /// Whether losses bunch up. `[NCP-RES-046]`
    #[must_use]
    pub fn burst(&self) -> bool {
        self.cusum > self.threshold
    }

    /// Lost over expected. `[NCP-RES-044] [NCP-RES-045]`
    #[must_use]
    #[expect(clippy::cast_precision_loss)]
    pub fn loss_rate(&self) -> f64 {
        let Some((first, last)) = self.seen else {
            return 0.0;
        };
        let expected = last.abs_diff(first) as f64 + 1.0;
        (self.lost as f64 / expected).clamp(0.0, 1.0)
    }

    fn deliver(&mut self) {
        self.received = self.received.saturating_add(1);
        self.step(-self.ref_loss);
    }

    /// `[NCP-RES-049]`
    fn step(&mut self, by: f64) {
        self.cusum = (self.cusum + by).clamp(0.0, 2.0 * self.threshold);
    }

    /// Keeps the newest missing seqs, which are the likeliest to come late. `[NCP-RES-057]`
    fn remember(&mut self, last: i64, seq: i64) {
        let newest = i64::try_from(MAX_MISSING).unwrap_or(i64::MAX);
        let from = last.saturating_add(1).max(seq.saturating_sub(newest));
        self.missing.append(from..seq);
        while self.missing.len() > MAX_MISSING {
            self.missing.pop_first();
        }
    }
}

/// Seqs that are missing, in their order: those of a gap are higher than all that were missing before it.
#[derive(Debug, Clone, Default)]
struct Missing(VecDeque<i64>);

impl Missing {
    fn append(&mut self, gap: Range<i64>) {
        self.0.extend(gap);
    }

    /// Whether it was missing.
    fn remove(&mut self, seq: &i64) -> bool {
        self.0.binary_search(seq).is_ok_and(|at| self.0.remove(at).is_some())
    }

    fn pop_first(&mut self) {
        self.0.pop_front();
    }

    fn len(&self) -> usize {
        self.0.len()
    }
}
