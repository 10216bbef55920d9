//! An input that was kept since its answers reached something new, changed in a few places.

use super::{Draw, Input, Tree};
use crate::fuzz::tree::{Step, at, at_mut, int, literal, num, own, places, text};
use crate::json::Json;

/// A changed copy. `other` is another input that was kept, of the same call: steps of it may be taken over.
pub(crate) fn mutate(input: &Input, other: Option<&Input>, draw: &mut Draw<'_>) -> Input {
    let mut args = input.args.clone();
    for _ in 0..=draw.below(4) {
        if draw.chance(40) {
            let name = if args.get("requests").is_some() { "requests" } else { "steps" };
            steps(&mut args, name, other, draw);
        } else {
            value(&mut args, draw);
        }
    }
    Input { call: input.call, args }
}

/// Changes the order, the number or the origin of the steps.
fn steps(args: &mut Tree, name: &str, other: Option<&Input>, draw: &mut Draw<'_>) {
    let foreign = other.and_then(|other| match other.args.get(name) {
        Some(Json::Array(steps)) => steps.get(draw.below(steps.len())).cloned(),
        _ => None,
    });
    let Json::Object(members) = args else { return };
    let Some((_, Json::Array(steps))) = members.iter_mut().find(|(known, _)| known == name) else { return };
    if steps.is_empty() || steps.len() > 2000 {
        return;
    }
    let (a, b) = (draw.below(steps.len()), draw.below(steps.len()));
    match draw.below(5) {
        0 => drop(steps.remove(a)),
        1 => steps.swap(a, b),
        2 => {
            // Counters and age: the same for long.
            let again = if draw.chance(20) { draw.size(2, 200) } else { 2 };
            let step = steps[a].clone();
            steps.splice(a..a, std::iter::repeat_n(step, again));
        }
        3 => {
            let (from, to) = (a.min(b), a.max(b));
            let run: Vec<Tree> = steps[from..to.min(from + 64)].to_vec();
            steps.extend(run);
        }
        _ => steps.insert(b, foreign.unwrap_or_else(|| steps[a].clone())),
    }
}

/// Changes a number, a string or a member somewhere.
pub(super) fn value(args: &mut Tree, draw: &mut Draw<'_>) {
    let all = places(args);
    let place = all[draw.below(all.len())].clone();
    let elsewhere = all[draw.below(all.len())].clone();
    let same =
        at(args, &elsewhere).filter(|found| at(args, &place).is_some_and(|here| here.kind() == found.kind())).cloned();
    // What is written within a string is changed in there.
    if let Some(Json::String(written)) = at(args, &place)
        && written.starts_with('{')
        && let Ok(inner) = Json::parse(written)
    {
        let mut inner = own(&inner);
        value(&mut inner, draw);
        let written = text(inner.to_string());
        if let Some(target) = at_mut(args, &place) {
            *target = written;
        }
        return;
    }
    if leads_to_op(args, &place) {
        return;
    }
    let Some(target) = at_mut(args, &place) else { return };
    match target {
        Json::Number(spelling) => {
            let integer = !spelling.contains(['.', 'e', 'E']);
            let value: f64 = spelling.parse().unwrap_or(0.0);
            *target = if integer {
                let near: i64 = spelling.parse().unwrap_or(0);
                let drawn = if draw.chance(60) { near.saturating_add(draw.range(-2, 2)) } else { draw.integer() };
                int(drawn.clamp(-crate::fuzz::draw::LARGEST, crate::fuzz::draw::LARGEST))
            } else if draw.chance(60) {
                finite(draw.neighbour(value))
            } else {
                finite(draw.finite())
            };
        }
        Json::Bool(value) => *value = !*value,
        Json::String(_) | Json::Array(_) | Json::Object(_) | Json::Null => {
            if let Some(same) = same.filter(|same| same.to_string().len() < 4096) {
                *target = same;
            }
        }
    }
}

fn finite(value: f64) -> Tree {
    if value.is_finite() && !(value == 0.0 && value.is_sign_negative()) { num(value) } else { literal("1.0") }
}

/// Whether a place is the name of a step, without which it is none.
fn leads_to_op(args: &Tree, place: &[Step]) -> bool {
    crate::fuzz::tree::name_at(args, place) == "op"
}
