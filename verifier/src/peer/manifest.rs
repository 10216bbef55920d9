//! `peer.toml`: how a peer that is checked often says how it is set up and started.

use std::io::Read as _;
use std::path::{Path, PathBuf};
use std::process::Stdio;
use std::thread;
use std::time::Duration;

use ncp_text::catalogue::Level;
use serde::Deserialize;

use super::connection::{describe_status, end_group};
use super::{Address, ExpectedFailure, Launch, StartError, is_on_path};
use crate::stop::Stop;

/// The file's name within a peer's folder.
const FILE: &str = "peer.toml";
/// How much of a failed set-up command's output is shown, in lines.
const SHOWN_LINES: usize = 30;

/// A peer's folder and what its `peer.toml` says (PROTOCOL.md, section 6).
#[derive(Debug, Clone)]
pub struct Manifest {
    /// The folder, absolute.
    pub folder: PathBuf,
    /// The peer's name.
    pub name: String,
    /// The language that it is written in.
    pub language: String,
    /// What it is, in a sentence.
    pub about: Option<String>,
    /// The level that it claims.
    pub level: Level,
    /// How it is started.
    pub launch: Launch,
    /// Programs that must be on PATH.
    pub requires: Vec<String>,
    /// What has to run before the first start.
    pub setup: Vec<Setup>,
    /// What is known to fail.
    pub expected_failures: Vec<ExpectedFailure>,
}

/// A command that runs in the peer's folder before the first start.
#[derive(Debug, Clone)]
pub struct Setup {
    /// What it does, for people.
    pub say: String,
    /// The command.
    pub launch: Launch,
}

/// Why a `peer.toml`, or a list of expected failures, cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum ManifestError {
    /// The folder or the file is not there, or cannot be read.
    #[error("{}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What the operating system said.
        source: std::io::Error,
    },
    /// The file is not TOML, or not of this form.
    #[error("{}: {message}", path.display())]
    Form {
        /// The file.
        path: PathBuf,
        /// What is wrong, with its line.
        message: String,
    },
}

impl Manifest {
    /// Reads `peer.toml` in `folder`. `{root}` and `{target}` in commands become `root` and `target`.
    ///
    /// # Errors
    /// [`ManifestError`] if the file cannot be read or is not of the form of PROTOCOL.md, section 6.
    pub fn load(folder: &Path, root: &Path, target: &Path) -> Result<Self, ManifestError> {
        let path = folder.join(FILE);
        let read = |source| ManifestError::Read { path: path.clone(), source };
        let text = std::fs::read_to_string(&path).map_err(read)?;
        let folder = folder.canonicalize().map_err(read)?;
        let form = |message: String| ManifestError::Form { path: path.clone(), message };
        let file: File = toml::from_str(&text).map_err(|error| form(error.to_string().trim_end().to_owned()))?;
        let launch = |argv: Vec<String>, what: &str| {
            if argv.first().is_none_or(String::is_empty) {
                return Err(form(format!("the command of {what} is empty")));
            }
            let fill = |word: String| {
                word.replace("{root}", &root.to_string_lossy()).replace("{target}", &target.to_string_lossy())
            };
            Ok(Launch::new(argv.into_iter().map(fill).collect(), &folder))
        };
        let setup = file
            .setup
            .into_iter()
            .map(|step| {
                Ok(Setup { launch: launch(step.command, &format!("the set-up step {:?}", step.say))?, say: step.say })
            })
            .collect::<Result<_, _>>()?;
        file.expected_failures.iter().try_for_each(ExpectedFailure::check).map_err(|why| form(why.to_owned()))?;
        let level = match &file.level {
            None => Level::Wire,
            Some(name) => {
                Level::parse(name).ok_or_else(|| form(format!("`{name}` is not a level: wire, safety, strict")))?
            }
        };
        let address = file.connect.as_deref().map(Address::parse).transpose();
        let address = address.map_err(|error| form(error.to_string()))?;
        let peer = match (file.command, address) {
            (Some(command), None) => launch(command, "the peer")?,
            (Some(command), Some(address)) => launch(command, "the peer")?.listening_at(address),
            (None, Some(address)) if address.is_open() => {
                return Err(form("a `{port}` in `connect` is for a `command` that starts the server".to_owned()));
            }
            (None, Some(address)) => Launch::connect(address),
            (None, None) => return Err(form("missing field `command`, or `connect` with an address".to_owned())),
        };
        Ok(Self {
            level,
            launch: peer,
            folder,
            name: file.name,
            language: file.language,
            about: file.about,
            requires: file.requires,
            setup,
            expected_failures: file.expected_failures,
        })
    }

    /// The programs of `requires` that are not on PATH.
    #[must_use]
    pub fn missing_tools(&self) -> Vec<&str> {
        self.requires.iter().map(String::as_str).filter(|tool| !is_on_path(tool)).collect()
    }
}

