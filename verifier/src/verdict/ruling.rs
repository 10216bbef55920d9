//! Which rule a case that does not pass is charged to.

use std::collections::HashMap;
use std::sync::Arc;

use ncp_text::catalogue::Requirement;

use crate::check::Manner;
use crate::peer::Call;
use crate::run::{CaseRun, Outcome};
use crate::suite::Case;

/// What a case says of the rule that it is about: the first that it cites.
///
/// An answer can be wrong before it comes to that rule: at an earlier step of a trace, by a crash where a refusal is
/// asked for, or since the case rests on another that does not pass. The rule that is broken there is charged, and the
/// case is inconclusive for its own, as in TTCN-3.
///
/// A case of the corpus asks one thing, a case of the deep set many at once. So where cases of the corpus show that a
/// call breaks some rules, those of the deep set with that call add no other: they wait for one of these. And where
/// they show nothing of a call, it is what they show of the calls that are its parts, or of the frames that it reads.
/// Where they show nothing of those either, a case of the deep set waits for the rule to which most of its call are
/// charged, if it cites that.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Ruling {
    /// The peer keeps it, here.
    Passed,
    /// The peer breaks it.
    Failed {
        /// The rule: the first that the case cites.
        rule: Arc<Requirement>,
    },
    /// The peer breaks another, so that this one was not judged.
    Inconclusive {
        /// The rule that is broken. It is charged with the case.
        waits_for: Arc<Requirement>,
    },
    /// The peer has no such function, or cannot do a step of a trace.
    Unsupported {
        /// The rule of that step; none: it is the whole call.
        rule: Option<Arc<Requirement>>,
    },
    /// The case was not run.
    NotRun,
}

impl Ruling {
    /// As reports write it.
    #[must_use]
    pub fn as_str(&self) -> &'static str {
        match self {
            Self::Passed => "passed",
            Self::Failed { .. } => "failed",
            Self::Inconclusive { .. } => "inconclusive",
            Self::Unsupported { .. } => "unsupported",
            Self::NotRun => "not run",
        }
    }

    /// The rule that is broken, whether the case is about it or waits for it.
    #[must_use]
    pub fn charged(&self) -> Option<&Arc<Requirement>> {
        match self {
            Self::Failed { rule } | Self::Inconclusive { waits_for: rule } => Some(rule),
            Self::Passed | Self::Unsupported { .. } | Self::NotRun => None,
        }
    }

    /// The rule that is broken, or that is not judged since the peer cannot do its step.
    #[must_use]
    pub fn decided_by(&self) -> Option<&Arc<Requirement>> {
        match self {
            Self::Unsupported { rule } => rule.as_ref(),
            _ => self.charged(),
        }
    }

    /// The ruling of a case alone.
    fn of(case: &Case, outcome: &Outcome) -> Self {
        let charged = match outcome {
            Outcome::Pass => return Self::Passed,
            Outcome::Unsupported { step } => {
                let rule = step.as_ref().and_then(|step| case.by.at(step).or(case.requirements.first()));
                return Self::Unsupported { rule: rule.cloned() };
            }
            Outcome::NotRun { .. } => return Self::NotRun,
            Outcome::Fail(differences) => match differences.manner {
                Manner::Crash => case.by.crash.as_ref(),
                Manner::Refusal => case.by.refusal.as_ref(),
                Manner::Order => case.by.order.as_ref(),
                Manner::Value if differences.is_of_an_extra_member() => case.by.extra.as_ref(),
                Manner::Value => None,
            }
            .or_else(|| case.by.at(&differences.place)),
            Outcome::Crash { .. } | Outcome::Timeout { .. } | Outcome::Protocol { .. } => case.by.crash.as_ref(),
        };
        Self::charging(case, charged)
    }

    fn charging(case: &Case, charged: Option<&Arc<Requirement>>) -> Self {
        match (charged, case.requirements.first()) {
            (Some(waits_for), own) if own != Some(waits_for) => Self::Inconclusive { waits_for: Arc::clone(waits_for) },
            (_, Some(rule)) => Self::Failed { rule: Arc::clone(rule) },
            // No case is without a rule.
            (_, None) => Self::NotRun,
        }
    }
}

