//! Proofs of the safety kernel.
//!
//! | module | what it holds |
//! |---|---|
//! | [`kernel`] | the kernel as a harness calls it |
//! | [`prover`] | what a harness asks of an engine |
//! | [`properties`] | what is claimed, in words, in symbols, and as harnesses that any engine runs |
//! | [`counterexample`] | inputs that break a property |
//! | [`reference`](mod@reference), [`vector`] | counterexamples as vectors |
//! | [`provers`] | what answers a harness: doubles, and terms for a solver |
//! | [`harness`] | the harness of a property on a kernel, ready for each engine |
//! | [`engines`] | symbolic execution, enumeration, and the stand-in for Kani's API |
//! | [`kani_engine`], `kani_proofs` | Kani as an engine, and the harnesses as proofs of it |
//! | [`broken`], `mutants` | copies of the kernel with a planted defect, and with one token changed |
//! | [`pins`] | how much the symbolic engine explores |
//! | [`sabotage`] | engines with a defect of their own |
//! | [`report`], [`digest`] | what was found out, and about which sources |
//! | [`evidence`] | the counterexamples of all engines as one file of vectors |
//! | [`program`] | how an engine's program leaves its result, and how it ends |
//! | [`terminal`] | how it is shown on the terminal |
//!
//! Each row knows those above it, and none below.

#![forbid(unsafe_code)]

pub mod broken;
pub mod counterexample;
pub mod digest;
#[cfg(not(feature = "sabotage"))]
pub mod engines;
pub mod evidence;
pub mod harness;
pub mod kani_engine;
#[cfg(any(kani, test))]
mod kani_proofs;
pub mod kernel;
#[cfg(feature = "mutants")]
pub mod mutants;
pub mod pins;
pub mod program;
pub mod properties;
pub mod prover;
#[cfg(not(feature = "sabotage"))]
pub mod provers;
pub mod reference;
pub mod report;
pub mod sabotage;
pub mod terminal;
pub mod vector;

// The engine with a switch for every defect of its own, which the build script makes of its sources.
#[cfg(feature = "sabotage")]
include!(concat!(env!("OUT_DIR"), "/sabotaged.rs"));
