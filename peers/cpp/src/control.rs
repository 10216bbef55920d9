//! Beyond the seed: what makes commands out of what is sensed. One thread at a time may use an object.

use std::ffi::c_char;
use std::mem::MaybeUninit;
use std::ptr;

use ncp_spec::codec::RateCodec;
use ncp_spec::control::{ControlLoop, Controller as _, LoopConfig, ReflexController};
use ncp_spec::resilience::LinkMonitor;
use ncp_spec::safety::SafetyGovernor;
use ncp_spec::wire::Message;

use crate::abi::{Handle, Text, entry, required, text_out, yes};
use crate::json;
use crate::seed::stamp;

/// Ties components of channels to populations of neurons.
pub struct Codec(RateCodec);

/// A codec from its JSON text: "uav" in quotes for the default one, or an object of encoders and decoders,
/// arrays of mappings: channel, component, population, and, if need be, value_range, rate_range, unit. An
/// object without them is read as ncp_encode_rates reads one.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_codec_new(codec: Text<'_>) -> Option<Box<Codec>> {
    entry(|| {
        let codec = json::codec(codec.required("codec")?)?;
        Ok(Some(Box::new(Codec(codec))))
    })
}

/// The rates in Hz by population, a JSON object, for the fields of a sensor frame, or NULL for none.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_codec_encode(codec: Option<&Codec>, sensor: Text<'_>) -> *mut c_char {
    entry(|| {
        let Codec(codec) = required(codec, "codec")?;
        let sensor = json::optional_sensor(sensor.optional("sensor")?)?;
        text_out(json::rates_out(&codec.encode(sensor.as_ref()))?)
    })
}

/// All fields of the command for these rates. NULL for frame_id and mode is as in ncp_decode_command.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_codec_decode(
    codec: Option<&Codec>,
    rates: Text<'_>,
    t: f64,
    seq: i64,
    frame_id: Text<'_>,
    mode: Text<'_>,
) -> *mut c_char {
    entry(|| {
        let Codec(codec) = required(codec, "codec")?;
        let rates = json::rates(rates.required("rates")?)?;
        let (frame_id, mode) = stamp(frame_id, mode)?;
        let command = codec.decode(&rates, t, seq, frame_id, mode);
        text_out(Message::from(command).fields())
    })
}

/// Frees a codec. NULL is nothing.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_codec_free(codec: Option<Box<Codec>>) {
    entry(|| {
        drop(codec);
        Ok(())
    });
}

/// Steers towards a target.
pub struct Reflex(Handle<ReflexController>);

/// A controller from a JSON object with any of target (three metres), kp, kd, max_speed. Gains that cannot
/// be used are an error.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_reflex_new(config: Text<'_>) -> Option<Box<Reflex>> {
    entry(|| {
        let controller = ReflexController::new(json::reflex(config.required("config")?)?)?;
        Ok(Some(Box::new(Reflex(Handle::new(controller)))))
    })
}

/// All fields of the command for the fields of a sensor frame, or NULL for none, at now_s in seconds.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_reflex_step(reflex: Option<&mut Reflex>, now_s: f64, sensor: Text<'_>) -> *mut c_char {
    entry(|| {
        let Reflex(reflex) = required(reflex, "reflex")?;
        let sensor = json::optional_sensor(sensor.optional("sensor")?)?;
        reflex.with(|reflex| {
            let command = reflex.step(now_s, sensor.as_ref());
            text_out(Message::from(command).fields())
        })
    })
}

/// Frees a controller. NULL is nothing.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_reflex_free(reflex: Option<Box<Reflex>>) {
    entry(|| {
        drop(reflex);
        Ok(())
    });
}

/// The newest sensor in, one governed command out, a tick at a time.
pub struct Loop(Handle<ControlLoop<ReflexController>>);

/// A loop of a reflex controller, a governor with the canonical channels, and a link monitor, that ticks
/// every period_ms.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_loop_new(period_ms: f64, limits: Text<'_>, config: Text<'_>) -> Option<Box<Loop>> {
    entry(|| {
        let limits = json::limits(limits.required("limits")?)?;
        let controller = ReflexController::new(json::reflex(config.required("config")?)?)?;
        let control = ControlLoop::new(
            LoopConfig { period_ms },
            controller,
            SafetyGovernor::new(&limits),
            LinkMonitor::default(),
        )?;
        Ok(Some(Box::new(Loop(Handle::new(control)))))
    })
}

/// Takes the fields of a sensor frame, every one that arrives, at now_s. 1 if it is the newest, else 0; -1
/// error.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_loop_on_sensor(control: Option<&mut Loop>, sensor: Text<'_>, now_s: f64) -> i32 {
    entry(|| {
        let Loop(control) = required(control, "loop")?;
        let sensor = json::sensor(sensor.required("sensor")?)?;
        control.with(|control| Ok(yes(control.on_sensor(sensor, now_s))))
    })
}

/// One tick at now_s: all fields of the command and of the status that are to be sent, which the caller
/// frees. took_ms is how long the tick before it took. 1; or -1, and both are NULL: send nothing, so that
/// the plant holds.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_loop_tick(
    control: Option<&mut Loop>,
    now_s: f64,
    took_ms: f64,
    command: Option<&mut MaybeUninit<*mut c_char>>,
    status: Option<&mut MaybeUninit<*mut c_char>>,
) -> i32 {
    entry(|| {
        let command = required(command, "command")?.write(ptr::null_mut());
        let status = required(status, "status")?.write(ptr::null_mut());
        let Loop(control) = required(control, "loop")?;
        let tick = control.with(|control| Ok(control.tick(now_s, took_ms)))?;
        // The first is handed over only when nothing can fail any more.
        let said = Message::from(tick.status).fields();
        let sent = text_out(Message::from(tick.command).fields())?;
        match text_out(said) {
            Ok(said) => {
                (*command, *status) = (sent, said);
                Ok(1)
            }
            Err(refusal) => {
                // SAFETY: it was made above, and is not used again.
                unsafe { crate::abi::free_text(sent) };
                Err(refusal)
            }
        }
    })
}

/// Clears the latch of the governor, by a supervisor's decision. 1, or -1.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_loop_reset(control: Option<&mut Loop>) -> i32 {
    entry(|| {
        required(control, "loop")?.0.with(|control| {
            control.governor_mut().reset();
            Ok(1)
        })
    })
}

/// Frees a loop. NULL is nothing.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_loop_free(control: Option<Box<Loop>>) {
    entry(|| {
        drop(control);
        Ok(())
    });
}
