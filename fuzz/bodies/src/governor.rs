//! Traces of the safety governor, against the invariants of chapter 7.

use ncp_spec::safety::{Decision, POSITION_CHANNEL, SafetyGovernor, VELOCITY_CHANNEL};
use ncp_spec::wire::{
    ChannelKind, ChannelMap, ChannelSpec, ChannelValue, CommandFrame, Mode, SafetyLimits, SensorFrame, Text,
};

use crate::plain::{plain, read};

plain! {
    /// Names of channels.
    words Name = ["velocity_setpoint", "pose_position", "arm", "other"];
}
plain! {
    /// Units.
    words Unit = ["m/s", "m", "", "km/h"];
}
plain! {
    /// Modes.
    words ModeName = ["active", "estop", "init", "hold"];
}
plain! {
    /// Kinds of channels.
    words KindName = ["vec3", "array", "scalar", "quat"];
}
plain! {
    /// A channel and its value.
    struct Channel {
        /// Its name.
        name: Name,
        /// Its components.
        data: Vec<f64>,
        /// Its unit.
        unit: Option<Unit>,
    }
}
plain! {
    /// A declared channel.
    struct Spec {
        /// Its name.
        name: Name,
        /// Its shape.
        kind: KindName,
        /// Its unit.
        unit: Option<Unit>,
        /// Its width.
        size: Option<i64>,
    }
}
plain! {
    /// A command.
    struct Command {
        /// Its mode.
        mode: ModeName,
        /// Its seq.
        seq: i64,
        /// Its ttl in ms.
        ttl_ms: f64,
        /// Tick 0.
        channels: Vec<Channel>,
        /// The ticks behind it.
        horizon: Vec<Vec<Channel>>,
        /// The length of a tick in ms.
        horizon_dt_ms: Option<f64>,
    }
}
plain! {
    /// A command at the gates.
    struct Govern {
        /// The command.
        command: Command,
        /// The governor's clock in s.
        now_s: f64,
        /// What the sensor says.
        sensor: Option<Vec<Channel>>,
        /// When it said so, in s.
        last_sensor_s: Option<f64>,
    }
}
plain! {
    /// A step of a trace.
    enum Step {
        /// A command.
        0 Govern(Govern),
        /// News of the link.
        1 NoteLink(bool),
        /// A supervisor's reset.
        2 Reset(()),
    }
}
plain! {
    /// A governor and what happens to it.
    struct Trace {
        /// `max_speed_mps`.
        max_speed_mps: Option<f64>,
        /// `geofence_radius_m`.
        geofence_radius_m: Option<f64>,
        /// `command_timeout_ms`.
        command_timeout_ms: f64,
        /// The sensor and command channels, if they were negotiated.
        negotiated: Option<(Vec<Spec>, Vec<Spec>)>,
        /// What happens.
        steps: Vec<Step>,
    }
}

/// After every step of every trace: nothing but an active command passes, none while ESTOP is latched or
/// the limits are at fault, none on a stale sensor; what passes is finite, within the bound of the
/// speed, a prefix of what was asked for, and ends inside the fence; what does not pass is all zeros.
///
/// It would find a latch that is lost, a step of a horizon that no gate looks at, and a double that
/// slips through a comparison.
// [NCP-SAFE-002] [NCP-SAFE-003] [NCP-SAFE-004] [NCP-SAFE-005] [NCP-SAFE-006] [NCP-SAFE-007]
// [NCP-SAFE-008] [NCP-SAFE-009] [NCP-SAFE-013] [NCP-SAFE-017] [NCP-SAFE-018] [NCP-SAFE-021]
// [NCP-SAFE-030] [NCP-SAFE-031] [NCP-SAFE-032] [NCP-SAFE-033] [NCP-SAFE-035] [NCP-SAFE-040]
// [NCP-SAFE-043] [NCP-SAFE-044] [NCP-SAFE-050] [NCP-SAFE-051] [NCP-SAFE-054] [NCP-SAFE-060]
// [NCP-SAFE-063] [NCP-SAFE-064] [NCP-SAFE-065] [NCP-SAFE-066] [NCP-SAFE-067] [NCP-SAFE-068]
// [NCP-SAFE-070] [NCP-SAFE-071] [NCP-SAFE-072] [NCP-SAFE-074]
pub fn governor_trace(input: &[u8]) {
    let trace = read::<Trace>(input);
    let limits = SafetyLimits {
        max_speed_mps: trace.max_speed_mps,
        geofence_radius_m: trace.geofence_radius_m,
        command_timeout_ms: trace.command_timeout_ms,
        max_tilt_rad: None,
    };
    let specs = |specs: &[Spec]| specs.iter().map(Spec::build).collect::<Vec<_>>();
    let mut governor = match &trace.negotiated {
        None => SafetyGovernor::new(&limits),
        Some((sensor, command)) => SafetyGovernor::negotiated(&limits, &specs(sensor), &specs(command)),
    };
    let faulty = |limit: Option<f64>| limit.is_some_and(|limit| !limit.is_finite() || limit < 0.0);
    let fault = governor.has_config_fault();
    assert!(fault || !(faulty(limits.max_speed_mps) || faulty(limits.geofence_radius_m)));
    let world = World { limits, fault, negotiated: trace.negotiated.as_ref().map(|(_, command)| specs(command)) };
    let mut latched = false;
    for step in &trace.steps {
        match step {
            Step::NoteLink(burst) => {
                governor.note_link(*burst);
                latched |= burst;
            }
            Step::Reset(()) => {
                governor.reset();
                latched = false;
            }
            Step::Govern(step) => {
                let before = step.command.build();
                let sensor = step.sensor.as_ref().map(|channels| SensorFrame {
                    seq: 1,
                    channels: build(channels),
                    ..SensorFrame::default()
                });
                let mut after = before.clone();
                let decision = governor.govern(&mut after, step.now_s, sensor.as_ref(), step.last_sensor_s);
                let stopped = matches!(decision, Decision::Stopped(_));
                assert!(stopped || !(latched || before.mode == Mode::Estop), "ESTOP is lost");
                latched |= stopped;
                world.judge(step, &before, &after, decision);
            }
        }
        assert_eq!(governor.is_stopped(), latched);
        assert_eq!(governor.has_config_fault(), fault);
    }
}

