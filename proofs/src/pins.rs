//! How much the symbolic engine explores and asks, pinned: what changes there is seen, and looked at.

use std::collections::BTreeMap;
use std::path::Path;
use std::{fs, io};

use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::report::Answer;

/// The table, from the root of the project.
pub const FILE: &str = "proofs/explored.json";

/// What is pinned of a property.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Pin {
    /// Paths explored.
    pub paths: u64,
    /// Checks that a solver had to decide, on all paths.
    pub raised: u64,
    /// Checks that were true on their path without a solver.
    pub true_by_evaluation: u64,
    /// Names of checks that were reached.
    pub reached: u64,
}

/// The table by property.
pub type Pins = BTreeMap<String, Pin>;

/// The table cannot be read or written.
#[derive(Debug, Error)]
pub enum PinError {
    /// The file.
    #[error("{FILE}: {0}")]
    File(#[from] io::Error),
    /// Its form.
    #[error("{FILE}: {0}")]
    Form(#[from] serde_json::Error),
}

/// What the engine has explored.
#[must_use]
pub fn of(answers: &[Answer]) -> Pins {
    let pin = |answer: &Answer| Pin {
        paths: answer.paths.unwrap_or_default(),
        raised: answer.raised.unwrap_or_default(),
        true_by_evaluation: answer.true_by_evaluation.unwrap_or_default(),
        reached: answer.reached.len() as u64,
    };
    answers.iter().map(|answer| (answer.property.clone(), pin(answer))).collect()
}

/// Reads the table.
///
/// # Errors
/// There is none, or it has another form.
pub fn read(root: &Path) -> Result<Pins, PinError> {
    Ok(serde_json::from_str(&fs::read_to_string(root.join(FILE))?)?)
}

/// Writes the table.
///
/// # Errors
/// The file.
pub fn write(root: &Path, pins: &Pins) -> Result<(), PinError> {
    Ok(fs::write(root.join(FILE), serde_json::to_string_pretty(pins)? + "\n")?)
}

/// Where the engine has explored something else than what is pinned.
#[must_use]
pub fn problems(pinned: &Pins, found: &Pins) -> Vec<String> {
    let all: std::collections::BTreeSet<&String> = pinned.keys().chain(found.keys()).collect();
    let differs = |id: &&String| pinned.get(*id) != found.get(*id);
    let say = |pin: Option<&Pin>| match pin {
        Some(pin) => format!(
            "{} paths, {} checks on them for the solver and {} without, {} by name",
            pin.paths, pin.raised, pin.true_by_evaluation, pin.reached
        ),
        None => "nothing".to_owned(),
    };
    let problem = |id: &String| {
        let (was, is) = (say(pinned.get(id)), say(found.get(id)));
        format!("{id}: explored are {is}; pinned in {FILE} are {was}: look why, and pin it with --pin")
    };
    all.into_iter().filter(differs).map(problem).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_less_a_new_property_and_one_that_is_gone_are_problems() {
        let pin = |paths| Pin { paths, ..Pin::default() };
        let pins = |all: &[(&str, u64)]| all.iter().map(|(id, paths)| ((*id).to_owned(), pin(*paths))).collect();
        let pinned: Pins = pins(&[("a", 2), ("b", 3), ("c", 4)]);
        assert_eq!(problems(&pinned, &pinned), [""; 0]);
        let found = problems(&pinned, &pins(&[("a", 2), ("b", 2), ("d", 1)]));
        assert_eq!(found.len(), 3);
        assert!(found[0].starts_with("b: explored are 2 paths"), "{}", found[0]);
        assert!(found[1].starts_with("c: explored are nothing"), "{}", found[1]);
        assert!(found[2].starts_with("d: explored are 1 paths"), "{}", found[2]);
    }
}
