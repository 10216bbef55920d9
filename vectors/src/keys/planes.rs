//! The quality of service of the four planes.

use crate::case::Role::{self, Body, Commander, Server};
use crate::case::{Case, File};
use crate::json::object;

pub(super) fn file() -> File {
    let cases = PLANES.iter().map(|plane| {
        let Plane { name, congestion, priority, express, rule, roles } = plane;
        Case::new(*name, &[rule], roles)
            .title(format!(
                "The {name} plane has congestion control `{congestion}`, priority `{priority}` and is{} express.",
                if *express { "" } else { " not" }
            ))
            .flags(&["wrong-qos"])
            .call("plane.qos", object! { "plane" => *name })
            .gives(object! { "congestion" => *congestion, "priority" => *priority, "express" => *express })
            .because("The row of the plane in section 3.1.")
    });
    File::new("keys", "planes", "The quality of service of the four planes.", cases.collect())
}

struct Plane {
    name: &'static str,
    congestion: &'static str,
    priority: &'static str,
    express: bool,
    rule: &'static str,
    roles: &'static [Role],
}

const PLANES: [Plane; 4] = [
    Plane {
        name: "control",
        congestion: "block",
        priority: "Data",
        express: false,
        rule: "NCP-PLANE-001",
        roles: &[Commander, Server],
    },
    Plane {
        name: "perception",
        congestion: "drop",
        priority: "DataHigh",
        express: false,
        rule: "NCP-PLANE-002",
        roles: &[Commander, Body],
    },
    Plane {
        name: "action",
        congestion: "drop",
        priority: "RealTime",
        express: true,
        rule: "NCP-PLANE-003",
        roles: &[Commander, Body],
    },
    Plane {
        name: "observation",
        congestion: "block",
        priority: "Data",
        express: false,
        rule: "NCP-PLANE-004",
        roles: &[Server],
    },
];
