//! The control keys of the strict profile: one for each kind of request, and no others.

use crate::case::Role::{Commander, Server};
use crate::case::{Case, File};
use crate::json::{Json, object};

/// The kinds of requests.
pub(super) const VERBS: [&str; 4] = ["open_session", "step_request", "run_request", "close_session"];

pub(super) fn file() -> File {
    let mut cases = built();
    cases.extend(refused());
    cases.extend(realms());
    let about = "The control keys of the strict profile: one for each kind of request, and none for anything else.";
    File::new("strict", "keys", about, cases)
}

fn case(path: String, rules: &[&'static str], realm: Option<&str>, verb: &str) -> Case {
    let args = object! { "key" => "rpc", "realm" => realm, "verb" => verb };
    Case::new(path, rules, &[Commander, Server]).flags(&["L04"]).call("key.build", args)
}

fn built() -> Vec<Case> {
    let realms = [("default-realm", None), ("realm", Some("lab")), ("realm-of-two", Some("engram/ncp"))];
    let mut cases = Vec::new();
    for verb in VERBS {
        for (what, realm) in realms {
            let in_realm = realm.unwrap_or("ncp");
            cases.push(
                case(format!("{verb}/{what}"), &["NCP-STRICT-001"], realm, verb)
                    .title(format!("The strict control key of `{verb}` in the realm `{in_realm}` ends in its kind."))
                    .gives(object! { "key" => format!("{in_realm}/rpc/{verb}") })
                    .because("The control key of a request is `{realm}/rpc/{kind}`."),
            );
        }
    }
    cases
}

fn refused() -> Vec<Case> {
    let others = [
        ("session-opened", "session_opened"),
        ("session-closed", "session_closed"),
        ("observation-frame", "observation_frame"),
        ("stimulus-frame", "stimulus_frame"),
        ("sensor-frame", "sensor_frame"),
        ("command-frame", "command_frame"),
        ("capabilities", "capabilities"),
        ("error", "error"),
        ("empty", ""),
        ("unknown", "reset_session"),
        ("short", "open"),
        ("upper-case", "OPEN_SESSION"),
        ("message-name", "OpenSession"),
        ("trailing-space", "open_session "),
        ("more-chunks", "open_session/a"),
        ("wildcard", "*"),
        ("wildcards", "**"),
    ];
    let refuse = |(what, verb): (&str, &str)| {
        case(format!("refused/{what}"), &["NCP-STRICT-006"], Some("lab"), verb)
            .title(format!(
                "There is no strict control key of {}, which is no kind of a request.",
                Json::string(verb).text()
            ))
            .rejects("key")
            .because("A strict key builder refuses anything but the four kinds of requests.")
    };
    others.into_iter().map(refuse).collect()
}

fn realms() -> Vec<Case> {
    let broken = [("empty-segment", "a//b"), ("space", "a b"), ("wildcard", "a/*"), ("hidden", "@a")];
    let refuse = |(what, realm): (&str, &str)| {
        case(format!("realm/{what}"), &["NCP-STRICT-001", "NCP-KEY-018"], Some(realm), "step_request")
            .title(format!("The strict control key in the realm `{realm}` is refused."))
            .rejects("key")
            .because("All other rules stay: the realm is checked segment by segment.")
    };
    broken.into_iter().map(refuse).collect()
}
