//! Long runs of items in the lists of a case, and of steps that one rule decides, each written once.

use std::collections::BTreeMap;

use crate::json::{Json, object};

/// What follows the first item of a run is written out as long as it has no more characters together.
const WRITTEN_OUT: usize = 200;

/// How many items a round has at most, and how many rounds are written out.
const ROUND: usize = 8;
const FEW: usize = 8;
/// Doubles that are multiples of this and below [`FAR`] add up without rounding.
const FINE: f64 = 1.0 / 1024.0;
const FAR: f64 = 1_048_576.0;

/// The value with each long run in the lists of its members of these names as one item: equal ones as
/// `{"$item": …, "times": …}`, and those in which numbers grow by the same from each to the next as
/// `{"$item": …, "times": …, "plus": {…}}`; so do those in whose JSON texts one grows. Rounds of several items are
/// `{"$items": […], "times": …, "plus": [{…}, …]}`.
pub(crate) fn of_arguments(value: Json, lists: &[&str]) -> Json {
    let run = |items: &[Json]| longest([rounds(items, true), equal(items), growing(items)]);
    written(value, false, &|name| lists.contains(&name), &run)
}

/// The pattern with each long run of equal items as one `{"$item": …, "times": …}`, and equal rounds of several as one
/// `{"$items": […], "times": …}`.
pub(crate) fn of_pattern(value: Json) -> Json {
    written(value, false, &|_| true, &|items| longest([rounds(items, false), equal(items)]))
}

/// The rules by the places that they decide, with steps at equal distances as one place: `/steps/*1-99+2` stands for
/// every second step from 1 to 99.
pub(crate) fn of_places(by: BTreeMap<String, &'static str>) -> BTreeMap<String, &'static str> {
    let mut steps: BTreeMap<&'static str, Vec<usize>> = BTreeMap::new();
    let mut places = BTreeMap::new();
    for (place, rule) in by {
        match place.strip_prefix(STEPS).and_then(|step| step.parse().ok()) {
            Some(step) => steps.entry(rule).or_default().push(step),
            None => _ = places.insert(place, rule),
        }
    }
    for (rule, mut steps) in steps {
        steps.sort_unstable();
        while let Some((first, apart, count)) = from_the_first(&steps) {
            let last = first + (count - 1) * apart;
            let place = if count == 1 { format!("{STEPS}{first}") } else { format!("{STEPS}*{first}-{last}+{apart}") };
            places.insert(place, rule);
            steps.retain(|step| *step > last || (step - first) % apart != 0);
        }
    }
    places
}

/// Where the steps of a trace stand.
const STEPS: &str = "/steps/";

/// The longest run from the first of ascending steps on: where it begins, how far apart its steps are, and how many
/// they are; one, where there is no long run.
fn from_the_first(steps: &[usize]) -> Option<(usize, usize, usize)> {
    let first = *steps.first()?;
    let apart = steps.iter().skip(1).take(ROUND).map(|step| step - first);
    let count = |apart: &usize| {
        let next = |count| steps.binary_search(&(first + count * apart)).is_ok();
        (1..).find(|count| !next(*count)).unwrap_or(1)
    };
    let longest = apart.map(|apart| (first, apart, count(&apart))).max_by_key(|(.., count)| *count);
    Some(longest.filter(|(.., count)| *count > FEW).unwrap_or((first, 1, 1)))
}

/// How many items a run has, and what stands for it.
type Run = (usize, Json);

/// The run of the most items, of several the last.
fn longest<const N: usize>(runs: [Option<Run>; N]) -> Option<Run> {
    runs.into_iter().flatten().max_by_key(|(count, _)| *count)
}

fn written(value: Json, is_list: bool, lists: &dyn Fn(&str) -> bool, run: &dyn Fn(&[Json]) -> Option<Run>) -> Json {
    match value {
        Json::Object(members) => {
            let member = |(name, value): (String, Json)| {
                // A word of a pattern stands for the member around it; what it chooses from is no list.
                let is_list = if name.starts_with('$') { is_list && name != "$any" } else { lists(&name) };
                let value = written(value, is_list, lists, run);
                (name, value)
            };
            Json::Object(members.into_iter().map(member).collect())
        }
        Json::Array(items) => {
            let items: Vec<Json> = items.into_iter().map(|item| written(item, is_list, lists, run)).collect();
            if !is_list {
                return Json::Array(items);
            }
            let (mut rest, mut kept) = (items.as_slice(), Vec::new());
            while let [first, behind @ ..] = rest {
                let (count, item) = run(rest).unwrap_or_else(|| (1, first.clone()));
                kept.push(item);
                rest = behind.get(count - 1..).unwrap_or_default();
            }
            Json::Array(kept)
        }
        scalar => scalar,
    }
}

/// The run of equal items at the head of a list, if it is long.
fn equal(items: &[Json]) -> Option<Run> {
    let first = items.first()?;
    let count = items.iter().take_while(|item| *item == first).count();
    is_long(first, count).then(|| (count, times(first, count)))
}

/// By how much the members of each item grow from one round to the next, if nothing else tells the rounds apart.
fn growth_of_round<'j>(one: &'j [Json], next: &[Json]) -> Option<Vec<Vec<(&'j str, Json)>>> {
    let both = one.iter().zip(next);
    both.map(|(one, next)| if one == next { Some(Vec::new()) } else { growth(one, next) }).collect()
}

