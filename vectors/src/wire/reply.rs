//! What a client accepts as a reply, by chapter 4.

use crate::case::Role::Commander;
use crate::case::{Case, File};
use crate::json::{Json, object};
use crate::model::{explicit, full, minimal};
use crate::patch::patched;
use crate::scenario::{Row, ScenarioError, Scenarios, beside, source};
use crate::template::Text;
use crate::trace::num;
use crate::version::{MALFORMED, malformed};

pub(super) fn file() -> Result<File, ScenarioError> {
    let mut text = Scenarios::read(source!("wire/reply"))?;
    let mut cases = text.cases("reply", |row| reply(row, minimal(&row.fill("{pair.name}")?)))?;
    for group in ["wording-opened", "wording-closed", "wording-error"] {
        cases.extend(text.cases(group, |row| wording(row, group == "wording-error"))?);
    }
    text.end()?;
    cases.extend(sizes());
    cases.extend(kinds_of_large());
    cases.extend(broken_of_large());
    cases.extend(alike());
    cases.extend(malformed_versions()?);
    cases.extend(long_sessions());
    cases.extend(of_other_contents());
    Ok(File::new("wire", "reply", "What a client accepts as the reply to its request.", cases))
}

/// Replies that say something else than a request would have: which simulation it is, and what it measured, is no
/// question of whether a reply belongs to a request.
fn of_other_contents() -> Vec<Case> {
    let own = || ("open_session", full("open_session"));
    let opened = |changes: &str| {
        full("session_opened").with("ok", true.into()).with("error", Json::Null).with("provenance", Json::read(changes))
    };
    let seeded = r#"{"seed":8,"backend":"nest-9.9","network_ref":"builtin:other","note":null}"#;
    let asks = |kind: &'static str, time: &str| (kind, full(kind).with(time, Json::literal("10.0")));
    let step = || asks("step_request", "advance_ms");
    let run = || asks("run_request", "duration_ms");
    let observed = |time: f64, records: &str| {
        full("observation_frame").with("sim_time_ms", num(time)).with("records", Json::read(records))
    };
    let table = [
        ("seed", own(), opened(seeded), "names another seed, backend and network"),
        ("populations", own(), opened("null").with("resolved", Json::read(r#"{"b":9,"c":0}"#)), "resolves others"),
        ("sizes", own(), opened("null").with("resolved", Json::read(r#"{"a":9}"#)), "resolves it in another size"),
        ("no-size", own(), opened("null").with("resolved", Json::read(r#"{"a":0}"#)), "resolves it as empty"),
        ("more-time", run(), observed(15.0, "{}"), "is of more time than the run"),
        ("less-time", step(), observed(5.0, "{}"), "is of less time than the step"),
        ("no-time", run(), observed(0.0, "{}"), "is of no time"),
        ("earlier", step(), observed(-2.5, "{}"), "is of a time below 0"),
        ("other-ports", run(), observed(10.0, r#"{"y":{"times":[3.0,1.0]},"z":{"values":[1.0]}}"#), "has other ports"),
    ];
    let case = |(name, (kind, request), reply, says): (&str, (&str, Json), Json, &str)| {
        Case::new(format!("{kind}/accepted/contents/{name}"), &["NCP-SESS-007"], &[Commander])
            .title(format!("A client accepts a reply to its `{kind}` that {says}."))
            .flags(&["over-strict"])
            .call("reply.check", object! { "request" => request.text(), "reply" => reply.text() })
            .accepts()
            .because("Kind, session and version fit, and nothing says that it failed.")
    };
    table.map(case).into()
}

/// Replies as long as their kind may be, and longer: a reply is a frame like every other.
fn sizes() -> Vec<Case> {
    const MIB: usize = 1 << 20;
    let table = [
        ("open_session", "session_opened", MIB, "x", true),
        ("open_session", "session_opened", MIB + 1, "x", false),
        ("close_session", "session_closed", MIB, "x", true),
        ("close_session", "session_closed", MIB + 1, "x", false),
        // Of fewer characters than 1 MiB.
        ("open_session", "session_opened", MIB, "\u{20ac}", true),
        ("open_session", "session_opened", MIB + 3, "\u{20ac}", false),
        ("close_session", "session_closed", 2 * MIB, "\u{20ac}", false),
        ("step_request", "observation_frame", MIB + 1, "x", true),
        ("run_request", "observation_frame", 2 * MIB, "x", true),
        ("step_request", "observation_frame", 5 * MIB, "x", true),
        ("step_request", "observation_frame", 64 * MIB, "x", true),
        ("step_request", "observation_frame", 64 * MIB + 1, "x", false),
    ];
    let case = |(request, kind, size, letter, is_read): (&str, &str, usize, &str, bool)| {
        let frame = explicit(kind).text();
        let open = format!("{},\"novel\":\"", frame.strip_suffix('}').unwrap_or(&frame));
        let pad = size - open.len() - 2;
        let rest = "x".repeat(pad % letter.len());
        let reply = Text::concat([open.into(), Text::repeat(letter, pad / letter.len()), (rest + "\"}").into()]);
        let (path, words) = match letter {
            "x" => ("", ""),
            _ => ("-of-three-each", ", most of them three to a character,"),
        };
        let rules: &[&'static str] = match (is_read, kind) {
            (true, "observation_frame") => &["NCP-SESS-007", "NCP-WIRE-063"],
            (true, _) => &["NCP-SESS-007", "NCP-WIRE-061"],
            (false, "observation_frame") => &["NCP-WIRE-062"],
            (false, _) => &["NCP-WIRE-060"],
        };
        let case = Case::new(format!("{request}/size/{size}-bytes{path}"), rules, &[Commander])
            .call("reply.check", object! { "request" => minimal(request).text(), "reply" => reply.json() })
            .flags(&[if is_read { "low-limits" } else { "missing-limits" }])
            .flags(if size > 32 * MIB { &["slow"] } else { &[] })
            .because("An `observation_frame` may have 64 MiB, and every other reply 1 MiB.");
        if is_read {
            case.accepts()
                .title(format!("A client accepts a `{kind}` of {size} bytes{words} as the reply to its `{request}`."))
        } else {
            case.rejects("limit").title(format!("A client reports a `{kind}` of {size} bytes{words} as an error."))
        }
    };
    table.into_iter().map(case).collect()
}

/// Replies of more than 1 MiB whose kind stands behind all of it, or is written with escapes, or stands elsewhere too:
/// what a frame is says its member `kind`, wherever that stands and however it is spelled.
fn kinds_of_large() -> Vec<Case> {
    const SIZE: usize = 3 << 19;
    let frame = minimal("observation_frame").text();
    let rest = frame.strip_prefix('{').unwrap_or(&frame);
    let last = rest.replace(r#""kind":"observation_frame","#, "").replace('}', r#","kind":"observation_frame"}"#);
    let spelled = |from: &str, to: &str| rest.replace(from, to);
    let of_escapes = || spelled("\"observation_frame\"", "\"observation\\u005fframe\"");
    // Its name in a string in front, where who only looks for it finds it.
    let beside = r#""x":"\"kind\":\"observation_frame\"","#;
    let table = [
        ("kind-last", beside, last, "whose kind is its last member", true),
        (
            "kind-escaped",
            beside,
            spelled("\"kind\"", "\"k\\u0069nd\""),
            "whose member `kind` is written with an escape",
            true,
        ),
        ("kind-of-escapes", beside, of_escapes(), "whose kind is written with an escape", true),
        ("kind-of-escapes-alone", "", of_escapes(), "whose kind stands in it only with an escape", true),
        (
            "kind-in-a-string",
            beside,
            spelled("\"observation_frame\"", "\"session_opened\""),
            "that has only the name of the kind in a string",
            false,
        ),
    ];
    let case = |(name, beside, rest, words, is_read): (&str, &str, String, &str, bool)| {
        let open = format!("{{{beside}\"pad\":\"");
        let reply = Text::concat([open.into(), Text::repeat("x", SIZE), format!("\",{rest}").into()]);
        let rules: &[&'static str] = if is_read { &["NCP-SESS-007", "NCP-WIRE-063"] } else { &["NCP-WIRE-060"] };
        let case = Case::new(format!("step_request/size/{name}"), rules, &[Commander])
            .call("reply.check", object! { "request" => minimal("step_request").text(), "reply" => reply.json() })
            .flags(&[if is_read { "low-limits" } else { "missing-limits" }])
            .because("An `observation_frame` may have 64 MiB, and every other reply 1 MiB.");
        if is_read {
            case.accepts().title(format!("A client accepts an `observation_frame` of 1.5 MiB {words}."))
        } else {
            case.rejects("limit").title(format!("A client reports a `session_opened` of 1.5 MiB {words} as an error."))
        }
    };
    table.map(case).into()
}

/// Replies of more than 1 MiB that are broken somewhere: some receivers look less closely at what is large.
fn broken_of_large() -> Vec<Case> {
    const SIZE: usize = 3 << 19;
    let frame = explicit("observation_frame");
    let text = |frame: Json| frame.text();
    let records = |observation: &str| text(frame.clone().with("records", Json::read(observation)));
    let pin = |name: &str, value: bool| text(frame.clone().with(name, value.into()));
    let table: [(&str, &'static str, String, &str); 9] = [
        ("posterior", "NCP-PROV-001", pin("calibrated_posterior", true), "that claims a calibrated posterior"),
        ("output", "NCP-PROV-002", pin("is_simulation_output", false), "that is no output of a simulation"),
        ("times", "NCP-WIRE-020", records(r#"{"v":{"times":[0.5,"1"]}}"#), "whose record has a time that is a string"),
        ("senders", "NCP-WIRE-010", records(r#"{"v":{"senders":[1,2.0]}}"#), "whose record has a sender of 2.0"),
        ("values", "NCP-WIRE-021", records(r#"{"v":{"values":null}}"#), "whose record has values of null"),
        ("record", "NCP-WIRE-020", records(r#"{"v":{},"w":[]}"#), "of whose records one is an array"),
        (
            "records",
            "NCP-WIRE-020",
            text(frame.clone().with("records", Json::Array(Vec::new()))),
            "whose records are an array",
        ),
        ("seq", "NCP-WIRE-020", text(frame.clone().with("seq", "1".into())), "whose seq is a string"),
        ("repeated", "NCP-WIRE-007", text(frame.clone().and("t", Json::literal("1.5"))), "that has its `t` twice"),
    ];
    let case = |(name, rule, broken, words): (&str, &'static str, String, &str)| {
        let rest = broken.strip_prefix('{').unwrap_or(&broken);
        let reply = Text::concat([r#"{"pad":""#.into(), Text::repeat("x", SIZE), format!("\",{rest}").into()]);
        Case::new(format!("step_request/broken/large/{name}"), &["NCP-SESS-006", rule], &[Commander])
            .call("reply.check", object! { "request" => minimal("step_request").text(), "reply" => reply.json() })
            .flags(&["unchecked-replies"])
            .title(format!("A client rejects an `observation_frame` of 1.5 MiB {words}."))
            .because("No decoder accepts such a frame, however large it is.")
            .rejects("reply")
    };
    table.map(case).into()
}

/// Sessions of long ids, of which one differs at its end, or none.
fn long_sessions() -> Vec<Case> {
    let mut cases = Vec::new();
    for (request, kind) in [("step_request", "observation_frame")] {
        let of = |kind: &str, id: &str| minimal(kind).with("session_id", id.into()).text();
        for bytes in [129, 256] {
            let id = |last: &str| "a".repeat(bytes - 1) + last;
            let case = |path: &str, rule: &'static str, other: &str| {
                Case::new(format!("{request}/session/{path}-of-{bytes}-bytes"), &[rule], &[Commander]).call(
                    "reply.check",
                    object! { "request" => of(request, &id("b")), "reply" => of(kind, &id(other)) },
                )
            };
            cases.push(
                case("other", "NCP-SESS-002", "c")
                    .title(format!("A client rejects a `{kind}` whose session differs in its last byte of {bytes}."))
                    .flags(&["unchecked-replies"])
                    .because("The reply is another session's.")
                    .rejects("reply"),
            );
            cases.extend((bytes == 256).then(|| {
                case("own", "NCP-SESS-007", "b")
                    .title(format!("A client accepts a `{kind}` of its session of {bytes} bytes."))
                    .flags(&["over-strict"])
                    .because("The reply's session is the request's.")
                    .accepts()
            }));
        }
    }
    cases
}

/// Replies of another version that is letter for letter the request's.
fn alike() -> Vec<Case> {
    let pairs = [
        ("open_session", "session_opened"),
        ("step_request", "observation_frame"),
        ("run_request", "observation_frame"),
        ("close_session", "session_closed"),
    ];
    let case = |((request, kind), (name, version)): ((&str, &str), &(&str, String))| {
        let of = |kind: &str| minimal(kind).with("ncp_version", version.as_str().into()).text();
        Case::new(format!("{request}/version/{name}-as-asked"), &["NCP-SESS-003"], &[Commander])
            .call("reply.check", object! { "request" => of(request), "reply" => of(kind) })
            .flags(&["unchecked-reply-version"])
            .title(format!("A client rejects a `{kind}` of version \"{version}\" also where it asked in that version."))
            .because("A client rejects a reply whose version is not compatible with its own.")
            .rejects("version")
    };
    let versions = [("older", beside(-1)), ("newer", beside(1)), ("next-major", "1.0".to_owned())];
    pairs.into_iter().flat_map(|pair| versions.iter().map(move |version| case((pair, version)))).collect()
}

/// Replies whose version is none, by characters that are easily lost or taken for others.
fn malformed_versions() -> Result<Vec<Case>, ScenarioError> {
    let mut cases = Vec::new();
    for (request, kind) in [("step_request", "observation_frame"), ("close_session", "session_closed")] {
        cases.extend(malformed(&MALFORMED[..3])?.into_iter().map(|(name, version)| {
            let reply = minimal(kind).with("ncp_version", version.clone()).text();
            Case::new(format!("{request}/version/{name}"), &["NCP-SESS-003", "NCP-VER-001"], &[Commander])
                .rests_on(format!("version/guard/strict/{name}"))
                .title(format!("A client rejects a reply of version {} to its `{request}`.", version.text()))
                .flags(&["unchecked-reply-version"])
                .call("reply.check", object! { "request" => minimal(request).text(), "reply" => reply })
                .rejects("version")
                .because("The version guard holds what is no version compatible with none.")
        }));
    }
    Ok(cases)
}

/// A failure whose error says what the row says.
fn wording(row: &Row, is_error_frame: bool) -> Result<Case, ScenarioError> {
    let error = Json::read(row.cell("error")?);
    let reply = match is_error_frame {
        true => minimal("error").with("error", error),
        false => minimal(&row.fill("{pair}")?).with("ok", false.into()).with("error", error),
    };
    let request = minimal(&row.fill("{pair.name}")?).text();
    let args = object! { "request" => request, "reply" => reply.text() };
    Ok(row.case(&[Commander]).call("reply.check", args).rejects("reply"))
}

/// A case of a row: a reply to that request.
pub(crate) fn reply(row: &Row, request: Json) -> Result<Case, ScenarioError> {
    let cell = row.text("frame")?;
    let (frame, changes) = cell.split_once(" | ").unwrap_or((&cell, ""));
    let (ground, kind) = frame.split_once(' ').unwrap_or((frame, ""));
    let text = minimal(kind).text();
    let reply = match ground {
        "explicit" => patched(explicit(kind), changes, row.place)?.text(),
        "minimal" => patched(minimal(kind), changes, row.place)?.text(),
        "raw" => kind.to_owned(),
        "array" => format!("[{text}]"),
        "cut" => text.trim_end_matches('}').to_owned(),
        "twice" => text.repeat(2),
        ground => return Err(row.place.wants("frame of a reply", ground)),
    };
    let (request, expect) = match row.cell("expect")?.split_once('-') {
        Some((expect, session)) => (request.with("session_id", Json::string(session)), expect),
        None => (request, row.cell("expect")?),
    };
    let case = row.case(&[Commander]).call("reply.check", object! { "request" => request.text(), "reply" => reply });
    Ok(if expect == "accept" { case.accepts() } else { case.rejects(expect) })
}
