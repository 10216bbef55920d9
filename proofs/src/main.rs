//! `ncp-prove`: holds the kernel against its properties, and the engines against broken kernels.
#![forbid(unsafe_code)]

use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard};
use std::thread;

use ncp_defects::Defect;
use ncp_proofs::broken;
use ncp_proofs::counterexample::{Counterexample, ENDS};
use ncp_proofs::digest::{self, ARTEFACTS};
use ncp_proofs::engines::symbolic::{self, Limits, Solvers, controls};
use ncp_proofs::engines::{Outcome, Patience, Verdict, bounds, enumeration, standin};
use ncp_proofs::evidence;
use ncp_proofs::harness::{Harness, compared, harness};
use ncp_proofs::kernel::Production;
use ncp_proofs::pins;
use ncp_proofs::properties::{PROPERTIES, Property};
use ncp_proofs::report::{self, Answer, Broken, Found, Report, Run};
use ncp_proofs::sabotage::{self, Sabotaged};
use ncp_proofs::terminal;
use serde::{Deserialize, Serialize};

const USAGE: &str = "\
Usage: ncp-prove [--stage kernel|rest] [--pin] [--engine ENGINE]…
       ncp-prove --sabotage NAME|all
Engines: kani, kani-stand-in, enumeration, symbolic, model, machine, readers, path, theorem
";

/// An engine: how it proves, and how it refutes a broken kernel.
struct Engine {
    name: &'static str,
    /// What its results depend on: the name of an artefact.
    artefact: &'static str,
    version: &'static str,
    about: &'static str,
    how: How,
}

/// A counterexample, or why there is none.
type Refutation = Result<Found, String>;

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
        artefact: "kernel",
        version: "bitwuzla, cross-checked by z3",
        about: "Exhaustive: all paths of the kernel's own code over symbolic doubles and seqs.",
        how: How::Here {
            is_quick: false,
            prove: |property, harness, place| {
                let mut outcome = symbolic::prove(property, harness, &place.solvers, &place.evidence);
                if outcome.verdict == Verdict::Failed && !place.solvers.patience.is_over() {
                    // No proof, and no counterexample of the solver's: perhaps samples have one.
                    let wide = standin::run(harness, 100 * SAMPLES, bounds::of(property.id).length);
                    if let Some(found) = wide.counterexample {
                        outcome.verdict = Verdict::Refuted;
                        outcome.counterexample = Some(found);
                    }
                }
                Some(outcome)
            },
            refute: |property, harness, place, id| {
                // By both names: a defect is refuted by several properties, at the same time.
                let draft = place.drafts.join(format!("{id}-{}.smt2", property.id.replace('/', "-")));
                let found = symbolic::refute(property, harness, &place.solvers, &draft);
                Some(found.map_err(|why| why.to_string()).and_then(|found| {
                    let (found, origin) = found.unzip();
                    let mut shown = counterexample(property, harness, found)?;
                    shown.found_by = origin.map(|origin| origin.as_str().to_owned());
                    Ok(shown)
                }))
            },
        },
    },
    Engine {
        name: "enumeration",
        artefact: "kernel",
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
        artefact: "machine",
        version: "angr 9.2.213",
        about: "Exhaustive: all paths of the machine code that the compiler made of the kernel.",
        how: How::Elsewhere(".tools/machine.json"),
    },
    Engine {
        name: "model",
        artefact: "model",
        version: "stateright",
        about: "Exhaustive over finite worlds: every state of the protocol over a bad network.",
        how: How::Elsewhere(".tools/model.json"),
    },
    Engine {
        name: "readers",
        artefact: "readers",
        version: env!("CARGO_PKG_VERSION"),
        about: "Exhaustive within bounds: every input of what reads blocks, versions and keys, natively.",
        how: How::Elsewhere(".tools/readers.json"),
    },
    Engine {
        name: "path",
        artefact: "path",
        version: env!("CARGO_PKG_VERSION"),
        about: "Exhaustive within bounds: the scanner for ESTOPs, the governor, the link monitor, the loop, natively.",
        how: How::Elsewhere(".tools/path.json"),
    },
    Engine {
        name: "theorem",
        artefact: "theorem",
        version: "Coq",
        about: "Coq checks theorems about the algorithm over doubles, and that the kernel's source is it path by path.",
        how: How::Elsewhere(".tools/theorem.json"),
    },
    Engine {
        name: "kani-stand-in",
        artefact: "kernel",
        version: env!("CARGO_PKG_VERSION"),
        about: "The harnesses of Kani on edges and samples. It proves nothing.",
        how: How::Here {
            is_quick: true,
            prove: |property, harness, _| {
                // Of all samples few have a horizon that the fence cuts off, behind every gate.
                let times = if property.id == "latch/govern" { 100 } else { 10 };
                Some(standin::run(harness, times * SAMPLES, usize::MAX))
            },
            refute: |property, harness, _, _| {
                let outcome = standin::run(harness, 100 * SAMPLES, usize::MAX);
                Some(counterexample(property, harness, outcome.counterexample))
            },
        },
    },
    Engine {
        name: "kani",
        artefact: "kernel",
        version: "0.68",
        about: "Bounded model checking of the harnesses, wherever Kani can be installed: cargo kani -p ncp-proofs.",
        how: How::Elsewhere(".tools/kani.json"),
    },
];

