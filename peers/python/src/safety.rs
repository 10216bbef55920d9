//! The governor: chapter 7.

use std::sync::{Mutex, PoisonError};

use ncp_spec::ErrorCode;
use ncp_spec::safety::{self, Decision, Reason};
use ncp_spec::wire::{self, Capabilities, CommandFrame, Frame as _, Kind, SafetyLimits, SensorFrame};
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedStr;
use pyo3::types::{PyDict, PyString};
use serde_json::value::RawValue;

use crate::argument::{Frame, double, optional_double, wrong_type};
use crate::error::{Error, Result};
use crate::message::{TryFromMessage as _, build, message, optional, to_dict};

/// Stands at the end of a control loop and lets a command pass only when it is safe.
///
/// `limits` are the fields of SafetyLimits, as a dict or as JSON. Without channels the governor takes
/// the canonical ones; with the channels that were negotiated, a limit that cannot act on them is a
/// config fault, from which it never recovers.
#[pyclass(module = "ncp", frozen)]
pub(crate) struct SafetyGovernor(Mutex<Governor>);

struct Governor {
    governor: safety::SafetyGovernor,
    last: Option<Decision>,
}

#[pymethods]
impl SafetyGovernor {
    #[new]
    #[pyo3(signature = (limits, sensor_channels=None, command_channels=None))]
    fn new(
        limits: &Bound<'_, PyAny>,
        sensor_channels: Option<&Bound<'_, PyAny>>,
        command_channels: Option<&Bound<'_, PyAny>>,
    ) -> Result<Self> {
        if sensor_channels.is_none() && command_channels.is_none() {
            return Ok(Self::of(safety::SafetyGovernor::new(&limits_of(limits)?)));
        }
        let fields = PyDict::new(limits.py());
        for (name, channels) in [("sensor_channels", sensor_channels), ("command_channels", command_channels)] {
            if let Some(channels) = channels {
                fields.set_item(name, channels)?;
            }
        }
        let declared: Capabilities = message(fields.as_any())?;
        Ok(Self::of(safety::SafetyGovernor::negotiated(
            &limits_of(limits)?,
            &declared.sensor_channels,
            &declared.command_channels,
        )))
    }

    /// A governor for the limits and the channels that a plant declares, as a dict or a frame.
    #[staticmethod]
    fn from_capabilities(capabilities: &Bound<'_, PyAny>) -> Result<Self> {
        let capabilities: Capabilities = message(capabilities)?;
        Ok(Self::of(safety::SafetyGovernor::from_capabilities(&capabilities)))
    }

    /// Decides on a command, a dict or a frame, and returns the fields of what may be sent.
    ///
    /// `now_s` is the governor's clock, `last_sensor_s` the time on it at which `sensor` was received,
    /// both in seconds.
    #[pyo3(signature = (command, now_s, sensor=None, last_sensor_s=None))]
    fn govern<'py>(
        &self,
        py: Python<'py>,
        command: &Bound<'py, PyAny>,
        #[pyo3(from_py_with = double)] now_s: f64,
        sensor: Option<&Bound<'py, PyAny>>,
        #[pyo3(from_py_with = optional_double)] last_sensor_s: Option<f64>,
    ) -> Result<Bound<'py, PyAny>> {
        let mut command: CommandFrame = message(command)?;
        let sensor: Option<SensorFrame> = optional(sensor)?;
        self.with(|this| {
            let decision = this.governor.govern(&mut command, now_s, sensor.as_ref(), last_sensor_s);
            this.last = Some(decision);
        });
        to_dict(py, command)
    }

    /// Takes note of the link: a burst of losses latches ESTOP.
    fn note_link(&self, burst: bool) {
        self.with(|this| this.governor.note_link(burst));
    }

    /// Clears the latch, by a supervisor's decision. A config fault stays.
    fn reset(&self) {
        self.with(|this| this.governor.reset());
    }

    /// Whether ESTOP is latched.
    #[getter]
    fn is_stopped(&self) -> bool {
        self.with(|this| this.governor.is_stopped())
    }

    /// Whether the limits cannot be enforced.
    #[getter]
    fn has_config_fault(&self) -> bool {
        self.with(|this| this.governor.has_config_fault())
    }

    /// What became of the last command: `passed`, `limited`, `held` or `stopped`.
    #[getter]
    fn decision(&self) -> Option<&'static str> {
        self.with(|this| this.last).map(|last| decision_and_reason(last).0)
    }

    /// Why it was held or stopped.
    #[getter]
    fn reason(&self) -> Option<&'static str> {
        self.with(|this| this.last).and_then(|last| decision_and_reason(last).1)
    }
}

