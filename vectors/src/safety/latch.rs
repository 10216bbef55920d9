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
        _ => govern(good().seq(seq), Sensor::at(&[3.0, 4.0, 1.0])),
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

/// The rules that a sequence shows, the one of its first event that latches at the head.
fn rules(names: &[&'static str; 3]) -> Vec<&'static str> {
    let mut rules = Vec::new();
    let mut latched = false;
    for name in names {
        let rule = match *name {
            "estop" => "NCP-SAFE-004",
            "burst" => "NCP-SAFE-006",
            "breach" => "NCP-SAFE-043",
            "reset" => "NCP-SAFE-008",
            _ => "NCP-SAFE-007",
        };
        if *name == "reset" && !latched && rules.is_empty() {
            continue;
        }
        latched |= matches!(*name, "estop" | "burst" | "breach");
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
    // What ends with a reset of a latch shows the reset.
    if names.last() == Some(&"reset")
        && let Some(at) = rules.iter().position(|rule| *rule == "NCP-SAFE-008")
    {
        rules.swap(0, at);
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
            steps.push(Step::Reset);
            steps.push(govern(good().seq(21), near()));
            case(format!("config/{name}/{path}"), rules, &Trace::new(limits, steps))
                .title(title)
                .flags(&["L13", "L15"])
                .because("Limits that are negative put the governor into config fail-closed, which does not end while it exists.")
        };
        cases.push(stay(
            "A governor in config fail-closed holds, also after a reset.",
            "reset",
            &["NCP-SAFE-009", "NCP-SAFE-013", "NCP-SAFE-017"],
            Vec::new(),
        ));
        cases.push(stay(
            "A governor in config fail-closed goes from ESTOP back to HOLD on a reset.",
            "burst",
            &["NCP-SAFE-009", "NCP-SAFE-006", "NCP-SAFE-017"],
            vec![Step::Link(true)],
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
            &["NCP-SAFE-004", "NCP-SAFE-005", "NCP-SAFE-009"],
            vec![govern(good().mode("estop"), near())],
        ));
    }
    cases
}

/// Holds that end by themselves.
fn holds() -> Vec<Case> {
    let far = Step::Govern {
        command: good().seq(2),
        now: 11.0,
        sensor: Some(near()),
        last: Some(10.0),
    };
    let back = Step::Govern {
        command: good().seq(2),
        now: 9.75,
        sensor: Some(near()),
        last: Some(10.0),
    };
    let out = govern(
        super::model::Command::moving(&[40.0, 0.0, 0.0]).seq(2),
        near(),
    );
    let lost = govern(good().seq(2), Sensor::of(Vec::new()));
    let table: [(&str, &str, &'static str, Step); 5] = [
        ("stale", "a stale sensor", "NCP-SAFE-033", far),
        (
            "clock",
            "a clock that stepped backward",
            "NCP-SAFE-035",
            back,
        ),
        (
            "projection",
            "a velocity that leads out of the fence",
            "NCP-SAFE-051",
            out,
        ),
        (
            "position",
            "a frame without a position",
            "NCP-SAFE-040",
            lost,
        ),
        (
            "mode",
            "a command in mode `hold`",
            "NCP-SAFE-002",
            govern(good().seq(2).mode("hold"), near()),
        ),
    ];
    let one = |(name, words, rule, step): (&str, &str, &'static str, Step)| {
        let steps = vec![
            govern(good().seq(1), near()),
            step.clone(),
            step,
            govern(good().seq(3), near()),
            govern(good().seq(4), near()),
        ];
        case(
            format!("hold/{name}"),
            &["NCP-SAFE-022", rule],
            &Trace::new(Limits::fence(5.0), steps),
        )
        .title(format!(
            "The HOLD for {words} ends with the next good command."
        ))
        .because("A HOLD ends by itself with the first command that passes all gates.")
    };
    table.into_iter().map(one).collect()
}