/// The rounds at the head of a list, equal or each growing by the same from one to the next, if they are many and long.
fn rounds(items: &[Json], may_grow: bool) -> Option<Run> {
    (2..=ROUND).find_map(|length| {
        let (first, rest) = items.split_at_checked(length)?;
        let second = rest.get(..length)?;
        let plus = growth_of_round(first, second)?;
        let grows = plus.iter().any(|plus| !plus.is_empty());
        let pairs = items.chunks_exact(length).zip(rest.chunks_exact(length));
        let count = 1 + pairs.take_while(|(one, next)| growth_of_round(one, next).as_ref() == Some(&plus)).count();
        let written: usize = first.iter().map(|item| item.text().len()).sum();
        if count <= FEW || (count - 1) * written <= WRITTEN_OUT || grows && !may_grow {
            return None;
        }
        let run = object! { "$items" => Json::Array(first.to_vec()), "times" => Json::literal(count.to_string()) };
        let objects = || plus.iter().map(|plus| Json::Object(named(plus.clone()))).collect();
        Some((count * length, if grows { run.with("plus", objects()) } else { run }))
    })
}

fn named(plus: Vec<(&str, Json)>) -> Vec<(String, Json)> {
    plus.into_iter().map(|(name, by)| (name.to_owned(), by)).collect()
}

/// The run at the head of a list in which numbers grow by the same from each item to the next, if it is long.
fn growing(items: &[Json]) -> Option<Run> {
    let [first, second, ..] = items else { return None };
    let growth = |one: &Json, next: &Json| match one {
        Json::Object(_) | Json::String(_) => growth_of(one, next),
        _ => None,
    };
    let plus = growth(first, second)?;
    let pairs = items.iter().zip(items.iter().skip(1));
    let count = 1 + pairs.take_while(|(one, next)| growth(one, next).as_ref() == Some(&plus)).count();
    is_long(first, count).then(|| (count, times(first, count).with("plus", plus)))
}

fn is_long(first: &Json, count: usize) -> bool {
    count.saturating_sub(1) * first.text().len() > WRITTEN_OUT
}

fn times(first: &Json, count: usize) -> Json {
    object! { "$item" => first.clone(), "times" => Json::literal(count.to_string()) }
}

/// By how much which members grow from one object to the next, if nothing else tells them apart.
fn growth<'j>(one: &'j Json, next: &Json) -> Option<Vec<(&'j str, Json)>> {
    let (Json::Object(one), Json::Object(next)) = (one, next) else { return None };
    let mut plus = Vec::new();
    if one.len() != next.len() || one.iter().any(|(name, _)| name.starts_with('$')) {
        return None;
    }
    for ((name, value), (next_name, next_value)) in one.iter().zip(next) {
        if name != next_name {
            return None;
        }
        if value != next_value {
            plus.push((name.as_str(), growth_of(value, next_value)?));
        }
    }
    (!plus.is_empty()).then_some(plus)
}

