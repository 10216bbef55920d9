//! The freedoms of a governor.
//!
//! The governor of the specification is led through the trace once for each reading of the text: in what order it looks
//! at the position and at the mode of a command that is not active, and after which silence of the sensor it stops.

use ncp_spec::safety::SafetyGovernor;
use ncp_spec::safety::{Decision, Reason};
use ncp_spec::wire::{self, Capabilities, ChannelMap, CommandFrame, Kind, Message, Mode, SensorFrame};

use super::exact::{is_settled, norm};
use super::{
    Outcome, TOLERANCE, Verdict, any, exactly, fits, fits_or_refused, free, near, num, refused, reject, steps,
};
use crate::fuzz::tree::{Tree, double, items, list, nums, object, set, string, text};
use crate::json::Json;

const POSITION: &str = "pose_position";
const VELOCITY: &str = "velocity_setpoint";
const MPS: &str = "m/s";
/// How far off, m/s, a component of a scaled velocity may be whatever its size, SAFE-061.
const SUBNORMAL: f64 = 1e-300;
/// How many readings of one trace are listed.
const MOST_READINGS: usize = 24;

/// In what order a governor looks at the position and at the mode.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Order {
    PositionFirst,
    ModeFirst,
    ModeOnly,
}

pub(super) fn governor(args: &Tree, result: Outcome<'_>) -> Verdict {
    if let Err(code) = result {
        return reject(code);
    }
    let Some(setup) = Setup::read(args) else { return Verdict::Open("limits or channels that the text leaves open") };
    let mut silences = vec![f64::INFINITY];
    for step in items(args.get("steps")) {
        if let (Some(now), Some(last)) = (double(step.get("now_s")), double(step.get("last_sensor_s"))) {
            let age = now - last;
            if setup.may_stop(age) && !silences.contains(&age) {
                silences.push(age);
            }
        }
    }
    if silences.len() * 3 > MOST_READINGS {
        return Verdict::Open("a sensor that is silent for long, in more ways than can be listed");
    }
    let mut patterns: Vec<Tree> = Vec::new();
    for silence in silences {
        for order in [Order::PositionFirst, Order::ModeFirst, Order::ModeOnly] {
            let Some(pattern) = setup.pattern(args, order, silence) else {
                return Verdict::Open("the trace holds what is no command");
            };
            if !patterns.contains(&pattern) {
                patterns.push(pattern);
            }
        }
    }
    if setup.is_writable { fits(any(patterns)) } else { fits_or_refused(any(patterns)) }
}

/// A governor as it is built, and what of it the text leaves open.
struct Setup {
    capabilities: Capabilities,
    negotiated: bool,
    speed: Option<f64>,
    fence: Option<f64>,
    timeout: f64,
    /// Whether a JSON text can hold the limits.
    is_writable: bool,
}

fn enabled(limit: Option<f64>) -> Option<f64> {
    limit.filter(|limit| limit.is_finite() && *limit > 0.0)
}

impl Setup {
    fn read(args: &Tree) -> Option<Self> {
        let limits = args.get("limits")?;
        let limit =
            |name: &str| limits.get(name).filter(|limit| !limit.is_null()).and_then(|limit| double(Some(limit)));
        let tilt = limit("max_tilt_rad");
        if tilt.is_some_and(|tilt| !tilt.is_finite() || tilt < 0.0) {
            return None;
        }
        let negotiated = args.get("capabilities").filter(|capabilities| !capabilities.is_null());
        let mut fields = negotiated.cloned().unwrap_or_else(|| object([]));
        set(&mut fields, "safety", limits.clone());
        let Ok(Message::Capabilities(capabilities)) = wire::build(Kind::Capabilities, fields.to_string().as_bytes())
        else {
            return None;
        };
        for (specs, name, limit) in [
            (&capabilities.sensor_channels, POSITION, limit("geofence_radius_m")),
            (&capabilities.command_channels, VELOCITY, limit("max_speed_mps")),
        ] {
            // Another width is advice, SAFE-016.
            let wide = specs
                .iter()
                .filter(|spec| spec.name == name)
                .all(|spec| matches!((spec.kind.as_str(), spec.size), ("vec3", None | Some(3)) | ("array", Some(3))));
            if enabled(limit).is_some() && !wide {
                return None;
            }
        }
        let timeout = limits.get("command_timeout_ms").map_or(Some(500.0), |timeout| double(Some(timeout)))?;
        let (speed, fence) = (limit("max_speed_mps"), limit("geofence_radius_m"));
        let finite = |limit: Option<f64>| limit.is_none_or(f64::is_finite);
        let is_writable = finite(speed) && finite(fence) && timeout.is_finite();
        Some(Self { capabilities, negotiated: negotiated.is_some(), speed, fence, timeout, is_writable })
    }

