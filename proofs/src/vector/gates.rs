//! Counterexamples as traces of `governor.run`: the fence, the speed limit, the latch and the age of a sensor frame.
//!
//! What a case expects is what the governor of the specification answers. A broken kernel has no governor of the
//! specification around it, so a small one of this file asks it, which knows the canonical channels and nothing more.
//! A case counts only when the small governor around the kernel of production answers as the specification's does on
//! these very steps, and around the broken kernel answers something else, by more than a peer's rounding may. So the
//! difference is the kernel's.

use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind};

use ncp_kernel::{Channel, Decision, Limit, Plan, Reason};
use ncp_spec::safety::{METRES, METRES_PER_SECOND, POSITION_CHANNEL, SafetyGovernor, VELOCITY_CHANNEL};
use ncp_spec::wire::{
    ChannelKind, ChannelMap, ChannelSpec, ChannelValue, CommandFrame, Mode, SafetyLimits, SensorFrame,
};
use serde_json::{Value, json};

use super::{Calls, Inputs, WhyNone, number, optional_number};
use crate::kernel::{Kernel, Production};

/// A channel of a tick: its name, its components and its unit.
pub type Setpoint = (&'static str, Vec<f64>, &'static str);
/// The channels of a tick.
pub type Tick = Vec<Setpoint>;

/// A channel beside the velocity's.
const OTHER: &str = "other_setpoint";
/// A unit that is not the velocity's.
const OTHER_UNIT: &str = "rad/s";

/// A step of a trace.
#[derive(Debug, Clone)]
pub enum Step {
    /// A command at the governor.
    Govern(Box<Command>),
    /// News of the link: whether there was a burst.
    NoteLink(bool),
    /// A reset.
    Reset,
}

/// A command, and what the governor knows when it comes.
#[derive(Debug, Clone)]
pub struct Command {
    mode: Mode,
    ttl: f64,
    dt: Option<f64>,
    ticks: Vec<Tick>,
    now: f64,
    last: Option<f64>,
    position: Option<[f64; 3]>,
}

/// The arguments of `governor.run`.
#[derive(Debug, Clone)]
pub struct Trace {
    speed: Option<f64>,
    radius: Option<f64>,
    timeout: f64,
    /// Whether the velocity and the position were negotiated; none: the canonical channels.
    binds: Option<[bool; 2]>,
    steps: Vec<Step>,
}

/// A case that the kernel behind the calls fails, of traces that a counterexample suggests.
///
/// # Errors
/// There are no such traces, or no trace shows it.
pub(super) fn case(property: &str, check: &str, calls: &Calls, inputs: &Inputs<'_>) -> Result<Value, WhyNone> {
    let mut none = WhyNone::NoCall;
    for trace in traces(property, check, inputs).unwrap_or_default() {
        let Some(broken) = (calls.governor)(&trace) else {
            continue;
        };
        match shown(&trace, &broken) {
            Ok(case) => return Ok(case),
            Err(why) => none = none.max(why),
        }
    }
    Err(none)
}

/// The case of a trace, if these answers are none that it lets pass.
fn shown(trace: &Trace, broken: &[Value]) -> Result<Value, WhyNone> {
    let expected = answers(trace);
    if run::<Production>(trace).as_ref() != Some(&expected) {
        return Err(WhyNone::NoCall);
    }
    let mut patterns = Vec::new();
    let mut differs = false;
    for ((step, answer), broken) in trace.steps.iter().zip(&expected).zip(broken) {
        let allowed = alternatives(trace, step, answer);
        differs |= allowed.iter().all(|allowed| is_apart(allowed, broken));
        patterns.push(match <[Value; 1]>::try_from(allowed) {
            Ok([only]) => only,
            Err(several) => json!({ "$any": several }),
        });
    }
    if !differs {
        let is_alike = broken == expected;
        return Err(if is_alike { WhyNone::Alike } else { WhyNone::Rounding });
    }
    Ok(json!({
        "roles": ["commander"],
        "call": "governor.run",
        "args": trace.json(),
        "expect": { "relation": "pattern", "value": { "steps": patterns }, "tolerance": TOLERANCE },
    }))
}

