//! The peer as a program: requests on standard input, answers on standard output.

#![forbid(unsafe_code)]

use std::process::ExitCode;

fn main() -> ExitCode {
    match ncp_peer_rust::serve() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("ncp-peer-rust: the conversation broke off: {error}");
            ExitCode::FAILURE
        }
    }
}
