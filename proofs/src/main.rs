//! `ncp-prove`: holds the kernel against its properties, and the engines against broken kernels.
#![forbid(unsafe_code)]

use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard};
use std::thread;
use std::time::Duration;

use ncp_proofs::broken::{self, Broken};
use ncp_proofs::engines::symbolic::{self, Solvers};
use ncp_proofs::engines::{Counterexample, ENDS, Outcome, Patience, Verdict, compared, enumeration, standin};
use ncp_proofs::kernel::Production;
use ncp_proofs::properties::{Harness, PROPERTIES, Property, harness};
use ncp_proofs::{digest, document, page, report, terminal};
use serde_json::{Value, json};

const USAGE: &str = "\
Usage: ncp-prove [--stage kernel|rest] [--engine kani|kani-stand-in|enumeration|symbolic|model|machine|readers]…
       ncp-prove --render     # reports/proofs.{md,html} from reports/proofs.json
";

/// An engine: how it proves, and how it refutes a broken kernel.
struct Engine {
    name: &'static str,
    version: &'static str,
    about: &'static str,
    how: How,
}

/// A counterexample, or why there is none.
type Refutation = Result<Value, String>;

/// Where an engine's results come from.
enum How {
    /// It runs here.
    Here {
        /// Whether it takes a moment only, and so has its word before the others.
        is_quick: bool,
        prove: fn(&Property, &Harness, &Place) -> Option<Outcome>,
        refute: fn(&Property, &Harness, &Place, &str) -> Option<Refutation>,
    },
    /// Another program has left its results in a file of `.tools`; it is not run here if there is none.
    Elsewhere(&'static str),
}

/// All engines, in the order of the report.
const ENGINES: &[Engine] = &[
    Engine {
        name: "symbolic",
        version: "bitwuzla, cross-checked by z3",
        about: "Exhaustive: all paths of the kernel's own code over symbolic doubles and seqs.",
        how: How::Here {
            is_quick: false,
            prove: |property, harness, place| {
                let mut outcome = symbolic::prove(property, harness, &place.solvers, &place.evidence);
                if outcome.verdict == Verdict::Failed && !place.solvers.patience.is_over() {
                    // No proof, and no counterexample of the solver's: perhaps samples have one.
                    let wide = standin::run(harness, 100 * SAMPLES, property.symbolic_length);
                    if let Some(found) = wide.counterexample {
                        outcome.verdict = Verdict::Refuted;
                        outcome.counterexample = Some(found);
                    }
                }
                Some(outcome)
            },
            refute: |property, harness, place, id| {
                let draft = place.drafts.join(format!("{id}.smt2"));
                let found = symbolic::refute(property, harness, &place.solvers, &draft);
                Some(found.and_then(|found| {
                    let (found, origin) = found.unzip();
                    let mut shown = counterexample(property, harness, found)?;
                    shown["found_by"] = json!(origin.map(symbolic::Origin::as_str));
                    Ok(shown)
                }))
            },
        },
    },
    Engine {
        name: "enumeration",
        version: env!("CARGO_PKG_VERSION"),
        about: "Exhaustive over finite sets: every combination of the values that the property lists, as doubles.",
        how: How::Here {
            is_quick: true,
            prove: |property, harness, _| enumeration::run(property, harness, usize::MAX),
            refute: |property, harness, _, _| {
                let outcome = enumeration::run(property, harness, usize::MAX)?;
                Some(counterexample(property, harness, outcome.counterexample))
            },
        },
    },
    Engine {
        name: "machine",
        version: "angr 9.2.213",
        about: "Exhaustive: all paths of the machine code that the compiler made of the kernel.",
        how: How::Elsewhere(".tools/machine.json"),
    },
    Engine {
        name: "model",
        version: "stateright",
        about: "Exhaustive over finite worlds: every state of the protocol over a bad network.",
        how: How::Elsewhere(".tools/model.json"),
    },
    Engine {
        name: "readers",
        version: env!("CARGO_PKG_VERSION"),
        about: "Exhaustive within bounds: every input of what reads blocks, versions and keys, natively.",
        how: How::Elsewhere(".tools/readers.json"),
    },
    Engine {
        name: "kani-stand-in",
        version: env!("CARGO_PKG_VERSION"),
        about: "The harnesses of Kani on edges and samples. It proves nothing.",
        how: How::Here {
            is_quick: true,
            prove: |_, harness, _| Some(standin::run(harness, 10 * SAMPLES, usize::MAX)),
            refute: |property, harness, _, _| {
                let outcome = standin::run(harness, 100 * SAMPLES, usize::MAX);
                Some(counterexample(property, harness, outcome.counterexample))
            },
        },
    },
    Engine {
        name: "kani",
        version: "0.68",
        about: "Bounded model checking of the harnesses, wherever Kani can be installed: cargo kani -p ncp-proofs.",
        how: How::Elsewhere(".tools/kani.json"),
    },
];

const SAMPLES: u64 = 20_000;
/// How many properties or broken kernels are at work at a time.
const WORKERS: usize = 2;
/// How long all proofs of the kernel may take together. A kernel that was changed may have far more paths, or
/// questions that no solver answers.
const PATIENCE: Duration = Duration::from_secs(600);
/// What is found out about the kernel before the slower part of the command.
const KERNEL: &str = ".tools/proofs-kernel.json";

/// Where things are.
struct Place {
    root: PathBuf,
    evidence: PathBuf,
    drafts: PathBuf,
    solvers: Solvers,
    /// The properties whose counterexample was shown.
    shown: Mutex<BTreeSet<&'static str>>,
}

/// What part of the work is done.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Stage {
    /// All of it.
    Whole,
    /// The kernel only; nothing is said where it is proved.
    Kernel,
    /// What comes after that.
    Rest,
}

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let args: Vec<&str> = args.iter().map(String::as_str).collect();
    match run(&args) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}

