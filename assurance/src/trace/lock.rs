//! What a person accepted: evidence as it was, and rules that nothing can show.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::path::Path;

use serde::Deserialize;

use super::{Rule, TraceError};

/// The evidence that was accepted.
#[derive(Debug, Default, Deserialize, PartialEq, Eq)]
#[serde(deny_unknown_fields)]
pub(super) struct Lock {
    pub(super) rules: BTreeMap<String, Accepted>,
}

/// The evidence of a rule that was accepted.
#[derive(Debug, Deserialize, PartialEq, Eq)]
#[serde(deny_unknown_fields)]
pub(super) struct Accepted {
    /// The digest of the sentence as it was.
    pub(super) digest: String,
    /// The places of what showed it.
    pub(super) shown_by: BTreeSet<String>,
}

impl Lock {
    /// Its file in the tree.
    pub(super) const FILE: &str = "spec/evidence.lock";

    /// The lock of a tree; an empty one where there is none.
    pub(super) fn read(root: &Path) -> Result<Self, TraceError> {
        Ok(read(root, Self::FILE)?.unwrap_or_default())
    }

    pub(super) fn of(rules: &[Rule]) -> Self {
        let rules = rules.iter().map(|rule| {
            let accepted = Accepted { digest: rule.requirement.digest.clone(), shown_by: rule.shown_by() };
            (rule.requirement.id.clone(), accepted)
        });
        Self { rules: rules.collect() }
    }
}

/// As the file holds it: every place on a line of its own, so that a change is easily read.
impl fmt::Display for Lock {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(
            "# The evidence of every rule, as a person last accepted it: `ncp-verify trace --accept`.\n\
             # A sentence that changes, or evidence that goes, fails the check until it is accepted again.\n",
        )?;
        for (id, Accepted { digest, shown_by }) in &self.rules {
            write!(f, "\n[rules.{id}]\ndigest = \"{digest}\"\nshown_by = [")?;
            for place in shown_by {
                write!(f, "\n  {},", toml::Value::from(place.as_str()))?;
            }
            f.write_str(if shown_by.is_empty() { "]\n" } else { "\n]\n" })?;
        }
        Ok(())
    }
}

/// Rules and findings that nothing can show, each with the reason.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Exclusions {
    #[serde(default)]
    pub(super) rules: BTreeMap<String, String>,
    #[serde(default)]
    pub(super) findings: BTreeMap<String, ExcludedFinding>,
}

/// A finding that no case can show.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ExcludedFinding {
    /// The rules that answer it.
    pub(super) rules: BTreeSet<String>,
    pub(super) why: String,
}

impl Exclusions {
    const FILE: &str = "spec/exclusions.toml";

    /// The exclusions of a tree; none where there is no file.
    pub(super) fn read(root: &Path) -> Result<Self, TraceError> {
        let exclusions: Self = read(root, Self::FILE)?.unwrap_or_default();
        let findings = exclusions.findings.iter();
        let all = findings.map(|(id, finding)| (id, &finding.why));
        let all = all.chain(&exclusions.rules);
        let mut silent = all.filter(|(_, why)| why.split_whitespace().count() < 3);
        if let Some((id, _)) = silent.next() {
            return Err(TraceError::Content {
                path: Self::FILE.to_owned(),
                message: format!("{id}: an exclusion says why"),
            });
        }
        Ok(exclusions)
    }
}

fn read<T: serde::de::DeserializeOwned>(root: &Path, file: &str) -> Result<Option<T>, TraceError> {
    let path = root.join(file);
    match std::fs::read_to_string(&path) {
        Ok(text) => toml::from_str(&text).map(Some).map_err(|error| {
            let message = error.to_string();
            TraceError::Content { path: file.to_owned(), message }
        }),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(None),
        Err(source) => Err(TraceError::File { path, source }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lock_is_read_as_it_was_written() {
        let accepted = |places: &[&str]| Accepted {
            digest: "0123abcd".to_owned(),
            shown_by: places.iter().map(|place| (*place).to_owned()).collect(),
        };
        let lock = Lock {
            rules: BTreeMap::from([
                ("NCP-A-001".to_owned(), accepted(&[])),
                ("NCP-A-002".to_owned(), accepted(&["vectors/a/b.json", "a \"quoted\" place"])),
            ]),
        };
        assert_eq!(toml::from_str::<Lock>(&lock.to_string()).unwrap(), lock);
    }

    #[test]
    fn an_exclusion_without_a_reason_is_refused() {
        let root = tempfile::tempdir().unwrap();
        std::fs::create_dir(root.path().join("spec")).unwrap();
        let file = root.path().join(Exclusions::FILE);
        std::fs::write(&file, "[rules]\nNCP-A-001 = \"\"\n").unwrap();
        let error = Exclusions::read(root.path()).unwrap_err().to_string();
        assert!(error.contains("NCP-A-001: an exclusion says why"), "{error}");
        std::fs::write(&file, "[rules]\nNCP-A-001 = \"It binds a person.\"\n").unwrap();
        assert_eq!(Exclusions::read(root.path()).unwrap().rules.len(), 1);
    }
}
