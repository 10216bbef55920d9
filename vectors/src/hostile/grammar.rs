//! Texts that are nearly JSON.

use super::{CARRIERS, rejected, with_raw};
use crate::case::{Case, File};
use crate::json::Json;
use crate::model::{WIRE_VERSION, explicit, meaning, minimal};
use crate::roles::{a, readers};

/// What stands around, before, after and instead of the object.
pub(super) fn structure_file() -> File {
    let mut cases = Vec::new();
    for kind in CARRIERS {
        cases.extend(no_object(kind));
        cases.extend(truncated(kind));
        cases.extend(around(kind));
        cases.extend(within(kind));
        cases.extend(white_space(kind));
    }
    // The frame that moves a plant is worth the most usual accidents by itself.
    cases.extend(truncated("command_frame"));
    cases.extend(around("command_frame"));
    let about = "Texts that are no object, are cut off, have something before or behind the object, or break the \
                 grammar within.";
    File::new("hostile", "structure", about, cases)
}

/// Numbers, literals and strings that JSON does not have.
pub(super) fn token_file() -> File {
    let mut cases = Vec::new();
    for kind in CARRIERS {
        cases.extend(literals(kind));
        cases.extend(strings(kind));
        cases.extend(surrogates(kind));
    }
    let all: Vec<&str> = NUMBERS.iter().map(|(what, _)| *what).collect();
    for kind in CARRIERS {
        cases.extend(numbers(kind, "novel", &all));
    }
    for (kind, field) in [("sensor_frame", "t"), ("command_frame", "ttl_ms"), ("run_request", "duration_ms")] {
        cases.extend(numbers(kind, field, &all[..16]));
    }
    // In an integer field only spellings that a general routine would take for an integer.
    let integers = ["plus", "leading-zero", "minus-leading-zero", "hexadecimal", "underscore", "suffix-n"];
    for (kind, field) in [("sensor_frame", "seq"), ("command_frame", "seq")] {
        cases.extend(numbers(kind, field, &integers));
    }
    for kind in ["sensor_frame", "command_frame"] {
        let literals = ["nan", "infinity", "minus-infinity", "bare-word"];
        cases.extend(literals_in(kind, "t", &literals));
    }
    let about = "Numbers, literals and strings that other languages write and JSON does not have.";
    File::new("hostile", "tokens", about, cases)
}

fn no_object(kind: &str) -> Vec<Case> {
    let frame = minimal(kind).text();
    let others = [
        ("null", "null".to_owned(), "null"),
        ("true", "true".to_owned(), "true"),
        ("false", "false".to_owned(), "false"),
        ("zero", "0".to_owned(), "a number"),
        ("fraction", "-1.5e3".to_owned(), "a number"),
        ("string", format!("\"{kind}\""), "a string"),
        ("frame-as-string", Json::string(&frame).text(), "a string that holds the frame"),
        ("empty-array", "[]".to_owned(), "an empty array"),
        ("frame-in-array", format!("[{frame}]"), "an array that holds the frame"),
        ("positional", format!("[\"{WIRE_VERSION}\",\"{kind}\",\"s1\"]"), "an array of the fields' values"),
        ("pairs", format!("[[\"kind\",\"{kind}\"],[\"session_id\",\"s1\"]]"), "an array of names and values"),
    ];
    let mut cases: Vec<Case> = others
        .into_iter()
        .map(|(what, text, says)| {
            rejected(
                kind,
                &format!("no-object/{what}"),
                &["NCP-WIRE-003"],
                text,
                format!("Where a `{kind}` is expected, {says} is rejected."),
            )
            .flags(&["top-level-values"])
            .because("The top-level value is JSON, but not an object.")
        })
        .collect();
    let nothing = [
        ("empty", "", "an empty frame"),
        ("space", " ", "a space"),
        ("line-feeds", "\n\n", "two line feeds"),
        ("nul", "\0", "U+0000"),
    ];
    cases.extend(nothing.into_iter().map(|(what, text, says)| {
        rejected(
            kind,
            &format!("nothing/{what}"),
            &["NCP-WIRE-002"],
            text,
            format!("Where a `{kind}` is expected, {says} is rejected."),
        )
        .flags(&["empty-input"])
        .because("The grammar demands a value.")
    }));
    cases
}

