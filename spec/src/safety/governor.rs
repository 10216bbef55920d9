//! The governor: what it knows, and the order of its gates.

use super::kernel::{self, Limit};
use super::{METRES, METRES_PER_SECOND, POSITION_CHANNEL, VELOCITY_CHANNEL};
use crate::wire::{
    Capabilities, ChannelKind, ChannelMap, ChannelSpec, ChannelValue, CommandFrame, Mode,
    SafetyLimits, SensorFrame, Text,
};

/// Stands at the end of a control loop and lets a command pass only when it is safe.
///
/// It works in place: the command that goes in is what may be sent when [`govern`](Self::govern)
/// returns, and nothing is allocated for a command that has the negotiated channels.
#[derive(Debug, Clone)]
pub struct SafetyGovernor {
    speed_mps: Limit<f64>,
    fence_m: Limit<f64>,
    timeout_ms: f64,
    /// The negotiated command channels with their units.
    channels: Vec<(Text, Option<Text>)>,
    config_fault: bool,
    estop: bool,
}

/// What the governor did with a command.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Decision {
    /// It passes as it came.
    Passed,
    /// It passes with a velocity scaled or its horizon truncated.
    Limited,
    /// It became a HOLD frame.
    Held(Reason),
    /// It became an ESTOP frame; ESTOP is latched.
    Stopped(Reason),
}

/// Which gate closed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reason {
    /// ESTOP was latched before, or the command itself is an ESTOP.
    Estop,
    /// The limits cannot be enforced.
    ConfigFault,
    /// The sensor is stale, or its age is unknown.
    StaleSensor,
    /// There is no usable position.
    NoPosition,
    /// The position is outside the fence, or its distance cannot be computed.
    OutsideFence,
    /// The command is not in mode `active`.
    NotActive,
    /// A component of tick 0 is not finite.
    NotFinite,
    /// The velocity is absent, not 3 wide, or in another unit.
    NoVelocity,
    /// There is a horizon, but its tick has no finite, positive length.
    BadHorizon,
    /// Tick 0 would lead out of the fence.
    LeavesFence,
}

impl SafetyGovernor {
    /// A governor for the canonical channels.
    #[must_use]
    pub fn new(limits: &SafetyLimits) -> Self {
        let speed_mps = kernel::limit(limits.max_speed_mps);
        let fence_m = kernel::limit(limits.geofence_radius_m);
        Self {
            speed_mps,
            fence_m,
            timeout_ms: limits.command_timeout_ms,
            channels: vec![(
                Text::Borrowed(VELOCITY_CHANNEL),
                Some(Text::Borrowed(METRES_PER_SECOND)),
            )],
            // [NCP-SAFE-013]
            config_fault: speed_mps == Limit::Faulty || fence_m == Limit::Faulty,
            estop: false,
        }
    }

    /// A governor for negotiated channels. A limit that cannot act on them is a config fault, from
    /// which this governor never recovers.
    #[must_use]
    pub fn negotiated(
        limits: &SafetyLimits,
        sensor_channels: &[ChannelSpec],
        command_channels: &[ChannelSpec],
    ) -> Self {
        let mut governor = Self::new(limits);
        // [NCP-SAFE-010] [NCP-SAFE-011] [NCP-SAFE-014] By name, never by place.
        let bound = |limit, channels, name, unit| {
            limit == Limit::Disabled || is_declared(channels, name, unit)
        };
        governor.config_fault |=
            !bound(governor.fence_m, sensor_channels, POSITION_CHANNEL, METRES)
                || !bound(
                    governor.speed_mps,
                    command_channels,
                    VELOCITY_CHANNEL,
                    METRES_PER_SECOND,
                );
        governor.channels = command_channels
            .iter()
            .map(|spec| (spec.name.clone(), spec.unit.clone()))
            .collect();
        governor
    }

    /// A governor for the channels and limits that a plant declares.
    #[must_use]
    pub fn from_capabilities(capabilities: &Capabilities) -> Self {
        Self::negotiated(
            &capabilities.safety,
            &capabilities.sensor_channels,
            &capabilities.command_channels,
        )
    }

