//! The two pins of chapter 6, on every frame that carries them.

use crate::case::Role::Commander;
use crate::case::{Case, File};
use crate::json::{Json, object};
use crate::model::{explicit, explicit_message, meaning, minimal};
use crate::roles::{a, readers};
use crate::template::Text;

/// The kind, whether the pins stand in its `provenance`, the pin, its value, and the rule.
const PINS: [(&str, bool, &str, bool, &str); 4] = [
    ("observation_frame", false, "calibrated_posterior", false, "NCP-PROV-001"),
    ("observation_frame", false, "is_simulation_output", true, "NCP-PROV-002"),
    ("session_opened", true, "calibrated_posterior", false, "NCP-PROV-003"),
    ("session_opened", true, "is_simulation_output", true, "NCP-PROV-004"),
];

pub(super) fn file() -> File {
    let mut cases = Vec::new();
    for (kind, nested, pin, pinned, rule) in PINS {
        let id = |what: &str| format!("{kind}/{pin}/{what}");
        let bare = |value: Json| match nested {
            true => minimal(kind).with("provenance", object! { pin => value }),
            false => minimal(kind).with(pin, value),
        };
        let whole = |change: &dyn Fn(Json) -> Json| match nested {
            true => explicit(kind).with("provenance", change(explicit_message("SimProvenance"))),
            false => change(explicit(kind)),
        };
        let member = if nested { format!("provenance.{pin}") } else { pin.to_owned() };
        let broken = [
            ("flipped", Json::Bool(!pinned), None),
            ("null", Json::Null, Some("NCP-WIRE-021")),
            ("zero", Json::literal("0"), Some("NCP-WIRE-020")),
            ("one", Json::literal("1"), Some("NCP-WIRE-020")),
            ("negative-zero", Json::literal("-0"), Some("NCP-WIRE-020")),
            ("zero-with-a-point", Json::literal("0.0"), Some("NCP-WIRE-020")),
            ("one-with-a-point", Json::literal("1.0"), Some("NCP-WIRE-020")),
            ("one-with-an-exponent", Json::literal("1e0"), Some("NCP-WIRE-020")),
            ("string", Json::string(if pinned { "true" } else { "false" }), Some("NCP-WIRE-020")),
            ("empty-string", Json::string(""), Some("NCP-WIRE-020")),
            ("array", Json::Array(Vec::new()), Some("NCP-WIRE-020")),
            ("object", Json::object(), Some("NCP-WIRE-020")),
        ];
        cases.extend(broken.into_iter().map(|(what, value, also)| {
            let mut rules = vec![rule];
            rules.extend(also);
            Case::new(id(what), &rules, readers(kind))
                .title(format!("{} whose `{member}` is {} is rejected.", a(kind), value.text()))
                .flags(&[if also.is_some() { "truthy-pins" } else { "unchecked-pins" }])
                .decode(kind, bare(value).text())
                .rejects("provenance")
                .because(format!("The pin is present and not exactly `{pinned}`."))
        }));
        for (what, frame, says, rule) in [
            ("pinned", whole(&|message| message), format!("is {pinned}"), rule),
            ("absent", whole(&|message| message.without(pin)), "is absent".to_owned(), "NCP-PROV-005"),
        ] {
            cases.push(
                Case::new(id(what), &[rule], readers(kind))
                    .title(format!("{} whose `{member}` {says} is read, with the pin at {pinned}.", a(kind)))
                    .flags(&["wrong-defaults"])
                    .decode(kind, frame.text())
                    .means(meaning(kind, &frame).text())
                    .because(format!("The pin holds; absent, it is `{pinned}`.")),
            );
        }
    }
    cases.extend(beside());
    cases.extend(of_backends());
    cases.extend(in_large_frames());
    let about = "The pins `calibrated_posterior` and `is_simulation_output`: exactly their pinned values, or absent.";
    File::new("wire", "pins", about, cases)
}

