//! The report as a document: what a reader sees of the results. Nothing is decided here.

use std::collections::{BTreeMap, BTreeSet};

use serde_json::{Value, json};

use crate::document::Block;
use crate::engines::symbolic::Origin;

/// The report as a document.
#[must_use]
pub fn document(report: &Value) -> Vec<Block> {
    let engines = list(&report["engines"]);
    let mut blocks = vec![
        heading(1, "top", "Proofs of the safety kernel"),
        text(
            "What is claimed of the code that decides whether a plant moves, and of the code that reads untrusted bytes; by which engine, within which bounds and under which assumptions it was shown; and how to repeat it. \"proved\" is said of engines that cover every case within the stated bounds, and of nothing else.",
        ),
        text(&format!(
            "Digest of the sources: of what is proved, of what proves it, and of what decides whether it is (SHA-256): `{}`. `cargo xtask test --only proofs-fresh` compares it with the sources as they are.",
            word(&report["digest"])
        )),
        text(
            "[Properties](#properties) · [Engines](#engines) · [Broken kernels](#broken) · [Each property](#each) · [What is trusted](#trusted) · [What is not proved](#not-proved) · [Repeat it](#repeat) · [This run](#run)",
        ),
    ];
    let problems = list(&report["problems"]);
    if problems.is_empty() {
        blocks.push(text("Every property is proved by an exhaustive engine, every family of the kernel by two; every broken kernel and every broken reader is refuted."));
    } else {
        blocks.push(text("Not everything is shown:"));
        blocks.push(Block::List(problems.iter().map(word).collect()));
    }
    blocks.push(heading(2, "properties", "Properties and engines"));
    blocks.extend(overview(report, &engines));
    blocks.push(heading(2, "engines", "Engines"));
    blocks.push(engine_table(&engines));
    broken_kernels(&engines, &mut blocks);
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
    blocks.push(text("All of it, from the root of the repository: `cargo xtask prove`; one engine: `cargo xtask prove --engine symbolic`. One file of obligations, with a stock solver; every line of the answer has to be `unsat`, as many as the head of the file says:"));
    blocks.push(Block::Code(
        "python3 -m venv venv && venv/bin/pip install bitwuzla==0.9.1 z3-solver==5.4.0.0\nvenv/bin/python proofs/evidence/solve.py proofs/evidence/watchdog/deadline/001.smt2\nvenv/bin/z3 proofs/evidence/watchdog/deadline/001.smt2\nbitwuzla proofs/evidence/watchdog/deadline/001.smt2     # where bitwuzla's own program is installed".to_owned(),
    ));
    blocks.push(text("The engine of the machine code leaves no files. It writes its obligations, of one property or of all, for any solver with floating point:"));
    blocks.push(Block::Code(
        "proofs/machine/prove.sh --only machine/within-deadline --no-broken --evidence obligations\nbitwuzla obligations/machine-within-deadline-paths-from-0.smt2                     # or z3".to_owned(),
    ));
    blocks.push(text("The model and the readers leave no obligations either: they run the code on each of their cases. `cargo run --release -p ncp-model -- --json model.json`, `cargo run --release -p ncp-readers --features broken -- --json readers.json`."));
    this_run(&report["run"], &engines, &mut blocks);
    blocks
}

