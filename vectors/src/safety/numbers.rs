//! Strange numbers in every numeric position of a command and a sensor frame.

use super::model::{Limits, Sensor, Trace, govern};
use super::{case, good, near};
use crate::case::{Case, File};
use crate::command::{Command, M, MPS, POSITION, VELOCITY, channel, velocity};
use crate::json::{Json, object};
use crate::trace::{any, name_of, refused, steps};

pub(super) fn file() -> File {
    let mut cases = commands();
    cases.extend(positions());
    cases.extend(beside());
    let about = "NaN, infinities, negative zero, subnormal and huge numbers in every numeric position of a command \
                 and a sensor frame.";
    File::new("safety", "numbers", about, cases)
}

const STRANGE: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
const ODD: [f64; 3] = [-0.0, 5e-324, -5e-324];

/// The vector with that component.
fn put(at: usize, value: f64) -> [f64; 3] {
    let mut data = [0.5, 0.25, 0.125];
    if let Some(component) = data.get_mut(at) {
        *component = value;
    }
    data
}

/// Components of the command's channels.
fn commands() -> Vec<Case> {
    let mut cases = Vec::new();
    let limits = [
        ("no-limit", Limits::NONE),
        // The good command is at it, so that scaling what needs none does not fail these cases.
        ("speed-limit", Limits::speed(1.0)),
        ("fence", Limits::fence(5.0)),
    ];
    for (with, limits) in limits {
        for value in STRANGE {
            for at in 0..3 {
                let steps = vec![govern(Command::moving(&put(at, value)), near()), govern(good().seq(8), near())];
                cases.push(
                    case(
                        format!("velocity/{at}/{}/{with}", name_of(value)),
                        &["NCP-SAFE-064"],
                        &Trace::new(limits, steps),
                    )
                    .title(format!(
                        "A velocity whose component {at} is {} is held, with {}.",
                        name_of(value),
                        with.replace('-', " ")
                    ))
                    .flags(&["non-finite-command"])
                    .because("The governor holds when any channel of tick 0 has a component that is not finite."),
                );
            }
            for (name, unit) in [("gripper", None), ("body_rates", Some("rad/s")), ("tow_velocity", Some(MPS))] {
                let command = Command::moving(&[0.5, 0.0, 0.0]).and(channel(name, &[0.5, value], unit));
                cases.push(
                    case(
                        format!("{}/{}/{with}", name.replace('_', "-"), name_of(value)),
                        &["NCP-SAFE-064"],
                        &Trace::new(limits, vec![govern(command, near()), govern(good().seq(8), near())]),
                    )
                    .title(format!(
                        "A command whose channel {name} holds {} is held, with {}.",
                        name_of(value),
                        with.replace('-', " ")
                    ))
                    .flags(&["non-finite-command"])
                    .because(
                        "The governor holds when any channel of tick 0 has a component that is not finite, \
                                  not only the velocity.",
                    ),
                );
            }
        }
        for value in ODD {
            for at in 0..3 {
                cases.push(
                    case(
                        format!("velocity/{at}/{}/{with}", name_of(value)),
                        &["NCP-SAFE-021"],
                        &Trace::new(limits, vec![govern(Command::moving(&put(at, value)), near())]),
                    )
                    .title(format!(
                        "A velocity whose component {at} is {} passes, with {}.",
                        name_of(value),
                        with.replace('-', " ")
                    ))
                    .flags(&["over-strict"])
                    .because("A negative zero and a subnormal number are finite; nothing closes on them."),
                );
            }
        }
        let command = Command::moving(&[0.5, 0.0, 0.0]).and(channel("thrust", &[1e308, -1e308, f64::MAX], Some("N")));
        cases.push(
            case(format!("other/huge/{with}"), &["NCP-SAFE-021"], &Trace::new(limits, vec![govern(command, near())]))
                .title(format!(
                    "A channel in another unit with huge finite numbers passes, with {}.",
                    with.replace('-', " ")
                ))
                .flags(&["over-strict"])
                .because("1e308 is finite, and no limit acts on that channel."),
        );
    }
    // Huge velocities against the fence.
    for value in [1e308, -1e308, f64::MAX, 1e200] {
        for at in 0..3 {
            let steps = vec![govern(Command::moving(&put(at, value)), near()), govern(good().seq(8), near())];
            cases.push(
                case(
                    format!("velocity/{at}/{}/fence", name_of(value)),
                    &["NCP-SAFE-051"],
                    &Trace::new(Limits::fence(5.0), steps),
                )
                .title(format!("A velocity whose component {at} is {value} leads out of the fence and is held."))
                .flags(&["overflowing-norm"])
                .because("The end of tick 0 lies outside the fence, or cannot be computed; nothing latches."),
            );
        }
    }
    cases
}

