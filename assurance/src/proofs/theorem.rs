//! The theorem in Coq as an engine: what `proofs/theorem/check.sh` prints, held against the claims beside it.

use std::collections::{BTreeMap, BTreeSet};

use ncp_proofs::report::{Answer, Engine, Verdict, Words};
use serde::Deserialize;

/// The claims, from the root of the project.
pub(crate) const CLAIMS: &str = "proofs/theorem/claims.toml";
/// The file that asks what each theorem rests on.
pub(crate) const THEOREMS: &str = "proofs/theorem/coq/Theorems.v";

/// What is claimed of the theorems.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Claims {
    trusted: Vec<String>,
    not_proved: Vec<String>,
    claim: Vec<Stated>,
}

/// A claim, and the theorems that say it.
#[derive(Debug, Deserialize)]
struct Stated {
    id: String,
    theorems: Vec<String>,
    /// Whether the hypotheses of the record `following` are assumed.
    #[serde(default)]
    follows: bool,
    #[serde(flatten)]
    words: Words,
}

impl Claims {
    /// The ids of the claims.
    pub(crate) fn ids(&self) -> impl Iterator<Item = &str> {
        self.claim.iter().map(|claim| &*claim.id)
    }

    /// What the check found: each claim is proved when the check held, Coq said of each of its theorems what it rests
    /// on, and what Coq assumes is what the claim names.
    pub(crate) fn engine(self, theorems: &str, printed: &str, is_good: bool) -> Engine {
        let rests: BTreeMap<&str, Vec<&str>> = asked(theorems).zip(answered(printed)).collect();
        let hypotheses = hypotheses(printed);
        let tie = said(printed, "tie: ").unwrap_or_default();
        let exported = said(printed, "exported: ").unwrap_or_default();
        let word = |Stated { id, theorems, follows, words }: Stated| {
            let missing = theorems.iter().find(|theorem| !rests.contains_key(theorem.as_str()));
            let named: BTreeSet<&str> =
                words.assumptions.iter().filter_map(|text| Some(text.split_once(':')?.0)).collect();
            let wrong = if !is_good {
                Some("the check does not hold".to_owned())
            } else if let Some(theorem) = missing {
                Some(format!("Coq does not say what {theorem} rests on"))
            } else if follows && (hypotheses.is_empty() || !hypotheses.is_subset(&named)) {
                let unnamed: Vec<&str> = hypotheses.difference(&named).copied().collect();
                Some(format!("Coq assumes what the claim does not name: {}", unnamed.join(", ")))
            } else {
                None
            };
            let axioms: BTreeSet<&str> =
                theorems.iter().filter_map(|it| rests.get(it.as_str())).flatten().copied().collect();
            let axioms = match axioms.is_empty() {
                true => "closed under the global context: no axiom".to_owned(),
                false => axioms.into_iter().collect::<Vec<_>>().join(", "),
            };
            let rests = format!("{}; Print Assumptions: {axioms}", theorems.join(", "));
            // What the tie covers stands with the claim about it.
            let on = if id.ends_with("/tie") { format!("{tie}; exported: {exported}; {rests}") } else { rests };
            let verdict = if wrong.is_none() { Verdict::Proved } else { Verdict::Failed };
            Answer { detail: wrong.unwrap_or(on), words: Some(words), ..Answer::new(&id, verdict) }
        };
        Engine {
            name: "theorem".to_owned(),
            version: said(printed, "versions: ").unwrap_or_default().to_owned(),
            results: self.claim.into_iter().map(word).collect(),
            trusted: self.trusted,
            not_proved: self.not_proved,
            ..Engine::default()
        }
    }
}

/// The line of a kind, without what it begins with.
fn said<'p>(printed: &'p str, kind: &str) -> Option<&'p str> {
    printed.lines().find_map(|line| line.strip_prefix(kind))
}

/// The theorems of which the file asks what they rest on, in its order.
fn asked(theorems: &str) -> impl Iterator<Item = &str> {
    theorems.lines().filter_map(|line| line.strip_prefix("Print Assumptions ")?.strip_suffix('.'))
}

