//! Clients that know the answers: whether each reply is the one to its request.

use std::sync::mpsc::Sender;
use std::time::Duration;

use ncp_spec::reply::ReplyError;
use ncp_spec::wire::{CloseSession, Message, NetworkRef, OpenSession, StepRequest, Text};
use ncp_zenoh::{BusError, ControlClient};

use super::body::Seen;
use crate::LiveError;
use crate::target::{Running, Target};

/// From one session to the next.
const PERIOD: Duration = Duration::from_millis(50);

/// How long a client waits for a reply.
const TIMEOUT: Duration = Duration::from_millis(700);

/// Sessions of a client, one after the other: a request that is late has ended before its session comes again.
const SESSIONS: u64 = 64;

/// Opens a session, steps it and closes it, over and over, and tells of each reply. What a link may do to a call, such
/// as to lose it, is no observation.
pub(super) fn asks(target: &Target, client: u32, into: Sender<Seen>) -> Result<Running, LiveError> {
    let bus = target.bus()?;
    let control = ControlClient::new(&bus, TIMEOUT)?;
    let network = NetworkRef { reference: target.network.clone().into(), ..NetworkRef::default() };
    let base = format!("{}-asks-{client}", target.session);
    let mut sessions = 0_u64;
    let running = Running::default().every(PERIOD, move || {
        sessions += 1;
        let session_id: Text = format!("{base}-{}", sessions % SESSIONS).into();
        // How far it steps says whose step it is.
        let advance_ms = 101.0 + f64::from(u32::try_from(sessions % 97).unwrap_or(0));
        let (id, network) = (|| session_id.clone(), network.clone());
        let open = OpenSession { session_id: id(), network, ..OpenSession::default() };
        let step = StepRequest { session_id: id(), advance_ms: Some(advance_ms), ..StepRequest::default() };
        let close = CloseSession { session_id: id(), ..CloseSession::default() };
        let ask = |request: Message| {
            let reply = control.ask(&request);
            for seen in judged(&reply, advance_ms) {
                // Nobody is left to tell at the end.
                let _ = into.send(seen);
            }
            reply.is_ok()
        };
        if ask(open.into()) {
            ask(step.into());
        }
        ask(close.into());
    });
    Ok(running.keeping(bus))
}

/// What a reply says of the rules; `advance_ms` is how far each step of the session goes.
fn judged(reply: &Result<Message, BusError>, advance_ms: f64) -> Vec<Seen> {
    const RULE: &str = "NCP-SESS-027";
    match reply {
        Ok(Message::ObservationFrame(frame)) => {
            // A link that doubles requests makes the session run as often.
            let steps = frame.sim_time_ms / advance_ms;
            let is_so = (steps - steps.round()).abs() < 1e-6 && (1.0..=64.0).contains(&steps.round());
            let why = || format!("{} ran {} ms in steps of {advance_ms} ms", frame.session_id, frame.sim_time_ms);
            vec![Seen::new(RULE, is_so, why), Seen::good("NCP-SESS-020")]
        }
        Ok(_) => vec![Seen::good("NCP-SESS-020")],
        Err(BusError::Reply(error @ (ReplyError::Kind { .. } | ReplyError::Session { .. }))) => {
            vec![Seen::new(RULE, false, || error.to_string())]
        }
        Err(_) => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use ncp_spec::wire::{Kind, ObservationFrame};

    use super::*;

    #[test]
    fn a_reply_of_another_request_is_told_from_its_own_and_from_what_a_link_does() {
        let ran = |sim_time_ms| {
            let frame = ObservationFrame { session_id: "s".into(), sim_time_ms, ..ObservationFrame::default() };
            judged(&Ok(frame.into()), 101.0).iter().all(|seen| seen.is_so)
        };
        assert!(ran(101.0) && ran(202.0) && !ran(102.0) && !ran(0.0) && !ran(f64::NAN));
        let crossed = ReplyError::Kind { expected: Kind::SessionOpened, found: Kind::SessionClosed };
        assert!(!judged(&Err(crossed.into()), 1.0)[0].is_so);
        assert!(judged(&Err(BusError::NoReply(TIMEOUT)), 1.0).is_empty());
    }
}
