//! What stands around a loop: a controller that does what it is told, and a governor and a link monitor that may answer
//! anything, and note what they are told.

use std::cell::RefCell;
use std::rc::Rc;

use ncp_spec::control::Controller;
use ncp_spec::safety::Decision;
use ncp_spec::wire::{CommandFrame, SensorFrame};

/// What a loop asked of its parts, in order.
#[derive(Debug, Clone, PartialEq)]
pub enum Asked {
    /// The controller was asked for a command.
    Step {
        /// The time that it was told.
        now_s: u64,
        /// The sensor frame.
        sensor: Option<SensorFrame>,
    },
    /// The monitor was told of a frame.
    Arrived(i64),
    /// The monitor was asked for a burst.
    Burst,
    /// The governor was told of the link.
    Link(bool),
    /// The governor was given a command.
    Govern {
        /// It, as it was given.
        command: CommandFrame,
        /// The time, by its bits.
        now_s: u64,
        /// The sensor frame.
        sensor: Option<SensorFrame>,
        /// When that was received, by its bits.
        last_s: Option<u64>,
    },
}

/// What was asked, shared by the parts of a loop.
pub type Log = Rc<RefCell<Vec<Asked>>>;

/// A controller that answers with a given command.
#[derive(Debug, Clone, Default)]
pub struct Scripted {
    /// The command.
    pub answer: CommandFrame,
    /// What it was asked.
    pub log: Log,
}

impl Controller for Scripted {
    fn step(&mut self, now_s: f64, sensor: Option<&SensorFrame>) -> CommandFrame {
        self.log.borrow_mut().push(Asked::Step { now_s: now_s.to_bits(), sensor: sensor.cloned() });
        self.answer.clone()
    }
}

/// A governor that leaves a given command and decision, whatever it is asked.
#[derive(Debug, Clone)]
pub struct SafetyGovernor {
    /// The command that it leaves; none: it changes nothing.
    pub leaves: Option<CommandFrame>,
    /// Its decision.
    pub decides: Decision,
    /// What it was asked.
    pub log: Log,
}

impl SafetyGovernor {
    /// As the governor of the specification.
    pub fn govern(
        &mut self,
        command: &mut CommandFrame,
        now_s: f64,
        sensor: Option<&SensorFrame>,
        last_s: Option<f64>,
    ) -> Decision {
        let (sensor, last_s) = (sensor.cloned(), last_s.map(f64::to_bits));
        let asked = Asked::Govern { command: command.clone(), now_s: now_s.to_bits(), sensor, last_s };
        self.log.borrow_mut().push(asked);
        if let Some(leaves) = &self.leaves {
            command.clone_from(leaves);
        }
        self.decides
    }

    /// As the governor of the specification.
    pub fn note_link(&mut self, burst: bool) {
        self.log.borrow_mut().push(Asked::Link(burst));
    }

    /// As the governor of the specification.
    pub const fn reset(&mut self) {}
}

/// A link monitor that says what it is told to.
#[derive(Debug, Clone)]
pub struct LinkMonitor {
    /// What it says.
    pub burst: bool,
    /// What it was told.
    pub log: Log,
}

impl LinkMonitor {
    /// As the monitor of the specification.
    pub fn on_frame(&mut self, seq: i64) {
        self.log.borrow_mut().push(Asked::Arrived(seq));
    }

    /// As the monitor of the specification.
    #[must_use]
    pub fn burst(&self) -> bool {
        self.log.borrow_mut().push(Asked::Burst);
        self.burst
    }
}
