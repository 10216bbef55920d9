//! Whoever obeys commands: what a plant does is read from its sensor stream.

use std::time::{Duration, Instant};

use ncp_spec::wire::{ChannelMap, ChannelValue, CommandFrame, Frame, SensorFrame};
use ncp_zenoh::{Bus, BusError, CommandPublisher, Intake, Perception};
use serde_json::{Map, Value};

use super::{PATIENCE, first_seq, until};
use crate::LiveError;
use crate::scenario::{Motion, Step};
use crate::target::{Mapping, Noise, Target};
use crate::verdict::{Measured, Rulings};

/// How long a plant may take to react, on the slowest machine; what is about time is measured by itself.
const REACTION: Duration = Duration::from_secs(2);

/// How late a machine may wake the judge before what it did not see says nothing.
const NOISY_MS: f64 = 500.0;

/// Carries out the steps of a scenario, in their order.
pub(super) fn steps(
    bus: &Bus,
    target: &Target,
    steps: &[Step],
    noise: &Noise,
    rulings: &mut Rulings,
) -> Result<(), LiveError> {
    let Some(plant) = Plant::meet(bus, target, rulings)? else { return Ok(()) };
    let base = first_seq();
    for (number, step) in (1..).zip(steps) {
        let (frame, (motion, for_ms, rule)) = match step {
            Step::Ask { .. } => continue,
            Step::Command { command, plant, for_ms, rule } => {
                (Some(frame(&target.mapping, base, command)), (*plant, *for_ms, rule))
            }
            Step::Raw { raw, plant, for_ms, rule } => (Some(raw.clone()), (*plant, *for_ms, rule)),
            Step::Look { plant, for_ms, rule } => (None, (*plant, *for_ms, rule)),
        };
        if let Some(frame) = frame {
            plant.commands.stream().send_bytes(frame)?;
        }
        noise.worst_ms();
        let moves = motion == Motion::Moves;
        let lasting = Duration::from_millis(for_ms);
        let reaction = match motion {
            Motion::Still => plant.stays(false, Instant::now(), lasting),
            _ => plant.comes_to(moves, lasting),
        };
        match reaction {
            Reaction::Stays => rulings.observe(rule, true, String::new),
            Reaction::Silent => rulings.unclear(rule, "the plant's sensor stream fell silent"),
            _ if noise.worst_ms() > NOISY_MS => rulings.unclear(rule, "this machine is too noisy to tell"),
            Reaction::Never => rulings.fail(rule, format!("step {number}: the plant never {}", verb(moves))),
            Reaction::Leaves(after) => {
                let why = format!("step {number}: the plant {} for {after:?} only, not for {for_ms} ms", verb(moves));
                rulings.fail(rule, why);
            }
        }
    }
    Ok(())
}

/// How long a command moves the plant, by the plant's own clock and by the judge's.
pub(super) fn expiry(bus: &Bus, target: &Target, noise: &Noise, rulings: &mut Rulings) -> Result<(), LiveError> {
    const TTL_MS: f64 = 400.0;
    const TIMES: usize = 5;
    let Some(plant) = Plant::meet(bus, target, rulings)? else { return Ok(()) };
    let (mut moved_ms, mut seen_ms, mut period_ms) = (Vec::new(), Vec::new(), 0.0_f64);
    let mut worst_ms = 0.0_f64;
    for seq in (first_seq()..).take(TIMES) {
        noise.worst_ms();
        plant.drain();
        let sent = Instant::now();
        plant.commands.send(&moving(&target.mapping, seq, TTL_MS))?;
        let (mut began, mut last, mut before) = (None, None, None::<f64>);
        // As long as it moves, up to three times as long as it may.
        while sent.elapsed().as_secs_f64() * 1e3 < 3.0 * TTL_MS + 200.0 {
            let Some((at, t, moves)) = plant.next(Duration::from_millis(500)) else { break };
            if let Some(before) = before {
                period_ms = period_ms.max((t - before) * 1e3);
            }
            before = Some(t);
            if moves {
                began.get_or_insert(t);
                last = Some((at, t));
            } else if last.is_some() {
                break;
            }
        }
        worst_ms = worst_ms.max(noise.worst_ms());
        if let (Some(began), Some((at, t))) = (began, last) {
            moved_ms.push((t - began) * 1e3);
            seen_ms.push(at.saturating_duration_since(sent).as_secs_f64() * 1e3);
        }
        if !matches!(plant.comes_to(false, Duration::ZERO), Reaction::Stays) {
            rulings.fail(
                "NCP-RES-002",
                format!("a command with a ttl of {TTL_MS} ms still moves the plant after {REACTION:?} more"),
            );
            return Ok(());
        }
    }
    let tolerance_ms = target.mapping.tolerance_ms + 2.0 * period_ms;
    let moved = Measured::of(moved_ms, tolerance_ms);
    let seen = Measured::of(seen_ms, tolerance_ms + worst_ms);
    for (rule, measured) in [("NCP-RES-001", seen), ("NCP-RES-002", moved), ("NCP-RES-013", moved)] {
        rulings.measured(rule, measured);
    }
    let (Some(moved), Some(seen)) = (moved, seen) else {
        rulings.all_unclear("the plant never moved on an active command");
        return Ok(());
    };
    if moved.count < 3 || tolerance_ms + worst_ms > TTL_MS / 2.0 {
        rulings.all_unclear("this machine is too noisy to tell");
        return Ok(());
    }
    // The middle one: a single pause of the plant is no decision of it.
    let too_long = |measured: Measured| measured.median_ms > TTL_MS + measured.tolerance_ms;
    rulings.observe("NCP-RES-002", !too_long(moved), || format!("a ttl of {TTL_MS} ms moves it for {moved}"));
    rulings.observe("NCP-RES-001", !too_long(seen), || format!("a ttl of {TTL_MS} ms is seen to move it for {seen}"));
    let is_long_enough = moved.median_ms >= TTL_MS - moved.tolerance_ms;
    rulings.observe("NCP-RES-013", is_long_enough, || format!("a ttl of {TTL_MS} ms moves it for {moved}"));
    Ok(())
}

