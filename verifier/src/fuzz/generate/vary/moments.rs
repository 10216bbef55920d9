//! When something happens, and what happened before: gaps, instants at which a deadline falls, and steps that leave
//! something behind.

use super::{clock_of, each_double, graft, later, steps_of, within};
use crate::fuzz::draw::LARGEST;
use crate::fuzz::generate::mutate::value;
use crate::fuzz::generate::{Draw, Tree};
use crate::fuzz::tree::{Step, at_mut, double, name_at, num, places, set};
use crate::json::Json;

/// After so many seconds a clock begins anew: an hour, a day, a week, the weeks of a satellite, and what wide
/// counters of microseconds and nanoseconds hold.
const PERIODS: [f64; 8] = [
    3600.0,
    86_400.0,
    604_800.0,
    619_315_200.0,
    9_007_199_254.740_992,
    9.223_372_036_854_776e9,
    1.844_674_407_370_955_2e10,
    1.844_674_407_370_955e13,
];

/// From a step on everything is later, has later seqs, or both; how much, as a power of two.
pub(super) fn gap(args: &mut Tree, draw: &mut Draw<'_>) -> usize {
    let Some(steps) = steps_of(args).filter(|steps| steps.len() > 1) else { return 0 };
    let from = 1 + draw.below(steps.len() - 1);
    // Where narrow counters of units of time or of seqs begin anew, more often.
    let power = if draw.chance(40) { draw.one(&[8, 16, 24, 31, 32]) } else { draw.below(52) };
    let by = (1_i64 << power).saturating_add(draw.range(-1, 1));
    let (clock, seqs) = draw.one(&[(true, false), (true, false), (true, true), (false, true)]);
    let has_clock = steps.iter().any(|step| clock_of(step).is_some());
    let seconds = match (clock && has_clock, draw.below(5)) {
        (false, _) => 0.0,
        (_, 4) => draw.one(&PERIODS),
        (_, 0) => 10_f64.powi(i32::try_from(draw.below(9)).unwrap_or(0)),
        // Milliseconds of a wide count, more often than what a narrow one ends at.
        (_, 1) => by as f64,
        (_, 2) => by as f64 / draw.one(&[1e6, 1e9]),
        _ => by as f64 / 1000.0,
    };
    let seqs = if seqs || !has_clock { by.min(LARGEST) } else { 0 };
    let sign = if draw.chance(8) { -1 } else { 1 };
    steps[from..].iter_mut().for_each(|step| later(step, seconds * sign as f64, seqs * sign));
    power
}

/// A step at the instant at which a time that stands in the arguments ends, or next to it.
pub(super) fn instant(args: &mut Tree, draw: &mut Draw<'_>) -> usize {
    let mut spans: Vec<f64> = Vec::new();
    each_double(args, &mut |name, value| {
        if name.ends_with("_ms") && value.is_finite() && value != 0.0 && spans.len() < 400 {
            spans.push(value / 1000.0);
        }
        None
    });
    let Some(steps) = steps_of(args) else { return 0 };
    let clocked: Vec<usize> = (0..steps.len()).filter(|nth| clock_of(&steps[*nth]).is_some()).collect();
    if clocked.is_empty() {
        return 0;
    }
    let at = clocked[draw.below(clocked.len())];
    let back = draw.one(&[0, 0, 1, 1, 2, 4]);
    let earlier: Vec<usize> = clocked.iter().copied().filter(|nth| *nth <= at).collect();
    let of = earlier[earlier.len().saturating_sub(1 + back)];
    let told = double(steps[of].get("last_sensor_s")).filter(|told| told.is_finite() && draw.chance(40));
    let Some(began) = told.or_else(|| clock_of(&steps[of])) else { return 0 };
    let span = if spans.is_empty() { 0.5 } else { spans[draw.below(spans.len())] };
    let times = match draw.below(6) {
        0..=2 => 1.0,
        3 => draw.one(&[0.0, 0.5, 2.0]),
        _ => draw.size(1, 64) as f64,
    };
    let end = began + span * times;
    let digits = draw.below(12);
    let little = 10_f64.powi(-i32::try_from(digits).unwrap_or(0)) * draw.one(&[1.0, 0.5, 2.0]);
    let now = match draw.below(8) {
        0 => end,
        1 => end.next_up(),
        2 => end.next_down(),
        3..=5 => end + little,
        _ => end - little,
    };
    if !now.is_finite() {
        return 0;
    }
    let mut step = steps[at].clone();
    set(&mut step, "now_s", num(now));
    if draw.chance(50) {
        // Between those that are there, or in place of one, so that what follows is later.
        let place = clocked.iter().copied().find(|nth| clock_of(&steps[*nth]).is_some_and(|clock| clock > now));
        steps.insert(place.unwrap_or(steps.len()), step);
    } else {
        let more = now - clock_of(&steps[at]).unwrap_or(now);
        steps[at] = step;
        if draw.chance(70) {
            steps[at + 1..].iter_mut().for_each(|step| later(step, more, 0));
        }
    }
    1 + digits
}

