//! What HOLD and ESTOP frames hold.
//!
//! A case looks at one thing only: at the zeros, at widths and units, at what is added, at one member that is
//! kept, or at the horizon. That the frame is a HOLD or an ESTOP is asked elsewhere.

use super::model::{
    Capabilities, Channel, Command, Limits, MPS, Sensor, Step, Trace, VELOCITY, channel, govern, scalar, vec3, velocity,
};
use super::near;
use crate::case::{Case, File, Role};
use crate::json::{Json, object};
use crate::trace::{any, anything, int, name_of, no_result, num, nums, refused, steps};

pub(super) fn file() -> File {
    let mut cases = Vec::new();
    for way in WAYS {
        cases.extend(channels(way));
        cases.extend(kept(way));
    }
    let about = "HOLD and ESTOP frames: what of the command is zeroed, what is kept and what is added.";
    File::new("safety", "zeroing", about, cases)
}

/// A way to a HOLD or an ESTOP frame.
struct Way {
    name: &'static str,
    frame: &'static str,
    limits: Limits,
    steps: fn(Command) -> Vec<Step>,
}

const FENCE: Limits = Limits::fence(5.0);

const WAYS: &[Way] = &[
    Way {
        name: "hold-command",
        frame: "HOLD",
        limits: FENCE,
        steps: |command| vec![govern(command.mode("hold"), near())],
    },
    Way {
        name: "init-command",
        frame: "HOLD",
        limits: FENCE,
        steps: |command| vec![govern(command.mode("init"), near())],
    },
    Way {
        name: "stale",
        frame: "HOLD",
        limits: FENCE,
        steps: |command| vec![Step::Govern { command, now: 20.0, sensor: Some(near()), last: Some(10.0) }],
    },
    Way {
        name: "no-position",
        frame: "HOLD",
        limits: FENCE,
        steps: |command| vec![govern(command, Sensor::of(Vec::new()))],
    },
    Way {
        name: "config-fault",
        frame: "HOLD",
        limits: Limits::speed(-1.0),
        steps: |command| vec![govern(command, near())],
    },
    Way {
        name: "not-finite",
        frame: "HOLD",
        limits: Limits::NONE,
        steps: |command| vec![govern(command.and(channel("z", &[f64::NAN], None)), near())],
    },
    Way {
        name: "bad-tick",
        frame: "HOLD",
        limits: Limits::NONE,
        steps: |command| {
            let mut command = if command.horizon.is_empty() { command.then(0.0, &[[0.0; 3]]) } else { command };
            command.dt = None;
            vec![govern(command, near())]
        },
    },
    Way {
        name: "leaves-fence",
        frame: "HOLD",
        limits: FENCE,
        steps: |command| vec![govern(command, Sensor::at(&[4.875, 0.0, 0.0]))],
    },
    Way {
        name: "estop-command",
        frame: "ESTOP",
        limits: FENCE,
        steps: |command| vec![govern(command.mode("estop"), near())],
    },
    Way {
        name: "breach",
        frame: "ESTOP",
        limits: FENCE,
        steps: |command| vec![govern(command, Sensor::at(&[9.0, 0.0, 0.0]))],
    },
    Way {
        name: "latched",
        frame: "ESTOP",
        limits: FENCE,
        steps: |command| {
            let mut before = Command::moving(&[9.0, 9.0, 9.0]).seq(2).ttl(777.0);
            before.t = 99.0;
            before.frame_id = "other";
            vec![govern(before.clone().mode("estop"), near()), govern(before.seq(3), near()), govern(command, near())]
        },
    },
];

/// A case that looks at this part of the last frame.
fn case(
    path: String,
    rule: &'static str,
    way: &Way,
    capabilities: Option<Capabilities>,
    command: Command,
    part: Json,
) -> Case {
    let trace = Trace { limits: way.limits, capabilities, steps: (way.steps)(command) };
    let is_writable = |step: &Step| match step {
        Step::Govern { command, .. } => command.is_writable(),
        _ => true,
    };
    let mut frames = vec![object! { "frame" => part }];
    if !trace.steps.iter().all(is_writable) {
        frames.push(refused());
    }
    let mut entries: Vec<Json> = trace.steps.iter().map(|_| no_result()).collect();
    if let Some(last) = entries.last_mut() {
        *last = any(frames);
    }
    Case::new(path, &[rule], &[Role::Commander]).call("governor.run", trace.args()).shows(steps(entries))
}

