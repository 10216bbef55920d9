//! What a soak has found.

use serde::Serialize;

use super::resources::{Growth, Held};
use crate::relay::FaultCounts;
use crate::relay::decision::Fault;
use crate::report;
use crate::verdict::{Ruling, Verdict};

/// All of it, as it is written.
#[derive(Debug, Serialize)]
pub(super) struct Report {
    /// What the faults were drawn from.
    pub(super) seed: u64,
    /// The defect that was planted.
    pub(super) defect: Option<String>,
    /// How long it ran, in s.
    pub(super) time_s: f64,
    /// How many faults there were, by plane and kind.
    pub(super) faults: FaultCounts,
    /// What was judged, rule by rule.
    pub(super) rulings: Vec<Ruling>,
    /// What would have failed on a quiet machine, and says nothing on a noisy one.
    pub(super) skipped: u64,
    /// How often the supervisor has reset plant and commander.
    pub(super) resets: u64,
    /// Whether memory, handles and threads grow.
    pub(super) growth: Option<Growths>,
    /// What the process held before the system started.
    pub(super) held_before: Option<Held>,
    /// What it held when all had ended.
    pub(super) held_after: Option<Held>,
    /// How many parts ran, routers and link aside.
    pub(super) parts: usize,
    /// Whether all of them ended.
    pub(super) ended: bool,
    /// How long that took, in ms.
    pub(super) ended_in_ms: f64,
    /// How many threads panicked.
    pub(super) panics: u64,
    /// What there was, second by second.
    pub(super) seconds: Vec<Second>,
}

/// A second of a soak.
#[derive(Debug, Serialize)]
pub(super) struct Second {
    /// When, in s.
    pub(super) at_s: f64,
    /// How many faults there were until then.
    pub(super) faults: FaultCounts,
    /// Whether the plant moved in it.
    pub(super) moved: bool,
    /// Whether the plant was latched at its end.
    pub(super) latched: bool,
    /// What the process held.
    pub(super) held: Option<Held>,
}

/// Whether what the process holds grows.
#[derive(Debug, Clone, Copy, Serialize)]
pub(super) struct Growths {
    rss_kib: Growth,
    handles: Growth,
    threads: Growth,
}

/// How they grow; none of too short a time.
pub(super) fn growths(seconds: &[Second]) -> Option<Growths> {
    let of = |what: fn(Held) -> u64, share, more| {
        let numbers: Vec<u64> = seconds.iter().filter_map(|second| second.held.map(what)).collect();
        Growth::of(&numbers, share, more)
    };
    Some(Growths {
        rss_kib: of(|held| held.rss_kib, 0.1, 2_048)?,
        handles: of(|held| held.handles, 0.0, 4)?,
        threads: of(|held| held.threads, 0.0, 8)?,
    })
}

impl Report {
    /// Whether nothing failed, grew, panicked or hung.
    pub(super) fn held(&self) -> bool {
        let failed = self.rulings.iter().any(|ruling| ruling.verdict == Verdict::Failed);
        let grows = self
            .growth
            .is_some_and(|growth| [growth.rss_kib, growth.handles, growth.threads].iter().any(|growth| growth.grows));
        !failed && !grows && self.ended && self.panics == 0
    }

    /// Shows it to people.
    pub(super) fn print(&self) {
        println!("{:.1} s with seed {}", self.time_s, self.seed);
        print!("\n{:12}", "faults");
        for fault in Fault::ALL {
            print!("{:>12}", fault.as_str());
        }
        for (plane, of_plane) in &self.faults {
            print!("\n{:12}", plane.plane().as_str());
            for fault in Fault::ALL {
                print!("{:>12}", of_plane.get(&fault).copied().unwrap_or(0));
            }
        }
        println!("\n");
        report::matrix(&self.rulings);
        let (checks, violations) = self.rulings.iter().fold((0, 0), |(checks, violations), ruling| {
            (checks + ruling.observed + ruling.violations, violations + ruling.violations)
        });
        println!(
            "{checks} checks, {violations} violations; {} said nothing, since the machine was noisy",
            self.skipped
        );
        println!("{} resets by the supervisor, {} panics", self.resets, self.panics);
        match &self.growth {
            Some(growth) => {
                println!("memory in KiB  {}", growth.rss_kib);
                println!("open handles   {}", growth.handles);
                println!("threads        {}", growth.threads);
            }
            None => println!("too short a time to say whether anything grows"),
        }
        if let (Some(before), Some(after)) = (self.held_before, self.held_after) {
            println!(
                "before and after: handles {} → {}, threads {} → {}",
                before.handles, after.handles, before.threads, after.threads
            );
        }
        let ended = if self.ended { "ended" } else { "did NOT end" };
        println!("{} parts, two routers and the link {ended} in {:.0} ms", self.parts, self.ended_in_ms);
        println!("{}", if self.held() { "it held" } else { "it did NOT hold" });
    }
}
