//! JSON as it is written: members in their order, numbers by their spelling.
//!
//! A frame under test is a text, and its spelling matters: `5` and `5.0`, a member that stands
//! there twice, a literal that is no JSON at all. So this model keeps what a value-based one loses.

use std::fmt::Write as _;

use ncp_text::tables::Value;

/// A JSON value by its spelling.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Json {
    /// `null`
    Null,
    /// `true` or `false`
    Bool(bool),
    /// A number by its digits, or any other text that is to stand as it is, even if it is no JSON.
    Literal(String),
    /// A string by its characters.
    String(String),
    /// An array.
    Array(Vec<Json>),
    /// An object, its members in order; a name may occur twice.
    Object(Vec<(String, Json)>),
}

impl Json {
    /// An empty object.
    pub(crate) const fn object() -> Self {
        Self::Object(Vec::new())
    }

    /// A number, or any other text, as it is.
    pub(crate) fn literal(text: impl Into<String>) -> Self {
        Self::Literal(text.into())
    }

    /// A string.
    pub(crate) fn string(text: impl Into<String>) -> Self {
        Self::String(text.into())
    }

    /// A JSON text by its spelling; what is no JSON, as it is.
    pub(crate) fn read(text: &str) -> Self {
        let mut reader = Reader { rest: text.trim(), depth: 0 };
        reader.value().filter(|_| reader.rest.is_empty()).unwrap_or_else(|| Self::literal(text))
    }

    /// The members, if it is an object.
    pub(crate) fn members(&self) -> &[(String, Json)] {
        match self {
            Self::Object(members) => members,
            _ => &[],
        }
    }

    /// The first member of that name.
    pub(crate) fn get(&self, name: &str) -> Option<&Json> {
        self.members().iter().find(|(known, _)| known == name).map(|(_, value)| value)
    }

    /// The string, if it is one.
    pub(crate) fn as_str(&self) -> Option<&str> {
        match self {
            Self::String(text) => Some(text),
            _ => None,
        }
    }

    /// The object with that member set, in its place if it is there, else at the end.
    pub(crate) fn with(mut self, name: &str, value: Json) -> Self {
        if let Self::Object(members) = &mut self {
            match members.iter_mut().find(|(known, _)| known == name) {
                Some((_, old)) => *old = value,
                None => members.push((name.to_owned(), value)),
            }
        }
        self
    }

    /// The object with that member at its end, also when the name is there already.
    pub(crate) fn and(mut self, name: &str, value: Json) -> Self {
        if let Self::Object(members) = &mut self {
            members.push((name.to_owned(), value));
        }
        self
    }

    /// The object without that member.
    pub(crate) fn without(mut self, name: &str) -> Self {
        if let Self::Object(members) = &mut self {
            members.retain(|(known, _)| known != name);
        }
        self
    }

    /// The value with what stands at a path of member names and indices changed.
    pub(crate) fn edit(self, path: &[&str], change: impl FnOnce(Json) -> Json) -> Self {
        let Some((head, rest)) = path.split_first() else {
            return change(self);
        };
        match self {
            Self::Object(mut members) => {
                if let Some((_, value)) = members.iter_mut().find(|(name, _)| name == head) {
                    *value = std::mem::replace(value, Self::Null).edit(rest, change);
                }
                Self::Object(members)
            }
            Self::Array(mut items) => {
                let item = head.parse::<usize>().ok().and_then(|nth| items.get_mut(nth));
                if let Some(item) = item {
                    *item = std::mem::replace(item, Self::Null).edit(rest, change);
                }
                Self::Array(items)
            }
            scalar => scalar,
        }
    }

    /// The text without white space, as a frame travels; characters beyond ASCII stand as they are.
    pub(crate) fn text(&self) -> String {
        let mut out = String::new();
        self.write(&mut out, Style { spaced: false, ascii: false });
        out
    }

    /// The text for a file: ASCII, one space a level, whatever fits on a line on one line.
    pub(crate) fn pretty(&self) -> String {
        let mut out = String::new();
        self.write_pretty(&mut out, 0);
        out.push('\n');
        out
    }

    fn write(&self, out: &mut String, style: Style) {
        match self {
            Self::Null => out.push_str("null"),
            Self::Bool(value) => out.push_str(if *value { "true" } else { "false" }),
            Self::Literal(text) => out.push_str(text),
            Self::String(text) => write_string(out, text, style.ascii),
            Self::Array(items) => {
                out.push('[');
                for (nth, item) in items.iter().enumerate() {
                    style.separate(out, nth);
                    item.write(out, style);
                }
                out.push(']');
            }
            Self::Object(members) => {
                out.push('{');
                for (nth, (name, value)) in members.iter().enumerate() {
                    style.separate(out, nth);
                    write_string(out, name, style.ascii);
                    out.push_str(if style.spaced { ": " } else { ":" });
                    value.write(out, style);
                }
                out.push('}');
            }
        }
    }

    /// Whether it is little enough to stand with many others on one line.
    fn is_short(&self) -> bool {
        let mut text = String::new();
        self.write(&mut text, Style { spaced: true, ascii: true });
        text.len() <= SHORT
    }

