//! What was tried: a lock for each module, the page, and the fate of every mutant.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use serde::Serialize;
use xtask::project::Project;

use super::outcome::{By, Fate, Mutant, Outcome};
use super::{CARGO_MUTANTS, MODULES, Module, MutateError};
use crate::artefact::Artefact;
use crate::document::{Block, heading, table, text};
use crate::lock::Lock;
use crate::reports;
use ncp_proofs::digest::of_files;

/// The name of its page.
const PAGE: &str = "cargo-mutants";
/// By mutant: why no test can notice it.
const EQUIVALENT: &str = "spec/equivalent.toml";
/// The counts of a lock, with what the page calls them.
const COUNTS: [(&str, &str); 3] =
    [("mutants", "mutants"), ("unviable", "do not compile"), ("caught by the cases", "caught by the golden cases")];
/// The fates of a lock, with what the page calls them. A lock names no mutant that has another one.
const FATES: [(&str, &str); 4] = [
    (BY_TESTS, "caught by the tests alone"),
    (TIMED_OUT, "ran too long"),
    (MISSED, "missed"),
    (NOT_TRIED, "not tried"),
];
const BY_TESTS: &str = "caught by the tests";
const TIMED_OUT: &str = "timed out";
const MISSED: &str = "missed";
/// The run was broken off.
const NOT_TRIED: &str = "not tried";

/// What was tried, now and before: a run replaces its module.
pub(super) struct Report {
    /// By the name of the module.
    locks: BTreeMap<&'static str, Lock>,
    /// Of the modules that were run now: what became of each mutant.
    fates: BTreeMap<&'static str, BTreeMap<String, Fate>>,
}

/// Everything: the locks, and the fate of every mutant of the modules that were run last.
#[derive(Serialize)]
struct Full<'a> {
    tool: String,
    modules: &'a BTreeMap<&'static str, Lock>,
    fates: &'a BTreeMap<&'static str, BTreeMap<String, Fate>>,
}

impl Report {
    /// What was tried before.
    ///
    /// # Errors
    /// A lock cannot be read.
    pub(super) fn read(project: &Project) -> Result<Self, MutateError> {
        let mut locks = BTreeMap::new();
        for module in &MODULES {
            locks.extend(Lock::read(&project.path(""), &artefact(module))?.map(|lock| (module.name, lock)));
        }
        Ok(Self { locks, fates: BTreeMap::new() })
    }

    /// Takes note of a run over a module.
    ///
    /// # Errors
    /// A source cannot be read.
    pub(super) fn ran(
        &mut self,
        project: &Project,
        module: &Module,
        mutants: &[Mutant],
        outcomes: &[Outcome],
    ) -> Result<(), MutateError> {
        let by_name: BTreeMap<&str, Fate> = outcomes.iter().map(|outcome| (&*outcome.name, outcome.fate)).collect();
        let fates: Vec<(&String, Option<Fate>)> =
            mutants.iter().map(|mutant| (&mutant.key, by_name.get(&*mutant.name).copied())).collect();
        let count = |of: Fate| fates.iter().filter(|(_, fate)| *fate == Some(of)).count() as u64;
        let counts = [mutants.len() as u64, count(Fate::Unviable), count(Fate::CaughtBy(By::Cases))];
        let named = fates.iter().filter_map(|(key, fate)| {
            let fate = match fate {
                Some(Fate::Unviable | Fate::CaughtBy(By::Cases)) => return None,
                Some(Fate::CaughtBy(By::Tests)) => BY_TESTS,
                Some(Fate::TimedOut) => TIMED_OUT,
                Some(Fate::Missed) => MISSED,
                None => NOT_TRIED,
            };
            Some(((*key).clone(), fate.to_owned()))
        });
        let lock = Lock {
            sources: sources(project, module)?,
            counts: COUNTS.iter().zip(counts).map(|((name, _), count)| ((*name).to_owned(), count)).collect(),
            fates: named.collect(),
            ..Lock::default()
        };
        self.locks.insert(module.name, lock);
        let fates = fates.into_iter().filter_map(|(key, fate)| Some((key.clone(), fate?)));
        self.fates.insert(module.name, fates.collect());
        Ok(())
    }

