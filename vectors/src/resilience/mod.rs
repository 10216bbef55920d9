//! Area `resilience`: the watchdog, the action buffer, horizons, the link monitor.

mod buffer;
mod estop;
mod horizon;
mod link;
mod liveness;
mod model;
mod watchdog;

use crate::case::{Case, File, Role};
use crate::command::active;
use crate::scenario::{Row, ScenarioError};
pub(crate) use model::{Event, Run, buffer, events, watchdog};

pub(crate) fn files() -> Result<Vec<File>, ScenarioError> {
    let mut files =
        vec![watchdog::file()?, buffer::file()?, estop::file()?, horizon::replay()?, horizon::lengths(), link::file()?];
    files.extend(liveness::files());
    Ok(files)
}

/// What becomes of an action buffer that sees these events.
fn buffer_case(path: impl Into<String>, rules: &[&'static str], events: &[Event]) -> Case {
    let (args, pattern, decided) = buffer(events, false);
    Case::new(path, rules, &[Role::Body]).call("buffer.run", args).shows(pattern).decided_by(&decided)
}

/// The same of a row.
fn buffer_row(row: &Row) -> Result<Case, ScenarioError> {
    let (args, pattern, decided) = buffer(&events(row)?, false);
    Ok(row.case(&[Role::Body]).call("buffer.run", args).shows(pattern).decided_by(&decided))
}

/// A command that moves the plant.
pub(crate) fn go(seq: i64, now: f64) -> Event {
    Event::Command(active(seq), now)
}
