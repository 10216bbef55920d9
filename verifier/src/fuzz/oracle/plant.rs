//! The freedoms of a plant: its watchdog, its buffer, its link monitor.

use std::cmp::Ordering;

use ncp_spec::resilience::{ActionBuffer, is_estop};
use ncp_spec::wire::{self, CommandFrame, Kind, Message, Mode};

use super::frames::{bytes, is_strict};
use super::open::{Freedom, freedom, is_object};
use super::{Outcome, Verdict, any, exact, exactly, fits, free, near, range, reject, steps};
use crate::fuzz::tree::{Tree, double, int, integer, items, object, set, string};
use crate::json::Json;

/// What is known of a plant, by the readings of the text.
#[derive(Debug, Default)]
struct Known {
    last_seq: Option<i64>,
    /// When the command was received that may be acted upon, and for how long, ms.
    held: Option<(f64, f64)>,
    clock: Option<f64>,
    /// It may hold instead, until a command advances.
    may_hold: bool,
    /// Nothing is known, until a command advances.
    unknown: bool,
    /// Nothing is known, until a reset.
    lost: bool,
}

impl Known {
    /// A clock that steps back is reason enough to hold.
    fn read(&mut self, now: f64) {
        if self.clock.is_some_and(|before| now < before) && self.held.is_some() {
            self.may_hold = true;
        }
        self.clock = Some(now);
    }

    fn advance(&mut self, seq: i64, now: f64, ttl: f64) -> bool {
        let advances = self.last_seq.is_none_or(|last| seq > last);
        if advances {
            self.last_seq = Some(seq);
            self.held = Some((now, ttl));
            (self.may_hold, self.unknown) = (false, false);
        }
        advances
    }

    /// Whether a rounding decides whether the time is over.
    fn look(&mut self, now: f64) {
        let Some((received, ttl)) = self.held else { return };
        let ttl = ttl.min(60_000.0);
        let is_time = ttl.is_finite() && ttl > 0.0 && now.is_finite() && received.is_finite() && received <= now;
        match exact::age(now, received, ttl) {
            _ if !is_time => self.held = None,
            Some(Ordering::Greater) => self.held = None,
            None => self.unknown = true,
            Some(_) => {}
        }
    }

    fn reset(&mut self) {
        *self = Self { clock: self.clock, ..Self::default() };
    }
}

pub(super) fn watchdog(args: &Tree, result: Outcome<'_>) -> Verdict {
    let result = match result {
        Ok(result) => result,
        Err(code) => return reject(code),
    };
    let mut known = Known::default();
    let mut entries = Vec::new();
    for (step, answer) in items(args.get("steps")).iter().zip(items(result.get("steps"))) {
        let now = double(step.get("now_s")).unwrap_or(f64::NAN);
        match string(step, "op") {
            Some("command") => {
                known.read(now);
                known.advance(
                    integer(step.get("seq")).unwrap_or(0),
                    now,
                    double(step.get("ttl_ms")).unwrap_or(f64::NAN),
                );
                entries.push(free());
            }
            Some("should_hold") => {
                known.read(now);
                known.look(now);
                let moves = answer.get("hold") == Some(&Json::Bool(false));
                entries.push(if known.unknown || known.may_hold && moves { free() } else { answer.clone() });
            }
            _ => {
                known.reset();
                entries.push(free());
            }
        }
    }
    fits(steps(entries))
}

/// Whether bytes hold something like a stop, spelled in whatever way.
fn mentions_estop(frame: &[u8]) -> bool {
    let holds = |wanted: &[u8]| frame.windows(wanted.len()).any(|window| window == wanted);
    holds(b"estop") || holds(b"\\u")
}

/// The horizon of the command that a buffer holds.
struct Horizon {
    dt: Option<f64>,
    steps: usize,
}

pub(super) fn buffer(args: &Tree, result: Outcome<'_>) -> Verdict {
    let result = match result {
        Ok(result) => result,
        Err(code) => return reject(code),
    };
    let strict = is_strict(args);
    let mut known = Known::default();
    let mut buffer = if strict { ActionBuffer::strict() } else { ActionBuffer::new() };
    let mut horizon = Horizon { dt: None, steps: 0 };
    let mut unstamped_first = false;
    let mut entries = Vec::new();
    for (step, answer) in items(args.get("steps")).iter().zip(items(result.get("steps"))) {
        let now = double(step.get("now_s")).unwrap_or(f64::NAN);
        match string(step, "op") {
            Some("command") => {
                known.read(now);
                let frame = bytes(step);
                arrives(&frame, now, strict, &mut known, &mut unstamped_first, &mut horizon);
                let _ = buffer.on_frame(&frame, now);
                entries.push(free());
            }
            Some("active") => {
                known.read(now);
                known.look(now);
                let latched = buffer.is_stopped();
                let _ = buffer.active(now);
                entries.push(active(answer, now, latched, &mut known, &horizon));
            }
            _ => {
                known.reset();
                buffer.reset();
                unstamped_first = false;
                entries.push(free());
            }
        }
    }
    fits(steps(entries))
}