    /// What is wrong, a line each: a module that was not tried as it is now, a mutant that is missed and not
    /// explained, an explanation of what is not missed.
    ///
    /// # Errors
    /// A file cannot be read.
    pub(super) fn problems(&self, project: &Project) -> Result<Vec<String>, MutateError> {
        let mut problems = Vec::new();
        for module in &MODULES {
            let name = module.name;
            let again = |why: &str| format!("{name}: {why}; cargo assure mutate spec --module {name}");
            match self.locks.get(name) {
                None => problems.push(again("not tried")),
                Some(lock) if lock.sources != sources(project, module)? => {
                    problems.push(again("changed since it was tried"));
                }
                Some(_) => {}
            }
        }
        let why = equivalent(project)?;
        let missed: BTreeSet<&String> = self.named(MISSED).collect();
        problems.extend(self.named(NOT_TRIED).map(|key| format!("not tried: {key}")));
        let unexplained = missed.iter().filter(|key| !why.contains_key(**key));
        problems.extend(unexplained.map(|key| format!("missed, and not explained: {key}")));
        let stale = why.keys().filter(|key| !missed.contains(key));
        problems.extend(stale.map(|key| format!("{EQUIVALENT} explains what is not missed: {key}")));
        let written = fs::read_to_string(project.path(&format!("{}/{PAGE}.md", reports::PAGES))).unwrap_or_default();
        if problems.is_empty() && written.replace("\r\n", "\n") != crate::document::markdown(&self.page(&why)) {
            problems.push(format!("reports/{PAGE}.md is not what the locks and {EQUIVALENT} say"));
        }
        Ok(problems)
    }

    /// Keeps it.
    ///
    /// # Errors
    /// A file cannot be written.
    pub(super) fn write(&self, project: &Project) -> Result<(), MutateError> {
        for module in &MODULES {
            if let Some(lock) = self.locks.get(module.name) {
                lock.write(&project.path(""), &artefact(module))?;
            }
        }
        let (folder, page) = (project.path(reports::PAGES), self.page(&equivalent(project)?));
        let full = Full { tool: format!("cargo-mutants {CARGO_MUTANTS}"), modules: &self.locks, fates: &self.fates };
        reports::page(&folder, PAGE, &page)?;
        Ok(reports::full(&folder, PAGE, &full, &page)?)
    }

    /// All modules in a line.
    pub(super) fn summary(&self) -> String {
        let sums = columns().map(|(name, heading)| {
            let sum: u64 = self.locks.values().map(|lock| number(lock, name)).sum();
            format!("{sum} {heading}")
        });
        sums.collect::<Vec<_>>().join(", ")
    }

    /// What people read: the counts, and what nothing notices, each with its reason.
    fn page(&self, why: &BTreeMap<String, String>) -> Vec<Block> {
        let head: Vec<&str> = ["module", "files"].into_iter().chain(columns().map(|(_, heading)| heading)).collect();
        let rows = MODULES.iter().map(|module| {
            let files = module.files.iter().map(|files| format!("`{files}`")).collect::<Vec<_>>().join(", ");
            let lock = self.locks.get(module.name);
            let numbers = columns().map(|(name, _)| lock.map_or(0, |lock| number(lock, name)).to_string());
            [module.name.to_owned(), files].into_iter().chain(numbers).collect()
        });
        let mut page = vec![heading(1, "Mutants of the specification")];
        page.extend(ABOUT.map(text));
        page.extend([table(&head, rows), text(format!("In all: {}.", self.summary()))]);
        let mut list = |title: &str, about: &str, items: Vec<String>| {
            if !items.is_empty() {
                page.extend([heading(2, title), text(about), Block::List(items)]);
            }
        };
        let explained = |key: &String| format!("`{key}`: {}", why.get(key).map_or("**not explained**", String::as_str));
        list("Missed", "Of each is said why it cannot be noticed.", self.named(MISSED).map(explained).collect());
        let not_tried = self.named(NOT_TRIED).map(|key| format!("`{key}`")).collect();
        list("Not tried", "The run was broken off.", not_tried);
        page
    }

