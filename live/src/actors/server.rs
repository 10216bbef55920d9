//! The session service over the reference backend, and a client that keeps a session going.

use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::Duration;

use ncp_spec::WIRE_VERSION;
use ncp_spec::plane::{Congestion, Plane, Priority, Qos};
use ncp_spec::session::ReferenceBackend;
use ncp_spec::wire::{
    BulkObservation, CloseSession, Frame, Message, NetworkRef, ObservationFrame, OpenSession, StepRequest, decode_any,
};
use ncp_zenoh::{Bus, BusError, ControlClient, ControlServer, SessionHost, StreamPublisher};
use zenoh::Wait;
use zenoh::query::Query;

use super::Planted;
use crate::LiveError;
use crate::target::{Running, Target};

type Handler = Arc<dyn Fn(&[u8]) -> Vec<u8> + Send + Sync>;

pub(super) fn server(target: &Target, planted: &Planted) -> Result<Running, LiveError> {
    let bus = Arc::new(target.bus()?);
    let handler = handler(&bus, planted);
    let running = Running::default();
    let of_server = Arc::clone(&handler);
    let running = if ["late-first", "error-reply"].iter().any(|name| planted.is(name)) {
        running.keeping(bare_server(&bus, planted, handler)?)
    } else {
        let running = running.keeping(ControlServer::start(&bus, move |request| of_server(request))?);
        match planted.is("second-server") {
            true => running.keeping(ControlServer::start(&bus, move |request| handler(request))?),
            false => running,
        }
    };
    Ok(running.keeping(bus))
}

