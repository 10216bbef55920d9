//! What a server answers from `open_session` to `close_session`.

use ncp_text::WIRE_VERSION;

use super::numbers::simulate;
use super::{
    Open, case, close, closed, error, id_of, not_closed, not_opened, observation, observed, opened, record, run,
    step as step_of, stimulus, without_session,
};
use crate::case::{Case, File};
use crate::json::{Json, object};
use crate::model::explicit;
use crate::patch::written;
use crate::roles::a;
use crate::scenario::{Row, ScenarioError, Scenarios, Step, beside, source};
use crate::template::Text;
use crate::trace::{any, anything, exactly, int, name_of, nums, some_text, text_of};
use crate::version::{self, MALFORMED};

pub(super) fn file() -> Result<File, ScenarioError> {
    let mut text = Scenarios::read(source!("session/life"))?;
    let mut cases = Vec::new();
    for group in
        ["life", "durations", "announced", "zero", "hash", "opened-anew", "opened-anew-chunk", "alike", "alike-steps"]
    {
        cases.extend(text.cases(group, row_case)?);
    }
    cases.extend(alike_but_for_space());
    cases.extend(open_questions());
    cases.extend(refused());
    cases.push(refused_often());
    cases.push(refused_alike());
    cases.push(unnamed());
    cases.extend(refused_anew());
    cases.push(opened_equally());
    cases.push(opened_over_and_over());
    cases.extend(refused_beside());
    cases.extend(text.rest(malformed)?);
    cases.extend(versions()?);
    cases.extend(misfits());
    cases.extend(versions_beside());
    cases.extend(long_requests());
    cases.extend(behind_long_members());
    cases.extend(stated_hashes());
    cases.extend(requests_beyond());
    cases.extend(times());
    cases.extend(malformed_times());
    cases.push(refused_requests());
    cases.extend(super::failures::cases());
    cases.extend(endless());
    cases.extend(crowds());
    cases.extend(abandoned());
    cases.extend(super::endures::cases());
    let about = "A server's sessions: opened, stepped, closed, kept apart, and every request answered once.";
    Ok(File::new("session", "life", about, cases))
}

/// A case of the requests of a row and what they are answered.
fn row_case(row: &Row) -> Result<Case, ScenarioError> {
    let steps = row.steps();
    let trace = steps.iter().map(exchange).collect::<Result<_, _>>()?;
    let case = described(case(row.path.clone(), &row.rules, trace), row);
    // To close what is not open is refused, whatever else the case is about.
    let refused =
        steps.iter().enumerate().filter(|(_, step)| step.verb() == "close" && step.words().last() == Some("refused"));
    Ok(refused.fold(case, |case, (nth, _)| case.by(format!("/replies/{nth}"), "NCP-SESS-029")))
}

fn described(case: Case, row: &Row) -> Case {
    case.title(&row.title).flags(&row.flags).because(&row.why)
}

/// A step, as `life.txt` says how they are written.
fn exchange(step: &Step) -> Result<(String, Json), ScenarioError> {
    let place = step.place;
    let words: Vec<&str> = step.words().collect();
    let at = words.iter().position(|word| *word == "=").unwrap_or(words.len());
    let (asked, answered) = words.split_at(at);
    let id = asked.first().copied().ok_or_else(|| place.wants("request", step.verb()))?;
    let time = asked.get(1).map(|time| place.double(time));
    let request = match step.verb() {
        "open" => {
            let mut open = Open::lif(id);
            let mut members = Vec::new();
            let mut sim = Vec::new();
            for word in asked {
                match word.split_once('=') {
                    Some(("chunk", chunk)) => open.chunk = place.double(chunk)?,
                    Some((name @ ("contract_hash" | "ncp_version" | "network"), value)) => {
                        members.push((name, Json::read(value)));
                    }
                    // Members of its `sim`, with bars between.
                    Some(("sim", of_sim)) => {
                        let of_sim = of_sim.split('|').filter_map(|member| member.split_once('='));
                        sim.extend(of_sim.map(|(name, value)| (name, Json::read(value))));
                    }
                    _ => {}
                }
            }
            let with = |open: Json, (name, value)| open.edit(&["sim"], |sim: Json| sim.with(name, value));
            let open = sim.into_iter().fold(open.json(), with);
            members.into_iter().fold(open, |open, (name, value)| open.with(name, value)).text()
        }
        "step" => step_of(id, time.transpose()?, None),
        "run" => run(id, time.ok_or_else(|| place.wants("time", ""))??),
        "close" => close(id),
        verb => return Err(place.wants("request", verb)),
    };
    let answer = match (answered.get(1), step.verb()) {
        (None, _) => opened(id),
        (Some(word), verb) => {
            any(word.split('|').map(|word| answer(step, id, verb, word)).collect::<Result<_, _>>()?)
        }
    };
    Ok((request, answer))
}

