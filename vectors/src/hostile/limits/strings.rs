//! Long names and strings, and many of them.

use super::super::with_raw;
use super::stretch::{MARK, set};
use crate::case::Case;
use crate::json::{Json, object};
use crate::model::{explicit, explicit_message, meaning, minimal};
use crate::roles::{a, readers};
use crate::template::Text;

pub(super) fn cases() -> Vec<Case> {
    let mut cases = long_strings();
    cases.extend(long_names());
    cases.extend(alike_in_all_places());
    cases.extend(of_one_checksum());
    cases.extend(long_enums());
    cases
}

/// Names and other strings, which only the bytes of the frame limit, but for ids.
fn long_strings() -> Vec<Case> {
    // The last part is the name of an entry, or a field that is a string.
    let places: [(&str, &[&str], &str); 10] = [
        ("sensor_frame", &["frame_id"], "frame_id"),
        ("sensor_frame", &["channels", "{}"], "name of a channel"),
        ("command_frame", &["frame_id"], "frame_id"),
        ("command_frame", &["channels", "a", "unit"], "unit of a channel"),
        ("stimulus_frame", &["values", "{}"], "name of a port"),
        ("observation_frame", &["records", "{}"], "name of a port"),
        ("session_opened", &["resolved", "{}"], "name of a population"),
        ("open_session", &["network", "ref"], "name of a network"),
        ("open_session", &["network", "params", "{}"], "name of a parameter"),
        ("link_status", &["session_id"], "session_id, which is any string,"),
    ];
    let mut cases = Vec::new();
    for (kind, path, says) in places {
        // A text that is read in pieces is cut within a character, if it has three bytes.
        for (length, letter) in [(257, "n"), (65_537, "n"), (100_000, "\u{20ac}")] {
            let entry = |value: Json| object! { MARK => value };
            let frame = match path {
                ["channels", "{}"] => explicit(kind).with("channels", entry(explicit_message("ChannelValue"))),
                ["values", "{}"] => explicit(kind).with("values", entry(explicit_message("ChannelValue"))),
                ["records", "{}"] => explicit(kind).with("records", entry(explicit_message("Observation"))),
                [map @ .., "{}"] => set(explicit(kind), map, entry(Json::literal("1"))),
                ["channels", "a", "unit"] => {
                    let value = explicit_message("ChannelValue").with("unit", MARK.into());
                    explicit(kind).with("channels", object! { "a" => value })
                }
                path => set(explicit(kind), path, MARK.into()),
            };
            let place = path.iter().filter(|part| !matches!(**part, "{}" | "a")).copied().collect::<Vec<_>>().join("-");
            let frame = frame.text();
            let (before, after) = frame.split_once(MARK).unwrap_or((&frame, ""));
            let text = Text::concat([before.into(), Text::repeat(letter, length), after.into()]);
            let of_bytes = if letter == "n" { "" } else { " of three bytes each" };
            cases.push(
                Case::new(
                    format!("{kind}/strings/{place}-{length}{}", of_bytes.replace(' ', "-")),
                    &["NCP-WIRE-034", "NCP-WIRE-061"],
                    readers(kind),
                )
                .title(format!("{} with a {says} of {length} characters{of_bytes} is read.", a(kind)))
                .flags(&["low-limits"])
                .decode(kind, text.clone())
                .means(text)
                .because("Nothing but the bytes of the frame limits a string that is no id."),
            );
        }
    }
    cases
}

/// Names that agree in thousands of characters, and one that repeats.
fn long_names() -> Vec<Case> {
    let value = explicit_message("ChannelValue").text();
    let mut cases = Vec::new();
    for (kind, length) in [("sensor_frame", 70_000), ("command_frame", 2_000)] {
        let name = |last: &str| [Text::from("\""), Text::repeat("n", length), format!("{last}\":").into()];
        // Two names with a value each, within the frame with the mark in it.
        let of_two = |frame: &Json, value: &str, lasts: [&str; 2]| {
            let frame = frame.text();
            let (before, after) = frame.split_once(MARK).unwrap_or((&frame, ""));
            let [one, other] = lasts.map(name);
            let parts = [vec![before.into()], one.into(), vec![format!("{value},").into()], other.into()];
            Text::Concat([parts.concat(), vec![format!("{value}{after}").into()]].concat())
        };
        let in_channels = |ground: Json| ground.with("channels", Json::literal(format!("{{{MARK}}}")));
        let read = of_two(&in_channels(explicit(kind)), &value, ["a", "b"]);
        cases.push(
            Case::new(format!("{kind}/strings/alike-{length}/channels"), &["NCP-WIRE-068"], readers(kind))
                .title(format!("{} with two channels whose names agree in {length} characters has both.", a(kind)))
                .flags(&["low-limits"])
                .decode(kind, read.clone())
                .means(read)
                .because("Two names that differ in their last letter are two names, however long they are."),
        );
        cases.push(
            Case::new(format!("{kind}/strings/alike-{length}/repeated"), &["NCP-WIRE-007"], readers(kind))
                .title(format!("{} with a channel twice whose name has {length} characters is rejected.", a(kind)))
                .flags(&["duplicate-members"])
                .decode(kind, of_two(&in_channels(minimal(kind)), "{}", ["a", "a"]))
                .rejects("malformed")
                .because("One object has the same member name twice, however long it is."),
        );
        let beside = |ground: Json| Json::literal(with_raw(&ground.text(), MARK));
        cases.push(
            Case::new(format!("{kind}/strings/alike-{length}/unknown"), &["NCP-WIRE-026"], readers(kind))
                .title(format!(
                    "{} with two unknown members whose names agree in {length} characters is read.",
                    a(kind)
                ))
                .flags(&["closed-objects"])
                .decode(kind, of_two(&beside(explicit(kind)), "1", ["a", "b"]))
                .means(meaning(kind, &explicit(kind)).text())
                .because("Two names that differ in their last letter are two names, and both are ignored."),
        );
    }
    cases
}

