//! In which way a case fails, in so few bits that peers in any language show the same.

use std::collections::BTreeMap;

use crate::check::Manner;
use crate::run::Outcome;
use crate::suite::{Case, Expect};
use crate::verdict::Judged;

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

/// In which way a case fails: equal for peers that fail it alike.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Symptom(pub u16);

/// The cases that fail, and how.
pub type Symptoms = BTreeMap<CaseKey, Symptom>;

impl Symptom {
    /// That of an outcome: the place of the first difference and what was there, but no words of the peer's own. None
    /// for a case that passed, and for one that was not judged.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, reason = "the low bits of the hash")]
    pub fn of(case: &Case, outcome: &Outcome) -> Option<Self> {
        let text = match outcome {
            Outcome::Pass | Outcome::Unsupported | Outcome::NotRun { .. } => return None,
            Outcome::Crash { .. } => "crash".to_owned(),
            Outcome::Timeout { .. } => "timeout".to_owned(),
            Outcome::Protocol { .. } => "protocol".to_owned(),
            Outcome::Fail(differences) => {
                let first = differences.first.first();
                match differences.manner {
                    // A crash that the peer survives shows as one that it does not.
                    Manner::Crash => "crash".to_owned(),
                    Manner::Refusal => "refused".to_owned(),
                    Manner::Order => format!("order {}", differences.place),
                    Manner::Value if matches!(case.expect, Expect::Reject(_)) => "accepted".to_owned(),
                    Manner::Value => {
                        let got = first.and_then(|first| first.got.as_deref()).unwrap_or("nothing");
                        format!("value {} {got}", differences.place)
                    }
                }
            }
        };
        Some(Self(fnv(text.as_bytes()) as u16))
    }
}

/// What was seen of a peer: every case that was judged, and how it fails if it does.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Observed {
    /// The cases.
    pub cases: BTreeMap<CaseKey, Option<Symptom>>,
}

impl Observed {
    /// What a verdict is about.
    #[must_use]
    pub fn of(cases: &[Judged<'_>]) -> Self {
        let was_judged = |judged: &&Judged<'_>| {
            !matches!(judged.run.outcome, Outcome::Unsupported | Outcome::NotRun { .. })
        };
        let seen = |judged: &Judged<'_>| (CaseKey::of(&judged.case.id), Symptom::of(judged.case, &judged.run.outcome));
        Self { cases: cases.iter().filter(was_judged).map(seen).collect() }
    }

    /// The cases that fail, and how.
    #[must_use]
    pub fn symptoms(&self) -> Symptoms {
        self.cases.iter().filter_map(|(key, symptom)| Some((*key, (*symptom)?))).collect()
    }
}

/// FNV-1a, 64 bits, folded so that each part of it depends on every byte.
fn fnv(bytes: &[u8]) -> u64 {
    let hash = bytes.iter().fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3)
    });
    hash ^ (hash >> 32)
}
