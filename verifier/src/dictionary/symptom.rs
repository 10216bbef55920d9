//! In which way a case fails, in so few bits that peers in any language show the same.

use std::collections::BTreeMap;

use crate::check::{Differences, Manner};
use crate::json::{Json, Number};
use crate::run::Outcome;
use crate::suite::{Case, Expect};

/// The longest string that a symptom holds; what is longer, or has words, is prose of the peer.
const NAME_CHARS: usize = 40;

/// A case, by a hash of its id: it outlives a corpus to which cases are added.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CaseKey(pub u32);

impl CaseKey {
    /// That of an id.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, reason = "the low half of the hash")]
    pub fn of(id: &str) -> Self {
        Self(fnv(id.as_bytes()) as u32)
    }
}

/// In which way a case fails: equal for peers that fail it alike, whatever words they have for it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Symptom {
    /// How many steps of a trace come before the first difference, and one more; 0: the answer as a whole is wrong.
    pub step: u8,
    /// A hash of the place of the first difference, and of what kind it is.
    pub place: u8,
    /// A hash of what is there.
    pub value: u16,
}

/// The cases that fail, and how.
pub type Symptoms = BTreeMap<CaseKey, Symptom>;

impl Symptom {
    /// That of an outcome; none for a case that passed, and for one that was not judged.
    #[must_use]
    pub fn of(case: &Case, outcome: &Outcome) -> Option<Self> {
        match outcome {
            Outcome::Pass | Outcome::Unsupported { .. } | Outcome::NotRun { .. } => None,
            Outcome::Crash { .. } => Some(Self::whole("crash")),
            Outcome::Timeout { .. } => Some(Self::whole("timeout")),
            Outcome::Protocol { .. } => Some(Self::whole("protocol")),
            Outcome::Fail(differences) => Some(match differences.manner {
                // A crash that the peer survives shows as one that it does not.
                Manner::Crash if differences.place.is_empty() => Self::whole("crash"),
                Manner::Crash => Self::at(differences, "crash", ""),
                Manner::Refusal => Self::at(differences, "refusal", ""),
                Manner::Order => Self::at(differences, "order", ""),
                Manner::Value if matches!(case.expect, Expect::Reject(_)) => Self::whole("acceptance"),
                Manner::Value => {
                    let got = differences.first.first().and_then(|first| first.got.as_deref());
                    Self::at(differences, "value", &got.map_or("nothing".to_owned(), canonical))
                }
            }),
        }
    }

    fn whole(kind: &str) -> Self {
        Self::at(&Differences::default(), kind, "")
    }

    #[expect(clippy::cast_possible_truncation, reason = "the low bits of a hash")]
    fn at(differences: &Differences, kind: &str, value: &str) -> Self {
        let place = &differences.place;
        let step = place.split('/').find_map(|token| token.parse::<usize>().ok());
        Self {
            step: step.map_or(0, |step| u8::try_from(step + 1).unwrap_or(u8::MAX)),
            place: fnv(format!("{kind} {place}").as_bytes()) as u8,
            value: fnv(value.as_bytes()) as u16,
        }
    }
}

/// A value by its meaning: numbers by value, members in one order, and no prose.
fn canonical(shown: &str) -> String {
    Json::parse(shown).map_or_else(
        // Cut short, or in the words of the check: what kind of thing it is.
        |_| if shown.ends_with(" items") { shown.to_owned() } else { shown.chars().take(1).collect() },
        |value| meaning(&value),
    )
}

fn meaning(value: &Json<'_>) -> String {
    if let Some(number) = Number::of(value) {
        return format!("{:?}", number.as_double());
    }
    match value {
        Json::String(text) if text.len() > NAME_CHARS || text.contains(' ') => "prose".to_owned(),
        Json::Array(items) => format!("[{}]", items.iter().map(meaning).collect::<Vec<_>>().join(",")),
        Json::Object(members) if members.iter().any(|(name, _)| name == "error") => "refusal".to_owned(),
        Json::Object(members) => {
            let mut members: Vec<String> =
                members.iter().map(|(name, value)| format!("{name}:{}", meaning(value))).collect();
            members.sort();
            format!("{{{}}}", members.join(","))
        }
        _ => value.to_string(),
    }
}

/// What was seen of a peer.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Observed {
    /// Every case that was judged.
    pub cases: BTreeMap<CaseKey, Seen>,
}

