//! What a server needs of a simulator.

use thiserror::Error;

use crate::wire::{ChannelMap, Observation, OpenSession, SortedMap};

/// Opens networks.
pub trait SimulationBackend {
    /// Its name, for `SessionOpened.backend`.
    fn name(&self) -> &str;

    /// Builds the network that a request names.
    ///
    /// # Errors
    /// The network is not known here, or the request does not fit it.
    fn open(&mut self, request: &OpenSession) -> Result<Opened, BackendError>;
}

/// A network that was built.
pub struct Opened {
    /// It, ready to run.
    pub simulation: Box<dyn Simulation + Send>,
    /// Neurons a population.
    pub resolved: SortedMap<i64>,
    /// The seed that is used, if the network draws random numbers.
    pub seed: Option<i64>,
}

/// One network that runs.
pub trait Simulation {
    /// Sets the values of ports; they stay until other values come. `[NCP-SESS-054]`
    ///
    /// # Errors
    /// A port is unknown, or its value does not fit.
    fn stimulate(&mut self, values: &ChannelMap) -> Result<(), BackendError>;

    /// Whether `advance_ms` can be run now. It is asked before the values of ports are set, so that a
    /// request that fails changes nothing. `[NCP-SESS-037]`
    ///
    /// # Errors
    /// The time cannot be run.
    fn check_advance(&self, advance_ms: f64) -> Result<(), BackendError> {
        let _ = advance_ms;
        Ok(())
    }

    /// Runs for `advance_ms` of simulation time, and gives what was recorded meanwhile, by port.
    ///
    /// # Errors
    /// The time cannot be run, or a number leaves the doubles meanwhile.
    fn advance(&mut self, advance_ms: f64) -> Result<SortedMap<Observation>, BackendError>;

    /// The simulation time since the network was built, in ms. `[NCP-SESS-033]`
    fn time_ms(&self) -> f64;
}

/// Why a backend refuses.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum BackendError {
    /// There is no such network.
    #[error("no network {reference:?} of kind {kind:?} is offered here")]
    UnknownNetwork {
        /// `NetworkRef.kind`.
        kind: String,
        /// `NetworkRef.ref`.
        reference: String,
    },
    /// A parameter is unknown or has a value that the model cannot have.
    #[error("the parameter {name:?} cannot be {value}")]
    Parameter {
        /// Its name.
        name: String,
        /// Its value.
        value: f64,
    },
    /// A population has an impossible size.
    #[error("the population {name:?} cannot have {size} neurons")]
    PopulationSize {
        /// Its name.
        name: String,
        /// Its size.
        size: i64,
    },
    /// A target names no population.
    #[error("the port {port:?} names the population {target:?}, which the network lacks")]
    UnknownTarget {
        /// The port.
        port: String,
        /// The population.
        target: String,
    },
    /// An id names no neuron.
    #[error("the port {port:?} names the neuron {id}, which its population lacks")]
    UnknownNeuron {
        /// The port.
        port: String,
        /// The neuron.
        id: i64,
    },
    /// Two targets have one port.
    #[error("two targets have the port {port:?}")]
    PortTwice {
        /// The port.
        port: String,
    },
    /// The network has no such quantity, or takes no such stimulus.
    #[error("the port {port:?} asks for {what:?}, which the network lacks")]
    Unsupported {
        /// The port.
        port: String,
        /// The observable or the stimulus kind.
        what: String,
    },
    /// A number of the network, or its time, is no double any more.
    #[error("a number of the network or its time leaves the doubles")]
    Overflow,
    /// A port of a stimulus is not one of the session's.
    #[error("the session has no stimulus port {port:?}")]
    UnknownPort {
        /// The port.
        port: String,
    },
    /// A stimulus has not as many components as its port has neurons, nor one for all.
    #[error("the port {port:?} takes 1 or {expected} values, and got {found}")]
    StimulusWidth {
        /// The port.
        port: String,
        /// Neurons of the port.
        expected: usize,
        /// Components of the stimulus.
        found: usize,
    },
    /// A time is negative, not finite, or too long.
    #[error("{name} cannot be {value_ms} ms")]
    Time {
        /// Which time.
        name: &'static str,
        /// What it is, in ms.
        value_ms: f64,
    },
}
