//! A strict server: requests without a version, and requests at another key than their own.

use ncp_text::WIRE_VERSION;

use super::keys::VERBS;
use super::{against_version, unfit_versions};
use crate::case::{Case, File};
use crate::json::{Json, object};
use crate::scenario::{ScenarioError, beside};
use crate::session::{Open, case, close, closed, error, not_opened, observed, opened, run, step};
use crate::trace::{any, num, nums};
use crate::version::{MALFORMED, malformed};

pub(super) fn file() -> Result<File, ScenarioError> {
    let mut cases = lives();
    cases.extend(openings());
    cases.extend(unversioned());
    cases.extend(malformed_versions()?);
    cases.extend(doors());
    cases.extend(doors_of_nothing());
    cases.extend(versions_beside());
    cases.extend(stimulated());
    cases.extend(remembered());
    let about =
        "A strict server: requests without a compatible version, and requests at the control key of another kind.";
    Ok(File::new("strict", "server", about, cases))
}

/// The session of all cases.
const ID: &str = "a";

type Exchange = (String, Json);

fn open() -> Exchange {
    (Open::lif(ID).text(), opened(ID))
}

/// A step that finds the session as it was after `before` ms.
fn step_after(before: f64) -> Exchange {
    (step(ID, Some(10.0), None), observed(ID, before + 10.0))
}

/// A request of each kind, and what it is answered in a session that has run nothing.
fn request(kind: &str) -> Exchange {
    match kind {
        "open_session" => open(),
        "step_request" => step_after(0.0),
        "run_request" => (run(ID, 10.0), observed(ID, 10.0)),
        _ => (close(ID), closed(ID)),
    }
}

/// The request without its version, or with another.
fn with_version(request: &str, version: Option<&str>) -> String {
    let own = format!("\"ncp_version\":\"{WIRE_VERSION}\",");
    let other = version.map_or(String::new(), |version| format!("\"ncp_version\":\"{version}\","));
    request.replacen(&own, &other, 1)
}

/// The case, with the kind in the key at which each request comes.
fn at(case: Case, verbs: &[&str]) -> Case {
    let verbs: Json = verbs.iter().copied().collect();
    let mut case = case.strictly();
    case.args = case.args.and("verbs", verbs);
    case
}

fn lives() -> Vec<Case> {
    let life = vec![open(), step_after(0.0), (run(ID, 20.0), observed(ID, 30.0)), (close(ID), closed(ID))];
    let mut with_stimulus = Open::rate(ID);
    with_stimulus.stimuli = vec![crate::session::stimulus("drive", "rate_inject")];
    let stimulated =
        vec![(with_stimulus.text(), opened(ID)), (step(ID, Some(10.0), Some(("drive", 1.0))), observed(ID, 10.0))];
    vec![
        case("life/plain".into(), &["NCP-STRICT-012"], life.clone())
            .strictly()
            .title("A strict server carries out requests with a version.")
            .flags(&["over-strict"])
            .because("Their version is compatible, and no other chapter rejects them."),
        at(
            case("life/at-their-keys".into(), &["NCP-STRICT-012"], life),
            &["open_session", "step_request", "run_request", "close_session"],
        )
        .title("A strict server carries out requests at the keys of their kinds.")
        .flags(&["over-strict"])
        .because("Each comes at the control key of its kind."),
        case("life/stimulus".into(), &["NCP-STRICT-012"], stimulated)
            .strictly()
            .title("A strict server carries out a request whose stimulus frame leaves the version to it.")
            .flags(&["over-strict", "nested-stimulus"])
            .because("A stimulus frame within a request may still leave its version to the request."),
    ]
}

