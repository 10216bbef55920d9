//! The geofence: where the plant is, what its limit says, and where a command leads.

use std::cell::Cell;

use ncp_kernel::{Decision, Limit, Mode, Plan, Reason, Scalar};

use super::clamp::{Sized, sized};
pub use super::loops::{follow, long, step};
use super::words::{enforced, is_within, positive};
use crate::kernel::Kernel;
use crate::prover::Prover;

/// Inside exactly for three finite components whose norm is not above a finite, positive radius.
pub fn inside<K: Kernel, P: Prover>(p: &mut P) {
    let position = p.vector("position");
    let radius = p.scalar("radius");
    let answer = K::inside(&position, radius);
    let says = super::words::inside(p, &position, radius);
    p.exactly("inside", answer, says);
}

/// Of every size: inside exactly where the exact norm is not above the radius.
pub fn range<K: Kernel, P: Prover>(p: &mut P) {
    let Sized { vector, bound, is_within, .. } = sized(p);
    let (position, radius) = (vector.map(|x| p.number(x)), p.number(bound));
    let right = p.truth(K::inside(&position, radius) == is_within);
    p.check("inside exactly within the radius", right);
}

/// A limit is enabled exactly when finite and above 0, disabled when absent or 0, and else faulty.
pub fn limit<K: Kernel, P: Prover>(p: &mut P) {
    let value = p.optional("value");
    let answer = K::limit(value);
    let (enabled, faulty) = limit_says(p, value);
    p.exactly("enabled", matches!(answer, Limit::Enabled(_)), enabled);
    p.exactly("faulty", matches!(answer, Limit::Faulty), faulty);
    if let (Limit::Enabled(is), Some(says)) = (answer, value) {
        let same = p.same(is, says);
        p.check("the bound is the value", same);
    }
}

/// Whether a limit is enabled, and whether it is faulty. `[NCP-SAFE-012] [NCP-SAFE-013]`
pub(super) fn limit_says<P: Prover>(p: &mut P, value: Option<P::S>) -> (P::B, P::B) {
    let Some(value) = value else {
        let no = p.truth(false);
        return (no, no);
    };
    let zero = p.number(0.0);
    let (finite, negative) = (p.finite(value), p.lt(value, zero));
    let infinite = p.not(finite);
    (positive(p, value), p.or(infinite, negative))
}

/// No accepted tick or step ends outside the fence; only a step that ends outside, or has no velocity, is
/// cut off. Up to 3 steps, no speed limit.
pub fn projection<K: Kernel, P: Prover>(p: &mut P) {
    project::<K, P>(p, false, 3);
}

/// The same with a speed limit: the projection sees the clamped velocities, and these are within the
/// limit. Without a horizon: the paths of two clamps multiply, and the projection of a horizon is proved
/// above for all velocities, so for clamped ones too.
pub fn projection_and_clamp<K: Kernel, P: Prover>(p: &mut P) {
    project::<K, P>(p, true, 0);
}

