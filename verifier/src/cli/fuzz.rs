//! `ncp-verify fuzz`: the search for what no case of the corpus shows.

use std::io::IsTerminal as _;
use std::path::PathBuf;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;
use std::time::{Duration, SystemTime, UNIX_EPOCH};

use clap::Args;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use ncp_text::catalogue::{Level, Role};

use super::check::{Styles, current_dir, one_at_a_time, write};
use super::workspace::{Workspace, target};
use super::{CliError, level, print, role, seconds};
use crate::fuzz::{self, Extent, FuzzError, Harvest, Listener, Settings, Tested, report};
use crate::peer::{Address, Connection, Launch, Manifest, StartError, handshake};
use crate::report::{Exit, Progress};
use crate::stop::Stop;
use crate::suite::{Pattern, Suite};

pub(super) const HELP: &str = "\
Draws inputs and whole traces at random and asks the specification and the peer the same. Where their answers \
part, and the text does not leave it open, the input is shrunk to the smallest that still shows it. A crash, a \
hang, or memory beyond a bound is found as well. The same seed finds the same, whatever --jobs.

No black box finds a value that switches checks off, unless it is tried. So strings and numbers that the text \
does not have are taken out of the sources in the peer's folder, or beside a script that its command names; \
--dictionary takes them out of other files, binaries among them, and the common ones too, and \
--no-dictionary does without.

Examples:
  ncp-verify fuzz --peer my/peer                              a minute of it
  ncp-verify fuzz --peer my/peer --time 1h --jobs 4 --save found
  ncp-verify run --peer my/peer --vectors found               what was found, as cases
  ncp-verify fuzz --peer my/peer --cases 10000 --seed 7       the same ten thousand each time
  ncp-verify fuzz --peer my/peer --filter governor --coverage what of the governor was reached
  ncp-verify fuzz --peer my/peer --dictionary my/peer/src     with the strings and numbers of its sources

Exit codes:
    0  no disagreement
    1  a disagreement, a crash, a hang, or too much memory
    2  usage: the command line, a peer.toml, or a filter that leaves nothing to ask
    3  a peer could not be started, or did not answer `describe`
    4  the suite itself is at fault
  130  interrupted; what was found until then is printed";

#[derive(Debug, Args)]
pub(super) struct FuzzArgs {
    /// A folder with a peer.toml (may be repeated) [default: every bundled peer]
    #[arg(long, value_name = "DIR")]
    peer: Vec<PathBuf>,
    /// A command that starts a peer; quotes work as in a shell (may be repeated)
    #[arg(long, value_name = "CMD")]
    peer_cmd: Vec<String>,
    /// The address of a peer that listens: tcp://HOST:PORT or ws://HOST:PORT/PATH (may be repeated)
    #[arg(long, value_name = "URL", value_parser = Address::parse)]
    connect: Vec<Address>,
    /// How long to search each peer, such as 90s, 10m or 1h [default: 60s]
    #[arg(long, value_name = "TIME", value_parser = duration, conflicts_with = "cases")]
    time: Option<Duration>,
    /// How many inputs to ask of each peer, instead of a time
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    cases: Option<u64>,
    /// What everything that is drawn begins with [default: by the clock]
    #[arg(long, value_name = "N")]
    seed: Option<u64>,
    /// Only calls whose name holds this text, or fits it as a whole if it has * or ? (may be repeated)
    #[arg(long, value_name = "PATTERN")]
    filter: Vec<String>,
    /// Ask as this role, claimed or not, instead of all that the peer claims (may be repeated)
    #[arg(long, value_name = "ROLE", value_parser = role)]
    role: Vec<Role>,
    /// Ask up to this level: wire, safety or strict [default: what the peer's peer.toml claims, else wire]
    #[arg(long, value_name = "LEVEL", value_parser = level)]
    level: Option<Level>,
    /// How many processes of each peer, or connections to it, work side by side [default: as many as there are cores;
    /// one connection, and one process of a peer with a fixed port]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=256))]
    jobs: Option<u16>,
    /// Write what is found as vector files into this folder, for run --vectors
    #[arg(long, value_name = "DIR")]
    save: Option<PathBuf>,
    /// Take strings and numbers out of this file, source or binary, or of all files of this folder (may be repeated)
    #[arg(long, value_name = "FILE", num_args = 1..)]
    dictionary: Vec<PathBuf>,
    /// Take nothing out of the peer's own sources
    #[arg(long, conflicts_with = "dictionary")]
    no_dictionary: bool,
    /// Write the result as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Print all of what was reached, and what never was
    #[arg(long)]
    coverage: bool,
    /// Seconds that a peer may be silent while a request is in flight
    #[arg(long, value_name = "S", default_value = "10", value_parser = seconds)]
    timeout: Duration,
    /// Seconds until the first answer of a process
    #[arg(long, value_name = "S", default_value = "30", value_parser = seconds)]
    start_timeout: Duration,
    /// Mebibytes of memory that a process of a peer may hold
    #[arg(long, value_name = "MIB", default_value_t = 2048, value_parser = clap::value_parser!(u64).range(16..))]
    memory: u64,
    /// Draw traces of N steps each [default: mostly up to 40, some of hundreds, rarely of thousands]
    #[arg(long, value_name = "N")]
    steps: Option<usize>,
    /// How often an input is tried on the way to the smallest
    #[arg(long, value_name = "N", default_value_t = 1500)]
    tries: usize,
}

