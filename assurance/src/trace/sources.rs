//! Collects from the tree what cites the rules.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use ncp_defects::Defect;
use ncp_proofs::digest::ARTEFACTS as PROOFS;
use ncp_text::citations::{Citation, FunctionRole, RustFile, cited};
use serde::Deserialize;
use walkdir::WalkDir;

use crate::artefact::OF_PROOFS;
use crate::live;
use crate::lock::Lock;

use super::{Evidence, EvidenceKind, Fault, TraceError};

/// Folders of Rust code whose functions carry out rules, and whose tests show them.
const CODE: [&str; 3] = ["spec/kernel/src", "spec/src", "proto/src"];
/// Folders of Rust tests.
const TESTS: [&str; 3] = ["spec/tests", "proto/tests", "peers/zenoh/tests"];
/// The modules in which every public function has to say which rule it serves.
const ACCOUNTABLE: [&str; 5] =
    ["spec/kernel/src/", "spec/src/wire/", "spec/src/safety/", "spec/src/resilience/", "spec/src/bulk/"];
/// The wrappers of the fuzz targets, a file a target, and the functions of the same names that check.
const FUZZ: [&str; 2] = ["fuzz/fuzz_targets", "fuzz/bodies/src"];
/// Implementations that were written from the text alone, and how the names of their files end.
const INDEPENDENT: [(&str, &str); 2] = [("peers/typescript/src", "ts"), ("peers/python-pure/ncp_pure", "py")];
/// The tables of the defects that are planted in the Rust peer.
const DEFECTS: &str = "defects/peer";
/// The page that shows the locks of the proofs.
const PROOFS_PAGE: &str = "reports/proofs.md";
/// The live scenarios, each with the rules that it judges.
const LIVE: &str = "live/scenarios.toml";
/// Prose that names rules.
const PROSE: [&str; 3] = ["README.md", "peers/PROTOCOL.md", "schemas/README.md"];

/// All that the tree says about rules.
#[derive(Debug, Default)]
pub(super) struct Sources {
    /// By rule; each list is sorted.
    evidence: BTreeMap<String, Vec<Evidence>>,
    /// By flag: the cases and live scenarios, and the rules that they cite.
    flags: BTreeMap<String, (usize, BTreeSet<String>)>,
    /// Every citation that is no evidence: the rule, and where it is named.
    mentions: Vec<(String, String)>,
    /// What has to cite a rule and does not.
    pub(super) orphans: Vec<Fault>,
    /// Vector files of the manifest that are not there.
    pub(super) missing_vectors: Vec<String>,
}

impl Sources {
    /// Reads the tree at `root`.
    ///
    /// # Errors
    /// A file that cannot be read, or a vector file that is none.
    pub(super) fn read(root: &Path) -> Result<Self, TraceError> {
        let mut sources = Self::default();
        sources.vectors(root)?;
        for folder in CODE {
            sources.rust(root, folder, false)?;
        }
        for folder in TESTS {
            sources.rust(root, folder, true)?;
        }
        sources.fuzz(root)?;
        sources.independent(root)?;
        sources.mutants(root)?;
        sources.proofs(root)?;
        sources.live(root)?;
        for file in PROSE {
            if root.join(file).is_file() {
                for Citation { id, line } in cited(&text(root, file)?) {
                    sources.mentions.push((id, format!("{file}:{line}")));
                }
            }
        }
        for evidence in sources.evidence.values_mut() {
            evidence.sort();
        }
        Ok(sources)
    }

    /// What cites a rule, sorted.
    pub(super) fn evidence(&self, id: &str) -> Vec<Evidence> {
        self.evidence.get(id).cloned().unwrap_or_default()
    }

    /// Every rule that is cited, with the place.
    pub(super) fn citations(&self) -> impl Iterator<Item = (&str, String)> {
        let evidence = self
            .evidence
            .iter()
            .flat_map(|(id, evidence)| evidence.iter().map(move |one| (id.as_str(), one.shown_place())));
        let mentions = self.mentions.iter();
        evidence.chain(mentions.map(|(id, place)| (id.as_str(), place.clone())))
    }

    /// How many cases are flagged so, and the rules that they cite.
    pub(super) fn flagged(&self, flag: &str) -> (usize, BTreeSet<String>) {
        self.flags.get(flag).cloned().unwrap_or_default()
    }

    fn add(&mut self, id: &str, evidence: Evidence) {
        self.evidence.entry(id.to_owned()).or_default().push(evidence);
    }

