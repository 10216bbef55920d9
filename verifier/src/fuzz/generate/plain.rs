//! Versions, contract hashes, keys, planes and the longest horizon.

use ncp_text::{CONTRACT_HASH, WIRE_VERSION};

use super::frames::segment;
use super::{Draw, Menu, Tree};
use crate::fuzz::tree::{num, object, or_null, set, text};
use crate::json::Json;

fn version_string(draw: &mut Draw<'_>) -> String {
    match draw.below(6) {
        0 => WIRE_VERSION.to_owned(),
        1 => format!("{}.{}", draw.below(3), draw.below(8)),
        2 => {
            let digits = draw.size(1, 30);
            format!("{}.{}", "1".repeat(digits), draw.below(9))
        }
        3 if draw.chance(50) => draw.below(4).to_string(),
        // As a word of some bits reads it, or does not.
        3 => {
            let (major, minor) = (draw.digits(), draw.digits());
            let zeros = "0".repeat(draw.one(&[0, 0, 0, 1, 20]));
            let version = match draw.below(4) {
                0 => format!("{zeros}{major}.5"),
                1 => format!("0.{zeros}{minor}"),
                2 => format!("{major}.{minor}"),
                _ => major,
            };
            // What stands behind may be wrong all the same.
            if draw.chance(75) { version } else { version + draw.pick(&[".", "x", ".5.x", " ", "-", ".0"]) }
        }
        5 if draw.chance(30) => {
            // Long, with one character that is none of it.
            let mut digits = "0".repeat(draw.size(1, 300));
            digits.push(draw.one(&['5', 'x', ' ', '.', '-']));
            if draw.chance(50) { format!("0.{digits}") } else { format!("{digits}.5") }
        }
        4 => {
            // One character more, less or other.
            let mut version: Vec<char> = WIRE_VERSION.chars().collect();
            let place = draw.below(version.len() + 1);
            let odd = draw.one(&['.', '0', '5', ' ', '-', '+', 'v', '_', '\n', '٥', '５', 'e', ',', '\u{0}', 'x']);
            if draw.chance(60) || place >= version.len() {
                version.insert(place, odd);
            } else {
                version[place] = odd;
            }
            version.into_iter().collect()
        }
        _ if draw.chance(60) => draw.nearly(WIRE_VERSION),
        _ => draw.string(),
    }
}

/// The arguments of `version.check`.
pub(super) fn version(draw: &mut Draw<'_>) -> Tree {
    let version = if draw.chance(2) { format!("{}.5", "0".repeat(draw.size(1, 5000))) } else { version_string(draw) };
    object([("version", text(version)), ("strict", Json::Bool(draw.chance(50)))])
}

/// A contract hash that a peer may send, or none.
pub(super) fn hash(draw: &mut Draw<'_>) -> Option<String> {
    match draw.below(6) {
        0 => None,
        1 | 2 => Some(CONTRACT_HASH.to_owned()),
        3 => Some(CONTRACT_HASH.to_uppercase()),
        4 => {
            let mut hash = CONTRACT_HASH.to_owned();
            match draw.below(8) {
                // Up to where some texts end.
                6 => hash.push_str(draw.pick(&["\0", "\0x", "\0\0", "\0-dirty"])),
                7 => hash.push_str(draw.pick(&[" ", "\n", "-dirty", "+", ".0", "\u{a0}"])),
                4 => hash.insert(0, '0'),
                5 => hash.insert_str(0, "0x"),
                0 => hash.push('0'),
                1 => drop(hash.pop()),
                2 => hash.insert(0, ' '),
                _ => hash.replace_range(15.., "0"),
            }
            Some(hash)
        }
        _ if draw.chance(50) => Some(draw.nearly(CONTRACT_HASH)),
        _ => Some(draw.string()),
    }
}

/// The arguments of `contract.status` and `contract.verify`.
pub(super) fn contract(draw: &mut Draw<'_>) -> Tree {
    object([("peer_hash", or_null(hash(draw).map(text)))])
}

