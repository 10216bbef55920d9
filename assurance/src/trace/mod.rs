//! Traceability: from every rule to what shows it, and back.
//!
//! [`Trace::read`] reads the source tree itself, text, corpus, code and tests, and says what is
//! wrong with it:
//!
//! - forward: a binding rule that nothing shows, unless `spec/exclusions.toml` says why;
//! - backward: a case, a property, or a public function of the safety-relevant modules that cites
//!   no rule, and a citation of a rule that the text does not have;
//! - in time: evidence that is gone, or whose rule reads differently, since a person last accepted
//!   it. `reports/lock/trace.toml` holds what was accepted.
//!
//! Code that names a rule says where the rule is carried out. That is shown, but is no evidence: only
//! what can fail is. A mutant is counted and is no evidence either: it shows that the vectors of its
//! rule bite, not that the rule holds. So neither is in the lock, which stays short enough to be read.
//!
//! - `sources`: collects citations from the tree.
//! - `lock`: what was accepted.
//! - `report`: the matrix as a model and as documents.
//! - `command`: the command line.

pub(crate) mod command;
mod lock;
mod report;
mod sources;

use std::collections::{BTreeMap, BTreeSet};
use std::io;
use std::path::{Path, PathBuf};

use ncp_text::catalogue::{Catalogue, CatalogueError, Requirement};
use ncp_text::{CHAPTERS, Chapter};

use ncp_text::exclusions::{Exclusions, ExclusionsError, Lack};

use crate::lock::LockError;
use lock::Accepted;
use sources::Sources;

/// What shows, or carries out, a rule.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Evidence {
    /// What it is.
    pub(crate) kind: EvidenceKind,
    /// Where it is: a file of the tree, and a function or an item of it where there is one.
    pub(crate) place: String,
    /// The line, from 1, where there is one.
    pub(crate) line: Option<usize>,
    /// How many cases, if it is a vector file; else 1.
    pub(crate) count: usize,
}

/// A kind of evidence.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum EvidenceKind {
    /// A function of the executable specification that carries the rule out.
    Code,
    /// Golden vectors, to which every peer is held.
    Vector,
    /// A test over chosen input.
    Test,
    /// A test over random input.
    Property,
    /// A fuzz target.
    Fuzz,
    /// A property that an engine proves of the safety kernel, or a model checker of the protocol.
    Proof,
    /// A scenario between running programs.
    Live,
    /// A peer with this one planted defect, which the corpus finds.
    Mutant,
}

impl EvidenceKind {
    /// All kinds.
    pub(crate) const ALL: [Self; 8] =
        [Self::Code, Self::Vector, Self::Test, Self::Property, Self::Fuzz, Self::Proof, Self::Live, Self::Mutant];

    /// As the report names it.
    pub(crate) const fn as_str(self) -> &'static str {
        match self {
            Self::Code => "code",
            Self::Vector => "vectors",
            Self::Test => "tests",
            Self::Property => "properties",
            Self::Fuzz => "fuzz",
            Self::Proof => "proofs",
            Self::Live => "live",
            Self::Mutant => "mutants",
        }
    }

    /// Whether it can fail when the rule is broken, and so shows something.
    pub(crate) const fn shows(self) -> bool {
        !matches!(self, Self::Code | Self::Mutant)
    }
}

/// The matrix of rules and evidence, and its faults.
#[derive(Debug)]
pub(crate) struct Trace {
    root: PathBuf,
    rules: Vec<Rule>,
    findings: Vec<Finding>,
    faults: Vec<Fault>,
}

/// A rule with what shows it.
#[derive(Debug)]
pub(crate) struct Rule {
    /// The rule.
    pub(crate) requirement: Requirement,
    /// Its evidence, sorted.
    pub(crate) evidence: Vec<Evidence>,
    /// Why nothing shows it, if that is accepted.
    pub(crate) exclusion: Option<String>,
}

