//! A plant in plain arithmetic, written from sections 8.1 and 8.2 and from nothing else.
//!
//! It knows three answers: the plant holds, it may not hold, or the text lets it do either.

use crate::json::{Json, object};
use crate::trace::{any, int, no_result, num, nums, steps};

/// A command as the plant receives it.
#[derive(Debug, Clone)]
pub(super) struct Command {
    pub(super) seq: i64,
    pub(super) mode: &'static str,
    pub(super) ttl: f64,
    /// What tick 0 commands.
    pub(super) value: f64,
    /// What the ticks 1, 2, … command.
    pub(super) horizon: Vec<f64>,
    pub(super) dt: Option<f64>,
    pub(super) t: f64,
}

/// A command of a quarter of a second that commands its own seq.
pub(super) fn active(seq: i64) -> Command {
    #[expect(clippy::cast_precision_loss, reason = "seqs are small, and a value is only to be told from others")]
    let value = seq as f64;
    Command { seq, mode: "active", ttl: 250.0, value, horizon: Vec::new(), dt: None, t: 3.0 }
}

impl Command {
    pub(super) fn mode(mut self, mode: &'static str) -> Self {
        self.mode = mode;
        self
    }

    pub(super) fn ttl(mut self, ttl: f64) -> Self {
        self.ttl = ttl;
        self
    }

    pub(super) fn then(mut self, dt: Option<f64>, horizon: &[f64]) -> Self {
        self.horizon = horizon.to_vec();
        self.dt = dt;
        self
    }

    /// The frame as it travels.
    pub(super) fn json(&self) -> Json {
        let channels =
            |x: f64| object! { "velocity_setpoint" => object! { "data" => nums(&[x, 0.0, 0.0]), "unit" => "m/s" } };
        object! {
            "ncp_version" => "0.5",
            "kind" => "command_frame",
            "seq" => int(self.seq),
            "t" => num(self.t),
            "frame_id" => "world",
            "mode" => self.mode,
            "ttl_ms" => Json::literal(format!("{:?}", self.ttl)),
            "channels" => channels(self.value),
            "horizon" => self.horizon.iter().map(|x| channels(*x)).collect::<Json>(),
            // As a frame spells them, the sign of a zero included.
            "horizon_dt_ms" => self.dt.map(|dt| Json::literal(format!("{dt:?}"))),
        }
    }

    pub(super) fn text(&self) -> String {
        self.json().text()
    }
}

/// What happens at a plant.
#[derive(Debug, Clone)]
pub(super) enum Event {
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

/// What a plant may answer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Answer {
    Hold,
    Move(f64),
    /// It holds or moves so.
    Either(f64),
}

/// What the plant of the text does.
#[derive(Debug, Clone, Default)]
pub(super) struct Plant {
    last_seq: Option<i64>,
    /// The command that may be acted upon, when it came, and whether holding is allowed as well.
    held: Option<(Command, f64, bool)>,
    latched: bool,
    /// The last reading of the clock.
    clock: Option<f64>,
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
        let advances = self.last_seq.is_none_or(|last| command.seq > last);
        match command.mode {
            "estop" => self.latched = true,
            "active" => {
                if advances {
                    self.last_seq = Some(command.seq);
                    self.held = Some((command.clone(), now, false));
                }
            }
            _ => {
                // A HOLD that is older need not be dropped.
                if advances || command.seq == 0 || self.last_seq == Some(command.seq) {
                    self.held = None;
                } else if let Some((_, _, may_hold)) = &mut self.held {
                    *may_hold = true;
                }
                if advances && command.seq != 0 {
                    self.last_seq = Some(command.seq);
                }
            }
        }
    }

    /// Another command frame by the watchdog's call, which has no mode.
    pub(super) fn reset(&mut self) {
        *self = Self { clock: self.clock, ..Self::default() };
    }

    /// Whether and on what the plant acts at `now`.
    pub(super) fn ask(&mut self, now: f64) -> Answer {
        self.read(now);
        let Some((command, received, may_hold)) = self.held.clone() else {
            return Answer::Hold;
        };
        let ttl = command.ttl.min(60_000.0);
        let clocks = now.is_finite() && received.is_finite() && received <= now;
        let alive = command.ttl.is_finite() && ttl > 0.0 && clocks && (now - received) * 1000.0 <= ttl;
        if !alive {
            self.held = None;
            return Answer::Hold;
        }
        if self.latched {
            return Answer::Hold;
        }
        let usable = command.dt.filter(|dt| dt.is_finite() && *dt > 0.0);
        // A horizon whose ticks have no length is held for, or tick 0 followed.
        let may_hold = may_hold || usable.is_none() && !command.horizon.is_empty();
        let value = match usable.filter(|_| !command.horizon.is_empty()) {
            None => Some(command.value),
            Some(dt) => {
                let tick = ((now - received) * 1000.0 / dt).floor();
                if tick < 1.0 {
                    Some(command.value)
                } else {
                    #[expect(
                        clippy::cast_possible_truncation,
                        clippy::cast_sign_loss,
                        reason = "a tick of at most a minute"
                    )]
                    command.horizon.get(tick as usize - 1).copied()
                }
            }
        };
        match value {
            None => {
                // The hold past the end of a horizon persists like every other.
                self.held = None;
                Answer::Hold
            }
            Some(value) if may_hold => Answer::Either(value),
            Some(value) => Answer::Move(value),
        }
    }
}

/// The arguments and the pattern of `buffer.run`.
pub(super) fn buffer(events: &[Event]) -> (Json, Json) {
    let mut plant = Plant::default();
    let (mut args, mut results) = (Vec::new(), Vec::new());
    for event in events {
        match event {
            Event::Command(command, now) => {
                plant.command(command, *now);
                args.push(object! { "op" => "command", "text" => command.text(), "now_s" => num(*now) });
                results.push(no_result());
            }
            Event::Text { text, now, stops } => {
                plant.read(*now);
                plant.latched |= stops;
                args.push(object! { "op" => "command", "text" => text.clone(), "now_s" => num(*now) });
                results.push(no_result());
            }
            Event::Ask(now) => {
                args.push(object! { "op" => "active", "now_s" => num(*now) });
                let moving = |x: f64| object! { "velocity_setpoint" => object! { "data" => nums(&[x, 0.0, 0.0]), "unit" => "m/s" } };
                let channels = match plant.ask(*now) {
                    Answer::Hold => vec![Json::Null],
                    Answer::Move(x) => vec![moving(x)],
                    Answer::Either(x) => vec![moving(x), Json::Null],
                };
                results.push(any(channels.into_iter().map(|channels| object! { "channels" => channels }).collect()));
            }
            Event::Reset => {
                plant.reset();
                args.push(object! { "op" => "reset" });
                results.push(no_result());
            }
        }
    }
    (object! { "steps" => Json::Array(args) }, steps(results))
}

/// The arguments and the pattern of `watchdog.run`, in which a command has neither mode nor channels.
pub(super) fn watchdog(events: &[Event]) -> (Json, Json) {
    let mut plant = Plant::default();
    let (mut args, mut results) = (Vec::new(), Vec::new());
    for event in events {
        match event {
            Event::Command(command, now) => {
                plant.command(command, *now);
                args.push(object! { "op" => "command", "now_s" => num(*now), "ttl_ms" => num(command.ttl), "seq" => int(command.seq) });
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
    }
    (object! { "steps" => Json::Array(args) }, steps(results))
}
