//! What a gate says, on a terminal and in the formats of files.

use std::time::Duration;

use quick_junit::{NonSuccessKind, Report as JunitReport, TestCase, TestCaseStatus, TestSuite};
use serde_json::{Value, json};

use super::format::{Format, RenderError};
use super::layout::{Style, cut, wrap};
use super::sarif::SCHEMA;
use crate::gate::{Finding, GateReport, ROWS, RowReport, RowState, Verdict};

/// The formats in which a gate is written: those for cases do not fit it.
pub const GATE_FORMATS: [Format; 4] = [Format::Json, Format::Junit, Format::Markdown, Format::Sarif];

/// How many findings of a row are named on a terminal, and in a summary.
const NAMED: usize = 5;
/// How many lines of a finding.
const LINES: usize = 14;

/// How much a terminal is shown of a gate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct GateForm {
    /// Colours and width.
    pub style: Style,
    /// Every finding, in full.
    pub verbose: bool,
}

/// Renders what a gate says for a terminal: a table of the rows, what is wrong with what to do, and the verdict.
#[must_use]
pub fn gate(report: &GateReport, form: GateForm) -> String {
    let style = form.style;
    let mut out = wrap(&format!("held against {}", against(report)), style.width, "", "  ") + "\n";
    let name = ROWS.iter().map(|row| row.name.len()).max().unwrap_or_default();
    out += &style.bold(&format!("{:name$}  {:10}  what", "row", "state"));
    out.push('\n');
    for row in &report.rows {
        let state = format!("{} {:8}", mark(row.state), row.state.as_str());
        let head = format!("{:name$}  {}  ", row.name, paint(style, row.state, &state));
        let room = style.width.saturating_sub(name + 2 + 10 + 2);
        out += &format!("{head}{}\n", cut(&row.said, room));
    }
    for row in report.rows.iter().filter(|row| row.remedy.is_some()) {
        out.push('\n');
        out += &style.bold(&wrap(&format!("{}: {}", row.name, row.about), style.width, "", "  "));
        out.push('\n');
        let shown = if form.verbose { row.findings.len() } else { NAMED };
        for finding in row.findings.iter().take(shown) {
            out += &of_finding(finding, style, form.verbose);
        }
        if row.findings.len() > shown {
            out += &format!("  and {} more: --verbose\n", row.findings.len() - shown);
        }
        if row.findings.is_empty() {
            out += &format!("{}\n", wrap(&row.said, style.width, "  ? ", "    "));
        }
        let remedy = row.remedy.as_deref().unwrap_or_default();
        out += &format!("{}\n", wrap(&format!("to do: {remedy}"), style.width, "  ", "    "));
        out += &style.dim(&wrap(&format!("alone: {}", row.command), style.width, "  ", "    "));
        out.push('\n');
    }
    let verdict = wrap(&verdict(report), style.width, "", "  ");
    let verdict = if report.verdict == Verdict::Open { style.green(&verdict) } else { style.red(&verdict) };
    out + "\n" + &verdict + "\n"
}

/// Renders what a gate says in a format of [`GATE_FORMATS`]; none: it does not fit.
///
/// # Errors
/// [`RenderError`] if it cannot be written, which does not occur.
pub fn gate_in(report: &GateReport, format: Format) -> Result<Option<String>, RenderError> {
    Ok(Some(match format {
        Format::Json => serde_json::to_string_pretty(report)? + "\n",
        Format::Junit => junit(report)?,
        Format::Markdown => markdown(report),
        Format::Sarif => serde_json::to_string_pretty(&sarif(report))? + "\n",
        Format::Html | Format::Tsv | Format::Badge | Format::Shields => return Ok(None),
    }))
}

fn against(report: &GateReport) -> String {
    let against = &report.against;
    let wire = against.wire_version.as_deref().map_or_else(String::new, |wire| format!(", wire {wire}"));
    format!("{} {}{wire}", against.kind.as_str(), against.name)
}

