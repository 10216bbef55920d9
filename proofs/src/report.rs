//! The report as JSON: each result, and what is wrong with all of them. `page` shows it.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use serde_json::{Value, json};

use crate::engines::{Counterexample, Outcome, native::Drawn};
use crate::properties::{Family, Harness, PROPERTIES};
use crate::vector;

/// Engines whose proofs cover all inputs within the bounds that they state.
const EXHAUSTIVE: [&str; 6] = ["symbolic", "enumeration", "machine", "model", "readers", "kani"];
/// The families of what reads untrusted bytes, which is proved beside the kernel.
const READERS: [&str; 3] = ["bulk", "version", "keys"];
/// How many broken kernels of a family an engine has to refute that covers the family.
const ENOUGH: usize = 5;

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
pub fn outcome(property: &str, harness: &Harness, outcome: &Outcome) -> Value {
    json!({
        "property": property,
        "verdict": outcome.verdict.as_str(),
        "detail": outcome.detail,
        "paths": outcome.paths,
        "obligations": outcome.obligations,
        "true_by_evaluation": outcome.by_evaluation,
        "cross_checked": outcome.cross_checked,
        "runs": outcome.runs,
        "reached": outcome.reached,
        "evidence": outcome.evidence,
        "seconds": whole(outcome.seconds),
        "counterexample": outcome.counterexample.as_ref().map(|found| counterexample(property, harness, found)),
    })
}

/// A counterexample: the check that fails and the inputs, numbers spelled as in the vectors; as a case of a
/// vector too, where a call of the peer protocol shows it.
#[must_use]
pub fn counterexample(property: &str, harness: &Harness, found: &Counterexample) -> Value {
    let inputs = found.inputs.iter().map(|(name, drawn)| {
        let value = match *drawn {
            Drawn::Scalar(x) => vector::number(x),
            Drawn::Seq(seq) => json!(seq),
            Drawn::Choice(way) => json!(way),
        };
        json!([name, value])
    });
    let mut whole = json!({ "check": found.check, "inputs": inputs.collect::<Vec<_>>() });
    match vector::try_case(property, harness, found) {
        Ok(case) => whole["vector"] = case,
        Err(why) => whole["no_vector"] = json!(why.as_str()),
    }
    whole
}

/// The results of an engine that another program has run, from the file that it left.
#[must_use]
pub fn elsewhere(mut head: Value, file: &Path) -> Value {
    let left: Option<Value> = fs::read_to_string(file).ok().and_then(|text| serde_json::from_str(&text).ok());
    let Some(left) = left else {
        head["not_run"] = json!(true);
        return head;
    };
    if left["version"].is_string() {
        head["version"] = left["version"].clone();
    }
    let claims = ["properties", "claims"].map(|name| list(&left[name]));
    let results: Vec<Value> = claims
        .into_iter()
        .flatten()
        .map(|claim| {
            json!({
                "property": claim["id"], "family": claim["family"], "rules": claim["rules"],
                "sentence": claim["sentence"], "statement": claim["formal"], "bounds": claim["bounds"],
                "assumptions": claim["assumptions"], "verdict": claim["result"],
                "detail": word(&claim["why"]), "paths": claim["paths"], "states": claim["states"],
                "obligations": claim["evidence"].as_array().map(Vec::len), "function": claim["function"],
                "seconds": whole(claim["seconds"].as_f64().unwrap_or_default()),
            })
        })
        .collect();
    head["results"] = json!(results);
    head["broken"] = list(&left["broken"])
        .into_iter()
        .map(|broken| {
            let claim = results.iter().find(|claim| claim["property"] == broken["property"]);
            let mut entry = json!({
                "id": broken["id"], "property": broken["property"],
                "family": claim.map(|claim| claim["family"].clone()), "about": broken["about"],
            });
            if broken["refuted"] == true {
                entry["counterexample"] = broken["counterexample"].clone();
                if broken["vector"].is_object() {
                    entry["counterexample"]["vector"] = broken["vector"].clone();
                }
            } else {
                entry["missed"] = json!("no counterexample");
            }
            entry
        })
        .collect();
    for name in ["trusted", "not_proved"] {
        head[name] = left[name].clone();
    }
    head
}

/// Says which version of an engine was run.
pub fn name_version(engines: &mut [Value], name: &str, version: &str) {
    for engine in engines.iter_mut().filter(|engine| engine["name"] == name) {
        engine["version"] = json!(version);
    }
}

