//! The simulation service of a test, on an address of its own.

use std::net::SocketAddr;

pub(crate) use ncp_gateway::service::{Does, LineService as Service};

pub(crate) fn start(script: impl Fn(&str) -> Does + Send + Sync + 'static) -> Service {
    Service::start(any(), script).unwrap()
}

pub(crate) fn reference() -> Service {
    Service::reference(any()).unwrap()
}

/// Ends a service, as its death would; where it was.
pub(crate) fn die(service: Service) -> SocketAddr {
    let address = service.address();
    drop(service);
    address
}

fn any() -> SocketAddr {
    SocketAddr::from(([127, 0, 0, 1], 0))
}
