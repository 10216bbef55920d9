//! What HOLD and ESTOP frames hold.
//!
//! A case looks at one thing only: at the zeros, at widths and units, at what is added, at one member that is
//! kept, or at the horizon. That the frame is a HOLD or an ESTOP is asked elsewhere.

use super::model::{Capabilities, Limits, Sensor, Spec, Step, Trace, govern, scalar, vec3};
use super::near;
use crate::case::{Case, File, Role};
use crate::command::{self, Channel, Command, MPS, VELOCITY, channel, velocity};
use crate::json::{Json, object};
use crate::names;
use crate::scenario::{Row, ScenarioError, Scenarios, source};
use crate::trace::{any, anything, int, name_of, no_result, num, nums, refused, steps};

pub(super) fn file() -> Result<File, ScenarioError> {
    let mut text = Scenarios::read(source!("safety/zeroing"))?;
    let rows = text.rows("channels")?;
    text.end()?;
    let mut cases = Vec::new();
    for way in WAYS {
        cases.extend(channels(way, &rows)?);
        cases.push(canonical(way));
        cases.extend(declared(way));
        cases.extend(kept(way));
        cases.extend(wide(way));
        cases.extend(rare_names(way));
    }
    cases.extend(one_after_another());
    cases.extend(behind_what_passed());
    let about = "HOLD and ESTOP frames: what of the command is zeroed, what is kept and what is added.";
    Ok(File::new("safety", "zeroing", about, cases))
}

/// A way to a HOLD or an ESTOP frame.
struct Way {
    name: &'static str,
    /// The case about that way.
    beneath: &'static str,
    frame: &'static str,
    limits: Limits,
    steps: fn(Command) -> Vec<Step>,
}

const FENCE: Limits = Limits::fence(5.0);