/// The rulings of cases, each in the light of those on which it rests.
pub(super) fn rulings(runs: &[(&Case, CaseRun)]) -> Vec<Ruling> {
    let alone: Vec<Ruling> = runs.iter().map(|(case, run)| Ruling::of(case, &run.outcome)).collect();
    let places: HashMap<&str, usize> = runs.iter().enumerate().map(|(i, (case, _))| (case.id.as_str(), i)).collect();
    let settle = |(place, ruling): (usize, &Ruling)| {
        let foundation = ruling.charged().and_then(|_| foundation(place, runs, &alone, &places));
        match (foundation, runs.get(place)) {
            (Some(rule), Some((case, _))) => Ruling::charging(case, Some(rule)),
            _ => ruling.clone(),
        }
    };
    let settled: Vec<Ruling> = alone.iter().enumerate().map(settle).collect();
    let by_corpus = Shown::of(runs, &settled, |case| !case.is_deep());
    let by_all = Shown::of(runs, &settled, |_| true);
    let wait = |((case, _), ruling): (&(&Case, CaseRun), Ruling)| match instead(&by_corpus, &by_all, case, &ruling) {
        Some(rule) => Ruling::charging(case, Some(rule)),
        None => ruling,
    };
    runs.iter().zip(settled).map(wait).collect()
}

/// What cases show of each call: the rules that it breaks, with how many cases are charged to each.
struct Shown(HashMap<Call, Vec<(Arc<Requirement>, usize)>>);

impl Shown {
    fn of(runs: &[(&Case, CaseRun)], rulings: &[Ruling], counts: impl Fn(&Case) -> bool) -> Self {
        let mut shown: HashMap<Call, Vec<(Arc<Requirement>, usize)>> = HashMap::new();
        for ((case, _), ruling) in runs.iter().zip(rulings).filter(|((case, _), _)| counts(case)) {
            let Some(rule) = ruling.charged() else { continue };
            let of_call = shown.entry(case.call).or_default();
            match of_call.iter_mut().find(|(known, _)| known == rule) {
                Some((_, count)) => *count += 1,
                None => of_call.push((Arc::clone(rule), 1)),
            }
        }
        Self(shown)
    }

    fn by(&self, call: Call) -> &[(Arc<Requirement>, usize)] {
        self.0.get(&call).map_or(&[], Vec::as_slice)
    }
}

/// The rule that a case of the deep set waits for: of those that are shown to be broken, one that it cites, and of
/// these one with most cases. What the corpus shows of its call counts first, then what it shows of the calls on
/// which that is built, then what the deep set shows of those, and at last what it shows of the call, where that is
/// more than of its own charge. None where its own charge is shown, or nothing is.
fn instead<'s>(by_corpus: &'s Shown, by_all: &'s Shown, case: &Case, ruling: &Ruling) -> Option<&'s Arc<Requirement>> {
    let charged = ruling.charged().filter(|_| case.is_deep())?;
    let of = |shown: &'s Shown, calls: &[Call]| -> Vec<&'s (Arc<Requirement>, usize)> {
        calls.iter().flat_map(|call| shown.by(*call)).collect()
    };
    let (parts, frames) = (parts(case.call), frames(case.call));
    let shown = [of(by_corpus, &[case.call]), of(by_corpus, parts), of(by_corpus, frames), of(by_all, parts)];
    let Some(shown) = shown.into_iter().find(|shown| !shown.is_empty()) else {
        let of_call = by_all.by(case.call);
        let own = of_call.iter().find(|(rule, _)| rule == charged).map_or(0, |(_, count)| *count);
        let cited = of_call.iter().rev().filter(|(rule, count)| *count > own && case.requirements.contains(rule));
        return cited.max_by_key(|(_, count)| *count).map(|(rule, _)| rule);
    };
    if shown.iter().any(|(rule, _)| rule == charged) {
        return None;
    }
    // Of equals the first.
    let worth = |(rule, count): &&&(Arc<Requirement>, usize)| (case.requirements.contains(rule), *count);
    shown.iter().rev().max_by_key(worth).map(|(rule, _)| rule)
}

/// The calls whose work a call shows within its own.
const fn parts(call: Call) -> &'static [Call] {
    match call {
        Call::LoopRun => &[Call::ReflexStep, Call::GovernorRun, Call::LinkRun],
        Call::Negotiate => &[Call::VersionCheck],
        Call::ObservationUnpack => &[Call::BulkDecode],
        Call::ReplyCheck | Call::SessionRun => &[Call::Decode, Call::VersionCheck, Call::KeyBuild],
        Call::BufferRun => &[Call::Decode, Call::WatchdogRun],
        _ => &[],
    }
}

