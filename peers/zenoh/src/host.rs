//! The session services behind a [`ControlServer`](crate::ControlServer).

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex};

use ncp_spec::session::{SessionService, SimulationBackend};
use ncp_spec::wire::Text;

use crate::control::session_of;
use crate::intake::lock;

/// One service a session, each with a backend of its own, so that a long run holds up nobody else. `[NCP-TRANS-007]`
pub struct SessionHost<B> {
    backend: fn() -> B,
    sessions: Mutex<BTreeMap<Text, Arc<Mutex<SessionService<B>>>>>,
}

impl<B: SimulationBackend> SessionHost<B> {
    /// A host without sessions; `backend` makes what a session runs on.
    pub const fn new(backend: fn() -> B) -> Self {
        Self { backend, sessions: Mutex::new(BTreeMap::new()) }
    }

    /// The one reply to a request, whatever its bytes. `[NCP-SESS-020]`
    pub fn serve(&self, request: &[u8]) -> String {
        // No session is touched by what is no request.
        let Some(session) = session_of(request) else {
            return SessionService::new((self.backend)()).serve(request);
        };
        let service = {
            let mut sessions = lock(&self.sessions);
            let service = sessions.entry(session.clone());
            Arc::clone(service.or_insert_with(|| Arc::new(Mutex::new(SessionService::new((self.backend)())))))
        };
        let mut service = lock(&service);
        let reply = service.serve(request);
        if service.open_sessions().len() == 0 {
            lock(&self.sessions).remove(&session);
        }
        reply
    }

    /// How many sessions are open.
    #[must_use]
    pub fn len(&self) -> usize {
        lock(&self.sessions).len()
    }

    /// Whether no session is open.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}
