//! The frames of the control plane: how requests may be written, what they leave out, and what replies say.

use ncp_text::WIRE_VERSION;
use ncp_text::tables::tables;

use super::numbers::simulate;
use super::{
    Open, asking, case, close, error, not_opened, observation, observed, opened, record, recorded, reference, replies,
    run, step, stimulus,
};
use crate::case::{Case, File, REFERENCE_NETWORKS};
use crate::json::{Json, object};
use crate::model::meaning;
use crate::scenario::beside;
use crate::trace::{any, anything, exactly, frame_of, nums, text_of};

pub(super) fn file() -> File {
    let mut cases = versions();
    cases.push(of_an_older_request());
    cases.push(of_an_older_close());
    cases.extend(written());
    cases.extend(error_frames());
    cases.extend(pins());
    cases.extend(unversioned());
    cases.extend(defaults());
    cases.extend(nulls());
    cases.extend(opened_with_nulls());
    cases.extend(whole());
    cases.extend(encoded());
    cases.extend(bindings());
    cases.extend(stimulus_frames());
    cases.extend(times_of_stimuli());
    cases.extend(units_of_values());
    cases.extend(odd_names());
    let about = "The frames of the control plane: how requests may be written, and what the replies to them say.";
    File::new("session", "frames", about, cases)
}

type Exchange = (String, Json);

/// A session of one neuron whose potential is recorded at each step, and that one port drives.
fn driven() -> Open {
    Open {
        records: vec![record("v", "V_m", 1.0)],
        stimuli: vec![stimulus("in", "current_pA")],
        chunk: 1.0,
        ..Open::lif("a")
    }
}

/// The potentials of its neuron under these currents, a step each, from a step on.
fn potentials(currents: &[f64], from: usize) -> Json {
    let mut neuron = super::numbers::Lif::new(&[], 1.0);
    let values: Vec<f64> = currents.iter().map(|current| (neuron.step(*current), neuron.v).1).collect();
    let times: Vec<f64> = (1_u32..).map(f64::from).take(values.len()).collect();
    let v = object! { "times" => nums(&times[from..]), "values" => nums(&values[from..]) };
    recorded("a", object! { "v" => v })
}

/// A request of the session for one step, with a stimulus frame as it is written.
fn with_stimulus(kind: &str, frame: Json) -> String {
    let time = if kind == "step_request" { "advance_ms" } else { "duration_ms" };
    object! { "ncp_version" => WIRE_VERSION, "kind" => kind, "session_id" => "a", time => crate::trace::num(1.0),
    "stimulus" => frame }
    .text()
}

/// The values of a stimulus frame that gives the port a current.
fn values(current: f64) -> Json {
    object! { "in" => object! { "data" => nums(&[current]) } }
}

/// The kinds of the requests that run a session, as titles say them.
const RUNNING: [(&str, &str); 2] = [("step_request", "step"), ("run_request", "run")];

/// The pattern of a reply, with the version that it states.
fn stating(reply: Json) -> Json {
    reply.edit(&["$json"], |reply| reply.with("ncp_version", WIRE_VERSION.into()))
}

/// A case about the version of a reply; what else it is, another rule decides.
fn of_version(case: Case, nth: usize, rule: &'static str) -> Case {
    case.by(format!("/replies/{nth}"), rule).by_own(format!("/replies/{nth}/ncp_version"))
}

