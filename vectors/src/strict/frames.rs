//! Frames as a strict receiver reads them: their versions on every plane, and the stamps of commands.

use super::incompatible;
use crate::case::{Case, File};
use crate::json::{Json, object};
use crate::model::{explicit, meaning, minimal};
use crate::roles::{a, readers};
use crate::scenario::beside;
use crate::text::tables;
use ncp_text::WIRE_VERSION;

pub(super) fn file() -> File {
    let kinds = tables().messages.iter().filter_map(|message| message.kind.as_deref());
    let mut cases = Vec::new();
    for kind in kinds {
        if kind == "error" {
            cases.extend(errors());
        } else {
            cases.extend(versions(kind));
        }
    }
    cases.extend(almost_versions());
    cases.extend(stimuli());
    cases.extend(unstamped());
    cases.extend(stamped());
    let about = "Frames of every kind at a strict receiver: with a version, without one, with another, and commands \
                 without a stamp.";
    File::new("strict", "frames", about, cases)
}

fn case(kind: &str, path: &str, rules: &[&'static str]) -> Case {
    Case::new(format!("{kind}/{path}"), rules, readers(kind))
}

/// A frame with which a strict receiver finds no fault.
fn good(kind: &str) -> Json {
    stamped_by(explicit(kind), 3)
}

/// A command of this seq; another frame as it is.
fn stamped_by(frame: Json, seq: i64) -> Json {
    if frame.get("kind") == Some(&Json::string("command_frame")) {
        frame.with("seq", crate::trace::int(seq))
    } else {
        frame
    }
}

fn accepts(case: Case, kind: &str, frame: &Json) -> Case {
    case.decode(kind, frame.text()).means(meaning(kind, frame).text()).strictly()
}

fn rejects(case: Case, kind: &str, frame: &Json, code: &str) -> Case {
    case.decode(kind, frame.text()).rejects(code).strictly()
}

fn versions(kind: &str) -> Vec<Case> {
    let frame = good(kind);
    let terse = stamped_by(minimal(kind), 7).with("ncp_version", WIRE_VERSION.into());
    let roomy = good(kind).and("novel", object! { "ncp_version" => beside(-1) });
    let mut cases = vec![
        accepts(case(kind, "version/own", &["NCP-STRICT-012"]), kind, &frame)
            .title(format!("{} of one's own version is read by a strict receiver.", a(kind)))
            .flags(&["over-strict"])
            .because("Its version is compatible, and no other chapter rejects it."),
        accepts(case(kind, "version/terse", &["NCP-STRICT-012"]), kind, &terse)
            .title(format!("{} that says little but its version is read by a strict receiver.", a(kind)))
            .flags(&["over-strict"])
            .because("Of the fields with a default the profile asks for the version alone, and for a command's seq."),
        accepts(case(kind, "version/of-an-unknown-member", &["NCP-STRICT-012"]), kind, &roomy)
            .title(format!(
                "A strict receiver looks at the version of {} itself, not at one in an unknown member.",
                a(kind)
            ))
            .flags(&["over-strict"])
            .because("Members that the tables do not list are ignored."),
        rejects(
            case(kind, "version/absent", &["NCP-STRICT-002"]),
            kind,
            &frame.clone().without("ncp_version"),
            "missing",
        )
        .title(format!("{} without a version is rejected by a strict receiver.", a(kind)))
        .flags(&["L07"])
        .because("A strict receiver rejects a frame without `ncp_version`, on every plane."),
    ];
    cases.extend(incompatible().map(|(what, version)| {
        let other = frame.clone().with("ncp_version", version.as_str().into());
        rejects(case(kind, &format!("version/{what}"), &["NCP-STRICT-003"]), kind, &other, "version")
            .title(format!("{} of the version `{version}` is rejected by a strict receiver.", a(kind)))
            .flags(&["L07"])
            .because(format!(
                "The version guard of chapter 2 does not hold that version compatible with {WIRE_VERSION}."
            ))
    }));
    cases
}

/// Members that are not the version, or are it in another spelling.
fn almost_versions() -> Vec<Case> {
    let mut cases = Vec::new();
    for kind in crate::roles::ANY {
        let bare = good(kind).without("ncp_version");
        let near = [
            ("other-name", bare.clone().and("version", WIRE_VERSION.into()), "under another name"),
            ("upper-case", bare.clone().and("NCP_VERSION", WIRE_VERSION.into()), "under a name in capitals"),
            (
                "nested",
                bare.clone().and("header", object! { "ncp_version" => WIRE_VERSION }),
                "within a member that is ignored",
            ),
        ];
        for (what, frame, says) in near {
            cases.push(
                rejects(case(kind, &format!("almost/{what}"), &["NCP-STRICT-002"]), kind, &frame, "missing")
                    .title(format!("{} with its version {says} is rejected by a strict receiver.", a(kind)))
                    .flags(&["L07"])
                    .because("The frame itself has no `ncp_version`."),
            );
        }
        let frame = good(kind);
        let escaped = frame.text().replacen("ncp_version", "ncp_versio\\u006e", 1);
        cases.push(
            case(kind, "almost/escaped", &["NCP-STRICT-012"])
                .title(format!(
                    "{} whose member `ncp_version` is spelled with an escape is read by a strict receiver.",
                    a(kind)
                ))
                .flags(&["raw-names"])
                .decode(kind, escaped)
                .means(meaning(kind, &frame).text())
                .strictly()
                .because("Two member names are the same when they are equal after their escapes are resolved."),
        );
        let last = bare.and("novel", Json::Null).and("ncp_version", WIRE_VERSION.into());
        cases.push(
            accepts(case(kind, "almost/last", &["NCP-STRICT-012"]), kind, &last)
                .title(format!("{} whose version is its last member is read by a strict receiver.", a(kind)))
                .flags(&["over-strict"])
                .because("The order of members does not count."),
        );
    }
    cases
}

/// The error frame has no version that could be missing.
fn errors() -> Vec<Case> {
    let frame = minimal("error");
    let about = frame.clone().with("session_id", "s1".into());
    [("bare", frame), ("with-session", about)]
        .map(|(what, frame)| {
            accepts(case("error", what, &["NCP-STRICT-012"]), "error", &frame)
                .title(format!("An error frame ({what}) is read by a strict receiver without a version."))
                .flags(&["over-strict"])
                .because("The error frame has no version, so these rules let it through.")
        })
        .into()
}

/// A stimulus frame leaves its version to the request, not the request to it.
fn stimuli() -> Vec<Case> {
    let mut cases = Vec::new();
    for kind in ["step_request", "run_request"] {
        let values = object! { "values" => object! { "drive" => object! { "data" => crate::trace::nums(&[1.5]) } } };
        let versioned = values.clone().with("ncp_version", WIRE_VERSION.into());
        let frame = good(kind).with("stimulus", values);
        cases.push(
            accepts(case(kind, "stimulus/without-version", &["NCP-STRICT-012"]), kind, &frame)
                .title(format!(
                    "A stimulus frame without a version within {} is read by a strict receiver.",
                    a(kind).to_lowercase()
                ))
                .flags(&["over-strict", "nested-stimulus"])
                .because("A stimulus frame within a request may still leave its version to the request."),
        );
        let frame = good(kind).with("stimulus", versioned);
        cases.push(
            accepts(case(kind, "stimulus/with-version", &["NCP-STRICT-012"]), kind, &frame)
                .title(format!(
                    "A stimulus frame with the version of {} is read by a strict receiver.",
                    a(kind).to_lowercase()
                ))
                .flags(&["over-strict", "nested-stimulus"])
                .because("Its version is the request's."),
        );
        let frame = frame.without("ncp_version");
        cases.push(
            rejects(case(kind, "stimulus/alone-with-version", &["NCP-STRICT-002"]), kind, &frame, "missing")
                .title(format!(
                    "{} without a version is rejected by a strict receiver, though its stimulus frame has one.",
                    a(kind)
                ))
                .flags(&["L07", "nested-stimulus"])
                .because("A stimulus frame may leave its version to the request, not the other way round."),
        );
    }
    cases
}

const MODES: [(&str, Option<&str>); 5] = [
    ("active", Some("active")),
    ("hold", Some("hold")),
    ("init", Some("init")),
    ("estop", Some("estop")),
    ("absent", None),
];

fn command(mode: Option<&str>, seq: Option<i64>) -> Json {
    let mut frame = good("command_frame");
    frame = match mode {
        Some(mode) => frame.with("mode", mode.into()),
        None => frame.without("mode"),
    };
    match seq {
        Some(seq) => frame.with("seq", crate::trace::int(seq)),
        None => frame.without("seq"),
    }
}

fn unstamped() -> Vec<Case> {
    let seqs = [("zero", Some(0)), ("absent", None), ("minus-one", Some(-1)), ("least", Some(-9_007_199_254_740_991))];
    let mut cases = Vec::new();
    for (mode_name, mode) in MODES {
        for (what, seq) in seqs {
            let path = format!("stamp/{what}/{mode_name}");
            cases.push(
                rejects(
                    case("command_frame", &path, &["NCP-STRICT-004"]),
                    "command_frame",
                    &command(mode, seq),
                    "value",
                )
                .title(format!(
                    "A command with the mode {mode_name} and the seq {what} is rejected by a strict \
                                    receiver."
                ))
                .flags(&["L08"])
                .because(
                    "A strict receiver rejects a command frame whose seq is less than 1, whatever its \
                              mode; an absent one reads as 0.",
                ),
            );
        }
    }
    cases
}

fn stamped() -> Vec<Case> {
    let seqs = [("one", 1), ("two", 2), ("greatest", 9_007_199_254_740_991)];
    let mut cases = Vec::new();
    for (mode_name, mode) in MODES {
        for (what, seq) in seqs {
            let path = format!("stamp/{what}/{mode_name}");
            cases.push(
                accepts(case("command_frame", &path, &["NCP-STRICT-012"]), "command_frame", &command(mode, Some(seq)))
                    .title(format!(
                        "A command with the mode {mode_name} and the seq {what} is read by a strict receiver."
                    ))
                    .flags(&["over-strict"])
                    .because("It has a compatible version and a seq of at least 1."),
            );
        }
    }
    for kind in ["sensor_frame", "control_status", "observation_frame"] {
        for (what, seq) in [("minus-one", -1), ("least", -9_007_199_254_740_991)] {
            let frame = good(kind).with("seq", crate::trace::int(seq));
            cases.push(
                accepts(case(kind, &format!("stamp/{what}"), &["NCP-STRICT-012"]), kind, &frame)
                    .title(format!("{} with the seq {seq} is read by a strict receiver.", a(kind)))
                    .flags(&["over-strict"])
                    .because("The profile asks for a stamp on the action plane only."),
            );
        }
    }
    cases
}
