//! Segments, realms and keys: the builders accept exactly the grammar of 3.3, and change nothing.

use ncp_proofs::prover::Prover;
use serde_json::{Value, json};

use super::strings::{self, Alphabet, Class};
use crate::readers::{Key, Readers};

/// What the text tells apart, and beyond that DEL from other control characters, and characters by their
/// length in UTF-8.
pub const CLASSES: Alphabet = &[
    Class {
        width: 1,
        members: &['a', 'A', '0', '-', '_', '~', '"', '\\', '%'],
        holds: |c| matches!(c, '!'..='~') && !"/*$#?@.".contains(c),
    },
    Class {
        width: 1,
        members: &['.'],
        holds: |c| c == '.',
    },
    Class {
        width: 1,
        members: &['@'],
        holds: |c| c == '@',
    },
    Class {
        width: 1,
        members: &['/'],
        holds: |c| c == '/',
    },
    Class {
        width: 1,
        members: &['*', '$', '#', '?'],
        holds: |c| "*$#?".contains(c),
    },
    Class {
        width: 1,
        members: &[' ', '\t', '\n', '\u{b}', '\u{c}', '\r'],
        holds: |c| matches!(c, '\t'..='\r' | ' '),
    },
    Class {
        width: 1,
        members: &['\0', '\u{1f}', '\u{8}', '\u{e}', '\u{1b}'],
        holds: |c| c < ' ',
    },
    Class {
        width: 1,
        members: &['\u{7f}'],
        holds: |c| c == '\u{7f}',
    },
    Class {
        width: 2,
        members: &['\u{80}', '\u{9f}', '\u{85}'],
        holds: |c| matches!(c, '\u{80}'..='\u{9f}'),
    },
    Class {
        width: 2,
        members: &['\u{e9}', '\u{a0}', '\u{ad}', '\u{7ff}'],
        holds: |c| c.len_utf8() == 2,
    },
    Class {
        width: 3,
        members: &[
            '\u{4e2d}', '\u{2028}', '\u{feff}', '\u{202e}', '\u{ffff}', '\u{ff20}',
        ],
        holds: |c| c.len_utf8() == 3,
    },
    Class {
        width: 4,
        members: &['\u{1f600}', '\u{10ffff}'],
        holds: |c| c.len_utf8() == 4,
    },
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
        accepts_the_grammar::<R, P>(p, &text);
        answers_alike::<R, P>(p, &text);
    }
}

/// Every character of Unicode, in contexts.
pub fn scalars<R: Readers, P: Prover>(p: &mut P) {
    if let Some(text) = strings::any_scalar(p, CONTEXTS) {
        accepts_the_grammar::<R, P>(p, &text);
        answers_alike::<R, P>(p, &text);
    }
}

/// All strings of classes as a session id: accepted exactly by the grammar, and in the key unchanged.
pub fn segment<R: Readers, P: Prover>(p: &mut P) {
    let text = strings::of_classes(p, CLASSES);
    let says = p.truth(is_segment(&text));
    p.exactly("a segment by the grammar", R::segment(&text), says);
    builds::<R, P>(
        p,
        &Parts {
            key: 1,
            realm: None,
            session: text,
            name: None,
        },
    );
}

/// All strings of classes as a realm.
pub fn realm<R: Readers, P: Prover>(p: &mut P) {
    let text = strings::of_classes(p, CLASSES);
    let says = p.truth(is_realm(&text));
    p.exactly("a realm by the grammar", R::realm(&text), says);
    builds::<R, P>(
        p,
        &Parts {
            key: 0,
            realm: Some(text),
            session: "s".to_owned(),
            name: None,
        },
    );
}

/// Short strings in every place of every key.
pub fn builders<R: Readers, P: Prover>(p: &mut P) {
    let parts = parts(p);
    builds::<R, P>(p, &parts);
}

/// The case that a harness's inputs are, as a vector.
pub(super) fn vector<P: Prover>(property: &str, p: &mut P) -> Option<Value> {
    let as_session = |session| Parts {
        key: 1,
        realm: None,
        session,
        name: None,
    };
    let as_realm = |realm| Parts {
        key: 0,
        realm: Some(realm),
        session: "s".to_owned(),
        name: None,
    };
    let parts = match property {
        "keys/bytes" => as_session(strings::any_bytes(p)?),
        "keys/scalars" => as_session(strings::any_scalar(p, CONTEXTS)?),
        "keys/segment" => as_session(strings::of_classes(p, CLASSES)),
        "keys/realm" => as_realm(strings::of_classes(p, CLASSES)),
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

fn parts<P: Prover>(p: &mut P) -> Parts {
    let key = p.choice("key", KEYS.len());
    let place = p.choice("place", 3);
    let most = p.length(SHORT);
    let text = strings::of_classes_within(p, CLASSES, most);
    let session = "s".to_owned();
    match place {
        0 => Parts {
            key,
            realm: Some(text),
            session,
            name: None,
        },
        1 => Parts {
            key,
            realm: None,
            session: text,
            name: Some("n".to_owned()),
        },
        _ => Parts {
            key,
            realm: Some("r/q".to_owned()),
            session,
            name: Some(text),
        },
    }
}

fn builds<R: Readers, P: Prover>(p: &mut P, parts: &Parts) {
    let key = KEYS.get(parts.key).map_or(Key::Rpc, |(key, _)| *key);
    let answer = R::key(
        key,
        parts.realm.as_deref(),
        &parts.session,
        parts.name.as_deref(),
    );
    let same = p.truth(answer == key_of(parts));
    p.check("the key of the table, or an error", same);
}

fn accepts_the_grammar<R: Readers, P: Prover>(p: &mut P, text: &str) {
    let says = p.truth(is_segment(text));
    p.exactly("a segment by the grammar", R::segment(text), says);
    let says = p.truth(is_realm(text));
    p.exactly("a realm by the grammar", R::realm(text), says);
}

fn answers_alike<R: Readers, P: Prover>(p: &mut P, text: &str) {
    let canonical = strings::canonical(text, CLASSES);
    let same = R::segment(text) == R::segment(&canonical) && R::realm(text) == R::realm(&canonical);
    let same = p.truth(same);
    p.check("answers alike within a class", same);
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
    let end = text
        .bytes()
        .fold(State::Start, |state, byte| match (state, byte) {
            (State::Good, b'/') => State::Start,
            _ => state.next(byte),
        });
    end.is_good()
}