    fn vectors(&mut self, root: &Path) -> Result<(), TraceError> {
        for file in vector_files(root)? {
            let content = text(root, &file)?;
            let parsed: VectorFile = serde_json::from_str(&content)
                .map_err(|error| TraceError::Content { path: file.clone(), message: error.to_string() })?;
            let mut cases: BTreeMap<String, usize> = BTreeMap::new();
            for case in parsed.cases {
                if case.requirements.is_empty() {
                    self.orphans.push(Fault::Orphan { what: "the case", place: case.id });
                }
                for flag in case.flags {
                    let (count, rules) = self.flags.entry(flag).or_default();
                    *count += 1;
                    rules.extend(case.requirements.iter().cloned());
                }
                for id in case.requirements {
                    *cases.entry(id).or_default() += 1;
                }
            }
            for (id, count) in cases {
                let evidence = Evidence { kind: EvidenceKind::Vector, place: file.clone(), line: None, count };
                self.add(&id, evidence);
            }
        }
        let manifest = "vectors/MANIFEST.sha256";
        for line in text(root, manifest)?.lines() {
            if let Some((_, file)) = line.split_once("  ")
                && !root.join("vectors").join(file).is_file()
            {
                self.missing_vectors.push(file.to_owned());
            }
        }
        Ok(())
    }

    fn rust(&mut self, root: &Path, folder: &str, only_tests: bool) -> Result<(), TraceError> {
        for file in files(root, folder, "rs")? {
            let RustFile { functions, elsewhere } = RustFile::read(&text(root, &file)?);
            let accountable = ACCOUNTABLE.iter().any(|folder| file.starts_with(folder));
            for function in functions {
                let place = format!("{file} {}", function.name);
                let kind = match function.role {
                    FunctionRole::Code if only_tests => continue,
                    FunctionRole::Code => EvidenceKind::Code,
                    FunctionRole::Test => EvidenceKind::Test,
                    FunctionRole::Property => EvidenceKind::Property,
                };
                if function.cites.is_empty() && !function.within_citing {
                    let what = match function.role {
                        FunctionRole::Property => Some("the property"),
                        FunctionRole::Code if accountable && function.public => Some("the public function"),
                        _ => None,
                    };
                    self.orphans.extend(what.map(|what| Fault::Orphan {
                        what,
                        place: format!("{file}:{} {}", function.line, function.name),
                    }));
                }
                let cites: BTreeSet<String> = function.cites.into_iter().map(|cited| cited.id).collect();
                for id in cites {
                    let evidence = Evidence { kind, place: place.clone(), line: Some(function.line), count: 1 };
                    self.add(&id, evidence);
                }
            }
            if !only_tests {
                self.lines(&file, elsewhere);
            }
        }
        Ok(())
    }

    /// A target shows the rules that the function of its name cites.
    fn fuzz(&mut self, root: &Path) -> Result<(), TraceError> {
        let [wrappers, bodies] = FUZZ;
        if !root.join(wrappers).is_dir() {
            return Ok(());
        }
        let wrappers = files(root, wrappers, "rs")?;
        let names = wrappers.iter().filter_map(|file| Path::new(file).file_stem()?.to_str());
        let mut without: BTreeSet<&str> = names.collect();
        for file in files(root, bodies, "rs")? {
            for function in RustFile::read(&text(root, &file)?).functions {
                let name = function.name.as_str();
                if !function.public || function.cites.is_empty() || !without.remove(name) {
                    continue;
                }
                let cites: BTreeSet<String> = function.cites.iter().map(|cited| cited.id.clone()).collect();
                for id in cites {
                    let evidence = Evidence {
                        kind: EvidenceKind::Fuzz,
                        place: format!("{file} {name}"),
                        line: Some(function.line),
                        count: 1,
                    };
                    self.add(&id, evidence);
                }
            }
        }
        self.orphans
            .extend(without.into_iter().map(|name| Fault::Orphan { what: "the fuzz target", place: name.to_owned() }));
        Ok(())
    }

    fn independent(&mut self, root: &Path) -> Result<(), TraceError> {
        for (folder, extension) in INDEPENDENT {
            for file in files(root, folder, extension)? {
                let content = text(root, &file)?;
                self.lines(&file, cited(&content));
            }
        }
        Ok(())
    }

    /// What an engine has proved, as the locks of the proofs say: a fate is that of an engine and a claim.
    fn proofs(&mut self, root: &Path) -> Result<(), TraceError> {
        let mut proved: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
        for proofs in PROOFS {
            let Lock { fates, rules, .. } =
                Lock::read(root, &format!("{OF_PROOFS}{}", proofs.name))?.unwrap_or_default();
            let claims = fates.iter().filter(|(_, fate)| fate.starts_with("proved"));
            for claim in claims.filter_map(|(id, _)| id.split_once(' ')).map(|(_, claim)| claim) {
                proved.entry(claim.to_owned()).or_default().extend(rules.get(claim).into_iter().flatten().cloned());
            }
        }
        for (claim, rules) in proved {
            for id in rules {
                let place = format!("{PROOFS_PAGE} {claim}");
                self.add(&id, Evidence { kind: EvidenceKind::Proof, place, line: None, count: 1 });
            }
        }
        Ok(())
    }

    fn mutants(&mut self, root: &Path) -> Result<(), TraceError> {
        for file in files(root, DEFECTS, "toml")? {
            let content = text(root, &file)?;
            let defects = ncp_defects::read(&root.join(&file))
                .map_err(|error| TraceError::Content { path: file.clone(), message: error.to_string() })?;
            for Defect { name, rules, .. } in defects {
                let entry = format!("name = \"{name}\"");
                let line = content.lines().position(|line| line == entry);
                let evidence = Evidence {
                    kind: EvidenceKind::Mutant,
                    place: format!("{file} {name}"),
                    line: line.map(|before| before + 1),
                    count: 1,
                };
                for id in rules {
                    self.add(&id, evidence.clone());
                }
            }
        }
        Ok(())
    }

