//! A governor in plain arithmetic, written from chapter 7 and from nothing else.
//!
//! It answers what the text demands and, where the text leaves a choice, every answer that it
//! allows: a governor may look further ahead, and drop more of a horizon than it must.

use std::collections::BTreeSet;

use crate::command::{Channel, Command, M, MPS, POSITION, VELOCITY, channel, channels, channels_json};
use crate::json::{Json, object};
use crate::scenario::{self, Place, Row, ScenarioError};
use crate::trace::{any, beginning, exactly, int, num, nums, refused};

/// The fields of `SafetyLimits`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Limits {
    pub(crate) speed: Option<f64>,
    pub(crate) fence: Option<f64>,
    pub(crate) timeout: f64,
    pub(crate) tilt: Option<f64>,
}

impl Limits {
    pub(super) const NONE: Self = Self { speed: None, fence: None, timeout: 500.0, tilt: None };

    pub(super) const fn speed(speed: f64) -> Self {
        Self { speed: Some(speed), ..Self::NONE }
    }

    pub(super) const fn fence(fence: f64) -> Self {
        Self { fence: Some(fence), ..Self::NONE }
    }

    pub(super) const fn both(speed: f64, fence: f64) -> Self {
        Self { speed: Some(speed), fence: Some(fence), ..Self::NONE }
    }

    /// With those of a step.
    pub(super) fn set(mut self, step: &scenario::Step) -> Result<Self, ScenarioError> {
        for word in step.words() {
            let (name, value) = word.split_once('=').unwrap_or((word, ""));
            let value = || if value == "-" { Ok(None) } else { step.place.double(value).map(Some) };
            match name {
                "speed" => self.speed = value()?,
                "fence" => self.fence = value()?,
                "tilt" => self.tilt = value()?,
                "timeout" => self.timeout = value()?.unwrap_or(self.timeout),
                _ => return Err(step.place.wants("limit", word)),
            }
        }
        Ok(self)
    }

    fn json(self) -> Json {
        object! {
            "max_speed_mps" => self.speed.map(num),
            "max_tilt_rad" => self.tilt.map(num),
            "geofence_radius_m" => self.fence.map(num),
            "command_timeout_ms" => num(self.timeout),
        }
    }
}

/// The fields of a sensor frame.
#[derive(Debug, Clone)]
pub(crate) struct Sensor {
    pub(crate) seq: i64,
    pub(crate) t: f64,
    pub(crate) channels: Vec<Channel>,
}

impl Sensor {
    pub(super) fn of(channels: Vec<Channel>) -> Self {
        Self { seq: 7, t: 40.0, channels }
    }

    /// At that position.
    pub(super) fn at(data: &[f64]) -> Self {
        Self::of(vec![channel(POSITION, data, Some(M))])
    }

    fn json(&self) -> Json {
        object! { "seq" => int(self.seq), "t" => num(self.t), "channels" => channels_json(&self.channels) }
    }

    fn is_writable(&self) -> bool {
        self.t.is_finite() && self.channels.iter().all(|c| c.is_finite())
    }
}

/// A declared channel.
#[derive(Debug, Clone)]
pub(crate) struct Spec {
    pub(crate) name: String,
    pub(crate) kind: &'static str,
    pub(crate) unit: Option<String>,
    pub(crate) size: Option<i64>,
    pub(crate) optional: Option<bool>,
}

pub(super) fn vec3(name: &str, unit: Option<&str>) -> Spec {
    Spec { name: name.to_owned(), kind: "vec3", unit: unit.map(str::to_owned), size: None, optional: None }
}

pub(super) fn scalar(name: &str, unit: Option<&str>) -> Spec {
    Spec { kind: "scalar", ..vec3(name, unit) }
}

impl Spec {
    fn json(&self) -> Json {
        let spec = object! { "name" => self.name.as_str(), "kind" => self.kind, "unit" => self.unit.as_deref(),
        "size" => self.size.map(int) };
        match self.optional {
            Some(optional) => spec.with("optional", Json::Bool(optional)),
            None => spec,
        }
    }
}

