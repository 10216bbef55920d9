//! Limits and the negotiated channels.

use super::model::Command;
use super::model::{
    Capabilities, Limits, M, MPS, POSITION, Sensor, Spec, Step, Trace, VELOCITY, channel, govern, scalar, vec3,
    velocity,
};
use super::{case, good, near};
use crate::case::{Case, File};
use crate::json::object;
use crate::trace::{anything, steps};

pub(super) fn file() -> File {
    let mut cases = order();
    cases.extend(undeclared());
    cases.extend(units());
    cases.extend(values());
    cases.extend(widths());
    cases.extend(resets());
    let about = "How limits bind to the negotiated channels: by name, in their unit, and closed when they cannot.";
    File::new("safety", "binding", about, cases)
}

/// A command, and another.
fn twice() -> Vec<Step> {
    vec![govern(good(), near()), govern(good().seq(8), near())]
}

const DECOYS: [(&str, Spec, Spec); 4] = [
    ("imu-and-gripper", vec3("imu_accel", Some("m/s2")), scalar("gripper", None)),
    ("metres-and-speeds", vec3("goal_position", Some(M)), vec3("tow_velocity", Some(MPS))),
    ("scalars", scalar("battery", Some("V")), scalar("light", Some("lm"))),
    ("alike", vec3("pose_position_raw", Some(M)), vec3("velocity_setpoint_raw", Some(MPS))),
];

/// Other channels before, after and around the canonical ones.
fn order() -> Vec<Case> {
    let mut cases = Vec::new();
    for (name, sensor, command) in DECOYS {
        for place in ["before", "after", "around"] {
            let arrange = |decoy: Spec, own: Spec| match place {
                "before" => vec![decoy, own],
                "after" => vec![own, decoy],
                _ => vec![decoy, own, scalar("zz", None)],
            };
            let capabilities = Capabilities {
                sensors: arrange(sensor, vec3(POSITION, Some(M))),
                commands: arrange(command, vec3(VELOCITY, Some(MPS))),
            };
            let decoy = channel(sensor.name, &[0.0; 3], sensor.unit);
            let sensed = |at: &[f64]| Sensor::of(vec![decoy.clone(), channel(POSITION, at, Some(M))]);
            let fast =
                Command::of(vec![channel(command.name, &[0.25, 0.0, 0.0], command.unit), velocity(&[30.0, 40.0, 0.0])]);
            for (what, rule, limits, step) in [
                ("speed", "NCP-SAFE-011", Limits::speed(2.0), govern(fast.clone(), sensed(&[0.0; 3]))),
                ("fence-inside", "NCP-SAFE-010", Limits::fence(5.0), govern(good(), sensed(&[1.0, 2.0, 2.0]))),
                ("fence-outside", "NCP-SAFE-010", Limits::fence(5.0), govern(good(), sensed(&[9.0, 0.0, 0.0]))),
            ] {
                cases.push(
                    case(format!("by-name/{name}/{place}/{what}"), &[rule], &Trace::negotiated(limits, capabilities.clone(), vec![step]))
                        .title(format!("With other channels ({name}) {place} the canonical ones, the limit acts on the right one ({what})."))
                        .flags(&["first-channel"])
                        .because("Limits bind to the canonical channels by name, whatever other channels come first."),
                );
            }
        }
    }
    cases
}

