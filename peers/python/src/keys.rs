//! Keys and their matching: chapter 3.

use ncp_spec::keys;
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedStr;

use crate::error::Result;

/// Builds the keys of one realm, the default one without a name.
#[pyclass(module = "ncp", frozen)]
pub(crate) struct Keys(keys::Keys);

#[pymethods]
impl Keys {
    #[new]
    #[pyo3(signature = (realm=None))]
    fn new(realm: Option<PyBackedStr>) -> Result<Self> {
        Ok(Self(keys::Keys::new(realm.as_deref())?))
    }

    /// The realm.
    #[getter]
    fn realm(&self) -> &str {
        self.0.realm()
    }

    /// The key of the control RPC.
    fn rpc(&self) -> Result<String> {
        Ok(self.0.rpc()?)
    }

    /// The key of a session's sensor stream.
    fn sensor(&self, session: PyBackedStr) -> Result<String> {
        Ok(self.0.sensor(&session, None)?)
    }

    /// The key of a session's sensor stream of this name.
    fn sensor_named(&self, session: PyBackedStr, name: PyBackedStr) -> Result<String> {
        Ok(self.0.sensor(&session, Some(&name))?)
    }

    /// The key of a session's command stream.
    fn command(&self, session: PyBackedStr) -> Result<String> {
        Ok(self.0.command(&session, None)?)
    }

    /// The key of a session's command stream of this name.
    fn command_named(&self, session: PyBackedStr, name: PyBackedStr) -> Result<String> {
        Ok(self.0.command(&session, Some(&name))?)
    }

    /// The key of a session's observations.
    fn observation(&self, session: PyBackedStr) -> Result<String> {
        Ok(self.0.observation(&session)?)
    }

    /// Covers all sensor streams of a session.
    fn sensor_glob(&self, session: PyBackedStr) -> Result<String> {
        Ok(self.0.sensor_glob(&session)?)
    }

    /// Covers all command streams of a session.
    fn command_glob(&self, session: PyBackedStr) -> Result<String> {
        Ok(self.0.command_glob(&session)?)
    }

    /// Covers all of a session.
    fn session_glob(&self, session: PyBackedStr) -> Result<String> {
        Ok(self.0.session_glob(&session)?)
    }

    /// Covers all sessions of the realm.
    fn fleet_glob(&self) -> Result<String> {
        Ok(self.0.fleet_glob()?)
    }

    fn __repr__(&self) -> String {
        format!("Keys({:?})", self.0.realm())
    }
}

/// Whether a key expression covers a key, by Zenoh's rules.
#[pyfunction]
pub(crate) fn key_matches(pattern: PyBackedStr, key: PyBackedStr) -> Result<bool> {
    Ok(keys::matches(&pattern, &key)?)
}
