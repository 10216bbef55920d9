//! What the inputs reach, measured: features of steps and pairs of them, sizes, classes of numbers, lengths of traces.
//!
//! A feature is a value on an axis, such as `fence: on`. Of each step that is asked, a value on every axis of its call
//! counts, and so does every pair of them. What no input reached is said by name.

use std::collections::{BTreeMap, HashSet};

use ncp_peer_rust::Answer;
use serde::Serialize;

use super::generate::Input;
use super::rules::fnv;
use super::tree::{double, doubles, integer, items, members, string};
use crate::json::Json;
use crate::peer::Call;

/// An axis, and the values on it.
type Axis = (&'static str, &'static [&'static str]);

const GOVERNOR: &[Axis] = &[
    ("decision", &["passes", "changed", "hold", "estop", "refused"]),
    ("mode", &["active", "hold", "init", "estop"]),
    ("speed limit", &["off", "on", "broken"]),
    ("fence", &["off", "on", "broken"]),
    ("horizon", &["none", "1", "2-16", "17-256", "257-4096"]),
    ("tick", &["none", "good", "bad"]),
    ("position", &["none", "odd", "inside", "on the fence", "outside", "not finite"]),
    ("latch", &["free", "latched"]),
    ("clock", &["fresh", "at the time-out", "stale", "back", "none", "not finite"]),
    ("channels", &["canonical", "negotiated"]),
];

const PLANT: &[Axis] = &[
    ("answer", &["moves", "holds"]),
    ("last command", &["none", "active", "hold", "estop", "malformed", "reset"]),
    ("horizon", &["none", "1", "2-16", "17-256", "257-4096"]),
    ("ttl", &["none", "short", "a minute", "beyond", "no time"]),
    ("age", &["none", "fresh", "at the ttl", "expired", "back", "not finite"]),
    ("order", &["first", "next", "same", "older", "0", "far"]),
    ("receiver", &["lenient", "strict"]),
];

const LINK: &[Axis] = &[
    ("arrival", &["first", "next", "gap", "late", "duplicate", "older"]),
    ("gap", &["0", "1", "2-16", "17-256", "257-4096", "beyond"]),
    ("burst", &["no", "yes"]),
    ("missing", &["0", "1-16", "17-4096", "beyond"]),
    ("reference", &["default", "given"]),
    ("threshold", &["default", "given"]),
];

const LOOP: &[Axis] = &[
    ("decision", &["active", "hold", "estop"]),
    ("speed limit", &["off", "on", "broken"]),
    ("fence", &["off", "on", "broken"]),
    ("position", &["none", "odd", "inside", "on the fence", "outside", "not finite"]),
    ("sensor", &["none", "new", "the same"]),
    ("latch", &["free", "latched"]),
    ("before", &["no reset", "a reset"]),
];

const SESSION: &[Axis] = &[
    ("request", &["open_session", "step_request", "run_request", "close_session", "none of these"]),
    ("reply", &["session_opened", "observation_frame", "session_closed", "refused", "error"]),
    ("open sessions", &["0", "1", "2", "3 or more"]),
    ("stimulus", &["none", "given"]),
    ("network", &["none", "lif", "rate"]),
    ("receiver", &["lenient", "strict"]),
];

const FRAME: &[Axis] = &[
    (
        "answer",
        &[
            "result",
            "malformed",
            "type",
            "kind",
            "missing",
            "value",
            "provenance",
            "limit",
            "version",
            "reply",
            "other",
        ],
    ),
    (
        "kind",
        &[
            "open_session",
            "session_opened",
            "stimulus_frame",
            "step_request",
            "run_request",
            "observation_frame",
            "close_session",
            "session_closed",
            "capabilities",
            "sensor_frame",
            "command_frame",
            "control_status",
            "link_status",
            "error",
        ],
    ),
    ("bytes", &["to 256", "to 4 Ki", "to 64 Ki", "to 1 Mi", "beyond"]),
    ("receiver", &["lenient", "strict"]),
];

const OTHER: &[Axis] = &[
    ("answer", &["result", "version", "contract", "key", "block", "non_finite", "value", "other"]),
    ("bytes", &["to 256", "to 4 Ki", "to 64 Ki", "to 1 Mi", "beyond"]),
];

/// The axes of a call.
fn axes(call: Call) -> &'static [Axis] {
    match call {
        Call::GovernorRun => GOVERNOR,
        Call::BufferRun | Call::WatchdogRun => PLANT,
        Call::LinkRun => LINK,
        Call::LoopRun => LOOP,
        Call::SessionRun => SESSION,
        Call::Decode | Call::Encode | Call::ReplyCheck => FRAME,
        _ => OTHER,
    }
}

/// What one input reaches.
#[derive(Debug, Clone, Default)]
pub(crate) struct Reached {
    /// A value on each axis, for each step.
    steps: Vec<Vec<u8>>,
    /// What its answers reach, as keys: those that are new make an input worth keeping.
    pub(crate) keys: Vec<u64>,
    /// How many steps the trace has, 1 if it is none.
    pub(crate) length: usize,
    /// How many bytes the request has.
    bytes: usize,
    /// Of which classes its numbers are.
    numbers: [u32; NUMBERS.len()],
}

impl Reached {
    /// The pairs of features of its steps, and the combinations of one step and the one before, as keys.
    pub(crate) fn pairs(&self, call: Call) -> Vec<u64> {
        let call = fnv(2, call.as_str());
        let mut keys: HashSet<u64> = self.keys.iter().copied().collect();
        for step in &self.steps {
            for (axis, value) in step.iter().enumerate() {
                for (other, second) in step.iter().enumerate().skip(axis + 1) {
                    let pair = (axis << 24) + (usize::from(*value) << 16) + (other << 8) + usize::from(*second);
                    keys.insert((call ^ pair as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15));
                }
            }
        }
        keys.into_iter().collect()
    }
}

/// Classes of numbers.
const NUMBERS: [&str; 9] = [
    "zero",
    "minus zero",
    "subnormal",
    "below 1e-9",
    "plain",
    "above 1e9",
    "integer above 2^31",
    "near the largest",
    "not finite",
];

/// What all inputs reached.
#[derive(Debug, Clone, Default)]
pub struct Coverage {
    tables: BTreeMap<Call, Table>,
    lengths: BTreeMap<u32, u64>,
    bytes: BTreeMap<u32, u64>,
    numbers: [u64; NUMBERS.len()],
    /// The keys of [`Reached`] that are known.
    pub(crate) keys: HashSet<u64>,
}

#[derive(Debug, Clone, Default)]
struct Table {
    inputs: u64,
    steps: u64,
    /// For each value and each value of a later axis, how many steps had both.
    pairs: Vec<u64>,
    singles: Vec<u64>,
}

/// What was reached, in figures, for reports.
#[derive(Debug, Clone, Serialize)]
pub struct Summary {
    /// For each call, what was reached of its features.
    pub calls: Vec<OfCall>,
    /// How many traces have up to 2^n steps, by n.
    pub lengths: BTreeMap<String, u64>,
    /// How many requests have up to 2^n bytes, by n.
    pub bytes: BTreeMap<String, u64>,
    /// How many numbers were of which class.
    pub numbers: BTreeMap<&'static str, u64>,
    /// How many combinations of call, answer and features were told apart.
    pub combinations: usize,
}

/// What was reached of the features of a call.
#[derive(Debug, Clone, Serialize)]
pub struct OfCall {
    /// The call.
    pub call: &'static str,
    /// How many inputs there were.
    pub inputs: u64,
    /// How many steps these had.
    pub steps: u64,
    /// For each feature, how many steps had it.
    pub features: Vec<(String, u64)>,
    /// How many pairs of features were reached.
    pub pairs: usize,
    /// How many there are.
    pub of: usize,
    /// The features that no step had.
    pub never: Vec<String>,
    /// The pairs that no step had, of features that were reached each by itself.
    pub never_together: Vec<String>,
}

impl Coverage {
    /// Counts an input, and says whether it reached anything new.
    pub(crate) fn count(&mut self, call: Call, reached: &Reached) -> bool {
        let axes = axes(call);
        let total: usize = axes.iter().map(|(_, values)| values.len()).sum();
        let table = self.tables.entry(call).or_default();
        if table.singles.is_empty() {
            (table.singles, table.pairs) = (vec![0; total], vec![0; total * total]);
        }
        table.inputs += 1;
        table.steps += reached.steps.len() as u64;
        for step in &reached.steps {
            let mut offset = 0;
            let mut places = [0; 16];
            for (axis, value) in step.iter().enumerate() {
                places[axis] = offset + usize::from(*value);
                offset += axes[axis].1.len();
            }
            for (axis, place) in places.iter().enumerate().take(step.len()) {
                table.singles[*place] += 1;
                for other in &places[axis + 1..step.len()] {
                    table.pairs[place * total + other] += 1;
                }
            }
        }
        *self.lengths.entry(reached.length.max(1).ilog2()).or_default() += 1;
        *self.bytes.entry(reached.bytes.max(1).ilog2()).or_default() += 1;
        for (known, more) in self.numbers.iter_mut().zip(reached.numbers) {
            *known += u64::from(more);
        }
        let before = self.keys.len();
        self.keys.extend(&reached.keys);
        self.keys.len() > before
    }

    /// All of it in figures.
    #[must_use]
    pub fn summary(&self) -> Summary {
        let calls = self.tables.iter().map(|(call, table)| {
            let names: Vec<(usize, String)> = axes(*call)
                .iter()
                .enumerate()
                .flat_map(|(axis, (name, values))| values.iter().map(move |value| (axis, format!("{name}: {value}"))))
                .collect();
            let total = names.len();
            let (mut pairs, mut of) = (0, 0);
            let mut never_together = Vec::new();
            for (a, (axis, first)) in names.iter().enumerate() {
                for (b, (_, second)) in names.iter().enumerate().filter(|(_, (other, _))| other > axis) {
                    of += 1;
                    if table.pairs[a * total + b] > 0 {
                        pairs += 1;
                    } else if table.singles[a] > 0 && table.singles[b] > 0 {
                        never_together.push(format!("{first} with {second}"));
                    }
                }
            }
            let features = names.iter().zip(&table.singles).map(|((_, name), count)| (name.clone(), *count)).collect();
            let never = names.iter().zip(&table.singles).filter(|(_, count)| **count == 0);
            OfCall {
                call: call.as_str(),
                inputs: table.inputs,
                steps: table.steps,
                features,
                pairs,
                of,
                never: never.map(|((_, name), _)| name.clone()).collect(),
                never_together,
            }
        });
        let powers = |counts: &BTreeMap<u32, u64>| {
            counts.iter().map(|(power, count)| (format!("{:>9}", 1_u64 << (power + 1).min(62)), *count)).collect()
        };
        Summary {
            calls: calls.collect(),
            lengths: powers(&self.lengths),
            bytes: powers(&self.bytes),
            numbers: NUMBERS.into_iter().zip(self.numbers).collect(),
            combinations: self.keys.len(),
        }
    }
}

/// What an input reaches, by the specification's answer to it.
pub(crate) fn reached(input: &Input, bytes: usize, answer: &Answer) -> Reached {
    let mut reached = Reached { bytes, length: 1, ..Reached::default() };
    let parsed = match answer {
        Answer::Result(result) => Json::parse(result).ok(),
        _ => None,
    };
    let args = &input.args;
    match (input.call, &parsed) {
        (Call::GovernorRun, Some(result)) => governor(args, result, &mut reached),
        (Call::BufferRun | Call::WatchdogRun, Some(result)) => plant(args, result, &mut reached),
        (Call::LinkRun, Some(result)) => link(args, result, &mut reached),
        (Call::LoopRun, Some(result)) => control_loop(args, result, &mut reached),
        (Call::SessionRun, Some(result)) => session(args, result, &mut reached),
        (Call::Decode | Call::Encode | Call::ReplyCheck, _) => frame(input, answer, bytes, &mut reached),
        _ => {
            let code = code_of(answer);
            let code = place_of(OTHER[0].1, code, 7);
            reached.steps.push(vec![code, size_class(bytes)]);
        }
    }
    let call = fnv(0, input.call.as_str());
    let mut before = 0;
    for step in &reached.steps {
        let key = step.iter().fold(call, |hash, value| (hash ^ u64::from(*value)).wrapping_mul(0x0100_0000_01b3));
        // What came before is part of what is reached, and so are the first steps of its kind.
        reached.keys.push(key);
        reached.keys.push(key.rotate_left(17) ^ before);
        before = key;
    }
    if let Answer::Error { code, message } = answer {
        // Without what was drawn, the message says which check it was.
        let words: String =
            message.chars().filter(|c| c.is_ascii_alphabetic() || matches!(c, ' ' | '_')).take(60).collect();
        reached.keys.push(fnv(fnv(call, code), &words));
    }
    numbers(args, &mut reached.numbers, 4000);
    reached
}

fn place_of(values: &[&str], value: &str, default: u8) -> u8 {
    values.iter().position(|known| *known == value).and_then(|place| u8::try_from(place).ok()).unwrap_or(default)
}

fn code_of(answer: &Answer) -> &str {
    match answer {
        Answer::Error { code, .. } => code,
        _ => "result",
    }
}

fn size_class(bytes: usize) -> u8 {
    match bytes {
        0..=256 => 0,
        257..=4096 => 1,
        4097..=65_536 => 2,
        65_537..=1_048_576 => 3,
        _ => 4,
    }
}

fn length_class(length: usize) -> u8 {
    match length {
        0 => 0,
        1 => 1,
        2..=16 => 2,
        17..=256 => 3,
        _ => 4,
    }
}

fn numbers(tree: &Json<'_>, counts: &mut [u32; NUMBERS.len()], most: usize) {
    let mut left = most;
    let mut waiting = vec![tree];
    while let Some(tree) = waiting.pop() {
        left = left.saturating_sub(1);
        if left == 0 {
            return;
        }
        match tree {
            Json::Array(items) => waiting.extend(items.iter().take(64)),
            Json::Object(members) => waiting.extend(members.iter().map(|(_, value)| value).take(64)),
            Json::Number(_) => {
                let value = double(Some(tree)).unwrap_or(f64::NAN);
                let size = value.abs();
                let class = match size {
                    _ if !value.is_finite() => 8,
                    0.0 => usize::from(value.is_sign_negative()),
                    _ if size < f64::MIN_POSITIVE => 2,
                    _ if size < 1e-9 => 3,
                    _ if size > 1e300 => 7,
                    _ if size >= 2_147_483_648.0 && value.fract() == 0.0 => 6,
                    _ if size > 1e9 => 5,
                    _ => 4,
                };
                counts[class] += 1;
            }
            Json::String(word) => match word.as_ref() {
                "-0" => counts[1] += 1,
                "NaN" | "Infinity" | "-Infinity" => counts[8] += 1,
                _ => {}
            },
            _ => {}
        }
    }
}

fn limit_class(limits: Option<&Json<'_>>, name: &str) -> u8 {
    match double(limits.and_then(|limits| limits.get(name)).filter(|limit| !limit.is_null())) {
        None | Some(0.0) => 0,
        Some(limit) if limit.is_finite() && limit > 0.0 => 1,
        Some(_) => 2,
    }
}

fn position_class(sensor: Option<&Json<'_>>, fence: Option<f64>) -> u8 {
    let channel = sensor.and_then(|sensor| sensor.get("channels")).and_then(|channels| channels.get("pose_position"));
    let Some(channel) = channel else { return 0 };
    let data = doubles(channel.get("data"));
    if !data.iter().all(|x| x.is_finite()) {
        return 5;
    }
    if data.len() != 3 || channel.get("unit").and_then(Json::as_str).is_some_and(|unit| unit != "m") {
        return 1;
    }
    let norm = data.iter().map(|x| x * x).sum::<f64>().sqrt();
    match fence {
        Some(fence) if (norm - fence).abs() <= 1e-12 * fence => 3,
        Some(fence) if norm > fence => 4,
        _ => 2,
    }
}

fn fence_of(limits: Option<&Json<'_>>) -> Option<f64> {
    let fence = limits.and_then(|limits| limits.get("geofence_radius_m")).filter(|fence| !fence.is_null());
    double(fence).filter(|fence| fence.is_finite() && *fence > 0.0)
}

fn governor(args: &Json<'_>, result: &Json<'_>, reached: &mut Reached) {
    let limits = args.get("limits");
    let (speed, fence) = (limit_class(limits, "max_speed_mps"), limit_class(limits, "geofence_radius_m"));
    let timeout = double(limits.and_then(|limits| limits.get("command_timeout_ms"))).unwrap_or(500.0);
    let negotiated = u8::from(args.get("capabilities").is_some_and(|capabilities| !capabilities.is_null()));
    let mut latched = 0;
    let steps = items(args.get("steps"));
    reached.length = steps.len();
    for (step, answer) in steps.iter().zip(items(result.get("steps"))) {
        match string(step, "op") {
            Some("note_link") if step.get("burst") == Some(&Json::Bool(true)) => latched = 1,
            Some("reset") => latched = 0,
            Some("govern") => {
                let command = step.get("command");
                let frame = answer.get("frame");
                let mode = command.and_then(|command| string(command, "mode")).unwrap_or("active");
                let sent = frame.and_then(|frame| string(frame, "mode"));
                let ticks = items(command.and_then(|command| command.get("horizon"))).len();
                let decision = match sent {
                    None => 4,
                    Some("hold") => 2,
                    Some("estop") => 3,
                    Some(_) => {
                        let kept = items(frame.and_then(|frame| frame.get("horizon"))).len();
                        let data = |of: Option<&Json<'_>>| {
                            let channels = of.and_then(|of| of.get("channels"));
                            doubles(channels.and_then(|c| c.get("velocity_setpoint")).and_then(|v| v.get("data")))
                        };
                        u8::from(kept != ticks || data(frame) != data(command))
                    }
                };
                let dt = command.and_then(|command| command.get("horizon_dt_ms")).filter(|dt| !dt.is_null());
                let dt = match double(dt) {
                    None => 0,
                    Some(dt) if dt.is_finite() && dt > 0.0 => 1,
                    Some(_) => 2,
                };
                let now = double(step.get("now_s")).unwrap_or(f64::NAN);
                let last = double(step.get("last_sensor_s").filter(|last| !last.is_null()));
                let clock = match last.map(|last| (now - last) * 1000.0) {
                    None => 4,
                    Some(age) if !age.is_finite() => 5,
                    Some(age) if age < 0.0 => 3,
                    Some(age) if age > timeout => 2,
                    Some(age) => u8::from(age == timeout),
                };
                let position = position_class(step.get("sensor"), fence_of(limits));
                reached.steps.push(vec![
                    decision,
                    place_of(GOVERNOR[1].1, mode, 1),
                    speed,
                    fence,
                    length_class(ticks),
                    dt,
                    position,
                    latched,
                    clock,
                    negotiated,
                ]);
                if sent == Some("estop") {
                    latched = 1;
                }
            }
            _ => {}
        }
    }
}