/// Limits whose channel is not there.
fn undeclared() -> Vec<Case> {
    let mut cases = Vec::new();
    let fence = Limits::fence(5.0);
    let speed = Limits::speed(2.0);
    let both = Limits::both(2.0, 5.0);
    let nothing = || Capabilities { sensors: Vec::new(), commands: Vec::new() };
    let only_sensor = || Capabilities { sensors: vec![vec3(POSITION, Some(M))], commands: Vec::new() };
    let only_command = || Capabilities { sensors: Vec::new(), commands: vec![vec3(VELOCITY, Some(MPS))] };
    let swapped = || Capabilities { sensors: vec![vec3(VELOCITY, Some(MPS))], commands: vec![vec3(POSITION, Some(M))] };
    let renamed =
        || Capabilities { sensors: vec![vec3("position", Some(M))], commands: vec![vec3("velocity", Some(MPS))] };
    let cased = || Capabilities {
        sensors: vec![vec3("POSE_POSITION", Some(M))],
        commands: vec![vec3("VELOCITY_SETPOINT", Some(MPS))],
    };
    let table: [(&str, Limits, Capabilities); 14] = [
        ("nothing/fence", fence, nothing()),
        ("nothing/speed", speed, nothing()),
        ("nothing/both", both, nothing()),
        ("only-sensor/speed", speed, only_sensor()),
        ("only-sensor/both", both, only_sensor()),
        ("only-command/fence", fence, only_command()),
        ("only-command/both", both, only_command()),
        ("swapped/fence", fence, swapped()),
        ("swapped/speed", speed, swapped()),
        ("renamed/fence", fence, renamed()),
        ("renamed/speed", speed, renamed()),
        ("renamed/both", both, renamed()),
        ("cased/fence", fence, cased()),
        ("cased/speed", speed, cased()),
    ];
    for (name, limits, capabilities) in table {
        cases.push(
            case(format!("undeclared/{name}"), &["NCP-SAFE-014", "NCP-SAFE-018"], &Trace::negotiated(limits, capabilities, twice()))
                .title(format!("A limit whose channel is not declared ({}) holds every command.", name.replace('/', ", ")))
                .flags(&["first-channel"])
                .because("An enabled limit whose channel the Capabilities do not declare puts the governor into config fail-closed."),
        );
    }
    // A disabled limit needs no channel.
    for (name, limits, capabilities) in [
        ("none", Limits::NONE, nothing()),
        ("zeros", Limits::both(0.0, 0.0), nothing()),
        (
            "fence-only",
            fence,
            Capabilities { sensors: vec![vec3(POSITION, Some(M))], commands: vec![vec3(VELOCITY, Some(MPS))] },
        ),
        ("speed-only", speed, only_command()),
    ] {
        cases.push(
            case(format!("not-needed/{name}"), &["NCP-SAFE-012"], &Trace::negotiated(limits, capabilities, twice()))
                .title(format!("A limit that is disabled needs no declared channel ({name})."))
                .flags(&["over-strict"])
                .because("A limit that is absent or 0 is disabled, and only an enabled one can be a fault."),
        );
    }
    cases
}

/// Declared units.
fn units() -> Vec<Case> {
    let mut cases = Vec::new();
    for unit in [
        None,
        Some(""),
        Some("ft"),
        Some("km"),
        Some("mm"),
        Some("M"),
        Some("metre"),
        Some("deg"),
        Some("m/s"),
        Some(" m"),
    ] {
        let capabilities =
            Capabilities { sensors: vec![vec3(POSITION, unit)], commands: vec![vec3(VELOCITY, Some(MPS))] };
        let name = unit_name(unit);
        cases.push(
            case(format!("unit/position/{name}"), &["NCP-SAFE-015", "NCP-SAFE-018"], &Trace::negotiated(Limits::fence(5.0), capabilities, twice()))
                .title(format!("A fence on a position declared with the unit {name} holds every command."))
                .flags(&["L10"])
                .because("An enabled limit whose channel is declared without a unit, or in another than the table's, puts the governor into config fail-closed."),
        );
    }
    for unit in [
        None,
        Some(""),
        Some("kn"),
        Some("km/h"),
        Some("mps"),
        Some("M/S"),
        Some("m"),
        Some("m/s2"),
        Some("m s-1"),
        Some("m/s "),
    ] {
        let capabilities =
            Capabilities { sensors: vec![vec3(POSITION, Some(M))], commands: vec![vec3(VELOCITY, unit)] };
        let name = unit_name(unit);
        cases.push(
            case(format!("unit/velocity/{name}"), &["NCP-SAFE-015", "NCP-SAFE-018"], &Trace::negotiated(Limits::speed(2.0), capabilities, twice()))
                .title(format!("A speed limit on a velocity declared with the unit {name} holds every command."))
                .flags(&["L10"])
                .because("An enabled limit whose channel is declared without a unit, or in another than the table's, puts the governor into config fail-closed."),
        );
    }
    cases
}

