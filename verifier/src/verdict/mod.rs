//! From outcomes to a verdict.
//!
//! [`judge`] folds what became of the cases into one [`Verdict`] a peer: levels per role, under the peer's list of
//! expected failures. A role holds at a level when every binding case of that role, up to that level, passed. A case
//! that does not pass is charged to one rule, and only to that: see [`Ruling`].

mod baseline;
mod described;
mod ruling;

pub use baseline::{Baseline, BaselineError, Excuse};
pub use described::judge_description;
pub use ruling::Ruling;

use ncp_text::catalogue::{Level, Role};

use crate::run::{CaseRun, Outcome, OutcomeKind};
use crate::suite::Case;

/// What a case counts for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Status {
    /// It passed.
    Passed,
    /// It did not pass, and decides the verdict: a rule that it cites is a MUST, or the peer crashed or hung.
    Failed,
    /// It did not pass, but cites only SHOULD and MAY rules.
    Advice,
    /// It did not pass, and was known not to.
    ExpectedFailure,
    /// It passed, though it is listed as an expected failure.
    UnexpectedPass,
    /// It was not run.
    NotRun,
}

impl Status {
    /// As reports write it.
    #[must_use]
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Passed => "passed",
            Self::Failed => "failed",
            Self::Advice => "advice",
            Self::ExpectedFailure => "expected failure",
            Self::UnexpectedPass => "unexpected pass",
            Self::NotRun => "not run",
        }
    }
}

/// A case with what became of it.
#[derive(Debug)]
pub struct Judged<'s> {
    /// The case.
    pub case: &'s Case,
    /// What became of it.
    pub run: CaseRun,
    /// What it counts for.
    pub status: Status,
    /// What it says of the rule that it is about.
    pub ruling: Ruling,
    /// Why it was expected to fail, if it was.
    pub reason: Option<String>,
}

/// Whether a case was answered by `unsupported`, and not expected to be.
#[must_use]
pub fn is_unsupported(outcome: OutcomeKind, status: Status) -> bool {
    outcome == OutcomeKind::Unsupported && matches!(status, Status::Failed | Status::Advice)
}

/// How many cases count for what.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Tally {
    /// Passed, unexpectedly or not.
    pub passed: usize,
    /// Failed.
    pub failed: usize,
    /// Differ from advice.
    pub advice: usize,
    /// Failed as expected.
    pub expected_failures: usize,
    /// Not run.
    pub not_run: usize,
}

impl Tally {
    /// All cases.
    #[must_use]
    pub fn total(self) -> usize {
        self.passed + self.failed + self.advice + self.expected_failures + self.not_run
    }

    fn count(&mut self, status: Status) {
        *match status {
            Status::Passed | Status::UnexpectedPass => &mut self.passed,
            Status::Failed => &mut self.failed,
            Status::Advice => &mut self.advice,
            Status::ExpectedFailure => &mut self.expected_failures,
            Status::NotRun => &mut self.not_run,
        } += 1;
    }
}

/// One role at one level.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LevelVerdict {
    /// The level.
    pub level: Level,
    /// The cases of exactly this level.
    pub tally: Tally,
    /// Whether the role conforms at this level, and so at all below it.
    pub conformant: bool,
    /// Whether everything that keeps it from conforming was expected to fail.
    pub as_expected: bool,
}

/// One role.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RoleVerdict {
    /// The role.
    pub role: Role,
    /// Whether the peer claims it, or it is judged because it was asked for.
    pub claimed: bool,
    /// The levels from the lowest that has a case of the role; one above it may have none.
    pub levels: Vec<LevelVerdict>,
}

/// What a peer is found to be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Conclusion {
    /// Every judged role conforms at the level that was asked for.
    Conformant,
    /// It does not conform, but nothing failed that was not expected to.
    AsExpected,
    /// It does not conform.
    NotConformant,
}

impl Conclusion {
    /// As reports write it.
    #[must_use]
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Conformant => "conformant",
            Self::AsExpected => "as expected",
            Self::NotConformant => "not conformant",
        }
    }
}

/// The verdict on one peer.
#[derive(Debug)]
pub struct Verdict<'s> {
    /// The roles that were judged.
    pub roles: Vec<RoleVerdict>,
    /// Every case.
    pub cases: Vec<Judged<'s>>,
    /// What became of the expected failures.
    pub excuses: Vec<Excuse>,
    /// All in all.
    pub conclusion: Conclusion,
}

