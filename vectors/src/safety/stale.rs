//! The age of the sensor.

use super::model::{Limits, Step, Trace};
use super::{case, good, near, row_case};
use crate::case::{Case, File};
use crate::scenario::{ScenarioError, Scenarios, source};
use crate::trace::name_of;

pub(super) fn file() -> Result<File, ScenarioError> {
    let mut text = Scenarios::read(source!("safety/stale"))?;
    let mut cases = ages();
    cases.extend(hairs());
    for group in ["clock", "backward", "zero", "no-time", "tiny", "begun-anew", "senders-clock"] {
        cases.extend(text.cases(group, row_case)?);
    }
    cases.extend(timeouts());
    cases.extend(text.rest(row_case)?);
    let about = "When a sensor is stale: its age against the timeout, clocks that are no clocks, and clocks that step.";
    Ok(File::new("safety", "stale", about, cases))
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
                    .title(format!(
                        "A command passes or is held by a sensor {} ms old under a timeout of {timeout} \
                                    ms: it {ends}.",
                        age * 1000.0
                    ))
                    .flags(&["off-by-a-boundary"])
                    .because(
                        "The governor holds when now \u{2212} last is more than the timeout, and not when it \
                              is exactly that.",
                    ),
                );
            }
        }
    }
    cases
}

/// Ages next to a timeout, and further from it than doubles round; and next to it on a clock that has run for long.
fn hairs() -> Vec<Case> {
    let mut cases = Vec::new();
    let mut add = |path: String, rule: &'static str, timeout: f64, age: f64, last: f64| {
        let ends = if rule == "NCP-SAFE-033" { "is held" } else { "passes" };
        cases.push(
            case(path, &[rule], &Trace::new(limits(timeout), vec![ask(last + age, Some(last))]))
                .title(format!(
                    "A command is judged by a sensor {age} s old under a timeout of {timeout} ms, at {} s: it {ends}.",
                    last + age
                ))
                .flags(&["off-by-a-boundary"])
                .because(
                    "The governor holds when now \u{2212} last is more than the timeout, and not when it is less.",
                ),
        );
    };
    for (timeout, end) in [(10.0, 0.01), (500.0, 0.5)] {
        for power in [-20, -33, -37] {
            let hair = 2.0_f64.powi(power);
            let path = |name: &str| format!("hair/{timeout}-ms/{name}-by-2-to-minus-{}", -power);
            add(path("inside"), "NCP-SAFE-034", timeout, end * (1.0 - hair), 0.0);
            add(path("outside"), "NCP-SAFE-033", timeout, end * (1.0 + hair), 0.0);
        }
    }
    // A second before a power of two, and a timeout that ends closer to it than doubles are there.
    for power in [21, 31, 40] {
        let timeout = 1000.0 * (1.0 - 2.0_f64.powi(power - 55));
        let path = format!("hair/at-2-to-{power}-s/outside");
        add(path, "NCP-SAFE-033", timeout, 1.0, 2.0_f64.powi(power) - 1.0);
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
        .by("/steps/0", "NCP-SAFE-021")
        .title("A governor with the smallest timeout takes only a sensor of age 0.")
        .because("An age of 0 is not more than any positive timeout; an age of 1 ms is more than this one."),
    );
    cases
}
