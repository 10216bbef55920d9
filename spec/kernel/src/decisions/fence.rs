//! The geofence: where the plant is, and where a command leads it.

use ncp_kernel::{Plan, Reason, Scalar};

use super::enforced_ttl_ms;
use super::speed::{all_finite, norm};

/// Whether a position lies in the closed ball of `radius` about the origin. False whenever that
/// cannot be computed. `// [NCP-SAFE-043] [NCP-SAFE-044] [NCP-SAFE-045]`
#[inline]
pub fn inside<S: Scalar>(position: &[S; 3], radius: S) -> bool {
    all_finite(position) && radius.is_finite() && S::constant(0.0).lt(radius) && norm(position).le(radius)
}

/// Where a plant is that moves from `position` with `velocity` for `time_s` seconds. `[NCP-SAFE-050]`
#[inline]
pub fn travel<S: Scalar>(position: &[S; 3], velocity: &[S; 3], time_s: S) -> [S; 3] {
    let [x, y, z] = *position;
    let [u, v, w] = *velocity;
    [x.add(u.mul(time_s)), y.add(v.mul(time_s)), z.add(w.mul(time_s))]
}

/// The part of tick `k`, [k·dt, (k+1)·dt), that lies before the end of the ttl; both in ms. 0 when
/// there is none. `[NCP-SAFE-050] [NCP-SAFE-051]`
#[inline]
pub fn tick_share_ms<S: Scalar>(tick: usize, dt_ms: S, ttl_ms: S) -> S {
    // A horizon has at most 4,096 steps: the conversion is exact.
    #[expect(clippy::cast_precision_loss)]
    let start = S::constant(tick as f64).mul(dt_ms);
    if !start.lt(ttl_ms) {
        return S::constant(0.0);
    }
    let rest = ttl_ms.sub(start);
    if dt_ms.lt(rest) { dt_ms } else { rest }
}

/// Where a plant ends that moves from `from` with `velocity` for `time_ms`; none where that is outside the fence.
/// `[NCP-SAFE-050] [NCP-SAFE-051]`
#[inline]
pub fn end_inside<S: Scalar>(from: &[S; 3], velocity: &[S; 3], time_ms: S, radius: S) -> Option<[S; 3]> {
    let end = travel(from, velocity, time_ms.div(S::constant(1000.0)));
    inside(&end, radius).then_some(end)
}

/// Where step `tick` of the horizon ends that begins at `from`; none where that is outside the fence, or where the
/// step has no velocity. Times are in ms. `[NCP-SAFE-050] [NCP-SAFE-055]`
#[inline]
pub fn step_end<S: Scalar>(
    plan: &impl Plan<S>,
    tick: usize,
    from: &[S; 3],
    dt_ms: S,
    ttl_ms: S,
    radius: S,
) -> Option<[S; 3]> {
    let velocity = plan.velocity(tick)?; // [NCP-SAFE-055]
    end_inside(from, &velocity, tick_share_ms(tick, dt_ms, ttl_ms), radius)
}

/// Takes the steps 1, 2, … `steps`, each from what the one before has left, until there is one that cannot be taken.
/// How many were taken, and what the last of them has left.
/// `[NCP-SAFE-050] [NCP-SAFE-066] [NCP-SAFE-067]`
#[inline]
pub fn follow<T>(steps: usize, start: T, mut step: impl FnMut(usize, &T) -> Option<T>) -> (usize, T) {
    let (mut taken, mut left) = (0, start);
    while taken < steps {
        let Some(next) = step(taken + 1, &left) else { break };
        left = next;
        taken += 1;
    }
    (taken, left)
}

/// How many steps of the horizon end inside the fence, from the first on, each projected from the
/// end of the one before.
///
/// # Errors
/// Tick 0 itself leads out, or its velocity cannot be used.
#[inline]
pub fn steps_inside<S: Scalar>(plan: &impl Plan<S>, position: &[S; 3], radius: S) -> Result<usize, Reason> {
    // [NCP-SAFE-052]
    let velocity = plan.velocity(0).ok_or(Reason::NoVelocity)?;
    // A plant does not act on a command whose ttl is no time.
    let ttl_ms = enforced_ttl_ms(plan.ttl_ms()).unwrap_or(S::constant(0.0));
    let first = |time_ms| end_inside(position, &velocity, time_ms, radius).ok_or(Reason::LeavesFence);
    if plan.steps() > 0 {
        let dt_ms = plan.dt_ms().unwrap_or(S::constant(f64::NAN));
        // [NCP-SAFE-051]
        let place = first(tick_share_ms(0, dt_ms, ttl_ms))?;
        let step = |tick, place: &_| step_end(plan, tick, place, dt_ms, ttl_ms, radius);
        let (kept, _) = follow(plan.steps(), place, step);
        if kept > 0 {
            return Ok(kept); // [NCP-SAFE-050]
        }
    }
    // [NCP-SAFE-053] Without a horizon, tick 0 is followed until the ttl ends.
    first(ttl_ms)?;
    Ok(0)
}
