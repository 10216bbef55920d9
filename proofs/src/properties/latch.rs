//! The latch of ESTOP, the order of the gates, and who may move the plant.

use ncp_kernel::{Decision, Limit, Mode, Plan, Reason, Received, Scalar};

use super::geofence::{Asked, Ticks, limit_says};
use super::words::{advances, alive, fresh, hold_takes_effect, positive};
use crate::kernel::{Kernel, PlantState, WatchdogState};
use crate::prover::Prover;

pub use super::command::{event, govern, new};
pub use super::loops::{closed, replay};

const MODES: [Mode; 4] = [Mode::Active, Mode::Hold, Mode::Init, Mode::Estop];

pub(super) fn mode<P: Prover>(p: &mut P) -> Mode {
    let nth = p.choice("mode", MODES.len());
    MODES.get(nth).copied().unwrap_or(Mode::Hold)
}

/// One command at gates in any state: the first gate of 7.3 that closes decides, ESTOP latches exactly by
/// gates 1 and 4, and nothing but `active` passes. Gates 6 to 8 are the properties of clamp and fence.
pub fn gates<K: Kernel, P: Prover>(p: &mut P) {
    let (speed, radius, timeout) = (p.optional("speed"), p.optional("radius"), p.scalar("timeout"));
    let (has_velocity, has_position) = (p.boolean("binds_velocity"), p.boolean("binds_position"));
    let was_stopped = p.boolean("was_stopped");
    let mut gates = K::gates(speed, radius, timeout);
    K::gates_bind(&mut gates, has_velocity, has_position);
    K::gates_note_link(&mut gates, was_stopped);

    let ((speeds, bad_speed), (fenced, bad_fence)) = (limit_says(p, speed), limit_says(p, radius));
    let (unbound_speed, unbound_fence) = (p.truth(!has_velocity), p.truth(!has_position));
    let (no_speed, no_fence) = (p.and(speeds, unbound_speed), p.and(fenced, unbound_fence));
    let (bad, unbound) = (p.or(bad_speed, bad_fence), p.or(no_speed, no_fence));
    let fault = p.or(bad, unbound);
    let has_fault = K::gates_has_config_fault(&gates);
    p.exactly("a config fault exactly by 7.2", has_fault, fault);

    let mode = mode(p);
    let (now, last) = (p.scalar("now"), p.optional("last"));
    let position = p.boolean("has_position").then(|| p.vector("position"));
    let still = [p.number(0.0); 3];
    let mut plan = Ticks::<K, P::S> {
        mode,
        ttl: p.number(100.0),
        dt: None,
        ticks: [Some(still), None, None, None],
        steps: 0,
        asked: Asked::default(),
        kernel: std::marker::PhantomData,
    };
    let decision = K::gates_govern(&mut gates, &mut plan, now, last, position);

    // The gates in their order; each is reached only when none before it closed.
    let mut open = p.truth(true);
    let mut gate = |p: &mut P, name, reason, closes: P::B| {
        let here = p.and(open, closes);
        p.exactly(name, decision == reason, here);
        let passes = p.not(closes);
        open = p.and(open, passes);
        here
    };
    let first = p.truth(was_stopped || mode == Mode::Estop);
    gate(p, "gate 1: ESTOP", Decision::Stopped(Reason::Estop), first);
    gate(p, "gate 2: config", Decision::Held(Reason::ConfigFault), fault);
    let stale = {
        let fresh = match last {
            Some(last) => fresh(p, now, last, timeout),
            None => p.truth(false),
        };
        p.not(fresh)
    };
    gate(p, "gate 3: stale", Decision::Held(Reason::StaleSensor), stale);
    let missing = p.truth(position.is_none());
    let missing = p.and(fenced, missing);
    gate(p, "gate 4: no position", Decision::Held(Reason::NoPosition), missing);
    let outside = {
        let inside = match (&position, radius) {
            (Some(position), Some(radius)) => super::words::inside(p, position, radius),
            _ => p.truth(false),
        };
        let outside = p.not(inside);
        p.and(fenced, outside)
    };
    let stops = Decision::Stopped(Reason::OutsideFence);
    let outside = gate(p, "gate 4: outside", stops, outside);
    let inactive = p.truth(mode != Mode::Active);
    gate(p, "gate 5: only active moves", Decision::Held(Reason::NotActive), inactive);

    let latched = p.or(first, outside);
    let is_stopped = K::gates_is_stopped(&gates);
    p.exactly("latches exactly by gates 1 and 4", is_stopped, latched);
    let burst = p.boolean("burst");
    K::gates_note_link(&mut gates, burst);
    let stopped = p.truth(K::gates_is_stopped(&gates) == (is_stopped || burst));
    p.check("a burst latches, and nothing else changes", stopped);
    K::gates_reset(&mut gates);
    let reset = p.truth(!K::gates_is_stopped(&gates) && K::gates_has_config_fault(&gates) == has_fault);
    p.check("a reset clears the latch and not the fault", reset);
}

