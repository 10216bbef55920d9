//! The calls with a trace (PROTOCOL.md, section 4): one function each, named after its call.

use std::borrow::Cow;

use serde::Deserialize;
use serde_json::value::RawValue;
use serde_json::{Value, json};

use crate::calls::{CallError, expressible, frame, json, parse, yes};
use crate::library::{Decode, Library, LinkReport};
use crate::value::{Bytes, Double};

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

pub(crate) fn governor_run(library: &Library, args: &GovernorArgs<'_>) -> Result<Value, CallError> {
    if !library.extended {
        return governed_once(library, args);
    }
    let governor = match &args.capabilities {
        None => library.governor(args.limits.get())?,
        Some(channels) => library.governor_of(&format!(
            r#"{{"safety":{},"sensor_channels":{},"command_channels":{}}}"#,
            args.limits, channels.sensor_channels, channels.command_channels
        ))?,
    };
    run(&args.steps, |op, step| match op {
        "govern" => {
            let args: Govern<'_> = parse(step)?;
            // The governor wants to be told what a program leaves to the message's defaults.
            let command = library.build("command_frame", args.command.get())?;
            let frame = library.governor_govern(
                &governor,
                &command,
                args.now_s.0,
                args.sensor.map(RawValue::get),
                args.last_sensor_s.map(|Double(last_s)| last_s),
            )?;
            Ok(json!({ "frame": json(&frame)? }))
        }
        "note_link" => {
            let NoteLink { burst } = parse(step)?;
            library.governor_note_link(&governor, burst)?;
            Ok(json!({}))
        }
        "reset" => {
            library.governor_reset(&governor)?;
            Ok(json!({}))
        }
        _ => Err(no_step(op)),
    })
}

