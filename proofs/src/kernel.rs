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
    pub lt: fn(f64, f64) -> bool,
    pub le: fn(f64, f64) -> bool,
    pub is_finite: fn(f64) -> bool,
    pub floor_index: fn(f64, usize) -> usize,
    pub seq_is_zero: fn(i64) -> bool,
    pub seq_lt: fn(i64, i64) -> bool,
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

    fn watchdog<S: Scalar, Q: Seq>() -> Self::Watchdog<S, Q>;
    fn watchdog_default<S: Scalar, Q: Seq>() -> Self::Watchdog<S, Q>;
    fn watchdog_command<S: Scalar, Q: Seq>(watchdog: &mut Self::Watchdog<S, Q>, now_s: S, ttl_ms: S, seq: Q) -> bool;
    fn watchdog_on_hold<S: Scalar, Q: Seq>(watchdog: &mut Self::Watchdog<S, Q>, seq: Q) -> bool;
    fn watchdog_should_hold<S: Scalar, Q: Seq>(watchdog: &mut Self::Watchdog<S, Q>, now_s: S) -> bool;
    fn watchdog_hold<S: Scalar, Q: Seq>(watchdog: &mut Self::Watchdog<S, Q>);
    fn watchdog_reset<S: Scalar, Q: Seq>(watchdog: &mut Self::Watchdog<S, Q>);
    fn watchdog_state<S: Scalar, Q: Seq>(watchdog: &Self::Watchdog<S, Q>) -> (Option<Q>, Option<(S, S)>);

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
    fn plant_is_stopped<S: Scalar, Q: Seq>(plant: &Self::Plant<S, Q>) -> bool;
    fn plant_state<S: Scalar, Q: Seq>(plant: &Self::Plant<S, Q>) -> (Option<Q>, Option<(S, S)>);

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
            ) -> (Option<Q>, Option<(S, S)>) {
                (watchdog.last_seq(), watchdog.deadline())
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
            fn plant_is_stopped<S: Scalar, Q: Seq>(plant: &Self::Plant<S, Q>) -> bool {
                plant.is_stopped()
            }
            fn plant_state<S: Scalar, Q: Seq>(
                plant: &Self::Plant<S, Q>,
            ) -> (Option<Q>, Option<(S, S)>) {
                (plant.watchdog().last_seq(), plant.watchdog().deadline())
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
        }
    };
}
#[cfg(any(feature = "broken", feature = "mutants"))]
pub(crate) use kernel;

kernel! {
    /// The kernel that production runs.
    Production = [ncp_kernel] [ncp_kernel]
}