/// The arguments of `negotiate`.
pub(super) fn negotiate(draw: &mut Draw<'_>) -> Tree {
    object([("version", text(version_string(draw))), ("contract_hash", or_null(hash(draw).map(text)))])
}

/// A segment, valid or not.
fn any_segment(draw: &mut Draw<'_>) -> String {
    if draw.chance(60) {
        return segment(draw);
    }
    match draw.below(6) {
        // Nothing, or what ends a line for some.
        4 => String::new(),
        5 => {
            let odd = draw.pick(&["\u{2028}", "\u{2029}", "\u{85}", "\u{a0}", "\u{3000}", "%", "\u{feff}"]);
            format!("{}{odd}{}", draw.pick(&["", "a"]), draw.pick(&["", "b"]))
        }
        0 => draw.string(),
        1 => {
            // Of wide letters, one more than fit needs some bytes more.
            let more = draw.below(10);
            let length = draw.one(&[255, 256, 257, 256 + more, 256 + 10 * more, 256 + 60 * more, 1000]);
            let mut letters = draw.letters(length);
            if draw.chance(40) {
                // With what a refusal that quotes it may stumble over.
                let odd = draw.pick(&["%", "%s", "{}", "{0}", "\\", "\"", "\n", "\0", "\u{85}", "/", "*"]);
                letters.insert_str(0, odd);
            }
            letters
        }
        2 => {
            let mut segment: Vec<char> = segment(draw).chars().collect();
            let place = draw.below(segment.len() + 1);
            if draw.chance(40) {
                segment.insert(
                    place,
                    draw.one(&['\u{2028}', '\u{2029}', '\u{85}', '\u{e9}', '%', '\u{3000}', '\u{1f681}']),
                );
            }
            let odd = ['/', '*', '$', '#', '?', ' ', '\t', '\n', '\u{b}', '\u{c}', '\r', '@', '.', '\u{0}', '\u{7f}'];
            segment.insert(place, draw.one(&odd));
            segment.into_iter().collect()
        }
        _ => draw
            .pick(&[
                ".", "..", "...", "@", "@a", "a@", "", "/", "**", "$*", "~", "%2F", "a.", "É", "0", "00", "sensor",
                "a/b",
            ])
            .to_owned(),
    }
}

/// The arguments of `key.build`.
pub(super) fn key_build(menu: &Menu, draw: &mut Draw<'_>) -> Option<Tree> {
    let key = draw.one(menu.keys.get(..).filter(|keys| !keys.is_empty())?);
    let realm = draw.chance(60).then(|| {
        let parts = if draw.chance(15) { draw.size(1, 70) } else { draw.size(1, 3) };
        let is_short = parts > 3 && draw.chance(50);
        let part = |draw: &mut Draw<'_>| if is_short { draw.name() } else { segment(draw) };
        let mut parts: Vec<String> = (0..parts).map(|_| part(draw)).collect();
        for _ in 0..draw.one(&[0, 1, 1, 2]) {
            let place = draw.below(parts.len());
            parts[place] = any_segment(draw);
        }
        parts.join("/")
    });
    let mut args = object([("key", text(key)), ("realm", or_null(realm.clone().map(text)))]);
    // What is valid as a realm need not be so as a segment.
    let part = |draw: &mut Draw<'_>| match &realm {
        Some(realm) if draw.chance(4) => realm.clone(),
        _ => any_segment(draw),
    };
    if !matches!(key, "rpc" | "fleet_glob") {
        set(&mut args, "session", text(part(draw)));
    }
    if matches!(key, "sensor" | "command") && draw.chance(60) {
        set(&mut args, "name", text(part(draw)));
    }
    if key == "rpc" && menu.strict && draw.chance(50) {
        let verbs =
            ["open_session", "step_request", "run_request", "close_session", "sensor_frame", "", "Step_request"];
        set(&mut args, "verb", text(draw.pick(&verbs)));
    }
    Some(args)
}

