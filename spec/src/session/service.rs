//! The service: requests in, replies out.

use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};

use super::backend::{BackendError, Simulation, SimulationBackend};
use crate::version::check_version;
use crate::wire::{
    ChannelMap, CloseSession, DecodeError, ErrorFrame, Kind, Message, ObservationFrame, OpenSession, SessionClosed,
    SessionOpened, SimProvenance, StimulusFrame, Text, decode_any, decode_any_strict,
};

/// Serves sessions over one backend.
pub struct SessionService<B> {
    backend: B,
    sessions: BTreeMap<Text, Session>,
    is_strict: bool,
}

struct Session {
    simulation: Box<dyn Simulation + Send>,
    chunk_ms: f64,
    seq: i64,
}

impl<B: SimulationBackend> SessionService<B> {
    /// A service without sessions.
    pub const fn new(backend: B) -> Self {
        Self { backend, sessions: BTreeMap::new(), is_strict: false }
    }

    /// A service without sessions that keeps the strict profile (chapter 12.1): every request has a
    /// compatible version.
    pub const fn strict(backend: B) -> Self {
        Self { backend, sessions: BTreeMap::new(), is_strict: true }
    }

    /// The one reply to a request, whatever its bytes. `[NCP-SESS-020]`
    pub fn serve(&mut self, request: &[u8]) -> String {
        let reply = self.reply(request, |_| true);
        written(&reply)
    }

    /// The one reply to a request that came at the strict profile's control key of a kind, see
    /// [`Keys::rpc_verb`](crate::keys::Keys::rpc_verb). A request of another kind is not carried
    /// out. `[NCP-STRICT-007]`
    pub fn serve_at(&mut self, verb: Kind, request: &[u8]) -> String {
        let reply = self.reply(request, |kind| kind == verb);
        written(&reply)
    }

    fn reply(&mut self, frame: &[u8], comes_right: impl FnOnce(Kind) -> bool) -> Message {
        let request = match decode_any(frame) {
            Ok(request) => request,
            Err(error) => return failure(None, error), // [NCP-SESS-021]
        };
        if !comes_right(request.kind()) {
            return failure(None, format_args!("this is not the key of {}", request.kind()));
        }
        if self.is_strict
            && let Err(error) = decode_any_strict(frame)
        {
            return self.refuse(&request, error);
        }
        self.answer(request)
    }

    /// The reply to a request that only the strict profile rejects.
    fn refuse(&self, request: &Message, error: DecodeError) -> Message {
        match request {
            Message::OpenSession(request) => {
                Message::SessionOpened(self.not_opened(request, error)) // [NCP-STRICT-008]
            }
            _ => failure(None, error), // [NCP-STRICT-009]
        }
    }

    /// The ids of the open sessions.
    pub fn open_sessions(&self) -> impl ExactSizeIterator<Item = &str> {
        self.sessions.keys().map(AsRef::as_ref)
    }

    fn answer(&mut self, request: Message) -> Message {
        match request {
            Message::OpenSession(request) => Message::SessionOpened(self.open(&request)),
            Message::StepRequest(request) => {
                self.run(&request.session_id, request.advance_ms, request.stimulus.as_ref())
            }
            Message::RunRequest(request) => {
                self.run(&request.session_id, Some(request.duration_ms), request.stimulus.as_ref())
            }
            Message::CloseSession(request) => Message::SessionClosed(self.close(&request)),
            // [NCP-SESS-022]
            other => failure(None, format_args!("{} is no request", other.kind().as_str())),
        }
    }