/// What else the text lets a governor answer: it may cut off more steps of a horizon, and all of them where tick 0
/// alone may be sent.
fn alternatives(trace: &Trace, step: &Step, answer: &Value) -> Vec<Value> {
    let mut allowed = vec![answer.clone()];
    let Some(kept) = answer["frame"]["horizon"].as_array().map(Vec::len) else {
        return allowed;
    };
    let shortened = |to: usize| {
        let mut answer = answer.clone();
        if let Some(steps) = answer["frame"]["horizon"].as_array_mut() {
            steps.truncate(to);
        }
        answer
    };
    allowed.extend((1..kept).rev().map(shortened));
    if let (true, Step::Govern(command)) = (kept > 0, step) {
        let mut alone = command.clone();
        alone.ticks.truncate(1);
        let alone = Trace { steps: vec![Step::Govern(alone)], ..trace.clone() };
        if answers(&alone).iter().any(|answer| answer["frame"]["mode"] == "active") {
            allowed.push(shortened(0));
        }
    }
    allowed
}

/// How far a peer's numbers may be from those of a case.
const TOLERANCE: f64 = 1e-9;
/// How far a broken kernel's have to be.
const APART: f64 = 1e-6;

/// Whether two answers differ by more than rounding.
fn is_apart(a: &Value, b: &Value) -> bool {
    match (a, b) {
        (Value::Object(a), Value::Object(b)) => {
            a.len() != b.len() || a.iter().any(|(name, a)| b.get(name).is_none_or(|b| is_apart(a, b)))
        }
        (Value::Array(a), Value::Array(b)) => a.len() != b.len() || a.iter().zip(b).any(|(a, b)| is_apart(a, b)),
        _ => match (double(a), double(b)) {
            (Some(a), Some(b)) => (a - b).abs() > APART * a.abs().max(b.abs()).max(1.0),
            _ => a != b,
        },
    }
}

fn double(value: &Value) -> Option<f64> {
    value.as_f64().or_else(|| (value == "-0").then_some(0.0))
}

/// What the governor of the specification answers.
#[must_use]
pub fn answers(trace: &Trace) -> Vec<Value> {
    let limits = SafetyLimits {
        max_speed_mps: trace.speed,
        geofence_radius_m: trace.radius,
        command_timeout_ms: trace.timeout,
        ..SafetyLimits::default()
    };
    let mut governor = match trace.binds {
        None => SafetyGovernor::new(&limits),
        Some([velocity, position]) => SafetyGovernor::negotiated(
            &limits,
            &declared(position, POSITION_CHANNEL, METRES),
            &declared(velocity, VELOCITY_CHANNEL, METRES_PER_SECOND),
        ),
    };
    let steps = trace.steps.iter().map(|step| match step {
        Step::Govern(given) => {
            let mut ticks = given.ticks.iter().map(channels);
            let mut command = CommandFrame {
                seq: 1,
                mode: given.mode,
                ttl_ms: given.ttl,
                channels: ticks.next().unwrap_or_default(),
                horizon: ticks.collect(),
                horizon_dt_ms: given.dt,
                ..CommandFrame::default()
            };
            let sensor = given.sensor();
            governor.govern(&mut command, given.now, Some(&sensor), given.last);
            frame(&command.mode, &command.channels, &command.horizon)
        }
        Step::NoteLink(burst) => {
            governor.note_link(*burst);
            json!({})
        }
        Step::Reset => {
            governor.reset();
            json!({})
        }
    });
    steps.collect()
}

fn declared(is_declared: bool, name: &'static str, unit: &'static str) -> Vec<ChannelSpec> {
    let spec =
        ChannelSpec { name: name.into(), kind: ChannelKind::Vec3, unit: Some(unit.into()), ..ChannelSpec::default() };
    is_declared.then_some(spec).into_iter().collect()
}

fn channels(tick: &Tick) -> ChannelMap {
    let mut map = ChannelMap::new();
    for (name, data, unit) in tick {
        map.insert(*name, ChannelValue::new(data.clone(), *unit));
    }
    map
}

