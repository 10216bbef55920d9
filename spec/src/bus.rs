//! The model of a transport: a bus within one process, with queryable RPC, publish and subscribe, and Zenoh's key
//! matching.
//!
//! It does what chapter 11 asks of any transport, and no more: nothing leaves the process. The tests and the examples
//! that need a transport run on it. Publishing never waits for a subscriber: a full queue drops its oldest frame.
//! `[NCP-TRANS-009]`

use std::collections::VecDeque;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, Weak};

use thiserror::Error;

use crate::keys::{KeyError, Keys, matches};
use crate::reply::{ReplyError, check_reply, check_reply_strict};
use crate::wire::{
    CloseSession, EncodeError, Kind, Message, ObservationFrame, OpenSession, RunRequest, SessionClosed, SessionOpened,
    StepRequest, Text,
};

/// How many frames a subscription keeps that nobody has taken.
pub const QUEUE_FRAMES: usize = 1_024;

type Handler = dyn FnMut(&[u8]) -> Vec<u8> + Send;

/// The bus. Clones share it.
#[derive(Clone, Default)]
pub struct LocalBus {
    shared: Arc<Mutex<Shared>>,
}

#[derive(Default)]
struct Shared {
    queues: Vec<Weak<Queue>>,
    servers: Vec<Weak<Server>>,
}

struct Queue {
    pattern: String,
    frames: Mutex<VecDeque<Delivery>>,
}

struct Server {
    key: String,
    handler: Mutex<Box<Handler>>,
}

/// A frame that a subscription received.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Delivery {
    /// The key on which it was published.
    pub key: String,
    /// Its bytes, as they were published. `[NCP-TRANS-001]`
    pub frame: Arc<[u8]>,
}

