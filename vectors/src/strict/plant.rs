//! A strict plant: which commands it follows, and what the others leave behind, which is nothing.

use crate::case::{Case, File, Role};
use crate::patch::template;
use crate::resilience::{Event, buffer, events, go};
use crate::scenario::{Row, ScenarioError, Scenarios, source};

pub(super) fn file() -> Result<File, ScenarioError> {
    let mut text = Scenarios::read(source!("strict/plant"))?;
    let mut cases = Vec::new();
    for group in [
        "followed",
        "first-seq",
        "first-version",
        "dropped",
        "fallen",
        "kept-seq",
        "kept-version",
        "version",
        "hold",
        "estop",
    ] {
        // Of what is kept the whole trace is about: the commands differ in nothing that a plant could show besides.
        let about = |case: Case| if group.starts_with("kept") { case.about_from(0) } else { case };
        cases.extend(text.cases(group, |row| Ok(about(case(row, &events(row)?))))?);
    }
    cases.extend(text.cases("estop-broken", broken_stop)?);
    cases.extend(text.rest(|row| Ok(case(row, &events(row)?)))?);
    let about = "A strict plant: commands that advance, and those that are rejected or dropped and change nothing, \
                 ESTOP \
                 aside.";
    Ok(File::new("strict", "plant", about, cases))
}

fn case(row: &Row, events: &[Event]) -> Case {
    let (args, pattern, decided) = buffer(events, true);
    row.case(&[Role::Body]).call("buffer.run", args).strictly().shows(pattern).decided_by(&decided)
}

/// An ESTOP in a frame that no receiver reads, between commands that move.
fn broken_stop(row: &Row) -> Result<Case, ScenarioError> {
    let stop = Event::Text { text: template(&row.text("frame")?).json(), now: 1.0625, stops: true };
    Ok(case(row, &[go(5, 1.0), stop, Event::Ask(1.0625), go(6, 1.125), Event::Ask(1.125)]))
}
