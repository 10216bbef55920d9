//! Frames as they may be spelled, and valid text made invalid with its grammar in mind.

use super::{Draw, Tree};
use crate::fuzz::tree::{Step, at, at_mut, int, list, literal, map, name_at, object, places, set, text};
use crate::json::{Json, write_string};

/// Writes a frame as strangely as the grammar allows: white space, escapes, and unknown members.
pub(super) fn wild(frame: &Tree, draw: &mut Draw<'_>) -> String {
    let mut frame = frame.clone();
    if draw.chance(20) {
        // What another kind has is unknown to this one.
        let is_unversioned = frame.get("kind").and_then(Json::as_str) == Some("error");
        let (name, unknown) = if is_unversioned && draw.chance(40) {
            ("ncp_version", text(draw.pick(&["0.4", "1.0", "x", "0.5"])))
        } else {
            let unknown = unknown(draw);
            (draw.pick(&["future", "x", "Kind", "kind ", "ncp_versio", "s\u{e9}q", ""]), unknown)
        };
        let sites: Vec<_> =
            places(&frame).into_iter().filter(|place| matches!(at(&frame, place), Some(Json::Object(_)))).collect();
        // A member of a map is an entry, so only the top is sure to ignore it.
        if let Some(top) = sites.first().and_then(|place| at_mut(&mut frame, place)) {
            set(top, name, unknown);
        }
    }
    if draw.chance(20) {
        reorder(&mut frame, draw);
    }
    let spaces = draw.one(&[0, 0, 20]);
    let escapes = draw.one(&[0, 0, 15]);
    let mut out = String::new();
    write(&frame, spaces, escapes, draw, &mut out);
    out
}

/// The members of an object, and of what it holds, in another order, which says the same.
fn reorder(tree: &mut Tree, draw: &mut Draw<'_>) {
    match tree {
        Json::Array(items) if items.len() < 40 => items.iter_mut().for_each(|item| reorder(item, draw)),
        Json::Object(members) if members.len() < 40 => {
            let count = members.len();
            match draw.below(3) {
                0 => members.reverse(),
                1 => members.rotate_left(draw.below(count.max(1))),
                _ => (0..count).for_each(|at| members.swap(at, draw.below(count))),
            }
            members.iter_mut().for_each(|(_, value)| reorder(value, draw));
        }
        _ => {}
    }
}

/// A value for a member that nobody knows.
pub(super) fn unknown(draw: &mut Draw<'_>) -> Tree {
    match draw.below(10) {
        // So many brackets that somebody counts them, about strings whose ends are told by their escapes.
        9 => {
            let strings: Vec<String> = (0..3).map(|_| draw.quoted()).collect();
            let count = draw.size(1, 100);
            let mut items = vec![list(Vec::new()); count];
            items.extend(strings.into_iter().map(text));
            items.push(deep(&[2, 31, 58, 60, 61, 62], draw));
            let at = draw.below(items.len());
            items.insert(at, text(draw.quoted()));
            list(items)
        }
        // Large, and perhaps with a name twice.
        6 => {
            let count = if draw.chance(20) { draw.size(1, 3000) } else { draw.size(1, 40) };
            let mut members: Vec<_> = (0..count).map(|nth| (format!("m{nth}").into(), int(1))).collect();
            if draw.chance(30) {
                let again = members[draw.below(members.len())].clone();
                members.push(again);
            }
            let levels = draw.below(8);
            (0..levels).fold(Json::Object(members), |inner, _| object([("a", inner)]))
        }
        7 if draw.chance(20) => {
            let length = if draw.chance(10) { draw.size(70_000, 1_200_000) } else { draw.size(300, 140_000) };
            text(draw.letters(length))
        }
        0 => deep(&[2, 31, 32, 61, 62, 63], draw),
        1 => text(draw.string()),
        2 => literal(draw.pick(&["1.0", "-0", "1e308", "0.1e-400", "123456789012345678901234567890"])),
        3 => object([("kind", text("estop")), ("mode", text("estop")), ("seq", literal("1.5"))]),
        4 => Json::Null,
        _ => list(vec![Json::Bool(true), text("]"), text("\\\"["), object([])]),
    }
}

/// Arrays and objects within each other, of so many levels.
fn deep(levels: &[usize], draw: &mut Draw<'_>) -> Tree {
    let levels = draw.one(levels);
    let objects = draw.chance(30);
    (0..levels).fold(int(1), |inner, _| if objects { object([("a", inner)]) } else { list(vec![inner]) })
}