/// What was negotiated.
#[derive(Debug, Clone)]
pub(crate) struct Capabilities {
    pub(crate) sensors: Vec<Spec>,
    pub(crate) commands: Vec<Spec>,
}

impl Capabilities {
    /// The canonical channels, and further command channels.
    pub(super) fn canonical(more: &[Spec]) -> Self {
        let mut commands = vec![vec3(VELOCITY, Some(MPS))];
        commands.extend_from_slice(more);
        Self { sensors: vec![vec3(POSITION, Some(M))], commands }
    }

    fn json(&self) -> Json {
        object! {
            "sensor_channels" => self.sensors.iter().map(Spec::json).collect::<Json>(),
            "command_channels" => self.commands.iter().map(Spec::json).collect::<Json>(),
        }
    }
}

/// One step of a trace.
#[expect(clippy::large_enum_variant, reason = "nearly every step is of the large one")]
#[derive(Debug, Clone)]
pub(crate) enum Step {
    Govern { command: Command, now: f64, sensor: Option<Sensor>, last: Option<f64> },
    Link(bool),
    Reset,
}

/// A command with a fresh sensor: a quarter of a second old.
pub(super) fn govern(command: Command, sensor: Sensor) -> Step {
    Step::Govern { command, now: 10.25, sensor: Some(sensor), last: Some(10.0) }
}

/// Declared channels, each as its name and its unit, or its name, its kind and its unit.
fn specs(step: &scenario::Step) -> Result<Vec<Spec>, ScenarioError> {
    let unit = |unit: &str| (unit != "none").then(|| Json::read(unit).as_str().unwrap_or(unit).replace("\\s", " "));
    let spec = |word: &str| match word.split(':').collect::<Vec<_>>()[..] {
        [name] => Ok(vec3(name, None)),
        [name, of] => Ok(vec3(name, unit(of).as_deref())),
        [name, "scalar", of] => Ok(scalar(name, unit(of).as_deref())),
        [name, "optional", of] => Ok(Spec { optional: Some(true), ..vec3(name, unit(of).as_deref()) }),
        [name, "required", of] => Ok(Spec { optional: Some(false), ..vec3(name, unit(of).as_deref()) }),
        _ => Err(step.place.wants("declared channel", word)),
    };
    step.words().filter(|word| *word != "-").map(spec).collect()
}

/// What is sensed at a place, or the channels that are.
pub(super) fn sensed(place: Place, word: &str) -> Result<Sensor, ScenarioError> {
    Ok(Sensor::of(channels(place, word, |data| channel(POSITION, data, Some(M)))?))
}

impl Step {
    /// The step that a row says.
    pub(super) fn of(step: &scenario::Step) -> Result<Self, ScenarioError> {
        let place = step.place;
        match step.verb() {
            "govern" => {}
            "link" => return Ok(Self::Link(true)),
            "calm" => return Ok(Self::Link(false)),
            "reset" => return Ok(Self::Reset),
            verb => return Err(place.wants("step of a governor", verb)),
        }
        let (mut command, mut sensor) = (super::good(), Some(super::near()));
        let (mut now, mut last) = (10.25, Some(10.0));
        for word in step.words() {
            let (name, value) = word.split_once('=').unwrap_or((word, ""));
            match name {
                "at" if value == "none" => sensor = None,
                "at" => sensor = Some(sensed(place, value)?),
                "sent" => sensor = sensor.map(|sensor| Ok(Sensor { t: place.double(value)?, ..sensor })).transpose()?,
                "stamp" => {
                    let seq = value.parse().map_err(|_| place.wants("seq", value))?;
                    sensor = sensor.map(|sensor| Sensor { seq, ..sensor });
                }
                "now" => now = place.double(value)?,
                "last" => last = if value == "-" { None } else { Some(place.double(value)?) },
                _ if command.setting(place, name, value)? => {}
                _ => return Err(place.wants("setting of a governor", word)),
            }
        }
        Ok(Self::Govern { command, now, sensor, last })
    }

