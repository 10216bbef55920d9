//! Control RPC: a queryable on `{realm}/rpc`, and a client that asks it.

use std::collections::{HashMap, VecDeque};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::thread;
use std::time::Duration;

use ncp_spec::plane::Plane;
use ncp_spec::reply::check_reply;
use ncp_spec::wire::{ErrorFrame, Frame, MAX_FRAME_BYTES, Message, Text, decode_any};
use zenoh::key_expr::KeyExpr;
use zenoh::query::{ConsolidationMode, Query, Queryable};
use zenoh::{Session, Wait};

use crate::bus::{Bus, BusError};
use crate::intake::lock;
use crate::qos::SeenQos;

/// Sessions with requests in flight; a request beyond is refused.
pub const MAX_LANES: usize = 256;

/// Requests of one session that wait; a request beyond is refused.
pub const MAX_WAITING: usize = 1_024;

/// What a server has done.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ServerCounts {
    /// Requests that came.
    pub requests: u64,
    /// Requests whose handler panicked.
    pub panics: u64,
    /// Requests that were refused unread: too long, or too many at once.
    pub refused: u64,
    /// Replies that Zenoh did not take.
    pub failed: u64,
}

/// Answers the requests of the realm, until it is dropped. `[NCP-TRANS-010]`
///
/// Requests of one session are handled in the order in which they came `[NCP-SESS-036]`, those of different sessions
/// side by side `[NCP-TRANS-007]`. The reply is a frame, also when the handler panics. `[NCP-SESS-020] [NCP-SESS-037]`
pub struct ControlServer {
    lanes: Arc<Lanes>,
    queryable: Option<Queryable<()>>,
}

type Handler = dyn Fn(&[u8]) -> Vec<u8> + Send + Sync;

struct Lanes {
    handler: Box<Handler>,
    /// By session; requests that name none share a lane. A lane is here as long as a thread works on it.
    waiting: Mutex<HashMap<Option<Text>, VecDeque<Query>>>,
    idle: Condvar,
    requests: AtomicU64,
    panics: AtomicU64,
    refused: AtomicU64,
    failed: AtomicU64,
}

impl ControlServer {
    /// Answers on the control key of the realm.
    ///
    /// # Errors
    /// Zenoh refuses.
    pub fn start(bus: &Bus, handler: impl Fn(&[u8]) -> Vec<u8> + Send + Sync + 'static) -> Result<Self, BusError> {
        let lanes = Arc::new(Lanes {
            handler: Box::new(handler),
            waiting: Mutex::default(),
            idle: Condvar::new(),
            requests: AtomicU64::new(0),
            panics: AtomicU64::new(0),
            refused: AtomicU64::new(0),
            failed: AtomicU64::new(0),
        });
        let key = KeyExpr::try_from(bus.keys().rpc()?)?;
        let into = Arc::clone(&lanes);
        let queryable = bus.session().declare_queryable(key).callback(move |query| into.enter(query)).wait()?;
        Ok(Self { lanes, queryable: Some(queryable) })
    }

    /// Takes no more requests, and waits at most so long for those that are in flight; whether all were answered.
    #[must_use]
    pub fn stop(mut self, longest: Duration) -> bool {
        self.queryable = None;
        let waiting = lock(&self.lanes.waiting);
        let waited = self.lanes.idle.wait_timeout_while(waiting, longest, |lanes| !lanes.is_empty());
        !waited.unwrap_or_else(PoisonError::into_inner).1.timed_out()
    }

    /// What it has done so far.
    #[must_use]
    pub fn counts(&self) -> ServerCounts {
        let Lanes { requests, panics, refused, failed, .. } = &*self.lanes;
        let [requests, panics, refused, failed] =
            [requests, panics, refused, failed].map(|count| count.load(Ordering::Relaxed));
        ServerCounts { requests, panics, refused, failed }
    }
}

impl Lanes {
    /// Puts a request behind those of its session. It runs on Zenoh's thread, and does not wait.
    fn enter(self: &Arc<Self>, query: Query) {
        self.requests.fetch_add(1, Ordering::Relaxed);
        let session = match query.payload() {
            Some(payload) if payload.len() > MAX_FRAME_BYTES => return self.refuse(&query, "the request is too long"),
            Some(payload) => session_of(&payload.to_bytes()),
            None => None,
        };
        let mut lanes = lock(&self.waiting);
        let (is_new, is_full) = (!lanes.contains_key(&session), lanes.len() >= MAX_LANES);
        if is_new && is_full {
            drop(lanes);
            return self.refuse(&query, "too many sessions have requests in flight");
        }
        let lane = lanes.entry(session.clone()).or_default();
        if lane.len() >= MAX_WAITING {
            drop(lanes);
            return self.refuse(&query, "too many requests of this session wait");
        }
        lane.push_back(query);
        drop(lanes);
        if is_new {
            let lanes = Arc::clone(self);
            thread::spawn(move || lanes.work(&session));
        }
    }

