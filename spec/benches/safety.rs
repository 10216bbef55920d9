//! The hot path of a plant and of its commander: the governor, a whole tick of the control loop, the
//! watchdog and the action buffer, against a plain governor that clones each command it is given.
//!
//! `cargo bench -p ncp-spec --bench safety` prints the ratios, each of two works timed in turns in one
//! run. The plain governor keeps its channels in a `BTreeMap` and its text in owned strings, answers
//! with a clone, and makes the frame of a HOLD anew; of the gates it has the latch, the age of the
//! sensor, the fence, the mode and the speed limit, but neither units nor the projection of chapter 7.

use std::error::Error;
use std::hint::black_box;

use ncp_spec::control::{
    ControlLoop, Controller, LoopConfig, MEASURED_VELOCITY_CHANNEL, ReflexConfig, ReflexController,
};
use ncp_spec::resilience::{ActionBuffer, CommandWatchdog, LinkMonitor};
use ncp_spec::safety::{Decision, METRES, METRES_PER_SECOND, POSITION_CHANNEL, SafetyGovernor, VELOCITY_CHANNEL};
use ncp_spec::wire::{ChannelMap, ChannelValue, CommandFrame, Mode, SafetyLimits, SensorFrame};

use paired::Bench;

mod paired;

/// Below the limit.
const CALM: [f64; 3] = [0.6, 0.3, 0.1];
/// Above the limit.
const HASTY: [f64; 3] = [3.0, -4.0, 1.0];
const POSITION: [f64; 3] = [1.0, 2.0, 0.5];
const NOW_S: f64 = 10.0;
const LAST_S: f64 = 9.98;
const STEPS: usize = 20;
const STEP_MS: f64 = 50.0;

fn main() -> Result<(), Box<dyn Error>> {
    let bench = Bench::from_args();
    println!("note   one channel of 3 components, a speed limit, a fence; the horizon has {STEPS} steps");
    println!("note   80 ns and 500 ns where the plain governor takes 140 ns are 0.57 and 3.6");
    govern(&bench);
    tick(&bench)?;
    plant(&bench);
    Ok(())
}

/// Each decision of the governor against the same of the plain one.
fn govern(bench: &Bench) {
    let sensor = sensor(1);
    let plain_sensor = plain::Sensor::at(POSITION);
    let case = |name: &str, aim, velocity: [f64; 3], steps, last_s, expect: fn(Decision) -> bool| {
        let mut governor = SafetyGovernor::new(&limits());
        let mut plain = plain::Governor::new();
        let mut sent = command(1, velocity, steps);
        let wish = plain::Command::new(velocity, steps);
        let decision = governor.govern(&mut command(1, velocity, steps), NOW_S, Some(&sensor), last_s);
        assert!(expect(decision), "{name}: {decision:?}");
        assert_eq!(
            plain.govern(&wish, NOW_S, Some(&plain_sensor), last_s).mode == plain::Mode::Active,
            matches!(decision, Decision::Passed | Decision::Limited),
            "both sides decide alike"
        );
        bench.ratio(
            name,
            "clone-per-call",
            aim,
            || {
                // What the call before made of the command is undone in place.
                sent.mode = Mode::Active;
                restore(&mut sent.channels, velocity);
                for step in &mut sent.horizon {
                    restore(step, velocity);
                }
                governor.govern(black_box(&mut sent), NOW_S, Some(black_box(&sensor)), last_s)
            },
            || plain.govern(black_box(&wish), NOW_S, Some(black_box(&plain_sensor)), last_s),
        );
    };
    let passed = |decision| decision == Decision::Passed;
    let limited = |decision| decision == Decision::Limited;
    let held = |decision| matches!(decision, Decision::Held(_));
    case("safety/govern-pass", "≤ 0.57", CALM, 0, Some(LAST_S), passed);
    case("safety/govern-clamp", "≤ 0.57", HASTY, 0, Some(LAST_S), limited);
    case("safety/govern-hold", "≤ 0.57", CALM, 0, None, held);
    case("safety/govern-horizon", "≤ 0.57", CALM, STEPS, Some(LAST_S), passed);
}

