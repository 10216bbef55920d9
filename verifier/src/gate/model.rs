//! The one model of what a gate says. Its JSON form is that of `schemas/gate.schema.json`.

use std::time::{Duration, SystemTime};

use serde::{Deserialize, Serialize};

use super::{Kind, Row};
use crate::report::{Exit, Tool, time_of};

/// What a gate says.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GateReport {
    /// The format of this model.
    pub format: u32,
    /// What made it.
    pub tool: Tool,
    /// When it began, RFC 3339 in UTC.
    pub started: String,
    /// How long it took, in seconds.
    pub elapsed_s: f64,
    /// What the tree was held against.
    pub against: Against,
    /// Whether it is open.
    pub verdict: Verdict,
    /// Every row, in order.
    pub rows: Vec<RowReport>,
}

/// What went out before.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Against {
    /// What it is.
    pub kind: Kind,
    /// Its name: a tag, or a path.
    pub name: String,
    /// Its wire version, if it says one.
    pub wire_version: Option<String>,
    /// Its contract hash, if it says one.
    pub contract_hash: Option<String>,
}

/// Whether a gate is open.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// Every row that was asked for passed, or need not be run.
    Open,
    /// One failed, or was not run.
    Shut,
    /// Somebody ended it.
    Interrupted,
}

/// What a row says.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RowReport {
    /// Its name.
    pub name: String,
    /// What it asks.
    pub about: String,
    /// How it ended.
    pub state: RowState,
    /// What there is to say in a line.
    pub said: String,
    /// What is wrong.
    pub findings: Vec<Finding>,
    /// What to do, unless it passed.
    pub remedy: Option<String>,
    /// What asks the same alone.
    pub command: String,
    /// How long it took, in seconds.
    pub elapsed_s: f64,
}

/// How a row ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum RowState {
    /// Nothing is wrong.
    Passed,
    /// Something is wrong.
    Failed,
    /// It could not be run: a tool or a file is missing.
    NotRun,
    /// It could not be run, and need not be.
    Allowed,
    /// It was not asked for.
    LeftOut,
}

/// One thing that is wrong.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Finding {
    /// What.
    pub text: String,
    /// The file that it is about, from the root of the tree.
    pub file: Option<String>,
    /// The line, counted from 1.
    pub line: Option<u32>,
    /// The rule of the tool that found it.
    pub rule: Option<String>,
}

impl GateReport {
    pub(super) fn new(
        against: Against,
        rows: Vec<RowReport>,
        interrupted: bool,
        (started, elapsed): (SystemTime, Duration),
    ) -> Self {
        let is_good = |row: &RowReport| !matches!(row.state, RowState::Failed | RowState::NotRun);
        let verdict = match rows.iter().all(is_good) {
            _ if interrupted => Verdict::Interrupted,
            true => Verdict::Open,
            false => Verdict::Shut,
        };
        Self {
            format: 1,
            tool: Tool::this(),
            started: time_of(started),
            elapsed_s: elapsed.as_secs_f64(),
            against,
            verdict,
            rows,
        }
    }

    /// How the program ends.
    #[must_use]
    pub fn exit(&self) -> Exit {
        match self.verdict {
            Verdict::Open => Exit::Conformant,
            Verdict::Shut => Exit::NotConformant,
            Verdict::Interrupted => Exit::Interrupted,
        }
    }

    /// How many rows ended so.
    #[must_use]
    pub fn count(&self, state: RowState) -> usize {
        self.rows.iter().filter(|row| row.state == state).count()
    }
}

impl Verdict {
    /// As the result has it.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Open => "open",
            Self::Shut => "shut",
            Self::Interrupted => "interrupted",
        }
    }
}

impl RowState {
    /// As people read it.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Passed => "passed",
            Self::Failed => "FAILED",
            Self::NotRun => "not run",
            Self::Allowed => "allowed",
            Self::LeftOut => "left out",
        }
    }
}

impl RowReport {
    /// A row that was run.
    pub(super) fn ran(row: &Row, said: String, findings: Vec<Finding>, time: Duration) -> Self {
        let failed = !findings.is_empty();
        let said = match &findings[..] {
            [] => said,
            [one] if said.is_empty() => one.text.lines().next().unwrap_or_default().to_owned(),
            several if said.is_empty() => format!("{} things are wrong", several.len()),
            _ => said,
        };
        let state = if failed { RowState::Failed } else { RowState::Passed };
        let remedy = failed.then(|| row.remedy.to_owned());
        Self { findings, ..Self::unrun(row, state, said, remedy, time) }
    }

    /// A row that was not.
    pub(super) fn unrun(row: &Row, state: RowState, why: String, remedy: Option<String>, time: Duration) -> Self {
        Self {
            name: row.name.to_owned(),
            about: row.about.to_owned(),
            state,
            said: why,
            findings: Vec::new(),
            remedy,
            command: row.command.to_owned(),
            elapsed_s: time.as_secs_f64(),
        }
    }
}

impl Finding {
    /// Something wrong that is nowhere in particular.
    #[must_use]
    pub fn new(text: impl Into<String>) -> Self {
        Self { text: text.into(), file: None, line: None, rule: None }
    }

    /// Something wrong in a file.
    #[must_use]
    pub fn at(file: &str, line: Option<u32>, text: impl Into<String>) -> Self {
        Self { file: Some(file.to_owned()), line, ..Self::new(text) }
    }

    /// By a rule of the tool that found it.
    #[must_use]
    pub fn by(self, rule: &str) -> Self {
        Self { rule: Some(rule.to_owned()), ..self }
    }

    /// Where, as compilers write it.
    #[must_use]
    pub fn place(&self) -> Option<String> {
        let file = self.file.as_deref()?;
        Some(self.line.map_or_else(|| file.to_owned(), |line| format!("{file}:{line}")))
    }
}
