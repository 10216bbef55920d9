//! The harnesses as proofs of Kani: `cargo kani -p ncp-readers`, where Kani can be installed; strings are of any
//! bytes and classes there, of up to 8 bytes. Elsewhere a module with the same functions stands in for Kani's,
//! so that the proofs are compiled and run by the tests.

use ncp_proofs::engines::native::{Draw, Native};

use crate::properties::kani_harness;

/// Any value at all; the readers take no numbers of the kernel.
#[derive(Debug, Default)]
pub(crate) struct Any;

impl Draw for Any {
    fn scalar(&mut self) -> f64 {
        0.0
    }
    fn seq(&mut self) -> i64 {
        0
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
    bulk_header = "bulk/header", 70;
    bulk_entry = "bulk/entry", 70;
    bulk_directories = "bulk/directories", 110;
    bulk_columns = "bulk/columns", 130;
    version_bytes = "version/bytes", 10;
    version_scalars = "version/scalars", 20;
    version_classes = "version/classes", 10;
    keys_bytes = "keys/bytes", 10;
    keys_scalars = "keys/scalars", 20;
    keys_segment = "keys/segment", 30;
    keys_realm = "keys/realm", 30;
    keys_builders = "keys/builders", 30;
}

/// The part of Kani's API that stands above, on samples.
#[cfg(not(kani))]
mod kani {
    use std::cell::{Cell, RefCell};

    use ncp_proofs::engines::native::{Draw, Sample};

    thread_local! {
        static SAMPLE: RefCell<Sample> = const { RefCell::new(Sample::new(0, usize::MAX)) };
        static IS_VOID: Cell<bool> = const { Cell::new(false) };
    }

    pub(super) fn begin(seed: u64) {
        SAMPLE.set(Sample::new(seed, usize::MAX));
        IS_VOID.set(false);
    }
    pub(super) fn any_where(is_wanted: impl Fn(&usize) -> bool) -> usize {
        SAMPLE.with_borrow_mut(|sample| {
            loop {
                let bits = sample.choice(21);
                let value = sample.choice(2 << bits);
                if is_wanted(&value) {
                    return value;
                }
            }
        })
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
            for seed in 0..300 {
                kani::begin(seed);
                proof();
            }
        }
    }

    #[test]
    #[should_panic(expected = "the grammar")]
    fn a_check_that_fails_is_noticed() {
        kani::begin(0);
        Any.check("the grammar", false);
    }
}
