//! Area `strict`: what changes once the strict profile of chapter 12.1 is agreed upon.

mod frames;
mod keys;
mod plant;
mod replies;
mod server;

use crate::case::{Case, File};
use crate::json::Json;
use crate::scenario::ScenarioError;

pub(crate) fn files() -> Result<Vec<File>, ScenarioError> {
    Ok(vec![keys::file(), frames::file(), replies::file(), plant::file()?, server::file()])
}

/// Versions with which one's own, 0.5, is not compatible, by name and spelling.
const INCOMPATIBLE: [(&str, &str); 5] =
    [("older", "0.4"), ("newer", "0.6"), ("major", "1.0"), ("three-parts", "0.5.0"), ("malformed", "latest")];

/// Why a strict receiver rejects a frame for its version: it is absent, or one of [`INCOMPATIBLE`].
fn unfit_versions() -> Vec<(&'static str, Option<&'static str>)> {
    let others = INCOMPATIBLE.map(|(what, version)| (what, Some(version)));
    std::iter::once(("absent", None)).chain(others).collect()
}

/// The rule by which it does.
const fn against_version(version: Option<&str>) -> &'static str {
    if version.is_some() { "NCP-STRICT-003" } else { "NCP-STRICT-002" }
}

impl Case {
    /// The same question to a peer that has agreed upon the profile.
    fn strictly(mut self) -> Self {
        self.args = self.args.and("strict", Json::Bool(true));
        self
    }
}
