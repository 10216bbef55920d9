//! Whoever sends commands: the judge is the plant.

use std::collections::BTreeSet;
use std::time::{Duration, Instant};

use ncp_spec::wire::{ChannelMap, ChannelValue, CommandFrame, Frame, Mode, SensorFrame};
use ncp_zenoh::{Bus, BusError, Intake, SensorPublisher};

use super::{PATIENCE, first_seq, until};
use crate::LiveError;
use crate::target::{Noise, Target};
use crate::verdict::{Measured, Rulings};

/// From one sensor frame to the next.
const PERIOD: Duration = Duration::from_millis(10);

/// The commands' seq are those of sensor frames, whose stamps no counter hits; and they live for two periods at least.
pub(super) fn echo(bus: &Bus, target: &Target, rulings: &mut Rulings) -> Result<(), LiveError> {
    let Some(mut loops) = Loop::meet(bus, target, rulings)? else { return Ok(()) };
    let mut arrivals = Vec::new();
    let began = Instant::now();
    while began.elapsed() < Duration::from_secs(1) {
        loops.sense([0.1, 0.0, 0.0])?;
        arrivals.extend(loops.commands(PERIOD));
    }
    for (_, command) in arrivals.iter().filter(|(_, command)| command.seq != 0) {
        let is_so = loops.stamps.contains(&command.seq);
        for rule in ["NCP-PLANE-006", "NCP-CTRL-013"] {
            rulings.observe(rule, is_so, || format!("seq {} of a command is that of no sensor frame", command.seq));
        }
    }
    let apart = arrivals.windows(2).map(|pair| pair[1].0.saturating_duration_since(pair[0].0).as_secs_f64() * 1e3);
    if let Some(period) = Measured::of(apart.collect(), 0.0) {
        // The middle of what was seen is the loop's period; half of it is left for a machine that was late.
        for (_, command) in &arrivals {
            let is_so = command.ttl_ms >= 1.5 * period.median_ms;
            let why = || format!("a ttl of {} ms, and the period is about {:.1} ms", command.ttl_ms, period.median_ms);
            rulings.observe("NCP-CTRL-014", is_so, why);
        }
        rulings.measured("NCP-CTRL-014", Some(period));
    }
    Ok(())
}

/// Commands go on while sensor frames come faster than any loop takes them.
pub(super) fn flood(bus: &Bus, target: &Target, noise: &Noise, rulings: &mut Rulings) -> Result<(), LiveError> {
    const RULE: &str = "NCP-TRANS-009";
    const BURST: usize = 4_000;
    let Some(mut loops) = Loop::meet(bus, target, rulings)? else { return Ok(()) };
    let mut calm = Vec::new();
    let began = Instant::now();
    while began.elapsed() < Duration::from_millis(500) {
        loops.sense([0.1, 0.0, 0.0])?;
        calm.extend(loops.commands(PERIOD));
    }
    noise.worst_ms();
    let began = Instant::now();
    for _ in 0..BURST {
        loops.sense([0.1, 0.0, 0.0])?;
    }
    let mut flooded = vec![began];
    while began.elapsed() < Duration::from_secs(2) {
        flooded.extend(loops.commands(PERIOD).into_iter().map(|(at, _)| at).filter(|at| *at > began));
        loops.sense([0.1, 0.0, 0.0])?;
    }
    flooded.push(Instant::now());
    let gaps = flooded.windows(2).map(|pair| pair[1].saturating_duration_since(pair[0]).as_secs_f64() * 1e3);
    let worst_ms = noise.worst_ms();
    let tolerance_ms = 700.0 + 2.0 * worst_ms;
    let Some(gaps) = Measured::of(gaps.collect(), tolerance_ms) else { return Ok(()) };
    rulings.measured(RULE, Some(gaps));
    if calm.len() < 5 || worst_ms > 300.0 {
        rulings.unclear(RULE, "too few commands came before the flood, or this machine is too noisy to tell");
        return Ok(());
    }
    rulings.observe(RULE, gaps.max_ms <= tolerance_ms, || {
        format!("{BURST} sensor frames at once held the commands up for {:.0} ms", gaps.max_ms)
    });
    Ok(())
}