fn plant(args: &Json<'_>, result: &Json<'_>, reached: &mut Reached) {
    let strict = u8::from(args.get("strict") == Some(&Json::Bool(true)));
    let (mut last, mut ticks, mut ttl, mut order) = (0, 0, 0, 0);
    let (mut received, mut span, mut highest) = (None, f64::NAN, None);
    let steps = items(args.get("steps"));
    reached.length = steps.len();
    for (step, answer) in steps.iter().zip(items(result.get("steps"))) {
        let now = double(step.get("now_s")).unwrap_or(f64::NAN);
        match string(step, "op") {
            Some("command") => {
                let frame = string(step, "text").and_then(|text| Json::parse(text).ok());
                let is_watchdog = step.get("seq").is_some();
                let of = if is_watchdog { Some(step) } else { frame.as_ref() };
                last = match of.and_then(|frame| string(frame, "mode")) {
                    _ if answer.get("error").is_some() => 4,
                    _ if is_watchdog => 1,
                    None => {
                        if of.is_none() {
                            4
                        } else {
                            2
                        }
                    }
                    Some("active") => 1,
                    Some("estop") => 3,
                    Some(_) => 2,
                };
                let seq = integer(of.and_then(|frame| frame.get("seq"))).unwrap_or(0);
                order = match highest {
                    _ if seq == 0 => 4,
                    None => 0,
                    Some(known) if seq == known => 2,
                    Some(known) if seq < known => 3,
                    Some(known) if seq > known + 1 => 5,
                    Some(_) => 1,
                };
                if last == 1 && highest.is_none_or(|known| seq > known) {
                    highest = Some(seq);
                    received = Some(now);
                    span = double(of.and_then(|frame| frame.get("ttl_ms"))).unwrap_or(200.0);
                    ticks = length_class(items(of.and_then(|frame| frame.get("horizon"))).len());
                    ttl = match span {
                        span if !(span.is_finite() && span > 0.0) => 4,
                        60_000.0 => 2,
                        span if span > 60_000.0 => 3,
                        _ => 1,
                    };
                }
            }
            Some("reset") => (last, received, highest) = (5, None, None),
            _ => {
                let holds = answer.get("hold") == Some(&Json::Bool(true))
                    || answer.get("channels").is_some_and(Json::is_null)
                    || answer.get("hold").is_none() && answer.get("channels").is_none();
                let age = match received.map(|received| (now - received) * 1000.0) {
                    None => 0,
                    Some(age) if !age.is_finite() => 5,
                    Some(age) if age < 0.0 => 4,
                    Some(age) if age > span => 3,
                    Some(age) => 1 + u8::from(age == span),
                };
                reached.steps.push(vec![u8::from(holds), last, ticks, ttl, age, order, strict]);
            }
        }
    }
}

