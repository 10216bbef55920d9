//! What was tried: the lock, the page, and the fate of every mutant.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use xtask::project::Project;

use super::outcome::{By, Fate, Mutant, Outcome};
use super::{CARGO_MUTANTS, MODULES, Module, SpecError};
use crate::digest::of_files;
use crate::kept;

/// The name under which it is kept.
const NAME: &str = "cargo-mutants";
/// By mutant: why no test can notice it.
const EQUIVALENT: &str = "spec/equivalent.toml";
/// The digests of the golden cases.
const MANIFEST: &str = "vectors/MANIFEST.sha256";

/// What was tried, now and before: a run replaces its module.
pub(super) struct Report {
    lock: Lock,
    /// Of the modules that were run now: what became of each mutant.
    fates: BTreeMap<&'static str, BTreeMap<String, Fate>>,
}

/// What stands in git.
#[derive(Debug, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Lock {
    /// By name.
    #[serde(default)]
    modules: BTreeMap<String, Tried>,
}

/// A run over the mutants of a module. A list names its mutants.
#[derive(Debug, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Tried {
    tool: String,
    /// SHA-256 of the module's files, and of the manifest of the golden cases.
    sources: String,
    cases: String,
    started: Option<String>,
    ended: Option<String>,
    mutants: usize,
    /// How many of them do not compile.
    unviable: usize,
    caught_by_cases: usize,
    /// What no golden case shows.
    caught_by_tests: Vec<String>,
    timed_out: Vec<String>,
    missed: Vec<String>,
    /// Where the run was broken off.
    not_tried: Vec<String>,
}

/// Everything: the lock, and the fate of every mutant of the modules that were run last.
#[derive(Serialize)]
struct Full<'a> {
    #[serde(flatten)]
    lock: &'a Lock,
    fates: &'a BTreeMap<&'static str, BTreeMap<String, Fate>>,
}

impl Report {
    /// What was tried before.
    ///
    /// # Errors
    /// The lock cannot be read.
    pub(super) fn read(project: &Project) -> Result<Self, SpecError> {
        Ok(Self { lock: kept::read(project, NAME)?.unwrap_or_default(), fates: BTreeMap::new() })
    }

    /// Takes note of a run over a module.
    pub(super) fn ran(&mut self, module: &Module, digests: &Digests, mutants: &[Mutant], outcomes: &[Outcome]) {
        let by_name: BTreeMap<&str, Fate> = outcomes.iter().map(|outcome| (&*outcome.name, outcome.fate)).collect();
        let keys = |fate: Option<Fate>| -> Vec<String> {
            let met = mutants.iter().filter(|mutant| by_name.get(&*mutant.name).copied() == fate);
            met.map(|mutant| mutant.key.clone()).collect()
        };
        let count = |fate| keys(Some(fate)).len();
        let runs = || outcomes.iter().map(|outcome| &outcome.run);
        let tried = Tried {
            tool: format!("cargo-mutants {CARGO_MUTANTS}"),
            sources: digests.sources.clone(),
            cases: digests.cases.clone(),
            started: runs().map(|[started, _]| started.clone()).min(),
            ended: runs().map(|[_, ended]| ended.clone()).max(),
            mutants: mutants.len(),
            unviable: count(Fate::Unviable),
            caught_by_cases: count(Fate::CaughtBy(By::Cases)),
            caught_by_tests: keys(Some(Fate::CaughtBy(By::Tests))),
            timed_out: keys(Some(Fate::TimedOut)),
            missed: keys(Some(Fate::Missed)),
            not_tried: keys(None),
        };
        self.lock.modules.insert(module.name.to_owned(), tried);
        let fates = mutants.iter().filter_map(|mutant| Some((mutant.key.clone(), *by_name.get(&*mutant.name)?)));
        self.fates.insert(module.name, fates.collect());
    }

