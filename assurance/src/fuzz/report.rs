//! `reports/fuzz.json`, which holds what was measured, and `reports/fuzz.md`, which is made of it.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;

use serde_json::{Map, Value, json};

use super::coverage::percent;
use super::engine::{Engine, Run};
use super::{CORPUS, Target, files, grouped};
use crate::Error;
use xtask::project::Project;

const JSON: &str = "reports/fuzz.json";
const MARKDOWN: &str = "reports/fuzz.md";

/// What was measured, now and before: each command replaces its own part.
pub(super) struct Report(Value);

impl Report {
    /// What was measured before, with the targets as they are.
    pub(super) fn read(project: &Project, targets: &[Target]) -> Self {
        let before = fs::read(project.path(JSON)).unwrap_or_default();
        let mut report: Value = serde_json::from_slice(&before).unwrap_or_default();
        if !report["targets"].is_object() {
            report = json!({"format": 1, "targets": {}, "fuzzing": null, "planted": null, "coverage": null});
        }
        let (rules, sizes) = (rules(project), sizes(project));
        for target in targets {
            let entry = &mut report["targets"][target.name.as_str()];
            entry["finds"] = target.finds.as_str().into();
            entry["rules"] = rules(&target.name).into();
            let (count, bytes) = sizes(&target.name);
            entry["corpus"] = json!({"inputs": count, "bytes": bytes});
        }
        Self(report)
    }

    /// Takes note of fuzzing.
    pub(super) fn ran(&mut self, engine: &Engine, targets: &[Target], runs: &[Run]) {
        self.0["fuzzing"] = json!({"engine": engine.to_string()});
        for (target, run) in targets.iter().zip(runs) {
            self.0["targets"][target.name.as_str()]["run"] = json!({
                "executions": run.executions,
                "edges": run.edges,
                "seconds": tenths(run.seconds),
                "found": run.crash.is_some(),
            });
        }
    }

    /// Takes note of the hunt for planted bugs.
    pub(super) fn hunted(&mut self, engine: &Engine, targets: &[Target], runs: &[Run]) {
        self.0["planted"] = json!({"engine": engine.to_string()});
        for (target, run) in targets.iter().zip(runs) {
            self.0["targets"][target.name.as_str()]["planted"] = json!({
                "bug": target.planted,
                "found": run.crash.is_some(),
                "by_the_corpus": run.from_corpus,
                "seconds": tenths(run.seconds),
                "executions": run.executions,
            });
        }
    }

    /// Takes note of the coverage.
    pub(super) fn covered(&mut self, coverage: Value) {
        self.0["coverage"] = coverage;
    }

    /// Writes both files.
    ///
    /// # Errors
    /// One cannot be written.
    pub(super) fn write(&self, project: &Project) -> Result<(), Error> {
        let texts = [(JSON, format!("{:#}\n", self.0)), (MARKDOWN, self.markdown())];
        for (file, text) in texts {
            let path = project.path(file);
            fs::write(&path, text).map_err(|source| Error::File { path, source })?;
            println!("wrote {file}");
        }
        Ok(())
    }

    fn markdown(&self) -> String {
        let mut page = HEAD.to_owned();
        let targets = self.0["targets"].as_object().cloned().unwrap_or_default();
        fuzzing(&mut page, &self.0["fuzzing"], &targets);
        planted(&mut page, &self.0["planted"], &targets);
        coverage(&mut page, &self.0["coverage"]);
        rules_of(&mut page, &targets);
        page
    }
}

const HEAD: &str = "\
# Fuzzing: what was tried, and what it reaches

Made by `cargo xtask fuzz --report`, `--planted --report` and `--coverage --report`, each of which measures one part anew; \
`fuzz/README.md` says how to repeat it. `cargo xtask test` replays every committed input.

Fuzzing looks for what is wrong and proves nothing: that nothing was found is worth as much as the number of executions, the \
lines reached, and the planted bugs that the same targets do find.

";