/// What of a frame a case looks at.
fn frame(mode: &Mode, channels: &ChannelMap, horizon: &[ChannelMap]) -> Value {
    let shown = |map: &ChannelMap| -> Value {
        let channels = map.iter().map(|(name, channel)| {
            let data: Vec<Value> = channel.data.iter().map(|x| number(*x)).collect();
            (name.to_string(), json!({ "data": data, "unit": channel.unit }))
        });
        channels.collect::<serde_json::Map<_, _>>().into()
    };
    let horizon: Vec<Value> = horizon.iter().map(shown).collect();
    json!({ "frame": { "mode": mode.as_str(), "channels": shown(channels), "horizon": horizon } })
}

/// What a small governor around a kernel answers; none if the kernel panics or does not end.
#[must_use]
pub fn run<K: Kernel>(trace: &Trace) -> Option<Vec<Value>> {
    catch_unwind(AssertUnwindSafe(|| govern::<K>(trace))).ok()
}

fn govern<K: Kernel>(trace: &Trace) -> Vec<Value> {
    let mut gates = K::gates(trace.speed, trace.radius, trace.timeout);
    let mut negotiated = true;
    if let Some([velocity, position]) = trace.binds {
        K::gates_bind(&mut gates, velocity, position);
        negotiated = velocity;
    }
    let steps = trace.steps.iter().map(|step| match step {
        Step::Govern(command) => {
            let mut plan =
                Ticks::<K> { command: (**command).clone(), asked: Cell::new(0), kernel: std::marker::PhantomData };
            let (now, last, position) = (command.now, command.last, command.position);
            let decision = K::gates_govern(&mut gates, &mut plan, now, last, position);
            let mut ticks: Vec<ChannelMap> = plan.command.ticks.iter().map(channels).collect();
            let mode = match decision {
                Decision::Passed | Decision::Limited => plan.command.mode,
                Decision::Held(_) => Mode::Hold,
                Decision::Stopped(_) => Mode::Estop,
            };
            if matches!(decision, Decision::Held(_) | Decision::Stopped(_)) {
                ticks.truncate(1);
                for channel in ticks.iter_mut().flat_map(ChannelMap::values_mut) {
                    channel.data.fill(0.0);
                }
                if let Some(first) = ticks.first_mut()
                    && negotiated
                    && first.get(VELOCITY_CHANNEL).is_none()
                {
                    first.insert(VELOCITY_CHANNEL, ChannelValue::new([0.0; 3], METRES_PER_SECOND));
                }
            }
            let (first, horizon) = ticks.split_first().unzip();
            let none = ChannelMap::new();
            frame(&mode, first.unwrap_or(&none), horizon.unwrap_or_default())
        }
        Step::NoteLink(burst) => {
            K::gates_note_link(&mut gates, *burst);
            json!({})
        }
        Step::Reset => {
            K::gates_reset(&mut gates);
            json!({})
        }
    });
    steps.collect()
}

/// A command as a kernel sees it.
struct Ticks<K> {
    command: Command,
    /// How often the kernel has asked; one that asks without end is ended.
    asked: Cell<u32>,
    kernel: std::marker::PhantomData<K>,
}

impl<K> Ticks<K> {
    fn ask(&self) {
        self.asked.set(self.asked.get() + 1);
        assert!(self.asked.get() < 10_000, "the kernel does not end");
    }
}

impl<K: Kernel> Plan<f64> for Ticks<K> {
    fn mode(&self) -> Mode {
        self.command.mode
    }
    fn ttl_ms(&self) -> f64 {
        self.command.ttl
    }
    fn dt_ms(&self) -> Option<f64> {
        self.command.dt
    }
    fn steps(&self) -> usize {
        self.ask();
        self.command.ticks.len().saturating_sub(1)
    }
    fn limit(&mut self, tick: usize, max_mps: Limit<f64>) -> Result<bool, Reason> {
        self.ask();
        let tick = self.command.ticks.get_mut(tick).ok_or(Reason::NoVelocity)?;
        let channels = tick.iter_mut().map(|(name, data, unit)| Channel {
            is_velocity: *name == VELOCITY_CHANNEL,
            in_mps: *unit == METRES_PER_SECOND,
            data,
        });
        K::limit_tick(channels, max_mps)
    }
    fn velocity(&self, tick: usize) -> Option<[f64; 3]> {
        self.ask();
        let tick = self.command.ticks.get(tick)?;
        let (_, data, unit) = tick.iter().find(|(name, ..)| *name == VELOCITY_CHANNEL)?;
        (*unit == METRES_PER_SECOND).then(|| data.as_slice().try_into().ok()).flatten()
    }
    fn truncate(&mut self, steps: usize) {
        self.command.ticks.truncate(steps + 1);
    }
}

