//! The latch at both ends: the governor of a commander, the network, and the plant.
//!
//! Both ends are the specification's: what the governor lets out is encoded, sent, and read by the
//! action buffer. Each end has a reset of its own. The clock stands still: it is the matter of the
//! model of the plant.

use std::hash::{Hash, Hasher};

use ncp_spec::resilience::ActionBuffer;
use ncp_spec::safety::SafetyGovernor;
use ncp_spec::wire::{ChannelMap, ChannelValue, CommandFrame, Frame, Mode, SafetyLimits, SensorFrame};
use serde_json::{Value, json};
use stateright::{Model, Property};

use crate::explore::{Claim, Protocol, Replay, Variant, case, pattern};
use crate::signs::{Signs, always, sometimes};

/// Where the sensor sees the plant, in m from the origin of a fence of 10 m; NaN is no place.
const PLACES_M: [f64; 3] = [0.0, 20.0, f64::NAN];
const MODES: [Mode; 3] = [Mode::Active, Mode::Hold, Mode::Estop];

/// What happens next.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Event {
    /// The controller proposes a command of `MODES` while the sensor sees a place of `PLACES_M`, or
    /// has no time; what the governor makes of it is sent.
    Govern(usize, Option<usize>),
    /// The link monitor speaks: a burst or none.
    Link(bool),
    ResetGovernor,
    /// The frame of that number arrives at the plant.
    Arrive(usize),
    ResetPlant,
}

/// The two ends, and all that was sent.
#[derive(Debug, Clone)]
pub(crate) struct State {
    governor: SafetyGovernor,
    faulty: bool,
    plant: ActionBuffer,
    /// Mode by mode, in the order of their seqs.
    sent: Vec<Mode>,
    /// By the text: whether the governor is latched, whether the plant is.
    latched: [bool; 2],
    /// The highest seq that the plant obeyed since its reset, and whether by it it moves.
    obeyed: Option<(usize, bool)>,
    last: Signs,
}

impl State {
    /// All that tells two states apart: the plant's own seq and deadline follow from what it obeyed.
    fn key(&self) -> impl Hash + PartialEq + '_ {
        let mut plant = self.plant.clone();
        let ends = (self.governor.is_stopped(), self.plant.is_stopped(), plant.active(0.0).is_some());
        (ends, self.faulty, &self.sent, self.latched, self.obeyed, self.last)
    }
}

impl PartialEq for State {
    fn eq(&self, other: &Self) -> bool {
        self.key() == other.key()
    }
}

impl Hash for State {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.key().hash(state);
    }
}

mod sign {
    pub(super) const LATCH_LET_OUT: u16 = 1;
    pub(super) const NOT_LATCHED: u16 = 1 << 1;
    pub(super) const FAULT_LET_OUT: u16 = 1 << 2;
    pub(super) const PLANT_MOVED: u16 = 1 << 3;
    pub(super) const UNLATCHED_BY_OTHER: u16 = 1 << 4;
    pub(super) const NOT_ACTIVE_MOVED: u16 = 1 << 5;
    pub(super) const PASSED: u16 = 1 << 6;
    pub(super) const STOPPED: u16 = 1 << 7;
    pub(super) const BOTH_LATCHED: u16 = 1 << 8;
    pub(super) const MOVED_AGAIN: u16 = 1 << 9;
    pub(super) const FAULT_HELD: u16 = 1 << 10;
}
use sign::*;

/// What is broken in the governor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Defect {
    InsideReleases,
    FenceOnlyHolds,
    EstopIsPassedOn,
    BurstIgnored,
    QuietLinkReleases,
    NanIsInside,
    ResetClearsFault,
    HoldIsPassedOn,
}

/// The model, over the real governor or a broken one.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Ends {
    defect: Option<Defect>,
    frames: usize,
}

fn governor(faulty: bool) -> SafetyGovernor {
    SafetyGovernor::new(&SafetyLimits {
        geofence_radius_m: Some(10.0),
        max_speed_mps: Some(if faulty { -1.0 } else { 5.0 }),
        command_timeout_ms: 500.0,
        ..SafetyLimits::default()
    })
}

