//! The calls with a trace (PROTOCOL.md, section 4): one function each, named after its call.

use ncp_adapter::json::Raw;
use ncp_adapter::reply::StepReply;
use ncp_adapter::steps::{
    BufferStep, Govern, GovernorStep, LinkStep, LoopStep, NoteLink, Seen, Sensed, Stamp, WatchdogStep, run,
};
use ncp_adapter::value::{Double, Fields};
use ncp_adapter::{CallError, args};

use crate::library::{Decode, Library, LinkReport, yes};
use crate::seed;

type Steps = Result<Vec<StepReply>, CallError>;

pub(crate) fn governor_run(library: &Library, args: &args::Governor<'_>) -> Steps {
    if !library.extended {
        return governed_once(library, args);
    }
    let governor = match args.capabilities() {
        None => library.governor(args.limits.get())?,
        Some(declared) => library.governor_of(&declared)?,
    };
    run(&args.steps, |step| {
        match step {
            GovernorStep::Govern(Govern { command, now_s, sensor, last_sensor_s }) => {
                // The governor wants to be told what a program leaves to the message's defaults.
                let command = library.build("command_frame", command.get())?;
                let (sensor, last_sensor_s) = (sensor.map(Raw::get), last_sensor_s.map(|Double(last_s)| last_s));
                let frame = library.governor_govern(&governor, &command, now_s.0, sensor, last_sensor_s)?;
                return Ok(StepReply::Frame { frame: Fields::of_text(frame)? });
            }
            GovernorStep::NoteLink(NoteLink { burst }) => library.governor_note_link(&governor, burst)?,
            GovernorStep::Reset => library.governor_reset(&governor)?,
        };
        Ok(StepReply::Nothing {})
    })
}

/// A trace for the seed's function, which has no state and takes frames: one step `govern` for the canonical
/// channels, in numbers that JSON has, with no sensor before time began.
fn governed_once(library: &Library, args: &args::Governor<'_>) -> Steps {
    if args.steps.len() != 1 || args.capabilities().is_some() {
        return Err(CallError::Unsupported);
    }
    run(&args.steps, |step| {
        let GovernorStep::Govern(step) = step else {
            return Err(CallError::Unsupported);
        };
        let last_sensor_s = match step.last_sensor_s {
            None => -1.0,
            Some(Double(last_s)) if last_s < 0.0 => return Err(CallError::Unsupported),
            Some(Double(last_s)) => last_s,
        };
        seed::expressible(args.limits)?;
        let command = seed::frame(library, "command_frame", step.command)?;
        let sensor = step.sensor.map(|fields| seed::frame(library, "sensor_frame", fields)).transpose()?;
        let (limits, Double(now_s)) = (args.limits.get(), step.now_s);
        let frame = library.govern(limits, &command, now_s, sensor.as_deref(), last_sensor_s)?;
        Ok(StepReply::Frame { frame: Fields::of_text(frame)? })
    })
}

pub(crate) fn watchdog_run(library: &Library, args: &args::Watchdog<'_>) -> Steps {
    let watchdog = library.watchdog()?;
    run(&args.steps, |step| {
        match step {
            WatchdogStep::Command(Stamp { now_s, ttl_ms, seq }) => {
                library.watchdog_on_command(&watchdog, now_s.0, ttl_ms.0, seq)?
            }
            WatchdogStep::ShouldHold(now) => {
                let hold = yes(library.watchdog_should_hold(&watchdog, now.seconds())?)?;
                return Ok(StepReply::Hold { hold });
            }
            WatchdogStep::Reset => library.watchdog_reset(&watchdog)?,
        };
        Ok(StepReply::Nothing {})
    })
}

pub(crate) fn buffer_run(library: &Library, args: &args::Buffer<'_>) -> Steps {
    let buffer = library.buffer()?;
    run(&args.steps, |step| {
        match step {
            BufferStep::Command(arrival) => library.buffer_on_frame(&buffer, arrival.frame()?, arrival.now_s.0)?,
            BufferStep::Active(now) => {
                let channels = library.buffer_active(&buffer, now.seconds())?;
                return Ok(StepReply::Active { channels: channels.map(Fields::of_text).transpose()? });
            }
            BufferStep::Reset => library.buffer_reset(&buffer)?,
        };
        Ok(StepReply::Nothing {})
    })
}

pub(crate) fn link_run(library: &Library, args: &args::Link<'_>) -> Steps {
    let double = |value: Option<Double>| value.map(|Double(value)| value);
    let link = library.link(double(args.ref_loss), double(args.threshold))?;
    run(&args.steps, |LinkStep::Frame(Seen { seq })| {
        let LinkReport { last_seq, received, lost, loss_rate, burst } = library.link_on_frame(&link, seq)?;
        Ok(StepReply::Link { last_seq, received, lost, loss_rate: Double(loss_rate), burst })
    })
}

pub(crate) fn codec_encode(library: &Library, args: &args::CodecEncode<'_>) -> Result<Fields, CallError> {
    let rates = if library.extended {
        let codec = library.codec(args.codec.get())?;
        library.codec_encode(&codec, args.sensor.map(Raw::get))?
    } else {
        let sensor = args.sensor.ok_or(CallError::Unsupported)?;
        let sensor = seed::frame(library, "sensor_frame", sensor)?;
        library.encode_rates(&seed::codec(args.codec)?, &sensor)?
    };
    Fields::of_text(rates)
}

pub(crate) fn codec_decode(library: &Library, args: &args::CodecDecode<'_>) -> Result<Fields, CallError> {
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
        seed::expressible(args.rates)?;
        if !decode.t.is_finite() {
            return Err(CallError::Unsupported);
        }
        library.decode_command(&Decode { codec: &seed::codec(args.codec)?, ..decode })?
    };
    Fields::of_text(command)
}

pub(crate) fn reflex_step(library: &Library, args: &args::Reflex<'_>) -> Result<Fields, CallError> {
    // The clock is nothing to a controller without memory.
    let sensor = args.sensor.map(Raw::get);
    Fields::of_text(library.reflex_step(args.config.get(), 0.0, sensor)?)
}

pub(crate) fn loop_run(library: &Library, args: &args::Loop<'_>) -> Steps {
    let control = library.control_loop(args.period_ms.0, args.limits.get(), args.config.get())?;
    run(&args.steps, |step| {
        match step {
            LoopStep::Sensor(Sensed { sensor, now_s }) => library.loop_on_sensor(&control, sensor.get(), now_s.0)?,
            LoopStep::Tick(now) => {
                // The clock of a trace stands still within a tick.
                let (command, status) = library.loop_tick(&control, now.seconds(), 0.0)?;
                let (command, status) = (Fields::of_text(command)?, Fields::of_text(status)?);
                return Ok(StepReply::Tick { command, status });
            }
            LoopStep::Reset => library.loop_reset(&control)?,
        };
        Ok(StepReply::Nothing {})
    })
}

pub(crate) fn session_run(library: &Library, args: &args::Session<'_>) -> Result<Vec<String>, CallError> {
    let service = library.service()?;
    args.requests.iter().map(|request| library.service_serve(&service, request)).collect()
}
