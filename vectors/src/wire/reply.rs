//! What a client accepts as a reply, by chapter 4.

use crate::case::Role::Commander;
use crate::case::{Case, File};
use crate::json::{Json, object};
use crate::model::{WIRE_VERSION, explicit, minimal};
use crate::roles::a;
use crate::scenario::beside;

/// The requests and the kinds that answer them.
const PAIRS: [(&str, &str); 4] = [
    ("open_session", "session_opened"),
    ("step_request", "observation_frame"),
    ("run_request", "observation_frame"),
    ("close_session", "session_closed"),
];

pub(super) fn file() -> File {
    let mut cases = Vec::new();
    for (request, reply) in PAIRS {
        cases.extend(fitting(request, reply));
        cases.extend(wrong_kinds(request, reply));
        cases.extend(wrong_sessions(request, reply));
        cases.extend(wrong_versions(request, reply));
        cases.extend(failures(request, reply));
        cases.extend(broken(request, reply));
    }
    File::new("wire", "reply", "What a client accepts as the reply to its request.", cases)
}

fn fitting(request: &str, reply: &str) -> Vec<Case> {
    let mut table = vec![
        ("explicit", explicit(reply), "that writes out its defaults", &["NCP-SESS-007"][..]),
        ("minimal", minimal(reply), "that says only what it must", &["NCP-WIRE-023", "NCP-SESS-007"]),
        (
            "without-version",
            explicit(reply).without("ncp_version"),
            "without a version",
            &["NCP-WIRE-032", "NCP-SESS-007"],
        ),
        (
            "unknown-member",
            explicit(reply).and("novel", Json::Null),
            "with an unknown member",
            &["NCP-WIRE-026", "NCP-SESS-007"],
        ),
    ];
    if reply == "session_opened" {
        let other_hash = explicit(reply).with("contract_hash", "2cf0763ad61e4f1c".into());
        table.push(("other-contract-hash", other_hash, "of another contract hash", &["NCP-VER-025", "NCP-SESS-007"]));
        let without_hash = explicit(reply).without("contract_hash");
        table.push((
            "without-contract-hash",
            without_hash,
            "without a contract hash",
            &["NCP-WIRE-025", "NCP-SESS-007"],
        ));
    }
    if reply == "observation_frame" {
        let filled = explicit(reply)
            .with("records", object! { "v" => object! { "times" => Json::Array(vec![Json::literal("0.1")]) } });
        table.push(("records", filled, "with a record", &["NCP-SESS-007"]));
    }
    let mut cases: Vec<Case> = table
        .into_iter()
        .map(|(what, frame, says, rules)| {
            ask(request, &format!("accepted/{what}"), rules, &minimal(request), &frame.text())
                .title(format!("A client accepts {} {says} as the reply to its `{request}`.", a(reply).to_lowercase()))
                .flags(&["over-strict"])
                .accepts()
                .because("Kind, session and version fit, and nothing failed.")
        })
        .collect();
    let session = Json::string("caf\u{e9}");
    let asked = minimal(request).with("session_id", session.clone());
    cases.push(
        ask(
            request,
            "accepted/other-session",
            &["NCP-SESS-007"],
            &asked,
            &explicit(reply).with("session_id", session).text(),
        )
        .title(format!("A client accepts a reply to its `{request}` of a session that is not in ASCII."))
        .flags(&["over-strict"])
        .accepts()
        .because("The reply's session is the request's."),
    );
    cases
}

fn wrong_kinds(request: &str, reply: &str) -> Vec<Case> {
    let replies = ["session_opened", "observation_frame", "session_closed"];
    let others = replies.into_iter().filter(|kind| *kind != reply).chain([request, "stimulus_frame", "link_status"]);
    others
        .map(|kind| {
            // An echo of the request, or any frame with the right session: only the kind is wrong.
            let frame = explicit(kind).with("session_id", "s1".into());
            ask(
                request,
                &format!("kind/{}", kind.replace('_', "-")),
                &["NCP-SESS-001"],
                &minimal(request),
                &frame.text(),
            )
            .title(format!("A client rejects {} as the reply to its `{request}`.", a(kind).to_lowercase()))
            .flags(&["unchecked-replies"])
            .rejects("reply")
            .because(format!("A `{request}` is answered by {}.", a(reply).to_lowercase()))
        })
        .collect()
}

fn wrong_sessions(request: &str, reply: &str) -> Vec<Case> {
    [("other", "s2"), ("other-case", "S1"), ("longer", "s12"), ("shorter", "s")]
        .into_iter()
        .map(|(what, session)| {
            let frame = explicit(reply).with("session_id", session.into());
            ask(request, &format!("session/{what}"), &["NCP-SESS-002"], &minimal(request), &frame.text())
                .title(format!(
                    "A client rejects a reply of the session `{session}` to its `{request}` of the session `s1`."
                ))
                .flags(&["unchecked-replies"])
                .rejects("reply")
                .because("The reply is another session's.")
        })
        .collect()
}