impl SafetyGovernor {
    fn of(governor: safety::SafetyGovernor) -> Self {
        Self(Mutex::new(Governor { governor, last: None }))
    }

    /// The lock is never held while Python code runs.
    fn with<T>(&self, act: impl FnOnce(&mut Governor) -> T) -> T {
        act(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

/// Governs one command with the canonical channels: JSON in, JSON out.
///
/// Nothing is remembered: whoever needs the latch uses a SafetyGovernor.
#[pyfunction]
#[pyo3(signature = (limits_json, command_json, now_s, sensor_json=None, last_sensor_s=None))]
pub(crate) fn govern(
    limits_json: &Bound<'_, PyAny>,
    command_json: Frame,
    #[pyo3(from_py_with = double)] now_s: f64,
    sensor_json: Option<Frame>,
    #[pyo3(from_py_with = optional_double)] last_sensor_s: Option<f64>,
) -> Result<String> {
    let mut command = CommandFrame::decode(command_json.bytes())?;
    let sensor = sensor_json.map(|frame| SensorFrame::decode(frame.bytes())).transpose()?;
    let mut governor = safety::SafetyGovernor::new(&limits_of(limits_json)?);
    governor.govern(&mut command, now_s, sensor.as_ref(), last_sensor_s);
    Ok(command.encode()?)
}

/// Limits, as a dict or as JSON. A limit of an unknown name is refused: it would limit nothing.
pub(crate) fn limits_of(limits: &Bound<'_, PyAny>) -> Result<SafetyLimits> {
    if limits.is_instance_of::<PyString>() {
        let text: PyBackedStr = limits.extract()?;
        return limits_of_json(&text);
    }
    if !limits.is_instance_of::<PyDict>() {
        return Err(wrong_type("a dict of limits, or JSON", limits).into());
    }
    let fields = PyDict::new(limits.py());
    fields.set_item("safety", limits)?;
    let capabilities = build(Kind::Capabilities, fields.as_any())?;
    Ok(Capabilities::take(capabilities)?.safety)
}

fn limits_of_json(text: &str) -> Result<SafetyLimits> {
    let limits: &RawValue = serde_json::from_str(text)
        .map_err(|error| Error::refused(ErrorCode::Malformed, &format_args!("limits: {error}")))?;
    let fields = format!(r#"{{"safety":{limits}}}"#);
    let capabilities = wire::build(Kind::Capabilities, fields.as_bytes())?;
    Ok(Capabilities::take(capabilities)?.safety)
}

/// Both, as words.
pub(crate) fn decision_and_reason(decision: Decision) -> (&'static str, Option<&'static str>) {
    match decision {
        Decision::Passed => ("passed", None),
        Decision::Limited => ("limited", None),
        Decision::Held(reason) => ("held", Some(reason_name(reason))),
        Decision::Stopped(reason) => ("stopped", Some(reason_name(reason))),
    }
}

fn reason_name(reason: Reason) -> &'static str {
    match reason {
        Reason::Estop => "estop",
        Reason::ConfigFault => "config_fault",
        Reason::StaleSensor => "stale_sensor",
        Reason::NoPosition => "no_position",
        Reason::OutsideFence => "outside_fence",
        Reason::NotActive => "not_active",
        Reason::NotFinite => "not_finite",
        Reason::NoVelocity => "no_velocity",
        Reason::BadHorizon => "bad_horizon",
        Reason::LeavesFence => "leaves_fence",
    }
}
