//! Each thing that can happen to a plant, a thousand times over, and behind it all that a plant does.
//!
//! What counts, fills up or wears out shows only in the long case of a pair; it rests on the short one, which shows
//! what is wrong from the beginning.

use super::model::{Event, Run, buffer, watchdog};
use crate::case::{Case, File, Role};
use crate::command::{Command, active};
use crate::json::Json;

pub(super) fn file() -> File {
    let mut cases = Vec::new();
    for round in ROUNDS {
        let of_buffer = round.buffer.map(|rules| ("buffer", rules));
        let of_watchdog = round.watchdog.map(|rules| ("watchdog", rules));
        for (plant, rules) in of_buffer.into_iter().chain(of_watchdog) {
            cases.extend(TIMES.map(|times| round.case(plant, rules, times)));
        }
        // Of a strict plant one short case shows whether it moves at all.
        let times = if round.name == "followed" { &TIMES[..] } else { &TIMES[1..] };
        cases.extend(
            round.strict.into_iter().flat_map(|rules| times.iter().map(|times| round.case("strict", rules, *times))),
        );
    }
    let about = "Plants that go through the same a thousand times, and behind it through all that a plant does: \
                 commands that advance and that do not, HOLDs, horizons, ESTOP, and resets.";
    File::new("resilience", "endures", about, cases)
}

/// How often a round comes: few enough for what is wrong from the beginning, and many.
const TIMES: [(&str, &str, i64); 2] = [("twice", "two", 2), ("for-long", "1,100", 1100)];

/// What happens again and again.
struct Round {
    name: &'static str,
    words: &'static str,
    /// The events of the round of a number, which begins at a time.
    events: fn(i64, f64) -> Vec<Event>,
    /// How long it takes, a multiple of 1/16 s.
    lasts: f64,
    /// The rules that it is about, of a buffer, a strict buffer and a watchdog, if it is asked of such.
    buffer: Option<&'static [&'static str]>,
    strict: Option<&'static [&'static str]>,
    watchdog: Option<&'static [&'static str]>,
}

