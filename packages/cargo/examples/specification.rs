//! The executable specification, held against the whole corpus at the highest level: a test target as an example, since
//! each of its tests would be a process of its own to those who run a test a process.

#![forbid(unsafe_code)]

use std::process::ExitCode;

use ncp_harness::{Conformance, Level};

fn main() -> ExitCode {
    Conformance::conversation(ncp_peer_rust::hold).level(Level::Strict).run()
}
