//! That something happens at last: the loop goes on after every HOLD, and a healthy link clears a burst.
//!
//! The loop, its governor and its link monitor are those of the specification. What surrounds them may do anything of
//! a list at any time. Of the state only what can decide is kept: seqs and times as differences from the newest, and
//! no counts (`link/relative` shows that these decide nothing).

use std::collections::{BTreeMap, BTreeSet, VecDeque};

use ncp_spec::safety::{Decision, Reason};
use ncp_spec::wire::{ChannelMap, ChannelValue, CommandFrame, Mode, SafetyLimits, SensorFrame};

use crate::engine::{Case, Counterexample, Harness, Outcome, PANICS, every};
use crate::spies::Scripted;
use crate::subject::{Governor, Link, LinkState, Loop, LoopParts};

/// The harness of a claim.
#[must_use]
pub fn run<L: Loop<Governor: Governor, Link: Link>>(id: &str) -> Option<Harness> {
    match id {
        "liveness/hold" => Some(|_| Graph::<L>::explored().holds_end()),
        "liveness/fair" => Some(|_| Graph::<L>::explored().no_fair_cycle()),
        "liveness/burst" => Some(|scope| every(scope, burst::<L::Link>)),
        _ => None,
    }
}

/// From every listed S, and for other configurations from the largest: so many deliveries end a burst.
fn burst<L: Link>(c: &mut Case) {
    let (ref_loss, threshold): (f64, f64) =
        *c.pick("ref_loss and threshold", &[(0.25, 1.0), (0.0625, 2.0), (0.05, 5.0), (0.99, 5.0), (0.01, 100.0)]);
    let most = 2.0 * threshold;
    let is_exact = ref_loss == 0.25 || ref_loss == 0.0625;
    #[expect(clippy::cast_precision_loss, reason = "it is small")]
    let s = if is_exact { c.below("S in 16ths", (most * 16.0) as usize + 1) as f64 / 16.0 } else { most };
    let state =
        LinkState { ref_loss, threshold, seen: Some((0, 0)), received: 1, lost: 0, missing: BTreeSet::new(), cusum: s };
    let mut monitor = L::of(state);
    let deliveries = (threshold / ref_loss).ceil() as i64 + 1;
    let mut last = s;
    for seq in 1..=deliveries {
        monitor.on_frame(seq);
        let LinkState { cusum, .. } = monitor.state();
        c.check("each delivery lowers S, or it is 0", cusum < last || cusum.to_bits() == 0);
        last = cusum;
    }
    c.check("no burst after ⌈threshold / ref_loss⌉ + 1 deliveries", !monitor.burst());
}

/// What may happen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
enum Event {
    /// A quarter of a second passes.
    Time,
    /// A sensor frame arrives that is newer by so many, and sees the plant somewhere.
    Sensor(i64, Place),
    /// The newest frame arrives again, from elsewhere.
    Duplicate,
    /// A frame arrives that was missing.
    Late,
    /// A tick with a command.
    Tick(Wish),
    /// A good sensor frame, and a tick with a good command at once.
    Good,
    /// A supervisor's reset.
    Reset,
}

/// Where a sensor sees the plant, within a fence of 10 m.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
enum Place {
    Inside,
    Outside,
    Nowhere,
}

/// What the controller commands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
enum Wish {
    Good,
    Init,
    NotFinite,
    NoVelocity,
    BadHorizon,
    LeavesFence,
    Estop,
}

use Event::{Duplicate, Good, Late, Reset, Sensor, Tick, Time};

const EVENTS: [Event; 17] = [
    Time,
    Sensor(1, Place::Inside),
    Sensor(1, Place::Outside),
    Sensor(1, Place::Nowhere),
    Sensor(2, Place::Inside),
    Sensor(5, Place::Inside),
    Duplicate,
    Late,
    Tick(Wish::Good),
    Tick(Wish::Init),
    Tick(Wish::NotFinite),
    Tick(Wish::NoVelocity),
    Tick(Wish::BadHorizon),
    Tick(Wish::LeavesFence),
    Tick(Wish::Estop),
    Good,
    Reset,
];
/// The reasons of a HOLD that ends.
const HOLDS: [Reason; 7] = [
    Reason::StaleSensor,
    Reason::NoPosition,
    Reason::NotActive,
    Reason::NotFinite,
    Reason::NoVelocity,
    Reason::BadHorizon,
    Reason::LeavesFence,
];
/// A loop with more states than these is no finite one.
const MOST: usize = 4_000;
/// Deliveries that end a burst: threshold / ref_loss, and one more.
const DELIVERIES: usize = 5;
const QUARTER: f64 = 0.25;
/// A sensor is stale after 500 ms; older than this is as old.
const OLDEST: f64 = 0.75;

