//! The report as a document: what a reader sees of the results. Nothing is decided here.

use std::collections::{BTreeMap, BTreeSet};

use serde_json::Value;

use ncp_proofs::engines::symbolic::Origin;
use ncp_proofs::report::{Answer, Broken, Claim, Engine, Found, Report, Run, Shown, Words};
use ncp_text::catalogue::Catalogue;

use super::held::{LISTED, is_listed};
use super::{Locks, tables};
use crate::document::Block;

/// The report as a document.
pub(super) fn document(report: &Report, locks: &Locks, catalogue: &Catalogue, commit: &str) -> Vec<Block> {
    let engines = &report.engines;
    let mut blocks = vec![
        heading(1, "top", "Proofs"),
        text(
            "What is claimed of the code that decides whether a plant moves, and of the code that reads untrusted \
             bytes; by which engine, within which bounds and under which assumptions it was shown; and how to repeat \
             it.",
        ),
        text(&format!(
            "Commit: `{commit}`. Digest of what is proved, of what proves it, and of what it was built with \
             (SHA-256): `{}`. `cargo assure status` compares both with the sources as they are.",
            report.digest
        )),
        text(
            "[Claims](#claims) · [Rules](#rules) · [Trusted](#trusted) · [The theorem](#the-theorem) · \
             [Engines](#engines) · [Made with](#made-with) · [Broken kernels](#broken) · [Each property](#each) · \
             [Trusted, in words](#trusted-in-words) · [What is not proved](#not-proved) · [Repeat it](#repeat) · \
             [This run](#run)",
        ),
    ];
    let mut problems = report.problems.clone();
    problems.extend(tables::open(locks).into_iter().filter(|line| !report.problems.contains(line)));
    if !problems.is_empty() {
        blocks.push(heading(2, "not-shown", "Not shown"));
        blocks.push(Block::List(problems));
    }
    blocks.extend(tables::subject(locks, catalogue));
    broken_kernels(engines, &mut blocks);
    blocks.push(heading(2, "each", "Each property"));
    for Claim { id, words } in &report.properties {
        each(id, words, engines, &mut blocks);
    }
    for engine in engines {
        own_claims(report, engine, &mut blocks);
    }
    blocks.push(heading(2, "trusted-in-words", "Trusted, in words"));
    blocks.push(trusted(engines));
    blocks.push(heading(2, "not-proved", "What is not proved"));
    blocks.push(not_proved(engines));
    blocks.push(heading(2, "repeat", "Repeat it"));
    blocks.push(text(
        "All of it, from the root of the repository: `cargo assure prove`; one engine: `cargo assure \
        prove --engine symbolic`. One file of obligations, with a stock solver; every line of the answer has to be \
        `unsat`, as many as the head of the file says:",
    ));
    blocks.push(Block::Code(
        "python3 -m venv venv && venv/bin/pip install bitwuzla==0.9.1 z3-solver==5.4.0.0\nvenv/bin/python \
         proofs/evidence/solve.py proofs/evidence/watchdog/deadline/001.smt2\nvenv/bin/z3 \
         proofs/evidence/watchdog/deadline/001.smt2\nbitwuzla proofs/evidence/watchdog/deadline/001.smt2     # where \
         bitwuzla's own program is installed"
            .to_owned(),
    ));
    blocks.push(text(
        "The engine of the machine code leaves no files. It writes its obligations, of one property or \
        of all, for any solver with floating point:",
    ));
    blocks.push(Block::Code(
        "proofs/machine/prove.sh --only machine/within-deadline --no-broken --evidence obligations\nbitwuzla \
         obligations/machine-within-deadline-paths-from-0.smt2                     # or z3"
            .to_owned(),
    ));
    blocks.push(text(
        "The model and the readers leave no obligations either: they run the code on each of their \
        cases. `cargo run --release -p ncp-model -- --json model.json`, `cargo run --release -p ncp-readers \
        --features broken -- --json readers.json`.",
    ));
    this_run(&report.run, engines, &mut blocks);
    blocks
}

