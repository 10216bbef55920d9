//! Programs: each ends when the gate is told to, and leaves what it printed where it can be read.

use std::fs::{self, File};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use super::GateError;
use crate::stop::Stop;

/// Where what programs printed can be read afterwards, from the root of a tree.
const LOGS: &str = ".tools/logs";
/// The buf CLI as the project installs it.
const BUF: &str = if cfg!(windows) { ".tools/venv/Scripts/buf.exe" } else { ".tools/venv/bin/buf" };
/// How often a program is looked after.
const GLANCE: Duration = Duration::from_millis(20);
/// How long a program that was asked to end may take to.
const GRACE: Duration = Duration::from_secs(10);

/// A folder for what is needed while a gate is asked; it goes with the value.
#[derive(Debug)]
pub(super) struct Scratch(PathBuf);

impl Scratch {
    /// Makes one, within the tree's folder that git ignores.
    pub(super) fn make(root: &Path) -> Result<Self, GateError> {
        let path = root.join(".tools/gate").join(std::process::id().to_string());
        fs::create_dir_all(&path).map_err(|source| GateError::File { path: path.clone(), source })?;
        Ok(Self(path))
    }

    /// A path in it.
    pub(super) fn path(&self, relative: &str) -> PathBuf {
        self.0.join(relative)
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        // What is left of it does no harm.
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// Starts programs in a tree.
#[derive(Debug)]
pub(super) struct Tools<'t> {
    root: &'t Path,
    scratch: &'t Scratch,
    stop: &'t Stop,
    /// This very program, where it was when the gate was asked.
    own: io::Result<PathBuf>,
}

/// How a program ended.
#[derive(Debug)]
pub(super) struct Ended {
    /// As somebody would type it.
    pub(super) shown: String,
    /// Its exit code, unless a signal ended it.
    pub(super) code: Option<i32>,
    /// What it printed.
    pub(super) stdout: String,
    /// What it printed of errors.
    pub(super) stderr: String,
}

/// Why a program did not end by itself.
#[derive(Debug, thiserror::Error)]
pub(super) enum ToolError {
    /// It is not there.
    #[error("{0} is not installed")]
    Missing(String),
    /// It cannot be started.
    #[error("{program}: {source}")]
    Start { program: String, source: io::Error },
    /// Everything is to end.
    #[error("interrupted")]
    Interrupted,
}

impl<'t> Tools<'t> {
    pub(super) fn new(root: &'t Path, scratch: &'t Scratch, stop: &'t Stop) -> Self {
        Self { root, scratch, stop, own: std::env::current_exe() }
    }

    /// The folder for what is needed meanwhile.
    pub(super) fn scratch(&self) -> &Scratch {
        self.scratch
    }

    /// This program, in the root of the tree.
    pub(super) fn itself(&self, args: &[&str]) -> Result<Command, ToolError> {
        let failed = |error: &io::Error| ToolError::Missing(format!("this program, by its path ({error}),"));
        self.own.as_ref().map(|own| self.program(own, args, "")).map_err(failed)
    }

    /// cargo, in the root of the tree.
    pub(super) fn cargo(&self, args: &[&str]) -> Command {
        let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        self.program(Path::new(&cargo), args, "")
    }

    /// git, in the root of the tree.
    pub(super) fn git(&self, args: &[&str]) -> Command {
        self.program(Path::new("git"), args, "")
    }

    /// buf, in a folder of the tree: the one that `NCP_BUF` names, the one that the project installs, or that on the
    /// path.
    pub(super) fn buf(&self, args: &[&str], folder: &str) -> Command {
        let named = std::env::var_os("NCP_BUF").filter(|path| !path.is_empty()).map(PathBuf::from);
        let own = || Some(self.root.join(BUF)).filter(|own| own.is_file());
        let buf = named.or_else(own).unwrap_or_else(|| "buf".into());
        self.program(&buf, args, folder)
    }

    /// A program in a folder of the tree.
    pub(super) fn program(&self, program: &Path, args: &[&str], folder: &str) -> Command {
        let mut command = Command::new(program);
        command.args(args).current_dir(self.root.join(folder)).env("NO_COLOR", "1").env("CARGO_TERM_COLOR", "never");
        // What a line says is told apart by its end.
        command.env("COLUMNS", "1000");
        command
    }

    /// Runs a program to its end. What it prints stays in a log of this name.
    pub(super) fn run(&self, mut command: Command, log: &str) -> Result<Ended, ToolError> {
        let shown = shown(&command);
        let program = Path::new(command.get_program()).file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let started = |source: io::Error| match source.kind() {
            ErrorKind::NotFound => ToolError::Missing(program.clone()),
            _ => ToolError::Start { program: program.clone(), source },
        };
        let logs = self.root.join(LOGS);
        let file = |end: &str| logs.join(format!("gate-{log}.{end}"));
        let open = |end: &str| fs::create_dir_all(&logs).and_then(|()| File::create(file(end)));
        let unusable = |source| ToolError::Start { program: LOGS.to_owned(), source };
        let (out, err) = (open("out").map_err(unusable)?, open("err").map_err(unusable)?);
        if self.stop.is_set() {
            return Err(ToolError::Interrupted);
        }
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        let child = command.stdin(Stdio::null()).stdout(out).stderr(err).spawn().map_err(started)?;
        let status = self.wait(child)?;
        let said = |end: &str| fs::read(file(end)).map(|text| String::from_utf8_lossy(&text).into_owned());
        let (stdout, stderr) = (said("out").unwrap_or_default(), said("err").unwrap_or_default());
        Ok(Ended { shown, code: status.code(), stdout, stderr })
    }

