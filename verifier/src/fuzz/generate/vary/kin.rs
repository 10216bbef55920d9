//! What is nearly the same: a copy that differs in one thing, one name for two things, and what another call asks.
//!
//! Who remembers an answer by less than all that decides it, who keeps two sorts of things in one table, and who checks
//! on one road what another takes unchecked: each is seen only where something nearly equal is asked beside.

use super::{NAMED, names, other_numbers, rename, within};
use crate::fuzz::generate::mutate::value;
use crate::fuzz::generate::{Draw, Tree};
use crate::fuzz::tree::{MAPS, Step, at, at_mut, own, places, text};
use crate::json::Json;
use crate::peer::Call;

/// The calls that ask for the same by another road, as often as each is to be taken.
pub(super) fn of(call: Call) -> &'static [Call] {
    match call {
        Call::ObservationUnpack => &[Call::BulkDecode, Call::BulkDecode, Call::ObservationPack],
        Call::BulkDecode => &[Call::ObservationUnpack],
        Call::ContractStatus | Call::Negotiate => &[Call::ContractVerify],
        Call::ContractVerify => &[Call::ContractStatus],
        Call::VersionCheck => &[Call::Negotiate],
        Call::Decode => &[Call::Encode, Call::ReplyCheck, Call::SessionRun, Call::BufferRun],
        Call::Encode | Call::ReplyCheck => &[Call::Decode],
        Call::SessionRun => &[Call::Decode, Call::ReplyCheck],
        Call::BufferRun => &[Call::Decode, Call::WatchdogRun, Call::GovernorRun],
        Call::WatchdogRun => &[Call::BufferRun],
        Call::GovernorRun => &[Call::LoopRun],
        Call::LoopRun => &[Call::GovernorRun, Call::ReflexStep],
        Call::ReflexStep => &[Call::LoopRun],
        Call::CodecEncode => &[Call::CodecDecode],
        Call::CodecDecode => &[Call::CodecEncode],
        Call::KeyBuild => &[Call::KeyMatch],
        Call::KeyMatch => &[Call::KeyBuild],
        _ => &[],
    }
}

/// Beside an item of an array one that differs from it in a single place.
pub(super) fn sibling(tree: &mut Tree, draw: &mut Draw<'_>) -> usize {
    let is_thing = |item: &Tree| matches!(item, Json::Object(members) if members.len() > 1);
    let arrays: Vec<Vec<Step>> = places(tree)
        .into_iter()
        .filter(|place| matches!(at(tree, place), Some(Json::Array(items)) if items.iter().any(is_thing)))
        .collect();
    let Some(place) = arrays.get(draw.below(arrays.len())) else { return 0 };
    let Some(Json::Array(items)) = at_mut(tree, place) else { return 0 };
    let things: Vec<usize> = (0..items.len()).filter(|nth| is_thing(&items[*nth])).collect();
    let at = things[draw.below(things.len())];
    let before = items[at].clone();
    let mut other = before.clone();
    for _ in 0..8 {
        if draw.chance(70) {
            value(&mut other, draw);
        } else {
            one_member_of_another(&mut other, &items[draw.below(items.len())], draw);
        }
        if other != before {
            break;
        }
    }
    // Where what it is the value of has a name of its own, both are in the answer.
    if draw.chance(40)
        && let Some(name) = ["population", "channel", "port", "name"].iter().find(|name| other.get(name).is_some())
        && let Some(old) = other.get(name).and_then(Json::as_str).map(str::to_owned)
    {
        rename(&mut other, &old, &format!("{old}2"));
    }
    let behind = if draw.chance(70) { at + 1 } else { at };
    items.insert(behind, other);
    1
}

/// One member becomes what the same member of another thing is.
fn one_member_of_another(thing: &mut Tree, other: &Tree, draw: &mut Draw<'_>) {
    let (Json::Object(members), Json::Object(others)) = (thing, other) else { return };
    let nth = draw.below(members.len());
    if let Some((_, value)) = others.iter().find(|(name, _)| *name == members[nth].0 && name != "op") {
        members[nth].1 = value.clone();
    }
}

