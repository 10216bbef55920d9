//! The calls with a trace (PROTOCOL.md, section 4): one function each, named after its call.
//!
//! An object of chapters 7 to 10 is built anew from the arguments, and does the steps in their order.

use std::borrow::Cow;
use std::collections::BTreeMap;

use ncp_spec::ErrorCode;
use ncp_spec::codec::{Mapping, RateCodec};
use ncp_spec::control::{ControlLoop, Controller as _, LoopConfig, ReflexConfig, ReflexController};
use ncp_spec::resilience::{
    ActionBuffer, CommandWatchdog, DEFAULT_REF_LOSS, DEFAULT_THRESHOLD, LinkMonitor, LinkReport, max_horizon_len,
};
use ncp_spec::safety::SafetyGovernor;
use ncp_spec::session::{ReferenceBackend, SessionService};
use ncp_spec::wire::{Capabilities, CommandFrame, Kind, Message, Mode, SensorFrame};
use serde::{Deserialize, Serialize};
use serde_json::value::RawValue;

use crate::calls::{CallError, Reply, build, kind, parse};
use crate::value::{Bytes, Channels, Double, Fields};

/// What a step gives, in the members that PROTOCOL.md lists with it.
#[derive(Debug, Serialize)]
#[serde(untagged)]
pub(crate) enum StepReply {
    Frame { frame: Fields },
    Hold { hold: bool },
    Active { channels: Option<Channels> },
    Link { last_seq: i64, received: i64, lost: i64, loss_rate: Double, burst: bool },
    Tick { command: Fields, status: Fields },
    Refused { error: Refusal },
    Nothing {},
}

/// Why a step was refused.
#[derive(Debug, Serialize)]
pub(crate) struct Refusal {
    code: &'static str,
    message: String,
}

#[derive(Deserialize)]
pub(crate) struct GovernorArgs<'a> {
    #[serde(borrow)]
    limits: &'a RawValue,
    #[serde(borrow)]
    capabilities: Option<ChannelArgs<'a>>,
    #[serde(borrow)]
    steps: Vec<&'a RawValue>,
}

#[derive(Deserialize)]
struct ChannelArgs<'a> {
    #[serde(borrow)]
    sensor_channels: &'a RawValue,
    #[serde(borrow)]
    command_channels: &'a RawValue,
}

#[derive(Deserialize)]
struct Govern<'a> {
    #[serde(borrow)]
    command: &'a RawValue,
    now_s: Double,
    #[serde(borrow)]
    sensor: Option<&'a RawValue>,
    last_sensor_s: Option<Double>,
}

#[derive(Deserialize)]
struct NoteLink {
    burst: bool,
}

pub(crate) fn governor_run(args: &GovernorArgs<'_>) -> Result<Reply, CallError> {
    let mut governor = match &args.capabilities {
        None => governor(args.limits)?,
        Some(channels) => SafetyGovernor::from_capabilities(&capabilities(&format!(
            r#"{{"safety":{},"sensor_channels":{},"command_channels":{}}}"#,
            args.limits, channels.sensor_channels, channels.command_channels
        ))?),
    };
    run(&args.steps, |op, step| match op {
        "govern" => {
            let args: Govern<'_> = parse(step)?;
            let mut command = command(args.command)?;
            let sensor = args.sensor.map(sensor).transpose()?;
            let Double(now_s) = args.now_s;
            let last_sensor_s = args.last_sensor_s.map(|Double(last_s)| last_s);
            governor.govern(&mut command, now_s, sensor.as_ref(), last_sensor_s);
            Ok(StepReply::Frame { frame: Fields::of(command) })
        }
        "note_link" => {
            let NoteLink { burst } = parse(step)?;
            governor.note_link(burst);
            Ok(StepReply::Nothing {})
        }
        "reset" => {
            governor.reset();
            Ok(StepReply::Nothing {})
        }
        _ => Err(no_step(op)),
    })
}

#[derive(Deserialize)]
pub(crate) struct StepsArgs<'a> {
    #[serde(borrow)]
    steps: Vec<&'a RawValue>,
}

