//! The freedoms of the reflex controller and of the loop.

use ncp_peer_rust::Answer;

use super::exact::norm;
use super::plant::Detector;
use super::{Outcome, TOLERANCE, Verdict, any, fits, fits_or_refused, free, num, range, reject, specification, steps};
use crate::fuzz::tree::{Tree, double, doubles, integer, items, list, members, nums, object, set, string, text};
use crate::json::Json;
use crate::peer::Call;

/// Beyond this, a sum of products may leave the doubles on the way.
const HUGE: f64 = 1e150;

/// A channel of a sensor.
fn data(sensor: Option<&Tree>, name: &str) -> (Option<Vec<f64>>, Option<String>) {
    let channel = sensor.and_then(|sensor| sensor.get("channels")).and_then(|channels| channels.get(name));
    let data = channel.map(|channel| doubles(channel.get("data")));
    (data, channel.and_then(|channel| string(channel, "unit")).map(str::to_owned))
}

fn is_usable(data: Option<&Vec<f64>>) -> bool {
    data.is_some_and(|data| data.len() == 3 && data.iter().all(|x| x.is_finite()))
}

/// What a controller is built from: the doubles of its configuration, and whether one is 0 that may be refused.
struct Gains {
    target: Vec<f64>,
    kp: f64,
    kd: f64,
    max_speed: f64,
}

/// Whether a configuration has the members of the protocol and no others.
fn is_config(config: Option<&Tree>) -> bool {
    let known = |(name, value): &(std::borrow::Cow<'_, str>, Tree)| match name.as_ref() {
        "target" => items(Some(value)).len() == 3,
        "kp" | "kd" | "max_speed" => double(Some(value)).is_some(),
        _ => false,
    };
    config.is_some_and(|config| matches!(config, Json::Object(_)) && members(Some(config)).iter().all(known))
}

impl Gains {
    fn read(config: Option<&Tree>) -> Self {
        let gain = |name: &str, default: f64| {
            config.and_then(|config| double(config.get(name).filter(|gain| !gain.is_null()))).unwrap_or(default)
        };
        let target = config.map(|config| doubles(config.get("target"))).filter(|target| target.len() == 3);
        Self {
            target: target.unwrap_or_else(|| vec![0.0; 3]),
            kp: gain("kp", 1.0),
            kd: gain("kd", 0.3),
            max_speed: gain("max_speed", 1.5),
        }
    }

    fn may_be_refused(&self) -> bool {
        [self.kp, self.kd, self.max_speed].contains(&0.0)
    }

    /// The velocity that the law gives, as the specification says it, with the roundings of its terms.
    fn about(&self, given: &[f64], position: &[f64], velocity: &[f64]) -> Option<Tree> {
        let mut axes = Vec::new();
        for axis in 0..3 {
            let (p, t, v) = (*position.get(axis)?, *self.target.get(axis)?, *velocity.get(axis)?);
            let given = *given.get(axis)?;
            let (pull, drag) = (self.kp * (p - t), self.kd * v);
            let is_one_beyond = pull.is_finite() != drag.is_finite();
            // Where one term alone is beyond the doubles, the other leads back to less than max_speed only if that is
            // huge.
            if !(p - t).is_finite() || !(pull.is_finite() || drag.is_finite()) || is_one_beyond && self.max_speed > HUGE
            {
                return None;
            }
            // The difference and the products may round, and the clamp is exact.
            let off =
                if is_one_beyond { 0.0 } else { TOLERANCE * pull.abs() + TOLERANCE * drag.abs() + f64::MIN_POSITIVE };
            let most = self.max_speed.abs();
            let at = |u: f64| u.max(-most).min(most);
            axes.push(range(at(-pull - drag - off).min(given), at(-pull - drag + off).max(given)));
        }
        Some(list(axes))
    }
}

fn hold() -> Tree {
    let zeros = object([("data", nums(&[0.0; 3])), ("unit", text("m/s"))]);
    let channels = object([("velocity_setpoint", zeros)]);
    object([("mode", text("hold")), ("channels", channels), ("horizon", list(Vec::new()))])
}

