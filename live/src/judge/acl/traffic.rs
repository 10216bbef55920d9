//! Traffic of a cell of the matrix: whether what is tried arrives.

use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use ncp_zenoh::{Bus, BusError, Intake};
use zenoh::Wait;
use zenoh::query::{ConsolidationMode, QueryTarget};

use super::super::PATIENCE;
use crate::LiveError;

/// How long what is denied is waited for, after what is allowed has arrived.
const AFTER: Duration = Duration::from_millis(150);

/// Whether what somebody puts arrives at a legitimate reader; none if not even what its legitimate source puts does.
pub(super) fn puts(own: &Bus, source: &Bus, sink: &Bus, key: &str) -> Result<Option<bool>, LiveError> {
    let intake: Intake<()> = Intake::subscribe(sink, key.to_owned(), 4_096)?;
    let mut has_arrived = false;
    let arrives = exchange(source, key, || {
        put(own, key, "tried")?;
        let mut allowed = false;
        while let Some(arrival) = intake.next() {
            has_arrived |= &*arrival.payload.to_bytes() == b"tried";
            allowed |= &*arrival.payload.to_bytes() == b"allowed";
        }
        Ok(allowed)
    })?;
    thread::sleep(AFTER);
    while let Some(arrival) = intake.next() {
        has_arrived |= &*arrival.payload.to_bytes() == b"tried";
    }
    Ok(arrives.then_some(has_arrived))
}

/// Whether somebody reads what its legitimate source puts; none if not even a legitimate reader does.
pub(super) fn reads(own: &Bus, source: &Bus, sink: &Bus, key: &str) -> Result<Option<bool>, LiveError> {
    let tries: Intake<()> = Intake::subscribe(own, key.to_owned(), 4_096)?;
    let intake: Intake<()> = Intake::subscribe(sink, key.to_owned(), 4_096)?;
    // A subscription takes its time to be known.
    thread::sleep(AFTER);
    let arrives = exchange(source, key, || Ok(intake.next().is_some()))?;
    thread::sleep(AFTER);
    Ok(arrives.then_some(tries.next().is_some()))
}

/// Lets a legitimate source put until what is allowed has arrived, or patience is at its end.
fn exchange(
    source: &Bus,
    key: &str,
    mut has_arrived: impl FnMut() -> Result<bool, LiveError>,
) -> Result<bool, LiveError> {
    let began = Instant::now();
    while began.elapsed() < PATIENCE / 2 {
        put(source, key, "allowed")?;
        thread::sleep(Duration::from_millis(10));
        if has_arrived()? {
            return Ok(true);
        }
    }
    Ok(false)
}

fn put(bus: &Bus, key: &str, what: &'static str) -> Result<(), LiveError> {
    Ok(bus.session().put(key, what).wait().map_err(BusError::from)?)
}

/// Whether a reply of one comes to another who asks everybody.
pub(super) fn answered(server: &Bus, asker: &Bus, who: &str) -> Result<bool, LiveError> {
    const KEY: &str = "ncp/rpc";
    let name = who.to_owned();
    let asked = Arc::new(Mutex::new(0_u32));
    let count = Arc::clone(&asked);
    let queryable = server.session().declare_queryable(KEY).callback(move |query| {
        *count.lock().unwrap_or_else(PoisonError::into_inner) += 1;
        // Whether it comes through is what is judged.
        let _ = query.reply(KEY, name.clone()).wait();
    });
    let _queryable = queryable.wait().map_err(BusError::from)?;
    let began = Instant::now();
    // A queryable takes its time to be known; one that is denied never is.
    while began.elapsed() < Duration::from_millis(600) {
        let query = asker.session().get(KEY).target(QueryTarget::All).consolidation(ConsolidationMode::None);
        let replies = query.timeout(Duration::from_millis(200)).wait().map_err(BusError::from)?;
        if replies
            .into_iter()
            .any(|reply| reply.result().is_ok_and(|reply| reply.payload().to_bytes() == who.as_bytes()))
        {
            return Ok(true);
        }
        thread::sleep(Duration::from_millis(50));
    }
    Ok(false)
}