const TRUSTED: &[&str] = &[
    "The text as it was put into sentences, and the sentences as they were put into formulas and harnesses: that \
     they say what the rules say. Each stands here beside its rules, so that a reader can compare.",
    "rustc and LLVM, and the processor: that the program does what its source says, and that doubles are IEEE 754 \
     binary64 with rounding to nearest. The machine-code engine, where it was run, narrows this to its lifter, for \
     one build by one compiler.",
    "The square root: `f64::sqrt`, which IEEE 754 rounds correctly and which x86-64 and AArch64 have as an \
     instruction. No other function of a mathematical library is used; `f64::floor`, the absolute value and the \
     saturating conversion to an index are Rust's own.",
    "The harness's own model: `watchdog/step`, `latch/gates` and `latch/plant` compare the kernel with a model of a \
     few lines within the harness.",
    "The kernel's source is generic over its numbers, and production runs it on `f64` and `i64`: that the few lines \
     which map `Scalar` and `Seq` to these (`scalar.rs`) do so. The engines on doubles and the machine code run \
     them; the symbolic engine and the theorem do not.",
    "The symbolic scalar: that its terms mean in SMT-LIB what the operations of `f64` do, that both ways of every \
     comparison are followed, and the writer of the obligations. Refuting broken kernels exercises a part of that, and \
     does not show that both ways were followed.",
    "The rule that drops decisions: a question to the solver keeps only those decisions of its path that its check \
     mentions. With fewer decisions the question claims more, so `unsat` stays a proof; where the answer is `sat`, \
     each path is asked again with all its decisions.",
    "A comparison that follows from those decided before (a < b excludes b ≤ a) is not asked again.",
    "The solvers: that bitwuzla's `unsat` is right. It leaves no certificate that another program could check. z3 is \
     asked the same within a limit of its own steps and has not contradicted it; what it did not answer rests on \
     bitwuzla alone, and [this run](#run) counts both.",
    "The programs of this project that run the engines, read their answers and write this report; and that the \
     broken copies are the kernel with that one change, which the build script makes.",
    "What calls the kernel: that `ActionBuffer` and `SafetyGovernor` ask it and do what it says. The model explores \
     both within its bounds; tests and vectors cover the rest.",
];
const NOT_PROVED: &[&str] = &[
    "Anything about the world: that a number which is called metres, seconds or metres per second is one, that a \
     sensor tells the truth, that a clock runs, that a plant follows its command. The proofs are about doubles.",
    "Positions against real arithmetic by other engines than the theorem: their claims are about positions as \
     computed in doubles.",
    "Anything beyond the bounds: horizons of more steps, longer sequences, wider vectors, more channels than each \
     property states, except where it says that it holds by induction.",
    "What the enumeration tried holds on the values that it lists, and nothing is said of others.",
    "What the stand-in for Kani tried is no proof: it runs the harnesses on edges and samples.",
    "Liveness: that something moves at last. The properties say when the plant must hold and when it may move.",
    "Time and memory: how long the kernel takes, and that it is called in time.",
    "Other implementations. A peer is held to the text by the vectors and the scenarios, and proved by nothing here.",
];

/// The broken copies: how many, by whom they are refuted, and which print a vector.
fn broken_kernels(engines: &[Engine], blocks: &mut Vec<Block>) {
    blocks.push(heading(2, "broken", "Broken kernels"));
    blocks.push(text(
        "Copies of the source with one change each: an engine that would prove anything does not refute \
        them. Each counterexample was run again, natively: the broken kernel fails the check. Those of the symbolic \
        engine come from one of two places, and each says from which: a model of bitwuzla; or inputs that broke the \
        harness on doubles, of samples or of the enumeration, for which bitwuzla confirmed with the inputs fixed \
        that the question which they raise is satisfiable. A dash: the engine does not cover the property.",
    ));
    let rows = broken_rows(engines);
    let kinds = [Origin::Model, Origin::Sampled, Origin::Enumerated];
    let mut origins: BTreeMap<&str, usize> = kinds.map(|kind| (kind.as_str(), 0)).into();
    let found = engines.iter().flat_map(|engine| &engine.broken).filter_map(|broken| broken.counterexample.as_ref());
    for origin in found.filter_map(|found| found.found_by.as_deref()) {
        *origins.entry(origin).or_default() += 1;
    }
    let origins = origins.iter();
    let mut facts: Vec<String> = origins.map(|(origin, count)| format!("symbolic: {count} by {origin}")).collect();
    let (mut with, mut without) = (0, BTreeMap::<&str, Vec<&str>>::new());
    for refuted in first_refutations(engines) {
        if refuted.found.vector.is_some() {
            with += 1;
        } else {
            without.entry(refuted.found.no_vector.as_deref().unwrap_or_default()).or_default().push(&refuted.broken.id);
        }
    }
    let count = with + without.values().map(Vec::len).sum::<usize>();
    facts.push(format!(
        "{with} of {count} refuted broken kernels print a counterexample as a vector: a call of [the peer \
         protocol](../peers/PROTOCOL.md) that a peer with this defect fails, and that expects what the executable \
         specification answers"
    ));
    facts.extend(without.into_iter().map(|(why, ids)| {
        let ids: Vec<String> = ids.iter().map(|id| format!("`{id}`")).collect();
        format!("no vector, as {why}: {}", ids.join(", "))
    }));
    blocks.push(Block::List(facts));
    let title = format!("All {} broken kernels, and who refutes them", rows.1.len());
    blocks.push(Block::Details(title, vec![Block::Table(rows.0, rows.1)]));
}