/// The arguments of `key.match`.
pub(super) fn key_match(draw: &mut Draw<'_>) -> Tree {
    let long = draw.size(8, 200);
    let long = draw.letters(long);
    let longer = format!("{long}1");
    let alphabet = ["a", "b", "ab", "aab", "@a", "session", "x.y", "aaaa", "é", "abab", "@ab", long.as_str(), &longer];
    let alphabet = match draw.below(10) {
        0 | 1 => &alphabet[..],
        // So few that one chunk fits in many places, and a matcher has to try again.
        2..=4 => &alphabet[..2],
        5 => &alphabet[..5],
        _ => &alphabet[..11],
    };
    let count = if draw.chance(20) { draw.size(1, 70) } else { draw.size(1, 6) };
    let (repeats, odd, controls) = (draw.one(&[0, 0, 50]), draw.one(&[0, 0, 40]), draw.one(&[0, 0, 0, 30]));
    let chunk = |draw: &mut Draw<'_>| {
        if draw.chance(odd) {
            return draw.pick(&MEANINGFUL).to_owned();
        }
        if draw.chance(controls) {
            let control = draw.one(&['\n', '\n', '\r', '\0', '\u{2028}', '\u{85}']);
            return match draw.below(4) {
                0 => control.to_string(),
                1 => format!("a{control}b"),
                _ => format!("{}{control}", draw.pick(alphabet)),
            };
        }
        if !draw.chance(repeats) {
            return draw.pick(alphabet).to_owned();
        }
        // What a search within it comes back to.
        let most = if draw.chance(30) { 250 } else { 12 };
        (0..draw.size(1, most)).map(|_| draw.one(&['a', 'a', 'b'])).collect()
    };
    let mut key: Vec<String> = (0..count).map(|_| chunk(draw)).collect();
    // The pattern is the key with some of it made wild, so that both answers are common.
    let mut pattern = Vec::new();
    let mut chunks = key.clone().into_iter();
    while let Some(chunk) = chunks.next() {
        match draw.below(12) {
            0 | 1 => pattern.push("*".to_owned()),
            2 => {
                // It covers any number of them.
                pattern.push("**".to_owned());
                for _ in 0..draw.size(0, count) {
                    chunks.next();
                }
            }
            // The key has another character where the pattern has one that means something elsewhere.
            9 | 10 if MEANINGFUL.contains(&chunk.as_str()) => {
                let other = chunk.replace(|c: char| !c.is_alphanumeric(), draw.pick(&["x", "a", ""]));
                let at = key.len() - chunks.len() - 1;
                key[at] = if other.is_empty() { "x".to_owned() } else { other };
                pattern.push(if draw.chance(70) { format!("{chunk}$*") } else { format!("$*{chunk}") });
            }
            8 if chunk.starts_with('@') && draw.chance(60) => {
                pattern.push(if draw.chance(50) { "$*".to_owned() } else { format!("$*{}", &chunk[1..]) });
            }
            8 if chunk.len() > 1 && draw.chance(50) => {
                // Cut, or with more behind it.
                let cut = chunk.char_indices().last().map_or(0, |(at, _)| at);
                pattern.push(if draw.chance(50) { chunk[..cut].to_owned() } else { format!("{chunk}b") });
            }
            3 => {
                pattern.push("**".to_owned());
                pattern.push(chunk);
            }
            4 | 5 if chunk.starts_with('@') && chunk.len() > 1 => {
                let cut = 1 + draw.below(chunk.len() - 1);
                let cut = if chunk.is_char_boundary(cut) { cut } else { 1 };
                pattern.push(format!("{}$*", &chunk[..cut]));
            }
            4 | 5 if !chunk.starts_with('@') => pattern.push(dollars(&chunk, draw)),
            6 => {
                pattern.push(chunk);
                if draw.chance(50) {
                    chunks.next();
                }
            }
            7 if draw.chance(30) => pattern.push(draw.pick(alphabet).to_owned()),
            _ => pattern.push(chunk),
        }
    }
    if draw.chance(15) {
        pattern.push(draw.pick(&["**", "*", "a", "$*"]).to_owned());
    }
    let mut pattern = canonical(pattern).join("/");
    if draw.chance(5) {
        pattern.push_str(draw.pick(&["/", "#", "?", "*a", "$", "//a"]));
    }
    object([("pattern", text(pattern)), ("key", text(key.join("/")))])
}

