//! The gates as a whole: every state, every event, and a command with limits, fence and horizon at once.

use std::cell::RefCell;

use ncp_kernel::{Decision, Limit, Mode, Plan, Reason};

use super::geofence::{Asked, limit_says};
use super::latch::mode;
use super::words::{End, ends, fresh, positive, same_gates, same_limit};
use crate::kernel::{GatesState, Kernel};
use crate::prover::Prover;

/// A new governor's gates: the limits as they were read, the timeout as it was given, and no latch.
pub fn new<K: Kernel, P: Prover>(p: &mut P) {
    let (speed, radius, timeout_ms) = (p.optional("speed"), p.optional("radius"), p.scalar("timeout"));
    let gates = K::gates(speed, radius, timeout_ms);
    let state = K::gates_state(&gates);
    let mut fault = p.truth(false);
    for (is, value) in [(state.max_speed_mps, speed), (state.fence_m, radius)] {
        let (enabled, faulty) = limit_says(p, value);
        p.exactly("enabled exactly when finite and above 0", matches!(is, Limit::Enabled(_)), enabled);
        p.exactly("faulty exactly when negative or not finite", matches!(is, Limit::Faulty), faulty);
        if let (Limit::Enabled(is), Some(says)) = (is, value) {
            let same = p.same(is, says);
            p.check("the bound is the value", same);
        }
        fault = p.or(fault, faulty);
    }
    p.exactly("a config fault exactly for a faulty limit", state.config_fault, fault);
    // The limits are held above: here it is the rest.
    same_gates(p, state, GatesState { timeout_ms, estop: false, ..state });
    p.check_accessors::<K>(&gates);
}

/// A limit of any kind, and of any number.
pub(super) fn any_limit<P: Prover>(p: &mut P, name: &str) -> Limit<P::S> {
    match p.choice(name, 3) {
        0 => Limit::Disabled,
        1 => Limit::Enabled(p.scalar(name)),
        _ => Limit::Faulty,
    }
}

/// Any state of the gates at all, also one that they cannot reach.
fn any_state<P: Prover>(p: &mut P) -> GatesState<P::S> {
    GatesState {
        max_speed_mps: any_limit(p, "speed"),
        fence_m: any_limit(p, "radius"),
        timeout_ms: p.scalar("timeout"),
        config_fault: p.boolean("was_faulty"),
        estop: p.boolean("was_stopped"),
    }
}

/// One event other than a command at gates in any state: what it is for changes, and nothing else.
pub fn event<K: Kernel, P: Prover>(p: &mut P) {
    let before = any_state(p);
    let mut gates = K::gates_in(before);
    let says = match p.choice("event", 3) {
        0 => {
            let (has_velocity, has_position) = (p.boolean("binds_velocity"), p.boolean("binds_position"));
            K::gates_bind(&mut gates, has_velocity, has_position);
            let acts = |limit| !matches!(limit, Limit::Disabled);
            let unbound = (acts(before.max_speed_mps) && !has_velocity) || (acts(before.fence_m) && !has_position);
            GatesState { config_fault: before.config_fault || unbound, ..before }
        }
        1 => {
            let burst = p.boolean("burst");
            K::gates_note_link(&mut gates, burst);
            GatesState { estop: before.estop || burst, ..before }
        }
        _ => {
            K::gates_reset(&mut gates);
            GatesState { estop: false, ..before }
        }
    };
    same_gates(p, K::gates_state(&gates), says);
    p.check_accessors::<K>(&gates);
}

/// What the accessors of the gates say is their state.
trait Accessors: Prover {
    fn check_accessors<K: Kernel>(&mut self, gates: &K::Gates<Self::S>) {
        let GatesState { config_fault, estop, .. } = K::gates_state(gates);
        let right = K::gates_is_stopped(gates) == estop && K::gates_has_config_fault(gates) == config_fault;
        let right = self.truth(right);
        self.check("the accessors say what the state is", right);
    }
}
impl<P: Prover> Accessors for P {}

/// The most steps of a horizon here. Any number of them is the matter of the loops' own properties.
const STEPS: usize = 2;

