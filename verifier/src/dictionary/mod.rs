//! The fault dictionary: how each known defect shows, and the fewest of them that explain what a peer does.
//!
//! A [`Dictionary`] holds the [`Symptom`]s of planted defects: which cases fail with one, and in which way. It is made
//! by running the whole suite against a peer with each defect (`cargo assure dictionary`). [`Dictionary::explain`]
//! looks for the fewest entries whose symptoms are those of a peer; what none explains stays unexplained.

mod explain;
mod symptom;

pub use explain::{Explained, Explanation};
pub use symptom::{CaseKey, Observed, Seen, Symptom, Symptoms};

use std::sync::OnceLock;

use serde::{Deserialize, Serialize};
use thiserror::Error;

/// The symptoms of the known defects.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Dictionary {
    /// The SHA-256 of the `vectors/MANIFEST.sha256` of the cases that were run.
    pub corpus: String,
    /// One entry a defect.
    pub entries: Vec<Entry>,
}

/// A known defect.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Entry {
    /// Its name.
    pub name: String,
    /// What it does, in a sentence.
    pub words: String,
    /// The rules that it breaks, the one that says it best first.
    pub rules: Vec<String>,
    /// How it shows.
    #[serde(with = "packed")]
    pub symptoms: Symptoms,
}

/// Why a dictionary cannot be read or written.
#[derive(Debug, Error)]
pub enum DictionaryError {
    /// It is no JSON of this form.
    #[error("the fault dictionary: {0}")]
    Json(#[from] serde_json::Error),
}

impl Dictionary {
    /// The one that is built in.
    #[must_use]
    pub fn embedded() -> &'static Self {
        static EMBEDDED: OnceLock<Dictionary> = OnceLock::new();
        // A test reads it, so that the empty one never comes about.
        EMBEDDED.get_or_init(|| Self::read(SOURCE).unwrap_or_default())
    }

    /// Reads one.
    ///
    /// # Errors
    /// [`DictionaryError`] if it is none.
    pub fn read(text: &str) -> Result<Self, DictionaryError> {
        Ok(serde_json::from_str(text)?)
    }

    /// As it stands in git: one line an entry.
    ///
    /// # Errors
    /// Never, for what can be built.
    pub fn write(&self) -> Result<String, DictionaryError> {
        let lines = self.entries.iter().map(serde_json::to_string).collect::<Result<Vec<_>, _>>()?;
        Ok(format!("{{\"corpus\":{:?},\"entries\":[\n{}\n]}}\n", self.corpus, lines.join(",\n")))
    }
}

const SOURCE: &str = include_str!("../../dictionary.json");

/// Symptoms as text: for each case the four bytes of its key and the four of the symptom, little-endian, in base64.
mod packed {
    use base64::Engine as _;
    use base64::engine::general_purpose::STANDARD;
    use serde::de::Error as _;
    use serde::{Deserialize as _, Deserializer, Serializer};

    use super::{CaseKey, Symptom, Symptoms};

    pub(super) fn serialize<S: Serializer>(symptoms: &Symptoms, to: S) -> Result<S::Ok, S::Error> {
        let pair = |(key, symptom): (&CaseKey, &Symptom)| {
            let ([a, b, c, d], [e, f]) = (key.0.to_le_bytes(), symptom.value.to_le_bytes());
            [a, b, c, d, symptom.step, symptom.place, e, f]
        };
        to.serialize_str(&STANDARD.encode(symptoms.iter().flat_map(pair).collect::<Vec<u8>>()))
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<Symptoms, D::Error> {
        let bytes = STANDARD.decode(String::deserialize(from)?).map_err(D::Error::custom)?;
        let (pairs, rest) = bytes.as_chunks::<8>();
        if !rest.is_empty() {
            return Err(D::Error::custom("symptoms have eight bytes each"));
        }
        let pair = |&[a, b, c, d, step, place, e, f]: &[u8; 8]| {
            (CaseKey(u32::from_le_bytes([a, b, c, d])), Symptom { step, place, value: u16::from_le_bytes([e, f]) })
        };
        Ok(pairs.iter().map(pair).collect())
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::suite::Suite;

    #[test]
    fn what_is_written_is_read_again() {
        let symptom = |step, value| Symptom { step, place: 200, value };
        let symptoms: Symptoms = [(CaseKey(7), symptom(0, 1)), (CaseKey(u32::MAX), symptom(255, 0xABCD))].into();
        let entry = Entry { name: "n".into(), words: "It does.".into(), rules: vec!["NCP-SAFE-004".into()], symptoms };
        let dictionary = Dictionary { corpus: "00ff".into(), entries: vec![entry.clone(), entry] };
        let text = dictionary.write().unwrap();
        assert_eq!(Dictionary::read(&text).unwrap(), dictionary);
        assert_eq!(text.lines().count(), 4);
        let short = r#"{"corpus":"","entries":[{"name":"","words":"","rules":[],"symptoms":"AAA="}]}"#;
        assert!(Dictionary::read(short).unwrap_err().to_string().contains("eight bytes"));
    }

    #[test]
    fn no_two_cases_share_a_key() {
        let suite = Suite::embedded().unwrap();
        let keys: BTreeSet<CaseKey> = suite.with_describe().map(|case| CaseKey::of(&case.id)).collect();
        assert_eq!(keys.len(), suite.cases().len() + 1);
    }

    #[test]
    fn the_built_in_dictionary_knows_cases_and_rules_of_the_suite() {
        let suite = Suite::embedded().unwrap();
        let dictionary = Dictionary::read(SOURCE).unwrap();
        assert!(!dictionary.entries.is_empty());
        let keys: BTreeSet<CaseKey> = suite.with_describe().map(|case| CaseKey::of(&case.id)).collect();
        for entry in &dictionary.entries {
            assert!(!entry.symptoms.is_empty(), "{} shows nowhere", entry.name);
            assert!(entry.symptoms.keys().all(|key| keys.contains(key)), "{}", entry.name);
            assert!(!entry.rules.is_empty(), "{}", entry.name);
            assert!(entry.rules.iter().all(|rule| suite.requirement(rule).is_some()), "{}", entry.name);
        }
    }
}
