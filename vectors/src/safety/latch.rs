//! What latches ESTOP, what clears it, and what a fault of the configuration outlives.

use super::model::{Limits, Sensor, Step, Trace, govern};
use super::{case, good, near};
use crate::case::{Case, File};

pub(super) fn file() -> File {
    let mut cases = sequences();
    cases.extend(faults());
    cases.extend(holds());
    let about = "Latches and resets of the governor: every sequence of three events, with a good command after each.";
    File::new("safety", "latch", about, cases)
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
                    case(format!("sequence/{}", names.join("-")), &rules(&names), &trace)
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

/// A config fail-closed, which nothing ends.
fn faults() -> Vec<Case> {
    let faulty = [
        ("negative-speed", Limits::both(-1.0, 5.0)),
        ("negative-fence", Limits::both(2.0, -5.0)),
        ("negative-both", Limits::both(-2.0, -5.0)),
    ];
    let mut cases = Vec::new();
    for (name, limits) in faulty {
        let stay = |title: &str, path: &str, rules: &[&'static str], before: Vec<Step>| {
            let mut steps = before;
            steps.push(govern(good().seq(20), near()));
            case(format!("config/{name}/{path}"), rules, &Trace::new(limits, steps))
                .title(title)
                .flags(&["L13", "L15"])
                .because("Limits that are negative put the governor into config fail-closed, which does not end while it exists.")
        };
        cases.push(stay(
            "A governor in config fail-closed holds, also after a reset.",
            "reset",
            &["NCP-SAFE-009", "NCP-SAFE-017"],
            vec![govern(good().seq(1), near()), Step::Reset],
        ));
        cases.push(stay(
            "A governor in config fail-closed holds after a reset that comes before any command.",
            "reset-first",
            &["NCP-SAFE-009", "NCP-SAFE-017"],
            vec![Step::Reset],
        ));
        cases.push(stay(
            "A governor in config fail-closed goes from ESTOP back to HOLD on a reset.",
            "burst-reset",
            &["NCP-SAFE-009", "NCP-SAFE-017"],
            vec![Step::Link(true), Step::Reset],
        ));
        cases.push(stay(
            "A burst latches ESTOP in a governor in config fail-closed too.",
            "burst",
            &["NCP-SAFE-006", "NCP-SAFE-005"],
            vec![Step::Link(true)],
        ));
        cases.push(stay(
            "A burst latches ESTOP in a governor in config fail-closed that has held before.",
            "hold-burst",
            &["NCP-SAFE-006", "NCP-SAFE-005"],
            vec![govern(good().seq(1), near()), Step::Link(true)],
        ));
        cases.push(stay(
            "A governor in config fail-closed holds for every command, not only the first.",
            "many",
            &["NCP-SAFE-018", "NCP-SAFE-017"],
            (1..4).map(|seq| govern(good().seq(seq), near())).collect(),
        ));
        cases.push(stay(
            "A governor in config fail-closed still latches an ESTOP command.",
            "estop",
            &["NCP-SAFE-004", "NCP-SAFE-005"],
            vec![govern(good().mode("estop"), near())],
        ));
    }
    cases
}

/// Holds that end by themselves.
fn holds() -> Vec<Case> {
    let far = Step::Govern { command: good().seq(2), now: 11.0, sensor: Some(near()), last: Some(10.0) };
    let back = Step::Govern { command: good().seq(2), now: 9.75, sensor: Some(near()), last: Some(10.0) };
    let out = govern(super::model::Command::moving(&[40.0, 0.0, 0.0]).seq(2), near());
    let lost = govern(good().seq(2), Sensor::of(Vec::new()));
    let table: [(&str, &str, &'static str, Step); 5] = [
        ("stale", "a stale sensor", "NCP-SAFE-033", far),
        ("clock", "a clock that stepped backward", "NCP-SAFE-035", back),
        ("projection", "a velocity that leads out of the fence", "NCP-SAFE-051", out),
        ("position", "a frame without a position", "NCP-SAFE-040", lost),
        ("mode", "a command in mode `hold`", "NCP-SAFE-002", govern(good().seq(2).mode("hold"), near())),
    ];
    let mut cases = Vec::new();
    for (name, words, rule, step) in table {
        let first = || govern(good().seq(1), near());
        for (when, what, before) in [
            ("twice", "Two HOLDs in a row end", vec![first(), step.clone(), step.clone()]),
            ("once", "One HOLD ends", vec![first(), step.clone()]),
            ("at-first", "A HOLD for the first command ends", vec![step]),
        ] {
            let mut steps = before;
            steps.push(govern(good().seq(3), near()));
            steps.push(govern(good().seq(4), near()));
            cases.push(
                case(format!("hold/{name}/{when}"), &["NCP-SAFE-022", rule], &Trace::new(Limits::fence(5.0), steps))
                    .title(format!("{what} with the next good command, after {words}."))
                    .because("A HOLD ends by itself with the first command that passes all gates."),
            );
        }
    }
    cases
}
