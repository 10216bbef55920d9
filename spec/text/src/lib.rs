//! The normative text of the Neuro-Cybernetic Protocol (NCP), and what is parsed from it.
//!
//! The chapters stand in this crate's folder, one Markdown file each. All else in the project takes from here what the
//! text says, and nothing repeats it.
//!
//! | module | what it parses |
//! |---|---|
//! | [`chapters`] | the files themselves |
//! | [`catalogue`] | the rules, one sentence each with an id |
//! | [`identity`] | the wire version and the contract hash, at compile time |

#![forbid(unsafe_code)]

pub mod catalogue;
pub mod chapters;
pub mod identity;

pub use catalogue::Catalogue;
pub use chapters::{CHAPTERS, Chapter};
pub use identity::{CONTRACT_HASH, WIRE_VERSION};
