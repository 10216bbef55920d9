//! From a verdict to what is most likely broken.
//!
//! A case that does not pass is charged to one rule: to that which it is about, or to the one that it waits for (see
//! [`Ruling`](crate::verdict::Ruling)). [`by_rule`] gathers cases by it; [`likeliest_first`] also ranks the rules.

use std::collections::HashMap;

use crate::verdict::Judged;

/// Cases that are charged to one rule, those first that are about it and that a reader takes in.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Suspect {
    /// The rule.
    pub rule: String,
    /// The places of the cases among all that were judged; never empty.
    pub cases: Vec<usize>,
}

/// The picked cases by their rule, in the order in which the rules first occur.
pub fn by_rule(cases: &[Judged<'_>], picked: impl Fn(&Judged<'_>) -> bool) -> Vec<Suspect> {
    let mut suspects: Vec<Suspect> = Vec::new();
    for (place, judged) in cases.iter().enumerate().filter(|(_, judged)| picked(judged)) {
        let rule = charged_to(judged);
        match suspects.iter_mut().find(|suspect| suspect.rule == rule) {
            Some(suspect) => suspect.cases.push(place),
            None => suspects.push(Suspect { rule: rule.to_owned(), cases: vec![place] }),
        }
    }
    for suspect in &mut suspects {
        // A frame of 64 KiB explains nothing that a short one does not.
        suspect.cases.sort_by_key(|place| {
            let judged = cases.get(*place);
            judged.map(|judged| (rule_of(judged) != suspect.rule, judged.case.is_large()))
        });
    }
    suspects
}

/// The rules of the picked cases, which fail: those that the peer most likely breaks first.
///
/// A case of the corpus asks one thing, a case of the deep set many at once: so the rules that a case of the corpus
/// names come first, and go by the cases of the corpus alone. What is broken at a level also fails cases of the levels
/// above it, and hardly the other way round: so of these the lowest level comes first. Within a level it goes by how
/// many of a rule's cases fail, times the share of all its cases that they are: a defect fails many cases of its own
/// rule, and some of others in passing. Rules that only cases of the deep set name follow by the number of these cases.
pub fn likeliest_first(cases: &[Judged<'_>], picked: impl Fn(&Judged<'_>) -> bool) -> Vec<Suspect> {
    let mut all: HashMap<&str, usize> = HashMap::new();
    for judged in cases.iter().filter(|judged| !judged.case.is_deep()) {
        *all.entry(rule_of(judged)).or_default() += 1;
    }
    let rank = |suspect: &Suspect| {
        let failing = || suspect.cases.iter().filter_map(|place| cases.get(*place));
        let of_corpus = || failing().filter(|judged| !judged.case.is_deep());
        let fail = of_corpus().count() as f64;
        let weight = fail * fail / all.get(suspect.rule.as_str()).map_or(1.0, |all| *all as f64);
        let level = of_corpus().map(|judged| judged.case.level).min();
        (level.is_none(), level, if level.is_some() { weight } else { failing().count() as f64 })
    };
    let mut suspects: Vec<_> = by_rule(cases, picked).into_iter().map(|suspect| (rank(&suspect), suspect)).collect();
    // Stable: rules of one weight keep the order in which they first occur.
    suspects.sort_by(|((deep, level, weight), _), ((other_deep, other_level, other), _)| {
        (deep, level).cmp(&(other_deep, other_level)).then_with(|| other.total_cmp(weight))
    });
    suspects.into_iter().map(|(_, suspect)| suspect).collect()
}

fn charged_to<'c>(judged: &'c Judged<'_>) -> &'c str {
    judged.ruling.charged().map_or(rule_of(judged), |rule| rule.id.as_str())
}

fn rule_of<'c>(judged: &Judged<'c>) -> &'c str {
    judged.case.requirements.first().map_or("", |rule| rule.id.as_str())
}

#[cfg(test)]
mod tests {
    use ncp_text::catalogue::Role;

