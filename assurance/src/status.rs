//! `cargo assure status` and `cargo assure refresh`: what is stale, and making just that anew.

use std::collections::BTreeMap;
use std::env;
use std::io;
use std::process::Command;

use clap::Args;
use serde::Serialize;
use thiserror::Error;
use xtask::project::Project;

use crate::artefact::{ARTEFACTS, Artefact, Freshness, OF_PROOFS};
use crate::console::Styles;
use crate::lock::{self, LockError, Standing};
use crate::proofs::{self, ProofsError};
use crate::trace::{self, TraceError};

#[derive(Debug, Args)]
pub(crate) struct StatusArgs {
    #[command(flatten)]
    which: Which,
    /// Print JSON: every artefact with its sources, its command and why it is stale
    #[arg(long)]
    json: bool,
}

#[derive(Debug, Args)]
pub(crate) struct RefreshArgs {
    #[command(flatten)]
    which: Which,
    /// Only say what would be run
    #[arg(long)]
    dry_run: bool,
}

/// The artefacts that are meant.
#[derive(Debug, Args)]
struct Which {
    /// Only these artefacts, or groups of them, such as `proofs` [default: all]
    #[arg(value_name = "NAME", value_parser = name)]
    names: Vec<String>,
    /// Only what is made in minutes, and neither changed kernels, changed specifications nor fuzzing
    #[arg(long)]
    quick: bool,
}

impl Which {
    fn artefacts(&self) -> impl Iterator<Item = &'static Artefact> {
        let is_named = |artefact: &Artefact| self.names.iter().any(|name| artefact.is_meant(name));
        let is_meant = move |artefact: &&Artefact| self.names.is_empty() || is_named(artefact);
        ARTEFACTS.iter().filter(is_meant).filter(|artefact| !(self.quick && artefact.nightly))
    }
}

/// Why the state cannot be told.
#[derive(Debug, Error)]
pub(crate) enum StatusError {
    #[error("the sources of {name}: {source}")]
    Digest { name: &'static str, source: io::Error },
    #[error(transparent)]
    Lock(#[from] LockError),
    #[error(transparent)]
    Proofs(#[from] ProofsError),
    #[error(transparent)]
    Trace(#[from] TraceError),
    #[error("cargo {command}: {why}")]
    Command { command: String, why: String },
}

/// What an artefact is, and why it is not fresh.
#[derive(Debug, Serialize)]
struct State {
    name: &'static str,
    makes: &'static [&'static str],
    sources: &'static [&'static str],
    command: String,
    fresh: bool,
    /// What changed since it was made.
    why: Vec<String>,
}

/// Says of every artefact whether it is fresh; `false` if one is not.
///
/// # Errors
/// The state of one cannot be told.
pub(crate) fn status(project: &Project, args: &StatusArgs) -> Result<bool, StatusError> {
    let mut eyes = Eyes::of(project);
    let states: Vec<State> = args.which.artefacts().map(|artefact| eyes.state(artefact)).collect::<Result<_, _>>()?;
    if args.json {
        println!("{:#}", serde_json::json!(states));
    } else {
        states.iter().for_each(|state| print(state, Styles::detect()));
    }
    Ok(states.iter().all(|state| state.fresh))
}

/// Makes what is stale anew, in order; `false` if a command finds something wrong.
///
/// # Errors
/// The state of an artefact cannot be told, or a command cannot be started.
pub(crate) fn refresh(project: &Project, args: &RefreshArgs) -> Result<bool, StatusError> {
    let mut eyes = Eyes::of(project);
    let mut ran: Vec<&[&str]> = Vec::new();
    for artefact in args.which.artefacts() {
        // What stands before it may have changed its sources.
        let state = eyes.state(artefact)?;
        if state.fresh || ran.contains(&artefact.command) {
            continue;
        }
        ran.push(artefact.command);
        println!("cargo {}  ({}: {})", state.command, state.name, state.why.join("; "));
        if args.dry_run {
            continue;
        }
        let failed =
            |source: io::Error| StatusError::Command { command: state.command.clone(), why: source.to_string() };
        if !program(project, artefact.command).and_then(|mut command| command.status()).map_err(failed)?.success() {
            return Ok(false);
        }
        eyes.forget();
    }
    println!("{}", if ran.is_empty() { "all is fresh" } else { "done" });
    Ok(true)
}

/// What was seen so far; what is generated is seen all at once.
struct Eyes<'p> {
    project: &'p Project,
    /// The lines that say which generated file is not as it would be generated.
    generated: Option<Vec<String>>,
}

impl<'p> Eyes<'p> {
    fn of(project: &'p Project) -> Self {
        Self { project, generated: None }
    }

