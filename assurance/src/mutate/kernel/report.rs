//! What became of the changed kernels: the lock, the page, and the whole of it.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use serde::{Deserialize, Serialize};
use xtask::project::Project;

use super::copies::Refuted;
use super::explained::EXPLAINED;
use super::{KernelArgs, KernelError, Mutant};
use crate::digest;
use crate::kept;

/// The name under which it is kept.
pub(super) const NAME: &str = "mutations";
/// What the report is about, and what it depends on.
pub(crate) const SOURCES: [&str; 7] = [
    super::DECISIONS,
    super::SCALAR,
    "proofs/src/properties",
    "proofs/src/engines",
    "proofs/src/bin/mutants.rs",
    EXPLAINED,
    "assurance/src/mutate/kernel",
];

/// Everything.
#[derive(Debug, Serialize)]
pub(super) struct Report {
    #[serde(flatten)]
    lock: Lock,
    mutants: Vec<Entry>,
}

/// What stands in git: the digest of the sources, and how many changes met with which fate.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct Lock {
    /// Of the [`SOURCES`].
    digest: String,
    /// How many changes were wanted, and the seed that chose them.
    count: usize,
    seed: u64,
    /// How many changes there are.
    changes: usize,
    /// A line for each change that is neither refuted nor explained.
    open: Vec<String>,
    /// By the file that is changed.
    files: BTreeMap<String, Counts>,
    /// By the property that refutes first, and by the engine.
    refuted_by: BTreeMap<String, BTreeMap<String, usize>>,
}

/// How many changes met with each fate.
#[derive(Debug, Default, Clone, Copy, Serialize, Deserialize)]
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
    /// # Errors
    /// A source cannot be read.
    pub(super) fn of(
        project: &Project,
        args: &KernelArgs,
        changes: usize,
        fates: &[(Mutant, Fate)],
    ) -> Result<Self, KernelError> {
        let mut lock = Lock {
            digest: digest_of(project)?,
            count: args.count,
            seed: args.seed,
            changes,
            open: Vec::new(),
            files: BTreeMap::new(),
            refuted_by: BTreeMap::new(),
        };
        for (mutant, fate) in fates {
            let counts = lock.files.entry(mutant.file_name().to_owned()).or_default();
            match fate {
                Fate::Refuted(by) => {
                    counts.refuted += 1;
                    let engines = lock.refuted_by.entry(by.property.clone()).or_default();
                    *engines.entry(by.engine.clone()).or_default() += 1;
                }
                Fate::Equivalent(_) => counts.equivalent += 1,
                Fate::Open(_) => {
                    counts.open += 1;
                    lock.open.push(shown(mutant, fate));
                }
            }
        }
        let entries = fates.iter().map(|(mutant, fate)| Entry {
            file: mutant.file.clone(),
            line: mutant.line,
            column: mutant.column,
            text: mutant.text.clone(),
            from: mutant.change.from.clone(),
            to: mutant.change.to.clone(),
            fate: fate.clone(),
        });
        Ok(Self { lock, mutants: entries.collect() })
    }

    /// Keeps it; whether no change is open.
    ///
    /// # Errors
    /// A file cannot be written.
    pub(super) fn write(&self, project: &Project) -> Result<bool, KernelError> {
        kept::write(project, NAME, &self.lock, &page(&self.lock), self)?;
        let Counts { refuted, equivalent, open } = self.lock.total();
        let page = kept::page_file(NAME);
        println!(
            "{} changes: {refuted} refuted, {equivalent} equivalent, {open} NOT REFUTED; {page}",
            self.mutants.len()
        );
        Ok(open == 0)
    }
}

