//! The session service: chapter 4.

use std::sync::{Mutex, PoisonError};

use ncp_spec::session::{self, ReferenceBackend};
use pyo3::prelude::*;

use crate::argument::Frame;

/// Serves sessions of the reference simulation: bytes of a request in, its one reply out.
#[pyclass(module = "ncp", frozen)]
pub(crate) struct SessionService(Mutex<session::SessionService<ReferenceBackend>>);

#[pymethods]
impl SessionService {
    #[new]
    fn new() -> Self {
        Self(Mutex::new(session::SessionService::new(ReferenceBackend)))
    }

    /// The one reply to a request, whatever it holds. It never raises for what a client sent.
    fn serve(&self, py: Python<'_>, request: Frame) -> String {
        // A simulation takes its time; other threads may run.
        py.detach(|| self.lock(|service| service.serve(request.bytes())))
    }

    /// The ids of the open sessions.
    #[getter]
    fn open_sessions(&self) -> Vec<String> {
        self.lock(|service| service.open_sessions().map(str::to_owned).collect())
    }
}

impl SessionService {
    /// The lock is never held while Python code runs.
    fn lock<T>(&self, act: impl FnOnce(&mut session::SessionService<ReferenceBackend>) -> T) -> T {
        act(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }
}
