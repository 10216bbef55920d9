//! Checking peers: the bundled ones, or those that were named.

use std::collections::HashSet;
use std::io::IsTerminal as _;
use std::path::{Path, PathBuf};
use std::time::{Instant, SystemTime};

use ncp_text::catalogue::{Level, Role};

use super::workspace::{Workspace, target};
use super::{CheckArgs, CliError, RunArgs, print};
use crate::dictionary::Dictionary;
use crate::peer::{
    Connection, Description, ExpectedFailure, ExpectedFailures, Launch, Manifest, StartError, handshake,
};
use crate::report::{
    Asked, Detail, Exit, NotAsked, PeerReport, Progress, Report, State, Style, expected_list, junit, terminal, today,
};
use crate::run::{self, CaseRun, Settings};
use crate::stop::Stop;
use crate::suite::{Case, Need, Pattern, Suite};
use crate::verdict::{Baseline, judge, judge_description};

/// Where the result goes, from the workspace's root.
const RESULT: &str = "reports/run/result.json";

/// Checks every bundled peer.
pub(super) fn bundled(suite: &Suite, args: &CheckArgs, styles: Styles, stop: &Stop) -> Result<Exit, CliError> {
    let here = current_dir()?;
    let Some(workspace) = Workspace::find(&here) else {
        return Err(CliError::Usage(
            "there is no folder with peers/*/peer.toml at or above this one; name a peer: ncp-verify run --peer-cmd '…'"
                .to_owned(),
        ));
    };
    let target = workspace.target();
    let sources = workspace
        .peers
        .iter()
        .map(|folder| {
            let shown = folder.strip_prefix(&workspace.root).unwrap_or(folder).display().to_string();
            Source::folder(folder, shown, &workspace.root, &target, Vec::new(), suite)
        })
        .collect::<Result<_, _>>()?;
    check(suite, sources, args, None, styles, &workspace.root, stop)
}

/// Checks the peers that were named.
pub(super) fn named(suite: &Suite, args: &RunArgs, styles: Styles, stop: &Stop) -> Result<Exit, CliError> {
    if args.peer.is_empty() && args.peer_cmd.is_empty() {
        return Err(CliError::Usage(
            "name a peer: --peer with a folder that has a peer.toml, or --peer-cmd with a command".to_owned(),
        ));
    }
    if (args.expected.is_some() || args.write_expected.is_some()) && args.peer.len() + args.peer_cmd.len() > 1 {
        return Err(CliError::Usage("a list of expected failures is that of one peer: name only one".to_owned()));
    }
    let listed = match &args.expected {
        Some(file) => ExpectedFailures::load(file)?.entries,
        None => Vec::new(),
    };
    let here = current_dir()?;
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
            suite,
        )?);
    }
    for command in &args.peer_cmd {
        sources.push(Source {
            name: None,
            shown: command.clone(),
            launch: Launch::from_command_line(command, &here)?,
            manifest: None,
            baseline: baseline(command, listed.clone(), suite)?,
        });
    }
    let root = Workspace::above(&here).map_or(here, |workspace| workspace.root);
    check(suite, sources, &args.check, args.write_expected.as_deref(), styles, &root, stop)
}

/// The expected failures of a peer.
fn baseline(peer: &str, entries: Vec<ExpectedFailure>, suite: &Suite) -> Result<Baseline, CliError> {
    Baseline::new(entries, suite, &today()).map_err(|source| CliError::Baseline { peer: peer.to_owned(), source })
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
    baseline: Baseline,
}

