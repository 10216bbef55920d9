//! The freedoms of `decode`, `encode` and `reply.check`.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use ncp_spec::version::check_version;
use ncp_text::WIRE_VERSION;
use ncp_text::tables::{Default, Message, Shape, tables};

use super::open::{Freedom, freedom, is_advice};
use super::{Outcome, Verdict, accept, reject};
use crate::fuzz::tree::{Tree, items, members, object, set, string, text};
use crate::json::Json;

/// The bytes of a frame that is given as text or in base64.
pub(crate) fn bytes(holder: &Json<'_>) -> Vec<u8> {
    match (string(holder, "text"), string(holder, "base64")) {
        (Some(text), _) => text.as_bytes().to_vec(),
        (_, Some(encoded)) => STANDARD.decode(encoded).unwrap_or_default(),
        _ => Vec::new(),
    }
}

pub(super) fn is_strict(args: &Json<'_>) -> bool {
    args.get("strict") == Some(&Json::Bool(true))
}

pub(super) fn decode(args: &Tree, result: Outcome<'_>) -> Verdict {
    let frame = bytes(args);
    let may_reject = match freedom(string(args, "kind").unwrap_or_default(), &frame, is_strict(args)) {
        Freedom::Open(why) => return Verdict::Open(why),
        Freedom::MayRejectFor(why) if result.is_err() => return Verdict::Open(why),
        freedom => freedom != Freedom::None,
    };
    match result {
        Err(_) if may_reject => Verdict::Open("a version that may be rejected, WIRE-039"),
        Err(code) => reject(code),
        Ok(result) => match string(result, "text") {
            None => accept(),
            Some(frame) => {
                let mut expect = object([("relation", text("message")), ("text", text(frame))]);
                if may_reject {
                    set(&mut expect, "or_reject", Json::Bool(true));
                }
                Verdict::Expect(expect)
            }
        },
    }
}

pub(super) fn encode(args: &Tree, result: Outcome<'_>) -> Verdict {
    let fields = args.get("fields");
    let member = |name: &str| fields.and_then(|fields| fields.get(name));
    if let Some(stimulus) = member("stimulus").filter(|_| member("network").is_none())
        && (stimulus.get("session_id") != member("session_id") || stimulus.get("ncp_version") != member("ncp_version"))
        && !stimulus.is_null()
    {
        return Verdict::Open("a stimulus whose defaults may be the request's");
    }
    let known = |name: &str, wanted: &[&str]| {
        member(name).is_none_or(|mode| mode.as_str().is_some_and(|mode| wanted.contains(&mode)))
    };
    if !known("mode", &["init", "active", "hold", "estop"]) {
        return Verdict::Open("a mode that is none may be refused, or written as hold");
    }
    let message = tables().kind(string(args, "kind").unwrap_or_default());
    if message.is_some_and(|message| lacks_required(message, fields)) {
        return Verdict::Open("a required field without a value, for which no table has a default");
    }
    match result {
        Err("non_finite") => reject("non_finite"),
        Err(_) => Verdict::Open("a message that every receiver rejects, WIRE-091"),
        Ok(result) => match string(result, "text") {
            Some(frame) => Verdict::Expect(object([("relation", text("encoding")), ("text", text(frame))])),
            None => Verdict::Open("the specification writes no frame"),
        },
    }
}

/// Whether a message to be built, or one within it, names no value for a field that it has to have.
fn lacks_required(message: &Message, fields: Option<&Tree>) -> bool {
    message.fields.iter().any(|field| match fields.and_then(|fields| fields.get(&field.name)) {
        None => field.default == Default::Required,
        Some(value) => lacks_within(&field.shape, value),
    })
}

fn lacks_within(shape: &Shape, value: &Tree) -> bool {
    match shape {
        Shape::Message(name) if matches!(value, Json::Object(_)) => {
            tables().message(name).is_some_and(|message| lacks_required(message, Some(value)))
        }
        Shape::List(item) => items(Some(value)).iter().any(|value| lacks_within(item, value)),
        Shape::Map(of) => members(Some(value)).iter().any(|(_, value)| lacks_within(of, value)),
        _ => false,
    }
}

