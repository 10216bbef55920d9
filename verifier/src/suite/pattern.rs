//! Patterns of results, for answers of which a case does not judge everything.
//!
//! A pattern is JSON of which some objects have a meaning of their own, told by their one member: `$any`,
//! `$beginning`, `$error`, `$exact`, `$json`, `$frame`, `$range`, `$double`, `$text`, `$anything`. In a list,
//! `{"$item": pattern, "times": 1000}` stands for so many equal items, and `{"$items": [pattern, …], "times": 1000}`
//! for so many equal rounds of items; no other template stands in a pattern. Reading it is strict: a pattern that is
//! misspelt would test nothing.

use std::borrow::Cow;
use std::fmt::{self, Write as _};

use super::template::{self, TemplateError};
use crate::json::{Json, JsonError, Number, write_string};

/// The members that make an object more than an object.
const WORDS: &str =
    "`$any`, `$beginning`, `$error`, `$exact`, `$json`, `$frame`, `$range`, `$double`, `$text`, `$anything`";

/// How many items the lists of one pattern have at most, those that `$item` stands for counted.
const MOST_ITEMS: usize = 1 << 20;

/// What a value has to look like.
#[derive(Debug, Clone)]
pub enum Shape {
    /// Null, or nothing at all.
    Null,
    /// This boolean.
    Bool(bool),
    /// This number, within a tolerance.
    Number(Number),
    /// This string.
    Text(String),
    /// An array of as many items.
    Items(Vec<Shape>),
    /// An array of the first of these items, of one at least and of all at most: `$beginning`.
    Beginning(Vec<Shape>),
    /// An object that has these members, and perhaps more.
    Members(Vec<(String, Shape)>),
    /// An object that has these members and no more: `$exact`.
    Exact(Vec<(String, Shape)>),
    /// One of these, of which there is at least one: `$any`.
    Any(Vec<Shape>),
    /// A step of a trace that was refused, but not by a crash: `$error`.
    Refused,
    /// A string that is JSON text of this: `$json`.
    Json(Box<Shape>),
    /// A string that is JSON text of this as an encoder writes it, the members that are named in this order and each
    /// integer spelled as one: `$frame`.
    Frame(Box<Shape>),
    /// A number from one to another, both included: `$range`.
    Range(Number, Number),
    /// This double and no other, so that −0 is not 0, whatever the tolerance: `$double`.
    Double(Number),
    /// A string that is not empty: `$text`.
    SomeText,
    /// Whatever is there: `$anything`.
    Anything,
}

/// Why a pattern is none.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum PatternError {
    /// It is not JSON.
    #[error(transparent)]
    Json(#[from] JsonError),
    /// An object begins like a special one but is none.
    #[error("`{0}` is no word of a pattern: one of {WORDS}")]
    Unknown(String),
    /// A special object has other members.
    #[error("`{0}` of a pattern stands alone in its object")]
    NotAlone(String),
    /// What follows the word does not fit it.
    #[error("`{word}` of a pattern is not {expected}")]
    Operand {
        /// The word.
        word: &'static str,
        /// What has to follow it.
        expected: &'static str,
    },
    /// `$item` stands for too much.
    #[error("the lists of a pattern have more than {MOST_ITEMS} items")]
    Size,
}

impl Shape {
    /// Reads a pattern.
    ///
    /// # Errors
    /// [`PatternError`] if it is not JSON, or an object in it has a member that begins with `$` and is no special
    /// object.
    pub fn parse(text: &str) -> Result<Self, PatternError> {
        let value = Json::parse(text)?;
        if weight(&value)? > MOST_ITEMS {
            return Err(PatternError::Size);
        }
        Self::of(&value)
    }

    fn of(value: &Json<'_>) -> Result<Self, PatternError> {
        Ok(match value {
            Json::Null => Self::Null,
            Json::Bool(value) => Self::Bool(*value),
            Json::Number(spelling) => Self::Number(Number::read(spelling)),
            Json::String(text) => Number::of(value).map_or_else(|| Self::Text(text.to_string()), Self::Number),
            Json::Array(items) => Self::Items(listed(items)?),
            Json::Object(members) => match members.iter().find(|(name, _)| name.starts_with('$')) {
                None => Self::Members(named(members)?),
                Some((word, operand)) if members.len() == 1 => Self::special(word, operand)?,
                Some((word, _)) => return Err(PatternError::NotAlone(word.to_string())),
            },
        })
    }