fn link(args: &Json<'_>, result: &Json<'_>, reached: &mut Reached) {
    let given = |name: &str| u8::from(args.get(name).is_some_and(|value| !value.is_null()));
    let (reference, threshold) = (given("ref_loss"), given("threshold"));
    let (mut first, mut expected, mut lost_before) = (None, 0, 0);
    let steps = items(args.get("steps"));
    reached.length = steps.len();
    for (step, answer) in steps.iter().zip(items(result.get("steps"))) {
        let seq = integer(step.get("seq")).unwrap_or(0);
        let lost = integer(answer.get("lost")).unwrap_or(i64::MAX);
        let gap = usize::try_from(seq.saturating_sub(expected)).unwrap_or(0);
        let (arrival, gap) = match first {
            None => (0, 0),
            Some(from) if seq < from => (5, 0),
            Some(_) if seq < expected => (if lost < lost_before { 3 } else { 4 }, 0),
            Some(_) => (1 + u8::from(gap > 0), if gap > 4096 { 5 } else { length_class(gap) }),
        };
        let missing = match lost {
            0 => 0,
            1..=16 => 1,
            17..=4096 => 2,
            _ => 3,
        };
        let burst = u8::from(answer.get("burst") == Some(&Json::Bool(true)));
        reached.steps.push(vec![arrival, gap, burst, missing, reference, threshold]);
        first.get_or_insert(seq);
        expected = if arrival == 0 { seq + 1 } else { expected.max(seq.saturating_add(1)) };
        lost_before = lost;
    }
}

