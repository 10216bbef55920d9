//! The report as a document: what a reader sees of the results. Nothing is decided here.

use std::collections::BTreeSet;

use serde_json::Value;

use crate::document::Block;
use crate::report::{is_refuted, list, word};

/// The report as a document.
#[must_use]
pub fn document(report: &Value) -> Vec<Block> {
    let engines = list(&report["engines"]);
    let mut blocks = vec![
        heading(1, "top", "Proofs of the safety kernel"),
        text(
            "What is claimed of the code that decides whether a plant moves; by which engine, within which bounds and under which assumptions it was shown; and how to repeat it. \"proved\" is said of engines that cover every case within the stated bounds, and of nothing else.",
        ),
        text(&format!(
            "Digest of the kernel's sources and of the harnesses (SHA-256): `{}`",
            word(&report["digest"])
        )),
        text(
            "[Properties](#properties) · [Engines](#engines) · [Broken kernels](#broken) · [Each property](#each) · [What is trusted](#trusted) · [What is not proved](#not-proved) · [Repeat it](#repeat)",
        ),
    ];
    let problems = list(&report["problems"]);
    if problems.is_empty() {
        blocks.push(text("Every property is proved by an exhaustive engine, every family by two; every broken kernel is refuted."));
    } else {
        blocks.push(text("Not everything is shown:"));
        blocks.push(Block::List(problems.iter().map(word).collect()));
    }
    blocks.push(heading(2, "properties", "Properties and engines"));
    blocks.push(overview(report, &engines));
    blocks.push(heading(2, "engines", "Engines"));
    blocks.push(engine_table(&engines));
    blocks.push(heading(2, "broken", "Broken kernels"));
    blocks.push(text("Copies of the kernel's source with one change each. An engine that would prove anything does not refute them. Each counterexample was replayed on doubles. A dash: the engine does not cover the property."));
    blocks.push(broken_table(&engines));
    blocks.push(heading(2, "each", "Each property"));
    for property in list(&report["properties"]) {
        each(&property, &engines, &mut blocks);
    }
    for engine in &engines {
        own_claims(report, engine, &mut blocks);
    }
    blocks.push(heading(2, "trusted", "What is trusted"));
    blocks.push(points(TRUSTED, &engines, "trusted"));
    blocks.push(heading(2, "not-proved", "What is not proved"));
    blocks.push(points(NOT_PROVED, &engines, "not_proved"));
    blocks.push(heading(2, "repeat", "Repeat it"));
    blocks.push(text("All of it, from the root of the repository: `cargo xtask prove`. One file of obligations, with a stock solver; every line of the answer has to be `unsat`, as many as the head of the file says:"));
    blocks.push(Block::Code(
        "python3 -m venv venv && venv/bin/pip install bitwuzla==0.9.1 z3-solver\nvenv/bin/python proofs/solve.py proofs/evidence/watchdog/deadline/001.smt2\nvenv/bin/z3 proofs/evidence/watchdog/deadline/001.smt2\nbitwuzla proofs/evidence/watchdog/deadline/001.smt2     # where bitwuzla's own program is installed".to_owned(),
    ));
    blocks
}

const TRUSTED: &[&str] = &[
    "rustc and the processor: that the program does what its source says, and that doubles are IEEE 754 binary64 with rounding to nearest. The machine-code engine, where it was run, narrows this to its lifter.",
    "The harnesses: that they say what the text says. Each sentence and formula stands here beside its rules.",
    "The harness's own model: `watchdog/step`, `latch/gates` and `latch/plant` compare the kernel with a model of a few lines within the harness.",
    "The symbolic scalar: that its terms mean in SMT-LIB what the operations of `f64` do, that both ways of every comparison are run, and the writer of the obligations. Refuting the broken kernels exercises all of that.",
    "The rule that drops decisions: a question to the solver keeps only those decisions of its path that its check mentions. With fewer decisions the question claims more, so `unsat` stays a proof; where the answer is `sat`, each path is asked again with all its decisions.",
    "A comparison that follows from those decided before (a < b excludes b ≤ a) is not asked again.",
    "bitwuzla's library. z3 answers the same obligations within a limit of its own steps and has not contradicted it; how many it answered stands with each property.",
    "What calls the kernel: that `ActionBuffer` and `SafetyGovernor` ask it and do what it says. Tests and vectors cover that, no proof here.",
];
const NOT_PROVED: &[&str] = &[
    "Positions against real arithmetic: NCP-SAFE-054 speaks of a plant that follows a command exactly; the proof is about positions as computed in doubles.",
    "Anything beyond the bounds: horizons of more steps, longer sequences, wider vectors, more channels than each property states, except where it says that it holds by induction.",
    "What the enumeration says it proves is proved for the listed values only.",
    "Liveness: that something moves at last. The properties say when the plant must hold and when it may move.",
];

