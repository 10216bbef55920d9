//! The loops of the kernel: one turn of each from any state, what turns them, and the whole for long horizons.
//!
//! A loop holds for any number of turns when a turn keeps what is claimed of the state before it, and when the turns
//! are taken one after the other, each once, from the first on, until there is none or one that cannot be taken. The
//! state of a turn is whatever the one before has left: here it is arbitrary.

use std::marker::PhantomData;

use ncp_kernel::{Channel, Decision, Limit, Mode, Plan, Reason, Scalar};

use super::command::any_limit;
use super::words::{all_finite, end, is_within, positive, same_gates, share};
use crate::kernel::{GatesState, Kernel, PlantState, WatchdogState};
use crate::prover::Prover;

/// One turn of the projection: any step of a horizon, from any place, with any velocity, for any times and radius.
pub fn step<K: Kernel, P: Prover>(p: &mut P) {
    let (from, velocity) = (p.vector("from"), p.boolean("has_velocity").then(|| p.vector("v")));
    let (dt, ttl, radius) = (p.scalar("dt"), p.scalar("ttl"), p.scalar("radius"));
    let tick = p.index("tick");
    let answer = K::step_end(&OneStep { tick, velocity, zero: p.number(0.0) }, tick, &from, dt, ttl, radius);
    let time = share(p, tick, dt, ttl);
    let (place, is_inside) = end(p, from, velocity, time, radius);
    p.exactly("is taken exactly when it ends inside", answer.is_some(), is_inside);
    for (is, says) in answer.iter().flatten().zip(&place) {
        let same = p.same(*is, *says);
        p.check("it ends where its velocity leads in its share of the time", same);
    }
}

/// A command of which one step has a velocity, or none.
struct OneStep<S> {
    tick: usize,
    velocity: Option<[S; 3]>,
    zero: S,
}

impl<S: Scalar> Plan<S> for OneStep<S> {
    fn mode(&self) -> Mode {
        Mode::Active
    }
    fn ttl_ms(&self) -> S {
        self.zero
    }
    fn dt_ms(&self) -> Option<S> {
        None
    }
    fn steps(&self) -> usize {
        self.tick
    }
    fn limit(&mut self, _: usize, _: Limit<S>) -> Result<bool, Reason> {
        Err(Reason::NoVelocity)
    }
    fn velocity(&self, tick: usize) -> Option<[S; 3]> {
        self.velocity.filter(|_| tick == self.tick)
    }
    fn truncate(&mut self, _: usize) {}
}

/// The longest horizon that a frame may have. `[NCP-WIRE-067]`
const LONGEST: usize = 4_096;

/// What a turn has left: the number of the step. Nothing but a turn can make one.
struct Left(usize);

/// What turns both loops over a horizon: the steps are taken one after the other, each once and from what the one
/// before has left, up to the last or the first that cannot be taken; and no more turns than that.
pub fn follow<K: Kernel, P: Prover>(p: &mut P) {
    let (steps, fails) = if p.boolean("is_long") {
        let steps = p.choice("steps", LONGEST + 1);
        let at = [steps + 1, 1, 2, steps / 2, steps.saturating_sub(1), steps];
        (steps, at.get(p.choice("fails", at.len())).copied().unwrap_or(1).max(1))
    } else {
        let steps = p.choice("steps", 65);
        (steps, p.choice("fails", steps + 1) + 1)
    };
    let (mut turns, mut in_order) = (0, true);
    let (taken, Left(left)) = K::follow(steps, Left(0), |step, Left(before)| {
        turns += 1;
        // A kernel that goes on without end is stopped.
        assert!(turns <= LONGEST + 2, "the kernel does not end");
        in_order &= step == before + 1 && step == turns;
        (step != fails).then_some(Left(step))
    });
    let says = steps.min(fails - 1);
    let right = p.truth(in_order);
    p.check("each step from what the one before has left, in order, once", right);
    let right = p.truth(taken == says && left == says);
    p.check("up to the last, or the first that cannot be taken", right);
    let right = p.truth(turns == steps.min(fails));
    p.check("and no turn more", right);
}

