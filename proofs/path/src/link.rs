//! The link monitor: what it counts, its detector, and that it keeps its invariant in every step.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use ncp_proofs::engines::{Verdict, standin};

use crate::engine::{Case, Counterexample, Harness, Outcome, Scope, every};
use crate::number::{self, Detector, Term};
use crate::subject::{Link, LinkState};

/// The harness of a claim.
#[must_use]
pub fn run<L: Link + Detector<f64>, T: Detector<Term>>(id: &str) -> Option<Harness> {
    match id {
        "link/detector" => Some(detector::<L, T>),
        "link/traces" => Some(|scope| every(scope, traces::<L>)),
        "link/gaps" => Some(|scope| every(scope, gaps::<L>)),
        "link/step" => Some(|scope| every(scope, step::<L>)),
        "link/relative" => Some(|scope| every(scope, relative::<L>)),
        "link/configuration" => Some(|scope| every(scope, configuration::<L>)),
        _ => None,
    }
}

/// The detector for all doubles, by the symbolic engine; on samples where little is run.
fn detector<L: Detector<f64>, T: Detector<Term>>(scope: Scope) -> Outcome {
    let harness = number::harness::<T, L>();
    let done = match scope {
        Scope::Short => Some(standin::run(&harness, 2_000, 0)),
        Scope::Whole => {
            let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
            // The module of a subject has its name: `ncp_path::subjects::production_link::…`
            let subject = std::any::type_name::<T>().split("::").nth(2).unwrap_or_default();
            number::prove(root, subject, &harness)
        }
    };
    let Some(done) = done else {
        return Outcome {
            detail: "no solver is installed: cargo assure prove does that".to_owned(),
            ..Outcome::default()
        };
    };
    let is_decided = matches!((scope, done.verdict), (Scope::Short, Verdict::Tried) | (Scope::Whole, Verdict::Proved));
    let reached = if is_decided { done.reached.iter().map(|check| (*check, 1)).collect() } else { BTreeMap::new() };
    let picked = |(name, drawn): (String, _)| (name, format!("{drawn:?}"));
    let said = format!(
        "{} paths, {} obligations, {} checks true by evaluation; cross-checked: {} {}",
        done.paths, done.obligations, done.by_evaluation, done.cross_checked, done.detail
    );
    Outcome {
        cases: done.paths.max(done.runs),
        reached,
        counterexample: done.counterexample.map(|found| Counterexample {
            check: "a check of the detector",
            picked: [("check".to_owned(), found.check)]
                .into_iter()
                .chain(found.inputs.into_iter().map(picked))
                .collect(),
        }),
        detail: said,
    }
}

/// Shares of losses and thresholds whose sums are exact, in 64ths.
const EXACT: [(i64, i64); 4] = [(16, 64), (0, 96), (3, 320), (63, 32)];
const UNIT: f64 = 64.0;
/// The most missing seqs that are remembered. `[NCP-RES-048]`
const REMEMBERED: usize = 4_096;
/// The most updates of a gap. `[NCP-RES-047]`
const UPDATES: i128 = 256;

/// Section 8.3 in integers: seqs as i128, the detector in 64ths.
#[derive(Debug, Clone)]
struct Text {
    ref_loss: i64,
    threshold: i64,
    /// *first* and *expected*.
    seen: Option<(i128, i128)>,
    received: i128,
    lost: i128,
    missing: BTreeSet<i128>,
    s: i64,
}

impl Text {
    const fn new((ref_loss, threshold): (i64, i64)) -> Self {
        Self { ref_loss, threshold, seen: None, received: 0, lost: 0, missing: BTreeSet::new(), s: 0 }
    }

    /// A slot of the detector. `[NCP-RES-049]`
    fn slot(&mut self, by: i64) {
        self.s = (self.s + by).max(0).min(2 * self.threshold);
    }

    /// A frame arrives; whether it is late is the monitor's memory to say.
    fn arrives(&mut self, seq: i128) {
        match self.seen {
            None => self.seen = Some((seq, seq + 1)),
            Some((first, expected)) if seq >= expected => {
                self.missing.extend(expected..seq);
                self.lost += seq - expected; // [NCP-RES-040]
                for _ in 0..(seq - expected).min(UPDATES) {
                    self.slot(64 - self.ref_loss);
                }
                self.seen = Some((first, seq + 1));
            }
            // [NCP-RES-041]
            Some(_) if self.missing.remove(&seq) => self.lost -= 1,
            Some(_) => return, // [NCP-RES-042]
        }
        self.received += 1;
        self.slot(-self.ref_loss);
    }

