//! What a strict client accepts as the reply to its request.

use ncp_text::WIRE_VERSION;

use crate::case::{Case, File, Role};
use crate::json::{Json, object};
use crate::model::explicit;
use crate::roles::a;
use crate::scenario::{ScenarioError, Scenarios, source};
use crate::template::Text;
use crate::version::{MALFORMED, malformed};
use crate::wire::reply;

pub(super) fn file() -> Result<File, ScenarioError> {
    let text = Scenarios::read(source!("strict/replies"))?;
    let mut cases = text.rest(|row| Ok(reply(row, explicit(&row.fill("{pair.name}")?))?.strictly()))?;
    cases.extend(malformed_versions()?);
    cases.extend(late_versions());
    let about = "What a strict client accepts as the reply to its request.";
    Ok(File::new("strict", "replies", about, cases))
}

/// Replies whose version is none, by characters that are easily lost or taken for others.
fn malformed_versions() -> Result<Vec<Case>, ScenarioError> {
    let (request, kind) = ("step_request", "observation_frame");
    let case = |(name, version): (&str, Json)| {
        let reply = explicit(kind).with("ncp_version", version.clone()).text();
        Case::new(format!("{request}/{name}"), &["NCP-STRICT-003", "NCP-VER-001"], &[Role::Commander])
            .rests_on(format!("version/guard/strict/{name}"))
            .title(format!(
                "A strict client rejects {} of the version {} as the reply to a `{request}`.",
                a(kind).to_lowercase(),
                version.text()
            ))
            .flags(&["L07", "lenient-versions"])
            .call("reply.check", object! { "request" => explicit(request).text(), "reply" => reply })
            .strictly()
            .rejects("version")
            .because("The version guard of chapter 2 answers what is no version with an error.")
    };
    Ok(malformed(&MALFORMED[..2])?.into_iter().map(case).collect())
}

/// Replies whose version stands behind many members, or behind a long one.
fn late_versions() -> Vec<Case> {
    let mut cases = Vec::new();
    let (request, kind) = ("step_request", "observation_frame");
    let bare = explicit(kind).without("ncp_version");
    let many = (0..70).fold(bare.clone(), |frame, nth| frame.and(&format!("n{nth}"), 0_u32.into())).text();
    let bare = bare.text();
    let open = |frame: &str| frame.strip_suffix('}').unwrap_or(frame).to_owned();
    let long = Text::concat([format!("{},\"pad\":\"", open(&bare)).into(), Text::repeat("x", 70_000), "\"".into()]);
    for (name, before, words) in [
        ("behind-70", Text::from(open(&many)), "seventy members"),
        ("behind-70000-letters", long, "a string of 70,000 letters"),
    ] {
        let reply = Text::concat([before, format!(",\"ncp_version\":\"{WIRE_VERSION}\"}}").into()]);
        cases.push(
            Case::new(format!("{request}/version-{name}"), &["NCP-STRICT-012"], &[Role::Commander])
                .title(format!("A strict client accepts a `{kind}` whose version stands behind {words}."))
                .flags(&["over-strict"])
                .call("reply.check", object! { "request" => explicit(request).text(), "reply" => reply.json() })
                .strictly()
                .accepts()
                .because("The order of members does not count, nor does their number or length."),
        );
    }
    cases
}