fn run(args: &[&str]) -> Result<bool, Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().ok_or("no root")?.to_owned();
    let place = Place {
        evidence: root.join("proofs/evidence"),
        drafts: root.join(".tools/proofs-drafts"),
        solvers: Solvers {
            bin: root.join(".tools/proofs-venv").join(if cfg!(windows) { "Scripts" } else { "bin" }),
            script: root.join("proofs/evidence/solve.py"),
            patience: Patience::of(PATIENCE),
            known: None,
        },
        shown: Mutex::default(),
        root,
    };
    if args == ["--render"] {
        let text = fs::read_to_string(place.root.join("reports/proofs.json"))?;
        render(&place, &serde_json::from_str(&text)?)?;
        return Ok(true);
    }
    let (mut names, mut stage) = (Vec::new(), Stage::Whole);
    for pair in args.chunks(2) {
        match pair {
            ["--engine", name] if ENGINES.iter().any(|engine| engine.name == *name) => {
                names.push(*name);
            }
            ["--stage", "kernel"] => stage = Stage::Kernel,
            ["--stage", "rest"] => stage = Stage::Rest,
            _ => return Err(USAGE.into()),
        }
    }
    prove(&place, &names, stage)
}

/// What the engines say of the kernel: their results by their names, in the order of the properties.
type Results = BTreeMap<String, Vec<Value>>;

