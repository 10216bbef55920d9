//! A body: it moves as commanded, and says where it is and how fast.

use std::time::{Duration, Instant};

use ncp_spec::keys::KeyError;
use ncp_spec::plane::{Congestion, Plane, Priority, Qos};
use ncp_spec::resilience::{ActionBuffer, is_estop};
use ncp_spec::wire::{BulkObservation, ChannelMap, ChannelValue, CommandFrame, Frame, Mode, SensorFrame};
use ncp_zenoh::{Bus, Commands, Intake, StreamPublisher};

use super::{Care, Planted};
use crate::LiveError;
use crate::target::{Running, Target};

const PERIOD: Duration = Duration::from_millis(10);

pub(super) fn plant(target: &Target, planted: &Planted, care: &Care) -> Result<Running, LiveError> {
    let bus = target.bus()?;
    let mut streams = Streams::declare(&bus, target, planted)?;
    let mut obeys = Obeys::new(&bus, target, planted)?;
    let began = Instant::now();
    let mut position = [0.0; 3];
    let resets = care.plant.clone();
    let running = Running::default().every(PERIOD, move || {
        resets.carry_out(|| obeys.reset());
        let now_s = began.elapsed().as_secs_f64();
        let velocity = obeys.velocity(now_s);
        for (position, velocity) in position.iter_mut().zip(velocity) {
            *position += velocity * PERIOD.as_secs_f64();
        }
        streams.publish(now_s, position, velocity);
    });
    Ok(running.keeping(bus))
}

/// Three sensor streams, each with a counter of its own. `[NCP-PLANE-005]`
struct Streams {
    planted: Planted,
    body: StreamPublisher,
    front: StreamPublisher,
    rear: StreamPublisher,
    seqs: [i64; 3],
    ticks: i64,
}

impl Streams {
    fn declare(bus: &Bus, target: &Target, planted: &Planted) -> Result<Self, LiveError> {
        let mut qos = Plane::Perception.qos();
        if planted.is("sensor-blocks") {
            qos = Qos { congestion: Congestion::Block, ..qos };
        } else if planted.is("sensor-priority") {
            qos = Qos { priority: Priority::Data, ..qos };
        } else if planted.is("sensor-express") {
            qos = Qos { express: true, ..qos };
        }
        let stream = |name| -> Result<StreamPublisher, LiveError> {
            let key: Result<String, KeyError> = bus.keys().sensor(&target.session, name);
            Ok(StreamPublisher::declare(bus, key.map_err(ncp_zenoh::BusError::from)?, qos)?)
        };
        let (body, front, rear) = (stream(None)?, stream(Some("front"))?, stream(Some("rear"))?);
        Ok(Self { planted: planted.clone(), body, front, rear, seqs: [0; 3], ticks: 0 })
    }

    /// A failed publication is counted by its publisher; the next one says more than it.
    fn publish(&mut self, now_s: f64, position: [f64; 3], velocity: [f64; 3]) {
        self.ticks += 1;
        let t = if self.planted.is("clock-in-ms") { now_s * 1e3 } else { now_s };
        let channels = ChannelMap::from_iter([
            ("pose_position", ChannelValue::new(position, "m")),
            ("pose_velocity", ChannelValue::new(velocity, "m/s")),
        ]);
        let turns = [true, self.ticks % 2 == 0, self.ticks % 3 == 0];
        for (stream, is_due) in turns.into_iter().enumerate() {
            if !is_due {
                continue;
            }
            let counter = if self.planted.is("shared-counter") { 0 } else { stream };
            self.seqs[counter] += 1;
            if self.planted.is("seq-restarts") && self.seqs[counter] == 40 {
                self.seqs[counter] = 1;
            }
            let seq = self.seqs[counter];
            let publisher = [&self.body, &self.front, &self.rear][stream];
            let channels = if stream == 0 { channels.clone() } else { ChannelMap::new() };
            let _ = publisher.send(&SensorFrame { seq, t, channels, ..SensorFrame::default() });
        }
        if self.planted.is("block-on-perception") {
            let _ = self.rear.send(&BulkObservation::default());
        }
        if self.planted.is("raw-block-on-perception") {
            let _ = self.rear.send_bytes(*b"NCPB\x01\x00\x00\x00\x0c\x00\x00\x00");
        }
        if self.planted.is("cut-sensor") && self.ticks % 10 == 0 {
            let _ = self.front.send_bytes(*b"{\"kind\":\"sensor_frame\",\"seq\":");
        }
    }
}

/// How the plant obeys: the sound one as every plant may, the others with what goes wrong in plants.
enum Obeys {
    Sound(Commands),
    Defective {
        planted: Planted,
        intake: Intake<CommandFrame>,
        buffer: Box<ActionBuffer>,
        last_seq: i64,
        has_any: bool,
        /// The last command that moved it.
        last: Option<CommandFrame>,
        has_ended: bool,
        was_active: bool,
    },
}

impl Obeys {
    fn new(bus: &Bus, target: &Target, planted: &Planted) -> Result<Self, LiveError> {
        let buffer = ActionBuffer::new();
        if planted.0.is_none() {
            return Ok(Self::Sound(Commands::of(bus, &target.session, None, buffer)?));
        }
        let key = bus.keys().command(&target.session, None).map_err(ncp_zenoh::BusError::from)?;
        let intake = Intake::subscribe(bus, key, 4_096)?;
        let (planted, buffer) = (planted.clone(), Box::new(buffer));
        Ok(Self::Defective {
            planted,
            intake,
            buffer,
            last_seq: 0,
            has_any: false,
            last: None,
            has_ended: false,
            was_active: false,
        })
    }

