//! The speed limit: the bound, the direction, and the ticks to which it is applied.

use ncp_kernel::{Channel, Limit, Reason, Scalar};

pub use super::loops::{channel, channels};
use super::words::{all_finite, is_within, norm, positive};
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
        let within = is_within(p, c.after.get(..c.width).unwrap_or_default(), c.max);
        p.check("the norm is not above the bound", within);
    }
}

/// Unchanged exactly when the norm is not above the bound.
pub fn unchanged<K: Kernel, P: Prover>(p: &mut P) {
    let c = clamped::<K, P>(p);
    let Some(changed) = c.answer else { return };
    let within = is_within(p, c.before.get(..c.width).unwrap_or_default(), c.max);
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

/// Every component is the old one times one factor, common to all, each product rounded once; where the factor is
/// below 2⁻⁹⁰⁰, first divided by the norm and then times the bound. The zero vector stands only where that rounds above
/// the bound.
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

    let (length, scale) = norm(p, before);
    let factor = aim.mul(scale).div(length);
    let least = p.number(2.0_f64.powi(-900));
    let is_harmless = p.le(least, factor);
    let by_norm = |x: P::S| x.mul(scale).div(length).mul(aim);
    let scaled: Vec<P::S> = before.iter().map(|x| p.select(is_harmless, x.mul(factor), by_norm(*x))).collect();
    let fits = is_within(p, &scaled, c.max);
    let zero = p.number(0.0);
    for (scaled, after) in scaled.iter().zip(after) {
        let says = p.select(fits, *scaled, zero);
        let same = p.same(says, *after);
        p.check("every component by one factor", same);
    }
}

/// Vectors whose norm is exact.
const EXACT: [([f64; 3], f64); 4] =
    [([3.0, -4.0, 0.0], 5.0), ([-2.0, 3.0, 6.0], 7.0), ([1.0, -4.0, 8.0], 9.0), ([0.0, 0.0, -1.0], 1.0)];
/// Powers of two over the whole range of doubles: squares vanish below −537 and overflow above 512.
const SIZES: [i32; 14] = [-1074, -1022, -600, -538, -452, -449, -300, 0, 300, 498, 501, 513, 600, 1020];

/// A vector of any size and a bound, with what exact numbers say of them: the norm of the vector is a power of two
/// times that of its direction, and the bound another, or the next double below.
pub(super) struct Sized {
    /// The vector's direction, of norm 1.
    pub direction: [f64; 3],
    pub vector: [f64; 3],
    pub bound: f64,
    pub is_within: bool,
}

pub(super) fn sized<P: Prover>(p: &mut P) -> Sized {
    let (direction, norm) = EXACT.get(p.choice("direction", EXACT.len())).copied().unwrap_or(([1.0, 0.0, 0.0], 1.0));
    let [size, at] = ["size", "bound"].map(|name| SIZES.get(p.choice(name, SIZES.len())).copied().unwrap_or_default());
    let is_next = p.boolean("is_next_below");
    // In two steps, since not every power is a double.
    let power = |x: f64, exponent: i32| x * 2.0_f64.powi(exponent / 2) * 2.0_f64.powi(exponent - exponent / 2);
    let bound = power(norm, at);
    Sized {
        direction: direction.map(|x| x / norm),
        vector: direction.map(|x| power(x, size)),
        bound: if is_next { bound.next_down() } else { bound },
        is_within: size < at || (size == at && !is_next),
    }
}

/// Of every size: left alone exactly within the bound, and else scaled to it, in the same direction.
pub fn range<K: Kernel, P: Prover>(p: &mut P) {
    let Sized { direction, vector, bound, is_within } = sized(p);
    let (mut after, max) = (vector.map(|x| p.number(x)), p.number(bound));
    let answer = K::bring_within(&mut after, max);
    // Below the least double there is no bound.
    let right = p.truth(answer == (bound > 0.0).then_some(!is_within));
    p.check("left alone exactly within the bound", right);
    // Below the normal range, a component has too few digits for a direction.
    if is_within || bound < 2.0_f64.powi(-1000) {
        return;
    }
    for (after, part) in after.iter().zip(direction) {
        let [one, other] = [-1.0, 1.0].map(|sign| part * bound * (1.0 + sign * 2.0_f64.powi(-40)));
        let (least, most) = (p.number(one.min(other)), p.number(one.max(other)));
        let (above, below) = (p.le(least, *after), p.le(*after, most));
        let right = p.and(above, below);
        p.check("scaled to the bound, in the same direction", right);
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
                let within = is_within(p, after, max);
                p.check("every channel in m/s is within the limit", within);
                let was_within = is_within(p, before, max);
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
