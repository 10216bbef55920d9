//! What a plant does now: its latch, its watchdog, and the tick of the horizon.

use ncp_kernel::{Mode, Received, Scalar, Seq};

use super::{Watchdog, age_ms, is_duration};

/// The gates of a plant. All times are seconds on its own clock.
///
/// Its fields are the whole of its state, and public for proofs, which take and make any state.
#[derive(Debug, Clone, Copy)]
pub struct Plant<S, Q> {
    /// Which command counts, and until when.
    pub watchdog: Watchdog<S, Q>,
    /// Whether ESTOP is latched.
    pub estop: bool,
}

impl<S: Scalar, Q: Seq> Plant<S, Q> {
    /// A plant that holds until the first command. `[NCP-RES-006]`
    #[inline]
    #[must_use]
    pub const fn new() -> Self {
        Self { watchdog: Watchdog::new(), estop: false }
    }

    /// Takes note of a command received at `now_s`. The plant follows it only when it is
    /// [accepted](Received::Accepted).
    #[inline]
    pub fn on_command(&mut self, mode: Mode, now_s: S, ttl_ms: S, seq: Q) -> Received {
        match mode {
            // [NCP-RES-021]
            Mode::Estop => {
                self.stop();
                Received::Stopped
            }
            // [NCP-RES-020] [NCP-RES-009]
            Mode::Active => {
                if !self.watchdog.on_command(now_s, ttl_ms, seq) {
                    Received::Dropped
                } else if self.estop {
                    Received::Stopped
                } else {
                    Received::Accepted
                }
            }
            // [NCP-SAFE-001] [NCP-RES-023] [NCP-RES-024]
            Mode::Init | Mode::Hold => {
                if self.watchdog.on_hold(seq) {
                    Received::Held
                } else {
                    Received::Dropped
                }
            }
        }
    }

    /// Latches ESTOP. `[NCP-RES-021] [NCP-RES-022]`
    #[inline]
    pub const fn stop(&mut self) {
        self.estop = true;
    }

    /// The tick that the plant actuates at `now_s`, or none when it holds: 0, or k for step k of a
    /// horizon of `steps` steps of `dt_ms`. `[NCP-RES-025]`
    #[inline]
    pub fn active(&mut self, now_s: S, dt_ms: Option<S>, steps: usize) -> Option<usize> {
        if self.watchdog.should_hold(now_s) || self.estop {
            return None;
        }
        let (received_s, _) = self.watchdog.deadline()?;
        // [NCP-RES-026] [NCP-RES-027]
        let Some(dt_ms) = dt_ms.filter(|&dt_ms| steps > 0 && is_duration(dt_ms)) else {
            return Some(0);
        };
        // [NCP-RES-028]
        let tick = age_ms(now_s, received_s).div(dt_ms).floor_index(steps + 1);
        // [NCP-RES-029]
        if tick > steps {
            self.watchdog.hold();
            return None;
        }
        Some(tick)
    }

    /// Clears the latch, the held command and the last seq, by a supervisor's decision: nothing moves
    /// until a new command comes. `[NCP-RES-030] [NCP-RES-031] [NCP-RES-032]`
    #[inline]
    pub const fn reset(&mut self) {
        *self = Self::new();
    }

    /// Its watchdog. `[NCP-RES-001]`
    #[inline]
    #[must_use]
    pub const fn watchdog(&self) -> &Watchdog<S, Q> {
        &self.watchdog
    }

    /// Whether ESTOP is latched. `[NCP-RES-021]`
    #[inline]
    #[must_use]
    pub const fn is_stopped(&self) -> bool {
        self.estop
    }
}

impl<S: Scalar, Q: Seq> Default for Plant<S, Q> {
    fn default() -> Self {
        Self::new()
    }
}
