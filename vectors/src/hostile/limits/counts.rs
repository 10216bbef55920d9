//! How many entries a map and how many items an array may have, and what only the bytes of the frame limit.

use super::super::with_raw;
use super::stretch::{MARK, base_64, entries_of, list, set};
use super::{ENTRIES, MIB};
use crate::case::Case;
use crate::json::{Json, object};
use crate::model::{explicit, explicit_message, meaning, minimal};
use crate::roles::{ANY, a, readers};
use crate::template::Text;

pub(super) fn cases() -> Vec<Case> {
    let mut cases = maps();
    cases.push(members());
    cases.extend(repeated_of_many());
    cases.extend(repeated_as_it_grows());
    cases.extend(arrays());
    cases.extend(sums());
    cases.extend(side_by_side());
    cases.extend(steps_of_shared_names());
    cases.extend(numeric_arrays());
    cases.extend(equal_numbers());
    cases.extend(small_values());
    cases
}

/// Maps of 4,096 entries and of one more.
fn maps() -> Vec<Case> {
    let places: [(&str, &[&str], &str); 11] = [
        ("sensor_frame", &["channels"], "{}"),
        ("command_frame", &["channels"], "{}"),
        ("command_frame", &["horizon", "0"], "{}"),
        ("stimulus_frame", &["values"], "{}"),
        ("step_request", &["stimulus", "values"], "{}"),
        ("observation_frame", &["records"], "{}"),
        ("session_opened", &["resolved"], "1"),
        ("open_session", &["network", "population_sizes"], "1"),
        ("open_session", &["network", "params"], "1"),
        ("open_session", &["bindings", "0", "entity", "meta"], "\"\""),
        ("open_session", &["stimulus", "targets", "0", "params"], "1"),
    ];
    let mut cases = Vec::new();
    for (kind, path, value) in places {
        let place = path.iter().filter(|part| **part != "0").copied().collect::<Vec<_>>().join("-");
        let member = path.join(".").replace(".0", "[0]");
        let marked = |frame: Json| set(frame, path, Json::literal(MARK)).text();
        // One too many, and as many as 16 bits count as few.
        for (name, count, says) in [("limit", ENTRIES + 1, "4,097"), ("2-to-16", (1 << 16) + 1, "65,537")] {
            cases.push(
                Case::new(format!("{kind}/map/{place}-beyond-{name}"), &["NCP-WIRE-066"], readers(kind))
                    .title(format!("{} with {says} entries in `{member}` is rejected.", a(kind)))
                    .flags(&["missing-limits"])
                    .decode(kind, entries_of(&marked(minimal(kind)), value, count))
                    .rejects("limit")
                    .because("A map of the tables may have 4,096 entries."),
            );
        }
        // What a stimulus frame may have, it may have in a request.
        if path == ["stimulus", "values"] {
            continue;
        }
        let text = entries_of(&marked(explicit(kind)), value, ENTRIES);
        cases.push(
            Case::new(format!("{kind}/map/{place}-at-limit"), &["NCP-WIRE-068"], readers(kind))
                .title(format!("{} with 4,096 entries in `{member}` is read.", a(kind)))
                .flags(&["low-limits"])
                .decode(kind, text.clone())
                .means(text)
                .because("A map may have 4,096 entries; what each leaves out has its default."),
        );
    }
    cases
}

/// A message of more members than a map may have entries.
fn members() -> Case {
    const MEMBERS: usize = 4_200;
    let kind = "sensor_frame";
    // None of two characters is listed, and none of three that begins with a 1.
    let members: Vec<String> = (64..64 + MEMBERS).map(|nth| format!("\"{}\":0", base_64(nth))).collect();
    Case::new(format!("{kind}/members/{MEMBERS}"), &["NCP-WIRE-026", "NCP-WIRE-061"], readers(kind))
        .title(format!("{} with {MEMBERS} unknown members is read.", a(kind)))
        .flags(&["low-limits"])
        .decode(kind, with_raw(&explicit(kind).text(), &members.join(",")))
        .means(meaning(kind, &explicit(kind)).text())
        .because("A message is no map: nothing but the bytes of the frame limits the number of its members.")
}

