//! The fewest known defects that explain what was seen.
//!
//! A set of defects predicts how each case ends. What was seen otherwise costs something, each defect named costs
//! something, and the set that costs least is looked for: one defect after the other, each time asking whether one that
//! was named is no longer needed or is better replaced. A defect whose own prediction is contradicted is then refuted,
//! and so is one beside which too much stays unexplained: it is likely part of another that nobody knows.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use super::symptom::{CaseKey, Observed, Symptom};
use super::{Dictionary, Symptoms};
use crate::suite::DESCRIBE;

/// What it costs to name a defect.
const NAMED: i64 = 5;
/// A case fails that no named defect breaks.
const UNEXPLAINED: i64 = 10;
/// A case fails where a named defect breaks it, with another value there; or where one of several does.
const OTHER_VALUE: [i64; 2] = [3, 1];
/// A case fails elsewhere than a named defect breaks it, or than any of several does: one can hide the other.
const ELSEWHERE: [i64; 2] = [8, 5];
/// A case passes that a named defect breaks, or that several do: one can undo the other.
const PASSES: [i64; 2] = [15, 4];
/// For every case that contradicts a defect, so many have to end exactly as with it: more where the case is of a file
/// in which no other defect that is named shows, as beside another it may be this that ends it otherwise.
const ALIKE_A_CONTRADICTION: [usize; 2] = [100, 10];
/// So many times the cases that stay unexplained beside those that a defect breaks must not exceed those.
const UNEXPLAINED_BESIDE: usize = 3;

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
    /// Its entry in the dictionary; more than one, if no case that was judged tells them apart.
    pub entries: Vec<usize>,
    /// The failing cases that it explains: each is explained by one defect.
    pub cases: Vec<CaseKey>,
    /// How many cases would fail with it, but pass.
    pub missed: usize,
}

impl Dictionary {
    /// Whether any case that was judged breaks with a known defect; the question that every run asks, whatever its
    /// cases, does not count.
    #[must_use]
    pub fn knows(&self, observed: &Observed) -> bool {
        let describe = CaseKey::of(DESCRIBE);
        let known = |key: &CaseKey| *key != describe && observed.cases.contains_key(key);
        self.entries.iter().flat_map(|entry| entry.symptoms.keys()).any(known)
    }

    /// Explains what was seen by the fewest entries.
    #[must_use]
    pub fn explain(&self, observed: &Observed) -> Explanation {
        self.explain_without(observed, &[])
    }

    /// The same, as if some entries were not there.
    #[must_use]
    pub fn explain_without(&self, observed: &Observed, left_out: &[usize]) -> Explanation {
        let suspects = self.suspects(observed, left_out);
        let mut refuted = BTreeSet::new();
        loop {
            let mut search = Search::new(observed, &suspects, &refuted);
            search.run();
            match search.most_contradicted() {
                Some(suspect) => refuted.insert(suspect),
                None => {
                    search.forget_the_superfluous();
                    return search.explanation();
                }
            };
        }
    }

    /// The entries as which at least one case fails, with what they predict of the judged cases; of those that predict
    /// the same, one.
    fn suspects(&self, observed: &Observed, left_out: &[usize]) -> Vec<Suspect> {
        let mut alike: HashMap<Vec<(CaseKey, Symptom)>, Suspect> = HashMap::new();
        for (place, entry) in self.entries.iter().enumerate().filter(|(place, _)| !left_out.contains(place)) {
            let judged = entry.symptoms.iter().filter(|(key, _)| observed.cases.contains_key(key));
            let predicts: Symptoms = judged.map(|(key, symptom)| (*key, *symptom)).collect();
            if predicts.iter().any(|(key, symptom)| observed.symptom(*key) == Some(*symptom)) {
                let form = predicts.iter().map(|(key, symptom)| (*key, *symptom)).collect();
                alike.entry(form).or_insert_with(|| Suspect { entries: Vec::new(), predicts }).entries.push(place);
            }
        }
        let mut suspects: Vec<Suspect> = alike.into_values().collect();
        suspects.sort_by_key(|suspect| suspect.entries.first().copied());
        suspects
    }
}

/// An entry, or several of one form, as far as the cases that were judged can show it.
#[derive(Debug)]
struct Suspect {
    entries: Vec<usize>,
    predicts: Symptoms,
}

/// The search for the cheapest set of suspects.
struct Search<'s> {
    observed: &'s Observed,
    suspects: &'s [Suspect],
    open: BTreeSet<usize>,
    named: Vec<usize>,
    /// What the named ones predict, case by case.
    predicted: BTreeMap<CaseKey, Vec<Symptom>>,
}

