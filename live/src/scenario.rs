//! The scenarios, as `scenarios.toml` has them.

use clap::ValueEnum;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
use thiserror::Error;

use crate::soak::OverLink;

/// A live scenario: what is set up, what is done, and on which rules it gives a verdict.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Scenario {
    /// Group and name, such as `server/lifecycle`.
    pub(crate) name: String,
    /// What it does, in a sentence.
    pub(crate) about: String,
    /// Which actors have to run; in a deployment of others, those that it has to have.
    pub(crate) needs: Vec<Role>,
    /// The rules that it judges, and no other.
    pub(crate) rules: Vec<String>,
    /// The audited findings, such as `L16`, that it fails a system for; the trace reads them.
    #[serde(default)]
    #[expect(dead_code, reason = "it is read of the table alone")]
    findings: Vec<String>,
    /// What is done, one after the other; empty where the code of the judge says it.
    #[serde(default, rename = "step")]
    pub(crate) steps: Vec<Step>,
    /// The hostile link over which the reference actors meet, for scenarios of their own.
    #[serde(default)]
    pub(crate) link: Option<OverLink>,
}

/// A running program.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize, ValueEnum)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Role {
    /// Answers control RPC.
    Server,
    /// Asks it.
    Client,
    /// Senses, and obeys.
    Plant,
    /// Makes commands out of what is sensed.
    Commander,
    /// Reads.
    Observer,
    /// Answers lines.
    Simulator,
    /// Answers control RPC by asking whoever answers lines.
    Gateway,
}

/// One thing that is done, and what it has to lead to.
#[derive(Debug, Clone, Deserialize)]
#[serde(untagged, deny_unknown_fields)]
pub(crate) enum Step {
    /// A request to a server.
    Ask {
        /// The bytes; `{a}` and `{b}` are ids of sessions of this run, `{network}` is what is opened.
        ask: String,
        /// The reply has all members of one of these.
        reply: Vec<Map<String, Value>>,
        /// The rule that asks for it.
        rule: String,
    },
    /// What is put on the action plane, and what the plant then does.
    Command {
        /// Members of a command frame; what is not given is an active command that moves the plant.
        command: Map<String, Value>,
        /// What the plant does.
        plant: Motion,
        /// How long it has to do so, once it does.
        #[serde(default)]
        for_ms: u64,
        /// The rule that asks for it.
        rule: String,
    },
    /// Bytes that are put on the action plane, and what the plant then does.
    Raw {
        /// The bytes.
        raw: String,
        /// What the plant does.
        plant: Motion,
        /// How long it has to do so, once it does.
        #[serde(default)]
        for_ms: u64,
        /// The rule that asks for it.
        rule: String,
    },
    /// What the plant does of itself.
    Look {
        /// What the plant does.
        plant: Motion,
        /// How long it has to do so, once it does.
        #[serde(default)]
        for_ms: u64,
        /// The rule that asks for it.
        rule: String,
    },
}

/// What a plant does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Motion {
    /// It moves.
    Moves,
    /// It holds.
    Holds,
    /// It has held before, and does not move.
    Still,
}

/// Why the scenarios cannot be read.
#[derive(Debug, Error)]
#[error("scenarios.toml: {0}")]
pub(crate) struct ScenarioError(#[from] toml::de::Error);

/// All scenarios, in the order in which they are run.
///
/// # Errors
/// The table is faulty; a test makes sure that it is not.
pub(crate) fn scenarios() -> Result<Vec<Scenario>, ScenarioError> {
    #[derive(Deserialize)]
    #[serde(deny_unknown_fields)]
    struct Table {
        scenario: Vec<Scenario>,
    }
    Ok(toml::from_str::<Table>(include_str!("../scenarios.toml"))?.scenario)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn every_scenario_has_a_name_of_its_own_and_rules_of_the_text() {
        let catalogue = ncp_text::Catalogue::load().unwrap();
        let mut names = BTreeSet::new();
        for Scenario { name, rules, steps, .. } in scenarios().unwrap() {
            assert!(names.insert(name.clone()), "{name} stands twice");
            assert!(!rules.is_empty(), "{name}");
            for rule in &rules {
                assert!(catalogue.get(rule).is_some(), "{name}: {rule}");
            }
            for step in &steps {
                let (Step::Ask { rule, .. }
                | Step::Command { rule, .. }
                | Step::Raw { rule, .. }
                | Step::Look { rule, .. }) = step;
                assert!(rules.contains(rule), "{name}: {rule} is not among its rules");
            }
        }
    }
}