    /// What is wrong, a line each: a module that was not tried as it is now, a mutant that is missed and not
    /// explained, an explanation of what is not missed.
    ///
    /// # Errors
    /// A file cannot be read.
    pub(super) fn problems(&self, project: &Project) -> Result<Vec<String>, SpecError> {
        let mut problems = Vec::new();
        let why = equivalent(project)?;
        let mut missed = BTreeSet::new();
        for module in &MODULES {
            let name = module.name;
            let Some(tried) = self.lock.modules.get(name) else {
                problems.push(format!("{name}: not tried; cargo assure mutate spec --module {name}"));
                continue;
            };
            if tried.sources != Digests::of(project, module)?.sources {
                problems.push(format!("{name}: changed since it was tried; cargo assure mutate spec --module {name}"));
            }
            problems.extend(tried.not_tried.iter().map(|key| format!("not tried: {key}")));
            missed.extend(&tried.missed);
        }
        let unexplained = missed.iter().filter(|key| !why.contains_key(**key));
        problems.extend(unexplained.map(|key| format!("missed, and not explained: {key}")));
        let stale = why.keys().filter(|key| !missed.contains(key));
        problems.extend(stale.map(|key| format!("{EQUIVALENT} explains what is not missed: {key}")));
        if problems.is_empty() && kept::read_page(project, NAME) != page(&self.lock, &why) {
            let (page, lock) = (kept::page_file(NAME), kept::lock_file(NAME));
            problems.push(format!("{page} is not what {lock} and {EQUIVALENT} say"));
        }
        Ok(problems)
    }

    /// Keeps it.
    ///
    /// # Errors
    /// A file cannot be written.
    pub(super) fn write(&self, project: &Project) -> Result<(), SpecError> {
        let page = page(&self.lock, &equivalent(project)?);
        let full = Full { lock: &self.lock, fates: &self.fates };
        Ok(kept::write(project, NAME, &self.lock, &page, &full)?)
    }

    /// All modules in a line.
    pub(super) fn summary(&self) -> String {
        summary(&self.lock)
    }
}

/// What people read: the counts, and what nothing notices, each with its reason.
fn page(lock: &Lock, why: &BTreeMap<String, String>) -> String {
    let headings = counts(&Tried::default()).map(|(heading, _)| heading);
    let mut page = format!("{HEAD}| module | tried with | began | ended | {} |\n", headings.join(" | "));
    page.push_str("|---|---|---|---|---|---|---|---|---|---|\n");
    for module in &MODULES {
        let none = Tried::default();
        let tried = lock.modules.get(module.name).unwrap_or(&none);
        let tool = if tried.tool.is_empty() { "not tried" } else { &tried.tool };
        let time = |time: &Option<String>| time.clone().unwrap_or_else(|| "not tried".to_owned());
        let files = module.files.iter().map(|files| format!("`{files}`")).collect::<Vec<_>>().join(", ");
        let counts = counts(tried).map(|(_, count)| count.to_string()).join(" | ");
        let (began, ended) = (time(&tried.started), time(&tried.ended));
        let _ = writeln!(page, "| {} ({files}) | {tool} | {began} | {ended} | {counts} |", module.name);
    }
    let _ = writeln!(page, "\nIn all: {}.", summary(lock));
    let tried = || MODULES.iter().filter_map(|module| lock.modules.get(module.name));
    let missed: Vec<&String> = tried().flat_map(|tried| &tried.missed).collect();
    if !missed.is_empty() {
        page.push_str("\n## Missed\n\nOf each is said why it cannot be noticed.\n\n");
    }
    for key in missed {
        let why = why.get(key).map_or("**not explained**", String::as_str);
        let _ = writeln!(page, "- `{key}`: {why}");
    }
    let not_tried: Vec<&String> = tried().flat_map(|tried| &tried.not_tried).collect();
    if !not_tried.is_empty() {
        page.push_str("\n## Not tried\n\nThe run was broken off.\n\n");
    }
    for key in not_tried {
        let _ = writeln!(page, "- `{key}`");
    }
    page
}

const HEAD: &str = "\
# Mutants of the specification

Made by `cargo assure mutate spec`, which has cargo-mutants change the specification in one place after the other, and \
asks whether that is noticed. A mutant is first held against the golden cases that can reach its module, by a verifier \
that was built without the mutation. What they miss is held against the unit tests of `ncp-spec` and those of its test \
programs that are about the module: what these alone catch is shown by no golden case, since no call of the peer \
protocol asks for it or only the values of proptest reach it. A mutant that ran too long counts as noticed: a test \
without an end is a test that fails. `.cargo/mutants.toml` is the configuration; `assurance/src/mutate/spec/mod.rs` \
names the modules, their cases and their tests; `spec/equivalent.toml` says why a mutant that is missed behaves as the \
specification does. `reports/lock/cargo-mutants.toml` names the mutants that the cases did not catch, and \
`reports/full/cargo-mutants.json` the fate of each once the command has run.

