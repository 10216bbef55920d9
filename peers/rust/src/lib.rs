//! The peer of the executable specification: `ncp-spec` behind the peer protocol.
//!
//! An adapter and nothing more: it hands over what the requests hold and reports what
//! `ncp-spec` did with it. `peers/PROTOCOL.md` describes the conversation and every call.
//! The program holds the conversation; a test asks single calls with [`ask`].
//!
//! - `conversation`: lines in, lines out.
//! - `calls`: one function a call.
//! - `traces`: the calls that hold a whole trace.
//! - `value`: numbers, bytes and messages in the form that requests and answers give them.
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
mod conversation;
mod traces;
mod value;

pub use conversation::{Answer, ask, hold};
