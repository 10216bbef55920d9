//! The properties: what is claimed, in words and in symbols, and the harness that says it.

pub mod clamp;
pub mod geofence;
pub mod latch;
pub mod number;
pub mod watchdog;
mod words;

use crate::engines::native::{Native, Source};
use crate::engines::symbolic::Symbolic;
use crate::kernel::Kernel;
use crate::vector::{Event, gates, plant};

/// What a property is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Family {
    /// The deadline of a command, and the order of commands.
    Watchdog,
    /// The fence and the look-ahead.
    Geofence,
    /// The speed limit.
    Clamp,
    /// ESTOP, the order of the gates, the modes.
    Latch,
    /// The numbers on which all of it runs.
    Number,
}

impl Family {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Watchdog, Self::Geofence, Self::Clamp, Self::Latch, Self::Number];

    /// Its name in reports and in the table of broken kernels.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Watchdog => "watchdog",
            Self::Geofence => "geofence",
            Self::Clamp => "clamp",
            Self::Latch => "latch",
            Self::Number => "number",
        }
    }
}

/// A property of the kernel.
#[derive(Debug, Clone, Copy)]
pub struct Property {
    /// Its name: family and subject.
    pub id: &'static str,
    /// What it is about.
    pub family: Family,
    /// The rules for which it is evidence.
    pub rules: &'static [&'static str],
    /// The claim in words.
    pub sentence: &'static str,
    /// The claim in symbols.
    pub statement: &'static str,
    /// The bounds within which it is claimed; all doubles and all seqs where nothing is said.
    pub bounds: &'static str,
    /// What is assumed.
    pub assumptions: &'static [&'static str],
    /// How often Kani unwinds a loop.
    pub unwind: u32,
    /// The longest sequence of events for the symbolic engine.
    pub symbolic_length: usize,
    /// Values that the enumeration combines; none where the harness has too many inputs for that.
    pub enumeration: Option<Values>,
}

/// The finite sets of an enumeration.
#[derive(Debug, Clone, Copy)]
pub struct Values {
    /// The doubles.
    pub scalars: &'static [f64],
    /// The seqs.
    pub seqs: &'static [i64],
    /// The longest sequence of events.
    pub length: usize,
}

const ALL: usize = 6;
const NONE: &[&str] = &[];
const TIMES: &[f64] =
    &[0.0, 0.25, 1.0, -1.0, 250.0, 60_000.0, 60_000.5, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX];

include!("table.rs");

/// A harness on a kernel, for each kind of prover.
macro_rules! of {
    ($kernel:ty, $($harness:ident)::+) => {
        $crate::properties::Harness {
            symbolic: $($harness)::+::<$kernel, $crate::engines::symbolic::Symbolic>,
            native: $($harness)::+::<$kernel, $crate::engines::native::Native<$crate::engines::native::Source>>,
            trace: $crate::vector::run::<$kernel>,
            govern: $crate::vector::gates::run::<$kernel>,
            follow: $crate::vector::plant::run::<$kernel>,
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
                    trace: crate::vector::run::<K>,
                    govern: crate::vector::gates::run::<K>,
                    follow: crate::vector::plant::run::<K>,
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
    /// What the kernel's watchdog answers to a trace.
    pub trace: fn(&[Event]) -> Vec<serde_json::Value>,
    /// What a small governor around the kernel answers to a trace.
    pub govern: fn(&gates::Trace) -> Option<Vec<serde_json::Value>>,
    /// What a small action buffer around the kernel answers to a trace.
    pub follow: fn(&[plant::Step]) -> Option<Vec<serde_json::Value>>,
}

harnesses! {
    "watchdog/deadline" => watchdog::deadline,
    "watchdog/ttl" => watchdog::ttl,
    "watchdog/order" => watchdog::order,
    "watchdog/step" => watchdog::step,
    "watchdog/sequence" => watchdog::sequence,
    "geofence/inside" => geofence::inside,
    "geofence/limit" => geofence::limit,
    "geofence/projection" => geofence::projection,
    "geofence/projection-and-clamp" => geofence::projection_and_clamp,
    "clamp/bound" => clamp::bound,
    "clamp/unchanged" => clamp::unchanged,
    "clamp/direction" => clamp::direction,
    "clamp/tick" => clamp::tick,
    "latch/gates" => latch::gates,
    "latch/plant" => latch::plant,
    "latch/sequence" => latch::sequence,
    "latch/plant-sequence" => latch::plant_sequence,
    "latch/horizon" => latch::horizon,
    "number/operations" => number::operations,
}