impl Source {
    fn folder(
        folder: &Path,
        shown: String,
        root: &Path,
        target: &Path,
        listed: Vec<ExpectedFailure>,
        suite: &Suite,
    ) -> Result<Self, CliError> {
        let manifest = Manifest::load(folder, root, target)?;
        let entries = manifest.expected_failures.iter().cloned().chain(listed).collect();
        let baseline = baseline(&manifest.name, entries, suite)?;
        let (name, launch) = (Some(manifest.name.clone()), manifest.launch.clone());
        Ok(Self { name, shown, launch, manifest: Some(manifest), baseline })
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
    settings: Settings,
    visible: bool,
    error_style: Style,
    stop: &'c Stop,
}

fn check(
    suite: &Suite,
    sources: Vec<Source>,
    args: &CheckArgs,
    write_expected: Option<&Path>,
    styles: Styles,
    root: &Path,
    stop: &Stop,
) -> Result<Exit, CliError> {
    let (started, clock) = (SystemTime::now(), Instant::now());
    let mut selection = args.select.selection();
    // A peer is held to what it claims; who filters has said which cases are meant.
    let default = (!selection.patterns.is_empty()).then(|| suite.highest_level());
    let asked_level = args.select.level.or(default);
    let level = asked_level.or_else(|| sources.iter().map(Source::claimed).max()).unwrap_or(Level::Wire);
    if level > suite.highest_level() {
        let highest = suite.highest_level();
        return Err(CliError::Usage(format!("there is no case of level {level} yet; the highest is {highest}")));
    }
    let partial = !selection.patterns.is_empty();
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
    };
    let check = Check {
        suite,
        patterns: selection.patterns,
        roles: &args.select.role,
        level: asked_level,
        settings: Settings {
            jobs: usize::from(args.jobs),
            timeout: args.timeout,
            start_timeout: args.start_timeout,
            max_restarts: args.max_restarts,
            repeat: args.repeat,
        },
        visible: std::io::stderr().is_terminal(),
        error_style: styles.error,
        stop,
    };
    let mut report = Report::new(suite, asked, started);
    for source in sources {
        report.peers.push(check.peer(source)?);
    }
    let exit = report.close(clock.elapsed(), stop.is_set());
    // When none could be started, all there is to say has been said.
    let silent = report.peers.iter().all(|peer| peer.state == State::NotStarted);
    if !silent {
        let examples = args.examples.unwrap_or(Detail::NORMAL.examples);
        let detail = if args.verbose { Detail::VERBOSE } else { Detail { examples, ..Detail::NORMAL } };
        print(&terminal(&report, styles.out, detail))?;
    }
    let json = report.to_json().map_err(|error| CliError::Harness(format!("the result cannot be written: {error}")))?;
    let file = args.json.clone().unwrap_or_else(|| root.join(RESULT));
    write(&file, &json)?;
    let shown = args.json.as_ref().map_or(RESULT.to_owned(), |file| file.display().to_string());
    if !silent {
        print(&format!("{}\n", styles.out.dim(&format!("result: {shown}"))))?;
    }
    if let (Some(file), Some(peer)) = (write_expected, report.peers.first().filter(|_| !silent)) {
        let list = expected_list(peer);
        let list = list.map_err(|error| CliError::Harness(format!("the expected failures: {error}")))?;
        write(file, &list)?;
        print(&format!("{}\n", styles.out.dim(&format!("expected failures: {}", file.display()))))?;
    }
    if let Some(file) = &args.junit {
        let xml =
            junit(&report).map_err(|error| CliError::Harness(format!("the JUnit file cannot be written: {error}")))?;
        write(file, &xml)?;
    }
    Ok(exit)
}

