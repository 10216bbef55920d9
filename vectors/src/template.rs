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
    /// Texts one after the other.
    Concat(Vec<Text>),
    /// The base64 of the text's UTF-8 bytes.
    Base64(Box<Text>),
}

impl Text {
    /// Texts one after the other.
    pub(crate) fn concat<const N: usize>(parts: [Text; N]) -> Self {
        Self::Concat(parts.into())
    }

    /// A text so many times.
    pub(crate) fn repeat(text: impl Into<String>, times: usize) -> Self {
        Self::Repeat(text.into(), times)
    }

    /// The base64 of bytes, written out.
    pub(crate) fn base64_of(bytes: &[u8]) -> Self {
        Self::Plain(STANDARD.encode(bytes))
    }

    /// As the vector file writes it.
    pub(crate) fn json(&self) -> Json {
        match self {
            Self::Plain(text) => Json::string(text),
            Self::Repeat(text, times) => {
                object! { "$repeat" => text.as_str(), "times" => Json::literal(times.to_string()) }
            }
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
