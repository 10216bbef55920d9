//! Texts that a vector file states by how they are made, so that a 64 MiB frame takes a line.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;

use crate::json::{Json, object};

/// A text of `args` or `expect`, written out or as a template that the runner expands.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Text {
    /// The text itself.
    Plain(String),
    /// A text so many times.
    Repeat(String, usize),
    /// The numbers from 0, so many, each between these two.
    Count(String, String, usize),
    /// Texts one after the other.
    Concat(Vec<Text>),
    /// The base64 of the text's UTF-8 bytes.
    Base64(Box<Text>),
}

impl Text {
    /// Texts one after the other.
    pub(crate) fn concat(parts: impl Into<Vec<Text>>) -> Self {
        Self::Concat(parts.into())
    }

    /// A text so many times.
    pub(crate) fn repeat(text: impl Into<String>, times: usize) -> Self {
        Self::Repeat(text.into(), times)
    }

    /// The numbers from 0, so many, each between these two.
    pub(crate) fn count(before: &str, after: &str, times: usize) -> Self {
        Self::Count(before.to_owned(), after.to_owned(), times)
    }

    /// The base64 of bytes, written out but for the first long run of zeros.
    pub(crate) fn base64_of(bytes: &[u8]) -> Self {
        const LONG: usize = 600;
        let text = STANDARD.encode(bytes);
        let Some(begins) = text.find(&"A".repeat(LONG)) else { return Self::Plain(text) };
        let (before, rest) = text.split_at(begins);
        let behind = rest.trim_start_matches('A');
        Self::concat([before.into(), Self::repeat("A", rest.len() - behind.len()), behind.into()])
    }

    /// What the runner makes of it.
    #[cfg(test)]
    pub(crate) fn expanded(&self) -> String {
        match self {
            Self::Plain(text) => text.clone(),
            Self::Repeat(text, times) => text.repeat(*times),
            Self::Count(before, after, times) => (0..*times).map(|nth| format!("{before}{nth}{after}")).collect(),
            Self::Concat(parts) => parts.iter().map(Self::expanded).collect(),
            Self::Base64(text) => STANDARD.encode(text.expanded()),
        }
    }

    /// As the vector file writes it.
    pub(crate) fn json(&self) -> Json {
        match self {
            Self::Plain(text) => Json::string(text),
            Self::Repeat(text, times) => {
                object! { "$repeat" => text.as_str(), "times" => Json::literal(times.to_string()) }
            }
            Self::Count(before, after, times) => object! {
                "$count" => [before, after].into_iter().map(Json::string).collect::<Json>(),
                "times" => Json::literal(times.to_string()),
            },
            Self::Concat(parts) => {
                object! { "$concat" => parts.iter().map(Self::json).collect::<Json>() }
            }
            Self::Base64(text) => object! { "$base64" => text.json() },
        }
    }
}

impl From<&str> for Text {
    fn from(text: &str) -> Self {
        Self::Plain(text.to_owned())
    }
}

impl From<String> for Text {
    fn from(text: String) -> Self {
        Self::Plain(text)
    }
}

impl From<Text> for Json {
    fn from(text: Text) -> Self {
        text.json()
    }
}
