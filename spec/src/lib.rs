//! The executable specification of the Neuro-Cybernetic Protocol (NCP).
//!
//! This crate does what the normative text says. A comment such as `// [NCP-WIRE-007]` stands where the code implements
//! that rule; the crate `ncp-text`, in `text/`, holds the prose, one rule a sentence, and parses from it what is stated
//! as data. The decisions that keep a plant safe are a crate of their own, `ncp-kernel`, in `kernel/`.
//!
//! It reaches no network, and has no async runtime and no `unsafe`. No input makes it panic, and decoding takes memory
//! within a small constant times the input.
//!
//! | module | what it holds | chapter |
//! |---|---|---|
//! | [`wire`] | messages, enums, strict decoding, encoding | 1, 6 |
//! | [`version`] | the wire version and its guard | 2.1 |
//! | [`contract`] | the contract's identity, negotiation | 2.2, 2.3 |
//! | [`plane`] | the planes and their quality of service | 3.1 |
//! | [`keys`] | keys, segments and matching | 3.2 to 3.4 |
//! | [`session`] | the simulation service and the reference backend | 4 |
//! | [`reply`] | what a client accepts as a reply | 4 |
//! | [`bulk`] | the binary column block, and observations in it | 5 |
//! | [`safety`] | the governor: the gates in their order | 7 |
//! | [`resilience`] | the watchdog, the action buffer, the link monitor | 8 |
//! | [`codec`] | the rate codec | 9 |
//! | [`control`] | the control loop and the reflex controller | 10 |
//! | [`bus`] | the model of a transport, within one process, and a client on it | 4, 11 |
//! | `error_code` | [`ErrorCode`]: why something was refused | all |
//!
//! The strict profile (chapter 12.1) is a switch in the
//! modules that it concerns.
//!
//! # Example
//!
//! A controller builds a command, a body reads it, and both refuse what is not NCP:
//!
//! ```
//! use ncp_spec::wire::{ChannelMap, ChannelValue, CommandFrame, Frame, Mode};
//!
//! let command = CommandFrame {
//!     seq: 42,
//!     ttl_ms: 150.0,
//!     channels: ChannelMap::from_iter([(
//!         "velocity_setpoint",
//!         ChannelValue::new([0.5, 0.0, -0.2], "m/s"),
//!     )]),
//!     ..CommandFrame::default()
//! };
//! let sent = command.encode()?;
//!
//! let received = CommandFrame::decode(sent.as_bytes())?;
//! assert_eq!(received, command);
//! assert_eq!(received.mode, Mode::Active);
//!
//! // A frame that does not say what the plant may do does not move it.
//! let silent = CommandFrame::decode(br#"{"kind":"command_frame","seq":43}"#)?;
//! assert_eq!(silent.mode, Mode::Hold);
//!
//! let twice = CommandFrame::decode(br#"{"kind":"command_frame","seq":1,"seq":2}"#).unwrap_err();
//! assert_eq!(twice.to_string(), "seq: the member occurs twice (byte 38)");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#![forbid(unsafe_code)]

// What reads versions, keys and blocks names the rest by this crate's name, so that a copy of it elsewhere, with a
// planted defect, stands beside the same rest.
extern crate self as ncp_spec;

pub mod bulk;
pub mod bus;
pub mod codec;
pub mod contract;
pub mod control;
mod error_code;
pub mod keys;
pub mod plane;
pub mod reply;
pub mod resilience;
pub mod safety;
pub mod session;
pub mod version;
pub mod wire;

pub use contract::CONTRACT_HASH;
pub use error_code::ErrorCode;
pub use version::WIRE_VERSION;
