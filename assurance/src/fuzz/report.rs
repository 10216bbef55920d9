//! What was measured: the lock, the page, and the whole of it.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::fs;

use ncp_defects::Defect;
use serde::{Deserialize, Serialize};
use xtask::project::Project;

use super::coverage::percent;
use super::engine::Engine;
use super::{CORPUS, FuzzError, Hunt, Run, Target, files, grouped};
use crate::digest;
use crate::kept;

/// The name under which it is kept.
const NAME: &str = "fuzz";
/// What a measurement is about: what is attacked, and what attacks it.
pub(crate) const SOURCES: [&str; 8] = [
    "spec/src",
    "spec/kernel/src",
    "proto/src",
    "verifier/src/json.rs",
    "verifier/src/peer",
    "fuzz/bodies/src",
    "fuzz/fuzz_targets",
    super::DEFECTS,
];

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

/// What stands in git: what was measured, now and before. Each command replaces its own part.
#[derive(Debug, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Lock {
    fuzzing: Option<Fuzzing>,
    planted: Option<Planted>,
    coverage: Option<Coverage>,
}

/// Fuzzing, for a while.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Fuzzing {
    /// Of the [`SOURCES`], as in the other parts.
    digest: String,
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
    digest: String,
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
    pub(super) digest: String,
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
    /// The lock is not of the form.
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
        Ok(Self { targets: targets.iter().map(facts).collect(), lock: kept::read(project, NAME)?.unwrap_or_default() })
    }

    /// Takes note of fuzzing.
    ///
    /// # Errors
    /// A source cannot be read.
    pub(super) fn ran(&mut self, project: &Project, engine: &Engine, runs: &[(&Target, Run)]) -> Result<(), FuzzError> {
        let digest = digest_of(project)?;
        let before = self.lock.fuzzing.take().filter(|before| before.digest == digest);
        let mut targets = before.map(|before| before.targets).unwrap_or_default();
        targets.extend(runs.iter().map(|(target, run)| {
            let fuzzed = Fuzzed {
                executions: run.executions,
                edges: run.edges,
                seconds: tenths(run.seconds),
                found: run.crash.is_some(),
            };
            (target.name.clone(), fuzzed)
        }));
        self.lock.fuzzing = Some(Fuzzing { digest, engine: engine.to_string(), targets });
        Ok(())
    }

    /// Takes note of the hunt for planted defects.
    ///
    /// # Errors
    /// A source cannot be read.
    pub(super) fn hunted(
        &mut self,
        project: &Project,
        engine: &Engine,
        hunts: &[(&Hunt<'_>, Run)],
    ) -> Result<(), FuzzError> {
        let digest = digest_of(project)?;
        let before = self.lock.planted.take().filter(|before| before.digest == digest);
        let mut defects = before.map(|before| before.defects).unwrap_or_default();
        for (hunt, run) in hunts {
            let by = if run.from_corpus { FoundBy::Corpus } else { FoundBy::Fuzzing };
            let by = run.crash.is_some().then_some(by);
            let hunted = Hunted { by, seconds: tenths(run.seconds), executions: run.executions };
            defects.entry(hunt.defect.name.clone()).or_default().insert(hunt.target.to_owned(), hunted);
        }
        self.lock.planted = Some(Planted { digest, engine: engine.to_string(), defects });
        Ok(())
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
        kept::write(project, NAME, &self.lock, &page(self, defects), self)?;
        println!("wrote {}", kept::page_file(NAME));
        Ok(())
    }
}

/// What people read.
fn page(report: &Report, defects: &[Defect]) -> String {
    let mut page = HEAD.to_owned();
    fuzzing(&mut page, report);
    planted(&mut page, report.lock.planted.as_ref(), defects);
    coverage(&mut page, report.lock.coverage.as_ref());
    page
}

const HEAD: &str = "\
# Fuzzing: what was tried, and what it reaches

Made by `cargo assure fuzz --report`, `--planted --report` and `--coverage --report`, each of which measures one part \
anew; `fuzz/README.md` says how to repeat it. `cargo xtask test` replays every committed input. For which rules a \
target is evidence stands above its function in `fuzz/bodies/src`, and in `reports/traceability.md`.

Fuzzing looks for what is wrong and proves nothing: that nothing was found is worth as much as the number of \
executions, the lines reached, and the planted defects that the same targets do find.

";

fn fuzzing(page: &mut String, report: &Report) {
    page.push_str("## The last run\n\n");
    let Some(Fuzzing { engine, targets, .. }) = &report.lock.fuzzing else {
        page.push_str("Not run here.\n\n");
        return;
    };
    let _ = write!(
        page,
        "{engine}, libFuzzer.\n\n| target | would find | corpus | executions | seconds | edges | found |\n\
         |---|---|---|---|---|---|---|\n"
    );
    for (name, run) in targets {
        let none = Facts::default();
        let Facts { finds, inputs, bytes, .. } = report.targets.get(name).unwrap_or(&none);
        let _ = writeln!(
            page,
            "| {name} | {finds} | {inputs} inputs, {} bytes | {} | {} | {} | {} |",
            grouped(*bytes),
            grouped(run.executions),
            run.seconds,
            grouped(run.edges),
            if run.found { "something" } else { "nothing" },
        );
    }
    let total = grouped(targets.values().map(|run| run.executions).sum());
    let _ = writeln!(
        page,
        "\n{total} executions in all. An edge is a step from one basic block to another, in the target and in all that \
         it calls.\n"
    );
}

fn planted(page: &mut String, planted: Option<&Planted>, defects: &[Defect]) {
    let _ = writeln!(
        page,
        "## Planted defects\n\nEach target is pointed at a build with one defect of its class (`{}`), and has two \
         minutes to find it.\n",
        super::DEFECTS
    );
    let Some(Planted { engine, defects: hunted, .. }) = planted else {
        page.push_str("Not run here.\n\n");
        return;
    };
    let _ = write!(
        page,
        "{engine}, libFuzzer.\n\n| target | defect | found | seconds | executions |\n|---|---|---|---|---|\n"
    );
    for Defect { name, about, .. } in defects {
        for (target, Hunted { by, seconds, executions }) in hunted.get(name).into_iter().flatten() {
            let found = match by {
                Some(FoundBy::Corpus) => "by the corpus",
                Some(FoundBy::Fuzzing) => "by fuzzing",
                None => "NO",
            };
            let _ = writeln!(page, "| {target} | {about} | {found} | {seconds} | {} |", grouped(*executions));
        }
    }
    page.push('\n');
}

fn coverage(page: &mut String, coverage: Option<&Coverage>) {
    page.push_str("## Lines of the decoders that the corpora reach\n\n");
    let Some(Coverage { tool, folders, files, .. }) = coverage else {
        page.push_str("Not measured here.\n");
        return;
    };
    let _ = write!(
        page,
        "{tool}. The committed inputs alone, replayed without fuzzing.\n\n\
         | where | lines with code | run | % |\n|---|---|---|---|\n"
    );
    let mut row = |place: &str, count, covered| {
        let _ = writeln!(page, "| {place} | {count} | {covered} | {:.1} |", percent(count, covered));
    };
    for Lines { place, count, covered } in folders {
        row(&format!("**{place}**"), *count, *covered);
    }
    for Lines { place, count, covered } in files {
        row(place, *count, *covered);
    }
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

/// The digest of the [`SOURCES`].
pub(super) fn digest_of(project: &Project) -> Result<String, FuzzError> {
    let root = project.path("");
    digest::of_sources(&root, &SOURCES).map_err(|source| FuzzError::File { path: root, source })
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
        let page = page(&report, &[]);
        assert_eq!(page.matches("Not run here.").count(), 2);
        assert!(page.contains("Not measured here."));
    }

    #[test]
    fn a_lock_is_read_as_it_was_written() {
        let folder = tempfile::tempdir().unwrap();
        let project = Project::at(folder.path());
        let hunted = Hunted { by: Some(FoundBy::Corpus), seconds: 0.5, executions: 7 };
        let defects = BTreeMap::from([("it".to_owned(), BTreeMap::from([("keys".to_owned(), hunted)]))]);
        let planted = Some(Planted { digest: "d".to_owned(), engine: "e".to_owned(), defects });
        let mut report = Report::read(&project, &[]).unwrap();
        report.lock = Lock { fuzzing: None, planted, coverage: None };
        report.write(&project, &[]).unwrap();
        let again = Report::read(&project, &[]).unwrap();
        assert_eq!(again.lock.planted.unwrap().defects["it"]["keys"].by, Some(FoundBy::Corpus));
        assert!(again.lock.fuzzing.is_none());
    }
}
