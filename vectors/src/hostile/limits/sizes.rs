//! Frames of 1 MiB and a byte more, larger ones, and what a reader of pieces would cut in two.

use super::stretch::{Side, outside, padded, padded_before, spaced};
use super::{LEVELS, MIB, OBSERVATION};
use crate::case::Case;
use crate::json::{Json, object};
use crate::model::{explicit, meaning, minimal};
use crate::roles::{ANY, a, readers};
use crate::template::Text;
use ncp_text::tables::tables;

pub(super) fn cases() -> Vec<Case> {
    let mut cases = sizes();
    cases.extend(observation_sizes());
    cases.extend(large());
    cases.extend(large_and_broken());
    cases.extend(larger_and_broken());
    cases.extend(across_pieces());
    cases.extend(escapes_across_pieces());
    cases.extend(endless());
    cases
}

/// Frames of 1 MiB and of a byte more.
fn sizes() -> Vec<Case> {
    let mut cases = Vec::new();
    let kinds = tables().messages.iter().filter_map(|message| message.kind.as_deref());
    for kind in kinds.filter(|kind| *kind != "observation_frame") {
        cases.push(
            too_large(kind, "padded", padded(&minimal(kind).text(), MIB + 1, "x"))
                .title(format!("{} of 1 MiB and a byte is rejected.", a(kind))),
        );
    }
    for kind in ANY {
        let frame = explicit(kind).text();
        cases.push(
            too_large(kind, "padded-with-two-bytes", padded(&minimal(kind).text(), MIB + 1, "\u{e9}"))
                .flags(&["bytes-not-characters"])
                .title(format!("{} of 1 MiB and a byte is rejected, though it has half as many characters.", a(kind))),
        );
        cases.push(
            too_large(kind, "white-space", spaced(&minimal(kind).text(), MIB + 1))
                .title(format!("{} of 1 MiB and a byte, most of it white space, is rejected.", a(kind))),
        );
        for (what, side) in [("before", Side::Before), ("after", Side::After)] {
            let text = outside(&minimal(kind).text(), MIB + 1, side);
            cases.push(
                too_large(kind, &format!("white-space-{what}"), text).flags(&["bytes-outside-the-object"]).title(
                    format!("{} of 1 MiB and a byte, most of it white space {what} the object, is rejected.", a(kind)),
                ),
            );
        }
        let table = [
            ("padded", padded(&frame, MIB, "x"), "of exactly 1 MiB"),
            ("padded-with-two-bytes", padded(&frame, MIB, "\u{e9}"), "of exactly 1 MiB in half as many characters"),
            ("white-space", spaced(&frame, MIB), "of exactly 1 MiB, most of it white space,"),
            (
                "white-space-before",
                outside(&frame, MIB, Side::Before),
                "of exactly 1 MiB, most of it white space before the object,",
            ),
            (
                "white-space-after",
                outside(&frame, MIB, Side::After),
                "of exactly 1 MiB, most of it white space after the object,",
            ),
        ];
        for (what, text, says) in table {
            cases.push(
                Case::new(format!("{kind}/size/{what}-at-limit"), &["NCP-WIRE-061"], readers(kind))
                    .title(format!("{} {says} is read.", a(kind)))
                    .flags(&["low-limits"])
                    .decode(kind, text)
                    .means(meaning(kind, &explicit(kind)).text())
                    .because(
                        "A frame at the limit is read; its bytes count, white space and ignored members included.",
                    ),
            );
        }
    }
    cases
}

