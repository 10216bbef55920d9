//! What was measured: the lock, the page, and the whole of it.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;

use ncp_defects::Defect;
use serde::{Deserialize, Serialize};
use xtask::project::Project;

use super::coverage::percent;
use super::engine::Engine;
use super::{CORPUS, FuzzError, Hunt, Run, Target, files, grouped};
use crate::artefact::Artefact;
use crate::document::{Block, heading, table, text};
use crate::{lock, reports};

/// The name under which it is kept.
const NAME: &str = "fuzz";

/// Everything.
#[derive(Debug, Serialize)]
pub(super) struct Report {
    /// The targets as they are, by name.
    targets: BTreeMap<String, Facts>,
    #[serde(flatten)]
    lock: Lock,
}

/// What the sources say of a target.
#[derive(Debug, Default, Serialize)]
struct Facts {
    finds: String,
    /// The rules for which it is evidence.
    rules: BTreeSet<String>,
    /// The committed corpus.
    inputs: usize,
    bytes: u64,
}

/// What git keeps: what was measured. Each command replaces its own part, and what was measured of other sources is
/// dropped.
#[derive(Debug, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Lock {
    /// The digest that each source had.
    #[serde(default)]
    sources: BTreeMap<String, String>,
    fuzzing: Option<Fuzzing>,
    planted: Option<Planted>,
    coverage: Option<Coverage>,
}

/// Fuzzing, for a while.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Fuzzing {
    engine: String,
    /// By name.
    targets: BTreeMap<String, Fuzzed>,
}

#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Fuzzed {
    executions: u64,
    /// Edges of the program's flow that were reached.
    edges: u64,
    seconds: f64,
    found: bool,
}

/// The hunt for planted defects.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Planted {
    engine: String,
    /// By the name of the defect, and by that of the target.
    defects: BTreeMap<String, BTreeMap<String, Hunted>>,
}

#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Hunted {
    by: Option<FoundBy>,
    seconds: f64,
    executions: u64,
}

/// What finds a planted defect.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
enum FoundBy {
    /// A committed input, before anything was mutated.
    Corpus,
    Fuzzing,
}

/// Lines of the decoders that the committed corpora reach.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Coverage {
    pub(super) tool: String,
    pub(super) folders: Vec<Lines>,
    pub(super) files: Vec<Lines>,
}

/// The lines of a file or a folder.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Lines {
    pub(super) place: String,
    /// Lines that have code, and how many of them ran.
    pub(super) count: u64,
    pub(super) covered: u64,
}

impl Report {
    /// What was measured before, with the targets as they are.
    ///
    /// # Errors
    /// The lock is not of the form, or a source cannot be read.
    pub(super) fn read(project: &Project, targets: &[Target]) -> Result<Self, FuzzError> {
        let rules = rules(project);
        let facts = |target: &Target| {
            let inputs = files(&project.path(CORPUS).join(&target.name)).unwrap_or_default();
            let facts = Facts {
                finds: target.finds.clone(),
                rules: rules(&target.name),
                inputs: inputs.len(),
                bytes: inputs.iter().filter_map(|file| Some(file.metadata().ok()?.len())).sum(),
            };
            (target.name.clone(), facts)
        };
        let root = project.path("");
        let sources = Artefact::named(NAME).map(|artefact| artefact.digests(&root)).transpose();
        let sources = sources.map_err(|source| FuzzError::File { path: root.clone(), source })?.unwrap_or_default();
        let before: Option<Lock> = lock::read(&root, NAME)?;
        let lock = before.filter(|before| before.sources == sources).unwrap_or_default();
        Ok(Self { targets: targets.iter().map(facts).collect(), lock: Lock { sources, ..lock } })
    }

    /// Takes note of fuzzing.
    pub(super) fn ran(&mut self, engine: &Engine, runs: &[(&Target, Run)]) {
        let before = self.lock.fuzzing.take();
        let mut targets = before.map(|before| before.targets).unwrap_or_default();
        targets.extend(runs.iter().map(|(target, run)| {
            let Run { executions, edges, .. } = *run;
            let fuzzed = Fuzzed { executions, edges, seconds: tenths(run.seconds), found: run.crash.is_some() };
            (target.name.clone(), fuzzed)
        }));
        self.lock.fuzzing = Some(Fuzzing { engine: engine.to_string(), targets });
    }

