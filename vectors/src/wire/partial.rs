//! Messages of which some fields are named: what is absent is at its default, whatever is named beside it.

use super::place::{Ground, Place};
use super::{READ, WRITE, encode};
use crate::case::{Case, File};
use crate::json::Json;
use crate::model::{self, meaning};
use crate::roles::{a, readers, writers};
use ncp_text::tables::{Default, Field, Shape};

pub(super) fn file() -> File {
    let nested = Place::nested().into_iter().filter(|place| !place.is_twin() && place.message.kind.is_none());
    let places: Vec<Place> = Place::frames().chain(nested).collect();
    let read = places.iter().flat_map(read);
    let written = places.iter().filter(|place| !place.is_nested()).flat_map(written);
    let about = "Messages of which some fields are named, so that each field is absent beside each other once.";
    File::new("wire", "partial", about, read.chain(written).collect())
}

fn read(place: &Place) -> Vec<Case> {
    let of_share = |(nth, share): (usize, Vec<&Field>)| {
        let message = named(place, &share);
        let frame = place.frame(Ground::Explicit, message);
        let first: &[&str] = if place.kind == "error" { &["NCP-WIRE-100", READ] } else { &["NCP-WIRE-023", READ] };
        let members = place.label();
        let members = members.strip_prefix(place.kind).unwrap_or("/");
        let path = format!("{}/read{members}{}", place.kind, nth + 1);
        let case = Case::new(path, first, readers(place.kind))
            .title(format!("{} that names {} is read with the defaults of all others.", says(place), words(&share)))
            .flags(&["wrong-defaults"])
            .decode(place.kind, frame.text())
            .means(place.meaning(&frame))
            .because("What is absent is read as its default, whatever stands beside it.");
        let case =
            place.message.fields.iter().fold(case, |case, field| match rule_of_absence(place.kind, &field.name) {
                Some(rule) => case.by(place.pointer(&field.name), rule),
                None => case,
            });
        share.iter().fold(case, |case, field| case.by(place.pointer(&field.name), READ))
    };
    shares(place).into_iter().enumerate().map(of_share).chain(like_strings(place)).collect()
}

/// Enums that are absent beside strings that are strings of theirs.
fn like_strings(place: &Place) -> Vec<Case> {
    let enums = place.message.fields.iter().filter(|field| matches!(field.shape, Shape::Enum(_)));
    let may_say = |field: &&Field| {
        field.shape == Shape::String
            && !matches!(field.name.as_str(), "kind" | "session_id" | "ncp_version" | "contract_hash")
    };
    let strings: Vec<&Field> = place.message.fields.iter().filter(may_say).collect();
    let case = |field: &Field| {
        let value = model::sample(place.message, field);
        let message = strings
            .iter()
            .fold(place.alone(Ground::Minimal), |message, string| message.with(&string.name, value.clone()));
        let frame = place.frame(Ground::Explicit, message);
        let members = place.label();
        let members = members.strip_prefix(place.kind).unwrap_or("/");
        Case::new(
            format!("{}/read{members}like-{}", place.kind, field.name),
            &["NCP-WIRE-023", READ],
            readers(place.kind),
        )
        .title(format!(
            "{} whose `{}` is absent, and each of whose strings is {}, is read with its default.",
            says(place),
            field.name,
            value.text()
        ))
        .flags(&["wrong-defaults"])
        .decode(place.kind, frame.text())
        .means(place.meaning(&frame))
        .because("What is absent is read as its default, whatever stands beside it.")
    };
    if strings.is_empty() { Vec::new() } else { enums.map(case).collect() }
}