/// What is wrong with what is kept: missing, about other sources, or with a change that nothing refutes.
///
/// # Errors
/// A file cannot be read.
pub(super) fn problems(project: &Project) -> Result<Vec<String>, KernelError> {
    let file = kept::lock_file(NAME);
    let Some(lock) = kept::read::<Lock>(project, NAME)? else {
        return Ok(vec![format!("{file}: there is none; cargo assure mutate kernel")]);
    };
    let mut problems = Vec::new();
    if lock.digest != digest_of(project)? {
        let Lock { count, seed, .. } = lock;
        let command = format!("cargo assure mutate kernel --count {count} --seed {seed}");
        problems.push(format!("{file}: the kernel, its properties or the changes are others now; {command}"));
    }
    problems.extend(lock.open.iter().map(|open| format!("a change is not refuted: {open}")));
    if problems.is_empty() && kept::read_page(project, NAME) != page(&lock) {
        problems.push(format!("{} is not what {file} says", kept::page_file(NAME)));
    }
    Ok(problems)
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

/// What people read.
fn page(lock: &Lock) -> String {
    let Counts { refuted, equivalent, open } = lock.total();
    let mut page = format!(
        "# Changes of one token\n\n`cargo assure mutate kernel --count {} --seed {}`: of {} changes of one token of \
         the kernel that the grammar of `assurance/src/mutate/kernel/tokens.rs` knows, {} that compile, held against \
         every property. A refuted one has a concrete counterexample, which `reports/full/{NAME}.json` holds once the \
         command has run. An equivalent one changes no behaviour; [`{EXPLAINED}`](../{EXPLAINED}) says why of each.\n\n\
         | file | changes | refuted | equivalent | open |\n|---|---|---|---|---|\n",
        lock.count,
        lock.seed,
        lock.changes,
        refuted + equivalent + open,
    );
    let all = [("all", lock.total())];
    for (file, counts) in lock.files.iter().map(|(file, counts)| (file.as_str(), *counts)).chain(all) {
        let Counts { refuted, equivalent, open } = counts;
        let sum = refuted + equivalent + open;
        let _ = writeln!(page, "| {file} | {sum} | {refuted} | {equivalent} | {open} |");
    }
    page += "\n| first refuted by | engine | changes |\n|---|---|---|\n";
    for (property, engines) in &lock.refuted_by {
        for (engine, changes) in engines {
            let _ = writeln!(page, "| {property} | {engine} | {changes} |");
        }
    }
    for open in &lock.open {
        let _ = write!(page, "\nOpen: {open}\n");
    }
    page
}

impl Lock {
    fn total(&self) -> Counts {
        self.files.values().fold(Counts::default(), |sum, counts| Counts {
            refuted: sum.refuted + counts.refuted,
            equivalent: sum.equivalent + counts.equivalent,
            open: sum.open + counts.open,
        })
    }
}

fn digest_of(project: &Project) -> Result<String, KernelError> {
    let root = project.path("");
    digest::of_sources(&root, &SOURCES).map_err(|source| KernelError::File { path: root, source })
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn a_change_of_the_kernel_or_of_a_property_makes_the_report_stale() {
        let folder = tempfile::tempdir().unwrap();
        let root = folder.path();
        for source in SOURCES.map(|source| root.join(source)) {
            if source.extension().is_none() {
                fs::create_dir_all(source).unwrap();
            } else {
                fs::create_dir_all(source.parent().unwrap()).unwrap();
                fs::write(source, "").unwrap();
            }
        }
        let project = Project::at(root);
        let problems = || problems(&project).unwrap().join("\n");
        assert!(problems().contains("there is none"));
        let args = KernelArgs { count: 1, seed: 1, ask_all: false, check: false };
        let mutant = Mutant {
            id: "m_00000".to_owned(),
            file: "a.rs".to_owned(),
            line: 1,
            text: "a < b".to_owned(),
            column: 3,
            change: super::super::tokens::Change { start: 2, from: "<".to_owned(), to: "<=".to_owned() },
        };
        let fate = |fate| Report::of(&project, &args, 1, &[(mutant.clone(), fate)]).unwrap().write(&project).unwrap();
        assert!(!fate(Fate::Open("undecided".to_owned())));
        assert!(problems().contains("not refuted: a.rs:1:3"));
        assert!(fate(Fate::Equivalent("Both are 0.".to_owned())));
        assert_eq!(problems(), "");
        fs::write(project.path(&kept::page_file(NAME)), "all is well").unwrap();
        assert!(problems().contains("is not what"));
        fs::write(root.join("proofs/src/properties/clamp.rs"), "less").unwrap();
        assert!(problems().contains("others now"));
    }
}
