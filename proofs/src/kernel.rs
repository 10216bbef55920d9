//! The kernel as a harness calls it: the one of production, or a broken copy of its source.

use ncp_kernel::{Channel, Decision, Limit, Mode, Plan, Reason, Received, Scalar, Seq};

/// The operations of the numbers on which production runs the kernel.
#[allow(missing_docs, reason = "each is the operation of that name")]
#[derive(Debug, Clone, Copy)]
pub struct Numbers {
    pub constant: fn(f64) -> f64,
    pub add: fn(f64, f64) -> f64,
    pub sub: fn(f64, f64) -> f64,
    pub mul: fn(f64, f64) -> f64,
    pub div: fn(f64, f64) -> f64,
    pub sqrt: fn(f64) -> f64,
    pub abs: fn(f64) -> f64,
    pub select_lt: fn(f64, f64, f64, f64) -> f64,
    pub lt: fn(f64, f64) -> bool,
    pub le: fn(f64, f64) -> bool,
    pub is_finite: fn(f64) -> bool,
    pub floor_index: fn(f64, usize) -> usize,
    pub seq_is_zero: fn(i64) -> bool,
    pub seq_lt: fn(i64, i64) -> bool,
}

/// The whole state of a watchdog. The kernel's own is taken apart and put together member by member, so that a member
/// more or less there is an error of the compiler here; as with those below.
#[allow(missing_docs, reason = "each member is that of the kernel")]
#[derive(Debug, Clone, Copy)]
pub struct WatchdogState<S, Q> {
    pub last_seq: Option<Q>,
    pub deadline: Option<(S, S)>,
}

/// The whole state of a plant.
#[allow(missing_docs, reason = "each member is that of the kernel")]
#[derive(Debug, Clone, Copy)]
pub struct PlantState<S, Q> {
    pub watchdog: WatchdogState<S, Q>,
    pub estop: bool,
}

/// The whole state of the gates.
#[allow(missing_docs, reason = "each member is that of the kernel")]
#[derive(Debug, Clone, Copy)]
pub struct GatesState<S> {
    pub max_speed_mps: Limit<S>,
    pub fence_m: Limit<S>,
    pub timeout_ms: S,
    pub config_fault: bool,
    pub estop: bool,
}

/// Everything that the kernel decides.
#[allow(missing_docs, reason = "each function is that of the kernel")]
pub trait Kernel {
    type Watchdog<S: Scalar, Q: Seq>: Copy;
    type Plant<S: Scalar, Q: Seq>: Copy;
    type Gates<S: Scalar>: Copy;

    fn numbers() -> Numbers;

    fn enforced_ttl_ms<S: Scalar>(ttl_ms: S) -> Option<S>;
    fn within_deadline<S: Scalar>(now_s: S, received_s: S, ttl_ms: S) -> bool;
    fn is_fresh<S: Scalar>(now_s: S, last_s: S, timeout_ms: S) -> bool;
    fn advances<Q: Seq>(last: Option<Q>, seq: Q) -> bool;
    fn hold_takes_effect<Q: Seq>(last: Option<Q>, seq: Q) -> bool;
    fn limit<S: Scalar>(value: Option<S>) -> Limit<S>;
    fn inside<S: Scalar>(position: &[S; 3], radius: S) -> bool;
    fn bring_within<S: Scalar>(vector: &mut [S], max: S) -> Option<bool>;
    fn clamp<S: Scalar>(vector: &mut [S], max: S) -> bool;
    fn limit_tick<'a, S: Scalar + 'a>(
        channels: impl Iterator<Item = Channel<'a, S>>,
        max_mps: Limit<S>,
    ) -> Result<bool, Reason>;
    /// What is so far, and what the channel makes of it: whether one was changed, and whether there is a velocity.
    fn limit_channel<S: Scalar>(
        so_far: [bool; 2],
        channel: &mut Channel<'_, S>,
        max_mps: Limit<S>,
    ) -> Result<[bool; 2], Reason>;
    fn step_end<S: Scalar>(
        plan: &impl Plan<S>,
        tick: usize,
        from: &[S; 3],
        dt_ms: S,
        ttl_ms: S,
        radius: S,
    ) -> Option<[S; 3]>;
    fn follow<T>(steps: usize, start: T, step: impl FnMut(usize, &T) -> Option<T>) -> (usize, T);