const TRUSTED: &[&str] = &[
    "The text as it was put into sentences, and the sentences as they were put into formulas and harnesses: that they say what the rules say. Each stands here beside its rules, so that a reader can compare.",
    "rustc and LLVM, and the processor: that the program does what its source says, and that doubles are IEEE 754 binary64 with rounding to nearest. The machine-code engine, where it was run, narrows this to its lifter, for one build by one compiler.",
    "The square root: `f64::sqrt`, which IEEE 754 rounds correctly and which x86-64 and AArch64 have as an instruction. No other function of a mathematical library is used; `f64::floor`, the absolute value and the saturating conversion to an index are Rust's own.",
    "The harness's own model: `watchdog/step`, `latch/gates` and `latch/plant` compare the kernel with a model of a few lines within the harness.",
    "The kernel's source is generic over its numbers, and production runs it on `f64` and `i64`: that the few lines which map `Scalar` and `Seq` to these (`scalar.rs`) do so. The engines on doubles and the machine code run them; the symbolic engine does not.",
    "The symbolic scalar: that its terms mean in SMT-LIB what the operations of `f64` do, that both ways of every comparison are run, and the writer of the obligations. Refuting the broken kernels exercises all of that.",
    "The rule that drops decisions: a question to the solver keeps only those decisions of its path that its check mentions. With fewer decisions the question claims more, so `unsat` stays a proof; where the answer is `sat`, each path is asked again with all its decisions.",
    "A comparison that follows from those decided before (a < b excludes b ≤ a) is not asked again.",
    "The solvers: that bitwuzla's `unsat` is right. It leaves no certificate that another program could check. z3 is asked the same within a limit of its own steps and has not contradicted it; what it did not answer rests on bitwuzla alone, and [this run](#run) counts both.",
    "The programs of this project that run the engines, read their answers and write this report; and that the broken copies are the kernel with that one change, which the build script makes.",
    "What calls the kernel: that `ActionBuffer` and `SafetyGovernor` ask it and do what it says. The model explores both within its bounds; tests and vectors cover the rest.",
];
const NOT_PROVED: &[&str] = &[
    "Anything about the world: that a number which is called metres, seconds or metres per second is one, that a sensor tells the truth, that a clock runs, that a plant follows its command. The proofs are about doubles.",
    "Positions against real arithmetic: NCP-SAFE-054 speaks of a plant that follows a command exactly; the proof is about positions as computed in doubles.",
    "Anything beyond the bounds: horizons of more steps, longer sequences, wider vectors, more channels than each property states, except where it says that it holds by induction.",
    "What the enumeration says it proves is proved for the listed values only.",
    "What the stand-in for Kani tried is no proof: it runs the harnesses on edges and samples.",
    "Liveness: that something moves at last. The properties say when the plant must hold and when it may move.",
    "Time and memory: how long the kernel takes, and that it is called in time.",
    "Other implementations. A peer is held to the text by the vectors and the scenarios, and proved by nothing here.",
];

/// The broken copies: how many, by whom they are refuted, and which print a vector.
fn broken_kernels(engines: &[Value], blocks: &mut Vec<Block>) {
    blocks.push(heading(2, "broken", "Broken kernels"));
    blocks.push(text("Copies of the source with one change each: an engine that would prove anything does not refute them. Each counterexample was run again, natively: the broken kernel fails the check. Those of the symbolic engine come from one of two places, and each says from which: a model of bitwuzla; or inputs that broke the harness on doubles, of samples or of the enumeration, for which bitwuzla confirmed with the inputs fixed that the question which they raise is satisfiable. A dash: the engine does not cover the property."));
    let rows = broken_rows(engines);
    let kinds = [Origin::Model, Origin::Sampled, Origin::Enumerated];
    let mut origins: BTreeMap<String, usize> = kinds.map(|kind| (kind.as_str().to_owned(), 0)).into();
    let all = engines.iter().flat_map(|engine| list(&engine["broken"]));
    for broken in all {
        if let Some(origin) = broken["counterexample"]["found_by"].as_str() {
            *origins.entry(origin.to_owned()).or_default() += 1;
        }
    }
    let origins = origins.iter();
    let mut facts: Vec<String> = origins.map(|(origin, count)| format!("symbolic: {count} by {origin}")).collect();
    let shown = |broken: &&Value| broken["counterexample"]["vector"].is_object();
    let (mut with, mut without) = (0, BTreeMap::<String, Vec<String>>::new());
    for broken in first_refutations(engines) {
        if shown(&&broken) {
            with += 1;
        } else {
            let why = word(&broken["counterexample"]["no_vector"]);
            without.entry(why).or_default().push(word(&broken["id"]));
        }
    }
    let count = with + without.values().map(Vec::len).sum::<usize>();
    facts.push(format!(
        "{with} of {count} refuted broken kernels print a counterexample as a vector: a call of [the peer protocol](../peers/PROTOCOL.md) that a peer with this defect fails, and that expects what the executable specification answers"
    ));
    facts.extend(without.into_iter().map(|(why, ids)| {
        let ids: Vec<String> = ids.iter().map(|id| format!("`{id}`")).collect();
        format!("no vector, as {why}: {}", ids.join(", "))
    }));
    blocks.push(Block::List(facts));
    let title = format!("All {} broken kernels, and who refutes them", rows.1.len());
    blocks.push(Block::Details(title, vec![Block::Table(rows.0, rows.1)]));
}

