//! The reference system over a hostile link, judged all the time: for the time of a scenario, or of a soak.
//!
//! | module | what it does |
//! |---|---|
//! | [`system`] | starts everything, and looks at both ends of the link |
//! | [`body`] | what a plant may do, by the commands that reached it |
//! | [`commander`] | what a commander may send, by the sensor frames that reached it |
//! | [`replies`] | clients that know the answers |
//! | [`supervisor`] | leads back from ESTOP |
//! | [`resources`] | memory, handles and threads, and whether they grow |
//! | [`report`] | what a soak has found, as JSON and for people |
//! | [`plot`] | the same over time, as SVG |

mod body;
mod commander;
pub(crate) mod plot;
mod replies;
mod report;
mod resources;
mod supervisor;
mod system;

use std::panic;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::thread;
use std::time::Duration;

use clap::Args;
use ncp_text::Catalogue;
use serde::Deserialize;
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;

use crate::LiveError;
use crate::actors::Planted;
use crate::mutants;
use crate::relay::schedule::Schedule;
use crate::scenario::Role;
use crate::verdict::Rulings;
use report::{Report, Second};
use resources::Held;
use system::System;

/// How a soak is run.
#[derive(Debug, Args)]
pub(crate) struct Soak {
    /// For how long, such as `10m` or `90s`
    #[arg(long, value_name = "TIME", default_value = "10m", value_parser = humantime::parse_duration)]
    time: Duration,
    /// What the faults are drawn from [default: that of the schedule]
    #[arg(long, value_name = "NUMBER")]
    seed: Option<u64>,
    /// What the link does (TOML) [default: everything, `live/soak.toml`]
    #[arg(long, value_name = "FILE")]
    schedule: Option<PathBuf>,
    /// Write what was found as JSON
    #[arg(long, value_name = "FILE")]
    report: Option<PathBuf>,
    /// Draw what happened over time, as SVG
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
    /// Plant a defect in the actors
    #[arg(long, value_name = "NAME")]
    defect: Option<String>,
}

/// What a scenario over a hostile link needs.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct OverLink {
    /// For how long it runs, in s.
    time_s: f64,
    /// The reference actors that run.
    parts: Vec<Role>,
    /// How many clients ask that know the answers.
    #[serde(default)]
    asks: u32,
    /// How long after a cut the plant has to move again, in s.
    #[serde(default = "recovers_s")]
    recovers_s: f64,
    /// What the link does.
    pub(crate) schedule: Schedule,
}

/// The rules that a soak judges.
const RULES: [&str; 22] = [
    "NCP-RES-002",
    "NCP-RES-005",
    "NCP-RES-006",
    "NCP-RES-009",
    "NCP-RES-020",
    "NCP-RES-021",
    "NCP-RES-022",
    "NCP-RES-023",
    "NCP-RES-025",
    "NCP-RES-026",
    "NCP-RES-031",
    "NCP-WIRE-001",
    "NCP-WIRE-002",
    "NCP-WIRE-004",
    "NCP-WIRE-007",
    "NCP-SAFE-006",
    "NCP-SAFE-033",
    "NCP-CTRL-011",
    "NCP-CTRL-020",
    "NCP-PLANE-006",
    "NCP-PLANE-007",
    "NCP-TRANS-009",
];

/// Those on replies.
const OF_REPLIES: [&str; 2] = ["NCP-SESS-020", "NCP-SESS-027"];

/// What a soak's link does unless it is told.
const SCHEDULE: &str = include_str!("../../soak.toml");

/// How many clients ask.
const ASKS: u32 = 2;

/// From one look to the next.
const LOOK: Duration = Duration::from_millis(10);

/// How long a system may take to end.
const ENDS: Duration = Duration::from_secs(20);

/// How much later than it happened the last thing is judged, in s.
const LAST_S: f64 = 0.6;

/// Runs the system of a scenario over its link.
///
/// # Errors
/// Zenoh refuses, or the schedule is none.
pub(crate) fn over_link(link: &OverLink, planted: &Planted, rulings: &mut Rulings) -> Result<(), LiveError> {
    let OverLink { time_s, parts, asks, recovers_s, schedule } = link;
    let schedule = schedule.clone().checked()?;
    let longest = Duration::try_from_secs_f64(*time_s).map_err(|_| LiveError::Time(*time_s))?;
    let mut system = System::start(parts, *asks, &schedule, planted, longest, *recovers_s)?;
    while system.now_s() < time_s + LAST_S {
        system.look(|seen| rulings.observe(seen.rule, seen.is_so, || seen.why));
        thread::sleep(LOOK);
    }
    for seen in system.joined() {
        rulings.observe(seen.rule, seen.is_so, || seen.why);
    }
    system.end(ENDS);
    Ok(())
}

