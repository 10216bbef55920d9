//! The deadline of one command.

use super::model::{Event, events, watchdog};
use crate::case::{Case, File, Role};
use crate::command::active;
use crate::scenario::{Row, ScenarioError, Scenarios, source};
use crate::trace::name_of;

pub(super) fn file() -> Result<File, ScenarioError> {
    let mut text = Scenarios::read(source!("resilience/watchdog"))?;
    let mut cases = boundaries();
    cases.extend(hairs());
    cases.extend(far());
    cases.extend(ttls());
    for group in ["no-ttl", "zero", "before-any", "before-at", "clock"] {
        cases.extend(text.cases(group, row_case)?);
    }
    cases.extend(steps_back());
    cases.extend([rising_below(), rising_for_long(), recovers(), goes_back(), without_a_ttl()]);
    cases.extend(text.rest(row_case)?);
    let about =
        "The watchdog: ttls up to exactly their end, ttls and clocks that are none, and seqs that do not advance.";
    Ok(File::new("resilience", "watchdog", about, cases))
}

fn row_case(row: &Row) -> Result<Case, ScenarioError> {
    let (args, pattern, decided) = watchdog(&events(row)?);
    Ok(row.case(&[Role::Body]).call("watchdog.run", args).shows(pattern).decided_by(&decided))
}

