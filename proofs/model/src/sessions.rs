//! The life of sessions at a server.
//!
//! Two clients know two sessions; each may ask to open, step and close either. The network delivers any
//! request that any of them may send, any number of times, in any order, or never; some arrive torn;
//! the server may start anew, and then knows no session. The server is the specification's service,
//! over bytes. Nothing of it is abstracted: a state is all that the server was given.

use std::collections::BTreeMap;

use ncp_spec::reply::check_reply;
use ncp_spec::session::{BackendError, Opened, SessionService, Simulation, SimulationBackend};
use ncp_spec::wire::{ChannelMap, Message, Observation, OpenSession, SortedMap, decode_any};
use ncp_text::WIRE_VERSION;
use serde_json::{Value, json};
use stateright::{Model, Property};

use crate::explore::{Claim, Protocol, Replay, Variant, case, pattern};
use crate::signs::{Signs, always, sometimes};

const SESSIONS: [&str; 2] = ["a", "b"];

/// What a client asks for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Ask {
    Open,
    Step,
    Close,
}

/// What reaches the server next.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Event {
    /// A request for one of `SESSIONS`.
    Request(Ask, usize),
    /// A request of which only a part arrives.
    Torn,
    /// The server starts anew.
    Restart,
}

/// All that happened, and what the last event showed.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(crate) struct State {
    events: Vec<Event>,
    /// By the text: the steps since it was opened of each session that is open.
    open: BTreeMap<usize, i64>,
    last: Signs,
}

mod sign {
    pub(super) const NO_REPLY: u16 = 1;
    pub(super) const WRONG_STEP: u16 = 1 << 1;
    pub(super) const WRONG_OPEN: u16 = 1 << 2;
    pub(super) const WRONG_CLOSE: u16 = 1 << 3;
    pub(super) const WRONG_SEQ: u16 = 1 << 4;
    pub(super) const WRONG_CLIENT: u16 = 1 << 5;
    pub(super) const STEPPED: u16 = 1 << 6;
    pub(super) const REFUSED: u16 = 1 << 7;
    pub(super) const REOPENED: u16 = 1 << 8;
    pub(super) const CLOSED: u16 = 1 << 9;
    pub(super) const TORN: u16 = 1 << 10;
    pub(super) const BOTH: u16 = 1 << 11;
}
use sign::*;

/// What is broken in a server or, in the last two, in a client.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Defect {
    SilentToTorn,
    CloseKeeps,
    StepOpens,
    OpenReplaces,
    SecondCloseSucceeds,
    OneSession,
    SeqStands,
    RestartRemembers,
    ClientTakesErrors,
}

/// A server that is given events.
struct Server {
    service: SessionService<Clock>,
    defect: Option<Defect>,
}

impl Server {
    fn new(defect: Option<Defect>) -> Self {
        let service = SessionService::new(Clock);
        Self { service, defect }
    }

    /// The replies to an event: one to a request.
    fn take(&mut self, event: Event) -> Vec<String> {
        let Some(text) = text(event) else {
            if self.defect != Some(Defect::RestartRemembers) {
                self.service = SessionService::new(Clock);
            }
            return vec![];
        };
        let ask = |ask, session| text_of(Event::Request(ask, session));
        let serve = |service: &mut SessionService<Clock>, text: &str| service.serve(text.as_bytes());
        match (self.defect, event) {
            (Some(Defect::SilentToTorn), Event::Torn) => vec![],
            (Some(Defect::CloseKeeps), Event::Request(Ask::Close, session)) => {
                let is_open = self.service.open_sessions().any(|id| id == SESSIONS[session]);
                vec![json!({"kind": "session_closed", "session_id": SESSIONS[session], "ok": is_open}).to_string()]
            }
            (Some(Defect::StepOpens), Event::Request(Ask::Step, session)) => {
                serve(&mut self.service, &ask(Ask::Open, session));
                vec![serve(&mut self.service, &text)]
            }
            (Some(Defect::OpenReplaces), Event::Request(Ask::Open, session)) => {
                serve(&mut self.service, &ask(Ask::Close, session));
                vec![serve(&mut self.service, &text)]
            }
            (Some(Defect::SecondCloseSucceeds), Event::Request(Ask::Close, _)) => {
                vec![serve(&mut self.service, &text).replace("\"ok\":false", "\"ok\":true")]
            }
            (Some(Defect::OneSession), Event::Request(wanted, 1)) => {
                let reply = serve(&mut self.service, &ask(wanted, 0));
                vec![reply.replace("\"session_id\":\"a\"", "\"session_id\":\"b\"")]
            }
            (Some(Defect::SeqStands), Event::Request(Ask::Step, _)) => {
                vec![serve(&mut self.service, &text).replace("\"seq\":2", "\"seq\":1")]
            }
            _ => vec![serve(&mut self.service, &text)],
        }
    }