/// The calls that show how frames are read and written, for one that reads or writes any.
const fn frames(call: Call) -> &'static [Call] {
    match call {
        Call::Decode => &[Call::Encode],
        Call::Encode => &[Call::Decode],
        Call::GovernorRun
        | Call::ReflexStep
        | Call::LoopRun
        | Call::CodecEncode
        | Call::CodecDecode
        | Call::BufferRun
        | Call::SessionRun => &[Call::Decode, Call::Encode],
        _ => &[],
    }
}

/// The rule of the lowest case that is broken, of those on which a case rests. The suite has no circles.
fn foundation<'a>(
    place: usize,
    runs: &[(&Case, CaseRun)],
    alone: &'a [Ruling],
    places: &HashMap<&str, usize>,
) -> Option<&'a Arc<Requirement>> {
    let rests_on = runs.get(place)?.0.rests_on.iter();
    rests_on.filter_map(|id| places.get(id.as_str())).find_map(|below| {
        let broken = alone.get(*below)?.charged()?;
        foundation(*below, runs, alone, places).or(Some(broken))
    })
}

#[cfg(test)]
mod tests {
    use ncp_text::catalogue::Role;

    use super::*;
    use crate::check::{Difference, Differences};
    use crate::suite::testing;

    const OWN: &str = "NCP-SAFE-008";
    const OTHER: &str = "NCP-SAFE-004";
    const THIRD: &str = "NCP-SAFE-005";

    fn rule(id: &str) -> Arc<Requirement> {
        Arc::clone(&testing::case("a", &[id], &[Role::Commander]).requirements[0])
    }

    fn case(id: &str, own: &str) -> Case {
        testing::case(id, &[own], &[Role::Commander])
    }

    fn fail(place: &str, manner: Manner) -> Outcome {
        let first = Difference { at: place.to_owned(), expected: None, got: None, hint: None };
        Outcome::Fail(Differences { first: vec![first], place: place.to_owned(), manner, more: 0 })
    }

    fn waits_for(id: &str) -> Ruling {
        Ruling::Inconclusive { waits_for: rule(id) }
    }

    #[test]
    fn a_case_is_charged_to_the_rule_of_the_deepest_place_that_holds_the_first_difference() {
        let mut case = case("a", OWN);
        case.by.places = vec![("/steps/1".to_owned(), rule(OTHER)), ("/steps/1/frame/mode".to_owned(), rule(THIRD))];
        let ruling = |place: &str| Ruling::of(&case, &fail(place, Manner::Value));
        assert_eq!(ruling("/steps/1/frame/seq"), waits_for(OTHER));
        assert_eq!(ruling("/steps/1/frame/mode"), waits_for(THIRD));
        for own in ["/steps/10", "/steps/3", "/steps", ""] {
            assert_eq!(ruling(own), Ruling::Failed { rule: rule(OWN) }, "{own}");
        }
    }

    #[test]
    fn a_step_that_the_peer_cannot_do_is_unsupported_for_the_rule_of_that_step() {
        let mut case = case("a", OWN);
        case.by.places = vec![("/steps/1".to_owned(), rule(OTHER))];
        let ruling = |step: Option<&str>| Ruling::of(&case, &Outcome::Unsupported { step: step.map(str::to_owned) });
        for (step, by) in [(Some("/steps/1"), Some(OTHER)), (Some("/steps/3"), Some(OWN)), (None, None)] {
            let ruling = ruling(step);
            assert_eq!(ruling, Ruling::Unsupported { rule: by.map(rule) });
            assert_eq!((ruling.decided_by().cloned(), ruling.charged()), (by.map(rule), None));
        }
    }

    #[test]
    fn a_star_is_any_token_and_a_place_within_is_any_but_the_whole() {
        let mut case = case("a", OWN);
        case.by.places = vec![("/steps/*/lost".to_owned(), rule(OTHER))];
        let ruling = |case: &Case, place: &str| Ruling::of(case, &fail(place, Manner::Value));
        let own = Ruling::Failed { rule: rule(OWN) };
        assert_eq!(ruling(&case, "/steps/12/lost"), waits_for(OTHER));
        assert_eq!(ruling(&case, "/steps/12/last_seq"), own);
        assert_eq!(ruling(&case, "/steps/lost"), own);
        case.by.within = Some(rule(THIRD));
        assert_eq!(ruling(&case, "/steps/12/lost"), waits_for(OTHER));
        assert_eq!(ruling(&case, "/steps/12/last_seq"), waits_for(THIRD));
        assert_eq!(ruling(&case, ""), own);
    }

