//! The peer of the executable specification: `ncp-spec` behind the peer protocol.
//!
//! An adapter and nothing more: it hands over what the requests hold and reports what
//! `ncp-spec` did with it. `peers/PROTOCOL.md` describes the conversation and every call;
//! `ncp-adapter` holds the conversation. A test asks single calls with [`ask`].
//!
//! - `calls`: one method a call.
//! - `traces`: the calls that hold a whole trace.
//! - `value`: messages in the form that requests and answers give them.
//! - `refusal`: why `ncp-spec` refused.
//!
//! ```
//! use ncp_peer_rust::{Answer, ask};
//!
//! let answer = ask("version.check", r#"{"version":"0.4","strict":false}"#);
//! assert_eq!(answer, Answer::Result(r#"{"compatible":false}"#.to_owned()));
//! assert_eq!(ask("teleport", "{}"), Answer::Unsupported);
//! ```

#![forbid(unsafe_code)]

mod calls;
mod refusal;
mod traces;
mod value;

use std::io::{self, BufReader, Read, Write};

pub use ncp_adapter::Answer;

/// Answers every request of `input` on `output`, in order, until the input ends.
///
/// # Errors
/// Input that cannot be read, or output that cannot be written.
pub fn hold(input: BufReader<impl Read>, output: impl Write) -> io::Result<()> {
    ncp_adapter::hold(&calls::Specification, input, output)
}

/// As [`hold`], on standard input and output.
///
/// # Errors
/// As [`hold`].
pub fn serve() -> io::Result<()> {
    ncp_adapter::serve(&calls::Specification)
}

/// Answers one call in this process, as the program would; `args` is the JSON text of its arguments.
#[must_use]
pub fn ask(call: &str, args: &str) -> Answer {
    ncp_adapter::ask(&calls::Specification, call, args)
}
