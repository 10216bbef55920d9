//! Whether the scenarios notice what goes wrong: each defect of `defects.toml`, planted in the reference actors.

use ncp_text::Catalogue;
use serde::{Deserialize, Serialize};

use crate::actors::Planted;
use crate::scenario::{Scenario, scenarios};
use crate::verdict::Verdict;
use crate::{LiveError, OwnNet};

/// How often a scenario is run that is inconclusive.
const TRIES: usize = 3;

/// A defect that an actor can have.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Defect {
    /// Its name, once in the table.
    pub(crate) name: String,
    /// What is wrong, in a sentence.
    #[cfg_attr(not(test), expect(dead_code, reason = "for readers of the table, and a test"))]
    pub(crate) about: String,
    /// The scenario that notices it.
    pub(crate) scenario: String,
    /// The rules that it breaks; the scenario has to fail the first.
    pub(crate) rules: Vec<String>,
}

/// What became of a defect.
#[derive(Debug, Serialize)]
pub(crate) struct Found {
    defect: String,
    scenario: String,
    rule: String,
    /// The rules that failed.
    failed: Vec<String>,
}

impl Found {
    /// Whether the scenario failed by the rule that the defect breaks.
    pub(crate) fn is_caught(&self) -> bool {
        self.failed.contains(&self.rule)
    }
}

/// The table.
///
/// # Errors
/// It is faulty; a test makes sure that it is not.
pub(crate) fn defects() -> Result<Vec<Defect>, LiveError> {
    #[derive(Deserialize)]
    #[serde(deny_unknown_fields)]
    struct Table {
        defect: Vec<Defect>,
    }
    Ok(toml::from_str::<Table>(include_str!("../defects.toml")).map_err(LiveError::Defects)?.defect)
}

/// Runs the scenario of each defect with it, and without: a scenario that fails by itself notices nothing.
pub(crate) fn run(only: &[String]) -> Result<Vec<Found>, LiveError> {
    let (catalogue, scenarios, mut net) = (Catalogue::load()?, scenarios()?, OwnNet::start()?);
    let all = defects()?;
    if let Some(unknown) = only.iter().find(|name| all.iter().all(|defect| defect.name != **name)) {
        return Err(LiveError::Unknown(unknown.clone()));
    }
    let chosen: Vec<Defect> = all.into_iter().filter(|defect| only.is_empty() || only.contains(&defect.name)).collect();
    let mut found = Vec::new();
    // On a noisy machine a scenario is inconclusive, and is run again.
    let mut failed_by = |scenario: &Scenario, planted: &Planted| -> Result<Vec<String>, LiveError> {
        let mut failed = Vec::new();
        for _ in 0..TRIES {
            let rulings = net.judge(scenario, planted, &catalogue)?;
            let is_clear = rulings.iter().all(|ruling| ruling.verdict != Verdict::Inconclusive);
            let of_failed = rulings.into_iter().filter(|ruling| ruling.verdict == Verdict::Failed);
            failed = of_failed.map(|ruling| ruling.rule).collect();
            if is_clear || !failed.is_empty() {
                break;
            }
        }
        Ok(failed)
    };
    for scenario in scenarios.iter().filter(|scenario| chosen.iter().any(|defect| defect.scenario == scenario.name)) {
        let sound = failed_by(scenario, &Planted::default())?;
        println!("{:26} {:22} {}", "sound", scenario.name, if sound.is_empty() { "passes" } else { "FAILS" });
        for Defect { name, rules, .. } in chosen.iter().filter(|defect| defect.scenario == scenario.name) {
            let mut failed = failed_by(scenario, &Planted(Some(name.clone())))?;
            // What fails without the defect does not show it.
            failed.retain(|rule| !sound.contains(rule));
            let rule = rules.first().cloned().unwrap_or_default();
            let one = Found { defect: name.clone(), scenario: scenario.name.clone(), rule, failed };
            let fate = match (one.is_caught(), one.failed.is_empty()) {
                (true, _) => "caught by",
                (false, false) => "CAUGHT BY ANOTHER RULE than",
                (false, true) => "MISSED",
            };
            println!("{name:26} {:22} {fate} {} ({})", one.scenario, one.rule, one.failed.join(", "));
            found.push(one);
        }
    }
    let caught = found.iter().filter(|one| one.is_caught()).count();
    println!("\n{caught} of {} defects are caught, each by its rule", found.len());
    Ok(found)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn every_defect_has_a_scenario_that_judges_its_rule_and_is_planted_somewhere() {
        let scenarios = scenarios().unwrap();
        let actors = [
            include_str!("actors/plant.rs"),
            include_str!("actors/commander.rs"),
            include_str!("actors/server.rs"),
            include_str!("actors/observer.rs"),
            include_str!("judge/acl/planted.rs"),
            include_str!("actors/gateway.rs"),
        ]
        .concat();
        let mut names = BTreeSet::new();
        for Defect { name, about, scenario, rules } in defects().unwrap() {
            assert!(names.insert(name.clone()), "{name} stands twice");
            assert!(about.ends_with('.'), "{name}: {about}");
            let found = scenarios.iter().find(|known| known.name == scenario);
            let found = found.unwrap_or_else(|| panic!("{name}: there is no scenario {scenario}"));
            for rule in &rules {
                assert!(found.rules.contains(rule), "{name}: {scenario} does not judge {rule}");
            }
            assert!(actors.contains(&format!("{name:?}")), "{name} is planted nowhere");
        }
        let asked = actors.split("planted.is(\"").skip(1).filter_map(|rest| rest.split('"').next());
        let unlisted: BTreeSet<&str> = asked.filter(|name| !names.contains(*name)).collect();
        assert_eq!(unlisted, BTreeSet::new(), "planted, and not in the table");
    }
}