/// How many steps the horizons of a plant have.
pub(crate) const HORIZONS: [usize; 5] = [0, 1, 2, 3, 8];

/// One event on a plant in any state: the answer and the whole state after it are the model's.
pub fn plant<K: Kernel, P: Prover>(p: &mut P) {
    for start in [K::plant::<P::S, P::Q>(), K::plant_default()] {
        same_state::<K, P>(p, &start, PlantState { watchdog: super::watchdog::empty(), estop: false });
    }
    let watchdog = super::watchdog::any_state(p);
    let before = PlantState { watchdog, estop: p.boolean("was_stopped") };
    let (mut last, mut deadline, mut stopped) = (watchdog.last_seq, watchdog.deadline, before.estop);
    let mut plant = K::plant_in(before);
    match p.choice("event", 4) {
        0 => {
            let mode = mode(p);
            let (now, ttl, seq) = (p.scalar("now"), p.scalar("new_ttl"), p.seq("seq"));
            let answer = K::plant_command(&mut plant, mode, now, ttl, seq);
            match mode {
                Mode::Estop => {
                    stopped = true;
                    let right = p.truth(answer == Received::Stopped);
                    p.check("ESTOP latches whatever its seq", right);
                }
                Mode::Active => {
                    let says = advances(p, last, seq);
                    p.exactly("only what advances counts", answer != Received::Dropped, says);
                    let follows = p.truth(!stopped);
                    let follows = p.and(says, follows);
                    p.exactly("followed unless stopped", answer == Received::Accepted, follows);
                    let right = p.truth(answer != Received::Held);
                    p.check("no active command is answered as a HOLD", right);
                    if answer != Received::Dropped {
                        (last, deadline) = (Some(seq), Some((now, ttl)));
                    }
                }
                Mode::Init | Mode::Hold => {
                    let says = hold_takes_effect(p, last, seq);
                    p.exactly("a HOLD is never ignored", answer == Received::Held, says);
                    let right = p.truth(matches!(answer, Received::Held | Received::Dropped));
                    p.check("a HOLD holds or is dropped", right);
                    if answer == Received::Held {
                        let now = K::plant_state(&plant).watchdog.last_seq;
                        last = super::watchdog::after_hold(p, now, last, seq);
                        deadline = None;
                    }
                }
            }
        }
        1 => {
            let (now, dt, steps) = (p.scalar("now"), p.optional("dt"), p.choice("steps", HORIZONS.len()));
            let steps = HORIZONS.get(steps).copied().unwrap_or_default();
            let answer = K::plant_active(&mut plant, now, dt, steps);
            let lives = match deadline {
                Some((received, ttl)) => alive(p, now, received, ttl),
                None => p.truth(false),
            };
            let has_ticks = match dt {
                Some(dt) if steps > 0 => positive(p, dt),
                _ => p.truth(false),
            };
            let position = match (deadline, dt) {
                (Some((received, _)), Some(dt)) => now.sub(received).mul(p.number(1000.0)).div(dt),
                _ => p.number(0.0),
            };
            #[expect(clippy::cast_precision_loss)]
            let end = p.number(steps as f64 + 1.0);
            let before_end = p.lt(position, end);
            let past_end = {
                let at_end = p.not(before_end);
                p.and(has_ticks, at_end)
            };
            let goes_on = {
                let free = p.truth(!stopped);
                let within = p.not(past_end);
                p.all(&[lives, free, within])
            };
            p.exactly("moves exactly while alive, free and before the end", answer.is_some(), goes_on);
            if let Some(tick) = answer {
                #[expect(clippy::cast_precision_loss)]
                let (from, to) = (p.number(tick as f64), p.number(tick as f64 + 1.0));
                let (begun, unended) = (p.le(from, position), p.lt(position, to));
                let in_tick = p.and(begun, unended);
                let right = p.implies(has_ticks, in_tick);
                p.check("the tick is ⌊age / dt⌋", right);
                let first = p.truth(tick == 0);
                let right = p.or(has_ticks, first);
                p.check("without a horizon it is tick 0", right);
            }
            // Past its end a command is over for good, as when its ttl is.
            let state = K::plant_state(&plant).watchdog;
            let ends = {
                let dead = p.not(lives);
                let free = p.truth(!stopped);
                let over = p.and(past_end, free);
                p.or(dead, over)
            };
            p.exactly("a hold persists", state.deadline.is_none(), ends);
            if state.deadline.is_none() {
                deadline = None;
            }
        }
        2 => {
            K::plant_reset(&mut plant);
            (last, deadline, stopped) = (None, None, false);
        }
        _ => {
            K::plant_stop(&mut plant);
            stopped = true;
        }
    }
    let watchdog = WatchdogState { last_seq: last, deadline };
    same_state::<K, P>(p, &plant, PlantState { watchdog, estop: stopped });
    if stopped || deadline.is_none() {
        let later = p.scalar("later");
        let answer = K::plant_active(&mut plant, later, None, 0);
        let none = p.truth(answer.is_none());
        p.check("nothing moves while stopped or held", none);
    }
}

