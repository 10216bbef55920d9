//! From outcomes to a verdict.
//!
//! [`judge`] folds what became of the cases into one [`Verdict`] a peer: levels per role, under the peer's list of
//! expected failures. A role holds at a level when every binding case of that role, up to that level, passed. A case
//! that does not pass is charged to one rule, and only to that: see [`Ruling`].

mod baseline;
mod described;
mod ruling;

pub use baseline::{Baseline, BaselineError};
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
    /// Expected failures that no longer fail, as they are listed.
    pub stale: Vec<String>,
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
            let reason = baseline.reason(case).map(str::to_owned);
            let status = status(case, &run.outcome, reason.is_some(), baseline.names(case));
            Judged { case, run, status, ruling, reason }
        })
        .collect();
    let stale = baseline.stale(&cases, partial);
    let roles: Vec<_> = roles.iter().filter_map(|(role, claimed)| judge_role(*role, *claimed, level, &cases)).collect();
    let reached = |judge: fn(&LevelVerdict) -> bool| {
        !roles.is_empty() && roles.iter().all(|role| role.levels.last().is_some_and(judge))
    };
    let conclusion = if !stale.is_empty() {
        Conclusion::NotConformant
    } else if reached(|level| level.conformant) {
        Conclusion::Conformant
    } else if reached(|level| level.as_expected) {
        Conclusion::AsExpected
    } else {
        Conclusion::NotConformant
    };
    Verdict { roles, cases, stale, conclusion }
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
        (verdict.conclusion, verdict.roles, statuses, verdict.stale)
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
            Outcome::Unsupported,
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
}
