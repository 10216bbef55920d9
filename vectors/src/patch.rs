//! Frames of scenario text: a frame in good order, and what is changed in it.

use crate::json::Json;
use crate::scenario::{Place, ScenarioError};
use crate::template::Text;

/// The frame with changes, which have ` | ` between: `name=value` sets a member, `+name=value` adds one at the end,
/// also
/// when it is there already, and `-name` takes one away; `~` adds members as they are spelled. A name may be a path
/// with
/// dots, or a JSON string. A value is JSON, or any other text that is to stand as it is.
pub(crate) fn patched(frame: Json, changes: &str, place: Place) -> Result<Json, ScenarioError> {
    let changes = changes.split(" | ").map(str::trim).filter(|change| !change.is_empty());
    changes.into_iter().try_fold(frame, |frame, change| patch(frame, change, place))
}

/// The text that a cell writes: behind `json`, the characters of a JSON string; else, also behind `raw`, the cell as it
/// stands, in which `<s*9>` repeats `s`.
pub(crate) fn written(cell: &str) -> String {
    match cell.split_once(' ') {
        Some(("json", text)) => Json::read(text).as_str().unwrap_or(text).to_owned(),
        Some(("raw", text)) => repeated(text),
        _ => repeated(cell),
    }
}

fn repeated(text: &str) -> String {
    let Some((before, (inside, after))) = text.split_once('<').and_then(|(a, b)| Some((a, b.split_once('>')?))) else {
        return text.to_owned();
    };
    let (part, times) = inside.split_once('*').unwrap_or((inside, "1"));
    format!("{before}{}{}", part.repeat(times.parse().unwrap_or(1)), repeated(after))
}

/// The text in which `<s*9>` repeats `s`, as a template, which the runner expands.
pub(crate) fn template(text: &str) -> Text {
    let mut parts = Vec::new();
    let mut rest = text;
    while let Some((before, (inside, after))) = rest.split_once('<').and_then(|(a, b)| Some((a, b.split_once('>')?))) {
        let (part, times) = inside.split_once('*').unwrap_or((inside, "1"));
        parts.extend([before.into(), Text::repeat(part, times.parse().unwrap_or(1))]);
        rest = after;
    }
    if parts.is_empty() {
        return text.into();
    }
    parts.push(rest.into());
    Text::Concat(parts)
}

fn patch(frame: Json, change: &str, place: Place) -> Result<Json, ScenarioError> {
    if let Some(name) = change.strip_prefix('-') {
        return Ok(frame.without(name));
    }
    if let Some(members) = change.strip_prefix('~') {
        let text = frame.text();
        return Ok(Json::literal(format!("{},{members}}}", text.strip_suffix('}').unwrap_or(&text))));
    }
    let (adds, change) = match change.strip_prefix('+') {
        Some(change) => (true, change),
        None => (false, change),
    };
    // The first equals sign behind the name, which a quoted name may hold as well.
    let quoted = change.starts_with('"').then(|| change.find("\"=")).flatten().map(|at| at + 1);
    let at = quoted.or_else(|| change.find('=')).ok_or_else(|| place.wants("change of a frame", change))?;
    let (name, value) = (&change[..at], Json::read(&change[at + 1..]));
    let name = match quoted {
        Some(_) => Json::read(name).as_str().unwrap_or(name).to_owned(),
        None => repeated(name),
    };
    Ok(match name.split_once('.') {
        _ if adds => frame.and(&name, value),
        Some(_) if quoted.is_none() => frame.edit(&name.split('.').collect::<Vec<_>>(), |_| value),
        _ => frame.with(&name, value),
    })
}
/// The text with those of its letters as escapes that are chosen by their number, from 0.
pub(crate) fn escaped(text: &str, is: impl Fn(usize) -> bool) -> String {
    let letter = |(nth, letter)| match is(nth) {
        true => format!("\\u{:04x}", u32::from(letter)),
        false => String::from(letter),
    };
    text.chars().enumerate().map(letter).collect()
}
