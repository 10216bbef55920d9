//! The engines: each a way to hold the kernel against the properties.

pub mod bounds;
mod ends;
pub mod enumeration;
pub(crate) mod outcome;
pub mod standin;
pub mod symbolic;

pub use outcome::{Outcome, Patience, Verdict};
