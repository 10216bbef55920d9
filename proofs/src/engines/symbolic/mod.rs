//! Symbolic execution of the kernel, its obligations decided by bitwuzla and cross-checked by z3.

mod smt;
mod solver;

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path as FilePath;
use std::time::{Duration, Instant};

pub use solver::{Answer, SolverError, Solvers, read_answers, read_values};

use super::outcome::{Outcome, Patience, Verdict};
use super::{bounds, enumeration, standin};
use crate::counterexample::{Counterexample, Drawn};
use crate::harness::{Harness, run_once, said};
use crate::properties::Property;
use crate::provers::native::{Native, Replay, Source};
use crate::provers::terms::{self, Guide, Path, Symbolic};
use smt::Question;

/// More paths than these are a failure of the property.
const MOST_PATHS: u64 = 4_000_000;
/// Obligations in one file.
const PER_FILE: usize = 400;
/// Seconds of the processor for one file of obligations.
const SECONDS: u32 = 300;
/// What z3 may take for one obligation, in its own steps.
const CROSS_STEPS: u32 = 200_000;
/// And for one file, in seconds of the processor.
const CROSS_SECONDS: u32 = 5;

/// What the exploration of a harness left.
#[derive(Debug, Default)]
struct Explored {
    paths: u64,
    by_evaluation: u64,
    open: Vec<Path>,
    /// Each question with the paths that raise it, by their places in `open`.
    questions: BTreeMap<Question, Vec<usize>>,
    reached: BTreeSet<&'static str>,
}

/// Explores all paths of a harness.
///
/// A question holds only those decisions of its path that its check speaks of, so that many paths share
/// it: with fewer decisions it claims more. Where that is too much, the paths are asked one by one.
///
/// # Errors
/// The path cap, a panic of the kernel, or no patience.
fn explore(property: &Property, harness: fn(&mut Symbolic), patience: &Patience) -> Result<Explored, String> {
    terms::clear();
    let mut all = Explored::default();
    let mut atoms: HashMap<u32, BTreeSet<u32>> = HashMap::new();
    loop {
        let run = || terms::run(bounds::of(property.id).length, harness);
        let path = catch_unwind(AssertUnwindSafe(run)).map_err(|panic| said(&*panic))?;
        all.paths += 1;
        all.by_evaluation += path.by_evaluation;
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
            return Err(format!("more than {MOST_PATHS} paths"));
        }
        if all.paths.is_multiple_of(1024) {
            let paths = all.paths;
            patience.left().map_err(|why| format!("{paths} paths explored, and more to come: {why}"))?;
        }
    }
}

impl Explored {
    /// The questions of one path after the other, with all of its decisions, where the shared question
    /// was answered with `sat`.
    fn one_by_one(&self, question: &Question) -> Vec<(Question, &Path)> {
        let paths = self.questions.get(question).map_or(&[][..], Vec::as_slice);
        let paths = paths.iter().filter_map(|nth| self.open.get(*nth));
        paths
            .map(|path| {
                let literals = path.literals.clone();
                (Question { literals, ..question.clone() }, path)
            })
            .collect()
    }
}

/// Proves a property of a kernel; leaves the obligations in `evidence`.
pub fn prove(property: &Property, harness: &Harness, solvers: &Solvers, evidence: &FilePath) -> Outcome {
    let began = Instant::now();
    let mut outcome = Outcome::new(began);
    let result = try_prove(property, harness, solvers, evidence, &mut outcome);
    match result {
        Ok(verdict) => outcome.verdict = verdict,
        Err(why) => (outcome.verdict, outcome.detail) = (Verdict::Failed, why),
    }
    outcome.seconds = began.elapsed().as_secs_f64();
    outcome
}

