//! One function a decision, over any module that has the kernel's functions.
//!
//! A function of a step takes a block of words: the *whole* state before, field by field, and what the step is given;
//! and leaves a block of words: the whole state after, and the answer. States are made and taken apart by naming each
//! field and no `..`: a field more or less does not compile here.

use ncp_kernel::{Limit, Mode, Reason};

/// There is a value.
pub(crate) const FIRST: u64 = 1;

/// The steps of a horizon, at most.
pub(crate) const STEPS: usize = 3;
/// The ticks: tick 0 and the steps.
pub(crate) const TICKS: usize = STEPS + 1;
/// The channels of a tick of which the speed limit is asked, at most.
pub(crate) const CHANNELS: usize = 2;

/// The words of gates: limit, m/s, limit, m, ms, fault, latch.
pub(crate) const GATES: usize = 7;
/// The words of a watchdog: last seq, deadline.
pub(crate) const WATCHDOG: usize = 5;
/// The words of a plant: those of its watchdog, latch.
pub(crate) const PLANT: usize = WATCHDOG + 1;
/// The words of what is governed: mode, time, time of the sensor, place, ttl, dt, steps.
pub(crate) const COMMAND: usize = 12;
/// The words of a tick of it: what the speed limit answers, the velocity before, and after.
pub(crate) const TICK: usize = 9;
/// The words of what the plan was asked of a tick: how often to limit it, to what limit.
pub(crate) const ASKED: usize = 3;
/// The words of a channel: how wide, whether the velocity, whether in m/s, three components.
pub(crate) const CHANNEL: usize = 6;

/// Two blocks of words, one after the other.
#[repr(C)]
pub(crate) struct Two<A, B>(pub(crate) A, pub(crate) B);
/// Three of them.
#[repr(C)]
pub(crate) struct Three<A, B, C>(pub(crate) A, pub(crate) B, pub(crate) C);

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

/// The limit of two words: 0 disabled, 1 enabled, 2 faulty; and the bound.
#[inline]
#[must_use]
pub(crate) const fn limit_of(kind: u64, bound: u64) -> Limit<f64> {
    match kind {
        1 => Limit::Enabled(f64::from_bits(bound)),
        2 => Limit::Faulty,
        _ => Limit::Disabled,
    }
}

/// The words of a limit; the bound is 0 where there is none.
#[inline]
#[must_use]
pub(crate) const fn words_of(limit: Limit<f64>) -> [u64; 2] {
    match limit {
        Limit::Disabled => [0, 0],
        Limit::Enabled(bound) => [1, bound.to_bits()],
        Limit::Faulty => [2, 0],
    }
}

/// The number of a reason, from 1 on, in the order of the vocabulary.
#[inline]
#[must_use]
pub(crate) const fn number(reason: Reason) -> u64 {
    reason as u64 + 1
}

/// A double of a word.
#[inline]
#[must_use]
pub(crate) const fn double(word: u64) -> f64 {
    f64::from_bits(word)
}

/// The components of a channel.
#[inline]
#[must_use]
pub(crate) const fn components(&[_, _, _, x, y, z]: &[u64; CHANNEL]) -> [f64; 3] {
    triple([x, y, z])
}

/// Three words of three doubles.
#[inline]
#[must_use]
pub(crate) const fn bits([x, y, z]: [f64; 3]) -> [u64; 3] {
    [x.to_bits(), y.to_bits(), z.to_bits()]
}

/// Three doubles of three words.
#[inline]
#[must_use]
pub(crate) const fn triple([x, y, z]: [u64; 3]) -> [f64; 3] {
    [f64::from_bits(x), f64::from_bits(y), f64::from_bits(z)]
}

