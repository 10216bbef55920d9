//! What git keeps of the proofs: a lock for each group of engines, and a short page.
//!
//! The engines leave their report as JSON; only what is kept of it is read here.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use serde::Deserialize;
use thiserror::Error;
use xtask::project::Project;

use crate::artefact::Artefact;
use crate::document::{Block, heading, table, text};
use crate::lock::{Lock, LockError};
use crate::reports::{self, ReportError};

/// Where the engines leave their report, from the root of the project.
const REPORT: &str = "reports/proofs.json";
/// The artefacts, each with the engines that make it.
const MADE_BY: [(&str, &[&str]); 4] = [
    ("proofs-kernel", &["symbolic", "enumeration", "kani-stand-in"]),
    ("proofs-machine", &["machine"]),
    ("proofs-model", &["model"]),
    ("proofs-readers", &["readers"]),
];

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
}

/// Writes the locks of the artefacts all of whose engines ran, and the page of all; no engine that is named means all.
///
/// # Errors
/// The report cannot be read, or a file cannot be written.
pub(crate) fn keep(project: &Project, engines: &[String], before: &Before) -> Result<(), ProofsError> {
    let root = project.path("");
    let report = read(&project.path(REPORT))?;
    let ran = |engine: &&str| engines.is_empty() || engines.iter().any(|named| named == engine);
    for (name, made_by) in MADE_BY.iter().filter(|(_, made_by)| made_by.iter().all(|engine| ran(engine))) {
        let sources = before.0.get(name).cloned().unwrap_or_default();
        lock(&report, made_by, sources).write(&root, name)?;
    }
    reports::page(&project.path(reports::PAGES), "proofs", &page(&report))?;
    Ok(())
}

/// What is read of the report.
#[derive(Debug, Deserialize)]
struct Report {
    properties: Vec<Property>,
    engines: Vec<Engine>,
    #[serde(default)]
    problems: Vec<String>,
}

/// A claim about the kernel, which several engines are held against.
#[derive(Debug, Deserialize)]
struct Property {
    id: String,
    rules: Vec<String>,
}

#[derive(Debug, Deserialize)]
struct Engine {
    name: String,
    version: String,
    about: String,
    #[serde(default)]
    results: Vec<Claim>,
    #[serde(default)]
    broken: Vec<Broken>,
    #[serde(default)]
    not_proved: Vec<String>,
}

#[derive(Debug, Deserialize)]
struct Claim {
    property: String,
    verdict: String,
    /// Its own rules, if it is not one of the shared claims.
    rules: Option<BTreeSet<String>>,
}

/// A copy of what is proved with a planted defect.
#[derive(Debug, Deserialize)]
struct Broken {
    id: String,
    /// Present if it is refuted, whatever it holds.
    counterexample: Option<serde::de::IgnoredAny>,
}

impl Claim {
    /// What the engine's word is worth: the enumeration covers the values that it lists.
    fn fate(&self, engine: &Engine) -> String {
        let is_partial = engine.name == "enumeration" && self.verdict == "proved";
        if is_partial { "proved for the listed values".to_owned() } else { self.verdict.clone() }
    }
}

impl Engine {
    fn proved(&self) -> usize {
        self.results.iter().filter(|claim| claim.verdict == "proved").count()
    }

    fn refuted(&self) -> usize {
        self.broken.iter().filter(|broken| broken.counterexample.is_some()).count()
    }
}

fn read(path: &Path) -> Result<Report, ProofsError> {
    let text = fs::read_to_string(path).map_err(|source| ProofsError::File { path: path.to_owned(), source })?;
    serde_json::from_str(&text).map_err(|source| ProofsError::Form { path: path.to_owned(), source })
}

/// What git keeps of what some engines found: their words on claims and on defects, by engine and id.
fn lock(report: &Report, engines: &[&str], sources: BTreeMap<String, String>) -> Lock {
    let mut lock = Lock { sources, ..Lock::default() };
    for engine in report.engines.iter().filter(|engine| engines.contains(&engine.name.as_str())) {
        let name = &engine.name;
        for claim in &engine.results {
            *lock.counts.entry(format!("{name}-{}", claim.verdict)).or_default() += 1;
            lock.fates.insert(format!("{name} {}", claim.property), claim.fate(engine));
            let shared = report.properties.iter().find(|property| property.id == claim.property);
            let shared = || shared.map(|property| property.rules.iter().cloned().collect());
            let rules: BTreeSet<String> = claim.rules.clone().or_else(shared).unwrap_or_default();
            lock.rules.insert(claim.property.clone(), rules.into_iter().collect());
        }
        for Broken { id, counterexample } in &engine.broken {
            let (end, fate) = if counterexample.is_some() { ("refuted", "refuted") } else { ("missed", "NOT refuted") };
            *lock.counts.entry(format!("{name}-{end}")).or_default() += 1;
            lock.fates.insert(format!("{name} defect {id}"), fate.to_owned());
        }
    }
    lock
}