/// Before a step nearly the same one, by which something may stay behind.
pub(super) fn residue(args: &mut Tree, other: &Tree, draw: &mut Draw<'_>) -> usize {
    let Some(steps) = steps_of(args).filter(|steps| !steps.is_empty()) else { return 0 };
    let at = draw.below(steps.len());
    let mut step = steps[at].clone();
    let mut changes = 0;
    for _ in 0..=draw.below(3) {
        changes += match draw.below(4) {
            0 => {
                value(&mut step, draw);
                1
            }
            1 => within(&mut step, draw, &mut |tree, draw| graft(tree, other, draw)),
            _ => within(&mut step, draw, &mut omit),
        };
    }
    // As often the poorer one comes second.
    let (before, behind) = if draw.chance(50) { (step, steps[at].clone()) } else { (steps[at].clone(), step) };
    steps[at] = behind;
    steps.insert(at, before);
    let pause = draw.one(&[0.0, 0.001, 0.0625]);
    if draw.chance(80) {
        steps[at + 1..].iter_mut().for_each(|step| later(step, pause, 1));
    }
    changes
}

/// A member less, within what may lack some.
pub(super) fn omit(tree: &mut Tree, draw: &mut Draw<'_>) -> usize {
    const NEEDED: [&str; 9] = ["op", "steps", "requests", "kind", "call", "key", "text", "base64", "now_s"];
    let objects: Vec<Vec<Step>> = places(tree)
        .into_iter()
        .filter(
            |place| matches!(crate::fuzz::tree::at(tree, place), Some(Json::Object(members)) if !members.is_empty()),
        )
        .collect();
    for _ in 0..4 {
        let Some(place) = objects.get(draw.below(objects.len())) else { return 0 };
        let name = name_at(tree, place).to_owned();
        let Some(Json::Object(members)) = at_mut(tree, place) else { continue };
        let gone = draw.below(members.len());
        if !NEEDED.contains(&members[gone].0.as_ref()) && name != "params" {
            if draw.chance(30) {
                members[gone].1 = Json::Null;
            } else {
                members.remove(gone);
            }
            return 1;
        }
    }
    0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fuzz::harvest::Harvest;
    use crate::fuzz::tree::{int, items, list, object, text};

    fn trace() -> Tree {
        let command = |now: f64, seq: i64| {
            object([("op", text("command")), ("now_s", num(now)), ("ttl_ms", num(250.0)), ("seq", int(seq))])
        };
        object([("steps", list(vec![command(1.0, 1), command(2.0, 2), command(3.0, 3)]))])
    }

    fn clocks(args: &Tree) -> Vec<f64> {
        items(args.get("steps")).iter().filter_map(clock_of).collect()
    }

    #[test]
    fn a_gap_leaves_what_is_before_it_and_moves_the_rest_together() {
        let harvest = Harvest::default();
        let mut widest: f64 = 0.0;
        for number in 0..200 {
            let mut args = trace();
            gap(&mut args, &mut Draw::new(1, number, &harvest));
            let now = clocks(&args);
            assert_eq!((now.len(), now[0]), (3, 1.0));
            let (one, two) = (now[1] - now[0], now[2] - now[1]);
            assert!((one - 1.0).abs() < 1e-9 || (two - 1.0).abs() < 1e-9 || one.abs() > 1e15, "{now:?}");
            widest = widest.max(one).max(two);
        }
        assert!(widest > 4_294_967.296, "{widest}");
    }

    #[test]
    fn an_instant_is_the_end_of_a_ttl_or_next_to_it() {
        let harvest = Harvest::default();
        let (mut exact, mut near) = (0, 0);
        for number in 0..400 {
            let mut args = trace();
            instant(&mut args, &mut Draw::new(1, number, &harvest));
            let ends = [1.25, 2.25, 3.25];
            exact += usize::from(clocks(&args).iter().any(|now| ends.contains(now)));
            let is_near = |now: &f64| ends.iter().any(|end| *now != *end && (now - end).abs() <= 1e-3);
            near += usize::from(clocks(&args).iter().any(is_near));
        }
        assert!(exact > 20 && near > 100, "{exact} {near}");
    }

    #[test]
    fn what_may_stay_behind_comes_before_a_step_that_is_there() {
        let harvest = Harvest::default();
        for number in 0..100 {
            let mut args = trace();
            residue(&mut args, &trace(), &mut Draw::new(1, number, &harvest));
            assert_eq!(items(args.get("steps")).len(), 4, "{number}");
        }
    }
}
