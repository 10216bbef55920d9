//! `ncp-readers`: holds the readers against their properties, and the engine against broken readers.
#![forbid(unsafe_code)]

use std::path::PathBuf;
use std::process::ExitCode;
use std::{fs, io, panic};

use clap::Parser;
use ncp_proofs::engines::native::{Native, Replay};
use ncp_readers::broken::{self, BROKEN, Broken};
use ncp_readers::exhaustive;
use ncp_readers::properties::strings::LONGEST;
use ncp_readers::properties::{PROPERTIES, Property, harness, is_shown, vector};
use serde_json::{Value, json};
use thiserror::Error;

/// Runs every input within the bounds through the readers, and refutes the broken ones.
#[derive(Debug, Parser)]
struct Arguments {
    /// Write the result there, as JSON.
    #[arg(long)]
    json: Option<PathBuf>,
}

#[derive(Debug, Error)]
enum Failure {
    #[error("{0} has no harness")]
    NoHarness(&'static str),
    #[error("cannot write {0}: {1}")]
    Write(PathBuf, io::Error),
    #[error("a property is not proved, or a broken reader not refuted")]
    NotShown,
}

const TRUSTED: [&str; 4] = [
    "rustc and the processor: the readers run as they were compiled",
    "the models: that the automata, and the reader of blocks that marks the owner of every byte, say what the text says",
    "std's reader of UTF-8: bytes that are not UTF-8 never reach a reader of strings",
    "the class argument: within strings of 4 to 8 bytes, which are enumerated by classes, the readers answer characters of one class alike; shown for shorter strings and for single characters only",
];
const NOT_PROVED: [&str; 4] = [
    "strings of more than 8 bytes, and so the longest segment (NCP-KEY-017)",
    "directories of more than 3 columns, blocks of other lengths than the bounds name, and so the limits on size (NCP-BULK-015)",
    "fields of entries beside the values that the bounds name",
    "what reads JSON",
];

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("ncp-readers: {failure}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &Arguments) -> Result<(), Failure> {
    let mut is_shown = true;
    let mut properties = Vec::new();
    for property in PROPERTIES {
        let proved = prove(property)?;
        is_shown &= proved["result"] == "proved";
        properties.push(proved);
    }
    // A panic of a broken reader is a counterexample and not this program's end.
    panic::set_hook(Box::new(|_| {}));
    let mut refuted = Vec::new();
    for broken in BROKEN {
        let found = refute(broken)?;
        is_shown &= found["refuted"] == true;
        refuted.push(found);
    }
    if let Some(file) = &arguments.json {
        let report = json!({
            "engine": "exhaustive", "version": env!("CARGO_PKG_VERSION"),
            "properties": properties, "broken": refuted, "trusted": TRUSTED, "not_proved": NOT_PROVED,
        });
        fs::write(file, format!("{report:#}\n")).map_err(|error| Failure::Write(file.clone(), error))?;
    }
    is_shown.then_some(()).ok_or(Failure::NotShown)
}

/// Runs all inputs of a property through the readers of production.
fn prove(property: &'static Property) -> Result<Value, Failure> {
    let harness = harness(property.id).ok_or(Failure::NoHarness(property.id))?;
    let outcome = exhaustive::run(property, harness.enumerate, None);
    let why = match &outcome.counterexample {
        Some(found) => format!("{}: {:?}", found.check, found.choices),
        None => {
            format!("{} inputs judged, {} left aside", outcome.judged, outcome.inputs.saturating_sub(outcome.judged))
        }
    };
    let result = match &outcome.counterexample {
        Some(_) => "refuted",
        None if outcome.is_proved() => "proved",
        None => "failed",
    };
    println!("{result:8} {}: {} inputs, {why}, {:.1} s", property.id, outcome.inputs, outcome.seconds);
    Ok(json!({
        "id": property.id, "family": property.family.as_str(), "rules": property.rules,
        "sentence": property.sentence, "formal": property.statement, "bounds": property.bounds,
        "assumptions": property.assumptions, "result": result, "why": why, "states": outcome.inputs,
        "seconds": (outcome.seconds * 100.0).round() / 100.0,
    }))
}

/// Looks for an input that a broken reader fails; the readers of production have to keep it, and its vector has
/// to show it.
fn refute(broken: &'static Broken) -> Result<Value, Failure> {
    let property = PROPERTIES.iter().find(|p| p.id == broken.property);
    let bent = broken::harness(broken.id, broken.property);
    let sound = harness(broken.property);
    let (Some(property), Some(bent), Some(sound)) = (property, bent, sound) else {
        return Err(Failure::NoHarness(broken.id));
    };
    let outcome = exhaustive::run(property, bent, None);
    let mut entry = json!({
        "id": broken.id, "property": broken.property,
        "about": format!("{}: `{}` → `{}`", broken.file, flat(broken.from), flat(broken.to)),
        "inputs": outcome.inputs,
    });
    let found = outcome.counterexample.and_then(|found| {
        let mut replay = Native::new(Replay { choices: found.ways().into(), length: LONGEST, ..Replay::default() });
        (sound.replay)(&mut replay);
        let is_kept = replay.failed.is_none() && !replay.reached.is_empty();
        let vector = vector(property, broken.id, &found.ways())?;
        (is_kept && is_shown(property, found.check)).then_some((found, vector))
    });
    entry["refuted"] = json!(found.is_some());
    match found {
        Some((found, vector)) => {
            println!("refuted  {} after {} inputs: {}", broken.id, outcome.inputs, found.check);
            entry["counterexample"] = json!({ "check": found.check, "inputs": found.choices });
            entry["vector"] = vector;
        }
        None => println!("NOT REFUTED {}", broken.id),
    }
    Ok(entry)
}

fn flat(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