fn negotiated() -> Capabilities {
    Capabilities::canonical(&[scalar("gripper", None), vec3("body_rates", Some("rad/s")), scalar("light", Some("lm"))])
}

/// What a case of the channels looks at.
#[derive(Clone, Copy)]
enum Part {
    /// That the command's channels are zero. All of them are 3 wide.
    Zeros,
    /// Widths and units of the command's channels.
    Shape,
    /// The negotiated channels that the command lacks.
    Added,
}

impl Part {
    fn rule(self) -> &'static str {
        match self {
            Self::Zeros => "NCP-SAFE-071",
            Self::Shape => "NCP-SAFE-072",
            Self::Added => "NCP-SAFE-073",
        }
    }

    fn why(self) -> &'static str {
        match self {
            Self::Zeros => "The union of the command's channels and the negotiated ones is zeroed.",
            Self::Shape => "A zeroed channel of the command keeps its width and its unit.",
            Self::Added => {
                "A negotiated channel that the command lacks becomes three zeros in m/s if it is the velocity, and else a single zero."
            }
        }
    }

    fn pattern(self, channels: &[Channel]) -> Json {
        let of = |channel: &Channel| {
            let width = channel.data.len();
            let value = match self {
                Self::Zeros => object! { "data" => nums(&vec![0.0; width]) },
                _ => {
                    let data: Json = channel.data.iter().map(|_| anything()).collect();
                    object! { "data" => data, "unit" => channel.unit }
                }
            };
            (channel.name.to_owned(), value)
        };
        let added = || {
            let capabilities = negotiated();
            let lacks = |name: &str| channels.iter().all(|channel| channel.name != name);
            let specs = capabilities.commands.into_iter();
            specs
                .filter(|spec| lacks(spec.name))
                .map(|spec| {
                    let zero = if spec.name == VELOCITY {
                        object! { "data" => nums(&[0.0; 3]), "unit" => MPS }
                    } else {
                        object! { "data" => nums(&[0.0]) }
                    };
                    (spec.name.to_owned(), zero)
                })
                .collect()
        };
        let members: Vec<(String, Json)> = match self {
            Self::Added => added(),
            _ => channels.iter().map(of).collect(),
        };
        object! { "channels" => Json::Object(members) }
    }
}

/// The union of the command's channels and the negotiated ones.
fn channels(way: &Way) -> Vec<Case> {
    let table: [(&str, Part, &str, Vec<Channel>); 10] = [
        (
            "all",
            Part::Zeros,
            "all negotiated channels is zero in all of them",
            vec![
                velocity(&[1.0, 2.0, 3.0]),
                channel("gripper", &[0.5, 0.25, 0.5], None),
                channel("body_rates", &[1.0, 1.0, 1.0], Some("rad/s")),
                channel("light", &[900.0, 1.0, 2.0], Some("lm")),
            ],
        ),
        (
            "others",
            Part::Zeros,
            "channels that were not negotiated is zero in them too",
            vec![channel("winch", &[4.0, 5.0, 6.0], Some("N")), channel("flaps", &[1.0, 1.0, 1.0], None)],
        ),
        (
            "negative",
            Part::Zeros,
            "negative and huge values is zero",
            vec![velocity(&[-1.0, -1e308, 5e-324]), channel("gripper", &[-0.0, 1e308, -2.0], None)],
        ),
        (
            "usual",
            Part::Shape,
            "all negotiated channels has them in their width and unit",
            vec![
                velocity(&[1.0, 2.0, 3.0]),
                channel("gripper", &[0.5], None),
                channel("body_rates", &[1.0, 1.0, 1.0], Some("rad/s")),
                channel("light", &[900.0], Some("lm")),
            ],
        ),
        (
            "widths",
            Part::Shape,
            "channels of unusual widths keeps the widths",
            vec![
                velocity(&[1.0, 2.0]),
                channel("gripper", &[0.5, 0.5, 0.5, 0.5], None),
                channel("light", &[], Some("lm")),
            ],
        ),
        (
            "units",
            Part::Shape,
            "channels in other units than the negotiated ones keeps the units",
            vec![channel(VELOCITY, &[1.0, 2.0, 3.0], Some("kn")), channel("light", &[1.0], Some("cd"))],
        ),
        (
            "unknown",
            Part::Shape,
            "channels that were not negotiated keeps their widths and units",
            vec![channel("winch", &[4.0, 5.0], Some("N")), channel("flaps", &[1.0], None)],
        ),
        ("some", Part::Added, "the velocity alone has the other negotiated channels", vec![velocity(&[1.0, 2.0, 3.0])]),
        ("none", Part::Added, "no channels has all negotiated ones", Vec::new()),
        ("no-velocity", Part::Added, "no velocity has one of three zeros", vec![channel("gripper", &[0.5], None)]),
    ];
    let one = |(name, part, words, channels): (&str, Part, &str, Vec<Channel>)| {
        let pattern = part.pattern(&channels);
        let command = Command::of(channels);
        let path = format!("channels/{name}/{}", way.name);
        case(path, part.rule(), way, Some(negotiated()), command, pattern)
            .title(format!("The {} frame ({}) of a command with {words}.", way.frame, way.name))
            .flags(&["moving-hold"])
            .because(part.why())
    };
    table.into_iter().map(one).collect()
}