fn openings() -> Vec<Case> {
    let open_with = |(what, version): (&str, Option<String>)| {
        let refusal = match what {
            "three-parts" | "malformed" => any(vec![not_opened(ID), error()]),
            _ => not_opened(ID),
        };
        let trace = vec![
            (with_version(&Open::lif(ID).text(), version.as_deref()), refusal),
            (step(ID, Some(10.0), None), error()),
            open(),
            step_after(0.0),
        ];
        case(format!("open/{what}"), &["NCP-STRICT-008", against_version(version.as_deref())], trace)
            .strictly()
            .title(format!("A strict server does not open a session for a request whose version is {what}."))
            .flags(&["L07"])
            .because(
                "It answers `session_opened` with `ok` false, or an error frame if it is malformed, and opens nothing.",
            )
    };
    unfit_versions().into_iter().map(open_with).collect()
}

fn unversioned() -> Vec<Case> {
    let mut cases = Vec::new();
    for kind in ["step_request", "run_request", "close_session"] {
        for (what, version) in unfit_versions() {
            let (text, answer) = request(kind);
            let trace = vec![
                open(),
                (with_version(&text, version.as_deref()), error()),
                // What was not carried out is still to be done.
                (text, answer),
            ];
            cases.push(
                case(format!("{kind}/{what}"), &["NCP-STRICT-009", against_version(version.as_deref())], trace)
                    .strictly()
                    .title(format!("A strict server does not carry out a `{kind}` whose version is {what}."))
                    .flags(&["L07"])
                    .because("It answers with an error frame, and does not carry it out."),
            );
        }
    }
    // What may be answered in two ways of a session that is not open, may not where the version rejects the request.
    for (what, version) in unfit_versions() {
        let trace = vec![(with_version(&close("b"), version.as_deref()), error()), open(), step_after(0.0)];
        cases.push(
            case(
                format!("close_session/of-no-session/{what}"),
                &["NCP-STRICT-009", against_version(version.as_deref())],
                trace,
            )
            .strictly()
            .title(format!(
                "A strict server answers a `close_session` for no open session with an error frame if its version is \
                 {what}."
            ))
            .flags(&["L07"])
            .because("It answers with an error frame, and does not carry it out."),
        );
    }
    cases
}

/// Requests whose version is none, by characters that are easily lost or taken for others.
fn malformed_versions() -> Result<Vec<Case>, ScenarioError> {
    let mut cases = Vec::new();
    for (name, version) in malformed(&MALFORMED[..1])? {
        let with = |request: &str| Json::read(request).with("ncp_version", version.clone()).text();
        let opening = vec![
            (with(&Open::lif(ID).text()), any(vec![not_opened(ID), error()])),
            (step(ID, Some(10.0), None), error()),
            open(),
            step_after(0.0),
        ];
        let (text, answer) = step_after(0.0);
        let stepping = vec![open(), (with(&text), error()), (text, answer)];
        for (kind, rule, trace) in [("open", "NCP-STRICT-008", opening), ("step_request", "NCP-STRICT-009", stepping)] {
            cases.push(
                case(format!("{kind}/{name}"), &[rule, "NCP-STRICT-003", "NCP-VER-001"], trace)
                    .strictly()
                    .rests_on(format!("version/guard/strict/{name}"))
                    .title(format!(
                        "A strict server does not carry out a request ({kind}) whose version is {}.",
                        version.text()
                    ))
                    .flags(&["L07", "lenient-versions"])
                    .because("The version guard answers what is no version with an error, and nothing is carried out."),
            );
        }
    }
    Ok(cases)
}