/// What a frame that arrives leaves known.
fn arrives(frame: &[u8], now: f64, strict: bool, known: &mut Known, unstamped: &mut bool, horizon: &mut Horizon) {
    let stops = is_estop(frame);
    if mentions_estop(frame) && (!is_object(frame) || frame.len() > 1 << 20) {
        // Bytes that are no object, or too many of them: a plant may latch as well.
        known.lost = true;
    }
    let freedom = freedom("command_frame", frame, strict);
    if stops {
        return;
    }
    if freedom != Freedom::None {
        known.lost = true;
        return;
    }
    let read =
        if strict { wire::decode_strict(Kind::CommandFrame, frame) } else { wire::decode(Kind::CommandFrame, frame) };
    let Ok(Message::CommandFrame(command)) = read else {
        // It may hold on what it rejects; a strict plant leaves its buffer as it was.
        known.may_hold |= !strict;
        return;
    };
    follows(&command, now, strict, known, unstamped, horizon);
}

fn follows(
    command: &CommandFrame,
    now: f64,
    strict: bool,
    known: &mut Known,
    unstamped: &mut bool,
    horizon: &mut Horizon,
) {
    let seq = command.seq;
    let advances = known.last_seq.is_none_or(|last| seq > last);
    if *unstamped && advances && seq <= 0 && !strict {
        known.lost = true;
    }
    if strict && !advances {
        return;
    }
    if command.mode == Mode::Active {
        if known.advance(seq, now, command.ttl_ms) {
            *horizon = Horizon { dt: command.horizon_dt_ms, steps: command.horizon.len() };
        }
        return;
    }
    // The text leaves open whether such a HOLD advances the stream.
    if known.last_seq.is_none_or(|last| last < 0) && seq == 0 {
        *unstamped = true;
    }
    if advances || seq == 0 || known.last_seq == Some(seq) {
        known.held = None;
        (known.may_hold, known.unknown) = (false, false);
    } else {
        // An older HOLD may be dropped or obeyed.
        known.may_hold = true;
    }
    if advances && seq != 0 {
        known.last_seq = Some(seq);
    }
}

/// What a plant may answer that is asked what it does.
fn active(answer: &Tree, now: f64, latched: bool, known: &mut Known, horizon: &Horizon) -> Tree {
    let channels = answer.get("channels").filter(|channels| !channels.is_null());
    let usable = horizon.dt.filter(|dt| dt.is_finite() && *dt > 0.0);
    let mut may_hold = known.may_hold || horizon.steps > 0 && usable.is_none();
    if let (Some((received, _)), Some(dt), true) = (known.held, usable, horizon.steps > 0) {
        let tick = ((now - received) * 1000.0 / dt).round();
        // At the border of two ticks a rounding decides, and at the end of the last whether it goes on.
        if tick <= horizon.steps as f64 + 2.0 && exact::age(now, received, tick * dt).is_none()
            || tick > 0.0
                && !(dt * tick / tick == dt && tick.mul_add(dt, -(tick * dt)) == 0.0)
                && ((now - received) * 1000.0 - tick * dt).abs() <= 1e-9 * tick * dt
        {
            if tick >= horizon.steps as f64 {
                known.unknown = true;
            }
            if !latched {
                return free();
            }
        }
        if (now - received) * 1000.0 / dt >= horizon.steps as f64 + 1.0 && channels.is_none() {
            known.held = None;
        }
    }
    if known.lost || known.unknown {
        return free();
    }
    match channels {
        None => object([("channels", Json::Null)]),
        Some(channels) => {
            may_hold |= latched;
            let moves = exactly(channels.clone());
            object([("channels", if may_hold { any(vec![moves, Json::Null]) } else { moves })])
        }
    }
}

/// The detector by each reading of the text: whether a gap or its delivery counts first, and what a late frame is
/// worth.
pub(super) struct Detector {
    ref_loss: f64,
    threshold: f64,
    sums: [f64; 6],
    /// How many numbers were added to a sum, each of which may be rounded.
    added: f64,
}

impl Detector {
    pub(super) fn new(args: &Tree) -> Self {
        let ref_loss = double(args.get("ref_loss").filter(|loss| !loss.is_null())).unwrap_or(0.05);
        let threshold = double(args.get("threshold").filter(|threshold| !threshold.is_null())).unwrap_or(5.0);
        let ref_loss = if ref_loss.is_finite() { ref_loss.clamp(0.0, 0.99) } else { 0.05 };
        let threshold = if threshold.is_finite() && threshold > 0.0 { threshold } else { 5.0 };
        Self { ref_loss, threshold, sums: [0.0; 6], added: 0.0 }
    }

