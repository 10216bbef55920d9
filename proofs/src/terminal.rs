//! What a person reads on the terminal when the kernel is refuted.

use std::fmt::Write;

use serde_json::{Value, json};

use crate::properties::Property;

const RULE: &str = "================================================================================";

/// A counterexample to a property of the kernel, for someone who has just changed it.
#[must_use]
pub fn refutation(engine: &str, property: &Property, found: &Value) -> String {
    let mut text = format!("\n{RULE}\nTHE KERNEL IS REFUTED: {}\n", property.id);
    let mut line = |name: &str, value: &str| {
        let _ = writeln!(text, "  {name:9} {value}");
    };
    line("claim", property.sentence);
    line("rules", &property.rules.join(", "));
    line("fails", found["check"].as_str().unwrap_or_default());
    if let Some(compared) = found["compared"].as_str() {
        line("answers", compared);
    }
    line("inputs", &inputs(found));
    line("found by", engine);
    if found["vector"].is_object() {
        line("as a case of a vector", "");
        line("", &found["vector"].to_string());
    }
    text + RULE + "\n"
}

/// The inputs of a counterexample in one line.
#[must_use]
pub fn inputs(found: &Value) -> String {
    let pairs = found["inputs"].as_array().into_iter().flatten();
    let pairs = pairs.map(|pair| {
        let value = match &pair[1] {
            Value::String(word) => word.clone(),
            value => value.to_string(),
        };
        format!("{} = {value}", pair[0].as_str().unwrap_or_default())
    });
    let pairs: Vec<String> = pairs.collect();
    if pairs.is_empty() { "none".to_owned() } else { pairs.join(", ") }
}

/// The end of a run in which the kernel was refuted: which properties, and what to do.
#[must_use]
pub fn summary(refuted: &[String]) -> String {
    format!(
        "\n{RULE}\nFAILED: the kernel in spec/src/safety/kernel does not do what the text says.\n  \
         refuted   {}\n  {SKIPPED}\n  \
         to do     mend the kernel, and run this again; each counterexample stands above and in\n            \
         reports/proofs.md. If the change is wanted, the text's rules and the harnesses in\n            \
         proofs/src/properties have to say so first.\n{RULE}",
        refuted.join(", ")
    )
}

/// The end of a run without a problem: what each engine did, and where to read of it.
#[must_use]
pub fn proved(report: &Value) -> String {
    let mut text = format!("\n{RULE}\nPROVED: the kernel does what the text says, as far as the report says.\n");
    for engine in report["engines"].as_array().into_iter().flatten() {
        let (name, done) = (engine["name"].as_str().unwrap_or_default(), count(engine));
        let _ = writeln!(text, "  {name:14} {done}");
    }
    let _ = writeln!(text, "  {:14} reports/proofs.html, .md, .json", "to read");
    text + RULE
}

/// How many properties of how many an engine has proved or tried, and how many broken kernels refuted.
fn count(engine: &Value) -> String {
    let results = engine["results"].as_array().map_or(&[][..], Vec::as_slice);
    if results.is_empty() {
        return "not run here".to_owned();
    }
    let of = |word: &str| results.iter().filter(|result| result["verdict"] == word).count();
    let (proved, tried) = (of("proved"), of("tried"));
    let (word, good) = if tried > 0 { ("tried", tried) } else { ("proved", proved) };
    let broken = engine["broken"].as_array().map_or(&[][..], Vec::as_slice);
    let refuted = broken.iter().filter(|broken| broken["missed"].is_null()).count();
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
pub const SKIPPED: &str = "skipped   what would mean nothing now: the other properties by the slow engines, the broken\n            kernels, and, where they come later, the model and the machine code";

/// A problem of a report: a property that is refuted.
#[must_use]
pub fn problem(engine: &str, property: &str, found: &Value) -> String {
    let check = found["check"].as_str().unwrap_or_default();
    format!("{property} is refuted by {engine}: {check}: {}", inputs(found))
}

/// The counterexample with what the kernel answered and what the text says.
#[must_use]
pub fn with_compared(mut found: Value, compared: Option<String>) -> Value {
    if let Some(compared) = compared {
        found["compared"] = json!(compared);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::properties::PROPERTIES;

    #[test]
    fn the_end_of_a_good_run_counts_for_each_engine_and_names_those_that_did_not_run() {
        let report = json!({"engines": [
            {"name": "symbolic", "results": [{"verdict": "proved"}, {"verdict": "failed"}],
             "broken": [{"counterexample": {}}, {"missed": "no counterexample"}]},
            {"name": "kani-stand-in", "results": [{"verdict": "tried"}], "broken": []},
            {"name": "kani", "results": []},
        ]});
        let text = proved(&report);
        for part in [
            "symbolic       proved 1 of 2; broken ones refuted: 1 of 2",
            "kani-stand-in  tried 1 of 1",
            "kani           not run here",
            "reports/proofs.html",
        ] {
            assert!(text.contains(part), "{part}: {text}");
        }
        assert_eq!(short("ü"), "ü");
        assert_eq!(short(&"ü".repeat(200)), "ü".repeat(120) + "…");
    }

    #[test]
    fn a_refutation_shows_claim_rules_inputs_and_the_case() {
        let property = PROPERTIES.iter().find(|property| property.id == "watchdog/deadline").unwrap();
        let found = json!({
            "check": "alive", "inputs": [["now", 1.0], ["ttl", "NaN"]], "vector": {"call": "watchdog.run"},
            "compared": "the text says no, the kernel yes",
        });
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
