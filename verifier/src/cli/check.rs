//! Checking peers: the bundled ones, or those that were named.

use std::collections::{BTreeSet, HashSet};
use std::fs::File;
use std::io::{self, IsTerminal as _, Write as _};
use std::path::{Path, PathBuf};
use std::time::{Instant, SystemTime};

use ncp_text::catalogue::{Level, Role};

use super::workspace::{Workspace, target};
use super::{CheckArgs, CliError, RunArgs, print};
use crate::conclude::{Checked, Extent, not_asked, roles, selected};
use crate::journal::{Head, Journal, Kept};
use crate::peer::{
    Call, Connection, Description, ExpectedFailure, ExpectedFailures, Launch, Manifest, StartError, handshake,
};
use crate::report::{
    Asked, CaseReport, Exit, PeerReport, Progress, Report, RunReport, State, Style, day_of, expected_list,
};
use crate::run::{self, Listener, RunRecord, Settings};
use crate::shard::Shard;
use crate::stop::Stop;
use crate::suite::{Case, Pattern, Suite};
use crate::verdict::{Baseline, Status};

/// Checks every bundled peer.
pub(super) fn bundled(suite: &Suite, args: &CheckArgs, styles: Styles, stop: &Stop) -> Result<Exit, CliError> {
    let here = current_dir()?;
    let workspace = Workspace::of_bundled_peers(&here, "run")?;
    let (target, started) = (workspace.target(), SystemTime::now());
    let sources = workspace
        .peers
        .iter()
        .map(|folder| {
            let shown = folder.strip_prefix(&workspace.root).unwrap_or(folder).display().to_string();
            Source::folder(folder, shown, &workspace.root, &target, Vec::new(), (suite, started))
        })
        .collect::<Result<_, _>>()?;
    check(suite, sources, args, None, styles, &workspace.root, (started, stop))
}

/// Checks the peers that were named.
pub(super) fn named(suite: &Suite, args: &RunArgs, styles: Styles, stop: &Stop) -> Result<Exit, CliError> {
    let named = args.peer.len() + args.peer_cmd.len() + args.connect.len();
    if named == 0 {
        return Err(CliError::Usage(
            "name a peer: --peer with a folder that has a peer.toml, --peer-cmd with a command, or --connect with an \
             address"
                .to_owned(),
        ));
    }
    if (args.expected.is_some() || args.write_expected.is_some()) && named > 1 {
        return Err(CliError::Usage("a list of expected failures is that of one peer: name only one".to_owned()));
    }
    let listed = match &args.expected {
        Some(file) => ExpectedFailures::load(file)?.entries,
        None => Vec::new(),
    };
    let (here, started) = (current_dir()?, SystemTime::now());
    let mut sources = Vec::new();
    for folder in &args.peer {
        let absolute = std::path::absolute(folder).unwrap_or_else(|_| folder.clone());
        let root = Workspace::above(&absolute).map_or_else(|| absolute.clone(), |workspace| workspace.root);
        sources.push(Source::folder(
            &absolute,
            folder.display().to_string(),
            &root,
            &target(&root),
            listed.clone(),
            (suite, started),
        )?);
    }
    let commands = args.peer_cmd.iter().map(|line| Ok((line.clone(), Launch::from_command_line(line, &here)?)));
    let addresses = args.connect.iter().map(|address| Ok((address.to_string(), Launch::connect(address.clone()))));
    for named in commands.chain(addresses) {
        let (shown, launch) = named.map_err(CliError::Start)?;
        let baseline = baseline(&shown, listed.clone(), (suite, started))?;
        sources.push(Source { name: None, shown, launch, manifest: None, baseline, entries: listed.clone() });
    }
    let root = Workspace::above(&here).map_or(here, |workspace| workspace.root);
    check(suite, sources, &args.check, args.write_expected.as_deref(), styles, &root, (started, stop))
}

