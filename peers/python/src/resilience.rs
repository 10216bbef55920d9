//! The plant's side: chapter 8.

use std::sync::{Mutex, MutexGuard, PoisonError};

use ncp_spec::resilience::{self, Received};
use ncp_spec::wire::CommandFrame;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::argument::{Frame, double, integer};
use crate::error::Result;
use crate::message::{channels_to_dict, message};

/// How many ticks of `dt_ms` a ttl of `ttl_ms` has room for, both in ms.
#[pyfunction]
pub(crate) fn max_horizon_len(
    #[pyo3(from_py_with = double)] ttl_ms: f64,
    #[pyo3(from_py_with = double)] dt_ms: f64,
) -> usize {
    resilience::max_horizon_len(ttl_ms, dt_ms)
}

/// Holds a plant whose commands stay away. All times are seconds on the plant's own clock.
#[pyclass(module = "ncp", frozen)]
pub(crate) struct CommandWatchdog(Mutex<resilience::CommandWatchdog>);

#[pymethods]
impl CommandWatchdog {
    #[new]
    fn new() -> Self {
        Self(Mutex::new(resilience::CommandWatchdog::new()))
    }

    /// Takes note of a command received at `now_s`; whether its `seq` advanced and refreshed the deadline.
    fn on_command(
        &self,
        #[pyo3(from_py_with = double)] now_s: f64,
        #[pyo3(from_py_with = double)] ttl_ms: f64,
        #[pyo3(from_py_with = integer)] seq: i64,
    ) -> bool {
        lock(&self.0).on_command(now_s, ttl_ms, seq)
    }

    /// Whether the plant holds at `now_s`.
    fn should_hold(&self, #[pyo3(from_py_with = double)] now_s: f64) -> bool {
        lock(&self.0).should_hold(now_s)
    }

    /// Forgets every command: the plant holds until a new one comes.
    fn reset(&self) {
        lock(&self.0).reset();
    }
}

/// Keeps the newest command and replays its horizon. All times are seconds on the plant's own clock.
#[pyclass(module = "ncp", frozen)]
pub(crate) struct ActionBuffer(Mutex<resilience::ActionBuffer>);

#[pymethods]
impl ActionBuffer {
    #[new]
    fn new() -> Self {
        Self(Mutex::new(resilience::ActionBuffer::new()))
    }

    /// Takes a frame as it arrived at `now_s`: `accepted`, `held`, `stopped` or `dropped`.
    ///
    /// Raises for a frame that cannot be decoded; one that is an ESTOP for all that latches.
    fn on_frame(&self, frame: Frame, #[pyo3(from_py_with = double)] now_s: f64) -> Result<&'static str> {
        Ok(received_name(lock(&self.0).on_frame(frame.bytes(), now_s)?))
    }

    /// Takes a command, a dict or a frame, received at `now_s`: as `on_frame`.
    fn on_command(
        &self,
        command: &Bound<'_, PyAny>,
        #[pyo3(from_py_with = double)] now_s: f64,
    ) -> Result<&'static str> {
        if let Ok(frame) = command.extract::<Frame>() {
            return self.on_frame(frame, now_s);
        }
        let command: CommandFrame = message(command)?;
        Ok(received_name(lock(&self.0).on_command(command, now_s)))
    }

    /// The channels that the plant actuates at `now_s`, or None when it holds.
    fn active<'py>(
        &self,
        py: Python<'py>,
        #[pyo3(from_py_with = double)] now_s: f64,
    ) -> Result<Option<Bound<'py, PyDict>>> {
        let channels = lock(&self.0).active(now_s).cloned();
        channels.map(|channels| channels_to_dict(py, &channels)).transpose()
    }

    /// Clears the latch, the command and the last seq, by a supervisor's decision.
    fn reset(&self) {
        lock(&self.0).reset();
    }

    /// Whether ESTOP is latched.
    #[getter]
    fn is_stopped(&self) -> bool {
        lock(&self.0).is_stopped()
    }
}

/// Counts what a stream loses, and detects bursts, by the `seq` of every frame that arrives.
#[pyclass(module = "ncp", frozen)]
pub(crate) struct LinkMonitor(Mutex<resilience::LinkMonitor>);

#[pymethods]
impl LinkMonitor {
    #[new]
    #[pyo3(signature = (ref_loss=0.05, threshold=5.0))]
    fn new(#[pyo3(from_py_with = double)] ref_loss: f64, #[pyo3(from_py_with = double)] threshold: f64) -> Self {
        Self(Mutex::new(resilience::LinkMonitor::new(ref_loss, threshold)))
    }

    /// Takes note of a frame that arrived.
    fn on_frame(&self, #[pyo3(from_py_with = integer)] seq: i64) {
        lock(&self.0).on_frame(seq);
    }

    /// What is known by now.
    fn report(&self) -> LinkReport {
        LinkReport(lock(&self.0).report())
    }

    /// Whether the detector is above its threshold.
    #[getter]
    fn burst(&self) -> bool {
        lock(&self.0).burst()
    }

    /// Lost over expected, from 0 to 1.
    #[getter]
    fn loss_rate(&self) -> f64 {
        lock(&self.0).loss_rate()
    }
}

/// What a link monitor knows.
#[pyclass(module = "ncp", frozen)]
pub(crate) struct LinkReport(resilience::LinkReport);

#[pymethods]
impl LinkReport {
    /// The highest seq seen; -1: none.
    #[getter]
    fn last_seq(&self) -> i64 {
        self.0.last_seq
    }

    /// Frames that arrived, duplicates aside.
    #[getter]
    fn received(&self) -> i64 {
        self.0.received
    }

    /// Frames that did not.
    #[getter]
    fn lost(&self) -> i64 {
        self.0.lost
    }

    /// Lost over expected, from 0 to 1.
    #[getter]
    fn loss_rate(&self) -> f64 {
        self.0.loss_rate
    }

    /// Whether the detector is above its threshold.
    #[getter]
    fn burst(&self) -> bool {
        self.0.burst
    }
}

/// The lock is never held while Python code runs.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

fn received_name(received: Received) -> &'static str {
    match received {
        Received::Accepted => "accepted",
        Received::Held => "held",
        Received::Stopped => "stopped",
        Received::Dropped => "dropped",
    }
}