    /// Takes note of the hunt for planted defects.
    pub(super) fn hunted(&mut self, engine: &Engine, hunts: &[(&Hunt<'_>, Run)]) {
        let before = self.lock.planted.take();
        let mut defects = before.map(|before| before.defects).unwrap_or_default();
        for (hunt, run) in hunts {
            let by = if run.from_corpus { FoundBy::Corpus } else { FoundBy::Fuzzing };
            let by = run.crash.is_some().then_some(by);
            let hunted = Hunted { by, seconds: tenths(run.seconds), executions: run.executions };
            defects.entry(hunt.defect.name.clone()).or_default().insert(hunt.target.to_owned(), hunted);
        }
        self.lock.planted = Some(Planted { engine: engine.to_string(), defects });
    }

    /// Takes note of the coverage.
    pub(super) fn covered(&mut self, coverage: Coverage) {
        self.lock.coverage = Some(coverage);
    }

    /// Keeps it.
    ///
    /// # Errors
    /// A file cannot be written.
    pub(super) fn write(&self, project: &Project, defects: &[Defect]) -> Result<(), FuzzError> {
        let (path, text) = (lock::path(&project.path(""), NAME), lock::text(NAME, &self.lock)?);
        let made = path.parent().map_or(Ok(()), fs::create_dir_all).and_then(|()| fs::write(&path, text));
        made.map_err(|source| FuzzError::File { path, source })?;
        let (folder, page) = (project.path(reports::PAGES), self.page(defects));
        reports::page(&folder, NAME, &page)?;
        reports::full(&folder, NAME, self, &page)?;
        println!("wrote reports/{NAME}.md");
        Ok(())
    }

    /// What people read.
    fn page(&self, defects: &[Defect]) -> Vec<Block> {
        let mut page = vec![heading(1, "Fuzzing: what was tried, and what it reaches")];
        page.extend(ABOUT.map(text));
        page.push(heading(2, "The last run"));
        page.extend(self.lock.fuzzing.as_ref().map_or_else(not_run, |fuzzing| self.fuzzed(fuzzing)));
        page.extend([heading(2, "Planted defects"), text(ABOUT_PLANTED)]);
        page.extend(self.lock.planted.as_ref().map_or_else(not_run, |planted| hunted(planted, defects)));
        page.push(heading(2, "Lines of the decoders that the corpora reach"));
        page.extend(self.lock.coverage.as_ref().map_or_else(not_run, covered));
        page
    }

    fn fuzzed(&self, Fuzzing { engine, targets }: &Fuzzing) -> Vec<Block> {
        let none = Facts::default();
        let rows = targets.iter().map(|(name, Fuzzed { executions, edges, seconds, found })| {
            let Facts { finds, inputs, bytes, .. } = self.targets.get(name).unwrap_or(&none);
            let corpus = format!("{inputs} inputs, {} bytes", grouped(*bytes));
            let found = if *found { "something" } else { "nothing" };
            let numbers = [grouped(*executions), seconds.to_string(), grouped(*edges)];
            [name.clone(), finds.clone(), corpus].into_iter().chain(numbers).chain([found.to_owned()]).collect()
        });
        let total = grouped(targets.values().map(|run| run.executions).sum());
        vec![
            text(format!("{engine}, libFuzzer.")),
            table(&["target", "would find", "corpus", "executions", "seconds", "edges", "found"], rows),
            text(format!(
                "{total} executions in all. An edge is a step from one basic block to another, in the target and in \
                 all that it calls."
            )),
        ]
    }
}

const ABOUT: [&str; 2] = [
    "Made by `cargo assure fuzz --report`, `--planted --report` and `--coverage --report`, each of which measures \
     one part anew and drops what was measured of other sources; `fuzz/README.md` says how to repeat it. `cargo \
     xtask test` replays every committed input. For which rules a target is evidence stands above its function in \
     `fuzz/bodies/src`, and in `reports/traceability.md`.",
    "Fuzzing looks for what is wrong and proves nothing: that nothing was found is worth as much as the number of \
     executions, the lines reached, and the planted defects that the same targets do find.",
];

const ABOUT_PLANTED: &str = "Each target is pointed at a build with one defect of its class (`defects/fuzz.toml`), and \
                             has two minutes to find it.";

fn not_run() -> Vec<Block> {
    vec![text("Not run here.")]
}

fn hunted(Planted { engine, defects: hunted }: &Planted, defects: &[Defect]) -> Vec<Block> {
    let rows = defects.iter().flat_map(|Defect { name, about, .. }| {
        hunted.get(name).into_iter().flatten().map(move |(target, Hunted { by, seconds, executions })| {
            let found = match by {
                Some(FoundBy::Corpus) => "by the corpus",
                Some(FoundBy::Fuzzing) => "by fuzzing",
                None => "NO",
            };
            vec![target.clone(), about.clone(), found.to_owned(), seconds.to_string(), grouped(*executions)]
        })
    });
    vec![text(format!("{engine}, libFuzzer.")), table(&["target", "defect", "found", "seconds", "executions"], rows)]
}

fn covered(Coverage { tool, folders, files }: &Coverage) -> Vec<Block> {
    let row = |place: String, count: u64, covered: u64| {
        vec![place, count.to_string(), covered.to_string(), format!("{:.1}", percent(count, covered))]
    };
    let folders = folders.iter().map(|Lines { place, count, covered }| row(format!("**{place}**"), *count, *covered));
    let files = files.iter().map(|Lines { place, count, covered }| row(place.clone(), *count, *covered));
    vec![
        text(format!("{tool}. The committed inputs alone, replayed without fuzzing.")),
        table(&["where", "lines with code", "run", "%"], folders.chain(files)),
    ]
}

/// The rules that the comment of a target's function cites.
fn rules(project: &Project) -> impl Fn(&str) -> BTreeSet<String> + use<> {
    let bodies = files(&project.path("fuzz/bodies/src")).unwrap_or_default();
    let texts: Vec<_> = bodies.iter().filter_map(|file| fs::read_to_string(file).ok()).collect();
    move |name| {
        let head = format!("pub fn {name}(input: &[u8])");
        let comment = texts.iter().find_map(|text| {
            let before = text.get(..text.find(&head)?)?.trim_end();
            let start = before.rfind("\n\n").unwrap_or(0);
            before.get(start..)
        });
        let words = comment.unwrap_or_default().split(['[', ']']);
        words.filter(|word| word.starts_with("NCP-")).map(str::to_owned).collect()
    }
}

fn tenths(seconds: f64) -> f64 {
    (seconds * 10.0).round() / 10.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rules_of_a_target_are_those_above_its_function() {
        let folder = tempfile::tempdir().unwrap();
        let bodies = folder.path().join("fuzz/bodies/src");
        fs::create_dir_all(&bodies).unwrap();
        let code = "// [NCP-A-001]\n\n/// Does.\n// [NCP-B-002] [NCP-B-001]\npub fn things(input: &[u8]) {}\n";
        fs::write(bodies.join("x.rs"), code).unwrap();
        let rules = rules(&Project::at(folder.path()));
        assert_eq!(rules("things"), ["NCP-B-001", "NCP-B-002"].map(str::to_owned).into());
        assert!(rules("others").is_empty());
    }

    #[test]
    fn what_was_not_run_is_said_not_to_be() {
        let folder = tempfile::tempdir().unwrap();
        let report = Report::read(&Project::at(folder.path()), &[]).unwrap();
        let page = crate::document::markdown(&report.page(&[]));
        assert_eq!(page.matches("Not run here.").count(), 3);
    }

    #[test]
    fn what_was_measured_is_kept_until_its_sources_change() {
        let folder = tempfile::tempdir().unwrap();
        let project = Project::at(folder.path());
        fs::create_dir_all(project.path("fuzz/bodies/src")).unwrap();
        let hunted = Hunted { by: Some(FoundBy::Corpus), seconds: 0.5, executions: 7 };
        let defects = BTreeMap::from([("it".to_owned(), BTreeMap::from([("keys".to_owned(), hunted)]))]);
        let mut report = Report::read(&project, &[]).unwrap();
        report.lock.planted = Some(Planted { engine: "e".to_owned(), defects });
        report.write(&project, &[]).unwrap();
        let again = Report::read(&project, &[]).unwrap();
        assert_eq!(again.lock.planted.unwrap().defects["it"]["keys"].by, Some(FoundBy::Corpus));
        fs::write(project.path("fuzz/bodies/src/keys.rs"), "").unwrap();
        assert!(Report::read(&project, &[]).unwrap().lock.planted.is_none());
    }
}
