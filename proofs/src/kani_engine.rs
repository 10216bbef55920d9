//! Kani as a prover: `cargo kani -p ncp-proofs`, where Kani can be installed. Elsewhere a module with the same
//! functions stands in for Kani's, so that what stands here is compiled everywhere, and the proofs run by the tests.

use crate::provers::native::Draw;

/// Any value at all.
#[derive(Debug, Default)]
pub struct Any;

impl Draw for Any {
    fn scalar(&mut self) -> f64 {
        kani::any()
    }
    fn seq(&mut self) -> i64 {
        kani::any()
    }
    fn choice(&mut self, count: usize) -> usize {
        kani::any_where(|way: &usize| *way < count)
    }
    fn assume(&mut self, condition: bool) {
        kani::assume(condition);
    }
    fn check(&mut self, name: &'static str, condition: bool) {
        kani::assert(condition, name);
    }
}

/// Proofs of Kani: a function a property, by its name, its id and how often loops are unwound.
#[macro_export]
macro_rules! kani_proofs {
    ($harness:path: $($name:ident = $id:literal, $unwind:literal;)*) => {
        $(
            #[cfg_attr(kani, kani::proof)]
            #[cfg_attr(kani, kani::unwind($unwind))]
            fn $name() {
                let any = $crate::kani_engine::Any;
                $harness($id, &mut $crate::provers::native::Native::new(any));
            }
        )*

        #[cfg(test)]
        const PROOFS: &[(&str, u32, fn())] = &[$(($id, $unwind, $name),)*];
    };
}

/// Begins a run on other samples, where Kani is not there.
#[cfg(not(kani))]
pub use kani::begin;

/// The part of Kani's API that stands above, on samples.
#[cfg(not(kani))]
mod kani {
    use std::cell::{Cell, RefCell};

    use crate::provers::native::{Draw, Sample};

    thread_local! {
        static SAMPLE: RefCell<Sample> = const { RefCell::new(Sample::new(0, usize::MAX)) };
        static IS_VOID: Cell<bool> = const { Cell::new(false) };
    }

    pub(super) trait Arbitrary {
        fn any(sample: &mut Sample) -> Self;
    }
    impl Arbitrary for f64 {
        fn any(sample: &mut Sample) -> Self {
            sample.scalar()
        }
    }
    impl Arbitrary for i64 {
        fn any(sample: &mut Sample) -> Self {
            sample.seq()
        }
    }
    impl Arbitrary for usize {
        fn any(sample: &mut Sample) -> Self {
            // Small ones more often than others.
            let bits = sample.choice(21);
            sample.choice(2 << bits)
        }
    }

    /// The values of a seed from now on.
    pub fn begin(seed: u64) {
        SAMPLE.set(Sample::new(seed, usize::MAX));
        IS_VOID.set(false);
    }
    pub(super) fn any<T: Arbitrary>() -> T {
        SAMPLE.with_borrow_mut(T::any)
    }
    pub(super) fn any_where<T: Arbitrary>(is_wanted: impl Fn(&T) -> bool) -> T {
        loop {
            let value = any();
            if is_wanted(&value) {
                return value;
            }
        }
    }
    pub(super) fn assume(condition: bool) {
        IS_VOID.set(IS_VOID.get() || !condition);
    }
    pub(super) fn assert(condition: bool, name: &'static str) {
        assert!(condition || IS_VOID.get(), "{name}");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[should_panic(expected = "the bound")]
    fn a_check_that_fails_is_noticed() {
        begin(0);
        Any.check("the bound", false);
    }

    #[test]
    fn a_check_behind_a_false_assumption_is_none() {
        begin(0);
        Any.assume(false);
        Any.check("the bound", false);
    }
}
