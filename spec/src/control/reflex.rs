//! The reflex controller: proportional, with damping.

use thiserror::Error;

use super::Controller;
use crate::ErrorCode;
use crate::safety::{METRES_PER_SECOND, POSITION_CHANNEL, VELOCITY_CHANNEL};
use crate::wire::{ChannelValue, CommandFrame, Mode, SensorFrame};
use ncp_kernel::all_finite;

/// The channel of the measured velocity, in m/s.
pub const MEASURED_VELOCITY_CHANNEL: &str = "pose_velocity";

/// Where to go, and how eagerly. `[NCP-CTRL-002]`
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReflexConfig {
    /// The target, in m.
    pub target_m: [f64; 3],
    /// Gain on the position's error, 1/s.
    pub kp: f64,
    /// Gain on the velocity, without unit.
    pub kd: f64,
    /// The most that is commanded for an axis, in m/s.
    pub max_speed_mps: f64,
}

impl Default for ReflexConfig {
    fn default() -> Self {
        Self { target_m: [0.0; 3], kp: 1.0, kd: 0.3, max_speed_mps: 1.5 }
    }
}

/// Why a reflex controller cannot be built. `[NCP-CTRL-005]`
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum ReflexError {
    /// A gain is negative or not finite.
    #[error("the gain {name} is {value}: it must be finite and not negative")]
    Gain {
        /// Which.
        name: &'static str,
        /// What it is.
        value: f64,
    },
    /// The speed is negative or not finite.
    #[error("max_speed is {value} m/s: it must be finite and not negative")]
    MaxSpeed {
        /// What it is, in m/s.
        value: f64,
    },
    /// The target is not finite.
    #[error("the target is not finite")]
    Target,
}

impl ReflexError {
    /// Always [`ErrorCode::Value`]. `[NCP-CTRL-005]`
    #[must_use]
    pub const fn code(&self) -> ErrorCode {
        ErrorCode::Value
    }
}

/// Commands a velocity towards a target.
#[derive(Debug, Clone)]
pub struct ReflexController {
    config: ReflexConfig,
}

impl ReflexController {
    /// A controller.
    ///
    /// # Errors
    /// A gain, the speed or the target is not usable.
    pub fn new(config: ReflexConfig) -> Result<Self, ReflexError> {
        let usable = |value: f64| value.is_finite() && value >= 0.0;
        for (name, value) in [("kp", config.kp), ("kd", config.kd)] {
            if !usable(value) {
                return Err(ReflexError::Gain { name, value });
            }
        }
        if !usable(config.max_speed_mps) {
            return Err(ReflexError::MaxSpeed { value: config.max_speed_mps });
        }
        if !all_finite(&config.target_m) {
            return Err(ReflexError::Target);
        }
        Ok(Self { config })
    }
}

impl Controller for ReflexController {
    fn step(&mut self, _now_s: f64, sensor: Option<&SensorFrame>) -> CommandFrame {
        let measured = |name| {
            let data = &sensor?.channels.get(name)?.data;
            <[f64; 3]>::try_from(data.as_slice()).ok().filter(|vector| all_finite(vector))
        };
        // [NCP-PLANE-006]
        let mut command = CommandFrame { seq: sensor.map_or(0, |frame| frame.seq), ..CommandFrame::default() };
        let mut setpoint = [0.0; 3];
        match measured(POSITION_CHANNEL) {
            // [NCP-CTRL-003]
            None => command.mode = Mode::Hold,
            // [NCP-CTRL-001]
            Some(position) => {
                // [NCP-CTRL-004]
                let velocity = measured(MEASURED_VELOCITY_CHANNEL).unwrap_or_default();
                let ReflexConfig { target_m, kp, kd, max_speed_mps } = self.config;
                let axes = position.iter().zip(velocity).zip(target_m);
                for (u, ((p, v), target)) in setpoint.iter_mut().zip(axes) {
                    let wanted = -kp * (p - target) - kd * v;
                    *u = wanted.max(-max_speed_mps).min(max_speed_mps);
                    if wanted.is_nan() {
                        command.mode = Mode::Hold;
                    }
                }
                // Terms that overflow against each other say nothing, and `max` would pick a bound.
                if command.mode == Mode::Hold {
                    setpoint = [0.0; 3];
                }
            }
        }
        command.channels.insert(VELOCITY_CHANNEL, ChannelValue::new(setpoint, METRES_PER_SECOND));
        command
    }
}