    fn json(&self) -> Json {
        match self {
            Self::Govern { command, now, sensor, last } => object! {
                "op" => "govern",
                "command" => command.fields(),
                "now_s" => num(*now),
                "sensor" => sensor.as_ref().map(Sensor::json),
                "last_sensor_s" => last.map(num),
            },
            Self::Link(burst) => object! { "op" => "note_link", "burst" => *burst },
            Self::Reset => object! { "op" => "reset" },
        }
    }
}

/// A governor and what it is asked.
#[derive(Debug, Clone)]
pub(crate) struct Trace {
    pub(crate) limits: Limits,
    pub(crate) capabilities: Option<Capabilities>,
    pub(crate) steps: Vec<Step>,
}

impl Trace {
    pub(super) fn new(limits: Limits, steps: Vec<Step>) -> Self {
        Self { limits, capabilities: None, steps }
    }

    pub(super) fn negotiated(limits: Limits, capabilities: Capabilities, steps: Vec<Step>) -> Self {
        Self { limits, capabilities: Some(capabilities), steps }
    }

    /// The trace that the steps of a row say: `limits` with `speed=`, `fence=`, `timeout=` and `tilt=`; `sensors` and
    /// `commands`, the channels that are declared, as `tow:m/s` or, if it is a scalar, `grip:scalar:N`; `govern`,
    /// which is a good command at a good place but for the settings of [`Command::setting`], `at=` for the place or
    /// the channels that are sensed, `sent=`, `now=` and `last=` for times; `link`, `calm` and `reset`. A hyphen is
    /// none of it.
    pub(super) fn of(row: &Row) -> Result<Self, ScenarioError> {
        let mut trace = Self::new(Limits::NONE, Vec::new());
        for step in row.steps() {
            match step.verb() {
                "limits" => trace.limits = trace.limits.set(&step)?,
                "sensors" => trace.declared().sensors = specs(&step)?,
                "commands" => trace.declared().commands = specs(&step)?,
                _ => {
                    let (times, round) = step.repeated();
                    let round = round.iter().map(Step::of).collect::<Result<Vec<_>, _>>()?;
                    trace.steps.extend(std::iter::repeat_n(round, times).flatten());
                }
            }
        }
        Ok(trace)
    }

    fn declared(&mut self) -> &mut Capabilities {
        self.capabilities.get_or_insert_with(|| Capabilities { sensors: Vec::new(), commands: Vec::new() })
    }

    /// The arguments of `governor.run`.
    pub(super) fn args(&self) -> Json {
        object! {
            "limits" => self.limits.json(),
            "capabilities" => self.capabilities.as_ref().map(Capabilities::json),
            "steps" => self.steps.iter().map(Step::json).collect::<Json>(),
        }
    }

    /// Whether JSON texts can hold the limits.
    pub(super) fn has_writable_limits(&self) -> bool {
        let finite = |value: Option<f64>| value.is_none_or(f64::is_finite);
        finite(self.limits.speed)
            && finite(self.limits.fence)
            && finite(self.limits.tilt)
            && self.limits.timeout.is_finite()
    }

    /// What the governor does at each `govern`, by the model.
    pub(super) fn outcomes(&self) -> Vec<Option<Vec<Outcome>>> {
        self.outcomes_by(Reading::PositionFirst, Silence::HOLDS)
    }

    /// Whether the text leaves a choice between the position and the mode.
    pub(super) fn is_open(&self) -> bool {
        self.outcomes() != self.outcomes_by(Reading::ModeOnly, Silence::HOLDS)
    }

    fn outcomes_by(&self, reading: Reading, silence: Silence) -> Vec<Option<Vec<Outcome>>> {
        let mut governor = Governor { silence, ..self.governor(reading) };
        self.steps.iter().map(|step| governor.step(step)).collect()
    }