/// Takes out of the results what differs from one run to the next: how long it took, and how much the second solver
/// answered within its limit. Of engines that were not run again, it is that of `before`.
pub fn take_run(engines: &mut [Value], before: &Value) -> Value {
    let mut run = serde_json::Map::new();
    for engine in engines {
        let name = word(&engine["name"]);
        let mut mine = serde_json::Map::new();
        // Not by index, which would give results to an engine that was not run.
        let results = engine.get_mut("results").and_then(Value::as_array_mut);
        for result in results.into_iter().flatten() {
            let property = word(&result["property"]);
            let Some(result) = result.as_object_mut() else {
                continue;
            };
            let mut taken = serde_json::Map::new();
            for member in ["seconds", "cross_checked"] {
                let value = result.shift_remove(member);
                taken.extend(value.map(|value| (member.to_owned(), value)));
            }
            let old = || before[&name][&property].clone();
            let taken = if taken.is_empty() { old() } else { taken.into() };
            mine.insert(property, taken);
        }
        run.insert(name, mine.into());
    }
    run.into()
}

/// What is wrong with a report: everything that keeps it from saying that the kernel is proved.
#[must_use]
pub fn problems(report: &Value) -> Vec<String> {
    let engines = list(&report["engines"]);
    let exhaustive = || engines.iter().filter(|engine| EXHAUSTIVE.contains(&&*word(&engine["name"])));
    let results = |engine: &Value| list(&engine["results"]);
    let mut problems = Vec::new();

    for engine in &engines {
        for result in results(engine) {
            let verdict = word(&result["verdict"]);
            if !["proved", "tried"].contains(&&*verdict) {
                let (name, property) = (word(&engine["name"]), word(&result["property"]));
                problems.push(format!("{name}: {property} is {verdict} {}", word(&result["detail"])));
            }
        }
    }
    for property in list(&report["properties"]) {
        let is_mine = |result: &Value| result["property"] == property["id"];
        let is_proved = |result: &Value| is_mine(result) && result["verdict"] == "proved";
        if !exhaustive().any(|engine| results(engine).iter().any(is_proved)) {
            problems.push(format!("{}: no exhaustive engine proves it", word(&property["id"])));
        }
        // [vacuity] What the symbolic engine checks on some path, numbers have to reach.
        let reached = |wanted: &dyn Fn(&str) -> bool| -> BTreeSet<String> {
            let engines = engines.iter().filter(|engine| wanted(&word(&engine["name"])));
            let results = engines.flat_map(results).filter(is_mine);
            results.flat_map(|result| list(&result["reached"])).map(|name| word(&name)).collect()
        };
        let by_terms = reached(&|name| name == "symbolic");
        let by_numbers = reached(&|name| name != "symbolic");
        if by_terms.is_empty() {
            problems.push(format!("{}: no check is reached", word(&property["id"])));
        }
        for check in by_terms.difference(&by_numbers) {
            problems.push(format!("{}: no numbers reach the check {check:?}", word(&property["id"])));
        }
    }
    for family in Family::ALL.map(Family::as_str) {
        let proves = |engine: &&Value| {
            results(engine).iter().any(|result| family_of(result) == family && result["verdict"] == "proved")
        };
        if exhaustive().filter(proves).count() < 2 {
            problems.push(format!("{family}: not proved by two exhaustive engines"));
        }
        for engine in &engines {
            let mine = list(&engine["broken"]).into_iter().filter(|broken| broken["family"] == family);
            let (refuted, missed): (Vec<_>, Vec<_>) = mine.partition(is_refuted);
            if !(refuted.is_empty() && missed.is_empty()) && refuted.len() < ENOUGH {
                problems.push(format!(
                    "{}: refutes only {} broken kernels of {family}",
                    word(&engine["name"]),
                    refuted.len()
                ));
            }
        }
    }
    for family in READERS {
        let is_proved = |result: &Value| family_of(result) == family && result["verdict"] == "proved";
        if !exhaustive().any(|engine| results(engine).iter().any(is_proved)) {
            problems.push(format!("{family}: no exhaustive engine proves it"));
        }
    }
    // A family of an engine's own has broken code that only this engine can refute.
    for engine in exhaustive() {
        let families: BTreeSet<String> = results(engine).iter().map(family_of).collect();
        let is_shared = |family: &str| Family::ALL.iter().any(|known| known.as_str() == family);
        for family in families.iter().filter(|family| !is_shared(family)) {
            let broken = list(&engine["broken"]).into_iter();
            let mine = broken.filter(|broken| broken["family"] == family.as_str());
            let refuted = mine.filter(is_refuted).count();
            if refuted < ENOUGH {
                problems.push(format!("{}: refutes only {refuted} broken ones of {family}", word(&engine["name"])));
            }
        }
    }
    for id in broken_ids(&engines) {
        let refutes = |engine: &Value| list(&engine["broken"]).iter().any(|b| b["id"] == id.as_str() && is_refuted(b));
        if !exhaustive().any(refutes) {
            problems.push(format!("{id}: no exhaustive engine refutes it"));
        }
    }
    problems
}

/// The family of a result: its own word, or the first part of its property.
fn family_of(result: &Value) -> String {
    let named = word(&result["family"]);
    if named.is_empty() {
        let property = word(&result["property"]);
        property.split('/').next().unwrap_or_default().to_owned()
    } else {
        named
    }
}

