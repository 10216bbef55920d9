//! JSON that is built and changed: what requests are made of.
//!
//! A [`Tree`] is [`Json`] that owns its text, so numbers keep their spelling and members their order.

use std::borrow::Cow;

use crate::json::Json;

/// The members that hold entries by name, themselves or in each of their items.
pub(crate) const MAPS: [&str; 8] =
    ["channels", "rates", "values", "records", "population_sizes", "params", "horizon", "resolved"];

/// A JSON value that owns its text.
pub(crate) type Tree = Json<'static>;

/// One step on the way to a value within a tree.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Step {
    /// The member at this place of an object.
    Member(usize),
    /// The item at this place of an array.
    Item(usize),
}

/// A copy that owns its text.
pub(crate) fn own(json: &Json<'_>) -> Tree {
    match json {
        Json::Null => Json::Null,
        Json::Bool(value) => Json::Bool(*value),
        Json::Number(spelling) => Json::Number(Cow::Owned(spelling.to_string())),
        Json::String(text) => Json::String(Cow::Owned(text.to_string())),
        Json::Array(items) => Json::Array(items.iter().map(own).collect()),
        Json::Object(members) => {
            Json::Object(members.iter().map(|(name, value)| (Cow::Owned(name.to_string()), own(value))).collect())
        }
    }
}

/// About how many bytes it has when it is written, escapes aside.
pub(crate) fn size(tree: &Tree) -> usize {
    match tree {
        Json::Null | Json::Bool(_) => 5,
        Json::Number(spelling) => spelling.len() + 1,
        Json::String(text) => text.len() + 3,
        Json::Array(items) => 2 + items.iter().map(size).sum::<usize>(),
        Json::Object(members) => 2 + members.iter().map(|(name, value)| name.len() + 4 + size(value)).sum::<usize>(),
    }
}

/// A double as PROTOCOL.md, section 2, spells it.
pub(crate) fn num(value: f64) -> Tree {
    if value.is_nan() {
        text("NaN")
    } else if value.is_infinite() {
        text(if value > 0.0 { "Infinity" } else { "-Infinity" })
    } else if value == 0.0 && value.is_sign_negative() {
        text("-0")
    } else {
        literal(format!("{value:?}"))
    }
}

/// A double as a frame spells it, which has no way to write what is not finite.
pub(crate) fn spelled(value: f64) -> Tree {
    literal(format!("{value:?}"))
}

/// Doubles.
pub(crate) fn nums(values: &[f64]) -> Tree {
    Json::Array(values.iter().copied().map(num).collect())
}

/// An integer.
pub(crate) fn int(value: i64) -> Tree {
    literal(value.to_string())
}

/// A number of this spelling.
pub(crate) fn literal(spelling: impl Into<String>) -> Tree {
    Json::Number(Cow::Owned(spelling.into()))
}

/// A string.
pub(crate) fn text(value: impl Into<String>) -> Tree {
    Json::String(Cow::Owned(value.into()))
}

/// An object of these members.
pub(crate) fn object<const N: usize>(members: [(&str, Tree); N]) -> Tree {
    Json::Object(members.into_iter().map(|(name, value)| (Cow::Owned(name.to_owned()), value)).collect())
}

/// An object of entries whose names were drawn; of two of one name, the first stays.
pub(crate) fn map(entries: Vec<(String, Tree)>) -> Tree {
    let mut seen = std::collections::HashSet::new();
    let entries = entries.into_iter().filter(|(name, _)| seen.insert(name.clone()));
    Json::Object(entries.map(|(name, value)| (Cow::Owned(name), value)).collect())
}

/// An array.
pub(crate) fn list(items: Vec<Tree>) -> Tree {
    Json::Array(items)
}

/// `null`, or what is there.
pub(crate) fn or_null(value: Option<Tree>) -> Tree {
    value.unwrap_or(Json::Null)
}

/// Sets a member, or adds it at the end.
pub(crate) fn set(tree: &mut Tree, name: &str, value: Tree) {
    if let Json::Object(members) = tree {
        match members.iter_mut().find(|(known, _)| known == name) {
            Some((_, known)) => *known = value,
            None => members.push((Cow::Owned(name.to_owned()), value)),
        }
    }
}

/// The items of an array; none of anything else.
pub(crate) fn items<'t, 'a>(tree: Option<&'t Json<'a>>) -> &'t [Json<'a>] {
    match tree {
        Some(Json::Array(items)) => items,
        _ => &[],
    }
}

/// The members of an object; none of anything else.
pub(crate) fn members<'t, 'a>(tree: Option<&'t Json<'a>>) -> &'t [(Cow<'a, str>, Json<'a>)] {
    match tree {
        Some(Json::Object(members)) => members,
        _ => &[],
    }
}

/// The double that a value is by PROTOCOL.md, section 2.
pub(crate) fn double(tree: Option<&Json<'_>>) -> Option<f64> {
    crate::json::Number::of(tree?).map(crate::json::Number::as_double)
}

