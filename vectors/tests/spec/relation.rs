//! Whether an answer is the expected one.

use serde_json::{Value, json};

use super::answer::{Answer, columns_of, decode};

/// What is wrong with the answer, if anything.
pub(crate) fn judge(expect: &Value, answer: Answer) -> Result<(), String> {
    if expect.get("reject").is_some() {
        return match answer {
            Err(_) => Ok(()),
            Ok(result) => Err(format!("should be rejected, but is {}", short(&result))),
        };
    }
    if expect["or_reject"] == true && answer.is_err() {
        return Ok(());
    }
    let result = answer.map_err(|error| format!("should be accepted, but: {error}"))?;
    let Some(relation) = expect["relation"].as_str() else {
        return Ok(());
    };
    let (expected, got) = match relation {
        "json" => (expect["value"].clone(), result),
        "bytes" => (expect["base64"].clone(), result["block"].clone()),
        "columns" => (expect["columns"].clone(), columns_of(result["block"].as_str().unwrap())?),
        "message" => return message(expect, result["text"].as_str().unwrap()),
        "pattern" => return pattern(&expect["value"], &result, ""),
        "encoding" => return encoding(&parsed(&expect["text"]), &parsed(&result["text"]), ""),
        other => panic!("{other} is no relation"),
    };
    same(&expected, &got, "", true)
}

/// What the patterns of the wire areas need: objects whose other members are free, `$any` and `$json`.
fn pattern(expected: &Value, got: &Value, at: &str) -> Result<(), String> {
    let Value::Object(members) = expected else {
        return same(expected, got, at, true);
    };
    if let Some(any) = members.get("$any").and_then(Value::as_array) {
        let fits = |one: &Value| pattern(one, got, at).is_ok();
        let nothing = || format!("{at}: {} is none of {}", short(got), short(expected));
        return any.iter().any(fits).then_some(()).ok_or_else(nothing);
    }
    if let Some(inner) = members.get("$json") {
        return pattern(inner, &parsed(got), at);
    }
    members.iter().try_for_each(|(name, value)| pattern(value, &got[name], &format!("{at}/{name}")))
}

fn parsed(text: &Value) -> Value {
    serde_json::from_str(text.as_str().expect("a text")).expect("a frame is JSON")
}

/// The same members with the same values, apart from what is ignored. The generator writes every
/// field out; only the frames of thousands of entries leave out what is a default.
fn message(expect: &Value, got: &str) -> Result<(), String> {
    let mut expected = parsed(&expect["text"]);
    let mut got = parsed(&Value::from(got));
    if same(&expected, &got, "", false).is_err() && expect.get("ignore").is_none() {
        let frame = json!({ "kind": expected["kind"], "text": expect["text"] });
        let read = decode(&frame).map_err(|error| format!("what is expected is rejected: {error}"))?;
        let normal = parsed(&read["text"]);
        if is_abbreviated(&expected, &normal) {
            expected = normal;
        }
    }
    for pointer in expect["ignore"].as_array().into_iter().flatten() {
        for frame in [&mut expected, &mut got] {
            if let Some(value) = frame.pointer_mut(pointer.as_str().unwrap()) {
                *value = Value::Null;
            }
        }
    }
    same(&expected, &got, "", false)
}

/// Whether a frame says less than another, and nothing else.
fn is_abbreviated(frame: &Value, whole: &Value) -> bool {
    match (frame, whole) {
        (Value::Object(some), Value::Object(all)) => {
            some.iter().all(|(name, value)| all.get(name).is_some_and(|other| is_abbreviated(value, other)))
        }
        (Value::Array(some), Value::Array(all)) => {
            some.len() == all.len() && some.iter().zip(all).all(|(a, b)| is_abbreviated(a, b))
        }
        (a, b) => same(a, b, "", false).is_ok(),
    }
}

/// Equal values: doubles by their bits; if not exact, null and nothing are the same.
fn same(expected: &Value, got: &Value, at: &str, exact: bool) -> Result<(), String> {
    match (expected, got) {
        (Value::Object(a), Value::Object(b)) => {
            let names = a.keys().chain(b.keys().filter(|name| !a.contains_key(*name)));
            for name in names {
                let is_there = a.contains_key(name) && b.contains_key(name);
                if exact && !is_there {
                    return Err(format!("{at}/{name} is there on one side only"));
                }
                same(&expected[name], &got[name], &format!("{at}/{name}"), exact)?;
            }
            Ok(())
        }
        (Value::Array(a), Value::Array(b)) if a.len() == b.len() => {
            let mut pairs = a.iter().zip(b).enumerate();
            pairs.try_for_each(|(nth, (a, b))| same(a, b, &format!("{at}/{nth}"), exact))
        }
        (Value::Number(a), Value::Number(b)) => {
            let bits = |number: &serde_json::Number| number.as_f64().map(f64::to_bits);
            let equal = match (a.as_i64(), b.as_i64()) {
                (Some(a), Some(b)) => a == b,
                _ => bits(a) == bits(b),
            };
            equal.then_some(()).ok_or(format!("{at}: expected {a}, got {b}"))
        }
        (a, b) if a == b => Ok(()),
        (a, b) => Err(format!("{at}: expected {}, got {}", short(a), short(b))),
    }
}

/// Equal members in equal order, integers spelled as such.
fn encoding(expected: &Value, got: &Value, at: &str) -> Result<(), String> {
    match (expected, got) {
        (Value::Object(a), Value::Object(b)) => {
            let (names, others): (Vec<_>, Vec<_>) = (a.keys().collect(), b.keys().collect());
            if names != others {
                return Err(format!("{at}: expected the members {names:?}, got {others:?}"));
            }
            names.into_iter().try_for_each(|name| encoding(&a[name], &b[name], &format!("{at}/{name}")))
        }
        (Value::Array(a), Value::Array(b)) if a.len() == b.len() => {
            a.iter().zip(b).try_for_each(|(a, b)| encoding(a, b, at))
        }
        (Value::Number(a), Value::Number(b)) if a.is_i64() && !b.is_i64() => {
            Err(format!("{at}: expected the integer {a}, got {b}"))
        }
        (a, b) => same(a, b, at, true),
    }
}

fn short(value: &Value) -> String {
    value.to_string().chars().take(200).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_negative_zero_and_a_zero_differ() {
        let zero = serde_json::from_str("0.0").unwrap();
        let negative: Value = serde_json::from_str("-0.0").unwrap();
        assert!(same(&negative, &zero, "", false).is_err());
    }

    #[test]
    fn null_and_nothing_are_the_same_message_and_another_encoding() {
        let (null, nothing) = (json!({ "a": null }), json!({}));
        assert!(same(&null, &nothing, "", false).is_ok());
        assert!(encoding(&null, &nothing, "").is_err());
    }

    #[test]
    fn the_order_of_members_counts_in_an_encoding_alone() {
        let (a, b) = (json!({ "a": 1, "b": 2 }), json!({ "b": 2, "a": 1 }));
        assert!(same(&a, &b, "", true).is_ok());
        assert!(encoding(&a, &b, "").is_err());
    }

    #[test]
    fn a_rejection_that_is_none_is_told() {
        assert!(judge(&json!({ "reject": "type" }), Ok(json!({}))).is_err());
        assert!(judge(&json!({ "accept": true }), Err("no".to_owned())).is_err());
    }
}
