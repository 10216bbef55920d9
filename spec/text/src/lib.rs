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
//! | [`tables`](mod@tables) | messages and enums: fields, types, defaults, wire strings |
//! | [`planes`](mod@planes) | the planes and their quality of service |
//! | [`limits`] | the limits of frames, keys and blocks, at compile time |
//! | [`bulk`] | the golden block |
//! | `markdown` | the cells of a table's row |
//!
//! Feature `assurance` adds what holds the project to the rules:
//!
//! | module | what it reads |
//! |---|---|
#![cfg_attr(feature = "assurance", doc = "| [`exclusions`] | `spec/exclusions.toml`: what nothing can show, and why |")]
#![cfg_attr(
    feature = "assurance",
    doc = "| [`citations`] | the rules that code names, and the functions that name them |"
)]
#![forbid(unsafe_code)]

pub mod bulk;
pub mod catalogue;
pub mod chapters;
#[cfg(feature = "assurance")]
pub mod citations;
#[cfg(feature = "assurance")]
pub mod exclusions;
pub mod identity;
pub mod limits;
mod markdown;
pub mod planes;
pub mod tables;

pub use catalogue::Catalogue;
pub use chapters::{CHAPTERS, Chapter};
pub use identity::{CONTRACT_HASH, WIRE_VERSION};
pub use planes::planes;
pub use tables::tables;