    /// Whether a client takes a reply for a success.
    fn accepts(&self, request: &Message, reply: &str) -> bool {
        if self.defect == Some(Defect::ClientTakesErrors) {
            return true;
        }
        check_reply(request, reply.as_bytes()).is_ok()
    }
}

/// A simulator that only counts time.
struct Clock;

struct Running(f64);

impl SimulationBackend for Clock {
    fn name(&self) -> &str {
        "clock"
    }

    fn open(&mut self, _: &OpenSession) -> Result<Opened, BackendError> {
        Ok(Opened { simulation: Box::new(Running(0.0)), resolved: SortedMap::default(), seed: None })
    }
}

impl Simulation for Running {
    fn stimulate(&mut self, _: &ChannelMap) -> Result<(), BackendError> {
        Ok(())
    }

    fn advance(&mut self, advance_ms: f64) -> Result<SortedMap<Observation>, BackendError> {
        self.0 += advance_ms;
        Ok(SortedMap::default())
    }

    fn time_ms(&self) -> f64 {
        self.0
    }
}

/// The model: how much reaches the server, and what it is.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Service {
    defect: Option<Defect>,
    events: usize,
}

impl Model for Service {
    type State = State;
    type Action = Event;

    fn init_states(&self) -> Vec<State> {
        vec![State { events: vec![], open: BTreeMap::new(), last: Signs::default() }]
    }

    fn actions(&self, state: &State, actions: &mut Vec<Event>) {
        if state.events.len() == self.events {
            return;
        }
        for ask in [Ask::Open, Ask::Step, Ask::Close] {
            actions.extend((0..SESSIONS.len()).map(|session| Event::Request(ask, session)));
        }
        actions.extend([Event::Torn, Event::Restart]);
    }

    fn next_state(&self, before: &State, event: Event) -> Option<State> {
        let mut server = Server::new(self.defect);
        for &event in &before.events {
            server.take(event);
        }
        let replies = server.take(event);
        let mut state = before.clone();
        state.events.push(event);
        state.last = judge(&mut state.open, &server, event, &replies);
        Some(state)
    }

    fn properties(&self) -> Vec<Property<Self>> {
        vec![
            always!("one reply", NO_REPLY),
            always!("steps only while open", WRONG_STEP),
            always!("opens once", WRONG_OPEN),
            always!("closes once", WRONG_CLOSE),
            always!("seq and time", WRONG_SEQ),
            always!("client knows success", WRONG_CLIENT),
            sometimes!("a session steps", STEPPED),
            sometimes!("a step is refused after a close or before an open", REFUSED),
            sometimes!("a session is opened twice", REOPENED),
            sometimes!("a session closes", CLOSED),
            sometimes!("a torn request arrives", TORN),
            sometimes!("both sessions are open", BOTH),
        ]
    }
}

