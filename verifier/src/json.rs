//! JSON as it is spelled.
//!
//! A verdict on an encoder has to see what a model of values hides: the order of members, a member that
//! stands twice, and whether an integer was written `5` or `5.0`. So this reader keeps numbers as they
//! are spelled and objects as lists, and refuses a repeated member.
//!
//! It reads vector files, answers of peers, and the frames within both. It is no part of the rules of
//! NCP: what a frame means is asked of [`ncp_spec`].

use std::borrow::Cow;
use std::cell::OnceCell;
use std::collections::{HashMap, HashSet};
use std::fmt::{self, Write as _};

/// How deep arrays and objects may nest. Answers are a few levels deep; hostile nesting travels inside strings.
const MAX_DEPTH: usize = 160;

/// Up to so many bytes of a string are looked at one by one, the rest in blocks of as many.
const SHORT: usize = 64;

/// Up to how many members of an object are compared one by one.
const FEW: usize = 12;

/// A JSON value, borrowed from its text where that is possible.
#[derive(Debug, Clone, PartialEq)]
pub enum Json<'a> {
    /// `null`
    Null,
    /// `true` or `false`
    Bool(bool),
    /// A number, spelled as in its text.
    Number(Cow<'a, str>),
    /// A string, its escapes resolved.
    String(Cow<'a, str>),
    /// An array.
    Array(Vec<Json<'a>>),
    /// An object: its members in the order of the text, each name once.
    Object(Vec<(Cow<'a, str>, Json<'a>)>),
}

/// Why a text is not one JSON value.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{what} at byte {offset}")]
pub struct JsonError {
    /// Where, in bytes from the start of the text.
    pub offset: usize,
    /// What is wrong there.
    pub what: JsonFault,
}

/// What is wrong with a text that is not JSON.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum JsonFault {
    /// Something else was expected here.
    #[error("expected {0}")]
    Expected(&'static str),
    /// The text ends too early.
    #[error("the text ends too early")]
    End,
    /// Something follows the value.
    #[error("something follows the value")]
    Trailing,
    /// An object has a member twice.
    #[error("the member {0:?} stands twice in one object")]
    Duplicate(String),
    /// A surrogate escape lacks its partner.
    #[error("an escaped surrogate lacks its partner")]
    Surrogate,
    /// Arrays and objects are nested too deeply.
    #[error("more than {MAX_DEPTH} levels")]
    Depth,
}

/// A number by its meaning: the nearest double, and the exact integer if it is spelled as one.
#[derive(Debug, Clone, Copy)]
pub struct Number {
    /// The integer, if it is spelled without fraction and exponent and is not `-0`.
    integer: Option<i128>,
    double: f64,
}

impl Number {
    /// Reads the spelling of a JSON number.
    #[must_use]
    pub fn read(spelling: &str) -> Self {
        let integer = if is_integer(spelling) && spelling != "-0" { spelling.parse().ok() } else { None };
        Self { integer, double: spelling.parse().unwrap_or(f64::NAN) }
    }

    /// The number that a value is, or that its string stands for: `"NaN"`, `"Infinity"`, `"-Infinity"`, `"-0"`.
    #[must_use]
    pub fn of(value: &Json<'_>) -> Option<Self> {
        let double = match value {
            Json::Number(spelling) => return Some(Self::read(spelling)),
            Json::String(name) => match name.as_ref() {
                "NaN" => f64::NAN,
                "Infinity" => f64::INFINITY,
                "-Infinity" => f64::NEG_INFINITY,
                "-0" => -0.0,
                _ => return None,
            },
            _ => return None,
        };
        Some(Self { integer: None, double })
    }

    /// The nearest double.
    #[must_use]
    pub fn as_double(self) -> f64 {
        self.double
    }

    /// Whether it is spelled as an integer.
    #[must_use]
    pub fn is_integer(self) -> bool {
        self.integer.is_some()
    }

    /// Whether another number is this one but for `tolerance`, which is relative, with a floor of the same size:
    /// |a − b| ≤ tolerance · max(1, |a|, |b|). 0 is −0, and two integers have to be the same.
    #[must_use]
    pub fn is_near(self, got: Self, tolerance: f64) -> bool {
        let (a, b) = (self.double, got.double);
        match (self.integer, got.integer) {
            (Some(expected), Some(got)) => expected == got,
            _ if a.is_finite() && b.is_finite() => (a - b).abs() <= tolerance * a.abs().max(b.abs()).max(1.0),
            _ => a == b || (a.is_nan() && b.is_nan()),
        }
    }

    /// Whether another number is the one that is expected here.
    ///
    /// Where a double is expected, that is the same double by its bits, so that −0 is not 0, however many digits spell
    /// it. Where an integer is expected, that is exactly this integer.
    #[must_use]
    pub fn is_met_by(self, got: Self) -> bool {
        match (self.integer, got.integer) {
            (Some(expected), Some(got)) => expected == got,
            (Some(expected), None) => is_exactly(got.double, expected),
            (None, _) => self.double.to_bits() == got.double.to_bits() || (self.double.is_nan() && got.double.is_nan()),
        }
    }
}

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.integer, self.double) {
            (Some(integer), _) => write!(f, "{integer}"),
            (None, f64::INFINITY) => f.write_str("\"Infinity\""),
            (None, f64::NEG_INFINITY) => f.write_str("\"-Infinity\""),
            (None, double) if double.is_nan() => f.write_str("\"NaN\""),
            (None, double) => write!(f, "{double:?}"),
        }
    }
}