/// A sensor that falls silent turns the commands to HOLD.
pub(super) fn stale(bus: &Bus, target: &Target, rulings: &mut Rulings) -> Result<(), LiveError> {
    const RULE: &str = "NCP-SAFE-033";
    let Some(mut loops) = Loop::meet(bus, target, rulings)? else { return Ok(()) };
    if !loops.becomes(&[Mode::Active], || Some([0.1, 0.0, 0.0]))? {
        rulings.unclear(RULE, "the commander never sent an active command");
        return Ok(());
    }
    let turns = loops.becomes(&[Mode::Hold, Mode::Estop], || None)?;
    rulings.observe(RULE, turns, || format!("no sensor frame came for {PATIENCE:?}, and the commands are active"));
    Ok(())
}

/// A plant beyond any fence turns the commands to ESTOP, and they stay so.
pub(super) fn fence(bus: &Bus, target: &Target, rulings: &mut Rulings) -> Result<(), LiveError> {
    let Some(mut loops) = Loop::meet(bus, target, rulings)? else { return Ok(()) };
    if !loops.becomes(&[Mode::Active], || Some([0.1, 0.0, 0.0]))? {
        rulings.all_unclear("the commander never sent an active command");
        return Ok(());
    }
    let stops = loops.becomes(&[Mode::Estop], || Some([1e6, 0.0, 0.0]))?;
    rulings.observe("NCP-SAFE-043", stops, || "the plant is 1,000 km away, and no ESTOP came".to_owned());
    if stops {
        let began = Instant::now();
        while began.elapsed() < Duration::from_millis(600) {
            loops.sense([0.1, 0.0, 0.0])?;
            for (_, command) in loops.commands(PERIOD) {
                let is_so = command.mode == Mode::Estop;
                rulings.observe("NCP-SAFE-005", is_so, || format!("after an ESTOP came {:?}", command.mode));
            }
        }
    } else {
        rulings.unclear("NCP-SAFE-005", "no ESTOP came that could be latched");
    }
    Ok(())
}

/// A control loop, seen from its plant.
struct Loop {
    sensors: SensorPublisher,
    commands: Intake<CommandFrame>,
    began: Instant,
    seq: i64,
    stamps: BTreeSet<i64>,
}

impl Loop {
    /// Waits for a commander that reads the sensor stream and commands; none if none comes.
    fn meet(bus: &Bus, target: &Target, rulings: &mut Rulings) -> Result<Option<Self>, LiveError> {
        let sensors = SensorPublisher::declare(bus, &target.session, target.mapping.stream.as_deref())?;
        let key = bus.keys().command(&target.session, None).map_err(BusError::from)?;
        let commands = Intake::subscribe(bus, key, 1 << 16)?;
        let mut loops = Self { sensors, commands, began: Instant::now(), seq: first_seq(), stamps: BTreeSet::new() };
        let is_there = until(PATIENCE, || {
            loops.sense([0.1, 0.0, 0.0])?;
            Ok(!loops.commands(PERIOD).is_empty())
        })?;
        if !is_there {
            rulings.all_unclear("nobody commands the plant");
        }
        Ok(is_there.then_some(loops))
    }

    /// Publishes that the plant is there, and rests.
    fn sense(&mut self, position: [f64; 3]) -> Result<(), LiveError> {
        self.seq += 7;
        self.stamps.insert(self.seq);
        let channels = ChannelMap::from_iter([
            ("pose_position", ChannelValue::new(position, "m")),
            ("pose_velocity", ChannelValue::new([0.0; 3], "m/s")),
        ]);
        let t = self.began.elapsed().as_secs_f64();
        Ok(self.sensors.send(&SensorFrame { seq: self.seq, t, channels, ..SensorFrame::default() })?)
    }

    /// The commands that came meanwhile, and when.
    fn commands(&self, meanwhile: Duration) -> Vec<(Instant, CommandFrame)> {
        let began = Instant::now();
        let mut commands = Vec::new();
        while let Some(rest) = meanwhile.checked_sub(began.elapsed()) {
            let Some(arrival) = self.commands.wait_for(rest) else { break };
            if let Ok(command) = CommandFrame::decode(&arrival.payload.to_bytes()) {
                commands.push((arrival.at, command));
            }
        }
        commands
    }

    /// Senses, or not, until a command in one of the modes comes that was computed since; whether one did.
    fn becomes(&mut self, modes: &[Mode], mut position: impl FnMut() -> Option<[f64; 3]>) -> Result<bool, LiveError> {
        let began = Instant::now();
        until(PATIENCE, || {
            if let Some(position) = position() {
                self.sense(position)?;
            }
            let commands = self.commands(PERIOD);
            Ok(commands.iter().any(|(at, command)| *at > began + 2 * PERIOD && modes.contains(&command.mode)))
        })
    }
}