fn control_loop(args: &Json<'_>, result: &Json<'_>, reached: &mut Reached) {
    let limits = args.get("limits");
    let (speed, fence) = (limit_class(limits, "max_speed_mps"), limit_class(limits, "geofence_radius_m"));
    let (mut sensor, mut kept, mut latched, mut reset) = (0, None, 0, 0);
    let steps = items(args.get("steps"));
    reached.length = steps.len();
    for (step, answer) in steps.iter().zip(items(result.get("steps"))) {
        match string(step, "op") {
            Some("sensor") => (sensor, kept) = (1, step.get("sensor")),
            Some("tick") => {
                let mode = answer.get("command").and_then(|command| string(command, "mode")).unwrap_or("hold");
                let decision = place_of(LOOP[0].1, mode, 1);
                reached.steps.push(vec![
                    decision,
                    speed,
                    fence,
                    position_class(kept, fence_of(limits)),
                    sensor,
                    latched,
                    reset,
                ]);
                sensor = if sensor == 0 { 0 } else { 2 };
                latched = u8::from(mode == "estop");
            }
            _ => (latched, reset) = (0, 1),
        }
    }
}

fn session(args: &Json<'_>, result: &Json<'_>, reached: &mut Reached) {
    let strict = u8::from(args.get("strict") == Some(&Json::Bool(true)));
    let mut open = 0_u8;
    let requests = items(args.get("requests"));
    reached.length = requests.len();
    for (request, reply) in requests.iter().zip(items(result.get("replies"))) {
        let parse =
            |json: &Json<'_>| json.as_str().and_then(|text| Json::parse(text).ok().map(|json| super::tree::own(&json)));
        let (request, reply) = (parse(request), parse(reply));
        let kind = request.as_ref().and_then(|request| string(request, "kind")).unwrap_or_default();
        let ok = reply.as_ref().is_some_and(|reply| reply.get("ok") != Some(&Json::Bool(false)));
        let answer = match reply.as_ref().and_then(|reply| string(reply, "kind")) {
            Some("session_opened") if ok => 0,
            Some("observation_frame") => 1,
            Some("session_closed") if ok => 2,
            Some("session_opened" | "session_closed") => 3,
            _ => 4,
        };
        let network =
            request.as_ref().and_then(|request| request.get("network")).and_then(|network| string(network, "ref"));
        let network = match network {
            Some("ncp.reference.lif") => 1,
            Some("ncp.reference.rate") => 2,
            _ => 0,
        };
        let stimulus = u8::from(request.as_ref().is_some_and(|request| {
            !members(request.get("stimulus").and_then(|stimulus| stimulus.get("values"))).is_empty()
        }));
        reached.steps.push(vec![place_of(SESSION[0].1, kind, 4), answer, open.min(3), stimulus, network, strict]);
        match answer {
            0 => open = open.saturating_add(1),
            2 => open = open.saturating_sub(1),
            _ => {}
        }
    }
}

