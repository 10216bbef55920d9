//! What a strict client accepts as the reply to its request.

use ncp_text::WIRE_VERSION;

use super::incompatible;
use crate::case::Role::Commander;
use crate::case::{Case, File};
use crate::json::{Json, object};
use crate::model::explicit;

/// The requests and the kinds that answer them.
const PAIRS: [(&str, &str); 4] = [
    ("open_session", "session_opened"),
    ("step_request", "observation_frame"),
    ("run_request", "observation_frame"),
    ("close_session", "session_closed"),
];

pub(super) fn file() -> File {
    let cases = PAIRS.iter().flat_map(|(request, reply)| cases(request, reply)).collect();
    let about = "What a strict client accepts as the reply to its request.";
    File::new("strict", "replies", about, cases)
}

fn cases(request: &str, reply: &str) -> Vec<Case> {
    let case = |path: &str, rules: &[&'static str], frame: Json| {
        let args = object! { "request" => explicit(request).text(), "reply" => frame.text() };
        Case::new(format!("{request}/{path}"), rules, &[Commander]).call("reply.check", args).strictly()
    };
    let fitting = explicit(reply);
    let mut cases = vec![
        case("fitting", &["NCP-STRICT-012"], fitting.clone())
            .title(format!("A strict client accepts a `{reply}` with a version as the reply to a `{request}`."))
            .flags(&["over-strict"])
            .accepts()
            .because("It has a compatible version, and kind and session fit."),
        case("without-version", &["NCP-STRICT-002"], fitting.clone().without("ncp_version"))
            .title(format!("A strict client rejects a `{reply}` without a version as the reply to a `{request}`."))
            .flags(&["L07"])
            .rejects("missing")
            .because("A strict receiver rejects a frame without `ncp_version`, on every plane."),
    ];
    cases.extend(incompatible().map(|(what, version)| {
        case(what, &["NCP-STRICT-003"], fitting.clone().with("ncp_version", version.as_str().into()))
            .title(format!(
                "A strict client rejects a `{reply}` of the version `{version}` as the reply to a `{request}`."
            ))
            .flags(&["L07"])
            .rejects("version")
            .because(format!(
                "The version guard of chapter 2 does not hold that version compatible with {WIRE_VERSION}."
            ))
    }));
    cases
}
