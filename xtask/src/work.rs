//! What a check works with: it sets up what it needs, runs programs, and counts their tests.

use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::process;
use crate::project::{self, Project};
use crate::setup::{Say, SetupError};
use crate::tally::{self, Tally};

/// The folder of the logs.
pub(crate) const LOGS: &str = ".tools/logs";

/// What a check works with.
pub(crate) struct Work<'a> {
    pub(crate) project: &'a Project,
    /// The name of the check.
    pub(crate) name: &'static str,
    /// Shows a remark.
    pub(crate) say: Say<'a>,
}

/// How a check failed.
#[derive(Debug)]
pub(crate) struct Failure {
    /// At least one failed test.
    pub(crate) tally: Tally,
    /// What to show.
    pub(crate) text: String,
}

impl Failure {
    /// A check that is one test, and failed.
    pub(crate) fn of_one(text: String) -> Self {
        Self { tally: Tally::one(false), text }
    }
}

impl From<SetupError> for Failure {
    fn from(error: SetupError) -> Self {
        Self::of_one(error.to_string())
    }
}

impl Work<'_> {
    /// Where all that the check's program prints can be read afterwards.
    fn log(&self) -> PathBuf {
        self.project.path(LOGS).join(self.name).with_extension("log")
    }

    /// Where a test program leaves its JUnit file, if it can be told.
    pub(crate) fn report(&self) -> PathBuf {
        self.project.path(LOGS).join(self.name).with_extension("xml")
    }

    /// Sets up what the check needs, showing what is installed.
    ///
    /// # Errors
    /// It could not be set up.
    pub(crate) fn set_up<T>(
        &mut self,
        set_up: fn(&Project, Say<'_>) -> Result<T, SetupError>,
    ) -> Result<T, SetupError> {
        set_up(self.project, self.say)
    }

    /// Runs a program that is one test: it has to succeed.
    ///
    /// # Errors
    /// It did not, or could not be started.
    pub(crate) fn program(&mut self, mut program: Command) -> Result<Tally, Failure> {
        self.run(&mut program).map(|()| Tally::one(true)).map_err(Failure::of_one)
    }

    /// Runs a program that runs tests and leaves a JUnit file of them. What fails without a failed test, such as a
    /// compiler that finds an error, is a failed test itself; so is a program that leaves no test.
    ///
    /// # Errors
    /// It did not succeed, could not be started, or ran no test.
    pub(crate) fn tests(&mut self, mut program: Command, report: &Path) -> Result<Tally, Failure> {
        // What an earlier run left counts for nothing.
        fs::remove_file(report).ok();
        let mut ended = self.run(&mut program);
        let read = fs::read_to_string(report).map_err(|error| error.to_string());
        let read = read.and_then(|text| tally::junit(&text).map_err(|error| error.to_string()));
        let mut tally = read.unwrap_or_else(|error| {
            let shown = project::shown(&program);
            ended = ended.clone().and(Err(format!("{shown} left no report in {}: {error}", report.display())));
            Tally::default()
        });
        if ended.is_ok() && tally.passed + tally.failed == 0 {
            ended = Err(format!("{} ran no test", project::shown(&program)));
        }
        match ended {
            Ok(()) if tally.failed == 0 => Ok(tally),
            Ok(()) => Err(Failure { text: format!("{} has failed tests", project::shown(&program)), tally }),
            Err(text) => {
                if tally.failed == 0 {
                    tally += Tally::one(false);
                }
                Err(Failure { tally, text })
            }
        }
    }

    /// Runs a program, what it prints into the log; what to show, if it does not succeed.
    fn run(&self, program: &mut Command) -> Result<(), String> {
        let shown = project::shown(program);
        let log = self.log();
        let unusable = |error| format!("{}: {error}", log.display());
        let out = File::create(&log).map_err(unusable)?;
        let err = out.try_clone().map_err(unusable)?;
        let ended = match process::run(program.stdout(out).stderr(err)) {
            Ok(status) if status.success() => return Ok(()),
            Ok(status) => format!("{shown} ended with {status}"),
            Err(error) => format!("{shown} could not be started: {error}"),
        };
        let printed = fs::read(&log).map_err(unusable)?;
        let excerpt = excerpt(&String::from_utf8_lossy(&printed));
        Err(format!("{excerpt}\n{ended}\nall of its output: {}", log.display()))
    }
}

/// What matters most of what a failed program printed: the failures that test programs report, wherever they stand,
/// and the last lines.
fn excerpt(printed: &str) -> String {
    const FAILURES: usize = 80;
    const TAIL: usize = 25;
    let lines: Vec<&str> = printed.trim_end().lines().collect();
    let tail = lines.len().saturating_sub(TAIL);

    let mut shown = Vec::new();
    let mut failing = false;
    for (number, line) in lines.iter().enumerate() {
        failing |= matches!(line.trim(), "failures:" | "✖ failing tests:") || line.trim_start().starts_with("FAIL [");
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

#[cfg(test)]
mod tests {
    use super::*;

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

        /// A program that may leave a JUnit file.
        fn tests(program: &str, script: &str, junit: Option<&str>) -> Result<Tally, Failure> {
            let folder = tempfile::tempdir().unwrap();
            let project = Project::at(folder.path());
            fs::create_dir_all(project.path(LOGS)).unwrap();
            let mut work = Work { project: &project, name: "check", say: &mut |_| {} };
            let leave = junit.map(|text| format!("echo \"{text}\" > junit.xml; ")).unwrap_or_default();
            work.tests(project.program(program, &["-c", &(leave + script)], ""), &project.path("junit.xml"))
        }

        fn counts(tally: &Tally) -> (u64, u64) {
            (tally.passed, tally.failed)
        }

        const TWO: &str = "<testsuite><testcase name='a'/><testcase name='b'/></testsuite>";
        const ONE_FAILED: &str = "<testsuite><testcase name='a'><failure/></testcase></testsuite>";

        #[test]
        fn the_tests_of_a_program_that_succeeds_are_counted() {
            assert_eq!(counts(&tests("sh", "exit 0", Some(TWO)).unwrap()), (2, 0));
        }

        #[test]
        fn a_program_that_leaves_no_test_has_failed() {
            for junit in [None, Some("<testsuites></testsuites>"), Some("<testsuites>")] {
                assert_eq!(counts(&tests("sh", "exit 0", junit).unwrap_err().tally), (0, 1), "{junit:?}");
            }
        }

        #[test]
        fn a_failed_test_is_no_success_whatever_the_program_says() {
            assert_eq!(counts(&tests("sh", "exit 0", Some(ONE_FAILED)).unwrap_err().tally), (0, 1));
        }

        #[test]
        fn a_program_that_fails_before_any_test_is_one_failed_test() {
            let failure = tests("sh", "echo 'error: no such thing' >&2; exit 3", None).unwrap_err();
            assert_eq!(counts(&failure.tally), (0, 1));
            assert!(failure.text.contains("error: no such thing"), "{}", failure.text);
            assert!(failure.text.contains("exit status: 3"), "{}", failure.text);
        }

        #[test]
        fn a_crash_behind_passed_tests_is_a_failed_test() {
            assert_eq!(counts(&tests("sh", "kill -ABRT $$", Some(TWO)).unwrap_err().tally), (2, 1));
        }

        #[test]
        fn a_program_that_cannot_be_started_is_named() {
            let failure = tests("no-such-program-anywhere", "", None).unwrap_err();
            assert_eq!(counts(&failure.tally), (0, 1));
            assert!(failure.text.contains("no-such-program-anywhere"), "{}", failure.text);
        }
    }
}