`cargo assure mutate spec --check` says whether the sources are still those that were tried. `reports/mutants.md` is \
about something else: peers with one defect each, chosen by hand, and the rule that each breaks.

";

/// The columns of numbers, with their headings.
fn counts(tried: &Tried) -> [(&'static str, usize); 6] {
    [
        ("mutants", tried.mutants),
        ("do not compile", tried.unviable),
        ("caught by the golden cases", tried.caught_by_cases),
        ("caught by the tests alone", tried.caught_by_tests.len()),
        ("ran too long", tried.timed_out.len()),
        ("missed", tried.missed.len()),
    ]
}

fn summary(lock: &Lock) -> String {
    let mut sums = counts(&Tried::default());
    for tried in MODULES.iter().filter_map(|module| lock.modules.get(module.name)) {
        for (sum, (_, count)) in sums.iter_mut().zip(counts(tried)) {
            sum.1 += count;
        }
    }
    sums.map(|(heading, sum)| format!("{sum} {heading}")).join(", ")
}

/// What a run over a module is about.
pub(super) struct Digests {
    /// SHA-256 over the names and the contents of the module's files.
    pub(super) sources: String,
    /// SHA-256 of the manifest of the golden cases.
    cases: String,
}

impl Digests {
    /// Those of a module as it is.
    ///
    /// # Errors
    /// A file cannot be read.
    pub(super) fn of(project: &Project, module: &Module) -> Result<Self, SpecError> {
        let root = project.path("");
        let digest = || {
            let mut files = Vec::new();
            for pattern in module.files {
                matching(&root, pattern, &mut files)?;
            }
            Ok((of_files(&root, files)?, of_files(&root, vec![root.join(MANIFEST)])?))
        };
        let (sources, cases) = digest().map_err(|source| SpecError::File { path: root.clone(), source })?;
        Ok(Self { sources, cases })
    }
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
fn equivalent(project: &Project) -> Result<BTreeMap<String, String>, SpecError> {
    let path = project.path(EQUIVALENT);
    let text = fs::read_to_string(&path).map_err(|source| SpecError::File { path: path.clone(), source })?;
    toml::from_str(&text).map_err(|source| SpecError::Explained { path, source: Box::new(source) })
}

#[cfg(test)]
mod tests {
    use super::*;

    const WITH_LINE: &str = "spec/src/codec.rs:1:1: x";
    const KEY: &str = "spec/src/codec.rs: x";
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
            report.ran(module, &Digests::of(&project, module).unwrap(), &[], &[]);
        }
        (folder, project, report)
    }

    fn problems(project: &Project, report: &Report) -> String {
        report.write(project).unwrap();
        Report::read(project).unwrap().problems(project).unwrap().join("\n")
    }

    /// Has one mutant of the codec fare so, or not be tried.
    fn codec(project: &Project, report: &mut Report, fate: Option<Fate>) {
        let module = MODULES.iter().find(|module| module.name == "codec").unwrap();
        let mutant = Mutant { name: WITH_LINE.to_owned(), key: KEY.to_owned() };
        let run = ["2026-01-02T03:04:05Z", "2026-01-02T04:04:05Z"].map(str::to_owned);
        let outcome = fate.map(|fate| Outcome { name: WITH_LINE.to_owned(), fate, run });
        let digests = Digests::of(project, module).unwrap();
        report.ran(module, &digests, &[mutant], outcome.as_slice());
    }

    #[test]
    fn a_mutant_that_is_missed_needs_an_explanation_and_no_other_has_one() {
        let (_folder, project, mut report) = tried();
        assert_eq!(problems(&project, &report), "");
        codec(&project, &mut report, Some(Fate::Missed));
        assert_eq!(problems(&project, &report), format!("missed, and not explained: {KEY}"));
        fs::write(project.path(EQUIVALENT), format!("{KEY:?} = \"Both are 0.\"\n")).unwrap();
        assert_eq!(problems(&project, &report), "");
        assert!(kept::read_page(&project, NAME).contains("x`: Both are 0."));
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
        report.lock.modules.remove("codec");
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
        fs::write(project.path(&kept::page_file(NAME)), "all is well").unwrap();
        let found = Report::read(&project).unwrap().problems(&project).unwrap();
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(found[0].starts_with(&kept::page_file(NAME)));
    }
}
