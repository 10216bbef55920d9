//! Every mode at every gate, and violations of two and three gates at once.

use super::model::{Capabilities, Channel, Command, Limits, Outcome, POSITION, Sensor, Step, Trace, VELOCITY, govern};
use super::{case, good, near};
use crate::case::{Case, File};
use crate::json::object;
use crate::trace::{any, refused, steps};

pub(super) fn file() -> File {
    let mut cases = Vec::new();
    for violation in VIOLATIONS {
        cases.extend(in_every_mode(violation));
    }
    cases.extend(in_every_mode(&NOTHING));
    cases.extend(together());
    cases.extend(modes());
    let about = "The gates of the governor: every mode at each of them, and which one decides when several close.";
    File::new("safety", "gates", about, cases)
}

/// What a governor is asked, with all that may be wrong with it.
#[derive(Clone)]
struct Setup {
    limits: Limits,
    capabilities: Option<Capabilities>,
    before: Vec<Step>,
    command: Command,
    sensor: Sensor,
    last: Option<f64>,
}

impl Setup {
    fn new() -> Self {
        Self {
            limits: Limits::fence(5.0),
            capabilities: None,
            before: Vec::new(),
            command: good(),
            sensor: near(),
            last: Some(10.0),
        }
    }

    /// The steps before, the command, and a good command after it.
    fn trace(self) -> Trace {
        let mut steps = self.before;
        steps.push(Step::Govern { command: self.command, now: 10.25, sensor: Some(self.sensor), last: self.last });
        steps.push(govern(good().seq(9), near()));
        Trace { limits: self.limits, capabilities: self.capabilities, steps }
    }
}

/// Something that closes a gate.
struct Violation {
    name: &'static str,
    /// As the end of a sentence that begins with *when*.
    words: &'static str,
    rule: &'static str,
    /// Violations of one slot exclude each other.
    slot: u8,
    apply: fn(&mut Setup),
}

const NOTHING: Violation =
    Violation { name: "nothing", words: "nothing else is wrong", rule: "NCP-SAFE-021", slot: 0, apply: |_| {} };

const VIOLATIONS: &[Violation] = &[
    Violation {
        name: "latched-by-link",
        words: "a burst has latched ESTOP",
        rule: "NCP-SAFE-005",
        slot: 1,
        apply: |setup| setup.before.push(Step::Link(true)),
    },
    Violation {
        name: "latched-by-command",
        words: "an ESTOP command has latched ESTOP",
        rule: "NCP-SAFE-004",
        slot: 1,
        apply: |setup| {
            setup.before.push(govern(good().seq(6).mode("estop"), near()));
        },
    },
    Violation {
        name: "latched-by-fence",
        words: "a breach of the fence has latched ESTOP",
        rule: "NCP-SAFE-043",
        slot: 1,
        apply: |setup| {
            setup.before.push(govern(good().seq(6), Sensor::at(&[0.0, 0.0, -6.0])));
        },
    },
    Violation {
        name: "config-fault",
        words: "the limits cannot be enforced",
        rule: "NCP-SAFE-017",
        slot: 2,
        apply: |setup| setup.limits.speed = Some(-1.0),
    },
    Violation {
        name: "unbound-limit",
        words: "the fence's channel is not declared",
        rule: "NCP-SAFE-014",
        slot: 2,
        apply: |setup| {
            let mut capabilities = Capabilities::canonical(&[]);
            capabilities.sensors.clear();
            setup.capabilities = Some(capabilities);
        },
    },
    Violation {
        name: "stale-sensor",
        words: "the sensor is older than the timeout",
        rule: "NCP-SAFE-033",
        slot: 3,
        apply: |setup| setup.last = Some(9.0),
    },
    Violation {
        name: "no-sensor-time",
        words: "there is no sensor time",
        rule: "NCP-SAFE-030",
        slot: 3,
        apply: |setup| setup.last = None,
    },
    Violation {
        name: "clock-backward",
        words: "the clock reads less than the sensor's time",
        rule: "NCP-SAFE-035",
        slot: 3,
        apply: |setup| setup.last = Some(10.5),
    },
    Violation {
        name: "no-position",
        words: "the position is missing",
        rule: "NCP-SAFE-040",
        slot: 4,
        apply: |setup| {
            setup.sensor.channels.retain(|channel| channel.name != POSITION);
        },
    },
    Violation {
        name: "outside",
        words: "the position is outside the fence",
        rule: "NCP-SAFE-043",
        slot: 4,
        apply: |setup| setup.sensor = Sensor::at(&[0.0, 6.0, 0.0]),
    },
    Violation {
        name: "no-velocity",
        words: "the command has no velocity",
        rule: "NCP-SAFE-052",
        slot: 5,
        apply: |setup| setup.command.channels = vec![other_channel()],
    },
    Violation {
        name: "leaves-fence",
        words: "the velocity leads out of the fence",
        rule: "NCP-SAFE-051",
        slot: 5,
        apply: |setup| {
            if let Some(channel) = setup.command.channels.iter_mut().find(|c| c.name == VELOCITY) {
                channel.data = vec![40.0, 0.0, 0.0];
            }
        },
    },
    Violation {
        name: "bad-horizon",
        words: "the horizon's tick has no length",
        rule: "NCP-SAFE-068",
        slot: 6,
        apply: |setup| {
            setup.command = setup.command.clone().then(100.0, &[[1.0, 0.0, 0.0]]);
            setup.command.dt = None;
        },
    },
    Violation {
        name: "estop",
        words: "the command is an ESTOP",
        rule: "NCP-SAFE-003",
        slot: 7,
        apply: |setup| setup.command.mode = "estop",
    },
    Violation {
        name: "hold",
        words: "the command is a HOLD",
        rule: "NCP-SAFE-002",
        slot: 7,
        apply: |setup| setup.command.mode = "hold",
    },
    Violation {
        name: "init",
        words: "the command is in mode `init`",
        rule: "NCP-SAFE-002",
        slot: 7,
        apply: |setup| setup.command.mode = "init",
    },
];

