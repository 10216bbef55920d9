//! Counterexamples as cases of vectors, where a call of the peer protocol can show them: traces of `watchdog.run`
//! here, of `governor.run` in `gates`, of `buffer.run` in `plant`.

pub mod gates;
pub mod plant;

use ncp_kernel::Mode;
use serde_json::{Value, json};

use crate::counterexample::{Counterexample, Drawn, ENDS};
use crate::kernel::Kernel;
use crate::reference::{self, Event};

/// A kernel behind the calls of the peer protocol.
#[derive(Debug, Clone, Copy)]
pub struct Calls {
    /// What its watchdog answers to a trace.
    pub watchdog: fn(&[Event]) -> Vec<Value>,
    /// What a small governor around it answers to a trace.
    pub governor: fn(&gates::Trace) -> Option<Vec<Value>>,
    /// What a small action buffer around it answers to a trace.
    pub buffer: fn(&[plant::Step]) -> Option<Vec<Value>>,
}

impl Calls {
    /// Those of a kernel.
    #[must_use]
    pub fn of<K: Kernel>() -> Self {
        Self { watchdog: run::<K>, governor: gates::run::<K>, buffer: plant::run::<K> }
    }
}

/// A number as vectors spell it.
#[must_use]
pub fn number(x: f64) -> Value {
    if x.is_nan() {
        json!("NaN")
    } else if x.is_infinite() {
        json!(if x > 0.0 { "Infinity" } else { "-Infinity" })
    } else if x == 0.0 && x.is_sign_negative() {
        json!("-0")
    } else {
        json!(x)
    }
}

/// A number that may be absent.
fn optional_number(x: Option<f64>) -> Value {
    x.map_or(Value::Null, number)
}

/// The mode that a harness draws by its place.
fn mode(nth: usize) -> Option<Mode> {
    let modes = [Mode::Active, Mode::Hold, Mode::Init, Mode::Estop];
    modes.into_iter().nth(nth)
}

/// A case that the kernel behind the calls fails, by a counterexample to this property. What it expects is
/// what the text's watchdog, or the specification's governor or buffer, answers.
#[must_use]
pub fn case(property: &str, calls: &Calls, found: &Counterexample) -> Option<Value> {
    try_case(property, calls, found).ok()
}

/// The same, or why there is none.
///
/// # Errors
/// What stands between this counterexample and a call of the protocol.
pub fn try_case(property: &str, calls: &Calls, found: &Counterexample) -> Result<Value, WhyNone> {
    if found.check == ENDS {
        return Err(WhyNone::Endless);
    }
    let inputs = Inputs(found);
    if let Some(case) = watched(property, calls, found) {
        return Ok(case);
    }
    let gates = match gates::case(property, &found.check, calls, &inputs) {
        Ok(case) => return Ok(case),
        Err(why) => why,
    };
    plant::case(property, calls, &inputs).map_err(|why| why.max(gates))
}

/// Why a counterexample is no case. The last one that is true says most.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum WhyNone {
    /// No trace was made of its inputs.
    NoCall,
    /// A frame cannot hold them.
    NoFrame,
    /// The answers are the same.
    Alike,
    /// They are not quite the same.
    Rounding,
    /// There is none.
    Endless,
}

impl WhyNone {
    /// Its words in reports, after "as".
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Endless => "the kernel never answers to its counterexample",
            Self::NoCall => "no call of the protocol takes inputs like those of its counterexample",
            Self::NoFrame => "its counterexample has numbers that JSON lacks",
            Self::Alike => {
                "every call answers its counterexample alike: what is wrong does not leave the kernel, or another \
                 decision comes first"
            }
            Self::Rounding => "the answers to its counterexample differ by no more than a peer's rounding may",
        }
    }
}

/// A case of `watchdog.run`.
fn watched(property: &str, calls: &Calls, found: &Counterexample) -> Option<Value> {
    let inputs = Inputs(found);
    let events = match property {
        "watchdog/deadline" if found.check.starts_with("alive") => {
            vec![inputs.command("received", "ttl", None)?, Event::ShouldHold(inputs.double("now")?)]
        }
        "watchdog/ttl" => {
            let ttl = inputs.double("ttl")?;
            // Where the least of ttl and 60 s ends, and a moment later.
            let end = if ttl.is_finite() { ttl.clamp(0.0, 60_000.0) / 1000.0 } else { 0.0 };
            vec![
                Event::Command(0.0, ttl, 1),
                Event::ShouldHold(end),
                Event::Command(0.0, ttl, 2),
                Event::ShouldHold(end + 0.001),
            ]
        }
        "watchdog/order" if found.check == "advances" && inputs.choice("has_last")? == 1 => vec![
            Event::Command(0.0, 1000.0, inputs.seq("last")?),
            Event::Command(5.0, 1000.0, inputs.seq("seq")?),
            Event::ShouldHold(5.0),
        ],
        "watchdog/step" => step(&inputs)?,
        _ => return None,
    };
    let answers = reference::run(&events);
    if answers == (calls.watchdog)(&events) {
        return None;
    }
    let steps: Vec<Value> = events.iter().map(step_json).collect();
    Some(json!({
        "roles": ["body"],
        "call": "watchdog.run",
        "args": { "steps": steps },
        "expect": { "relation": "pattern", "value": { "steps": answers } },
    }))
}

