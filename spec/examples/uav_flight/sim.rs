//! The body, the commander, the links between them, and what is written down of it all.

use std::cell::RefCell;
use std::error::Error;
use std::fmt::Write as _;
use std::rc::Rc;

use ncp_spec::bus::{LocalBus, Subscription};
use ncp_spec::control::{
    ControlLoop, Controller, LoopConfig, MEASURED_VELOCITY_CHANNEL, ReflexConfig, ReflexController, ReflexError,
};
use ncp_spec::keys::Keys;
use ncp_spec::resilience::{ActionBuffer, LinkMonitor, Received};
use ncp_spec::safety::{
    Decision, METRES, METRES_PER_SECOND, POSITION_CHANNEL, Reason, SafetyGovernor, VELOCITY_CHANNEL, kernel,
};
use ncp_spec::wire::{ChannelMap, ChannelValue, CommandFrame, Frame, SafetyLimits, SensorFrame, decode_any};
use serde_json::json;

use super::{place, shown};

pub(crate) const RADIUS_M: f64 = 10.0;
pub(crate) const MAX_SPEED_MPS: f64 = 2.0;
const TIMEOUT_MS: f64 = 250.0;
const TTL_MS: f64 = 400.0;
const PERIOD_MS: f64 = 50.0;
const HORIZON_STEPS: usize = 10;
const HORIZON_DT_MS: f64 = 200.0;
const HORIZON_TTL_MS: f64 = 3_000.0;

/// The body moves in steps of 10 ms; every fifth it senses, and the commander ticks.
const STEPS_A_SECOND: u32 = 100;
const STEPS_A_TICK: u32 = 5;
const STEP_S: f64 = 0.01;
/// A scene that takes longer has gone wrong.
const PATIENCE_S: f64 = 60.0;
const NEAR_M: f64 = 0.1;
const CARRY_MPS: f64 = 1.5;
const SESSION: &str = "uav3";

/// What the commander is told.
#[derive(Clone)]
pub(crate) struct Orders {
    reflex: ReflexController,
    target_m: [f64; 3],
    has_horizon: bool,
    /// The speed that the controller asked for at the last tick, in m/s.
    asked_mps: f64,
}

/// What the body does, and why.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum State {
    /// It follows tick 0 of a command that the governor passed as it was.
    Active,
    /// It follows tick 0 of a command that the governor limited.
    Limited,
    /// It follows a later tick.
    Replay,
    /// It stands.
    Hold,
    /// It stands, and is latched.
    Estop,
    /// A person moves it.
    Carried,
}

impl State {
    pub(crate) const ALL: [Self; 6] =
        [Self::Active, Self::Limited, Self::Replay, Self::Hold, Self::Estop, Self::Carried];

    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Active => "active",
            Self::Limited => "limited",
            Self::Replay => "replay",
            Self::Hold => "hold",
            Self::Estop => "estop",
            Self::Carried => "carried",
        }
    }
}

/// One row of the trajectory.
pub(crate) struct Sample {
    pub(crate) t: f64,
    pub(crate) position: [f64; 3],
    /// What the body follows, in m/s; wind and hands move it besides.
    pub(crate) followed_mps: f64,
    pub(crate) state: State,
}

/// A place on the plot.
pub(crate) struct Mark {
    pub(crate) name: &'static str,
    pub(crate) position: [f64; 3],
}

/// The flight and its record.
pub(crate) struct Flight {
    pub(crate) log: String,
    pub(crate) samples: Vec<Sample>,
    pub(crate) scenes: Vec<(f64, &'static str)>,
    pub(crate) marks: Vec<Mark>,
    steps: u32,
    bus: LocalBus,
    keys: SessionKeys,
    body: Body,
    commander: Commander,
    orders: Rc<RefCell<Orders>>,
    station: Station,
    is_linked: bool,
    is_sensing: bool,
    wind: [f64; 3],
    carried: bool,
}

struct SessionKeys {
    sensor: String,
    command: String,
    observation: String,
}

/// The plant: it does what its buffer says, exactly, and knows nothing else.
struct Body {
    position: [f64; 3],
    velocity: [f64; 3],
    seq: i64,
    buffer: ActionBuffer,
    commands: Subscription,
    /// When the command that it follows arrived, and how long its ticks are.
    following: Option<(f64, Option<f64>)>,
    was_told_to_hold: bool,
    tick: Option<usize>,
    shown: Option<(State, Option<usize>)>,
}

struct Commander {
    looped: ControlLoop<Pilot>,
    sensors: Subscription,
    decision: Option<Decision>,
    shown: Option<Decision>,
}

/// Flies by reflex, and looks ahead when it is told to.
struct Pilot {
    orders: Rc<RefCell<Orders>>,
}

/// Hears everything, and counts it.
struct Station {
    all: Subscription,
    sensors: u32,
    commands: u32,
    statuses: u32,
    lost: u32,
}

impl Orders {
    /// To a target in m, at no more than so many m/s an axis.
    pub(crate) fn new(target_m: [f64; 3], max_speed_mps: f64) -> Result<Self, ReflexError> {
        let config = ReflexConfig { target_m, max_speed_mps, ..ReflexConfig::default() };
        Ok(Self { reflex: ReflexController::new(config)?, target_m, has_horizon: false, asked_mps: 0.0 })
    }

