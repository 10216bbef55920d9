//! What a server answers from `open_session` to `close_session`.

use ncp_text::WIRE_VERSION;

use super::numbers::{driven_step, simulate};
use super::{
    Open, case, close, closed, error, id_of, not_closed, not_opened, observation, observed, opened, record, recorded,
    run, step as step_of, stimulus, without_session,
};
use crate::case::{Case, File};
use crate::json::{Json, object};
use crate::model::explicit;
use crate::patch::written;
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
    cases.extend(refused_anew());
    cases.push(opened_equally());
    cases.push(opened_over_and_over());
    cases.extend(refused_beside());
    cases.extend(text.rest(malformed)?);
    cases.extend(versions()?);
    cases.extend(misfits());
    cases.extend(versions_beside());
    cases.extend(long_requests());
    cases.extend(requests_beyond());
    cases.extend(times());
    cases.extend(failures());
    cases.push(failure_of_many_steps());
    cases.push(refused_requests());
    cases.extend(failures_of_one());
    cases.extend(failures_behind_no_step());
    cases.extend(malformed_times());
    cases.extend(failures_by_road());
    cases.push(failures_of_two());
    cases.extend(failures_beside_a_current());
    cases.extend(failures_without_number());
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

/// Numbers that leave the doubles within the simulator, so that no frame can hold what it gives.
fn failures() -> Vec<Case> {
    let driven = |open: Open, observable: &str, kind: &str| Open {
        records: vec![record("out", observable, 1.0)],
        stimuli: vec![stimulus("in", kind)],
        ..open
    };
    let rate = driven(Open { params: vec![("mu", 1.7e308)], ..Open::rate("a") }, "rate", "rate_inject");
    let membrane = driven(Open { params: vec![("C_m", 1.0)], ..Open::lif("a") }, "V_m", "current_pA");
    // Beyond the doubles in whatever order it is computed, and above every threshold.
    let spiking = driven(Open { params: vec![("C_m", 1e-3)], ..Open::lif("a") }, "V_m", "current_pA");
    // With the second input, either network stays where it began.
    let table = [
        ("rate", rate, 1.7e308, -1.7e308, 0.0),
        ("membrane", membrane, -1.7e308, 0.0, -70.0),
        ("spiking-membrane", spiking, 1.7e308, 0.0, -70.0),
    ];
    let mut cases = Vec::new();
    for (what, a, too_much, rest, state) in table {
        let open = || (a.text(), opened("a"));
        let by = |time: f64, value: f64| step_of("a", Some(time), Some(("in", value)));
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
            "A request that fails within the simulator costs that request only, and is answered with an error \
             frame; no frame can hold an infinity.",
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
        // So long that the samples of all of them are more than a server bears in one.
        let long = |steps: f64| (by(steps, too_much), error());
        let most = [300_000.0, 300_000.0, 300_000.0, 99_998.0].map(long);
        push(
            "/of-many-samples",
            &["NCP-SESS-037"],
            format!("After four long steps whose {what} leaves the doubles, the session goes on from where it was."),
            [open()].into_iter().chain(most).chain([(by(5.0, rest), after(0, 5))]).collect(),
            "A request that fails costs that request only: what it took is free again.",
        );
        let mut trace = vec![open()];
        for nth in 0..4 {
            trace.extend(std::iter::repeat_with(fails).take(6));
            trace.push((by(5.0, rest), after(5 * nth, 5 * nth + 5)));
        }
        push(
            "/often",
            &["NCP-SESS-037"],
            format!("After 24 steps whose {what} leaves the doubles, and others between them, the session goes on."),
            trace,
            "A request that fails costs that request only, however many of them do.",
        );
    }
    cases
}