/// What a request is answered with, and what is published besides.
fn handler(bus: &Arc<Bus>, planted: &Planted) -> Handler {
    let host = SessionHost::new(|| ReferenceBackend);
    let one = Mutex::new(());
    let last_reply = Mutex::new(Vec::new());
    let (bus, planted) = (Arc::clone(bus), planted.clone());
    Arc::new(move |request| {
        let asked = decode_any(request);
        let _alone = planted.is("one-at-a-time").then(|| one.lock().unwrap_or_else(PoisonError::into_inner));
        let request = mangled(&planted, request);
        if planted.is("close-forgotten") && matches!(asked, Ok(Message::CloseSession(_))) {
            let reply = String::from_utf8_lossy(&request).replace("close_session", "session_closed");
            return reply.replace('}', r#","ok":true}"#).into_bytes();
        }
        let mut reply = host.serve(&request);
        if let Ok(Message::ObservationFrame(frame)) = decode_any(reply.as_bytes()) {
            publish(&bus, &planted, &frame);
        }
        match &asked {
            Err(_) if planted.is("malformed-is-fine") => {
                reply = r#"{"kind":"session_closed","session_id":"x"}"#.to_owned();
            }
            Err(_) if planted.is("silent") => thread::sleep(Duration::from_secs(7)),
            Ok(Message::StepRequest(_)) if planted.is("cut-reply") => reply.truncate(reply.len() / 2),
            _ => {}
        }
        if planted.is("time-in-seconds") {
            reply = reply.replace(r#""sim_time_ms":"#, r#""sim_time_ms":0.001,"was":"#);
        }
        if planted.is("reply-of-another") && matches!(asked, Ok(Message::StepRequest(_))) {
            let mut last = last_reply.lock().unwrap_or_else(PoisonError::into_inner);
            let before = std::mem::replace(&mut *last, reply.clone().into_bytes());
            if !before.is_empty() {
                return before;
            }
        }
        if planted.is("crossed-replies") {
            let mut last = last_reply.lock().unwrap_or_else(PoisonError::into_inner);
            let before = std::mem::replace(&mut *last, reply.clone().into_bytes());
            let of_sessions = |frame: &[u8]| matches!(decode_any(frame), Ok(Message::ObservationFrame(_)));
            if of_sessions(&before) && of_sessions(reply.as_bytes()) {
                return before;
            }
        }
        reply.into_bytes()
    })
}

/// A request as a server with a defect reads it.
fn mangled(planted: &Planted, request: &[u8]) -> Vec<u8> {
    let text = String::from_utf8_lossy(request);
    let replaced = |from: &str, to: &str| text.replace(from, to).into_bytes();
    if planted.is("version-ignored") {
        return replaced(r#""ncp_version":"0.4""#, &format!(r#""ncp_version":"{WIRE_VERSION}""#));
    }
    if planted.is("negative-time") {
        return replaced(r#""advance_ms":-"#, r#""advance_ms":"#);
    }
    if planted.is("chunk-ignored") && !text.contains("advance_ms") && text.contains("step_request") {
        return replaced(r#""ncp_version""#, r#""advance_ms":1,"ncp_version""#);
    }
    if planted.is("one-session-for-all")
        && let Ok(Message::StepRequest(step)) = decode_any(request)
        && let Some(base) = step.session_id.strip_suffix("-b")
    {
        return replaced(&step.session_id, &format!("{base}-a"));
    }
    request.to_vec()
}

/// What was observed also travels on the observation plane.
fn publish(bus: &Bus, planted: &Planted, frame: &ObservationFrame) {
    let keys = bus.keys();
    let key = match planted.is("observation-on-perception") {
        true => keys.sensor(&frame.session_id, Some("observed")),
        false => keys.observation(&frame.session_id),
    };
    let Some(stream) = key.ok().and_then(|key| StreamPublisher::declare(bus, key, Plane::Observation.qos()).ok())
    else {
        return;
    };
    let mut frame = frame.clone();
    if planted.is("observation-seq-stands") {
        frame.seq = 1;
    }
    let text = frame.encode().unwrap_or_default();
    let text = match planted.is("pins-missing") {
        true => text.replace(r#","calibrated_posterior":false,"is_simulation_output":true"#, ""),
        false => text,
    };
    // The stream goes with the request; what of it fails, the judge misses.
    let _ = stream.send_bytes(text);
    let block = ncp_spec::bulk::pack(&[1.5], &[], &[7]).unwrap_or_default();
    let _ = match planted.is("raw-block") {
        true => stream.send_bytes(block),
        false => stream.send(&BulkObservation { block, ..BulkObservation::default() }),
    };
}

/// A queryable below [`ControlServer`], for what that one does not let go wrong.
fn bare_server(bus: &Bus, planted: &Planted, handler: Handler) -> Result<impl Send + use<>, LiveError> {
    let waiting: Arc<Mutex<Vec<Query>>> = Arc::default();
    let (into, planted) = (Arc::clone(&waiting), planted.clone());
    let late_first = planted.is("late-first");
    let key = bus.keys().rpc().map_err(BusError::from)?;
    let queryable = bus.session().declare_queryable(key).callback(move |query| {
        into.lock().unwrap_or_else(PoisonError::into_inner).push(query);
    });
    let queryable = queryable.wait().map_err(BusError::from)?;
    // What waited together is answered the last first.
    let period = Duration::from_millis(if late_first { 40 } else { 1 });
    let running = Running::default().every(period, move || {
        let mut taken = std::mem::take(&mut *waiting.lock().unwrap_or_else(PoisonError::into_inner));
        if late_first {
            taken.reverse();
        }
        for query in taken {
            let request = query.payload().map(|payload| payload.to_bytes()).unwrap_or_default();
            let reply = handler(&request);
            let is_error = matches!(decode_any(&reply), Ok(Message::Error(_)));
            // A client that went has its reply nowhere.
            let _ = match planted.is("error-reply") && is_error {
                true => query.reply_err(reply).wait(),
                false => query.reply(query.key_expr(), reply).wait(),
            };
        }
    });
    Ok((queryable, running))
}

/// Opens a session and steps it, over and over.
pub(super) fn client(target: &Target, planted: &Planted) -> Result<Running, LiveError> {
    let bus = target.bus()?;
    let mut qos = Plane::Control.qos();
    if planted.is("request-drops") {
        qos = Qos { congestion: Congestion::Drop, ..qos };
    } else if planted.is("request-priority") {
        qos = Qos { priority: Priority::RealTime, ..qos };
    } else if planted.is("request-express") {
        qos = Qos { express: true, ..qos };
    }
    let client = ControlClient::new(&bus, Duration::from_millis(500))?.with_qos(qos.into());
    let session_id: ncp_spec::wire::Text = format!("{}-client", target.session).into();
    let network = NetworkRef { reference: target.network.clone().into(), ..NetworkRef::default() };
    let running = Running::default().every(Duration::from_millis(50), move || {
        let session_id = || session_id.clone();
        let network = network.clone();
        let requests: [Message; 3] = [
            OpenSession { session_id: session_id(), network, ..OpenSession::default() }.into(),
            StepRequest { session_id: session_id(), ..StepRequest::default() }.into(),
            CloseSession { session_id: session_id(), ..CloseSession::default() }.into(),
        ];
        for request in &requests {
            // Whoever is not there yet is asked again.
            if client.ask(request).is_err() {
                break;
            }
        }
    });
    Ok(running.keeping(bus))
}
