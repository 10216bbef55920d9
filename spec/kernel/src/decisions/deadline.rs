//! How long a command is worth anything, and how old a sensor frame may be.

use ncp_kernel::Scalar;

/// The longest time for which a plant acts upon one command, in ms. `// [NCP-RES-004]`
pub const MAX_TTL_MS: f64 = 60_000.0;

/// The ttl that a plant enforces for a command's `ttl_ms`: at most [`MAX_TTL_MS`], and none for one
/// that is not finite or not positive. In ms.
#[inline]
pub fn enforced_ttl_ms<S: Scalar>(ttl_ms: S) -> Option<S> {
    // [NCP-RES-005]
    if !is_duration(ttl_ms) {
        return None;
    }
    // [NCP-RES-004]
    let most = S::constant(MAX_TTL_MS);
    Some(if ttl_ms.lt(most) { ttl_ms } else { most })
}

/// Whether a command received at `received_s` may still be acted upon at `now_s`, both in seconds on
/// the plant's clock.
#[inline]
pub fn within_deadline<S: Scalar>(now_s: S, received_s: S, ttl_ms: S) -> bool {
    let Some(ttl_ms) = enforced_ttl_ms(ttl_ms) else {
        return false;
    };
    // [NCP-RES-007] [NCP-RES-008]
    if !now_s.is_finite() || !received_s.is_finite() || !received_s.le(now_s) {
        return false;
    }
    // [NCP-RES-002] [NCP-RES-003]
    age_ms(now_s, received_s).le(ttl_ms)
}

/// Whether a sensor frame received at `last_s` is fresh at `now_s`, both in seconds on one clock.
#[inline]
pub fn is_fresh<S: Scalar>(now_s: S, last_s: S, timeout_ms: S) -> bool {
    // [NCP-SAFE-032]
    if !is_duration(timeout_ms) {
        return false;
    }
    // [NCP-SAFE-031] [NCP-SAFE-035]
    if !now_s.is_finite() || !last_s.is_finite() || !last_s.le(now_s) {
        return false;
    }
    // [NCP-SAFE-033] [NCP-SAFE-034]
    age_ms(now_s, last_s).le(timeout_ms)
}

/// Whether a duration is one: finite and positive. `// [NCP-SAFE-068] [NCP-RES-027]`
#[inline]
pub fn is_duration<S: Scalar>(value: S) -> bool {
    value.is_finite() && S::constant(0.0).lt(value)
}

/// From `then_s` to `now_s`, in ms. `[NCP-SAFE-033] [NCP-RES-002]`
#[inline]
pub fn age_ms<S: Scalar>(now_s: S, then_s: S) -> S {
    now_s.sub(then_s).mul(S::constant(1000.0))
}