/// What stands beside the channels.
fn kept(way: &Way) -> Vec<Case> {
    let mut cases = Vec::new();
    let base = || Command::of(vec![velocity(&[1.0, 2.0, 3.0])]);
    let mut add = |path: String, rule, what: String, command: Command, part: Json| {
        cases.push(
            case(format!("kept/{path}/{}", way.name), rule, way, None, command, part)
                .title(format!("The {} frame ({}) {what}.", way.frame, way.name))
                .because("A HOLD or ESTOP frame keeps `t`, `seq`, `frame_id` and `ttl_ms` of the command, and has no horizon."),
        );
    };
    for seq in [0, 1, -3, 9_007_199_254_740_991] {
        add(
            format!("seq/{seq}").replace("/-", "/minus-"),
            "NCP-SAFE-070",
            format!("keeps the seq {seq}"),
            base().seq(seq),
            object! { "seq" => int(seq) },
        );
    }
    for t in [0.0, -1.5, 1e9, 1e308, 5e-324] {
        let mut command = base();
        command.t = t;
        add(
            format!("t/{}", name_of(t)),
            "NCP-SAFE-070",
            format!("keeps the time {t} s"),
            command,
            object! { "t" => num(t) },
        );
    }
    for ttl in [250.0, 60_001.0, 1e308] {
        add(
            format!("ttl/{}", name_of(ttl)),
            "NCP-SAFE-070",
            format!("keeps the ttl of {ttl} ms"),
            base().ttl(ttl),
            object! { "ttl_ms" => num(ttl) },
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
            format!("keeps a frame_id ({name})"),
            command,
            object! { "frame_id" => frame_id },
        );
    }
    let nothing = || object! { "horizon" => Json::Array(Vec::new()) };
    let horizon = base().then(100.0, &[[1.0, 0.0, 0.0], [2.0, 0.0, 0.0]]);
    add("horizon".to_owned(), "NCP-SAFE-074", "of a command with a horizon has none".to_owned(), horizon, nothing());
    let mut other = base();
    other.horizon = vec![vec![channel("tow", &[1.0], Some(MPS))]];
    other.dt = Some(10.0);
    add(
        "horizon-of-other-channels".to_owned(),
        "NCP-SAFE-074",
        "drops a horizon of other channels".to_owned(),
        other,
        nothing(),
    );
    cases
}

#[cfg(test)]
mod tests {
    use super::super::model::Outcome;
    use super::*;

    #[test]
    fn every_way_leads_to_the_frame_of_its_name() {
        for way in WAYS {
            let expected = if way.frame == "HOLD" { Outcome::Hold } else { Outcome::Estop };
            for command in [
                Command::moving(&[1.0, 2.0, 3.0]),
                Command::moving(&[-1.0, -1e308, 5e-324]),
                Command::of(Vec::new()),
                Command::moving(&[1.0, 2.0, 3.0]).then(100.0, &[[1.0, 0.0, 0.0]]),
            ] {
                let trace = Trace::new(way.limits, (way.steps)(command));
                let outcomes = trace.outcomes();
                let last = outcomes.last().and_then(Option::as_ref);
                assert_eq!(last, Some(&vec![expected.clone()]), "{}", way.name);
            }
        }
    }
}