/// One name becomes another that is there, wherever it stands.
pub(super) fn namesake(args: &mut Tree, draw: &mut Draw<'_>) -> usize {
    let mut known = Vec::new();
    names(args, "", &mut known);
    known.sort();
    known.dedup();
    if known.len() < 2 {
        return 0;
    }
    let old = known.remove(draw.below(known.len()));
    let new = known[draw.below(known.len())].clone();
    // Everywhere, or in one place alone.
    let mut left = if draw.chance(60) { usize::MAX } else { 1 + draw.below(3) };
    call_it(args, &old, &new, &mut left, "");
    if draw.chance(30) {
        within(args, draw, &mut |tree, _| {
            other_numbers(tree);
            1
        });
    }
    1
}

fn call_it(tree: &mut Tree, old: &str, new: &str, left: &mut usize, under: &str) {
    match tree {
        Json::Array(items) => items.iter_mut().for_each(|item| call_it(item, old, new, left, under)),
        Json::Object(members) => {
            for (name, value) in members {
                if *left > 0 && MAPS.contains(&under) && name == old {
                    *name = new.to_owned().into();
                    *left -= 1;
                }
                let inner = name.to_string();
                call_it(value, old, new, left, &inner);
            }
        }
        Json::String(written) if written.starts_with('{') => {
            let Some(mut frame) = Json::parse(written).ok().map(|frame| own(&frame)) else { return };
            let before = frame.clone();
            call_it(&mut frame, old, new, left, "");
            if frame != before {
                *tree = text(frame.to_string());
            }
        }
        Json::String(word) if *left > 0 && NAMED.contains(&under) && word == old => {
            *left -= 1;
            *tree = text(new);
        }
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fuzz::harvest::Harvest;
    use crate::fuzz::tree::items;

    fn read(written: &str) -> Tree {
        own(&Json::parse(written).unwrap())
    }

    #[test]
    fn a_sibling_differs_from_its_item_in_one_member_or_in_that_and_its_name() {
        let harvest = Harvest::default();
        let mapping = r#"{"channel":"a","component":0,"population":"p","min":-1.5,"max":1.5}"#;
        let mut of_one = [0; 5];
        for number in 0..300 {
            let mut tree = read(&format!("{{\"decoders\":[{mapping}]}}"));
            sibling(&mut tree, &mut Draw::new(6, number, &harvest));
            let both = items(tree.get("decoders"));
            assert_eq!(both.len(), 2, "{tree}");
            let members = ["channel", "component", "population", "min", "max"];
            let differing: Vec<usize> =
                (0..5).filter(|nth| both[0].get(members[*nth]) != both[1].get(members[*nth])).collect();
            assert!(differing.len() <= 2, "{tree}");
            if let [one] = differing[..] {
                of_one[one] += 1;
            }
        }
        assert!(of_one[1] > 5 && of_one[3] > 5 && of_one[4] > 5, "{of_one:?}");
    }

    #[test]
    fn a_name_becomes_another_everywhere_or_in_one_place() {
        let harvest = Harvest::default();
        let open = r#"{"record":{"targets":[{"port":"a"},{"port":"a"}]},"stimulus":{"targets":[{"port":"b"}]}}"#;
        let (mut everywhere, mut one_place) = (0, 0);
        for number in 0..200 {
            let mut tree = crate::fuzz::tree::object([("requests", crate::fuzz::tree::list(vec![text(open)]))]);
            namesake(&mut tree, &mut Draw::new(6, number, &harvest));
            let frame = items(tree.get("requests"))[0].as_str().unwrap().to_owned();
            let count = |name: &str| frame.matches(&format!("\"port\":\"{name}\"")).count();
            assert_eq!(count("a") + count("b"), 3, "{frame}");
            everywhere += usize::from(count("b") == 3);
            one_place += usize::from(count("b") == 2);
        }
        assert!(everywhere > 40 && one_place > 5, "{everywhere} {one_place}");
    }
}
