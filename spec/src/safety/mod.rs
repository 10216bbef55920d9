//! The commander's gate: chapter 7.
//!
//! [`SafetyGovernor`] decides what leaves the control loop. Its decisions stand in [`kernel`], where the
//! plant's side (chapter 8) finds its own too.

mod governor;
pub use ncp_kernel as kernel;

pub use governor::SafetyGovernor;
pub use ncp_kernel::{Decision, Reason};

/// The sensor channel on which the geofence acts: 3 wide, in [`METRES`]. `[NCP-SAFE-010]`
pub const POSITION_CHANNEL: &str = "pose_position";
/// The command channel on which the speed limit acts: 3 wide, in [`METRES_PER_SECOND`].
/// `[NCP-SAFE-011]`
pub const VELOCITY_CHANNEL: &str = "velocity_setpoint";
/// The unit of a position.
pub const METRES: &str = "m";
/// The unit of a velocity.
pub const METRES_PER_SECOND: &str = "m/s";
