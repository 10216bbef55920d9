//! Changes one token of the kernel at a time, and asks whether a proof notices.
//!
//! | module | what it does |
//! |---|---|
//! | `tokens` | which changes there are |
//! | `explained` | which changes change no behaviour, and why |
//! | `report` | what became of each |
//!
//! The compiler says which copies are programs. These are held against all properties, by the quick engines first, and
//! by the symbolic one if none of these refutes them. A change that nobody refutes has to be explained in
//! `proofs/equivalent.toml`, or is a gap of the proofs.

mod explained;
mod report;
mod tokens;

use std::collections::BTreeMap;
use std::fs;
use std::io;

use clap::Args;
use xtask::project::Project;
use xtask::setup;

use self::explained::{EXPLAINED, Explained};
use self::report::{Fate, Report};
use self::tokens::{Change, changes, variants};
use super::MutateError;
use super::copies::{Ask, Changed, Copies, DECISIONS, SCALAR, file_name};

/// Types without decisions: only its variants are read.
const VOCABULARY: &str = "spec/kernel/src/vocabulary.rs";
/// Modules and exports.
const LEFT_ALONE: [&str; 2] = ["spec/kernel/src/decisions/mod.rs", VOCABULARY];

pub(super) const EXAMPLES: &str = "\
Examples:
  cargo assure mutate kernel --count 450 --seed 3   what reports/mutations.md is made of
  cargo assure mutate kernel --count 20 --seed 7    a sample that nobody tried before
  cargo assure mutate kernel --check                only: is the report about the sources as they are?";

#[derive(Debug, Args)]
pub(crate) struct KernelArgs {
    /// How many changes that compile are tried
    #[arg(long, value_name = "N", default_value_t = 220)]
    count: usize,
    /// Chooses the changes: the same ones again for the same number
    #[arg(long, value_name = "S", default_value_t = 1)]
    seed: u64,
    /// Ask the symbolic engine of explained changes, too
    #[arg(long)]
    ask_all: bool,
    /// Try nothing: only say whether the report is about the sources as they are
    #[arg(long, conflicts_with_all = ["count", "seed", "ask_all"])]
    check: bool,
}

/// A change of one token of the kernel.
#[derive(Debug, Clone)]
struct Mutant {
    id: String,
    /// From the root of the repository.
    file: String,
    line: usize,
    /// The line, without the blanks around it.
    text: String,
    /// Where in that, in characters, from 1 on.
    column: usize,
    change: Change,
}

/// Changes tokens and holds the changed kernels against the properties; `false` if a change is neither refuted nor
/// explained, an explanation is of a change that is refuted, or of one that there is not.
///
/// # Errors
/// A file, or a program that cannot be started.
pub(crate) fn run(project: &Project, args: &KernelArgs) -> Result<bool, MutateError> {
    if args.check {
        let problems = report::problems(project)?;
        problems.iter().for_each(|problem| println!("{problem}"));
        return Ok(problems.is_empty());
    }
    let sources = sources(project)?;
    let all = mutants(&sources);
    let explained = explained::read(project, &sources)?;
    let stale = explained::stale(&explained, &all);
    stale.iter().for_each(|line| println!("STALE: {line}"));

    let copies = Copies::new(project, &sources)?;
    let chosen = choose(&copies, &all, args)?;
    let mut is_good = stale.is_empty();
    let mut fates = Vec::new();
    for (mutant, fate, entry) in hold(&copies, chosen, &explained, args)? {
        if let (Fate::Refuted(_), Some(entry)) = (&fate, entry) {
            println!("WRONG: {EXPLAINED} calls it equivalent: {}", entry.reason);
            is_good = false;
        }
        println!("{}", report::shown(&mutant, &fate));
        fates.push((mutant, fate));
    }
    Ok(Report::of(args, all.len(), &fates).write(project)? && is_good)
}

/// As many changes as are wanted that compile, in the order of the files.
fn choose(copies: &Copies<'_>, all: &[Mutant], args: &KernelArgs) -> Result<Vec<Mutant>, MutateError> {
    println!("{} changes of one token; {} are wanted that compile", all.len(), args.count);
    let mut order = all.to_vec();
    shuffle(&mut order, args.seed);
    let mut rest = order.into_iter();
    let mut chosen = Vec::new();
    while chosen.len() < args.count {
        let missing = args.count - chosen.len();
        let some: Vec<Mutant> = rest.by_ref().take(missing * 3 + 50).collect();
        if some.is_empty() {
            break;
        }
        let (good, _) = copies.that_compile(some)?;
        println!("{} of them compile", good.len());
        chosen.extend(good);
    }
    chosen.truncate(args.count);
    chosen.sort_by_key(|mutant| (mutant.file.clone(), mutant.change.clone()));
    Ok(chosen)
}

/// A mutant, what became of it, and the explanation that it has.
type Held<'e> = (Mutant, Fate, Option<&'e Explained>);

