//! Proofs of the safety path around the kernel: what zeroes frames and binds channels, what finds an ESTOP in any
//! bytes, what counts losses, and the loop that brings them together.
//!
//! | module | what it holds |
//! |---|---|
//! | [`subject`] | the parts of the path as a harness calls them, with their state in sight |
//! | [`spies`] | what stands around a loop, and notes what it is asked |
//! | [`engine`] | a harness on every combination of what it picks from |
//! | [`claims`] | what is claimed, in words and in symbols |
//! | [`estop`], [`governor`], [`link`], [`number`], [`control`], [`liveness`] | the harnesses |
//! | [`subjects`] | the sources of the specification, and copies with a planted defect |

#![forbid(unsafe_code)]

pub mod claims;
pub mod control;
pub mod engine;
pub mod estop;
pub mod governor;
pub mod link;
pub mod liveness;
pub mod number;
pub mod spies;
pub mod subject;

#[allow(missing_docs, unreachable_pub, reason = "copies of sources")]
/// The sources, which the build script copies from the specification: as they are, and with a planted defect.
pub mod subjects {
    include!(concat!(env!("OUT_DIR"), "/subjects.rs"));

    /// The name of the sources as they are.
    pub const PRODUCTION: &str = "production";

    /// The planted defects.
    ///
    /// # Errors
    /// The table cannot be read.
    pub fn defects() -> Result<Vec<ncp_defects::Defect>, ncp_defects::TableError> {
        ncp_defects::read(&std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../defects/path.toml"))
    }
}