#[derive(Deserialize)]
struct Stamp {
    now_s: Double,
    ttl_ms: Double,
    seq: i64,
}

#[derive(Deserialize)]
struct Now {
    now_s: Double,
}

pub(crate) fn watchdog_run(args: &StepsArgs<'_>) -> Result<Reply, CallError> {
    let mut watchdog = CommandWatchdog::new();
    run(&args.steps, |op, step| {
        match op {
            "command" => {
                let Stamp { now_s, ttl_ms, seq } = parse(step)?;
                watchdog.on_command(now_s.0, ttl_ms.0, seq);
            }
            "should_hold" => {
                let Now { now_s } = parse(step)?;
                let hold = watchdog.should_hold(now_s.0);
                return Ok(StepReply::Hold { hold });
            }
            "reset" => watchdog.reset(),
            _ => return Err(no_step(op)),
        }
        Ok(StepReply::Nothing {})
    })
}

#[derive(Deserialize)]
struct Arrival<'a> {
    #[serde(borrow)]
    text: Option<Cow<'a, str>>,
    base64: Option<Bytes>,
    now_s: Double,
}

#[derive(Deserialize)]
pub(crate) struct BufferArgs<'a> {
    #[serde(default)]
    strict: bool,
    #[serde(borrow)]
    steps: Vec<&'a RawValue>,
}

pub(crate) fn buffer_run(args: &BufferArgs<'_>) -> Result<Reply, CallError> {
    let mut buffer = if args.strict { ActionBuffer::strict() } else { ActionBuffer::new() };
    run(&args.steps, |op, step| {
        match op {
            "command" => {
                let Arrival { text, base64, now_s } = parse(step)?;
                let frame = match (&text, &base64) {
                    (Some(text), None) => text.as_bytes(),
                    (None, Some(Bytes(bytes))) => bytes,
                    _ => return Err(CallError::misfit(&"command takes either text or base64")),
                };
                buffer.on_frame(frame, now_s.0)?;
            }
            "active" => {
                let Now { now_s } = parse(step)?;
                let channels = buffer.active(now_s.0).cloned().map(Channels);
                return Ok(StepReply::Active { channels });
            }
            "reset" => buffer.reset(),
            _ => return Err(no_step(op)),
        }
        Ok(StepReply::Nothing {})
    })
}

#[derive(Deserialize)]
pub(crate) struct HorizonArgs {
    ttl_ms: Double,
    dt_ms: Double,
}

pub(crate) fn horizon_max_len(args: &HorizonArgs) -> Reply {
    Reply::Len { len: max_horizon_len(args.ttl_ms.0, args.dt_ms.0) }
}

#[derive(Deserialize)]
pub(crate) struct LinkArgs<'a> {
    ref_loss: Option<Double>,
    threshold: Option<Double>,
    #[serde(borrow)]
    steps: Vec<&'a RawValue>,
}

#[derive(Deserialize)]
struct Seen {
    seq: i64,
}

pub(crate) fn link_run(args: &LinkArgs<'_>) -> Result<Reply, CallError> {
    let mut link = LinkMonitor::new(
        args.ref_loss.map_or(DEFAULT_REF_LOSS, |Double(loss)| loss),
        args.threshold.map_or(DEFAULT_THRESHOLD, |Double(threshold)| threshold),
    );
    run(&args.steps, |op, step| match op {
        "frame" => {
            let Seen { seq } = parse(step)?;
            link.on_frame(seq);
            let LinkReport { last_seq, received, lost, loss_rate, burst } = link.report();
            Ok(StepReply::Link { last_seq, received, lost, loss_rate: Double(loss_rate), burst })
        }
        _ => Err(no_step(op)),
    })
}

#[derive(Deserialize)]
#[serde(untagged)]
enum CodecArgs {
    Preset(Preset),
    Own { encoders: Vec<MappingArgs>, decoders: Vec<MappingArgs> },
}

#[derive(Deserialize)]
#[serde(rename_all = "snake_case")]
enum Preset {
    Uav,
}

#[derive(Deserialize)]
struct MappingArgs {
    channel: String,
    component: usize,
    population: String,
    value_range: Option<[Double; 2]>,
    rate_range: Option<[Double; 2]>,
    unit: Option<String>,
}

