//! The quality of service of the four planes.

use crate::case::{Case, File};
use crate::json::object;
use crate::scenario::{Row, ScenarioError, Scenarios, source};

pub(super) fn file() -> Result<File, ScenarioError> {
    let cases = Scenarios::read(source!("keys/planes"))?.rest(plane)?;
    Ok(File::new("keys", "planes", "The quality of service of the four planes.", cases))
}

fn plane(row: &Row) -> Result<Case, ScenarioError> {
    let qos = object! {
        "congestion" => row.cell("congestion")?,
        "priority" => row.cell("priority")?,
        "express" => row.cell("is")? == "is",
    };
    Ok(row.case(&row.roles()?).call("plane.qos", object! { "plane" => row.name }).gives(qos))
}
