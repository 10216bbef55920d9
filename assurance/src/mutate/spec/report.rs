//! `reports/cargo-mutants.json`, which holds what was tried, and `reports/cargo-mutants.md`, which is made of it.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use super::outcome::{By, Fate, Mutant, Outcome};
use super::{CARGO_MUTANTS, MODULES, Module};
use crate::Error;
use crate::digest::of_files;
use xtask::project::Project;

const JSON: &str = "reports/cargo-mutants.json";
const MARKDOWN: &str = "reports/cargo-mutants.md";
/// By mutant: why no test can notice it.
const EQUIVALENT: &str = "spec/equivalent.toml";
/// The digests of the golden cases.
const MANIFEST: &str = "vectors/MANIFEST.sha256";
/// The columns of numbers: a member of a module, and its heading.
const COUNTS: [(&str, &str); 6] = [
    ("mutants", "mutants"),
    ("unviable", "do not compile"),
    ("caught_by_cases", "caught by the golden cases"),
    ("caught_by_tests", "caught by the tests alone"),
    ("timed_out", "ran too long"),
    ("missed", "missed"),
];

/// What was tried, now and before: a run replaces its module.
pub(super) struct Report(Value);

impl Report {
    /// What was tried before.
    pub(super) fn read(project: &Project) -> Self {
        let before = fs::read(project.path(JSON)).unwrap_or_default();
        let mut report: Value = serde_json::from_slice(&before).unwrap_or_default();
        if !report["modules"].is_object() {
            report = json!({"format": 1, "modules": {}});
        }
        Self(report)
    }

    /// Takes note of a run over a module.
    pub(super) fn ran(&mut self, module: &Module, digests: &Digests, mutants: &[Mutant], outcomes: &[Outcome]) {
        let fates: BTreeMap<&str, Fate> =
            outcomes.iter().map(|outcome| (outcome.name.as_str(), outcome.fate)).collect();
        let keys = |fate: Option<Fate>| -> Vec<&str> {
            mutants
                .iter()
                .filter(|mutant| fates.get(mutant.name.as_str()).copied() == fate)
                .map(|mutant| mutant.key.as_str())
                .collect()
        };
        let count = |fate| keys(Some(fate)).len();
        let runs = || outcomes.iter().map(|outcome| &outcome.run);
        self.0["modules"][module.name] = json!({
            "tool": format!("cargo-mutants {CARGO_MUTANTS}"),
            "sources": digests.sources,
            "cases": digests.cases,
            "started": runs().map(|run| &run[0]).min(),
            "ended": runs().map(|run| &run[1]).max(),
            "mutants": mutants.len(),
            "unviable": count(Fate::Unviable),
            "caught_by_cases": count(Fate::Caught(By::Cases)),
            "caught_by_tests": keys(Some(Fate::Caught(By::Tests))),
            "timed_out": keys(Some(Fate::TimedOut)),
            "missed": keys(Some(Fate::Missed)),
            "not_tried": keys(None),
        });
    }

    /// What is wrong, a line each: a module that was not tried as it is now, a mutant that is missed and not
    /// explained, an explanation of what is not missed.
    ///
    /// # Errors
    /// A file cannot be read.
    pub(super) fn problems(&self, project: &Project) -> Result<Vec<String>, Error> {
        let mut problems = Vec::new();
        let why = equivalent(project)?;
        let mut missed = BTreeSet::new();
        for module in &MODULES {
            let (name, tried) = (module.name, &self.0["modules"][module.name]);
            if !tried.is_object() {
                problems.push(format!("{name}: not tried; cargo xtask mutate-spec"));
                continue;
            }
            if tried["sources"] != Digests::of(project, module)?.sources.as_str() {
                problems.push(format!("{name}: changed since it was tried; cargo xtask mutate-spec --module {name}"));
            }
            problems.extend(texts(&tried["not_tried"]).map(|key| format!("not tried: {key}")));
            missed.extend(texts(&tried["missed"]));
        }
        let unexplained = missed.iter().filter(|key| !why.contains_key(**key));
        problems.extend(unexplained.map(|key| format!("missed, and not explained: {key}")));
        let stale = why.keys().filter(|key| !missed.contains(key.as_str()));
        problems.extend(stale.map(|key| format!("{EQUIVALENT} explains what is not missed: {key}")));
        let page = fs::read_to_string(project.path(MARKDOWN)).unwrap_or_default();
        if problems.is_empty() && page.replace("\r\n", "\n") != self.markdown(&why) {
            problems.push(format!("{MARKDOWN} is not what {JSON} and {EQUIVALENT} say"));
        }
        Ok(problems)
    }

