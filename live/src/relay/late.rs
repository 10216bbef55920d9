//! What is due at a time.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap};
use std::time::{Duration, Instant};

/// The most that waits; a flood beyond is lost.
const MOST: usize = 1 << 16;

/// Things that wait for their time; of those with the same time, the first comes first.
pub(super) struct Late<T> {
    times: BinaryHeap<Reverse<(Instant, u64)>>,
    things: BTreeMap<u64, T>,
    count: u64,
}

impl<T> Late<T> {
    pub(super) const fn new() -> Self {
        Self { times: BinaryHeap::new(), things: BTreeMap::new(), count: 0 }
    }

    /// Lets a thing wait.
    pub(super) fn push(&mut self, due: Instant, thing: T) {
        if self.things.len() < MOST {
            self.count += 1;
            self.times.push(Reverse((due, self.count)));
            self.things.insert(self.count, thing);
        }
    }

    /// The next thing whose time has come.
    pub(super) fn pop(&mut self, now: Instant) -> Option<T> {
        let Reverse((due, number)) = *self.times.peek()?;
        if due > now {
            return None;
        }
        self.times.pop();
        self.things.remove(&number)
    }

    /// How long nothing is due, but at most so long.
    pub(super) fn rest(&self, longest: Duration) -> Duration {
        let next = self.times.peek().map(|Reverse((due, _))| due.saturating_duration_since(Instant::now()));
        next.unwrap_or(longest).min(longest)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_due_comes_by_its_time_and_then_in_order() {
        let now = Instant::now();
        let later = now + Duration::from_millis(5);
        let mut late = Late::new();
        for (due, thing) in [(later, 'c'), (now, 'a'), (now, 'b'), (later, 'd')] {
            late.push(due, thing);
        }
        assert_eq!((late.pop(now), late.pop(now), late.pop(now)), (Some('a'), Some('b'), None));
        assert_eq!((late.pop(later), late.pop(later), late.pop(later)), (Some('c'), Some('d'), None));
    }
}
