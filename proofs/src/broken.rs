//! The broken kernels: what each engine has to refute, or it would prove anything.

include!("../broken.rs");

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