    use super::*;
    use crate::check::Differences;
    use crate::run::{CaseRun, Outcome};
    use crate::suite::{Case, testing};
    use crate::verdict::{Ruling, Status};

    /// A case about a rule, which fails or passes.
    fn judged(case: &Case, fails: bool) -> Judged<'_> {
        let rule = case.requirements[0].clone();
        let (outcome, status, ruling) = match fails {
            true => (Outcome::Fail(Differences::default()), Status::Failed, Ruling::Failed { rule }),
            false => (Outcome::Pass, Status::Passed, Ruling::Passed),
        };
        Judged { case, run: CaseRun { outcome, answer: None, note: None }, status, ruling, reason: None }
    }

    #[test]
    fn the_rule_most_of_whose_cases_fail_comes_first_at_the_lowest_level_that_fails() {
        let also = "NCP-WIRE-001";
        let of = |rule| testing::case(rule, &[rule, also], &[Role::Body]);
        let [one, few, most, tie] = ["NCP-WIRE-002", "NCP-WIRE-003", "NCP-WIRE-004", "NCP-WIRE-005"].map(of);
        let above = of("NCP-SAFE-001");
        let counts = [(&above, 50, 0), (&one, 1, 0), (&few, 6, 94), (&most, 4, 1), (&tie, 1, 0)];
        let mut cases = Vec::new();
        for (case, failing, passing) in counts {
            cases.extend((0..failing).map(|_| judged(case, true)));
            cases.extend((0..passing).map(|_| judged(case, false)));
        }
        let failed = |judged: &Judged<'_>| judged.status == Status::Failed;
        let order = |suspects: Vec<Suspect>| suspects.into_iter().map(|suspect| suspect.rule).collect::<Vec<_>>();
        assert_eq!(order(by_rule(&cases, failed)), [&above, &one, &few, &most, &tie].map(|case| case.id.as_str()));
        let ranked = order(likeliest_first(&cases, failed));
        assert_eq!(ranked, [&most, &one, &tie, &few, &above].map(|case| case.id.as_str()));
    }

    #[test]
    fn of_a_rule_its_own_cases_come_first_and_of_these_those_that_a_reader_takes_in() {
        let rule = "NCP-WIRE-002";
        let large = testing::large("large", rule, 100_000);
        let small = testing::case("small", &[rule], &[Role::Body]);
        let other = testing::case("other", &["NCP-WIRE-003"], &[Role::Body]);
        let mut waits = judged(&other, true);
        waits.ruling = Ruling::Failed { rule: small.requirements[0].clone() };
        let cases = [waits, judged(&large, true), judged(&small, true)];
        let [suspect] = &by_rule(&cases, |_| true)[..] else { panic!() };
        assert_eq!(suspect.cases, [2, 1, 0]);
    }

    #[test]
    fn a_rule_that_a_case_of_the_corpus_names_comes_before_those_of_the_deep_set() {
        let deep = |id, rule| testing::case(id, &[rule], &[Role::Body]);
        let corpus = |rule| testing::case(rule, &[rule], &[Role::Body]);
        let (one, other) = (corpus("NCP-WIRE-002"), corpus("NCP-WIRE-003"));
        let (both, only) = (deep("deep/a", "NCP-WIRE-002"), deep("deep/b", "NCP-WIRE-004"));
        // One of 2 fails of the corpus, where all that the deep set asks of the rule fail; of the other 2 of 3.
        let counts = [(&both, 9, 0), (&only, 9, 0), (&one, 1, 1), (&other, 2, 1)];
        let cases: Vec<_> = counts
            .iter()
            .flat_map(|(case, failing, passing)| (0..failing + passing).map(|n| judged(case, n < *failing)))
            .collect();
        let failed = |judged: &Judged<'_>| judged.status == Status::Failed;
        let ranked: Vec<_> = likeliest_first(&cases, failed).into_iter().map(|suspect| suspect.rule).collect();
        assert_eq!(ranked, ["NCP-WIRE-003", "NCP-WIRE-002", "NCP-WIRE-004"]);
    }
}
