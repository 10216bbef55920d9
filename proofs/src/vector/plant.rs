//! Counterexamples as traces of `buffer.run`: what a plant follows, and when it holds.
//!
//! What a case expects is what the action buffer of the specification answers to the frames as text. As with the
//! gates, a small buffer around a kernel has to answer as the specification's does when the kernel is the one of
//! production, and otherwise when it is the broken one.

use std::panic::{AssertUnwindSafe, catch_unwind};

use ncp_kernel::{Mode, Received};
use ncp_spec::resilience::ActionBuffer;
use serde_json::{Value, json};

use super::{Calls, Inputs, State, WhyNone, number};
use crate::kernel::{Kernel, Production};
use crate::properties::latch::HORIZONS;

/// A step of a trace.
#[derive(Debug, Clone)]
pub enum Step {
    /// A command arrives.
    Command(Command),
    /// What does the plant do at this time?
    Active(f64),
    /// A reset.
    Reset,
}

/// A command as it arrives at a plant. Tick k has the velocity k + 1.
#[derive(Debug, Clone)]
pub struct Command {
    mode: Mode,
    now: f64,
    ttl: f64,
    seq: i64,
    dt: Option<f64>,
    steps: usize,
}

/// A case that the kernel behind the calls fails, of traces that a counterexample suggests.
///
/// # Errors
/// There are no such traces, or no trace shows it.
pub(super) fn case(property: &str, calls: &Calls, inputs: &Inputs<'_>) -> Result<Value, WhyNone> {
    let mut none = WhyNone::NoCall;
    for steps in traces(property, inputs).unwrap_or_default() {
        let texts = steps.iter().map(Step::json).collect::<Option<Vec<_>>>();
        let (Some(texts), Some(expected)) = (texts, answers(&steps)) else {
            none = none.max(WhyNone::NoFrame);
            continue;
        };
        let (sound, broken) = (run::<Production>(&steps), (calls.buffer)(&steps));
        if sound.as_ref() != Some(&expected) || broken.is_none() {
            continue;
        }
        if broken == sound {
            none = none.max(WhyNone::Alike);
            continue;
        }
        return Ok(json!({
            "roles": ["body"],
            "call": "buffer.run",
            "args": { "steps": texts },
            "expect": { "relation": "pattern", "value": { "steps": expected } },
        }));
    }
    Err(none)
}

/// What the action buffer of the specification answers; none if it does not take a frame.
#[must_use]
pub fn answers(steps: &[Step]) -> Option<Vec<Value>> {
    let mut buffer = ActionBuffer::new();
    let steps = steps.iter().map(|step| match step {
        Step::Command(command) => {
            buffer.on_frame(command.text()?.as_bytes(), command.now).ok()?;
            Some(json!({}))
        }
        Step::Active(now) => {
            let channels = buffer.active(*now).map(|channels| {
                let channels = channels.iter().map(|(name, channel)| {
                    let data: Vec<Value> = channel.data.iter().map(|x| number(*x)).collect();
                    (name.to_string(), json!({ "data": data, "unit": channel.unit }))
                });
                Value::from(channels.collect::<serde_json::Map<_, _>>())
            });
            Some(json!({ "channels": channels }))
        }
        Step::Reset => {
            buffer.reset();
            Some(json!({}))
        }
    });
    steps.collect()
}

/// What a small buffer around a kernel answers; none if the kernel panics.
#[must_use]
pub fn run<K: Kernel>(steps: &[Step]) -> Option<Vec<Value>> {
    catch_unwind(AssertUnwindSafe(|| follow::<K>(steps))).ok()
}

