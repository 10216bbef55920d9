//! Traces of a plant: its watchdog, its buffer, its link monitor.

use ncp_text::WIRE_VERSION;

use super::corrupt::{corrupted, wild};
use super::frames::base64;
use super::safety::{Shapes, command};
use super::{Draw, Menu, Tree, steps};
use crate::fuzz::tree::{int, list, literal, num, object, set, spelled, text};
use crate::json::{Json, write_string};

/// The clock of a trace: mostly forward, in steps that meet deadlines.
pub(super) struct Clock {
    pub(super) now: f64,
    /// How often it steps back or is no number, of a hundred.
    odd: u64,
    /// Whether it ticks in fractions that doubles hold exactly.
    exact: bool,
    /// Into how many readings it cuts the time up to a moment that counts, if it does so: then nothing ends before.
    patience: Option<i64>,
    /// What it read last that is no number, and may read again.
    stuck: Option<f64>,
}

/// After so many seconds a clock of some width begins anew: of milliseconds, microseconds or nanoseconds, or in single
/// precision.
pub(super) const WRAPS: [f64; 11] = [
    65.536,
    2_147.483_648,
    4_294.967_296,
    2_147_483.648,
    4_294_967.296,
    2.147_483_648,
    4.294_967_296,
    16_777.216,
    2_147_483_648.0,
    4_294_967_296.0,
    9_007_199_254.740_992,
];

impl Clock {
    pub(super) fn draw(draw: &mut Draw<'_>) -> Self {
        let now = draw.one(&[0.0, 1.0, 10.0, 1000.0, -5.0, -1.0, 1e6, 1.7e9, 4_503_599_627_370_496.0]);
        // A decimal whose milliseconds round, though the differences of such times may not.
        let now = if draw.chance(20) { draw.range(0, 400) as f64 / 100.0 } else { now };
        // Near where a narrow one wraps.
        let now = if draw.chance(12) { draw.one(&WRAPS) - draw.range(1, 64) as f64 / 64.0 } else { now };
        let patience = if draw.chance(12) { Some(draw.one(&[3, 9, 13, 45, 99])) } else { None };
        Self { now, odd: draw.one(&[0, 0, 5]), exact: draw.chance(80), patience, stuck: None }
    }

    /// A later time: `span` after a moment that counts, or just before or behind that.
    pub(super) fn tick(&mut self, from: f64, span_ms: f64, draw: &mut Draw<'_>) -> f64 {
        if draw.chance(self.odd) {
            return match draw.below(4) {
                0 => {
                    let strange = self.stuck.filter(|_| draw.chance(60)).unwrap_or_else(|| draw.strange());
                    self.stuck = Some(strange);
                    strange
                }
                1 => {
                    self.now = from - 1.0;
                    self.now
                }
                _ => from.next_down(),
            };
        }
        let span = if span_ms.is_finite() { (span_ms / 1000.0).clamp(0.0, 1e5) } else { 1.0 };
        if let Some(readings) = self.patience.filter(|_| draw.chance(97)) {
            let next = self.now + span / (readings as f64 + 0.3);
            self.now = if next < from + span { next.max(self.now) } else { self.now.max(from + span) };
            return self.now;
        }
        let next = match draw.below(10) {
            8 => from + span + draw.little().abs() / 10.0,
            9 => from + span - draw.little().abs() / 10.0,
            0 => from + span,
            1 => (from + span).next_up(),
            2 => (from + span).next_down(),
            3 => from + span * 2.0,
            4 => self.now,
            5 => self.now + span / 2.0,
            _ => self.now + if self.exact { 0.0625 } else { draw.share() },
        };
        if next.is_finite() && next >= self.now {
            self.now = next;
        }
        self.now
    }
}

/// The next seq of a stream.
pub(super) fn next_seq(last: i64, draw: &mut Draw<'_>) -> i64 {
    match draw.below(16) {
        0 => last,
        1 => last - 1,
        2 => 0,
        3 => draw.integer(),
        4 => last + draw.range(2, 300),
        5 => -last,
        _ => last + 1,
    }
    .clamp(-crate::fuzz::draw::LARGEST, crate::fuzz::draw::LARGEST)
}