/// A pattern as Zenoh writes it: it refuses every other spelling, and so may a peer.
pub(in crate::fuzz) fn canonical(chunks: Vec<String>) -> Vec<String> {
    let mut pattern: Vec<String> = Vec::new();
    for chunk in chunks {
        let chunk = if chunk == "$*" { "*".to_owned() } else { chunk };
        match pattern.last_mut() {
            Some(last) if last == "**" && chunk == "**" => {}
            Some(last) if last == "**" && chunk == "*" => {
                *last = chunk;
                pattern.push("**".to_owned());
            }
            _ => pattern.push(chunk),
        }
    }
    pattern
}

/// Chunks with characters that mean something to who takes a pattern for a regular expression, or for a glob.
const MEANINGFUL: [&str; 14] =
    ["v1.0", "a+b", "(a)", "[ab]", "[^a]", "[!a]", "a|b", "^a", "a{2}", "{a,b}", "\\d", "a\\", "a_b", "a%"];

/// A chunk with some runs of it wild.
fn dollars(chunk: &str, draw: &mut Draw<'_>) -> String {
    if draw.chance(50) {
        return pieces(chunk, draw);
    }
    let mut pattern = String::new();
    for c in chunk.chars() {
        match draw.below(4) {
            0 => pattern.push_str("$*"),
            1 => {
                pattern.push(c);
                pattern.push_str("$*");
            }
            _ => pattern.push(c),
        }
    }
    if draw.chance(20) {
        // More than there is: what stands before and behind may not cover the same.
        let again = chunk.chars().last().map_or_else(String::new, String::from);
        pattern.push_str("$*");
        pattern.push_str(&again);
    }
    single(pattern)
}

/// Pieces of a chunk with wild runs between, of which neighbours may overlap, or leave out what stands between: then
/// only a reader that looks again, or that counts a character twice, has another answer.
fn pieces(chunk: &str, draw: &mut Draw<'_>) -> String {
    let letters: Vec<char> = chunk.chars().collect();
    let long = draw.one(&[2, 4, 12]);
    let mut pattern = Vec::new();
    let mut at = if draw.chance(60) { 0 } else { draw.below(letters.len()) };
    for _ in 0..draw.size(2, 6) {
        let end = (at + draw.size(1, long)).min(letters.len());
        pattern.push(letters[at.min(end)..end].iter().collect::<String>());
        at = match draw.below(6) {
            0 => end.saturating_sub(1),
            1 => end.saturating_sub(draw.size(1, long)),
            2 | 3 => end,
            _ => end + draw.below(4),
        };
    }
    if draw.chance(60) {
        // To its end, perhaps with what the piece before has covered.
        let from = if draw.chance(50) { at.min(letters.len()) } else { at.saturating_sub(draw.size(1, long)) };
        pattern.push(letters[from.min(letters.len())..].iter().collect());
    }
    let pattern = pattern.join("$*");
    let pattern = if draw.chance(20) { format!("$*{pattern}") } else { pattern };
    let pattern = if draw.chance(20) { format!("{pattern}$*") } else { pattern };
    single(pattern)
}

/// One wild run where there would be two side by side, which no pattern has.
fn single(mut pattern: String) -> String {
    while pattern.contains("$*$*") {
        pattern = pattern.replace("$*$*", "$*");
    }
    if pattern == "$*" { "a$*".to_owned() } else { pattern }
}