/// By how much a number grows, or those of an object, or the first integer that differs in a JSON text, by its name.
fn growth_of(value: &Json, next: &Json) -> Option<Json> {
    if matches!(value, Json::Object(_)) {
        return growth(value, next).map(|plus| Json::Object(named(plus)));
    }
    let by = |one: i64, next: i64| Some(Json::literal(next.checked_sub(one)?.to_string()));
    let (Json::String(text), Json::String(next)) = (value, next) else {
        return match (integer(value), integer(next)) {
            (Some(one), Some(next)) => by(one, next),
            _ => Some(Json::literal(format!("{:?}", double(next)? - double(value)?))),
        };
    };
    // What has the same bytes before the name has it in the same place.
    let alike = text.bytes().zip(next.bytes()).take_while(|(one, other)| one == other).count();
    let named = text.get(..alike)?.rfind("\":")?;
    let name = text.get(..named)?.rsplit('"').next()?;
    let begins = named + 2;
    let is_first = text.find(&format!("\"{name}\":")) == Some(begins.checked_sub(name.len() + 3)?);
    let (one, behind) = integer_at(text, begins)?;
    let (other, next_behind) = integer_at(next, begins)?;
    let grown = by(one, other).filter(|_| is_first && behind == next_behind)?;
    Some(object! { name => grown })
}

/// The integer that begins at a place of a text, spelled as one, and what stands behind it.
fn integer_at(text: &str, begins: usize) -> Option<(i64, &str)> {
    let rest = text.get(begins..)?;
    let (spelled, behind) = rest.split_at(rest.find(|c: char| !c.is_ascii_digit() && c != '-').unwrap_or(rest.len()));
    let integer = integer(&Json::literal(spelled.to_owned()))?;
    (!behind.starts_with(['.', 'e', 'E'])).then_some((integer, behind))
}

/// A double that is spelled as the shortest that is one, and short enough that many add up without rounding.
fn double(value: &Json) -> Option<f64> {
    let Json::Literal(spelling) = value else { return None };
    let is_exact = |value: &f64| (value / FINE).fract() == 0.0 && value.abs() < FAR;
    spelling.parse().ok().filter(|value| is_exact(value) && format!("{value:?}") == *spelling)
}