#[derive(Deserialize)]
pub(crate) struct CodecEncodeArgs<'a> {
    codec: CodecArgs,
    #[serde(borrow)]
    sensor: Option<&'a RawValue>,
}

pub(crate) fn codec_encode(args: CodecEncodeArgs<'_>) -> Result<Reply, CallError> {
    let sensor = args.sensor.map(sensor).transpose()?;
    let rates = codec(args.codec).encode(sensor.as_ref());
    let rates = rates.into_iter();
    Ok(Reply::Rates { rates: rates.map(|(name, rate)| (name, Double(rate))).collect() })
}

#[derive(Deserialize)]
pub(crate) struct CodecDecodeArgs {
    codec: CodecArgs,
    rates: BTreeMap<String, Double>,
    t: Double,
    seq: i64,
    frame_id: String,
    mode: String,
}

pub(crate) fn codec_decode(args: CodecDecodeArgs) -> Result<Reply, CallError> {
    let mode = Mode::parse(&args.mode).ok_or_else(|| CallError::misfit(&"not a mode"))?;
    let rates = args.rates.into_iter();
    let rates = rates.map(|(name, Double(rate))| (name, rate)).collect();
    let command = codec(args.codec).decode(&rates, args.t.0, args.seq, args.frame_id, mode);
    Ok(Reply::Command { command: Fields::of(command) })
}

#[derive(Deserialize)]
struct ReflexConfigArgs {
    target: Option<[Double; 3]>,
    kp: Option<Double>,
    kd: Option<Double>,
    max_speed: Option<Double>,
}

#[derive(Deserialize)]
pub(crate) struct ReflexArgs<'a> {
    config: ReflexConfigArgs,
    #[serde(borrow)]
    sensor: Option<&'a RawValue>,
}

pub(crate) fn reflex_step(args: &ReflexArgs<'_>) -> Result<Reply, CallError> {
    let mut controller = reflex(&args.config)?;
    let sensor = args.sensor.map(sensor).transpose()?;
    // The clock is nothing to a controller without memory.
    let command = controller.step(0.0, sensor.as_ref());
    Ok(Reply::Command { command: Fields::of(command) })
}

#[derive(Deserialize)]
pub(crate) struct LoopArgs<'a> {
    period_ms: Double,
    #[serde(borrow)]
    limits: &'a RawValue,
    config: ReflexConfigArgs,
    #[serde(borrow)]
    steps: Vec<&'a RawValue>,
}

#[derive(Deserialize)]
struct Sensed<'a> {
    #[serde(borrow)]
    sensor: &'a RawValue,
    now_s: Double,
}

pub(crate) fn loop_run(args: &LoopArgs<'_>) -> Result<Reply, CallError> {
    let Double(period_ms) = args.period_ms;
    let mut control = ControlLoop::new(
        LoopConfig { period_ms },
        reflex(&args.config)?,
        governor(args.limits)?,
        LinkMonitor::default(),
    )?;
    run(&args.steps, |op, step| {
        match op {
            "sensor" => {
                let args: Sensed<'_> = parse(step)?;
                control.on_sensor(sensor(args.sensor)?, args.now_s.0);
            }
            "tick" => {
                let Now { now_s } = parse(step)?;
                // The clock of a trace stands still within a tick.
                let tick = control.tick(now_s.0, 0.0);
                return Ok(StepReply::Tick { command: Fields::of(tick.command), status: Fields::of(tick.status) });
            }
            "reset" => control.governor_mut().reset(),
            _ => return Err(no_step(op)),
        }
        Ok(StepReply::Nothing {})
    })
}

#[derive(Deserialize)]
pub(crate) struct SessionArgs<'a> {
    #[serde(borrow)]
    requests: Vec<Cow<'a, str>>,
    #[serde(default)]
    strict: bool,
    /// At the key of which kind each request comes; none: each at the right one.
    #[serde(borrow)]
    verbs: Option<Vec<Cow<'a, str>>>,
}

