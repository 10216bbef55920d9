//! Planted defects: what the suite, the proofs and the fuzz targets have to notice.
//!
//! A [`Defect`] is data: the place of a source file, what stands there instead, the rules that this breaks, and who has
//! to notice it. The tables are the TOML files of this crate's folder, one format for all:
//!
//! ```toml
//! [[defect]]
//! name = "estop-is-hold"                       # lower case, with hyphens; once in a folder
//! about = "An inbound ESTOP becomes a HOLD."   # the defect, in a sentence
//! finding = "classic"                          # L01 … L35, `decision` (it inverts one), or `classic`
//! rules = ["NCP-SAFE-003"]                     # what it breaks; a suite has to name the first
//! properties = ["latch/gates"]                 # the properties that have to refute it
//! engines = ["symbolic"]                       # the engines that have to, if not all that know the property
//! targets = ["governor_trace"]                 # the fuzz targets that have to find it
//!
//! [defect.also]                                # what else it breaks on the way, and how
//! NCP-SAFE-005 = "The latch is not set."
//!
//! [[defect.edit]]
//! file = "spec/kernel/src/decisions/gates.rs"  # from the root of the repository
//! after = "let mode = plan.mode();"            # where the code stands twice: a text that stands once before it
//! code = "mode == Mode::Estop"                 # what is replaced
//! with = "false"                               # by what
//! ```
//!
//! A defect `of = ["one", "other"]` has the edits of others that stand before it. An edit with `always = true` is a
//! declaration that changes nothing by itself, such as a further field of a state, and is made also where the defect is
//! switched off.
//!
//! White space and trailing commas do not count where a place is looked for, so that a formatter moves no defect.
//!
//! - [`table`]: reads the files.
//! - [`place`]: finds a place, and plants one defect.
//! - [`copy`]: copies sources with one defect in them.
//! - [`weave`]: puts many defects into one text, each behind a switch.

#![forbid(unsafe_code)]

pub mod copy;
pub mod place;
pub mod table;
pub mod weave;

pub use place::PlaceError;
pub use table::{Defect, Edit, TableError, read};
