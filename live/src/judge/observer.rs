//! Whoever reads: the judge is the plant and the commander.

use std::thread;
use std::time::Duration;

use ncp_spec::wire::{CommandFrame, SensorFrame};
use ncp_zenoh::{Bus, BusError, CommandPublisher, Intake, SensorPublisher};

use super::{PATIENCE, first_seq, until};
use crate::LiveError;
use crate::target::Target;
use crate::verdict::Rulings;

/// Nothing appears on the action plane while nobody but an observer is there.
pub(super) fn quiet(bus: &Bus, target: &Target, rulings: &mut Rulings) -> Result<(), LiveError> {
    let key = bus.keys().command_glob(&target.session).map_err(BusError::from)?;
    let commands: Intake<CommandFrame> = Intake::subscribe(bus, key, 16)?;
    let Some(sensors) = meet(bus, target, rulings)? else { return Ok(()) };
    for seq in (first_seq()..).take(50) {
        sensors.send(&SensorFrame { seq, ..SensorFrame::default() })?;
        thread::sleep(Duration::from_millis(10));
    }
    let count = commands.counts().received;
    rulings.observe("NCP-PLANE-008", count == 0, || format!("{count} samples on the action plane, and no commander"));
    Ok(())
}

/// Commands come late, early and out of step; the observer joins them by their stamps.
pub(super) fn join(bus: &Bus, target: &Target, rulings: &mut Rulings) -> Result<(), LiveError> {
    const RULE: &str = "NCP-PLANE-007";
    const FRAMES: usize = 20;
    let Some(sensors) = meet(bus, target, rulings)? else { return Ok(()) };
    let commands = CommandPublisher::declare(bus, &target.session, None)?;
    until(PATIENCE, || Ok(commands.stream().has_reader()?))?;
    let pause = || thread::sleep(Duration::from_millis(10));
    // Every third command comes before its sensor frame, and every other three frames late.
    let mut late = Vec::new();
    for seq in (first_seq()..).take(FRAMES) {
        let command = CommandFrame { seq, ..CommandFrame::default() };
        if seq % 3 == 0 {
            commands.send(&command)?;
            pause();
        } else {
            late.push(command);
        }
        sensors.send(&SensorFrame { seq, ..SensorFrame::default() })?;
        pause();
        if late.len() > 3 {
            commands.send(&late.remove(0))?;
            pause();
        }
    }
    for command in late {
        commands.send(&command)?;
        pause();
    }
    let pairs = || -> Result<Vec<(i64, i64)>, LiveError> {
        let text = std::fs::read_to_string(&target.joined)?;
        Ok(text.lines().filter_map(|line| serde_json::from_str(line).ok()).collect())
    };
    until(PATIENCE, || Ok(pairs()?.len() >= FRAMES))?;
    for (command, sensor) in pairs()? {
        let why = || format!("the command with seq {command} was joined with the sensor frame with seq {sensor}");
        rulings.observe(RULE, command == sensor, why);
    }
    Ok(())
}

/// An observer that is told to leave, and does, reads no more; `leave` tells it, where the judge can.
pub(super) fn leaves(
    bus: &Bus,
    target: &Target,
    leave: Option<impl FnOnce()>,
    rulings: &mut Rulings,
) -> Result<(), LiveError> {
    const RULE: &str = "NCP-TRANS-008";
    let Some(sensors) = meet(bus, target, rulings)? else { return Ok(()) };
    let Some(leave) = leave else {
        rulings.unclear(RULE, "the judge cannot tell an observer of a deployment to leave");
        return Ok(());
    };
    leave();
    let is_gone = until(Duration::from_secs(2), || Ok(!sensors.stream().has_reader()?))?;
    rulings.observe(RULE, is_gone, || "the observer has left, and is still subscribed".to_owned());
    Ok(())
}

/// Waits for somebody who reads the sensor stream; none if none comes.
fn meet(bus: &Bus, target: &Target, rulings: &mut Rulings) -> Result<Option<SensorPublisher>, LiveError> {
    let sensors = SensorPublisher::declare(bus, &target.session, None)?;
    let is_there = until(PATIENCE, || Ok(sensors.stream().has_reader()?))?;
    if !is_there {
        rulings.all_unclear("nobody reads the sensor stream");
    }
    Ok(is_there.then_some(sensors))
}
