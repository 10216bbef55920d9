//! Holds the flight stack against the NCP conformance suite: each case is a test.

use std::process::ExitCode;

use ncp_harness::adapter::reply::Description;
use ncp_harness::adapter::{CallError, Peer, args};
use ncp_harness::{Conformance, Level};
use ncp_harness_example::{CONTRACT_HASH, WIRE_VERSION, is_compatible};

/// The calls of the suite, as calls of the implementation. What is left out is unsupported.
struct FlightStack;

impl Peer for FlightStack {
    type Error = CallError;

    fn describe(&self) -> Result<Description<'_>, CallError> {
        Ok(Description {
            name: "flight-stack".into(),
            version: env!("CARGO_PKG_VERSION").into(),
            language: "Rust".into(),
            wire_version: WIRE_VERSION.into(),
            contract_hash: CONTRACT_HASH.into(),
            roles: vec!["body".into()],
            reference_networks: false,
        })
    }

    fn version_check(&self, args: &args::VersionCheck<'_>) -> Result<bool, CallError> {
        is_compatible(&args.version).map_err(|_| CallError::refused("version", "not a version"))
    }
}

fn main() -> ExitCode {
    // The filter goes once there is more than a version guard.
    Conformance::of(FlightStack).level(Level::Wire).filter("version.check").expected("tests/known.toml").run()
}
