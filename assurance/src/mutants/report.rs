//! What was found of all mutants: as a model, as documents, and as what git keeps.

use std::collections::BTreeMap;

use ncp_verifier::suite::Suite;
use serde::{Deserialize, Serialize};

use super::{Fate, Trial};
use crate::document::{Block, heading, table, text};
use crate::lock::Lock;

/// The format of the JSON file.
const FORMAT: u32 = 1;
/// How many rules somebody reads before giving up.
const EARLY: usize = 3;

/// What a hunt found.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct MutantsReport {
    /// The format of this model.
    pub(crate) format: u32,
    /// How many cases the suite has.
    pub(crate) cases: usize,
    /// The SHA-256 of `vectors/MANIFEST.sha256`.
    pub(crate) corpus_sha256: String,
    /// How many mutants came to which end.
    pub(crate) totals: Totals,
    /// The trials, in the order of the tables.
    pub(crate) mutants: Vec<Trial>,
}

/// How many mutants came to which end.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Totals {
    /// The suite fails them and names their rule.
    pub(crate) killed: usize,
    /// Of those: the rule, the first of the defect's list, is the first that the verdict names.
    pub(crate) named_first: usize,
    /// Of those: the first rule that the verdict names is that rule, or one that the defect breaks as directly.
    pub(crate) led_rightly: usize,
    /// Of those: the rule is among the first three that the verdict names.
    pub(crate) named_early: usize,
    /// The verdict names a rule or more whose sentence they keep.
    pub(crate) blamed: usize,
    /// The suite fails them for other rules.
    pub(crate) misnamed: usize,
    /// The suite does not notice them.
    pub(crate) survived: usize,
    /// The trial took too long.
    pub(crate) unfinished: usize,
}

impl Totals {
    /// Whether every mutant was killed.
    pub(crate) fn all_killed(self) -> bool {
        self.misnamed + self.survived + self.unfinished == 0
    }

    /// Whether every mutant was killed, and none of the rules that it keeps was blamed.
    pub(crate) fn all_rightly_judged(self) -> bool {
        self.all_killed() && self.blamed == 0
    }
}

impl MutantsReport {
    /// Puts a report together.
    pub(crate) fn new(suite: &Suite, mutants: Vec<Trial>) -> Self {
        let mut totals = Totals::default();
        for trial in &mutants {
            *match trial.fate {
                Fate::Killed => &mut totals.killed,
                Fate::Misnamed => &mut totals.misnamed,
                Fate::Survived => &mut totals.survived,
                Fate::Unfinished => &mut totals.unfinished,
            } += 1;
            let is_within = |places| trial.fate == Fate::Killed && trial.place.is_some_and(|at| at <= places);
            let first = trial.named.first();
            let is_led = first.is_some_and(|named| trial.mutant.is_led_by(&named.rule));
            totals.named_first += usize::from(is_within(1));
            totals.led_rightly += usize::from(trial.fate == Fate::Killed && is_led);
            totals.blamed += usize::from(!trial.blamed().is_empty());
            totals.named_early += usize::from(is_within(EARLY));
        }
        Self { format: FORMAT, cases: suite.cases().len(), corpus_sha256: suite.digest().to_owned(), totals, mutants }
    }

    /// The mutants that were not killed, or in which a rule that they keep is blamed, a line each.
    pub(crate) fn remarks(&self) -> Vec<String> {
        let remark = |trial: &Trial| {
            let Trial { mutant, fate, named, .. } = trial;
            let (name, rule) = (&mutant.name, mutant.owed().join(", "));
            match fate {
                Fate::Killed => match &trial.blamed()[..] {
                    [] => None,
                    [one] => Some(format!("{name} keeps {one}, but the verdict names it")),
                    blamed => Some(format!("{name} keeps {}, but the verdict names them", blamed.join(", "))),
                },
                Fate::Misnamed => {
                    let named: Vec<&str> = named.iter().map(|named| named.rule.as_str()).collect();
                    Some(format!("{name} breaks {rule}, but the verdict names {}", few(&named)))
                }
                Fate::Survived => Some(format!("{name} survived: no case of {rule} notices it. {}", mutant.about)),
                Fate::Unfinished => Some(format!("{name}: its trial took too long")),
            }
        };
        self.mutants.iter().filter_map(remark).collect()
    }

    /// What git keeps of it, with the digests of the sources.
    pub(crate) fn lock(&self, sources: BTreeMap<String, String>) -> Lock {
        let Totals { killed, named_first, led_rightly, named_early, blamed, misnamed, survived, unfinished } =
            self.totals;
        let counts = [
            ("blamed", blamed),
            ("cases", self.cases),
            ("killed", killed),
            ("led_rightly", led_rightly),
            ("misnamed", misnamed),
            ("named_early", named_early),
            ("named_first", named_first),
            ("survived", survived),
            ("unfinished", unfinished),
        ];
        let fate = |trial: &Trial| {
            let place = trial.place.map(|place| format!(", its rule named as number {place}"));
            let blamed = match &trial.blamed()[..] {
                [] => String::new(),
                blamed => format!(", {} blamed falsely", blamed.join(", ")),
            };
            format!("{}, {} failing{}{blamed}", trial.fate, trial.failing_cases, place.unwrap_or_default())
        };
        Lock {
            sources,
            counts: counts.map(|(end, count)| (end.to_owned(), count as u64)).into(),
            fates: self.mutants.iter().map(|trial| (trial.mutant.name.clone(), fate(trial))).collect(),
            problems: self.remarks(),
            ..Lock::default()
        }
    }

