//! What git keeps of the proofs: a lock for each group of engines, and a short page, which is rendered from the locks
//! and the text and from nothing else.
//!
//! The engines leave their report as JSON.
//!
//! - `tables`: the tables of both forms of the report: claims, rules, what is trusted.
//! - `page`: the long form of the report, for auditors.
//! - `held`: what a lock has to say, whatever a report says.
//! - `theorem`: the theorem in Coq, as an engine.

mod held;
mod page;
mod tables;
pub(crate) mod theorem;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use ncp_proofs::digest::ARTEFACTS;
use ncp_proofs::pins;
use ncp_proofs::report::{self, Answer, Broken, Engine, FILE, Report, Verdict};
use ncp_text::catalogue::{Catalogue, CatalogueError};
use thiserror::Error;
use xtask::project::Project;

use crate::artefact::{Artefact, OF_PROOFS};
use crate::document::{self, Block};
use crate::lock::{Asked, Lock, LockError, Prover, Scope};
use crate::prove::QUICK;
use crate::reports::{self, ReportError};

pub(crate) use held::wrong;

/// The artefacts, each with the engines that make it.
const MADE_BY: [(&str, &[&str]); 6] = [
    ("proofs-kernel", &["symbolic", "enumeration", "kani-stand-in"]),
    ("proofs-machine", &["machine"]),
    ("proofs-model", &["model"]),
    ("proofs-readers", &["readers"]),
    ("proofs-path", &["path"]),
    ("proofs-theorem", &["theorem"]),
];
/// The name of the page.
const PAGE: &str = "proofs";

/// What git keeps of all engines, by artefact.
type Locks = BTreeMap<String, Lock>;