/// The integer that a value is.
pub(crate) fn integer(tree: Option<&Json<'_>>) -> Option<i64> {
    match tree? {
        Json::Number(spelling) => spelling.parse().ok(),
        _ => None,
    }
}

/// The doubles of an array.
pub(crate) fn doubles(tree: Option<&Json<'_>>) -> Vec<f64> {
    items(tree).iter().map(|item| double(Some(item)).unwrap_or(f64::NAN)).collect()
}

/// The doubles of an array as ranges: each may be off by a part of itself, or by the least if that is more.
pub(crate) fn near_list(tree: &Json<'_>, tolerance: f64, least: f64) -> Tree {
    let near = |item: &Json<'_>| {
        let value = double(Some(item)).unwrap_or(f64::NAN);
        let off = (value.abs() * tolerance).max(least);
        if !value.is_finite() || off == 0.0 {
            return num(value);
        }
        object([("$range", list(vec![num(value - off), num(value + off)]))])
    };
    list(items(Some(tree)).iter().map(near).collect())
}

/// The string of a member.
pub(crate) fn string<'t>(tree: &'t Json<'_>, name: &str) -> Option<&'t str> {
    tree.get(name)?.as_str()
}

/// The ways to every value of a tree, its own first, a parent before what is in it.
pub(crate) fn places(tree: &Json<'_>) -> Vec<Vec<Step>> {
    fn walk(tree: &Json<'_>, at: &mut Vec<Step>, found: &mut Vec<Vec<Step>>) {
        found.push(at.clone());
        match tree {
            Json::Array(items) => {
                for (place, item) in items.iter().enumerate() {
                    at.push(Step::Item(place));
                    walk(item, at, found);
                    at.pop();
                }
            }
            Json::Object(members) => {
                for (place, (_, value)) in members.iter().enumerate() {
                    at.push(Step::Member(place));
                    walk(value, at, found);
                    at.pop();
                }
            }
            _ => {}
        }
    }
    let mut found = Vec::new();
    walk(tree, &mut Vec::new(), &mut found);
    found
}

/// What stands at a place.
pub(crate) fn at<'t, 'a>(tree: &'t Json<'a>, place: &[Step]) -> Option<&'t Json<'a>> {
    place.iter().try_fold(tree, |tree, step| match (tree, step) {
        (Json::Array(items), Step::Item(place)) => items.get(*place),
        (Json::Object(members), Step::Member(place)) => members.get(*place).map(|(_, value)| value),
        _ => None,
    })
}

/// What stands at a place, to be changed.
pub(crate) fn at_mut<'t>(tree: &'t mut Tree, place: &[Step]) -> Option<&'t mut Tree> {
    place.iter().try_fold(tree, |tree, step| match (tree, step) {
        (Json::Array(items), Step::Item(place)) => items.get_mut(*place),
        (Json::Object(members), Step::Member(place)) => members.get_mut(*place).map(|(_, value)| value),
        _ => None,
    })
}

/// The name of the member at the end of the way to a place; of an item, that of its array.
pub(crate) fn name_at<'t>(tree: &'t Json<'_>, place: &[Step]) -> &'t str {
    let mut name = "";
    let mut here = tree;
    for step in place {
        match (here, step) {
            (Json::Array(items), Step::Item(place)) => match items.get(*place) {
                Some(item) => here = item,
                None => return name,
            },
            (Json::Object(members), Step::Member(place)) => match members.get(*place) {
                Some((known, value)) => (name, here) = (known, value),
                None => return name,
            },
            _ => return name,
        }
    }
    name
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_double_is_spelled_so_that_it_reads_back() {
        for value in [0.1, -0.0, 5e-324, f64::MAX, f64::NAN, f64::NEG_INFINITY, 1.0] {
            let read = double(Some(&num(value))).unwrap();
            assert!(read.to_bits() == value.to_bits() || read.is_nan() && value.is_nan(), "{value}");
        }
    }

    #[test]
    fn every_place_leads_to_its_value() {
        let tree = own(&Json::parse(r#"{"a":[1,{"b":2}],"c":"x"}"#).unwrap());
        let all = places(&tree);
        assert_eq!(all.len(), 6);
        assert!(all.iter().all(|place| at(&tree, place).is_some()));
        let inner = all.iter().find(|place| name_at(&tree, place) == "b").unwrap();
        assert_eq!(at(&tree, inner), Some(&literal("2")));
    }

    #[test]
    fn a_member_is_set_once() {
        let mut tree = object([("a", int(1))]);
        set(&mut tree, "a", int(2));
        set(&mut tree, "b", Json::Null);
        assert_eq!(tree.to_string(), r#"{"a":2,"b":null}"#);
    }

    #[test]
    fn the_size_of_a_tree_is_about_that_of_its_text() {
        let frame = object([
            ("seq", int(7)),
            ("data", nums(&[0.5, -1.25])),
            ("unit", Json::Null),
            ("id", text("s".repeat(60))),
        ]);
        let (size, written) = (size(&frame), frame.to_string().len());
        assert!(size >= written && size < written + 20, "{size} {written}");
    }
}
