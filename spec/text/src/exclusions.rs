//! Rules and findings that nothing can show, each with the one reason why: `spec/exclusions.toml`.

use std::collections::{BTreeMap, BTreeSet};

use serde::Deserialize;
use thiserror::Error;

/// What is excluded.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Exclusions {
    /// Rules by their ids.
    #[serde(default)]
    pub rules: BTreeMap<String, ExcludedRule>,
    /// Audited findings, `L01` to `L35`, that no case can show.
    #[serde(default)]
    pub findings: BTreeMap<String, ExcludedFinding>,
}

/// A rule that lacks something.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ExcludedRule {
    /// What it lacks; never empty.
    pub without: BTreeSet<Lack>,
    /// Why.
    pub why: String,
}

/// What a rule lacks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Lack {
    /// A function of the specification that carries it out.
    Code,
    /// A case of the corpus.
    Case,
    /// Anything that shows it: a case, a test, a property, a proof or a live scenario.
    Evidence,
}

/// A finding that no case can show.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ExcludedFinding {
    /// The rules that answer it.
    pub rules: BTreeSet<String>,
    /// Why.
    pub why: String,
}

impl Exclusions {
    /// Where the list stands in the tree.
    pub const FILE: &str = "spec/exclusions.toml";

    /// The list that this crate was built with.
    ///
    /// # Errors
    ///
    /// [`ExclusionsError`] when it is faulty; a test of this crate makes sure that it is not.
    pub fn load() -> Result<Self, ExclusionsError> {
        Self::parse(include_str!("../../exclusions.toml"))
    }

    /// The exclusions of a text.
    ///
    /// # Errors
    ///
    /// What is not in the form, and the first exclusion that does not say what it lacks and why.
    pub fn parse(text: &str) -> Result<Self, ExclusionsError> {
        let exclusions: Self = toml::from_str(text)?;
        let rules = exclusions.rules.iter().map(|(id, rule)| (id, &rule.why, rule.without.is_empty()));
        let findings = exclusions.findings.iter().map(|(id, finding)| (id, &finding.why, false));
        for (id, why, lacks_nothing) in rules.chain(findings) {
            if lacks_nothing || why.split_whitespace().count() < 3 {
                return Err(ExclusionsError::Silent { id: id.clone() });
            }
        }
        Ok(exclusions)
    }

    /// The rules that lack this, sorted by their ids, each with the reason.
    pub fn without(&self, lack: Lack) -> impl Iterator<Item = (&str, &str)> {
        let rules = self.rules.iter().filter(move |(_, rule)| rule.without.contains(&lack));
        rules.map(|(id, rule)| (id.as_str(), rule.why.as_str()))
    }
}

/// A list of exclusions that cannot be read.
#[derive(Debug, Error)]
pub enum ExclusionsError {
    /// It is not in the form.
    #[error("{file}: {0}", file = Exclusions::FILE)]
    Form(#[from] toml::de::Error),
    /// An exclusion that gives no reason, or excludes nothing.
    #[error("{file}: {id}: an exclusion says what is lacking and why", file = Exclusions::FILE)]
    Silent {
        /// The rule or the finding.
        id: String,
    },
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Catalogue;

    #[test]
    fn the_list_is_without_fault_and_names_rules_of_the_text() {
        let exclusions = Exclusions::load().unwrap_or_else(|fault| panic!("{fault}"));
        let catalogue = Catalogue::load().unwrap();
        let answering = exclusions.findings.values().flat_map(|finding| &finding.rules);
        for id in exclusions.rules.keys().chain(answering) {
            assert!(catalogue.get(id).is_some(), "{id}");
        }
        // What the specification does not carry out has no case; a live scenario of other programs may still show it.
        for stronger in [Lack::Code, Lack::Evidence] {
            assert!(exclusions.without(stronger).all(|(id, _)| exclusions.rules[id].without.contains(&Lack::Case)));
        }
    }

    #[test]
    fn an_exclusion_says_what_is_lacking_and_why() {
        let rule = |without: &str, why: &str| format!("[rules.NCP-A-001]\nwithout = {without}\nwhy = \"{why}\"\n");
        for silent in [rule("[\"case\"]", ""), rule("[]", "It binds a person.")] {
            let error = Exclusions::parse(&silent).unwrap_err().to_string();
            assert!(error.contains("NCP-A-001: an exclusion says what is lacking and why"), "{error}");
        }
        let exclusions = Exclusions::parse(&rule("[\"case\"]", "It binds a person.")).unwrap();
        assert_eq!(exclusions.without(Lack::Case).collect::<Vec<_>>(), [("NCP-A-001", "It binds a person.")]);
        assert_eq!(exclusions.without(Lack::Evidence).count(), 0);
        assert!(Exclusions::parse(&rule("[\"luck\"]", "It binds a person.")).is_err());
    }
}
