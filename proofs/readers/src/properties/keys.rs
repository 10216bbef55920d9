//! Segments, realms and keys: the builders accept exactly the grammar of 3.3, and change nothing.

use ncp_proofs::prover::Prover;
use serde_json::{Value, json};

use super::strings::{self, Alphabet, WHITE_SPACE, class};
use crate::readers::{Key, Readers};

/// What the text tells apart, and beyond that DEL from other control characters, and characters by their
/// length in UTF-8.
pub const CLASSES: Alphabet = &[
    class(1, &['a', 'A', '0', '-', '_', '~', '"', '\\', '%'], |c| matches!(c, '!'..='~') && !"/*$#?@.".contains(c)),
    class(1, &['.'], |c| c == '.'),
    class(1, &['@'], |c| c == '@'),
    class(1, &['/'], |c| c == '/'),
    class(1, &['*', '$', '#', '?'], |c| "*$#?".contains(c)),
    WHITE_SPACE,
    class(1, &['\0', '\u{1f}', '\u{8}', '\u{e}', '\u{1b}'], |c| c < ' '),
    class(1, &['\u{7f}'], |c| c == '\u{7f}'),
    class(2, &['\u{80}', '\u{9f}', '\u{85}'], |c| matches!(c, '\u{80}'..='\u{9f}')),
    class(2, &['\u{e9}', '\u{a0}', '\u{ad}', '\u{7ff}'], |c| c.len_utf8() == 2),
    class(3, &['\u{4e2d}', '\u{2028}', '\u{feff}', '\u{202e}', '\u{ffff}', '\u{ff20}'], |c| c.len_utf8() == 3),
    class(4, &['\u{1f600}', '\u{10ffff}'], |c| c.len_utf8() == 4),
];

/// What stands beside a character of any kind.
const CONTEXTS: &[&str] = &["", "a", ".", "@", "/"];
const KEYS: [(Key, &str); 8] = [
    (Key::Rpc, "rpc"),
    (Key::Sensor, "sensor"),
    (Key::Command, "command"),
    (Key::Observation, "observation"),
    (Key::SensorGlob, "sensor_glob"),
    (Key::CommandGlob, "command_glob"),
    (Key::SessionGlob, "session_glob"),
    (Key::FleetGlob, "fleet_glob"),
];
/// The longest segments with which every key is built.
const SHORT: usize = 3;

/// All strings of few bytes, as segment and as realm: accepted exactly by the grammar, and alike for
/// characters of the same classes.
pub fn bytes<R: Readers, P: Prover>(p: &mut P) {
    if let Some(text) = strings::any_bytes(p) {
        holds::<R, P>(p, &text);
    }
}

/// Every character of Unicode, in contexts.
pub fn scalars<R: Readers, P: Prover>(p: &mut P) {
    if let Some(text) = strings::any_scalar(p, CONTEXTS) {
        holds::<R, P>(p, &text);
    }
}

/// All strings of classes as a session id: accepted exactly by the grammar, and in the key unchanged.
pub fn segment<R: Readers, P: Prover>(p: &mut P) {
    let text = strings::of_classes(p, CLASSES);
    segment_by_the_grammar::<R, P>(p, &text);
    builds::<R, P>(p, &Parts::of_session(text));
}

/// All strings of classes as a realm.
pub fn realm<R: Readers, P: Prover>(p: &mut P) {
    let text = strings::of_classes(p, CLASSES);
    realm_by_the_grammar::<R, P>(p, &text);
    builds::<R, P>(p, &Parts::of_realm(text));
}

/// Short strings in every place of every key.
pub fn builders<R: Readers, P: Prover>(p: &mut P) {
    let parts = parts(p);
    builds::<R, P>(p, &parts);
}

/// The case that a harness's inputs are, as a vector.
pub(super) fn vector<P: Prover>(property: &str, p: &mut P) -> Option<Value> {
    let parts = match property {
        "keys/bytes" => Parts::of_session(strings::any_bytes(p)?),
        "keys/scalars" => Parts::of_session(strings::any_scalar(p, CONTEXTS)?),
        "keys/segment" => Parts::of_session(strings::of_classes(p, CLASSES)),
        "keys/realm" => Parts::of_realm(strings::of_classes(p, CLASSES)),
        _ => parts(p),
    };
    let (key, name) = KEYS.get(parts.key).copied()?;
    let mut args = json!({ "key": name, "realm": parts.realm });
    if !matches!(key, Key::Rpc | Key::FleetGlob) {
        args["session"] = json!(parts.session);
    }
    if matches!(key, Key::Sensor | Key::Command) {
        args["name"] = json!(parts.name);
    }
    Some(json!({
        "roles": match key {
            Key::Rpc => json!(["commander", "server"]),
            Key::Sensor | Key::Command => json!(["commander", "body", "observer"]),
            Key::Observation => json!(["server", "observer"]),
            _ => json!(["observer"]),
        },
        "call": "key.build",
        "args": args,
        "expect": match key_of(&parts) {
            None => json!({ "reject": "key" }),
            Some(key) => json!({ "relation": "json", "value": { "key": key } }),
        },
    }))
}

