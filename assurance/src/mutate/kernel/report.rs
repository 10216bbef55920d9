//! What became of the changed kernels: the lock, the page, and the whole of it.

use std::collections::BTreeMap;

use serde::Serialize;
use xtask::project::Project;

use super::super::copies::{Refuted, file_name};
use super::explained::EXPLAINED;
use super::{KernelArgs, Mutant, MutateError};
use crate::artefact::Artefact;
use crate::document::{Block, heading, table, text};
use crate::lock::Lock;
use crate::reports;

/// The name under which its lock is kept.
const NAME: &str = "mutate-kernel";
/// The name of its page.
const PAGE: &str = "mutations";

/// Everything.
#[derive(Debug, Serialize)]
pub(super) struct Report {
    /// How many changes were wanted, and the seed that chose them.
    count: usize,
    seed: u64,
    /// How many changes there are.
    changes: usize,
    mutants: Vec<Entry>,
}

/// How many changes met with each fate.
#[derive(Debug, Default, Clone, Copy)]
struct Counts {
    refuted: usize,
    equivalent: usize,
    open: usize,
}

/// A change, and what became of it.
#[derive(Debug, Serialize)]
struct Entry {
    file: String,
    line: usize,
    column: usize,
    text: String,
    from: String,
    to: String,
    #[serde(flatten)]
    fate: Fate,
}

/// What became of a changed kernel.
#[derive(Debug, Clone, Serialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Fate {
    /// It behaves as the kernel does, and this is why.
    Equivalent(String),
    /// Nothing refutes it, and nobody explained it: what was said of it.
    Open(String),
    /// Something refutes it.
    #[serde(untagged)]
    Refuted(Refuted),
}

impl Report {
    pub(super) fn of(args: &KernelArgs, changes: usize, fates: &[(Mutant, Fate)]) -> Self {
        let mutants = fates.iter().map(|(mutant, fate)| Entry {
            file: mutant.file.clone(),
            line: mutant.line,
            column: mutant.column,
            text: mutant.text.clone(),
            from: mutant.change.from.clone(),
            to: mutant.change.to.clone(),
            fate: fate.clone(),
        });
        Self { count: args.count, seed: args.seed, changes, mutants: mutants.collect() }
    }

    /// Keeps it; whether no change is open.
    ///
    /// # Errors
    /// A file cannot be written.
    pub(super) fn write(&self, project: &Project) -> Result<bool, MutateError> {
        self.lock(sources(project)?).write(&project.path(""), NAME)?;
        let (folder, page) = (project.path(reports::PAGES), self.page());
        reports::page(&folder, PAGE, &page)?;
        reports::full(&folder, PAGE, self, &page)?;
        let Counts { refuted, equivalent, open } = self.total();
        let all = self.mutants.len();
        println!("{all} changes: {refuted} refuted, {equivalent} equivalent, {open} NOT REFUTED; reports/{PAGE}.md");
        Ok(open == 0)
    }

    /// What git keeps: how many changes of each file met with which fate, by what they are refuted, and what is open.
    fn lock(&self, sources: BTreeMap<String, String>) -> Lock {
        let mut lock = Lock { sources, ..Lock::default() };
        let mut note = |name: String, count: usize| lock.counts.insert(name, count as u64);
        note("wanted".to_owned(), self.count);
        note("changes".to_owned(), self.changes);
        for (file, Counts { refuted, equivalent, open }) in self.by_file() {
            for (fate, count) in [("refuted", refuted), ("equivalent", equivalent), ("open", open)] {
                note(format!("{file} {fate}"), count);
            }
        }
        for ((property, engine), count) in self.by_refuter() {
            note(format!("refuted by {property}, {engine}"), count);
        }
        lock.counts.insert("seed".to_owned(), self.seed);
        lock.fates = self.open().map(|entry| (entry.id(), "open".to_owned())).collect();
        lock.problems = self.open().map(|entry| format!("{} is neither refuted nor explained", entry.id())).collect();
        lock
    }

    /// What people read.
    fn page(&self) -> Vec<Block> {
        let Self { count, seed, changes, mutants } = self;
        let about = format!(
            "`cargo assure mutate kernel --count {count} --seed {seed}`: of {changes} changes of one token of the \
             kernel that the grammar of `assurance/src/mutate/kernel/tokens.rs` knows, {} that compile, held against \
             every property. A refuted one has a concrete counterexample, which `reports/full/{PAGE}.json` holds once \
             the command has run. An equivalent one changes no behaviour; [`{EXPLAINED}`](../{EXPLAINED}) says why of \
             each.",
            mutants.len()
        );
        let row = |name: &str, Counts { refuted, equivalent, open }: Counts| {
            let numbers = [refuted + equivalent + open, refuted, equivalent, open].map(|number| number.to_string());
            [&[name.to_owned()][..], &numbers].concat()
        };
        let files = self.by_file().into_iter().map(|(file, counts)| row(file, counts));
        let refuters = self.by_refuter().into_iter();
        let refuters = refuters
            .map(|((property, engine), count)| [property, engine, &count.to_string()].map(str::to_owned).to_vec());
        let mut page = vec![
            heading(1, "Changes of one token"),
            text(about),
            table(&["file", "changes", "refuted", "equivalent", "open"], files.chain([row("all", self.total())])),
            table(&["first refuted by", "engine", "changes"], refuters),
        ];
        page.extend(self.open().map(|entry| text(format!("Open: {}, in `{}`", entry.id(), entry.text))));
        page
    }

