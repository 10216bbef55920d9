//! The plant: its watchdog, the order of seqs, and its latch.
//!
//! The plant is the specification's action buffer, to which frames come as text. The network keeps all
//! that was ever sent and delivers any of it at any time, any number of times or never: it loses,
//! duplicates and reorders. The plant's clock is not trusted either: each event reads any of its
//! times, backward steps and a NaN among them.

use std::hash::{Hash, Hasher};

use ncp_kernel::Plant;
use ncp_spec::resilience::{ActionBuffer, is_estop};
use ncp_spec::wire::{ChannelMap, ChannelValue, CommandFrame, Frame, Mode};
use serde_json::{Value, json};
use stateright::{Model, Property};

use crate::explore::{Claim, Protocol, Replay, Variant, case, pattern};
use crate::signs::{Signs, always, sometimes};

/// What the clock may read, in seconds: within a ttl of 250 ms, exactly at it, past it; the same for
/// 60 s; and no time at all.
const TIMES_S: [f64; 6] = [0.0, 0.25, 0.5, 60.0, 60.25, f64::NAN];
const TTLS_MS: [f64; 3] = [0.0, 250.0, 1e9];
const MAX_TTL_S: f64 = 60.0;

/// A command as it is sent.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) enum Body {
    /// `active`, with a ttl of `TTLS_MS`.
    Active(usize),
    Hold,
    /// A HOLD of seq 0.
    Unstamped,
    Estop,
    /// An ESTOP in which all else is malformed.
    Torn,
}

/// A frame in the network.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Sent {
    body: Body,
    seq: i64,
}

/// What happens next.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Event {
    /// The sender sends a frame with its next seq.
    Send(Body),
    /// The sender begins anew: its next seq is 1 again.
    Restart,
    /// A frame arrives, while the clock reads a time of `TIMES_S`.
    Arrive(Sent, usize),
    /// The plant is asked what it does, while the clock reads a time.
    Ask(usize),
    /// A supervisor resets the plant.
    Reset,
}

/// A state of sender, network and plant.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(crate) struct State {
    next: i64,
    restarted: bool,
    sent: Vec<Sent>,
    plant: Subject,
    text: Permit,
    last: Signs,
}

/// What the text permits, kept from its sentences and not from the plant.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
struct Permit {
    /// The highest seq of the commands obeyed since the last reset.
    newest: Option<i64>,
    /// The time of receipt and the ttl of the command that may be acted upon.
    command: Option<(usize, usize)>,
    latched: bool,
}

impl Permit {
    fn moves(&self, time: usize) -> bool {
        let now = TIMES_S[time];
        !self.latched
            && self.command.is_some_and(|(received, ttl)| {
                let (received, ttl_s) = (TIMES_S[received], TTLS_MS[ttl] / 1000.0);
                ttl_s > 0.0 && now >= received && now - received <= ttl_s.min(MAX_TTL_S)
            })
    }
}

/// What the last event showed. The first few are wrong; the rest are signs that something was tried.
mod sign {
    pub(super) const MOVED_WRONGLY: u16 = 1;
    pub(super) const HELD_WRONGLY: u16 = 1 << 1;
    pub(super) const STALE_COUNTED: u16 = 1 << 2;
    pub(super) const LATCH_MOVED: u16 = 1 << 3;
    pub(super) const ESTOP_LOST: u16 = 1 << 4;
    pub(super) const REVIVED: u16 = 1 << 5;
    pub(super) const NOT_ONE: u16 = 1 << 6;
    pub(super) const MOVED: u16 = 1 << 7;
    pub(super) const EXPIRED: u16 = 1 << 8;
    pub(super) const STALE: u16 = 1 << 9;
    pub(super) const OLD_ESTOP: u16 = 1 << 10;
    pub(super) const RESTART_HELD: u16 = 1 << 11;
    pub(super) const RESTART_MOVED: u16 = 1 << 12;
    pub(super) const MOVED_AT_END: u16 = 1 << 13;
}
use sign::*;

/// What is broken in a plant.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Defect {
    /// Nothing: the plant of the broken variants is itself right.
    #[cfg(test)]
    Nothing,
    DuplicateRefreshes,
    OldRefreshes,
    NoCap,
    ZeroTtlCounts,
    ClockBackwardCounts,
    ReviveAfterExpiry,
    NanIsFresh,
    EndIsPast,
    RestartIsNewer,
    HoldDoesNotAdvance,
    ResetKeepsDeadline,
    OldEstopDropped,
    TornEstopDropped,
    ActiveClearsLatch,
    EstopIsHold,
    HoldClearsLatch,
}