fn fuzzing(page: &mut String, run: &Value, targets: &Map<String, Value>) {
    page.push_str("## The last run\n\n");
    let Some(engine) = run["engine"].as_str() else {
        page.push_str("Not run here.\n\n");
        return;
    };
    let _ = writeln!(page, "{engine}, libFuzzer.\n");
    page.push_str(
        "| target | would find | corpus | executions | seconds | edges | found |\n|---|---|---|---|---|---|---|\n",
    );
    let mut total = 0;
    for (name, target) in targets {
        let (run, corpus) = (&target["run"], &target["corpus"]);
        total += number(&run["executions"]);
        let _ = writeln!(
            page,
            "| {name} | {} | {} inputs, {} bytes | {} | {} | {} | {} |",
            text(&target["finds"]),
            number(&corpus["inputs"]),
            grouped(number(&corpus["bytes"])),
            grouped(number(&run["executions"])),
            run["seconds"],
            grouped(number(&run["edges"])),
            if run["found"] == true { "something" } else { "nothing" },
        );
    }
    let _ = writeln!(
        page,
        "\n{} executions in all. An edge is a step from one basic block to another, in the target and in all that it calls.\n",
        grouped(total)
    );
}

fn planted(page: &mut String, hunt: &Value, targets: &Map<String, Value>) {
    page.push_str("## Planted bugs\n\nEach target is pointed at a build with one bug of its class (`fuzz/bodies/src/planted.rs`), and has two minutes to find it.\n\n");
    let Some(engine) = hunt["engine"].as_str() else {
        page.push_str("Not run here.\n\n");
        return;
    };
    let _ = writeln!(page, "{engine}, libFuzzer.\n");
    page.push_str("| target | bug | found | seconds | executions |\n|---|---|---|---|---|\n");
    for (name, target) in targets {
        let planted = &target["planted"];
        let found = match (&planted["found"], &planted["by_the_corpus"]) {
            (Value::Bool(true), Value::Bool(true)) => "by the corpus",
            (Value::Bool(true), _) => "by fuzzing",
            _ => "NO",
        };
        let _ = writeln!(
            page,
            "| {name} | {} | {found} | {} | {} |",
            text(&planted["bug"]),
            planted["seconds"],
            grouped(number(&planted["executions"])),
        );
    }
    page.push('\n');
}

fn coverage(page: &mut String, coverage: &Value) {
    page.push_str("## Lines of the decoders that the corpora reach\n\n");
    let Some(tool) = coverage["tool"].as_str() else {
        page.push_str("Not measured here.\n\n");
        return;
    };
    let _ = writeln!(page, "{tool}. The committed inputs alone, replayed without fuzzing.\n");
    page.push_str("| where | lines with code | run | % |\n|---|---|---|---|\n");
    let parts = [("folders", "folder"), ("files", "file")];
    for (list, name) in parts {
        for part in coverage[list].as_array().into_iter().flatten() {
            let (count, covered) = (number(&part["lines"]), number(&part["covered"]));
            let place = text(&part[name]);
            let place = if list == "folders" { format!("**{place}**") } else { place.to_owned() };
            let _ = writeln!(page, "| {place} | {count} | {covered} | {:.1} |", percent(count, covered));
        }
    }
    page.push('\n');
}

fn rules_of(page: &mut String, targets: &Map<String, Value>) {
    page.push_str("## For which rules each target is evidence\n\n");
    for (name, target) in targets {
        let rules = target["rules"].as_array().into_iter().flatten().map(text);
        let _ = writeln!(page, "- **{name}**: {}", rules.collect::<Vec<_>>().join(", "));
    }
}

/// The rules that the comment of a target's function cites.
fn rules(project: &Project) -> impl Fn(&str) -> Vec<String> + use<> {
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
        let rules: BTreeSet<_> = words.filter(|word| word.starts_with("NCP-")).collect();
        rules.into_iter().map(str::to_owned).collect()
    }
}

/// How many inputs a corpus has, and how many bytes.
fn sizes(project: &Project) -> impl Fn(&str) -> (usize, u64) + use<> {
    let corpora: PathBuf = project.path(CORPUS);
    move |name| {
        let inputs = files(&corpora.join(name)).unwrap_or_default();
        let bytes = inputs.iter().filter_map(|file| Some(file.metadata().ok()?.len())).sum();
        (inputs.len(), bytes)
    }
}

fn text(value: &Value) -> &str {
    value.as_str().unwrap_or_default()
}

fn number(value: &Value) -> u64 {
    value.as_u64().unwrap_or_default()
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
        assert_eq!(rules("things"), ["NCP-B-001", "NCP-B-002"]);
        assert!(rules("others").is_empty());
    }

    #[test]
    fn what_was_not_run_is_said_not_to_be() {
        let folder = tempfile::tempdir().unwrap();
        let page = Report::read(&Project::at(folder.path()), &[]).markdown();
        assert_eq!(page.matches("Not run here.").count(), 2);
        assert!(page.contains("Not measured here."));
    }
}
