//! The grammar of a required `session_id`.

use super::READ;
use crate::case::{Case, File};
use crate::json::Json;
use crate::keys::segments::{self, Segment};
use crate::model::{explicit, full, meaning, minimal};
use crate::roles::{a, readers};
use ncp_text::tables::{Default, tables};

pub(super) fn file() -> File {
    let mut cases = Vec::new();
    let with_session = tables().messages.iter().filter_map(|message| {
        let required = message.field("session_id")?.default == Default::Required;
        message.kind.as_deref().filter(|_| required)
    });
    for (road, kind) in with_session.enumerate() {
        // The whole grammar for one kind; the builders of area `keys` show it to the other roles.
        let all = kind == "close_session";
        let refused = if all { segments::refused() } else { segments::refused_sample() };
        let besides = if all { Vec::new() } else { segments::refused_besides(road) };
        cases.extend(refused.iter().chain(&besides).map(|segment| rejected(kind, segment)));
        cases.extend(besides.iter().take(2).map(|segment| rejected_among_all(kind, segment)));
        let accepted = if all { segments::accepted() } else { segments::accepted_sample() };
        cases.extend(accepted.iter().map(|segment| read(kind, segment)));
        if all {
            cases.extend(segments::discouraged().iter().map(|segment| advised_against(kind, segment)));
        }
    }
    cases.extend(free());
    let about = "A required `session_id` is an id segment by chapter 3.";
    File::new("wire", "session_id", about, cases)
}

/// A frame that says only what it must.
fn rejected(kind: &'static str, segment: &Segment) -> Case {
    rejected_in(kind, segment, &minimal(kind), "", "")
}

/// One in which every other field has another value than its default.
fn rejected_among_all(kind: &'static str, segment: &Segment) -> Case {
    rejected_in(kind, segment, &full(kind), "/among-all", ", whatever its other fields say")
}

fn rejected_in(kind: &'static str, segment: &Segment, frame: &Json, path: &str, words: &str) -> Case {
    let frame = frame.clone().with("session_id", Json::string(&segment.text));
    Case::new(format!("{kind}/refused/{}{path}", segment.name), &["NCP-WIRE-031", segment.rule], readers(kind))
        .title(format!("{} whose `session_id` {} is rejected{words}.", a(kind), segment.says))
        .flags(&["unchecked-session-id"])
        .decode(kind, frame.text())
        .rejects("value")
        .because("No key could be built from the id, so no peer could have the session.")
}

/// What chapter 3 only advises against is only advised against here.
fn advised_against(kind: &'static str, segment: &Segment) -> Case {
    let frame = minimal(kind).with("session_id", Json::string(&segment.text));
    Case::new(format!("{kind}/discouraged/{}", segment.name), &[segment.rule], readers(kind))
        .title(format!("{} whose `session_id` {} should be rejected.", a(kind), segment.says))
        .flags(&[segment.flag])
        .decode(kind, frame.text())
        .rejects("value")
        .because("What chapter 3 says with SHOULD is SHOULD for a frame too.")
}

/// Ids that are any strings.
fn free() -> Vec<Case> {
    let mut cases = Vec::new();
    for (kind, field) in [("link_status", "session_id"), ("capabilities", "controller_id")] {
        for (what, text) in
            [("empty", ""), ("slash", "a/b"), ("star", "*"), ("at", "@a"), ("space", "a b"), ("nul", "a\0b")]
        {
            let frame = explicit(kind).with(field, Json::string(text));
            if frame == explicit(kind) {
                continue;
            }
            cases.push(
                Case::new(format!("{kind}/free/{what}"), &[READ], readers(kind))
                    .title(format!("{} whose `{field}` is {} is read.", a(kind), Json::string(text).text()))
                    .flags(&["over-strict"])
                    .decode(kind, frame.text())
                    .means(meaning(kind, &frame).text())
                    .because(format!(
                        "No key is built from it: the `{field}` of {} is any string.",
                        a(kind).to_lowercase()
                    )),
            );
        }
    }
    cases
}

fn read(kind: &'static str, segment: &Segment) -> Case {
    let frame = explicit(kind).with("session_id", Json::string(&segment.text));
    Case::new(format!("{kind}/accepted/{}", segment.name), &["NCP-KEY-020", "NCP-WIRE-031"], readers(kind))
        .title(format!("{} whose `session_id` {} is read.", a(kind), segment.says))
        .flags(&[segment.flag])
        .decode(kind, frame.text())
        .means(meaning(kind, &frame).text())
        .because("Chapter 3 refuses nothing of it, so it is a valid id.")
}