/// The plant under check.
#[derive(Debug, Clone)]
enum Subject {
    Real(Box<ActionBuffer>, Plant<f64, i64>),
    Broken(Wrong),
}

/// A plant with a defect, written down in the shortest way.
#[derive(Debug, Clone, Copy)]
struct Wrong {
    defect: Defect,
    last: Option<i64>,
    deadline: Option<(f64, f64)>,
    stopped: bool,
}

type Key = (Option<i64>, Option<(u64, u64)>, bool);

impl Subject {
    fn key(&self) -> Key {
        let (last, deadline, stopped) = match self {
            Self::Real(_, plant) => (plant.watchdog().last_seq(), plant.watchdog().deadline(), plant.is_stopped()),
            Self::Broken(wrong) => (wrong.last, wrong.deadline, wrong.stopped),
        };
        (last, deadline.map(|(r, ttl)| (r.to_bits(), ttl.to_bits())), stopped)
    }

    fn arrive(&mut self, text: &str, now_s: f64) {
        match self {
            Self::Real(buffer, plant) => {
                let _ = buffer.on_frame(text.as_bytes(), now_s);
                // The plant within the buffer cannot be looked at: this is its like.
                match CommandFrame::decode(text.as_bytes()) {
                    Ok(frame) => {
                        plant.on_command(frame.mode, now_s, frame.ttl_ms, frame.seq);
                    }
                    Err(_) if is_estop(text.as_bytes()) => plant.stop(),
                    Err(_) => {}
                }
            }
            Self::Broken(wrong) => wrong.arrive(text, now_s),
        }
    }

    /// Whether the plant moves; and whether the buffer does what its plant says.
    fn ask(&mut self, now_s: f64) -> (bool, bool) {
        match self {
            Self::Real(buffer, plant) => {
                let moves = buffer.active(now_s).is_some();
                let like = plant.active(now_s, None, 0).is_some();
                (moves, moves == like && buffer.is_stopped() == plant.is_stopped())
            }
            Self::Broken(wrong) => (wrong.ask(now_s), true),
        }
    }

    fn reset(&mut self) {
        match self {
            Self::Real(buffer, plant) => {
                buffer.reset();
                plant.reset();
            }
            Self::Broken(wrong) => {
                wrong.stopped = false;
                wrong.last = None;
                if wrong.defect != Defect::ResetKeepsDeadline {
                    wrong.deadline = None;
                }
            }
        }
    }
}

impl PartialEq for Subject {
    fn eq(&self, other: &Self) -> bool {
        self.key() == other.key()
    }
}

impl Eq for Subject {}

impl Hash for Subject {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.key().hash(state);
    }
}

impl Wrong {
    fn arrive(&mut self, text: &str, now_s: f64) {
        let defect = self.defect;
        let Ok(frame) = CommandFrame::decode(text.as_bytes()) else {
            self.stopped |= defect != Defect::TornEstopDropped && is_estop(text.as_bytes());
            return;
        };
        let seq = frame.seq;
        let newer = self.last.is_none_or(|last| match defect {
            Defect::DuplicateRefreshes => last <= seq,
            Defect::OldRefreshes => true,
            Defect::RestartIsNewer => last < seq || seq == 1,
            _ => last < seq,
        });
        match frame.mode {
            Mode::Estop if defect == Defect::OldEstopDropped && !newer => {}
            Mode::Estop if defect == Defect::EstopIsHold => self.deadline = None,
            Mode::Estop => self.stopped = true,
            Mode::Active if newer => {
                self.last = Some(seq);
                self.deadline = Some((now_s, frame.ttl_ms));
                self.stopped &= defect != Defect::ActiveClearsLatch;
            }
            Mode::Active => {}
            Mode::Init | Mode::Hold => {
                if seq == 0 || self.last.is_none_or(|last| seq >= last) {
                    if seq != 0 && newer && defect != Defect::HoldDoesNotAdvance {
                        self.last = Some(seq);
                    }
                    self.deadline = None;
                    self.stopped &= defect != Defect::HoldClearsLatch;
                }
            }
        }
    }

