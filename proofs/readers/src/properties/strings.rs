//! Strings as harnesses draw them: all bytes, all characters in contexts, and strings of classes.
//!
//! What is not UTF-8 reaches neither the guard nor the key builders, whose arguments are `&str`: such bytes
//! are drawn, and left aside.

use ncp_proofs::prover::Prover;

/// Characters that a grammar does not tell apart, all of one length in UTF-8.
#[derive(Debug, Clone, Copy)]
pub struct Class {
    /// Bytes a character.
    pub width: usize,
    /// Some of them; which one stands in a string depends on its place. The first is the canonical one.
    pub members: &'static [char],
    /// Whether a character that no class before holds is one of them.
    pub holds: fn(char) -> bool,
}

/// A class, by its fields in order.
#[must_use]
pub const fn class(width: usize, members: &'static [char], holds: fn(char) -> bool) -> Class {
    Class { width, members, holds }
}

/// White space of ASCII.
pub const WHITE_SPACE: Class = class(1, &[' ', '\t', '\n', '\u{b}', '\u{c}', '\r'], |c| matches!(c, '\t'..='\r' | ' '));

/// Classes that hold every character, the narrow ones first; a character is of the first that holds it.
pub type Alphabet = &'static [Class];

/// The longest string, in bytes.
pub const LONGEST: usize = 8;

/// A string of any bytes at all, no longer than the engine explores.
pub fn any_bytes<P: Prover>(p: &mut P) -> Option<String> {
    let most = p.length(LONGEST);
    let length = p.choice("length", most + 1);
    let bytes: Vec<u8> = (0..length).map(|_| u8::try_from(p.choice("byte", 256)).unwrap_or_default()).collect();
    let text = String::from_utf8(bytes).ok();
    let is_text = p.truth(text.is_some());
    p.assume(is_text);
    text
}

/// Any character, between any two of some contexts, of which the engine explores so many behind the first.
pub fn any_scalar<P: Prover>(p: &mut P, contexts: &[&str]) -> Option<String> {
    let most = p.length(contexts.len().saturating_sub(1));
    let before = p.choice("before", most + 1);
    let after = p.choice("after", most + 1);
    let scalar = u32::try_from(p.choice("character", 0x11_0000)).ok();
    let scalar = scalar.and_then(char::from_u32);
    let is_scalar = p.truth(scalar.is_some());
    p.assume(is_scalar);
    let mut text = String::with_capacity(16);
    text.push_str(contexts.get(before)?);
    text.push(scalar?);
    text.push_str(contexts.get(after)?);
    Some(text)
}

/// A string of classes, no longer than the engine explores.
pub fn of_classes<P: Prover>(p: &mut P, alphabet: Alphabet) -> String {
    let most = p.length(LONGEST);
    of_classes_within(p, alphabet, most)
}

/// A string of classes of at most so many bytes.
pub fn of_classes_within<P: Prover>(p: &mut P, alphabet: Alphabet, most: usize) -> String {
    let length = p.choice("length", most + 1);
    let mut text = String::with_capacity(length);
    while text.len() < length {
        let rest = length - text.len();
        let fitting = alphabet.partition_point(|class| class.width <= rest);
        let class = p.choice("class", fitting);
        let members = alphabet.get(class).map_or(&['?'][..], |class| class.members);
        let nth = text.len() % members.len();
        text.push(members.get(nth).copied().unwrap_or('?'));
    }
    text
}

/// The same string with the first member of each character's class in its place.
#[must_use]
pub fn canonical(text: &str, alphabet: Alphabet) -> String {
    text.chars()
        .map(|c| {
            let class = alphabet.iter().find(|class| (class.holds)(c));
            class.and_then(|class| class.members.first()).copied().unwrap_or(c)
        })
        .collect()
}

/// Says that a reader answers a string as that of its classes' first members.
pub fn answers_alike<P: Prover, A: PartialEq>(p: &mut P, text: &str, alphabet: Alphabet, answer: impl Fn(&str) -> A) {
    let same = p.truth(answer(text) == answer(&canonical(text, alphabet)));
    p.check("answers alike within a class", same);
}