fn same_state<K: Kernel, P: Prover>(p: &mut P, plant: &K::Plant<P::S, P::Q>, says: PlantState<P::S, P::Q>) {
    for PlantState { watchdog, estop } in [K::plant_state(plant), K::plant_says(plant)] {
        let same = super::words::same_watchdog(p, watchdog, says.watchdog);
        p.check("the state is the model's", same);
        let same = p.truth(estop == says.estop);
        p.check("the latch is the model's", same);
    }
}

/// Every sequence of events at gates with a fence, a speed limit and a clock: ESTOP holds from the event
/// that latches it to the reset, and each command is answered by the first gate that closes.
pub fn sequence<K: Kernel, P: Prover>(p: &mut P) {
    let (ten, timeout, now) = (p.number(10.0), p.number(500.0), p.number(3.0));
    let mut gates = K::gates(Some(ten), Some(ten), timeout);
    let zero = p.number(0.0);
    let home = [zero; 3];
    let away = [p.number(11.0), zero, zero];
    let mut stopped = false;
    for _ in 0..p.length(6) {
        let (mode, last, position) = match p.choice("event", 9) {
            0 => (Mode::Active, Some(now), Some(home)),
            1 => (Mode::Active, Some(now), Some(away)),
            2 => (Mode::Active, Some(now), None),
            3 => (Mode::Active, None, Some(home)),
            4 => (Mode::Hold, Some(now), Some(home)),
            5 => (Mode::Estop, None, None),
            event => {
                match event {
                    6 => {
                        K::gates_note_link(&mut gates, true);
                        stopped = true;
                    }
                    7 => K::gates_note_link(&mut gates, false),
                    _ => {
                        K::gates_reset(&mut gates);
                        stopped = false;
                    }
                }
                continue;
            }
        };
        let mut plan = Ticks::<K, P::S> {
            mode,
            ttl: timeout,
            dt: None,
            ticks: [Some(home), None, None, None],
            steps: 0,
            asked: Asked::default(),
            kernel: std::marker::PhantomData,
        };
        let is_away = position.is_some_and(|_| matches!((mode, last), (Mode::Active, Some(_))))
            && position.map(|[x, ..]| x).is_some_and(|x| !x.le(ten));
        let decision = K::gates_govern(&mut gates, &mut plan, now, last, position);
        let says = if stopped || mode == Mode::Estop {
            Decision::Stopped(Reason::Estop)
        } else if last.is_none() {
            Decision::Held(Reason::StaleSensor)
        } else if position.is_none() {
            Decision::Held(Reason::NoPosition)
        } else if is_away {
            Decision::Stopped(Reason::OutsideFence)
        } else if mode == Mode::Active {
            Decision::Passed
        } else {
            Decision::Held(Reason::NotActive)
        };
        stopped |= matches!(says, Decision::Stopped(_));
        let right = p.truth(decision == says && K::gates_is_stopped(&gates) == stopped);
        p.check("ESTOP holds until the reset", right);
    }
}

/// Every sequence of events at a plant: after an ESTOP nothing moves until a reset, and after that until
/// a new command.
pub fn plant_sequence<K: Kernel, P: Prover>(p: &mut P) {
    let mut plant = K::plant::<P::S, P::Q>();
    let (second, ttl) = (p.number(1.0), p.number(500.0));
    let (mut stopped, mut commanded) = (false, false);
    for _ in 0..p.length(6) {
        match p.choice("event", 5) {
            0 => {
                let seq = p.seq("seq");
                let answer = K::plant_command(&mut plant, Mode::Active, second, ttl, seq);
                commanded |= answer != Received::Dropped;
            }
            1 => {
                let seq = p.seq("seq");
                let answer = K::plant_command(&mut plant, Mode::Hold, second, ttl, seq);
                commanded &= answer != Received::Held;
            }
            2 => {
                let seq = p.seq("seq");
                K::plant_command(&mut plant, Mode::Estop, second, ttl, seq);
                stopped = true;
            }
            3 => {
                let moves = K::plant_active(&mut plant, second, None, 0).is_some();
                let right = p.truth(moves == (commanded && !stopped));
                p.check("moves exactly when commanded and not stopped", right);
            }
            _ => {
                K::plant_reset(&mut plant);
                (stopped, commanded) = (false, false);
            }
        }
    }
}

