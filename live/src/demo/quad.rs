//! The plant: a quad that follows a velocity as fast as it can accelerate, and hovers when it holds.

use std::sync::Arc;
use std::time::{Duration, Instant};

use ncp_spec::resilience::ActionBuffer;
use ncp_spec::safety::VELOCITY_CHANNEL;
use ncp_spec::wire::{ChannelMap, ChannelValue, SensorFrame};
use ncp_zenoh::{Commands, SensorPublisher};

use super::Wishes;
use super::brain::{Log, lock};
use crate::LiveError;
use crate::target::{Running, Target};

/// From one step of its motion to the next; it senses in every second one.
const PERIOD: Duration = Duration::from_millis(10);
/// How long it takes to follow, in s.
const LAG_S: f64 = 0.08;
/// What it accelerates with at most, in m/s².
const STRONGEST_MPS2: f64 = 6.0;
/// Slower than this it stands, when it is to, in m/s.
const STANDS_MPS: f64 = 0.005;

/// Where it was.
#[derive(Debug, Clone)]
pub(super) struct Place {
    pub(super) at_s: f64,
    /// In m.
    pub(super) position: [f64; 3],
    /// In m/s.
    pub(super) velocity: [f64; 3],
    /// Whether it obeyed a command, and did not hold.
    pub(super) obeys: bool,
    /// Whether ESTOP was latched.
    pub(super) is_stopped: bool,
}

/// Starts the quad, which stands at the origin; its log counts from `began`.
///
/// # Errors
/// Zenoh refuses.
pub(super) fn quad(target: &Target, wishes: &Arc<Wishes>, began: Instant) -> Result<(Running, Log<Place>), LiveError> {
    let bus = target.bus()?;
    let commands = Commands::of(&bus, &target.session, None, ActionBuffer::new())?;
    let sensors = SensorPublisher::declare(&bus, &target.session, None)?;
    let log: Log<Place> = Arc::default();
    let (into, wishes) = (Arc::clone(&log), Arc::clone(wishes));
    let (mut motion, mut steps, mut resets) = (Motion::default(), 0_i64, wishes.resets());
    let mut before = Instant::now();
    let running = Running::default().every(PERIOD, move || {
        if resets != wishes.resets() {
            resets = wishes.resets();
            commands.reset();
        }
        let active = commands.active();
        let setpoint = active.as_ref().and_then(|channels| channels.get(VELOCITY_CHANNEL));
        let setpoint = setpoint.and_then(|channel| channel.data.as_slice().try_into().ok()).unwrap_or_default();
        motion.follow(setpoint, before.elapsed().as_secs_f64());
        before = Instant::now();
        let Motion { position, velocity } = motion;
        steps += 1;
        if steps % 2 == 0 {
            let channels = ChannelMap::from_iter([
                ("pose_position", ChannelValue::new(position, "m")),
                ("pose_velocity", ChannelValue::new(velocity, "m/s")),
            ]);
            let t = commands.now_s();
            // What a publisher counts as failed, the next frame makes good.
            let _ = sensors.send(&SensorFrame { seq: steps / 2, t, channels, ..SensorFrame::default() });
        }
        let at_s = began.elapsed().as_secs_f64();
        let (obeys, is_stopped) = (active.is_some(), commands.is_stopped());
        lock(&into).push(Place { at_s, position, velocity, obeys, is_stopped });
    });
    Ok((running.keeping(bus), log))
}

/// How it moves.
#[derive(Debug, Clone, Copy, Default)]
struct Motion {
    position: [f64; 3],
    velocity: [f64; 3],
}

impl Motion {
    /// Goes on for a while towards a velocity in m/s.
    fn follow(&mut self, setpoint: [f64; 3], for_s: f64) {
        let wanted = [0, 1, 2].map(|axis| setpoint[axis] - self.velocity[axis]);
        let size = wanted.iter().map(|part| part * part).sum::<f64>().sqrt();
        let share = (for_s / LAG_S).min(1.0).min(STRONGEST_MPS2 * for_s / size.max(f64::MIN_POSITIVE));
        for axis in 0..3 {
            self.velocity[axis] += wanted[axis] * share;
            if setpoint[axis] == 0.0 && self.velocity[axis].abs() < STANDS_MPS {
                self.velocity[axis] = 0.0;
            }
            self.position[axis] += self.velocity[axis] * for_s;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flown(mut motion: Motion, setpoint: [f64; 3], for_s: f64) -> Motion {
        let mut gone_s = 0.0;
        while gone_s < for_s {
            motion.follow(setpoint, 0.01);
            gone_s += 0.01;
        }
        motion
    }

    #[test]
    fn it_follows_a_velocity_and_stands_when_it_holds() {
        let moving = flown(Motion::default(), [1.0, 0.0, -0.5], 1.0);
        assert!((moving.velocity[0] - 1.0).abs() < 0.01 && (moving.velocity[2] + 0.5).abs() < 0.01);
        assert!(moving.position[0] > 0.8 && moving.position[1] == 0.0);
        assert_eq!(flown(moving, [0.0; 3], 1.0).velocity, [0.0; 3]);
    }

    #[test]
    fn it_accelerates_no_stronger_than_it_can() {
        let mut motion = Motion::default();
        motion.follow([100.0, 0.0, 0.0], 0.01);
        assert!((motion.velocity[0] - STRONGEST_MPS2 * 0.01).abs() < 1e-12);
    }
}
