//! Every mode at every gate, and violations of two and three gates at once.

use super::model::{Capabilities, Limits, Outcome, Sensor, Step, Trace, govern, sensed};
use super::{case, good, latching, near, row_case};
use crate::case::{Case, File};
use crate::command::Command;
use crate::json::object;
use crate::scenario::{self, Fault, Row, ScenarioError, Scenarios, source};
use crate::trace::{any, refused, steps};

pub(super) fn file() -> Result<File, ScenarioError> {
    let mut text = Scenarios::read(source!("safety/gates"))?;
    let violations: Vec<_> = text.rows("violations")?.iter().map(Violation::of).collect::<Result<_, _>>()?;
    let nothing = Violation {
        name: "nothing",
        words: "nothing else is wrong",
        rule: "NCP-SAFE-021",
        slot: 0,
        change: Vec::new(),
    };
    let mut cases = Vec::new();
    for violation in violations.iter().chain([&nothing]) {
        cases.extend(in_every_mode(violation)?);
    }
    cases.extend(together(&violations)?);
    cases.extend(modes());
    cases.extend(text.rest(row_case)?);
    let about = "The gates of the governor: every mode at each of them, and which one decides when several close.";
    Ok(File::new("safety", "gates", about, cases))
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
    words: &'static str,
    rule: &'static str,
    /// Violations of one slot exclude each other.
    slot: u8,
    change: Vec<scenario::Step>,
}

impl Violation {
    fn of(row: &Row) -> Result<Self, ScenarioError> {
        let rule = row.rules.first().copied().ok_or(row.place.fault(Fault::Missing("rules")))?;
        let slot = row.cell("slot")?.parse().map_err(|_| row.place.wants("slot", ""))?;
        Ok(Self { name: row.name, words: row.cell("words")?, rule, slot, change: row.steps_of("change")? })
    }

    /// The setup with what is wrong.
    fn apply(&self, setup: &mut Setup) -> Result<(), ScenarioError> {
        for step in &self.change {
            let what = step.tail();
            match step.verb() {
                "before" => setup.before.push(Step::of(&what)?),
                "limits" => setup.limits = setup.limits.set(step)?,
                "undeclared" => {
                    let capabilities = Capabilities { sensors: Vec::new(), ..Capabilities::canonical(&[]) };
                    setup.capabilities = Some(capabilities);
                }
                "last" if what.verb() == "-" => setup.last = None,
                "last" => setup.last = Some(step.place.double(what.verb())?),
                "sensor" => setup.sensor = sensed(step.place, what.verb())?,
                "command" => setup.command = setup.command.clone().set(step)?,
                verb => return Err(step.place.wants("change of what a governor is asked", verb)),
            }
        }
        Ok(())
    }
}

/// A violation under each mode.
fn in_every_mode(violation: &Violation) -> Result<Vec<Case>, ScenarioError> {
    let modes: &[&'static str] = if violation.slot == 7 { &[] } else { &["active", "hold", "init", "estop"] };
    let mode_case = |mode: &&'static str| {
        let mode = *mode;
        let mut setup = Setup::new();
        violation.apply(&mut setup)?;
        setup.command = setup.command.mode(mode);
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
        Ok(latching(format!("{}/{mode}", violation.name), &rules, &trace)
            .title(format!("A command in mode `{mode}` when {} becomes {decided}.", violation.words))
            .flags(if mode == "estop" { &["lost-estop"] } else { &[] })
            .because("The gates of section 7.3 in their order, for this command and for a good one after it."))
    };
    modes.iter().map(mode_case).collect()
}

/// Wire strings that nobody knows; an interface may refuse them.
fn modes() -> Vec<Case> {
    let mut cases = Vec::new();
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
    cases
}

/// Two and three violations at once, where their order can be seen: one of them latches ESTOP and
/// another does not.
fn together(violations: &[Violation]) -> Result<Vec<Case>, ScenarioError> {
    let mut sets: Vec<Vec<&Violation>> = Vec::new();
    for (a, first) in violations.iter().enumerate() {
        for (b, second) in violations.iter().enumerate().skip(a + 1) {
            sets.push(vec![first, second]);
            for third in violations.iter().skip(b + 1) {
                sets.push(vec![first, second, third]);
            }
        }
    }
    sets.retain(|set| is_telling(set));
    let case_of = |set: Vec<&Violation>| {
        let mut setup = Setup::new();
        for violation in &set {
            violation.apply(&mut setup)?;
        }
        let before = setup.before.len();
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
        Ok(latching(format!("order/{}", names.join("_and_")), &rules, &trace)
            .about_from(before)
            .title(format!("When {}, the command becomes {decided}.", words.join(" and ")))
            .flags(&["gate-order"])
            .because(
                "The first gate of section 7.3 that closes decides the frame, and a gate behind it latches nothing.",
            ))
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
