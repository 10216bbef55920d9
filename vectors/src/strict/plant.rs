//! A strict plant: which commands it follows, and what the others leave behind, which is nothing.

use ncp_text::WIRE_VERSION;

use crate::case::{Case, File, Role};
use crate::json::Json;
use crate::patch::template;
use crate::resilience::{Event, buffer, events, go};
use crate::scenario::{Row, ScenarioError, Scenarios, source};

pub(super) fn file() -> Result<File, ScenarioError> {
    let mut text = Scenarios::read(source!("strict/plant"))?;
    let mut cases = Vec::new();
    for group in ["followed", "first-seq", "first-version", "dropped", "fallen"] {
        cases.extend(text.cases(group, plain)?);
    }
    cases.extend(text.cases("kept-seq", of_what_is_kept)?);
    cases.extend(text.cases("kept-version", of_what_is_kept)?);
    cases.extend(text.cases("kept-clock", of_what_is_kept)?);
    for group in ["version", "hold", "estop"] {
        cases.extend(text.cases(group, plain)?);
    }
    cases.extend(text.cases("estop-broken", broken_stop)?);
    cases.extend(text.cases("rejected", rejected)?);
    for group in ["reset", "reset-seq", "reset-version", "stream"] {
        cases.extend(text.cases(group, plain)?);
    }
    cases.extend(text.cases("kept-stream", of_what_is_kept)?);
    cases.extend(text.rest(plain)?);
    cases.push(late_version());
    let about = "A strict plant: commands that advance, and those that are rejected or dropped and change nothing, \
                 ESTOP \
                 aside.";
    Ok(File::new("strict", "plant", about, cases))
}

fn case(row: &Row, events: &[Event]) -> Case {
    let (args, pattern, decided) = buffer(events, true);
    row.case(&[Role::Body]).call("buffer.run", args).strictly().shows(pattern).decided_by(&decided)
}

fn plain(row: &Row) -> Result<Case, ScenarioError> {
    Ok(case(row, &events(row)?))
}

/// A case that is about the whole trace: its commands differ in nothing that a plant could show besides.
fn of_what_is_kept(row: &Row) -> Result<Case, ScenarioError> {
    Ok(plain(row)?.about_from(0))
}

/// An ESTOP in a frame that no receiver reads, between commands that move.
fn broken_stop(row: &Row) -> Result<Case, ScenarioError> {
    let stop = Event::Text { text: template(&row.text("frame")?).json(), now: 1.0625, stops: true };
    Ok(case(row, &[go(5, 1.0), stop, Event::Ask(1.0625), go(6, 1.125), Event::Ask(1.125)]))
}

/// A frame that no receiver reads and that is no ESTOP, between commands that move.
fn rejected(row: &Row) -> Result<Case, ScenarioError> {
    let frame = Event::Text { text: template(&row.text("frame")?).json(), now: 1.0625, stops: false };
    let events = [go(5, 1.0), frame, Event::Ask(1.125), go(6, 1.1875), Event::Ask(1.1875)];
    Ok(case(row, &events).about_from(0))
}

/// Commands whose versions stand behind many members.
fn late_version() -> Case {
    let (args, pattern, decided) = buffer(&[go(1, 1.0), Event::Ask(1.125), go(2, 1.25), Event::Ask(1.25)], true);
    let own = format!("\"ncp_version\":\"{WIRE_VERSION}\"");
    let members: String = (0..70).map(|nth| format!(",\"n{nth}\":0")).collect();
    let late = |step: Json| match step.get("text").and_then(Json::as_str) {
        Some(text) => {
            let text = text.replacen(&format!("{own},"), "", 1);
            let text = format!("{}{members},{own}}}", text.strip_suffix('}').unwrap_or(&text));
            step.with("text", text.into())
        }
        None => step,
    };
    let args = args.edit(&["steps"], |steps| match steps {
        Json::Array(steps) => steps.into_iter().map(late).collect(),
        other => other,
    });
    Case::new("followed/versions-behind-70", &["NCP-STRICT-012", "NCP-RES-026"], &[Role::Body])
        .title("A strict plant follows commands whose versions stand behind seventy members.")
        .flags(&["over-strict"])
        .call("buffer.run", args)
        .strictly()
        .shows(pattern)
        .decided_by(&decided)
        .because("The order of members does not count, nor does their number.")
}