/// A command with a horizon, and a speed limit or none: what its ticks answer to the limit decides which of them are
/// kept and whether something changed. The ticks answer anything; clamp/tick is about what they answer.
pub fn horizon<K: Kernel, P: Prover>(p: &mut P) {
    let (steps, dt) = (p.choice("steps", 4), p.optional("dt"));
    let speed = p.boolean("has_speed").then(|| p.scalar("speed"));
    let mut answers = [Ok(false); 4];
    for (tick, answer) in answers.iter_mut().enumerate().take(steps + 1) {
        let ways = [Ok(false), Ok(true), Err(Reason::NotFinite), Err(Reason::NoVelocity)];
        let way = p.choice(&format!("answer_{tick}"), ways.len());
        *answer = ways.get(way).copied().unwrap_or(Ok(false));
    }
    let (now, timeout) = (p.number(0.0), p.number(500.0));
    let mut plan = Answers { dt, ttl: timeout, steps, answers, asked: Vec::new(), count: Asked::default() };
    let mut gates = K::gates(speed, None, timeout);
    let decision = K::gates_govern(&mut gates, &mut plan, now, Some(now), None);
    plan.count.ends(p);

    let (enabled, faulty) = limit_says(p, speed);
    p.exactly("a faulty limit holds", decision == Decision::Held(Reason::ConfigFault), faulty);
    let sound = p.not(faulty);
    let has_time = match dt {
        Some(dt) => positive(p, dt),
        None => p.truth(false),
    };
    let is_bad = {
        let (none, with_steps) = (p.not(has_time), p.truth(steps > 0));
        p.all(&[sound, none, with_steps])
    };
    p.exactly("a bad horizon holds", decision == Decision::Held(Reason::BadHorizon), is_bad);

    let first_bad = |answer: &Result<bool, Reason>| answer.is_err();
    let kept = answers.iter().skip(1).take(steps).position(first_bad);
    let kept = kept.unwrap_or(steps);
    let changed = answers.iter().take(kept + 1).any(|answer| *answer == Ok(true));
    let says = match answers[0] {
        Err(reason) => Decision::Held(reason),
        Ok(_) if changed || kept < steps => Decision::Limited,
        Ok(_) => Decision::Passed,
    };
    let good = p.not(is_bad);
    let good = p.and(sound, good);
    let is_held = answers[0].is_err();
    let right = p.truth(decision == says && (is_held || plan.steps == kept));
    let right = p.implies(good, right);
    p.check("ticks are kept up to the first that is not to be used", right);
    if matches!(decision, Decision::Passed | Decision::Limited) {
        for tick in 0..=plan.steps {
            let mut limits = plan.asked.iter().filter(|(asked, _)| *asked == tick);
            let right = match (limits.next(), speed) {
                (Some((_, Limit::Enabled(is))), Some(says)) => {
                    let same = p.same(*is, says);
                    p.and(same, enabled)
                }
                (Some((_, Limit::Disabled)), _) => p.not(enabled),
                _ => p.truth(false),
            };
            p.check("every kept tick was limited as configured", right);
        }
    }
}

/// A command whose ticks answer to the limit as they are told to.
struct Answers<S> {
    dt: Option<S>,
    ttl: S,
    steps: usize,
    answers: [Result<bool, Reason>; 4],
    asked: Vec<(usize, Limit<S>)>,
    count: Asked,
}

impl<S: Scalar> Plan<S> for Answers<S> {
    fn mode(&self) -> Mode {
        Mode::Active
    }
    fn ttl_ms(&self) -> S {
        self.ttl
    }
    fn dt_ms(&self) -> Option<S> {
        self.dt
    }
    fn steps(&self) -> usize {
        if self.count.again() { self.steps } else { 0 }
    }
    fn limit(&mut self, tick: usize, max_mps: Limit<S>) -> Result<bool, Reason> {
        self.asked.push((tick, max_mps));
        self.answers.get(tick).copied().unwrap_or(Ok(false))
    }
    fn velocity(&self, _tick: usize) -> Option<[S; 3]> {
        None
    }
    fn truncate(&mut self, steps: usize) {
        self.steps = self.steps.min(steps);
    }
}
