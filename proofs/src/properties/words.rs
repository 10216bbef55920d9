//! What the text says, as formulas: written from its sentences, not from the kernel's code.

use ncp_kernel::Scalar;

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

/// √(x² + y² + …)
pub(super) fn norm<P: Prover>(p: &mut P, vector: &[P::S]) -> P::S {
    let mut sum = p.number(0.0);
    for x in vector {
        sum = sum.add(x.mul(*x));
    }
    sum.sqrt()
}

/// Section 7.5: the closed ball.
pub(super) fn inside<P: Prover>(p: &mut P, position: &[P::S; 3], radius: P::S) -> P::B {
    let distance = norm(p, position);
    let near = p.le(distance, radius);
    let [x, y, z] = position.map(|x| p.finite(x));
    let good = positive(p, radius);
    p.all(&[x, y, z, good, near])
}

/// All components are finite.
pub(super) fn all_finite<P: Prover>(p: &mut P, vector: &[P::S]) -> P::B {
    let parts: Vec<_> = vector.iter().map(|x| p.finite(*x)).collect();
    p.all(&parts)
}

/// What a watchdog knows: its last seq, and when it received and for how long.
type State<S, Q> = (Option<Q>, Option<(S, S)>);

/// A watchdog's last seq, when it received and for how long: those of the model.
pub(super) fn same_state<P: Prover>(
    p: &mut P,
    state: State<P::S, P::Q>,
    last: Option<P::Q>,
    deadline: Option<(P::S, P::S)>,
) {
    let same_seq = match (state.0, last) {
        (Some(is), Some(says)) => p.seq_same(is, says),
        (is, says) => p.truth(is.is_none() && says.is_none()),
    };
    let same_deadline = match (state.1, deadline) {
        (Some(is), Some(says)) => {
            let (received, ttl) = (p.same(is.0, says.0), p.same(is.1, says.1));
            p.and(received, ttl)
        }
        (is, says) => p.truth(is.is_none() && says.is_none()),
    };
    let same = p.and(same_seq, same_deadline);
    p.check("the state is the model's", same);
}
