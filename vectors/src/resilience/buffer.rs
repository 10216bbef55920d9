//! Modes, seqs, holds, resets and malformed frames at the action buffer.

use super::model::{Event, active, buffer};
use super::{buffer_case as case, go};
use crate::case::{Case, File, Role};
use crate::json::{Json, object};
use crate::trace::{any, name_of, no_result, nums, steps};

pub(super) fn file() -> File {
    let mut cases = modes();
    cases.extend(holds());
    cases.extend(holds_without_a_clock());
    cases.extend(seqs());
    cases.extend(resets());
    cases.extend(deadlines());
    cases.extend(malformed());
    cases.extend(channels());
    let about = "The action buffer: which command a plant follows, and when it follows none.";
    File::new("resilience", "buffer", about, cases)
}

fn of(mode: &'static str, seq: i64, now: f64) -> Event {
    Event::Command(active(seq).mode(mode), now)
}

fn ask(now: f64) -> Event {
    Event::Ask(now)
}

/// A text that is an active command but for its mode.
fn with_mode(seq: i64, mode: Option<Json>) -> Json {
    let frame = active(seq).json();
    let frame = match mode {
        Some(mode) => frame.with("mode", mode),
        None => frame.without("mode"),
    };
    Json::string(frame.text())
}

/// Only `active` moves.
fn modes() -> Vec<Case> {
    let mut cases = vec![
        case("mode/active", &["NCP-RES-026"], &[go(1, 1.0), ask(1.0), ask(1.25), ask(1.3125)])
            .title("An active command moves the plant for its ttl.")
            .because("Without a horizon, `active` is the channels of tick 0, until now \u{2212} received is more than the ttl."),
        case("mode/none", &["NCP-RES-006"], &[ask(0.0), ask(1.0)])
            .title("A plant without a command holds.")
            .because("A plant holds before the first command."),
    ];
    for mode in ["hold", "init", "estop"] {
        cases.push(
            case(format!("mode/{mode}/first"), &["NCP-SAFE-001"], &[of(mode, 1, 1.0), ask(1.0), ask(1.125)])
                .title(format!("A first command in mode `{mode}` moves nothing."))
                .because("A plant does not move on a command whose mode is not `active`."),
        );
        cases.push(
            case(
                format!("mode/{mode}/second"),
                &["NCP-SAFE-001", "NCP-RES-025"],
                &[go(1, 1.0), ask(1.0), of(mode, 2, 1.0625), ask(1.0625), ask(1.125)],
            )
            .title(format!("A command in mode `{mode}` ends the active one before it."))
            .because("`active` is none while the last command is not in mode `active`."),
        );
    }
    for mode in ["hold", "init"] {
        for (name, words, before, seq) in [
            ("seq-zero", "without a stamp", Vec::new(), 0),
            ("negative", "of a negative seq", Vec::new(), -3),
            ("large", "of a large seq", Vec::new(), 9_007_199_254_740_991),
            ("after-expiry", "after a command that expired", vec![go(1, 0.5)], 2),
            ("after-reset", "after a reset", vec![go(1, 0.5), Event::Reset], 1),
            ("after-hold", "after a HOLD", vec![of("hold", 1, 0.9375)], 2),
            ("after-no-ttl", "after a command without a ttl", vec![Event::Command(active(1).ttl(0.0), 0.9375)], 2),
            ("twice", "that comes twice", vec![of(mode, 1, 0.9375)], 1),
        ] {
            let mut events = before;
            events.extend([of(mode, seq, 1.0), ask(1.0), ask(1.125)]);
            cases.push(
                case(format!("mode/{mode}/{name}"), &["NCP-SAFE-001"], &events)
                    .title(format!("A command in mode `{mode}` {words} moves nothing."))
                    .because("A plant does not move on a command whose mode is not `active`."),
            );
        }
    }
    let unknown: [(&str, &str); 12] = [
        ("capital", "Active"),
        ("capitals", "ACTIVE"),
        ("space", "active "),
        ("space-before", " active"),
        ("empty", ""),
        ("other", "dance"),
        ("running", "running"),
        ("constant", "MODE_ACTIVE"),
        ("number", "1"),
        ("nul", "active\0"),
        ("prefix", "activ"),
        ("longer", "activeX"),
    ];
    for (name, mode) in unknown {
        let text = |seq| with_mode(seq, Some(Json::string(mode)));
        cases.push(
            case(
                format!("mode/unknown/{name}"),
                &["NCP-SAFE-001"],
                &[Event::Text { text: text(1), now: 1.0, stops: false }, ask(1.0), ask(1.125)],
            )
            .title(format!("A command in the unknown mode ({name}) moves nothing."))
            .flags(&["unknown-mode-moves"])
            .because("An unknown mode reads as `hold`, and only `active` moves."),
        );
    }
    for (name, mode) in [
        ("capitals", "ESTOP"),
        ("capital", "Estop"),
        ("space", "estop "),
        ("other", "stop"),
        ("emergency", "emergency_stop"),
    ] {
        // A hold of a newer seq, from which the next command leads back.
        let trace = [go(1, 1.0), Event::Command(active(2).mode(mode), 1.0625), ask(1.0625), go(3, 1.125), ask(1.125)];
        cases.push(
            case(format!("mode/not-estop/{name}"), &["NCP-RES-023", "NCP-SAFE-001", "NCP-RES-025"], &trace)
                .title(format!("A mode that only looks like ESTOP ({name}) is a HOLD and no latch."))
                .flags(&["latch-by-likeness"])
                .because("Wire strings are compared by their letters, and an unknown mode reads as `hold`, which the next active command ends."),
        );
    }
    cases.push(
        case(
            "mode/absent",
            &["NCP-SAFE-001"],
            &[Event::Text { text: with_mode(1, None), now: 1.0, stops: false }, ask(1.0)],
        )
        .title("A command without a mode moves nothing.")
        .flags(&["absent-mode-moves"])
        .because("An absent `CommandFrame.mode` reads as `hold`."),
    );
    cases
}