fn try_prove(
    property: &Property,
    harness: &Harness,
    solvers: &Solvers,
    evidence: &FilePath,
    outcome: &mut Outcome,
) -> Result<Verdict, String> {
    let explored = explore(property, harness.symbolic, &solvers.patience)?;
    (outcome.paths, outcome.by_evaluation) = (explored.paths, explored.by_evaluation);
    outcome.reached = explored.reached.iter().copied().collect();
    let folder = evidence.join(property.id);
    let in_folder = |error: std::io::Error| format!("{}: {error}", folder.display());
    if folder.exists() {
        fs::remove_dir_all(&folder).map_err(in_folder)?;
    }
    fs::create_dir_all(&folder).map_err(in_folder)?;

    // First the shared questions; a `sat` there is none yet, but asks for the paths.
    let shared: Vec<&Question> = explored.questions.keys().collect();
    let mut proved: Vec<Question> = Vec::new();
    let mut single: Vec<(Question, &Path)> = Vec::new();
    let draft = folder.join("draft.smt2");
    for chunk in shared.chunks(PER_FILE) {
        let answers = ask(solvers, &draft, chunk)?;
        for (question, answer) in chunk.iter().zip(answers) {
            match answer {
                Answer::Unsat => proved.push((*question).clone()),
                Answer::Unknown => return Err("bitwuzla: unknown".to_owned()),
                Answer::Sat => single.extend(explored.one_by_one(question)),
            }
        }
    }
    for chunk in single.chunks(PER_FILE) {
        let questions: Vec<&Question> = chunk.iter().map(|(question, _)| question).collect();
        let answers = ask(solvers, &draft, &questions)?;
        for ((question, path), answer) in chunk.iter().zip(answers) {
            match answer {
                Answer::Unsat => proved.push(question.clone()),
                Answer::Unknown => return Err("bitwuzla: unknown".to_owned()),
                Answer::Sat => {
                    let found = counterexample(property, harness, question, path, solvers, &draft, None)?;
                    outcome.counterexample = Some(found);
                    return Ok(Verdict::Refuted);
                }
            }
        }
    }
    fs::remove_file(&draft).ok();

    // What was proved, for others to ask again; and at once the second solver.
    proved.sort();
    outcome.obligations = proved.len() as u64;
    for (nth, chunk) in proved.chunks(PER_FILE).enumerate() {
        let name = format!("{}/{:03}.smt2", property.id, nth + 1);
        let file = evidence.join(&name);
        let title = format!(
            "{}: {}\nEach answer has to be unsat, {} of them. A question is a check that fails where the kernel has \
             taken\nthese decisions. x… are the doubles in the order in which the harness draws them, q… the seqs.",
            property.id,
            property.statement,
            chunk.len()
        );
        let questions: Vec<&Question> = chunk.iter().collect();
        let (script, _) = smt::script(&title, &questions, false, None);
        fs::write(&file, script).map_err(in_folder)?;
        outcome.evidence.push(name);
        let answers = solvers.bitwuzla(&file, chunk.len(), SECONDS).map_err(|error| format!("bitwuzla: {error}"))?;
        if answers.iter().any(|answer| *answer != Answer::Unsat) {
            return Err("bitwuzla does not answer unsat again".to_owned());
        }
        let answers =
            solvers.z3(&file, chunk.len(), CROSS_STEPS, CROSS_SECONDS).map_err(|error| format!("z3: {error}"))?;
        let count = |answer| answers.iter().filter(|a| **a == Some(answer)).count() as u64;
        outcome.cross_checked += count(Answer::Unsat);
        if count(Answer::Sat) > 0 {
            return Err("z3 contradicts bitwuzla: sat".to_owned());
        }
    }
    Ok(Verdict::Proved)
}

/// Where the inputs of a counterexample come from. In each case bitwuzla said `sat` of the question that they raise,
/// and the harness failed on them on doubles.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// The solver found them.
    Model,
    /// Samples broke the harness on doubles; the solver confirmed them with the inputs fixed.
    Sampled,
    /// The same, by the values of the enumeration.
    Enumerated,
}

impl Origin {
    /// Its words in reports.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Model => "a model of bitwuzla, replayed on doubles",
            Self::Sampled => "a sampled hint, confirmed by bitwuzla with the inputs fixed, replayed on doubles",
            Self::Enumerated => "an enumerated hint, confirmed by bitwuzla with the inputs fixed, replayed on doubles",
        }
    }
}

/// Looks for a counterexample only: for kernels that are broken.
///
/// Hints come first: inputs that break the harness on doubles. Their path is run on terms, and the question
/// that it raises goes to the solver together with the inputs; the solver has to say `sat`. So the solver need
/// not search, and it is shown that no proof would have come of it. Without a hint the solver searches.
///
/// # Errors
/// No solver, or it does not answer, or none of its models fails on doubles.
pub fn refute(
    property: &Property,
    harness: &Harness,
    solvers: &Solvers,
    file: &FilePath,
) -> Result<Option<(Counterexample, Origin)>, String> {
    let patience = Patience::of(REFUTE);
    if let Some((hint, origin)) = hint(property, harness) {
        terms::clear();
        let run = || terms::run_guided(bounds::of(property.id).length, harness.symbolic, hint.clone());
        let (path, broken) = catch_unwind(AssertUnwindSafe(run)).map_err(|panic| said(&*panic))?;
        let Some(&(check, formula)) = broken.first() else {
            return Err("what fails on doubles does not on terms".to_owned());
        };
        let literals = path.literals.clone();
        let question = Question { check, formula, literals };
        return counterexample(property, harness, &question, &path, solvers, file, Some(&hint))
            .map(|found| Some((found, origin)));
    }
    let explored = explore(property, harness.symbolic, &patience)?;
    let mut questions: Vec<&Question> = explored.questions.keys().collect();
    questions.sort_by_cached_key(|question| smt::size(question.formula));
    for chunk in questions.chunks(25) {
        let answers = ask_for(solvers, file, chunk, REFUTE_SECONDS, None)?;
        for (question, _) in chunk.iter().zip(answers).filter(|(_, a)| *a == Answer::Sat) {
            for (question, path) in explored.one_by_one(question).into_iter().take(8) {
                let answers = ask_for(solvers, file, &[&question], REFUTE_SECONDS, None)?;
                if answers == [Answer::Sat] {
                    return counterexample(property, harness, &question, path, solvers, file, None)
                        .map(|found| Some((found, Origin::Model)));
                }
            }
        }
    }
    Ok(None)
}