    fn watchdog<S: Scalar, Q: Seq>() -> Self::Watchdog<S, Q>;
    fn watchdog_default<S: Scalar, Q: Seq>() -> Self::Watchdog<S, Q>;
    fn watchdog_command<S: Scalar, Q: Seq>(watchdog: &mut Self::Watchdog<S, Q>, now_s: S, ttl_ms: S, seq: Q) -> bool;
    fn watchdog_on_hold<S: Scalar, Q: Seq>(watchdog: &mut Self::Watchdog<S, Q>, seq: Q) -> bool;
    fn watchdog_should_hold<S: Scalar, Q: Seq>(watchdog: &mut Self::Watchdog<S, Q>, now_s: S) -> bool;
    fn watchdog_hold<S: Scalar, Q: Seq>(watchdog: &mut Self::Watchdog<S, Q>);
    fn watchdog_reset<S: Scalar, Q: Seq>(watchdog: &mut Self::Watchdog<S, Q>);
    fn watchdog_state<S: Scalar, Q: Seq>(watchdog: &Self::Watchdog<S, Q>) -> WatchdogState<S, Q>;
    fn watchdog_in<S: Scalar, Q: Seq>(state: WatchdogState<S, Q>) -> Self::Watchdog<S, Q>;
    /// What its accessors say.
    fn watchdog_says<S: Scalar, Q: Seq>(watchdog: &Self::Watchdog<S, Q>) -> WatchdogState<S, Q>;

    fn plant<S: Scalar, Q: Seq>() -> Self::Plant<S, Q>;
    fn plant_default<S: Scalar, Q: Seq>() -> Self::Plant<S, Q>;
    fn plant_command<S: Scalar, Q: Seq>(
        plant: &mut Self::Plant<S, Q>,
        mode: Mode,
        now_s: S,
        ttl_ms: S,
        seq: Q,
    ) -> Received;
    fn plant_stop<S: Scalar, Q: Seq>(plant: &mut Self::Plant<S, Q>);
    fn plant_active<S: Scalar, Q: Seq>(
        plant: &mut Self::Plant<S, Q>,
        now_s: S,
        dt_ms: Option<S>,
        steps: usize,
    ) -> Option<usize>;
    fn plant_reset<S: Scalar, Q: Seq>(plant: &mut Self::Plant<S, Q>);
    fn plant_state<S: Scalar, Q: Seq>(plant: &Self::Plant<S, Q>) -> PlantState<S, Q>;
    fn plant_in<S: Scalar, Q: Seq>(state: PlantState<S, Q>) -> Self::Plant<S, Q>;
    /// What its accessors say.
    fn plant_says<S: Scalar, Q: Seq>(plant: &Self::Plant<S, Q>) -> PlantState<S, Q>;

    fn gates<S: Scalar>(max_speed_mps: Option<S>, radius_m: Option<S>, timeout_ms: S) -> Self::Gates<S>;
    fn gates_bind<S: Scalar>(gates: &mut Self::Gates<S>, has_velocity: bool, has_position: bool);
    fn gates_govern<S: Scalar>(
        gates: &mut Self::Gates<S>,
        plan: &mut impl Plan<S>,
        now_s: S,
        last_s: Option<S>,
        position: Option<[S; 3]>,
    ) -> Decision;
    fn gates_note_link<S: Scalar>(gates: &mut Self::Gates<S>, burst: bool);
    fn gates_reset<S: Scalar>(gates: &mut Self::Gates<S>);
    fn gates_is_stopped<S: Scalar>(gates: &Self::Gates<S>) -> bool;
    fn gates_has_config_fault<S: Scalar>(gates: &Self::Gates<S>) -> bool;
    fn gates_state<S: Scalar>(gates: &Self::Gates<S>) -> GatesState<S>;
    fn gates_in<S: Scalar>(state: GatesState<S>) -> Self::Gates<S>;
}