/// Each broken kernel with the best of its refutations: one that prints a vector, if there is one.
fn first_refutations(engines: &[Value]) -> Vec<Value> {
    let mut found: Vec<Value> = Vec::new();
    for engine in engines {
        for mut broken in list(&engine["broken"]) {
            if !is_refuted(&broken) || !broken["file"].is_string() {
                continue;
            }
            broken["by"] = json!([engine["name"]]);
            match found.iter_mut().find(|known| known["id"] == broken["id"]) {
                None => found.push(broken),
                Some(known) => {
                    let mut by = list(&known["by"]);
                    by.push(engine["name"].clone());
                    let had = known["counterexample"]["vector"].is_object();
                    if !had && broken["counterexample"]["vector"].is_object() {
                        *known = broken;
                    }
                    known["by"] = json!(by);
                }
            }
        }
    }
    found
}

/// What differs from run to run.
fn this_run(run: &Value, engines: &[Value], blocks: &mut Vec<Block>) {
    blocks.push(heading(2, "run", "This run: times and cross-check"));
    blocks.push(text("What differs from one run to the next on the same sources, and on other machines: how long each property took, in seconds, and how many of the obligations z3 answered within its limit, each of them as bitwuzla did. The engine of the machine code has limits by the clock: on a busy machine another of its solvers may answer first, whose counterexample may be another one, or none in time."));
    let mut rows = Vec::new();
    for engine in engines {
        let name = word(&engine["name"]);
        for result in list(&engine["results"]) {
            let property = word(&result["property"]);
            let mine = &run[&name][&property];
            let z3 = match (mine["cross_checked"].as_u64(), result["obligations"].as_u64()) {
                (Some(some), Some(all)) if all > 0 && name == "symbolic" => {
                    format!("{some} of {all}")
                }
                _ => "–".to_owned(),
            };
            rows.push(vec![property, name.clone(), mine["seconds"].to_string(), z3]);
        }
    }
    let head = ["property", "engine", "seconds", "also answered by z3"];
    let table = Block::Table(head.map(str::to_owned).to_vec(), rows);
    blocks.push(Block::Details("Each property".to_owned(), vec![table]));
}

fn overview(report: &Value, engines: &[Value]) -> Vec<Block> {
    let (own, shared): (Vec<&Value>, Vec<&Value>) = engines.iter().partition(|engine| has_own_claims(engine));
    let mut head = vec!["property".to_owned()];
    head.extend(shared.iter().map(|engine| word(&engine["name"])));
    let rows = list(&report["properties"])
        .iter()
        .map(|property| {
            let id = word(&property["id"]);
            let mut row = vec![format!("[{id}](#{})", anchor(&id))];
            row.extend(shared.iter().map(|engine| {
                let results = list(&engine["results"]);
                let mine = results.iter().find(|result| result["property"] == property["id"]);
                match mine {
                    Some(result) => verdict(engine, result),
                    None if engine["not_run"] == true => "not run here".to_owned(),
                    None => "–".to_owned(),
                }
            }));
            row
        })
        .collect();
    let mut blocks = vec![Block::Table(head, rows)];
    let own = own.into_iter().map(|engine| {
        let (name, results) = (word(&engine["name"]), list(&engine["results"]));
        let proved = results.iter().filter(|r| r["verdict"] == "proved").count();
        format!("[{name}](#{name}): {proved} of {} claims of its own proved. {}", results.len(), word(&engine["about"]))
    });
    let own: Vec<String> = own.collect();
    if !own.is_empty() {
        blocks.push(Block::List(own));
    }
    blocks.push(text(
        "How many claims of each family an engine has proved; those of the enumeration for the listed values only:",
    ));
    blocks.push(families(report, engines));
    blocks
}