fn space(percent: u64, draw: &mut Draw<'_>, out: &mut String) {
    while percent > 0 && draw.chance(percent) {
        out.push(draw.one(&[' ', '\t', '\n', '\r']));
    }
}

fn write(tree: &Tree, spaces: u64, escapes: u64, draw: &mut Draw<'_>, out: &mut String) {
    space(spaces, draw, out);
    match tree {
        Json::String(value) => spell(value, escapes, draw, out),
        Json::Array(items) => {
            out.push('[');
            for (nth, item) in items.iter().enumerate() {
                if nth > 0 {
                    out.push(',');
                }
                write(item, spaces, escapes, draw, out);
            }
            space(spaces, draw, out);
            out.push(']');
        }
        Json::Object(members) => {
            out.push('{');
            for (nth, (name, value)) in members.iter().enumerate() {
                if nth > 0 {
                    out.push(',');
                }
                space(spaces, draw, out);
                spell(name, escapes, draw, out);
                space(spaces, draw, out);
                out.push(':');
                write(value, spaces, escapes, draw, out);
            }
            space(spaces, draw, out);
            out.push('}');
        }
        Json::Number(spelling) if escapes > 0 && spelling.contains(['.', 'e', 'E']) && draw.chance(50) => {
            let spelling = if draw.chance(10) { draw.pick(&ZEROS).to_owned() } else { respelled(spelling, draw) };
            out.push_str(&recased(&spelling, draw));
        }
        plain => out.push_str(&plain.to_string()),
    }
    space(spaces, draw, out);
}

/// Ways to spell no more than a sign.
const ZEROS: [&str; 8] = ["-0", "0", "-0.0", "0e0", "-0e5", "0.00E-7", "-0.0e-400", "0E400"];

/// The same number, its exponent perhaps with another letter, or with a sign.
fn recased(spelling: &str, draw: &mut Draw<'_>) -> String {
    let Some((digits, exponent)) = spelling.split_once(['e', 'E']) else { return spelling.to_owned() };
    let size = exponent.trim_start_matches(['+', '-']);
    let sign = match exponent.strip_suffix(size) {
        Some("-") => "-",
        _ => draw.one(&["", "+"]),
    };
    format!("{digits}{}{sign}{}{size}", draw.one(&['e', 'E']), zeros(draw))
}

/// Zeros that lead an exponent and change nothing, now and then more than any integer has digits.
fn zeros(draw: &mut Draw<'_>) -> String {
    let most = draw.one(&[0, 0, 0, 2, 2, 40]);
    "0".repeat(draw.below(most + 1))
}

/// The same double, spelled with more digits or another exponent.
fn respelled(spelling: &str, draw: &mut Draw<'_>) -> String {
    let (digits, exponent) = spelling.split_once(['e', 'E']).unwrap_or((spelling, "0"));
    let exponent: i64 = exponent.parse().unwrap_or(0);
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let (sign, whole) = whole.strip_prefix('-').map_or(("", whole), |whole| ("-", whole));
    let long = draw.one(&[3, 3, 20, 400]);
    let zeros = "0".repeat(draw.size(1, long));
    let places = |count: usize| i64::try_from(count).unwrap_or(0);
    match draw.below(6) {
        0 => format!("{sign}{whole}.{fraction}{zeros}{}{exponent:+}", draw.one(&['e', 'E'])),
        // All of it before the point.
        1 if whole != "0" => format!("{sign}{whole}{fraction}e{}", exponent - places(fraction.len())),
        2 if whole != "0" => {
            let less = exponent - places(fraction.len()) - places(zeros.len());
            format!("{sign}{whole}{fraction}{zeros}E{less}")
        }
        // All of it behind.
        3 => {
            let more = exponent + places(whole.len()) + places(zeros.len());
            format!("{sign}0.{zeros}{whole}{fraction}e{more:+}")
        }
        4 => format!("{sign}{whole}.{fraction}0e{}{}", if exponent < 0 { "-0" } else { "+0" }, exponent.abs()),
        _ => spelling.to_owned(),
    }
}

