//! Frames at the limits of section 1.6, and one beyond.

use super::with_raw;
use crate::case::{Case, File};
use crate::json::{Json, object};
use crate::model::{explicit, explicit_message, meaning, minimal};
use crate::roles::{ANY, a, readers};
use crate::template::Text;
use ncp_text::tables::tables;

const MIB: usize = 1 << 20;
/// The most bytes of an `observation_frame`.
const OBSERVATION: usize = 64 * MIB;
/// The most levels.
const LEVELS: usize = 64;
/// The most entries of a map and items of an array.
const ENTRIES: usize = 4096;

pub(super) fn file() -> File {
    let mut cases = sizes();
    cases.extend(observation_sizes());
    cases.extend(large());
    cases.extend(large_and_broken());
    cases.extend(larger_and_broken());
    cases.extend(across_pieces());
    cases.extend(escapes_across_pieces());
    cases.extend(endless());
    cases.extend(depths());
    cases.extend(deep_names());
    cases.extend(maps());
    cases.push(members());
    cases.extend(repeated_of_many());
    cases.extend(repeated_as_it_grows());
    cases.extend(arrays());
    cases.extend(sums());
    cases.extend(numeric_arrays());
    cases.extend(equal_numbers());
    cases.extend(small_values());
    cases.extend(long_strings());
    cases.extend(long_names());
    cases.extend(alike_in_all_places());
    cases.extend(of_one_checksum());
    cases.extend(long_enums());

    let about = "Frames at a limit, which are read, and frames beyond it, which are rejected.";
    File::new("hostile", "limits", about, cases)
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
        read("at-limit", padded(&frame, OBSERVATION, "x"))
            .flags(&["slow"])
            .title("An `observation_frame` of exactly 64 MiB is read."),
        Case::new(format!("{kind}/size/beyond-limit"), &["NCP-WIRE-062"], readers(kind))
            .title("An `observation_frame` of 64 MiB and a byte is rejected.")
            .flags(&["missing-limits", "slow"])
            .decode(kind, padded(&minimal(kind).text(), OBSERVATION + 1, "x"))
            .rejects("limit")
            .because("An `observation_frame` may have 64 MiB, and this one has a byte more."),
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

fn too_large(kind: &str, what: &str, text: Text) -> Case {
    Case::new(format!("{kind}/size/{what}-beyond-limit"), &["NCP-WIRE-060"], readers(kind))
        .flags(&["missing-limits"])
        .decode(kind, text)
        .rejects("limit")
        .because("Every kind but `observation_frame` may have 1 MiB, and this frame has a byte more.")
}

/// Levels of arrays and objects within an unknown member; the frame itself is the first level.
fn depths() -> Vec<Case> {
    let mut cases = Vec::new();
    for kind in ANY {
        let nest = |ground: &Json, open: &str, close: &str, levels: usize| {
            let frame = ground.text();
            let open_frame = frame.strip_suffix('}').unwrap_or(&frame);
            // One level is the frame's own; the innermost value is a number.
            Text::concat([
                format!("{open_frame},\"novel\":").into(),
                Text::repeat(open, levels - 1),
                "0".into(),
                Text::repeat(close, levels - 1),
                "}".into(),
            ])
        };
        let kinds = [("arrays", "[", "]"), ("objects", "{\"a\":", "}")];
        for (what, open, close) in kinds {
            cases.push(
                Case::new(format!("{kind}/depth/{what}-at-limit"), &["NCP-WIRE-065"], readers(kind))
                    .title(format!("{} of 64 levels of {what} is read.", a(kind)))
                    .flags(&["low-limits"])
                    .decode(kind, nest(&explicit(kind), open, close, LEVELS))
                    .means(meaning(kind, &explicit(kind)).text())
                    .because("The frame itself is the first level, and the unknown member has 63."),
            );
            for (name, levels) in [("beyond-limit", LEVELS + 1), ("far-beyond-limit", 1000), ("to-the-stack", 100_000)]
            {
                cases.push(
                    Case::new(format!("{kind}/depth/{what}-{name}"), &["NCP-WIRE-064"], readers(kind))
                        .title(format!("{} of {levels} levels of {what} is rejected.", a(kind)))
                        .flags(&[if levels > 1000 { "stack-overflow" } else { "missing-limits" }])
                        .decode(kind, nest(&minimal(kind), open, close, levels))
                        .rejects("limit")
                        .because(
                            "A frame may have 64 levels, in ignored members too; beyond, an error and never a crash.",
                        ),
                );
            }
        }
        let read = |what: &str, text: Text, says: &str| {
            Case::new(format!("{kind}/depth/{what}"), &["NCP-WIRE-065"], readers(kind))
                .title(format!("{} with {says} is read.", a(kind)))
                .flags(&["low-limits"])
                .decode(kind, text)
                .means(meaning(kind, &explicit(kind)).text())
                .because("Levels are nested objects and arrays, at most 64 at a time.")
        };
        let frame = explicit(kind).text();
        let open_frame = frame.strip_suffix('}').unwrap_or(&frame);
        cases.push(read(
            "brackets-in-a-string",
            Text::concat([format!("{open_frame},\"novel\":\"").into(), Text::repeat("[", 1000), "\"}".into()]),
            "a thousand brackets within a string",
        ));
        cases.push(read(
            "side-by-side",
            Text::concat([format!("{open_frame},\"novel\":[").into(), Text::repeat("[[]],", 1000), "[]]}".into()]),
            "a thousand nested arrays side by side",
        ));
        // Strings whose ends are told by their escapes, among so many brackets that the levels are counted.
        for (name, string, says) in [
            ("ends-with-escape", r#""C:\\""#, "a string that ends with a backslash"),
            ("ends-with-escapes", r#""\\\\""#, "a string of two backslashes"),
            ("quote-and-bracket", r#""a\"[[""#, "a string with brackets behind a quote"),
            ("escape-quote-bracket", r#""\\\"]]""#, "a string with brackets behind a backslash and a quote"),
            ("bracket-and-escape", r#""]]\\""#, "a string of brackets and a backslash"),
            ("escaped-quote-last", r#""[[\"""#, "a string of brackets and a quote"),
        ] {
            let text = |open_frame: &str, levels: usize| {
                let within = format!("{}{string}{}", "[".repeat(levels - 2), "]".repeat(levels - 2));
                Text::from(format!(
                    "{open_frame},\"novel\":[{string},{}{within},{string},{{{string}:[{string}]}},{string}]}}",
                    "[],".repeat(70)
                ))
            };
            cases.push(read(&format!("{name}/at-limit"), text(open_frame, LEVELS), &format!("64 levels and {says}")));
            let frame = minimal(kind).text();
            cases.push(
                Case::new(format!("{kind}/depth/{name}/beyond-limit"), &["NCP-WIRE-064"], readers(kind))
                    .title(format!("{} of 65 levels with {says} is rejected.", a(kind)))
                    .flags(&["missing-limits"])
                    .decode(kind, text(frame.strip_suffix('}').unwrap_or(&frame), LEVELS + 1))
                    .rejects("limit")
                    .because(
                        "Brackets within a string are no levels, and those behind it are, whatever its escapes are.",
                    ),
            );
        }
        // Levels of which a part is open while more brackets come and go than any block of them has.
        let crowded = |frame: &Json, levels: usize| {
            let (before, rows) = (40, 1700);
            let behind = levels - 1 - before;
            let frame = frame.text();
            let open = frame.strip_suffix('}').unwrap_or(&frame);
            Text::concat([
                format!("{open},\"novel\":{}", "[".repeat(before)).into(),
                Text::repeat(format!("[{}[]],", "[],".repeat(149)), rows),
                format!("{}{}}}", "[".repeat(behind), "]".repeat(behind + before)).into(),
            ])
        };
        cases.push(read(
            "around-a-crowd",
            crowded(&explicit(kind), LEVELS),
            "64 levels around half a million brackets",
        ));
        cases.push(
            Case::new(format!("{kind}/depth/around-a-crowd-beyond-limit"), &["NCP-WIRE-064"], readers(kind))
                .title(format!("{} of 65 levels around half a million brackets is rejected.", a(kind)))
                .flags(&["missing-limits"])
                .decode(kind, crowded(&minimal(kind), LEVELS + 1))
                .rejects("limit")
                .because("Every level counts that is open, however many brackets have come and gone within it."),
        );
        cases.push(read(
            "half-and-half",
            Text::concat([
                format!("{open_frame},\"novel\":").into(),
                Text::repeat("[{\"a\":", 31),
                "[0]".into(),
                Text::repeat("}]", 31),
                "}".into(),
            ]),
            "64 levels of arrays and objects in turn",
        ));
    }
    cases
}

/// A member name that repeats so far down, and names that do not.
fn deep_names() -> Vec<Case> {
    let mut cases = Vec::new();
    for kind in ["command_frame", "close_session"] {
        for (what, open, close) in [("arrays", "[", "]"), ("objects", "{\"a\":", "}")] {
            // The frame is a level, and the object within is the last one.
            let levels = LEVELS - 2;
            let around = |frame: &str, inner: &str| {
                Text::concat([
                    format!("{},\"novel\":", frame.strip_suffix('}').unwrap_or(frame)).into(),
                    Text::repeat(open, levels),
                    inner.into(),
                    Text::repeat(close, levels),
                    "}".into(),
                ])
            };
            cases.push(
                Case::new(format!("{kind}/depth/repeated-in-{levels}-{what}"), &["NCP-WIRE-007"], readers(kind))
                    .title(format!("{} with a member twice within {levels} unknown {what} is rejected.", a(kind)))
                    .flags(&["duplicate-members"])
                    .decode(kind, around(&minimal(kind).text(), r#"{"a":1,"a":2}"#))
                    .rejects("malformed")
                    .because("One object has one member name twice, at whatever depth it stands."),
            );
            cases.push(
                Case::new(format!("{kind}/depth/two-names-in-{levels}-{what}"), &["NCP-WIRE-065"], readers(kind))
                    .title(format!("{} with two members within {levels} unknown {what} is read.", a(kind)))
                    .flags(&["low-limits"])
                    .decode(kind, around(&explicit(kind).text(), r#"{"a":1,"b":2}"#))
                    .means(meaning(kind, &explicit(kind)).text())
                    .because("The names differ, and the frame has 64 levels at most."),
            );
        }
    }
    cases
}

/// Maps of 4,096 entries and of one more.
fn maps() -> Vec<Case> {
    let places: [(&str, &[&str], &str); 11] = [
        ("sensor_frame", &["channels"], "{}"),
        ("command_frame", &["channels"], "{}"),
        ("command_frame", &["horizon", "0"], "{}"),
        ("stimulus_frame", &["values"], "{}"),
        ("step_request", &["stimulus", "values"], "{}"),
        ("observation_frame", &["records"], "{}"),
        ("session_opened", &["resolved"], "1"),
        ("open_session", &["network", "population_sizes"], "1"),
        ("open_session", &["network", "params"], "1"),
        ("open_session", &["bindings", "0", "entity", "meta"], "\"\""),
        ("open_session", &["stimulus", "targets", "0", "params"], "1"),
    ];
    let mut cases = Vec::new();
    for (kind, path, value) in places {
        let place = path.iter().filter(|part| **part != "0").copied().collect::<Vec<_>>().join("-");
        let member = path.join(".").replace(".0", "[0]");
        let marked = |frame: Json| set(frame, path, Json::literal(MARK)).text();
        // One too many, and as many as 16 bits count as few.
        for (name, count, says) in [("limit", ENTRIES + 1, "4,097"), ("2-to-16", (1 << 16) + 1, "65,537")] {
            cases.push(
                Case::new(format!("{kind}/map/{place}-beyond-{name}"), &["NCP-WIRE-066"], readers(kind))
                    .title(format!("{} with {says} entries in `{member}` is rejected.", a(kind)))
                    .flags(&["missing-limits"])
                    .decode(kind, entries_of(&marked(minimal(kind)), value, count))
                    .rejects("limit")
                    .because("A map of the tables may have 4,096 entries."),
            );
        }
        // What a stimulus frame may have, it may have in a request.
        if path == ["stimulus", "values"] {
            continue;
        }
        let text = entries_of(&marked(explicit(kind)), value, ENTRIES);
        cases.push(
            Case::new(format!("{kind}/map/{place}-at-limit"), &["NCP-WIRE-068"], readers(kind))
                .title(format!("{} with 4,096 entries in `{member}` is read.", a(kind)))
                .flags(&["low-limits"])
                .decode(kind, text.clone())
                .means(text)
                .because("A map may have 4,096 entries; what each leaves out has its default."),
        );
    }
    cases
}

/// A message of more members than a map may have entries.
fn members() -> Case {
    const MEMBERS: usize = 4_200;
    let kind = "sensor_frame";
    // None of two characters is listed, and none of three that begins with a 1.
    let members: Vec<String> = (64..64 + MEMBERS).map(|nth| format!("\"{}\":0", base_64(nth))).collect();
    Case::new(format!("{kind}/members/{MEMBERS}"), &["NCP-WIRE-026", "NCP-WIRE-061"], readers(kind))
        .title(format!("{} with {MEMBERS} unknown members is read.", a(kind)))
        .flags(&["low-limits"])
        .decode(kind, with_raw(&explicit(kind).text(), &members.join(",")))
        .means(meaning(kind, &explicit(kind)).text())
        .because("A message is no map: nothing but the bytes of the frame limits the number of its members.")
}

/// A member that repeats in a message of more members than a map may have entries.
fn repeated_of_many() -> [Case; 2] {
    const MEMBERS: usize = 4_200;
    let kind = "sensor_frame";
    [("first", 64), ("last", 64 + MEMBERS - 1)].map(|(which, nth)| {
        let members = (64..64 + MEMBERS).chain([nth]).map(|nth| format!("\"{}\":0", base_64(nth)));
        let members: Vec<String> = members.collect();
        Case::new(format!("{kind}/members/{MEMBERS}/{which}-repeated"), &["NCP-WIRE-007"], readers(kind))
            .title(format!("{} with {MEMBERS} unknown members and the {which} of them again is rejected.", a(kind)))
            .flags(&["duplicate-members"])
            .decode(kind, with_raw(&minimal(kind).text(), &members.join(",")))
            .rejects("malformed")
            .because("One object has one member name twice, however many others it has.")
    })
}

/// A name that repeats as the last of so many, where tables of names of the usual sizes are full, and just beyond.
fn repeated_as_it_grows() -> Vec<Case> {
    const COUNTS: [usize; 20] = [3, 4, 7, 8, 9, 14, 15, 16, 17, 28, 29, 32, 33, 56, 57, 64, 65, 113, 257, 1025];
    let kind = "sensor_frame";
    let mut cases = Vec::new();
    for count in COUNTS {
        for (name, which, nth) in [("first", "the first", 0), ("one-before", "the one before it", count - 2)] {
            for (place, members, value, frame) in [
                ("unknown", "unknown members", "0", with_raw(&minimal(kind).text(), MARK)),
                (
                    "channels",
                    "channels",
                    "{}",
                    set(minimal(kind), &["channels"], Json::literal(format!("{{{MARK}}}"))).text(),
                ),
            ] {
                let (before, after) = frame.split_once(MARK).unwrap_or((&frame, ""));
                let text = Text::concat([
                    before.into(),
                    Text::count("\"k", &format!("\":{value},"), count - 1),
                    format!("\"k{nth}\":{value}{after}").into(),
                ]);
                cases.push(
                    Case::new(
                        format!("{kind}/members/{count}/{name}-repeated-in-{place}"),
                        &["NCP-WIRE-007"],
                        readers(kind),
                    )
                    .title(format!(
                        "{} with {count} {members} of which the last has the name of {which} is rejected.",
                        a(kind)
                    ))
                    .flags(&["duplicate-members"])
                    .decode(kind, text)
                    .rejects("malformed")
                    .because("One object has one member name twice, however many others it has."),
                );
            }
        }
    }
    cases
}

/// Arrays of 4,096 items that are no numbers, and of one more.
fn arrays() -> Vec<Case> {
    let spec = explicit_message("ChannelSpec").text();
    let binding = explicit_message("EntityBinding").text();
    let record = explicit_message("RecordTarget").text();
    let stimulus = explicit_message("StimulusTarget").text();
    let places: [(&str, &[&str], &str); 7] = [
        ("command_frame", &["horizon"], "{}"),
        ("capabilities", &["sensor_channels"], &spec),
        ("capabilities", &["command_channels"], &spec),
        ("open_session", &["bindings"], &binding),
        ("open_session", &["record", "targets"], &record),
        ("open_session", &["record", "targets", "0", "recordables"], "\"x\""),
        ("open_session", &["stimulus", "targets"], &stimulus),
    ];
    let mut cases = Vec::new();
    for (kind, path, item) in places {
        let place = path.iter().filter(|part| **part != "0").copied().collect::<Vec<_>>().join("-");
        let member = path.join(".").replace(".0", "[0]");
        cases.push(
            Case::new(format!("{kind}/array/{place}-beyond-limit"), &["NCP-WIRE-067"], readers(kind))
                .title(format!("{} with 4,097 items in `{member}` is rejected.", a(kind)))
                .flags(&["missing-limits"])
                .decode(kind, list(&set(minimal(kind), path, Json::literal(MARK)).text(), item, ENTRIES + 1))
                .rejects("limit")
                .because("An array of the tables whose items are no numbers may have 4,096 items."),
        );
        if matches!(item, "{}" | "\"x\"") {
            cases.push(
                Case::new(format!("{kind}/array/{place}-beyond-2-to-16"), &["NCP-WIRE-067"], readers(kind))
                    .title(format!("{} with 65,537 items in `{member}` is rejected.", a(kind)))
                    .flags(&["missing-limits"])
                    .decode(kind, list(&set(minimal(kind), path, Json::literal(MARK)).text(), item, (1 << 16) + 1))
                    .rejects("limit")
                    .because("An array of the tables whose items are no numbers may have 4,096 items."),
            );
        }
        let text = list(&set(explicit(kind), path, Json::literal(MARK)).text(), item, ENTRIES);
        cases.push(
            Case::new(format!("{kind}/array/{place}-at-limit"), &["NCP-WIRE-068"], readers(kind))
                .title(format!("{} with 4,096 items in `{member}` is read.", a(kind)))
                .flags(&["low-limits"])
                .decode(kind, text.clone())
                .means(text)
                .because("An array may have 4,096 items."),
        );
    }
    cases
}

/// Maps and arrays that each keep their limit, and together have more: the limit is that of one.
fn sums() -> Vec<Case> {
    let item =
        |message: &str, path: &[&str], value: &str| set(explicit_message(message), path, Json::literal(value)).text();
    let value = explicit_message("ChannelValue").text();
    let horizon = format!("{{\"a\":{value},\"b\":{value},\"c\":{value}}}");
    let binding = item("EntityBinding", &["entity", "meta"], r#"{"a":"x","b":"y","c":"z"}"#);
    let record = item("RecordTarget", &["recordables"], r#"["V_m","g_ex","w"]"#);
    let stimulus = item("StimulusTarget", &["params"], r#"{"a":1.0,"b":2.0,"c":3.0}"#);
    let places: [(&str, &[&str], &str); 4] = [
        ("command_frame", &["horizon"], &horizon),
        ("open_session", &["bindings"], &binding),
        ("open_session", &["record", "targets"], &record),
        ("open_session", &["stimulus", "targets"], &stimulus),
    ];
    let mut cases: Vec<Case> = places
        .into_iter()
        .map(|(kind, path, item)| {
            let text = list(&set(explicit(kind), path, Json::literal(MARK)).text(), item, 1_500);
            sum(kind, &path.join("-"), text).title(format!(
                "{} with 1,500 items of 3 entries each in `{}` is read.",
                a(kind),
                path.join(".")
            ))
        })
        .collect();
    // Tens of thousands of values in all, within 1 MiB.
    let text = list(
        &explicit("command_frame").with("horizon", Json::literal(MARK)).text(),
        r#"{"a":{},"b":{},"c":{},"d":{}}"#,
        ENTRIES,
    );
    cases.push(
        sum("command_frame", "horizon-of-many", text)
            .title("A `command_frame` with 4,096 items of 4 entries each in `horizon` is read."),
    );
    // Written out, as an answer is, they are nearly as many bytes as a frame may have.
    let names = ["a", "b", "c", "d", "e", "f", "g", "h"];
    let wide = format!("{{{}}}", names.map(|name| format!("\"{name}\":{{}}")).join(","));
    let text = list(&explicit("command_frame").with("horizon", Json::literal(MARK)).text(), &wide, ENTRIES);
    cases.push(
        sum("command_frame", "horizon-of-most", text)
            .title("A `command_frame` with 4,096 items of 8 entries each in `horizon` is read."),
    );
    // More entries in all than 16 bits count.
    let entries: Vec<String> = (b'a'..=b'q').map(|name| format!("\"{}\":\"\"", char::from(name))).collect();
    let crowded = item("EntityBinding", &["entity", "meta"], &format!("{{{}}}", entries.join(",")));
    let text = list(&set(explicit("open_session"), &["bindings"], Json::literal(MARK)).text(), &crowded, ENTRIES);
    cases.push(
        sum("open_session", "bindings-of-more-than-16-bits", text)
            .title("An `open_session` with 4,096 items of 17 entries each in `bindings` is read."),
    );
    cases
}

fn sum(kind: &str, path: &str, text: Text) -> Case {
    Case::new(format!("{kind}/sum/{path}"), &["NCP-WIRE-068"], readers(kind))
        .flags(&["low-limits"])
        .decode(kind, text.clone())
        .means(text)
        .because("One map may have 4,096 entries, and one array as many items, whatever others have.")
}

/// Numeric arrays, which only the bytes of the frame limit.
fn numeric_arrays() -> Vec<Case> {
    let places: [(&str, &[&str], &str, usize); 12] = [
        ("sensor_frame", &["channels", "a", "data"], "0.25", 5_000),
        ("sensor_frame", &["channels", "b", "data"], "0.25", 200_000),
        ("command_frame", &["channels", "a", "data"], "-1.5", 5_000),
        ("command_frame", &["horizon", "0", "a", "data"], "-1.5", 5_000),
        ("stimulus_frame", &["values", "a", "data"], "100", 5_000),
        ("observation_frame", &["records", "a", "times"], "0.1", 400_000),
        ("observation_frame", &["records", "a", "values"], "-65.0", 5_000),
        ("observation_frame", &["records", "a", "senders"], "7", 5_000),
        // More than 1 MiB has room for.
        ("observation_frame", &["records", "a", "times"], "0.5", MIB + 1),
        ("observation_frame", &["records", "a", "senders"], "7", MIB + 1),
        ("open_session", &["record", "targets", "0", "ids"], "7", 5_000),
        ("open_session", &["stimulus", "targets", "0", "ids"], "7", 5_000),
    ];
    places
        .into_iter()
        .map(|(kind, path, item, count)| {
            let place = path.iter().filter(|part| !matches!(**part, "0" | "a")).copied().collect::<Vec<_>>().join("-");
            let member = path.join(".").replace(".0", "[0]");
            let items = Json::literal(MARK);
            let frame = match path {
                ["stimulus", ..] => {
                    let target = explicit_message("StimulusTarget").with("ids", items);
                    explicit(kind).with("stimulus", object! { "targets" => Json::Array(vec![target]) })
                }
                path => set(explicit(kind), path, items),
            };
            let text = list(&frame.text(), item, count);
            let rules: &[_] = if count > 300_000 { &["NCP-WIRE-069", "NCP-WIRE-063"] } else { &["NCP-WIRE-069"] };
            Case::new(format!("{kind}/numbers/{place}-{count}"), rules, readers(kind))
                .title(format!("{} with {count} numbers in `{member}` is read.", a(kind)))
                .flags(&["low-limits"])
                .decode(kind, text.clone())
                .means(text)
                .because("Nothing but the bytes of the frame limits a numeric array.")
        })
        .collect()
}

/// Long arrays of few values, of which 0 and -0 are two.
fn equal_numbers() -> Vec<Case> {
    let places: [(&str, &[&str]); 5] = [
        ("sensor_frame", &["channels", "a", "data"]),
        ("command_frame", &["channels", "a", "data"]),
        ("command_frame", &["horizon", "0", "a", "data"]),
        ("stimulus_frame", &["values", "a", "data"]),
        ("observation_frame", &["records", "a", "values"]),
    ];
    let mut cases = Vec::new();
    for (kind, path) in places {
        let place = path.iter().filter(|part| !matches!(**part, "0" | "a")).copied().collect::<Vec<_>>().join("-");
        let member = path.join(".").replace(".0", "[0]");
        for count in [17, 65, 129, 300] {
            for (order, first, last) in [("zero-first", "0.0", "-0.0"), ("zero-last", "-0.0", "0.0")] {
                let items = vec![first; count - 2].join(",");
                let data = format!("[{items},0.5,{last}]");
                let text = set(explicit(kind), path, Json::literal(data)).text();
                cases.push(
                    Case::new(
                        format!("{kind}/equal-numbers/{place}-{count}/{order}"),
                        &["NCP-WIRE-015"],
                        readers(kind),
                    )
                    .title(format!(
                        "{} whose `{member}` has {count} numbers, {first} many times and {last} at the end, is \
                             read to the sign.",
                        a(kind)
                    ))
                    .flags(&["signed-zero"])
                    .decode(kind, text.clone())
                    .means(text)
                    .because("0 and \u{2212}0 are two doubles, and a number is read as the double that is nearest."),
                );
            }
        }
    }
    cases
}

/// Frames of a million bytes that hold as many values as fit.
fn small_values() -> Vec<Case> {
    let mut cases = Vec::new();
    for kind in ANY {
        let frame = explicit(kind).text();
        for (what, item, says) in [
            ("arrays", "[]", "empty arrays"),
            ("objects", "{}", "empty objects"),
            ("zeros", "0", "zeros"),
            ("strings", "\"\"", "empty strings"),
        ] {
            // In rows, since a receiver may hold ignored arrays to 4,096 items too. [NCP-WIRE-071]
            let row = format!("[{}{item}]", format!("{item},").repeat(299));
            let item = row.as_str();
            let marked = with_raw(&frame, &format!("\"novel\":{MARK}"));
            let room = (MIB - marked.len()) / (item.len() + 1);
            cases.push(
                Case::new(format!("{kind}/small-values/{what}"), &["NCP-WIRE-070", "NCP-WIRE-061"], readers(kind))
                    .title(format!("{} of nearly 1 MiB that is full of {says} is read.", a(kind)))
                    .flags(&["amplification"])
                    .decode(kind, list(&marked, item, room))
                    .means(meaning(kind, &explicit(kind)).text())
                    .because("The frame is within its limit, and its memory within a small constant times that."),
            );
        }
    }
    cases
}

/// Names and other strings, which only the bytes of the frame limit, but for ids.
fn long_strings() -> Vec<Case> {
    // The last part is the name of an entry, or a field that is a string.
    let places: [(&str, &[&str], &str); 10] = [
        ("sensor_frame", &["frame_id"], "frame_id"),
        ("sensor_frame", &["channels", "{}"], "name of a channel"),
        ("command_frame", &["frame_id"], "frame_id"),
        ("command_frame", &["channels", "a", "unit"], "unit of a channel"),
        ("stimulus_frame", &["values", "{}"], "name of a port"),
        ("observation_frame", &["records", "{}"], "name of a port"),
        ("session_opened", &["resolved", "{}"], "name of a population"),
        ("open_session", &["network", "ref"], "name of a network"),
        ("open_session", &["network", "params", "{}"], "name of a parameter"),
        ("link_status", &["session_id"], "session_id, which is any string,"),
    ];
    let mut cases = Vec::new();
    for (kind, path, says) in places {
        // A text that is read in pieces is cut within a character, if it has three bytes.
        for (length, letter) in [(257, "n"), (65_537, "n"), (100_000, "\u{20ac}")] {
            let entry = |value: Json| object! { MARK => value };
            let frame = match path {
                ["channels", "{}"] => explicit(kind).with("channels", entry(explicit_message("ChannelValue"))),
                ["values", "{}"] => explicit(kind).with("values", entry(explicit_message("ChannelValue"))),
                ["records", "{}"] => explicit(kind).with("records", entry(explicit_message("Observation"))),
                [map @ .., "{}"] => set(explicit(kind), map, entry(Json::literal("1"))),
                ["channels", "a", "unit"] => {
                    let value = explicit_message("ChannelValue").with("unit", MARK.into());
                    explicit(kind).with("channels", object! { "a" => value })
                }
                path => set(explicit(kind), path, MARK.into()),
            };
            let place = path.iter().filter(|part| !matches!(**part, "{}" | "a")).copied().collect::<Vec<_>>().join("-");
            let frame = frame.text();
            let (before, after) = frame.split_once(MARK).unwrap_or((&frame, ""));
            let text = Text::concat([before.into(), Text::repeat(letter, length), after.into()]);
            let of_bytes = if letter == "n" { "" } else { " of three bytes each" };
            cases.push(
                Case::new(
                    format!("{kind}/strings/{place}-{length}{}", of_bytes.replace(' ', "-")),
                    &["NCP-WIRE-034", "NCP-WIRE-061"],
                    readers(kind),
                )
                .title(format!("{} with a {says} of {length} characters{of_bytes} is read.", a(kind)))
                .flags(&["low-limits"])
                .decode(kind, text.clone())
                .means(text)
                .because("Nothing but the bytes of the frame limits a string that is no id."),
            );
        }
    }
    cases
}

/// Names that agree in thousands of characters, and one that repeats.
fn long_names() -> Vec<Case> {
    let value = explicit_message("ChannelValue").text();
    let mut cases = Vec::new();
    for (kind, length) in [("sensor_frame", 70_000), ("command_frame", 2_000)] {
        let name = |last: &str| [Text::from("\""), Text::repeat("n", length), format!("{last}\":").into()];
        // Two names with a value each, within the frame with the mark in it.
        let of_two = |frame: &Json, value: &str, lasts: [&str; 2]| {
            let frame = frame.text();
            let (before, after) = frame.split_once(MARK).unwrap_or((&frame, ""));
            let [one, other] = lasts.map(name);
            let parts = [vec![before.into()], one.into(), vec![format!("{value},").into()], other.into()];
            Text::Concat([parts.concat(), vec![format!("{value}{after}").into()]].concat())
        };
        let in_channels = |ground: Json| ground.with("channels", Json::literal(format!("{{{MARK}}}")));
        let read = of_two(&in_channels(explicit(kind)), &value, ["a", "b"]);
        cases.push(
            Case::new(format!("{kind}/strings/alike-{length}/channels"), &["NCP-WIRE-068"], readers(kind))
                .title(format!("{} with two channels whose names agree in {length} characters has both.", a(kind)))
                .flags(&["low-limits"])
                .decode(kind, read.clone())
                .means(read)
                .because("Two names that differ in their last letter are two names, however long they are."),
        );
        cases.push(
            Case::new(format!("{kind}/strings/alike-{length}/repeated"), &["NCP-WIRE-007"], readers(kind))
                .title(format!("{} with a channel twice whose name has {length} characters is rejected.", a(kind)))
                .flags(&["duplicate-members"])
                .decode(kind, of_two(&in_channels(minimal(kind)), "{}", ["a", "a"]))
                .rejects("malformed")
                .because("One object has the same member name twice, however long it is."),
        );
        let beside = |ground: Json| Json::literal(with_raw(&ground.text(), MARK));
        cases.push(
            Case::new(format!("{kind}/strings/alike-{length}/unknown"), &["NCP-WIRE-026"], readers(kind))
                .title(format!(
                    "{} with two unknown members whose names agree in {length} characters is read.",
                    a(kind)
                ))
                .flags(&["closed-objects"])
                .decode(kind, of_two(&beside(explicit(kind)), "1", ["a", "b"]))
                .means(meaning(kind, &explicit(kind)).text())
                .because("Two names that differ in their last letter are two names, and both are ignored."),
        );
    }
    cases
}

/// As many names as a name has letters, and one, each of which differs from all others in one place or in two.
fn alike_in_all_places() -> Vec<Case> {
    let mut cases = Vec::new();
    for base in ["arm_joint_01_position_setpoint", &"left_arm_upper_joint_".repeat(4)] {
        let with_mark = |place| {
            let marked = |(at, letter)| if at == place { '~' } else { letter };
            base.char_indices().map(marked).collect::<String>()
        };
        let names: Vec<String> = (0..=base.len()).map(with_mark).collect();
        let (name, says) = (format!("alike-in-all-{}-places", base.len()), "that differ in a place or two");
        cases.extend(with_names(
            &name,
            &names,
            says,
            "Two names that differ in a letter are two names, wherever it stands.",
        ));
    }
    cases
}

/// Pairs of names of which a usual checksum or hash is the same: CRC-32 and its variant of Castagnoli, Adler-32, FNV-1
/// and FNV-1a, the products by 31 and by 33, and others, each of 32 bits.
const COLLIDING: [[&str; 2]; 12] = [
    ["Aa", "BB"],
    ["hztkwpo", "t2w87d9"],
    ["kay62fh", "9eqgvan"],
    ["6i5nfxi", "6kwnh6i"],
    ["a71uvek", "3ehzu6g"],
    ["pfd5q9a", "htpibo6"],
    ["sg3welo", "okqd0qj"],
    ["e01w3kz", "40vcv3o"],
    ["6hwq09s", "2nkdck6"],
    ["ny0832h", "dxjl5i6"],
    ["30boei0", "ntkbpid"],
    ["e2uf3h9", "21ogzzt"],
];

/// Names that who compares by a checksum takes for one.
fn of_one_checksum() -> Vec<Case> {
    let names = COLLIDING.concat().iter().map(ToString::to_string).collect::<Vec<_>>();
    with_names(
        "of-one-checksum",
        &names,
        "of which two at a time have the same checksum",
        "Names are the same letter for letter, and not by what is made of them.",
    )
}

/// A frame of each of some kinds, with a map, or an object that nobody reads, of these names.
fn with_names(name: &str, names: &[String], says: &str, why: &str) -> Vec<Case> {
    let value = explicit_message("ChannelValue").text();
    let table: [(&str, &[&str], &str); 4] = [
        ("sensor_frame", &["channels"], &value),
        ("command_frame", &["horizon", "0"], &value),
        ("open_session", &["network", "population_sizes"], "1"),
        ("close_session", &["novel"], "1"),
    ];
    let case = |(kind, path, value): (&str, &[&str], &str)| {
        let entries: Vec<String> = names.iter().map(|name| format!("\"{name}\":{value}")).collect();
        let with_all = Json::literal(format!("{{{}}}", entries.join(",")));
        let is_listed = path != ["novel"];
        let frame =
            if is_listed { set(explicit(kind), path, with_all) } else { explicit(kind).with("novel", with_all) };
        let means = if is_listed { frame.text() } else { meaning(kind, &explicit(kind)).text() };
        let member = path.join(".").replace(".0", "[0]");
        Case::new(
            format!("{kind}/strings/{name}/{}", path.join("-")),
            &[if is_listed { "NCP-WIRE-068" } else { "NCP-WIRE-026" }, "NCP-WIRE-007"],
            readers(kind),
        )
        .title(format!("{} is read whose `{member}` has {} names {says}.", a(kind), names.len()))
        .flags(&["low-limits"])
        .decode(kind, frame.text())
        .means(means)
        .because(why)
    };
    table.into_iter().map(case).collect()
}

/// Strings of descriptive enums that are none of theirs and long.
fn long_enums() -> Vec<Case> {
    let places: [(&str, &[&str]); 1] = [("open_session", &["record", "targets", "0", "observable"])];
    let case = |(kind, path): (&str, &[&str])| {
        let frame = set(explicit(kind), path, MARK.into()).text();
        let (before, after) = frame.split_once(MARK).unwrap_or((&frame, ""));
        let text = Text::concat([before.into(), Text::repeat("novel", 60), after.into()]);
        let place = path.iter().filter(|part| **part != "0").copied().collect::<Vec<_>>().join("-");
        Case::new(
            format!("{kind}/strings/enum-{place}"),
            &["NCP-WIRE-043", "NCP-WIRE-042", "NCP-WIRE-045"],
            readers(kind),
        )
        .title(format!(
            "{} whose `{}` is an unknown string of 300 characters keeps it.",
            a(kind),
            path.join(".").replace(".0", "[0]")
        ))
        .flags(&["invented-sentinel"])
        .decode(kind, text.clone())
        .means(text)
        .because("An unknown string of a descriptive enum is kept as it is, however long it is.")
    };
    places.map(case).into()
}

/// Stands for an array or a string that is written as a template.
const MARK: &str = "%ITEMS%";

/// The text with the mark replaced by an array of equal items.
fn list(text: &str, item: &str, count: usize) -> Text {
    let (before, after) = text.split_once(MARK).unwrap_or((text, ""));
    Text::concat([
        format!("{before}[").into(),
        Text::repeat(format!("{item},"), count - 1),
        format!("{item}]{after}").into(),
    ])
}

/// The text with an object of so many members in the place of the mark.
fn entries_of(text: &str, value: &str, count: usize) -> Text {
    let (before, after) = text.split_once(MARK).unwrap_or((text, ""));
    Text::concat([
        format!("{before}{{").into(),
        Text::count("\"k", &format!("\":{value},"), count - 1),
        format!("\"k\":{value}}}{after}").into(),
    ])
}

/// The frame with an unknown string of such a length that the whole has `total` bytes.
fn padded(frame: &str, total: usize, unit: &str) -> Text {
    let open = frame.strip_suffix('}').unwrap_or(frame);
    let before = format!("{open},\"pad\":\"");
    let room = total - before.len() - 2;
    let rest = "x".repeat(room % unit.len());
    Text::concat([before.into(), Text::repeat(unit, room / unit.len()), format!("{rest}\"}}").into()])
}

/// The frame with an unknown string before everything else.
fn padded_before(frame: &str, total: usize) -> Text {
    let rest = frame.strip_prefix('{').unwrap_or(frame);
    let (before, after) = ("{\"pad\":\"", format!("\",{rest}"));
    let room = total - before.len() - after.len();
    Text::concat([before.into(), Text::repeat("x", room), after.into()])
}

/// The frame with so much white space before its last brace that the whole has `total` bytes.
fn spaced(frame: &str, total: usize) -> Text {
    let open = frame.strip_suffix('}').unwrap_or(frame);
    Text::concat([open.into(), Text::repeat(" ", total - frame.len()), "}".into()])
}

/// A side of the object.
#[derive(Clone, Copy)]
enum Side {
    Before,
    After,
}

/// The frame with so much white space on one side of its object that the whole has `total` bytes.
fn outside(frame: &str, total: usize, side: Side) -> Text {
    let space = |character: &str| Text::repeat(character, total - frame.len());
    match side {
        Side::Before => Text::concat([space(" "), frame.into()]),
        Side::After => Text::concat([frame.into(), space("\n")]),
    }
}

/// The frame with a value at a path; what the path needs is made.
fn set(frame: Json, path: &[&str], value: Json) -> Json {
    let Some((name, rest)) = path.split_first() else {
        return value;
    };
    let inner = match frame.get(name) {
        Some(known) if !rest.is_empty() && !known.members().is_empty() => known.clone(),
        _ => ground(name, rest),
    };
    match rest {
        ["0", rest @ ..] => frame.with(name, Json::Array(vec![set(ground(name, rest), rest, value)])),
        rest => frame.with(name, set(inner, rest, value)),
    }
}

/// What stands in that member, apart from what is set in it by the path: its defaults written out.
fn ground(name: &str, rest: &[&str]) -> Json {
    match (name, rest) {
        ("bindings", _) => explicit_message("EntityBinding"),
        ("targets", ["params", ..]) => explicit_message("StimulusTarget"),
        ("targets", [_, ..]) => explicit_message("RecordTarget"),
        ("a", ["times" | "values" | "senders"]) => explicit_message("Observation"),
        _ => Json::object(),
    }
}

/// A number in two digits, as long as it is less than 4,096.
fn base_64(mut number: usize) -> String {
    const DIGITS: &[u8; 64] = b"0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ-_";
    let mut digits = Vec::new();
    loop {
        digits.push(DIGITS.get(number % 64).copied().map_or('0', char::from));
        number /= 64;
        if number == 0 {
            return digits.into_iter().rev().collect();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_padded_frame_has_the_bytes_that_it_should_have() {
        let frame = minimal("sensor_frame").text();
        for unit in ["x", "\u{e9}"] {
            assert_eq!(padded(&frame, MIB + 1, unit).expanded().len(), MIB + 1);
        }
        assert_eq!(padded_before(&frame, MIB).expanded().len(), MIB);
        assert_eq!(spaced(&frame, MIB).expanded().len(), MIB);
        for side in [Side::Before, Side::After] {
            let text = outside(&frame, MIB, side).expanded();
            assert_eq!((text.len(), text.trim()), (MIB, frame.as_str()));
        }
    }

    #[test]
    fn a_list_has_the_items_that_it_should_have() {
        assert_eq!(list("{\"a\":%ITEMS%}", "0", 3).expanded(), "{\"a\":[0,0,0]}");
    }

    #[test]
    fn a_value_is_set_wherever_the_path_leads() {
        let frame = set(minimal("command_frame"), &["horizon", "0", "a", "data"], Json::literal("7"));
        assert_eq!(frame.text(), r#"{"kind":"command_frame","horizon":[{"a":{"data":7}}]}"#);
        assert_eq!(set(Json::object(), &["a"], Json::Null).text(), r#"{"a":null}"#);
    }

    #[test]
    fn a_name_is_a_number_in_base_64() {
        assert_eq!([0, 63, 64, 4095, 4096].map(base_64), ["0", "_", "10", "__", "100"]);
    }
}