/// The families of claims, and how many of each an engine has proved.
fn families(report: &Value, engines: &[Value]) -> Block {
    let properties = list(&report["properties"]);
    // A shared property has its family, and a claim of an engine's own says it.
    let family = |result: &Value| {
        let shared = properties.iter().find(|p| p["id"] == result["property"]);
        word(&shared.unwrap_or(result)["family"])
    };
    let proves = |result: &&Value| result["verdict"] == "proved";
    let mut proved: Vec<(String, Vec<String>)> = Vec::new();
    let mut names: Vec<String> = Vec::new();
    for engine in engines {
        let results = list(&engine["results"]);
        let mine: Vec<String> = results.iter().filter(proves).map(family).collect();
        if mine.is_empty() {
            continue;
        }
        for name in &mine {
            if !names.contains(name) {
                names.push(name.clone());
            }
        }
        proved.push((word(&engine["name"]), mine));
    }
    let mut head = vec!["family".to_owned()];
    head.extend(proved.iter().map(|(engine, _)| engine.clone()));
    let rows = names.into_iter().map(|name| {
        let counts = proved.iter().map(|(_, mine)| match mine.iter().filter(|family| **family == name).count() {
            0 => "–".to_owned(),
            count => format!("proved {count}"),
        });
        let counts: Vec<String> = counts.collect();
        [vec![name], counts].concat()
    });
    Block::Table(head, rows.collect())
}

/// What an engine found, with how far it goes.
fn verdict(engine: &Value, result: &Value) -> String {
    let verdict = word(&result["verdict"]);
    if engine["name"] == "enumeration" && verdict == "proved" {
        return "proved for the listed values".to_owned();
    }
    verdict
}

/// Whether an engine was held against other properties than the shared ones.
fn has_own_claims(engine: &Value) -> bool {
    list(&engine["results"]).iter().any(|result| result["sentence"].is_string())
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
            let name = word(&engine["name"]);
            let results = list(&engine["results"]);
            let proved = results.iter().filter(|r| r["verdict"] == "proved").count();
            let shown = match results.len() {
                0 => "–".to_owned(),
                all if proved == 0 => format!("tried {all}"),
                all => format!("proved {proved} of {all}"),
            };
            let repeat = repeat(&name).map_or("–".to_owned(), |how| format!("`{how}`"));
            let about = word(&engine["about"]);
            vec![name, word(&engine["version"]), about, shown, what, repeat]
        })
        .collect();
    let head = ["engine", "version", "what it does", "properties", "broken code", "repeat"];
    Block::Table(head.map(str::to_owned).to_vec(), rows)
}

/// The command that runs an engine again.
fn repeat(engine: &str) -> Option<String> {
    match engine {
        "kani" => Some("cargo kani -p ncp-proofs -p ncp-readers".to_owned()),
        "" => None,
        name => Some(format!("cargo xtask prove --engine {name}")),
    }
}

/// The code that a property is about.
fn code(engine: &str, id: &str) -> Vec<String> {
    let kernel = |names: &[&str]| {
        let files = names.iter();
        let file = |name: &&str| format!("spec/kernel/src/decisions/{name}.rs");
        files.map(file).collect::<Vec<_>>()
    };
    let (family, subject) = id.split_once('/').unwrap_or((id, ""));
    let subject = subject.split(['/', '-']).next().unwrap_or_default();
    let files: &[&str] = match (engine, family) {
        ("machine", _) => &["spec/kernel/src", "proofs/machine/src"],
        ("model", _) => match subject {
            "plant" => &["spec/src/resilience/action_buffer.rs"],
            "latch" => &["spec/src/safety/governor.rs", "spec/src/resilience/action_buffer.rs"],
            _ => &["spec/src/session", "spec/src/reply.rs"],
        },
        ("readers", "bulk") => &["spec/src/bulk"],
        ("readers", "version") => &["spec/src/version.rs"],
        ("readers", _) => &["spec/src/keys.rs"],
        (_, "watchdog") => return kernel(&["deadline", "order", "watchdog"]),
        (_, "geofence") => return kernel(&["fence", "speed", "gates"]),
        (_, "clamp") => return kernel(&["speed"]),
        _ if subject == "plant" => return kernel(&["plant", "watchdog", "order", "deadline"]),
        _ => return kernel(&["gates"]),
    };
    files.iter().map(|file| (*file).to_owned()).collect()
}

fn broken_rows(engines: &[Value]) -> (Vec<String>, Vec<Vec<String>>) {
    let shared = |engine: &&Value| list(&engine["broken"]).iter().any(|broken| broken["file"].is_string());
    let engines: Vec<&Value> = engines.iter().filter(shared).collect();
    let mut head = vec!["broken kernel".to_owned(), "change".to_owned()];
    head.extend(engines.iter().map(|engine| word(&engine["name"])));
    let first: Vec<Value> = engines.first().map(|engine| list(&engine["broken"])).unwrap_or_default();
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
    (head, rows)
}