/// As many names as a name has letters, and one, each of which differs from all others in one place or in two.
fn alike_in_all_places() -> Vec<Case> {
    let mut cases = Vec::new();
    for base in ["arm_joint_01_position_setpoint", &"left_arm_upper_joint_".repeat(4)] {
        let with_mark = |place| {
            let marked = |(at, letter)| if at == place { '~' } else { letter };
            base.char_indices().map(marked).collect::<String>()
        };
        let names: Vec<String> = (0..=base.len()).map(with_mark).collect();
        let (name, says) = (format!("alike-in-all-{}-places", base.len()), "that differ in a place or two");
        cases.extend(with_names(
            &name,
            &names,
            says,
            "Two names that differ in a letter are two names, wherever it stands.",
        ));
    }
    cases
}

/// Pairs of names of which a usual checksum or hash is the same: CRC-32 and its variant of Castagnoli, Adler-32, FNV-1
/// and FNV-1a, the products by 31 and by 33, and others, each of 32 bits.
const COLLIDING: [[&str; 2]; 12] = [
    ["Aa", "BB"],
    ["hztkwpo", "t2w87d9"],
    ["kay62fh", "9eqgvan"],
    ["6i5nfxi", "6kwnh6i"],
    ["a71uvek", "3ehzu6g"],
    ["pfd5q9a", "htpibo6"],
    ["sg3welo", "okqd0qj"],
    ["e01w3kz", "40vcv3o"],
    ["6hwq09s", "2nkdck6"],
    ["ny0832h", "dxjl5i6"],
    ["30boei0", "ntkbpid"],
    ["e2uf3h9", "21ogzzt"],
];

/// Names that who compares by a checksum takes for one.
fn of_one_checksum() -> Vec<Case> {
    let names = COLLIDING.concat().iter().map(ToString::to_string).collect::<Vec<_>>();
    with_names(
        "of-one-checksum",
        &names,
        "of which two at a time have the same checksum",
        "Names are the same letter for letter, and not by what is made of them.",
    )
}

/// A frame of each of some kinds, with a map, or an object that nobody reads, of these names.
fn with_names(name: &str, names: &[String], says: &str, why: &str) -> Vec<Case> {
    let value = explicit_message("ChannelValue").text();
    let table: [(&str, &[&str], &str); 4] = [
        ("sensor_frame", &["channels"], &value),
        ("command_frame", &["horizon", "0"], &value),
        ("open_session", &["network", "population_sizes"], "1"),
        ("close_session", &["novel"], "1"),
    ];
    let case = |(kind, path, value): (&str, &[&str], &str)| {
        let entries: Vec<String> = names.iter().map(|name| format!("\"{name}\":{value}")).collect();
        let with_all = Json::literal(format!("{{{}}}", entries.join(",")));
        let is_listed = path != ["novel"];
        let frame =
            if is_listed { set(explicit(kind), path, with_all) } else { explicit(kind).with("novel", with_all) };
        let means = if is_listed { frame.text() } else { meaning(kind, &explicit(kind)).text() };
        let member = path.join(".").replace(".0", "[0]");
        Case::new(
            format!("{kind}/strings/{name}/{}", path.join("-")),
            &[if is_listed { "NCP-WIRE-068" } else { "NCP-WIRE-026" }, "NCP-WIRE-007"],
            readers(kind),
        )
        .title(format!("{} is read whose `{member}` has {} names {says}.", a(kind), names.len()))
        .flags(&["low-limits"])
        .decode(kind, frame.text())
        .means(means)
        .because(why)
    };
    table.into_iter().map(case).collect()
}

/// Strings of descriptive enums that are none of theirs and long.
fn long_enums() -> Vec<Case> {
    let places: [(&str, &[&str]); 1] = [("open_session", &["record", "targets", "0", "observable"])];
    let case = |(kind, path): (&str, &[&str])| {
        let frame = set(explicit(kind), path, MARK.into()).text();
        let (before, after) = frame.split_once(MARK).unwrap_or((&frame, ""));
        let text = Text::concat([before.into(), Text::repeat("novel", 60), after.into()]);
        let place = path.iter().filter(|part| **part != "0").copied().collect::<Vec<_>>().join("-");
        Case::new(
            format!("{kind}/strings/enum-{place}"),
            &["NCP-WIRE-043", "NCP-WIRE-042", "NCP-WIRE-045"],
            readers(kind),
        )
        .title(format!(
            "{} whose `{}` is an unknown string of 300 characters keeps it.",
            a(kind),
            path.join(".").replace(".0", "[0]")
        ))
        .flags(&["invented-sentinel"])
        .decode(kind, text.clone())
        .means(text)
        .because("An unknown string of a descriptive enum is kept as it is, however long it is.")
    };
    places.map(case).into()
}