/// An audited finding, `L01` to `L35`.
#[derive(Debug)]
pub(crate) struct Finding {
    /// Its id.
    pub(crate) id: String,
    /// The cases and live scenarios that are flagged with it.
    pub(crate) cases: usize,
    /// The rules that those cases cite; of one without any, the rules that answer it.
    pub(crate) rules: BTreeSet<String>,
    /// Why nothing can show it, if that is so.
    pub(crate) exclusion: Option<String>,
}

/// Something that is wrong with the matrix.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub(crate) enum Fault {
    /// A chapter that the catalogue does not list.
    #[error("spec/text/{0} is no chapter of the catalogue: its rules count nowhere")]
    UnlistedChapter(String),
    /// An id that the text does not have.
    #[error("{id} is not in the text; orphaned are {}", list(places))]
    UnknownRule {
        /// The id.
        id: String,
        /// What cites it.
        places: Vec<String>,
    },
    /// Something that has to cite a rule and does not.
    #[error("{what} {place} cites no rule")]
    Orphan {
        /// What it is: a case, a property, a public function.
        what: &'static str,
        /// Where it is.
        place: String,
    },
    /// A binding rule that nothing shows.
    #[error("{id} is binding, and nothing shows it: {sentence}")]
    NoEvidence {
        /// The rule.
        id: String,
        /// Its sentence.
        sentence: String,
    },
    /// An exclusion that is of no use.
    #[error("spec/exclusions.toml names {id}, {why}")]
    UselessExclusion {
        /// The rule or the finding.
        id: String,
        /// Why it is of no use.
        why: &'static str,
    },
    /// A finding that no case and no live scenario is flagged with.
    #[error("no case and no live scenario is flagged with the finding {0}")]
    FindingWithoutCase(String),
    /// A vector file of the manifest is not there.
    #[error("vectors/{file} is in the manifest and is gone; orphaned is its evidence for {}", list(rules))]
    VectorFileGone {
        /// The file, within `vectors/`.
        file: String,
        /// The rules for which it was evidence.
        rules: Vec<String>,
    },
    /// A rule was accepted and is not in the text any more.
    #[error("{id} is gone from the text; orphaned is {}", list(evidence))]
    RuleGone {
        /// The rule.
        id: String,
        /// What showed it.
        evidence: Vec<String>,
    },
    /// Evidence was accepted and is not there any more.
    #[error("{id} has lost {}", list(evidence))]
    EvidenceGone {
        /// The rule.
        id: String,
        /// What showed it.
        evidence: Vec<String>,
    },
    /// The sentence changed since its evidence was accepted.
    #[error(
        "the sentence of {id} changed (digest {was}, now {now}) since its evidence was accepted: {}",
        list(evidence)
    )]
    SentenceChanged {
        /// The rule.
        id: String,
        /// The accepted digest.
        was: String,
        /// The digest of the sentence as it is.
        now: String,
        /// What cites it.
        evidence: Vec<String>,
    },
}

impl Fault {
    /// Whether a person may accept it, having looked: what changed since the last time.
    pub(crate) const fn can_be_accepted(&self) -> bool {
        matches!(self, Self::RuleGone { .. } | Self::EvidenceGone { .. } | Self::SentenceChanged { .. })
    }
}