/// The expected failures of a peer, on the day on which the run begins.
fn baseline(
    peer: &str,
    entries: Vec<ExpectedFailure>,
    (suite, started): (&Suite, SystemTime),
) -> Result<Baseline, CliError> {
    Baseline::new(entries, suite, &day_of(started))
        .map_err(|source| CliError::Baseline { peer: peer.to_owned(), source })
}

/// How to write to stdout and to stderr.
#[derive(Clone, Copy)]
pub(super) struct Styles {
    pub(super) out: Style,
    pub(super) error: Style,
}

/// A peer that is to be checked.
struct Source {
    name: Option<String>,
    shown: String,
    launch: Launch,
    manifest: Option<Manifest>,
    entries: Vec<ExpectedFailure>,
    baseline: Baseline,
}

impl Source {
    fn folder(
        folder: &Path,
        shown: String,
        root: &Path,
        target: &Path,
        listed: Vec<ExpectedFailure>,
        judged_by: (&Suite, SystemTime),
    ) -> Result<Self, CliError> {
        let manifest = Manifest::load(folder, root, target)?;
        let entries: Vec<_> = manifest.expected_failures.iter().cloned().chain(listed).collect();
        let baseline = baseline(&manifest.name, entries.clone(), judged_by)?;
        let (name, launch) = (Some(manifest.name.clone()), manifest.launch.clone());
        Ok(Self { name, shown, launch, manifest: Some(manifest), entries, baseline })
    }

    fn name(&self) -> &str {
        self.name.as_deref().unwrap_or(&self.shown)
    }

    /// The level that the peer claims in its `peer.toml`: the first one, if it does not say.
    fn claimed(&self) -> Level {
        self.manifest.as_ref().map_or(Level::Wire, |manifest| manifest.level)
    }
}

/// What one invocation checks by.
struct Check<'c> {
    suite: &'c Suite,
    patterns: Vec<Pattern>,
    roles: &'c [Role],
    /// The level that was asked for; none: each peer is held to the one that it claims.
    level: Option<Level>,
    shard: Option<Shard>,
    rerun: Option<&'c Rerun>,
    settings: Settings,
    journal: Option<&'c Journal>,
    visible: bool,
    error_style: Style,
    stop: &'c Stop,
}

/// The cases that failed in an earlier result, by peer.
struct Rerun {
    file: PathBuf,
    peers: Vec<(String, HashSet<String>)>,
}

impl Rerun {
    fn read(file: &Path) -> Result<Self, CliError> {
        let failed = |case: &&CaseReport| matches!(case.status, Status::Failed | Status::NotRun);
        let peer = |peer: PeerReport| {
            let failed = peer.cases.iter().filter(failed).map(|case| case.id.clone()).collect();
            (peer.name, failed)
        };
        let peers: Vec<_> = Report::read(file)?.peers.into_iter().map(peer).collect();
        if peers.iter().all(|(_, failed): &(_, HashSet<String>)| failed.is_empty()) {
            return Err(CliError::Usage(format!(
                "nothing failed in {}: there is nothing to run again",
                file.display()
            )));
        }
        Ok(Self { file: file.to_owned(), peers })
    }

    /// Which cases of a peer failed. A peer that is the only one of the result is meant, whatever its name.
    fn of(&self, name: &str) -> Result<&HashSet<String>, CliError> {
        let alone = self.peers.first().filter(|_| self.peers.len() == 1);
        let found = self.peers.iter().find(|(of, _)| of == name).or(alone);
        let none = || CliError::Usage(format!("{} has no peer {name}", self.file.display()));
        found.map(|(_, failed)| failed).ok_or_else(none)
    }
}

