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

/// Starts an actor, until what is returned is dropped.
///
/// # Errors
/// Zenoh refuses.
pub(crate) fn start(role: Role, target: &Target, planted: &Planted) -> Result<Running, LiveError> {
    match role {
        Role::Server => server::server(target, planted),
        Role::Client => server::client(target, planted),
        Role::Plant => plant::plant(target, planted),
        Role::Commander => commander::commander(target, planted),
        Role::Observer => observer::observer(target, planted),
        Role::Simulator => gateway::simulator(target),
        Role::Gateway => gateway::gateway(target, planted),
    }
}