/// The short page: what each engine shows, and what none does.
fn page(report: &Report) -> Vec<Block> {
    let mut page = vec![heading(1, "Proofs"), text(ABOUT)];
    if report.problems.is_empty() {
        page.push(text(
            "Every property is proved by an exhaustive engine, every family of the kernel by two; every planted defect \
             is refuted.",
        ));
    } else {
        page.push(heading(2, "Not shown"));
        page.push(Block::List(report.problems.clone()));
    }
    page.push(heading(2, "Engines"));
    let rows = report.engines.iter().map(|engine| {
        let of = |part: usize, whole: usize| if whole == 0 { "-".to_owned() } else { format!("{part} of {whole}") };
        vec![
            engine.name.clone(),
            engine.version.clone(),
            engine.about.clone(),
            of(engine.proved(), engine.results.len()),
            of(engine.refuted(), engine.broken.len()),
        ]
    });
    page.push(table(&["engine", "version", "what it does", "claims proved", "defects refuted"], rows));
    page.push(heading(2, "What is not proved"));
    let all = report.engines.iter();
    let all = all.flat_map(|engine| engine.not_proved.iter().map(|what| format!("{}: {what}", engine.name)));
    page.push(Block::List(all.collect()));
    page
}

const ABOUT: &str = "\
What is claimed of the code that decides whether a plant moves, and of the code that reads untrusted bytes, and which \
engine shows it. Made by `cargo assure prove`, which writes the whole report, with each claim in words and symbols, its \
bounds and assumptions, and what is trusted. Each claim and each planted defect with its end stands in \
`reports/lock/proofs-*.toml`; the files that solvers answered are in `proofs/evidence`.";

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn report() -> Report {
        let word = |property: &str, verdict: &str| json!({"property": property, "verdict": verdict});
        let broken = json!([{"id": "open_ball", "counterexample": {}}, {"id": "missed", "counterexample": null}]);
        let report = json!({
            "properties": [{"id": "clamp/bound", "rules": ["NCP-SAFE-002", "NCP-SAFE-001"]}],
            "engines": [
                {"name": "symbolic", "version": "1", "about": "All.", "results": [word("clamp/bound", "proved")], "broken": broken},
                {"name": "enumeration", "version": "1", "about": "Some.", "results": [word("clamp/bound", "proved")]},
                {"name": "model", "version": "1", "about": "Worlds.", "not_proved": ["liveness"], "results": [
                    {"property": "model/plant", "verdict": "proved", "rules": ["NCP-RES-001"]},
                ]},
            ],
        });
        serde_json::from_value(report).unwrap()
    }

    #[test]
    fn a_lock_says_what_each_engine_found_and_which_rules_a_claim_shows() {
        let lock = lock(&report(), &["symbolic", "enumeration"], BTreeMap::new());
        let fates: Vec<(&str, &str)> = lock.fates.iter().map(|(id, fate)| (id.as_str(), fate.as_str())).collect();
        assert_eq!(
            fates,
            [
                ("enumeration clamp/bound", "proved for the listed values"),
                ("symbolic clamp/bound", "proved"),
                ("symbolic defect missed", "NOT refuted"),
                ("symbolic defect open_ball", "refuted"),
            ]
        );
        assert_eq!(lock.counts["symbolic-missed"], 1);
        assert_eq!(lock.rules["clamp/bound"], ["NCP-SAFE-001", "NCP-SAFE-002"]);
        assert!(!lock.rules.contains_key("model/plant"));
    }

    #[test]
    fn the_page_says_what_is_not_proved() {
        let page = crate::document::markdown(&page(&report()));
        assert!(
            page.contains("| symbolic | 1 | All. | 1 of 1 | 1 of 2 |") && page.contains("- model: liveness"),
            "{page}"
        );
    }
}
