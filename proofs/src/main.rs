//! `ncp-prove`: holds the kernel against its properties, and the engines against broken kernels.
#![forbid(unsafe_code)]

use std::collections::BTreeMap;
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use ncp_proofs::broken::{self, Broken};
use ncp_proofs::engines::symbolic::{self, Solvers};
use ncp_proofs::engines::{Counterexample, enumeration, standin};
use ncp_proofs::kernel::Production;
use ncp_proofs::properties::{Harness, PROPERTIES, Property, harness};
use ncp_proofs::{digest, document, page, report};
use serde_json::{Value, json};

const USAGE: &str = "\
Usage: ncp-prove [--engine kani|kani-stand-in|enumeration|symbolic|model|machine|readers]…
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
        prove: fn(&Property, &Harness, &Place) -> Option<Value>,
        refute: fn(&Property, &Harness, &Place, &Broken) -> Option<Refutation>,
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
            prove: |property, harness, place| {
                let outcome = symbolic::prove(property, harness, &place.solvers, &place.evidence);
                Some(report::outcome(property.id, harness, &outcome))
            },
            refute: |property, harness, place, broken| {
                let draft = place.drafts.join(format!("{}.smt2", broken.id));
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
            prove: |property, harness, _| {
                let outcome = enumeration::run(property, harness, usize::MAX)?;
                Some(report::outcome(property.id, harness, &outcome))
            },
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
            prove: |property, harness, _| {
                let outcome = standin::run(harness, SAMPLES, usize::MAX);
                Some(report::outcome(property.id, harness, &outcome))
            },
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

/// Where things are.
struct Place {
    root: PathBuf,
    evidence: PathBuf,
    drafts: PathBuf,
    solvers: Solvers,
}

/// Something to do: an engine on a property, or on a broken kernel.
#[derive(Clone, Copy)]
enum Job {
    Prove(&'static Engine, &'static Property),
    Refute(&'static Engine, &'static Broken),
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
    let root = Path::new(env!("CARGO_MANIFEST_DIR"))
        .parent()
        .ok_or("no root")?
        .to_owned();
    let place = Place {
        evidence: root.join("proofs/evidence"),
        drafts: root.join(".tools/proofs-drafts"),
        solvers: Solvers {
            bin: root.join(".tools/proofs-venv").join(if cfg!(windows) {
                "Scripts"
            } else {
                "bin"
            }),
            script: root.join("proofs/solve.py"),
        },
        root,
    };
    if args == ["--render"] {
        let text = fs::read_to_string(place.root.join("reports/proofs.json"))?;
        render(&place, &serde_json::from_str(&text)?)?;
        return Ok(true);
    }
    let mut names = Vec::new();
    for pair in args.chunks(2) {
        match pair {
            ["--engine", name] if ENGINES.iter().any(|engine| engine.name == *name) => {
                names.push(*name);
            }
            _ => return Err(USAGE.into()),
        }
    }
    prove(&place, &names)
}

fn prove(place: &Place, names: &[&str]) -> Result<bool, Box<dyn Error>> {
    let now = digest::of(&place.root)?;
    fs::create_dir_all(&place.drafts)?;
    let file = place.root.join("reports/proofs.json");
    // What other engines found out about the same sources stays.
    let before: Value = fs::read_to_string(&file)
        .ok()
        .and_then(|text| serde_json::from_str(&text).ok())
        .filter(|report: &Value| report["digest"] == now.as_str())
        .unwrap_or_default();
    let is_wanted = |engine: &Engine| names.is_empty() || names.contains(&engine.name);

    let wanted = || ENGINES.iter().filter(|engine| is_wanted(engine));
    let here = || wanted().filter(|engine| matches!(engine.how, How::Here { .. }));
    // The longest first.
    let proofs = here().flat_map(|engine| PROPERTIES.iter().map(move |p| Job::Prove(engine, p)));
    let refutations =
        here().flat_map(|engine| broken::BROKEN.iter().map(move |b| Job::Refute(engine, b)));
    let jobs: Vec<Job> = proofs.chain(refutations).collect();
    let mut done = work(place, &jobs)?;

    let mut engines = Vec::new();
    for engine in ENGINES {
        let head = json!({ "name": engine.name, "version": engine.version, "about": engine.about });
        if !is_wanted(engine) {
            let old = before["engines"].as_array().into_iter().flatten();
            engines.extend(old.filter(|old| old["name"] == engine.name).cloned());
        } else if let How::Elsewhere(file) = engine.how {
            engines.push(report::elsewhere(head, &place.root.join(file)));
        } else {
            let (results, broken) = done.remove(engine.name).unwrap_or_default();
            let mut whole = head;
            whole["results"] = results.into();
            whole["broken"] = broken.into();
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
    let problems = report::problems(&report);
    for problem in &problems {
        println!("PROBLEM: {problem}");
    }
    report["problems"] = json!(problems);
    fs::create_dir_all(place.root.join("reports"))?;
    fs::write(&file, serde_json::to_string_pretty(&report)? + "\n")?;
    render(place, &report)?;
    Ok(problems.is_empty())
}

fn render(place: &Place, report: &Value) -> Result<(), Box<dyn Error>> {
    let document = page::document(report);
    let reports = place.root.join("reports");
    fs::write(reports.join("proofs.md"), document::markdown(&document))?;
    fs::write(reports.join("proofs.html"), document::html(&document))?;
    Ok(())
}

/// Results and refutations of each engine, in the order of the tables.
type Done = BTreeMap<&'static str, (Vec<Value>, Vec<Value>)>;

/// Does all jobs, some at a time.
fn work(place: &Place, jobs: &[Job]) -> Result<Done, Box<dyn Error>> {
    let next = AtomicUsize::new(0);
    let answers: Mutex<BTreeMap<usize, Result<Option<Value>, String>>> = Mutex::default();
    thread::scope(|scope| {
        for _ in 0..WORKERS {
            scope.spawn(|| {
                loop {
                    let nth = next.fetch_add(1, Ordering::Relaxed);
                    let Some(job) = jobs.get(nth) else { break };
                    let answer = job.run(place);
                    let Ok(mut answers) = answers.lock() else {
                        break;
                    };
                    answers.insert(nth, answer);
                }
            });
        }
    });
    let mut done = Done::new();
    for (nth, answer) in answers.into_inner()? {
        let (Some(job), Some(answer)) = (jobs.get(nth), answer?) else {
            continue;
        };
        match job {
            Job::Prove(engine, _) => done.entry(engine.name).or_default().0.push(answer),
            Job::Refute(engine, _) => done.entry(engine.name).or_default().1.push(answer),
        }
    }
    Ok(done)
}

impl Job {
    /// What came of it; nothing where the engine does not cover the property.
    fn run(self, place: &Place) -> Result<Option<Value>, String> {
        match self {
            Self::Prove(engine, property) => {
                let How::Here { prove, .. } = engine.how else {
                    return Ok(None);
                };
                let harness = harness::<Production>(property.id)
                    .ok_or_else(|| format!("{} has no harness", property.id))?;
                let answer = prove(property, &harness, place);
                if let Some(answer) = &answer {
                    let verdict = &answer["verdict"];
                    println!("{:14} {:32} {verdict}", engine.name, property.id);
                }
                Ok(answer)
            }
            Self::Refute(engine, broken) => {
                let How::Here { refute, .. } = engine.how else {
                    return Ok(None);
                };
                let property = PROPERTIES.iter().find(|p| p.id == broken.property);
                let (Some(property), Some(harness)) = (property, broken::harness(broken.id)) else {
                    return Err(format!("{} has no harness", broken.id));
                };
                let Some(answer) = refute(property, &harness, place, broken) else {
                    return Ok(None);
                };
                let mut entry = json!({
                    "id": broken.id, "property": broken.property, "family": property.family.as_str(),
                    "file": broken.file, "from": broken.from, "to": broken.to,
                });
                match answer {
                    Ok(found) => {
                        println!("{:14} {:32} refuted by {found}", engine.name, broken.id);
                        entry["counterexample"] = found;
                    }
                    Err(why) => {
                        println!("{:14} {:32} NOT REFUTED: {why}", engine.name, broken.id);
                        entry["missed"] = json!(why);
                    }
                }
                Ok(Some(entry))
            }
        }
    }
}

fn counterexample(
    property: &Property,
    harness: &Harness,
    found: Option<Counterexample>,
) -> Result<Value, String> {
    found
        .map(|found| report::counterexample(property.id, harness, &found))
        .ok_or_else(|| "no counterexample".to_owned())
}
