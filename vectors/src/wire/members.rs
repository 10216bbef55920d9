//! Members that a frame has too many: unknown ones, which are ignored, and repeated ones, which
//! are not.

use super::READ;
use super::encode::{reversed, zeros_of_both_signs};
use super::kinds::kinds;
use super::place::{Ground, Place};
use crate::case::{Case, File};
use crate::json::{Json, object};
use crate::model::{self, explicit, explicit_message, full, is_pin, meaning, minimal};
use crate::names;
use crate::patch::{self, patched};
use crate::roles::{ANY, a, readers};
use crate::scenario::{Row, ScenarioError, Scenarios, beside, source};
use crate::trace::nums;
use ncp_text::tables::Default;

pub(super) fn file() -> Result<File, ScenarioError> {
    let mut text = Scenarios::read(source!("wire/members"))?;
    let mut cases = unknown_values();
    cases.extend(unknown_everywhere());
    cases.extend(unknown_names());
    cases.extend(names_like_fields());
    cases.extend(fields_of_another());
    cases.extend(other_case_alone());
    cases.extend(unknown_overflow());
    cases.extend(versions_within());
    cases.extend(text.cases("repeated", repeated)?);
    cases.extend(text.cases("repeated-within", repeated)?);
    cases.extend(text.rest(not_repeated)?);
    cases.extend(of_all_names());
    cases.extend(empty_errors());
    cases.extend(zeros());
    cases.push(escaped_kind());
    cases.extend(escaped());
    cases.extend(not_wrapped());
    cases.push(far_apart());
    cases.extend(version_of_an_error());
    cases.extend(backwards());
    let about = "Unknown members, which every receiver ignores, and repeated ones, which every receiver rejects.";
    Ok(File::new("wire", "members", about, cases))
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

/// Maps of all names that are alike, and of names that spell the way to a member of another.
fn of_all_names() -> Vec<Case> {
    let mut cases =
        maps_of("names-alike", "all names that are alike", || names::alike().map(|(name, _)| name)).to_vec();
    cases.extend(maps_of("names-like-paths", "names like paths", || names::PATHS.into_iter()));
    cases
}

/// Maps of these names, of which each has a value of its own.
fn maps_of<Names: Iterator<Item = &'static str>>(path: &str, words: &str, of: impl Fn() -> Names) -> [Case; 5] {
    let names = || (1_u32..).zip(of()).map(|(nth, name)| (name, nth));
    let map = |of: &dyn Fn(u32) -> Json| Json::Object(names().map(|(name, nth)| (name.to_owned(), of(nth))).collect());
    let value = |nth| explicit_message("ChannelValue").with("data", nums(&[f64::from(nth)]));
    let sample = |nth| explicit_message("Observation").with("times", nums(&[f64::from(nth)]));
    let stimulus = explicit("stimulus_frame").with("values", map(&value));
    [
        ("sensor_frame", "channels", map(&value)),
        ("command_frame", "channels", map(&value)),
        ("command_frame", "horizon", Json::Array(vec![map(&value)])),
        ("step_request", "stimulus", stimulus),
        ("observation_frame", "records", map(&sample)),
    ]
    .map(|(kind, field, value)| {
        let frame = explicit(kind).with(field, value);
        Case::new(format!("{kind}/{path}/{field}"), &[READ], readers(kind))
            .title(format!("{} whose `{field}` has {words} is read with each of them.", a(kind)))
            .flags(&["lost-fields"])
            .decode(kind, frame.text())
            .means(meaning(kind, &frame).text())
            .because("Every field has the value that the frame gives it, and a name is another by its least letter.")
    })
}

/// Frames without a version, within whose messages an unknown member has the name of one.
fn versions_within() -> Vec<Case> {
    let nested = Place::nested().into_iter().filter(|place| !place.is_twin() && place.message.kind.is_none());
    let case = |place: Place| {
        let message = place.alone(Ground::Explicit).and("ncp_version", "9000.1".into());
        let frame = place.frame(Ground::Explicit, message).without("ncp_version");
        Case::new(format!("{}version-within", place.label()), &["NCP-WIRE-033", "NCP-WIRE-026"], readers(place.kind))
            .title(format!(
                "{} without a version is read whose `{}` has an unknown member `ncp_version`.",
                a(place.kind),
                place.member("")
            ))
            .flags(&["over-strict"])
            .decode(place.kind, frame.text())
            .means(place.meaning(&frame))
            .because("The version of a frame is its own member, and an unknown member is ignored.")
    };
    nested.map(case).collect()
}