    fn governor(&self, reading: Reading) -> Governor<'_> {
        Governor::new(self.limits, self.capabilities.as_ref(), reading)
    }

    /// The rule that decides each answer.
    pub(crate) fn rules(&self) -> Vec<Option<&'static str>> {
        let mut governor = self.governor(Reading::PositionFirst);
        let rule = |step| governor.step(step).map(|_| governor.said);
        self.steps.iter().map(rule).collect()
    }

    /// The places of channels that a command keeps while a clamp changes others; none where units are negotiated,
    /// since a clamp may change a channel without one.
    pub(super) fn kept(&self) -> Vec<String> {
        let mut places = Vec::new();
        if self.capabilities.is_some() {
            return places;
        }
        for (nth, (step, rule)) in self.steps.iter().zip(self.rules()).enumerate() {
            if let (Step::Govern { command, .. }, Some(CLAMPS)) = (step, rule) {
                let is_other = |channel: &&Channel| channel.unit.as_deref() != Some(MPS) && channel.name != VELOCITY;
                for channel in command.channels.iter().filter(is_other) {
                    places.push(format!("/steps/{nth}/frame/channels/{}", channel.name));
                }
                let others: BTreeSet<&str> =
                    command.horizon.iter().flatten().filter(is_other).map(|channel| channel.name.as_str()).collect();
                places.extend(others.iter().map(|name| format!("/steps/{nth}/frame/horizon/*/{name}")));
            }
        }
        places
    }

    /// The pattern of the result.
    pub(crate) fn pattern(&self) -> Json {
        let mut patterns = Vec::new();
        for silence in self.silences() {
            for reading in Reading::ALL {
                let pattern = self.pattern_by(reading, silence);
                if !patterns.contains(&pattern) {
                    patterns.push(pattern);
                }
            }
        }
        any(patterns)
    }

    /// After which silences of the sensor a governor may stop in this trace, and that it may not do so.
    fn silences(&self) -> Vec<Silence> {
        let mut all = vec![Silence::HOLDS];
        for step in &self.steps {
            if let Step::Govern { now, last: Some(last), .. } = step
                && Silence::may_stop(now - last, self.limits.timeout)
                && !all.contains(&Silence(now - last))
            {
                all.push(Silence(now - last));
            }
        }
        all
    }

    fn pattern_by(&self, reading: Reading, silence: Silence) -> Json {
        let governor = self.governor(reading);
        let mut entries = Vec::new();
        // After a sensor that a JSON text cannot hold, nobody knows whether ESTOP was latched.
        let mut is_known = true;
        for (step, outcomes) in self.steps.iter().zip(self.outcomes_by(reading, silence)) {
            let (Step::Govern { command, sensor, .. }, Some(outcomes)) = (step, outcomes) else {
                is_known |= matches!(step, Step::Reset);
                entries.push(Json::object());
                continue;
            };
            if !is_known {
                entries.push(Json::object());
                continue;
            }
            let may_refuse = !command.is_writable()
                || sensor.as_ref().is_some_and(|sensor| !sensor.is_writable())
                || !self.has_writable_limits();
            is_known = sensor.as_ref().is_none_or(Sensor::is_writable);
            let mut patterns: Vec<Json> =
                outcomes.iter().map(|outcome| object! { "frame" => outcome.pattern(command, &governor) }).collect();
            if may_refuse {
                patterns.push(refused());
            }
            entries.push(any(patterns));
        }
        crate::trace::steps(entries)
    }
}

/// What may come of a command.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Outcome {
    Estop,
    Hold,
    Pass {
        channels: Vec<Channel>,
        horizon: Vec<Vec<Channel>>,
    },
    /// It passes with the first steps of this horizon, one at least.
    Begin {
        channels: Vec<Channel>,
        horizon: Vec<Vec<Channel>>,
    },
}

/// The most steps for which each length is an outcome of its own.
const SHORT: usize = 16;

