//! The speed limit: the bound, the direction, and the ticks to which it is applied.

use ncp_kernel::{Channel, Limit, Reason, Scalar};

pub use super::loops::{channel, channels};
use super::words::{all_finite, norm, positive};
use crate::kernel::Kernel;
use crate::prover::Prover;

/// A vector of 1 to 3 components, and what the kernel made of it.
struct Clamped<P: Prover> {
    before: [P::S; 3],
    after: [P::S; 3],
    width: usize,
    max: P::S,
    answer: Option<bool>,
}

fn clamped<K: Kernel, P: Prover>(p: &mut P) -> Clamped<P> {
    let width = p.choice("width", 3) + 1;
    let mut before = [p.number(0.0); 3];
    for (axis, x) in before.iter_mut().enumerate().take(width) {
        *x = p.scalar(&format!("v_{axis}"));
    }
    let max = p.scalar("max");
    let mut after = before;
    let answer = K::bring_within(after.get_mut(..width).unwrap_or_default(), max);
    Clamped { before, after, width, max, answer }
}

/// What comes back is not above the bound, for every double; and nothing comes back exactly for what
/// is not finite and for a bound that is none.
pub fn bound<K: Kernel, P: Prover>(p: &mut P) {
    let c = clamped::<K, P>(p);
    let finite = all_finite(p, c.before.get(..c.width).unwrap_or_default());
    let good = positive(p, c.max);
    let usable = p.and(finite, good);
    p.exactly("usable exactly when finite", c.answer.is_some(), usable);
    let mut again = c.before;
    let is_usable = K::clamp(again.get_mut(..c.width).unwrap_or_default(), c.max);
    let alike: Vec<_> = again.iter().zip(&c.after).map(|(a, b)| p.same(*a, *b)).collect();
    let alike = p.all(&alike);
    let same = p.truth(is_usable == c.answer.is_some());
    let alike = p.and(same, alike);
    p.check("clamp says and does the same", alike);
    if c.answer.is_some() {
        let after = norm(p, c.after.get(..c.width).unwrap_or_default());
        let within = p.le(after, c.max);
        p.check("the norm is not above the bound", within);
    }
}

/// Unchanged exactly when the norm is not above the bound.
pub fn unchanged<K: Kernel, P: Prover>(p: &mut P) {
    let c = clamped::<K, P>(p);
    let Some(changed) = c.answer else { return };
    let before = norm(p, c.before.get(..c.width).unwrap_or_default());
    let within = p.le(before, c.max);
    p.exactly("left alone exactly within the bound", !changed, within);
    if !changed {
        let same: Vec<_> = (0..3).map(|axis| same_at(p, &c, axis)).collect();
        let same = p.all(&same);
        p.check("what is left alone is the same", same);
    }
}

fn same_at<P: Prover>(p: &mut P, c: &Clamped<P>, axis: usize) -> P::B {
    match (c.before.get(axis), c.after.get(axis)) {
        (Some(before), Some(after)) => p.same(*before, *after),
        _ => p.truth(false),
    }
}

/// Every component is the old one times one factor, common to all, each product rounded once; where the
/// norm overflows, first divided by the largest, each quotient rounded once. The zero vector stands only
/// where that rounds above the bound.
pub fn direction<K: Kernel, P: Prover>(p: &mut P) {
    let c = clamped::<K, P>(p);
    if c.answer != Some(true) {
        return;
    }
    let before = c.before.get(..c.width).unwrap_or_default();
    let after = c.after.get(..c.width).unwrap_or_default();
    // A little below the bound: n + 8 units of 2⁻⁵³.
    #[expect(clippy::cast_precision_loss)]
    let margin = p.number(1.0 - (c.width as f64 + 8.0) * 2.0_f64.powi(-53));
    let aim = c.max.mul(margin);

    let length = norm(p, before);
    let overflows = {
        let finite = p.finite(length);
        p.not(finite)
    };
    let mut largest = p.number(0.0);
    for x in before {
        let larger = p.lt(largest, x.abs());
        largest = p.select(larger, x.abs(), largest);
    }
    let base: Vec<P::S> = before.iter().map(|x| p.select(overflows, x.div(largest), *x)).collect();
    let factor = aim.div(norm(p, &base));
    let scaled: Vec<P::S> = base.iter().map(|x| x.mul(factor)).collect();
    let length = norm(p, &scaled);
    let fits = p.le(length, c.max);
    let zero = p.number(0.0);
    for (scaled, after) in scaled.iter().zip(after) {
        let says = p.select(fits, *scaled, zero);
        let same = p.same(says, *after);
        p.check("every component by one factor", same);
    }
}

