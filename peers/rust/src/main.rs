//! The peer of the executable specification: `ncp-spec` behind the peer protocol.
//!
//! An adapter and nothing more: it hands over what the requests hold and reports what
//! `ncp-spec` did with it. `peers/PROTOCOL.md` describes the conversation and every call.
//!
//! - `conversation`: lines in, lines out.
//! - `calls`: one function a call.
//! - `value`: numbers and bytes in the form that requests and answers give them.

#![forbid(unsafe_code)]

mod calls;
mod conversation;
mod value;

use std::io::{self, BufReader, BufWriter};
use std::process::ExitCode;

/// As much as a pipe holds: a larger buffer would never be filled by one read.
const BUFFER: usize = 64 << 10;

fn main() -> ExitCode {
    let input = BufReader::with_capacity(BUFFER, io::stdin().lock());
    let output = BufWriter::with_capacity(BUFFER, io::stdout().lock());
    match conversation::hold(input, output) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("ncp-peer-rust: the conversation broke off: {error}");
            ExitCode::FAILURE
        }
    }
}
