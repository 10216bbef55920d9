//! Two JSON values side by side, under one of three relations.

use super::{Difference, Differences, Manner, SHOWN, excerpt, short};
use crate::json::{Json, Members, Number, is_integer, pointer_token};

/// When two values are the same.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Relation {
    /// As JSON values: objects whatever their order, numbers by value and the sign of a zero. The strings `"NaN"`,
    /// `"Infinity"`, `"-Infinity"` and `"-0"` stand for those numbers (PROTOCOL.md, section 2).
    Values,
    /// As messages: as values, and `null` is as good as absent.
    Message,
    /// As encodings: the same members in the same order, and integers spelled as integers.
    Encoding,
}

/// A difference that was found, in terms of the values themselves.
#[derive(Debug)]
pub(super) struct Found<'v> {
    /// Where, as a JSON pointer.
    pub(super) at: String,
    what: What<'v>,
}

#[derive(Debug)]
enum What<'v> {
    Values { expected: &'v Json<'v>, got: &'v Json<'v>, hint: Option<&'static str> },
    Missing { expected: &'v Json<'v>, hint: Option<&'static str> },
    Added { got: &'v Json<'v>, hint: Option<&'static str> },
    Items { expected: usize, got: usize },
    Order { place: usize, expected: &'v str, got: &'v str },
}

/// All that differs.
pub(super) fn compare<'v>(relation: Relation, expected: &'v Json<'v>, got: &'v Json<'v>) -> Vec<Found<'v>> {
    let mut walk = Walk { relation, path: Vec::new(), found: Vec::new() };
    walk.visit(expected, got);
    walk.found
}

impl Found<'_> {
    /// Whether a member stands on one side only.
    pub(super) fn is_one_sided(&self) -> bool {
        matches!(self.what, What::Missing { .. } | What::Added { .. })
    }

    /// Puts it into words.
    pub(super) fn note(&self, differences: &mut Differences) {
        if differences.is_empty() && matches!(self.what, What::Order { .. }) {
            differences.manner = Manner::Order;
        }
        let items = |count: usize| Some(format!("{count} items"));
        let (expected, got, hint) = match &self.what {
            What::Values { expected: Json::String(expected), got: Json::String(got), .. }
                if part_late(expected, got) =>
            {
                let at = shared(expected, got);
                let hint = format!("the texts part at character {} of {}", at + 1, expected.chars().count());
                (Some(from(expected, at)), Some(from(got, at)), Some(hint))
            }
            What::Values { expected, got, hint } => (Some(short(expected)), Some(short(got)), hint.map(str::to_owned)),
            What::Missing { expected, hint } => (Some(short(expected)), None, hint.map(str::to_owned)),
            What::Added { got, hint } => (None, Some(short(got)), hint.map(str::to_owned)),
            What::Items { expected, got } => (items(*expected), items(*got), None),
            What::Order { place, expected, got } => {
                let hint = format!("as member {} of the object: the order differs", place + 1);
                (Some(format!("{expected:?}")), Some(format!("{got:?}")), Some(hint))
            }
        };
        differences.push(Difference { at: self.at.clone(), expected, got, hint });
    }
}

/// A step on the way to a value.
enum Step<'v> {
    Member(&'v str),
    Item(usize),
}

struct Walk<'v> {
    relation: Relation,
    path: Vec<Step<'v>>,
    found: Vec<Found<'v>>,
}

impl<'v> Walk<'v> {
    fn visit(&mut self, expected: &'v Json<'v>, got: &'v Json<'v>) {
        match (expected, got) {
            (Json::Object(expected), Json::Object(got)) => self.objects(expected, got),
            (Json::Array(expected), Json::Array(got)) => {
                if expected.len() != got.len() {
                    self.note(What::Items { expected: expected.len(), got: got.len() });
                }
                for (i, (expected, got)) in expected.iter().zip(got).enumerate() {
                    self.path.push(Step::Item(i));
                    self.visit(expected, got);
                    self.path.pop();
                }
            }
            _ => {
                if let Err(hint) = self.leaves(expected, got) {
                    self.note(What::Values { expected, got, hint });
                }
            }
        }
    }

