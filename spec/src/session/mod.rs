//! The simulation service: chapter 4.
//!
//! [`SessionService`] turns the bytes of a request into the bytes of its one reply, whatever they are.
//! What simulates is behind [`SimulationBackend`]; [`ReferenceBackend`] is the one that the text defines.

mod backend;
mod reference;
mod service;

pub use backend::{BackendError, Opened, Simulation, SimulationBackend};
pub use reference::ReferenceBackend;
pub use service::SessionService;
