//! The reference system over a hostile link, with a judge at both ends and a supervisor.

use std::collections::VecDeque;
use std::sync::mpsc::{Receiver, channel};
use std::thread;
use std::time::{Duration, Instant};

use ncp_spec::wire::{Frame, SensorFrame};
use ncp_zenoh::{Bus, BusError, Intake, Link, Perception};

use super::body::{Body, Seen};
use super::commander::Commander;
use super::replies;
use super::supervisor::{Supervisor, Tended};
use crate::LiveError;
use crate::actors::{self, Care, Planted};
use crate::judge::road::Road;
use crate::relay::schedule::{PlaneName, Schedule};
use crate::relay::{Fate, FaultCounts, Passed, Relay};
use crate::scenario::Role;
use crate::target::{GatewayPlace, Mapping, Noise, Running, Target, free_endpoint};

/// Where the parts stand: who obeys and answers on the right, the others on the left.
const RIGHT: [Role; 2] = [Role::Plant, Role::Server];

/// How long the judge waits before it judges what was seen: by then it knows all that went before.
const LAG_S: f64 = 0.4;

/// What a measurement may deviate by on a quiet machine, in s: the plant takes its time to notice, and to say so.
const SLACK_S: f64 = 0.15;

/// How late a machine may wake a thread before what it shows says nothing, in s.
const NOISY_S: f64 = 0.1;

/// How long a sensor may be silent to the judge beside its plant, in s.
const SILENT_S: f64 = 2.0;

/// A running system, until it is dropped.
pub(super) struct System {
    // In the order in which they end: first who talks, then the link, then the routers.
    running: Vec<Running>,
    sensors: Perception,
    replies: Receiver<Seen>,
    relay: Relay,
    noise: Noise,
    _buses: [Bus; 3],
    folder: tempfile::TempDir,
    schedule: Schedule,
    judge: Judge,
    supervisor: Supervisor,
}

/// What is seen, in the order of its time.
enum Event {
    /// A frame of the action or the perception plane.
    Passed(Passed),
    /// The plant says whether it moves.
    Moves(bool),
    /// The supervisor has asked for the resets.
    Asked,
    /// The supervisor has reset plant and commander.
    Reset,
}

/// What the judge knows.
struct Judge {
    body: Body,
    commander: Commander,
    mapping: Mapping,
    began: Instant,
    command: String,
    sensor: String,
    events: Vec<(f64, Event)>,
    /// What has to be added to the plant's clock at least, in s.
    offset_s: f64,
    last_sensed_s: f64,
    /// How late this machine was, and when, in s.
    late: VecDeque<(f64, f64)>,
    /// When each cut ends after which the plant has not moved yet, in s.
    cuts: VecDeque<f64>,
    /// How long it has to do so, in s.
    recovers_s: f64,
    skipped: u64,
}

impl System {
    /// Starts routers, link and parts.
    ///
    /// # Errors
    /// Zenoh refuses.
    pub(super) fn start(
        roles: &[Role],
        asks: u32,
        schedule: &Schedule,
        planted: &Planted,
        longest: Duration,
        recovers_s: f64,
    ) -> Result<Self, LiveError> {
        let (left, right) = (free_endpoint("tcp")?, free_endpoint("tcp")?);
        let routers = [&left, &right].map(|endpoint| Bus::open(&Link::Router(endpoint.clone()), None));
        let [left_router, right_router] = routers;
        let folder = tempfile::tempdir()?;
        // No gateway stands in the loop.
        let nobody = GatewayPlace::free()?;
        let target = |endpoint: String| Target {
            road: Road::Zenoh,
            endpoint,
            realm: "soak".to_owned(),
            session: "live".to_owned(),
            network: "ncp.reference.lif".to_owned(),
            joined: folder.path().join("joined.jsonl"),
            mapping: Mapping::default(),
            gateway: nobody.clone(),
        };
        let (routers, care) = ([left_router?, right_router?], Care::over_a_link());
        let relay = Relay::start(&left, &right, "soak", schedule.clone())?;
        let (left, right) = (target(left), target(right));
        let beside = right.bus()?;
        let key = beside.keys().sensor(&right.session, None).map_err(BusError::from)?;
        let sensors = Intake::subscribe(&beside, key, 4_096)?;
        let mut running = Vec::new();
        for role in roles {
            let target = if RIGHT.contains(role) { &right } else { &left };
            running.push(actors::start(*role, target, planted, &care)?);
        }
        let (into, replies) = channel();
        for client in 0..asks {
            running.push(replies::asks(&left, client, into.clone())?);
        }
        let judge = Judge::new(&right, relay.began(), schedule.windows(longest.as_secs_f64()), recovers_s);
        let [left_router, right_router] = routers;
        let _buses = [beside, left_router, right_router];
        let (noise, supervisor) = (Noise::new(), Supervisor::new(care));
        let schedule = schedule.clone();
        Ok(Self { running, sensors, replies, relay, noise, _buses, folder, schedule, judge, supervisor })
    }