fn case(path: String, rules: &[&'static str], events: &[Event]) -> Case {
    let (args, pattern, decided) = watchdog(events);
    Case::new(path, rules, &[Role::Body]).call("watchdog.run", args).shows(pattern).decided_by(&decided)
}

fn command(seq: i64, ttl: f64, now: f64) -> Event {
    Event::Command(active(seq).ttl(ttl), now)
}

/// Commands that advance, thousands of them, and those that do not behind them.
fn rising_for_long() -> Case {
    let mut events: Vec<Event> = (1..=10_000).map(|seq| command(seq, 250.0, 1.0)).collect();
    events.extend([Event::Ask(1.125), command(9_999, 250.0, 1.25), Event::Ask(1.25), Event::Ask(1.257_812_5)]);
    events.extend([command(10_000, 250.0, 1.5), Event::Ask(1.5), command(10_001, 250.0, 1.5), Event::Ask(1.75)]);
    case("sequence/rising-for-long".to_owned(), &["NCP-RES-009", "NCP-RES-003"], &events)
        .title("Behind 10,000 commands that advanced, one that does not advance refreshes nothing, and the next does.")
        .flags(&["revived-command"])
        .because("A plant goes by the last command that it accepted, however many came before.")
}

/// What a plant does behind hundreds of holds that ended.
fn recovers() -> Case {
    const MANY: u16 = 300;
    let mut events: Vec<Event> = (1..=MANY)
        .flat_map(|nth| [command(i64::from(nth), 250.0, f64::from(nth)), Event::Ask(f64::from(nth) + 0.5)])
        .collect();
    let now = f64::from(MANY) + 1.0;
    events.push(command(i64::from(MANY) + 1, 250.0, now));
    events.extend([0.0, 0.25, 0.257_812_5].map(|age| Event::Ask(now + age)));
    case("sequence/recovers-for-long".to_owned(), &["NCP-RES-003", "NCP-RES-010"], &events)
        .title(format!("Behind {MANY} holds, each ended by a command, the next command moves the plant for its ttl."))
        .flags(&["over-strict"])
        .because("The next command that advances ends a hold, however many there were.")
}

/// A clock that goes back and on again, over and over.
fn goes_back() -> Case {
    const MANY: i64 = 130;
    let mut events: Vec<Event> =
        (1..=MANY).flat_map(|nth| [command(nth, 250.0, 100.0), Event::Ask(50.0), Event::Ask(100.0)]).collect();
    events.extend([command(MANY + 1, 250.0, 200.0), Event::Ask(200.25), Event::Ask(200.257_812_5)]);
    case("sequence/goes-back-for-long".to_owned(), &["NCP-RES-008", "NCP-RES-003"], &events)
        .title(format!("A clock that went back {MANY} times holds the plant each time, and the next command moves it."))
        .flags(&["over-strict"])
        .because("A time before the receipt holds until the next command that advances.")
}

/// Commands whose ttl is none, hundreds of them.
fn without_a_ttl() -> Case {
    let mut events: Vec<Event> = (1..=300).map(|seq| command(seq, 0.0, 1.0)).collect();
    events.extend([Event::Ask(1.0), command(301, 250.0, 1.0), Event::Ask(1.25), Event::Ask(1.257_812_5)]);
    case("sequence/no-ttl-for-long".to_owned(), &["NCP-RES-003"], &events)
        .title("Behind 300 commands with a ttl of 0, one with a ttl of 250 ms moves the plant for as long.")
        .flags(&["over-strict"])
        .because("Each command that advances has its own ttl.")
}

/// Commands that advance among themselves and do not advance what the plant follows.
fn rising_below() -> Case {
    let mut events = vec![command(5_000, 250.0, 1.0)];
    events.extend((1..=1_200).map(|seq| command(seq, 250.0, 2.0)));
    events.extend([Event::Ask(2.0), command(5_001, 250.0, 2.0), Event::Ask(2.0)]);
    case("sequence/rising-below".to_owned(), &["NCP-RES-009"], &events)
        .title("Commands that rise from 1 to 1,200 behind seq 5,000 move nothing without a reset.")
        .flags(&["revived-command"])
        .because("Only a reset lets the seq begin anew, however like a sender that restarts the commands look.")
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
                ("at-once", 0.0, "NCP-RES-013", "moves"),
                ("half", exact / 2.0, "NCP-RES-013", "moves"),
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

/// Ages that are next to a ttl, and further from it than doubles round.
fn hairs() -> Vec<Case> {
    let mut cases = Vec::new();
    for (ttl, end) in [(10.0, 0.01), (60_000.0, 60.0)] {
        for power in [-33, -37] {
            let hair = 2.0_f64.powi(power);
            for (name, age, rule, is) in [
                ("before", end * (1.0 - hair), "NCP-RES-013", "moves"),
                ("past", end * (1.0 + hair), "NCP-RES-002", "holds"),
            ] {
                cases.push(
                    case(
                        format!("hair/ttl-{ttl}/{name}-by-2-to-{power}").replace("--", "-minus-"),
                        &[rule, "NCP-RES-001"],
                        &[command(1, ttl, 0.0), Event::Ask(age)],
                    )
                    .title(format!("A plant {is} {age} s after a command of {ttl} ms that came at 0 s."))
                    .flags(&["off-by-a-boundary"])
                    .because(DEADLINE),
                );
            }
        }
    }
    cases
}

/// Ends of a ttl at which no double is, on clocks that have run for long.
fn far() -> Vec<Case> {
    let one = |power: i32| {
        let (whole, ttl) = super::second_at(power);
        let case = |name: &str, events: &[Event]| {
            case(format!("far/2-to-{power}/{name}"), &["NCP-RES-002", "NCP-RES-001"], events)
                .title(format!(
                    "A plant holds one second after a command of {ttl} ms that came before 2^{power} s ({name})."
                ))
                .flags(&["off-by-a-boundary"])
                .because(DEADLINE)
        };
        [
            case("first", &[command(1, ttl, whole - 1.0), Event::Ask(whole)]),
            case(
                "renewed",
                &[
                    command(1, 250.0, whole - 2.0),
                    command(2, ttl, whole - 1.0),
                    Event::Ask(whole - 0.5),
                    Event::Ask(whole),
                ],
            ),
        ]
    };
    super::FAR.into_iter().flat_map(one).collect()
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
    cases
}

/// A clock that steps back.
fn steps_back() -> Vec<Case> {
    let mut cases = Vec::new();
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
            case(
                format!("backward/{}/persists", name_of(back)),
                &["NCP-RES-010", "NCP-RES-008"],
                &[command(1, 250.0, received), Event::Ask(now), Event::Ask(received)],
            )
            .title(format!("The hold for a clock {back} s back persists when the clock is right again."))
            .flags(&["L14", "reviving-hold"])
            .because(
                "A hold persists until an advancing command, also when the clock then reads a time at \
                          which the command was not yet expired.",
            ),
        );
    }
    cases
}