/// One command, with a horizon or without, at gates in any state with both limits or one or none: the decision, what
/// is kept of the horizon, and the whole state after it. What a tick answers to the limit, and its velocity after
/// that, is anything that `clamp/tick` lets it be, drawn when the kernel asks.
pub fn govern<K: Kernel, P: Prover>(p: &mut P) {
    let before = any_state(p);
    // [NCP-SAFE-013] A faulty limit is a config fault in every state that gates reach.
    let is_faulty = |limit| matches!(limit, Limit::Faulty);
    let config_fault = before.config_fault || is_faulty(before.max_speed_mps) || is_faulty(before.fence_m);
    let before = GatesState { config_fault, ..before };
    let mut gates = K::gates_in(before);
    let mode = mode(p);
    let (now, last) = (p.scalar("now"), p.optional("last"));
    let position = p.boolean("has_position").then(|| p.vector("position"));
    let (ttl, dt, steps) = (p.scalar("ttl"), p.optional("dt"), p.choice("steps", STEPS + 1));
    let ticks = RefCell::new(Default::default());
    let mut command = Command { p: RefCell::new(p), mode, ttl, dt, steps, ticks, asked: Asked::default() };
    let decision = K::gates_govern(&mut gates, &mut command, now, last, position);
    let Command { p, steps: kept, ticks, asked, .. } = command;
    let (p, ticks) = (p.into_inner(), ticks.into_inner());
    asked.ends(p);

    // Each gate is reached only when none before it closed.
    let mut open = p.truth(true);
    let mut gate = |p: &mut P, name, is: bool, closes: P::B| {
        let here = p.and(open, closes);
        p.exactly(name, is, here);
        let passes = p.not(closes);
        open = p.and(open, passes);
        (here, open)
    };
    let stopped = p.truth(before.estop || mode == Mode::Estop);
    gate(p, "gate 1: ESTOP", decision == Decision::Stopped(Reason::Estop), stopped);
    let fault = p.truth(config_fault);
    gate(p, "gate 2: config", decision == Decision::Held(Reason::ConfigFault), fault);
    let fresh = match last {
        Some(last) => fresh(p, now, last, before.timeout_ms),
        None => p.truth(false),
    };
    let stale = p.not(fresh);
    gate(p, "gate 3: stale", decision == Decision::Held(Reason::StaleSensor), stale);
    let fence = match before.fence_m {
        Limit::Enabled(radius) => Some(radius),
        Limit::Disabled | Limit::Faulty => None,
    };
    let missing = p.truth(fence.is_some() && position.is_none());
    gate(p, "gate 4: no position", decision == Decision::Held(Reason::NoPosition), missing);
    let outside = match (fence, position) {
        (Some(radius), Some(position)) => {
            let inside = super::words::inside(p, &position, radius);
            p.not(inside)
        }
        _ => p.truth(false),
    };
    let (outside, _) = gate(p, "gate 4: outside", decision == Decision::Stopped(Reason::OutsideFence), outside);
    let inactive = p.truth(mode != Mode::Active);
    gate(p, "gate 5: only active moves", decision == Decision::Held(Reason::NotActive), inactive);
    let has_time = match dt {
        Some(dt) => positive(p, dt),
        None => p.truth(false),
    };
    let (with_steps, no_time) = (p.truth(steps > 0), p.not(has_time));
    let bad = p.and(with_steps, no_time);
    let (_, mut open) = gate(p, "gate 6: a bad horizon", decision == Decision::Held(Reason::BadHorizon), bad);

    // The latch, and the frame: no command changes anything else.
    let latched = p.or(stopped, outside);
    let state = K::gates_state(&gates);
    p.exactly("latches exactly by gates 1 and 4", state.estop, latched);
    same_gates(p, state, GatesState { estop: state.estop, ..before });

    let Some(first) = ticks[0] else {
        let unlimited = p.not(open);
        p.check("a command that comes so far is limited", unlimited);
        return;
    };
    if let Err(reason) = first.answer {
        let held = p.truth(decision == Decision::Held(reason));
        let right = p.implies(open, held);
        p.check("gate 6: tick 0 is not to be used", right);
        return;
    }
    // The steps before the first that is not to be used. One that was not limited is none of them.
    let is_usable = |tick: &&Option<Tick<P::S>>| tick.is_some_and(|tick| tick.answer.is_ok());
    let usable = ticks.iter().skip(1).take(steps).take_while(is_usable).count();
    let mut fits = usable;
    if let (Some(radius), Some(position)) = (fence, position) {
        let has_velocity = p.truth(first.velocity.is_some());
        let none = p.not(has_velocity);
        let held = p.truth(decision == Decision::Held(Reason::NoVelocity));
        let here = p.and(open, none);
        let right = p.implies(here, held);
        p.check("gate 7: no velocity to project", right);
        open = p.and(open, has_velocity);

        let velocities: Vec<_> = ticks.iter().take(usable + 1).map(|tick| (*tick)?.velocity).collect();
        let End { whole, ticks: inside } = ends(p, &position, radius, ttl, dt, &velocities);
        // Tick 0 ends inside, and so does the first step, or tick 0 after the whole ttl.
        let way = match (inside.first(), inside.get(1)) {
            (Some(first), Some(second)) => {
                let somehow = p.or(*second, whole);
                p.and(*first, somehow)
            }
            _ => whole,
        };
        let leaves = p.not(way);
        let here = p.and(open, leaves);
        p.exactly("gate 7: tick 0 leads out", decision == Decision::Held(Reason::LeavesFence), here);
        open = p.and(open, way);

        fits = kept.min(usable);
        for inside in inside.iter().skip(1).take(fits) {
            let right = p.implies(open, *inside);
            p.check("every kept step ends inside", right);
        }
        if let Some(next) = inside.get(fits + 1) {
            let out = p.not(*next);
            let right = p.implies(open, out);
            p.check("only a step that leads out is cut off", right);
        }
    }
    let right = p.truth(kept == fits);
    let right = p.implies(open, right);
    p.check("the horizon is kept up to there", right);
    let is_changed = |tick: &Option<Tick<P::S>>| tick.is_some_and(|tick| tick.answer == Ok(true));
    let changed = ticks.iter().take(usable + 1).any(is_changed) || kept < steps;
    let (is_changed, is_whole) = (p.truth(changed), p.truth(!changed));
    let (limited, passed) = (p.and(open, is_changed), p.and(open, is_whole));
    p.exactly("is limited exactly when something changes", decision == Decision::Limited, limited);
    p.exactly("passes exactly when nothing does", decision == Decision::Passed, passed);
    for tick in ticks.iter().take(kept + 1) {
        let once = p.truth(tick.is_some_and(|tick| tick.times == 1 && !tick.is_early));
        let as_configured = match tick.and_then(|tick| tick.limit) {
            Some(limit) => same_limit(p, limit, before.max_speed_mps),
            None => p.truth(false),
        };
        let right = p.and(once, as_configured);
        let right = p.implies(open, right);
        p.check("every kept tick was limited once, as configured, and then projected", right);
    }
}