fn wrong_versions(request: &str, reply: &str) -> Vec<Case> {
    [
        ("older", beside(-1)),
        ("newer", beside(1)),
        ("next-major", "1.0".to_owned()),
        ("no-minor", "0".to_owned()),
        ("three-parts", format!("{WIRE_VERSION}.0")),
        ("empty", String::new()),
        ("line-feed", format!("{WIRE_VERSION}\n")),
    ]
    .into_iter()
    .map(|(what, version)| {
        let frame = explicit(reply).with("ncp_version", version.as_str().into());
        ask(request, &format!("version/{what}"), &["NCP-SESS-003"], &minimal(request), &frame.text())
            .title(format!("A client rejects a reply of version {} to its `{request}`.", Json::string(version).text()))
            .flags(&["unchecked-reply-version"])
            .rejects("version")
            .because(format!("The version guard does not hold the version compatible with {WIRE_VERSION}."))
    })
    .collect()
}

fn failures(request: &str, reply: &str) -> Vec<Case> {
    let error = || minimal("error");
    let mut table = vec![
        ("error", error(), "NCP-SESS-005", "an error frame"),
        ("error-of-session", error().and("session_id", "s1".into()), "NCP-SESS-005", "an error frame of its session"),
        (
            "error-of-null-session",
            error().and("session_id", Json::Null),
            "NCP-SESS-005",
            "an error frame whose session is null",
        ),
    ];
    if reply != "observation_frame" {
        table.push(("not-ok", explicit(reply).with("ok", false.into()), "NCP-SESS-004", "a reply with `ok` false"));
        table.push((
            "not-ok-minimal",
            minimal(reply).with("ok", false.into()),
            "NCP-SESS-004",
            "a reply that says only `ok` false",
        ));
    }
    table
        .into_iter()
        .map(|(what, frame, rule, says)| {
            ask(request, &format!("failure/{what}"), &[rule], &minimal(request), &frame.text())
                .title(format!("A client reports {says} to its `{request}` as an error."))
                .flags(&["swallowed-failures"])
                .rejects("reply")
                .because("The reply says that the request failed.")
        })
        .collect()
}

/// Replies that chapter 1 or 6 rejects.
fn broken(request: &str, reply: &str) -> Vec<Case> {
    let text = minimal(reply).text();
    let mut table = vec![
        ("not-json", "ok".to_owned(), "is no JSON", "NCP-WIRE-002"),
        ("empty", String::new(), "is empty", "NCP-WIRE-002"),
        ("array", format!("[{text}]"), "is an array", "NCP-WIRE-003"),
        ("truncated", text[..text.len() - 1].to_owned(), "is cut off", "NCP-WIRE-002"),
        ("two-documents", format!("{text}{text}"), "is two documents", "NCP-WIRE-004"),
        ("duplicate", minimal(reply).and("session_id", "s1".into()).text(), "has a member twice", "NCP-WIRE-007"),
        ("no-kind", minimal(reply).without("kind").text(), "has no kind", "NCP-WIRE-028"),
        ("session-null", minimal(reply).with("session_id", Json::Null).text(), "has a session of null", "NCP-WIRE-021"),
    ];
    match reply {
        "observation_frame" => {
            table.push((
                "pin",
                minimal(reply).with("is_simulation_output", false.into()).text(),
                "has a broken pin",
                "NCP-PROV-002",
            ));
        }
        _ => table.push((
            "ok-string",
            minimal(reply).with("ok", "true".into()).text(),
            "has an `ok` that is a string",
            "NCP-WIRE-020",
        )),
    }
    if reply == "session_opened" {
        let provenance = object! { "calibrated_posterior" => true };
        table.push(("pin", minimal(reply).with("provenance", provenance).text(), "has a broken pin", "NCP-PROV-003"));
    }
    table
        .into_iter()
        .map(|(what, reply, says, rule)| {
            // What the decoders of other frames read wrongly too is about that rule alone.
            let rules: &[_] = match rule {
                "NCP-WIRE-003" | "NCP-WIRE-020" | "NCP-PROV-002" | "NCP-PROV-003" => &[rule],
                rule => &["NCP-SESS-006", rule],
            };
            ask(request, &format!("broken/{what}"), rules, &minimal(request), &reply)
                .title(format!("A client rejects a reply to its `{request}` that {says}."))
                .flags(&["unchecked-replies"])
                .rejects("reply")
                .because("No decoder accepts such a frame.")
        })
        .collect()
}

fn ask(request: &str, what: &str, rules: &[&'static str], asked: &Json, reply: &str) -> Case {
    Case::new(format!("{request}/{what}"), rules, &[Commander])
        .call("reply.check", object! { "request" => asked.text(), "reply" => reply })
}
