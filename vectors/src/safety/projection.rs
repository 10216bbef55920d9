//! Where a command leads within its ttl.

use super::model::{Capabilities, Limits, Sensor, Trace, govern, vec3};
use super::{case, row_case};
use crate::case::{Case, File};
use crate::command::{Command, MPS, VELOCITY, channel, velocity};
use crate::scenario::{ScenarioError, Scenarios, source};
use crate::trace::name_of;

pub(super) fn file() -> Result<File, ScenarioError> {
    let mut text = Scenarios::read(source!("safety/projection"))?;
    let mut cases = without_horizon();
    cases.extend(text.cases("path", row_case)?);
    cases.extend(without_horizon_further());
    cases.extend(text.cases("velocity", row_case)?);
    cases.extend(with_horizon());
    cases.extend(text.rest(row_case)?);
    cases.extend(steps_without_velocity());
    cases.extend(clamped_horizons());
    cases.extend(other_units());
    let about = "The look ahead of the geofence: commands with and without a horizon, up to exactly the fence.";
    Ok(File::new("safety", "projection", about, cases))
}

const FENCE: f64 = 5.0;

fn one(path: String, rules: &[&'static str], limits: Limits, command: Command, at: &[f64]) -> Case {
    case(
        path,
        rules,
        &Trace::new(
            limits,
            vec![govern(command, Sensor::at(at)), govern(Command::moving(&[0.0; 3]), Sensor::at(&[0.0; 3]))],
        ),
    )
}

/// Tick 0 for the whole ttl. Along x, y, z, toward the fence and away from it, and across.
fn without_horizon() -> Vec<Case> {
    let mut cases = Vec::new();
    let axes: [(&str, usize); 3] = [("x", 0), ("y", 1), ("z", 2)];
    // A way of 2 m from 3 m out: exactly to the fence.
    for (ttl, speed) in
        [(250.0, 8.0), (500.0, 4.0), (1000.0, 2.0), (125.0, 16.0), (2000.0, 1.0), (60_000.0, 1.0 / 30.0)]
    {
        for (axis, at) in axes {
            for sign in [1.0, -1.0] {
                for (name, factor, rule) in
                    [("to-the-fence", 1.0, "NCP-SAFE-021"), ("beyond", 1.0 + 1.0 / 1024.0, "NCP-SAFE-051")]
                {
                    // 60 s at 1/30 m/s is no sum of doubles: half the way and twice the way.
                    let factor = if ttl > 10_000.0 { if factor > 1.0 { 2.0 } else { 0.5 } } else { factor };
                    if ttl > 10_000.0 && at > 0 || sign < 0.0 && ttl > 500.0 {
                        continue;
                    }
                    let mut place = [0.0; 3];
                    let mut v = [0.0; 3];
                    place[at] = 3.0 * sign;
                    v[at] = speed * factor * sign;
                    let side = if sign > 0.0 { "plus" } else { "minus" };
                    cases.push(
                        one(
                            format!("ttl-{ttl}/{axis}-{side}/{name}"),
                            &[rule, "NCP-SAFE-054"],
                            Limits::fence(FENCE),
                            Command::moving(&v).ttl(ttl),
                            &place,
                        )
                        .title(format!(
                            "From 3 m out, {} m/s along {axis} for {ttl} ms within a fence of 5 m is \
                                            judged by its end.",
                            v[at]
                        ))
                        .flags(&["short-look-ahead", "off-by-a-boundary"])
                        .because(
                            "Without a horizon the plant follows tick 0 for the whole ttl; an end exactly \
                                      on the fence is inside.",
                        ),
                    );
                }
            }
        }
    }
    cases
}

/// Ttls beyond a minute, ticks of no horizon, and velocities that are clamped.
fn without_horizon_further() -> Vec<Case> {
    let mut cases = Vec::new();
    // Beyond a minute a ttl is a minute, for the look ahead too.
    for (ttl, speed, rule, ends) in [
        (120_000.0, 0.0625, "NCP-SAFE-021", "passes"),
        (1e308, 0.0625, "NCP-SAFE-021", "passes"),
        (120_000.0, 0.125, "NCP-SAFE-051", "is held"),
        (60_000.0, 0.125, "NCP-SAFE-051", "is held"),
        (30_000.0, 0.125, "NCP-SAFE-021", "passes"),
        (30_000.0, 0.25, "NCP-SAFE-051", "is held"),
    ] {
        cases.push(
            one(
                format!("enforced/{}-ms/{speed}", name_of(ttl)),
                &[rule, "NCP-SAFE-053", "NCP-SAFE-054"],
                Limits::fence(FENCE),
                Command::moving(&[speed, 0.0, 0.0]).ttl(ttl),
                &[0.0; 3],
            )
            .title(format!("{speed} m/s with a ttl of {ttl} ms is projected for at most 60 s: the command {ends}."))
            .flags(&["L02"])
            .because("T is the enforced ttl, min(ttl_ms, 60 s)."),
        );
    }
    // A length of ticks without ticks says nothing.
    let lengths = |folder: &str, lengths: &[f64], speed: f64, rule: &'static str, what: &str| {
        let of = |dt: &f64| {
            one(
                format!("no-ticks/{folder}dt-{}", name_of(*dt)),
                &[rule, "NCP-SAFE-054"],
                Limits::fence(FENCE),
                Command::moving(&[speed, 0.0, 0.0]).then(*dt, &[]),
                &[4.0, 0.0, 0.0],
            )
            .title(format!("From 4 m out {what} whose horizon_dt_ms is {dt}."))
            .because("Without a horizon the plant follows tick 0 for the whole ttl, and no tick has a length.")
        };
        lengths.iter().map(of).collect::<Vec<_>>()
    };
    let passes = "inward, a command without a horizon passes";
    cases.extend(lengths("", &[-500.0, 0.0, 125.0, 10_000.0], -4.0, "NCP-SAFE-021", passes));
    let held = "outward, a command without a horizon is held";
    let outward = lengths("outward/", &[-500.0, 12.5, 50.0, 62.5, 10_000.0], 8.0, "NCP-SAFE-051", held);
    cases.extend(outward.into_iter().map(|case| case.flags(&["short-look-ahead"])));
    // The velocity is clamped before it is projected.
    for (speed, rule, ends) in [(4.0, "NCP-SAFE-021", "passes"), (16.0, "NCP-SAFE-051", "is held")] {
        let rules: &[&'static str] =
            if rule == "NCP-SAFE-021" { &["NCP-SAFE-060", "NCP-SAFE-054"] } else { &["NCP-SAFE-051", "NCP-SAFE-054"] };
        cases.push(
            one(
                format!("clamped/{speed}"),
                rules,
                Limits::both(speed, FENCE),
                Command::moving(&[80.0, 0.0, 0.0]),
                &[3.0, 0.0, 0.0],
            )
            .title(format!("80 m/s under a limit of {speed} m/s is projected with {speed} m/s: the command {ends}."))
            .because("The look ahead takes the clamped velocities."),
        );
    }
    cases
}

/// Horizons deep inside, to the fence and beyond.
fn with_horizon() -> Vec<Case> {
    let mut cases = Vec::new();
    // From the origin with a tick of 250 ms: each step of 4 m/s is 1 m.
    for steps in 1..=8_usize {
        for ttl in [250.0_f64, 1000.0, 5000.0] {
            let ticks = vec![[4.0, 0.0, 0.0]; steps];
            let command = Command::moving(&[4.0, 0.0, 0.0]).then(250.0, &ticks).ttl(ttl);
            #[expect(clippy::cast_precision_loss, reason = "at most 8 steps")]
            let way = ((steps + 1) as f64).min(ttl / 250.0);
            let rule = if way > 5.0 { "NCP-SAFE-050" } else { "NCP-SAFE-054" };
            cases.push(
                one(format!("ahead/{steps}-steps/ttl-{ttl}"), &[rule], Limits::fence(FENCE), command, &[0.0; 3])
                    .title(format!(
                        "From the origin, {} ticks of 1 m each under a ttl of {ttl} ms end inside 5 m.",
                        steps + 1
                    ))
                    .flags(&["short-look-ahead", "horizon-past-the-fence"])
                    .because(
                        "The horizon is truncated before the first step at whose end, by the part of its tick \
                              that lies before the ttl, \
                              the plant is outside; a governor may drop more if tick 0 stays \
                              inside for the whole ttl.",
                    ),
            );
        }
    }
    // With a speed limit that bounds every horizon well inside, nothing has to be shortened.
    for steps in 1..=6_usize {
        for at in [[0.0, 0.0, 0.0], [1.0, 2.0, 2.0], [-3.0, 0.0, 0.0]] {
            let ticks = vec![[0.5, 0.5, 0.0]; steps];
            let command = Command::moving(&[0.5, 0.5, 0.0]).then(62.5, &ticks).ttl(500.0);
            cases.push(
                one(
                    format!("inside/{steps}-steps/from-{}-{}-{}", at[0], at[1], at[2]).replace("--", "-minus-"),
                    &["NCP-SAFE-021"],
                    Limits::both(1.0, FENCE),
                    command,
                    &at,
                )
                .title(format!(
                    "A horizon of {steps} steps that cannot reach the fence, from ({}, {}, {}), \
                                    passes whole.",
                    at[0], at[1], at[2]
                ))
                .flags(&["over-strict"])
                .because(
                    "Even at the speed limit for all of its ticks the plant stays inside, so that no \
                              reading truncates it.",
                ),
            );
        }
    }
    cases
}

/// Steps of a horizon from which nothing can be projected, without a speed limit.
fn steps_without_velocity() -> Vec<Case> {
    let slow = [0.25, 0.0, 0.0];
    let table = [
        ("absent", "has no velocity", vec![channel("gripper", &[1.0], None)]),
        ("no-channels", "has no channels", Vec::new()),
        ("empty", "has an empty velocity", vec![velocity(&[])]),
        ("two-wide", "has a velocity 2 wide", vec![velocity(&[0.25, 0.0])]),
        ("four-wide", "has a velocity 4 wide", vec![velocity(&[0.25, 0.0, 0.0, 0.0])]),
        ("knots", "has a velocity in knots", vec![channel(VELOCITY, &slow, Some("kn"))]),
        ("kilometres-an-hour", "has a velocity in km/h", vec![channel(VELOCITY, &slow, Some("km/h"))]),
        ("another-name", "has a velocity under another name", vec![channel("velocity", &slow, Some(MPS))]),
    ];
    let mut cases = Vec::new();
    for (name, words, step) in table {
        // One place each shows it.
        let places = match name {
            "empty" => 0..1,
            "two-wide" => 1..2,
            "four-wide" => 2..3,
            "absent" => 0..2,
            "no-channels" | "another-name" => 2..3,
            _ => 1..2,
        };
        for place in places {
            let mut command = Command::moving(&slow).then(50.0, &[slow, slow, slow]);
            if let Some(at) = command.horizon.get_mut(place) {
                at.clone_from(&step);
            }
            cases.push(
                one(
                    format!("step/{name}-at-{}", place + 1),
                    &["NCP-SAFE-055", "NCP-SAFE-054"],
                    Limits::fence(FENCE),
                    command,
                    &[1.0, 2.0, 2.0],
                )
                .title(format!("Within a fence, a horizon whose step {} {words} goes no further than that.", place + 1))
                .flags(&["horizon-past-the-fence", "L11", "L10"])
                .because(
                    "With the geofence enabled, a step that has no usable velocity is not sent: the \
                              horizon is truncated before it, or the command held.",
                ),
            );
        }
    }
    cases
}

/// Horizons whose velocities are clamped before they are projected.
fn clamped_horizons() -> Vec<Case> {
    let fast = [80.0, 0.0, 0.0];
    let still = [0.0; 3];
    let back = [-80.0, 0.0, 0.0];
    let table: [(&str, &str, [f64; 3], [f64; 3]); 3] = [
        ("tick-0", "tick 0 is too fast", fast, still),
        ("step", "step 1 is too fast", still, fast),
        ("both", "tick 0 is too fast and step 1 goes back", fast, back),
    ];
    let one = |(name, words, tick, step): (&str, &str, [f64; 3], [f64; 3])| {
        let command = Command::moving(&tick).then(250.0, &[step]).ttl(500.0);
        one(
            format!("clamped-horizon/{name}"),
            &["NCP-SAFE-021", "NCP-SAFE-060", "NCP-SAFE-066"],
            Limits::both(4.0, FENCE),
            command,
            &[2.5, 0.0, 0.0],
        )
        .title(format!("A horizon of which {words} is projected with the 4 m/s that are sent, and is not held."))
        .flags(&["over-strict"])
        .because(
            "The look ahead takes the clamped velocities: at 4 m/s the plant does not leave the fence \
                      before the ttl ends.",
        )
    };
    table.into_iter().map(one).collect()
}

/// Velocities without a unit that were negotiated in another than m/s, without a speed limit.
fn other_units() -> Vec<Case> {
    let mut cases = Vec::new();
    for unit in ["km/h", "kn"] {
        let capabilities = || {
            let mut capabilities = Capabilities::canonical(&[]);
            capabilities.commands = vec![vec3(VELOCITY, Some(unit))];
            capabilities
        };
        let bare = || vec![channel(VELOCITY, &[0.25, 0.0, 0.0], None)];
        let still = || Command::of(vec![channel(VELOCITY, &[0.0; 3], None)]);
        let name = unit.replace('/', "-per-");
        let commands = [("slow", Command::of(bare())), ("still", still())];
        for (what, command) in commands.into_iter().take(if unit == "kn" { 1 } else { 2 }) {
            let steps = vec![govern(command, Sensor::at(&[1.0, 2.0, 2.0]))];
            cases.push(
                case(
                    format!("negotiated-unit/{name}/{what}"),
                    &["NCP-SAFE-042", "NCP-SAFE-052"],
                    &Trace::negotiated(Limits::fence(FENCE), capabilities(), steps),
                )
                .title(format!("A velocity without a unit that was negotiated in {unit} is not read as m/s ({what})."))
                .flags(&["L10"])
                .because(
                    "The governor reads a channel without a unit in the negotiated one, and one in another \
                          unit than m/s cannot be projected.",
                ),
            );
        }
        let mut command = Command::moving(&[0.25, 0.0, 0.0]).then(50.0, &[[0.0; 3]]);
        command.horizon = vec![bare(), bare()];
        let steps = vec![govern(command, Sensor::at(&[1.0, 2.0, 2.0]))];
        cases.push(
            case(
                format!("negotiated-unit/{name}/step"),
                &["NCP-SAFE-042", "NCP-SAFE-055"],
                &Trace::negotiated(Limits::fence(FENCE), capabilities(), steps),
            )
            .title(format!("A step whose velocity has no unit and was negotiated in {unit} is not read as m/s."))
            .flags(&["L10"])
            .because(
                "The governor reads a channel without a unit in the negotiated one, and a step in another unit \
                      than m/s is not sent.",
            ),
        );
    }
    cases
}