fn prove(place: &Place, names: &[&str], stage: Stage) -> Result<bool, Box<dyn Error>> {
    let now = digest::of(&place.root)?;
    fs::create_dir_all(&place.drafts)?;
    let wanted: Vec<&Engine> =
        ENGINES.iter().filter(|engine| names.is_empty() || names.contains(&engine.name)).collect();
    let kernel = match stage {
        Stage::Rest => found_before(place, &now)?,
        Stage::Whole | Stage::Kernel => hold_kernel(place, &wanted)?,
    };
    let mut refuted = refuted(&kernel);
    if stage == Stage::Kernel && refuted.is_empty() {
        let found = json!({ "digest": now, "results": kernel });
        fs::write(place.root.join(KERNEL), found.to_string())?;
        return Ok(true);
    }

    let mut left: BTreeMap<&str, Value> = BTreeMap::new();
    for engine in &wanted {
        if let How::Elsewhere(file) = engine.how {
            let result = report::elsewhere(head(engine), &place.root.join(file));
            refuted.extend(refuted_elsewhere(engine, &result));
            left.insert(engine.name, result);
        }
    }
    let mut broken =
        if refuted.is_empty() && broken::IS_BUILT { refute_broken(place, &wanted)? } else { Results::new() };

    let file = place.root.join("reports/proofs.json");
    // What other engines found out about the same sources stays.
    let before: Value = fs::read_to_string(&file)
        .ok()
        .and_then(|text| serde_json::from_str(&text).ok())
        .filter(|report: &Value| report["digest"] == now.as_str())
        .unwrap_or_default();
    let mut engines = Vec::new();
    for engine in ENGINES {
        if !wanted.iter().any(|wanted| wanted.name == engine.name) {
            let old = before["engines"].as_array().into_iter().flatten();
            engines.extend(old.filter(|old| old["name"] == engine.name).cloned());
        } else if let Some(result) = left.remove(engine.name) {
            engines.push(result);
        } else {
            let mut whole = head(engine);
            whole["results"] = kernel.get(engine.name).cloned().unwrap_or_default().into();
            whole["broken"] = broken.remove(engine.name).unwrap_or_default().into();
            engines.push(whole);
        }
    }
    if names.is_empty() || names.contains(&"symbolic") {
        report::name_version(&mut engines, "symbolic", &place.solvers.versions()?);
    }
    let run = report::take_run(&mut engines, &before["run"]);
    let mut report = json!({
        "format": 2, "digest": now, "properties": report::properties(), "engines": engines, "run": run,
    });
    let mut problems: Vec<String> = broken::missing();
    if refuted.is_empty() {
        problems.extend(report::problems(&report));
        if !broken::IS_BUILT {
            problems.push("the broken kernels are not part of this build".to_owned());
        }
    } else {
        problems.splice(0..0, refuted.iter().map(|(_, problem)| problem.clone()));
        problems.push(terminal::SKIPPED.split_whitespace().collect::<Vec<_>>().join(" "));
    }
    for problem in &problems {
        println!("PROBLEM: {problem}");
    }
    report["problems"] = json!(problems);
    fs::create_dir_all(place.root.join("reports"))?;
    fs::write(&file, serde_json::to_string_pretty(&report)? + "\n")?;
    render(place, &report)?;
    if problems.is_empty() {
        println!("{}", terminal::proved(&report));
    }
    if !refuted.is_empty() {
        let mut ids: Vec<String> = refuted.into_iter().map(|(id, _)| id).collect();
        ids.sort();
        ids.dedup();
        println!("{}", terminal::summary(&ids));
    }
    Ok(problems.is_empty())
}

fn head(engine: &Engine) -> Value {
    json!({ "name": engine.name, "version": engine.version, "about": engine.about })
}

/// The refuted properties, each with the problem that it is.
fn refuted(kernel: &Results) -> Vec<(String, String)> {
    let mut refuted = Vec::new();
    for (engine, results) in kernel {
        for result in results.iter().filter(|result| result["verdict"] == "refuted") {
            let id = result["property"].as_str().unwrap_or_default();
            let problem = terminal::problem(engine, id, &result["counterexample"]);
            refuted.push((id.to_owned(), problem));
        }
    }
    refuted
}