/// Whether a number is spelled without fraction and exponent.
#[must_use]
pub fn is_integer(spelling: &str) -> bool {
    !spelling.bytes().any(|b| matches!(b, b'.' | b'e' | b'E'))
}

impl<'a> Json<'a> {
    /// Reads one JSON value that fills the text, apart from white space around it.
    ///
    /// # Errors
    /// [`JsonError`] if the text is anything else, or an object in it has a member twice.
    pub fn parse(text: &'a str) -> Result<Self, JsonError> {
        let mut reader = Reader { text, at: 0 };
        reader.skip_space();
        let value = reader.value(0)?;
        reader.skip_space();
        if reader.at < text.len() {
            return reader.fail(JsonFault::Trailing);
        }
        Ok(value)
    }

    /// The member of this name, if this is an object that has it.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<&Json<'a>> {
        match self {
            Self::Object(members) => members.iter().find(|(key, _)| key == name).map(|(_, value)| value),
            _ => None,
        }
    }

    /// The value that a JSON pointer (RFC 6901) leads to.
    #[must_use]
    pub fn pointer(&self, pointer: &str) -> Option<&Json<'a>> {
        let mut here = self;
        for token in pointer.split('/').skip(1) {
            here = match here {
                Self::Object(_) => here.get(&token.replace("~1", "/").replace("~0", "~"))?,
                Self::Array(items) => items.get(token.parse::<usize>().ok()?)?,
                _ => return None,
            };
        }
        Some(here)
    }

    /// The string, if this is one.
    #[must_use]
    pub fn as_str(&self) -> Option<&str> {
        match self {
            Self::String(text) => Some(text),
            _ => None,
        }
    }

    /// Whether this is `null`.
    #[must_use]
    pub fn is_null(&self) -> bool {
        matches!(self, Self::Null)
    }

    /// What kind of value this is, in words.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Null => "null",
            Self::Bool(_) => "a boolean",
            Self::Number(_) => "a number",
            Self::String(_) => "a string",
            Self::Array(_) => "an array",
            Self::Object(_) => "an object",
        }
    }

    /// Writes the value without white space, numbers as they were spelled.
    pub fn write_to(&self, out: &mut String) {
        match self {
            Self::Null => out.push_str("null"),
            Self::Bool(true) => out.push_str("true"),
            Self::Bool(false) => out.push_str("false"),
            Self::Number(spelling) => out.push_str(spelling),
            Self::String(text) => write_string(text, out),
            Self::Array(items) => {
                out.push('[');
                for (i, item) in items.iter().enumerate() {
                    if i > 0 {
                        out.push(',');
                    }
                    item.write_to(out);
                }
                out.push(']');
            }
            Self::Object(members) => {
                out.push('{');
                for (i, (name, value)) in members.iter().enumerate() {
                    if i > 0 {
                        out.push(',');
                    }
                    write_string(name, out);
                    out.push(':');
                    value.write_to(out);
                }
                out.push('}');
            }
        }
    }
}

impl fmt::Display for Json<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut out = String::new();
        self.write_to(&mut out);
        f.write_str(&out)
    }
}

