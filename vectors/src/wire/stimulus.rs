//! The stimulus frame within a request, which may leave out what the request says.

use super::encode::reversed;
use super::fields;
use super::place::Place;
use crate::case::{Case, File};
use crate::json::Json;
use crate::model::{explicit, meaning, minimal};
use crate::patch::patched;
use crate::roles::readers;
use crate::scenario::{Row, ScenarioError, Scenarios, source};

pub(super) fn file() -> Result<File, ScenarioError> {
    let mut text = Scenarios::read(source!("wire/stimulus"))?;
    let rows = text.rows("stimulus")?;
    text.end()?;
    let mut cases = rows.iter().map(within).collect::<Result<Vec<_>, _>>()?;
    let backwards = rows.iter().filter(|row| BACKWARDS.contains(&row.name)).map(within_backwards);
    cases.extend(backwards.collect::<Result<Vec<_>, _>>()?);
    let nested = Place::nested().into_iter().filter(|place| place.message.kind.is_some());
    cases.extend(nested.flat_map(|place| fields::cases_at(&place)));
    let about = "A stimulus frame within a request: what it may leave out, and what it must agree with.";
    Ok(File::new("wire", "stimulus_in_request", about, cases))
}

/// The rows of which there is a case with all members in reverse as well: the stimulus frame before what the request
/// says.
const BACKWARDS: [&str; 5] = [
    "fits/other-session-in-both",
    "misfit/kind-sensor_frame",
    "misfit/session-other",
    "misfit/version-older",
    "misfit/version-of-absent",
];

fn within_backwards(row: &Row) -> Result<Case, ScenarioError> {
    let mut case = ordered(row, true)?;
    case.path = format!("{}/backwards", case.path);
    case.title = format!("With its members in reverse: {}", case.title);
    Ok(case)
}

fn within(row: &Row) -> Result<Case, ScenarioError> {
    ordered(row, false)
}

fn ordered(row: &Row, is_reversed: bool) -> Result<Case, ScenarioError> {
    let kind = row.kind()?;
    let request = row.text("request")?;
    let (ground, changes) = request.split_once(" | ").unwrap_or((&request, ""));
    let ground = if ground == "minimal" { minimal(kind) } else { explicit(kind) };
    let stimulus = row.text("stimulus")?;
    let stimulus = match stimulus.strip_prefix("only ") {
        Some(members) => patched(Json::object(), members, row.place)?,
        None if stimulus == "empty" => Json::object(),
        None => patched(explicit("stimulus_frame"), &stimulus, row.place)?,
    };
    let frame = patched(ground, changes, row.place)?.with("stimulus", stimulus);
    let written = if is_reversed { reversed(frame.clone()) } else { frame.clone() };
    let case = row.case(readers(kind)).decode(kind, written.text());
    let text = || meaning(kind, &frame).text();
    Ok(match row.cell("expect")?.split_once(' ').unwrap_or((row.cell("expect")?, "")) {
        ("but", pointers) => case.means_but_for(text(), &pointers.split(' ').collect::<Vec<_>>()),
        ("means", _) => case.means(text()),
        ("or-reject", _) => case.means_or_rejects(text()),
        (code, _) => case.rejects(code),
    })
}