const SAMPLES: u64 = 20_000;
/// How many properties or broken kernels are at work at a time.
const WORKERS: usize = 2;
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

impl Place {
    fn evidence_of_controls(&self) -> PathBuf {
        self.drafts.join("controls").join(self.evidence.file_name().unwrap_or_default())
    }
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
            patience: Patience::default(),
            limits: Limits::default(),
            known: None,
        },
        shown: Mutex::default(),
        root,
    };
    let (mut names, mut stage, mut pin) = (Vec::new(), Stage::Whole, false);
    let mut words = args.iter().copied();
    while let Some(word) = words.next() {
        match (word, if word == "--pin" { None } else { words.next() }) {
            ("--pin", _) => pin = true,
            ("--engine", Some(name)) if ENGINES.iter().any(|engine| engine.name == name) => names.push(name),
            ("--stage", Some("kernel")) => stage = Stage::Kernel,
            ("--stage", Some("rest")) => stage = Stage::Rest,
            ("--sabotage", Some("all")) => return sabotage_all(&place),
            ("--sabotage", Some(name)) => return sabotage(place, name),
            _ => return Err(USAGE.into()),
        }
    }
    prove(&place, &names, stage, pin)
}

/// Runs the engine with a defect of its own, as it runs on the kernel: its controls, and then a few properties.
/// It ends with the error that says what is wrong with the engine, or has not noticed.
fn sabotage(mut place: Place, name: &str) -> Result<bool, Box<dyn Error>> {
    sabotage::switch_on(name)?;
    place.evidence = place.drafts.join("sabotage").join(name);
    controlled(&place)?;
    let mut answers = Vec::new();
    for property in PROPERTIES.iter().filter(|property| QUICK.contains(&property.id)) {
        let harness = harness::<Production>(property.id).ok_or("no harness")?;
        let outcome = symbolic::prove(property, &harness, &place.solvers, &place.evidence);
        if outcome.verdict != Verdict::Proved {
            return Err(format!("{}: {} {}", property.id, outcome.verdict.as_str(), outcome.detail).into());
        }
        answers.push(report::outcome(property.id, &harness, &outcome));
    }
    let mut pinned = pins::read(&place.root)?;
    pinned.retain(|id, _| QUICK.contains(&&**id));
    match pins::problems(&pinned, &pins::of(&answers)).first() {
        Some(problem) => Err(problem.clone().into()),
        None => Ok(true),
    }
}

/// The properties of which a sabotaged engine is asked.
const QUICK: [&str; 4] = ["watchdog/deadline", "watchdog/ttl", "watchdog/order", "geofence/limit"];

/// Runs every sabotaged engine in a process of its own; `false` if one of them does not end with an error.
fn sabotage_all(place: &Place) -> Result<bool, Box<dyn Error>> {
    let defects = sabotage::defects()?;
    let program = std::env::current_exe()?;
    let run = |nth: usize| {
        let defect = defects.get(nth)?;
        let output = Command::new(&program).args(["--sabotage", &defect.name]).output().ok()?;
        let errors = String::from_utf8_lossy(&output.stderr);
        let error = errors.lines().find_map(|line| line.strip_prefix("error: "));
        let noticed = error.filter(|_| !output.status.success()).map(str::to_owned);
        println!("{:28} {}", defect.name, noticed.as_deref().unwrap_or("NOT NOTICED"));
        Some(Sabotaged { id: defect.name.clone(), about: defect.about.clone(), noticed })
    };
    let results: Vec<Sabotaged> = parallel(defects.len(), run).into_iter().flatten().collect();
    let missed = results.iter().filter(|result| result.noticed.is_none()).count();
    println!("{} sabotaged engines, {missed} not noticed", results.len());
    let left = Left { digest: kernel_digest(place)?, results };
    fs::write(place.root.join(SABOTAGED), serde_json::to_string_pretty(&left)?)?;
    Ok(missed == 0 && left.results.len() == defects.len())
}