    fn ask(&mut self, now_s: f64) -> bool {
        let defect = self.defect;
        let alive = self.deadline.is_some_and(|(received_s, ttl_ms)| {
            let ttl_ms = match defect {
                Defect::NoCap => ttl_ms,
                Defect::ZeroTtlCounts if ttl_ms <= 0.0 => 250.0,
                _ => ttl_ms.min(60_000.0),
            };
            let age_ms = (now_s - received_s) * 1000.0;
            match defect {
                Defect::NanIsFresh => {
                    let held = ttl_ms <= 0.0 || age_ms < 0.0 || age_ms > ttl_ms;
                    !held
                }
                Defect::ClockBackwardCounts => ttl_ms > 0.0 && age_ms <= ttl_ms,
                Defect::EndIsPast => ttl_ms > 0.0 && age_ms >= 0.0 && age_ms < ttl_ms,
                _ => ttl_ms > 0.0 && age_ms >= 0.0 && age_ms <= ttl_ms,
            }
        });
        if !alive && defect != Defect::ReviveAfterExpiry {
            self.deadline = None;
        }
        alive && !self.stopped
    }
}

/// The model: how much is sent, and what the plant is.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Link {
    defect: Option<Defect>,
    seqs: i64,
    bodies: &'static [Body],
}

/// Every body.
const ALL: [Body; 7] =
    [Body::Active(0), Body::Active(1), Body::Active(2), Body::Hold, Body::Unstamped, Body::Estop, Body::Torn];
/// The bodies on which the order of seqs acts.
const ORDERED: [Body; 3] = [Body::Active(1), Body::Hold, Body::Estop];

impl Model for Link {
    type State = State;
    type Action = Event;

    fn init_states(&self) -> Vec<State> {
        vec![State {
            next: 1,
            restarted: false,
            sent: vec![],
            plant: subject(self.defect),
            text: Permit::default(),
            last: Signs::default(),
        }]
    }

    fn actions(&self, state: &State, actions: &mut Vec<Event>) {
        if state.next <= self.seqs {
            actions.extend(self.bodies.iter().copied().map(Event::Send));
        }
        if !state.restarted && state.next > 1 {
            actions.push(Event::Restart);
        }
        for time in 0..TIMES_S.len() {
            actions.extend(state.sent.iter().map(|&sent| Event::Arrive(sent, time)));
            actions.push(Event::Ask(time));
        }
        actions.push(Event::Reset);
    }

    fn next_state(&self, before: &State, event: Event) -> Option<State> {
        let mut state = before.clone();
        state.last = Signs::default();
        match event {
            Event::Send(body) => {
                let seq = if body == Body::Unstamped { 0 } else { state.next };
                let sent = Sent { body, seq };
                state.next += 1;
                match state.sent.binary_search(&sent) {
                    Ok(_) => {}
                    Err(place) => state.sent.insert(place, sent),
                }
            }
            Event::Restart => {
                state.next = 1;
                state.restarted = true;
            }
            Event::Arrive(sent, time) => arrive(&mut state, sent, time),
            Event::Ask(time) => ask(&mut state, time),
            Event::Reset => {
                state.plant.reset();
                state.text = Permit::default();
            }
        }
        Some(state)
    }

    fn properties(&self) -> Vec<Property<Self>> {
        vec![
            always!("liveness", MOVED_WRONGLY),
            always!("no needless hold", HELD_WRONGLY),
            always!("stale changes nothing", STALE_COUNTED),
            always!("latch", LATCH_MOVED),
            always!("estop is never lost", ESTOP_LOST),
            always!("reset never revives", REVIVED),
            always!("buffer is its plant", NOT_ONE),
            sometimes!("the plant moves", MOVED),
            sometimes!("a deadline passes", EXPIRED),
            sometimes!("a stale command arrives while the plant moves", STALE),
            sometimes!("an ESTOP arrives that is older than the newest command", OLD_ESTOP),
            sometimes!("a restarted sender is held", RESTART_HELD),
            sometimes!("a restarted sender moves the plant after a reset", RESTART_MOVED),
            sometimes!("the plant moves at the very end of a ttl", MOVED_AT_END),
        ]
    }
}

/// The plant's side of the protocol.
pub(crate) enum PlantSide {}