/// Components of the measured position.
fn positions() -> Vec<Case> {
    let mut cases = Vec::new();
    let still = || Command::moving(&[0.0; 3]);
    for at in 0..3 {
        for value in STRANGE {
            let steps = vec![govern(still(), Sensor::at(&put(at, value))), govern(still().seq(8), near())];
            cases.push(
                case(
                    format!("position/{at}/{}", name_of(value)),
                    &["NCP-SAFE-044", "NCP-SAFE-005"],
                    &Trace::new(Limits::fence(5.0), steps),
                )
                .title(format!("A position whose component {at} is {} latches ESTOP.", name_of(value)))
                .flags(&["non-finite-position"])
                .because("The governor latches ESTOP when a component of the position is not finite."),
            );
        }
        for value in [1e308, -1e308, f64::MAX, 1e200, -1e160] {
            let steps = vec![govern(still(), Sensor::at(&put(at, value))), govern(still().seq(8), near())];
            cases.push(
                case(
                    format!("position/{at}/{}", name_of(value)),
                    &["NCP-SAFE-043", "NCP-SAFE-044", "NCP-SAFE-005"],
                    &Trace::new(Limits::fence(5.0), steps),
                )
                .title(format!("A position whose component {at} is {value} latches ESTOP."))
                .flags(&["overflowing-norm"])
                .because("Its norm is more than the radius, or overflows: both latch."),
            );
        }
        for value in ODD {
            cases.push(
                case(
                    format!("position/{at}/{}", name_of(value)),
                    &["NCP-SAFE-045"],
                    &Trace::new(Limits::fence(5.0), vec![govern(still(), Sensor::at(&put(at, value)))]),
                )
                .title(format!("A position whose component {at} is {} is inside.", name_of(value)))
                .flags(&["over-strict"])
                .because("The norm is not more than the radius."),
            );
        }
    }
    // Without a fence the position does not matter.
    for value in [1e308, -1e308, 5e-324] {
        cases.push(
            case(
                format!("position/no-fence/{}", name_of(value)),
                &["NCP-SAFE-012"],
                &Trace::new(Limits::NONE, vec![govern(good(), Sensor::at(&put(0, value)))]),
            )
            .title(format!("Without a fence, a position of {value} closes nothing."))
            .flags(&["over-strict"])
            .because("A limit that is absent is disabled."),
        );
    }
    // Only the position latches.
    let mut channels = vec![channel("imu_accel", &[1e308, -1e308, 0.0], Some("m/s2"))];
    channels.push(channel(POSITION, &[1.0, 2.0, 2.0], Some(M)));
    cases.push(
        case(
            "position/other-channel/huge",
            &["NCP-SAFE-010"],
            &Trace::new(Limits::fence(5.0), vec![govern(good(), Sensor::of(channels))]),
        )
        .title("Huge numbers in another sensor channel latch nothing.")
        .flags(&["first-channel"])
        .because("The geofence acts on `pose_position`."),
    );
    cases
}

/// `ttl_ms`, `t` and the clock.
fn beside() -> Vec<Case> {
    let mut cases = Vec::new();
    // A plant does nothing with such a ttl; a governor may pass it or hold.
    for ttl in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, -0.0, -1.0, 5e-324, 1e308] {
        for (with, limits) in [("no-limit", Limits::NONE), ("fence", Limits::fence(5.0))] {
            let command = Command::of(vec![velocity(&[0.0625, 0.0, 0.0])]).ttl(ttl);
            let trace = Trace::new(limits, vec![govern(command, Sensor::at(&[0.0; 3]))]);
            let frame = |mode: &str, x: f64| {
                object! { "frame" => object! { "mode" => mode,
                "seq" => crate::trace::int(7),
                    "channels" => object! { VELOCITY => object! { "data" => crate::trace::nums(&[x, 0.0, 0.0]) } } } }
            };
            let allowed: Vec<Json> = vec![frame("active", 0.0625), frame("hold", 0.0), refused()];
            let usable = ttl == 5e-324 || ttl == 1e308;
            let case = case(format!("ttl/{}/{with}", name_of(ttl)), &["NCP-SAFE-021"], &trace)
                .title(format!(
                    "A command with a ttl of {} is answered, with {}.",
                    name_of(ttl),
                    with.replace('-', " ")
                ))
                .flags(&["L12"]);
            cases.push(if usable {
                case.because("No gate closes on a ttl that is finite and positive, and the projection ends at 60 s.")
            } else {
                case.shows(steps(vec![any(allowed)])).because(
                    "No gate closes on such a ttl, and the plant does not act on it: what comes back is \
                              the command or a HOLD.",
                )
            });
        }
    }
    for t in [-0.0, 5e-324, 1e308, -1e308] {
        let mut command = good();
        command.t = t;
        cases.push(
            case(
                format!("t/{}", name_of(t)),
                &["NCP-SAFE-021"],
                &Trace::new(Limits::both(2.0, 5.0), vec![govern(command, near())]),
            )
            .title(format!("A command of the time {} passes.", name_of(t)))
            .flags(&["L25"])
            .because("`t` is the sender's and is compared with nothing."),
        );
    }
    for (name, now, last) in [("subnormal", 5e-324, 0.0), ("huge", 1e308, 1e308), ("minus-zero", 0.0, -0.0)] {
        let step = super::model::Step::Govern { command: good(), now, sensor: Some(near()), last: Some(last) };
        cases.push(
            case(format!("clock/{name}"), &["NCP-SAFE-034"], &Trace::new(Limits::NONE, vec![step]))
                .title(format!("A clock that reads {now} s, {} s after the sensor, is a clock.", now - last))
                .because("Both are finite, now is not less than last, and the age is not more than the timeout."),
        );
    }
    let step = super::model::Step::Govern { command: good(), now: 1e308, sensor: Some(near()), last: Some(0.0) };
    cases.push(
        case("clock/overflow", &["NCP-SAFE-033"], &Trace::new(Limits::NONE, vec![step]))
            .title("A sensor 1e308 s old is stale, though its age in milliseconds overflows.")
            .because("The age is more than the timeout."),
    );
    cases
}
