//! Levels of arrays and objects.

use super::LEVELS;
use crate::case::Case;
use crate::json::Json;
use crate::model::{explicit, meaning, minimal};
use crate::roles::{ANY, a, readers};
use crate::template::Text;

pub(super) fn cases() -> Vec<Case> {
    let mut cases = depths();
    cases.extend(deep_names());
    cases
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
