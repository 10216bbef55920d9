//! The broken kernels: what each engine has to refute, or it would prove anything.

include!("../broken.rs");
include!(concat!(env!("OUT_DIR"), "/broken_missing.rs"));

/// Whether the broken kernels are part of this build.
pub const IS_BUILT: bool = cfg!(feature = "broken");

/// What is wrong with the table: a broken kernel that is none, as its text is not in the kernel once.
#[must_use]
pub fn missing() -> Vec<String> {
    let broken = |id: &str| BROKEN.iter().find(|broken| broken.id == id);
    let missing = MISSING.iter().filter_map(|(id, times)| Some((broken(id)?, times)));
    missing
        .map(|(broken, times)| {
            format!("the broken kernel {} does not apply: its text occurs {times} times in {}", broken.id, broken.file)
        })
        .collect()
}

/// The harness of its property on a broken kernel: none of them is part of this build.
#[cfg(not(feature = "broken"))]
#[must_use]
pub const fn harness(_id: &str) -> Option<crate::properties::Harness> {
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
    use ncp_spec::safety::kernel::{Channel, Decision, Limit, Plan, Reason, Received, Scalar, Seq};
    use ncp_spec::wire::Mode;

    include!(concat!(env!("OUT_DIR"), "/broken_kernels.rs"));
}

#[cfg(feature = "broken")]
pub use kernels::harness;