    /// A live scenario shows the rules that it found kept when it was last run.
    fn live(&mut self, root: &Path) -> Result<(), TraceError> {
        if !root.join(LIVE).is_file() {
            return Ok(());
        }
        let content = text(root, LIVE)?;
        let table: LiveTable = toml::from_str(&content)
            .map_err(|error| TraceError::Content { path: LIVE.to_owned(), message: error.to_string() })?;
        let fates = Lock::read(root, live::NAME)?.map_or_else(BTreeMap::new, |lock| lock.fates);
        let is_kept =
            |name: &str, rule: &str| fates.get(&live::fate_of(name, rule)).is_some_and(|fate| fate == live::PASSED);
        for LiveScenario { name, rules, findings } in table.scenario {
            if rules.is_empty() {
                self.orphans.push(Fault::Orphan { what: "the live scenario", place: name.clone() });
            }
            if rules.iter().all(|rule| is_kept(&name, rule)) {
                for finding in findings {
                    let (count, cited) = self.flags.entry(finding).or_default();
                    *count += 1;
                    cited.extend(rules.iter().cloned());
                }
            }
            let entry = format!("name = \"{name}\"");
            let line = content.lines().position(|line| line == entry).map(|before| before + 1);
            let evidence = Evidence { kind: EvidenceKind::Live, place: format!("{LIVE} {name}"), line, count: 1 };
            for id in rules {
                if is_kept(&name, &id) {
                    self.add(&id, evidence.clone());
                } else {
                    self.mentions.push((id, evidence.shown_place()));
                }
            }
        }
        Ok(())
    }

    /// Code that names rules outside of functions: once a file and rule, at the first line.
    fn lines(&mut self, file: &str, citations: Vec<Citation>) {
        let mut first: BTreeMap<String, usize> = BTreeMap::new();
        for Citation { id, line } in citations {
            first.entry(id).or_insert(line);
        }
        for (id, line) in first {
            let evidence = Evidence { kind: EvidenceKind::Code, place: file.to_owned(), line: Some(line), count: 1 };
            self.add(&id, evidence);
        }
    }
}

impl Evidence {
    /// The place with its line, or with the number of cases.
    pub(crate) fn shown_place(&self) -> String {
        let Self { place, line, count, .. } = self;
        match (line, place.split_once(' ')) {
            (Some(line), Some((file, item))) => format!("{file}:{line} {item}"),
            (Some(line), None) => format!("{place}:{line}"),
            (None, Some((file, item))) => format!("{file} {item}"),
            (None, None) if *count == 1 => format!("{place} (1 case)"),
            (None, None) => format!("{place} ({count} cases)"),
        }
    }
}

/// What is read of a vector file.
#[derive(Deserialize)]
struct VectorFile {
    cases: Vec<VectorCase>,
}

#[derive(Deserialize)]
struct VectorCase {
    id: String,
    #[serde(default)]
    requirements: Vec<String>,
    #[serde(default)]
    flags: Vec<String>,
}

/// What is read of the live scenarios.
#[derive(Deserialize)]
struct LiveTable {
    scenario: Vec<LiveScenario>,
}

#[derive(Deserialize)]
struct LiveScenario {
    name: String,
    #[serde(default)]
    rules: Vec<String>,
    #[serde(default)]
    findings: Vec<String>,
}

/// Every `vectors/corpus/<area>/<name>.json`, sorted.
fn vector_files(root: &Path) -> Result<Vec<String>, TraceError> {
    files(root, "vectors/corpus", "json")
}

/// The files of a folder, at any depth, with an extension: their paths within the tree, sorted.
fn files(root: &Path, folder: &str, extension: &str) -> Result<Vec<String>, TraceError> {
    let mut found = Vec::new();
    for entry in WalkDir::new(root.join(folder)) {
        let entry = entry.map_err(|error| TraceError::File {
            path: error.path().map(Path::to_owned).unwrap_or_default(),
            source: error.into(),
        })?;
        let path = entry.path();
        if path.extension().is_some_and(|e| e == extension) {
            let within = path.strip_prefix(root).unwrap_or(path);
            found.push(within.to_string_lossy().replace('\\', "/"));
        }
    }
    found.sort();
    Ok(found)
}

/// The names of the files of a folder with an extension.
pub(super) fn names(folder: &Path, extension: &str) -> Result<Vec<String>, TraceError> {
    let found = files(folder, "", extension)?;
    Ok(found.into_iter().filter(|name| !name.contains('/')).collect())
}

fn text(root: &Path, file: &str) -> Result<String, TraceError> {
    let path: PathBuf = root.join(file);
    std::fs::read_to_string(&path).map_err(|source| TraceError::File { path, source })
}