fn follow<K: Kernel>(steps: &[Step]) -> Vec<Value> {
    let mut plant = K::plant::<f64, i64>();
    let mut followed = None;
    let steps = steps.iter().map(|step| match step {
        Step::Command(command) => {
            let (mode, seq) = (command.mode, command.seq);
            let answer = K::plant_command(&mut plant, mode, command.now, command.ttl, seq);
            if answer == Received::Accepted {
                followed = Some(command);
            }
            json!({})
        }
        Step::Active(now) => {
            let (dt, steps) = followed.map_or((None, 0), |command| (command.dt, command.steps));
            let tick = K::plant_active(&mut plant, *now, dt, steps);
            // A buffer that follows nothing has no channels, and a horizon no more ticks than it has.
            let channels = tick.map(|tick| match followed {
                Some(_) if tick <= steps => json!({ "velocity_setpoint": setpoint(tick) }),
                Some(_) => Value::Null,
                None => json!({}),
            });
            json!({ "channels": channels })
        }
        Step::Reset => {
            K::plant_reset(&mut plant);
            json!({})
        }
    });
    steps.collect()
}

#[expect(clippy::cast_precision_loss)]
fn setpoint(tick: usize) -> Value {
    json!({ "data": [tick as f64 + 1.0, 0.0, 0.0], "unit": "m/s" })
}

impl Command {
    /// The frame as it arrives; none if JSON lacks one of its numbers.
    fn text(&self) -> Option<String> {
        if !self.ttl.is_finite() || self.dt.is_some_and(|dt| !dt.is_finite()) {
            return None;
        }
        let horizon = (1..=self.steps).map(|tick| json!({ "velocity_setpoint": setpoint(tick) }));
        // Without a version, which a plant reads as its own: what is kept as evidence is that of every version.
        let frame = json!({
            "kind": "command_frame", "seq": self.seq, "t": 0.0, "frame_id": "world", "mode": self.mode.as_str(),
            "ttl_ms": self.ttl, "channels": { "velocity_setpoint": setpoint(0) },
            "horizon": horizon.collect::<Vec<_>>(), "horizon_dt_ms": self.dt,
        });
        Some(frame.to_string())
    }
}

impl Step {
    fn json(&self) -> Option<Value> {
        Some(match self {
            Self::Command(command) => {
                json!({ "op": "command", "text": command.text()?, "now_s": number(command.now) })
            }
            Self::Active(now) => json!({ "op": "active", "now_s": number(*now) }),
            Self::Reset => json!({ "op": "reset" }),
        })
    }
}

/// Traces in which the plant has to decide as in a counterexample, by its inputs.
fn traces(property: &str, inputs: &Inputs<'_>) -> Option<Vec<Vec<Step>>> {
    let command = |mode, now, ttl, seq| Step::Command(Command { mode, now, ttl, seq, dt: None, steps: 0 });
    Some(match property {
        "watchdog/order" => {
            let seq = inputs.seq("seq")?;
            let last = inputs.seq("last");
            let first = last.map(|last| command(Mode::Active, 0.0, 1000.0, last));
            [Mode::Hold, Mode::Active]
                .map(|mode| {
                    let mut steps: Vec<Step> = first.iter().cloned().collect();
                    steps.push(command(mode, 0.5, 1000.0, seq));
                    // Where the first command has ended and the second has not; and before.
                    steps.extend([Step::Active(0.75), Step::Active(1.25)]);
                    steps
                })
                .to_vec()
        }
        "watchdog/step" | "latch/plant" => step(property, inputs)?,
        "latch/plant-sequence" => vec![sequence(inputs)],
        _ => return None,
    })
}

