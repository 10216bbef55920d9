//! What happens when frames stay away: chapter 8.

mod action_buffer;
mod link_monitor;
mod watchdog;

pub use action_buffer::{ActionBuffer, is_estop};
pub use link_monitor::{DEFAULT_REF_LOSS, DEFAULT_THRESHOLD, LinkMonitor, LinkReport};
pub use watchdog::CommandWatchdog;

pub use ncp_kernel::Received;

use crate::wire::MAX_ITEMS;
use ncp_kernel as kernel;

/// How many ticks of `dt_ms` a ttl of `ttl_ms` has room for, and a frame for their setpoints; 0 when
/// either is not finite or not positive. `[NCP-RES-033] [NCP-RES-034]`
#[must_use]
pub fn max_horizon_len(ttl_ms: f64, dt_ms: f64) -> usize {
    if !kernel::is_duration(ttl_ms) || !kernel::is_duration(dt_ms) {
        return 0;
    }
    // A conversion from a float saturates.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    let ticks = (ttl_ms / dt_ms).floor() as usize;
    ticks.min(MAX_ITEMS)
}
