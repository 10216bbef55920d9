//! The matrix, for people and for programs.

use std::collections::BTreeSet;

use ncp_text::{CONTRACT_HASH, WIRE_VERSION};
use serde::Serialize;

use super::{Evidence, EvidenceKind, Rule, Trace};
use crate::document::{Block, heading, table, text};

/// The matrix as a model.
#[derive(Debug, Serialize)]
pub(crate) struct Matrix<'t> {
    format: u32,
    wire_version: &'static str,
    contract_hash: &'static str,
    faults: Vec<String>,
    rules: Vec<MatrixRule<'t>>,
    findings: Vec<MatrixFinding<'t>>,
}

#[derive(Debug, Serialize)]
struct MatrixRule<'t> {
    id: &'t str,
    keyword: &'t str,
    level: &'t str,
    roles: Vec<&'t str>,
    chapter: &'t str,
    section: &'t str,
    line: usize,
    digest: &'t str,
    sentence: &'t str,
    evidence: Vec<MatrixEvidence<'t>>,
    exclusion: Option<&'t str>,
}

#[derive(Debug, Serialize)]
struct MatrixEvidence<'t> {
    kind: &'t str,
    place: &'t str,
    line: Option<usize>,
    count: usize,
}

#[derive(Debug, Serialize)]
struct MatrixFinding<'t> {
    id: &'t str,
    cases: usize,
    rules: &'t BTreeSet<String>,
    exclusion: Option<&'t str>,
}

/// The matrix as a model.
pub(crate) fn matrix(trace: &Trace) -> Matrix<'_> {
    let findings = trace.findings().iter().map(|finding| MatrixFinding {
        id: &finding.id,
        cases: finding.cases,
        rules: &finding.rules,
        exclusion: finding.exclusion.as_deref(),
    });
    Matrix {
        format: 1,
        wire_version: WIRE_VERSION,
        contract_hash: CONTRACT_HASH,
        faults: trace.faults().iter().map(ToString::to_string).collect(),
        rules: trace.rules().iter().map(rule).collect(),
        findings: findings.collect(),
    }
}

fn rule(rule: &Rule) -> MatrixRule<'_> {
    let Rule { requirement, evidence, exclusion } = rule;
    let evidence = evidence.iter().map(|Evidence { kind, place, line, count }| MatrixEvidence {
        kind: kind.as_str(),
        place,
        line: *line,
        count: *count,
    });
    MatrixRule {
        id: &requirement.id,
        keyword: requirement.keyword.as_str(),
        level: requirement.level.as_str(),
        roles: requirement.roles.iter().map(|role| role.as_str()).collect(),
        chapter: requirement.file,
        section: &requirement.section,
        line: requirement.line,
        digest: &requirement.digest,
        sentence: &requirement.sentence,
        evidence: evidence.collect(),
        exclusion: exclusion.as_deref(),
    }
}

/// The short page: how many rules are shown by what, and what nothing shows. Its links lead from `reports/` into the
/// tree.
pub(crate) fn page(trace: &Trace) -> Vec<Block> {
    let kinds = KINDS.map(str::to_owned).to_vec();
    let mut page = vec![heading(1, "Traceability: what shows each rule"), text(ABOUT), Block::List(kinds)];
    if !trace.faults().is_empty() {
        page.push(heading(2, "Faults"));
        page.push(Block::List(trace.faults().iter().map(ToString::to_string).collect()));
    }
    page.extend(summary(trace));
    page.extend(findings(trace));
    page.extend(excluded(trace));
    page
}