impl Protocol for PlantSide {
    type Defect = Defect;
    type Model = Link;

    const FAMILY: &'static str = "plant";
    const CLAIMS: &'static [Claim] = &[
        Claim {
            name: "liveness",
            rules: &[
                "NCP-RES-001",
                "NCP-RES-002",
                "NCP-RES-004",
                "NCP-RES-005",
                "NCP-RES-006",
                "NCP-RES-007",
                "NCP-RES-008",
                "NCP-RES-009",
                "NCP-RES-010",
                "NCP-RES-023",
                "NCP-RES-024",
                "NCP-RES-025",
                "NCP-RES-032",
            ],
            sentence: "Over every network and clock, a plant moves only on an advancing command that was received at \
                r ≤ now with now − r ≤ min(ttl, 60 s), and that no HOLD, hold or reset has ended since.",
            formal: "always: moves(now) ⟹ ∃ accepted (r, ttl): r ≤ now ∧ now − r ≤ min(ttl, 60 s) ∧ not ended",
        },
        Claim {
            name: "no needless hold",
            rules: &["NCP-RES-003", "NCP-RES-012", "NCP-RES-026"],
            sentence: "A plant moves where the text lets it: also at exactly the end of the ttl, and after a reset \
                on a new command whatever its seq.",
            formal: "always: permitted(now) ⟹ moves(now)",
        },
        Claim {
            name: "stale changes nothing",
            rules: &["NCP-RES-009", "NCP-RES-020"],
            sentence: "A stale, duplicate or reordered command leaves the last seq and the deadline as they are.",
            formal: "always: arrival of an active command with seq ≤ last ⟹ (last, deadline)' = (last, deadline)",
        },
        Claim {
            name: "latch",
            rules: &["NCP-RES-021", "NCP-RES-022", "NCP-RES-025"],
            sentence: "Once an ESTOP has arrived, the plant does not move until its reset.",
            formal: "always: latched ⟹ ¬moves(now)",
        },
        Claim {
            name: "estop is never lost",
            rules: &["NCP-RES-021", "NCP-RES-022"],
            sentence: "An ESTOP that arrives latches, whatever its seq, and also when all else in it is malformed.",
            formal: "always: arrival of an ESTOP ⟹ stopped'",
        },
        Claim {
            name: "reset never revives",
            rules: &["NCP-RES-011", "NCP-RES-030", "NCP-RES-031"],
            sentence: "After a reset nothing moves until a new command comes.",
            formal: "always: no command accepted since the reset ⟹ ¬moves(now)",
        },
        Claim {
            name: "buffer is its plant",
            rules: &["NCP-RES-025", "NCP-RES-026"],
            sentence: "The action buffer, fed with the frames as text, moves and latches exactly as the kernel's \
                plant.",
            formal: "always: buffer.active(now) is some ⟺ plant.active(now) is some, and both latch alike",
        },
    ];
    const BROKEN: &'static [Variant<Defect>] = &[
        (
            Defect::DuplicateRefreshes,
            "duplicate-refreshes",
            "A duplicate refreshes the deadline.",
            "stale changes nothing",
        ),
        (Defect::OldRefreshes, "old-refreshes", "A reordered command counts as new.", "liveness"),
        (Defect::NoCap, "no-cap", "A ttl is not capped at 60 s.", "liveness"),
        (Defect::ZeroTtlCounts, "zero-ttl", "A ttl of 0 counts as 250 ms.", "liveness"),
        (
            Defect::ClockBackwardCounts,
            "clock-backward",
            "A clock that reads less than at the receipt counts as no age.",
            "liveness",
        ),
        (Defect::ReviveAfterExpiry, "revives", "A hold ends when the clock goes back.", "liveness"),
        (Defect::NanIsFresh, "nan-is-fresh", "A clock that reads NaN passes every comparison.", "liveness"),
        (Defect::EndIsPast, "end-is-past", "A command counts as expired at exactly its ttl.", "no needless hold"),
        (Defect::RestartIsNewer, "restart-is-newer", "A seq of 1 always counts as a new stream.", "liveness"),
        (
            Defect::HoldDoesNotAdvance,
            "hold-does-not-advance",
            "A HOLD does not advance the stream, so that a command which it overtook moves the plant.",
            "liveness",
        ),
        (Defect::ResetKeepsDeadline, "reset-keeps-deadline", "A reset keeps the deadline.", "reset never revives"),
        (Defect::OldEstopDropped, "old-estop-dropped", "A stale ESTOP is dropped.", "estop is never lost"),
        (
            Defect::TornEstopDropped,
            "torn-estop-dropped",
            "An ESTOP in a malformed frame is dropped.",
            "estop is never lost",
        ),
        (Defect::ActiveClearsLatch, "active-clears-latch", "A newer active command ends ESTOP.", "latch"),
        (Defect::EstopIsHold, "estop-is-hold", "An ESTOP only holds.", "latch"),
        (Defect::HoldClearsLatch, "hold-clears-latch", "A HOLD ends ESTOP.", "latch"),
    ];

    fn models(small: bool) -> Vec<Link> {
        let link = |seqs, bodies| Link { defect: None, seqs, bodies };
        if small { vec![link(2, &ORDERED)] } else { vec![link(2, &ALL), link(3, &ORDERED)] }
    }

    fn broken(defect: Defect) -> Link {
        Link { defect: Some(defect), seqs: 2, bodies: &ALL }
    }

    fn bounds(small: bool) -> String {
        let sent = if small {
            "seqs 1 and 2, of modes active (ttl 250 ms), hold and estop"
        } else {
            "seqs 1 and 2, of modes active (ttl 0, 250 and 10⁹ ms), hold, hold with seq 0, estop, and estop in a \
             malformed frame; and seqs 1 to 3, of modes active (ttl 250 ms), hold and estop"
        };
        format!(
            "{sent}; all seqs once more after one restart of the sender; clock readings 0, 0.25, 0.5, 60, 60.25 s \
             and NaN, in any order; any number of deliveries, questions and resets"
        )
    }

    fn replay(defect: Defect, path: &[Event]) -> Replay {
        let path = with_an_ending(path);
        let run = |defect| {
            let mut plant = subject(defect);
            let mut answers = vec![];
            for event in &path {
                match *event {
                    Event::Send(_) | Event::Restart => {}
                    Event::Arrive(sent, time) => {
                        plant.arrive(&text(sent), TIMES_S[time]);
                        answers.push(json!({}));
                    }
                    Event::Ask(time) => {
                        answers.push(json!({"moves": plant.ask(TIMES_S[time]).0}));
                    }
                    Event::Reset => {
                        plant.reset();
                        answers.push(json!({}));
                    }
                }
            }
            Value::Array(answers)
        };
        Replay::new(&path, defect, run, |_| Some(vector(&path)))
    }
}

