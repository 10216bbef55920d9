//! Each thing that can happen to a control loop, a thousand times over, and behind it all that a loop does.
//!
//! What counts, fills up or wears out shows only in the long case of a pair; it rests on the short one.

use super::tick::{Step, arrives_at, frame, holds, moves_by, reset, run, stops, waits};
use crate::case::Case;
use crate::json::{Json, object};
use crate::trace::num;

pub(super) fn cases() -> Vec<Case> {
    let rounds = ROUNDS.into_iter().flat_map(|round| TIMES.map(|times| round.case(times)));
    rounds.chain(between_ticks()).chain([begun_again()]).collect()
}

/// Frames of which a thousand come between two ticks: behind the newest, or before it.
fn between_ticks() -> [Case; 3] {
    const MANY: i64 = 1_100;
    let at = FIRST + 0.125;
    let newest = |seq| vec![elsewhere(seq, at)];
    let older = [newest(3), (0..MANY).map(|_| inside(2, at)).collect()].concat();
    let begun_again = [newest(3 + MANY), (3..3 + MANY).map(|seq| inside(seq, at)).collect()].concat();
    let newer = [(3..3 + MANY).map(|seq| inside(seq, at)).collect(), newest(3 + MANY)].concat();
    let streams = [
        ("older", "behind it", older),
        ("older-and-rising", "rise behind it", begun_again),
        ("newer", "before it", newer),
    ];
    streams.map(|(name, words, frames)| {
        let before = vec![inside(2, FIRST), moves(FIRST)];
        let steps = [before, frames, vec![moves_by(&[-0.25, 0.0, 0.0], at)]].concat();
        let limits = object! { "geofence_radius_m" => num(5.0) };
        run(format!("endures/between-ticks/{name}"), &["NCP-CTRL-011"], 50.0, limits, steps)
            .title(format!("The loop acts on the newest frame, however many others come {words} before the tick."))
            .because("What a loop decides depends on its latch and on the frames, and on no count of either.")
    })
}

/// A sensor that begins again at 1, and of which every frame is followed by a tick.
fn begun_again() -> Case {
    const NEWEST: i64 = 5_000;
    #[expect(clippy::cast_precision_loss, reason = "a few hundred")]
    let at = |nth: i64| FIRST + 0.5625 + nth as f64 / 8.0;
    let again = (1..=300).flat_map(|nth| [elsewhere(nth, at(nth)), holds(at(nth))]);
    let late = at(301);
    let steps = [inside(NEWEST, FIRST), moves(FIRST)].into_iter().chain(again);
    let steps = steps.chain([inside(NEWEST + 1, late), moves(late)]).collect();
    let limits = object! { "geofence_radius_m" => num(5.0) };
    run("endures/begun-again", &["NCP-CTRL-011", "NCP-CTRL-012"], 50.0, limits, steps)
        .title("A sensor whose seq begins again holds the plant at each of 300 ticks, until its seq is newer.")
        .because(
            "A sensor whose seq begins again is not newer, and so is held before a reset, however long it goes on.",
        )
}

/// How often a round comes: few enough for what is wrong from the beginning, and many.
const TIMES: [(&str, &str, i64); 2] = [("twice", "two", 2), ("for-long", "1,100", 1100)];

/// What happens again and again: the steps of the round whose first frame has a seq, from a time on.
struct Round {
    name: &'static str,
    words: &'static str,
    rules: &'static [&'static str],
    steps: fn(i64, f64) -> Vec<Step>,
    /// How many seqs it has.
    seqs: i64,
    /// How long it takes, a multiple of 1/16 s.
    lasts: f64,
}

