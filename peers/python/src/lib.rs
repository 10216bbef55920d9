//! The Python module `ncp`: `ncp-spec` as Python programs want it.
//!
//! This crate is the part `ncp._ncp`. The package around it, in `python/ncp`, re-exports it and
//! adds what is easier said in Python. Nothing here decides anything: each function hands over to
//! `ncp-spec`.
//!
//! A text is a *frame*, JSON as it travels, and is read as strictly as any frame is. A dict holds the
//! *fields* of a message in a program's hands: what it leaves out takes the program's defaults.
//!
//! - `error`: every refusal is an `NcpError`, a `ValueError` with a code and a path.
//! - `argument`: numbers and texts as arguments.
//! - `message`: messages from dicts and to dicts.
//! - `wire`: frames, versions, contract, planes.
//! - `keys`, `bulk`, `safety`, `resilience`, `codec`, `control`, `session`: the modules of `ncp-spec`.

#![forbid(unsafe_code)]
#![expect(clippy::needless_pass_by_value, reason = "PyO3 hands converted arguments over")]

mod argument;
mod bulk;
mod codec;
mod control;
mod error;
mod keys;
mod message;
mod resilience;
mod safety;
mod session;
mod wire;

/// NCP's executable specification, bound. Import `ncp` instead.
#[pyo3::pymodule]
mod _ncp {
    use pyo3::prelude::*;

    #[pymodule_export]
    use crate::{
        bulk::{bulk_directory, bulk_encode, observation_check, observation_pack},
        codec::{RateCodec, RateMapping, decode_command, encode_rates},
        control::{ControlLoop, ReflexController, Tick},
        error::NcpError,
        keys::{Keys, key_matches},
        resilience::{ActionBuffer, CommandWatchdog, LinkMonitor, LinkReport, max_horizon_len},
        safety::{SafetyGovernor, govern},
        session::SessionService,
        wire::{
            Qos, channel_value, check_reply, check_version, contract_status, decode, encode, negotiate, plane_qos,
            validate, verify_contract,
        },
    };

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("NCP_VERSION", ncp_spec::WIRE_VERSION)?;
        module.add("CONTRACT_HASH", ncp_spec::CONTRACT_HASH)?;
        module.add("DEFAULT_REALM", ncp_spec::keys::DEFAULT_REALM)?;
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
