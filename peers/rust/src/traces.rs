//! The calls with a trace (PROTOCOL.md, section 4): one function each, named after its call.
//!
//! An object of chapters 7 to 10 is built anew from the arguments, and does the steps in their order.

use std::collections::BTreeMap;

use ncp_adapter::CallError;
use ncp_adapter::args::{self, parse};
use ncp_adapter::json::Raw;
use ncp_adapter::reply::StepReply;
use ncp_adapter::steps::{
    BufferStep, Govern, GovernorStep, LinkStep, LoopStep, NoteLink, Seen, Sensed, Stamp, WatchdogStep, run,
};
use ncp_adapter::value::{Double, Fields};
use ncp_spec::codec::{Mapping, RateCodec};
use ncp_spec::control::{ControlLoop, Controller as _, LoopConfig, ReflexConfig, ReflexController};
use ncp_spec::resilience::{
    ActionBuffer, CommandWatchdog, DEFAULT_REF_LOSS, DEFAULT_THRESHOLD, LinkMonitor, LinkReport, max_horizon_len,
};
use ncp_spec::safety::SafetyGovernor;
use ncp_spec::session::{ReferenceBackend, SessionService};
use ncp_spec::wire::Mode;
use serde::Deserialize;

use crate::refusal::Refusal;
use crate::value::{capabilities, channels, command, fields, kind, sensor};

type Steps = Result<Vec<StepReply>, Refusal>;

pub(crate) fn governor_run(args: &args::Governor<'_>) -> Steps {
    let mut governor = match args.capabilities() {
        None => governor(args.limits)?,
        Some(declared) => SafetyGovernor::from_capabilities(&capabilities(&declared)?),
    };
    run(&args.steps, |step| {
        match step {
            GovernorStep::Govern(Govern { command: sent, now_s, sensor: seen, last_sensor_s }) => {
                let mut command = command(sent.get())?;
                let sensor = seen.map(|seen| sensor(seen.get())).transpose()?;
                let last_sensor_s = last_sensor_s.map(|Double(last_s)| last_s);
                governor.govern(&mut command, now_s.0, sensor.as_ref(), last_sensor_s);
                return Ok(StepReply::Frame { frame: fields(command)? });
            }
            GovernorStep::NoteLink(NoteLink { burst }) => governor.note_link(burst),
            GovernorStep::Reset => governor.reset(),
        }
        Ok::<_, Refusal>(StepReply::Nothing {})
    })
}

pub(crate) fn watchdog_run(args: &args::Watchdog<'_>) -> Steps {
    let mut watchdog = CommandWatchdog::new();
    run(&args.steps, |step| {
        match step {
            WatchdogStep::Command(Stamp { now_s, ttl_ms, seq }) => {
                watchdog.on_command(now_s.0, ttl_ms.0, seq);
            }
            WatchdogStep::ShouldHold(now) => {
                return Ok(StepReply::Hold { hold: watchdog.should_hold(now.seconds()) });
            }
            WatchdogStep::Reset => watchdog.reset(),
        }
        Ok::<_, Refusal>(StepReply::Nothing {})
    })
}

pub(crate) fn buffer_run(args: &args::Buffer<'_>) -> Steps {
    let mut buffer = if args.strict { ActionBuffer::strict() } else { ActionBuffer::new() };
    run(&args.steps, |step| {
        match step {
            BufferStep::Command(arrival) => {
                buffer.on_frame(arrival.frame()?, arrival.now_s.0)?;
            }
            BufferStep::Active(now) => {
                let channels = buffer.active(now.seconds()).map(channels).transpose()?;
                return Ok(StepReply::Active { channels });
            }
            BufferStep::Reset => buffer.reset(),
        }
        Ok::<_, Refusal>(StepReply::Nothing {})
    })
}

pub(crate) fn horizon_max_len(args: &args::Horizon) -> usize {
    max_horizon_len(args.ttl_ms.0, args.dt_ms.0)
}

pub(crate) fn link_run(args: &args::Link<'_>) -> Steps {
    let mut link = LinkMonitor::new(
        args.ref_loss.map_or(DEFAULT_REF_LOSS, |Double(loss)| loss),
        args.threshold.map_or(DEFAULT_THRESHOLD, |Double(threshold)| threshold),
    );
    run(&args.steps, |LinkStep::Frame(Seen { seq })| {
        link.on_frame(seq);
        let LinkReport { last_seq, received, lost, loss_rate, burst } = link.report();
        Ok::<_, Refusal>(StepReply::Link { last_seq, received, lost, loss_rate: Double(loss_rate), burst })
    })
}

