//! What a client accepts as a reply, by chapter 4.

use crate::case::Role::Commander;
use crate::case::{Case, File};
use crate::json::{Json, object};
use crate::model::{explicit, minimal};
use crate::patch::patched;
use crate::scenario::{Row, ScenarioError, Scenarios, source};

pub(super) fn file() -> Result<File, ScenarioError> {
    let cases = Scenarios::read(source!("wire/reply"))?.rest(|row| reply(row, minimal(&row.fill("{pair.name}")?)))?;
    Ok(File::new("wire", "reply", "What a client accepts as the reply to its request.", cases))
}

/// A case of a row: a reply to that request.
pub(crate) fn reply(row: &Row, request: Json) -> Result<Case, ScenarioError> {
    let cell = row.text("frame")?;
    let (frame, changes) = cell.split_once(" | ").unwrap_or((&cell, ""));
    let (ground, kind) = frame.split_once(' ').unwrap_or((frame, ""));
    let text = minimal(kind).text();
    let reply = match ground {
        "explicit" => patched(explicit(kind), changes, row.place)?.text(),
        "minimal" => patched(minimal(kind), changes, row.place)?.text(),
        "raw" => kind.to_owned(),
        "array" => format!("[{text}]"),
        "cut" => text.trim_end_matches('}').to_owned(),
        "twice" => text.repeat(2),
        ground => return Err(row.place.wants("frame of a reply", ground)),
    };
    let (request, expect) = match row.cell("expect")?.split_once('-') {
        Some((expect, session)) => (request.with("session_id", Json::string(session)), expect),
        None => (request, row.cell("expect")?),
    };
    let case = row.case(&[Commander]).call("reply.check", object! { "request" => request.text(), "reply" => reply });
    Ok(if expect == "accept" { case.accepts() } else { case.rejects(expect) })
}