/// What was seen of one case.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Seen {
    /// A hash of the file that holds it: cases of one file are about one thing.
    pub file: u16,
    /// How it fails, if it does.
    pub symptom: Option<Symptom>,
}

impl Seen {
    /// A case that ends so.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, reason = "the low bits of a hash")]
    pub fn new(case: &Case, symptom: Option<Symptom>) -> Self {
        Self { file: fnv(case.file.as_bytes()) as u16, symptom }
    }
}

impl Observed {
    /// What came of cases; what was not run or is not implemented shows nothing.
    #[must_use]
    pub fn of<'c>(runs: impl IntoIterator<Item = (&'c Case, &'c Outcome)>) -> Self {
        let was_judged =
            |(_, outcome): &(&Case, &Outcome)| !matches!(outcome, Outcome::Unsupported { .. } | Outcome::NotRun { .. });
        let seen =
            |(case, outcome): (&Case, &Outcome)| (CaseKey::of(&case.id), Seen::new(case, Symptom::of(case, outcome)));
        Self { cases: runs.into_iter().filter(was_judged).map(seen).collect() }
    }

    /// The cases that fail, and how.
    #[must_use]
    pub fn symptoms(&self) -> Symptoms {
        self.cases.iter().filter_map(|(key, seen)| Some((*key, seen.symptom?))).collect()
    }

    /// How a case fails, if it was judged and does.
    pub(super) fn symptom(&self, key: CaseKey) -> Option<Symptom> {
        self.cases.get(&key)?.symptom
    }

    pub(super) fn file(&self, key: CaseKey) -> u16 {
        self.cases.get(&key).map_or(0, |seen| seen.file)
    }
}

/// FNV-1a, 64 bits, folded so that each part of it depends on every byte.
fn fnv(bytes: &[u8]) -> u64 {
    let hash = bytes
        .iter()
        .fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3));
    hash ^ (hash >> 32) ^ (hash >> 48)
}

#[cfg(test)]
mod tests {
    use ncp_text::catalogue::Role;

    use super::*;
    use crate::check::Difference;
    use crate::suite::testing;

    fn symptom(place: &str, manner: Manner, got: Option<&str>) -> Symptom {
        let got = got.map(str::to_owned);
        let first = Difference { at: place.to_owned(), expected: None, got, hint: Some("words".to_owned()) };
        let differences = Differences { first: vec![first], more: 0, place: place.to_owned(), manner };
        let case = testing::case("a", &["NCP-SAFE-008"], &[Role::Commander]);
        Symptom::of(&case, &Outcome::Fail(differences)).unwrap()
    }

    #[test]
    fn a_number_shows_alike_however_it_is_spelled_and_prose_whatever_it_says() {
        let value = |got| symptom("/steps/2/frame", Manner::Value, Some(got));
        assert_eq!(value("1"), value("1.0"));
        assert_eq!(value(r#"{"a":1,"b":[2e0]}"#), value(r#"{"b":[2],"a":1.0}"#));
        assert_eq!(value(r#""no such thing""#), value(r#""unknown channel x""#));
        assert_eq!(
            value(r#"{"error":{"code":"value","message":"too big"}}"#),
            value(r#"{"error":{"code":"range","message":"x"}}"#)
        );
        for (one, other) in [("1", "2"), ("0", "-0.0"), ("true", "false"), (r#""hold""#, r#""active""#), ("1", "null")]
        {
            assert_ne!(value(one), value(other), "{one} {other}");
        }
    }

    #[test]
    fn a_symptom_knows_its_step_and_a_crash_is_a_crash_in_any_form() {
        assert_eq!(symptom("/steps/2/frame", Manner::Value, None).step, 3);
        assert_eq!(symptom("/steps/900/frame", Manner::Value, None).step, u8::MAX);
        assert_eq!(symptom("/channels", Manner::Value, None).step, 0);
        let case = testing::case("a", &["NCP-SAFE-008"], &[Role::Commander]);
        let died = Outcome::Crash { what: "signal 6".to_owned(), log: "why".to_owned() };
        assert_eq!(Symptom::of(&case, &died), Some(symptom("", Manner::Crash, Some("the error `internal`, why"))));
        assert_ne!(symptom("", Manner::Crash, None), symptom("", Manner::Refusal, None));
        assert_ne!(symptom("/a", Manner::Value, None), symptom("/b", Manner::Value, None));
    }
}