/// A step that fails in its first step, of nearly as many as a server bears, and one behind it.
fn failure_of_many_steps() -> Case {
    let stimuli = vec![stimulus("in", "rate_inject")];
    let open = Open { params: vec![("mu", 1.7e308)], stimuli, records: Vec::new(), ..Open::rate("a") };
    let by = |time: f64, value: f64| step_of("a", Some(time), Some(("in", value)));
    let trace = vec![
        (open.text(), opened("a")),
        (by(19_999_990.0, 1.7e308), error()),
        (by(20.0, -1.7e308), observed("a", 20.0)),
    ];
    super::reference("fails/rate/of-many-steps".to_owned(), &["NCP-SESS-037"], trace)
        .title("After a step of 19,999,990 ms whose rate leaves the doubles, the session goes on.")
        .flags(&["session-lifecycle", "non-finite-numbers"])
        .because("A request that fails costs that request only: what it took is free again.")
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

/// Numbers of one of two populations that leave the doubles, at its first step or after some: the other is put back as
/// well, and so are another session and its time.
fn failures_of_one() -> Vec<Case> {
    let drive = |port: &str, kind: &str, target: &str| stimulus(port, kind).with("target", target.into());
    let kinds = [("rate", "rate", "rate_inject"), ("membrane", "V_m", "current_pA")];
    let mut cases = Vec::new();
    for (what, observable, kind) in kinds {
        for (failing, other) in [("pop", "other"), ("other", "pop")] {
            // Two inputs whose sum is none, in whatever order it is computed, and one to the population that is asked.
            let two = [drive("y", kind, failing), drive("z", kind, failing), drive("x", kind, other)];
            let network = |id: &str| if what == "rate" { Open::rate(id) } else { Open::lif(id) };
            let open = |id: &str| Open {
                other: Some(1),
                records: vec![record("out", observable, 1.0).with("target", other.into())],
                stimuli: two.to_vec(),
                ..network(id)
            };
            let by = |id: &str, time: f64, x: f64, much: f64| {
                let value = |value: f64| object! { "data" => nums(&[value]) };
                let values = object! { "x" => value(x), "y" => value(much), "z" => value(much) };
                let request = Json::read(&step_of(id, Some(time), None));
                request.with("stimulus", object! { "values" => values }).text()
            };
            // What the population that is asked does, of which no step of a request that failed is left.
            let mut runs = driven_from_rest(what);
            let before = recorded("a", runs(0, 3, 40.0));
            let after = recorded("a", runs(3, 5, 20.0));
            let trace = vec![
                (open("a").text(), opened("a")),
                (by("a", 3.0, 40.0, 1.0), before),
                (by("a", 4.0, 200.0, 1.7e308), error()),
                (by("a", 2.0, 20.0, 1.0), after),
            ];
            cases.push(
                super::reference(format!("fails/{what}-of-{failing}/other"), &["NCP-SESS-057", "NCP-SESS-037"], trace)
                    .title(format!(
                        "After a step in which the {what} of the population `{failing}` leaves the doubles, `{other}` \
                         goes on from where it was."
                    ))
                    .flags(&["session-lifecycle", "non-finite-numbers"])
                    .because("A request that fails leaves the network as it was before it, all of it."),
            );
        }
    }
    cases.extend(late_failures());
    cases
}

/// What a population that began at rest records at its port `out` over some steps of one input, step by step.
fn driven_from_rest(what: &str) -> impl FnMut(u32, u32, f64) -> Json {
    let is_rate = what == "rate";
    let mut state = if is_rate { 0.0 } else { -70.0 };
    let p = (-0.1_f64).exp();
    move |from, to, x| {
        let times: Vec<f64> = (from + 1..=to).map(f64::from).collect();
        let step = |_: &f64| {
            state = match is_rate {
                true => state * p + x * (1.0 - p),
                false => -70.0 + (state + 70.0) * p + x * 10.0 / 250.0 * (1.0 - p),
            };
            state
        };
        let values: Vec<f64> = times.iter().map(step).collect();
        object! { "out" => object! { "times" => nums(&times), "values" => nums(&values) } }
    }
}

/// A value that came with no step stays in force, also behind a request of another port that fails.
fn failures_behind_no_step() -> Vec<Case> {
    let kinds = [("rate", "rate", "rate_inject"), ("membrane", "V_m", "current_pA")];
    let mut cases = Vec::new();
    for (what, observable, kind) in kinds {
        for (name, nothing, words) in [("of-0-ms", 0.0, "of 0 ms"), ("of-no-step", 0.25, "of a quarter of a step")] {
            let drive = |port: &str, target: &str| stimulus(port, kind).with("target", target.into());
            let open = Open {
                other: Some(1),
                records: vec![record("out", observable, 1.0)],
                stimuli: vec![drive("x", "pop"), drive("y", "other"), drive("z", "other")],
                ..if what == "rate" { Open::rate("a") } else { Open::lif("a") }
            };
            let by = |time: f64, given: &[(&str, f64)]| {
                let value = |(port, value): &(&str, f64)| ((*port).to_owned(), object! { "data" => nums(&[*value]) });
                let values = Json::Object(given.iter().map(value).collect());
                let request = Json::read(&step_of("a", Some(time), None));
                request.with("stimulus", object! { "values" => values }).text()
            };
            let mut runs = driven_from_rest(what);
            // Two inputs of the other population whose sum is beyond the doubles, and then none.
            let trace = vec![
                (open.text(), opened("a")),
                (by(3.0, &[("x", 40.0)]), recorded("a", runs(0, 3, 40.0))),
                (by(nothing, &[("x", 20.0)]), text_of(object! { "kind" => "observation_frame" })),
                (by(4.0, &[("y", 1.7e308), ("z", 1.7e308)]), error()),
                (by(2.0, &[("y", 0.0), ("z", 0.0)]), recorded("a", runs(3, 5, 20.0))),
            ];
            cases.push(
                super::reference(
                    format!("fails/{what}/behind-a-value/{name}"),
                    &["NCP-SESS-054", "NCP-SESS-057"],
                    trace,
                )
                .title(format!(
                    "A value that came with a step {words} is in force behind one whose {what} leaves the doubles."
                ))
                .flags(&["session-lifecycle", "non-finite-numbers"])
                .because(
                    "A stimulus acts from the next step on until the next value of its port, and a request that \
                     fails costs that request only.",
                ),
            );
        }
    }
    cases
}

/// A membrane that leaves the doubles only at a later step of its request, beside a population that does not.
fn late_failures() -> Vec<Case> {
    [1, 2, 3].into_iter().flat_map(late_failures_sampled).collect()
}

/// The same, with a sample every so many steps.
fn late_failures_sampled(every: u32) -> Vec<Case> {
    // From E_L the potential falls by 1e308 mV times 1 - P^n, which is too much at the third step.
    let params = vec![("E_L", -1.6e308), ("C_m", 1.0), ("tau_m", 10.0), ("V_th", 0.0)];
    let drive = |port: &str, target: &str| stimulus(port, "current_pA").with("target", target.into());
    let open = |id: &str| Open {
        other: Some(1),
        params: params.clone(),
        records: vec![
            record("out", "V_m", f64::from(every)),
            record("out-too", "V_m", f64::from(every)).with("target", "other".into()),
        ],
        stimuli: vec![drive("x", "pop"), drive("y", "other")],
        ..Open::lif(id)
    };
    let by = |id: &str, time: f64, x: f64, y: f64| {
        let value = |value: f64| object! { "data" => nums(&[value]) };
        let request = Json::read(&step_of(id, Some(time), None));
        request.with("stimulus", object! { "values" => object! { "x" => value(x), "y" => value(y) } }).text()
    };
    let run = |id: &str, from: u32, steps: u32, x: f64, y: f64, state: &mut [f64; 2]| {
        let mut values = [Vec::new(), Vec::new()];
        let mut times = Vec::new();
        for step in from + 1..=from + steps {
            *state = [fallen(state[0], x), fallen(state[1], y)];
            if step % every == 0 {
                times.push(f64::from(step));
                values[0].push(state[0]);
                values[1].push(state[1]);
            }
        }
        let of = |values: &[f64]| object! { "times" => nums(&times), "values" => nums(values) };
        (by(id, f64::from(steps), x, y), recorded(id, object! { "out" => of(&values[0]), "out-too" => of(&values[1]) }))
    };
    // So much falls too far at the third step of a request; so little rises, and never far.
    let (much, little) = (-1e307, 2e306);
    let table: [(&str, &str, f64, f64); 3] = [
        ("first", "the first population", much, little),
        ("second", "the second population", little, much),
        ("both", "both populations", much, much),
    ];
    let mut cases = Vec::new();
    for (name, words, x, y) in table {
        let (mut a, mut b) = ([-1.6e308; 2], [-1.6e308; 2]);
        let mut trace = vec![(open("a").text(), opened("a")), (open("b").text(), opened("b"))];
        trace.push(run("a", 0, 2, little, little, &mut a));
        trace.push(run("b", 0, 1, little, little, &mut b));
        trace.push((by("a", 10.0, x, y), error()));
        trace.push(run("a", 2, if every == 1 { 2 } else { 5 }, little, 0.0, &mut a));
        trace.push(run("b", 1, 2, 0.0, little, &mut b));
        let (path, rules, sampled): (_, &[&'static str], _) = match every {
            1 => (format!("fails/later/{name}"), &["NCP-SESS-057", "NCP-SESS-035"], String::new()),
            _ => (
                format!("fails/later/{name}/every-{every}"),
                &["NCP-SESS-057", "NCP-SESS-053", "NCP-SESS-035"],
                format!(" (a sample every {every} steps)"),
            ),
        };
        cases.push(
            super::reference(path, rules, trace)
                .title(format!(
                    "After a step in which {words} of a session leaves the doubles some way on, neither population has \
                     moved, and no other session{sampled}."
                ))
                .flags(&["session-lifecycle", "non-finite-numbers"])
                .because("A request that fails leaves the network and the time of its session as they were before it."),
        );
    }
    cases
}

/// The potential after a step of 1 ms under a current, where it rests at -1.6e308 mV, of 1 pF and 10 ms.
fn fallen(v: f64, current: f64) -> f64 {
    let p = (-0.1_f64).exp();
    -1.6e308 + (v + 1.6e308) * p + current * 10.0 * (1.0 - p)
}

/// A membrane that leaves the doubles by each kind of request, and under a current that it has already as well.
fn failures_by_road() -> Vec<Case> {
    // So much falls too far at the third step.
    let (much, little) = (-1e307, -1e306);
    let open = |own: f64| Open {
        params: vec![
            ("E_L", -1.6e308),
            ("V_reset", -1.6e308),
            ("C_m", 1.0),
            ("tau_m", 10.0),
            ("V_th", 0.0),
            ("I_e", own),
        ],
        records: vec![record("v", "V_m", 1.0)],
        stimuli: vec![stimulus("in", "current_pA")],
        ..Open::lif("a")
    };
    let roads = [
        ("chunk", "a step of the session's chunk", step_of("a", None, None)),
        ("step", "a step", step_of("a", Some(10.0), None)),
        ("run", "a run", run("a", 10.0)),
    ];
    // The neuron's own current, and what the requests bring before, in and behind the one that fails.
    let table: [(&str, &str, f64, [Option<f64>; 3]); 3] = [
        ("own", "the neuron's own current", much, [None; 3]),
        ("kept", "a current that a request before brought", 0.0, [Some(much), None, Some(0.0)]),
        ("brought", "the current that it brings", 0.0, [Some(little), Some(much), Some(0.0)]),
    ];
    let mut cases = Vec::new();
    for (way, words, fails) in roads {
        for (how, by, own, [before, within, behind]) in table {
            // The cases of a later step have one that brings it.
            if matches!((way, how), ("step", "brought" | "kept") | ("run", "own" | "kept")) {
                continue;
            }
            let driven = |request: &str, value: Option<f64>| match value {
                Some(value) => {
                    let values = object! { "in" => object! { "data" => nums(&[value]) } };
                    Json::read(request).with("stimulus", object! { "values" => values }).text()
                }
                None => request.to_owned(),
            };
            let one = step_of("a", Some(1.0), None);
            let mut v = -1.6e308;
            let mut steps = |time: f64, value: Option<f64>| {
                v = fallen(v, value.unwrap_or(own));
                let samples = object! { "times" => nums(&[time]), "values" => nums(&[v]) };
                (driven(&one, value), recorded("a", object! { "v" => samples }))
            };
            let trace = vec![
                (open(own).text(), opened("a")),
                steps(1.0, before),
                (driven(&fails, within), error()),
                steps(2.0, behind),
            ];
            cases.push(
                super::reference(format!("fails/by-{way}/{how}"), &["NCP-SESS-057", "NCP-SESS-037"], trace)
                    .title(format!(
                        "After {words} in which the potential leaves the doubles by {by}, the session goes on from \
                         where it was."
                    ))
                    .flags(&["session-lifecycle", "non-finite-numbers"])
                    .because("A request that fails leaves the network and the time of its session as they were."),
            );
        }
    }
    cases
}

/// A network whose numbers leave the doubles when two ports give it so much for 40 ms.
struct Overdriven {
    what: &'static str,
    observable: &'static str,
    kind: &'static str,
    ground: Open,
    much: f64,
    /// A value that does no harm.
    little: f64,
    /// Where it begins, and by how much the input is multiplied.
    rest: f64,
    gain: f64,
}

impl Overdriven {
    fn both() -> [Self; 2] {
        let membrane = Open { params: vec![("C_m", 1.0)], ..Open::lif("a") };
        let of = |what, [observable, kind]: [&'static str; 2], ground, [much, little, rest, gain]: [f64; 4]| Self {
            what,
            observable,
            kind,
            ground,
            much,
            little,
            rest,
            gain,
        };
        [
            of("rate", ["rate", "rate_inject"], Open::rate("a"), [1.7e308, 40.0, 0.0, 1.0]),
            of("membrane", ["V_m", "current_pA"], membrane, [-1.7e308, 0.5, -70.0, 10.0]),
        ]
    }

    /// A session of it, with an output and these inputs.
    fn open(&self, id: &str, stimuli: Vec<Json>) -> Open {
        let records = vec![record("out", self.observable, 1.0)];
        Open { id: id.to_owned(), records, stimuli, ..self.ground.clone() }
    }

    /// Where it is after each of so many steps of 1 ms under an input.
    fn after(&self, steps: usize, input: f64) -> Vec<f64> {
        let p = (-0.1_f64).exp();
        let next = |x: &mut f64, _| {
            *x = self.rest + (*x - self.rest) * p + input * self.gain * (1.0 - p);
            Some(*x)
        };
        (0..steps).scan(self.rest, next).collect()
    }
}

/// Two sessions of one network that both fail before anything else: they stay two.
fn failures_of_two() -> Case {
    let [of, _] = Overdriven::both();
    let what = of.what;
    let stimuli = || ["x", "y"].map(|port| stimulus(port, of.kind)).into();
    let open = |id: &str| (of.open(id, stimuli()).text(), opened(id));
    let fails = |id: &str| (driven_step(id, 40.0, &[("x", of.much), ("y", of.much)]), error());
    let steps = |id: &str, x: f64| {
        let out = object! { "times" => nums(&[1.0]), "values" => nums(&of.after(1, x)) };
        (driven_step(id, 1.0, &[("x", x), ("y", 0.0)]), recorded(id, object! { "out" => out }))
    };
    let trace = vec![open("a"), open("b"), fails("a"), fails("b"), steps("a", of.little), steps("b", 0.0)];
    super::reference(format!("fails/{what}/of-two-sessions"), &["NCP-SESS-035", "NCP-SESS-057"], trace)
        .title(format!("Two sessions whose {what} left the doubles go on each by itself."))
        .flags(&["session-lifecycle", "non-finite-numbers"])
        .because("What is done to one session changes no other; a request that fails leaves the network as it was.")
}

/// The values of ports to which a request that fails brings nothing.
fn failures_beside_a_current() -> Vec<Case> {
    let mut cases = Vec::new();
    for of in Overdriven::both() {
        let what = of.what;
        let (name, words, target) = match what {
            "rate" => ("same", "the same population", "pop"),
            _ => ("other", "another population", "other"),
        };
        let drive = |port: &str| stimulus(port, of.kind).with("target", target.into());
        let stimuli = vec![stimulus("in", of.kind), drive("x"), drive("y")];
        let open = Open { other: Some(1), ..of.open("a", stimuli) };
        let values = of.after(3, of.little);
        let steps = |request: String, from: usize, to: usize| {
            let times: Vec<f64> = (1_u32..).map(f64::from).skip(from).take(to - from).collect();
            let out = object! { "times" => nums(&times), "values" => nums(&values[from..to]) };
            (request, recorded("a", object! { "out" => out }))
        };
        let trace = vec![
            (open.text(), opened("a")),
            steps(driven_step("a", 1.0, &[("in", of.little)]), 0, 1),
            (driven_step("a", 40.0, &[("x", of.much), ("y", of.much)]), error()),
            steps(driven_step("a", 2.0, &[("x", 0.0), ("y", 0.0)]), 1, 3),
        ];
        let path = format!("fails/{what}/beside-a-stimulus/{name}");
        cases.push(
            super::reference(path, &["NCP-SESS-054", "NCP-SESS-057"], trace)
                .title(format!(
                    "A stimulus stays when a request fails that brings values for other ports, of {words} ({what})."
                ))
                .flags(&["session-lifecycle", "non-finite-numbers"])
                .because("A stimulus stays until another value for its port comes, which the one that fails lacks."),
        );
    }
    cases
}

/// Many requests that fail: none ends the session, and all of them together neither.
fn failures_without_number() -> Vec<Case> {
    const MANY: usize = 300;
    let too_much = Open { params: vec![("C_m", 1.0)], stimuli: vec![stimulus("in", "current_pA")], ..Open::lif("a") };
    let at_rest = || step_of("a", Some(1.0), Some(("in", 0.0)));
    let plain = || step_of("a", Some(1.0), None);
    type Row = (&'static str, &'static str, String, String, String);
    let table: [Row; 3] = [
        ("below-0", "steps of a time below 0", Open::lif("a").text(), step_of("a", Some(-1.0), None), plain()),
        ("nonsense", "texts that are no request", Open::lif("a").text(), "hello".to_owned(), plain()),
        (
            "overflow",
            "steps whose membrane leaves the doubles",
            too_much.text(),
            step_of("a", Some(10.0), Some(("in", -1.7e308))),
            at_rest(),
        ),
    ];
    let one = |(name, words, open, fails, then): Row| {
        let mut trace = vec![(open, opened("a")), (then.clone(), observed("a", 1.0))];
        trace.extend(std::iter::repeat_n((fails, error()), MANY));
        trace.extend([(then, observed("a", 2.0)), (close("a"), closed("a"))]);
        let (path, rules) = (format!("fails/many/{name}"), ["NCP-SESS-037", "NCP-SESS-027"]);
        match name {
            "overflow" => super::reference(path, &rules, trace),
            _ => case(path, &rules, trace),
        }
        .title(format!("A session goes on after {MANY} {words}, and is closed."))
        .flags(&["session-lifecycle"])
        .because("A request that fails costs that request only, however many fail.")
    };
    table.map(one).into()
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
