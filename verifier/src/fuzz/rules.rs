//! Which rule decides a disagreement: that of the most similar case of the corpus.

use std::collections::{BTreeMap, HashSet};

use ncp_text::catalogue::{Level, Role};

use super::tree::Tree;
use crate::json::Json;
use crate::peer::Call;
use crate::suite::{Case, Expect, Suite};

/// How much of a case is looked at: a longer one says no more.
const LOOKED_AT: usize = 64 << 10;

/// The cases of the corpus, and what they are made of.
#[derive(Debug)]
pub struct Rules<'s> {
    suite: &'s Suite,
    looks: BTreeMap<Call, Vec<(&'s Case, HashSet<u64>)>>,
}

/// The rule of a disagreement.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Decided {
    /// Its id.
    pub rule: String,
    /// Its sentence.
    pub sentence: String,
    /// Whether it binds; else it is advice.
    pub binds: bool,
    /// The case of the corpus that is most like it.
    pub like: String,
}

impl<'s> Rules<'s> {
    /// Those of a suite.
    #[must_use]
    pub fn new(suite: &'s Suite) -> Self {
        Self { suite, looks: BTreeMap::new() }
    }

    /// A rule and a role by which a question of this call is a case at all.
    pub(crate) fn any(&self, call: Call, roles: &[Role], level: Level) -> Option<(String, Role)> {
        let cases = self.suite.cases().iter().filter(|case| case.call == call && case.level <= level && case.binding);
        cases.filter_map(|case| role_of(case, roles).map(|role| (case.requirements[0].id.clone(), role))).next()
    }

    /// The rule that decides a place of the answer to a question, and the role that it binds.
    pub(crate) fn decide(
        &mut self,
        call: Call,
        args: &Tree,
        rejects: bool,
        place: &str,
        roles: &[Role],
        level: Level,
    ) -> Option<(Decided, Role)> {
        let suite = self.suite;
        let looks = self.looks.entry(call).or_insert_with(|| {
            let cases = suite.cases().iter().filter(|case| case.call == call && case.request_bytes() < LOOKED_AT);
            cases.map(|case| (case, look(&case.body()))).collect()
        });
        let own = look(&super::generate::body(call, &args.to_string()));
        let mut best: Option<(f64, &Case, Role)> = None;
        for (case, features) in looks.iter() {
            let Some(role) = role_of(case, roles).filter(|_| case.level <= level && case.binding) else { continue };
            let shared = own.intersection(features).count() as f64;
            let mut score = shared / (own.len() + features.len()).max(1) as f64;
            if matches!(case.expect, Expect::Reject(_)) == rejects {
                score += 0.3;
            }
            if best.is_none_or(|(known, _, _)| score > known) {
                best = Some((score, case, role));
            }
        }
        let (_, case, role) = best?;
        // The places of another trace are other steps: only what is within a step tells.
        let rule = case.by.at(place).filter(|_| !place.starts_with("/steps/")).or_else(|| case.requirements.first())?;
        let role = if rule.binds(role) { role } else { roles.iter().copied().find(|role| rule.binds(*role))? };
        let decided = Decided {
            rule: rule.id.clone(),
            sentence: rule.sentence.clone(),
            binds: rule.keyword.is_binding(),
            like: case.id.clone(),
        };
        Some((decided, role))
    }
}

fn role_of(case: &Case, roles: &[Role]) -> Option<Role> {
    case.roles
        .iter()
        .copied()
        .find(|role| roles.contains(role) && case.requirements.iter().any(|rule| rule.binds(*role)))
}

/// What a request is made of: the ways to its values, what these are, and short strings.
fn look(body: &str) -> HashSet<u64> {
    let mut features = HashSet::new();
    let request = format!("{{{body}");
    if let Ok(request) = Json::parse(&request) {
        walk(&request, 0xcbf2_9ce4_8422_2325, &mut features);
    }
    features
}

fn walk(json: &Json<'_>, path: u64, features: &mut HashSet<u64>) {
    let mut add = |what: &str| {
        features.insert(fnv(path, what));
    };
    match json {
        Json::Null => add("null"),
        Json::Bool(value) => add(if *value { "true" } else { "false" }),
        Json::Number(spelling) => {
            let value: f64 = spelling.parse().unwrap_or(f64::NAN);
            add(if value == 0.0 {
                "0"
            } else if value < 0.0 {
                "negative"
            } else if value > 1e15 {
                "huge"
            } else if value < 1e-15 {
                "tiny"
            } else {
                "number"
            });
            if !spelling.contains(['.', 'e', 'E']) {
                add("integer");
            }
        }
        Json::String(written) => {
            if let Ok(inner @ Json::Object(_)) = Json::parse(written) {
                walk(&inner, fnv(path, "json"), features);
            } else if written.len() <= 40 {
                add(written);
            } else {
                add("long");
            }
        }
        Json::Array(items) => {
            add(if items.is_empty() { "[]" } else { "[…]" });
            for item in items.iter().take(256) {
                walk(item, fnv(path, "*"), features);
            }
        }
        Json::Object(members) => {
            for (name, value) in members.iter().take(256) {
                walk(value, fnv(path, name), features);
            }
        }
    }
}

/// FNV-1a.
pub(crate) fn fnv(from: u64, text: &str) -> u64 {
    text.bytes().fold(from ^ 0x2f, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}