/// Where the results of the sabotaged engines are left for the report.
const SABOTAGED: &str = ".tools/proofs-sabotage.json";

/// What came of the sabotaged engines, and of which sources.
#[derive(Serialize, Deserialize)]
struct Left {
    digest: String,
    results: Vec<Sabotaged>,
}

/// The digest of what is proved here and of what proves it.
fn kernel_digest(place: &Place) -> Result<String, Box<dyn Error>> {
    let kernel = ARTEFACTS.iter().find(|artefact| artefact.name == "kernel").ok_or("no artefact")?;
    Ok(kernel.digest(&place.root)?)
}

/// What came of the sabotaged engines of these sources; nothing where they were not run.
fn sabotaged(place: &Place) -> Result<Vec<Sabotaged>, Box<dyn Error>> {
    let text = fs::read_to_string(place.root.join(SABOTAGED)).unwrap_or_default();
    let left = serde_json::from_str::<Left>(&text).ok();
    let digest = kernel_digest(place)?;
    Ok(left.filter(|left| left.digest == digest).map(|left| left.results).unwrap_or_default())
}

/// Holds the symbolic engine against its controls: so many.
fn controlled(place: &Place) -> Result<usize, controls::AtFault> {
    controls::hold(&place.solvers, &place.evidence_of_controls())
}

/// What the engines say of the kernel: their results by their names, in the order of the properties.
type Results = BTreeMap<String, Vec<Answer>>;

/// What is found out about the kernel before the slower part of the command.
#[derive(Serialize, Deserialize)]
struct Before {
    digest: String,
    /// The controls that the symbolic engine has passed.
    controls: usize,
    results: Results,
}

