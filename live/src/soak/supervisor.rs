//! A supervisor: it leads back from ESTOP, since nothing else does.

use super::body::Body;
use crate::actors::Care;
use crate::relay::Relay;

/// How long it looks at a latched plant before it resets it, in s: meanwhile the latch is judged.
const LOOKS_S: f64 = 1.0;

/// After how much stillness it resets a plant that is not known to be latched, in s.
const STILL_S: f64 = 4.0;

/// How long no command passes before a reset, and after it, in s: so it is known what came before.
const QUIET_S: f64 = 0.25;

/// Resets plant and commander while no command passes.
pub(super) struct Supervisor {
    care: Care,
    does: Does,
    resets: u64,
}

#[derive(Debug, Clone, Copy)]
enum Does {
    /// Looks, and acts no sooner than at a time.
    Looks(f64),
    /// Has stopped the commands, and waits until a time.
    Stops(f64),
    /// Has asked for the resets.
    Resets,
    /// Waits until a time, and then lets commands through.
    Settles(f64),
}

/// What a supervisor has done just now.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Tended {
    /// Nothing that matters to a judge.
    Nothing,
    /// It has asked for the resets: from now on the commander may be reset.
    Asked,
    /// Plant and commander are reset.
    Reset,
}

impl Supervisor {
    pub(super) const fn new(care: Care) -> Self {
        Self { care, does: Does::Looks(0.0), resets: 0 }
    }

    /// How often it has reset.
    pub(super) const fn resets(&self) -> u64 {
        self.resets
    }

    /// Goes on with what it does.
    pub(super) fn tend(&mut self, now_s: f64, body: &Body, is_cut: bool, noise_s: f64, relay: &Relay) -> Tended {
        match self.does {
            Does::Looks(from_s) => {
                let is_latched = body.latched_s().is_some_and(|since_s| now_s - since_s > LOOKS_S);
                let is_still = now_s - body.last_moved_s() > STILL_S;
                if now_s > from_s && !is_cut && (is_latched || is_still) {
                    relay.stop_commands(true);
                    self.does = Does::Stops(now_s + QUIET_S + 2.0 * noise_s);
                }
            }
            Does::Stops(until_s) if now_s > until_s => {
                self.care.ask_for_resets();
                self.does = Does::Resets;
                return Tended::Asked;
            }
            Does::Resets if self.care.are_reset() => {
                self.resets += 1;
                self.does = Does::Settles(now_s + QUIET_S + 2.0 * noise_s);
                return Tended::Reset;
            }
            Does::Settles(until_s) if now_s > until_s => {
                relay.stop_commands(false);
                self.does = Does::Looks(now_s + LOOKS_S);
            }
            Does::Stops(_) | Does::Resets | Does::Settles(_) => {}
        }
        Tended::Nothing
    }
}
