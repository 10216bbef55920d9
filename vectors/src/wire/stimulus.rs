//! The stimulus frame within a request, which may leave out what the request says.

use super::fields;
use super::place::Place;
use crate::case::{Case, File};
use crate::json::{Json, object};
use crate::model::{explicit, meaning, minimal};
use crate::roles::{a, readers};
use crate::scenario::beside;
use ncp_text::WIRE_VERSION;

pub(super) fn file() -> File {
    let mut cases = Vec::new();
    for kind in ["step_request", "run_request"] {
        cases.extend(left_out(kind));
        cases.extend(fits(kind));
        cases.extend(misfits(kind));
    }
    let nested = Place::nested().into_iter().filter(|place| place.message.kind.is_some());
    cases.extend(nested.flat_map(|place| fields::cases_at(&place)));
    let about = "A stimulus frame within a request: what it may leave out, and what it must agree with.";
    File::new("wire", "stimulus_in_request", about, cases)
}

fn stimulus() -> Json {
    explicit("stimulus_frame")
}

/// Each subset of the three members that may be left out.
fn left_out(kind: &'static str) -> Vec<Case> {
    let subsets: [&[&str]; 7] = [
        &["kind"],
        &["ncp_version"],
        &["session_id"],
        &["kind", "ncp_version"],
        &["kind", "session_id"],
        &["ncp_version", "session_id"],
        &["kind", "ncp_version", "session_id"],
    ];
    let mut cases: Vec<Case> = subsets
        .into_iter()
        .map(|names| {
            let left = names.iter().fold(stimulus(), |stimulus, name| stimulus.without(name));
            let frame = explicit(kind).with("stimulus", left);
            let pointers: Vec<String> = names.iter().map(|name| format!("/stimulus/{name}")).collect();
            let ignore: Vec<&str> = pointers.iter().map(String::as_str).collect();
            let listed = names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(" and ");
            Case::new(
                format!("{kind}/without/{}", names.join("-and-").replace("ncp_", "").replace('_', "-")),
                &["NCP-WIRE-035"],
                readers(kind),
            )
            .title(format!("{} whose stimulus frame leaves out {listed} is read.", a(kind)))
            .flags(&["nested-stimulus"])
            .decode(kind, frame.text())
            .means_but_for(meaning(kind, &frame).text(), &ignore)
            .because("The request already says it; what the peer fills in is not judged.")
        })
        .collect();
    let frame = minimal(kind).with("stimulus", Json::object());
    cases.push(
        Case::new(format!("{kind}/without/anything"), &["NCP-WIRE-035", "NCP-WIRE-023"], readers(kind))
            .title(format!("{} whose stimulus frame is an empty object is read.", a(kind)))
            .flags(&["nested-stimulus"])
            .decode(kind, frame.text())
            .means_but_for(
                meaning(kind, &frame).text(),
                &["/stimulus/kind", "/stimulus/ncp_version", "/stimulus/session_id"],
            )
            .because("Three members may be left out, and the others have defaults."),
    );
    cases
}

fn fits(kind: &'static str) -> Vec<Case> {
    let with_version = |version: &str| Json::string(version);
    let table = [
        (
            "other-version-in-both",
            explicit(kind)
                .with("ncp_version", with_version(&beside(-1)))
                .with("stimulus", stimulus().with("ncp_version", with_version(&beside(-1)))),
            "has the request's version, which is an older one,",
        ),
        (
            "version-where-the-request-has-none",
            explicit(kind).without("ncp_version").with("stimulus", stimulus()),
            &format!("says {WIRE_VERSION} where the request leaves its version out"),
        ),
        (
            "other-session-in-both",
            explicit(kind)
                .with("session_id", Json::string("\u{e9}"))
                .with("stimulus", stimulus().with("session_id", Json::string("\u{e9}"))),
            "has the request's session, which is not in ASCII,",
        ),
    ];
    table
        .into_iter()
        .map(|(what, frame, says)| {
            Case::new(format!("{kind}/fits/{what}"), &["NCP-WIRE-035"], readers(kind))
                .title(format!("{} whose stimulus frame {says} is read.", a(kind)))
                .flags(&["nested-stimulus"])
                .decode(kind, frame.text())
                .means(meaning(kind, &frame).text())
                .because(format!(
                    "What stands there agrees with the request; a request without a version has {WIRE_VERSION}."
                ))
        })
        .map(|case| {
            if case.path.ends_with("/other-version-in-both") {
                // The request's version alone may be a reason to reject it.
                return case.or_rejects().title(format!(
                    "{} whose stimulus frame has the request's version, an older one, is rejected for that, or read.",
                    a(kind)
                ));
            }
            case
        })
        .collect()
}

