//! What answers a harness: doubles, wherever they come from, and terms for a solver.

pub mod native;
pub mod terms;