    fn special(word: &str, operand: &Json<'_>) -> Result<Self, PatternError> {
        let wrong = |word, expected| Err(PatternError::Operand { word, expected });
        match (word, operand) {
            ("$any", Json::Array(choices)) if !choices.is_empty() => all(choices).map(Self::Any),
            ("$any", _) => wrong("$any", "an array of patterns"),
            ("$beginning", Json::Array(items)) if !items.is_empty() => listed(items).map(Self::Beginning),
            ("$beginning", _) => wrong("$beginning", "an array of patterns"),
            ("$error", Json::Bool(true)) => Ok(Self::Refused),
            ("$error", _) => wrong("$error", "true"),
            ("$exact", Json::Object(members)) => match members.iter().find(|(name, _)| name.starts_with('$')) {
                None => named(members).map(Self::Exact),
                Some(_) => wrong("$exact", "an object of plain members"),
            },
            ("$exact", _) => wrong("$exact", "an object of plain members"),
            ("$json", inner) => Self::of(inner).map(|inner| Self::Json(Box::new(inner))),
            ("$frame", inner) => Self::of(inner).map(|inner| Self::Frame(Box::new(inner))),
            ("$range", Json::Array(ends)) => match ends.iter().map(Number::of).collect::<Vec<_>>().as_slice() {
                [Some(low), Some(high)] if low.as_double() <= high.as_double() => Ok(Self::Range(*low, *high)),
                _ => wrong("$range", "two numbers in order"),
            },
            ("$range", _) => wrong("$range", "two numbers in order"),
            ("$double", value) => match Number::of(value) {
                Some(number) if !number.is_integer() => Ok(Self::Double(number)),
                _ => wrong("$double", "a double"),
            },
            ("$text", Json::Bool(true)) => Ok(Self::SomeText),
            ("$text", _) => wrong("$text", "true"),
            ("$anything", Json::Bool(true)) => Ok(Self::Anything),
            ("$anything", _) => wrong("$anything", "true"),
            _ => Err(PatternError::Unknown(word.to_owned())),
        }
    }
}

/// As a pattern is written, without white space.
impl fmt::Display for Shape {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Null => f.write_str("null"),
            Self::Bool(value) => write!(f, "{value}"),
            Self::Number(number) => write!(f, "{number}"),
            Self::Text(text) => write_name(text, f),
            Self::Items(items) => write_items(items, f),
            Self::Beginning(items) => {
                f.write_str("{\"$beginning\":")?;
                write_items(items, f)?;
                f.write_char('}')
            }
            Self::Members(members) => write_members(members, f),
            Self::Exact(members) => {
                f.write_str("{\"$exact\":")?;
                write_members(members, f)?;
                f.write_char('}')
            }
            Self::Any(choices) => {
                f.write_str("{\"$any\":")?;
                write_items(choices, f)?;
                f.write_char('}')
            }
            Self::Refused => f.write_str("{\"$error\":true}"),
            Self::Json(inner) => write!(f, "{{\"$json\":{inner}}}"),
            Self::Frame(inner) => write!(f, "{{\"$frame\":{inner}}}"),
            Self::Range(low, high) => write!(f, "{{\"$range\":[{low},{high}]}}"),
            Self::Double(number) => write!(f, "{{\"$double\":{number}}}"),
            Self::SomeText => f.write_str("{\"$text\":true}"),
            Self::Anything => f.write_str("{\"$anything\":true}"),
        }
    }
}