/// What became of each.
fn hold<'e>(
    copies: &Copies<'_>,
    chosen: Vec<Mutant>,
    explained: &'e [Explained],
    args: &KernelArgs,
) -> Result<Vec<Held<'e>>, MutateError> {
    let explanation = |mutant: &Mutant| explained.iter().find(|entry| entry.is_of(mutant));
    let mut fates = ask(copies, &chosen, Ask::Numbers)?;
    let is_open = |mutant: &&Mutant| !matches!(fates.get(&mutant.id), Some(Fate::Refuted(_)));
    let is_asked = |mutant: &&Mutant| args.ask_all || explanation(mutant).is_none();
    let open: Vec<Mutant> = chosen.iter().filter(is_open).filter(is_asked).cloned().collect();
    if !open.is_empty() {
        println!("{} are left for the symbolic engine", open.len());
        setup::solvers(copies.project(), &mut |line| println!("{line}"))?;
        fates.extend(ask(copies, &open, Ask::Solvers)?);
    }
    let fate = |mutant: Mutant| {
        let entry = explanation(&mutant);
        let fate = match (fates.remove(&mutant.id), entry) {
            (Some(Fate::Refuted(by)), _) => Fate::Refuted(by),
            (_, Some(entry)) => Fate::Equivalent(entry.reason.clone()),
            (Some(fate), None) => fate,
            (None, None) => Fate::Open("not held against anything".to_owned()),
        };
        (mutant, fate, entry)
    };
    Ok(chosen.into_iter().map(fate).collect())
}

/// What is said of each, by its id.
fn ask(copies: &Copies<'_>, mutants: &[Mutant], ask: Ask) -> Result<BTreeMap<String, Fate>, MutateError> {
    let answers = copies.hold(mutants, ask)?.into_iter();
    Ok(answers.map(|answer| (answer.id, answer.refuted.map_or(Fate::Open(answer.said), Fate::Refuted))).collect())
}

/// The kernel's files, by their names from the root.
pub(super) fn sources(project: &Project) -> Result<BTreeMap<String, String>, MutateError> {
    let folder = project.path(DECISIONS);
    let entries = fs::read_dir(&folder).and_then(Iterator::collect::<io::Result<Vec<_>>>);
    let entries = entries.map_err(|source| MutateError::File { path: folder, source })?;
    let decisions = entries.iter().map(|entry| format!("{DECISIONS}/{}", entry.file_name().to_string_lossy()));
    let files = decisions.chain([SCALAR, VOCABULARY].map(str::to_owned));
    let read = |file: String| {
        let path = project.path(&file);
        let text = fs::read_to_string(&path).map_err(|source| MutateError::File { path, source })?;
        Ok((file, text.replace("\r\n", "\n")))
    };
    files.map(read).collect()
}

/// Every change of one token.
fn mutants(sources: &BTreeMap<String, String>) -> Vec<Mutant> {
    let words = sources.get(VOCABULARY).map_or("", String::as_str);
    let variants = variants(words);
    let mut mutants = Vec::new();
    let mut files: Vec<_> = sources.iter().filter(|(file, _)| !LEFT_ALONE.contains(&&***file)).collect();
    // The numbers of the changes, and so what a seed chooses, do not depend on the folders.
    files.sort_by_key(|(file, _)| file_name(file));
    for (file, text) in files {
        for change in changes(text, &variants) {
            let before = text.get(..change.start).unwrap_or_default();
            let begin = before.rfind('\n').map_or(0, |at| at + 1);
            let whole = text.get(begin..).and_then(|rest| rest.lines().next());
            let whole = whole.unwrap_or_default();
            let blanks = whole.len() - whole.trim_start().len();
            let left = text.get(begin + blanks..change.start).unwrap_or_default();
            mutants.push(Mutant {
                id: format!("m_{:05}", mutants.len()),
                file: file.clone(),
                line: before.matches('\n').count() + 1,
                text: whole.trim().to_owned(),
                column: left.chars().count() + 1,
                change,
            });
        }
    }
    mutants
}

/// The same order for the same seed: Fisher and Yates, by SplitMix64.
fn shuffle(mutants: &mut [Mutant], seed: u64) {
    let mut state = seed;
    for last in (1..mutants.len()).rev() {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^= z >> 31;
        let other = usize::try_from(z % (last as u64 + 1)).unwrap_or_default();
        mutants.swap(last, other);
    }
}

impl Changed for Mutant {
    fn id(&self) -> &str {
        &self.id
    }

    fn change(&self, file: &str, text: &str) -> Option<String> {
        (file == self.file).then(|| self.change.of(text))
    }

    fn is_of_numbers(&self) -> bool {
        self.file == SCALAR
    }
}

impl Mutant {
    fn place(&self) -> String {
        format!("{}:{}:{}", self.file, self.line, self.column)
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    #[test]
    fn a_seed_chooses_the_same_changes_again_and_another_one_others() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
        let all = mutants(&sources(&Project::at(root)).unwrap());
        assert!(all.len() > 1_000, "{}", all.len());
        let first = |seed| {
            let mut order = all.clone();
            shuffle(&mut order, seed);
            order.into_iter().take(20).map(|mutant| mutant.id).collect::<Vec<_>>()
        };
        assert_eq!(first(1), first(1));
        assert_ne!(first(1), first(2));
    }
}
