//! Members that a frame has too many: unknown ones, which are ignored, and repeated ones, which
//! are not.

use super::READ;
use super::place::{Ground, Place};
use crate::case::{Case, File};
use crate::json::{Json, object};
use crate::model::{self, explicit, full, is_pin, meaning, minimal};
use crate::roles::{ANY, a, readers};
use crate::text::Default;

pub(super) fn file() -> File {
    let mut cases = unknown_values();
    cases.extend(unknown_everywhere());
    cases.extend(unknown_names());
    cases.extend(other_case_alone());
    cases.extend(unknown_overflow());
    cases.extend(repeated());
    cases.extend(not_repeated());
    cases.extend(not_wrapped());
    let about = "Unknown members, which every receiver ignores, and repeated ones, which every receiver rejects.";
    File::new("wire", "members", about, cases)
}

/// Every JSON type in a member that the tables do not list.
fn unknown_values() -> Vec<Case> {
    let values = [
        ("null", Json::Null),
        ("boolean", Json::Bool(true)),
        ("integer", Json::literal("1")),
        ("fraction", Json::literal("1.0")),
        ("negative-zero", Json::literal("-0")),
        ("large-integer", Json::literal("18446744073709551617")),
        ("string", Json::string("x")),
        ("empty-array", Json::Array(Vec::new())),
        ("mixed-array", Json::Array(vec![Json::literal("1"), Json::Null, Json::string("x"), Json::object()])),
        ("empty-object", Json::object()),
        ("object-of-known-names", object! { "kind" => Json::literal("5"), "seq" => "x", "session_id" => Json::Null }),
    ];
    let mut cases = Vec::new();
    for kind in ANY {
        for (what, value) in &values {
            let frame = explicit(kind).and("novel", value.clone());
            cases.push(ignored(&format!("unknown-value/{what}"), kind, &frame).title(format!(
                "{} with an unknown member whose value is {} is read as one without it.",
                a(kind),
                value.text()
            )));
        }
    }
    cases
}

/// An unknown member in every kind and in every message that stands within one.
fn unknown_everywhere() -> Vec<Case> {
    let places = Place::frames().chain(Place::nested());
    places
        .map(|place| {
            let message = place.alone(Ground::Explicit).and("novel", object! { "t" => Json::literal("1") });
            let frame = place.frame(Ground::Explicit, message);
            let (what, title) = match place.member("") {
                member if member.is_empty() => (
                    "unknown-member".to_owned(),
                    format!("{} with an unknown member is read as one without it.", a(place.kind)),
                ),
                member => {
                    let path = member.replace("[0]", "");
                    let parts: Vec<&str> = path.split('.').filter(|part| *part != "a").collect();
                    (
                        format!("unknown-member-in-{}", parts.join("-")),
                        format!("{} whose `{member}` has an unknown member is read as one without it.", a(place.kind)),
                    )
                }
            };
            let case = ignored(&what, place.kind, &frame).title(title);
            if place.is_nested() { with_rule(case, "NCP-WIRE-050") } else { case }
        })
        .collect()
}

