//! A watchdog in a few lines, from the text's sentences: what a case of a vector expects, whatever the kernel does.

use serde_json::{Value, json};

use crate::vector::Event;

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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engines::native::{Draw, Sample};
    use crate::kernel::Production;
    use crate::vector;

    #[test]
    fn the_kernel_answers_every_sampled_trace_as_the_text_says() {
        for seed in 0..20_000 {
            let mut draw = Sample::new(seed, 8);
            let events: Vec<Event> = (0..8)
                .map(|_| match draw.choice(5) {
                    0 | 1 => Event::Command(draw.scalar(), draw.scalar(), draw.seq()),
                    2 | 3 => Event::ShouldHold(draw.scalar()),
                    _ => Event::Reset,
                })
                .collect();
            assert_eq!(run(&events), vector::run::<Production>(&events), "{events:?}");
        }
    }
}
