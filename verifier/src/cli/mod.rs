//! The command line of `ncp-verify`.
//!
//! Every error is one message on stderr and an exit code of PROTOCOL.md, section 8. What is asked for goes to stdout;
//! what happens meanwhile goes to stderr.

mod attest;
mod check;
mod convert;
mod explain;
mod fuzz;
mod gate;
mod list;
mod merge;
mod output;
mod shell;
mod workspace;

use std::io::{IsTerminal as _, Write as _};
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::LazyLock;
use std::time::Duration;

use clap::builder::styling::{AnsiColor, Styles};
use clap::{Args, Parser, Subcommand, ValueEnum};
use ncp_text::catalogue::{Level, Role};
use ncp_text::{CONTRACT_HASH, WIRE_VERSION};

use crate::attest::AttestError;
use crate::diff::{self, DiffError};
use crate::gate::GateError;
use crate::journal::JournalError;
use crate::merge::MergeError;
use crate::peer::{Address, ManifestError, StartError};
use crate::report::{Exit, Form, ReadError, RenderError, Style, comparison};
use crate::shard::Shard;
use crate::stop::Stop;
use crate::suite::{DEEP, Pattern, Selection, Suite, SuiteError};
use crate::verdict::BaselineError;

use attest::{AttestArgs, CheckReportArgs};
use convert::ConvertArgs;
use gate::GateArgs;
use merge::MergeArgs;
use output::OutputArgs;
use shell::{CompletionsArgs, ManArgs};

/// How wide a line is where there is no terminal to ask.
const PIPED_WIDTH: usize = 100;

/// Runs the program.
#[must_use]
pub fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) => {
            let exit = if error.use_stderr() { Exit::Usage.code() } else { 0 };
            // Nothing is left to be done if even that cannot be printed.
            let _ = error.print();
            return ExitCode::from(exit);
        }
    };
    let exit = run(&cli).unwrap_or_else(|error| {
        let style = cli.style(std::io::stderr().is_terminal());
        eprintln!("{} {error}", style.red("error:"));
        error.exit()
    });
    ExitCode::from(exit.code())
}

fn run(cli: &Cli) -> Result<Exit, CliError> {
    let stop = Stop::default();
    listen(&stop)?;
    let style = cli.style(std::io::stdout().is_terminal());
    let suite = || match &cli.vectors {
        Some(_) if cli.is_deep() => {
            Err(CliError::Usage("--deep is of the vectors that are built in, and not of those of a folder".to_owned()))
        }
        Some(folder) if !folder.is_dir() => {
            Err(CliError::Usage(format!("--vectors {}: there is no such folder", folder.display())))
        }
        Some(folder) => Ok(Suite::load(folder)?),
        None if cli.is_deep() => Ok(Suite::with_deep()?),
        None => Ok(Suite::embedded()?),
    };
    let styles = check::Styles { out: style, error: cli.style(std::io::stderr().is_terminal()) };
    match &cli.command {
        None => check::bundled(&suite()?, &cli.check, styles, &stop),
        Some(Command::Run(run)) => check::named(&suite()?, run, styles, &stop),
        Some(Command::Fuzz(args)) => fuzz::fuzz(&suite()?, args, styles, &stop),
        Some(Command::Diff(diff)) => compare(diff, style),
        Some(Command::Gate(args)) => gate::gate(args, styles, &stop),
        Some(Command::Attest(args)) => attest::attest(&suite()?, args),
        Some(Command::CheckReport(args)) => attest::check_report(&suite()?, args),
        Some(Command::Convert(args)) => convert::convert(&suite()?, args),
        Some(Command::Merge(args)) => merge::merge(&suite()?, args, styles),
        Some(Command::List(list)) => list::list(&suite()?, list, style),
        Some(Command::Explain(explain)) => explain::explain(&suite()?, &explain.id, style),
        Some(Command::Starter) => print(STARTER).map(|()| Exit::Conformant),
        Some(Command::Completions(args)) => shell::completions(args),
        Some(Command::Man(args)) => shell::man(args),
    }
}

