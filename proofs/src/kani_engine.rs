//! The harnesses as proofs of Kani: `cargo kani -p ncp-proofs`, where Kani can be installed.

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
        let way = kani::any();
        kani::assume(way < count);
        way
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
            #[kani::proof]
            #[kani::unwind($unwind)]
            fn $name() {
                kani_harness($id, &mut Native::new(Any));
            }
        )*
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
}
