//! One function a decision, over any module that has the kernel's functions.

use ncp_kernel::Mode;

/// What the last accepted command left, as a plant says it.
#[repr(C)]
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Seen {
    /// 1 when there is a last seq.
    pub(crate) has_last: u64,
    /// It.
    pub(crate) last: i64,
    /// 1 when there is a deadline.
    pub(crate) has_deadline: u64,
    /// When its command was received, in seconds.
    pub(crate) received_s: f64,
    /// Its ttl, in ms.
    pub(crate) ttl_ms: f64,
    /// 1 while ESTOP is latched.
    pub(crate) stopped: u64,
}

/// One step: the state before, the answer, and the state after.
#[repr(C)]
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Step {
    /// Before the step.
    pub(crate) before: Seen,
    /// After it.
    pub(crate) after: Seen,
    /// What the kernel answered, as the function says.
    pub(crate) answer: u64,
}

/// One step of a governor's gates.
#[repr(C)]
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct GateStep {
    /// 1 while ESTOP is latched, before.
    pub(crate) stopped_before: u64,
    /// 1 when the limits cannot be enforced, before.
    pub(crate) fault_before: u64,
    /// 1 while ESTOP is latched, after.
    pub(crate) stopped_after: u64,
    /// 1 when the limits cannot be enforced, after.
    pub(crate) fault_after: u64,
    /// 0 passed, 1 limited, 2 held, 3 stopped; 4 for a step that is no decision.
    pub(crate) answer: u64,
}

/// There is a last seq, there is a speed limit.
pub(crate) const FIRST: u64 = 1;
/// There is a deadline, there is a fence.
pub(crate) const SECOND: u64 = 2;
/// ESTOP is latched.
pub(crate) const STOPPED: u64 = 4;
/// There is a dt, or a time of the sensor.
pub(crate) const TIMED: u64 = 8;
/// The velocity channel is not bound.
pub(crate) const NO_VELOCITY: u64 = 16;
/// The position channel is not bound.
pub(crate) const NO_POSITION: u64 = 32;
/// The sensor has a position.
pub(crate) const PLACED: u64 = 64;

/// Whether a flag is set.
#[inline]
#[must_use]
pub(crate) const fn has(flags: u64, flag: u64) -> bool {
    flags & flag != 0
}

/// The mode of a number.
#[inline]
#[must_use]
pub(crate) const fn mode(number: u64) -> Mode {
    match number {
        1 => Mode::Active,
        2 => Mode::Hold,
        3 => Mode::Estop,
        _ => Mode::Init,
    }
}