/// A number of many digits: that overflows by them alone, or that an exponent brings back, or nearly.
pub(super) fn digits(draw: &mut Draw<'_>) -> String {
    let count = match draw.below(3) {
        0 if draw.chance(20) => 4250 + draw.below(1000),
        // More than readers count of an exponent.
        0 if draw.chance(10) => draw.one(&[19_990, 20_010, 65_530, 100_000]) + draw.below(30),
        0 => draw.size(15, 1100),
        _ => draw.one(&[17, 19, 40, 307, 308, 309, 310, 320, 350, 400, 1000]) + draw.below(30),
    };
    let (digit, sign) = (draw.one(&['1', '9']), draw.one(&["", "-"]));
    let many = digit.to_string().repeat(count);
    let zeros = "0".repeat(count);
    match draw.below(9) {
        // Digits and an exponent that overflow together, or nearly.
        8 => {
            let zeros = draw.below(309);
            let exponent = (306 + draw.below(5)).saturating_sub(zeros);
            recased(&format!("{sign}{digit}{}e{exponent}", "0".repeat(zeros)), draw)
        }
        7 => {
            let beyond = 306 + draw.below(6);
            recased(&format!("{sign}{digit}e{beyond}"), draw)
        }
        0 | 1 | 6 => format!("{sign}{many}"),
        2 => format!("{sign}{many}.0"),
        3 => format!("{sign}{many}e-{}", count - draw.below(3)),
        4 => format!("{sign}0.{zeros}{digit}e+{}", count + draw.one(&[0, 1, 300, 308, 309, 310])),
        _ => format!("{sign}1{zeros}{}", draw.one(&["", ".5", "e-400", "E+0"])),
    }
}

/// A string, some of its characters as escapes.
fn spell(value: &str, escapes: u64, draw: &mut Draw<'_>, out: &mut String) {
    if escapes == 0 {
        return write_string(value, out);
    }
    out.push('"');
    for c in value.chars() {
        let mut units = [0; 2];
        // A pair, and what stands behind a backslash, is read by rules of its own.
        let often = if c.len_utf16() > 1 { 60 } else { escapes };
        if draw.chance(often) {
            for unit in c.encode_utf16(&mut units) {
                let upper = draw.chance(50);
                out.push_str(&if upper { format!("\\u{unit:04X}") } else { format!("\\u{unit:04x}") });
            }
        } else if c == '/' && draw.chance(50) {
            out.push_str("\\/");
        } else {
            let mut one = String::new();
            write_string(c.encode_utf8(&mut [0; 4]), &mut one);
            out.push_str(&one[1..one.len() - 1]);
        }
    }
    out.push('"');
}

/// A frame that is wrong in one way, most likely.
pub(super) fn corrupted(frame: &Tree, draw: &mut Draw<'_>) -> Vec<u8> {
    if draw.chance(60) {
        let mut frame = frame.clone();
        wrong_value(&mut frame, draw);
        if draw.chance(2) {
            enlarge(&mut frame, draw);
        }
        return wild(&frame, draw).into_bytes();
    }
    wrong_text(wild(frame, draw).into_bytes(), draw)
}

/// Makes the frame long by a member that nobody knows, at its beginning or its end: some receivers read long frames on
/// a road of their own.
fn enlarge(frame: &mut Tree, draw: &mut Draw<'_>) {
    let kinds = frame.get("kind").and_then(Json::as_str);
    let most = if kinds == Some("observation_frame") { 1_300_000 } else { 1_000_000 };
    let length = if draw.chance(30) { most } else { draw.size(4000, 140_000) };
    let member = if draw.chance(50) {
        text("x".repeat(length))
    } else {
        // In rows, since an array that is ignored may be held to a limit, too.
        let row = list(vec![literal("0.5"); 1000]);
        list(vec![row; length / 4000 + 1])
    };
    if let Json::Object(members) = frame {
        let at = if draw.chance(50) { 0 } else { members.len() };
        members.insert(at, ("future".into(), member));
    }
}