/// A tick, once the kernel has asked for it.
#[derive(Debug, Clone, Copy)]
struct Tick<S> {
    /// What it answers to the limit.
    answer: Result<bool, Reason>,
    /// Its velocity after that.
    velocity: Option<[S; 3]>,
    /// The limit that it was asked to keep, and how often.
    limit: Option<Limit<S>>,
    times: usize,
    /// Whether its velocity was read before that.
    is_early: bool,
}

/// A command whose ticks are drawn when the kernel asks for them.
struct Command<'a, P: Prover> {
    p: RefCell<&'a mut P>,
    mode: Mode,
    ttl: P::S,
    dt: Option<P::S>,
    steps: usize,
    ticks: RefCell<[Option<Tick<P::S>>; STEPS + 2]>,
    asked: Asked,
}

impl<P: Prover> Command<'_, P> {
    /// A tick that answers to this limit in any way that `clamp/tick` allows; to none, as if it had been limited.
    fn draw(&self, nth: usize, limit: Option<Limit<P::S>>) -> Tick<P::S> {
        let ways: &[_] = match limit {
            None => &[(Ok(false), true)],
            Some(Limit::Enabled(_)) => &[
                (Ok(false), true),
                (Ok(true), true),
                (Err(Reason::NotFinite), false),
                (Err(Reason::NoVelocity), false),
            ],
            Some(Limit::Disabled) => &[(Ok(false), true), (Ok(false), false), (Err(Reason::NotFinite), false)],
            Some(Limit::Faulty) => &[(Err(Reason::NotFinite), false), (Err(Reason::NoVelocity), false)],
        };
        let p = &mut **self.p.borrow_mut();
        let way = p.choice(&format!("tick_{nth}"), ways.len());
        let (answer, moves) = ways.get(way).copied().unwrap_or((Ok(false), false));
        let velocity = moves.then(|| p.vector(&format!("v{nth}")));
        Tick { answer, velocity, limit, times: 0, is_early: limit.is_none() }
    }
}

impl<P: Prover> Plan<P::S> for Command<'_, P> {
    fn mode(&self) -> Mode {
        self.mode
    }
    fn ttl_ms(&self) -> P::S {
        self.ttl
    }
    fn dt_ms(&self) -> Option<P::S> {
        self.dt
    }
    fn steps(&self) -> usize {
        if self.asked.again() { self.steps } else { 0 }
    }
    fn limit(&mut self, tick: usize, max_mps: Limit<P::S>) -> Result<bool, Reason> {
        let known = self.ticks.borrow().get(tick).copied().ok_or(Reason::NoVelocity)?;
        let mut known = known.unwrap_or_else(|| self.draw(tick, Some(max_mps)));
        known.times += 1;
        if let Some(slot) = self.ticks.borrow_mut().get_mut(tick) {
            *slot = Some(known);
        }
        known.answer
    }
    fn velocity(&self, tick: usize) -> Option<[P::S; 3]> {
        if !self.asked.again() {
            return None;
        }
        let known = self.ticks.borrow().get(tick).copied()?;
        let known = known.unwrap_or_else(|| self.draw(tick, None));
        if let Some(slot) = self.ticks.borrow_mut().get_mut(tick) {
            *slot = Some(known);
        }
        known.velocity
    }
    fn truncate(&mut self, steps: usize) {
        self.steps = self.steps.min(steps);
    }
}