    /// Whether a monitor says and is what the text says.
    fn is_told_by<L: Link>(&self, c: &mut Case, monitor: &L) {
        let LinkState { ref_loss, threshold, seen, received, lost, missing, cusum } = monitor.state();
        let report = monitor.report();
        let (first, expected) = self.seen.unwrap_or((0, 0));
        c.check("first and expected", seen.map(|(first, last)| (first.into(), i128::from(last) + 1)) == self.seen);
        c.check("received", i128::from(received) == self.received && i128::from(report.received) == self.received);
        c.check("lost", i128::from(lost) == self.lost && i128::from(report.lost) == self.lost);
        c.check("what is missing", missing.iter().map(|seq| i128::from(*seq)).eq(self.missing.iter().copied()));
        #[expect(clippy::cast_precision_loss, reason = "they are small")]
        let (s, rate) = (self.s as f64 / UNIT, self.lost as f64 / (expected - first).max(1) as f64);
        c.check("the detector", cusum.to_bits() == s.to_bits());
        #[expect(clippy::float_cmp, reason = "both are the nearest double")]
        let is_rate = report.loss_rate == rate && monitor.loss_rate() == rate;
        c.check("the loss rate", is_rate);
        c.check("the burst", report.burst == (self.s > self.threshold) && monitor.burst() == report.burst);
        let last = if self.seen.is_some() { expected - 1 } else { -1 };
        c.check("the last seq", i128::from(report.last_seq) == last);
        #[expect(clippy::cast_precision_loss, clippy::float_cmp, reason = "they are small")]
        let stays = ref_loss == self.ref_loss as f64 / UNIT && threshold == self.threshold as f64 / UNIT;
        c.check("the configuration stays", stays);
    }
}

/// A monitor whose sums are exact.
fn exact<L: Link>((ref_loss, threshold): (i64, i64)) -> L {
    #[expect(clippy::cast_precision_loss, reason = "they are small")]
    let of = |count: i64| count as f64 / UNIT;
    L::new(of(ref_loss), of(threshold))
}

/// All short traces of small seqs: the monitor is what the text says, after each frame.
fn traces<L: Link>(c: &mut Case) {
    let config = *c.pick("ref_loss and threshold in 64ths", &EXACT);
    let length = c.bound(3, 6);
    let (mut text, mut monitor) = (Text::new(config), exact::<L>(config));
    text.is_told_by(c, &monitor);
    for _ in 0..length {
        let seq = *c.pick("seq", &[-1, 0, 1, 2, 3, 4, 5, 9_i64]);
        text.arrives(seq.into());
        monitor.on_frame(seq);
        text.is_told_by(c, &monitor);
    }
}

