//! `ncp-prove`: holds the kernel against its properties, and the engines against broken kernels.
#![forbid(unsafe_code)]

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use ncp_proofs::engines::symbolic::{self, Solvers};
use ncp_proofs::engines::{Verdict, enumeration, standin};
use ncp_proofs::kernel::Production;
use ncp_proofs::properties::{Harness, PROPERTIES, Property, harness};
use ncp_proofs::{broken, digest, report};
use serde_json::{Value, json};

const USAGE: &str = "\
Usage: ncp-prove [--engine kani|kani-stand-in|enumeration|symbolic]…
";

/// An engine: how it proves, and how it refutes a broken kernel.
struct Engine {
    name: &'static str,
    version: &'static str,
    about: &'static str,
    prove: fn(&Property, &Harness, &Place) -> Option<Value>,
    refute: fn(&Property, &Harness, &Place) -> Option<Result<Value, String>>,
}

/// All engines, in the order of the report.
const ENGINES: &[Engine] = &[
    Engine {
        name: "kani",
        version: "0.68",
        about: "Not run here.",
        prove: |_, _, _| Some(json!({ "verdict": "not run here" })),
        refute: |_, _, _| None,
    },
    Engine {
        name: STAND_IN,
        version: env!("CARGO_PKG_VERSION"),
        about: "The harnesses on edges and samples; it proves nothing.",
        prove: |property, harness, _| {
            Some(report::outcome(
                property.id,
                &standin::run(harness, SAMPLES).0,
            ))
        },
        refute: |_, harness, _| found(standin::run(harness, 10 * SAMPLES).0.counterexample),
    },
    Engine {
        name: "enumeration",
        version: env!("CARGO_PKG_VERSION"),
        about: "Exhaustive: every combination of the values that the property lists, as doubles.",
        prove: |property, harness, _| {
            Some(report::outcome(
                property.id,
                &enumeration::run(property, harness)?,
            ))
        },
        refute: |property, harness, _| found(enumeration::run(property, harness)?.counterexample),
    },
    Engine {
        name: "symbolic",
        version: "bitwuzla 0.9.1, cross-checked by z3 5.4.0",
        about: "Exhaustive: all paths of the kernel's own code over symbolic doubles and seqs.",
        prove: |property, harness, place| {
            let outcome = symbolic::prove(property, harness, &place.solvers, &place.evidence);
            Some(report::outcome(property.id, &outcome))
        },
        refute: |property, harness, place| {
            Some(
                match symbolic::refute(property, harness, &place.solvers, &place.drafts) {
                    Ok(Some(found)) => Ok(report::counterexample(&found)),
                    Ok(None) => Err("no counterexample within the limit".to_owned()),
                    Err(why) => Err(why),
                },
            )
        },
    },
];

const SAMPLES: u64 = 20_000;
const STAND_IN: &str = "kani-stand-in";

/// Where things are.
struct Place {
    root: PathBuf,
    evidence: PathBuf,
    drafts: PathBuf,
    solvers: Solvers,
}

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    match run(&args) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}

fn run(args: &[String]) -> Result<bool, Box<dyn Error>> {
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
    let args: Vec<&str> = args.iter().map(String::as_str).collect();
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
    let file = place.root.join("reports/proofs.json");
    // What other engines found out about the same sources stays.
    let before: Value = fs::read_to_string(&file)
        .ok()
        .and_then(|text| serde_json::from_str(&text).ok())
        .filter(|report: &Value| report["digest"] == now.as_str())
        .unwrap_or_default();
    let mut engines = Vec::new();
    let mut good = true;
    for engine in ENGINES {
        if !names.is_empty() && !names.contains(&engine.name) {
            let old = before["engines"].as_array().into_iter().flatten();
            engines.extend(old.filter(|old| old["name"] == engine.name).cloned());
            continue;
        }
        let (mut results, mut refuted) = (Vec::new(), Vec::new());
        for property in PROPERTIES {
            let Some(harness) = harness::<Production>(property.id) else {
                return Err(format!("{} has no harness", property.id).into());
            };
            let Some(mut result) = (engine.prove)(property, &harness, place) else {
                continue;
            };
            result["property"] = json!(property.id);
            println!(
                "{:14} {:32} {}",
                engine.name, property.id, result["verdict"]
            );
            let bad = [Verdict::Refuted, Verdict::Failed];
            if bad.iter().any(|bad| result["verdict"] == bad.as_str()) {
                good = false;
                println!("  {} {}", result["detail"], result["counterexample"]);
            }
            results.push(result);
        }
        for broken in broken::BROKEN {
            let property = PROPERTIES.iter().find(|p| p.id == broken.property);
            let harness = broken::harness(broken.id, broken.property);
            let (Some(property), Some(harness)) = (property, harness) else {
                return Err(format!("{} has no harness", broken.id).into());
            };
            let Some(answer) = (engine.refute)(property, &harness, place) else {
                continue;
            };
            let mut entry = json!({
                "id": broken.id, "property": broken.property, "file": broken.file,
                "from": broken.from, "to": broken.to, "counterexample": null,
            });
            match answer {
                Ok(found) => {
                    println!("{:14} {:32} refuted by {found}", engine.name, broken.id);
                    entry["counterexample"] = found;
                }
                Err(why) => {
                    println!("{:14} {:32} NOT REFUTED: {why}", engine.name, broken.id);
                    // What only samples may miss one.
                    good &= engine.name == STAND_IN;
                }
            }
            refuted.push(entry);
        }
        engines.push(json!({
            "name": engine.name, "version": engine.version, "about": engine.about,
            "results": results, "broken": refuted,
        }));
    }
    let report = json!({
        "format": 1, "digest": now, "properties": report::properties(), "engines": engines,
    });
    fs::create_dir_all(place.root.join("reports"))?;
    fs::write(&file, serde_json::to_string_pretty(&report)? + "\n")?;
    fs::write(
        place.root.join("reports/proofs.md"),
        report::markdown(&report),
    )?;
    fs::write(
        place.root.join("reports/proofs.html"),
        report::html(&report),
    )?;
    Ok(good)
}

fn found(
    counterexample: Option<ncp_proofs::engines::Counterexample>,
) -> Option<Result<Value, String>> {
    Some(
        counterexample
            .map(|found| report::counterexample(&found))
            .ok_or_else(|| "no counterexample".to_owned()),
    )
}
