//! The two pins of chapter 6, on every frame that carries them.

use crate::case::{Case, File};
use crate::json::{Json, object};
use crate::model::{explicit, explicit_message, meaning, minimal};
use crate::roles::{a, readers};

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
    let about = "The pins `calibrated_posterior` and `is_simulation_output`: exactly their pinned values, or absent.";
    File::new("wire", "pins", about, cases)
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
