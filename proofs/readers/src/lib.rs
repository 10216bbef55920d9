//! Proofs of what reads untrusted bytes: the decoder of blocks, the version guard, the segments of keys.
//!
//! | module | what it holds |
//! |---|---|
//! | [`readers`] | what reads blocks, versions and keys, as a harness calls it |
//! | [`properties`] | what is claimed, in words, in symbols, and as a harness that any engine runs |
//! | [`exhaustive`] | the engine, which runs a harness on every input within the bounds |
//! | [`broken`] | the planted defects, and copies of the readers with one of them |
//! | `kani_proofs` | the harnesses as proofs of Kani |

#![forbid(unsafe_code)]

pub mod broken;
pub mod exhaustive;
#[cfg(any(kani, test))]
mod kani_proofs;
pub mod properties;
pub mod readers;