/// One turn of the loop over the channels of a tick: any channel, after any others.
pub fn channel<K: Kernel, P: Prover>(p: &mut P) {
    let before = [p.boolean("was_changed"), p.boolean("had_velocity")];
    let limit = any_limit(p, "max");
    let width = p.choice("width", 5);
    let (is_velocity, in_mps) = (p.boolean("is_velocity"), p.boolean("in_mps"));
    let data: Vec<P::S> = (0..width).map(|axis| p.scalar(&format!("v_{axis}"))).collect();
    let mut after = data.clone();
    let answer = K::limit_channel(before, &mut Channel { data: &mut after, is_velocity, in_mps }, limit);

    let finite = all_finite(p, &data);
    let max = match limit {
        Limit::Enabled(max) if in_mps => Some(max),
        _ => None,
    };
    let bound = match max {
        Some(max) => positive(p, max),
        None => p.truth(true),
    };
    let infinite = p.not(finite);
    p.exactly("not finite exactly when so", answer == Err(Reason::NotFinite), infinite);
    let good = p.and(finite, bound);
    p.exactly("usable exactly when finite, and the bound is one", answer.is_ok(), good);
    let Ok([changed, has_velocity]) = answer else {
        let right = p.truth(matches!(answer, Err(Reason::NotFinite | Reason::NoVelocity)));
        p.check("no other reason", right);
        return;
    };
    let acts = max.is_some() && is_velocity && width == 3;
    let right = p.truth(has_velocity == (before[1] || acts));
    p.check("a velocity is one by name, three wide, in m/s", right);
    let above = match max {
        Some(max) => {
            let (is_now, was_within) = (is_within(p, &after, max), is_within(p, &data, max));
            p.check("a channel in m/s is within the limit", is_now);
            p.not(was_within)
        }
        None => p.truth(false),
    };
    let was_changed = p.truth(before[0]);
    let says = p.or(was_changed, above);
    p.exactly("says whether it changed something", changed, says);
    for (is, was) in after.iter().zip(&data) {
        let same = p.same(*is, *was);
        let right = p.or(above, same);
        p.check("what is not above the limit is as it was", right);
    }
}

/// How many channels a tick has.
const CHANNELS: [usize; 6] = [1, 2, 3, 9, 65, 257];
/// How wide one of them is.
const WIDTHS: [usize; 7] = [1, 3, 4, 9, 65, 257, 259];

/// The loops over channels and over components: with many of both, a channel that is too fast is limited, one that is
/// not finite is noticed and the velocity is found, wherever it stands, and whichever of its components is to blame.
pub fn channels<K: Kernel, P: Prover>(p: &mut P) {
    let (nth, wide) = (p.choice("channels", CHANNELS.len()), p.choice("width", WIDTHS.len()));
    let (count, width) = (CHANNELS.get(nth).copied().unwrap_or(1), WIDTHS.get(wide).copied().unwrap_or(3));
    let place = |nth: usize, of: usize| [0, of / 2, of - 1].get(nth).copied().unwrap_or(0);
    let (velocity_at, odd_at) = (place(p.choice("velocity_at", 3), count), place(p.choice("odd_at", 3), count));
    let axis = place(p.choice("axis", 3), width);
    let (kind, is_enabled) = (p.choice("kind", 3), p.boolean("is_enabled"));
    let [zero, one, max, fast] = [0.0, 1.0, 2.0, 3.0].map(|x| p.number(x));
    let odd = [one, fast, p.number(f64::NAN)].get(kind).copied().unwrap_or(one);
    let odd: Vec<P::S> = (0..width).map(|nth| if nth == axis { odd } else { zero }).collect();
    let mut data: Vec<Vec<P::S>> =
        (0..count).map(|nth| if nth == odd_at { odd.clone() } else { vec![zero, one, zero] }).collect();
    let limit = if is_enabled { Limit::Enabled(max) } else { Limit::Disabled };
    let channels = data.iter_mut().enumerate();
    let channels = channels.map(|(nth, data)| Channel { data, is_velocity: nth == velocity_at, in_mps: true });
    let answer = K::limit_tick(channels, limit);
    let says = if kind == 2 {
        Err(Reason::NotFinite)
    } else if is_enabled && velocity_at == odd_at && width != 3 {
        Err(Reason::NoVelocity)
    } else {
        Ok(kind == 1 && is_enabled)
    };
    let right = p.truth(answer == says);
    p.check("each of many channels and components counts", right);
    if answer.is_ok() && is_enabled {
        let within = is_within(p, data.get(odd_at).map_or(&odd[..], Vec::as_slice), max);
        p.check("and is limited", within);
    }
}

