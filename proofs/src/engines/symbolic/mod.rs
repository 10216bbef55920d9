//! Symbolic execution of the kernel, its obligations decided by bitwuzla and cross-checked by z3.
//!
//! Whatever limits it is counted and not timed, so that the same sources have the same answers on every machine.

pub mod controls;
mod cover;
mod explore;
mod smt;
mod solver;

use std::fs;
use std::io;
use std::path::{Path as FilePath, PathBuf};
use std::time::Instant;

use thiserror::Error;

pub use solver::{Answer, Limits, SolverError, Solvers, read_answers, read_values};

use super::outcome::{Ended, Outcome, Verdict};
use super::{bounds, enumeration, standin};
use crate::counterexample::{Counterexample, Drawn};
use crate::harness::{Harness, run_once, said};
use crate::properties::Property;
use crate::provers::native::{Native, Replay, Source};
use crate::provers::terms::{self, Guide, Path};
use explore::{Explored, explore};
use smt::{Inputs, Question};

/// Obligations in one file.
const PER_FILE: usize = 400;
/// Questions of a search in one file.
const PER_SEARCH: usize = 25;
/// How much further a solver goes where it confirms what numbers have found than where it searches.
const CONFIRMING: u64 = 10;
/// So many paths of one question are searched for a counterexample.
const PATHS_SEARCHED: usize = 400;
/// How many samples are tried for a hint.
const HINTS: u64 = 300_000;

