//! What the text leaves open of a frame as it arrives.

use ncp_text::WIRE_VERSION;
use ncp_text::tables::{Message, Shape, tables};

use crate::json::{Json, JsonFault};

/// What a receiver may do with a frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Freedom {
    /// What the rules say.
    None,
    /// It may reject the frame as well.
    MayReject,
    /// It may reject the frame as well, for what stands in a member that nobody reads, by this.
    MayRejectFor(&'static str),
    /// Whatever it wants, by this.
    Open(&'static str),
}

/// The freedom that a receiver has with a frame of a kind.
pub(super) fn freedom(kind: &str, frame: &[u8], strict: bool) -> Freedom {
    let Ok(text) = std::str::from_utf8(frame) else { return Freedom::None };
    if text.starts_with('\u{feff}') {
        return Freedom::Open("a byte order mark, WIRE-006");
    }
    let json = match Json::parse(text) {
        Ok(json) => json,
        Err(error) if error.what == JsonFault::Surrogate => return Freedom::Open("half a surrogate, WIRE-008"),
        // Behind a repeated member there may be more to say, and each of it rejects.
        Err(_) => return Freedom::None,
    };
    let message = tables().kind(kind);
    if let Some(why) = message.and_then(|message| within(message, &json)) {
        return Freedom::MayRejectFor(why);
    }
    // Where it is not required, a session id is any string.
    let is_segment = !matches!(kind, "error" | "link_status");
    let id = json.get("session_id").and_then(Json::as_str).filter(|_| is_segment).unwrap_or_default();
    if id.chars().any(|c| ('\u{80}'..='\u{9f}').contains(&c)) {
        return Freedom::Open("a control character of U+0080 to U+009F, KEY-016");
    }
    let version = json.get("ncp_version").and_then(Json::as_str);
    if let Some(nested) = json.get("stimulus").and_then(|stimulus| stimulus.get("ncp_version")).and_then(Json::as_str) {
        let own = version.unwrap_or(WIRE_VERSION);
        if nested != own && (!strict || plain_version(nested) == plain_version(own)) {
            return Freedom::Open("a stimulus of another version, WIRE-038");
        }
    }
    match version {
        None => Freedom::None,
        Some(version) if version == WIRE_VERSION => Freedom::None,
        Some(version) if is_advice(version) => Freedom::Open("a version with leading zeros or a large part, VER-009"),
        Some(version) if !strict && ncp_spec::version::check_version(version, false) != Ok(true) => Freedom::MayReject,
        Some(_) => Freedom::None,
    }
}

/// Whether a version is one that only advice tells how to read.
pub(super) fn is_advice(version: &str) -> bool {
    let digits = |part: &str| part.bytes().all(|byte| byte.is_ascii_digit()) && !part.is_empty();
    let parts: Vec<&str> = version.split('.').collect();
    parts.len() <= 2
        && parts.iter().all(|part| digits(part))
        && parts.iter().any(|part| part.parse::<u16>().is_err() || part.len() > 1 && part.starts_with('0'))
}

fn plain_version(version: &str) -> String {
    version.split('.').map(|part| part.trim_start_matches('0')).collect::<Vec<_>>().join(".")
}

/// What is open in the members that nobody reads.
fn within(message: &Message, json: &Json<'_>) -> Option<&'static str> {
    let Json::Object(members) = json else { return None };
    members.iter().find_map(|(name, value)| match message.field(name) {
        None => ignored(value),
        Some(field) => of_shape(&field.shape, value),
    })
}

fn of_shape(shape: &Shape, value: &Json<'_>) -> Option<&'static str> {
    match (shape, value) {
        (Shape::Message(name), _) => tables().message(name).and_then(|message| within(message, value)),
        (Shape::List(item), Json::Array(items)) => items.iter().find_map(|value| of_shape(item, value)),
        (Shape::Map(entry), Json::Object(members)) => members.iter().find_map(|(_, value)| of_shape(entry, value)),
        _ => None,
    }
}

fn ignored(value: &Json<'_>) -> Option<&'static str> {
    match value {
        Json::Number(spelling) if spelling.parse().is_ok_and(f64::is_infinite) => {
            Some("a number beyond a double that nobody reads, WIRE-014")
        }
        Json::Array(items) if items.len() > 4096 => Some("an array of many items that nobody reads, WIRE-071"),
        Json::Object(members) if members.len() > 4096 => Some("an object of many members that nobody reads, WIRE-071"),
        Json::Array(items) => items.iter().find_map(ignored),
        Json::Object(members) => members.iter().find_map(|(_, value)| ignored(value)),
        _ => None,
    }
}

/// Whether bytes are one JSON object by the grammar, whatever repeats in it and however deep it is.
pub(super) fn is_object(bytes: &[u8]) -> bool {
    let Ok(text) = std::str::from_utf8(bytes) else { return false };
    let mut reader = Grammar { rest: text.as_bytes() };
    reader.space();
    reader.rest.first() == Some(&b'{') && reader.values().is_some() && reader.rest.is_empty()
}

/// A reader that keeps nothing.
struct Grammar<'t> {
    rest: &'t [u8],
}

impl Grammar<'_> {
    fn space(&mut self) {
        while let [b' ' | b'\t' | b'\n' | b'\r', rest @ ..] = self.rest {
            self.rest = rest;
        }
    }

    fn take(&mut self, wanted: u8) -> Option<()> {
        let (first, rest) = self.rest.split_first()?;
        (*first == wanted).then(|| self.rest = rest)
    }

    /// One value and the white space around it, without recursion.
    fn values(&mut self) -> Option<()> {
        let mut open: Vec<u8> = Vec::new();
        loop {
            self.space();
            match self.rest.first()? {
                b'{' => {
                    self.take(b'{')?;
                    self.space();
                    if self.rest.first() == Some(&b'}') {
                        self.take(b'}')?;
                    } else {
                        self.name()?;
                        open.push(b'}');
                        continue;
                    }
                }
                b'[' => {
                    self.take(b'[')?;
                    self.space();
                    if self.rest.first() == Some(&b']') {
                        self.take(b']')?;
                    } else {
                        open.push(b']');
                        continue;
                    }
                }
                b'"' => self.string()?,
                _ => self.word()?,
            }
            loop {
                self.space();
                let Some(close) = open.last().copied() else { return Some(()) };
                if self.rest.first() == Some(&b',') {
                    self.take(b',')?;
                    if close == b'}' {
                        self.space();
                        self.name()?;
                    }
                    break;
                }
                self.take(close)?;
                open.pop();
            }
        }
    }

    fn name(&mut self) -> Option<()> {
        self.string()?;
        self.space();
        self.take(b':')
    }

    fn string(&mut self) -> Option<()> {
        self.take(b'"')?;
        loop {
            let (first, rest) = self.rest.split_first()?;
            self.rest = rest;
            match first {
                b'"' => return Some(()),
                0..=0x1f => return None,
                b'\\' => {
                    let (escape, rest) = self.rest.split_first()?;
                    self.rest = rest;
                    match escape {
                        b'u' => {
                            let digits = self.rest.get(..4)?;
                            digits.iter().all(u8::is_ascii_hexdigit).then(|| self.rest = &self.rest[4..])?;
                        }
                        b'"' | b'\\' | b'/' | b'b' | b'f' | b'n' | b'r' | b't' => {}
                        _ => return None,
                    }
                }
                _ => {}
            }
        }
    }

    /// A number or a literal, which the suite's own reader knows.
    fn word(&mut self) -> Option<()> {
        let is_part = |byte: &u8| byte.is_ascii_alphanumeric() || matches!(byte, b'+' | b'-' | b'.');
        let length = self.rest.iter().take_while(|byte| is_part(byte)).count();
        let word = std::str::from_utf8(self.rest.get(..length)?).ok()?;
        Json::parse(word).ok()?;
        self.rest = &self.rest[length..];
        Some(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_version_with_a_part_beyond_65535_or_with_leading_zeros_is_advice() {
        for advice in ["0.65536", "65536", "0.00", "00.5", "0.99999999999999999999"] {
            assert!(is_advice(advice), "{advice}");
        }
        for binding in ["0.65535", "65535.0", "0", "0.5", "0.5.1", "0.", "0.x", ""] {
            assert!(!is_advice(binding), "{binding}");
        }
    }

    #[test]
    fn an_object_is_told_by_its_grammar_alone() {
        for good in ["{}", r#" {"a":1,"a":[{"b":"\ud800"}],"c":{"d":null}} "#, r#"{"a":[],"b":{},"c":-1e400}"#] {
            assert!(is_object(good.as_bytes()), "{good}");
        }
        let deep = format!("{{\"a\":{}{}}}", "[".repeat(5000), "]".repeat(5000));
        assert!(is_object(deep.as_bytes()));
        for bad in ["", "[]", "{", r#"{"a":1}x"#, r#"{"a":01}"#, r#"{"a" 1}"#, r#"{"a":1,}"#, "{\"a\":\"\u{1}\"}"] {
            assert!(!is_object(bad.as_bytes()), "{bad}");
        }
        assert!(!is_object(b"{\"a\":\"\xff\"}"));
    }

    #[test]
    fn what_the_text_advises_is_open_and_what_it_demands_is_not() {
        let of = |frame: &str| freedom("command_frame", frame.as_bytes(), false);
        assert_eq!(of(r#"{"kind":"command_frame","seq":1}"#), Freedom::None);
        assert_eq!(of(r#"{"kind":"command_frame","ncp_version":"0.4"}"#), Freedom::MayReject);
        for open in [
            "\u{feff}{\"kind\":\"command_frame\"}",
            r#"{"kind":"command_frame","x":"\ud800"}"#,
            r#"{"kind":"command_frame","ncp_version":"0.05"}"#,
        ] {
            assert!(matches!(of(open), Freedom::Open(_)), "{open}");
        }
        for ignored in
            [r#"{"kind":"command_frame","x":[1e400]}"#, r#"{"kind":"command_frame","channels":{"a":{"x":1e400}}}"#]
        {
            assert!(matches!(of(ignored), Freedom::MayRejectFor(_)), "{ignored}");
        }
        assert_eq!(of(r#"{"kind":"command_frame","t":1e400}"#), Freedom::None);
        for (kind, is_open) in [("error", false), ("link_status", false), ("close_session", true)] {
            let frame = format!("{{\"kind\":\"{kind}\",\"session_id\":\"\u{85}\"}}");
            assert_eq!(matches!(freedom(kind, frame.as_bytes(), false), Freedom::Open(_)), is_open, "{kind}");
        }
    }
}