/// Requests that carry a stimulus frame: without a version, with another, and with a stimulus frame of another.
fn stimulated() -> Vec<Case> {
    let mut rate = Open::rate(ID);
    rate.stimuli = vec![crate::session::stimulus("drive", "rate_inject")];
    let opening = || (rate.text(), opened(ID));
    let values = || object! { "drive" => object! { "data" => nums(&[1.0]) } };
    let request = |kind: &str, version: Option<&str>, stimulus: Json| {
        let time = if kind == "step_request" { "advance_ms" } else { "duration_ms" };
        let request = version.map_or_else(Json::object, |version| object! { "ncp_version" => version });
        let request = request.and("kind", kind.into()).and("session_id", ID.into()).and(time, num(10.0));
        request.and("stimulus", stimulus).text()
    };
    let of_values = |version: Option<&str>| {
        let stimulus = version.map_or_else(Json::object, |version| object! { "ncp_version" => version });
        stimulus.and("values", values())
    };
    let good = |kind: &str| (request(kind, Some(WIRE_VERSION), of_values(None)), observed(ID, 10.0));
    let mut cases = Vec::new();
    for kind in ["step_request", "run_request"] {
        let own = (request(kind, Some(WIRE_VERSION), of_values(Some(WIRE_VERSION))), observed(ID, 10.0));
        cases.push(
            case(format!("stimulated/{kind}/own/values"), &["NCP-STRICT-012"], vec![opening(), own])
                .strictly()
                .title(format!("A strict server carries out a `{kind}` with a stimulus frame of its version."))
                .flags(&["over-strict", "nested-stimulus"])
                .because("The version of the stimulus frame is the request's."),
        );
        for (what, version) in unfit_versions() {
            let with: &[(&str, Option<&str>)] = match what {
                "absent" => &[("no-version", None), ("own-version", Some(WIRE_VERSION))],
                "older" => &[("same-version", version.as_deref())],
                "malformed" if kind == "step_request" => &[("no-version", None)],
                _ => &[],
            };
            for (with, of_stimulus) in with {
                let bad = request(kind, version.as_deref(), of_values(*of_stimulus));
                cases.push(
                    case(
                        format!("stimulated/{kind}/{what}/{with}"),
                        &["NCP-STRICT-009", against_version(version.as_deref())],
                        vec![opening(), (bad, error()), good(kind)],
                    )
                    .strictly()
                    .title(format!(
                        "A strict server does not carry out a `{kind}` whose version is {what}, and whose stimulus \
                         frame has {}.",
                        with.replace('-', " ").replace("own", "its own").replace("same", "the same")
                    ))
                    .flags(&["L07", "nested-stimulus"])
                    .because("It answers with an error frame, and does not carry it out, stimulus or none."),
                );
            }
        }
        let nothing = object! { "ncp_version" => beside(-1) };
        let bad = request(kind, Some(WIRE_VERSION), nothing);
        cases.push(
            case(
                format!("stimulated/{kind}/fits-not/older/nothing"),
                &["NCP-STRICT-013", "NCP-SESS-021"],
                vec![opening(), (bad, error()), good(kind)],
            )
            .strictly()
            .title(format!(
                "A strict server does not carry out a `{kind}` whose stimulus frame has an older version and nothing \
                 else."
            ))
            .flags(&["nested-stimulus"])
            .because("A strict receiver rejects a request whose stimulus frame has another version than it."),
        );
    }
    cases
}

/// Kinds that are no requests, and so no control keys either.
const NO_VERBS: [&str; 3] = ["session_opened", "observation_frame", "command_frame"];

/// Requests at another key than their own that would be refused at their own as well, in another way.
fn doors_of_nothing() -> Vec<Case> {
    let network = object! { "kind" => "builtin", "ref" => "ncp.no.such.network" };
    let unknown = Json::read(&Open::lif(ID).text()).with("network", network).text();
    let mut cases = Vec::new();
    let mut add = |path: String, words: &str, before: Option<Exchange>, text: &str, verb: &str, then: Exchange| {
        let mut verbs: Vec<&str> = before.iter().map(|_| "open_session").collect();
        verbs.extend([verb, if then.0.contains("step_request") { "step_request" } else { "open_session" }]);
        let trace = before.into_iter().chain([(text.to_owned(), error()), then]).collect();
        cases.push(
            at(case(format!("door/{path}/{verb}"), &["NCP-STRICT-007"], trace), &verbs)
                .title(format!("A strict server answers {words} at the key of `{verb}` with an error frame."))
                .flags(&["L04"])
                .because("A request at another control key than that of its kind is answered with an error frame."),
        );
    };
    let open_text = Open::lif(ID).text();
    for verb in ["step_request", "command_frame"] {
        let words = "an `open_session` for a session that is open";
        add("open-already".into(), words, Some(open()), &open_text, verb, step_after(0.0));
    }
    let words = "an `open_session` of an unknown network";
    add("unknown-network".into(), words, None, &unknown, "run_request", open());
    let words = "a `close_session` for no open session";
    add("close-of-no-session".into(), words, None, &close(ID), "step_request", open());
    cases
}

