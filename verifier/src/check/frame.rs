//! Equal frames: as messages, and as encodings.

use std::collections::{BTreeSet, HashMap};

use ncp_spec::wire::{self, Kind};

use super::compare::{Found, Relation, compare};
use super::{Difference, Differences};
use crate::json::{Json, Members};

/// Compares a frame with the expected one as messages.
///
/// An encoder's faults are none of a decoder's: the order of members, the spelling of numbers, `null` for an
/// absent optional and a member left out that has its default do not count. Values do: doubles by their bits,
/// integers exactly, a member that stands twice never.
pub(super) fn same_message(expected: &str, got: &str, ignore: &[String], differences: &mut Differences) {
    // The suite was read before; and an answer letter for letter as expected needs no second look.
    let (false, Ok(expected_frame)) = (expected == got, Json::parse(expected)) else {
        return;
    };
    let Some(got_frame) = parse(got, differences) else {
        return;
    };
    let mut found = compare(Relation::Message, &expected_frame, &got_frame);
    found.retain(|found| !ignore.iter().any(|spared| is_within(&found.at, spared)));
    let mut refused = None;
    if found.iter().any(Found::is_one_sided) {
        // What the frame means with such a member, or without it, the spec knows.
        let (expected, got) = without_equal_numbers(&expected_frame, &got_frame);
        match (normalise(&expected_frame, &expected.to_string()), normalise(&expected_frame, &got.to_string())) {
            (Ok(expected), Ok(got)) => settle(&mut found, &expected, &got),
            (_, Err(why)) | (Err(why), _) => refused = Some(why),
        }
    }
    found.iter().for_each(|found| found.note(differences));
    if let Some(why) = refused {
        let hint = format!("and the spec refuses the frame: {why}");
        differences.first.iter_mut().for_each(|difference| difference.hint = Some(hint.clone()));
    }
}

/// Compares a frame with the expected one as encodings: the same members in the same order, unset optionals `null`,
/// integers spelled as integers, doubles equal bit by bit however they are spelled. White space is free.
pub(super) fn same_encoding(expected: &str, got: &str, differences: &mut Differences) {
    let (false, Ok(expected)) = (expected == got, Json::parse(expected)) else {
        return;
    };
    if let Some(got) = parse(got, differences) {
        let free = may_write_null_session(&expected, &got);
        let mut found = compare(Relation::Encoding, &expected, &got);
        found.retain(|found| !(free && found.at == "/session_id"));
        found.iter().for_each(|found| found.note(differences));
    }
}

/// Whether an error frame that names no session may say so by `null`, too. [NCP-WIRE-102]
fn may_write_null_session(expected: &Json<'_>, got: &Json<'_>) -> bool {
    let is_error = expected.get("kind").and_then(Json::as_str) == Some(Kind::Error.as_str());
    is_error && expected.get("session_id").is_none() && got.get("session_id").is_some_and(Json::is_null)
}

/// Reads the peer's frame, or notes that it is none.
fn parse<'g>(got: &'g str, differences: &mut Differences) -> Option<Json<'g>> {
    let wrong = match Json::parse(got) {
        Ok(frame @ Json::Object(_)) => return Some(frame),
        Ok(other) => format!("it is {}", other.kind()),
        Err(error) => error.to_string(),
    };
    differences.push(Difference {
        at: String::new(),
        expected: Some("a frame".to_owned()),
        got: Some(super::excerpt(got.as_bytes(), super::SHOWN)),
        hint: Some(wrong),
    });
    None
}

/// Both frames without the arrays of numbers in which they agree: what is left says the same of all other members, and
/// is not too long for a frame where an answer has more white space, or longer numbers, than the frame that came.
fn without_equal_numbers<'v>(expected: &Json<'v>, got: &Json<'v>) -> (Json<'v>, Json<'v>) {
    match (expected, got) {
        (Json::Array(of_expected), Json::Array(of_got)) => {
            let are_numbers = of_expected.iter().all(|item| matches!(item, Json::Number(_)));
            if are_numbers && compare(Relation::Message, expected, got).is_empty() {
                return (Json::Array(Vec::new()), Json::Array(Vec::new()));
            }
            if of_expected.len() != of_got.len() {
                return (expected.clone(), got.clone());
            }
            let both = of_expected.iter().zip(of_got).map(|(expected, got)| without_equal_numbers(expected, got));
            let (expected, got) = both.unzip();
            (Json::Array(expected), Json::Array(got))
        }
        (Json::Object(of_expected), Json::Object(of_got)) => {
            let mut rest: HashMap<&str, Json<'v>> = HashMap::new();
            let (in_got, mut of_left) = (Members::new(of_got), Vec::new());
            for (place, (name, value)) in of_expected.iter().enumerate() {
                let left = in_got.get(name, place).map(|got| without_equal_numbers(value, got));
                let (value, got) = left.map_or((value.clone(), None), |(value, got)| (value, Some(got)));
                of_left.push((name.clone(), value));
                rest.extend(got.map(|got| (name.as_ref(), got)));
            }
            let of_rest = of_got
                .iter()
                .map(|(name, value)| (name.clone(), rest.remove(name.as_ref()).unwrap_or_else(|| value.clone())));
            let of_rest = of_rest.collect();
            (Json::Object(of_left), Json::Object(of_rest))
        }
        _ => (expected.clone(), got.clone()),
    }
}

