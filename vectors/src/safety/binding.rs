//! Limits and the negotiated channels.

use super::model::{Capabilities, Limits, Sensor, Spec, Step, Trace, govern, scalar, vec3};
use super::{case, good, near, row_case};
use crate::case::{Case, File};
use crate::command::{Command, M, MPS, POSITION, VELOCITY, channel, velocity};
use crate::json::object;
use crate::names::{self, LONG_NAMES};
use crate::scenario::{ScenarioError, Scenarios, full_width, source};
use crate::trace::{anything, steps};

pub(super) fn file() -> Result<File, ScenarioError> {
    let mut text = Scenarios::read(source!("safety/binding"))?;
    let mut cases = order();
    for group in ["undeclared", "not-needed", "unit/position", "unit/velocity"] {
        cases.extend(text.cases(group, row_case)?);
    }
    cases.extend(values());
    cases.extend(widths());
    cases.extend(text.rest(row_case)?);
    cases.extend(behind_many());
    cases.extend(likenesses());
    cases.extend([long_names(), of_all_names()]);
    let about = "How limits bind to the negotiated channels: by name, in their unit, and closed when they cannot.";
    Ok(File::new("safety", "binding", about, cases))
}

/// A command, and another.
fn twice() -> Vec<Step> {
    vec![govern(good(), near()), govern(good().seq(8), near())]
}