impl Command {
    /// A command that nothing is wrong with: it stands still at the centre of the fence, in the clock's first second.
    fn still() -> Self {
        Self {
            mode: Mode::Active,
            ttl: 100.0,
            dt: None,
            ticks: vec![vec![velocity([0.0; 3])]],
            now: 1.0,
            last: Some(1.0),
            position: Some([0.0; 3]),
        }
    }

    fn at(position: [f64; 3]) -> Self {
        Self { position: Some(position), ..Self::still() }
    }

    fn of(tick: Tick) -> Self {
        Self { ticks: vec![tick], ..Self::still() }
    }

    fn step(self) -> Step {
        Step::Govern(Box::new(self))
    }

    fn sensor(&self) -> SensorFrame {
        let mut sensor = SensorFrame::default();
        if let Some(position) = self.position {
            let place = ChannelValue::new(position, METRES);
            sensor.channels.insert(POSITION_CHANNEL, place);
        }
        sensor
    }

    fn json(&self) -> Value {
        let tick = |tick: &Tick| -> Value {
            let channels = tick.iter().map(|(name, data, unit)| {
                let data: Vec<Value> = data.iter().map(|x| number(*x)).collect();
                ((*name).to_owned(), json!({ "data": data, "unit": unit }))
            });
            channels.collect::<serde_json::Map<_, _>>().into()
        };
        let mut ticks = self.ticks.iter().map(tick);
        let first = ticks.next().unwrap_or_else(|| json!({}));
        let position = self.position.map(|axes| axes.map(number));
        let place = position.map(|data| json!({ POSITION_CHANNEL: { "data": data, "unit": METRES } }));
        json!({
            "op": "govern",
            "command": {
                "seq": 1, "mode": self.mode.as_str(), "ttl_ms": number(self.ttl), "channels": first,
                "horizon": ticks.collect::<Vec<_>>(), "horizon_dt_ms": optional_number(self.dt),
            },
            "now_s": number(self.now),
            "sensor": { "channels": place.unwrap_or_else(|| json!({})) },
            "last_sensor_s": optional_number(self.last),
        })
    }
}

impl Trace {
    fn of(speed: Option<f64>, radius: Option<f64>, steps: Vec<Step>) -> Self {
        Self { speed, radius, timeout: 500.0, binds: None, steps }
    }

    fn json(&self) -> Value {
        let spec = |declared: Vec<ChannelSpec>| -> Vec<Value> {
            let spec = |spec: ChannelSpec| json!({ "name": spec.name, "kind": "vec3", "unit": spec.unit });
            declared.into_iter().map(spec).collect()
        };
        let capabilities = self.binds.map(|[velocity, position]| {
            json!({
                "sensor_channels": spec(declared(position, POSITION_CHANNEL, METRES)),
                "command_channels": spec(declared(velocity, VELOCITY_CHANNEL, METRES_PER_SECOND)),
            })
        });
        let steps = self.steps.iter().map(|step| match step {
            Step::Govern(command) => command.json(),
            Step::NoteLink(burst) => json!({ "op": "note_link", "burst": burst }),
            Step::Reset => json!({ "op": "reset" }),
        });
        json!({
            "limits": {
                "max_speed_mps": optional_number(self.speed),
                "max_tilt_rad": null,
                "geofence_radius_m": optional_number(self.radius),
                "command_timeout_ms": number(self.timeout),
            },
            "capabilities": capabilities,
            "steps": steps.collect::<Vec<_>>(),
        })
    }
}

fn velocity(data: [f64; 3]) -> Setpoint {
    (VELOCITY_CHANNEL, data.to_vec(), METRES_PER_SECOND)
}

