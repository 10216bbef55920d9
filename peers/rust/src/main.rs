//! The peer as a program: requests on standard input, answers on standard output.

#![forbid(unsafe_code)]

use std::io::{self, BufReader, BufWriter};
use std::process::ExitCode;

/// As much as a pipe holds: a larger buffer would never be filled by one read.
const BUFFER: usize = 64 << 10;

fn main() -> ExitCode {
    let input = BufReader::with_capacity(BUFFER, io::stdin().lock());
    let output = BufWriter::with_capacity(BUFFER, io::stdout().lock());
    match ncp_peer_rust::hold(input, output) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("ncp-peer-rust: the conversation broke off: {error}");
            ExitCode::FAILURE
        }
    }
}