impl<'s> Search<'s> {
    fn new(observed: &'s Observed, suspects: &'s [Suspect], refuted: &BTreeSet<usize>) -> Self {
        let open = (0..suspects.len()).filter(|suspect| !refuted.contains(suspect)).collect();
        Self { observed, suspects, open, named: Vec::new(), predicted: BTreeMap::new() }
    }

    fn run(&mut self) {
        while let Some((_, best)) = self.cheapest(None).filter(|(cost, _)| *cost < 0) {
            self.name(best);
            for named in self.named.clone() {
                // Taken out, it is put back only if it, or another instead, still pays.
                self.withdraw(named);
                if let Some((_, better)) = self.cheapest(Some(named)).filter(|(cost, _)| *cost < 0) {
                    self.name(better);
                }
            }
        }
    }

    /// The suspect whose naming costs least, and how much; of equals `before`, or else the first.
    fn cheapest(&self, before: Option<usize>) -> Option<(i64, usize)> {
        let costs = self.open.iter().map(|suspect| (self.cost_of_naming(*suspect), *suspect));
        costs.min_by_key(|(cost, suspect)| (*cost, Some(*suspect) != before, *suspect))
    }

    fn predictions(&self, suspect: usize) -> impl Iterator<Item = (CaseKey, Symptom)> + use<'s> {
        let suspect = self.suspects.get(suspect);
        suspect.into_iter().flat_map(|suspect| &suspect.predicts).map(|(key, symptom)| (*key, *symptom))
    }

    fn predicted(&self, key: CaseKey) -> &[Symptom] {
        self.predicted.get(&key).map_or(&[], Vec::as_slice)
    }

    fn cost_of_naming(&self, suspect: usize) -> i64 {
        let change = |(key, symptom): (CaseKey, Symptom)| {
            let (seen, before) = (self.observed.symptom(key), self.predicted(key));
            cost(seen, before, Some(symptom)) - cost(seen, before, None)
        };
        NAMED + self.predictions(suspect).map(change).sum::<i64>()
    }

    fn name(&mut self, suspect: usize) {
        self.open.remove(&suspect);
        self.named.push(suspect);
        for (key, symptom) in self.predictions(suspect) {
            self.predicted.entry(key).or_default().push(symptom);
        }
    }

    fn withdraw(&mut self, suspect: usize) {
        self.open.insert(suspect);
        self.named.retain(|named| *named != suspect);
        for (key, symptom) in self.predictions(suspect) {
            if let Some(symptoms) = self.predicted.get_mut(&key) {
                if let Some(place) = symptoms.iter().position(|other| *other == symptom) {
                    symptoms.swap_remove(place);
                }
                if symptoms.is_empty() {
                    self.predicted.remove(&key);
                }
            }
        }
    }

    /// The failing cases that end as no named suspect predicts.
    fn unlike(&self) -> impl Iterator<Item = CaseKey> + '_ {
        let failing = self.observed.symptoms();
        failing.into_iter().filter(|(key, seen)| !self.predicted(*key).contains(seen)).map(|(key, _)| key)
    }

    /// The named suspect against which most speaks, if that is too much.
    fn most_contradicted(&self) -> Option<usize> {
        let mut unlike: HashMap<u16, usize> = HashMap::new();
        for key in self.unlike() {
            *unlike.entry(self.observed.file(key)).or_default() += 1;
        }
        let is_alike = |(key, symptom): &(CaseKey, Symptom)| self.observed.symptom(*key) == Some(*symptom);
        let files = |suspect: &usize| -> BTreeSet<u16> {
            self.predictions(*suspect).filter(is_alike).map(|(key, _)| self.observed.file(key)).collect()
        };
        let of_others = |suspect: &usize| -> BTreeSet<u16> {
            self.named.iter().filter(|named| *named != suspect).flat_map(files).collect()
        };
        let against = |suspect: &usize| {
            let (alike, other): (Vec<_>, Vec<_>) = self.predictions(*suspect).partition(is_alike);
            let shared = of_others(suspect);
            let contradictions = other.iter().filter(|(key, _)| self.predicted(*key).len() == 1);
            let [alone, beside_others] = ALIKE_A_CONTRADICTION;
            let weight = |(key, _): &(CaseKey, Symptom)| {
                if shared.contains(&self.observed.file(*key)) { beside_others } else { alone }
            };
            let contradictions: usize = contradictions.map(weight).sum();
            let beside: usize = files(suspect).iter().filter_map(|file| unlike.get(file)).sum();
            let is_refuted = contradictions > alike.len();
            let is_part = beside * UNEXPLAINED_BESIDE > alike.len();
            // The share of what speaks against it, in thousandths.
            let share = |count: usize| count * 1000 / alike.len().max(1);
            (is_refuted || is_part)
                .then(|| (is_refuted, if is_refuted { share(contradictions) } else { share(beside) }))
        };
        let refuted = self.named.iter().filter_map(|suspect| Some((against(suspect)?, *suspect)));
        refuted.max().map(|(_, suspect)| suspect)
    }

    /// Forgets the named suspects without which every failing case still ends as one of the others predicts: they
    /// were named for the cases that pass alone, as two defects that would break such a case speak less against each
    /// other than one.
    fn forget_the_superfluous(&mut self) {
        let alike = |suspect: &usize| {
            let is_alike = |(key, symptom): &(CaseKey, Symptom)| self.observed.symptom(*key) == Some(*symptom);
            self.predictions(*suspect).filter(is_alike).collect::<Vec<_>>()
        };
        let mut named: Vec<_> = self.named.iter().map(|suspect| (*suspect, alike(suspect))).collect();
        named.sort_by_key(|(_, alike)| alike.len());
        for (suspect, alike) in named {
            let is_shared = |(key, seen): &(CaseKey, Symptom)| {
                self.predicted(*key).iter().filter(|symptom| *symptom == seen).count() > 1
            };
            if alike.iter().all(is_shared) {
                self.withdraw(suspect);
            }
        }
    }

    fn explanation(self) -> Explanation {
        let mut defects: Vec<(usize, Explained)> = Vec::new();
        for suspect in &self.named {
            let missed = self.predictions(*suspect).filter(|(key, _)| self.observed.symptom(*key).is_none()).count();
            let entries = self.suspects.get(*suspect).map_or(Vec::new(), |suspect| suspect.entries.clone());
            defects.push((*suspect, Explained { entries, cases: Vec::new(), missed }));
        }
        let mut unexplained = Vec::new();
        for (key, seen) in self.observed.symptoms() {
            // Whose prediction it is, and failing that, who breaks it at all.
            let likeness = |(suspect, _): &(usize, Explained)| {
                let predicted = self.suspects.get(*suspect)?.predicts.get(&key)?;
                Some((*predicted == seen, (predicted.step, predicted.place) == (seen.step, seen.place)))
            };
            let closest = (0..defects.len()).max_by_key(|place| defects.get(*place).map(likeness));
            match closest.and_then(|place| defects.get_mut(place)).filter(|defect| likeness(defect).is_some()) {
                Some((_, defect)) => defect.cases.push(key),
                None => unexplained.push(key),
            }
        }
        let mut defects: Vec<Explained> = defects.into_iter().map(|(_, defect)| defect).collect();
        defects.sort_by_key(|defect| std::cmp::Reverse(defect.cases.len()));
        Explanation { defects, unexplained }
    }
}