    fn open(&mut self, request: &OpenSession) -> SessionOpened {
        // [NCP-SESS-023] [NCP-SESS-024] The contract hash is not looked at. [NCP-SESS-025]
        if let Err(error) = check_version(&request.ncp_version, true) {
            return self.not_opened(request, error);
        }
        // [NCP-SESS-030]
        if self.sessions.contains_key(&request.session_id) {
            let why = format_args!("the session {:?} is open already", request.session_id);
            return self.not_opened(request, why);
        }
        let backend = &mut self.backend;
        let opened = match guarded(|| backend.open(request)) {
            Ok(opened) => opened,
            Err(error) => return self.not_opened(request, error),
        };
        let session = Session { simulation: opened.simulation, chunk_ms: request.sim.chunk_ms, seq: 0 };
        self.sessions.insert(request.session_id.clone(), session);
        let backend: Text = self.backend.name().to_owned().into();
        SessionOpened {
            session_id: request.session_id.clone(),
            backend: backend.clone(),
            resolved: opened.resolved,
            // [NCP-SESS-039] [NCP-PROV-007]
            provenance: Some(SimProvenance {
                network_ref: request.network.reference.clone(),
                backend,
                seed: opened.seed,
                ..SimProvenance::default()
            }),
            ..SessionOpened::default()
        }
    }

    fn not_opened(&self, request: &OpenSession, why: impl std::fmt::Display) -> SessionOpened {
        SessionOpened {
            session_id: request.session_id.clone(),
            ok: false,
            backend: self.backend.name().to_owned().into(),
            error: Some(why.to_string().into()),
            ..SessionOpened::default()
        }
    }

    /// `[NCP-SESS-026] [NCP-SESS-027] [NCP-SESS-031] [NCP-SESS-035]`
    fn run(&mut self, session_id: &Text, advance_ms: Option<f64>, stimulus: Option<&StimulusFrame>) -> Message {
        let Some(session) = self.sessions.get_mut(session_id) else {
            return failure(Some(session_id), format_args!("the session {session_id:?} is not open"));
        };
        let advance_ms = advance_ms.unwrap_or(session.chunk_ms);
        // [NCP-SESS-032]
        if !(advance_ms.is_finite() && advance_ms >= 0.0) {
            let name = "advance_ms";
            let value_ms = advance_ms;
            return failure(Some(session_id), BackendError::Time { name, value_ms });
        }
        let none = ChannelMap::new();
        let values = stimulus.map_or(&none, |frame| &frame.values);
        let records = guarded(|| {
            session.simulation.check_advance(advance_ms)?;
            session.simulation.stimulate(values)?;
            session.simulation.advance(advance_ms)
        });
        match records {
            Ok(records) => {
                session.seq = session.seq.saturating_add(1); // [NCP-SESS-034]
                let sim_time_ms = session.simulation.time_ms(); // [NCP-SESS-033]
                Message::ObservationFrame(ObservationFrame {
                    session_id: session_id.clone(),
                    seq: session.seq,
                    t: sim_time_ms / 1000.0,
                    sim_time_ms,
                    records,
                    ..ObservationFrame::default()
                })
            }
            Err(error) => failure(Some(session_id), error), // [NCP-SESS-037]
        }
    }

    /// `[NCP-SESS-028] [NCP-SESS-029]`
    fn close(&mut self, request: &CloseSession) -> SessionClosed {
        SessionClosed {
            session_id: request.session_id.clone(),
            ok: self.sessions.remove(&request.session_id).is_some(),
            ..SessionClosed::default()
        }
    }
}

fn written(reply: &Message) -> String {
    reply.encode().unwrap_or_else(|error| {
        // The backend gave what no frame can hold. [NCP-SESS-037]
        let reply = failure(None, error);
        reply.encode().unwrap_or_else(|_| r#"{"kind":"error","error":"no reply"}"#.to_owned())
    })
}

fn failure(session_id: Option<&Text>, error: impl std::fmt::Display) -> Message {
    Message::Error(ErrorFrame { error: error.to_string().into(), session_id: session_id.cloned() })
}

/// Runs what a backend does; its panic costs the request and no more. `[NCP-SESS-037]`
fn guarded<T>(run: impl FnOnce() -> Result<T, BackendError>) -> Result<T, String> {
    match catch_unwind(AssertUnwindSafe(run)) {
        Ok(done) => done.map_err(|error| error.to_string()),
        Err(_) => Err("the simulator failed".to_owned()),
    }
}