pub(super) fn reply(args: &Tree, result: Outcome<'_>) -> Verdict {
    let request = string(args, "request").and_then(|text| Json::parse(text).ok());
    let asked = request.as_ref().and_then(|request| request.get("ncp_version")).and_then(Json::as_str);
    let reply = string(args, "reply").unwrap_or_default();
    let parsed = Json::parse(reply).ok();
    let kind = parsed.as_ref().and_then(|reply| reply.get("kind")).and_then(Json::as_str).unwrap_or_default();
    if kind == "error" {
        // It is an error whether it can be read or not.
        return result.map_or_else(reject, |_| Verdict::Open("the specification takes an error frame for none"));
    }
    if let Freedom::Open(why) | Freedom::MayRejectFor(why) = freedom(kind, reply.as_bytes(), is_strict(args)) {
        return Verdict::Open(why);
    }
    let version = parsed.as_ref().and_then(|reply| reply.get("ncp_version")).and_then(Json::as_str);
    if version.is_some_and(is_advice) {
        return Verdict::Open("a version with leading zeros or a large part, VER-009");
    }
    // [NCP-SESS-003] A reply of another version is none, in whichever the client asked.
    let is_of_another = version.is_some_and(|version| check_version(version, false) != Ok(true));
    let is_own = match asked {
        Some(version) => version == WIRE_VERSION,
        // Who names none has the wire version, but to the strict.
        None => !is_strict(args) && request.is_some_and(|request| request.get("ncp_version").is_none()),
    };
    if !(is_own || is_of_another && result.is_err()) {
        return Verdict::Open("the request is none of this version");
    }
    result.map_or_else(reject, |_| accept())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_array_in_a_member_that_is_ignored_changes_nothing_of_the_frame() {
        let long = format!("[{}0]", "0,".repeat(5000));
        let frame = format!(r#"{{"ncp_version":"{WIRE_VERSION}","kind":"command_frame","seq":7,"novel":{long}}}"#);
        let args = object([("kind", text("command_frame")), ("text", text(frame))]);
        let spec = specification(Call::Decode, &args.to_string());
        let Verdict::Expect(expect) = expectation(&Input { call: Call::Decode, args }, &spec, None) else {
            panic!("it is rejected, or read without that member");
        };
        assert_eq!(expect.get("or_reject"), Some(&Json::Bool(true)));
        assert!(string(&expect, "text").is_some_and(|text| text.contains("\"seq\":7")));
    }

    use crate::fuzz::Input;
    use crate::fuzz::oracle::{expectation, specification};
    use crate::fuzz::tree::own;
    use crate::peer::Call;

    #[test]
    fn a_reply_of_another_version_is_rejected_also_where_the_client_asked_in_it() {
        let verdict = |asked: &str, answered: &str| {
            let of = |kind: &str, version: &str| {
                text(format!(r#"{{"ncp_version":"{version}","kind":"{kind}","session_id":"a"}}"#))
            };
            let pair = [("request", of("close_session", asked)), ("reply", of("session_closed", answered))];
            let args = object(pair);
            let spec = specification(Call::ReplyCheck, &args.to_string());
            expectation(&Input { call: Call::ReplyCheck, args: own(&args) }, &spec, None)
        };
        let rejects = |verdict: Verdict| matches!(&verdict, Verdict::Expect(expect) if expect.get("reject").is_some());
        assert!(rejects(verdict("0.4", "0.4")));
        assert!(rejects(verdict(WIRE_VERSION, "0.4")));
        assert!(!rejects(verdict(WIRE_VERSION, WIRE_VERSION)));
        assert!(matches!(verdict("0.4", WIRE_VERSION), Verdict::Open(_)));
        // A request that names no version is one of this version.
        let args = object([
            ("request", text(r#"{"kind":"close_session","session_id":"a"}"#)),
            ("reply", text(r#"{"kind":"session_closed","session_id":"a"}"#)),
        ]);
        let spec = specification(Call::ReplyCheck, &args.to_string());
        let unversioned = expectation(&Input { call: Call::ReplyCheck, args }, &spec, None);
        assert!(matches!(unversioned, Verdict::Expect(_)) && !rejects(unversioned));
    }
}