fn project<K: Kernel, P: Prover>(p: &mut P, has_speed_limit: bool, most_steps: usize) {
    let radius = p.scalar("radius");
    let max = has_speed_limit.then(|| p.scalar("max"));
    let steps = p.choice("steps", most_steps + 1);
    let position = p.vector("position");
    let mut ticks: [Option<[P::S; 3]>; 4] = [None; 4];
    for (tick, velocity) in ticks.iter_mut().enumerate().take(steps + 1) {
        *velocity = p.boolean(&format!("has_velocity_{tick}")).then(|| p.vector(&format!("v{tick}")));
    }
    let before = ticks;
    let (ttl, dt) = (p.scalar("ttl"), p.optional("dt"));
    let mut plan = Ticks::<K, P::S> {
        mode: Mode::Active,
        ttl,
        dt,
        ticks,
        steps,
        asked: Asked::default(),
        kernel: std::marker::PhantomData,
    };

    let (now, timeout) = (p.number(0.0), p.number(500.0));
    let mut gates = K::gates(max, Some(radius), timeout);
    let decision = K::gates_govern(&mut gates, &mut plan, now, Some(now), Some(position));
    let kept = plan.steps;
    plan.asked.ends(p);

    // T of 7.5, 0 where the ttl is none.
    let (is_time, zero) = (positive(p, ttl), p.number(0.0));
    let whole = enforced(p, ttl);
    let whole = p.select(is_time, whole, zero);
    let travel = |p: &mut P, from: [P::S; 3], tick: usize, time: P::S| {
        let velocity = plan.ticks.get(tick).copied().flatten()?;
        let seconds = time.div(p.number(1000.0));
        let [x, y, z] = from;
        let [u, v, w] = velocity;
        Some([x.add(u.mul(seconds)), y.add(v.mul(seconds)), z.add(w.mul(seconds))])
    };
    // The part of [k·dt, (k + 1)·dt) before T.
    let share = |p: &mut P, tick: usize| {
        #[expect(clippy::cast_precision_loss)]
        let nth = p.number(tick as f64);
        let dt = dt.unwrap_or_else(|| p.number(f64::NAN));
        let start = nth.mul(dt);
        let rest = whole.sub(start);
        let (shorter, begins) = (p.lt(dt, rest), p.lt(start, whole));
        let part = p.select(shorter, dt, rest);
        p.select(begins, part, zero)
    };
    match decision {
        Decision::Passed | Decision::Limited => {
            let here = end_inside(p, Some(position), radius);
            p.check("starts inside", here);
            let mut place = Some(position);
            if kept == 0 {
                let end = travel(p, position, 0, whole);
                let good = end_inside(p, end, radius);
                p.check("tick 0 alone ends inside after the whole ttl", good);
            } else {
                let dt_good = match dt {
                    Some(dt) => positive(p, dt),
                    None => p.truth(false),
                };
                p.check("a tick has a length", dt_good);
                for tick in 0..=kept {
                    let time = share(p, tick);
                    place = place.and_then(|from| travel(p, from, tick, time));
                    let good = end_inside(p, place, radius);
                    p.check("every kept tick ends inside", good);
                }
            }
            if kept < steps {
                // The first one that was cut off.
                let mut place = Some(position);
                for tick in 0..=kept + 1 {
                    let time = share(p, tick);
                    place = place.and_then(|from| travel(p, from, tick, time));
                }
                let ends_inside = end_inside(p, place, radius);
                let usable = match before.get(kept + 1).copied().flatten() {
                    Some(velocity) => super::words::all_finite(p, &velocity),
                    None => p.truth(false),
                };
                let good = p.and(ends_inside, usable);
                let bad = p.not(good);
                p.check("only a step that leads out is cut off", bad);
            }
            for velocity in plan.ticks.iter().take(kept + 1).flatten() {
                let finite = super::words::all_finite(p, velocity);
                p.check("every kept velocity is finite", finite);
                if let Some(max) = max {
                    let (within, (enabled, _)) = (is_within(p, velocity, max), limit_says(p, Some(max)));
                    let good = p.implies(enabled, within);
                    p.check("every kept velocity is within the limit", good);
                }
            }
            let changed = (0..=kept).filter_map(|tick| {
                let (before, after) = (before.get(tick)?.as_ref()?, plan.ticks.get(tick)?.as_ref()?);
                Some((*before, *after))
            });
            if decision == Decision::Passed {
                let whole = p.truth(kept == steps);
                p.check("nothing is cut off silently", whole);
                for (before, after) in changed {
                    for (before, after) in before.iter().zip(&after) {
                        let same = p.same(*before, *after);
                        p.check("nothing is changed silently", same);
                    }
                }
            }
        }
        Decision::Held(Reason::LeavesFence) => {
            let first = share(p, 0);
            let end = if steps > 0 && kept > 0 {
                let after_tick = travel(p, position, 0, first);
                let tick = end_inside(p, after_tick, radius);
                let after_all = travel(p, position, 0, whole);
                let all = end_inside(p, after_all, radius);
                p.and(tick, all)
            } else {
                let after_all = travel(p, position, 0, whole);
                end_inside(p, after_all, radius)
            };
            let outside = p.not(end);
            p.check("holds for the fence only when tick 0 leads out", outside);
            let has_velocity = p.truth(before[0].is_some());
            p.check("without a velocity the reason is another", has_velocity);
        }
        Decision::Stopped(_) => {
            let (inside, (enabled, faulty)) = (super::words::inside(p, &position, radius), limit_says(p, Some(radius)));
            let outside = p.not(inside);
            let sound = p.not(faulty);
            let good = p.all(&[outside, enabled, sound]);
            p.check("stops only outside an enabled fence", good);
        }
        Decision::Held(Reason::NoPosition | Reason::StaleSensor | Reason::Estop | Reason::NotActive) => {
            p.never("no other gate closes");
        }
        Decision::Held(Reason::BadHorizon) => {
            let has_time = match dt {
                Some(dt) => positive(p, dt),
                None => p.truth(false),
            };
            let none = p.not(has_time);
            let with_steps = p.truth(steps > 0);
            let good = p.and(none, with_steps);
            p.check("a bad horizon is one", good);
        }
        Decision::Held(Reason::NotFinite) => {
            let finite = match before.first().copied().flatten() {
                Some(velocity) => super::words::all_finite(p, &velocity),
                None => p.truth(true),
            };
            let bad = p.not(finite);
            p.check("holds for a component only when it is not finite", bad);
        }
        Decision::Held(Reason::NoVelocity) => {
            let none = p.truth(before.first().copied().flatten().is_none());
            p.check("holds for the velocity only when there is none", none);
        }
        Decision::Held(Reason::ConfigFault | Reason::OutsideFence) => {
            let (_, mut faulty) = limit_says(p, Some(radius));
            if let Some(max) = max {
                let (_, other) = limit_says(p, Some(max));
                faulty = p.or(faulty, other);
            }
            p.check("a config fault is one", faulty);
        }
    }
}