/// Changes one value or member, so that the grammar stays.
fn wrong_value(frame: &mut Tree, draw: &mut Draw<'_>) {
    let all = places(frame);
    let place = all[draw.below(all.len())].clone();
    let name = name_at(frame, &place).to_owned();
    match draw.below(17) {
        // A name twice, anywhere.
        14 | 15 => {
            let sites: Vec<_> = all
                .iter()
                .filter(|place| matches!(at(frame, place), Some(Json::Object(members)) if !members.is_empty()))
                .cloned()
                .collect();
            let Some(place) = sites.get(draw.below(sites.len())) else { return };
            if let Some(Json::Object(members)) = at_mut(frame, place) {
                let again = members[draw.below(members.len())].clone();
                let at = draw.below(members.len() + 1);
                members.insert(at, again);
            }
        }
        // Of another session, version or depth, within.
        16 => {
            let sites: Vec<_> = all
                .iter()
                .filter(|place| !place.is_empty() && matches!(at(frame, place), Some(Json::Object(_))))
                .cloned()
                .collect();
            let levels = deep(&[58, 59, 60, 61, 62, 63, 64], draw);
            let id = frame.get("session_id").and_then(Json::as_str).unwrap_or("s1").to_owned();
            let id = draw.nearly(&id);
            let Some(place) = sites.get(draw.below(sites.len())) else { return };
            let kind = frame.get("kind").cloned().unwrap_or(Json::Null);
            let is_of_another_kind = draw.chance(40);
            if let Some(inner) = at_mut(frame, place) {
                match draw.below(3) {
                    // The kind within, and another one, or none, without.
                    _ if is_of_another_kind => set(inner, "kind", kind),
                    0 => set(inner, "session_id", text(id)),
                    1 => set(inner, "ncp_version", text(draw.pick(&["0.4", "0.6", "1.0", "0.5"]))),
                    _ => set(inner, "future", levels),
                }
            }
            if is_of_another_kind {
                turned(frame, draw);
            }
        }
        // Another type.
        0 if draw.chance(50) => {
            // What is right stands a level too deep.
            let Some(value) = at(frame, &place).cloned() else { return };
            let wrapped = match draw.below(4) {
                0 => object([(name.as_str(), value)]),
                1 => list(vec![value.clone(), value]),
                2 => list(vec![list(vec![value])]),
                _ => list(vec![value]),
            };
            replace(frame, &place, draw, |_| wrapped);
        }
        0..=2 => replace(frame, &place, draw, |draw| match draw.below(8) {
            0 => Json::Null,
            1 => Json::Bool(draw.chance(50)),
            2 => int(0),
            3 => text("1"),
            4 => list(Vec::new()),
            5 => object([]),
            6 => literal("1.5"),
            _ => text(""),
        }),
        3 => replace(frame, &place, draw, |_| Json::Null),
        // An integer in another spelling, or beyond the wire's.
        4 | 5 => {
            let spelling = [
                "1.0",
                "1e0",
                "-0",
                "0.0",
                "1E1",
                "9007199254740991",
                "9007199254740992",
                "-9007199254740992",
                "10e-1",
                "9007199254740993",
                "18446744073709551617",
                "9007199254740991.0",
                "1e15",
                "-0.0",
                "2147483648",
            ];
            let mut spelling = if draw.chance(25) { draw.digits() } else { draw.pick(&spelling).to_owned() };
            if draw.chance(40) {
                // What follows it, or stands before it, may be white space.
                let space = draw.pick(&[" ", "\t", "\n", "\r", " \r\n"]);
                spelling = if draw.chance(70) { format!("{spelling}{space}") } else { format!("{space}{spelling}") };
            }
            let numbers: Vec<_> =
                all.iter().filter(|place| matches!(at(frame, place), Some(Json::Number(_)))).cloned().collect();
            let place = if numbers.is_empty() { place } else { numbers[draw.below(numbers.len())].clone() };
            replace(frame, &place, draw, |_| literal(spelling));
        }
        // A number beyond a double, or at its end.
        6 => {
            let known = ["1e400", "-1E+400", "1.7976931348623159e308", "1.7976931348623158e308", "1e309", "2e-324"];
            let spelling = if draw.chance(40) { digits(draw) } else { draw.pick(&known).to_owned() };
            let numbers: Vec<_> =
                all.iter().filter(|place| matches!(at(frame, place), Some(Json::Number(_)))).cloned().collect();
            if !numbers.is_empty() {
                let place = numbers[draw.below(numbers.len())].clone();
                replace(frame, &place, draw, |_| literal(spelling));
            }
        }
        // A member less.
        7 => {
            let sites: Vec<_> =
                all.iter().filter(|place| matches!(at(frame, place), Some(Json::Object(_)))).cloned().collect();
            if let Some(Json::Object(members)) = at_mut(frame, &sites[draw.below(sites.len())])
                && !members.is_empty()
            {
                let gone = draw.below(members.len());
                members.remove(gone);
            }
        }
        8 => {
            let kinds = ["sensor_frame", "command_frame", "error", "Command_frame", "", "observation_frame", "novel"];
            set(frame, "kind", text(draw.pick(&kinds)));
        }
        9 => {
            let versions = [
                "0.4", "0.6", "1.0", "1", "0", "0.5.0", "v0.5", "", "0.", ".5", " 0.5", "0.5 ", "00.5", "0.05", "0.５",
                "0.51", "0.50", "0.5\n", "10.5", "0.15",
            ];
            set(frame, "ncp_version", text(draw.pick(&versions)));
        }
        10 => {
            let ids = ["", "a/b", "a*", "$a", "a#", "?", "a b", "@a", ".", "..", "\u{7f}", "a\n", "\u{1}"];
            let long = draw.letters(257);
            let id = if draw.chance(20) { long } else { draw.pick(&ids).to_owned() };
            set(frame, "session_id", text(id));
        }
        11 => {
            let pin = draw.one(&["calibrated_posterior", "is_simulation_output"]);
            let value = match draw.below(5) {
                0 => Json::Bool(true),
                1 => Json::Bool(false),
                2 => Json::Null,
                3 => int(0),
                _ => text("false"),
            };
            let mut within = frame.get("provenance").cloned().unwrap_or(Json::Null);
            if frame.get("kind").and_then(Json::as_str) == Some("session_opened") {
                if !matches!(within, Json::Object(_)) {
                    within = object([]);
                }
                set(&mut within, pin, value);
                set(frame, "provenance", within);
            } else {
                set(frame, pin, value);
            }
        }
        // At the limit of levels, or beyond.
        12 => {
            let levels = deep(&[63, 64, 65, 100], draw);
            set(frame, "future", levels);
        }
        // An array or a map at its limit.
        _ => {
            let sites: Vec<_> = all
                .iter()
                .filter(|place| !place.is_empty() && matches!(at(frame, place), Some(Json::Array(_) | Json::Object(_))))
                .cloned()
                .collect();
            if sites.is_empty() {
                return set(frame, &name, Json::Null);
            }
            let place = sites[draw.below(sites.len())].clone();
            let count = crowd(draw);
            if let Some(target) = at_mut(frame, &place) {
                grow(target, count);
            }
        }
    }
}