const ROUNDS: [Round; 19] = [
    Round {
        name: "followed",
        words: "a command that is followed",
        events: |nth, now| vec![go(BEFORE + nth, now), Event::Ask(now)],
        lasts: 0.0625,
        buffer: Some(&["NCP-RES-026"]),
        strict: Some(&["NCP-RES-026"]),
        watchdog: Some(&["NCP-RES-013"]),
    },
    Round {
        name: "expired",
        words: "a command that is held when its time is over",
        events: |nth, now| vec![go(BEFORE + nth, now), Event::Ask(now + 0.3125)],
        lasts: 0.5,
        buffer: Some(&["NCP-RES-002"]),
        strict: Some(&["NCP-RES-002"]),
        watchdog: Some(&["NCP-RES-002"]),
    },
    Round {
        name: "followed-and-expired",
        words: "a command that is followed to the end of its time and then held",
        events: |nth, now| {
            vec![go(BEFORE + nth, now), Event::Ask(now), Event::Ask(now + 0.25), Event::Ask(now + 0.3125)]
        },
        lasts: 0.5,
        buffer: Some(&["NCP-RES-003", "NCP-RES-002"]),
        strict: Some(&["NCP-RES-003", "NCP-RES-002"]),
        watchdog: Some(&["NCP-RES-003", "NCP-RES-002"]),
    },
    Round {
        name: "of-no-time",
        words: "a command whose ttl is 0, and one with time behind it",
        events: |nth, now| {
            vec![
                Event::Command(command(BEFORE + 2 * nth).ttl(0.0), now),
                Event::Ask(now),
                go(BEFORE + 2 * nth + 1, now),
            ]
        },
        lasts: 0.0625,
        buffer: Some(&["NCP-RES-026", "NCP-RES-005"]),
        strict: Some(&["NCP-RES-026", "NCP-RES-005"]),
        watchdog: Some(&["NCP-RES-013", "NCP-RES-005"]),
    },
    Round {
        name: "duplicates",
        words: "a duplicate of the command before",
        events: |nth, now| vec![go(BEFORE + nth, now), go(BEFORE + nth, now), Event::Ask(now)],
        lasts: 0.0625,
        buffer: Some(&["NCP-RES-026", "NCP-RES-020"]),
        strict: Some(&["NCP-RES-026", "NCP-STRICT-005"]),
        watchdog: Some(&["NCP-RES-013", "NCP-RES-009"]),
    },
    Round {
        name: "reordered",
        words: "a command that comes behind its successor",
        events: |nth, now| vec![go(BEFORE + 2 * nth, now), go(BEFORE + 2 * nth - 1, now), Event::Ask(now)],
        lasts: 0.0625,
        buffer: Some(&["NCP-RES-026", "NCP-RES-020"]),
        strict: Some(&["NCP-RES-026", "NCP-STRICT-005"]),
        watchdog: Some(&["NCP-RES-013", "NCP-RES-009"]),
    },
    Round {
        name: "asked",
        words: "a question while it moves",
        events: |_, now| vec![Event::Ask(now)],
        lasts: 0.0,
        buffer: Some(&["NCP-RES-026"]),
        strict: Some(&["NCP-RES-026"]),
        watchdog: Some(&["NCP-RES-013"]),
    },
    Round {
        name: "asked-late",
        words: "a question while it holds",
        events: |_, now| vec![Event::Ask(now + 0.3125)],
        lasts: 0.0625,
        buffer: Some(&["NCP-RES-010"]),
        strict: Some(&["NCP-RES-010"]),
        watchdog: Some(&["NCP-RES-010"]),
    },
    Round {
        name: "held",
        words: "a HOLD, and a command behind it",
        events: |nth, now| {
            let seq = BEFORE + 2 * nth;
            vec![hold("hold", seq, now), Event::Ask(now), go(seq + 1, now), Event::Ask(now)]
        },
        lasts: 0.0625,
        buffer: Some(&["NCP-RES-026", "NCP-RES-023"]),
        strict: Some(&["NCP-RES-026", "NCP-RES-023"]),
        watchdog: None,
    },
    Round {
        name: "held-by-init",
        words: "a command in mode `init`, and one in mode `active` behind it",
        events: |nth, now| {
            let seq = BEFORE + 2 * nth;
            vec![hold("init", seq, now), Event::Ask(now), go(seq + 1, now), Event::Ask(now)]
        },
        lasts: 0.0625,
        buffer: Some(&["NCP-RES-026", "NCP-RES-023"]),
        strict: Some(&["NCP-RES-026", "NCP-RES-023"]),
        watchdog: None,
    },
    Round {
        name: "held-by-the-last-seq",
        words: "a HOLD of the last seq, and a command behind it",
        events: |nth, now| {
            let seq = BEFORE + nth;
            vec![go(seq, now), Event::Ask(now), hold("hold", seq, now), Event::Ask(now)]
        },
        lasts: 0.0625,
        buffer: Some(&["NCP-RES-026", "NCP-RES-023"]),
        strict: None,
        watchdog: None,
    },
    Round {
        name: "held-without-a-stamp",
        words: "a HOLD without a stamp, and a command behind it",
        events: |nth, now| vec![go(BEFORE + nth, now), Event::Ask(now), hold("hold", 0, now), Event::Ask(now)],
        lasts: 0.0625,
        buffer: Some(&["NCP-RES-026", "NCP-RES-023"]),
        strict: None,
        watchdog: None,
    },
    Round {
        name: "horizon",
        words: "a horizon that is followed past its end",
        events: |nth, now| {
            let horizon = command(BEFORE + nth).along_x(62.5, &[8.0, 9.0]);
            let asks = [0.0, 0.0625, 0.125, 0.1875].map(|later| Event::Ask(now + later));
            std::iter::once(Event::Command(horizon, now)).chain(asks).collect()
        },
        lasts: 0.25,
        buffer: Some(&["NCP-RES-028", "NCP-RES-029"]),
        strict: Some(&["NCP-RES-028", "NCP-RES-029"]),
        watchdog: None,
    },
    Round {
        name: "horizon-left-early",
        words: "a horizon of which the next command takes over",
        events: |nth, now| {
            let horizon = command(BEFORE + nth).along_x(62.5, &[8.0, 9.0]);
            vec![Event::Command(horizon, now), Event::Ask(now + 0.0625)]
        },
        lasts: 0.125,
        buffer: Some(&["NCP-RES-028"]),
        strict: Some(&["NCP-RES-028"]),
        watchdog: None,
    },
    Round {
        name: "stopped",
        words: "a command in mode `estop`, and a reset",
        events: |_, now| {
            vec![hold("estop", 5, now), Event::Ask(now), Event::Reset, Event::Ask(now), go(1, now), Event::Ask(now)]
        },
        lasts: 0.0625,
        buffer: Some(&["NCP-RES-030", "NCP-RES-021"]),
        strict: Some(&["NCP-RES-030", "NCP-RES-021"]),
        watchdog: None,
    },
    Round {
        name: "stopped-by-a-faulty-frame",
        words: "an ESTOP in a frame that no decoder accepts, and a reset",
        events: |_, now| {
            let text = Json::string(r#"{"kind":"command_frame","mode":"estop","seq":[]}"#);
            let stop = Event::Text { text, now, stops: true };
            vec![stop, Event::Ask(now), Event::Reset, go(1, now), Event::Ask(now)]
        },
        lasts: 0.0625,
        buffer: Some(&["NCP-RES-030", "NCP-RES-022"]),
        strict: Some(&["NCP-RES-030", "NCP-RES-022"]),
        watchdog: None,
    },
    Round {
        name: "stopped-still",
        words: "a command while ESTOP is latched",
        events: |nth, now| vec![hold("estop", BEFORE, now), go(BEFORE + nth, now), Event::Ask(now)],
        lasts: 0.0625,
        buffer: Some(&["NCP-RES-025", "NCP-RES-021"]),
        strict: Some(&["NCP-RES-025", "NCP-RES-021"]),
        watchdog: None,
    },
    Round {
        name: "reset",
        words: "a reset, and a stream that begins anew",
        events: |_, now| vec![Event::Reset, Event::Ask(now), go(1, now), Event::Ask(now)],
        lasts: 0.0625,
        buffer: Some(&["NCP-RES-030", "NCP-RES-031"]),
        strict: Some(&["NCP-RES-030", "NCP-RES-031"]),
        watchdog: Some(&["NCP-RES-012", "NCP-RES-011"]),
    },
    Round {
        name: "reset-at-rest",
        words: "a reset with nothing to clear",
        events: |_, now| vec![Event::Reset, Event::Ask(now)],
        lasts: 0.0625,
        buffer: Some(&["NCP-RES-031"]),
        strict: Some(&["NCP-RES-031"]),
        watchdog: Some(&["NCP-RES-011"]),
    },
];

/// The last seq before the first round, and when it comes.
const BEFORE: i64 = 9;
const FIRST: f64 = 8.0;

/// A command that moves as all do, so that rounds differ in the seq alone.
fn command(seq: i64) -> Command {
    active(seq).x(7.0)
}

fn go(seq: i64, now: f64) -> Event {
    Event::Command(command(seq), now)
}

/// A command of the seq in a mode that does not move.
fn hold(mode: &str, seq: i64, now: f64) -> Event {
    Event::Command(command(seq).mode(mode), now)
}

impl Round {
    /// The round so many times at a plant that moves, and all that a plant does.
    fn case(&self, plant: &str, rules: &[&'static str], (name, words, times): (&str, &str, i64)) -> Case {
        let mut events = vec![go(BEFORE, FIRST), Event::Ask(FIRST)];
        for nth in 1..=times {
            #[expect(clippy::cast_precision_loss, reason = "a few thousand")]
            events.extend((self.events)(nth, FIRST + 0.0625 + (nth - 1) as f64 * self.lasts));
        }
        let repeated = events.len();
        #[expect(clippy::cast_precision_loss, reason = "a few thousand")]
        events.extend(everything(BEFORE + 2 * times, FIRST + 1.0 + times as f64 * self.lasts, plant != "watchdog"));
        let (args, pattern, decided): Run = match plant {
            "watchdog" => watchdog(&events),
            plant => buffer(&events, plant == "strict"),
        };
        // Of many rounds, the case is about each.
        let is_long = times > 2;
        let decided: Vec<_> =
            decided.into_iter().enumerate().map(|(nth, rule)| rule.filter(|_| !is_long || nth >= repeated)).collect();
        let call = if plant == "watchdog" { "watchdog.run" } else { "buffer.run" };
        let case = Case::new(format!("{plant}/{}/{name}", self.name), rules, &[Role::Body])
            .call(call, args)
            .shows(pattern)
            .decided_throughout_by(&decided)
            .title(format!("Behind {words} times {}, a plant does all that it did before.", self.words))
            .flags(&["liveness"])
            .because("Sections 8.1 and 8.2: none of their rules asks how often something has happened.");
        // Only a strict plant is asked what a strict one does with the commands that it drops.
        let case = if plant == "strict" { case.about("NCP-STRICT-011").strictly() } else { case };
        let short = |plant: &str, name: &str| format!("resilience/endures/{plant}/{name}/twice");
        match (is_long, plant) {
            (true, "strict") => case.rests_on(short("buffer", self.name)).rests_on(short(plant, "followed")),
            (true, plant) => case.rests_on(short(plant, self.name)),
            (false, _) => case,
        }
    }
}

/// All that a plant does, behind a stream up to a seq and from a time on; a watchdog knows neither modes nor horizons.
fn everything(last: i64, from: f64, knows_modes: bool) -> Vec<Event> {
    let (mut now, mut events) = (from, vec![Event::Ask(from)]);
    let mut then = |more: &[Event], pause: f64| {
        events.extend_from_slice(more);
        now += pause;
        now
    };
    let at = then(&[], 1.0);
    let at = then(&[go(last + 1, at), Event::Ask(at), Event::Ask(at + 0.25), Event::Ask(at + 0.3125)], 1.0);
    let at = then(&[go(last, at), Event::Ask(at), go(last + 2, at), Event::Ask(at)], 0.125);
    let at = then(&[go(last + 2, at), Event::Ask(at), Event::Ask(at + 0.1875)], 1.0);
    let at = if knows_modes {
        let at = then(&[go(last + 3, at), Event::Ask(at), hold("hold", last + 4, at), Event::Ask(at)], 0.125);
        let at = then(&[go(last + 4, at), Event::Ask(at), go(last + 5, at), Event::Ask(at)], 1.0);
        let horizon = Event::Command(command(last + 6).along_x(62.5, &[8.0, 9.0]), at);
        let asks = [0.0, 0.0625, 0.125, 0.1875].map(|later| Event::Ask(at + later));
        let at = then(&[&[horizon], &asks[..]].concat(), 1.0);
        let at = then(&[go(last + 7, at), Event::Ask(at), hold("estop", last, at), Event::Ask(at)], 0.125);
        then(&[go(last + 8, at), Event::Ask(at)], 0.125)
    } else {
        at
    };
    let at = then(&[Event::Reset, Event::Ask(at), go(1, at), Event::Ask(at)], 0.125);
    then(
        &[go(1, at), Event::Ask(at + 0.125), Event::Ask(at + 0.1875), go(2, at + 0.1875), Event::Ask(at + 0.1875)],
        0.0,
    );
    events
}
