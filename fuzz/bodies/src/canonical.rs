//! The canonical text of a proto file.

use ncp_spec::contract::{canonical_text, fnv1a_64};

/// The canonical text is the one that a second canonicaliser finds; where nothing in it could begin a
/// comment or a string it is its own canonical text, and edits that must not count leave the hash.
///
/// It would find a comment sign in a string that is taken for one, an escape that is missed, a line
/// that is dropped or kept wrongly, and a panic within a character.
// [NCP-VER-020]
pub fn canonical_proto(input: &[u8]) {
    let text = String::from_utf8_lossy(input);
    let canonical = canonical_text(&text);
    assert_eq!(canonical, by_states(&text));
    assert!(canonical.split('\n').all(|line| line.trim() == line));
    if canonical.contains(['/', '"', '\'']) {
        return;
    }
    assert_eq!(canonical_text(&canonical), canonical);
    let hash = fnv1a_64(canonical.as_bytes());
    let edits = [
        canonical.replace('\n', " // \"a remark\n\n\t"),
        canonical.replace('\n', "\r\n /* several\n lines ' */ \n"),
        format!("syntax = \"proto3\";\npackage ncp.v0;\n{canonical}\n  option x = 1;\n// end"),
    ];
    for edited in edits {
        assert_eq!(fnv1a_64(canonical_text(&edited).as_bytes()), hash, "{edited:?}");
    }
}

/// Where the canonicaliser is, character by character.
#[derive(Clone, Copy)]
enum State {
    Text,
    /// After a slash that may begin a comment.
    Slash,
    Line,
    Block,
    /// After a star within a block comment.
    Star,
    Quote(char),
    Escape(char),
}

fn by_states(text: &str) -> String {
    let mut bare = String::new();
    let mut state = State::Text;
    for c in text.chars() {
        state = match (state, c) {
            (State::Slash, '/') => State::Line,
            (State::Slash, '*') => State::Block,
            (State::Text | State::Slash, _) => {
                if matches!(state, State::Slash) {
                    bare.push('/');
                }
                match c {
                    '/' => State::Slash,
                    '"' | '\'' => {
                        bare.push(c);
                        State::Quote(c)
                    }
                    _ => {
                        bare.push(c);
                        State::Text
                    }
                }
            }
            (State::Line, '\n') => {
                bare.push(c);
                State::Text
            }
            (State::Line, _) => State::Line,
            (State::Star, '/') => State::Text,
            (State::Block | State::Star, '*') => State::Star,
            (State::Block | State::Star, _) => State::Block,
            (State::Escape(quote), _) => {
                bare.push(c);
                State::Quote(quote)
            }
            (State::Quote(quote), _) => {
                bare.push(c);
                match c {
                    '\\' => State::Escape(quote),
                    _ if c == quote => State::Text,
                    _ => State::Quote(quote),
                }
            }
        };
    }
    if matches!(state, State::Slash) {
        bare.push('/');
    }
    let mut canonical: Vec<&str> = Vec::new();
    for line in bare.split('\n').map(str::trim) {
        let words = ["syntax", "package ", "import ", "option "];
        if !line.is_empty() && words.into_iter().all(|word| line.strip_prefix(word).is_none()) {
            canonical.push(line);
        }
    }
    canonical.join("\n")
}
