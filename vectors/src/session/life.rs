//! What a server answers from `open_session` to `close_session`.

use ncp_text::WIRE_VERSION;
use super::{
    Open, case, close, closed, error, not_closed, not_opened, observation, observed, opened, record, recorded, run,
    step, stimulus,
};
use crate::case::{Case, File};
use crate::json::{Json, object};
use crate::trace::{any, anything, int, name_of, nums, text_of};

pub(super) fn file() -> File {
    let mut cases = lives();
    cases.extend(refused());
    cases.extend(malformed());
    cases.extend(versions());
    cases.extend(times());
    cases.extend(failures());
    let about = "A server's sessions: opened, stepped, closed, kept apart, and every request answered once.";
    File::new("session", "life", about, cases)
}

fn open(id: &'static str) -> (String, Json) {
    (Open::lif(id).text(), opened(id))
}

fn steps(id: &str, time: f64) -> (String, Json) {
    (step(id, None, None), observed(id, time))
}

fn lives() -> Vec<Case> {
    let mut with_hash = Open::lif("a").json();
    with_hash = with_hash.with("contract_hash", "0123456789abcdef".into());
    // What is said of the numbers is pinned, if anything is said.
    let provenance = |absent: Option<Json>| {
        let pins = object! { "calibrated_posterior" => false, "is_simulation_output" => true };
        let provenance = any(absent.into_iter().chain([pins]).collect());
        text_of(object! { "kind" => "session_opened", "ok" => true, "provenance" => provenance })
    };
    #[expect(clippy::type_complexity, reason = "a table is read by its rows")]
    let table: Vec<(&str, &[&'static str], &str, Vec<(String, Json)>)> = vec![
        (
            "open",
            &["NCP-PROV-007", "NCP-PROV-008", "NCP-SESS-020"],
            "A session that is opened has both pins in its provenance, if it has one.",
            vec![(Open::lif("a").text(), provenance(Some(Json::Null)))],
        ),
        (
            "open/provenance",
            &["NCP-SESS-039"],
            "A session that is opened should have a provenance.",
            vec![(Open::lif("a").text(), provenance(None))],
        ),
        (
            "open-step",
            &["NCP-SESS-027"],
            "A step of an open session is answered with an observation.",
            vec![open("a"), (step("a", None, None), observation("a"))],
        ),
        (
            "open-run",
            &["NCP-SESS-027"],
            "A run of an open session is answered with an observation.",
            vec![open("a"), (run("a", 25.0), observation("a"))],
        ),
        (
            "step-again",
            &["NCP-SESS-027"],
            "Each step of an open session is answered with an observation.",
            vec![
                open("a"),
                (step("a", None, None), observation("a")),
                (run("a", 5.0), observation("a")),
                (step("a", Some(5.0), None), observation("a")),
            ],
        ),
        (
            "many-steps",
            &["NCP-SESS-033", "NCP-SESS-031"],
            "Simulation time adds up over steps.",
            vec![
                open("a"),
                steps("a", 10.0),
                (step("a", Some(5.0), None), observed("a", 15.0)),
                steps("a", 25.0),
                (step("a", Some(1.0), None), observed("a", 26.0)),
            ],
        ),
        (
            "many-runs",
            &["NCP-SESS-033", "NCP-SESS-031"],
            "Simulation time adds up over runs.",
            vec![
                open("a"),
                (run("a", 10.0), observed("a", 10.0)),
                (run("a", 10.0), observed("a", 20.0)),
                steps("a", 30.0),
            ],
        ),
        (
            "time-since-opened",
            &["NCP-SESS-033"],
            "Simulation time counts from the opening of the session, not from the request.",
            vec![
                open("a"),
                (step("a", Some(5.0), None), observed("a", 5.0)),
                (step("a", Some(5.0), None), observed("a", 10.0)),
            ],
        ),
        (
            "reopen",
            &["NCP-SESS-033", "NCP-SESS-028"],
            "A session that is opened again begins at 0.",
            vec![
                open("a"),
                (step("a", Some(20.0), None), observation("a")),
                (close("a"), anything()),
                open("a"),
                steps("a", 10.0),
            ],
        ),
        (
            "step-before-open",
            &["NCP-SESS-026"],
            "A step before the session is opened is an error.",
            vec![(step("a", None, None), error()), open("a"), steps("a", 10.0)],
        ),
        (
            "run-before-open",
            &["NCP-SESS-026"],
            "A run before the session is opened is an error.",
            vec![(run("a", 10.0), error()), open("a"), steps("a", 10.0)],
        ),
        (
            "close",
            &["NCP-SESS-028"],
            "A session that was only opened is closed.",
            vec![open("a"), (close("a"), closed("a"))],
        ),
        (
            "close-after-step",
            &["NCP-SESS-028"],
            "A session is closed after a step.",
            vec![open("a"), (step("a", None, None), observation("a")), (close("a"), closed("a"))],
        ),
        (
            "close-after-run",
            &["NCP-SESS-028"],
            "A session is closed after a run.",
            vec![open("a"), (run("a", 25.0), observation("a")), (close("a"), closed("a"))],
        ),
        (
            "step-after-close",
            &["NCP-SESS-028", "NCP-SESS-026"],
            "A step after the session is closed is an error.",
            vec![open("a"), (close("a"), anything()), (step("a", None, None), error())],
        ),
        (
            "run-after-close",
            &["NCP-SESS-028", "NCP-SESS-026"],
            "A run after the session is closed is an error.",
            vec![
                open("a"),
                (step("a", None, None), observation("a")),
                (close("a"), anything()),
                (run("a", 1.0), error()),
            ],
        ),
        (
            "open-after-close",
            &["NCP-SESS-028"],
            "A session that was closed can be opened again.",
            vec![open("a"), (close("a"), anything()), open("a")],
        ),
        (
            "close-unknown",
            &["NCP-SESS-029"],
            "To close a session that is not open is refused.",
            vec![(close("a"), not_closed("a"))],
        ),
        (
            "close-twice",
            &["NCP-SESS-029", "NCP-SESS-028"],
            "To close a session a second time is refused.",
            vec![open("a"), (close("a"), anything()), (close("a"), not_closed("a"))],
        ),
        (
            "two-apart",
            &["NCP-SESS-035"],
            "Two sessions have each their own time.",
            vec![
                open("a"),
                open("b"),
                (step("a", None, None), observation("a")),
                (step("b", Some(5.0), None), observed("b", 5.0)),
            ],
        ),
        (
            "two-apart-by-runs",
            &["NCP-SESS-035"],
            "A run of one session takes no time of another.",
            vec![open("a"), open("b"), (run("b", 100.0), observation("b")), (run("a", 5.0), observed("a", 5.0))],
        ),
        (
            "two-apart-from-the-start",
            &["NCP-SESS-035"],
            "The time of a session begins when it is opened, whatever others have run.",
            vec![
                open("a"),
                (step("a", None, None), observation("a")),
                open("b"),
                (step("b", Some(5.0), None), observed("b", 5.0)),
            ],
        ),
        (
            "close-one-of-two",
            &["NCP-SESS-035"],
            "To close one session leaves the other open.",
            vec![open("a"), open("b"), (close("a"), anything()), steps("b", 10.0)],
        ),
        (
            "close-one-of-three",
            &["NCP-SESS-035"],
            "To close one session leaves the others open.",
            vec![open("a"), open("b"), open("c"), (close("b"), anything()), steps("a", 10.0), steps("c", 10.0)],
        ),
        (
            "failure-apart",
            &["NCP-SESS-035", "NCP-SESS-026"],
            "A request for a session that is not open costs no other.",
            vec![open("a"), (step("b", None, None), error()), (close("b"), not_closed("b")), steps("a", 10.0)],
        ),
        (
            "ids-alike",
            &["NCP-SESS-035"],
            "Session ids are compared by their letters.",
            vec![open("a"), (step("A", None, None), error()), (step("aa", None, None), error()), steps("a", 10.0)],
        ),
        (
            "in-order",
            &["NCP-SESS-036"],
            "The requests of a session are handled in their order.",
            vec![
                open("a"),
                (step("a", Some(1.0), None), observed("a", 1.0)),
                (step("a", Some(2.0), None), observed("a", 3.0)),
                (step("a", Some(4.0), None), observed("a", 7.0)),
                (step("a", Some(8.0), None), observed("a", 15.0)),
            ],
        ),
        (
            "other-hash",
            &["NCP-SESS-025"],
            "Another contract hash is no reason to refuse.",
            vec![open("b"), (close("b"), anything()), (with_hash.text(), opened("a")), steps("a", 10.0)],
        ),
    ];
    let mut cases: Vec<Case> = table
        .into_iter()
        .map(|(name, rules, title, trace)| {
            case(format!("life/{name}"), rules, trace)
                .title(title)
                .because("The states of section 4.2; a session that is refused is not open.")
        })
        .collect();
    cases.extend(durations());
    // Whether a server runs nothing for no time, or refuses to, is its affair.
    let for_nothing = any(vec![observed("a", 0.0), error()]);
    cases.push(
        case(
            "life/step-of-zero".to_owned(),
            &["NCP-SESS-033"],
            vec![open("a"), (step("a", Some(0.0), None), for_nothing), steps("a", 10.0)],
        )
        .title("A step of 0 ms takes no time.")
        .because("`sim_time_ms` is the time that the session has run; a step of 0 ms runs nothing or is refused."),
    );
    for (name, hash) in [
        ("null", Json::Null),
        ("empty", Json::string("")),
        ("word", Json::string("latest")),
        ("capitals", Json::string("24E8E6E31E1DEC8A")),
    ] {
        let request = Open::lif("a").json().with("contract_hash", hash).text();
        cases.push(
            case(
                format!("hash/{name}"),
                &["NCP-SESS-025"],
                // The session before shows that the network is offered at all; it is closed, so that
                // a server that holds one session at a time has room.
                vec![open("b"), (close("b"), anything()), (request, opened("a")), steps("a", 10.0)],
            )
            .title(format!("A contract hash that does not match ({name}) opens a session all the same."))
            .because("A server does not refuse an `open_session` for its contract hash alone."),
        );
    }
    let counted =
        |seq: i64| (step("a", None, None), text_of(object! { "kind" => "observation_frame", "seq" => int(seq) }));
    let from = |first: i64| {
        let frames = (first..first + 4).map(counted);
        std::iter::once(open("a")).chain(frames).collect::<Vec<_>>()
    };
    // Where the count begins is the server's affair.
    let begun = case("seq/rises".to_owned(), &["NCP-SESS-034"], from(1));
    let answers = |first| super::replies(from(first).into_iter().map(|(_, reply)| reply).collect());
    let without = super::replies(std::iter::once(not_opened("a")).chain((0..4).map(|_| error())).collect());
    cases.push(
        begun
            .shows(any(vec![answers(0), answers(1), without]))
            .title("The seq of the observation frames of a session should rise by one with each.")
            .because("The `seq` of the observation frames of a session should rise by one with each."),
    );
    let mixed = |first: i64| {
        let counted = |id: &str, seq: i64| {
            (step(id, None, None), text_of(object! { "kind" => "observation_frame", "seq" => int(seq) }))
        };
        vec![
            open("a"),
            open("b"),
            counted("a", first),
            counted("b", first),
            counted("b", first + 1),
            counted("a", first + 1),
        ]
    };
    let answers = |first| super::replies(mixed(first).into_iter().map(|(_, reply)| reply).collect());
    let without = super::replies(["a", "b"].into_iter().map(not_opened).chain((0..4).map(|_| error())).collect());
    let mut expected = vec![answers(0), answers(1), without];
    expected.extend([0, 1].map(mixed).iter().flat_map(|trace| super::within_capacities(trace)));
    cases.push(
        case("seq/apart".to_owned(), &["NCP-SESS-034"], mixed(1))
            .shows(any(expected))
            .title("The seq of one session should not rise with the frames of another.")
            .because("The `seq` of the observation frames of a session should rise by one with each."),
    );
    // Whether a stimulus for a port that the session lacks fails is the server's affair.
    let stray = |reply: Json, time: f64| {
        vec![
            open("a"),
            (step("a", Some(5.0), Some(("no-such-port", 1.0))), reply),
            (step("a", Some(5.0), None), observed("a", time)),
        ]
    };
    let answers = |trace: Vec<(String, Json)>| super::replies(trace.into_iter().map(|(_, reply)| reply).collect());
    let without = super::replies(vec![not_opened("a"), error(), error()]);
    cases.push(
        case("life/failure-in-the-simulator".to_owned(), &["NCP-SESS-037"], stray(error(), 5.0))
            .shows(any(vec![answers(stray(error(), 5.0)), answers(stray(observed("a", 5.0), 10.0)), without]))
            .title("A stimulus for a port that the session lacks costs at most its request.")
            .because("A request that fails within the simulator costs that request only."),
    );
    let again = vec![open("a"), steps("a", 10.0), (Open::lif("a").text(), not_opened("a")), steps("a", 20.0)];
    cases.push(
        case("twice/refused".to_owned(), &["NCP-SESS-030"], again)
            .title("To open a session that is open should be refused, and leave it as it is.")
            .because("A server should answer an `open_session` for a session that is already open with `ok` false, and leave the session as it is."),
    );
    cases
}

/// How far simulation time goes by one request.
fn durations() -> Vec<Case> {
    let mut cases = Vec::new();
    let mut push = |path: String, title: String, trace| {
        cases.push(
            case(path, &["NCP-SESS-031", "NCP-SESS-033"], trace)
                .title(title)
                .because("A server advances the simulation by a run's `duration_ms` or a step's `advance_ms`, or by the session's `chunk_ms` when that is absent."),
        );
    };
    for chunk in [1.0, 5.0, 20.0, 25.0] {
        let open = Open { chunk, ..Open::lif("a") };
        push(
            format!("chunk/{chunk}"),
            format!("A step without a time takes the session's chunk of {chunk} ms."),
            vec![(open.text(), opened("a")), steps("a", chunk)],
        );
    }
    for time in [1.0, 5.0, 25.0] {
        push(
            format!("advance/{time}"),
            format!("A step of {time} ms takes {time} ms."),
            vec![open("a"), (step("a", Some(time), None), observed("a", time))],
        );
    }
    for time in [1.0, 2.0, 5.0, 15.0, 25.0, 50.0, 100.0] {
        push(
            format!("run/{time}"),
            format!("A run of {time} ms takes {time} ms."),
            vec![open("a"), (run("a", time), observed("a", time))],
        );
    }
    cases
}

/// Networks that hardly anybody has; that they are refused, the text does not say.
fn refused() -> Vec<Case> {
    let network = |kind: &str, reference: &str| {
        object! { "ncp_version" => WIRE_VERSION, "kind" => "open_session", "session_id" => "a", "network" => object! { "kind" => kind, "ref" => reference } }.text()
    };
    [("builtin", "ncp.no.such.network"), ("handle", "no-such-handle"), ("builtin", "")]
        .into_iter()
        .enumerate()
        .map(|(nth, (kind, reference))| {
            let refusal = any(vec![not_opened("a"), error()]);
            let trace = vec![(network(kind, reference), refusal), (step("a", None, None), error()), (close("a"), not_closed("a"))];
            let refuses = super::replies(trace.iter().map(|(_, reply)| reply.clone()).collect());
            let opens = super::replies(vec![opened("a"), observation("a"), closed("a")]);
            case(format!("refused/{nth}"), &["NCP-SESS-024", "NCP-SESS-026"], trace)
                .shows(any(vec![refuses, opens]))
                .title(format!("A session of an unusual network ({kind} `{reference}`) is open only if the server said so."))
                .because("A server does not open a session that it answered with `ok` false, and answers a step for it with an error frame.")
        })
        .collect()
}

/// Bytes that are no request.
fn malformed() -> Vec<Case> {
    let long = format!("{{\"kind\":\"step_request\",\"session_id\":\"a\",\"x\":{}}}", "[".repeat(500));
    let table: [(&str, &'static str, &str, String); 24] = [
        ("empty", "NCP-SESS-021", "Nothing", String::new()),
        ("space", "NCP-SESS-021", "White space", "  ".to_owned()),
        ("word", "NCP-SESS-021", "A word", "hello".to_owned()),
        ("number", "NCP-SESS-021", "A number", "42".to_owned()),
        ("null", "NCP-SESS-021", "A null", "null".to_owned()),
        ("array", "NCP-SESS-021", "An array", "[]".to_owned()),
        ("empty-object", "NCP-SESS-021", "An empty object", "{}".to_owned()),
        (
            "truncated",
            "NCP-SESS-021",
            "A request that is cut off",
            step("a", None, None).trim_end_matches('}').to_owned(),
        ),
        ("trailing", "NCP-SESS-021", "A request with a tail", step("a", None, None) + " x"),
        ("two", "NCP-SESS-021", "Two requests in one", step("a", None, None) + &step("a", None, None)),
        ("no-kind", "NCP-SESS-021", "A request without a kind", r#"{"session_id":"a"}"#.to_owned()),
        (
            "unknown-kind",
            "NCP-SESS-021",
            "A request of an unknown kind",
            r#"{"kind":"pause_request","session_id":"a"}"#.to_owned(),
        ),
        (
            "kind-number",
            "NCP-SESS-021",
            "A request whose kind is a number",
            r#"{"kind":3,"session_id":"a"}"#.to_owned(),
        ),
        ("no-session", "NCP-SESS-021", "A step without a session", r#"{"kind":"step_request"}"#.to_owned()),
        (
            "session-null",
            "NCP-SESS-021",
            "A step whose session is null",
            r#"{"kind":"step_request","session_id":null}"#.to_owned(),
        ),
        (
            "session-invalid",
            "NCP-SESS-021",
            "A step whose session is no id",
            r#"{"kind":"step_request","session_id":"a/b"}"#.to_owned(),
        ),
        (
            "no-duration",
            "NCP-SESS-021",
            "A run without a duration",
            r#"{"kind":"run_request","session_id":"a"}"#.to_owned(),
        ),
        (
            "duration-text",
            "NCP-SESS-021",
            "A run whose duration is a text",
            r#"{"kind":"run_request","session_id":"a","duration_ms":"10"}"#.to_owned(),
        ),
        (
            "repeated",
            "NCP-SESS-021",
            "A step with two sessions",
            r#"{"kind":"step_request","session_id":"a","session_id":"b"}"#.to_owned(),
        ),
        ("deep", "NCP-SESS-021", "A request of 500 levels", long),
        (
            "sensor-frame",
            "NCP-SESS-022",
            "A sensor frame",
            r#"{"ncp_version":"0.5","kind":"sensor_frame","seq":1}"#.to_owned(),
        ),
        (
            "command-frame",
            "NCP-SESS-022",
            "A command frame",
            r#"{"ncp_version":"0.5","kind":"command_frame","mode":"active","seq":1}"#.to_owned(),
        ),
        (
            "session-opened",
            "NCP-SESS-022",
            "A reply",
            r#"{"ncp_version":"0.5","kind":"session_opened","session_id":"a"}"#.to_owned(),
        ),
        ("error", "NCP-SESS-022", "An error frame", r#"{"kind":"error","error":"no"}"#.to_owned()),
    ];
    table
        .into_iter()
        .map(|(name, rule, words, request)| {
            let trace = vec![(request.clone(), error()), open("a"), (request, error()), steps("a", 10.0)];
            // What is no JSON is where a server falls silent; what is JSON shows the error frame.
            let rules = match name {
                "empty" | "space" | "word" | "truncated" | "trailing" | "two" | "deep" => ["NCP-SESS-020", rule],
                _ => [rule, "NCP-SESS-020"],
            };
            case(format!("malformed/{name}"), &rules, trace)
                .title(format!("{words} is answered with an error frame, and changes nothing."))
                .because("A server answers every request with exactly one reply, and one that it cannot decode, or that is no request, with an error frame.")
        })
        .collect()
}

fn versions() -> Vec<Case> {
    let mut cases = Vec::new();
    for (nth, version) in
        ["0.4", "0.6", "1.0", "0", "5.0", "0.50", "", "latest", "0.5.0", "v0.5", "0.5 ", "+0.5", "0.x"]
            .into_iter()
            .enumerate()
    {
        // One that is no version at all, a server may take for a frame that is broken.
        let well_formed = ["0.4", "0.6", "1.0", "0", "5.0", "0.50"].contains(&version);
        let refusal = || match well_formed {
            true => not_opened("a"),
            false => any(vec![not_opened("a"), error()]),
        };
        let request = Open::lif("a").json().with("ncp_version", version.into()).text();
        cases.push(
            case(format!("version/{nth:02}"), &["NCP-SESS-023"], vec![(request.clone(), refusal())])
                .title(format!("An `open_session` of the version \u{ab}{version}\u{bb} is refused."))
                .flags(&["lenient-versions"])
                .because(if well_formed {
                    "A server answers an `open_session` of an incompatible `ncp_version` with a `session_opened` in which `ok` is false."
                } else {
                    "A server answers an `open_session` of a malformed `ncp_version` with a `session_opened` in which `ok` is false, or with an error frame."
                }),
        );
        if !["0.4", "1.0", "latest"].contains(&version) {
            continue;
        }
        // A server that opens the session after all breaks another rule.
        let trace = vec![(request, refusal()), (step("a", None, None), error()), (close("a"), not_closed("a"))];
        let refuses = super::replies(trace.iter().map(|(_, reply)| reply.clone()).collect());
        let opens = super::replies(vec![opened("a"), anything(), anything()]);
        cases.push(
            case(format!("version/{nth:02}/leaves-nothing"), &["NCP-SESS-024"], trace)
                .shows(any(vec![refuses, opens]))
                .title(format!(
                    "An `open_session` of the version \u{ab}{version}\u{bb} that is refused leaves no session."
                ))
                .flags(&["lenient-versions"])
                .because("A server does not open a session that it answered with `ok` false."),
        );
    }
    cases
}

/// Times that cannot be run.
fn times() -> Vec<Case> {
    let mut cases = Vec::new();
    for time in [-1.0, -0.001, -1e308, -5e-324] {
        for (name, request) in [("step", step("a", Some(time), None)), ("run", run("a", time))] {
            cases.push(
                case(
                    format!("time/{name}/{}", name_of(time)),
                    &["NCP-SESS-032", "NCP-SESS-033"],
                    vec![open("a"), (request, error()), steps("a", 10.0)],
                )
                .title(format!("A {name} of {time} ms is an error, and time stands still."))
                .because("A server answers a step or a run whose time is negative with an error frame."),
            );
        }
    }
    for (name, literal) in [
        ("overflow", "1e999"),
        ("minus-overflow", "-1e999"),
        ("nan", "NaN"),
        ("infinity", "Infinity"),
        ("text", "\"10\""),
        ("boolean", "true"),
    ] {
        let request =
            format!(r#"{{"ncp_version":"0.5","kind":"step_request","session_id":"a","advance_ms":{literal}}}"#);
        cases.push(
            case(
                format!("time/literal/{name}"),
                &["NCP-SESS-021", "NCP-SESS-032"],
                vec![open("a"), (request, error()), steps("a", 10.0)],
            )
            .title(format!("A step of {literal} is an error, and time stands still."))
            .because("A step whose time is not finite, or is no number, is answered with an error frame."),
        );
    }
    cases
}

/// Numbers that leave the doubles within the simulator, so that no frame can hold what it gives.
fn failures() -> Vec<Case> {
    let driven = |open: Open, observable: &str, kind: &str| Open {
        records: vec![record("out", observable, 1.0)],
        stimuli: vec![stimulus("in", kind)],
        ..open
    };
    let rate = driven(Open { params: vec![("mu", 1.7e308)], ..Open::rate("a") }, "rate", "rate_inject");
    let membrane = driven(Open { params: vec![("C_m", 1.0)], ..Open::lif("a") }, "V_m", "current_pA");
    // With the second input, either network stays where it began.
    let table = [("rate", rate, 1.7e308, -1.7e308, 0.0), ("membrane", membrane, -1.7e308, 0.0, -70.0)];
    let mut cases = Vec::new();
    for (what, a, too_much, rest, state) in table {
        let open = || (a.text(), opened("a"));
        let by = |time: f64, value: f64| step("a", Some(time), Some(("in", value)));
        let fails = || (by(10.0, too_much), error());
        let after = |from: u32, to: u32| {
            let times: Vec<f64> = (from + 1..=to).map(f64::from).collect();
            let values = vec![state; times.len()];
            recorded("a", object! { "out" => object! { "times" => nums(&times), "values" => nums(&values) } })
        };
        let mut push = |name: &str, rules: &[&'static str], title: String, trace, why: &str| {
            cases.push(
                super::reference(format!("fails/{what}{name}"), rules, trace)
                    .title(title)
                    .flags(&["session-lifecycle", "non-finite-numbers"])
                    .because(why),
            );
        };
        push(
            "",
            &["NCP-SESS-037"],
            format!("A step whose {what} leaves the doubles is an error, and costs no other session."),
            vec![open(), (Open::lif("b").text(), opened("b")), fails(), steps("b", 10.0)],
            "A request that fails within the simulator costs that request only, and is answered with an error frame; no frame can hold an infinity.",
        );
        push(
            "/goes-on",
            &["NCP-SESS-037", "NCP-SESS-057"],
            format!("After a step whose {what} leaves the doubles, the session goes on from where it was."),
            vec![open(), fails(), (by(5.0, rest), after(0, 5))],
            "A request that fails costs that request only: network and time are as they were before it.",
        );
        push(
            "/goes-on-later",
            &["NCP-SESS-037", "NCP-SESS-057"],
            format!("A step whose {what} leaves the doubles undoes nothing of the steps before it."),
            vec![open(), (by(3.0, rest), after(0, 3)), fails(), fails(), (by(5.0, rest), after(3, 8))],
            "A request that fails costs that request only: network and time are as they were before it.",
        );
        push(
            "/takes-no-time",
            &["NCP-SESS-057", "NCP-SESS-033"],
            format!("A step whose {what} leaves the doubles takes no simulation time."),
            vec![open(), fails(), (by(5.0, rest), observed("a", 5.0))],
            "A request that fails leaves the time of the session as it was.",
        );
    }
    cases
}