fn all(items: &[Json<'_>]) -> Result<Vec<Shape>, PatternError> {
    items.iter().map(Shape::of).collect()
}

/// The items of a list, each as often as it stands there.
fn listed(items: &[Json<'_>]) -> Result<Vec<Shape>, PatternError> {
    let mut shapes = Vec::with_capacity(items.len());
    for each in items {
        let (items, times) = counted(each)?;
        let round = all(items)?;
        shapes.extend(std::iter::repeat_n(round, times).flatten());
    }
    Ok(shapes)
}

/// The items that an entry of a list stands for, and how often they stand there.
fn counted<'v, 'a>(value: &'v Json<'a>) -> Result<(&'v [Json<'a>], usize), PatternError> {
    template::items(value).map_err(|error| match error {
        TemplateError::Type { name, expected } => PatternError::Operand { word: name, expected },
        _ => PatternError::Operand { word: "times", expected: "a count from 1" },
    })
}

/// How many items the lists within a value have, those that `$item` stands for counted.
fn weight(value: &Json<'_>) -> Result<usize, PatternError> {
    match value {
        Json::Array(items) => items.iter().try_fold(0_usize, |sum, each| {
            let (items, times) = counted(each)?;
            let round = items
                .iter()
                .try_fold(items.len(), |sum, item| Ok::<_, PatternError>(sum.saturating_add(weight(item)?)))?;
            Ok(sum.saturating_add(round.saturating_mul(times)))
        }),
        Json::Object(members) => {
            members.iter().try_fold(0_usize, |sum, (_, member)| Ok(sum.saturating_add(weight(member)?)))
        }
        _ => Ok(0),
    }
}

fn named(members: &[(Cow<'_, str>, Json<'_>)]) -> Result<Vec<(String, Shape)>, PatternError> {
    members.iter().map(|(name, value)| Ok((name.to_string(), Shape::of(value)?))).collect()
}

fn write_name(text: &str, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    let mut out = String::new();
    write_string(text, &mut out);
    f.write_str(&out)
}

fn write_items(items: &[Shape], f: &mut fmt::Formatter<'_>) -> fmt::Result {
    f.write_char('[')?;
    for (i, item) in items.iter().enumerate() {
        if i > 0 {
            f.write_char(',')?;
        }
        write!(f, "{item}")?;
    }
    f.write_char(']')
}

fn write_members(members: &[(String, Shape)], f: &mut fmt::Formatter<'_>) -> fmt::Result {
    f.write_char('{')?;
    for (i, (name, value)) in members.iter().enumerate() {
        if i > 0 {
            f.write_char(',')?;
        }
        write_name(name, f)?;
        write!(f, ":{value}")?;
    }
    f.write_char('}')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pattern_is_shown_as_it_was_written() {
        for text in [
            r#"{"steps":[{"hold":true},{},{"$error":true}],"a":null}"#,
            r#"{"$any":[1.5,"a\"b",{"$exact":{"b":[null]}}]}"#,
            r#"{"$json":{"ok":{"$anything":true},"t":{"$range":[-1,"Infinity"]},"why":{"$text":true}}}"#,
            r#"{"$frame":{"b":[1],"a":{"$exact":{}}}}"#,
            r#"{"$beginning":[{"a":1},[2]]}"#,
            r#"["NaN","-Infinity",-0.0,9007199254740993,1e300]"#,
        ] {
            assert_eq!(Shape::parse(text).unwrap().to_string(), text);
        }
        let rounds = Shape::parse(r#"[0,{"$items":[1,{"a":2}],"times":2},{"$item":3,"times":2}]"#).unwrap();
        assert_eq!(rounds.to_string(), r#"[0,1,{"a":2},1,{"a":2},3,3]"#);
    }

    #[test]
    fn a_faulty_pattern_is_refused() {
        for (pattern, fault) in [
            (r#"{"a":[{"$eror":true}]}"#, "`$eror` is no word of a pattern"),
            (r#"{"$repeat":"x","times":3}"#, "`$repeat` of a pattern stands alone"),
            (r#"{"$item":"x","times":3}"#, "`$item` of a pattern stands alone"),
            (r#"{"$any":[{"$item":1,"times":3}]}"#, "`$item` of a pattern stands alone"),
            (r#"[{"$item":1,"times":0}]"#, "`times` of a pattern is not a count from 1"),
            (r#"[{"$items":[],"times":3}]"#, "`$items` of a pattern is not a list of one item at least"),
            (r#"[{"$items":[1,{"$any":1}],"times":3}]"#, "`$any` of a pattern is not an array of patterns"),
            (r#"[{"$item":[{"$item":1,"times":9999}],"times":9999}]"#, "have more than 1048576 items"),
            (r#"{"$repeat":"x"}"#, "`$repeat` is no word of a pattern"),
            (r#"{"a":1,"$any":[1]}"#, "`$any` of a pattern stands alone"),
            (r#"{"$any":[]}"#, "`$any` of a pattern is not an array of patterns"),
            (r#"{"$any":1}"#, "`$any` of a pattern is not an array of patterns"),
            (r#"{"$any":[{"$nay":[1]}]}"#, "`$nay` is no word"),
            (r#"{"$beginning":[]}"#, "`$beginning` of a pattern is not an array of patterns"),
            (r#"{"$error":false}"#, "`$error` of a pattern is not true"),
            (r#"{"$error":"type"}"#, "`$error` of a pattern is not true"),
            (r#"{"$exact":[1]}"#, "`$exact` of a pattern is not an object"),
            (r#"{"$exact":{"$any":[1]}}"#, "`$exact` of a pattern is not an object"),
            (r#"{"$json":{"$jsn":1}}"#, "`$jsn` is no word"),
            (r#"{"$range":[1]}"#, "`$range` of a pattern is not two numbers in order"),
            (r#"{"$range":[2,1]}"#, "`$range` of a pattern is not two numbers in order"),
            (r#"{"$range":[1,"NaN"]}"#, "`$range` of a pattern is not two numbers in order"),
            (r#"{"$range":["1",2]}"#, "`$range` of a pattern is not two numbers in order"),
            (r#"{"$text":"why"}"#, "`$text` of a pattern is not true"),
            (r#"{"$anything":false}"#, "`$anything` of a pattern is not true"),
            (r#"{"a":1,"a":2}"#, "stands twice"),
            ("{", "ends too early"),
        ] {
            let error = Shape::parse(pattern).unwrap_err().to_string();
            assert!(error.contains(fault), "{pattern}: {error}");
        }
    }
}
