//! The steps of a trace (PROTOCOL.md, section 4), and how they are done.

use std::borrow::Cow;

use serde::Deserialize;

use crate::args::{frame, parse};
use crate::error::CallError;
use crate::json::Raw;
use crate::reply::{Refusal, StepReply};
use crate::value::{Bytes, Double};

/// Does the steps. One that is refused, or that the peer cannot do, is an entry like others; one that breaks a rule, or
/// that PROTOCOL.md does not allow, ends the call.
///
/// # Errors
/// What ends the call.
pub fn run<'a, S: Step<'a>, E: From<CallError> + Into<CallError>>(
    steps: &[Raw<'a>],
    mut each: impl FnMut(S) -> Result<StepReply, E>,
) -> Result<Vec<StepReply>, E> {
    #[derive(Deserialize)]
    struct Op<'a> {
        #[serde(borrow)]
        op: Cow<'a, str>,
    }

    let mut replies = Vec::with_capacity(steps.len());
    for &step in steps {
        let Op { op } = parse(step)?;
        replies.push(match each(S::read(&op, step)?).map_err(E::into) {
            Err(error) if error.is_internal() => return Err(error.into()),
            Err(CallError::Refused { code, message }) => StepReply::Refused { error: Refusal { code, message } },
            Err(CallError::Unsupported) => StepReply::Unsupported { unsupported: true },
            reply => reply?,
        });
    }
    Ok(replies)
}

/// A step of one kind of trace.
pub trait Step<'a>: Sized {
    /// Reads the step of this name from its members.
    ///
    /// # Errors
    /// No such step belongs to the trace, or its members are others.
    fn read(op: &str, members: Raw<'a>) -> Result<Self, CallError>;
}

/// A step of `governor.run`.
#[derive(Debug)]
pub enum GovernorStep<'a> {
    /// A command is governed.
    Govern(Govern<'a>),
    /// The link's state is noted.
    NoteLink(NoteLink),
    /// The latch is released.
    Reset,
}

impl<'a> Step<'a> for GovernorStep<'a> {
    fn read(op: &str, members: Raw<'a>) -> Result<Self, CallError> {
        match op {
            "govern" => Ok(Self::Govern(parse(members)?)),
            "note_link" => Ok(Self::NoteLink(parse(members)?)),
            "reset" => Ok(Self::Reset),
            _ => Err(foreign(op)),
        }
    }
}

/// The members of a step `govern`.
#[derive(Debug, Deserialize)]
pub struct Govern<'a> {
    /// The fields of the command.
    #[serde(borrow)]
    pub command: Raw<'a>,
    /// The time, in seconds.
    pub now_s: Double,
    /// The fields of the sensor frame, if there is one.
    #[serde(borrow)]
    pub sensor: Option<Raw<'a>>,
    /// When it arrived, in seconds.
    pub last_sensor_s: Option<Double>,
}

/// The members of a step `note_link`.
#[derive(Debug, Deserialize)]
pub struct NoteLink {
    /// Whether the link is in a burst of loss.
    pub burst: bool,
}

/// A step of `watchdog.run`.
#[derive(Debug)]
pub enum WatchdogStep {
    /// A command arrives.
    Command(Stamp),
    /// Whether the plant has to hold.
    ShouldHold(Now),
    /// The watchdog starts anew.
    Reset,
}

impl<'a> Step<'a> for WatchdogStep {
    fn read(op: &str, members: Raw<'a>) -> Result<Self, CallError> {
        match op {
            "command" => Ok(Self::Command(parse(members)?)),
            "should_hold" => Ok(Self::ShouldHold(parse(members)?)),
            "reset" => Ok(Self::Reset),
            _ => Err(foreign(op)),
        }
    }
}

/// What a watchdog is told of a command.
#[derive(Debug, Deserialize)]
pub struct Stamp {
    /// When it arrives, in seconds.
    pub now_s: Double,
    /// How long it holds, in milliseconds.
    pub ttl_ms: Double,
    /// Its sequence number.
    pub seq: i64,
}

/// The time of a step, in seconds.
#[derive(Debug, Deserialize)]
pub struct Now {
    now_s: Double,
}

impl Now {
    /// In seconds.
    #[must_use]
    pub fn seconds(&self) -> f64 {
        self.now_s.0
    }
}

/// A step of `buffer.run`.
#[derive(Debug)]
pub enum BufferStep<'a> {
    /// A command arrives.
    Command(Arrival<'a>),
    /// What is actuated.
    Active(Now),
    /// The buffer starts anew.
    Reset,
}