    /// Looks once, and hands on what was seen.
    pub(super) fn look(&mut self, mut seen: impl FnMut(Seen)) {
        let judge = &mut self.judge;
        let now_s = judge.now_s();
        judge.events.extend(self.relay.passed().map(|passed| {
            let at_s = passed.at.saturating_duration_since(judge.began).as_secs_f64();
            (at_s, Event::Passed(passed))
        }));
        judge.sense(&self.sensors);
        judge.hear_noise(now_s, self.noise.worst_ms() / 1e3);
        let is_cut = self.schedule.is_cut(PlaneName::Action, now_s);
        match self.supervisor.tend(now_s, &judge.body, is_cut, judge.noise_s(now_s), &self.relay) {
            Tended::Asked => judge.events.push((now_s, Event::Asked)),
            Tended::Reset => judge.events.push((now_s, Event::Reset)),
            Tended::Nothing => {}
        }
        judge.events.sort_by(|a, b| a.0.total_cmp(&b.0));
        judge.judge(now_s - LAG_S, &mut seen);
        self.replies.try_iter().for_each(seen);
    }

    /// Seconds since the link came up.
    pub(super) fn now_s(&self) -> f64 {
        self.judge.now_s()
    }

    /// How many faults the link made so far.
    pub(super) fn faults(&self) -> FaultCounts {
        self.relay.faults()
    }

    /// When the plant moved last, in s, and since when it is latched.
    pub(super) fn motion(&self) -> (f64, Option<f64>) {
        (self.judge.body.last_moved_s(), self.judge.body.latched_s())
    }

    /// How often the supervisor has reset plant and commander.
    pub(super) const fn resets(&self) -> u64 {
        self.supervisor.resets()
    }

    /// What could not be judged, since the machine was too noisy.
    pub(super) const fn skipped(&self) -> u64 {
        self.judge.skipped
    }

    /// The pairs that the observer joined, and whether both stamps of each are the same.
    pub(super) fn joined(&self) -> Vec<Seen> {
        let text = std::fs::read_to_string(self.folder.path().join("joined.jsonl")).unwrap_or_default();
        let pairs = text.lines().filter_map(|line| serde_json::from_str::<[i64; 2]>(line).ok());
        let seen = pairs.map(|[command, sensor]| {
            Seen::new("NCP-PLANE-007", command == sensor, || format!("the observer joined {command} with {sensor}"))
        });
        seen.collect()
    }

    /// Ends all parts; how long that took, and whether none of them hung.
    pub(super) fn end(self, longest: Duration) -> (Duration, bool) {
        let began = Instant::now();
        let ends = thread::spawn(move || drop(self));
        while !ends.is_finished() && began.elapsed() < longest {
            thread::sleep(Duration::from_millis(10));
        }
        let is_over = ends.is_finished() && ends.join().is_ok();
        (began.elapsed(), is_over)
    }

    /// How many parts run.
    pub(super) fn parts(&self) -> usize {
        self.running.len()
    }
}

impl Judge {
    fn new(target: &Target, began: Instant, windows: Vec<(&[PlaneName], f64, f64)>, recovers_s: f64) -> Self {
        let of_loop = [PlaneName::Action, PlaneName::Perception];
        let cuts = windows.into_iter().filter(|(planes, ..)| planes.iter().any(|plane| of_loop.contains(plane)));
        let cuts: VecDeque<f64> = cuts.map(|(.., to_s)| to_s).collect();
        Self {
            body: Body::new(target.mapping.clone()),
            commander: Commander::default(),
            mapping: target.mapping.clone(),
            began,
            command: format!("session/{}/command", target.session),
            sensor: format!("session/{}/sensor", target.session),
            events: Vec::new(),
            offset_s: f64::INFINITY,
            last_sensed_s: 0.0,
            late: VecDeque::new(),
            cuts,
            recovers_s,
            skipped: 0,
        }
    }

