//! The control keys of the strict profile: one for each kind of request, and no others.

use crate::case::Role::{Commander, Server};
use crate::case::{Case, File};
use crate::json::{Json, object};
use crate::scenario::{Row, ScenarioError, Scenarios, source};

/// The kinds of requests.
pub(super) const VERBS: [&str; 4] = ["open_session", "step_request", "run_request", "close_session"];

pub(super) fn file() -> Result<File, ScenarioError> {
    let mut text = Scenarios::read(source!("strict/keys"))?;
    let mut cases = text.cases("built", |row| {
        let realm = Some(row.cell("realm")?).filter(|realm| !realm.is_empty());
        let (within, verb) = (row.cell("in")?, row.fill("{verb}")?);
        Ok(case(row, realm, &verb).gives(object! { "key" => format!("{within}/rpc/{verb}") }))
    })?;
    cases.extend(text.cases("refused", |row| {
        Ok(case(row, Some("lab"), Json::read(row.cell("verb")?).as_str().unwrap_or_default()).rejects("key"))
    })?);
    cases.extend(text.rest(|row| Ok(case(row, Some(row.cell("realm")?), "step_request").rejects("key")))?);
    let about = "The control keys of the strict profile: one for each kind of request, and none for anything else.";
    Ok(File::new("strict", "keys", about, cases))
}

fn case(row: &Row, realm: Option<&str>, verb: &str) -> Case {
    row.case(&[Commander, Server]).call("key.build", object! { "key" => "rpc", "realm" => realm, "verb" => verb })
}
