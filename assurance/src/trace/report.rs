//! The matrix, for people and for programs.

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::{Evidence, EvidenceKind, Rule, Trace};

/// The matrix as JSON.
#[must_use]
pub fn json(trace: &Trace) -> String {
    let rules: Vec<Value> = trace.rules().iter().map(rule).collect();
    let findings: Vec<Value> = trace
        .findings()
        .iter()
        .map(|finding| {
            json!({
                "id": finding.id,
                "cases": finding.cases,
                "rules": finding.rules,
                "exclusion": finding.exclusion,
            })
        })
        .collect();
    let faults: Vec<String> = trace.faults().iter().map(ToString::to_string).collect();
    let report = json!({ "format": 1, "faults": faults, "rules": rules, "findings": findings });
    format!("{report:#}\n")
}

fn rule(rule: &Rule) -> Value {
    let requirement = &rule.requirement;
    let roles: Vec<&str> = requirement.roles.iter().map(|role| role.as_str()).collect();
    let evidence: Vec<Value> = rule
        .evidence
        .iter()
        .map(|evidence| {
            json!({
                "kind": evidence.kind.as_str(),
                "place": evidence.place,
                "count": evidence.count,
            })
        })
        .collect();
    json!({
        "id": requirement.id,
        "keyword": requirement.keyword.as_str(),
        "level": requirement.level.as_str(),
        "roles": roles,
        "chapter": requirement.file,
        "section": requirement.section,
        "digest": requirement.digest,
        "sentence": requirement.sentence,
        "evidence": evidence,
        "exclusion": rule.exclusion,
    })
}

/// The matrix as Markdown. Its links lead from `reports/` into the tree.
#[must_use]
pub fn markdown(trace: &Trace) -> String {
    let mut page = String::from(HEAD);
    faults(&mut page, trace);
    summary(&mut page, trace);
    findings(&mut page, trace);
    excluded(&mut page, trace);
    matrix(&mut page, trace);
    page
}

const HEAD: &str = "\
# Traceability: what shows each rule

Made by `cargo verify trace` from the text, the corpus, the code and the tests; `cargo xtask test` fails when it is stale. \
`cargo verify explain <id>` leads from a rule, a finding or a case to the text, the cases and the lines of code.

- **code**: functions and files that carry the rule out, here in `ncp-spec` and in the two peers that were written from \
the text alone (TypeScript, pure Python). This is where to look, and is no evidence.
- **vectors**: cases of the golden corpus that cite the rule; every peer is held to them.
- **tests**, **properties**: tests of the executable specification over chosen and over random input.
- **fuzz**, **proofs**, **live**: fuzz targets, proved properties, scenarios between running programs.
- **mutants**: peers with that one defect, which the vectors find. They show that the vectors bite, and are no evidence \
for the rule.

A column without an entry is left out.

";

fn faults(page: &mut String, trace: &Trace) {
    if trace.faults().is_empty() {
        return;
    }
    page.push_str("## Faults\n\n");
    for fault in trace.faults() {
        line(page, &format!("- {fault}"));
    }
    page.push('\n');
}

/// The kinds of which there is any.
fn present(trace: &Trace) -> Vec<EvidenceKind> {
    let any = |kind: &EvidenceKind| trace.rules().iter().any(|rule| rule.count(*kind) > 0);
    EvidenceKind::ALL.into_iter().filter(any).collect()
}