fn decoys() -> [(&'static str, Spec, Spec); 4] {
    [
        ("imu-and-gripper", vec3("imu_accel", Some("m/s2")), scalar("gripper", None)),
        ("metres-and-speeds", vec3("goal_position", Some(M)), vec3("tow_velocity", Some(MPS))),
        ("scalars", scalar("battery", Some("V")), scalar("light", Some("lm"))),
        ("alike", vec3("pose_position_raw", Some(M)), vec3("velocity_setpoint_raw", Some(MPS))),
    ]
}

/// Other channels before, after and around the canonical ones.
fn order() -> Vec<Case> {
    let mut cases = Vec::new();
    for (name, sensor, command) in decoys() {
        for place in ["before", "after", "around"] {
            let arrange = |decoy: Spec, own: Spec| match place {
                "before" => vec![decoy, own],
                "after" => vec![own, decoy],
                _ => vec![decoy, own, scalar("zz", None)],
            };
            let capabilities = Capabilities {
                sensors: arrange(sensor.clone(), vec3(POSITION, Some(M))),
                commands: arrange(command.clone(), vec3(VELOCITY, Some(MPS))),
            };
            let decoy = channel(&sensor.name, &[0.0; 3], sensor.unit.as_deref());
            let sensed = |at: &[f64]| Sensor::of(vec![decoy.clone(), channel(POSITION, at, Some(M))]);
            let fast = Command::of(vec![
                channel(&command.name, &[0.25, 0.0, 0.0], command.unit.as_deref()),
                velocity(&[30.0, 40.0, 0.0]),
            ]);
            for (what, rule, limits, step) in [
                ("speed", "NCP-SAFE-011", Limits::speed(2.0), govern(fast.clone(), sensed(&[0.0; 3]))),
                ("fence-inside", "NCP-SAFE-010", Limits::fence(5.0), govern(good(), sensed(&[1.0, 2.0, 2.0]))),
                ("fence-outside", "NCP-SAFE-010", Limits::fence(5.0), govern(good(), sensed(&[9.0, 0.0, 0.0]))),
            ] {
                cases.push(
                    case(
                        format!("by-name/{name}/{place}/{what}"),
                        &[rule],
                        &Trace::negotiated(limits, capabilities.clone(), vec![step]),
                    )
                    .title(format!(
                        "With other channels ({name}) {place} the canonical ones, the limit acts on \
                                        the right one ({what})."
                    ))
                    .flags(&["first-channel"])
                    .because("Limits bind to the canonical channels by name, whatever other channels come first."),
                );
            }
        }
    }
    cases
}

/// Two channels without a unit, of which one is in m/s and the other is not; their names differ in the last letter.
fn long_names() -> Case {
    let [one, other] = LONG_NAMES;
    let capabilities = Capabilities::canonical(&[vec3(one, Some("N")), vec3(other, Some(MPS))]);
    let command = Command::of(vec![
        velocity(&[1.0, 0.0, 0.0]),
        channel(one, &[0.0, 30.0, 40.0], None),
        channel(other, &[0.0, 3.0, 4.0], None),
    ]);
    let step = govern(command, Sensor::at(&[0.0; 3]));
    case(
        "beside/names-of-1024".to_owned(),
        &["NCP-SAFE-042", "NCP-SAFE-065"],
        &Trace::negotiated(Limits::speed(2.0), capabilities, vec![step]),
    )
    .title("Of two channels without a unit whose names agree in 1,023 characters, the one in m/s obeys the limit.")
    .flags(&["L10"])
    .because("A channel without a unit is read in the one that was negotiated for it, whatever its neighbours are in.")
}

/// Channels without a unit of all names that are alike: those that others are like are in N, all others in m/s.
fn of_all_names() -> Case {
    let specs: Vec<Spec> =
        names::alike().map(|(name, is_first)| vec3(name, Some(if is_first { "N" } else { MPS }))).collect();
    let channels = names::alike().map(|(name, _)| channel(name, &[0.0, 3.0, 4.0], None));
    let command = Command::of(std::iter::once(velocity(&[1.0, 0.0, 0.0])).chain(channels).collect());
    let step = govern(command, Sensor::at(&[0.0; 3]));
    case(
        "beside/names-alike".to_owned(),
        &["NCP-SAFE-042", "NCP-SAFE-065"],
        &Trace::negotiated(Limits::speed(2.0), Capabilities::canonical(&specs), vec![step]),
    )
    .title("Of channels without a unit whose names are alike, just those in m/s obey the limit.")
    .flags(&["L10"])
    .because("A channel without a unit is read in the one that was negotiated for it, by its name letter for letter.")
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
                    .by("/steps/1", "NCP-SAFE-018")
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
        let slow = object! { "frame" => object! { "channels" => object! { VELOCITY => object! { "data" =>
        crate::trace::nums(&[0.0; 3]) } } } };
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

/// Declared widths, which the text only advises about.
fn widths() -> Vec<Case> {
    let wide = |name, kind, unit, size| Spec { kind, size, ..vec3(name, Some(unit)) };
    let mut cases = Vec::new();
    for (kind, size) in [
        ("scalar", None),
        ("quat", None),
        ("array", Some(2)),
        ("array", Some(4)),
        ("array", Some(0)),
        // No width is another than 3, too.
        ("array", None),
        ("matrix", None),
        ("vec3", Some(2)),
        ("vec3", Some(4)),
        ("vec3", Some(0)),
        ("scalar", Some(3)),
        ("quat", Some(3)),
    ] {
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
                    .because(
                        "An enabled limit whose channel is declared with another width than 3 should put the \
                              governor into config fail-closed.",
                    ),
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
                .because(
                    "Both channels are declared in the table's unit and 3 wide, so that the limits act, and no \
                          gate closes.",
                ),
        );
    }
    cases
}

/// A limit's channel that is declared behind a thousand declarations.
fn behind_many() -> Vec<Case> {
    let behind = |spec: Spec, last: Spec| -> Vec<Spec> { std::iter::repeat_n(spec, 1_000).chain([last]).collect() };
    let grip = || scalar("gripper", None);
    let fast = || Command::moving(&[6.0, 8.0, 0.0]);
    let outside = || Sensor::at(&[6.0, 0.0, 0.0]);
    let commands = |last: Spec| Capabilities { commands: behind(grip(), last), ..Capabilities::canonical(&[]) };
    let sensors = |last: Spec| Capabilities { sensors: behind(grip(), last), ..Capabilities::canonical(&[]) };
    let own = vec3(VELOCITY, Some(MPS));
    let place = vec3(POSITION, Some(M));
    let one = |(name, rule, words, limits, capabilities, step): Row| {
        let trace = Trace::negotiated(limits, capabilities, vec![step]);
        case(format!("behind-1000/{name}"), &[rule], &trace)
            .title(format!("Behind a thousand declarations {words}."))
            .flags(&["first-channel"])
            .because("The limits act on their channels by name, whatever other channels come first.")
    };
    type Row = (&'static str, &'static str, &'static str, Limits, Capabilities, Step);
    let rows: [Row; 2] = [
        (
            "velocity",
            "NCP-SAFE-011",
            "the speed limit acts on the velocity",
            Limits::speed(5.0),
            commands(own),
            govern(fast(), near()),
        ),
        (
            "position",
            "NCP-SAFE-010",
            "the fence acts on the position",
            Limits::fence(5.0),
            sensors(place),
            govern(good(), outside()),
        ),
    ];
    rows.into_iter().map(one).collect()
}

/// Units and names that are the right ones to a reader who stops at a NUL or compares what they look like.
fn likenesses() -> Vec<Case> {
    let mut cases = Vec::new();
    let shapes: [(&str, &str, Shape); 4] = [
        ("nul-within", "with a NUL and more behind it", |text| format!("{text}\0{text}")),
        ("blanks-within", "with blanks around its stroke", |text| text.replace('/', " / ")),
        ("blank-before-its-stroke", "with a blank before its stroke", |text| text.replace('/', " /")),
        ("full-width", "in full-width letters", full_width),
    ];
    type Shape = fn(&str) -> String;
    for (name, words, shape) in shapes {
        let (m, mps) = (shape(M), shape(MPS));
        let (position, velocity) = (shape(POSITION), shape(VELOCITY));
        let moving = |name: &str, unit: &str| Command::of(vec![channel(name, &[1.0, 0.0, 0.0], Some(unit))]);
        let sensed = |name: &str, unit: &str| Sensor::of(vec![channel(name, &[0.0; 3], Some(unit))]);
        let other = good().and(channel("tow", &[30.0, 40.0, 0.0], Some(&mps)));
        let (fence, speed) = (Limits::fence(5.0), Limits::speed(5.0));
        let mut add = |what: &str, rule: &'static str, limits, capabilities, step: Step| {
            let trace = Trace { limits, capabilities, steps: vec![step] };
            cases.push(
                case(format!("likeness/{what}/{name}"), &[rule], &trace)
                    .title(format!("A {} {words} is another than it looks like.", what.replace('-', " ")))
                    .flags(&["L10"])
                    .because("Wire strings are compared by their letters, and one that has another is another."),
            );
        };
        if m != M {
            add("unit-of-a-position", "NCP-SAFE-041", fence, None, govern(good(), sensed(POSITION, &m)));
        }
        add("unit-of-another-channel", "NCP-SAFE-021", speed, None, govern(other, near()));
        if name == "full-width" {
            add("name-of-a-position", "NCP-SAFE-040", fence, None, govern(good(), sensed(&position, M)));
            add("name-of-a-velocity", "NCP-SAFE-063", speed, None, govern(moving(&velocity, MPS), near()));
            continue;
        }
        add("unit-of-a-velocity", "NCP-SAFE-063", speed, None, govern(moving(VELOCITY, &mps), near()));
        add("unit-of-a-projected-velocity", "NCP-SAFE-052", fence, None, govern(moving(VELOCITY, &mps), near()));
        let way = Capabilities { commands: vec![vec3(VELOCITY, Some(&mps))], ..Capabilities::canonical(&[]) };
        add("declared-unit-of-a-velocity", "NCP-SAFE-015", speed, Some(way), govern(good(), near()));
    }
    cases
}
