//! Area `strict`: what changes once the strict profile of chapter 12.1 is agreed upon.

mod frames;
mod keys;
mod plant;
mod replies;
mod server;
mod turns;

use ncp_text::WIRE_VERSION;

use crate::case::{Case, File};
use crate::json::Json;
use crate::scenario::{ScenarioError, beside};

pub(crate) fn files() -> Result<Vec<File>, ScenarioError> {
    Ok(vec![keys::file()?, frames::file()?, replies::file()?, turns::file(), plant::file()?, server::file()?])
}

/// Versions with which one's own is not compatible, by name and spelling.
fn incompatible() -> [(&'static str, String); 5] {
    [
        ("older", beside(-1)),
        ("newer", beside(1)),
        ("major", "1.0".to_owned()),
        ("three-parts", format!("{WIRE_VERSION}.0")),
        ("malformed", "latest".to_owned()),
    ]
}

/// Why a strict receiver rejects a frame for its version: it is absent, or [`incompatible`].
fn unfit_versions() -> Vec<(&'static str, Option<String>)> {
    let others = incompatible().map(|(what, version)| (what, Some(version)));
    std::iter::once(("absent", None)).chain(others).collect()
}

/// The rule by which it does.
const fn against_version(version: Option<&str>) -> &'static str {
    if version.is_some() { "NCP-STRICT-003" } else { "NCP-STRICT-002" }
}

impl Case {
    /// The same question to a peer that has agreed upon the profile.
    pub(crate) fn strictly(mut self) -> Self {
        self.args = self.args.and("strict", Json::Bool(true));
        self
    }
}
