//! What went over the wire in one case, as people read it: a trace as a table of steps, a block by its directory.

use std::borrow::Cow;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;

use super::layout::cut;
use super::model::CaseReport;
use crate::json::Json;

/// How many steps before and after the differing one are shown of a long trace.
const AROUND: usize = 3;
/// From which width on question and answer of a step stand side by side.
const SIDE_BY_SIDE: usize = 110;
/// Members that say the same in every message.
const EVERYWHERE: [&str; 3] = ["ncp_version", "kind", "frame_id"];
/// How many entries of a directory are shown.
const ENTRIES: usize = 8;
/// The calls' names for what is asked for in order, and for what comes back.
const TRACES: [(&str, &str); 2] = [("steps", "steps"), ("requests", "replies")];

/// A trace as a table: a line a step, what is asked and what came back, the first differing step marked by `▸`. `None`
/// if the case is no trace, or was not kept whole.
pub(super) fn steps(case: &CaseReport, width: usize) -> Option<Vec<String>> {
    let request = Json::parse(case.request.as_deref()?).ok()?;
    let args = request.get("args")?;
    let (asked_name, told_name, asked) = TRACES.into_iter().find_map(|(asked, told)| match args.get(asked) {
        Some(Json::Array(steps)) => Some((asked, told, steps)),
        _ => None,
    })?;
    let answer = case.answer.as_deref().and_then(|answer| Json::parse(answer).ok());
    let told = match answer.as_ref().and_then(|answer| answer.get("result")?.get(told_name)) {
        Some(Json::Array(steps)) => steps.as_slice(),
        _ => &[],
    };
    let differing = case.differences.first().and_then(|difference| {
        difference.at.strip_prefix(&format!("/{told_name}/"))?.split('/').next()?.parse::<usize>().ok()
    });
    let focus = differing.unwrap_or(asked.len().saturating_sub(1));
    let column = width.saturating_sub(7) / 2;
    let row = |mark: &str, number: &str, left: &str, right: &str| {
        let head = format!("{mark:1} {number:>2} ");
        if width >= SIDE_BY_SIDE {
            return vec![format!("{head}{:column$} {}", cut(left, column), cut(right, column)).trim_end().to_owned()];
        }
        let room = width.saturating_sub(7);
        let answered = (!right.is_empty()).then(|| format!("     → {}", cut(right, room)));
        std::iter::once(format!("{head}{}", cut(left, room)).trim_end().to_owned()).chain(answered).collect()
    };
    let mut lines = Vec::new();
    if let Json::Object(members) = args {
        let rest: Vec<_> = members.iter().filter(|(name, _)| name != asked_name).cloned().collect();
        let with = brief(&Json::Object(rest));
        if !with.is_empty() {
            lines.push(cut(&format!("with {with}"), width));
        }
    }
    if width >= SIDE_BY_SIDE {
        lines.extend(row("", "", "asked", "answered"));
    }
    for (at, step) in asked.iter().enumerate() {
        let near = at < 2 || at.abs_diff(focus) <= AROUND;
        if !near {
            if lines.last().is_some_and(|line| line.trim() != "…") {
                lines.extend(row("", "…", "", ""));
            }
            continue;
        }
        let mark = if differing == Some(at) { "▸" } else { "" };
        lines.extend(row(mark, &at.to_string(), &brief(step), &told.get(at).map_or_else(String::new, brief)));
    }
    Some(lines)
}

/// Whether a place is one in what a trace answers.
pub(super) fn is_of_a_trace(at: &str) -> bool {
    TRACES.iter().any(|(_, told)| at.strip_prefix('/').is_some_and(|at| at.starts_with(told)))
}

/// The block that was sent or that came back: its header, then an entry of its directory a line. `None` if there is
/// none, or it was not kept whole. It need not be a valid one.
pub(super) fn block(case: &CaseReport) -> Option<(&'static str, Vec<String>)> {
    let request = case.request.as_deref().and_then(|request| Json::parse(request).ok());
    let answer = case.answer.as_deref().and_then(|answer| Json::parse(answer).ok());
    let sent = request.as_ref().and_then(|request| request.get("args")?.get("block")?.as_str());
    let got = || answer.as_ref().and_then(|answer| answer.get("result")?.get("block")?.as_str());
    let (which, text) = sent.map(|text| ("sent", text)).or_else(|| got().map(|text| ("got", text)))?;
    Some((which, directory(&STANDARD.decode(text).ok()?)))
}

