//! `ncp-verify gate`: what has to hold of a tree before it is released.

use std::io::IsTerminal as _;
use std::path::PathBuf;

use clap::Args;
use clap::builder::PossibleValuesParser;

use super::check::{Styles, current_dir, write};
use super::{CliError, print};
use crate::gate::{self, Asked, Listener, ROWS, Row, RowReport};
use crate::report::{Exit, Format, GATE_FORMATS, GateForm, Progress, gate as rendered, gate_in};
use crate::stop::Stop;

/// Where the result goes, from the root of the tree.
const RESULT: &str = "reports/run/gate.json";

pub(super) const HELP: &str = "\
Rows:
  identity      the contract hash is that of the proto, and wire version and hash move together
  corpus        no case was changed or removed under the same wire version; added is fine
  buf-lint      the proto follows buf's rules
  buf-breaking  the proto breaks nothing that went out, by buf
  contract      nor does what buf does not see: enum strings, defaults, keys, JSON names
  generated     schemas, cases with their manifest, and the C header are fresh
  trace         every binding rule is shown
  proofs        the proofs are about the sources as they are
  peers         every bundled peer does what it says, down to its expected failures

A row that cannot be run, since a tool or a file is missing, keeps the gate shut, unless --allow-missing names \
it. What to do about a row that failed stands below the table.

Examples:
  ncp-verify gate
  ncp-verify gate --against v0.1.0 --report md=summary.md --report sarif=gate.sarif
  ncp-verify gate --only identity --only corpus
  ncp-verify gate --against proto/baseline/ncp-0.5.binpb --allow-missing corpus

Exit codes:
    0  open: every row that was asked for passed, or need not be run
    1  shut: a row failed, or was not run
    2  usage: no tree, an unknown row, or nothing to hold it against
    4  the report cannot be written
  130  interrupted; the table says how far it came";

#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub(super) struct GateArgs {
    /// What went out before: a folder, a buf image or a git ref [default: the latest tag, else proto/baseline]
    #[arg(long, value_name = "REF|DIR|IMAGE")]
    against: Option<String>,
    /// Ask only this row (may be repeated)
    #[arg(long, value_name = "ROW", value_parser = rows(), hide_possible_values = true)]
    only: Vec<String>,
    /// Leave this row out (may be repeated)
    #[arg(long, value_name = "ROW", value_parser = rows(), hide_possible_values = true)]
    skip: Vec<String>,
    /// Open the gate even if this row cannot be run (may be repeated)
    #[arg(long, value_name = "ROW", value_parser = rows(), hide_possible_values = true)]
    allow_missing: Vec<String>,
    /// Where to write the result as JSON [default: reports/run/gate.json]
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Also write the result as JUnit XML
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
    /// Also write the result in another format: json, junit, md or sarif, such as md=summary.md (may be repeated)
    #[arg(long, value_name = "FORMAT=FILE", value_parser = format_and_file)]
    report: Vec<(Format, PathBuf)>,
    /// Show every finding, in full
    #[arg(long, short)]
    verbose: bool,
}

/// Asks every row, shows the table, and ends as the gate stands.
pub(super) fn gate(args: &GateArgs, styles: Styles, stop: &Stop) -> Result<Exit, CliError> {
    let root = gate::root(&current_dir()?)?;
    let asked = Asked {
        against: args.against.clone(),
        only: args.only.clone(),
        skip: args.skip.clone(),
        allow_missing: args.allow_missing.clone(),
    };
    let mut shown = Shown { visible: std::io::stderr().is_terminal(), row: None };
    let report = gate::ask(&root, &asked, stop, &mut shown)?;
    print(&rendered(&report, GateForm { style: styles.out, verbose: args.verbose }))?;

    let result = args.json.clone().unwrap_or_else(|| root.join(RESULT));
    let junit = args.junit.iter().map(|file| (Format::Junit, file));
    let asked_for = args.report.iter().map(|(format, file)| (*format, file));
    for (format, file) in [(Format::Json, &result)].into_iter().chain(junit).chain(asked_for) {
        if let Some(text) = gate_in(&report, format)? {
            write(file, &text)?;
        }
    }
    let named = args.json.as_ref().map_or_else(|| RESULT.to_owned(), |file| file.display().to_string());
    print(&format!("{}\n", styles.out.dim(&format!("result: {named}"))))?;
    Ok(report.exit())
}

/// The row at work, on stderr.
struct Shown {
    visible: bool,
    row: Option<Progress>,
}

impl Listener for Shown {
    fn begins(&mut self, row: &Row) {
        self.row = Some(Progress::spinner(format!("{}: {}", row.name, row.command), self.visible));
    }

    fn ends(&mut self, row: &RowReport) {
        if let Some(progress) = self.row.take() {
            progress.done();
            if self.visible {
                eprintln!("{}: {} after {:.0} s", row.name, row.state.as_str(), row.elapsed_s);
            }
        }
    }
}

fn rows() -> PossibleValuesParser {
    PossibleValuesParser::new(ROWS.iter().map(|row| row.name))
}

fn format_and_file(text: &str) -> Result<(Format, PathBuf), String> {
    let names = || GATE_FORMATS.map(Format::as_str).join(", ");
    let wrong = || format!("a format and a file, such as md=summary.md; the formats of a gate: {}", names());
    let (format, file) = text.split_once('=').filter(|(_, file)| !file.is_empty()).ok_or_else(wrong)?;
    let format = Format::parse(format).filter(|format| GATE_FORMATS.contains(format)).ok_or_else(wrong)?;
    Ok((format, file.into()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_help_lists_the_rows_in_the_order_in_which_they_are_asked() {
        let listed = HELP.lines().skip(1).map_while(|line| line.split_whitespace().next());
        assert_eq!(listed.collect::<Vec<_>>(), ROWS.iter().map(|row| row.name).collect::<Vec<_>>());
    }

    #[test]
    fn a_format_that_is_for_cases_is_refused() {
        assert!(format_and_file("md=a.md").is_ok());
        for wrong in ["html=a.html", "tsv=a", "md=", "md", "=a"] {
            assert!(format_and_file(wrong).is_err(), "{wrong}");
        }
    }
}
