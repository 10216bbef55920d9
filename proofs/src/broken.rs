//! The broken kernels: what each engine has to refute, or it would prove anything.

use std::path::Path;

use ncp_defects::{Defect, TableError, read};

include!(concat!(env!("OUT_DIR"), "/broken_missing.rs"));

/// Whether the broken kernels are part of this build.
pub const IS_BUILT: bool = cfg!(feature = "broken");

/// The planted defects of the kernel, of its source and of its machine code.
///
/// # Errors
/// The table cannot be read.
pub fn defects() -> Result<Vec<Defect>, TableError> {
    read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../defects/kernel.toml"))
}

/// What is wrong with the table: a defect that has no place in the kernel, or more than one.
#[must_use]
pub fn missing() -> Vec<String> {
    MISSING.iter().map(|(_, why)| format!("a defect of the kernel does not apply: {why}")).collect()
}

/// The harness of a property on a broken kernel: none of them is part of this build.
#[cfg(not(feature = "broken"))]
#[must_use]
pub const fn harness(_name: &str, _property: &str) -> Option<crate::harness::Harness> {
    None
}

#[cfg(feature = "broken")]
/// The copies, which the build script makes of the kernel's source.
#[allow(
    missing_docs,
    dead_code,
    unused_assignments,
    unused_imports,
    unused_variables,
    unused_comparisons,
    unreachable_pub,
    clippy::all,
    reason = "copies of the kernel, broken on purpose"
)]
mod kernels {
    use ncp_kernel::{Channel, Decision, Limit, Mode, Plan, Reason, Received, Scalar, Seq};

    include!(concat!(env!("OUT_DIR"), "/broken_kernels.rs"));
}

#[cfg(feature = "broken")]
pub use kernels::harness;