/// Why the tree cannot be read.
#[derive(Debug, thiserror::Error)]
pub(crate) enum TraceError {
    /// A file or a folder.
    #[error("{}: {source}", path.display())]
    File {
        /// Which.
        path: PathBuf,
        /// What the operating system said.
        source: io::Error,
    },
    /// The text is faulty.
    #[error("spec/text/{0}")]
    Text(#[from] CatalogueError),
    /// The list of exclusions is faulty.
    #[error("spec/exclusions.toml: {0}")]
    Exclusions(#[from] ExclusionsError),
    /// A lock.
    #[error(transparent)]
    Lock(#[from] LockError),
    /// A vector file, the lock, the exclusions or a report that evidence is read from.
    #[error("{path}: {message}")]
    Content {
        /// The file within the tree.
        path: String,
        /// What is wrong.
        message: String,
    },
}

impl Trace {
    /// Reads the tree at `root`.
    ///
    /// # Errors
    /// [`TraceError`] when something cannot be read. What can be read and is wrong is a [`Fault`].
    pub(crate) fn read(root: &Path) -> Result<Self, TraceError> {
        let (catalogue, unlisted) = catalogue(root)?;
        let sources = Sources::read(root)?;
        let exclusions = exclusions(root)?;
        let reasons: BTreeMap<&str, &str> = exclusions.without(Lack::Evidence).collect();
        let mut faults: Vec<Fault> = unlisted.into_iter().map(Fault::UnlistedChapter).collect();
        faults.extend(unknown(&catalogue, &sources));
        faults.extend(sources.orphans.iter().cloned());

        let rules: Vec<Rule> = catalogue
            .iter()
            .map(|requirement| Rule {
                evidence: sources.evidence(&requirement.id),
                exclusion: reasons.get(requirement.id.as_str()).map(|why| (*why).to_owned()),
                requirement: requirement.clone(),
            })
            .collect();
        let findings = findings(&sources, &exclusions);
        let mut trace = Self { root: root.to_owned(), rules, findings, faults };
        trace.forward(&exclusions);
        trace.in_time(&Accepted::read(root)?, &sources);
        Ok(trace)
    }

    /// Every rule, in the order of the text.
    pub(crate) fn rules(&self) -> &[Rule] {
        &self.rules
    }

    /// Every audited finding.
    pub(crate) fn findings(&self) -> &[Finding] {
        &self.findings
    }

    /// What is wrong.
    pub(crate) fn faults(&self) -> &[Fault] {
        &self.faults
    }

    /// Takes the evidence as it is for accepted: writes `reports/lock/trace.toml`.
    ///
    /// # Errors
    /// [`TraceError::File`] when it cannot be written.
    pub(crate) fn accept(&self) -> Result<(), TraceError> {
        let path = crate::lock::path(&self.root, Accepted::NAME);
        std::fs::write(&path, self.lock()?).map_err(|source| TraceError::File { path, source })
    }

    /// What [`accept`](Self::accept) writes.
    ///
    /// # Errors
    /// What the lock cannot hold.
    pub(crate) fn lock(&self) -> Result<String, TraceError> {
        Ok(Accepted::of(&self.rules).text()?)
    }

    fn forward(&mut self, exclusions: &Exclusions) {
        for rule in &self.rules {
            let shown = rule.evidence.iter().any(|evidence| evidence.kind.shows());
            let id = rule.requirement.id.clone();
            match (&rule.exclusion, shown) {
                (None, false) if rule.requirement.keyword.is_binding() => {
                    let sentence = rule.requirement.sentence.clone();
                    self.faults.push(Fault::NoEvidence { id, sentence });
                }
                (Some(_), true) => self.faults.push(Fault::UselessExclusion { id, why: "which is shown" }),
                _ => {}
            }
        }
        let known = |id: &String| self.rules.iter().any(|rule| rule.requirement.id == *id);
        let answering = exclusions.findings.values().flat_map(|finding| &finding.rules);
        let named = exclusions.rules.keys().chain(answering);
        for id in named.filter(|id| !known(id)) {
            self.faults.push(Fault::UselessExclusion { id: id.clone(), why: "which is not in the text" });
        }
        for finding in &self.findings {
            let id = finding.id.clone();
            match (&finding.exclusion, finding.cases) {
                (None, 0) => self.faults.push(Fault::FindingWithoutCase(id)),
                (Some(_), 1..) => self
                    .faults
                    .push(Fault::UselessExclusion { id, why: "which cases or live scenarios are flagged with" }),
                _ => {}
            }
        }
    }

    fn in_time(&mut self, lock: &Accepted, sources: &Sources) {
        for file in &sources.missing_vectors {
            let place = format!("vectors/{file}");
            let rules = lock.rules.iter();
            let rules = rules.filter(|(_, accepted)| accepted.shown_by.contains(&place));
            self.faults
                .push(Fault::VectorFileGone { file: file.clone(), rules: rules.map(|(id, _)| id.clone()).collect() });
        }
        for (id, accepted) in &lock.rules {
            let Some(rule) = self.rules.iter().find(|rule| rule.requirement.id == *id) else {
                self.faults
                    .push(Fault::RuleGone { id: id.clone(), evidence: accepted.shown_by.iter().cloned().collect() });
                continue;
            };
            let shown_by = rule.shown_by();
            let gone: Vec<String> = accepted.shown_by.difference(&shown_by).cloned().collect();
            if !gone.is_empty() {
                self.faults.push(Fault::EvidenceGone { id: id.clone(), evidence: gone });
            }
            if rule.requirement.digest != accepted.digest {
                self.faults.push(Fault::SentenceChanged {
                    id: id.clone(),
                    was: accepted.digest.clone(),
                    now: rule.requirement.digest.clone(),
                    evidence: shown_by.into_iter().collect(),
                });
            }
        }
    }
}

impl Rule {
    /// The places of what shows it.
    fn shown_by(&self) -> BTreeSet<String> {
        let showing = self.evidence.iter().filter(|one| one.kind.shows());
        showing.map(|one| one.place.clone()).collect()
    }

    /// How much evidence of a kind there is: cases, or items.
    pub(crate) fn count(&self, kind: EvidenceKind) -> usize {
        let of_kind = self.evidence.iter().filter(|one| one.kind == kind);
        of_kind.map(|one| one.count).sum()
    }
}

/// The catalogue of the text as it stands in the tree, and the files that it does not list.
fn catalogue(root: &Path) -> Result<(Catalogue, Vec<String>), TraceError> {
    let folder = root.join("spec/text");
    let mut texts = Vec::new();
    for chapter in CHAPTERS {
        let path = folder.join(chapter.file);
        let text = std::fs::read_to_string(&path).map_err(|source| TraceError::File { path, source })?;
        texts.push((chapter.file, text));
    }
    let chapters: Vec<Chapter<'_>> = texts.iter().map(|(file, text)| Chapter { file, text }).collect();
    let catalogue = Catalogue::parse(&chapters)?;
    let listed: BTreeSet<&str> = CHAPTERS.iter().map(|chapter| chapter.file).collect();
    let is_unlisted = |name: &String| name != "README.md" && !listed.contains(name.as_str());
    let unlisted = sources::names(&folder, "md")?.into_iter().filter(is_unlisted).collect();
    Ok((catalogue, unlisted))
}

/// The exclusions of the tree; none where there is no list.
fn exclusions(root: &Path) -> Result<Exclusions, TraceError> {
    let path = root.join(Exclusions::FILE);
    match std::fs::read_to_string(&path) {
        Ok(text) => Ok(Exclusions::parse(&text)?),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(Exclusions::default()),
        Err(source) => Err(TraceError::File { path, source }),
    }
}

/// The ids that are cited and are not in the text.
fn unknown(catalogue: &Catalogue, sources: &Sources) -> Vec<Fault> {
    let known: BTreeSet<&str> = catalogue.iter().map(|rule| rule.id.as_str()).collect();
    let mut unknown: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for (id, place) in sources.citations() {
        if !known.contains(id) {
            unknown.entry(id.to_owned()).or_default().push(place);
        }
    }
    unknown.into_iter().map(|(id, places)| Fault::UnknownRule { id, places }).collect()
}

fn findings(sources: &Sources, exclusions: &Exclusions) -> Vec<Finding> {
    let ids = (1..=35).map(|number| format!("L{number:02}"));
    ids.map(|id| {
        let (cases, mut rules) = sources.flagged(&id);
        let exclusion = exclusions.findings.get(&id);
        rules.extend(exclusion.iter().flat_map(|excluded| excluded.rules.clone()));
        Finding { exclusion: exclusion.map(|excluded| excluded.why.clone()), id, cases, rules }
    })
    .collect()
}

/// The first few of many things.
fn list(things: &[String]) -> String {
    const SHOWN: usize = 6;
    let mut shown = things.iter().take(SHOWN).map(String::as_str).collect::<Vec<_>>().join(", ");
    if shown.is_empty() {
        return "nothing".to_owned();
    }
    if things.len() > SHOWN {
        shown.push_str(&format!(" and {} more", things.len() - SHOWN));
    }
    shown
}