pub(crate) fn session_run(args: &SessionArgs<'_>) -> Result<Reply, CallError> {
    let mut service =
        if args.strict { SessionService::strict(ReferenceBackend) } else { SessionService::new(ReferenceBackend) };
    let requests = args.requests.iter().map(|request| request.as_bytes());
    let replies = match &args.verbs {
        None => requests.map(|request| service.serve(request)).collect(),
        Some(verbs) => requests
            .zip(verbs)
            .map(|(request, verb)| Ok(service.serve_at(kind(verb)?, request)))
            .collect::<Result<_, CallError>>()?,
    };
    Ok(Reply::Replies { replies })
}

/// Does the steps. One that is refused is an entry like others; one that PROTOCOL.md does not allow ends the call.
fn run<'a>(
    steps: &[&'a RawValue],
    mut each: impl FnMut(&str, &'a RawValue) -> Result<StepReply, CallError>,
) -> Result<Reply, CallError> {
    #[derive(Deserialize)]
    struct Op<'a> {
        #[serde(borrow)]
        op: Cow<'a, str>,
    }

    let mut replies = Vec::with_capacity(steps.len());
    for step in steps {
        let Op { op } = parse(step)?;
        replies.push(match each(&op, step) {
            Err(CallError::Refused { code, message }) if code != ErrorCode::Internal => {
                let code = code.as_str();
                let error = Refusal { code, message };
                StepReply::Refused { error }
            }
            reply => reply?,
        });
    }
    Ok(Reply::Steps { steps: replies })
}

fn no_step(op: &str) -> CallError {
    CallError::misfit(&format_args!("{op:?} is not a step of this call"))
}

/// A governor with the canonical channels.
fn governor(limits: &RawValue) -> Result<SafetyGovernor, CallError> {
    let capabilities = capabilities(&format!(r#"{{"safety":{limits}}}"#))?;
    Ok(SafetyGovernor::new(&capabilities.safety))
}

fn codec(args: CodecArgs) -> RateCodec {
    match args {
        CodecArgs::Preset(Preset::Uav) => RateCodec::uav(),
        CodecArgs::Own { encoders, decoders } => RateCodec {
            encoders: encoders.into_iter().map(mapping).collect(),
            decoders: decoders.into_iter().map(mapping).collect(),
        },
    }
}

fn mapping(args: MappingArgs) -> Mapping {
    let range = |[Double(from), Double(to)]: [Double; 2]| (from, to);
    let default = Mapping::new(args.channel, args.component, args.population);
    Mapping {
        value_range: args.value_range.map_or(default.value_range, range),
        rate_range: args.rate_range.map_or(default.rate_range, range),
        unit: args.unit.map(Into::into),
        ..default
    }
}

fn reflex(args: &ReflexConfigArgs) -> Result<ReflexController, CallError> {
    let default = ReflexConfig::default();
    let or = |value: Option<Double>, default| value.map_or(default, |Double(value)| value);
    Ok(ReflexController::new(ReflexConfig {
        target_m: args.target.map_or(default.target_m, |axes| axes.map(|Double(axis)| axis)),
        kp: or(args.kp, default.kp),
        kd: or(args.kd, default.kd),
        max_speed_mps: or(args.max_speed, default.max_speed_mps),
    })?)
}

fn capabilities(fields: &str) -> Result<Capabilities, CallError> {
    match build(Kind::Capabilities, fields)? {
        Message::Capabilities(capabilities) => Ok(capabilities),
        other => Err(other_kind(&other)),
    }
}

fn command(fields: &RawValue) -> Result<CommandFrame, CallError> {
    match build(Kind::CommandFrame, fields.get())? {
        Message::CommandFrame(command) => Ok(command),
        other => Err(other_kind(&other)),
    }
}

fn sensor(fields: &RawValue) -> Result<SensorFrame, CallError> {
    match build(Kind::SensorFrame, fields.get())? {
        Message::SensorFrame(sensor) => Ok(sensor),
        other => Err(other_kind(&other)),
    }
}

/// A message is always of the kind that was asked for.
fn other_kind(message: &Message) -> CallError {
    CallError::misfit(&format_args!("{} was built", message.kind()))
}
