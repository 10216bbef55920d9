//! What a person accepted: the sentence of every rule, and what showed it.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use serde::{Deserialize, Serialize};

use super::Rule;
use crate::lock::{self, LockError};

/// The evidence that was accepted.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct Accepted {
    /// By rule.
    pub(super) rules: BTreeMap<String, AcceptedRule>,
}

/// The evidence of a rule that was accepted.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct AcceptedRule {
    /// The digest of the sentence as it was.
    pub(super) digest: String,
    /// The places of what showed it.
    pub(super) shown_by: BTreeSet<String>,
}

/// As the file holds it: a line for every rule and for every place, so that a change is easily read.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    /// The digest of each rule's sentence.
    sentences: BTreeMap<String, String>,
    /// The rules that each place shows.
    shows: BTreeMap<String, String>,
}

impl Accepted {
    /// The name of its lock.
    pub(super) const NAME: &str = "trace";

    /// What was accepted in a tree; nothing where there is no lock.
    ///
    /// # Errors
    /// A lock that cannot be read.
    pub(super) fn read(root: &Path) -> Result<Self, LockError> {
        Ok(lock::read::<File>(root, Self::NAME)?.map(Self::from).unwrap_or_default())
    }

    pub(super) fn of(rules: &[Rule]) -> Self {
        let rules = rules.iter().map(|rule| {
            let accepted = AcceptedRule { digest: rule.requirement.digest.clone(), shown_by: rule.shown_by() };
            (rule.requirement.id.clone(), accepted)
        });
        Self { rules: rules.collect() }
    }

    /// The text of the lock.
    ///
    /// # Errors
    /// What TOML cannot hold.
    pub(super) fn text(&self) -> Result<String, LockError> {
        let mut shows: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
        for (id, rule) in &self.rules {
            for place in &rule.shown_by {
                shows.entry(place).or_default().push(id);
            }
        }
        let sentences = self.rules.iter().map(|(id, rule)| (id.clone(), rule.digest.clone())).collect();
        let shows = shows.into_iter().map(|(place, ids)| (place.to_owned(), ids.join(" "))).collect();
        lock::text(Self::NAME, &File { sentences, shows })
    }
}

impl From<File> for Accepted {
    fn from(file: File) -> Self {
        let sentences = file.sentences.into_iter();
        let empty = |digest| AcceptedRule { digest, ..AcceptedRule::default() };
        let mut rules: BTreeMap<String, _> = sentences.map(|(id, digest)| (id, empty(digest))).collect();
        for (place, ids) in file.shows {
            for id in ids.split_whitespace() {
                rules.entry(id.to_owned()).or_default().shown_by.insert(place.clone());
            }
        }
        Self { rules }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_accepted_is_read_as_it_was_written() {
        let rule = |places: &[&str]| AcceptedRule {
            digest: "0123abcd".to_owned(),
            shown_by: places.iter().map(|place| (*place).to_owned()).collect(),
        };
        let accepted = Accepted {
            rules: BTreeMap::from([
                ("NCP-A-001".to_owned(), rule(&[])),
                ("NCP-A-002".to_owned(), rule(&["vectors/a/b.json", "a \"quoted\" place"])),
            ]),
        };
        let root = tempfile::tempdir().unwrap();
        let path = lock::path(root.path(), Accepted::NAME);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, accepted.text().unwrap()).unwrap();
        assert_eq!(Accepted::read(root.path()).unwrap(), accepted);
    }
}
