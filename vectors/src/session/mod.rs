//! Area `session`: a server's life, and the numbers of the reference networks.

mod endures;
mod failures;
mod frames;
mod life;
mod numbers;

use crate::case::{Case, File, REFERENCE_NETWORKS, Role};
use crate::json::{Json, object};
use crate::scenario::ScenarioError;
use crate::trace::{any, num, text_of};
use ncp_text::WIRE_VERSION;

pub(crate) fn files() -> Result<Vec<File>, ScenarioError> {
    Ok(vec![life::file()?, frames::file(), crate::wire::requests(), numbers::file()])
}

/// A session of the reference networks.
#[derive(Clone)]
pub(crate) struct Open {
    id: String,
    network: &'static str,
    params: Vec<(&'static str, f64)>,
    size: u32,
    /// The size of a second population, `other`, if there is one.
    other: Option<u32>,
    records: Vec<Json>,
    pub(crate) stimuli: Vec<Json>,
    dt: f64,
    chunk: f64,
}

impl Open {
    pub(crate) fn lif(id: &str) -> Self {
        Self {
            id: id.to_owned(),
            network: "ncp.reference.lif",
            params: Vec::new(),
            size: 1,
            other: None,
            records: Vec::new(),
            stimuli: Vec::new(),
            dt: 1.0,
            chunk: 10.0,
        }
    }

    pub(crate) fn rate(id: &str) -> Self {
        Self { network: "ncp.reference.rate", ..Self::lif(id) }
    }

    fn json(&self) -> Json {
        let params = self.params.iter().map(|(name, value)| ((*name).to_owned(), num(*value))).collect();
        let mut sizes = object! { "pop" => self.size };
        if let Some(other) = self.other {
            sizes = sizes.with("other", other.into());
        }
        object! {
            "ncp_version" => WIRE_VERSION,
            "kind" => "open_session",
            "session_id" => self.id.as_str(),
            "network" => object! {
                "kind" => "builtin",
                "ref" => self.network,
                "population_sizes" => sizes,
                "params" => Json::Object(params),
            },
            "record" => object! { "targets" => Json::Array(self.records.clone()) },
            "stimulus" => object! { "targets" => Json::Array(self.stimuli.clone()) },
            "sim" => object! { "dt_ms" => num(self.dt), "chunk_ms" => num(self.chunk) },
        }
    }