/// Exports the functions of a kernel's decisions under a prefix.
macro_rules! wrap {
    ($prefix:literal, $($kernel:tt)+) => {
        /// The exported functions.
        mod exported {
            use $($kernel)+ as kernel;
            use $crate::wrappers::{
                FIRST, GateStep, NO_POSITION, NO_VELOCITY, PLACED, SECOND, STOPPED, Seen, Step,
                TIMED, has, mode,
            };
            use ncp_kernel::Mode;

            type Plant = kernel::Plant<f64, i64>;
            type Watchdog = kernel::Watchdog<f64, i64>;

            /// `within_deadline`
            #[unsafe(export_name = concat!($prefix, "_within_deadline"))]
            extern "C" fn within_deadline(now_s: f64, received_s: f64, ttl_ms: f64) -> u8 {
                kernel::within_deadline(now_s, received_s, ttl_ms).into()
            }

            /// `is_fresh`
            #[unsafe(export_name = concat!($prefix, "_is_fresh"))]
            extern "C" fn is_fresh(now_s: f64, last_s: f64, timeout_ms: f64) -> u8 {
                kernel::is_fresh(now_s, last_s, timeout_ms).into()
            }

            /// `enforced_ttl_ms`: whether there is one; it in `out`.
            #[unsafe(export_name = concat!($prefix, "_enforced_ttl"))]
            extern "C" fn enforced_ttl(out: &mut f64, ttl_ms: f64) -> u8 {
                kernel::enforced_ttl_ms(ttl_ms).map(|ttl_ms| *out = ttl_ms).is_some().into()
            }

            /// `advances`
            #[unsafe(export_name = concat!($prefix, "_advances"))]
            extern "C" fn advances(flags: u64, last: i64, seq: i64) -> u8 {
                kernel::advances(has(flags, FIRST).then_some(last), seq).into()
            }

            /// `hold_takes_effect`
            #[unsafe(export_name = concat!($prefix, "_hold_takes_effect"))]
            extern "C" fn hold_takes_effect(flags: u64, last: i64, seq: i64) -> u8 {
                kernel::hold_takes_effect(has(flags, FIRST).then_some(last), seq).into()
            }

            /// `inside`
            #[unsafe(export_name = concat!($prefix, "_inside"))]
            extern "C" fn inside(x: f64, y: f64, z: f64, radius: f64) -> u8 {
                kernel::inside(&[x, y, z], radius).into()
            }

            /// `limit`: 0 disabled, 1 enabled, 2 faulty; the bound in `out`.
            #[unsafe(export_name = concat!($prefix, "_limit"))]
            extern "C" fn limit(out: &mut f64, flags: u64, value: f64) -> u8 {
                match kernel::limit(has(flags, FIRST).then_some(value)) {
                    ncp_kernel::Limit::Disabled => 0,
                    ncp_kernel::Limit::Enabled(bound) => {
                        *out = bound;
                        1
                    }
                    ncp_kernel::Limit::Faulty => 2,
                }
            }

            /// `clamp`: whether the vector is to be used; it in `out`.
            #[unsafe(export_name = concat!($prefix, "_clamp"))]
            extern "C" fn clamp(out: &mut [f64; 3], x: f64, y: f64, z: f64, max: f64) -> u8 {
                *out = [x, y, z];
                kernel::clamp(out, max).into()
            }

            /// `steps_inside` on a command without a horizon: 0 when it leads out, else 1.
            #[unsafe(export_name = concat!($prefix, "_projection"))]
            extern "C" fn projection(
                x: f64, y: f64, z: f64, radius: f64, u: f64, v: f64, w: f64, ttl_ms: f64,
            ) -> u8 {
                let plan = Tick { mode: Mode::Active, ttl_ms, velocity: [u, v, w] };
                kernel::steps_inside(&plan, &[x, y, z], radius).is_ok().into()
            }

            /// `Watchdog::on_command`: 1 when it refreshed the deadline.
            #[unsafe(export_name = concat!($prefix, "_watchdog_command"))]
            extern "C" fn watchdog_command(
                step: &mut Step, flags: u64, last: i64, seq: i64,
                received_s: f64, ttl_ms: f64, now_s: f64, new_ttl_ms: f64,
            ) {
                watch(step, flags, last, received_s, ttl_ms, |watchdog| {
                    watchdog.on_command(now_s, new_ttl_ms, seq).into()
                });
            }

            /// `Watchdog::on_hold`: 1 when it took effect.
            #[unsafe(export_name = concat!($prefix, "_watchdog_on_hold"))]
            extern "C" fn watchdog_on_hold(
                step: &mut Step, flags: u64, last: i64, seq: i64, received_s: f64, ttl_ms: f64,
            ) {
                watch(step, flags, last, received_s, ttl_ms, |watchdog| watchdog.on_hold(seq).into());
            }

            /// `Watchdog::should_hold`: 1 when the plant must hold.
            #[unsafe(export_name = concat!($prefix, "_watchdog_should_hold"))]
            extern "C" fn watchdog_should_hold(
                step: &mut Step, flags: u64, last: i64, received_s: f64, ttl_ms: f64, now_s: f64,
            ) {
                watch(step, flags, last, received_s, ttl_ms, |watchdog| {
                    watchdog.should_hold(now_s).into()
                });
            }

            /// `Watchdog::reset`
            #[unsafe(export_name = concat!($prefix, "_watchdog_reset"))]
            extern "C" fn watchdog_reset(
                step: &mut Step, flags: u64, last: i64, received_s: f64, ttl_ms: f64,
            ) {
                watch(step, flags, last, received_s, ttl_ms, |watchdog| {
                    watchdog.reset();
                    0
                });
            }

            /// `Plant::on_command`: 0 accepted, 1 held, 2 stopped, 3 dropped.
            #[unsafe(export_name = concat!($prefix, "_plant_command"))]
            extern "C" fn plant_command(
                step: &mut Step, flags: u64, last: i64, mode_number: u64, seq: i64,
                received_s: f64, ttl_ms: f64, now_s: f64, new_ttl_ms: f64,
            ) {
                plant(step, flags, last, received_s, ttl_ms, |plant| {
                    match plant.on_command(mode(mode_number), now_s, new_ttl_ms, seq) {
                        ncp_kernel::Received::Accepted => 0,
                        ncp_kernel::Received::Held => 1,
                        ncp_kernel::Received::Stopped => 2,
                        ncp_kernel::Received::Dropped => 3,
                    }
                });
            }

            /// `Plant::active`: 0 when it holds, or 1 more than the tick.
            #[unsafe(export_name = concat!($prefix, "_plant_active"))]
            extern "C" fn plant_active(
                step: &mut Step, flags: u64, last: i64, steps: usize,
                received_s: f64, ttl_ms: f64, now_s: f64, dt_ms: f64,
            ) {
                plant(step, flags, last, received_s, ttl_ms, |plant| {
                    let tick = plant.active(now_s, has(flags, TIMED).then_some(dt_ms), steps);
                    tick.map_or(0, |tick| tick as u64 + 1)
                });
            }

            /// `Plant::reset`
            #[unsafe(export_name = concat!($prefix, "_plant_reset"))]
            extern "C" fn plant_reset(
                step: &mut Step, flags: u64, last: i64, received_s: f64, ttl_ms: f64,
            ) {
                plant(step, flags, last, received_s, ttl_ms, |plant| {
                    plant.reset();
                    0
                });
            }

            /// `Gates::govern` on a command without a horizon.
            #[unsafe(export_name = concat!($prefix, "_gates_govern"))]
            #[allow(clippy::too_many_arguments, reason = "a proof wants every input by value")]
            extern "C" fn gates_govern(
                step: &mut GateStep, flags: u64, mode_number: u64,
                speed_mps: f64, radius_m: f64, timeout_ms: f64, now_s: f64, last_s: f64,
                x: f64, y: f64, z: f64, u: f64, v: f64, w: f64, ttl_ms: f64,
            ) {
                gate(step, flags, speed_mps, radius_m, timeout_ms, |gates| {
                    let mode = mode(mode_number);
                    let mut plan = Tick { mode, ttl_ms, velocity: [u, v, w] };
                    let last_s = has(flags, TIMED).then_some(last_s);
                    let position = || has(flags, PLACED).then_some([x, y, z]);
                    match gates.govern(&mut plan, now_s, last_s, position) {
                        ncp_kernel::Decision::Passed => 0,
                        ncp_kernel::Decision::Limited => 1,
                        ncp_kernel::Decision::Held(_) => 2,
                        ncp_kernel::Decision::Stopped(_) => 3,
                    }
                });
            }

            /// `Gates::note_link`
            #[unsafe(export_name = concat!($prefix, "_gates_note_link"))]
            extern "C" fn gates_note_link(
                step: &mut GateStep, flags: u64, burst: u64,
                speed_mps: f64, radius_m: f64, timeout_ms: f64,
            ) {
                gate(step, flags, speed_mps, radius_m, timeout_ms, |gates| {
                    gates.note_link(burst & 1 != 0);
                    4
                });
            }

            /// `Gates::reset`
            #[unsafe(export_name = concat!($prefix, "_gates_reset"))]
            extern "C" fn gates_reset(
                step: &mut GateStep, flags: u64, speed_mps: f64, radius_m: f64, timeout_ms: f64,
            ) {
                gate(step, flags, speed_mps, radius_m, timeout_ms, |gates| {
                    gates.reset();
                    4
                });
            }

            /// A command without a horizon, with one velocity in m/s.
            #[derive(Debug)]
            struct Tick {
                mode: Mode,
                ttl_ms: f64,
                velocity: [f64; 3],
            }

            impl ncp_kernel::Plan<f64> for Tick {
                #[inline]
                fn mode(&self) -> Mode {
                    self.mode
                }
                #[inline]
                fn ttl_ms(&self) -> f64 {
                    self.ttl_ms
                }
                #[inline]
                fn dt_ms(&self) -> Option<f64> {
                    None
                }
                #[inline]
                fn steps(&self) -> usize {
                    0
                }
                #[inline]
                fn limit(
                    &mut self,
                    _: usize,
                    max_mps: ncp_kernel::Limit<f64>,
                ) -> Result<bool, ncp_kernel::Reason> {
                    let data = &mut self.velocity;
                    let channel = ncp_kernel::Channel { data, is_velocity: true, in_mps: true };
                    kernel::limit_tick(std::iter::once(channel), max_mps)
                }
                #[inline]
                fn velocity(&self, _: usize) -> Option<[f64; 3]> {
                    Some(self.velocity)
                }
                #[inline]
                fn truncate(&mut self, _: usize) {}
            }

            /// A watchdog with a last seq and a deadline, and what a step makes of it.
            #[inline]
            fn watch(
                step: &mut Step, flags: u64, last: i64, received_s: f64, ttl_ms: f64,
                run: impl FnOnce(&mut Watchdog) -> u64,
            ) {
                let mut watchdog = Watchdog::new();
                if has(flags, FIRST) {
                    watchdog.on_command(received_s, ttl_ms, last);
                    if !has(flags, SECOND) {
                        watchdog.hold();
                    }
                }
                step.before = seen(&watchdog, false);
                step.answer = run(&mut watchdog);
                step.after = seen(&watchdog, false);
            }

            /// A plant with a last seq, a deadline and a latch, and what a step makes of it.
            #[inline]
            fn plant(
                step: &mut Step, flags: u64, last: i64, received_s: f64, ttl_ms: f64,
                run: impl FnOnce(&mut Plant) -> u64,
            ) {
                let mut plant = Plant::new();
                if has(flags, FIRST) {
                    plant.on_command(Mode::Active, received_s, ttl_ms, last);
                    if !has(flags, SECOND) {
                        plant.on_command(Mode::Hold, received_s, ttl_ms, last);
                    }
                }
                if has(flags, STOPPED) {
                    plant.stop();
                }
                step.before = seen(plant.watchdog(), plant.is_stopped());
                step.answer = run(&mut plant);
                step.after = seen(plant.watchdog(), plant.is_stopped());
            }

            /// Gates with limits, channels and a latch, and what a step makes of them.
            #[inline]
            fn gate(
                step: &mut GateStep, flags: u64, speed_mps: f64, radius_m: f64, timeout_ms: f64,
                run: impl FnOnce(&mut kernel::Gates<f64>) -> u64,
            ) {
                let speed_mps = has(flags, FIRST).then_some(speed_mps);
                let radius_m = has(flags, SECOND).then_some(radius_m);
                let mut gates = kernel::Gates::new(speed_mps, radius_m, timeout_ms);
                gates.bind(!has(flags, NO_VELOCITY), !has(flags, NO_POSITION));
                gates.note_link(has(flags, STOPPED));
                step.stopped_before = gates.is_stopped().into();
                step.fault_before = gates.has_config_fault().into();
                step.answer = run(&mut gates);
                step.stopped_after = gates.is_stopped().into();
                step.fault_after = gates.has_config_fault().into();
            }

            #[inline]
            fn seen(watchdog: &Watchdog, stopped: bool) -> Seen {
                let deadline = watchdog.deadline();
                let (received_s, ttl_ms) = deadline.unwrap_or_default();
                Seen {
                    has_last: watchdog.last_seq().is_some().into(),
                    last: watchdog.last_seq().unwrap_or_default(),
                    has_deadline: deadline.is_some().into(),
                    received_s,
                    ttl_ms,
                    stopped: stopped.into(),
                }
            }
        }
    };
}
pub(crate) use wrap;
