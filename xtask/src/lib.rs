//! Where things are, how programs are started, and what is installed: what the project's commands share.
//!
//! - [`project`]: the checked-out project.
//! - [`setup`]: tools and packages, into folders that git ignores.

#![forbid(unsafe_code)]

pub mod project;
pub mod setup;
