//! The broken readers: what the engine has to refute, or it would prove anything.

use std::path::Path;

use ncp_defects::{Defect, TableError, read};

/// The planted defects of the readers.
///
/// # Errors
/// The table cannot be read.
pub fn defects() -> Result<Vec<Defect>, TableError> {
    read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../defects/readers.toml"))
}

#[cfg(feature = "broken")]
/// The copies, which the build script makes of the readers' sources.
#[allow(
    missing_docs,
    missing_debug_implementations,
    dead_code,
    unused_assignments,
    unused_imports,
    unused_mut,
    unused_variables,
    unreachable_code,
    unreachable_patterns,
    unreachable_pub,
    clippy::all,
    clippy::pedantic,
    clippy::restriction,
    reason = "copies of the readers, broken on purpose"
)]
mod copies {
    include!(concat!(env!("OUT_DIR"), "/broken_readers.rs"));
}

#[cfg(feature = "broken")]
pub use copies::harness;
