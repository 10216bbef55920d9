//! Carries the checks out, one after the other, and shows how they end.

use std::fs::{self, File};
use std::io::{self, IsTerminal, Write};
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

use crate::Error;
use crate::checks::{CHECKS, Check, Work};
use crate::count::Count;
use crate::project::{self, Project};

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
                return Ok(CHECKS
                    .iter()
                    .filter(|check| names.contains(&check.name))
                    .collect());
            }
            ["--only", name, rest @ ..] => {
                let check = CHECKS.iter().find(|check| check.name == *name);
                names.push(
                    check
                        .ok_or_else(|| usage(format!("`{name}` is no check")))?
                        .name,
                );
                args = rest;
            }
            [other, ..] => return Err(usage(format!("`{other}` is no option of `test`"))),
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
    fs::create_dir_all(&logs).map_err(|source| Error::File {
        path: logs.clone(),
        source,
    })?;
    let mut screen = Screen::new();
    let mut total = Count::default();
    for check in checks {
        screen.begin(check.name);
        let start = Instant::now();
        let outcome = match &check.work {
            Work::Library(work) => match work(project) {
                Ok(()) => Outcome {
                    count: Count::one(true),
                    failure: None,
                },
                Err(failure) => Outcome::failed(failure),
            },
            Work::Program { program, count } => {
                let log = logs.join(format!("{}.log", check.name));
                match program(project, &mut |line| screen.say(line)) {
                    Ok(program) => carry_out(program, *count, &log)
                        .map_err(|source| Error::File { path: log, source })?,
                    Err(error) => Outcome::failed(error.to_string()),
                }
            }
        };
        screen.end(check.name, start.elapsed(), &outcome);
        total += outcome.count;
    }
    println!("{} passed, {} failed", total.passed, total.failed);
    Ok(total.failed == 0)
}

const LOGS: &str = ".tools/logs";

fn usage(what: String) -> Error {
    Error::Usage {
        what: format!("{what}; `cargo xtask test --list` shows the checks"),
    }
}

/// How a check ended.
struct Outcome {
    count: Count,
    /// What to show if it failed.
    failure: Option<String>,
}

impl Outcome {
    /// A check that failed as a whole.
    fn failed(failure: String) -> Self {
        Self {
            count: Count::one(false),
            failure: Some(failure),
        }
    }
}

/// Runs a program, with all that it prints going to a log.
fn carry_out(
    mut program: Command,
    counter: Option<fn(&str) -> Count>,
    log: &Path,
) -> io::Result<Outcome> {
    let file = File::create(log)?;
    let status = program.stdout(file.try_clone()?).stderr(file).status();
    let ended = match status {
        Ok(status) if status.success() => None,
        Ok(status) => Some(format!("{} ended with {status}", project::shown(&program))),
        Err(error) => Some(format!(
            "{} could not be started: {error}",
            project::shown(&program)
        )),
    };
    let printed = String::from_utf8_lossy(&fs::read(log)?).into_owned();
    let mut count = counter.map_or_else(Count::default, |counter| counter(&printed));
    // What does not count its tests is one; what fails without a failed test, such as code
    // that does not compile, has failed once.
    if count == Count::default() || (ended.is_some() && count.failed == 0) {
        count += Count::one(ended.is_none());
    }
    let failure = ended.map(|ended| {
        format!(
            "{}\n{ended}\nall that it printed: {}",
            excerpt(&printed),
            log.display()
        )
    });
    Ok(Outcome { count, failure })
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
        Self {
            live,
            colours: live && std::env::var_os("NO_COLOR").is_none(),
        }
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
    fn end(&mut self, name: &str, time: Duration, outcome: &Outcome) {
        self.clear();
        let Count { passed, failed } = outcome.count;
        let (state, colour) = match (&outcome.failure, failed) {
            (None, 0) => ("ok", "32"),
            _ => ("FAILED", "31"),
        };
        let state = format!("{state:8}");
        let state = if self.colours {
            format!("\x1b[{colour}m{state}\x1b[0m")
        } else {
            state
        };
        let tests = match passed + failed {
            0 | 1 => String::new(),
            _ if failed == 0 => format!("   {passed} passed"),
            _ => format!("   {passed} passed, {failed} failed"),
        };
        println!("{state} {name:14} {:>7.1} s{tests}", time.as_secs_f64());
        for line in outcome.failure.iter().flat_map(|failure| failure.lines()) {
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
        let names = |args: &[&str]| -> Vec<_> {
            select(args)
                .unwrap()
                .into_iter()
                .map(|check| check.name)
                .collect()
        };
        assert_eq!(
            names(&["--only", "rust", "--only", "format"]),
            ["format", "rust"]
        );
        assert_eq!(names(&[]).len(), CHECKS.len());
    }

    #[test]
    fn an_unknown_check_or_option_is_said() {
        for args in [&["--only", "nonsense"][..], &["--only"], &["rust"]] {
            let Err(error) = select(args) else {
                panic!("{args:?} was accepted")
            };
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

        fn run_shell(script: &str, counter: Option<fn(&str) -> Count>) -> Outcome {
            let folder = tempfile::tempdir().unwrap();
            let mut shell = Command::new("sh");
            shell.args(["-c", script]);
            carry_out(shell, counter, &folder.path().join("log")).unwrap()
        }

        #[test]
        fn a_program_that_succeeds_is_one_passed_test() {
            let outcome = run_shell("echo fine", None);
            assert_eq!(
                outcome.count,
                Count {
                    passed: 1,
                    failed: 0
                }
            );
            assert_eq!(outcome.failure, None);
        }

        #[test]
        fn a_program_that_fails_before_any_test_is_one_failed_test() {
            let outcome = run_shell(
                "echo 'error: no such thing' >&2; exit 3",
                Some(crate::count::cargo),
            );
            assert_eq!(
                outcome.count,
                Count {
                    passed: 0,
                    failed: 1
                }
            );
            let failure = outcome.failure.unwrap();
            assert!(failure.contains("error: no such thing"), "{failure}");
            assert!(failure.contains("exit status: 3"), "{failure}");
        }

        #[test]
        fn a_crash_behind_passed_tests_is_a_failed_test() {
            let script = "echo 'test result: ok. 7 passed; 0 failed; 0 ignored'; kill -ABRT $$";
            let outcome = run_shell(script, Some(crate::count::cargo));
            assert_eq!(
                outcome.count,
                Count {
                    passed: 7,
                    failed: 1
                }
            );
        }

        #[test]
        fn a_program_that_cannot_be_started_is_named() {
            let folder = tempfile::tempdir().unwrap();
            let program = Command::new("no-such-program-anywhere");
            let outcome = carry_out(program, None, &folder.path().join("log")).unwrap();
            assert_eq!(
                outcome.count,
                Count {
                    passed: 0,
                    failed: 1
                }
            );
            assert!(
                outcome
                    .failure
                    .unwrap()
                    .contains("no-such-program-anywhere")
            );
        }
    }
}
