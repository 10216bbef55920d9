//! The smallest input that still shows a disagreement: fewer steps first, then fewer fields, then shorter strings and
//! simpler numbers.

use std::ops::ControlFlow;

use super::tree::{Step, Tree, at, at_mut, int, items, num, own, places, text};
use crate::json::Json;

/// Whether an input still shows it; or there is to be no further try.
pub(crate) type Shows = ControlFlow<(), bool>;

/// Takes a candidate in place of the input if it still shows the disagreement, and says whether it did.
type Attempt<'a> = dyn FnMut(Tree, &mut Tree) -> Shows + 'a;

/// Shrinks the arguments as long as `shows` holds, with at most so many tries. Whether it came to its end, so that
/// nothing that is left can be left out.
pub(crate) fn shrink(args: &mut Tree, most: usize, mut shows: impl FnMut(&Tree) -> Shows) -> bool {
    let mut tries = 0;
    let mut attempt = |candidate: Tree, args: &mut Tree| {
        if tries >= most {
            return ControlFlow::Break(());
        }
        tries += 1;
        let better = candidate != *args && shows(&candidate)?;
        if better {
            *args = candidate;
        }
        ControlFlow::Continue(better)
    };
    until_nothing_helps(args, &mut attempt).is_continue()
}

fn until_nothing_helps(args: &mut Tree, attempt: &mut Attempt<'_>) -> ControlFlow<()> {
    loop {
        let before = args.to_string();
        for name in ["steps", "requests"] {
            fewer_steps(args, name, attempt)?;
        }
        fewer_parts(args, attempt)?;
        simpler(args, attempt)?;
        if args.to_string() == before {
            return ControlFlow::Continue(());
        }
    }
}

/// Takes runs of steps away, half of them first, each alone last.
fn fewer_steps(args: &mut Tree, name: &str, attempt: &mut Attempt<'_>) -> ControlFlow<()> {
    let mut run = items(args.get(name)).len().div_ceil(2);
    while run > 0 {
        let mut from = items(args.get(name)).len();
        // From the end on: what comes last most often needs nothing behind it.
        while from > 0 {
            from = from.saturating_sub(run);
            let mut candidate = args.clone();
            without(&mut candidate, name, from, run);
            if name == "requests" {
                without(&mut candidate, "verbs", from, run);
            }
            attempt(candidate, args)?;
            from = from.min(items(args.get(name)).len());
        }
        run = if run == 1 { 0 } else { run.div_ceil(2) };
    }
    ControlFlow::Continue(())
}

fn without(args: &mut Tree, name: &str, from: usize, run: usize) {
    if let Json::Object(members) = args
        && let Some((_, Json::Array(items))) = members.iter_mut().find(|(known, _)| known == name)
    {
        let from = from.min(items.len());
        items.drain(from..(from + run).min(items.len()));
    }
}

/// Takes members and items away, and puts `null` for what is there.
fn fewer_parts(args: &mut Tree, attempt: &mut Attempt<'_>) -> ControlFlow<()> {
    let mut place = 0;
    loop {
        let all = places(args);
        let Some(here) = all.get(place) else { return ControlFlow::Continue(()) };
        let here = here.clone();
        place += 1;
        let length = match at(args, &here) {
            Some(Json::Array(items)) => items.len(),
            Some(Json::Object(members)) => members.len(),
            _ => continue,
        };
        let is_steps = here.len() == 1 && matches!(super::tree::name_at(args, &here), "steps" | "requests" | "verbs");
        if is_steps {
            continue;
        }
        let mut run = length.div_ceil(2);
        while run > 0 {
            let mut from = length;
            while from > 0 {
                from = from.saturating_sub(run);
                let mut candidate = args.clone();
                match at_mut(&mut candidate, &here) {
                    Some(Json::Array(items)) if from < items.len() => {
                        items.drain(from..(from + run).min(items.len()));
                    }
                    Some(Json::Object(members)) if from < members.len() => {
                        members.drain(from..(from + run).min(members.len()));
                    }
                    _ => continue,
                }
                attempt(candidate, args)?;
            }
            run = if run == 1 { 0 } else { run.div_ceil(2) };
        }
    }
}

