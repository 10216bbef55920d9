//! What a person reads on the terminal when the kernel is refuted.

use std::fmt::Write;

use serde_json::Value;

use crate::engines::Verdict;
use crate::properties::Property;
use crate::report::{Engine, Found, Report, Shown};

const RULE: &str = "================================================================================";

/// A counterexample to a property of the kernel, for someone who has just changed it.
#[must_use]
pub fn refutation(engine: &str, property: &Property, found: &Found) -> String {
    let mut text = format!("\n{RULE}\nTHE KERNEL IS REFUTED: {}\n", property.id);
    let mut line = |name: &str, value: &str| {
        let _ = writeln!(text, "  {name:9} {value}");
    };
    line("claim", property.sentence);
    line("rules", &property.rules.join(", "));
    line("fails", found.check());
    if let Some(compared) = &found.compared {
        line("answers", compared);
    }
    line("inputs", &inputs(found));
    line("found by", engine);
    if let Some(vector) = &found.vector {
        line("as a case of a vector", "");
        line("", &vector.to_string());
    }
    text + RULE + "\n"
}

/// What happens in a counterexample, in one line.
#[must_use]
pub fn inputs(found: &Found) -> String {
    let pair = |(name, value): (&String, &Value)| match value {
        Value::String(word) => format!("{name} = {word}"),
        value => format!("{name} = {value}"),
    };
    let parts: Vec<String> = match &found.shown {
        Shown::Inputs { inputs, .. } => inputs.iter().map(|(name, value)| pair((name, value))).collect(),
        Shown::Call { inputs, .. } => inputs.iter().map(pair).collect(),
        Shown::Path { steps, .. } => steps.clone(),
    };
    if parts.is_empty() { "none".to_owned() } else { parts.join(", ") }
}

/// The end of a run in which the kernel was refuted: which properties, and what to do.
#[must_use]
pub fn summary(refuted: &[String]) -> String {
    format!(
        "\n{RULE}\nFAILED: the kernel in spec/kernel does not do what the text says.\n  \
         refuted   {}\n  {SKIPPED}\n  \
         to do     mend the kernel, and run this again; each counterexample stands above and in\n            \
         reports/proofs.md. If the change is wanted, the text's rules and the harnesses in\n            \
         proofs/src/properties have to say so first.\n{RULE}",
        refuted.join(", ")
    )
}

/// The end of a run without a problem: what each engine did, and where to read of it.
#[must_use]
pub fn proved(report: &Report) -> String {
    let mut text = format!("\n{RULE}\nPROVED: the kernel does what the text says, as far as the report says.\n");
    for engine in &report.engines {
        let _ = writeln!(text, "  {:14} {}", engine.name, count(engine));
    }
    let _ = writeln!(text, "  {:14} reports/proofs.md, reports/full/proofs.html", "to read");
    text + RULE
}

/// How many properties of how many an engine has proved or tried, and how many broken kernels refuted.
fn count(engine: &Engine) -> String {
    let Engine { results, broken, .. } = engine;
    if results.is_empty() {
        return "not run here".to_owned();
    }
    let of = |verdict| results.iter().filter(|result| result.verdict == verdict).count();
    let (proved, tried) = (of(Verdict::Proved), of(Verdict::Tried));
    let (word, good) = if tried > 0 { ("tried", tried) } else { ("proved", proved) };
    let refuted = broken.iter().filter(|broken| broken.is_refuted()).count();
    let (all, every) = (results.len(), broken.len());
    format!("{word} {good} of {all}; broken ones refuted: {refuted} of {every}")
}

/// A line that is not longer than a reader of a log wants.
#[must_use]
pub fn short(line: &str) -> String {
    const LONGEST: usize = 120;
    match line.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", line.get(..end).unwrap_or_default()),
        None => line.to_owned(),
    }
}

/// What a refuted kernel was not asked any more.
pub const SKIPPED: &str = "skipped   what would mean nothing now: the other properties by the slow engines, the \
    broken\n            kernels, and, where they come later, the model and the machine code";

/// A problem of a report: a property that is refuted.
#[must_use]
pub fn problem(engine: &str, property: &str, found: &Found) -> String {
    format!("{property} is refuted by {engine}: {}: {}", found.check(), inputs(found))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::properties::PROPERTIES;
    use crate::report::{Answer, Broken};
    use serde_json::json;

    fn found(inputs: &[(&str, Value)]) -> Found {
        let inputs = inputs.iter().map(|(name, value)| ((*name).to_owned(), value.clone())).collect();
        Found::new(Shown::Inputs { check: "alive".to_owned(), inputs })
    }

    fn broken(is_refuted: bool) -> Broken {
        Broken {
            id: String::new(),
            property: String::new(),
            family: String::new(),
            about: String::new(),
            file: None,
            from: None,
            to: None,
            counterexample: is_refuted.then(|| found(&[])),
            missed: None,
        }
    }

    #[test]
    fn the_end_of_a_good_run_counts_for_each_engine_and_names_those_that_did_not_run() {
        let engine = |name: &str, verdicts: &[Verdict], refuted: &[bool]| Engine {
            name: name.to_owned(),
            results: verdicts.iter().map(|verdict| Answer::new("clamp/bound", *verdict)).collect(),
            broken: refuted.iter().map(|is_refuted| broken(*is_refuted)).collect(),
            ..Engine::default()
        };
        let engines = vec![
            engine("symbolic", &[Verdict::Proved, Verdict::Failed], &[true, false]),
            engine("kani-stand-in", &[Verdict::Tried], &[]),
            engine("kani", &[], &[]),
        ];
        let report = Report { engines, ..Report::default() };
        let text = proved(&report);
        for part in [
            "symbolic       proved 1 of 2; broken ones refuted: 1 of 2",
            "kani-stand-in  tried 1 of 1",
            "kani           not run here",
            "reports/full/proofs.html",
        ] {
            assert!(text.contains(part), "{part}: {text}");
        }
        assert_eq!(short("ü"), "ü");
        assert_eq!(short(&"ü".repeat(200)), "ü".repeat(120) + "…");
    }

    #[test]
    fn a_refutation_shows_claim_rules_inputs_and_the_case() {
        let property = PROPERTIES.iter().find(|property| property.id == "watchdog/deadline").unwrap();
        let found = Found {
            compared: Some("the text says no, the kernel yes".to_owned()),
            vector: Some(json!({ "call": "watchdog.run" })),
            ..found(&[("now", json!(1.0)), ("ttl", json!("NaN"))])
        };
        let text = refutation("enumeration", property, &found);
        for part in [
            "watchdog/deadline",
            property.sentence,
            "NCP-RES-002",
            "fails     alive",
            "the text says no",
            "now = 1.0, ttl = NaN",
            "{\"call\":\"watchdog.run\"}",
        ] {
            assert!(text.contains(part), "{part}: {text}");
        }
    }
}