    pub(crate) fn with_horizon(mut self) -> Self {
        self.has_horizon = true;
        self
    }
}

impl Controller for Pilot {
    fn step(&mut self, now_s: f64, sensor: Option<&SensorFrame>) -> CommandFrame {
        let mut orders = self.orders.borrow_mut();
        let mut command = orders.reflex.step(now_s, sensor);
        command.ttl_ms = TTL_MS;
        orders.asked_mps = speed(&command.channels);
        let Some(sensor) = sensor.filter(|_| orders.has_horizon) else {
            return command;
        };
        // The plan: the same reflex, applied to where the body will be.
        let mut ahead = sensor.clone();
        let mut channels = command.channels.clone();
        command.ttl_ms = HORIZON_TTL_MS;
        command.horizon_dt_ms = Some(HORIZON_DT_MS);
        for _ in 0..HORIZON_STEPS {
            let (place, velocity) = (position_of(&ahead), velocity_of(&channels));
            let place = kernel::travel(&place, &velocity, HORIZON_DT_MS / 1000.0);
            ahead.channels = sensed(place, velocity);
            channels = orders.reflex.step(now_s, Some(&ahead)).channels;
            command.horizon.push(channels.clone());
        }
        command
    }
}

impl Flight {
    /// A body at its start, a commander without orders, and a bus between them.
    pub(crate) fn new(start: [f64; 3]) -> Result<Self, Box<dyn Error>> {
        let limits = SafetyLimits {
            max_speed_mps: Some(MAX_SPEED_MPS),
            geofence_radius_m: Some(RADIUS_M),
            command_timeout_ms: TIMEOUT_MS,
            ..SafetyLimits::default()
        };
        let realm = Keys::new(None)?;
        let keys = SessionKeys {
            sensor: realm.sensor(SESSION, None)?,
            command: realm.command(SESSION, None)?,
            observation: realm.observation(SESSION)?,
        };
        let bus = LocalBus::new();
        let orders = Rc::new(RefCell::new(Orders::new(start, 0.0)?));
        let pilot = Pilot { orders: Rc::clone(&orders) };
        let config = LoopConfig { period_ms: PERIOD_MS };
        let governor = SafetyGovernor::new(&limits);
        let mut flight = Self {
            log: String::new(),
            samples: Vec::new(),
            scenes: Vec::new(),
            marks: vec![Mark { name: "start", position: start }],
            steps: 0,
            body: Body {
                position: start,
                velocity: [0.0; 3],
                seq: 0,
                buffer: ActionBuffer::new(),
                commands: bus.subscribe(&keys.command)?,
                following: None,
                was_told_to_hold: false,
                tick: None,
                shown: None,
            },
            commander: Commander {
                looped: ControlLoop::new(config, pilot, governor, LinkMonitor::default())?,
                sensors: bus.subscribe(&keys.sensor)?,
                decision: None,
                shown: None,
            },
            orders,
            station: Station {
                all: bus.subscribe(&realm.session_glob(SESSION)?)?,
                sensors: 0,
                commands: 0,
                statuses: 0,
                lost: 0,
            },
            is_linked: true,
            is_sensing: true,
            wind: [0.0; 3],
            carried: false,
            bus,
            keys,
        };
        let _ = writeln!(
            flight.log,
            "fence {RADIUS_M} m, speed limit {MAX_SPEED_MPS} m/s, sensor timeout {TIMEOUT_MS} ms, \
             ttl {TTL_MS} ms, tick {PERIOD_MS} ms\n\n\
             {:>7}  {:<10}  {:<13}  {:<20}  detail",
            "time s", "who", "event", "   x m    y m    z m"
        );
        Ok(flight)
    }

