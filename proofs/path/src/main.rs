//! `ncp-path`: holds the safety path around the kernel against its claims, and the engine against planted defects.
#![forbid(unsafe_code)]

use std::panic;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

use clap::Parser;
use ncp_defects::{Defect, TableError};
use ncp_path::claims::{CLAIMS, Claim, NOT_PROVED, TRUSTED};
use ncp_path::engine::{Counterexample, Outcome, Scope};
use ncp_path::subjects::{PRODUCTION, defects, harness};
use ncp_proofs::program::{self, WriteError};
use ncp_proofs::report::{Answer, Broken, Engine, Found, Shown, Verdict, Words, owned};
use serde_json::json;
use thiserror::Error;

/// Runs everything within the bounds through the safety path, and refutes the planted defects.
#[derive(Debug, Parser)]
struct Arguments {
    /// Write the result there, as JSON.
    #[arg(long)]
    json: Option<PathBuf>,
    /// Only the claims whose id holds this.
    #[arg(long)]
    only: Option<String>,
}

#[derive(Debug, Error)]
enum Failure {
    #[error("{0} has no harness")]
    NoHarness(String),
    #[error(transparent)]
    Defects(#[from] TableError),
    #[error(transparent)]
    Write(#[from] WriteError),
    #[error("a claim is not proved, or a planted defect not refuted")]
    NotShown,
}

fn main() -> ExitCode {
    program::end(env!("CARGO_BIN_NAME"), run(&Arguments::parse()))
}

fn run(arguments: &Arguments) -> Result<(), Failure> {
    // A panic of a subject is a counterexample and not this program's end.
    panic::set_hook(Box::new(|_| {}));
    let wanted = |id: &str| arguments.only.as_deref().is_none_or(|part| id.contains(part));
    let mut report = Engine {
        name: "path".to_owned(),
        version: env!("CARGO_PKG_VERSION").to_owned(),
        trusted: owned(&TRUSTED),
        not_proved: owned(&NOT_PROVED),
        ..Engine::default()
    };
    for claim in CLAIMS.iter().filter(|claim| wanted(claim.id)) {
        report.results.push(prove(claim)?);
    }
    for defect in defects()? {
        for id in defect.properties.iter().filter(|id| wanted(id)) {
            report.broken.push(refute(&defect, id)?);
        }
    }
    if let Some(file) = &arguments.json {
        program::write(&report, file)?;
    }
    let is_good = |answer: &Answer| matches!(answer.verdict, Verdict::Proved | Verdict::Tried);
    let is_shown = report.results.iter().all(is_good) && report.broken.iter().all(Broken::is_refuted);
    is_shown.then_some(()).ok_or(Failure::NotShown)
}

/// Runs a claim on the sources as they are.
fn prove(claim: &'static Claim) -> Result<Answer, Failure> {
    let harness = harness(PRODUCTION, claim.id).ok_or_else(|| Failure::NoHarness(claim.id.to_owned()))?;
    let began = Instant::now();
    let outcome = harness(Scope::Whole);
    let seconds = began.elapsed().as_secs_f64();
    let verdict = match &outcome.counterexample {
        Some(_) => Verdict::Refuted,
        None if outcome.is_kept() && claim.is_tried() => Verdict::Tried,
        None if outcome.is_kept() => Verdict::Proved,
        None => Verdict::Failed,
    };
    let said = outcome.counterexample.as_ref().map(|found| format!("{}: {:?}", found.check, found.picked));
    println!("{:8} {}: {} cases, {seconds:.1} s {}", verdict.as_str(), claim.id, outcome.cases, outcome.detail);
    if let Some(said) = said {
        println!("         {said}");
    }
    Ok(Answer {
        words: Some(Words {
            family: claim.family().to_owned(),
            rules: owned(claim.rules),
            sentence: claim.sentence.to_owned(),
            statement: claim.statement.to_owned(),
            bounds: claim.bounds.to_owned(),
            assumptions: owned(claim.assumptions),
        }),
        detail: outcome.detail.clone(),
        states: Some(outcome.cases),
        reached: outcome.reached.keys().map(|check| (*check).to_owned()).collect(),
        counterexample: outcome.counterexample.as_ref().map(shown),
        seconds: Some(seconds),
        ..Answer::new(claim.id, verdict)
    })
}

/// Looks for a case that a planted defect fails by a claim.
fn refute(defect: &Defect, id: &str) -> Result<Broken, Failure> {
    let name = &defect.name;
    let bent = harness(name, id).ok_or_else(|| Failure::NoHarness(format!("{name} by {id}")))?;
    let Outcome { cases, counterexample, .. } = bent(Scope::Whole);
    let found = counterexample.as_ref().map(shown);
    match &found {
        Some(found) => println!("refuted  {name} after {cases} cases: {}", found.check()),
        None => println!("NOT REFUTED {name} by {id}"),
    }
    Ok(Broken {
        id: format!("{name}/{}", id.split('/').next_back().unwrap_or_default()),
        property: id.to_owned(),
        family: id.split('/').next().unwrap_or_default().to_owned(),
        about: defect.about.clone(),
        file: defect.edit.first().map(|edit| edit.file.clone()),
        from: defect.edit.first().map(|edit| edit.code.clone()),
        to: defect.edit.first().map(|edit| edit.with.clone()),
        missed: found.is_none().then(|| "no counterexample".to_owned()),
        counterexample: found,
    })
}

fn shown(found: &Counterexample) -> Found {
    let inputs = found.picked.iter().map(|(name, what)| (name.clone(), json!(what))).collect();
    let no_vector = Some("the harness asks the part itself, and not a call".to_owned());
    Found { no_vector, ..Found::new(Shown::Inputs { check: found.check.to_owned(), inputs }) }
}