fn frame(input: &Input, answer: &Answer, bytes: usize, reached: &mut Reached) {
    let reply = string(&input.args, "reply").and_then(|reply| Json::parse(reply).ok());
    let kind = string(&input.args, "kind").or_else(|| reply.as_ref().and_then(|reply| string(reply, "kind")));
    let strict = u8::from(input.args.get("strict") == Some(&Json::Bool(true)));
    let code = place_of(FRAME[0].1, code_of(answer), 10);
    reached.steps.push(vec![code, place_of(FRAME[1].1, kind.unwrap_or_default(), 13), size_class(bytes), strict]);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fuzz::draw::Draw;
    use crate::fuzz::generate;
    use crate::fuzz::generate::tests::whole_menu;
    use crate::fuzz::harvest::Harvest;

    #[test]
    fn what_is_reached_is_counted_once_and_new_only_the_first_time() {
        let (menu, harvest) = (whole_menu(), Harvest::default());
        let mut coverage = Coverage::default();
        let mut inputs = 0;
        for number in 0..200 {
            let mut draw = Draw::new(1, number, &harvest);
            let call = generate::call(&menu, &mut draw).unwrap();
            let input = Input { call, args: generate::args(call, &menu, &mut draw).unwrap() };
            let answer = ncp_peer_rust::ask(input.call.as_str(), &input.args.to_string());
            let reached = reached(&input, input.body().len(), &answer);
            coverage.count(input.call, &reached);
            assert!(!coverage.count(input.call, &reached), "it is known by now");
            inputs += 2;
        }
        let summary = coverage.summary();
        assert_eq!(summary.calls.iter().map(|call| call.inputs).sum::<u64>(), inputs);
        assert!(summary.calls.iter().all(|call| call.pairs <= call.of));
        assert!(summary.combinations > 100);
    }
}