fn other_channel() -> Channel {
    super::model::channel("gripper", &[0.5], None)
}

/// A violation under each mode.
fn in_every_mode(violation: &Violation) -> Vec<Case> {
    let modes: &[&'static str] = if violation.slot == 7 { &[] } else { &["active", "hold", "init", "estop"] };
    let mode_case = |mode: &&'static str| {
        let mode = *mode;
        let mut setup = Setup::new();
        (violation.apply)(&mut setup);
        setup.command.mode = mode;
        let trace = setup.trace();
        let decided = outcome(&trace);
        // What the mode decides is the mode's rule; else the violation's.
        let rules: Vec<&'static str> = match (mode, violation.slot) {
            ("estop", _) => vec!["NCP-SAFE-003", "NCP-SAFE-004"],
            ("hold" | "init", 0 | 5 | 6) => vec!["NCP-SAFE-002", "NCP-SAFE-022"],
            (_, 1) if violation.rule != "NCP-SAFE-005" => {
                vec![violation.rule, "NCP-SAFE-005"]
            }
            (_, 2) => vec![violation.rule, "NCP-SAFE-018"],
            (_, 0) => vec![violation.rule],
            ("hold" | "init", _) if violation.name == "outside" => {
                vec!["NCP-SAFE-002", "NCP-SAFE-020"]
            }
            _ => vec![violation.rule, "NCP-SAFE-020"],
        };
        case(format!("{}/{mode}", violation.name), &rules, &trace)
            .title(format!("A command in mode `{mode}` when {} becomes {decided}.", violation.words))
            .flags(if mode == "estop" { &["lost-estop"] } else { &[] })
            .because("The gates of section 7.3 in their order, for this command and for a good one after it.")
    };
    modes.iter().map(mode_case).collect()
}

