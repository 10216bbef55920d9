//! Bytes: what is UTF-8 and what is not, byte order marks, and characters in strings.

use super::{CARRIERS, with_raw};
use crate::case::{Case, File};
use crate::json::Json;
use crate::model::{explicit, meaning, minimal};
use crate::roles::{a, readers};
use crate::wire::READ;

pub(super) fn file() -> File {
    let mut cases = Vec::new();
    for kind in CARRIERS {
        cases.extend(not_utf8(kind));
        cases.extend(other_encodings(kind));
        cases.extend(marks(kind));
    }
    cases.extend(strings());
    cases.extend(in_known_strings());
    let about = "Frames that are not UTF-8, byte order marks, and strings with every width of character.";
    File::new("hostile", "encoding", about, cases)
}

/// Sequences that UTF-8 does not have.
const NOT_UTF8: &[(&str, &[u8], &str)] = &[
    ("ff", b"\xff", "the byte FF"),
    ("fe", b"\xfe", "the byte FE"),
    ("lone-continuation", b"\x80", "a continuation byte alone"),
    ("two-continuations", b"\xbf\x80", "two continuation bytes"),
    ("latin-1", b"caf\xe9", "an e acute in Latin-1"),
    ("truncated-2", b"\xc3", "two bytes of which the second is missing"),
    ("truncated-3", b"\xe2\x82", "three bytes of which the third is missing"),
    ("truncated-4", b"\xf0\x9f\x98", "four bytes of which the fourth is missing"),
    ("bad-continuation-2", b"\xc3\x28", "two bytes of which the second is a bracket"),
    ("bad-continuation-3", b"\xe2\x28\xa1", "three bytes of which the second is a bracket"),
    ("bad-continuation-4", b"\xf0\x9f\x28\x80", "four bytes of which the third is a bracket"),
    ("overlong-nul", b"\xc0\x80", "U+0000 in two bytes"),
    ("overlong-slash", b"\xc0\xaf", "a slash in two bytes"),
    ("overlong-quote", b"\xc0\xa2", "a quote in two bytes"),
    ("overlong-2-last", b"\xc1\xbf", "U+007F in two bytes"),
    ("overlong-3", b"\xe0\x80\xaf", "a slash in three bytes"),
    ("overlong-3-last", b"\xe0\x9f\xbf", "U+07FF in three bytes"),
    ("overlong-4", b"\xf0\x80\x80\xaf", "a slash in four bytes"),
    ("overlong-4-last", b"\xf0\x8f\xbf\xbf", "U+FFFF in four bytes"),
    ("surrogate-high", b"\xed\xa0\x80", "the surrogate U+D800"),
    ("surrogate-low", b"\xed\xbf\xbf", "the surrogate U+DFFF"),
    ("surrogate-pair", b"\xed\xa0\xbd\xed\xb8\x80", "U+1F600 as two surrogates of three bytes (CESU-8)"),
    ("beyond-unicode", b"\xf4\x90\x80\x80", "U+110000"),
    ("lead-f5", b"\xf5\x80\x80\x80", "four bytes that begin with F5"),
    ("five-bytes", b"\xf8\x88\x80\x80\x80", "a sequence of five bytes"),
    ("six-bytes", b"\xfc\x84\x80\x80\x80\x80", "a sequence of six bytes"),
];