/// Asks the run to end on Ctrl-C and on a request to terminate; the second time, ends at once.
fn listen(stop: &Stop) -> Result<(), CliError> {
    for signal in [signal_hook::consts::SIGINT, signal_hook::consts::SIGTERM] {
        signal_hook::flag::register_conditional_shutdown(signal, i32::from(Exit::Interrupted.code()), stop.flag())
            .and_then(|_| signal_hook::flag::register(signal, stop.flag()))
            .map_err(|source| CliError::Harness(format!("the signal {signal} cannot be handled: {source}")))?;
    }
    Ok(())
}

/// What the program is, and what it judges by.
static LONG_VERSION: LazyLock<String> = LazyLock::new(|| {
    format!(
        "{}\nwire version   {WIRE_VERSION}\ncontract hash  {CONTRACT_HASH}\ncorpus         sha256:{}",
        env!("CARGO_PKG_VERSION"),
        Suite::embedded_digest()
    )
});

/// Checks whether an implementation of NCP conforms.
///
/// With `run`, checks your peer; without a command, in a checkout of the project, builds and checks every bundled one.
#[derive(Debug, Parser)]
#[command(
    name = "ncp-verify",
    version,
    long_version = LONG_VERSION.as_str(),
    args_conflicts_with_subcommands = true,
    styles = Styles::styled().header(AnsiColor::Green.on_default().bold()).literal(AnsiColor::Cyan.on_default().bold()),
    after_help = AFTER_HELP,
)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
    #[command(flatten)]
    check: CheckArgs,
    /// Read the vectors of this folder instead of those built in
    #[arg(long, value_name = "DIR", global = true)]
    vectors: Option<PathBuf>,
    /// When to use colours; NO_COLOR is respected
    #[arg(long, value_name = "WHEN", global = true, default_value = "auto")]
    color: Colour,
}

const AFTER_HELP: &str = "\
Examples:
  ncp-verify                                            every bundled peer, in a checkout of the project
  ncp-verify run --peer-cmd 'python3 my_adapter.py'     your peer, by a command
  ncp-verify run --connect tcp://127.0.0.1:7000         your peer, where it listens
  ncp-verify run --peer my/peer --role body             the peer of a folder with peer.toml, as a body
  ncp-verify run --peer my/peer --filter 'wire/*/seq/*' some cases only
  ncp-verify fuzz --peer my/peer --time 10m             random traces, held against the specification
  ncp-verify list --filter duplicate                    which cases there are
  ncp-verify explain NCP-WIRE-007                       a rule and the cases that test it
  ncp-verify diff old.json new.json                     what a release fixes, and what it breaks
  ncp-verify merge one.json two.json                    one result from the shards of a run
  ncp-verify convert result.json --to md                a stored result in another format
  ncp-verify attest result.json --key KEY -o FILE       a signed result
  ncp-verify gate --against v0.1.0                      whether this tree can be released
  ncp-verify starter > my_adapter.py                    an adapter to begin with

Exit codes:
    0  conformant, or as expected: nothing fails but the peer's expected failures
    1  not conformant
    2  usage: the command line, a peer.toml, or a filter that selects nothing
    3  a peer could not be started, or did not answer `describe`
    4  the suite itself is at fault: a vector file, a report that cannot be written
  130  interrupted; the report is written, with what was not run";

