//! A property's harness on a kernel, ready for each engine.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};

use crate::counterexample::{Counterexample, Drawn, ENDS};
use crate::kernel::Kernel;
use crate::properties::{clamp, geofence, latch, number, watchdog};
use crate::provers::native::{Draw, Native, Replay, Source};
use crate::provers::terms::Symbolic;
use crate::vector::Calls;

/// A harness on a kernel, for each kind of prover.
macro_rules! of {
    ($kernel:ty, $($harness:ident)::+) => {
        $crate::harness::Harness {
            symbolic: $($harness)::+::<$kernel, $crate::provers::terms::Symbolic>,
            native: $($harness)::+::<$kernel, $crate::provers::native::Native<$crate::provers::native::Source>>,
            calls: $crate::vector::Calls::of::<$kernel>(),
        }
    };
}
#[cfg(feature = "broken")]
pub(crate) use of;

/// The harnesses of a kernel, by the ids of their properties.
macro_rules! harnesses {
    ($($id:literal => $($harness:ident)::+,)*) => {
        /// The harness of a property on a kernel.
        #[must_use]
        pub fn harness<K: Kernel>(id: &str) -> Option<Harness> {
            match id {
                $($id => Some(of!(K, $($harness)::+)),)*
                _ => None,
            }
        }

        /// The harness of a property on a kernel that is only run on doubles.
        #[cfg(feature = "mutants")]
        #[must_use]
        pub fn native_harness<K: Kernel>(id: &str) -> Option<Harness> {
            match id {
                $($id => Some(Harness {
                    symbolic: |_| {},
                    native: $($harness)::+::<K, Native<Source>>,
                    calls: Calls::of::<K>(),
                }),)*
                _ => None,
            }
        }

        #[cfg(any(kani, test))]
        pub(crate) fn kani_harness(id: &str, p: &mut Native<crate::kani_engine::Any>) {
            match id {
                $($id => $($harness)::+::<crate::kernel::Production, Native<crate::kani_engine::Any>>(p),)*
                _ => {}
            }
        }
    };
}

/// One harness, ready for each engine.
#[derive(Debug, Clone, Copy)]
pub struct Harness {
    /// On terms.
    pub symbolic: fn(&mut Symbolic),
    /// On doubles: sampled, every combination of some, or given ones.
    pub native: fn(&mut Native<Source>),
    /// The kernel behind the calls of the peer protocol.
    pub calls: Calls,
}

harnesses! {
    "watchdog/deadline" => watchdog::deadline,
    "watchdog/ttl" => watchdog::ttl,
    "watchdog/order" => watchdog::order,
    "watchdog/step" => watchdog::step,
    "watchdog/sequence" => watchdog::sequence,
    "geofence/inside" => geofence::inside,
    "geofence/range" => geofence::range,
    "geofence/limit" => geofence::limit,
    "geofence/projection" => geofence::projection,
    "geofence/projection-and-clamp" => geofence::projection_and_clamp,
    "geofence/step" => geofence::step,
    "geofence/follow" => geofence::follow,
    "geofence/long" => geofence::long,
    "clamp/bound" => clamp::bound,
    "clamp/unchanged" => clamp::unchanged,
    "clamp/direction" => clamp::direction,
    "clamp/range" => clamp::range,
    "clamp/tick" => clamp::tick,
    "clamp/channel" => clamp::channel,
    "clamp/channels" => clamp::channels,
    "latch/new" => latch::new,
    "latch/event" => latch::event,
    "latch/govern" => latch::govern,
    "latch/gates" => latch::gates,
    "latch/plant" => latch::plant,
    "latch/sequence" => latch::sequence,
    "latch/plant-sequence" => latch::plant_sequence,
    "latch/horizon" => latch::horizon,
    "latch/closed" => latch::closed,
    "latch/replay" => latch::replay,
    "number/operations" => number::operations,
}

/// The check that fails where the kernel panics.
const NO_PANIC: &str = "the kernel does not panic";

/// Runs a harness once on doubles. A panic is a failure.
pub(crate) fn run_once<D: Draw>(harness: fn(&mut Native<D>), native: &mut Native<D>) {
    if catch_unwind(AssertUnwindSafe(|| harness(native))).is_err() {
        native.failed.get_or_insert(NO_PANIC);
    }
}

/// What a panic says.
pub(crate) fn said(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    let text = text.or_else(|| panic.downcast_ref::<&str>().copied());
    format!("the kernel panics: {}", text.unwrap_or_default())
}

/// What the kernel answers to a counterexample and what the text says, where the check compares the two.
#[must_use]
pub fn compared(harness: &Harness, found: &Counterexample, length: usize) -> Option<String> {
    if found.check == ENDS {
        return Some("the text has an answer, the kernel never gives one".to_owned());
    }
    let mut replay = Replay { length, ..Replay::default() };
    for (_, drawn) in &found.inputs {
        match *drawn {
            Drawn::Scalar(value) => replay.scalars.push_back(value),
            Drawn::Seq(value) => replay.seqs.push_back(value),
            Drawn::Choice(value) => replay.choices.push_back(value),
        }
    }
    let mut native = Native::new(Source::Replay(replay));
    run_once(harness.native, &mut native);
    native.compared.filter(|compared| !compared.is_empty())
}
