//! A plant in plain arithmetic, written from sections 8.1 and 8.2 and from nothing else.
//!
//! It knows three answers: the plant holds, it may not hold, or the text lets it do either.

use ncp_text::WIRE_VERSION;

use crate::command::{Channel, Command, active, channels_json};
use crate::json::{Json, object};
use crate::patch::patched;
use crate::scenario::{Row, ScenarioError, Step};
use crate::trace::{any, int, no_result, num, steps};

/// What happens at a plant.
#[derive(Debug, Clone)]
pub(crate) enum Event {
    /// A command arrives.
    Command(Command, f64),
    /// Any other text arrives. Whether it is an ESTOP by rule 22.
    Text {
        text: Json,
        now: f64,
        stops: bool,
    },
    /// The plant is asked what it does.
    Ask(f64),
    Reset,
}

/// The events that the steps of a row say: `ask`, `reset`, `go 5` or `hold 5` for a command of that seq, with settings
/// behind it, and `frame estop 5` with changes of the frame behind it. `@1.5` sets the clock for the step and those
/// behind it, `+0.5` moves it; `x9` before a step repeats it.
pub(crate) fn events(row: &Row) -> Result<Vec<Event>, ScenarioError> {
    let (mut events, mut now) = (Vec::new(), 0.0);
    for step in row.steps() {
        let (times, round) = step.repeated();
        let steps = round.into_iter().map(Step::counted).collect::<Result<Vec<_>, _>>()?.concat();
        for step in std::iter::repeat_n(&steps, times).flatten() {
            for word in step.words() {
                if let Some(time) = word.strip_prefix('@') {
                    now = step.place.double(time)?;
                } else if let Some(time) = word.strip_prefix('+') {
                    now += step.place.double(time)?;
                }
            }
            events.push(event(step, now)?);
        }
    }
    Ok(events)
}

fn event(step: &Step, now: f64) -> Result<Event, ScenarioError> {
    Ok(match step.verb() {
        "ask" => Event::Ask(now),
        "reset" => Event::Reset,
        "frame" => {
            let (step, changes) = step.tail().halves();
            let frame = patched(command(&step)?.frame(), &changes, step.place)?;
            Event::Text { text: Json::string(frame.text()), now, stops: false }
        }
        _ => Event::Command(command(step)?, now),
    })
}

/// The command of a step: its mode, its seq, and its settings. A hyphen stands for what is absent.
pub(crate) fn command(step: &Step) -> Result<Command, ScenarioError> {
    let seq = match step.word(0, "seq")? {
        "-" => None,
        seq => Some(step.place.integer(seq)?),
    };
    let command = active(seq.unwrap_or(99));
    let mode = match step.verb() {
        "-" => None,
        "go" => Some("active".to_owned()),
        mode => Some(mode.to_owned()),
    };
    Command { seq, mode, ..command }.set(step)
}

/// What a plant may answer.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Answer {
    Hold,
    Move(Vec<Channel>),
    /// It holds or moves so.
    Either(Vec<Channel>),
}

/// What the plant of the text does, strict or not.
#[derive(Debug, Clone, Default)]
pub(super) struct Plant {
    strict: bool,
    last_seq: Option<i64>,
    /// The command that may be acted upon, when it came, and whether holding is allowed as well.
    held: Option<(Command, f64, bool)>,
    latched: bool,
    /// The last reading of the clock.
    clock: Option<f64>,
    /// The rule by which it holds while it has no command to act upon.
    rests: Option<&'static str>,
    /// The command whose hold persists, and when it came.
    outlived: Option<(Command, f64)>,
    /// The rule by which ESTOP is latched.
    stopped: &'static str,
    /// The rule of what has happened since the plant was last asked: a command that is dropped, a reset.
    happened: Option<&'static str>,
    /// The rule by which a command that came since the last one that advanced does not refresh the deadline.
    refreshes_not: Option<&'static str>,
    /// Whether an unstamped HOLD came before every seq of 0 or more: the text leaves open whether it advances.
    unstamped_first: bool,
    /// Whether nothing has moved since a reset that cleared a seq or a latch.
    is_reset: bool,
    /// Whether a strict plant has rejected or dropped a command since the last one that advanced.
    spared: bool,
    /// Whether it had before the one that it follows, and nobody has asked since.
    spares: bool,
    /// The rule that decided the last answer.
    said: &'static str,
}

impl Plant {
    /// A clock that steps back, also to a time after the receipt, is reason enough to hold.
    fn read(&mut self, now: f64) {
        if self.clock.is_some_and(|before| now < before)
            && let Some((_, _, may_hold)) = &mut self.held
        {
            *may_hold = true;
        }
        self.clock = Some(now);
    }