fn end_inside<P: Prover>(p: &mut P, end: Option<[P::S; 3]>, radius: P::S) -> P::B {
    let near = match end {
        Some(end) => super::words::inside(p, &end, radius),
        None => p.truth(false),
    };
    // A fence of radius 0 is disabled, and has no outside.
    let (enabled, _) = limit_says(p, Some(radius));
    p.implies(enabled, near)
}

/// A command whose ticks have a velocity channel, or none.
pub(super) struct Ticks<K, S> {
    pub(super) mode: Mode,
    pub(super) ttl: S,
    pub(super) dt: Option<S>,
    pub(super) ticks: [Option<[S; 3]>; 4],
    pub(super) steps: usize,
    /// How often it was asked.
    pub(super) asked: Asked,
    pub(super) kernel: std::marker::PhantomData<K>,
}

/// Counts the questions to a plan. A kernel that asks without end is told after some that there is nothing more, and
/// fails a check; one that goes on even so is ended.
#[derive(Debug, Default)]
pub(super) struct Asked(Cell<u32>);

impl Asked {
    /// More than any plan of a harness is asked.
    const ENOUGH: u32 = 100;

    /// Whether this question is still answered.
    pub(super) fn again(&self) -> bool {
        self.0.set(self.0.get() + 1);
        assert!(self.0.get() < 100 * Self::ENOUGH, "the kernel does not end");
        self.0.get() <= Self::ENOUGH
    }

    /// The check that it ends.
    pub(super) fn ends<P: Prover>(&self, p: &mut P) {
        let ends = p.truth(self.0.get() <= Self::ENOUGH);
        p.check("the kernel ends", ends);
    }
}

impl<K: Kernel, S: Scalar> Plan<S> for Ticks<K, S> {
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
        if self.asked.again() { self.steps } else { 0 }
    }
    fn limit(&mut self, tick: usize, max_mps: Limit<S>) -> Result<bool, Reason> {
        let velocity = self.ticks.get_mut(tick).and_then(Option::as_mut);
        let channels =
            velocity.map(|data| ncp_kernel::Channel { data: data.as_mut_slice(), is_velocity: true, in_mps: true });
        K::limit_tick(channels.into_iter(), max_mps)
    }
    fn velocity(&self, tick: usize) -> Option<[S; 3]> {
        let tick = self.ticks.get(tick).copied().flatten();
        tick.filter(|_| self.asked.again())
    }
    fn truncate(&mut self, steps: usize) {
        self.steps = self.steps.min(steps);
    }
}