/// A member that repeats in a message of more members than a map may have entries.
fn repeated_of_many() -> [Case; 2] {
    const MEMBERS: usize = 4_200;
    let kind = "sensor_frame";
    [("first", 64), ("last", 64 + MEMBERS - 1)].map(|(which, nth)| {
        let members = (64..64 + MEMBERS).chain([nth]).map(|nth| format!("\"{}\":0", base_64(nth)));
        let members: Vec<String> = members.collect();
        Case::new(format!("{kind}/members/{MEMBERS}/{which}-repeated"), &["NCP-WIRE-007"], readers(kind))
            .title(format!("{} with {MEMBERS} unknown members and the {which} of them again is rejected.", a(kind)))
            .flags(&["duplicate-members"])
            .decode(kind, with_raw(&minimal(kind).text(), &members.join(",")))
            .rejects("malformed")
            .because("One object has one member name twice, however many others it has.")
    })
}

/// A name that repeats as the last of so many, where tables of names of the usual sizes are full, and just beyond.
fn repeated_as_it_grows() -> Vec<Case> {
    const COUNTS: [usize; 20] = [3, 4, 7, 8, 9, 14, 15, 16, 17, 28, 29, 32, 33, 56, 57, 64, 65, 113, 257, 1025];
    let kind = "sensor_frame";
    let mut cases = Vec::new();
    for count in COUNTS {
        for (name, which, nth) in [("first", "the first", 0), ("one-before", "the one before it", count - 2)] {
            for (place, members, value, frame) in [
                ("unknown", "unknown members", "0", with_raw(&minimal(kind).text(), MARK)),
                (
                    "channels",
                    "channels",
                    "{}",
                    set(minimal(kind), &["channels"], Json::literal(format!("{{{MARK}}}"))).text(),
                ),
            ] {
                let (before, after) = frame.split_once(MARK).unwrap_or((&frame, ""));
                let text = Text::concat([
                    before.into(),
                    Text::count("\"k", &format!("\":{value},"), count - 1),
                    format!("\"k{nth}\":{value}{after}").into(),
                ]);
                cases.push(
                    Case::new(
                        format!("{kind}/members/{count}/{name}-repeated-in-{place}"),
                        &["NCP-WIRE-007"],
                        readers(kind),
                    )
                    .title(format!(
                        "{} with {count} {members} of which the last has the name of {which} is rejected.",
                        a(kind)
                    ))
                    .flags(&["duplicate-members"])
                    .decode(kind, text)
                    .rejects("malformed")
                    .because("One object has one member name twice, however many others it has."),
                );
            }
        }
    }
    cases
}

/// Two maps or two arrays of one message, each of which has all that it may have.
fn side_by_side() -> [Case; 2] {
    let at_limit = |kind: &str, first: &[&str], second: &[&str], fill: &dyn Fn(&str) -> Text| {
        let text = set(set(explicit(kind), first, Json::literal("\"~\"")), second, Json::literal("\"~\"")).text();
        let parts: Vec<&str> = text.split("\"~\"").collect();
        let [before, between, behind] = parts[..] else { return Text::from(text) };
        Text::concat([before.into(), fill(MARK), between.into(), fill(MARK), behind.into()])
    };
    let names = |mark: &str| entries_of(mark, "1", ENTRIES);
    let items = |mark: &str| list(mark, r#"{"name":"x"}"#, ENTRIES);
    let of = |kind: &'static str, name: &str, words: &str, text: Text| {
        Case::new(format!("{kind}/{name}"), &["NCP-WIRE-068"], readers(kind))
            .title(format!("{} with 4,096 {words} is read.", a(kind)))
            .flags(&["low-limits"])
            .decode(kind, text.clone())
            .means(text)
            .because("The limit of 4,096 is one of each map and of each array, and not of what a message has in all.")
    };
    let maps = at_limit("open_session", &["network", "population_sizes"], &["network", "params"], &names);
    let arrays = at_limit("capabilities", &["sensor_channels"], &["command_channels"], &items);
    [
        of("open_session", "map/two-at-limit", "entries in each of two maps of its network", maps),
        of("capabilities", "array/two-at-limit", "items in each of its two arrays", arrays),
    ]
}

