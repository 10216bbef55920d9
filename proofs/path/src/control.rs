//! The control loop between any controller, any governor and any link monitor: which time, which frame, in which order.

use ncp_spec::safety::{Decision, Reason};
use ncp_spec::wire::{ChannelMap, ChannelValue, CommandFrame, Mode, SensorFrame, Text};

use crate::engine::{Case, Harness, every};
use crate::spies::{Asked, LinkMonitor, Log, SafetyGovernor, Scripted};
use crate::subject::{Loop, LoopParts};

/// The harness of a claim.
#[must_use]
pub fn run<L: Loop<Governor = SafetyGovernor, Link = LinkMonitor>>(id: &str) -> Option<Harness> {
    match id {
        "loop/start" => Some(|scope| every(scope, start::<L>)),
        "loop/sensor" => Some(|scope| every(scope, sensor::<L>)),
        "loop/tick" => Some(|scope| every(scope, tick::<L>)),
        "loop/frame" => Some(|scope| every(scope, frame::<L>)),
        _ => None,
    }
}

/// The loop starts exactly with a period that is finite and positive, and knows nothing then.
fn start<L: Loop<Governor = SafetyGovernor, Link = LinkMonitor>>(c: &mut Case) {
    let numbers = [10.0, 5e-324, f64::MAX, 0.0, -0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    let period_ms = *c.pick("period_ms", &numbers);
    let log = Log::default();
    let started = L::new(period_ms, governor(&log, None), LinkMonitor { burst: false, log: log.clone() });
    // [NCP-CTRL-010]
    c.check("refused without a period", started.is_some() == (period_ms.is_finite() && period_ms > 0.0));
    if let Some(LoopParts { newest, ticks, t, period_ms: period, .. }) = started.map(|started| started.parts()) {
        let is_new = newest.is_none() && ticks == 0 && t.to_bits() == 0 && period.to_bits() == period_ms.to_bits();
        c.check("knows nothing at first", is_new);
    }
}

/// From any kept frame of these, any frame that arrives: the newest by seq, or by t, is kept with its time.
fn sensor<L: Loop<Governor = SafetyGovernor, Link = LinkMonitor>>(c: &mut Case) {
    const SEQS: [i64; 8] = [0, 1, 2, 7, -1, i64::MIN, i64::MAX - 1, i64::MAX];
    const TIMES: [f64; 5] = [0.0, 1.0, 1.5, -2.0, f64::MAX];
    let log = Log::default();
    let mut parts = parts(&log, None);
    parts.newest = c.either("a frame is kept").then(|| {
        let (seq, t) = (*c.pick("its seq", &SEQS), *c.pick("its t", &TIMES));
        (stamped(seq, t, "kept"), *c.pick("received at", &[0.25, 9.0, f64::NAN]))
    });
    let arrives = stamped(*c.pick("seq", &SEQS), *c.pick("t", &TIMES), "arrives");
    let now_s = *c.pick("now", &[0.5, 8.0, f64::INFINITY, f64::NAN]);
    let mut looped = L::of(parts.clone());
    let was_taken = looped.on_sensor(arrives.clone(), now_s);
    let after = looped.parts();
    let kept =
        |parts: &LoopParts<_, _>| parts.newest.clone().map(|(frame, at): (SensorFrame, f64)| (frame, at.to_bits()));
    // [NCP-RES-053] The monitor sees every frame, stamped or not, whether it is taken or not.
    c.check("the monitor sees the frame", *log.borrow() == [Asked::Arrived(arrives.seq)]);
    // [NCP-CTRL-011] Streams in which stamped and unstamped frames alternate are left open.
    let is_newer = match &parts.newest {
        None => Some(true),
        Some((kept, _)) if kept.seq != 0 && arrives.seq != 0 => Some(kept.seq < arrives.seq),
        Some((kept, _)) if kept.seq == 0 && arrives.seq == 0 => Some(kept.t < arrives.t),
        Some(_) => None,
    };
    if let Some(is_newer) = is_newer {
        c.check("taken exactly when it is newer", was_taken == is_newer);
    }
    // [NCP-CTRL-012]
    let says = if was_taken { Some((arrives, now_s.to_bits())) } else { kept(&parts) };
    c.check("the frame and its time are those of one arrival", kept(&after) == says);
    c.check("nothing else changes", after.ticks == parts.ticks && after.t.to_bits() == parts.t.to_bits());
}

/// From any kept frame, any command of the controller, any answer of the governor: what a tick asks, and what it sends.
fn tick<L: Loop<Governor = SafetyGovernor, Link = LinkMonitor>>(c: &mut Case) {
    const PERIODS: [f64; 3] = [10.0, 5e-324, f64::MAX];
    let log = Log::default();
    let (mode, left) = (*c.pick("the controller's mode", Mode::KNOWN), *c.pick("the governor leaves", &LEFT));
    let period_ms = *c.pick("period_ms", &PERIODS);
    let twice = 2.0 * period_ms;
    let ttls = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -5.0, 0.0, period_ms, twice.next_down(), twice, 1e9];
    let ttl_ms = *c.pick("ttl_ms", &ttls);
    let now_s = *c.pick("now", &[2.5, f64::NAN, f64::INFINITY]);
    let took_ms = *c.pick("the tick before took", &[0.0, period_ms, period_ms.next_up(), f64::NAN]);
    let newest = *c.pick("the kept frame's seq", &[None, Some(0), Some(41), Some(-3), Some(i64::MAX)]);
    let burst = c.either("burst");
    let ticks = *c.pick("ticks", &[0, 7, i64::MAX]);

    let wished = CommandFrame { mode, ttl_ms, ..command(99, 77.0) };
    let leaves = left.map(|mode| CommandFrame { mode, ttl_ms: 123.0, ..command(55, 66.0) });
    let newest = newest.map(|seq| (stamped(seq, 3.0, "kept"), 1.25));
    let before = LoopParts {
        controller: Scripted { answer: wished, log: log.clone() },
        link: LinkMonitor { burst, log: log.clone() },
        governor: governor(&log, leaves.clone()),
        period_ms,
        newest: newest.clone(),
        ticks,
        t: 0.5,
    };
    let mut looped = L::of(before);
    let sent = looped.tick(now_s, took_ms);
    let after = looped.parts();

    let asked = log.borrow();
    let governed: Vec<_> = asked.iter().filter(|asked| matches!(asked, Asked::Govern { .. })).collect();
    let frame = newest.as_ref().map(|(frame, _)| frame.clone());
    let [Asked::Govern { command, now_s: told_s, sensor, last_s }] = governed.as_slice() else {
        c.check("governed exactly once", false);
        return;
    };
    let step = Asked::Step { now_s: now_s.to_bits(), sensor: frame.clone() };
    c.check("the controller is asked once, for the kept frame", count(&asked, &step) == 1);
    let steps = asked.iter().filter(|asked| matches!(asked, Asked::Step { .. })).count();
    c.check("the controller is asked no more", steps == 1);
    // [NCP-CTRL-016]
    let at = |asked: &[Asked], what: &Asked| asked.iter().position(|one| one == what);
    let links = asked.iter().filter(|asked| matches!(asked, Asked::Link(_))).count();
    let before_it = at(&asked, &Asked::Link(burst)) < asked.iter().position(|one| matches!(one, Asked::Govern { .. }));
    c.check("told of the link, then asked", links == 1 && at(&asked, &Asked::Link(burst)).is_some() && before_it);
    // [NCP-CTRL-015] Which time, which frame.
    c.check("governed at the tick's time", *told_s == now_s.to_bits());
    c.check("governed by the kept frame", *sensor == frame);
    let received = newest.as_ref().map(|(_, at)| at.to_bits());
    c.check("governed by the time at which that frame was received", *last_s == received);
    // [NCP-CTRL-013]
    c.check("the seq is the kept frame's", command.seq == frame.as_ref().map_or(0, |frame| frame.seq));
    // [NCP-CTRL-014]
    let least = if twice.is_finite() { twice } else { f64::MAX };
    c.check("governed with at least two periods", command.ttl_ms.is_finite() && command.ttl_ms >= least);
    if ttl_ms.is_finite() && ttl_ms >= least {
        c.check("a longer ttl stays", command.ttl_ms.to_bits() == ttl_ms.to_bits());
    }
    c.check("the mode is the controller's", command.mode == mode);
    // [NCP-CTRL-015]
    let answer = leaves.unwrap_or_else(|| command.clone());
    c.check("what the governor leaves is sent", sent.command == answer && sent.decision == DECIDES);
    // [NCP-CTRL-017]
    c.check("a counter of its own", sent.status.seq == ticks.saturating_add(1) && after.ticks == sent.status.seq);
    c.check("the status has the mode that was sent", sent.status.mode == sent.command.mode);
    let is_latency = sent.status.loop_latency_ms.to_bits() == took_ms.to_bits();
    c.check("the status has the measured latency", is_latency || !took_ms.is_finite());
    // [NCP-CTRL-018] [NCP-CTRL-021]
    if mode == Mode::Active {
        c.check("safety_ok exactly when it stays active", sent.status.safety_ok == (answer.mode == Mode::Active));
    }
    // [NCP-CTRL-019]
    c.check("a note when the tick before overran", sent.status.note.is_some() == (took_ms > period_ms));
    let kept = |newest: Option<(SensorFrame, f64)>| newest.map(|(frame, at)| (frame, at.to_bits()));
    let stays = kept(after.newest) == kept(newest) && after.period_ms.to_bits() == period_ms.to_bits();
    c.check("the kept frame, its time and the period stay", stays);
    let t = if now_s.is_finite() { now_s } else { 0.5 };
    c.check("t is the last finite time", after.t.to_bits() == t.to_bits() && command.t.to_bits() == t.to_bits());
}