impl Outcome {
    /// A frame that holds is told by its mode; what else it holds is asked in `zeroing` alone, so that a
    /// fault there does not fail every case.
    fn pattern(&self, command: &Command, governor: &Governor<'_>) -> Json {
        let passed = |channels: &[Channel]| {
            let value = |channel: &Channel| {
                let unit = match channel.unit.as_deref() {
                    Some(unit) => unit.into(),
                    // Left out as it was, or written down as it is read.
                    None => any(std::iter::once(Json::Null).chain(governor.unit(channel).map(Json::from)).collect()),
                };
                let value = object! { "data" => nums(&channel.data), "unit" => unit };
                (channel.name.clone(), value)
            };
            exactly(Json::Object(channels.iter().map(value).collect()))
        };
        let (channels, horizon) = match self {
            Self::Estop => return object! { "mode" => "estop" },
            Self::Hold => return object! { "mode" => "hold" },
            Self::Pass { channels, horizon } => {
                (passed(channels), horizon.iter().map(|step| passed(step)).collect::<Json>())
            }
            Self::Begin { channels, horizon } => {
                (passed(channels), beginning(horizon.iter().map(|step| passed(step)).collect()))
            }
        };
        object! {
            "mode" => "active",
            "seq" => command.seq.map(int),
            "t" => num(command.t),
            "frame_id" => command.frame_id,
            "ttl_ms" => num(command.ttl),
            "channels" => channels,
            "horizon" => horizon,
        }
    }
}

/// In what order a governor looks at the position and at the mode, of a command that is not active.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Reading {
    /// The position, which latches ESTOP.
    PositionFirst,
    /// The mode, while the position latches all the same.
    ModeFirst,
    /// The mode, and then nothing else.
    ModeOnly,
}

impl Reading {
    const ALL: [Self; 3] = [Self::PositionFirst, Self::ModeFirst, Self::ModeOnly];
}

/// The silence of the sensor, in seconds, from which on a governor latches ESTOP instead of holding.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Silence(f64);

impl Silence {
    /// It always holds.
    const HOLDS: Self = Self(f64::INFINITY);

    /// Whether the text lets it stop: only after more than two time-outs.
    fn may_stop(age: f64, timeout: f64) -> bool {
        age.is_finite() && timeout.is_finite() && timeout > 0.0 && age * 1000.0 > 2.0 * timeout
    }
}

struct Governor<'a> {
    reading: Reading,
    silence: Silence,
    limits: Limits,
    capabilities: Option<&'a Capabilities>,
    /// The rule by which it is in config fail-closed.
    fault: Option<&'static str>,
    /// The rule by which ESTOP is latched.
    latched: Option<&'static str>,
    /// The rule of what has happened since the last command, if a command can tell.
    happened: Option<&'static str>,
    /// The rule that decided the last answer, and whether that was a HOLD.
    said: &'static str,
    held: bool,
}

impl<'a> Governor<'a> {
    fn new(limits: Limits, capabilities: Option<&'a Capabilities>, reading: Reading) -> Self {
        let broken = |limit: Option<f64>| limit.is_some_and(|limit| !limit.is_finite() || limit < 0.0);
        let named = |specs: &[Spec], name: &str| specs.iter().any(|spec| spec.name == name);
        // Each declaration of a channel counts.
        let declared = |specs: &[Spec], name: &str, unit: &str| {
            let mut of_it = specs.iter().filter(|spec| spec.name == name);
            named(specs, name) && of_it.all(|spec| spec.unit.as_deref() == Some(unit))
        };
        let unbound = capabilities.is_some_and(|capabilities| {
            enabled(limits.fence).is_some() && !declared(&capabilities.sensors, POSITION, M)
                || enabled(limits.speed).is_some() && !declared(&capabilities.commands, VELOCITY, MPS)
        });
        let unnamed = capabilities.is_some_and(|capabilities| {
            enabled(limits.fence).is_some() && !named(&capabilities.sensors, POSITION)
                || enabled(limits.speed).is_some() && !named(&capabilities.commands, VELOCITY)
        });
        let fault = if broken(limits.speed) || broken(limits.fence) {
            Some("NCP-SAFE-013")
        } else {
            unbound.then_some(if unnamed { "NCP-SAFE-014" } else { "NCP-SAFE-015" })
        };
        Self {
            reading,
            silence: Silence::HOLDS,
            limits,
            capabilities,
            fault,
            latched: None,
            happened: None,
            said: "",
            held: false,
        }
    }