    /// Writes both files.
    ///
    /// # Errors
    /// One cannot be written.
    pub(super) fn write(&self, project: &Project) -> Result<(), Error> {
        let page = self.markdown(&equivalent(project)?);
        for (file, text) in [(JSON, format!("{:#}\n", self.0)), (MARKDOWN, page)] {
            let path = project.path(file);
            fs::write(&path, text).map_err(|source| Error::File { path, source })?;
        }
        Ok(())
    }

    /// All modules in a line.
    pub(super) fn summary(&self) -> String {
        let sum = |member| MODULES.iter().map(|module| self.count(module, member)).sum::<u64>();
        COUNTS.map(|(member, heading)| format!("{} {heading}", sum(member))).join(", ")
    }

    /// A number of a module, or how many a list of it has.
    fn count(&self, module: &Module, member: &str) -> u64 {
        let value = &self.0["modules"][module.name][member];
        let listed = || value.as_array().map(|list| list.len() as u64);
        value.as_u64().or_else(listed).unwrap_or_default()
    }

    fn markdown(&self, why: &BTreeMap<String, String>) -> String {
        let mut page = HEAD.to_owned();
        page.push_str("| module | tried with | began | ended |");
        for (_, heading) in COUNTS {
            let _ = write!(page, " {heading} |");
        }
        page.push_str("\n|---|---|---|---|---|---|---|---|---|---|\n");
        for module in &MODULES {
            let tried = &self.0["modules"][module.name];
            let text = |member: &str| tried[member].as_str().unwrap_or("not tried");
            let _ = write!(
                page,
                "| {} (`{}`) | {} | {} | {} |",
                module.name,
                module.files,
                text("tool"),
                text("started"),
                text("ended")
            );
            for (member, _) in COUNTS {
                let _ = write!(page, " {} |", self.count(module, member));
            }
            page.push('\n');
        }
        let _ = writeln!(page, "\nIn all: {}.", self.summary());
        let lists = [
            ("missed", "Missed", "Of each is said why it cannot be noticed."),
            (
                "caught_by_tests",
                "Caught by the tests alone",
                "What no golden case shows: no call of the peer protocol asks for it, or only proptest's values reach it.",
            ),
            ("timed_out", "Ran too long", "They count as noticed: a test that does not end is a test that fails."),
            ("not_tried", "Not tried", "The run was broken off."),
        ];
        for (member, heading, about) in lists {
            let tried = MODULES.iter().map(|module| &self.0["modules"][module.name]);
            let keys: Vec<&str> = tried.flat_map(|tried| texts(&tried[member])).collect();
            if keys.is_empty() {
                continue;
            }
            let _ = writeln!(page, "\n## {heading}\n\n{about}\n");
            for key in keys {
                let _ = match why.get(key) {
                    _ if member != "missed" => writeln!(page, "- `{key}`"),
                    Some(why) => writeln!(page, "- `{key}`: {why}"),
                    None => writeln!(page, "- `{key}`: **not explained**"),
                };
            }
        }
        page
    }
}

const HEAD: &str = "\
# Mutants of the specification

Made by `cargo xtask mutate-spec`, which has cargo-mutants change the specification in one place after the other, and asks \
whether that is noticed. A mutant is first held against the golden cases that can reach its module, by a verifier that was built without the \
mutation. What they miss is held against the unit tests of `ncp-spec` and those of its test programs that are about the module. \
`.cargo/mutants.toml` is the configuration; `xtask/src/mutate_spec/mod.rs` names the modules, their cases and their tests; `spec/equivalent.toml` says why a mutant that is missed is none.

