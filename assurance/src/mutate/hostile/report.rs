//! What became of the hostile kernels: the lock, the page, and the whole of it.

use std::collections::BTreeMap;
use std::fmt;

use serde::Serialize;
use xtask::project::Project;

use super::super::MutateError;
use super::super::copies::Refuted;
use super::TABLE;
use super::cases::Judged;
use super::tie::Tied;
use crate::artefact::Artefact;
use crate::document::{Block, heading, table, text};
use crate::lock::Lock;
use crate::reports;

/// The name of the artefact, of its lock and of its page.
const NAME: &str = "hostile";
/// So many have to notice a kernel.
const ENOUGH: usize = 2;

/// Everything.
#[derive(Debug, Serialize)]
pub(super) struct Report {
    pub(super) kernels: Vec<Held>,
}

/// A kernel, and who notices it.
#[derive(Debug, Serialize)]
pub(super) struct Held {
    pub(super) name: String,
    pub(super) about: String,
    /// Whether it is a change of the numbers alone, of which terms know nothing.
    pub(super) is_of_numbers: bool,
    pub(super) properties: Fate,
    pub(super) cases: Judged,
    /// Nothing where the tie was not asked.
    pub(super) tie: Option<Tied>,
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
    /// Whether the tie has a word to say: fewer than two of the others notice it, and terms can tell.
    pub(super) fn asks_the_tie(&self) -> bool {
        !self.is_of_numbers && self.noticed_by() < ENOUGH
    }

    fn is_refuted(&self) -> bool {
        !matches!(self.properties, Fate::Open(_))
    }

    fn is_failed(&self) -> bool {
        self.cases != Judged::Passed
    }

    fn is_refused(&self) -> bool {
        self.tie.as_ref().is_some_and(|tie| !matches!(tie, Tied::Accepted | Tied::Late))
    }

    /// How many notice it.
    fn noticed_by(&self) -> usize {
        [self.is_refuted(), self.is_failed(), self.is_refused()].into_iter().filter(|notices| *notices).count()
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

    fn by_cases(&self) -> &'static str {
        match &self.cases {
            Judged::Failed { .. } => "failed",
            Judged::Late => "too late",
            Judged::Passed => "passed",
        }
    }

    fn by_tie(&self) -> &'static str {
        match &self.tie {
            None => "not asked",
            Some(Tied::Accepted) => "accepted",
            Some(Tied::Refused(_)) => "refused",
            Some(Tied::NotExported(_)) => "not exported",
            Some(Tied::NotBuilt(_)) => "not built",
            Some(Tied::Late) => "too late",
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
        match &self.cases {
            Judged::Failed { cases, first } => write!(form, "; {cases} golden cases fail, {first} first")?,
            Judged::Late => write!(form, "; the golden cases come to no end")?,
            Judged::Passed => write!(form, "; PASSES the golden cases")?,
        }
        self.tie.as_ref().map_or(Ok(()), |tie| write!(form, "; {tie}"))
    }
}

impl Report {
    /// The kernels that fewer than two notice.
    pub(super) fn problems(&self) -> Vec<String> {
        let open = self.kernels.iter().filter(|held| held.noticed_by() < ENOUGH);
        open.map(|held| match held.noticed_by() {
            0 => format!("{}: nothing notices it", held.name),
            _ => format!(
                "{}: only one notices it (properties {}, golden cases {}, tie {})",
                held.name,
                held.by_properties(),
                held.by_cases(),
                held.by_tie()
            ),
        })
        .collect()
    }

    pub(super) fn summary(&self) -> String {
        let (all, problems) = (self.kernels.len(), self.problems().len());
        format!("{all} hostile kernels: {} noticed by two at least; {problems} PROBLEMS", all - problems)
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
            *counts.entry(format!("golden cases {}", held.by_cases())).or_default() += 1;
            *counts.entry(format!("tie {}", held.by_tie())).or_default() += 1;
        }
        let fate = |held: &Held| (held.name.clone(), [held.by_properties(), held.by_cases(), held.by_tie()].join(", "));
        let fates = self.kernels.iter().map(fate).collect();
        Lock { sources, counts, fates, problems: self.problems(), ..Lock::default() }.write(&root, NAME)?;
        let (folder, page) = (project.path(reports::PAGES), self.page());
        reports::page(&folder, NAME, &page)?;
        reports::full(&folder, NAME, self, &page)?;
        Ok(())
    }

    /// What people read.
    fn page(&self) -> Vec<Block> {
        let mut classes: BTreeMap<&str, [usize; 6]> = BTreeMap::new();
        for held in &self.kernels {
            for class in [held.class(), "~all"] {
                let row = classes.entry(class).or_default();
                let is_enough = held.noticed_by() >= ENOUGH;
                let marks =
                    [true, held.is_refuted(), held.is_failed(), held.tie.is_some(), held.is_refused(), is_enough];
                row.iter_mut().zip(marks).for_each(|(count, mark)| *count += usize::from(mark));
            }
        }
        let row = |(class, counts): (&str, [usize; 6])| {
            let mut row = vec![class.trim_start_matches('~').to_owned()];
            row.extend(counts.map(|count| count.to_string()));
            row
        };
        let mut page = vec![
            heading(1, "Hostile kernels"),
            text(format!(
                "`cargo assure mutate hostile`: the {} kernels of [`{TABLE}`](../{TABLE}), single and combined, \
                 planted by an author who had not read the properties. Three share no harness, and two of them have to \
                 notice each kernel: the properties of the proofs - on samples, on enumerated values, and for all \
                 doubles by the solvers -; the golden cases of what moves a plant, asked of the Rust peer with that \
                 kernel, which are no proof and whose author knew these kernels; and the tie of the theorem, for which \
                 the changed source is run on terms and Coq is asked whether that is still its model. The tie takes \
                 minutes for some kernels and is asked of those that one of the others lets pass; of a change of the \
                 numbers alone the terms know nothing. A kernel with another state than the properties or the tie \
                 take apart does not build with them, and is noticed so.",
                self.kernels.len()
            )),
            table(
                &["class", "kernels", "properties", "golden cases", "tie asked", "tie", "by two at least"],
                classes.into_iter().map(row),
            ),
        ];
        let passing = self.kernels.iter().filter(|held| !held.is_refuted() || !held.is_failed());
        let passing: Vec<Vec<String>> = passing
            .map(|held| {
                [&*held.name, &held.about, held.by_properties(), held.by_cases(), held.by_tie()]
                    .map(str::to_owned)
                    .to_vec()
            })
            .collect();
        if !passing.is_empty() {
            page.push(heading(2, "What the properties or the golden cases let pass"));
            page.push(table(&["kernel", "what it does", "properties", "golden cases", "tie"], passing));
        }
        page
    }
}
