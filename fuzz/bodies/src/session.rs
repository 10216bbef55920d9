//! A server with the reference backend: each line of the input is a request, or each request is built from bytes.

use std::borrow::Cow;
use std::collections::BTreeMap;

use ncp_spec::WIRE_VERSION;
use ncp_spec::reply::check_reply;
use ncp_spec::session::{ReferenceBackend, SessionService};
use ncp_spec::wire::{Kind, Message, OpenSession, decode_any};
use serde_json::{Value, json};

use crate::plain::{plain, read, write};

plain! {
    /// A session, by one of a few names.
    words Name = ["a", "b", "café", ""];
}
plain! {
    /// What a client says of the protocol.
    words Version = [WIRE_VERSION, "1.2.3", "0.4", "1.5", "five", ""];
}
plain! {
    /// A request to open.
    struct Opening {
        /// Which.
        id: Name,
        /// `ncp_version`
        version: Version,
        /// How many neurons its population has.
        neurons: u8,
        /// Whether its potential is recorded, at one port.
        records: bool,
        /// `dt_ms`
        dt_ms: f64,
        /// `chunk_ms`
        chunk_ms: f64,
    }
}
plain! {
    /// A request to go on.
    struct Going {
        /// Which.
        id: Name,
        /// For how long, in ms.
        time_ms: Option<f64>,
    }
}
plain! {
    /// A request.
    enum Request {
        /// `open_session`
        0 Open(Opening),
        /// `step_request`
        1 Step(Going),
        /// `run_request`
        2 Run(Going),
        /// `close_session`
        3 Close(Name),
    }
}
plain! {
    /// Requests, one after the other.
    struct Trace {
        /// In this order.
        requests: Vec<Request>,
    }
}

/// The first byte of an input that is a [`Trace`]: no line begins with it.
const BUILT: u8 = 0;

/// How many requests of an input are served.
const MOST_REQUESTS: usize = 12;
/// How much a request may cost, in steps times neurons. What would take longer is left out.
const MOST_WORK: f64 = 4_000.0;

/// Every request gets one reply, which is of the kind that answers it, which a client reads, and which
/// is true: sessions open once, step by what was asked, count, and close.
///
/// It would find a panic, a session that is opened although it was refused, two sessions that get mixed
/// up, a time that is not added up, and a reply that its own client refuses.
// [NCP-SESS-020] [NCP-SESS-021] [NCP-SESS-022] [NCP-SESS-023] [NCP-SESS-024] [NCP-SESS-025]
// [NCP-SESS-026] [NCP-SESS-027] [NCP-SESS-028] [NCP-SESS-029] [NCP-SESS-030] [NCP-SESS-031]
// [NCP-SESS-032] [NCP-SESS-033] [NCP-SESS-034] [NCP-SESS-035] [NCP-SESS-037] [NCP-SESS-039]
// [NCP-SESS-007] [NCP-PROV-007]
pub fn session(input: &[u8]) {
    let mut service = SessionService::new(ReferenceBackend);
    let mut open: BTreeMap<String, Model> = BTreeMap::new();
    for line in lines(input).split(|byte| *byte == b'\n').take(MOST_REQUESTS) {
        let request = decode_any(line);
        if request.as_ref().is_ok_and(|request| is_too_much(request, &open)) {
            continue;
        }
        let text = service.serve(line);
        let reply = decode_any(text.as_bytes()).expect("a reply can be read");
        match &request {
            Err(_) => assert_eq!(reply.kind(), Kind::Error),
            Ok(request) => judge(request, &reply, &text, &mut open),
        }
        let sessions: Vec<_> = service.open_sessions().map(str::to_owned).collect();
        assert!(sessions.iter().eq(open.keys()), "{sessions:?} are open");
    }
}

