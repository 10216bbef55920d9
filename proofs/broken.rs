/// A broken kernel: the source of the real one with one token changed.
#[derive(Debug, Clone, Copy)]
pub struct Broken {
    /// Its name, of the family that has to notice it.
    pub id: &'static str,
    /// The file of the kernel.
    pub file: &'static str,
    /// Some text of it that occurs once.
    pub from: &'static str,
    /// What stands there instead.
    pub to: &'static str,
    /// The property that has to refute it.
    pub property: &'static str,
}

#[rustfmt::skip]
const fn broken(
    id: &'static str,
    file: &'static str,
    from: &'static str,
    to: &'static str,
    property: &'static str,
) -> Broken {
    Broken { id, file, from, to, property }
}

/// All of them.
#[rustfmt::skip]
pub const BROKEN: &[Broken] = &[
    broken("watchdog_zero_ttl", "deadline.rs", "value.is_finite() && S::constant(0.0).lt(value)", "value.is_finite() && S::constant(0.0).le(value)", "watchdog/ttl"),
    broken("watchdog_infinite_ttl", "deadline.rs", "value.is_finite() && S::constant(0.0)", "value.is_finite() || S::constant(0.0)", "watchdog/ttl"),
    broken("watchdog_long_ttl", "deadline.rs", "MAX_TTL_MS: f64 = 60_000.0", "MAX_TTL_MS: f64 = 600_000.0", "watchdog/deadline"),
    broken("watchdog_most_ttl", "deadline.rs", "if ttl_ms.lt(most)", "if most.lt(ttl_ms)", "watchdog/ttl"),
    broken("watchdog_early_end", "deadline.rs", "age_ms(now_s, received_s).le(ttl_ms)", "age_ms(now_s, received_s).lt(ttl_ms)", "watchdog/deadline"),
    broken("watchdog_backward_clock", "deadline.rs", "!received_s.le(now_s)", "!now_s.le(received_s)", "watchdog/deadline"),
    broken("watchdog_first_instant", "deadline.rs", "!received_s.le(now_s)", "!received_s.lt(now_s)", "watchdog/deadline"),
    broken("watchdog_sum_of_times", "deadline.rs", "now_s.sub(then_s)", "now_s.add(then_s)", "watchdog/deadline"),
    broken("watchdog_seconds", "deadline.rs", "S::constant(1000.0)", "S::constant(100.0)", "watchdog/deadline"),
    broken("watchdog_fresh_end", "deadline.rs", "age_ms(now_s, last_s).le(timeout_ms)", "age_ms(now_s, last_s).lt(timeout_ms)", "watchdog/deadline"),
    broken("watchdog_older_seq", "order.rs", "Some(last) => last.lt(seq)", "Some(last) => seq.lt(last)", "watchdog/order"),
    broken("watchdog_duplicate_seq", "order.rs", "Some(last) => last.lt(seq)", "Some(last) => !seq.lt(last)", "watchdog/order"),
    broken("watchdog_hold_ignored", "order.rs", "seq.is_zero() || !seq.lt(last)", "seq.is_zero() && !seq.lt(last)", "watchdog/order"),
    broken("watchdog_old_hold", "order.rs", "!seq.lt(last)", "seq.lt(last)", "watchdog/order"),
    broken("watchdog_stale_refreshes", "watchdog.rs", "if !advances(self.last_seq, seq) {", "if advances(self.last_seq, seq) {", "watchdog/step"),
    broken("watchdog_unstamped_hold", "watchdog.rs", "advances(self.last_seq, seq) && !seq.is_zero()", "advances(self.last_seq, seq) || !seq.is_zero()", "watchdog/step"),
    broken("watchdog_inverted_hold", "watchdog.rs", "self.deadline.is_none()", "self.deadline.is_some()", "watchdog/step"),
    broken("watchdog_swapped_deadline", "watchdog.rs", "self.deadline = Some((now_s, ttl_ms))", "self.deadline = Some((ttl_ms, ttl_ms))", "watchdog/step"),

    broken("geofence_open_ball", "fence.rs", "norm(position).le(radius)", "norm(position).lt(radius)", "geofence/inside"),
    broken("geofence_any_radius", "fence.rs", "&& norm(position).le(radius)", "|| norm(position).le(radius)", "geofence/inside"),
    broken("geofence_zero_radius", "fence.rs", "S::constant(0.0).lt(radius)", "S::constant(0.0).le(radius)", "geofence/inside"),
    broken("geofence_outside_in", "fence.rs", "norm(position).le(radius)", "radius.le(norm(position))", "geofence/inside"),
    broken("geofence_negative_limit", "speed.rs", "!value.is_finite() || value.lt(zero)", "!value.is_finite() && value.lt(zero)", "geofence/limit"),
    broken("geofence_zero_limit", "speed.rs", "} else if zero.lt(value) {", "} else if zero.le(value) {", "geofence/limit"),
    broken("geofence_travel_back", "fence.rs", "y.add(v.mul(time_s))", "y.sub(v.mul(time_s))", "geofence/projection"),
    broken("geofence_wrong_axis", "fence.rs", "z.add(w.mul(time_s))", "z.add(v.mul(time_s))", "geofence/projection"),
    broken("geofence_long_share", "fence.rs", "if dt_ms.lt(rest) { dt_ms } else { rest }", "if rest.lt(dt_ms) { dt_ms } else { rest }", "geofence/projection"),
    broken("geofence_late_start", "fence.rs", "if !start.lt(ttl_ms)", "if !ttl_ms.lt(start)", "geofence/projection"),
    broken("geofence_step_skipped", "fence.rs", "let tick = kept + 1;", "let tick = kept + 2;", "geofence/projection"),
    broken("geofence_first_place", "fence.rs", "after(&place, &velocity, share_ms(tick))", "after(position, &velocity, share_ms(tick))", "geofence/projection"),
    broken("geofence_first_tick_only", "fence.rs", "if kept > 0 {", "if kept >= 0 {", "geofence/projection"),
    broken("geofence_microseconds", "fence.rs", "time_ms.div(S::constant(1000.0))", "time_ms.mul(S::constant(1000.0))", "geofence/projection"),
    broken("geofence_untruncated", "gates.rs", "Ok(kept) => plan.truncate(kept)", "Ok(kept) => plan.truncate(kept + 1)", "geofence/projection"),

    broken("clamp_at_the_bound", "speed.rs", "if length.le(max) {", "if length.lt(max) {", "clamp/unchanged"),
    broken("clamp_never", "speed.rs", "return Some(false);", "return Some(true);", "clamp/unchanged"),
    broken("clamp_not_finite", "speed.rs", "!all_finite(vector) || !max.is_finite()", "!all_finite(vector) && !max.is_finite()", "clamp/bound"),
    broken("clamp_zero_bound", "speed.rs", "|| !zero.lt(max)", "|| !zero.le(max)", "clamp/bound"),
    broken("clamp_no_last_look", "speed.rs", "if !norm(vector).le(max) {", "if norm(vector).le(max) {", "clamp/direction"),
    broken("clamp_wide_margin", "speed.rs", "+ 8.0)", "+ 9.0)", "clamp/direction"),
    broken("clamp_no_overflow", "speed.rs", "if !length.is_finite() {", "if length.is_finite() {", "clamp/direction"),
    broken("clamp_smallest", "speed.rs", "if largest.lt(x.abs()) {", "if x.abs().lt(largest) {", "clamp/direction"),
    broken("clamp_signed_largest", "speed.rs", "largest = x.abs();", "largest = *x;", "clamp/direction"),
    broken("clamp_inverse_scale", "speed.rs", "*x = x.mul(scale);", "*x = x.div(scale);", "clamp/direction"),
    broken("clamp_difference_of_squares", "speed.rs", "sum = sum.add(x.mul(*x));", "sum = sum.sub(x.mul(*x));", "clamp/unchanged"),
    broken("clamp_any_width", "speed.rs", "channel.is_velocity && channel.data.len() == 3", "channel.is_velocity || channel.data.len() == 3", "clamp/tick"),
    broken("clamp_other_units", "speed.rs", "if !channel.in_mps {", "if channel.in_mps {", "clamp/tick"),

    broken("latch_estop_ignored", "gates.rs", "if mode == Mode::Estop {", "if mode == Mode::Init {", "latch/gates"),
    broken("latch_inverted", "gates.rs", "if self.estop {", "if !self.estop {", "latch/gates"),
    broken("latch_outside_forgotten", "gates.rs", "if !inside(&position, radius_m) {\n                    self.estop = true;", "if !inside(&position, radius_m) {\n                    self.estop = false;", "latch/sequence"),
    broken("latch_hold_moves", "gates.rs", "if mode != Mode::Active {", "if mode == Mode::Active {", "latch/gates"),
    broken("latch_no_burst", "gates.rs", "if burst {", "if !burst {", "latch/sequence"),
    broken("latch_reset_latches", "gates.rs", "pub fn reset(&mut self) {\n        self.estop = false;", "pub fn reset(&mut self) {\n        self.estop = true;", "latch/sequence"),
    broken("latch_faults_both", "gates.rs", "is_faulty(max_speed_mps) || is_faulty(fence_m)", "is_faulty(max_speed_mps) && is_faulty(fence_m)", "latch/gates"),
    broken("latch_unbound", "gates.rs", "bound || matches!(limit, Limit::Disabled)", "bound && matches!(limit, Limit::Disabled)", "latch/gates"),
    broken("latch_config_ignored", "gates.rs", "if self.config_fault {", "if !self.config_fault {", "latch/gates"),
    broken("latch_stale_passes", "gates.rs", "if !last_s.is_some_and(", "if last_s.is_some_and(", "latch/sequence"),
    broken("latch_plant_hold_moves", "plant.rs", "Mode::Init | Mode::Hold => {\n                if self.watchdog.on_hold(seq)", "Mode::Init | Mode::Hold => {\n                if !self.watchdog.on_hold(seq)", "latch/plant"),
    broken("latch_plant_stopped_moves", "plant.rs", "self.watchdog.should_hold(now_s) || self.estop", "self.watchdog.should_hold(now_s) && self.estop", "latch/plant"),
    broken("latch_plant_no_stop", "plant.rs", "pub const fn stop(&mut self) {\n        self.estop = true;", "pub const fn stop(&mut self) {\n        self.estop = false;", "latch/plant-sequence"),
    broken("latch_plant_past_the_end", "plant.rs", "if tick > steps {", "if tick >= steps {", "latch/plant"),
    broken("latch_plant_replays", "plant.rs", "floor_index(steps + 1)", "floor_index(steps + 0)", "latch/plant"),
    broken("latch_plant_tick_times", "plant.rs", "age_ms(now_s, received_s).div(dt_ms)", "age_ms(now_s, received_s).mul(dt_ms)", "latch/plant"),
    broken("latch_horizon_unsaid", "gates.rs", "limited |= changed", "limited &= changed", "latch/horizon"),
    broken("latch_horizon_step_kept", "gates.rs", "plan.truncate(step);", "plan.truncate(step + 1);", "latch/horizon"),
    broken("latch_horizon_wrong_tick", "gates.rs", "plan.limit(step + 1, max_mps)", "plan.limit(step + 0, max_mps)", "latch/horizon"),
    broken("clamp_says_no", "speed.rs", "bring_within(vector, max).is_some()", "bring_within(vector, max).is_none()", "clamp/bound"),

    broken("number_difference", "scalar.rs", "self + other", "self - other", "number/operations"),
    broken("number_quotient", "scalar.rs", "self / other", "self * other", "number/operations"),
    broken("number_no_root", "scalar.rs", "Self::sqrt(self)", "Self::cbrt(self)", "number/operations"),
    broken("number_at_most", "scalar.rs", "self <= other", "self < other", "number/operations"),
    broken("number_infinite", "scalar.rs", "Self::is_finite(self)", "Self::is_infinite(self)", "number/operations"),
    broken("number_rounded_up", "scalar.rs", "self.floor()", "self.ceil()", "number/operations"),
    broken("number_no_end", "scalar.rs", "index.min(most)", "index.max(most)", "number/operations"),
    broken("number_not_zero", "scalar.rs", "self == 0", "self != 0", "number/operations"),
];