    fn forget(&mut self) {
        self.generated = None;
    }

    fn state(&mut self, artefact: &'static Artefact) -> Result<State, StatusError> {
        let Artefact { name, makes, sources, freshness, command, .. } = artefact;
        let why = match freshness {
            Freshness::Generated => {
                let is_own = |line: &&String| makes.iter().any(|made| line.starts_with(made));
                self.generated()?.iter().filter(is_own).cloned().collect()
            }
            Freshness::Traced => trace::command::stale(&self.project.path(""))?,
            Freshness::Rendered => proofs::stale_page(&self.project.path(""))?,
            Freshness::Locked if name.starts_with(OF_PROOFS) => {
                // A lock says what somebody wrote there: it is held against what it has to say.
                [self.changed(artefact)?, proofs::wrong(&self.project.path(""), name)?].concat()
            }
            Freshness::Locked => self.changed(artefact)?,
        };
        Ok(State { name, makes, sources, command: command.join(" "), fresh: why.is_empty(), why })
    }

    fn generated(&mut self) -> Result<&[String], StatusError> {
        let lines = match self.generated.take() {
            Some(lines) => lines,
            None => {
                let failed = |why: String| StatusError::Command { command: "xtask generate --check".to_owned(), why };
                let output = program(self.project, &["xtask", "generate", "--check"])
                    .and_then(|mut check| check.output())
                    .map_err(|error| failed(error.to_string()))?;
                let printed = String::from_utf8_lossy(&output.stdout);
                let stale = printed.lines().filter(|line| !line.starts_with(' ') && line.contains(": is "));
                let stale: Vec<String> = stale.map(str::to_owned).collect();
                if !output.status.success() && stale.is_empty() {
                    return Err(failed(String::from_utf8_lossy(&output.stderr).into_owned()));
                }
                stale
            }
        };
        Ok(self.generated.insert(lines))
    }