fn check(
    suite: &Suite,
    sources: Vec<Source>,
    args: &CheckArgs,
    write_expected: Option<&Path>,
    styles: Styles,
    root: &Path,
    (started, stop): (SystemTime, &Stop),
) -> Result<Exit, CliError> {
    let clock = Instant::now();
    let mut selection = args.select.selection();
    // A peer is held to what it claims; who filters has said which cases are meant.
    let default = (!selection.patterns.is_empty()).then(|| suite.highest_level());
    let asked_level = args.select.level.or(default);
    let level = asked_level.or_else(|| sources.iter().map(Source::claimed).max()).unwrap_or(Level::Wire);
    if level > suite.highest_level() {
        let highest = suite.highest_level();
        return Err(CliError::Usage(format!("there is no case of level {level} yet; the highest is {highest}")));
    }
    if let Some(single) = sources.iter().find(|source| args.jobs > 1 && source.launch.is_single()) {
        return Err(CliError::Usage(one_at_a_time(single.name())));
    }
    if args.resume && args.repeat > 1 {
        return Err(CliError::Usage("--resume goes on with a run that asks every case once, not --repeat".to_owned()));
    }
    let rerun = args.rerun_failed.as_deref().map(Rerun::read).transpose()?;
    let partial = !selection.patterns.is_empty() || rerun.is_some() || args.shard.is_some();
    selection.level = Some(level);
    let selected = || suite.cases().iter().filter(|case| selection.meets(case));
    let files: HashSet<&str> = selected().map(|case| &*case.file).collect();
    if files.is_empty() {
        return Err(CliError::Usage(nothing_selected(args)));
    }
    let asked = Asked {
        level,
        roles: args.select.role.clone(),
        filters: args.select.filter.clone(),
        files: files.len(),
        cases: selected().count(),
        repeat: args.repeat,
        partial,
        shard: args.shard,
        rerun: rerun.is_some(),
        deep: selected().filter(|case| case.is_deep()).count(),
    };
    let result = args.output.result(root);
    let (journal, kept) = journal(suite, &sources, &asked, rerun.as_ref(), args, &result)?;
    let check = Check {
        suite,
        patterns: selection.patterns,
        roles: &args.select.role,
        level: asked_level,
        shard: args.shard,
        rerun: rerun.as_ref(),
        settings: Settings {
            jobs: usize::from(args.jobs),
            timeout: args.timeout,
            start_timeout: args.start_timeout,
            max_restarts: args.max_restarts,
            repeat: args.repeat,
        },
        journal: journal.as_ref(),
        visible: std::io::stderr().is_terminal(),
        error_style: styles.error,
        stop,
    };
    let mut report = Report::new(suite, asked, started);
    for ((place, mut source), kept) in sources.into_iter().enumerate().zip(kept) {
        source.launch = source.launch.with_patience(args.start_timeout);
        report.peers.extend(check.peer(place, source, &kept)?);
    }
    let exit = report.close(clock.elapsed(), stop.is_set());
    // When none could be started, all there is to say has been said.
    let silent = report.peers.iter().all(|peer| peer.state == State::NotStarted);
    args.output.write(&report, suite, styles.out, &result, silent)?;
    if let (Some(file), Some(peer)) = (write_expected, report.peers.first().filter(|_| !silent)) {
        let list = expected_list(peer);
        let list = list.map_err(|error| CliError::Harness(format!("the expected failures: {error}")))?;
        write(file, &list)?;
        print(&format!("{}\n", styles.out.dim(&format!("expected failures: {}", file.display()))))?;
    }
    // The journal of a run that was interrupted is taken up by --resume.
    if let Some(journal) = journal.filter(|_| !stop.is_set()) {
        journal.remove();
    }
    Ok(exit)
}