fn overview(report: &Value, engines: &[Value]) -> Block {
    let mut head = vec!["property".to_owned()];
    head.extend(engines.iter().map(|engine| word(&engine["name"])));
    let rows = list(&report["properties"])
        .iter()
        .map(|property| {
            let id = word(&property["id"]);
            let mut row = vec![format!("[{id}](#{})", anchor(&id))];
            row.extend(engines.iter().map(|engine| {
                let results = list(&engine["results"]);
                let mine = results
                    .iter()
                    .find(|result| result["property"] == property["id"]);
                match mine {
                    Some(result) => {
                        format!("{}, {} s", word(&result["verdict"]), result["seconds"])
                    }
                    None if engine["not_run"] == true => "not run here".to_owned(),
                    None if has_own_claims(engine) => {
                        "[own claims](#".to_owned() + &word(&engine["name"]) + ")"
                    }
                    None => "–".to_owned(),
                }
            }));
            row
        })
        .collect();
    Block::Table(head, rows)
}

/// Whether an engine was held against other properties than the shared ones.
fn has_own_claims(engine: &Value) -> bool {
    list(&engine["results"])
        .iter()
        .any(|result| result["sentence"].is_string())
}

fn engine_table(engines: &[Value]) -> Block {
    let rows = engines
        .iter()
        .map(|engine| {
            let broken = list(&engine["broken"]);
            let refuted = broken.iter().filter(|broken| is_refuted(broken)).count();
            let what = if engine["not_run"] == true {
                "not run here".to_owned()
            } else {
                format!("refuted {refuted} of {}", broken.len())
            };
            vec![
                word(&engine["name"]),
                word(&engine["version"]),
                word(&engine["about"]),
                what,
            ]
        })
        .collect();
    let head = ["engine", "version", "what it does", "broken kernels"];
    Block::Table(head.map(str::to_owned).to_vec(), rows)
}

fn broken_table(engines: &[Value]) -> Block {
    let shared = |engine: &&Value| {
        list(&engine["broken"])
            .iter()
            .any(|broken| broken["file"].is_string())
    };
    let engines: Vec<&Value> = engines.iter().filter(shared).collect();
    let mut head = vec!["broken kernel".to_owned(), "change".to_owned()];
    head.extend(engines.iter().map(|engine| word(&engine["name"])));
    let first: Vec<Value> = engines
        .first()
        .map(|engine| list(&engine["broken"]))
        .unwrap_or_default();
    let rows = first
        .iter()
        .map(|broken| {
            let mut row = vec![word(&broken["id"]), change(broken)];
            row.extend(engines.iter().map(|engine| {
                let all = list(&engine["broken"]);
                match all.iter().find(|other| other["id"] == broken["id"]) {
                    Some(other) if is_refuted(other) => "refuted".to_owned(),
                    Some(_) => "not seen".to_owned(),
                    None => "–".to_owned(),
                }
            }));
            row
        })
        .collect();
    Block::Table(head, rows)
}

fn each(property: &Value, engines: &[Value], blocks: &mut Vec<Block>) {
    let id = word(&property["id"]);
    blocks.push(heading(3, &anchor(&id), &id));
    claim(property, blocks);
    let mut shown = Vec::new();
    for engine in engines {
        for result in list(&engine["results"]) {
            if result["property"] == property["id"] {
                shown.push(said(engine, &result));
            }
        }
    }
    blocks.push(Block::List(shown));
    let files: Vec<String> = engines
        .iter()
        .flat_map(|engine| list(&engine["results"]))
        .filter(|result| result["property"] == property["id"])
        .flat_map(|result| list(&result["evidence"]))
        .map(|file| format!("[{0}](../proofs/evidence/{0})", word(&file)))
        .collect();
    if !files.is_empty() {
        blocks.push(text(&format!("Obligations: {}", files.join(", "))));
    }
    let mut refuted: Vec<(String, String, String, String)> = Vec::new();
    for engine in engines {
        for broken in list(&engine["broken"]) {
            if broken["property"] == property["id"]
                && is_refuted(&broken)
                && broken["file"].is_string()
            {
                let name = word(&broken["id"]);
                let seen = refuted.iter().position(|(known, ..)| *known == name);
                let found = shown_counterexample(&broken["counterexample"]);
                match seen {
                    Some(_) => {}
                    None => refuted.push((name, change(&broken), word(&engine["name"]), found)),
                }
            }
        }
    }
    if !refuted.is_empty() {
        let head = [
            "broken kernel",
            "change",
            "first refuted by",
            "counterexample",
        ];
        let rows = refuted
            .into_iter()
            .map(|(a, b, c, d)| vec![a, b, c, d])
            .collect();
        let title = "Broken kernels that it refutes".to_owned();
        let table = Block::Table(head.map(str::to_owned).to_vec(), rows);
        blocks.push(Block::Details(title, vec![table]));
    }
}

