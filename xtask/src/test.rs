//! Carries the checks out, in two lanes side by side, and shows how they end.

use std::collections::VecDeque;
use std::fs;
use std::io::{self, IsTerminal, Write};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use crate::Error;
use crate::checks::{CHECKS, Check, Lane};
use crate::process;
use crate::project::Project;
use crate::tally::Tally;
use crate::work::{Failure, LOGS, Work};

/// Prints the checks.
pub(crate) fn list() {
    for Check { name, about, .. } in CHECKS {
        println!("{name:14} {about}");
    }
}

/// The checks of these names, in their own order; without a name, all but those that have to be asked for.
pub(crate) fn select(project: &Project, only: &[String]) -> Vec<&'static Check> {
    let is_selected = |check: &Check| {
        if only.is_empty() { (check.runs)(project) } else { only.iter().any(|name| name == check.name) }
    };
    CHECKS.iter().filter(|check| is_selected(check)).collect()
}

/// Carries out the checks, all of them whatever fails, and ends with the line `N passed, N failed`; `false` if any
/// failed.
///
/// # Errors
/// The folder of the logs cannot be made, or somebody has interrupted it.
pub(crate) fn run(project: &Project, checks: &[&Check]) -> Result<bool, Error> {
    let logs = project.path(LOGS);
    let unusable = |source| Error::File { path: logs.clone(), source };
    fs::create_dir_all(&logs).map_err(unusable)?;
    process::end_on_signal().map_err(unusable)?;
    let before = tree(project);
    let screen = Mutex::new(Screen::new());
    let total = Mutex::new(Tally::default());

    let waiting = Mutex::new(checks.iter().copied().collect::<VecDeque<_>>());
    thread::scope(|scope| {
        for lane in [Lane::Crates, Lane::Peers] {
            let (screen, total, waiting) = (&screen, &total, &waiting);
            scope.spawn(move || {
                // The lock is not held while a check is carried out.
                let next = || take(&mut lock(waiting), lane);
                while let Some(check) = next().filter(|_| !process::is_stopped()) {
                    let tally = carry_out(project, check, screen);
                    *lock(total) += tally;
                }
            });
        }
    });
    if process::is_stopped() {
        return Err(Error::Interrupted);
    }

    let mut total = total.into_inner().unwrap_or_else(PoisonError::into_inner);
    let after = tree(project);
    if before != after {
        println!("FAILED   the checks changed the tree:\n{}", after.unwrap_or_default().trim_end());
        total += Tally::one(false);
    }
    print_slowest(&mut total.times);
    println!("{} passed, {} failed", total.passed, total.failed);
    Ok(total.failed == 0)
}

/// The next check of a lane; once it has none left, the last of the other, so that no lane waits for the other.
fn take<'c>(waiting: &mut VecDeque<&'c Check>, lane: Lane) -> Option<&'c Check> {
    match waiting.iter().position(|check| check.lane == lane) {
        Some(place) => waiting.remove(place),
        None => waiting.pop_back(),
    }
}

/// Carries out one check, and shows how it ends.
fn carry_out(project: &Project, check: &Check, screen: &Mutex<Screen>) -> Tally {
    lock(screen).begin(check.name);
    let start = Instant::now();
    let mut say = |remark: &str| lock(screen).say(remark);
    let outcome = (check.run)(&mut Work { project, name: check.name, say: &mut say });
    let time = start.elapsed();
    lock(screen).end(check.name, time, &outcome);
    let mut tally = match outcome {
        Ok(tally) | Err(Failure { tally, .. }) => tally,
    };
    if tally.times.is_empty() {
        tally.times.push((check.name.to_owned(), time));
    } else {
        tally.times.iter_mut().for_each(|(name, _)| *name = format!("{}: {name}", check.name));
    }
    tally
}

/// What git sees changed in the tree; `None` where there is no git, or no repository.
fn tree(project: &Project) -> Option<String> {
    let output = project.program("git", &["status", "--porcelain"], "").output().ok()?;
    output.status.success().then(|| String::from_utf8_lossy(&output.stdout).into_owned())
}

/// Shows which ten tests took longest, a check without tests counting as one.
fn print_slowest(times: &mut [(String, Duration)]) {
    times.sort_by_key(|(_, time)| std::cmp::Reverse(*time));
    if times.len() > 1 {
        println!("slowest:");
    }
    for (name, time) in times.iter().take(if times.len() > 1 { 10 } else { 0 }) {
        println!("{:>8.1} s  {name}", time.as_secs_f64());
    }
}

fn lock<T>(of: &Mutex<T>) -> MutexGuard<'_, T> {
    of.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The list of the checks as it grows on the terminal.