    /// Decides on a command, and makes of it what may be sent.
    ///
    /// `now_s` is the governor's clock and `last_sensor_s` the time on it at which `sensor` was
    /// received, both in seconds. The gates stand in the order of section 7.3. `[NCP-SAFE-020]`
    pub fn govern(
        &mut self,
        command: &mut CommandFrame,
        now_s: f64,
        sensor: Option<&SensorFrame>,
        last_sensor_s: Option<f64>,
    ) -> Decision {
        // [NCP-SAFE-003] [NCP-SAFE-004]
        if command.mode == Mode::Estop {
            self.estop = true;
        }
        // [NCP-SAFE-005]
        if self.estop {
            return self.stop(command, Reason::Estop);
        }
        // [NCP-SAFE-017] [NCP-SAFE-018]
        if self.config_fault {
            return self.hold(command, Reason::ConfigFault);
        }
        // [NCP-SAFE-030]
        if !last_sensor_s.is_some_and(|last_s| kernel::is_fresh(now_s, last_s, self.timeout_ms)) {
            return self.hold(command, Reason::StaleSensor);
        }
        let place = match self.fence_m {
            Limit::Enabled(radius_m) => {
                let Some(position) = sensor.and_then(position_of) else {
                    return self.hold(command, Reason::NoPosition);
                };
                // [NCP-SAFE-043] [NCP-SAFE-044]
                if !kernel::inside(&position, radius_m) {
                    self.estop = true;
                    return self.stop(command, Reason::OutsideFence);
                }
                Some((position, radius_m))
            }
            Limit::Disabled | Limit::Faulty => None,
        };
        // [NCP-SAFE-002]
        if command.mode != Mode::Active {
            return self.hold(command, Reason::NotActive);
        }
        let limited = match self.limit(command) {
            Ok(limited) => limited,
            Err(reason) => return self.hold(command, reason),
        };
        let truncated = match place.map(|place| self.keep_inside(command, &place)) {
            Some(Err(reason)) => return self.hold(command, reason),
            Some(Ok(truncated)) => truncated,
            None => false,
        };
        if limited || truncated {
            Decision::Limited
        } else {
            Decision::Passed
        }
    }

    /// Takes note of the link: a burst of losses latches ESTOP. `[NCP-SAFE-006] [NCP-SAFE-007]`
    pub const fn note_link(&mut self, burst: bool) {
        if burst {
            self.estop = true;
        }
    }

    /// Clears the latch, by a supervisor's decision; a config fault stays.
    /// `[NCP-SAFE-008] [NCP-SAFE-009]`
    pub const fn reset(&mut self) {
        self.estop = false;
    }

    /// Whether ESTOP is latched.
    #[must_use]
    pub const fn is_stopped(&self) -> bool {
        self.estop
    }

    /// Whether the limits cannot be enforced.
    #[must_use]
    pub const fn has_config_fault(&self) -> bool {
        self.config_fault
    }

    fn hold(&self, command: &mut CommandFrame, reason: Reason) -> Decision {
        self.quiet(command, Mode::Hold);
        Decision::Held(reason)
    }

    fn stop(&self, command: &mut CommandFrame, reason: Reason) -> Decision {
        self.quiet(command, Mode::Estop);
        Decision::Stopped(reason)
    }

    /// Zeroes every channel of the command and of the negotiation; all else stays as it is.
    /// `[NCP-SAFE-070] [NCP-SAFE-071] [NCP-SAFE-072] [NCP-SAFE-073] [NCP-SAFE-074]`
    fn quiet(&self, command: &mut CommandFrame, mode: Mode) {
        command.mode = mode;
        command.horizon.clear();
        command.horizon_dt_ms = None;
        for channel in command.channels.values_mut() {
            channel.data.fill(0.0);
        }
        for (name, unit) in &self.channels {
            if !command.channels.contains_key(name) {
                let zero = if name == VELOCITY_CHANNEL {
                    ChannelValue::new([0.0; 3], METRES_PER_SECOND)
                } else {
                    ChannelValue {
                        data: vec![0.0],
                        unit: unit.clone(),
                    }
                };
                command.channels.insert(name.clone(), zero);
            }
        }
    }

    /// Applies the speed limit to every tick. Whether anything changed.
    fn limit(&self, command: &mut CommandFrame) -> Result<bool, Reason> {
        // [NCP-SAFE-068]
        let has_ticks = command.horizon_dt_ms.is_some_and(kernel::is_duration);
        if !command.horizon.is_empty() && !has_ticks {
            return Err(Reason::BadHorizon);
        }
        let mut limited = self.limit_tick(&mut command.channels)?; // [NCP-SAFE-063] [NCP-SAFE-064]
        for tick in 0..command.horizon.len() {
            match command
                .horizon
                .get_mut(tick)
                .map(|step| self.limit_tick(step))
            {
                Some(Ok(changed)) => limited |= changed, // [NCP-SAFE-066]
                // [NCP-SAFE-067]
                Some(Err(_)) | None => {
                    command.horizon.truncate(tick);
                    return Ok(true);
                }
            }
        }
        Ok(limited)
    }

