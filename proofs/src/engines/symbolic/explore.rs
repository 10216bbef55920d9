//! The paths of a harness, the questions that they raise, and whether they are all.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::panic::{AssertUnwindSafe, catch_unwind};

use super::smt::{self, Question};
use super::{Stop, cover};
use crate::engines::outcome::Patience;
use crate::harness::said;
use crate::provers::terms::{self, Decision, Path, Symbolic};

/// More paths than these are a failure of the property.
const MOST_PATHS: u64 = 1_000_000;

/// What the exploration of a harness left.
#[derive(Debug, Default)]
pub(super) struct Explored {
    pub(super) paths: u64,
    pub(super) by_evaluation: u64,
    /// The checks that are not true by evaluation, on all paths.
    pub(super) raised: u64,
    pub(super) reached: BTreeSet<&'static str>,
    /// Each question with the paths that raise it, by their places in `open`.
    pub(super) questions: BTreeMap<Question, Vec<usize>>,
    open: Vec<Path>,
    decisions: Vec<Vec<Decision>>,
}

/// Explores all paths of a harness with sequences of at most this length.
///
/// A question holds only those decisions of its path that its check speaks of, so that many paths share
/// it: with fewer decisions it claims more. Where that is too much, the paths are asked one by one.
///
/// # Errors
/// The path cap, a panic of the kernel, or no patience.
pub(super) fn explore(length: usize, harness: fn(&mut Symbolic), patience: &Patience) -> Result<Explored, Stop> {
    terms::clear();
    let mut all = Explored::default();
    let mut atoms: HashMap<u32, BTreeSet<u32>> = HashMap::new();
    loop {
        let run = || terms::run(length, harness);
        let mut path = catch_unwind(AssertUnwindSafe(run)).map_err(|panic| Stop::Panics(said(&*panic)))?;
        all.decisions.push(std::mem::take(&mut path.decisions));
        all.paths += 1;
        all.by_evaluation += path.by_evaluation;
        all.raised += path.checks.len() as u64;
        all.reached.extend(&path.reached);
        for &(check, formula) in &path.checks {
            let atoms = atoms.entry(formula).or_insert_with(|| smt::atoms(formula));
            let mut literals = path.literals.clone();
            literals.retain(|(literal, _)| atoms.contains(literal));
            literals.sort_unstable();
            let question = Question { check, formula, literals };
            all.questions.entry(question).or_default().push(all.open.len());
        }
        if !path.checks.is_empty() {
            all.open.push(path);
        }
        if !terms::turn() {
            return Ok(all);
        }
        if all.paths >= MOST_PATHS {
            return Err(Stop::Paths(MOST_PATHS));
        }
        if all.paths.is_multiple_of(1024) {
            patience.left()?;
        }
    }
}

impl Explored {
    /// The questions of one path after the other, with all of its decisions, where the shared question
    /// was answered with `sat`.
    pub(super) fn one_by_one(&self, question: &Question) -> Vec<(Question, &Path)> {
        let paths = self.questions.get(question).map_or(&[][..], Vec::as_slice);
        let paths = paths.iter().filter_map(|nth| self.open.get(*nth));
        paths
            .map(|path| {
                let literals = path.literals.clone();
                (Question { literals, ..question.clone() }, path)
            })
            .collect()
    }

    /// The questions whether there are inputs whose path was not explored, each to be answered with `unsat`; and how
    /// many they are.
    pub(super) fn uncovered(&self, title: &str) -> (String, usize) {
        cover::script(title, &self.decisions)
    }
}