/// Which version replies state: the server's own.
fn versions() -> Vec<Case> {
    const WHY: &str = "A server states its own wire version in each reply but the error frame.";
    let mut cases = Vec::new();
    for (name, version) in [("older", beside(-1)), ("next-major", "1.0".to_owned())] {
        let request = Open::lif("a").json().with("ncp_version", version.as_str().into()).text();
        let trace = vec![(request, stating(not_opened("a")))];
        cases.push(
            of_version(
                case(format!("version/refused/{name}"), &["NCP-VER-021", "NCP-SESS-023"], trace),
                0,
                "NCP-SESS-023",
            )
            .title(format!("The refusal of an `open_session` of the version {version} states the server's own."))
            .because(WHY),
        );
    }
    let closed = super::closed("a");
    let table: [(&str, &str, Vec<Exchange>, &'static str); 3] = [
        ("opened", "A `session_opened`", Vec::new(), "NCP-SESS-050"),
        ("stepped", "The reply to a step", vec![(step("a", None, None), observation("a"))], "NCP-SESS-027"),
        ("closed", "A `session_closed`", vec![(close("a"), closed)], "NCP-SESS-028"),
    ];
    for (name, words, trace, rule) in table {
        // A version that is the same by its numbers, in a spelling of its own.
        for (path, spelled, when) in [
            (format!("version/{name}"), WIRE_VERSION.to_owned(), String::new()),
            (
                format!("version/{name}/of-another-spelling"),
                format!("0{WIRE_VERSION}"),
                format!(", also in a session that was opened by the version 0{WIRE_VERSION}"),
            ),
        ] {
            let open = Open::lif("a").json().with("ncp_version", spelled.into()).text();
            let mut trace = trace.clone();
            trace.insert(0, (open, opened("a")));
            let last = trace.len() - 1;
            trace[last].1 = stating(trace[last].1.clone());
            let case = of_version(reference(path, &["NCP-VER-021", rule], trace), last, rule);
            cases.push(case.title(format!("{words} states the wire version of the server{when}.")).because(WHY));
        }
    }
    cases
}

/// A request of an older version within a session: refused, or answered in the server's own version.
fn of_an_older_request() -> Case {
    let request = Json::read(&step("a", None, None)).with("ncp_version", beside(-1).as_str().into()).text();
    let reply = any(vec![stating(observation("a")), error()]);
    let trace = vec![(Open::lif("a").text(), opened("a")), (request, reply)];
    let case = case("version/of-an-older-step".to_owned(), &["NCP-VER-021", "NCP-SESS-020"], trace);
    of_version(case, 1, "NCP-SESS-020")
        .title("A step of an older version is refused, or its reply states the version of the server.")
        .because("Decoding may reject another version; a reply states the wire version of its sender.")
}

/// A close of an older version of what is not open: refused, or answered in the server's own version.
fn of_an_older_close() -> Case {
    let request = Json::read(&close("a")).with("ncp_version", beside(-1).as_str().into()).text();
    let closed = object! { "kind" => "session_closed", "session_id" => "a", "ok" => false };
    let reply = any(vec![stating(text_of(closed)), error()]);
    of_version(
        case("version/of-an-older-close".to_owned(), &["NCP-VER-021", "NCP-SESS-029"], vec![(request, reply)]),
        0,
        "NCP-SESS-029",
    )
    .title("A close of an older version is refused, or its reply states the version of the server.")
    .because("Decoding may reject another version; a reply states the wire version of its sender.")
}

/// What stands in a field of which nothing is said, whatever it is; if it has to stand there at all.
fn field(is_optional: bool) -> Json {
    if is_optional { any(vec![Json::Null, anything()]) } else { anything() }
}

/// A message by its table: each field is there but for the optional ones, and no other; some as they are said.
fn by_table(name: &str, said: &[(&str, Json)]) -> Json {
    let fields = tables().message(name).map(|message| message.fields.as_slice()).unwrap_or_default();
    let shape = |name: &str, is_optional| {
        let said = said.iter().find(|(known, _)| *known == name);
        said.map_or_else(|| field(is_optional), |(_, shape)| shape.clone())
    };
    let members = fields.iter().map(|of| (of.name.clone(), shape(&of.name, of.json_type().ends_with("|null"))));
    exactly(Json::Object(members.collect()))
}

/// What encoders of replies write: every field of the tables, and null for what is not set.
fn written() -> Vec<Case> {
    let session = || Open { records: vec![record("v", "V_m", 1.0), record("s", "spikes", 1.0)], ..Open::lif("a") };
    let older = || Open::lif("a").json().with("ncp_version", beside(-1).as_str().into()).text();
    let open = || (session().text(), opened("a"));
    let steps = || step("a", Some(1.0), None);
    let there = || object! { "unit" => anything(), "recordable" => anything() };
    let optional = |kind: &str| {
        text_of(object! { "kind" => kind, "provenance" => anything(), "error" => anything(),
        "contract_hash" => anything() })
    };
    // What is optional in a reply of the session, and where.
    let of_opened = ["/provenance", "/error", "/contract_hash"].as_slice();
    let of_samples = ["/records/*/unit", "/records/*/recordable"].as_slice();
    let records = object! { "v" => there(), "s" => there() };
    #[expect(clippy::type_complexity, reason = "a table is read by its rows")]
    let table: [(&str, &str, Vec<Exchange>, &[&str], &'static str); 3] = [
        (
            "opened",
            "A `session_opened`",
            vec![(session().text(), optional("session_opened"))],
            of_opened,
            "NCP-SESS-050",
        ),
        ("refused", "A refusal", vec![(older(), optional("session_opened"))], of_opened, "NCP-SESS-023"),
        ("observed", "An observation", vec![open(), (steps(), recorded("a", records))], of_samples, "NCP-SESS-027"),
    ];
    let mut cases = Vec::new();
    for (name, words, trace, places, rule) in table {
        let last = trace.len() - 1;
        let case = reference(format!("written/null/{name}"), &["NCP-WIRE-082", rule], trace);
        let mut case = case.by(format!("/replies/{last}"), rule);
        for place in places {
            case.by.remove(&format!("/replies/*{place}"));
            case = case.by_own(format!("/replies/{last}{place}"));
        }
        cases.push(
            case.title(format!("{words} writes null for what is not set."))
                .flags(&["session-lifecycle"])
                .because("An encoder writes an unset optional field as null; a reply is the text that is sent."),
        );
    }
    let of_session = |name: &str, kind: &str, said: Vec<(&str, Json)>| {
        let said: Vec<(&str, Json)> =
            [("kind", Json::from(kind)), ("session_id", "a".into())].into_iter().chain(said).collect();
        text_of(by_table(name, &said))
    };
    let provenance = || ("provenance", any(vec![Json::Null, by_table("SimProvenance", &[])]));
    let ok = |is: bool| ("ok", Json::Bool(is));
    let observation = || by_table("Observation", &[]);
    let records = || ("records", exactly(object! { "v" => observation(), "s" => observation() }));
    let opened_by = |is: bool| of_session("SessionOpened", "session_opened", vec![ok(is), provenance()]);
    let table: [(&str, &str, Vec<Exchange>, &'static str); 4] = [
        ("opened", "A `session_opened`", vec![(session().text(), opened_by(true))], "NCP-SESS-050"),
        ("refused", "A refusal", vec![(older(), opened_by(false))], "NCP-SESS-023"),
        (
            "observed",
            "An `observation_frame`",
            vec![open(), (steps(), of_session("ObservationFrame", "observation_frame", vec![records()]))],
            "NCP-SESS-027",
        ),
        (
            "closed",
            "A `session_closed`",
            vec![open(), (close("a"), of_session("SessionClosed", "session_closed", vec![ok(true)]))],
            "NCP-SESS-028",
        ),
    ];
    for (name, words, trace, rule) in table {
        let last = trace.len() - 1;
        let mut case = reference(format!("written/whole/{name}"), &["NCP-WIRE-081", rule], trace);
        case.by.retain(|place, _| place == "/replies/0" && last > 0);
        let case = ["kind", "session_id", "ok"]
            .into_iter()
            .fold(case, |case, member| case.by(format!("/replies/{last}/{member}"), rule));
        cases.push(
            case.title(format!("{words} has every field of its table, and no other member."))
                .flags(&["session-lifecycle"])
                .because(
                    "An encoder writes every field of the tables, also one that has its default, and no other member.",
                ),
        );
    }
    cases
}

/// Error frames: two members, and perhaps the session that they concern, which is a string.
fn error_frames() -> Vec<Case> {
    let error = |ids: &[&str]| {
        let ids = std::iter::once(Json::Null).chain(ids.iter().map(|id| Json::from(*id))).collect();
        text_of(exactly(object! { "kind" => "error", "error" => anything(), "session_id" => any(ids) }))
    };
    let request = |kind: &str, id: &str| {
        let request = object! { "ncp_version" => WIRE_VERSION, "kind" => kind, "session_id" => Json::literal(id) };
        match kind {
            "run_request" => request.with("duration_ms", crate::trace::num(1.0)),
            "open_session" => request.with("network", object! { "ref" => "ncp.reference.lif" }),
            _ => request,
        }
        .text()
    };
    let sensor = || object! { "ncp_version" => WIRE_VERSION, "kind" => "sensor_frame", "session_id" => "a" }.text();
    let odd = [
        ("number", "step_request", "7", "is a number"),
        ("array", "close_session", "[\"a\"]", "is an array"),
        ("object", "step_request", "{}", "is an object"),
        ("number-to-open", "open_session", "7", "is a number"),
        ("no-id", "step_request", "\"a/b\"", "is no id"),
    ];
    let mut table: Vec<(String, String, String, Json, &'static str)> = odd
        .into_iter()
        .map(|(name, kind, id, says)| {
            // One that writes down what came as a string has written a string.
            let ids = ["", id.trim_matches('"'), "a"];
            let says = format!("a `{kind}` whose session {says}");
            (format!("of-{name}"), says, request(kind, id), error(&ids), "NCP-SESS-021")
        })
        .collect();
    table.extend([
        ("of-nonsense".into(), "what is no JSON".into(), "hello".to_owned(), error(&[""]), "NCP-SESS-021"),
        ("of-a-sensor-frame".into(), "a sensor frame".into(), sensor(), error(&["", "a"]), "NCP-SESS-022"),
        (
            "of-no-session".into(),
            "a step of a session that is not open".into(),
            step("z", None, None),
            error(&["z"]),
            "NCP-SESS-026",
        ),
    ]);
    table
        .into_iter()
        .map(|(name, says, request, reply, rule)| {
            asking(format!("error/{name}"), &["NCP-WIRE-102", rule], vec![request])
                .shows(replies(vec![reply]))
                .by("/replies/0/kind", rule)
                .title(format!(
                    "The error frame that answers {says} has its two members, and no other but a `session_id` that is \
                     a string or null."
                ))
                .flags(&["unanswered-requests"])
                .because(
                    "A server writes an error frame as an object with the members `kind` and `error`, and no others \
                     but `session_id`, which is a string or null.",
                )
        })
        .collect()
}

/// The pins of what refuses.
fn pins() -> Vec<Case> {
    let pinned = || {
        let pins = object! { "calibrated_posterior" => false, "is_simulation_output" => true };
        text_of(object! { "kind" => "session_opened", "provenance" => any(vec![Json::Null, pins]) })
    };
    let open = || Open::lif("a").json();
    let network = |network: Json| open().with("network", network).text();
    let table: [(&str, &str, Vec<Exchange>, &'static str); 3] = [
        (
            "older-version",
            "of an older version",
            vec![(open().with("ncp_version", beside(-1).as_str().into()).text(), pinned())],
            "NCP-SESS-023",
        ),
        (
            "unknown-network",
            "of an unknown network",
            vec![(
                network(object! { "kind" => "builtin", "ref" => "ncp.no.such.network" }),
                any(vec![pinned(), error()]),
            )],
            "NCP-SESS-020",
        ),
        (
            "open-already",
            "for a session that is open",
            vec![(open().text(), any(vec![pinned(), error()])), (open().text(), any(vec![pinned(), error()]))],
            "NCP-SESS-020",
        ),
    ];
    table
        .into_iter()
        .map(|(name, says, trace, rule)| {
            let last = trace.len() - 1;
            let (requests, answers) = trace.into_iter().unzip();
            asking(format!("pins/{name}"), &["NCP-PROV-008", "NCP-PROV-007", rule], requests)
                .shows(replies(answers))
                .by(format!("/replies/{last}"), rule)
                .by_own(format!("/replies/{last}/provenance"))
                .title(format!("What answers an `open_session` {says} has both pins in its provenance, if it has one."))
                .because(
                    "The pins stand within the provenance of a `session_opened`, whether its `ok` is true or false.",
                )
        })
        .collect()
}

/// A request as it is, without the version.
fn bare(request: &str) -> String {
    Json::read(request).without("ncp_version").text()
}

/// A case of the reference networks that is about all of its replies, these places of them among it.
fn about_all(mut case: Case, places: &[&str]) -> Case {
    case.by.remove("/replies/0");
    for place in places {
        case.by.remove(*place);
    }
    case
}

/// Requests without a version, to a server that is not strict.
fn unversioned() -> Vec<Case> {
    let open = || (Open::lif("a").text(), opened("a"));
    let table: [(&str, Vec<Exchange>, &'static str); 4] = [
        ("open_session", vec![open()], "NCP-SESS-050"),
        ("step_request", vec![open(), (step("a", None, None), observation("a"))], "NCP-SESS-027"),
        ("run_request", vec![open(), (run("a", 5.0), observation("a"))], "NCP-SESS-027"),
        ("close_session", vec![open(), (close("a"), super::closed("a"))], "NCP-SESS-028"),
    ];
    let mut cases = Vec::new();
    for (kind, mut trace, rule) in table {
        if let Some((request, _)) = trace.last_mut() {
            *request = bare(request);
        }
        let is_opening = trace.len() == 1;
        let case = reference(format!("unversioned/{kind}"), &["NCP-WIRE-032", "NCP-WIRE-033", rule], trace);
        cases.push(
            if is_opening { about_all(case, &[]) } else { case }
                .title(format!("A `{kind}` without a version is carried out."))
                .flags(&["over-strict"])
                .because("An absent `ncp_version` is the wire version, and does not reject a request."),
        );
    }
    cases
}

/// What an `open_session` leaves out is what the tables say.
fn defaults() -> Vec<Case> {
    let target = |without: &str| record("v", "V_m", 1.0).without(without);
    let params = vec![("I_e", 300.0)];
    let (times, sampled, _) = simulate(&params, 0.5, 4, 300.0);
    let every = |nth: usize| -> Json {
        let at = |of: &[f64]| of.iter().copied().skip(nth - 1).step_by(nth).collect::<Vec<_>>();
        object! { "v" => object! { "times" => nums(&at(&times)), "values" => nums(&at(&sampled)) } }
    };
    let of = |target: Json, dt: f64| Open { params: params.clone(), records: vec![target], dt, ..Open::lif("a") };
    let by_half = |target: Json, records: Json| {
        vec![(of(target, 0.5).text(), opened("a")), (step("a", Some(2.0), None), recorded("a", records))]
    };
    let kind_left_out = Open { stimuli: vec![stimulus("in", "current_pA").without("kind")], ..driven() };
    let sim = |sim: Option<Json>| {
        let open = Open::lif("a").json();
        sim.map_or_else(|| open.clone().without("sim"), |sim| open.clone().with("sim", sim)).text()
    };
    // A chunk, and a time that is a whole number of steps only by rounding.
    let runs = |open: String, chunk: f64, odd: f64| {
        vec![
            (open, opened("a")),
            (step("a", None, None), observed("a", chunk)),
            (step("a", Some(0.24), None), observed("a", chunk + odd)),
        ]
    };
    let num = crate::trace::num;
    let bare = ["record", "stimulus"].into_iter().fold(Open::lif("a").json(), Json::without);
    let bare = bare.edit(&["network"], |network| network.without("kind").without("params"));
    let nothing = recorded("a", exactly(Json::object()));
    let table: Vec<(&str, &str, Vec<Exchange>, &'static str)> = vec![
        ("cadence", "the cadence of a port", by_half(target("cadence_ms"), every(2)), "NCP-SESS-053"),
        ("observable", "the observable of a port", by_half(target("observable"), every(2)), "NCP-SESS-050"),
        (
            "stimulus-kind",
            "the kind of a stimulus",
            vec![
                (kind_left_out.text(), opened("a")),
                (step("a", Some(1.0), Some(("in", 300.0))), potentials(&[300.0], 0)),
            ],
            "NCP-SESS-054",
        ),
        ("sim", "how to run", runs(sim(None), 10.0, 0.2), "NCP-SESS-031"),
        ("chunk", "its chunk", runs(sim(Some(object! { "dt_ms" => num(1.0) })), 10.0, 0.0), "NCP-SESS-031"),
        (
            "ports",
            "what to record, what can drive it, and the kind of its network",
            vec![(bare.text(), opened("a")), (step("a", None, None), nothing)],
            "NCP-SESS-038",
        ),
    ];
    table
        .into_iter()
        .map(|(name, words, trace, rule)| {
            let case = reference(format!("default/{name}"), &["NCP-WIRE-023", rule], trace);
            about_all(case, &["/replies/*/sim_time_ms"])
                .title(format!("An `open_session` that leaves out {words} means the default."))
                .flags(&["session-lifecycle"])
                .because("An absent field is its default in the tables, for a server that acts on it, too.")
        })
        .collect()
}

/// Optional members of requests that are null, as encoders write them: they are absent.
fn nulls() -> Vec<Case> {
    let open = || (driven().text(), opened("a"));
    let drives = || (step("a", Some(1.0), Some(("in", 300.0))), potentials(&[300.0], 0));
    let goes_on = || potentials(&[300.0; 2], 1);
    let steps = |advance: Option<f64>| Json::read(&step("a", advance, None));
    let unit_null = object! { "data" => nums(&[300.0]), "unit" => Json::Null };
    let table: [(&str, &str, Vec<Exchange>); 4] = [
        (
            "advance_ms",
            "A step whose `advance_ms` is null takes the session's chunk.",
            vec![open(), (steps(None).with("advance_ms", Json::Null).text(), potentials(&[0.0], 0))],
        ),
        (
            "stimulus/step_request",
            "A step whose `stimulus` is null changes no port.",
            vec![open(), drives(), (steps(Some(1.0)).with("stimulus", Json::Null).text(), goes_on())],
        ),
        (
            "stimulus/run_request",
            "A run whose `stimulus` is null changes no port.",
            vec![open(), drives(), (Json::read(&run("a", 1.0)).with("stimulus", Json::Null).text(), goes_on())],
        ),
        (
            "unit",
            "A value whose `unit` is null acts as one without.",
            vec![
                open(),
                (
                    with_stimulus("step_request", object! { "values" => object! { "in" => unit_null } }),
                    potentials(&[300.0], 0),
                ),
            ],
        ),
    ];
    table
        .into_iter()
        .map(|(name, title, trace)| {
            reference(format!("null/{name}"), &["NCP-WIRE-022", "NCP-SESS-054"], trace)
                .title(title)
                .flags(&["session-lifecycle"])
                .because("A receiver reads null in an optional field as absent; a stimulus stays until another comes.")
        })
        .collect()
}

/// Optional members of an `open_session` that are null.
fn opened_with_nulls() -> Vec<Case> {
    [("contract_hash", &[][..]), ("model_name", &["network"]), ("seed", &["sim"]), ("duration_ms", &["sim"])]
        .into_iter()
        .map(|(name, path)| {
            let text = driven().json().edit(path, |of| of.with(name, Json::Null)).text();
            let trace = vec![(text, opened("a")), (step("a", None, None), potentials(&[0.0], 0))];
            about_all(reference(format!("null/{name}"), &["NCP-WIRE-022", "NCP-SESS-050"], trace), &[])
                .title(format!("An `open_session` whose `{name}` is null is one without."))
                .flags(&["session-lifecycle"])
                .because("A receiver reads null in an optional field as absent.")
        })
        .collect()
}

/// The pattern of a reply that has every field of its kind in the order of the tables, with some of them known.
fn in_order(kind: &str, known: &[(&str, Json)]) -> Json {
    let fields = tables().kind(kind).map_or(&[][..], |message| &message.fields);
    let field = |name: &str| match known.iter().find(|(of, _)| *of == name) {
        Some((_, value)) => value.clone(),
        None if name == "kind" => kind.into(),
        None => anything(),
    };
    frame_of(Json::Object(fields.iter().map(|known| (known.name.clone(), field(&known.name))).collect()))
}

/// Replies are frames as every other: what an encoder has to keep is asked of them, too.
fn encoded() -> Vec<Case> {
    let ports = ["w", "\u{1f600}", "v", "\u{ff5e}"];
    let sorted = ["v", "w", "\u{ff5e}", "\u{1f600}"];
    let open = Open {
        records: ports.map(|port| record(port, "V_m", 1.0)).into(),
        stimuli: Vec::new(),
        other: Some(2),
        ..driven()
    };
    let requests = || vec![open.text(), step("a", Some(1.0), None), step("b", Some(1.0), None), close("a")];
    let resolved = || ("resolved", object! { "other" => 2, "pop" => 1 });
    let observed = |value: &dyn Fn() -> Json| {
        let records = Json::Object(sorted.map(|port| (port.to_owned(), value())).into());
        in_order("observation_frame", &[("records", records)])
    };
    let of = |name: &str, rule: &'static str, replies: Vec<Json>, says: &str, why: &str| {
        let case = asking(format!("encoded/{name}"), &[rule, "NCP-SESS-027"], requests());
        case.shows(super::replies(replies)).needs(REFERENCE_NETWORKS).title(says).because(why)
    };
    let fields = of(
        "fields",
        "NCP-WIRE-080",
        ["session_opened", "observation_frame", "error", "session_closed"].map(|kind| in_order(kind, &[])).into(),
        "Replies have all fields of their kinds, in the order of the tables.",
        "An encoder writes every field of a message, in the order of the tables; a reply is a frame as every other.",
    );
    let maps = of(
        "maps",
        "NCP-WIRE-083",
        vec![in_order("session_opened", &[resolved()]), observed(&anything), anything(), anything()],
        "The maps of replies are sorted by the code points of their keys.",
        "An encoder writes the entries of a map sorted by the code points of their keys, also U+FF5E before U+1F600.",
    );
    let senders = || object! { "senders" => std::iter::once(1_u32).collect::<Json>() };
    let integers = of(
        "integers",
        "NCP-WIRE-085",
        vec![in_order("session_opened", &[resolved()]), observed(&senders), anything(), anything()],
        "The integers of replies are spelled as integers.",
        "An encoder writes an integer field as a plain JSON integer, without fraction or exponent.",
    );
    vec![
        fields.by("within", "NCP-WIRE-081").by_own("order"),
        maps.by("within", "NCP-SESS-038").by_own("order"),
        integers.by("order", "NCP-WIRE-083"),
    ]
}

/// Requests that are written whole, as encoders write them.
fn whole() -> Vec<Case> {
    let whole = |request: String| {
        let frame = Json::read(&request);
        let kind = frame.get("kind").and_then(Json::as_str).unwrap_or_default();
        let mut whole = meaning(kind, &frame);
        if whole.get("contract_hash") == Some(&Json::Null) {
            whole = whole.with("contract_hash", ncp_text::CONTRACT_HASH.into());
        }
        whole.text()
    };
    let trace = vec![
        (driven().text(), opened("a")),
        (step("a", Some(1.0), Some(("in", 300.0))), potentials(&[300.0], 0)),
        (step("a", None, None), potentials(&[300.0; 2], 1)),
        (with_stimulus("run_request", object! { "values" => values(50.0) }), potentials(&[300.0, 300.0, 50.0], 2)),
        (run("a", 1.0), potentials(&[300.0, 300.0, 50.0, 50.0], 3)),
        (close("a"), super::closed("a")),
    ];
    let trace = trace.into_iter().map(|(request, reply)| (whole(request), reply)).collect();
    vec![
        about_all(reference("whole".to_owned(), &["NCP-WIRE-034", "NCP-SESS-054", "NCP-SESS-028"], trace), &[])
            .by("/replies/5", "NCP-SESS-028")
            .title("Requests in which every field of the tables is written are carried out.")
            .flags(&["session-lifecycle"])
            .because("Every field is read as the value that the frame gives it."),
    ]
}

/// Entities that are bound to the ports of a session, and a seed.
fn bindings() -> Vec<Case> {
    let entity = |path: &str| object! { "path" => path };
    let bound = |path: &str, port: &str, direction: Option<&str>| {
        let binding = object! { "entity" => entity(path), "port" => port };
        direction.into_iter().fold(binding, |binding, direction| binding.with("direction", direction.into()))
    };
    let imu = |direction| bound("/world/uav3/imu", "v", direction);
    let motor = |direction| bound("/world/uav3/motor", "in", direction);
    let annotated = object! {
        "entity" => object! { "path" => "/world/uav3/imu", "role" => "actor", "meta" => object! { "of" => "uav3" } },
        "port" => "v",
        "direction" => "record",
    };
    let table = [
        ("recorded", "to the port that it records", vec![imu(Some("record"))]),
        ("both", "to both of its ports", vec![imu(Some("record")), motor(None)]),
        ("annotated", "of a role and with annotations to a port", vec![annotated]),
    ];
    let mut cases = Vec::new();
    let mut add = |name: String, title: String, open: Json, why: &str| {
        let records = |reply: Json| reply.edit(&["$json", "records"], exactly);
        let trace = vec![
            (open.text(), opened("a")),
            (step("a", Some(1.0), Some(("in", 300.0))), records(potentials(&[300.0], 0))),
        ];
        cases.push(
            reference(name, &["NCP-SESS-050", "NCP-SESS-038"], trace)
                .title(title)
                .flags(&["session-lifecycle"])
                .because(why),
        );
    };
    for (name, words, bindings) in table {
        let open = driven().json().with("bindings", Json::Array(bindings));
        let why = "A binding ties an entity to a port of the session, of a record or of a stimulus target.";
        add(format!("binding/{name}"), format!("A session that binds an entity {words} is opened."), open, why);
    }
    let open = driven().json().edit(&["sim"], |sim| sim.with("seed", crate::trace::int(7)));
    let why = "A server that claims the reference networks opens them; there is no random number in them.";
    add("seed".to_owned(), "A session with a seed is opened, and runs as every other.".to_owned(), open, why);
    cases
}

/// Stimulus frames within a request: whole, of another kind or session, and one that comes by itself.
fn stimulus_frames() -> Vec<Case> {
    let open = || (driven().text(), opened("a"));
    let at_rest = || (step("a", Some(1.0), None), potentials(&[0.0], 0));
    let with = |member: &str, value: &str| {
        let frame = object! { "ncp_version" => WIRE_VERSION, "kind" => "stimulus_frame", "session_id" => "a",
        "t" => crate::trace::num(0.0), "values" => values(300.0) };
        frame.with(member, value.into())
    };
    let mut cases = Vec::new();
    for (kind, word) in RUNNING {
        let request = |frame: Json| with_stimulus(kind, frame);
        let trace = vec![open(), (request(with("session_id", "a")), potentials(&[300.0], 0))];
        cases.push(
            reference(format!("stimulus/{kind}/whole"), &["NCP-WIRE-034", "NCP-SESS-054"], trace)
                .title(format!("A {word} with a stimulus frame that is written whole is carried out."))
                .flags(&["nested-stimulus"])
                .because("The stimulus frame is that of the request: of its kind, its version and its session."),
        );
        let fits_not = [
            ("sensor-frame", "NCP-WIRE-036", "kind", "sensor_frame"),
            ("no-kind", "NCP-WIRE-036", "kind", ""),
            ("other-session", "NCP-WIRE-037", "session_id", "b"),
        ];
        for (name, rule, member, value) in fits_not {
            let little = object! { member => value, "values" => values(300.0) };
            let is_plain = matches!(name, "sensor-frame" | "other-session");
            for (how, frame) in [("whole", with(member, value)), ("brief", little)] {
                let is_asked =
                    if kind == "run_request" { is_plain && how == "whole" } else { is_plain || how == "brief" };
                if !is_asked {
                    continue;
                }
                let trace = vec![open(), (request(frame), error()), at_rest()];
                cases.push(
                    reference(format!("stimulus/{kind}/{name}/{how}"), &[rule, "NCP-SESS-021"], trace)
                        .title(format!(
                            "A {word} whose stimulus frame has the `{member}` \u{ab}{value}\u{bb} is an error, and \
                             nothing comes of it ({how})."
                        ))
                        .flags(&["nested-stimulus"])
                        .because("A request is rejected whose stimulus frame has another kind or session than it."),
                );
            }
        }
    }
    let alone = vec![open(), (with("session_id", "a").text(), error()), at_rest()];
    cases.push(
        reference("stimulus/alone".to_owned(), &["NCP-SESS-022"], alone)
            .title("A stimulus frame that comes by itself is no request: an error, and it drives nothing.")
            .because("A server answers a frame whose kind is not a request with an error frame."),
    );
    cases
}

/// The `t` of stimulus frames, which orders nothing here.
fn times_of_stimuli() -> Vec<Case> {
    let timed = |member: &str, t: f64, current: f64| {
        let time = if member == "t" { crate::trace::num(t) } else { Json::literal(format!("{t:.0}")) };
        object! { member => time, "values" => values(current) }
    };
    // What is said with each of three values, and of what.
    let table: [(&str, &str, [f64; 3]); 3] = [
        ("falling", "t", [5.0, 1.0, 0.5]),
        ("far-first", "t", [1e9, 0.0, 1e9]),
        ("seq-falling", "seq", [5.0, 5.0, 1.0]),
    ];
    let currents = [300.0, 0.0, -100.0];
    let mut cases = Vec::new();
    for (name, member, said) in table {
        for (kind, word) in RUNNING {
            if kind == "run_request" && name != "falling" {
                continue;
            }
            let mut trace = vec![(driven().text(), opened("a"))];
            for (nth, (t, current)) in said.into_iter().zip(currents).enumerate() {
                trace.push((with_stimulus(kind, timed(member, t, current)), potentials(&currents[..=nth], nth)));
            }
            cases.push(
                reference(format!("stimulus-time/{name}/{kind}"), &["NCP-SESS-054", "NCP-SESS-036"], trace)
                    .title(format!(
                        "Stimulus frames act each with its {word}, whatever their `{member}` ({}).",
                        name.replace('-', " ")
                    ))
                    .because(
                        "The control plane is ordered by its requests: a stimulus frame acts with its request, \
                         whatever its `t`.",
                    ),
            );
        }
    }
    cases
}

/// Values that say the unit of their port.
fn units_of_values() -> Vec<Case> {
    let value = object! { "data" => nums(&[300.0]), "unit" => "pA" };
    let request = with_stimulus("step_request", object! { "values" => object! { "in" => value } });
    let trace = vec![
        (driven().text(), opened("a")),
        (request, potentials(&[300.0], 0)),
        (step("a", Some(1.0), None), potentials(&[300.0; 2], 1)),
    ];
    vec![
        reference("unit/current".to_owned(), &["NCP-SESS-054"], trace)
            .title("A current that says its unit, `pA`, acts as one that does not.")
            .because("A value of a port of `current_pA` is a direct current in pA, whether it says so or not."),
    ]
}

/// Names that stand in a frame as escapes, or that are easily taken for something else.
fn odd_names() -> Vec<Case> {
    const WHY: &str = "An encoder writes a frame that a receiver reads as the message, whatever its names are.";
    let names = ["t\t", "n\n", "one\u{1}", "\u{1f}", "q\"", "b\\", "del\u{7f}", "\u{2028}", "\u{e000}", "\u{1f680}"];
    let after = super::numbers::simulate(&[], 1.0, 1, 300.0).1;
    let mut cases = Vec::new();
    let mut add = |title: &str, case: Case| {
        cases.push(
            case.title(title).because(WHY).flags(&["session-lifecycle"]).by("/replies/1/records", "NCP-SESS-038"),
        );
    };
    let open = Open {
        records: names.iter().map(|name| record(name, "V_m", 1.0)).collect(),
        stimuli: vec![stimulus("i\t", "current_pA")],
        ..Open::lif("a")
    };
    let v = || object! { "times" => nums(&[1.0]), "values" => nums(&after) };
    let records = exactly(Json::Object(names.iter().map(|name| ((*name).to_owned(), v())).collect()));
    let trace = vec![(open.text(), opened("a")), (step("a", Some(1.0), Some(("i\t", 300.0))), recorded("a", records))];
    add(
        "Ports whose names have control characters, quotation marks or rare letters come back under their names.",
        reference("names/ports".to_owned(), &["NCP-WIRE-093", "NCP-SESS-038"], trace),
    );
    let sizes = Json::Object(names.iter().map(|name| ((*name).to_owned(), 1_u32.into())).collect());
    let open = Open { records: vec![record("v", "V_m", 1.0).with("target", names[2].into())], ..Open::lif("a") };
    let text = open.json().edit(&["network", "population_sizes"], |_| sizes).text();
    let records = object! { "v" => object! { "target" => names[2], "times" => nums(&[1.0]) } };
    let trace = vec![(text, opened("a")), (step("a", Some(1.0), None), recorded("a", records))];
    add(
        "Populations whose names have control characters, quotation marks or rare letters are opened and recorded.",
        about_all(reference("names/populations".to_owned(), &["NCP-WIRE-093", "NCP-SESS-050"], trace), &[]),
    );
    cases
}
