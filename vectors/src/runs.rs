//! Long runs of items in the lists of a case, each written once.

use crate::json::{Json, object};

/// What follows the first item of a run is written out as long as it has no more characters together.
const WRITTEN_OUT: usize = 200;

/// The value with each long run in the lists of its members of these names as one item: equal ones as
/// `{"$item": …, "times": …}`, and those in which integers grow by the same from each to the next as
/// `{"$item": …, "times": …, "plus": {…}}`; so do those in whose JSON texts one grows.
pub(crate) fn of_arguments(value: Json, lists: &[&str]) -> Json {
    written(value, false, &|name| lists.contains(&name), &|items| growing(items).or_else(|| equal(items)))
}

/// The pattern with each long run of equal items as one `{"$item": …, "times": …}`.
pub(crate) fn of_pattern(value: Json) -> Json {
    written(value, false, &|_| true, &equal)
}

/// How many items a run has, and what stands for it.
type Run = (usize, Json);

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

/// The run at the head of a list in which integers grow by the same from each item to the next, if it is long.
fn growing(items: &[Json]) -> Option<Run> {
    let [first, second, ..] = items else { return None };
    let plus = growth(first, second)?;
    let pairs = items.iter().zip(items.iter().skip(1));
    let count = 1 + pairs.take_while(|(one, next)| growth(one, next).as_ref() == Some(&plus)).count();
    let plus = plus.into_iter().map(|(name, by)| (name.to_owned(), by)).collect();
    is_long(first, count).then(|| (count, times(first, count).with("plus", Json::Object(plus))))
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

/// By how much an integer grows, or the first integer that differs in a JSON text, by its name.
fn growth_of(value: &Json, next: &Json) -> Option<Json> {
    let by = |one: i64, next: i64| Some(Json::literal(next.checked_sub(one)?.to_string()));
    let (Json::String(text), Json::String(next)) = (value, next) else { return by(integer(value)?, integer(next)?) };
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
    fn what_is_short_or_grows_otherwise_stands_as_it_is() {
        for text in [
            list((0..5).map(|nth| format!(r#"{{"seq":{nth}}}"#))),
            list((0..60).map(|nth| format!(r#"{{"seq":{}}}"#, nth * nth))),
            list((0..60).map(|nth| format!(r#"{{"seq":{nth}.0}}"#))),
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