/// Exports the functions of a kernel's decisions under a prefix.
macro_rules! wrap {
    ($prefix:literal, $($kernel:tt)+) => {
        /// The exported functions.
        mod exported {
            use $($kernel)+ as kernel;
            use $crate::wrappers::*;
            use ncp_kernel::{Channel, Decision, Limit, Mode, Plan, Reason, Received};

            type Gates = kernel::Gates<f64>;
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
                    Limit::Disabled => 0,
                    Limit::Enabled(bound) => {
                        *out = bound;
                        1
                    }
                    Limit::Faulty => 2,
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

            /// `Watchdog::new`
            #[unsafe(export_name = concat!($prefix, "_watchdog_new"))]
            extern "C" fn watchdog_new(out: &mut [u64; WATCHDOG], _: &[u64; 0]) {
                *out = words_of_watchdog(Watchdog::new());
            }

            /// `Watchdog::on_command`: 1 when it refreshed the deadline.
            #[unsafe(export_name = concat!($prefix, "_watchdog_command"))]
            extern "C" fn watchdog_command(
                out: &mut Two<[u64; WATCHDOG], u64>, Two(state, [seq, now_s, ttl_ms]): &Two<[u64; WATCHDOG], [u64; 3]>,
            ) {
                let mut watchdog = watchdog_of(state);
                let answer = watchdog.on_command(double(*now_s), double(*ttl_ms), *seq as i64);
                *out = Two(words_of_watchdog(watchdog), answer.into());
            }

            /// `Watchdog::on_hold`: 1 when it took effect.
            #[unsafe(export_name = concat!($prefix, "_watchdog_on_hold"))]
            extern "C" fn watchdog_on_hold(
                out: &mut Two<[u64; WATCHDOG], u64>, Two(state, seq): &Two<[u64; WATCHDOG], u64>,
            ) {
                let mut watchdog = watchdog_of(state);
                let answer = watchdog.on_hold(*seq as i64);
                *out = Two(words_of_watchdog(watchdog), answer.into());
            }

            /// `Watchdog::should_hold`: 1 when the plant must hold.
            #[unsafe(export_name = concat!($prefix, "_watchdog_should_hold"))]
            extern "C" fn watchdog_should_hold(
                out: &mut Two<[u64; WATCHDOG], u64>, Two(state, now_s): &Two<[u64; WATCHDOG], u64>,
            ) {
                let mut watchdog = watchdog_of(state);
                let answer = watchdog.should_hold(double(*now_s));
                *out = Two(words_of_watchdog(watchdog), answer.into());
            }

            /// `Watchdog::hold`
            #[unsafe(export_name = concat!($prefix, "_watchdog_hold"))]
            extern "C" fn watchdog_hold(out: &mut [u64; WATCHDOG], state: &[u64; WATCHDOG]) {
                let mut watchdog = watchdog_of(state);
                watchdog.hold();
                *out = words_of_watchdog(watchdog);
            }

            /// `Watchdog::reset`
            #[unsafe(export_name = concat!($prefix, "_watchdog_reset"))]
            extern "C" fn watchdog_reset(out: &mut [u64; WATCHDOG], state: &[u64; WATCHDOG]) {
                let mut watchdog = watchdog_of(state);
                watchdog.reset();
                *out = words_of_watchdog(watchdog);
            }

            /// `Plant::new`
            #[unsafe(export_name = concat!($prefix, "_plant_new"))]
            extern "C" fn plant_new(out: &mut [u64; PLANT], _: &[u64; 0]) {
                *out = words_of_plant(Plant::new());
            }

            /// `Plant::on_command`: 0 accepted, 1 held, 2 stopped, 3 dropped.
            #[unsafe(export_name = concat!($prefix, "_plant_command"))]
            extern "C" fn plant_command(
                out: &mut Two<[u64; PLANT], u64>,
                Two(state, [mode_number, seq, now_s, ttl_ms]): &Two<[u64; PLANT], [u64; 4]>,
            ) {
                let mut plant = plant_of(state);
                let received = plant.on_command(mode(*mode_number), double(*now_s), double(*ttl_ms), *seq as i64);
                let answer = match received {
                    Received::Accepted => 0,
                    Received::Held => 1,
                    Received::Stopped => 2,
                    Received::Dropped => 3,
                };
                *out = Two(words_of_plant(plant), answer);
            }

            /// `Plant::active`: 0 when it holds, or 1 more than the tick.
            #[unsafe(export_name = concat!($prefix, "_plant_active"))]
            extern "C" fn plant_active(
                out: &mut Two<[u64; PLANT], u64>,
                Two(state, [now_s, has_dt, dt_ms, steps]): &Two<[u64; PLANT], [u64; 4]>,
            ) {
                let mut plant = plant_of(state);
                let dt_ms = has(*has_dt, FIRST).then_some(double(*dt_ms));
                let tick = plant.active(double(*now_s), dt_ms, *steps as usize);
                *out = Two(words_of_plant(plant), tick.map_or(0, |tick| tick as u64 + 1));
            }

            /// `Plant::stop`
            #[unsafe(export_name = concat!($prefix, "_plant_stop"))]
            extern "C" fn plant_stop(out: &mut [u64; PLANT], state: &[u64; PLANT]) {
                let mut plant = plant_of(state);
                plant.stop();
                *out = words_of_plant(plant);
            }

            /// `Plant::reset`
            #[unsafe(export_name = concat!($prefix, "_plant_reset"))]
            extern "C" fn plant_reset(out: &mut [u64; PLANT], state: &[u64; PLANT]) {
                let mut plant = plant_of(state);
                plant.reset();
                *out = words_of_plant(plant);
            }

            /// `Gates::new`
            #[unsafe(export_name = concat!($prefix, "_gates_new"))]
            extern "C" fn gates_new(
                out: &mut [u64; GATES], [has_speed, speed_mps, has_fence, radius_m, timeout_ms]: &[u64; 5],
            ) {
                let speed_mps = has(*has_speed, FIRST).then_some(double(*speed_mps));
                let radius_m = has(*has_fence, FIRST).then_some(double(*radius_m));
                *out = words_of_gates(Gates::new(speed_mps, radius_m, double(*timeout_ms)));
            }

            /// `Gates::bind`
            #[unsafe(export_name = concat!($prefix, "_gates_bind"))]
            extern "C" fn gates_bind(
                out: &mut [u64; GATES], Two(state, [has_velocity, has_position]): &Two<[u64; GATES], [u64; 2]>,
            ) {
                let mut gates = gates_of(state);
                gates.bind(has(*has_velocity, FIRST), has(*has_position, FIRST));
                *out = words_of_gates(gates);
            }

            /// `Gates::note_link`
            #[unsafe(export_name = concat!($prefix, "_gates_note_link"))]
            extern "C" fn gates_note_link(out: &mut [u64; GATES], Two(state, burst): &Two<[u64; GATES], u64>) {
                let mut gates = gates_of(state);
                gates.note_link(has(*burst, FIRST));
                *out = words_of_gates(gates);
            }

            /// `Gates::reset`
            #[unsafe(export_name = concat!($prefix, "_gates_reset"))]
            extern "C" fn gates_reset(out: &mut [u64; GATES], state: &[u64; GATES]) {
                let mut gates = gates_of(state);
                gates.reset();
                *out = words_of_gates(gates);
            }

            /// What `govern` leaves: the gates, the answer, its reason, the steps, how often the place was asked for
            /// and a tick that there is none of, and what was asked of each tick.
            type Governed = Three<[u64; GATES], [u64; 5], [[u64; ASKED]; TICKS]>;

            /// `Gates::govern` on a command whose ticks answer anything: 0 passed, 1 limited, 2 held, 3 stopped.
            #[unsafe(export_name = concat!($prefix, "_gates_govern"))]
            extern "C" fn gates_govern(
                out: &mut Governed,
                Three(state, command, ticks): &Three<[u64; GATES], [u64; COMMAND], [[u64; TICK]; TICKS]>,
            ) {
                let mut gates = gates_of(state);
                let [mode_number, now_s, has_time, last_s, has_place, x, y, z, ttl_ms, has_dt, dt_ms, steps] =
                    *command;
                let mut plan = Answers {
                    mode: mode(mode_number),
                    ttl_ms: double(ttl_ms),
                    dt_ms: has(has_dt, FIRST).then_some(double(dt_ms)),
                    steps: steps as usize,
                    ticks,
                    asked: [[0; ASKED]; TICKS],
                    beyond: 0,
                };
                let last_s = has(has_time, FIRST).then_some(double(last_s));
                let mut places = 0;
                let decision = gates.govern(&mut plan, double(now_s), last_s, || {
                    places += 1;
                    has(has_place, FIRST).then_some(triple([x, y, z]))
                });
                let (answer, reason) = match decision {
                    Decision::Passed => (0, 0),
                    Decision::Limited => (1, 0),
                    Decision::Held(reason) => (2, number(reason)),
                    Decision::Stopped(reason) => (3, number(reason)),
                };
                let said = [answer, reason, plan.steps as u64, places, plan.beyond];
                *out = Three(words_of_gates(gates), said, plan.asked);
            }

            /// `limit_tick` on channels: 0 unchanged, 1 changed, or 2 more than the number of the reason; and the
            /// channels.
            #[unsafe(export_name = concat!($prefix, "_limit_tick"))]
            extern "C" fn limit_tick(
                out: &mut Two<u64, [[u64; 3]; CHANNELS]>,
                Three(limit, count, channels): &Three<[u64; 2], u64, [[u64; CHANNEL]; CHANNELS]>,
            ) {
                let [one, two] = channels;
                let (mut first, mut second) = (components(one), components(two));
                let given = [(one, &mut first), (two, &mut second)].into_iter().take(*count as usize);
                let given = given.map(|([width, is_velocity, in_mps, ..], data)| Channel {
                    data: data.split_at_mut((*width as usize).min(3)).0,
                    is_velocity: has(*is_velocity, FIRST),
                    in_mps: has(*in_mps, FIRST),
                });
                let [kind, bound] = *limit;
                let answer = match kernel::limit_tick(given, limit_of(kind, bound)) {
                    Ok(changed) => changed.into(),
                    Err(reason) => 2 + number(reason),
                };
                *out = Two(answer, [bits(first), bits(second)]);
            }

            /// A command of which each tick answers what its words say, and notes what it is asked.
            struct Answers<'a> {
                mode: Mode,
                ttl_ms: f64,
                dt_ms: Option<f64>,
                steps: usize,
                ticks: &'a [[u64; TICK]; TICKS],
                asked: [[u64; ASKED]; TICKS],
                beyond: u64,
            }

            impl Plan<f64> for Answers<'_> {
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
                    self.dt_ms
                }
                #[inline]
                fn steps(&self) -> usize {
                    self.steps
                }
                #[inline]
                fn limit(&mut self, tick: usize, max_mps: Limit<f64>) -> Result<bool, Reason> {
                    let (Some(asked), Some(words)) = (self.asked.get_mut(tick), self.ticks.get(tick)) else {
                        self.beyond += 1;
                        return Err(Reason::NoVelocity);
                    };
                    let [kind, bound] = words_of(max_mps);
                    *asked = [asked[0] + 1, kind, bound];
                    let refused = if words[0] == 2 { Reason::NotFinite } else { Reason::NoVelocity };
                    if words[0] <= 1 { Ok(words[0] == 1) } else { Err(refused) }
                }
                #[inline]
                fn velocity(&self, tick: usize) -> Option<[f64; 3]> {
                    let ([_, had, u, v, w, has_now, x, y, z], [times, ..]) =
                        (*self.ticks.get(tick)?, *self.asked.get(tick)?);
                    let (is_there, velocity) = if times > 0 { (has_now, [x, y, z]) } else { (had, [u, v, w]) };
                    has(is_there, FIRST).then_some(triple(velocity))
                }
                #[inline]
                fn truncate(&mut self, steps: usize) {
                    self.steps = self.steps.min(steps);
                }
            }

            /// A command without a horizon, with one velocity in m/s.
            struct Tick {
                mode: Mode,
                ttl_ms: f64,
                velocity: [f64; 3],
            }

            impl Plan<f64> for Tick {
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
                fn limit(&mut self, _: usize, _: Limit<f64>) -> Result<bool, Reason> {
                    Ok(false)
                }
                #[inline]
                fn velocity(&self, _: usize) -> Option<[f64; 3]> {
                    Some(self.velocity)
                }
                #[inline]
                fn truncate(&mut self, _: usize) {}
            }

            #[inline]
            fn gates_of(
                &[speed_kind, speed_mps, fence_kind, radius_m, timeout_ms, fault, estop]: &[u64; GATES],
            ) -> Gates {
                Gates {
                    max_speed_mps: limit_of(speed_kind, speed_mps),
                    fence_m: limit_of(fence_kind, radius_m),
                    timeout_ms: double(timeout_ms),
                    config_fault: has(fault, FIRST),
                    estop: has(estop, FIRST),
                }
            }

            #[inline]
            fn words_of_gates(gates: Gates) -> [u64; GATES] {
                let Gates { max_speed_mps, fence_m, timeout_ms, config_fault, estop } = gates;
                let ([speed_kind, speed_mps], [fence_kind, radius_m]) = (words_of(max_speed_mps), words_of(fence_m));
                let timeout_ms = timeout_ms.to_bits();
                [speed_kind, speed_mps, fence_kind, radius_m, timeout_ms, config_fault.into(), estop.into()]
            }

            #[inline]
            fn watchdog_of(&[has_last, last, has_deadline, received_s, ttl_ms]: &[u64; WATCHDOG]) -> Watchdog {
                Watchdog {
                    last_seq: has(has_last, FIRST).then_some(last as i64),
                    deadline: has(has_deadline, FIRST).then_some((double(received_s), double(ttl_ms))),
                }
            }

            #[inline]
            fn words_of_watchdog(watchdog: Watchdog) -> [u64; WATCHDOG] {
                let Watchdog { last_seq, deadline } = watchdog;
                let (received_s, ttl_ms) = deadline.unwrap_or_default();
                [
                    last_seq.is_some().into(),
                    last_seq.unwrap_or_default() as u64,
                    deadline.is_some().into(),
                    received_s.to_bits(),
                    ttl_ms.to_bits(),
                ]
            }

            #[inline]
            fn plant_of(&[has_last, last, has_deadline, received_s, ttl_ms, estop]: &[u64; PLANT]) -> Plant {
                let watchdog = watchdog_of(&[has_last, last, has_deadline, received_s, ttl_ms]);
                Plant { watchdog, estop: has(estop, FIRST) }
            }

            #[inline]
            fn words_of_plant(plant: Plant) -> [u64; PLANT] {
                let Plant { watchdog, estop } = plant;
                let [has_last, last, has_deadline, received_s, ttl_ms] = words_of_watchdog(watchdog);
                [has_last, last, has_deadline, received_s, ttl_ms, estop.into()]
            }
        }
    };
}
pub(crate) use wrap;