    /// A governor whose fence is so much wider.
    fn build(&self, wider: f64) -> SafetyGovernor {
        let mut capabilities = self.capabilities.clone();
        capabilities.safety.geofence_radius_m = self.fence.map(|fence| fence * wider);
        if self.negotiated {
            SafetyGovernor::from_capabilities(&capabilities)
        } else {
            SafetyGovernor::new(&capabilities.safety)
        }
    }

    /// Whether a governor may latch ESTOP after such a silence.
    fn may_stop(&self, age: f64) -> bool {
        age.is_finite() && self.timeout.is_finite() && self.timeout > 0.0 && age * 1000.0 > 2.0 * self.timeout
    }

    /// The unit in which a channel is read.
    fn unit<'c>(&'c self, name: &str, unit: Option<&'c str>) -> Option<&'c str> {
        unit.or_else(|| {
            if self.negotiated {
                let spec = self.capabilities.command_channels.iter().find(|spec| spec.name == name)?;
                return spec.unit.as_deref();
            }
            (name == VELOCITY).then_some(MPS)
        })
    }

    fn pattern(&self, args: &Tree, order: Order, silence: f64) -> Option<Tree> {
        let mut governor = self.build(1.0);
        let mut entries = Vec::new();
        // After a sensor that no JSON text holds, or where a rounding decides, nobody knows whether ESTOP is latched.
        let mut is_known = true;
        for step in items(args.get("steps")) {
            match string(step, "op")? {
                "note_link" => {
                    let burst = step.get("burst") == Some(&Json::Bool(true));
                    governor.note_link(burst);
                    // A burst latches whatever was before.
                    is_known |= burst && governor.is_stopped();
                    entries.push(free());
                }
                "reset" => {
                    governor.reset();
                    is_known = true;
                    entries.push(free());
                }
                _ => {
                    let step = Govern::read(step)?;
                    let (pattern, known) = self.govern(&mut governor, &step, order, silence);
                    // An ESTOP that was commanded latches whatever was before.
                    is_known |= step.command.mode == Mode::Estop;
                    entries.push(if is_known { pattern } else { free() });
                    is_known &= known;
                }
            }
        }
        Some(steps(entries))
    }