`cargo xtask mutate-spec --check` says whether the sources are still those that were tried. `reports/mutants.md` is about \
something else: peers with one defect each, chosen by hand, and the rule that each breaks.

";

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
    pub(super) fn of(project: &Project, module: &Module) -> Result<Self, Error> {
        let root = project.path("");
        let of = |path: &str| digest(&root, path).map_err(|source| Error::File { path: root.join(path), source });
        Ok(Self { sources: of(module.files)?, cases: of(MANIFEST)? })
    }
}

/// The digest of the files that a pattern of a module means.
fn digest(root: &Path, pattern: &str) -> io::Result<String> {
    let mut files = Vec::new();
    if let Some(folder) = pattern.strip_suffix("/**/*.rs") {
        collect(&root.join(folder), true, &mut files)?;
    } else if let Some(folder) = pattern.strip_suffix("/*.rs") {
        collect(&root.join(folder), false, &mut files)?;
    } else {
        files.push(root.join(pattern));
    }
    of_files(root, files)
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
fn equivalent(project: &Project) -> Result<BTreeMap<String, String>, Error> {
    let path = project.path(EQUIVALENT);
    let failed = |source| Error::File { path: path.clone(), source };
    let text = fs::read_to_string(&path).map_err(failed)?;
    toml::from_str(&text).map_err(|error| failed(io::Error::other(error.to_string())))
}

/// The texts of a list.
fn texts(list: &Value) -> impl Iterator<Item = &str> {
    list.as_array().into_iter().flatten().filter_map(Value::as_str)
}

#[cfg(test)]
mod tests {
    use super::*;

    const WITH_LINE: &str = "spec/src/codec.rs:1:1: x";
    const KEY: &str = "spec/src/codec.rs: x";

    /// A project whose files are empty, and a report that every module was tried with nothing missed.
    fn tried() -> (tempfile::TempDir, Project, Report) {
        let folder = tempfile::tempdir().unwrap();
        let root = folder.path();
        for path in [
            "spec/src/safety/kernel",
            "spec/src/resilience",
            "spec/src/bulk",
            "spec/src/wire/json",
            "reports",
            "vectors",
        ] {
            fs::create_dir_all(root.join(path)).unwrap();
        }
        for file in [EQUIVALENT, MANIFEST, "spec/src/codec.rs", "spec/kernel/src/decisions/speed.rs"] {
            fs::write(root.join(file), "").unwrap();
        }
        let project = Project::at(root);
        let mut report = Report::read(&project);
        for module in &MODULES {
            report.ran(module, &Digests::of(&project, module).unwrap(), &[], &[]);
        }
        (folder, project, report)
    }

    fn problems(project: &Project, report: &Report) -> String {
        report.write(project).unwrap();
        Report::read(project).problems(project).unwrap().join("\n")
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
        assert!(fs::read_to_string(project.path(MARKDOWN)).unwrap().contains("x`: Both are 0."));
        for fate in [Fate::Caught(By::Cases), Fate::TimedOut, Fate::Unviable] {
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
        report.0["modules"]["codec"] = Value::Null;
        assert!(problems(&project, &report).starts_with("codec: not tried"));
    }

    #[test]
    fn a_change_makes_the_report_of_its_module_stale() {
        let (_folder, project, report) = tried();
        report.write(&project).unwrap();
        fs::write(project.path("spec/kernel/src/decisions/speed.rs"), "a.lt(b)").unwrap();
        let found = problems(&project, &report);
        assert!(found.starts_with("safety: changed") && found.lines().count() == 1, "{found}");
    }

    #[test]
    fn a_page_that_was_changed_by_hand_is_noticed() {
        let (_folder, project, report) = tried();
        report.write(&project).unwrap();
        fs::write(project.path(MARKDOWN), "all is well").unwrap();
        let found = Report::read(&project).problems(&project).unwrap();
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(found[0].starts_with(MARKDOWN));
    }
}
