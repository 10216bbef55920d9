//! Where the measured position lies.

use super::model::{Capabilities, Channel, Command, Limits, M, POSITION, Sensor, Trace, channel, govern, velocity};
use super::{case, near};
use crate::case::{Case, File};
use crate::trace::name_of;

pub(super) fn file() -> File {
    let mut cases = places();
    cases.extend(channels());
    cases.extend(off());
    cases.extend(moved());
    let about = "The geofence and the measured position: inside, on and outside the ball, and positions that are none.";
    File::new("safety", "fence", about, cases)
}

/// A command that stays where it is.
fn still() -> Command {
    Command::moving(&[0.0, 0.0, 0.0])
}

/// Positions whose norm doubles hold exactly, in every octant and order.
fn places() -> Vec<Case> {
    let mut cases = Vec::new();
    let vectors: [([f64; 3], f64); 6] = [
        ([3.0, 4.0, 0.0], 5.0),
        ([0.0, 3.0, 4.0], 5.0),
        ([4.0, 0.0, 3.0], 5.0),
        ([2.0, 3.0, 6.0], 7.0),
        ([1.0, 4.0, 8.0], 9.0),
        ([0.0, 0.0, 1.0], 1.0),
    ];
    let signs: [[f64; 3]; 4] = [[1.0, 1.0, 1.0], [-1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, -1.0, -1.0]];
    for (vector, radius) in vectors {
        for (octant, sign) in signs.into_iter().enumerate() {
            let place = [vector[0] * sign[0], vector[1] * sign[1], vector[2] * sign[2]];
            for (name, scale, rule) in [
                ("on", 1.0, "NCP-SAFE-045"),
                ("inside", 1.0 - 1.0 / 1024.0, "NCP-SAFE-045"),
                ("outside", 1.0 + 1.0 / 1024.0, "NCP-SAFE-043"),
            ] {
                // Inside once a vector: what decides is the boundary.
                let repeats = vector[0] == 0.0 && octant % 2 == 1;
                if repeats || name == "inside" && octant > 0 || name == "outside" && octant % 2 == 1 {
                    continue;
                }
                let at = place.map(|x| if x == 0.0 { 0.0 } else { x * scale });
                let limits = Limits::fence(radius);
                let steps = vec![govern(still(), Sensor::at(&at)), govern(still(), Sensor::at(&[0.0; 3]))];
                cases.push(
                    case(format!("{name}/{}-{}-{}/octant-{octant}", vector[0], vector[1], vector[2]), &[rule], &Trace::new(limits, steps))
                        .title(format!("A position {name} the fence of {radius} m, at ({}, {}, {}), is told from the others.", at[0], at[1], at[2]))
                        .flags(if vector[2] == 0.0 { &["off-by-a-boundary"] } else { &["off-by-a-boundary", "L28"] })
                        .because("The fence is the closed ball about the origin: ESTOP is latched when the norm of all three components is more than the radius."),
                );
            }
        }
    }
    let shapes: [(&str, [f64; 3], &str); 6] = [
        ("above", [0.0, 0.0, 5.5], "a cylinder would contain it"),
        ("below", [0.0, 0.0, -5.5], "a cylinder or a floor at 0 would contain it"),
        ("corner", [4.0, 4.0, 4.0], "a box would contain it"),
        ("edge", [4.5, 0.0, 4.5], "a box or a cylinder would contain it"),
        ("low-corner", [-4.9, -4.9, -4.9], "a box would contain it, and so would a limit on the largest component"),
        ("far", [1e6, 0.0, 0.0], "nothing would contain it"),
    ];
    for (name, at, why) in shapes {
        cases.push(
            case(
                format!("shape/{name}"),
                &["NCP-SAFE-043"],
                &Trace::new(
                    Limits::fence(5.0),
                    // One step, so that an implementation without a memory is asked it, too.
                    vec![govern(still(), Sensor::at(&at))],
                ),
            )
            .title(format!("The fence is a sphere: ({}, {}, {}) is outside 5 m, though {why}.", at[0], at[1], at[2]))
            .flags(&["L28"])
            .because("It is a sphere, not a cylinder or a polygon."),
        );
    }
    for (name, at) in [
        ("diagonal", [2.8, 2.8, 2.8]),
        ("axis", [4.99, 0.0, 0.0]),
        ("origin", [0.0; 3]),
        ("negative", [-2.8, -2.8, 2.8]),
    ] {
        cases.push(
            case(
                format!("shape/inside-{name}"),
                &["NCP-SAFE-021", "NCP-SAFE-045"],
                &Trace::new(Limits::fence(5.0), vec![govern(still(), Sensor::at(&at))]),
            )
            .title(format!("The fence is a ball: ({}, {}, {}) is inside 5 m.", at[0], at[1], at[2]))
            .flags(&["L28"])
            .because("The norm is not more than the radius: a taxicab norm or the sum of components would be."),
        );
    }
    cases
}