impl Event {
    /// Whether it may latch ESTOP: at last, such things stay away.
    fn is_cause(self) -> bool {
        matches!(self, Sensor(_, Place::Outside) | Sensor(2.., _) | Tick(Wish::Estop))
    }
}

type Parts<L> = LoopParts<<L as Loop>::Governor, <L as Loop>::Link>;

/// An edge of the graph: what happened, what a tick decided, and where that led.
struct Edge {
    event: Event,
    decision: Option<Decision>,
    to: usize,
}

/// All states of a loop, with what may happen in each.
struct Graph<L: Loop> {
    states: Vec<Parts<L>>,
    is_faulty: Vec<bool>,
    edges: Vec<Vec<Edge>>,
    /// By which event each state was reached first.
    from: Vec<Option<(usize, Event)>>,
    outcome: Outcome,
}

impl<L: Loop<Governor: Governor, Link: Link>> Graph<L> {
    fn explored() -> Self {
        let mut graph =
            Self { states: vec![], is_faulty: vec![], edges: vec![], from: vec![], outcome: Outcome::default() };
        let explored = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| graph.explore()));
        if explored.is_err() {
            graph.refute(PANICS, graph.states.len().saturating_sub(1), &[]);
        }
        graph
    }

    fn explore(&mut self) {
        let mut places = BTreeMap::new();
        let mut queue = VecDeque::new();
        for is_faulty in [false, true] {
            let parts = normal::<L>(start::<L>(is_faulty));
            places.insert(key::<L>(&parts, is_faulty), self.states.len());
            queue.push_back(self.states.len());
            self.add(parts, is_faulty, None);
        }
        while let Some(at) = queue.pop_front() {
            for event in EVENTS {
                let (decision, parts) = after::<L>(&self.states[at], event);
                self.outcome.cases += 1;
                let is_faulty = self.is_faulty[at];
                let parts = normal::<L>(parts);
                let to = *places.entry(key::<L>(&parts, is_faulty)).or_insert(self.states.len());
                if to == self.states.len() {
                    queue.push_back(to);
                    self.add(parts, is_faulty, Some((at, event)));
                }
                self.edges[at].push(Edge { event, decision, to });
            }
            if self.states.len() > MOST {
                return;
            }
        }
    }

    fn add(&mut self, parts: Parts<L>, is_faulty: bool, from: Option<(usize, Event)>) {
        self.states.push(parts);
        self.is_faulty.push(is_faulty);
        self.edges.push(vec![]);
        self.from.push(from);
    }

    /// From every state: a HOLD ends with the next good frame and command; after a healthy link and a reset, all does.
    fn holds_end(mut self) -> Outcome {
        self.is_finite();
        let mut seen = BTreeSet::new();
        for at in 0..self.states.len() {
            for Edge { event, decision, to } in std::mem::take(&mut self.edges[at]) {
                if let Some(Decision::Held(reason)) = decision
                    && !self.is_faulty[at]
                {
                    seen.insert(format!("{reason:?}"));
                    let passes = self.ends(to, &[Good]);
                    self.say(
                        "a HOLD that is no config fault ends with the next good frame and command",
                        passes,
                        at,
                        &[event, Good],
                    );
                }
                if self.is_faulty[at] {
                    let is_held = decision.is_none_or(|decision| !is_passed(decision));
                    self.say("a config fault lets nothing pass", is_held, at, &[event]);
                }
            }
            if !self.is_faulty[at] {
                let healthy = [&[Sensor(1, Place::Inside); DELIVERIES][..], &[Reset, Good]].concat();
                let passes = self.ends(at, &healthy);
                self.say("a healthy link, a reset and a good command move the plant again", passes, at, &healthy);
            }
        }
        let all = HOLDS.iter().all(|reason| seen.contains(&format!("{reason:?}")));
        self.say("every HOLD of the gates happens", all, 0, &[]);
        self.finished()
    }

    /// In no cycle a good frame comes with a good command, and a reset comes, again and again, without a command that
    /// passes, once that has ended which latches ESTOP.
    fn no_fair_cycle(mut self) -> Outcome {
        self.is_finite();
        let is_silent = |edge: &Edge| !edge.event.is_cause() && edge.decision.is_none_or(|one| !is_passed(one));
        let silent: Vec<Vec<(Event, usize)>> = self
            .edges
            .iter()
            .zip(&self.is_faulty)
            .map(|(edges, is_faulty)| {
                let edges = edges.iter().filter(|edge| is_silent(edge) && !is_faulty);
                edges.map(|edge| (edge.event, edge.to)).collect()
            })
            .collect();
        let component = components(&silent);
        let mut within: BTreeMap<usize, BTreeSet<&str>> = BTreeMap::new();
        let mut cycles = 0;
        for (at, edges) in silent.iter().enumerate() {
            for (event, _) in edges.iter().filter(|(_, to)| component[*to] == component[at]) {
                cycles += 1;
                within.entry(component[at]).or_default().extend(match event {
                    Good => Some("good"),
                    Reset => Some("reset"),
                    _ => None,
                });
            }
        }
        self.say("some cycle passes nothing, so that there is something to show", cycles > 0, 0, &[]);
        for (at, own) in component.iter().enumerate() {
            let is_fair = within.get(own).is_some_and(|events| events.len() == 2);
            self.say("no fair cycle passes nothing", !is_fair, at, &[]);
        }
        // Without the fairness there is one: nobody resets a latched ESTOP.
        let unfair = within.values().any(|events| events.contains("good"));
        self.say("without a reset there is a cycle", unfair, 0, &[]);
        self.finished()
    }

    fn is_finite(&mut self) {
        let is_finite = self.states.len() <= MOST;
        self.say("the states are finitely many", is_finite, self.states.len() - 1, &[]);
    }

    /// Whether these events end in a command that passes.
    fn ends(&self, at: usize, events: &[Event]) -> bool {
        let mut parts = self.states[at].clone();
        let mut last = None;
        for event in events {
            (last, parts) = after::<L>(&parts, *event);
            parts = normal::<L>(parts);
        }
        last.is_some_and(is_passed)
    }

    fn say(&mut self, check: &'static str, holds: bool, at: usize, then: &[Event]) {
        *self.outcome.reached.entry(check).or_default() += 1;
        if !holds && self.outcome.counterexample.is_none() {
            self.refute(check, at, then);
        }
    }

    fn refute(&mut self, check: &'static str, at: usize, then: &[Event]) {
        let mut path: Vec<Event> = then.iter().rev().copied().collect();
        let mut here = at;
        while let Some(Some((from, event))) = self.from.get(here) {
            path.push(*event);
            here = *from;
        }
        let events = path.iter().rev().map(|event| ("event".to_owned(), format!("{event:?}")));
        self.outcome.counterexample = Some(Counterexample { check, picked: events.collect() });
    }

    fn finished(self) -> Outcome {
        Outcome { detail: format!("{} states", self.states.len()), ..self.outcome }
    }
}