/// Unknown names that a careless reader takes for known ones.
fn unknown_names() -> Vec<Case> {
    let five = Json::literal("5");
    let near = [
        ("command_frame", "ttlMs", "camel-case", "proto-json-names"),
        ("command_frame", "horizonDtMs", "camel-case-optional", "proto-json-names"),
        ("sensor_frame", "frameId", "camel-case", "proto-json-names"),
        ("step_request", "advanceMs", "camel-case", "proto-json-names"),
        ("command_frame", "Seq", "capital", "case-folded-names"),
        ("command_frame", "MODE", "upper-case", "case-folded-names"),
        ("sensor_frame", "seq ", "trailing-space", "trimmed-names"),
        ("sensor_frame", " seq", "leading-space", "trimmed-names"),
        ("close_session", "Session_id", "capital", "case-folded-names"),
        ("sensor_frame", "", "empty", "over-strict"),
        ("command_frame", "seq\u{0}", "with-nul", "nul-terminated-names"),
        ("command_frame", "ttl-ms", "hyphen", "case-folded-names"),
    ];
    let mut cases: Vec<Case> = near
        .into_iter()
        .map(|(kind, name, what, flag)| {
            let frame = explicit(kind).and(name, five.clone());
            ignored(&format!("unknown-name/{what}"), kind, &frame).flags(&[flag]).title(format!(
                "{} with the member {} is read as one without it.",
                a(kind),
                Json::string(name).text()
            ))
        })
        .collect();
    for kind in ANY {
        for name in ["__proto__", "constructor", "toString", "hasOwnProperty"] {
            let frame = explicit(kind).and(name, object! { "seq" => five.clone() });
            cases.push(
                ignored(&format!("unknown-name/{}", name.trim_matches('_').to_lowercase()), kind, &frame)
                    .flags(&["prototype-names"])
                    .title(format!("{} with a member named `{name}` is read as one without it.", a(kind))),
            );
        }
    }
    let frame = explicit("command_frame").without("mode").and("__proto__", object! { "mode" => "active" });
    cases.push(
        Case::new(
            "command_frame/unknown-name/proto-with-mode",
            &["NCP-WIRE-024", "NCP-WIRE-026"],
            readers("command_frame"),
        )
        .title("A `command_frame` without `mode`, but with a `__proto__` that has one, reads as `hold`.")
        .flags(&["prototype-names", "absent-mode-moves"])
        .decode("command_frame", frame.text())
        .means(meaning("command_frame", &frame).text())
        .because("`__proto__` is a member like any other unknown one, and the frame has no mode."),
    );
    cases
}

/// Every name in capitals, where the name itself is not there to win over it.
fn other_case_alone() -> Vec<Case> {
    let mut cases = Vec::new();
    for place in Place::frames() {
        for field in &place.message.fields {
            let name = field.name.to_uppercase();
            // Of a pin, the value that would break it.
            let value = match model::sample(place.message, field) {
                Json::Bool(pinned) if is_pin(&field.name) => Json::Bool(!pinned),
                sample => sample,
            };
            let path = format!("{}/other-case-alone/{}", place.kind, field.name);
            let says = format!("{} with `{name}` in the place of `{}`", a(place.kind), field.name);
            let frame = |ground| place.alone(ground).without(&field.name).and(&name, value.clone());
            let rule = match (&field.default, field.name.as_str()) {
                (Default::Kind, _) => Some(("NCP-WIRE-028", "kind")),
                (Default::Required, "error") => Some(("NCP-WIRE-101", "missing")),
                (Default::Required, _) => Some(("NCP-WIRE-027", "missing")),
                _ => None,
            };
            cases.push(match rule {
                None => other_case(path, &place, &frame(Ground::Explicit), &["NCP-WIRE-026"])
                    .title(format!("{says} is read with the default.")),
                Some((rule, code)) => Case::new(path, &[rule, "NCP-WIRE-026"], readers(place.kind))
                    .title(format!("{says} is rejected."))
                    .flags(&["case-folded-names"])
                    .decode(place.kind, frame(Ground::Minimal).text())
                    .rejects(code)
                    .because("The name in capitals is another name, so what is required is not there."),
            });
        }
    }
    let nested = Place::nested().into_iter();
    cases.extend(nested.filter(|place| !place.is_twin() && place.message.kind.is_none()).map(|place| {
        let names = model::full_message(&place.message.name);
        let capitals = names.members().iter().map(|(name, value)| (name.to_uppercase(), value.clone()));
        let message = Json::Object(capitals.collect());
        let path = format!("{}other-case-alone", place.label());
        other_case(path, &place, &place.frame(Ground::Explicit, message), &["NCP-WIRE-026", "NCP-WIRE-050"]).title(
            format!(
                "{} whose `{}` has its fields by names in capitals only is read with their defaults.",
                a(place.kind),
                place.member("")
            ),
        )
    }));
    cases
}

