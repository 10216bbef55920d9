//! Area `resilience`: the watchdog, the action buffer, horizons, the link monitor.

mod buffer;
mod endures;
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
    files.extend([crate::wire::commands(), endures::file()]);
    Ok(files)
}

/// Powers of two seconds that a clock may read: three weeks, 68 years and longer.
const FAR: [i32; 3] = [21, 31, 40];

/// The power as a time, and a ttl in ms that ends just before it when it begins a second before it: closer to it than
/// doubles are there. That second, the age and both times in ms are exact.
fn second_at(power: i32) -> (f64, f64) {
    (2.0_f64.powi(power), 1000.0 * (1.0 - 2.0_f64.powi(power - 55)))
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