    pub(super) fn command(&mut self, command: &Command, now: f64) {
        self.read(now);
        let seq = command.seq.unwrap_or(0);
        let advances = self.last_seq.is_none_or(|last| seq > last);
        match command.mode.as_deref() {
            Some("estop") => self.stop("NCP-RES-021"),
            // What a strict plant rejects or drops leaves nothing behind.
            _ if self.strict && (command.version.as_deref() != Some(WIRE_VERSION) || seq < 1 || !advances) => {
                self.happened = Some(match command.version.as_deref() {
                    None => "NCP-STRICT-002",
                    Some(version) if version != WIRE_VERSION => "NCP-STRICT-003",
                    Some(_) if seq < 1 => "NCP-STRICT-004",
                    Some(_) => "NCP-STRICT-005",
                });
                self.spared = true;
            }
            Some("active") => {
                if advances {
                    self.last_seq = Some(seq);
                    self.held = Some((command.clone(), now, self.unstamped_first && seq <= 0));
                    self.happened = None;
                    self.refreshes_not = None;
                    self.spares = std::mem::take(&mut self.spared);
                } else {
                    self.happened = self.happened.or(Some(DROPPED));
                    self.refreshes_not = Some("NCP-RES-009");
                }
            }
            _ => {
                let moved = self.held.is_some();
                self.unstamped_first |= self.last_seq.is_none_or(|last| last < 0) && seq == 0;
                // A HOLD that is older need not be dropped.
                if advances || seq == 0 || self.last_seq == Some(seq) {
                    self.held = None;
                    self.rests = Some(if moved { "NCP-RES-023" } else { "NCP-SAFE-001" });
                    self.happened = None;
                } else {
                    self.refreshes_not = Some("NCP-RES-024");
                    if let Some((_, _, may_hold)) = &mut self.held {
                        *may_hold = true;
                    }
                }
                if advances && seq != 0 {
                    self.last_seq = Some(seq);
                }
            }
        }
    }

    /// Another command frame by the watchdog's call, which has no mode.
    pub(super) fn reset(&mut self) {
        let clears = self.latched || self.last_seq.is_some();
        *self = Self {
            strict: self.strict,
            clock: self.clock,
            rests: Some("NCP-RES-031"),
            is_reset: clears,
            ..Self::default()
        };
    }

    /// Latches ESTOP by a rule.
    pub(super) fn stop(&mut self, rule: &'static str) {
        if !self.latched {
            (self.latched, self.stopped) = (true, if self.strict { "NCP-STRICT-010" } else { rule });
        }
    }

    /// The plant holds on its command, and persists.
    fn outlives(&mut self) {
        self.outlived = self.held.take().map(|(command, received, _)| (command, received));
        self.rests = Some(PERSISTS);
    }

    /// Whether and on what the plant acts at `now`.
    pub(super) fn ask(&mut self, now: f64) -> Answer {
        self.read(now);
        let happened = self.happened.take();
        let Some((command, received, may_hold)) = self.held.clone() else {
            // What was rejected or dropped revives nothing. Within the time of the command it need revive nothing for
            // the plant to move: it is enough that the hold does not persist.
            let is_in_time = |(command, received): &(Command, f64)| over(command, *received, now).is_none();
            let persists = self.rests == Some(PERSISTS) && self.outlived.as_ref().is_some_and(is_in_time);
            let dropped = happened.map(|rule| if rule == DROPPED && persists { PERSISTS } else { rule });
            let latched = self.latched.then_some(self.stopped);
            self.said = latched.or(dropped).or(self.rests).unwrap_or("NCP-RES-006");
            self.stopped = "NCP-RES-025";
            return Answer::Hold;
        };
        if let Some(late) = over(&command, received, now) {
            self.outlives();
            let may_be_refreshed = late == "NCP-RES-002" || late == "NCP-RES-007" && now.is_finite();
            self.said = self.refreshes_not.filter(|_| may_be_refreshed).unwrap_or(late);
            return Answer::Hold;
        }
        if self.latched {
            self.said = std::mem::replace(&mut self.stopped, "NCP-RES-025");
            return Answer::Hold;
        }
        let exact = (now - received) * 1000.0 == command.ttl.min(60_000.0);
        // Whether a strict plant follows what it rejects, or loses by it what it had, a model does not see.
        let happened = happened.filter(|rule| !rule.starts_with("NCP-STRICT"));
        let happened = happened.or(std::mem::take(&mut self.spares).then_some(SPARED));
        let happened = happened.or(std::mem::take(&mut self.is_reset).then_some(RESET));
        self.said = happened.unwrap_or(if exact { "NCP-RES-003" } else { "NCP-RES-026" });
        let usable = command.dt.filter(|dt| dt.is_finite() && *dt > 0.0);
        // A horizon whose ticks have no length is held for, or tick 0 followed.
        let may_hold = may_hold || usable.is_none() && !command.horizon.is_empty();
        let value = match usable.filter(|_| !command.horizon.is_empty()) {
            None => Some(command.channels),
            Some(dt) => {
                self.said = "NCP-RES-028";
                let tick = ((now - received) * 1000.0 / dt).floor();
                if tick < 1.0 {
                    Some(command.channels)
                } else {
                    #[expect(
                        clippy::cast_possible_truncation,
                        clippy::cast_sign_loss,
                        reason = "a tick of at most a minute"
                    )]
                    command.horizon.get(tick as usize - 1).cloned()
                }
            }
        };
        match value {
            None => {
                // The hold past the end of a horizon persists like every other.
                self.outlives();
                self.said = "NCP-RES-029";
                Answer::Hold
            }
            Some(value) if may_hold => Answer::Either(value),
            Some(value) => Answer::Move(value),
        }
    }
}