/// What the spec reads in a frame of the expected one's kind, as the spec writes it.
fn normalise(expected: &Json<'_>, frame: &str) -> Result<String, String> {
    let kind = expected.get("kind").and_then(Json::as_str).and_then(Kind::parse);
    let kind = kind.ok_or("it has no known kind")?;
    let message = wire::decode(kind, frame.as_bytes()).map_err(|error| error.to_string())?;
    message.encode().map_err(|error| error.to_string())
}

/// Whether a path leads to `place` or to something in it.
fn is_within(path: &str, place: &str) -> bool {
    path.strip_prefix(place).is_some_and(|rest| rest.is_empty() || rest.starts_with('/'))
}

/// Drops the members on one side only that mean nothing: where the two frames, both as the spec writes them, agree.
fn settle(found: &mut Vec<Found<'_>>, expected: &str, got: &str) {
    // The spec's own encoding is JSON.
    let (Ok(expected), Ok(got)) = (Json::parse(expected), Json::parse(got)) else {
        return;
    };
    let remaining = compare(Relation::Message, &expected, &got);
    let places: BTreeSet<&str> = remaining.iter().map(|found| found.at.as_str()).collect();
    let remains = |at: &str| {
        let below = format!("{at}/");
        let within = || places.range(below.as_str()..).next().is_some_and(|place| place.starts_with(&below));
        let above = || at.match_indices('/').any(|(end, _)| places.contains(&at[..end]));
        places.contains(at) || within() || above()
    };
    found.retain(|found| !found.is_one_sided() || (!places.is_empty() && remains(&found.at)));
}

#[cfg(test)]
mod tests {
    use super::*;
    use ncp_text::WIRE_VERSION;
    use proptest::prelude::*;

    const MEMBERS: &str = concat!(
        r#""kind":"command_frame","seq":7,"t":1.5,"frame_id":"world","mode":"active","ttl_ms":200.0,"#,
        r#""channels":{"a":{"data":[5.0,-0.0],"unit":null},"b":{"data":[],"unit":"m/s"}},"#,
        r#""horizon":[],"horizon_dt_ms":null"#
    );

