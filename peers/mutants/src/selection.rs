//! Which mutant the process is.

use std::sync::OnceLock;

static SELECTED: OnceLock<usize> = OnceLock::new();

/// Makes the process the mutant of this number. Only the first call counts.
pub(crate) fn select(number: usize) {
    SELECTED.get_or_init(|| number);
}

/// Whether the process is the mutant of this number.
#[inline]
pub(crate) fn is(number: usize) -> bool {
    SELECTED.get() == Some(&number)
}

/// Whether the process is the mutant of this number: what the build script writes into the sources.
macro_rules! mutant {
    ($number:literal) => {
        crate::selection::is($number)
    };
}