    /// By a supervisor's decision. `[NCP-RES-030]`
    fn reset(&mut self) {
        match self {
            Self::Sound(commands) => commands.reset(),
            Self::Defective { buffer, last_seq, .. } => {
                buffer.reset();
                *last_seq = 0;
            }
        }
    }

    fn velocity(&mut self, now_s: f64) -> [f64; 3] {
        let active = match self {
            Self::Sound(commands) => commands.active(),
            Self::Defective { planted, intake, buffer, last_seq, has_any, last, has_ended, was_active } => {
                while let Some(arrival) = intake.next() {
                    *has_any = true;
                    let frame = arrival.payload.to_bytes();
                    if planted.is("damage-ends") && CommandFrame::decode(&frame).is_err() {
                        *has_ended = true;
                    }
                    over_a_link(planted, buffer, last, &frame, now_s);
                    take(planted, buffer, last_seq, &frame, now_s);
                }
                if planted.is("moves-at-start") && !*has_any {
                    return [0.1, 0.0, 0.0];
                }
                let active = buffer.active(now_s).cloned();
                *has_ended |= planted.is("stays-down") && *was_active && active.is_none();
                *was_active = active.is_some();
                if *has_ended { None } else { active }
            }
        };
        let setpoint = active.as_ref().and_then(|channels| channels.get("velocity_setpoint"));
        setpoint.and_then(|channel| channel.data.as_slice().try_into().ok()).unwrap_or_default()
    }
}

/// What goes wrong in plants when a link damages or doubles frames.
fn over_a_link(
    planted: &Planted,
    buffer: &mut ActionBuffer,
    last: &mut Option<CommandFrame>,
    frame: &[u8],
    now_s: f64,
) {
    let decoded = CommandFrame::decode(frame);
    let renews = (planted.is("damage-renews") && decoded.is_err())
        || (planted.is("copy-renews") && decoded.as_ref().is_ok_and(|command| command.mode == Mode::Active));
    if renews
        && !buffer.is_stopped()
        && let Some(last) = last.clone()
    {
        buffer.reset();
        buffer.on_command(last, now_s);
    }
    if let Ok(command) = decoded
        && command.mode == Mode::Active
        && last.as_ref().is_none_or(|last| command.seq > last.seq)
    {
        *last = Some(command);
    }
}

/// What the plant makes of a frame, with the one defect that is planted in it.
fn take(planted: &Planted, buffer: &mut ActionBuffer, last_seq: &mut i64, frame: &[u8], now_s: f64) {
    let lenient = || -> Option<CommandFrame> {
        let mut value: serde_json::Value = serde_json::from_slice(frame).ok()?;
        if planted.is("mode-in-any-case") {
            value["mode"] = value["mode"].as_str()?.to_lowercase().into();
        }
        CommandFrame::decode(value.to_string().as_bytes()).ok()
    };
    let decoded = match CommandFrame::decode(frame) {
        _ if planted.is("mode-in-any-case") => lenient(),
        Err(_) if planted.is("repeated-member") => lenient(),
        decoded => decoded.ok(),
    };
    let Some(mut command) = decoded else {
        let stops = is_estop(frame) && !planted.is("broken-estop-ignored");
        let text = String::from_utf8_lossy(frame);
        if stops || (planted.is("estop-of-any-kind") && text.contains(r#""mode":"estop""#)) {
            stop(buffer, now_s);
        }
        return;
    };
    let advances = command.seq > *last_seq;
    let is_stop = command.mode == Mode::Estop;
    if planted.is("ttl-unchecked") || (planted.is("zero-ttl-moves") && command.ttl_ms <= 0.0) {
        command.ttl_ms = 60_000.0;
    }
    if planted.is("ttl-default") && command.ttl_ms <= 0.0 {
        command.ttl_ms = 200.0;
    }
    if planted.is("coasts") && command.ttl_ms > 0.0 {
        command.ttl_ms += 400.0;
    }
    if planted.is("ttl-in-seconds") {
        command.ttl_ms *= 1e3;
    }
    if planted.is("expires-early") {
        command.ttl_ms *= 0.5;
    }
    if planted.is("horizon-forever") && !command.horizon.is_empty() {
        command.horizon.clear();
    }
    if planted.is("horizon-skipped") && !command.horizon.is_empty() {
        command.mode = Mode::Hold;
    }
    if planted.is("init-moves") && command.mode == Mode::Init {
        command.mode = Mode::Active;
    }
    if planted.is("estop-is-hold") && is_stop {
        command.mode = Mode::Hold;
    }
    if (planted.is("estop-by-seq") && is_stop && !advances)
        || (planted.is("hold-ignored") && command.mode == Mode::Hold)
    {
        return;
    }
    let forgets = (planted.is("latch-forgets") && command.mode == Mode::Active && buffer.is_stopped())
        || (planted.is("duplicate-renews") && command.seq == *last_seq)
        || (planted.is("stale-obeyed") && command.seq == *last_seq - 1)
        || (planted.is("restart-obeyed") && command.seq < *last_seq - 1);
    if forgets {
        buffer.reset();
    }
    if command.mode == Mode::Active {
        *last_seq = command.seq.max(*last_seq);
    }
    buffer.on_command(command, now_s);
}

fn stop(buffer: &mut ActionBuffer, now_s: f64) {
    buffer.on_command(CommandFrame { mode: Mode::Estop, ..CommandFrame::default() }, now_s);
}