struct Screen {
    /// A terminal, on which a line can be replaced and coloured.
    live: bool,
    colours: bool,
    /// The checks at work.
    at_work: Vec<&'static str>,
}

impl Screen {
    fn new() -> Self {
        let live = io::stdout().is_terminal();
        Self { live, colours: live && std::env::var_os("NO_COLOR").is_none(), at_work: Vec::new() }
    }

    /// Shows which check is at work.
    fn begin(&mut self, name: &'static str) {
        self.at_work.push(name);
        self.show();
    }

    /// Shows a remark of a check at work, in a line of its own.
    fn say(&self, remark: &str) {
        self.clear();
        println!("{:8} {remark}", "");
        self.show();
    }

    /// Shows how a check ended.
    fn end(&mut self, name: &str, time: Duration, outcome: &Result<Tally, Failure>) {
        self.at_work.retain(|at_work| *at_work != name);
        self.clear();
        let (state, colour, tally, text) = match outcome {
            Ok(tally) => ("ok", "32", tally, ""),
            Err(Failure { tally, text }) => ("FAILED", "31", tally, text.as_str()),
        };
        let state = format!("{state:8}");
        let state = if self.colours { format!("\x1b[{colour}m{state}\x1b[0m") } else { state };
        let tests = match tally {
            Tally { passed, failed, .. } if passed + failed < 2 => String::new(),
            Tally { passed, failed: 0, .. } => format!("   {passed} passed"),
            Tally { passed, failed, .. } => format!("   {passed} passed, {failed} failed"),
        };
        println!("{state} {name:14} {:>7.1} s{tests}", time.as_secs_f64());
        for line in text.lines() {
            println!("         | {line}");
        }
        self.show();
    }

    fn show(&self) {
        if self.live {
            self.clear();
            if !self.at_work.is_empty() {
                print!("{:8} {}", "…", self.at_work.join(", "));
            }
            io::stdout().flush().ok();
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
    use std::sync::atomic::{AtomicUsize, Ordering};

    use super::*;

    fn names(only: &[&str]) -> Vec<&'static str> {
        let project = Project::at("no such folder".as_ref());
        let only: Vec<String> = only.iter().map(ToString::to_string).collect();
        select(&project, &only).into_iter().map(|check| check.name).collect()
    }

    #[test]
    fn only_selects_checks_in_their_own_order() {
        assert_eq!(names(&["rust", "format"]), ["format", "rust"]);
    }

    #[test]
    fn all_checks_are_selected_but_those_that_lack_their_program_or_take_too_long() {
        let selected = names(&[]);
        let lacking: Vec<_> = CHECKS.iter().filter(|check| !selected.contains(&check.name)).collect();
        assert!(lacking.iter().all(|check| ["deny", "gate", "packages"].contains(&check.name)));
    }

    #[test]
    fn a_lane_takes_its_own_checks_in_their_order_and_then_the_last_of_the_other() {
        let project = Project::at("no such folder".as_ref());
        let only = ["format", "buf-lint", "clippy", "trace", "mutants"].map(str::to_owned);
        let mut waiting = select(&project, &only).into_iter().collect();
        let mut next = |lane| take(&mut waiting, lane).map(|check| check.name);
        assert_eq!([next(Lane::Crates), next(Lane::Crates)], [Some("format"), Some("clippy")]);
        assert_eq!([next(Lane::Crates), next(Lane::Peers)], [Some("mutants"), Some("buf-lint")]);
        assert_eq!([next(Lane::Peers), next(Lane::Peers)], [Some("trace"), None]);
    }

    #[test]
    fn the_lanes_work_side_by_side() {
        static AT_WORK: AtomicUsize = AtomicUsize::new(0);
        fn meets_the_other(_: &mut Work<'_>) -> Result<Tally, Failure> {
            AT_WORK.fetch_add(1, Ordering::SeqCst);
            let deadline = Instant::now() + Duration::from_secs(20);
            while AT_WORK.load(Ordering::SeqCst) < 2 && Instant::now() < deadline {
                thread::sleep(Duration::from_millis(5));
            }
            Ok(Tally::one(AT_WORK.load(Ordering::SeqCst) == 2))
        }
        let check = |lane| Check { name: "meets", about: "", lane, runs: |_| true, run: meets_the_other };
        let folder = tempfile::tempdir().unwrap();
        let checks = [check(Lane::Crates), check(Lane::Peers)];
        assert!(run(&Project::at(folder.path()), &checks.iter().collect::<Vec<_>>()).unwrap());
    }

    #[test]
    fn every_check_has_its_own_name() {
        let mut names: Vec<_> = CHECKS.iter().map(|check| check.name).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), CHECKS.len());
    }
}
