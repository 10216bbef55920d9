//! The decisions that can hurt someone, and nothing else.
//!
//! | module | what it holds |
//! |---|---|
//! | [`vocabulary`] | the words in which the kernel is asked and answers; no decision is taken there |
//! | [`scalar`] | what the kernel needs of a number and of a seq |
//! | [`decisions`] | who moves the plant, how fast, how far and for how long |
//!
//! Each function allocates nothing, and loops only over the slice or the ticks that it is given. All are
//! generic over [`Scalar`] and [`Seq`], whose one production instance is `f64` and `i64`; a proof engine
//! brings others and runs this very code. Comparisons have the one shape that the text gives them:
//! √(x² + y² + z²) ≤ r is computed and compared just so, at a scale at which no square leaves the
//! doubles. Whatever is not a number fails the comparison that would let the plant move.
//!
//! The crate depends on nothing, and on the standard library only for the square root of a double (feature `std`).

#![no_std]
#![forbid(unsafe_code)]

// The decisions name the vocabulary by this crate's name, so that a copy of them elsewhere, with a planted defect,
// speaks the same words.
extern crate self as ncp_kernel;
#[cfg(feature = "std")]
extern crate std;

pub mod decisions;
pub mod scalar;
pub mod vocabulary;

pub use decisions::{
    Gates, Limited, MAX_TTL_MS, Norm, Plant, Watchdog, advances, age_ms, all_finite, bring_within, clamp, end_inside,
    enforced_ttl_ms, follow, hold_takes_effect, inside, is_duration, is_fresh, limit, limit_channel, limit_tick, norm,
    step_end, steps_inside, tick_share_ms, travel, within_deadline,
};
pub use scalar::{Scalar, Seq};
pub use vocabulary::{Channel, Decision, Limit, Mode, Plan, Reason, Received};