/// A peer that is to be searched.
struct Source {
    name: Option<String>,
    shown: String,
    launch: Launch,
    manifest: Option<Manifest>,
}

impl Source {
    /// What the sources in the peer's folder hold, or those beside the scripts of its command.
    fn harvest(&self) -> Harvest {
        if let Some(manifest) = &self.manifest {
            return Harvest::of_sources(&manifest.folder);
        }
        let script = self.launch.files().into_iter().find(|file| Harvest::is_source(file));
        script.and_then(|script| script.parent().map(Harvest::of_sources)).unwrap_or_default()
    }
}

/// Searches the peers that were named, or the bundled ones.
pub(super) fn fuzz(suite: &Suite, args: &FuzzArgs, styles: Styles, stop: &Stop) -> Result<Exit, CliError> {
    let patterns: Vec<Pattern> = args.filter.iter().map(|pattern| Pattern::new(pattern)).collect();
    let calls = crate::peer::Call::ALL;
    if !patterns.is_empty() && !calls.iter().any(|call| patterns.iter().any(|pattern| pattern.fits_text(call.as_str())))
    {
        return Err(CliError::Usage(format!("no call fits --filter {}", args.filter.join(" --filter "))));
    }
    let named = Harvest::of_files(&args.dictionary).map_err(|error| CliError::Usage(error.to_string()))?;
    if !args.dictionary.is_empty() {
        eprintln!("dictionary: {} strings, {} numbers", named.words.len(), named.numbers.len());
    }
    let seed = args.seed.unwrap_or_else(by_the_clock);
    let extent = args.cases.map_or_else(|| Extent::Time(args.time.unwrap_or(Duration::from_secs(60))), Extent::Cases);
    let mut tested: Vec<(String, Tested)> = Vec::new();
    let (mut asked, mut missing) = (false, false);
    for source in sources(args)? {
        if stop.is_set() {
            break;
        }
        let name = source.name.clone().unwrap_or_else(|| source.shown.clone());
        let lacking = source.manifest.as_ref().map(Manifest::missing_tools).unwrap_or_default();
        if !lacking.is_empty() {
            eprintln!("{name}: SKIPPED, not on PATH: {}", lacking.join(", "));
            continue;
        }
        let harvest = if args.dictionary.is_empty() && !args.no_dictionary { source.harvest() } else { named.clone() };
        if harvest.is_light && !harvest.is_empty() {
            let (words, numbers) = (harvest.words.len(), harvest.numbers.len());
            eprintln!("{name}: of its sources {words} strings and {numbers} numbers are tried");
        }
        let settings = Settings {
            extent,
            seed,
            jobs: jobs(args, &source.launch),
            patterns: patterns.clone(),
            level: args
                .level
                .unwrap_or_else(|| source.manifest.as_ref().map_or(Level::Wire, |manifest| manifest.level)),
            roles: args.role.clone(),
            timeout: args.timeout,
            start_timeout: args.start_timeout,
            memory: args.memory << 20,
            tries: args.tries,
            harvest,
            length: args.steps,
        };
        let result = match one(&source, suite, &settings, stop) {
            Ok(result) => result,
            Err(FuzzError::Start(StartError::Interrupted)) => break,
            Err(FuzzError::Start(error)) => {
                eprintln!("{} {name}: {error}", styles.error.red("error:"));
                missing = true;
                continue;
            }
            Err(error) => return Err(CliError::Harness(error.to_string())),
        };
        let name = source.name.unwrap_or_else(|| result.description.name.clone());
        print(&report::terminal(&name, seed, &result, styles.out, args.coverage))?;
        if let Some(folder) = args.save.as_ref().filter(|_| !result.findings.is_empty()) {
            let file = fuzz::save(folder, &name, seed, &result.findings);
            let file = file.map_err(|error| CliError::Harness(error.to_string()))?;
            print(&format!("{}\n", styles.out.dim(&format!("saved: {}", file.display()))))?;
        }
        asked |= !result.nothing_asked;
        tested.push((name, result));
    }
    if let Some(file) = &args.json {
        let text = report::json(seed, &tested);
        let text = text.map_err(|error| CliError::Harness(format!("the result cannot be written: {error}")))?;
        write(file, &text)?;
    }
    let found = tested.iter().any(|(_, tested)| !tested.findings.is_empty() || tested.given_up.is_some());
    Ok(if stop.is_set() {
        Exit::Interrupted
    } else if found {
        Exit::NotConformant
    } else if missing {
        Exit::NotStarted
    } else if !asked {
        return Err(CliError::Usage("there is nothing to ask of these peers".to_owned()));
    } else {
        Exit::Conformant
    })
}

