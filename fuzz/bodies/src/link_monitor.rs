//! Traces of the link monitor, against an exact model of section 8.3.

use std::collections::BTreeSet;

use ncp_spec::resilience::LinkMonitor;

use crate::plain::{plain, read};

plain! {
    /// The next frame.
    enum Arrival {
        /// The next one in order, after so many that are lost.
        0 After(u8),
        /// One so far back.
        1 Back(u8),
        /// Any.
        2 Seq(i64),
        /// As many in order, none lost.
        3 Run(u8),
    }
}
plain! {
    /// A monitor and what arrives.
    struct Trace {
        /// `ref_loss`.
        ref_loss: f64,
        /// `threshold`.
        threshold: f64,
        /// In this order.
        arrivals: Vec<Arrival>,
    }
}

/// The most arrivals of a trace that are judged.
const MOST: usize = 48;
/// The most missing seqs that a trace may have the monitor remember. What leaves out more, again and again, shows
/// nothing new and takes long.
const MOST_MISSING: i128 = 3 * 4_096;

/// Counts, rate and burst are those of an exact model, in integers that cannot overflow, after every
/// arrival.
///
/// It would find a gap that overflows or hides a burst, a late frame that is not taken back, a duplicate
/// that counts, and a detector that never comes down.
// [NCP-RES-040] [NCP-RES-041] [NCP-RES-042] [NCP-RES-043] [NCP-RES-044] [NCP-RES-045] [NCP-RES-046]
// [NCP-RES-047] [NCP-RES-048] [NCP-RES-049] [NCP-RES-050] [NCP-RES-051] [NCP-RES-052]
pub fn link_monitor_trace(input: &[u8]) {
    let trace = read::<Trace>(input);
    let mut monitor = LinkMonitor::new(trace.ref_loss, trace.threshold);
    let mut model = Model::new(trace.ref_loss, trace.threshold);
    model.judge(&monitor);
    let mut last = 0_i64;
    let mut missing = 0;
    for arrival in trace.arrivals.iter().take(MOST) {
        let (from, count) = match arrival {
            Arrival::After(lost) => (last.saturating_add(1 + i64::from(*lost)), 1),
            Arrival::Back(back) => (last.saturating_sub(i64::from(*back)), 1),
            Arrival::Seq(seq) => (*seq, 1),
            Arrival::Run(count) => (last.saturating_add(1), i64::from(*count)),
        };
        missing += model.gap(from).min(4_096);
        if missing > MOST_MISSING {
            break;
        }
        for seq in (0..count).map(|more| from.saturating_add(more)) {
            monitor.on_frame(seq);
            model.on_frame(seq.into());
            last = last.max(seq);
            model.judge(&monitor);
        }
    }
}

/// The rules of the text. Of more than 4,096 missing seqs it remembers the newest.
struct Model {
    ref_loss: f64,
    threshold: f64,
    first: i128,
    /// One more than the highest seq seen.
    expected: Option<i128>,
    received: i128,
    lost: i128,
    missing: BTreeSet<i128>,
    s: f64,
}

impl Model {
    fn new(ref_loss: f64, threshold: f64) -> Self {
        Self {
            ref_loss: if ref_loss.is_finite() { ref_loss.clamp(0.0, 0.99) } else { 0.05 },
            threshold: if threshold.is_finite() && threshold > 0.0 { threshold } else { 5.0 },
            first: 0,
            expected: None,
            received: 0,
            lost: 0,
            missing: BTreeSet::new(),
            s: 0.0,
        }
    }

    /// How many seqs would be missing before this one.
    fn gap(&self, seq: i64) -> i128 {
        self.expected.map_or(0, |expected| (i128::from(seq) - expected).max(0))
    }

    fn on_frame(&mut self, seq: i128) {
        let expected = *self.expected.get_or_insert_with(|| {
            self.first = seq;
            seq
        });
        if seq < expected {
            if self.missing.remove(&seq) {
                self.lost -= 1;
                self.deliver();
            }
            return;
        }
        self.lost += seq - expected;
        for missing in expected..seq.min(expected + 256) {
            let _ = missing;
            self.slot(1.0 - self.ref_loss);
        }
        self.missing.extend(expected.max(seq - 4_096)..seq);
        while self.missing.len() > 4_096 {
            self.missing.pop_first();
        }
        self.expected = Some(seq + 1);
        self.deliver();
    }

    fn deliver(&mut self) {
        self.received += 1;
        self.slot(-self.ref_loss);
    }

    fn slot(&mut self, by: f64) {
        self.s = (self.s + by).max(0.0).min(2.0 * self.threshold);
    }

    fn judge(&self, monitor: &LinkMonitor) {
        let report = monitor.report();
        let most = i128::from(i64::MAX);
        assert_eq!(i128::from(report.received), self.received.min(most));
        assert_eq!(i128::from(report.lost), self.lost.min(most), "lost");
        assert_eq!(report.burst, self.s > self.threshold, "S is {}", self.s);
        let (last, rate) = match self.expected {
            None => (-1, 0.0),
            Some(expected) => (expected - 1, self.lost as f64 / (expected - self.first) as f64),
        };
        assert_eq!(i128::from(report.last_seq), last);
        assert!((0.0..=1.0).contains(&report.loss_rate));
        assert!((report.loss_rate - rate).abs() <= 1e-12, "{} is not {rate}", report.loss_rate);
    }
}
