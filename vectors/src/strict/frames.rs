//! Frames as a strict receiver reads them: their versions on every plane, and the stamps of commands.

use super::incompatible;
use crate::case::{Case, File};
use crate::json::{Json, object};
use crate::model::{explicit, meaning, minimal};
use crate::patch::patched;
use crate::roles::{ANY, a, readers};
use crate::scenario::{Row, ScenarioError, Scenarios, beside, source};
use crate::template::Text;
use crate::version::{MALFORMED, malformed};
use crate::wire::versions_of_errors;
use ncp_text::WIRE_VERSION;
use ncp_text::tables::tables;

pub(super) fn file() -> Result<File, ScenarioError> {
    let kinds = tables().messages.iter().filter_map(|message| message.kind.as_deref());
    let mut cases = Vec::new();
    for kind in kinds {
        if kind == "error" {
            cases.extend(errors());
        } else {
            cases.extend(versions(kind));
        }
    }
    cases.extend(malformed_versions()?);
    cases.extend(late_versions());
    cases.extend(Scenarios::read(source!("strict/frames"))?.rest(row_case)?);
    let about = "Frames of every kind at a strict receiver: with a version, without one, with another, and commands \
                 without a stamp.";
    Ok(File::new("strict", "frames", about, cases))
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

/// Frames whose version is none, by characters that are easily lost or taken for others.
fn malformed_versions() -> Result<Vec<Case>, ScenarioError> {
    let mut cases = Vec::new();
    for kind in ANY {
        cases.extend(malformed(&MALFORMED[..3])?.into_iter().map(|(name, version)| {
            let frame = good(kind).with("ncp_version", version.clone());
            rejects(case(kind, &format!("version/{name}"), &["NCP-STRICT-003", "NCP-VER-001"]), kind, &frame, "version")
                .rests_on(format!("version/guard/strict/{name}"))
                .title(format!("{} of the version {} is rejected by a strict receiver.", a(kind), version.text()))
                .flags(&["L07", "lenient-versions"])
                .because("The version guard of chapter 2 answers what is no version with an error.")
        }));
    }
    Ok(cases)
}

/// The error frame has no version that could be missing.
fn errors() -> Vec<Case> {
    let frame = minimal("error");
    let about = frame.clone().with("session_id", "s1".into());
    let mut cases: Vec<Case> = [("bare", frame.clone()), ("with-session", about)]
        .map(|(what, frame)| {
            accepts(case("error", what, &["NCP-STRICT-012"]), "error", &frame)
                .title(format!("An error frame ({what}) is read by a strict receiver without a version."))
                .flags(&["over-strict"])
                .because("The error frame has no version, so these rules let it through.")
        })
        .into();
    cases.extend(versions_of_errors().map(|(what, version)| {
        let frame = frame.clone().and("ncp_version", Json::literal(version.as_str()));
        accepts(case("error", &format!("version-{what}"), &["NCP-STRICT-012", "NCP-WIRE-026"]), "error", &frame)
            .rests_on(format!("wire/members/error/unknown-name/version-{what}"))
            .title(format!("An error frame with the member `ncp_version` of {version} is read by a strict receiver."))
            .flags(&["over-strict"])
            .because("A member `ncp_version` of an error frame is none of its own, and is ignored.")
    }));
    cases
}

/// A version that stands behind many members, or behind a long one.
fn late_versions() -> Vec<Case> {
    let mut cases = Vec::new();
    for (kind, length) in [("sensor_frame", 70_000), ("command_frame", 1_000_000)] {
        let bare = good(kind).without("ncp_version");
        let many = (0..70).fold(bare.clone(), |frame, nth| frame.and(&format!("n{nth}"), 0_u32.into()));
        let many = many.and("ncp_version", WIRE_VERSION.into());
        cases.push(
            accepts(case(kind, "version/behind-70", &["NCP-STRICT-012"]), kind, &many)
                .title(format!("{} whose version stands behind seventy members is read by a strict receiver.", a(kind)))
                .flags(&["over-strict"])
                .because("The order of members does not count, nor does their number."),
        );
        let bare_text = bare.text();
        let text = Text::concat([
            format!("{},\"pad\":\"", bare_text.strip_suffix('}').unwrap_or(&bare_text)).into(),
            Text::repeat("x", length),
            format!("\",\"ncp_version\":\"{WIRE_VERSION}\"}}").into(),
        ]);
        cases.push(
            case(kind, &format!("version/behind-{length}-letters"), &["NCP-STRICT-012"])
                .decode(kind, text)
                .means(meaning(kind, &good(kind)).text())
                .strictly()
                .title(format!(
                    "{} whose version stands behind a string of {length} letters is read by a strict receiver.",
                    a(kind)
                ))
                .flags(&["over-strict"])
                .because("The order of members does not count, nor does their length."),
        );
    }
    cases
}

/// A case of a row, as `frames.txt` says how they are written.
fn row_case(row: &Row) -> Result<Case, ScenarioError> {
    let kind = row.kind()?;
    let frame = patched(good(kind), &row.text("frame")?, row.place)?;
    let case = row.case(readers(kind));
    Ok(match row.cell("expect")? {
        "read" => accepts(case, kind, &frame),
        "read-escaped" => {
            let text = frame.text().replacen("ncp_version", "ncp_versio\\u006e", 1);
            case.decode(kind, text).means(meaning(kind, &frame).text()).strictly()
        }
        code => rejects(case, kind, &frame, code),
    })
}
