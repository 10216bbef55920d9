//! Sabotaged engines: the symbolic engine with a defect of its own, which its run has to notice.
//!
//! With the feature `sabotage` the build script weaves the defects of [`TABLE`] into a copy of the engine's sources,
//! each behind a switch. The engine as it is has no switches.

use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

use ncp_defects::{Defect, TableError, read};
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// The defects of the engine, from the root of the project.
pub const TABLE: &str = "defects/engine.toml";
/// Whether the switches are part of this build.
pub const IS_BUILT: bool = cfg!(feature = "sabotage");

/// None is switched on.
const NONE: usize = usize::MAX;
static ON: AtomicUsize = AtomicUsize::new(NONE);

/// What came of a sabotaged engine.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Sabotaged {
    /// The defect's name.
    pub id: String,
    /// The defect, in a sentence.
    pub about: String,
    /// The error with which the run ended; none where it did not notice.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub noticed: Option<String>,
}

/// Why an engine cannot be sabotaged.
#[derive(Debug, Error)]
pub enum SabotageError {
    /// The table cannot be read.
    #[error(transparent)]
    Table(#[from] TableError),
    /// The table has no such defect.
    #[error("{TABLE} has no defect {0}")]
    Unknown(String),
    /// The build has no switches.
    #[error("this build has no sabotaged engines; the feature `sabotage` has them")]
    NotBuilt,
}

/// All defects of the engine.
///
/// # Errors
/// The table cannot be read.
pub fn defects() -> Result<Vec<Defect>, TableError> {
    read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(TABLE))
}

/// Switches a defect on, for the rest of this program.
///
/// # Errors
/// There is no such defect, or no switch in this build.
pub fn switch_on(name: &str) -> Result<(), SabotageError> {
    let place = defects()?.iter().position(|defect| defect.name == name);
    let number = place.ok_or_else(|| SabotageError::Unknown(name.to_owned()))?;
    if !IS_BUILT {
        return Err(SabotageError::NotBuilt);
    }
    ON.store(number, Ordering::Relaxed);
    Ok(())
}

/// Whether the defect of a number is switched on.
#[cfg(feature = "sabotage")]
pub(crate) fn is(number: usize) -> bool {
    ON.load(Ordering::Relaxed) == number
}
