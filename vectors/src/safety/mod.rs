//! Area `safety`: the governor, gate by gate.

mod binding;
mod fence;
mod gates;
mod latch;
mod model;
mod numbers;
mod projection;
mod speed;
mod stale;
mod together;
mod zeroing;

use crate::case::{Case, File, Role};
use crate::command::Command;
use crate::scenario::{Row, ScenarioError};
pub(crate) use model::{Capabilities, Limits, Sensor, Spec, Step, Trace};

pub(crate) fn files() -> Result<Vec<File>, ScenarioError> {
    Ok(vec![
        binding::file()?,
        fence::file()?,
        gates::file()?,
        latch::file()?,
        numbers::file(),
        projection::file()?,
        speed::file()?,
        stale::file()?,
        together::file()?,
        together::longest(),
        zeroing::file()?,
    ])
}

/// A case of `governor.run` whose answers are the model's.
fn case(path: impl Into<String>, rules: &[&'static str], trace: &Trace) -> Case {
    latching(path, rules, trace).about_from(0)
}

/// The same of a trace whose steps are about several rules.
fn latching(path: impl Into<String>, rules: &[&'static str], trace: &Trace) -> Case {
    let case = Case::new(path, rules, &[Role::Commander]).call("governor.run", trace.args());
    let mut case = case.decided_by(&trace.rules());
    for place in trace.kept() {
        case = case.by(place, model::PASSES);
    }
    if trace.has_writable_limits() { case.shows(trace.pattern()) } else { case.shows_or_refuses(trace.pattern()) }
}

/// A case of the trace of a row.
fn row_case(row: &Row) -> Result<Case, ScenarioError> {
    let case = latching(&row.path, &row.rules, &Trace::of(row)?);
    Ok(case.title(&row.title).flags(&row.flags).because(&row.why))
}

/// A command that passes every gate.
fn good() -> Command {
    Command::moving(&[1.0, 0.0, 0.0])
}

/// A sensor within a fence of 5 m: 3 m from the origin.
fn near() -> Sensor {
    Sensor::at(&[1.0, 2.0, 2.0])
}