/// Observation frames may be larger.
fn observation_sizes() -> Vec<Case> {
    let kind = "observation_frame";
    let frame = explicit(kind).text();
    let of_escapes = frame.replace("\"observation_frame\"", "\"observation\\u005fframe\"");
    let read = |what: &str, text: Text| {
        Case::new(format!("{kind}/size/{what}"), &["NCP-WIRE-063"], readers(kind))
            .flags(&["low-limits"])
            .decode(kind, text)
            .means(meaning(kind, &explicit(kind)).text())
            .because("An `observation_frame` may have 64 MiB.")
    };
    vec![
        read("beyond-1-mib", padded(&frame, MIB + 1, "x")).title("An `observation_frame` of 1 MiB and a byte is read."),
        read("white-space-beyond-1-mib", spaced(&frame, 2 * MIB))
            .title("An `observation_frame` of 2 MiB, most of it white space, is read."),
        read("kind-of-escapes-beyond-1-mib", padded(&of_escapes, 2 * MIB, "x"))
            .title("An `observation_frame` of 2 MiB whose kind stands in it only with an escape is read."),
        read("kind-of-escapes-behind-1-mib", padded_before(&of_escapes, 2 * MIB))
            .title("An `observation_frame` of 2 MiB whose kind stands behind most of it, with an escape, is read."),
        read("at-limit", padded(&frame, OBSERVATION, "x"))
            .flags(&["slow"])
            .title("An `observation_frame` of exactly 64 MiB is read."),
        Case::new(format!("{kind}/size/beyond-limit"), &["NCP-WIRE-062"], readers(kind))
            .title("An `observation_frame` of 64 MiB and a byte is rejected.")
            .flags(&["missing-limits", "slow"])
            .decode(kind, padded(&minimal(kind).text(), OBSERVATION + 1, "x"))
            .rejects("limit")
            .because("An `observation_frame` may have 64 MiB, and this one has a byte more."),
        Case::new(format!("{kind}/size/beyond-limit-of-two"), &["NCP-WIRE-062"], readers(kind))
            .title("An `observation_frame` of more than 64 MiB, most of it characters of two bytes, is rejected.")
            .flags(&["bytes-not-characters", "slow"])
            .decode(kind, padded(&minimal(kind).text(), OBSERVATION + 64, "\u{e9}"))
            .rejects("limit")
            .because("An `observation_frame` may have 64 MiB, and bytes count, not characters."),
    ]
}

