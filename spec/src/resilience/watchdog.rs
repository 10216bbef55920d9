//! The command watchdog as a plant uses it.

use crate::safety::kernel::Watchdog;

/// Holds a plant whose commands stay away. All times are seconds on the plant's own clock.
///
/// What it decides stands in the [kernel](crate::safety::kernel).
pub type CommandWatchdog = Watchdog<f64, i64>;
