//! Where the measured position lies.

use super::model::{Limits, Sensor, Trace, govern};
use super::{case, row_case};
use crate::case::{Case, File};
use crate::command::Command;
use crate::scenario::{ScenarioError, Scenarios, source};
use crate::trace::name_of;

pub(super) fn file() -> Result<File, ScenarioError> {
    let mut cases = places();
    cases.extend(Scenarios::read(source!("safety/fence"))?.rest(row_case)?);
    cases.extend(moved());
    cases.extend(hairs());
    let about = "The geofence and the measured position: inside, on and outside the ball, and positions that are none.";
    Ok(File::new("safety", "fence", about, cases))
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
                    case(
                        format!("{name}/{}-{}-{}/octant-{octant}", vector[0], vector[1], vector[2]),
                        &[rule],
                        &Trace::new(limits, steps),
                    )
                    .title(format!(
                        "A position {name} the fence of {radius} m, at ({}, {}, {}), is told from \
                                        the others.",
                        at[0], at[1], at[2]
                    ))
                    .flags(if vector[2] == 0.0 { &["off-by-a-boundary"] } else { &["off-by-a-boundary", "L28"] })
                    .because(
                        "The fence is the closed ball about the origin: ESTOP is latched when the norm of \
                                  all three components is more than the radius.",
                    ),
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
                    .because("The fence is the ball about the origin of the reference frame, not about where the \
                              plant was first."),
                );
            }
        }
    }
    cases
}

/// Positions that are outside, or inside, by ever less of the radius.
fn hairs() -> Vec<Case> {
    let mut cases = Vec::new();
    for (radius, direction) in [(5.0, [0.6, 0.0, -0.8]), (1e-3, [0.0, 1.0, 0.0]), (1e5, [0.0, 0.6, 0.8])] {
        for power in [4, 6, 7, 9, 10, 11] {
            if radius != 5.0 && power != 7 && power != 11 {
                continue;
            }
            let hair = 10.0_f64.powi(-power);
            for (name, factor, rule) in
                [("outside", 1.0 + hair, "NCP-SAFE-043"), ("inside", 1.0 - hair, "NCP-SAFE-045")]
            {
                if name == "inside" && power < 9 {
                    continue;
                }
                let at = direction.map(|x| if x == 0.0 { 0.0 } else { x * radius * factor });
                let steps = vec![govern(still(), Sensor::at(&at))];
                cases.push(
                    case(
                        format!("hair/{}/{name}-by-1e-{power}", name_of(radius)),
                        &[rule],
                        &Trace::new(Limits::fence(radius), steps),
                    )
                    .title(format!(
                        "A position {name} the fence of {radius} m by 1e-{power} of it is told from the others."
                    ))
                    .flags(&["off-by-a-boundary"])
                    .because(
                        "ESTOP is latched when the norm of the position is more than the radius, by however little.",
                    ),
                );
            }
        }
    }
    cases
}
