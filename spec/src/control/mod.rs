//! What makes commands out of sensor frames: chapter 10.

mod control_loop;
mod reflex;

pub use control_loop::{ControlLoop, LoopConfig, LoopError, Tick};
pub use reflex::{MEASURED_VELOCITY_CHANNEL, ReflexConfig, ReflexController, ReflexError};

use crate::wire::{CommandFrame, SensorFrame};

/// Makes a command out of the newest sensor frame. `now_s` is the loop's clock in seconds.
pub trait Controller {
    /// One step. The loop stamps the command and governs it.
    fn step(&mut self, now_s: f64, sensor: Option<&SensorFrame>) -> CommandFrame;
}
