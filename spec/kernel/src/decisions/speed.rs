//! Limits, and the speed of a tick.

use ncp_kernel::{Channel, Limit, Reason, Scalar};

/// Reads a limit. `// [NCP-SAFE-012] [NCP-SAFE-013]`
#[inline]
pub fn limit<S: Scalar>(value: Option<S>) -> Limit<S> {
    let Some(value) = value else {
        return Limit::Disabled;
    };
    let zero = S::constant(0.0);
    if !value.is_finite() || value.lt(zero) {
        Limit::Faulty
    } else if zero.lt(value) {
        Limit::Enabled(value)
    } else {
        Limit::Disabled
    }
}

/// 2⁻⁹⁰⁰: a sum of squares below it may have lost some to an underflow, and a quotient below it some of its digits.
const SMALL: f64 = f64::from_bits((1023 - 900) << 52);
/// 2¹⁰⁰⁰: a sum of squares that is not below it may overflow.
const LARGE: f64 = f64::from_bits((1023 + 1000) << 52);
/// 2⁶⁰⁰, by which the smallest components are multiplied before they are squared.
const UP: f64 = f64::from_bits((1023 + 600) << 52);
/// 2⁻⁶⁰⁰, by which the largest are.
const DOWN: f64 = f64::from_bits((1023 - 600) << 52);

/// Σ xᵢ².
#[inline]
fn squares<S: Scalar>(components: impl Iterator<Item = S>) -> S {
    components.fold(S::constant(0.0), |sum, x| sum.add(x.mul(x)))
}

/// A norm, times a power of two with which no square that counts leaves the doubles.
#[derive(Debug, Clone, Copy)]
pub struct Norm<S> {
    /// The norm at this scale.
    pub length: S,
    /// The scale: 1 wherever the plain squares are harmless.
    pub scale: S,
}

impl<S: Scalar> Norm<S> {
    /// Whether it is not above a finite bound. The bound is brought to the scale, where it loses digits only far below
    /// the norm, and overflows only far above it. `[NCP-SAFE-043] [NCP-SAFE-060]`
    #[inline]
    pub fn le(self, bound: S) -> bool {
        self.length.le(bound.mul(self.scale))
    }
}

/// √(Σ xᵢ²). `[NCP-SAFE-043] [NCP-SAFE-060]`
#[inline]
pub fn norm<S: Scalar>(vector: &[S]) -> Norm<S> {
    let sum = squares(vector.iter().copied());
    // Down also for a sum that is no number.
    let large = sum.select_lt(S::constant(LARGE), S::constant(1.0), S::constant(DOWN));
    let scale = sum.select_lt(S::constant(SMALL), S::constant(UP), large);
    Norm { length: squares(vector.iter().map(|x| x.mul(scale))).sqrt(), scale }
}

/// Whether all components are finite. `[NCP-SAFE-044] [NCP-SAFE-064]`
#[inline]
pub fn all_finite<S: Scalar>(vector: &[S]) -> bool {
    for x in vector {
        if !x.is_finite() {
            return false;
        }
    }
    true
}

/// Scales a finite vector so that its norm is not above `max`, keeping its direction; leaves it
/// unchanged when it is not. False, and the vector is not to be used, when a component is not
/// finite or `max` is not a finite bound above 0.
///
/// The bound is on [`norm`] as it is computed, and holds for every double: where scaling rounds
/// above it, as it may for a subnormal bound, the vector becomes zero.
/// `[NCP-SAFE-060] [NCP-SAFE-061] [NCP-SAFE-062] [NCP-SAFE-069]`
#[inline]
pub fn clamp<S: Scalar>(vector: &mut [S], max: S) -> bool {
    bring_within(vector, max).is_some()
}

/// [`clamp`], which also says whether the vector was above the bound; none for what is not to be used.
#[inline]
pub fn bring_within<S: Scalar>(vector: &mut [S], max: S) -> Option<bool> {
    let zero = S::constant(0.0);
    if !all_finite(vector) || !max.is_finite() || !zero.lt(max) {
        return None;
    }
    let length = norm(vector);
    if length.le(max) {
        return Some(false); // [NCP-SAFE-062]
    }
    // A little below `max`, by more than the roundings can add: half an ulp for each component and a
    // few for the rest.
    #[expect(clippy::cast_precision_loss)]
    let margin = 1.0 - (vector.len() as f64 + 8.0) * (f64::EPSILON / 2.0);
    let aim = max.mul(S::constant(margin));
    let scale = aim.mul(length.scale).div(length.length);
    // [NCP-SAFE-060] [NCP-SAFE-061] Where the quotient vanishes or loses digits, by the norm first.
    let is_harmless = S::constant(SMALL).le(scale);
    for x in vector.iter_mut() {
        *x = if is_harmless { x.mul(scale) } else { x.mul(length.scale).div(length.length).mul(aim) };
    }
    if !norm(vector).le(max) {
        for x in vector.iter_mut() {
            *x = zero;
        }
    }
    Some(true)
}

/// What the channels of a tick have shown so far.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Limited {
    /// Whether one was changed.
    pub changed: bool,
    /// Whether there is a velocity that the limit acts on.
    pub has_velocity: bool,
}

/// Applies the speed limit to the channels of a tick. Whether anything changed.
///
/// # Errors
/// The tick is not to be used: a component is not finite, or the limit is enabled and there is no
/// velocity that it can act on.
#[inline]
pub fn limit_tick<'a, S: Scalar + 'a>(
    mut channels: impl Iterator<Item = Channel<'a, S>>,
    max_mps: Limit<S>,
) -> Result<bool, Reason> {
    let none = Limited { changed: false, has_velocity: false };
    let all = channels.try_fold(none, |so_far, mut channel| limit_channel(so_far, &mut channel, max_mps))?;
    // [NCP-SAFE-063]
    if !all.has_velocity && !matches!(max_mps, Limit::Disabled) {
        return Err(Reason::NoVelocity);
    }
    Ok(all.changed)
}

/// Applies the speed limit to one channel more.
///
/// # Errors
/// Those of [`limit_tick`] that this channel causes.
#[inline]
pub fn limit_channel<S: Scalar>(
    so_far: Limited,
    channel: &mut Channel<'_, S>,
    max_mps: Limit<S>,
) -> Result<Limited, Reason> {
    // [NCP-SAFE-064]
    if !all_finite(channel.data) {
        return Err(Reason::NotFinite);
    }
    let Limit::Enabled(max_mps) = max_mps else {
        return Ok(so_far);
    };
    // [NCP-SAFE-065]
    if !channel.in_mps {
        return Ok(so_far);
    }
    let has_velocity = so_far.has_velocity || (channel.is_velocity && channel.data.len() == 3);
    let changed = bring_within(channel.data, max_mps).ok_or(Reason::NoVelocity)?;
    Ok(Limited { changed: so_far.changed || changed, has_velocity })
}
