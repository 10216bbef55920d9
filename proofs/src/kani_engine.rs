//! The harnesses as proofs of Kani: `cargo kani -p ncp-proofs`, where Kani can be installed. Elsewhere a module
//! with the same functions stands in for Kani's, so that the proofs are compiled and run by the tests.

use crate::engines::native::{Draw, Native};
use crate::properties::kani_harness;

/// Any value at all.
#[derive(Debug, Default)]
pub(crate) struct Any;

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

macro_rules! proofs {
    ($($name:ident = $id:literal, $unwind:literal;)*) => {
        $(
            #[cfg_attr(kani, kani::proof)]
            #[cfg_attr(kani, kani::unwind($unwind))]
            fn $name() {
                kani_harness($id, &mut Native::new(Any));
            }
        )*

        #[cfg(test)]
        const PROOFS: &[(&str, u32, fn())] = &[$(($id, $unwind, $name),)*];
    };
}

proofs! {
    watchdog_deadline = "watchdog/deadline", 1;
    watchdog_ttl = "watchdog/ttl", 1;
    watchdog_order = "watchdog/order", 1;
    watchdog_step = "watchdog/step", 1;
    watchdog_sequence = "watchdog/sequence", 7;
    geofence_inside = "geofence/inside", 4;
    geofence_limit = "geofence/limit", 1;
    geofence_projection = "geofence/projection", 5;
    geofence_projection_and_clamp = "geofence/projection-and-clamp", 5;
    clamp_bound = "clamp/bound", 4;
    clamp_unchanged = "clamp/unchanged", 4;
    clamp_direction = "clamp/direction", 4;
    clamp_tick = "clamp/tick", 4;
    latch_gates = "latch/gates", 5;
    latch_plant = "latch/plant", 5;
    latch_sequence = "latch/sequence", 7;
    latch_plant_sequence = "latch/plant-sequence", 7;
    latch_horizon = "latch/horizon", 6;
    number_operations = "number/operations", 10;
}

/// The part of Kani's API that stands above, on samples.
#[cfg(not(kani))]
mod kani {
    use std::cell::{Cell, RefCell};

    use crate::engines::native::{Draw, Sample};

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
            sample.choice(24)
        }
    }

    pub(super) fn begin(seed: u64) {
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
    use crate::properties::PROPERTIES;

    #[test]
    fn every_property_is_a_proof_of_kani_that_runs() {
        let table: Vec<_> = PROPERTIES.iter().map(|p| (p.id, p.unwind)).collect();
        let proofs: Vec<_> = PROOFS
            .iter()
            .map(|(id, unwind, _)| (*id, *unwind))
            .collect();
        assert_eq!(proofs, table);
        for (_, _, proof) in PROOFS {
            for seed in 0..1_000 {
                kani::begin(seed);
                proof();
            }
        }
    }

    #[test]
    #[should_panic(expected = "the bound")]
    fn a_check_that_fails_is_noticed() {
        kani::begin(0);
        Any.check("the bound", false);
    }
}
