//! The control loop: the newest sensor in, one governed command out, a tick at a time.

use thiserror::Error;

use super::Controller;
use crate::ErrorCode;
use crate::resilience::LinkMonitor;
use crate::safety::{Decision, SafetyGovernor};
use crate::wire::{CommandFrame, ControlStatus, MAX_ITEMS, SensorFrame, Text};
use ncp_kernel::is_duration;

/// How a loop runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoopConfig {
    /// From one tick to the next, in ms.
    pub period_ms: f64,
}

/// Why a loop does not start. `[NCP-CTRL-010]`
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum LoopError {
    /// The period is no time.
    #[error("the period is {period_ms} ms: it must be finite and positive")]
    Period {
        /// What it is, in ms.
        period_ms: f64,
    },
}

impl LoopError {
    /// Always [`ErrorCode::Value`]. `[NCP-CTRL-010]`
    #[must_use]
    pub const fn code(&self) -> ErrorCode {
        ErrorCode::Value
    }
}

/// What a tick sends.
#[derive(Debug, Clone, PartialEq)]
pub struct Tick {
    /// On the action plane.
    pub command: CommandFrame,
    /// On the observation plane.
    pub status: ControlStatus,
    /// What the governor did.
    pub decision: Decision,
}

/// A control loop without a clock, a thread or a transport of its own: whoever runs it hands in what
/// arrives and what time it is, in seconds on one monotonic clock.
#[derive(Debug)]
pub struct ControlLoop<C> {
    controller: C,
    governor: SafetyGovernor,
    link: LinkMonitor,
    period_ms: f64,
    /// The newest sensor frame and when it arrived.
    newest: Option<(SensorFrame, f64)>,
    ticks: i64,
    /// The last finite reading of the clock, in seconds.
    t: f64,
}

impl<C: Controller> ControlLoop<C> {
    /// A loop that has not ticked.
    ///
    /// # Errors
    /// The period is not finite and positive.
    pub fn new(
        config: LoopConfig,
        controller: C,
        governor: SafetyGovernor,
        link: LinkMonitor,
    ) -> Result<Self, LoopError> {
        let LoopConfig { period_ms } = config;
        // [NCP-CTRL-010]
        if !is_duration(period_ms) {
            return Err(LoopError::Period { period_ms });
        }
        Ok(Self { controller, governor, link, period_ms, newest: None, ticks: 0, t: 0.0 })
    }

    /// Takes every sensor frame that arrives, at `now_s`. Keeps it if it is newer than the one that
    /// is kept; whether it was. `[NCP-RES-053] [NCP-CTRL-011] [NCP-CTRL-012]`
    pub fn on_sensor(&mut self, frame: SensorFrame, now_s: f64) -> bool {
        // To the monitor 0 is a seq like any other. [NCP-RES-053]
        self.link.on_frame(frame.seq);
        let is_newer = self.newest.as_ref().is_none_or(|(kept, _)| {
            if frame.seq == 0 || kept.seq == 0 { frame.t > kept.t } else { frame.seq > kept.seq }
        });
        if is_newer {
            self.newest = Some((frame, now_s));
        }
        is_newer
    }

    /// One tick at `now_s`. `took_ms` tells how long the tick before it took, in ms.
    pub fn tick(&mut self, now_s: f64, took_ms: f64) -> Tick {
        let sensor = self.newest.as_ref().map(|(frame, _)| frame);
        let last_sensor_s = self.newest.as_ref().map(|(_, received_s)| *received_s);

        let mut command = self.controller.step(now_s, sensor);
        if now_s.is_finite() {
            self.t = now_s;
        }
        command.t = self.t;
        command.seq = sensor.map_or(0, |frame| frame.seq); // [NCP-CTRL-013]
        // [NCP-CTRL-014] A ttl that is no number is no time, so it is raised like any that is too short.
        let least_ms = (2.0 * self.period_ms).min(f64::MAX);
        command.ttl_ms = if command.ttl_ms.is_finite() { command.ttl_ms.max(least_ms) } else { least_ms };
        // What no frame holds is not to go out: a plant without the rest of a horizon holds sooner.
        command.horizon_dt_ms = command.horizon_dt_ms.filter(|dt_ms| dt_ms.is_finite());
        command.horizon.truncate(MAX_ITEMS);
        self.governor.note_link(self.link.burst()); // [NCP-CTRL-016]
        // [NCP-CTRL-015]
        let wanted = command.mode;
        let decision = self.governor.govern(&mut command, now_s, sensor, last_sensor_s);

        // [NCP-CTRL-017]
        self.ticks = self.ticks.saturating_add(1);
        let overran = took_ms > self.period_ms;
        let status = ControlStatus {
            seq: self.ticks,
            t: self.t,
            mode: command.mode,
            loop_latency_ms: if took_ms.is_finite() { took_ms } else { 0.0 },
            safety_ok: command.mode == wanted, // [NCP-CTRL-018]
            note: overran.then_some(Text::Borrowed("the tick before overran its period")), // [NCP-CTRL-019]
            ..ControlStatus::default()
        };
        Tick { command, status, decision }
    }

    /// The governor, for a supervisor's reset.
    pub const fn governor_mut(&mut self) -> &mut SafetyGovernor {
        &mut self.governor
    }

    /// The link monitor.
    #[must_use]
    pub const fn link(&self) -> &LinkMonitor {
        &self.link
    }
}
