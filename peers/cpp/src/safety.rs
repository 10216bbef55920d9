//! Beyond the seed: the objects that hold or stop a plant.
//!
//! They have a state, and one thread at a time may use each. A NULL object is an error, and an error
//! holds: `-1` is true where a plant asks whether it should hold.

use std::ffi::c_char;
use std::mem::MaybeUninit;
use std::ptr;

use ncp_spec::resilience::{
    ActionBuffer, CommandWatchdog, DEFAULT_REF_LOSS, DEFAULT_THRESHOLD, LinkMonitor, is_estop, max_horizon_len,
};
use ncp_spec::safety::SafetyGovernor;
use ncp_spec::wire::Message;

use crate::abi::{Handle, Text, bytes, entry, required, text_out, yes};
use crate::json;

/// Stands at the end of a control loop and lets a command pass only when it is safe.
pub struct Governor(Handle<SafetyGovernor>);

/// A governor with these limits, a JSON object, for the canonical channels. A limit that it does not know
/// is an error.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_governor_new(limits: Text<'_>) -> Option<Box<Governor>> {
    entry(|| {
        let limits = json::limits(limits.required("limits")?)?;
        let governor = SafetyGovernor::new(&limits);
        Ok(Some(Box::new(Governor(Handle::new(governor)))))
    })
}

/// A governor for the limits and the channels that a plant declares: the fields of capabilities.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_governor_from_capabilities(capabilities: Text<'_>) -> Option<Box<Governor>> {
    entry(|| {
        let capabilities = json::capabilities(capabilities.required("capabilities")?)?;
        let governor = SafetyGovernor::from_capabilities(&capabilities);
        Ok(Some(Box::new(Governor(Handle::new(governor)))))
    })
}

/// What may be sent of a command, as all of its fields; ncp_encode makes the frame. The command says its
/// mode. The sensor may be NULL; last_sensor_s is when it was received, on the clock of now_s, in seconds,
/// or NULL for none yet. On NULL send nothing, so that the plant holds; an ESTOP latches even so.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_governor_govern(
    governor: Option<&mut Governor>,
    command: Text<'_>,
    now_s: f64,
    sensor: Text<'_>,
    last_sensor_s: Option<&f64>,
) -> *mut c_char {
    entry(|| {
        let Governor(governor) = required(governor, "governor")?;
        let text = command.required("command")?;
        governor.with(|governor| {
            let command = json::command(text).inspect_err(|_| {
                // An ESTOP is never lost. [NCP-RES-022]
                if is_estop(text.as_bytes()) {
                    governor.note_link(true);
                }
            });
            let mut command = command?;
            let sensor = json::optional_sensor(sensor.optional("sensor")?)?;
            governor.govern(&mut command, now_s, sensor.as_ref(), last_sensor_s.copied());
            text_out(Message::from(command).fields())
        })
    })
}

/// Takes note of the link: a burst of losses (other than 0) latches ESTOP. 1, or -1.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_governor_note_link(governor: Option<&mut Governor>, burst: i32) -> i32 {
    entry(|| {
        required(governor, "governor")?.0.with(|governor| {
            governor.note_link(burst != 0);
            Ok(1)
        })
    })
}

/// Clears the latch, by a supervisor's decision. A config fault stays. 1, or -1.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_governor_reset(governor: Option<&mut Governor>) -> i32 {
    entry(|| {
        required(governor, "governor")?.0.with(|governor| {
            governor.reset();
            Ok(1)
        })
    })
}

/// Whether ESTOP is latched: 1 yes, 0 no, -1 error.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_governor_is_stopped(governor: Option<&mut Governor>) -> i32 {
    entry(|| {
        let Governor(governor) = required(governor, "governor")?;
        governor.with(|governor| Ok(yes(governor.is_stopped())))
    })
}

/// Whether a limit cannot act on the channels, so that this governor always holds: 1 yes, 0 no, -1 error.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_governor_has_config_fault(governor: Option<&mut Governor>) -> i32 {
    entry(|| {
        let Governor(governor) = required(governor, "governor")?;
        governor.with(|governor| Ok(yes(governor.has_config_fault())))
    })
}

/// Frees a governor. NULL is nothing.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_governor_free(governor: Option<Box<Governor>>) {
    entry(|| {
        drop(governor);
        Ok(())
    });
}