fn truncated(kind: &str) -> Vec<Case> {
    let frame = with_raw(&minimal(kind).text(), r#""n":{"a":[1.5,true,null,"x\u0041"]}"#);
    let after = |mark: &str| frame.find(mark).map(|at| at + mark.len());
    let cuts = [
        ("brace", Some(1), "after its first brace"),
        ("within-name", after("{\"ki"), "within a member's name"),
        ("name", after("{\"kind\""), "after a member's name"),
        ("colon", after("{\"kind\":"), "after a colon"),
        ("within-string", after("{\"kind\":\"c"), "within a string"),
        ("value", after(&format!("{{\"kind\":\"{kind}\"")), "after a value"),
        ("comma", after(&format!("{{\"kind\":\"{kind}\",")), "after a comma"),
        ("nested-brace", after("\"n\":{"), "after a nested brace"),
        ("bracket", after("\"a\":["), "after a bracket"),
        ("within-number", after("[1."), "within a number"),
        ("item-comma", after("1.5,"), "after an item's comma"),
        ("within-literal", after("tr"), "within a literal"),
        ("backslash", after("\"x\\"), "after a backslash"),
        ("within-escape", after("\"x\\u00"), "within an escape"),
        ("closed-bracket", after("]"), "after a closed bracket"),
        ("last-brace", Some(frame.len() - 1), "before its last brace"),
    ];
    cuts.into_iter()
        .filter_map(|(what, at, says)| {
            let text = &frame[..at?];
            let title = format!("{} that is cut off {says} is rejected.", a(kind));
            let case = rejected(kind, &format!("truncated/{what}"), &["NCP-WIRE-002"], text, title);
            Some(case.flags(&["truncated-input"]).because("What is cut off is no object by the grammar."))
        })
        .collect()
}

fn around(kind: &str) -> Vec<Case> {
    let frame = minimal(kind).text();
    let on_a_line = format!("\n{frame}");
    let behind = [
        ("brace", "}", "a brace"),
        ("bracket", "]", "a bracket"),
        ("comma", ",", "a comma"),
        ("letter", "x", "a letter"),
        ("null", "null", "null"),
        ("second-frame", frame.as_str(), "a second frame"),
        ("second-frame-on-a-line", on_a_line.as_str(), "a second frame on a line of its own"),
        ("empty-object", " {}", "an empty object"),
        ("nul", "\0", "U+0000"),
        ("nul-and-more", "\0{\"mode\":\"active\"}", "U+0000 and another object"),
        ("comment", "// frame", "a comment"),
        ("block-comment", "/* frame */", "a block comment"),
        ("no-break-space", "\u{a0}", "U+00A0"),
        ("form-feed", "\u{c}", "U+000C"),
        ("semicolon", ";", "a semicolon"),
    ];
    let before = [
        ("comma", ",", "a comma"),
        ("letter", "x", "a letter"),
        ("nul", "\0", "U+0000"),
        ("record-separator", "\u{1e}", "U+001E"),
        ("form-feed", "\u{c}", "U+000C"),
        ("no-break-space", "\u{a0}", "U+00A0"),
        ("comment", "// frame\n", "a comment"),
        ("block-comment", "/* frame */", "a block comment"),
        ("guard", ")]}'\n", "a guard against script inclusion"),
        ("length", "42\n", "a number on a line of its own"),
        ("bracket", "(", "a bracket"),
    ];
    let behind = behind.into_iter().map(|(what, text, says)| {
        let rule = ["NCP-WIRE-004"];
        let title = format!("{} that is followed by {says} is rejected.", a(kind));
        rejected(kind, &format!("behind/{what}"), &rule, format!("{frame}{text}"), title)
            .flags(&["trailing-input"])
            .because("Only JSON white space may follow the object.")
    });
    let before = before.into_iter().map(|(what, text, says)| {
        let title = format!("{} behind {says} is rejected.", a(kind));
        rejected(kind, &format!("before/{what}"), &["NCP-WIRE-002"], format!("{text}{frame}"), title)
            .flags(&["leading-input"])
            .because("Only JSON white space may stand before the object.")
    });
    behind.chain(before).collect()
}

/// Breaks of the grammar between tokens.
fn within(kind: &str) -> Vec<Case> {
    let frame = minimal(kind).text();
    let body = frame.trim_start_matches('{').trim_end_matches('}').to_owned();
    let table = [
        ("trailing-comma", format!("{{{body},}}"), "a trailing comma"),
        ("leading-comma", format!("{{,{body}}}"), "a leading comma"),
        ("two-commas", format!("{{{body},,\"n\":1}}"), "two commas side by side"),
        ("no-comma", format!("{{{body} \"n\":1}}"), "a comma missing"),
        ("semicolon", format!("{{{body};\"n\":1}}"), "a semicolon for a comma"),
        ("no-colon", with_raw(&frame, "\"n\" 1"), "a colon missing"),
        ("two-colons", with_raw(&frame, "\"n\"::1"), "two colons side by side"),
        ("equals", with_raw(&frame, "\"n\"=1"), "an equals sign for a colon"),
        ("arrow", with_raw(&frame, "\"n\"=>1"), "an arrow for a colon"),
        ("no-value", with_raw(&frame, "\"n\":"), "a value missing"),
        ("no-name", with_raw(&frame, ":1"), "a name missing"),
        ("name-alone", with_raw(&frame, "\"n\""), "a name without a value"),
        ("number-name", with_raw(&frame, "1:1"), "a number for a name"),
        ("null-name", with_raw(&frame, "null:1"), "null for a name"),
        ("bare-name", with_raw(&frame, "n:1"), "a name without quotes"),
        ("single-quoted-name", with_raw(&frame, "'n':1"), "a name in single quotes"),
        ("single-quoted-value", with_raw(&frame, "\"n\":'x'"), "a value in single quotes"),
        ("back-quoted-value", with_raw(&frame, "\"n\":`x`"), "a value in back quotes"),
        ("comment", with_raw(&frame, "\"n\":1/* one */"), "a comment"),
        ("line-comment", with_raw(&frame, "\"n\":1// one\n"), "a comment to the end of its line"),
        ("hash-comment", with_raw(&frame, "\"n\":1# one\n"), "a comment behind a hash"),
        ("array-trailing-comma", with_raw(&frame, "\"n\":[1,]"), "a trailing comma in an array"),
        ("array-leading-comma", with_raw(&frame, "\"n\":[,1]"), "a leading comma in an array"),
        ("array-two-commas", with_raw(&frame, "\"n\":[1,,2]"), "a hole in an array"),
        ("array-no-comma", with_raw(&frame, "\"n\":[1 2]"), "a comma missing in an array"),
        ("array-open", with_raw(&frame, "\"n\":[1"), "an array that is not closed"),
        ("array-closed-by-brace", with_raw(&frame, "\"n\":[1}"), "an array that a brace closes"),
        ("object-closed-by-bracket", with_raw(&frame, "\"n\":{\"a\":1]"), "an object that a bracket closes"),
        ("array-with-pair", with_raw(&frame, "\"n\":[\"a\":1]"), "a name and a value in an array"),
        ("tuple", with_raw(&frame, "\"n\":(1,2)"), "a tuple"),
        ("two-values", with_raw(&frame, "\"n\":1 2"), "two values of one member"),
        ("two-strings", with_raw(&frame, "\"n\":\"a\"\"b\""), "two strings side by side"),
        ("vertical-tab", with_raw(&frame, "\"n\":\u{b}1"), "U+000B between two tokens"),
        ("form-feed", with_raw(&frame, "\"n\":\u{c}1"), "U+000C between two tokens"),
        ("no-break-space", with_raw(&frame, "\"n\":\u{a0}1"), "U+00A0 between two tokens"),
        ("line-separator", with_raw(&frame, "\"n\":\u{2028}1"), "U+2028 between two tokens"),
        ("nul", with_raw(&frame, "\"n\":\u{0}1"), "U+0000 between two tokens"),
        ("mark", with_raw(&frame, "\"n\":\u{feff}1"), "U+FEFF between two tokens"),
    ];
    table
        .into_iter()
        .map(|(what, text, says)| {
            rejected(
                kind,
                &format!("within/{what}"),
                &["NCP-WIRE-002"],
                text,
                format!("{} with {says} is rejected.", a(kind)),
            )
            .flags(&["lenient-grammar"])
            .because("The grammar of RFC 8259 does not allow it, in ignored members as little as in others.")
        })
        .collect()
}

fn white_space(kind: &str) -> Vec<Case> {
    let frame = explicit(kind).text();
    let between = |space: &str| {
        // No string of an explicit frame holds any of these characters.
        let spread = ["{", "}", "[", "]", ":", ","]
            .iter()
            .fold(frame.clone(), |text, token| text.replace(token, &format!("{space}{token}{space}")));
        spread.trim_matches(' ').to_owned()
    };
    let table = [
        ("space-before", format!(" {frame}"), "a space before it"),
        ("tab-before", format!("\t{frame}"), "a tab before it"),
        ("line-feed-before", format!("\n{frame}"), "a line feed before it"),
        ("carriage-return-before", format!("\r{frame}"), "a carriage return before it"),
        ("space-behind", format!("{frame} "), "a space behind it"),
        ("tab-behind", format!("{frame}\t"), "a tab behind it"),
        ("line-feed-behind", format!("{frame}\n"), "a line feed behind it"),
        ("carriage-return-and-line-feed-behind", format!("{frame}\r\n"), "a carriage return and a line feed behind it"),
        ("spaces-between", between(" "), "spaces between its tokens"),
        ("all-between", between(" \t\n\r"), "every kind of white space between its tokens"),
        (
            "much-around",
            format!("{}{frame}{}", " ".repeat(1000), "\n".repeat(1000)),
            "a thousand spaces before it and line feeds behind it",
        ),
    ];
    table
        .into_iter()
        .map(|(what, text, says)| {
            Case::new(format!("{kind}/white-space/{what}"), &["NCP-WIRE-005"], readers(kind))
                .title(format!("{} with {says} is read.", a(kind)))
                .flags(&["over-strict"])
                .decode(kind, text)
                .means(meaning(kind, &explicit(kind)).text())
                .because("Space, tab, line feed and carriage return may stand before, behind and between tokens.")
        })
        .collect()
}

/// Literals that JSON does not have.
const LITERALS: &[(&str, &str)] = &[
    ("nan", "NaN"),
    ("infinity", "Infinity"),
    ("minus-infinity", "-Infinity"),
    ("nan-small", "nan"),
    ("inf-small", "inf"),
    ("undefined", "undefined"),
    ("python-true", "True"),
    ("python-none", "None"),
    ("capital-null", "NULL"),
    ("cut-null", "nul"),
    ("long-true", "truee"),
    ("two-words", "true false"),
    ("bare-word", "active"),
    ("function", "Date(0)"),
];

fn literals(kind: &str) -> Vec<Case> {
    let names: Vec<&str> = LITERALS.iter().map(|(what, _)| *what).collect();
    literals_in(kind, "novel", &names)
}

fn literals_in(kind: &str, member: &str, names: &[&str]) -> Vec<Case> {
    let chosen = LITERALS.iter().filter(|(what, _)| names.contains(what));
    chosen
        .map(|(what, literal)| {
            let text = with_raw(&minimal(kind).text(), &format!("\"{member}\":{literal}"));
            let title = format!("{} whose `{member}` is {literal} is rejected.", a(kind));
            rejected(kind, &format!("{member}/literal-{what}"), &["NCP-WIRE-002"], text, title)
                .flags(&[if what.contains("inf") || what.contains("nan") {
                    "non-finite-literals"
                } else {
                    "lenient-grammar"
                }])
                .because("JSON has the literals true, false and null, in these letters, and no others.")
        })
        .collect()
}

fn strings(kind: &str) -> Vec<Case> {
    let table = [
        ("raw-nul", "a\0b", "U+0000 as it is"),
        ("raw-line-feed", "a\nb", "a line feed as it is"),
        ("raw-carriage-return", "a\rb", "a carriage return as it is"),
        ("raw-tab", "a\tb", "a tab as it is"),
        ("raw-escape", "a\u{1b}b", "U+001B as it is"),
        ("raw-last-control", "a\u{1f}b", "U+001F as it is"),
        ("escape-hex", r"\x41", "the escape `\\x`"),
        ("escape-octal", r"\101", "an octal escape"),
        ("escape-nul", r"\0", "the escape `\\0`"),
        ("escape-single-quote", r"\'", "an escaped single quote"),
        ("escape-bell", r"\a", "the escape `\\a`"),
        ("escape-vertical-tab", r"\v", "the escape `\\v`"),
        ("escape-upper-case-u", r"\U0001F600", "the escape `\\U`"),
        ("escape-upper-case-n", r"\N", "the escape `\\N`"),
        ("escape-braces", r"\u{41}", "an escape in braces"),
        ("escape-three-digits", r"\u041", "an escape of three digits"),
        ("escape-no-digits", r"\u", "an escape without digits"),
        ("escape-bad-digit", r"\u00G1", "an escape with a letter that is no digit"),
        ("escape-signed", r"\u+041", "an escape with a sign"),
        ("escape-space", r"\u 041", "an escape with a space"),
        ("escape-line-feed", "\\\n", "an escaped line feed"),
        ("escape-second-half-short", r"\ud83d\ude0", "a second half of a pair that has three digits"),
    ];
    let frame = minimal(kind).text();
    let mut cases: Vec<Case> = table
        .into_iter()
        .map(|(what, string, says)| {
            let text = with_raw(&frame, &format!("\"novel\":\"{string}\""));
            rejected(
                kind,
                &format!("string/{what}"),
                &["NCP-WIRE-002"],
                text,
                format!(
                    "{} with a string that has \
                                                    {says} is rejected.",
                    a(kind)
                ),
            )
            .flags(&["lenient-strings"])
            .because(
                "The grammar has eight short escapes and `\\u` with four digits, and control characters \
                          only as escapes.",
            )
        })
        .collect();
    let names = [("name-raw-nul", "no\0vel", "U+0000 as it is"), ("name-bad-escape", r"no\xvel", "the escape `\\x`")];
    cases.extend(names.into_iter().map(|(what, name, says)| {
        let text = with_raw(&frame, &format!("\"{name}\":1"));
        rejected(
            kind,
            &format!("string/{what}"),
            &["NCP-WIRE-002"],
            text,
            format!("{} with a member's name that has {says} is rejected.", a(kind)),
        )
        .flags(&["lenient-strings"])
        .because("A name is a string, and the grammar of strings holds for it.")
    }));
    cases
}

fn surrogates(kind: &str) -> Vec<Case> {
    let table = [
        ("high", r"\ud800", "a first half alone"),
        ("low", r"\udc00", "a second half alone"),
        ("high-and-letter", r"\ud83dA", "a first half before a letter"),
        ("high-and-escape", r"\ud83d\u0041", "a first half before another escape"),
        ("two-high", r"\ud83d\ud83d", "two first halves"),
        ("swapped", r"\ude00\ud83d", "the halves of a pair in the wrong order"),
        ("pair-and-low", r"\ud83d\ude00\ude00", "a pair and a second half"),
    ];
    let mut cases = Vec::new();
    for (what, string, says) in table {
        for (place, member) in [("value", format!("\"novel\":\"{string}\"")), ("name", format!("\"{string}\":1"))] {
            if place == "name" && !matches!(what, "high" | "low") {
                continue;
            }
            let text = with_raw(&minimal(kind).text(), &member);
            let of = if place == "name" { "a member's name" } else { "a string" };
            cases.push(
                rejected(
                    kind,
                    &format!("surrogate/{place}-{what}"),
                    &["NCP-WIRE-008"],
                    text,
                    format!("{} with {says} as an escape in {of} should be rejected.", a(kind)),
                )
                .flags(&["lone-surrogates"])
                .because("A surrogate without its partner has no UTF-8 form."),
            );
        }
    }
    cases
}

/// Numbers that JSON does not have.
const NUMBERS: &[(&str, &str)] = &[
    ("plus", "+1"),
    ("no-integer-part", ".5"),
    ("minus-no-integer-part", "-.5"),
    ("no-fraction", "1."),
    ("no-fraction-exponent", "1.e5"),
    ("leading-zero", "01"),
    ("leading-zero-fraction", "00.5"),
    ("minus-leading-zero", "-01"),
    ("minus-alone", "-"),
    ("two-minus", "--1"),
    ("minus-plus", "-+1"),
    ("exponent-alone", "1e"),
    ("exponent-plus-alone", "1e+"),
    ("exponent-minus-alone", "1e-"),
    ("exponent-fraction", "1e5.5"),
    ("exponent-first", "e5"),
    ("two-points", "1.2.3"),
    ("hexadecimal", "0x1"),
    ("octal", "0o7"),
    ("binary", "0b1"),
    ("underscore", "1_000"),
    ("suffix-f", "1f"),
    ("suffix-n", "1n"),
    ("percent", "1%"),
    ("space-after-minus", "- 1"),
    ("space-within", "1 000"),
    ("full-width-digit", "\u{ff11}"),
    ("arabic-indic-digit", "\u{661}"),
    ("infinity-sign", "\u{221e}"),
    ("minus-sign", "\u{2212}1"),
];

fn numbers(kind: &str, member: &str, names: &[&str]) -> Vec<Case> {
    let chosen = NUMBERS.iter().filter(|(what, _)| names.contains(what));
    chosen
        .map(|(what, number)| {
            let frame = minimal(kind).without(member).text();
            let text = with_raw(&frame, &format!("\"{member}\":{number}"));
            let title = format!("{} whose `{member}` is spelled `{number}` is rejected.", a(kind));
            rejected(kind, &format!("{member}/number-{what}"), &["NCP-WIRE-002"], text, title)
                .flags(&["lenient-numbers"])
                .because("The grammar spells a number `-?(0|[1-9][0-9]*)(\\.[0-9]+)?([eE][+-]?[0-9]+)?`.")
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_cut_is_made() {
        for kind in CARRIERS {
            assert_eq!(truncated(kind).len(), 16);
        }
    }

    #[test]
    fn no_explicit_frame_has_a_token_within_a_string() {
        for kind in CARRIERS {
            let text = explicit(kind).text();
            let strings = text.split('"').skip(1).step_by(2);
            assert!(strings.into_iter().all(|s| !s.contains(['{', '}', '[', ']', ':', ','])));
        }
    }
}
