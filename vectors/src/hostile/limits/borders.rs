//! What is wrong just where a reader that takes a frame piece by piece ends a piece: 64 KiB and 1 MiB are multiples of
//! most lengths of pieces.

use super::MIB;
use crate::case::Case;
use crate::json::object;
use crate::model::{explicit, meaning, minimal};
use crate::roles::{a, readers};
use crate::template::Text;

pub(super) fn cases() -> Vec<Case> {
    let mut cases = cut_characters();
    cases.extend(behind_white_space());
    cases.extend(longer_names());
    cases
}

const KIB_64: usize = 1 << 16;

/// A kind of frame, and a border within it, behind which as much follows.
const BORDERS: [(&str, usize); 2] = [("sensor_frame", KIB_64), ("observation_frame", MIB)];

/// Characters of which only one side of the border has a part; all else are letters.
fn cut_characters() -> Vec<Case> {
    let table: [(&str, &[u8], &[u8], &str); 5] = [
        ("first-of-two", b"\xc3", b"", "the first byte of a character of two before it"),
        ("first-of-three", b"\xe2", b"", "the first byte of a character of three before it"),
        ("two-of-three", b"\xe2\x82", b"", "the first two bytes of a character of three before it"),
        ("three-of-four", b"\xf0\x9f\x98", b"", "the first three bytes of a character of four before it"),
        ("last-of-two", b"", b"\xa9", "the last byte of a character of two behind it"),
    ];
    let case = |(kind, border): (&str, usize), (what, before, behind, says): (&str, &[u8], &[u8], &str)| {
        let frame = minimal(kind).text();
        let open = format!("{},\"pad\":\"", frame.strip_suffix('}').unwrap_or(&frame));
        // In base64, three bytes are four characters.
        let open = open.clone() + filled(open.len());
        let letters = border - before.len() - open.len();
        let amid = [&b"xxx"[..letters % 3], before, behind].concat();
        let amid = [&amid, filled(amid.len()).as_bytes()].concat();
        let bytes = Text::concat([
            Text::base64_of(open.as_bytes()),
            Text::repeat("eHh4", letters / 3),
            Text::base64_of(&amid),
            Text::repeat("eHh4", border / 3),
            Text::base64_of(b"\"}"),
        ]);
        Case::new(format!("{kind}/at-a-border/{what}"), &["NCP-WIRE-001"], readers(kind))
            .title(format!("{} of letters that has {says}, {border} bytes from its beginning, is rejected.", a(kind)))
            .flags(&["invalid-utf8"])
            .call("decode", object! { "kind" => kind, "base64" => bytes })
            .rejects("malformed")
            .because("By what pieces a receiver reads a frame makes no difference.")
    };
    BORDERS.into_iter().flat_map(|border| table.map(|row| case(border, row))).collect()
}

/// What is missing to the next triple of letters.
fn filled(length: usize) -> &'static str {
    &"xxx"[..length.next_multiple_of(3) - length]
}

/// An object, white space up to the border, and something that may not stand there.
fn behind_white_space() -> Vec<Case> {
    let table = [
        ("brace", "}", "a brace", "NCP-WIRE-002"),
        ("letter", "x", "a letter", "NCP-WIRE-002"),
        ("nul", "\0", "U+0000", "NCP-WIRE-002"),
        ("object", "{}", "a second object", "NCP-WIRE-004"),
    ];
    let case = |(kind, border): (&str, usize), (what, more, says, rule): (&str, &str, &str, &'static str)| {
        let frame = minimal(kind).text();
        let text = Text::concat([frame.clone().into(), Text::repeat(" ", border - frame.len()), more.into()]);
        Case::new(format!("{kind}/at-a-border/behind-white-space/{what}"), &[rule], readers(kind))
            .title(format!(
                "{} with {says} behind white space, {border} bytes from its beginning, is rejected.",
                a(kind)
            ))
            .flags(&["lenient-grammar"])
            .decode(kind, text)
            .rejects("malformed")
            .because("Only white space may stand behind the object, however much of it there is.")
    };
    let borders = [("close_session", KIB_64), BORDERS[1]];
    borders.into_iter().flat_map(|border| table.map(|row| case(border, row))).collect()
}

/// Unknown members whose names begin with those of all fields, and are longer by what a narrow integer drops.
fn longer_names() -> Vec<Case> {
    let longer = |kind: &str, by: usize| {
        let frame = explicit(kind);
        let text = frame.text();
        let mut parts = vec![Text::from(text.strip_suffix('}').unwrap_or(&text))];
        for (name, _) in frame.members() {
            parts.extend([format!(",\"{name}").into(), Text::repeat("_", by), "\":[true]".into()]);
        }
        parts.push("}".into());
        Case::new(format!("{kind}/longer-names/by-{by}"), &["NCP-WIRE-026"], readers(kind))
            .title(format!(
                "{} with unknown members whose names are those of its fields and {by} characters more is read as one \
                 without them.",
                a(kind)
            ))
            .flags(&["nul-terminated-names"])
            .decode(kind, Text::concat(parts))
            .means(meaning(kind, &frame).text())
            .because("A receiver ignores a member that the tables do not list, and a longer name is another.")
    };
    let kinds = ["sensor_frame", "command_frame", "open_session", "session_opened", "observation_frame"];
    kinds.into_iter().flat_map(|kind| [256, KIB_64].map(|by| longer(kind, by))).collect()
}