/// The gate in a sentence.
fn verdict(report: &GateReport) -> String {
    let counted = |state: RowState, one: &str, many: &str| match report.count(state) {
        0 => None,
        1 => Some(format!("1 row {one}")),
        count => Some(format!("{count} rows {many}")),
    };
    let parts = [
        counted(RowState::Failed, "failed", "failed"),
        counted(RowState::NotRun, "was not run", "were not run"),
        counted(RowState::Passed, "passed", "passed"),
        counted(RowState::Allowed, "was not run, and need not be", "were not run, and need not be"),
        counted(RowState::LeftOut, "was left out", "were left out"),
    ];
    let parts: Vec<String> = parts.into_iter().flatten().collect();
    let gate = match report.verdict {
        Verdict::Open => "the gate is open",
        Verdict::Shut => "the gate is shut",
        Verdict::Interrupted => "interrupted: the gate is shut",
    };
    format!("{gate}: {}", parts.join(", "))
}

fn mark(state: RowState) -> char {
    match state {
        RowState::Passed => '✓',
        RowState::Failed => '✗',
        RowState::NotRun | RowState::Allowed => '?',
        RowState::LeftOut => '-',
    }
}

fn paint(style: Style, state: RowState, text: &str) -> String {
    match state {
        RowState::Passed => style.green(text),
        RowState::Failed => style.red(text),
        RowState::NotRun | RowState::Allowed => style.yellow(text),
        RowState::LeftOut => style.dim(text),
    }
}

fn of_finding(finding: &Finding, style: Style, verbose: bool) -> String {
    let place = finding.place().map_or_else(String::new, |place| format!("{place}: "));
    let rule = finding.rule.as_deref().map_or_else(String::new, |rule| format!(" [{rule}]"));
    let mut lines = finding.text.lines();
    let first = format!("{place}{}{rule}", lines.next().unwrap_or_default());
    let mut out = format!("{} {}\n", style.red("  ✗"), wrap(&first, style.width, "    ", "    ").trim_start());
    let rest: Vec<&str> = lines.collect();
    let shown = if verbose { rest.len() } else { rest.len().min(LINES) };
    for line in &rest[..shown] {
        out += &format!("    | {}\n", cut(line, style.width.saturating_sub(6)));
    }
    out
}

fn markdown(report: &GateReport) -> String {
    let mark = |state: RowState| match state {
        RowState::Passed => "✅",
        RowState::Failed => "❌",
        RowState::NotRun => "❓",
        RowState::Allowed => "☑️",
        RowState::LeftOut => "⏭️",
    };
    let mut out = format!("## Gate: {}\n\nHeld against {}.\n\n", report.verdict.as_str(), cell(&against(report)));
    out += "| row | state | what |\n|---|---|---|\n";
    for row in &report.rows {
        out += &format!("| {} | {} {} | {} |\n", row.name, mark(row.state), row.state.as_str(), cell(&row.said));
    }
    for row in report.rows.iter().filter(|row| row.remedy.is_some()) {
        out += &format!("\n### {}\n\n{}.\n\n", row.name, cell(&row.about));
        if row.findings.is_empty() {
            out += &format!("- {}\n", cell(&row.said));
        }
        for finding in row.findings.iter().take(4 * NAMED) {
            let place = finding.place().map_or_else(String::new, |place| format!("`{place}`: "));
            let mut lines = finding.text.lines();
            out += &format!("- {place}{}\n", cell(lines.next().unwrap_or_default()));
            let rest: Vec<&str> = lines.take(LINES).collect();
            if !rest.is_empty() {
                out += &format!("\n  ```\n  {}\n  ```\n", rest.join("\n  "));
            }
        }
        if row.findings.len() > 4 * NAMED {
            out += &format!("- and {} more\n", row.findings.len() - 4 * NAMED);
        }
        out += &format!("\nTo do: {}. Alone: `{}`.\n", cell(row.remedy.as_deref().unwrap_or_default()), row.command);
    }
    out + &format!("\n{}.\n\n<sub>ncp-verify {}</sub>\n", verdict(report), report.tool.version)
}

/// A text within a line of Markdown, as it is.
fn cell(text: &str) -> String {
    let is_markup = |c: char| matches!(c, '|' | '<' | '>' | '*' | '_' | '`' | '[' | ']' | '\\');
    text.chars().flat_map(|c| is_markup(c).then_some('\\').into_iter().chain([c])).collect()
}