    /// The short page. It holds no times, so that it changes only when the findings do.
    pub(crate) fn page(&self) -> Vec<Block> {
        let Totals { killed, named_first, led_rightly, named_early, blamed, misnamed, survived, unfinished } =
            self.totals;
        let counts =
            [self.mutants.len(), killed, named_first, led_rightly, named_early, blamed, misnamed, survived, unfinished];
        let mut page = vec![
            heading(1, "Mutants"),
            text(format!(
                "Made by `cargo assure mutants`: the Rust peer with one planted defect after the other \
                 (`defects/peer`), each held against the {} cases of the corpus `{}`. The fate of each stands in \
                 `reports/lock/mutants.toml`; the command writes the whole report to `reports/full`.",
                self.cases,
                self.corpus_sha256.get(..16).unwrap_or_default()
            )),
            table(
                &[
                    "mutants",
                    "killed",
                    "rule named first",
                    "or one as direct",
                    "rule among the first 3",
                    "another blamed",
                    "rule not named",
                    "survived",
                    "not finished",
                ],
                [counts.map(|count| count.to_string()).to_vec()],
            ),
            text(
                "A mutant is killed when a case fails that cites the broken rule and is charged to it. Cases with \
                 requests above 64 KiB were run only where no other case did. The verdict names the likeliest rule \
                 first: that of the lowest level, and within a level by how many of a rule's cases fail and what \
                 share of all they are. The *rule* of a mutant is the first that its defect lists. *Or one as direct* \
                 adds those whose verdict begins with another that the defect breaks as directly, such as that of the \
                 decoder where one function serves encoder and decoder: a reader who had not seen the verdicts named \
                 these. *Another blamed* means that the verdict names a rule whose sentence the mutant keeps: the \
                 table of defects does not list it among those that are broken.",
            ),
        ];
        let remarks = self.remarks();
        if !remarks.is_empty() {
            page.push(Block::List(remarks.into_iter().map(|remark| format!("**{remark}**")).collect()));
        }
        let mut findings: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
        for trial in self.mutants.iter().filter(|trial| trial.mutant.finding.starts_with('L')) {
            findings.entry(&trial.mutant.finding).or_default().push(&trial.mutant.name);
        }
        page.push(heading(2, "Audited findings"));
        let rows = findings.into_iter().map(|(finding, names)| vec![finding.to_owned(), names.join(", ")]);
        page.push(table(&["finding", "mutants"], rows));
        page.push(heading(2, "Blamed falsely"));
        page.push(text("The rules that a verdict names although the mutant keeps their sentences."));
        let blamed = self.mutants.iter().filter(|trial| !trial.blamed().is_empty());
        let rows = blamed.map(|trial| vec![trial.mutant.name.clone(), trial.blamed().join(", ")]);
        page.push(table(&["mutant", "rules"], rows));
        page.push(heading(2, "Named late"));
        page.push(text("Killed, but the verdict names three rules or more before the one that is broken."));
        let late = self.mutants.iter().filter(|trial| trial.place.is_some_and(|place| place > EARLY));
        page.push(table(&HEAD, late.map(row)));
        page
    }

    /// The whole page.
    pub(crate) fn full_page(&self) -> Vec<Block> {
        let mut page = self.page();
        page.push(heading(2, "All mutants"));
        page.push(table(&HEAD, self.mutants.iter().map(row)));
        page
    }
}

const HEAD: [&str; 6] = ["mutant", "the defect", "finding", "rule", "failing cases", "the shortest"];

/// A mutant with its rule; the rules that the verdict names before it stand in brackets.
fn row(trial: &Trial) -> Vec<String> {
    let Trial { mutant, fate, failing_cases, crashes, named, shortest_case, .. } = trial;
    let rule = mutant.rules.first().map_or("", String::as_str);
    let named = named.iter().map(|named| named.rule.as_str());
    let before: Vec<&str> = named.take_while(|named| *named != rule).collect();
    let rule = match (fate, &before[..]) {
        (Fate::Killed, []) => rule.to_owned(),
        (Fate::Killed, before) => format!("{rule} ({})", few(before)),
        _ => format!("**{rule}**"),
    };
    let crashes = match crashes {
        0 => String::new(),
        crashes => format!(", {crashes} by a crash"),
    };
    vec![
        mutant.name.clone(),
        mutant.about.clone(),
        mutant.finding.clone(),
        rule,
        format!("{failing_cases}{crashes}"),
        shortest_case.as_deref().map_or("none".to_owned(), |id| format!("`{id}`")),
    ]
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