/// The members of an object, to be looked up many times: by place, else by name.
#[derive(Debug)]
pub struct Members<'v, 'a> {
    list: &'v [(Cow<'a, str>, Json<'a>)],
    index: OnceCell<HashMap<&'v str, usize>>,
}

impl<'v, 'a> Members<'v, 'a> {
    /// The members of an object.
    #[must_use]
    pub fn new(list: &'v [(Cow<'a, str>, Json<'a>)]) -> Self {
        Self { list, index: OnceCell::new() }
    }

    /// The member of this name, which is most likely at this place.
    #[must_use]
    pub fn get(&self, name: &str, place: usize) -> Option<&'v Json<'a>> {
        match self.list.get(place) {
            Some((there, value)) if there == name => Some(value),
            _ if self.list.len() <= FEW => self.list.iter().find(|(key, _)| key == name).map(|(_, value)| value),
            _ => {
                let index = || self.list.iter().enumerate().map(|(i, (key, _))| (key.as_ref(), i)).collect();
                let place = *self.index.get_or_init(index).get(name)?;
                self.list.get(place).map(|(_, value)| value)
            }
        }
    }
}

/// Writes a JSON string, quotes included. Only what JSON demands is escaped.
pub fn write_string(text: &str, out: &mut String) {
    out.reserve(text.len() + 2);
    out.push('"');
    let mut start = 0;
    loop {
        let at = start + plain(&text.as_bytes()[start..]);
        out.push_str(&text[start..at]);
        let Some(byte) = text.as_bytes().get(at) else { break };
        start = at + 1;
        match byte {
            b'"' => out.push_str("\\\""),
            b'\\' => out.push_str("\\\\"),
            b'\n' => out.push_str("\\n"),
            b'\r' => out.push_str("\\r"),
            b'\t' => out.push_str("\\t"),
            // Writing to a string cannot fail.
            _ => drop(write!(out, "\\u{byte:04x}")),
        }
    }
    out.push('"');
}

/// How many bytes from the start stand for themselves within a string: no quote, no backslash, no control character.
fn plain(bytes: &[u8]) -> usize {
    let end = |bytes: &[u8]| bytes.iter().position(|byte| matches!(byte, b'"' | b'\\') || *byte < b' ');
    // Most strings are short. Of a long one, many bytes are looked at at once: without a branch, the compiler can.
    let (start, rest) = bytes.split_at(bytes.len().min(SHORT));
    let ends = |byte: &u8| u8::from((*byte == b'"') | (*byte == b'\\') | (*byte < b' '));
    let is_plain = |block: &&[u8]| block.iter().fold(0, |found, byte| found | ends(byte)) == 0;
    end(start).unwrap_or_else(|| {
        let blocks = rest.chunks_exact(SHORT).take_while(is_plain).count() * SHORT;
        let last = rest.get(blocks..).unwrap_or_default();
        start.len() + blocks + end(last).unwrap_or(last.len())
    })
}

/// A member name as one token of a JSON pointer.
#[must_use]
pub fn pointer_token(name: &str) -> Cow<'_, str> {
    if name.contains(['~', '/']) { Cow::Owned(name.replace('~', "~0").replace('/', "~1")) } else { Cow::Borrowed(name) }
}

/// Whether a double is exactly this integer. The negative zero is not.
fn is_exactly(double: f64, integer: i128) -> bool {
    // Beyond 2^126 the cast would saturate; no field of NCP comes near.
    double.is_finite()
        && double.abs() < 8e37
        && double.fract() == 0.0
        && double as i128 == integer
        && !(integer == 0 && double.is_sign_negative())
}

struct Reader<'a> {
    text: &'a str,
    at: usize,
}

impl<'a> Reader<'a> {
    fn fail<T>(&self, what: JsonFault) -> Result<T, JsonError> {
        Err(JsonError { offset: self.at, what })
    }

    fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    fn skip_space(&mut self) {
        while matches!(self.peek(), Some(b' ' | b'\t' | b'\n' | b'\r')) {
            self.at += 1;
        }
    }

    fn expect(&mut self, byte: u8, what: &'static str) -> Result<(), JsonError> {
        match self.peek() {
            Some(found) if found == byte => {
                self.at += 1;
                Ok(())
            }
            Some(_) => self.fail(JsonFault::Expected(what)),
            None => self.fail(JsonFault::End),
        }
    }