    fn open(&self) -> impl Iterator<Item = &Entry> {
        self.mutants.iter().filter(|entry| matches!(entry.fate, Fate::Open(_)))
    }

    fn by_file(&self) -> BTreeMap<&str, Counts> {
        let mut files: BTreeMap<&str, Counts> = BTreeMap::new();
        for Entry { file, fate, .. } in &self.mutants {
            let counts = files.entry(file_name(file)).or_default();
            match fate {
                Fate::Refuted(_) => counts.refuted += 1,
                Fate::Equivalent(_) => counts.equivalent += 1,
                Fate::Open(_) => counts.open += 1,
            }
        }
        files
    }

    fn by_refuter(&self) -> BTreeMap<(&str, &str), usize> {
        let mut by = BTreeMap::new();
        for Entry { fate, .. } in &self.mutants {
            if let Fate::Refuted(Refuted { property, engine, .. }) = fate {
                *by.entry((property.as_str(), engine.as_str())).or_default() += 1;
            }
        }
        by
    }

    fn total(&self) -> Counts {
        self.by_file().into_values().fold(Counts::default(), |sum, counts| Counts {
            refuted: sum.refuted + counts.refuted,
            equivalent: sum.equivalent + counts.equivalent,
            open: sum.open + counts.open,
        })
    }
}

impl Entry {
    fn id(&self) -> String {
        let Self { file, line, column, from, to, .. } = self;
        format!("{file}:{line}:{column}: `{from}` → `{to}`")
    }
}

/// What is wrong with what is kept: missing, about other sources, or with a change that nothing refutes.
///
/// # Errors
/// A file cannot be read.
pub(super) fn problems(project: &Project) -> Result<Vec<String>, MutateError> {
    let again = |why: &str| format!("{NAME}: {why}; cargo assure mutate kernel");
    let Some(lock) = Lock::read(&project.path(""), NAME)? else {
        return Ok(vec![again("it was never made")]);
    };
    let stale = (lock.sources != sources(project)?)
        .then(|| again("the kernel, its properties or the changes are others than those that were tried"));
    Ok(stale.into_iter().chain(lock.fates.keys().map(|open| format!("a change is not refuted: {open}"))).collect())
}

/// The digests of what the report is about.
fn sources(project: &Project) -> Result<BTreeMap<String, String>, MutateError> {
    let root = project.path("");
    let digests = Artefact::named(NAME).map(|artefact| artefact.digests(&root)).transpose();
    Ok(digests.map_err(|source| MutateError::File { path: root, source })?.unwrap_or_default())
}

/// A change and its fate, in a line, and one more with the code where nothing refutes it.
pub(super) fn shown(mutant: &Mutant, fate: &Fate) -> String {
    let head = format!("{}: `{}` → `{}`", mutant.place(), mutant.change.from, mutant.change.to);
    match fate {
        Fate::Refuted(Refuted { property, engine, counterexample }) => {
            let compared = counterexample.compared.as_ref().map_or(String::new(), |compared| format!(" ({compared})"));
            let inputs = counterexample.inputs.iter().map(|(name, value)| match value.as_str() {
                Some(spelled) => format!("{name} = {spelled}"),
                None => format!("{name} = {value}"),
            });
            let inputs = inputs.collect::<Vec<_>>().join(", ");
            format!("{head}: refuted by {property}, {engine}: {}{compared}: {inputs}", counterexample.check)
        }
        Fate::Equivalent(reason) => format!("{head}: no change of behaviour: {reason}"),
        Fate::Open(why) => format!("{head}: NOT REFUTED ({why})\n    {}", mutant.text),
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn a_change_of_the_kernel_or_of_a_property_makes_the_report_stale() {
        let folder = tempfile::tempdir().unwrap();
        let project = Project::at(folder.path());
        let write = |file: &str, text: &str| {
            let path = project.path(file);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, text).unwrap();
        };
        write("spec/kernel/src/decisions/speed.rs", "a.le(b)");
        write("proofs/src/properties/clamp.rs", "more");
        let problems = || problems(&project).unwrap().join("\n");
        assert!(problems().contains("never made"));
        let args = KernelArgs { count: 1, seed: 1, ask_all: false, check: false };
        let mutant = Mutant {
            id: "m_00000".to_owned(),
            file: "a.rs".to_owned(),
            line: 1,
            text: "a < b".to_owned(),
            column: 3,
            change: super::super::tokens::Change { start: 2, from: "<".to_owned(), to: "<=".to_owned() },
        };
        let fate = |fate| Report::of(&args, 1, &[(mutant.clone(), fate)]).write(&project).unwrap();
        assert!(!fate(Fate::Open("undecided".to_owned())));
        assert_eq!(problems(), "a change is not refuted: a.rs:1:3: `<` → `<=`");
        assert!(fate(Fate::Equivalent("Both are 0.".to_owned())));
        assert_eq!(problems(), "");
        let page = fs::read_to_string(project.path("reports/mutations.md")).unwrap();
        assert!(page.contains("| a.rs | 1 | 0 | 1 | 0 |"), "{page}");
        for source in ["spec/kernel/src/decisions/speed.rs", "proofs/src/properties/clamp.rs"] {
            fate(Fate::Equivalent("Both are 0.".to_owned()));
            write(source, "less");
            assert!(problems().contains("others than those"), "{source}");
        }
    }
}
