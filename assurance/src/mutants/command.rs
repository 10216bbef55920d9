//! `cargo assure mutants`.

use std::io::IsTerminal as _;
use std::path::{Path, PathBuf};
use std::time::Duration;

use clap::Args;
use ncp_verifier::peer::Setup;
use ncp_verifier::report::Progress;
use ncp_verifier::stop::Stop;
use ncp_verifier::suite::Suite;
use xtask::project::Project;

use super::{Asks, Fate, Hunt, Mutant, MutantsError, MutantsReport, Trial, planted};
use crate::artefact::Artefact;
use crate::console::{self, Styles, counted};
use crate::{Error, reports};

#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub(crate) struct MutantsArgs {
    /// Only this mutant; writes no reports (may be repeated)
    #[arg(long, value_name = "NAME")]
    only: Vec<String>,
    /// One peer with all defects of those that --only names
    #[arg(long, requires = "only")]
    together: bool,
    /// Only list the mutants
    #[arg(long)]
    list: bool,
    /// Each against the cases of its own rules alone: whether they notice it, not what else the verdict would name;
    /// writes no reports
    #[arg(long)]
    quick: bool,
    /// How many mutants are on trial side by side
    #[arg(long, value_name = "N", default_value_t = 2, value_parser = clap::value_parser!(u16).range(1..=256))]
    jobs: u16,
    /// Seconds that the trial of one mutant may take
    #[arg(long, value_name = "S", default_value = "120", value_parser = seconds)]
    limit: Duration,
    /// The folder with the tables of defects
    #[arg(long, value_name = "DIR", default_value = TABLES)]
    defects: PathBuf,
    /// The program that holds the defects, started with `--defect NAME`, instead of building it
    #[arg(long, value_name = "FILE")]
    program: Option<PathBuf>,
    /// The vectors of this folder instead of those built in
    #[arg(long, value_name = "DIR")]
    vectors: Option<PathBuf>,
    /// The deep set besides the corpus
    #[arg(long, conflicts_with = "vectors")]
    deep: bool,
    /// Where to write the reports; the lock is written only with those of the project
    #[arg(long, value_name = "DIR", default_value = reports::PAGES)]
    reports: PathBuf,
    /// Also write the trials to this file, as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

const HELP: &str = "\
Copies the Rust peer into .tools/planted, with a switch at every place that a defect of defects/peer changes, and writes
reports/mutants.md, reports/lock/mutants.toml and the long reports in reports/full.
Ends with 1 if the suite does not notice a mutant, or does not name the rule that it breaks.

Examples:
  cargo assure mutants --list
  cargo assure mutants --quick
  cargo assure mutants --only lenient-integer-fraction
  cargo assure mutants --defects defects/deep --deep --reports target/deep
  cargo assure mutants --only fence-open-ball --only speed-per-axis --together";

/// Where the tables of defects are, from the root of the project.
pub(crate) const TABLES: &str = "defects/peer";
/// The artefact that this command makes.
const ARTEFACT: &str = "mutants";

/// Holds the suite against every mutant; `false` if one is not killed, or has a rule blamed that it keeps.
pub(crate) fn mutants(project: &Project, args: &MutantsArgs) -> Result<bool, Error> {
    let (styles, stop) = (Styles::detect(), console::stop().map_err(Error::Signals)?);
    let built_in = if args.deep { Suite::with_deep } else { Suite::embedded };
    let suite = args.vectors.as_deref().map_or_else(built_in, Suite::load)?;
    let root = project.path("");
    // What changes while the mutants are on trial was not tried.
    let sources = Artefact::named(ARTEFACT).map(|own| own.digests(&root)).transpose();
    let sources = sources.map_err(|source| Error::File { path: root.clone(), source })?.unwrap_or_default();

    let defects = ncp_defects::read(&root.join(&args.defects)).map_err(MutantsError::from)?;
    let mutants = chosen(super::list(&defects, &suite)?, args)?;
    if args.list {
        for Mutant { name, about, finding, rules, .. } in mutants {
            println!("{}  {finding}  {}\n    {about}", styles.out.bold(&name), rules.join(" "));
        }
        return Ok(true);
    }
    let program = match &args.program {
        Some(program) => std::path::absolute(program).unwrap_or_else(|_| program.clone()),
        None => build(project, &defects, &stop)?,
    };
    let asks = if args.quick { Asks::OwnRules } else { Asks::All };
    let jobs = usize::from(args.jobs);
    let hunt = Hunt { program: &program, suite: &suite, asks, jobs, limit: args.limit, stop: &stop };
    let said = Progress::spinner(
        format!("{}, {} cases", counted(mutants.len(), "mutant"), suite.cases().len()),
        std::io::stderr().is_terminal(),
    );
    let trials = super::hunt(&hunt, &mutants, &|trial| said.say(&line(trial, styles)));
    said.done();
    let report = MutantsReport::new(&suite, trials?);
    if let Some(file) = &args.json {
        reports::json(&root.join(file), &report)?;
    }
    // What some of them show, or some of the cases, is no report on all.
    if args.only.is_empty() && !args.quick {
        let folder = root.join(&args.reports);
        reports::page(&folder, ARTEFACT, &report.page())?;
        reports::full(&folder, ARTEFACT, &report, &report.full_page())?;
        let is_usual = !args.deep && args.vectors.is_none() && args.defects == Path::new(TABLES);
        if is_usual && args.program.is_none() && args.reports == Path::new(reports::PAGES) {
            report.lock(sources).write(&root, ARTEFACT)?;
        }
    }
    if args.quick {
        print!("{}", quick_summary(&report, styles));
        return Ok(report.totals.all_killed());
    }
    print!("{}", summary(&report, styles));
    Ok(report.totals.all_rightly_judged())
}