    /// Begins a scene.
    pub(crate) fn scene(&mut self, name: &'static str, detail: &str) {
        self.log.push('\n');
        self.scenes.push((self.now_s(), name));
        let number = self.scenes.len();
        self.tell("scene", &format!("{number}"), &format!("{name}: {detail}"));
    }

    /// Gives the commander new orders, and marks where they lead.
    pub(crate) fn order(&mut self, name: &'static str, orders: Orders) {
        let position = orders.target_m;
        self.tell("operator", "orders", &format!("fly to {name} at {} m", place(position)));
        self.marks.push(Mark { name, position });
        *self.orders.borrow_mut() = orders;
    }

    /// Wind that moves the body whatever it follows.
    pub(crate) fn gust(&mut self, detail: &str, wind: [f64; 3]) {
        self.wind = wind;
        self.tell("world", "wind", detail);
    }

    /// Lets commands reach the body, or loses them.
    pub(crate) fn link(&mut self, is_linked: bool) {
        self.is_linked = is_linked;
        let (event, detail) =
            if is_linked { ("link back", "commands arrive again") } else { ("link lost", "no command arrives") };
        self.tell("world", event, detail);
    }

    /// Lets the sensor speak, or freezes it.
    pub(crate) fn sensor(&mut self, is_sensing: bool) {
        self.is_sensing = is_sensing;
        let (event, detail) =
            if is_sensing { ("sensor back", "frames are sent again") } else { ("sensor silent", "no frame is sent") };
        self.tell("world", event, detail);
    }

    /// A person takes the body in hand and carries it.
    pub(crate) fn carry(&mut self, to: [f64; 3]) -> Result<(), Box<dyn Error>> {
        self.carried = true;
        self.tell("supervisor", "carries", &format!("by hand, to {} m", place(to)));
        loop {
            let way = [0, 1, 2].map(|axis: usize| to[axis] - self.body.position[axis]);
            let left = norm(&way);
            let share = (CARRY_MPS * STEP_S / left).min(1.0);
            self.body.position = kernel::travel(&self.body.position, &way, share);
            self.step()?;
            if share >= 1.0 {
                self.carried = false;
                return Ok(());
            }
        }
    }

    pub(crate) fn reset_governor(&mut self) {
        self.commander.looped.governor_mut().reset();
        self.tell("supervisor", "resets", "the governor; the body is latched for itself");
    }

    pub(crate) fn reset_body(&mut self) {
        self.body.buffer.reset();
        self.body.following = None;
        self.tell("supervisor", "resets", "the body; nothing moves until a new command comes");
    }

    /// Lets time pass.
    pub(crate) fn wait(&mut self, time_s: f64) -> Result<(), Box<dyn Error>> {
        let until_s = self.now_s() + time_s;
        while self.now_s() < until_s {
            self.step()?;
        }
        Ok(())
    }

    /// Lets time pass until something is so.
    pub(crate) fn until(&mut self, what: &str, is_so: impl Fn(&Self) -> bool) -> Result<(), Box<dyn Error>> {
        let patience_s = self.now_s() + PATIENCE_S;
        while !is_so(self) {
            if self.now_s() > patience_s {
                return Err(format!("{PATIENCE_S} s passed before {what}").into());
            }
            self.step()?;
        }
        Ok(())
    }

    pub(crate) fn until_near(&mut self, target: [f64; 3]) -> Result<(), Box<dyn Error>> {
        let left = |f: &Self| distance(f.body.position, target);
        self.until("it arrived", |f| left(f) <= NEAR_M)?;
        self.tell("body", "arrives", &format!("{:.2} m from its target", left(self)));
        Ok(())
    }

    /// What it all came to.
    pub(crate) fn land(&mut self) {
        let count = |state| self.samples.iter().filter(|s| s.state == state).count();
        let seconds = |state| count(state) as f64 * PERIOD_MS / 1000.0;
        let told: Vec<String> = State::ALL.map(|state| format!("{} {:.1} s", state.name(), seconds(state))).to_vec();
        let most = |of: &dyn Fn(&Sample) -> f64| self.samples.iter().map(of).fold(0.0, f64::max);
        let fastest = most(&|s| s.followed_mps);
        let commanded = most(&|s| match s.state {
            State::Active | State::Limited | State::Replay => norm(&s.position),
            State::Hold | State::Estop | State::Carried => 0.0,
        });
        let farthest = most(&|s| norm(&s.position));
        let Station { sensors, commands, statuses, lost, .. } = self.station;
        let _ = writeln!(
            self.log,
            "\n{:.1} s in the air: {}\n\
             fastest {fastest:.2} m/s; farthest from the origin {commanded:.2} m under command, \
             {farthest:.2} m under the wind\n\
             {sensors} sensor frames, {commands} commands of which {lost} were lost, {statuses} statuses",
            self.now_s(),
            told.join(", "),
        );
    }