impl<'a> Step<'a> for BufferStep<'a> {
    fn read(op: &str, members: Raw<'a>) -> Result<Self, CallError> {
        match op {
            "command" => Ok(Self::Command(parse(members)?)),
            "active" => Ok(Self::Active(parse(members)?)),
            "reset" => Ok(Self::Reset),
            _ => Err(foreign(op)),
        }
    }
}

/// A command frame that arrives at a plant.
#[derive(Debug, Deserialize)]
pub struct Arrival<'a> {
    #[serde(borrow)]
    text: Option<Cow<'a, str>>,
    base64: Option<Bytes>,
    /// When, in seconds.
    pub now_s: Double,
}

impl Arrival<'_> {
    /// The frame as it arrives, which need not be UTF-8.
    ///
    /// # Errors
    /// The step holds no frame, or two.
    pub fn frame(&self) -> Result<&[u8], CallError> {
        frame(self.text.as_deref(), self.base64.as_ref())
    }
}

/// A step of `link.run`.
#[derive(Debug)]
pub enum LinkStep {
    /// A frame arrives.
    Frame(Seen),
}

impl<'a> Step<'a> for LinkStep {
    fn read(op: &str, members: Raw<'a>) -> Result<Self, CallError> {
        match op {
            "frame" => Ok(Self::Frame(parse(members)?)),
            _ => Err(foreign(op)),
        }
    }
}

/// What a link monitor sees of a frame.
#[derive(Debug, Deserialize)]
pub struct Seen {
    /// Its sequence number.
    pub seq: i64,
}

/// A step of `loop.run`.
#[derive(Debug)]
pub enum LoopStep<'a> {
    /// A sensor frame arrives.
    Sensor(Sensed<'a>),
    /// The loop does a tick.
    Tick(Now),
    /// A supervisor resets it.
    Reset,
}

impl<'a> Step<'a> for LoopStep<'a> {
    fn read(op: &str, members: Raw<'a>) -> Result<Self, CallError> {
        match op {
            "sensor" => Ok(Self::Sensor(parse(members)?)),
            "tick" => Ok(Self::Tick(parse(members)?)),
            "reset" => Ok(Self::Reset),
            _ => Err(foreign(op)),
        }
    }
}

/// A sensor frame that arrives at a control loop.
#[derive(Debug, Deserialize)]
pub struct Sensed<'a> {
    /// Its fields.
    #[serde(borrow)]
    pub sensor: Raw<'a>,
    /// When, in seconds.
    pub now_s: Double,
}

fn foreign(op: &str) -> CallError {
    CallError::misfit(format_args!("{op:?} is not a step of this call"))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test fails by panicking")]
mod tests {
    use super::*;
    use crate::json;

    fn done(each: impl Fn(i64) -> Result<StepReply, CallError>) -> Result<Vec<StepReply>, CallError> {
        let steps: Vec<Raw<'_>> = json::read(r#"[{"op":"frame","seq":1},{"op":"frame","seq":2}]"#).unwrap();
        run(&steps, |LinkStep::Frame(Seen { seq })| each(seq))
    }

    #[test]
    fn a_step_that_is_refused_is_an_entry_and_the_trace_goes_on() {
        let replies = done(|seq| match seq {
            1 => Err(CallError::refused("value", "one")),
            _ => Ok(StepReply::Nothing {}),
        });
        let shown = json::write(&replies.unwrap()).unwrap();
        assert_eq!(shown, r#"[{"error":{"code":"value","message":"one"}},{}]"#);
    }

    #[test]
    fn a_step_that_the_peer_cannot_do_is_an_entry_too() {
        let replies = done(|seq| if seq == 1 { Err(CallError::Unsupported) } else { Ok(StepReply::Nothing {}) });
        assert_eq!(json::write(&replies.unwrap()).unwrap(), r#"[{"unsupported":true},{}]"#);
    }

    #[test]
    fn a_step_that_breaks_a_rule_ends_the_call() {
        let broken = CallError::internal("broken");
        assert_eq!(done(|_| Err(broken.clone())).unwrap_err(), broken);
        let steps: Vec<Raw<'_>> = json::read(r#"[{"op":"jump"}]"#).unwrap();
        assert!(run(&steps, |_: LoopStep<'_>| -> Result<StepReply, CallError> { unreachable!() }).is_err());
    }
}
