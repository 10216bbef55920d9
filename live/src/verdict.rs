//! What a scenario found: a verdict a rule, never more certain than what was measured.

use std::collections::BTreeMap;
use std::fmt;

use serde::Serialize;

/// What is said of a rule.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Verdict {
    /// Something was observed that the rule asks for, and nothing that it forbids.
    Passed,
    /// Nothing was observed that could show it, or the machine was too noisy to tell.
    Inconclusive,
    /// Something was observed that the rule forbids.
    Failed,
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Passed => "passed",
            Self::Inconclusive => "inconclusive",
            Self::Failed => "failed",
        })
    }
}

/// What was measured for a verdict about time, in ms.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub(crate) struct Measured {
    /// How many times it was measured.
    pub(crate) count: usize,
    /// The smallest.
    pub(crate) min_ms: f64,
    /// The middle one.
    pub(crate) median_ms: f64,
    /// The largest.
    pub(crate) max_ms: f64,
    /// What a measurement may deviate by before it says something.
    pub(crate) tolerance_ms: f64,
}

impl Measured {
    /// The distribution of some times; none of no times.
    pub(crate) fn of(mut times_ms: Vec<f64>, tolerance_ms: f64) -> Option<Self> {
        times_ms.sort_by(f64::total_cmp);
        let (min_ms, max_ms) = (*times_ms.first()?, *times_ms.last()?);
        let median_ms = *times_ms.get(times_ms.len() / 2)?;
        Some(Self { count: times_ms.len(), min_ms, median_ms, max_ms, tolerance_ms })
    }
}

impl fmt::Display for Measured {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { count, min_ms, median_ms, max_ms, tolerance_ms } = self;
        write!(
            f,
            "{count} measured: {min_ms:.1} to {max_ms:.1} ms, median {median_ms:.1} ms, tolerance {tolerance_ms:.1} ms"
        )
    }
}

/// The verdict on one rule in one scenario.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct Ruling {
    /// The scenario.
    pub(crate) scenario: String,
    /// The rule.
    pub(crate) rule: String,
    /// The verdict.
    pub(crate) verdict: Verdict,
    /// How many observations passed.
    pub(crate) observed: usize,
    /// How many failed.
    pub(crate) violations: usize,
    /// What decided it, unless it passed; the first such thing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) why: Option<String>,
    /// What was measured.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) measured: Option<Measured>,
    /// The rule's sentence.
    pub(crate) sentence: String,
}

/// Collects the observations of a scenario on the rules that it is about.
#[derive(Debug)]
pub(crate) struct Rulings {
    of: BTreeMap<String, Found>,
}

#[derive(Debug, Default)]
struct Found {
    passed: usize,
    violations: usize,
    failed: Option<String>,
    unclear: Option<String>,
    measured: Option<Measured>,
}

impl Rulings {
    /// Nothing is observed yet on any of the rules.
    pub(crate) fn new(rules: &[String]) -> Self {
        Self { of: rules.iter().map(|rule| (rule.clone(), Found::default())).collect() }
    }

    /// An observation that is as the rule asks, or is not, for a reason that is made only then. What a scenario is not
    /// about, it does not judge.
    pub(crate) fn observe(&mut self, rule: &str, is_so: bool, why_not: impl FnOnce() -> String) {
        let Some(found) = self.of.get_mut(rule) else { return };
        if is_so {
            found.passed += 1;
        } else {
            found.violations += 1;
            found.failed.get_or_insert_with(why_not);
        }
    }

    /// An observation that breaks a rule.
    pub(crate) fn fail(&mut self, rule: &str, why: impl Into<String>) {
        self.observe(rule, false, || why.into());
    }

    /// Something kept an observation from being made.
    pub(crate) fn unclear(&mut self, rule: &str, why: impl Into<String>) {
        if let Some(found) = self.of.get_mut(rule) {
            found.unclear.get_or_insert_with(|| why.into());
        }
    }

    /// What of these rules was not observed gets no verdict, since it could not be asked.
    pub(crate) fn leave_out_unseen(&mut self, rules: &[&str]) {
        self.of.retain(|rule, found| !rules.contains(&rule.as_str()) || found.passed + found.violations > 0);
    }

    /// Something kept every observation from being made that was not made yet.
    pub(crate) fn all_unclear(&mut self, why: &str) {
        for found in self.of.values_mut() {
            found.unclear.get_or_insert_with(|| why.to_owned());
        }
    }

    /// What was measured for a rule.
    pub(crate) fn measured(&mut self, rule: &str, measured: Option<Measured>) {
        if let Some(found) = self.of.get_mut(rule) {
            found.measured = measured;
        }
    }

    /// The verdicts: a failure outweighs what is unclear, and that what passed.
    pub(crate) fn verdicts(self, scenario: &str, sentence: impl Fn(&str) -> String) -> Vec<Ruling> {
        let rulings = self.of.into_iter().map(|(rule, mut found)| {
            let (verdict, why) = match (found.failed.take(), found.unclear.take()) {
                (Some(why), _) => (Verdict::Failed, Some(why)),
                (None, Some(why)) => (Verdict::Inconclusive, Some(why)),
                (None, None) if found.passed == 0 => {
                    (Verdict::Inconclusive, Some("nothing was observed that could show it".to_owned()))
                }
                (None, None) => (Verdict::Passed, None),
            };
            let (scenario, sentence) = (scenario.to_owned(), sentence(&rule));
            let Found { passed: observed, violations, measured, .. } = found;
            Ruling { scenario, rule, verdict, observed, violations, why, measured, sentence }
        });
        rulings.collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn verdict(observe: impl FnOnce(&mut Rulings)) -> Verdict {
        let mut rulings = Rulings::new(&["NCP-TRANS-002".to_owned()]);
        observe(&mut rulings);
        rulings.verdicts("qos", str::to_owned)[0].verdict
    }

    #[test]
    fn nothing_observed_is_inconclusive_and_a_failure_outweighs_the_rest() {
        let rule = "NCP-TRANS-002";
        assert_eq!(verdict(|_| ()), Verdict::Inconclusive);
        assert_eq!(verdict(|found| found.observe(rule, true, String::new)), Verdict::Passed);
        assert_eq!(verdict(|found| found.observe("NCP-SESS-020", true, String::new)), Verdict::Inconclusive);
        let unclear = |found: &mut Rulings| {
            found.observe(rule, true, String::new);
            found.unclear(rule, "noise");
        };
        assert_eq!(verdict(unclear), Verdict::Inconclusive);
        let failed = |found: &mut Rulings| {
            unclear(found);
            found.fail(rule, "wrong");
        };
        assert_eq!(verdict(failed), Verdict::Failed);
    }

    #[test]
    fn a_distribution_has_its_smallest_middle_and_largest() {
        let measured = Measured::of(vec![3.0, 1.0, 2.0], 5.0).unwrap();
        assert_eq!((measured.min_ms, measured.median_ms, measured.max_ms), (1.0, 2.0, 3.0));
        assert_eq!(Measured::of(Vec::new(), 5.0), None);
    }
}