pub(crate) fn codec_encode(args: &args::CodecEncode<'_>) -> Result<Fields, Refusal> {
    let sensor = args.sensor.map(|seen| sensor(seen.get())).transpose()?;
    let rates = codec(args.codec)?.encode(sensor.as_ref());
    let rates: BTreeMap<_, _> = rates.into_iter().map(|(name, rate)| (name, Double(rate))).collect();
    Ok(Fields::of(&rates)?)
}

pub(crate) fn codec_decode(args: &args::CodecDecode<'_>) -> Result<Fields, Refusal> {
    let mode = Mode::parse(&args.mode).ok_or_else(|| CallError::misfit("not a mode"))?;
    let rates: BTreeMap<String, Double> = parse(args.rates)?;
    let rates = rates.into_iter().map(|(name, Double(rate))| (name, rate)).collect();
    Ok(fields(codec(args.codec)?.decode(&rates, args.t.0, args.seq, args.frame_id.to_string(), mode))?)
}

pub(crate) fn reflex_step(args: &args::Reflex<'_>) -> Result<Fields, Refusal> {
    let mut controller = reflex(args.config)?;
    let sensor = args.sensor.map(|seen| sensor(seen.get())).transpose()?;
    // The clock is nothing to a controller without memory.
    Ok(fields(controller.step(0.0, sensor.as_ref()))?)
}

pub(crate) fn loop_run(args: &args::Loop<'_>) -> Steps {
    let Double(period_ms) = args.period_ms;
    let mut control = ControlLoop::new(
        LoopConfig { period_ms },
        reflex(args.config)?,
        governor(args.limits)?,
        LinkMonitor::default(),
    )?;
    run(&args.steps, |step| {
        match step {
            LoopStep::Sensor(Sensed { sensor: seen, now_s }) => {
                control.on_sensor(sensor(seen.get())?, now_s.0);
            }
            LoopStep::Tick(now) => {
                // The clock of a trace stands still within a tick.
                let tick = control.tick(now.seconds(), 0.0);
                return Ok(StepReply::Tick { command: fields(tick.command)?, status: fields(tick.status)? });
            }
            LoopStep::Reset => control.governor_mut().reset(),
        }
        Ok::<_, Refusal>(StepReply::Nothing {})
    })
}

pub(crate) fn session_run(args: &args::Session<'_>) -> Result<Vec<String>, Refusal> {
    let mut service =
        if args.strict { SessionService::strict(ReferenceBackend) } else { SessionService::new(ReferenceBackend) };
    let requests = args.requests.iter().map(|request| request.as_bytes());
    match &args.verbs {
        None => Ok(requests.map(|request| service.serve(request)).collect()),
        Some(verbs) => requests.zip(verbs).map(|(request, verb)| Ok(service.serve_at(kind(verb)?, request))).collect(),
    }
}

/// A governor with the canonical channels.
fn governor(limits: Raw<'_>) -> Result<SafetyGovernor, Refusal> {
    let capabilities = capabilities(&format!(r#"{{"safety":{limits}}}"#))?;
    Ok(SafetyGovernor::new(&capabilities.safety))
}

#[derive(Deserialize)]
#[serde(untagged)]
enum CodecArgs {
    Preset(Preset),
    Own {
        #[serde(default)]
        encoders: Vec<MappingArgs>,
        #[serde(default)]
        decoders: Vec<MappingArgs>,
    },
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

fn codec(args: Raw<'_>) -> Result<RateCodec, CallError> {
    Ok(match parse(args)? {
        CodecArgs::Preset(Preset::Uav) => RateCodec::uav(),
        CodecArgs::Own { encoders, decoders } => RateCodec {
            encoders: encoders.into_iter().map(mapping).collect(),
            decoders: decoders.into_iter().map(mapping).collect(),
        },
    })
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

#[derive(Deserialize)]
struct ReflexConfigArgs {
    target: Option<[Double; 3]>,
    kp: Option<Double>,
    kd: Option<Double>,
    max_speed: Option<Double>,
}

fn reflex(config: Raw<'_>) -> Result<ReflexController, Refusal> {
    let args: ReflexConfigArgs = parse(config)?;
    let default = ReflexConfig::default();
    let or = |value: Option<Double>, default| value.map_or(default, |Double(value)| value);
    Ok(ReflexController::new(ReflexConfig {
        target_m: args.target.map_or(default.target_m, |axes| axes.map(|Double(axis)| axis)),
        kp: or(args.kp, default.kp),
        kd: or(args.kd, default.kd),
        max_speed_mps: or(args.max_speed, default.max_speed_mps),
    })?)
}