    fn now_s(&self) -> f64 {
        self.began.elapsed().as_secs_f64()
    }

    /// What the plant says of itself, by its own clock: a frame that is late is not taken for a late motion.
    fn sense(&mut self, sensors: &Perception) {
        while let Some(arrival) = sensors.next() {
            let Ok(frame) = SensorFrame::decode(&arrival.payload.to_bytes()) else { continue };
            let arrived_s = arrival.at.saturating_duration_since(self.began).as_secs_f64();
            self.offset_s = self.offset_s.min(arrived_s - frame.t);
            if let Some(moves) = self.mapping.moves(&frame) {
                self.events.push((arrived_s.min(frame.t + self.offset_s), Event::Moves(moves)));
            }
        }
    }

    fn hear_noise(&mut self, now_s: f64, late_s: f64) {
        self.late.push_back((now_s, late_s));
        while self.late.front().is_some_and(|(at_s, _)| now_s - at_s > 3.0) {
            self.late.pop_front();
        }
    }

    /// How late the machine was around a time.
    fn noise_s(&self, at_s: f64) -> f64 {
        let around = self.late.iter().filter(|(heard_s, _)| (heard_s - at_s).abs() < 0.6);
        around.map(|(_, late_s)| *late_s).fold(0.0, f64::max)
    }

    /// Judges what happened until a time.
    fn judge(&mut self, until_s: f64, seen: &mut impl FnMut(Seen)) {
        let count = self.events.partition_point(|(at_s, _)| *at_s <= until_s);
        let events: Vec<_> = self.events.drain(..count).collect();
        for (at_s, event) in events {
            let noise_s = self.noise_s(at_s);
            let slack_s = SLACK_S + 2.0 * noise_s;
            let is_noisy = noise_s > NOISY_S;
            let mut found = Vec::new();
            match event {
                Event::Asked => self.commander.reset(),
                Event::Reset => {
                    self.body.reset(at_s);
                    self.commander.reset();
                }
                Event::Moves(moves) => {
                    found.extend(self.body.is_seen(at_s, moves, slack_s));
                    self.last_sensed_s = at_s;
                }
                Event::Passed(passed) => {
                    let is = |stream: &str| *passed.stream == *stream;
                    let bytes = || passed.bytes.to_bytes();
                    match passed.fate {
                        Fate::WentOn(damage) if is(&self.command) => self.body.told(at_s, &bytes(), damage),
                        Fate::WentOn(None) if is(&self.sensor) => self.commander.told(at_s, &bytes()),
                        Fate::Came if is(&self.command) => found = self.commander.sent(at_s, &bytes(), slack_s),
                        _ => {}
                    }
                }
            }
            for one in found {
                if one.is_so || !is_noisy {
                    seen(one);
                } else {
                    self.skipped += 1;
                }
            }
        }
        self.recovers(until_s, seen);
        self.is_alive(until_s, seen);
    }

    /// After a cut the plant moves again.
    fn recovers(&mut self, until_s: f64, seen: &mut impl FnMut(Seen)) {
        const RULE: &str = "NCP-RES-026";
        while let Some(cut_s) = self.cuts.front().copied().filter(|cut_s| *cut_s < until_s) {
            let (moved, recovers_s) = (self.body.last_moved_s() > cut_s, self.recovers_s);
            if !moved && until_s - cut_s < self.recovers_s {
                return;
            }
            self.cuts.pop_front();
            seen(Seen::new(RULE, moved, || {
                format!("a cut ended at {cut_s:.3} s, and the plant did not move within {recovers_s} s")
            }));
        }
    }

    /// The plant goes on to sense, whatever reaches it.
    fn is_alive(&mut self, until_s: f64, seen: &mut impl FnMut(Seen)) {
        let silent_s = until_s - self.last_sensed_s;
        if silent_s > SILENT_S + 2.0 * self.noise_s(until_s) {
            self.last_sensed_s = until_s;
            seen(Seen::new("NCP-RES-026", false, || {
                format!("the plant was silent for {silent_s:.1} s, until {until_s:.3} s")
            }));
        }
    }
}
