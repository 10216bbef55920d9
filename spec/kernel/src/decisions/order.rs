//! Which command is newer: a stale, duplicate or reordered one changes nothing.

use ncp_kernel::Seq;

/// Whether a command of `seq` advances a stream whose last accepted one had `last`.
/// `// [NCP-RES-009]`
#[inline]
pub fn advances<Q: Seq>(last: Option<Q>, seq: Q) -> bool {
    match last {
        None => true,
        Some(last) => last.lt(seq),
    }
}

/// Whether a HOLD of `seq` takes effect on a stream whose last accepted command had `last`.
/// `// [NCP-RES-023]`
#[inline]
pub fn hold_takes_effect<Q: Seq>(last: Option<Q>, seq: Q) -> bool {
    match last {
        None => true,
        Some(last) => seq.is_zero() || !seq.lt(last),
    }
}
