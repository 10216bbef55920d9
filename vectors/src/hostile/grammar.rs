//! Texts that are nearly JSON.

use super::{CARRIERS, with_raw};
use crate::case::{Case, File};
use crate::json::Json;
use crate::model::{explicit, meaning, minimal};
use crate::patch::{patched, written};
use crate::roles::{a, readers};
use crate::scenario::{Row, ScenarioError, Scenarios, source};
use crate::template::Text;

/// What stands around, before, after and instead of the object.
pub(super) fn structure_file() -> Result<File, ScenarioError> {
    let cases = Scenarios::read(source!("hostile/structure"))?.rest(|row| text_case(row, row.kind()?))?;
    let about = "Texts that are no object, are cut off, have something before or behind the object, or break the \
                 grammar within.";
    Ok(File::new("hostile", "structure", about, cases))
}

/// Numbers, literals and strings that JSON does not have.
pub(super) fn token_file() -> Result<File, ScenarioError> {
    let mut text = Scenarios::read(source!("hostile/tokens"))?;
    let mut cases = text.cases("novel", |row| text_case(row, row.kind()?))?;
    cases.extend(text.cases("number", |row| member_case(row, row.kind()?))?);
    cases.extend(text.cases("number-in", |row| member_case(row, &row.fill("{place.first}")?))?);
    cases.extend(text.rest(|row| member_case(row, row.kind()?))?);
    cases.extend(long_strings());
    let about = "Numbers, literals and strings that other languages write and JSON does not have.";
    Ok(File::new("hostile", "tokens", about, cases))
}

/// What may not stand in a string, so far behind its beginning: a reader that takes many characters at a time is no
/// other reader.
fn long_strings() -> Vec<Case> {
    const WHOLE: [(&str, &str, &str); 7] = [
        ("raw-line-feed", "\n", "a line feed as it is"),
        ("raw-nul", "\0", "U+0000 as it is"),
        ("raw-first-control", "\u{1}", "U+0001 as it is"),
        ("raw-tab", "\t", "a tab as it is"),
        ("raw-last-control", "\u{1f}", "U+001F as it is"),
        ("escape-hex", r"\x41", "the escape `\\x`"),
        ("escape-three-digits", r"\u041", "an escape of three digits"),
    ];
    let of = |kind: &str, place: &str, [behind, after]: [usize; 2], (what, bad, says): (&str, &str, &str)| {
        let frame = minimal(kind).text();
        let open = frame.strip_suffix('}').unwrap_or(&frame);
        let (before, end, says_where) = match place {
            "name" => (format!("{open},\""), "\":1}", "a member's name with"),
            "channel" => (format!("{open},\"channels\":{{\""), "\":{}}}", "a channel's name with"),
            "frame_id" => (format!("{open},\"frame_id\":\""), "\"}", "a `frame_id` with"),
            _ => (format!("{open},\"novel\":\""), "\"}", "a string with"),
        };
        let path = if place == "novel" { "string".to_owned() } else { format!("string/{place}") };
        let (path, letters) = match after {
            1 => (format!("{path}/{what}-behind-{behind}"), format!("behind {behind} letters")),
            _ => (format!("{path}/{what}-amid-{}", behind + after), format!("amid {} letters", behind + after)),
        };
        let text = [before.into(), Text::repeat("x", behind)].into_iter();
        let text: Vec<Text> = match after {
            1 => text.chain([format!("{bad}x{end}").into()]).collect(),
            _ => text.chain([bad.into(), Text::repeat("x", after), end.into()]).collect(),
        };
        Case::new(format!("{kind}/{path}"), &["NCP-WIRE-002"], readers(kind))
            .title(format!("{} with {says_where} {says} {letters} is rejected.", a(kind)))
            .flags(&["lenient-strings"])
            .decode(kind, Text::concat(text))
            .rejects("malformed")
            .because("What a string may hold does not depend on how long it is.")
    };
    let mut cases = Vec::new();
    cases.extend(WHOLE.map(|bad| of("close_session", "novel", [100, 1], bad)));
    for kind in CARRIERS {
        cases.push(of(kind, "name", [100, 1], WHOLE[0]));
    }
    for behind in [16, 32, 64, 256, 70_000] {
        cases.push(of("close_session", "novel", [behind, 1], WHOLE[0]));
    }
    for kind in ["sensor_frame", "command_frame"] {
        for place in ["frame_id", "channel"] {
            cases.push(of(kind, place, [100, 1], WHOLE[0]));
        }
    }
    // In a piece of many characters that is neither the first nor the last of its string.
    cases.extend(WHOLE.map(|bad| of("close_session", "novel", [300, 300], bad)));
    for (kind, place) in [("sensor_frame", "frame_id"), ("command_frame", "channel"), ("close_session", "name")] {
        cases.extend([0, 1, 4].map(|bad| of(kind, place, [300, 300], WHOLE[bad])));
    }
    cases
}