/// Error frames that say nothing.
fn empty_errors() -> [Case; 3] {
    let frame = || object! { "kind" => "error", "error" => "" };
    let table = [
        ("alone", frame()),
        ("session-null", frame().with("session_id", Json::Null)),
        ("session-empty", frame().with("session_id", "".into())),
    ];
    table.map(|(name, frame)| {
        Case::new(format!("error/empty/{name}"), &["NCP-WIRE-100"], readers("error"))
            .title(format!("An error frame with an empty error ({}) is read.", name.replace('-', " ")))
            .flags(&["over-strict"])
            .decode("error", frame.text())
            .accepts()
            .because("A client reads a reply of kind `error` as an error frame, whatever it says.")
    })
}

/// Channels whose data are the same to who compares them as numbers.
fn zeros() -> [Case; 2] {
    ["sensor_frame", "command_frame"].map(|kind| {
        let frame = explicit(kind).with("channels", zeros_of_both_signs(&Json::literal("-0.0")));
        Case::new(format!("{kind}/zeros-of-both-signs"), &["NCP-WIRE-015", READ], readers(kind))
            .title(format!("{} whose channels have zeros of both signs is read with each of them.", a(kind)))
            .flags(&["lossy-doubles"])
            .decode(kind, frame.text())
            .means(meaning(kind, &frame).text())
            .because("A number is the nearest double, and −0 is another than 0.")
    })
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

/// All names of a message's fields in the ways in which a careless reader takes another name for them.
fn names_like_fields() -> Vec<Case> {
    let places = Place::frames().chain(Place::nested()).filter(|place| !place.is_twin());
    places
        .map(|place| {
            let mut message = place.alone(Ground::Explicit);
            for field in &place.message.fields {
                for name in like_a_field(&field.name) {
                    message = message.and(&name, Json::Array(vec![Json::Bool(true)]));
                }
            }
            let frame = place.frame(Ground::Explicit, message);
            let (path, rules, whose): (_, &[_], _) = match place.is_nested() {
                true => (place.label(), &["NCP-WIRE-026", "NCP-WIRE-050"], format!(" whose `{}`", place.member(""))),
                false => (format!("{}/", place.kind), &["NCP-WIRE-026"], String::new()),
            };
            let path = format!("{path}names-like-fields");
            Case::new(path, rules, readers(place.kind))
                .flags(&["case-folded-names"])
                .decode(place.kind, frame.text())
                .means(place.meaning(&frame))
                .title(format!(
                    "{}{whose} has unknown members whose names are like those of its fields is read as one without \
                     them.",
                    a(place.kind)
                ))
                .because("A receiver ignores a member that the tables do not list, and a name is just its characters.")
        })
        .collect()
}

/// An unknown member before and behind all others, in which every field has another value: who looks for a name in the
/// bytes finds the wrong one.
fn fields_of_another() -> Vec<Case> {
    let case = |(kind, is_first): (&'static str, bool)| {
        let other = full_message_of(kind).with("kind", "close_session".into());
        let other = if other.get("session_id").is_some() { other.with("session_id", "other".into()) } else { other };
        let frame = match is_first {
            true => explicit(kind)
                .members()
                .iter()
                .fold(object! { "novel" => other }, |frame, (name, value)| frame.and(name, value.clone())),
            false => explicit(kind).and("novel", other),
        };
        let place = if is_first { "first" } else { "last" };
        ignored(&format!("fields-of-another/{place}"), kind, &frame).title(format!(
            "{} with an unknown member, the {place} of all, that has each of its fields is read as one without it.",
            a(kind)
        ))
    };
    Place::frames().map(|place| place.kind).flat_map(|kind| [true, false].map(|first| case((kind, first)))).collect()
}

/// All fields of a kind, each with a value that is not its default.
fn full_message_of(kind: &str) -> Json {
    Place::frames()
        .find(|place| place.kind == kind)
        .map_or(Json::Null, |place| model::full_message(&place.message.name))
}

/// Names that are no field's, and like this one when case is folded, form or width changed, or what is not seen
/// dropped.
fn like_a_field(name: &str) -> Vec<String> {
    let folded = [('s', '\u{17f}'), ('k', '\u{212a}'), ('i', '\u{131}'), ('_', '-'), ('_', ' '), ('_', '\u{ff3f}')];
    let folded = folded.iter().map(|(from, to)| name.replace(*from, &to.to_string())).filter(|like| like != name);
    let mut letters = name.chars();
    let first = letters.next().and_then(|first| char::from_u32(u32::from(first) + 0xfee0));
    let wide = first.map(|first| format!("{first}{}", letters.as_str()));
    let around = ["%\0", "%\u{301}", "%\u{200b}", "\u{feff}%", "%\u{ad}", "%\n", "$%", "@%", "%.", "%[]", "\"%\""];
    folded.chain(wide).chain(around.map(|like| like.replace('%', name))).collect()
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

/// A row of members that stand there twice.
fn repeated(row: &Row) -> Result<Case, ScenarioError> {
    let kind = row.kind()?;
    let frame = patched(minimal(kind), &row.text("changes")?, row.place)?;
    Ok(row.case(readers(kind)).decode(kind, frame.text()).rejects("malformed"))
}

/// A row of members that look repeated and are not.
fn not_repeated(row: &Row) -> Result<Case, ScenarioError> {
    let kind = row.kind()?;
    let frame = match row.cell("changes")? {
        "full" => explicit(kind).and("novel", full(kind)),
        changes => patched(explicit(kind), changes, row.place)?,
    };
    Ok(row.case(readers(kind)).decode(kind, frame.text()).means(meaning(kind, &frame).text()))
}

/// A member twice, with hundreds of others between.
fn far_apart() -> Case {
    let kind = "close_session";
    let one = || 1_u32.into();
    let between = (0..260).fold(minimal(kind).and("n", one()), |frame, nth| frame.and(&format!("n{nth}"), one()));
    Case::new(format!("{kind}/repeated/farther-apart"), &["NCP-WIRE-007"], readers(kind))
        .title(format!("{} with a member twice with 260 others between is rejected.", a(kind)))
        .flags(&["duplicate-members"])
        .decode(kind, between.and("n", one()).text())
        .rejects("malformed")
        .because("One object has one member name twice, however far apart.")
}

/// A version in an error frame, which has none: it is ignored.
fn version_of_an_error() -> Vec<Case> {
    versions_of_errors()
        .into_iter()
        .map(|(what, version)| {
            let frame = minimal("error").and("ncp_version", Json::literal(version.as_str()));
            ignored(&format!("unknown-name/version-{what}"), "error", &frame)
                .title(format!("An error frame with the member `ncp_version` of {version} is read as one without it."))
        })
        .collect()
}

/// What may stand in a member `ncp_version` of an error frame, and what it is called.
pub(crate) fn versions_of_errors() -> [(&'static str, String); 3] {
    [("older", format!("\"{}\"", beside(-1))), ("malformed", "\"latest\"".to_owned()), ("null", "null".to_owned())]
}

/// Frames with all of their members in reverse, at every level.
fn backwards() -> Vec<Case> {
    ["command_frame", "step_request"]
        .into_iter()
        .map(|kind| {
            let frame = full(kind);
            Case::new(format!("{kind}/backwards"), &[READ], readers(kind))
                .title(format!("{} whose members stand in reverse, at every level, is read as in any order.", a(kind)))
                .flags(&["lost-fields"])
                .decode(kind, reversed(frame.clone()).text())
                .means(meaning(kind, &frame).text())
                .because("Every field has the value that the frame gives it, wherever it stands in its object.")
        })
        .collect()
}

fn escaped_kind() -> Case {
    let frame = explicit("close_session").text().replace("\"kind\"", r#""k\u0069nd""#);
    Case::new("close_session/not-repeated/escaped-kind", &[READ], readers("close_session"))
        .title("A `close_session` whose `kind` is spelled with an escape in its name is read.")
        .flags(&["raw-names"])
        .decode("close_session", frame)
        .means(explicit("close_session").text())
        .because("Member names are equal when they are so after their escapes are resolved.")
}

/// Frames whose every name and every string has an escape: for its first letter, for its last, or for all.
fn escaped() -> Vec<Case> {
    type Is = fn(usize, usize) -> bool;
    let letters: [(&str, &str, Is); 2] =
        [("first", "first letter", |nth, _| nth == 0), ("last", "last letter", |nth, count| nth + 1 == count)];
    let throughout: (&str, &str, Is) = ("throughout", "every letter", |_, _| true);
    let each = kinds().flat_map(|kind| letters.map(|letter| (kind, letter)));
    let all = each.chain(["sensor_frame", "command_frame", "open_session"].map(|kind| (kind, throughout)));
    let one = |(kind, (path, words, is)): (&'static str, (&str, &str, Is))| {
        let frame = full(kind);
        Case::new(format!("{kind}/escaped/{path}"), &[READ], readers(kind))
            .title(format!("{} is read in which the {words} of every name and string is an escape.", a(kind)))
            .flags(&["raw-names"])
            .decode(kind, with_escapes(&frame.text(), is))
            .means(meaning(kind, &frame).text())
            .because("A string is what its escapes stand for, and so is a name.")
    };
    all.map(one).collect()
}

/// The text with those letters of its strings as escapes that a function chooses by their number and how many there
/// are.
fn with_escapes(text: &str, is: fn(usize, usize) -> bool) -> String {
    // Every second part stands between quotation marks; the frames have none within their strings.
    let escaped = |part: &str| patch::escaped(part, |nth| is(nth, part.chars().count()));
    let parts = text.split('"').enumerate();
    let parts = parts.map(|(nth, part)| if nth % 2 == 1 { escaped(part) } else { part.to_owned() });
    parts.collect::<Vec<_>>().join("\"")
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