/// Brings the copy with the defects up to date and builds it.
pub(crate) fn build(project: &Project, defects: &[ncp_defects::Defect], stop: &Stop) -> Result<PathBuf, MutantsError> {
    let planted = planted::weave(project, defects)?;
    let setup = Setup { say: "build the mutants".to_owned(), launch: planted.build() };
    let said = Progress::spinner(setup.say.clone(), std::io::stderr().is_terminal());
    let built = setup.run(stop);
    said.done();
    built?;
    Ok(planted.program())
}

/// The mutants that were named; all, if none was.
fn chosen(mutants: Vec<Mutant>, args: &MutantsArgs) -> Result<Vec<Mutant>, Error> {
    let MutantsArgs { only, together, .. } = args;
    if let Some(unknown) = only.iter().find(|name| !mutants.iter().any(|mutant| mutant.name == **name)) {
        return Err(Error::Usage { what: format!("there is no mutant {unknown}; see cargo assure mutants --list") });
    }
    let is_chosen = |mutant: &Mutant| only.is_empty() || only.contains(&mutant.name);
    let chosen: Vec<Mutant> = mutants.into_iter().filter(is_chosen).collect();
    Ok(if *together { vec![Mutant::together(&chosen)] } else { chosen })
}

fn line(trial: &Trial, styles: Styles) -> String {
    let (mark, name) = match trial.fate {
        Fate::Killed => (styles.error.green("✓"), trial.mutant.name.clone()),
        _ => (styles.error.red("✗"), styles.error.red(&trial.mutant.name)),
    };
    format!("{mark} {name}  {}, {} failing", trial.mutant.owed().join(" "), trial.failing_cases)
}

fn summary(report: &MutantsReport, styles: Styles) -> String {
    let totals = report.totals;
    let remarks = report.remarks().into_iter().map(|remark| format!("{}\n", styles.out.red(&remark)));
    let line = format!(
        "{}: {} killed, of which {} by the rule that the verdict names first, {} by that or one as \
         directly broken, and {} by one of its first three; {} with a rule blamed falsely, {} misnamed, {} survived, \
         {} not finished",
        counted(report.mutants.len(), "mutant"),
        totals.killed,
        totals.named_first,
        totals.led_rightly,
        totals.named_early,
        totals.blamed,
        totals.misnamed,
        totals.survived,
        totals.unfinished
    );
    let by_corpus = report.mutants.iter().filter(|trial| trial.by_corpus == Some(Fate::Killed)).count();
    let line = if report.mutants.iter().any(|trial| trial.by_corpus.is_some()) {
        format!("{line}; by the corpus alone, {by_corpus} are killed")
    } else {
        line
    };
    let line = if totals.all_rightly_judged() { styles.out.green(&line) } else { styles.out.red(&line) };
    format!("{}{line}\n", remarks.collect::<String>())
}

/// What the cases of each mutant's own rules show: nothing of the other rules that a verdict on all cases names.
fn quick_summary(report: &MutantsReport, styles: Styles) -> String {
    let totals = report.totals;
    let alive = report.mutants.iter().filter(|trial| trial.fate != Fate::Killed);
    let remarks = alive.map(|trial| format!("{}\n", styles.out.red(&format!("{}: {}", trial.mutant.name, trial.fate))));
    let line = format!(
        "{}: {} killed by a case of their own rules, {} misnamed, {} survived, {} not finished",
        counted(report.mutants.len(), "mutant"),
        totals.killed,
        totals.misnamed,
        totals.survived,
        totals.unfinished
    );
    let line = if totals.all_killed() { styles.out.green(&line) } else { styles.out.red(&line) };
    format!("{}{line}\n", remarks.collect::<String>())
}

fn seconds(text: &str) -> Result<Duration, String> {
    let seconds: f64 = text.parse().map_err(|_| "a number of seconds".to_owned())?;
    if !(0.001..=86_400.0).contains(&seconds) {
        return Err("between 0.001 and 86400 seconds".to_owned());
    }
    Ok(Duration::from_secs_f64(seconds))
}
