//! The governor: what it knows of channels, and what a closed gate makes of a command.

use super::kernel::{self, Channel, Decision, Gates, Limit, Plan, Reason};
use super::{METRES, METRES_PER_SECOND, POSITION_CHANNEL, VELOCITY_CHANNEL};
use crate::wire::{
    Capabilities, ChannelKind, ChannelMap, ChannelSpec, ChannelValue, CommandFrame, Mode, SafetyLimits, SensorFrame,
    Text,
};

/// Stands at the end of a control loop and lets a command pass only when it is safe.
///
/// It works in place: the command that goes in is what may be sent when [`govern`](Self::govern)
/// returns, and nothing is allocated for a command that has the negotiated channels.
#[derive(Debug, Clone)]
pub struct SafetyGovernor {
    gates: Gates<f64>,
    channels: Channels,
}

impl SafetyGovernor {
    /// A governor for the canonical channels. `[NCP-SAFE-012] [NCP-SAFE-013]`
    #[must_use]
    pub fn new(limits: &SafetyLimits) -> Self {
        Self {
            gates: Gates::new(limits.max_speed_mps, limits.geofence_radius_m, limits.command_timeout_ms),
            channels: Channels(vec![(Text::Borrowed(VELOCITY_CHANNEL), Some(Text::Borrowed(METRES_PER_SECOND)))]),
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
        governor.gates.bind(
            is_declared(command_channels, VELOCITY_CHANNEL, METRES_PER_SECOND),
            is_declared(sensor_channels, POSITION_CHANNEL, METRES),
        );
        let known = command_channels.iter();
        governor.channels = Channels(known.map(|spec| (spec.name.clone(), spec.unit.clone())).collect());
        governor
    }

    /// A governor for the channels and limits that a plant declares. `[NCP-SAFE-014]`
    #[must_use]
    pub fn from_capabilities(capabilities: &Capabilities) -> Self {
        Self::negotiated(&capabilities.safety, &capabilities.sensor_channels, &capabilities.command_channels)
    }

    /// Decides on a command, and makes of it what may be sent.
    ///
    /// `now_s` is the governor's clock and `last_sensor_s` the time on it at which `sensor` was
    /// received, both in seconds. `[NCP-SAFE-020] [NCP-SAFE-021]`
    pub fn govern(
        &mut self,
        command: &mut CommandFrame,
        now_s: f64,
        sensor: Option<&SensorFrame>,
        last_sensor_s: Option<f64>,
    ) -> Decision {
        let mut plan = Ticks { command, channels: &self.channels };
        let position = || sensor.and_then(position_of);
        let decision = self.gates.govern(&mut plan, now_s, last_sensor_s, position);
        match decision {
            Decision::Passed | Decision::Limited => {}
            Decision::Held(_) => self.channels.quiet(command, Mode::Hold),
            Decision::Stopped(_) => self.channels.quiet(command, Mode::Estop),
        }
        decision
    }

    /// Takes note of the link: a burst of losses latches ESTOP. `[NCP-SAFE-006] [NCP-SAFE-007]`
    pub fn note_link(&mut self, burst: bool) {
        self.gates.note_link(burst);
    }

    /// Clears the latch, by a supervisor's decision; a config fault stays.
    /// `[NCP-SAFE-008] [NCP-SAFE-009]`
    pub fn reset(&mut self) {
        self.gates.reset();
    }

    /// Whether ESTOP is latched. `[NCP-SAFE-005]`
    #[must_use]
    pub const fn is_stopped(&self) -> bool {
        self.gates.is_stopped()
    }

    /// Whether the limits cannot be enforced. `[NCP-SAFE-017]`
    #[must_use]
    pub const fn has_config_fault(&self) -> bool {
        self.gates.has_config_fault()
    }
}

/// The negotiated command channels with their units.
#[derive(Debug, Clone)]
struct Channels(Vec<(Text, Option<Text>)>);

impl Channels {
    /// Zeroes every channel of the command and of the negotiation; all else stays as it is.
    /// `[NCP-SAFE-070] [NCP-SAFE-071] [NCP-SAFE-072] [NCP-SAFE-073] [NCP-SAFE-074]`
    fn quiet(&self, command: &mut CommandFrame, mode: Mode) {
        command.mode = mode;
        command.horizon.clear();
        command.horizon_dt_ms = None;
        for channel in command.channels.values_mut() {
            channel.data.fill(0.0);
        }
        for (name, unit) in &self.0 {
            if !command.channels.contains_key(name) {
                let zero = if name == VELOCITY_CHANNEL {
                    ChannelValue::new([0.0; 3], METRES_PER_SECOND)
                } else {
                    ChannelValue { data: vec![0.0], unit: unit.clone() }
                };
                command.channels.insert(name.clone(), zero);
            }
        }
    }

    /// The unit of a command's channel: the frame's, or the negotiated one where the frame does not
    /// say: of a channel that is declared twice, that of the first. `[NCP-SAFE-042]`
    fn unit_of<'a>(&'a self, name: &str, channel: &'a ChannelValue) -> Option<&'a str> {
        channel
            .unit
            .as_deref()
            .or_else(|| self.0.iter().find(|(known, _)| known == name).and_then(|(_, unit)| unit.as_deref()))
    }
}

/// The ticks of a command, in the units of the negotiation.
struct Ticks<'a> {
    command: &'a mut CommandFrame,
    channels: &'a Channels,
}

impl Plan<f64> for Ticks<'_> {
    fn mode(&self) -> Mode {
        self.command.mode
    }

    fn ttl_ms(&self) -> f64 {
        self.command.ttl_ms
    }

    fn dt_ms(&self) -> Option<f64> {
        self.command.horizon_dt_ms
    }

    fn steps(&self) -> usize {
        self.command.horizon.len()
    }

    fn limit(&mut self, tick: usize, max_mps: Limit<f64>) -> Result<bool, Reason> {
        let tick = match tick.checked_sub(1) {
            None => &mut self.command.channels,
            Some(step) => self.command.horizon.get_mut(step).ok_or(Reason::NoVelocity)?,
        };
        let channels = tick.iter_mut().map(|(name, channel)| Channel {
            is_velocity: name == VELOCITY_CHANNEL,
            in_mps: self.channels.unit_of(name, channel) == Some(METRES_PER_SECOND),
            data: &mut channel.data,
        });
        kernel::limit_tick(channels, max_mps)
    }

    fn velocity(&self, tick: usize) -> Option<[f64; 3]> {
        let tick: &ChannelMap = match tick.checked_sub(1) {
            None => &self.command.channels,
            Some(step) => self.command.horizon.get(step)?,
        };
        let channel = tick.get(VELOCITY_CHANNEL)?;
        // [NCP-SAFE-052] [NCP-SAFE-063]
        (self.channels.unit_of(VELOCITY_CHANNEL, channel) == Some(METRES_PER_SECOND))
            .then(|| channel.data.as_slice().try_into().ok())?
    }

    fn truncate(&mut self, steps: usize) {
        self.command.horizon.truncate(steps);
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