/// The state, the event and what shows the state after it.
fn step(property: &str, inputs: &Inputs<'_>) -> Option<Vec<Vec<Step>>> {
    let is_plant = property == "latch/plant";
    let (dt, steps) = match is_plant.then(|| inputs.optional("dt")).flatten() {
        Some(dt) => (dt, inputs.choice("steps").and_then(|nth| HORIZONS.get(nth).copied()).unwrap_or(0)),
        None => (None, 0),
    };
    let command = |mode, now, ttl, seq| Step::Command(Command { mode, now, ttl, seq, dt, steps });
    let state = inputs.state()?;
    let last = inputs.seq("last");
    let mut base = Vec::new();
    if state == State::Followed {
        let (received, ttl) = (inputs.double("received")?, inputs.double("ttl")?);
        base.push(command(Mode::Active, received, ttl, last?));
    }
    if state == State::Held {
        base.extend([command(Mode::Active, 0.0, 1000.0, last?), command(Mode::Hold, 0.0, 0.0, last?)]);
    }
    if inputs.choice("was_stopped") == Some(1) {
        base.push(command(Mode::Estop, 0.0, 0.0, 0));
    }
    let mut times: Vec<f64> = Vec::new();
    match (inputs.choice("event"), is_plant) {
        // A check failed before the event.
        (None, _) => {}
        (Some(0), _) => {
            let mode = match is_plant {
                true => super::mode(inputs.choice("mode")?)?,
                false => Mode::Active,
            };
            let (now, ttl) = (inputs.double("now")?, inputs.double("new_ttl")?);
            base.push(command(mode, now, ttl, inputs.seq("seq")?));
        }
        (Some(1), false) => base.push(command(Mode::Hold, 0.0, 0.0, inputs.seq("seq")?)),
        (Some(1), true) | (Some(2), false) => base.push(Step::Active(inputs.double("now")?)),
        (Some(3), false) => return None,
        (Some(3), true) => base.push(command(Mode::Estop, 0.0, 0.0, 0)),
        _ => base.push(Step::Reset),
    }
    times.extend(["now", "received", "later"].iter().filter_map(|name| inputs.double(name)));
    // The state after it shows in what the plant does at some time, or with a further command.
    let mut traces: Vec<Vec<Step>> = Vec::new();
    let mut follow = |more: &[Step]| traces.push([&base[..], more].concat());
    for time in &times {
        follow(&[Step::Active(*time)]);
    }
    let seqs = [inputs.seq("seq"), last, last.map(|last| last.wrapping_add(1)), Some(0), Some(i64::MIN)];
    for seq in seqs.into_iter().flatten() {
        for mode in [Mode::Active, Mode::Hold] {
            follow(&[command(mode, 1.0, 1000.0, seq), Step::Active(1.0)]);
        }
    }
    Some(traces)
}

/// The events of the harness, each as it stands there.
fn sequence(inputs: &Inputs<'_>) -> Vec<Step> {
    let mut seqs = inputs.seqs("seq").into_iter();
    let mut steps = Vec::new();
    for event in inputs.choices("event") {
        let mode = match event {
            0 => Mode::Active,
            1 => Mode::Hold,
            2 => Mode::Estop,
            3 => {
                steps.push(Step::Active(1.0));
                continue;
            }
            _ => {
                steps.push(Step::Reset);
                continue;
            }
        };
        steps.push(Step::Command(Command {
            mode,
            now: 1.0,
            ttl: 500.0,
            seq: seqs.next().unwrap_or(0),
            dt: None,
            steps: 0,
        }));
    }
    steps.push(Step::Active(1.0));
    steps
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::harness::harness;
    use crate::properties::PROPERTIES;

    #[test]
    fn the_small_buffer_answers_as_that_of_the_specification() {
        let mut moving = 0;
        for property in PROPERTIES {
            let harness = harness::<Production>(property.id).unwrap();
            for seed in 0..300 {
                let found = super::super::tests::sampled(&harness, seed);
                for steps in traces(property.id, &Inputs(&found)).unwrap_or_default() {
                    let Some(expected) = answers(&steps) else {
                        continue;
                    };
                    assert_eq!(run::<Production>(&steps).unwrap(), expected, "{steps:?}");
                    moving += usize::from(expected.iter().any(|a| a["channels"].is_object()));
                }
            }
        }
        assert!(moving > 100, "{moving}");
    }
}