/// A test a row: what was not run fails the gate, and is an error; what need not be run is skipped.
fn junit(report: &GateReport) -> Result<String, quick_junit::SerializeError> {
    let mut junit = JunitReport::new(report.tool.name.clone());
    let mut suite = TestSuite::new("gate");
    suite.add_test_cases(report.rows.iter().map(test));
    suite.set_time(seconds(report.elapsed_s));
    junit.set_time(seconds(report.elapsed_s));
    junit.add_test_suite(suite);
    junit.to_string()
}

fn test(row: &RowReport) -> TestCase {
    let non_success = |kind: NonSuccessKind, name: &str| {
        let mut status = TestCaseStatus::non_success(kind);
        status.set_type(name).set_message(row.said.clone());
        let mut lines: Vec<String> = row.findings.iter().map(in_text).collect();
        lines.extend(row.remedy.iter().map(|remedy| format!("to do: {remedy}")));
        status.set_description(lines.join("\n"));
        status
    };
    let status = match row.state {
        RowState::Passed => TestCaseStatus::success(),
        RowState::Failed => non_success(NonSuccessKind::Failure, "failed"),
        RowState::NotRun => non_success(NonSuccessKind::Error, "not run"),
        RowState::Allowed | RowState::LeftOut => {
            let mut status = TestCaseStatus::skipped();
            status.set_message(row.said.clone());
            status
        }
    };
    let mut test = TestCase::new(row.name.clone(), status);
    test.set_classname("gate").set_time(seconds(row.elapsed_s));
    test.set_system_out(format!("{}\n{}", row.about, row.command));
    test
}

fn seconds(seconds: f64) -> Duration {
    Duration::from_secs_f64(seconds.max(0.0))
}

fn in_text(finding: &Finding) -> String {
    finding.place().map_or_else(|| finding.text.clone(), |place| format!("{place}: {}", finding.text))
}

/// A rule a row, a result a finding. A row that was not run is told as a notification.
fn sarif(report: &GateReport) -> Value {
    let place_of = |row: &RowReport| ROWS.iter().find(|of| of.name == row.name).map_or("README.md", |of| of.place);
    let rules: Vec<Value> = report
        .rows
        .iter()
        .map(|row| {
            let remedy = ROWS.iter().find(|of| of.name == row.name).map_or("", |of| of.remedy);
            json!({
                "id": row.name, "shortDescription": {"text": row.about},
                "help": {"text": format!("To do: {remedy}. Alone: {}", row.command)},
            })
        })
        .collect();
    let results: Vec<Value> = report
        .rows
        .iter()
        .enumerate()
        .flat_map(|(index, row)| row.findings.iter().map(move |finding| (index, row, finding)))
        .map(|(index, row, finding)| {
            let file = finding.file.as_deref().unwrap_or_else(|| place_of(row));
            json!({
                "ruleId": row.name, "ruleIndex": index, "level": "error", "message": {"text": finding.text},
                "locations": [{"physicalLocation": {
                    "artifactLocation": {"uri": file}, "region": {"startLine": finding.line.unwrap_or(1)},
                }}],
                "properties": {"rule": finding.rule},
            })
        })
        .collect();
    let unrun = report.rows.iter().filter(|row| matches!(row.state, RowState::NotRun | RowState::Allowed));
    let notifications: Vec<Value> = unrun
        .map(|row| {
            let level = if row.state == RowState::NotRun { "error" } else { "note" };
            json!({"level": level, "message": {"text": format!("{} was not run: {}", row.name, row.said)}})
        })
        .collect();
    json!({"$schema": SCHEMA, "version": "2.1.0", "runs": [{
        "tool": {"driver": {"name": report.tool.name, "version": report.tool.version, "rules": rules}},
        "automationDetails": {"id": "ncp-verify/gate/"},
        "invocations": [{
            "executionSuccessful": report.count(RowState::NotRun) == 0, "startTimeUtc": report.started,
            "toolExecutionNotifications": notifications,
        }],
        "results": results,
        "properties": {"verdict": report.verdict.as_str(), "against": against(report)},
    }]})
}