/// The journal of a run, and what it holds of each peer if the run goes on with it. Who repeats every case measures,
/// and has none.
fn journal(
    suite: &Suite,
    sources: &[Source],
    asked: &Asked,
    rerun: Option<&Rerun>,
    args: &CheckArgs,
    result: &Path,
) -> Result<(Option<Journal>, Vec<Kept>), CliError> {
    let nothing = || vec![Kept::default(); sources.len()];
    if args.repeat > 1 {
        return Ok((None, nothing()));
    }
    let only = rerun.map_or_else(Vec::new, |rerun| {
        let sorted = |failed: &HashSet<String>| failed.iter().cloned().collect::<BTreeSet<_>>();
        rerun.peers.iter().map(|(name, failed)| (name.clone(), sorted(failed))).collect()
    });
    let head = Head {
        corpus: suite.digest(),
        asked,
        peers: sources.iter().map(|source| source.shown.as_str()).collect(),
        only,
    };
    let path = Journal::beside(result);
    if args.resume {
        let (journal, kept) = Journal::resume(&path, &head)?;
        return Ok((Some(journal), kept));
    }
    Ok((Some(Journal::begin(&path, &head)?), nothing()))
}

impl Check<'_> {
    /// Checks one peer, from its set-up to its verdict, but for the cases that are kept. None: nothing is to be run
    /// again of it.
    fn peer(&self, place: usize, source: Source, kept: &Kept) -> Result<Option<PeerReport>, CliError> {
        let name = source.name().to_owned();
        let unchecked =
            |state, reason| Ok(Some(PeerReport::unchecked(name.clone(), source.shown.clone(), state, reason)));
        if self.stop.is_set() {
            return unchecked(State::NotStarted, "the run was interrupted".to_owned());
        }
        if let Some(manifest) = &source.manifest {
            let missing = manifest.missing_tools();
            if !missing.is_empty() {
                let reason = format!("not on PATH: {}", missing.join(", "));
                eprintln!("{name}: SKIPPED, {reason}");
                return unchecked(State::Skipped, reason);
            }
        }
        let (connection, description) = match self.start(&source) {
            Ok(started) => started,
            Err(error) => {
                let of = source.name.as_ref().map_or(String::new(), |name| format!("{name}: "));
                eprintln!("{} {of}{error}", self.error_style.red("error:"));
                return unchecked(State::NotStarted, error.to_string());
            }
        };
        let name = source.name.clone().unwrap_or_else(|| description.name.clone());
        if kept.description.as_ref().is_some_and(|before| *before != description) {
            let other =
                "describes itself otherwise than in the run that is resumed; without --resume a run begins anew";
            return Err(CliError::Usage(format!("{name} {other}")));
        }
        let failed = self.rerun.map(|rerun| rerun.of(&name)).transpose()?;
        if failed.is_some_and(HashSet::is_empty) {
            eprintln!("{name}: nothing of it failed, and nothing is run again");
            return Ok(None);
        }
        let roles = roles(self.roles, &description);
        let level = self.level.unwrap_or_else(|| source.claimed());
        let (mut cases, mut kept_back) = selected(self.suite, &roles, level, &self.patterns, &description);
        if let Some(failed) = failed {
            cases.retain(|case| failed.contains(&case.id));
            kept_back.clear();
        }
        let mut not_asked = not_asked(&kept_back);
        if cases.is_empty() && !roles.is_empty() {
            let claimed: Vec<&str> = roles.iter().map(|(role, _)| role.as_str()).collect();
            let mut message = format!("no case is selected for the roles of {name}: {}", claimed.join(", "));
            for not_asked in &not_asked {
                message.push_str(&format!("; {}", not_asked.in_words()));
            }
            return Err(CliError::Usage(message));
        }
        if let Some(shard) = self.shard {
            cases = shard.pick(&cases);
            // What no shard asks is told by the first.
            not_asked.retain(|_| shard.index == 1);
        }
        let record = self.run(place, &source, &name, connection, &description, &cases, kept);
        let checked = Checked {
            name,
            source: source.shown,
            description,
            level,
            asked: self.roles,
            entries: &source.entries,
            baseline: &source.baseline,
            extent: match (self.shard, self.rerun) {
                (Some(_), _) => Extent::Shard,
                (None, None) if self.patterns.is_empty() => Extent::Whole,
                (None, _) => Extent::Picked,
            },
            cases: cases.into_iter().zip(record.cases.iter().cloned()).collect(),
            run: RunReport::from(&record),
            opened: record.opened,
            not_asked,
        };
        Ok(Some(checked.conclude(self.suite)))
    }

    /// Runs the cases of a peer but for those that are kept, and puts these with the others.
    #[expect(clippy::too_many_arguments, reason = "one call, of what the caller has just found out")]
    fn run(
        &self,
        place: usize,
        source: &Source,
        name: &str,
        connection: Connection,
        description: &Description,
        cases: &[&Case],
        kept: &Kept,
    ) -> RunRecord {
        let open: Vec<&Case> = cases.iter().copied().filter(|case| !kept.cases.contains_key(&case.id)).collect();
        let repeat = u64::from(self.settings.repeat);
        let total = open.iter().map(|case| if case.is_large() { 1 } else { repeat }).sum();
        let progress = Progress::new(name, total, self.visible);
        let recorder = self.journal.map(|journal| journal.record(place, description, &progress));
        let listener: &dyn Listener = recorder.as_ref().map_or(&progress, |recorder| recorder);
        let mut record = run::run(&source.launch, connection, &open, &self.settings, listener, self.stop);
        progress.done();
        if open.len() == cases.len() {
            return record;
        }
        let mut fresh = record.cases.into_iter();
        let known = |case: &&Case| kept.cases.get(&case.id).cloned().or_else(|| fresh.next());
        record.cases = cases.iter().filter_map(known).collect();
        let kept_runs = || cases.iter().filter_map(|case| kept.cases.get(&case.id));
        let faults = kept_runs().filter(|run| run.outcome.kind().is_fault()).count();
        record.answers += (kept_runs().count() - faults) as u64;
        record.faults += u32::try_from(faults).unwrap_or(u32::MAX);
        // Not all was answered in this run.
        record.rate = None;
        let is_asked = cases.iter().any(|case| case.call == Call::SessionRun);
        record.opened = is_asked.then(|| kept.opened || record.opened == Some(true));
        record
    }

    /// Sets a peer up, starts it, and lets it describe itself.
    fn start(&self, source: &Source) -> Result<(Connection, Description), StartError> {
        for step in source.manifest.iter().flat_map(|manifest| &manifest.setup) {
            let said = Progress::spinner(format!("{}: {}", source.name(), step.say), self.visible);
            let result = step.run(self.stop);
            said.done();
            result?;
        }
        let mut connection = Connection::open(&source.launch)?;
        let description = handshake(&mut connection, self.settings.start_timeout, self.stop)?;
        Ok((connection, description))
    }
}

