//! How much the suite detects: the Rust peer with one planted defect after the other.
//!
//! A mutant is a peer that differs from the executable specification by a planted defect, and names the rule that the
//! defect breaks. [`hunt`] runs the suite against every mutant and finds out what becomes of it: the suite has to fail
//! it, and has to name that rule. [`MutantsReport`] holds what was found.
//!
//! The cases with requests above 64 KiB take longer than all others together. They are run only against a mutant whose
//! rule the others do not name.
//!
//! - `planted`: the copy of the sources that holds every defect behind a switch.
//! - `trial`: what becomes of one mutant.
//! - `report`: what was found of all.
//! - `command`: the command line.

pub(crate) mod command;
mod planted;
mod report;
pub(crate) mod trial;

pub(crate) use report::MutantsReport;
pub(crate) use trial::{Fate, Trial};

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;
use std::time::Duration;

use ncp_defects::{Defect, TableError};
use ncp_verifier::dictionary::Observed;
use ncp_verifier::peer::StartError;
use ncp_verifier::stop::Stop;
use ncp_verifier::suite::{Case, Suite};
use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::planted::PlantedError;

/// A peer with a planted defect, or with several.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(crate) struct Mutant {
    /// Its name: that of the defect.
    pub(crate) name: String,
    /// The defect, in a sentence.
    pub(crate) about: String,
    /// The audited finding that it brings back; `decision`: it inverts one; `classic`: a common mistake.
    pub(crate) finding: String,
    /// The rules that it breaks.
    pub(crate) rules: Vec<String>,
    /// Those of them that it breaks as directly as the first.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(crate) equal: Vec<String>,
    /// Further rules whose sentence it breaks, and how.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub(crate) also: BTreeMap<String, String>,
    /// How many of the rules, from the first, the suite must name: one for each defect.
    #[serde(skip)]
    owed: usize,
    /// The defects that are switched on.
    #[serde(skip)]
    defects: Vec<String>,
}

impl Mutant {
    /// The peer with one defect.
    fn of(defect: &Defect) -> Self {
        let Defect { name, about, finding, rules, equal, also, .. } = defect.clone();
        Self { defects: vec![name.clone()], name, about, finding, rules, equal, also, owed: 1 }
    }

    /// The peer with all defects of several.
    fn together(mutants: &[Self]) -> Self {
        let all = |part: fn(&Self) -> &str, between| mutants.iter().map(part).collect::<Vec<_>>().join(between);
        let mut rules: Vec<String> = Vec::new();
        for rule in mutants.iter().flat_map(Self::owed) {
            if !rules.contains(rule) {
                rules.push(rule.clone());
            }
        }
        Self {
            name: all(|one| &one.name, " + "),
            about: all(|one| &one.about, " "),
            finding: all(|one| &one.finding, " + "),
            owed: rules.len(),
            equal: Vec::new(),
            also: mutants.iter().flat_map(Self::broken).map(|(rule, how)| (rule.to_owned(), how.to_owned())).collect(),
            rules,
            defects: mutants.iter().flat_map(|one| one.defects.clone()).collect(),
        }
    }

    /// The rules whose sentence it breaks, and how.
    fn broken(&self) -> impl Iterator<Item = (&str, &str)> {
        let listed = self.rules.iter().map(|rule| (rule.as_str(), self.about.as_str()));
        listed.chain(self.also.iter().map(|(rule, how)| (rule.as_str(), how.as_str())))
    }

    /// Whether it breaks the sentence of this rule.
    pub(crate) fn breaks(&self, rule: &str) -> bool {
        self.broken().any(|(broken, _)| broken == rule)
    }

    /// Whether a verdict that begins with this rule begins rightly.
    pub(crate) fn is_led_by(&self, rule: &str) -> bool {
        self.rules.first().into_iter().chain(&self.equal).any(|own| own == rule)
    }

    /// The rules that the suite must name.
    pub(crate) fn owed(&self) -> &[String] {
        self.rules.get(..self.owed).unwrap_or_default()
    }
}

/// How to hunt.
#[derive(Debug, Clone)]
pub(crate) struct Hunt<'h> {
    /// The program that holds the mutants.
    pub(crate) program: &'h Path,
    /// The suite.
    pub(crate) suite: &'h Suite,
    /// Which of its cases.
    pub(crate) asks: Asks,
    /// How many mutants are on trial side by side.
    pub(crate) jobs: usize,
    /// How long the trial of one may take.
    pub(crate) limit: Duration,
    /// Ends everything.
    pub(crate) stop: &'h Stop,
}

