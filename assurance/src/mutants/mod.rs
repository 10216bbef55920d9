//! How much the suite detects: the Rust peer with one defect after the other.
//!
//! A mutant is a peer that differs from the executable specification by one defect, and names the rule that the defect
//! breaks. [`hunt`] runs the suite against every mutant and finds out what becomes of it: the suite has to fail it, and
//! has to name that rule. [`MutantsReport`] holds what was found, and renders it.
//!
//! The cases with requests above 64 KiB take longer than all others together. They are run only against a mutant whose
//! rule the others do not name.

pub(crate) mod command;
mod report;
mod trial;

pub use report::MutantsReport;
pub use trial::{Fate, Named, Trial};

use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::Mutex;
use std::sync::PoisonError;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::Duration;

use serde::{Deserialize, Serialize};

use ncp_verifier::peer::StartError;
use ncp_verifier::run::Stop;
use ncp_verifier::suite::Suite;

/// A mutant, as the program that holds all of them lists it.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Mutant {
    /// Its name.
    pub name: String,
    /// The defect, in a sentence.
    pub about: String,
    /// The audited finding that it brings back; `decision`: it inverts one; `classic`: a common mistake.
    pub finding: String,
    /// The rules that it breaks; the suite must name the first.
    pub rules: Vec<String>,
}

/// How to hunt.
#[derive(Debug, Clone)]
pub struct Hunt<'h> {
    /// The program that holds the mutants.
    pub program: &'h Path,
    /// The suite.
    pub suite: &'h Suite,
    /// How many mutants are on trial side by side.
    pub jobs: usize,
    /// How long the trial of one may take.
    pub limit: Duration,
    /// Ends everything.
    pub stop: &'h Stop,
}

/// Why there is nothing to report.
#[derive(Debug, thiserror::Error)]
pub enum MutantsError {
    /// The program does not list its mutants.
    #[error("{program} --list: {why}")]
    List {
        /// The program.
        program: String,
        /// What is wrong.
        why: String,
    },
    /// A mutant says that it breaks a rule that the text does not have, or no rule.
    #[error("the mutant {mutant} breaks no rule of the text: {rule:?}")]
    Rule {
        /// The mutant.
        mutant: String,
        /// What it says.
        rule: String,
    },
    /// The program does not start, or does not speak the peer protocol.
    #[error(transparent)]
    Start(#[from] StartError),
    /// Without a defect, the peer does not conform: so what fails with one says nothing.
    #[error("without a mutant the peer fails {count} cases, {first} first")]
    Sick {
        /// How many.
        count: usize,
        /// The first.
        first: String,
    },
    /// Ctrl-C.
    #[error("interrupted")]
    Interrupted,
}

/// The mutants of a program.
///
/// # Errors
/// The program cannot be run, does not print a list, or a mutant names no rule of the text.
pub fn list(program: &Path, suite: &Suite) -> Result<Vec<Mutant>, MutantsError> {
    let fault = |why: String| MutantsError::List { program: program.display().to_string(), why };
    let output =
        Command::new(program).arg("--list").stdin(Stdio::null()).output().map_err(|error| fault(error.to_string()))?;
    if !output.status.success() {
        return Err(fault(output.status.to_string()));
    }
    let mutants: Vec<Mutant> = serde_json::from_slice(&output.stdout).map_err(|error| fault(error.to_string()))?;
    for Mutant { name, rules, .. } in &mutants {
        let unknown = rules.iter().find(|rule| suite.requirement(rule).is_none());
        if rules.is_empty() || unknown.is_some() {
            return Err(MutantsError::Rule { mutant: name.clone(), rule: unknown.cloned().unwrap_or_default() });
        }
    }
    Ok(mutants)
}

/// Puts every mutant on trial, after the peer without a defect. `told` hears of each trial as it ends.
///
/// # Errors
/// The peer does not start, does not conform without a defect, or all was interrupted.
pub fn hunt(hunt: &Hunt<'_>, mutants: &[Mutant], told: &(dyn Fn(&Trial) + Sync)) -> Result<Vec<Trial>, MutantsError> {
    trial::healthy(hunt)?;
    let next = AtomicUsize::new(0);
    let trials: Mutex<Vec<(usize, Result<Trial, MutantsError>)>> = Mutex::default();
    thread::scope(|scope| {
        for _ in 0..hunt.jobs.clamp(1, mutants.len().max(1)) {
            scope.spawn(|| {
                while !hunt.stop.is_set() {
                    let number = next.fetch_add(1, Ordering::Relaxed);
                    let Some(mutant) = mutants.get(number) else {
                        break;
                    };
                    let trial = trial::try_mutant(hunt, mutant);
                    if let Ok(trial) = &trial {
                        told(trial);
                    }
                    trials.lock().unwrap_or_else(PoisonError::into_inner).push((number, trial));
                }
            });
        }
    });
    if hunt.stop.is_set() {
        return Err(MutantsError::Interrupted);
    }
    let mut trials = trials.into_inner().unwrap_or_else(PoisonError::into_inner);
    trials.sort_by_key(|(number, _)| *number);
    trials.into_iter().map(|(_, trial)| trial).collect()
}