impl Setup {
    /// Runs the command to its end.
    ///
    /// # Errors
    /// [`StartError`] if it cannot be started or fails, with the end of its output.
    pub fn run(&self, stop: &Stop) -> Result<(), StartError> {
        let mut command = self.launch.command();
        let (mut output, sink) = std::io::pipe().map_err(|source| self.launch.refused(source))?;
        let log = sink.try_clone().map_err(|source| self.launch.refused(source))?;
        command.stdin(Stdio::null()).stdout(sink).stderr(log);
        let mut child = command.spawn().map_err(|source| self.launch.refused(source))?;
        // The command holds our ends of the pipe; without it, reading would never end.
        drop(command);
        let reader = thread::spawn(move || {
            let mut text = Vec::new();
            // Whatever came before an error is still worth showing.
            let _ = output.read_to_end(&mut text);
            text
        });
        let status = loop {
            match child.try_wait() {
                Ok(Some(status)) => break status,
                Ok(None) if stop.is_set() => {
                    end_group(&mut child);
                    return Err(StartError::Interrupted);
                }
                Ok(None) => thread::sleep(Duration::from_millis(20)),
                Err(source) => return Err(self.launch.refused(source)),
            }
        };
        end_group(&mut child);
        if status.success() {
            return Ok(());
        }
        let output = reader.join().unwrap_or_default();
        let text = String::from_utf8_lossy(&output);
        let lines: Vec<&str> = text.lines().collect();
        Err(StartError::Setup {
            command: self.launch.display(),
            ending: describe_status(status),
            output: lines[lines.len().saturating_sub(SHOWN_LINES)..].join("\n"),
        })
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    name: String,
    language: String,
    about: Option<String>,
    level: Option<String>,
    command: Option<Vec<String>>,
    connect: Option<String>,
    #[serde(default)]
    requires: Vec<String>,
    #[serde(default)]
    setup: Vec<Step>,
    #[serde(default, rename = "expected-failures")]
    expected_failures: Vec<ExpectedFailure>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Step {
    say: String,
    command: Vec<String>,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn load(text: &str) -> Result<Manifest, ManifestError> {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join(FILE), text).unwrap();
        Manifest::load(folder.path(), Path::new("/the/root"), Path::new("/the/target"))
    }

    #[test]
    fn a_whole_manifest_is_read_and_its_placeholders_are_filled() {
        let manifest = load(
            r#"
            name = "mine"
            language = "C++"
            about = "The flight stack."
            command = ["{target}/release/peer", "--root={root}"]
            requires = ["sh", "surely-no-such-program"]
            [[setup]]
            say = "build it"
            command = ["make", "-C", "{root}"]
            [[expected-failures]]
            requirement = "NCP-WIRE-007"
            reason = "issue 412"
            [[expected-failures]]
            requirement = "NCP-KEY-019"
            outcome = "crash"
            cases = ["wire/a/b", "wire/a/c"]
            expires = "2026-12-31"
            excuses = 2
            reason = "issue 413"
            "#,
        )
        .unwrap();
        assert_eq!(manifest.launch.argv, ["/the/target/release/peer", "--root=/the/root"]);
        assert_eq!(manifest.setup[0].launch.argv, ["make", "-C", "/the/root"]);
        assert_eq!(manifest.missing_tools(), ["surely-no-such-program"]);
        let [by_rule, exact] = &manifest.expected_failures[..] else { panic!() };
        assert_eq!(by_rule.name(), "requirement NCP-WIRE-007");
        assert_eq!(exact.name(), "requirement NCP-KEY-019, outcome crash, 2 cases");
        assert_eq!((exact.excuses, exact.expires.as_deref()), (Some(2), Some("2026-12-31")));
    }

    #[test]
    fn a_manifest_with_a_mistake_says_where() {
        let head = "name = \"n\"\nlanguage = \"C\"\n";
        for (text, what) in [
            ("command = [\"x\"]\ncomand = 1".to_owned(), "unknown field `comand`"),
            ("command = []".to_owned(), "the command of the peer is empty"),
            ("".to_owned(), "missing field `command`"),
            (
                "command = [\"x\"]\n[[expected-failures]]\nreason = \"r\"".to_owned(),
                "names a `case`, `cases`, a `requirement` or an `outcome`",
            ),
            (
                "command = [\"x\"]\n[[expected-failures]]\nreason = \"r\"\ncase = \"a\"\ncases = [\"b\"]".to_owned(),
                "either a `case` or `cases`",
            ),
            (
                "command = [\"x\"]\n[[expected-failures]]\nreason = \"r\"\ncase = \"a\"\nexpires = \"soon\"".to_owned(),
                "a day such as",
            ),
            ("command = [\"x\"".to_owned(), "line 3"),
            ("connect = \"tcp://a:{port}\"".to_owned(), "is for a `command` that starts the server"),
            ("connect = \"a:1\"".to_owned(), "is no address of a peer"),
        ] {
            let error = load(&format!("{head}{text}")).unwrap_err().to_string();
            assert!(error.contains(what) && error.contains("peer.toml"), "{error}");
        }
    }

    #[test]
    fn a_set_up_step_that_fails_shows_what_it_printed() {
        let step = |script: &str| Setup {
            say: "set up".into(),
            launch: Launch::new(vec!["sh".into(), "-c".into(), script.into()], "."),
        };
        step("echo fine").run(&Stop::default()).unwrap();
        let error = step("echo out; echo no such package >&2; exit 4").run(&Stop::default()).unwrap_err().to_string();
        assert!(error.contains("exited with status 4") && error.contains("| no such package"), "{error}");
        let stop = Stop::default();
        stop.set();
        assert!(matches!(step("sleep 60").run(&stop), Err(StartError::Interrupted)));
    }
}
