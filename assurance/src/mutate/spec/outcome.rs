//! What cargo-mutants tells: the mutants that there are, and how each of them fared.

use std::collections::BTreeMap;

use serde::de::Error as _;
use serde::{Deserialize, Serialize};

/// A mutant.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Mutant {
    /// As cargo-mutants prints it, with the line.
    pub(super) name: String,
    /// Without the line; the second of one such name in a file ends with ` #2`.
    pub(super) key: String,
}

/// How a mutant fared.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Outcome {
    /// The mutant's name, with the line.
    pub(super) name: String,
    pub(super) fate: Fate,
}

/// What became of a mutant.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Fate {
    CaughtBy(By),
    Missed,
    TimedOut,
    /// It does not compile.
    Unviable,
}

/// What notices mutants.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum By {
    /// The golden cases.
    Cases,
    /// The tests of the specification.
    Tests,
}

impl By {
    /// The name of the file in which the `nth` stage of a run is kept.
    pub(super) fn file(self, nth: usize) -> String {
        let by = match self {
            Self::Cases => "cases",
            Self::Tests => "tests",
        };
        format!("{nth:02}-{by}.json")
    }

    /// What was asked in the stage that is kept in a file of this name.
    pub(super) fn of_file(name: &str) -> Option<Self> {
        let (nth, by) = name.strip_suffix(".json")?.split_once('-')?;
        nth.parse::<u32>().ok()?;
        [Self::Cases, Self::Tests].into_iter().find(|of| of.file(0).strip_prefix("00-") == Some(&format!("{by}.json")))
    }
}

impl Outcome {
    /// Whether nothing noticed the mutant.
    pub(super) fn is_missed(&self) -> bool {
        self.fate == Fate::Missed
    }
}

/// The mutants that `--list --json` prints, in the order of the files and of the places within them; none where a name
/// is not of the form `file:line:column: what`.
pub(super) fn listed(list: &[u8]) -> Option<Vec<Mutant>> {
    #[derive(Deserialize)]
    struct Listed {
        name: String,
        file: String,
    }

    let place = |Listed { name, file }: Listed| {
        let (line, rest) = name.strip_prefix(&*file)?.strip_prefix(':')?.split_once(':')?;
        let (column, what) = rest.split_once(": ")?;
        let (line, column): (u32, u32) = (line.parse().ok()?, column.parse().ok()?);
        let what = what.to_owned();
        Some((file, line, column, what, name))
    };
    let list: Vec<Listed> = serde_json::from_slice(list).ok()?;
    let mut places: Vec<_> = list.into_iter().map(place).collect::<Option<_>>()?;
    places.sort();
    let mut times: BTreeMap<String, u32> = BTreeMap::new();
    let mutant = |(file, _, _, what, name)| {
        let without_line = format!("{file}: {what}");
        let nth = times.entry(without_line.clone()).or_default();
        *nth += 1;
        let key = match *nth {
            1 => without_line,
            nth => format!("{without_line} #{nth}"),
        };
        Mutant { name, key }
    };
    Some(places.into_iter().map(mutant).collect())
}

/// The outcomes of a run, as `outcomes.json` has them, also of one that was broken off.
///
/// # Errors
/// It is not of the form, or holds an outcome that nobody knows.
pub(super) fn told(outcomes: &[u8], by: By) -> serde_json::Result<Vec<Outcome>> {
    #[derive(Deserialize)]
    struct File {
        outcomes: Vec<Tried>,
    }
    #[derive(Deserialize)]
    struct Tried {
        scenario: Scenario,
        summary: Summary,
    }
    #[derive(Deserialize)]
    enum Scenario {
        Baseline,
        Mutant { name: String },
    }
    #[derive(Deserialize)]
    enum Summary {
        CaughtMutant,
        MissedMutant,
        Timeout,
        Unviable,
        /// Of the baseline, as is the next.
        Success,
        Failure,
    }

    let File { outcomes } = serde_json::from_slice(outcomes)?;
    let outcome = |tried: Tried| {
        let Scenario::Mutant { name } = tried.scenario else { return None };
        let fate = match tried.summary {
            Summary::CaughtMutant => Fate::CaughtBy(by),
            Summary::MissedMutant => Fate::Missed,
            Summary::Timeout => Fate::TimedOut,
            Summary::Unviable => Fate::Unviable,
            Summary::Success | Summary::Failure => {
                return Some(Err(serde_json::Error::custom(format_args!("{name} is neither caught nor missed"))));
            }
        };
        Some(Ok(Outcome { name, fate }))
    };
    outcomes.into_iter().filter_map(outcome).collect()
}

