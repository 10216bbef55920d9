//! The same bytes to a receiver that has agreed upon the profile and to one that has not, by turns: what a peer keeps
//! of one question is no answer to the other.

use crate::case::{Case, File, Role};
use crate::json::object;
use crate::model::{explicit, meaning};
use crate::roles::{a, readers};

pub(super) fn file() -> File {
    let mut cases: Vec<Case> =
        ["sensor_frame", "command_frame", "open_session", "step_request"].into_iter().flat_map(frames).collect();
    let replies = [
        ("open_session", "session_opened"),
        ("step_request", "observation_frame"),
        ("close_session", "session_closed"),
    ];
    cases.extend(replies.into_iter().flat_map(|(request, reply)| of_reply(request, reply)));
    let about = "The same frame without a version, read by the strict profile and without it, by turns.";
    File::new("strict", "turns", about, cases)
}

/// Two frames without a version: one is decoded without the profile first, and the other with it.
fn frames(kind: &'static str) -> [Case; 4] {
    // Stamped, so that a strict receiver has but one reason to reject it.
    let whole = explicit(kind);
    let whole = if kind == "command_frame" { whole.with("seq", 1_u32.into()) } else { whole };
    let ask = |turn: &str, rules: &[&'static str]| {
        // What no receiver knows tells the two apart, and from the frames of other files.
        let text = whole.clone().without("ncp_version").and("turn", first(turn).into()).text();
        Case::new(format!("{kind}/{turn}"), rules, readers(kind)).decode(kind, text)
    };
    let title = |end: &str| format!("{} without a version is {end}", a(kind));
    let lenient = |case: Case, when: &str| {
        case.title(title(&format!("read by a receiver that is not strict, {when}.")))
            .flags(&["L07"])
            .means(meaning(kind, &whole).text())
            .because(KEEPS)
    };
    let strict = |case: Case, when: &str| {
        case.strictly()
            .title(title(&format!("rejected by a strict receiver, {when}.")))
            .flags(&["L07"])
            .rejects("missing")
            .because(KEEPS)
    };
    [
        lenient(ask("lenient-first", &["NCP-WIRE-032"]), "which is asked first"),
        strict(ask("strict-second", &["NCP-STRICT-002"]), "though one that is not strict has read it"),
        strict(ask("strict-first", &["NCP-STRICT-002"]), "which is asked first"),
        lenient(ask("lenient-second", &["NCP-WIRE-032"]), "though a strict one has rejected it"),
    ]
}

/// Two replies without a version: one is for a client without the profile first, and the other for one with it.
fn of_reply(request: &'static str, reply: &'static str) -> [Case; 4] {
    let ask = |turn: &str, rules: &[&'static str]| {
        let reply = explicit(reply).without("ncp_version").and("turn", first(turn).into()).text();
        Case::new(format!("{request}/reply/{turn}"), rules, &[Role::Commander])
            .call("reply.check", object! { "request" => explicit(request).text(), "reply" => reply })
    };
    let words = a(reply).to_lowercase();
    let lenient = |case: Case, when: &str| {
        case.title(format!("A client that is not strict accepts {words} without a version, {when}."))
            .flags(&["L07"])
            .accepts()
            .because(KEEPS)
    };
    let strict = |case: Case, when: &str| {
        case.strictly()
            .title(format!("A strict client rejects {words} without a version, {when}."))
            .flags(&["L07"])
            .rejects("missing")
            .because(KEEPS)
    };
    let accepted: &[&'static str] = &["NCP-WIRE-032", "NCP-SESS-007"];
    [
        lenient(ask("lenient-first", accepted), "when it is asked first"),
        strict(ask("strict-second", &["NCP-STRICT-002"]), "though one that is not strict has accepted it"),
        strict(ask("strict-first", &["NCP-STRICT-002"]), "when it is asked first"),
        lenient(ask("lenient-second", accepted), "though a strict one has rejected it"),
    ]
}

/// The receiver that is asked first in a turn.
fn first(turn: &str) -> &'static str {
    if matches!(turn, "lenient-first" | "strict-second") { "lenient" } else { "strict" }
}

const KEEPS: &str = "Whether a receiver is strict decides, and not what was made of the same bytes before.";