pub(super) fn reflex(args: &Tree, result: Outcome<'_>) -> Verdict {
    if !is_config(args.get("config")) {
        return Verdict::Open("the configuration has other members than the protocol says");
    }
    let gains = Gains::read(args.get("config"));
    let result = match result {
        Ok(result) => result,
        Err(code) => return reject(code),
    };
    let sensor = args.get("sensor").filter(|sensor| !sensor.is_null());
    let (position, unit) = data(sensor, "pose_position");
    let (velocity, speed_unit) = data(sensor, "pose_velocity");
    let is_written = [&position, &velocity].into_iter().flatten().flatten().all(|x| x.is_finite());
    let pattern = if is_usable(position.as_ref()) {
        if velocity.as_ref().is_some_and(|v| is_usable(Some(v))) && speed_unit.as_deref().is_some_and(|u| u != "m/s") {
            return Verdict::Open("a velocity in another unit may be taken for none");
        }
        let (usable, zeros) = (is_usable(velocity.as_ref()), vec![0.0; 3]);
        let moving = velocity.filter(|_| usable).unwrap_or(zeros);
        let given = result.get("command").and_then(|command| command.get("channels"));
        let given = doubles(given.and_then(|channels| channels.get("velocity_setpoint")).and_then(|c| c.get("data")));
        let Some(about) = gains.about(&given, &position.unwrap_or_default(), &moving) else {
            return Verdict::Open("a law whose terms leave the doubles");
        };
        let channels = object([("velocity_setpoint", object([("data", about), ("unit", text("m/s"))]))]);
        let mut choices = vec![object([("mode", text("active")), ("channels", channels)])];
        if !usable || unit.is_some_and(|unit| unit != "m") {
            choices.push(hold());
        }
        any(choices)
    } else {
        hold()
    };
    let pattern = object([("command", pattern)]);
    if gains.may_be_refused() || !is_written { fits_or_refused(pattern) } else { fits(pattern) }
}

pub(super) fn control_loop(args: &Tree, result: Outcome<'_>) -> Verdict {
    if !is_config(args.get("config")) {
        return Verdict::Open("the configuration has other members than the protocol says");
    }
    let result = match result {
        Ok(result) => result,
        Err(code) => return reject(code),
    };
    let gains = Gains::read(args.get("config"));
    let limits = args.get("limits");
    let limit = |name: &str| double(limits.and_then(|limits| limits.get(name)).filter(|limit| !limit.is_null()));
    let timeout = limit("command_timeout_ms").unwrap_or(500.0);
    let period = double(args.get("period_ms")).unwrap_or(f64::NAN);
    if period.is_finite() && (2.0 * period).is_infinite() {
        return Verdict::Open("a period of which two are beyond the doubles");
    }
    let fence = limit("geofence_radius_m").filter(|fence| fence.is_finite() && *fence > 0.0);
    let other_roundings: Vec<Tree> = match fence {
        Some(fence) => {
            [1.0 - TOLERANCE, 1.0 + TOLERANCE].into_iter().filter_map(|by| widened(args, fence * by)).collect()
        }
        None => Vec::new(),
    };
    let (mut newest, mut seen): (Option<Tree>, Option<f64>) = (None, None);
    let mut is_known = true;
    let mut stamped = None;
    let mut watch = Watch::new();
    let mut entries = Vec::new();
    for (place, (step, answer)) in items(args.get("steps")).iter().zip(items(result.get("steps"))).enumerate() {
        let now = double(step.get("now_s")).unwrap_or(f64::NAN);
        match string(step, "op") {
            Some("sensor") => {
                if answer.get("error").is_some() {
                    return Verdict::Open("the trace holds what is no sensor frame");
                }
                let sensor = step.get("sensor").cloned().unwrap_or_else(|| object([]));
                let stamp = |sensor: &Tree| integer(sensor.get("seq")).unwrap_or(0);
                let t = |sensor: &Tree| double(sensor.get("t")).unwrap_or(0.0);
                watch.sees(stamp(&sensor));
                let is_stamped = stamp(&sensor) != 0;
                // Streams in which stamped frames and others alternate are open.
                is_known &= *stamped.get_or_insert(is_stamped) == is_stamped && t(&sensor).is_finite();
                let newer = newest
                    .as_ref()
                    .is_none_or(|kept| if is_stamped { stamp(&sensor) > stamp(kept) } else { t(&sensor) > t(kept) });
                if newer {
                    (newest, seen) = (Some(sensor), Some(now));
                }
                entries.push(free());
            }
            Some("tick") => {
                watch.tick();
                let age = seen.map(|seen| now - seen);
                is_known &= !age.is_some_and(|age| age * 1000.0 > 2.0 * timeout && timeout > 0.0);
                is_known &= seen.is_none_or(|seen| {
                    !now.is_finite() || !timeout.is_finite() || super::exact::age(now, seen, timeout).is_some()
                });
                let mode = |answer: &Tree| answer.get("command").and_then(|c| string(c, "mode")).map(str::to_owned);
                let rounds =
                    |other: &Tree| items(other.get("steps")).get(place).is_some_and(|o| mode(o) != mode(answer));
                is_known &= !other_roundings.iter().any(rounds);
                if is_known && is_in_another_unit(newest.as_ref()) {
                    // Whether it holds or goes on, it keeps nothing of it.
                    entries.push(free());
                    continue;
                }
                entries.push(match tick(answer, newest.as_ref(), &gains, period, limits).filter(|_| is_known) {
                    Some(pattern) => pattern,
                    None => {
                        is_known = false;
                        watch.owes(period)
                    }
                });
            }
            // What else a reset touches is open.
            _ => {
                is_known = false;
                watch.is_over = true;
                entries.push(free());
            }
        }
    }
    let written =
        limits.is_none_or(|limits| !limits.to_string().contains("\"NaN\"") && !limits.to_string().contains("Inf"));
    let pattern = steps(entries);
    if gains.may_be_refused() || !written { fits_or_refused(pattern) } else { fits(pattern) }
}