/// Makes a [`Kernel`] of a module that has the kernel's functions, and of one that has its numbers.
macro_rules! kernel {
    ($(#[$doc:meta])* $name:ident = [$($module:tt)+] [$($numbers:tt)+]) => {
        $(#[$doc])*
        #[derive(Debug)]
        pub struct $name;

        impl $crate::kernel::Kernel for $name {
            type Watchdog<S: Scalar, Q: Seq> = $($module)+::Watchdog<S, Q>;
            type Plant<S: Scalar, Q: Seq> = $($module)+::Plant<S, Q>;
            type Gates<S: Scalar> = $($module)+::Gates<S>;

            fn numbers() -> $crate::kernel::Numbers {
                use $($numbers)+ as numbers;
                $crate::kernel::Numbers {
                    constant: <f64 as numbers::Scalar>::constant,
                    add: <f64 as numbers::Scalar>::add,
                    sub: <f64 as numbers::Scalar>::sub,
                    mul: <f64 as numbers::Scalar>::mul,
                    div: <f64 as numbers::Scalar>::div,
                    sqrt: <f64 as numbers::Scalar>::sqrt,
                    abs: <f64 as numbers::Scalar>::abs,
                    select_lt: <f64 as numbers::Scalar>::select_lt,
                    lt: <f64 as numbers::Scalar>::lt,
                    le: <f64 as numbers::Scalar>::le,
                    is_finite: <f64 as numbers::Scalar>::is_finite,
                    floor_index: <f64 as numbers::Scalar>::floor_index,
                    seq_is_zero: <i64 as numbers::Seq>::is_zero,
                    seq_lt: <i64 as numbers::Seq>::lt,
                }
            }

            fn enforced_ttl_ms<S: Scalar>(ttl_ms: S) -> Option<S> {
                $($module)+::enforced_ttl_ms(ttl_ms)
            }
            fn within_deadline<S: Scalar>(now_s: S, received_s: S, ttl_ms: S) -> bool {
                $($module)+::within_deadline(now_s, received_s, ttl_ms)
            }
            fn is_fresh<S: Scalar>(now_s: S, last_s: S, timeout_ms: S) -> bool {
                $($module)+::is_fresh(now_s, last_s, timeout_ms)
            }
            fn advances<Q: Seq>(last: Option<Q>, seq: Q) -> bool {
                $($module)+::advances(last, seq)
            }
            fn hold_takes_effect<Q: Seq>(last: Option<Q>, seq: Q) -> bool {
                $($module)+::hold_takes_effect(last, seq)
            }
            fn limit<S: Scalar>(value: Option<S>) -> Limit<S> {
                $($module)+::limit(value)
            }
            fn inside<S: Scalar>(position: &[S; 3], radius: S) -> bool {
                $($module)+::inside(position, radius)
            }
            fn bring_within<S: Scalar>(vector: &mut [S], max: S) -> Option<bool> {
                $($module)+::bring_within(vector, max)
            }
            fn clamp<S: Scalar>(vector: &mut [S], max: S) -> bool {
                $($module)+::clamp(vector, max)
            }
            fn limit_tick<'a, S: Scalar + 'a>(
                channels: impl Iterator<Item = Channel<'a, S>>,
                max_mps: Limit<S>,
            ) -> Result<bool, Reason> {
                $($module)+::limit_tick(channels, max_mps)
            }
            fn limit_channel<S: Scalar>(
                so_far: [bool; 2],
                channel: &mut Channel<'_, S>,
                max_mps: Limit<S>,
            ) -> Result<[bool; 2], Reason> {
                let [changed, has_velocity] = so_far;
                let so_far = $($module)+::Limited { changed, has_velocity };
                let $($module)+::Limited { changed, has_velocity } =
                    $($module)+::limit_channel(so_far, channel, max_mps)?;
                Ok([changed, has_velocity])
            }
            fn step_end<S: Scalar>(
                plan: &impl Plan<S>,
                tick: usize,
                from: &[S; 3],
                dt_ms: S,
                ttl_ms: S,
                radius: S,
            ) -> Option<[S; 3]> {
                $($module)+::step_end(plan, tick, from, dt_ms, ttl_ms, radius)
            }
            fn follow<T>(steps: usize, start: T, step: impl FnMut(usize, &T) -> Option<T>) -> (usize, T) {
                $($module)+::follow(steps, start, step)
            }
            fn watchdog<S: Scalar, Q: Seq>() -> Self::Watchdog<S, Q> {
                $($module)+::Watchdog::new()
            }
            fn watchdog_default<S: Scalar, Q: Seq>() -> Self::Watchdog<S, Q> {
                $($module)+::Watchdog::default()
            }
            fn watchdog_command<S: Scalar, Q: Seq>(
                watchdog: &mut Self::Watchdog<S, Q>,
                now_s: S,
                ttl_ms: S,
                seq: Q,
            ) -> bool {
                watchdog.on_command(now_s, ttl_ms, seq)
            }
            fn watchdog_on_hold<S: Scalar, Q: Seq>(
                watchdog: &mut Self::Watchdog<S, Q>,
                seq: Q,
            ) -> bool {
                watchdog.on_hold(seq)
            }
            fn watchdog_should_hold<S: Scalar, Q: Seq>(
                watchdog: &mut Self::Watchdog<S, Q>,
                now_s: S,
            ) -> bool {
                watchdog.should_hold(now_s)
            }
            fn watchdog_hold<S: Scalar, Q: Seq>(watchdog: &mut Self::Watchdog<S, Q>) {
                watchdog.hold();
            }
            fn watchdog_reset<S: Scalar, Q: Seq>(watchdog: &mut Self::Watchdog<S, Q>) {
                watchdog.reset();
            }
            fn watchdog_state<S: Scalar, Q: Seq>(
                watchdog: &Self::Watchdog<S, Q>,
            ) -> $crate::kernel::WatchdogState<S, Q> {
                let $($module)+::Watchdog { last_seq, deadline } = *watchdog;
                $crate::kernel::WatchdogState { last_seq, deadline }
            }
            fn watchdog_in<S: Scalar, Q: Seq>(
                state: $crate::kernel::WatchdogState<S, Q>,
            ) -> Self::Watchdog<S, Q> {
                let $crate::kernel::WatchdogState { last_seq, deadline } = state;
                $($module)+::Watchdog { last_seq, deadline }
            }
            fn watchdog_says<S: Scalar, Q: Seq>(
                watchdog: &Self::Watchdog<S, Q>,
            ) -> $crate::kernel::WatchdogState<S, Q> {
                $crate::kernel::WatchdogState { last_seq: watchdog.last_seq(), deadline: watchdog.deadline() }
            }
            fn plant<S: Scalar, Q: Seq>() -> Self::Plant<S, Q> {
                $($module)+::Plant::new()
            }
            fn plant_default<S: Scalar, Q: Seq>() -> Self::Plant<S, Q> {
                $($module)+::Plant::default()
            }
            fn plant_command<S: Scalar, Q: Seq>(
                plant: &mut Self::Plant<S, Q>,
                mode: Mode,
                now_s: S,
                ttl_ms: S,
                seq: Q,
            ) -> Received {
                plant.on_command(mode, now_s, ttl_ms, seq)
            }
            fn plant_stop<S: Scalar, Q: Seq>(plant: &mut Self::Plant<S, Q>) {
                plant.stop();
            }
            fn plant_active<S: Scalar, Q: Seq>(
                plant: &mut Self::Plant<S, Q>,
                now_s: S,
                dt_ms: Option<S>,
                steps: usize,
            ) -> Option<usize> {
                plant.active(now_s, dt_ms, steps)
            }
            fn plant_reset<S: Scalar, Q: Seq>(plant: &mut Self::Plant<S, Q>) {
                plant.reset();
            }
            fn plant_state<S: Scalar, Q: Seq>(
                plant: &Self::Plant<S, Q>,
            ) -> $crate::kernel::PlantState<S, Q> {
                let $($module)+::Plant { watchdog, estop } = *plant;
                $crate::kernel::PlantState { watchdog: Self::watchdog_state(&watchdog), estop }
            }
            fn plant_in<S: Scalar, Q: Seq>(
                state: $crate::kernel::PlantState<S, Q>,
            ) -> Self::Plant<S, Q> {
                let $crate::kernel::PlantState { watchdog, estop } = state;
                $($module)+::Plant { watchdog: Self::watchdog_in(watchdog), estop }
            }
            fn plant_says<S: Scalar, Q: Seq>(
                plant: &Self::Plant<S, Q>,
            ) -> $crate::kernel::PlantState<S, Q> {
                let watchdog = Self::watchdog_says(plant.watchdog());
                $crate::kernel::PlantState { watchdog, estop: plant.is_stopped() }
            }
            fn gates<S: Scalar>(
                max_speed_mps: Option<S>,
                radius_m: Option<S>,
                timeout_ms: S,
            ) -> Self::Gates<S> {
                $($module)+::Gates::new(max_speed_mps, radius_m, timeout_ms)
            }
            fn gates_bind<S: Scalar>(
                gates: &mut Self::Gates<S>,
                has_velocity: bool,
                has_position: bool,
            ) {
                gates.bind(has_velocity, has_position);
            }
            fn gates_govern<S: Scalar>(
                gates: &mut Self::Gates<S>,
                plan: &mut impl Plan<S>,
                now_s: S,
                last_s: Option<S>,
                position: Option<[S; 3]>,
            ) -> Decision {
                gates.govern(plan, now_s, last_s, || position)
            }
            fn gates_note_link<S: Scalar>(gates: &mut Self::Gates<S>, burst: bool) {
                gates.note_link(burst);
            }
            fn gates_reset<S: Scalar>(gates: &mut Self::Gates<S>) {
                gates.reset();
            }
            fn gates_is_stopped<S: Scalar>(gates: &Self::Gates<S>) -> bool {
                gates.is_stopped()
            }
            fn gates_has_config_fault<S: Scalar>(gates: &Self::Gates<S>) -> bool {
                gates.has_config_fault()
            }
            fn gates_state<S: Scalar>(gates: &Self::Gates<S>) -> $crate::kernel::GatesState<S> {
                let $($module)+::Gates { max_speed_mps, fence_m, timeout_ms, config_fault, estop } = *gates;
                $crate::kernel::GatesState { max_speed_mps, fence_m, timeout_ms, config_fault, estop }
            }
            fn gates_in<S: Scalar>(state: $crate::kernel::GatesState<S>) -> Self::Gates<S> {
                let $crate::kernel::GatesState { max_speed_mps, fence_m, timeout_ms, config_fault, estop } = state;
                $($module)+::Gates { max_speed_mps, fence_m, timeout_ms, config_fault, estop }
            }
        }
    };
}
#[cfg(any(feature = "broken", feature = "mutants"))]
pub(crate) use kernel;

kernel! {
    /// The kernel that production runs.
    Production = [ncp_kernel] [ncp_kernel]
}