/// A whole tick, with a sensor frame that arrives before it, against one call of the plain governor.
fn tick(bench: &Bench) -> Result<(), Box<dyn Error>> {
    let config = LoopConfig { period_ms: 20.0 };
    let reflex = ReflexController::new(ReflexConfig::default())?;
    let link = LinkMonitor::default();
    let mut looped = ControlLoop::new(config, reflex, SafetyGovernor::new(&limits()), link.clone())?;
    looped.on_sensor(sensor(1), LAST_S);
    assert_eq!(looped.tick(NOW_S, 1.0).command.mode, Mode::Active);

    let sensor_of_plain = plain::Sensor::at(POSITION);
    let wish = plain::Command::new(CALM, 0);
    let mut plain = plain::Governor::new();
    bench.ratio(
        "safety/tick",
        "clone-per-call govern",
        "≤ 3.6",
        || looped.tick(black_box(NOW_S), 1.0),
        || plain.govern(black_box(&wish), NOW_S, Some(black_box(&sensor_of_plain)), Some(LAST_S)),
    );

    let mut looped = ControlLoop::new(config, Still, SafetyGovernor::new(&limits()), link)?;
    let mut seq = 0;
    bench.ratio(
        "safety/sensor-and-tick",
        "clone-per-call govern",
        "the sensor frame is built too",
        || {
            seq += 1;
            looped.on_sensor(sensor(seq), LAST_S);
            looped.tick(black_box(NOW_S), 1.0)
        },
        || plain.govern(black_box(&wish), NOW_S, Some(black_box(&sensor_of_plain)), Some(LAST_S)),
    );
    Ok(())
}

/// What a plant asks many times for each command that it gets.
fn plant(bench: &Bench) {
    let sensor = plain::Sensor::at(POSITION);
    let wish = plain::Command::new(CALM, 0);
    let mut plain = plain::Governor::new();
    let mut other = || plain.govern(black_box(&wish), NOW_S, Some(black_box(&sensor)), Some(LAST_S));

    let mut watchdog = CommandWatchdog::new();
    watchdog.on_command(0.0, 1_000.0, 1);
    assert!(!watchdog.should_hold(0.7));
    bench.ratio(
        "safety/should-hold",
        "clone-per-call govern",
        "≤ 0.1",
        || watchdog.should_hold(black_box(0.7)),
        &mut other,
    );
    for (name, steps) in [("safety/active", 0), ("safety/active-horizon", STEPS)] {
        let mut buffer = ActionBuffer::new();
        let mut command = command(1, CALM, steps);
        command.ttl_ms = 1_000.0;
        buffer.on_command(command, 0.0);
        assert!(buffer.active(0.7).is_some());
        bench.ratio(
            name,
            "clone-per-call govern",
            "≤ 0.1",
            || buffer.active(black_box(0.7)).map(ChannelMap::len),
            &mut other,
        );
    }
}

/// A controller that costs what building one command costs.
struct Still;

impl Controller for Still {
    fn step(&mut self, _now_s: f64, _sensor: Option<&SensorFrame>) -> CommandFrame {
        command(0, [0.0; 3], 0)
    }
}

fn limits() -> SafetyLimits {
    SafetyLimits {
        max_speed_mps: Some(plain::MAX_SPEED_MPS),
        geofence_radius_m: Some(plain::RADIUS_M),
        ..SafetyLimits::default()
    }
}

fn velocity_channel(velocity: [f64; 3]) -> ChannelMap {
    ChannelMap::from_iter([(VELOCITY_CHANNEL, ChannelValue::new(velocity, METRES_PER_SECOND))])
}

fn command(seq: i64, velocity: [f64; 3], steps: usize) -> CommandFrame {
    CommandFrame {
        seq,
        channels: velocity_channel(velocity),
        horizon: vec![velocity_channel(velocity); steps],
        horizon_dt_ms: (steps > 0).then_some(STEP_MS),
        ..CommandFrame::default()
    }
}

fn restore(channels: &mut ChannelMap, velocity: [f64; 3]) {
    if let Some(channel) = channels.get_mut(VELOCITY_CHANNEL) {
        channel.data.copy_from_slice(&velocity);
    }
}

fn sensor(seq: i64) -> SensorFrame {
    let mut frame = SensorFrame { seq, ..SensorFrame::default() };
    frame.channels.extend([
        (POSITION_CHANNEL, ChannelValue::new(POSITION, METRES)),
        (MEASURED_VELOCITY_CHANNEL, ChannelValue::new([0.1, 0.0, 0.0], METRES_PER_SECOND)),
    ]);
    frame
}

/// The governor that one writes first.
mod plain {
    use std::collections::BTreeMap;

    use ncp_spec::safety::{METRES, METRES_PER_SECOND, POSITION_CHANNEL, VELOCITY_CHANNEL};

    pub(crate) const MAX_SPEED_MPS: f64 = 2.0;
    pub(crate) const RADIUS_M: f64 = 10.0;
    const TIMEOUT_MS: f64 = 500.0;

