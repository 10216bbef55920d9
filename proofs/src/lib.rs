//! Proofs of the safety kernel.
//!
//! - `properties`: what is claimed, in words, in symbols, and as a harness that any engine runs.
//! - `prover`: what a harness asks of an engine.
//! - `kernel`, `broken`: the kernel of production, and copies of its source with one token changed.
//! - `engines`: symbolic execution, enumeration, and the stand-in for Kani's API.
//! - `kani_engine`, `kani_proofs`: Kani as an engine, and the harnesses as proofs of it.
//! - `report`, `page`, `document`, `digest`: what was found out, how it is shown, and about which sources.

#![forbid(unsafe_code)]

pub mod broken;
pub mod counterexample;
pub mod digest;
pub mod document;
pub mod engines;
pub mod harness;
pub mod kani_engine;
#[cfg(any(kani, test))]
mod kani_proofs;
pub mod kernel;
#[cfg(feature = "mutants")]
pub mod mutants;
pub mod page;
pub mod properties;
pub mod prover;
pub mod reference;
pub mod report;
pub mod terminal;
pub mod vector;