    /// What may come of a step, and whether it is known what it leaves.
    fn govern(&self, governor: &mut SafetyGovernor, step: &Govern, order: Order, silence: f64) -> (Tree, bool) {
        let mut frame = step.command.clone();
        let before = governor.clone();
        let decision = governor.govern(&mut frame, step.now, step.sensor.as_ref(), step.last);
        let active = step.command.mode == Mode::Active;
        let mut may_hold = false;
        let mut known = true;
        match decision {
            Decision::Held(Reason::StaleSensor) => {
                let age = step.last.map_or(f64::NAN, |last| step.now - last);
                if super::exact::age(step.now, step.last.unwrap_or(f64::NAN), self.timeout).is_none()
                    && age.is_finite()
                    && self.timeout.is_finite()
                {
                    return (free(), false);
                }
                if self.may_stop(age) && age >= silence {
                    governor.note_link(true);
                    frame.mode = Mode::Estop;
                }
            }
            Decision::Stopped(Reason::OutsideFence) if !active => match order {
                Order::PositionFirst => {}
                Order::ModeFirst => frame.mode = Mode::Hold,
                Order::ModeOnly => {
                    frame.mode = Mode::Hold;
                    governor.reset();
                }
            },
            Decision::Passed | Decision::Limited
                if super::exact::age(step.now, step.last.unwrap_or(f64::NAN), self.timeout).is_none() =>
            {
                return (free(), false);
            }
            _ => {}
        }
        let place = step.position();
        if let (Some(radius), Some(place)) = (enabled(self.fence), &place)
            && !is_settled(place, radius)
        {
            return (free(), false);
        }
        if step.sensor.as_ref().is_some_and(|sensor| !is_writable(sensor)) {
            known = false;
        }
        let may_refuse = !step.is_writable || !self.is_writable || !known;
        let mut patterns = Vec::new();
        if matches!(decision, Decision::Passed | Decision::Limited | Decision::Held(Reason::LeavesFence)) {
            if self.is_at_the_fence(&before, step, &decision, &frame) {
                let mode = object([("mode", any(vec![text("active"), text("hold")]))]);
                return (either(object([("frame", mode)]), may_refuse), known);
            }
            let ttl = step.command.ttl_ms;
            may_hold |= !(ttl.is_finite() && ttl > 0.0);
        }
        if matches!(decision, Decision::Passed | Decision::Limited) {
            // A width that no limit needs, or a step that is not finite, may be held for.
            let odd = |channels: &ChannelMap| channels.iter().any(|(name, c)| name == VELOCITY && c.data.len() != 3);
            let strange = |channels: &ChannelMap| channels.iter().any(|(_, c)| c.data.iter().any(|x| !x.is_finite()));
            may_hold |= odd(&step.command.channels) || step.command.horizon.iter().any(odd);
            may_hold |= step.command.horizon.iter().any(strange);
            may_hold |= place.as_ref().is_some_and(|place| place.len() != 3);
            self.passes(&before, step, &frame, &mut patterns, &mut may_hold);
        }
        let held = matches!(decision, Decision::Held(_) | Decision::Stopped(_));
        if held || may_hold {
            let mode = if held { frame.mode } else { Mode::Hold };
            patterns.push(object([("frame", self.quiet(step, mode.as_str()))]));
        }
        if may_refuse {
            patterns.push(refused());
        }
        (any(patterns), known)
    }

    /// Whether another rounding of the look ahead decides otherwise.
    fn is_at_the_fence(
        &self,
        before: &SafetyGovernor,
        step: &Govern,
        decision: &Decision,
        frame: &CommandFrame,
    ) -> bool {
        if enabled(self.fence).is_none() {
            return false;
        }
        // A projection that leaves the doubles on its way may be taken for one that ends outside.
        let mut ticks = std::iter::once(&step.command.channels).chain(&step.command.horizon);
        let far = step.position().map_or(0.0, |place| norm(&place));
        let most = enabled(self.speed).unwrap_or(f64::INFINITY);
        let leaves = |speed: f64| speed.min(most) * 60.0 + far > f64::MAX / 8.0;
        if ticks.any(|tick| tick.get(VELOCITY).is_some_and(|velocity| leaves(norm(&velocity.data)))) {
            return true;
        }
        [1.0 - TOLERANCE, 1.0 + TOLERANCE].into_iter().any(|wider| {
            let mut other = self.build(wider);
            if before.is_stopped() {
                other.note_link(true);
            }
            let mut copy = step.command.clone();
            let decided = other.govern(&mut copy, step.now, step.sensor.as_ref(), step.last);
            let same = match (decided, decision) {
                (Decision::Passed | Decision::Limited, Decision::Passed | Decision::Limited) => true,
                (decided, decision) => decided == *decision,
            };
            !same || copy.horizon.len() != frame.horizon.len()
        })
    }

