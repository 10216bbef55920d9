//! The speed limit.

use super::model::{Capabilities, Limits, Trace, govern, scalar, vec3};
use super::{case, near, row_case};
use crate::case::{Case, File};
use crate::command::{Channel, Command, MPS, VELOCITY, channel, velocity};
use crate::json::{Json, object};
use crate::scenario::{ScenarioError, Scenarios, source};
use crate::trace::{any, name_of, num, nums, refused, steps, within};

pub(super) fn file() -> Result<File, ScenarioError> {
    let mut cases = vectors();
    cases.extend(never_above());
    cases.extend(hairs());
    cases.extend(huge());
    cases.extend(huge_beside());
    let mut text = Scenarios::read(source!("safety/speed"))?;
    cases.extend(text.cases("signs-of-zero", |row| Ok(row_case(row)?.with_signs()))?);
    cases.extend(text.rest(row_case)?);
    cases.extend(channels());
    cases.extend(horizons());
    cases.extend(ticks_without_a_horizon());
    cases.extend(off());
    let about =
        "The speed limit: vectors above, at and below it, those that cannot be scaled, further channels and horizons.";
    Ok(File::new("safety", "speed", about, cases))
}

fn one(path: String, rules: &[&'static str], limits: Limits, command: Command) -> Case {
    case(path, rules, &Trace::new(limits, vec![govern(command, near())]))
}

const CLAMP: &str = "A velocity whose norm is above the limit is scaled to it, direction kept; one whose norm is \
                     not above it is unchanged.";

/// Vectors of exact norm, in several sizes, around several limits.
fn vectors() -> Vec<Case> {
    let mut cases = Vec::new();
    let units: [([f64; 3], f64); 7] = [
        ([3.0, 4.0, 0.0], 5.0),
        ([0.0, -3.0, 4.0], 5.0),
        ([-4.0, 0.0, -3.0], 5.0),
        ([2.0, 3.0, 6.0], 7.0),
        ([-1.0, 4.0, -8.0], 9.0),
        ([1.0, 0.0, 0.0], 1.0),
        ([0.0, 0.0, -1.0], 1.0),
    ];
    for (vector, norm) in units {
        for (name, limit, rules) in [
            ("at", norm, &["NCP-SAFE-062"][..]),
            ("below", norm * 2.0, &["NCP-SAFE-062"][..]),
            ("well-below", norm * 3.0, &["NCP-SAFE-062"][..]),
            ("far-below", norm * 16.0, &["NCP-SAFE-062"][..]),
            ("very-far-below", norm * 1024.0, &["NCP-SAFE-062"][..]),
            ("next-to-nothing", norm * 1e9, &["NCP-SAFE-062"][..]),
            ("just-below", norm * (1.0 + 1.0 / 1024.0), &["NCP-SAFE-062"][..]),
            ("just-above", norm * (1.0 - 1.0 / 1024.0), &["NCP-SAFE-060", "NCP-SAFE-061"][..]),
            ("above", norm / 2.0, &["NCP-SAFE-060", "NCP-SAFE-061"][..]),
            ("far-above", norm / 1024.0, &["NCP-SAFE-061", "NCP-SAFE-060"][..]),
        ] {
            let path = format!("vector/{}-{}-{}/{name}", vector[0], vector[1], vector[2])
                .replace("--", "-minus-")
                .replace("/-", "/minus-");
            cases.push(
                one(path, rules, Limits::speed(limit), Command::moving(&vector))
                    .title(format!(
                        "({}, {}, {}) m/s, {} the limit of {limit} m/s, obeys it.",
                        vector[0],
                        vector[1],
                        vector[2],
                        name.replace('-', " ")
                    ))
                    .flags(&["per-axis-clamp"])
                    .because(CLAMP),
            );
        }
    }
    cases.push(
        one("vector/still".to_owned(), &["NCP-SAFE-062"], Limits::speed(1.0), Command::moving(&[0.0, 0.0, 0.0]))
            .title("A velocity of 0 passes as it is.")
            .because("Its norm is not above the limit; scaling it would divide by 0."),
    );
    cases.push(
        one("vector/tiny".to_owned(), &["NCP-SAFE-062"], Limits::speed(1.0), Command::moving(&[5e-324, -5e-324, 0.0]))
            .title("A subnormal velocity passes.")
            .because("Its norm is not above the limit."),
    );
    cases
}

/// Along one axis the norm is the component itself: a rounding above the limit is allowed, and not one ulp advised.
fn never_above() -> Vec<Case> {
    let mut cases = Vec::new();
    for limit in [0.1, 0.3, 1.0, 1.5, 2.9, 1000.0 / 3.0] {
        for speed in [3.0, 7.7, 1e3] {
            let command = Command::moving(&[speed * limit, 0.0, 0.0]);
            let trace = Trace::new(Limits::speed(limit), vec![govern(command, near())]);
            for (group, rule, most, words, why) in [
                (
                    "never-above",
                    "NCP-SAFE-060",
                    limit * (1.0 + 1e-12),
                    "is scaled to the limit, but for a rounding",
                    "The norm of what is sent is not above the limit by more than a rounding, one part in 10^12.",
                ),
                (
                    "no-ulp-above",
                    "NCP-SAFE-069",
                    limit,
                    "should be scaled to no ulp above the limit",
                    "A scaled velocity should not be above the limit by a rounding either.",
                ),
            ] {
                let scaled = vec![within(limit * (1.0 - 1e-9), most), num(0.0), num(0.0)];
                let frame = object! { "mode" => "active",
                "channels" => object! { VELOCITY => object! { "data" => Json::Array(scaled) } } };
                cases.push(
                    case(format!("{group}/{limit:.1}/{speed}"), &[rule], &trace)
                        .shows(steps(vec![object! { "frame" => frame }]))
                        .title(format!("{speed} times the limit of {limit:.1} m/s along x {words}."))
                        .flags(&["overflowing-norm"])
                        .because(why),
                );
            }
        }
    }
    cases
}

/// Norms above the limit by ever less of it, and below it: only a rounding is allowed, one part in 10^12. Along one
/// axis the norm is the component itself.
fn hairs() -> Vec<Case> {
    let mut cases = Vec::new();
    let pose = |direction: [f64; 3], speed: f64| direction.map(|x| if x == 0.0 { 0.0 } else { x * speed });
    let (ahead, down) = ([0.0, 1.0, 0.0], [0.0, 0.0, -1.0]);
    for (limit, direction) in [(2.0, ahead), (2.5, down), (1e-6, ahead), (1e6, down)] {
        for power in 3..=11 {
            // The other limits show that a tolerance of so many m/s is none either.
            if limit != 2.0 && power != 7 && power != 11 {
                continue;
            }
            let hair = 10.0_f64.powi(-power);
            let fast = pose(direction, limit * (1.0 + hair));
            let slow = pose(direction, limit * 0.25);
            let most = pose(direction, limit);
            // What is sent of a velocity that is too fast.
            let clamped = || {
                let of = |x: f64| {
                    let (low, high) = (x.abs() * (1.0 - 1e-9), x.abs() * (1.0 + 1e-12));
                    if x == 0.0 {
                        num(0.0)
                    } else if x > 0.0 {
                        within(low, high)
                    } else {
                        within(-high, -low)
                    }
                };
                object! { "data" => most.iter().copied().map(of).collect::<Json>() }
            };
            let near_by = || Command::moving(&slow);
            let at_once = vec![(VELOCITY, fast.to_vec())];
            let beside = vec![(VELOCITY, slow.to_vec()), ("tow_velocity", fast.to_vec())];
            let of = |channels: &[(&str, Vec<f64>)]| -> Vec<Channel> {
                channels.iter().map(|(name, data)| channel(name, data, Some(MPS))).collect()
            };
            let in_step = |step: Vec<Channel>| {
                let mut command = near_by().then(50.0, &[slow, slow]);
                if let Some(last) = command.horizon.last_mut() {
                    *last = step;
                }
                command
            };
            let channels = |name: &str| object! { "channels" => Json::Object(vec![(name.to_owned(), clamped())]) };
            let steps_of = |name: &str| {
                let of_last = Json::Object(vec![(name.to_owned(), clamped())]);
                object! { "horizon" => Json::Array(vec![Json::object(), of_last]) }
            };
            let table = [
                ("tick-0", "NCP-SAFE-060", "the velocity of tick 0", Command::of(of(&at_once)), channels(VELOCITY)),
                (
                    "other-channel",
                    "NCP-SAFE-065",
                    "another channel in m/s",
                    Command::of(of(&beside)),
                    channels("tow_velocity"),
                ),
                ("step", "NCP-SAFE-066", "the velocity of a step", in_step(of(&at_once)), steps_of(VELOCITY)),
                (
                    "other-channel-of-a-step",
                    "NCP-SAFE-066",
                    "another channel in m/s of a step",
                    in_step(of(&beside)),
                    steps_of("tow_velocity"),
                ),
            ];
            for (name, rule, words, command, pattern) in table {
                if name != "tick-0" && (limit != 2.0 || power % 2 == 0) || name.ends_with("a-step") && power < 9 {
                    continue;
                }
                let trace = Trace::new(Limits::speed(limit), vec![govern(command, near())]);
                let path = format!("hair/{}/{name}/above-by-1e-{power}", name_of(limit));
                cases.push(
                    case(path, &[rule, "NCP-SAFE-061"], &trace)
                        .shows(steps(vec![object! { "frame" => pattern.and("mode", "active".into()) }]))
                        .title(format!(
                            "Under a limit of {limit} m/s {words} is scaled that is above it by 1e-{power} of it."
                        ))
                        .flags(&["per-axis-clamp"])
                        .because(
                            "The norm of what is sent is not above the limit by more than a rounding, one part in \
                             10^12.",
                        ),
                );
            }
            if power < 9 {
                continue;
            }
            let just_below = pose(direction, limit * (1.0 - hair));
            let trace = Trace::new(Limits::speed(limit), vec![govern(Command::moving(&just_below), near())]);
            cases.push(
                case(format!("hair/{}/below-by-1e-{power}", name_of(limit)), &["NCP-SAFE-062"], &trace)
                    .shows_exactly(trace.pattern())
                    .title(format!(
                        "Under a limit of {limit} m/s a velocity is left as it is that is below it by 1e-{power} of it."
                    ))
                    .flags(&["per-axis-clamp"])
                    .because(CLAMP),
            );
        }
    }
    cases
}

/// Norms that overflow, or whose squares do: such a velocity is scaled like every other.
fn huge() -> Vec<Case> {
    let r = 0.5_f64.sqrt();
    let third = (1.0_f64 / 3.0).sqrt();
    let table: [(&str, [f64; 3], [f64; 3]); 8] = [
        ("one-axis", [1e308, 0.0, 0.0], [1.0, 0.0, 0.0]),
        ("largest", [f64::MAX, 0.0, 0.0], [1.0, 0.0, 0.0]),
        ("minus-largest", [0.0, -f64::MAX, 0.0], [0.0, -1.0, 0.0]),
        ("two-axes", [1e308, 1e308, 0.0], [r, r, 0.0]),
        ("three-axes", [f64::MAX, f64::MAX, -f64::MAX], [third, third, -third]),
        ("squares-overflow", [1e200, 0.0, 0.0], [1.0, 0.0, 0.0]),
        ("three-four", [3e200, 4e200, 0.0], [0.6, 0.8, 0.0]),
        ("mixed", [1e308, 1.0, 0.0], [1.0, 0.0, 0.0]),
    ];
    let mut cases = Vec::new();
    for (name, v, direction) in table {
        for limit in [1.0, 2.5] {
            let command = Command::moving(&v);
            let trace = Trace::new(Limits::speed(limit), vec![govern(command, near())]);
            let scaled = nums(&direction.map(|x| x * limit));
            let frame = object! { "mode" => "active",
            "channels" => object! { VELOCITY => object! { "data" => scaled } } };
            cases.push(
                case(format!("huge/{name}/limit-{limit}"), &["NCP-SAFE-060", "NCP-SAFE-061"], &trace)
                    .shows(steps(vec![object! { "frame" => frame }]))
                    .title(format!("A velocity of ({}, {}, {}) m/s is scaled to {limit} m/s.", v[0], v[1], v[2]))
                    .flags(&["overflowing-norm"])
                    .because(
                        "A norm that overflows a double is above every limit, and its velocity is scaled like every \
                         other.",
                    ),
            );
        }
    }
    cases
}

/// The same in a channel of its own width, beside the velocity and in a step.
fn huge_beside() -> Vec<Case> {
    let table: [(&str, &[f64]); 4] = [
        ("one", &[f64::MAX]),
        ("two", &[1.5e308, -1.5e308]),
        ("four", &[1e308, 1e308, -1e308, 1e308]),
        ("squares-of-five", &[0.0, 0.0, 1e200, 0.0, 0.0]),
    ];
    let mut cases = Vec::new();
    for (name, data) in table {
        // All that are not 0 are alike.
        let many = data.iter().filter(|x| **x != 0.0).map(|_| 1.0).sum::<f64>();
        let sign = |x: &f64| if *x == 0.0 { 0.0 } else { x.signum() };
        let scaled: Vec<_> = data.iter().map(|x| sign(x) * 2.5 / many.sqrt()).collect();
        let channels = vec![velocity(&[1.0, 0.0, 0.0]), channel("arm", data, Some(MPS))];
        let mut in_step = Command::moving(&[1.0, 0.0, 0.0]).then(62.5, &[[1.0, 0.0, 0.0]]);
        in_step.horizon = vec![channels.clone()];
        let shown = object! { "arm" => object! { "data" => nums(&scaled) } };
        for (place, command, frame) in [
            ("beside", Command::of(channels), object! { "mode" => "active", "channels" => shown.clone() }),
            ("step", in_step, object! { "mode" => "active", "horizon" => Json::Array(vec![shown]) }),
        ] {
            let trace = Trace::new(Limits::speed(2.5), vec![govern(command, near())]);
            cases.push(
                case(format!("huge/{place}/{name}"), &["NCP-SAFE-061", "NCP-SAFE-065", "NCP-SAFE-060"], &trace)
                    .shows(steps(vec![object! { "frame" => frame }]))
                    .title(format!("A channel of {data:?} m/s ({place}) is scaled to the limit as a velocity is."))
                    .flags(&["overflowing-norm", "first-channel"])
                    .because("The limit acts on every channel in `m/s`, and scaling keeps its direction and its size."),
            );
        }
    }
    cases
}

/// Further channels, in m/s and in other units.
fn channels() -> Vec<Case> {
    let mut cases = Vec::new();
    for (name, more) in [
        ("tow", channel("tow_velocity", &[0.0, 30.0, 40.0], Some(MPS))),
        ("sorted-first", channel("a_velocity", &[-30.0, 0.0, 40.0], Some(MPS))),
        ("sorted-last", channel("z_velocity", &[20.0, 30.0, 60.0], Some(MPS))),
    ] {
        for (order, commands) in [
            ("before", [more.clone(), velocity(&[1.0, 0.0, 0.0])]),
            ("after", [velocity(&[3.0, 4.0, 0.0]), more.clone()]),
        ] {
            cases.push(
                one(
                    format!("channel/{name}/{order}"),
                    &["NCP-SAFE-065"],
                    Limits::speed(2.0),
                    Command::of(commands.to_vec()),
                )
                .title(format!("A second channel in m/s ({name}, {order} the velocity) obeys the speed limit too."))
                .flags(&["first-channel"])
                .because("The governor applies the limit to every channel of the command in `m/s`."),
            );
        }
    }
    // By its negotiated unit.
    let extra = vec3("tow_velocity", Some(MPS));
    let commands = vec![velocity(&[1.0, 0.0, 0.0]), channel("tow_velocity", &[0.0, 30.0, 40.0], None)];
    cases.push(
        case(
            "channel/negotiated-unit",
            &["NCP-SAFE-065", "NCP-SAFE-042"],
            &Trace::negotiated(
                Limits::speed(2.0),
                Capabilities::canonical(&[extra]),
                vec![govern(Command::of(commands), near())],
            ),
        )
        .title("A second channel whose negotiated unit is m/s obeys the speed limit too.")
        .flags(&["L10"])
        .because("A channel without a unit is in the negotiated one, here m/s."),
    );
    for unit in ["rad/s", "m", "lm", "m/s2", "km/h", "rpm"] {
        let more = channel("other", &[300.0, 400.0, 500.0], Some(unit));
        cases.push(
            one(
                format!("channel/unit-{}", unit.replace('/', "-per-")),
                &["NCP-SAFE-021"],
                Limits::speed(2.0),
                Command::moving(&[2.0, 0.0, 0.0]).and(more),
            )
            .title(format!("A channel in {unit} is left as it is."))
            .flags(&["over-strict"])
            .because(
                "The speed limit acts on channels in `m/s`, and a command passes unchanged that nothing else changes.",
            ),
        );
        let more = channel("other", &[300.0, 400.0, 500.0], Some(unit));
        cases.push(
            one(
                format!("channel/unit-{}-beside-a-clamp", unit.replace('/', "-per-")),
                &["NCP-SAFE-060"],
                Limits::speed(2.0),
                Command::moving(&[3.0, 4.0, 0.0]).and(more),
            )
            .title(format!("While the velocity is scaled, a channel in {unit} is left as it is."))
            .because("The speed limit acts on channels in `m/s` only."),
        );
    }
    // A scalar in m/s is bounded, or the command held.
    for value in [-9.0, 9.0] {
        let command = Command::moving(&[1.0, 0.0, 0.0]).and(channel("climb", &[value], Some(MPS)));
        let trace = Trace::negotiated(
            Limits::speed(2.0),
            Capabilities::canonical(&[scalar("climb", Some(MPS))]),
            vec![govern(command, near())],
        );
        let frame = object! { "frame" => object! { "channels" => object! { "climb" => object! { "data" =>
        std::iter::once(within(-2.0 - 1e-9, 2.0 + 1e-9)).collect::<crate::json::Json>() } } } };
        cases.push(
            case(format!("channel/scalar/{}", name_of(value)), &["NCP-SAFE-065"], &trace)
                .shows(steps(vec![frame]))
                .title(format!("A scalar channel of {value} m/s obeys the speed limit too."))
                .flags(&["first-channel"])
                .because("The governor applies the limit to every channel of the command in `m/s`."),
        );
    }
    cases
}

const TRUNCATES_OR_HOLDS: &str =
    "The governor truncates the horizon before a step that has a component that is not finite, or holds.";

/// The limit on every step.
/// The length of a tick without a horizon: it says nothing, and is a part of the command.
fn ticks_without_a_horizon() -> Vec<Case> {
    let table = [
        ("no-limit", Limits::NONE, "Without limits"),
        ("speed-limit", Limits::speed(2.0), "Within a speed limit"),
        ("fence", Limits::fence(5.0), "Within a fence"),
    ];
    let of = |(name, limits, words): (&str, Limits, &str)| {
        let mut command = Command::moving(&[0.5, 0.0, 0.0]);
        command.dt = Some(62.5);
        let trace = Trace::new(limits, vec![govern(command, near())]);
        let frame = object! { "mode" => "active", "horizon" => Json::Array(Vec::new()), "horizon_dt_ms" => num(62.5) };
        case(format!("horizon/none-of-62.5-ms/{name}"), &["NCP-SAFE-021"], &trace)
            .shows(steps(vec![object! { "frame" => frame }]))
            .title(format!("{words} a command that passes keeps the length of a tick, though it has no horizon."))
            .flags(&["over-strict"])
            .because("A command that no gate closes on, no clamp changes and no truncation shortens passes unchanged.")
    };
    table.map(of).into()
}

fn horizons() -> Vec<Case> {
    let mut cases = Vec::new();
    let fast = [30.0, 40.0, 0.0];
    // At the limit, where also a governor that scales every velocity to it changes nothing.
    let slow = [2.0, 0.0, 0.0];
    // Which of tick 0 and three steps are too fast.
    for mask in 0..16_u32 {
        let tick = |at: u32| if mask >> at & 1 == 1 { fast } else { slow };
        let command = Command::moving(&tick(0)).then(50.0, &[tick(1), tick(2), tick(3)]);
        let rule = if mask >> 1 > 0 {
            "NCP-SAFE-066"
        } else if mask > 0 {
            "NCP-SAFE-060"
        } else {
            "NCP-SAFE-062"
        };
        cases.push(
            one(format!("horizon/clamped-{mask:04b}"), &[rule], Limits::speed(2.0), command)
                .title(format!(
                    "Of tick 0 and three steps, those that are too fast (bits {mask:04b}, tick 0 last) are scaled."
                ))
                .flags(&["unclamped-horizon"])
                .because("The governor applies the speed limit to every step of the horizon."),
        );
    }
    // A step that cannot be clamped ends the horizon.
    let bad: [(&str, Vec<Channel>); 6] = [
        ("absent", vec![channel("gripper", &[1.0], None)]),
        ("empty", vec![velocity(&[])]),
        ("two-wide", vec![velocity(&[1.0, 0.0])]),
        ("knots", vec![channel(VELOCITY, &[1.0, 0.0, 0.0], Some("kn"))]),
        ("nan", vec![velocity(&[f64::NAN, 0.0, 0.0])]),
        ("infinity", vec![velocity(&[0.0, f64::INFINITY, 0.0])]),
    ];
    for (name, step) in bad {
        for at in 0..3 {
            let mut command = Command::moving(&slow).then(50.0, &[slow; 3]);
            if let Some(place) = command.horizon.get_mut(at) {
                place.clone_from(&step);
            }
            let (or_held, why) = if command.is_writable() {
                ("", "The governor truncates the horizon before a step that cannot be clamped.")
            } else {
                (", or the command is held", TRUNCATES_OR_HOLDS)
            };
            cases.push(
                one(format!("horizon/{name}-at-{}", at + 1), &["NCP-SAFE-067"], Limits::speed(2.0), command)
                    .title(format!(
                        "A horizon is truncated before step {}, whose velocity cannot be clamped ({name}){or_held}.",
                        at + 1
                    ))
                    .flags(&["unclamped-horizon"])
                    .because(why),
            );
        }
    }
    cases.extend(other_channels_of_steps());
    // A tick without a length.
    for dt in [
        None,
        Some(0.0),
        Some(-0.0),
        Some(-50.0),
        Some(f64::NAN),
        Some(f64::INFINITY),
        Some(f64::NEG_INFINITY),
        Some(-5e-324),
    ] {
        for limits in [Limits::NONE, Limits::speed(2.0), Limits::fence(5.0)] {
            let mut command = Command::moving(&slow).then(50.0, &[slow]);
            command.dt = dt;
            let with = match (limits.speed, limits.fence) {
                (Some(_), _) => "speed-limit",
                (_, Some(_)) => "fence",
                _ => "no-limit",
            };
            let name = dt.map_or("absent".to_owned(), name_of);
            cases.push(
                one(format!("horizon/dt-{name}/{with}"), &["NCP-SAFE-068"], limits, command)
                    .title(format!(
                        "A horizon whose tick has the length {name} is held, with {}.",
                        with.replace('-', " ")
                    ))
                    .because(
                        "The governor holds on a command with a horizon whose `horizon_dt_ms` is absent, not \
                              finite or not positive.",
                    ),
            );
        }
    }
    // Also when its first step cannot be clamped, or says nothing of the velocity.
    let unusable: [(&str, Vec<Channel>); 3] = [
        ("two-wide", vec![velocity(&[1.0, 0.0])]),
        ("knots", vec![channel(VELOCITY, &[1.0, 0.0, 0.0], Some("kn"))]),
        ("other-channels", vec![channel("gripper", &[1.0], None)]),
    ];
    for (name, step) in unusable {
        for (limits, with) in [(Limits::speed(2.0), "speed-limit"), (Limits::NONE, "no-limit")] {
            let mut command = Command::moving(&slow).then(50.0, &[slow]);
            command.horizon[0].clone_from(&step);
            command.dt = None;
            cases.push(
                one(format!("horizon/dt-absent/{name}/{with}"), &["NCP-SAFE-068"], limits, command)
                    .title(format!(
                        "A horizon whose tick has no length is held, though its first step is {}, with {}.",
                        if name == "other-channels" {
                            "of another channel".to_owned()
                        } else {
                            format!("odd ({name})")
                        },
                        with.replace('-', " ")
                    ))
                    .because(
                        "The governor holds on a command with a horizon whose `horizon_dt_ms` is absent, whatever its \
                         steps are.",
                    ),
            );
        }
    }
    // Without a horizon, its tick does not count.
    for dt in [0.0, -50.0, 50.0] {
        let mut command = Command::moving(&slow);
        command.dt = Some(dt);
        cases.push(
            one(format!("no-horizon/dt-{}", name_of(dt)), &["NCP-SAFE-021"], Limits::speed(2.0), command)
                .title(format!("A command without a horizon passes, though its tick has the length {dt}."))
                .flags(&["over-strict"])
                .because("Only a command with a horizon is held for the length of its tick."),
        );
    }
    cases
}

/// Channels of a step beside its velocity.
fn other_channels_of_steps() -> Vec<Case> {
    let mut cases = Vec::new();
    // At the limit, and deep inside the fence.
    let slow = [2.0, 0.0, 0.0];
    let with = |place: usize, more: Channel| {
        let mut command = Command::moving(&slow).then(50.0, &[slow, slow]);
        if let Some(step) = command.horizon.get_mut(place) {
            step.push(more);
        }
        command
    };
    let strange = [
        ("gripper", None, f64::NAN),
        ("body_rates", Some("rad/s"), f64::INFINITY),
        ("tow_velocity", Some(MPS), f64::NAN),
    ];
    for (name, unit, value) in strange {
        for place in 0..2 {
            for (limit, limits) in
                [("no-limit", Limits::NONE), ("speed-limit", Limits::speed(2.0)), ("fence", Limits::fence(5.0))]
            {
                let command = with(place, channel(name, &[0.5, value], unit));
                cases.push(
                    one(
                        format!("horizon/{}-{}-at-{}/{limit}", name.replace('_', "-"), name_of(value), place + 1),
                        &["NCP-SAFE-067"],
                        limits,
                        command,
                    )
                    .title(format!(
                        "A horizon is truncated before step {}, whose channel {name} holds {}, or the command is \
                         held, with {}.",
                        place + 1,
                        name_of(value),
                        limit.replace('-', " ")
                    ))
                    .flags(&["non-finite-command"])
                    .because(TRUNCATES_OR_HOLDS),
                );
            }
        }
    }
    // As of tick 0, every channel in m/s is limited.
    let tow = |unit| channel("tow_velocity", &[0.0, 30.0, 40.0], unit);
    for place in 0..2 {
        cases.push(
            one(
                format!("horizon/tow-at-{}", place + 1),
                &["NCP-SAFE-066", "NCP-SAFE-065"],
                Limits::speed(2.0),
                with(place, tow(Some(MPS))),
            )
            .title(format!("A second channel in m/s obeys the speed limit in step {} of a horizon too.", place + 1))
            .flags(&["unclamped-horizon"])
            .because("The governor applies the limit to every channel in `m/s`, and to every step of the horizon."),
        );
        let steps = vec![govern(with(place, tow(None)), near())];
        let capabilities = Capabilities::canonical(&[vec3("tow_velocity", Some(MPS))]);
        cases.push(
            case(
                format!("horizon/tow-at-{}/negotiated-unit", place + 1),
                &["NCP-SAFE-065", "NCP-SAFE-066", "NCP-SAFE-042"],
                &Trace::negotiated(Limits::speed(2.0), capabilities, steps),
            )
            .title(format!(
                "A second channel whose negotiated unit is m/s obeys the speed limit in step {} too.",
                place + 1
            ))
            .flags(&["unclamped-horizon", "L10"])
            .because("A channel without a unit is in the negotiated one, here m/s, in every step of the horizon."),
        );
    }
    // Tick 0 says another unit of the channel, and the step says none.
    let command = Command::moving(&[1.0, 0.0, 0.0]).and(channel("arm", &[0.0, 30.0, 40.0], Some("rad")));
    let step = vec![velocity(&[1.0, 0.0, 0.0]), channel("arm", &[0.0, 30.0, 40.0], None)];
    let capabilities = Capabilities::canonical(&[vec3("arm", Some(MPS))]);
    let mut command = command.along_x(125.0, &[1.0]);
    command.horizon = vec![step];
    let steps = vec![govern(command, near())];
    cases.push(
        case(
            "horizon/negotiated-unit-behind-another".to_owned(),
            &["NCP-SAFE-042", "NCP-SAFE-066"],
            &Trace::negotiated(Limits::speed(2.0), capabilities, steps),
        )
        .title("A channel without a unit in a step is in the negotiated one, whatever unit tick 0 says of it.")
        .flags(&["unclamped-horizon", "L10"])
        .because("The unit of a channel without one is the negotiated one, and not that of another step."),
    );
    cases
}

/// Limits that are none.
fn off() -> Vec<Case> {
    let mut cases = Vec::new();
    for (name, speed) in [("absent", None), ("zero", Some(0.0))] {
        for (what, command) in [
            ("fast", Command::moving(&[3e5, 4e5, 0.0])),
            ("no-velocity", Command::of(vec![channel("gripper", &[1.0], None)])),
            ("two-wide", Command::moving(&[3.0, 4.0])),
            ("knots", Command::of(vec![channel(VELOCITY, &[3.0, 4.0, 0.0], Some("kn"))])),
        ] {
            let limits = Limits { speed, ..Limits::NONE };
            cases.push(
                one(format!("off/{name}/{what}"), &["NCP-SAFE-012"], limits, command)
                    .title(format!("A speed limit that is {name} changes nothing ({what})."))
                    .flags(&["L13"])
                    .because("A limit that is absent or 0 is disabled."),
            );
        }
    }
    // Neither reading of a negative zero is wrong; what is sent is.
    for (name, limits) in [("speed", Limits::speed(-0.0)), ("fence", Limits::fence(-0.0))] {
        let trace = Trace::new(limits, vec![govern(Command::moving(&[1.0, 0.0, 0.0]), near())]);
        let data =
            |x: f64| object! { "channels" => object! { VELOCITY => object! { "data" => nums(&[x, 0.0, 0.0]) } } };
        let frames = vec![
            object! { "frame" => data(1.0).and("mode", "active".into()) },
            object! { "frame" => data(0.0).and("mode", "hold".into()) },
            refused(),
        ];
        cases.push(
            case(format!("off/minus-zero/{name}"), &["NCP-SAFE-012"], &trace)
                .shows_or_refuses(steps(vec![any(frames)]))
                .title(format!("A {name} limit of {} is disabled, or held for.", num(-0.0).text().replace('"', "")))
                .because("0 is disabled, and the negative zero is equal to it."),
        );
    }
    cases
}