/// Why nothing can be kept.
#[derive(Debug, Error)]
pub(crate) enum ProofsError {
    #[error("{}: {source}", path.display())]
    File { path: PathBuf, source: io::Error },
    #[error("{}: {source}", path.display())]
    Form { path: PathBuf, source: serde_json::Error },
    #[error(transparent)]
    Lock(#[from] LockError),
    #[error(transparent)]
    Report(#[from] ReportError),
    #[error("the text: {0}")]
    Text(#[from] CatalogueError),
    #[error(transparent)]
    Defects(#[from] ncp_defects::TableError),
    #[error("{}: {source}", path.display())]
    Claims { path: PathBuf, source: toml::de::Error },
}

/// The digests of the sources of each artefact, as they were before the engines ran.
#[derive(Debug)]
pub(crate) struct Before(BTreeMap<&'static str, BTreeMap<String, String>>);

impl Before {
    /// Those of the sources as they are now.
    ///
    /// # Errors
    /// A source cannot be read.
    pub(crate) fn of(project: &Project) -> Result<Self, ProofsError> {
        let root = project.path("");
        let artefacts = MADE_BY.iter().filter_map(|(name, _)| Artefact::named(name));
        let digests = artefacts.map(|artefact| Ok((artefact.name, artefact.digests(&root)?)));
        let digests: io::Result<_> = digests.collect();
        Ok(Self(digests.map_err(|source| ProofsError::File { path: root, source })?))
    }

    /// The same, with what the run itself has pinned as it is now.
    ///
    /// # Errors
    /// A source cannot be read.
    pub(crate) fn pinned(mut self, project: &Project) -> Result<Self, ProofsError> {
        let mut now = Self::of(project)?;
        for (name, digests) in &mut self.0 {
            let pins = now.0.get_mut(name).and_then(|digests| digests.remove_entry(pins::FILE));
            digests.extend(pins);
        }
        Ok(self)
    }
}

/// Writes the locks of the artefacts all of whose engines ran, and the page of all; no engine that is named means all.
///
/// # Errors
/// The report cannot be read, or a file cannot be written.
pub(crate) fn keep(
    project: &Project,
    engines: &[String],
    before: &Before,
    is_long_wanted: bool,
) -> Result<(), ProofsError> {
    let root = project.path("");
    let report = read(&project.path(FILE))?;
    let ran = |engine: &&str| {
        let is_asked = engines.is_empty() || engines.iter().any(|named| named == engine);
        is_asked && report.engine(engine).is_some_and(|engine| !engine.not_run)
    };
    for (name, made_by) in MADE_BY.iter().filter(|(_, made_by)| made_by.iter().all(&ran)) {
        // A run that ends with an error leaves the report of an earlier one.
        if !is_about(&report, name, &root)? {
            println!("NOT KEPT: {name}: the report is about other sources; was this run ended by an error?");
            continue;
        }
        let sources = before.0.get(name).cloned().unwrap_or_default();
        lock(&report, made_by, sources).write(&root, name)?;
    }
    render(project)?;
    if is_long_wanted {
        let locks = locks_of(&report, before);
        let document = page::document(&report, &locks, &Catalogue::load()?, &commit(project));
        reports::long_pages(&project.path(reports::PAGES), PAGE, &document)?;
    }
    Ok(())
}

/// Whether what a report says of an artefact is about the sources as they are.
fn is_about(report: &Report, name: &str, root: &Path) -> Result<bool, ProofsError> {
    let name = name.strip_prefix(OF_PROOFS).unwrap_or(name);
    let artefact = ARTEFACTS.iter().find(|artefact| artefact.name == name);
    let digest = artefact.map(|artefact| artefact.digest(root)).transpose();
    let digest = digest.map_err(|source| ProofsError::File { path: root.to_owned(), source })?;
    Ok(digest.is_some() && report.digests.get(name) == digest.as_ref())
}

/// Writes the page anew.
///
/// # Errors
/// A lock cannot be read, or the page not written.
pub(crate) fn render(project: &Project) -> Result<(), ProofsError> {
    Ok(reports::page(&project.path(reports::PAGES), PAGE, &summary(&project.path(""))?)?)
}

/// Why the page is not what the locks and the text say.
///
/// # Errors
/// A lock cannot be read.
pub(crate) fn stale_page(root: &Path) -> Result<Vec<String>, ProofsError> {
    let name = format!("{}/{PAGE}.md", reports::PAGES);
    let written = fs::read_to_string(root.join(&name)).unwrap_or_default();
    let is_same = written.replace("\r\n", "\n") == document::markdown(&summary(root)?);
    Ok((!is_same).then(|| format!("{name} is not what the locks and the text say")).into_iter().collect())
}

/// How the words of the quick engines, which have just run, differ from those of the locks.
///
/// # Errors
/// The report or a lock cannot be read.
pub(crate) fn differing(project: &Project) -> Result<Vec<String>, ProofsError> {
    let report = read(&project.path(FILE))?;
    let mut lines = Vec::new();
    for (name, made_by) in MADE_BY {
        let quick: Vec<&str> = made_by.iter().copied().filter(|engine| QUICK.contains(engine)).collect();
        if quick.is_empty() {
            continue;
        }
        let kept = Lock::read(&project.path(""), name)?.unwrap_or_default();
        let found = lock(&report, &quick, BTreeMap::new());
        let is_quick =
            |id: &str| quick.iter().any(|engine| id.strip_prefix(engine).is_some_and(|id| id.starts_with(' ')));
        let kept: BTreeMap<&String, &String> = kept.fates.iter().filter(|(id, _)| is_quick(id)).collect();
        let none = "nothing".to_owned();
        let ids: BTreeSet<&String> = kept.keys().copied().chain(found.fates.keys()).collect();
        lines.extend(ids.into_iter().filter_map(|id| {
            let (was, is) = (kept.get(id).copied().unwrap_or(&none), found.fates.get(id).unwrap_or(&none));
            (was != is).then(|| format!("{name}: {id}: the lock says {was:?}, the engine {is:?}"))
        }));
    }
    Ok(lines)
}

/// The report of an earlier run, put aside for as long as this lives.
pub(crate) struct Aside {
    report: PathBuf,
    aside: PathBuf,
}

impl Aside {
    /// Puts it aside, if there is one.
    ///
    /// # Errors
    /// It cannot be moved.
    pub(crate) fn put(project: &Project) -> Result<Self, ProofsError> {
        let (report, aside) = (project.path(FILE), project.path(".tools/proofs-aside.json"));
        if report.exists() {
            fs::rename(&report, &aside).map_err(|source| ProofsError::File { path: report.clone(), source })?;
        }
        Ok(Self { report, aside })
    }
}

impl Drop for Aside {
    fn drop(&mut self) {
        // Without an earlier report, that of the quick engines alone would be taken for one.
        if !self.aside.exists() || fs::rename(&self.aside, &self.report).is_err() {
            fs::remove_file(&self.report).ok();
        }
    }
}

/// What the engine's word is worth: an enumeration covers the values that it lists, and no others.
fn fate(engine: &Engine, answer: &Answer) -> String {
    let is_listed = held::is_listed(&engine.name, &answer.property) && answer.verdict == Verdict::Proved;
    if is_listed { held::LISTED.to_owned() } else { answer.verdict.as_str().to_owned() }
}

fn read(path: &Path) -> Result<Report, ProofsError> {
    let text = fs::read_to_string(path).map_err(|source| ProofsError::File { path: path.to_owned(), source })?;
    serde_json::from_str(&text).map_err(|source| ProofsError::Form { path: path.to_owned(), source })
}

/// What git keeps of all of a report.
fn locks_of(report: &Report, before: &Before) -> Locks {
    let of = |(name, made_by): &(&'static str, &'static [&'static str])| {
        let lock = lock(report, made_by, before.0.get(name).cloned().unwrap_or_default());
        ((*name).to_owned(), lock)
    };
    MADE_BY.iter().map(of).collect()
}

/// What git keeps of what some engines found: their words on claims and on defects, by engine and id.
fn lock(report: &Report, engines: &[&str], sources: BTreeMap<String, String>) -> Lock {
    let mut lock = Lock { sources, ..Lock::default() };
    for engine in report.engines.iter().filter(|engine| engines.contains(&engine.name.as_str())) {
        let name = &engine.name;
        lock.problems.extend(report::problems_of(engine));
        let Engine { version, about, library_sha256, not_proved, .. } = engine.clone();
        lock.engines.insert(name.clone(), Prover { version, about, library_sha256, not_proved });
        for claim in &engine.results {
            lock.fates.insert(format!("{name} {}", claim.property), fate(engine, claim));
            lock.asked.insert(format!("{name} {}", claim.property), asked(claim));
            let shared = report.properties.iter().find(|property| property.id == claim.property);
            if let Some(words) = claim.words.as_ref().or(shared.map(|property| &property.words)) {
                let rules: BTreeSet<String> = words.rules.iter().cloned().collect();
                lock.rules.insert(claim.property.clone(), rules.into_iter().collect());
                let (family, bounds) = (words.family.clone(), words.bounds.clone());
                let rests_on = if name == "theorem" { claim.detail.clone() } else { String::new() };
                let scope = Scope { family, bounds, rests_on, assumptions: words.assumptions.clone() };
                lock.claims.insert(claim.property.clone(), scope);
            }
        }
        for Broken { id, family, property, counterexample, .. } in &engine.broken {
            let fate = if counterexample.is_some() { "refuted" } else { held::MISSED };
            lock.fates.insert(held::defect(name, family, id, property), fate.to_owned());
        }
    }
    lock.counts = held::counts(&lock.fates);
    lock
}

/// How much an engine asked of a claim.
fn asked(claim: &Answer) -> Asked {
    // The symbolic engine alone counts this.
    let without = serde_json::to_value(claim).ok().and_then(|claim| claim.get("without_arithmetic")?.as_u64());
    let cases = [claim.states, claim.paths, claim.runs].into_iter().flatten().max().unwrap_or_default();
    Asked { cases, questions: claim.obligations, without_arithmetic: without }
}

/// The short page, from the locks and the text.
fn summary(root: &Path) -> Result<Vec<Block>, ProofsError> {
    let mut locks = Locks::new();
    for (name, _) in MADE_BY {
        locks.insert(name.to_owned(), Lock::read(root, name)?.unwrap_or_default());
    }
    Ok(tables::page(&locks, &Catalogue::load()?))
}

/// The commit that was proved, and whether the tree had changes; empty where there is no git.
fn commit(project: &Project) -> String {
    let git = |args: &[&str]| {
        let output = project.program("git", args, "").output().ok().filter(|output| output.status.success())?;
        Some(String::from_utf8_lossy(&output.stdout).trim().to_owned())
    };
    let head = git(&["rev-parse", "HEAD"]).unwrap_or_default();
    let is_changed = git(&["status", "--porcelain"]).is_some_and(|changes| !changes.is_empty());
    if is_changed { format!("{head}, with changes that are not committed") } else { head }
}

#[cfg(test)]
mod tests {
    use ncp_proofs::report::{Claim, Words};
    use serde_json::{Value, json};

    use super::*;

    fn words(family: &str, rules: &[&str]) -> Words {
        let rules = rules.iter().map(|rule| (*rule).to_owned()).collect();
        let (sentence, statement, bounds) = (String::new(), String::new(), "two steps".to_owned());
        Words { family: family.to_owned(), rules, sentence, statement, bounds, assumptions: Vec::new() }
    }

    fn engine(name: &str, results: &Value, broken: &Value) -> Engine {
        let engine = json!({"name": name, "version": "1", "about": "All.", "results": results, "broken": broken});
        serde_json::from_value(engine).unwrap()
    }

    #[test]
    fn a_report_counts_only_for_the_sources_that_it_is_about() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
        let kernel = ARTEFACTS.iter().find(|artefact| artefact.name == "kernel").unwrap();
        let mut report = report();
        report.digests.insert("kernel".to_owned(), "of an earlier run".to_owned());
        assert!(!is_about(&report, "proofs-kernel", root).unwrap());
        report.digests.insert("kernel".to_owned(), kernel.digest(root).unwrap());
        assert!(is_about(&report, "proofs-kernel", root).unwrap());
        assert!(!is_about(&report, "proofs-model", root).unwrap());
    }

    pub(super) fn report() -> Report {
        let proved = |claim: &str| json!({"property": claim, "verdict": "proved", "obligations": 3});
        let broken = |id: &str, property: &str, found: Value| {
            let (family, about) = ("clamp", "");
            json!({"id": id, "property": property, "family": family, "about": about, "counterexample": found})
        };
        let found = json!({"check": "c", "inputs": []});
        let defects = json!([
            broken("open-ball", "clamp/bound", found),
            broken("missed", "clamp/bound", Value::Null),
            broken("missed", "clamp/tick", json!({"check": "c", "inputs": []})),
        ]);
        let mut model = engine("model", &json!([proved("model/plant")]), &json!([]));
        model.not_proved.push("liveness".to_owned());
        model.results[0].words = Some(words("model", &["NCP-RES-001"]));
        Report {
            properties: vec![Claim {
                id: "clamp/bound".to_owned(),
                words: words("clamp", &["NCP-SAFE-002", "NCP-SAFE-001"]),
            }],
            engines: vec![
                engine("symbolic", &json!([proved("clamp/bound")]), &defects),
                engine("enumeration", &json!([proved("clamp/bound")]), &json!([])),
                model,
            ],
            ..Report::default()
        }
    }

    #[test]
    fn a_lock_says_what_each_engine_found_and_which_rules_a_claim_shows() {
        let lock = lock(&report(), &["symbolic", "enumeration"], BTreeMap::new());
        let fates: Vec<(&str, &str)> = lock.fates.iter().map(|(id, fate)| (id.as_str(), fate.as_str())).collect();
        assert_eq!(
            fates,
            [
                ("enumeration clamp/bound", "holds on the listed values"),
                ("symbolic clamp/bound", "proved"),
                ("symbolic defect clamp/missed by clamp/bound", "NOT refuted"),
                ("symbolic defect clamp/missed by clamp/tick", "refuted"),
                ("symbolic defect clamp/open-ball by clamp/bound", "refuted"),
            ]
        );
        assert_eq!(lock.counts["symbolic-missed"], 1);
        assert_eq!(lock.counts["enumeration-listed"], 1);
        assert_eq!(lock.rules["clamp/bound"], ["NCP-SAFE-001", "NCP-SAFE-002"]);
        assert!(!lock.rules.contains_key("model/plant"));
        assert_eq!(lock.problems, ["symbolic: missed is not refuted by clamp/bound"]);
    }

    #[test]
    fn a_page_that_was_edited_by_hand_is_stale() {
        let root = tempfile::tempdir().unwrap();
        let project = Project::at(root.path());
        lock(&report(), &["symbolic"], BTreeMap::new()).write(root.path(), "proofs-kernel").unwrap();
        render(&project).unwrap();
        assert!(stale_page(root.path()).unwrap().is_empty());
        let page = root.path().join("reports/proofs.md");
        let text = fs::read_to_string(&page).unwrap().replace("1 of 1", "2 of 2");
        fs::write(&page, text + " ").unwrap();
        assert_eq!(stale_page(root.path()).unwrap(), ["reports/proofs.md is not what the locks and the text say"]);
    }
}
