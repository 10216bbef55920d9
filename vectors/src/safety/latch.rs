//! What latches ESTOP, what clears it, and what a fault of the configuration outlives.

use super::model::{Limits, Outcome, Sensor, Step, Trace, govern};
use super::{good, latching, near, row_case};
use crate::case::{Case, File};
use crate::json::object;
use crate::scenario::{Row, ScenarioError, Scenarios, source};
use crate::trace::steps;

pub(super) fn file() -> Result<File, ScenarioError> {
    let mut cases = sequences();
    let mut text = Scenarios::read(source!("safety/latch"))?;
    for group in ["config", "hold", "again", "perhaps", "one-reset", "resets", "resets-behind", "pauses", "inwards"] {
        cases.extend(text.cases(group, row_case)?);
    }
    cases.extend(text.rest(repeated)?);
    let about = "Latches and resets of the governor: every sequence of three events, with a good command after each.";
    Ok(File::new("safety", "latch", about, cases))
}

const EVENTS: [(&str, &str); 5] = [
    ("estop", "an ESTOP command"),
    ("burst", "a burst"),
    ("calm", "a link without a burst"),
    ("reset", "a reset"),
    ("breach", "a breach of the fence"),
];

fn event(name: &str, seq: i64) -> Step {
    match name {
        "estop" => govern(good().seq(seq).mode("estop"), near()),
        "burst" => Step::Link(true),
        "calm" => Step::Link(false),
        "reset" => Step::Reset,
        _ => govern(good().seq(seq), Sensor::at(&[30.0, 40.0, 10.0])),
    }
}

/// Every sequence of three events, and a command that is good by itself after each.
fn sequences() -> Vec<Case> {
    let mut cases = Vec::new();
    for first in EVENTS {
        for second in EVENTS {
            for third in EVENTS {
                let sequence = [first, second, third];
                let mut steps = Vec::new();
                for (nth, (name, _)) in (1_i64..).zip(sequence) {
                    steps.push(event(name, 10 * nth));
                    steps.push(govern(good().seq(10 * nth + 1), near()));
                }
                let trace = Trace::new(Limits::fence(5.0), steps);
                let names = sequence.map(|(name, _)| name);
                let words = sequence.map(|(_, words)| words);
                cases.push(
                    latching(format!("sequence/{}", names.join("-")), &rules(&names), &trace)
                        .decided_throughout_by(&trace.rules())
                        .title(format!(
                            "After {}, then {}, then {}, the governor is latched or not as the text says.",
                            words[0], words[1], words[2]
                        ))
                        .flags(if names.contains(&"estop") { &["lost-estop"] } else { &[] })
                        .because("An ESTOP command, a burst and a breach latch; only a reset clears the latch."),
                );
            }
        }
    }
    cases
}

/// A row of HOLDs, of which only the mode is looked at: the first shows its gate, and those behind it that a HOLD
/// leaves nothing behind.
fn repeated(row: &Row) -> Result<Case, ScenarioError> {
    let outcomes = Trace::of(row)?.outcomes();
    let mode = |outcome: &Option<Vec<Outcome>>| {
        let holds = outcome.as_ref().is_some_and(|outcome| outcome.first() == Some(&Outcome::Hold));
        object! { "frame" => object! { "mode" => if holds { "hold" } else { "active" } } }
    };
    let shown = steps(outcomes.iter().map(mode).collect());
    Ok(row_case(row)?.shows(shown).about_from(1))
}

/// The rules that a sequence shows: at the head what a calm link or a reset does to a latch, else the one
/// of its first event that latches.
fn rules(names: &[&'static str; 3]) -> Vec<&'static str> {
    let rule_of = |name: &str| match name {
        "estop" => "NCP-SAFE-004",
        "burst" => "NCP-SAFE-006",
        "breach" => "NCP-SAFE-043",
        "reset" => "NCP-SAFE-008",
        _ => "NCP-SAFE-007",
    };
    let (mut calmed, mut cleared, mut latching) = (None, None, None);
    let (mut latched, mut shown) = (false, Vec::new());
    for name in names {
        let rule = rule_of(name);
        match *name {
            "calm" if latched => calmed = Some(rule),
            "reset" if latched => cleared = Some(rule),
            "calm" | "reset" => {}
            _ => latching = latching.or(Some(rule)),
        }
        latched = match *name {
            "calm" => latched,
            name => name != "reset",
        };
        if *name != "reset" || cleared.is_some() {
            shown.push(rule);
        }
    }
    let mut rules: Vec<&'static str> = [calmed, cleared, latching].into_iter().flatten().collect();
    for rule in shown {
        if !rules.contains(&rule) {
            rules.push(rule);
        }
    }
    if latched {
        rules.push("NCP-SAFE-005");
    }
    if rules.is_empty() {
        rules.push("NCP-SAFE-021");
    }
    rules
}
