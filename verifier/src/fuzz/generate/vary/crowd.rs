//! Many of a kind: sessions, channels, entries and declarations, each with a name of its own, or all with one.

use super::{NAMED, other_numbers, rename, steps_of, within};
use crate::fuzz::generate::{Draw, Tree};
use crate::fuzz::tree::{MAPS, Step, at, at_mut, own, places, set, string, text};
use crate::json::Json;

/// How many bytes the copies have together at most, and where there are more than an implementation would keep.
const ROOM: usize = 200_000;
const GIANT: usize = 3 << 20;

/// A thing that has a name, many times; how many.
pub(super) fn crowd(args: &mut Tree, draw: &mut Draw<'_>) -> usize {
    if args.get("requests").is_some() && draw.chance(60) {
        return sessions(args, draw);
    }
    within(args, draw, &mut things)
}

/// An item of an array or an entry of a map that has a name.
fn things(tree: &mut Tree, draw: &mut Draw<'_>) -> usize {
    let is_thing = |item: &Tree| NAMED.iter().any(|name| string(item, name).is_some());
    let sites: Vec<Vec<Step>> = places(tree)
        .into_iter()
        .filter(|place| match at(tree, place) {
            Some(Json::Array(items)) => items.iter().any(is_thing),
            Some(Json::Object(members)) => {
                !members.is_empty() && MAPS.contains(&crate::fuzz::tree::name_at(tree, place))
            }
            _ => false,
        })
        .collect();
    let Some(place) = sites.get(draw.below(sites.len())) else { return 0 };
    let (same, spread, other) = (draw.chance(30), draw.one(&['c', '~', '0']), draw.chance(60));
    let (count, room) = match draw.giant() {
        Some(count) => (count, GIANT),
        None if draw.chance(33) => (1 + draw.below(4), ROOM),
        None => (draw.size(1, 700), ROOM),
    };
    let front = draw.chance(50);
    match at_mut(tree, place) {
        Some(Json::Array(items)) => {
            let named: Vec<usize> = (0..items.len()).filter(|nth| is_thing(&items[*nth])).collect();
            let at = named[draw.below(named.len())];
            let item = items[at].clone();
            let count = count.min(room / item.to_string().len().max(1)).max(1);
            let copy = |nth: usize| {
                let mut copy = item.clone();
                if let Some(name) = NAMED.iter().find(|name| string(&copy, name).is_some()).filter(|_| !same) {
                    let old = string(&copy, name).unwrap_or_default().to_owned();
                    rename(&mut copy, &old, &format!("{old}{spread}{nth}"));
                }
                if other {
                    other_numbers(&mut copy);
                }
                copy
            };
            let copies: Vec<Tree> = (0..count).map(copy).collect();
            let at = if front { at } else { items.len() };
            items.splice(at..at, copies);
            count
        }
        Some(Json::Object(members)) => {
            let (name, value) = members[draw.below(members.len())].clone();
            let count = count.min(room / value.to_string().len().max(1)).max(1);
            let mut changed = value.clone();
            if other {
                other_numbers(&mut changed);
            }
            let names = (0..count).map(|nth| match spread {
                'c' => format!("{name}{nth}"),
                spread => format!("{spread}{nth}"),
            });
            let copies: Vec<_> = names.map(|name| (name.into(), changed.clone())).collect();
            let at = if front { 0 } else { members.len() };
            members.splice(at..at, copies);
            count
        }
        _ => 0,
    }
}

/// Every session many times, with ids of their own: by turns, one after the other, or around the first.
fn sessions(args: &mut Tree, draw: &mut Draw<'_>) -> usize {
    let Some(requests) = steps_of(args).filter(|requests| !requests.is_empty()) else { return 0 };
    let frames: Vec<Option<Tree>> =
        requests.iter().map(|request| Json::parse(request.as_str()?).ok().map(|frame| own(&frame))).collect();
    let bytes: usize = requests.iter().map(|request| request.to_string().len()).sum();
    let (count, room) = draw.giant().map_or_else(|| (draw.size(1, 300), ROOM), |count| (count, GIANT));
    let count = count.min(room / bytes.max(1)).max(1);
    let spread = draw.one(&["", "x", "-"]);
    let of = |nth: usize, frame: &Option<Tree>, request: &Tree| {
        let Some(mut frame) = frame.clone().filter(|_| nth > 0) else { return request.clone() };
        let Some(id) = string(&frame, "session_id").map(|id| format!("{id}{spread}{nth}")) else {
            return request.clone();
        };
        set(&mut frame, "session_id", text(id));
        text(frame.to_string())
    };
    let both = frames.iter().zip(requests.iter());
    let all: Vec<Tree> = match draw.below(3) {
        // All open, then all go on, and so forth.
        0 => both.flat_map(|(frame, request)| (0..=count).map(move |nth| of(nth, frame, request))).collect(),
        1 => (0..=count).flat_map(|nth| both.clone().map(move |(frame, request)| of(nth, frame, request))).collect(),
        // The first begins, the others come and go, and the first goes on.
        _ => {
            let cut = 1 + draw.below(requests.len());
            let head = both.clone().take(cut).map(|(frame, request)| of(0, frame, request));
            let others = (1..=count).flat_map(|nth| both.clone().map(move |(frame, request)| of(nth, frame, request)));
            head.chain(others).chain(requests[cut..].iter().cloned()).collect()
        }
    };
    *requests = all;
    // Where a request says at which key it comes, it says so for as many.
    if let Json::Object(members) = args {
        members.retain(|(name, _)| name != "verbs");
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fuzz::harvest::Harvest;
    use crate::fuzz::tree::{items, list, object};

    #[test]
    fn a_crowd_of_sessions_has_as_many_ids_and_the_requests_of_each_in_their_order() {
        let request = |kind: &str| text(format!("{{\"kind\":\"{kind}\",\"session_id\":\"a\"}}"));
        let kinds = ["open_session", "step_request", "close_session"];
        let harvest = Harvest::default();
        let mut largest = 0;
        for number in 0..60 {
            let mut args = object([("requests", list(kinds.map(request).to_vec()))]);
            let count = sessions(&mut args, &mut Draw::new(3, number, &harvest));
            let mut of: std::collections::BTreeMap<String, Vec<String>> = std::collections::BTreeMap::new();
            for request in items(args.get("requests")) {
                let frame = own(&Json::parse(request.as_str().unwrap()).unwrap());
                let of_id = of.entry(string(&frame, "session_id").unwrap().to_owned()).or_default();
                of_id.push(string(&frame, "kind").unwrap().to_owned());
            }
            assert_eq!(of.len(), count + 1);
            assert!(of.values().all(|found| *found == kinds), "{of:?}");
            largest = largest.max(count);
        }
        assert!(largest > 32, "{largest}");
    }

    #[test]
    fn a_crowd_of_things_has_names_of_their_own_or_all_the_same() {
        let harvest = Harvest::default();
        let (mut own_names, mut same) = (0, 0);
        for number in 0..60 {
            let mut tree = object([("sensor_channels", list(vec![object([("name", text("pose"))])]))]);
            let count = things(&mut tree, &mut Draw::new(3, number, &harvest));
            let names: std::collections::HashSet<&str> =
                items(tree.get("sensor_channels")).iter().filter_map(|item| string(item, "name")).collect();
            own_names += usize::from(names.len() == count + 1);
            same += usize::from(names.len() == 1);
        }
        assert!(own_names > 20 && same > 5 && own_names + same == 60, "{own_names} {same}");
    }
}