/// Tells a plant to hold when commands stay away.
pub struct Watchdog(Handle<CommandWatchdog>);

/// A watchdog that has seen no command, so that it holds.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_watchdog_new() -> Option<Box<Watchdog>> {
    entry(|| Ok(Some(Box::new(Watchdog(Handle::new(CommandWatchdog::new()))))))
}

/// Takes note of a command: received at now_s in seconds, live for ttl_ms. 1 if its seq advances, so that it
/// refreshes the deadline, else 0; -1 error.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_watchdog_on_command(watchdog: Option<&mut Watchdog>, now_s: f64, ttl_ms: f64, seq: i64) -> i32 {
    entry(|| {
        let Watchdog(watchdog) = required(watchdog, "watchdog")?;
        watchdog.with(|watchdog| Ok(yes(watchdog.on_command(now_s, ttl_ms, seq))))
    })
}

/// Whether the plant has to hold at now_s: 0 is no, and everything else is yes, an error (-1) too.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_watchdog_should_hold(watchdog: Option<&mut Watchdog>, now_s: f64) -> i32 {
    entry(|| {
        let Watchdog(watchdog) = required(watchdog, "watchdog")?;
        watchdog.with(|watchdog| Ok(yes(watchdog.should_hold(now_s))))
    })
}

/// Forgets everything, by a supervisor's decision: it holds until a new command comes. 1, or -1.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_watchdog_reset(watchdog: Option<&mut Watchdog>) -> i32 {
    entry(|| {
        required(watchdog, "watchdog")?.0.with(|watchdog| {
            watchdog.reset();
            Ok(1)
        })
    })
}

/// Frees a watchdog. NULL is nothing.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_watchdog_free(watchdog: Option<Box<Watchdog>>) {
    entry(|| {
        drop(watchdog);
        Ok(())
    });
}

/// Keeps the newest command and replays its horizon.
pub struct Buffer(Handle<ActionBuffer>);

/// A buffer without a command.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_buffer_new() -> Option<Box<Buffer>> {
    entry(|| Ok(Some(Box::new(Buffer(Handle::new(ActionBuffer::new()))))))
}

/// Takes a command_frame as it arrives, at now_s. 1, or -1 if it is rejected. An ESTOP latches however torn its
/// frame is, which is 1.
///
/// # Safety
/// The frame has that many bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ncp_buffer_on_frame(
    buffer: Option<&mut Buffer>,
    frame: *const u8,
    frame_len: usize,
    now_s: f64,
) -> i32 {
    entry(|| {
        let Buffer(buffer) = required(buffer, "buffer")?;
        // SAFETY: as this function demands.
        let frame = unsafe { bytes(frame, frame_len, "frame")? };
        buffer.with(|buffer| {
            buffer.on_frame(frame, now_s)?;
            Ok(1)
        })
    })
}

/// What the plant does at now_s: 1 and its channels, a JSON object that the caller frees; 0 and NULL when it
/// holds; -1 and NULL on an error, which holds as well.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_buffer_active(
    buffer: Option<&mut Buffer>,
    now_s: f64,
    channels: Option<&mut MaybeUninit<*mut c_char>>,
) -> i32 {
    entry(|| {
        let out = required(channels, "channels")?.write(ptr::null_mut());
        let Buffer(buffer) = required(buffer, "buffer")?;
        buffer.with(|buffer| {
            let Some(channels) = buffer.active(now_s) else {
                return Ok(0);
            };
            *out = text_out(json::channels_out(channels)?)?;
            Ok(1)
        })
    })
}

/// Clears the latch, the held command and the last seq, by a supervisor's decision: nothing moves until a
/// new command comes. 1, or -1.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_buffer_reset(buffer: Option<&mut Buffer>) -> i32 {
    entry(|| {
        required(buffer, "buffer")?.0.with(|buffer| {
            buffer.reset();
            Ok(1)
        })
    })
}

/// Whether ESTOP is latched: 0 is no, and everything else is yes, an error (-1) too.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_buffer_is_stopped(buffer: Option<&mut Buffer>) -> i32 {
    entry(|| {
        let Buffer(buffer) = required(buffer, "buffer")?;
        buffer.with(|buffer| Ok(yes(buffer.is_stopped())))
    })
}

