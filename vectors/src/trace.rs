//! What the cases of the behaviour share: numbers as arguments, and patterns as expectations.

use crate::case::Case;
use crate::json::{Json, object};

/// How far a computed number may be off, relatively.
pub(crate) const TOLERANCE: &str = "1e-9";

/// A double: a number, or one of the four strings for those that JSON lacks or loses.
pub(crate) fn num(value: f64) -> Json {
    if value.is_nan() {
        Json::string("NaN")
    } else if value.is_infinite() {
        Json::string(if value > 0.0 { "Infinity" } else { "-Infinity" })
    } else if value == 0.0 && value.is_sign_negative() {
        Json::string("-0")
    } else {
        Json::literal(format!("{value:?}"))
    }
}

/// Doubles.
pub(crate) fn nums(values: &[f64]) -> Json {
    values.iter().copied().map(num).collect()
}

/// An integer.
pub(crate) fn int(value: i64) -> Json {
    Json::literal(value.to_string())
}

/// A double by its name, for ids and titles.
pub(crate) fn name_of(value: f64) -> String {
    if value.is_nan() {
        "nan".to_owned()
    } else if value.is_infinite() {
        if value > 0.0 { "infinity" } else { "minus-infinity" }.to_owned()
    } else if value == 0.0 && value.is_sign_negative() {
        "minus-zero".to_owned()
    } else {
        format!("{value:?}").replace('-', "minus-").replace("eminus-", "e-")
    }
}

/// One of these patterns; the pattern itself when there is one.
pub(crate) fn any(mut patterns: Vec<Json>) -> Json {
    if patterns.len() == 1 {
        return patterns.remove(0);
    }
    object! { "$any" => Json::Array(patterns) }
}

/// A step that is refused.
pub(crate) fn refused() -> Json {
    object! { "$error" => true }
}

/// Exactly these members.
pub(crate) fn exactly(members: Json) -> Json {
    object! { "$exact" => members }
}

/// The first of these items, one at least.
pub(crate) fn beginning(items: Json) -> Json {
    object! { "$beginning" => items }
}

/// A number within.
pub(crate) fn within(low: f64, high: f64) -> Json {
    object! { "$range" => nums(&[low, high]) }
}

/// A text that is JSON of this pattern.
pub(crate) fn text_of(pattern: Json) -> Json {
    object! { "$json" => pattern }
}

/// A text that is JSON of this pattern as an encoder writes it: in this order, with integers spelled as such.
pub(crate) fn frame_of(pattern: Json) -> Json {
    object! { "$frame" => pattern }
}

/// A text that is not empty.
pub(crate) fn some_text() -> Json {
    object! { "$text" => true }
}

/// Whatever it is.
pub(crate) fn anything() -> Json {
    object! { "$anything" => true }
}

/// The entry of a step that has no result, whether it was refused or not.
pub(crate) fn no_result() -> Json {
    Json::object()
}

/// The results of a trace.
pub(crate) fn steps(entries: Vec<Json>) -> Json {
    object! { "steps" => Json::Array(entries) }
}

impl Case {
    /// A result of this pattern, whose numbers may be off by rounding.
    pub(crate) fn shows(mut self, pattern: Json) -> Self {
        self.expect = object! {
            "relation" => "pattern", "value" => pattern, "tolerance" => Json::literal(TOLERANCE),
        };
        self
    }

    /// A result of this pattern, in which every number is exact.
    pub(crate) fn shows_exactly(mut self, pattern: Json) -> Self {
        self.expect = object! { "relation" => "pattern", "value" => pattern };
        self
    }

    /// The same result, in which each double of a channel's `data` is the one that is expected, bit for bit: the sign
    /// of a zero as well.
    pub(crate) fn with_signs(mut self) -> Self {
        self.expect = by_bits(self.expect, false);
        self
    }

    /// A result of this pattern, or a refusal of the whole call.
    pub(crate) fn shows_or_refuses(self, pattern: Json) -> Self {
        self.shows(pattern).or_rejects()
    }
}

/// A pattern in which the items of each `data` are doubles by their bits.
fn by_bits(pattern: Json, is_data: bool) -> Json {
    match pattern {
        Json::Array(items) if is_data => items.into_iter().map(|item| object! { "$double" => item }).collect(),
        Json::Array(items) => items.into_iter().map(|item| by_bits(item, false)).collect(),
        Json::Object(members) => {
            let of = |(name, value): (String, Json)| {
                let value = by_bits(value, name == "data");
                (name, value)
            };
            Json::Object(members.into_iter().map(of).collect())
        }
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn by_bits_stand_the_items_of_data_and_nothing_else() {
        let pattern = Json::read(r#"{"t":1.0,"channels":{"a":{"data":[0.0,"-0"],"unit":"m"}},"horizon":[[1.0]]}"#);
        let channels = r#"{"a":{"data":[{"$double":0.0},{"$double":"-0"}],"unit":"m"}}"#;
        let expected = format!(r#"{{"t":1.0,"channels":{channels},"horizon":[[1.0]]}}"#);
        assert_eq!(by_bits(pattern, false).text(), expected);
    }

    #[test]
    fn a_double_reads_back_or_has_a_name() {
        for (value, text) in [
            (5.0, "5.0"),
            (5e-324, "5e-324"),
            (1e308, "1e308"),
            (-0.0, "\"-0\""),
            (f64::NAN, "\"NaN\""),
            (f64::NEG_INFINITY, "\"-Infinity\""),
        ] {
            assert_eq!(num(value).text(), text);
        }
    }
}