    /// The frames as which a command may pass.
    fn passes(
        &self,
        before: &SafetyGovernor,
        step: &Govern,
        frame: &CommandFrame,
        patterns: &mut Vec<Tree>,
        may_hold: &mut bool,
    ) {
        let mut pattern = object([
            ("mode", text("active")),
            ("seq", crate::fuzz::tree::int(frame.seq)),
            ("t", num(frame.t)),
            ("frame_id", text(frame.frame_id.to_string())),
            ("ttl_ms", num(frame.ttl_ms)),
            ("channels", self.channels(&step.command.channels, &frame.channels)),
        ]);
        let ticks: Vec<Tree> =
            step.command.horizon.iter().zip(&frame.horizon).map(|(was, is)| self.channels(was, is)).collect();
        let kept = ticks.len();
        let mut whole = pattern.clone();
        set(&mut whole, "horizon", list(ticks.clone()));
        patterns.push(object([("frame", whole)]));
        let (Some(radius), false) = (enabled(self.fence), step.command.horizon.is_empty()) else { return };
        // By SAFE-055 it may hold on a step without a usable velocity; with a speed limit, SAFE-067 truncates.
        let unusable = step.command.horizon.get(kept).is_some_and(|tick| !self.has_velocity(tick));
        *may_hold |= unusable && enabled(self.speed).is_none();
        let dt = step.command.horizon_dt_ms.unwrap_or(f64::NAN);
        // A horizon of which each step ends inside, those behind the ttl too, is shortened by nobody [NCP-SAFE-021].
        let ticks_inside = || {
            let mut place = step.position()?.to_vec();
            Some(std::iter::once(&frame.channels).chain(&frame.horizon).all(|tick| {
                let velocity = tick.get(VELOCITY).map(|channel| channel.data.as_slice()).unwrap_or_default();
                place = place.iter().zip(velocity).map(|(at, v)| at + v * (dt / 1000.0)).collect();
                place.len() == 3 && norm(&place) <= radius * (1.0 - 1e-9)
            }))
        };
        if kept > 0 && kept == step.command.horizon.len() && ticks_inside() == Some(true) {
            return;
        }
        // It may look further ahead, and drop more or all of it.
        if kept > 1 {
            set(&mut pattern, "horizon", object([("$beginning", list(ticks))]));
            patterns.push(object([("frame", pattern.clone())]));
        }
        let mut alone = step.command.clone();
        alone.horizon.clear();
        let decided = before.clone().govern(&mut alone, step.now, step.sensor.as_ref(), step.last);
        match decided {
            Decision::Passed | Decision::Limited => {
                set(&mut pattern, "horizon", list(Vec::new()));
                patterns.push(object([("frame", pattern)]));
            }
            _ => *may_hold = true,
        }
    }

    fn has_velocity(&self, tick: &ChannelMap) -> bool {
        tick.get(VELOCITY).is_some_and(|channel| {
            self.unit(VELOCITY, channel.unit.as_deref()) == Some(MPS)
                && channel.data.len() == 3
                && channel.data.iter().all(|x| x.is_finite())
        })
    }

    /// The channels of a tick that passes.
    fn channels(&self, was: &ChannelMap, is: &ChannelMap) -> Tree {
        let channel = |(name, after): (&str, &ncp_spec::wire::ChannelValue)| {
            let before = was.get(name);
            let unit = self.unit(name, before.and_then(|before| before.unit.as_deref()));
            let length = before.map_or(0.0, |before| norm(&before.data));
            // A length that is subnormal may have been rounded to the limit.
            let reaches = |most: f64| length > most * (1.0 - 1e-12) || length == most && most < f64::MIN_POSITIVE;
            let limited = unit == Some(MPS) && enabled(self.speed).is_some_and(reaches);
            let data = match before {
                Some(_) if limited => list(after.data.iter().map(|x| near(*x, SUBNORMAL)).collect()),
                Some(before) => nums(&before.data),
                None => nums(&after.data),
            };
            let own = before.and_then(|before| before.unit.as_deref());
            let unit = match own {
                Some(unit) => text(unit),
                None => any(std::iter::once(Json::Null).chain(unit.map(text)).collect()),
            };
            (name.to_string(), object([("data", data), ("unit", unit)]))
        };
        exactly(crate::fuzz::tree::map(is.iter().map(channel).collect()))
    }