    /// The mutants that met with a fate, module by module.
    fn named(&self, fate: &'static str) -> impl Iterator<Item = &String> {
        let locks = MODULES.iter().filter_map(|module| self.locks.get(module.name));
        locks.flat_map(move |lock| lock.fates.iter().filter(move |(_, of)| *of == fate).map(|(key, _)| key))
    }
}

const ABOUT: [&str; 2] = [
    "Made by `cargo assure mutate spec`, which has cargo-mutants change the specification in one place after the \
     other, and asks whether that is noticed. A mutant is first held against the golden cases that can reach its \
     module, by a verifier that was built without the mutation. What they miss is held against the unit tests of \
     `ncp-spec` and those of its test programs that are about the module: what these alone catch is shown by no \
     golden case, since no call of the peer protocol asks for it or only the values of proptest reach it. A mutant \
     that ran too long counts as noticed: a test without an end is a test that fails. `.cargo/mutants.toml` is the \
     configuration; `assurance/src/mutate/spec/mod.rs` names the modules, their cases and their tests; \
     `spec/equivalent.toml` says why a mutant that is missed behaves as the specification does. The locks \
     `reports/lock/mutate-spec-*.toml` name the mutants that the cases did not catch, and \
     `reports/full/cargo-mutants.json` the fate of each once the command has run.",
    "`cargo assure mutate spec --check` says whether the sources are still those that were tried. `reports/mutants.md` \
     is about something else: peers with one defect each, chosen by hand, and the rule that each breaks.",
];

/// The columns of numbers: a count or a fate of a lock, and its heading.
fn columns() -> impl Iterator<Item = (&'static str, &'static str)> {
    let fates = FATES.into_iter().filter(|(name, _)| *name != NOT_TRIED);
    COUNTS.into_iter().chain(fates)
}

/// A count of a lock, or how many of its mutants met with a fate.
fn number(lock: &Lock, name: &str) -> u64 {
    let met = || lock.fates.values().filter(|fate| *fate == name).count() as u64;
    lock.counts.get(name).copied().unwrap_or_else(met)
}

/// The name under which the lock of a module is kept.
fn artefact(module: &Module) -> String {
    format!("mutate-spec-{}", module.name)
}

/// The digests of what a module's lock is about.
fn sources(project: &Project, module: &Module) -> Result<BTreeMap<String, String>, MutateError> {
    let root = project.path("");
    let digests = Artefact::named(&artefact(module)).map(|artefact| artefact.digests(&root)).transpose();
    Ok(digests.map_err(|source| MutateError::File { path: root, source })?.unwrap_or_default())
}

/// SHA-256 over the names and the contents of the files that are mutated.
///
/// # Errors
/// A file cannot be read.
pub(super) fn mutated(project: &Project, module: &Module) -> Result<String, MutateError> {
    let root = project.path("");
    let digest = || {
        let mut files = Vec::new();
        for pattern in module.files {
            matching(&root, pattern, &mut files)?;
        }
        of_files(&root, files)
    };
    digest().map_err(|source| MutateError::File { path: root.clone(), source })
}

/// The files that a pattern of a module means.
fn matching(root: &Path, pattern: &str, files: &mut Vec<PathBuf>) -> io::Result<()> {
    if let Some(folder) = pattern.strip_suffix("/**/*.rs") {
        collect(&root.join(folder), true, files)
    } else if let Some(folder) = pattern.strip_suffix("/*.rs") {
        collect(&root.join(folder), false, files)
    } else {
        files.push(root.join(pattern));
        Ok(())
    }
}

fn collect(folder: &Path, is_deep: bool, files: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if !path.is_dir() {
            files.push(path);
        } else if is_deep {
            collect(&path, is_deep, files)?;
        }
    }
    Ok(())
}

/// The committed explanations.
fn equivalent(project: &Project) -> Result<BTreeMap<String, String>, MutateError> {
    let path = project.path(EQUIVALENT);
    let text = fs::read_to_string(&path).map_err(|source| MutateError::File { path: path.clone(), source })?;
    toml::from_str(&text).map_err(|source| MutateError::Explained { path, source: Box::new(source) })
}

#[cfg(test)]
mod tests {
    use super::*;

