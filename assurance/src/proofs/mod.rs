//! What git keeps of the proofs: a lock for each group of engines, and a short page.
//!
//! The engines leave their report as JSON.
//!
//! - `page`: the long form of the report, for auditors.

mod page;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use ncp_proofs::report::{Answer, Broken, Engine, FILE, Report, Verdict};
use thiserror::Error;
use xtask::project::Project;

use crate::artefact::Artefact;
use crate::document::{Block, heading, table, text};
use crate::lock::{Lock, LockError};
use crate::reports::{self, ReportError};

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
pub(crate) fn keep(
    project: &Project,
    engines: &[String],
    before: &Before,
    is_long_wanted: bool,
) -> Result<(), ProofsError> {
    let root = project.path("");
    let report = read(&project.path(FILE))?;
    let ran = |engine: &&str| engines.is_empty() || engines.iter().any(|named| named == engine);
    for (name, made_by) in MADE_BY.iter().filter(|(_, made_by)| made_by.iter().all(&ran)) {
        let sources = before.0.get(name).cloned().unwrap_or_default();
        lock(&report, made_by, sources).write(&root, name)?;
    }
    let pages = project.path(reports::PAGES);
    reports::page(&pages, "proofs", &summary(&report))?;
    if is_long_wanted {
        reports::long_pages(&pages, "proofs", &page::document(&report))?;
    }
    Ok(())
}

/// What the engine's word is worth: the enumeration covers the values that it lists.
fn fate(engine: &Engine, answer: &Answer) -> String {
    let is_partial = engine.name == "enumeration" && answer.verdict == Verdict::Proved;
    if is_partial { "proved for the listed values".to_owned() } else { answer.verdict.as_str().to_owned() }
}

fn proved(engine: &Engine) -> usize {
    engine.results.iter().filter(|answer| answer.verdict == Verdict::Proved).count()
}

fn refuted(engine: &Engine) -> usize {
    engine.broken.iter().filter(|broken| broken.counterexample.is_some()).count()
}

fn read(path: &Path) -> Result<Report, ProofsError> {
    let text = fs::read_to_string(path).map_err(|source| ProofsError::File { path: path.to_owned(), source })?;
    serde_json::from_str(&text).map_err(|source| ProofsError::Form { path: path.to_owned(), source })
}

/// What git keeps of what some engines found: their words on claims and on defects, by engine and id.
fn lock(report: &Report, engines: &[&str], sources: BTreeMap<String, String>) -> Lock {
    let mut lock = Lock { sources, problems: report.problems.clone(), ..Lock::default() };
    for engine in report.engines.iter().filter(|engine| engines.contains(&engine.name.as_str())) {
        let name = &engine.name;
        for claim in &engine.results {
            *lock.counts.entry(format!("{name}-{}", claim.verdict.as_str())).or_default() += 1;
            lock.fates.insert(format!("{name} {}", claim.property), fate(engine, claim));
            let shared = report.properties.iter().find(|property| property.id == claim.property);
            let shared = || shared.map(|property| property.words.rules.iter().cloned().collect());
            let rules: BTreeSet<String> = claim
                .words
                .as_ref()
                .map(|words| words.rules.iter().cloned().collect())
                .or_else(shared)
                .unwrap_or_default();
            lock.rules.insert(claim.property.clone(), rules.into_iter().collect());
        }
        for Broken { id, counterexample, .. } in &engine.broken {
            let (end, fate) = if counterexample.is_some() { ("refuted", "refuted") } else { ("missed", "NOT refuted") };
            *lock.counts.entry(format!("{name}-{end}")).or_default() += 1;
            lock.fates.insert(format!("{name} defect {id}"), fate.to_owned());
        }
    }
    lock
}

/// The short page: what each engine shows, and what none does.
fn summary(report: &Report) -> Vec<Block> {
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
            of(proved(engine), engine.results.len()),
            of(refuted(engine), engine.broken.len()),
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
engine shows it. Made by `cargo assure prove`; with `--report` it also writes the long report, with each claim in \
words and symbols, its bounds and assumptions, and what is trusted. Each claim and each planted defect with its end \
stands in `reports/lock/proofs-*.toml`; the files that solvers answered are in `proofs/evidence`.";

#[cfg(test)]
mod tests {
    use ncp_proofs::report::{Claim, Words};
    use serde_json::{Value, json};

    use super::*;

    fn words(family: &str, rules: &[&str]) -> Words {
        let rules = rules.iter().map(|rule| (*rule).to_owned()).collect();
        let (sentence, statement, bounds) = (String::new(), String::new(), String::new());
        Words { family: family.to_owned(), rules, sentence, statement, bounds, assumptions: Vec::new() }
    }

    fn engine(name: &str, results: &Value, broken: &Value) -> Engine {
        let engine = json!({"name": name, "version": "1", "about": "All.", "results": results, "broken": broken});
        serde_json::from_value(engine).unwrap()
    }

    fn report() -> Report {
        let proved = |claim: &str| json!({"property": claim, "verdict": "proved"});
        let broken = |id: &str, counterexample: Value| {
            let (property, family) = ("clamp/bound", "clamp");
            json!({"id": id, "property": property, "family": family, "about": "", "counterexample": counterexample})
        };
        let found = json!({"check": "c", "inputs": []});
        let defects = json!([broken("open-ball", found), broken("missed", Value::Null)]);
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
                ("enumeration clamp/bound", "proved for the listed values"),
                ("symbolic clamp/bound", "proved"),
                ("symbolic defect missed", "NOT refuted"),
                ("symbolic defect open-ball", "refuted"),
            ]
        );
        assert_eq!(lock.counts["symbolic-missed"], 1);
        assert_eq!(lock.rules["clamp/bound"], ["NCP-SAFE-001", "NCP-SAFE-002"]);
        assert!(!lock.rules.contains_key("model/plant"));
    }

    #[test]
    fn the_page_says_what_is_not_proved() {
        let page = crate::document::markdown(&summary(&report()));
        assert!(
            page.contains("| symbolic | 1 | All. | 1 of 1 | 1 of 2 |") && page.contains("- model: liveness"),
            "{page}"
        );
    }
}