impl Check<'_> {
    /// Checks one peer, from its set-up to its verdict.
    fn peer(&self, source: Source) -> Result<PeerReport, CliError> {
        let name = source.name().to_owned();
        let unchecked = |state, reason| Ok(PeerReport::unchecked(name.clone(), source.shown.clone(), state, reason));
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
        let mut roles = self.roles(&description);
        let level = self.level.unwrap_or_else(|| source.claimed());
        let (cases, kept) = self.cases(&roles, level, &description);
        let not_asked = not_asked(&kept);
        // That a peer describes itself rightly is no evidence for a role of which nothing is known.
        let claimed: Vec<&str> = roles.iter().map(|(role, _)| role.as_str()).collect();
        if cases.is_empty() && !roles.is_empty() {
            let mut message = format!("no case is selected for the roles of {name}: {}", claimed.join(", "));
            for (_, why) in &not_asked {
                message.push_str(&format!("; {why}"));
            }
            return Err(CliError::Usage(message));
        }
        roles.retain(|(role, _)| cases.iter().any(|case| case.roles.contains(role)));
        let repeat = u64::from(self.settings.repeat);
        let total = cases.iter().map(|case| if case.is_large() { 1 } else { repeat }).sum();
        let progress = Progress::new(&name, total, self.visible);
        let mut record = run::run(&source.launch, connection, &cases, &self.settings, &progress, self.stop);
        progress.done();
        record.notes.extend(not_asked.iter().map(|(_, why)| why.clone()));
        if record.opened == Some(false) && self.patterns.is_empty() && record.given_up.is_none() {
            record.notes.push(NO_SESSION.to_owned());
        }
        let describe = (self.suite.describe(&description), judge_description(&description));
        let runs = cases.into_iter().zip(record.cases.iter().cloned());
        let all: Vec<(&Case, CaseRun)> = std::iter::once(describe).chain(runs).collect();
        let verdict = judge(all, &roles, level, &source.baseline, !self.patterns.is_empty());
        let not_asked = not_asked.into_iter().map(|(count, _)| count).collect();
        let mut report = PeerReport::checked(name, source.shown, &description, &verdict, &record, not_asked);
        report.diagnose(Dictionary::embedded(), &verdict);
        Ok(report)
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

    /// The roles to judge: those that were asked for, or else all that the peer claims.
    fn roles(&self, description: &Description) -> Vec<(Role, bool)> {
        let claimed = |role: Role| description.roles.iter().any(|name| name == role.as_str());
        Role::ALL
            .into_iter()
            .filter(|role| if self.roles.is_empty() { claimed(*role) } else { self.roles.contains(role) })
            .map(|role| (role, claimed(role)))
            .collect()
    }

    /// The cases to ask, and those that need what the peer does not claim.
    fn cases(&self, roles: &[(Role, bool)], level: Level, description: &Description) -> (Vec<&Case>, Vec<&Case>) {
        let roles: Vec<Role> = roles.iter().map(|(role, _)| *role).collect();
        let meant = |case: &&Case| {
            case.concerns(&roles)
                && case.level <= level
                && (self.patterns.is_empty() || self.patterns.iter().any(|pattern| pattern.fits(case)))
        };
        let has = |need: &Need| match need {
            Need::ReferenceNetworks => description.reference_networks,
        };
        let cases = self.suite.cases().iter().filter(meant);
        cases.partition(|case| case.needs.iter().all(has))
    }
}

/// What is said of a peer that was asked of sessions, and never opened one.
const NO_SESSION: &str =
    "no session was opened in the whole run: the cases about open sessions show nothing about this server";

/// How many cases were kept from a peer for want of what they need, and that in words.
fn not_asked(kept: &[&Case]) -> Vec<(NotAsked, String)> {
    let counted = Need::ALL.into_iter().map(|need| {
        let cases = kept.iter().filter(|case| case.needs.contains(&need));
        (need, cases.count())
    });
    counted
        .filter(|(_, cases)| *cases > 0)
        .map(|(need, cases)| {
            let (were, need_it) = if cases == 1 { ("case was", "it needs") } else { ("cases were", "they need") };
            let count = NotAsked { needs: need.as_str(), cases };
            let why = format!(
                "{cases} {were} not asked: {need_it} {}, which the peer's `describe` does not claim (`{}`)",
                need.in_words(),
                need.as_str()
            );
            (count, why)
        })
        .collect()
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
    let folder = file.parent().filter(|folder| !folder.as_os_str().is_empty());
    folder
        .map_or(Ok(()), std::fs::create_dir_all)
        .and_then(|()| std::fs::write(file, text))
        .map_err(|error| CliError::Harness(format!("{} cannot be written: {error}", file.display())))
}
