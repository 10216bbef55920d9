//! The command watchdog as a plant uses it.

use ncp_kernel::Watchdog;

/// Holds a plant whose commands stay away. All times are seconds on the plant's own clock.
///
/// What it decides stands in the [kernel](ncp_kernel).
pub type CommandWatchdog = Watchdog<f64, i64>;
