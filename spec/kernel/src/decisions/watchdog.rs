//! The command watchdog: the liveness rule and nothing else.

use ncp_kernel::{Scalar, Seq};

use super::{advances, hold_takes_effect, within_deadline};

/// Holds a plant whose commands stay away. All times are seconds on the plant's own clock.
///
/// Its fields are the whole of its state, and public for proofs, which take and make any state.
#[derive(Debug, Clone, Copy)]
pub struct Watchdog<S, Q> {
    /// The seq of the last command that advanced.
    pub last_seq: Option<Q>,
    /// When the last advancing command was received, and its ttl in ms; none while the plant is
    /// held.
    pub deadline: Option<(S, S)>,
}

impl<S: Scalar, Q: Seq> Watchdog<S, Q> {
    /// A watchdog that holds until the first command. `[NCP-RES-006]`
    #[inline]
    #[must_use]
    pub const fn new() -> Self {
        Self { last_seq: None, deadline: None }
    }

    /// Takes note of a command received at `now_s`. Only one that advances refreshes the deadline;
    /// whether it did. `[NCP-RES-001] [NCP-RES-009]`
    #[inline]
    pub fn on_command(&mut self, now_s: S, ttl_ms: S, seq: Q) -> bool {
        if !advances(self.last_seq, seq) {
            return false;
        }
        self.last_seq = Some(seq);
        self.deadline = Some((now_s, ttl_ms));
        true
    }

    /// Takes note of a HOLD, which advances the stream but refreshes nothing; whether it took
    /// effect. `[NCP-RES-023] [NCP-RES-024]`
    #[inline]
    pub fn on_hold(&mut self, seq: Q) -> bool {
        if !hold_takes_effect(self.last_seq, seq) {
            return false;
        }
        if advances(self.last_seq, seq) && !seq.is_zero() {
            self.last_seq = Some(seq);
        }
        self.hold();
        true
    }

    /// Whether the plant must hold at `now_s`. A hold persists until an advancing command.
    /// `[NCP-RES-002] [NCP-RES-010]`
    #[inline]
    pub fn should_hold(&mut self, now_s: S) -> bool {
        self.deadline = self.deadline.filter(|&(received_s, ttl_ms)| within_deadline(now_s, received_s, ttl_ms));
        self.deadline.is_none()
    }

    /// Holds at once, until an advancing command. `[NCP-RES-010]`
    #[inline]
    pub const fn hold(&mut self) {
        self.deadline = None;
    }

    /// Forgets everything: the plant is held until a new command comes, whose seq may begin again.
    /// `[NCP-RES-011] [NCP-RES-012]`
    #[inline]
    pub const fn reset(&mut self) {
        *self = Self::new();
    }

    /// The seq of the last command that advanced. `[NCP-RES-009]`
    #[inline]
    #[must_use]
    pub const fn last_seq(&self) -> Option<Q> {
        self.last_seq
    }

    /// When the command was received that the plant may act upon, in seconds, and its ttl as sent, in
    /// ms; none while the plant is held. `[NCP-RES-001]`
    #[inline]
    #[must_use]
    pub const fn deadline(&self) -> Option<(S, S)> {
        self.deadline
    }
}

impl<S: Scalar, Q: Seq> Default for Watchdog<S, Q> {
    fn default() -> Self {
        Self::new()
    }
}