    fn step(&mut self, step: &Step) -> Option<Vec<Outcome>> {
        match step {
            Step::Link(true) => {
                self.latch("NCP-SAFE-006");
                None
            }
            Step::Link(false) => {
                // Of a latch that no command has shown yet, the rule is what latched.
                if self.latched.is_none_or(|rule| rule == LATCHED) {
                    self.happened = Some("NCP-SAFE-007");
                }
                None
            }
            Step::Reset => {
                let cleared = self.latched.take().map(|_| "NCP-SAFE-008");
                let stays = self.fault.map(|_| "NCP-SAFE-009");
                self.happened = cleared.or(stays).or(self.happened);
                None
            }
            Step::Govern { command, now, sensor, last } => {
                let was_latched = self.latched.is_some();
                let outcomes = self.govern(command, *now, sensor.as_ref(), *last);
                let held = std::mem::replace(&mut self.held, outcomes == [Outcome::Hold]);
                match (self.happened.take(), self.said) {
                    (Some(happened), PASSES | LATCHED | FAULTY) => self.said = happened,
                    (None, PASSES) if held => self.said = "NCP-SAFE-022",
                    _ => {}
                }
                if was_latched {
                    self.latched = Some(LATCHED);
                }
                Some(outcomes)
            }
        }
    }

    fn latch(&mut self, rule: &'static str) {
        if self.latched.is_none() {
            self.latched = Some(rule);
            self.happened = None;
        }
    }

    /// A HOLD by a rule.
    fn hold(&mut self, rule: &'static str) -> Vec<Outcome> {
        self.said = rule;
        vec![Outcome::Hold]
    }

    /// The gates of section 7.3, in their order.
    fn govern(&mut self, command: &Command, now: f64, sensor: Option<&Sensor>, last: Option<f64>) -> Vec<Outcome> {
        if let Some(latched) = self.latched {
            self.said = latched;
            return vec![Outcome::Estop];
        }
        if command.is("estop") {
            self.latch("NCP-SAFE-004");
            self.said = "NCP-SAFE-003";
            return vec![Outcome::Estop];
        }
        if let Some(fault) = self.fault {
            // That it stays is another rule than that it comes.
            self.fault = Some(FAULTY);
            return self.hold(fault);
        }
        if let Some(stale) = self.stale(now, last) {
            let age = last.map_or(f64::NAN, |last| now - last);
            if stale == STALE && Silence::may_stop(age, self.limits.timeout) && age >= self.silence.0 {
                self.latch(stale);
                return vec![Outcome::Estop];
            }
            return self.hold(stale);
        }
        let mut place = None;
        if let Some(radius) = enabled(self.limits.fence) {
            let found = sensor.and_then(|sensor| sensor.channels.iter().find(|c| c.name == POSITION));
            let usable = found.filter(|c| c.unit.as_deref().is_none_or(|unit| unit == M) && c.data.len() == 3);
            let Some(position) = usable else {
                let other_unit = found.is_some_and(|c| c.unit.as_deref().is_some_and(|unit| unit != M));
                return self.hold(if other_unit { "NCP-SAFE-041" } else { "NCP-SAFE-040" });
            };
            if !inside(&position.data, radius) {
                let waits = !command.is("active");
                let rule = if norm(&position.data).is_finite() { "NCP-SAFE-043" } else { "NCP-SAFE-044" };
                self.said = if waits { "NCP-SAFE-020" } else { rule };
                if !(waits && self.reading == Reading::ModeOnly) {
                    self.latched = Some(rule);
                }
                return vec![if waits && self.reading != Reading::PositionFirst {
                    Outcome::Hold
                } else {
                    Outcome::Estop
                }];
            }
            place = Some((position.data.clone(), radius));
        }
        if !command.is("active") {
            return self.hold("NCP-SAFE-002");
        }
        let Some(channels) = self.clamped(&command.channels) else {
            let finite = command.channels.iter().all(Channel::is_finite);
            return self.hold(if finite { "NCP-SAFE-063" } else { "NCP-SAFE-064" });
        };
        let mut horizon = Vec::new();
        if !command.horizon.is_empty() {
            if !command.dt.is_some_and(|dt| dt.is_finite() && dt > 0.0) {
                return self.hold("NCP-SAFE-068");
            }
            for step in &command.horizon {
                let Some(step) = self.clamped(step) else {
                    break;
                };
                horizon.push(step);
            }
        }
        let wide = |channels: &[Channel], name: &str| {
            channels.iter().any(|channel| channel.name == name && channel.data.len() != 3)
        };
        // A velocity or a position that is not 3 wide may be held for, though no limit needs it.
        let odd = wide(&channels, VELOCITY) || sensor.is_some_and(|sensor| wide(&sensor.channels, POSITION));
        let clamps = channels.iter().zip(&command.channels).any(|(after, before)| after.data != before.data);
        self.said = if clamps { CLAMPS } else { PASSES };
        let mut outcomes = match place {
            Some((place, radius)) => {
                let outcomes = self.project(command, &channels, &horizon, &place, radius);
                if outcomes == [Outcome::Hold] {
                    let first = command.dt.filter(|_| !command.horizon.is_empty()).map_or(f64::INFINITY, |dt| dt);
                    let ms = first.min(command.ttl).min(60_000.0);
                    self.said = match self.velocity(&channels) {
                        None => "NCP-SAFE-052",
                        // Tick 0 stays inside, but for all of the ttl it does not.
                        Some(v) if first < command.ttl && inside(&moved(&place, &v, ms), radius) => "NCP-SAFE-053",
                        Some(_) => "NCP-SAFE-051",
                    };
                }
                outcomes
            }
            None => vec![Outcome::Pass { channels, horizon }],
        };
        // So may a component of a step that is not finite, though it is enough to truncate before that step.
        let strange = !command.horizon.iter().flatten().all(|c| c.is_finite());
        if (odd || strange) && !outcomes.contains(&Outcome::Hold) {
            outcomes.push(Outcome::Hold);
        }
        outcomes
    }

