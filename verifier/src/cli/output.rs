//! Where a result goes: the terminal, and files.

use std::path::{Path, PathBuf};

use clap::Args;

use super::check::{write, write_by};
use super::{CliError, print};
use crate::report::{Detail, Format, Report, Style, render, terminal};
use crate::suite::Suite;

/// Where the result goes, from the workspace's root.
const RESULT: &str = "reports/run/result.json";

#[derive(Debug, Args)]
pub(super) struct OutputArgs {
    /// Where to write the result as JSON [default: reports/run/result.json]
    #[arg(long, value_name = "FILE")]
    pub(super) json: Option<PathBuf>,
    /// Also write the result as JUnit XML
    #[arg(long, value_name = "FILE")]
    pub(super) junit: Option<PathBuf>,
    /// Also write the result in another format, such as md=summary.md; `ncp-verify convert --help` lists them (may be
    /// repeated)
    #[arg(long, value_name = "FORMAT=FILE", value_parser = format_and_file)]
    pub(super) report: Vec<(Format, PathBuf)>,
    /// Show N failing cases of each peer with what went over the wire [default: 1]
    #[arg(long, value_name = "N")]
    pub(super) examples: Option<usize>,
    /// Show every failing case, in full
    #[arg(long, short, conflicts_with = "examples")]
    pub(super) verbose: bool,
}

impl OutputArgs {
    /// The file of the result.
    pub(super) fn result(&self, root: &Path) -> PathBuf {
        self.json.clone().unwrap_or_else(|| root.join(RESULT))
    }

    /// Prints and writes a result; if `silent`, prints nothing.
    pub(super) fn write(
        &self,
        report: &Report,
        suite: &Suite,
        style: Style,
        result: &Path,
        silent: bool,
    ) -> Result<(), CliError> {
        if !silent {
            let examples = self.examples.unwrap_or(Detail::NORMAL.examples);
            let detail = if self.verbose { Detail::VERBOSE } else { Detail { examples, ..Detail::NORMAL } };
            print(&terminal(report, style, detail))?;
        }
        write_by(result, |file| report.write_json(file))?;
        if !silent {
            let shown = self.json.as_ref().map_or(RESULT.to_owned(), |file| file.display().to_string());
            print(&format!("{}\n", style.dim(&format!("result: {shown}"))))?;
        }
        let junit = self.junit.iter().map(|file| (Format::Junit, file));
        for (format, file) in junit.chain(self.report.iter().map(|(format, file)| (*format, file))) {
            write(file, &render(report, format, Some(suite))?)?;
        }
        Ok(())
    }
}

fn format_and_file(text: &str) -> Result<(Format, PathBuf), String> {
    let wrong = || format!("a format and a file, such as md=summary.md; the formats: {}", Format::names());
    let (format, file) = text.split_once('=').filter(|(_, file)| !file.is_empty()).ok_or_else(wrong)?;
    Ok((Format::parse(format).ok_or_else(wrong)?, file.into()))
}
