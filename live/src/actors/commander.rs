//! A control loop with the reflex controller, within a fence.

use std::thread;
use std::time::{Duration, Instant};

use ncp_spec::control::{ControlLoop, Controller, LoopConfig, ReflexConfig, ReflexController};
use ncp_spec::plane::{Congestion, Plane, Priority, Qos};
use ncp_spec::resilience::LinkMonitor;
use ncp_spec::safety::SafetyGovernor;
use ncp_spec::wire::{BulkObservation, CommandFrame, Mode, SafetyLimits, SensorFrame};
use ncp_zenoh::{Bus, BusError, Perception, StreamPublisher};

use super::{Care, Planted};
use crate::LiveError;
use crate::target::{Running, Target};

const PERIOD: Duration = Duration::from_millis(20);

/// How far the plant may go, in m.
const FENCE_M: f64 = 50.0;

pub(super) fn commander(target: &Target, planted: &Planted, care: &Care) -> Result<Running, LiveError> {
    let bus = target.bus()?;
    let perception = Perception::of(&bus, &target.session, None)?;
    let sends = Sends::declare(&bus, target, planted)?;
    let fence = (!planted.is("fence-ignored")).then_some(FENCE_M);
    let limits = SafetyLimits {
        max_speed_mps: Some(1.0),
        geofence_radius_m: fence,
        command_timeout_ms: if planted.is("stale-for-long") { 60_000.0 } else { 300.0 },
        ..SafetyLimits::default()
    };
    let config = LoopConfig { period_ms: PERIOD.as_secs_f64() * 1e3 };
    // Where no link is judged, what a busy machine loses is no burst.
    let minds_link = care.minds_link && !planted.is("burst-ignored");
    let link = if minds_link { LinkMonitor::new(0.05, 5.0) } else { LinkMonitor::new(0.99, 1e6) };
    let mut control = ControlLoop::new(config, Shuttle::new()?, SafetyGovernor::new(&limits), link)?;

    let (planted, began) = (planted.clone(), Instant::now());
    let (mut took_ms, mut ticks, mut held_back) = (0.0, 0_i64, None::<CommandFrame>);
    let mut last_active = None::<CommandFrame>;
    let resets = care.commander.clone();
    let running = Running::default().every(PERIOD, move || {
        resets.carry_out(|| control.governor_mut().reset());
        let now = || began.elapsed().as_secs_f64();
        let began_s = now();
        while let Some(frame) = perception.next_frame() {
            if planted.is("perception-blocks") {
                thread::sleep(Duration::from_millis(5));
            }
            control.on_sensor(frame, now());
        }
        let mut tick = control.tick(now(), took_ms);
        ticks += 1;
        if planted.is("own-counter") {
            tick.command.seq = ticks;
        }
        if planted.is("short-ttl") {
            tick.command.ttl_ms = 1.0;
        }
        if planted.is("fence-forgets") {
            control.governor_mut().reset();
        }
        if planted.is("status-seq-of-command") {
            tick.status.seq = tick.command.seq;
        }
        if planted.is("goes-on-blind") {
            if tick.command.mode == Mode::Active {
                last_active = Some(tick.command.clone());
            } else if let Some(last) = &last_active {
                tick.command = last.clone();
            }
        }
        // What a publisher counts as failed, the next tick makes good.
        if planted.is("commands-reordered") {
            if let Some(before) = held_back.take() {
                let _ = (sends.command.send(&tick.command), sends.command.send(&before));
            } else {
                held_back = Some(tick.command);
            }
        } else {
            let _ = sends.command.send(&tick.command);
        }
        if !planted.is("no-status") {
            let _ = sends.status.send(&tick.status);
        }
        if planted.is("status-on-action") {
            let _ = sends.command.send(&tick.status);
        }
        if planted.is("block-on-action") {
            let _ = sends.command.send(&BulkObservation::default());
        }
        took_ms = (now() - began_s) * 1e3;
    });
    Ok(running.keeping(bus))
}

/// Flies to and fro, so that a plant that obeys keeps moving.
struct Shuttle {
    ways: [ReflexController; 2],
}

impl Shuttle {
    /// How long it flies one way, in s.
    const WAY_S: f64 = 6.0;

    fn new() -> Result<Self, LiveError> {
        let to = |x: f64| ReflexController::new(ReflexConfig { target_m: [x, 0.0, 0.0], ..ReflexConfig::default() });
        Ok(Self { ways: [to(2.0)?, to(-2.0)?] })
    }
}

impl Controller for Shuttle {
    fn step(&mut self, now_s: f64, sensor: Option<&SensorFrame>) -> CommandFrame {
        let [to, fro] = &mut self.ways;
        let way = if (now_s / Self::WAY_S) % 2.0 < 1.0 { to } else { fro };
        way.step(now_s, sensor)
    }
}

struct Sends {
    command: StreamPublisher,
    status: StreamPublisher,
}

impl Sends {
    fn declare(bus: &Bus, target: &Target, planted: &Planted) -> Result<Self, LiveError> {
        let (mut action, mut observation) = (Plane::Action.qos(), Plane::Observation.qos());
        if planted.is("command-blocks") {
            action = Qos { congestion: Congestion::Block, ..action };
        } else if planted.is("command-priority") {
            action = Qos { priority: Priority::Data, ..action };
        } else if planted.is("command-batched") {
            action = Qos { express: false, ..action };
        } else if planted.is("observation-drops") {
            observation = Qos { congestion: Congestion::Drop, ..observation };
        } else if planted.is("observation-priority") {
            observation = Qos { priority: Priority::RealTime, ..observation };
        } else if planted.is("observation-express") {
            observation = Qos { express: true, ..observation };
        }
        let (session, keys) = (&target.session, bus.keys());
        let command = keys.command(session, None).map_err(BusError::from)?;
        let status = keys.observation(session).map_err(BusError::from)?;
        Ok(Self {
            command: StreamPublisher::declare(bus, command, action)?,
            status: StreamPublisher::declare(bus, status, observation)?,
        })
    }
}