/// Traces on which the kernel has to decide as in a counterexample, by its inputs.
fn traces(property: &str, check: &str, inputs: &Inputs<'_>) -> Option<Vec<Trace>> {
    Some(match property {
        "watchdog/deadline" if !check.starts_with("alive") => {
            let command = Command { now: inputs.double("now")?, last: inputs.double("received"), ..Command::still() };
            vec![Trace { timeout: inputs.double("ttl")?, ..Trace::of(None, None, vec![command.step()]) }]
        }
        "geofence/inside" => {
            let position = inputs.vector("position")?;
            let radius = inputs.double("radius");
            vec![Trace::of(None, radius, vec![Command::at(position).step()])]
        }
        "geofence/limit" => {
            let value = inputs.optional("value")?;
            let fast = Command::of(vec![velocity([3.0, 0.0, 4.0])]);
            let far = Command::at([1e300, 0.0, 0.0]);
            vec![
                Trace::of(value, None, vec![fast.step()]),
                Trace::of(None, value, vec![far.step()]),
                Trace::of(None, value, vec![Command::still().step()]),
            ]
        }
        "geofence/projection" | "geofence/projection-and-clamp" => vec![projection(inputs)?],
        "clamp/bound" | "clamp/unchanged" | "clamp/direction" => {
            let width = inputs.choice("width")? + 1;
            let axes = (0..width).map(|axis| inputs.double(&format!("v_{axis}")));
            let data = axes.collect::<Option<Vec<f64>>>()?;
            // The velocity is three wide; what is not goes beside it, where the same limit acts.
            let tick = match <[f64; 3]>::try_from(data) {
                Ok(data) => vec![velocity(data)],
                Err(data) => vec![velocity([0.0; 3]), (OTHER, data, METRES_PER_SECOND)],
            };
            vec![Trace::of(inputs.double("max"), None, vec![Command::of(tick).step()])]
        }
        "clamp/tick" => {
            let [named, first, second] =
                ["is_named", "velocity_in_mps", "other_in_mps"].map(|name| inputs.choice(name) == Some(1));
            let unit = |in_mps| {
                if in_mps { METRES_PER_SECOND } else { OTHER_UNIT }
            };
            let width = inputs.choice("width")? + 2;
            let data: Option<_> = (0..width).map(|axis| inputs.double(&format!("v_{axis}"))).collect();
            let name = if named { VELOCITY_CHANNEL } else { "a_setpoint" };
            let tick = vec![(name, data?, unit(first)), (OTHER, vec![inputs.double("w")?], unit(second))];
            let max = match inputs.choice("limit")? {
                0 => None,
                1 => inputs.double("max"),
                // A governor whose limit is faulty asks no tick.
                _ => return None,
            };
            vec![Trace::of(max, None, vec![Command::of(tick).step()])]
        }
        "latch/gates" => gates(inputs)?,
        "latch/sequence" => vec![sequence(inputs)],
        _ => return None,
    })
}

fn projection(inputs: &Inputs<'_>) -> Option<Trace> {
    let ticks = (0..=inputs.choice("steps")?).map(|tick| {
        if inputs.choice(&format!("has_velocity_{tick}"))? == 0 {
            return Some(Vec::new());
        }
        Some(vec![velocity(inputs.vector(&format!("v{tick}"))?)])
    });
    let command = Command {
        ttl: inputs.double("ttl")?,
        dt: inputs.optional("dt")?,
        ticks: ticks.collect::<Option<_>>()?,
        ..Command::at(inputs.vector("position")?)
    };
    let radius = inputs.double("radius");
    Some(Trace::of(inputs.double("max"), radius, vec![command.step()]))
}

fn gates(inputs: &Inputs<'_>) -> Option<Vec<Trace>> {
    let mode = super::mode(inputs.choice("mode")?)?;
    let position = match inputs.choice("has_position")? {
        0 => None,
        _ => Some(inputs.vector("position")?),
    };
    let asked =
        Command { mode, now: inputs.double("now")?, last: inputs.optional("last")?, position, ..Command::still() };
    // What comes after shows the latch: a command that nothing is wrong with.
    let after = Command { now: 0.0, last: Some(0.0), ..Command::still() };
    let is = |name| Some(inputs.choice(name)? == 1);
    let mut steps = vec![Step::NoteLink(is("was_stopped")?), asked.clone().step()];
    steps.extend([after.clone().step(), Step::NoteLink(is("burst").unwrap_or(false))]);
    steps.extend([after.clone().step(), Step::Reset, after.clone().step()]);
    let trace = Trace {
        timeout: inputs.double("timeout")?,
        binds: Some([is("binds_velocity")?, is("binds_position")?]),
        ..Trace::of(inputs.optional("speed")?, inputs.optional("radius")?, steps)
    };
    // The same command once more after a reset, whose decision ESTOP does not hide.
    let mut again = trace.clone();
    again.steps = vec![Step::NoteLink(false), asked.step()];
    // The same limits with a sensor frame that is fresh.
    let mut fresh = trace.clone();
    (fresh.timeout, fresh.steps) = (500.0, vec![after.step()]);
    Some(vec![trace, again, fresh])
}