/// An integer that is spelled as one.
fn integer(value: &Json) -> Option<i64> {
    let Json::Literal(spelling) = value else { return None };
    spelling.parse().ok().filter(|value: &i64| value.to_string() == *spelling)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn arguments(text: &str) -> String {
        of_arguments(Json::read(text), &["steps"]).text()
    }

    fn list(items: impl Iterator<Item = String>) -> String {
        format!(r#"{{"steps":[{}]}}"#, items.collect::<Vec<_>>().join(","))
    }

    #[test]
    fn steps_at_equal_distances_are_one_place_and_the_others_stand_for_themselves() {
        const LATCH: &str = "NCP-SAFE-005";
        let of = |steps: &[usize]| steps.iter().map(|step| (format!("/steps/{step}"), LATCH)).collect::<Vec<_>>();
        let rounds: Vec<usize> = (0..40).flat_map(|round| [6 * round + 1, 6 * round + 3]).chain([500]).collect();
        let by = of(&rounds).into_iter().chain([("/steps/2/frame".to_owned(), "NCP-SAFE-006")]).collect();
        let places = of_places(by);
        let places: Vec<_> = places.iter().map(|(place, rule)| (place.as_str(), *rule)).collect();
        assert_eq!(
            places,
            [
                ("/steps/*1-235+6", LATCH),
                ("/steps/*3-237+6", LATCH),
                ("/steps/2/frame", "NCP-SAFE-006"),
                ("/steps/500", LATCH)
            ]
        );
        let few = of(&[0, 1, 2, 3, 4, 5, 6, 7]).into_iter().collect();
        assert_eq!(of_places(few).len(), 8);
    }

    #[test]
    fn a_long_run_of_equal_items_is_written_once() {
        let text = list((0..60).map(|nth| if nth == 0 { "7".to_owned() } else { "1234.5".to_owned() }));
        assert_eq!(arguments(&text), r#"{"steps":[7,{"$item":1234.5,"times":59}]}"#);
    }

    #[test]
    fn integers_that_grow_are_written_once() {
        let up = (0..60).map(|nth| format!(r#"{{"op":"frame","seq":{}}}"#, 5 + 3 * nth));
        let text = list(up.chain([r#"{"op":"ask"}"#.to_owned()]));
        let run = r#"{"$item":{"op":"frame","seq":5},"times":60,"plus":{"seq":3}}"#;
        assert_eq!(arguments(&text), format!(r#"{{"steps":[{run},{{"op":"ask"}}]}}"#));
    }

    #[test]
    fn an_integer_that_grows_in_a_text_is_written_once() {
        let frame = |seq: i64| format!(r#"{{"text":"{{\"a\":0,\"seq\":{seq},\"b\":{{\"seq\":7}}}}","now_s":1.5}}"#);
        let text = list((0..60).map(|nth| frame(8 + 3 * nth)));
        let run = format!(r#"{{"$item":{},"times":60,"plus":{{"text":{{"seq":3}}}}}}"#, frame(8));
        assert_eq!(arguments(&text), format!(r#"{{"steps":[{run}]}}"#));
    }

    #[test]
    fn a_double_that_grows_is_written_once() {
        let text = list((0..60).map(|nth| format!(r#"{{"now_s":{:?}}}"#, 0.25 + 0.125 * f64::from(nth))));
        assert_eq!(arguments(&text), r#"{"steps":[{"$item":{"now_s":0.25},"times":60,"plus":{"now_s":0.125}}]}"#);
    }

    #[test]
    fn a_number_that_grows_in_an_object_is_written_once() {
        let frame = |seq: i32| format!(r#"{{"sensor":{{"seq":{seq},"t":{seq}.5,"a":{{"seq":7}}}}}}"#);
        let run = format!(r#"{{"$item":{},"times":60,"plus":{{"sensor":{{"seq":2,"t":2.0}}}}}}"#, frame(3));
        assert_eq!(arguments(&list((0..60).map(|nth| frame(3 + 2 * nth)))), format!(r#"{{"steps":[{run}]}}"#));
    }

    #[test]
    fn rounds_of_several_items_are_written_once() {
        let round = |nth: i32| [format!(r#"{{"seq":{}}}"#, 3 + 2 * nth), "7".to_owned(), format!(r#"{{"t":{nth}.5}}"#)];
        let text = list((0..60).flat_map(round).chain(["7".to_owned()]));
        let run = r#"{"$items":[{"seq":3},7,{"t":0.5}],"times":60,"plus":[{"seq":2},{},{"t":1.0}]}"#;
        assert_eq!(arguments(&text), format!(r#"{{"steps":[{run},7]}}"#));
        let equal = list((0..120).map(|nth| format!(r#"{{"hold":{}}}"#, nth % 2 == 0)));
        let run = r#"{"$items":[{"hold":true},{"hold":false}],"times":60}"#;
        assert_eq!(arguments(&equal), format!(r#"{{"steps":[{run}]}}"#));
        assert_eq!(of_pattern(Json::read(&equal)).text(), format!(r#"{{"steps":[{run}]}}"#));
        // Two that stand side by side grow, but the rounds are longer.
        let far = |nth: i32| format!(r#"{{"note":"{}","now_s":{}.5}}"#, "-".repeat(250), 10 + nth % 2);
        let folded = arguments(&list((0..60).map(far)));
        assert!(folded.starts_with(r#"{"steps":[{"$items":[{"note""#) && folded.ends_with(r#"}],"times":30}]}"#));
    }

    #[test]
    fn what_is_short_or_grows_otherwise_stands_as_it_is() {
        for text in [
            list((0..5).map(|nth| format!(r#"{{"seq":{nth}}}"#))),
            list((0..60).map(|nth| format!(r#"{{"seq":{}}}"#, nth * nth))),
            list((0..60).map(|nth| format!(r#"{{"seq":{nth}.10}}"#))),
            list((0..60).map(|nth| format!(r#"{{"seq":{nth}.1}}"#))),
            list((0..60).map(|nth| format!(r#"{{"seq":"{nth}"}}"#))),
            list((0..60).map(|nth| format!(r#"{{"text":"{{\"seq\":0,\"a\":{{\"seq\":{nth}}}}}"}}"#))),
            list((0..60).map(|nth| format!(r#"{{"text":"{{\"seq\":{nth},\"t\":{nth}}}"}}"#))),
            list((0..60).map(|nth| format!(r#"{{"text":"{{\"seq\":{nth}.0}}"}}"#))),
            list((0..60).map(|nth| format!("{nth}"))).replace("steps", "others"),
        ] {
            assert_eq!(arguments(&text), text);
        }
    }

    #[test]
    fn a_pattern_has_runs_of_equal_items_only() {
        let growing = list((0..60).map(|nth| format!(r#"{{"seq":{nth}}}"#)));
        assert_eq!(of_pattern(Json::read(&growing)).text(), growing);
        let equal = list((0..60).map(|_| r#"{"gap":0}"#.to_owned()));
        assert_eq!(of_pattern(Json::read(&equal)).text(), r#"{"steps":[{"$item":{"gap":0},"times":60}]}"#);
    }
}