    pub(crate) fn text(&self) -> String {
        self.json().text()
    }
}

fn record(port: &str, observable: &str, cadence: f64) -> Json {
    object! { "port" => port, "target" => "pop", "observable" => observable, "cadence_ms" => num(cadence) }
}

pub(crate) fn stimulus(port: &str, kind: &str) -> Json {
    object! { "port" => port, "target" => "pop", "kind" => kind }
}

pub(crate) fn step(id: &str, advance: Option<f64>, value: Option<(&str, f64)>) -> String {
    let mut request = object! { "ncp_version" => WIRE_VERSION, "kind" => "step_request", "session_id" => id };
    if let Some(advance) = advance {
        request = request.with("advance_ms", num(advance));
    }
    if let Some((port, value)) = value {
        request = request.with(
            "stimulus",
            object! { "values" => object! { port => object! { "data" => Json::Array(vec![num(value)]) } } },
        );
    }
    request.text()
}

pub(crate) fn run(id: &str, duration: f64) -> String {
    object! { "ncp_version" => WIRE_VERSION, "kind" => "run_request", "session_id" => id,
    "duration_ms" => num(duration) }
    .text()
}

pub(crate) fn close(id: &str) -> String {
    object! { "ncp_version" => WIRE_VERSION, "kind" => "close_session", "session_id" => id }.text()
}

pub(crate) fn opened(id: &str) -> Json {
    text_of(object! { "kind" => "session_opened", "session_id" => id, "ok" => true })
}

pub(crate) fn not_opened(id: &str) -> Json {
    text_of(object! { "kind" => "session_opened", "session_id" => id, "ok" => false })
}

pub(crate) fn error() -> Json {
    text_of(object! { "kind" => "error" })
}

pub(crate) fn observed(id: &str, time: f64) -> Json {
    text_of(object! {
        "kind" => "observation_frame",
        "session_id" => id,
        "sim_time_ms" => num(time),
        "calibrated_posterior" => false,
        "is_simulation_output" => true,
    })
}

/// An observation of the session, whatever it holds.
fn observation(id: &str) -> Json {
    text_of(object! { "kind" => "observation_frame", "session_id" => id })
}

/// An observation of the session with these records; its time is the affair of other cases.
fn recorded(id: &str, records: Json) -> Json {
    text_of(object! { "kind" => "observation_frame", "session_id" => id, "records" => records })
}

pub(crate) fn closed(id: &str) -> Json {
    text_of(object! { "kind" => "session_closed", "session_id" => id, "ok" => true })
}

fn not_closed(id: &str) -> Json {
    any(vec![text_of(object! { "kind" => "session_closed", "session_id" => id, "ok" => false }), error()])
}

fn replies(of: Vec<Json>) -> Json {
    object! { "replies" => Json::Array(of) }
}

/// A case for the servers that claim the reference networks.
fn reference(path: String, rules: &[&'static str], trace: Vec<(String, Json)>) -> Case {
    let mut expected = within_capacities(&trace);
    let opens = trace
        .first()
        .filter(|(_, reply)| opens(reply))
        .map(|(request, _)| if request.contains("ncp.reference.rate") { "NCP-SESS-051" } else { "NCP-SESS-050" });
    let (requests, answers): (Vec<String>, Vec<Json>) = trace.into_iter().unzip();
    expected.insert(0, replies(answers));
    let case = of_members(asking(path, rules, requests).shows(any(expected)).needs(REFERENCE_NETWORKS));
    // A server that claims the networks opens them, whatever else the case is about.
    opens.into_iter().fold(case, |case, rule| case.by("/replies/0", rule))
}

/// Lets each member of an observation be judged by the rule about it.
fn of_members(case: Case) -> Case {
    // When a neuron fires, its network decides; when a port is sampled, the cadence.
    let (place, rule) = match case.requirements.first() {
        Some(&"NCP-SESS-053") => ("/replies/*/records/*/values", "NCP-SESS-050"),
        _ => ("/replies/*/records/*/unit", "NCP-SESS-056"),
    };
    let case = match case.requirements.first() {
        // A port that is left out says nothing of the numbers of its samples.
        Some(&("NCP-SESS-050" | "NCP-SESS-053")) => {
            let case = case.by("/replies/*/records/*", "NCP-SESS-038");
            case.by_own("/replies/*/records/*/times").by_own("/replies/*/records/*/values")
        }
        _ => case,
    };
    let case = match case.requirements.first() {
        Some(&"NCP-SESS-058") => case,
        _ => case.by("/replies/*/sim_time_ms", "NCP-SESS-033"),
    };
    let case = case.by(place, rule);
    match case.requirements.first() {
        Some(&"NCP-SESS-059") => case,
        _ => case.by("/replies/*/records/*/senders", "NCP-SESS-052"),
    }
}

fn asking(path: String, rules: &[&'static str], requests: Vec<String>) -> Case {
    Case::new(path, rules, &[Role::Server])
        .call("session.run", object! { "requests" => requests.into_iter().collect::<Json>() })
}

/// The session that a request is about.
fn id_of(request: &str) -> &str {
    request.split("\"session_id\":\"").nth(1).and_then(|rest| rest.split('"').next()).unwrap_or_default()
}

/// Whether a request is well-formed and of a kind.
fn is_of(request: &str, kind: &str) -> bool {
    request.starts_with(&format!("{{\"ncp_version\":\"{WIRE_VERSION}\",\"kind\":\"{kind}\""))
}

/// What a request is answered for a session that was refused; `None` if it is no request for one.
fn without_session(request: &str) -> Option<Json> {
    if is_of(request, "open_session") {
        Some(any(vec![not_opened(id_of(request)), error()]))
    } else if is_of(request, "step_request") || is_of(request, "run_request") {
        Some(error())
    } else if is_of(request, "close_session") {
        Some(not_closed(id_of(request)))
    } else {
        None
    }
}

/// Whether a reply says that a session was opened.
fn opens(reply: &Json) -> bool {
    reply.text().contains("\"ok\":true") && reply.text().contains("session_opened")
}

/// The answers to a trace of servers that hold fewer sessions open than it asks for, one at least.
pub(crate) fn within_capacities(trace: &[(String, Json)]) -> Vec<Json> {
    let (_, most) = within(usize::MAX, trace);
    (1..most).map(|capacity| replies(within(capacity, trace).0)).collect()
}

/// The answers of a server that holds so many sessions open and no more, and how many it held.
fn within(capacity: usize, trace: &[(String, Json)]) -> (Vec<Json>, usize) {
    let (mut open, mut refused, mut most) = (Vec::new(), Vec::new(), 0);
    let answers = trace.iter().map(|(request, reply)| {
        let id = id_of(request);
        if opens(reply) {
            let (to, from) = if open.len() < capacity { (&mut open, &mut refused) } else { (&mut refused, &mut open) };
            from.retain(|other| *other != id);
            to.push(id);
            most = most.max(open.len());
        }
        let answer = Some(id).filter(|id| refused.contains(id));
        let answer = answer.and_then(|_| without_session(request));
        if is_of(request, "close_session") {
            open.retain(|other| *other != id);
        }
        answer.unwrap_or_else(|| reply.clone())
    });
    (answers.collect(), most)
}

/// A case of requests and what they are answered; a server that refuses the network opens no
/// session, and then answers every step with an error frame and every close with a refusal. One
/// that is full answers so for the sessions beyond its capacity.
pub(crate) fn case(path: String, rules: &[&'static str], trace: Vec<(String, Json)>) -> Case {
    let mut expected = within_capacities(&trace);
    if trace.iter().any(|(_, reply)| opens(reply)) {
        let without = trace.iter().map(|(request, reply)| without_session(request).unwrap_or_else(|| reply.clone()));
        expected.push(replies(without.collect()));
    }
    let (requests, with): (Vec<String>, Vec<Json>) = trace.into_iter().unzip();
    expected.insert(0, replies(with));
    asking(path, rules, requests).shows(any(expected))
}
