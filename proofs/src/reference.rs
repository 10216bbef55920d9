//! A watchdog in a few lines, from the text's sentences: what a case of a vector expects, whatever the kernel does.

use serde_json::{Value, json};

/// A step of `watchdog.run`.
#[derive(Debug, Clone, Copy)]
pub enum Event {
    /// A command: the clock in seconds, the ttl in ms, the seq.
    Command(f64, f64, i64),
    /// A reading of the clock, in seconds.
    ShouldHold(f64),
    /// A reset.
    Reset,
}

/// What the text's watchdog answers to a trace.
#[must_use]
pub fn run(events: &[Event]) -> Vec<Value> {
    let mut last: Option<i64> = None;
    let mut command: Option<(f64, f64)> = None;
    let mut answers = Vec::new();
    for event in events {
        answers.push(match *event {
            Event::Command(now, ttl, seq) => {
                if last.is_none_or(|last| seq > last) {
                    (last, command) = (Some(seq), Some((now, ttl)));
                }
                json!({})
            }
            Event::ShouldHold(now) => {
                command = command.filter(|&(received, ttl)| {
                    let is_time = now.is_finite() && received.is_finite() && received <= now;
                    let age = (now - received) * 1000.0;
                    is_time && ttl.is_finite() && ttl > 0.0 && age <= ttl && age <= 60_000.0
                });
                json!({ "hold": command.is_none() })
            }
            Event::Reset => {
                (last, command) = (None, None);
                json!({})
            }
        });
    }
    answers
}
