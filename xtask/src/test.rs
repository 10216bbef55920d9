//! Carries the checks out, one after the other, and shows how they end.

use std::fs::{self, File};
use std::io::{self, IsTerminal, Write};
use std::path::PathBuf;
use std::process::Command;
use std::time::{Duration, Instant};

use crate::Error;
use crate::checks::{CHECKS, Check};
use crate::count::Count;
use xtask::project::{self, Project};
use xtask::setup::{Say, SetupError};

/// Prints the checks.
pub(crate) fn list() {
    for Check { name, about, .. } in CHECKS {
        println!("{name:14} {about}");
    }
}

/// The checks that `--only` selects; all of them without it.
///
/// # Errors
/// An unknown option or check.
pub(crate) fn select(mut args: &[&str]) -> Result<Vec<&'static Check>, Error> {
    let mut names = Vec::new();
    loop {
        match args {
            [] if names.is_empty() => return Ok(CHECKS.iter().collect()),
            [] => {
                return Ok(CHECKS.iter().filter(|check| names.contains(&check.name)).collect());
            }
            ["--only", name, rest @ ..] => {
                let check = CHECKS.iter().find(|check| check.name == *name);
                names.push(check.ok_or_else(|| usage(&format!("`{name}` is no check")))?.name);
                args = rest;
            }
            [other, ..] => return Err(usage(&format!("`{other}` is no option of `test`"))),
        }
    }
}

/// Carries out the checks, all of them whatever fails, and ends with the line
/// `N passed, N failed`; `false` if any failed.
///
/// # Errors
/// A log cannot be written.
pub(crate) fn run(project: &Project, checks: &[&Check]) -> Result<bool, Error> {
    let logs = project.path(LOGS);
    fs::create_dir_all(&logs).map_err(|source| Error::File { path: logs.clone(), source })?;
    let mut screen = Screen::new();
    let mut total = Count::default();
    for check in checks {
        screen.begin(check.name);
        let start = Instant::now();
        let log = logs.join(format!("{}.log", check.name));
        let outcome = (check.run)(&mut Work { project, log, screen: &mut screen });
        screen.end(check.name, start.elapsed(), &outcome);
        total += match outcome {
            Ok(count) | Err(Failure { count, .. }) => count,
        };
    }
    println!("{} passed, {} failed", total.passed, total.failed);
    Ok(total.failed == 0)
}

/// What a check works with.
pub(crate) struct Work<'a> {
    pub(crate) project: &'a Project,
    /// Where all that the check's program prints can be read afterwards.
    log: PathBuf,
    screen: &'a mut Screen,
}

/// How a check failed.
#[derive(Debug)]
pub(crate) struct Failure {
    /// At least one failed test.
    count: Count,
    /// What to show.
    text: String,
}

impl Failure {
    /// A check that is one test, and failed.
    pub(crate) fn of_one(text: String) -> Self {
        Self { count: Count::one(false), text }
    }
}

impl From<SetupError> for Failure {
    fn from(error: SetupError) -> Self {
        Self::of_one(error.to_string())
    }
}

impl Work<'_> {
    /// Sets up what the check needs, showing what is installed.
    ///
    /// # Errors
    /// It could not be set up.
    pub(crate) fn set_up<T>(
        &mut self,
        set_up: fn(&Project, Say<'_>) -> Result<T, SetupError>,
    ) -> Result<T, SetupError> {
        set_up(self.project, &mut |line| self.screen.say(line))
    }

    /// Runs a program that is one test: it has to succeed.
    ///
    /// # Errors
    /// It did not, or could not be started.
    pub(crate) fn program(&mut self, program: Command) -> Result<Count, Failure> {
        self.tests(program, |_| Count::default())
    }

    /// Runs a program that runs tests, and counts those.
    ///
    /// # Errors
    /// It did not succeed, or could not be started.
    pub(crate) fn tests(&mut self, mut program: Command, counter: fn(&str) -> Count) -> Result<Count, Failure> {
        let shown = project::shown(&program);
        let unusable = |error| Failure::of_one(format!("{}: {error}", self.log.display()));
        let out = File::create(&self.log).map_err(unusable)?;
        let err = out.try_clone().map_err(unusable)?;
        let ended = match program.stdout(out).stderr(err).status() {
            Ok(status) if status.success() => None,
            Ok(status) => Some(format!("{shown} ended with {status}")),
            Err(error) => Some(format!("{shown} could not be started: {error}")),
        };
        let printed = fs::read(&self.log).map_err(unusable)?;
        let printed = String::from_utf8_lossy(&printed);

        let mut count = counter(&printed);
        // A program without tests is a test itself; so is one that fails without a failed
        // test, such as a compiler that finds an error.
        if count == Count::default() || (ended.is_some() && count.failed == 0) {
            count += Count::one(ended.is_none());
        }
        match ended {
            None => Ok(count),
            Some(ended) => {
                let log = self.log.display();
                let text = format!("{}\n{ended}\nall of its output: {log}", excerpt(&printed));
                Err(Failure { count, text })
            }
        }
    }
}

const LOGS: &str = ".tools/logs";

fn usage(what: &str) -> Error {
    Error::Usage { what: format!("{what}; `cargo xtask test --list` shows the checks") }
}