fn each(property: &Value, engines: &[Value], blocks: &mut Vec<Block>) {
    let id = word(&property["id"]);
    blocks.push(heading(3, &anchor(&id), &id));
    claim("", &id, property, blocks);
    let rows: Vec<Vec<String>> = engines
        .iter()
        .flat_map(|engine| {
            let results = list(&engine["results"]).into_iter();
            let mine = results.filter(|result| result["property"] == property["id"]);
            mine.map(|result| said(engine, &result)).collect::<Vec<_>>()
        })
        .collect();
    blocks.push(results_table(rows));
    let files: Vec<String> = engines
        .iter()
        .flat_map(|engine| list(&engine["results"]))
        .filter(|result| result["property"] == property["id"])
        .flat_map(|result| list(&result["evidence"]))
        .map(|file| format!("[{0}](../proofs/evidence/{0})", word(&file)))
        .collect();
    if !files.is_empty() {
        blocks.push(text(&format!("Its obligations, each answered `unsat`: {}", files.join(", "))));
    }
    let mut mine = first_refutations(engines);
    mine.retain(|broken| broken["property"] == property["id"]);
    let mut inner = Vec::new();
    for broken in &mine {
        let by: Vec<String> = list(&broken["by"]).iter().map(word).collect();
        let found = &broken["counterexample"];
        inner.push(text(&format!(
            "`{}`: {}. Refuted by {}. {}{}",
            word(&broken["id"]),
            change(broken),
            by.join(", "),
            shown_inputs(found),
            no_vector(found)
        )));
        inner.extend(shown_vector(found));
    }
    if !mine.is_empty() {
        let count = mine.len();
        let title = format!("{count} broken kernels that it refutes, with counterexamples");
        blocks.push(Block::Details(title, inner));
    }
}

fn results_table(rows: Vec<Vec<String>>) -> Block {
    let head = ["result", "engine", "what was run", "repeat"];
    Block::Table(head.map(str::to_owned).to_vec(), rows)
}

/// Claims that an engine makes beside the shared properties.
fn own_claims(report: &Value, engine: &Value, blocks: &mut Vec<Block>) {
    let shared: BTreeSet<String> = list(&report["properties"]).iter().map(|p| word(&p["id"])).collect();
    let results = list(&engine["results"]);
    let own: Vec<&Value> = results.iter().filter(|r| !shared.contains(&word(&r["property"]))).collect();
    if own.is_empty() {
        return;
    }
    let name = word(&engine["name"]);
    blocks.push(heading(2, &name, &format!("Claims of the engine {name}")));
    blocks.push(text(&word(&engine["about"])));
    for result in own {
        blocks.push(heading(3, &format!("{name}-{}", anchor(&word(&result["property"]))), &word(&result["property"])));
        claim(&name, &word(&result["property"]), result, blocks);
        blocks.push(results_table(vec![said(engine, result)]));
    }
    let mut inner = Vec::new();
    for broken in list(&engine["broken"]) {
        let found = &broken["counterexample"];
        let (id, property) = (word(&broken["id"]), word(&broken["property"]));
        let about = word(&broken["about"]);
        let about = about.trim_end_matches('.');
        let how = match (is_refuted(&broken), found["vector"].is_object()) {
            (false, _) => "NOT REFUTED.".to_owned(),
            (true, true) => format!("Refuted by {property}, which this vector shows."),
            (true, false) => format!("Refuted by {property}. {}", shown_inputs(found)),
        };
        inner.push(text(&format!("`{id}`: {about}. {how}")));
        inner.extend(shown_vector(found));
    }
    let count = list(&engine["broken"]).len();
    let title = format!("{count} broken ones, with counterexamples");
    blocks.push(Block::Details(title, inner));
}

