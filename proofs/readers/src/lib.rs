//! Proofs of what reads untrusted bytes: the decoder of blocks, the version guard, the segments of keys.
//!
//! - `properties`: what is claimed, in words, in symbols, and as a harness that any engine runs.
//! - `exhaustive`: the engine, which runs a harness on every input within the bounds.
//! - `readers`, `broken`: the readers of production, and copies of their sources with one edit each.

#![forbid(unsafe_code)]

pub mod broken;
pub mod exhaustive;
#[cfg(any(kani, test))]
mod kani_proofs;
pub mod properties;
pub mod readers;
