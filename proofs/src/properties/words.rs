//! What the text says, as formulas: written from its sentences, not from the kernel's code.

use ncp_kernel::{Limit, Scalar};

use crate::kernel::{GatesState, WatchdogState};
use crate::prover::Prover;

/// min(ttl, 60 s), in ms. `[NCP-RES-004]`
pub(super) fn enforced<P: Prover>(p: &mut P, ttl: P::S) -> P::S {
    let most = p.number(60_000.0);
    let shorter = p.lt(ttl, most);
    p.select(shorter, ttl, most)
}

/// A finite number above 0.
pub(super) fn positive<P: Prover>(p: &mut P, x: P::S) -> P::B {
    let zero = p.number(0.0);
    let (finite, above) = (p.finite(x), p.lt(zero, x));
    p.and(finite, above)
}

/// All finite, `then` ≤ `now`, and `now` − `then` not above `most` and a bound, both in ms.
fn within<P: Prover>(p: &mut P, now: P::S, then: P::S, most: &[P::S]) -> P::B {
    let thousand = p.number(1000.0);
    let age = now.sub(then).mul(thousand);
    let mut parts = vec![p.finite(now), p.finite(then), p.le(then, now)];
    for most in most {
        parts.push(positive(p, *most));
        parts.push(p.le(age, *most));
    }
    p.all(&parts)
}

/// The liveness rule of 8.1 for one command.
pub(super) fn alive<P: Prover>(p: &mut P, now: P::S, received: P::S, ttl: P::S) -> P::B {
    let most = p.number(60_000.0);
    within(p, now, received, &[ttl, most])
}

/// Section 7.4.
pub(super) fn fresh<P: Prover>(p: &mut P, now: P::S, last: P::S, timeout: P::S) -> P::B {
    within(p, now, last, &[timeout])
}

/// `[NCP-RES-009]`
pub(super) fn advances<P: Prover>(p: &mut P, last: Option<P::Q>, seq: P::Q) -> P::B {
    match last {
        None => p.truth(true),
        Some(last) => p.seq_lt(last, seq),
    }
}

/// `[NCP-RES-023]`
pub(super) fn hold_takes_effect<P: Prover>(p: &mut P, last: Option<P::Q>, seq: P::Q) -> P::B {
    match last {
        None => p.truth(true),
        Some(last) => {
            let (older, zero) = (p.seq_lt(seq, last), p.seq_zero(seq));
            let current = p.not(older);
            p.or(current, zero)
        }
    }
}

/// √(x² + y² + …), and the power of two by which it, and what it is compared with, are multiplied: where the plain sum
/// of squares is below 2⁻⁹⁰⁰ it is 2⁶⁰⁰, where it is not below 2¹⁰⁰⁰ it is 2⁻⁶⁰⁰, and else 1.
pub(super) fn norm<P: Prover>(p: &mut P, vector: &[P::S]) -> (P::S, P::S) {
    let square_sum = |p: &mut P, scale: Option<P::S>| {
        let mut sum = p.number(0.0);
        for x in vector {
            let x = scale.map_or(*x, |scale| x.mul(scale));
            sum = sum.add(x.mul(x));
        }
        sum
    };
    let [small, large, up, down, one] = [-900, 1000, 600, -600, 0].map(|exponent| p.number(2.0_f64.powi(exponent)));
    let sum = square_sum(p, None);
    let (is_small, is_usual) = (p.lt(sum, small), p.lt(sum, large));
    let scale = p.select(is_usual, one, down);
    let scale = p.select(is_small, up, scale);
    (square_sum(p, Some(scale)).sqrt(), scale)
}

/// √(x² + y² + …) is not above a bound.
pub(super) fn is_within<P: Prover>(p: &mut P, vector: &[P::S], bound: P::S) -> P::B {
    let (length, scale) = norm(p, vector);
    p.le(length, bound.mul(scale))
}

/// Section 7.5: the closed ball.
pub(super) fn inside<P: Prover>(p: &mut P, position: &[P::S; 3], radius: P::S) -> P::B {
    let near = is_within(p, position, radius);
    let [x, y, z] = position.map(|x| p.finite(x));
    let good = positive(p, radius);
    p.all(&[x, y, z, good, near])
}

/// All components are finite.
pub(super) fn all_finite<P: Prover>(p: &mut P, vector: &[P::S]) -> P::B {
    let parts: Vec<_> = vector.iter().map(|x| p.finite(*x)).collect();
    p.all(&parts)
}