    /// The rule by which the sensor is stale, if it is.
    fn stale(&self, now: f64, last: Option<f64>) -> Option<&'static str> {
        let timeout = self.limits.timeout;
        let Some(last) = last else {
            return Some("NCP-SAFE-030");
        };
        if !(now.is_finite() && last.is_finite()) {
            Some("NCP-SAFE-031")
        } else if !(timeout.is_finite() && timeout > 0.0) {
            Some("NCP-SAFE-032")
        } else if now < last {
            Some("NCP-SAFE-035")
        } else {
            ((now - last) * 1000.0 > timeout).then_some(STALE)
        }
    }

    /// The unit in which a channel is read: its own, or else the negotiated one.
    fn unit<'c>(&'c self, channel: &'c Channel) -> Option<&'c str> {
        channel.unit.as_deref().or_else(|| match self.capabilities {
            Some(capabilities) => capabilities.commands.iter().find(|spec| spec.name == channel.name)?.unit.as_deref(),
            None => (channel.name == VELOCITY).then_some(MPS),
        })
    }

    /// The velocity that the plant would follow.
    fn velocity(&self, channels: &[Channel]) -> Option<Vec<f64>> {
        let channel = channels.iter().find(|channel| channel.name == VELOCITY)?;
        let usable = self.unit(channel) == Some(MPS) && channel.data.len() == 3 && channel.is_finite();
        usable.then(|| channel.data.clone())
    }

    /// The channels of a tick within the speed limit; none when that cannot be.
    fn clamped(&self, channels: &[Channel]) -> Option<Vec<Channel>> {
        if !channels.iter().all(|channel| channel.is_finite()) {
            return None;
        }
        let Some(most) = enabled(self.limits.speed) else {
            return Some(channels.to_vec());
        };
        self.velocity(channels)?;
        let clamp = |channel: &Channel| {
            let mut channel = channel.clone();
            if self.unit(&channel) == Some(MPS) && !is_within(&channel.data, most) {
                let (length, scale) = scaled_norm(&channel.data);
                channel.data = channel.data.iter().map(|x| x * scale / length * most).collect();
            }
            channel
        };
        Some(channels.iter().map(clamp).collect())
    }

    /// The look ahead of section 7.5.
    fn project(
        &self,
        command: &Command,
        channels: &[Channel],
        horizon: &[Vec<Channel>],
        place: &[f64],
        radius: f64,
    ) -> Vec<Outcome> {
        let Some(first) = self.velocity(channels) else {
            return vec![Outcome::Hold];
        };
        let ttl = if command.ttl.is_finite() && command.ttl > 0.0 { command.ttl.min(60_000.0) } else { 0.0 };
        let after = |from: &[f64], velocity: &[f64], ms: f64| -> Vec<f64> {
            from.iter().zip(velocity).map(|(p, v)| p + v * (ms / 1000.0)).collect()
        };
        let pass = |kept: usize| Outcome::Pass {
            channels: channels.to_vec(),
            horizon: horizon.get(..kept).unwrap_or_default().to_vec(),
        };
        // What comes of a governor that drops the horizon whole.
        let without = if inside(&after(place, &first, ttl), radius) { pass(0) } else { Outcome::Hold };
        let Some(dt) = command.dt.filter(|_| !command.horizon.is_empty()) else {
            return vec![without];
        };
        let mut at = place.to_vec();
        // Where each step leads that is followed for the whole of its tick, also behind the end of the ttl.
        let mut ahead = place.to_vec();
        let mut stays = true;
        let mut start = 0.0;
        let mut kept = 0;
        let mut unusable = false;
        for (tick, step) in std::iter::once(channels).chain(horizon.iter().map(Vec::as_slice)).enumerate() {
            let Some(velocity) = self.velocity(step) else {
                unusable = true;
                break;
            };
            let share = (ttl - start).clamp(0.0, dt);
            at = after(&at, &velocity, share);
            ahead = after(&ahead, &velocity, dt);
            stays &= inside(&ahead, radius * (1.0 - 1e-9));
            if !inside(&at, radius) {
                if tick == 0 {
                    return vec![Outcome::Hold];
                }
                break;
            }
            kept = tick;
            start += dt;
        }
        // A horizon of which each step ends inside, those behind the ttl too, is shortened by nobody [NCP-SAFE-021].
        if kept > 0 && kept == horizon.len() && stays {
            return vec![pass(kept)];
        }
        let mut outcomes: Vec<_> = match pass(kept) {
            Outcome::Pass { channels, horizon } if kept > SHORT => vec![Outcome::Begin { channels, horizon }],
            _ => (1..=kept).rev().map(pass).collect(),
        };
        outcomes.push(without);
        // A step without a usable velocity may be held for as well.
        if unusable && !outcomes.contains(&Outcome::Hold) {
            outcomes.push(Outcome::Hold);
        }
        outcomes
    }
}