    /// One JSON object a sample.
    pub(crate) fn trajectory(&self) -> String {
        let row = |sample: &Sample| {
            let scene = self.scenes.iter().rposition(|(begin, _)| *begin <= sample.t);
            let rounded = |x: f64| (x * 1e6).round() / 1e6 + 0.0;
            let row = json!({
                "t": sample.t,
                "scene": scene.map(|at| at + 1),
                "state": sample.state.name(),
                "position_m": sample.position.map(rounded),
                "distance_m": rounded(norm(&sample.position)),
                "followed_mps": rounded(sample.followed_mps),
            });
            format!("{row}\n")
        };
        self.samples.iter().map(row).collect()
    }

    pub(crate) fn state(&self) -> State {
        if self.carried {
            State::Carried
        } else if self.body.buffer.is_stopped() {
            State::Estop
        } else {
            match (self.body.tick, self.commander.decision) {
                (None, _) => State::Hold,
                (Some(0), Some(Decision::Limited)) => State::Limited,
                (Some(0), _) => State::Active,
                (Some(_), _) => State::Replay,
            }
        }
    }

    pub(crate) fn now_s(&self) -> f64 {
        f64::from(self.steps) / f64::from(STEPS_A_SECOND)
    }

    /// 10 ms: what arrived at the body, how it moves by it, and every fifth time a tick of the loop.
    fn step(&mut self) -> Result<(), Box<dyn Error>> {
        self.body_receives()?;
        self.body_moves();
        self.tell_of_the_body();
        if self.steps.is_multiple_of(STEPS_A_TICK) {
            self.samples.push(Sample {
                t: self.now_s(),
                position: self.body.position,
                followed_mps: norm(&self.body.velocity),
                state: self.state(),
            });
            if self.is_sensing {
                self.body_senses()?;
            }
            self.commander_ticks()?;
            self.station.listen()?;
        }
        self.steps += 1;
        Ok(())
    }

    fn body_receives(&mut self) -> Result<(), Box<dyn Error>> {
        let now_s = self.now_s();
        while let Some(delivery) = self.body.commands.next_frame() {
            if !self.is_linked {
                self.station.lost += 1;
                continue;
            }
            let received = self.body.buffer.on_frame(&delivery.frame, now_s)?;
            self.body.was_told_to_hold = received == Received::Held;
            if received == Received::Accepted {
                let dt_ms = CommandFrame::decode(&delivery.frame)?.horizon_dt_ms;
                self.body.following = Some((now_s, dt_ms));
            }
        }
        Ok(())
    }

    fn body_moves(&mut self) {
        let now_s = self.now_s();
        let body = &mut self.body;
        let followed = body.buffer.active(now_s).map(velocity_of);
        body.velocity = followed.unwrap_or_default();
        body.tick = followed.and(body.following).map(|(received_s, dt_ms)| {
            let age_ms = kernel::age_ms(now_s, received_s);
            dt_ms.map_or(0, |dt_ms| (age_ms / dt_ms) as usize)
        });
        if !self.carried {
            body.position = kernel::travel(&body.position, &body.velocity, STEP_S);
            body.position = kernel::travel(&body.position, &self.wind, STEP_S);
        }
    }

    fn body_senses(&mut self) -> Result<(), Box<dyn Error>> {
        self.body.seq += 1;
        let frame = SensorFrame {
            seq: self.body.seq,
            t: self.now_s(),
            channels: sensed(self.body.position, self.body.velocity),
            ..SensorFrame::default()
        };
        self.bus.publish(&self.keys.sensor, frame.encode()?.as_bytes())?;
        Ok(())
    }

    fn commander_ticks(&mut self) -> Result<(), Box<dyn Error>> {
        let now_s = self.now_s();
        while let Some(delivery) = self.commander.sensors.next_frame() {
            let frame = SensorFrame::decode(&delivery.frame)?;
            self.commander.looped.on_sensor(frame, now_s);
        }
        let tick = self.commander.looped.tick(now_s, 0.1);
        self.commander.decision = Some(tick.decision);
        self.bus.publish(&self.keys.command, tick.command.encode()?.as_bytes())?;
        self.bus.publish(&self.keys.observation, tick.status.encode()?.as_bytes())?;
        self.tell_of_the_governor(tick.decision, speed(&tick.command.channels));
        Ok(())
    }

