//! `ncp-verify trace`.

use std::io::IsTerminal as _;
use std::path::{Path, PathBuf};

use clap::Args;
use ncp_verifier::report::{Style, wrap};
use xtask::project::Project;

use super::{Fault, Trace, json, markdown};
use crate::Error;

#[derive(Debug, Args)]
pub(crate) struct TraceArgs {
    /// The source tree [default: the one at or above this folder]
    #[arg(long, value_name = "DIR")]
    root: Option<PathBuf>,
    /// Write nothing; fail also when what is written is stale
    #[arg(long, conflicts_with = "accept")]
    check: bool,
    /// Accept sentences that changed and evidence that is gone, having looked at them
    #[arg(long)]
    accept: bool,
}

/// How the matrix is written.
type Render = fn(&Trace) -> String;

/// Where the matrix is written, within the tree.
const REPORTS: [(&str, Render); 2] = [("reports/traceability.md", markdown), ("reports/traceability.json", json)];
/// What was accepted, within the tree.
const LOCK: &str = "spec/evidence.lock";

/// Builds the matrix of the tree, says what is wrong with it, and writes the reports.
pub(super) fn trace(args: &TraceArgs, style: Style) -> Result<Exit, CliError> {
    let here = || Workspace::here().map(|workspace| workspace.root);
    let root = args
        .root
        .clone()
        .or_else(here)
        .ok_or_else(|| CliError::Usage("there is no source tree here; --root FOLDER names it".to_owned()))?;
    let mut trace = Trace::read(&root)?;
    let acceptable = trace.faults().iter().all(Fault::can_be_accepted);
    if args.accept && acceptable {
        trace.accept()?;
        trace = Trace::read(&root)?;
    }
    let sound = trace.faults().is_empty();
    let mut out = String::new();
    let mut stale = Vec::new();
    for (file, render) in REPORTS {
        keep(&root, file, &render(&trace), args.check, &mut stale)?;
    }
    // Evidence that is new needs no acceptance; what was accepted is kept while something is wrong.
    if sound {
        keep(&root, LOCK, &trace.lock(), args.check, &mut stale)?;
    }

    out.push_str(&summary(&trace));
    for fault in trace.faults() {
        let shown = wrap(&fault.to_string(), style.width, "  ", "    ");
        out.push_str(&format!("{} {}\n", style.red("✗"), shown.trim_start()));
    }
    for file in &stale {
        out.push_str(&format!("{} {file} is stale; write it anew: cargo verify trace\n", style.red("✗")));
    }
    let faults = trace.faults().len();
    if faults > 0 {
        out.push_str(&match (acceptable, args.accept) {
            (true, false) => {
                format!("{}: read what is named; if it is meant: cargo verify trace --accept\n", counted(faults))
            }
            _ => format!("{}\n", counted(faults)),
        });
    } else if stale.is_empty() {
        let files: Vec<&str> = REPORTS.iter().map(|(file, _)| *file).collect();
        out.push_str(&format!("report: {}\n", files.join(", ")));
    }
    print(&out)?;
    Ok(if sound && stale.is_empty() { Exit::Conformant } else { Exit::NotConformant })
}

/// Writes a file if it differs; with `check`, only notes that it would be.
fn keep(root: &Path, file: &str, text: &str, check: bool, stale: &mut Vec<String>) -> Result<(), CliError> {
    let path = root.join(file);
    if std::fs::read_to_string(&path).is_ok_and(|written| written == text) {
        return Ok(());
    }
    if check {
        stale.push(file.to_owned());
        return Ok(());
    }
    let written = path.parent().map_or(Ok(()), std::fs::create_dir_all).and_then(|()| std::fs::write(&path, text));
    written.map_err(|error| CliError::Harness(format!("{}: {error}", path.display())))
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
    let binding = shown + excluded + none;
    format!(
        "{rules} rules, {binding} of them binding: {shown} shown, {excluded} excluded with a reason, {none} without evidence\n"
    )
}

fn counted(faults: usize) -> String {
    match faults {
        1 => "1 fault".to_owned(),
        many => format!("{many} faults"),
    }
}