/// What it costs that a case ends as seen, where these symptoms, and one more, are predicted.
fn cost(seen: Option<Symptom>, predicted: &[Symptom], more: Option<Symptom>) -> i64 {
    let count = predicted.len() + usize::from(more.is_some());
    let one_or_several = |[one, several]: [i64; 2]| if count == 1 { one } else { several };
    let mut all = predicted.iter().copied().chain(more);
    match seen {
        None if count == 0 => 0,
        None => one_or_several(PASSES),
        Some(_) if count == 0 => UNEXPLAINED,
        Some(seen) if all.clone().any(|symptom| symptom == seen) => 0,
        Some(seen) if all.any(|symptom| (symptom.step, symptom.place) == (seen.step, seen.place)) => {
            one_or_several(OTHER_VALUE)
        }
        Some(_) => one_or_several(ELSEWHERE),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dictionary::{Entry, Seen};

    const PLACE: Symptom = Symptom { step: 1, place: 1, value: 1 };
    const LATER: Symptom = Symptom { step: 3, place: 1, value: 1 };

    fn dictionary(entries: &[(&str, &[(u32, Symptom)])]) -> Dictionary {
        let entry = |(name, symptoms): &(&str, &[(u32, Symptom)])| Entry {
            name: (*name).to_owned(),
            words: String::new(),
            rules: Vec::new(),
            symptoms: symptoms.iter().map(|(key, symptom)| (CaseKey(*key), *symptom)).collect(),
        };
        Dictionary { corpus: String::new(), entries: entries.iter().map(entry).collect() }
    }

    /// A hundred cases in ten files, of which some fail.
    fn observed(failing: &[(u32, Symptom)]) -> Observed {
        let symptom = |key: u32| failing.iter().find(|(failing, _)| *failing == key).map(|(_, symptom)| *symptom);
        let seen = |key: u32| Seen { file: u16::try_from(key / 10).unwrap(), symptom: symptom(key) };
        Observed { cases: (0..100).map(|key| (CaseKey(key), seen(key))).collect() }
    }

    fn named(dictionary: &Dictionary, explanation: &Explanation) -> Vec<String> {
        let name = |defect: &Explained| {
            defect.entries.iter().map(|entry| dictionary.entries[*entry].name.clone()).collect::<Vec<_>>().join("|")
        };
        explanation.defects.iter().map(name).collect()
    }

    #[test]
    fn two_defects_are_named_also_where_one_breaks_cases_before_the_other_comes_to_its_own() {
        let first = [(1, PLACE), (2, PLACE), (3, PLACE)];
        let second = [(2, LATER), (3, LATER), (4, LATER), (50, LATER)];
        let known = dictionary(&[("first", &first), ("second", &second), ("third", &[(60, PLACE), (1, PLACE)])]);
        let seen = observed(&[(1, PLACE), (2, PLACE), (3, PLACE), (4, LATER), (50, LATER)]);
        let found = known.explain(&seen);
        assert_eq!(named(&known, &found), ["first", "second"]);
        assert_eq!(found.unexplained, []);
        assert_eq!(found.defects.iter().map(|defect| defect.cases.len()).sum::<usize>(), 5);
        // Where the first is not known, most of what fails beside the second is not its doing: no name is better than
        // a wrong one.
        let found = known.explain_without(&seen, &[0]);
        assert_eq!((found.defects.len(), found.unexplained.len()), (0, 5));
    }

    #[test]
    fn a_defect_that_explains_no_failing_case_of_its_own_is_not_named_for_the_cases_that_pass() {
        let whole: Vec<(u32, Symptom)> = (1..=20).map(|key| (key, PLACE)).collect();
        let part = [(1, PLACE), (19, PLACE), (20, PLACE)];
        let known = dictionary(&[("whole", &whole), ("part", &part)]);
        // The two cases that pass would speak less against both together than against the whole alone.
        let found = known.explain(&observed(&whole[..18]));
        assert_eq!(named(&known, &found), ["whole"]);
    }

    #[test]
    fn a_case_that_ends_otherwise_where_another_defect_shows_too_speaks_less_against_one() {
        let symptoms = |keys: &mut dyn Iterator<Item = u32>| keys.map(|key| (key, PLACE)).collect::<Vec<_>>();
        let (near, far) = (symptoms(&mut (0..16)), symptoms(&mut (0..15).chain([95])));
        let other = symptoms(&mut (16..40));
        let seen = observed(&symptoms(&mut (0..15).chain(16..40)));
        let names = |one: &[(u32, Symptom)]| {
            let known = dictionary(&[("one", one), ("other", &other)]);
            named(&known, &known.explain(&seen))
        };
        assert_eq!(names(&near), ["other", "one"]);
        // In the file of the case that passes nothing else is wrong.
        assert_eq!(names(&far), ["other"]);
    }

    #[test]
    fn what_no_known_defect_does_stays_unexplained() {
        let known = dictionary(&[("known", &[(1, PLACE), (2, PLACE), (3, PLACE)])]);
        // One of its cases passes; one fails elsewhere; all fail, and far more beside them.
        let passes = observed(&[(1, PLACE), (2, PLACE)]);
        let elsewhere = observed(&[(1, PLACE), (2, PLACE), (3, LATER)]);
        let beside = observed(&[1, 2, 3, 4, 5, 6, 7].map(|key| (key, PLACE)));
        for (seen, failing) in [(passes, 2), (elsewhere, 3), (beside, 7)] {
            let found = known.explain(&seen);
            assert_eq!((found.defects.len(), found.unexplained.len()), (0, failing));
        }
        // What fails in another file says nothing of it.
        let far = observed(&[(1, PLACE), (2, PLACE), (3, PLACE), (50, PLACE)]);
        assert_eq!(named(&known, &known.explain(&far)), ["known"]);
        assert_eq!(known.explain(&far).unexplained, [CaseKey(50)]);
    }

    #[test]
    fn defects_that_no_judged_case_tells_apart_are_named_together() {
        let known = dictionary(&[("a", &[(1, PLACE), (2, PLACE)]), ("b", &[(1, PLACE), (2, PLACE), (200, PLACE)])]);
        let found = known.explain(&observed(&[(1, PLACE), (2, PLACE)]));
        assert_eq!(named(&known, &found), ["a|b"]);
    }
}
