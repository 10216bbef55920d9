//! The fault dictionary: how each known defect shows, and the fewest of them that explain what a peer does.
//!
//! A [`Dictionary`] holds the [`Symptom`]s of planted defects: which cases fail with one, and in which way. It is made
//! by running the whole suite against a peer with each defect (`cargo assure dictionary`). [`Dictionary::explain`]
//! looks for the fewest entries whose symptoms are those of a peer; what none explains stays unexplained.

mod explain;
mod symptom;

pub use explain::{Explained, Explanation};
pub use symptom::{CaseKey, Observed, Symptom, Symptoms};

use std::sync::OnceLock;

use serde::{Deserialize, Serialize};
use thiserror::Error;

/// The symptoms of the known defects.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Dictionary {
    /// One entry a defect.
    pub entries: Vec<Entry>,
}

/// A known defect.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
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

/// Why a dictionary cannot be read.
#[derive(Debug, Error)]
pub enum DictionaryError {
    /// It is no JSON of this form.
    #[error("the fault dictionary cannot be read: {0}")]
    Json(#[from] serde_json::Error),
}

impl Dictionary {
    /// The one that is built in.
    #[must_use]
    pub fn embedded() -> &'static Self {
        static EMBEDDED: OnceLock<Dictionary> = OnceLock::new();
        // A test holds that it can be read.
        EMBEDDED.get_or_init(|| Self::read(include_str!("../../dictionary.json")).unwrap_or_default())
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
        Ok(format!("{{\"entries\": [\n{}\n]}}\n", lines.join(",\n")))
    }
}

/// Symptoms as text: for each case the four bytes of its key and the two of the symptom, little-endian, in base64.
mod packed {
    use base64::Engine as _;
    use base64::engine::general_purpose::STANDARD;
    use serde::de::Error as _;
    use serde::{Deserialize as _, Deserializer, Serializer};

    use super::{CaseKey, Symptom, Symptoms};

    pub(super) fn serialize<S: Serializer>(symptoms: &Symptoms, to: S) -> Result<S::Ok, S::Error> {
        let bytes: Vec<u8> = symptoms
            .iter()
            .flat_map(|(CaseKey(case), Symptom(symptom))| {
                case.to_le_bytes().into_iter().chain(symptom.to_le_bytes()).collect::<Vec<u8>>()
            })
            .collect();
        to.serialize_str(&STANDARD.encode(bytes))
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<Symptoms, D::Error> {
        let bytes = STANDARD.decode(String::deserialize(from)?).map_err(D::Error::custom)?;
        let (pairs, rest) = bytes.as_chunks::<6>();
        if !rest.is_empty() {
            return Err(D::Error::custom("symptoms have six bytes each"));
        }
        let pair = |[a, b, c, d, e, f]: &[u8; 6]| {
            (CaseKey(u32::from_le_bytes([*a, *b, *c, *d])), Symptom(u16::from_le_bytes([*e, *f])))
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
        let symptoms: Symptoms = [(CaseKey(7), Symptom(1)), (CaseKey(u32::MAX), Symptom(0xABCD))].into();
        let entry = Entry { name: "n".into(), words: "It does.".into(), rules: vec!["NCP-SAFE-004".into()], symptoms };
        let dictionary = Dictionary { entries: vec![entry.clone(), entry] };
        let text = dictionary.write().unwrap();
        assert_eq!(Dictionary::read(&text).unwrap().entries, dictionary.entries);
        assert_eq!(text.lines().count(), 4);
        assert!(Dictionary::read(&text.replace("==", "")).is_err() || !text.contains("=="));
        assert!(Dictionary::read("{\"entries\": [{\"symptoms\": \"AAA=\"}]}").is_err());
    }

    #[test]
    fn no_two_cases_share_a_key() {
        let suite = Suite::embedded().unwrap();
        let keys: BTreeSet<CaseKey> = suite.cases().iter().map(|case| CaseKey::of(&case.id)).collect();
        assert_eq!(keys.len(), suite.cases().len());
    }

    #[test]
    fn the_built_in_dictionary_knows_cases_and_rules_of_the_suite() {
        let suite = Suite::embedded().unwrap();
        let text = include_str!("../../dictionary.json");
        let dictionary = Dictionary::read(text).unwrap();
        assert!(!dictionary.entries.is_empty());
        let mut keys: BTreeSet<CaseKey> = suite.cases().iter().map(|case| CaseKey::of(&case.id)).collect();
        keys.insert(CaseKey::of(crate::suite::DESCRIBE));
        for entry in &dictionary.entries {
            assert!(!entry.symptoms.is_empty(), "{} shows nowhere", entry.name);
            assert!(entry.symptoms.keys().all(|key| keys.contains(key)), "{}", entry.name);
            assert!(entry.rules.iter().all(|rule| suite.requirement(rule).is_some()), "{}", entry.name);
        }
    }
}
