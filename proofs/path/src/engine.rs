//! The engine: a harness on every combination of what it picks from, natively; a panic refutes, too.

use std::collections::BTreeMap;
use std::fmt::Debug;
use std::panic::{AssertUnwindSafe, catch_unwind};

use ncp_proofs::provers::native::{Draw, Enumerate};

/// The check that fails where the code panics.
pub const PANICS: &str = "nothing panics";

/// A harness: it runs everything within bounds that many times smaller in tests, and says what came of it.
pub type Harness = fn(Scope) -> Outcome;

/// How much is run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scope {
    /// All that a claim says.
    Whole,
    /// What takes a moment.
    Short,
}

/// What came of a harness.
#[derive(Debug, Clone, Default)]
pub struct Outcome {
    /// Cases that were run, up to the first that refutes.
    pub cases: u64,
    /// How often each check was reached.
    pub reached: BTreeMap<&'static str, u64>,
    /// The first case that refutes.
    pub counterexample: Option<Counterexample>,
    /// What else is to be said.
    pub detail: String,
}

/// A case that breaks a claim.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Counterexample {
    /// The check that fails.
    pub check: &'static str,
    /// What was picked, by name and in order, and what was said of it.
    pub picked: Vec<(String, String)>,
}

impl Outcome {
    /// Whether all cases keep the claim, and each check was reached.
    #[must_use]
    pub fn is_kept(&self) -> bool {
        self.counterexample.is_none() && !self.reached.is_empty() && self.reached.values().all(|count| *count > 0)
    }
}

/// One case: what a harness picks, and what it checks.
#[derive(Debug)]
pub struct Case {
    draw: Enumerate,
    /// How much is run.
    pub scope: Scope,
    reached: Vec<(&'static str, u64)>,
    failed: Option<&'static str>,
    picked: Option<Vec<(String, String)>>,
}

impl Case {
    /// One of 0, 1, … `count` − 1.
    pub fn below(&mut self, name: &str, count: usize) -> usize {
        let way = self.draw.choice(count);
        self.say(name, &way);
        way
    }

    /// One of these.
    pub fn pick<'a, T: Debug>(&mut self, name: &str, from: &'a [T]) -> &'a T {
        let way = self.draw.choice(from.len());
        let one = &from[way];
        self.say(name, one);
        one
    }

    /// Yes or no.
    pub fn either(&mut self, name: &str) -> bool {
        *self.pick(name, &[false, true])
    }

    /// This many in a short run, that many in a whole one.
    #[must_use]
    pub fn bound<T>(&self, short: T, whole: T) -> T {
        if self.scope == Scope::Short { short } else { whole }
    }

    /// Says what has to hold.
    pub fn check(&mut self, name: &'static str, holds: bool) {
        match self.reached.iter_mut().find(|(known, _)| *known == name) {
            Some((_, count)) => *count += 1,
            None => self.reached.push((name, 1)),
        }
        if !holds && self.failed.is_none() {
            self.failed = Some(name);
        }
    }

    /// Notes something for a counterexample.
    pub fn say(&mut self, name: &str, what: &dyn Debug) {
        if let Some(picked) = &mut self.picked {
            picked.push((name.to_owned(), format!("{what:?}")));
        }
    }
}

/// Runs a harness on every combination.
pub fn every(scope: Scope, harness: fn(&mut Case)) -> Outcome {
    let draw = Enumerate::new(&[], &[], 0);
    let mut case = Case { draw, scope, reached: Vec::new(), failed: None, picked: None };
    let mut cases = 0;
    // One guard for all runs; behind a panic the choices still stand.
    let ended = catch_unwind(AssertUnwindSafe(|| {
        loop {
            cases += 1;
            harness(&mut case);
            if case.failed.is_some() || !case.draw.advance() {
                break;
            }
        }
    }));
    let failed = case.failed.or_else(|| ended.is_err().then_some(PANICS));
    let counterexample = failed.map(|check| {
        // Once more, to note what was picked.
        case.picked = Some(Vec::new());
        case.draw.restart();
        let _ = catch_unwind(AssertUnwindSafe(|| harness(&mut case)));
        Counterexample { check, picked: case.picked.take().unwrap_or_default() }
    });
    Outcome { cases, reached: case.reached.into_iter().collect(), counterexample, detail: String::new() }
}