    #[test]
    fn members_in_another_order_are_charged_to_the_rule_of_their_order() {
        let mut case = case("a", OWN);
        assert_eq!(Ruling::of(&case, &fail("", Manner::Order)), Ruling::Failed { rule: rule(OWN) });
        case.by.order = Some(rule(OTHER));
        assert_eq!(Ruling::of(&case, &fail("", Manner::Order)), waits_for(OTHER));
        assert_eq!(Ruling::of(&case, &fail("", Manner::Value)), Ruling::Failed { rule: rule(OWN) });
    }

    #[test]
    fn a_member_that_was_not_asked_for_is_charged_to_the_rule_against_it() {
        let mut case = case("a", OWN);
        case.by.extra = Some(rule(OTHER));
        let differing = |expected: Option<&str>, got: Option<&str>| {
            let [expected, got] = [expected, got].map(|text| text.map(str::to_owned));
            let first = vec![Difference { at: "/x".to_owned(), expected, got, hint: None }];
            Outcome::Fail(Differences { first, place: "/x".to_owned(), ..Differences::default() })
        };
        assert_eq!(Ruling::of(&case, &differing(None, Some("1"))), waits_for(OTHER));
        let own = Ruling::Failed { rule: rule(OWN) };
        assert_eq!(Ruling::of(&case, &differing(Some("1"), None)), own);
        assert_eq!(Ruling::of(&case, &differing(Some("1"), Some("2"))), own);
    }

    #[test]
    fn a_crash_and_a_refusal_are_charged_to_the_rules_against_them_where_there_are_any() {
        let mut case = case("a", OWN);
        let crash = Outcome::Crash { what: String::new(), log: String::new() };
        let own = Ruling::Failed { rule: rule(OWN) };
        for outcome in [crash.clone(), fail("", Manner::Crash), fail("", Manner::Refusal)] {
            assert_eq!(Ruling::of(&case, &outcome), own);
        }
        (case.by.crash, case.by.refusal) = (Some(rule(OTHER)), Some(rule(THIRD)));
        assert_eq!(Ruling::of(&case, &crash), waits_for(OTHER));
        assert_eq!(Ruling::of(&case, &fail("", Manner::Crash)), waits_for(OTHER));
        assert_eq!(Ruling::of(&case, &fail("", Manner::Refusal)), waits_for(THIRD));
        assert_eq!(Ruling::of(&case, &fail("", Manner::Value)), own);
    }

    #[test]
    fn a_case_that_fails_waits_for_the_rule_of_the_lowest_case_on_which_it_rests_that_fails_too() {
        let (base, mut middle, mut top) = (case("base", OTHER), case("middle", THIRD), case("top", OWN));
        middle.rests_on = vec!["base".to_owned()];
        top.rests_on = vec!["absent".to_owned(), "middle".to_owned()];
        let rulings_of = |outcomes: [Outcome; 3]| {
            let run = |outcome| CaseRun { outcome, answer: None, note: None };
            let runs: Vec<_> = [&top, &middle, &base].into_iter().zip(outcomes.map(run)).collect();
            rulings(&runs)
        };
        let wrong = || fail("", Manner::Value);
        let failed = |id| Ruling::Failed { rule: rule(id) };
        assert_eq!(rulings_of([wrong(), wrong(), wrong()]), [waits_for(OTHER), waits_for(OTHER), failed(OTHER)]);
        assert_eq!(rulings_of([wrong(), wrong(), Outcome::Pass]), [waits_for(THIRD), failed(THIRD), Ruling::Passed]);
        assert_eq!(rulings_of([Outcome::Pass, wrong(), wrong()]), [Ruling::Passed, waits_for(OTHER), failed(OTHER)]);
        // What passes shows that it can be judged, so that nothing above it waits for what lies below.
        assert_eq!(rulings_of([wrong(), Outcome::Pass, wrong()]), [failed(OWN), Ruling::Passed, failed(OTHER)]);
    }