/// Steps of a horizon whose channels have the names of those of a step before.
fn steps_of_shared_names() -> [Case; 2] {
    let kind = "command_frame";
    let step = |count| entries_of(MARK, "{}", count);
    let frame = |counts: [usize; 2]| {
        let text = set(explicit(kind), &["horizon"], Json::literal(MARK)).text();
        let (before, behind) = text.split_once(MARK).unwrap_or((&text, ""));
        let [first, second] = counts.map(step);
        Text::concat([format!("{before}[").into(), first, ",".into(), second, format!("]{behind}").into()])
    };
    let of = |name: &str, rule: &'static str| {
        Case::new(format!("{kind}/map/horizon-of-two-steps-{name}"), &[rule], readers(kind))
    };
    [
        of("beyond-limit", "NCP-WIRE-066")
            .title("A `command_frame` whose second step has the 4,096 channels of its first and one more is rejected.")
            .flags(&["missing-limits"])
            .decode(kind, frame([ENTRIES, ENTRIES + 1]))
            .rejects("limit")
            .because("A map of the tables may have 4,096 entries, whatever names others have."),
        of("at-limit", "NCP-WIRE-068")
            .title("A `command_frame` with 4,096 channels in each of two steps is read.")
            .flags(&["low-limits"])
            .decode(kind, frame([ENTRIES, ENTRIES]))
            .means(frame([ENTRIES, ENTRIES]))
            .because("A map may have 4,096 entries, whatever other maps of the frame have."),
    ]
}

/// Arrays of 4,096 items that are no numbers, and of one more.
fn arrays() -> Vec<Case> {
    let spec = explicit_message("ChannelSpec").text();
    let binding = explicit_message("EntityBinding").text();
    let record = explicit_message("RecordTarget").text();
    let stimulus = explicit_message("StimulusTarget").text();
    let places: [(&str, &[&str], &str); 7] = [
        ("command_frame", &["horizon"], "{}"),
        ("capabilities", &["sensor_channels"], &spec),
        ("capabilities", &["command_channels"], &spec),
        ("open_session", &["bindings"], &binding),
        ("open_session", &["record", "targets"], &record),
        ("open_session", &["record", "targets", "0", "recordables"], "\"x\""),
        ("open_session", &["stimulus", "targets"], &stimulus),
    ];
    let mut cases = Vec::new();
    for (kind, path, item) in places {
        let place = path.iter().filter(|part| **part != "0").copied().collect::<Vec<_>>().join("-");
        let member = path.join(".").replace(".0", "[0]");
        cases.push(
            Case::new(format!("{kind}/array/{place}-beyond-limit"), &["NCP-WIRE-067"], readers(kind))
                .title(format!("{} with 4,097 items in `{member}` is rejected.", a(kind)))
                .flags(&["missing-limits"])
                .decode(kind, list(&set(minimal(kind), path, Json::literal(MARK)).text(), item, ENTRIES + 1))
                .rejects("limit")
                .because("An array of the tables whose items are no numbers may have 4,096 items."),
        );
        if matches!(item, "{}" | "\"x\"") {
            cases.push(
                Case::new(format!("{kind}/array/{place}-beyond-2-to-16"), &["NCP-WIRE-067"], readers(kind))
                    .title(format!("{} with 65,537 items in `{member}` is rejected.", a(kind)))
                    .flags(&["missing-limits"])
                    .decode(kind, list(&set(minimal(kind), path, Json::literal(MARK)).text(), item, (1 << 16) + 1))
                    .rejects("limit")
                    .because("An array of the tables whose items are no numbers may have 4,096 items."),
            );
        }
        let text = list(&set(explicit(kind), path, Json::literal(MARK)).text(), item, ENTRIES);
        cases.push(
            Case::new(format!("{kind}/array/{place}-at-limit"), &["NCP-WIRE-068"], readers(kind))
                .title(format!("{} with 4,096 items in `{member}` is read.", a(kind)))
                .flags(&["low-limits"])
                .decode(kind, text.clone())
                .means(text)
                .because("An array may have 4,096 items."),
        );
    }
    cases
}

