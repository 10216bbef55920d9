//! An ESTOP is never lost.

use super::model::{Event, command};
use super::{buffer_case, buffer_row, go};
use crate::case::{Case, File};
use crate::json::Json;
use crate::patch::{self, patched, template};
use crate::scenario::{Row, ScenarioError, Scenarios, source};
use crate::template::Text;

pub(super) fn file() -> Result<File, ScenarioError> {
    let mut text = Scenarios::read(source!("resilience/estop"))?;
    let mut cases = Vec::new();
    for (group, stops) in [("latches", true), ("does-not-latch", false)] {
        for row in text.rows(group)? {
            cases.extend(traces(group, &row, stops)?);
        }
    }
    cases.extend(text.rest(buffer_row)?);
    cases.extend(escapes());
    let about = "ESTOP at the plant: frames that latch however malformed they are, frames that only look alike, and \
                 what a latch outlives.";
    Ok(File::new("resilience", "estop", about, cases))
}

/// The frame between active commands, and, if it is short, before them.
fn traces(group: &str, row: &Row, stops: bool) -> Result<Vec<Case>, ScenarioError> {
    let text = text_of(row)?.json();
    let (words, written) = (row.cell("words")?, row.cell("frame")?);
    let frame = |now| Event::Text { text: text.clone(), now, stops };
    let moving = [go(50, 1.0), Event::Ask(1.0), frame(1.0625), go(51, 1.125), Event::Ask(1.125)];
    let first = [frame(1.0), go(51, 1.0), Event::Ask(1.0)];
    let (rules, flag, verb, why) = if stops {
        (
            ["NCP-RES-022", "NCP-RES-021"],
            "lost-estop",
            "latches ESTOP",
            "Any JSON object of kind `command_frame` with a member `mode` of the value `estop` latches, whatever \
             else in \
             it is malformed, stale or out of order.",
        )
    } else {
        (
            ["NCP-RES-035", "NCP-RES-026"],
            "latch-by-likeness",
            "latches nothing",
            "It is no command frame in mode `estop`, so that nothing latches and the next active command moves the \
             plant.",
        )
    };
    let case = |when: &str, events: &[Event], at: &str| {
        buffer_case(format!("{group}/{}/{when}", row.name), &rules, events)
            .title(format!("{words} {verb} at a plant that {at}."))
            .flags(&[flag])
            .because(why)
    };
    let mut cases = vec![case("moving", &moving, "moves")];
    // What makes a frame long does so whatever came before it.
    if !["template", "numbered"].iter().any(|made| written.starts_with(made)) {
        cases.push(case("first", &first, "has seen nothing"));
    }
    if row.name == WITHOUT_A_CLOCK {
        for (name, now) in CLOCKS {
            let events = [go(50, 1.0), frame(now), Event::Ask(1.0625), go(51, 1.125), Event::Ask(1.125)];
            let at = format!("moves, though its clock reads {} then", name.replace('-', " "));
            cases.push(case(&format!("clock-{name}"), &events, &at));
        }
    }
    // The same bytes again, after a reset: a latch that was cleared says nothing of the next one.
    if AGAIN.contains(&row.name) {
        let reset = |now| [Event::Reset, go(50, now), Event::Ask(now)];
        let again = [&[frame(1.0)][..], &reset(1.0625), &[frame(1.125), go(51, 1.125), Event::Ask(1.125)]].concat();
        let unmoved = [frame(1.0), frame(1.0), Event::Reset, frame(1.0625), go(51, 1.125), Event::Ask(1.125)];
        cases.push(case("again", &again, "moves, and was reset after the same bytes"));
        cases.push(case("repeated", &unmoved, "was reset after the same bytes and has not moved since"));
    }
    Ok(cases)
}

/// Malformed ESTOPs of which one letter is an escape: each of those that they are known by.
fn escapes() -> Vec<Case> {
    const WORDS: [&str; 4] = ["kind", "command_frame", "mode", "estop"];
    let one = |word: &'static str, nth: usize| {
        let of = |own: &str| if own == word { patch::escaped(own, |at| at == nth) } else { own.to_owned() };
        let [kind, command, mode, estop] = WORDS.map(of);
        let text = Json::from(format!(r#"{{"{kind}":"{command}","{mode}":"{estop}","seq":1.5}}"#));
        let stop = Event::Text { text, now: 1.0625, stops: true };
        let moving = [go(50, 1.0), Event::Ask(1.0), stop, go(51, 1.125), Event::Ask(1.125)];
        let path = format!("latches/escaped-letter/{}-{}", word.replace('_', "-"), nth + 1);
        buffer_case(path, &["NCP-RES-022", "NCP-RES-021"], &moving)
            .title(format!("A malformed ESTOP in which letter {} of `{word}` is an escape latches.", nth + 1))
            .flags(&["lost-estop"])
            .because("Names and values are what their escapes stand for.")
    };
    WORDS
        .into_iter()
        .flat_map(|word| (0..word.len()).map(move |nth| (word, nth)))
        .map(|(word, nth)| one(word, nth))
        .collect()
}

/// A malformed frame that comes whatever the clock reads, and what that is.
const WITHOUT_A_CLOCK: &str = "seq-fraction";
const CLOCKS: [(&str, f64); 3] = [("nan", f64::NAN), ("infinity", f64::INFINITY), ("half-a-second-less", 0.5)];

/// Frames that come again in cases of their own: malformed in each way, and in good order.
const AGAIN: [&str; 6] =
    ["minimal", "seq-text", "no-version", "kind-and-mode-twice", "escaped-name-malformed", "everything-wrong"];

/// The text of a row: `raw` or `json` and a text, `template` and one that the runner makes, `numbered` and one of
/// [`numbered`], `members` and what stands behind many of them, or a command with its changes.
fn text_of(row: &Row) -> Result<Text, ScenarioError> {
    let cell = row.text("frame")?;
    if cell.starts_with("raw ") || cell.starts_with("json ") {
        return Ok(patch::written(&cell).into());
    }
    if let Some(text) = cell.strip_prefix("template ") {
        return Ok(template(text));
    }
    if let Some(text) = cell.strip_prefix("numbered ") {
        return Ok(numbered(text).into());
    }
    if let Some(behind) = cell.strip_prefix("members") {
        // Numbers in a frame that is in good order, and texts in one that is not.
        let value = |at: u32| if behind.is_empty() { at.to_string() } else { "\"\"".to_owned() };
        let members: String = (0..300).map(|at| format!("\"x{at}\":{},", value(at))).collect();
        return Ok(format!("{{{members}{}\"kind\":\"command_frame\",\"mode\":\"estop\"}}", behind.trim()).into());
    }
    let mut steps = row.steps_of("frame")?;
    let (step, changes) = steps.swap_remove(0).halves();
    Ok(patched(command(&step)?.frame(), &changes, row.place)?.text().into())
}

/// The text in which `<s#*9>` repeats `s#`, with its number for the `#`.
fn numbered(text: &str) -> String {
    let Some((before, (inside, after))) = text.split_once('<').and_then(|(a, b)| Some((a, b.split_once('>')?))) else {
        return text.to_owned();
    };
    let (part, times) = inside.split_once('*').unwrap_or((inside, "1"));
    let parts: String = (0..times.parse().unwrap_or(1)).map(|at: u32| part.replace('#', &at.to_string())).collect();
    format!("{before}{parts}{}", numbered(after))
}
