//! What was found, as JSON and as Markdown.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use serde::Serialize;

use super::{Fate, Trial};
use ncp_verifier::suite::Suite;

/// The format of the JSON file.
const FORMAT: u32 = 1;

/// What a hunt found.
#[derive(Debug, Serialize)]
pub struct MutantsReport {
    /// The format of this model.
    pub format: u32,
    /// How many cases the suite has.
    pub cases: usize,
    /// The SHA-256 of `vectors/MANIFEST.sha256`.
    pub corpus_sha256: String,
    /// How many mutants came to which end.
    pub totals: Totals,
    /// The trials, in the order of the table.
    pub mutants: Vec<Trial>,
}

/// How many mutants came to which end.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
pub struct Totals {
    /// The suite fails them and names their rule.
    pub killed: usize,
    /// Of those: the rule is the first that the verdict names.
    pub named_first: usize,
    /// Of those: the rule is among the first three that the verdict names.
    pub named_early: usize,
    /// The suite fails them for other rules.
    pub misnamed: usize,
    /// The suite does not notice them.
    pub survived: usize,
    /// The trial took too long.
    pub unfinished: usize,
}

impl Totals {
    /// Whether every mutant was killed.
    #[must_use]
    pub fn all_killed(self) -> bool {
        self.misnamed + self.survived + self.unfinished == 0
    }
}

impl MutantsReport {
    /// Puts a report together.
    #[must_use]
    pub fn new(suite: &Suite, mutants: Vec<Trial>) -> Self {
        let mut totals = Totals::default();
        for trial in &mutants {
            *match trial.fate {
                Fate::Killed => &mut totals.killed,
                Fate::Misnamed => &mut totals.misnamed,
                Fate::Survived => &mut totals.survived,
                Fate::Unfinished => &mut totals.unfinished,
            } += 1;
            let is_within = |places| trial.fate == Fate::Killed && trial.place.is_some_and(|at| at <= places);
            totals.named_first += usize::from(is_within(1));
            totals.named_early += usize::from(is_within(EARLY));
        }
        Self { format: FORMAT, cases: suite.cases().len(), corpus_sha256: suite.digest().to_owned(), totals, mutants }
    }

    /// The JSON file.
    ///
    /// # Errors
    /// Only if a number in it cannot be written, which does not occur.
    pub fn to_json(&self) -> Result<String, serde_json::Error> {
        Ok(serde_json::to_string_pretty(self)? + "\n")
    }

    /// The page for people. It holds no times, so that it changes only when the findings do.
    #[must_use]
    pub fn to_markdown(&self) -> String {
        let mut page = String::from("# Mutants\n\n");
        // Writing to a string does not fail.
        let _ = self.write(&mut page);
        page
    }

    /// The mutants that were not killed, a line each.
    #[must_use]
    pub fn remarks(&self) -> Vec<String> {
        let remark = |trial: &Trial| {
            let Trial { mutant, fate, named, .. } = trial;
            let (name, rule) = (&mutant.name, mutant.rules.first().map_or("", String::as_str));
            match fate {
                Fate::Killed => None,
                Fate::Misnamed => Some(format!("{name} breaks {rule}, but the verdict names {}", rules(named))),
                Fate::Survived => Some(format!("{name} survived: no case of {rule} notices it. {}", mutant.about)),
                Fate::Unfinished => Some(format!("{name}: its trial took too long")),
            }
        };
        self.mutants.iter().filter_map(remark).collect()
    }

    fn write(&self, page: &mut String) -> std::fmt::Result {
        let Totals { killed, named_first, named_early, misnamed, survived, unfinished } = self.totals;
        writeln!(
            page,
            "Made by `ncp-verify mutants`: the Rust peer with one defect after the other (`peers/mutants`), each held \
             against the {} cases of the corpus `{}`.\n",
            self.cases,
            self.corpus_sha256.get(..16).unwrap_or_default()
        )?;
        writeln!(
            page,
            "| mutants | killed | rule named first | among the first {EARLY} | rule not named | survived | not finished |"
        )?;
        writeln!(page, "|---|---|---|---|---|---|---|")?;
        writeln!(
            page,
            "| {} | {killed} | {named_first} | {named_early} | {misnamed} | {survived} | {unfinished} |\n",
            self.mutants.len()
        )?;
        writeln!(
            page,
            "A mutant is killed when a case fails that cites the broken rule first. Cases with requests above 64 KiB \
             were run only where no other case did. The verdict names the likeliest rule first: that of \
             the lowest level, and within a level by how many of a rule's cases fail and what share of all they are. *Named first* means that the verdict on this \
             mutant begins with that rule; where it does not, the rules before it stand in brackets."
        )?;
        let remarks = self.remarks();
        if !remarks.is_empty() {
            writeln!(page)?;
        }
        for remark in remarks {
            writeln!(page, "- **{remark}**")?;
        }
        writeln!(page, "\n## Audited findings\n\n| finding | mutants |\n|---|---|")?;
        let mut findings: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
        for trial in self.mutants.iter().filter(|trial| trial.mutant.finding.starts_with('L')) {
            findings.entry(&trial.mutant.finding).or_default().push(&trial.mutant.name);
        }
        for (finding, names) in findings {
            writeln!(page, "| {finding} | {} |", names.join(", "))?;
        }
        writeln!(
            page,
            "\n## All mutants\n\n| mutant | the defect | finding | rule | failing cases | the shortest |\n|---|---|---|---|---|---|"
        )?;
        for trial in &self.mutants {
            let Trial { mutant, fate, failing_cases, crashes, named, shortest_case, .. } = trial;
            let rule = mutant.rules.first().map_or("", String::as_str);
            let before: Vec<Named<'_>> =
                named.iter().take_while(|named| named.rule != rule).map(|named| named.rule.as_str()).collect();
            let rule = match (fate, &before[..]) {
                (Fate::Killed, []) => rule.to_owned(),
                (Fate::Killed, before) => format!("{rule} ({})", few(before)),
                _ => format!("**{rule}**"),
            };
            let crashes = match crashes {
                0 => String::new(),
                crashes => format!(", {crashes} by a crash"),
            };
            writeln!(
                page,
                "| {} | {} | {} | {rule} | {failing_cases}{crashes} | {} |",
                mutant.name,
                mutant.about.replace('|', "\\|"),
                mutant.finding,
                shortest_case.as_deref().map_or("none".to_owned(), |id| format!("`{id}`")),
            )?;
        }
        Ok(())
    }
}

/// How many rules somebody reads before giving up.
const EARLY: usize = 3;

type Named<'r> = &'r str;

fn rules(named: &[super::Named]) -> String {
    few(&named.iter().map(|named| named.rule.as_str()).collect::<Vec<_>>())
}

/// The first few of many rules.
fn few(rules: &[&str]) -> String {
    const SHOWN: usize = 3;
    let shown = rules.get(..SHOWN).unwrap_or(rules).join(", ");
    match rules.len().saturating_sub(SHOWN) {
        0 => shown,
        more => format!("{shown} and {more} more"),
    }
}