/// A trace for the seed's function, which has no state and takes frames: one step `govern` for the canonical
/// channels, in numbers that JSON has, with no sensor before time began.
fn governed_once(library: &Library, args: &GovernorArgs<'_>) -> Result<Value, CallError> {
    let ([step], None) = (&args.steps[..], &args.capabilities) else {
        return Err(CallError::Unsupported);
    };
    run(&[*step], |op, step| {
        if op != "govern" {
            return Err(CallError::Unsupported);
        }
        let step: Govern<'_> = parse(step)?;
        let last_sensor_s = match step.last_sensor_s {
            None => -1.0,
            Some(Double(last_s)) if last_s < 0.0 => return Err(CallError::Unsupported),
            Some(Double(last_s)) => last_s,
        };
        expressible(args.limits)?;
        let command = frame(library, "command_frame", step.command)?;
        let sensor = step.sensor.map(|fields| frame(library, "sensor_frame", fields));
        let governed =
            library.govern(args.limits.get(), &command, step.now_s.0, sensor.transpose()?.as_deref(), last_sensor_s)?;
        Ok(json!({ "frame": json(&governed)? }))
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

pub(crate) fn watchdog_run(library: &Library, args: &StepsArgs<'_>) -> Result<Value, CallError> {
    let watchdog = library.watchdog()?;
    run(&args.steps, |op, step| {
        match op {
            "command" => {
                let Stamp { now_s, ttl_ms, seq } = parse(step)?;
                library.watchdog_on_command(&watchdog, now_s.0, ttl_ms.0, seq)?;
            }
            "should_hold" => {
                let Now { now_s } = parse(step)?;
                let code = library.watchdog_should_hold(&watchdog, now_s.0)?;
                return Ok(json!({ "hold": yes(code)? }));
            }
            "reset" => {
                library.watchdog_reset(&watchdog)?;
            }
            _ => return Err(no_step(op)),
        }
        Ok(json!({}))
    })
}

#[derive(Deserialize)]
struct Arrival<'a> {
    #[serde(borrow)]
    text: Option<Cow<'a, str>>,
    base64: Option<Bytes>,
    now_s: Double,
}

pub(crate) fn buffer_run(library: &Library, args: &StepsArgs<'_>) -> Result<Value, CallError> {
    let buffer = library.buffer()?;
    run(&args.steps, |op, step| {
        match op {
            "command" => {
                let args: Arrival<'_> = parse(step)?;
                let frame = match (&args.text, &args.base64) {
                    (Some(text), None) => text.as_bytes(),
                    (None, Some(Bytes(bytes))) => bytes,
                    _ => return Err(CallError::misfit("command takes either text or base64")),
                };
                library.buffer_on_frame(&buffer, frame, args.now_s.0)?;
            }
            "active" => {
                let Now { now_s } = parse(step)?;
                let channels = library.buffer_active(&buffer, now_s.0)?;
                let channels = channels.map(|channels| json(&channels)).transpose()?;
                return Ok(json!({ "channels": channels }));
            }
            "reset" => {
                library.buffer_reset(&buffer)?;
            }
            _ => return Err(no_step(op)),
        }
        Ok(json!({}))
    })
}

#[derive(Deserialize)]
pub(crate) struct HorizonArgs {
    ttl_ms: Double,
    dt_ms: Double,
}

pub(crate) fn horizon_max_len(library: &Library, args: &HorizonArgs) -> Result<Value, CallError> {
    let len = library.max_horizon_len(args.ttl_ms.0, args.dt_ms.0)?;
    Ok(json!({ "len": len }))
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

pub(crate) fn link_run(library: &Library, args: &LinkArgs<'_>) -> Result<Value, CallError> {
    let double = |value: Option<Double>| value.map(|Double(value)| value);
    let link = library.link(double(args.ref_loss), double(args.threshold))?;
    run(&args.steps, |op, step| match op {
        "frame" => {
            let Seen { seq } = parse(step)?;
            let LinkReport { last_seq, received, lost, loss_rate, burst } = library.link_on_frame(&link, seq)?;
            Ok(json!({
                "last_seq": last_seq,
                "received": received,
                "lost": lost,
                "loss_rate": crate::value::shown(loss_rate),
                "burst": burst,
            }))
        }
        _ => Err(no_step(op)),
    })
}

#[derive(Deserialize)]
pub(crate) struct CodecEncodeArgs<'a> {
    #[serde(borrow)]
    codec: &'a RawValue,
    #[serde(borrow)]
    sensor: Option<&'a RawValue>,
}

pub(crate) fn codec_encode(library: &Library, args: &CodecEncodeArgs<'_>) -> Result<Value, CallError> {
    let rates = if library.extended {
        let codec = library.codec(args.codec.get())?;
        library.codec_encode(&codec, args.sensor.map(RawValue::get))?
    } else {
        let sensor = args.sensor.ok_or(CallError::Unsupported)?;
        let sensor = frame(library, "sensor_frame", sensor)?;
        seed_codec(library, args.codec)?;
        library.encode_rates(args.codec.get(), &sensor)?
    };
    Ok(json!({ "rates": json(&rates)? }))
}

#[derive(Deserialize)]
pub(crate) struct CodecDecodeArgs<'a> {
    #[serde(borrow)]
    codec: &'a RawValue,
    #[serde(borrow)]
    rates: &'a RawValue,
    t: Double,
    seq: i64,
    #[serde(borrow)]
    frame_id: Cow<'a, str>,
    #[serde(borrow)]
    mode: Cow<'a, str>,
}

pub(crate) fn codec_decode(library: &Library, args: &CodecDecodeArgs<'_>) -> Result<Value, CallError> {
    let decode = Decode {
        codec: args.codec.get(),
        rates: args.rates.get(),
        t: args.t.0,
        seq: args.seq,
        frame_id: &args.frame_id,
        mode: &args.mode,
    };
    let command = if library.extended {
        library.codec_decode(&decode)?
    } else {
        expressible(args.rates)?;
        seed_codec(library, args.codec)?;
        if !decode.t.is_finite() {
            return Err(CallError::Unsupported);
        }
        library.decode_command(&decode)?
    };
    Ok(json!({ "command": json(&command)? }))
}

/// Whether the seed's functions can be given this codec. Nobody says in which form of JSON they read one, so
/// a library that refuses the plainest codec in the form of PROTOCOL.md is not asked for others.
fn seed_codec(library: &Library, codec: &RawValue) -> Result<(), CallError> {
    const PLAINEST: &str = r#"{"encoders":[{"channel":"c","component":0,"population":"p","value_range":[-1.0,1.0],"rate_range":[0.0,200.0]}],"decoders":[]}"#;
    const SENSOR: &str = r#"{"kind":"sensor_frame","ncp_version":"0.5","seq":1,"t":0.0,"frame_id":"world","channels":{"c":{"data":[0.0],"unit":null}}}"#;
    let form = if codec.get() == r#""uav""# {
        codec.get()
    } else {
        expressible(codec)?;
        PLAINEST
    };
    match library.encode_rates(form, SENSOR) {
        Ok(_) => Ok(()),
        Err(_) => Err(CallError::Unsupported),
    }
}