/// Claims that an engine makes beside the shared properties.
fn own_claims(report: &Value, engine: &Value, blocks: &mut Vec<Block>) {
    let shared: BTreeSet<String> = list(&report["properties"])
        .iter()
        .map(|p| word(&p["id"]))
        .collect();
    let results = list(&engine["results"]);
    let own: Vec<&Value> = results
        .iter()
        .filter(|r| !shared.contains(&word(&r["property"])))
        .collect();
    if own.is_empty() {
        return;
    }
    let name = word(&engine["name"]);
    blocks.push(heading(2, &name, &format!("Claims of the engine {name}")));
    blocks.push(text(&word(&engine["about"])));
    for result in own {
        blocks.push(heading(
            3,
            &format!("{name}-{}", anchor(&word(&result["property"]))),
            &word(&result["property"]),
        ));
        claim(result, blocks);
        blocks.push(Block::List(vec![said(engine, result)]));
    }
    let rows: Vec<Vec<String>> = list(&engine["broken"])
        .iter()
        .map(|broken| {
            let how = if is_refuted(broken) {
                shown_counterexample(&broken["counterexample"])
            } else {
                "NOT REFUTED".to_owned()
            };
            vec![
                word(&broken["id"]),
                word(&broken["property"]),
                word(&broken["about"]),
                how,
            ]
        })
        .collect();
    let head = ["broken", "by", "what is wrong", "counterexample"];
    let table = Block::Table(head.map(str::to_owned).to_vec(), rows);
    blocks.push(Block::Details("What it refutes".to_owned(), vec![table]));
}

/// The sentence, the formula, the rules, the bounds and the assumptions of a claim.
fn claim(claim: &Value, blocks: &mut Vec<Block>) {
    blocks.push(text(&word(&claim["sentence"])));
    blocks.push(Block::Code(word(&claim["statement"])));
    let rules: Vec<String> = list(&claim["rules"]).iter().map(word).collect();
    let mut facts = vec![
        format!("rules: {}", rules.join(", ")),
        format!("bounds: {}", word(&claim["bounds"])),
    ];
    facts.extend(
        list(&claim["assumptions"])
            .iter()
            .map(|a| format!("assumed: {}", word(a))),
    );
    blocks.push(Block::List(facts));
}

/// What an engine says of a claim, with its numbers.
fn said(engine: &Value, result: &Value) -> String {
    let mut numbers = Vec::new();
    for (name, what) in [
        ("paths", "paths"),
        ("states", "states"),
        ("obligations", "obligations"),
        ("cross_checked", "of them also answered by z3"),
        ("true_by_evaluation", "checks true by evaluation"),
        ("runs", "runs"),
    ] {
        if let Some(count) = result[name].as_u64().filter(|count| *count > 0) {
            numbers.push(format!("{count} {what}"));
        }
    }
    numbers.push(format!("{} s", result["seconds"]));
    format!(
        "{}: {}; {} {}",
        word(&engine["name"]),
        word(&result["verdict"]),
        numbers.join(", "),
        word(&result["detail"])
    )
    .trim_end()
    .to_owned()
}

fn shown_counterexample(found: &Value) -> String {
    if found["vector"].is_object() {
        let vector = &found["vector"];
        return format!(
            "`{}` `{}` expects `{}`",
            word(&vector["call"]),
            vector["args"],
            vector["expect"]
        );
    }
    if found["inputs"].is_array() {
        let inputs: Vec<String> = list(&found["inputs"])
            .iter()
            .map(|input| format!("{} = {}", word(&input[0]), input[1]))
            .collect();
        return format!("{}: `{}`", word(&found["check"]), inputs.join(", "));
    }
    format!("`{found}`")
}

/// The change that makes a broken kernel.
fn change(broken: &Value) -> String {
    let flat = |value: &Value| word(value).split_whitespace().collect::<Vec<_>>().join(" ");
    format!(
        "{}: `{}` → `{}`",
        word(&broken["file"]),
        flat(&broken["from"]),
        flat(&broken["to"])
    )
}

fn points(fixed: &[&str], engines: &[Value], member: &str) -> Block {
    let mut items: Vec<String> = fixed.iter().map(|item| (*item).to_owned()).collect();
    for engine in engines {
        let name = word(&engine["name"]);
        if engine["not_run"] == true && member == "not_proved" {
            items.push(format!("{name}: not run here. {}", word(&engine["about"])));
        }
        items.extend(
            list(&engine[member])
                .iter()
                .map(|item| format!("{name}: {}", word(item))),
        );
    }
    Block::List(items)
}

fn heading(level: u8, name: &str, title: &str) -> Block {
    Block::Heading(level, name.to_owned(), title.to_owned())
}

fn text(words: &str) -> Block {
    Block::Text(words.to_owned())
}

fn anchor(id: &str) -> String {
    id.replace('/', "-")
}