#[derive(Debug, Subcommand)]
enum Command {
    /// Check the peers that you name
    #[command(after_help = RUN_HELP)]
    Run(Box<RunArgs>),
    /// Search a peer for what no case shows: random traces, held against the specification
    #[command(after_help = fuzz::HELP)]
    Fuzz(fuzz::FuzzArgs),
    /// Compare two results of one peer, such as those of two releases
    #[command(after_help = DIFF_HELP)]
    Diff(DiffArgs),
    /// Make one result of those of the shards of a run
    Merge(MergeArgs),
    /// Write a stored result in another format
    Convert(ConvertArgs),
    /// Sign a result, as an in-toto statement about the peer
    Attest(AttestArgs),
    /// Check a signed result: its signature, its digests, and that its verdict follows from its cases
    CheckReport(CheckReportArgs),
    /// Hold a tree against what went out before: whether it can be released
    Gate(GateArgs),
    /// List the cases, or the rules that they test
    List(ListArgs),
    /// Explain a case, a rule or a flag
    #[command(
        after_help = EXPLAIN_HELP
    )]
    Explain(ExplainArgs),
    /// Print an adapter to begin with, in Python: a peer that answers a few calls, and is to be filled in
    #[command(after_help = STARTER_HELP)]
    Starter,
    /// Print the completions of a shell
    #[command(after_help = shell::COMPLETIONS_HELP)]
    Completions(CompletionsArgs),
    /// Print the manual page, or write the pages of all commands into a folder
    #[command(after_help = shell::MAN_HELP)]
    Man(ManArgs),
}

const STARTER: &str = include_str!("../../../peers/PROTOCOL-starter.py");

const STARTER_HELP: &str = "\
Examples:
  ncp-verify starter > my_adapter.py
  ncp-verify run --peer-cmd 'python3 my_adapter.py'";

const EXPLAIN_HELP: &str = "\
Examples:
  ncp-verify explain wire/command_frame/seq/null
  ncp-verify explain NCP-WIRE-007
  ncp-verify explain lenient-integers";

const DIFF_HELP: &str = "\
Says what is fixed, what newly fails, and what fails in another way. A case that could not be judged before, \
since an earlier step failed, and now fails by its own rule, is no regression.

Examples:
  ncp-verify run --peer my/peer --json old.json
  ncp-verify diff old.json new.json
  ncp-verify diff old.json new.json --markdown >> notes.md

Exit codes:
    0  no regression
    1  a case that passed no longer does
    2  usage: a file that is no result";

const ATTEST_HELP: &str = "\
The attestation is a DSSE envelope, signed with ed25519, around an in-toto statement. Its subjects are the files \
that the peer's command names, by their digests as they are now, and those that you name; it also has the \
digests of vectors, text and verifier, and holds the whole result. A result whose verdict does not follow from \
its cases is not signed.

Examples:
  ncp-verify attest --new-key release.key
  ncp-verify attest result.json --key release.key --artefact dist/peer.tar.gz -o result.attestation.json

Exit codes:
    0  it is written, whatever the verdict
    2  usage: a file that is no result or no key, or a result that does not hold";

const CHECK_REPORT_HELP: &str = "\
Refuses what was not signed by the key, or was changed; what is about other vectors or another text than this \
program has; and a result that is not what follows from its cases, which are all judged anew.

Examples:
  ncp-verify check-report result.attestation.json --key release.key.pub
  ncp-verify check-report result.attestation.json --key release.key.pub --artefact dist/peer.tar.gz

Exit codes:
    0  it holds, whatever the verdict
    1  it is refused
    2  usage: a file that cannot be read, or no key";

const CONVERT_HELP: &str = "\
Formats:
  json     the whole result, by schemas/result.schema.json
  junit    JUnit XML: a test a case; what was not run, or is expected to fail, is skipped
  md       Markdown, for the summary of a CI job
  sarif    SARIF 2.1.0, for code hosts: a result a case that does not pass
  html     one page for people, without a network: every case, to its input and its trace
  tsv      a line a case, separated by tabs
  badge    an SVG badge
  shields  the JSON of a shields.io endpoint

Examples:
  ncp-verify convert result.json --to md >> summary.md
  ncp-verify convert result.json --to sarif -o result.sarif
  ncp-verify run --peer my/peer --report md=summary.md --report sarif=result.sarif