fn not_utf8(kind: &str) -> Vec<Case> {
    let mut cases = Vec::new();
    let around = |mark: &str| {
        let text = with_raw(&minimal(kind).text(), mark);
        let (before, after) = text.split_once('%').unwrap_or((&text, ""));
        (before.as_bytes().to_vec(), after.as_bytes().to_vec())
    };
    let reject = |what: String, bytes: &[u8], title: String| {
        Case::new(format!("{kind}/{what}"), &["NCP-WIRE-001"], readers(kind))
            .title(title)
            .flags(&["invalid-utf8"])
            .decode_bytes(kind, bytes)
            .rejects("malformed")
            .because("The bytes are no UTF-8; that nobody looks at the member makes no difference.")
    };
    for (what, bytes, says) in NOT_UTF8 {
        let (before, after) = around(r#""novel":"%""#);
        cases.push(reject(
            format!("value/{what}"),
            &[&before, *bytes, &after].concat(),
            format!("{} with {says} within a string is rejected.", a(kind)),
        ));
    }
    for (what, bytes, says) in
        NOT_UTF8.iter().filter(|(what, ..)| matches!(*what, "ff" | "overlong-slash" | "surrogate-high"))
    {
        let (before, after) = around(r#""no%vel":1"#);
        cases.push(reject(
            format!("name/{what}"),
            &[&before, *bytes, &after].concat(),
            format!("{} with {says} within a member's name is rejected.", a(kind)),
        ));
    }
    // Behind the frame, where a reader that waits for the rest of a character has read it whole.
    for (what, bytes, says) in
        NOT_UTF8.iter().filter(|(what, ..)| matches!(*what, "ff" | "truncated-2" | "truncated-4"))
    {
        let frame = minimal(kind).text();
        cases.push(reject(
            format!("behind/{what}"),
            &[frame.as_bytes(), *bytes].concat(),
            format!("{} with {says} behind it is rejected.", a(kind)),
        ));
    }
    cases
}

fn other_encodings(kind: &str) -> Vec<Case> {
    let text = minimal(kind).text();
    let units: Vec<u16> = text.encode_utf16().collect();
    let little: Vec<u8> = units.iter().flat_map(|unit| unit.to_le_bytes()).collect();
    let big: Vec<u8> = units.iter().flat_map(|unit| unit.to_be_bytes()).collect();
    let wide: Vec<u8> = text.chars().flat_map(|c| u32::from(c).to_le_bytes()).collect();
    let table = [
        ("utf-16-le", little.clone(), "NCP-WIRE-002", "in UTF-16, little-endian"),
        ("utf-16-be", big.clone(), "NCP-WIRE-002", "in UTF-16, big-endian"),
        ("utf-32-le", wide, "NCP-WIRE-002", "in UTF-32, little-endian"),
        (
            "utf-16-le-marked",
            [b"\xff\xfe".to_vec(), little].concat(),
            "NCP-WIRE-001",
            "in UTF-16, little-endian, with a byte order mark",
        ),
        (
            "utf-16-be-marked",
            [b"\xfe\xff".to_vec(), big].concat(),
            "NCP-WIRE-001",
            "in UTF-16, big-endian, with a byte order mark",
        ),
    ];
    table
        .into_iter()
        .map(|(what, bytes, rule, says)| {
            Case::new(format!("{kind}/{what}"), &[rule], readers(kind))
                .title(format!("{} {says} is rejected.", a(kind)))
                .flags(&["guessed-encodings"])
                .decode_bytes(kind, &bytes)
                .rejects("malformed")
                .because(match rule {
                    "NCP-WIRE-001" => "FE and FF stand in no UTF-8 text.",
                    _ => "As UTF-8 the bytes are letters and U+0000 in turn, and U+0000 is no part of the grammar.",
                })
        })
        .collect()
}

fn marks(kind: &str) -> Vec<Case> {
    let frame = minimal(kind).text();
    let table = [
        ("mark", format!("\u{feff}{frame}"), "NCP-WIRE-006", "behind a byte order mark"),
        ("mark-and-space", format!("\u{feff} {frame}"), "NCP-WIRE-006", "behind a byte order mark and a space"),
        ("two-marks", format!("\u{feff}\u{feff}{frame}"), "NCP-WIRE-006", "behind two byte order marks"),
        ("space-and-mark", format!(" \u{feff}{frame}"), "NCP-WIRE-002", "behind a space and U+FEFF"),
        ("mark-at-end", format!("{frame}\u{feff}"), "NCP-WIRE-004", "before U+FEFF"),
    ];
    let mut cases = Vec::new();
    for (what, text, rule, says) in table {
        let advises = rule == "NCP-WIRE-006";
        let is = if advises { "should be rejected" } else { "is rejected" };
        let case = |how: &str, rules: &[&'static str]| {
            Case::new(format!("{kind}/{what}{how}"), rules, readers(kind)).flags(&["byte-order-mark"])
        };
        let because = if advises {
            "A mark is no part of the grammar, though RFC 8259 lets a reader ignore one."
        } else {
            "U+FEFF is no white space of JSON, behind the frame or within it."
        };
        // Many conversions from bytes to text drop a mark in silence, so it travels both ways.
        cases.push(
            case("", &[rule])
                .title(format!("{} {says} {is}.", a(kind)))
                .decode(kind, text.clone())
                .rejects("malformed")
                .because(because),
        );
        cases.push(
            case("-as-bytes", &[rule])
                .title(format!("{} {says} {is} when it comes as bytes.", a(kind)))
                .decode_bytes(kind, text.as_bytes())
                .rejects("malformed")
                .because(because),
        );
        if what == "mark" {
            let read = meaning(kind, &minimal(kind)).text();
            cases.push(
                case("-if-at-all", &[READ])
                    .title(format!("{} {says} is rejected, or read as the frame behind the mark.", a(kind)))
                    .decode_bytes(kind, text.as_bytes())
                    .means_or_rejects(read)
                    .because("Who skips a mark reads the frame behind it, and nothing else."),
            );
        }
    }
    cases
}

/// Strings of unknown members and names that are fine.
fn strings() -> Vec<Case> {
    let table = [
        (
            "widths",
            "\u{7f}\u{80}\u{7ff}\u{800}\u{ffff}\u{10000}\u{10ffff}",
            "the first and last characters of each width of UTF-8",
        ),
        ("mark-within", "a\u{feff}b", "U+FEFF"),
        ("separators", "\u{2028}\u{2029}\u{85}", "line separators that JSON does not count as such"),
        ("bidirectional", "\u{202e}abc\u{2066}", "marks that turn the direction of writing"),
    ];
    let mut cases = Vec::new();
    for kind in CARRIERS {
        for (what, string, says) in table {
            let value = explicit(kind).and("novel", Json::string(string));
            let name = explicit(kind).and(string, Json::Null);
            for (place, frame, of) in [("value", value, "a string with"), ("name", name, "a member's name with")] {
                cases.push(
                    Case::new(format!("{kind}/{place}/accepted-{what}"), &["NCP-WIRE-026"], readers(kind))
                        .title(format!("{} with {of} {says} is read.", a(kind)))
                        .flags(&["over-strict"])
                        .decode(kind, frame.text())
                        .means(meaning(kind, &frame).text())
                        .because("They are well-formed UTF-8, and JSON lets them stand in a string as they are."),
                );
            }
        }
    }
    cases
}

/// Strings of known fields, in every spelling.
fn in_known_strings() -> Vec<Case> {
    let fields: [(&str, &[&str]); 3] =
        [("sensor_frame", &["frame_id"]), ("command_frame", &["frame_id"]), ("open_session", &["network", "ref"])];
    let table = [
        ("escape-letter", r"\u0041", "A", "a letter as an escape"),
        (
            "escape-upper-case-hex",
            r"\u00E9\u00e9",
            "\u{e9}\u{e9}",
            "an e acute as an escape in hexadecimal digits of either case",
        ),
        ("escape-short", r#"\"\\\/\b\f\n\r\t"#, "\"\\/\u{8}\u{c}\n\r\t", "each of the short escapes"),
        ("escape-nul", r"a\u0000b", "a\0b", "U+0000 as an escape"),
        ("escape-control", r"\u0001\u001f\u007f", "\u{1}\u{1f}\u{7f}", "control characters as escapes"),
        ("escape-pair", r"\ud83d\ude00", "\u{1f600}", "a character beyond the BMP as two escapes"),
        (
            "escape-pair-upper-case",
            r"\uD83D\uDE00",
            "\u{1f600}",
            "a character beyond the BMP as two escapes in upper case",
        ),
        ("escape-last-pair", r"\udbff\udfff", "\u{10ffff}", "U+10FFFF as two escapes"),
        ("escape-noncharacter", r"\uffff\ufffe", "\u{ffff}\u{fffe}", "noncharacters as escapes"),
        ("escaped-backslash-u", r"\\u0041", "\\u0041", "an escaped backslash before what looks like an escape"),
        (
            "pair-behind-backslash",
            r"\\\ud83d\ude00",
            "\\\u{1f600}",
            "an escaped backslash before two escapes of one character",
        ),
        (
            "pair-behind-backslashes",
            r"\\\\\ud83d\ude00",
            "\\\\\u{1f600}",
            "two escaped backslashes before two escapes of one character",
        ),
        (
            "no-pair-behind-backslashes",
            r"\\ud83d\\ude00",
            "\\ud83d\\ude00",
            "escaped backslashes before what looks like two halves",
        ),
        ("raw-delete", "\u{7f}", "\u{7f}", "U+007F as it is"),
        ("raw-separator", "\u{2028}", "\u{2028}", "U+2028 as it is"),
        ("raw-widths", "\u{e9}\u{20ac}\u{1f600}", "\u{e9}\u{20ac}\u{1f600}", "characters of two, three and four bytes"),
        ("decomposed", "e\u{301}", "e\u{301}", "a letter and its accent, not composed"),
        ("mark-first", "\u{feff}a", "\u{feff}a", "U+FEFF as its first character"),
        ("replacement", "\u{fffd}", "\u{fffd}", "the replacement character itself"),
        ("slashes", "</script>", "</script>", "a slash without an escape"),
        ("json-within", r#"{\"kind\":\"command_frame\"}"#, "{\"kind\":\"command_frame\"}", "a frame"),
    ];
    let mut cases = Vec::new();
    for (kind, path) in fields {
        for (what, spelled, is, says) in table {
            let spelled = Json::literal(format!("\"{spelled}\""));
            let frame = explicit(kind).edit(path, |_| spelled);
            let read = explicit(kind).edit(path, |_| Json::string(is));
            cases.push(
                Case::new(format!("{kind}/string/{what}"), &[READ], readers(kind))
                    .title(format!("{} whose `{}` holds {says} is read as that.", a(kind), path.join(".")))
                    .flags(&["string-escapes"])
                    .decode(kind, frame.text())
                    .means(meaning(kind, &read).text())
                    .because("An escape is the character that it names, and every other character is itself."),
            );
        }
    }
    cases
}
