//! `ncp-verify mutants`.

use std::io::IsTerminal as _;
use std::path::{Path, PathBuf};
use std::time::Duration;

use clap::Args;
use ncp_verifier::peer::{Launch, Setup};
use ncp_verifier::report::{Progress, Style};
use ncp_verifier::run::Stop;
use ncp_verifier::suite::Suite;
use xtask::project::Project;

use super::{Fate, Hunt, Mutant, MutantsError, MutantsReport, Trial};
use crate::Error;

#[derive(Debug, Args)]
pub(crate) struct MutantsArgs {
    /// Only this mutant; writes no reports (may be repeated)
    #[arg(long, value_name = "NAME")]
    only: Vec<String>,
    /// Only list the mutants
    #[arg(long)]
    list: bool,
    /// How many mutants are on trial side by side
    #[arg(long, value_name = "N", default_value_t = 2, value_parser = clap::value_parser!(u16).range(1..=256))]
    jobs: u16,
    /// Seconds that the trial of one mutant may take
    #[arg(long, value_name = "S", default_value = "120", value_parser = seconds)]
    limit: Duration,
    /// The program that holds the mutants, instead of building it
    #[arg(long, value_name = "FILE")]
    program: Option<PathBuf>,
    /// Where to write the reports [default: reports]
    #[arg(long, value_name = "DIR")]
    reports: Option<PathBuf>,
}

/// The package that holds the mutants, and its program.
const PACKAGE: &str = "ncp-peer-mutants";
/// Where the reports go, from the workspace's root.
const REPORTS: &str = "reports";

/// Holds the suite against every mutant.
pub(super) fn mutants(suite: &Suite, args: &MutantsArgs, styles: Styles, stop: &Stop) -> Result<Exit, CliError> {
    let here = current_dir()?;
    let workspace = Workspace::find(&here);
    let root = workspace.as_ref().map_or(here, |found| found.root.clone());
    let program = match (&args.program, &workspace) {
        (Some(program), _) => std::path::absolute(program).unwrap_or_else(|_| program.clone()),
        (None, Some(workspace)) => build(workspace, stop)?,
        (None, None) => {
            return Err(CliError::Usage("the sources of the mutants are not here".to_owned()));
        }
    };
    let mutants = chosen(mutants::list(&program, suite).map_err(fault)?, &args.only)?;
    if args.list {
        let lines = mutants.iter().map(|Mutant { name, about, finding, rules }| {
            format!("{}  {finding}  {}\n    {about}\n", styles.out.bold(name), rules.join(" "))
        });
        print(&lines.collect::<String>())?;
        return Ok(Exit::Conformant);
    }
    let hunt = Hunt { program: &program, suite, jobs: usize::from(args.jobs), limit: args.limit, stop };
    let said = Progress::spinner(
        format!("{}, {} cases", plural(mutants.len()), suite.cases().len()),
        std::io::stderr().is_terminal(),
    );
    let trials = mutants::hunt(&hunt, &mutants, &|trial| said.say(&line(trial, styles))).map_err(fault);
    said.done();
    let report = MutantsReport::new(suite, trials?);
    // What some of them show is no report on all.
    if args.only.is_empty() {
        let folder = args.reports.clone().unwrap_or_else(|| root.join(REPORTS));
        let json =
            report.to_json().map_err(|error| CliError::Harness(format!("the report cannot be written: {error}")))?;
        write(&folder.join("mutants.json"), &json)?;
        write(&folder.join("mutants.md"), &report.to_markdown())?;
    }
    print(&summary(&report, styles))?;
    Ok(if report.totals.all_killed() { Exit::Conformant } else { Exit::NotConformant })
}

/// Builds the program that holds the mutants.
fn build(workspace: &Workspace, stop: &Stop) -> Result<PathBuf, CliError> {
    let cargo = ["cargo", "build", "--release", "--quiet", "-p", PACKAGE];
    let setup = Setup {
        say: "build the mutants".to_owned(),
        launch: Launch::new(cargo.map(str::to_owned).to_vec(), &workspace.root),
    };
    let said = Progress::spinner(setup.say.clone(), std::io::stderr().is_terminal());
    let built = setup.run(stop);
    said.done();
    built?;
    let name = format!("{PACKAGE}{}", std::env::consts::EXE_SUFFIX);
    Ok(workspace.target().join(Path::new("release")).join(name))
}

/// The mutants that were named; all, if none was.
fn chosen(mutants: Vec<Mutant>, only: &[String]) -> Result<Vec<Mutant>, CliError> {
    if let Some(unknown) = only.iter().find(|name| !mutants.iter().any(|mutant| mutant.name == **name)) {
        return Err(CliError::Usage(format!("there is no mutant {unknown}; see ncp-verify mutants --list")));
    }
    Ok(mutants.into_iter().filter(|mutant| only.is_empty() || only.contains(&mutant.name)).collect())
}

fn fault(error: MutantsError) -> CliError {
    match error {
        MutantsError::Start(error) => CliError::Start(error),
        other => CliError::Harness(other.to_string()),
    }
}

fn line(trial: &Trial, styles: Styles) -> String {
    let (mark, name) = match trial.fate {
        Fate::Killed => (styles.error.green("✓"), trial.mutant.name.clone()),
        _ => (styles.error.red("✗"), styles.error.red(&trial.mutant.name)),
    };
    let rule = trial.mutant.rules.first().map_or("", String::as_str);
    format!("{mark} {name}  {rule}, {} failing", trial.failing_cases)
}

fn summary(report: &MutantsReport, styles: Styles) -> String {
    let totals = report.totals;
    let mut text = String::new();
    for remark in report.remarks() {
        text.push_str(&format!("{}\n", styles.out.red(&remark)));
    }
    let line = format!(
        "{}: {} killed, of which {} by the rule that the verdict names first and {} by one of its first three; {} misnamed, {} survived, {} not finished",
        plural(report.mutants.len()),
        totals.killed,
        totals.named_first,
        totals.named_early,
        totals.misnamed,
        totals.survived,
        totals.unfinished
    );
    text.push_str(&if totals.all_killed() { styles.out.green(&line) } else { styles.out.red(&line) });
    text.push('\n');
    text
}

fn plural(mutants: usize) -> String {
    format!("{mutants} mutant{}", if mutants == 1 { "" } else { "s" })
}