fn ttl(draw: &mut Draw<'_>) -> f64 {
    match draw.below(8) {
        0 => draw.finite(),
        1 => draw.one(&[0.0, -1.0, 5e-324, 60_000.0, 60_001.0, 59_999.0, 1e9]),
        2 => draw.positive(),
        _ => draw.one(&[50.0, 62.5, 125.0, 200.0, 250.0, 500.0]),
    }
}

/// The arguments of `watchdog.run`.
pub(super) fn watchdog(draw: &mut Draw<'_>) -> Tree {
    let count = steps(draw, 10_000);
    let (commands, resets) = (draw.one(&[1, 10, 30, 60]), draw.one(&[0, 0, 3, 30]));
    let mut clock = Clock::draw(draw);
    let (mut last, mut received, mut span) = (draw.range(0, 9), clock.now, 200.0);
    let steps = (0..count).map(|nth| {
        if draw.chance(resets) {
            return object([("op", text("reset"))]);
        }
        if nth > 0 && !draw.chance(commands) {
            let now = clock.tick(received, span, draw);
            return object([("op", text("should_hold")), ("now_s", num(now))]);
        }
        let now = clock.tick(received, span, draw);
        last = next_seq(last, draw);
        (received, span) = (now, ttl(draw));
        object([("op", text("command")), ("now_s", num(now)), ("ttl_ms", num(span)), ("seq", int(last))])
    });
    object([("steps", list(steps.collect()))])
}

/// The arguments of `buffer.run`.
pub(super) fn buffer(menu: &Menu, draw: &mut Draw<'_>) -> Tree {
    let count = steps(draw, 4000);
    let mut shapes = Shapes::draw(draw);
    let (commands, resets, odd) = (draw.one(&[2, 15, 40, 60]), draw.one(&[0, 0, 4]), draw.one(&[0, 0, 10, 40]));
    let estops = draw.one(&[0, 0, 2, 10]);
    let mut steps_of = 0;
    let mut clock = Clock::draw(draw);
    let (mut last, mut received, mut span, mut tick) = (draw.range(0, 3), clock.now, 200.0, 0.0);
    let strict = menu.strict && draw.chance(25);
    let steps = (0..count).map(|nth| {
        if draw.chance(resets) {
            return object([("op", text("reset"))]);
        }
        if nth > 0 && !draw.chance(commands) {
            let span = match draw.below(10) {
                0..=3 if tick > 0.0 => tick * draw.range(0, 6) as f64,
                4 | 5 if tick > 0.0 => tick * draw.size(0, steps_of + 1) as f64,
                _ => span,
            };
            let now = clock.tick(received, span, draw);
            return object([("op", text("active")), ("now_s", num(now))]);
        }
        let now = clock.tick(received, span, draw);
        last = next_seq(last, draw);
        let mut frame = command(&mut shapes, last, draw);
        set(&mut frame, "kind", text("command_frame"));
        set(&mut frame, "ncp_version", text(WIRE_VERSION));
        if draw.chance(estops) {
            set(&mut frame, "mode", text("estop"));
        }
        in_wire_form(&mut frame);
        received = now;
        span = crate::fuzz::tree::double(frame.get("ttl_ms")).unwrap_or(200.0);
        tick = crate::fuzz::tree::double(frame.get("horizon_dt_ms")).unwrap_or(0.0);
        steps_of = crate::fuzz::tree::items(frame.get("horizon")).len();
        let frame = if draw.chance(odd) { odd_frame(&frame, draw) } else { text(frame.to_string()) };
        let name = if matches!(&frame, Json::Object(_)) { "base64" } else { "text" };
        let frame = frame.get("base64").cloned().unwrap_or(frame);
        object([("op", text("command")), (name, frame), ("now_s", num(now))])
    });
    let mut args = object([("steps", list(steps.collect()))]);
    if strict {
        set(&mut args, "strict", Json::Bool(true));
    }
    args
}