struct World {
    limits: SafetyLimits,
    fault: bool,
    /// The negotiated command channels.
    negotiated: Option<Vec<ChannelSpec>>,
}

impl World {
    fn judge(&self, step: &Govern, before: &CommandFrame, after: &CommandFrame, decision: Decision) {
        assert_eq!((after.seq, &after.frame_id), (before.seq, &before.frame_id));
        assert_eq!(after.t.to_bits(), before.t.to_bits());
        assert_eq!(after.ttl_ms.to_bits(), before.ttl_ms.to_bits());
        match decision {
            Decision::Held(_) => self.judge_quiet(before, after, Mode::Hold),
            Decision::Stopped(_) => self.judge_quiet(before, after, Mode::Estop),
            Decision::Passed | Decision::Limited => {
                if decision == Decision::Passed {
                    // By their text, for which a NaN is itself.
                    assert_eq!(format!("{after:?}"), format!("{before:?}"));
                }
                self.judge_moving(step, before, after);
            }
        }
    }

    fn judge_quiet(&self, before: &CommandFrame, after: &CommandFrame, mode: Mode) {
        assert_eq!(after.mode, mode);
        assert!(after.horizon.is_empty() && after.horizon_dt_ms.is_none());
        assert!(after.channels.values().all(|channel| channel.data.iter().all(|x| *x == 0.0)));
        for (name, channel) in before.channels.iter() {
            let kept = after.channels.get(name).expect("a channel of the command stays");
            assert_eq!((kept.data.len(), &kept.unit), (channel.data.len(), &channel.unit));
        }
        for spec in self.negotiated.iter().flatten() {
            assert!(after.channels.contains_key(&spec.name));
        }
    }

    fn judge_moving(&self, step: &Govern, before: &CommandFrame, after: &CommandFrame) {
        assert_eq!((before.mode, after.mode), (Mode::Active, Mode::Active));
        assert!(!self.fault, "the limits are at fault");
        let (now, last) = (step.now_s, step.last_sensor_s.expect("a sensor time"));
        let timeout = self.limits.command_timeout_ms;
        assert!(now.is_finite() && last.is_finite() && timeout.is_finite() && timeout > 0.0);
        assert!(last <= now && (now - last) * 1000.0 <= timeout, "the sensor is stale");
        assert!(after.horizon.len() <= before.horizon.len());
        let dt = after.horizon_dt_ms.unwrap_or(f64::NAN);
        assert!(before.horizon.is_empty() || (dt.is_finite() && dt > 0.0));

        let ticks =
            |frame: &CommandFrame| std::iter::once(&frame.channels).chain(&frame.horizon).cloned().collect::<Vec<_>>();
        for (tick, asked) in ticks(after).iter().zip(ticks(before)) {
            assert!(tick.keys().eq(asked.keys()));
            for (name, channel) in tick.iter() {
                assert!(channel.data.iter().all(|x| x.is_finite()), "{name} is not finite");
                let asked = asked.get(name).expect("the same names");
                assert_eq!((channel.data.len(), &channel.unit), (asked.data.len(), &asked.unit));
                let in_mps = self.unit_of(name, channel) == Some("m/s");
                match self.limits.max_speed_mps.filter(|max| *max > 0.0) {
                    Some(max) if in_mps => {
                        assert!(is_within(&channel.data, max), "{name} is too fast");
                    }
                    _ => assert_eq!(channel, asked),
                }
            }
            if self.limits.max_speed_mps.is_some_and(|max| max > 0.0) {
                let velocity = tick.get(VELOCITY_CHANNEL).expect("a velocity");
                assert_eq!(velocity.data.len(), 3);
            }
        }
        if let Some(radius) = self.limits.geofence_radius_m.filter(|radius| *radius > 0.0) {
            self.judge_fenced(step, after, radius);
        }
    }