/// What a governor, whole or broken, makes of a command.
fn govern(
    defect: Option<Defect>,
    governor: &mut SafetyGovernor,
    seq: usize,
    mode: usize,
    place: Option<usize>,
) -> CommandFrame {
    let mut frame = command(seq, MODES[mode]);
    let place_m = place.map(|place| PLACES_M[place]);
    let place_m = match defect {
        Some(Defect::NanIsInside) if place_m.is_some_and(f64::is_nan) => Some(0.0),
        _ => place_m,
    };
    let sensor = sensor(place_m.unwrap_or(0.0));
    if defect == Some(Defect::InsideReleases) && place_m == Some(0.0) {
        governor.reset();
    }
    let was_stopped = governor.is_stopped();
    governor.govern(&mut frame, 0.0, Some(&sensor), place_m.map(|_| 0.0));
    match defect {
        Some(Defect::FenceOnlyHolds) if !was_stopped && place.is_some_and(|place| place > 0) => {
            governor.reset();
            frame.mode = Mode::Hold;
        }
        Some(Defect::EstopIsPassedOn) if !was_stopped && MODES[mode] == Mode::Estop => {
            governor.reset();
        }
        Some(Defect::HoldIsPassedOn) if MODES[mode] == Mode::Hold && frame.mode == Mode::Hold => {
            frame = command(seq, Mode::Active);
        }
        _ => {}
    }
    frame
}

fn note_link(defect: Option<Defect>, governor: &mut SafetyGovernor, burst: bool) {
    match defect {
        Some(Defect::BurstIgnored) => {}
        Some(Defect::QuietLinkReleases) if !burst => governor.reset(),
        _ => governor.note_link(burst),
    }
}

fn reset(defect: Option<Defect>, latched: &mut SafetyGovernor) {
    if defect == Some(Defect::ResetClearsFault) {
        *latched = governor(false);
    }
    latched.reset();
}

impl Model for Ends {
    type State = State;
    type Action = Event;

    fn init_states(&self) -> Vec<State> {
        let state = |faulty| State {
            governor: governor(faulty),
            faulty,
            plant: ActionBuffer::new(),
            sent: vec![],
            latched: [false, false],
            obeyed: None,
            last: Signs::default(),
        };
        vec![state(false), state(true)]
    }

    fn actions(&self, state: &State, actions: &mut Vec<Event>) {
        if state.sent.len() < self.frames {
            for mode in 0..MODES.len() {
                let places = (0..PLACES_M.len()).map(Some).chain([None]);
                actions.extend(places.map(|place| Event::Govern(mode, place)));
            }
        }
        actions.extend([Event::Link(false), Event::Link(true)]);
        actions.extend([Event::ResetGovernor, Event::ResetPlant]);
        actions.extend((0..state.sent.len()).map(Event::Arrive));
    }

    fn next_state(&self, before: &State, event: Event) -> Option<State> {
        let mut state = before.clone();
        let last = &mut state.last;
        *last = Signs::default();
        match event {
            Event::Govern(mode, place) => {
                let seq = state.sent.len() + 1;
                let frame = govern(self.defect, &mut state.governor, seq, mode, place);
                let outside = place.is_some_and(|place| place > 0) && !state.faulty;
                state.latched[0] |= MODES[mode] == Mode::Estop || outside;
                last.tell(state.latched[0] && frame.mode != Mode::Estop, LATCH_LET_OUT);
                last.tell(state.latched[0] != state.governor.is_stopped(), NOT_LATCHED);
                last.tell(state.faulty && frame.mode == Mode::Active, FAULT_LET_OUT);
                last.tell(MODES[mode] != Mode::Active && frame.mode == Mode::Active, NOT_ACTIVE_MOVED);
                last.tell(frame.mode == Mode::Active, PASSED);
                last.tell(frame.mode == Mode::Estop, STOPPED);
                last.tell(state.faulty && frame.mode == Mode::Hold, FAULT_HELD);
                state.sent.push(frame.mode);
            }
            Event::Link(burst) => {
                note_link(self.defect, &mut state.governor, burst);
                state.latched[0] |= burst;
                last.tell(state.latched[0] != state.governor.is_stopped(), NOT_LATCHED);
            }
            Event::ResetGovernor => {
                reset(self.defect, &mut state.governor);
                state.latched[0] = false;
                last.tell(state.latched[1] != state.plant.is_stopped(), UNLATCHED_BY_OTHER);
            }
            Event::ResetPlant => {
                state.plant.reset();
                state.latched[1] = false;
                state.obeyed = None;
                last.tell(state.latched[0] != state.governor.is_stopped(), UNLATCHED_BY_OTHER);
            }
            Event::Arrive(number) => {
                let seq = number + 1;
                let text = command(seq, state.sent[number]).encode().unwrap_or_default();
                let had_reset = state.sent.contains(&Mode::Estop) && state.obeyed.is_none();
                let _ = state.plant.on_frame(text.as_bytes(), 0.0);
                let newest = state.obeyed.map(|(newest, _)| newest);
                match state.sent[number] {
                    Mode::Estop => state.latched[1] = true,
                    Mode::Active if newest.is_none_or(|newest| newest < seq) => {
                        state.obeyed = Some((seq, true));
                    }
                    Mode::Hold if newest.is_none_or(|newest| newest <= seq) => {
                        state.obeyed = Some((seq, false));
                    }
                    _ => {}
                }
                let moves = state.plant.active(0.0).is_some();
                let may = !state.latched[1] && state.obeyed.is_some_and(|(_, moves)| moves);
                last.tell(moves != may || state.plant.is_stopped() != state.latched[1], PLANT_MOVED);
                last.tell(state.latched == [true, true], BOTH_LATCHED);
                last.tell(moves && had_reset, MOVED_AGAIN);
            }
        }
        Some(state)
    }