const ROUNDS: [Round; 8] = [
    Round {
        name: "moved",
        words: "a frame that moves the plant",
        rules: &["NCP-CTRL-011"],
        steps: |seq, now| vec![inside(seq, now), moves(now)],
        seqs: 1,
        lasts: 0.125,
    },
    Round {
        name: "stale",
        words: "a frame that moves the plant and grows stale",
        rules: &["NCP-SAFE-022", "NCP-SAFE-033"],
        steps: |seq, now| vec![inside(seq, now), moves(now), moves(now + 0.5), holds(now + 1.0)],
        seqs: 1,
        lasts: 1.5,
    },
    Round {
        name: "outside",
        words: "a frame outside the fence, a reset and a frame inside",
        rules: &["NCP-SAFE-008", "NCP-SAFE-043"],
        steps: |seq, now| {
            vec![outside(seq, now), stops(now), reset(), inside(seq + 1, now + 0.0625), moves(now + 0.0625)]
        },
        seqs: 2,
        lasts: 0.125,
    },
    Round {
        name: "older",
        words: "a frame and an older one",
        rules: &["NCP-CTRL-011"],
        steps: |seq, now| vec![inside(seq, now), elsewhere(seq - 1, now), moves(now)],
        seqs: 1,
        lasts: 0.125,
    },
    Round {
        name: "repeated",
        words: "a frame that comes twice, the second time from elsewhere",
        rules: &["NCP-CTRL-011"],
        steps: |seq, now| vec![inside(seq, now), moves(now), elsewhere(seq, now + 0.0625), moves(now + 0.0625)],
        seqs: 1,
        lasts: 0.125,
    },
    Round {
        name: "blind",
        words: "a frame without a position and one with it",
        rules: &["NCP-CTRL-011", "NCP-SAFE-022"],
        steps: |seq, now| {
            let blind = frame(seq, t(seq), Json::object(), now);
            vec![blind, waits(now), inside(seq + 1, now + 0.0625), moves(now + 0.0625)]
        },
        seqs: 2,
        lasts: 0.125,
    },
    Round {
        name: "reset",
        words: "a reset and a frame",
        rules: &["NCP-CTRL-011", "NCP-SAFE-008"],
        steps: |seq, now| vec![reset(), inside(seq, now), moves(now)],
        seqs: 1,
        lasts: 0.125,
    },
    Round {
        name: "asked",
        words: "a tick without a new frame",
        rules: &["NCP-CTRL-011"],
        steps: |_, now| vec![moves(now)],
        seqs: 0,
        lasts: 0.0,
    },
];

/// When the first frame comes.
const FIRST: f64 = 1.0;

/// The sender's clock.
#[expect(clippy::cast_precision_loss, reason = "a few thousand")]
fn t(seq: i64) -> f64 {
    seq as f64 / 8.0
}

fn inside(seq: i64, now: f64) -> Step {
    arrives_at(seq, t(seq), &[0.5, 0.0, 0.0], now)
}

fn elsewhere(seq: i64, now: f64) -> Step {
    arrives_at(seq, t(seq), &[0.25, 0.0, 0.0], now)
}

fn outside(seq: i64, now: f64) -> Step {
    arrives_at(seq, t(seq), &[6.0, 0.0, 0.0], now)
}

/// What follows from a frame inside.
fn moves(now: f64) -> Step {
    moves_by(&[-0.5, 0.0, 0.0], now)
}

impl Round {
    /// The round so many times at a loop that moves its plant, and all that a loop does.
    fn case(&self, (name, words, times): (&str, &str, i64)) -> Case {
        let mut steps = vec![inside(1, FIRST), moves(FIRST)];
        #[expect(clippy::cast_precision_loss, reason = "a few thousand")]
        let at = |nth: i64| FIRST + 0.125 + nth as f64 * self.lasts;
        for nth in 0..times {
            steps.extend((self.steps)(2 + nth * self.seqs, at(nth)));
        }
        steps.extend(everything(2 + times * self.seqs, at(times) + 0.125));
        let limits = object! { "geofence_radius_m" => num(5.0) };
        let case = run(format!("endures/{}/{name}", self.name), self.rules, 50.0, limits, steps)
            .title(format!("Behind {words} times {}, a loop does all that it did before.", self.words))
            .because("What a loop decides depends on its latch and on the frames, and on no count of either.");
        let short = || format!("control/loop/endures/{}/twice", self.name);
        if times > 2 { case.rests_on(short()) } else { case }
    }
}

/// All that a loop does, with frames from a seq on and from a time on.
fn everything(seq: i64, now: f64) -> Vec<Step> {
    vec![
        inside(seq, now),
        moves(now),
        elsewhere(seq - 1, now + 0.0625),
        moves(now + 0.0625),
        holds(now + 1.0),
        inside(seq + 1, now + 1.125),
        moves(now + 1.125),
        outside(seq + 2, now + 1.25),
        stops(now + 1.25),
        inside(seq + 3, now + 1.375),
        stops(now + 1.375),
        reset(),
        inside(seq + 4, now + 1.5),
        moves(now + 1.5),
    ]
}
