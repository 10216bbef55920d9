//! The age of the sensor.

use super::model::{Limits, Step, Trace};
use super::{case, good, near};
use crate::case::{Case, File};
use crate::trace::name_of;

pub(super) fn file() -> File {
    let mut cases = ages();
    cases.extend(clocks());
    cases.extend(timeouts());
    cases.extend(traces());
    let about = "When a sensor is stale: its age against the timeout, clocks that are no clocks, and clocks that step.";
    File::new("safety", "stale", about, cases)
}

fn limits(timeout: f64) -> Limits {
    Limits { timeout, ..Limits::NONE }
}

fn ask(now: f64, last: Option<f64>) -> Step {
    Step::Govern { command: good(), now, sensor: Some(near()), last }
}

/// Timeouts and ages that doubles hold exactly, at several times of the clock.
fn ages() -> Vec<Case> {
    let mut cases = Vec::new();
    for (timeout, exact) in [(500.0, 0.5), (250.0, 0.25), (125.0, 0.125), (1000.0, 1.0), (62.5, 0.0625)] {
        for start in [0.0, 1.0, 64.0, 4096.0] {
            let table: [(&str, f64, &'static str, &str); 6] = [
                ("at-once", 0.0, "NCP-SAFE-034", "passes"),
                ("half", exact / 2.0, "NCP-SAFE-034", "passes"),
                ("just-inside", exact * (1.0 - 1.0 / 1024.0), "NCP-SAFE-034", "passes"),
                ("exact", exact, "NCP-SAFE-034", "passes"),
                ("just-outside", exact * (1.0 + 1.0 / 1024.0), "NCP-SAFE-033", "is held"),
                ("double", exact * 2.0, "NCP-SAFE-033", "is held"),
            ];
            for (name, age, rule, ends) in table {
                // The boundary at every time; the rest once.
                if start > 0.0 && !matches!(name, "exact" | "just-outside") {
                    continue;
                }
                cases.push(
                    case(
                        format!("age/{timeout}-ms/from-{start}-s/{name}"),
                        &[rule],
                        &Trace::new(limits(timeout), vec![ask(start + age, Some(start))]),
                    )
                    .title(format!("A command passes or is held by a sensor {} ms old under a timeout of {timeout} ms: it {ends}.", age * 1000.0))
                    .flags(&["off-by-a-boundary"])
                    .because("The governor holds when now \u{2212} last is more than the timeout, and not when it is exactly that."),
                );
            }
        }
    }
    cases
}

/// Clock readings that are none, or that run backward.
fn clocks() -> Vec<Case> {
    let mut cases = Vec::new();
    let strange = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    for value in strange {
        for (which, now, last) in [("now", value, 10.0), ("last", 10.0, value), ("both", value, value)] {
            cases.push(
                case(
                    format!("clock/{which}/{}", name_of(value)),
                    &["NCP-SAFE-031"],
                    &Trace::new(limits(500.0), vec![ask(now, Some(last))]),
                )
                .title(format!("A command is held when {which} reads {}.", name_of(value)))
                .flags(&["non-finite-clock"])
                .because("The governor holds when now or last is not finite."),
            );
        }
    }
    for by in [5e-324, 1e-9, 0.001, 0.25, 1.0, 100.0, 1e308] {
        let (now, last) = if by < 1e-6 { (0.0, by) } else { (10.0, 10.0 + by) };
        cases.push(
            case(
                format!("backward/{}", name_of(by)),
                &["NCP-SAFE-035"],
                &Trace::new(limits(500.0), vec![ask(now, Some(last))]),
            )
            .title(format!("A command is held when the clock reads {by} s less than the sensor's time."))
            .flags(&["L14"])
            .because("The governor holds when now is less than last."),
        );
    }
    cases.push(
        case("no-time/once", &["NCP-SAFE-030"], &Trace::new(limits(500.0), vec![ask(10.0, None)]))
            .title("A command is held when no sensor has ever come.")
            .because("The governor holds when there is no sensor time."),
    );
    cases.push(
        case(
            "no-time/at-zero",
            &["NCP-SAFE-030"],
            &Trace::new(limits(500.0), vec![ask(0.0, None), ask(0.25, Some(0.0))]),
        )
        .title("No sensor time is another thing than a sensor time of 0.")
        .because("The governor holds when there is no sensor time; 0 is one."),
    );
    // The sender's clock is another one.
    for t in [0.0, -1e6, 1e6, 1e308, 5e-324] {
        let mut sensor = near();
        sensor.t = t;
        let step = Step::Govern { command: good(), now: 10.25, sensor: Some(sensor), last: Some(10.0) };
        cases.push(
            case(
                format!("senders-clock/{}", name_of(t)),
                &["NCP-SAFE-034", "NCP-SAFE-021"],
                &Trace::new(limits(500.0), vec![step]),
            )
            .title(format!("A sensor's own time of {t} s says nothing about its age."))
            .flags(&["L25"])
            .because("Both now and last are on the governor's clock; `t` is never compared with another peer's clock."),
        );
    }
    cases
}

/// Timeouts that are none.
fn timeouts() -> Vec<Case> {
    let bad = [0.0, -0.0, -1.0, -500.0, -5e-324, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    let mut cases: Vec<Case> = bad
        .into_iter()
        .map(|timeout| {
            case(
                format!("timeout/{}", name_of(timeout)),
                &["NCP-SAFE-032"],
                &Trace::new(limits(timeout), vec![ask(10.0, Some(10.0)), ask(10.25, Some(10.0))]),
            )
            .title(format!("A governor whose timeout is {} ms holds.", name_of(timeout)))
            .flags(&["L13"])
            .because("The governor holds when `command_timeout_ms` is not finite or not positive.")
        })
        .collect();
    cases.push(
        case("timeout/huge", &["NCP-SAFE-034"], &Trace::new(limits(1e308), vec![ask(1e6, Some(0.0))]))
            .title("A governor with a timeout of 1e308 ms lets an old sensor pass.")
            .because("The sensor's age is not more than the timeout."),
    );
    cases.push(
        case(
            "timeout/subnormal",
            &["NCP-SAFE-033"],
            &Trace::new(limits(5e-324), vec![ask(10.0, Some(10.0)), ask(10.001, Some(10.0))]),
        )
        .title("A governor with the smallest timeout takes only a sensor of age 0.")
        .because("An age of 0 is not more than any positive timeout; an age of 1 ms is more than this one."),
    );
    cases
}

/// Clocks over several commands.
fn traces() -> Vec<Case> {
    #[expect(clippy::type_complexity, reason = "a table is read by its rows")]
    let table: [(&str, &[&'static str], &str, &[(f64, f64)]); 6] = [
        (
            "ages-and-renews",
            &["NCP-SAFE-022", "NCP-SAFE-033"],
            "A sensor ages until it is stale, and a new one lets commands pass again.",
            &[(1.0, 1.0), (1.25, 1.0), (1.5, 1.0), (1.75, 1.0), (2.0, 2.0), (2.5, 2.0), (2.75, 2.0)],
        ),
        (
            "steps-backward",
            &["NCP-SAFE-022", "NCP-SAFE-035"],
            "A clock that steps backward holds while it reads less than the sensor's time.",
            &[(100.0, 100.0), (99.0, 100.0), (50.0, 100.0), (50.0, 50.0), (50.25, 50.0)],
        ),
        (
            "steps-forward",
            &["NCP-SAFE-022", "NCP-SAFE-033"],
            "A clock that steps forward makes the sensor stale until the next one.",
            &[(1.0, 1.0), (1000.0, 1.0), (1000.25, 1000.0)],
        ),
        (
            "stale-is-not-latched",
            &["NCP-SAFE-022", "NCP-SAFE-033"],
            "Many stale sensors latch nothing.",
            &[(9.0, 1.0), (10.0, 1.0), (11.0, 1.0), (12.0, 1.0), (12.0, 12.0)],
        ),
        (
            "stays-at-the-timeout",
            &["NCP-SAFE-034"],
            "Commands go on at exactly the timeout.",
            &[(0.5, 0.0), (1.0, 0.5), (1.5, 1.0), (2.0, 1.5)],
        ),
        (
            "zero-age",
            &["NCP-SAFE-034"],
            "Commands pass at the very moment of the sensor.",
            &[(0.0, 0.0), (5.0, 5.0), (5.0, 5.0)],
        ),
    ];
    let one = |(name, rules, title, times): (&str, &[&'static str], &str, &[(f64, f64)])| {
        let steps = times.iter().map(|(now, last)| ask(*now, Some(*last))).collect();
        case(format!("trace/{name}"), rules, &Trace::new(limits(500.0), steps))
            .title(title)
            .because("Each command is judged by its own now and last: stale is an age of more than 500 ms, or below 0.")
    };
    table.into_iter().map(one).collect()
}