fn is_passed(decision: Decision) -> bool {
    matches!(decision, Decision::Passed | Decision::Limited)
}

/// A loop that has not ticked, with good limits or one that is none.
fn start<L: Loop<Governor: Governor, Link: Link>>(is_faulty: bool) -> Parts<L> {
    let limits = SafetyLimits {
        max_speed_mps: Some(if is_faulty { -1.0 } else { 2.0 }),
        geofence_radius_m: Some(10.0),
        command_timeout_ms: 500.0,
        ..SafetyLimits::default()
    };
    LoopParts {
        controller: Scripted::default(),
        governor: L::Governor::new(&limits),
        link: L::Link::new(0.25, 1.0),
        period_ms: 100.0,
        newest: None,
        ticks: 0,
        t: 0.0,
    }
}

/// What an event makes of a loop at time 0, and what a tick decides.
fn after<L: Loop<Governor: Governor, Link: Link>>(parts: &Parts<L>, event: Event) -> (Option<Decision>, Parts<L>) {
    let mut parts = parts.clone();
    let newest = parts.newest.as_ref().map_or(0, |(frame, _)| frame.seq);
    if event == Time {
        if let Some((_, received_s)) = &mut parts.newest {
            *received_s -= QUARTER;
        }
        return (None, parts);
    }
    if parts.newest.is_none() && matches!(event, Duplicate | Late) {
        return (None, parts);
    }
    if event == Late {
        let mut state = parts.link.state();
        state.missing.insert(newest - 1);
        parts.link = L::Link::of(state);
    }
    if let Tick(wish) = event {
        parts.controller.answer = command(wish);
    } else if event == Good {
        parts.controller.answer = command(Wish::Good);
    }
    let mut looped = L::of(parts);
    let mut decision = None;
    match event {
        Sensor(by, place) => drop(looped.on_sensor(sensor(newest + by, place), 0.0)),
        Duplicate => drop(looped.on_sensor(sensor(newest, Place::Outside), 0.0)),
        Late => drop(looped.on_sensor(sensor(newest - 1, Place::Outside), 0.0)),
        Tick(_) => decision = Some(looped.tick(0.0, 0.0).decision),
        Good => {
            looped.on_sensor(sensor(newest + 1, Place::Inside), 0.0);
            decision = Some(looped.tick(0.0, 0.0).decision);
        }
        Reset => looped.reset(),
        Time => {}
    }
    (decision, looped.parts())
}

