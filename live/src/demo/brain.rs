//! The commander: a control loop whose commands are decoded from the spikes of a network on NEST, asked over Zenoh.

use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use ncp_spec::codec::{RateCodec, Rates};
use ncp_spec::control::{ControlLoop, Controller, LoopConfig};
use ncp_spec::plane::Plane;
use ncp_spec::resilience::LinkMonitor;
use ncp_spec::safety::{Decision, SafetyGovernor};
use ncp_spec::wire::{
    ChannelMap, ChannelValue, CloseSession, CommandFrame, Message, Mode, NetworkRef, NetworkRefKind, Observable,
    ObservationFrame, OpenSession, RecordSpec, RecordTarget, SafetyLimits, SensorFrame, SimConfig, SortedMap,
    StepRequest, StimulusFrame, StimulusKind, StimulusSpec, StimulusTarget,
};
use ncp_zenoh::{Bus, BusError, ControlClient, Perception, StreamPublisher};

use super::Wishes;
use super::story::{Asked, Story};
use crate::LiveError;
use crate::simulator::PATIENCE;
use crate::target::{Running, Target};

/// From one tick to the next, and how much the network runs in it.
const PERIOD: Duration = Duration::from_millis(20);
/// Neurons a population.
const NEURONS: i64 = 60;
/// How much of a rate that was just decoded counts; the rest is what was decoded before.
const NEWNESS: f64 = 0.3;

/// A log that is written while the flight goes on.
pub(super) type Log<T> = Arc<Mutex<Vec<T>>>;

/// A tick of the commander.
#[derive(Debug, Clone)]
pub(super) struct Ticked {
    pub(super) at_s: f64,
    pub(super) seq: i64,
    pub(super) mode: Mode,
    pub(super) decision: Decision,
    /// What was commanded, in m/s.
    pub(super) velocity: Vec<f64>,
    /// Spikes in this tick.
    pub(super) spikes: u64,
    /// How long the network took, with the way there and back, in ms.
    pub(super) thought_ms: f64,
}

/// Starts the commander, which stops at a burst of `link`, and whose clock begins at `began`: opens the session, and
/// closes it in the end.
///
/// # Errors
/// No session is opened, or Zenoh refuses.
pub(super) fn brain(
    target: &Target,
    story: &Story,
    wishes: &Arc<Wishes>,
    link: LinkMonitor,
    began: Instant,
) -> Result<(Running, Log<Ticked>), LiveError> {
    let bus = target.bus()?;
    let perception = Perception::of(&bus, &target.session, None)?;
    let keys = bus.keys();
    let command = StreamPublisher::declare(
        &bus,
        keys.command(&target.session, None).map_err(BusError::from)?,
        Plane::Action.qos(),
    )?;
    let session = Session::open(&bus, target)?;
    let said = Arc::new(Said::default());
    let network = Network {
        session,
        story: story.clone(),
        wishes: Arc::clone(wishes),
        codec: RateCodec::uav(),
        rates: Rates::new(),
        said: Arc::clone(&said),
    };
    let limits = SafetyLimits {
        max_speed_mps: Some(1.5),
        geofence_radius_m: Some(20.0),
        command_timeout_ms: 300.0,
        ..SafetyLimits::default()
    };
    let period_ms = PERIOD.as_secs_f64() * 1e3;
    let mut control = ControlLoop::new(LoopConfig { period_ms }, network, SafetyGovernor::new(&limits), link)?;
    let status = StreamPublisher::declare(
        &bus,
        keys.observation(&target.session).map_err(BusError::from)?,
        Plane::Observation.qos(),
    )?;

    let log: Log<Ticked> = Arc::default();
    let (into, wishes) = (Arc::clone(&log), Arc::clone(wishes));
    let (mut took_ms, mut resets) = (0.0, wishes.resets());
    let running = Running::default().every(PERIOD, move || {
        let now = || began.elapsed().as_secs_f64();
        if resets != wishes.resets() {
            resets = wishes.resets();
            control.governor_mut().reset();
        }
        let at_s = now();
        while let Some(frame) = perception.next_frame() {
            control.on_sensor(frame, at_s);
        }
        let tick = control.tick(at_s, took_ms);
        // What a publisher counts as failed, the next tick makes good.
        let _ = (command.send(&tick.command), status.send(&tick.status));
        let velocity = tick.command.channels.get(ncp_spec::safety::VELOCITY_CHANNEL);
        lock(&into).push(Ticked {
            at_s,
            seq: tick.command.seq,
            mode: tick.command.mode,
            decision: tick.decision,
            velocity: velocity.map(|channel| channel.data.clone()).unwrap_or_default(),
            spikes: said.spikes.load(Ordering::Relaxed),
            thought_ms: *lock(&said.thought_ms),
        });
        took_ms = (now() - at_s) * 1e3;
    });
    Ok((running.keeping(bus), log))
}

pub(super) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// What the network said last, for the log.
#[derive(Debug, Default)]
struct Said {
    spikes: AtomicU64,
    thought_ms: Mutex<f64>,
}

/// A controller that is a network: the error of the position goes in as rates, and a velocity comes out of spikes.
struct Network {
    session: Session,
    story: Story,
    wishes: Arc<Wishes>,
    codec: RateCodec,
    /// What was decoded so far, smoothed, in Hz.
    rates: Rates,
    said: Arc<Said>,
}

