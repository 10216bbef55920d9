//! What HOLD and ESTOP frames hold.

use super::model::{
    Capabilities, Channel, Command, Limits, MPS, Sensor, Step, Trace, VELOCITY, channel, govern,
    scalar, vec3, velocity,
};
use super::{case, near};
use crate::case::{Case, File};
use crate::trace::name_of;

pub(super) fn file() -> File {
    let mut cases = Vec::new();
    for way in WAYS {
        cases.extend(channels(way));
        cases.extend(kept(way));
    }
    let about =
        "HOLD and ESTOP frames: what of the command is zeroed, what is kept and what is added.";
    File::new("safety", "zeroing", about, cases)
}

/// A way to a HOLD or an ESTOP frame.
struct Way {
    name: &'static str,
    frame: &'static str,
    rule: &'static str,
    step: fn(Command) -> Step,
}

const WAYS: &[Way] = &[
    Way {
        name: "hold-command",
        frame: "HOLD",
        rule: "NCP-SAFE-002",
        step: |command| govern(command.mode("hold"), near()),
    },
    Way {
        name: "init-command",
        frame: "HOLD",
        rule: "NCP-SAFE-002",
        step: |command| govern(command.mode("init"), near()),
    },
    Way {
        name: "stale",
        frame: "HOLD",
        rule: "NCP-SAFE-033",
        step: |command| Step::Govern {
            command,
            now: 20.0,
            sensor: Some(near()),
            last: Some(10.0),
        },
    },
    Way {
        name: "no-position",
        frame: "HOLD",
        rule: "NCP-SAFE-040",
        step: |command| govern(command, Sensor::of(Vec::new())),
    },
    Way {
        name: "estop-command",
        frame: "ESTOP",
        rule: "NCP-SAFE-003",
        step: |command| govern(command.mode("estop"), near()),
    },
    Way {
        name: "breach",
        frame: "ESTOP",
        rule: "NCP-SAFE-043",
        step: |command| govern(command, Sensor::at(&[9.0, 0.0, 0.0])),
    },
];

fn negotiated() -> Capabilities {
    Capabilities::canonical(&[
        scalar("gripper", None),
        vec3("body_rates", Some("rad/s")),
        scalar("light", Some("lm")),
    ])
}

/// The union of the command's channels and the negotiated ones.
fn channels(way: &Way) -> Vec<Case> {
    let table: [(&str, &'static str, &str, Vec<Channel>); 8] = [
        (
            "all",
            "NCP-SAFE-071",
            "all negotiated channels",
            vec![
                velocity(&[1.0, 2.0, 3.0]),
                channel("gripper", &[0.5], None),
                channel("body_rates", &[1.0, 1.0, 1.0], Some("rad/s")),
                channel("light", &[900.0], Some("lm")),
            ],
        ),
        (
            "some",
            "NCP-SAFE-073",
            "some of the negotiated channels",
            vec![velocity(&[1.0, 2.0, 3.0])],
        ),
        ("none", "NCP-SAFE-073", "no channels", Vec::new()),
        (
            "no-velocity",
            "NCP-SAFE-073",
            "no velocity",
            vec![channel("gripper", &[0.5], None)],
        ),
        (
            "others",
            "NCP-SAFE-071",
            "channels that were not negotiated",
            vec![
                channel("winch", &[4.0, 5.0], Some("N")),
                channel("flaps", &[1.0], None),
            ],
        ),
        (
            "widths",
            "NCP-SAFE-072",
            "channels of unusual widths",
            vec![
                velocity(&[1.0, 2.0]),
                channel("gripper", &[0.5, 0.5, 0.5, 0.5], None),
                channel("light", &[], Some("lm")),
            ],
        ),
        (
            "units",
            "NCP-SAFE-072",
            "channels in other units than the negotiated ones",
            vec![
                channel(VELOCITY, &[1.0, 2.0, 3.0], Some("kn")),
                channel("light", &[1.0], Some("cd")),
            ],
        ),
        (
            "negative",
            "NCP-SAFE-071",
            "negative and huge values",
            vec![
                velocity(&[-1.0, -1e308, 5e-324]),
                channel("gripper", &[-0.0], None),
            ],
        ),
    ];
    let mut cases = Vec::new();
    for (name, rule, words, channels) in table {
        let trace = Trace::negotiated(
            Limits::fence(5.0),
            negotiated(),
            vec![(way.step)(Command::of(channels))],
        );
        cases.push(
            case(format!("channels/{name}/{}", way.name), &[rule, way.rule], &trace)
                .title(format!("The {} frame ({}) of a command with {words} zeroes them and the negotiated ones.", way.frame, way.name))
                .flags(&["moving-hold"])
                .because("The union of the command's channels and the negotiated ones is zeroed; width and unit of the command's are kept, an absent velocity becomes three zeros in m/s, any other a single zero."),
        );
    }
    cases
}

/// What stands beside the channels.
fn kept(way: &Way) -> Vec<Case> {
    let mut cases = Vec::new();
    let base = || Command::of(vec![velocity(&[1.0, 2.0, 3.0])]);
    let mut add = |path: String, rule, title: String, command: Command| {
        let trace = Trace::new(Limits::fence(5.0), vec![(way.step)(command)]);
        cases.push(
            case(format!("kept/{path}/{}", way.name), &[rule, way.rule], &trace)
                .title(title)
                .because("A HOLD or ESTOP frame keeps `t`, `seq`, `frame_id` and `ttl_ms` of the command, and has no horizon."),
        );
    };
    for seq in [0, 1, -3, 9_007_199_254_740_991] {
        add(
            format!("seq/{seq}").replace("/-", "/minus-"),
            "NCP-SAFE-070",
            format!(
                "The {} frame ({}) keeps the seq {seq}.",
                way.frame, way.name
            ),
            base().seq(seq),
        );
    }
    for t in [0.0, -1.5, 1e9, 1e308, 5e-324] {
        let mut command = base();
        command.t = t;
        add(
            format!("t/{}", name_of(t)),
            "NCP-SAFE-070",
            format!(
                "The {} frame ({}) keeps the time {t} s.",
                way.frame, way.name
            ),
            command,
        );
    }
    for ttl in [1.0, 60_001.0, 1e308] {
        add(
            format!("ttl/{}", name_of(ttl)),
            "NCP-SAFE-070",
            format!(
                "The {} frame ({}) keeps the ttl of {ttl} ms.",
                way.frame, way.name
            ),
            base().ttl(ttl),
        );
    }
    for frame_id in ["body", "", "map/odom \u{e9}"] {
        let mut command = base();
        command.frame_id = frame_id;
        let name = match frame_id {
            "" => "empty",
            "body" => "body",
            _ => "unusual",
        };
        add(
            format!("frame-id/{name}"),
            "NCP-SAFE-070",
            format!(
                "The {} frame ({}) keeps a frame_id ({name}).",
                way.frame, way.name
            ),
            command,
        );
    }
    let horizon = base().then(100.0, &[[1.0, 0.0, 0.0], [2.0, 0.0, 0.0]]);
    add(
        "horizon".to_owned(),
        "NCP-SAFE-074",
        format!(
            "The {} frame ({}) of a command with a horizon has none.",
            way.frame, way.name
        ),
        horizon,
    );
    let mut other = base();
    other.horizon = vec![vec![channel("tow", &[1.0], Some(MPS))]];
    other.dt = Some(10.0);
    add(
        "horizon-of-other-channels".to_owned(),
        "NCP-SAFE-074",
        format!(
            "The {} frame ({}) drops a horizon of other channels.",
            way.frame, way.name
        ),
        other,
    );
    cases
}