    type Channels = BTreeMap<String, ChannelValue>;

    #[derive(Clone)]
    pub(crate) struct ChannelValue {
        data: Vec<f64>,
        unit: Option<String>,
    }

    #[derive(Clone, Copy, PartialEq, Eq)]
    pub(crate) enum Mode {
        Active,
        Hold,
        Estop,
    }

    #[derive(Clone)]
    #[expect(dead_code, reason = "the rest is cloned, as a frame's is")]
    pub(crate) struct Command {
        ncp_version: String,
        kind: String,
        seq: i64,
        t: f64,
        frame_id: String,
        pub(crate) mode: Mode,
        ttl_ms: f64,
        channels: Channels,
        horizon: Vec<Channels>,
        horizon_dt_ms: Option<f64>,
    }

    pub(crate) struct Sensor {
        channels: Channels,
    }

    pub(crate) struct Governor {
        estop: bool,
    }

    impl Command {
        pub(crate) fn new(velocity: [f64; 3], steps: usize) -> Self {
            let channels = one(VELOCITY_CHANNEL, velocity, METRES_PER_SECOND);
            Self {
                ncp_version: ncp_spec::WIRE_VERSION.to_owned(),
                kind: "command_frame".to_owned(),
                seq: 1,
                t: 0.0,
                frame_id: "world".to_owned(),
                mode: Mode::Active,
                ttl_ms: 200.0,
                horizon: vec![channels.clone(); steps],
                channels,
                horizon_dt_ms: (steps > 0).then_some(super::STEP_MS),
            }
        }

        fn silenced(&self, mode: Mode) -> Self {
            let zeroed = |channel: &ChannelValue| ChannelValue {
                data: vec![0.0; channel.data.len()],
                unit: channel.unit.clone(),
            };
            let mut channels: Channels =
                self.channels.iter().map(|(name, channel)| (name.clone(), zeroed(channel))).collect();
            channels.entry(VELOCITY_CHANNEL.to_owned()).or_insert_with(|| value([0.0; 3], METRES_PER_SECOND));
            Self {
                ncp_version: self.ncp_version.clone(),
                kind: self.kind.clone(),
                seq: self.seq,
                t: self.t,
                frame_id: self.frame_id.clone(),
                mode,
                ttl_ms: self.ttl_ms,
                channels,
                horizon: Vec::new(),
                horizon_dt_ms: None,
            }
        }
    }

    impl Sensor {
        pub(crate) fn at(position: [f64; 3]) -> Self {
            Self { channels: one(POSITION_CHANNEL, position, METRES) }
        }
    }

    impl Governor {
        pub(crate) const fn new() -> Self {
            Self { estop: false }
        }

        pub(crate) fn govern(
            &mut self,
            command: &Command,
            now_s: f64,
            sensor: Option<&Sensor>,
            last_s: Option<f64>,
        ) -> Command {
            if self.estop || command.mode == Mode::Estop {
                self.estop = true;
                return command.silenced(Mode::Estop);
            }
            if !last_s.is_some_and(|last_s| (now_s - last_s) * 1000.0 <= TIMEOUT_MS) {
                return command.silenced(Mode::Hold);
            }
            let position = sensor.and_then(|sensor| sensor.channels.get(POSITION_CHANNEL));
            let Some(position) = position else {
                return command.silenced(Mode::Hold);
            };
            let distance_m = norm(&position.data);
            if distance_m.is_nan() || distance_m > RADIUS_M {
                self.estop = true;
                return command.silenced(Mode::Estop);
            }
            if command.mode != Mode::Active {
                return command.silenced(Mode::Hold);
            }
            let mut command = command.clone();
            for channels in std::iter::once(&mut command.channels).chain(&mut command.horizon) {
                if let Some(velocity) = channels.get_mut(VELOCITY_CHANNEL) {
                    let norm = norm(&velocity.data);
                    if norm > MAX_SPEED_MPS {
                        velocity.data.iter_mut().for_each(|x| *x *= MAX_SPEED_MPS / norm);
                    }
                }
            }
            command
        }
    }

    fn norm(vector: &[f64]) -> f64 {
        vector.iter().map(|x| x * x).sum::<f64>().sqrt()
    }

    fn one(name: &str, data: [f64; 3], unit: &str) -> Channels {
        Channels::from([(name.to_owned(), value(data, unit))])
    }

    fn value(data: [f64; 3], unit: &str) -> ChannelValue {
        ChannelValue { data: data.to_vec(), unit: Some(unit.to_owned()) }
    }
}
