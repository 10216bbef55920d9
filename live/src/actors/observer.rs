//! A reader that joins each command with the sensor frame that it was computed from.

use std::collections::{BTreeMap, VecDeque};
use std::fs::File;
use std::io::Write;
use std::mem;
use std::time::Duration;

use ncp_spec::wire::{CommandFrame, SensorFrame};
use ncp_zenoh::{BusError, CommandPublisher, Intake, Perception};

use super::Planted;
use crate::LiveError;
use crate::target::{Running, Target};

/// How many frames of a stream are kept: what was lost on the way is not waited for.
const KEPT: usize = 1_024;

pub(super) fn observer(target: &Target, planted: &Planted) -> Result<Running, LiveError> {
    let bus = target.bus()?;
    let sensors = Perception::of(&bus, &target.session, None)?;
    let key = bus.keys().command(&target.session, None).map_err(BusError::from)?;
    let commands: Intake<CommandFrame> = Intake::subscribe(&bus, key, 4_096)?;
    let publishes = match planted.is("observer-commands") {
        true => Some(CommandPublisher::declare(&bus, &target.session, None)?),
        false => None,
    };
    let mut joined = File::create(&target.joined)?;
    let planted = planted.clone();
    let mut known: BTreeMap<i64, SensorFrame> = BTreeMap::new();
    let mut waiting: VecDeque<CommandFrame> = VecDeque::new();
    let mut last_arrived = 0;

    let leaks = planted.is("subscription-leaks");
    let mut reads = Reads { leaks, intakes: Some((sensors, commands)) };
    let running = Running::default().every(Duration::from_millis(2), move || {
        let Some((sensors, commands)) = &mut reads.intakes else { return };
        while let Some(frame) = sensors.next_frame() {
            last_arrived = frame.seq;
            known.insert(frame.seq, frame);
            if known.len() > KEPT {
                known.pop_first();
            }
        }
        while let Some(command) = commands.next_frame() {
            waiting.push_back(command);
            if waiting.len() > KEPT {
                waiting.pop_front();
            }
        }
        // [NCP-PLANE-007] What was computed from a frame that is not here yet waits for it.
        waiting.retain(|command| {
            let sensor = if planted.is("joins-on-arrival") {
                Some(last_arrived)
            } else {
                known.get(&command.seq).map(|f| f.seq)
            };
            if let Some(sensor) = sensor {
                let _ = writeln!(joined, "[{},{sensor}]", command.seq);
            }
            sensor.is_none()
        });
        if let Some(publishes) = &publishes {
            let _ = publishes.send(&CommandFrame::default());
        }
    });
    // The thread ends before the session does, which else ended what is leaked.
    if leaks {
        mem::forget(bus);
        return Ok(running);
    }
    Ok(running.keeping(bus))
}

struct Reads {
    leaks: bool,
    intakes: Option<(Perception, Intake<CommandFrame>)>,
}

impl Drop for Reads {
    fn drop(&mut self) {
        if self.leaks {
            mem::forget(self.intakes.take());
        }
    }
}
