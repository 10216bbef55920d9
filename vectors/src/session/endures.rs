//! Sessions that go through the same thousands of times, and go on as they began.

use super::life::{open, opening, steps};
use super::numbers::{driven_step, simulate};
use super::{
    Open, close, closed, error, observed, opened, record, recorded, reference, run, step as step_of, stimulus,
};
use crate::case::Case;
use crate::json::{Json, object};
use crate::trace::{anything, nums};

pub(super) fn cases() -> Vec<Case> {
    let mut cases = one_kind();
    cases.push(opened_and_closed());
    cases.push(closed_among_others());
    cases.push(within_another());
    cases.push(idle());
    cases.extend(rounds());
    cases.push(driven_and_closed());
    cases
}

/// A session of thousands of requests.
fn one_kind() -> Vec<Case> {
    const MANY: u16 = 3_000;
    let one = |name: &str, rules: &[&'static str], words: &str, request: String, each_ms: f64, reply: Json| {
        let after = |more_ms| observed("a", each_ms.mul_add(f64::from(MANY), more_ms));
        let mut trace = vec![open("a")];
        trace.extend(std::iter::repeat_n((request, reply), usize::from(MANY)));
        trace.extend([
            (step_of("a", Some(5.0), None), after(5.0)),
            (super::run("a", 2.0), after(7.0)),
            steps("a", each_ms.mul_add(f64::from(MANY), 17.0)),
            (close("a"), closed("a")),
            (step_of("a", None, None), error()),
        ]);
        super::reference(format!("endures/{name}"), rules, trace)
            .title(format!("After {MANY} {words}, a session goes on as it began, until it is closed."))
            .flags(&["session-lifecycle"])
            .because("The time of a session is the sum of what it was advanced by; a `close_session` ends it.")
    };
    vec![
        refusals("refusals", "", &[1]),
        // What the larger ones leave of a room, the smaller ones fill.
        refusals("refusals-of-large", ", of 20,000 neurons and of fewer", &[20_000, 600, 20, 2]),
        one("steps", &ADDS_UP[..2], "steps", step_of("a", Some(1.0), None), 1.0, anything()),
        one("runs", &ADDS_UP[..2], "runs", super::run("a", 1.0), 1.0, anything()),
        one("errors", APART, "steps of another session", step_of("b", Some(1.0), None), 0.0, error()),
    ]
}

/// A session that is opened behind a thousand openings of each kind that a server may refuse, of so many neurons each.
/// Whether it refuses them is not asked.
fn refusals(name: &str, words: &str, sizes: &[u32]) -> Case {
    const MANY: usize = 1_100;
    let network = |name: &str, size: u32| {
        let network = object! { "kind" => "builtin", "ref" => name };
        if size > 1 { network.with("population_sizes", object! { "pop" => size }) } else { network }
    };
    let repeated = |id: &str, name: &str| {
        let requests = sizes.iter().map(|size| opening(id, network(name, *size)));
        requests.flat_map(|request| std::iter::repeat_n((request, anything()), MANY)).collect::<Vec<_>>()
    };
    let mut trace = repeated("b", "ncp.no.such.network");
    trace.extend([(close("b"), anything()), open("a")]);
    trace.extend(repeated("a", "ncp.reference.lif"));
    trace.extend(repeated("a", "ncp.no.such.network"));
    // Larger than the one that makes room.
    let anew = (Open { size: 10, ..Open::lif("a") }.text(), opened("a"));
    trace.extend([(close("a"), closed("a")), anew, steps("a", 10.0), (close("a"), closed("a"))]);
    super::reference(format!("endures/{name}"), &["NCP-SESS-050", "NCP-SESS-028"], trace)
        .title(format!("A session is opened behind {MANY} openings of each kind that may be refused{words}."))
        .flags(&["session-lifecycle"])
        .because("An `open_session` that is refused takes no room: it changes nothing, and leaves nothing behind.")
}