/// Horizons of every small length, and of those at which a narrower index would turn, up to the longest.
const LONG: [usize; 15] = [1, 2, 3, 4, 7, 8, 9, 16, 31, 64, 65, 129, 257, 1_025, LONGEST];

/// A whole command with a long horizon, of which one step is out of the ordinary: it leads out, is not finite, is too
/// fast, has no velocity, or leads out when the ttl is over. Whatever the limits, it is noticed, wherever it stands.
pub fn long<K: Kernel, P: Prover>(p: &mut P) {
    let nth = p.choice("steps", LONG.len());
    let steps = LONG.get(nth).copied().unwrap_or(1);
    let at = [1, 2, steps / 2, steps - 1, steps].get(p.choice("odd_at", 5)).copied().unwrap_or(1).clamp(1, steps);
    let (kind, is_fenced, is_limited) = (p.choice("kind", 5), p.boolean("is_fenced"), p.boolean("is_limited"));
    // A tick of 10 ms at 2 m/s leads from here to the outside.
    let [zero, edge, radius, max, fast, dt] = [0.0, 9.99, 10.0, 2.0, -4.0, 10.0].map(|x| p.number(x));
    #[expect(clippy::cast_precision_loss)]
    let ttl = p.number(if kind == 4 { 10.0 * at as f64 } else { 60_000.0 });
    let odd = match kind {
        1 => Some([zero, p.number(f64::NAN), zero]),
        2 => Some([fast, zero, zero]),
        3 => None,
        _ => Some([max, zero, zero]),
    };
    let velocities = (0..=steps).map(|tick| if tick == at { odd } else { Some([zero; 3]) }).collect();
    let mut plan = Long::<K, P::S> { mode: Mode::Active, ttl, dt: Some(dt), velocities, kernel: PhantomData };
    let (now, timeout) = (p.number(0.0), p.number(500.0));
    let mut gates = K::gates(is_limited.then_some(max), is_fenced.then_some(radius), timeout);
    let before = K::gates_state(&gates);
    let decision = K::gates_govern(&mut gates, &mut plan, now, Some(now), Some([edge, zero, zero]));
    same_gates(p, K::gates_state(&gates), before);

    let is_cut = match kind {
        0 => is_fenced,
        1 => true,
        3 => is_fenced || is_limited,
        _ => false,
    };
    let kept = if is_cut { at - 1 } else { steps };
    let is_changed = is_cut || (kind == 2 && is_limited);
    let says = if is_changed { Decision::Limited } else { Decision::Passed };
    let right = p.truth(plan.steps() == kept && decision == says);
    p.check("each step of a long horizon counts", right);
    if let Some(velocity) = plan.velocity(at).filter(|_| is_limited && kept >= at) {
        let within = is_within(p, &velocity, max);
        p.check("and is limited", within);
    }
}

/// A whole command with a long horizon at a gate that is closed: what it is answered, and the state after it, are those
/// of any other command there.
pub fn closed<K: Kernel, P: Prover>(p: &mut P) {
    let nth = p.choice("steps", LONG.len());
    let steps = LONG.get(nth).copied().unwrap_or(1);
    let closes = p.choice("closes", 13);
    let (is_fenced, is_limited) = (p.boolean("is_fenced"), p.boolean("is_limited"));
    let [zero, one, far, radius, timeout, long_ago, nan] =
        [0.0, 1.0, 11.0, 10.0, 500.0, -0.501, f64::NAN].map(|x| p.number(x));
    let (is_fenced, is_limited) = (is_fenced || matches!(closes, 5 | 6), is_limited || closes == 12);
    let bound = |is_enabled, bound| if is_enabled { Limit::Enabled(bound) } else { Limit::Disabled };
    let before = GatesState {
        max_speed_mps: bound(is_limited, one),
        fence_m: bound(is_fenced, radius),
        timeout_ms: timeout,
        config_fault: closes == 2,
        estop: closes == 0,
    };
    let mode = match closes {
        1 => Mode::Estop,
        7 => Mode::Hold,
        8 => Mode::Init,
        _ => Mode::Active,
    };
    let last = match closes {
        3 => None,
        4 => Some(long_ago),
        _ => Some(zero),
    };
    let position = match closes {
        5 => None,
        6 => Some([far, zero, zero]),
        _ => Some([zero; 3]),
    };
    let dt = match closes {
        9 => None,
        10 => Some(zero),
        _ => Some(one),
    };
    let first = match closes {
        11 => Some([zero, zero, nan]),
        12 => None,
        _ => Some([zero; 3]),
    };
    let velocities = std::iter::once(first).chain((0..steps).map(|_| Some([zero; 3]))).collect();
    let mut plan = Long::<K, P::S> { mode, ttl: timeout, dt, velocities, kernel: PhantomData };
    let mut gates = K::gates_in(before);
    let decision = K::gates_govern(&mut gates, &mut plan, zero, last, position);

    let says = match closes {
        0 | 1 => Decision::Stopped(Reason::Estop),
        2 => Decision::Held(Reason::ConfigFault),
        3 | 4 => Decision::Held(Reason::StaleSensor),
        5 => Decision::Held(Reason::NoPosition),
        6 => Decision::Stopped(Reason::OutsideFence),
        7 | 8 => Decision::Held(Reason::NotActive),
        9 | 10 => Decision::Held(Reason::BadHorizon),
        11 => Decision::Held(Reason::NotFinite),
        _ => Decision::Held(Reason::NoVelocity),
    };
    let right = p.truth(decision == says);
    p.check("a closed gate stops a horizon of any length", right);
    same_gates(p, K::gates_state(&gates), GatesState { estop: matches!(closes, 0 | 1 | 6), ..before });
}