/// The rule by which a command passes.
pub(super) const PASSES: &str = "NCP-SAFE-021";
const CLAMPS: &str = "NCP-SAFE-060";
/// The rule by which a sensor is too old.
const STALE: &str = "NCP-SAFE-033";
/// The rule by which a latch goes on.
const LATCHED: &str = "NCP-SAFE-005";
/// The rule by which a config fail-closed goes on.
const FAULTY: &str = "NCP-SAFE-018";

fn enabled(limit: Option<f64>) -> Option<f64> {
    limit.filter(|limit| limit.is_finite() && *limit > 0.0)
}

fn finite(data: &[f64]) -> bool {
    data.iter().all(|x| x.is_finite())
}

/// The norm times a power of two, and that: the squares of the largest and the smallest doubles are none.
fn scaled_norm(data: &[f64]) -> (f64, f64) {
    let scale = match data.iter().fold(0.0_f64, |largest, x| largest.max(x.abs())) {
        ..1e-120 => 2.0_f64.powi(600),
        1e120.. => 2.0_f64.powi(-600),
        _ => 1.0,
    };
    (data.iter().map(|x| (x * scale) * (x * scale)).sum::<f64>().sqrt(), scale)
}

fn norm(data: &[f64]) -> f64 {
    let (length, scale) = scaled_norm(data);
    length / scale
}

fn is_within(data: &[f64], bound: f64) -> bool {
    let (length, scale) = scaled_norm(data);
    length <= bound * scale
}

fn moved(from: &[f64], velocity: &[f64], ms: f64) -> Vec<f64> {
    from.iter().zip(velocity).map(|(p, v)| p + v * (ms / 1000.0)).collect()
}

fn inside(data: &[f64], radius: f64) -> bool {
    finite(data) && is_within(data, radius)
}
