//! Control RPC over Zenoh: a queryable on `{realm}/rpc`.

use ncp_spec::wire::MAX_FRAME_BYTES;
use ncp_zenoh::{Bus, BusError};
use tokio::runtime::Handle;
use tokio::task::spawn_blocking;
use tokio_util::task::TaskTracker;
use zenoh::Wait;
use zenoh::query::{Query, Queryable};

use crate::backend::Backend;
use crate::failure::{Failure, frame};
use crate::metrics::{Front, Metrics};

/// Answers the queries of a realm until it is stopped.
pub(crate) struct ZenohFront {
    bus: Bus,
    queryable: Queryable<()>,
    replies: TaskTracker,
}

impl ZenohFront {
    /// Declares the queryable. It blocks.
    ///
    /// # Errors
    /// Zenoh refuses.
    pub(crate) fn start(bus: Bus, backend: Backend, metrics: Metrics, runtime: Handle) -> Result<Self, BusError> {
        let key = bus.keys().rpc()?;
        let replies = TaskTracker::new();
        let tracked = replies.clone();
        let queryable = bus.session().declare_queryable(key).callback(move |query| {
            let bytes = query.payload().map_or(0, |payload| payload.len());
            let metrics = metrics.clone();
            if bytes > MAX_FRAME_BYTES {
                let too_long = Failure::RequestTooLong { len: bytes, limit: MAX_FRAME_BYTES };
                let refusal = backend.refuse(Front::Zenoh, too_long);
                tracked.spawn_on(async move { reply(query, refusal.frame(), &metrics).await }, &runtime);
                return;
            }
            let request = query.payload().map(|payload| payload.to_bytes()).unwrap_or_default();
            let answer = backend.submit(Front::Zenoh, &request);
            drop(request);
            tracked.spawn_on(async move { reply(query, frame(answer.await), &metrics).await }, &runtime);
        });
        Ok(Self { queryable: queryable.wait()?, bus, replies })
    }

    /// Takes no more queries. It blocks.
    pub(crate) fn stop_taking(self) -> Answering {
        let Self { bus, queryable, replies } = self;
        if let Err(error) = queryable.undeclare().wait() {
            tracing::warn!("Zenoh: {error}");
        }
        replies.close();
        Answering { bus, replies }
    }
}

/// What still answers queries that were taken.
pub(crate) struct Answering {
    bus: Bus,
    replies: TaskTracker,
}

impl Answering {
    /// Waits until all are answered, and gives the session, which blocks when it is dropped.
    pub(crate) async fn finish(self) -> Bus {
        self.replies.wait().await;
        self.bus
    }
}

/// Replies with the quality of service of the query, which may wait for a slow link.
async fn reply(query: Query, frame: Vec<u8>, metrics: &Metrics) {
    let replied = spawn_blocking(move || query.reply(query.key_expr().clone(), frame).wait()).await;
    if !matches!(replied, Ok(Ok(()))) {
        metrics.undelivered(Front::Zenoh);
    }
}
