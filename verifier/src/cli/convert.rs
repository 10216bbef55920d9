//! A stored result in another format.

use std::path::PathBuf;

use clap::Args;
use clap::builder::PossibleValuesParser;
use clap::builder::TypedValueParser as _;

use super::check::{write, write_by};
use super::{CONVERT_HELP, CliError, print};
use crate::report::{Exit, Format, Report, render};
use crate::suite::Suite;

#[derive(Debug, Args)]
#[command(after_help = CONVERT_HELP)]
pub(super) struct ConvertArgs {
    /// A result
    result: PathBuf,
    /// The format
    #[arg(
        long,
        value_name = "FORMAT",
        value_parser = PossibleValuesParser::new(Format::ALL.map(Format::as_str))
            .try_map(|name| Format::parse(&name).ok_or("one of the formats")),
    )]
    to: Format,
    /// Write to a file instead of stdout
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// Renders a stored result, without a run and without a verdict: the exit code says only that it was rendered.
pub(super) fn convert(suite: &Suite, args: &ConvertArgs) -> Result<Exit, CliError> {
    let report = Report::read(&args.result)?;
    let of_it = Some(suite).filter(|suite| suite.digest() == report.corpus.sha256);
    match &args.output {
        Some(file) if args.to == Format::Json => write_by(file, |file| report.write_json(file))?,
        Some(file) => write(file, &render(&report, args.to, of_it)?)?,
        None => print(&render(&report, args.to, of_it)?)?,
    }
    Ok(Exit::Conformant)
}
