//! The reflex controller.

use super::{DEFAULT, Gains, law, sensor, velocity};
use crate::case::{Case, File, Role};
use crate::json::{Json, object};
use crate::trace::{any, int, name_of, num, nums};

pub(super) fn file() -> File {
    let mut cases = laws();
    cases.extend(far_from_the_origin());
    cases.extend(finer_than_24_bits());
    cases.extend(small_errors());
    cases.extend(beyond_the_doubles());
    cases.extend(defaults());
    cases.extend(stamps());
    cases.extend(unusable());
    cases.extend(configs());
    let about = "The reflex controller: its law, its clamp, its defaults, and what it does without a position.";
    File::new("control", "reflex", about, cases)
}

fn case(path: String, rules: &[&'static str], config: Json, sensor: Json) -> Case {
    Case::new(path, rules, &[Role::Commander]).call("reflex.step", object! { "config" => config, "sensor" => sensor })
}

/// A case of the law, for a body that is here and moves so.
fn of_law(path: String, gains: Gains, position: [f64; 3], moving: [f64; 3]) -> Case {
    case(path, &["NCP-CTRL-001"], gains.json(), sensor(1, 0.0, &position, Some(&moving)))
}

fn commands(data: &[f64]) -> Json {
    object! { "command" => object! { "mode" => "active", "channels" => velocity(data) } }
}

fn holds() -> Json {
    object! { "command" => object! { "mode" => "hold", "channels" => velocity(&[0.0; 3]),
    "horizon" => Json::Array(Vec::new()) } }
}

/// A command without damping, or a HOLD.
fn damps_nothing(data: &[f64]) -> Json {
    any(vec![commands(data), holds()])
}

/// The law, at a few places and with a few gains.
fn laws() -> Vec<Case> {
    let mut cases = Vec::new();
    let places: [(&str, [f64; 3], [f64; 3]); 13] = [
        ("at-target", [0.0; 3], [0.0; 3]),
        ("x", [0.5, 0.0, 0.0], [0.0; 3]),
        ("y", [0.0, -0.5, 0.0], [0.0; 3]),
        ("z", [0.0, 0.0, 0.25], [0.0; 3]),
        ("all", [0.5, -1.0, 1.25], [0.0; 3]),
        ("moving", [0.0; 3], [1.0, -1.0, 0.5]),
        ("both", [0.5, 0.5, -0.5], [0.5, -0.5, 1.0]),
        ("far", [100.0, -100.0, 0.5], [0.0; 3]),
        ("at-the-clamp", [1.5, -1.5, 0.0], [0.0; 3]),
        ("fast", [0.0; 3], [100.0, 0.0, -100.0]),
        ("huge", [1e308, -1e308, 0.0], [0.0; 3]),
        ("huge-together", [1e308, 1.5e308, 0.25], [0.0; 3]),
        ("subnormal", [5e-324, -5e-324, -0.0], [5e-324, -0.0, 0.0]),
    ];
    let gains: [(&str, Gains); 5] = [
        ("defaults", DEFAULT),
        ("target", Gains { target: [1.0, 2.0, -1.0], ..DEFAULT }),
        ("stiff", Gains { kp: 4.0, kd: 0.125, max_speed: 10.0, ..DEFAULT }),
        ("damped", Gains { kp: 0.25, kd: 2.0, max_speed: 0.5, target: [-0.5, 0.0, 0.5] }),
        ("no-gain", Gains { kp: 0.0, kd: 0.0, ..DEFAULT }),
    ];
    for (place, position, moving) in places {
        for (name, gains) in gains {
            let u = law(gains, position, moving);
            let case = case(
                format!("law/{place}/{name}"),
                &["NCP-CTRL-001"],
                gains.json(),
                sensor(1, 0.0, &position, Some(&moving)),
            );
            // A gain of 0 may be refused.
            let case = if name == "no-gain" { case.shows_or_refuses(commands(&u)) } else { case.shows(commands(&u)) };
            cases.push(
                case.title(format!(
                    "The reflex controller ({name}) answers a body that is {}.",
                    place.replace('-', " ")
                ))
                .because(
                    "The command is u = \u{2212}kp\u{b7}(p \u{2212} target) \u{2212} kd\u{b7}v on each \
                              axis, each clamped to \u{b1}max_speed.",
                ),
            );
        }
    }
    cases
}

/// Bodies and targets far away: what is left of a difference is lost in the products of its ends.
fn far_from_the_origin() -> Vec<Case> {
    let mut cases = Vec::new();
    for (name, kp, far) in
        [("tenth", 0.1, 1e15), ("third", 1.0 / 3.0, -1e12), ("seven-tenths", 0.7, 3e14), ("three", 3.0, 1e308)]
    {
        let gains = Gains { kp, target: [far, -far, 0.5 * far], ..DEFAULT };
        let position = [far + 1.0, 1.0 - far, 0.5 * far - 1.0];
        cases.push(
            case(
                format!("law/far-from-the-origin/{name}"),
                &["NCP-CTRL-001"],
                gains.json(),
                sensor(1, 0.0, &position, Some(&[0.0; 3])),
            )
            .shows(commands(&law(gains, position, [0.0; 3])))
            .title(format!("A body {:e} m from the origin is led by its distance from the target.", far.abs()))
            .because("The command is \u{2212}kp\u{b7}(p \u{2212} target): the difference comes first."),
        );
    }
    cases
}

/// Numbers that 24 bits do not hold, each by itself, and all at once.
fn finer_than_24_bits() -> Vec<Case> {
    let mut cases = Vec::new();
    let still = [0.0; 3];
    let even = Gains { kp: 1.0, kd: 1.0, max_speed: 100.0, target: still };
    for (name, gains, position, moving) in [
        ("max-speed/0.7", Gains { max_speed: 0.7, ..even }, [5.0, -5.0, 5.0], still),
        ("max-speed/0.1", Gains { max_speed: 0.1, ..even }, [5.0, 5.0, -5.0], still),
        ("max-speed/1e-50", Gains { max_speed: 1e-50, ..even }, [-5.0, 5.0, 5.0], still),
        ("max-speed/1e300", Gains { max_speed: 1e300, ..even }, [1e301, -1e301, 1e301], still),
        ("kp/0.7", Gains { kp: 0.7, ..even }, [0.5, -0.25, 1.0], still),
        ("kd/0.1", Gains { kd: 0.1, ..even }, still, [0.5, -0.25, 1.0]),
        ("target", Gains { target: [-0.1, 0.2, -0.3], ..even }, [0.5, -0.25, 1.0], still),
        ("target/1e300", Gains { target: [1e300, -1e300, 0.5], max_speed: 1e301, ..even }, still, still),
        ("position", even, [0.1, -0.7, 1.3], still),
        ("velocity", even, still, [0.1, -0.7, 1.3]),
        ("all", Gains { kp: 0.7, kd: 0.1, max_speed: 0.9, target: [0.1, 0.2, 0.3] }, [0.6, 0.1, 3.3], [0.3, -0.6, 0.7]),
    ] {
        let expected = commands(&law(gains, position, moving));
        let case = of_law(format!("law/finer-than-24-bits/{name}"), gains, position, moving);
        // A clamp rounds nothing.
        let is_clamped = name.starts_with("max-speed");
        let case = if is_clamped { case.shows_exactly(expected) } else { case.shows(expected) };
        cases.push(
            case.title(format!("The reflex controller computes with doubles ({}).", name.replace(['-', '/'], " ")))
                .because("It is right to one part in 10^9 before it is clamped, and the clamp is exactly max_speed."),
        );
    }
    cases
}

/// Errors as small as a dead band may be, under a gain that shows them.
fn small_errors() -> Vec<Case> {
    let mut cases = Vec::new();
    let still = [0.0; 3];
    for (name, kp, kd, position, moving) in [
        ("position", 1e9, 0.0, [1e-6, -1e-7, 1e-9], still),
        ("position-further", 1e30, 0.0, [1e-20, -1e-28, 1e-30], still),
        ("velocity", 0.0, 1e9, still, [1e-6, -1e-7, 1e-9]),
        ("both", 1e12, 1e12, [1e-9, 0.0, -1e-12], [0.0, -1e-10, 1e-9]),
    ] {
        let gains = Gains { kp, kd, max_speed: 1e6, target: still };
        let expected = commands(&law(gains, position, moving));
        let case = of_law(format!("law/small/{name}"), gains, position, moving);
        // A gain of 0 may be refused.
        let case = if kp * kd == 0.0 { case.shows_or_refuses(expected) } else { case.shows(expected) };
        cases.push(
            case.title(format!(
                "The reflex controller answers the smallest of errors by its law ({}).",
                name.replace('-', " ")
            ))
            .because("The law has no dead band: it is a product, however small one factor is."),
        );
    }
    cases
}

/// One term of the law that leaves the doubles, and the other does not lead back.
fn beyond_the_doubles() -> Vec<Case> {
    let mut cases = Vec::new();
    let most = 1.7e308;
    for (name, kp, kd, position, moving, u) in [
        ("damping", 1.0, 1e10, [1.0, -1.0, 0.5], [1e300, -1e300, 0.0], [-most, most, -0.5]),
        ("pull", 1e10, 1.0, [1e300, -1e300, 0.0], [1.0, -1.0, 0.5], [-most, most, -0.5]),
        ("pull-of-one", 10.0, 1.0, [0.5, 1e308, 0.0], [0.0; 3], [-5.0, -most, 0.0]),
    ] {
        let gains = Gains { kp, kd, max_speed: most, target: [0.0; 3] };
        cases.push(
            of_law(format!("law/beyond-the-doubles/{name}"), gains, position, moving)
                .shows(object! {
                    "command" => object! { "seq" => int(1), "mode" => "active", "channels" => velocity(&u) },
                })
                .by("/command/seq", "NCP-PLANE-006")
                .title(format!(
                    "The reflex controller answers by its law where one term of it leaves the doubles ({}).",
                    name.replace('-', " ")
                ))
                .because(
                    "The command is left open only where p − target or both terms leave the doubles, or the other \
                     leads back.",
                ),
        );
    }
    cases
}

/// What holds of a setting that is not given: where only it counts, and beside one that is given.
fn defaults() -> Vec<Case> {
    let mut cases = Vec::new();
    for (name, position, moving) in [
        ("kp", [0.5, -0.75, 1.25], [0.0; 3]),
        ("target", [0.0; 3], [0.0; 3]),
        ("kd", [0.0; 3], [1.0, -2.0, 0.5]),
        ("max-speed", [90.0, -90.0, 2.0], [0.0; 3]),
    ] {
        cases.push(
            case(
                format!("default/{name}"),
                &["NCP-CTRL-002", "NCP-CTRL-001"],
                Json::object(),
                sensor(1, 0.0, &position, Some(&moving)),
            )
            .shows(commands(&law(DEFAULT, position, moving)))
            .title(format!("When nothing is given, {name} has its default."))
            .because("The defaults are kp 1, kd 0.3, max_speed 1.5 m/s."),
        );
    }
    // One given, the others by default.
    for (name, given, gains) in [
        ("target", object! { "target" => nums(&[1.0, 0.0, 0.0]) }, Gains { target: [1.0, 0.0, 0.0], ..DEFAULT }),
        ("kp", object! { "kp" => num(0.5) }, Gains { kp: 0.5, ..DEFAULT }),
        ("kd", object! { "kd" => num(1.0) }, Gains { kd: 1.0, ..DEFAULT }),
        ("max-speed", object! { "max_speed" => num(0.25) }, Gains { max_speed: 0.25, ..DEFAULT }),
    ] {
        cases.push(
            case(
                format!("default/beside-{name}"),
                &["NCP-CTRL-002", "NCP-CTRL-001"],
                given,
                sensor(1, 0.0, &[0.75, 0.5, -0.5], Some(&[0.5, -0.25, 0.125])),
            )
            .shows(commands(&law(gains, [0.75, 0.5, -0.5], [0.5, -0.25, 0.125])))
            .title(format!("With only {name} given, the rest has its default."))
            .because("The defaults are kp 1, kd 0.3, max_speed 1.5 m/s."),
        );
    }
    cases
}

/// An active command has the stamp of the frame that it is made of, whatever that is.
fn stamps() -> Vec<Case> {
    let one = |seq: i64| {
        let made = object! { "command" => object! { "mode" => "active", "seq" => int(seq) } };
        case(
            format!("stamp/{seq}").replace('-', "minus-"),
            &["NCP-PLANE-006", "NCP-CTRL-001"],
            Json::object(),
            sensor(seq, 0.0, &[0.75, 0.5, -0.5], Some(&[0.0; 3])),
        )
        .shows(made)
        .title(format!("A command that is made of a frame of seq {seq} has that seq."))
        .because("The command's seq is that of the sensor frame from which it was computed.")
    };
    [-9_007_199_254_740_991, -7, -1, 0, 1, 9_007_199_254_740_991].map(one).into()
}

fn unusable() -> Vec<Case> {
    let with = |name: &str, data: &[f64]| {
        object! { "seq" => 1_u32, "t" => num(0.0),
        "channels" => object! { name => object! { "data" => nums(data), "unit" => "m" } } }
    };
    let table: [(&str, &str, Json); 9] = [
        ("no-frame", "no sensor frame", Json::Null),
        ("no-channels", "a frame without channels", object! { "seq" => 1_u32, "channels" => Json::object() }),
        ("other-channel", "another channel only", with("imu_accel", &[1.0, 1.0, 1.0])),
        ("other-name", "a position under another name", with("position", &[1.0, 1.0, 1.0])),
        ("empty", "an empty position", with("pose_position", &[])),
        ("one-wide", "a position 1 wide", with("pose_position", &[1.0])),
        ("two-wide", "a position 2 wide", with("pose_position", &[1.0, 1.0])),
        ("four-wide", "a position 4 wide", with("pose_position", &[1.0, 1.0, 1.0, 1.0])),
        ("velocity-only", "a velocity only", with("pose_velocity", &[1.0, 1.0, 1.0])),
    ];
    let mut cases: Vec<Case> = table
        .into_iter()
        .map(|(name, words, sensor)| {
            case(format!("unusable/{name}"), &["NCP-CTRL-003"], Json::object(), sensor)
                .shows(holds())
                .title(format!("With {words}, the reflex controller commands a HOLD."))
                .flags(&["L03"])
                .because(
                    "Without a sensor frame, or without a usable position, it commands a HOLD with three zeros \
                          in `m/s`.",
                )
        })
        .collect();
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for at in 0..3 {
            let mut data = [0.5, 0.25, -0.5];
            if let Some(x) = data.get_mut(at) {
                *x = value;
            }
            cases.push(
                case(
                    format!("position/{at}/{}", name_of(value)),
                    &["NCP-CTRL-003"],
                    Json::object(),
                    sensor(1, 0.0, &data, Some(&[0.0; 3])),
                )
                .shows_or_refuses(holds())
                .title(format!(
                    "With a position whose component {at} is {}, the reflex controller commands a HOLD.",
                    name_of(value)
                ))
                .because("A position that is not finite is not usable."),
            );
            cases.push(
                case(
                    format!("velocity/{at}/{}", name_of(value)),
                    &["NCP-CTRL-004"],
                    Json::object(),
                    sensor(1, 0.0, &[0.5, 0.25, -0.5], Some(&data)),
                )
                .shows_or_refuses(damps_nothing(&[-0.5, -0.25, 0.5]))
                .title(format!(
                    "With a velocity whose component {at} is {}, the reflex controller damps nothing, or holds.",
                    name_of(value)
                ))
                .because("With a `pose_velocity` that is not usable it damps nothing or commands a HOLD."),
            );
        }
    }
    for (name, position) in [
        ("at-target", [0.0; 3]),
        ("x", [0.5, 0.0, 0.0]),
        ("y", [0.0, -0.5, 0.0]),
        ("all", [0.5, -1.0, 1.25]),
        ("far", [100.0, -100.0, 0.5]),
    ] {
        cases.push(
            case(format!("velocity/absent/{name}"), &["NCP-CTRL-004"], Json::object(), sensor(1, 0.0, &position, None))
                .shows(damps_nothing(&law(DEFAULT, position, [0.0; 3])))
                .title(format!("Without a velocity, the reflex controller damps nothing, or holds ({name})."))
                .because("Without a `pose_velocity` it damps nothing or commands a HOLD."),
        );
    }
    for (name, data) in [("empty", &[][..]), ("two-wide", &[5.0, 5.0]), ("four-wide", &[5.0, 5.0, 5.0, 5.0])] {
        cases.push(
            case(
                format!("velocity/{name}"),
                &["NCP-CTRL-004"],
                Json::object(),
                sensor(1, 0.0, &[0.5, 0.25, -0.5], Some(data)),
            )
            .shows(damps_nothing(&[-0.5, -0.25, 0.5]))
            .title(format!(
                "With a velocity that is {}, the reflex controller damps nothing, or holds.",
                name.replace('-', " ")
            ))
            .flags(&["L11"])
            .because("With a `pose_velocity` that is not usable it damps nothing or commands a HOLD."),
        );
    }
    cases
}