fn misfits(kind: &'static str) -> Vec<Case> {
    let string = |text: &str| Json::string(text);
    let one = || Json::literal("1");
    let mut table: Vec<(String, Json, &'static str, &str, String)> = Vec::new();
    for other in ["sensor_frame", "command_frame", kind, "Stimulus_frame", "StimulusFrame", "unknown", ""] {
        let name = match other {
            "" => "empty",
            "Stimulus_frame" => "capital",
            "StimulusFrame" => "message-name",
            other => other,
        };
        table.push((
            format!("kind-{name}"),
            object! { "kind" => other },
            "NCP-WIRE-036",
            "value",
            format!("is of the kind `{other}`"),
        ));
    }
    for (name, session) in [("other", "s2"), ("empty", ""), ("other-case", "S1"), ("longer", "s1 "), ("invalid", "s/1")]
    {
        table.push((
            format!("session-{name}"),
            object! { "session_id" => session },
            "NCP-WIRE-037",
            "value",
            format!("has the session `{session}`"),
        ));
    }
    for (name, version) in
        [("older", beside(-1)), ("newer", beside(1)), ("empty", String::new()), ("malformed", "x".to_owned())]
    {
        table.push((
            format!("version-{name}"),
            object! { "ncp_version" => version.as_str() },
            "NCP-WIRE-038",
            "value",
            format!("has the version `{version}`"),
        ));
    }
    for member in ["kind", "session_id", "ncp_version"] {
        let short = member.replace("ncp_", "").replace("_id", "");
        table.push((
            format!("{short}-null"),
            object! { member => Json::Null },
            "NCP-WIRE-021",
            "type",
            format!("has a `{member}` of null"),
        ));
        table.push((
            format!("{short}-number"),
            object! { member => one() },
            "NCP-WIRE-020",
            "type",
            format!("has a `{member}` that is a number"),
        ));
    }
    let mut cases: Vec<Case> = table
        .into_iter()
        .map(|(what, stimulus, rule, code, says)| {
            let rules: &[_] = match rule {
                "NCP-WIRE-021" | "NCP-WIRE-020" => &[rule, "NCP-WIRE-050"],
                rule => &[rule],
            };
            Case::new(format!("{kind}/misfit/{what}"), rules, readers(kind))
                .title(format!("{} whose stimulus frame {says} is rejected.", a(kind)))
                .flags(&["nested-stimulus"])
                .decode(kind, minimal(kind).with("stimulus", stimulus).text())
                .rejects(code)
                .because("A stimulus frame may leave these three out, but what stands there must fit the request.")
        })
        .collect();
    cases.push(
        Case::new(format!("{kind}/misfit/version-of-absent"), &["NCP-WIRE-038"], readers(kind))
            .title(format!(
                "{} of version {} whose stimulus frame says {WIRE_VERSION} is rejected.",
                a(kind),
                beside(-1)
            ))
            .flags(&["nested-stimulus"])
            .decode(
                kind,
                minimal(kind)
                    .with("ncp_version", string(&beside(-1)))
                    .with("stimulus", object! { "ncp_version" => WIRE_VERSION })
                    .text(),
            )
            .rejects("value")
            .because(format!("{WIRE_VERSION} is the receiver's version, but not the request's.")),
    );
    cases
}