/// A broken kernel with the best of its refutations: one that prints a vector, if there is one.
struct Refuted<'a> {
    broken: &'a Broken,
    found: &'a Found,
    /// The engines that refute it.
    by: Vec<&'a str>,
}

/// The broken copies of the shared kernel that some engine refutes.
fn first_refutations(engines: &[Engine]) -> Vec<Refuted<'_>> {
    let mut all: Vec<Refuted<'_>> = Vec::new();
    for engine in engines {
        for broken in engine.broken.iter().filter(|broken| broken.file.is_some()) {
            let Some(found) = &broken.counterexample else {
                continue;
            };
            match all.iter_mut().find(|known| is_same(known.broken, broken)) {
                None => all.push(Refuted { broken, found, by: vec![&engine.name] }),
                Some(known) => {
                    known.by.push(&engine.name);
                    if known.found.vector.is_none() && found.vector.is_some() {
                        (known.broken, known.found) = (broken, found);
                    }
                }
            }
        }
    }
    all
}

/// Whether two words are about one broken copy: an id is one of a family.
fn is_same(one: &Broken, other: &Broken) -> bool {
    (&one.family, &one.id) == (&other.family, &other.id)
}

/// What differs from run to run.
fn this_run(run: &Run, engines: &[Engine], blocks: &mut Vec<Block>) {
    blocks.push(heading(2, "run", "This run: times and cross-check"));
    blocks.push(text(
        "What differs from one run to the next on the same sources, and on other machines: how long \
        each property took, in seconds, and how many of the obligations z3 answered within its limit, each of them \
        as bitwuzla did. The engine of the machine code has limits by the clock: on a busy machine another of its \
        solvers may answer first, whose counterexample may be another one, or none in time.",
    ));
    let mut rows = Vec::new();
    for Engine { name, results, .. } in engines {
        for Answer { property, obligations, .. } in results {
            let mine = run.get(name).and_then(|run| run.get(property)).copied().unwrap_or_default();
            let z3 = match (mine.cross_checked, *obligations) {
                (Some(some), Some(all)) if all > 0 && name == "symbolic" => format!("{some} of {all}"),
                _ => "–".to_owned(),
            };
            let seconds = mine.seconds.map_or("null".to_owned(), |seconds| seconds.to_string());
            rows.push(vec![property.clone(), name.clone(), seconds, z3]);
        }
    }
    let head = ["property", "engine", "seconds", "also answered by z3"];
    let table = Block::Table(head.map(str::to_owned).to_vec(), rows);
    blocks.push(Block::Details("Each property".to_owned(), vec![table]));
}

/// What an engine found, with how far it goes.
fn verdict(engine: &Engine, result: &Answer) -> String {
    if is_listed(&engine.name, &result.property) && result.is_proved() {
        return LISTED.to_owned();
    }
    result.verdict.as_str().to_owned()
}

/// The command that runs an engine again.
fn repeat(engine: &str) -> Option<String> {
    match engine {
        "kani" => Some("cargo kani -p ncp-proofs -p ncp-readers".to_owned()),
        "" => None,
        name => Some(format!("cargo assure prove --engine {name}")),
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
        ("theorem", _) => &["spec/kernel/src", "proofs/theorem/coq", "proofs/theorem/src"],
        ("readers", "bulk") => &["spec/src/bulk"],
        ("readers", "version") => &["spec/src/version.rs"],
        ("readers", _) => &["spec/src/keys.rs"],
        ("path", "estop") => &["spec/src/resilience/action_buffer.rs"],
        ("path", "governor") => &["spec/src/safety/governor.rs"],
        ("path", "link") => &["spec/src/resilience/link_monitor.rs"],
        ("path", "loop") => &["spec/src/control/control_loop.rs"],
        ("path", _) => {
            &["spec/src/control/control_loop.rs", "spec/src/safety/governor.rs", "spec/src/resilience/link_monitor.rs"]
        }
        (_, "watchdog") => return kernel(&["deadline", "order", "watchdog"]),
        (_, "geofence") => return kernel(&["fence", "speed", "gates"]),
        (_, "clamp") => return kernel(&["speed"]),
        _ if subject == "plant" => return kernel(&["plant", "watchdog", "order", "deadline"]),
        _ => return kernel(&["gates"]),
    };
    files.iter().map(|file| (*file).to_owned()).collect()
}