/// A tick: it passes exactly when all its channels are finite and, with the limit enabled, its velocity is
/// 3 wide and in m/s; then every channel in m/s is within the limit, and every other one as it was.
pub fn tick<K: Kernel, P: Prover>(p: &mut P) {
    let kind = p.choice("limit", 3);
    let (is_enabled, is_faulty) = (kind == 1, kind == 2);
    let max = p.scalar("max");
    let limit = match kind {
        0 => Limit::Disabled,
        1 => Limit::Enabled(max),
        _ => Limit::Faulty,
    };
    let width = p.choice("width", 3) + 2;
    let flags = [p.boolean("is_named"), p.boolean("velocity_in_mps")];
    let (other_in_mps, is_first) = (p.boolean("other_in_mps"), p.boolean("is_first"));
    let mut velocity = [p.number(0.0); 4];
    for (axis, x) in velocity.iter_mut().enumerate().take(width) {
        *x = p.scalar(&format!("v_{axis}"));
    }
    let mut other = [p.scalar("w")];
    let (velocity_before, other_before) = (velocity, other);
    let answer = {
        let velocity =
            Channel { data: velocity.get_mut(..width).unwrap_or_default(), is_velocity: flags[0], in_mps: flags[1] };
        let other = Channel { data: other.as_mut_slice(), is_velocity: false, in_mps: other_in_mps };
        let channels = if is_first { [velocity, other] } else { [other, velocity] };
        K::limit_tick(channels.into_iter(), limit)
    };
    let before = velocity_before.get(..width).unwrap_or_default();
    let finite = {
        let (a, b) = (all_finite(p, before), all_finite(p, &other_before));
        p.and(a, b)
    };
    let acts = p.truth(!is_faulty && (!is_enabled || (width == 3 && flags[0] && flags[1])));
    let good = if is_enabled && (flags[1] || other_in_mps) { positive(p, max) } else { p.truth(true) };
    let says = p.all(&[finite, acts, good]);
    p.exactly("usable exactly when it can be limited", answer.is_ok(), says);
    if let Ok(changed) = answer {
        let mut above = p.truth(false);
        for (before, after, in_mps) in
            [(before, velocity.get(..width).unwrap_or_default(), flags[1]), (&other_before, &other, other_in_mps)]
        {
            if is_enabled && in_mps {
                let length = norm(p, after);
                let within = p.le(length, max);
                p.check("every channel in m/s is within the limit", within);
                let length = norm(p, before);
                let was_within = p.le(length, max);
                let was_above = p.not(was_within);
                above = p.or(above, was_above);
                let same: Vec<_> = before.iter().zip(after).map(|(before, after)| p.same(*before, *after)).collect();
                let same = p.all(&same);
                let right = p.or(was_above, same);
                p.check("a channel that is not above it is as it was", right);
            } else {
                for (before, after) in before.iter().zip(after) {
                    let same = p.same(*before, *after);
                    p.check("every other channel is as it was", same);
                }
            }
        }
        p.exactly("says whether it changed something", changed, above);
    }
    // Where the limit is a bound, as it is when it was read.
    let infinite = p.not(finite);
    let said = p.truth(answer == Err(Reason::NotFinite));
    let right = p.iff(said, infinite);
    let right = p.implies(good, right);
    p.check("not finite exactly when so", right);
    let reasons = p.truth(matches!(answer, Ok(_) | Err(Reason::NotFinite | Reason::NoVelocity)));
    p.check("no other reason", reasons);
}