/// Soaks the whole reference system, and reports; whether it held.
///
/// # Errors
/// Zenoh refuses, the schedule is none, or a file cannot be written.
pub(crate) fn run(soak: &Soak) -> Result<bool, LiveError> {
    let mut schedule = soak.schedule.as_deref().map_or_else(|| Schedule::parse(SCHEDULE), Schedule::read)?;
    schedule.seed = soak.seed.unwrap_or(schedule.seed);
    if let Some(name) = &soak.defect {
        let known = mutants::defects()?.into_iter().any(|known| known.name == *name);
        known.then_some(()).ok_or_else(|| LiveError::Unknown(name.clone()))?;
    }
    let (is_stopped, panics) = (stop_on_signal()?, count_panics());
    let before = Held::now();
    let rules: Vec<String> = RULES.iter().chain(&OF_REPLIES).map(|rule| (*rule).to_owned()).collect();
    let mut rulings = Rulings::new(&rules);
    let planted = Planted(soak.defect.clone());
    let parts = [Role::Plant, Role::Server, Role::Commander, Role::Client, Role::Observer];
    let mut system = System::start(&parts, ASKS, &schedule, &planted, soak.time, recovers_s())?;
    let (mut seconds, time_s) = (Vec::new(), soak.time.as_secs_f64());
    while system.now_s() < time_s + LAST_S && !is_stopped.load(Ordering::Relaxed) {
        system.look(|seen| rulings.observe(seen.rule, seen.is_so, || seen.why));
        let now_s = system.now_s();
        if seconds.last().is_none_or(|last: &Second| now_s - last.at_s >= 1.0) {
            let (moved_s, latched_s) = system.motion();
            seconds.push(Second {
                at_s: now_s,
                faults: system.faults(),
                moved: now_s - moved_s < 1.0,
                latched: latched_s.is_some(),
                held: Held::now(),
            });
        }
        thread::sleep(LOOK);
    }
    for seen in system.joined() {
        rulings.observe(seen.rule, seen.is_so, || seen.why);
    }
    let catalogue = Catalogue::load()?;
    let sentence = |rule: &str| catalogue.get(rule).map(|rule| rule.sentence.clone()).unwrap_or_default();
    let (now_s, faults, parts) = (system.now_s(), system.faults(), system.parts());
    let (resets, skipped) = (system.resets(), system.skipped());
    let (took, ended) = system.end(ENDS);
    let report = Report {
        seed: schedule.seed,
        defect: soak.defect.clone(),
        time_s: now_s,
        faults,
        rulings: rulings.verdicts("soak", sentence),
        skipped,
        resets,
        growth: report::growths(&seconds),
        held_before: before,
        held_after: Held::now(),
        parts,
        ended,
        ended_in_ms: took.as_secs_f64() * 1e3,
        panics: panics.load(Ordering::Relaxed),
        seconds,
    };
    report.print();
    crate::write_json(soak.report.as_deref(), &report)?;
    if let Some(path) = &soak.plot {
        plot::draw(path, &report, &schedule)?;
    }
    Ok(report.held())
}

/// As long as it takes that a burst clears, and that a supervisor has reset the system, more than once.
const fn recovers_s() -> f64 {
    15.0
}

/// Whether somebody asked to stop: the report is written all the same.
fn stop_on_signal() -> Result<Arc<AtomicBool>, LiveError> {
    let is_stopped = Arc::new(AtomicBool::new(false));
    for signal in [SIGINT, SIGTERM] {
        flag::register(signal, Arc::clone(&is_stopped))?;
    }
    Ok(is_stopped)
}

/// Counts the threads that panic from now on.
fn count_panics() -> Arc<AtomicU64> {
    let panics = Arc::new(AtomicU64::new(0));
    let (count, before) = (Arc::clone(&panics), panic::take_hook());
    panic::set_hook(Box::new(move |info| {
        count.fetch_add(1, Ordering::Relaxed);
        before(info);
    }));
    panics
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_schedule_of_a_soak_has_every_fault_on_every_plane() {
        let schedule = Schedule::parse(SCHEDULE).unwrap();
        for plane in crate::relay::schedule::PlaneName::ALL {
            let of = schedule.of(plane);
            let all = [of.lose, of.delay, of.duplicate, of.reorder, of.corrupt, of.flood];
            assert!(all.iter().all(|probability| *probability > 0.0) && of.burst.is_some(), "{plane:?}");
            assert!(schedule.cuts.iter().any(|cut| cut.planes.contains(&plane)), "{plane:?}");
        }
    }

    #[test]
    fn a_soak_judges_rules_of_the_text() {
        let catalogue = Catalogue::load().unwrap();
        for rule in RULES.iter().chain(&OF_REPLIES) {
            assert!(catalogue.get(rule).is_some(), "{rule}");
        }
    }
}