    fn write_pretty(&self, out: &mut String, indent: usize) {
        let mut line = String::new();
        self.write(&mut line, Style { spaced: true, ascii: true });
        let is_long_list = matches!(self, Self::Array(items)
            if items.len() > LONG_LIST && items.iter().all(Self::is_short));
        let is_long_map = matches!(self, Self::Object(members)
            if members.len() > LONG_LIST && members.iter().all(|(_, value)| value.is_short()));
        let is_scalar = !matches!(self, Self::Array(_) | Self::Object(_));
        if is_scalar || is_long_list || is_long_map || indent + line.len() <= LINE {
            out.push_str(&line);
            return;
        }
        let new_line = |out: &mut String, indent: usize| {
            out.push('\n');
            out.extend(std::iter::repeat_n(' ', indent));
        };
        match self {
            Self::Array(items) => {
                out.push('[');
                for (nth, item) in items.iter().enumerate() {
                    out.push_str(if nth == 0 { "" } else { "," });
                    new_line(out, indent + 1);
                    item.write_pretty(out, indent + 1);
                }
                new_line(out, indent);
                out.push(']');
            }
            Self::Object(members) => {
                out.push('{');
                // What is short shares a line as far as it fits, and everything else has its own.
                let mut room = 0;
                for (nth, (name, value)) in members.iter().enumerate() {
                    out.push_str(if nth == 0 { "" } else { "," });
                    let mut member = String::new();
                    write_string(&mut member, name, true);
                    member.push_str(": ");
                    value.write_pretty(&mut member, indent + 1);
                    let is_short = value.is_short();
                    if is_short && member.len() + ", ,".len() <= room {
                        out.push(' ');
                        room -= member.len() + ", ".len();
                    } else {
                        new_line(out, indent + 1);
                        let left = LINE.saturating_sub(indent + 1 + member.len());
                        room = if is_short { left } else { 0 };
                    }
                    out.push_str(&member);
                }
                new_line(out, indent);
                out.push('}');
            }
            _ => {}
        }
    }
}

/// Reads JSON without white space between tokens but for single spaces.
struct Reader<'a> {
    rest: &'a str,
    depth: usize,
}

impl Reader<'_> {
    fn eat(&mut self, token: &str) -> bool {
        let rest = self.rest.trim_start().strip_prefix(token);
        self.rest = rest.unwrap_or(self.rest);
        rest.is_some()
    }

    /// Reads a value; none if it is no JSON, or too deep for the stack.
    fn value(&mut self) -> Option<Json> {
        self.depth += 1;
        let value = (self.depth <= DEEPEST).then(|| self.value_here()).flatten();
        self.depth -= 1;
        value
    }

    fn value_here(&mut self) -> Option<Json> {
        if self.eat("{") {
            let mut members = Vec::new();
            while !self.eat("}") {
                if !members.is_empty() && !self.eat(",") {
                    return None;
                }
                let name = self.string()?;
                if !self.eat(":") {
                    return None;
                }
                members.push((name, self.value()?));
            }
            return Some(Json::Object(members));
        }
        if self.eat("[") {
            let mut items = Vec::new();
            while !self.eat("]") {
                if !items.is_empty() && !self.eat(",") {
                    return None;
                }
                items.push(self.value()?);
            }
            return Some(Json::Array(items));
        }
        if self.rest.trim_start().starts_with('"') {
            return self.string().map(Json::String);
        }
        let rest = self.rest.trim_start();
        let (word, rest) = rest.split_at(rest.find(ends_number).unwrap_or(rest.len()));
        self.rest = rest;
        match word {
            "null" => Some(Json::Null),
            "true" | "false" => Some(Json::Bool(word == "true")),
            _ => word.parse::<f64>().ok().filter(|_| word.starts_with(is_of_number)).map(|_| Json::literal(word)),
        }
    }

    fn string(&mut self) -> Option<String> {
        let mut units = Vec::new();
        let mut chars = self.rest.trim_start().strip_prefix('"')?.chars();
        loop {
            let c = match chars.next()? {
                '"' => break,
                '\\' => match chars.next()? {
                    'u' => {
                        let digits: String = chars.by_ref().take(4).collect();
                        units.push(u16::from_str_radix(&digits, 16).ok()?);
                        continue;
                    }
                    'n' => '\n',
                    'r' => '\r',
                    't' => '\t',
                    'b' => '\u{8}',
                    'f' => '\u{c}',
                    c => c,
                },
                c => c,
            };
            units.extend_from_slice(c.encode_utf16(&mut [0; 2]));
        }
        self.rest = chars.as_str();
        String::from_utf16(&units).ok()
    }
}

/// Twice what a frame may be.
const DEEPEST: usize = 256;

fn ends_number(c: char) -> bool {
    [',', ']', '}'].contains(&c) || c.is_ascii_whitespace()
}

fn is_of_number(c: char) -> bool {
    c.is_ascii_digit() || c == '-'
}

/// What fits on one line of a file.
const LINE: usize = 160;
/// A list of more items that are all short is written on one line, however long it becomes.
const LONG_LIST: usize = 16;
/// What is short.
const SHORT: usize = 64;