/// Makes values simpler, those within a string of JSON too.
fn simpler(args: &mut Tree, attempt: &mut Attempt<'_>) -> ControlFlow<()> {
    let mut place = 0;
    loop {
        let all = places(args);
        let Some(here) = all.get(place) else { return ControlFlow::Continue(()) };
        let here = here.clone();
        place += 1;
        let Some(value) = at(args, &here).cloned() else { continue };
        if super::tree::name_at(args, &here) == "op" {
            continue;
        }
        match value {
            Json::Number(spelling) => {
                for simple in numbers(&spelling) {
                    if put(args, &here, simple, attempt)? {
                        break;
                    }
                }
            }
            Json::String(written) => strings(args, &here, &written, attempt)?,
            Json::Bool(true) => {
                put(args, &here, Json::Bool(false), attempt)?;
            }
            Json::Object(_) | Json::Array(_) if !here.is_empty() => {
                put(args, &here, Json::Null, attempt)?;
            }
            _ => {}
        }
    }
}

fn put(args: &mut Tree, here: &[Step], value: Tree, attempt: &mut Attempt<'_>) -> Shows {
    let mut candidate = args.clone();
    match at_mut(&mut candidate, here) {
        Some(target) if *target != value => *target = value,
        _ => return ControlFlow::Continue(false),
    }
    attempt(candidate, args)
}

/// Simpler numbers than this one, the simplest first.
fn numbers(spelling: &str) -> Vec<Tree> {
    let value: f64 = spelling.parse().unwrap_or(0.0);
    if !spelling.contains(['.', 'e', 'E']) {
        let value: i64 = spelling.parse().unwrap_or(0);
        let near = [0, 1, 2, value / 2, value - value.signum()];
        return near.into_iter().filter(|near| near.unsigned_abs() < value.unsigned_abs()).map(int).collect();
    }
    let size = |value: f64| (format!("{value:?}").len(), value.abs());
    let rounded = (0..8).map(|digits| format!("{value:.digits$e}").parse().unwrap_or(0.0));
    let near = [0.0, 1.0, 2.0, value.round(), value.abs()].into_iter().chain(rounded);
    near.filter(|near: &f64| near.is_finite() && size(*near) < size(value)).map(num).collect()
}

/// Shrinks a string: as JSON if it is some, as bytes if it is base64, as characters else.
fn strings(args: &mut Tree, here: &[Step], written: &str, attempt: &mut Attempt<'_>) -> ControlFlow<()> {
    if written.is_empty() || put(args, here, text(""), attempt)? {
        return ControlFlow::Continue(());
    }
    if let Ok(inner @ (Json::Object(_) | Json::Array(_))) = Json::parse(written) {
        let mut inner = own(&inner);
        let mut within = |candidate: Tree, known: &mut Tree| {
            let better = put(args, here, text(candidate.to_string()), attempt)?;
            if better {
                *known = candidate;
            }
            ControlFlow::Continue(better)
        };
        fewer_parts(&mut inner, &mut within)?;
        return simpler(&mut inner, &mut within);
    }
    let name = super::tree::name_at(args, here).to_owned();
    if matches!(name.as_str(), "block" | "base64") {
        use base64::Engine as _;
        use base64::engine::general_purpose::STANDARD;
        if let Ok(bytes) = STANDARD.decode(written) {
            pieces(&bytes, |kept| put(args, here, text(STANDARD.encode(kept)), attempt))?;
            return ControlFlow::Continue(());
        }
    }
    let characters: Vec<char> = written.chars().collect();
    let shortened = pieces(&characters, |kept| put(args, here, text(kept.iter().collect::<String>()), attempt))?;
    for place in 0..shortened.len() {
        let mut plain = shortened.clone();
        if plain[place].is_ascii_alphanumeric() {
            continue;
        }
        plain[place] = 'a';
        put(args, here, text(plain.into_iter().collect::<String>()), attempt)?;
    }
    ControlFlow::Continue(())
}

