//! The verifier's reader of what a peer prints.

use ncp_spec::wire::decode_any;
use ncp_verifier::json::{Json, JsonFault};
use ncp_verifier::peer::{Answer, Reply, ReplyFault, excerpt};
use serde_json::Value;

/// A line is taken for the answer that another JSON reader finds in it, and for none otherwise.
///
/// The same reader, which refuses repeated members, is held against the specification's: a frame that
/// is read is JSON without them at any depth.
///
/// It would find a line by which a peer makes the verifier panic, an answer that is charged to another
/// request, a peer that passes by answering twice in one line, and a repeated member that a decoder
/// overlooks.
// [NCP-WIRE-002] [NCP-WIRE-007] [NCP-WIRE-008]
pub fn peer_protocol(input: &[u8]) {
    if decode_any(input).is_ok() {
        let text = std::str::from_utf8(input).expect("a frame is UTF-8");
        assert_eq!(Json::parse(text).err(), None, "a frame is read that is no JSON");
    }
    let shown = excerpt(input, 40);
    assert!(!shown.chars().any(char::is_control), "a terminal would act on {shown:?}");

    let read = Reply::parse(input);
    let value = serde_json::from_slice::<Value>(input);
    match &read {
        Ok(reply) => {
            let value = value.expect("an answer is JSON");
            assert_eq!(value["id"].as_u64(), Some(reply.id));
            let has = |name: &str| value.get(name).is_some();
            let forms = [has("result"), has("error"), has("unsupported")];
            let expected = match &reply.answer {
                Answer::Result(result) => {
                    agrees(result, &value["result"]);
                    [true, false, false]
                }
                Answer::Error { code, message } => {
                    assert_eq!(value["error"]["code"], **code);
                    assert_eq!(value["error"]["message"].as_str().unwrap_or_default(), message);
                    [false, true, false]
                }
                Answer::Unsupported => {
                    assert_eq!(value["unsupported"], true);
                    [false, false, true]
                }
            };
            assert_eq!(forms, expected);
        }
        Err(fault) => judge_fault(fault, value.ok().as_ref()),
    }
}

/// A line that is refused is one that the other reader refuses too, or one whose shape is wrong.
fn judge_fault(fault: &ReplyFault, value: Option<&Value>) {
    assert!(!fault.to_string().is_empty());
    match (fault, value) {
        (ReplyFault::Json(error), Some(_)) => {
            // serde_json keeps the last of two members.
            assert!(matches!(error.what, JsonFault::Duplicate(_)), "{error}");
        }
        (ReplyFault::Utf8, Some(_)) => panic!("UTF-8 is not taken for it"),
        (ReplyFault::NoId, Some(value)) => {
            assert!(!value["id"].is_u64(), "the id is not seen");
        }
        (ReplyFault::Shape { id, .. }, Some(value)) => {
            assert_eq!(value["id"].as_u64(), Some(*id));
            let forms = ["result", "error", "unsupported"];
            let count = forms.iter().filter(|name| value.get(**name).is_some()).count();
            let bad_error = value.get("error").is_some_and(|error| !error["code"].is_string());
            let bad_flag = value.get("unsupported").is_some_and(|flag| *flag != true);
            assert!(count != 1 || bad_error || bad_flag);
        }
        (_, None) => {}
    }
}

/// Two readings of one value are equal, and what is written of it is read as equal again.
fn agrees(read: &Json<'_>, value: &Value) {
    let mut text = String::new();
    read.write_to(&mut text);
    assert_eq!(serde_json::from_str::<Value>(&text).ok().as_ref(), Some(value));
    assert_eq!(Json::parse(&text).as_ref(), Ok(read));
}