const WAYS: &[Way] = &[
    Way {
        name: "hold-command",
        beneath: "safety/gates/nothing/hold",
        frame: "HOLD",
        limits: FENCE,
        steps: |command| vec![govern(command.mode("hold"), near())],
    },
    Way {
        name: "init-command",
        beneath: "safety/gates/nothing/init",
        frame: "HOLD",
        limits: FENCE,
        steps: |command| vec![govern(command.mode("init"), near())],
    },
    Way {
        name: "stale",
        beneath: "safety/gates/stale-sensor/active",
        frame: "HOLD",
        limits: FENCE,
        steps: |command| vec![Step::Govern { command, now: 20.0, sensor: Some(near()), last: Some(10.0) }],
    },
    Way {
        name: "no-position",
        beneath: "safety/gates/no-position/active",
        frame: "HOLD",
        limits: FENCE,
        steps: |command| vec![govern(command, Sensor::of(Vec::new()))],
    },
    Way {
        name: "config-fault",
        beneath: "safety/gates/config-fault/active",
        frame: "HOLD",
        limits: Limits::speed(-1.0),
        steps: |command| vec![govern(command, near())],
    },
    Way {
        name: "not-finite",
        beneath: "safety/numbers/gripper/nan/no-limit",
        frame: "HOLD",
        limits: Limits::NONE,
        steps: |command| vec![govern(command.and(channel("z", &[f64::NAN], None)), near())],
    },
    Way {
        name: "bad-tick",
        beneath: "safety/gates/bad-horizon/active",
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
        beneath: "safety/gates/leaves-fence/active",
        frame: "HOLD",
        limits: FENCE,
        steps: |command| vec![govern(command, Sensor::at(&[4.875, 0.0, 0.0]))],
    },
    Way {
        name: "estop-command",
        beneath: "safety/gates/nothing/estop",
        frame: "ESTOP",
        limits: FENCE,
        steps: |command| vec![govern(command.mode("estop"), near())],
    },
    Way {
        name: "breach",
        beneath: "safety/gates/outside/active",
        frame: "ESTOP",
        limits: FENCE,
        steps: |command| vec![govern(command, Sensor::at(&[9.0, 0.0, 0.0]))],
    },
    Way {
        name: "latched",
        beneath: "safety/gates/latched-by-command/active",
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
    let case = Case::new(path, &[rule], &[Role::Commander]).rests_on(way.beneath);
    case.call("governor.run", trace.args()).shows(steps(entries))
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
                "A negotiated channel that the command lacks becomes three zeros in m/s if it is the velocity, and \
                 else a single zero."
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
                    object! { "data" => data, "unit" => channel.unit.as_deref() }
                }
            };
            (channel.name.clone(), value)
        };
        let added = || {
            let capabilities = negotiated();
            let lacks = |name: &str| channels.iter().all(|channel| channel.name != name);
            let specs = capabilities.commands.into_iter();
            specs
                .filter(|spec| lacks(&spec.name))
                .map(|spec| {
                    let zero = if spec.name == VELOCITY {
                        object! { "data" => nums(&[0.0; 3]), "unit" => MPS }
                    } else {
                        object! { "data" => nums(&[0.0]) }
                    };
                    (spec.name.clone(), zero)
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
fn channels(way: &Way, rows: &[Row]) -> Result<Vec<Case>, ScenarioError> {
    let one = |row: &Row| {
        let part = match row.cell("part")? {
            "zeros" => Part::Zeros,
            "shape" => Part::Shape,
            "added" => Part::Added,
            part => return Err(row.place.wants("part of a frame", part)),
        };
        let channels = command::channels(row.place, row.cell("v")?, velocity)?;
        let pattern = part.pattern(&channels);
        let path = format!("channels/{}/{}", row.name, way.name);
        let case = case(path, part.rule(), way, Some(negotiated()), Command::of(channels), pattern);
        // A channel of another width is not zeroed wrongly.
        let case = match part {
            Part::Zeros => {
                case.by("/steps/*/frame/channels/*/data", "NCP-SAFE-072").by_own("/steps/*/frame/channels/*/data/*")
            }
            _ => case,
        };
        Ok(case
            .title(format!("The {} frame ({}) of a command with {}.", way.frame, way.name, row.cell("words")?))
            .flags(&["moving-hold"])
            .because(part.why()))
    };
    rows.iter().map(one).collect()
}

/// A channel that is wider than a buffer somebody may keep zeros in, and more channels than that.
fn wide(way: &Way) -> Vec<Case> {
    // Every width on the plainest way to either frame, one on each other.
    let widths: &[usize] = match way.name {
        "hold-command" => &[65, 300, 1025, 8193],
        "breach" => &[65, 300],
        _ => &[65],
    };
    let why = "A zeroed channel of the command keeps its width, however wide it is.";
    let mut cases: Vec<Case> = widths
        .iter()
        .map(|width| {
            let grid = channel("grid", &vec![0.5; *width], None);
            let zeros = object! { "channels" => object! { "grid" => object! { "data" => nums(&vec![0.0; *width]) } } };
            let command = Command::moving(&[1.0, 0.0, 0.0]).and(grid);
            case(format!("wide/{width}/{}", way.name), "NCP-SAFE-072", way, None, command, zeros)
                .by("/steps/*/frame/channels/*/data/*", "NCP-SAFE-071")
                .title(format!(
                    "The {} frame ({}) of a command with a channel {width} wide is as wide.",
                    way.frame, way.name
                ))
                .flags(&["moving-hold"])
                .because(why)
        })
        .collect();
    if way.name == "hold-command" {
        let names: Vec<String> = (0..130).map(|nth| format!("joint_{nth}")).collect();
        let joints = names.iter().map(|name| channel(name, &[0.5], None)).collect();
        let zeros = names.iter().map(|name| (name.clone(), object! { "data" => nums(&[0.0]) })).collect();
        let part = object! { "channels" => Json::Object(zeros) };
        cases.push(
            case(format!("wide/130-channels/{}", way.name), "NCP-SAFE-071", way, None, Command::of(joints), part)
                .title(format!(
                    "The {} frame ({}) of a command with 130 channels zeroes them all.",
                    way.frame, way.name
                ))
                .flags(&["moving-hold"])
                .because("The union of the command's channels and the negotiated ones is zeroed."),
        );
    }
    // A sensor may have a channel of the name, too.
    let commands = negotiated().commands;
    let sensors = negotiated().sensors.into_iter().chain(commands.clone()).collect();
    let capabilities = Some(Capabilities { sensors, commands });
    let none = Part::Added.pattern(&[]);
    cases.push(
        case(format!("both-sides/{}", way.name), Part::Added.rule(), way, capabilities, Command::of(Vec::new()), none)
            .title(format!(
                "The {} frame ({}) of no channels has all negotiated ones, also those that a sensor has.",
                way.frame, way.name
            ))
            .flags(&["moving-hold"])
            .because(Part::Added.why()),
    );
    // More of them than a table of 256 has room for: only some are looked at.
    if way.name == "hold-command" {
        let name = |nth: usize| format!("a{nth:03}");
        let many: Vec<Spec> = (0..600).map(|nth| scalar(&name(nth), None)).collect();
        let zeros = [0, 1, 88, 127, 255, 256, 343, 599].map(|nth| (name(nth), object! { "data" => nums(&[0.0]) }));
        let part = object! { "channels" => Json::Object(zeros.into()) };
        let path = format!("wide/600-negotiated/{}", way.name);
        let capabilities = Some(Capabilities::canonical(&many));
        let case = case(path, "NCP-SAFE-071", way, capabilities, Command::moving(&[1.0, 2.0, 3.0]), part);
        cases.push(
            case.title(format!(
                "The {} frame ({}) of a plant with 600 negotiated channels has the last as the first.",
                way.frame, way.name
            ))
            .flags(&["moving-hold"])
            .because("The union of the command's channels and the negotiated ones is zeroed."),
        );
    }
    if way.name == "hold-command" {
        let name = |nth: usize| format!("a{nth:03}");
        let many = (0..270).map(|nth| channel(&name(nth), &[1.0], None)).collect();
        let zeros = [0, 127, 128, 255, 256, 257, 269].map(|nth| (name(nth), object! { "data" => nums(&[0.0]) }));
        let part = object! { "channels" => Json::Object(zeros.into()) };
        let case = case(format!("wide/270-channels/{}", way.name), "NCP-SAFE-071", way, None, Command::of(many), part);
        cases.push(
            case.title(format!(
                "The {} frame ({}) of a command with 270 channels zeroes the last as the first.",
                way.frame, way.name
            ))
            .flags(&["moving-hold"])
            .because("The union of the command's channels and the negotiated ones is zeroed."),
        );
    }
    cases
}

/// Commands one after the other, of the same channels in other widths and units, and of others.
fn one_after_another() -> [Case; 3] {
    [("hold", "HOLD"), ("init", "HOLD"), ("estop", "ESTOP")].map(|(mode, frame)| {
        let gripper = |width: usize, unit| channel("gripper", &vec![1.0; width], unit);
        let commands = [
            vec![gripper(1, Some("N")), velocity(&[1.0, 0.0, 0.0])],
            // Of the same names and widths, and the other way round of all the same.
            vec![gripper(1, Some("mm")), velocity(&[1.0, 0.0, 0.0])],
            vec![gripper(1, None), channel(VELOCITY, &[1.0, 0.0, 0.0], Some("kn"))],
            vec![channel(VELOCITY, &[1.0, 0.0, 0.0], Some("rad")), gripper(1, Some("N"))],
            vec![gripper(2, Some("mm")), velocity(&[1.0, 0.0, 0.0])],
            vec![velocity(&[1.0, 0.0, 0.0]), gripper(3, None)],
            vec![velocity(&[1.0, 0.0, 0.0])],
            vec![channel("gimbal", &[1.0, 2.0, 3.0], Some("rad"))],
            vec![gripper(1, None), velocity(&[1.0, 0.0])],
            vec![],
        ];
        let zeros = |channels: &[Channel]| {
            let mut all: Vec<(String, Json)> = channels
                .iter()
                .map(|channel| {
                    let zero = object! { "data" => nums(&vec![0.0; channel.data.len()]),
                    "unit" => channel.unit.as_deref() };
                    (channel.name.to_string(), zero)
                })
                .collect();
            if !all.iter().any(|(name, _)| name == VELOCITY) {
                all.push((VELOCITY.to_owned(), object! { "data" => nums(&[0.0; 3]), "unit" => MPS }));
            }
            object! { "frame" => object! { "channels" => object! { "$exact" => Json::Object(all) } } }
        };
        let entries = commands.iter().map(|channels| zeros(channels)).collect();
        let commands = (1..).zip(commands);
        let commands = commands.map(|(seq, channels)| govern(Command::of(channels).seq(seq).mode(mode), near()));
        let trace = Trace { limits: Limits::NONE, capabilities: None, steps: commands.collect() };
        Case::new(format!("one-after-another/{mode}"), &["NCP-SAFE-071", "NCP-SAFE-072"], &[Role::Commander])
            .by("/steps/*/frame/channels/*/data", "NCP-SAFE-072")
            .by("/steps/*/frame/channels/*/unit", "NCP-SAFE-072")
            .rests_on(format!("safety/gates/nothing/{mode}"))
            .call("governor.run", trace.args())
            .shows(steps(entries))
            .title(format!("The {frame} frames of ten commands in mode `{mode}` have each the channels of their own."))
            .flags(&["moving-hold"])
            .because(
                "A frame has the union of its own command's channels and the negotiated ones and no other, and each \
                 of the command's keeps its width and its unit.",
            )
    })
}

/// Behind a command that passed, with channels of its own at tick 0 and in its horizon.
fn behind_what_passed() -> [Case; 3] {
    [("hold", "HOLD"), ("init", "HOLD"), ("estop", "ESTOP")].map(|(mode, frame)| {
        let mut passing = Command::moving(&[1.0, 0.0, 0.0]).and(channel("gripper", &[1.0], Some("N"))).seq(1);
        passing = passing.then(50.0, &[[1.0, 0.0, 0.0], [0.0; 3]]);
        for step in &mut passing.horizon {
            step.push(channel("tow", &[1.0], Some("N")));
        }
        let stopping = Command::moving(&[1.0, 0.0, 0.0]).mode(mode).seq(2);
        let zero = object! { "data" => nums(&[0.0; 3]), "unit" => MPS };
        let zeroed = object! { "channels" => object! { "$exact" => object! { VELOCITY => zero } } };
        let governed = vec![govern(passing, near()), govern(stopping, near())];
        let trace = Trace { limits: Limits::NONE, capabilities: None, steps: governed };
        Case::new(format!("behind-what-passed/{mode}"), &["NCP-SAFE-071"], &[Role::Commander])
            .rests_on(format!("safety/gates/nothing/{mode}"))
            .call("governor.run", trace.args())
            .shows(steps(vec![anything(), object! { "frame" => zeroed }]))
            .title(format!(
                "The {frame} frame of a command in mode `{mode}` has no channel of a command that passed before it."
            ))
            .flags(&["moving-hold"])
            .because("A frame has the union of its own command's channels and the negotiated ones, and no other.")
    })
}

/// A command whose channels have all names that others are like, and negotiated channels of the names that are like
/// them.
fn of_all_names(way: &Way) -> Case {
    let (own, others): (Vec<_>, Vec<_>) = names::alike().partition(|(_, is_first)| *is_first);
    let command = Command::of(own.iter().map(|(name, _)| channel(name, &[1.0, 2.0], None)).collect());
    let negotiated: Vec<Spec> = others.iter().map(|(name, _)| scalar(name, None)).collect();
    let zeros = |of: &[(&str, bool)], width: usize| -> Vec<(String, Json)> {
        let zero = |name: &str| (name.to_owned(), object! { "data" => nums(&vec![0.0; width]) });
        of.iter().map(|(name, _)| zero(name)).collect()
    };
    let all = Json::Object([zeros(&own, 2), zeros(&others, 1)].concat());
    let capabilities = Capabilities::canonical(&negotiated);
    let part = object! { "channels" => all };
    case("channels/alike/all".to_owned(), "NCP-SAFE-071", way, Some(capabilities), command, part)
        .title("The HOLD frame has the channels of the command and the negotiated ones, however alike their names are.")
        .flags(&["moving-hold"])
        .because("Names are compared letter for letter, and the union has both.")
}

/// A channel whose name is empty, of the command and among the negotiated ones; and names that only look the same.
fn rare_names(way: &Way) -> Vec<Case> {
    if way.name != "hold-command" {
        return Vec::new();
    }
    let zeros = |data: &[f64]| object! { "channels" => object! { "" => object! { "data" => nums(data) } } };
    let own = Command::moving(&[1.0, 2.0, 3.0]).and(channel("", &[1.0, 2.0], None));
    let lacks = Command::moving(&[1.0, 2.0, 3.0]);
    let capabilities = Capabilities::canonical(&[scalar("", None)]);
    let title = |words: &str| format!("The {} frame ({}) {words} whose name is empty.", way.frame, way.name);
    // Names of the same letters, composed in one and not in the other.
    let composed = Capabilities::canonical(&[scalar("\u{e9}", None)]);
    let decomposed = Command::moving(&[1.0, 2.0, 3.0]).and(channel("e\u{301}", &[1.0, 2.0], None));
    let zero = |data: &[f64]| object! { "data" => nums(data) };
    let both = object! { "\u{e9}" => zero(&[0.0]), "e\u{301}" => zero(&[0.0; 2]) };
    vec![
        of_all_names(way),
        case(
            format!("channels/composed/{}", way.name),
            "NCP-SAFE-071",
            way,
            Some(composed),
            decomposed,
            object! { "channels" => both },
        )
        .title(format!(
            "The {} frame ({}) has a channel of the command and a negotiated one whose names differ in their normal \
             form.",
            way.frame, way.name
        ))
        .flags(&["moving-hold"])
        .because("Names are compared letter for letter, and the union has both."),
        case(format!("channels/nameless/own/{}", way.name), "NCP-SAFE-071", way, None, own, zeros(&[0.0; 2]))
            .title(title("zeroes a channel of the command"))
            .flags(&["moving-hold"])
            .because("The union of the command's channels and the negotiated ones is zeroed, whatever their names."),
        case(
            format!("channels/nameless/negotiated/{}", way.name),
            "NCP-SAFE-073",
            way,
            Some(capabilities),
            lacks,
            zeros(&[0.0]),
        )
        .title(title("adds a negotiated channel"))
        .flags(&["moving-hold"])
        .because(Part::Added.why()),
    ]
}

/// Without Capabilities the velocity is the one negotiated command channel.
fn canonical(way: &Way) -> Case {
    let zeros = object! { VELOCITY => object! { "data" => nums(&[0.0; 3]), "unit" => MPS } };
    let command = Command::of(vec![channel("gripper", &[0.5], None)]);
    let path = format!("channels/canonical/{}", way.name);
    case(path, "NCP-SAFE-073", way, None, command, object! { "channels" => zeros })
        .title(format!(
            "The {} frame ({}) of a governor without Capabilities has a velocity, though the command has none.",
            way.frame, way.name
        ))
        .flags(&["moving-hold"])
        .because(
            "Without Capabilities the negotiated channels are the canonical ones, here `velocity_setpoint` in m/s.",
        )
}

/// The velocity as somebody else would declare it: three zeros in m/s are added all the same.
fn declared(way: &Way) -> Vec<Case> {
    let of = |kind, unit: Option<&str>, size| Spec { kind, size, ..vec3(VELOCITY, unit) };
    let table = [
        ("other-unit", "as a `vec3` in km/h", of("vec3", Some("km/h"), None)),
        ("no-unit", "without a unit", of("vec3", None, None)),
        ("empty-unit", "in an empty unit", of("vec3", Some(""), None)),
        ("scalar", "as a scalar in m/s", of("scalar", Some(MPS), None)),
        ("array-of-4", "as an `array` of 4 in m/s", of("array", Some(MPS), Some(4))),
        ("array-without-a-size", "as an `array` without a size", of("array", Some(MPS), None)),
        ("array-of-6-in-other-unit", "as an `array` of 6 in rad/s", of("array", Some("rad/s"), Some(6))),
    ];
    // Every declaration on the plainest way, a few on others.
    let count = match way.name {
        "hold-command" => table.len(),
        "breach" => 2,
        "config-fault" | "latched" => 1,
        _ => 0,
    };
    let one = |(name, words, spec): (&str, &str, Spec)| {
        let capabilities = Capabilities { commands: vec![spec], ..Capabilities::canonical(&[]) };
        let zeros = object! { VELOCITY => object! { "data" => nums(&[0.0; 3]), "unit" => MPS } };
        let command = Command::of(vec![channel("gripper", &[0.5], None)]);
        let path = format!("channels/declared/{name}/{}", way.name);
        case(path, "NCP-SAFE-073", way, Some(capabilities), command, object! { "channels" => zeros })
            .title(format!(
                "The {} frame ({}) adds three zeros in m/s for a velocity that was declared {words}.",
                way.frame, way.name
            ))
            .flags(&["moving-hold"])
            .because(
                "The velocity channel of rule 73 is `velocity_setpoint`, in whatever kind and unit it was declared.",
            )
    };
    table.into_iter().take(count).map(one).collect()
}

/// What stands beside the channels.
fn kept(way: &Way) -> Vec<Case> {
    let mut cases = Vec::new();
    let base = || Command::of(vec![velocity(&[1.0, 2.0, 3.0])]);
    let mut add = |path: String, rule, what: String, command: Command, part: Json| {
        cases.push(
            case(format!("kept/{path}/{}", way.name), rule, way, None, command, part)
                .title(format!("The {} frame ({}) {what}.", way.frame, way.name))
                .because(
                    "A HOLD or ESTOP frame keeps `t`, `seq`, `frame_id` and `ttl_ms` of the command, and has \
                          no horizon.",
                ),
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
    // What stands still already, and might pass for the frame that it becomes.
    let still = || Command::of(vec![velocity(&[0.0; 3])]);
    for (name, what, command) in [
        ("still", "channels of zeros", still().then(100.0, &[[1.0, 0.0, 0.0], [2.0, 0.0, 0.0]])),
        ("all-still", "channels and steps of zeros", still().then(100.0, &[[0.0; 3], [0.0; 3]])),
        ("no-channels", "no channels", Command::of(Vec::new()).then(100.0, &[[1.0, 0.0, 0.0]])),
    ] {
        // Who stands still leaves no fence.
        if way.name == "leaves-fence" {
            continue;
        }
        let says = format!("of a command with {what} and a horizon has none");
        add(format!("horizon/{name}"), "NCP-SAFE-074", says, command, nothing());
    }
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