/// Judges a peer: what became of its cases, for the roles in question up to `level`.
///
/// `roles` pairs each role with whether the peer claims it. `partial` says that not all cases of the roles were run,
/// so that an expected failure of a whole rule cannot be called stale.
#[must_use]
pub fn judge<'s>(
    runs: impl IntoIterator<Item = (&'s Case, CaseRun)>,
    roles: &[(Role, bool)],
    level: Level,
    baseline: &Baseline,
    partial: bool,
) -> Verdict<'s> {
    let runs: Vec<_> = runs.into_iter().collect();
    let cases: Vec<Judged<'s>> = ruling::rulings(&runs)
        .into_iter()
        .zip(runs)
        .map(|(ruling, (case, run))| {
            let reason = baseline.reason(case, &run.outcome, &ruling).map(str::to_owned);
            let status = status(case, &run.outcome, reason.is_some(), baseline.names(case));
            Judged { case, run, status, ruling, reason }
        })
        .collect();
    let excuses = baseline.excuses(&cases, partial);
    let untrue = |excuse: &Excuse| excuse.stale || !excuse.stale_cases.is_empty() || excuse.expired.is_some();
    let roles: Vec<_> = roles.iter().filter_map(|(role, claimed)| judge_role(*role, *claimed, level, &cases)).collect();
    let reached = |judge: fn(&LevelVerdict) -> bool| {
        !roles.is_empty() && roles.iter().all(|role| role.levels.last().is_some_and(judge))
    };
    let conclusion = if excuses.iter().any(untrue) {
        Conclusion::NotConformant
    } else if reached(|level| level.conformant) {
        Conclusion::Conformant
    } else if reached(|level| level.as_expected) {
        Conclusion::AsExpected
    } else {
        Conclusion::NotConformant
    };
    Verdict { roles, cases, excuses, conclusion }
}

/// What a case counts for. `listed`: an expected failure covers it; `named`: by its own id.
fn status(case: &Case, outcome: &Outcome, listed: bool, named: bool) -> Status {
    match outcome {
        Outcome::NotRun { .. } => Status::NotRun,
        Outcome::Pass if named => Status::UnexpectedPass,
        Outcome::Pass => Status::Passed,
        _ if listed => Status::ExpectedFailure,
        _ if decides(case, outcome) => Status::Failed,
        _ => Status::Advice,
    }
}

/// Whether a case that does not pass decides the verdict. A SHOULD leaves open what to answer, but not whether: a peer
/// that crashes or hangs is not doing otherwise for a good reason.
fn decides(case: &Case, outcome: &Outcome) -> bool {
    case.binding || outcome.kind().is_fault()
}

