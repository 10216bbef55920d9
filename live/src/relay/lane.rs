//! The samples of a plane on their way.

use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::{Duration, Instant};

use ncp_zenoh::{Arrival, Bus, BusError, Intake, SeenQos, StreamPublisher};
use zenoh::bytes::ZBytes;

use super::decision::Damage;
use super::late::Late;
use super::schedule::{PlaneName, Stream};
use super::{Fate, LinkState, Passed};
use crate::LiveError;

/// How many samples wait for the relay; what is lost here, the schedule did not ask for.
const WAITING: usize = 1 << 16;

/// How long a frame waits for the next one, which is to go before it.
const NEXT: Duration = Duration::from_millis(100);

/// How long a lane sleeps at most.
const NAP: Duration = Duration::from_millis(5);

/// One plane, in one direction.
pub(super) struct Lane {
    plane: PlaneName,
    below: usize,
    intake: Intake<()>,
    to: Arc<Bus>,
    state: Arc<LinkState>,
    streams: BTreeMap<String, Way>,
    late: Late<Frame>,
}

/// A stream: what is decided on it, and where it goes on.
struct Way {
    name: Arc<str>,
    decisions: Stream,
    publisher: Option<(SeenQos, StreamPublisher)>,
    /// Frames that wait for the next one to go first, but no longer than until a time.
    held: Vec<(Instant, Frame)>,
    held_until: Option<Instant>,
}

struct Frame {
    key: String,
    qos: SeenQos,
    bytes: ZBytes,
    damage: Option<Damage>,
}

impl Lane {
    pub(super) fn open(plane: PlaneName, from: &Bus, to: Arc<Bus>, state: Arc<LinkState>) -> Result<Self, LiveError> {
        let realm = from.keys().realm();
        let pattern = match plane {
            PlaneName::Perception => "session/*/sensor/**",
            PlaneName::Action => "session/*/command/**",
            PlaneName::Observation => "session/*/observation",
            PlaneName::Control => "rpc",
        };
        let intake = Intake::subscribe(from, format!("{realm}/{pattern}"), WAITING)?;
        let below = realm.len() + 1;
        Ok(Self { plane, below, intake, to, state, streams: BTreeMap::new(), late: Late::new() })
    }

    /// Takes what came, and lets go on what is due.
    pub(super) fn pump(&mut self) {
        if let Some(arrival) = self.intake.wait_for(self.late.rest(NAP)) {
            self.take(&arrival);
        }
        let now = Instant::now();
        for way in self.streams.values_mut() {
            if way.held_until.is_some_and(|until| until <= now) {
                way.release(&mut self.late);
            }
        }
        while let Some(frame) = self.late.pop(now) {
            self.let_go_on(frame);
        }
    }

    fn take(&mut self, arrival: &Arrival) {
        let key = arrival.key.to_string();
        let Self { plane, below, state, streams, late, .. } = self;
        let way = streams.entry(key.clone()).or_insert_with(|| {
            let name = key.get(*below..).unwrap_or_default();
            let decisions = state.schedule.stream(*plane, name);
            Way { name: name.into(), decisions, publisher: None, held: Vec::new(), held_until: None }
        });
        let bytes = arrival.payload.clone();
        state.tell(Passed {
            plane: *plane,
            stream: Arc::clone(&way.name),
            bytes: bytes.clone(),
            at: arrival.at,
            fate: Fate::Came,
        });
        // A frame has its decision also when it meets a cut: the next one's stays the same.
        let decision = way.decisions.next();
        if state.is_cut(*plane) {
            return;
        }
        state.decided(*plane, &decision);
        let damage = decision.corrupt.map(|corruption| corruption.damage);
        let bytes = match decision.corrupt {
            Some(corruption) => ZBytes::from(corruption.of(&bytes.to_bytes())),
            None => bytes,
        };
        let now = Instant::now();
        let frame = || Frame { key: key.clone(), qos: arrival.qos, bytes: bytes.clone(), damage };
        let copies = decision.copies().into_iter().map(|after| (now + after, frame()));
        if decision.reordered && way.held.is_empty() {
            way.held.extend(copies);
            way.held_until = Some(now + NEXT);
            return;
        }
        for (due, frame) in copies {
            late.push(due, frame);
        }
        way.release(late);
    }

    fn let_go_on(&mut self, frame: Frame) {
        let Frame { key, qos, bytes, damage } = frame;
        // Commands that were late do not come after a supervisor has stopped them.
        if self.state.is_stopped(self.plane) {
            return;
        }
        let Some(way) = self.streams.get_mut(&key) else { return };
        let at = Instant::now();
        let passed = Passed {
            plane: self.plane,
            stream: Arc::clone(&way.name),
            bytes: bytes.clone(),
            at,
            fate: Fate::WentOn(damage),
        };
        self.state.tell(passed);
        // What cannot be published is lost, as on any link.
        if let Ok(publisher) = way.publisher(&self.to, &key, qos) {
            let _ = publisher.send_bytes(bytes);
        }
    }
}

impl Way {
    /// Lets the frames go on that waited for the next one.
    fn release(&mut self, late: &mut Late<Frame>) {
        let now = Instant::now();
        for (due, frame) in self.held.drain(..) {
            late.push(due.max(now), frame);
        }
        self.held_until = None;
    }

    /// The publisher with the quality of service that the stream came with. `[NCP-TRANS-002]`
    fn publisher(&mut self, to: &Bus, key: &str, qos: SeenQos) -> Result<&StreamPublisher, BusError> {
        let declared = match self.publisher.take() {
            Some((before, publisher)) if before == qos => publisher,
            _ => StreamPublisher::declare(to, key.to_owned(), qos)?,
        };
        Ok(&self.publisher.insert((qos, declared)).1)
    }
}