fn summary(page: &mut String, trace: &Trace) {
    let kinds = present(trace);
    page.push_str("## By chapter\n\nHow many of the rules have evidence of a kind.\n\n");
    header(page, &["chapter", "rules", "binding"], &kinds, &["excluded"]);
    let mut chapters: Vec<&str> = trace.rules().iter().map(|r| r.requirement.file).collect();
    chapters.dedup();
    for chapter in chapters.iter().copied().map(Some).chain([None]) {
        let of_chapter = |rule: &&Rule| chapter.is_none_or(|file| rule.requirement.file == file);
        let rules: Vec<&Rule> = trace.rules().iter().filter(of_chapter).collect();
        let count = |wanted: &dyn Fn(&Rule) -> bool| rules.iter().filter(|rule| wanted(rule)).count().to_string();
        let mut cells = vec![
            chapter.map_or_else(|| "**all**".to_owned(), |file| format!("[{file}](../spec/text/{file})")),
            rules.len().to_string(),
            count(&|rule| rule.requirement.keyword.is_binding()),
        ];
        cells.extend(kinds.iter().map(|kind| count(&|rule| rule.count(*kind) > 0)));
        cells.push(count(&|rule| rule.exclusion.is_some()));
        row(page, &cells);
    }
    page.push('\n');
}

fn findings(page: &mut String, trace: &Trace) {
    page.push_str("## Audited findings\n\nThe cases that are flagged with a finding fail a peer that has it.\n\n");
    header(page, &["finding", "cases", "rules"], &[], &[]);
    for finding in trace.findings() {
        let rules = match &finding.exclusion {
            Some(reason) => reason.clone(),
            None => finding.rules.iter().cloned().collect::<Vec<_>>().join(", "),
        };
        let cases = match finding.cases {
            0 => "-".to_owned(),
            cases => cases.to_string(),
        };
        row(page, &[finding.id.clone(), cases, rules]);
    }
    page.push('\n');
}

fn excluded(page: &mut String, trace: &Trace) {
    page.push_str("## What nothing shows, and why\n\n");
    header(page, &["rule", "sentence", "why"], &[], &[]);
    for rule in trace.rules() {
        if let Some(reason) = &rule.exclusion {
            let Rule { requirement, .. } = rule;
            row(page, &[requirement.id.clone(), requirement.sentence.clone(), reason.clone()]);
        }
    }
    page.push('\n');
}

fn matrix(page: &mut String, trace: &Trace) {
    let kinds = present(trace);
    page.push_str("## Every rule\n");
    let mut chapter = "";
    for rule in trace.rules() {
        let Rule { requirement, .. } = rule;
        if requirement.file != chapter {
            chapter = requirement.file;
            line(page, &format!("\n### {chapter}\n"));
            header(page, &["rule", "binds"], &kinds, &[]);
        }
        let mut cells = vec![
            format!("**{}** {}", requirement.id, requirement.sentence),
            format!("{}, {}", requirement.keyword, requirement.level),
        ];
        cells.extend(kinds.iter().map(|kind| {
            let of_kind = rule.evidence.iter().filter(|one| one.kind == *kind);
            of_kind.map(entry).collect::<Vec<_>>().join("<br>")
        }));
        row(page, &cells);
    }
}

/// A link to the file of a piece of evidence.
fn entry(evidence: &Evidence) -> String {
    let Evidence { place, count, .. } = evidence;
    let (file, item) = place.split_once(' ').unwrap_or((place, ""));
    let name = match item {
        "" => file.rsplit('/').next().unwrap_or(file),
        item => item,
    };
    let name = name.replace('_', "\\_");
    match evidence.kind {
        EvidenceKind::Vector => format!("[{name}](../{file}) {count}"),
        _ => format!("[{name}](../{file})"),
    }
}

fn header(page: &mut String, before: &[&str], kinds: &[EvidenceKind], after: &[&str]) {
    let kinds = kinds.iter().map(|kind| kind.as_str());
    let cells: Vec<String> =
        before.iter().copied().chain(kinds).chain(after.iter().copied()).map(str::to_owned).collect();
    row(page, &cells);
    line(page, &format!("|{}", "---|".repeat(cells.len())));
}

fn row(page: &mut String, cells: &[String]) {
    let cells: Vec<String> = cells.iter().map(|cell| cell.replace('|', "\\|")).collect();
    line(page, &format!("| {} |", cells.join(" | ")));
}

fn line(page: &mut String, text: &str) {
    // Writing to a string cannot fail.
    let _ = writeln!(page, "{text}");
}
