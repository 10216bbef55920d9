//! What became of the hostile kernels: the lock, the page, and the whole of it.

use std::collections::BTreeMap;
use std::fmt;

use serde::Serialize;
use xtask::project::Project;

use super::super::MutateError;
use super::super::copies::Refuted;
use super::TABLE;
use super::tie::Tied;
use crate::artefact::Artefact;
use crate::document::{Block, heading, table, text};
use crate::lock::Lock;
use crate::reports;

/// The name of the artefact, of its lock and of its page.
const NAME: &str = "hostile";

/// Everything.
#[derive(Debug, Serialize)]
pub(super) struct Report {
    pub(super) kernels: Vec<Held>,
}

/// A kernel, and what both engines say of it.
#[derive(Debug, Serialize)]
pub(super) struct Held {
    pub(super) name: String,
    pub(super) about: String,
    /// Whether it is a change of the numbers alone, of which terms know nothing.
    pub(super) is_of_numbers: bool,
    pub(super) properties: Fate,
    #[serde(flatten)]
    pub(super) tie: Tied,
}

/// What the properties say of a kernel.
#[derive(Debug, Serialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Fate {
    /// An input breaks one of them.
    Refuted(Box<Refuted>),
    /// It does not compile where a harness takes its state apart, member by member: the compiler's words.
    NotBuilt(String),
    /// Nothing refutes it: what was said of it.
    Open(String),
}

impl Held {
    fn is_refuted(&self) -> bool {
        !matches!(self.properties, Fate::Open(_))
    }

    fn is_refused(&self) -> bool {
        self.tie != Tied::Accepted
    }

    /// The first word of its name.
    fn class(&self) -> &str {
        self.name.split('-').next().unwrap_or_default()
    }

    fn by_properties(&self) -> &'static str {
        match &self.properties {
            Fate::Refuted(_) => "refuted",
            Fate::NotBuilt(_) => "not built",
            Fate::Open(_) => "open",
        }
    }

    fn by_tie(&self) -> &'static str {
        match &self.tie {
            Tied::Accepted => "accepted",
            Tied::Refused(_) => "refused",
            Tied::NotExported(_) => "not exported",
            Tied::NotBuilt(_) => "not built",
        }
    }
}

impl fmt::Display for Held {
    fn fmt(&self, form: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(form, "{}: ", self.name)?;
        match &self.properties {
            Fate::Refuted(by) => {
                write!(form, "refuted by {}, {}: {}", by.property, by.engine, by.counterexample.check)?;
            }
            Fate::NotBuilt(said) => write!(form, "does not build with the properties: {said}")?,
            Fate::Open(said) => write!(form, "NOT REFUTED by the properties ({said})")?,
        }
        write!(form, "; {}", self.tie)
    }
}

impl Report {
    /// The kernels that one engine lets pass, but for numbers and the tie.
    pub(super) fn problems(&self) -> Vec<String> {
        let open = self.kernels.iter().filter_map(|held| match (held.is_refuted(), held.is_refused()) {
            (false, false) => Some(format!("{}: neither engine refutes it", held.name)),
            (false, true) => Some(format!("{}: no property refutes it", held.name)),
            (true, false) if !held.is_of_numbers => Some(format!("{}: the tie accepts it", held.name)),
            (true, _) => None,
        });
        open.collect()
    }

    pub(super) fn summary(&self) -> String {
        let (all, both) = (self.kernels.len(), self.both().count());
        format!("{all} hostile kernels: {both} noticed by both engines; {} PROBLEMS", self.problems().len())
    }

    fn both(&self) -> impl Iterator<Item = &Held> {
        self.kernels.iter().filter(|held| held.is_refuted() && held.is_refused())
    }

    /// Keeps it.
    ///
    /// # Errors
    /// A file cannot be written.
    pub(super) fn write(&self, project: &Project) -> Result<(), MutateError> {
        let root = project.path("");
        let digests = Artefact::named(NAME).map(|artefact| artefact.digests(&root)).transpose();
        let sources = digests.map_err(|source| MutateError::File { path: root.clone(), source })?.unwrap_or_default();
        let mut counts = BTreeMap::new();
        for held in &self.kernels {
            *counts.entry(format!("properties {}", held.by_properties())).or_default() += 1;
            *counts.entry(format!("tie {}", held.by_tie())).or_default() += 1;
        }
        let fate = |held: &Held| (held.name.clone(), format!("{}, {}", held.by_properties(), held.by_tie()));
        let fates = self.kernels.iter().map(fate).collect();
        Lock { sources, counts, fates, problems: self.problems(), ..Lock::default() }.write(&root, NAME)?;
        let (folder, page) = (project.path(reports::PAGES), self.page());
        reports::page(&folder, NAME, &page)?;
        reports::full(&folder, NAME, self, &page)?;
        Ok(())
    }

    /// What people read.
    fn page(&self) -> Vec<Block> {
        let mut classes: BTreeMap<&str, [usize; 4]> = BTreeMap::new();
        for held in &self.kernels {
            for class in [held.class(), "~all"] {
                let row = classes.entry(class).or_default();
                row[0] += 1;
                row[1] += usize::from(held.is_refuted());
                row[2] += usize::from(held.is_refused());
                row[3] += usize::from(held.is_refuted() && held.is_refused());
            }
        }
        let row = |(class, counts): (&str, [usize; 4])| {
            let mut row = vec![class.trim_start_matches('~').to_owned()];
            row.extend(counts.map(|count| count.to_string()));
            row
        };
        let mut page = vec![
            heading(1, "Hostile kernels"),
            text(format!(
                "`cargo assure mutate hostile`: the {} kernels of [`{TABLE}`](../{TABLE}), single and combined, \
                 planted by an author who had not read the properties. Each is held against two engines that share no \
                 harness: the properties of the proofs - on samples, on enumerated values, and for all doubles by the \
                 solvers -, and the tie of the theorem, for which the changed source is run on terms and Coq is asked \
                 whether that is still its model. A kernel with another state than the properties or the tie take \
                 apart does not build with them, and is noticed so. Of a change of the numbers alone the terms know \
                 nothing.",
                self.kernels.len()
            )),
            table(
                &["class", "kernels", "noticed by the properties", "by the tie", "by both"],
                classes.into_iter().map(row),
            ),
        ];
        let passing = self.kernels.iter().filter(|held| !(held.is_refuted() && held.is_refused()));
        let passing: Vec<Vec<String>> = passing
            .map(|held| [&*held.name, &held.about, held.by_properties(), held.by_tie()].map(str::to_owned).to_vec())
            .collect();
        if !passing.is_empty() {
            page.push(heading(2, "What one of them lets pass"));
            page.push(table(&["kernel", "what it does", "properties", "tie"], passing));
        }
        page
    }
}