    fn literal(&mut self, word: &'static str, value: Json<'a>) -> Result<Json<'a>, JsonError> {
        if self.text[self.at..].starts_with(word) {
            self.at += word.len();
            return Ok(value);
        }
        self.fail(JsonFault::Expected("a JSON value"))
    }

    fn value(&mut self, depth: usize) -> Result<Json<'a>, JsonError> {
        if depth > MAX_DEPTH {
            return self.fail(JsonFault::Depth);
        }
        match self.peek() {
            Some(b'{') => self.object(depth),
            Some(b'[') => self.array(depth),
            Some(b'"') => Ok(Json::String(self.string()?)),
            Some(b't') => self.literal("true", Json::Bool(true)),
            Some(b'f') => self.literal("false", Json::Bool(false)),
            Some(b'n') => self.literal("null", Json::Null),
            Some(b'-' | b'0'..=b'9') => self.number(),
            Some(_) => self.fail(JsonFault::Expected("a JSON value")),
            None => self.fail(JsonFault::End),
        }
    }

    fn object(&mut self, depth: usize) -> Result<Json<'a>, JsonError> {
        let start = self.at;
        self.at += 1;
        let mut members: Vec<(Cow<'a, str>, Json<'a>)> = Vec::new();
        self.skip_space();
        if self.peek() == Some(b'}') {
            self.at += 1;
            return Ok(Json::Object(members));
        }
        loop {
            self.skip_space();
            if self.peek().is_some_and(|byte| byte != b'"') {
                return self.fail(JsonFault::Expected("a member name"));
            }
            let name = self.string()?;
            self.skip_space();
            self.expect(b':', "`:`")?;
            self.skip_space();
            let value = self.value(depth + 1)?;
            members.push((name, value));
            self.skip_space();
            if self.peek() == Some(b',') {
                self.at += 1;
                continue;
            }
            self.expect(b'}', "`,` or `}`")?;
            if let Some(name) = repeated(&members) {
                return Err(JsonError { offset: start, what: JsonFault::Duplicate(name.to_owned()) });
            }
            return Ok(Json::Object(members));
        }
    }

    fn array(&mut self, depth: usize) -> Result<Json<'a>, JsonError> {
        self.at += 1;
        let mut items = Vec::new();
        self.skip_space();
        if self.peek() == Some(b']') {
            self.at += 1;
            return Ok(Json::Array(items));
        }
        loop {
            self.skip_space();
            items.push(self.value(depth + 1)?);
            self.skip_space();
            if self.peek() == Some(b',') {
                self.at += 1;
                continue;
            }
            self.expect(b']', "`,` or `]`")?;
            return Ok(Json::Array(items));
        }
    }

    fn number(&mut self) -> Result<Json<'a>, JsonError> {
        let start = self.at;
        if self.peek() == Some(b'-') {
            self.at += 1;
        }
        if self.peek() == Some(b'0') {
            self.at += 1;
        } else {
            self.digits()?;
        }
        if self.peek() == Some(b'.') {
            self.at += 1;
            self.digits()?;
        }
        if matches!(self.peek(), Some(b'e' | b'E')) {
            self.at += 1;
            if matches!(self.peek(), Some(b'+' | b'-')) {
                self.at += 1;
            }
            self.digits()?;
        }
        Ok(Json::Number(Cow::Borrowed(&self.text[start..self.at])))
    }

    fn digits(&mut self) -> Result<(), JsonError> {
        let start = self.at;
        while matches!(self.peek(), Some(b'0'..=b'9')) {
            self.at += 1;
        }
        if self.at == start { self.fail(JsonFault::Expected("a digit")) } else { Ok(()) }
    }

    fn string(&mut self) -> Result<Cow<'a, str>, JsonError> {
        self.expect(b'"', "a string")?;
        let start = self.at;
        let mut owned: Option<String> = None;
        let mut seen = start;
        loop {
            let rest = &self.text.as_bytes()[self.at..];
            self.at += plain(rest);
            let run = &self.text[seen..self.at];
            match self.peek() {
                None => return self.fail(JsonFault::End),
                Some(b'"') => {
                    self.at += 1;
                    return Ok(match owned {
                        None => Cow::Borrowed(run),
                        Some(text) => Cow::Owned(text + run),
                    });
                }
                Some(b'\\') => {
                    self.at += 1;
                    let text = owned.get_or_insert_default();
                    text.push_str(run);
                    text.push(self.escape()?);
                    seen = self.at;
                }
                Some(_) => {
                    return self.fail(JsonFault::Expected("an escape instead of a control character"));
                }
            }
        }
    }

    fn escape(&mut self) -> Result<char, JsonError> {
        let Some(byte) = self.peek() else {
            return self.fail(JsonFault::End);
        };
        self.at += 1;
        Ok(match byte {
            b'"' => '"',
            b'\\' => '\\',
            b'/' => '/',
            b'b' => '\u{8}',
            b'f' => '\u{c}',
            b'n' => '\n',
            b'r' => '\r',
            b't' => '\t',
            b'u' => return self.unicode(),
            _ => {
                self.at -= 1;
                return self.fail(JsonFault::Expected("an escape"));
            }
        })
    }

    fn unicode(&mut self) -> Result<char, JsonError> {
        let first = self.hex4()?;
        let code = if (0xd800..0xdc00).contains(&first) {
            if !self.text[self.at..].starts_with("\\u") {
                return self.fail(JsonFault::Surrogate);
            }
            self.at += 2;
            let second = self.hex4()?;
            if !(0xdc00..0xe000).contains(&second) {
                return self.fail(JsonFault::Surrogate);
            }
            0x1_0000 + ((first - 0xd800) << 10) + (second - 0xdc00)
        } else {
            first
        };
        match char::from_u32(code) {
            Some(resolved) => Ok(resolved),
            None => self.fail(JsonFault::Surrogate),
        }
    }

    fn hex4(&mut self) -> Result<u32, JsonError> {
        let digits = self.text.get(self.at..self.at + 4).filter(|d| d.bytes().all(|b| b.is_ascii_hexdigit()));
        let Some(code) = digits.and_then(|d| u32::from_str_radix(d, 16).ok()) else {
            return self.fail(JsonFault::Expected("four hexadecimal digits"));
        };
        self.at += 4;
        Ok(code)
    }
}