/// The requests of an input, as lines.
fn lines(input: &[u8]) -> Cow<'_, [u8]> {
    let [BUILT, trace @ ..] = input else {
        return input.into();
    };
    let requests = read::<Trace>(trace).requests;
    let lines: Vec<String> = requests.iter().map(|r| r.json().to_string()).collect();
    lines.join("\n").into_bytes().into()
}

/// The bytes of requests that open, use and close two sessions, and one that is not there.
#[must_use]
pub fn seed() -> Vec<u8> {
    let open = |id| {
        Request::Open(Opening {
            id: Name(id),
            version: Version(WIRE_VERSION),
            neurons: 1,
            records: true,
            dt_ms: 1.0,
            chunk_ms: 10.0,
        })
    };
    let going = |id, time_ms| Going { id: Name(id), time_ms };
    let requests = vec![
        open("a"),
        Request::Step(going("a", None)),
        open("b"),
        Request::Run(going("b", Some(5.0))),
        Request::Close(Name("a")),
        Request::Step(going("café", Some(1.0))),
    ];
    [vec![BUILT], write(&Trace { requests })].concat()
}

/// An input as a person reads it.
#[must_use]
pub fn show(input: &[u8]) -> String {
    String::from_utf8_lossy(&lines(input)).into_owned()
}

impl Request {
    fn json(&self) -> Value {
        match self {
            Self::Open(opening) => {
                let targets = if opening.records {
                    json!([{"port": "v", "target": "pop", "observable": "V_m", "cadence_ms": 1.0}])
                } else {
                    json!([])
                };
                json!({
                    "ncp_version": opening.version.0, "kind": "open_session", "session_id": opening.id.0,
                    "network": {
                        "kind": "builtin", "ref": "ncp.reference.lif", "params": {},
                        "population_sizes": {"pop": opening.neurons},
                    },
                    "record": {"targets": targets}, "stimulus": {"targets": []},
                    "sim": {"dt_ms": opening.dt_ms, "chunk_ms": opening.chunk_ms},
                })
            }
            Self::Step(going) => json!({
                "ncp_version": WIRE_VERSION, "kind": "step_request", "session_id": going.id.0,
                "advance_ms": going.time_ms,
            }),
            Self::Run(going) => json!({
                "ncp_version": WIRE_VERSION, "kind": "run_request", "session_id": going.id.0,
                "duration_ms": going.time_ms,
            }),
            Self::Close(id) => {
                json!({"ncp_version": WIRE_VERSION, "kind": "close_session", "session_id": id.0})
            }
        }
    }
}

struct Model {
    dt_ms: f64,
    chunk_ms: f64,
    neurons: f64,
    ports: Vec<String>,
    seq: i64,
    /// Those that have run since it was opened.
    steps: f64,
}

/// The digits of the last part of a version, without leading zeros.
fn minor(version: &str) -> Option<&str> {
    version.split('.').next_back().map(|minor| minor.trim_start_matches('0'))
}