/// A session that nobody asks while another is asked again and again, and a third is opened and closed.
fn idle() -> Case {
    const MANY: usize = 9_000;
    let mut trace = vec![open("a"), steps("a", 10.0), open("b")];
    trace.extend(std::iter::repeat_n((step_of("b", Some(1.0), None), anything()), MANY));
    trace.extend([open("c"), (close("c"), closed("c")), steps("a", 20.0), (close("a"), closed("a"))]);
    trace.push((step_of("a", None, None), error()));
    super::reference("endures/idle".to_owned(), &["NCP-SESS-027", "NCP-SESS-033", "NCP-SESS-035"], trace)
        .title(format!("A session goes on as it was behind {MANY} requests to another and an opening."))
        .flags(&["session-lifecycle"])
        .because("A session is open until a `close_session` ends it, however long nobody asks it anything.")
}

/// A session that is opened, stepped and closed over and over.
fn opened_and_closed() -> Case {
    const MANY: usize = 1_100;
    let once = || [open("a"), steps("a", 10.0), (close("a"), closed("a"))];
    let mut trace: Vec<(String, Json)> = std::iter::repeat_with(once).take(MANY).flatten().collect();
    trace.extend([open("a"), steps("a", 10.0), steps("a", 20.0), (close("a"), closed("a"))]);
    trace.push((step_of("a", None, None), error()));
    super::reference("endures/closes".to_owned(), &["NCP-SESS-033", "NCP-SESS-028"], trace)
        .title(format!("A session that was opened and closed {MANY} times is opened as on the first."))
        .flags(&["session-lifecycle"])
        .because("A session that is closed leaves nothing behind: its room and its id are free again.")
}

/// A session that is closed, and asked all the same, whenever its place may have gone to another.
fn closed_among_others() -> Case {
    const MANY: usize = 1_100;
    let round = [
        (Open::lif("b").text(), opened("b")),
        (step_of("a", Some(1.0), None), error()),
        (step_of("b", Some(1.0), None), observed("b", 1.0)),
        (close("b"), closed("b")),
    ];
    let mut trace = vec![open("a"), (close("a"), closed("a"))];
    trace.extend(std::iter::repeat_n(round, MANY).flatten());
    trace.extend([open("a"), steps("a", 10.0)]);
    super::reference("endures/closed-among-others".to_owned(), &["NCP-SESS-026", "NCP-SESS-035"], trace)
        .title(format!("A session that is closed stays closed, whatever is opened behind it, {MANY} times."))
        .flags(&["session-lifecycle"])
        .because("A `close_session` ends a session; what is opened afterwards is another.")
}

/// Requests that have a member to be ignored before all others, in which they would be another's.
fn within_another() -> Case {
    let of = |id: &str, request: &str| {
        let other = object! { "kind" => "close_session", "session_id" => id, "ncp_version" => "9.9",
        "advance_ms" => 7, "duration_ms" => 9, "network" => object! { "ref" => "ncp.no.such.network" } };
        Json::read(request)
            .members()
            .iter()
            .fold(object! { "novel" => other }, |frame, (name, value)| frame.and(name, value.clone()))
    };
    let trace = vec![
        (of("b", &Open::lif("a").text()).text(), opened("a")),
        open("b"),
        (of("b", &step_of("a", Some(5.0), None)).text(), observed("a", 5.0)),
        (of("none", &run("a", 2.0)).text(), observed("a", 7.0)),
        (of("a", &run("b", 3.0)).text(), observed("b", 3.0)),
        (of("b", &close("a")).text(), closed("a")),
        (of("b", &step_of("a", Some(5.0), None)).text(), error()),
        (step_of("b", Some(1.0), None), observed("b", 4.0)),
    ];
    super::reference("life/within-another".to_owned(), &["NCP-SESS-027", "NCP-SESS-035"], trace)
        .by("/replies/5", "NCP-SESS-028")
        .by("/replies/6", "NCP-SESS-028")
        .by("/replies/7", "NCP-SESS-035")
        .title("A request is of the session that it names itself, whatever a member says that is to be ignored.")
        .flags(&["session-lifecycle"])
        .because("A receiver ignores a member that the tables do not list, and what stands in it is no field.")
}