/// The whole state of a watchdog is this one, bit by bit; and so is what its accessors say.
pub(super) fn same_watchdog<P: Prover>(
    p: &mut P,
    state: WatchdogState<P::S, P::Q>,
    says: WatchdogState<P::S, P::Q>,
) -> P::B {
    let WatchdogState { last_seq, deadline } = state;
    let same_seq = match (last_seq, says.last_seq) {
        (Some(is), Some(says)) => p.seq_same(is, says),
        (is, says) => p.truth(is.is_none() && says.is_none()),
    };
    let same_deadline = match (deadline, says.deadline) {
        (Some(is), Some(says)) => {
            let (received, ttl) = (p.same(is.0, says.0), p.same(is.1, says.1));
            p.and(received, ttl)
        }
        (is, says) => p.truth(is.is_none() && says.is_none()),
    };
    p.and(same_seq, same_deadline)
}

/// Two limits are the same, bit by bit.
pub(super) fn same_limit<P: Prover>(p: &mut P, is: Limit<P::S>, says: Limit<P::S>) -> P::B {
    match (is, says) {
        (Limit::Enabled(is), Limit::Enabled(says)) => p.same(is, says),
        (Limit::Disabled, Limit::Disabled) | (Limit::Faulty, Limit::Faulty) => p.truth(true),
        _ => p.truth(false),
    }
}

/// The whole state of the gates is this one, bit by bit: what is not meant to change has not.
pub(super) fn same_gates<P: Prover>(p: &mut P, state: GatesState<P::S>, says: GatesState<P::S>) {
    let GatesState { max_speed_mps, fence_m, timeout_ms, config_fault, estop } = state;
    let same = same_limit(p, max_speed_mps, says.max_speed_mps);
    p.check("the speed limit is the model's", same);
    let same = same_limit(p, fence_m, says.fence_m);
    p.check("the fence is the model's", same);
    let same = p.same(timeout_ms, says.timeout_ms);
    p.check("the timeout is the model's", same);
    let same = p.truth(config_fault == says.config_fault);
    p.check("the config fault is the model's", same);
    let same = p.truth(estop == says.estop);
    p.check("the latch is the model's", same);
}

/// Where a plant is that follows a command from a position inside the fence.
pub(super) struct End<B> {
    /// Whether tick 0 alone, followed for the whole ttl, ends inside.
    pub(super) whole: B,
    /// Whether each tick ends inside, each projected from the end of the one before.
    pub(super) ticks: Vec<B>,
}

/// Section 7.5: whether the ticks of these velocities end inside; one without a velocity does not.
pub(super) fn ends<P: Prover>(
    p: &mut P,
    position: &[P::S; 3],
    radius: P::S,
    ttl: P::S,
    dt: Option<P::S>,
    velocities: &[Option<[P::S; 3]>],
) -> End<P::B> {
    let whole_ms = whole(p, ttl);
    let first = velocities.first().copied().flatten();
    let (_, whole) = end(p, *position, first, whole_ms, radius);
    let dt = dt.unwrap_or_else(|| p.number(f64::NAN));
    let mut place = *position;
    let mut ticks = Vec::new();
    for (tick, velocity) in velocities.iter().enumerate() {
        let time = share(p, tick, dt, whole_ms);
        let (next, is_inside) = end(p, place, *velocity, time, radius);
        place = next;
        ticks.push(is_inside);
    }
    End { whole, ticks }
}

/// *T* of section 7.5: the enforced ttl, and 0 for what is no time. In ms.
pub(super) fn whole<P: Prover>(p: &mut P, ttl: P::S) -> P::S {
    let (is_time, enforced, zero) = (positive(p, ttl), enforced(p, ttl), p.number(0.0));
    p.select(is_time, enforced, zero)
}

/// The part of [k·dt, (k + 1)·dt) that lies before the end, in ms. `[NCP-SAFE-050]`
pub(super) fn share<P: Prover>(p: &mut P, tick: usize, dt: P::S, whole: P::S) -> P::S {
    #[expect(clippy::cast_precision_loss)]
    let start = p.number(tick as f64).mul(dt);
    let rest = whole.sub(start);
    let (shorter, begins, zero) = (p.lt(dt, rest), p.lt(start, whole), p.number(0.0));
    let part = p.select(shorter, dt, rest);
    p.select(begins, part, zero)
}

/// Where this velocity leads in so many ms, and whether that is inside; without one, nowhere.
pub(super) fn end<P: Prover>(
    p: &mut P,
    from: [P::S; 3],
    velocity: Option<[P::S; 3]>,
    time_ms: P::S,
    radius: P::S,
) -> ([P::S; 3], P::B) {
    let Some([u, v, w]) = velocity else {
        return (from, p.truth(false));
    };
    let seconds = time_ms.div(p.number(1000.0));
    let [x, y, z] = from;
    let end = [x.add(u.mul(seconds)), y.add(v.mul(seconds)), z.add(w.mul(seconds))];
    let is_inside = inside(p, &end, radius);
    (end, is_inside)
}