fn prove(place: &Place, names: &[&str], stage: Stage, pin: bool) -> Result<bool, Box<dyn Error>> {
    let digest = digest::of(&place.root)?;
    fs::create_dir_all(&place.drafts)?;
    let wanted: Vec<&Engine> =
        ENGINES.iter().filter(|engine| names.is_empty() || names.contains(&engine.name)).collect();
    let is_symbolic = wanted.iter().any(|engine| engine.name == "symbolic");
    let controls = if is_symbolic && stage != Stage::Rest { controlled(place)? } else { 0 };
    let (controls, kernel) = match stage {
        Stage::Rest => found_before(place, &digest)?,
        Stage::Whole | Stage::Kernel => (controls, hold_kernel(place, &wanted)?),
    };
    let mut refuted = refuted(&kernel);
    if stage == Stage::Kernel && refuted.is_empty() {
        let found = Before { digest, controls, results: kernel };
        fs::write(place.root.join(KERNEL), serde_json::to_string(&found)?)?;
        return Ok(true);
    }

    let mut left: BTreeMap<&str, report::Engine> = BTreeMap::new();
    for engine in &wanted {
        if let How::Elsewhere(file) = engine.how {
            let result = report::elsewhere(head(engine), &place.root.join(file))?;
            refuted.extend(refuted_of(engine.name, &result.results));
            left.insert(engine.name, result);
        }
    }
    let mut broken =
        if refuted.is_empty() && broken::IS_BUILT { refute_broken(place, &wanted)? } else { BTreeMap::new() };

    // The table is one of the sources.
    if let Some(explored) = kernel.get("symbolic").filter(|_| pin && is_symbolic) {
        pins::write(&place.root, &pins::of(explored))?;
    }
    let digest = digest::of(&place.root)?;
    let file = place.root.join(report::FILE);
    let before = fs::read_to_string(&file).ok().and_then(|text| serde_json::from_str::<Report>(&text).ok());
    let before = before.unwrap_or_default();
    let mut digests = BTreeMap::new();
    for artefact in ARTEFACTS {
        digests.insert(artefact.name.to_owned(), artefact.digest(&place.root)?);
    }
    // What other engines found out about the same sources stays.
    let stays = |engine: &Engine| before.digests.get(engine.artefact) == digests.get(engine.artefact);
    let (mut engines, mut run) = (Vec::new(), Run::new());
    for engine in ENGINES {
        if !wanted.iter().any(|wanted| wanted.name == engine.name) {
            if let Some(old) = before.engine(engine.name).filter(|_| stays(engine)) {
                engines.push(old.clone());
                run.extend(before.run.get_key_value(engine.name).map(|(name, run)| (name.clone(), run.clone())));
            }
        } else if let Some(result) = left.remove(engine.name) {
            engines.push(result);
        } else {
            let results = kernel.get(engine.name).cloned().unwrap_or_default();
            let broken = broken.remove(engine.name).unwrap_or_default();
            engines.push(report::Engine { results, broken, ..head(engine) });
        }
    }
    let mut changed = Vec::new();
    for engine in engines.iter_mut().filter(|engine| is_symbolic && engine.name == "symbolic") {
        engine.version = place.solvers.versions()?;
        engine.controls = Some(controls as u64);
        engine.sabotaged = sabotaged(place)?;
        if refuted.is_empty() {
            changed = pins::problems(&pins::read(&place.root)?, &pins::of(&engine.results));
        }
    }
    let run = report::take_run(&mut engines, &run);
    let (format, properties) = (report::FORMAT, report::properties());
    let mut report = Report { format, digest, digests, properties, engines, run, problems: broken::missing() };
    if refuted.is_empty() {
        report.problems.extend(changed);
    }
    if refuted.is_empty() && !names.is_empty() {
        // Who asks some engines is told about these.
        let asked = report.engines.iter().filter(|engine| names.contains(&&*engine.name));
        let problems: Vec<String> = asked.flat_map(report::problems_of).collect();
        report.problems.extend(problems);
        report.problems.extend((!broken::IS_BUILT).then(|| "the broken kernels are not part of this build".to_owned()));
    } else if refuted.is_empty() {
        report.problems.extend(report::problems(&report));
        if !broken::IS_BUILT {
            report.problems.push("the broken kernels are not part of this build".to_owned());
        }
    } else {
        report.problems.splice(0..0, refuted.iter().map(|(_, problem)| problem.clone()));
        report.problems.push(terminal::SKIPPED.split_whitespace().collect::<Vec<_>>().join(" "));
    }
    for problem in &report.problems {
        println!("PROBLEM: {problem}");
    }
    fs::create_dir_all(file.parent().unwrap_or(&place.root))?;
    fs::write(&file, serde_json::to_string_pretty(&report)? + "\n")?;
    if report.problems.is_empty() {
        let file = place.evidence.join(report::VECTORS);
        let before = fs::read_to_string(&file).unwrap_or_default();
        fs::write(file, evidence::vectors(&report, &before))?;
    }
    if report.problems.is_empty() && report::problems(&report).is_empty() {
        println!("{}", terminal::proved(&report));
    } else if report.problems.is_empty() {
        println!("shown, as far as {} go: what the others found is of other sources, or none", names.join(", "));
    }
    if !refuted.is_empty() {
        let mut ids: Vec<String> = refuted.into_iter().map(|(id, _)| id).collect();
        ids.sort();
        ids.dedup();
        println!("{}", terminal::summary(&ids));
    }
    Ok(report.problems.is_empty())
}

fn head(engine: &Engine) -> report::Engine {
    report::Engine {
        name: engine.name.to_owned(),
        version: engine.version.to_owned(),
        about: engine.about.to_owned(),
        ..report::Engine::default()
    }
}

/// The refuted properties, each with the problem that it is.
fn refuted(kernel: &Results) -> Vec<(String, String)> {
    kernel.iter().flat_map(|(engine, results)| refuted_of(engine, results)).collect()
}

/// Those that one engine has refuted.
fn refuted_of(engine: &str, results: &[Answer]) -> Vec<(String, String)> {
    let refuted = results.iter().filter(|result| result.verdict == Verdict::Refuted);
    let problem = |result: &Answer| match &result.counterexample {
        Some(found) => terminal::problem(engine, &result.property, found),
        None => format!("{} is refuted by {engine}: {}", result.property, result.detail),
    };
    refuted.map(|result| (result.property.clone(), problem(result))).collect()
}