/// Three frames with seqs at every edge: counts, memory, and the updates of a gap.
fn gaps<L: Link>(c: &mut Case) {
    const EDGES: [i64; 17] = [
        i64::MIN,
        i64::MIN + 1,
        -4_097,
        -1,
        0,
        1,
        2,
        256,
        257,
        258,
        259,
        4_095,
        4_096,
        4_097,
        4_098,
        i64::MAX - 1,
        i64::MAX,
    ];
    // The last is not full after 256 updates, so that one more would be seen.
    let configs = [EXACT.as_slice(), &[(3, 20_000)]].concat();
    let config = *c.pick("ref_loss and threshold in 64ths", &configs);
    let mut monitor = exact::<L>(config);
    let (ref_loss, threshold) = (config.0, config.1);
    let mut s = 0;
    let mut lost = 0_i128;
    let mut was_full = false;
    let mut span: Option<(i128, i128)> = None;
    for _ in 0..c.bound(2, 3) {
        let edges = c.bound(&EDGES[..9], &EDGES[..]);
        let seq = *c.pick("seq", edges);
        let before = monitor.state();
        let was_missing = before.missing.contains(&seq);
        monitor.on_frame(seq);
        let after = monitor.state();
        let wide = i128::from(seq);
        let mut slot = |by: i64| s = (s + by).clamp(0, 2 * threshold);
        let (first, expected) = span.unwrap_or((wide, wide));
        if wide >= expected {
            lost += wide - expected;
            for _ in 0..(wide - expected).min(UPDATES) {
                slot(64 - ref_loss);
            }
            slot(-ref_loss);
            span = Some((first, wide + 1));
        } else if was_missing {
            lost -= 1;
            slot(-ref_loss);
        }
        let (first, expected) = span.unwrap_or_default();
        // [NCP-RES-050]
        c.check("lost", i128::from(after.lost) == lost);
        c.check("first and expected", after.seen.map(|(a, b)| (a.into(), i128::from(b) + 1)) == span);
        c.check("remembers at most 4096", after.missing.len() <= REMEMBERED);
        let is_between = |seq: &i64| (first + 1..expected - 1).contains(&i128::from(*seq));
        c.check("remembers only what is between", after.missing.iter().all(is_between));
        // None is forgotten while there is room.
        was_full |= lost > 4_096;
        let is_whole = was_full || after.missing.len() as i128 == lost;
        c.check("remembers all while there is room", is_whole);
        #[expect(clippy::cast_precision_loss, reason = "it is small")]
        let is_s = after.cusum.to_bits() == (s as f64 / UNIT).to_bits();
        c.check("the detector, at most 256 updates a gap", is_s);
        c.check("the loss rate within 0 and 1", (0.0..=1.0).contains(&monitor.loss_rate()));
        #[expect(clippy::cast_precision_loss, reason = "the tolerance is wider")]
        let (share, rate) = (lost as f64 / (expected - first) as f64, monitor.loss_rate());
        c.check("the loss rate is lost over expected", (share - rate).abs() <= 1e-15);
    }
}

/// Any state of the listed numbers that keeps the invariant, and any of the listed seqs: the next state keeps it.
fn step<L: Link>(c: &mut Case) {
    let ref_loss = *c.pick("ref_loss", &[0.0, 5e-324, 0.05, 0.5, 0.99]);
    let threshold: f64 = *c.pick("threshold", &[5e-324, 0.3, 5.0, 1e300, f64::MAX]);
    let most = 2.0 * threshold;
    let edges = [0.0, 5e-324, threshold / 2.0, threshold, threshold.next_up(), most.next_down(), most];
    let cusum = *c.pick("S", &edges);
    let spans = [None, Some((0, 0)), Some((-3, 7)), Some((i64::MIN, i64::MAX)), Some((i64::MAX - 9, i64::MAX))];
    let seen: Option<(i64, i64)> = *c.pick("first and last", &spans);
    let counts = [0, 1, (1_u64 << 53) - 1, u64::MAX];
    let (received, lost) = (*c.pick("received", &counts), *c.pick("lost", &counts));
    let mut missing = BTreeSet::new();
    if let Some((first, last)) = seen
        && last.abs_diff(first) > 3
        && c.either("some are missing")
    {
        missing.extend([first + 1, last - 1]);
    }
    let before = LinkState { ref_loss, threshold, seen, received, lost, missing, cusum };
    let seq = *c.pick("seq", &[i64::MIN, -2, 0, 6, 8, 300, i64::MAX - 1, i64::MAX]);
    let mut monitor = L::of(before.clone());
    monitor.on_frame(seq);
    let after = monitor.state();
    c.check("0 ≤ S ≤ 2·threshold", (0.0..=most).contains(&after.cusum));
    let same = |a: f64, b: f64| a.to_bits() == b.to_bits();
    c.check("the configuration stays", same(after.ref_loss, ref_loss) && same(after.threshold, threshold));
    c.check("first stays", seen.is_none_or(|(first, _)| after.seen.map(|(first, _)| first) == Some(first)));
    let last = seen.map_or(seq, |(_, last)| last.max(seq));
    c.check("expected moves forward only, to this frame", after.seen.map(|(_, last)| last) == Some(last));
    let is_new = seen.is_none_or(|(_, last)| seq > last);
    let is_late = before.missing.contains(&seq);
    let gap = if let (Some((_, last)), true) = (seen, is_new) { seq.abs_diff(last) - 1 } else { 0 };
    let counted = if is_late { lost.saturating_sub(1) } else { lost.saturating_add(gap) };
    c.check("lost, saturating", after.lost == counted);
    let counted = if is_new || is_late { received.saturating_add(1) } else { received };
    c.check("received, saturating", after.received == counted);
    if !is_new && !is_late {
        c.check("a duplicate changes nothing", after == before);
    }
    c.check("what is late is missing no longer", !after.missing.contains(&seq));
    let between = after.seen.is_some_and(|(first, last)| after.missing.iter().all(|seq| first < *seq && *seq < last));
    c.check("missing lies between first and last", after.missing.is_empty() || between);
    c.check("remembers at most 4096", after.missing.len() <= REMEMBERED);
    c.check("the loss rate within 0 and 1", (0.0..=1.0).contains(&monitor.loss_rate()));
    c.check("a burst exactly above the threshold", monitor.burst() == (after.cusum > threshold));
    if gap > 0 {
        c.check("a gap raises S, and its end takes ref_loss off", after.cusum >= (cusum - ref_loss).max(0.0));
    } else {
        c.check("S rises by a gap only", after.cusum <= cusum);
    }
    let report = monitor.report();
    c.check("reported counts are whole and not below 0", report.received >= 0 && report.lost >= 0);
}