/// Why the bus, or a client on it, could not.
#[derive(Debug, Error)]
pub enum BusError {
    /// A key or a pattern is not a key expression.
    #[error(transparent)]
    Key(#[from] KeyError),
    /// Nobody answers on this key.
    #[error("nobody answers on {key:?}")]
    NoServer {
        /// The key.
        key: String,
    },
    /// The request cannot be written.
    #[error(transparent)]
    Encode(#[from] EncodeError),
    /// The reply is not accepted.
    #[error(transparent)]
    Reply(#[from] ReplyError),
}

impl LocalBus {
    /// A bus with nobody on it.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Hands a frame to every subscription whose pattern matches the key; to how many.
    ///
    /// # Errors
    /// The key is not one.
    pub fn publish(&self, key: &str, frame: &[u8]) -> Result<usize, BusError> {
        matches(key, key)?;
        let frame: Arc<[u8]> = frame.into();
        let mut delivered = 0;
        for queue in self.queues() {
            if matches(&queue.pattern, key)? {
                let mut frames = lock(&queue.frames);
                if frames.len() == QUEUE_FRAMES {
                    frames.pop_front();
                }
                frames.push_back(Delivery { key: key.to_owned(), frame: Arc::clone(&frame) });
                delivered += 1;
            }
        }
        Ok(delivered)
    }

    /// Subscribes to the keys that a pattern covers, until the handle is dropped. `[NCP-TRANS-008]`
    ///
    /// # Errors
    /// The pattern is not a key expression.
    pub fn subscribe(&self, pattern: &str) -> Result<Subscription, BusError> {
        matches(pattern, "ncp")?;
        let queue = Arc::new(Queue { pattern: pattern.to_owned(), frames: Mutex::new(VecDeque::new()) });
        lock(&self.shared).queues.push(Arc::downgrade(&queue));
        Ok(Subscription { queue })
    }

    /// Answers the requests on a key, until the handle is dropped. `[NCP-TRANS-010]`
    ///
    /// # Errors
    /// The key is not one.
    pub fn serve(
        &self,
        key: &str,
        handler: impl FnMut(&[u8]) -> Vec<u8> + Send + 'static,
    ) -> Result<Serving, BusError> {
        matches(key, key)?;
        let server = Arc::new(Server { key: key.to_owned(), handler: Mutex::new(Box::new(handler)) });
        lock(&self.shared).servers.push(Arc::downgrade(&server));
        Ok(Serving { _server: server })
    }

    /// Asks whoever serves a key.
    ///
    /// # Errors
    /// Nobody does.
    pub fn query(&self, key: &str, request: &[u8]) -> Result<Vec<u8>, BusError> {
        let server = {
            let mut shared = lock(&self.shared);
            shared.servers.retain(|server| server.strong_count() > 0);
            shared.servers.iter().filter_map(Weak::upgrade).find(|server| server.key == key)
        };
        let server = server.ok_or_else(|| BusError::NoServer { key: key.to_owned() })?;
        let mut handler = lock(&server.handler);
        Ok(handler(request))
    }

    fn queues(&self) -> Vec<Arc<Queue>> {
        let mut shared = lock(&self.shared);
        shared.queues.retain(|queue| queue.strong_count() > 0);
        shared.queues.iter().filter_map(Weak::upgrade).collect()
    }
}

/// Frames of the keys that a pattern covers. Dropping it ends it.
pub struct Subscription {
    queue: Arc<Queue>,
}

impl Subscription {
    /// The oldest frame that was not taken yet.
    #[must_use]
    pub fn next_frame(&self) -> Option<Delivery> {
        lock(&self.queue.frames).pop_front()
    }
}

/// A key that is served. Dropping it ends that.
pub struct Serving {
    _server: Arc<Server>,
}

/// A client of the simulation service. It closes, on its own account, only sessions that it opened.
/// `[NCP-SESS-040]`
pub struct NeuroSimClient {
    bus: LocalBus,
    keys: Keys,
    is_strict: bool,
    opened: Vec<Text>,
}

impl NeuroSimClient {
    /// A client in a realm; none: the default one.
    ///
    /// # Errors
    /// The realm is not one.
    pub fn new(bus: LocalBus, realm: Option<&str>) -> Result<Self, BusError> {
        Ok(Self { bus, keys: Keys::new(realm)?, is_strict: false, opened: Vec::new() })
    }

    /// A client that keeps the strict profile (chapter 12.1): it asks each request at the key of its
    /// kind, and accepts no reply without a version.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn strict(bus: LocalBus, realm: Option<&str>) -> Result<Self, BusError> {
        let client = Self::new(bus, realm)?;
        Ok(Self { is_strict: true, ..client })
    }

    /// Opens a session.
    ///
    /// # Errors
    /// The request cannot be sent, or its reply is not accepted.
    pub fn open(&mut self, request: OpenSession) -> Result<SessionOpened, BusError> {
        let id = request.session_id.clone();
        match self.ask(&Message::OpenSession(request))? {
            Message::SessionOpened(opened) => {
                self.opened.push(id);
                Ok(opened)
            }
            other => Err(unfitting(Kind::SessionOpened, &other)),
        }
    }

    /// Advances a session.
    ///
    /// # Errors
    /// As [`open`](Self::open).
    pub fn step(&self, request: StepRequest) -> Result<ObservationFrame, BusError> {
        self.observe(&Message::StepRequest(request))
    }

    /// Runs a session for a stated time.
    ///
    /// # Errors
    /// As [`open`](Self::open).
    pub fn run(&self, request: RunRequest) -> Result<ObservationFrame, BusError> {
        self.observe(&Message::RunRequest(request))
    }

    /// Closes a session if this client opened it; none, and nothing is sent, if it did not.
    ///
    /// # Errors
    /// As [`open`](Self::open).
    pub fn close(&mut self, session_id: &str) -> Result<Option<SessionClosed>, BusError> {
        let Some(at) = self.opened.iter().position(|id| id == session_id) else {
            return Ok(None);
        };
        let request = CloseSession { session_id: session_id.to_owned().into(), ..CloseSession::default() };
        let reply = self.ask(&Message::CloseSession(request));
        // Whatever the server says, the session is not this client's any more; if none was asked, it is.
        if !matches!(reply, Err(BusError::NoServer { .. })) {
            self.opened.remove(at);
        }
        match reply? {
            Message::SessionClosed(closed) => Ok(Some(closed)),
            other => Err(unfitting(Kind::SessionClosed, &other)),
        }
    }

    fn observe(&self, request: &Message) -> Result<ObservationFrame, BusError> {
        match self.ask(request)? {
            Message::ObservationFrame(frame) => Ok(frame),
            other => Err(unfitting(Kind::ObservationFrame, &other)),
        }
    }

    fn ask(&self, request: &Message) -> Result<Message, BusError> {
        let (key, check): (_, fn(&Message, &[u8]) -> _) = if self.is_strict {
            (self.keys.rpc_verb(request.kind())?, check_reply_strict) // [NCP-STRICT-001]
        } else {
            (self.keys.rpc()?, check_reply)
        };
        let reply = self.bus.query(&key, request.encode()?.as_bytes())?;
        Ok(check(request, &reply)?)
    }
}

fn unfitting(expected: Kind, reply: &Message) -> BusError {
    ReplyError::Kind { expected, found: reply.kind() }.into()
}

/// A handler that panicked left its own state in doubt, not the bus's.
fn lock<T: ?Sized>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::session::{ReferenceBackend, SessionService};
    use crate::wire::NetworkRef;

    /// `[NCP-SESS-040]`
    #[test]
    fn a_session_whose_close_never_reached_a_server_is_still_the_clients_to_close() {
        let bus = LocalBus::new();
        let service = Arc::new(Mutex::new(SessionService::new(ReferenceBackend)));
        let serve = |bus: &LocalBus| {
            let service = Arc::clone(&service);
            bus.serve("ncp/rpc", move |request| lock(&service).serve(request).into_bytes()).unwrap()
        };
        let mut client = NeuroSimClient::new(bus.clone(), None).unwrap();
        let serving = serve(&bus);
        let network = NetworkRef { reference: "ncp.reference.rate".into(), ..NetworkRef::default() };
        let request = OpenSession { session_id: "s".into(), network, ..OpenSession::default() };
        client.open(request).unwrap();
        drop(serving);
        assert!(matches!(client.close("s"), Err(BusError::NoServer { .. })));
        let _serving = serve(&bus);
        assert!(client.close("s").unwrap().unwrap().ok);
        // A second close would close somebody else's session.
        assert!(client.close("s").unwrap().is_none());
        assert_eq!(lock(&service).open_sessions().len(), 0);
    }

    /// `[NCP-SESS-040]`
    #[test]
    fn a_session_that_the_server_has_lost_is_no_more_the_clients() {
        let bus = LocalBus::new();
        let mut client = NeuroSimClient::new(bus.clone(), None).unwrap();
        let opens = r#"{"kind":"session_opened","session_id":"s"}"#;
        let closes = r#"{"kind":"session_closed","session_id":"s","ok":false}"#;
        let _serving = bus
            .serve("ncp/rpc", move |request| {
                let is_open = String::from_utf8_lossy(request).contains("open_session");
                if is_open { opens } else { closes }.into()
            })
            .unwrap();
        let request = OpenSession { session_id: "s".into(), ..OpenSession::default() };
        client.open(request).unwrap();
        assert!(matches!(client.close("s"), Err(BusError::Reply(_))));
        assert!(client.close("s").unwrap().is_none());
    }
}