/// Starts one peer and searches it.
fn one(source: &Source, suite: &Suite, settings: &Settings, stop: &Stop) -> Result<Tested, FuzzError> {
    let visible = std::io::stderr().is_terminal();
    let name = source.name.as_deref().unwrap_or(&source.shown);
    for step in source.manifest.iter().flat_map(|manifest| &manifest.setup) {
        let said = Progress::spinner(format!("{name}: {}", step.say), visible);
        let result = step.run(stop);
        said.done();
        result?;
    }
    let mut connection = Connection::open(&source.launch)?;
    let description = handshake(&mut connection, settings.start_timeout, stop)?;
    let bar = Bar::new(name, settings.extent, visible);
    let result = fuzz::fuzz(&source.launch, connection, description, suite, settings, &bar, stop);
    bar.bar.finish_and_clear();
    result
}

fn sources(args: &FuzzArgs) -> Result<Vec<Source>, CliError> {
    let here = current_dir()?;
    let mut sources = Vec::new();
    let mut folder = |folder: PathBuf, shown: String| -> Result<(), CliError> {
        let absolute = std::path::absolute(&folder).unwrap_or(folder);
        let root = Workspace::above(&absolute).map_or_else(|| absolute.clone(), |workspace| workspace.root);
        let manifest = Manifest::load(&absolute, &root, &target(&root))?;
        let (name, launch) = (Some(manifest.name.clone()), manifest.launch.clone());
        sources.push(Source { name, shown, launch, manifest: Some(manifest) });
        Ok(())
    };
    if args.peer.is_empty() && args.peer_cmd.is_empty() && args.connect.is_empty() {
        let workspace = Workspace::of_bundled_peers(&here, "fuzz")?;
        for peer in workspace.peers {
            let shown = peer.display().to_string();
            folder(peer, shown)?;
        }
    }
    for peer in &args.peer {
        folder(peer.clone(), peer.display().to_string())?;
    }
    for command in &args.peer_cmd {
        let launch = Launch::from_command_line(command, &here)?;
        sources.push(Source { name: None, shown: command.clone(), launch, manifest: None });
    }
    for address in &args.connect {
        let launch = Launch::connect(address.clone());
        sources.push(Source { name: None, shown: address.to_string(), launch, manifest: None });
    }
    for source in &mut sources {
        if args.jobs.is_some_and(|jobs| jobs > 1) && source.launch.is_single() {
            return Err(CliError::Usage(one_at_a_time(source.name.as_ref().unwrap_or(&source.shown))));
        }
        source.launch = source.launch.clone().with_patience(args.start_timeout);
    }
    Ok(sources)
}

