//! One result from the results of shards.

use std::path::PathBuf;

use clap::Args;

use super::check::{Styles, current_dir};
use super::output::OutputArgs;
use super::workspace::Workspace;
use super::{CliError, MERGE_HELP};
use crate::merge;
use crate::report::{Exit, Report};
use crate::suite::Suite;

#[derive(Debug, Args)]
#[command(after_help = MERGE_HELP)]
pub(super) struct MergeArgs {
    /// The results of all shards of one run, in any order
    #[arg(value_name = "RESULT", required = true)]
    results: Vec<PathBuf>,
    #[command(flatten)]
    output: OutputArgs,
}

/// Merges results; ends as the one run would have.
pub(super) fn merge(suite: &Suite, args: &MergeArgs, styles: Styles) -> Result<Exit, CliError> {
    let here = current_dir()?;
    let root = Workspace::above(&here).map_or(here, |workspace| workspace.root);
    let results = args.results.iter().map(|file| Report::read(file)).collect::<Result<Vec<_>, _>>()?;
    let merged = merge::merge(results, suite)?;
    let exit = merged.exit();
    args.output.write(&merged, suite, styles.out, &args.output.result(&root), false)?;
    Ok(exit)
}