/// Why the engine has no word on a property.
#[derive(Debug, Error)]
pub enum Stop {
    /// On some path of the terms.
    #[error("{0}")]
    Panics(String),
    /// The cap on paths.
    #[error("more than {0} paths")]
    Paths(u64),
    /// Somebody else has refuted the kernel.
    #[error(transparent)]
    Ended(#[from] Ended),
    /// No answers.
    #[error("{name}: {source}")]
    Solver {
        /// Which solver.
        name: &'static str,
        /// Why.
        source: SolverError,
    },
    /// The solver came to its limit.
    #[error("bitwuzla: unknown, within the steps that a question may take")]
    Unknown,
    /// The same file has other answers.
    #[error("bitwuzla does not answer unsat again")]
    NotAgain,
    /// Two solvers disagree.
    #[error("z3 contradicts bitwuzla: sat")]
    Contradiction,
    /// The exploration is incomplete.
    #[error("the engine is at fault: there are inputs that take none of the {0} explored paths")]
    Uncovered(u64),
    /// The questions are not all that were raised.
    #[error("the engine is at fault: of {raised} checks that the paths raise, {settled} were decided")]
    Unsettled {
        /// Checks on paths.
        raised: u64,
        /// Those that an answer decides.
        settled: u64,
    },
    /// What is asked is not what runs.
    #[error("the engine is at fault: the solver's model fails on terms, and not on doubles: {0:?}")]
    NotReplayed(&'static str),
    /// What runs is not what is asked.
    #[error("the engine is at fault: what fails on doubles does not on terms")]
    OnlyNumbers,
    /// The solver has no model where it said `sat`.
    #[error("the solver finds no model: {0:?}")]
    NoModel(String),
    /// A file of the evidence, or a draft.
    #[error("{}: {source}", path.display())]
    File {
        /// Which.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
}

/// Proves a property of a kernel; leaves the obligations in `evidence`.
pub fn prove(property: &Property, harness: &Harness, solvers: &Solvers, evidence: &FilePath) -> Outcome {
    let began = Instant::now();
    let mut outcome = Outcome::new(began);
    let result = try_prove(property, harness, solvers, evidence, &mut outcome);
    match result {
        Ok(verdict) => outcome.verdict = verdict,
        Err(why) => (outcome.verdict, outcome.detail) = (Verdict::Failed, why.to_string()),
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
) -> Result<Verdict, Stop> {
    let explored = explore(bounds::of(property.id).length, harness.symbolic, &solvers.patience)?;
    (outcome.paths, outcome.by_evaluation, outcome.raised) = (explored.paths, explored.by_evaluation, explored.raised);
    outcome.reached = explored.reached.iter().copied().collect();
    let folder = evidence.join(property.id);
    if folder.exists() {
        fs::remove_dir_all(&folder).map_err(in_file(&folder))?;
    }
    fs::create_dir_all(&folder).map_err(in_file(&folder))?;
    let draft = folder.join("draft.smt2");
    cover(property, &explored, solvers, &draft)?;

    // First the shared questions; a `sat` there is none yet, but asks for the paths.
    let (mut proved, mut single, mut settled): (Vec<Question>, Vec<(Question, &Path)>, u64) = Default::default();
    let shared: Vec<(&Question, &Vec<usize>)> = explored.questions.iter().collect();
    for chunk in shared.chunks(PER_FILE) {
        let questions: Vec<&Question> = chunk.iter().map(|(question, _)| *question).collect();
        let answers = ask(solvers, &draft, &questions, solvers.limits.proof, Inputs::Any)?;
        for ((question, paths), answer) in chunk.iter().zip(answers) {
            match answer {
                Answer::Unsat => {
                    settled += paths.len() as u64;
                    proved.push((*question).clone());
                }
                Answer::Unknown => return Err(Stop::Unknown),
                Answer::Sat => single.extend(explored.one_by_one(question)),
            }
        }
    }
    for chunk in single.chunks(PER_FILE) {
        let questions: Vec<&Question> = chunk.iter().map(|(question, _)| question).collect();
        let answers = ask(solvers, &draft, &questions, solvers.limits.proof, Inputs::Any)?;
        for ((question, path), answer) in chunk.iter().zip(answers) {
            match answer {
                Answer::Unsat => {
                    settled += 1;
                    proved.push(question.clone());
                }
                Answer::Unknown => return Err(Stop::Unknown),
                Answer::Sat => {
                    let found = model(property, harness, (question, path), solvers, &draft, Inputs::Any)?;
                    outcome.counterexample = Some(found.ok_or(Stop::NotReplayed(question.check))?);
                    return Ok(Verdict::Refuted);
                }
            }
        }
    }
    if settled != explored.raised {
        return Err(Stop::Unsettled { raised: explored.raised, settled });
    }

    // What was proved, for others to ask again; and at once the second solver.
    proved.sort();
    outcome.obligations = proved.len() as u64;
    for (nth, chunk) in proved.chunks(PER_FILE).enumerate() {
        let name = format!("{}/{:03}.smt2", property.id, nth + 1);
        let questions: Vec<&Question> = chunk.iter().collect();
        leave(property, &questions, solvers, &evidence.join(&name))?;
        outcome.evidence.push(name);
        cross_check(&questions, solvers, &draft, outcome)?;
    }
    fs::remove_file(&draft).ok();
    Ok(Verdict::Proved)
}

/// Shows that every input takes an explored path.
fn cover(property: &Property, explored: &Explored, solvers: &Solvers, draft: &FilePath) -> Result<(), Stop> {
    let title = format!("{}: an input takes none of the {} paths", property.id, explored.paths);
    let (script, parts) = explored.uncovered(&title);
    fs::write(draft, script).map_err(in_file(draft))?;
    let answers = solvers.bitwuzla(draft, parts, solvers.limits.proof).map_err(of("bitwuzla"))?;
    if answers.contains(&Answer::Sat) {
        return Err(Stop::Uncovered(explored.paths));
    }
    if answers.iter().all(|answer| *answer == Answer::Unsat) { Ok(()) } else { Err(Stop::Unknown) }
}

/// Writes what was proved into a file, and has it proved as it stands there.
fn leave(property: &Property, questions: &[&Question], solvers: &Solvers, file: &FilePath) -> Result<(), Stop> {
    let title = format!(
        "{}: {}\nEach answer has to be unsat, {} of them. A question is a check that fails where the kernel has \
         taken\nthese decisions. x… are the doubles in the order in which the harness draws them, q… the seqs.",
        property.id,
        property.statement,
        questions.len()
    );
    let (script, _) = smt::script(&title, questions, false, Inputs::Any);
    fs::write(file, &script).map_err(in_file(file))?;
    let answers = solvers.bitwuzla(file, questions.len(), solvers.limits.proof).map_err(of("bitwuzla"))?;
    if answers.iter().all(|answer| *answer == Answer::Unsat) { Ok(()) } else { Err(Stop::NotAgain) }
}

/// Asks z3, too: first with the operations and comparisons of doubles uninterpreted, which claims more, and what does
/// not hold so with the doubles' own.
fn cross_check(
    questions: &[&Question],
    solvers: &Solvers,
    draft: &FilePath,
    outcome: &mut Outcome,
) -> Result<(), Stop> {
    fs::write(draft, smt::uninterpreted(questions)).map_err(in_file(draft))?;
    let answers = solvers.z3(draft, questions.len(), solvers.limits.cross).map_err(of("z3"))?;
    let holds = |answer: &Option<Answer>| *answer == Some(Answer::Unsat);
    outcome.without_arithmetic += answers.iter().filter(|answer| holds(answer)).count() as u64;
    let open = questions.iter().zip(&answers).filter(|(_, answer)| !holds(answer));
    let open: Vec<&Question> = open.map(|(question, _)| *question).collect();
    outcome.cross_checked += (questions.len() - open.len()) as u64;
    if open.is_empty() {
        return Ok(());
    }
    let (script, _) = smt::script("draft", &open, false, Inputs::Any);
    fs::write(draft, script).map_err(in_file(draft))?;
    let answers = solvers.z3(draft, open.len(), solvers.limits.cross).map_err(of("z3"))?;
    if answers.contains(&Some(Answer::Sat)) {
        return Err(Stop::Contradiction);
    }
    outcome.cross_checked += answers.iter().filter(|answer| holds(answer)).count() as u64;
    Ok(())
}

/// Where the inputs of a counterexample come from. The harness failed on them on doubles in each case.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// The engine's own search: the solver found them.
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
            Self::Sampled => {
                "a sampled hint, confirmed by bitwuzla with the inputs fixed; its own search found none within \
                 its limit"
            }
            Self::Enumerated => {
                "an enumerated hint, confirmed by bitwuzla with the inputs fixed; its own search found none within \
                 its limit"
            }
        }
    }
}

/// Looks for a counterexample only: for kernels that are broken.
///
/// The engine searches by itself: it asks for models of the paths that raise a check, and replays each on doubles.
/// Only where that comes to its limit are inputs tried that break the harness on doubles: their path is run on terms,
/// and the solver has to say `sat` of the question that it raises with these inputs.
///
/// # Errors
/// No solver, or it does not answer, or what fails on terms does not on doubles, or the other way round.
pub fn refute(
    property: &Property,
    harness: &Harness,
    solvers: &Solvers,
    file: &FilePath,
) -> Result<Option<(Counterexample, Origin)>, Stop> {
    match search(property, harness, solvers, file) {
        Ok(Some(found)) => Ok(Some((found, Origin::Model))),
        Ok(None) => match hint(property, harness) {
            // Every path was asked, and every check holds on all of them.
            Some(_) => Err(Stop::OnlyNumbers),
            None => Ok(None),
        },
        Err(why @ (Stop::Unknown | Stop::Paths(_) | Stop::Panics(_))) => {
            let (hint, origin) = hint(property, harness).ok_or(why)?;
            confirmed(property, harness, solvers, file, &hint).map(|found| Some((found, origin)))
        }
        Err(why) => Err(why),
    }
}

/// The engine's own search: among doubles with few digits first, and then among all.
fn search(
    property: &Property,
    harness: &Harness,
    solvers: &Solvers,
    file: &FilePath,
) -> Result<Option<Counterexample>, Stop> {
    let explored = explore(bounds::of(property.id).length, harness.symbolic, &solvers.patience)?;
    let mut missed = None;
    for inputs in [Inputs::Round, Inputs::Any] {
        match search_among(inputs, &explored, property, harness, solvers, file) {
            Ok(Some(found)) => return Ok(Some(found)),
            Ok(None) => {}
            // What is not known of some inputs is asked of all.
            Err(Stop::Unknown) if matches!(inputs, Inputs::Round) => {}
            Err(why @ (Stop::Unknown | Stop::NotReplayed(_))) => missed = Some(why),
            Err(why) => return Err(why),
        }
    }
    missed.map_or(Ok(None), Err)
}

/// The same among some inputs, the smallest questions first.
fn search_among(
    inputs: Inputs<'_>,
    explored: &Explored,
    property: &Property,
    harness: &Harness,
    solvers: &Solvers,
    file: &FilePath,
) -> Result<Option<Counterexample>, Stop> {
    let mut questions: Vec<&Question> = explored.questions.keys().collect();
    questions.sort_by_cached_key(|question| smt::size(question.formula));
    let (mut is_unknown, mut missed) = (false, None);
    for chunk in questions.chunks(PER_SEARCH) {
        let answers = ask(solvers, file, chunk, solvers.limits.search, inputs)?;
        is_unknown |= answers.contains(&Answer::Unknown);
        for (question, _) in chunk.iter().zip(answers).filter(|(_, answer)| *answer == Answer::Sat) {
            let single = explored.one_by_one(question);
            // A model of what the paths share may well take one of them.
            if let Some((_, path)) = single.first()
                && let Some(found) = model(property, harness, (question, path), solvers, file, inputs)?
            {
                return Ok(Some(found));
            }
            is_unknown |= single.len() > PATHS_SEARCHED;
            for chunk in single.chunks(PER_SEARCH).take(PATHS_SEARCHED / PER_SEARCH) {
                let asked: Vec<&Question> = chunk.iter().map(|(question, _)| question).collect();
                let answers = ask(solvers, file, &asked, solvers.limits.search, inputs)?;
                is_unknown |= answers.contains(&Answer::Unknown);
                if let Some(((question, path), _)) = chunk.iter().zip(answers).find(|(_, a)| *a == Answer::Sat) {
                    match model(property, harness, (question, path), solvers, file, inputs)? {
                        Some(found) => return Ok(Some(found)),
                        None => missed = missed.or(Some(question.check)),
                    }
                } else if is_unknown {
                    break;
                }
            }
        }
        // What comes next is larger.
        if is_unknown {
            break;
        }
    }
    match missed {
        Some(check) => Err(Stop::NotReplayed(check)),
        None if is_unknown => Err(Stop::Unknown),
        None => Ok(None),
    }
}

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

/// A hint as a counterexample: its path breaks a check on terms, the solver says so, and so do doubles.
fn confirmed(
    property: &Property,
    harness: &Harness,
    solvers: &Solvers,
    file: &FilePath,
    hint: &Guide,
) -> Result<Counterexample, Stop> {
    terms::clear();
    let length = bounds::of(property.id).length;
    let run = || terms::run_guided(length, harness.symbolic, hint.clone());
    let run = std::panic::catch_unwind(std::panic::AssertUnwindSafe(run));
    let (path, broken) = run.map_err(|panic| Stop::Panics(said(&*panic)))?;
    let &(check, formula) = broken.first().ok_or(Stop::OnlyNumbers)?;
    let question = Question { check, formula, literals: path.literals };
    let (script, _) = smt::script("draft", &[&question], false, Inputs::Given(hint));
    fs::write(file, script).map_err(in_file(file))?;
    if solvers.bitwuzla(file, 1, solvers.limits.search * CONFIRMING).map_err(of("bitwuzla"))? != [Answer::Sat] {
        return Err(Stop::OnlyNumbers);
    }
    let replay = Replay {
        scalars: hint.scalars.iter().copied().collect(),
        seqs: hint.seqs.iter().copied().collect(),
        choices: hint.choices.iter().copied().collect(),
        length,
    };
    replayed(harness, replay).ok_or(Stop::NotReplayed(check))
}

/// The answers of bitwuzla to these questions, each within so many steps.
fn ask(
    solvers: &Solvers,
    file: &FilePath,
    questions: &[&Question],
    steps: u64,
    inputs: Inputs<'_>,
) -> Result<Vec<Answer>, Stop> {
    solvers.patience.left()?;
    let (script, _) = smt::script("draft", questions, false, inputs);
    fs::write(file, script).map_err(in_file(file))?;
    let printed = solvers.bitwuzla_prints(file, steps, Some(steps)).map_err(of("bitwuzla"))?;
    read_answers(&printed, questions.len()).map_err(of("bitwuzla"))
}

/// The solver's model of a question, with the choices of a path, replayed on doubles; nothing where that does not fail.
fn model(
    property: &Property,
    harness: &Harness,
    (question, path): (&Question, &Path),
    solvers: &Solvers,
    file: &FilePath,
    inputs: Inputs<'_>,
) -> Result<Option<Counterexample>, Stop> {
    let (script, variables) = smt::script(property.id, &[question], true, inputs);
    fs::write(file, script).map_err(in_file(file))?;
    let printed = solvers.bitwuzla_prints(file, solvers.limits.proof, None).map_err(of("bitwuzla"))?;
    let first = printed.split('\n').next().unwrap_or_default();
    if read_answers(first, 1) != Ok(vec![Answer::Sat]) {
        return Err(Stop::NoModel(first.to_owned()));
    }
    let values = read_values(&printed);
    let value = |name: String| values.iter().find(|(n, _)| *n == name).map_or(0, |(_, bits)| *bits);
    let most = |set: &std::collections::BTreeSet<u32>| set.last().map_or(0, |last| last + 1);
    let replay = Replay {
        scalars: (0..most(&variables.doubles)).map(|nth| f64::from_bits(value(format!("x{nth}")))).collect(),
        seqs: (0..most(&variables.seqs)).map(|nth| value(format!("q{nth}")).cast_signed()).collect(),
        choices: path.choices.iter().copied().collect(),
        length: bounds::of(property.id).length,
    };
    Ok(replayed(harness, replay))
}

/// The inputs as a counterexample, if the harness fails on them on doubles.
fn replayed(harness: &Harness, replay: Replay) -> Option<Counterexample> {
    let mut run = Native::new(Source::Replay(replay));
    run.keep = true;
    run_once(harness.native, &mut run);
    run.failed.map(|check| Counterexample { check: check.to_owned(), inputs: run.drawn })
}

fn in_file(path: &FilePath) -> impl Fn(io::Error) -> Stop {
    let path = path.to_owned();
    move |source| Stop::File { path: path.clone(), source }
}

fn of(name: &'static str) -> impl Fn(SolverError) -> Stop {
    move |source| Stop::Solver { name, source }
}