/// Only differences of seqs count, and what was counted before decides nothing: from any state of these, the shifted
/// one goes to the shifted next one.
fn relative<L: Link>(c: &mut Case) {
    let config = *c.pick("ref_loss and threshold in 64ths", &EXACT);
    let mut monitor = exact::<L>(config);
    let shift = *c.pick("shift", &[1_i64, -7, 1_000, 1 << 40]);
    for _ in 0..c.bound(2, 4) {
        let seq = *c.pick("seq", &[0, 1, 2, 4, 5, 9_i64]);
        let mut before = monitor.state();
        monitor.on_frame(seq);
        let mut expected = monitor.state();
        for state in [&mut before, &mut expected] {
            state.seen = state.seen.map(|(first, last)| (first + shift, last + shift));
            state.missing = state.missing.iter().map(|seq| seq + shift).collect();
            (state.received, state.lost) = (state.received + 1_000, state.lost + 1_000);
        }
        let mut other = L::of(before);
        other.on_frame(seq + shift);
        c.check("a shifted stream is counted alike", other.state() == expected);
    }
}

/// What a configuration makes of the listed doubles.
fn configuration<L: Link>(c: &mut Case) {
    const NUMBERS: [f64; 16] = [
        0.0,
        -0.0,
        5e-324,
        -5e-324,
        0.05,
        0.99,
        0.990_000_000_000_000_1,
        1.0,
        -1.0,
        5.0,
        f64::MAX,
        f64::MIN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NAN,
        -f64::NAN,
    ];
    let (ref_loss, threshold) = (*c.pick("ref_loss", &NUMBERS), *c.pick("threshold", &NUMBERS));
    let monitor = L::new(ref_loss, threshold);
    let LinkState { ref_loss: r, threshold: t, seen, received, lost, missing, cusum } = monitor.state();
    // [NCP-RES-051] [NCP-RES-052]
    let says = match ref_loss {
        _ if !ref_loss.is_finite() => 0.05,
        _ if ref_loss > 0.99 => 0.99,
        _ if ref_loss < 0.0 => 0.0,
        _ => ref_loss,
    };
    #[expect(clippy::float_cmp, reason = "exactly that is claimed")]
    let is_clamped = r == says;
    c.check("ref_loss is clamped, or 0.05", is_clamped);
    let is_one = threshold.is_finite() && threshold > 0.0;
    #[expect(clippy::float_cmp, reason = "exactly that is claimed")]
    let is_taken = t == if is_one { threshold } else { 5.0 };
    c.check("the threshold, or 5", is_taken);
    let is_empty = seen.is_none() && (received, lost) == (0, 0) && missing.is_empty() && cusum.to_bits() == 0;
    c.check("nothing was seen", is_empty);
    let report = monitor.report();
    c.check("nothing is reported", report.last_seq == -1 && report.loss_rate.to_bits() == 0 && !report.burst);
}