/// A frame has no words for numbers that JSON lacks, and spells the negative zero as one.
fn in_wire_form(frame: &mut Tree) {
    match frame {
        Json::Array(items) => items.iter_mut().for_each(in_wire_form),
        Json::Object(members) => members.iter_mut().for_each(|(_, value)| in_wire_form(value)),
        Json::String(word) => match word.as_ref() {
            "NaN" | "Infinity" | "-Infinity" => *frame = spelled(1.0),
            "-0" => *frame = spelled(-0.0),
            _ => {}
        },
        _ => {}
    }
}

/// A command frame that is malformed, strange, or an ESTOP in hiding.
fn odd_frame(frame: &Tree, draw: &mut Draw<'_>) -> Tree {
    let mut frame = frame.clone();
    let written = match draw.below(15) {
        // An ESTOP, or another command, that is wrong in any way that a frame can be.
        12..=14 => {
            if draw.chance(70) {
                set(&mut frame, "mode", text("estop"));
            }
            match String::from_utf8(corrupted(&frame, draw)) {
                Ok(written) => written,
                Err(error) => return object([("base64", base64(error.as_bytes()))]),
            }
        }
        0 => {
            set(&mut frame, "seq", literal(draw.pick(&["1.0", "-0", "1e0", "9007199254740992"])));
            frame.to_string()
        }
        1 => {
            set(
                &mut frame,
                "kind",
                text(if draw.chance(60) {
                    draw.nearly("command_frame")
                } else {
                    draw.pick(&["sensor_frame", "estop"]).to_owned()
                }),
            );
            set(&mut frame, "mode", text("estop"));
            frame.to_string()
        }
        2 => {
            // An ESTOP in a frame that no receiver reads.
            set(&mut frame, "mode", text("estop"));
            let (name, value) = draw.one(&[
                ("seq", "\"7\""),
                ("ttl_ms", "null"),
                ("channels", "[]"),
                ("horizon", "7"),
                ("t", "\"x\""),
                ("ncp_version", "\"0.4\""),
                ("frame_id", "1e400"),
            ]);
            set(&mut frame, name, Json::parse(value).map_or(Json::Null, |value| crate::fuzz::tree::own(&value)));
            frame.to_string()
        }
        3 => {
            // Twice, of which one stops.
            let modes = draw.one(&[("active", "estop"), ("estop", "active"), ("hold", "estop")]);
            set(&mut frame, "mode", text(modes.0));
            let mut written = frame.to_string();
            for mode in [modes.1, "hold", "active"].into_iter().take(1 + draw.below(3)) {
                let key = draw.pick(&["mode", "m\\u006fde", "\\u006Dode"]);
                written = format!("{},\"{key}\":\"{mode}\"}}", &written[..written.len() - 1]);
            }
            written
        }
        4 => {
            // Not at the top, or not a mode.
            set(&mut frame, "x", object([("mode", text("estop"))]));
            set(&mut frame, "frame_id", text("estop"));
            frame.to_string()
        }
        5 => {
            set(
                &mut frame,
                "mode",
                text(if draw.chance(80) { draw.nearly("estop") } else { draw.pick(&["e\u{301}stop", ""]).to_owned() }),
            );
            frame.to_string()
        }
        6 => {
            // Between much that nobody reads.
            let filler = if draw.chance(70) { draw.size(1_000, 70_000) } else { 200_000 };
            set(&mut frame, "mode", text("estop"));
            let mut padding = String::new();
            write_string(&"[".repeat(filler), &mut padding);
            let written = frame.to_string();
            let bad = draw.pick(&["", ",\"seq\":1.5"]);
            format!("{{\"x\":{padding},{}{bad}}}", &written[1..written.len() - 1])
        }
        7 => {
            let depth = if draw.chance(50) { draw.one(&[10, 63, 64, 100]) } else { draw.size(1, 5000) };
            set(&mut frame, "mode", text("estop"));
            let mut written = frame.to_string();
            // Taken back at the end, which a reader that counts levels might not come to.
            if draw.chance(30) {
                let back = draw.pick(&["\"mode\":\"active\"", "\"kind\":\"link_status\"", "\"mode\":\"hold\""]);
                written = format!("{},{back}}}", &written[..written.len() - 1]);
            }
            let before = draw.pick(&["\\\"", "]", "\\\\", "}"]);
            format!("{{\"y\":\"{before}[\",\"x\":{}{},{}", "[".repeat(depth), "]".repeat(depth), &written[1..])
        }
        8 if draw.chance(60) => {
            // As strangely as the grammar allows, and wrong in one member.
            set(&mut frame, "mode", text("estop"));
            set(&mut frame, "seq", text("7"));
            wild(&frame, draw)
        }
        8 => {
            set(&mut frame, "mode", Json::Null);
            frame.to_string()
        }
        9 => {
            if let Json::Object(members) = &mut frame {
                members.retain(|(name, _)| name != "mode");
            }
            frame.to_string()
        }
        10 => {
            set(&mut frame, "ncp_version", text(draw.pick(&["0.4", "1.0", "x", ""])));
            frame.to_string()
        }
        _ => {
            let bytes = frame.to_string().into_bytes();
            let bytes = [&b"{\"z\":\"\xff\","[..], &bytes[1..]].concat();
            return object([("base64", base64(&bytes))]);
        }
    };
    text(written)
}