fn subject(defect: Option<Defect>) -> Subject {
    match defect {
        None => Subject::Real(Box::default(), Plant::new()),
        Some(defect) => Subject::Broken(Wrong { defect, last: None, deadline: None, stopped: false }),
    }
}

/// The path, and after it what brings a wrong state to light: questions, a new command, questions.
fn with_an_ending(path: &[Event]) -> Vec<Event> {
    let newest = Sent { body: Body::Active(1), seq: 9 };
    let ending = [Event::Ask(0), Event::Ask(1), Event::Arrive(newest, 0), Event::Ask(0)];
    path.iter().copied().chain(ending).collect()
}

fn arrive(state: &mut State, sent: Sent, time: usize) {
    let before = state.plant.key();
    state.plant.arrive(&text(sent), TIMES_S[time]);
    let after = state.plant.key();
    let permit = &mut state.text;
    let last = &mut state.last;
    let newer = permit.newest.is_none_or(|newest| newest < sent.seq);
    match sent.body {
        Body::Active(ttl) if newer => {
            permit.newest = Some(sent.seq);
            permit.command = Some((time, ttl));
        }
        Body::Active(_) => {
            last.tell(after != before, STALE_COUNTED);
            last.tell(permit.moves(time), STALE);
            let is_held = permit.newest > Some(1) && sent.seq == 1;
            last.tell(state.restarted && is_held, RESTART_HELD);
        }
        Body::Hold | Body::Unstamped => {
            if sent.seq == 0 || permit.newest.is_none_or(|newest| sent.seq >= newest) {
                permit.command = None;
                if sent.seq != 0 {
                    permit.newest = Some(sent.seq);
                }
            }
        }
        Body::Estop | Body::Torn => {
            permit.latched = true;
            last.tell(!after.2, ESTOP_LOST);
            last.tell(!newer, OLD_ESTOP);
        }
    }
}

