//! The stimulus frame within a request, which may leave out what the request says.

use super::fields;
use super::place::Place;
use crate::case::{Case, File};
use crate::json::Json;
use crate::model::{explicit, meaning, minimal};
use crate::patch::patched;
use crate::roles::readers;
use crate::scenario::{Row, ScenarioError, Scenarios, source};

pub(super) fn file() -> Result<File, ScenarioError> {
    let mut cases = Scenarios::read(source!("wire/stimulus"))?.rest(within)?;
    let nested = Place::nested().into_iter().filter(|place| place.message.kind.is_some());
    cases.extend(nested.flat_map(|place| fields::cases_at(&place)));
    let about = "A stimulus frame within a request: what it may leave out, and what it must agree with.";
    Ok(File::new("wire", "stimulus_in_request", about, cases))
}

fn within(row: &Row) -> Result<Case, ScenarioError> {
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
    let case = row.case(readers(kind)).decode(kind, frame.text());
    let text = || meaning(kind, &frame).text();
    Ok(match row.cell("expect")?.split_once(' ').unwrap_or((row.cell("expect")?, "")) {
        ("but", pointers) => case.means_but_for(text(), &pointers.split(' ').collect::<Vec<_>>()),
        ("means", _) => case.means(text()),
        ("or-reject", _) => case.means_or_rejects(text()),
        (code, _) => case.rejects(code),
    })
}
