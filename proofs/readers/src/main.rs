//! `ncp-readers`: holds the readers against their properties, and the engine against broken readers.
#![forbid(unsafe_code)]

use std::panic;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Parser;
use ncp_defects::{Defect, TableError};
use ncp_proofs::program::{self, WriteError};
use ncp_proofs::provers::native::{Native, Replay};
use ncp_proofs::report::{Answer, Broken, Engine, Found, Shown, Verdict, Words, owned};
use ncp_readers::broken;
use ncp_readers::exhaustive;
use ncp_readers::properties::strings::LONGEST;
use ncp_readers::properties::{PROPERTIES, Property, harness, is_shown, vector};
use serde_json::json;
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
    NoHarness(String),
    #[error(transparent)]
    Defects(#[from] TableError),
    #[error(transparent)]
    Write(#[from] WriteError),
    #[error("a property is not proved, or a broken reader not refuted")]
    NotShown,
}

const TRUSTED: [&str; 4] = [
    "rustc and the processor: the readers run as they were compiled",
    "the models: that the automata, and the reader of blocks that marks the owner of every byte, say what the text \
     says",
    "std's reader of UTF-8: bytes that are not UTF-8 never reach a reader of strings",
    "the class argument: within strings of 4 to 8 bytes, which are enumerated by classes, the readers answer \
     characters of one class alike; shown for shorter strings and for single characters only",
];
const NOT_PROVED: [&str; 4] = [
    "strings of more than 8 bytes, and so the longest segment (NCP-KEY-017)",
    "directories of more than 3 columns, blocks of other lengths than the bounds name, and so the limits on size \
     (NCP-BULK-015)",
    "fields of entries beside the values that the bounds name",
    "what reads JSON",
];

fn main() -> ExitCode {
    program::end(env!("CARGO_BIN_NAME"), run(&Arguments::parse()))
}

fn run(arguments: &Arguments) -> Result<(), Failure> {
    let mut report = Engine {
        name: "readers".to_owned(),
        version: env!("CARGO_PKG_VERSION").to_owned(),
        trusted: owned(&TRUSTED),
        not_proved: owned(&NOT_PROVED),
        ..Engine::default()
    };
    for property in PROPERTIES {
        report.results.push(prove(property)?);
    }
    // A panic of a broken reader is a counterexample and not this program's end.
    panic::set_hook(Box::new(|_| {}));
    for defect in broken::defects()? {
        for id in &defect.properties {
            report.broken.push(refute(&defect, id)?);
        }
    }
    if let Some(file) = &arguments.json {
        program::write(&report, file)?;
    }
    let is_shown = report.results.iter().all(Answer::is_proved) && report.broken.iter().all(Broken::is_refuted);
    is_shown.then_some(()).ok_or(Failure::NotShown)
}

/// Runs all inputs of a property through the readers of production.
fn prove(property: &'static Property) -> Result<Answer, Failure> {
    let harness = harness(property.id).ok_or_else(|| Failure::NoHarness(property.id.to_owned()))?;
    let outcome = exhaustive::run(property, harness.enumerate, None);
    let detail = match &outcome.counterexample {
        Some(found) => format!("{}: {:?}", found.check, found.choices),
        None => {
            format!("{} inputs judged, {} left aside", outcome.judged, outcome.inputs.saturating_sub(outcome.judged))
        }
    };
    let verdict = match &outcome.counterexample {
        Some(_) => Verdict::Refuted,
        None if outcome.is_proved() => Verdict::Proved,
        None => Verdict::Failed,
    };
    let Property { id, sentence, statement, bounds, .. } = *property;
    println!("{:8} {id}: {} inputs, {detail}, {:.1} s", verdict.as_str(), outcome.inputs, outcome.seconds);
    Ok(Answer {
        words: Some(Words {
            family: property.family.as_str().to_owned(),
            rules: owned(property.rules),
            sentence: sentence.to_owned(),
            statement: statement.to_owned(),
            bounds: bounds.to_owned(),
            assumptions: owned(property.assumptions),
        }),
        detail,
        states: Some(outcome.inputs),
        counterexample: outcome.counterexample.as_ref().map(shown),
        seconds: Some(outcome.seconds),
        ..Answer::new(id, verdict)
    })
}

/// Looks for an input that a broken reader fails; the readers of production have to keep it, and its vector has
/// to show it.
fn refute(defect: &Defect, id: &str) -> Result<Broken, Failure> {
    let name = &defect.name;
    let property = PROPERTIES.iter().find(|property| property.id == id);
    let (Some(property), Some(bent), Some(sound)) = (property, broken::harness(name, id), harness(id)) else {
        return Err(Failure::NoHarness(format!("{name} by {id}")));
    };
    let outcome = exhaustive::run(property, bent, None);
    let found = outcome.counterexample.and_then(|found| {
        let mut replay = Native::new(Replay { choices: found.ways().into(), length: LONGEST, ..Replay::default() });
        (sound.replay)(&mut replay);
        let is_kept = replay.failed.is_none() && !replay.reached.is_empty();
        let vector = vector(property, name, &found.ways())?;
        (is_kept && is_shown(property, found.check)).then(|| Found { vector: Some(vector), ..shown(&found) })
    });
    match &found {
        Some(found) => println!("refuted  {name} after {} inputs: {}", outcome.inputs, found.check()),
        None => println!("NOT REFUTED {name}"),
    }
    Ok(Broken {
        id: name.clone(),
        property: id.to_owned(),
        family: property.family.as_str().to_owned(),
        about: defect.about.clone(),
        file: None,
        from: None,
        to: None,
        missed: found.is_none().then(|| "no counterexample".to_owned()),
        counterexample: found,
    })
}

fn shown(found: &exhaustive::Counterexample) -> Found {
    let inputs = found.choices.iter().map(|(name, way)| (name.clone(), json!(way))).collect();
    Found::new(Shown::Inputs { check: found.check.to_owned(), inputs })
}