/// What another program has refuted.
fn refuted_elsewhere(engine: &Engine, left: &Value) -> Vec<(String, String)> {
    let results = left["results"].as_array().into_iter().flatten();
    let refuted = results.filter(|result| result["verdict"] == "refuted");
    refuted
        .map(|result| {
            let id = result["property"].as_str().unwrap_or_default();
            let (name, detail) = (engine.name, &result["counterexample"]);
            (id.to_owned(), format!("{id} is refuted by {name}: {detail}"))
        })
        .collect()
}

/// What the first part of the command found out.
fn found_before(place: &Place, digest: &str) -> Result<Results, Box<dyn Error>> {
    let file = place.root.join(KERNEL);
    let text = fs::read_to_string(&file).map_err(|error| format!("{KERNEL}: {error}"))?;
    let found: Value = serde_json::from_str(&text)?;
    if found["digest"] != digest {
        return Err(format!("{KERNEL} is about other sources").into());
    }
    Ok(serde_json::from_value(found["results"].clone())?)
}

/// Holds the kernel against all properties: by the quick engines first, and by the others if none of these has
/// refuted it.
fn hold_kernel(place: &Place, engines: &[&Engine]) -> Result<Results, Box<dyn Error>> {
    let mut results = Results::new();
    for quick in [true, false] {
        let mut jobs = Vec::new();
        for engine in engines {
            if let How::Here { is_quick, .. } = engine.how
                && is_quick == quick
            {
                jobs.extend(PROPERTIES.iter().map(|property| (*engine, property)));
            }
        }
        let bad: BTreeSet<String> = refuted(&results).into_iter().map(|(id, _)| id).collect();
        if !bad.is_empty() {
            jobs.retain(|(_, property)| bad.contains(property.id));
        }
        let answers = parallel(jobs.len(), |nth| {
            let (engine, property) = jobs.get(nth)?;
            hold(place, engine, property, !bad.is_empty()).transpose()
        });
        for (answer, (engine, _)) in answers.into_iter().zip(&jobs) {
            if let Some(answer) = answer {
                let results = results.entry(engine.name.to_owned()).or_default();
                results.push(answer?);
            }
        }
    }
    Ok(results)
}

/// Holds the kernel against one property; nothing where the engine does not cover it. A refuted one is only
/// confirmed.
fn hold(
    place: &Place,
    engine: &Engine,
    property: &'static Property,
    is_refuted: bool,
) -> Result<Option<Value>, String> {
    let How::Here { is_quick, prove, refute } = engine.how else {
        return Ok(None);
    };
    let harness = harness::<Production>(property.id).ok_or_else(|| format!("{} has no harness", property.id))?;
    if place.solvers.patience.is_over() {
        return Ok(None);
    }
    if is_refuted {
        let word = match refute(property, &harness, place, "kernel") {
            Some(Ok(_)) => "refutes it, too",
            Some(Err(_)) | None => "finds no counterexample of its own",
        };
        println!("{:14} {:32} {word}", engine.name, property.id);
        return Ok(None);
    }
    let Some(outcome) = prove(property, &harness, place) else {
        return Ok(None);
    };
    if outcome.verdict == Verdict::Failed && place.solvers.patience.is_over() {
        return Ok(None);
    }
    let mut answer = report::outcome(property.id, &harness, &outcome);
    let verdict = outcome.verdict.as_str();
    let (name, id, detail) = (engine.name, property.id, &outcome.detail);
    println!("{name:14} {id:32} {verdict} {detail}");
    if let Some(found) = &outcome.counterexample {
        let compared = compared(&harness, found, usize::MAX);
        let found = terminal::with_compared(answer["counterexample"].take(), compared);
        // One counterexample of a property is enough to read.
        let is_new = |mut shown: MutexGuard<'_, BTreeSet<_>>| shown.insert(property.id);
        if place.shown.lock().is_ok_and(is_new) {
            println!("{}", terminal::refutation(engine.name, property, &found));
        }
        answer["counterexample"] = found;
    }
    // Whatever else is asked of a kernel that does not come to an end may have none, either.
    let is_endless = |found: &Counterexample| found.check == ENDS;
    let is_endless = outcome.counterexample.as_ref().is_some_and(is_endless);
    if outcome.verdict == Verdict::Refuted && (!is_quick || is_endless) {
        place.solvers.patience.end();
    }
    Ok(Some(answer))
}