#[derive(Clone, Copy)]
struct Style {
    spaced: bool,
    ascii: bool,
}

impl Style {
    fn separate(self, out: &mut String, nth: usize) {
        if nth > 0 {
            out.push_str(if self.spaced { ", " } else { "," });
        }
    }
}

/// Writes a JSON string: the two characters that need it and the control characters are escaped,
/// and in ASCII style all that lies beyond.
fn write_string(out: &mut String, text: &str, ascii: bool) {
    out.push('"');
    for c in text.chars() {
        match c {
            '"' => out.push_str("\\\""),
            '\\' => out.push_str("\\\\"),
            '\n' => out.push_str("\\n"),
            '\r' => out.push_str("\\r"),
            '\t' => out.push_str("\\t"),
            _ if c < ' ' || (ascii && !(' '..='~').contains(&c)) => {
                for unit in c.encode_utf16(&mut [0; 2]) {
                    // Writing to a string does not fail.
                    let _ = write!(out, "\\u{unit:04x}");
                }
            }
            _ => out.push(c),
        }
    }
    out.push('"');
}

impl From<&Value> for Json {
    fn from(value: &Value) -> Self {
        match value {
            Value::Bool(value) => Self::Bool(*value),
            Value::Number(spelled) => Self::literal(spelled),
            Value::String(text) => Self::string(text),
            Value::EmptyList => Self::Array(Vec::new()),
            Value::EmptyMap => Self::object(),
        }
    }
}

impl From<&str> for Json {
    fn from(text: &str) -> Self {
        Self::String(text.to_owned())
    }
}

impl From<String> for Json {
    fn from(text: String) -> Self {
        Self::String(text)
    }
}

impl From<bool> for Json {
    fn from(value: bool) -> Self {
        Self::Bool(value)
    }
}

impl From<u32> for Json {
    fn from(value: u32) -> Self {
        Self::Literal(value.to_string())
    }
}

impl<T: Into<Json>> From<Option<T>> for Json {
    fn from(value: Option<T>) -> Self {
        value.map_or(Self::Null, Into::into)
    }
}

impl<T: Into<Json>> FromIterator<T> for Json {
    fn from_iter<I: IntoIterator<Item = T>>(items: I) -> Self {
        Self::Array(items.into_iter().map(Into::into).collect())
    }
}

/// Builds a [`Json::Object`] from `name => value` pairs, in their order.
macro_rules! object {
    ($($name:expr => $value:expr),* $(,)?) => {
        $crate::json::Json::Object(vec![$(($name.to_owned(), $crate::json::Json::from($value))),*])
    };
}
pub(crate) use object;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_frame_text_keeps_the_spelling_the_order_and_the_repetition_of_its_members() {
        let frame = object! { "kind" => "x", "t" => Json::literal("5e0") }.and("t", Json::Null);
        assert_eq!(frame.text(), r#"{"kind":"x","t":5e0,"t":null}"#);
    }

    #[test]
    fn a_frame_text_escapes_only_what_json_demands() {
        let frame = Json::string("a\"\\\u{1}\u{7f}é\u{1f600}");
        assert_eq!(frame.text(), "\"a\\\"\\\\\\u0001\u{7f}é\u{1f600}\"");
    }

    #[test]
    fn a_file_is_ascii_whatever_the_characters() {
        let pretty = Json::string("é\u{1f600}\u{7f}").pretty();
        assert_eq!(pretty, "\"\\u00e9\\ud83d\\ude00\\u007f\"\n");
    }

    #[test]
    fn a_long_list_stands_on_one_line_only_if_its_items_are_short() {
        let numbers: Json = (0..1000_u32).collect();
        assert_eq!(numbers.pretty().lines().count(), 1);
        let texts: Json = (0..100).map(|_| "x".repeat(100)).collect();
        assert_eq!(texts.pretty().lines().count(), 102);
    }

    #[test]
    fn short_members_share_a_line_as_far_as_it_goes_and_long_ones_have_their_own() {
        let long = "x".repeat(LINE);
        let few = object! { "a" => 1, "b" => true, "long" => long.as_str(), "c" => 3, "d" => "e" };
        let lines: Vec<_> = few.pretty().lines().map(str::to_owned).collect();
        let own = format!(r#" "long": "{long}","#);
        assert_eq!(lines, ["{", r#" "a": 1, "b": true,"#, &own, r#" "c": 3, "d": "e""#, "}"]);
        let many =
            (0..16).fold(Json::object(), |all, nth| all.with(&format!("{nth:010}"), Json::string("y".repeat(12))));
        let lines: Vec<_> = many.pretty().lines().map(str::len).collect();
        assert!(lines.len() < 8 && lines.iter().all(|length| *length <= LINE), "{lines:?}");
    }

    #[test]
    fn an_edit_reaches_into_members_and_items() {
        let frame = object! { "a" => Json::Array(vec![Json::Null, object! { "b" => true }]) };
        let edited = frame.edit(&["a", "1", "b"], |_| Json::literal("7"));
        assert_eq!(edited.text(), r#"{"a":[null,{"b":7}]}"#);
    }
}