/// Which cases a mutant is held against.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Asks {
    /// All of them: so that it is known what the verdict names.
    All,
    /// Those that cite a rule which its defect lists: enough to notice it, in a tenth of the time.
    OwnRules,
}

/// Why there is nothing to report.
#[derive(Debug, Error)]
pub(crate) enum MutantsError {
    #[error(transparent)]
    Table(#[from] TableError),
    #[error("the mutant {mutant} breaks no rule of the text: {rule:?}")]
    Rule { mutant: String, rule: String },
    #[error("the copy with the planted defects: {0}")]
    Planted(#[from] PlantedError),
    /// The program does not start, or does not speak the peer protocol.
    #[error(transparent)]
    Start(#[from] StartError),
    /// Without a defect, the peer does not conform: so what fails with one says nothing.
    #[error("without a mutant the peer fails {count} cases, {first} first")]
    Sick { count: usize, first: String },
    #[error("with {mutant} the suite does not come to its end in time")]
    Late { mutant: String },
    #[error("interrupted")]
    Interrupted,
}

/// The mutants of the defects in a folder.
fn list(defects: &[Defect], suite: &Suite) -> Result<Vec<Mutant>, MutantsError> {
    for Defect { name, rules, equal, also, .. } in defects {
        let unlisted = equal.iter().find(|rule| !rules.contains(rule));
        let unknown = rules.iter().chain(also.keys()).find(|rule| suite.requirement(rule).is_none()).or(unlisted);
        if rules.is_empty() || unknown.is_some() {
            return Err(MutantsError::Rule { mutant: name.clone(), rule: unknown.cloned().unwrap_or_default() });
        }
    }
    Ok(defects.iter().map(Mutant::of).collect())
}

/// Puts every mutant on trial, after the peer without a defect. `told` hears of each trial as it ends.
fn hunt(hunt: &Hunt<'_>, mutants: &[Mutant], told: &(dyn Fn(&Trial) + Sync)) -> Result<Vec<Trial>, MutantsError> {
    trial::healthy(hunt)?;
    let trials = side_by_side(hunt, mutants, |_, mutant| {
        let trial = trial::try_mutant(hunt, mutant);
        if let Ok(trial) = &trial {
            told(trial);
        }
        trial
    })?;
    trials.into_iter().collect()
}

/// How these cases end against each of the peers with these defects. `told` hears the number of each as it ends, from
/// 1.
pub(crate) fn observe(
    hunt: &Hunt<'_>,
    peers: &[Vec<String>],
    cases: &[&Case],
    told: &(dyn Fn(usize) + Sync),
) -> Result<Vec<Result<Observed, MutantsError>>, MutantsError> {
    side_by_side(hunt, peers, |number, defects| {
        let observed = trial::observe(hunt, defects, cases);
        told(number + 1);
        observed
    })
}

/// What comes of each, as many at a time as the hunt has jobs.
fn side_by_side<T: Sync, D: Send>(
    hunt: &Hunt<'_>,
    all: &[T],
    work: impl Fn(usize, &T) -> D + Sync,
) -> Result<Vec<D>, MutantsError> {
    let (next, done): (_, Mutex<Vec<(usize, D)>>) = (AtomicUsize::new(0), Mutex::default());
    thread::scope(|scope| {
        for _ in 0..hunt.jobs.clamp(1, all.len().max(1)) {
            scope.spawn(|| {
                while !hunt.stop.is_set() {
                    let number = next.fetch_add(1, Ordering::Relaxed);
                    let Some(one) = all.get(number) else {
                        break;
                    };
                    let came = work(number, one);
                    done.lock().unwrap_or_else(PoisonError::into_inner).push((number, came));
                }
            });
        }
    });
    if hunt.stop.is_set() {
        return Err(MutantsError::Interrupted);
    }
    let mut done = done.into_inner().unwrap_or_else(PoisonError::into_inner);
    done.sort_by_key(|(number, _)| *number);
    Ok(done.into_iter().map(|(_, came)| came).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_verdict_begins_rightly_with_the_first_rule_of_a_defect_and_with_those_that_it_breaks_as_directly() {
        let rules = ["NCP-CODEC-005", "NCP-CODEC-006", "NCP-CODEC-001"].map(str::to_owned).to_vec();
        let mutant = Mutant::of(&Defect { rules, equal: vec!["NCP-CODEC-006".to_owned()], ..Defect::default() });
        assert!(mutant.is_led_by("NCP-CODEC-005") && mutant.is_led_by("NCP-CODEC-006"));
        assert!(!mutant.is_led_by("NCP-CODEC-001") && !mutant.is_led_by("NCP-CODEC-002"));
    }
}