/// The arguments of `plane.qos`.
pub(super) fn plane(menu: &Menu, draw: &mut Draw<'_>) -> Option<Tree> {
    let plane = draw.one(menu.planes.get(..).filter(|planes| !planes.is_empty())?);
    Some(object([("plane", text(plane))]))
}

/// The arguments of `horizon.max_len`.
pub(super) fn horizon(draw: &mut Draw<'_>) -> Tree {
    let is_decimal = draw.chance(25);
    let dt = match is_decimal {
        true if draw.chance(40) => draw.range(1, 200) as f64,
        true => draw.range(1, 999) as f64 / 10.0,
        false if draw.chance(80) => draw.positive(),
        false => draw.double(),
    };
    draw.note(dt);
    let ttl = match draw.below(4) {
        // Next to a whole number of ticks, by more than one rounding and less than many.
        _ if is_decimal => {
            let beside = draw.one(&[0.0, 1e-15, 4e-15, 1e-14, 1e-13, 1e-12]);
            let beside = if draw.chance(50) { -beside } else { beside };
            dt * draw.range(1, 4096) as f64 * (1.0 + beside)
        }
        0 => dt * draw.range(0, 5000) as f64,
        1 => {
            let count = draw.range(1, 4097) as f64;
            draw.neighbour(dt * count)
        }
        2 => draw.double(),
        _ => draw.positive(),
    };
    object([("ttl_ms", num(ttl)), ("dt_ms", num(dt))])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fuzz::harvest::Harvest;
    use crate::fuzz::tree::{double, string};

    #[test]
    fn a_hash_goes_on_behind_where_some_texts_end_and_a_ttl_lies_next_to_a_whole_number_of_ticks() {
        let harvest = Harvest::default();
        let (mut behind, mut beside) = (0, 0);
        for number in 0..2000 {
            let mut draw = Draw::new(3, number, &harvest);
            let negotiated = negotiate(&mut draw);
            let hash = string(&negotiated, "contract_hash").unwrap_or_default();
            behind += usize::from(hash.strip_prefix(CONTRACT_HASH).is_some_and(|rest| rest.starts_with('\0')));
            let length = horizon(&mut draw);
            let ticks = double(length.get("ttl_ms")).unwrap_or(0.0) / double(length.get("dt_ms")).unwrap_or(1.0);
            let off = (ticks - ticks.round()).abs() / ticks;
            beside += usize::from((1e-15..2e-12).contains(&off) && ticks < 4097.0);
        }
        assert!(behind > 20 && beside > 100, "{behind} {beside}");
    }

    #[test]
    fn a_character_that_means_something_elsewhere_stands_beside_a_wildcard_and_another_in_the_key() {
        let harvest = Harvest::default();
        let mut found = std::collections::HashSet::<&str>::new();
        for number in 0..2000 {
            let args = key_match(&mut Draw::new(3, number, &harvest));
            let (pattern, key) = (string(&args, "pattern").unwrap(), string(&args, "key").unwrap());
            for (chunk, other) in pattern.split('/').zip(key.split('/')) {
                let bare = chunk.strip_suffix("$*").or(chunk.strip_prefix("$*")).unwrap_or_default();
                found.extend(MEANINGFUL.iter().filter(|known| **known == bare && !other.contains(**known)));
            }
        }
        assert!(found.len() > 10, "{found:?}");
    }

    #[test]
    fn a_pattern_is_spelled_as_zenoh_spells_it() {
        let spelled = |pattern: &str| canonical(pattern.split('/').map(str::to_owned).collect()).join("/");
        for (pattern, expected) in [
            ("a/$*/b", "a/*/b"),
            ("**/**/a", "**/a"),
            ("**/*/*", "*/*/**"),
            ("**/$*/**", "*/**"),
            ("a$*/**/b", "a$*/**/b"),
        ] {
            assert_eq!(spelled(pattern), expected);
        }
    }
}