    /// A plant that follows the command exactly stays in the ball until its watchdog holds it.
    fn judge_fenced(&self, step: &Govern, after: &CommandFrame, radius: f64) {
        let sensor = build(step.sensor.as_ref().expect("a sensor frame"));
        let position = sensor.get(POSITION_CHANNEL).expect("a position");
        assert!(position.unit.as_deref().is_none_or(|unit| unit == "m"));
        let mut place: [f64; 3] = position.data.as_slice().try_into().expect("a position is 3 wide");
        assert!(is_within(&place, radius), "the plant is outside");
        let ttl = after.ttl_ms;
        let ttl = if ttl.is_finite() && ttl > 0.0 { ttl.min(60_000.0) } else { 0.0 };
        let ticks = std::iter::once(&after.channels).chain(&after.horizon);
        for (k, tick) in ticks.enumerate() {
            let share = if after.horizon.is_empty() {
                ttl
            } else {
                let dt = after.horizon_dt_ms.expect("a horizon has a tick");
                (ttl - k as f64 * dt).clamp(0.0, dt)
            };
            let velocity = &tick.get(VELOCITY_CHANNEL).expect("a velocity").data;
            for (x, v) in place.iter_mut().zip(velocity) {
                *x += v * (share / 1000.0);
            }
            assert!(is_within(&place, radius * (1.0 + 1e-9)), "{place:?} is outside {radius} m after tick {k}");
        }
    }

    /// The unit of a channel: its own, or the negotiated one.
    fn unit_of<'a>(&'a self, name: &str, channel: &'a ChannelValue) -> Option<&'a str> {
        if channel.unit.is_some() {
            return channel.unit.as_deref();
        }
        match &self.negotiated {
            None => (name == VELOCITY_CHANNEL).then_some("m/s"),
            Some(specs) => specs.iter().find(|spec| spec.name == name)?.unit.as_deref(),
        }
    }
}

impl Spec {
    fn build(&self) -> ChannelSpec {
        ChannelSpec {
            name: Text::Borrowed(self.name.0),
            kind: match self.kind.0 {
                "vec3" => ChannelKind::Vec3,
                "array" => ChannelKind::Array,
                "quat" => ChannelKind::Quat,
                _ => ChannelKind::Scalar,
            },
            unit: self.unit.map(|unit| Text::Borrowed(unit.0)),
            size: self.size,
            ..ChannelSpec::default()
        }
    }
}

impl Command {
    /// The command as the wire types have it.
    #[must_use]
    pub fn build(&self) -> CommandFrame {
        CommandFrame {
            mode: mode(self.mode),
            seq: self.seq,
            t: 1.5,
            ttl_ms: self.ttl_ms,
            channels: build(&self.channels),
            horizon: self.horizon.iter().map(|tick| build(tick)).collect(),
            horizon_dt_ms: self.horizon_dt_ms,
            ..CommandFrame::default()
        }
    }
}

/// A mode by its name.
#[must_use]
pub fn mode(name: ModeName) -> Mode {
    match name.0 {
        "active" => Mode::Active,
        "estop" => Mode::Estop,
        "init" => Mode::Init,
        _ => Mode::Hold,
    }
}

fn build(channels: &[Channel]) -> ChannelMap {
    let channels = channels.iter().map(|channel| {
        let value = ChannelValue { data: channel.data.clone(), unit: channel.unit.map(|unit| Text::Borrowed(unit.0)) };
        (channel.name.0, value)
    });
    channels.collect()
}

/// Whether the norm is not above a bound, as the text has it: both at a scale at which no square leaves the doubles.
fn is_within(vector: &[f64], bound: f64) -> bool {
    let largest = vector.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    let scale = match largest {
        ..1e-120 => 2.0_f64.powi(600),
        1e120.. => 2.0_f64.powi(-600),
        _ => 1.0,
    };
    vector.iter().map(|x| (x * scale) * (x * scale)).sum::<f64>().sqrt() <= bound * scale
}
