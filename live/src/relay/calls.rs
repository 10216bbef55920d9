//! Requests and replies on their way.

use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::{Duration, Instant};

use ncp_zenoh::{Bus, BusError, SeenQos};
use zenoh::Wait;
use zenoh::query::{ConsolidationMode, Query, Queryable, Reply};

use super::LinkState;
use super::late::Late;
use super::schedule::{PlaneName, Stream};
use crate::LiveError;

/// How long the relay waits for a reply.
const TIMEOUT: Duration = Duration::from_secs(2);

/// How long a call that was lost stays open, so that whoever asks has to wait: a link says nothing of what it loses.
const SILENCE: Duration = Duration::from_secs(2);

/// How long a call waits for the next one, which is to go before it.
const NEXT: Duration = Duration::from_millis(100);

/// How long the lane sleeps at most.
const NAP: Duration = Duration::from_millis(5);

/// The control plane: a queryable on the left, and a querier on the right.
pub(super) struct Calls {
    came: Receiver<Call>,
    into: Sender<Call>,
    right: Arc<Bus>,
    state: Arc<LinkState>,
    requests: Way,
    replies: Way,
    late: Late<Call>,
    silent: Late<Arc<Query>>,
    _queryable: Queryable<()>,
}

/// A direction.
struct Way {
    decisions: Stream,
    held: Vec<(Instant, Call)>,
    held_until: Option<Instant>,
}

/// What is on its way for a query.
enum Call {
    /// Its request.
    Request(Arc<Query>, Vec<u8>),
    /// A reply to it: a frame, or Zenoh's error reply.
    Reply(Arc<Query>, Result<Vec<u8>, Vec<u8>>),
}

impl Calls {
    pub(super) fn open(left: &Bus, right: Arc<Bus>, state: Arc<LinkState>) -> Result<Self, LiveError> {
        let (into, came) = channel();
        let of_queryable = into.clone();
        let key = left.keys().rpc().map_err(BusError::from)?;
        let queryable = left.session().declare_queryable(key).callback(move |query| {
            let request = query.payload().map(|payload| payload.to_bytes().into_owned()).unwrap_or_default();
            // The lane ends with the link.
            let _ = of_queryable.send(Call::Request(Arc::new(query), request));
        });
        let way = |name| Way {
            decisions: state.schedule.stream(PlaneName::Control, name),
            held: Vec::new(),
            held_until: None,
        };
        let (requests, replies) = (way("rpc/request"), way("rpc/reply"));
        let _queryable = queryable.wait().map_err(BusError::from)?;
        Ok(Self { came, into, right, state, requests, replies, late: Late::new(), silent: Late::new(), _queryable })
    }

    /// Takes what came, and lets go on what is due.
    pub(super) fn pump(&mut self) {
        if let Ok(call) = self.came.recv_timeout(self.late.rest(NAP)) {
            self.take(&call);
        }
        let now = Instant::now();
        for way in [&mut self.requests, &mut self.replies] {
            if way.held_until.is_some_and(|until| until <= now) {
                way.release(&mut self.late);
            }
        }
        while let Some(call) = self.late.pop(now) {
            self.let_go_on(call);
        }
        while self.silent.pop(now).is_some() {}
    }

    fn take(&mut self, call: &Call) {
        let Self { state, requests, replies, late, silent, .. } = self;
        let way = if matches!(call, Call::Request(..)) { requests } else { replies };
        let now = Instant::now();
        silent.push(now + SILENCE, Arc::clone(call.query()));
        let decision = way.decisions.next();
        if state.is_cut(PlaneName::Control) {
            return;
        }
        state.decided(PlaneName::Control, &decision);
        let damaged = |bytes: &[u8]| decision.corrupt.map_or_else(|| bytes.to_vec(), |corruption| corruption.of(bytes));
        let copies = decision.copies().into_iter().map(|after| (now + after, call.changed(damaged)));
        if decision.reordered && way.held.is_empty() {
            way.held.extend(copies);
            way.held_until = Some(now + NEXT);
            return;
        }
        for (due, call) in copies {
            late.push(due, call);
        }
        way.release(late);
    }

    fn let_go_on(&self, call: Call) {
        match call {
            Call::Request(query, request) => {
                let into = self.into.clone();
                let SeenQos { congestion, priority, express } = SeenQos::from(&*query);
                let get = self.right.session().get(query.key_expr().clone()).payload(request).timeout(TIMEOUT);
                let get = get.congestion_control(congestion).priority(priority).express(express);
                let get = get.consolidation(ConsolidationMode::None).callback(move |reply| {
                    // That the relay's own time is up, is silence.
                    if let Some(reply) = answer(reply) {
                        let _ = into.send(Call::Reply(Arc::clone(&query), reply));
                    }
                });
                // A request that cannot be sent is lost.
                let _ = get.wait();
            }
            // The reply goes out with the quality of service of its query; who asked may be gone.
            Call::Reply(query, Ok(reply)) => drop(query.reply(query.key_expr(), reply).wait()),
            Call::Reply(query, Err(error)) => drop(query.reply_err(error).wait()),
        }
    }
}

impl Call {
    const fn query(&self) -> &Arc<Query> {
        match self {
            Self::Request(query, _) | Self::Reply(query, _) => query,
        }
    }

    fn changed(&self, change: impl Fn(&[u8]) -> Vec<u8>) -> Self {
        match self {
            Self::Request(query, request) => Self::Request(Arc::clone(query), change(request)),
            Self::Reply(query, Ok(reply)) => Self::Reply(Arc::clone(query), Ok(change(reply))),
            Self::Reply(query, Err(error)) => Self::Reply(Arc::clone(query), Err(error.clone())),
        }
    }
}

impl Way {
    fn release(&mut self, late: &mut Late<Call>) {
        let now = Instant::now();
        for (due, call) in self.held.drain(..) {
            late.push(due.max(now), call);
        }
        self.held_until = None;
    }
}

/// What a server replied; none when nobody did.
fn answer(reply: Reply) -> Option<Result<Vec<u8>, Vec<u8>>> {
    match reply.into_result() {
        Ok(sample) => Some(Ok(sample.payload().to_bytes().into_owned())),
        Err(error) => {
            let error = error.payload().to_bytes().into_owned();
            (error != b"Timeout").then_some(Err(error))
        }
    }
}