/// What matters most of what a failed program printed: the failures that test programs
/// report, wherever they stand, and the last lines.
fn excerpt(printed: &str) -> String {
    const FAILURES: usize = 80;
    const TAIL: usize = 25;
    let lines: Vec<&str> = printed.trim_end().lines().collect();
    let tail = lines.len().saturating_sub(TAIL);

    let mut shown = Vec::new();
    let mut failing = false;
    for (number, line) in lines.iter().enumerate() {
        failing |= matches!(*line, "failures:" | "✖ failing tests:");
        failing &= !line.starts_with("test result: ");
        if number >= tail {
            shown.push(*line);
        } else if failing && shown.len() < FAILURES {
            shown.push(*line);
            if shown.len() == FAILURES {
                shown.push("[…]");
            }
        }
    }
    shown.join("\n")
}

/// The list of the checks as it grows on the terminal.
struct Screen {
    /// A terminal, on which a line can be replaced and coloured.
    live: bool,
    colours: bool,
}

impl Screen {
    fn new() -> Self {
        let live = io::stdout().is_terminal();
        Self { live, colours: live && std::env::var_os("NO_COLOR").is_none() }
    }

    /// Shows which check is at work.
    fn begin(&mut self, name: &str) {
        if self.live {
            print!("{:8} {name}", "…");
            io::stdout().flush().ok();
        }
    }

    /// Shows a remark of the check at work, in a line of its own.
    fn say(&mut self, remark: &str) {
        self.clear();
        println!("{:8} {remark}", "");
    }

    /// Shows how the check ended.
    fn end(&mut self, name: &str, time: Duration, outcome: &Result<Count, Failure>) {
        self.clear();
        let (state, colour, count, text) = match outcome {
            Ok(count) => ("ok", "32", count, ""),
            Err(Failure { count, text }) => ("FAILED", "31", count, text.as_str()),
        };
        let state = format!("{state:8}");
        let state = if self.colours { format!("\x1b[{colour}m{state}\x1b[0m") } else { state };
        let tests = match count {
            Count { passed, failed } if passed + failed < 2 => String::new(),
            Count { passed, failed: 0 } => format!("   {passed} passed"),
            Count { passed, failed } => format!("   {passed} passed, {failed} failed"),
        };
        println!("{state} {name:14} {:>7.1} s{tests}", time.as_secs_f64());
        for line in text.lines() {
            println!("         | {line}");
        }
    }

    fn clear(&self) {
        if self.live {
            print!("\r\x1b[2K");
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_selects_checks_in_their_own_order() {
        let names = |args: &[&str]| -> Vec<_> { select(args).unwrap().into_iter().map(|check| check.name).collect() };
        assert_eq!(names(&["--only", "rust", "--only", "format"]), ["format", "rust"]);
        assert_eq!(names(&[]).len(), CHECKS.len());
    }

    #[test]
    fn an_unknown_check_or_option_is_said() {
        for args in [&["--only", "nonsense"][..], &["--only"], &["rust"]] {
            let Err(error) = select(args) else { panic!("{args:?} was accepted") };
            assert!(error.to_string().contains("--list"), "{error}");
        }
    }

    #[test]
    fn every_check_has_its_own_name() {
        let mut names: Vec<_> = CHECKS.iter().map(|check| check.name).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), CHECKS.len());
    }

    #[test]
    fn a_failure_far_above_the_end_is_shown() {
        let noise = "test other ... ok\n".repeat(1000);
        let printed = format!(
            "{noise}\nfailures:\n\n---- it_holds stdout ----\nassertion failed: 1 == 2\n\n\
             failures:\n    it_holds\n\ntest result: FAILED. 0 passed; 1 failed;\n\n{noise}error: 1 target failed"
        );
        let excerpt = excerpt(&printed);
        assert!(excerpt.contains("assertion failed: 1 == 2"));
        assert!(excerpt.ends_with("error: 1 target failed"));
        assert!(excerpt.lines().count() < 40, "{excerpt}");
    }

    #[test]
    fn the_failures_that_are_shown_are_bounded() {
        let printed = format!("failures:\n{}", "noise\n".repeat(100_000));
        assert!(excerpt(&printed).lines().count() < 120);
    }

    #[cfg(unix)]
    mod with_programs {
        use super::*;

        fn tests(program: &str, args: &[&str]) -> Result<Count, Failure> {
            let folder = tempfile::tempdir().unwrap();
            let project = Project::at(folder.path());
            let (log, mut screen) = (folder.path().join("log"), Screen::new());
            let mut work = Work { project: &project, log, screen: &mut screen };
            let program = project.program(program, args, "");
            work.tests(program, crate::count::cargo)
        }

        fn shell(script: &str) -> Result<Count, Failure> {
            tests("sh", &["-c", script])
        }

        #[test]
        fn a_program_that_succeeds_without_tests_is_one_passed_test() {
            assert_eq!(shell("echo fine").unwrap(), Count { passed: 1, failed: 0 });
        }

        #[test]
        fn a_program_that_fails_before_any_test_is_one_failed_test() {
            let failure = shell("echo 'error: no such thing' >&2; exit 3").unwrap_err();
            assert_eq!(failure.count, Count { passed: 0, failed: 1 });
            assert!(failure.text.contains("error: no such thing"), "{}", failure.text);
            assert!(failure.text.contains("exit status: 3"), "{}", failure.text);
        }

        #[test]
        fn a_crash_behind_passed_tests_is_a_failed_test() {
            let script = "echo 'test result: ok. 7 passed; 0 failed; 0 ignored'; kill -ABRT $$";
            let failure = shell(script).unwrap_err();
            assert_eq!(failure.count, Count { passed: 7, failed: 1 });
        }

        #[test]
        fn a_program_that_cannot_be_started_is_named() {
            let failure = tests("no-such-program-anywhere", &[]).unwrap_err();
            assert_eq!(failure.count, Count { passed: 0, failed: 1 });
            assert!(failure.text.contains("no-such-program-anywhere"), "{}", failure.text);
        }
    }
}