    fn limit_tick(&self, channels: &mut ChannelMap) -> Result<bool, Reason> {
        let (mut limited, mut has_velocity) = (false, false);
        for (name, channel) in channels.iter_mut() {
            if !kernel::all_finite(&channel.data) {
                return Err(Reason::NotFinite);
            }
            let Limit::Enabled(max_mps) = self.speed_mps else {
                continue;
            };
            // [NCP-SAFE-065]
            if self.unit_of(name, channel) != Some(METRES_PER_SECOND) {
                continue;
            }
            has_velocity |= channel.data.len() == 3 && name == VELOCITY_CHANNEL;
            limited |=
                kernel::bring_within(&mut channel.data, max_mps).ok_or(Reason::NoVelocity)?;
        }
        if self.speed_mps != Limit::Disabled && !has_velocity {
            return Err(Reason::NoVelocity);
        }
        Ok(limited)
    }

    /// The velocity in m/s, if the tick has one that is 3 wide. `[NCP-SAFE-052] [NCP-SAFE-063]`
    fn velocity_of(&self, channels: &ChannelMap) -> Option<[f64; 3]> {
        let channel = channels.get(VELOCITY_CHANNEL)?;
        (self.unit_of(VELOCITY_CHANNEL, channel) == Some(METRES_PER_SECOND))
            .then(|| channel.data.as_slice().try_into().ok())?
    }

    /// The unit of a command's channel: the frame's, or the negotiated one where the frame does not
    /// say. `[NCP-SAFE-042]`
    fn unit_of<'a>(&'a self, name: &str, channel: &'a ChannelValue) -> Option<&'a str> {
        channel.unit.as_deref().or_else(|| {
            self.channels
                .iter()
                .find(|(known, _)| known == name)
                .and_then(|(_, unit)| unit.as_deref())
        })
    }

    /// Truncates the horizon before the first step that ends outside the fence. Whether it did; an
    /// error when tick 0 itself leads out.
    fn keep_inside(
        &self,
        command: &mut CommandFrame,
        &(position, radius_m): &([f64; 3], f64),
    ) -> Result<bool, Reason> {
        // [NCP-SAFE-052]
        let velocity = self
            .velocity_of(&command.channels)
            .ok_or(Reason::NoVelocity)?;
        // A plant does not act on a command whose ttl is no time.
        let ttl_ms = kernel::enforced_ttl_ms(command.ttl_ms).unwrap_or(0.0);
        let after = |from: &[f64; 3], velocity: &[f64; 3], time_ms: f64| {
            Some(kernel::travel(from, velocity, time_ms / 1000.0))
                .filter(|end| kernel::inside(end, radius_m))
        };
        let had_horizon = !command.horizon.is_empty();
        if had_horizon {
            let dt_ms = command.horizon_dt_ms.unwrap_or(f64::NAN);
            let share_ms = |tick| kernel::tick_share_ms(tick, dt_ms, ttl_ms);
            // [NCP-SAFE-051]
            let mut place = after(&position, &velocity, share_ms(0)).ok_or(Reason::LeavesFence)?;
            let mut kept = 0;
            for step in &command.horizon {
                let next = self
                    .velocity_of(step)
                    .and_then(|v| after(&place, &v, share_ms(kept + 1)));
                let Some(next) = next else { break };
                place = next;
                kept += 1;
            }
            let truncated = kept < command.horizon.len();
            command.horizon.truncate(kept); // [NCP-SAFE-050]
            if kept > 0 {
                return Ok(truncated);
            }
        }
        // [NCP-SAFE-053] Without a horizon, tick 0 is followed until the ttl ends.
        after(&position, &velocity, ttl_ms).ok_or(Reason::LeavesFence)?;
        Ok(had_horizon)
    }
}

/// Whether a channel is declared, and never but in its unit and 3 wide.
/// `[NCP-SAFE-014] [NCP-SAFE-015] [NCP-SAFE-016]`
fn is_declared(channels: &[ChannelSpec], name: &str, unit: &str) -> bool {
    let mut declared = channels.iter().filter(|spec| spec.name == name).peekable();
    declared.peek().is_some()
        && declared.all(|spec| {
            let is_wide = match spec.kind {
                ChannelKind::Vec3 => spec.size.is_none_or(|size| size == 3),
                ChannelKind::Array => spec.size == Some(3),
                _ => false,
            };
            spec.unit.as_deref() == Some(unit) && is_wide
        })
}

/// The position in metres, if the frame has one that is 3 wide. Where the fence is enabled, metres are
/// what was negotiated. `[NCP-SAFE-040] [NCP-SAFE-041] [NCP-SAFE-042]`
fn position_of(sensor: &SensorFrame) -> Option<[f64; 3]> {
    let channel = sensor.channels.get(POSITION_CHANNEL)?;
    if channel.unit.as_deref().is_some_and(|unit| unit != METRES) {
        return None;
    }
    channel.data.as_slice().try_into().ok()
}
