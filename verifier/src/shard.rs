//! Parts of the cases, for several machines: `--shard 2/5`.
//!
//! The parts are disjoint and hold all cases between them. Which part a case is in depends on nothing but the cases,
//! and the parts are about as much work each: a request is dear by its length, and every case costs something.

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Serialize};

use crate::suite::Case;

/// What a case costs however short its request is, in bytes of a request.
const COST_OF_ANY: usize = 2048;
/// How many parts there may be.
const MOST: u32 = 10_000;

/// One of several parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Shard {
    /// Which, from 1.
    pub index: u32,
    /// Of how many.
    pub of: u32,
}

/// What is no shard.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("a part such as 2/5: the second of five; of at most {MOST}")]
pub struct ShardError;

impl Shard {
    /// The cases of this part, in the order in which they stand.
    #[must_use]
    pub fn pick<'c>(self, cases: &[&'c Case]) -> Vec<&'c Case> {
        let costs: Vec<usize> = cases.iter().map(|case| case.request_bytes() + COST_OF_ANY).collect();
        let parts = deal(&costs, self.of as usize);
        cases.iter().zip(parts).filter(|(_, part)| *part + 1 == self.index as usize).map(|(case, _)| *case).collect()
    }
}

impl FromStr for Shard {
    type Err = ShardError;

    fn from_str(text: &str) -> Result<Self, ShardError> {
        let (index, of) = text.split_once('/').ok_or(ShardError)?;
        let number = |text: &str| text.parse::<u32>().map_err(|_| ShardError);
        let shard = Self { index: number(index)?, of: number(of)? };
        if (1..=shard.of).contains(&shard.index) && shard.of <= MOST { Ok(shard) } else { Err(ShardError) }
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.of)
    }
}

/// To which part each goes: the dearest first, each to the part that has least so far.
fn deal(costs: &[usize], parts: usize) -> Vec<usize> {
    let mut dearest_first: Vec<usize> = (0..costs.len()).collect();
    // Stable, so that of equals the first comes first.
    dearest_first.sort_by_key(|place| std::cmp::Reverse(costs.get(*place)));
    let mut loads: std::collections::BinaryHeap<_> =
        (0..parts.max(1)).map(|part| std::cmp::Reverse((0, part))).collect();
    let mut dealt = vec![0; costs.len()];
    for place in dearest_first {
        let Some(std::cmp::Reverse((load, part))) = loads.pop() else { break };
        let cost = costs.get(place).copied().unwrap_or_default();
        if let Some(dealt) = dealt.get_mut(place) {
            *dealt = part;
        }
        loads.push(std::cmp::Reverse((load + cost, part)));
    }
    dealt
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::suite::Suite;

    #[test]
    fn a_part_is_written_as_its_number_and_how_many_there_are() {
        assert_eq!("2/5".parse(), Ok(Shard { index: 2, of: 5 }));
        assert_eq!(Shard { index: 2, of: 5 }.to_string(), "2/5");
        for bad in ["", "2", "0/5", "6/5", "0/0", "1/10001", "-1/5", "a/b", "1/2/3", "1/ 2"] {
            assert_eq!(bad.parse::<Shard>(), Err(ShardError), "{bad}");
        }
    }

    #[test]
    fn the_parts_of_the_corpus_hold_each_case_once_and_are_about_as_much_work() {
        let suite = Suite::embedded().unwrap();
        let all: Vec<&Case> = suite.cases().iter().collect();
        let cost = |cases: &[&Case]| cases.iter().map(|case| case.request_bytes() + COST_OF_ANY).sum::<usize>();
        for of in [1, 2, 3, 4] {
            let parts: Vec<_> = (1..=of).map(|index| Shard { index, of }.pick(&all)).collect();
            let mut ids: Vec<&str> = parts.iter().flatten().map(|case| case.id.as_str()).collect();
            assert_eq!(ids.len(), all.len());
            ids.sort_unstable();
            ids.dedup();
            assert_eq!(ids.len(), all.len());
            let costs: Vec<usize> = parts.iter().map(|part| cost(part)).collect();
            let (least, most) = (costs.iter().min().unwrap(), costs.iter().max().unwrap());
            assert!(most - least < cost(&all) / 20, "{costs:?}");
        }
    }

    proptest! {
        #[test]
        fn no_part_has_more_than_another_by_more_than_the_dearest(
            costs in prop::collection::vec(1_usize..1000, 0..60), parts in 1_usize..9
        ) {
            let dealt = deal(&costs, parts);
            prop_assert_eq!(&dealt, &deal(&costs, parts));
            let of = |part: usize| dealt.iter().zip(&costs).filter(move |(of, _)| **of == part);
            let load = |part| of(part).map(|(_, cost)| cost).sum::<usize>();
            let loads: Vec<usize> = (0..parts).map(load).collect();
            prop_assert_eq!(loads.iter().sum::<usize>(), costs.iter().sum::<usize>());
            let most = costs.iter().max().copied().unwrap_or_default();
            prop_assert!(loads.iter().max() <= loads.iter().min().map(|least| least + most).as_ref());
        }
    }
}
