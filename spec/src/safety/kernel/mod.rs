//! The decisions that can hurt someone, and nothing else.
//!
//! | module | what it decides | used by |
//! |---|---|---|
//! | `gates` | which command passes the commander, and what of it | [`SafetyGovernor`](super::SafetyGovernor) |
//! | `fence`, `speed` | where a command leads, and how fast | `gates` |
//! | `plant`, `watchdog` | what the plant may do now | [`ActionBuffer`](crate::resilience::ActionBuffer) |
//! | `deadline`, `order` | how long a command is worth anything, and which is newer | both sides |
//!
//! Each function allocates nothing, and loops only over the slice or the ticks that it is given. All are
//! generic over [`Scalar`] and [`Seq`], whose one production instance is `f64` and `i64`; a proof engine
//! brings others and runs this very code. Comparisons have the one shape that the text gives them:
//! √(x² + y² + z²) ≤ r is computed and compared just so. Whatever is not a number fails the
//! comparison that would let the plant move.

mod deadline;
mod fence;
mod gates;
mod order;
mod plant;
mod scalar;
mod speed;
mod vocabulary;
mod watchdog;

pub use deadline::{MAX_TTL_MS, age_ms, enforced_ttl_ms, is_duration, is_fresh, within_deadline};
pub use fence::{inside, steps_inside, tick_share_ms, travel};
pub use gates::Gates;
pub use order::{advances, hold_takes_effect};
pub use plant::Plant;
pub use scalar::{Scalar, Seq};
pub use speed::{all_finite, bring_within, clamp, limit, limit_tick, norm};
pub use vocabulary::{Channel, Decision, Limit, Plan, Reason, Received};
pub use watchdog::Watchdog;