fn answer(step: &Step, id: &str, verb: &str, word: &str) -> Result<Json, ScenarioError> {
    // What is said of the numbers is pinned, if anything is said.
    let provenance = |absent: Option<Json>| {
        let pins = object! { "calibrated_posterior" => false, "is_simulation_output" => true };
        let provenance = any(absent.into_iter().chain([pins]).collect());
        text_of(object! { "kind" => "session_opened", "ok" => true, "provenance" => provenance })
    };
    Ok(match word {
        "any" => anything(),
        "error" => error(),
        "observation" => observation(id),
        "closed" => closed(id),
        "provenance" => provenance(None),
        "provenance-or-none" => provenance(Some(Json::Null)),
        "refused" if verb == "close" => not_closed(id),
        "refused" => not_opened(id),
        time => observed(id, step.place.double(time)?),
    })
}

pub(super) fn open(id: &str) -> (String, Json) {
    (Open::lif(id).text(), opened(id))
}

/// A request to open a session of some network.
pub(super) fn opening(id: &str, network: Json) -> String {
    object! { "ncp_version" => WIRE_VERSION, "kind" => "open_session", "session_id" => id, "network" => network }.text()
}

pub(super) fn steps(id: &str, time: f64) -> (String, Json) {
    (step_of(id, None, None), observed(id, time))
}

/// Ids with white space of Unicode about them, which scenario text has no words for.
fn alike_but_for_space() -> Vec<Case> {
    [("ideographic-space", '\u{3000}'), ("no-break-space", '\u{a0}'), ("line-separator", '\u{2028}')]
        .into_iter()
        .flat_map(|(name, space)| {
            [("before", format!("{space}a")), ("behind", format!("a{space}"))].map(|(place, other)| {
                let trace = vec![open("a"), (close(&other), anything()), steps("a", 10.0)];
                case(format!("alike/close-no-other/{name}-{place}"), &["NCP-SESS-035"], trace)
                    .title(format!(
                        "To close a session that is not open leaves a session open whose id has no {} {place} it.",
                        name.replace('-', " ")
                    ))
                    .flags(&["session-lifecycle"])
                    .because("A server keeps sessions apart, and the id of a session is its letters.")
            })
        })
        .collect()
}

/// The seq of the observation frames, and what is the server's affair.
fn open_questions() -> Vec<Case> {
    let mut cases = Vec::new();
    let counted =
        |seq: i64| (step_of("a", None, None), text_of(object! { "kind" => "observation_frame", "seq" => int(seq) }));
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
            (step_of(id, None, None), text_of(object! { "kind" => "observation_frame", "seq" => int(seq) }))
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
            (step_of("a", Some(5.0), Some(("no-such-port", 1.0))), reply),
            (step_of("a", Some(5.0), None), observed("a", time)),
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
            .because(
                "A server should answer an `open_session` for a session that is already open with `ok` false, \
                      and leave the session as it is.",
            ),
    );
    cases
}

/// Networks that hardly anybody has; that they are refused, the text does not say.
fn refused() -> Vec<Case> {
    let network = |kind: &str, reference: &str| opening("a", object! { "kind" => kind, "ref" => reference });
    [("builtin", "ncp.no.such.network"), ("handle", "no-such-handle"), ("builtin", "")]
        .into_iter()
        .enumerate()
        .map(|(nth, (kind, reference))| {
            let refusal = any(vec![not_opened("a"), error()]);
            let trace = vec![
                (network(kind, reference), refusal),
                (step_of("a", None, None), error()),
                (close("a"), not_closed("a")),
            ];
            let refuses = super::replies(trace.iter().map(|(_, reply)| reply.clone()).collect());
            let opens = super::replies(vec![opened("a"), observation("a"), closed("a")]);
            case(format!("refused/{nth}"), &["NCP-SESS-024", "NCP-SESS-026"], trace)
                .shows(any(vec![refuses, opens]))
                .by("/replies/2", "NCP-SESS-029")
                .title(format!(
                    "A session of an unusual network ({kind} `{reference}`) is open only if the server \
                                said so."
                ))
                .because(
                    "A server does not open a session that it answered with `ok` false, and answers a step for \
                          it with an error frame.",
                )
        })
        .collect()
}

/// An opening behind many that were refused: what is refused takes no room.
fn refused_often() -> Case {
    const MANY: usize = 1_000;
    // For its version: whether a server refuses a network is its own affair.
    let network = object! { "kind" => "builtin", "ref" => "ncp.reference.lif" };
    let request = opening("b", network).replacen(WIRE_VERSION, "9000.1", 1);
    let mut trace: Vec<(String, Json)> =
        std::iter::repeat_n((request, any(vec![not_opened("b"), error()])), MANY).collect();
    trace.extend([open("a"), steps("a", 10.0), (close("a"), closed("a"))]);
    super::reference("refused/often".to_owned(), &["NCP-SESS-050"], trace)
        .by("/replies/0", "NCP-SESS-023")
        .title(format!("A session is opened behind {MANY} openings that were refused."))
        .flags(&["session-lifecycle"])
        .because("An opening that is refused takes nothing of what a server bears.")
}