/// A plant with the two streams by which the judge deals with it.
struct Plant<'a> {
    mapping: &'a Mapping,
    sensors: Perception,
    commands: CommandPublisher,
}

/// What a plant did after something was done to it.
enum Reaction {
    /// What was asked, and as long.
    Stays,
    /// Not what was asked.
    Never,
    /// What was asked, but not as long.
    Leaves(Duration),
    /// It did not say.
    Silent,
}

impl<'a> Plant<'a> {
    /// Waits for the plant's sensor stream, and for it to take commands; none if it does not come.
    fn meet(bus: &Bus, target: &'a Target, rulings: &mut Rulings) -> Result<Option<Self>, LiveError> {
        let mapping = &target.mapping;
        let key = bus.keys().sensor(&target.session, mapping.stream.as_deref()).map_err(BusError::from)?;
        let sensors: Perception = Intake::subscribe(bus, key, 4_096)?;
        let commands = CommandPublisher::declare(bus, &target.session, None)?;
        let plant = Self { mapping, sensors, commands };
        let is_there =
            plant.next(PATIENCE).is_some() && until(PATIENCE, || Ok(plant.commands.stream().has_reader()?))?;
        if !is_there {
            rulings.all_unclear("no plant publishes its motion, or none subscribes to commands");
        }
        Ok(is_there.then_some(plant))
    }

    /// The next word on the plant's motion: when it arrived, the plant's own time in s, and whether it moves.
    fn next(&self, longest: Duration) -> Option<(Instant, f64, bool)> {
        let began = Instant::now();
        while let Some(rest) = longest.checked_sub(began.elapsed()) {
            let arrival = self.sensors.wait_for(rest)?;
            let frame = SensorFrame::decode(&arrival.payload.to_bytes()).ok();
            if let Some((frame, moves)) =
                frame.and_then(|frame| Some((self.mapping.moves(&frame)?, frame))).map(|(moves, frame)| (frame, moves))
            {
                return Some((arrival.at, frame.t, moves));
            }
        }
        None
    }

    fn drain(&self) {
        while self.sensors.next().is_some() {}
    }

    /// Waits for a motion, and then looks whether it lasts.
    fn comes_to(&self, moves: bool, lasting: Duration) -> Reaction {
        let began = Instant::now();
        let since = loop {
            match self.next(REACTION) {
                None => return Reaction::Silent,
                Some((at, _, is)) if is == moves => {
                    // A plant that moved may have said so on the way.
                    if at > began + if moves { Duration::ZERO } else { Duration::from_millis(30) } {
                        break at;
                    }
                }
                Some(_) => {}
            }
            if began.elapsed() > REACTION {
                return Reaction::Never;
            }
        };
        self.stays(moves, since, lasting)
    }

    /// Looks whether a motion lasts.
    fn stays(&self, moves: bool, since: Instant, lasting: Duration) -> Reaction {
        while since.elapsed() < lasting {
            match self.next(REACTION) {
                None => return Reaction::Silent,
                Some((at, _, is)) if is != moves => return Reaction::Leaves(at.saturating_duration_since(since)),
                Some(_) => {}
            }
        }
        Reaction::Stays
    }
}

/// An active command that moves the plant.
fn moving(mapping: &Mapping, seq: i64, ttl_ms: f64) -> CommandFrame {
    let setpoint = ChannelValue::new(mapping.setpoint.clone(), mapping.unit.clone());
    let channels = ChannelMap::from_iter([(mapping.command.clone(), setpoint)]);
    CommandFrame { seq, ttl_ms, channels, ..CommandFrame::default() }
}

/// Such a command with the members that a step gives it; its seq counts from `base` on.
fn frame(mapping: &Mapping, base: i64, members: &Map<String, Value>) -> String {
    let text = moving(mapping, 1, 200.0).encode().unwrap_or_default();
    let mut frame: Map<String, Value> = serde_json::from_str(&text).unwrap_or_default();
    frame.extend(members.iter().map(|(name, value)| (name.clone(), value.clone())));
    if let Some(seq) = frame.get_mut("seq") {
        *seq = (base + seq.as_i64().unwrap_or_default()).into();
    }
    Value::Object(frame).to_string()
}

const fn verb(moves: bool) -> &'static str {
    if moves { "moves" } else { "holds" }
}
