//! Whoever serves WebSockets before a simulation service on a line.

use std::collections::BTreeMap;
use std::io;
use std::net::TcpStream;
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

use ncp_gateway::service::Does;
use ncp_spec::wire::{Message, decode_any};
use ncp_zenoh::{Bus, BusError};
use tungstenite::WebSocket;

use super::gateway::{is_observation_of, number_in, observation, service, session_in};
use super::server::{has_server, session, step};
use super::{PATIENCE, shown};
use crate::LiveError;
use crate::target::Target;
use crate::verdict::Rulings;

/// Replies come over a WebSocket in the order of its requests, and those of one session are handled in it.
pub(super) fn order(bus: &Bus, target: &Target, rulings: &mut Rulings) -> Result<(), LiveError> {
    let slow = session(target, "slow");
    let (of_script, run_ms) = (slow.clone(), Mutex::new(BTreeMap::<String, f64>::new()));
    let service = service(target, rulings, move |line| {
        let id = session_in(line);
        let mut run_ms = run_ms.lock().unwrap_or_else(PoisonError::into_inner);
        let run_ms = run_ms.entry(id.clone()).or_default();
        *run_ms += number_in(line, "advance_ms");
        let reply = observation(&id, *run_ms);
        // The first of a session takes its time, so that those behind it could overtake.
        let is_late = id == of_script || number_in(line, "advance_ms") == 1.0;
        if is_late { Does::Late(Duration::from_millis(150), reply) } else { Does::Reply(reply) }
    });
    if service.is_none() || !has_server(bus, rulings)? {
        return Ok(());
    }
    let Some(mut socket) = connect(target, rulings) else { return Ok(()) };
    let others = ["a", "b", "c"].map(|name| session(target, name));
    let mut asked: Vec<(&str, f64)> = Vec::new();
    for number in 1..=6_u8 {
        asked.push((&slow, f64::from(number)));
        asked.extend(others.iter().map(|other| (other.as_str(), f64::from(number))));
    }
    for (id, advance_ms) in &asked {
        let request = step(id, *advance_ms).encode().map_err(BusError::from)?;
        if socket.send(tungstenite::Message::text(request)).is_err() {
            rulings.fail("NCP-SESS-027", "the socket takes no more requests");
            return Ok(());
        }
    }
    let mut run_ms: BTreeMap<&str, f64> = BTreeMap::new();
    for (nth, (id, advance_ms)) in asked.iter().enumerate() {
        let expected = run_ms.entry(id).or_default();
        *expected += advance_ms;
        let reply = receive(&mut socket).unwrap_or_default();
        let found = match decode_any(reply.as_bytes()) {
            Ok(Message::ObservationFrame(frame)) if frame.session_id == *id => Some(frame.sim_time_ms),
            _ => None,
        };
        rulings.observe("NCP-SESS-027", found.is_some(), || {
            format!("reply {} is {}, and the request was about {id}", nth + 1, shown(reply.as_bytes()))
        });
        if let Some(found) = found {
            rulings.observe("NCP-SESS-036", found == *expected, || {
                format!("reply {} of {id} is of {found} ms, and in order it is {expected} ms", nth + 1)
            });
        }
    }
    Ok(())
}

/// Whatever is sent over a WebSocket has one reply, and the socket stays.
pub(super) fn refusals(bus: &Bus, target: &Target, rulings: &mut Rulings) -> Result<(), LiveError> {
    let service = service(target, rulings, |line| Does::Reply(observation(&session_in(line), 1.0)));
    if service.is_none() || !has_server(bus, rulings)? {
        return Ok(());
    }
    let Some(mut socket) = connect(target, rulings) else { return Ok(()) };
    let bad = [
        ("NCP-SESS-021", "no frame"),
        ("NCP-SESS-021", r#"{"kind":"step_request","session_id":"a","session_id":"b"}"#),
        ("NCP-SESS-021", ""),
        ("NCP-SESS-022", r#"{"kind":"sensor_frame","seq":1}"#),
    ];
    for (nth, (rule, request)) in (1_u32..).zip(bad) {
        let id = session(target, &format!("after-{nth}"));
        let good = step(&id, 1.0).encode().map_err(BusError::from)?;
        let is_sent = [request, &good].into_iter().all(|one| socket.send(tungstenite::Message::text(one)).is_ok());
        let replies = [receive(&mut socket), receive(&mut socket)].map(Option::unwrap_or_default);
        let is_error = matches!(decode_any(replies[0].as_bytes()), Ok(Message::Error(_)));
        rulings.observe(rule, is_sent && is_error, || {
            format!("{} was answered with {:?}", shown(request.as_bytes()), shown(replies[0].as_bytes()))
        });
        rulings.observe("NCP-SESS-020", is_observation_of(replies[1].as_bytes(), &id), || {
            format!(
                "a sound request after {} was answered with {:?}",
                shown(request.as_bytes()),
                shown(replies[1].as_bytes())
            )
        });
    }
    Ok(())
}

/// A WebSocket of the gateway's, if it serves any.
fn connect(target: &Target, rulings: &mut Rulings) -> Option<WebSocket<TcpStream>> {
    let address = target.gateway.websocket;
    let connected = address.ok_or(io::ErrorKind::NotFound.into()).and_then(TcpStream::connect).and_then(|stream| {
        stream.set_read_timeout(Some(PATIENCE))?;
        Ok((stream, address.map(|address| format!("ws://{address}/")).unwrap_or_default()))
    });
    let opened = connected.map_err(|error| error.to_string()).and_then(|(stream, url)| {
        tungstenite::client(url, stream).map(|(socket, _)| socket).map_err(|error| error.to_string())
    });
    if let Err(why) = &opened {
        rulings.all_unclear(&format!("no WebSocket to talk to: {why}"));
    }
    opened.ok()
}

/// The next reply, unless the socket ends or none comes.
fn receive(socket: &mut WebSocket<TcpStream>) -> Option<String> {
    loop {
        match socket.read() {
            Ok(tungstenite::Message::Text(reply)) => return Some(reply.as_str().to_owned()),
            Ok(tungstenite::Message::Binary(reply)) => return String::from_utf8(reply.to_vec()).ok(),
            Ok(tungstenite::Message::Close(_)) | Err(_) => return None,
            Ok(_) => {}
        }
    }
}