/// Takes runs of items away as long as `keeps` says so; what is left.
fn pieces<T: Clone>(all: &[T], mut keeps: impl FnMut(&[T]) -> Shows) -> ControlFlow<(), Vec<T>> {
    let mut left = all.to_vec();
    let mut run = left.len().div_ceil(2);
    while run > 0 {
        let mut from = left.len();
        while from > 0 {
            from = from.saturating_sub(run);
            let mut candidate = left.clone();
            candidate.drain(from..(from + run).min(candidate.len()));
            if candidate.len() < left.len() && keeps(&candidate)? {
                left = candidate;
            }
            from = from.min(left.len());
        }
        run = if run == 1 { 0 } else { run.div_ceil(2) };
    }
    ControlFlow::Continue(left)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fuzz::tree::{list, object, string};

    fn trace(seqs: &[i64]) -> Tree {
        let steps = seqs.iter().map(|seq| object([("op", text("frame")), ("seq", int(*seq)), ("x", num(1.2345678))]));
        object([("ref_loss", Json::Null), ("steps", list(steps.collect()))])
    }

    fn seqs(args: &Tree) -> Vec<i64> {
        items(args.get("steps")).iter().filter_map(|step| crate::fuzz::tree::integer(step.get("seq"))).collect()
    }

    #[test]
    fn superfluous_steps_go_and_each_that_is_left_is_needed() {
        // It shows with a 7 somewhere before a 9 and a 3 anywhere.
        let shows = |args: &Tree| {
            let seqs = seqs(args);
            let seven = seqs.iter().position(|seq| *seq == 7);
            let nine = seqs.iter().rposition(|seq| *seq == 9);
            seqs.contains(&3) && seven.zip(nine).is_some_and(|(seven, nine)| seven < nine)
        };
        let mut args = trace(&[1, 2, 7, 4, 3, 5, 5, 5, 9, 1, 2, 9, 3, 8]);
        assert!(shows(&args));
        assert!(shrink(&mut args, 5000, |args| ControlFlow::Continue(shows(args))));
        assert_eq!(seqs(&args).len(), 3, "{args}");
        for gone in 0..3 {
            let mut fewer = args.clone();
            without(&mut fewer, "steps", gone, 1);
            assert!(!shows(&fewer), "{args}");
        }
    }

    #[test]
    fn fields_strings_and_numbers_become_simple() {
        let mut args = object([
            ("text", text(r#"{"kind":"command_frame","seq":812,"more":[1,2,3],"t":1.25}"#)),
            ("name", text("abcXdef")),
            ("dt", num(0.123_456_789)),
        ]);
        let shows = |args: &Tree| {
            let frame = string(args, "text").and_then(|text| Json::parse(text).ok());
            frame.is_some_and(|frame| crate::fuzz::tree::integer(frame.get("seq")).is_some_and(|seq| seq > 5))
                && string(args, "name").is_some_and(|name| name.contains('X'))
        };
        shrink(&mut args, 5000, |args| ControlFlow::Continue(shows(args)));
        assert_eq!(string(&args, "name"), Some("X"));
        let frame = string(&args, "text").unwrap();
        assert!(!frame.contains("more") && !frame.contains("kind"), "{frame}");
        assert!(frame.len() < 12, "{frame}");
        assert!(args.get("dt").is_none());
    }

    #[test]
    fn no_more_is_tried_than_allowed() {
        let mut args = trace(&[1; 200]);
        let mut asked = 0;
        let is_smallest = shrink(&mut args, 50, |_| {
            asked += 1;
            ControlFlow::Continue(false)
        });
        assert!(!is_smallest && asked <= 50);
    }

    #[test]
    fn when_it_is_over_nothing_more_is_tried() {
        let mut args = trace(&[1; 200]);
        let mut asked = 0;
        let is_smallest = shrink(&mut args, 5000, |_| {
            asked += 1;
            if asked == 3 { ControlFlow::Break(()) } else { ControlFlow::Continue(false) }
        });
        assert!(!is_smallest && asked == 3);
    }
}
