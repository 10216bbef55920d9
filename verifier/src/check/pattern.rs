//! A result beside the shape that it has to have.

use std::borrow::Cow;

use ncp_spec::ErrorCode;

use super::{Difference, Differences, Manner, SHOWN, short};
use crate::json::{Json, Members, Number, is_integer, pointer_token};
use crate::peer::excerpt;
use crate::suite::Shape;

/// Notes where a result has not the shape; `tolerance` is that of its numbers.
pub(super) fn fits(shape: &Shape, tolerance: f64, got: &Json<'_>, differences: &mut Differences) {
    Walk { tolerance, is_spelled: false, at: String::new(), differences }.visit(shape, Some(got));
}

struct Walk<'d> {
    tolerance: f64,
    /// Whether the order of members and the spelling of integers count.
    is_spelled: bool,
    /// Where, as a JSON pointer. Into JSON that stands in a string it simply goes on.
    at: String,
    differences: &'d mut Differences,
}

impl Walk<'_> {
    /// Compares a shape with what is there, if anything is.
    fn visit(&mut self, shape: &Shape, got: Option<&Json<'_>>) {
        match (shape, got) {
            (Shape::Null, None | Some(Json::Null)) | (Shape::Anything, Some(_)) => {}
            (Shape::SomeText, Some(Json::String(got))) if !got.is_empty() => {}
            (Shape::Bool(expected), Some(Json::Bool(got))) if expected == got => {}
            (Shape::Text(expected), Some(Json::String(got))) if expected == got => {}
            (Shape::Number(expected), Some(value))
                if Number::of(value).is_some_and(|got| expected.is_near(got, self.tolerance))
                    && !(self.is_spelled && expected.is_integer() && is_fraction(value)) => {}
            (Shape::Range(low, high), Some(value)) if is_within(*low, *high, value) => {}
            (Shape::Double(expected), Some(value)) if Number::of(value).is_some_and(|got| expected.is_met_by(got)) => {}
            (Shape::Refused, Some(step)) if is_refusal(step) => {}
            (Shape::Items(expected), Some(Json::Array(got))) => self.items(expected, got),
            (Shape::Beginning(expected), Some(Json::Array(got))) if (1..=expected.len()).contains(&got.len()) => {
                self.items(expected.get(..got.len()).unwrap_or_default(), got);
            }
            (Shape::Members(expected), Some(step @ Json::Object(got))) if !is_an_error_for(expected, step) => {
                self.members(expected, got, false);
            }
            (Shape::Exact(expected), Some(Json::Object(got))) => self.members(expected, got, true),
            (Shape::Any(choices), got) => self.any(shape, choices, got),
            (Shape::Json(inner), Some(Json::String(text))) => self.text(shape, inner, text, false),
            (Shape::Frame(inner), Some(Json::String(text))) => self.text(shape, inner, text, true),
            _ => self.differs(shape, got, None),
        }
    }

    fn items(&mut self, expected: &[Shape], got: &[Json<'_>]) {
        if expected.len() != got.len() {
            let count = |len: usize| Some(format!("{len} items"));
            self.note(count(expected.len()), count(got.len()), None);
        }
        for (i, (expected, got)) in expected.iter().zip(got).enumerate() {
            self.inside(&i.to_string(), |walk| walk.visit(expected, Some(got)));
        }
    }

    /// Compares a shape with what a string holds.
    fn text(&mut self, shape: &Shape, inner: &Shape, text: &str, is_spelled: bool) {
        match Json::parse(text) {
            Ok(value) => {
                let around = std::mem::replace(&mut self.is_spelled, is_spelled);
                self.visit(inner, Some(&value));
                self.is_spelled = around;
            }
            Err(error) => self.differs(shape, Some(&Json::String(text.into())), Some(error.to_string())),
        }
    }

    fn members(&mut self, expected: &[(String, Shape)], got: &[Member<'_>], exact: bool) {
        let there = Members::new(got);
        if self.is_spelled {
            self.order(expected, got);
        }
        for (i, (name, shape)) in expected.iter().enumerate() {
            self.inside(&pointer_token(name), |walk| {
                walk.visit(shape, there.get(name, i));
            });
        }
        for (name, value) in got.iter().filter(|_| exact) {
            if !expected.iter().any(|(known, _)| known == name) {
                self.inside(&pointer_token(name), |walk| {
                    walk.note(None, Some(short(value)), None);
                });
            }
        }
    }

    /// Notes the first member that stands before one which has to come earlier.
    fn order(&mut self, expected: &[(String, Shape)], got: &[Member<'_>]) {
        let place = |name: &str| got.iter().position(|(known, _)| known == name);
        let places: Vec<(usize, &str)> =
            expected.iter().filter_map(|(name, _)| Some((place(name)?, name.as_str()))).collect();
        let wrong = places.iter().zip(places.iter().skip(1)).find(|((one, _), (next, _))| one > next);
        if let Some(((_, one), (_, next))) = wrong {
            let is_first = self.differences.is_empty();
            self.note(Some(format!("`{one}` before `{next}`")), Some(format!("`{next}` before `{one}`")), None);
            if is_first {
                self.differences.manner = Manner::Order;
            }
        }
    }

    fn any(&mut self, shape: &Shape, choices: &[Shape], got: Option<&Json<'_>>) {
        let is_first = self.differences.is_empty();
        let mut nearest: Option<Differences> = None;
        for choice in choices {
            let mut differences = Differences::default();
            let (tolerance, is_spelled, at) = (self.tolerance, self.is_spelled, self.at.clone());
            Walk { tolerance, is_spelled, at, differences: &mut differences }.visit(choice, got);
            if differences.is_empty() {
                return;
            }
            if nearest.as_ref().is_none_or(|nearest| is_nearer(&differences, nearest)) {
                nearest = Some(differences);
            }
        }
        let place = nearest.as_ref().map(|nearest| (nearest.place.clone(), nearest.manner));
        // What is wrong with a value as a whole says nothing new.
        let inner = nearest
            .and_then(|nearest| nearest.first.into_iter().next())
            .filter(|first| first.at != self.at)
            .map(|first| format!("nearest: {first}"));
        self.differs(shape, got, inner);
        if let Some((place, manner)) = place.filter(|_| is_first) {
            self.differences.place = place;
            self.differences.manner = manner;
        }
    }

    fn inside(&mut self, token: &str, visit: impl FnOnce(&mut Self)) {
        let outer = self.at.len();
        self.at.push('/');
        self.at.push_str(token);
        visit(self);
        self.at.truncate(outer);
    }

    fn differs(&mut self, shape: &Shape, got: Option<&Json<'_>>, hint: Option<String>) {
        let expected = match shape {
            Shape::Refused => "a refused step, and no crash".to_owned(),
            Shape::Json(_) | Shape::Frame(_) => "a string of JSON".to_owned(),
            Shape::Range(low, high) => format!("a number from {low} to {high}"),
            Shape::Double(number) => format!("{number}, bit for bit"),
            Shape::SomeText => "a text that is not empty".to_owned(),
            Shape::Anything => "a member".to_owned(),
            Shape::Beginning(items) => format!("the first of {} items, at least one", items.len()),
            Shape::Any(choices) => {
                let choices: Vec<String> = choices.iter().map(ToString::to_string).collect();
                format!("one of {}", choices.join(" | "))
            }
            _ => shape.to_string(),
        };
        if let Some(code) = got.and_then(error_code).filter(|_| self.differences.is_empty()) {
            self.differences.manner = Manner::of_error(code);
        }
        self.note(Some(expected), got.map(short), hint);
    }

    fn note(&mut self, expected: Option<String>, got: Option<String>, hint: Option<String>) {
        self.differences.push(Difference {
            at: self.at.clone(),
            expected: expected.map(|text| excerpt(text.as_bytes(), SHOWN)),
            got,
            hint,
        });
    }
}

/// Whether an answer that differs so from one choice is nearer to it than to another. Of steps one after the other
/// that is the choice with which it goes longer; elsewhere the one from which it differs in fewer places.
fn is_nearer(differences: &Differences, other: &Differences) -> bool {
    let mut tokens = differences.place.split('/').zip(other.place.split('/'));
    let parting = tokens.find(|(here, there)| here != there);
    match parting.map(|(here, there)| (here.parse::<usize>(), there.parse::<usize>())) {
        Some((Ok(here), Ok(there))) => here > there,
        _ => differences.count() < other.count(),
    }
}

type Member<'v> = (Cow<'v, str>, Json<'v>);

fn is_within(low: Number, high: Number, value: &Json<'_>) -> bool {
    let ends = low.as_double()..=high.as_double();
    Number::of(value).is_some_and(|got| ends.contains(&got.as_double()))
}

/// Whether a number is spelled otherwise than an integer is.
fn is_fraction(value: &Json<'_>) -> bool {
    matches!(value, Json::Number(spelling) if !is_integer(spelling))
}

/// Whether a step was refused. A crash is no refusal.
fn is_refusal(step: &Json<'_>) -> bool {
    error_code(step).is_some_and(|code| code != ErrorCode::Internal.as_str())
}

/// Whether a step ended in an error where members are expected and none of them is that. A hold is `null`, and an
/// absent member counts as such; an error says nothing of what the plant does.
fn is_an_error_for(expected: &[(String, Shape)], step: &Json<'_>) -> bool {
    !expected.is_empty() && expected.iter().all(|(name, _)| name != "error") && error_code(step).is_some()
}

/// The code of a step that ended in an error.
fn error_code<'a>(step: &'a Json<'_>) -> Option<&'a str> {
    step.get("error")?.get("code")?.as_str()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn differ_by(tolerance: f64, pattern: &str, got: &str) -> Vec<String> {
        let (shape, got) = (Shape::parse(pattern).unwrap(), Json::parse(got).unwrap());
        let mut differences = Differences::default();
        fits(&shape, tolerance, &got, &mut differences);
        differences.first.iter().map(ToString::to_string).collect()
    }

    fn differ(pattern: &str, got: &str) -> Vec<String> {
        differ_by(0.0, pattern, got)
    }

    #[test]
    fn members_that_a_pattern_lacks_are_free_and_null_is_absent() {
        assert!(differ(r#"{"a":1,"b":null,"c":null}"#, r#"{"x":[],"b":null,"a":1}"#).is_empty());
        assert_eq!(
            differ(r#"{"steps":[{"hold":true},{"a/b":null}]}"#, r#"{"steps":[{"hold":false},{"a/b":0}]}"#),
            ["/steps/0/hold: expected true, got false", "/steps/1/a~1b: expected null, got 0"]
        );
        assert_eq!(differ(r#"{"a":{"b":1}}"#, r#"{"c":1}"#), [r#"/a: expected {"b":1}, got nothing"#]);
        assert_eq!(differ("[1,2]", "[3]"), ["expected 2 items, got 1 items", "/0: expected 1, got 3"]);
        assert_eq!(differ("{}", "[]"), ["expected {}, got []"]);
        assert_eq!(differ("\"a\"", "\"b\""), ["expected \"a\", got \"b\""]);
        assert_eq!(differ("1", "true").len(), 1);
    }

    #[test]
    fn the_place_of_the_first_difference_leads_through_choices_into_the_nearest() {
        let found = |pattern: &str, got: &str| {
            let mut differences = Differences::default();
            let (shape, got) = (Shape::parse(pattern).unwrap(), Json::parse(got).unwrap());
            fits(&shape, 0.0, &got, &mut differences);
            (differences.place, differences.manner)
        };
        let choices = r#"{"$any":[{"steps":[{"hold":true},{"hold":true}]},{"steps":[{"hold":false},{"hold":false}]}]}"#;
        assert_eq!(
            found(choices, r#"{"steps":[{"hold":true},{"hold":false}]}"#),
            ("/steps/1/hold".into(), Manner::Value)
        );
        // With the second choice it goes longer, though more of it differs there.
        let choices = r#"{"$any":[[1,2,3,4,5],[2,2,9,9,9]]}"#;
        assert_eq!(found(choices, "[2,2,3,4,5]").0, "/2");
        assert_eq!(found(r#"{"$any":[{"a":1,"b":1},{"a":2,"b":2}]}"#, r#"{"a":3,"b":2}"#).0, "/a");
        let step = |code: &str| format!(r#"{{"steps":[{{"hold":true}},{{"error":{{"code":"{code}"}}}}]}}"#);
        let steps = r#"{"steps":[{"hold":true},5]}"#;
        assert_eq!(found(steps, &step("internal")), ("/steps/1".into(), Manner::Crash));
        assert_eq!(found(steps, &step("value")), ("/steps/1".into(), Manner::Refusal));
        let steps = r#"{"steps":[{"hold":false},5]}"#;
        assert_eq!(found(steps, &step("value")), ("/steps/0/hold".into(), Manner::Value));
    }

    #[test]
    fn an_error_is_no_null_unless_anything_is_right() {
        for code in ["internal", "value"] {
            let step = format!(r#"{{"error":{{"code":"{code}","message":""}}}}"#);
            assert_eq!(differ(r#"{"channels":null}"#, &step).len(), 1, "{step}");
            assert!(differ("{}", &step).is_empty());
            assert!(differ(r#"{"error":{"code":{"$anything":true}}}"#, &step).is_empty());
        }
        assert!(differ(r#"{"channels":null}"#, "{}").is_empty());
        assert!(differ(r#"{"kind":"error"}"#, r#"{"kind":"error","error":"why"}"#).is_empty());
    }

    #[test]
    fn numbers_are_compared_by_value_within_the_tolerance() {
        for (pattern, got) in [
            ("0", "-0.0"),
            ("\"-0\"", "0"),
            ("5", "5.0"),
            ("1e2", "100"),
            ("\"NaN\"", "\"NaN\""),
            ("\"Infinity\"", "\"Infinity\""),
            ("9007199254740993", "9007199254740993"),
        ] {
            assert!(differ(pattern, got).is_empty(), "{pattern} and {got}");
        }
        for (pattern, got) in [
            ("0.1", "0.10000000000000002"),
            ("9007199254740993", "9007199254740992"),
            ("\"NaN\"", "0"),
            ("0", "\"NaN\""),
            ("1", "\"1\""),
        ] {
            assert_eq!(differ(pattern, got).len(), 1, "{pattern} and {got}");
        }
        assert!(differ_by(0.5, "1", "1.5").is_empty() && !differ_by(0.5, "1", "2.5").is_empty());
        assert!(differ_by(1e-9, "0", "1e-9").is_empty() && !differ_by(1e-9, "0", "2e-9").is_empty());
        assert!(differ_by(1e-9, "1e9", "1000000001").is_empty());
        // A count is exact, also where a double of its size may be off by many.
        assert_eq!(differ_by(1e-9, "9007199254740991", "9007199254740990").len(), 1);
        for (pattern, got) in
            [("\"Infinity\"", "1e308"), ("1", "\"Infinity\""), ("\"Infinity\"", "\"-Infinity\""), ("1", "\"NaN\"")]
        {
            assert_eq!(differ_by(0.5, pattern, got).len(), 1, "{pattern} and {got}");
        }
    }

    #[test]
    fn special_objects_mean_what_they_say() {
        let refused = r#"{"error":{"code":"type","message":"m"}}"#;
        for (pattern, got) in [
            (r#"{"$any":[1,"a"]}"#, "\"a\""),
            (r#"{"a":{"$any":[1,null]}}"#, "{}"),
            (r#"{"$beginning":[1,2]}"#, "[1]"),
            (r#"{"$beginning":[1,2]}"#, "[1,2]"),
            (r#"{"$error":true}"#, refused),
            (r#"{"$exact":{"a":1,"b":null}}"#, r#"{"a":1}"#),
            (r#"{"$json":{"ok":true}}"#, r#""{\"ok\": true, \"x\": 1}""#),
            (r#"{"$frame":{"b":1,"a":{"c":2.0}}}"#, r#""{\"b\":1,\"x\":0,\"a\":{\"c\":2}}""#),
            (r#"{"$json":{"b":1,"a":2}}"#, r#""{\"a\":2.0,\"b\":1}""#),
            (r#"{"$range":[-1,1]}"#, "1.0"),
            (r#"{"$double":0.5}"#, "5e-1"),
            (r#"{"$double":"-0"}"#, "-0.0"),
            (r#"{"$double":"-0"}"#, "\"-0\""),
            (r#"{"$double":0.0}"#, "0"),
            (r#"{"$range":[0,"Infinity"]}"#, "\"Infinity\""),
            (r#"{"a":{"$text":true}}"#, r#"{"a":"no"}"#),
            (r#"{"a":{"$anything":true}}"#, r#"{"a":null}"#),
        ] {
            assert!(differ(pattern, got).is_empty(), "{pattern} and {got}");
        }
        let internal = r#"{"error":{"code":"internal","message":"m"}}"#;
        for (pattern, got, difference) in [
            (r#"{"$any":[1,2]}"#, "3", "expected one of 1 | 2, got 3"),
            (r#"{"$beginning":[1,2]}"#, "[]", "expected the first of 2 items, at least one, got []"),
            (r#"{"$beginning":[1,2]}"#, "[1,2,2]", "expected the first of 2 items, at least one, got [1,2,2]"),
            (r#"{"$beginning":[1,2]}"#, "[2]", "/0: expected 1, got 2"),
            (
                r#"{"$any":[{"a":1},{"a":[]}]}"#,
                r#"{"a":2}"#,
                r#"expected one of {"a":1} | {"a":[]}, got {"a":2} (nearest: /a: expected 1, got 2)"#,
            ),
            (
                r#"{"$error":true}"#,
                internal,
                r#"expected a refused step, and no crash, got {"error":{"code":"internal","message":"m"}}"#,
            ),
            (r#"{"$error":true}"#, "{}", "expected a refused step, and no crash, got {}"),
            (r#"{"$error":true}"#, r#"{"error":true}"#, r#"expected a refused step, and no crash, got {"error":true}"#),
            (r#"{"$exact":{"a":1}}"#, r#"{"a":1,"b":null}"#, "/b: expected nothing there, got null"),
            (r#"{"r":[{"$json":{"ok":true}}]}"#, r#"{"r":["{\"ok\":false}"]}"#, "/r/0/ok: expected true, got false"),
            (
                r#"{"$json":{}}"#,
                r#""{,}""#,
                r#"expected a string of JSON, got "{,}" (expected a member name at byte 1)"#,
            ),
            (r#"{"$json":{}}"#, "{}", "expected a string of JSON, got {}"),
            (r#"{"$frame":{"b":1,"a":2}}"#, r#""{\"a\":2,\"b\":1}""#, "expected `b` before `a`, got `a` before `b`"),
            (r#"{"$frame":{"a":[1,2]}}"#, r#""{\"a\":[1,2.0]}""#, "/a/1: expected 2, got 2.0"),
            (r#"{"$range":[-1,1]}"#, "1.5", "expected a number from -1 to 1, got 1.5"),
            (r#"{"$range":[-1,1]}"#, "\"NaN\"", "expected a number from -1 to 1, got \"NaN\""),
            (r#"{"$double":"-0"}"#, "0.0", "expected -0.0, bit for bit, got 0.0"),
            (r#"{"$double":0.0}"#, "-0.0", "expected 0.0, bit for bit, got -0.0"),
            (r#"{"a":{"$text":true}}"#, r#"{"a":""}"#, r#"/a: expected a text that is not empty, got """#),
            (r#"{"a":{"$text":true}}"#, r#"{"a":null}"#, "/a: expected a text that is not empty, got null"),
            (r#"{"a":{"$text":true}}"#, "{}", "/a: expected a text that is not empty, got nothing"),
            (r#"{"a":{"$anything":true}}"#, "{}", "/a: expected a member, got nothing"),
        ] {
            assert_eq!(differ(pattern, got), [difference], "{pattern} and {got}");
        }
    }

    /// JSON as an answer may hold it.
    fn json() -> impl Strategy<Value = serde_json::Value> {
        use serde_json::{Map, Value};
        let leaf = prop_oneof![
            any::<bool>().prop_map(Value::from),
            any::<i64>().prop_map(Value::from),
            any::<f64>().prop_map(Value::from),
            "[a-zN]{0,4}".prop_map(Value::from),
        ];
        leaf.prop_recursive(4, 30, 4, |inner| {
            prop_oneof![
                prop::collection::vec(inner.clone(), 0..4).prop_map(Value::from),
                prop::collection::btree_map("[a-z/~]{0,3}", inner, 0..4)
                    .prop_map(|members| Value::Object(members.into_iter().collect::<Map<_, _>>())),
            ]
        })
    }

    /// The JSON pointers of all leaves.
    fn leaves(value: &serde_json::Value, at: &str, found: &mut Vec<String>) {
        match value {
            serde_json::Value::Array(items) => {
                for (i, item) in items.iter().enumerate() {
                    leaves(item, &format!("{at}/{i}"), found);
                }
            }
            serde_json::Value::Object(members) => {
                for (name, member) in members {
                    leaves(member, &format!("{at}/{}", pointer_token(name)), found);
                }
            }
            _ => found.push(at.to_owned()),
        }
    }

    proptest! {
        #[test]
        fn a_value_matches_itself_and_a_changed_leaf_is_found_where_it_is(
            value in json(),
            which: prop::sample::Index,
        ) {
            let text = value.to_string();
            prop_assert!(differ(&text, &text).is_empty());
            let mut found = Vec::new();
            leaves(&value, "", &mut found);
            prop_assume!(!found.is_empty());
            let at = which.get(&found);
            let mut changed = value.clone();
            *changed.pointer_mut(at).unwrap() = "another".into();
            let differences = differ(&text, &changed.to_string());
            prop_assert_eq!(differences.len(), 1);
            let place = if at.is_empty() { "expected".to_owned() } else { format!("{at}: ") };
            prop_assert!(differences[0].starts_with(&place), "{}", differences[0]);
        }
    }
}
