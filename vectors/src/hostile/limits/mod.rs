//! Frames at the limits of section 1.6, and one beyond.

mod borders;
mod counts;
mod depths;
mod sizes;
mod stretch;
mod strings;

use crate::case::File;

const MIB: usize = 1 << 20;
/// The most bytes of an `observation_frame`.
const OBSERVATION: usize = 64 * MIB;
/// The most levels.
const LEVELS: usize = 64;
/// The most entries of a map and items of an array.
const ENTRIES: usize = 4096;

pub(super) fn file() -> File {
    let about = "Frames at a limit, which are read, and frames beyond it, which are rejected.";
    let cases = [sizes::cases(), depths::cases(), counts::cases(), strings::cases(), borders::cases()].concat();
    File::new("hostile", "limits", about, cases)
}
