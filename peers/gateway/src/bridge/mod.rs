//! The line bridge: connections to the simulation service, each with one request in flight.
//!
//! | module | what it holds |
//! |---|---|
//! | [`line`] | one connection |

mod line;

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use tokio::sync::Semaphore;
use tokio::time::{Instant, timeout, timeout_at};

use crate::failure::{Failure, Refusal};
use crate::metrics::Metrics;
use crate::request::Request;
use line::Line;

/// How long a connection may take to be made, if the request has that long.
const LONGEST_DIAL: Duration = Duration::from_secs(2);

/// Where the service is, and how it is spoken to.
#[derive(Debug, Clone)]
pub(crate) struct BridgeSettings {
    /// Its address, as `host:port`.
    pub(crate) address: String,
    /// How long a request may take, from its arrival to its reply.
    pub(crate) timeout: Duration,
    /// How many connections there are at most.
    pub(crate) connections: usize,
}

/// The connections to the service. The one that was used last is used first, so that a client alone has one.
pub(crate) struct Bridge {
    settings: BridgeSettings,
    idle: Mutex<Vec<Line>>,
    slots: Semaphore,
    /// Connections that were lost, and for which no other was made yet.
    lost: AtomicUsize,
    metrics: Metrics,
}

impl Bridge {
    /// A bridge without connections.
    pub(crate) fn new(settings: BridgeSettings, metrics: Metrics) -> Self {
        let slots = Semaphore::new(settings.connections);
        Self { settings, idle: Mutex::default(), slots, lost: AtomicUsize::new(0), metrics }
    }

    /// How long a request may take.
    pub(crate) const fn timeout(&self) -> Duration {
        self.settings.timeout
    }

    /// Forwards a request, and gives the reply if it is one to it. A request that was sent is never sent again, since
    /// it may have been carried out.
    ///
    /// # Errors
    /// There is no such reply within the time-out, counted from when the request arrived: a request that has waited
    /// for all of it is not forwarded. `[NCP-TRANS-006]`
    pub(crate) async fn ask(&self, request: &Request, arrived: Instant) -> Result<Vec<u8>, Refusal> {
        self.reply(request, arrived + self.settings.timeout).await.map_err(|failure| request.refusal(failure))
    }

    /// Whether the service can be reached.
    pub(crate) async fn is_reachable(&self) -> bool {
        if self.idle().iter().any(Line::is_quiet) {
            return true;
        }
        let Ok(slot) = self.slots.try_acquire() else { return true };
        let dialled = self.dial(Instant::now() + LONGEST_DIAL).await.map(|line| self.idle().push(line));
        drop(slot);
        dialled.is_ok()
    }

    async fn reply(&self, request: &Request, deadline: Instant) -> Result<Vec<u8>, Failure> {
        let Self { settings: BridgeSettings { timeout, .. }, slots, metrics, .. } = self;
        let expired = || Failure::Expired(*timeout);
        if Instant::now() >= deadline {
            return Err(expired());
        }
        let slot = timeout_at(deadline, slots.acquire()).await.map_err(|_| expired())?;
        let _slot = slot.map_err(|_| Failure::Stopping)?;
        let mut line = match self.take_idle() {
            Some(line) => line,
            None => self.dial(deadline).await?,
        };
        metrics.sent(request.line().len());
        let exchanged = timeout_at(deadline, line.exchange(request.line())).await;
        let exchanged = exchanged.unwrap_or(Err(Failure::TimedOut(*timeout)));
        let checked = exchanged.and_then(|reply| {
            metrics.received(reply.len() + 1);
            request.is_failed_by(&reply).map(|is_failed| (reply, is_failed))
        });
        match checked {
            Ok((reply, is_failed)) => {
                if is_failed {
                    metrics.failed("service");
                }
                self.idle().push(line);
                Ok(reply)
            }
            // The connection is dropped: what may yet come over it answers nobody.
            Err(failure) => {
                self.lost.fetch_add(1, Ordering::Relaxed);
                tracing::warn!(cause = failure.cause(), "a connection to the service is dropped: {failure}");
                Err(failure)
            }
        }
    }

    /// The connection that was used last and still stands.
    fn take_idle(&self) -> Option<Line> {
        let mut idle = self.idle();
        loop {
            let line = idle.pop()?;
            if line.is_quiet() {
                return Some(line);
            }
            self.lost.fetch_add(1, Ordering::Relaxed);
            tracing::info!("a connection to the service has ended while nobody used it");
        }
    }

    async fn dial(&self, deadline: Instant) -> Result<Line, Failure> {
        let address = &self.settings.address;
        let longest = LONGEST_DIAL.min(deadline.saturating_duration_since(Instant::now()));
        let dialled = timeout(longest, Line::dial(address)).await;
        let unreachable = |why: String| {
            tracing::warn!(address, "the service cannot be reached: {why}");
            Failure::Unreachable(why)
        };
        let line = dialled.map_err(|_| unreachable(format!("no connection within {longest:?}")))?;
        let line = line.map_err(|error| unreachable(error.to_string()))?;
        self.metrics.connected();
        let lost = |lost: usize| lost.checked_sub(1);
        if self.lost.fetch_update(Ordering::Relaxed, Ordering::Relaxed, lost).is_ok() {
            self.metrics.reconnected();
            tracing::info!(address, "connected to the service again");
        }
        Ok(line)
    }

    fn idle(&self) -> MutexGuard<'_, Vec<Line>> {
        // What a thread that panicked left is whole: each change is one call.
        self.idle.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
