//! The commander's gates, in the order of section 7.3.

use ncp_kernel::{Decision, Limit, Mode, Plan, Reason, Scalar};

use super::{follow, inside, is_duration, is_fresh, limit, steps_inside};

/// The gates of a governor: its limits, its latch, and whether the limits can be enforced.
///
/// Its fields are the whole of its state, and public for proofs, which take and make any state. Whoever governs uses
/// the functions.
#[derive(Debug, Clone, Copy)]
pub struct Gates<S> {
    /// The speed limit, in m/s.
    pub max_speed_mps: Limit<S>,
    /// The fence's radius, in m.
    pub fence_m: Limit<S>,
    /// How old a sensor frame may be, in ms, as configured.
    pub timeout_ms: S,
    /// Whether the limits cannot be enforced.
    pub config_fault: bool,
    /// Whether ESTOP is latched.
    pub estop: bool,
}

impl<S: Scalar> Gates<S> {
    /// Open gates for limits as they are configured: a speed in m/s, a radius in m, and how old a
    /// sensor frame may be, in ms.
    #[inline]
    #[must_use]
    pub fn new(max_speed_mps: Option<S>, radius_m: Option<S>, timeout_ms: S) -> Self {
        let (max_speed_mps, fence_m) = (limit(max_speed_mps), limit(radius_m));
        let is_faulty = |limit| matches!(limit, Limit::Faulty);
        Self {
            max_speed_mps,
            fence_m,
            timeout_ms,
            // [NCP-SAFE-013]
            config_fault: is_faulty(max_speed_mps) || is_faulty(fence_m),
            estop: false,
        }
    }

    /// Shuts them for good unless each enabled limit has a channel to act on.
    /// `[NCP-SAFE-014] [NCP-SAFE-018]`
    #[inline]
    pub fn bind(&mut self, has_velocity: bool, has_position: bool) {
        let is_bound = |limit, bound| bound || matches!(limit, Limit::Disabled);
        if !is_bound(self.max_speed_mps, has_velocity) || !is_bound(self.fence_m, has_position) {
            self.config_fault = true;
        }
    }

    /// Decides on a command, and limits it in place.
    ///
    /// `now_s` is the governor's clock, and `last_s` the time on it at which the sensor frame was
    /// received whose `position` is asked for. The gates stand in the order of section 7.3.
    /// `[NCP-SAFE-020]`
    #[inline]
    pub fn govern(
        &mut self,
        plan: &mut impl Plan<S>,
        now_s: S,
        last_s: Option<S>,
        position: impl FnOnce() -> Option<[S; 3]>,
    ) -> Decision {
        let mode = plan.mode();
        // [NCP-SAFE-003] [NCP-SAFE-004]
        if mode == Mode::Estop {
            self.estop = true;
        }
        // [NCP-SAFE-005]
        if self.estop {
            return Decision::Stopped(Reason::Estop);
        }
        // [NCP-SAFE-017] [NCP-SAFE-018]
        if self.config_fault {
            return Decision::Held(Reason::ConfigFault);
        }
        // [NCP-SAFE-030]
        if !last_s.is_some_and(|last_s| is_fresh(now_s, last_s, self.timeout_ms)) {
            return Decision::Held(Reason::StaleSensor);
        }
        let place = match self.fence_m {
            Limit::Enabled(radius_m) => {
                let Some(position) = position() else {
                    return Decision::Held(Reason::NoPosition);
                };
                // [NCP-SAFE-043] [NCP-SAFE-044]
                if !inside(&position, radius_m) {
                    self.estop = true;
                    return Decision::Stopped(Reason::OutsideFence);
                }
                Some((position, radius_m))
            }
            Limit::Disabled | Limit::Faulty => None,
        };
        // [NCP-SAFE-002]
        if mode != Mode::Active {
            return Decision::Held(Reason::NotActive);
        }
        let steps = plan.steps();
        let limited = match limit_ticks(plan, self.max_speed_mps) {
            Ok(limited) => limited,
            Err(reason) => return Decision::Held(reason),
        };
        if let Some((position, radius_m)) = place {
            match steps_inside(plan, &position, radius_m) {
                Ok(kept) => plan.truncate(kept), // [NCP-SAFE-050]
                Err(reason) => return Decision::Held(reason),
            }
        }
        if limited || plan.steps() < steps { Decision::Limited } else { Decision::Passed }
    }

    /// Takes note of the link: a burst of losses latches ESTOP. `[NCP-SAFE-006] [NCP-SAFE-007]`
    #[inline]
    pub fn note_link(&mut self, burst: bool) {
        if burst {
            self.estop = true;
        }
    }

    /// Clears the latch, by a supervisor's decision; a config fault stays.
    /// `[NCP-SAFE-008] [NCP-SAFE-009]`
    #[inline]
    pub fn reset(&mut self) {
        self.estop = false;
    }

    /// Whether ESTOP is latched. `[NCP-SAFE-005]`
    #[inline]
    #[must_use]
    pub const fn is_stopped(&self) -> bool {
        self.estop
    }

    /// Whether the limits cannot be enforced. `[NCP-SAFE-017]`
    #[inline]
    #[must_use]
    pub const fn has_config_fault(&self) -> bool {
        self.config_fault
    }
}

/// Applies the speed limit to every tick, and truncates the horizon before the first step that is
/// not to be used. Whether a velocity changed.
#[inline]
fn limit_ticks<S: Scalar>(plan: &mut impl Plan<S>, max_mps: Limit<S>) -> Result<bool, Reason> {
    // [NCP-SAFE-068]
    if plan.steps() > 0 && !plan.dt_ms().is_some_and(is_duration) {
        return Err(Reason::BadHorizon);
    }
    let first = plan.limit(0, max_mps)?; // [NCP-SAFE-063] [NCP-SAFE-064]
    // [NCP-SAFE-066]
    let (kept, limited) = follow(plan.steps(), first, |tick, &limited| {
        let changed = plan.limit(tick, max_mps).ok()?;
        Some(limited || changed)
    });
    plan.truncate(kept); // [NCP-SAFE-067]
    Ok(limited)
}
