//! Which cases are meant.

use ncp_text::catalogue::{Level, Role};

use super::case::Case;

/// A pattern of `--filter`: a piece of text, or with `*` and `?` a whole one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Pattern(String);

/// Which cases are meant. Every part that is set has to hold.
#[derive(Debug, Clone, Default)]
pub struct Selection {
    /// One of these patterns fits, unless there is none.
    pub patterns: Vec<Pattern>,
    /// One of these roles needs the case, unless there is none.
    pub roles: Vec<Role>,
    /// The case is at this level or below.
    pub level: Option<Level>,
}

impl Pattern {
    /// Takes a pattern as it was typed. Letters fit in either case.
    #[must_use]
    pub fn new(pattern: &str) -> Self {
        Self(pattern.to_ascii_lowercase())
    }

    /// The pattern, in lower case.
    #[must_use]
    pub fn as_str(&self) -> &str {
        &self.0
    }

    /// Whether it fits the case's id, one of its rules' ids, one of its flags, or its call.
    #[must_use]
    pub fn fits(&self, case: &Case) -> bool {
        self.fits_text(&case.id)
            || self.fits_text(case.call.as_str())
            || case.flags.iter().any(|flag| self.fits_text(flag))
            || case.requirements.iter().any(|rule| self.fits_text(&rule.id))
    }

    /// Whether it fits a text: a piece of it, or with `*` (any characters) and `?` (one character) all of it.
    #[must_use]
    pub fn fits_text(&self, text: &str) -> bool {
        let text = text.to_ascii_lowercase();
        if self.0.contains(['*', '?']) { glob(self.0.as_bytes(), text.as_bytes()) } else { text.contains(&self.0) }
    }
}

impl Selection {
    /// Whether a case is meant.
    #[must_use]
    pub fn meets(&self, case: &Case) -> bool {
        (self.patterns.is_empty() || self.patterns.iter().any(|pattern| pattern.fits(case)))
            && (self.roles.is_empty() || case.concerns(&self.roles))
            && self.level.is_none_or(|level| case.level <= level)
    }
}

/// Whether a pattern with `*` and `?` fits a whole text. Time is at most the product of the lengths.
fn glob(pattern: &[u8], text: &[u8]) -> bool {
    let (mut p, mut t) = (0, 0);
    // Where the last star stood, and how much of the text it has taken.
    let mut star: Option<(usize, usize)> = None;
    while t < text.len() {
        match pattern.get(p) {
            Some(b'*') => {
                star = Some((p, t));
                p += 1;
            }
            Some(b'?') => {
                p += 1;
                t += 1;
            }
            Some(byte) if *byte == text[t] => {
                p += 1;
                t += 1;
            }
            _ => match star {
                Some((at, taken)) => {
                    star = Some((at, taken + 1));
                    p = at + 1;
                    t = taken + 1;
                }
                None => return false,
            },
        }
    }
    pattern[p..].iter().all(|byte| *byte == b'*')
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_piece_fits_anywhere_and_a_glob_fits_the_whole() {
        let fits = |pattern: &str, text: &str| Pattern::new(pattern).fits_text(text);
        assert!(fits("seq", "wire/command_frame/seq/null"));
        assert!(fits("ncp-wire-01", "NCP-WIRE-012"));
        assert!(fits("wire/*/null", "wire/command_frame/seq/null"));
        assert!(fits("NCP-WIRE-01?", "NCP-WIRE-012"));
        assert!(!fits("wire/*/nul", "wire/command_frame/seq/null"));
        assert!(!fits("ire/*", "wire/command_frame"));
        assert!(!fits("bulk", "wire/command_frame"));
        assert!(fits("*", "") && fits("**", "x") && !fits("?", ""));
    }

    proptest! {
        #[test]
        fn a_star_stands_for_any_text(head in "[a-c]{0,5}", body in "[a-c]{0,5}", tail in "[a-c]{1,5}") {
            let pattern = Pattern::new(&format!("{head}*{tail}"));
            let text = format!("{head}{body}{tail}");
            prop_assert!(pattern.fits_text(&text));
            prop_assert!(!pattern.fits_text(&(text + "x")));
        }
    }
}
