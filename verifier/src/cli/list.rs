//! `ncp-verify list`.

use serde::Serialize;

use super::{CliError, ListArgs, print};
use crate::check::in_words;
use crate::report::{Exit, Style, wrap};
use crate::suite::{Case, Expect, Selection, Suite};

/// Lists cases or rules.
pub(super) fn list(suite: &Suite, args: &ListArgs, style: Style) -> Result<Exit, CliError> {
    let selection = args.select.selection();
    let text = match (args.requirements, args.json) {
        (false, json) => {
            let cases: Vec<&Case> = suite.cases().iter().filter(|case| selection.meets(case)).collect();
            if cases.is_empty() {
                return Err(CliError::Usage("no case fits; ncp-verify list shows all".to_owned()));
            }
            if json {
                to_json(&cases.iter().map(|case| case_line(case)).collect::<Vec<_>>())?
            } else {
                case_table(&cases, style)
            }
        }
        (true, json) => {
            let rules = rules(suite, &selection);
            if rules.is_empty() {
                return Err(CliError::Usage("no rule fits; ncp-verify list --requirements shows all".to_owned()));
            }
            if json { to_json(&rules)? } else { rule_table(&rules, style) }
        }
    };
    print(&text)?;
    Ok(Exit::Conformant)
}

#[derive(Serialize)]
struct CaseLine<'s> {
    id: &'s str,
    title: &'s str,
    call: &'static str,
    expected: String,
    level: &'static str,
    binding: bool,
    roles: Vec<&'static str>,
    rules: Vec<&'s str>,
    flags: &'s [String],
    file: &'s str,
}

#[derive(Serialize)]
struct RuleLine<'s> {
    id: &'s str,
    keyword: &'static str,
    level: &'static str,
    roles: Vec<&'static str>,
    cases: usize,
    place: String,
    digest: &'s str,
    sentence: &'s str,
}

fn case_line(case: &Case) -> CaseLine<'_> {
    CaseLine {
        id: &case.id,
        title: &case.title,
        call: case.call.as_str(),
        expected: in_words(&case.expect),
        level: case.level.as_str(),
        binding: case.binding,
        roles: case.roles.iter().map(|role| role.as_str()).collect(),
        rules: case.requirements.iter().map(|rule| rule.id.as_str()).collect(),
        flags: &case.flags,
        file: &case.file,
    }
}

/// The rules that are meant: by their own id, or by a case that is meant and cites them.
fn rules<'s>(suite: &'s Suite, selection: &Selection) -> Vec<RuleLine<'s>> {
    let mut lines = Vec::new();
    for rule in suite.requirements() {
        let citing =
            suite.with_describe().filter(|case| case.requirements.iter().any(|cited| cited.id == rule.id)).count();
        let meant = (selection.patterns.is_empty() || selection.patterns.iter().any(|p| p.fits_text(&rule.id)))
            && (selection.roles.is_empty() || selection.roles.iter().any(|role| rule.binds(*role)))
            && selection.level.is_none_or(|level| rule.level <= level);
        if meant {
            lines.push(RuleLine {
                id: &rule.id,
                keyword: rule.keyword.as_str(),
                level: rule.level.as_str(),
                roles: rule.roles.iter().map(|role| role.as_str()).collect(),
                cases: citing,
                place: rule.place(),
                digest: &rule.digest,
                sentence: &rule.sentence,
            });
        }
    }
    lines
}

fn case_table(cases: &[&Case], style: Style) -> String {
    let id_width = cases.iter().map(|case| case.id.len()).max().unwrap_or(0);
    let call_width = cases.iter().map(|case| case.call.as_str().len()).max().unwrap_or(0);
    let mut out = String::new();
    for case in cases {
        let rules: Vec<&str> = case.requirements.iter().map(|rule| rule.id.as_str()).collect();
        let (call, rules, relation) = (case.call.as_str(), rules.join(" "), relation(&case.expect));
        let row = format!("{:id_width$}  {call:call_width$}  {relation:8}  {rules}", case.id);
        if row.chars().count() <= style.width {
            out.push_str(&row);
        } else {
            out.push_str(&wrap(&case.id, style.width, "", "  "));
            out.push('\n');
            out.push_str(&style.dim(&wrap(&format!("{call} {relation} {rules}"), style.width, "    ", "    ")));
        }
        out.push('\n');
    }
    out
}

fn rule_table(rules: &[RuleLine<'_>], style: Style) -> String {
    let mut out = String::new();
    for rule in rules {
        let roles = if rule.roles.len() == 4 { "all".to_owned() } else { rule.roles.join(" ") };
        let cases = match rule.cases {
            0 => style.yellow("no case"),
            1 => "1 case".to_owned(),
            many => format!("{many} cases"),
        };
        out.push_str(&format!("{} {}, {}, {roles}, {cases}\n", style.bold(rule.id), rule.keyword, rule.level));
        out.push_str(&wrap(rule.sentence, style.width, "    ", "    "));
        out.push('\n');
    }
    out
}

fn relation(expect: &Expect) -> &'static str {
    match expect {
        Expect::Reject(_) => "reject",
        Expect::Accept => "accept",
        Expect::Json(_) => "json",
        Expect::Message { .. } => "message",
        Expect::Encoding(_) => "encoding",
        Expect::Bytes(_) => "bytes",
        Expect::Columns(_) => "columns",
        Expect::Pattern { .. } => "pattern",
    }
}

fn to_json<T: Serialize>(lines: &[T]) -> Result<String, CliError> {
    let mut text = serde_json::to_string_pretty(lines).map_err(|error| CliError::Harness(error.to_string()))?;
    text.push('\n');
    Ok(text)
}