/// How many processes or connections work side by side. A server that listens may take one connection only, and
/// somebody else has started it, so that several are for them to ask for.
fn jobs(args: &FuzzArgs, launch: &Launch) -> usize {
    let alone = launch.is_single() || !launch.has_command();
    let cores = thread::available_parallelism().map_or(1, usize::from);
    args.jobs.map_or(if alone { 1 } else { cores }, usize::from)
}

/// A seed that the next run does not have.
fn by_the_clock() -> u64 {
    let now = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
    u64::from(now.subsec_micros()) ^ (now.as_secs() << 20) & 0xff_ffff_ffff
}

fn duration(text: &str) -> Result<Duration, String> {
    let (number, unit) = match text.find(|c: char| c.is_ascii_alphabetic()) {
        Some(at) => text.split_at(at),
        None => (text, "s"),
    };
    let by = match unit {
        "ms" => 0.001,
        "s" => 1.0,
        "m" | "min" => 60.0,
        "h" => 3600.0,
        _ => return Err("a time such as 90s, 10m or 1h".to_owned()),
    };
    let number: f64 = number.parse().map_err(|_| "a time such as 90s, 10m or 1h".to_owned())?;
    if !(0.001..=604_800.0).contains(&(number * by)) {
        return Err("between a millisecond and a week".to_owned());
    }
    Ok(Duration::from_secs_f64(number * by))
}

/// A search while it goes on: a bar on stderr, if that is a terminal.
struct Bar {
    bar: ProgressBar,
    time: Option<Duration>,
    inputs: AtomicU64,
}

impl Bar {
    fn new(name: &str, extent: Extent, visible: bool) -> Self {
        let target = if visible { ProgressDrawTarget::stderr_with_hz(10) } else { ProgressDrawTarget::hidden() };
        let (total, time, template) = match extent {
            Extent::Cases(cases) => (cases, None, "{prefix} {bar:24} {pos}/{len} {elapsed} {msg}"),
            Extent::Time(time) => (time.as_secs().max(1), Some(time), "{prefix} {bar:24} {elapsed}/{len}s {msg}"),
        };
        let bar = ProgressBar::with_draw_target(Some(total), target);
        if let Ok(style) = ProgressStyle::with_template(template) {
            bar.set_style(style);
        }
        bar.set_prefix(name.to_owned());
        Self { bar, time, inputs: AtomicU64::new(0) }
    }
}

impl Listener for Bar {
    fn asked(&self, inputs: u64) {
        let all = self.inputs.fetch_add(inputs, Ordering::Relaxed) + inputs;
        if self.time.is_some() {
            self.bar.set_position(self.bar.elapsed().as_secs());
            self.bar.set_message(format!("{all} inputs"));
        } else {
            self.bar.inc(inputs);
        }
    }

    fn found(&self, call: &str, what: &str) {
        let line = format!("found: {call}: {what}");
        if self.bar.is_hidden() { eprintln!("{line}") } else { self.bar.println(line) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_time_is_read_with_its_unit() {
        for (text, seconds) in [("60s", 60.0), ("90", 90.0), ("1.5m", 90.0), ("2h", 7200.0), ("250ms", 0.25)] {
            assert_eq!(duration(text), Ok(Duration::from_secs_f64(seconds)), "{text}");
        }
        for text in ["", "s", "-1s", "1d", "NaNs", "0s", "1000000h"] {
            assert!(duration(text).is_err(), "{text}");
        }
    }
}
