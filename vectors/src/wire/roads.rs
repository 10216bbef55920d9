//! Frames with one broken field, by the other roads on which frames come: to a server as requests, to a plant as
//! commands, to a client as replies. Who checks a field in `decode` need not check it there.

use super::fields;
use super::place::Place;
use crate::case::{Case, File, Role};
use crate::command::active;
use crate::json::{Json, object};
use crate::model::minimal;
use crate::resilience::{Event, buffer, go};
use crate::roles::a;
use crate::session::{Open, case, error, not_opened, observed, opened, run, stimulus};
use crate::trace::{any, no_result, num, nums, steps};

/// Replies, as a client receives them.
pub(super) fn replies() -> File {
    let pairs = [
        ("open_session", "session_opened"),
        ("step_request", "observation_frame"),
        ("close_session", "session_closed"),
    ];
    let mut cases = Vec::new();
    for (request, kind) in pairs {
        cases.extend(broken(kind).iter().flat_map(|field| replied(request, field)));
    }
    File::new("wire", "reply_fields", "Replies with one broken field, as a client receives them.", cases)
}

/// Requests, as a server receives them.
pub(crate) fn requests() -> File {
    let kinds = ["open_session", "step_request", "run_request", "close_session"];
    let cases = kinds.into_iter().flat_map(broken).map(|field| requested(&field));
    File::new("session", "fields", "Requests with one broken field, as a server receives them.", cases.collect())
}

/// Commands, as a plant receives them.
pub(crate) fn commands() -> File {
    let cases = broken("command_frame").iter().map(commanded).collect();
    File::new("resilience", "fields", "Commands with one broken field, as a plant receives them.", cases)
}

/// The requests with one broken field: each is answered with an error frame, and none of them does anything.
fn requested(field: &Broken) -> Case {
    let open = || {
        let mut open = Open::lif("s1");
        open.stimuli.push(stimulus("in", "current_pA"));
        (open.text(), opened("s1"))
    };
    // What is no text is no version either, malformed or not.
    let refusal = match (field.kind, field.name.as_str()) {
        ("open_session", "ncp_version") => any(vec![error(), not_opened("s1")]),
        _ => error(),
    };
    let refused = field.frames(request(field.kind)).map(|frame| (frame.text(), refusal.clone()));
    let trace: Vec<(String, Json)> = match field.kind {
        // Which one of them opened, the last would open no more.
        "open_session" => refused.chain([open()]).collect(),
        _ => [open()].into_iter().chain(refused).chain([(run("s1", 1.0), observed("s1", 1.0))]).collect(),
    };
    let kind = field.kind;
    let case = case(format!("{kind}/{}", field.name), &["NCP-SESS-021"], trace)
        .title(format!(
            "A server answers {} whose `{}` is broken with an error frame, in whichever way, and does nothing.",
            a(kind).to_lowercase(),
            field.member()
        ))
        .because("What cannot be decoded is no request, whichever of its fields is to blame.")
        .flags(&["unanswered-requests"]);
    let opens = (kind != "open_session").then_some("NCP-SESS-020");
    let case = opens.into_iter().fold(case, |case, rule| case.by("/replies/0", rule));
    field.rests(case)
}

/// A request that a server would do, were no field of it broken.
fn request(kind: &str) -> Json {
    let stimulated = |frame: Json| {
        let value = object! { "data" => nums(&[1.0]), "unit" => "pA" };
        frame.with("stimulus", object! { "values" => object! { "in" => value } })
    };
    let frame = minimal(kind);
    match kind {
        "open_session" => frame.with("network", object! { "ref" => "ncp.reference.lif" }),
        "step_request" => stimulated(frame.with("advance_ms", num(1.0))),
        "run_request" => stimulated(frame.with("duration_ms", num(1.0))),
        _ => frame,
    }
}

/// The commands with one broken field, as they come to a plant: none of them moves it, and none counts.
fn commanded(field: &Broken) -> Case {
    let broken = field.frames(active(5).x(9.0).frame());
    let mut events: Vec<Event> =
        broken.map(|frame| Event::Text { text: Json::string(frame.text()), now: 1.0, stops: false }).collect();
    let mut results = vec![no_result(); events.len()];
    events.extend([Event::Ask(1.0), go(4, 1.125), Event::Ask(1.125)]);
    let moving = object! { "velocity_setpoint" => object! { "data" => nums(&[4.0, 0.0, 0.0]) } };
    results.extend([object! { "channels" => Json::Null }, no_result(), object! { "channels" => moving }]);
    let (args, _, decided) = buffer(&events, false);
    let case = Case::new(field.name.clone(), &["NCP-RES-006"], &[Role::Body])
        .call("buffer.run", args)
        .shows(steps(results))
        .decided_throughout_by(&decided)
        .title(format!(
            "A command whose `{}` is broken, in whichever way, moves nothing, and the next one does.",
            field.member()
        ))
        .because("A frame that is rejected is not acted upon in any part.")
        .flags(&["malformed-moves"]);
    field.rests(case)
}