/// Openings of another version, of a network that the server lacks or for a session that is open.
fn versions_beside() -> Vec<Case> {
    let network = object! { "kind" => "builtin", "ref" => "ncp.no.such.network" };
    let older = beside(-1);
    let of = |request: Json| with_version(&request.text(), Some(&older));
    let plain = || Json::read(&Open::lif(ID).text());
    [
        ("unknown-network", "of an unknown network", vec![(of(plain().with("network", network)), not_opened(ID))]),
        ("open-already", "for a session that is open", vec![open(), (of(plain()), not_opened(ID)), step_after(0.0)]),
    ]
    .into_iter()
    .map(|(name, words, trace)| {
        let was_open = trace.len() > 1;
        let case = case(format!("open/older/{name}"), &["NCP-STRICT-008", "NCP-SESS-023"], trace);
        // What was open stays so.
        let case = if was_open { case.by("/replies/2", "NCP-SESS-027") } else { case };
        case.strictly()
            .title(format!(
                "A strict server answers an `open_session` of an older version {words} with a `session_opened` that \
                 refuses."
            ))
            .flags(&["L07"])
            .because("It answers `session_opened` with `ok` false, and opens nothing.")
    })
    .collect()
}

/// Every request at the key of every other, and at keys of kinds that are no requests.
fn doors() -> Vec<Case> {
    let mut cases = Vec::new();
    for kind in VERBS {
        for verb in VERBS.into_iter().chain(NO_VERBS).filter(|verb| *verb != kind) {
            let (text, answer) = request(kind);
            let (mut trace, mut verbs) = (Vec::new(), Vec::new());
            if kind != "open_session" {
                trace.push(open());
                verbs.push("open_session");
            }
            trace.extend([(text.clone(), error()), (text, answer)]);
            verbs.extend([verb, kind]);
            cases.push(
                at(case(format!("door/{kind}/{verb}"), &["NCP-STRICT-007"], trace), &verbs)
                    .title(format!("A strict server does not carry out a `{kind}` at the key of `{verb}`."))
                    .flags(&["L04"])
                    .because(
                        "The request comes at another control key than that of its kind: an error frame, and \
                              it is not carried out.",
                    ),
            );
        }
    }
    cases
}

/// Requests that are rejected after others of their kind were carried out: each is judged by itself.
fn remembered() -> Vec<Case> {
    let mut cases = Vec::new();
    // One that is there and does not fit; what fits none at all is asked of each request elsewhere.
    if let Some((what, version)) = unfit_versions().into_iter().nth(1) {
        let (good, _) = step_after(0.0);
        let bad = with_version(&good, version.as_deref());
        let trace = vec![open(), step_after(0.0), (bad, error()), step_after(10.0)];
        cases.push(
            case(format!("remembered/{what}"), &["NCP-STRICT-009", against_version(version.as_deref())], trace)
                .strictly()
                .title(format!(
                    "A strict server does not carry out a step whose version is {what} after one with its own."
                ))
                .flags(&["L07"])
                .because("It answers with an error frame, and does not carry it out, whatever came before."),
        );
    }
    let verb = "run_request";
    let (good, _) = step_after(0.0);
    let trace = vec![open(), step_after(0.0), (good, error()), step_after(10.0)];
    cases.push(
        at(
            case(format!("remembered/at-{verb}"), &["NCP-STRICT-007"], trace),
            &["open_session", "step_request", verb, "step_request"],
        )
        .title(format!("A strict server does not carry out a step at the key of `{verb}` after one at its own."))
        .flags(&["L04"])
        .because("The request comes at another control key than that of its kind, whatever came before."),
    );
    cases
}
