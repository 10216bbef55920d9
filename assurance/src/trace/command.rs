//! `cargo assure trace`.

use std::fs;
use std::path::{Path, PathBuf};

use clap::Args;
use ncp_verifier::report::wrap;
use xtask::project::Project;

use super::{Accepted, Fault, Trace, TraceError, report};
use crate::console::{Styles, counted};
use crate::{Error, document, lock, reports};

#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub(crate) struct TraceArgs {
    /// The source tree [default: the project's]
    #[arg(long, value_name = "DIR")]
    root: Option<PathBuf>,
    /// Write nothing; fail also when what is written is stale
    #[arg(long, conflicts_with = "accept")]
    check: bool,
    /// Accept sentences that changed and evidence that is gone, having looked at them
    #[arg(long)]
    accept: bool,
    /// Only write the matrix to this file, as JSON, whatever is wrong with it
    #[arg(long, value_name = "FILE", conflicts_with_all = ["check", "accept"])]
    matrix: Option<PathBuf>,
}

const HELP: &str = "\
Writes reports/traceability.md, reports/lock/trace.toml and the long reports in reports/full. Exit code 1 says that a
binding rule has no evidence, that a case, a property or a public function cites no rule or one that the text does not
have, or that evidence is gone, or its rule reads differently, since it was last accepted.";

/// The name of the report.
const REPORT: &str = "traceability";

/// Builds the matrix of the tree, says what is wrong with it, and writes the reports; `false` if something is wrong.
pub(crate) fn trace(project: &Project, args: &TraceArgs) -> Result<bool, Error> {
    let style = Styles::detect().out;
    let root = args.root.clone().unwrap_or_else(|| project.path(""));
    let mut trace = Trace::read(&root)?;
    if let Some(file) = &args.matrix {
        reports::json(file, &report::matrix(&trace))?;
        return Ok(true);
    }
    let acceptable = trace.faults().iter().all(Fault::can_be_accepted);
    if args.accept && acceptable {
        trace.accept()?;
        trace = Trace::read(&root)?;
    }
    let stale = differing(&root, &trace)?;
    if !args.check {
        let folder = root.join(reports::PAGES);
        reports::full(&folder, REPORT, &report::matrix(&trace), &report::full_page(&trace))?;
        for (path, text) in &stale {
            let made = path.parent().map_or(Ok(()), fs::create_dir_all).and_then(|()| fs::write(path, text));
            made.map_err(|source| Error::File { path: path.clone(), source })?;
        }
    }

    println!("{}", summary(&trace));
    for fault in trace.faults() {
        let shown = wrap(&fault.to_string(), style.width, "  ", "    ");
        println!("{} {}", style.red("✗"), shown.trim_start());
    }
    if args.check {
        shown(&root, &stale).iter().for_each(|line| println!("{} {line}: cargo assure trace", style.red("✗")));
    }
    let faults = counted(trace.faults().len(), "fault");
    match trace.faults() {
        [] if !args.check => println!("report: {}/{REPORT}.md", reports::PAGES),
        [] => {}
        _ if acceptable && !args.accept => {
            println!("{faults}: read what is named; if it is meant: cargo assure trace --accept");
        }
        _ => println!("{faults}"),
    }
    Ok(trace.faults().is_empty() && (!args.check || stale.is_empty()))
}

/// What is wrong with the matrix of a tree, and what git keeps of it and is stale.
///
/// # Errors
/// The tree cannot be read.
pub(crate) fn stale(root: &Path) -> Result<Vec<String>, TraceError> {
    let trace = Trace::read(root)?;
    let mut lines: Vec<String> = trace.faults().iter().map(ToString::to_string).collect();
    lines.extend(shown(root, &differing(root, &trace)?));
    Ok(lines)
}

/// What git keeps and would be written otherwise: the files and their texts.
fn differing(root: &Path, trace: &Trace) -> Result<Vec<(PathBuf, String)>, TraceError> {
    let page = root.join(reports::PAGES).join(format!("{REPORT}.md"));
    let mut files = vec![(page, document::markdown(&report::page(trace)))];
    // Evidence that is new needs no acceptance; what was accepted is kept while something is wrong.
    if trace.faults().is_empty() {
        files.push((lock::path(root, Accepted::NAME), trace.lock()?));
    }
    files.retain(|(path, text)| !fs::read_to_string(path).is_ok_and(|written| written == *text));
    Ok(files)
}

fn shown(root: &Path, files: &[(PathBuf, String)]) -> Vec<String> {
    let name = |path: &Path| path.strip_prefix(root).unwrap_or(path).display().to_string();
    files.iter().map(|(path, _)| format!("{} is stale", name(path))).collect()
}

fn summary(trace: &Trace) -> String {
    let rules = trace.rules().len();
    let binding = trace.rules().iter().filter(|rule| rule.requirement.keyword.is_binding());
    let (mut shown, mut excluded, mut none) = (0, 0, 0);
    for rule in binding {
        if rule.evidence.iter().any(|one| one.kind.shows()) {
            shown += 1;
        } else if rule.exclusion.is_some() {
            excluded += 1;
        } else {
            none += 1;
        }
    }
    format!(
        "{rules} rules, {} of them binding: {shown} shown, {excluded} excluded with a reason, {none} without evidence",
        shown + excluded + none
    )
}