/// Frees a buffer. NULL is nothing.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_buffer_free(buffer: Option<Box<Buffer>>) {
    entry(|| {
        drop(buffer);
        Ok(())
    });
}

/// The longest horizon of steps of dt_ms that is of use within ttl_ms; 0 for what are no durations.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_max_horizon_len(ttl_ms: f64, dt_ms: f64) -> usize {
    entry(|| Ok(max_horizon_len(ttl_ms, dt_ms)))
}

/// Counts what a stream loses, and sees a burst of losses.
pub struct Link(Handle<LinkMonitor>);

/// How a stream arrives.
#[repr(C)]
pub struct LinkReport {
    /// The highest seq that was seen.
    pub last_seq: i64,
    /// Frames that arrived.
    pub received: i64,
    /// Frames that are missing.
    pub lost: i64,
    /// Lost of those expected, 0 to 1.
    pub loss_rate: f64,
    /// Whether losses come in a burst.
    pub burst: bool,
}

/// A monitor that has seen nothing. NULL is the default: a loss of 0.05 that is taken for normal, and a
/// threshold of 5.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_link_new(ref_loss: Option<&f64>, threshold: Option<&f64>) -> Option<Box<Link>> {
    entry(|| {
        let link = LinkMonitor::new(
            ref_loss.copied().unwrap_or(DEFAULT_REF_LOSS),
            threshold.copied().unwrap_or(DEFAULT_THRESHOLD),
        );
        Ok(Some(Box::new(Link(Handle::new(link)))))
    })
}

/// Takes note of a frame: every one that arrives. 1, or -1.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_link_on_frame(link: Option<&mut Link>, seq: i64) -> i32 {
    entry(|| {
        required(link, "link")?.0.with(|link| {
            link.on_frame(seq);
            Ok(1)
        })
    })
}

/// How the stream arrives so far. 1, or -1.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_link_report(link: Option<&mut Link>, report: Option<&mut MaybeUninit<LinkReport>>) -> i32 {
    entry(|| {
        let out = required(report, "report")?;
        let report = required(link, "link")?.0.with(|link| Ok(link.report()))?;
        out.write(report.into());
        Ok(1)
    })
}

/// Frees a monitor. NULL is nothing.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_link_free(link: Option<Box<Link>>) {
    entry(|| {
        drop(link);
        Ok(())
    });
}

impl From<ncp_spec::resilience::LinkReport> for LinkReport {
    fn from(report: ncp_spec::resilience::LinkReport) -> Self {
        let ncp_spec::resilience::LinkReport { last_seq, received, lost, loss_rate, burst } = report;
        Self { last_seq, received, lost, loss_rate, burst }
    }
}

#[cfg(test)]
mod tests {
    use std::ffi::CStr;

    use super::*;

    fn govern(governor: &mut Governor, command: &CStr) -> Option<String> {
        let text = ncp_governor_govern(Some(governor), command.into(), 1.0, Text::NULL, Some(&1.0));
        if text.is_null() {
            return None;
        }
        // SAFETY: it is read, then freed, once.
        unsafe {
            let said = CStr::from_ptr(text).to_str().unwrap().to_owned();
            crate::abi::free_text(text);
            Some(said)
        }
    }

    #[test]
    fn an_estop_that_cannot_be_read_latches_the_governor_all_the_same() {
        let mut governor = ncp_governor_new(c"{}".into()).unwrap();
        let torn = c"{\"kind\":\"command_frame\",\"mode\":\"estop\",\"seq\":\"1\"}";
        assert_eq!(govern(&mut governor, torn), None);
        let fine = c"{\"mode\":\"active\",\"seq\":2}";
        assert!(govern(&mut governor, fine).unwrap().contains(r#""estop""#));
        assert_eq!(ncp_governor_is_stopped(Some(&mut governor)), 1);
    }

    #[test]
    fn a_missing_object_holds_the_plant() {
        assert_ne!(ncp_watchdog_should_hold(None, 0.0), 0);
        assert_ne!(ncp_buffer_is_stopped(None), 0);
        let mut channels = MaybeUninit::uninit();
        assert_ne!(ncp_buffer_active(None, 0.0, Some(&mut channels)), 1);
    }
}