    /// Answers the requests of a session until none waits.
    fn work(&self, session: &Option<Text>) {
        loop {
            let query = {
                let mut lanes = lock(&self.waiting);
                match lanes.get_mut(session).and_then(VecDeque::pop_front) {
                    Some(query) => query,
                    None => {
                        lanes.remove(session);
                        self.idle.notify_all();
                        return;
                    }
                }
            };
            let request = query.payload().map(|payload| payload.to_bytes()).unwrap_or_default();
            let reply = catch_unwind(AssertUnwindSafe(|| (self.handler)(&request)));
            let reply = reply.unwrap_or_else(|_| {
                self.panics.fetch_add(1, Ordering::Relaxed);
                failure("the server failed") // [NCP-SESS-037]
            });
            self.reply(&query, reply);
        }
    }

    fn refuse(&self, query: &Query, why: &'static str) {
        self.refused.fetch_add(1, Ordering::Relaxed);
        self.reply(query, failure(why));
    }

    /// The reply goes out with the quality of service of its query.
    fn reply(&self, query: &Query, reply: Vec<u8>) {
        if query.reply(query.key_expr(), reply).wait().is_err() {
            self.failed.fetch_add(1, Ordering::Relaxed);
        }
    }
}

/// The session that a request names, if it is one.
pub(crate) fn session_of(request: &[u8]) -> Option<Text> {
    match decode_any(request) {
        Ok(Message::OpenSession(request)) => Some(request.session_id),
        Ok(Message::StepRequest(request)) => Some(request.session_id),
        Ok(Message::RunRequest(request)) => Some(request.session_id),
        Ok(Message::CloseSession(request)) => Some(request.session_id),
        _ => None,
    }
}

fn failure(why: &'static str) -> Vec<u8> {
    let frame = ErrorFrame { error: Text::Borrowed(why), session_id: None };
    frame.encode().unwrap_or_default().into_bytes()
}

/// Asks the server of a realm.
pub struct ControlClient {
    session: Session,
    key: KeyExpr<'static>,
    timeout: Duration,
    qos: SeenQos,
}

impl ControlClient {
    /// A client that waits at most so long for a reply.
    ///
    /// # Errors
    /// None today but a key that Zenoh refuses.
    pub fn new(bus: &Bus, timeout: Duration) -> Result<Self, BusError> {
        let key = KeyExpr::try_from(bus.keys().rpc()?)?;
        Ok(Self { session: bus.session().clone(), key, timeout, qos: Plane::Control.qos().into() })
    }

    /// The same client with another quality of service, for showing what a wrong one looks like.
    #[must_use]
    pub fn with_qos(self, qos: SeenQos) -> Self {
        Self { qos, ..self }
    }

    /// Sends a request, and gives the reply if it is one to it.
    ///
    /// # Errors
    /// The request cannot be sent, nobody answers, or the reply is not accepted (chapter 4.1).
    pub fn ask(&self, request: &Message) -> Result<Message, BusError> {
        let reply = self.ask_bytes(request.encode()?)?;
        Ok(check_reply(request, &reply)?)
    }

    /// Sends bytes, and gives those of the first reply.
    ///
    /// # Errors
    /// They are too many, nobody answers in time, or the call fails.
    pub fn ask_bytes(&self, request: impl Into<Vec<u8>>) -> Result<Vec<u8>, BusError> {
        let request = request.into();
        if request.len() > MAX_FRAME_BYTES {
            return Err(BusError::TooLong { len: request.len(), limit: MAX_FRAME_BYTES });
        }
        let Self { session, key, timeout, qos: SeenQos { congestion, priority, express } } = self;
        let query = session.get(key).payload(request).timeout(*timeout).consolidation(ConsolidationMode::None);
        let replies = query.congestion_control(*congestion).priority(*priority).express(*express).wait()?;
        match replies.recv().map(zenoh::query::Reply::into_result) {
            Ok(Ok(sample)) => Ok(sample.payload().to_bytes().into_owned()),
            // Zenoh says by an error reply, too, that the time is up.
            Ok(Err(error)) if &*error.payload().to_bytes() == b"Timeout" => Err(BusError::NoReply(*timeout)),
            Ok(Err(error)) => Err(BusError::Failed(String::from_utf8_lossy(&error.payload().to_bytes()).into_owned())),
            Err(_) => Err(BusError::NoReply(*timeout)),
        }
    }
}