/// A name that stands twice, if there is one.
fn repeated<'m>(members: &'m [(Cow<'_, str>, Json<'_>)]) -> Option<&'m str> {
    if members.len() <= FEW {
        let twice = |(i, (name, _)): (usize, &'m (Cow<'_, str>, Json<'_>))| {
            members[..i].iter().any(|(earlier, _)| earlier == name).then_some(name.as_ref())
        };
        return members.iter().enumerate().find_map(twice);
    }
    let mut seen = HashSet::with_capacity(members.len());
    members.iter().map(|(name, _)| name.as_ref()).find(|name| !seen.insert(*name))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn order_and_spelling_survive() {
        let text = r#"{"b":5.0,"a":[-0,1e3,5],"ä":"A\n","c":null}"#;
        assert_eq!(Json::parse(text).unwrap().to_string(), r#"{"b":5.0,"a":[-0,1e3,5],"ä":"A\n","c":null}"#);
    }

    #[test]
    fn a_member_that_stands_twice_is_refused_also_when_one_is_escaped() {
        for text in [r#"{"seq":1,"seq":1}"#, r#"{"seq":1,"s\u0065q":1}"#, r#"{"x":{"seq":1,"seq":1}}"#] {
            let error = Json::parse(text).unwrap_err();
            assert_eq!(error.what, JsonFault::Duplicate("seq".to_owned()), "{text}");
        }
        let many: Vec<String> = (0..100).map(|i| format!("\"k{}\":0", i % 99)).collect();
        let text = format!("{{{}}}", many.join(","));
        assert_eq!(Json::parse(&text).unwrap_err().what, JsonFault::Duplicate("k0".to_owned()));
    }

    #[test]
    fn what_the_grammar_forbids_is_refused() {
        for text in [
            "",
            " ",
            "{",
            "[1,]",
            "{\"a\":1,}",
            "{a:1}",
            "01",
            "1.",
            ".5",
            "+1",
            "1e",
            "-",
            "nul",
            "NaN",
            "'a'",
            "\"a",
            "\"\t\"",
            "\"\\x\"",
            "\"\\u12\"",
            "\"\\ud800\"",
            "\"\\udc00\"",
            "\"\\ud800\\u0041\"",
            "1 2",
            "{} x",
            "// c\n1",
            "\u{feff}{}",
        ] {
            assert!(Json::parse(text).is_err(), "{text:?} was read");
        }
    }

    #[test]
    fn nesting_is_bounded() {
        let deep = |n: usize| format!("{}{}", "[".repeat(n), "]".repeat(n));
        assert!(Json::parse(&deep(100)).is_ok());
        assert_eq!(Json::parse(&deep(100_000)).unwrap_err().what, JsonFault::Depth);
    }

    #[test]
    fn a_number_is_met_by_value_and_sign_of_zero() {
        let met = |expected: &str, got: &str| Number::read(expected).is_met_by(Number::read(got));
        for (a, b) in [("5", "5.0"), ("5", "50e-1"), ("-0.0", "-0"), ("0", "0.0"), ("1e2", "100")] {
            assert!(met(a, b) && met(b, a), "{a} {b}");
        }
        for (a, b) in [
            ("0", "-0"),
            ("0.0", "-0.0"),
            ("1", "2"),
            ("9007199254740993", "9007199254740992"),
            ("9007199254740993", "9007199254740992.0"),
            ("0.1", "0.10000000000000002"),
        ] {
            assert!(!met(a, b), "{a} {b}");
        }
        // The shortest digits that read back as 2^63 are not 2^63; they are that double all the same.
        assert!(met("9.223372036854775808e18", "9223372036854776000"));
        assert!(!met("9223372036854775808", "9223372036854776000"));
    }

    #[test]
    fn members_are_found_wherever_they_stand() {
        for count in [3, 100] {
            let text: Vec<String> = (0..count).map(|i| format!("\"k{i}\":{i}")).collect();
            let object = Json::parse(&format!("{{{}}}", text.join(","))).unwrap().to_string();
            let Json::Object(list) = Json::parse(&object).unwrap() else { panic!() };
            let members = Members::new(&list);
            for (name, place) in [("k2", 2), ("k2", 0), ("k0", 999)] {
                assert_eq!(members.get(name, place), Some(&Json::Number(name[1..].into())));
            }
            assert_eq!(members.get("k", 1), None);
        }
    }

    #[test]
    fn a_pointer_finds_members_and_items() {
        let value = Json::parse(r#"{"a":[{"b/c~":7}]}"#).unwrap();
        let path = format!("/a/0/{}", pointer_token("b/c~"));
        assert_eq!(value.pointer(&path), Some(&Json::Number("7".into())));
        assert_eq!(value.pointer("/a/1"), None);
        assert_eq!(value.pointer(""), Some(&value));
    }

    proptest! {
        #[test]
        fn any_string_survives_writing_and_reading(text in any::<String>()) {
            let mut written = String::new();
            write_string(&text, &mut written);
            let read = Json::parse(&written).unwrap();
            prop_assert_eq!(read.as_str(), Some(text.as_str()));
        }

        #[test]
        fn the_plain_bytes_of_a_string_end_where_the_first_other_one_is(plain_ones in 0_usize..300, then: Vec<u8>) {
            let bytes = [vec![b'x'; plain_ones], then].concat();
            let first = bytes.iter().position(|byte| *byte < b' ' || *byte == b'"' || *byte == b'\\');
            prop_assert_eq!(plain(&bytes), first.unwrap_or(bytes.len()));
        }

        #[test]
        fn no_text_makes_the_reader_panic(text in any::<String>()) {
            let _ = Json::parse(&text);
        }

        #[test]
        fn what_serde_writes_is_read_as_the_same_value(value in any_value(4)) {
            let text = serde_json::to_string(&value).unwrap();
            let ours = Json::parse(&text).unwrap().to_string();
            prop_assert_eq!(serde_json::from_str::<serde_json::Value>(&ours).unwrap(), value);
        }
    }

    fn any_value(depth: u32) -> impl Strategy<Value = serde_json::Value> {
        let leaf = prop_oneof![
            Just(serde_json::Value::Null),
            any::<bool>().prop_map(Into::into),
            any::<i64>().prop_map(Into::into),
            any::<f64>().prop_filter("finite", |d| d.is_finite()).prop_map(Into::into),
            any::<String>().prop_map(Into::into),
        ];
        leaf.prop_recursive(depth, 32, 6, |inner| {
            prop_oneof![
                prop::collection::vec(inner.clone(), 0..6).prop_map(serde_json::Value::from),
                prop::collection::btree_map(any::<String>(), inner, 0..6)
                    .prop_map(|m| serde_json::Value::Object(m.into_iter().collect())),
            ]
        })
    }
}