/// The events of the harness, each as it stands there.
fn sequence(inputs: &Inputs<'_>) -> Trace {
    let home = [0.0; 3];
    let command = |mode, last, position| Command { mode, ttl: 500.0, now: 3.0, last, position, ..Command::still() };
    let events = inputs.choices("event").into_iter().map(|event| match event {
        0 => command(Mode::Active, Some(3.0), Some(home)).step(),
        1 => command(Mode::Active, Some(3.0), Some([11.0, 0.0, 0.0])).step(),
        2 => command(Mode::Active, Some(3.0), None).step(),
        3 => command(Mode::Active, None, Some(home)).step(),
        4 => command(Mode::Hold, Some(3.0), Some(home)).step(),
        5 => command(Mode::Estop, None, None).step(),
        6 => Step::NoteLink(true),
        7 => Step::NoteLink(false),
        _ => Step::Reset,
    });
    let mut steps: Vec<Step> = events.collect();
    // The latch shows at the next command.
    steps.push(command(Mode::Active, Some(3.0), Some(home)).step());
    Trace::of(Some(10.0), Some(10.0), steps)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::harness::harness;
    use crate::properties::PROPERTIES;

    #[test]
    fn the_small_governor_answers_as_that_of_the_specification() {
        let mut moving = 0;
        for property in PROPERTIES {
            let harness = harness::<Production>(property.id).unwrap();
            for seed in 0..300 {
                let found = super::super::tests::sampled(&harness, seed);
                let traces = traces(property.id, "", &Inputs(&found)).unwrap_or_default();
                for trace in traces {
                    let expected = answers(&trace);
                    assert_eq!(run::<Production>(&trace).unwrap(), expected, "{trace:?}");
                    let moves = |answer: &Value| answer["frame"]["mode"] == "active";
                    moving += usize::from(expected.iter().any(moves));
                }
            }
        }
        assert!(moving > 100, "{moving}");
    }

    #[test]
    fn a_governor_may_cut_off_more_of_a_horizon_and_never_less() {
        let step = |x| vec![velocity([x, 0.0, 0.0])];
        let command =
            Command { ttl: 300.0, dt: Some(100.0), ticks: vec![step(1.0), step(1.0), step(100.0)], ..Command::still() };
        let trace = Trace::of(None, Some(5.0), vec![command.step()]);
        let expected = answers(&trace);
        let kept = |answer: &Value| answer["frame"]["horizon"].as_array().unwrap().len();
        let allowed = alternatives(&trace, &trace.steps[0], &expected[0]);
        assert_eq!(allowed.iter().map(kept).collect::<Vec<_>>(), [1, 0]);
        let mut longer = expected.clone();
        longer[0]["frame"]["horizon"] = json!([{}, {}]);
        assert!(shown(&trace, &longer).is_ok());
        let mut shorter = expected.clone();
        shorter[0]["frame"]["horizon"] = json!([]);
        assert_eq!(shown(&trace, &shorter), Err(WhyNone::Rounding));
        assert_eq!(shown(&trace, &expected), Err(WhyNone::Alike));
    }

    #[test]
    fn numbers_within_rounding_are_not_apart() {
        assert!(!is_apart(&json!([1.0, "-0"]), &json!([1.000_000_000_1, 0.0])));
        assert!(is_apart(&json!({ "x": 1.0 }), &json!({ "x": 1.001 })));
        assert!(is_apart(&json!("NaN"), &json!(0.0)));
    }
}