/// How long one broken kernel is searched for a counterexample.
const REFUTE: Duration = Duration::from_secs(600);
/// Seconds of the processor for one search of the solver for a counterexample.
const REFUTE_SECONDS: u32 = 30;
/// How many samples are tried for a hint.
const HINTS: u64 = 3_000_000;

/// Inputs that break the harness on doubles: of samples, or of the values that are enumerated.
fn hint(property: &Property, harness: &Harness) -> Option<(Guide, Origin)> {
    let most = bounds::of(property.id).length;
    let sampled = standin::run(harness, HINTS, most).counterexample;
    let (found, origin) = match sampled {
        Some(found) => (found, Origin::Sampled),
        None => {
            let all = enumeration::run(property, harness, most)?;
            (all.counterexample?, Origin::Enumerated)
        }
    };
    let mut guide = Guide::default();
    for (_, drawn) in found.inputs {
        match drawn {
            Drawn::Scalar(value) => guide.scalars.push(value),
            Drawn::Seq(value) => guide.seqs.push(value),
            Drawn::Choice(value) => guide.choices.push(value),
        }
    }
    Some((guide, origin))
}

fn ask(solvers: &Solvers, file: &FilePath, questions: &[&Question]) -> Result<Vec<Answer>, String> {
    let left = u32::try_from(solvers.patience.left()?.as_secs()).unwrap_or(SECONDS);
    ask_for(solvers, file, questions, left.clamp(1, SECONDS), None)
}

fn ask_for(
    solvers: &Solvers,
    file: &FilePath,
    questions: &[&Question],
    seconds: u32,
    inputs: Option<&Guide>,
) -> Result<Vec<Answer>, String> {
    let (script, _) = smt::script("draft", questions, false, inputs);
    fs::write(file, script).map_err(|error| format!("{}: {error}", file.display()))?;
    solvers.bitwuzla(file, questions.len(), seconds).map_err(|error| format!("bitwuzla: {error}"))
}

/// The solver's model of one path, replayed on doubles.
fn counterexample(
    property: &Property,
    harness: &Harness,
    question: &Question,
    path: &Path,
    solvers: &Solvers,
    file: &FilePath,
    inputs: Option<&Guide>,
) -> Result<Counterexample, String> {
    let (script, variables) = smt::script(property.id, &[question], true, inputs);
    fs::write(file, script).map_err(|error| error.to_string())?;
    let printed = solvers.bitwuzla_prints(file, SECONDS).map_err(|error| error.to_string())?;
    let first = printed.split('\n').next().unwrap_or_default();
    if read_answers(first, 1) != Ok(vec![Answer::Sat]) {
        return Err(format!("the solver finds no counterexample: {first:?}"));
    }
    let values = read_values(&printed);
    let value = |name: String| values.iter().find(|(n, _)| *n == name).map(|(_, bits)| *bits);
    let most = |set: &std::collections::BTreeSet<u32>| set.last().map_or(0, |last| last + 1);
    let choices = path.choices.iter().copied().collect();
    let length = bounds::of(property.id).length;
    let replay = inputs.map(|inputs| Replay {
        scalars: inputs.scalars.iter().copied().collect(),
        seqs: inputs.seqs.iter().copied().collect(),
        choices: inputs.choices.iter().copied().collect(),
        length,
    });
    let replay = replay.unwrap_or_else(|| Replay {
        scalars: (0..most(&variables.doubles))
            .map(|nth| f64::from_bits(value(format!("x{nth}")).unwrap_or(0)))
            .collect(),
        seqs: (0..most(&variables.seqs)).map(|nth| value(format!("q{nth}")).unwrap_or(0).cast_signed()).collect(),
        choices,
        length,
    });
    let mut run = Native::new(Source::Replay(replay));
    run.keep = true;
    run_once(harness.native, &mut run);
    match run.failed {
        Some(check) => Ok(Counterexample { check: check.to_owned(), inputs: run.drawn }),
        None => Err("the solver's model does not fail on doubles".to_owned()),
    }
}