/// What is told from its neighbours in a small frame, in frames of 64 and 256 KiB and more: a reader for large frames
/// is no other reader.
fn large() -> Vec<Case> {
    // A member, its value as it is spelled, the rule, and what is special about it. `seq` is written twice.
    let table: [(&str, &str, &str, &'static str, &str); 14] = [
        ("overflow", "t", "1e999", "NCP-WIRE-013", "overflows a double"),
        ("minus-overflow", "t", "-1e309", "NCP-WIRE-013", "overflows a double downwards"),
        ("fraction", "seq", "1.0", "NCP-WIRE-010", "has a fraction"),
        ("minus-zero-integer", "seq", "-0", "NCP-WIRE-010", "is the negative zero"),
        ("beyond-2-to-53", "seq", "9007199254740992", "NCP-WIRE-011", "is 2^53"),
        ("text", "t", "\"1\"", "NCP-WIRE-020", "is a text"),
        ("repeated", "seq", "1,\"seq\":1", "NCP-WIRE-007", "stands there twice"),
        ("minus-zero", "t", "-0", "NCP-WIRE-015", "is the negative zero"),
        ("largest", "t", "1.7976931348623157e308", "NCP-WIRE-012", "is the largest double"),
        (
            "many-digits",
            "t",
            "0.1000000000000000055511151231257827021181583404541015625",
            "NCP-WIRE-012",
            "has 55 digits",
        ),
        ("largest-integer", "seq", "9007199254740991", "NCP-WIRE-034", "is the largest integer"),
        ("rounded-once", "t", "9007199254740993e1", "NCP-WIRE-012", "has more than 53 bits and a power of ten"),
        ("rounded-once-by-decimals", "t", "90071992547.40995", "NCP-WIRE-012", "has more than 53 bits and decimals"),
        (
            "rounded-once-by-a-negative-power",
            "t",
            "-1152921504606847105e-18",
            "NCP-WIRE-012",
            "has more than 53 bits and a negative power of ten",
        ),
    ];
    let sizes: [(&str, &[usize]); 3] = [
        ("sensor_frame", &[(64 << 10) + 1, (256 << 10) + 1, MIB]),
        ("command_frame", &[(512 << 10) + 1]),
        ("observation_frame", &[(256 << 10) + 1, 2 * MIB, 5 * MIB]),
    ];
    let mut cases = Vec::new();
    for (kind, sizes) in sizes {
        for (nth, size) in sizes.iter().enumerate() {
            // The last of the numbers in one size of a kind.
            let shown = if nth == 0 && kind != "observation_frame" { table.len() } else { table.len() - ROUNDED };
            for (what, member, value, rule, says) in table.into_iter().take(shown) {
                let frame = |ground: Json| ground.with(member, Json::literal(value));
                let is_read = matches!(rule, "NCP-WIRE-015" | "NCP-WIRE-012" | "NCP-WIRE-034");
                // A sample of what is read for the largest.
                if is_read && *size > 4 * MIB && what != "minus-zero" {
                    continue;
                }
                let whole = if is_read { frame(explicit(kind)) } else { frame(minimal(kind)) };
                // Behind what matters, and before it.
                let text = match nth % 2 {
                    0 => padded(&whole.text(), *size, "x"),
                    _ => padded_before(&whole.text(), *size),
                };
                let verb = if is_read { "read as it is" } else { "rejected" };
                let case = Case::new(format!("{kind}/large/{what}-in-{size}-bytes"), &[rule], readers(kind))
                    .title(format!("{} of {size} bytes whose `{member}` {says} is {verb}.", a(kind)))
                    .decode(kind, text)
                    .because("What a frame means, and whether it is read, does not depend on its length.");
                cases.push(match is_read {
                    true => case.flags(&["rounding"]).means(meaning(kind, &whole).text()),
                    false => case.flags(&["overflow"]).rejects("value"),
                });
            }
        }
    }
    cases
}

/// How many of these are numbers that have to be rounded once.
const ROUNDED: usize = 3;

/// What is no frame for its bytes or its grammar, in frames of many sizes: a reader for large frames is no other
/// reader.
fn large_and_broken() -> Vec<Case> {
    let sizes = [
        ("sensor_frame", 70_000_usize),
        ("command_frame", 300_000),
        ("close_session", 1_000_000),
        ("observation_frame", 2 * MIB),
    ];
    // Behind a long string: the rest of it, and of the frame.
    let table: [(&str, &[u8], &'static str, &str); 6] = [
        ("ff", b"\xff\"}", "NCP-WIRE-001", "the byte FF in a string"),
        ("overlong-slash", b"\xc0\xaf\"}", "NCP-WIRE-001", "a slash in two bytes"),
        ("raw-line-feed", b"\n\"}", "NCP-WIRE-002", "a line feed as it is in a string"),
        ("bad-escape", br#"\x41"}"#, "NCP-WIRE-002", "an escape that is none"),
        ("trailing-comma", br#"",}"#, "NCP-WIRE-002", "a trailing comma"),
        ("second-object", br#""}{}"#, "NCP-WIRE-004", "a second object behind it"),
    ];
    let mut cases = Vec::new();
    for (kind, size) in sizes {
        // A sample for the larger ones.
        let is_whole = size < 100_000;
        let sample = table.into_iter().filter(|(what, ..)| is_whole || matches!(*what, "ff" | "raw-line-feed"));
        for (what, end, rule, says) in sample {
            let frame = minimal(kind).text();
            let mut before = format!("{},\"pad\":\"", frame.strip_suffix('}').unwrap_or(&frame));
            // In base64, three bytes are four characters.
            before.push_str(&"x".repeat(before.len().next_multiple_of(3) - before.len()));
            let bytes = Text::concat([
                Text::base64_of(before.as_bytes()),
                Text::repeat("eHh4", (size - before.len()) / 3),
                Text::base64_of(end),
            ]);
            cases.push(
                Case::new(format!("{kind}/large/{what}"), &[rule], readers(kind))
                    .title(format!("{} of about {size} bytes with {says} is rejected.", a(kind)))
                    .flags(&[if rule == "NCP-WIRE-001" { "invalid-utf8" } else { "lenient-grammar" }])
                    .call("decode", object! { "kind" => kind, "base64" => bytes })
                    .rejects("malformed")
                    .because("Whether a frame is read does not depend on its length."),
            );
        }
    }
    cases
}

/// Frames of a megabyte that break off: who looks again from each place at what is missing takes hours for one.
fn endless() -> Vec<Case> {
    let brackets = format!("\"pad\":\"{}", "[".repeat(LEVELS + 1));
    let table: [(&str, &str, &str, &str); 7] = [
        ("quotes-behind-brackets", &brackets, r#"\""#, "a string of brackets and escaped quotation marks"),
        ("quotes", r#""pad":""#, r#"\""#, "a string of escaped quotation marks"),
        ("backslashes", r#""pad":""#, r"\\", "a string of escaped backslashes"),
        ("letters", r#""pad":""#, "xx", "a string of letters"),
        ("spaces", r#""pad":"#, "  ", "spaces"),
        ("digits", r#""pad":"#, "11", "digits"),
        ("points", r#""pad":0."#, "00", "zeros behind a decimal point"),
    ];
    let mut cases = Vec::new();
    for kind in ["close_session", "command_frame", "sensor_frame"] {
        let frame = minimal(kind).text();
        let open = frame.strip_suffix('}').unwrap_or(&frame);
        for (what, before, unit, says) in table {
            let text = Text::concat([format!("{open},{before}").into(), Text::repeat(unit, 500_000)]);
            cases.push(
                Case::new(format!("{kind}/endless/{what}"), &["NCP-WIRE-002"], readers(kind))
                    .title(format!("{} that breaks off behind a megabyte of {says} is rejected.", a(kind)))
                    .flags(&["lenient-grammar"])
                    .decode(kind, text)
                    .rejects("malformed")
                    .because("What is no JSON is rejected however long it is, and a receiver reads it once."),
            );
        }
    }
    cases
}

/// What shows only by both ends of a frame of 5 MiB, or behind all of it.
fn larger_and_broken() -> Vec<Case> {
    let kind = "observation_frame";
    let frame = minimal(kind).text();
    let open = frame.strip_suffix('}').unwrap_or(&frame);
    let nested = format!("{}0{}", "[".repeat(LEVELS), "]".repeat(LEVELS));
    // What stands around the letters, behind the frame's first members.
    let table: [(&str, &str, &str, &'static str, &str); 6] = [
        ("repeated-around", r#""seq":1,"pad":""#, r#"","seq":1}"#, "NCP-WIRE-007", "a member on both sides of them"),
        (
            "repeated-record-around",
            r#""records":{"a":{},"b":{"port":""#,
            r#""},"a":{}}}"#,
            "NCP-WIRE-007",
            "a record on both sides of them",
        ),
        ("pin", r#""pad":""#, r#"","is_simulation_output":false}"#, "NCP-PROV-002", "a broken pin behind them"),
        ("line-feed", r#""pad":""#, "\n\"}", "NCP-WIRE-002", "a line feed as it is at their end"),
        ("second-object", r#""pad":""#, r#""}{}"#, "NCP-WIRE-004", "a second object behind them"),
        ("levels", r#""pad":""#, &format!("\",\"novel\":{nested}}}"), "NCP-WIRE-064", "65 levels behind them"),
    ];
    let case = |(what, before, after, rule, says): (&str, &str, &str, &'static str, &str)| {
        let text = Text::concat([format!("{open},{before}").into(), Text::repeat("x", 5 * MIB), after.into()]);
        Case::new(format!("{kind}/larger/{what}"), &[rule], readers(kind))
            .title(format!("{} of 5 MiB of letters with {says} is rejected.", a(kind)))
            .flags(&[match rule {
                "NCP-WIRE-007" => "duplicate-members",
                "NCP-WIRE-064" => "missing-limits",
                "NCP-PROV-002" => "unchecked-pins",
                _ => "lenient-grammar",
            }])
            .decode(kind, text)
            .rejects("malformed")
            .because("Whether a frame is read does not depend on its length.")
    };
    table.map(case).into()
}

/// A kind of frame, and the size of one that has to be read in pieces.
const IN_PIECES: [(&str, usize); 3] =
    [("command_frame", 200_000), ("sensor_frame", 900_000), ("observation_frame", 5 * MIB)];

/// Characters of which one lies across each border of the pieces that a reader may cut a frame into: their widths are
/// multiples of 3, and no power of 2 or 10 is one. Where widths are mixed, one lies across many of the borders.
fn across_pieces() -> Vec<Case> {
    let table = [
        ("three-bytes", "\u{20ac}", "characters of three bytes"),
        ("escapes", "\\u20ac", "escaped characters"),
        ("pairs", "\\ud83d\\ude00", "escaped characters of two halves"),
        ("all-widths", "\u{1f600}\u{20ac}\u{e9}", "characters of four, three and two bytes"),
    ];
    let mut cases = Vec::new();
    for (kind, size) in IN_PIECES {
        for (what, unit, says) in table {
            let rules: &[_] = if size > MIB { &["NCP-WIRE-063", "NCP-WIRE-034"] } else { &["NCP-WIRE-034"] };
            // Behind a whole number of units, counted from the beginning of the frame.
            cases.push(
                in_pieces((kind, size), what, rules, unit, 0, "\"}")
                    .title(format!("{} of about {size} bytes, most of them {says}, is read.", a(kind)))
                    .because("By what pieces a receiver reads a frame makes no difference."),
            );
        }
    }
    cases
}

/// Escapes of which each border of the pieces that a reader may cut a frame into leaves a half, since all of them begin
/// at odd places; and brackets behind them that are within strings.
fn escapes_across_pieces() -> Vec<Case> {
    let table = [("quotes", "\\\"", "escaped quotes"), ("backslashes", "\\\\", "escaped backslashes")];
    let brackets = "[".repeat(LEVELS + 6);
    let behind = format!("{brackets}\",\"more\":\"{brackets}\"}}");
    let mut cases = Vec::new();
    for (kind, size) in IN_PIECES {
        for (what, unit, says) in table {
            cases.push(
                in_pieces((kind, size), what, &["NCP-WIRE-065", "NCP-WIRE-034"], unit, 1, &behind)
                    .title(format!(
                        "{} of about {size} bytes, most of them {says}, and with brackets in its strings is read.",
                        a(kind)
                    ))
                    .because("Brackets within a string are no levels, by what pieces ever a receiver reads a frame."),
            );
        }
    }
    cases
}

/// A frame whose unknown member is one unit again and again: each begins so many bytes behind a multiple of its length.
fn in_pieces(
    (kind, size): (&str, usize),
    what: &str,
    rules: &[&'static str],
    unit: &str,
    offset: usize,
    behind: &str,
) -> Case {
    let frame = explicit(kind).text();
    let mut before = format!("{},\"pad\":\"", frame.strip_suffix('}').unwrap_or(&frame));
    let from = (before.len() - offset).next_multiple_of(unit.len()) + offset;
    before.push_str(&"x".repeat(from - before.len()));
    let times = (size - before.len()) / unit.len();
    Case::new(format!("{kind}/across-pieces/{what}"), rules, readers(kind))
        .flags(&["low-limits"])
        .decode(kind, Text::concat([before.into(), Text::repeat(unit, times), behind.into()]))
        .means(meaning(kind, &explicit(kind)).text())
}

pub(super) fn too_large(kind: &str, what: &str, text: Text) -> Case {
    Case::new(format!("{kind}/size/{what}-beyond-limit"), &["NCP-WIRE-060"], readers(kind))
        .flags(&["missing-limits"])
        .decode(kind, text)
        .rejects("limit")
        .because("Every kind but `observation_frame` may have 1 MiB, and this frame has a byte more.")
}