/// What the text says of the replies to an event.
fn judge(open: &mut BTreeMap<usize, i64>, server: &Server, event: Event, replies: &[String]) -> Signs {
    let mut said = Signs::default();
    if event == Event::Restart {
        open.clear();
        return said;
    }
    let decoded = replies.first().map(|reply| decode_any(reply.as_bytes()));
    let (1, Some(Ok(reply))) = (replies.len(), decoded) else {
        said.tell(true, NO_REPLY);
        return said;
    };
    let is_error = matches!(reply, Message::Error(_));
    let Event::Request(ask, session) = event else {
        said.tell(!is_error, NO_REPLY);
        said.tell(true, TORN);
        return said;
    };
    let was_open = open.get(&session).copied();
    let succeeds = match (ask, &reply) {
        (Ask::Open, Message::SessionOpened(reply)) => {
            said.tell(reply.session_id != SESSIONS[session], NO_REPLY);
            said.tell(reply.ok == was_open.is_some(), WRONG_OPEN);
            said.tell(was_open.is_some(), REOPENED);
            if was_open.is_none() {
                open.insert(session, 0);
            }
            reply.ok
        }
        (Ask::Step, Message::ObservationFrame(reply)) => {
            said.tell(reply.session_id != SESSIONS[session], NO_REPLY);
            said.tell(was_open.is_none(), WRONG_STEP);
            if let Some(steps) = open.get_mut(&session) {
                *steps += 1;
                // One step is 10 ms.
                let time_ms = f64::from(i32::try_from(*steps).unwrap_or(0)) * 10.0;
                said.tell(reply.seq != *steps || reply.sim_time_ms != time_ms, WRONG_SEQ);
                said.tell(true, STEPPED);
            }
            true
        }
        (Ask::Step, Message::Error(_)) => {
            said.tell(was_open.is_some(), WRONG_STEP);
            said.tell(true, REFUSED);
            false
        }
        (Ask::Close, Message::SessionClosed(reply)) => {
            said.tell(reply.session_id != SESSIONS[session], NO_REPLY);
            said.tell(reply.ok != was_open.is_some(), WRONG_CLOSE);
            said.tell(reply.ok, CLOSED);
            open.remove(&session);
            reply.ok
        }
        (Ask::Close, Message::Error(_)) => {
            said.tell(was_open.is_some(), WRONG_CLOSE);
            false
        }
        _ => {
            said.tell(true, NO_REPLY);
            return said;
        }
    };
    said.tell(open.len() == SESSIONS.len(), BOTH);
    let request = text(event).map(|text| decode_any(text.as_bytes()));
    if let (Some(Ok(request)), Some(reply)) = (request, replies.first()) {
        said.tell(server.accepts(&request, reply) != succeeds, WRONG_CLIENT);
    }
    said
}

/// The server's side of the protocol.
pub(crate) enum Sessions {}

impl Protocol for Sessions {
    type Defect = Defect;
    type Model = Service;

    const FAMILY: &'static str = "session";
    const CLAIMS: &'static [Claim] = &[
        Claim {
            name: "one reply",
            rules: &["NCP-SESS-020", "NCP-SESS-021", "NCP-SESS-036"],
            sentence: "Each request that arrives is answered by exactly one frame, of the kind that answers it or an \
                error, with its session id; a torn one by an error.",
            formal: "always: arrival of a request ⟹ |replies| = 1 ∧ kind and session_id fit",
        },
        Claim {
            name: "steps only while open",
            rules: &["NCP-SESS-026", "NCP-SESS-027", "NCP-SESS-035"],
            sentence: "A step succeeds exactly for a session that is open: none that was never opened, was closed, \
                or was lost with a restart.",
            formal: "always: reply to step is an observation_frame ⟺ open(session)",
        },
        Claim {
            name: "opens once",
            rules: &["NCP-SESS-024", "NCP-SESS-030"],
            sentence: "An open succeeds exactly for a session that is not open.",
            formal: "always: ok(open) ⟺ ¬open(session)",
        },
        Claim {
            name: "closes once",
            rules: &["NCP-SESS-028", "NCP-SESS-029"],
            sentence: "A close succeeds exactly for a session that is open.",
            formal: "always: ok(close) ⟺ open(session)",
        },
        Claim {
            name: "seq and time",
            rules: &["NCP-SESS-030", "NCP-SESS-031", "NCP-SESS-033", "NCP-SESS-034", "NCP-SESS-035"],
            sentence: "The n-th step of a session since it was opened has seq n and n steps of simulation time, \
                whatever happens to the other session, and a second open changes nothing.",
            formal: "always: observation ⟹ seq = n ∧ sim_time_ms = 10 n",
        },
        Claim {
            name: "client knows success",
            rules: &["NCP-SESS-001", "NCP-SESS-002", "NCP-SESS-004", "NCP-SESS-005", "NCP-SESS-007"],
            sentence: "A client takes a reply for a success exactly when the server did what was asked.",
            formal: "always: check_reply(request, reply) is ok ⟺ the request succeeded",
        },
    ];
    const BROKEN: &'static [Variant<Defect>] = &[
        (Defect::SilentToTorn, "silent-to-torn", "A request that cannot be decoded gets no reply.", "one reply"),
        (Defect::CloseKeeps, "close-keeps", "A close is answered and does not close.", "steps only while open"),
        (Defect::StepOpens, "step-opens", "A step opens the session that it names.", "steps only while open"),
        (
            Defect::RestartRemembers,
            "restart-remembers",
            "Sessions outlive the server's restart.",
            "steps only while open",
        ),
        (Defect::OpenReplaces, "open-replaces", "A second open begins the session anew.", "opens once"),
        (Defect::SecondCloseSucceeds, "second-close", "A close of a session that is not open succeeds.", "closes once"),
        (Defect::OneSession, "one-session", "Both sessions are one.", "opens once"),
        (Defect::SeqStands, "seq-stands", "The seq does not rise.", "seq and time"),
        (
            Defect::ClientTakesErrors,
            "client-takes-errors",
            "A client takes any reply for a success.",
            "client knows success",
        ),
    ];

    fn models(small: bool) -> Vec<Service> {
        let events = if small { 4 } else { 6 };
        vec![Service { defect: None, events }]
    }

    fn broken(defect: Defect) -> Service {
        Service { defect: Some(defect), events: 4 }
    }

    fn bounds(small: bool) -> String {
        format!(
            "all sequences of at most {} events: open, step and close of either of two sessions, a torn request, a \
             restart of the server",
            Self::models(small)[0].events
        )
    }

    fn replay(defect: Defect, path: &[Event]) -> Replay {
        let run = |defect| {
            let mut server = Server::new(defect);
            let replies = |event: &Event| {
                let replies = server.take(*event);
                let request = text(*event).and_then(|text| decode_any(text.as_bytes()).ok());
                let taken = request.zip(replies.first()).map(|(request, reply)| server.accepts(&request, reply));
                json!({"replies": replies, "a client takes it for a success": taken})
            };
            path.iter().map(replies).collect::<Value>()
        };
        // The call knows no restart, and judges no client.
        let is_shown = !path.contains(&Event::Restart) && defect != Defect::ClientTakesErrors;
        Replay::new(path, defect, run, |_| is_shown.then(|| vector(path)))
    }
}