fn unit_name(unit: Option<&str>) -> String {
    match unit {
        None => "absent".to_owned(),
        Some("") => "empty".to_owned(),
        Some("M") => "capital-m".to_owned(),
        Some("M/S") => "capital-m-per-s".to_owned(),
        Some(" m") => "space-m".to_owned(),
        Some("m/s ") => "m-per-s-space".to_owned(),
        Some(unit) => unit.replace('/', "-per-").replace(' ', "-"),
    }
}

/// Limits that are no limits.
fn values() -> Vec<Case> {
    let mut cases = Vec::new();
    let bad = [-1.0, -5e-324, -1e308, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    for value in bad {
        let name = crate::trace::name_of(value);
        for (which, limits) in [
            ("speed", Limits::speed(value)),
            ("fence", Limits::fence(value)),
            ("speed-beside-a-fence", Limits::both(value, 5.0)),
            ("fence-beside-a-speed", Limits::both(2.0, value)),
        ] {
            let flag = if value.is_finite() { "L15" } else { "L13" };
            cases.push(
                case(format!("value/{which}/{name}"), &["NCP-SAFE-013", "NCP-SAFE-018"], &Trace::new(limits, twice()))
                    .title(format!("A limit of {name} ({}) holds every command.", which.replace('-', " ")))
                    .flags(&[flag])
                    .because("A limit that is negative or not finite puts the governor into config fail-closed."),
            );
        }
    }
    for value in [5e-324, 1e-300, 1e-9, 1e308] {
        let name = crate::trace::name_of(value);
        let command = Command::moving(&[0.0, 0.0, 0.0]);
        cases.push(
            case(
                format!("value/fence/{name}"),
                &["NCP-SAFE-045"],
                &Trace::new(Limits::fence(value), vec![govern(command.clone(), Sensor::at(&[0.0; 3]))]),
            )
            .title(format!("A fence of {name} m contains its centre."))
            .because("The limit is finite and positive, so it is enabled, and 0 is not more than it."),
        );
        cases.push(
            case(
                format!("value/speed/{name}"),
                &["NCP-SAFE-062"],
                &Trace::new(Limits::speed(value), vec![govern(command, near())]),
            )
            .title(format!("A speed limit of {name} m/s lets a plant stand still."))
            .because("The limit is finite and positive, so it is enabled, and 0 is not above it."),
        );
    }
    for value in [5e-324, 1e-300] {
        let name = crate::trace::name_of(value);
        let slow = object! { "frame" => object! { "channels" => object! { VELOCITY => object! { "data" => crate::trace::nums(&[0.0; 3]) } } } };
        cases.push(
            case(
                format!("value/speed-bounds/{name}"),
                &["NCP-SAFE-060"],
                &Trace::new(Limits::speed(value), vec![govern(Command::moving(&[3.0, 4.0, 0.0]), near())]),
            )
            .shows(steps(vec![slow]))
            .title(format!("A speed limit of {name} m/s leaves next to nothing of 5 m/s."))
            .because("The velocity is scaled so that its norm is not above the limit."),
        );
        cases.push(
            case(
                format!("value/fence-bounds/{name}"),
                &["NCP-SAFE-043"],
                &Trace::new(
                    Limits::fence(value),
                    vec![
                        govern(Command::moving(&[0.0; 3]), Sensor::at(&[0.0, 1.0, 0.0])),
                        govern(Command::moving(&[0.0; 3]), Sensor::at(&[0.0; 3])),
                    ],
                ),
            )
            .title(format!("A fence of {name} m has everything but its centre outside."))
            .because("ESTOP is latched when the norm of the position is more than the radius."),
        );
    }
    cases
}

/// Every kind of fault, over resets.
fn resets() -> Vec<Case> {
    let negotiated = |position: Option<Spec>, velocity: Option<Spec>| Capabilities {
        sensors: position.into_iter().collect(),
        commands: velocity.into_iter().collect(),
    };
    let (position, velocity) = (vec3(POSITION, Some(M)), vec3(VELOCITY, Some(MPS)));
    let (speed, fence) = (Limits::speed(2.0), Limits::fence(5.0));
    let table: [(&str, &str, Limits, Option<Capabilities>); 10] = [
        ("negative-speed", "a negative speed limit", Limits::speed(-1.0), None),
        ("negative-fence", "a negative radius", Limits::fence(-1.0), None),
        ("nan-speed", "a speed limit of NaN", Limits::speed(f64::NAN), None),
        ("nan-fence", "a radius of NaN", Limits::fence(f64::NAN), None),
        ("infinite-speed", "an infinite speed limit", Limits::speed(f64::INFINITY), None),
        ("infinite-fence", "an infinite radius", Limits::fence(f64::INFINITY), None),
        ("no-velocity", "an undeclared velocity", speed, Some(negotiated(Some(position), None))),
        ("no-position", "an undeclared position", fence, Some(negotiated(None, Some(velocity)))),
        (
            "knots",
            "a velocity declared in knots",
            speed,
            Some(negotiated(Some(position), Some(vec3(VELOCITY, Some("kn"))))),
        ),
        (
            "feet",
            "a position declared in feet",
            fence,
            Some(negotiated(Some(vec3(POSITION, Some("ft"))), Some(velocity))),
        ),
    ];
    let one = |(name, words, limits, capabilities): (&str, &str, Limits, Option<Capabilities>)| {
        let steps = vec![
            govern(good(), near()),
            Step::Reset,
            govern(good().seq(8), near()),
            Step::Reset,
            Step::Reset,
            govern(good().seq(9), near()),
        ];
        let trace = Trace { limits, capabilities, steps };
        case(format!("reset/{name}"), &["NCP-SAFE-009", "NCP-SAFE-018"], &trace)
            .title(format!("A reset does not end the config fail-closed for {words}."))
            .because("The governor's reset does not clear a config fail-closed.")
    };
    table.into_iter().map(one).collect()
}

/// Declared widths, which the text only advises about.
fn widths() -> Vec<Case> {
    let wide = |name, kind, unit, size| Spec { name, kind, unit: Some(unit), size };
    let mut cases = Vec::new();
    for (kind, size) in [("scalar", None), ("quat", None), ("array", Some(2)), ("array", Some(4)), ("array", Some(0))] {
        let name = size.map_or(kind.to_owned(), |size: i64| format!("{kind}-{size}"));
        let position =
            Capabilities { sensors: vec![wide(POSITION, kind, M, size)], commands: vec![vec3(VELOCITY, Some(MPS))] };
        let velocity =
            Capabilities { sensors: vec![vec3(POSITION, Some(M))], commands: vec![wide(VELOCITY, kind, MPS, size)] };
        for (which, limits, capabilities) in
            [("position", Limits::fence(5.0), position), ("velocity", Limits::speed(2.0), velocity)]
        {
            let trace = Trace::negotiated(limits, capabilities, vec![govern(good(), near())]);
            let hold = object! { "frame" => object! { "mode" => "hold", "channels" => anything() } };
            cases.push(
                case(format!("width/{which}/{name}"), &["NCP-SAFE-016"], &trace)
                    .shows(steps(vec![hold]))
                    .title(format!("A limit on a {which} declared as {name} should hold every command."))
                    .flags(&["L11"])
                    .because("An enabled limit whose channel is declared with another width than 3 should put the governor into config fail-closed."),
            );
        }
    }
    for (kind, name) in [("array", "array-3"), ("vec3", "vec3-of-3")] {
        let capabilities = Capabilities {
            sensors: vec![wide(POSITION, kind, M, Some(3))],
            commands: vec![wide(VELOCITY, kind, MPS, Some(3))],
        };
        let trace = Trace::negotiated(Limits::both(2.0, 5.0), capabilities, vec![govern(good(), near())]);
        cases.push(
            case(format!("width/both/{name}"), &["NCP-SAFE-021"], &trace)
                .title(format!("Limits on channels declared as {kind} of size 3 let a command pass that keeps them."))
                .flags(&["over-strict"])
                .because("Both channels are declared in the table's unit and 3 wide, so that the limits act, and no gate closes."),
        );
    }
    cases
}