    /// A HOLD or ESTOP frame.
    fn quiet(&self, step: &Govern, mode: &str) -> Tree {
        let command = &step.command;
        let mut channels: Vec<(String, Tree)> = command
            .channels
            .iter()
            .map(|(name, channel)| {
                let unit = match &channel.unit {
                    Some(unit) => text(unit.to_string()),
                    None => any(std::iter::once(Json::Null).chain(self.unit(name, None).map(text)).collect()),
                };
                let zeros = |width, unit| object([("data", nums(&vec![0.0; width])), ("unit", unit)]);
                let zeroed = if name == VELOCITY && channel.data.is_empty() {
                    // [NCP-SAFE-072] [NCP-SAFE-073] One that came without values may stay so.
                    any(vec![zeros(0, unit.clone()), zeros(3, any(vec![unit, text(MPS)]))])
                } else {
                    zeros(channel.data.len(), unit)
                };
                (name.to_string(), zeroed)
            })
            .collect();
        let negotiated: Vec<&str> = if self.negotiated {
            self.capabilities.command_channels.iter().map(|spec| &*spec.name).collect()
        } else {
            vec![VELOCITY]
        };
        for name in negotiated {
            let zero = if name == VELOCITY {
                object([("data", nums(&[0.0; 3])), ("unit", text(MPS))])
            } else {
                object([("data", nums(&[0.0]))])
            };
            channels.push((name.to_owned(), zero));
        }
        object([
            ("mode", text(mode)),
            ("seq", crate::fuzz::tree::int(command.seq)),
            ("t", num(command.t)),
            ("frame_id", text(command.frame_id.to_string())),
            ("ttl_ms", num(command.ttl_ms)),
            ("channels", exactly(crate::fuzz::tree::map(channels))),
            ("horizon", list(Vec::new())),
        ])
    }
}

fn either(pattern: Tree, may_refuse: bool) -> Tree {
    if may_refuse { any(vec![pattern, refused()]) } else { pattern }
}

fn is_writable(sensor: &SensorFrame) -> bool {
    sensor.t.is_finite() && sensor.channels.iter().all(|(_, channel)| channel.data.iter().all(|x| x.is_finite()))
}

/// A step `govern`.
struct Govern {
    command: CommandFrame,
    now: f64,
    sensor: Option<SensorFrame>,
    last: Option<f64>,
    /// Whether a JSON text can hold the command.
    is_writable: bool,
}

impl Govern {
    fn read(step: &Tree) -> Option<Self> {
        let written = step.get("command")?.to_string();
        let Ok(Message::CommandFrame(command)) = wire::build(Kind::CommandFrame, written.as_bytes()) else {
            return None;
        };
        let sensor = match step.get("sensor").filter(|sensor| !sensor.is_null()) {
            None => None,
            Some(fields) => match wire::build(Kind::SensorFrame, fields.to_string().as_bytes()) {
                Ok(Message::SensorFrame(sensor)) => Some(sensor),
                _ => return None,
            },
        };
        let last = step.get("last_sensor_s").filter(|last| !last.is_null()).and_then(|last| double(Some(last)));
        let is_writable = Message::from(command.clone()).encode().is_ok();
        Some(Self { command, now: double(step.get("now_s"))?, sensor, last, is_writable })
    }

    fn position(&self) -> Option<Vec<f64>> {
        self.sensor.as_ref().and_then(|sensor| sensor.channels.get(POSITION)).map(|channel| channel.data.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fuzz::Input;
    use crate::fuzz::oracle::{expectation, specification};
    use crate::fuzz::tree::own;
    use crate::peer::Call;

    #[test]
    fn a_velocity_that_came_without_values_stays_so_in_a_hold_or_becomes_three_zeros() {
        let written = r#"{"limits":{"command_timeout_ms":500.0},"steps":[{"op":"govern","command":{"seq":1,
            "mode":"hold","ttl_ms":250.0,"channels":{"velocity_setpoint":{"data":[],"unit":"m/s"},"a":{"data":[]}}},
            "now_s":1.0,"last_sensor_s":1.0}]}"#;
        let (call, args) = (Call::GovernorRun, own(&Json::parse(written).unwrap()));
        let Verdict::Expect(expect) = expectation(&Input { call, args }, &specification(call, written), None) else {
            panic!("the frame is decided");
        };
        let expect = expect.to_string();
        assert!(expect.contains(r#""velocity_setpoint":{"$any":[{"data":[]"#), "{expect}");
        assert!(expect.contains(r#"{"data":[0.0,0.0,0.0]"#) && expect.contains(r#""a":{"data":[]"#), "{expect}");
    }
}
