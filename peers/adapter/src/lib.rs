//! The skeleton of an adapter in Rust: an implementation of NCP behind the peer protocol.
//!
//! `peers/PROTOCOL.md` describes the conversation and every call. This crate holds the conversation, parses what a call
//! is given and writes what it answers. An author implements [`Peer`], a method a call; what is left out is answered as
//! unsupported. The crate knows no implementation of NCP and decides nothing.
//!
//! | module | what it holds |
//! |---|---|
//! | [`args`] | what each call is given |
//! | [`steps`] | the steps of a trace, and how they are done |
//! | [`reply`] | what calls and steps give |
//! | [`json`] | JSON, bit for bit, and messages with serde's traits |
//! | [`value`] | numbers, bytes, columns and messages in the form of the protocol |
//! | `peer` | the calls: [`Peer`] |
//! | `conversation` | lines in, lines out: [`serve`], [`hold`], [`ask`] |
//! | `error` | why a call has no result: [`CallError`] |
//!
//! ```
//! use ncp_adapter::reply::Description;
//! use ncp_adapter::{Answer, CallError, Peer, args, ask};
//!
//! struct FlightStack;
//!
//! impl Peer for FlightStack {
//!     type Error = CallError;
//!
//!     fn describe(&self) -> Result<Description<'_>, CallError> {
//!         Ok(Description {
//!             name: "flight-stack".into(),
//!             version: "3.1.0".into(),
//!             language: "Rust".into(),
//!             wire_version: "0.4".into(),
//!             contract_hash: "2cf0763ad61e4f1c".into(),
//!             roles: vec!["body".into()],
//!             reference_networks: false,
//!         })
//!     }
//!
//!     fn version_check(&self, args: &args::VersionCheck<'_>) -> Result<bool, CallError> {
//!         Ok(args.version == "0.4")
//!     }
//! }
//!
//! let answer = ask(&FlightStack, "version.check", r#"{"version":"0.3","strict":false}"#);
//! assert_eq!(answer, Answer::Result(r#"{"compatible":false}"#.to_owned()));
//! assert_eq!(ask(&FlightStack, "plane.qos", r#"{"plane":"action"}"#), Answer::Unsupported);
//! ```
//!
//! Its `main` is `ncp_adapter::serve(&FlightStack)`; `examples/small.rs` is a whole program.

#![forbid(unsafe_code)]

pub mod args;
mod conversation;
mod error;
pub mod json;
mod peer;
pub mod reply;
pub mod steps;
pub mod value;

pub use conversation::{Answer, ask, hold, serve};
pub use error::CallError;
pub use peer::Peer;