/// What a loop owes whatever sensor frame it keeps: the ESTOP of a burst that a tick has seen.
struct Watch {
    detector: Detector,
    /// One more than the highest seq.
    expected: Option<i64>,
    stopped: bool,
    /// A reset came.
    is_over: bool,
}

impl Watch {
    fn new() -> Self {
        Self { detector: Detector::new(&object([])), expected: None, stopped: false, is_over: false }
    }

    /// [NCP-RES-053] A frame of any seq. One that is not the highest may be late or not, so that it counts or does not.
    fn sees(&mut self, seq: i64) {
        match self.expected {
            Some(expected) if seq < expected => self.detector.frame(0, true),
            expected => {
                self.detector.frame(expected.map_or(0, |expected| seq.abs_diff(expected)), false);
                self.expected = Some(seq.saturating_add(1));
            }
        }
    }

    /// [NCP-CTRL-016] What the monitor shows when a tick begins.
    fn tick(&mut self) {
        self.stopped |= self.detector.burst() == Some(true);
    }

    fn owes(&self, period: f64) -> Tree {
        if !self.stopped || self.is_over {
            return free();
        }
        // [NCP-SAFE-006] [NCP-SAFE-071] [NCP-CTRL-014]
        let still = object([("data", nums(&[0.0; 3])), ("unit", text("m/s"))]);
        let channels = object([("velocity_setpoint", still)]);
        let ttl = range(2.0 * period * (1.0 - 1e-12), f64::MAX);
        object([("command", object([("mode", text("estop")), ("channels", channels), ("ttl_ms", ttl)]))])
    }
}

/// What a loop of another fence does.
fn widened(args: &Tree, fence: f64) -> Option<Tree> {
    let mut other = args.clone();
    let mut limits = args.get("limits")?.clone();
    set(&mut limits, "geofence_radius_m", num(fence));
    set(&mut other, "limits", limits);
    match specification(Call::LoopRun, &other.to_string()) {
        Answer::Result(result) => Json::parse(&result).ok().map(|result| crate::fuzz::tree::own(&result)),
        _ => None,
    }
}

