//! What a strict client accepts as the reply to its request.

use crate::case::File;
use crate::model::explicit;
use crate::scenario::{ScenarioError, Scenarios, source};
use crate::wire::reply;

pub(super) fn file() -> Result<File, ScenarioError> {
    let text = Scenarios::read(source!("strict/replies"))?;
    let cases = text.rest(|row| Ok(reply(row, explicit(&row.fill("{pair.name}")?))?.strictly()))?;
    let about = "What a strict client accepts as the reply to its request.";
    Ok(File::new("strict", "replies", about, cases))
}