/// When a HOLD takes effect, and what it leaves behind.
fn holds() -> Vec<Case> {
    let mut cases = Vec::new();
    for mode in ["hold", "init"] {
        let mut table: Vec<(&str, &[&'static str], &str, Vec<Event>)> = vec![
            (
                "equal-seq",
                &["NCP-RES-023"],
                "of the same seq as the active command takes effect",
                vec![go(5, 1.0), ask(1.0), of(mode, 5, 1.0625), ask(1.0625), ask(1.125)],
            ),
            (
                "newer-seq",
                &["NCP-RES-023"],
                "of a newer seq takes effect",
                vec![go(5, 1.0), of(mode, 6, 1.0625), ask(1.0625)],
            ),
            (
                "seq-zero",
                &["NCP-RES-023"],
                "without a stamp takes effect",
                vec![go(5, 1.0), of(mode, 0, 1.0625), ask(1.0625), ask(1.125)],
            ),
            (
                "equal-then-next",
                &["NCP-RES-023", "NCP-RES-026"],
                "of the same seq ends with the next active command",
                vec![go(5, 1.0), of(mode, 5, 1.0625), ask(1.0625), go(6, 1.125), ask(1.125)],
            ),
            (
                "zero-then-next",
                &["NCP-RES-023", "NCP-RES-026"],
                "without a stamp ends with the next active command",
                vec![go(5, 1.0), of(mode, 0, 1.0625), ask(1.0625), go(6, 1.125), ask(1.125)],
            ),
            (
                "newer-then-next",
                &["NCP-RES-023", "NCP-RES-026"],
                "of a newer seq ends with an active command that is newer still",
                vec![go(5, 1.0), of(mode, 8, 1.0625), ask(1.0625), go(9, 1.125), ask(1.125)],
            ),
            (
                "equal-then-duplicate",
                &["NCP-RES-020", "NCP-RES-023"],
                "of the same seq is not undone by a duplicate of the active command",
                vec![go(5, 1.0), of(mode, 5, 1.0625), go(5, 1.0625), ask(1.0625)],
            ),
            (
                "zero-then-duplicate",
                &["NCP-RES-023", "NCP-RES-020"],
                "without a stamp is not undone by a duplicate of the active command",
                vec![go(5, 1.0), of(mode, 0, 1.0625), go(5, 1.0625), ask(1.0625)],
            ),
            (
                "zero-then-older",
                &["NCP-RES-023", "NCP-RES-020"],
                "without a stamp is not undone by an older active command",
                vec![go(5, 1.0), of(mode, 0, 1.0625), go(3, 1.0625), ask(1.0625), go(1, 1.0625), ask(1.0625)],
            ),
            (
                "newer-then-reordered",
                &["NCP-RES-020", "NCP-RES-023"],
                "of a newer seq is not undone by an active command that it overtook",
                vec![go(5, 1.0), of(mode, 8, 1.0625), go(7, 1.0625), ask(1.0625), go(6, 1.125), ask(1.125)],
            ),
            (
                "older-then-next",
                &["NCP-RES-020", "NCP-RES-026"],
                "of an older seq keeps no newer active command from moving",
                vec![go(5, 1.0), of(mode, 3, 1.0625), ask(1.0625), go(6, 1.125), ask(1.125)],
            ),
            (
                "older-refreshes-nothing",
                &["NCP-RES-024", "NCP-RES-009"],
                "of an older seq refreshes no deadline",
                vec![go(5, 1.0), of(mode, 3, 1.1875), ask(1.3125), ask(1.375)],
            ),
            (
                "older-of-a-minute-refreshes-nothing",
                &["NCP-RES-024", "NCP-RES-009"],
                "of an older seq and a ttl of a minute refreshes no deadline",
                vec![go(5, 1.0), Event::Command(active(4).mode(mode).ttl(60_000.0), 1.0625), ask(1.3125), ask(10.0)],
            ),
            (
                "negative-refreshes-nothing",
                &["NCP-RES-024", "NCP-RES-009"],
                "of a negative seq refreshes no deadline",
                vec![go(5, 1.0), of(mode, -1, 1.25), ask(1.3125)],
            ),
            (
                "newer-refreshes-nothing",
                &["NCP-RES-024", "NCP-RES-025"],
                "of a newer seq refreshes no deadline",
                vec![go(5, 1.0), of(mode, 6, 1.1875), ask(1.1875), ask(1.375), ask(1.4375)],
            ),
            (
                "zero-of-a-negative-stream",
                &["NCP-RES-023"],
                "without a stamp takes effect also after a command of a negative seq",
                vec![go(-5, 1.0), ask(1.0), of(mode, 0, 1.0625), ask(1.0625)],
            ),
            (
                "zero-in-a-replay",
                &["NCP-RES-023"],
                "without a stamp ends a replay",
                vec![
                    Event::Command(active(5).then(Some(62.5), &[51.0, 52.0, 53.0]), 1.0),
                    ask(1.0625),
                    of(mode, 0, 1.0625),
                    ask(1.0625),
                    ask(1.125),
                ],
            ),
            (
                "zero-of-a-long-ttl",
                &["NCP-RES-023"],
                "without a stamp ends a command of a minute",
                vec![Event::Command(active(5).ttl(60_000.0), 1.0), ask(10.0), of(mode, 0, 10.0), ask(10.0), ask(20.0)],
            ),
            (
                "older-moves-nothing-back",
                &["NCP-RES-020", "NCP-RES-009"],
                "of an older seq does not move the stream back",
                vec![go(10, 1.0), of(mode, 3, 1.0625), go(5, 1.0625), ask(1.0625), ask(1.125), ask(1.3125)],
            ),
            (
                "older-moves-no-expired-stream-back",
                &["NCP-RES-020", "NCP-RES-009"],
                "of an older seq does not move the stream of an expired command back",
                vec![
                    go(10, 1.0),
                    ask(1.5),
                    of(mode, 3, 1.5),
                    go(5, 1.5),
                    ask(1.5),
                    go(10, 1.5),
                    ask(1.5),
                    go(11, 1.5),
                    ask(1.5),
                ],
            ),
            (
                "older-after-hold-moves-nothing-back",
                &["NCP-RES-020"],
                "of an older seq does not move the stream of a HOLD back",
                vec![
                    go(5, 1.0),
                    of("hold", 10, 1.0625),
                    of(mode, 6, 1.0625),
                    go(8, 1.125),
                    ask(1.125),
                    go(11, 1.125),
                    ask(1.125),
                ],
            ),
            (
                "long-ttl",
                &["NCP-SAFE-001", "NCP-RES-024"],
                "with a ttl of a minute moves nothing for a minute",
                vec![go(5, 1.0), Event::Command(active(6).mode(mode).ttl(60_000.0), 1.0625), ask(1.0625), ask(10.0)],
            ),
            (
                "no-ttl",
                &["NCP-RES-023"],
                "takes effect, though its ttl is 0",
                vec![
                    go(5, 1.0),
                    Event::Command(active(6).mode(mode).ttl(0.0), 1.0625),
                    ask(1.0625),
                    go(7, 1.125),
                    ask(1.125),
                ],
            ),
            (
                "twice",
                &["NCP-RES-023"],
                "twice is as good as once",
                vec![go(5, 1.0), of(mode, 5, 1.0625), of(mode, 5, 1.0625), ask(1.0625), go(6, 1.125), ask(1.125)],
            ),
            (
                "with-horizon",
                &["NCP-SAFE-001", "NCP-RES-025"],
                "with a horizon replays none of it",
                vec![
                    go(5, 1.0),
                    Event::Command(active(6).mode(mode).then(Some(62.5), &[61.0, 62.0]), 1.0625),
                    ask(1.0625),
                    ask(1.125),
                    ask(1.1875),
                ],
            ),
            (
                "persists",
                &["NCP-RES-010", "NCP-RES-023"],
                "holds for good when nothing else comes",
                vec![go(5, 1.0), of(mode, 5, 1.0625), ask(1.0625), ask(1.125), ask(1.25), ask(10.0), ask(1.0625)],
            ),
            (
                "before-any",
                &["NCP-RES-026", "NCP-SAFE-001"],
                "before any active command holds until one comes",
                vec![of(mode, 1, 1.0), ask(1.0), go(2, 1.125), ask(1.125)],
            ),
        ];
        // What `init` shows is mostly that it does not move: of what a HOLD does, the first things.
        let is_shown = |name: &str, rules: &[&str]| {
            mode == "hold"
                || rules.first() != Some(&"NCP-RES-023")
                || matches!(name, "equal-seq" | "newer-seq" | "seq-zero" | "twice")
        };
        table.retain(|(name, rules, ..)| is_shown(name, rules));
        for (name, rules, words, events) in table {
            cases.push(
                case(format!("hold/{name}/{mode}"), rules, &events)
                    .title(format!("A command in mode `{mode}` {words}."))
                    .flags(&["lost-hold"])
                    .because("A HOLD takes effect at once when its seq is not less than that of the last accepted command, or is 0; it refreshes nothing, and what does not advance is dropped."),
            );
        }
    }
    cases
}

/// A HOLD needs no clock.
fn holds_without_a_clock() -> Vec<Case> {
    let mut cases = Vec::new();
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for (name, seq) in [("newer", 6), ("equal", 5), ("zero", 0)] {
            cases.push(
                case(
                    format!("hold/clock-{}/{name}", name_of(value)),
                    &["NCP-RES-023"],
                    &[go(5, 1.0), ask(1.0), of("hold", seq, value), ask(1.0625), ask(1.125)],
                )
                .title(format!(
                    "A HOLD ({name} seq) takes effect, though the clock reads {} when it comes.",
                    name_of(value)
                ))
                .flags(&["lost-hold", "non-finite-clock"])
                .because("A HOLD takes effect at once; it refreshes nothing and needs no clock."),
            );
        }
    }
    cases
}

