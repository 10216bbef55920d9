//! The reflex controller and the control loop: chapter 10.

use std::sync::{Mutex, MutexGuard, PoisonError};

use ncp_spec::control::{self, Controller as _, LoopConfig, ReflexConfig};
use ncp_spec::resilience::LinkMonitor;
use ncp_spec::safety::{Decision, SafetyGovernor};
use ncp_spec::wire::{CommandFrame, ControlStatus, SensorFrame};
use pyo3::prelude::*;

use crate::argument::{double, vector};
use crate::error::Result;
use crate::message::{message, optional, to_dict};
use crate::safety::{decision_and_reason, limits_of};

/// Commands a velocity towards a target: proportional, with damping.
///
/// `target` is in m, `kp` in 1/s, `max_speed` in m/s an axis.
#[pyclass(module = "ncp", frozen)]
pub(crate) struct ReflexController(control::ReflexController);

#[pymethods]
impl ReflexController {
    #[new]
    #[pyo3(signature = (target=[0.0, 0.0, 0.0], kp=1.0, kd=0.3, max_speed=1.5))]
    fn new(
        #[pyo3(from_py_with = vector)] target: [f64; 3],
        #[pyo3(from_py_with = double)] kp: f64,
        #[pyo3(from_py_with = double)] kd: f64,
        #[pyo3(from_py_with = double)] max_speed: f64,
    ) -> Result<Self> {
        Ok(Self(control::ReflexController::new(ReflexConfig { target_m: target, kp, kd, max_speed_mps: max_speed })?))
    }

    /// The fields of the command for what is sensed: a dict or a frame; a hold without it.
    #[pyo3(signature = (sensor=None))]
    fn step<'py>(&self, py: Python<'py>, sensor: Option<&Bound<'py, PyAny>>) -> Result<Bound<'py, PyAny>> {
        let sensor: Option<SensorFrame> = optional(sensor)?;
        // The clock is nothing to a controller without memory.
        to_dict(py, self.0.clone().step(0.0, sensor.as_ref()))
    }
}

/// A control loop with a reflex controller, a governor with the canonical channels and a link monitor.
///
/// It has no clock of its own: `now_s` is a time in seconds on one monotonic clock.
#[pyclass(module = "ncp", frozen)]
pub(crate) struct ControlLoop(Mutex<control::ControlLoop<control::ReflexController>>);

#[pymethods]
impl ControlLoop {
    #[new]
    #[pyo3(signature = (period_ms, limits, reflex=None))]
    fn new(
        #[pyo3(from_py_with = double)] period_ms: f64,
        limits: &Bound<'_, PyAny>,
        reflex: Option<&Bound<'_, ReflexController>>,
    ) -> Result<Self> {
        let reflex = match reflex {
            Some(reflex) => reflex.get().0.clone(),
            None => control::ReflexController::new(ReflexConfig::default())?,
        };
        Ok(Self(Mutex::new(control::ControlLoop::new(
            LoopConfig { period_ms },
            reflex,
            SafetyGovernor::new(&limits_of(limits)?),
            LinkMonitor::default(),
        )?)))
    }

    /// Takes a sensor frame, a dict or as it arrived at `now_s`; whether it is newer than the one before.
    fn on_sensor(&self, sensor: &Bound<'_, PyAny>, #[pyo3(from_py_with = double)] now_s: f64) -> Result<bool> {
        let sensor: SensorFrame = message(sensor)?;
        Ok(self.lock().on_sensor(sensor, now_s))
    }

    /// One tick at `now_s`; `took_ms` tells how long the one before took, in ms.
    #[pyo3(signature = (now_s, took_ms=0.0))]
    fn tick(&self, #[pyo3(from_py_with = double)] now_s: f64, #[pyo3(from_py_with = double)] took_ms: f64) -> Tick {
        let control::Tick { command, status, decision } = self.lock().tick(now_s, took_ms);
        Tick { command, status, decision }
    }

    /// Clears the governor's latch, by a supervisor's decision.
    fn reset(&self) {
        self.lock().governor_mut().reset();
    }

    /// Whether ESTOP is latched.
    #[getter]
    fn is_stopped(&self) -> bool {
        self.lock().governor_mut().is_stopped()
    }
}

impl ControlLoop {
    /// The lock is never held while Python code runs.
    fn lock(&self) -> MutexGuard<'_, control::ControlLoop<control::ReflexController>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// What a tick sends.
#[pyclass(module = "ncp", frozen)]
pub(crate) struct Tick {
    command: CommandFrame,
    status: ControlStatus,
    decision: Decision,
}

#[pymethods]
impl Tick {
    /// The fields of the command, for the action plane.
    #[getter]
    fn command<'py>(&self, py: Python<'py>) -> Result<Bound<'py, PyAny>> {
        to_dict(py, self.command.clone())
    }

    /// The fields of the ControlStatus, for the observation plane.
    #[getter]
    fn status<'py>(&self, py: Python<'py>) -> Result<Bound<'py, PyAny>> {
        to_dict(py, self.status.clone())
    }

    /// What the governor did: `passed`, `limited`, `held` or `stopped`.
    #[getter]
    fn decision(&self) -> &'static str {
        decision_and_reason(self.decision).0
    }

    /// Why it held or stopped.
    #[getter]
    fn reason(&self) -> Option<&'static str> {
        decision_and_reason(self.decision).1
    }
}
