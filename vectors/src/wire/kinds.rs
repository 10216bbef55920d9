//! What a frame says that it is, and of which version.

use super::READ;
use crate::case::{Case, File};
use crate::json::Json;
use crate::model::{WIRE_VERSION, explicit, full, meaning, minimal};
use crate::roles::{a, readers};
use crate::scenario::beside;
use ncp_text::tables::tables;

pub(super) fn file() -> File {
    let mut cases = unknown_kinds();
    cases.extend(other_kinds());
    cases.extend(behind_the_expected());
    cases.extend(versions());
    let about = "Frames of an unknown kind, frames of another kind than the expected one, and versions, which \
                 decoding keeps as they are.";
    File::new("wire", "kinds", about, cases)
}

pub(super) fn kinds() -> impl Iterator<Item = &'static str> {
    tables().messages.iter().filter_map(|message| message.kind.as_deref())
}

fn unknown_kinds() -> Vec<Case> {
    let mut cases = Vec::new();
    for (kind, name) in
        [("sensor_frame", "SensorFrame"), ("command_frame", "CommandFrame"), ("close_session", "CloseSession")]
    {
        let near = [
            ("empty", String::new(), "kind-matching"),
            ("unknown", "unknown".to_owned(), "kind-matching"),
            ("message-name", name.to_owned(), "kind-matching"),
            ("full-proto-name", format!("ncp.v0.{name}"), "kind-matching"),
            ("upper-case", kind.to_uppercase(), "case-folded-kinds"),
            ("capital", format!("{}{}", kind[..1].to_uppercase(), &kind[1..]), "case-folded-kinds"),
            ("hyphen", kind.replace('_', "-"), "kind-matching"),
            ("trailing-space", format!("{kind} "), "trimmed-kinds"),
            ("leading-space", format!(" {kind}"), "trimmed-kinds"),
            ("trailing-line-feed", format!("{kind}\n"), "trimmed-kinds"),
            ("trailing-nul", format!("{kind}\u{0}"), "nul-terminated-names"),
            ("longer", format!("{kind}s"), "kind-matching"),
            ("shorter", kind[..kind.len() - 1].to_owned(), "kind-matching"),
        ];
        for (what, string, flag) in near {
            let frame = minimal(kind).with("kind", Json::string(&string));
            cases.push(
                Case::new(format!("{kind}/unknown/{what}"), &["NCP-WIRE-029"], readers(kind))
                    .title(format!(
                        "A frame of the kind {} is rejected where a `{kind}` is expected.",
                        Json::string(&string).text()
                    ))
                    .flags(&[flag])
                    .decode(kind, frame.text())
                    .rejects("kind")
                    .because("Kinds are known by their exact letters."),
            );
        }
    }
    cases
}

/// Each expected kind with frames of others that have its required fields too, so that nothing but
/// the kind is wrong.
fn other_kinds() -> Vec<Case> {
    let mut cases = Vec::new();
    for expected in kinds() {
        // The next ones of the text, and those that are easily taken for it.
        let all: Vec<_> = kinds().collect();
        let at = all.iter().position(|kind| *kind == expected).unwrap_or_default();
        let mut others: Vec<_> = (1..=2).filter_map(|step| all.get((at + step) % all.len())).copied().collect();
        others.extend(twin(expected));
        others.push("bulk_observation");
        others.sort_unstable();
        others.dedup();
        for other in others.into_iter().filter(|other| *other != expected) {
            let frame = with_what_it_needs(full(expected).with("kind", Json::string(other)), other);
            cases.push(
                Case::new(format!("{expected}/other/{other}"), &["NCP-WIRE-030"], readers(expected))
                    .title(format!(
                        "{} is rejected where a `{expected}` is expected, though it has its fields.",
                        a(other)
                    ))
                    .flags(&["kind-confusion"])
                    .decode(expected, frame.text())
                    .rejects("kind")
                    .because("The kind is a known one, and not the expected one."),
            );
        }
    }
    cases
}

/// Frames of another kind, before which the expected one stands somewhere within.
fn behind_the_expected() -> Vec<Case> {
    let mut cases = Vec::new();
    for expected in kinds() {
        let all: Vec<_> = kinds().collect();
        let at = all.iter().position(|kind| *kind == expected).unwrap_or_default();
        let other = twin(expected).or(all.get((at + 1) % all.len()).copied()).unwrap_or_default();
        let within = [
            ("object", Json::object().with("kind", expected.into()), "an object that has the expected one"),
            ("text", Json::string(format!("\"kind\":\"{expected}\"")), "a text that holds the expected one"),
        ];
        for (name, novel, words) in within {
            let begins = Json::object().with("novel", novel).with("kind", other.into());
            let frame = with_what_it_needs(with_absent(begins, &full(expected)), other);
            cases.push(
                Case::new(format!("{expected}/behind/{name}"), &["NCP-WIRE-030"], readers(expected))
                    .title(format!(
                        "{} is rejected where a `{expected}` is expected, though {words} stands before its kind.",
                        a(other)
                    ))
                    .flags(&["kind-confusion"])
                    .decode(expected, frame.text())
                    .rejects("kind")
                    .because("The kind of a frame is its own member `kind`, and nothing within another member."),
            );
        }
    }
    cases
}

/// The frame with the fields that this kind has to have, where it lacks them.
fn with_what_it_needs(frame: Json, kind: &str) -> Json {
    with_absent(frame, &minimal(kind))
}

/// The frame with those members of another that it does not have.
fn with_absent(frame: Json, other: &Json) -> Json {
    other.members().iter().fold(
        frame,
        |frame, (name, value)| {
            if frame.get(name).is_some() { frame } else { frame.and(name, value.clone()) }
        },
    )
}

/// The kind that a careless receiver takes a frame for.
fn twin(kind: &str) -> Option<&'static str> {
    Some(match kind {
        "command_frame" => "sensor_frame",
        "sensor_frame" => "command_frame",
        "step_request" => "run_request",
        "run_request" => "step_request",
        "close_session" => "session_closed",
        "session_closed" => "close_session",
        "session_opened" => "error",
        "error" => "session_opened",
        "observation_frame" => "sensor_frame",
        "control_status" => "link_status",
        "link_status" => "control_status",
        _ => return None,
    })
}

fn versions() -> Vec<Case> {
    let newer = beside(1);
    let zero = WIRE_VERSION.replacen('.', ".0", 1);
    let versions = [
        ("newer", newer.as_str()),
        ("major", "1.0"),
        ("malformed", "not a version"),
        ("empty", ""),
        ("leading-zero", &zero),
    ];
    let mut cases = Vec::new();
    for kind in crate::roles::ANY {
        for (what, version) in versions {
            let frame = explicit(kind).with("ncp_version", Json::string(version));
            cases.push(
                Case::new(format!("{kind}/version/{what}"), &[READ], readers(kind))
                    .title(format!("{} of version `{version}` is rejected, or keeps it.", a(kind)))
                    .flags(&["version-in-decoder"])
                    .decode(kind, frame.text())
                    .means_or_rejects(meaning(kind, &frame).text())
                    .because("A decoder may judge the version, but not change it."),
            );
        }
        let frame = explicit(kind);
        cases.push(
            Case::new(format!("{kind}/version/own"), &["NCP-WIRE-033"], readers(kind))
                .title(format!("{} of version `{WIRE_VERSION}` is decoded.", a(kind)))
                .flags(&["version-in-decoder"])
                .decode(kind, frame.text())
                .means(meaning(kind, &frame).text())
                .because("The version is the receiver's own."),
        );
    }
    cases
}