/// The replies with one broken field, each for itself.
fn replied<'a>(request: &'a str, field: &'a Broken) -> impl Iterator<Item = Case> + 'a {
    field.cases.iter().filter_map(move |(id, broken)| {
        let what = broken.path.rsplit_once('/').map_or("", |(_, what)| what);
        let reply = broken.args.get("text")?.as_str()?;
        let title = broken.title.split_once(' ').map_or("", |(_, rest)| rest);
        Some(
            Case::new(format!("{}/{}/{what}", field.kind, field.name), &["NCP-SESS-006"], &[Role::Commander])
                .call("reply.check", object! { "request" => minimal(request).text(), "reply" => reply })
                .rejects("reply")
                .title(format!("As a reply, too, a {title}"))
                .because("No decoder accepts such a frame.")
                .flags(&["unchecked-replies"])
                .rests_on(id.as_str()),
        )
    })
}

/// A field, and the cases of `decode` that break it, by their ids.
struct Broken {
    kind: &'static str,
    /// The members that lead to the field, with `/` between them.
    name: String,
    cases: Vec<(String, Case)>,
}

impl Broken {
    /// The frame, with the field broken in each of the ways.
    fn frames(&self, frame: Json) -> impl Iterator<Item = Json> {
        self.cases.iter().filter_map(move |(_, case)| {
            let broken = Json::read(case.args.get("text")?.as_str()?);
            let is_absent = case.path.ends_with("/absent") && !self.name.contains('/');
            let frame = if is_absent { frame.clone().without(&self.name) } else { frame.clone() };
            Some(laid_over(frame, broken))
        })
    }

    fn member(&self) -> String {
        self.name.replace('/', ".")
    }

    /// The case shows nothing of its own rule where `decode` does not reject the frame either.
    fn rests(&self, case: Case) -> Case {
        self.cases.iter().fold(case, |case, (id, _)| case.rests_on(id.as_str()))
    }
}

/// In how many ways a field of what stands within a frame is broken, besides the [`ENDS`]: `decode` breaks it in all.
const WITHIN: usize = 2;

/// The ways that a reader of its own for what stands within a frame would overlook: an item, and the ends of numbers.
const ENDS: [&str; 4] = ["element-null", "double-overflow", "integer-fraction", "integer-two-to-53"];

/// The fields of a kind that some frame breaks, those of what stands within it among them.
fn broken(kind: &'static str) -> Vec<Broken> {
    let places = Place::frames().chain(Place::nested());
    let places = places.filter(|place| place.kind == kind && !place.is_twin());
    let mut fields: Vec<Broken> = Vec::new();
    for place in places {
        let file = fields::file_of(&place);
        let is_broken = |case: &Case| {
            let is_written_out = case.args.get("text").and_then(Json::as_str).is_some();
            case.expect.get("reject").is_some() && is_written_out
        };
        for case in fields::cases_at(&place).into_iter().filter(is_broken) {
            let path = case.path.strip_prefix(kind).map_or(case.path.as_str(), |path| path.trim_start_matches('/'));
            let (field, way) = path.rsplit_once('/').unwrap_or(("", path));
            let most = if field.contains('/') && !ENDS.contains(&way) { WITHIN } else { usize::MAX };
            let name = field.to_owned();
            let case = (format!("wire/{file}/{}", case.path), case);
            match fields.iter_mut().find(|field| field.name == name) {
                Some(field) if field.cases.len() >= most => {}
                Some(field) => field.cases.push(case),
                None => fields.push(Broken { kind, name, cases: vec![case] }),
            }
        }
    }
    fields
}

/// A frame with what another says in its place, member by member, and in a list by its first item.
fn laid_over(frame: Json, other: Json) -> Json {
    match (frame, other) {
        (Json::Object(members), Json::Object(others)) => {
            others.into_iter().fold(Json::Object(members), |frame, (name, other)| {
                let own = frame.get(&name).cloned();
                frame.with(&name, own.map_or(other.clone(), |own| laid_over(own, other)))
            })
        }
        (Json::Array(items), Json::Array(others)) if !items.is_empty() && !others.is_empty() => {
            let first = items.into_iter().zip(others.clone()).map(|(item, other)| laid_over(item, other)).take(1);
            first.chain(others.into_iter().skip(1)).collect()
        }
        (_, other) => other,
    }
}
