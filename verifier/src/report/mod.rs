//! Telling people and machines what was found.
//!
//! [`Report`] is the one model of a result; it holds verdicts that were reached elsewhere. The renderers put it on a
//! terminal ([`terminal`]) and into files of any [`Format`], first of all JSON by `schemas/result.schema.json`
//! ([`Report::to_json`]), from which it is read again ([`Report::read`]); [`comparison`] shows what differs between two
//! results, [`expected_list`] writes the list of known failures. [`Progress`] shows a run while it goes on. None of
//! them computes a verdict.

mod badge;
mod comparison;
mod exchange;
mod expected;
mod format;
mod gate;
mod html;
mod junit;
mod layout;
mod markdown;
mod model;
mod named;
mod progress;
mod sarif;
mod shared;
mod terminal;
mod tsv;

pub use comparison::{Form, comparison};
pub use expected::expected_list;
pub use format::{Format, RenderError, render};
pub use gate::{GATE_FORMATS, GateForm, gate, gate_in};
pub use junit::junit;
pub use layout::{Style, wrap};
pub use model::{
    Asked, CaseReport, Corpus, CrashLogReport, DefectReport, DescriptionReport, DiagnosisReport, DifferenceReport,
    ExcuseReport, Exit, FormError, LevelReport, NotAsked, PeerReport, RateReport, ReadError, Report, RoleReport, Rule,
    RunReport, State, StoredRun, TallyReport, Tool, day_of, time_of,
};
pub use progress::Progress;
pub use terminal::{Detail, example, terminal};