impl Controller for Network {
    fn step(&mut self, now_s: f64, sensor: Option<&SensorFrame>) -> CommandFrame {
        let position = sensor.and_then(|frame| frame.channels.get("pose_position"));
        let goal = self.story.goal(now_s);
        let error: Vec<f64> = match position {
            Some(position) => goal.iter().zip(&position.data).map(|(goal, at)| goal - at).collect(),
            None => vec![0.0; 3],
        };
        let channels = ChannelMap::from_iter([("pose_error", ChannelValue::new(error, "m"))]);
        let rates = self.codec.encode(Some(&SensorFrame { channels, ..SensorFrame::default() }));
        let began = Instant::now();
        let heard = self.session.step(&rates, now_s);
        *lock(&self.said.thought_ms) = began.elapsed().as_secs_f64() * 1e3;
        let mut mode = match self.wishes.asked() {
            Asked::Fly => Mode::Active,
            Asked::Hold => Mode::Hold,
            Asked::Estop => Mode::Estop,
        };
        match heard {
            Some(heard) => self.hear(&heard),
            // Without its network it knows no velocity.
            None if mode == Mode::Active => mode = Mode::Hold,
            None => {}
        }
        self.codec.decode(&self.rates, now_s, 0, "world", mode)
    }
}

impl Network {
    fn hear(&mut self, heard: &ObservationFrame) {
        let mut spikes = 0;
        for mapping in &self.codec.decoders {
            let count = heard.records.get(&mapping.population).map_or(0, |record| record.times.len());
            spikes += count as u64;
            #[expect(clippy::cast_precision_loss, reason = "some hundred spikes of some neurons")]
            let rate = count as f64 / (NEURONS as f64 * PERIOD.as_secs_f64());
            let smoothed = self.rates.entry(mapping.population.to_string()).or_insert(rate);
            *smoothed += NEWNESS * (rate - *smoothed);
        }
        self.said.spikes.store(spikes, Ordering::Relaxed);
    }
}

/// An open session of the NEST service, until it is dropped.
struct Session {
    client: ControlClient,
    id: ncp_spec::wire::Text,
    observed: StreamPublisher,
    _bus: Bus,
}

impl Session {
    fn open(bus: &Bus, target: &Target) -> Result<Self, LiveError> {
        let client = ControlClient::new(bus, PATIENCE)?;
        let id: ncp_spec::wire::Text = target.session.clone().into();
        let codec = RateCodec::uav();
        let populations = codec.encoders.iter().map(|mapping| mapping.population.clone());
        let stimulus = populations.map(|name| StimulusTarget {
            port: name.clone(),
            target: name,
            kind: StimulusKind::RateHz,
            ..StimulusTarget::default()
        });
        let record = codec.decoders.iter().map(|mapping| RecordTarget {
            port: mapping.population.clone(),
            target: mapping.population.clone(),
            observable: Observable::Spikes,
            ..RecordTarget::default()
        });
        let open = OpenSession {
            session_id: id.clone(),
            network: NetworkRef {
                kind: NetworkRefKind::Spec,
                reference: network(&codec).into(),
                population_sizes: SortedMap::new(),
                ..NetworkRef::default()
            },
            record: RecordSpec { targets: record.collect() },
            stimulus: StimulusSpec { targets: stimulus.collect() },
            sim: SimConfig { chunk_ms: PERIOD.as_secs_f64() * 1e3, seed: Some(1), ..SimConfig::default() },
            ..OpenSession::default()
        };
        let key = bus.keys().observation(&id).map_err(BusError::from)?;
        let observed = StreamPublisher::declare(bus, key, Plane::Observation.qos())?;
        match client.ask(&open.into())? {
            Message::SessionOpened(opened) if opened.ok => {}
            Message::SessionOpened(opened) => {
                return Err(LiveError::Nest(opened.error.unwrap_or_default().into_owned()));
            }
            reply => return Err(LiveError::Nest(format!("opening the session: {reply:?}"))),
        }
        Ok(Self { client, id, observed, _bus: target.bus()? })
    }

    /// Runs the network for a period with these rates; what it did, unless it cannot be asked.
    fn step(&self, rates: &Rates, now_s: f64) -> Option<ObservationFrame> {
        let value = |(name, rate): (&String, &f64)| (name.clone(), ChannelValue::without_unit([*rate]));
        let stimulus = StimulusFrame {
            session_id: self.id.clone(),
            t: now_s,
            values: rates.iter().map(value).collect(),
            ..StimulusFrame::default()
        };
        let step = StepRequest { session_id: self.id.clone(), stimulus: Some(stimulus), ..StepRequest::default() };
        let Ok(Message::ObservationFrame(frame)) = self.client.ask(&step.into()) else { return None };
        // Who analyses the spikes reads them on the observation plane.
        let _ = self.observed.send(&frame);
        Some(frame)
    }
}

impl Drop for Session {
    fn drop(&mut self) {
        // A gateway that has ended leaves nothing to close.
        let _ = self.client.ask(&CloseSession { session_id: self.id.clone(), ..CloseSession::default() }.into());
    }
}

/// The network: a relay of spiking neurons for each axis, whose rate follows the rate of its input.
fn network(codec: &RateCodec) -> String {
    let (mut populations, mut projections) = (serde_json::Map::new(), Vec::new());
    for (from, to) in codec.encoders.iter().zip(&codec.decoders) {
        let [from, to] = [from, to].map(|mapping| mapping.population.to_string());
        let relay = serde_json::json!({"model": "iaf_psc_delta", "size": NEURONS, "params": {"t_ref": 0.5}});
        populations.insert(from.clone(), serde_json::json!({"model": "parrot_neuron", "size": NEURONS}));
        populations.insert(to.clone(), relay);
        // One spike is enough for one spike.
        projections.push(serde_json::json!({
            "source": from, "target": to,
            "rule": {"rule": "one_to_one"}, "synapse": {"weight": 25.0, "delay": 1.0},
        }));
    }
    serde_json::json!({"populations": populations, "projections": projections}).to_string()
}
