//! What the process holds: memory, handles and threads, and whether they grow.

use std::fmt;
use std::fs;

use serde::Serialize;

/// What the process holds at a time.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub(crate) struct Held {
    /// Memory that is resident, in KiB.
    pub(crate) rss_kib: u64,
    /// Open files and sockets.
    pub(crate) handles: u64,
    /// Threads.
    pub(crate) threads: u64,
}

/// Whether what is held grows: the middle values of the thirds of a run, after a warm-up.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub(crate) struct Growth {
    /// The middle of each third.
    pub(crate) thirds: [u64; 3],
    /// How much more the last third may have than the first.
    pub(crate) allowed: u64,
    /// Whether it has more, and the second third lies between.
    pub(crate) grows: bool,
}

/// The part of a run that is no measurement: caches fill, and pools take what they need.
const WARM_UP: f64 = 0.2;

impl Held {
    /// What it is now; none where there is no `/proc`.
    pub(crate) fn now() -> Option<Self> {
        let status = fs::read_to_string("/proc/self/status").ok()?;
        let rss = status.lines().find_map(|line| line.strip_prefix("VmRSS:"))?;
        let rss_kib = rss.trim().strip_suffix("kB")?.trim().parse().ok()?;
        let entries = |folder| fs::read_dir(folder).ok().and_then(|entries| u64::try_from(entries.count()).ok());
        // The folder that is read is open, too.
        let handles = entries("/proc/self/fd")?.saturating_sub(1);
        Some(Self { rss_kib, handles, threads: entries("/proc/self/task")? })
    }
}

impl Growth {
    /// How some numbers grow, of which the last may be larger by a share and by some more; none of too few.
    pub(crate) fn of(numbers: &[u64], share: f64, more: u64) -> Option<Self> {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss)]
        let warm = (numbers.len() as f64 * WARM_UP) as usize;
        let steady = numbers.get(warm..)?;
        let third = steady.len() / 3;
        if third < 3 {
            return None;
        }
        let middle = |part: &[u64]| {
            let mut part = part.to_vec();
            part.sort_unstable();
            part.get(part.len() / 2).copied().unwrap_or(0)
        };
        let (first, rest) = steady.split_at(third);
        let (second, last) = rest.split_at(third);
        let thirds = [middle(first), middle(second), middle(last)];
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss)]
        let allowed = (thirds[0] as f64 * share) as u64 + more;
        let grows = thirds[2] > thirds[0] + allowed && thirds[0] <= thirds[1] && thirds[1] <= thirds[2];
        Some(Self { thirds, allowed, grows })
    }
}

impl fmt::Display for Growth {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { thirds: [first, second, last], allowed, grows } = self;
        let verdict = if *grows { "grows" } else { "steady" };
        write!(f, "{first} → {second} → {last} (at most {allowed} more): {verdict}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_process_has_memory_handles_and_threads() {
        let held = Held::now().unwrap();
        assert!(held.rss_kib > 100 && held.handles >= 3 && held.threads >= 1, "{held:?}");
    }

    #[test]
    fn what_rises_steadily_grows_and_what_fills_and_stays_does_not() {
        let grows = |numbers: Vec<u64>| Growth::of(&numbers, 0.1, 10).unwrap().grows;
        assert!(grows((0..100).map(|n| 1_000 + 10 * n).collect()));
        assert!(!grows((0..100).map(|n| if n < 15 { 100 * n } else { 1_500 }).collect()));
        assert!(!grows((0..100).map(|n| 1_000 + n % 7).collect()));
        assert_eq!(Growth::of(&[1; 8], 0.1, 10), None);
    }
}
