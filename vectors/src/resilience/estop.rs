//! An ESTOP is never lost.

use super::model::{Event, active};
use super::{buffer_case as case, go};
use crate::case::{Case, File};
use crate::json::{Json, object};

pub(super) fn file() -> File {
    let mut cases = Vec::new();
    for (name, words, text) in stops() {
        cases.extend(trace(name, words, &text, true));
    }
    for (name, words, text) in likenesses() {
        cases.extend(trace(name, words, &text, false));
    }
    cases.extend(sequences());
    let about = "ESTOP at the plant: frames that latch however malformed they are, frames that only look alike, and what a latch outlives.";
    File::new("resilience", "estop", about, cases)
}

/// The text between active commands: after it nothing moves, or everything goes on.
fn trace(name: &str, words: &str, text: &Json, stops: bool) -> Vec<Case> {
    let frame = |now| Event::Text { text: text.clone(), now, stops };
    let moving = vec![go(50, 1.0), Event::Ask(1.0), frame(1.0625), go(51, 1.125), Event::Ask(1.125)];
    let first = vec![frame(1.0), go(51, 1.0), Event::Ask(1.0)];
    let rule: &[&'static str] = if !stops { &["NCP-RES-022", "NCP-RES-026"] } else { &["NCP-RES-022", "NCP-RES-021"] };
    let flag: &[&'static str] = if stops { &["lost-estop"] } else { &["latch-by-likeness"] };
    let why = if stops {
        "Any JSON object of kind `command_frame` with a member `mode` of the value `estop` latches, whatever else in it is malformed, stale or out of order."
    } else {
        "It is no command frame in mode `estop`, so that nothing latches and the next active command moves the plant."
    };
    let group = if stops { "latches" } else { "does-not-latch" };
    let verb = if stops { "latches ESTOP" } else { "latches nothing" };
    vec![
        case(format!("{group}/{name}/moving"), rule, &moving)
            .title(format!("{words} {verb} at a plant that moves."))
            .flags(flag)
            .because(why),
        case(format!("{group}/{name}/first"), rule, &first)
            .title(format!("{words} {verb} at a plant that has seen nothing."))
            .flags(flag)
            .because(why),
    ]
}

/// An ESTOP frame in good order.
fn estop() -> Json {
    active(50).mode("estop").json()
}

fn stops() -> Vec<(&'static str, &'static str, Json)> {
    let text = |json: Json| Json::string(json.text());
    let with = |name: &str, value: Json| text(estop().with(name, value));
    let minimal = r#"{"kind":"command_frame","mode":"estop"}"#;
    let deep = |levels: usize| {
        format!(r#"{{"kind":"command_frame","deep":{}{},"mode":"estop"}}"#, "[".repeat(levels), "]".repeat(levels))
    };
    vec![
        ("newer", "An ESTOP of a newer seq", with("seq", Json::literal("90"))),
        ("equal-seq", "An ESTOP of the last seq", text(estop())),
        ("older", "A stale ESTOP", with("seq", Json::literal("3"))),
        ("unstamped", "An ESTOP without a stamp", with("seq", Json::literal("0"))),
        ("negative-seq", "An ESTOP of a negative seq", with("seq", Json::literal("-9"))),
        ("no-seq", "An ESTOP without a seq", text(estop().without("seq"))),
        ("minimal", "An ESTOP of two members", Json::string(minimal)),
        ("mode-first", "An ESTOP whose mode comes first", Json::string(r#"{"mode":"estop","kind":"command_frame"}"#)),
        ("seq-text", "An ESTOP whose seq is a text", with("seq", "1".into())),
        ("seq-fraction", "An ESTOP whose seq is a fraction", with("seq", Json::literal("1.5"))),
        ("seq-spelled-as-double", "An ESTOP whose seq is spelled 1.0", with("seq", Json::literal("1.0"))),
        ("seq-huge", "An ESTOP of a seq beyond 2^53", with("seq", Json::literal("9007199254740993"))),
        ("seq-enormous", "An ESTOP of a seq of forty digits", with("seq", Json::literal("9".repeat(40)))),
        ("seq-null", "An ESTOP whose seq is null", with("seq", Json::Null)),
        ("seq-object", "An ESTOP whose seq is an object", with("seq", Json::object())),
        ("ttl-zero", "An ESTOP without time", with("ttl_ms", Json::literal("0"))),
        ("ttl-negative", "An ESTOP with a negative ttl", with("ttl_ms", Json::literal("-1"))),
        ("ttl-text", "An ESTOP whose ttl is a text", with("ttl_ms", "soon".into())),
        ("ttl-null", "An ESTOP whose ttl is null", with("ttl_ms", Json::Null)),
        ("ttl-overflow", "An ESTOP whose ttl overflows a double", with("ttl_ms", Json::literal("1e999"))),
        ("t-text", "An ESTOP whose time is a text", with("t", "now".into())),
        ("t-overflow", "An ESTOP whose time overflows a double", with("t", Json::literal("-1e999"))),
        ("frame-id-number", "An ESTOP whose frame_id is a number", with("frame_id", Json::literal("1"))),
        ("channels-null", "An ESTOP whose channels are null", with("channels", Json::Null)),
        (
            "channels-array",
            "An ESTOP whose channels are an array",
            with("channels", Json::Array(vec![Json::literal("1")])),
        ),
        ("channels-text", "An ESTOP whose channels are a text", with("channels", "none".into())),
        (
            "channel-number",
            "An ESTOP with a channel that is a number",
            with("channels", object! { "a" => Json::literal("1") }),
        ),
        (
            "data-text",
            "An ESTOP with a channel of texts",
            with("channels", object! { "a" => object! { "data" => Json::Array(vec!["1".into()]) } }),
        ),
        (
            "data-overflow",
            "An ESTOP with a component that overflows",
            with("channels", object! { "a" => object! { "data" => Json::Array(vec![Json::literal("1e999")]) } }),
        ),
        ("horizon-object", "An ESTOP whose horizon is an object", with("horizon", Json::object())),
        ("horizon-null", "An ESTOP whose horizon is null", with("horizon", Json::Null)),
        ("dt-text", "An ESTOP whose dt is a text", with("horizon_dt_ms", "1".into())),
        ("version-other", "An ESTOP of another version", with("ncp_version", "9.9".into())),
        ("version-junk", "An ESTOP of a version that is none", with("ncp_version", "junk".into())),
        ("version-number", "An ESTOP whose version is a number", with("ncp_version", Json::literal("0.5"))),
        ("version-null", "An ESTOP whose version is null", with("ncp_version", Json::Null)),
        ("no-version", "An ESTOP without a version", text(estop().without("ncp_version"))),
        (
            "mode-after-active",
            "An ESTOP whose mode was `active` before",
            text(active(60).json().and("mode", "estop".into())),
        ),
        ("mode-before-active", "An ESTOP whose mode is `active` after", text(estop().and("mode", "active".into()))),
        ("mode-before-hold", "An ESTOP whose mode is `hold` after", text(estop().and("mode", "hold".into()))),
        (
            "mode-after-null",
            "An ESTOP whose mode was null before",
            text(active(60).json().with("mode", Json::Null).and("mode", "estop".into())),
        ),
        (
            "mode-after-number",
            "An ESTOP whose mode was a number before",
            text(active(60).json().with("mode", Json::literal("3")).and("mode", "estop".into())),
        ),
        ("mode-before-object", "An ESTOP whose mode is an object after", text(estop().and("mode", Json::object()))),
        (
            "mode-thrice",
            "An ESTOP between two other modes",
            text(active(60).json().and("mode", "estop".into()).and("mode", "active".into())),
        ),
        ("mode-twice-estop", "An ESTOP that says so twice", text(estop().and("mode", "estop".into()))),
        ("repeated-seq", "An ESTOP with two seqs", text(estop().and("seq", Json::literal("2")))),
        (
            "repeated-unknown",
            "An ESTOP with an unknown member twice",
            text(estop().and("x", Json::Null).and("x", Json::Null)),
        ),
        (
            "repeated-within",
            "An ESTOP with a repeated channel",
            text(estop().with("channels", object! { "a" => Json::object() }.and("a", Json::object()))),
        ),
        ("unknown-member", "An ESTOP with an unknown member", text(estop().and("why", "obstacle".into()))),
        (
            "unknown-object",
            "An ESTOP with an unknown object that has a mode",
            text(estop().and("x", object! { "mode" => "active", "kind" => "sensor_frame" })),
        ),
        (
            "unknown-overflow",
            "An ESTOP with an unknown number that overflows",
            text(estop().and("x", Json::literal("1e999"))),
        ),
        (
            "white-space",
            "An ESTOP with white space",
            Json::string(" \t\r\n{ \"kind\" :\t\"command_frame\" ,\n\"mode\"\r:  \"estop\" }\n "),
        ),
        (
            "white-space-malformed",
            "A malformed ESTOP with white space",
            Json::string(" \t\r\n{ \"kind\" :\t\"command_frame\" ,\n\"mode\"\r:  \"estop\" , \"seq\" : \"x\" }\n "),
        ),
        (
            "spaced-malformed",
            "A malformed ESTOP with a space behind every colon and comma",
            Json::string(r#"{"seq": "x", "kind": "command_frame", "mode": "estop"}"#),
        ),
        (
            "indented-malformed",
            "A malformed ESTOP with a member a line",
            Json::string("{\r\n\t\"seq\": [1, 2],\r\n\t\"kind\": \"command_frame\",\r\n\t\"mode\": \"estop\"\r\n}\r\n"),
        ),
        (
            "escaped-name",
            "An ESTOP whose member name is escaped",
            Json::string(r#"{"kind":"command_frame","m\u006fde":"estop"}"#),
        ),
        (
            "escaped-value",
            "An ESTOP whose value is escaped",
            Json::string(r#"{"kind":"command_frame","mode":"\u0065\u0073\u0074\u006f\u0070"}"#),
        ),
        (
            "escaped-kind",
            "An ESTOP whose kind is escaped",
            Json::string(r#"{"\u006bind":"command\u005fframe","mode":"estop"}"#),
        ),
        (
            "escaped-name-malformed",
            "A malformed ESTOP whose member name is escaped",
            Json::string(r#"{"kind":"command_frame","m\u006fde":"estop","seq":"x"}"#),
        ),
        (
            "escaped-value-malformed",
            "A malformed ESTOP whose value is escaped",
            Json::string(r#"{"kind":"command_frame","mode":"\u0065\u0073\u0074\u006f\u0070","seq":"x"}"#),
        ),
        (
            "escaped-kind-malformed",
            "A malformed ESTOP whose kind is escaped",
            Json::string(r#"{"\u006bind":"command\u005fframe","mode":"estop","seq":"x"}"#),
        ),
        (
            "text-with-quotes",
            "An ESTOP behind a text with quotes and braces",
            Json::string(r#"{"x":"\"}{\\","kind":"command_frame","mode":"estop"}"#),
        ),
        (
            "text-with-a-mode",
            "An ESTOP behind a text that has a mode",
            Json::string(r#"{"x":"\"mode\":\"active\"","kind":"command_frame","mode":"estop"}"#),
        ),
        (
            "text-with-quotes-malformed",
            "A malformed ESTOP behind a text with quotes and braces",
            Json::string(r#"{"x":"\"}{\\","seq":"x","kind":"command_frame","mode":"estop"}"#),
        ),
        (
            "text-with-quotes-within-malformed",
            "A malformed ESTOP behind a list with such a text",
            Json::string(r#"{"x":["\"}{],\\",{"y":"]\""}],"seq":"x","kind":"command_frame","mode":"estop"}"#),
        ),
        ("deep-unknown", "An ESTOP with an unknown member of 40 levels", Json::string(deep(40))),
        ("too-deep-unknown", "An ESTOP with an unknown member of 100 levels", Json::string(deep(100))),
        ("deeper-unknown", "An ESTOP with an unknown member of 3,000 levels", Json::string(deep(3000))),
        (
            "many-members",
            "An ESTOP behind 300 unknown members",
            Json::string(format!(
                "{{{}\"kind\":\"command_frame\",\"mode\":\"estop\"}}",
                (0..300).map(|at| format!("\"x{at}\":{at},")).collect::<String>()
            )),
        ),
        (
            "nested-active",
            "An ESTOP with a channel named `mode`",
            with("channels", object! { "mode" => object! { "data" => Json::Array(vec![Json::literal("1")]) } }),
        ),
        ("horizon", "An ESTOP with a horizon", text(active(60).mode("estop").then(Some(100.0), &[1.0, 2.0]).json())),
        (
            "everything-wrong",
            "An ESTOP in which every other field is wrong",
            Json::string(
                r#"{"ncp_version":1,"kind":"command_frame","seq":"x","t":null,"frame_id":[],"mode":"estop","ttl_ms":{},"channels":0,"horizon":"","horizon_dt_ms":false}"#,
            ),
        ),
    ]
}

fn likenesses() -> Vec<(&'static str, &'static str, Json)> {
    let text = |json: Json| Json::string(json.text());
    let other = |kind: &str| {
        Json::string(
            object! { "ncp_version" => "0.5", "kind" => kind, "seq" => Json::literal("60"), "mode" => "estop" }.text(),
        )
    };
    vec![
        ("sensor-frame", "A sensor frame with a mode", other("sensor_frame")),
        ("control-status", "A control status of mode ESTOP", other("control_status")),
        ("link-status", "A link status with a mode", other("link_status")),
        (
            "channels-with-a-mode",
            "An active command with a channel named `mode`",
            text(active(50).json().with(
                "channels",
                object! { "mode" => object! { "data" => Json::Array(vec![Json::literal("1")]), "unit" => "estop" } },
            )),
        ),
        (
            "nested-mode",
            "A stale command with an unknown object in mode `estop`",
            text(active(3).json().and("x", object! { "mode" => "estop" })),
        ),
        ("nested-frame", "A stale command with an ESTOP frame within", text(active(3).json().and("x", estop()))),
        (
            "nested-in-array",
            "A stale command with an ESTOP frame within an array",
            text(active(3).json().and("x", Json::Array(vec![estop()]))),
        ),
        ("unknown-kind", "An object of an unknown kind in mode `estop`", other("command")),
        ("observation-frame", "An observation frame with a mode", other("observation_frame")),
        (
            "mode-in-capitals",
            "A command in mode `ESTOP` with a frame_id of `estop`",
            text(active(50).mode("ESTOP").json().with("frame_id", "estop".into())),
        ),
        (
            "mode-half-in-capitals",
            "A command in mode `Estop` with a channel named `estop`",
            text(
                active(50)
                    .mode("Estop")
                    .json()
                    .with("channels", object! { "estop" => object! { "data" => Json::Array(Vec::new()) } }),
            ),
        ),
        ("array", "An array that holds `estop`", Json::string(r#"["command_frame","mode","estop"]"#)),
        ("text", "A text that says ESTOP", Json::string(r#""estop""#)),
        ("no-json", "Bytes that say ESTOP", Json::string("estop")),
        (
            "channel-named-estop",
            "An active command with a channel named `estop`",
            text(active(50).json().with(
                "channels",
                object! { "estop" => object! { "data" => Json::Array(vec![Json::literal("1")]), "unit" => "estop" } },
            )),
        ),
        (
            "frame-id",
            "A stale command with a frame_id of `estop`",
            text(active(3).json().with("frame_id", "estop".into())),
        ),
        (
            "text-within",
            "A stale command with a text that looks like an ESTOP",
            text(active(3).json().and("x", r#""mode":"estop""#.into())),
        ),
    ]
}

fn sequences() -> Vec<Case> {
    let stop = |seq: i64, now: f64| Event::Command(active(seq).mode("estop"), now);
    let hold = |seq: i64, now: f64| Event::Command(active(seq).mode("hold"), now);
    let ask = Event::Ask;
    let table: Vec<(&str, &[&'static str], &str, Vec<Event>)> = vec![
        (
            "newer-commands",
            &["NCP-RES-025", "NCP-RES-021"],
            "No newer command ends a latched ESTOP.",
            vec![
                go(1, 1.0),
                stop(2, 1.0),
                ask(1.0),
                go(3, 1.0625),
                ask(1.0625),
                go(4, 1.125),
                ask(1.125),
                go(500, 1.1875),
                ask(1.1875),
            ],
        ),
        (
            "hold-after",
            &["NCP-RES-025", "NCP-RES-021"],
            "A HOLD does not end a latched ESTOP.",
            vec![go(1, 1.0), stop(2, 1.0), hold(3, 1.0625), go(4, 1.125), ask(1.125)],
        ),
        (
            "hold-before",
            &["NCP-RES-021"],
            "An ESTOP latches at a plant that holds.",
            vec![go(1, 1.0), hold(2, 1.0), stop(3, 1.0625), go(4, 1.125), ask(1.125)],
        ),
        (
            "time-passes",
            &["NCP-RES-025", "NCP-RES-021"],
            "Time does not end a latched ESTOP.",
            vec![go(1, 1.0), stop(2, 1.0), ask(100.0), go(3, 1e6), ask(1e6)],
        ),
        (
            "clock-back",
            &["NCP-RES-021"],
            "A clock that steps back does not end a latched ESTOP.",
            vec![go(1, 100.0), stop(2, 100.0), ask(1.0), go(3, 1.0), ask(1.0)],
        ),
        (
            "strange-clock",
            &["NCP-RES-021"],
            "An ESTOP latches whatever the clock reads.",
            vec![stop(1, f64::NAN), go(2, 1.0), ask(1.0)],
        ),
        (
            "infinite-clock",
            &["NCP-RES-021"],
            "An ESTOP latches though the clock reads infinity.",
            vec![stop(1, f64::INFINITY), go(2, 1.0), ask(1.0)],
        ),
        (
            "stale-estop",
            &["NCP-RES-021"],
            "A stale ESTOP latches.",
            vec![go(100, 1.0), stop(1, 1.0), ask(1.0), go(101, 1.0), ask(1.0)],
        ),
        (
            "duplicate-estop",
            &["NCP-RES-021"],
            "A duplicate of an ESTOP latches again after a reset.",
            vec![stop(1, 1.0), Event::Reset, stop(1, 1.0), go(2, 1.0), ask(1.0)],
        ),
        (
            "reset-once",
            &["NCP-RES-030"],
            "One reset clears many ESTOPs.",
            vec![stop(1, 1.0), stop(2, 1.0), stop(3, 1.0), Event::Reset, go(4, 1.0), ask(1.0)],
        ),
        (
            "estop-reset-estop",
            &["NCP-RES-021", "NCP-RES-030"],
            "ESTOP, reset, command, ESTOP: each does what it says.",
            vec![
                stop(1, 1.0),
                Event::Reset,
                go(1, 1.0),
                ask(1.0),
                stop(2, 1.0625),
                ask(1.0625),
                Event::Reset,
                ask(1.0625),
                go(1, 1.125),
                ask(1.125),
            ],
        ),
        (
            "expired-estop",
            &["NCP-RES-021"],
            "An ESTOP does not expire with its ttl.",
            vec![Event::Command(active(1).mode("estop").ttl(1.0), 1.0), ask(1.0), go(2, 5.0), ask(5.0)],
        ),
        (
            "during-horizon",
            &["NCP-RES-021", "NCP-RES-025"],
            "An ESTOP ends a replay.",
            vec![
                Event::Command(active(1).ttl(1000.0).then(Some(125.0), &[11.0, 12.0, 13.0]), 1.0),
                ask(1.125),
                stop(2, 1.125),
                ask(1.125),
                ask(1.25),
                ask(1.375),
            ],
        ),
    ];
    table
        .into_iter()
        .map(|(name, rules, title, events)| {
            case(format!("sequence/{name}"), rules, &events)
                .title(title)
                .flags(&["lost-estop"])
                .because("The buffer latches ESTOP whatever its seq, and only a reset leads back.")
        })
        .collect()
}
