//! The control keys of the strict profile: one for each kind of request, and no others.

use crate::case::Role::{Commander, Server};
use crate::case::{Case, File};
use crate::json::{Json, object};
use crate::scenario::{Row, ScenarioError, Scenarios, source};
use crate::template::Text;

/// The kinds of requests.
pub(super) const VERBS: [&str; 4] = ["open_session", "step_request", "run_request", "close_session"];

pub(super) fn file() -> Result<File, ScenarioError> {
    let mut text = Scenarios::read(source!("strict/keys"))?;
    let mut cases = text.cases("built", |row| {
        let realm = Some(row.cell("realm")?).filter(|realm| !realm.is_empty());
        let (within, verb) = (row.cell("in")?, row.fill("{verb}")?);
        Ok(case(row, realm, &verb).gives(object! { "key" => format!("{within}/rpc/{verb}") }))
    })?;
    cases.extend(long());
    cases.extend(text.cases("refused", |row| {
        Ok(case(row, Some("lab"), Json::read(row.cell("verb")?).as_str().unwrap_or_default()).rejects("key"))
    })?);
    cases.extend(text.rest(|row| Ok(case(row, Some(row.cell("realm")?), "step_request").rejects("key")))?);
    let about = "The control keys of the strict profile: one for each kind of request, and none for anything else.";
    Ok(File::new("strict", "keys", about, cases))
}

/// In realms that are long as a whole.
fn long() -> Vec<Case> {
    let realm = |bytes: usize| vec![Text::repeat("abcdefghijklmno/", bytes / 16), "z".into()];
    let mut cases = Vec::new();
    for verb in VERBS {
        for bytes in [257_usize, 1025, 65_537] {
            let key = Text::Concat([realm(bytes), vec![format!("/rpc/{verb}").into()]].concat());
            let args = object! { "key" => "rpc", "realm" => Text::Concat(realm(bytes)), "verb" => verb };
            cases.push(
                Case::new(
                    format!("{verb}/realm-of-{bytes}-bytes"),
                    &["NCP-STRICT-001", "NCP-KEY-018"],
                    &[Commander, Server],
                )
                .title(format!("The strict control key of `{verb}` is built in a realm of {bytes} bytes."))
                .flags(&["L04", "segment-length"])
                .call("key.build", args)
                .gives(object! { "key" => key.json() })
                .because("The control key of a request is `{realm}/rpc/{kind}`, and a realm has no limit as a whole."),
            );
        }
    }
    cases
}

fn case(row: &Row, realm: Option<&str>, verb: &str) -> Case {
    row.case(&[Commander, Server]).call("key.build", object! { "key" => "rpc", "realm" => realm, "verb" => verb })
}