Exit codes:
    0  it is written, whatever the verdict
    2  usage: a file that is no result";

const MERGE_HELP: &str = "\
The merged result is that of one run over all cases, byte for byte, but for the time that it took. It draws on \
the same vectors as the shards, so that this has to be the same version of ncp-verify.

Examples:
  ncp-verify run --peer my/peer --shard 1/2 --json one.json
  ncp-verify run --peer my/peer --shard 2/2 --json two.json
  ncp-verify merge one.json two.json --json result.json --junit result.xml

Exit codes: those of the one run";

const RUN_HELP: &str = "\
A peer is any program that speaks the protocol of peers/PROTOCOL.md, on its standard streams or as a server over \
TCP or WebSocket. What `ncp-verify starter` prints is an adapter to begin with.

Examples:
  ncp-verify run --peer-cmd 'python3 my_adapter.py'
  ncp-verify run --connect ws://127.0.0.1:7000/ncp
  ncp-verify run --peer peers/rust --peer peers/typescript --level wire
  ncp-verify run --peer my/peer --filter NCP-WIRE-01? --verbose
  ncp-verify run --peer my/peer --deep
  ncp-verify run --peer my/peer --write-expected known.toml
  ncp-verify run --peer my/peer --expected known.toml
  ncp-verify run --peer peers/rust --repeat 50 --jobs 2
  ncp-verify run --peer peers/rust --jobs 4 --shard 2/5 --json shard-2.json
  ncp-verify run --peer my/peer --resume
  ncp-verify run --peer my/peer --rerun-failed reports/run/result.json";

#[derive(Debug, Args)]
struct RunArgs {
    /// A folder with a peer.toml (may be repeated)
    #[arg(long, value_name = "DIR")]
    peer: Vec<PathBuf>,
    /// A command that starts a peer; quotes work as in a shell (may be repeated)
    #[arg(long, value_name = "CMD")]
    peer_cmd: Vec<String>,
    /// The address of a peer that listens: tcp://HOST:PORT or ws://HOST:PORT/PATH (may be repeated)
    #[arg(long, value_name = "URL", value_parser = Address::parse)]
    connect: Vec<Address>,
    /// A file of failures that are expected of the peer, beside those of its peer.toml
    #[arg(long, value_name = "FILE")]
    expected: Option<PathBuf>,
    /// Run the deep set besides the corpus: long traces, large sizes and rare combinations that a search chose
    #[arg(long)]
    deep: bool,
    /// Write every failure of the peer to a file that --expected takes
    #[arg(long, value_name = "FILE")]
    write_expected: Option<PathBuf>,
    #[command(flatten)]
    check: CheckArgs,
}

#[derive(Debug, Args)]
struct CheckArgs {
    #[command(flatten)]
    select: SelectArgs,
    /// How many processes of each peer, or connections to it, work side by side
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..=256))]
    jobs: u16,
    /// Seconds that a peer may be silent while a request is in flight
    #[arg(long, value_name = "S", default_value = "10", value_parser = seconds)]
    timeout: Duration,
    /// Seconds until the first answer of a process
    #[arg(long, value_name = "S", default_value = "30", value_parser = seconds)]
    start_timeout: Duration,
    /// Give a peer up after so many restarts of its process [default: when it answers nothing any more]
    #[arg(long, value_name = "N")]
    max_restarts: Option<u32>,
    /// Run every case N times, those above 64 KiB once, and print the rate
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..))]
    repeat: u32,
    /// Run one part of the cases, such as 2/5; `ncp-verify merge` makes one result of all parts
    #[arg(long, value_name = "I/N")]
    shard: Option<Shard>,
    /// Go on with a run that was killed or interrupted, by the journal beside its result
    #[arg(long)]
    resume: bool,
    /// Run only the cases that failed, or were not run, in this result
    #[arg(long, value_name = "RESULT")]
    rerun_failed: Option<PathBuf>,
    #[command(flatten)]
    output: OutputArgs,
}