fn other_case(path: String, place: &Place, frame: &Json, rules: &[&'static str]) -> Case {
    Case::new(path, rules, readers(place.kind))
        .flags(&["case-folded-names"])
        .decode(place.kind, frame.text())
        .means(place.meaning(frame))
        .because("The tables do not list a name in capitals, and the field itself is absent.")
}

/// A number beyond a double within a member that is ignored.
fn unknown_overflow() -> Vec<Case> {
    ANY.into_iter()
        .map(|kind| {
            Case::new(format!("{kind}/unknown-value/overflow"), &["NCP-WIRE-014"], readers(kind))
                .title(format!("{} with an unknown member of 1e309 should be rejected.", a(kind)))
                .flags(&["overflow"])
                .decode(kind, minimal(kind).and("novel", Json::literal("1e309")).text())
                .rejects("malformed")
                .because("The nearest double is infinite, also where nobody looks.")
        })
        .collect()
}

fn ignored(what: &str, kind: &str, frame: &Json) -> Case {
    Case::new(format!("{kind}/{what}"), &["NCP-WIRE-026"], readers(kind))
        .flags(&["closed-objects"])
        .decode(kind, frame.text())
        .means(meaning(kind, frame).text())
        .because("The tables do not list the member, so the frame means what it means without it.")
}

fn with_rule(mut case: Case, rule: &'static str) -> Case {
    case.requirements.push(rule);
    case
}

/// Members that stand there twice.
fn repeated() -> Vec<Case> {
    let one = || Json::literal("1");
    let two = || Json::literal("2");
    let mut table: Vec<(&str, String, Json, &str)> = Vec::new();
    for kind in ANY {
        let frame = minimal(kind);
        let deep = object! { "b" => Json::Array(vec![object! { "c" => object! { "d" => one() }.and("d", one()) }]) };
        let known = match kind {
            "close_session" => frame.clone().and("session_id", Json::string("s2")),
            _ => frame.clone().and("seq", one()).and("seq", two()),
        };
        let escaped = match kind {
            "close_session" => frame.text().replace('}', r#","s\u0065ssion_id":"s2"}"#),
            _ => frame.text().replace('}', r#","seq":1,"s\u0065q":2}"#),
        };
        let far = (0..40)
            .fold(frame.clone().and("n", one()), |frame, nth| frame.and(&format!("n{nth}"), one()))
            .and("n", one());
        let long = "n".repeat(300);
        table.extend([
            (kind, "known".into(), known, "a known member twice"),
            (kind, "kind".into(), frame.clone().and("kind", Json::string(kind)), "the same `kind` twice"),
            (
                kind,
                "unknown".into(),
                frame.clone().and("novel", one()).and("novel", one()),
                "an unknown member twice, with one value",
            ),
            (
                kind,
                "unknown-after-null".into(),
                frame.clone().and("novel", Json::Null).and("novel", one()),
                "an unknown member twice, first as null",
            ),
            (
                kind,
                "unknown-nested".into(),
                frame.clone().and("novel", object! { "x" => one() }.and("x", two())),
                "a member twice within an unknown one",
            ),
            (
                kind,
                "unknown-deep".into(),
                frame.clone().and("novel", object! { "a" => deep.clone() }),
                "a member twice five levels deep within an unknown one",
            ),
            (
                kind,
                "unknown-in-array".into(),
                frame.clone().and("novel", Json::Array(vec![one(), object! { "x" => one() }.and("x", one())])),
                "a member twice within an object in an unknown array",
            ),
            (
                kind,
                "empty-name".into(),
                frame.clone().and("", one()).and("", two()),
                "a member with an empty name twice",
            ),
            (kind, "proto".into(), frame.clone().and("__proto__", one()).and("__proto__", two()), "`__proto__` twice"),
            (kind, "far-apart".into(), far, "a member twice with forty others between"),
            (
                kind,
                "long-name".into(),
                frame.clone().and(&long, one()).and(&long, two()),
                "a member of a long name twice",
            ),
            (
                kind,
                "escaped".into(),
                Json::literal(escaped),
                "a known member twice, the second time with an escape in its name",
            ),
            (
                kind,
                "escaped-unknown".into(),
                Json::literal(frame.text().replace('}', r#","novel":1,"\u006eovel":1}"#)),
                "an unknown member twice, the second time with an escape in its name",
            ),
            (
                kind,
                "escaped-astral".into(),
                Json::literal(frame.text().replace('}', ",\"\u{1f600}\":1,\"\\ud83d\\ude00\":1}")),
                "an unknown member twice, once as a character beyond the BMP and once as its two escapes",
            ),
        ]);
    }
    let unit = || object! { "unit" => "m" }.and("unit", Json::string("m"));
    let twice = || object! { "a" => Json::object() }.and("a", Json::object());
    let frame = |kind: &str, name: &str, value: Json| minimal(kind).and(name, value);
    let sensor = |value| frame("sensor_frame", "channels", value);
    let command = |name: &str, value| frame("command_frame", name, value);
    let open = |name: &str, value| minimal("open_session").with(name, value);
    table.extend([
        ("sensor_frame", "channel-name".into(), sensor(twice()), "the same channel twice"),
        (
            "sensor_frame",
            "within-channel".into(),
            sensor(object! { "a" => unit() }),
            "a member twice within a channel value",
        ),
        (
            "sensor_frame",
            "unknown-within-channel".into(),
            sensor(object! { "a" => object! { "x" => one() }.and("x", one()) }),
            "an unknown member twice within a channel value",
        ),
        (
            "sensor_frame",
            "escaped-channel-name".into(),
            Json::literal(sensor(twice()).text().replacen(r#","a":"#, r#","\u0061":"#, 1)),
            "the same channel twice, the second time with an escape",
        ),
        (
            "sensor_frame",
            "three-times".into(),
            minimal("sensor_frame").and("t", one()).and("t", one()).and("t", one()),
            "a member three times",
        ),
        (
            "command_frame",
            "mode-hold-then-active".into(),
            minimal("command_frame").and("mode", "hold".into()).and("mode", "active".into()),
            "`mode` twice, first `hold`, then `active`",
        ),
        (
            "command_frame",
            "mode-active-then-hold".into(),
            minimal("command_frame").and("mode", "active".into()).and("mode", "hold".into()),
            "`mode` twice, first `active`, then `hold`",
        ),
        (
            "command_frame",
            "ttl-twice".into(),
            minimal("command_frame").and("ttl_ms", one()).and("ttl_ms", Json::literal("1.0")),
            "`ttl_ms` twice, with one value in two spellings",
        ),
        ("command_frame", "channel-name".into(), command("channels", twice()), "the same channel twice"),
        (
            "command_frame",
            "within-channel".into(),
            command("channels", object! { "a" => unit() }),
            "a member twice within a channel value",
        ),
        (
            "command_frame",
            "horizon-channel-name".into(),
            command("horizon", Json::Array(vec![twice()])),
            "the same channel twice within a step of the horizon",
        ),
        (
            "command_frame",
            "within-horizon-channel".into(),
            command("horizon", Json::Array(vec![object! { "a" => unit() }])),
            "a member twice within a channel value of the horizon",
        ),
        (
            "open_session",
            "within-network".into(),
            open("network", object! { "ref" => "x" }.and("ref", Json::string("y"))),
            "a member twice within `network`",
        ),
        (
            "open_session",
            "network-params".into(),
            open("network", object! { "params" => object! { "a" => one() }.and("a", two()) }),
            "the same parameter twice",
        ),
        (
            "open_session",
            "population-sizes".into(),
            open("network", object! { "population_sizes" => object! { "a" => one() }.and("a", two()) }),
            "the same population twice",
        ),
        (
            "open_session",
            "within-record-target".into(),
            open(
                "record",
                object! { "targets" => Json::Array(vec![object! { "port" => "p" }.and("port", Json::string("q"))]) },
            ),
            "a member twice within a record target",
        ),
        (
            "open_session",
            "within-sim".into(),
            open("sim", object! { "seed" => one() }.and("seed", one())),
            "a member twice within `sim`",
        ),
        (
            "open_session",
            "entity-meta".into(),
            open(
                "bindings",
                Json::Array(vec![
                    object! { "entity" => object! { "meta" => object! { "a" => "x" }.and("a", Json::string("x")) } },
                ]),
            ),
            "the same annotation twice within an entity of a binding",
        ),
        (
            "step_request",
            "within-stimulus".into(),
            minimal("step_request").and("stimulus", object! { "t" => one() }.and("t", one())),
            "a member twice within its stimulus frame",
        ),
        (
            "session_opened",
            "resolved".into(),
            minimal("session_opened").and("resolved", object! { "a" => one() }.and("a", two())),
            "the same population twice within `resolved`",
        ),
        (
            "session_opened",
            "within-provenance".into(),
            minimal("session_opened").and("provenance", object! { "seed" => one() }.and("seed", one())),
            "a member twice within its provenance",
        ),
        (
            "observation_frame",
            "records".into(),
            minimal("observation_frame").and("records", twice()),
            "the same port twice within `records`",
        ),
        (
            "observation_frame",
            "within-record".into(),
            minimal("observation_frame").and(
                "records",
                object! { "a" => object! { "times" => Json::Array(Vec::new()) }.and("times", Json::Array(Vec::new())) },
            ),
            "a member twice within a record",
        ),
        (
            "observation_frame",
            "pin".into(),
            minimal("observation_frame")
                .and("is_simulation_output", false.into())
                .and("is_simulation_output", true.into()),
            "a pin twice, the first time broken",
        ),
        (
            "capabilities",
            "within-safety".into(),
            minimal("capabilities").and("safety", object! { "max_speed_mps" => one() }.and("max_speed_mps", two())),
            "a limit twice within `safety`",
        ),
        (
            "capabilities",
            "within-channel-spec".into(),
            minimal("capabilities")
                .and("sensor_channels", Json::Array(vec![object! { "name" => "a" }.and("name", Json::string("b"))])),
            "a member twice within a channel's specification",
        ),
        ("error", "error".into(), minimal("error").and("error", "y".into()), "`error` twice"),
    ]);
    table
        .into_iter()
        .map(|(kind, what, frame, says)| {
            Case::new(format!("{kind}/repeated/{what}"), &["NCP-WIRE-007"], readers(kind))
                .title(format!("{} with {says} is rejected.", a(kind)))
                .flags(&["duplicate-members"])
                .decode(kind, frame.text())
                .rejects("malformed")
                .because("One object has one member name twice; where that object stands does not matter.")
        })
        .collect()
}

/// Members that look repeated and are not.
fn not_repeated() -> Vec<Case> {
    let one = || Json::literal("1");
    let channel = |unit: &str| object! { "data" => Json::Array(Vec::new()), "unit" => unit };
    let mut cases = Vec::new();
    for kind in ANY {
        let frame = explicit(kind);
        let table = [
            (
                "other-case",
                frame.clone().and("novel", one()).and("Novel", one()),
                "two unknown members whose names differ in case",
            ),
            (
                "other-normal-form",
                frame.clone().and("\u{e9}", one()).and("e\u{301}", one()),
                "two unknown members whose names differ in their normal form",
            ),
            (
                "other-depth",
                frame.clone().and("novel", object! { "novel" => object! { "novel" => one() } }),
                "the same unknown name at three depths",
            ),
            (
                "siblings",
                frame.clone().and("novel", Json::Array(vec![object! { "x" => one() }, object! { "x" => one() }])),
                "the same name in two unknown objects side by side",
            ),
            (
                "prefix",
                frame.clone().and("a", one()).and("aa", one()).and("a\u{0}", one()),
                "unknown names of which one begins another",
            ),
            (
                "known-names-below",
                frame.clone().and("novel", full(kind)),
                "its own field names again within an unknown member",
            ),
        ];
        for (what, frame, says) in table {
            cases.push(
                ignored(&format!("not-repeated/{what}"), kind, &frame)
                    .flags(&["duplicate-members"])
                    .title(format!("{} with {says} is read.", a(kind))),
            );
        }
    }
    for kind in ["sensor_frame", "command_frame"] {
        let maps = [
            (
                "channels-other-case",
                object! { "a" => channel("m"), "A" => channel("rad") },
                "two channels whose names differ in case",
            ),
            (
                "channels-other-normal-form",
                object! { "\u{e9}" => channel("m"), "e\u{301}" => channel("rad") },
                "two channels whose names differ in their normal form",
            ),
            (
                "channels-of-prototype",
                object! { "__proto__" => channel("m"), "constructor" => channel("rad"), "toString" => channel("m/s") },
                "channels named `__proto__`, `constructor` and `toString`",
            ),
            (
                "channels-of-digits",
                object! { "10" => channel("m"), "9" => channel("rad"), "1" => channel("m/s") },
                "channels named by numbers",
            ),
            ("channel-of-empty-name", object! { "" => channel("m") }, "a channel of an empty name"),
            (
                "channel-of-mark",
                object! { "\u{feff}a" => channel("m"), "a" => channel("rad") },
                "channels of which one has the other's name behind U+FEFF",
            ),
            (
                "channel-of-field-name",
                object! { "seq" => channel("m"), "kind" => channel("rad") },
                "channels named like fields",
            ),
        ];
        for (what, channels, says) in maps {
            let frame = explicit(kind).with("channels", channels);
            let flag = if what.ends_with("prototype") { "prototype-names" } else { "lost-fields" };
            cases.push(
                Case::new(format!("{kind}/not-repeated/{what}"), &["NCP-WIRE-068"], readers(kind))
                    .title(format!("{} with {says} keeps each of them.", a(kind)))
                    .flags(&[flag])
                    .decode(kind, frame.text())
                    .means(meaning(kind, &frame).text())
                    .because("A map is an object whose member names are the channel names, letter for letter."),
            );
        }
    }
    let frame = explicit("close_session").text().replace("\"kind\"", r#""k\u0069nd""#);
    cases.push(
        Case::new("close_session/not-repeated/escaped-kind", &[READ], readers("close_session"))
            .title("A `close_session` whose `kind` is spelled with an escape in its name is read.")
            .flags(&["raw-names"])
            .decode("close_session", frame)
            .means(explicit("close_session").text())
            .because("Member names are equal when they are so after their escapes are resolved."),
    );
    cases
}

/// Steps of a horizon that look like the proto's `SetpointStep`, whose one member is `channels`.
fn not_wrapped() -> Vec<Case> {
    let kind = "command_frame";
    let one = || Json::Array(vec![Json::literal("1.5")]);
    let channel = || object! { "data" => one(), "unit" => "m/s" };
    let frame = |ground: Json, step: Json| ground.with("horizon", Json::Array(vec![step]));
    let read = [
        ("alone", object! { "channels" => channel() }, "one channel, named `channels`,"),
        (
            "of-channels",
            object! { "channels" => object! { "a" => channel(), "b" => channel() } },
            "one channel, named `channels`, that has two unknown members",
        ),
        ("empty", object! { "channels" => Json::object() }, "one channel, named `channels`, that is empty"),
        (
            "beside",
            object! { "a" => channel(), "channels" => object! { "b" => channel() } },
            "a channel named `channels` beside another",
        ),
    ];
    let rejected = [
        ("data", object! { "data" => channel() }, "has an object for `data`"),
        ("unit", object! { "unit" => channel() }, "has an object for `unit`"),
    ];
    let read = read.into_iter().map(|(what, step, says)| {
        let frame = frame(explicit(kind), step);
        Case::new(format!("{kind}/not-wrapped/{what}"), &[READ, "NCP-WIRE-026", "NCP-WIRE-050"], readers(kind))
            .title(format!("A `{kind}` whose horizon has a step of {says} is read with that channel."))
            .flags(&["unwrapped-horizon"])
            .decode(kind, frame.text())
            .means(meaning(kind, &frame).text())
            .because("A step is a map of channels without the proto's wrapper, so `channels` is a channel's name.")
    });
    let rejected = rejected.into_iter().map(|(what, value, says)| {
        let step = object! { "channels" => value };
        Case::new(format!("{kind}/not-wrapped/{what}-of-wrong-type"), &["NCP-WIRE-020", "NCP-WIRE-050"], readers(kind))
            .title(format!(
                "A `{kind}` whose horizon has a step of a channel named `channels` that {says} is rejected."
            ))
            .flags(&["unwrapped-horizon"])
            .decode(kind, frame(minimal(kind), step).text())
            .rejects("type")
            .because("`channels` is a channel's name there, and no ChannelValue has an object in that field.")
    });
    read.chain(rejected).collect()
}