/// The frame with its kind behind all else, and another one there, or none.
fn turned(frame: &mut Tree, draw: &mut Draw<'_>) {
    let Json::Object(members) = frame else { return };
    members.retain(|(name, _)| name != "kind");
    if draw.chance(80) {
        let kind = draw.pick(&["sensor_frame", "command_frame", "step_request", "error", "session_opened"]);
        members.push(("kind".into(), text(kind)));
    }
}

fn replace(frame: &mut Tree, place: &[Step], draw: &mut Draw<'_>, by: impl FnOnce(&mut Draw<'_>) -> Tree) {
    if place.is_empty() {
        return;
    }
    let value = by(draw);
    if let Some(target) = at_mut(frame, place) {
        *target = value;
    }
}

/// As many as are near a limit, or as many as a count of 16 bits takes for few.
fn crowd(draw: &mut Draw<'_>) -> usize {
    let near = draw.one(&[64, 65, 256, 1000, 4095, 4096, 4097]);
    if draw.chance(4) { 65_536 + draw.below(4096) } else { near }
}

/// Repeats what is there until there is so much of it.
fn grow(target: &mut Tree, count: usize) {
    match target {
        Json::Array(items) if !items.is_empty() => {
            let have = items.len();
            for nth in have..count {
                items.push(items[nth % have].clone());
            }
        }
        Json::Object(members) if !members.is_empty() => {
            let value = members[0].1.clone();
            let entries: Vec<_> = (members.len()..count).map(|nth| (format!("k{nth}"), value.clone())).collect();
            if let Json::Object(more) = map(entries) {
                members.extend(more);
            }
        }
        _ => {}
    }
}

