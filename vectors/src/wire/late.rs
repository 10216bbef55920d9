//! What is wrong in a message, an entry or an item that stands behind many others.

use crate::case::{Case, File};
use crate::model::minimal;
use crate::roles::{a, readers};
use crate::template::Text;

pub(super) fn file() -> File {
    let mut cases = items();
    cases.extend(entries());
    let about = "The last of many items and entries, which has to be as good as the first.";
    File::new("wire", "late", about, cases)
}

/// What is wrong: its name, how it is spelled, and the rule against it.
type Bad = (&'static str, &'static str, &'static str);

const NULL: Bad = ("null", "null", "NCP-WIRE-021");
const TEXT: Bad = ("string", "\"x\"", "NCP-WIRE-020");
const NUMBER: Bad = ("number", "5", "NCP-WIRE-020");
const TRUE: Bad = ("boolean", "true", "NCP-WIRE-020");
const FRACTION: Bad = ("fraction", "1.0", "NCP-WIRE-010");
const BEYOND: Bad = ("two-to-53", "9007199254740992", "NCP-WIRE-011");
const BELOW: Bad = ("minus-two-to-53", "-9007199254740992", "NCP-WIRE-011");
const INFINITE: Bad = ("infinite", "1e309", "NCP-WIRE-013");
/// Values that hold what is wrong.
const TEXT_IN_DATA: Bad = ("data-string", r#"{"a":{"data":["x"]}}"#, "NCP-WIRE-020");
const INFINITE_IN_DATA: Bad = ("data-infinite", r#"{"a":{"data":[1e309]}}"#, "NCP-WIRE-013");
const NUMBER_IN_META: Bad = ("meta-number", r#"{"entity":{"meta":{"a":1}}}"#, "NCP-WIRE-020");
const FRACTION_IN_IDS: Bad = ("ids-fraction", r#"{"ids":[1.0]}"#, "NCP-WIRE-010");
const TEXT_IN_PARAMS: Bad = ("params-string", r#"{"params":{"a":"1"}}"#, "NCP-WIRE-020");
const NULL_OPTIONAL: Bad = ("optional-null", r#"{"optional":null}"#, "NCP-WIRE-021");
const TEXT_IN_TIMES: Bad = ("times-string", r#"{"times":["x"]}"#, "NCP-WIRE-020");
const TRUE_IN_DATA: Bad = ("data-boolean", r#"{"data":[true]}"#, "NCP-WIRE-020");
const NUMBER_AS_UNIT: Bad = ("unit-number", r#"{"unit":5}"#, "NCP-WIRE-020");

/// Kind, the member as a reader finds it, what stands around the items, a good item, and bad ones.
type Items = (&'static str, &'static str, [&'static str; 2], &'static str, &'static [Bad]);

const ITEMS: [Items; 12] = [
    ("command_frame", "horizon", ["\"horizon\":[", "]"], "{}", &[NULL, TEXT_IN_DATA, INFINITE_IN_DATA]),
    ("open_session", "bindings", ["\"bindings\":[", "]"], "{}", &[NUMBER_IN_META]),
    ("open_session", "record.targets", ["\"record\":{\"targets\":[", "]}"], "{}", &[FRACTION_IN_IDS]),
    (
        "open_session",
        "record.targets[0].recordables",
        ["\"record\":{\"targets\":[{\"recordables\":[", "]}]}"],
        "\"V_m\"",
        &[NUMBER],
    ),
    ("open_session", "stimulus.targets", ["\"stimulus\":{\"targets\":[", "]}"], "{}", &[TEXT_IN_PARAMS]),
    ("capabilities", "sensor_channels", ["\"sensor_channels\":[", "]"], "{}", &[NULL_OPTIONAL]),
    ("command_frame", "channels.a.data", ["\"channels\":{\"a\":{\"data\":[", "]}}"], "0.5", &[TEXT]),
    ("command_frame", "horizon[0].a.data", ["\"horizon\":[{\"a\":{\"data\":[", "]}}]"], "0.5", &[TRUE]),
    ("observation_frame", "records.a.values", ["\"records\":{\"a\":{\"values\":[", "]}}"], "-65.0", &[TRUE, INFINITE]),
    ("observation_frame", "records.a.senders", ["\"records\":{\"a\":{\"senders\":[", "]}}"], "7", &[BEYOND, BELOW]),
    (
        "open_session",
        "record.targets[0].ids",
        ["\"record\":{\"targets\":[{\"ids\":[", "]}]}"],
        "7",
        &[FRACTION, BEYOND, BELOW],
    ),
    ("open_session", "stimulus.targets[0].ids", ["\"stimulus\":{\"targets\":[{\"ids\":[", "]}]}"], "7", &[BELOW]),
];

fn items() -> Vec<Case> {
    let mut cases = Vec::new();
    for (kind, member, [before, after], good, bad) in ITEMS {
        // Numbers behind many more than messages.
        let count = if good == "{}" || good.starts_with('"') { 20 } else { 1_000 };
        for (name, item, rule) in bad {
            let frame = minimal(kind).text();
            let open = frame.strip_suffix('}').unwrap_or(&frame);
            let text = Text::concat([
                format!("{open},{before}").into(),
                Text::repeat(format!("{good},"), count),
                format!("{item}{after}}}").into(),
            ]);
            cases.push(case(kind, member, name, count, rule, text, "items"));
            // And before as many: not the last either.
            let text = Text::concat([
                format!("{open},{before}").into(),
                Text::repeat(format!("{good},"), count),
                (*item).into(),
                Text::repeat(format!(",{good}"), count),
                format!("{after}}}").into(),
            ]);
            cases.push(case(kind, member, name, count, rule, text, "items-on-both-sides"));
        }
    }
    cases
}

/// The same of maps, whose names have to be written out.
fn entries() -> Vec<Case> {
    let places: [Items; 7] = [
        ("observation_frame", "records", ["\"records\":{", "}"], "{}", &[TEXT_IN_TIMES]),
        ("command_frame", "channels", ["\"channels\":{", "}"], "{}", &[NUMBER_AS_UNIT]),
        ("command_frame", "horizon[0]", ["\"horizon\":[{", "}]"], "{}", &[NULL]),
        ("stimulus_frame", "values", ["\"values\":{", "}"], "{}", &[TRUE_IN_DATA]),
        ("session_opened", "resolved", ["\"resolved\":{", "}"], "1", &[FRACTION]),
        ("open_session", "network.params", ["\"network\":{\"params\":{", "}}"], "1", &[TEXT]),
        (
            "open_session",
            "network.population_sizes",
            ["\"network\":{\"population_sizes\":{", "}}"],
            "1",
            &[BEYOND, BELOW],
        ),
    ];
    let mut cases = Vec::new();
    for (kind, member, [before, after], good, bad) in places {
        for (name, value, rule) in bad {
            let count = 20;
            let frame = minimal(kind);
            let frame = if member.starts_with("network") { frame.without("network") } else { frame }.text();
            let open = frame.strip_suffix('}').unwrap_or(&frame);
            let entries: String = (0..count).map(|nth| format!("\"n{nth}\":{good},")).collect();
            let text = format!("{open},{before}{entries}\"z\":{value}{after}}}");
            cases.push(case(kind, member, name, count, rule, text.into(), "entries"));
        }
    }
    cases
}

fn case(kind: &str, member: &str, name: &str, count: usize, rule: &'static str, text: Text, of: &str) -> Case {
    let place = member.replace(".a.", ".").replace("[0]", "").replace('.', "/");
    let path = format!("{kind}/{place}/{name}-behind-{count}-{of}");
    Case::new(path, &[rule, "NCP-WIRE-050"], readers(kind))
        .title(format!(
            "{} whose `{member}` has one of another sort ({}) behind {count} good {} is rejected.",
            a(kind),
            name.replace('-', " "),
            of.replace('-', " ")
        ))
        .flags(&[if rule == "NCP-WIRE-021" { "null-as-default" } else { "unchecked-types" }])
        .decode(kind, text)
        .rejects("type")
        .because("The rules of fields hold for every value of a map or an array, the last as the first.")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::json::Json;

    #[test]
    fn what_stands_around_the_items_closes_what_it_opens() {
        for (kind, member, [before, after], good, _) in ITEMS {
            let frame = format!("{{{before}{good}{after}}}");
            assert!(!Json::read(&frame).members().is_empty(), "{kind} {member}");
        }
    }
}