/// A flipped pin before and behind so much that a receiver might read the frame on a faster road.
fn in_large_frames() -> Vec<Case> {
    const SHAPES: [(&str, &str, usize); 2] =
        [("64-kib", "more than 64 KiB", 20_000), ("1-mib", "more than 1 MiB", 300_000)];
    let mut cases = Vec::new();
    for (kind, nested, pin, pinned, rule) in PINS {
        let member = if nested { format!("provenance.{pin}") } else { pin.to_owned() };
        let broken =
            if nested { format!("\"provenance\":{{\"{pin}\":{}}}", !pinned) } else { format!("\"{pin}\":{}", !pinned) };
        let front = minimal(kind).text();
        let front = front.strip_suffix('}').unwrap_or(&front);
        // Of the two kinds only an observation may be longer than 1 MiB.
        for (size, words, count) in SHAPES.into_iter().take(if nested { 1 } else { 2 }) {
            let large = || {
                let (before, item, after) = match nested {
                    true => ("\"novel\":\"", "abc ", "\""),
                    false => ("\"records\":{\"a\":{\"values\":[", "0.5,", "0.5]}}"),
                };
                [before.into(), Text::repeat(item, count), after.into()]
            };
            for place in ["before", "behind", "behind-escaped"] {
                let [a_part, b_part, c_part] = large();
                let broken = if place.ends_with("escaped") { escaped(pin, &broken) } else { broken.clone() };
                let text = if place.starts_with("before") {
                    Text::concat([format!("{front},{broken},").into(), a_part, b_part, c_part, "}".into()])
                } else {
                    Text::concat([format!("{front},").into(), a_part, b_part, c_part, format!(",{broken}}}").into()])
                };
                cases.push(
                    Case::new(format!("{kind}/{pin}/large/{size}/{place}"), &[rule], readers(kind))
                        .title(format!(
                            "{} of {words} whose `{member}` is {} is rejected ({}).",
                            a(kind),
                            !pinned,
                            place.replace('-', ", ")
                        ))
                        .flags(&["unchecked-pins"])
                        .decode(kind, text)
                        .rejects("provenance")
                        .because(format!("The pin is present and not exactly `{pinned}`, however long the frame is.")),
                );
            }
        }
    }
    cases
}

/// The same with an escape in the name of a member.
fn escaped(name: &str, text: &str) -> String {
    text.replace(name, &name.replacen('_', "\\u005f", 1))
}

/// A flipped pin among other members that say something, on each road to the frame: none of them is a reason to let it
/// pass.
fn of_backends() -> Vec<Case> {
    let backends = ["mock", "", "ncp.reference", "NEST 3.8", "test", "dummy", "hardware"];
    let provenance = |pin: &str, pinned: bool| object! { pin => !pinned };
    let mut beside: Vec<(String, String, Json, &str)> = Vec::new();
    for backend in backends {
        let name = if backend.is_empty() { "empty".to_owned() } else { backend.to_lowercase().replace(' ', "-") };
        beside.push((format!("backend-{name}"), format!("backend `{backend}`"), object! { "backend" => backend }, ""));
    }
    for (name, says, members) in [
        ("reference-network", "network `ncp.reference.lif`", object! { "network_ref" => "ncp.reference.lif" }),
        ("seed", "seed 0", object! { "seed" => Json::literal("0") }),
        ("not-advisory", "`advisory_only` at false", object! { "advisory_only" => false }),
        ("note", "note `validated`", object! { "note" => "validated" }),
    ] {
        beside.push((name.to_owned(), says.to_owned(), members, ""));
    }
    for (name, says, member) in [
        ("session-of-backend-mock", "session of the backend `mock`", object! { "backend" => "mock" }),
        ("session-of-backend-nest", "session of the backend `nest`", object! { "backend" => "nest" }),
    ] {
        beside.push((name.to_owned(), says.to_owned(), member, "session"));
    }
    let with = |frame: Json, members: &Json| {
        members.members().iter().fold(frame, |frame, (name, value)| frame.with(name, value.clone()))
    };
    let mut cases = Vec::new();
    for (kind, nested, pin, pinned, rule) in PINS.into_iter().filter(|(_, nested, ..)| *nested) {
        for (name, says, members, of) in &beside {
            let frame = match *of {
                "session" => with(minimal(kind).with("provenance", provenance(pin, pinned)), members),
                _ => minimal(kind).with("provenance", with(provenance(pin, pinned), members)),
            };
            cases.extend(on_each_road(kind, nested, pin, rule, name, says, &frame, "open_session"));
        }
    }
    for (kind, nested, pin, pinned, rule) in PINS.into_iter().filter(|(_, nested, ..)| !*nested) {
        let record = object! { "v" => object! { "times" => Json::Array(vec![Json::literal("0.1")]) } };
        for (name, says, members) in [
            ("records", "with a record", object! { "records" => record }),
            (
                "later",
                "of a later seq",
                object! { "seq" => Json::literal("7"), "sim_time_ms" => Json::literal("70.0") },
            ),
            ("before-any-step", "of the time 0", object! { "sim_time_ms" => Json::literal("0.0") }),
        ] {
            let frame = with(minimal(kind).with(pin, (!pinned).into()), &members);
            for request in ["step_request", "run_request"] {
                cases.extend(on_each_road(kind, nested, pin, rule, name, says, &frame, request));
            }
        }
    }
    cases
}