    pub(super) fn frame(&mut self, gap: u64, is_late: bool) {
        let cap = 2.0 * self.threshold;
        self.added += gap.min(256) as f64 + 1.0;
        let late = [-self.ref_loss, -1.0, 0.0];
        for (reading, sum) in self.sums.iter_mut().enumerate() {
            let mut add = |by: f64| *sum = (*sum + by).clamp(0.0, cap);
            let delivery_first = reading >= 3;
            if is_late {
                add(late[reading % 3]);
                continue;
            }
            if delivery_first {
                add(-self.ref_loss);
            }
            for _ in 0..gap.min(256) {
                add(1.0 - self.ref_loss);
            }
            if !delivery_first {
                add(-self.ref_loss);
            }
        }
    }

    /// Whether there is a burst, where every reading says the same.
    pub(super) fn burst(&self) -> Option<bool> {
        // What rounding may make of so many sums of up to twice the threshold, with room to spare.
        let margin = 4.0 * f64::EPSILON * (self.added + 16.0) * (2.0 * self.threshold).max(1.0);
        if self.sums.iter().all(|sum| *sum > self.threshold + margin) {
            Some(true)
        } else if self.sums.iter().all(|sum| *sum < self.threshold - margin) {
            Some(false)
        } else {
            None
        }
    }
}

/// The largest count of which every monitor is sure.
const SATURATES: i64 = (1 << 53) - 1;
/// How many missing seqs a monitor surely remembers, by the text's one number for it.
const REMEMBERED: i64 = 4096;

pub(super) fn link(args: &Tree, result: Outcome<'_>) -> Verdict {
    let result = match result {
        Ok(result) => result,
        Err(code) => return reject(code),
    };
    let mut detector = Detector::new(args);
    if detector.threshold > 1e15 || detector.threshold < 1e-12 {
        return Verdict::Open("a threshold at which the steps of the detector are roundings");
    }
    let (mut first, mut expected): (Option<i64>, i64) = (None, 0);
    let (mut older, mut lost_before, mut in_order, mut is_known) = (0_i64, 0, true, true);
    let mut entries = Vec::new();
    for (step, answer) in items(args.get("steps")).iter().zip(items(result.get("steps"))) {
        let seq = integer(step.get("seq")).unwrap_or(0);
        let lost = integer(answer.get("lost")).unwrap_or(SATURATES);
        in_order = seq >= expected || in_order && seq + 1 == expected;
        match first {
            None => {
                (first, expected) = (Some(seq), seq + 1);
                detector.frame(0, false);
            }
            Some(from) if seq < expected => {
                older += i64::from(seq < from);
                // Which of so many it remembers, nobody says.
                is_known &= lost_before <= REMEMBERED || seq < from;
                // [NCP-RES-042] One from before the first may be a delivery to the detector, as a late one may.
                if lost < lost_before || seq < from {
                    detector.frame(0, true);
                }
            }
            Some(_) => {
                detector.frame(seq.abs_diff(expected), false);
                expected = seq + 1;
            }
        }
        lost_before = lost;
        let mut report = object([]);
        if !is_known || lost >= SATURATES {
            entries.push(free());
            continue;
        }
        if in_order {
            set(&mut report, "last_seq", int(expected - 1));
        }
        let received = integer(answer.get("received")).unwrap_or(0);
        let at_least = received - older.min(received);
        set(
            &mut report,
            "received",
            if older > 0 { range(at_least as f64, (received + older) as f64) } else { int(received) },
        );
        set(&mut report, "lost", int(lost));
        set(&mut report, "loss_rate", near(double(answer.get("loss_rate")).unwrap_or(0.0), 1e-12));
        if let Some(burst) = detector.burst() {
            set(&mut report, "burst", Json::Bool(burst));
        }
        entries.push(report);
    }
    fits(steps(entries))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fuzz::generate::Input;
    use crate::fuzz::oracle;
    use crate::fuzz::tree::{list, num, text};
    use crate::peer::Call;

    #[test]
    fn a_detector_that_every_reading_agrees_on_is_asked_for() {
        let mut detector = Detector::new(&object([]));
        detector.frame(0, false);
        assert_eq!(detector.burst(), Some(false));
        detector.frame(300, false);
        assert_eq!(detector.burst(), Some(true));
    }

    #[test]
    fn what_a_frame_from_before_the_first_makes_of_a_burst_is_left_open() {
        let frames = |seqs: &[i64]| {
            let steps = list(seqs.iter().map(|seq| object([("op", text("frame")), ("seq", int(*seq))])).collect());
            object([("ref_loss", num(0.5)), ("threshold", num(1.7)), ("steps", steps)])
        };
        let asks = |seqs: &[i64]| {
            let args = frames(seqs);
            let answer = oracle::specification(Call::LinkRun, &args.to_string());
            let Verdict::Expect(expect) = oracle::expectation(&Input { call: Call::LinkRun, args }, &answer, None)
            else {
                panic!("nothing is asked for");
            };
            expect.to_string().matches("\"burst\"").count()
        };
        // Three missing make 1.5, a delivery takes 0.5 off, and the threshold is 1.7.
        assert_eq!(asks(&[10, 14, 18]), 3);
        assert_eq!(asks(&[10, 14, 3, 18]), 3);
    }
}