/// A plant with a long horizon, asked at the beginning and in the middle of a tick: the one that it follows is that of
/// the command's age, and there is none past the end, however far.
pub fn replay<K: Kernel, P: Prover>(p: &mut P) {
    let nth = p.choice("steps", LONG.len() + 1);
    let steps = nth.checked_sub(1).and_then(|nth| LONG.get(nth)).copied().unwrap_or(0);
    let ticks = [0, 1, steps / 2, steps.saturating_sub(1), steps, steps + 1, steps + 256, 65_536, 65_537];
    // Beyond 32 bits, where a wider index is what a target has.
    let far = [1_u64 << 32, (1 << 32) + 1].map(|tick| usize::try_from(tick).unwrap_or(usize::MAX >> 12));
    let nth = p.choice("tick", ticks.len() + far.len());
    let tick = ticks.into_iter().chain(far).nth(nth).unwrap_or(0);
    // A tick of 2⁻³⁰ s, so that no age rounds.
    let length_s = 1.0 / f64::from(1 << 30);
    #[expect(clippy::cast_precision_loss)]
    let age_s = (tick as f64 + if p.boolean("is_halfway") { 0.5 } else { 0.0 }) * length_s;
    let [now, received, ttl, dt] = [age_s, 0.0, 60_000.0, 1000.0 * length_s].map(|x| p.number(x));
    let mut plant = K::plant_in::<P::S, P::Q>(PlantState {
        watchdog: WatchdogState { last_seq: None, deadline: Some((received, ttl)) },
        estop: false,
    });
    let answer = K::plant_active(&mut plant, now, Some(dt), steps);
    let says = if steps == 0 { Some(0) } else { Some(tick).filter(|tick| *tick <= steps) };
    let right = p.truth(answer == says);
    p.check("the tick of a long horizon is that of its age", right);
    let is_over = K::plant_state(&plant).watchdog.deadline.is_none();
    let right = p.truth(is_over == says.is_none());
    p.check("and past its end the plant holds for good", right);
}

/// A command whose ticks have a velocity, or nothing.
struct Long<K, S> {
    mode: Mode,
    ttl: S,
    dt: Option<S>,
    velocities: Vec<Option<[S; 3]>>,
    kernel: PhantomData<K>,
}

impl<K: Kernel, S: Scalar> Plan<S> for Long<K, S> {
    fn mode(&self) -> Mode {
        self.mode
    }
    fn ttl_ms(&self) -> S {
        self.ttl
    }
    fn dt_ms(&self) -> Option<S> {
        self.dt
    }
    fn steps(&self) -> usize {
        self.velocities.len() - 1
    }
    fn limit(&mut self, tick: usize, max_mps: Limit<S>) -> Result<bool, Reason> {
        let velocity = self.velocities.get_mut(tick).ok_or(Reason::NoVelocity)?;
        let channel = velocity.as_mut().map(|data| Channel { data, is_velocity: true, in_mps: true });
        K::limit_tick(channel.into_iter(), max_mps)
    }
    fn velocity(&self, tick: usize) -> Option<[S; 3]> {
        self.velocities.get(tick).copied().flatten()
    }
    fn truncate(&mut self, steps: usize) {
        self.velocities.truncate(steps + 1);
    }
}