#[derive(Debug, Args)]
struct SelectArgs {
    /// Judge this role, claimed or not, instead of all that the peer claims (may be repeated)
    #[arg(long, value_name = "ROLE", value_parser = role)]
    role: Vec<Role>,
    /// Judge up to this level: wire, safety or strict [default: what the peer's peer.toml claims, else wire]
    #[arg(long, value_name = "LEVEL", value_parser = level)]
    level: Option<Level>,
    /// Only cases whose id, rule, flag or call holds this text, or fits it as a whole if it has * or ? (may be
    /// repeated)
    #[arg(long, value_name = "PATTERN")]
    filter: Vec<String>,
}

#[derive(Debug, Args)]
struct DiffArgs {
    /// The older result
    old: PathBuf,
    /// The newer result
    new: PathBuf,
    /// Print JSON
    #[arg(long, conflicts_with = "markdown")]
    json: bool,
    /// Print Markdown
    #[arg(long)]
    markdown: bool,
    /// Name every case
    #[arg(long, short)]
    verbose: bool,
}

#[derive(Debug, Args)]
struct ListArgs {
    #[command(flatten)]
    select: SelectArgs,
    /// List rules instead of cases
    #[arg(long)]
    requirements: bool,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

#[derive(Debug, Args)]
struct ExplainArgs {
    /// The id of a case or a rule, or a flag
    id: String,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
enum Colour {
    Auto,
    Always,
    Never,
}

impl Cli {
    /// Whether the deep set is to be used besides the corpus: it is run, or explained.
    fn is_deep(&self) -> bool {
        match &self.command {
            Some(Command::Run(run)) => run.deep,
            Some(Command::Explain(explain)) => explain.id.starts_with(DEEP),
            _ => false,
        }
    }