/// Judges a role level by level; `None` if it has no case.
fn judge_role(role: Role, claimed: bool, asked: Level, cases: &[Judged<'_>]) -> Option<RoleVerdict> {
    let mut levels = Vec::new();
    let (mut conformant, mut as_expected) = (true, true);
    for level in Level::ALL.into_iter().filter(|level| *level <= asked) {
        let mut tally = Tally::default();
        for judged in cases.iter().filter(|judged| judged.case.level == level && judged.case.roles.contains(&role)) {
            tally.count(judged.status);
            if decides(judged.case, &judged.run.outcome) {
                let passed = matches!(judged.status, Status::Passed | Status::UnexpectedPass);
                conformant &= passed;
                as_expected &= passed || judged.status == Status::ExpectedFailure;
            }
        }
        // A level that asks nothing of a role of its own is reached with the level below.
        let reached = !levels.is_empty() && cases.iter().any(|judged| judged.case.level == level);
        if tally.total() > 0 || reached {
            levels.push(LevelVerdict { level, tally, conformant, as_expected });
        }
    }
    (!levels.is_empty()).then_some(RoleVerdict { role, claimed, levels })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::Differences;
    use crate::peer::ExpectedFailure;
    use crate::suite::testing;

    fn run(outcome: Outcome) -> CaseRun {
        CaseRun { outcome, answer: None, note: None }
    }

    fn fail() -> Outcome {
        Outcome::Fail(Differences::default())
    }

    /// Judges cases `(id, rule, roles, outcome)` of the test suite.
    fn verdict(
        cases: &[(&str, &str, &[Role], Outcome)],
        listed: &[(&str, &str)],
    ) -> (Conclusion, Vec<RoleVerdict>, Vec<Status>, Vec<String>) {
        let built: Vec<_> = cases.iter().map(|(id, rule, roles, _)| testing::case(id, &[rule], roles)).collect();
        let baseline = testing::baseline(listed);
        let runs = built.iter().zip(cases).map(|(case, (.., outcome))| (case, run(outcome.clone())));
        let roles = [(Role::Body, true), (Role::Server, true)];
        let verdict = judge(runs, &roles, Level::Wire, &baseline, false);
        let statuses = verdict.cases.iter().map(|judged| judged.status).collect();
        let stale = verdict.excuses.into_iter().filter(|excuse| excuse.stale).map(|excuse| excuse.entry);
        (verdict.conclusion, verdict.roles, statuses, stale.collect())
    }

    const MUST: &str = "NCP-WIRE-010";
    const SHOULD: &str = "NCP-WIRE-008";

    #[test]
    fn a_level_that_asks_nothing_of_a_role_is_reached_with_the_one_below() {
        let wire = testing::case("a", &[MUST], &[Role::Body, Role::Observer]);
        let safety = testing::case("b", &["NCP-SAFE-001"], &[Role::Body]);
        let observer = |of_wire: Outcome| {
            let runs = [(&wire, run(of_wire)), (&safety, run(Outcome::Pass))];
            let roles = [(Role::Body, true), (Role::Observer, true)];
            let verdict = judge(runs, &roles, Level::Strict, &testing::baseline(&[]), false);
            let levels = verdict.roles[1].levels.iter();
            levels.map(|level| (level.level, level.tally.total(), level.conformant)).collect::<Vec<_>>()
        };
        let good = [(Level::Wire, 1, true), (Level::Safety, 0, true)];
        assert_eq!(observer(Outcome::Pass), good);
        let bad = [(Level::Wire, 1, false), (Level::Safety, 0, false)];
        assert_eq!(observer(fail()), bad);
    }

    #[test]
    fn a_role_conforms_when_all_its_binding_cases_pass() {
        let (conclusion, roles, ..) = verdict(
            &[("a", MUST, &[Role::Body], Outcome::Pass), ("b", MUST, &[Role::Body, Role::Server], Outcome::Pass)],
            &[],
        );
        assert_eq!(conclusion, Conclusion::Conformant);
        assert_eq!(
            roles.iter().map(|r| (r.role, r.levels[0].tally.passed)).collect::<Vec<_>>(),
            [(Role::Body, 2), (Role::Server, 1)]
        );
    }

    #[test]
    fn whatever_is_not_a_pass_keeps_its_roles_from_conforming_and_no_other() {
        for outcome in [
            fail(),
            Outcome::Unsupported { step: None },
            Outcome::Unsupported { step: Some("/steps/0".to_owned()) },
            Outcome::NotRun { why: String::new() },
            Outcome::Crash { what: String::new(), log: String::new() },
            Outcome::Timeout { what: String::new(), log: String::new() },
            Outcome::Protocol { what: String::new(), log: String::new() },
        ] {
            let (conclusion, roles, ..) =
                verdict(&[("a", MUST, &[Role::Body], outcome), ("b", MUST, &[Role::Server], Outcome::Pass)], &[]);
            assert_eq!(conclusion, Conclusion::NotConformant);
            assert_eq!(roles.iter().map(|r| r.levels[0].conformant).collect::<Vec<_>>(), [false, true]);
        }
    }

    #[test]
    fn a_case_of_advice_alone_never_decides() {
        let (conclusion, _, statuses, _) =
            verdict(&[("a", SHOULD, &[Role::Body], fail()), ("b", MUST, &[Role::Body], Outcome::Pass)], &[]);
        assert_eq!((conclusion, statuses), (Conclusion::Conformant, vec![Status::Advice, Status::Passed]));
    }

    #[test]
    fn a_crash_decides_also_where_the_rule_is_advice() {
        let crash = Outcome::Crash { what: String::new(), log: String::new() };
        let (conclusion, _, statuses, _) = verdict(&[("a", SHOULD, &[Role::Body], crash)], &[]);
        assert_eq!((conclusion, statuses), (Conclusion::NotConformant, vec![Status::Failed]));
    }

    #[test]
    fn a_role_without_cases_is_not_judged_and_no_role_is_not_conformant() {
        let (_, roles, ..) = verdict(&[("a", MUST, &[Role::Body], Outcome::Pass)], &[]);
        assert_eq!(roles.len(), 1);
        let (conclusion, roles, ..) = verdict(&[], &[]);
        assert!(roles.is_empty());
        assert_eq!(conclusion, Conclusion::NotConformant);
    }

    #[test]
    fn an_expected_failure_is_not_conformant_but_as_expected() {
        let (conclusion, roles, statuses, stale) = verdict(&[("a", MUST, &[Role::Body], fail())], &[("case", "a")]);
        assert_eq!((conclusion, statuses), (Conclusion::AsExpected, vec![Status::ExpectedFailure]));
        assert!(!roles[0].levels[0].conformant && stale.is_empty());
    }

    #[test]
    fn an_expected_failure_that_passes_fails_the_run() {
        let (conclusion, _, statuses, stale) = verdict(&[("a", MUST, &[Role::Body], Outcome::Pass)], &[("case", "a")]);
        assert_eq!((conclusion, statuses), (Conclusion::NotConformant, vec![Status::UnexpectedPass]));
        assert_eq!(stale, ["case a"]);
    }

    #[test]
    fn an_expected_rule_is_stale_only_when_none_of_its_cases_fails() {
        let case = |outcome: Outcome| ("a", MUST, &[Role::Body][..], outcome);
        let other = ("b", MUST, &[Role::Body][..], Outcome::Pass);
        let (conclusion, _, statuses, stale) = verdict(&[case(fail()), other.clone()], &[("requirement", MUST)]);
        assert_eq!((conclusion, stale.len()), (Conclusion::AsExpected, 0));
        assert_eq!(statuses, [Status::ExpectedFailure, Status::Passed]);
        let (conclusion, _, _, stale) = verdict(&[case(Outcome::Pass), other], &[("requirement", MUST)]);
        assert_eq!((conclusion, stale), (Conclusion::NotConformant, vec![format!("requirement {MUST}")]));
    }

    /// What becomes of one entry, when these cases have these outcomes.
    fn excused(entry: ExpectedFailure, cases: &[(&str, &str, Outcome)], today: &str) -> (Conclusion, Excuse) {
        let built: Vec<_> = cases.iter().map(|(id, rule, _)| testing::case(id, &[rule], &[Role::Body])).collect();
        let runs = built.iter().zip(cases).map(|(case, (.., outcome))| (case, run(outcome.clone())));
        let baseline = Baseline::unchecked(vec![entry], today);
        let verdict = judge(runs, &[(Role::Body, true)], Level::Wire, &baseline, false);
        (verdict.conclusion, verdict.excuses.into_iter().next().unwrap())
    }

    fn entry() -> ExpectedFailure {
        ExpectedFailure { requirement: Some(MUST.into()), reason: "known".into(), ..ExpectedFailure::default() }
    }

    #[test]
    fn an_entry_excuses_what_fails_by_its_rule_with_its_outcome_among_its_cases_and_nothing_else() {
        let crash = || Outcome::Crash { what: String::new(), log: String::new() };
        let other = "NCP-WIRE-011";
        let cases = [("a", MUST, crash()), ("b", MUST, fail()), ("c", other, crash())];
        let count = |entry: ExpectedFailure| excused(entry, &cases, "").1.cases;
        assert_eq!(count(entry()), 2);
        assert_eq!(count(ExpectedFailure { outcome: Some("crash".into()), ..entry() }), 1);
        assert_eq!(count(ExpectedFailure { cases: vec!["b".into(), "c".into()], ..entry() }), 1);
        let crashes = ExpectedFailure { outcome: Some("crash".into()), requirement: None, ..entry() };
        assert_eq!(count(crashes), 2);
    }

    #[test]
    fn an_entry_fails_the_run_from_the_day_after_it_expires() {
        let until = ExpectedFailure { expires: Some("2026-12-31".into()), ..entry() };
        let cases = [("a", MUST, fail())];
        let (conclusion, excuse) = excused(until.clone(), &cases, "2026-12-31");
        assert_eq!((conclusion, excuse.expired), (Conclusion::AsExpected, None));
        let (conclusion, excuse) = excused(until, &cases, "2027-01-01");
        assert_eq!((conclusion, excuse.expired.as_deref()), (Conclusion::NotConformant, Some("2026-12-31")));
    }

    #[test]
    fn an_entry_that_excuses_more_than_when_it_was_written_is_too_broad() {
        let cases = [("a", MUST, fail()), ("b", MUST, fail())];
        for (written, broad) in [(Some(1), true), (Some(2), false), (None, false)] {
            let (conclusion, excuse) = excused(ExpectedFailure { excuses: written, ..entry() }, &cases, "");
            assert_eq!((conclusion, excuse.is_too_broad()), (Conclusion::AsExpected, broad));
        }
    }

    #[test]
    fn a_case_that_is_named_and_passes_or_fails_in_another_way_is_stale() {
        let both = || ExpectedFailure { cases: vec!["a".into(), "b".into()], ..entry() };
        let (conclusion, excuse) = excused(both(), &[("a", MUST, fail()), ("b", MUST, Outcome::Pass)], "");
        assert_eq!(
            (conclusion, excuse.stale, excuse.stale_cases),
            (Conclusion::NotConformant, false, vec!["b".into()])
        );
        let crashes = ExpectedFailure { outcome: Some("crash".into()), ..both() };
        let (conclusion, excuse) = excused(crashes, &[("a", MUST, fail()), ("b", MUST, fail())], "");
        assert_eq!((conclusion, excuse.stale, excuse.stale_cases.len()), (Conclusion::NotConformant, true, 2));
        // What was not run says nothing.
        let not_run = Outcome::NotRun { why: String::new() };
        let (_, excuse) = excused(both(), &[("a", MUST, not_run), ("b", MUST, fail())], "");
        assert!(!excuse.stale && excuse.stale_cases.is_empty());
    }
}
