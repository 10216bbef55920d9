//! The control keys of the strict profile: one for each kind of request, and no others.

use crate::case::Role::{Commander, Server};
use crate::case::{Case, File};
use crate::json::{Json, object};
use crate::keys::segments::{self, Segment};
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
    cases.extend(accepted());
    // Each in a realm of one segment, and in one of several.
    for row in text.rows("refused")? {
        let verb = Json::read(row.cell("verb")?);
        let verb = verb.as_str().unwrap_or_default();
        cases.push(case(&row, Some("lab"), verb).rejects("key"));
        let mut other = row.clone();
        other.path = format!("{}/in-a-realm-of-two", row.path);
        other.title = row.title.replace("strict control key of", "strict control key in the realm `engram/ncp` of");
        cases.push(case(&other, Some("engram/ncp"), verb).rejects("key"));
    }
    cases.extend(text.rest(|row| Ok(case(row, Some(row.cell("realm")?), "step_request").rejects("key")))?);
    cases.extend(refused());
    let about = "The control keys of the strict profile: one for each kind of request, and none for anything else.";
    Ok(File::new("strict", "keys", about, cases))
}

/// In realms of segments that look wrong and are not: each is in the key as it is.
fn accepted() -> Vec<Case> {
    const NAMES: [&str; 6] = ["latin", "punctuation", "brackets", "percent-escape", "quotes", "at-inside"];
    let segments = segments::accepted().into_iter().filter(|segment| NAMES.contains(&segment.name.as_str()));
    let case = |(nth, segment): (usize, Segment)| {
        let verb = VERBS[nth % VERBS.len()];
        let realm = format!("lab/{}", segment.text);
        Case::new(format!("{verb}/accepted/{}", segment.name), &["NCP-STRICT-001", "NCP-KEY-007"], &[Commander, Server])
            .rests_on(format!("keys/realms/rpc/realm/accepted/{}", segment.name))
            .title(format!(
                "The strict control key of `{verb}` is built in a realm with a segment that {}, unchanged.",
                segment.says
            ))
            .flags(&["L04", segment.flag])
            .call("key.build", object! { "key" => "rpc", "realm" => realm.as_str(), "verb" => verb })
            .gives(object! { "key" => format!("{realm}/rpc/{verb}") })
            .because("All other rules stay: a valid realm is put into the key without escaping or changing it.")
    };
    segments.enumerate().map(case).collect()
}

/// In realms with a second segment that no builder accepts.
fn refused() -> Vec<Case> {
    const NAMES: [&str; 4] = ["star-alone", "dot-dot", "control-00", "bytes-257"];
    let segments = segments::refused_sample().into_iter().filter(|segment| NAMES.contains(&segment.name.as_str()));
    let case = |(nth, segment): (usize, Segment)| {
        let verb = VERBS[nth % VERBS.len()];
        let realm = format!("lab/{}", segment.text);
        Case::new(
            format!("realm/{verb}/{}", segment.name),
            &["NCP-STRICT-001", "NCP-KEY-018", segment.rule],
            &[Commander, Server],
        )
        .rests_on(format!("keys/segments/sensor/session/refused/{}", segment.name))
        .title(format!(
            "The strict control key of `{verb}` is not built in a realm with a second segment that {}.",
            segment.says
        ))
        .flags(&["L04", segment.flag])
        .call("key.build", object! { "key" => "rpc", "realm" => realm, "verb" => verb })
        .rejects("key")
        .because("All other rules stay: the realm is checked segment by segment.")
    };
    segments.enumerate().map(case).collect()
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