fn written(place: &Place) -> Vec<Case> {
    let of_share = |(nth, share): (usize, Vec<&Field>)| {
        let frame = named(place, &share);
        let defaults = || {
            let absent = place.message.fields.iter().filter(|field| frame.get(&field.name).is_none());
            absent.filter_map(|field| Some((&field.name, program_default(place.kind, &field.name)?)))
        };
        let said = defaults().fold(frame.clone(), |said, (name, (value, _))| said.with(name, value.into()));
        let case =
            Case::new(format!("{}/written/{}", place.kind, nth + 1), &["NCP-WIRE-090", WRITE], writers(place.kind))
                .title(format!(
                    "{} for which a program names {} is written with the defaults of all others.",
                    says(place),
                    words(&share)
                ))
                .flags(&["wrong-defaults"])
                .encode(place.kind, encode::fields(place.message, frame.clone()))
                .means(meaning(place.kind, &said).text())
                .because("What a program leaves out has the default of the table, whatever it names beside it.");
        let case = defaults().fold(case, |case, (name, (_, rule))| case.by(place.pointer(name), rule));
        share.iter().fold(case, |case, field| case.by(place.pointer(&field.name), WRITE))
    };
    if place.kind == "error" { Vec::new() } else { shares(place).into_iter().enumerate().map(of_share).collect() }
}

/// The message that names these fields, beside what it has to name.
fn named(place: &Place, share: &[&Field]) -> Json {
    share.iter().fold(place.alone(Ground::Minimal), |message, field| {
        message.with(&field.name, model::sample(place.message, field))
    })
}

/// What an encoder says of a field that a program leaves out, and by which rule, where that is not the table's default.
fn program_default(kind: &str, name: &str) -> Option<(&'static str, &'static str)> {
    match (kind, name) {
        (_, "contract_hash") => Some((model::CONTRACT_HASH, "NCP-WIRE-089")),
        ("command_frame", "mode") => Some(("active", "NCP-WIRE-088")),
        _ => None,
    }
}

/// The rule by which a receiver reads a field that is absent, where it is one of its own.
fn rule_of_absence(kind: &str, name: &str) -> Option<&'static str> {
    match (kind, name) {
        (_, "contract_hash") => Some("NCP-WIRE-025"),
        ("command_frame", "mode") => Some("NCP-WIRE-024"),
        _ => None,
    }
}

/// Shares of the fields that may be absent, such that of any two fields each is in one that the other is not in.
fn shares(place: &Place) -> Vec<Vec<&'static Field>> {
    let may_be_absent = |field: &&Field| {
        !matches!(field.default, Default::Kind | Default::Required)
            && field.name != "ncp_version"
            && !model::is_pin(&field.name)
    };
    let fields: Vec<&Field> = place.message.fields.iter().filter(may_be_absent).collect();
    // As many shares as there have to be for each field to be in another pair of them.
    let pairs = |count: usize| (0..count).flat_map(move |one| (one + 1..count).map(move |other| [one, other]));
    let Some(count) = (2..).find(|count| pairs(*count).count() >= fields.len()).filter(|_| fields.len() > 1) else {
        return Vec::new();
    };
    if fields.len() == 2 {
        return fields.into_iter().map(|field| vec![field]).collect();
    }
    let is_in = |share: usize| move |(_, pair): &(&&'static Field, [usize; 2])| pair.contains(&share);
    let share = |share| fields.iter().zip(pairs(count)).filter(is_in(share)).map(|(field, _)| *field).collect();
    (0..count).map(share).filter(|share: &Vec<_>| !share.is_empty()).collect()
}

fn says(place: &Place) -> String {
    if !place.is_nested() {
        return a(place.kind);
    }
    format!("{} with a message at `{}`", a(place.kind), place.member(""))
}

/// The names in words.
fn words(share: &[&Field]) -> String {
    let names: Vec<String> = share.iter().map(|field| format!("`{}`", field.name)).collect();
    match names.split_last() {
        Some((last, [])) => last.clone(),
        Some((last, rest)) => format!("{} and {last}", rest.join(", ")),
        None => "nothing".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_any_two_fields_each_is_named_once_without_the_other() {
        for place in Place::frames().chain(Place::nested()) {
            let shares = shares(&place);
            let fields: Vec<_> = shares.iter().flatten().collect();
            let without = |one: &&&Field, other: &&&Field| {
                shares.iter().any(|share| share.contains(*one) && !share.contains(*other))
            };
            for one in &fields {
                assert!(fields.iter().all(|other| one.name == other.name || without(one, other)), "{}", place.kind);
            }
        }
    }
}