/// What the first part of the command found out.
fn found_before(place: &Place, digest: &str) -> Result<(usize, Results), Box<dyn Error>> {
    let file = place.root.join(KERNEL);
    let text = fs::read_to_string(&file).map_err(|error| format!("{KERNEL}: {error}"))?;
    let found: Before = serde_json::from_str(&text)?;
    if found.digest != digest {
        return Err(format!("{KERNEL} is about other sources").into());
    }
    Ok((found.controls, found.results))
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
) -> Result<Option<Answer>, String> {
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
    if let (Some(found), Some(shown)) = (&outcome.counterexample, &mut answer.counterexample) {
        shown.compared = compared(&harness, found, usize::MAX);
        // One counterexample of a property is enough to read.
        let is_new = |mut shown: MutexGuard<'_, BTreeSet<_>>| shown.insert(property.id);
        if place.shown.lock().is_ok_and(is_new) {
            println!("{}", terminal::refutation(engine.name, property, shown));
        }
    }
    // Whatever else is asked of a kernel that does not come to an end may have none, either.
    let is_endless = |found: &Counterexample| found.check == ENDS;
    let is_endless = outcome.counterexample.as_ref().is_some_and(is_endless);
    if outcome.verdict == Verdict::Refuted && (!is_quick || is_endless) {
        place.solvers.patience.end();
    }
    Ok(Some(answer))
}

/// Refutes the broken kernels: each defect by each of its properties, by every engine that it does not leave out.
fn refute_broken(place: &Place, engines: &[&Engine]) -> Result<BTreeMap<String, Vec<Broken>>, Box<dyn Error>> {
    let mut defects = broken::defects()?;
    defects.retain(|defect| broken::MISSING.iter().all(|(name, _)| *name != defect.name));
    let mut jobs = Vec::new();
    for engine in engines {
        for defect in &defects {
            let is_asked = defect.engines.is_empty() || defect.engines.iter().any(|name| name == engine.name);
            let own = PROPERTIES.iter().filter(|property| defect.properties.iter().any(|id| id == property.id));
            jobs.extend(own.filter(|_| is_asked).map(|property| (*engine, defect, property)));
        }
    }
    let answers = parallel(jobs.len(), |nth| {
        let (engine, defect, property) = jobs.get(nth)?;
        refute_one(place, engine, defect, property).transpose()
    });
    let mut results: BTreeMap<String, Vec<Broken>> = BTreeMap::new();
    for (answer, (engine, ..)) in answers.into_iter().zip(&jobs) {
        if let Some(answer) = answer {
            results.entry(engine.name.to_owned()).or_default().push(answer?);
        }
    }
    Ok(results)
}

/// Refutes one broken kernel by one property; nothing where the engine does not cover the property.
fn refute_one(
    place: &Place,
    engine: &Engine,
    defect: &Defect,
    property: &'static Property,
) -> Result<Option<Broken>, String> {
    let How::Here { refute, .. } = engine.how else {
        return Ok(None);
    };
    let Some(harness) = broken::harness(&defect.name, property.id) else {
        return Err(format!("{} has no harness of {}", defect.name, property.id));
    };
    let Some(answer) = refute(property, &harness, place, &defect.name) else {
        return Ok(None);
    };
    let said = match &answer {
        Ok(found) => terminal::short(&format!("refuted: {}: {}", found.check(), terminal::inputs(found))),
        Err(why) => format!("NOT REFUTED: {why}"),
    };
    println!("{:14} {:32} {said}", engine.name, defect.name);
    let edit = defect.edit.first();
    let missed = answer.as_ref().err().cloned();
    Ok(Some(Broken {
        id: defect.name.clone(),
        property: property.id.to_owned(),
        family: property.family.as_str().to_owned(),
        about: defect.about.clone(),
        file: edit.map(|edit| edit.file.clone()),
        from: edit.map(|edit| edit.code.clone()),
        to: edit.map(|edit| edit.with.clone()),
        counterexample: answer.ok(),
        missed,
    }))
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

fn counterexample(property: &Property, harness: &Harness, found: Option<Counterexample>) -> Refutation {
    found
        .map(|found| report::counterexample(property.id, harness, &found))
        .ok_or_else(|| "no counterexample".to_owned())
}