/// Maps and arrays that each keep their limit, and together have more: the limit is that of one.
fn sums() -> Vec<Case> {
    let item =
        |message: &str, path: &[&str], value: &str| set(explicit_message(message), path, Json::literal(value)).text();
    let value = explicit_message("ChannelValue").text();
    let horizon = format!("{{\"a\":{value},\"b\":{value},\"c\":{value}}}");
    let binding = item("EntityBinding", &["entity", "meta"], r#"{"a":"x","b":"y","c":"z"}"#);
    let record = item("RecordTarget", &["recordables"], r#"["V_m","g_ex","w"]"#);
    let stimulus = item("StimulusTarget", &["params"], r#"{"a":1.0,"b":2.0,"c":3.0}"#);
    let places: [(&str, &[&str], &str); 4] = [
        ("command_frame", &["horizon"], &horizon),
        ("open_session", &["bindings"], &binding),
        ("open_session", &["record", "targets"], &record),
        ("open_session", &["stimulus", "targets"], &stimulus),
    ];
    let mut cases: Vec<Case> = places
        .into_iter()
        .map(|(kind, path, item)| {
            let text = list(&set(explicit(kind), path, Json::literal(MARK)).text(), item, 1_500);
            sum(kind, &path.join("-"), text).title(format!(
                "{} with 1,500 items of 3 entries each in `{}` is read.",
                a(kind),
                path.join(".")
            ))
        })
        .collect();
    // Tens of thousands of values in all, within 1 MiB.
    let text = list(
        &explicit("command_frame").with("horizon", Json::literal(MARK)).text(),
        r#"{"a":{},"b":{},"c":{},"d":{}}"#,
        ENTRIES,
    );
    cases.push(
        sum("command_frame", "horizon-of-many", text)
            .title("A `command_frame` with 4,096 items of 4 entries each in `horizon` is read."),
    );
    // Written out, as an answer is, they are nearly as many bytes as a frame may have.
    let names = ["a", "b", "c", "d", "e", "f", "g", "h"];
    let wide = format!("{{{}}}", names.map(|name| format!("\"{name}\":{{}}")).join(","));
    let text = list(&explicit("command_frame").with("horizon", Json::literal(MARK)).text(), &wide, ENTRIES);
    cases.push(
        sum("command_frame", "horizon-of-most", text)
            .title("A `command_frame` with 4,096 items of 8 entries each in `horizon` is read."),
    );
    // More entries in all than 16 bits count.
    let entries: Vec<String> = (b'a'..=b'q').map(|name| format!("\"{}\":\"\"", char::from(name))).collect();
    let crowded = item("EntityBinding", &["entity", "meta"], &format!("{{{}}}", entries.join(",")));
    let text = list(&set(explicit("open_session"), &["bindings"], Json::literal(MARK)).text(), &crowded, ENTRIES);
    cases.push(
        sum("open_session", "bindings-of-more-than-16-bits", text)
            .title("An `open_session` with 4,096 items of 17 entries each in `bindings` is read."),
    );
    cases
}

fn sum(kind: &str, path: &str, text: Text) -> Case {
    Case::new(format!("{kind}/sum/{path}"), &["NCP-WIRE-068"], readers(kind))
        .flags(&["low-limits"])
        .decode(kind, text.clone())
        .means(text)
        .because("One map may have 4,096 entries, and one array as many items, whatever others have.")
}

/// Numeric arrays, which only the bytes of the frame limit.
fn numeric_arrays() -> Vec<Case> {
    let places: [(&str, &[&str], &str, usize); 12] = [
        ("sensor_frame", &["channels", "a", "data"], "0.25", 5_000),
        ("sensor_frame", &["channels", "b", "data"], "0.25", 200_000),
        ("command_frame", &["channels", "a", "data"], "-1.5", 5_000),
        ("command_frame", &["horizon", "0", "a", "data"], "-1.5", 5_000),
        ("stimulus_frame", &["values", "a", "data"], "100", 5_000),
        ("observation_frame", &["records", "a", "times"], "0.1", 400_000),
        ("observation_frame", &["records", "a", "values"], "-65.0", 5_000),
        ("observation_frame", &["records", "a", "senders"], "7", 5_000),
        // More than 1 MiB has room for.
        ("observation_frame", &["records", "a", "times"], "0.5", MIB + 1),
        ("observation_frame", &["records", "a", "senders"], "7", MIB + 1),
        ("open_session", &["record", "targets", "0", "ids"], "7", 5_000),
        ("open_session", &["stimulus", "targets", "0", "ids"], "7", 5_000),
    ];
    places
        .into_iter()
        .map(|(kind, path, item, count)| {
            let place = path.iter().filter(|part| !matches!(**part, "0" | "a")).copied().collect::<Vec<_>>().join("-");
            let member = path.join(".").replace(".0", "[0]");
            let items = Json::literal(MARK);
            let frame = match path {
                ["stimulus", ..] => {
                    let target = explicit_message("StimulusTarget").with("ids", items);
                    explicit(kind).with("stimulus", object! { "targets" => Json::Array(vec![target]) })
                }
                path => set(explicit(kind), path, items),
            };
            let text = list(&frame.text(), item, count);
            let rules: &[_] = if count > 300_000 { &["NCP-WIRE-069", "NCP-WIRE-063"] } else { &["NCP-WIRE-069"] };
            Case::new(format!("{kind}/numbers/{place}-{count}"), rules, readers(kind))
                .title(format!("{} with {count} numbers in `{member}` is read.", a(kind)))
                .flags(&["low-limits"])
                .decode(kind, text.clone())
                .means(text)
                .because("Nothing but the bytes of the frame limits a numeric array.")
        })
        .collect()
}

/// Long arrays of few values, of which 0 and -0 are two.
fn equal_numbers() -> Vec<Case> {
    let places: [(&str, &[&str]); 5] = [
        ("sensor_frame", &["channels", "a", "data"]),
        ("command_frame", &["channels", "a", "data"]),
        ("command_frame", &["horizon", "0", "a", "data"]),
        ("stimulus_frame", &["values", "a", "data"]),
        ("observation_frame", &["records", "a", "values"]),
    ];
    let mut cases = Vec::new();
    for (kind, path) in places {
        let place = path.iter().filter(|part| !matches!(**part, "0" | "a")).copied().collect::<Vec<_>>().join("-");
        let member = path.join(".").replace(".0", "[0]");
        for count in [17, 65, 129, 300] {
            for (order, first, last) in [("zero-first", "0.0", "-0.0"), ("zero-last", "-0.0", "0.0")] {
                let items = vec![first; count - 2].join(",");
                let data = format!("[{items},0.5,{last}]");
                let text = set(explicit(kind), path, Json::literal(data)).text();
                cases.push(
                    Case::new(
                        format!("{kind}/equal-numbers/{place}-{count}/{order}"),
                        &["NCP-WIRE-015"],
                        readers(kind),
                    )
                    .title(format!(
                        "{} whose `{member}` has {count} numbers, {first} many times and {last} at the end, is \
                             read to the sign.",
                        a(kind)
                    ))
                    .flags(&["signed-zero"])
                    .decode(kind, text.clone())
                    .means(text)
                    .because("0 and \u{2212}0 are two doubles, and a number is read as the double that is nearest."),
                );
            }
        }
    }
    cases
}

/// Frames of a million bytes that hold as many values as fit.
fn small_values() -> Vec<Case> {
    let mut cases = Vec::new();
    for kind in ANY {
        let frame = explicit(kind).text();
        for (what, item, says) in [
            ("arrays", "[]", "empty arrays"),
            ("objects", "{}", "empty objects"),
            ("zeros", "0", "zeros"),
            ("strings", "\"\"", "empty strings"),
        ] {
            // In rows, since a receiver may hold ignored arrays to 4,096 items too. [NCP-WIRE-071]
            let row = format!("[{}{item}]", format!("{item},").repeat(299));
            let item = row.as_str();
            let marked = with_raw(&frame, &format!("\"novel\":{MARK}"));
            let room = (MIB - marked.len()) / (item.len() + 1);
            cases.push(
                Case::new(format!("{kind}/small-values/{what}"), &["NCP-WIRE-070", "NCP-WIRE-061"], readers(kind))
                    .title(format!("{} of nearly 1 MiB that is full of {says} is read.", a(kind)))
                    .flags(&["amplification"])
                    .decode(kind, list(&marked, item, room))
                    .means(meaning(kind, &explicit(kind)).text())
                    .because("The frame is within its limit, and its memory within a small constant times that."),
            );
        }
    }
    cases
}
