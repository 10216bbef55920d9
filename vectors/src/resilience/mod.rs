//! Area `resilience`: the watchdog, the action buffer, horizons, the link monitor.

mod buffer;
mod estop;
mod horizon;
mod link;
mod liveness;
mod model;
mod watchdog;

use crate::case::{Case, File, Role};
use model::{Event, active, buffer};

pub(crate) fn files() -> Vec<File> {
    let mut files =
        vec![watchdog::file(), buffer::file(), estop::file(), horizon::replay(), horizon::lengths(), link::file()];
    files.extend(liveness::files());
    files
}

/// What becomes of an action buffer that sees these events.
fn buffer_case(path: impl Into<String>, rules: &[&'static str], events: &[Event]) -> Case {
    let (args, pattern) = buffer(events);
    Case::new(path, rules, &[Role::Body]).call("buffer.run", args).shows(pattern)
}

/// A command that moves the plant.
fn go(seq: i64, now: f64) -> Event {
    Event::Command(active(seq), now)
}