fn judge(request: &Message, reply: &Message, text: &str, open: &mut BTreeMap<String, Model>) {
    match (request, reply) {
        (Message::OpenSession(request), Message::SessionOpened(opened)) => {
            assert_eq!(opened.session_id, request.session_id);
            let id = request.session_id.to_string();
            if opened.ok {
                assert_eq!(minor(&request.ncp_version), minor(WIRE_VERSION));
                assert!(opened.provenance.is_some());
                assert!(open.insert(id, Model::of(request)).is_none(), "opened twice");
            } else {
                assert!(opened.error.is_some());
            }
        }
        (Message::StepRequest(_) | Message::RunRequest(_), Message::ObservationFrame(frame)) => {
            let (id, asked_ms) = asked(request);
            let model = open.get_mut(id).expect("only an open session runs");
            let asked_ms = asked_ms.unwrap_or(model.chunk_ms);
            assert!(asked_ms.is_finite() && asked_ms >= 0.0);
            model.seq += 1;
            // Each request runs whole steps, of what it asks for the nearest number. [NCP-SESS-058]
            model.steps += (asked_ms / model.dt_ms).round();
            assert_eq!((frame.session_id.as_ref(), frame.seq), (id, model.seq));
            let behind = model.steps * model.dt_ms - frame.sim_time_ms;
            assert!(behind.abs() <= 1e-9 * frame.sim_time_ms.abs(), "{behind} ms behind");
            assert!(frame.records.keys().eq(model.ports.iter()), "other ports are recorded");
            for record in frame.records.values() {
                assert_eq!(record.times.len(), record.senders.len());
                assert!(record.times.iter().all(|t| *t <= frame.sim_time_ms + 1e-9 * frame.sim_time_ms.abs()));
            }
        }
        (Message::CloseSession(request), Message::SessionClosed(closed)) => {
            assert_eq!(closed.session_id, request.session_id);
            let was_open = open.remove(request.session_id.as_ref()).is_some();
            assert_eq!(closed.ok, was_open, "what is not open was closed");
        }
        (_, Message::Error(_)) => {
            let asks_to_run = matches!(request, Message::StepRequest(_) | Message::RunRequest(_));
            let is_request = asks_to_run || matches!(request, Message::OpenSession(_) | Message::CloseSession(_));
            assert!(asks_to_run || !is_request, "{} gets an error frame", request.kind());
        }
        (request, reply) => panic!("{} answers {}", reply.kind(), request.kind()),
    }
    let succeeded = match reply {
        Message::SessionOpened(opened) => opened.ok,
        Message::SessionClosed(closed) => closed.ok,
        Message::ObservationFrame(_) => true,
        _ => false,
    };
    assert_eq!(check_reply(request, text.as_bytes()).is_ok(), succeeded);
}

impl Model {
    fn of(request: &OpenSession) -> Self {
        let mut ports: Vec<_> = request.record.targets.iter().map(|target| target.port.to_string()).collect();
        ports.sort();
        ports.dedup();
        Self {
            dt_ms: request.sim.dt_ms,
            chunk_ms: request.sim.chunk_ms,
            neurons: neurons(request),
            ports,
            seq: 0,
            steps: 0.0,
        }
    }
}

fn neurons(request: &OpenSession) -> f64 {
    let listed = request.record.targets.len() as f64 + 1.0;
    request.network.population_sizes.values().map(|size| *size as f64).sum::<f64>().max(1.0) * listed
}

fn asked(request: &Message) -> (&str, Option<f64>) {
    match request {
        Message::StepRequest(request) => (&request.session_id, request.advance_ms),
        Message::RunRequest(request) => (&request.session_id, Some(request.duration_ms)),
        _ => ("", None),
    }
}

/// Whether serving a request would take long; what is refused at once is served.
fn is_too_much(request: &Message, open: &BTreeMap<String, Model>) -> bool {
    match request {
        Message::OpenSession(request) => neurons(request) > 1_000.0,
        Message::StepRequest(_) | Message::RunRequest(_) => {
            let (id, asked_ms) = asked(request);
            open.get(id).is_some_and(|model| {
                let steps = asked_ms.unwrap_or(model.chunk_ms) / model.dt_ms;
                steps * model.neurons > MOST_WORK && steps < 1e6
            })
        }
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_built_requests_open_use_and_close_sessions() {
        let input = seed();
        assert_eq!(input.first(), Some(&BUILT));
        let mut service = SessionService::new(ReferenceBackend);
        let lines = lines(&input);
        let replies = lines.split(|byte| *byte == b'\n').map(|line| service.serve(line));
        let kinds: Vec<Kind> = replies.map(|reply| decode_any(reply.as_bytes()).unwrap().kind()).collect();
        let (opened, observed) = (Kind::SessionOpened, Kind::ObservationFrame);
        let said = [opened, observed, opened, observed, Kind::SessionClosed, Kind::Error];
        assert_eq!(kinds, said);
        assert!(service.open_sessions().eq(["b"]));
        session(&input);
    }
}
