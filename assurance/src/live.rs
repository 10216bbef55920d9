//! `cargo assure live`: what the live scenarios say of our own system, and whether they notice what is planted in it.
//!
//! Zenoh is built and run by the workspace `live/`; here its verdicts are kept, so that a scenario counts as evidence
//! only where it was run and passed.

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::PathBuf;

use clap::Args;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use thiserror::Error;
use xtask::project::Project;

use crate::artefact::Artefact;
use crate::document::{Block, heading, table, text};
use crate::lock::{Lock, LockError};
use crate::reports::{self, ReportError};

/// The name of the artefact, of its lock and of its page.
pub(crate) const NAME: &str = "live";
/// The verdict that shows a rule.
pub(crate) const PASSED: &str = "passed";
/// Where the program leaves what it found, from the root of the project.
const RULINGS: &str = "reports/full/live-rulings.json";
const DEFECTS: &str = "reports/full/live-defects.json";
const AGAIN: &str = "reports/full/live-again.json";

#[derive(Debug, Args)]
pub(crate) struct LiveArgs {
    /// Only the defects that the last run missed, and nothing else of it; it has to be of the same sources
    #[arg(long)]
    missed: bool,
}

/// Why the live scenarios say nothing.
#[derive(Debug, Error)]
pub(crate) enum LiveError {
    #[error("cannot start cargo: {0}")]
    Start(io::Error),
    #[error("the sources have changed since the last run: run `cargo assure live` without --missed")]
    Changed,
    #[error("`cargo live {command}` left no result: it could not judge")]
    NoResult { command: &'static str },
    #[error("{}: {source}", path.display())]
    File { path: PathBuf, source: io::Error },
    #[error("{}: {source}", path.display())]
    Form { path: PathBuf, source: serde_json::Error },
    #[error(transparent)]
    Lock(#[from] LockError),
    #[error(transparent)]
    Report(#[from] ReportError),
}

/// The verdict of a scenario on a rule.
#[derive(Debug, Clone, Serialize, Deserialize)]
struct Ruling {
    scenario: String,
    rule: String,
    verdict: String,
    #[serde(default)]
    why: Option<String>,
}

/// What became of a planted defect.
#[derive(Debug, Clone, Serialize, Deserialize)]
struct Found {
    defect: String,
    scenario: String,
    rule: String,
    failed: Vec<String>,
}

/// Everything.
#[derive(Debug, Serialize)]
struct Report {
    rulings: Vec<Ruling>,
    defects: Vec<Found>,
}

/// Runs every scenario on our own system, and with each planted defect; `false` if a rule is not shown, or a defect not
/// noticed by its rule. A busy machine leaves a scenario without a verdict, so a defect that is missed is tried once
/// more.
///
/// # Errors
/// A program that cannot be started, or a file.
pub(crate) fn run(project: &Project, args: &LiveArgs) -> Result<bool, LiveError> {
    let root = project.path("");
    // What changes while it runs was not judged.
    let sources = Artefact::named(NAME).map(|own| own.digests(&root)).transpose();
    let sources = sources.map_err(|source| LiveError::File { path: root.clone(), source })?.unwrap_or_default();
    let mut report = if args.missed {
        if Lock::read(&root, NAME)?.is_none_or(|lock| lock.sources != sources) {
            return Err(LiveError::Changed);
        }
        Report { rulings: left(project, "all", RULINGS)?, defects: left(project, "mutants", DEFECTS)? }
    } else {
        Report { rulings: judged(project, "all", RULINGS, &[])?, defects: judged(project, "mutants", DEFECTS, &[])? }
    };
    let missed = report.defects.iter().filter(|found| !found.is_caught());
    let missed: Vec<String> = missed.flat_map(|found| ["--only".to_owned(), found.defect.clone()]).collect();
    if !missed.is_empty() {
        let again: Vec<Found> = judged(project, "mutants", AGAIN, &missed)?;
        for found in &mut report.defects {
            let other = again.iter().find(|other| (&other.defect, &other.scenario) == (&found.defect, &found.scenario));
            *found = other.unwrap_or(found).clone();
        }
    }
    report.lock(sources).write(&root, NAME)?;
    let (folder, page) = (project.path(reports::PAGES), report.page());
    reports::page(&folder, NAME, &page)?;
    reports::full(&folder, NAME, &report, &page)?;
    let problems = report.problems();
    problems.iter().for_each(|problem| println!("{problem}"));
    Ok(problems.is_empty())
}

/// Under which name the lock keeps the verdict of a scenario on a rule.
pub(crate) fn fate_of(scenario: &str, rule: &str) -> String {
    format!("{scenario} {rule}")
}

/// What `cargo live` finds with a command.
fn judged<T: DeserializeOwned>(
    project: &Project,
    command: &'static str,
    file: &str,
    more: &[String],
) -> Result<Vec<T>, LiveError> {
    let path = project.path(file);
    let failed = |source| LiveError::File { path: path.clone(), source };
    path.parent().map_or(Ok(()), fs::create_dir_all).map_err(failed)?;
    if path.exists() {
        fs::remove_file(&path).map_err(failed)?;
    }
    let words = ["run", "--quiet", "--manifest-path", "live/Cargo.toml", "-p", "ncp-live", "--", command, "--json"];
    project.cargo(&words).arg(&path).args(more).status().map_err(LiveError::Start)?;
    left(project, command, file)
}

/// What a command left.
fn left<T: DeserializeOwned>(project: &Project, command: &'static str, file: &str) -> Result<Vec<T>, LiveError> {
    let path = project.path(file);
    if !path.exists() {
        return Err(LiveError::NoResult { command });
    }
    let text = fs::read_to_string(&path).map_err(|source| LiveError::File { path: path.clone(), source })?;
    serde_json::from_str(&text).map_err(|source| LiveError::Form { path, source })
}

impl Found {
    fn is_caught(&self) -> bool {
        self.failed.contains(&self.rule)
    }
}

impl Report {
    fn lock(&self, sources: BTreeMap<String, String>) -> Lock {
        let mut counts = BTreeMap::new();
        let mut fates = BTreeMap::new();
        for Ruling { scenario, rule, verdict, .. } in &self.rulings {
            *counts.entry(format!("verdicts {verdict}")).or_default() += 1;
            fates.insert(fate_of(scenario, rule), verdict.clone());
        }
        for found in &self.defects {
            let fate = if found.is_caught() { "defects caught" } else { "defects missed" };
            *counts.entry(fate.to_owned()).or_default() += 1;
        }
        Lock { sources, counts, fates, problems: self.problems(), ..Lock::default() }
    }

    fn problems(&self) -> Vec<String> {
        let unshown = self.rulings.iter().filter(|ruling| ruling.verdict != PASSED);
        let unshown = unshown.map(|Ruling { scenario, rule, verdict, why }| {
            format!("{scenario}: {rule} {verdict}: {}", why.as_deref().unwrap_or("nothing is said"))
        });
        let missed = self.defects.iter().filter(|found| !found.is_caught());
        let missed = missed.map(|Found { defect, scenario, rule, failed }| {
            format!("{defect}: {scenario} does not fail {rule} (but {})", failed.join(", "))
        });
        unshown.chain(missed).collect()
    }

    /// What people read.
    fn page(&self) -> Vec<Block> {
        let mut groups: BTreeMap<&str, [usize; 4]> = BTreeMap::new();
        let group = |scenario: &'_ str| scenario.split('/').next().map_or(0, str::len);
        for Ruling { scenario, verdict, .. } in &self.rulings {
            let row = groups.entry(scenario.get(..group(scenario)).unwrap_or_default()).or_default();
            row[0] += 1;
            row[1] += usize::from(verdict == PASSED);
        }
        for found in &self.defects {
            let row = groups.entry(found.scenario.get(..group(&found.scenario)).unwrap_or_default()).or_default();
            row[2] += 1;
            row[3] += usize::from(found.is_caught());
        }
        let row = |(group, counts): (&str, [usize; 4])| {
            [vec![group.to_owned()], counts.map(|count| count.to_string()).to_vec()].concat()
        };
        let problems = self.problems();
        let mut page = vec![
            heading(1, "Live"),
            text(
                "`cargo assure live`: every scenario of `live/scenarios.toml` on our own actors over a router on \
                 loopback, and again with each defect of `live/defects.toml` planted in them. The verdict on each rule \
                 stands in `reports/lock/live.toml`; traceability counts those that passed.",
            ),
            table(
                &["group", "verdicts", "passed", "planted defects", "caught by their rule"],
                groups.into_iter().map(row),
            ),
        ];
        if !problems.is_empty() {
            page.push(heading(2, "Not as it should be"));
            page.extend(problems.into_iter().map(text));
        }
        page
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn report(verdict: &str, failed: &[&str]) -> Report {
        let (scenario, rule) = ("body/ttl".to_owned(), "NCP-RES-002".to_owned());
        Report {
            rulings: vec![Ruling {
                scenario: scenario.clone(),
                rule: rule.clone(),
                verdict: verdict.into(),
                why: None,
            }],
            defects: vec![Found {
                defect: "ttl-ignored".into(),
                scenario,
                rule,
                failed: failed.iter().map(|rule| (*rule).to_owned()).collect(),
            }],
        }
    }

    #[test]
    fn a_verdict_that_did_not_pass_and_a_defect_that_another_rule_notices_are_problems() {
        assert_eq!(report(PASSED, &["NCP-RES-002"]).problems(), Vec::<String>::new());
        assert_eq!(report("inconclusive", &["NCP-RES-002"]).problems().len(), 1);
        assert_eq!(report(PASSED, &["NCP-RES-001"]).problems().len(), 1);
    }

    #[test]
    fn the_lock_says_of_each_scenario_and_rule_what_was_found() {
        let lock = report(PASSED, &["NCP-RES-002"]).lock(BTreeMap::new());
        assert_eq!(lock.fates["body/ttl NCP-RES-002"], PASSED);
        assert_eq!(lock.counts["defects caught"], 1);
    }
}
