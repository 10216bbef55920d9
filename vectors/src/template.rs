//! Texts that a vector file states by how they are made, so that a 64 MiB frame takes a line.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;

use crate::json::{Json, object};

/// How many bytes of one character are a long run.
const LONG: usize = 600;

/// How many letters of base64 three entries of a directory take.
const ENTRIES: usize = 64;

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

    /// The base64 of bytes, written out but for the first long run of zeros, or of three equal directory entries.
    pub(crate) fn base64_of(bytes: &[u8]) -> Self {
        let text = STANDARD.encode(bytes);
        let run = |part: &str| {
            let begins = text.find(&part.repeat(LONG / part.len()))?;
            let (before, rest) = text.split_at(begins);
            let behind = rest.trim_start_matches(part);
            let times = (rest.len() - behind.len()) / part.len();
            Some(Self::concat([before.into(), Self::repeat(part, times), behind.into()]))
        };
        run("A").or_else(|| run(text.get(ENTRIES..2 * ENTRIES)?)).unwrap_or(Self::Plain(text))
    }

    /// A text, written out but for each long run of one character.
    pub(crate) fn folded(text: &str) -> Self {
        let (mut parts, mut plain, mut rest) = (Vec::new(), String::new(), text);
        while let Some(first) = rest.chars().next() {
            let behind = rest.trim_start_matches(first);
            let run = &rest[..rest.len() - behind.len()];
            if run.len() >= LONG {
                parts.push(Self::Plain(std::mem::take(&mut plain)));
                parts.push(Self::repeat(first, run.len() / first.len_utf8()));
            } else {
                plain.push_str(run);
            }
            rest = behind;
        }
        if parts.is_empty() {
            return Self::Plain(plain);
        }
        parts.push(Self::Plain(plain));
        parts.retain(|part| *part != Self::Plain(String::new()));
        Self::Concat(parts)
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_of_equal_entries_are_folded_and_stay_the_same() {
        let mut bytes = b"NCPB\x01\x00\x00\x10\x0b\x00\x01\x00".to_vec();
        bytes.extend((0..400).flat_map(|_| [0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0]));
        bytes.extend([7, 8, 9]);
        let folded = Text::base64_of(&bytes);
        assert_eq!(folded.expanded(), STANDARD.encode(&bytes));
        let Text::Concat(parts) = folded else { panic!("the entries are folded") };
        assert!(matches!(&parts[1], Text::Repeat(part, 130..) if part.len() == ENTRIES), "{parts:?}");
    }

    #[test]
    fn long_runs_are_folded_and_the_text_stays_the_same() {
        let long = format!("0.{}1{}\u{e9}", "0".repeat(700), "\u{e9}".repeat(400));
        let folded = Text::folded(&long);
        assert_eq!(folded.expanded(), long);
        let Text::Concat(parts) = folded else { panic!("{long} is folded") };
        assert_eq!(parts[..2], [Text::from("0."), Text::repeat("0", 700)]);
        let short = format!("0.{}", "0".repeat(599));
        assert_eq!(Text::folded(&short), Text::Plain(short));
    }
}