/// The state and the event of `watchdog/step`, where the protocol has a word for them.
fn step(inputs: &Inputs<'_>) -> Option<Vec<Event>> {
    let mut events = Vec::new();
    match inputs.state()? {
        State::Empty => {}
        State::Followed => events.push(inputs.command("received", "ttl", Some("last"))?),
        State::Held => return None,
    }
    match inputs.choice("event")? {
        0 => {
            events.push(inputs.command("now", "new_ttl", Some("seq"))?);
            events.push(Event::ShouldHold(inputs.double("now")?));
        }
        2 => events.push(Event::ShouldHold(inputs.double("now")?)),
        4 => {
            events.push(Event::Reset);
            events.push(Event::ShouldHold(inputs.double("later")?));
        }
        _ => return None,
    }
    Some(events)
}

/// A step as a vector spells it.
fn step_json(event: &Event) -> Value {
    match *event {
        Event::Command(now, ttl, seq) => {
            json!({"op": "command", "now_s": number(now), "ttl_ms": number(ttl), "seq": seq})
        }
        Event::ShouldHold(now) => json!({"op": "should_hold", "now_s": number(now)}),
        Event::Reset => json!({"op": "reset"}),
    }
}

/// What a kernel's watchdog answers to a trace.
#[must_use]
pub fn run<K: Kernel>(events: &[Event]) -> Vec<Value> {
    let mut watchdog = K::watchdog::<f64, i64>();
    let answers = events.iter().map(|event| match *event {
        Event::Command(now, ttl, seq) => {
            K::watchdog_command(&mut watchdog, now, ttl, seq);
            json!({})
        }
        Event::ShouldHold(now) => json!({"hold": K::watchdog_should_hold(&mut watchdog, now)}),
        Event::Reset => {
            K::watchdog_reset(&mut watchdog);
            json!({})
        }
    });
    answers.collect()
}

/// The state of a watchdog, where commands lead to it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum State {
    /// No command has come.
    Empty,
    /// A command is followed.
    Followed,
    /// The plant is held after one.
    Held,
}

/// The inputs of a counterexample, by their names.
struct Inputs<'a>(&'a Counterexample);

impl Inputs<'_> {
    /// All that was drawn by a name: a double that may be absent has a choice of the same name.
    fn named(&self, name: &str) -> impl Iterator<Item = Drawn> {
        let inputs = self.0.inputs.iter();
        inputs.filter(move |(known, _)| known == name).map(|(_, drawn)| *drawn)
    }
    fn double(&self, name: &str) -> Option<f64> {
        self.named(name).find_map(|drawn| match drawn {
            Drawn::Scalar(x) => Some(x),
            _ => None,
        })
    }
    fn seqs(&self, name: &str) -> Vec<i64> {
        let seqs = self.named(name).filter_map(|drawn| match drawn {
            Drawn::Seq(seq) => Some(seq),
            _ => None,
        });
        seqs.collect()
    }
    fn seq(&self, name: &str) -> Option<i64> {
        self.seqs(name).first().copied()
    }
    fn choices(&self, name: &str) -> Vec<usize> {
        let choices = self.named(name).filter_map(|drawn| match drawn {
            Drawn::Choice(way) => Some(way),
            _ => None,
        });
        choices.collect()
    }
    fn choice(&self, name: &str) -> Option<usize> {
        self.choices(name).first().copied()
    }
    /// A double that is there or not.
    fn optional(&self, name: &str) -> Option<Option<f64>> {
        match self.choice(name)? {
            0 => Some(None),
            _ => self.double(name).map(Some),
        }
    }
    /// None for one to which no commands lead.
    fn state(&self) -> Option<State> {
        match (self.choice("has_last")?, self.choice("has_deadline")?) {
            (0, 0) => Some(State::Empty),
            (0, _) => None,
            (_, 0) => Some(State::Held),
            _ => Some(State::Followed),
        }
    }
    fn vector(&self, name: &str) -> Option<[f64; 3]> {
        let [x, y, z] = [0, 1, 2].map(|axis| self.double(&format!("{name}_{axis}")));
        Some([x?, y?, z?])
    }
    fn command(&self, now: &str, ttl: &str, seq: Option<&str>) -> Option<Event> {
        let seq = match seq {
            Some(name) => self.seq(name)?,
            None => 1,
        };
        Some(Event::Command(self.double(now)?, self.double(ttl)?, seq))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::harness::{Harness, harness};
    use crate::kernel::Production;
    use crate::provers::native::{Draw, Native, Sample, Source};

    /// Inputs of a harness, as if they were a counterexample.
    pub(super) fn sampled(harness: &Harness, seed: u64) -> Counterexample {
        let mut native = Native::new(Source::Sample(Sample::new(seed, usize::MAX)));
        native.keep = true;
        (harness.native)(&mut native);
        Counterexample { check: String::new(), inputs: native.drawn }
    }

    #[test]
    fn a_command_that_is_too_old_is_a_case_that_expects_a_hold() {
        let inputs = [("now", 61.0), ("received", 0.0), ("ttl", f64::MAX)];
        let found = Counterexample {
            check: "alive exactly by the liveness rule".to_owned(),
            inputs: inputs.map(|(name, x)| (name.to_owned(), Drawn::Scalar(x))).to_vec(),
        };
        let mut harness = harness::<Production>("watchdog/deadline").unwrap();
        assert_eq!(case("watchdog/deadline", &harness.calls, &found), None);
        harness.calls.watchdog = |_| vec![json!({}), json!({"hold": false})];
        let case = case("watchdog/deadline", &harness.calls, &found).unwrap();
        assert_eq!(case["call"], "watchdog.run");
        assert_eq!(case["expect"]["value"]["steps"], json!([{}, {"hold": true}]));
    }

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
            assert_eq!(reference::run(&events), run::<Production>(&events), "{events:?}");
        }
    }
}