/// A name, the rules, what happens in a round, its requests with their replies, and by how much it advances the
/// session, in ms.
type Rounds = (&'static str, &'static [&'static str], &'static str, Vec<(String, Json)>, f64);

/// The rules of a session beside others, of one that goes on behind failures, and of one whose time adds up.
const APART: &[&str] = &["NCP-SESS-035", "NCP-SESS-033", "NCP-SESS-031"];
const FAILS: &[&str] = &["NCP-SESS-037", "NCP-SESS-033", "NCP-SESS-031"];
const ADDS_UP: &[&str] = &["NCP-SESS-033", "NCP-SESS-031", "NCP-SESS-037"];

/// A session that goes through rounds of requests, some of them to others.
fn rounds() -> Vec<Case> {
    const MANY: u16 = 1_100;
    let step = |id: &str, ms: f64| (step_of(id, Some(ms), None), anything());
    let fails = |id: &str| (step_of(id, Some(-1.0), None), error());
    let closes = |id: &str| (close(id), anything());
    let table: [Rounds; 7] = [
        (
            "of-another",
            APART,
            "another that is opened, stepped and closed",
            vec![(Open::lif("b").text(), anything()), step("b", 1.0), closes("b")],
            0.0,
        ),
        ("failing", FAILS, "a step that fails and one that does not", vec![fails("a"), step("a", 1.0)], 1.0),
        ("by-turns", APART, "a step of it and one of another", vec![step("a", 1.0), step("b", 2.0)], 1.0),
        ("closed-unknown", ADDS_UP, "a step and a close of what is not open", vec![step("a", 1.0), closes("c")], 1.0),
        ("runs", ADDS_UP, "a step and a run", vec![step("a", 1.0), (run("a", 2.0), anything())], 3.0),
        ("of-no-step", ADDS_UP, "a step of no time and one of some", vec![step("a", 0.25), step("a", 1.0)], 1.0),
        (
            "nonsense",
            ADDS_UP,
            "a text that is no request and a step",
            vec![("hello".to_owned(), error()), step("a", 1.0)],
            1.0,
        ),
    ];
    let one = |(name, rules, words, round, each_ms): Rounds| {
        let after = |more_ms| observed("a", f64::from(MANY).mul_add(each_ms, more_ms));
        let mut trace = vec![open("a"), (Open::lif("b").text(), anything())];
        trace.extend(std::iter::repeat_n(round, usize::from(MANY)).flatten());
        trace.extend([
            (step_of("a", Some(5.0), None), after(5.0)),
            (run("a", 2.0), after(7.0)),
            (close("a"), closed("a")),
            (step_of("a", None, None), error()),
            open("a"),
            steps("a", 10.0),
        ]);
        reference(format!("endures/rounds/{name}"), rules, trace)
            .title(format!("After {MANY} rounds of {words}, a session goes on as it began, until it is closed."))
            .flags(&["session-lifecycle"])
            .because(
                "The time of a session is the sum of what it was advanced by, and what fails costs that request only; \
                 a `close_session` ends it, and what is opened then is new.",
            )
    };
    table.map(one).into()
}

/// A network that is driven, closed and opened anew, over and over: each time it begins at rest.
fn driven_and_closed() -> Case {
    const MANY: usize = 1_100;
    let ports = vec![stimulus("in", "current_pA"), stimulus("more", "current_pA")];
    let open = Open { records: vec![record("v", "V_m", 5.0)], stimuli: ports, ..Open::lif("a") };
    let after = |steps, current| {
        let potential = simulate(&[], 1.0, steps, current).1.last().copied().unwrap_or_default();
        recorded("a", object! { "v" => object! { "values" => nums(&[potential]) } })
    };
    let both = driven_step("a", 5.0, &[("in", 200.0), ("more", 100.0)]);
    let round = [(open.text(), opened("a")), (both, after(5, 300.0)), (close("a"), closed("a"))];
    let mut trace = std::iter::repeat_n(round, MANY).flatten().collect::<Vec<_>>();
    trace.extend([
        (open.text(), opened("a")),
        (step_of("a", Some(5.0), Some(("more", 100.0))), after(5, 100.0)),
        (step_of("a", Some(5.0), None), after(10, 100.0)),
        (close("a"), closed("a")),
    ]);
    reference("endures/rounds/driven-and-closed".to_owned(), &["NCP-SESS-035", "NCP-SESS-054"], trace)
        .title(format!("A network that was driven and closed {MANY} times is opened at rest."))
        .flags(&["session-lifecycle"])
        .because("What was done to a session, its stimuli among it, changes no other, not the next either.")
}