/// Outcomes, with what a later stage made of those that were not noticed before.
pub(super) fn updated(outcomes: Vec<Outcome>, later: Vec<Outcome>) -> Vec<Outcome> {
    let by_name = |outcome: Outcome| (outcome.name.clone(), outcome);
    let mut all: BTreeMap<String, Outcome> = outcomes.into_iter().map(by_name).collect();
    for outcome in later {
        let before = all.get(&outcome.name).map(|before| before.fate);
        if !matches!(before, Some(Fate::CaughtBy(_) | Fate::Unviable)) {
            all.insert(outcome.name.clone(), outcome);
        }
    }
    all.into_values().collect()
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use super::*;

    #[test]
    fn a_mutant_is_known_without_its_line_and_two_of_one_name_by_their_order() {
        let list = json!([
            {"file": "a.rs", "name": "a.rs:10:9: replace < with <= in f"},
            {"file": "a.rs", "name": "a.rs:9:10: replace < with <= in f"},
            {"file": "b.rs", "name": "b.rs:1:2: replace S::g -> Option<u8> with Some(0)"},
        ]);
        let mutants = listed(list.to_string().as_bytes()).unwrap();
        assert_eq!(mutants[0].name, "a.rs:9:10: replace < with <= in f");
        let keys: Vec<_> = mutants.into_iter().map(|mutant| mutant.key).collect();
        assert_eq!(
            keys,
            [
                "a.rs: replace < with <= in f",
                "a.rs: replace < with <= in f #2",
                "b.rs: replace S::g -> Option<u8> with Some(0)",
            ]
        );
        assert_eq!(listed(br#"[{"file": "a.rs", "name": "b.rs:1:1: x"}]"#), None);
    }

    fn run(summaries: &[(&str, &str)]) -> Value {
        let mutants =
            summaries.iter().map(|(name, summary)| json!({"scenario": {"Mutant": {"name": name}}, "summary": summary}));
        let baseline = json!({"scenario": "Baseline", "summary": "Success"});
        let outcomes: Vec<_> = std::iter::once(baseline).chain(mutants).collect();
        json!({"start_time": "2026-01-02T03:04:05.678Z", "end_time": "2026-01-02T03:05:06Z", "outcomes": outcomes})
    }

    #[test]
    fn the_tests_are_asked_of_what_the_cases_miss_only() {
        let first = run(&[("a", "CaughtMutant"), ("b", "MissedMutant"), ("c", "MissedMutant"), ("d", "Unviable")]);
        let second = run(&[("b", "CaughtMutant"), ("c", "MissedMutant"), ("d", "Timeout")]);
        let first = told(first.to_string().as_bytes(), By::Cases).unwrap();
        let fates: Vec<_> = updated(first, told(second.to_string().as_bytes(), By::Tests).unwrap())
            .into_iter()
            .map(|outcome| outcome.fate)
            .collect();
        assert_eq!(fates, [Fate::CaughtBy(By::Cases), Fate::CaughtBy(By::Tests), Fate::Missed, Fate::Unviable]);
    }

    #[test]
    fn of_a_run_that_was_broken_off_what_it_tried_counts() {
        let mut broken_off = run(&[("a", "CaughtMutant")]);
        broken_off["end_time"] = Value::Null;
        let outcomes = told(broken_off.to_string().as_bytes(), By::Cases).unwrap();
        assert_eq!(outcomes.len(), 1);
    }

    #[test]
    fn an_unknown_outcome_is_not_guessed() {
        assert!(told(run(&[("a", "Lost")]).to_string().as_bytes(), By::Cases).is_err());
    }
}
