//! What the corpus knows of its flags beside their notes: `vectors/flags.toml` and `vectors/findings.toml`.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use serde::Deserialize;

/// A bug class that cases are flagged with.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
pub struct Flag {
    /// What it belongs to, such as `estop` or `grammar`.
    pub class: String,
    /// What the bug is.
    pub description: String,
    /// What comes of it.
    pub effect: String,
}

/// An audited finding, `L01` to `L35`.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
pub struct Finding {
    /// What is wrong in a peer that has it.
    pub title: String,
    /// `high`, `medium` or `low`.
    pub severity: String,
    /// What is required instead.
    pub required: String,
    /// The rules that demand it; none where NCP 0.5 has no rule for it.
    pub rules: Vec<String>,
    /// Whether what is required changes the wire, so that the strict profile alone demands it.
    #[serde(default)]
    pub wire_breaking: bool,
}

static FLAGS: LazyLock<BTreeMap<String, Flag>> =
    LazyLock::new(|| toml::from_str(include_str!("../../../vectors/flags.toml")).unwrap_or_default());
static FINDINGS: LazyLock<BTreeMap<String, Finding>> =
    LazyLock::new(|| toml::from_str(include_str!("../../../vectors/findings.toml")).unwrap_or_default());

impl Flag {
    /// The bug class of that name.
    #[must_use]
    pub fn of(name: &str) -> Option<&'static Self> {
        FLAGS.get(name)
    }
}

impl Finding {
    /// The finding of that id, in capitals or not.
    #[must_use]
    pub fn of(id: &str) -> Option<(&'static str, &'static Self)> {
        FINDINGS.get_key_value(&id.to_ascii_uppercase()).map(|(id, finding)| (id.as_str(), finding))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::suite::Suite;

    #[test]
    fn every_flag_of_the_suite_is_a_bug_class_or_a_finding() {
        let suite = Suite::embedded().unwrap();
        for flag in suite.flags() {
            assert!(Flag::of(flag).is_some() != Finding::of(flag).is_some(), "{flag}");
        }
        for (name, flag) in FLAGS.iter() {
            assert_eq!(suite.notes(name), [flag.description.as_str()], "{name}");
        }
    }

    #[test]
    fn the_rules_of_every_finding_exist_and_those_with_cases_are_decided_by_one() {
        let suite = Suite::embedded().unwrap();
        assert_eq!(FINDINGS.len(), 35);
        for (id, finding) in FINDINGS.iter() {
            assert!(["high", "medium", "low"].contains(&finding.severity.as_str()), "{id}");
            let flagged: Vec<_> = suite.cases().iter().filter(|case| case.flags.contains(id)).collect();
            for rule in &finding.rules {
                assert!(suite.requirement(rule).is_some(), "{id}: {rule} is no rule");
                let is_cited = flagged.iter().any(|case| case.requirements.iter().any(|cited| cited.id == *rule));
                assert!(flagged.is_empty() || is_cited, "{id}: no flagged case cites {rule}");
            }
        }
    }
}
