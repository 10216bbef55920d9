//! What all front ends share: requests enter, each has one answer, sessions run side by side, and each is in order.

use std::collections::{HashMap, VecDeque};
use std::future::Future;
use std::panic::AssertUnwindSafe;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use futures_util::FutureExt;
use ncp_spec::wire::Text;
use tokio::runtime::Handle;
use tokio::sync::{Notify, oneshot};
use tokio::time::{Instant, timeout};

use crate::bridge::{Bridge, BridgeSettings};
use crate::failure::{Answer, Failure, Refusal};
use crate::metrics::{Front, Metrics};
use crate::request::Request;

/// Requests that are in the gateway at most; one beyond is refused.
pub const MAX_IN_FLIGHT: usize = 1_024;

/// Takes requests of all front ends to the simulation service. Clones are of the same backend.
#[derive(Clone)]
pub struct Backend(Arc<Shared>);

struct Shared {
    bridge: Bridge,
    metrics: Metrics,
    lanes: Mutex<Lanes>,
    /// Told whenever a lane ends.
    ended: Notify,
    runtime: Handle,
}

/// The requests of each session that wait. A lane is here as long as a task works on it.
#[derive(Default)]
struct Lanes {
    waiting: HashMap<Text, VecDeque<Job>>,
    in_flight: usize,
    is_closed: bool,
}

struct Job {
    request: Request,
    front: Front,
    arrived: Instant,
    answer: oneshot::Sender<Answer>,
}

impl Backend {
    /// A backend that works on a runtime.
    pub(crate) fn new(settings: BridgeSettings, metrics: Metrics, runtime: Handle) -> Self {
        let bridge = Bridge::new(settings, metrics.clone());
        Self(Arc::new(Shared { bridge, metrics, lanes: Mutex::default(), ended: Notify::new(), runtime }))
    }

    /// Takes a request at once, behind those of its session that came before `[NCP-SESS-036]`; what is returned waits
    /// for the one answer `[NCP-SESS-020]`. The request goes its way also if nobody waits.
    pub fn submit(&self, front: Front, bytes: &[u8]) -> impl Future<Output = Answer> + Send + use<> {
        let arrived = Instant::now();
        self.0.metrics.came(front);
        let entered = Request::read(bytes).and_then(|request| self.enter(request, front, arrived));
        if let Err(refusal) = &entered {
            self.0.finish(front, arrived, Some(refusal));
        }
        async move {
            match entered {
                Ok(answer) => answer.await.unwrap_or(Err(Refusal { session: None, failure: Failure::Internal })),
                Err(refusal) => Err(refusal),
            }
        }
    }

    /// Counts a request that a front end refuses by itself.
    pub(crate) fn refuse(&self, front: Front, failure: Failure) -> Refusal {
        let refusal = Refusal { session: None, failure };
        self.0.metrics.came(front);
        self.0.finish(front, Instant::now(), Some(&refusal));
        refusal
    }

    /// Whether the simulation service can be reached.
    pub async fn is_reachable(&self) -> bool {
        self.0.bridge.is_reachable().await
    }

    /// Whether it takes requests.
    #[must_use]
    pub fn is_open(&self) -> bool {
        !self.0.lanes().is_closed
    }

    /// Takes no more requests, and waits for those that are in flight, each of which has its own time-out; whether all
    /// were answered.
    pub async fn drain(&self) -> bool {
        self.0.lanes().is_closed = true;
        let longest = self.0.bridge.timeout() + Duration::from_secs(1);
        let all_ended = async {
            loop {
                let ended = self.0.ended.notified();
                if self.0.lanes().waiting.is_empty() {
                    return;
                }
                ended.await;
            }
        };
        timeout(longest, all_ended).await.is_ok()
    }

    fn enter(&self, request: Request, front: Front, arrived: Instant) -> Result<oneshot::Receiver<Answer>, Refusal> {
        let mut lanes = self.0.lanes();
        if lanes.is_closed {
            return Err(request.refusal(Failure::Stopping));
        }
        if lanes.in_flight >= MAX_IN_FLIGHT {
            return Err(request.refusal(Failure::Busy));
        }
        lanes.in_flight += 1;
        let session = request.session().clone();
        let (answer, answered) = oneshot::channel();
        let is_new = !lanes.waiting.contains_key(&session);
        lanes.waiting.entry(session.clone()).or_default().push_back(Job { request, front, arrived, answer });
        drop(lanes);
        if is_new {
            let shared = Arc::clone(&self.0);
            self.0.runtime.spawn(async move { shared.work(&session).await });
        }
        Ok(answered)
    }
}

impl Shared {
    /// Answers the requests of a session until none waits. `[NCP-TRANS-007]`
    async fn work(&self, session: &Text) {
        while let Some(Job { request, front, arrived, answer }) = self.next(session) {
            let asked = AssertUnwindSafe(self.bridge.ask(&request, arrived)).catch_unwind().await;
            let found = asked.unwrap_or_else(|_| Err(request.refusal(Failure::Internal))); // [NCP-SESS-037]
            self.finish(front, arrived, found.as_ref().err());
            // A client that has gone needs none.
            let _ = answer.send(found);
            self.lanes().in_flight -= 1;
        }
    }

    fn next(&self, session: &Text) -> Option<Job> {
        let mut lanes = self.lanes();
        let job = lanes.waiting.get_mut(session).and_then(VecDeque::pop_front);
        if job.is_none() {
            lanes.waiting.remove(session);
            self.ended.notify_waiters();
        }
        job
    }

    fn finish(&self, front: Front, arrived: Instant, refusal: Option<&Refusal>) {
        self.metrics.answered(front, arrived.elapsed());
        if let Some(Refusal { session, failure }) = refusal {
            let cause = failure.cause();
            self.metrics.failed(cause);
            tracing::info!(?front, session = session.as_deref(), cause, "error frame: {failure}");
        }
    }

    fn lanes(&self) -> MutexGuard<'_, Lanes> {
        // What a thread that panicked left is whole: each change is one call.
        self.lanes.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