/// The frame as a decoder is given it, and as a client is given it as the reply to its request.
#[expect(clippy::too_many_arguments, reason = "they are what a case is made of")]
fn on_each_road(
    kind: &'static str,
    nested: bool,
    pin: &str,
    rule: &'static str,
    name: &str,
    says: &str,
    frame: &Json,
    request: &str,
) -> Vec<Case> {
    let member = if nested { format!("provenance.{pin}") } else { pin.to_owned() };
    let says = if nested { format!("beside the {says}") } else { says.to_owned() };
    let why = "The pin is present and has another than its pinned value, whatever stands beside it.";
    let decoded = Case::new(format!("{kind}/{pin}/beside/{name}"), &[rule], readers(kind))
        .title(format!("{} whose `{member}` is flipped, {says}, is rejected.", a(kind)))
        .flags(&["unchecked-pins"])
        .decode(kind, frame.text())
        .rejects("provenance")
        .because(why);
    let args = object! { "request" => minimal(request).text(), "reply" => frame.text() };
    let replied = Case::new(format!("{kind}/{pin}/as-the-reply/{request}/{name}"), &[rule], &[Commander])
        .title(format!(
            "A client rejects {} whose `{member}` is flipped, {says}, as the reply to its `{request}`.",
            an(kind)
        ))
        .flags(&["unchecked-pins"])
        .call("reply.check", args)
        .rejects("reply")
        .because(why);
    // A decoder is given no request.
    if request == "run_request" { vec![replied] } else { vec![decoded, replied] }
}

/// The kind with its article, within a sentence.
fn an(kind: &str) -> String {
    a(kind).replacen('A', "a", 1)
}

/// Frames in which something else is like a broken pin, or a pin is broken beside other content.
fn beside() -> Vec<Case> {
    let session = || explicit("session_opened");
    let table = [
        (
            "provenance-without-pins",
            session().with(
                "provenance",
                explicit_message("SimProvenance").without("calibrated_posterior").without("is_simulation_output"),
            ),
            "NCP-PROV-005",
            "whose `provenance` has neither pin is read with both pins at their values",
        ),
        (
            "pin-beside-provenance",
            session().with("calibrated_posterior", true.into()),
            "NCP-WIRE-026",
            "that has the name of a pin outside of its `provenance` is read as one without that member",
        ),
    ];
    let mut cases: Vec<Case> = table
        .into_iter()
        .map(|(what, frame, rule, says)| {
            Case::new(format!("session_opened/{what}"), &[rule], readers("session_opened"))
                .title(format!("A `session_opened` {says}."))
                .flags(&["over-strict"])
                .decode("session_opened", frame.text())
                .means(meaning("session_opened", &frame).text())
                .because("The pins stand on an `observation_frame` and within a `provenance`, nowhere else.")
        })
        .collect();
    let record =
        minimal("observation_frame").with("records", object! { "v" => object! { "calibrated_posterior" => true } });
    let explicit_record = explicit("observation_frame")
        .with("records", object! { "v" => explicit_message("Observation").with("calibrated_posterior", true.into()) });
    cases.push(
        Case::new("observation_frame/pin-within-record", &["NCP-WIRE-026"], readers("observation_frame"))
            .title(
                "An `observation_frame` that has the name of a pin within a record is read as one without that member.",
            )
            .flags(&["over-strict"])
            .decode("observation_frame", explicit_record.text())
            .means(meaning("observation_frame", &record).text())
            .because("A record has no pins; there the name is an unknown one."),
    );
    let failed = minimal("session_opened")
        .with("ok", false.into())
        .with("provenance", object! { "calibrated_posterior" => true });
    cases.push(
        Case::new("session_opened/pin-of-failure", &["NCP-PROV-003"], readers("session_opened"))
            .title("A `session_opened` that reports a failure is rejected all the same when a pin is broken.")
            .flags(&["unchecked-pins"])
            .decode("session_opened", failed.text())
            .rejects("provenance")
            .because("The rule makes no difference between success and failure."),
    );
    cases
}