/// The sentence, the formula, the code, the rules, the bounds and the assumptions of a claim.
fn claim(engine: &str, id: &str, claim: &Value, blocks: &mut Vec<Block>) {
    blocks.push(text(&word(&claim["sentence"])));
    blocks.push(Block::Code(word(&claim["statement"])));
    let rules: Vec<String> = list(&claim["rules"]).iter().map(word).collect();
    let code: Vec<String> = code(engine, id).iter().map(|file| format!("[{file}](../{file})")).collect();
    let mut facts = vec![
        format!("code: {}", code.join(", ")),
        format!("rules: {}", rules.join(", ")),
        format!("bounds: {}", word(&claim["bounds"])),
    ];
    let assumptions = list(&claim["assumptions"]);
    facts.extend(assumptions.iter().map(|a| format!("assumed: {}", word(a))));
    if assumptions.is_empty() {
        facts.push("assumed: nothing but what is [trusted](#trusted)".to_owned());
    }
    blocks.push(Block::List(facts));
}

/// What an engine says of a claim, with its version, its numbers, and how to ask it again.
fn said(engine: &Value, result: &Value) -> Vec<String> {
    let name = word(&engine["name"]);
    let mut numbers = Vec::new();
    for (member, what) in [
        ("paths", "paths"),
        ("states", if name == "readers" { "inputs" } else { "states" }),
        ("obligations", "obligations"),
        ("true_by_evaluation", "checks true by evaluation"),
        ("runs", "runs"),
    ] {
        if let Some(count) = result[member].as_u64().filter(|count| *count > 0) {
            numbers.push(format!("{count} {what}"));
        }
    }
    for member in ["function", "detail"] {
        let told = word(&result[member]);
        if !told.is_empty() {
            numbers.push(if member == "function" { format!("`{told}`") } else { told });
        }
    }
    let property = word(&result["property"]);
    let repeat = match &*name {
        "machine" => Some(format!("proofs/machine/prove.sh --no-broken --only {property}")),
        name => repeat(name),
    };
    vec![
        verdict(engine, result),
        format!("{name}, {}", word(&engine["version"])),
        numbers.join(", "),
        repeat.map_or_else(String::new, |how| format!("`{how}`")),
    ]
}

/// The inputs of a counterexample, with the check that fails and where they come from.
fn shown_inputs(found: &Value) -> String {
    if !found["inputs"].is_array() {
        return format!("Counterexample: `{found}`.");
    }
    let inputs: Vec<String> =
        list(&found["inputs"]).iter().map(|input| format!("{} = {}", word(&input[0]), input[1])).collect();
    // The longer words stand with the numbers of all of them.
    let by = found["found_by"].as_str().and_then(|by| by.split(',').next());
    let by = by.map_or_else(String::new, |by| format!(" ({by})"));
    let check = word(&found["check"]);
    format!("Fails \"{check}\" for `{}`{by}.", inputs.join(", "))
}

/// A counterexample as a vector.
fn shown_vector(found: &Value) -> Option<Block> {
    let vector = &found["vector"];
    vector.is_object().then(|| {
        let (call, args, expect) = (word(&vector["call"]), &vector["args"], &vector["expect"]);
        Block::Code(format!("call   {call}\nargs   {args}\nexpect {expect}"))
    })
}

/// Why a counterexample is no vector.
fn no_vector(found: &Value) -> String {
    match word(&found["no_vector"]) {
        why if why.is_empty() || found["vector"].is_object() => String::new(),
        why => format!(" No vector, as {why}."),
    }
}

/// The change that makes a broken kernel.
fn change(broken: &Value) -> String {
    let flat = |value: &Value| word(value).split_whitespace().collect::<Vec<_>>().join(" ");
    format!("{}: `{}` → `{}`", word(&broken["file"]), flat(&broken["from"]), flat(&broken["to"]))
}

fn points(fixed: &[&str], engines: &[Value], member: &str) -> Block {
    let mut items: Vec<String> = fixed.iter().map(|item| (*item).to_owned()).collect();
    for engine in engines {
        let name = word(&engine["name"]);
        if engine["not_run"] == true && member == "not_proved" {
            items.push(format!("{name}: not run here. {}", word(&engine["about"])));
        }
        items.extend(list(&engine[member]).iter().map(|item| format!("{name}: {}", word(item))));
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

fn is_refuted(broken: &Value) -> bool {
    broken["counterexample"].is_object()
}

fn word(value: &Value) -> String {
    value.as_str().unwrap_or_default().to_owned()
}

fn list(value: &Value) -> Vec<Value> {
    value.as_array().cloned().unwrap_or_default()
}