    /// Runs git; what it prints, if it succeeds.
    pub(super) fn asks_git(&self, args: &[&str]) -> Option<String> {
        let ended = self.run(self.git(args), "git").ok()?;
        (ended.code == Some(0)).then(|| ended.stdout.trim().to_owned())
    }

    fn wait(&self, mut child: Child) -> Result<ExitStatus, ToolError> {
        let failed = |source| ToolError::Start { program: "wait".to_owned(), source };
        let mut asked_to_end: Option<Instant> = None;
        loop {
            if let Some(status) = child.try_wait().map_err(failed)? {
                return if asked_to_end.is_some() { Err(ToolError::Interrupted) } else { Ok(status) };
            }
            match asked_to_end {
                None if self.stop.is_set() => {
                    end(&mut child, false);
                    asked_to_end = Some(Instant::now());
                }
                Some(since) if since.elapsed() > GRACE => end(&mut child, true),
                _ => {}
            }
            thread::sleep(GLANCE);
        }
    }
}

impl Ended {
    /// The end of what it said, when it did not do what it is for.
    pub(super) fn last_words(&self) -> String {
        const LINES: usize = 12;
        let words = if self.stderr.trim().is_empty() { &self.stdout } else { &self.stderr };
        let lines: Vec<&str> = words.lines().filter(|line| !line.trim().is_empty()).collect();
        let tail = lines[lines.len().saturating_sub(LINES)..].join("\n");
        let how = self.code.map_or_else(|| "by a signal".to_owned(), |code| format!("with exit code {code}"));
        format!("{} ended {how}\n{tail}", self.shown)
    }
}

/// Asks a program, and all that it has started, to end; or ends it.
#[cfg(unix)]
fn end(child: &mut Child, by_force: bool) {
    use rustix::process::{Pid, Signal, kill_process_group};
    let group = i32::try_from(child.id()).ok().and_then(Pid::from_raw);
    let signal = if by_force { Signal::KILL } else { Signal::TERM };
    // A group that has ended meanwhile needs no signal.
    let _ = group.map(|group| kill_process_group(group, signal));
}

#[cfg(not(unix))]
fn end(child: &mut Child, _: bool) {
    let _ = child.kill();
}

/// A program and its arguments, as somebody would type them.
fn shown(command: &Command) -> String {
    let program = Path::new(command.get_program());
    let program = program.file_stem().unwrap_or(program.as_os_str());
    let words = std::iter::once(program).chain(command.get_args());
    words.map(|word| word.to_string_lossy().into_owned()).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
#[cfg(unix)]
mod tests {
    use super::*;

    fn with_tools<T>(does: impl FnOnce(&Tools<'_>, &Stop) -> T) -> T {
        let folder = tempfile::tempdir().unwrap();
        let stop = Stop::default();
        let scratch = Scratch::make(folder.path()).unwrap();
        does(&Tools::new(folder.path(), &scratch, &stop), &stop)
    }

    #[test]
    fn what_a_program_prints_and_how_it_ends_is_told() {
        with_tools(|tools, _| {
            let command = tools.program(Path::new("sh"), &["-c", "echo out; echo err >&2; exit 3"], "");
            let ended = tools.run(command, "test").unwrap();
            assert_eq!((ended.code, &*ended.stdout, &*ended.stderr), (Some(3), "out\n", "err\n"));
            assert!(ended.last_words().ends_with("ended with exit code 3\nerr"), "{}", ended.last_words());
        });
    }

    #[test]
    fn a_program_that_is_not_there_is_missing() {
        with_tools(|tools, _| {
            let missing = tools.run(tools.program(Path::new("no-such-program"), &[], ""), "test").unwrap_err();
            assert_eq!(missing.to_string(), "no-such-program is not installed");
        });
    }

    #[test]
    fn a_program_ends_with_all_that_it_started_when_everything_is_to_end() {
        with_tools(|tools, stop| {
            let clock = Instant::now();
            let asks = stop.clone();
            let asking = thread::spawn(move || {
                thread::sleep(Duration::from_millis(200));
                asks.set();
            });
            let command = tools.program(Path::new("sh"), &["-c", "sleep 60 & sleep 60"], "");
            assert!(matches!(tools.run(command, "test"), Err(ToolError::Interrupted)));
            asking.join().unwrap();
            assert!(clock.elapsed() < Duration::from_secs(9));
        });
    }

    #[test]
    fn the_scratch_folder_goes_with_the_gate() {
        let folder = tempfile::tempdir().unwrap();
        let scratch = Scratch::make(folder.path()).unwrap();
        let path = scratch.path("");
        assert!(path.is_dir());
        drop(scratch);
        assert!(!path.exists());
    }
}
