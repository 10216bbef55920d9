//! The failures that are expected of a peer, as its `peer.toml` or a list of their own holds them.

use std::path::Path;

use serde::{Deserialize, Serialize};

use super::ManifestError;

/// Failures that are known: of all that is named, what fits all of it (PROTOCOL.md, section 6).
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ExpectedFailure {
    /// A known defect that explains them, by its id; a label.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub defect: Option<String>,
    /// The rule by which they fail.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub requirement: Option<String>,
    /// Their outcome, such as `crash`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub outcome: Option<String>,
    /// How many there were when the entry was written.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub excuses: Option<usize>,
    /// The last day on which they are excused, such as `2026-12-31`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub expires: Option<String>,
    /// Why they fail.
    pub reason: String,
    /// The one case that is meant.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub case: Option<String>,
    /// The cases that are meant.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub cases: Vec<String>,
}

/// A file of expected failures.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ExpectedFailures {
    /// The entries.
    #[serde(default, rename = "expected-failures")]
    pub entries: Vec<ExpectedFailure>,
}

impl ExpectedFailures {
    /// Reads a file.
    ///
    /// # Errors
    /// [`ManifestError`] if it cannot be read or an entry means nothing.
    pub fn load(path: &Path) -> Result<Self, ManifestError> {
        let read = |source| ManifestError::Read { path: path.to_owned(), source };
        let form = |message| ManifestError::Form { path: path.to_owned(), message };
        let text = std::fs::read_to_string(path).map_err(read)?;
        let file: Self = toml::from_str(&text).map_err(|error| form(error.to_string().trim_end().to_owned()))?;
        file.entries.iter().try_for_each(ExpectedFailure::check).map_err(|why| form(why.to_owned()))?;
        Ok(file)
    }
}

impl ExpectedFailure {
    /// Whether the entry means something.
    pub(super) fn check(&self) -> Result<(), &'static str> {
        let is_date = |date: &String| {
            let digits = |part: &str, count| part.len() == count && part.bytes().all(|byte| byte.is_ascii_digit());
            let parts: Vec<&str> = date.split('-').collect();
            matches!(parts[..], [year, month, day] if digits(year, 4) && digits(month, 2) && digits(day, 2))
        };
        if self.case.is_some() && !self.cases.is_empty() {
            return Err("an expected failure names either a `case` or `cases`");
        }
        if self.case.is_none() && self.cases.is_empty() && self.requirement.is_none() && self.outcome.is_none() {
            return Err("an expected failure names a `case`, `cases`, a `requirement` or an `outcome`");
        }
        if !self.expires.as_ref().is_none_or(is_date) {
            return Err("an expected failure `expires` on a day such as \"2026-12-31\"");
        }
        Ok(())
    }

    /// The cases that are meant by their ids, if any.
    pub fn ids(&self) -> impl Iterator<Item = &String> {
        self.case.iter().chain(&self.cases)
    }

    /// What it is called in reports.
    #[must_use]
    pub fn name(&self) -> String {
        let mut parts: Vec<String> = Vec::new();
        let named = [("defect", &self.defect), ("requirement", &self.requirement), ("outcome", &self.outcome)];
        parts.extend(named.into_iter().filter_map(|(what, name)| Some(format!("{what} {}", name.as_ref()?))));
        match self.ids().count() {
            0 => {}
            1 => parts.extend(self.ids().map(|id| format!("case {id}"))),
            count => parts.push(format!("{count} cases")),
        }
        parts.join(", ")
    }
}