/// The whole page: also what shows each rule. Its links lead from `reports/full/` into the tree.
pub(crate) fn full_page(trace: &Trace) -> Vec<Block> {
    let kinds = present(trace);
    let mut page = page(trace);
    page.push(heading(2, "Every rule"));
    page.push(text("A column without an entry is left out."));
    let chapters = trace.rules().chunk_by(|one, next| one.requirement.file == next.requirement.file);
    for rules in chapters {
        page.extend(rules.first().map(|rule| heading(3, rule.requirement.file)));
        let names = kinds.iter().map(|kind| kind.as_str());
        let head: Vec<&str> = ["rule", "binds"].into_iter().chain(names).collect();
        let rows = rules.iter().map(|rule| {
            let requirement = &rule.requirement;
            let mut cells = vec![
                format!("**{}** {}", requirement.id, requirement.sentence),
                format!("{}, {}", requirement.keyword, requirement.level),
            ];
            cells.extend(kinds.iter().map(|kind| {
                let of_kind = rule.evidence.iter().filter(|one| one.kind == *kind);
                of_kind.map(entry).collect::<Vec<_>>().join(", ")
            }));
            cells
        });
        page.push(table(&head, rows));
    }
    page
}

const ABOUT: &str = "\
Made by `cargo assure trace` from the text, the corpus, the code and the tests; `cargo assure status` says when it is \
stale. What was accepted stands in `reports/lock/trace.toml`, and the command writes what shows each single rule to \
`reports/full`. `cargo verify explain <id>` leads from a rule, a finding or a case to the text, the cases and the \
lines of code.";

const KINDS: [&str; 5] = [
    "**code**: functions and files that carry the rule out, in `ncp-kernel` and `ncp-spec`, and in the two peers that \
     were written from the text alone (TypeScript, pure Python). This is where to look, and is no evidence.",
    "**vectors**: cases of the golden corpus that cite the rule; every peer is held to them.",
    "**tests**, **properties**: tests of the executable specification over chosen and over random input.",
    "**fuzz**, **proofs**, **live**: fuzz targets, proved properties, scenarios between running programs.",
    "**mutants**: peers with that one planted defect, which the vectors find. They show that the vectors bite, and are \
     no evidence for the rule.",
];

/// The kinds of which there is any.
fn present(trace: &Trace) -> Vec<EvidenceKind> {
    let any = |kind: &EvidenceKind| trace.rules().iter().any(|rule| rule.count(*kind) > 0);
    EvidenceKind::ALL.into_iter().filter(any).collect()
}

fn summary(trace: &Trace) -> [Block; 3] {
    let kinds = present(trace);
    let mut chapters: Vec<&str> = trace.rules().iter().map(|rule| rule.requirement.file).collect();
    chapters.dedup();
    let rows = chapters.into_iter().map(Some).chain([None]).map(|chapter| {
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
        cells
    });
    let names = kinds.iter().map(|kind| kind.as_str());
    let head: Vec<&str> = ["chapter", "rules", "binding"].into_iter().chain(names).chain(["excluded"]).collect();
    [heading(2, "By chapter"), text("How many of the rules have evidence of a kind."), table(&head, rows)]
}

fn findings(trace: &Trace) -> [Block; 3] {
    let rows = trace.findings().iter().map(|finding| {
        let rules = || finding.rules.iter().cloned().collect::<Vec<_>>().join(", ");
        let cases = if finding.cases == 0 { "-".to_owned() } else { finding.cases.to_string() };
        vec![finding.id.clone(), cases, finding.exclusion.clone().unwrap_or_else(rules)]
    });
    [
        heading(2, "Audited findings"),
        text("The cases and live scenarios that are flagged with a finding fail a peer that has it."),
        table(&["finding", "cases and scenarios", "rules"], rows),
    ]
}

fn excluded(trace: &Trace) -> [Block; 2] {
    let rows = trace.rules().iter().filter_map(|rule| {
        let Rule { requirement, exclusion, .. } = rule;
        Some(vec![requirement.id.clone(), requirement.sentence.clone(), exclusion.clone()?])
    });
    [heading(2, "What nothing shows, and why"), table(&["rule", "sentence", "why"], rows)]
}

/// A link to the file of a piece of evidence.
fn entry(evidence: &Evidence) -> String {
    let Evidence { kind, place, count, .. } = evidence;
    let (file, item) = place.split_once(' ').unwrap_or((place, ""));
    let name = match item {
        "" => file.rsplit('/').next().unwrap_or(file),
        item => item,
    };
    let link = format!("[{name}](../../{file})");
    if *kind == EvidenceKind::Vector { format!("{link} {count}") } else { link }
}
