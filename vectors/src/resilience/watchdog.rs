//! The deadline of one command.

use super::model::{Command, Event, active, watchdog};
use crate::case::{Case, File, Role};
use crate::trace::name_of;

pub(super) fn file() -> File {
    let mut cases = boundaries();
    cases.extend(ttls());
    cases.extend(clocks());
    cases.extend(seqs());
    cases.extend(traces());
    let about =
        "The watchdog: ttls up to exactly their end, ttls and clocks that are none, and seqs that do not advance.";
    File::new("resilience", "watchdog", about, cases)
}

fn case(path: String, rules: &[&'static str], events: &[Event]) -> Case {
    let (args, pattern) = watchdog(events);
    Case::new(path, rules, &[Role::Body]).call("watchdog.run", args).shows(pattern)
}

fn command(seq: i64, ttl: f64, now: f64) -> Event {
    Event::Command(active(seq).ttl(ttl), now)
}

const DEADLINE: &str =
    "The plant holds once now \u{2212} received is more than min(ttl, 60 s), and not when it is exactly that.";

fn boundaries() -> Vec<Case> {
    let mut cases = Vec::new();
    for (ttl, exact) in [
        (250.0, 0.25),
        (500.0, 0.5),
        (125.0, 0.125),
        (1000.0, 1.0),
        (2000.0, 2.0),
        (62.5, 0.0625),
        (59_000.0, 59.0),
        (60_000.0, 60.0),
    ] {
        for start in [0.0, 2.0, 1024.0] {
            for (name, age, rule, is) in [
                ("at-once", 0.0, "NCP-RES-003", "moves"),
                ("half", exact / 2.0, "NCP-RES-003", "moves"),
                ("exact", exact, "NCP-RES-003", "moves"),
                ("just-past", exact * (1.0 + 1.0 / 1024.0), "NCP-RES-002", "holds"),
                ("double", exact * 2.0, "NCP-RES-002", "holds"),
            ] {
                if start > 0.0 && !matches!(name, "exact" | "just-past") {
                    continue;
                }
                cases.push(
                    case(
                        format!("ttl-{ttl}/from-{start}/{name}"),
                        &[rule, "NCP-RES-001"],
                        &[command(1, ttl, start), Event::Ask(start + age)],
                    )
                    .title(format!(
                        "A plant {is} {} ms after a command of {ttl} ms that came at {start} s.",
                        age * 1000.0
                    ))
                    .flags(&["off-by-a-boundary"])
                    .because(DEADLINE),
                );
            }
        }
    }
    // Beyond a minute.
    for ttl in [60_000.5, 61_000.0, 120_000.0, 3_600_000.0, 1e9, 1e308, f64::MAX] {
        for (age, is) in [(60.0, "moves"), (60.0625, "holds"), (61.0, "holds"), (3600.0, "holds")] {
            cases.push(
                case(
                    format!("capped/{}/after-{age}-s", name_of(ttl)),
                    &["NCP-RES-004"],
                    &[command(1, ttl, 16.0), Event::Ask(16.0 + age)],
                )
                .title(format!("A plant {is} {age} s after a command of {ttl} ms."))
                .flags(&["L02"])
                .because("A plant enforces a `ttl_ms` of more than 60,000 as 60,000."),
            );
        }
    }
    cases
}

fn ttls() -> Vec<Case> {
    let mut cases = Vec::new();
    for ttl in [0.0, -0.0, -1.0, -5e-324, -250.0, -1e308, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let flags: &[&'static str] = if ttl.is_finite() { &["ttl-without-time"] } else { &["L12"] };
        cases.push(
            case(
                format!("no-ttl/{}/at-once", name_of(ttl)),
                &["NCP-RES-005"],
                &[command(1, ttl, 1.0), Event::Ask(1.0)],
            )
            .title(format!("A plant holds on a ttl of {} at the moment of its receipt.", name_of(ttl)))
            .flags(flags)
            .because("A plant holds on a command whose `ttl_ms` is not finite or not positive."),
        );
        // A watchdog may refuse what is no number, and then it has not seen the command.
        if !ttl.is_finite() {
            continue;
        }
        cases.push(
            case(
                format!("no-ttl/{}/trace", name_of(ttl)),
                &["NCP-RES-005"],
                &[
                    command(1, 250.0, 1.0),
                    Event::Ask(1.125),
                    command(2, ttl, 1.125),
                    Event::Ask(1.125),
                    Event::Ask(1.1875),
                    command(3, 250.0, 1.1875),
                    Event::Ask(1.25),
                ],
            )
            .title(format!("A newer command with a ttl of {} ends the one before, until the next.", name_of(ttl)))
            .flags(flags)
            .because("The plant acts on the last command that advanced, and that one has no time."),
        );
    }
    cases.push(
        case(
            "no-ttl/subnormal".to_owned(),
            &["NCP-RES-003", "NCP-RES-002"],
            &[command(1, 5e-324, 1.0), Event::Ask(1.0), Event::Ask(1.001)],
        )
        .title("The smallest ttl lasts for the moment of its receipt.")
        .because(DEADLINE),
    );
    cases
}

fn clocks() -> Vec<Case> {
    let mut cases = vec![
        case("before-any/once".to_owned(), &["NCP-RES-006"], &[Event::Ask(0.0)])
            .title("A plant holds before the first command.")
            .because("A plant holds before the first command."),
        case(
            "before-any/many".to_owned(),
            &["NCP-RES-006"],
            &[Event::Ask(0.0), Event::Ask(5.0), Event::Ask(1e9), Event::Reset, Event::Ask(1e9)],
        )
        .title("A plant holds before the first command, however long it waits.")
        .because("A plant holds before the first command."),
    ];
    let strange = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    for now in strange {
        let name = name_of(now);
        cases.push(
            case(format!("now/{name}"), &["NCP-RES-007"], &[command(1, 250.0, 1.0), Event::Ask(now)])
                .title(format!("A plant holds when its clock reads {name}."))
                .flags(&["non-finite-clock"])
                .because("A plant holds when now is not finite."),
        );
        cases.push(
            case(
                format!("now/{name}/persists"),
                &["NCP-RES-010", "NCP-RES-007"],
                &[
                    command(1, 250.0, 1.0),
                    Event::Ask(1.0625),
                    Event::Ask(now),
                    Event::Ask(1.125),
                    command(2, 250.0, 1.125),
                    Event::Ask(1.25),
                ],
            )
            .title(format!("The hold for a clock that reads {name} persists until the next command."))
            .flags(&["non-finite-clock", "reviving-hold"])
            .because("A hold persists until an advancing command."),
        );
        cases.push(
            case(
                format!("received/{name}"),
                &["NCP-RES-007"],
                &[command(1, 250.0, now), Event::Ask(1.0), command(2, 250.0, 1.0), Event::Ask(1.125)],
            )
            .title(format!("A plant holds on a command that came when its clock read {name}."))
            .flags(&["non-finite-clock"])
            .because("A plant holds when the time of receipt is not finite."),
        );
        cases.push(
            case(format!("both/{name}"), &["NCP-RES-007"], &[command(1, 250.0, now), Event::Ask(now)])
                .title(format!("A plant holds when both of its clock readings are {name}."))
                .flags(&["non-finite-clock"])
                .because("A plant holds when now or the time of receipt is not finite."),
        );
    }
    for back in [5e-324, 0.001, 0.125, 1.0, 60.0, 1e6, 1e308] {
        let (received, now) = if back < 1e-6 {
            (back, 0.0)
        } else if back > 1e300 {
            (back, 1.0)
        } else {
            (64.0 + back, 64.0)
        };
        cases.push(
            case(
                format!("backward/{}", name_of(back)),
                &["NCP-RES-008"],
                &[command(1, 250.0, received), Event::Ask(now)],
            )
            .title(format!("A plant holds when its clock reads {back} s less than at the receipt."))
            .flags(&["L14"])
            .because("A plant holds when now is less than the time of receipt."),
        );
        cases.push(
            case(format!("backward/{}/persists", name_of(back)), &["NCP-RES-010", "NCP-RES-008"], &[command(1, 250.0, received), Event::Ask(now), Event::Ask(received)])
                .title(format!("The hold for a clock {back} s back persists when the clock is right again."))
                .flags(&["L14", "reviving-hold"])
                .because("A hold persists until an advancing command, also when the clock then reads a time at which the command was not yet expired."),
        );
    }
    cases.push(
        case("huge-clock".to_owned(), &["NCP-RES-003"], &[command(1, 250.0, 1e308), Event::Ask(1e308)])
            .title("A clock that reads 1e308 s twice is a clock.")
            .because("Both readings are finite, and their difference is 0."),
    );
    cases.push(
        case("overflowing-age".to_owned(), &["NCP-RES-002"], &[command(1, 250.0, 0.0), Event::Ask(1e308)])
            .title("An age that overflows in milliseconds is past every ttl.")
            .because(DEADLINE),
    );
    cases
}

fn seqs() -> Vec<Case> {
    let mut cases = Vec::new();
    for (first, second, name) in [
        (5, 5, "same"),
        (5, 4, "one-less"),
        (5, 1, "less"),
        (5, 0, "zero"),
        (5, -5, "negative"),
        (0, 0, "zero-twice"),
        (0, -1, "below-zero"),
        (-3, -3, "negative-twice"),
        (9_007_199_254_740_991, 1, "after-the-largest"),
        (9_007_199_254_740_991, -9_007_199_254_740_991, "from-end-to-end"),
    ] {
        let flags: &[&'static str] = if second == 0 { &["L08", "refreshed-deadline"] } else { &["refreshed-deadline"] };
        for (when, events) in [
            (
                "before-the-end",
                vec![command(first, 250.0, 1.0), command(second, 250.0, 1.125), Event::Ask(1.25), Event::Ask(1.3125)],
            ),
            (
                "after-the-end",
                vec![command(first, 250.0, 1.0), Event::Ask(1.5), command(second, 250.0, 1.5), Event::Ask(1.5)],
            ),
            ("unasked", vec![command(first, 250.0, 1.0), command(second, 250.0, 1.5), Event::Ask(1.5)]),
            (
                "longer",
                vec![command(first, 250.0, 1.0), command(second, 60_000.0, 1.0), Event::Ask(1.25), Event::Ask(1.5)],
            ),
        ] {
            cases.push(
                case(format!("seq/{name}/{when}"), &["NCP-RES-009"], &events)
                    .title(format!(
                        "A command of seq {second} after one of {first} ({}) refreshes nothing.",
                        when.replace('-', " ")
                    ))
                    .flags(flags)
                    .because("A command that does not advance does not refresh the deadline."),
            );
        }
    }
    for (first, second, name) in [
        (5, 6, "next"),
        (5, 500, "gap"),
        (0, 1, "from-zero"),
        (-5, -4, "negative"),
        (-1, 0, "to-zero"),
        (1, 9_007_199_254_740_991, "to-the-largest"),
        (-9_007_199_254_740_991, 9_007_199_254_740_991, "from-end-to-end"),
    ] {
        cases.push(
            case(format!("advance/{name}"), &["NCP-RES-003"], &[command(first, 250.0, 1.0), command(second, 250.0, 1.25), Event::Ask(1.5), Event::Ask(1.5625)])
                .title(format!("A command of seq {second} after one of {first} refreshes the deadline."))
                .flags(&["over-strict"])
                .because("A command advances when its seq is greater than that of the last that advanced; then its whole ttl counts."),
        );
    }
    cases
}

fn traces() -> Vec<Case> {
    let ask = Event::Ask;
    let reset = || Event::Reset;
    let slow = |seq: i64, now: f64| command(seq, 250.0, now);
    let table: Vec<(&str, &[&'static str], &str, Vec<Event>)> = vec![
        (
            "expired-then-back",
            &["NCP-RES-010"],
            "A plant that expired holds when its clock steps back before the deadline.",
            vec![slow(1, 1.0), ask(1.5), ask(1.125), ask(1.0), ask(1.25)],
        ),
        (
            "expired-then-duplicate",
            &["NCP-RES-009", "NCP-RES-010"],
            "A duplicate revives no plant that expired.",
            vec![slow(1, 1.0), ask(1.5), slow(1, 1.5), ask(1.5), slow(1, 1.75), ask(1.75)],
        ),
        (
            "expired-then-next",
            &["NCP-RES-010"],
            "The next command revives a plant that expired.",
            vec![slow(1, 1.0), ask(1.5), slow(2, 1.5), ask(1.5), ask(1.75), ask(1.8125)],
        ),
        (
            "reset",
            &["NCP-RES-011"],
            "A reset holds a plant that was moving.",
            vec![slow(1, 1.0), ask(1.125), reset(), ask(1.125), ask(1.0), ask(1.25)],
        ),
        (
            "reset-then-same",
            &["NCP-RES-012"],
            "After a reset, a command of the same seq advances.",
            vec![slow(5, 1.0), ask(1.125), reset(), slow(5, 1.125), ask(1.125), ask(1.375), ask(1.4375)],
        ),
        (
            "reset-then-lower",
            &["NCP-RES-012"],
            "After a reset, a command of a lower seq advances.",
            vec![slow(5, 1.0), reset(), slow(1, 1.125), ask(1.25), slow(2, 1.375), ask(1.625)],
        ),
        (
            "reset-then-negative",
            &["NCP-RES-012"],
            "After a reset, even a negative seq advances.",
            vec![slow(5, 1.0), reset(), slow(-7, 1.125), ask(1.25)],
        ),
        (
            "reset-twice",
            &["NCP-RES-011"],
            "Two resets leave the plant holding.",
            vec![slow(5, 1.0), reset(), reset(), ask(1.0)],
        ),
        (
            "restart-without-reset",
            &["NCP-RES-009"],
            "A sender whose seq begins again refreshes nothing.",
            vec![
                slow(100, 1.0),
                ask(1.0),
                slow(1, 1.25),
                slow(2, 1.375),
                ask(1.375),
                slow(3, 1.5),
                ask(1.5),
                slow(100, 1.5),
                ask(1.5),
                slow(101, 1.5),
                ask(1.625),
            ],
        ),
        (
            "burst-of-duplicates",
            &["NCP-RES-009"],
            "A hundred duplicates are worth nothing.",
            std::iter::once(slow(1, 1.0))
                .chain((1..=100_u32).map(|at| slow(1, 1.0 + f64::from(at) / 128.0)))
                .chain([ask(1.78125)])
                .collect(),
        ),
        (
            "ten-commands",
            &["NCP-RES-003"],
            "A stream of commands keeps the plant moving.",
            (0..10_u32)
                .flat_map(|at| {
                    let now = 1.0 + f64::from(at) / 4.0;
                    [slow(i64::from(at) + 1, now), ask(now), ask(now + 0.25)]
                })
                .collect(),
        ),
        (
            "reordered",
            &["NCP-RES-009"],
            "Of a reordered pair only the newer counts.",
            vec![slow(1, 1.0), slow(3, 1.125), slow(2, 1.25), ask(1.375), ask(1.4375)],
        ),
        (
            "shorter-ttl",
            &["NCP-RES-002"],
            "A newer command with a shorter ttl ends sooner.",
            vec![command(1, 1000.0, 1.0), command(2, 125.0, 1.0625), ask(1.1875), ask(1.25)],
        ),
        (
            "longer-ttl",
            &["NCP-RES-003"],
            "A newer command with a longer ttl lasts longer.",
            vec![command(1, 125.0, 1.0), command(2, 1000.0, 1.0625), ask(1.25), ask(2.0625), ask(2.125)],
        ),
        (
            "clock-back-then-command",
            &["NCP-RES-008", "NCP-RES-010"],
            "A command that comes after the clock stepped back counts from there.",
            vec![slow(1, 100.0), ask(50.0), slow(2, 50.0), ask(50.0), ask(50.25), ask(50.5)],
        ),
        (
            "capped-then-renewed",
            &["NCP-RES-004"],
            "A command of an hour is renewed by the next, and else ends after a minute.",
            vec![command(1, 3.6e6, 0.0), ask(60.0), command(2, 3.6e6, 60.0), ask(120.0), ask(120.5)],
        ),
    ];
    table
        .into_iter()
        .map(|(name, rules, title, events)| {
            let flags: &[&'static str] = match rules.first() {
                Some(&"NCP-RES-010") => &["reviving-hold"],
                Some(&"NCP-RES-009") => &["refreshed-deadline"],
                Some(&"NCP-RES-004") => &["L02"],
                _ => &[],
            };
            case(format!("trace/{name}"), rules, &events).title(title).flags(flags).because(
                "The liveness rule: the plant may move only by an advancing command received at r \u{2264} now with now \u{2212} r \u{2264} min(ttl, 60 s), and a hold persists until the next.",
            )
        })
        .collect()
}

/// Used by the enumerations: a command that is told from others by its seq.
pub(super) fn next(seq: i64) -> Command {
    active(seq)
}