/// Openings of a version that fits no server, of which the last is refused like the first.
fn refused_alike() -> Case {
    const MANY: usize = 1_100;
    let request = Open::lif("b").json().with("ncp_version", beside(-1).into()).text();
    let trace = std::iter::repeat_n((request, not_opened("b")), MANY).collect();
    case("version/often".to_owned(), &["NCP-SESS-023"], trace)
        .title(format!("Each of {MANY} openings of an older version is refused by a `session_opened`."))
        .flags(&["lenient-versions"])
        .because("A server answers each such `open_session` with a `session_opened` in which `ok` is false.")
}

/// A request whose session is none that a server could name: the error frame names it as it stands there, or nothing.
fn unnamed() -> Case {
    let long = "s".repeat(300);
    let names = |id: Json| text_of(object! { "kind" => "error", "session_id" => id });
    let nothing = text_of(exactly(object! { "kind" => "error", "error" => some_text() }));
    let answer = any(vec![names(Json::Null), names("".into()), names(long.as_str().into()), nothing]);
    let request = object! { "kind" => "step_request", "session_id" => long.as_str() };
    case("malformed/session-too-long".to_owned(), &["NCP-SESS-021", "NCP-WIRE-045"], vec![(request.text(), answer)])
        .by("/replies/0", "NCP-WIRE-045")
        .rests_on("session/life/malformed/session-invalid")
        .title("The error frame for a session id of 300 bytes has no name of the server's own for it.")
        .because("A sender writes no placeholder of its own for a value that it does not know.")
}

/// An `open_session` of an open id that a server refuses for its network ends nothing.
fn refused_anew() -> Vec<Case> {
    [
        ("unknown-network", object! { "kind" => "builtin", "ref" => "ncp.no.such.network" }),
        ("unknown-handle", object! { "kind" => "handle", "ref" => "no-such-handle" }),
        ("no-name", object! { "kind" => "builtin", "ref" => "" }),
        ("odd-kind", object! { "kind" => "no-such-kind", "ref" => "ncp.reference.lif" }),
    ]
    .into_iter()
    .map(|(name, network)| {
        let trace = |second: Json, third: Json, fourth: Json| {
            vec![
                open("a"),
                steps("a", 10.0),
                (opening("a", network.clone()), second),
                (step_of("a", None, None), third),
                (close("a"), fourth),
            ]
        };
        let refused = || trace(any(vec![not_opened("a"), error()]), observed("a", 20.0), closed("a"));
        let answers = |trace: Vec<(String, Json)>| super::replies(trace.into_iter().map(|(_, reply)| reply).collect());
        let opens = answers(trace(opened("a"), anything(), anything()));
        // A server that lacks the first network refuses both.
        let neither = refused().into_iter().map(|(request, _)| without_session(&request).unwrap_or_else(anything));
        let neither = super::replies(neither.collect());
        case(format!("opened-anew/{name}"), &["NCP-SESS-027", "NCP-SESS-033"], refused())
            .shows(any(vec![answers(refused()), opens, neither]))
            .flags(&["session-lifecycle"])
            .title(format!(
                "An `open_session` of another network ({}) for a session that is open leaves it as it is where it is \
                 refused.",
                name.replace('-', " ")
            ))
            .because("An `open_session` that is refused ends no session.")
    })
    .collect()
}

/// An `open_session` of an open id that is refused: nothing of what it says comes to the session that is open.
fn refused_beside() -> Vec<Case> {
    let driven = || Open {
        params: vec![("I_e", 300.0)],
        records: vec![record("v", "V_m", 5.0)],
        stimuli: vec![stimulus("in", "current_pA")],
        chunk: 5.0,
        ..Open::lif("a")
    };
    let table = [
        ("chunk", "chunk", "NCP-SESS-031", Open { chunk: 2.0, ..driven() }),
        ("records", "ports to record", "NCP-SESS-038", Open { records: vec![record("w", "V_m", 2.0)], ..driven() }),
        ("stimuli", "ports to drive", "NCP-SESS-054", Open { stimuli: vec![stimulus("x", "current_pA")], ..driven() }),
        ("step", "length of a step", "NCP-SESS-058", Open { dt: 0.5, ..driven() }),
        ("params", "current", "NCP-SESS-050", Open { params: vec![("I_e", 100.0)], ..driven() }),
    ];
    let (_, potentials, _) = simulate(&[], 1.0, 10, 350.0);
    let mut cases = Vec::new();
    for (name, words, rule, other) in table {
        for (road, version) in [("own-version", WIRE_VERSION.to_owned()), ("older-version", beside(-1))] {
            if road == "older-version" && name != "records" {
                continue;
            }
            let steps = |value| {
                let advance = if name == "chunk" { None } else { Some(5.0) };
                step_of("a", advance, value)
            };
            let observed = |time: f64, at: usize| {
                let values = potentials.get(at - 1).copied().into_iter().collect::<Vec<_>>();
                let senders = std::iter::once(1_u32).collect::<Json>();
                let v = object! { "times" => nums(&[time]), "values" => nums(&values), "senders" => senders };
                observed("a", time).edit(&["$json"], |of| of.with("records", exactly(object! { "v" => v })))
            };
            let trace = |third: Json, fourth: Json| {
                vec![
                    (driven().text(), opened("a")),
                    (steps(Some(("in", 50.0))), observed(5.0, 5)),
                    (other.json().with("ncp_version", version.as_str().into()).text(), third),
                    (steps((name == "stimuli").then_some(("in", 50.0))), fourth),
                ]
            };
            let answers =
                |trace: Vec<(String, Json)>| super::replies(trace.into_iter().map(|(_, reply)| reply).collect());
            let refused = || trace(any(vec![not_opened("a"), error()]), observed(10.0, 10));
            let opens = answers(trace(opened("a"), anything()));
            let rules = [rule, "NCP-SESS-027"];
            let case = super::reference(format!("opened-anew/{road}/other-{name}"), &rules, refused());
            let mut case = case.shows(any(vec![answers(refused()), opens]));
            case.by.retain(|place, _| place == "/replies/0");
            cases.push(
                case.title(format!(
                    "An `open_session` of another {words} that is refused for a session that is open leaves it as it \
                     is ({}).",
                    road.replace('-', " ")
                ))
                .flags(&["session-lifecycle"])
                .because("An `open_session` that is refused ends no session, and changes none."),
            );
        }
    }
    cases
}