fn configs() -> Vec<Case> {
    let mut cases = Vec::new();
    let ask = || sensor(1, 0.0, &[0.5, 0.0, 0.0], Some(&[0.0; 3]));
    let strange = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    for name in ["kp", "kd", "max_speed"] {
        for value in strange.into_iter().chain([-1.0, -0.25, -1e308]) {
            cases.push(
                case(
                    format!("refused/{}/{}", name.replace('_', "-"), name_of(value)),
                    &["NCP-CTRL-005"],
                    object! { name => num(value) },
                    ask(),
                )
                .rejects("value")
                .title(format!("A reflex controller with a {name} of {} is refused.", name_of(value)))
                .because(
                    "A gain or a max_speed that is not finite or is negative is refused when the controller is built.",
                ),
            );
        }
    }
    for at in 0..3 {
        for value in strange {
            let mut target = [0.0; 3];
            if let Some(x) = target.get_mut(at) {
                *x = value;
            }
            cases.push(
                case(
                    format!("refused/target-{at}/{}", name_of(value)),
                    &["NCP-CTRL-005"],
                    object! { "target" => nums(&target) },
                    ask(),
                )
                .rejects("value")
                .title(format!(
                    "A reflex controller whose target has a component {at} of {} is refused.",
                    name_of(value)
                ))
                .because("A target that is not finite is refused when the controller is built."),
            );
        }
    }
    for (name, value) in [("kp", 5e-324), ("kd", 5e-324), ("max_speed", 1e308), ("kp", -0.0), ("kd", -0.0)] {
        let gains = match name {
            "kp" => Gains { kp: value, ..DEFAULT },
            "kd" => Gains { kd: value, ..DEFAULT },
            _ => Gains { max_speed: value, ..DEFAULT },
        };
        let case =
            case(format!("odd/{}/{}", name.replace('_', "-"), name_of(value)), &["NCP-CTRL-001"], gains.json(), ask())
                .title(format!("A reflex controller with a {name} of {value} is one."))
                .because("It is finite and not negative.");
        let expected = commands(&law(gains, [0.5, 0.0, 0.0], [0.0; 3]));
        cases.push(if value == 0.0 { case.shows_or_refuses(expected) } else { case.shows(expected) });
    }
    cases
}