    fn objects(&mut self, expected: &'v [Member<'v>], got: &'v [Member<'v>]) {
        let (in_expected, in_got) = (Members::new(expected), Members::new(got));
        let mut complete = expected.len() == got.len();
        let lenient = self.relation == Relation::Message;
        for (i, (name, value)) in expected.iter().enumerate() {
            self.path.push(Step::Member(name));
            match in_got.get(name, i) {
                Some(got) if !(lenient && got.is_null()) || value.is_null() => {
                    self.visit(value, got);
                }
                _ if lenient && value.is_null() => {}
                _ => {
                    complete = false;
                    self.note(What::Missing { expected: value, hint: self.why_written(value) });
                }
            }
            self.path.pop();
        }
        for (i, (name, value)) in got.iter().enumerate() {
            if in_expected.get(name, i).is_none() && !(lenient && value.is_null()) {
                complete = false;
                self.path.push(Step::Member(name));
                // [NCP-WIRE-081]
                let is_encoding = self.relation == Relation::Encoding;
                let hint = is_encoding.then_some("no member is written that the tables do not list");
                self.note(What::Added { got: value, hint });
                self.path.pop();
            }
        }
        if self.relation == Relation::Encoding && complete {
            // [NCP-WIRE-080] [NCP-WIRE-083]
            let names = expected.iter().zip(got).map(|((expected, _), (got, _))| (expected.as_ref(), got.as_ref()));
            if let Some((place, (expected, got))) = names.enumerate().find(|(_, (expected, got))| expected != got) {
                self.note(What::Order { place, expected, got });
            }
        }
    }

    /// Compares values that are not both objects or both arrays.
    fn leaves(&self, expected: &Json<'_>, got: &Json<'_>) -> Result<(), Option<&'static str>> {
        let number = match self.relation {
            Relation::Values => Number::of,
            Relation::Message | Relation::Encoding => number,
        };
        let same = match (number(expected), number(got)) {
            (Some(expected), Some(got)) => expected.is_met_by(got),
            _ => expected == got,
        };
        if !same {
            return Err(None);
        }
        // An expectation spells its integers, and only those, without fraction and exponent.
        match (self.relation, expected, got) {
            (Relation::Encoding, Json::Number(expected), Json::Number(got))
                if is_integer(expected) && expected != "-0" && expected != got =>
            {
                Err(Some("an integer is written without fraction and exponent")) // [NCP-WIRE-085]
            }
            _ => Ok(()),
        }
    }

    /// Why a member should have been written.
    fn why_written(&self, value: &Json<'_>) -> Option<&'static str> {
        match (self.relation, value) {
            (Relation::Encoding, Json::Null) => Some("an unset optional field is written as null"), // [NCP-WIRE-082]
            (Relation::Encoding, _) => Some("every field is written"),                              // [NCP-WIRE-081]
            _ => None,
        }
    }

    fn note(&mut self, what: What<'v>) {
        let mut at = String::new();
        for step in &self.path {
            at.push('/');
            match step {
                Step::Member(name) => at.push_str(&pointer_token(name)),
                Step::Item(index) => at.push_str(&index.to_string()),
            }
        }
        self.found.push(Found { at, what });
    }
}

/// How many characters that two texts share stand before the first in which they differ.
const BEFORE: usize = 8;
/// How many stand from that one on.
const AFTER: usize = 40;

/// Whether two texts first differ where neither would be shown any more.
fn part_late(expected: &str, got: &str) -> bool {
    shared(expected, got) >= SHOWN - BEFORE
}

/// How many characters two texts begin with in common.
fn shared(expected: &str, got: &str) -> usize {
    expected.chars().zip(got.chars()).take_while(|(expected, got)| expected == got).count()
}

/// A text from shortly before a character on, and whether more follows.
fn from(text: &str, at: usize) -> String {
    let mut rest = text.chars().skip(at - BEFORE.min(at));
    let window: String = rest.by_ref().take(BEFORE + AFTER).collect();
    let more = if rest.next().is_some() { "…" } else { "" };
    format!("\"…{}{more}\"", excerpt(window.as_bytes(), BEFORE + AFTER))
}

type Member<'v> = (std::borrow::Cow<'v, str>, Json<'v>);

fn number(value: &Json<'_>) -> Option<Number> {
    match value {
        Json::Number(spelling) => Some(Number::read(spelling)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn differ(expected: &str, got: &str) -> Vec<String> {
        let (expected, got) = (Json::parse(expected).unwrap(), Json::parse(got).unwrap());
        let mut differences = Differences::default();
        compare(Relation::Values, &expected, &got).iter().for_each(|found| found.note(&mut differences));
        differences.first.iter().map(ToString::to_string).collect()
    }

    #[test]
    fn order_and_spelling_do_not_count_and_values_do() {
        assert!(differ(r#"{"a":1,"b":[2.0,null]}"#, r#"{"b":[2,null],"a":1e0}"#).is_empty());
        assert_eq!(
            differ(r#"{"a":1,"b":2}"#, r#"{"a":2,"c":2}"#),
            ["/a: expected 1, got 2", "/b: expected 2, got nothing", "/c: expected nothing there, got 2"]
        );
        assert_eq!(differ("[1,2]", "[1,3,4]"), ["expected 2 items, got 3 items", "/1: expected 2, got 3"]);
        assert_eq!(differ("true", "1"), ["expected true, got 1"]);
        assert_eq!(differ("5", "\"5\""), ["expected 5, got \"5\""]);
    }

    #[test]
    fn long_texts_are_shown_from_where_they_part() {
        let long = "x".repeat(65_535);
        let (expected, got) = (format!("{{\"note\":\"{long}a\"}}"), format!("{{\"note\":\"{long}bc\"}}"));
        assert_eq!(
            differ(&expected, &got),
            ["/note: expected \"…xxxxxxxxa\", got \"…xxxxxxxxbc\" (the texts part at character 65536 of 65536)"]
        );
        let cut_short = format!("{{\"note\":\"{}\"}}", &long[..200]);
        assert!(differ(&expected, &cut_short)[0].contains("got \"…xxxxxxxx\" (the texts part at character 201 of"));
        assert_eq!(differ("\"short\"", "\"shorn\""), ["expected \"short\", got \"shorn\""]);
    }

    #[test]
    fn strings_stand_for_the_numbers_that_json_lacks() {
        assert!(differ(r#"["NaN","-0","Infinity","-0"]"#, r#"["NaN",-0.0,"Infinity","-0"]"#).is_empty());
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
        assert_eq!(differ("\"9223372036854775807\"", "9223372036854775807").len(), 1);
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