/// Requests of just so many bytes as a frame may have: what refuses them may not quote them whole.
fn long_requests() -> Vec<Case> {
    const FRAME: usize = 1 << 20;
    const CONTROL: &str = "\u{85}";
    let frame = |kind: &str| object! { "ncp_version" => WIRE_VERSION, "kind" => kind, "session_id" => "a" };
    let network = |reference: &str| frame("open_session").with("network", object! { "ref" => reference });
    let stimulus = |name: &str, value: Json| {
        let stimulus = object! { "values" => Json::Object(vec![(name.to_owned(), value)]) };
        frame("step_request").with("advance_ms", crate::trace::num(5.0)).with("stimulus", stimulus)
    };
    let port = stimulus("~", object! { "data" => nums(&[1.0]) });
    let opening = || text_of(object! { "kind" => "session_opened" });
    let version = || network("ncp.reference.lif").with("ncp_version", "~".into());
    // A frame with a tilde where the long text stands, and of what that is.
    let table: [(&str, &str, Json, &str, Json, &'static str); 17] = [
        ("kind", "kind", frame("~"), "x", error(), "NCP-SESS-022"),
        ("kind-of-escapes", "kind", frame("~"), "\\u0001", error(), "NCP-SESS-022"),
        ("session", "session", frame("step_request").with("session_id", "~".into()), "x", error(), "NCP-SESS-026"),
        ("network", "network", network("~"), "x", any(vec![opening(), error()]), "NCP-SESS-021"),
        ("version", "version", version(), "x", any(vec![not_opened("a"), error()]), "NCP-SESS-023"),
        ("port", "port", port.clone(), "x", any(vec![observation("a"), error()]), "NCP-SESS-037"),
        // In the shortest of frames, so that whoever says more than where it stands has no room for it.
        ("kind-alone", "kind", object! { "kind" => "~" }, "x", error(), "NCP-SESS-022"),
        (
            "name-alone",
            "name",
            Json::read(r#"{"kind":"step_request","stimulus":{"values":{"~":5}},"session_id":"a"}"#),
            "x",
            error(),
            "NCP-SESS-021",
        ),
        // Of two bytes, and written as an escape by who shows it, or writes ASCII alone: of five or six.
        ("kind-of-controls", "kind", frame("~"), CONTROL, error(), "NCP-SESS-022"),
        ("network-of-controls", "network", network("~"), CONTROL, any(vec![opening(), error()]), "NCP-SESS-021"),
        ("version-of-controls", "version", version(), CONTROL, any(vec![not_opened("a"), error()]), "NCP-SESS-023"),
        ("port-of-controls", "port", port, CONTROL, any(vec![observation("a"), error()]), "NCP-SESS-037"),
        ("name-of-controls", "name", stimulus("~", 5.into()), CONTROL, error(), "NCP-SESS-021"),
        // Who quotes so many bytes of it cuts a character in one of two.
        ("kind-of-three-bytes", "kind", frame("~"), "\u{20ac}", error(), "NCP-SESS-022"),
        ("kind-of-three-bytes-and-one", "kind", frame("x~"), "\u{20ac}", error(), "NCP-SESS-022"),
        ("name-of-three-bytes", "name", stimulus("~", 5.into()), "\u{20ac}", error(), "NCP-SESS-021"),
        ("name-of-three-bytes-and-one", "name", stimulus("x~", 5.into()), "\u{20ac}", error(), "NCP-SESS-021"),
    ];
    let mut cases = Vec::new();
    for (name, words, frame, of, reply, rule) in table {
        let frame = frame.text();
        let (before, behind) = frame.split_once('~').unwrap_or((&frame, ""));
        let times = (FRAME - before.len() - behind.len()) / of.len();
        let padding = FRAME - before.len() - behind.len() - times * of.len();
        let behind = format!("{behind}{}", " ".repeat(padding));
        let long = Text::concat([before.into(), Text::repeat(of, times), behind.into()]);
        // A network that is opened after all would keep its session open.
        let id = if words == "network" { "b" } else { "a" };
        let goes_on = |time: f64| (step_of(id, Some(5.0), None), observed(id, time));
        let trace = match words {
            "port" => vec![open(id), goes_on(5.0), (frame.clone(), reply), (step_of(id, None, None), observation(id))],
            _ => vec![(frame.clone(), reply), open(id), goes_on(5.0)],
        };
        let args = with_long(&trace, &frame, &long);
        cases.push(
            case(format!("long/{name}"), &["NCP-SESS-020", rule], trace)
                .call("session.run", args)
                .title(format!(
                    "A request of 1 MiB with a long {words} is answered with one reply, and the server goes on ({}).",
                    name.replace('-', " ")
                ))
                .flags(&["unanswered-requests"])
                .because("A server answers every request with exactly one reply, whatever its bytes."),
        );
    }
    cases
}

/// The requests of a trace, with a template in the place of one.
fn with_long(trace: &[(String, Json)], short: &str, long: &Text) -> Json {
    let requests =
        trace.iter().map(|(request, _)| if request == short { long.json() } else { request.as_str().into() });
    object! { "requests" => requests.collect::<Json>() }
}

/// Requests of which all that is known stands behind an ignored member as long as a head, a buffer or a frame.
fn behind_long_members() -> Vec<Case> {
    const SIZES: [(&str, usize); 3] = [("5000", 5_000), ("70000", 70_000), ("1-mib", 1 << 20)];
    let mut cases = Vec::new();
    for (size, bytes) in SIZES {
        // Opened once by a plain request, so that a server that offers the network is told from one that does not.
        let end = || (close("a"), closed("a"));
        let opened_late = Open { chunk: 5.0, ..Open::lif("a") }.text();
        let trace = vec![open("a"), end(), (opened_late.clone(), opened("a")), steps("a", 5.0)];
        let life = vec![open("a"), steps("a", 10.0), (run("a", 10.0), observed("a", 20.0)), end()];
        let table = [
            ("open_session", opened_late, &trace),
            ("step_request", life[1].0.clone(), &life),
            ("run_request", life[2].0.clone(), &life),
            ("close_session", life[3].0.clone(), &life),
        ];
        for (kind, short, trace) in table {
            let known = short.trim_start_matches('{');
            let before = r#"{"pad":""#;
            let behind = format!(r#"",{known}"#);
            let pad = Text::repeat("x", bytes - before.len() - behind.len());
            let long = Text::concat([before.into(), pad, behind.into()]);
            let args = with_long(trace, &short, &long);
            cases.push(
                case(format!("behind/{kind}/{size}"), &["NCP-WIRE-034", "NCP-SESS-027"], trace.to_vec())
                    .call("session.run", args)
                    .title(format!(
                        "The fields of {} are read behind an ignored member, in a frame of {bytes} bytes.",
                        a(kind).to_lowercase()
                    ))
                    .because("The members of an object stand in any order, and an unknown one is ignored."),
            );
        }
    }
    cases
}

/// What a server says of its contract hash does not depend on what the client says of its own.
fn stated_hashes() -> [Case; 3] {
    let own = ncp_text::CONTRACT_HASH;
    [("capitals", own.to_uppercase()), ("other", "0123456789abcdef".to_owned()), ("own", own.to_owned())].map(
        |(name, theirs)| {
            let request = Open::lif("a").json().with("contract_hash", theirs.as_str().into()).text();
            let stated = any(vec![own.into(), Json::Null]);
            let reply = opened("a").edit(&["$json"], |reply| reply.with("contract_hash", stated));
            let trace = vec![open("b"), (close("b"), closed("b")), (request, reply)];
            case(format!("stated-hash/{name}"), &["NCP-SESS-025", "NCP-VER-020"], trace)
                .by("/replies/2/contract_hash", "NCP-VER-020")
                .title(format!("A server states its own contract hash, or none, to a client of {theirs}."))
                .flags(&["over-strict"])
                .because("A peer states the contract hash of its schema, in the letters of the text.")
        },
    )
}

/// Requests of more bytes than a frame may have, in one of fewer characters: they close nothing.
fn requests_beyond() -> [Case; 2] {
    let frame = object! { "ncp_version" => WIRE_VERSION, "kind" => "close_session", "session_id" => "a", "pad" => "~" };
    let frame = frame.text();
    let (before, behind) = frame.split_once('~').unwrap_or((&frame, ""));
    [("letters", "x", 1 << 20), ("characters-of-three-bytes", "\u{20ac}", 500_000)].map(|(name, letter, times)| {
        let long = Text::concat([before.into(), Text::repeat(letter, times), behind.into()]);
        let trace = vec![open("a"), steps("a", 10.0), (frame.clone(), error()), steps("a", 20.0)];
        let args = with_long(&trace, &frame, &long);
        case(format!("beyond/{name}"), &["NCP-WIRE-060", "NCP-SESS-021"], trace)
            .call("session.run", args)
            .title(format!("A `close_session` with {times} {} closes nothing.", name.replace('-', " ")))
            .flags(&["missing-limits"])
            .because("A frame of more than 1 MiB is rejected, and a limit counts bytes.")
    })
}

/// Bytes that are no request, before and after the session is opened.
fn malformed(row: &Row) -> Result<Case, ScenarioError> {
    let request = written(&row.text("request")?);
    let trace = vec![(request.clone(), error()), open("a"), (request, error()), steps("a", 10.0)];
    Ok(described(case(row.path.clone(), &row.rules, trace), row))
}

/// The pattern of a refusal that has a reason.
fn saying_why(refusal: Json) -> Json {
    refusal.edit(&["$json"], |refusal| refusal.with("error", some_text()))
}

fn versions() -> Result<Vec<Case>, ScenarioError> {
    let mut cases = Vec::new();
    let own = WIRE_VERSION;
    let well_formed = [beside(-1), beside(1), "1.0".into(), "0".into(), "5.0".into(), format!("{own}0")];
    let others = ["", "latest", &format!("{own}.0"), &format!("v{own}"), &format!("{own} "), &format!("+{own}"), "0.x"];
    let further = version::malformed(&MALFORMED[..2])?;
    let further = further.iter().filter_map(|(_, version)| version.as_str());
    for (nth, version) in well_formed.iter().map(String::as_str).chain(others).chain(further).enumerate() {
        // One that is no version at all, a server may take for a frame that is broken.
        let well_formed = nth < well_formed.len();
        let refusal = || match well_formed {
            true => not_opened("a"),
            false => any(vec![not_opened("a"), error()]),
        };
        let request = Open::lif("a").json().with("ncp_version", version.into()).text();
        let said = if well_formed { saying_why(not_opened("a")) } else { refusal() };
        cases.push(
            case(format!("version/{nth:02}"), &["NCP-SESS-023"], vec![(request.clone(), said)])
                .title(format!("An `open_session` of the version \u{ab}{}\u{bb} is refused.", version.escape_debug()))
                .flags(&["lenient-versions"])
                .because(if well_formed {
                    "A server answers an `open_session` of an incompatible `ncp_version` with a `session_opened` in \
                     which `ok` is false and `error` says why."
                } else {
                    "A server answers an `open_session` of a malformed `ncp_version` with a `session_opened` in \
                     which `ok` is false, or with an error frame."
                }),
        );
        if ![0, 2, 7].contains(&nth) {
            continue;
        }
        // A server that opens the session after all breaks another rule.
        let trace = vec![(request, refusal()), (step_of("a", None, None), error()), (close("a"), not_closed("a"))];
        let refuses = super::replies(trace.iter().map(|(_, reply)| reply.clone()).collect());
        let opens = super::replies(vec![opened("a"), anything(), anything()]);
        cases.push(
            case(format!("version/{nth:02}/leaves-nothing"), &["NCP-SESS-024"], trace)
                .shows(any(vec![refuses, opens]))
                .title(format!(
                    "An `open_session` of the version \u{ab}{version}\u{bb} that is refused leaves no session."
                ))
                .by("/replies/2", "NCP-SESS-029")
                .flags(&["lenient-versions"])
                .because("A server does not open a session that it answered with `ok` false."),
        );
    }
    Ok(cases)
}

/// Times that are no JSON numbers though many a reader takes them for numbers, in the requests of an open session.
fn malformed_times() -> Vec<Case> {
    let spelled = ["05", "+5", "5.", ".5", "5e", "0x5", "5_0", "-.5", "1e+", "Infinity", "NaN", "\u{ff15}"];
    let mut cases = Vec::new();
    for (kind, member) in [("step_request", "advance_ms"), ("run_request", "duration_ms")] {
        let whole = explicit(kind).with("session_id", "a".into()).with(member, Json::literal("7654.0"));
        for (nth, time) in spelled.into_iter().enumerate() {
            // Every other one with all members, as most clients write a request.
            let whole = if nth % 2 == 0 { whole.clone().and("stimulus", Json::Null) } else { whole.clone() };
            let request = whole.text().replacen("7654.0", time, 1);
            cases.push(
                case(
                    format!("time/{}/malformed/{nth:02}", kind.trim_end_matches("_request")),
                    &["NCP-WIRE-002", "NCP-SESS-021"],
                    vec![open("a"), steps("a", 10.0), (request, error()), steps("a", 20.0)],
                )
                .title(format!("A `{kind}` whose `{member}` is spelled {time} is an error, and time stands still."))
                .flags(&["session-lifecycle"])
                .because("A frame that is no JSON is answered with an error frame, whatever it would have said."),
            );
        }
    }
    cases
}

/// A step whose stimulus frame is of another session, though of one that looks the same or nearly so.
fn misfits() -> [Case; 2] {
    [("other-form", "caf\u{e9}", "cafe\u{301}"), ("other-case", "uav\u{e9}", "uav\u{c9}")].map(|(name, id, other)| {
        let stimulus = object! { "session_id" => other };
        let request = Json::read(&step_of(id, None, None)).with("stimulus", stimulus).text();
        case(
            format!("misfit/{name}"),
            &["NCP-WIRE-037", "NCP-SESS-021"],
            vec![open(id), (request, error()), steps(id, 10.0)],
        )
        .title(format!(
            "A step whose stimulus frame has the request's session in another spelling ({}) is an error, and time \
             stands still.",
            name.replace('-', " ")
        ))
        .flags(&["nested-stimulus"])
        .because("A stimulus frame has the `session_id` of its request, code point by code point.")
    })
}

/// Openings of another version that a server has one more reason to refuse.
fn versions_beside() -> Vec<Case> {
    let network = |kind: &str, reference: &str| object! { "kind" => kind, "ref" => reference };
    let of = |version: &str, network: Option<Json>| {
        let open = Open::lif("a").json().with("ncp_version", version.into());
        network.into_iter().fold(open, |open, network| open.with("network", network)).text()
    };
    let table = [
        ("unknown-network", "of an unknown network", beside(-1), Some(network("builtin", "ncp.no.such.network"))),
        ("unknown-handle", "of an unknown handle", "1.0".to_owned(), Some(network("handle", "no-such-handle"))),
        ("open-already", "for a session that is open", beside(-1), None),
        ("closed-before", "of an id that was opened and closed before", beside(1), None),
    ];
    let case = |(name, words, version, network): (&str, &str, String, Option<Json>)| {
        let mut trace = Vec::new();
        trace.extend(network.is_none().then(|| open("a")));
        trace.extend((name == "closed-before").then(|| (close("a"), closed("a"))));
        trace.push((of(&version, network), not_opened("a")));
        case(format!("version/beside/{name}"), &["NCP-SESS-023"], trace)
            .title(format!("An `open_session` of the version {version} {words} is answered with a `session_opened`."))
            .flags(&["lenient-versions"])
            .because(
                "A server answers an `open_session` of an incompatible `ncp_version` with a `session_opened` in which \
                 `ok` is false, whatever else there is to refuse.",
            )
    };
    table.into_iter().map(case).collect()
}

/// Times that cannot be run.
fn times() -> Vec<Case> {
    let mut cases = Vec::new();
    for time in [-1.0, -0.001, -1e308, -5e-324] {
        for (name, request) in [("step", step_of("a", Some(time), None)), ("run", run("a", time))] {
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
    // The time of a request may be that of the session.
    for chunk in [-10.0, -0.001, -1e308] {
        let trace = vec![
            (Open { chunk, ..Open::lif("a") }.text(), opened("a")),
            (step_of("a", None, None), error()),
            // It says its own time, and does not run for the chunk.
            (step_of("a", Some(10.0), None), observed("a", 10.0)),
        ];
        cases.push(
            case(format!("time/chunk/{}", name_of(chunk)), &["NCP-SESS-032", "NCP-SESS-033"], trace)
                .title(format!("A step for a `chunk_ms` of {chunk} is an error, unless the session was refused."))
                .because(
                    "A server refuses a `chunk_ms` that is negative when the session is opened, or else each request \
                     that is to run for it.",
                ),
        );
    }
    for (name, literal) in [
        ("overflow", "1e999"),
        ("minus-overflow", "-1e999"),
        ("nan", "NaN"),
        ("infinity", "Infinity"),
        ("text", "\"10\""),
        ("boolean", "true"),
    ] {
        let request = object! { "ncp_version" => WIRE_VERSION, "kind" => "step_request", "session_id" => "a",
        "advance_ms" => Json::literal(literal) }
        .text();
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

/// Requests for no time, many of them, between such that are carried out: they close nothing.
fn refused_requests() -> Case {
    let mut trace = vec![open("a")];
    for nth in 1..=5 {
        let refused = || (step_of("a", Some(-1.0), None), error());
        trace.extend(std::iter::repeat_with(refused).take(28));
        trace.push(steps("a", 10.0 * f64::from(nth)));
    }
    super::reference("fails/refused-often".to_owned(), &["NCP-SESS-037"], trace)
        .title("A session goes on between 140 steps that are refused for their time.")
        .flags(&["session-lifecycle"])
        .because("However many of its requests fail, a session stays open.")
}

/// The same opening again: the session goes on, or begins anew, and nothing between the two.
fn opened_equally() -> Case {
    let trace = |again: Json, time: f64| {
        let five = |time| (step_of("a", Some(5.0), None), observed("a", time));
        vec![open("a"), five(5.0), (open("a").0, again), five(time), (close("a"), closed("a"))]
    };
    let replies = |trace: Vec<(String, Json)>| super::replies(trace.into_iter().map(|(_, reply)| reply).collect());
    let goes_on = trace(any(vec![not_opened("a"), error()]), 10.0);
    super::reference("opened-anew/equally".to_owned(), &["NCP-SESS-033"], goes_on.clone())
        .shows(any(vec![replies(goes_on), replies(trace(opened("a"), 5.0))]))
        .title(
            "A session that is opened again as it was, with `ok` true, begins anew, or goes on where that is refused.",
        )
        .flags(&["session-lifecycle"])
        .because("Where the opening is answered with `ok` true, the simulation time is that since then.")
}

/// Large openings of an id that is open, however a server answers them: when it is closed, none of them takes room.
fn opened_over_and_over() -> Case {
    const LARGEST: u32 = 100_000;
    const AGAIN: u32 = LARGEST / 10;
    let sized = |id: &str, size| Open { size, ..Open::lif(id) }.text();
    let mut trace = vec![open("a")];
    let either = any(vec![opened("a"), not_opened("a"), error()]);
    trace.extend(std::iter::repeat_n((sized("a", AGAIN), either), 9));
    trace.push((close("a"), closed("a")));
    trace.push((sized("b", LARGEST), opened("b")));
    super::reference("opened-anew/over-and-over".to_owned(), &["NCP-SESS-050"], trace)
        .title(format!(
            "A session of {LARGEST} neurons is opened behind nine openings of one that was open and is closed."
        ))
        .flags(&["session-lifecycle"])
        .because("An opening that is refused, or that ends the session before, takes nothing of what a server bears.")
}

/// A time that leaves the doubles.
fn endless() -> Vec<Case> {
    /// A time that is no step of such a session, and not 0 ms, which a server may refuse.
    const NONE: f64 = 1e-300;
    let mut cases = Vec::new();
    for (name, advances, then) in [
        ("at-once", &[1.0, 1.0][..], NONE),
        ("in-one-request", &[2.0][..], 1.0),
        ("after-some", &[1.0, NONE, 1.0, 1.0][..], NONE),
    ] {
        let open = Open { dt: 1e308, records: Vec::new(), ..Open::lif("a") };
        let mut trace = vec![(open.text(), opened("a"))];
        let mut time = 0.0;
        for advance in advances.iter().chain([&then]).map(|steps| steps * 1e308) {
            let reply = if f64::is_finite(time + advance) {
                time += advance;
                observed("a", time)
            } else {
                error()
            };
            // No text holds an infinity as a number; 1.7e308 ms are two steps of 1e308 ms.
            let advance = if advance.is_finite() { advance } else { 1.7e308 };
            trace.push((super::step("a", Some(advance), None), reply));
        }
        cases.push(
            super::reference(format!("fails/time/{name}"), &["NCP-SESS-057", "NCP-SESS-037"], trace)
                .title(format!("A step whose time leaves the doubles is an error, and costs nothing else ({name})."))
                .because(
                    "A request by which the time of a session leaves the doubles fails, and leaves the time as it was.",
                ),
        );
    }
    cases
}

/// A session that is left alone for long, while much is asked of others.
fn abandoned() -> Vec<Case> {
    const MANY: usize = 300;
    const WHY: &str = "What is done to one session changes no other; only a `close_session` ends one.";
    // There are many, so that each is as short as it may be.
    let steps = |id: &str| object! { "kind" => "step_request", "session_id" => id }.text();
    let repeated = |id: &str, reply: Json| std::iter::repeat_n((steps(id), reply), MANY);
    let of_another = std::iter::once((Open::lif("b").text(), anything()));
    let of_another = of_another.chain(repeated("b", anything())).collect();
    let failing = repeated("c", error()).collect();
    vec![
        goes_on("abandoned/steps-of-another", "a", of_another)
            .title(format!("A session goes on after {MANY} steps of another session."))
            .because(WHY),
        goes_on("abandoned/failing-steps", "a", failing)
            .title(format!("A session goes on after {MANY} steps of a session that is not open."))
            .because(WHY),
    ]
}

/// The first of many sessions. Whether the server has room for the others is its own affair; the first stays open.
fn crowds() -> Vec<Case> {
    // There are many, so that the number in their ids is one that a run writes once.
    let brief = |nth: usize| {
        let network = object! { "ref" => "ncp.reference.lif" };
        let id = format!("{{\"s\":{nth}}}");
        object! { "kind" => "open_session", "session_id" => id, "network" => network }.text()
    };
    let of = |others: usize| {
        let opened = (1..=others).map(|nth| (brief(nth), anything())).collect();
        goes_on(&format!("crowd/{others}-opened"), "s0", opened)
            .title(format!("A session goes on after {others} others were opened, or refused."))
            .because("A server keeps sessions apart: what is done to one, such as opening it, changes no other.")
    };
    [33, 130, 257, 520, 4_100].map(of).into()
}

/// A session that is stepped before and behind other requests, and closed; or was not opened by a server without such
/// networks.
fn goes_on(path: &str, id: &str, others: Vec<(String, Json)>) -> Case {
    let trace = [open(id), steps(id, 10.0)].into_iter().chain(others);
    let trace: Vec<(String, Json)> = trace.chain([steps(id, 20.0), (close(id), closed(id))]).collect();
    let without = trace.iter().map(|(request, reply)| match id_of(request) == id {
        true => without_session(request).unwrap_or_else(error),
        false => reply.clone(),
    });
    let without = super::replies(without.collect());
    let (requests, with): (Vec<String>, Vec<Json>) = trace.into_iter().unzip();
    super::asking(path.to_owned(), &["NCP-SESS-035", "NCP-SESS-027"], requests)
        .shows(any(vec![super::replies(with), without]))
}
