//! The link monitor.

use std::collections::BTreeSet;

use crate::case::{Case, File, Role};
use crate::json::{Json, object};
use crate::scenario::{Row, ScenarioError, Scenarios, source};
use crate::trace::{any, int, name_of, no_result, num, steps, within};

pub(super) fn file() -> Result<File, ScenarioError> {
    let mut text = Scenarios::read(source!("resilience/link"))?;
    let mut cases = text.cases("count", row_case)?;
    cases.extend(counts());
    cases.extend(text.cases("last-seq", last_seq)?);
    cases.extend(gaps());
    cases.extend(text.cases("burst", row_case)?);
    cases.push(at_the_threshold());
    cases.extend(next_to_the_threshold());
    cases.extend(high_thresholds());
    cases.extend(small_beside_the_sum());
    cases.extend(text.rest(row_case)?);
    cases.extend(relapses());
    cases.extend(small_losses());
    cases.extend(lasting());
    cases.extend(alike());
    cases.extend(bounded());
    cases.extend(parameters());
    cases.extend(extremes());
    cases.extend(alike_from_before());
    cases.extend(spans());
    cases.push(far_apart());
    let about =
        "The link monitor: losses, late frames and duplicates, bursts and how they clear, and seqs from end to end.";
    Ok(File::new("resilience", "link", about, cases))
}

/// A monitor in plain arithmetic. The text leaves open in what order one frame's gap and its
/// delivery count, and the detector is compared only where that, and what a late frame is worth,
/// makes no difference.
struct Monitor {
    ref_loss: f64,
    threshold: f64,
    first: Option<i64>,
    expected: i64,
    received: i64,
    /// Whether a frame from before the first counts as received; the text allows either.
    counts_older: bool,
    /// Whether the frame of the highest seq is also the last that arrived.
    in_order: bool,
    missing: BTreeSet<i64>,
    /// The detector, by each reading.
    sums: Vec<(Reading, f64)>,
    /// How many numbers were added to a sum, each of which may be rounded.
    added: f64,
}

#[derive(Clone, Copy)]
struct Reading {
    delivery_first: bool,
    late: f64,
}

impl Monitor {
    fn new(ref_loss: f64, threshold: f64, counts_older: bool) -> Self {
        let mut sums = Vec::new();
        for delivery_first in [false, true] {
            for late in [-ref_loss, -1.0, 0.0] {
                sums.push((Reading { delivery_first, late }, 0.0));
            }
        }
        Self {
            ref_loss,
            threshold,
            first: None,
            expected: 0,
            received: 0,
            counts_older,
            in_order: true,
            missing: BTreeSet::new(),
            sums,
            added: 0.0,
        }
    }

    fn frame(&mut self, seq: i64) {
        self.in_order = seq >= self.expected || self.in_order && seq + 1 == self.expected;
        let (gap, is_late) = match self.first {
            None => {
                self.first = Some(seq);
                self.expected = seq;
                (0, false)
            }
            Some(_) if seq < self.expected => {
                if !self.missing.remove(&seq) {
                    let is_older = self.first.is_some_and(|first| seq < first);
                    self.received += i64::from(is_older && self.counts_older);
                    return;
                }
                (0, true)
            }
            Some(_) => (seq - self.expected, false),
        };
        self.received += 1;
        self.added += f64::from(u16::try_from(gap.min(256)).unwrap_or(256)) + 1.0;
        let (loss, delivery, cap) = (1.0 - self.ref_loss, -self.ref_loss, 2.0 * self.threshold);
        for (reading, sum) in &mut self.sums {
            let mut add = |by: f64| *sum = (*sum + by).clamp(0.0, cap);
            if is_late {
                add(reading.late);
                continue;
            }
            if reading.delivery_first {
                add(delivery);
            }
            for _ in 0..gap.min(256) {
                add(loss);
            }
            if !reading.delivery_first {
                add(delivery);
            }
        }
        if !is_late {
            self.missing.extend(self.expected..seq);
            self.expected = seq + 1;
        }
    }

    fn report(&self) -> Json {
        let lost = self.missing.len();
        let span = self.first.map_or(1, |first| self.expected - first);
        #[expect(clippy::cast_precision_loss, reason = "small counts")]
        let rate = lost as f64 / span as f64;
        let report = object! {
            "last_seq" => int(self.expected - 1),
            "received" => int(self.received),
            "lost" => Json::literal(lost.to_string()),
            "loss_rate" => num(rate),
        };
        // Then it may be that of the frame that arrived last.
        let report = if self.in_order { report } else { report.without("last_seq") };
        // What rounding may make of so many sums of up to twice the threshold, with room to spare.
        let margin = 4.0 * f64::EPSILON * (self.added + 16.0) * (2.0 * self.threshold).max(1.0);
        if self.sums.iter().all(|(_, sum)| *sum > self.threshold + margin) {
            report.with("burst", Json::Bool(true))
        } else if self.sums.iter().all(|(_, sum)| *sum < self.threshold - margin) {
            report.with("burst", Json::Bool(false))
        } else {
            report
        }
    }
}

const BOTH: [Role; 2] = [Role::Commander, Role::Body];

fn args(ref_loss: Option<f64>, threshold: Option<f64>, seqs: &[i64]) -> Json {
    let frames: Json = seqs.iter().map(|seq| object! { "op" => "frame", "seq" => int(*seq) }).collect();
    object! { "ref_loss" => ref_loss.map(num), "threshold" => threshold.map(num), "steps" => frames }
}