/// A frame that says only what it must, with changes.
fn member_case(row: &Row, kind: &str) -> Result<Case, ScenarioError> {
    let frame = patched(minimal(kind), &row.body, row.place)?;
    Ok(row.case(readers(kind)).decode(kind, frame.text()).rejects("malformed"))
}

/// A text, as `structure.txt` says how they are written.
fn text_case(row: &Row, kind: &str) -> Result<Case, ScenarioError> {
    let cell = row.text("text")?;
    let frame = minimal(kind).text();
    let (how, what) = cell.split_once(' ').unwrap_or((&cell, ""));
    let unquoted = || Json::read(what).as_str().unwrap_or_default().to_owned();
    let full = || explicit(kind).text();
    let read = match how {
        "explicit" => Some(unquoted().replace('%', &full())),
        "around" => Some(format!("{}{}{}", " ".repeat(1000), full(), "\n".repeat(1000))),
        "between" => Some(spread(&full(), &unquoted())),
        _ => None,
    };
    if let Some(text) = read {
        return Ok(row.case(readers(kind)).decode(kind, text).means(meaning(kind, &explicit(kind)).text()));
    }
    let text = match how {
        "cut" => cut(&frame, what).ok_or_else(|| row.place.wants("mark of the frame", what))?,
        _ => match cell.strip_prefix('~') {
            Some(members) => with_raw(&frame, &written(members)),
            None => {
                let body = frame.trim_start_matches('{').trim_end_matches('}');
                let quoted = Json::string(&frame).text();
                let parts = [("<quoted>", &quoted[..]), ("<frame>", &frame), ("<body>", body), ("<kind>", kind)];
                let text = if how == "json" { unquoted() } else { cell.clone() };
                parts.into_iter().fold(text, |text, (mark, part)| text.replace(mark, part))
            }
        },
    };
    Ok(row.case(readers(kind)).decode(kind, text).rejects("malformed"))
}

/// The frame with a member of every kind of token, cut off behind a mark, or before its last brace.
fn cut(frame: &str, mark: &str) -> Option<String> {
    let frame = with_raw(frame, r#""n":{"a":[1.5,true,null,"x\u0041"]}"#);
    let end = if mark == "last" { frame.len() - 1 } else { frame.find(mark)? + mark.len() };
    frame.get(..end).map(str::to_owned)
}

/// The frame with white space around each of its tokens. No string of an explicit frame holds any of them.
fn spread(frame: &str, space: &str) -> String {
    let spread = ["{", "}", "[", "]", ":", ","]
        .iter()
        .fold(frame.to_owned(), |text, token| text.replace(token, &format!("{space}{token}{space}")));
    spread.trim_matches(' ').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_explicit_frame_has_a_token_within_a_string() {
        for kind in CARRIERS {
            let text = explicit(kind).text();
            let strings = text.split('"').skip(1).step_by(2);
            assert!(strings.into_iter().all(|s| !s.contains(['{', '}', '[', ']', ':', ','])));
        }
    }
}
