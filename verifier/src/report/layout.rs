//! Text for a terminal: colours and line breaks.

/// Which colours to write.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Style {
    /// Whether to write any.
    pub colour: bool,
    /// How many characters fit on a line.
    pub width: usize,
}

impl Style {
    /// Emphasis.
    #[must_use]
    pub fn bold(self, text: &str) -> String {
        self.paint("1", text)
    }

    /// Background.
    #[must_use]
    pub fn dim(self, text: &str) -> String {
        self.paint("2", text)
    }

    /// Good.
    #[must_use]
    pub fn green(self, text: &str) -> String {
        self.paint("32", text)
    }

    /// Bad.
    #[must_use]
    pub fn red(self, text: &str) -> String {
        self.paint("1;31", text)
    }

    /// Worth a look.
    #[must_use]
    pub fn yellow(self, text: &str) -> String {
        self.paint("33", text)
    }

    fn paint(self, code: &str, text: &str) -> String {
        if self.colour { format!("\x1b[{code}m{text}\x1b[0m") } else { text.to_owned() }
    }
}

/// Breaks a text into lines of at most `width` characters, the first after `first`, the others after `rest`. A word
/// that is longer than a line is broken.
#[must_use]
pub fn wrap(text: &str, width: usize, first: &str, rest: &str) -> String {
    let mut lines = vec![first.to_owned()];
    let mut empty = true;
    for word in text.split_whitespace() {
        let mut word = word;
        loop {
            let line = lines.last_mut();
            let Some(line) = line else { break };
            let room = width.saturating_sub(line.chars().count() + usize::from(!empty));
            let length = word.chars().count();
            if length <= room {
                if !empty {
                    line.push(' ');
                }
                line.push_str(word);
                empty = false;
                break;
            }
            if !empty {
                lines.push(rest.to_owned());
                empty = true;
                continue;
            }
            // Too long for any line; at least one character goes on each, so that this ends.
            let cut = word.char_indices().nth(room.max(1)).map_or(word.len(), |(at, _)| at);
            line.push_str(&word[..cut]);
            word = &word[cut..];
            if word.is_empty() {
                empty = false;
                break;
            }
            lines.push(rest.to_owned());
        }
    }
    lines.join("\n")
}

/// The beginning of a text, whole words of it as far as they fit into `width` characters, and `…` if that is not all.
#[must_use]
pub(super) fn cut(text: &str, width: usize) -> String {
    if text.chars().count() <= width {
        return text.to_owned();
    }
    let most: String = text.chars().take(width.saturating_sub(1)).collect();
    let whole = most.rfind(' ').filter(|at| 2 * at > most.len()).map_or(most.as_str(), |at| &most[..at]);
    format!("{}…", whole.trim_end())
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_text_is_broken_between_words_and_a_long_word_within() {
        assert_eq!(wrap("one two three", 9, "* ", "  "), "* one two\n  three");
        assert_eq!(wrap("a bcdefghij k", 5, "", " "), "a\n bcde\n fghi\n j k");
        assert_eq!(wrap("", 5, "- ", "  "), "- ");
        assert_eq!(wrap("ab", 0, "", ""), "a\nb");
    }

    #[test]
    fn a_text_is_cut_after_a_whole_word_unless_that_leaves_little() {
        assert_eq!(cut("one two three", 13), "one two three");
        assert_eq!(cut("one two three", 12), "one two…");
        assert_eq!(cut("onetwothreefour", 6), "onetw…");
        assert_eq!((cut("ab", 1), cut("", 0)), ("…".to_owned(), String::new()));
    }

    #[test]
    fn colours_are_written_only_when_asked_for() {
        assert_eq!(Style { colour: false, width: 80 }.red("x"), "x");
        assert_eq!(Style { colour: true, width: 80 }.red("x"), "\x1b[1;31mx\x1b[0m");
    }

    proptest! {
        #[test]
        fn no_line_is_too_long_and_no_character_is_lost(text in "[a-zäß ]{0,80}", width in 4_usize..30) {
            let wrapped = wrap(&text, width, "- ", "  ");
            prop_assert!(wrapped.lines().all(|line| line.chars().count() <= width));
            let letters = |t: &str| t.chars().filter(|c| c.is_alphabetic()).collect::<String>();
            prop_assert_eq!(letters(&wrapped), letters(&text));
            prop_assert!(cut(&text, width).chars().count() <= width);
        }
    }
}
