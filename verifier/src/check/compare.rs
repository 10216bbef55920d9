//! Equal as JSON values.

use super::{Difference, Differences, short};
use crate::json::{Json, Members, Number, pointer_token};

/// Compares two JSON values: objects whatever their order, numbers by value and the sign of a zero. The strings
/// `"NaN"`, `"Infinity"`, `"-Infinity"` and `"-0"` stand for those numbers (PROTOCOL.md, section 2).
pub(super) fn values(expected: &Json<'_>, got: &Json<'_>, differences: &mut Differences) {
    compare(expected, got, &mut String::new(), differences);
}

/// The number that a value is or stands for.
fn number(value: &Json<'_>) -> Option<Number> {
    match value {
        Json::Number(spelling) => Some(Number::read(spelling)),
        Json::String(text) => match text.as_ref() {
            "NaN" => Some(Number::Double(f64::NAN)),
            "Infinity" => Some(Number::Double(f64::INFINITY)),
            "-Infinity" => Some(Number::Double(f64::NEG_INFINITY)),
            "-0" => Some(Number::Double(-0.0)),
            _ => None,
        },
        _ => None,
    }
}

fn compare(expected: &Json<'_>, got: &Json<'_>, at: &mut String, differences: &mut Differences) {
    let length = at.len();
    match (expected, got) {
        (Json::Array(expected), Json::Array(got)) => {
            if expected.len() != got.len() {
                differences.push(Difference {
                    at: at.clone(),
                    expected: Some(format!("{} items", expected.len())),
                    got: Some(format!("{} items", got.len())),
                    hint: None,
                });
            }
            for (i, (expected, got)) in expected.iter().zip(got).enumerate() {
                at.push_str(&format!("/{i}"));
                compare(expected, got, at, differences);
                at.truncate(length);
            }
        }
        (Json::Object(expected_members), Json::Object(got_members)) => {
            let (in_expected, in_got) = (Members::new(expected_members), Members::new(got_members));
            for (i, (name, expected)) in expected_members.iter().enumerate() {
                at.push('/');
                at.push_str(&pointer_token(name));
                match in_got.get(name, i) {
                    Some(got) => compare(expected, got, at, differences),
                    None => differences.push(Difference {
                        at: at.clone(),
                        expected: Some(short(expected)),
                        got: None,
                        hint: None,
                    }),
                }
                at.truncate(length);
            }
            for (i, (name, value)) in got_members.iter().enumerate() {
                if in_expected.get(name, i).is_some() {
                    continue;
                }
                differences.push(Difference {
                    at: format!("{at}/{}", pointer_token(name)),
                    expected: None,
                    got: Some(short(value)),
                    hint: None,
                });
            }
        }
        _ => {
            let same = match (number(expected), number(got)) {
                (Some(expected), Some(got)) => expected.same(got),
                _ => expected == got,
            };
            if !same {
                differences.push(Difference {
                    at: at.clone(),
                    expected: Some(short(expected)),
                    got: Some(short(got)),
                    hint: None,
                });
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn differ(expected: &str, got: &str) -> Vec<String> {
        let mut differences = Differences::default();
        values(
            &Json::parse(expected).unwrap(),
            &Json::parse(got).unwrap(),
            &mut differences,
        );
        differences.first.iter().map(ToString::to_string).collect()
    }

    #[test]
    fn order_and_spelling_do_not_count_and_values_do() {
        assert!(differ(r#"{"a":1,"b":[2.0,null]}"#, r#"{"b":[2,null],"a":1e0}"#).is_empty());
        assert_eq!(
            differ(r#"{"a":1,"b":2}"#, r#"{"a":2,"c":2}"#),
            [
                "/a: expected 1, got 2",
                "/b: expected 2, got nothing",
                "/c: expected nothing there, got 2"
            ]
        );
        assert_eq!(
            differ("[1,2]", "[1,3,4]"),
            ["expected 2 items, got 3 items", "/1: expected 2, got 3"]
        );
        assert_eq!(differ("true", "1"), ["expected true, got 1"]);
        assert_eq!(differ("5", "\"5\""), ["expected 5, got \"5\""]);
    }

    #[test]
    fn strings_stand_for_the_numbers_that_json_lacks() {
        assert!(
            differ(
                r#"["NaN","-0","Infinity","-0"]"#,
                r#"["NaN",-0.0,"Infinity","-0"]"#
            )
            .is_empty()
        );
        for (expected, got) in [
            ("\"-0\"", "0"),
            ("0.0", "-0.0"),
            ("\"NaN\"", "\"Infinity\""),
            ("\"Infinity\"", "\"-Infinity\""),
            ("\"NaN\"", "null"),
        ] {
            assert_eq!(differ(expected, got).len(), 1, "{expected} and {got}");
        }
        assert!(differ("\"9223372036854775807\"", "\"9223372036854775807\"").is_empty());
        assert_eq!(
            differ("\"9223372036854775807\"", "9223372036854775807").len(),
            1
        );
    }

    proptest! {
        #[test]
        fn a_double_is_the_same_only_as_one_of_its_own_bits(a in any::<u64>(), flip in 0_u32..64) {
            let (a, b) = (f64::from_bits(a), f64::from_bits(a ^ (1 << flip)));
            prop_assume!(a.is_finite() && b.is_finite());
            let (text_a, text_b) = (serde_json::to_string(&a).unwrap(), serde_json::to_string(&b).unwrap());
            let exponent = format!("{a:e}");
            prop_assert!(differ(&text_a, &exponent).is_empty());
            prop_assert_eq!(differ(&text_a, &text_b).len(), 1);
        }

        #[test]
        fn an_integer_is_the_same_only_as_itself(a in any::<i64>(), b in any::<i64>()) {
            prop_assert!(differ(&a.to_string(), &a.to_string()).is_empty());
            prop_assert_eq!(differ(&a.to_string(), &b.to_string()).is_empty(), a == b);
        }
    }
}