fn case(
    path: String,
    rules: &[&'static str],
    given: (Option<f64>, Option<f64>),
    meant: (f64, f64),
    seqs: &[i64],
) -> Case {
    // Only the cases of the rate ask for it.
    let asks_for_rate = matches!(rules.first(), Some(&"NCP-RES-044" | &"NCP-RES-045"));
    let reports = |counts_older| {
        let mut monitor = Monitor::new(meant.0, meant.1, counts_older);
        let report = |seq: &i64| {
            monitor.frame(*seq);
            let report = monitor.report();
            if asks_for_rate { report } else { report.without("loss_rate") }
        };
        steps(seqs.iter().map(report).collect())
    };
    let mut patterns = vec![reports(false), reports(true)];
    patterns.dedup();
    let case = Case::new(path, rules, &BOTH).call("link.run", args(given.0, given.1, seqs)).shows(any(patterns));
    of_members(case)
}

/// Lets each member of a report be judged by the rule about it.
fn of_members(case: Case) -> Case {
    let own = case.requirements.first().copied().unwrap_or_default();
    let case = case.by("/steps/*/last_seq", "NCP-RES-054");
    match own {
        // What is lost and what is received is one count.
        "NCP-RES-040" | "NCP-RES-041" | "NCP-RES-042" | "NCP-RES-043" | "NCP-RES-050" => {
            case.by("/steps/*/burst", "NCP-RES-046").by("/steps/*/loss_rate", "NCP-RES-044")
        }
        "NCP-RES-044" | "NCP-RES-045" => case
            .by("/steps/*/burst", "NCP-RES-046")
            .by("/steps/*/received", "NCP-RES-041")
            .by("/steps/*/lost", "NCP-RES-040"),
        _ => case.by("/steps/*/received", "NCP-RES-041").by("/steps/*/lost", "NCP-RES-040"),
    }
}

fn usual(path: &str, rules: &[&'static str], seqs: &[i64]) -> Case {
    case(path.to_owned(), rules, (None, None), (0.05, 5.0), seqs)
}

/// The seqs of a row: one after the other, `1..9` and `1..9/2` for every seq and every second one up to 9, and `5x3`
/// for
/// three times 5.
fn seqs(row: &Row) -> Result<Vec<i64>, ScenarioError> {
    let mut seqs = Vec::new();
    for word in row.body.split(' ') {
        let (word, by) = word.split_once('/').unwrap_or((word, "1"));
        let integer = |word| row.place.integer(word);
        if let Some((from, to)) = word.split_once("..") {
            let by = usize::try_from(integer(by)?).unwrap_or(1);
            seqs.extend((integer(from)?..=integer(to)?).step_by(by));
        } else if let Some((seq, times)) = word.split_once('x') {
            seqs.extend((0..integer(times)?).map(|_| integer(seq)).collect::<Result<Vec<_>, _>>()?);
        } else {
            seqs.push(integer(word)?);
        }
    }
    Ok(seqs)
}

fn row_case(row: &Row) -> Result<Case, ScenarioError> {
    let case = usual(&row.path, &row.rules, &seqs(row)?);
    Ok(case.title(&row.title).flags(&row.flags).because(&row.why))
}

/// The `last_seq` alone.
fn last_seq(row: &Row) -> Result<Case, ScenarioError> {
    let seqs = seqs(row)?;
    let highest = seqs.iter().scan(i64::MIN, |highest, seq| {
        *highest = (*highest).max(*seq);
        Some(object! { "last_seq" => int(*highest) })
    });
    Ok(row.case(&BOTH).call("link.run", args(None, None, &seqs)).shows(steps(highest.collect())))
}

fn counts() -> Vec<Case> {
    let mut cases = Vec::new();
    // Every order of four frames after a first one.
    for (nth, order) in orders().into_iter().enumerate() {
        let mut seqs = vec![1];
        seqs.extend(order);
        seqs.extend([6, 7]);
        cases.push(
            usual(&format!("order/{nth:02}"), &["NCP-RES-041", "NCP-RES-040", "NCP-RES-043", "NCP-RES-056"], &seqs)
                .title(format!("The frames {seqs:?} lose nothing in the end, in this order."))
                .flags(&["wrong-loss"])
                .because(
                    "A late frame is taken back from `lost` and counted as received, and expected only moves forward.",
                ),
        );
    }
    // Every subset of four frames that may be lost.
    for mask in 0..16_i64 {
        let seqs: Vec<i64> = std::iter::once(1)
            .chain((0..4).filter(|bit| mask >> bit & 1 == 0).map(|bit| bit + 2))
            .chain([6, 7])
            .collect();
        cases.push(
            usual(&format!("lost/{mask:04b}"), &["NCP-RES-040", "NCP-RES-044"], &seqs)
                .title(format!("Of the frames 1 to 7, {seqs:?} arrive."))
                .flags(&["wrong-loss"])
                .because("Each seq between expected and the seq of an arriving frame is lost."),
        );
        cases.push(
            usual(&format!("rate/{mask:04b}"), &["NCP-RES-044"], &seqs)
                .title(format!("The loss rate after each of the frames {seqs:?}."))
                .flags(&["wrong-loss"])
                .because(
                    "The loss rate is lost / (expected \u{2212} first), and expected is one more than the \
                          highest seq seen.",
                ),
        );
    }
    cases
}

/// Every order of 2, 3, 4, 5.
fn orders() -> Vec<Vec<i64>> {
    let mut all = vec![Vec::new()];
    for _ in 0..4 {
        all = all
            .into_iter()
            .flat_map(|order: Vec<i64>| {
                (2..=5)
                    .filter(|next| !order.contains(next))
                    .map(|next| [order.clone(), vec![next]].concat())
                    .collect::<Vec<_>>()
            })
            .collect();
    }
    all
}

fn gaps() -> Vec<Case> {
    let mut cases = Vec::new();
    for gap in [1, 2, 3, 4, 5, 6, 7, 10, 11, 20, 100, 255, 256, 257, 1000] {
        let rule = if gap > 256 { "NCP-RES-050" } else { "NCP-RES-046" };
        cases.push(
            usual(&format!("burst/gap-{gap}"), &[rule, "NCP-RES-040"], &[1, 2, 3 + gap, 4 + gap])
                .title(format!("A gap of {gap} raises the burst as the detector says."))
                .flags(&["burst-detector"])
                .because(
                    "A missing seq adds 0.95 and a delivery takes 0.05 off; the burst is on while the sum is above 5.",
                ),
        );
    }
    cases
}

/// Bursts of other parameters, where only the sum decides.
fn at_the_threshold() -> Case {
    // Without a usual loss every sum is a whole number, so that the threshold itself can be met.
    let entry = |burst| object! { "burst" => Json::Bool(burst) };
    Case::new("burst/at-the-threshold", &["NCP-RES-046"], &BOTH)
        .call("link.run", args(Some(0.0), Some(5.0), &[1, 7, 9]))
        .shows(steps(vec![entry(false), entry(false), entry(true)]))
        .title("A sum of exactly the threshold is no burst, and one more loss is.")
        .flags(&["burst-detector"])
        .because("The burst is true exactly while the sum is above the threshold; 5 is not above 5.")
}

/// Sums that no rounding takes to the other side of a threshold next to them.
fn next_to_the_threshold() -> Vec<Case> {
    let table: [(&str, f64, i64, bool); 9] = [
        ("just-below", 2.999_999_999_9, 3, true),
        ("next-below", 3_f64.next_down(), 3, true),
        ("next-above", 3_f64.next_up(), 3, false),
        ("just-above", 3.000_000_000_1, 3, false),
        ("of-24-bits-below", 2.999_999_9, 3, true),
        ("of-24-bits-above", 3.000_000_1, 3, false),
        ("below-a-hundred", 99.999_999_999, 100, true),
        ("small", 1e-10, 1, true),
        ("smallest", 2e-12, 1, true),
    ];
    let case = |(name, threshold, missing, is_burst): (&str, f64, i64, bool)| {
        let entry = |burst| object! { "burst" => Json::Bool(burst) };
        Case::new(format!("burst/next-to-the-threshold/{name}"), &["NCP-RES-046"], &BOTH)
            .call("link.run", args(Some(0.0), Some(threshold), &[1, 2 + missing]))
            .shows(steps(vec![entry(false), entry(is_burst)]))
            .title(format!(
                "Under a reference loss of 0, {missing} lost frames are {} at a threshold of {threshold:?}.",
                if is_burst { "a burst" } else { "no burst" }
            ))
            .flags(&["burst-detector"])
            .because(
                "The burst is true exactly while the sum is above the threshold, and no sum of whole numbers rounds.",
            )
    };
    table.map(case).into()
}

/// Thresholds beyond what a detector might hold for the most that a sum comes to.
fn high_thresholds() -> Vec<Case> {
    let case = |(threshold, gaps): (f64, i64)| {
        // Each gap of 256 adds 256 under a reference loss of 0, and takes nothing off.
        let seqs: Vec<i64> = (0..=gaps).map(|nth| 1 + nth * 257).collect();
        #[expect(clippy::cast_precision_loss, reason = "the numbers are small")]
        let is_burst = |nth: usize| (nth * 256) as f64 > threshold;
        let entries = (0..seqs.len()).map(|nth| object! { "burst" => Json::Bool(is_burst(nth)) }).collect();
        Case::new(format!("burst/high-threshold/{threshold}"), &["NCP-RES-046", "NCP-RES-049"], &BOTH)
            .call("link.run", args(Some(0.0), Some(threshold), &seqs))
            .shows(steps(entries))
            .title(format!("{gaps} gaps of 256 lost frames are a burst at a threshold of {threshold}."))
            .flags(&["burst-detector"])
            .because("The sum may come to twice the threshold, however high that is.")
    };
    [(300.5, 4), (1_100.5, 8), (4_200.5, 20), (33_000.5, 130)].map(case).into()
}

/// Sums that fall below the threshold before they are 0, and rise above it again.
fn relapses() -> Vec<Case> {
    let mut cases = Vec::new();
    for threshold in [2_u32, 3] {
        for (ref_loss, inverse) in [(0.125, 8), (0.25, 4), (0.5, 2)] {
            // Up to one and a half times the threshold, and down by three quarters of it.
            let gap = i64::from(3 * threshold * inverse / (2 * (inverse - 1))) + 1;
            let falls = i64::from(threshold * inverse * 3 / 4) + 1;
            let mut seqs = vec![1, 2 + gap];
            seqs.extend((1..=falls).map(|nth| 2 + gap + nth));
            let again = 3 + gap + falls + gap;
            seqs.extend([again, again + 1, again + 2]);
            cases.push(
                case(
                    format!("burst/relapse/threshold-{threshold}/ref-loss-{ref_loss}"),
                    &["NCP-RES-046"],
                    (Some(ref_loss), Some(f64::from(threshold))),
                    (ref_loss, f64::from(threshold)),
                    &seqs,
                )
                .title(format!(
                    "Under a threshold of {threshold} and a reference loss of {ref_loss} a burst is over below the \
                     threshold, not only at 0, and comes again."
                ))
                .flags(&["burst-detector"])
                .because("The burst is true exactly while the sum is above the threshold, whatever it was before."),
            );
        }
    }
    cases
}

/// Reference losses so small that few deliveries take off less than most arithmetic in fixed point holds.
fn small_losses() -> Vec<Case> {
    // One loss, and so many deliveries until it is below the threshold.
    let table = [(1e-3, 9), (1e-5, 9), (5e-6, 20), (1e-7, 9), (2_f64.powi(-17), 9), (2_f64.powi(-33), 9)];
    table
        .into_iter()
        .map(|(ref_loss, falls)| {
            let threshold = 1.0 - ref_loss * (f64::from(falls) + 0.5);
            let seqs: Vec<i64> = [0, 2].into_iter().chain(3..i64::from(falls) + 6).collect();
            case(
                format!("burst/small-loss/{}", name_of(ref_loss)),
                &["NCP-RES-046"],
                (Some(ref_loss), Some(threshold)),
                (ref_loss, threshold),
                &seqs,
            )
            .title(format!(
                "A burst by one loss is over after {falls} deliveries under a reference loss of {ref_loss}."
            ))
            .flags(&["burst-detector"])
            .because("Each delivery takes the reference loss off the sum, however small it is.")
        })
        .collect()
}

/// Sums beside which the reference loss is so small that single precision drops it, or takes too much of it.
fn small_beside_the_sum() -> Vec<Case> {
    [("dropped", 5e-6, 22_000, false), ("too-much", 1e-5, 8_000, true)]
        .into_iter()
        .map(|(name, ref_loss, frames, is_burst)| {
            let threshold = 255.9;
            let seqs: Vec<i64> = [1].into_iter().chain(258..258 + frames).collect();
            let mut entries: Vec<Json> = seqs.iter().skip(1).map(|_| no_result()).collect();
            entries.push(object! { "burst" => is_burst });
            Case::new(format!("burst/small-beside-the-sum/{name}"), &["NCP-RES-046"], &BOTH)
                .call("link.run", args(Some(ref_loss), Some(threshold), &seqs))
                .shows(steps(entries))
                .title(format!(
                    "Under a reference loss of {ref_loss}, {frames} deliveries take as many times that off a sum of \
                     256."
                ))
                .flags(&["burst-detector"])
                .because("Each delivery takes the reference loss off the sum, however small it is beside it.")
        })
        .collect()
}

/// Bursts over hundreds of frames without a gap, which end when the sum says so and not before.
fn lasting() -> Vec<Case> {
    // The reference loss, the threshold, the gap, and how many frames follow.
    let table = [(0.0, 5.0, 98, 300), (0.001, 5.0, 98, 300), (0.01, 5.0, 98, 520), (0.05, 50.0, 250, 300)];
    let mut cases = Vec::new();
    for (ref_loss, threshold, gap, frames) in table {
        let seqs: Vec<i64> = [1].into_iter().chain(2 + gap..2 + gap + frames).collect();
        let mut monitor = Monitor::new(ref_loss, threshold, false);
        let report = |(nth, seq): (usize, &i64)| {
            monitor.frame(*seq);
            let burst = monitor.report().get("burst").cloned();
            match burst {
                // Now and then is often enough, and at the end.
                Some(burst) if nth % 20 == 1 || nth + 1 == seqs.len() => object! { "burst" => burst },
                _ => no_result(),
            }
        };
        let entries = seqs.iter().enumerate().map(report).collect();
        cases.push(
            Case::new(
                format!("burst/lasting/ref-loss-{ref_loss}/threshold-{threshold}"),
                &["NCP-RES-046", "NCP-RES-049"],
                &BOTH,
            )
            .call("link.run", args(Some(ref_loss), Some(threshold), &seqs))
            .shows(steps(entries))
            .title(format!(
                "Under a reference loss of {ref_loss} and a threshold of {threshold} a burst of {gap} lost frames \
                 lasts as long as the sum says, over {frames} frames."
            ))
            .flags(&["burst-detector"])
            .because(
                "Each delivery takes the reference loss off the sum, and nothing else does: the burst is true exactly \
                 while the sum is above the threshold.",
            ),
        );
    }
    cases
}

/// Seqs that agree in their lowest bits with one that is missing.
fn alike() -> Vec<Case> {
    let mut cases = Vec::new();
    for bits in [8_u32, 10, 12, 16] {
        let far = 1_i64 << bits;
        // The second seq is missing; a duplicate above it looks like it, and below it one of the first.
        let above = vec![1, 3, 2 + far, 2 + far, 3 + far];
        let below = vec![4, 5, 3 + far, 5 + far, 5, 4, 6 + far];
        for (name, seqs) in [("above", above), ("below", below)] {
            cases.push(
                usual(&format!("count/alike/{name}-by-2-to-{bits}"), &["NCP-RES-042", "NCP-RES-040"], &seqs)
                    .title(format!("A duplicate that lies 2^{bits} {name} a missing seq takes nothing back."))
                    .flags(&["wrong-loss"])
                    .because("A duplicate changes nothing: a frame is late when its own seq is remembered as missing."),
            );
        }
        if bits > 12 {
            continue;
        }
        // Both are missing, and each is taken back when it comes, once. The last leaves no more than 4,096 missing.
        let both = vec![1, 3, 3 + far, 2 + far, 2, 2 + far, 2, 4 + far];
        cases.push(
            usual(&format!("count/alike/both-by-2-to-{bits}"), &["NCP-RES-041", "NCP-RES-042"], &both)
                .title(format!("Of two missing seqs that lie 2^{bits} apart each is taken back once."))
                .flags(&["wrong-loss"])
                .because("A late frame is taken back from `lost`, and a duplicate changes nothing."),
        );
    }
    cases
}

fn bounded() -> Vec<Case> {
    let mut cases = Vec::new();
    // With a tiny step, only the bound on the updates of one gap keeps the sum low.
    for gap in [1000, 100_000, 1_000_000_000] {
        let seqs = [1, 2 + gap];
        let entries = vec![no_result(), object! { "lost" => int(gap), "burst" => false }];
        cases.push(
            Case::new(format!("burst/bounded-{gap}"), &["NCP-RES-047"], &BOTH)
                .call("link.run", args(Some(0.99), Some(4.0), &seqs))
                .shows(steps(entries))
                .by("/steps/*/lost", "NCP-RES-040")
                .title(format!("One gap of {gap} makes at most 256 updates."))
                .flags(&["unbounded-work"])
                .because("256 updates of 0.01 are 2.56, which is not above a threshold of 4."),
        );
    }
    // And as many it makes: at a threshold that 256 are above, and 255 are not.
    for gap in [256, 257, 1000, 1_000_000_000] {
        let entries = vec![no_result(), object! { "lost" => int(gap), "burst" => true }];
        cases.push(
            Case::new(format!("burst/as-many-{gap}"), &["NCP-RES-047"], &BOTH)
                .call("link.run", args(Some(0.99), Some(1.565), &[1, 2 + gap]))
                .shows(steps(entries))
                .by("/steps/*/lost", "NCP-RES-040")
                .title(format!("One gap of {gap} makes 256 updates."))
                .flags(&["burst-detector"])
                .because("256 updates of 0.01 less the delivery's 0.99 are 1.57, which is above a threshold of 1.565."),
        );
    }
    cases
}

fn parameters() -> Vec<Case> {
    let mut cases = Vec::new();
    let seqs: Vec<i64> = [1, 2, 5, 6, 9, 13, 14, 24, 25, 26].to_vec();
    for (ref_loss, meant) in [
        (f64::NAN, 0.05),
        (f64::INFINITY, 0.05),
        (f64::NEG_INFINITY, 0.05),
        (-1.0, 0.0),
        (-1e308, 0.0),
        (-0.0, 0.0),
        (0.0, 0.0),
        (5e-324, 0.0),
        (0.25, 0.25),
        (0.5, 0.5),
        (0.99, 0.99),
        (1.0, 0.99),
        (2.0, 0.99),
        (1e308, 0.99),
    ] {
        for threshold in [5.0, 2.0] {
            cases.push(
                case(
                    format!("ref-loss/{}/threshold-{threshold}", name_of(ref_loss)),
                    &["NCP-RES-051"],
                    (Some(ref_loss), Some(threshold)),
                    (meant, threshold),
                    &seqs,
                )
                .title(format!(
                    "A reference loss of {} counts as {meant}, under a threshold of {threshold}.",
                    name_of(ref_loss)
                ))
                .because("`ref_loss` is clamped to 0 \u{2026} 0.99, and is 0.05 when it is not finite."),
            );
        }
    }
    // 250 misses add up to twice the threshold, 2, of which each delivery takes 0.99.
    for ref_loss in [0.99, 1.0, 2.0, f64::MAX] {
        let burst = |burst: bool| object! { "burst" => burst };
        cases.push(
            Case::new(format!("ref-loss/{}/deliveries", name_of(ref_loss)), &["NCP-RES-051", "NCP-RES-046"], &BOTH)
                .call("link.run", args(Some(ref_loss), Some(1.0), &[1, 252, 253, 254]))
                .shows(steps(vec![no_result(), burst(true), burst(false), burst(false)]))
                .title(format!("A delivery takes 0.99 off under a reference loss of {}.", name_of(ref_loss)))
                .flags(&["burst-detector"])
                .because("`ref_loss` is clamped to 0 \u{2026} 0.99, for what comes as for what is missing."),
        );
    }
    // A burst of which only the usual loss, taken off with each delivery, can tell how long it lasts.
    let clearing: Vec<i64> = std::iter::once(1).chain(8..40).collect();
    for ref_loss in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        cases.push(
            case(
                format!("ref-loss/{}/clears", name_of(ref_loss)),
                &["NCP-RES-051"],
                (Some(ref_loss), None),
                (0.05, 5.0),
                &clearing,
            )
            .title(format!("Under a reference loss of {} a burst clears as fast as under 0.05.", name_of(ref_loss)))
            .flags(&["burst-detector"])
            .because("`ref_loss` is 0.05 when it is not finite, and each delivery takes it off."),
        );
    }
    for (threshold, meant) in [
        (f64::NAN, 5.0),
        (f64::INFINITY, 5.0),
        (f64::NEG_INFINITY, 5.0),
        (0.0, 5.0),
        (-0.0, 5.0),
        (-1.0, 5.0),
        (-1e308, 5.0),
        (-5e-324, 5.0),
        (0.5, 0.5),
        (1.5, 1.5),
        (5.0, 5.0),
        (50.0, 50.0),
        (1e308, 1e308),
    ] {
        let gap: Vec<i64> = [1, 2, 4, 5, 12, 13, 14, 100, 101].to_vec();
        cases.push(
            case(
                format!("threshold/{}", name_of(threshold)),
                &["NCP-RES-052"],
                (None, Some(threshold)),
                (0.05, meant),
                &gap,
            )
            .title(format!("A threshold of {} counts as {meant}.", name_of(threshold)))
            .because("A threshold that is not finite or not positive is 5."),
        );
    }
    cases
}

/// Frames from before the first whose seq is a missing one less such a number: a monitor that keeps a part of the seq
/// alone takes them for it.
fn alike_from_before() -> Vec<Case> {
    let mut cases = Vec::new();
    let table: [(&str, i64); 12] = [
        ("64", 64),
        ("256", 256),
        ("1000", 1000),
        ("1024", 1024),
        ("4095", 4095),
        ("4096", 4096),
        ("4097", 4097),
        ("8192", 8192),
        ("65536", 65_536),
        ("2-to-24", 1 << 24),
        ("2-to-31", 1 << 31),
        ("2-to-32", 1 << 32),
    ];
    for (name, by) in table {
        let first = by + 3;
        cases.push(
            usual(
                &format!("alias/{name}"),
                &["NCP-RES-042", "NCP-RES-041", "NCP-RES-043"],
                &[first, first + 2, first + 1 - by, first + 3, first + 1],
            )
            .title(format!(
                "A frame from before the first, whose seq is that of a missing one less {by}, takes nothing back."
            ))
            .flags(&["wrong-loss"])
            .because("Only what is missing is late; a duplicate changes nothing, and the missing one stays missing."),
        );
    }
    cases
}

/// Missing seqs that lie as far apart as a table of them may be long, and none of them forgotten: all gaps together
/// are at most 4,096 seqs.
fn spans() -> Vec<Case> {
    let mut cases = Vec::new();
    for first in [0_i64, -4_100, (1 << 31) - 2_050, (1 << 32) - 2_050, (1 << 53) - 4_200] {
        for span in [1_024_i64, 2_048, 4_095, 4_096, 4_097] {
            // At another beginning than 0, the one at which a ring of the usual length is full.
            if first != 0 && span != 4_096 {
                continue;
            }
            let old = first + 1;
            let new = old + span;
            // Every sixteenth of the way a delivery, and so a few seqs less missing than it is long.
            let mut seqs = vec![first, old + 1];
            seqs.extend((1..16).map(|nth| old + 1 + nth * (span - 3) / 16));
            seqs.extend([new - 1, new + 1]);
            let missing = new + 1 - first + 1 - i64::try_from(seqs.len()).unwrap_or_default();
            for (order, late) in [("old-first", [old, new]), ("new-first", [new, old])] {
                if order == "new-first" && (first != 0 || span != 4_096) {
                    continue;
                }
                let seqs: Vec<i64> = seqs.iter().copied().chain(late).collect();
                let mut entries: Vec<Json> = seqs.iter().map(|_| no_result()).collect();
                let all = i64::try_from(seqs.len()).unwrap_or_default();
                for (entry, lost) in entries.iter_mut().rev().zip([missing - 2, missing - 1]) {
                    *entry = object! { "lost" => int(lost), "received" => int(all - (lost - (missing - 2))) };
                }
                cases.push(
                    Case::new(
                        format!("span/{span}/from-{first}/{order}").replace("from--", "from-minus-"),
                        &["NCP-RES-056", "NCP-RES-041"],
                        &BOTH,
                    )
                    .call("link.run", args(None, None, &seqs))
                    .shows(steps(entries))
                    .title(format!(
                        "Of {missing} missing frames from {first} on, two that lie {span} apart are both taken back \
                         ({}).",
                        order.replace('-', " ")
                    ))
                    .flags(&["wrong-loss"])
                    .because("While no more than 4,096 seqs are missing, the monitor remembers each of them."),
                );
            }
        }
    }
    cases
}

/// Missing seqs that lie as far apart as a larger table would be long, with nothing else missing between them.
fn far_apart() -> Case {
    let missing = [1, 1 + (1 << 13), 1 + (1 << 14), 1 + (1 << 15), 1 + (1 << 16)];
    let arrive = (0..=missing[4] + 1).filter(|seq| !missing.contains(seq));
    let seqs: Vec<i64> = arrive.chain(missing).collect();
    let mut entries: Vec<Json> = seqs.iter().map(|_| no_result()).collect();
    for (entry, lost) in entries.iter_mut().rev().zip(0..5) {
        *entry = object! { "lost" => int(lost) };
    }
    Case::new("span/powers-of-two", &["NCP-RES-056", "NCP-RES-041"], &BOTH)
        .call("link.run", args(None, None, &seqs))
        .shows(steps(entries))
        .title("Of five missing frames that lie powers of two up to 65,536 apart each is taken back.")
        .flags(&["wrong-loss"])
        .because("While no more than 4,096 seqs are missing, the monitor remembers each of them, however far apart.")
}

/// The frame behind the `nth` gap of 4,000, the first of which follows seq 2, and then what was missing.
fn came_late(nth: i64) -> impl Iterator<Item = i64> {
    let before = 2 + nth * 4_001;
    [before + 4_001].into_iter().chain(before + 1..=before + 4_000)
}

/// Seqs from end to end: the count of what is lost is exact up to where it may saturate.
fn extremes() -> Vec<Case> {
    let most = 9_007_199_254_740_991_i64;
    let mut cases = Vec::new();
    for (name, seqs) in [
        ("from-end-to-end", vec![-most, most]),
        ("from-minus-one", vec![-1, most]),
        ("from-zero", vec![0, most]),
        ("from-one", vec![1, most]),
        ("to-zero", vec![-most, 0]),
        ("to-one", vec![-most, 1]),
    ] {
        let (from, to) = (seqs.first().copied().unwrap_or_default(), seqs.last().copied().unwrap_or_default());
        let lost = to - from - 1;
        let big = object! {
            "last_seq" => int(to),
            "received" => int(2),
            "lost" => if lost > most { within(most as f64, 2e19) } else { int(lost) },
            "loss_rate" => within(0.999, 1.0),
            "burst" => true,
        };
        let entry = |seq: i64| {
            object! { "last_seq" => int(seq), "received" => int(1), "lost" => int(0),
            "loss_rate" => int(0), "burst" => false }
        };
        let first = seqs.first().copied().unwrap_or_default();
        cases.push(
            Case::new(format!("extreme/{name}"), &["NCP-RES-050", "NCP-RES-045"], &BOTH)
                .call("link.run", args(None, None, &seqs))
                .shows(steps(vec![entry(first), big]))
                .by("/steps/*/loss_rate", "NCP-RES-044")
                .title(format!(
                    "A gap from {first} to the other end overflows nothing and is a burst ({}).",
                    name.replace('-', " ")
                ))
                .flags(&["L09"])
                .because("A gap between any two seqs does not overflow: counts saturate, and the burst still trips."),
        );
        // And back again: duplicates or late ones, but never a step back.
        let back = [seqs.clone(), vec![first, first + 1, first]].concat();
        let last = seqs.last().copied().unwrap_or_default();
        let after = || object! { "loss_rate" => within(0.999, 1.0), "burst" => true };
        cases.push(
            Case::new(format!("extreme/{name}/and-back"), &["NCP-RES-043", "NCP-RES-050"], &BOTH)
                .call("link.run", args(None, None, &back))
                .shows(steps(vec![entry(first), after().with("last_seq", int(last)), after(), after(), after()]))
                .by("/steps/*/loss_rate", "NCP-RES-044")
                .title(format!(
                    "After a gap from {first} to the other end, nothing leads back ({}).",
                    name.replace('-', " ")
                ))
                .flags(&["L09"])
                .because("The expected seq only moves forward, and a seq from before stays late or a duplicate."),
        );
    }
    // What is lost leaves the integers of the wire, and so does what was expected: their quotient does not.
    for (name, seqs) in
        [("from-the-least", vec![-most, most - 991, most - 990]), ("by-halves", vec![-most, -1, 0, most - 1, most])]
    {
        let entries = seqs.iter().map(|_| object! { "loss_rate" => within(0.0, 1.0) }).collect();
        cases.push(
            Case::new(format!("extreme/rate/{name}"), &["NCP-RES-045", "NCP-RES-044", "NCP-RES-050"], &BOTH)
                .call("link.run", args(None, None, &seqs))
                .shows(steps(entries))
                .title(format!(
                    "The loss rate stays within 0 and 1 where the counts saturate ({}).",
                    name.replace('-', " ")
                ))
                .flags(&["L09"])
                .because("`loss_rate` stays within 0 and 1, whatever the counts do."),
        );
    }
    // The rate of nearly all is below 1, also where single precision takes what was expected for less.
    for last in [33_554_435_i64, 67_108_867, 4_294_967_301] {
        cases.push(
            Case::new(format!("extreme/rate/{last}"), &["NCP-RES-045", "NCP-RES-044"], &BOTH)
                .call("link.run", args(None, None, &[1, last]))
                .shows(steps(vec![no_result(), object! { "loss_rate" => within(0.999_999, 1.0) }]))
                .title(format!("Where all between 1 and {last} are lost, the loss rate is at most 1."))
                .flags(&["wrong-loss"])
                .because("The loss rate is lost / (expected \u{2212} first), and always within 0 and 1."),
        );
    }
    // Late frames of so many lost ones that the count is at its end. What they take off that count is its own affair,
    // and so is whether they count at all: of so many that are missing, any may be forgotten.
    let rate = || object! { "loss_rate" => within(0.999, 1.0) };
    cases.push(
        Case::new("extreme/late-at-the-end", &["NCP-RES-050", "NCP-RES-044"], &BOTH)
            .call("link.run", args(None, None, &[-most, most, most - 1, most - 2]))
            .shows(steps(vec![no_result(), rate().with("received", int(2)), rate(), rate()]))
            .title("Behind a gap from end to end, two late frames leave the loss rate at 1.")
            .flags(&["L09"])
            .because("The rate is that of the counts as they would be without saturation: 2^54 less 2 of as many."),
    );
    for last in [most, most - 1] {
        cases.push(
            usual(
                &format!("extreme/at-the-end/{}", most - last),
                &["NCP-RES-043", "NCP-RES-050"],
                &[last - 2, last - 1, last, last, last - 1],
            )
            .title(format!("Frames up to the seq {last} are counted like any others."))
            .flags(&["L09"])
            .because("Nothing overflows at the largest seq of the wire."),
        );
    }
    // Only what stands after the last frame is asked.
    let mut at_last = |name: &str, rules: &[&'static str], seqs: Vec<i64>, last: Json, flag, title: &str, why| {
        let mut entries: Vec<Json> = seqs.iter().map(|_| no_result()).collect();
        entries.pop();
        entries.push(last);
        cases.push(
            Case::new(name, rules, &BOTH)
                .call("link.run", args(None, None, &seqs))
                .shows(steps(entries))
                .title(title)
                .flags(&[flag])
                .because(why),
        );
    };
    const REMEMBERS: &str = "While no more than 4,096 seqs are missing, the monitor remembers each of them.";
    // As many missing as have to be remembered: all of them are taken back, the oldest last.
    at_last(
        "extreme/remembers",
        &["NCP-RES-056", "NCP-RES-041"],
        [0, 4_097].into_iter().chain((1..=4_096).rev()).collect(),
        object! { "lost" => int(0), "received" => int(4_098) },
        "wrong-loss",
        "Of 4,096 missing frames that all come late, each is taken back.",
        REMEMBERS,
    );
    // Two missing, and then a long time nothing else: both are taken back for all that.
    at_last(
        "extreme/remembers-for-long",
        &["NCP-RES-056", "NCP-RES-041"],
        [0, 3].into_iter().chain(4..=4_300).chain([2, 1]).collect(),
        object! { "lost" => int(0), "received" => int(4_301) },
        "wrong-loss",
        "Two missing frames that come 4,300 frames late are taken back.",
        REMEMBERS,
    );
    // As many frames as 16 bits count, and the one that is missing when they all have come.
    at_last(
        "extreme/received/65536",
        &["NCP-RES-050", "NCP-RES-041"],
        (0..65_536).collect(),
        object! { "lost" => int(0), "received" => int(65_536) },
        "wrong-loss",
        "Of 65,536 frames each is counted as received.",
        "Counts saturate at 2^53 \u{2212} 1 or above it, and do not begin again.",
    );
    at_last(
        "extreme/remembers-for-65536",
        &["NCP-RES-056", "NCP-RES-041"],
        [0].into_iter().chain(2..=65_537).chain([1]).collect(),
        object! { "lost" => int(0) },
        "wrong-loss",
        "A missing frame that comes 65,536 frames late is taken back.",
        REMEMBERS,
    );
    // Hardly fewer missing than may be, and far behind.
    at_last(
        "extreme/remembers-far-back",
        &["NCP-RES-056", "NCP-RES-041"],
        [0, 3, 4_050].into_iter().chain(4_051..=8_300).chain([2, 1, 4_049]).collect(),
        object! { "lost" => int(4_045), "received" => int(4_256) },
        "wrong-loss",
        "Of 4,048 missing frames two that come 8,298 seqs late are taken back.",
        REMEMBERS,
    );
    // More missing in all than have to be remembered, and never so many at a time.
    for (name, seqs, lost, words) in [
        ("one-came", vec![0, 4_097, 4_096, 4_099, 1], 4_095, "one of the last came late"),
        ("first-gap-came", vec![0, 3, 2, 4_099, 1], 4_095, "one of an early gap came late"),
        (
            "many-came",
            [0, 101].into_iter().chain((2..=100).rev()).chain([4_196, 1, 4_197]).collect(),
            4_094,
            "a hundred early ones came late",
        ),
        (
            "came-and-again",
            [0, 2_049].into_iter().chain((2_019..2_049).rev()).chain([4_127, 1, 2, 4_126]).collect(),
            4_092,
            "thirty came late before the next gap",
        ),
        (
            "five-times-as-many-came",
            [0, 2].into_iter().chain((0..5).flat_map(came_late)).chain([1]).collect(),
            0,
            "five gaps of 4,000 came late, one behind the other",
        ),
    ] {
        let received = i64::try_from(seqs.len()).unwrap_or_default();
        at_last(
            &format!("extreme/remembers-though/{name}"),
            &["NCP-RES-056", "NCP-RES-041"],
            seqs,
            object! { "lost" => int(lost), "received" => int(received) },
            "wrong-loss",
            &format!("Where {words}, no more than 4,096 are missing at a time, and the oldest is taken back."),
            "Rule 56 counts the seqs that are missing at that time: one that came late is missing no longer.",
        );
    }
    // The same order again and again; of the last frame that is asked about, the oldest that is missing.
    let rounds = |times: i64, by: i64, round: &[i64], then: &[i64]| -> Vec<i64> {
        let seqs = (0..times).flat_map(|nth| round.iter().map(move |seq| by * nth + seq));
        std::iter::once(0).chain(seqs).chain(then.iter().map(|seq| by * times + seq)).collect()
    };
    for (name, seqs, lost, words) in [
        ("swapped", rounds(5_000, 2, &[2, 1], &[2, 1]), 0, "5,000 pairs that come in the other order"),
        ("late-by-three", rounds(3_000, 4, &[4, 1, 2, 3], &[2, 1]), 0, "3,000 frames that overtake three others"),
        ("gaps", rounds(3_000, 3, &[3, 1], &[2, 1, 2 - 9_000]), 2_999, "3,000 gaps of two of which one comes late"),
    ] {
        let received = i64::try_from(seqs.len()).unwrap_or_default();
        at_last(
            &format!("extreme/endures/{name}"),
            &["NCP-RES-041", "NCP-RES-056"],
            seqs,
            object! { "lost" => int(lost), "received" => int(received) },
            "wrong-loss",
            &format!("Behind {words}, a missing frame is taken back as before."),
            REMEMBERS,
        );
    }
    // More missing than may be remembered: not all of them can be taken back.
    at_last(
        "extreme/memory",
        &["NCP-RES-048"],
        [0, 4_201].into_iter().chain(1..=4_200).collect(),
        object! { "lost" => within(104.0, 4200.0) },
        "unbounded-work",
        "Of 4,200 missing frames that all come late, at most 4,096 are taken back.",
        "The monitor remembers at most 4,096 missing seqs; what it forgot is a duplicate when it comes.",
    );
    at_last(
        "extreme/forgets",
        &["NCP-RES-057"],
        [0, 4_201].into_iter().chain(105..=4_200).collect(),
        object! { "lost" => int(104) },
        "wrong-loss",
        "Of 4,200 missing frames the 4,096 newest should be remembered.",
        "Of more missing seqs than it remembers, the monitor should forget the lowest first.",
    );
    cases
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_case_of_a_burst_that_ends_says_when_there_is_one_and_when_there_is_none() {
        for case in small_losses().iter().chain(&relapses()) {
            let expect = case.expect.text();
            for burst in ["\"burst\":true", "\"burst\":false"] {
                assert!(expect.contains(burst), "{} lacks {burst}", case.path);
            }
        }
    }
}
