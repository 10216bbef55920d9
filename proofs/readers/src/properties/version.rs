//! The version guard: it accepts exactly the grammar of 2.1, and compares by value.

use ncp_proofs::prover::Prover;
use ncp_text::WIRE_VERSION;
use serde_json::{Value, json};

use super::strings::{self, Alphabet, WHITE_SPACE, class};
use crate::readers::Readers;

/// The minor of the text's own version; its major is 0.
const MINOR: char = WIRE_VERSION.as_bytes()[2] as char;

/// The digits beside 0 and the minor.
const OTHERS: [char; 8] = {
    let digits = ['4', '6', '1', '9', '7', '3', '2', '8', '5'];
    let (mut others, mut from, mut to) = (['0'; 8], 0, 0);
    while to < others.len() {
        if digits[from] != MINOR {
            others[to] = digits[from];
            to += 1;
        }
        from += 1;
    }
    others
};

/// What the text tells apart, and beyond that what readers of numbers are known to take for digits, signs,
/// spaces or parts of a number.
pub const CLASSES: Alphabet = &[
    class(1, &['0'], |c| c == '0'),
    class(1, &[MINOR], |c| c == MINOR),
    class(1, &OTHERS, |c| c.is_ascii_digit()),
    class(1, &['.'], |c| c == '.'),
    class(1, &['+', '-'], |c| c == '+' || c == '-'),
    WHITE_SPACE,
    class(1, &['v', 'e', 'x', 'E', 'a', 'f'], |c| c.is_ascii_alphabetic()),
    class(1, &['_', ',', '\0', '/', ':', '\u{7f}'], |c| c.is_ascii()),
    class(2, &['\u{665}', '\u{b2}', '\u{a0}', '\u{80}'], |c| c.len_utf8() == 2),
    class(3, &['\u{ff15}', '\u{ff0e}', '\u{feff}', '\u{2007}'], |c| c.len_utf8() == 3),
    class(4, &['\u{1d7d3}', '\u{10ffff}'], |c| c.len_utf8() == 4),
];

/// What stands beside a character of any kind.
const CONTEXTS: &[&str] = &["", "0.", WIRE_VERSION.split_at(1).1, WIRE_VERSION];

/// All strings of few bytes: the guard accepts exactly the grammar, and answers alike for characters of the
/// same classes.
pub fn bytes<R: Readers, P: Prover>(p: &mut P) {
    if let Some(version) = strings::any_bytes(p) {
        holds::<R, P>(p, &version);
    }
}

/// Every character of Unicode, in contexts.
pub fn scalars<R: Readers, P: Prover>(p: &mut P) {
    if let Some(version) = strings::any_scalar(p, CONTEXTS) {
        holds::<R, P>(p, &version);
    }
}

/// All strings of classes.
pub fn classes<R: Readers, P: Prover>(p: &mut P) {
    let version = strings::of_classes(p, CLASSES);
    accepts_the_grammar::<R, P>(p, &version);
}

/// The case that a harness's inputs are, as a vector.
pub(super) fn vector<P: Prover>(property: &str, p: &mut P) -> Option<Value> {
    let version = match property {
        "version/bytes" => strings::any_bytes(p)?,
        "version/scalars" => strings::any_scalar(p, CONTEXTS)?,
        _ => strings::of_classes(p, CLASSES),
    };
    let verdict = guard(&version);
    // A malformed version is so strict or not; else the call that is not strict tells more.
    Some(json!({
        "roles": ["commander", "body", "server", "observer"],
        "call": "version.check",
        "args": { "version": version, "strict": false },
        "expect": match verdict {
            None => json!({ "reject": "version" }),
            Some(compatible) => json!({ "relation": "json", "value": { "compatible": compatible } }),
        },
    }))
}

fn accepts_the_grammar<R: Readers, P: Prover>(p: &mut P, version: &str) {
    let says = guard(version);
    let answer = R::version(version, false);
    let same = p.truth(answer == says);
    p.check("not strict, as the text says", same);
    let answer = R::version(version, true);
    let says = says.filter(|compatible| *compatible);
    let same = p.truth(answer == says);
    p.check("strict, as the text says", same);
}

/// The grammar, and that the classes lose nothing.
fn holds<R: Readers, P: Prover>(p: &mut P, version: &str) {
    accepts_the_grammar::<R, P>(p, version);
    strings::answers_alike(p, version, CLASSES, |version| [false, true].map(|strict| R::version(version, strict)));
}

/// The guard of 2.1 as an automaton over bytes: whether a version is compatible with the own, or none.
fn guard(version: &str) -> Option<bool> {
    #[derive(Clone, Copy)]
    enum State {
        Start,
        /// Within the major; whether it is 0 so far.
        Major(bool),
        /// Behind the dot.
        Dot(bool),
        /// Within the minor.
        Minor(bool, Minor),
    }
    #[derive(Clone, Copy, PartialEq)]
    enum Minor {
        Zero,
        Own,
        Other,
    }
    let mut state = State::Start;
    for byte in version.bytes() {
        state = match (state, byte) {
            (State::Start, b'0') => State::Major(true),
            (State::Start, b'1'..=b'9') => State::Major(false),
            (State::Major(zero), b'0') => State::Major(zero),
            (State::Major(_), b'1'..=b'9') => State::Major(false),
            (State::Major(zero), b'.') => State::Dot(zero),
            (State::Dot(zero) | State::Minor(zero, Minor::Zero), b'0') => State::Minor(zero, Minor::Zero),
            (State::Dot(zero) | State::Minor(zero, Minor::Zero), digit) if char::from(digit) == MINOR => {
                State::Minor(zero, Minor::Own)
            }
            (State::Dot(zero) | State::Minor(zero, _), b'0'..=b'9') => State::Minor(zero, Minor::Other),
            _ => return None,
        };
    }
    match state {
        State::Start | State::Dot(_) => None,
        State::Major(_) => Some(false),
        State::Minor(zero, minor) => Some(zero && minor == Minor::Own),
    }
}