/// Channels from which no position can be read.
fn channels() -> Vec<Case> {
    let position = |data: &[f64], unit| channel(POSITION, data, unit);
    let other = |data: &[f64]| channel("imu_accel", data, Some("m/s2"));
    #[expect(clippy::type_complexity, reason = "a table is read by its rows")]
    let table: [(&str, &'static str, &str, Vec<Channel>, &[&'static str]); 19] = [
        ("no-channels", "NCP-SAFE-040", "has no channels", Vec::new(), &["L03"]),
        ("another-channel", "NCP-SAFE-040", "has another channel only", vec![other(&[0.0; 3])], &["L03"]),
        (
            "another-name",
            "NCP-SAFE-040",
            "has its position under another name",
            vec![channel("position", &[0.0; 3], Some(M))],
            &["first-channel"],
        ),
        (
            "another-case",
            "NCP-SAFE-040",
            "has its position under a name in another case",
            vec![channel("Pose_Position", &[0.0; 3], Some(M))],
            &["first-channel"],
        ),
        ("empty", "NCP-SAFE-040", "has an empty position", vec![position(&[], Some(M))], &["L03"]),
        (
            "empty-without-unit",
            "NCP-SAFE-040",
            "has an empty position without a unit",
            vec![position(&[], None)],
            &["L03"],
        ),
        ("one-wide", "NCP-SAFE-040", "has a position 1 wide", vec![position(&[1.0], Some(M))], &["L11"]),
        ("two-wide", "NCP-SAFE-040", "has a position 2 wide", vec![position(&[1.0, 2.0], Some(M))], &["L11"]),
        (
            "four-wide",
            "NCP-SAFE-040",
            "has a position 4 wide",
            vec![position(&[1.0, 2.0, 2.0, 0.0], Some(M))],
            &["L11"],
        ),
        ("six-wide", "NCP-SAFE-040", "has a position 6 wide", vec![position(&[0.0; 6], Some(M))], &["L11"]),
        (
            "two-wide-outside",
            "NCP-SAFE-040",
            "has a position 2 wide and far away",
            vec![position(&[90.0, 90.0], Some(M))],
            &["L11"],
        ),
        (
            "four-wide-outside",
            "NCP-SAFE-040",
            "has a position 4 wide and far away",
            vec![position(&[90.0, 0.0, 0.0, 0.0], Some(M))],
            &["L11"],
        ),
        ("feet", "NCP-SAFE-041", "has a position in feet", vec![position(&[1.0, 0.0, 0.0], Some("ft"))], &["L10"]),
        (
            "kilometres",
            "NCP-SAFE-041",
            "has a position in kilometres",
            vec![position(&[1.0, 0.0, 0.0], Some("km"))],
            &["L10"],
        ),
        (
            "millimetres",
            "NCP-SAFE-041",
            "has a position in millimetres",
            vec![position(&[4000.0, 0.0, 0.0], Some("mm"))],
            &["L10"],
        ),
        (
            "degrees",
            "NCP-SAFE-041",
            "has a position in degrees",
            vec![position(&[1.0, 0.0, 0.0], Some("deg"))],
            &["L10"],
        ),
        (
            "metres-a-second",
            "NCP-SAFE-041",
            "has a position in m/s",
            vec![position(&[1.0, 0.0, 0.0], Some("m/s"))],
            &["L10"],
        ),
        (
            "empty-unit",
            "NCP-SAFE-041",
            "has a position whose unit is the empty text",
            vec![position(&[1.0, 0.0, 0.0], Some(""))],
            &["L10"],
        ),
        (
            "capital-unit",
            "NCP-SAFE-041",
            "has a position in `M`",
            vec![position(&[1.0, 0.0, 0.0], Some("M"))],
            &["L10"],
        ),
    ];
    let mut cases = Vec::new();
    for (name, rule, words, channels, flags) in table {
        let steps = vec![govern(still(), Sensor::of(channels)), govern(still(), near())];
        cases.push(
            case(format!("channel/{name}"), &[rule], &Trace::new(Limits::fence(5.0), steps))
                .title(format!("A command is held, and nothing latched, when the sensor frame {words}."))
                .flags(flags)
                .because("The governor holds when the position is missing, empty, not 3 wide or in another unit; what is no position is not the origin."),
        );
    }
    let no_frame = super::model::Step::Govern { command: still(), now: 10.25, sensor: None, last: Some(10.0) };
    cases.push(
        case(
            "channel/no-frame",
            &["NCP-SAFE-040"],
            &Trace::new(Limits::fence(5.0), vec![no_frame, govern(still(), near())]),
        )
        .title("A command is held when there is a sensor time and no sensor frame.")
        .flags(&["L03"])
        .because("The governor holds when the geofence is enabled and there is no position."),
    );
    // The position is found by its name, wherever it stands.
    for (name, before) in
        [("after-one", vec![other(&[0.0; 3])]), ("after-two", vec![channel("a", &[0.0; 3], Some(M)), other(&[9.0; 3])])]
    {
        for (place, at, rule) in
            [("inside", [1.0, 2.0, 2.0], "NCP-SAFE-010"), ("outside", [6.0, 0.0, 0.0], "NCP-SAFE-010")]
        {
            let mut channels = before.clone();
            channels.push(position(&at, Some(M)));
            cases.push(
                case(format!("channel/{name}/{place}"), &[rule], &Trace::new(Limits::fence(5.0), vec![govern(still(), Sensor::of(channels))]))
                    .title(format!("The fence reads `pose_position` {place} behind other channels."))
                    .flags(&["first-channel"])
                    .because("The geofence acts on the sensor channel named `pose_position`, whatever other channels come first."),
            );
        }
    }
    for (place, at, rule) in [("inside", [1.0, 2.0, 2.0], "NCP-SAFE-042"), ("outside", [6.0, 0.0, 0.0], "NCP-SAFE-042")]
    {
        let sensor = Sensor::of(vec![position(&at, None)]);
        let steps = vec![govern(still(), sensor)];
        cases.push(
            case(
                format!("channel/without-unit/{place}"),
                &[rule],
                &Trace::negotiated(Limits::fence(5.0), Capabilities::canonical(&[]), steps),
            )
            .title(format!("A position without a unit is read in the negotiated one, {place} the fence."))
            .flags(&["L10"])
            .because("The governor reads a channel without a unit in the negotiated one, here m."),
        );
    }
    cases
}

