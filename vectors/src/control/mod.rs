//! Area `control`: the reflex controller and the control loop.

mod endures;
mod reflex;
mod tick;

use crate::case::File;
use crate::json::{Json, object};
use crate::scenario::ScenarioError;
use crate::trace::{int, num, nums};

pub(crate) fn files() -> Result<Vec<File>, ScenarioError> {
    Ok(vec![reflex::file(), tick::file()?])
}

/// The fields of a sensor frame with a position and perhaps a velocity.
fn sensor(seq: i64, t: f64, position: &[f64], velocity: Option<&[f64]>) -> Json {
    object! { "seq" => int(seq), "t" => num(t), "channels" => channels_at(position, velocity) }
}

fn channels_at(position: &[f64], velocity: Option<&[f64]>) -> Json {
    let mut channels = object! { "pose_position" => object! { "data" => nums(position), "unit" => "m" } };
    if let Some(velocity) = velocity {
        channels = channels.with("pose_velocity", object! { "data" => nums(velocity), "unit" => "m/s" });
    }
    channels
}

/// A velocity of a command.
fn velocity(data: &[f64]) -> Json {
    object! { "velocity_setpoint" => object! { "data" => nums(data), "unit" => "m/s" } }
}

/// The control law of chapter 10.
fn law(gains: Gains, position: [f64; 3], velocity: [f64; 3]) -> [f64; 3] {
    let axis = |at: usize| {
        let of = |vector: [f64; 3]| vector.get(at).copied().unwrap_or_default();
        let u = -gains.kp * (of(position) - of(gains.target)) - gains.kd * of(velocity);
        u.clamp(-gains.max_speed, gains.max_speed)
    };
    [axis(0), axis(1), axis(2)]
}

#[derive(Clone, Copy)]
struct Gains {
    target: [f64; 3],
    kp: f64,
    kd: f64,
    max_speed: f64,
}

impl Gains {
    /// The configuration of a controller.
    fn json(self) -> Json {
        object! { "target" => nums(&self.target), "kp" => num(self.kp), "kd" => num(self.kd),
        "max_speed" => num(self.max_speed) }
    }
}

const DEFAULT: Gains = Gains { target: [0.0; 3], kp: 1.0, kd: 0.3, max_speed: 1.5 };