/// The request as it arrives; none for a restart.
fn text(event: Event) -> Option<String> {
    (event != Event::Restart).then(|| text_of(event))
}

fn text_of(event: Event) -> String {
    match event {
        Event::Request(Ask::Open, session) => format!(
            "{{\"kind\":\"open_session\",\"ncp_version\":\"{WIRE_VERSION}\",\"session_id\":\"{}\",\
             \"network\":{{\"kind\":\"builtin\",\"ref\":\"ncp.reference.lif\"}}}}",
            SESSIONS[session]
        ),
        Event::Request(Ask::Step, session) => {
            format!(r#"{{"kind":"step_request","session_id":"{}","advance_ms":10.0}}"#, SESSIONS[session])
        }
        Event::Request(Ask::Close, session) => {
            format!(r#"{{"kind":"close_session","session_id":"{}"}}"#, SESSIONS[session])
        }
        Event::Torn | Event::Restart => r#"{"kind":"step_request","session_id":"a""#.to_owned(),
    }
}

fn vector(path: &[Event]) -> Value {
    let mut server = Server::new(None);
    let mut replies = vec![];
    for event in path {
        for reply in server.take(*event) {
            let reply: Value = serde_json::from_str(&reply).unwrap_or_default();
            let mut known = serde_json::Map::new();
            for member in ["kind", "session_id", "ok", "seq", "sim_time_ms"] {
                if let Some(value) = reply.get(member) {
                    known.insert(member.to_owned(), value.clone());
                }
            }
            replies.push(json!({"$json": known}));
        }
    }
    let requests: Vec<String> = path.iter().filter_map(|event| text(*event)).collect();
    case("server", "session.run", json!({"requests": requests}), pattern(json!({"replies": replies})))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::explore::{check, refute};

    #[test]
    fn the_service_keeps_its_claims() {
        for checked in check::<Sessions>(true) {
            assert!(checked.is_proved(), "{checked:?}");
        }
    }

    #[test]
    fn every_broken_service_is_refuted() {
        for broken in refute::<Sessions>() {
            assert!(broken.is_refuted(), "{broken:?}");
        }
    }
}
