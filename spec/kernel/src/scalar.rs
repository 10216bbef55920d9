//! What the kernel needs of a number and of a seq.

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
    /// `then` where `self` < `other`, else `otherwise`: a number, and no decision.
    fn select_lt(self, other: Self, then: Self, otherwise: Self) -> Self;
    /// `self` < `other`.
    fn lt(self, other: Self) -> bool;
    /// `self` ≤ `other`.
    fn le(self, other: Self) -> bool;
    /// Neither infinite nor NaN.
    fn is_finite(self) -> bool;
    /// ⌊`self`⌋ as an index, at most `most`; 0 for a NaN and for what is below 0.
    fn floor_index(self, most: usize) -> usize;
}

/// What the kernel needs of a seq, in a total order. Its one production instance is `i64`.
pub trait Seq: Copy {
    /// Whether it is 0, the seq of a frame that has none.
    fn is_zero(self) -> bool;
    /// `self` < `other`.
    fn lt(self, other: Self) -> bool;
}

#[cfg(feature = "std")]
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
    fn select_lt(self, other: Self, then: Self, otherwise: Self) -> Self {
        if self < other { then } else { otherwise }
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
    #[inline]
    fn floor_index(self, most: usize) -> usize {
        // A conversion from a float saturates, and makes 0 of a NaN.
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let index = self.floor() as usize;
        index.min(most)
    }
}

impl Seq for i64 {
    #[inline]
    fn is_zero(self) -> bool {
        self == 0
    }
    #[inline]
    fn lt(self, other: Self) -> bool {
        self < other
    }
}