/// The same loop with the newest seq at 1,000, without counts, and with no sensor older than need be.
fn normal<L: Loop<Governor: Governor, Link: Link>>(mut parts: Parts<L>) -> Parts<L> {
    const NEWEST: i64 = 1_000;
    parts.controller = Scripted::default();
    (parts.ticks, parts.t) = (0, 0.0);
    if let Some((frame, received_s)) = &mut parts.newest {
        frame.seq = NEWEST;
        *received_s = received_s.max(-OLDEST);
    }
    let mut state = parts.link.state();
    state.seen = state.seen.map(|_| (NEWEST - 10, NEWEST));
    (state.received, state.lost) = (0, 0);
    state.missing.clear();
    parts.link = L::Link::of(state);
    parts
}

/// A state by its words.
fn key<L: Loop<Governor: Governor, Link: Link>>(parts: &Parts<L>, is_faulty: bool) -> String {
    let LoopParts { controller: _, governor, link, period_ms, newest, ticks, t } = parts;
    format!("{is_faulty} {governor:?} {link:?} {period_ms} {newest:?} {ticks} {t}")
}

fn sensor(seq: i64, place: Place) -> SensorFrame {
    let position = |x_m: f64| ChannelMap::from_iter([("pose_position", ChannelValue::new([x_m, 0.0, 0.0], "m"))]);
    let channels = match place {
        Place::Inside => position(0.0),
        Place::Outside => position(11.0),
        Place::Nowhere => ChannelMap::new(),
    };
    SensorFrame { seq, channels, ..SensorFrame::default() }
}

fn command(wish: Wish) -> CommandFrame {
    let velocity = |x: f64| ChannelMap::from_iter([("velocity_setpoint", ChannelValue::new([x, 0.0, 0.0], "m/s"))]);
    let good = CommandFrame { channels: velocity(0.5), mode: Mode::Active, ttl_ms: 500.0, ..CommandFrame::default() };
    match wish {
        Wish::Good => good,
        Wish::Init => CommandFrame { mode: Mode::Init, ..good },
        Wish::NotFinite => CommandFrame { channels: velocity(f64::NAN), ..good },
        Wish::NoVelocity => CommandFrame { channels: ChannelMap::new(), ..good },
        Wish::BadHorizon => CommandFrame { horizon: vec![velocity(0.5)], horizon_dt_ms: None, ..good },
        Wish::LeavesFence => CommandFrame { ttl_ms: 60_000.0, channels: velocity(2.0), ..good },
        Wish::Estop => CommandFrame { mode: Mode::Estop, ..good },
    }
}

/// The strongly connected component of each place, by Kosaraju's method.
fn components(edges: &[Vec<(Event, usize)>]) -> Vec<usize> {
    let mut back = vec![vec![]; edges.len()];
    let ahead: Vec<Vec<usize>> = edges.iter().map(|edges| edges.iter().map(|(_, to)| *to).collect()).collect();
    for (at, edges) in ahead.iter().enumerate() {
        edges.iter().for_each(|to| back[*to].push(at));
    }
    let mut order = vec![];
    let mut done = vec![false; edges.len()];
    for root in 0..edges.len() {
        visit(&ahead, root, &mut done, &mut order);
    }
    let mut component = vec![0; edges.len()];
    let mut done = vec![false; edges.len()];
    for root in order.into_iter().rev() {
        let mut mine = vec![];
        visit(&back, root, &mut done, &mut mine);
        mine.into_iter().for_each(|at| component[at] = root);
    }
    component
}

/// Notes all places that are reached from one and not done, each behind those that it leads to.
fn visit(edges: &[Vec<usize>], root: usize, done: &mut [bool], order: &mut Vec<usize>) {
    if std::mem::replace(&mut done[root], true) {
        return;
    }
    let mut stack = vec![(root, 0)];
    while let Some((at, nth)) = stack.pop() {
        match edges[at].get(nth) {
            None => order.push(at),
            Some(to) => {
                stack.push((at, nth + 1));
                if !std::mem::replace(&mut done[*to], true) {
                    stack.push((*to, 0));
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_component_is_what_leads_to_itself_and_back() {
        let edge = |to| (Time, to);
        let component = components(&[vec![edge(1)], vec![edge(2)], vec![edge(1), edge(3)], vec![]]);
        assert_eq!(component[1], component[2]);
        assert!(component[0] != component[1] && component[3] != component[1] && component[0] != component[3]);
    }
}