fn ask(state: &mut State, time: usize) {
    let permitted = state.text.moves(time);
    let (moves, one) = state.plant.ask(TIMES_S[time]);
    let last = &mut state.last;
    last.tell(moves && !permitted && !state.text.latched, MOVED_WRONGLY);
    last.tell(!moves && permitted, HELD_WRONGLY);
    last.tell(moves && state.text.latched, LATCH_MOVED);
    last.tell(moves && state.text.newest.is_none(), REVIVED);
    last.tell(!one, NOT_ONE);
    last.tell(moves, MOVED);
    let (had, latched) = (state.text.command, state.text.latched);
    last.tell(!moves && had.is_some() && !latched, EXPIRED);
    let at_end = had.is_some_and(|(received, ttl)| TTLS_MS[ttl] == 250.0 && received + 1 == time);
    last.tell(moves && at_end, MOVED_AT_END);
    last.tell(moves && state.restarted && state.text.newest == Some(1), RESTART_MOVED);
    // [NCP-RES-010] A hold persists, and so what has expired is no permit any more.
    let lives = Permit { latched: false, ..state.text };
    if !lives.moves(time) {
        state.text.command = None;
    }
}

/// The frame as it goes over the wire.
fn text(sent: Sent) -> String {
    let (mode, ttl_ms) = match sent.body {
        Body::Active(ttl) => (Mode::Active, TTLS_MS[ttl]),
        Body::Hold | Body::Unstamped => (Mode::Hold, 200.0),
        Body::Estop => (Mode::Estop, 200.0),
        Body::Torn => {
            return format!(r#"{{"kind":"command_frame","seq":"{}","mode":"estop","mode":"estop"}}"#, sent.seq);
        }
    };
    let channel = ChannelValue::new([1.0, 0.0, 0.0], "m/s");
    let frame = CommandFrame {
        seq: sent.seq,
        mode,
        ttl_ms,
        channels: ChannelMap::from_iter([("velocity_setpoint", channel)]),
        ..CommandFrame::default()
    };
    frame.encode().unwrap_or_default()
}

fn vector(path: &[Event]) -> Value {
    let mut buffer = ActionBuffer::new();
    let (mut steps, mut answers) = (vec![], vec![]);
    for event in path {
        match *event {
            Event::Send(_) | Event::Restart => {}
            Event::Arrive(sent, time) => {
                let text = text(sent);
                let _ = buffer.on_frame(text.as_bytes(), TIMES_S[time]);
                steps.push(json!({"op": "command", "text": text, "now_s": number(TIMES_S[time])}));
                answers.push(json!({"$anything": true}));
            }
            Event::Ask(time) => {
                let moves = buffer.active(TIMES_S[time]).is_some();
                steps.push(json!({"op": "active", "now_s": number(TIMES_S[time])}));
                let channels = json!({"velocity_setpoint": {"data": [1.0, 0.0, 0.0]}});
                answers.push(json!({"channels": moves.then_some(channels)}));
            }
            Event::Reset => {
                buffer.reset();
                steps.push(json!({"op": "reset"}));
                answers.push(json!({}));
            }
        }
    }
    case("body", "buffer.run", json!({"steps": steps}), pattern(json!({"steps": answers})))
}

fn number(value: f64) -> Value {
    if value.is_nan() { json!("NaN") } else { json!(value) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::explore::{check, refute};

    #[test]
    fn the_plant_keeps_its_claims() {
        for checked in check::<PlantSide>(true) {
            assert!(checked.is_proved(), "{checked:?}");
        }
    }

    #[test]
    fn every_broken_plant_is_refuted() {
        for broken in refute::<PlantSide>() {
            assert!(broken.is_refuted(), "{broken:?}");
        }
    }

    /// So that a broken variant is refuted for its defect and for nothing else.
    #[test]
    fn the_plant_of_the_broken_variants_is_right_without_a_defect() {
        use stateright::Checker;
        let model = Link { seqs: 2, bodies: &ORDERED, ..PlantSide::broken(Defect::Nothing) };
        let checker = model.checker().spawn_bfs().join();
        for claim in PlantSide::CLAIMS {
            assert!(checker.discovery(claim.name).is_none(), "{claim:?}");
        }
    }
}
