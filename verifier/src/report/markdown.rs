//! Markdown, for the summary of a job on a code host.

use super::model::{CaseReport, PeerReport, Report, State};
use super::terminal::plural;
use crate::verdict::Status;

/// How many failing cases of a peer are named.
const NAMED: usize = 50;
/// How many defects, or broken rules, of a peer.
const LISTED: usize = 20;

/// Renders a report as Markdown: the verdicts, the levels, what explains the failures, and the first of these.
#[must_use]
pub(super) fn markdown(report: &Report) -> String {
    let asked = &report.asked;
    let mut text = format!("## NCP {}, level {}\n\n", report.wire_version, asked.level);
    if report.interrupted {
        text.push_str("**The run was interrupted.**\n\n");
    }
    if asked.partial {
        text.push_str("Only a part of the cases was run: a pass is no conformance.\n\n");
    }
    text.push_str("| peer | verdict | passed | failed | as expected | advice | not run | levels |\n");
    text.push_str("|---|---|--:|--:|--:|--:|--:|---|\n");
    for peer in &report.peers {
        let totals = &peer.totals;
        let counts = [totals.passed, totals.failed, totals.expected_failures, totals.advice, totals.not_run];
        let counts = counts.map(|count| count.to_string()).join(" | ");
        let verdict = format!("{} {}", mark(peer), peer.verdict());
        text.push_str(&format!("| {} | {verdict} | {counts} | {} |\n", cell(&peer.name), levels(peer)));
    }
    for peer in &report.peers {
        text.push_str(&of_peer(report, peer));
    }
    text.push_str(&format!(
        "\n<sub>ncp-verify {}, {} cases in {} files, corpus <code>{}</code></sub>\n",
        report.tool.version,
        asked.cases,
        asked.files,
        report.corpus.sha256.get(..12).unwrap_or_default()
    ));
    text
}

fn mark(peer: &PeerReport) -> &'static str {
    match peer.verdict() {
        "conformant" => "✅",
        "as expected" => "☑️",
        "skipped" => "⏭️",
        _ => "❌",
    }
}

/// The levels of each role, such as `body wire ✓ safety ✗`.
fn levels(peer: &PeerReport) -> String {
    let level = |level: &super::LevelReport| {
        let mark = if level.conformant { "✓" } else { "✗" };
        format!("{} {mark}", level.level)
    };
    let role = |role: &super::RoleReport| {
        let levels = role.levels.iter().map(level).collect::<Vec<_>>().join(", ");
        format!("{}: {levels}", role.role)
    };
    peer.roles.iter().map(role).collect::<Vec<_>>().join("<br>")
}

fn of_peer(report: &Report, peer: &PeerReport) -> String {
    let mut text = String::new();
    if peer.state != State::Checked {
        let reason = peer.reason.as_deref().unwrap_or_default();
        return format!("\n### {}\n\n{}: {}\n", cell(&peer.name), peer.verdict(), cell(reason));
    }
    let failed: Vec<&CaseReport> = peer.cases.iter().filter(|case| case.status == Status::Failed).collect();
    let untrue: Vec<String> = peer.expected_failures.iter().flat_map(super::ExcuseReport::untrue).collect();
    let given_up = peer.run.as_ref().and_then(|run| run.given_up.as_ref());
    if failed.is_empty() && untrue.is_empty() && given_up.is_none() {
        return text;
    }
    text.push_str(&format!("\n### {}\n", cell(&peer.name)));
    for line in given_up.map(|why| format!("given up: {why}")).into_iter().chain(untrue) {
        text.push_str(&format!("\n- {}", cell(&line)));
    }
    let defects = peer.diagnosis.as_ref().map_or(&[][..], |diagnosis| &diagnosis.defects);
    if !defects.is_empty() {
        text.push_str("\nKnown defects that explain failing cases:\n");
        for defect in defects.iter().take(LISTED) {
            let (words, cases) = (cell(&defect.words), plural(defect.explained.len(), "case"));
            text.push_str(&format!(
                "\n- **{}** {words} ({cases}, such as `{}`)",
                cell(&defect.defect),
                defect.shortest
            ));
        }
        text.push('\n');
    }
    let rules = by_rule(&failed);
    if !rules.is_empty() {
        text.push_str("\n| rule | cases | sentence |\n|---|--:|---|\n");
        for (rule, cases) in rules.iter().take(LISTED) {
            let sentence = report.rules.iter().find(|known| known.id == **rule).map_or("", |known| &known.sentence);
            text.push_str(&format!("| {rule} | {cases} | {} |\n", cell(sentence)));
        }
        if rules.len() > LISTED {
            text.push_str(&format!("\n… and {} more rules\n", rules.len() - LISTED));
        }
    }
    if !failed.is_empty() {
        let count = failed.len();
        let summary = plural(count, "failing case");
        text.push_str(&format!("\n<details><summary>{summary}</summary>\n\n| case | what |\n|---|---|\n"));
        for case in failed.iter().take(NAMED) {
            let brief: String = case.in_brief().chars().take(300).collect();
            text.push_str(&format!("| `{}` | {} |\n", case.id, cell(&brief)));
        }
        if count > NAMED {
            text.push_str(&format!("\n… and {} more\n", count - NAMED));
        }
        text.push_str("\n</details>\n");
    }
    text
}

/// The rules of cases with how many are charged to each, the most first.
fn by_rule<'c>(cases: &[&'c CaseReport]) -> Vec<(&'c str, usize)> {
    let mut rules: Vec<(&str, usize)> = Vec::new();
    for case in cases {
        match rules.iter_mut().find(|(rule, _)| *rule == case.rule()) {
            Some((_, count)) => *count += 1,
            None => rules.push((case.rule(), 1)),
        }
    }
    rules.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    rules
}

/// A text within a cell of a table: on one line, and nothing of it is markup.
fn cell(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '|' | '*' | '_' | '`' | '[' | ']' | '\\' | '#' | '~' => {
                out.push('\\');
                out.push(c);
            }
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_that_a_peer_says_is_markup() {
        assert_eq!(cell("a|b\n<script>`x`"), "a\\|b &lt;script&gt;\\`x\\`");
    }
}