    /// The sources that have another digest than when the artefact was made, and what was wrong then.
    fn changed(&self, artefact: &'static Artefact) -> Result<Vec<String>, StatusError> {
        let root = self.project.path("");
        let Some(Standing { sources, problems }) = lock::read(&root, artefact.name)? else {
            return Ok(vec!["it was never made".to_owned()]);
        };
        if sources.is_empty() {
            return Ok(vec!["nobody noted of which sources it was made".to_owned()]);
        }
        let now = artefact.digests(&root).map_err(|source| StatusError::Digest { name: artefact.name, source })?;
        Ok(differences(&sources, &now).into_iter().chain(problems).collect())
    }
}

/// How the digests of sources differ, a line each.
fn differences(was: &BTreeMap<String, String>, now: &BTreeMap<String, String>) -> Vec<String> {
    let gone = was.keys().filter(|source| !now.contains_key(*source)).map(|source| format!("{source} is gone"));
    let changed = now.iter().filter_map(|(source, digest)| match was.get(source) {
        Some(before) if before == digest => None,
        Some(before) => Some(format!("{source} has changed ({before}, now {digest})")),
        None => Some(format!("{source} is new")),
    });
    gone.chain(changed).collect()
}

/// What carries out a command of the table: cargo, or this very program.
fn program(project: &Project, command: &[&str]) -> io::Result<Command> {
    match command {
        ["assure", args @ ..] => Ok(project.program(env::current_exe()?, args, "")),
        _ => Ok(project.cargo(command)),
    }
}

fn name(name: &str) -> Result<String, String> {
    let known = || ARTEFACTS.iter().map(|artefact| artefact.name).collect::<Vec<_>>().join(", ");
    let is_known = ARTEFACTS.iter().any(|artefact| artefact.is_meant(name));
    if is_known { Ok(name.to_owned()) } else { Err(format!("one of {}", known())) }
}

fn print(state: &State, styles: Styles) {
    let State { name, command, fresh, why, .. } = state;
    if *fresh {
        println!("{}  {name}", styles.out.green("fresh"));
        return;
    }
    println!("{}  {name}: cargo {command}", styles.out.red("stale"));
    const SHOWN: usize = 3;
    why.iter().take(SHOWN).for_each(|line| println!("       {line}"));
    if why.len() > SHOWN {
        println!("       and {} more", why.len() - SHOWN);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lock::Lock;

    fn digests(of: &[(&str, &str)]) -> BTreeMap<String, String> {
        of.iter().map(|(source, digest)| ((*source).to_owned(), (*digest).to_owned())).collect()
    }

    #[test]
    fn it_says_which_source_changed_came_or_went() {
        let was = digests(&[("a", "1"), ("b", "2"), ("c", "3")]);
        let now = digests(&[("a", "1"), ("b", "4"), ("d", "5")]);
        assert_eq!(differences(&was, &now), ["c is gone", "b has changed (2, now 4)", "d is new"]);
        assert_eq!(differences(&was, &was), Vec::<String>::new());
    }

    #[test]
    fn a_change_of_one_source_makes_only_what_depends_on_it_stale() {
        let root = tempfile::tempdir().unwrap();
        let write = |file: &str, text: &str| {
            let path = root.path().join(file);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, text).unwrap();
        };
        write("spec/kernel/src/lib.rs", "//! The kernel.\n");
        write("spec/src/wire/messages.rs", "//! Messages.\n");
        for name in ["proofs-kernel", "proofs-model"] {
            let sources = Artefact::named(name).unwrap().digests(root.path()).unwrap();
            Lock { sources, ..Lock::default() }.write(root.path(), name).unwrap();
        }
        let project = Project::at(root.path());
        let why = |name: &str| Eyes::of(&project).changed(Artefact::named(name).unwrap()).unwrap();
        assert!(why("proofs-kernel").is_empty() && why("proofs-model").is_empty());
        assert_eq!(why("proofs-readers"), ["it was never made"]);
        write("spec/src/wire/messages.rs", "//! Messages, changed.\n");
        assert!(why("proofs-kernel").is_empty());
        assert!(why("proofs-model")[0].starts_with("spec/src/wire has changed"));
    }
    #[test]
    fn a_lock_with_the_right_digests_that_somebody_wrote_by_hand_is_stale() {
        let root = tempfile::tempdir().unwrap();
        std::fs::create_dir_all(root.path().join("defects")).unwrap();
        std::fs::write(root.path().join("defects/readers.toml"), "defect = []\n").unwrap();
        let artefact = Artefact::named("proofs-readers").unwrap();
        let mut lock = Lock { sources: artefact.digests(root.path()).unwrap(), ..Lock::default() };
        let project = Project::at(root.path());
        let why = |lock: &Lock| {
            lock.write(root.path(), artefact.name).unwrap();
            Eyes::of(&project).state(artefact).unwrap().why
        };
        assert_eq!(why(&lock), Vec::<String>::new());
        lock.counts.insert("readers-proved".to_owned(), 12);
        assert_eq!(why(&lock), ["the counts are not those of the entries"]);
        lock.counts.clear();
        lock.sources.insert("rustc".to_owned(), "1.0.0 elsewhere".to_owned());
        assert!(why(&lock)[0].starts_with("rustc has changed (1.0.0 elsewhere, now "));
    }
}
