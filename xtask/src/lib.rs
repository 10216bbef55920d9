//! What the project's own programs share.
//!
//! - [`project`]: where things are, and how programs are started.
//! - [`setup`]: tools and packages, into folders that git ignores.

#![forbid(unsafe_code)]

pub mod project;
pub mod setup;