fn broken_rows(engines: &[Engine]) -> (Vec<String>, Vec<Vec<String>>) {
    let shared = |engine: &&Engine| engine.broken.iter().any(|broken| broken.file.is_some());
    let engines: Vec<&Engine> = engines.iter().filter(shared).collect();
    let mut head = vec!["broken kernel".to_owned(), "change".to_owned()];
    head.extend(engines.iter().map(|engine| engine.name.clone()));
    let mut all: Vec<&Broken> = Vec::new();
    for broken in engines.iter().flat_map(|engine| &engine.broken) {
        if !all.iter().any(|known| is_same(known, broken) && known.property == broken.property) {
            all.push(broken);
        }
    }
    let rows = all.into_iter().map(|broken| {
        let mut row = vec![format!("{} by {}", broken.id, broken.property), change(broken)];
        let is_it = |other: &&Broken| is_same(other, broken) && other.property == broken.property;
        row.extend(engines.iter().map(|engine| match engine.broken.iter().find(is_it) {
            Some(other) if other.is_refuted() => "refuted".to_owned(),
            Some(_) => "not seen".to_owned(),
            None => "–".to_owned(),
        }));
        row
    });
    (head, rows.collect())
}

fn each(id: &str, words: &Words, engines: &[Engine], blocks: &mut Vec<Block>) {
    blocks.push(heading(3, &anchor(id), id));
    claim("", id, words, blocks);
    let mine = |engine: &'_ Engine| engine.results.iter().position(|result| result.property == id);
    let results = engines.iter().filter_map(|engine| Some((engine, engine.results.get(mine(engine)?)?)));
    blocks.push(results_table(results.clone().map(|(engine, result)| said(engine, result)).collect()));
    let files: Vec<String> = results
        .flat_map(|(_, result)| &result.evidence)
        .map(|file| format!("[{file}](../proofs/evidence/{file})"))
        .collect();
    if !files.is_empty() {
        blocks.push(text(&format!("Its obligations, each answered `unsat`: {}", files.join(", "))));
    }
    let mut mine = first_refutations(engines);
    mine.retain(|refuted| refuted.broken.property == id);
    let mut inner = Vec::new();
    for Refuted { broken, found, by } in &mine {
        inner.push(text(&format!(
            "`{}`: {}. Refuted by {}. {}{}",
            broken.id,
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
fn own_claims(report: &Report, engine: &Engine, blocks: &mut Vec<Block>) {
    let shared: BTreeSet<&str> = report.properties.iter().map(|claim| &*claim.id).collect();
    let own = engine.results.iter().filter(|result| !shared.contains(&*result.property));
    let own: Vec<(&Answer, &Words)> = own.filter_map(|result| Some((result, result.words.as_ref()?))).collect();
    if own.is_empty() {
        return;
    }
    let name = &engine.name;
    blocks.push(heading(2, name, &format!("Claims of the engine {name}")));
    blocks.push(text(&engine.about));
    for (result, words) in own {
        let id = &result.property;
        blocks.push(heading(3, &format!("{name}-{}", anchor(id)), id));
        claim(name, id, words, blocks);
        blocks.push(results_table(vec![said(engine, result)]));
    }
    let mut inner = Vec::new();
    for Broken { id, property, about, counterexample, .. } in &engine.broken {
        let about = about.trim_end_matches('.');
        let how = match counterexample {
            None => "NOT REFUTED.".to_owned(),
            Some(found) if found.vector.is_some() => format!("Refuted by {property}, which this vector shows."),
            Some(found) => format!("Refuted by {property}. {}", shown_inputs(found)),
        };
        inner.push(text(&format!("`{id}`: {about}. {how}")));
        inner.extend(counterexample.as_ref().and_then(shown_vector));
    }
    let title = format!("{} broken ones, with counterexamples", engine.broken.len());
    blocks.push(Block::Details(title, inner));
}

/// The sentence, the formula, the code, the rules, the bounds and the assumptions of a claim.
fn claim(engine: &str, id: &str, words: &Words, blocks: &mut Vec<Block>) {
    blocks.push(text(&words.sentence));
    blocks.push(Block::Code(words.statement.clone()));
    let code: Vec<String> = code(engine, id).iter().map(|file| format!("[{file}](../{file})")).collect();
    let mut facts = vec![
        format!("code: {}", code.join(", ")),
        format!("rules: {}", words.rules.join(", ")),
        format!("bounds: {}", words.bounds),
    ];
    facts.extend(words.assumptions.iter().map(|assumption| format!("assumed: {assumption}")));
    if words.assumptions.is_empty() {
        facts.push("assumed: nothing but what is [trusted](#trusted)".to_owned());
    }
    blocks.push(Block::List(facts));
}

/// What an engine says of a claim, with its version, its numbers, and how to ask it again.
fn said(engine: &Engine, result: &Answer) -> Vec<String> {
    let (name, property) = (&*engine.name, &result.property);
    let counts = [
        (result.paths, "paths"),
        (result.states, if ["readers", "path"].contains(&name) { "inputs" } else { "states" }),
        (result.obligations, "obligations"),
        (result.true_by_evaluation, "checks true by evaluation"),
        (result.runs, "runs"),
    ];
    let counts = counts.into_iter().filter_map(|(count, what)| Some((count.filter(|count| *count > 0)?, what)));
    let mut numbers: Vec<String> = counts.map(|(count, what)| format!("{count} {what}")).collect();
    numbers.extend(result.function.iter().map(|function| format!("`{function}`")));
    numbers.extend((!result.detail.is_empty()).then(|| result.detail.clone()));
    let repeat = match name {
        "machine" => Some(format!("proofs/machine/prove.sh --no-broken --only {property}")),
        name => repeat(name),
    };
    vec![
        verdict(engine, result),
        format!("{name}, {}", engine.version),
        numbers.join(", "),
        repeat.map_or_else(String::new, |how| format!("`{how}`")),
    ]
}

/// The inputs of a counterexample, with the check that fails and where they come from.
fn shown_inputs(found: &Found) -> String {
    let Shown::Inputs { check, inputs } = &found.shown else {
        return format!("Counterexample: `{}`.", serde_json::to_string(found).unwrap_or_default());
    };
    let inputs: Vec<String> = inputs.iter().map(|(name, value)| format!("{name} = {value}")).collect();
    // The longer words stand with the numbers of all of them.
    let by = found.found_by.as_deref().and_then(|by| by.split(',').next());
    let by = by.map_or_else(String::new, |by| format!(" ({by})"));
    format!("Fails \"{check}\" for `{}`{by}.", inputs.join(", "))
}

/// A counterexample as a vector.
fn shown_vector(found: &Found) -> Option<Block> {
    let vector = found.vector.as_ref()?;
    let part = |name: &str| vector.get(name).unwrap_or(&Value::Null);
    let call = part("call").as_str().unwrap_or_default();
    Some(Block::Code(format!("call   {call}\nargs   {}\nexpect {}", part("args"), part("expect"))))
}

/// Why a counterexample is no vector.
fn no_vector(found: &Found) -> String {
    let why = found.no_vector.as_deref().filter(|_| found.vector.is_none());
    why.map_or_else(String::new, |why| format!(" No vector, as {why}."))
}

/// The change that makes a broken kernel.
fn change(broken: &Broken) -> String {
    let flat =
        |text: &Option<String>| text.iter().flat_map(|text| text.split_whitespace()).collect::<Vec<_>>().join(" ");
    format!("{}: `{}` → `{}`", flat(&broken.file), flat(&broken.from), flat(&broken.to))
}

fn trusted(engines: &[Engine]) -> Block {
    let own = |engine: &'_ Engine| engine.trusted.iter().map(|item| format!("{}: {item}", engine.name)).collect();
    let own: Vec<Vec<String>> = engines.iter().map(own).collect();
    Block::List([TRUSTED.iter().map(|item| (*item).to_owned()).collect(), own.concat()].concat())
}

fn not_proved(engines: &[Engine]) -> Block {
    let mut items: Vec<String> = NOT_PROVED.iter().map(|item| (*item).to_owned()).collect();
    for Engine { name, about, not_run, not_proved, .. } in engines {
        items.extend(not_run.then(|| format!("{name}: not run here. {about}")));
        items.extend(not_proved.iter().map(|item| format!("{name}: {item}")));
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