    fn properties(&self) -> Vec<Property<Self>> {
        vec![
            always!("latched governor sends ESTOP", LATCH_LET_OUT),
            always!("governor latches", NOT_LATCHED),
            always!("config fault lets nothing out", FAULT_LET_OUT),
            always!("plant obeys", PLANT_MOVED),
            always!("each reset is for its own side", UNLATCHED_BY_OTHER),
            always!("only active moves", NOT_ACTIVE_MOVED),
            sometimes!("a command passes the governor", PASSED),
            sometimes!("the governor stops", STOPPED),
            sometimes!("both sides are latched", BOTH_LATCHED),
            sometimes!("the plant moves after an ESTOP and a reset", MOVED_AGAIN),
            sometimes!("a config fault holds", FAULT_HELD),
        ]
    }
}

/// The latch at both ends.
pub(crate) enum Latches {}

impl Protocol for Latches {
    type Defect = Defect;
    type Model = Ends;

    const FAMILY: &'static str = "latch";
    const CLAIMS: &'static [Claim] = &[
        Claim {
            name: "latched governor sends ESTOP",
            rules: &["NCP-SAFE-003", "NCP-SAFE-005", "NCP-SAFE-020"],
            sentence: "Once latched, the governor sends nothing but ESTOP until its reset.",
            formal: "always: latched(governor) ⟹ sent.mode = estop",
        },
        Claim {
            name: "governor latches",
            rules: &["NCP-SAFE-004", "NCP-SAFE-006", "NCP-SAFE-007", "NCP-SAFE-008", "NCP-SAFE-043", "NCP-SAFE-044"],
            sentence: "The governor is latched exactly when, since its reset, it was given an ESTOP, a position \
                outside the fence or not finite, or a burst.",
            formal: "always: governor.is_stopped() ⟺ latched(governor)",
        },
        Claim {
            name: "config fault lets nothing out",
            rules: &["NCP-SAFE-009", "NCP-SAFE-013", "NCP-SAFE-017", "NCP-SAFE-018"],
            sentence: "A governor with a negative limit never sends an active command, whatever the resets.",
            formal: "always: fault ⟹ sent.mode ≠ active",
        },
        Claim {
            name: "plant obeys",
            rules: &["NCP-RES-021", "NCP-RES-023", "NCP-RES-025", "NCP-RES-030", "NCP-SAFE-001"],
            sentence: "Over every network, the plant is latched exactly from the arrival of an ESTOP to its own \
                reset, and moves exactly when it is not and the newest command that it obeyed is active.",
            formal: "always: moves ⟺ ¬latched(plant) ∧ mode(newest obeyed) = active",
        },
        Claim {
            name: "each reset is for its own side",
            rules: &["NCP-SAFE-008", "NCP-RES-030"],
            sentence: "A reset of one side leaves the latch of the other.",
            formal: "always: reset(one) ⟹ latched(other)' = latched(other)",
        },
        Claim {
            name: "only active moves",
            rules: &["NCP-SAFE-002", "NCP-SAFE-001"],
            sentence: "The governor makes no active command of one that was none.",
            formal: "always: mode ≠ active ⟹ sent.mode ≠ active",
        },
    ];
    const BROKEN: &'static [Variant<Defect>] = &[
        (
            Defect::InsideReleases,
            "inside-releases",
            "The latch ends when the plant is inside the fence again.",
            "latched governor sends ESTOP",
        ),
        (
            Defect::FenceOnlyHolds,
            "fence-only-holds",
            "A position outside the fence holds and does not latch.",
            "governor latches",
        ),
        (Defect::EstopIsPassedOn, "estop-is-passed-on", "An ESTOP is sent and does not latch.", "governor latches"),
        (Defect::BurstIgnored, "burst-ignored", "A burst does not latch.", "governor latches"),
        (Defect::QuietLinkReleases, "quiet-link-releases", "A healthy link ends ESTOP.", "governor latches"),
        (Defect::NanIsInside, "nan-is-inside", "A position that is NaN is inside.", "governor latches"),
        (
            Defect::ResetClearsFault,
            "reset-clears-fault",
            "A reset ends config fail-closed.",
            "config fault lets nothing out",
        ),
        (
            Defect::HoldIsPassedOn,
            "hold-is-passed-on",
            "A hold leaves the governor as an active command.",
            "only active moves",
        ),
    ];

    fn models(small: bool) -> Vec<Ends> {
        vec![Ends { defect: None, frames: if small { 3 } else { 5 } }]
    }

    fn broken(defect: Defect) -> Ends {
        Ends { defect: Some(defect), frames: 3 }
    }

    fn bounds(small: bool) -> String {
        format!(
            "{} commands, each active, hold or estop, with the plant seen inside the fence, outside it, at NaN, or \
             not at all; good limits and a negative one; one clock reading; any number of deliveries, bursts and \
             resets",
            Self::models(small)[0].frames
        )
    }

    fn replay(defect: Defect, path: &[Event]) -> Replay {
        // A command at the end shows the latch.
        let path: Vec<Event> = path.iter().copied().chain([Event::Govern(0, Some(0))]).collect();
        let faulty = defect == Defect::ResetClearsFault;
        let run = |defect| {
            let mut governor = governor(faulty);
            let (mut sent, mut answers) = (0, vec![]);
            for event in &path {
                match *event {
                    Event::Govern(mode, place) => {
                        sent += 1;
                        let frame = govern(defect, &mut governor, sent, mode, place);
                        answers.push(json!({"frame": {"mode": frame.mode.as_str()}}));
                        continue;
                    }
                    Event::Link(burst) => note_link(defect, &mut governor, burst),
                    Event::ResetGovernor => reset(defect, &mut governor),
                    Event::Arrive(_) | Event::ResetPlant => continue,
                }
                answers.push(json!({}));
            }
            Value::Array(answers)
        };
        Replay::new(&path, defect, run, |real| Some(vector(&path, faulty, real)))
    }
}