/// The header and the directory of a block, as far as it has them (section 5.1 of the text).
fn directory(block: &[u8]) -> Vec<String> {
    let number = |at: usize, size: usize| -> Option<u64> {
        let bytes = block.get(at..at.checked_add(size)?)?;
        Some(bytes.iter().rev().fold(0, |number, byte| number << 8 | u64::from(*byte)))
    };
    let all = block.len();
    let (Some(magic), Some(version), Some(flags), Some(columns), Some(total)) =
        (block.get(..4), number(4, 1), number(5, 1), number(6, 2), number(8, 4))
    else {
        return vec![format!("a block of {all} bytes, fewer than its header has")];
    };
    let mut lines = vec![format!(
        "a block of {all} bytes: magic {:?}, version {version}, flags {flags}, n_cols {columns}, total_len {total}",
        String::from_utf8_lossy(magic)
    )];
    for column in 0..columns as usize {
        if column == ENTRIES {
            lines.push(format!("and {} more", columns as usize - ENTRIES));
            break;
        }
        let at = 12 + 16 * column;
        let entry = [(0, 4), (4, 2), (6, 1), (7, 1), (8, 4), (12, 4)].map(|(from, size)| number(at + from, size));
        let [Some(name_at), Some(name_len), Some(dtype), Some(pad), Some(rows), Some(data_at)] = entry else {
            lines.push(format!("{column}: the directory ends at byte {all}"));
            break;
        };
        let range = usize::try_from(name_at).ok().zip(usize::try_from(name_at + name_len).ok());
        let name = range.and_then(|(from, to)| block.get(from..to)).map(String::from_utf8_lossy);
        let name = name.map_or_else(|| "beyond the end".to_owned(), |name| format!("{:?}", cut(&name, 24)));
        let dtype = match dtype {
            1 => "f32".to_owned(),
            2 => "f64".to_owned(),
            3 => "i32".to_owned(),
            4 => "i64".to_owned(),
            other => format!("dtype {other}"),
        };
        let pad = if pad == 0 { String::new() } else { format!(", pad {pad}") };
        lines.push(format!("{column}: name {name} at {name_at}+{name_len}, {rows} rows of {dtype} at {data_at}{pad}"));
    }
    lines
}

/// A value in few characters: members as `name:value`, absent ones and those of every message left out, strings
/// without quotes.
fn brief(value: &Json<'_>) -> String {
    let list = |parts: Vec<String>| parts.join(" ");
    match value {
        Json::String(text) => text.to_string(),
        Json::Array(items) => format!("[{}]", list(items.iter().map(brief).collect())),
        Json::Object(members) => {
            let says = |(name, value): &&(Cow<'_, str>, _)| !is_empty(value) && !EVERYWHERE.contains(&&**name);
            // What a message does comes before what it is about.
            let (first, rest): (Vec<_>, Vec<_>) =
                members.iter().filter(says).partition(|(name, _)| name == "op" || name == "mode");
            let shown = first.into_iter().chain(rest);
            let member = |(name, value): &(Cow<'_, str>, Json<'_>)| match value {
                _ if name == "op" => brief(value),
                Json::Object(_) => format!("{name}{{{}}}", brief(value)),
                Json::Array(_) => format!("{name}{}", brief(value)),
                _ => format!("{name}:{}", brief(value)),
            };
            list(shown.map(member).collect())
        }
        other => other.to_string(),
    }
}

/// Whether a member says nothing.
fn is_empty(value: &Json<'_>) -> bool {
    match value {
        Json::Null => true,
        Json::Array(items) => items.is_empty(),
        Json::Object(members) => members.is_empty(),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_is_written_briefly() {
        let command = r#"{"seq":7,"mode":"active","horizon":[]}"#;
        let json = format!(r#"{{"op":"govern","command":{command},"now_s":1.5,"sensor":null,"d":[1,2],"kind":"x"}}"#);
        let value = Json::parse(&json).unwrap();
        assert_eq!(brief(&value), "govern command{mode:active seq:7} now_s:1.5 d[1 2]");
    }

    #[test]
    fn a_block_is_shown_by_its_header_and_directory_also_when_it_is_cut() {
        let golden = "TkNQQgEAAgBoAAAALAAAAAUAAgADAAAAOAAAADEAAAAHAAQAAwAAAFAAAAB0aW1lc3NlbmRlcnMAAAAAAAD4PwAA\
                      AAAAAAVAAAAAAAAAIkAHAAAAAAAAAAcAAAAAAAAACQAAAAAAAAA=";
        let bytes = STANDARD.decode(golden).unwrap();
        let whole = directory(&bytes);
        assert_eq!(
            whole,
            [
                r#"a block of 104 bytes: magic "NCPB", version 1, flags 0, n_cols 2, total_len 104"#,
                r#"0: name "times" at 44+5, 3 rows of f64 at 56"#,
                r#"1: name "senders" at 49+7, 3 rows of i64 at 80"#,
            ]
        );
        assert_eq!(directory(&bytes[..30])[2], "1: the directory ends at byte 30");
        assert_eq!(directory(&bytes[..46])[1], "0: name beyond the end at 44+5, 3 rows of f64 at 56");
        assert_eq!(directory(&bytes[..11]), ["a block of 11 bytes, fewer than its header has"]);
    }
}