/// Refutes the broken kernels.
fn refute_broken(place: &Place, engines: &[&Engine]) -> Result<Results, Box<dyn Error>> {
    let jobs: Vec<(&Engine, &Broken)> = engines
        .iter()
        .flat_map(|engine| broken::BROKEN.iter().map(move |broken| (*engine, broken)))
        .filter(|(_, broken)| broken::MISSING.iter().all(|(id, _)| *id != broken.id))
        .collect();
    let answers = parallel(jobs.len(), |nth| {
        let (engine, broken) = jobs.get(nth)?;
        refute_one(place, engine, broken).transpose()
    });
    let mut results = Results::new();
    for (answer, (engine, _)) in answers.into_iter().zip(&jobs) {
        if let Some(answer) = answer {
            let results = results.entry(engine.name.to_owned()).or_default();
            results.push(answer?);
        }
    }
    Ok(results)
}

/// Refutes one broken kernel; nothing where the engine does not cover the property.
fn refute_one(place: &Place, engine: &Engine, broken: &Broken) -> Result<Option<Value>, String> {
    let How::Here { refute, .. } = engine.how else {
        return Ok(None);
    };
    let property = PROPERTIES.iter().find(|p| p.id == broken.property);
    let (Some(property), Some(harness)) = (property, broken::harness(broken.id)) else {
        return Err(format!("{} has no harness", broken.id));
    };
    let Some(answer) = refute(property, &harness, place, broken.id) else {
        return Ok(None);
    };
    let mut entry = json!({
        "id": broken.id, "property": broken.property, "family": property.family.as_str(),
        "file": broken.file, "from": broken.from, "to": broken.to,
    });
    match answer {
        Ok(found) => {
            let (check, inputs) = (&found["check"], terminal::inputs(&found));
            let line = format!("refuted: {}: {inputs}", check.as_str().unwrap_or_default());
            println!("{:14} {:32} {}", engine.name, broken.id, terminal::short(&line));
            entry["counterexample"] = found;
        }
        Err(why) => {
            println!("{:14} {:32} NOT REFUTED: {why}", engine.name, broken.id);
            entry["missed"] = json!(why);
        }
    }
    Ok(Some(entry))
}

fn render(place: &Place, report: &Value) -> Result<(), Box<dyn Error>> {
    let document = page::document(report);
    let reports = place.root.join("reports");
    fs::write(reports.join("proofs.md"), document::markdown(&document))?;
    fs::write(reports.join("proofs.html"), document::html(&document))?;
    Ok(())
}

/// Does so many things, some at a time; the answers in their order.
fn parallel<T: Send>(count: usize, job: impl Fn(usize) -> Option<T> + Sync) -> Vec<Option<T>> {
    let next = AtomicUsize::new(0);
    let answers: Mutex<BTreeMap<usize, T>> = Mutex::default();
    thread::scope(|scope| {
        for _ in 0..WORKERS {
            scope.spawn(|| {
                loop {
                    let nth = next.fetch_add(1, Ordering::Relaxed);
                    if nth >= count {
                        break;
                    }
                    if let Some(answer) = job(nth)
                        && let Ok(mut answers) = answers.lock()
                    {
                        answers.insert(nth, answer);
                    }
                }
            });
        }
    });
    let mut answers = answers.into_inner().unwrap_or_default();
    (0..count).map(|nth| answers.remove(&nth)).collect()
}

fn counterexample(property: &Property, harness: &Harness, found: Option<Counterexample>) -> Result<Value, String> {
    found
        .map(|found| report::counterexample(property.id, harness, &found))
        .ok_or_else(|| "no counterexample".to_owned())
}