/// All else of the controller's command reaches the governor, but what no frame holds.
fn frame<L: Loop<Governor = SafetyGovernor, Link = LinkMonitor>>(c: &mut Case) {
    let log = Log::default();
    let mut before = parts(&log, None);
    let dt_ms = *c.pick("dt_ms", &[None, Some(20.0), Some(-1.0), Some(f64::NAN), Some(f64::INFINITY)]);
    let steps = *c.pick("steps", &[0, 1, 3, 4_096, 4_097]);
    let step = |nth: usize| channels(&[("step", &[nth as f64])]);
    let wished = CommandFrame {
        horizon_dt_ms: dt_ms,
        horizon: (0..steps).map(step).collect(),
        frame_id: Text::Borrowed("elsewhere"),
        channels: channels(&[("a", &[1.0]), ("velocity_setpoint", &[f64::NAN, 0.0, 2.0])]),
        ..command(1, 2.0)
    };
    before.controller.answer = wished.clone();
    let mut looped = L::of(before);
    let _ = looped.tick(1.0, 0.0);
    let asked = log.borrow();
    let Some(Asked::Govern { command, .. }) = asked.iter().find(|asked| matches!(asked, Asked::Govern { .. })) else {
        c.check("governed", false);
        return;
    };
    c.check("governed", true);
    c.check("the steps in their order", command.horizon.iter().eq(wished.horizon.iter().take(4_096)));
    c.check("dt, unless no frame holds it", command.horizon_dt_ms == dt_ms.filter(|dt_ms| dt_ms.is_finite()));
    // NaN is not itself: the bits are.
    let spelled = |channels: &ChannelMap| format!("{channels:?}");
    c.check("the channels as they are", spelled(&command.channels) == spelled(&wished.channels));
    c.check("the frame_id as it is", command.frame_id == wished.frame_id);
}