/// Why a peer has no use for several jobs.
pub(super) fn one_at_a_time(peer: &str) -> String {
    format!("{peer} has a fixed port, so that there can be one of it: --jobs 1, or {{port}} in its peer.toml")
}

fn nothing_selected(args: &CheckArgs) -> String {
    let mut parts: Vec<String> = args.select.filter.iter().map(|filter| format!("--filter {filter}")).collect();
    parts.extend(args.select.role.iter().map(|role| format!("--role {role}")));
    parts.extend(args.select.level.map(|level| format!("--level {level}")));
    format!("no case fits {}; see ncp-verify list", parts.join(" "))
}

pub(super) fn current_dir() -> Result<PathBuf, CliError> {
    std::env::current_dir().map_err(|error| CliError::Harness(format!("the current folder is not known: {error}")))
}

pub(super) fn write(file: &Path, text: &str) -> Result<(), CliError> {
    write_by(file, |mut file| file.write_all(text.as_bytes()))
}

/// Writes a file, and the folder that it lies in.
pub(super) fn write_by(file: &Path, write: impl FnOnce(&File) -> io::Result<()>) -> Result<(), CliError> {
    let folder = file.parent().filter(|folder| !folder.as_os_str().is_empty());
    folder
        .map_or(Ok(()), std::fs::create_dir_all)
        .and_then(|()| write(&File::create(file)?))
        .map_err(|error| CliError::Harness(format!("{} cannot be written: {error}", file.display())))
}
