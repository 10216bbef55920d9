//! Telling people and machines what was found.
//!
//! [`Report`] is the one model of a result; it holds verdicts that were reached elsewhere. The renderers put it on a
//! terminal ([`terminal`]), into a JSON file whose form is `schemas/result.schema.json` ([`Report::to_json`]), and into
//! JUnit XML ([`junit`]); [`comparison`] shows what differs between two results. [`Progress`] shows a run while it goes on. None of them computes a verdict.

mod comparison;
mod expected;
mod junit;
mod layout;
mod model;
mod progress;
mod terminal;

pub use comparison::{Form, comparison};
pub use expected::expected_list;
pub use junit::junit;
pub use layout::{Style, wrap};
pub use model::{
    Asked, CaseReport, Corpus, CrashLogReport, DifferenceReport, ExcuseReport, Exit, LevelReport, NotAsked, PeerReport,
    RateReport, Report, RoleReport, Rule, RunReport, State, Tool, today,
};
pub use progress::Progress;
pub use terminal::{Detail, terminal};