fn broken_ids(engines: &[Value]) -> BTreeSet<String> {
    engines.iter().flat_map(|engine| list(&engine["broken"])).map(|broken| word(&broken["id"])).collect()
}

pub(crate) fn is_refuted(broken: &Value) -> bool {
    broken["counterexample"].is_object()
}

/// Whole seconds.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn whole(seconds: f64) -> u64 {
    seconds.round() as u64
}

pub(crate) fn word(value: &Value) -> String {
    value.as_str().unwrap_or_default().to_owned()
}

pub(crate) fn list(value: &Value) -> Vec<Value> {
    value.as_array().cloned().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn report(verdict: &str, counterexample: &Value, reached: &[&str]) -> Value {
        let broken: Vec<Value> = Family::ALL
            .iter()
            .flat_map(|family| (0..ENOUGH).map(|nth| (family.as_str(), nth)))
            .map(|(family, nth)| {
                json!({"id": format!("{family}_{nth}"), "family": family, "file": "x.rs", "counterexample": counterexample})
            })
            .collect();
        let results: Vec<Value> = Family::ALL
            .iter()
            .map(|family| json!({"property": format!("{}/p", family.as_str()), "verdict": verdict, "reached": ["a"]}))
            .collect();
        let mut numbers = results.clone();
        numbers.iter_mut().for_each(|result| result["reached"] = json!(reached));
        let properties: Vec<Value> = results.iter().map(|result| json!({"id": result["property"]})).collect();
        let [read, bent] = readers(verdict, counterexample);
        json!({
            "properties": properties,
            "engines": [
                {"name": "symbolic", "results": results, "broken": broken},
                {"name": "enumeration", "results": numbers, "broken": broken},
                {"name": "readers", "results": read, "broken": bent},
            ],
        })
    }

    /// Results of the readers, and broken ones.
    fn readers(verdict: &str, counterexample: &Value) -> [Value; 2] {
        let results =
            READERS.map(|family| json!({"property": format!("{family}/p"), "family": family, "verdict": verdict}));
        let broken = READERS.iter().flat_map(|family| (0..ENOUGH).map(move |nth| (family, nth)));
        let broken = broken.map(|(family, nth)| {
            json!({"id": format!("{family}_{nth}"), "family": family, "counterexample": counterexample})
        });
        [json!(results), broken.collect()]
    }

    #[test]
    fn a_report_is_good_only_when_all_is_proved_refuted_and_reached() {
        assert_eq!(problems(&report("proved", &json!({}), &["a"])), [""; 0]);
        let shows = |report: &Value, what: &str| problems(report).iter().any(|p| p.contains(what));
        assert!(shows(&report("failed", &json!({}), &["a"]), "no exhaustive engine proves it"));
        assert!(shows(&report("tried", &json!({}), &["a"]), "not proved by two"));
        assert!(shows(&report("not run", &json!({}), &["a"]), "is not run"));
        assert!(shows(&report("proved", &Value::Null, &["a"]), "no exhaustive engine refutes it"));
        assert!(shows(&report("proved", &Value::Null, &["a"]), "refutes only 0 broken kernels of clamp"));
        assert!(shows(&report("proved", &Value::Null, &["a"]), "readers: refutes only 0 broken ones of bulk"));
        let mut without_readers = report("proved", &json!({}), &["a"]);
        without_readers["engines"][2] = json!({"name": "readers", "not_run": true});
        assert!(shows(&without_readers, "version: no exhaustive engine proves it"));
        assert!(shows(&report("proved", &json!({}), &[]), "no numbers reach the check \"a\""));
    }

    #[test]
    fn what_differs_from_run_to_run_stands_apart_and_outlives_a_run_of_other_engines() {
        let result = json!({"property": "clamp/bound", "verdict": "proved", "seconds": 7, "cross_checked": 3});
        let mut engines = [json!({"name": "symbolic", "results": [result]})];
        let run = take_run(&mut engines, &Value::Null);
        let taken = json!({"symbolic": {"clamp/bound": {"seconds": 7, "cross_checked": 3}}});
        assert_eq!(run, taken);
        let left = json!([{"property": "clamp/bound", "verdict": "proved"}]);
        assert_eq!(engines[0]["results"], left);
        assert_eq!(take_run(&mut engines, &run), taken);
        let mut absent = [json!({"name": "kani", "not_run": true})];
        take_run(&mut absent, &Value::Null);
        assert!(absent[0].get("results").is_none());
    }

    #[test]
    fn an_engine_that_left_no_file_is_not_run_here() {
        let head = json!({"name": "kani"});
        let engine = elsewhere(head, Path::new("no such file"));
        assert_eq!(engine["not_run"], true);
        assert!(engine["results"].is_null());
    }
}