/// What advances and what is dropped.
fn seqs() -> Vec<Case> {
    let mut cases = Vec::new();
    for (name, first, second) in [
        ("duplicate", 5, 5),
        ("older", 5, 4),
        ("much-older", 5, 1),
        ("unstamped", 5, 0),
        ("negative", 5, -1),
        ("unstamped-twice", 0, 0),
        ("wrapped", 9_007_199_254_740_991, 1),
    ] {
        let flags: &[&'static str] = if second == 0 { &["L08", "revived-command"] } else { &["revived-command"] };
        let other = |now| Event::Command(super::model::Command { value: 77.0, ..active(second) }, now);
        cases.push(
            case(
                format!("drop/{name}/channels"),
                &["NCP-RES-020"],
                &[go(first, 1.0), other(1.0625), ask(1.0625), ask(1.125)],
            )
            .title(format!("A command of seq {second} after one of {first} does not replace it."))
            .flags(flags)
            .because("The buffer drops a command that does not advance."),
        );
        cases.push(
            case(
                format!("drop/{name}/deadline"),
                &["NCP-RES-009", "NCP-RES-020"],
                &[go(first, 1.0), other(1.1875), ask(1.25), ask(1.3125)],
            )
            .title(format!("A command of seq {second} after one of {first} does not prolong it."))
            .flags(flags)
            .because("A command that does not advance does not refresh the deadline."),
        );
        cases.push(
            case(
                format!("drop/{name}/revival"),
                &["NCP-RES-010", "NCP-RES-020"],
                &[go(first, 1.0), ask(1.5), other(1.5), ask(1.5)],
            )
            .title(format!("A command of seq {second} after one of {first} does not revive a plant that expired."))
            .flags(flags)
            .because("A hold persists until an advancing command."),
        );
    }
    for (name, first, second) in [
        ("next", 5, 6),
        ("gap", 5, 5000),
        ("from-zero", 0, 1),
        ("from-negative", -5, -4),
        ("largest", 1, 9_007_199_254_740_991),
    ] {
        cases.push(
            case(
                format!("replace/{name}"),
                &["NCP-RES-026"],
                &[go(first, 1.0), ask(1.0), go(second, 1.125), ask(1.125), ask(1.375), ask(1.4375)],
            )
            .title(format!("A command of seq {second} after one of {first} replaces it, and its ttl counts."))
            .flags(&["over-strict"])
            .because("A command advances when its seq is greater than that of the last that advanced."),
        );
    }
    let events: Vec<Event> = [3, 1, 2, 5, 4, 5, 6, 2]
        .into_iter()
        .enumerate()
        .flat_map(|(at, seq)| {
            #[expect(clippy::cast_precision_loss, reason = "eight steps")]
            let now = 1.0 + at as f64 / 16.0;
            [go(seq, now), ask(now)]
        })
        .collect();
    cases.push(
        case("trace/shuffled", &["NCP-RES-020"], &events)
            .title("Of commands in a shuffled order the plant follows the newest so far.")
            .flags(&["revived-command"])
            .because("The buffer drops what does not advance."),
    );
    cases
}

fn resets() -> Vec<Case> {
    let reset = || Event::Reset;
    let table: Vec<(&str, &[&'static str], &str, Vec<Event>)> = vec![
        (
            "moving",
            &["NCP-RES-031", "NCP-RES-030"],
            "A reset stops a plant that was moving.",
            vec![go(5, 1.0), ask(1.0), reset(), ask(1.0), ask(1.125)],
        ),
        (
            "estop",
            &["NCP-RES-031", "NCP-RES-030"],
            "A reset clears ESTOP and revives nothing.",
            vec![go(5, 1.0), of("estop", 6, 1.0625), ask(1.0625), reset(), ask(1.0625), ask(1.125)],
        ),
        (
            "estop-then-new",
            &["NCP-RES-030", "NCP-RES-021"],
            "After a reset of ESTOP, a new command moves the plant.",
            vec![go(5, 1.0), of("estop", 6, 1.0625), go(7, 1.0625), ask(1.0625), reset(), go(8, 1.125), ask(1.125)],
        ),
        (
            "estop-then-lower",
            &["NCP-RES-030"],
            "After a reset, a seq that begins again moves the plant.",
            vec![go(500, 1.0), of("estop", 501, 1.0625), reset(), go(1, 1.125), ask(1.125), go(2, 1.1875), ask(1.1875)],
        ),
        (
            "command-while-latched",
            &["NCP-RES-031", "NCP-RES-025"],
            "A command that came while ESTOP was latched does not move after the reset.",
            vec![of("estop", 1, 1.0), go(2, 1.0), ask(1.0), reset(), ask(1.0), ask(1.125)],
        ),
        (
            "hold",
            &["NCP-RES-030"],
            "A reset forgets the seq of a HOLD.",
            vec![go(5, 1.0), of("hold", 50, 1.0625), reset(), go(6, 1.125), ask(1.125)],
        ),
        (
            "same-seq",
            &["NCP-RES-030"],
            "After a reset, the same seq advances.",
            vec![go(5, 1.0), reset(), go(5, 1.125), ask(1.125)],
        ),
        (
            "much-lower",
            &["NCP-RES-030"],
            "After a reset, a much lower seq advances.",
            vec![go(9_007_199_254_740_991, 1.0), reset(), go(3, 1.125), ask(1.125)],
        ),
        (
            "unstamped",
            &["NCP-RES-030"],
            "After a reset, an unstamped command advances.",
            vec![go(5, 1.0), reset(), go(0, 1.125), ask(1.125)],
        ),
        (
            "negative",
            &["NCP-RES-030"],
            "After a reset, a negative seq advances.",
            vec![go(5, 1.0), reset(), go(-3, 1.125), ask(1.125)],
        ),
        (
            "expired-then-lower",
            &["NCP-RES-030"],
            "After a reset of a plant that expired, a lower seq advances.",
            vec![go(5, 1.0), ask(1.5), reset(), go(2, 1.5), ask(1.5)],
        ),
        (
            "restart-held",
            &["NCP-RES-032"],
            "A sender that begins again is held until the reset.",
            vec![
                go(100, 1.0),
                ask(1.0),
                go(1, 1.5),
                ask(1.5),
                go(2, 1.5625),
                ask(1.5625),
                go(3, 1.625),
                ask(1.625),
                reset(),
                ask(1.625),
                go(4, 1.6875),
                ask(1.6875),
            ],
        ),
        (
            "restart-unstamped",
            &["NCP-RES-032"],
            "A sender that stops stamping is held until the reset.",
            vec![go(100, 1.0), go(0, 1.5), ask(1.5), go(0, 1.5625), ask(1.5625), reset(), go(0, 1.625), ask(1.625)],
        ),
        ("twice", &["NCP-RES-031"], "Two resets revive nothing.", vec![go(5, 1.0), reset(), reset(), ask(1.0)]),
        (
            "first",
            &["NCP-RES-031"],
            "A reset before anything changes nothing.",
            vec![reset(), ask(1.0), go(1, 1.0), ask(1.0)],
        ),
        (
            "replay-after",
            &["NCP-RES-031", "NCP-RES-030"],
            "A reset forgets the horizon too.",
            vec![
                Event::Command(active(5).ttl(1000.0).then(Some(125.0), &[51.0, 52.0, 53.0]), 1.0),
                ask(1.125),
                reset(),
                ask(1.25),
                ask(1.375),
            ],
        ),
    ];
    table
        .into_iter()
        .map(|(name, rules, title, events)| {
            case(format!("reset/{name}"), rules, &events)
                .title(title)
                .flags(&["reviving-reset"])
                .because("The buffer's reset clears the latch, the held command and the last seq, and nothing moves until a new command comes.")
        })
        .collect()
}

fn deadlines() -> Vec<Case> {
    let mut cases = Vec::new();
    for (ttl, ages) in [
        (0.0, [0.0, 0.125]),
        (-1.0, [0.0, 0.125]),
        (-1e308, [0.0, 60.0]),
        (5e-324, [0.0, 0.001]),
        (62.5, [0.0625, 0.125]),
        (250.0, [0.25, 0.251]),
        (60_000.0, [60.0, 60.5]),
        (60_001.0, [60.0, 60.5]),
        (3.6e6, [60.0, 60.5]),
        (1e308, [60.0, 61.0]),
    ] {
        for age in ages {
            let rule = if ttl <= 0.0 {
                "NCP-RES-005"
            } else if ttl > 60_000.0 {
                "NCP-RES-004"
            } else if age * 1000.0 <= ttl {
                "NCP-RES-003"
            } else {
                "NCP-RES-002"
            };
            cases.push(
                case(
                    format!("deadline/ttl-{}/after-{age}-s", name_of(ttl)),
                    &[rule, "NCP-RES-025"],
                    &[Event::Command(active(1).ttl(ttl), 4.0), ask(4.0 + age)],
                )
                .title(format!(
                    "The buffer keeps a command of {ttl} ms for the enforced ttl, and is asked after {age} s."
                ))
                .flags(if ttl > 60_000.0 { &["L02"] } else { &["off-by-a-boundary"] })
                .because("`active` is none whenever the deadline rules of 8.1 hold the plant."),
            );
        }
    }
    // A newer command without a ttl takes the place of the one before it.
    for ttl in [0.0, -0.0, -1.0, -250.0, -1e308] {
        cases.push(
            case(
                format!("replace/ttl-{}", name_of(ttl)),
                &["NCP-RES-005", "NCP-RES-025"],
                &[
                    go(1, 1.0),
                    ask(1.0),
                    Event::Command(active(2).ttl(ttl), 1.0625),
                    ask(1.0625),
                    ask(1.125),
                    go(3, 1.1875),
                    ask(1.1875),
                ],
            )
            .title(format!("A newer command of {ttl} ms ends the one before it, until the next."))
            .flags(&["ttl-without-time"])
            .because("The plant keeps the newest command, and holds on one whose `ttl_ms` is not positive."),
        );
        cases.push(
            case(
                format!("replace/ttl-{}/in-a-replay", name_of(ttl)),
                &["NCP-RES-005", "NCP-RES-025"],
                &[
                    Event::Command(active(1).ttl(1000.0).then(Some(125.0), &[11.0, 12.0]), 1.0),
                    ask(1.125),
                    Event::Command(active(2).ttl(ttl), 1.125),
                    ask(1.125),
                    ask(1.25),
                ],
            )
            .title(format!("A newer command of {ttl} ms ends a replay."))
            .flags(&["ttl-without-time"])
            .because("The plant keeps the newest command, and holds on one whose `ttl_ms` is not positive."),
        );
    }
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let name = name_of(value);
        cases.push(
            case(format!("clock/{name}/asked-once"), &["NCP-RES-007"], &[go(1, 1.0), ask(value)])
                .title(format!("The buffer holds when the clock reads {name}."))
                .flags(&["non-finite-clock"])
                .because("A plant holds when now is not finite."),
        );
        cases.push(
            case(
                format!("clock/{name}/asked"),
                &["NCP-RES-010", "NCP-RES-007"],
                &[go(1, 1.0), ask(value), ask(1.125), go(2, 1.125), ask(1.125)],
            )
            .title(format!("The buffer holds when the clock reads {name}, and until the next command."))
            .flags(&["non-finite-clock"])
            .because("A plant holds when now is not finite, and the hold persists."),
        );
        cases.push(
            case(
                format!("clock/{name}/received"),
                &["NCP-RES-007"],
                &[go(1, value), ask(1.0), go(2, 1.125), ask(1.125)],
            )
            .title(format!("The buffer holds on a command that came when the clock read {name}."))
            .flags(&["non-finite-clock"])
            .because("A plant holds when the time of receipt is not finite."),
        );
    }
    for (name, events) in [
        ("before-receipt", vec![go(1, 100.0), ask(99.0), ask(100.0), go(2, 100.0), ask(100.0)]),
        ("far-back", vec![go(1, 1e6), ask(0.0), ask(1e6)]),
        ("expired-then-back", vec![go(1, 1.0), ask(2.0), ask(1.125), ask(1.0)]),
        ("back-and-next", vec![go(1, 100.0), ask(50.0), go(2, 50.0), ask(50.0), ask(50.25), ask(50.5)]),
    ] {
        cases.push(
            case(format!("clock/{name}"), &["NCP-RES-008", "NCP-RES-010"], &events)
                .title(format!("The buffer holds when the clock steps backward ({}).", name.replace('-', " ")))
                .flags(&["L14"])
                .because("A plant holds when now is less than the time of receipt, and the hold persists until an advancing command."),
        );
    }
    // The sender's own time says nothing.
    for t in [0.0, -1e9, 1e9, 1e308, 5e-324] {
        let mut command = active(1);
        command.t = t;
        cases.push(
            case(
                format!("senders-clock/{}", name_of(t)),
                &["NCP-RES-001"],
                &[Event::Command(command, 1.0), ask(1.25), ask(1.3125)],
            )
            .title(format!("A command's own time of {t} s says nothing about its age."))
            .flags(&["L25"])
            .because("A plant enforces the ttl on its own clock, from the moment at which it received the command."),
        );
    }
    cases
}

/// Frames that are rejected move nothing; whether the command before goes on is left open.
fn malformed() -> Vec<Case> {
    let base = active(2).json();
    let texts: Vec<(&str, Json)> = vec![
        ("empty", Json::string("")),
        ("no-json", Json::string("go")),
        ("array", Json::string("[]")),
        ("truncated", Json::string(base.text().trim_end_matches('}'))),
        ("trailing", Json::string(base.text() + "x")),
        ("two-objects", Json::string(base.text() + &base.text())),
        ("seq-text", Json::string(base.clone().with("seq", "2".into()).text())),
        ("seq-fraction", Json::string(base.clone().with("seq", Json::literal("2.0")).text())),
        ("seq-huge", Json::string(base.clone().with("seq", Json::literal("9007199254740992")).text())),
        ("seq-null", Json::string(base.clone().with("seq", Json::Null).text())),
        ("ttl-text", Json::string(base.clone().with("ttl_ms", "250".into()).text())),
        ("ttl-overflow", Json::string(base.clone().with("ttl_ms", Json::literal("1e309")).text())),
        ("ttl-infinity", Json::string(base.clone().with("ttl_ms", Json::literal("Infinity")).text())),
        ("channels-array", Json::string(base.clone().with("channels", Json::Array(Vec::new())).text())),
        (
            "data-text",
            Json::string(base.clone().edit(&["channels", "velocity_setpoint", "data"], |_| "fast".into()).text()),
        ),
        (
            "data-overflow",
            Json::string(
                base.clone()
                    .edit(&["channels", "velocity_setpoint", "data"], |_| Json::Array(vec![Json::literal("1e400")]))
                    .text(),
            ),
        ),
        (
            "data-nan",
            Json::string(
                base.clone()
                    .edit(&["channels", "velocity_setpoint", "data"], |_| Json::Array(vec![Json::literal("NaN")]))
                    .text(),
            ),
        ),
        (
            "data-null",
            Json::string(
                base.clone().edit(&["channels", "velocity_setpoint", "data"], |_| Json::Array(vec![Json::Null])).text(),
            ),
        ),
        ("mode-number", Json::string(base.clone().with("mode", Json::literal("1")).text())),
        ("mode-null", Json::string(base.clone().with("mode", Json::Null).text())),
        ("repeated-mode", Json::string(base.clone().and("mode", "active".into()).text())),
        ("repeated-ttl", Json::string(base.clone().and("ttl_ms", Json::literal("60000.0")).text())),
        ("no-kind", Json::string(base.clone().without("kind").text())),
        ("other-kind", Json::string(base.clone().with("kind", "sensor_frame".into()).text())),
        ("unknown-kind", Json::string(base.clone().with("kind", "command".into()).text())),
    ];
    let mut cases = Vec::new();
    let moving = |x: f64| object! { "channels" => object! { "velocity_setpoint" => object! { "data" => nums(&[x, 0.0, 0.0]) } } };
    let still = || object! { "channels" => Json::Null };
    for (name, text) in texts {
        let rule = if name == "other-kind" || name == "unknown-kind" || name == "no-kind" {
            "NCP-RES-025"
        } else {
            "NCP-RES-006"
        };
        let (args, _) =
            buffer(&[Event::Text { text: text.clone(), now: 1.0, stops: false }, ask(1.0), go(3, 1.125), ask(1.125)]);
        cases.push(
            Case::new(format!("malformed/{name}/first"), &[rule], &[Role::Body])
                .call("buffer.run", args)
                .shows(steps(vec![no_result(), still(), no_result(), moving(3.0)]))
                .title(format!("A frame that is rejected ({}) moves nothing, and the next one does.", name.replace('-', " ")))
                .flags(&["malformed-moves"])
                .because("To reject a frame is to refuse it as a whole without acting on any part of it, so that there is no command yet."),
        );
        let (args, _) = buffer(&[
            go(1, 1.0),
            Event::Text { text, now: 1.125, stops: false },
            ask(1.125),
            ask(1.3125),
            go(3, 1.375),
            ask(1.375),
        ]);
        cases.push(
            Case::new(format!("malformed/{name}/second"), &["NCP-RES-009", "NCP-RES-002"], &[Role::Body])
                .call("buffer.run", args)
                .shows(steps(vec![no_result(), no_result(), any(vec![moving(1.0), still()]), still(), no_result(), moving(3.0)]))
                .title(format!("A frame that is rejected ({}) prolongs nothing and latches nothing.", name.replace('-', " ")))
                .flags(&["malformed-moves"])
                .because("A rejected frame is not acted upon in any part: the deadline of the command before it stays, and the next command moves."),
        );
    }
    cases
}

/// What `active` returns.
fn channels() -> Vec<Case> {
    let base = active(1).json();
    let value = |data: &[f64], unit: Option<&str>| object! { "data" => nums(data), "unit" => unit };
    let table: [(&str, &str, Json); 6] = [
        (
            "several",
            "several channels",
            object! { "velocity_setpoint" => value(&[1.0, 2.0, 3.0], Some("m/s")), "gripper" => value(&[0.5], None), "light" => value(&[900.0], Some("lm")) },
        ),
        ("wide", "a wide channel", object! { "motors" => value(&[0.125; 16], None) }),
        ("empty-data", "a channel without components", object! { "gripper" => value(&[], None) }),
        ("none", "no channels", Json::object()),
        ("odd-numbers", "odd numbers", object! { "velocity_setpoint" => value(&[-0.0, 5e-324, 1e308], Some("m/s")) }),
        (
            "odd-names",
            "odd names",
            object! { "" => value(&[1.0], None), "\u{e9}" => value(&[2.0], None), "estop" => value(&[3.0], None), "mode" => value(&[4.0], None) },
        ),
    ];
    table
        .into_iter()
        .map(|(name, words, channels)| {
            // In a frame the negative zero is a number like any other.
            let text = base.clone().with("channels", channels.clone()).text().replace("\"-0\"", "-0.0");
            let (args, _) = buffer(&[Event::Text { text: Json::string(text), now: 1.0, stops: false }, ask(1.125)]);
            Case::new(format!("channels/{name}"), &["NCP-RES-026"], &[Role::Body])
                .call("buffer.run", args)
                .shows(steps(vec![no_result(), object! { "channels" => crate::trace::exactly(channels) }]))
                .title(format!("A command with {words} is followed in all of them."))
                .because("Without a horizon, `active` is the channels of tick 0.")
        })
        .collect()
}
