//! Who moves the plant, how fast, how far and for how long.
//!
//! | module | what it decides | used by |
//! |---|---|---|
//! | `gates` | which command passes the commander, and what of it | the governor |
//! | `fence`, `speed` | where a command leads, and how fast | `gates` |
//! | `plant`, `watchdog` | what the plant may do now | the action buffer |
//! | `deadline`, `order` | how long a command is worth anything, and which is newer | both sides |

mod deadline;
mod fence;
mod gates;
mod order;
mod plant;
mod speed;
mod watchdog;

pub use deadline::{MAX_TTL_MS, age_ms, enforced_ttl_ms, is_duration, is_fresh, within_deadline};
pub use fence::{end_inside, follow, inside, step_end, steps_inside, tick_share_ms, travel};
pub use gates::Gates;
pub use order::{advances, hold_takes_effect};
pub use plant::Plant;
pub use speed::{Limited, Norm, all_finite, bring_within, clamp, limit, limit_channel, limit_tick, norm};
pub use watchdog::Watchdog;
