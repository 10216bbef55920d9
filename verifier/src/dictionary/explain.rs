//! The fewest known defects that explain what was seen.

use std::collections::{BTreeMap, BTreeSet};

use super::symptom::{CaseKey, Observed, Symptom};
use super::{Dictionary, Entry};

/// Of the cases that fail with a defect, at most one in so many may pass: another defect can hide it.
const MISSED_ONE_IN: usize = 8;
/// Of the cases that fail with a defect, so many in a hundred fail exactly as with it, unless other named defects
/// explain how they fail.
const ALIKE_PERCENT: usize = 60;

/// What the known defects explain.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Explanation {
    /// The defects, those that explain most cases first.
    pub defects: Vec<Explained>,
    /// The failing cases that none of them explains.
    pub unexplained: Vec<CaseKey>,
}

/// A defect that explains failing cases.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Explained {
    /// Its entry in the dictionary; more than one, if no case tells them apart.
    pub entries: Vec<usize>,
    /// The cases that fail, as they do with it.
    pub alike: Vec<CaseKey>,
    /// The cases that fail, and would with it, but in another way: another defect shows first.
    pub otherwise: Vec<CaseKey>,
    /// How many cases would fail with it, but pass.
    pub missed: usize,
}

impl Dictionary {
    /// Explains what was seen by the fewest entries.
    #[must_use]
    pub fn explain(&self, observed: &Observed) -> Explanation {
        self.explain_without(observed, None)
    }

    /// The same, as if one entry were not there.
    #[must_use]
    pub fn explain_without(&self, observed: &Observed, left_out: Option<usize>) -> Explanation {
        let suspects: Vec<Suspect> = self.entries.iter().enumerate()
            .filter(|(place, _)| Some(*place) != left_out)
            .filter_map(|(place, entry)| Suspect::of(place, entry, observed))
            .collect();
        let suspects = indistinguishable_together(suspects);
        let named = pruned(&suspects, chosen(&suspects));
        let mut defects: Vec<Explained> = named.iter().filter_map(|place| suspects.get(*place)).map(Suspect::explained).collect();
        defects.sort_by_key(|defect| std::cmp::Reverse(defect.alike.len()));
        let explained: BTreeSet<&CaseKey> = defects.iter().flat_map(|d| d.alike.iter().chain(&d.otherwise)).collect();
        let failing = observed.cases.iter().filter(|(_, symptom)| symptom.is_some()).map(|(key, _)| key);
        let unexplained = failing.filter(|key| !explained.contains(key)).copied().collect();
        Explanation { defects, unexplained }
    }
}

/// An entry, as far as the cases that were judged can show it.
#[derive(Debug)]
struct Suspect {
    entries: Vec<usize>,
    alike: BTreeSet<CaseKey>,
    otherwise: BTreeSet<CaseKey>,
    missed: usize,
    /// Its symptoms among the judged cases: what tells it from others.
    symptoms: BTreeMap<CaseKey, Symptom>,
}

impl Suspect {
    /// None for an entry that cannot be there: nothing fails as with it, or too much passes.
    fn of(place: usize, entry: &Entry, observed: &Observed) -> Option<Self> {
        let mut suspect = Self {
            entries: vec![place],
            alike: BTreeSet::new(),
            otherwise: BTreeSet::new(),
            missed: 0,
            symptoms: BTreeMap::new(),
        };
        for (key, symptom) in &entry.symptoms {
            let Some(seen) = observed.cases.get(key) else {
                continue;
            };
            suspect.symptoms.insert(*key, *symptom);
            match seen {
                Some(seen) if seen == symptom => suspect.alike.insert(*key),
                Some(_) => suspect.otherwise.insert(*key),
                None => {
                    suspect.missed += 1;
                    false
                }
            };
        }
        let all = suspect.symptoms.len();
        (!suspect.alike.is_empty() && suspect.missed * MISSED_ONE_IN <= all).then_some(suspect)
    }

    fn explained(&self) -> Explained {
        Explained {
            entries: self.entries.clone(),
            alike: self.alike.iter().copied().collect(),
            otherwise: self.otherwise.iter().copied().collect(),
            missed: self.missed,
        }
    }

    /// Whether what fails in another way than with it is explained by those that are named already.
    fn is_coherent(&self, alike_with_named: &BTreeSet<CaseKey>) -> bool {
        let foreign = self.otherwise.iter().filter(|key| !alike_with_named.contains(key)).count();
        self.alike.len() * 100 >= ALIKE_PERCENT * (self.alike.len() + foreign)
    }
}

/// Entries with the very same symptoms are one.
fn indistinguishable_together(suspects: Vec<Suspect>) -> Vec<Suspect> {
    let mut together: Vec<Suspect> = Vec::new();
    for suspect in suspects {
        match together.iter_mut().find(|other| other.symptoms == suspect.symptoms) {
            Some(other) => other.entries.extend(suspect.entries),
            None => together.push(suspect),
        }
    }
    together
}

/// One after the other that which explains most of what is still unexplained, as long as there is any.
fn chosen(suspects: &[Suspect]) -> Vec<usize> {
    let mut named: Vec<usize> = Vec::new();
    let mut alike: BTreeSet<CaseKey> = BTreeSet::new();
    let mut touched: BTreeSet<CaseKey> = BTreeSet::new();
    loop {
        let gain = |suspect: &Suspect| {
            let new = suspect.alike.difference(&alike).count();
            let first = suspect.alike.difference(&touched).count();
            (new, first)
        };
        let best = suspects
            .iter()
            .enumerate()
            .filter(|(place, suspect)| !named.contains(place) && suspect.is_coherent(&alike))
            .map(|(place, suspect)| (place, suspect, gain(suspect)))
            .filter(|(_, suspect, (new, first))| *first > 0 || *new * 2 > suspect.symptoms.len())
            // Of two that explain as much, that which promises less that is not there.
            .max_by_key(|(place, suspect, (new, _))| {
                let promised = suspect.missed * 2 + suspect.otherwise.len();
                (i64::try_from(*new).unwrap_or(0) - i64::try_from(promised).unwrap_or(0), std::cmp::Reverse(*place))
            });
        let Some((place, suspect, _)) = best else {
            return named;
        };
        named.push(place);
        alike.extend(&suspect.alike);
        touched.extend(suspect.alike.iter().chain(&suspect.otherwise));
    }
}

/// Leaves out what the others explain as well, that which explains least first.
fn pruned(suspects: &[Suspect], mut named: Vec<usize>) -> Vec<usize> {
    let suspect = |place: &usize| suspects.get(*place);
    let mut by_size = named.clone();
    by_size.sort_by_key(|place| suspect(place).map_or(0, |s| s.alike.len()));
    for place in by_size {
        let others: BTreeSet<CaseKey> =
            named.iter().filter(|other| **other != place).filter_map(suspect).flat_map(|s| &s.alike).copied().collect();
        if suspect(&place).is_some_and(|s| s.alike.is_subset(&others)) {
            named.retain(|other| *other != place);
        }
    }
    named
}