/// What a governor may make of a command; none: nothing.
const LEFT: [Option<Mode>; 4] = [None, Some(Mode::Active), Some(Mode::Hold), Some(Mode::Estop)];
const DECIDES: Decision = Decision::Held(Reason::BadHorizon);

fn governor(log: &Log, leaves: Option<CommandFrame>) -> SafetyGovernor {
    SafetyGovernor { leaves, decides: DECIDES, log: log.clone() }
}

fn parts(log: &Log, leaves: Option<CommandFrame>) -> LoopParts<SafetyGovernor, LinkMonitor> {
    LoopParts {
        controller: Scripted { log: log.clone(), ..Scripted::default() },
        governor: governor(log, leaves),
        link: LinkMonitor { burst: false, log: log.clone() },
        period_ms: 10.0,
        newest: None,
        ticks: 3,
        t: 0.5,
    }
}

fn stamped(seq: i64, t: f64, name: &'static str) -> SensorFrame {
    SensorFrame { seq, t, channels: channels(&[(name, &[1.0])]), ..SensorFrame::default() }
}

fn command(seq: i64, t: f64) -> CommandFrame {
    CommandFrame { seq, t, mode: Mode::Active, ttl_ms: 500.0, ..CommandFrame::default() }
}

fn channels(named: &[(&'static str, &[f64])]) -> ChannelMap {
    named.iter().map(|(name, data)| (*name, ChannelValue::without_unit(*data))).collect()
}

fn count(asked: &[Asked], what: &Asked) -> usize {
    asked.iter().filter(|one| *one == what).count()
}