/// Modes that do not move, under each limit and at several speeds.
fn modes() -> Vec<Case> {
    let mut cases = Vec::new();
    // A wire string that nobody knows; an interface may refuse it.
    for mode in ["dance", "ACTIVE", "active "] {
        let trace = Trace::new(Limits::NONE, vec![govern(good().mode(mode), near())]);
        let hold = object! { "frame" => object! { "mode" => "hold" } };
        let name = mode.to_lowercase().replace(' ', "-space");
        cases.push(
            case(format!("mode/unknown/{name}"), &["NCP-SAFE-002"], &trace)
                .shows_or_refuses(steps(vec![any(vec![hold, refused()])]))
                .title(format!("A command in the unknown mode `{mode}` becomes a HOLD frame."))
                .flags(&["unknown-mode-moves"])
                .because("An unknown mode reads as `hold`, and the governor answers it with a HOLD frame."),
        );
    }
    for mode in ["hold", "init"] {
        for (with, limits) in [
            ("no-limit", Limits::NONE),
            ("speed-limit", Limits::speed(2.0)),
            ("fence", Limits::fence(5.0)),
            ("both", Limits::both(2.0, 5.0)),
        ] {
            for (what, velocity) in [("still", [0.0; 3]), ("slow", [1.0, 0.0, 0.0])] {
                let command = Command::moving(&velocity).mode(mode);
                cases.push(
                    case(
                        format!("mode/{mode}/{with}/{what}"),
                        &["NCP-SAFE-002"],
                        &Trace::new(limits, vec![govern(command, near())]),
                    )
                    .title(format!(
                        "A command in mode `{mode}` becomes a HOLD frame, with {} ({what}).",
                        with.replace('-', " ")
                    ))
                    .because("The governor answers a command in mode `init` or `hold` with a HOLD frame."),
                );
            }
        }
    }
    cases
}

/// Two and three violations at once, where their order can be seen: one of them latches ESTOP and
/// another does not.
fn together() -> Vec<Case> {
    let mut sets: Vec<Vec<&Violation>> = Vec::new();
    for (a, first) in VIOLATIONS.iter().enumerate() {
        for (b, second) in VIOLATIONS.iter().enumerate().skip(a + 1) {
            sets.push(vec![first, second]);
            for third in VIOLATIONS.iter().skip(b + 1) {
                sets.push(vec![first, second, third]);
            }
        }
    }
    sets.retain(|set| is_telling(set));
    let case_of = |set: Vec<&Violation>| {
        let mut setup = Setup::new();
        for violation in &set {
            (violation.apply)(&mut setup);
        }
        let trace = setup.trace();
        let decided = outcome(&trace);
        let names: Vec<_> = set.iter().map(|violation| violation.name).collect();
        let words: Vec<_> = set.iter().map(|violation| violation.words).collect();
        let mut rules = vec!["NCP-SAFE-020"];
        let moves = !set.iter().any(|v| matches!(v.name, "hold" | "init"));
        for violation in &set {
            // What is outside is bound to latch on an active command only.
            if !rules.contains(&violation.rule) && (moves || violation.name != "outside") {
                rules.push(violation.rule);
            }
        }
        case(format!("order/{}", names.join("_and_")), &rules, &trace)
            .title(format!("When {}, the command becomes {decided}.", words.join(" and ")))
            .flags(&["gate-order"])
            .because(
                "The first gate of section 7.3 that closes decides the frame, and a gate behind it latches nothing.",
            )
    };
    sets.into_iter().map(case_of).collect()
}

fn is_telling(set: &[&Violation]) -> bool {
    let excluded = set.iter().enumerate().any(|(at, one)| set.iter().skip(at + 1).any(|other| one.slot == other.slot));
    let latches = |violation: &&Violation| matches!(violation.name, "outside" | "estop") || violation.slot == 1;
    // What is wrong with the mode or the velocity is all one to a latched governor: one of them is enough.
    let behind = set.iter().filter(|violation| violation.slot >= 5).count();
    let stops = set.iter().filter(|violation| latches(violation)).count();
    !excluded && (1..set.len()).contains(&stops) && (set.len() == 2 || behind == 0)
}

/// What the last command but one becomes, in words.
fn outcome(trace: &Trace) -> &'static str {
    if trace.is_open() {
        return "an ESTOP frame or a HOLD frame";
    }
    let outcomes = trace.outcomes();
    let at = outcomes.len().saturating_sub(2);
    match outcomes.get(at).and_then(Option::as_ref).and_then(|outcomes| outcomes.first()) {
        Some(Outcome::Estop) => "an ESTOP frame",
        Some(Outcome::Hold) => "a HOLD frame",
        _ => "what may be sent",
    }
}