    fn tell_of_the_governor(&mut self, decision: Decision, sent_mps: f64) {
        if self.commander.shown.replace(decision) == Some(decision) {
            return;
        }
        let asked_mps = self.orders.borrow().asked_mps;
        let (event, detail) = match decision {
            Decision::Passed => ("passes", format!("{asked_mps:.2} m/s")),
            Decision::Limited => ("limits", format!("{asked_mps:.2} m/s to {sent_mps:.2} m/s")),
            Decision::Held(reason) => ("holds", why(reason).to_owned()),
            Decision::Stopped(reason) => ("stops", why(reason).to_owned()),
        };
        self.tell("governor", event, &detail);
    }

    fn tell_of_the_body(&mut self) {
        let (state, tick) = (self.state(), self.body.tick);
        // What the governor did to a command is its own news.
        let news = match state {
            State::Limited => (State::Active, Some(0)),
            _ => (state, tick),
        };
        if self.body.shown.replace(news) == Some(news) {
            return;
        }
        let (event, detail) = match (news.0, tick) {
            (State::Replay, Some(tick)) => ("replays", format!("tick {tick} of its last command")),
            (State::Active | State::Limited | State::Replay, _) => {
                ("moves", "by tick 0 of each new command".to_owned())
            }
            (State::Hold, _) => ("holds", self.body.why_it_holds(self.now_s())),
            (State::Estop, _) => ("is stopped", "until it is reset".to_owned()),
            (State::Carried, _) => return,
        };
        self.tell("body", event, &detail);
    }

    fn tell(&mut self, who: &str, event: &str, detail: &str) {
        let _ = writeln!(
            self.log,
            "{:>7.2}  {who:<10}  {event:<13}  {}  {detail}",
            self.now_s(),
            shown(self.body.position),
        );
    }
}

impl Body {
    fn why_it_holds(&self, now_s: f64) -> String {
        match self.following {
            _ if self.was_told_to_hold => "it was told to".to_owned(),
            None => "no command has come".to_owned(),
            Some((_, Some(_))) => "its horizon is at its end".to_owned(),
            Some((received_s, None)) => {
                let age_ms = kernel::age_ms(now_s, received_s);
                format!("its command is {age_ms:.0} ms old")
            }
        }
    }
}

impl Station {
    fn listen(&mut self) -> Result<(), Box<dyn Error>> {
        while let Some(delivery) = self.all.next_frame() {
            match decode_any(&delivery.frame)?.kind().as_str() {
                "sensor_frame" => self.sensors += 1,
                "command_frame" => self.commands += 1,
                _ => self.statuses += 1,
            }
        }
        Ok(())
    }
}

const fn why(reason: Reason) -> &'static str {
    match reason {
        Reason::Estop => "ESTOP is latched",
        Reason::ConfigFault => "its limits cannot be enforced",
        Reason::StaleSensor => "the sensor is stale",
        Reason::NoPosition => "there is no position",
        Reason::OutsideFence => "the body is outside the fence: ESTOP, latched",
        Reason::NotActive => "the command is not active",
        Reason::NotFinite => "the command is not finite",
        Reason::NoVelocity => "there is no velocity",
        Reason::BadHorizon => "the horizon has no tick",
        Reason::LeavesFence => "the command leads out of the fence",
    }
}

fn sensed(position: [f64; 3], velocity: [f64; 3]) -> ChannelMap {
    ChannelMap::from_iter([
        (POSITION_CHANNEL, ChannelValue::new(position, METRES)),
        (MEASURED_VELOCITY_CHANNEL, ChannelValue::new(velocity, METRES_PER_SECOND)),
    ])
}

fn position_of(sensor: &SensorFrame) -> [f64; 3] {
    vector(&sensor.channels, POSITION_CHANNEL)
}

fn velocity_of(channels: &ChannelMap) -> [f64; 3] {
    vector(channels, VELOCITY_CHANNEL)
}

fn vector(channels: &ChannelMap, name: &str) -> [f64; 3] {
    let data = channels.get(name).map(|channel| channel.data.as_slice());
    data.and_then(|data| data.try_into().ok()).unwrap_or_default()
}

fn speed(channels: &ChannelMap) -> f64 {
    norm(&velocity_of(channels))
}

/// √(x² + y² + z²).
fn norm(vector: &[f64; 3]) -> f64 {
    vector.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    norm(&[0, 1, 2].map(|axis: usize| a[axis] - b[axis]))
}