/// What Coq answers to that, one after the other: the axioms of a theorem.
fn answered(printed: &str) -> Vec<Vec<&str>> {
    let mut answers: Vec<Vec<&str>> = Vec::new();
    let mut is_within = false;
    for line in printed.lines() {
        match line {
            "Axioms:" | "Closed under the global context" => {
                answers.push(Vec::new());
                is_within = line == "Axioms:";
            }
            "" => is_within = false,
            // An axiom begins its line, its type may go on on indented ones.
            _ if is_within && !line.starts_with(' ') => {
                let name = line.split([' ', ':']).next();
                answers.last_mut().into_iter().for_each(|axioms| axioms.extend(name));
            }
            _ => {}
        }
    }
    answers
}

/// The fields of the record `following`, as Coq prints it.
fn hypotheses(printed: &str) -> BTreeSet<&str> {
    let record = printed.split_once("Build_following\n").and_then(|(_, rest)| rest.split_once("}."));
    let lines = record.map_or("", |(fields, _)| fields).lines();
    // A field begins four columns in, or after the brace; its type may go on further in.
    let field = |line: &'_ str| -> bool { !line.starts_with("     ") };
    lines
        .filter(|line| field(line))
        .filter_map(|line| Some(line.trim_start_matches(['{', ' ']).split_once(" :")?.0))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const ASKS: &str = "Print following.\nPrint Assumptions a.\nPrint Assumptions b.\n";
    const SAYS: &str = "\
versions: Coq 8
Record
following (held : R) : Prop := Build_following
  { one : forall a : R,
           0 <= a :> R;
    two : held = held }.

Arguments following held
Axioms:
M.x : forall P,
  P
N.y
  : Q
Closed under the global context

axioms, all of Coq's:
  M.x
";

    fn claims(assumptions: &str) -> Claims {
        let words = "family = \"f\"\nrules = []\nsentence = \"\"\nstatement = \"\"\nbounds = \"\"\n";
        let claim = |id: &str, theorem: &str, rest: &str| {
            format!("[[claim]]\nid = {id:?}\ntheorems = [{theorem:?}]\n{words}{rest}\n")
        };
        let with = claim("t/a", "a", &format!("follows = true\nassumptions = [{assumptions}]"));
        let without = claim("t/b", "b", "assumptions = []");
        toml::from_str(&format!("trusted = []\nnot_proved = []\n{with}{without}")).unwrap()
    }

    #[test]
    fn each_theorem_gets_the_axioms_that_coq_prints_of_it() {
        let engine = claims(r#""one: 1", "two: 2""#).engine(ASKS, SAYS, true);
        assert!(engine.results.iter().all(Answer::is_proved), "{:?}", engine.results);
        assert!(engine.results[0].detail.ends_with("Print Assumptions: M.x, N.y"), "{}", engine.results[0].detail);
        assert!(engine.results[1].detail.contains("no axiom"), "{}", engine.results[1].detail);
        assert_eq!(engine.version, "Coq 8");
    }

    #[test]
    fn a_hypothesis_that_the_claim_does_not_name_is_no_proof() {
        let engine = claims(r#""one: 1""#).engine(ASKS, SAYS, true);
        assert_eq!(engine.results[0].verdict, Verdict::Failed);
        assert!(engine.results[0].detail.ends_with("does not name: two"), "{}", engine.results[0].detail);
        assert_eq!(claims(r#""one: 1""#).engine(ASKS, "", true).results[0].verdict, Verdict::Failed);
    }

    #[test]
    fn a_check_that_fails_or_a_theorem_that_is_not_asked_for_proves_nothing() {
        let both = || claims(r#""one: 1", "two: 2""#);
        assert!(both().engine(ASKS, SAYS, false).results.iter().all(|answer| !answer.is_proved()));
        let engine = both().engine("Print Assumptions a.\n", SAYS, true);
        assert_eq!(engine.results[1].detail, "Coq does not say what b rests on");
    }

    #[test]
    fn every_theorem_of_the_claims_is_one_of_which_coq_is_asked_what_it_rests_on() {
        let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let read = |file: &str| std::fs::read_to_string(root.join(file)).unwrap();
        let (claims, theorems): (Claims, _) = (toml::from_str(&read(CLAIMS)).unwrap(), read(THEOREMS));
        let asked: BTreeSet<&str> = asked(&theorems).collect();
        let missing = claims.claim.iter().flat_map(|claim| &claim.theorems).find(|it| !asked.contains(it.as_str()));
        assert_eq!(missing, None);
    }
}