/// The rule by which a command's time is over, if it is.
fn over(command: &Command, received: f64, now: f64) -> Option<&'static str> {
    let ttl = command.ttl.min(60_000.0);
    if !(command.ttl.is_finite() && ttl > 0.0) {
        Some("NCP-RES-005")
    } else if !(now.is_finite() && received.is_finite()) {
        Some("NCP-RES-007")
    } else if received > now {
        Some("NCP-RES-008")
    } else {
        let rule = if command.ttl > ttl { "NCP-RES-004" } else { "NCP-RES-002" };
        ((now - received) * 1000.0 > ttl).then_some(rule)
    }
}

/// The rule that the case is about.
const OWN: &str = "";
/// The rule by which a hold persists.
const PERSISTS: &str = "NCP-RES-010";
/// The rule by which a command that does not advance is dropped.
const DROPPED: &str = "NCP-RES-020";
/// The rule by which a command moves the plant that would not have advanced before a reset.
const RESET: &str = "NCP-RES-030";

/// The rule by which a command moves a strict plant that rejected or dropped another before it.
const SPARED: &str = "NCP-STRICT-011";

/// A trace: its arguments, its pattern, and the rule of each answer.
pub(crate) type Run = (Json, Json, Vec<Option<&'static str>>);

/// The arguments and the pattern of `buffer.run`, of a plant that is strict or not.
pub(crate) fn buffer(events: &[Event], strict: bool) -> Run {
    let mut plant = Plant { strict, ..Plant::default() };
    let (mut args, mut results, mut rules) = (Vec::new(), Vec::new(), Vec::new());
    for event in events {
        plant.said = "";
        match event {
            Event::Command(command, now) => {
                plant.command(command, *now);
                args.push(object! { "op" => "command", "text" => command.frame().text(), "now_s" => num(*now) });
                results.push(no_result());
            }
            Event::Text { text, now, stops } => {
                plant.read(*now);
                if *stops {
                    plant.stop("NCP-RES-022");
                } else {
                    // What the case is about.
                    plant.happened = Some(OWN);
                }
                args.push(object! { "op" => "command", "text" => text.clone(), "now_s" => num(*now) });
                results.push(no_result());
            }
            Event::Ask(now) => {
                args.push(object! { "op" => "active", "now_s" => num(*now) });
                let channels = match plant.ask(*now) {
                    Answer::Hold => vec![Json::Null],
                    Answer::Move(channels) => vec![channels_json(&channels)],
                    Answer::Either(channels) => vec![channels_json(&channels), Json::Null],
                };
                results.push(any(channels.into_iter().map(|channels| object! { "channels" => channels }).collect()));
            }
            Event::Reset => {
                plant.reset();
                args.push(object! { "op" => "reset" });
                results.push(no_result());
            }
        }
        rules.push(Some(plant.said).filter(|rule| !rule.is_empty()));
    }
    (object! { "steps" => Json::Array(args) }, steps(results), rules)
}

/// The arguments and the pattern of `watchdog.run`, in which a command has neither mode nor channels.
pub(crate) fn watchdog(events: &[Event]) -> Run {
    let mut plant = Plant::default();
    let (mut args, mut results, mut rules) = (Vec::new(), Vec::new(), Vec::new());
    for event in events {
        plant.said = "";
        match event {
            Event::Command(command, now) => {
                plant.command(command, *now);
                args.push(object! { "op" => "command", "now_s" => num(*now), "ttl_ms" => num(command.ttl),
                "seq" => command.seq.map(int) });
                results.push(no_result());
            }
            Event::Ask(now) => {
                args.push(object! { "op" => "should_hold", "now_s" => num(*now) });
                let hold = match plant.ask(*now) {
                    Answer::Hold => vec![true],
                    Answer::Move(_) => vec![false],
                    Answer::Either(_) => vec![true, false],
                };
                results.push(object! { "hold" => any(hold.into_iter().map(Json::Bool).collect()) });
            }
            Event::Reset | Event::Text { .. } => {
                plant.reset();
                args.push(object! { "op" => "reset" });
                results.push(no_result());
            }
        }
        rules.push(Some(of_watchdog(plant.said)).filter(|rule| !rule.is_empty()));
    }
    (object! { "steps" => Json::Array(args) }, steps(results), rules)
}

/// What a rule of the buffer is to a watchdog, which knows no channels.
fn of_watchdog(rule: &'static str) -> &'static str {
    match rule {
        "NCP-RES-020" => "NCP-RES-009",
        "NCP-RES-026" => "NCP-RES-013",
        "NCP-RES-030" => "NCP-RES-012",
        "NCP-RES-031" => "NCP-RES-011",
        rule => rule,
    }
}
