//! A hostile link: a relay between two routers on loopback, which loses, delays, duplicates, reorders, damages, cuts
//! and floods what passes, plane by plane, as a schedule and its seed have it.
//!
//! On the left are those who command and ask, on the right those who obey and answer. Commands and requests go from
//! left to right, sensor frames, observations and replies from right to left, each with the quality of service with
//! which it came.
//!
//! | module | what it holds |
//! |---|---|
//! | [`schedule`] | what a link does: TOML, a seed, and the decisions that follow from both |
//! | [`decision`] | what happens to one frame, and what arrives of it |
//! | [`lane`] | the samples of a plane on their way |
//! | [`calls`] | requests and replies on their way |
//! | [`late`] | what is due at a time |

mod calls;
pub(crate) mod decision;
mod lane;
mod late;
pub(crate) mod schedule;

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use ncp_zenoh::{Bus, Link};
use zenoh::bytes::ZBytes;

use crate::LiveError;
use crate::target::Running;
use calls::Calls;
use decision::{Damage, Decision, Fault};
use lane::Lane;
use schedule::{PlaneName, Schedule};

/// How many times each kind of fault happened on each plane.
pub(crate) type FaultCounts = BTreeMap<PlaneName, BTreeMap<Fault, u64>>;

/// A running link, until it is dropped.
pub(crate) struct Relay {
    state: Arc<LinkState>,
    passed: Receiver<Passed>,
    _running: Running,
}

/// A sample that came to the relay, or went on from it.
#[derive(Debug, Clone)]
pub(crate) struct Passed {
    /// Its plane.
    pub(crate) plane: PlaneName,
    /// Its key below the realm.
    pub(crate) stream: Arc<str>,
    /// Its bytes.
    pub(crate) bytes: ZBytes,
    /// When it came, or just before it went on.
    pub(crate) at: Instant,
    /// What became of it.
    pub(crate) fate: Fate,
}

/// What became of a sample.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Fate {
    /// It came to the relay.
    Came,
    /// It went on, damaged or as it was.
    WentOn(Option<Damage>),
}

/// What the lanes of a link share.
struct LinkState {
    schedule: Schedule,
    began: Instant,
    faults: Mutex<FaultCounts>,
    /// Whether a supervisor holds up the commands.
    commands_stopped: AtomicBool,
    passed: Mutex<Sender<Passed>>,
}

impl Relay {
    /// Links two routers in a realm.
    ///
    /// # Errors
    /// One of them is not there, or Zenoh refuses.
    pub(crate) fn start(left: &str, right: &str, realm: &str, schedule: Schedule) -> Result<Self, LiveError> {
        let bus = |endpoint: &str| Bus::open(&Link::Connect(endpoint.to_owned()), Some(realm));
        let (left, right) = (Arc::new(bus(left)?), Arc::new(bus(right)?));
        let (into, passed) = channel();
        let state = Arc::new(LinkState {
            schedule,
            began: Instant::now(),
            faults: Mutex::default(),
            commands_stopped: AtomicBool::new(false),
            passed: Mutex::new(into),
        });
        let mut running = Running::default();
        for (plane, from, to) in [
            (PlaneName::Action, &left, &right),
            (PlaneName::Perception, &right, &left),
            (PlaneName::Observation, &right, &left),
        ] {
            let mut lane = Lane::open(plane, from, Arc::clone(to), Arc::clone(&state))?;
            running = running.every(Duration::ZERO, move || lane.pump());
        }
        let mut calls = Calls::open(&left, Arc::clone(&right), Arc::clone(&state))?;
        running = running.every(Duration::ZERO, move || calls.pump());
        Ok(Self { state, passed, _running: running.keeping((left, right)) })
    }

    /// When it came up: the times of the schedule count from here.
    pub(crate) fn began(&self) -> Instant {
        self.state.began
    }

    /// The samples of the action and the perception plane that passed since the last time, in the order of each plane.
    pub(crate) fn passed(&self) -> impl Iterator<Item = Passed> {
        self.passed.try_iter()
    }

    /// How many faults there were so far.
    pub(crate) fn faults(&self) -> FaultCounts {
        lock(&self.state.faults).clone()
    }

    /// Lets no command through, or lets them through again. What comes meanwhile is lost, and so is what was late.
    pub(crate) fn stop_commands(&self, stop: bool) {
        self.state.commands_stopped.store(stop, Ordering::SeqCst);
    }
}

impl LinkState {
    /// Whether a plane is cut now; counted.
    fn is_cut(&self, plane: PlaneName) -> bool {
        let is_cut = self.schedule.is_cut(plane, self.began.elapsed().as_secs_f64()) || self.is_stopped(plane);
        if is_cut {
            self.count(plane, Fault::Cut, 1);
        }
        is_cut
    }

    fn is_stopped(&self, plane: PlaneName) -> bool {
        plane == PlaneName::Action && self.commands_stopped.load(Ordering::SeqCst)
    }

    fn decided(&self, plane: PlaneName, decision: &Decision) {
        for (fault, times) in decision.faults() {
            self.count(plane, fault, times);
        }
    }

    fn count(&self, plane: PlaneName, fault: Fault, times: u64) {
        *lock(&self.faults).entry(plane).or_default().entry(fault).or_default() += times;
    }

    /// Tells of a sample; nobody has to listen.
    fn tell(&self, passed: Passed) {
        if matches!(passed.plane, PlaneName::Action | PlaneName::Perception) {
            let _ = lock(&self.passed).send(passed);
        }
    }
}

/// What a thread that panicked left is whole: each change is one call.
fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests;