    #[test]
    fn where_the_corpus_shows_what_a_call_breaks_the_deep_set_adds_no_other_rule() {
        let corpus = [case("one", OWN), case("other", OTHER), case("more", OTHER)];
        let mut cites = case("deep/cites", THIRD);
        cites.requirements.push(rule(OWN));
        let mut known = case("deep/known", OWN);
        known.requirements.push(rule(OTHER));
        let deep = [case("deep/new", THIRD), cites, known];
        let mut elsewhere = case("deep/elsewhere", THIRD);
        elsewhere.call = Call::KeyBuild;
        let rulings_of = |corpus_fails: bool| {
            let run = |fails: bool| {
                let outcome = if fails { fail("", Manner::Value) } else { Outcome::Pass };
                CaseRun { outcome, answer: None, note: None }
            };
            let failing = deep.iter().chain([&elsewhere]).map(|case| (case, run(true)));
            let runs: Vec<_> = corpus.iter().map(|case| (case, run(corpus_fails))).chain(failing).collect();
            rulings(&runs)[corpus.len()..].to_vec()
        };
        let failed = |id| Ruling::Failed { rule: rule(id) };
        assert_eq!(rulings_of(true), [waits_for(OTHER), waits_for(OWN), failed(OWN), failed(THIRD)]);
        assert_eq!(rulings_of(false), [failed(THIRD), failed(THIRD), failed(OWN), failed(THIRD)]);
    }

    #[test]
    fn a_deep_case_of_a_call_waits_for_what_is_shown_of_the_calls_within_it() {
        let of = |id: &str, own: &str, call: Call| {
            let mut case = case(id, own);
            case.call = call;
            case
        };
        let cases = [
            of("one", OWN, Call::LoopRun),
            of("deep/a", OTHER, Call::ReflexStep),
            of("deep/b", THIRD, Call::LoopRun),
            of("deep/c", OWN, Call::ReflexStep),
            of("frames", OWN, Call::Encode),
            of("deep/d", THIRD, Call::Decode),
            of("deep/e", OTHER, Call::Encode),
            of("reads", OWN, Call::Decode),
        ];
        let all = |fails: [bool; 8]| {
            let run = |fails: bool| {
                let outcome = if fails { fail("", Manner::Value) } else { Outcome::Pass };
                CaseRun { outcome, answer: None, note: None }
            };
            let runs: Vec<_> = cases.iter().zip(fails).map(|(case, fails)| (case, run(fails))).collect();
            rulings(&runs)
        };
        let rulings_of = |[a, b, c, d]: [bool; 4]| all([a, b, c, d, false, false, false, false]).swap_remove(2);
        let own = Ruling::Failed { rule: rule(THIRD) };
        assert_eq!(rulings_of([false, true, true, false]), waits_for(OTHER));
        // What the corpus shows of the call itself comes first, and nothing waits for what passes.
        assert_eq!(rulings_of([true, true, true, false]), waits_for(OWN));
        assert_eq!(rulings_of([false, false, true, false]), own);
        assert_eq!(rulings_of([false, true, false, true]), Ruling::Passed);
        // Frames that are written wrongly show in what is read, and the other way round, by the corpus; of two finds of
        // the deep set neither waits for the other.
        let of_frames = |encode, decode| {
            all([false, false, false, false, encode, true, true, decode]).get(5..7).map(<[_]>::to_vec).unwrap()
        };
        assert_eq!(of_frames(true, false), [waits_for(OWN), waits_for(OWN)]);
        assert_eq!(of_frames(false, true), [waits_for(OWN), waits_for(OWN)]);
        assert_eq!(of_frames(false, false), [own, Ruling::Failed { rule: rule(OTHER) }]);
    }

    #[test]
    fn where_the_deep_set_alone_shows_what_a_call_breaks_a_case_waits_for_the_rule_of_most_that_it_cites() {
        let citing = |id: &str, own: &str, others: &[&str]| {
            let mut case = case(id, own);
            case.requirements.extend(others.iter().map(|other| rule(other)));
            case
        };
        let cases = [
            citing("deep/a", OWN, &[THIRD]),
            citing("deep/b", OWN, &[THIRD, OTHER]),
            citing("deep/c", OTHER, &[OWN]),
            citing("deep/d", THIRD, &[OTHER]),
        ];
        let wrong = || CaseRun { outcome: fail("", Manner::Value), answer: None, note: None };
        let runs: Vec<_> = cases.iter().map(|case| (case, wrong())).collect();
        let failed = |id| Ruling::Failed { rule: rule(id) };
        // The last cites another of as few cases as its own.
        assert_eq!(rulings(&runs), [failed(OWN), failed(OWN), waits_for(OWN), failed(THIRD)]);
    }
}