/// What a key is built from; the key by its place in the table.
struct Parts {
    key: usize,
    realm: Option<String>,
    session: String,
    name: Option<String>,
}

impl Parts {
    /// A key of a session, with its id alone.
    const fn of_session(session: String) -> Self {
        Self { key: 1, realm: None, session, name: None }
    }

    /// A key of a realm alone.
    fn of_realm(realm: String) -> Self {
        Self { key: 0, realm: Some(realm), session: "s".to_owned(), name: None }
    }
}

fn parts<P: Prover>(p: &mut P) -> Parts {
    let key = p.choice("key", KEYS.len());
    let place = p.choice("place", 3);
    let most = p.length(SHORT);
    let text = strings::of_classes_within(p, CLASSES, most);
    let plain = Parts { key, realm: None, session: "s".to_owned(), name: None };
    match place {
        0 => Parts { realm: Some(text), ..plain },
        1 => Parts { session: text, name: Some("n".to_owned()), ..plain },
        _ => Parts { realm: Some("r/q".to_owned()), name: Some(text), ..plain },
    }
}

fn builds<R: Readers, P: Prover>(p: &mut P, parts: &Parts) {
    let key = KEYS.get(parts.key).map_or(Key::Rpc, |(key, _)| *key);
    let answer = R::key(key, parts.realm.as_deref(), &parts.session, parts.name.as_deref());
    let same = p.truth(answer == key_of(parts));
    p.check("the key of the table, or an error", same);
}

/// The grammar, and that the classes lose nothing.
fn holds<R: Readers, P: Prover>(p: &mut P, text: &str) {
    segment_by_the_grammar::<R, P>(p, text);
    realm_by_the_grammar::<R, P>(p, text);
    strings::answers_alike(p, text, CLASSES, |text| (R::segment(text), R::realm(text)));
}

fn segment_by_the_grammar<R: Readers, P: Prover>(p: &mut P, text: &str) {
    let says = p.truth(is_segment(text));
    p.exactly("a segment by the grammar", R::segment(text), says);
}

fn realm_by_the_grammar<R: Readers, P: Prover>(p: &mut P, text: &str) {
    let says = p.truth(is_realm(text));
    p.exactly("a realm by the grammar", R::realm(text), says);
}

/// The table of 3.2. `[NCP-KEY-001]` to `[NCP-KEY-007]`
fn key_of(parts: &Parts) -> Option<String> {
    let realm = parts.realm.as_deref().unwrap_or("ncp");
    if !is_realm(realm) {
        return None;
    }
    let (key, _) = KEYS.get(parts.key)?;
    let id = &parts.session;
    if !matches!(key, Key::Rpc | Key::FleetGlob) && !is_segment(id) {
        return None;
    }
    let tail = match (key, &parts.name) {
        (Key::Sensor | Key::Command, Some(name)) if !is_segment(name) => return None,
        (Key::Sensor | Key::Command, Some(name)) => format!("/{name}"),
        _ => String::new(),
    };
    Some(match key {
        Key::Rpc => [realm, "/rpc"].concat(),
        Key::Sensor => [realm, "/session/", id, "/sensor", &tail].concat(),
        Key::Command => [realm, "/session/", id, "/command", &tail].concat(),
        Key::Observation => [realm, "/session/", id, "/observation"].concat(),
        Key::SensorGlob => [realm, "/session/", id, "/sensor/**"].concat(),
        Key::CommandGlob => [realm, "/session/", id, "/command/**"].concat(),
        Key::SessionGlob => [realm, "/session/", id, "/**"].concat(),
        Key::FleetGlob => [realm, "/session/**"].concat(),
    })
}

/// Where the automaton of 3.3 is, byte by byte of UTF-8.
#[derive(Clone, Copy, PartialEq, Eq)]
enum State {
    /// Before the first byte of a segment.
    Start,
    /// Behind a first dot.
    Dot,
    /// Behind two dots.
    Dots,
    /// Within a segment that is good as it stands.
    Good,
    /// Behind the byte that leads U+0080 to U+00BF.
    Lead,
    /// Within what is no segment.
    Bad,
}

impl State {
    fn next(self, byte: u8) -> Self {
        match (self, byte) {
            (Self::Bad, _) => Self::Bad,
            // C2 80 to C2 9F are the control characters of U+0080 to U+009F.
            (Self::Lead, 0x80..=0x9f) => Self::Bad,
            (_, 0xc2) => Self::Lead,
            // Controls, white space, and what key expressions reserve.
            (_, 0x00..=0x20 | 0x7f | b'/' | b'*' | b'$' | b'#' | b'?') => Self::Bad,
            (Self::Start, b'@') => Self::Bad,
            (Self::Start, b'.') => Self::Dot,
            (Self::Dot, b'.') => Self::Dots,
            _ => Self::Good,
        }
    }

    /// Whether a segment may end here.
    fn is_good(self) -> bool {
        self == Self::Good
    }
}

fn is_segment(text: &str) -> bool {
    text.bytes().fold(State::Start, State::next).is_good()
}

fn is_realm(text: &str) -> bool {
    let end = text.bytes().fold(State::Start, |state, byte| match (state, byte) {
        (State::Good, b'/') => State::Start,
        _ => state.next(byte),
    });
    end.is_good()
}
