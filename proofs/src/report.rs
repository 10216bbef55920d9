//! The report: one result, written as JSON, and rendered from that as Markdown and HTML.

use std::fmt::Write;

use serde_json::{Value, json};

use crate::engines::{Counterexample, Outcome, native::Drawn};
use crate::properties::PROPERTIES;

/// The table of the properties.
#[must_use]
pub fn properties() -> Value {
    PROPERTIES
        .iter()
        .map(|p| {
            json!({
                "id": p.id, "family": p.family.as_str(), "rules": p.rules, "sentence": p.sentence,
                "statement": p.statement, "bounds": p.bounds, "assumptions": p.assumptions,
            })
        })
        .collect()
}

/// One result of an engine.
#[must_use]
pub fn outcome(property: &str, outcome: &Outcome) -> Value {
    json!({
        "property": property,
        "verdict": outcome.verdict.as_str(),
        "detail": outcome.detail,
        "paths": outcome.paths,
        "obligations": outcome.obligations,
        "true_by_evaluation": outcome.by_evaluation,
        "cross_checked": outcome.cross_checked,
        "runs": outcome.runs,
        "evidence": outcome.evidence,
        "seconds": (outcome.seconds * 10.0).round() / 10.0,
        "counterexample": outcome.counterexample.as_ref().map(counterexample),
    })
}

/// A counterexample: the check that fails and the inputs, numbers spelled as in the vectors.
#[must_use]
pub fn counterexample(found: &Counterexample) -> Value {
    let inputs = found.inputs.iter().map(|(name, drawn)| {
        let value = match *drawn {
            Drawn::Scalar(x) if x.is_nan() => json!("NaN"),
            Drawn::Scalar(x) if x.is_infinite() => {
                json!(if x > 0.0 { "Infinity" } else { "-Infinity" })
            }
            Drawn::Scalar(x) if x == 0.0 && x.is_sign_negative() => json!("-0"),
            Drawn::Scalar(x) => json!(x),
            Drawn::Seq(seq) => json!(seq),
            Drawn::Choice(way) => json!(way),
        };
        json!([name, value])
    });
    json!({ "check": found.check, "inputs": inputs.collect::<Vec<_>>() })
}

/// The report as Markdown, rendered from its JSON.
#[must_use]
pub fn markdown(report: &Value) -> String {
    let mut text = String::from("# Proofs of the safety kernel\n\n");
    let word = |value: &Value| value.as_str().unwrap_or_default().to_owned();
    let list = |value: &Value| value.as_array().cloned().unwrap_or_default();
    let engines = list(&report["engines"]);
    let _ = writeln!(
        text,
        "Digest of the code and the harnesses (SHA-256): `{}`\n\nRepeat all: `cargo xtask prove`. Repeat one file of obligations with a stock solver: `z3 proofs/evidence/<file>`, or `python proofs/solve.py proofs/evidence/<file>` with the package `bitwuzla` 0.9.1; each line has to be `unsat`.\n",
        word(&report["digest"])
    );
    text.push_str("## Properties and engines\n\n| property |");
    for engine in &engines {
        let _ = write!(text, " {} |", word(&engine["name"]));
    }
    text.push_str("\n|---|");
    text.push_str(&"---|".repeat(engines.len()));
    text.push('\n');
    for property in list(&report["properties"]) {
        let id = word(&property["id"]);
        let _ = write!(text, "| {id} |");
        for engine in &engines {
            let results = list(&engine["results"]);
            let result = results
                .iter()
                .find(|result| result["property"] == id.as_str());
            let cell = result.map_or_else(|| "–".to_owned(), |result| word(&result["verdict"]));
            let _ = write!(text, " {cell} |");
        }
        text.push('\n');
    }
    text.push_str("\n## Engines\n\n");
    for engine in &engines {
        let broken = list(&engine["broken"]);
        let refuted = broken
            .iter()
            .filter(|b| !b["counterexample"].is_null())
            .count();
        let _ = writeln!(
            text,
            "- **{}** ({}): {} Broken kernels refuted: {refuted} of {}.",
            word(&engine["name"]),
            word(&engine["version"]),
            word(&engine["about"]),
            broken.len()
        );
    }
    text.push_str("\n## The properties\n");
    for property in list(&report["properties"]) {
        let id = word(&property["id"]);
        let rules: Vec<String> = list(&property["rules"]).iter().map(&word).collect();
        let _ = writeln!(
            text,
            "\n### {id}\n\n{}\n\n`{}`\n\n- rules: {}\n- bounds: {}",
            word(&property["sentence"]),
            word(&property["statement"]),
            rules.join(", "),
            word(&property["bounds"])
        );
        for assumption in list(&property["assumptions"]) {
            let _ = writeln!(text, "- assumed: {}", word(&assumption));
        }
        for engine in &engines {
            for result in list(&engine["results"]) {
                if result["property"] == id.as_str() {
                    let _ = writeln!(
                        text,
                        "- {}: {}; {} paths, {} obligations ({} also by z3), {} checks true by evaluation, {} runs, {} s {}",
                        word(&engine["name"]),
                        word(&result["verdict"]),
                        result["paths"],
                        result["obligations"],
                        result["cross_checked"],
                        result["true_by_evaluation"],
                        result["runs"],
                        result["seconds"],
                        word(&result["detail"])
                    );
                }
            }
            for broken in list(&engine["broken"]) {
                if broken["property"] == id.as_str() {
                    let _ = writeln!(
                        text,
                        "- {}, broken kernel `{}` ({}: `{}` → `{}`): {}",
                        word(&engine["name"]),
                        word(&broken["id"]),
                        word(&broken["file"]),
                        word(&broken["from"]).replace('\n', " "),
                        word(&broken["to"]).replace('\n', " "),
                        if broken["counterexample"].is_null() {
                            "NOT REFUTED".to_owned()
                        } else {
                            format!("refuted, {}", broken["counterexample"])
                        }
                    );
                }
            }
        }
    }
    text.push_str(TRUSTED);
    text
}

const TRUSTED: &str = "
## What is trusted

- The Rust compiler, and that the doubles of the machine are IEEE 754 binary64 with rounding to nearest.
- The symbolic scalar: that its terms mean in SMT-LIB what the operations of `f64` do, that both ways of every comparison are run, and the writer of the obligations. The broken kernels, whose models are replayed on doubles, test all of that.
- bitwuzla. z3 answers the same obligations within a limit, and has not contradicted it; how many it answered stands with each property.
- The harnesses: that they say what the text says. Each sentence stands beside its formula here.
- The one thing that the kernel's callers do: that `ActionBuffer` and `SafetyGovernor` ask the kernel and do what it says. Tests and vectors cover that, and no proof here.

## What is not proved

- Rounding of the projection against real arithmetic (NCP-SAFE-054 speaks of a plant that follows a command exactly; the proof is about the positions as computed in doubles).
- Horizons of more steps, sequences of more events and vectors of more components than the bounds say, except where a property says that it holds by induction.
- What reads frames: JSON, keys, versions and BulkBlock. Tests, vectors and fuzzing stand for those.
- Kani: not run here. Its harnesses are the same bodies; the stand-in runs them on samples, which proves nothing.
";

/// The report as HTML, rendered from the same Markdown as preformatted text.
#[must_use]
pub fn html(report: &Value) -> String {
    let text = markdown(report)
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;");
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>Proofs of the safety kernel</title>\n<style>body{{max-width:110ch;margin:2em auto}}pre{{white-space:pre-wrap}}</style>\n<pre>\n{text}</pre>\n</html>\n"
    )
}
