//! The decisions that can hurt someone, and nothing else.
//!
//! Each function is pure, allocates nothing, and loops only over the slice that it is given. All are generic
//! over [`Scalar`], whose one production instance is `f64`; a proof engine brings another and runs this
//! very code. Comparisons have the one shape that the text gives them: √(x² + y² + z²) ≤ r is
//! computed and compared just so. Whatever is not a number fails the comparison that would let
//! the plant move.

/// What the kernel needs of a number. Comparisons with a NaN are false, as IEEE 754 has it.
pub trait Scalar: Copy {
    /// The number that is nearest to `value`.
    fn constant(value: f64) -> Self;
    /// `self` + `other`, rounded to nearest.
    fn add(self, other: Self) -> Self;
    /// `self` − `other`, rounded to nearest.
    fn sub(self, other: Self) -> Self;
    /// `self` · `other`, rounded to nearest.
    fn mul(self, other: Self) -> Self;
    /// `self` / `other`, rounded to nearest.
    fn div(self, other: Self) -> Self;
    /// √`self`, rounded to nearest.
    fn sqrt(self) -> Self;
    /// |`self`|.
    fn abs(self) -> Self;
    /// `self` < `other`.
    fn lt(self, other: Self) -> bool;
    /// `self` ≤ `other`.
    fn le(self, other: Self) -> bool;
    /// Neither infinite nor NaN.
    fn is_finite(self) -> bool;
}

impl Scalar for f64 {
    #[inline]
    fn constant(value: f64) -> Self {
        value
    }
    #[inline]
    fn add(self, other: Self) -> Self {
        self + other
    }
    #[inline]
    fn sub(self, other: Self) -> Self {
        self - other
    }
    #[inline]
    fn mul(self, other: Self) -> Self {
        self * other
    }
    #[inline]
    fn div(self, other: Self) -> Self {
        self / other
    }
    #[inline]
    fn sqrt(self) -> Self {
        Self::sqrt(self)
    }
    #[inline]
    fn abs(self) -> Self {
        Self::abs(self)
    }
    #[inline]
    fn lt(self, other: Self) -> bool {
        self < other
    }
    #[inline]
    fn le(self, other: Self) -> bool {
        self <= other
    }
    #[inline]
    fn is_finite(self) -> bool {
        Self::is_finite(self)
    }
}

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

/// From `then_s` to `now_s`, in ms.
#[inline]
pub fn age_ms<S: Scalar>(now_s: S, then_s: S) -> S {
    now_s.sub(then_s).mul(S::constant(1000.0))
}

/// Whether a command of `seq` advances a stream whose last accepted one had `last`.
/// `// [NCP-RES-009]`
#[inline]
pub fn advances(last: Option<i64>, seq: i64) -> bool {
    match last {
        None => true,
        Some(last) => seq > last,
    }
}

/// Whether a HOLD of `seq` takes effect on a stream whose last accepted command had `last`.
/// `// [NCP-RES-023]`
#[inline]
pub fn hold_takes_effect(last: Option<i64>, seq: i64) -> bool {
    match last {
        None => true,
        Some(last) => seq == 0 || seq >= last,
    }
}

/// What a limit says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Limit<S> {
    /// Nothing: it is absent or 0.
    Disabled,
    /// A finite bound above 0.
    Enabled(S),
    /// It cannot be enforced, and so nothing may move.
    Faulty,
}

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

/// √(Σ xᵢ²).
#[inline]
pub fn norm<S: Scalar>(vector: &[S]) -> S {
    let mut sum = S::constant(0.0);
    for x in vector {
        sum = sum.add(x.mul(*x));
    }
    sum.sqrt()
}

/// Whether all components are finite.
#[inline]
pub fn all_finite<S: Scalar>(vector: &[S]) -> bool {
    for x in vector {
        if !x.is_finite() {
            return false;
        }
    }
    true
}

/// Whether a position lies in the closed ball of `radius` about the origin. False whenever that
/// cannot be computed. `// [NCP-SAFE-043] [NCP-SAFE-044] [NCP-SAFE-045]`
#[inline]
pub fn inside<S: Scalar>(position: &[S; 3], radius: S) -> bool {
    all_finite(position)
        && radius.is_finite()
        && S::constant(0.0).lt(radius)
        && norm(position).le(radius)
}

/// Where a plant is that moves from `position` with `velocity` for `time_s` seconds.
#[inline]
pub fn travel<S: Scalar>(position: &[S; 3], velocity: &[S; 3], time_s: S) -> [S; 3] {
    let [x, y, z] = *position;
    let [u, v, w] = *velocity;
    [
        x.add(u.mul(time_s)),
        y.add(v.mul(time_s)),
        z.add(w.mul(time_s)),
    ]
}

/// The part of tick `k`, [k·dt, (k+1)·dt), that lies before the end of the ttl; both in ms. 0 when
/// there is none.
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

/// Scales a finite vector so that its norm is not above `max`, keeping its direction; leaves it
/// unchanged when it is not. False, and the vector is not to be used, when a component is not
/// finite or `max` is not a finite bound above 0.
///
/// The bound is on [`norm`] as it is computed, and holds for every double: where scaling rounds
/// above it, the vector becomes zero.
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
    let mut length = norm(vector);
    if length.le(max) {
        return Some(false); // [NCP-SAFE-062]
    }
    // [NCP-SAFE-060] [NCP-SAFE-061] Where a square overflows, by the largest component first.
    if !length.is_finite() {
        let mut largest = zero;
        for x in vector.iter() {
            if largest.lt(x.abs()) {
                largest = x.abs();
            }
        }
        for x in vector.iter_mut() {
            *x = x.div(largest);
        }
        length = norm(vector);
    }
    // A little below `max`, by more than the roundings can add: half an ulp for each component and a
    // few for the rest.
    #[expect(clippy::cast_precision_loss)]
    let margin = 1.0 - (vector.len() as f64 + 8.0) * (f64::EPSILON / 2.0);
    let scale = max.mul(S::constant(margin)).div(length);
    for x in vector.iter_mut() {
        *x = x.mul(scale);
    }
    if !norm(vector).le(max) {
        for x in vector.iter_mut() {
            *x = zero;
        }
    }
    Some(true)
}