fn command(seq: usize, mode: Mode) -> CommandFrame {
    let velocity = ChannelValue::new([0.1, 0.0, 0.0], "m/s");
    CommandFrame {
        seq: i64::try_from(seq).unwrap_or(i64::MAX),
        mode,
        ttl_ms: 200.0,
        channels: ChannelMap::from_iter([("velocity_setpoint", velocity)]),
        ..CommandFrame::default()
    }
}

fn sensor(x_m: f64) -> SensorFrame {
    let position = ChannelValue::new([x_m, 0.0, 0.0], "m");
    SensorFrame { channels: ChannelMap::from_iter([("pose_position", position)]), ..SensorFrame::default() }
}

fn vector(path: &[Event], faulty: bool, real: &Value) -> Value {
    let max_speed_mps = if faulty { -1.0 } else { 5.0 };
    let limits = json!({"geofence_radius_m": 10.0, "max_speed_mps": max_speed_mps, "command_timeout_ms": 500.0});
    let mut seq = 0;
    let steps: Vec<Value> = path
        .iter()
        .filter_map(|event| match *event {
            Event::Govern(mode, place) => {
                seq += 1;
                let place_m = place.map_or(0.0, |place| PLACES_M[place]);
                let place_m = if place_m.is_nan() { json!("NaN") } else { json!(place_m) };
                let velocity = json!({"velocity_setpoint": {"data": [0.1, 0.0, 0.0], "unit": "m/s"}});
                let position = json!({"pose_position": {"data": [place_m, 0.0, 0.0], "unit": "m"}});
                Some(json!({
                    "op": "govern",
                    "command": {"seq": seq, "mode": MODES[mode].as_str(), "ttl_ms": 200.0, "channels": velocity},
                    "now_s": 0.0,
                    "sensor": {"channels": position},
                    "last_sensor_s": place.map(|_| 0.0),
                }))
            }
            Event::Link(burst) => Some(json!({"op": "note_link", "burst": burst})),
            Event::ResetGovernor => Some(json!({"op": "reset"})),
            Event::Arrive(_) | Event::ResetPlant => None,
        })
        .collect();
    let args = json!({"limits": limits, "capabilities": null, "steps": steps});
    case("commander", "governor.run", args, pattern(json!({"steps": real})))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::explore::{check, refute};

    #[test]
    fn both_latches_keep_their_claims() {
        for checked in check::<Latches>(true) {
            assert!(checked.is_proved(), "{checked:?}");
        }
    }

    #[test]
    fn every_broken_governor_is_refuted() {
        for broken in refute::<Latches>() {
            assert!(broken.is_refuted(), "{broken:?}");
        }
    }
}
