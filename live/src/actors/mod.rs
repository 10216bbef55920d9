//! The reference actors: a system of one's own to judge, each with the defects that can be planted in it.
//!
//! | module | what it runs |
//! |---|---|
//! | [`server`] | the session service, and a client of it |
//! | [`plant`] | a body that moves as commanded |
//! | [`commander`] | a control loop with the reflex controller |
//! | [`gateway`] | a simulation service on a line, and a gateway before it |
//! | [`observer`] | a reader that joins commands with what they were computed from |

mod commander;
pub(crate) mod gateway;
mod observer;
mod plant;
mod server;

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use crate::LiveError;
use crate::scenario::Role;
use crate::target::{Running, Target};

/// The one defect that is planted in an actor, by its name in `defects.toml`; none in a sound one.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Planted(pub(crate) Option<String>);

impl Planted {
    /// Whether it is this one.
    pub(crate) fn is(&self, name: &str) -> bool {
        self.0.as_deref() == Some(name)
    }
}

/// What the actors have besides: a commander that minds its link, and a supervisor who resets. By default neither.
#[derive(Debug, Clone, Default)]
pub(crate) struct Care {
    /// Whether a burst of losses stops the commander.
    minds_link: bool,
    plant: Resets,
    commander: Resets,
}

/// The resets of one actor.
#[derive(Debug, Clone, Default)]
struct Resets {
    asked: Arc<AtomicU64>,
    done: Arc<AtomicU64>,
}

impl Care {
    /// That of a system whose link may lose frames.
    pub(crate) fn over_a_link() -> Self {
        Self { minds_link: true, ..Self::default() }
    }

    /// Asks plant and commander to reset themselves.
    pub(crate) fn ask_for_resets(&self) {
        for resets in [&self.plant, &self.commander] {
            resets.asked.fetch_add(1, Ordering::SeqCst);
        }
    }

    /// Whether both have.
    pub(crate) fn are_reset(&self) -> bool {
        [&self.plant, &self.commander]
            .iter()
            .all(|resets| resets.asked.load(Ordering::SeqCst) == resets.done.load(Ordering::SeqCst))
    }
}

impl Resets {
    /// Resets, if that was asked for.
    fn carry_out(&self, reset: impl FnOnce()) {
        let asked = self.asked.load(Ordering::SeqCst);
        if asked != self.done.load(Ordering::SeqCst) {
            reset();
            self.done.store(asked, Ordering::SeqCst);
        }
    }
}

/// Starts an actor, until what is returned is dropped.
///
/// # Errors
/// Zenoh refuses.
pub(crate) fn start(role: Role, target: &Target, planted: &Planted, care: &Care) -> Result<Running, LiveError> {
    match role {
        Role::Server => server::server(target, planted),
        Role::Client => server::client(target, planted),
        Role::Plant => plant::plant(target, planted, care),
        Role::Commander => commander::commander(target, planted, care),
        Role::Observer => observer::observer(target, planted),
        Role::Simulator => gateway::simulator(target),
        Role::Gateway => gateway::gateway(target, planted),
    }
}
