//! Area `wire`: frames, fields, numbers, enums, encoders, pins, replies.

mod encode;
mod fields;
mod kinds;
mod late;
mod members;
mod numbers;
mod partial;
mod pins;
mod place;
mod reply;
mod roads;
mod session_id;
mod spellings;
mod stimulus;

use crate::case::File;
use crate::scenario::ScenarioError;
pub(crate) use members::versions_of_errors;
pub(crate) use reply::reply;
pub(crate) use roads::{commands, requests};

/// The rule that a plain value is read as the frame gives it.
pub(crate) const READ: &str = "NCP-WIRE-034";

/// The rule that a field is written as the program set it.
const WRITE: &str = "NCP-WIRE-093";

pub(crate) fn files() -> Result<Vec<File>, ScenarioError> {
    let mut files = fields::files();
    files.extend([
        spellings::file(),
        members::file()?,
        late::file(),
        kinds::file(),
        session_id::file(),
        stimulus::file()?,
        pins::file(),
        partial::file(),
        reply::file()?,
        roads::replies(),
    ]);
    files.extend(encode::files());
    Ok(files)
}