    fn frame() -> String {
        format!(r#"{{"ncp_version":"{WIRE_VERSION}",{MEMBERS}}}"#)
    }

    fn message(got: &str) -> Vec<String> {
        let mut differences = Differences::default();
        same_message(&frame(), got, &[], &mut differences);
        differences.first.iter().map(ToString::to_string).collect()
    }

    fn encoding(got: &str) -> Vec<String> {
        let mut differences = Differences::default();
        same_encoding(&frame(), got, &mut differences);
        differences.first.iter().map(ToString::to_string).collect()
    }

    fn changed(from: &str, to: &str) -> String {
        let frame = frame();
        assert!(frame.contains(from), "{from}");
        frame.replacen(from, to, 1)
    }

    #[test]
    fn a_message_does_not_answer_for_its_encoder() {
        for got in [
            changed("5.0,", "50e-1,"),
            changed("1.5", "15E-1"),
            changed("200.0", "200"),
            changed("-0.0", "-0"),
            changed(r#""seq":7,"t":1.5,"#, r#""t":1.5,"seq":7,"#),
            changed(r#","horizon_dt_ms":null"#, ""),
            changed(r#","unit":null"#, ""),
            changed(r#","horizon":[]"#, ""),
            changed(r#""frame_id":"world","#, ""),
            changed(r#""ttl_ms":200.0,"#, ""),
            changed(r#""seq":7"#, r#""future":{"x":[1]},"seq":7"#),
            format!(" {} ", frame().replace(':', " : ")),
        ] {
            assert_eq!(message(&got), Vec::<String>::new(), "{got}");
        }
    }

    #[test]
    fn a_message_answers_for_every_value() {
        assert_eq!(message(&changed("\"seq\":7", "\"seq\":8")), ["/seq: expected 7, got 8"]);
        assert_eq!(message(&changed("-0.0", "0.0")), ["/channels/a/data/1: expected -0.0, got 0.0"]);
        assert_eq!(message(&changed("1.5", "1.5000000000000002")), ["/t: expected 1.5, got 1.5000000000000002"]);
        assert_eq!(message(&changed("[5.0,-0.0]", "[5.0]")), ["/channels/a/data: expected 2 items, got 1 items"]);
        assert_eq!(message(&changed("\"active\"", "\"hold\"")), [r#"/mode: expected "active", got "hold""#]);
        assert_eq!(
            message(&changed(r#""unit":null"#, r#""unit":"m""#)),
            [r#"/channels/a/unit: expected null, got "m""#]
        );
        assert_eq!(message(&changed("\"seq\":7", "\"seq\":\"7\"")), [r#"/seq: expected 7, got "7""#]);
    }

    #[test]
    fn a_member_left_out_counts_unless_its_value_is_the_default() {
        assert_eq!(message(&changed("\"seq\":7,", "")), ["/seq: expected 7, got nothing"]);
        // Absent, the mode is hold: rule NCP-WIRE-024.
        assert_eq!(message(&changed(r#""mode":"active","#, "")), [r#"/mode: expected "active", got nothing"#]);
        let without = changed(r#""kind":"command_frame","#, "");
        let found = message(&without);
        assert!(
            found[0].starts_with(r#"/kind: expected "command_frame", got nothing (and the spec refuses the frame: "#),
            "{found:?}"
        );
        assert_eq!(
            message(&changed(r#"{"data":[],"unit":"m/s"}"#, "null")).len(),
            1,
            "a channel that became null is lost"
        );
    }

    #[test]
    fn an_answer_may_be_longer_than_the_frame_that_came() {
        let long = |number: &str| format!("[{}]", vec![number; 200_000].join(","));
        let expected = changed("[5.0,-0.0]", &long("0.0"));
        let differ = |got: &str| {
            let mut differences = Differences::default();
            same_message(&expected, got, &[], &mut differences);
            differences.first.iter().map(ToString::to_string).collect::<Vec<_>>()
        };
        // More than 1 MiB, and without what has its default.
        let got = changed("[5.0,-0.0]", &long("0.0000")).replace(r#","unit":null"#, "");
        assert!(got.len() > 1 << 20);
        assert_eq!(differ(&got), Vec::<String>::new());
        assert_eq!(differ(&got.replace(r#""mode":"active","#, "")), [r#"/mode: expected "active", got nothing"#]);
        assert_eq!(differ(&got.replace(r#""seq":7,"#, "").replacen("0.0000", "1", 1)).len(), 2);
    }

    #[test]
    fn an_expectation_may_leave_out_defaults_too() {
        let short = r#"{"kind":"command_frame","seq":7,"channels":{"a":{}}}"#;
        let whole = |unit: &str| {
            format!(
                r#"{{"ncp_version":"{WIRE_VERSION}","kind":"command_frame","seq":7,"t":0,"frame_id":"world",
                "mode":"hold","ttl_ms":2e2,"channels":{{"a":{{"data":[],"unit":{unit}}}}},"horizon":[],
                "horizon_dt_ms":null}}"#
            )
        };
        let differ = |got: &str| {
            let mut differences = Differences::default();
            same_message(short, got, &[], &mut differences);
            differences.first.iter().map(ToString::to_string).collect::<Vec<_>>()
        };
        assert_eq!(differ(&whole("null")), Vec::<String>::new());
        assert_eq!(differ(&whole("\"m\"")), [r#"/channels/a/unit: expected nothing there, got "m""#]);
    }

    #[test]
    fn a_channel_that_was_added_or_lost_counts() {
        assert_eq!(
            message(&changed(r#","b":{"data":[],"unit":"m/s"}"#, "")),
            [r#"/channels/b: expected {"data":[],"unit":"m/s"}, got nothing"#]
        );
        assert_eq!(
            message(&changed(r#""b":"#, r#""c":{"data":[]},"b":"#)),
            [r#"/channels/c: expected nothing there, got {"data":[]}"#]
        );
    }

    #[test]
    fn what_is_to_be_ignored_is() {
        let mut differences = Differences::default();
        let got = changed("\"seq\":7", "\"seq\":8").replace("m/s", "m");
        same_message(&frame(), &got, &["/seq".to_owned(), "/channels/b".to_owned()], &mut differences);
        assert!(differences.is_empty());
        same_message(&frame(), &got, &["/se".to_owned(), "/channels/b/uni".to_owned()], &mut differences);
        assert_eq!(differences.first.len(), 2);
    }

    #[test]
    fn a_member_that_stands_twice_fails_in_either_relation() {
        let got = changed("\"seq\":7", "\"seq\":7,\"seq\":7");
        for found in [message(&got), encoding(&got)] {
            assert_eq!(found.len(), 1);
            assert!(found[0].contains("the member \"seq\" stands twice in one object"), "{found:?}");
        }
        assert!(message("[]")[0].contains("it is an array"));
        assert!(encoding("{")[0].contains("ends too early"));
    }

    #[test]
    fn an_encoding_may_choose_white_space_and_the_spelling_of_doubles() {
        for got in [changed("5.0,", "5,"), changed("200.0", "2e2"), changed("-0.0", "-0"), frame().replace(',', " ,\n")]
        {
            assert_eq!(encoding(&got), Vec::<String>::new(), "{got}");
        }
    }

    #[test]
    fn an_encoding_answers_for_order_nulls_and_integers() {
        assert_eq!(
            encoding(&changed("\"seq\":7", "\"seq\":7.0")),
            ["/seq: expected 7, got 7.0 (an integer is written without fraction and exponent)"]
        );
        assert_eq!(encoding(&changed("\"seq\":7", "\"seq\":8")), ["/seq: expected 7, got 8"]);
        assert_eq!(encoding(&changed("\"seq\":7", "\"seq\":\"7\"")), [r#"/seq: expected 7, got "7""#]);
        assert_eq!(
            encoding(&changed(r#","horizon_dt_ms":null"#, "")),
            ["/horizon_dt_ms: expected null, got nothing (an unset optional field is written as null)"]
        );
        assert_eq!(
            encoding(&changed(r#","horizon":[]"#, "")),
            ["/horizon: expected [], got nothing (every field is written)"]
        );
        assert_eq!(
            encoding(&changed(r#""seq":7,"t":1.5,"#, r#""t":1.5,"seq":7,"#)),
            [r#"expected "seq", got "t" (as member 3 of the object: the order differs)"#]
        );
        assert_eq!(encoding(&changed("-0.0", "0.0")), ["/channels/a/data/1: expected -0.0, got 0.0"]);
        assert_eq!(
            encoding(&changed("\"seq\":7", "\"x\":null,\"seq\":7")),
            ["/x: expected nothing there, got null (no member is written that the tables do not list)"]
        );
        assert_eq!(encoding(&changed("null}", "0}")), ["/channels/a/unit: expected null, got 0"]);
    }

    #[test]
    fn an_error_frame_may_name_no_session_in_two_ways() {
        let differ = |expected: &str, got: &str| {
            let mut differences = Differences::default();
            same_encoding(expected, got, &mut differences);
            differences.first.len()
        };
        let without = r#"{"kind":"error","error":"x"}"#;
        assert_eq!(differ(without, r#"{"kind":"error","error":"x","session_id":null}"#), 0);
        assert_eq!(differ(without, r#"{"kind":"error","error":"x","session_id":"a"}"#), 1);
        assert_eq!(differ(without, r#"{"kind":"error","error":"x","other":null}"#), 1);
        assert_eq!(differ(without, r#"{"kind":"error","session_id":null}"#), 1);
        assert_eq!(differ(r#"{"kind":"error","error":"x","session_id":"a"}"#, without), 1);
        assert_eq!(differ(r#"{"kind":"closed","a":1}"#, r#"{"kind":"closed","a":1,"session_id":null}"#), 1);
    }

    proptest! {
        #[test]
        fn members_in_any_order_are_one_message_and_another_encoding(
            order in Just((0..10_usize).collect::<Vec<_>>()).prop_shuffle(),
        ) {
            let whole = frame();
            let Json::Object(members) = Json::parse(&whole).unwrap() else { panic!() };
            let shuffled = Json::Object(order.iter().map(|i| members[*i].clone()).collect()).to_string();
            prop_assert!(message(&shuffled).is_empty());
            prop_assert_eq!(encoding(&shuffled).is_empty(), order.is_sorted());
        }

        #[test]
        fn a_double_counts_bit_by_bit_in_both_relations(bits in any::<u64>(), flip in 0_u32..64) {
            let (a, b) = (f64::from_bits(bits), f64::from_bits(bits ^ (1 << flip)));
            prop_assume!(a.is_finite() && b.is_finite());
            let frame = |v: f64| changed("\"t\":1.5", &format!("\"t\":{v:e}"));
            let (mut same, mut other) = (Differences::default(), Differences::default());
            let expected = changed("1.5", &serde_json::to_string(&a).unwrap());
            same_message(&expected, &frame(a), &[], &mut same);
            same_encoding(&expected, &frame(a), &mut same);
            prop_assert!(same.is_empty());
            same_message(&expected, &frame(b), &[], &mut other);
            same_encoding(&expected, &frame(b), &mut other);
            prop_assert_eq!(other.first.len(), 2);
        }
    }
}