#[derive(Deserialize)]
pub(crate) struct ReflexArgs<'a> {
    #[serde(borrow)]
    config: &'a RawValue,
    #[serde(borrow)]
    sensor: Option<&'a RawValue>,
}

pub(crate) fn reflex_step(library: &Library, args: &ReflexArgs<'_>) -> Result<Value, CallError> {
    // The clock is nothing to a controller without memory.
    let sensor = args.sensor.map(RawValue::get);
    let command = library.reflex_step(args.config.get(), 0.0, sensor)?;
    Ok(json!({ "command": json(&command)? }))
}

#[derive(Deserialize)]
pub(crate) struct LoopArgs<'a> {
    period_ms: Double,
    #[serde(borrow)]
    limits: &'a RawValue,
    #[serde(borrow)]
    config: &'a RawValue,
    #[serde(borrow)]
    steps: Vec<&'a RawValue>,
}

#[derive(Deserialize)]
struct Sensed<'a> {
    #[serde(borrow)]
    sensor: &'a RawValue,
    now_s: Double,
}

pub(crate) fn loop_run(library: &Library, args: &LoopArgs<'_>) -> Result<Value, CallError> {
    let Double(period_ms) = args.period_ms;
    let control = library.control_loop(period_ms, args.limits.get(), args.config.get())?;
    run(&args.steps, |op, step| {
        match op {
            "sensor" => {
                let args: Sensed<'_> = parse(step)?;
                library.loop_on_sensor(&control, args.sensor.get(), args.now_s.0)?;
            }
            "tick" => {
                let Now { now_s } = parse(step)?;
                // The clock of a trace stands still within a tick.
                let (command, status) = library.loop_tick(&control, now_s.0, 0.0)?;
                return Ok(json!({ "command": json(&command)?, "status": json(&status)? }));
            }
            "reset" => {
                library.loop_reset(&control)?;
            }
            _ => return Err(no_step(op)),
        }
        Ok(json!({}))
    })
}

#[derive(Deserialize)]
pub(crate) struct SessionArgs<'a> {
    #[serde(borrow)]
    requests: Vec<Cow<'a, str>>,
}

pub(crate) fn session_run(library: &Library, args: &SessionArgs<'_>) -> Result<Value, CallError> {
    let service = library.service()?;
    let requests = args.requests.iter();
    let replies: Vec<String> =
        requests.map(|request| library.service_serve(&service, request)).collect::<Result<_, _>>()?;
    Ok(json!({ "replies": replies }))
}

/// Does the steps. One that the library refuses is an entry like others; one that it cannot do, or that
/// PROTOCOL.md does not allow, ends the call.
fn run<'a>(
    steps: &[&'a RawValue],
    mut each: impl FnMut(&str, &'a RawValue) -> Result<Value, CallError>,
) -> Result<Value, CallError> {
    #[derive(Deserialize)]
    struct Op<'a> {
        #[serde(borrow)]
        op: Cow<'a, str>,
    }

    let mut replies = Vec::with_capacity(steps.len());
    for step in steps {
        let Op { op } = parse(step)?;
        replies.push(match each(&op, step) {
            Err(CallError::Refused { code, message }) if code != "internal" => {
                json!({ "error": { "code": code, "message": message } })
            }
            reply => reply?,
        });
    }
    Ok(json!({ "steps": replies }))
}

fn no_step(op: &str) -> CallError {
    CallError::misfit(format_args!("{op:?} is not a step of this call"))
}