/// Lets a frame that is cut off go on for long with what has no end: who looks for it again and again hangs.
fn break_off(bytes: &mut Vec<u8>, draw: &mut Draw<'_>) {
    let opening = draw.pick(&["", "\"", "\"", "[", "-0."]);
    let brackets = if draw.chance(50) { "[".repeat(70) } else { String::new() };
    let unit = draw.pick(&["\\\"", "\\\"", "\\\\", "x", " ", "1", "\"", "\u{20ac}"]);
    let times = draw.size(20_000, 300_000);
    bytes.extend_from_slice(format!("{opening}{brackets}{}", unit.repeat(times)).as_bytes());
}

/// Breaks the grammar, most likely.
fn wrong_text(mut bytes: Vec<u8>, draw: &mut Draw<'_>) -> Vec<u8> {
    let tokens: Vec<usize> = bytes
        .iter()
        .enumerate()
        .filter(|(_, byte)| matches!(byte, b'{' | b'}' | b'[' | b']' | b',' | b':' | b'"' | b'0'..=b'9'))
        .map(|(place, _)| place)
        .collect();
    let place = if tokens.is_empty() { 0 } else { tokens[draw.below(tokens.len())] };
    let insert = |bytes: &mut Vec<u8>, place: usize, what: &[u8]| {
        bytes.splice(place.min(bytes.len())..place.min(bytes.len()), what.iter().copied());
    };
    match draw.below(17) {
        // Half of a pair of surrogates, or a pair the wrong way round, in a string.
        14..=16 => {
            let quotes: Vec<usize> = (0..bytes.len()).filter(|at| bytes[*at] == b'"').collect();
            let Some(place) = quotes.get(draw.below(quotes.len())).copied() else { return bytes };
            let half = draw.pick(&["\\ud800", "\\uDFFF", "\\udc00\\ud800", "\\ud83dx", "\\uD83D\\u0041"]);
            insert(&mut bytes, place + draw.below(2), half.as_bytes());
        }
        // Within an escape, or a number.
        12 | 13 => {
            let sites: Vec<usize> = bytes
                .iter()
                .enumerate()
                .filter(|(_, byte)| matches!(byte, b'\\' | b'.' | b'e' | b'E' | b'-'))
                .map(|(place, _)| place)
                .collect();
            let Some(place) = sites.get(draw.below(sites.len())).copied() else { return bytes };
            let place = (place + draw.below(7)).min(bytes.len() - 1);
            match draw.below(3) {
                0 => drop(bytes.remove(place)),
                1 => bytes[place] = draw.one(b"+-0.eEuxg \t\"\\"),
                _ => bytes.insert(place, draw.one(b"+-0.eE \r")),
            }
        }
        0 => {
            bytes.remove(place.min(bytes.len().saturating_sub(1)));
        }
        1 => {
            bytes.truncate(place);
            if draw.chance(8) {
                break_off(&mut bytes, draw);
            }
        }
        2 => {
            let what =
                draw.pick(&[",", ":", "}", "]", "{", "[", "\"", "0", "-", "+", ".", "\\", "/**/", "\u{0}", "\u{b}"]);
            insert(&mut bytes, place, what.as_bytes());
        }
        3 => {
            let what = draw.pick(&["x", "{}", ",", "\u{0}", "\u{feff}", "\u{a0}", "null", "]", " {}"]);
            // Or the beginning of a character.
            let begun: &[u8] = draw.one(&[&b"\xc3"[..], b"\xe2\x82", b"\xf0\x9f\x98", b" \xc3"]);
            if draw.chance(20) {
                // Where a reader that looks for the end in blocks has stopped.
                let blanks = draw.size(1, 70_000);
                bytes.extend(std::iter::repeat_n(draw.one(b" \t\n\r"), blanks));
            }
            bytes.extend_from_slice(if draw.chance(30) { begun } else { what.as_bytes() });
        }
        4 if draw.chance(50) => {
            // What is a blank elsewhere, at both ends or at one.
            let blank = draw.pick(&["\u{b}", "\u{c}", "\u{0}", "\u{85}", "\u{a0}", "\u{1c}", "\u{1f}", "\u{2028}"]);
            if draw.chance(60) {
                bytes.extend_from_slice(blank.as_bytes());
            }
            if draw.chance(60) {
                insert(&mut bytes, 0, blank.as_bytes());
            }
        }
        4 => insert(&mut bytes, 0, draw.pick(&["x", "[", "\u{a0}", "\u{c}", ",", "//\n"]).as_bytes()),
        5 => {
            insert(&mut bytes, place, draw.pick(&["\u{a0}", "\u{c}", "\u{2028}", "\u{1680}", "NaN", "nul"]).as_bytes());
        }
        // A byte that no UTF-8 has there.
        6 | 7 => {
            let what: &[u8] = [
                &b"\xff"[..],
                b"\xc0\x80",
                b"\xed\xa0\x80",
                b"\xf4\x90\x80\x80",
                b"\x80",
                b"\xe2\x82",
                b"\xf8\x88\x80\x80\x80",
            ][draw.below(7)];
            insert(&mut bytes, place, what);
        }
        // A member twice, its name as it is or escaped.
        8..=10 => {
            let text = String::from_utf8_lossy(&bytes).into_owned();
            if let Some(name) = text
                .find('"')
                .and_then(|from| text[from + 1..].find('"').map(|length| text[from + 1..from + 1 + length].to_owned()))
            {
                let again = match name.chars().next().filter(|c| draw.chance(50) && c.is_ascii_alphabetic()) {
                    Some(first) => format!("\\u{:04x}{}", first as u32, &name[1..]),
                    None => name,
                };
                let value = draw.pick(&["null", "1", "\"estop\"", "{}"]);
                let end = text.rfind('}').unwrap_or(text.len());
                insert(&mut bytes, end, format!(",\"{again}\":{value}").as_bytes());
            }
        }
        _ => {
            if let Some(byte) = bytes.get_mut(place) {
                *byte = byte.wrapping_add(u8::try_from(draw.below(255)).unwrap_or(1).max(1));
            }
        }
    }
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fuzz::harvest::Harvest;

    #[test]
    fn a_frame_may_break_off_behind_a_long_string_of_escaped_quotation_marks() {
        let (frame, harvest) = (object([("kind", text("close_session"))]), Harvest::default());
        let is_drawn = |number: &u64| {
            let bytes = corrupted(&frame, &mut Draw::new(3, *number, &harvest));
            bytes.len() > 20_000
                && bytes.ends_with(b"\\\"\\\"\\\"")
                && Json::parse(&String::from_utf8_lossy(&bytes)).is_err()
        };
        let drawn = (0..4000).filter(is_drawn).count();
        assert!((1..40).contains(&drawn), "{drawn}");
    }

    #[test]
    fn a_crowd_is_as_large_as_a_limit_one_larger_or_more_than_sixteen_bits_count() {
        let harvest = Harvest::default();
        let drawn: std::collections::HashSet<usize> =
            (0..2000).map(|number| crowd(&mut Draw::new(3, number, &harvest))).collect();
        assert!([4096, 4097].iter().all(|count| drawn.contains(count)), "{drawn:?}");
        assert!(drawn.iter().filter(|count| (65_536..69_632).contains(*count)).count() > 10, "{drawn:?}");
    }

    #[test]
    fn a_frame_in_another_order_has_the_same_members_at_every_level() {
        let harvest = Harvest::default();
        let inner = object([("x", int(1)), ("y", int(2)), ("z", int(3))]);
        let frame = object([("kind", text("sensor_frame")), ("a", inner.clone()), ("b", list(vec![inner]))]);
        let sorted = |tree: &Tree| serde_json::from_str::<serde_json::Value>(&tree.to_string()).unwrap();
        let mut orders = std::collections::HashSet::new();
        for number in 0..200 {
            let mut turned = frame.clone();
            reorder(&mut turned, &mut Draw::new(3, number, &harvest));
            assert_eq!(sorted(&turned), sorted(&frame));
            orders.insert(turned.to_string());
        }
        assert!(orders.len() > 30, "{}", orders.len());
    }

    #[test]
    fn a_frame_of_another_kind_holds_the_expected_kind_within_before_its_own() {
        let harvest = Harvest::default();
        let stimulus = object([("t", literal("1.0"))]);
        let frame = object([("kind", text("stimulus_frame")), ("stimulus", stimulus)]);
        let is_drawn = |number: &u64| {
            let mut frame = frame.clone();
            wrong_value(&mut frame, &mut Draw::new(3, *number, &harvest));
            let within = frame.get("stimulus").and_then(|inner| inner.get("kind")).and_then(Json::as_str);
            let own = frame.get("kind").and_then(Json::as_str);
            within == Some("stimulus_frame") && own != within
        };
        let drawn = (0..4000).filter(is_drawn).count();
        assert!(drawn > 10, "{drawn}");
    }
}