/// Whether a position or a velocity that can be used but for its unit is in another.
fn is_in_another_unit(newest: Option<&Tree>) -> bool {
    let is_other = |name: &str, own: &str| {
        let (data, unit) = data(newest, name);
        is_usable(data.as_ref()) && unit.is_some_and(|unit| unit != own)
    };
    is_usable(data(newest, "pose_position").0.as_ref())
        && (is_other("pose_position", "m") || is_other("pose_velocity", "m/s"))
}

/// What a tick may send; none where it is open.
fn tick(answer: &Tree, newest: Option<&Tree>, gains: &Gains, period: f64, limits: Option<&Tree>) -> Option<Tree> {
    let limit = |name: &str| double(limits.and_then(|limits| limits.get(name)).filter(|limit| !limit.is_null()));
    let may_be_outside = limit("geofence_radius_m").is_some_and(|fence| fence > 0.0);
    let command = answer.get("command")?;
    let mode = string(command, "mode")?;
    let (position, velocity) = (data(newest, "pose_position").0, data(newest, "pose_velocity").0);
    let has_place = is_usable(position.as_ref());
    // [NCP-CTRL-004]
    let is_damped = is_usable(velocity.as_ref());
    let velocity = velocity.filter(|_| is_damped).unwrap_or_else(|| vec![0.0; 3]);
    let may_hold_instead = has_place && !is_damped && mode == "active";
    if has_place && !is_damped && mode == "estop" && may_be_outside {
        // A controller that holds gives the governor no active command: from outside the fence it may hold, too.
        return None;
    }
    let mut pattern = object([("mode", text(mode))]);
    if let Some(seq) = newest.and_then(|newest| newest.get("seq")) {
        set(&mut pattern, "seq", seq.clone());
    }
    let mut status = object([("mode", text(mode))]);
    let most = limit("max_speed_mps");
    if mode == "active" {
        let given = command.get("channels").and_then(|channels| channels.get("velocity_setpoint"));
        let given = doubles(given.and_then(|channel| channel.get("data")));
        let about = gains.about(&given, &position?, &velocity)?;
        // What is scaled to a limit near the smallest doubles may have any norm below it.
        let limited = most.is_some_and(|most| most > 0.0 && (most < 1e-300 || norm(&given) > most * (1.0 - 1e-6)));
        let about = if limited { list(given.iter().map(|x| super::near(*x, 1e-12)).collect()) } else { about };
        set(
            &mut pattern,
            "channels",
            object([("velocity_setpoint", object([("data", about), ("unit", text("m/s"))]))]),
        );
        if !limited {
            set(&mut status, "safety_ok", Json::Bool(true));
        }
    } else {
        // [NCP-SAFE-071] Whether the controller or the governor holds, the one channel is zero.
        let zeros = list(vec![num(0.0), num(0.0), num(0.0)]);
        let still = object([("data", zeros), ("unit", text("m/s"))]);
        set(&mut pattern, "channels", object([("velocity_setpoint", still)]));
        if mode == "estop" && has_place && is_damped {
            set(&mut status, "safety_ok", Json::Bool(false));
        }
    }
    // [NCP-CTRL-014] [NCP-SAFE-070] A HOLD or an ESTOP keeps the ttl that was raised.
    set(&mut pattern, "ttl_ms", range(2.0 * period * (1.0 - 1e-12), f64::MAX));
    let sent = object([("command", pattern), ("status", status)]);
    if !may_hold_instead {
        return Some(sent);
    }
    let zeros = object([("data", nums(&[0.0; 3])), ("unit", text("m/s"))]);
    let held = object([("mode", text("hold")), ("channels", object([("velocity_setpoint", zeros)]))]);
    Some(any(vec![sent, object([("command", held)])]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fuzz::Input;
    use crate::fuzz::oracle::expectation;
    use crate::fuzz::tree::own;

    #[test]
    fn a_law_of_which_one_term_leaves_the_doubles_is_clamped_and_one_whose_difference_does_is_open() {
        let call = Call::ReflexStep;
        let verdict = |config: &str, position: &str, velocity: &str| {
            let position = format!(r#""pose_position":{{"data":[{position},0.0,0.0],"unit":"m"}}"#);
            let velocity = format!(r#""pose_velocity":{{"data":[{velocity},0.0,0.0],"unit":"m/s"}}"#);
            let sensor = format!(r#"{{"seq":1,"channels":{{{position},{velocity}}}}}"#);
            let written = format!(r#"{{"config":{config},"sensor":{sensor}}}"#);
            let args = Json::parse(&written).map(|args| own(&args)).unwrap();
            expectation(&Input { call, args }, &specification(call, &written), None)
        };
        let Verdict::Expect(expect) = verdict(r#"{"kp":4.0,"max_speed":2.0}"#, "1e308", "1e300") else {
            panic!("a term beyond the doubles is beyond every bound");
        };
        assert!(expect.to_string().contains(r#""data":[-2.0,"#), "{expect}");
        assert!(matches!(verdict(r#"{"kp":1e-308,"target":[-1e308,0.0,0.0]}"#, "1e308", "0.0"), Verdict::Open(_)));
        assert!(matches!(verdict(r#"{"kp":4.0,"kd":4.0}"#, "1e308", "1e308"), Verdict::Open(_)));
        assert!(matches!(verdict(r#"{"kp":4.0,"max_speed":1e308}"#, "1e308", "0.0"), Verdict::Open(_)));
    }

    #[test]
    fn a_loop_without_a_usable_velocity_damps_nothing_or_holds_and_is_judged_on_as_before() {
        let call = Call::LoopRun;
        let sensor = |seq: i64, more: &str| {
            let position = r#""pose_position":{"data":[0.5,0.0,0.0],"unit":"m"}"#;
            let sensor = format!(r#"{{"seq":{seq},"channels":{{{position}{more}}}}}"#);
            format!(r#"{{"op":"sensor","sensor":{sensor},"now_s":1.0}}"#)
        };
        let moving = r#","pose_velocity":{"data":[1.0,0.0,0.0],"unit":"m/s"}"#;
        let tick = r#"{"op":"tick","now_s":1.0}"#;
        let steps = [&sensor(1, moving), tick, &sensor(2, ""), tick, &sensor(3, moving), tick].join(",");
        let written = format!(r#"{{"period_ms":50.0,"limits":{{}},"config":{{}},"steps":[{steps}]}}"#);
        let args = Json::parse(&written).map(|args| own(&args)).unwrap();
        let Verdict::Expect(expect) = expectation(&Input { call, args }, &specification(call, &written), None) else {
            panic!("a loop whose sensor has no velocity is decided");
        };
        let answers = items(expect.get("value").and_then(|value| value.get("steps")));
        let undamped = answers[3].to_string();
        assert!(undamped.starts_with("{\"$any\"") && undamped.contains("\"hold\""), "{undamped}");
        assert!(undamped.contains("-0.50000000") || undamped.contains("-0.5,"), "{undamped}");
        assert!(answers[5].to_string().contains("velocity_setpoint"), "{}", answers[5]);
    }

    #[test]
    fn what_a_controller_may_hold_on_says_nothing_of_safety_ok() {
        let asks = |limits: &str, velocity: &str| {
            let channels = format!(r#"{{"pose_position":{{"data":[5.0,0.0,0.0],"unit":"m"}}{velocity}}}"#);
            let sensor = |seq: u32, now: f64| {
                format!(r#"{{"op":"sensor","sensor":{{"seq":{seq},"channels":{channels}}},"now_s":{now:?}}}"#)
            };
            let (first, burst) = (sensor(1, 0.0), sensor(400, 0.125));
            let tick = |now: f64| format!(r#"{{"op":"tick","now_s":{now:?}}}"#);
            let (one, two) = (tick(0.0625), tick(0.125));
            let written = format!(
                r#"{{"period_ms":100.0,"limits":{limits},"config":{{}},"steps":[{first},{one},{burst},{two}]}}"#
            );
            let args = Json::parse(&written).map(|args| own(&args)).unwrap();
            let answer = specification(Call::LoopRun, &written);
            let Verdict::Expect(expect) = expectation(&Input { call: Call::LoopRun, args }, &answer, None) else {
                panic!("the trace is decided");
            };
            let answers = items(expect.get("value").and_then(|value| value.get("steps"))).to_vec();
            [1, 3].map(|tick: usize| answers[tick].to_string().contains("safety_ok"))
        };
        let still = r#","pose_velocity":{"data":[0.0,0.0,0.0],"unit":"m/s"}"#;
        assert_eq!(asks("{}", still), [true, true]);
        assert_eq!(asks("{}", ""), [true, false]);
        assert_eq!(asks(r#"{"geofence_radius_m":1.0}"#, ""), [false, false]);
        assert_eq!(asks(r#"{"max_speed_mps":5e-324}"#, still), [false, true]);
    }

    #[test]
    fn a_loop_that_holds_owes_the_ttl_that_it_raised_and_zeros() {
        let call = Call::LoopRun;
        let written = r#"{"period_ms":400.0,"limits":{},"config":{},"steps":[{"op":"tick","now_s":0.0}]}"#;
        let args = Json::parse(written).map(|args| own(&args)).unwrap();
        let Verdict::Expect(expect) = expectation(&Input { call, args }, &specification(call, written), None) else {
            panic!("what a loop sends without a sensor is decided");
        };
        let answers = items(expect.get("value").and_then(|value| value.get("steps")));
        let command = answers[0].get("command").unwrap();
        let least = doubles(command.get("ttl_ms").and_then(|ttl| ttl.get("$range")))[0];
        assert!((least - 800.0).abs() < 1e-6, "{command}");
        assert!(command.get("channels").unwrap().to_string().contains("[0.0,0.0,0.0]"), "{command}");
    }

    #[test]
    fn a_burst_stops_a_loop_whatever_frame_it_keeps() {
        let call = Call::LoopRun;
        let modes = |seqs: &[i64]| {
            let position = r#"{"pose_position":{"data":[0.5,0.0,0.0],"unit":"m"}}"#;
            let tick = r#"{"op":"tick","now_s":1.0}"#;
            let sensor = |seq: &i64| {
                let sensor = format!(r#"{{"seq":{seq},"channels":{position}}}"#);
                format!(r#"{{"op":"sensor","sensor":{sensor},"now_s":1.0}},{tick}"#)
            };
            let steps = seqs.iter().map(sensor).collect::<Vec<_>>().join(",");
            let written = format!(r#"{{"period_ms":50.0,"limits":{{}},"config":{{}},"steps":[{steps}]}}"#);
            let args = Json::parse(&written).map(|args| own(&args)).unwrap();
            let Verdict::Expect(expect) = expectation(&Input { call, args }, &specification(call, &written), None)
            else {
                panic!("a loop of sensor frames is decided");
            };
            let answers = items(expect.get("value").and_then(|value| value.get("steps")));
            let mode = |answer: &Tree| answer.get("command").and_then(|c| string(c, "mode")).map(str::to_owned);
            answers.iter().skip(1).step_by(2).map(mode).collect::<Vec<_>>()
        };
        let stop = Some("estop".to_owned());
        assert_eq!(modes(&[0, 3, 400, 0, 401])[1..], [None, stop.clone(), stop.clone(), stop.clone()]);
        assert_eq!(modes(&[0, 3, 4, 0, 5])[1..], [None, None, None, None]);
        assert_eq!(modes(&[-1, 0, 400])[1..], [None, stop]);
    }

    #[test]
    fn what_a_loop_of_a_period_does_of_which_two_leave_the_doubles_is_open() {
        let call = Call::LoopRun;
        let verdict = |period: &str| {
            let written = format!(
                r#"{{"period_ms":{period},"limits":{{}},"config":{{}},"steps":[{{"op":"tick","now_s":0.0}}]}}"#
            );
            let args = Json::parse(&written).map(|args| own(&args)).unwrap();
            expectation(&Input { call, args }, &specification(call, &written), None)
        };
        assert!(matches!(verdict("9e307"), Verdict::Open(_)));
        assert!(matches!(verdict("8e307"), Verdict::Expect(_)));
    }
}