/// The centre is the origin, wherever the first position lay.
fn moved() -> Vec<Case> {
    let mut cases = Vec::new();
    for (axis, at) in [("x", 0), ("y", 1), ("z", 2)] {
        for (side, sign) in [("plus", 1.0), ("minus", -1.0)] {
            let place = |distance: f64| {
                let mut place = [0.0; 3];
                if let Some(component) = place.get_mut(at) {
                    *component = distance * sign;
                }
                place
            };
            for (name, first, second, rule) in [
                ("outside", 4.0, 6.0, "NCP-SAFE-043"),
                ("just-outside", 0.5, 5.25, "NCP-SAFE-043"),
                ("across", 4.0, -4.0, "NCP-SAFE-045"),
            ] {
                let steps =
                    vec![govern(still(), Sensor::at(&place(first))), govern(still(), Sensor::at(&place(second)))];
                cases.push(
                    case(
                        format!("moved/{axis}-{side}/{name}"),
                        &[rule],
                        &Trace::new(Limits::fence(5.0), steps),
                    )
                    .title(format!(
                        "From {first} m to {second} m along {axis} ({side}), the fence of 5 m stays about the origin."
                    ))
                    .flags(&["L28"])
                    .because("The fence is the ball about the origin of the reference frame, not about where the plant was first."),
                );
            }
        }
    }
    cases
}

/// Fences that are none.
fn off() -> Vec<Case> {
    let table: [(&str, Option<f64>); 2] = [("absent", None), ("zero", Some(0.0))];
    let mut cases = Vec::new();
    for (name, fence) in table {
        let limits = Limits { fence, ..Limits::NONE };
        for (what, sensor) in [
            ("far", Sensor::at(&[1e6, 0.0, 0.0])),
            ("no-position", Sensor::of(Vec::new())),
            ("two-wide", Sensor::at(&[1.0, 2.0])),
            ("feet", Sensor::of(vec![channel(POSITION, &[1.0; 3], Some("ft"))])),
        ] {
            let command = Command::of(vec![velocity(&[100.0, 0.0, 0.0])]);
            cases.push(
                case(
                    format!("off/{name}/{what}"),
                    &["NCP-SAFE-012"],
                    &Trace::new(limits, vec![govern(command, sensor)]),
                )
                .title(format!("A fence that is {name} closes on nothing ({what})."))
                .flags(&["L13"])
                .because("A limit that is absent or 0 is disabled."),
            );
        }
    }
    for tilt in [0.0, 0.5, 1.5, 1e308] {
        let limits = Limits { tilt: Some(tilt), ..Limits::both(2.0, 5.0) };
        cases.push(
            case(
                format!("tilt/{}", name_of(tilt)),
                &["NCP-SAFE-019"],
                &Trace::new(
                    limits,
                    vec![govern(
                        Command::moving(&[1.0, 0.0, 0.0]).and(channel("attitude", &[1.5, 0.0, 0.0], Some("rad"))),
                        near(),
                    )],
                ),
            )
            .title(format!("A `max_tilt_rad` of {tilt} changes nothing."))
            .because("`max_tilt_rad` is advice to the plant."),
        );
    }
    cases
}
