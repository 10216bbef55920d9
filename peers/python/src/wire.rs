//! Frames, the version guard, the contract's identity, replies and planes: chapters 1 to 4.

use ncp_spec::plane::{self, Plane};
use ncp_spec::wire;
use ncp_spec::{ErrorCode, contract, reply, version};
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedStr;
use pyo3::types::PyDict;

use crate::argument::Frame;
use crate::error::{Error, Result};
use crate::message::{self, build, to_dict};

/// Whether a peer's wire version is compatible. Strict: raises unless it is.
#[pyfunction]
#[pyo3(signature = (version, strict=false))]
pub(crate) fn check_version(version: PyBackedStr, strict: bool) -> Result<bool> {
    Ok(version::check_version(&version, strict)?)
}

/// `match`, `mismatch` or `not_advertised`. Advisory: a mismatch is no reason to reject a peer.
#[pyfunction]
#[pyo3(signature = (peer_hash=None))]
pub(crate) fn contract_status(peer_hash: Option<PyBackedStr>) -> &'static str {
    contract::contract_status(peer_hash.as_deref()).as_str()
}

/// Accepts only a peer with the same contract hash: the strict opt-in.
#[pyfunction]
#[pyo3(signature = (peer_hash=None))]
pub(crate) fn verify_contract(peer_hash: Option<PyBackedStr>) -> Result<()> {
    Ok(contract::verify_contract(peer_hash.as_deref())?)
}

/// The version guard, strict, and then the contract status.
#[pyfunction]
#[pyo3(signature = (version, contract_hash=None))]
pub(crate) fn negotiate(version: PyBackedStr, contract_hash: Option<PyBackedStr>) -> Result<&'static str> {
    Ok(contract::negotiate(&version, contract_hash.as_deref())?.as_str())
}

/// Checks a frame of this kind, and returns it normalised: every field, in the contract's order.
#[pyfunction]
#[pyo3(name = "validate")]
pub(crate) fn validate(kind: PyBackedStr, json: Frame) -> Result<String> {
    let message = wire::decode(message::kind(&kind)?, json.bytes())?;
    // A frame may hold what this peer may read and not send.
    Ok(message.encode().unwrap_or_else(|_| message.fields()))
}

/// The fields of a frame of this kind, as a dict.
#[pyfunction]
#[pyo3(name = "decode")]
pub(crate) fn decode<'py>(py: Python<'py>, kind: PyBackedStr, frame: Frame) -> Result<Bound<'py, PyAny>> {
    to_dict(py, wire::decode(message::kind(&kind)?, frame.bytes())?)
}

/// Writes a frame of this kind. What `fields` leaves out takes a program's defaults.
#[pyfunction]
#[pyo3(name = "encode")]
pub(crate) fn encode(kind: PyBackedStr, fields: &Bound<'_, PyAny>) -> Result<String> {
    Ok(build(message::kind(&kind)?, fields)?.encode()?)
}

/// Checks a reply to a request as a client does, and returns its fields.
#[pyfunction]
pub(crate) fn check_reply<'py>(py: Python<'py>, request: Frame, reply: Frame) -> Result<Bound<'py, PyAny>> {
    let request = wire::decode_any(request.bytes())?;
    to_dict(py, reply::check_reply(&request, reply.bytes())?)
}

/// One channel's value as JSON: `data`, a number or a sequence of numbers, in `unit`.
#[pyfunction]
#[pyo3(signature = (data, unit=None))]
pub(crate) fn channel_value(data: &Bound<'_, PyAny>, unit: Option<&Bound<'_, PyAny>>) -> Result<String> {
    const NAME: &str = "value";
    let py = data.py();
    let value = PyDict::new(py);
    if data.len().is_err() && crate::argument::double(data).is_ok() {
        value.set_item("data", [data])?;
    } else {
        value.set_item("data", data)?;
    }
    value.set_item("unit", unit)?;
    // Any frame with channels checks and writes a channel value.
    let fields = PyDict::new(py);
    let channels = PyDict::new(py);
    channels.set_item(NAME, value)?;
    fields.set_item("channels", channels)?;
    let message = build(wire::Kind::SensorFrame, fields.as_any())?;
    let text = message.encode()?;
    let frame: serde_json::Value =
        serde_json::from_str(&text).map_err(|error| Error::refused(ErrorCode::Internal, &error))?;
    Ok(frame["channels"][NAME].to_string())
}

/// How the messages of a plane travel: `control`, `perception`, `action` or `observation`.
#[pyfunction]
pub(crate) fn plane_qos(plane: PyBackedStr) -> Result<Qos> {
    let plane = Plane::parse(&plane)
        .ok_or_else(|| Error::refused(ErrorCode::Value, &"a plane is control, perception, action or observation"))?;
    Ok(Qos(plane.qos()))
}

/// The quality of service of a plane.
#[pyclass(module = "ncp", frozen)]
pub(crate) struct Qos(plane::Qos);

#[pymethods]
impl Qos {
    /// When the network cannot keep up: `block` or `drop`.
    #[getter]
    fn congestion(&self) -> &'static str {
        self.0.congestion.as_str()
    }

    /// `Data`, `DataHigh` or `RealTime`.
    #[getter]
    fn priority(&self) -> &'static str {
        self.0.priority.as_str()
    }

    /// Whether messages are sent without batching.
    #[getter]
    fn express(&self) -> bool {
        self.0.express
    }

    fn __repr__(&self) -> String {
        format!(
            "Qos(congestion={:?}, priority={:?}, express={})",
            self.congestion(),
            self.priority(),
            if self.0.express { "True" } else { "False" }
        )
    }
}