    const WITH_LINE: &str = "spec/src/codec.rs:1:1: x";
    const KEY: &str = "spec/src/codec.rs: x";
    const MANIFEST: &str = "vectors/MANIFEST.sha256";
    const KERNEL: &str = "spec/kernel/src/decisions/speed.rs";

    /// A project whose files are empty, and a report that every module was tried with nothing missed.
    fn tried() -> (tempfile::TempDir, Project, Report) {
        let folder = tempfile::tempdir().unwrap();
        let root = folder.path();
        for path in ["spec/src/safety", "spec/src/resilience", "spec/src/bulk", "spec/src/wire/json", "vectors"] {
            fs::create_dir_all(root.join(path)).unwrap();
        }
        fs::create_dir_all(root.join(KERNEL).parent().unwrap()).unwrap();
        for file in [EQUIVALENT, MANIFEST, "spec/src/codec.rs", KERNEL] {
            fs::write(root.join(file), "").unwrap();
        }
        let project = Project::at(root);
        let mut report = Report::read(&project).unwrap();
        for module in &MODULES {
            report.ran(&project, module, &[], &[]).unwrap();
        }
        (folder, project, report)
    }

    fn problems(project: &Project, report: &Report) -> String {
        report.write(project).unwrap();
        Report::read(project).unwrap().problems(project).unwrap().join("\n")
    }

    fn page(project: &Project) -> String {
        fs::read_to_string(project.path("reports/cargo-mutants.md")).unwrap()
    }

    /// Has one mutant of the codec fare so, or not be tried.
    fn codec(project: &Project, report: &mut Report, fate: Option<Fate>) {
        let module = MODULES.iter().find(|module| module.name == "codec").unwrap();
        let mutant = Mutant { name: WITH_LINE.to_owned(), key: KEY.to_owned() };
        let outcome = fate.map(|fate| Outcome { name: WITH_LINE.to_owned(), fate });
        report.ran(project, module, &[mutant], outcome.as_slice()).unwrap();
    }

    #[test]
    fn a_mutant_that_is_missed_needs_an_explanation_and_no_other_has_one() {
        let (_folder, project, mut report) = tried();
        assert_eq!(problems(&project, &report), "");
        codec(&project, &mut report, Some(Fate::Missed));
        assert_eq!(problems(&project, &report), format!("missed, and not explained: {KEY}"));
        fs::write(project.path(EQUIVALENT), format!("{KEY:?} = \"Both are 0.\"\n")).unwrap();
        assert_eq!(problems(&project, &report), "");
        assert!(page(&project).contains("x`: Both are 0."));
        for fate in [Fate::CaughtBy(By::Cases), Fate::TimedOut, Fate::Unviable] {
            codec(&project, &mut report, Some(fate));
            let stale = format!("{EQUIVALENT} explains what is not missed: {KEY}");
            assert_eq!(problems(&project, &report), stale, "{fate:?}");
        }
    }

    #[test]
    fn a_mutant_or_a_module_that_was_not_tried_is_told() {
        let (_folder, project, mut report) = tried();
        codec(&project, &mut report, None);
        assert_eq!(problems(&project, &report), format!("not tried: {KEY}"));
        report.locks.remove("codec");
        fs::remove_file(project.path("reports/lock/mutate-spec-codec.toml")).unwrap();
        assert!(problems(&project, &report).starts_with("codec: not tried"));
    }

    #[test]
    fn a_change_makes_the_report_of_its_module_stale() {
        let (_folder, project, report) = tried();
        report.write(&project).unwrap();
        fs::write(project.path(KERNEL), "a.lt(b)").unwrap();
        let found = problems(&project, &report);
        assert!(found.starts_with("safety: changed") && found.lines().count() == 1, "{found}");
    }

    #[test]
    fn a_page_that_was_changed_by_hand_is_noticed() {
        let (_folder, project, report) = tried();
        report.write(&project).unwrap();
        fs::write(project.path("reports/cargo-mutants.md"), "all is well").unwrap();
        let found = Report::read(&project).unwrap().problems(&project).unwrap();
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(found[0].starts_with("reports/cargo-mutants.md"));
    }
}