/// The arguments of `link.run`.
pub(super) fn link(draw: &mut Draw<'_>) -> Tree {
    let count = steps(draw, 10_000);
    let ref_loss =
        if draw.chance(50) { Json::Null } else { num(if draw.chance(60) { draw.share() } else { draw.double() }) };
    let threshold =
        if draw.chance(50) { Json::Null } else { num(if draw.chance(60) { draw.positive() } else { draw.double() }) };
    // Of a burst of thousands.
    let threshold = if draw.chance(8) { num(draw.size(16, 1 << 20) as f64 + 0.5) } else { threshold };
    // Or so that one loss makes a burst, which few deliveries of a small usual loss end.
    let is_small = draw.chance(10);
    let (ref_loss, threshold) = if is_small {
        let small = 10_f64.powf(-8.0 * draw.share());
        (num(small), num(1.0 - small * (draw.range(1, 20) as f64 + 0.5)))
    } else {
        (ref_loss, threshold)
    };
    let (gaps, late, wide) = (draw.one(&[0, 5, 40]), draw.one(&[0, 5, 40]), draw.one(&[0, 0, 10]));
    let (gaps, late, wide) = if is_small { (1, 0, 0) } else { (gaps, late, wide) };
    let mut next = if draw.chance(80) { draw.range(0, 3) } else { draw.integer() };
    let most = draw.one(&[16, 5000, 5000, 1 << 20]);
    let largest = crate::fuzz::draw::LARGEST;
    // A gap as wide as what a monitor has to remember, out of which some come late, in any order.
    let gap = if !is_small && draw.chance(10) { draw.range(4000, 4100) } else { 0 };
    let first = next.clamp(1, 1 << 50);
    // Every second one is lost, for long.
    let is_sparse = gap == 0 && !is_small && draw.length().is_none() && draw.chance(6);
    let count = if is_sparse { count.max(draw.size(40, 5000)) } else { count };
    let steps = (0..count).map(|nth| {
        if is_sparse && draw.chance(99) {
            next = next.saturating_add(1);
        }
        let seq = if gap > 0 && nth > 1 && draw.chance(60) {
            let far = if draw.chance(50) { gap } else { 8 };
            let back = draw.range(0, far);
            first + if draw.chance(50) { back } else { gap - back }
        } else if gap > 0 && nth < 2 {
            first + if nth == 0 { 0 } else { gap }
        } else if draw.chance(late) {
            // Late, or what a narrow count takes for late.
            let power = if draw.chance(8) { 1_i64 << draw.one(&[8, 12, 15, 16, 24, 31, 32]) } else { 0 };
            next - draw.range(1, 12) + if draw.chance(50) { power } else { -power }
        } else if draw.chance(wide) {
            draw.integer()
        } else {
            if is_small && nth == 1 {
                next = next.saturating_add(1);
            } else if draw.chance(gaps) {
                next = next.saturating_add(i64::try_from(draw.size(1, most)).unwrap_or(1));
            }
            next
        };
        let seq = seq.clamp(-largest, largest);
        next = next.max(seq.saturating_add(1));
        object([("op", text("frame")), ("seq", int(seq))])
    });
    let steps = list(steps.collect());
    object([("ref_loss", ref_loss), ("threshold", threshold), ("steps", steps)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fuzz::harvest::Harvest;

    #[test]
    fn an_estop_is_wrong_in_its_grammar_in_its_members_and_in_its_bytes() {
        let harvest = Harvest::default();
        let frame = object([("kind", text("command_frame")), ("seq", int(7)), ("mode", text("active"))]);
        let (mut cut, mut bytes, mut halves) = (0, 0, 0);
        for number in 0..4000 {
            let odd = odd_frame(&frame, &mut Draw::new(3, number, &harvest));
            let Some(written) = odd.as_str() else {
                bytes += 1;
                continue;
            };
            let is_estop = written.contains("estop");
            cut += usize::from(is_estop && Json::parse(written).is_err());
            halves += usize::from(is_estop && written.contains("\\ud800"));
        }
        assert!(cut > 100 && bytes > 100 && halves > 5, "{cut} {bytes} {halves}");
    }

    #[test]
    fn a_burst_by_one_loss_ends_by_deliveries_and_wide_gaps_are_filled_late() {
        let harvest = Harvest::default();
        let (mut small, mut filled) = (0, 0);
        for number in 0..600 {
            let args = link(&mut Draw::new(3, number, &harvest));
            let of = |name: &str| crate::fuzz::tree::double(args.get(name)).unwrap_or(0.0);
            let (ref_loss, threshold) = (of("ref_loss"), of("threshold"));
            small += usize::from(ref_loss < 1e-4 && (1.0 - 21.0 * ref_loss..1.0).contains(&threshold));
            let seqs = crate::fuzz::tree::items(args.get("steps")).iter();
            let seqs: Vec<i64> = seqs.filter_map(|step| crate::fuzz::tree::integer(step.get("seq"))).collect();
            let is_wide = |pair: &[i64]| (4000..=4100).contains(&pair[1].saturating_sub(pair[0]));
            filled += usize::from(seqs.len() > 3 && is_wide(&seqs[..2]) && seqs[2..].iter().any(|seq| *seq < seqs[1]));
        }
        assert!(small > 5 && filled > 10, "{small} {filled}");
    }

    #[test]
    fn a_patient_clock_reads_often_before_the_moment_and_then_meets_it() {
        let harvest = Harvest::default();
        let (mut met, mut most) = (0, 0);
        for number in 0..400 {
            let mut draw = Draw::new(3, number, &harvest);
            let mut clock = Clock { now: 2.0, odd: 0, exact: false, patience: Some(45), stuck: None };
            let readings: Vec<f64> = (0..60).map(|_| clock.tick(2.0, 1000.0, &mut draw)).collect();
            let before = readings.iter().take_while(|now| **now < 3.0).count();
            met += usize::from(readings.get(before) == Some(&3.0));
            most = most.max(before);
        }
        assert!(met > 50 && most >= 45, "{met} {most}");
    }

    #[test]
    fn a_clock_begins_just_before_a_narrow_one_wraps_and_reads_the_same_strange_time_again() {
        let harvest = Harvest::default();
        let (mut wraps, mut again, mut pairs) = (0, 0, 0);
        for number in 0..2000 {
            let mut draw = Draw::new(3, number, &harvest);
            let mut clock = Clock::draw(&mut draw);
            // Those of hours and more, which no other clock comes near.
            let far = WRAPS.iter().filter(|wrap| **wrap > 2000.0);
            wraps += usize::from(far.clone().any(|wrap| *wrap > clock.now && *wrap - clock.now <= 1.0));
            clock.odd = 100;
            let read: Vec<f64> = (0..12).map(|_| clock.tick(1.0, 100.0, &mut draw)).collect();
            let strange: Vec<u64> = read.iter().filter(|now| !now.is_finite()).map(|now| now.to_bits()).collect();
            pairs += strange.len().saturating_sub(1);
            again += strange.windows(2).filter(|two| two[0] == two[1]).count();
        }
        // By chance alone it would be a third of them.
        assert!(wraps > 50 && 2 * again > pairs, "{wraps} {again} {pairs}");
    }
}
