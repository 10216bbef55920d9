//! NCP for C and C++: `ncp-spec` behind a C ABI.
//!
//! `include/ncp.h` is generated from this crate and says to a C program all that it has to know;
//! `include/ncp.hpp` wraps that for C++17.
//!
//! - `abi`: what crosses the boundary. All unsafe reading and writing of memory starts there.
//! - `seed`: the 14 functions that every C build of NCP exports.
//! - `wire`, `bulk`, `safety`, `control`, `session`: what this build offers beyond them.
//! - `json`: the JSON texts that are no frames.
//!
//! The modules are public so that cbindgen and rustdoc show them; Rust programs use `ncp-spec`.
//!
//! Three rules hold for every function. A required pointer that is null, or a text that is not
//! UTF-8, is an error and never a default. A panic is an error too and never unwinds into C. And
//! where a failure could move a plant, the value that says "failed" makes a careless caller hold.

#![expect(unsafe_code, reason = "a C ABI is made of pointers that only its caller can vouch for")]
#![warn(clippy::undocumented_unsafe_blocks)]

#[cfg(not(panic = "unwind"))]
compile_error!("a panic that aborts would end the C program: build with panic = \"unwind\"");

pub mod abi;
pub mod bulk;
pub mod control;
mod json;
pub mod safety;
pub mod seed;
pub mod session;
pub mod wire;