    /// How to write to a stream, which is a terminal or not.
    fn style(&self, terminal: bool) -> Style {
        let plain = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
        let colour = match self.color {
            Colour::Always => true,
            Colour::Never => false,
            Colour::Auto => terminal && !plain,
        };
        let columns = std::env::var("COLUMNS").ok().and_then(|columns| columns.parse().ok());
        let asked = terminal_size::terminal_size().filter(|_| terminal).map(|(width, _)| usize::from(width.0));
        Style { colour, width: asked.or(columns).unwrap_or(PIPED_WIDTH).clamp(40, 240) }
    }
}

impl SelectArgs {
    fn selection(&self) -> Selection {
        Selection {
            patterns: self.filter.iter().map(|pattern| Pattern::new(pattern)).collect(),
            roles: self.role.clone(),
            level: self.level,
        }
    }
}

/// What ends the program early.
#[derive(Debug, thiserror::Error)]
enum CliError {
    #[error("{0}")]
    Usage(String),
    #[error(transparent)]
    Manifest(#[from] ManifestError),
    #[error("{peer}: {source}")]
    Baseline { peer: String, source: BaselineError },
    #[error(transparent)]
    Start(#[from] StartError),
    #[error(transparent)]
    Diff(#[from] DiffError),
    #[error(transparent)]
    Read(#[from] ReadError),
    #[error(transparent)]
    Merge(#[from] MergeError),
    #[error(transparent)]
    Journal(#[from] JournalError),
    #[error(transparent)]
    Render(#[from] RenderError),
    #[error(transparent)]
    Attest(#[from] AttestError),
    #[error(transparent)]
    Gate(#[from] GateError),
    #[error("the suite: {0}")]
    Suite(#[from] SuiteError),
    #[error("{0}")]
    Harness(String),
}

impl CliError {
    fn exit(&self) -> Exit {
        match self {
            Self::Usage(_) | Self::Manifest(_) | Self::Baseline { .. } | Self::Diff(_) => Exit::Usage,
            Self::Read(_) | Self::Merge(_) | Self::Attest(_) => Exit::Usage,
            Self::Journal(JournalError::File { .. }) => Exit::Harness,
            Self::Journal(_) => Exit::Usage,
            Self::Gate(GateError::Interrupted) => Exit::Interrupted,
            Self::Gate(_) => Exit::Usage,
            Self::Start(_) => Exit::NotStarted,
            Self::Suite(_) | Self::Render(_) | Self::Harness(_) => Exit::Harness,
        }
    }
}

/// Compares two results.
fn compare(args: &DiffArgs, style: Style) -> Result<Exit, CliError> {
    let compared = diff::compare(&args.old, &args.new)?;
    let text = if args.json {
        let json = serde_json::to_string_pretty(&compared);
        json.map_err(|error| CliError::Harness(format!("the comparison cannot be written: {error}")))? + "\n"
    } else {
        let form = if args.markdown { Form::Markdown } else { Form::Terminal(style) };
        comparison(&compared, form, args.verbose)
    };
    print(&text)?;
    Ok(if compared.regression { Exit::NotConformant } else { Exit::Conformant })
}

/// Prints to stdout. That its reader has gone is no error of ours.
fn print(text: &str) -> Result<(), CliError> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(CliError::Harness(format!("the report cannot be printed: {error}")))
        }
        _ => Ok(()),
    }
}

fn role(name: &str) -> Result<Role, String> {
    Role::parse(name).ok_or_else(|| format!("one of {}", Role::ALL.map(Role::as_str).join(", ")))
}

fn level(name: &str) -> Result<Level, String> {
    Level::parse(name).ok_or_else(|| format!("one of {}", Level::ALL.map(Level::as_str).join(", ")))
}

fn seconds(text: &str) -> Result<Duration, String> {
    let seconds: f64 = text.parse().map_err(|_| "a number of seconds".to_owned())?;
    if !(0.001..=86_400.0).contains(&seconds) {
        return Err("between 0.001 and 86400 seconds".to_owned());
    }
    Ok(Duration::from_secs_f64(seconds))
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory as _;

    #[test]
    fn the_command_line_is_well_formed() {
        Cli::command().debug_assert();
    }

    #[test]
    fn options_stand_without_a_command_and_after_run() {
        let cli = Cli::try_parse_from(["ncp-verify", "--level", "wire", "--jobs", "2"]).unwrap();
        assert!(cli.command.is_none() && cli.check.jobs == 2 && cli.check.select.level == Some(Level::Wire));
        let cli = Cli::try_parse_from(["ncp-verify", "run", "--peer-cmd", "x", "--timeout", "0.5"]).unwrap();
        let Some(Command::Run(run)) = cli.command else { panic!() };
        assert_eq!((run.peer_cmd, run.check.timeout), (vec!["x".to_owned()], Duration::from_millis(500)));
    }

    /// A terminal wraps a paragraph where it ends; a break of ours within it would leave a stump of a line.
    #[test]
    fn no_paragraph_of_a_help_text_has_a_line_break_of_its_own() {
        let is_prose = |line: &str| !line.is_empty() && !line.starts_with(' ') && !line.ends_with(':');
        for command in Cli::command().get_subcommands() {
            let help = command.get_after_help().map(ToString::to_string).unwrap_or_default();
            let lines: Vec<&str> = help.lines().collect();
            let broken = lines.windows(2).find(|pair| pair.iter().all(|line| is_prose(line)));
            assert_eq!(broken, None, "{}", command.get_name());
        }
    }

    #[test]
    fn values_that_mean_nothing_are_refused() {
        for bad in [
            ["--role", "pilot"],
            ["--level", "high"],
            ["--jobs", "0"],
            ["--repeat", "0"],
            ["--timeout", "-1"],
            ["--timeout", "NaN"],
        ] {
            assert!(Cli::try_parse_from(["ncp-verify"].into_iter().chain(bad)).is_err(), "{bad:?}");
        }
    }
}
