//! The command watchdog: the liveness rule and nothing else.

use crate::safety::kernel;

/// Holds a plant whose commands stay away. All times are seconds on the plant's own clock.
#[derive(Debug, Clone, Default)]
pub struct CommandWatchdog {
    last_seq: Option<i64>,
    /// When the last advancing command was received, and its ttl in ms; none while the plant is
    /// held.
    deadline: Option<(f64, f64)>,
}

impl CommandWatchdog {
    /// A watchdog that holds until the first command. `[NCP-RES-006]`
    #[must_use]
    pub const fn new() -> Self {
        Self {
            last_seq: None,
            deadline: None,
        }
    }

    /// Takes note of a command received at `now_s`. Only one that advances refreshes the deadline;
    /// whether it did. `[NCP-RES-001] [NCP-RES-009]`
    pub fn on_command(&mut self, now_s: f64, ttl_ms: f64, seq: i64) -> bool {
        if !kernel::advances(self.last_seq, seq) {
            return false;
        }
        self.last_seq = Some(seq);
        self.deadline = Some((now_s, ttl_ms));
        true
    }

    /// Whether the plant must hold at `now_s`. A hold persists until an advancing command.
    /// `[NCP-RES-002] [NCP-RES-010]`
    pub fn should_hold(&mut self, now_s: f64) -> bool {
        self.deadline = self
            .deadline
            .filter(|&(received_s, ttl_ms)| kernel::within_deadline(now_s, received_s, ttl_ms));
        self.deadline.is_none()
    }

    /// Whether a command of this seq would advance.
    #[must_use]
    pub fn advances(&self, seq: i64) -> bool {
        kernel::advances(self.last_seq, seq)
    }

    /// Holds at once, until an advancing command.
    pub const fn hold(&mut self) {
        self.deadline = None;
    }

    /// Forgets everything: the plant is held until a new command comes, whose seq may begin again.
    /// `[NCP-RES-011] [NCP-RES-012]`
    pub const fn reset(&mut self) {
        *self = Self::new();
    }

    /// The seq of the last command that advanced.
    #[must_use]
    pub const fn last_seq(&self) -> Option<i64> {
        self.last_seq
    }

    /// When the command was received that the plant may act upon, in seconds.
    #[must_use]
    pub fn received_s(&self) -> Option<f64> {
        self.deadline.map(|(received_s, _)| received_s)
    }

    /// Takes note of a HOLD, which advances the stream but refreshes nothing. `[NCP-RES-024]`
    pub(super) fn on_hold(&mut self, seq: i64) -> bool {
        if !kernel::hold_takes_effect(self.last_seq, seq) {
            return false;
        }
        if kernel::advances(self.last_seq, seq) && seq != 0 {
            self.last_seq = Some(seq);
        }
        self.hold();
        true
    }
}
