//! The tie between the Coq development and the safety kernel: what the shipped source does on terms, as Coq.
//!
//! | module | what it holds |
//! |---|---|
//! | [`term`] | numbers that record, and the exploration of each path |
//! | [`source`] | the kernel's functions, each run on such numbers |
//! | [`coq`] | what came of it, as definitions and as lemmas that they are the model's |

#![forbid(unsafe_code)]

pub mod coq;
pub mod source;
pub mod term;
