//! Clients over WebSocket.

use std::io;
use std::net::TcpStream;
use std::thread;
use std::time::Duration;

use tungstenite::client::IntoClientRequest;
use tungstenite::http::HeaderValue;
use tungstenite::{Error, Message, WebSocket};

use crate::program::Program;
use crate::service::{self, Does};
use crate::{LONG, error, json, observation, open, step, until};

pub(crate) type Socket = WebSocket<TcpStream>;

pub(crate) fn connect(program: &Program) -> Socket {
    connect_from(program, None).unwrap()
}

fn connect_from(program: &Program, origin: Option<&'static str>) -> Result<Socket, String> {
    let address = program.address("websocket");
    let stream = TcpStream::connect(address).unwrap();
    stream.set_read_timeout(Some(LONG)).unwrap();
    let mut request = format!("ws://{address}/").into_client_request().unwrap();
    if let Some(origin) = origin {
        request.headers_mut().insert("Origin", HeaderValue::from_static(origin));
    }
    tungstenite::client(request, stream).map(|(socket, _)| socket).map_err(|error| error.to_string())
}

pub(crate) fn send(socket: &mut Socket, request: &str) {
    socket.send(Message::text(request)).unwrap();
}

/// A socket that is being closed takes no more.
pub(crate) fn try_send(socket: &mut Socket, request: &str) {
    let _ = socket.send(Message::text(request));
}

pub(crate) fn receive(socket: &mut Socket) -> Vec<u8> {
    match socket.read().unwrap() {
        Message::Text(text) => text.as_bytes().to_vec(),
        other => panic!("{other:?}"),
    }
}

/// The code with which the gateway closes.
pub(crate) fn closed(socket: &mut Socket) -> Option<u16> {
    loop {
        match socket.read() {
            Ok(Message::Close(Some(frame))) => return Some(frame.code.into()),
            Ok(_) => {}
            Err(_) => return None,
        }
    }
}

#[test]
fn replies_come_in_the_order_of_the_requests_also_of_sessions_side_by_side() {
    let service = service::start(|line| {
        let line = json(line.as_bytes());
        let id = line["session_id"].as_str().unwrap().to_owned();
        match id.as_str() {
            "slow" => Does::Late(Duration::from_millis(700), observation("slow", 1)),
            _ => Does::Reply(observation(&id, 1)),
        }
    });
    let program = Program::start(service.address(), &[]);
    let mut socket = connect(&program);
    let asked = ["slow", "a", "b", "slow", "a"];
    for id in asked {
        send(&mut socket, &step(id, 1.0));
    }
    until("the fast ones are asked beside the slow one", || {
        service.lines().iter().filter(|(_, line)| !line.contains("slow")).count() == 3
    });
    for id in asked {
        assert_eq!(json(&receive(&mut socket))["session_id"], id);
    }
}

/// `[NCP-SESS-020] [NCP-SESS-021] [NCP-SESS-022]`
#[test]
fn each_bad_request_has_one_error_frame_and_the_socket_stays() {
    let service = service::reference();
    let program = Program::start(service.address(), &[]);
    let mut socket = connect(&program);
    send(&mut socket, &open("s"));
    assert_eq!(json(&receive(&mut socket))["ok"], true);
    for (number, bad) in ["", "no frame", "[]", r#"{"kind":"sensor_frame"}"#, "{\"kind\":"].into_iter().enumerate() {
        send(&mut socket, bad);
        send(&mut socket, &step("s", 1.0));
        error(&receive(&mut socket));
        assert_eq!(json(&receive(&mut socket))["seq"], number + 1, "after {bad:?}");
    }
    socket.send(Message::binary(step("s", 1.0).into_bytes())).unwrap();
    assert_eq!(json(&receive(&mut socket))["seq"], 6, "a binary message is a request, too");
    assert_eq!(service.lines().len(), 7, "what is bad is not forwarded");
}

#[test]
fn a_message_beyond_all_limits_has_an_error_frame_and_costs_its_socket() {
    let service = service::reference();
    let program = Program::start(service.address(), &[]);
    let mut socket = connect(&program);
    send(&mut socket, &open("s"));
    socket.write(Message::text(" ".repeat(3 << 20))).unwrap();
    let _ = socket.flush();
    assert_eq!(json(&receive(&mut socket))["ok"], true);
    assert!(error(&receive(&mut socket)).contains("more than 1048576"));
    assert_eq!(closed(&mut socket), Some(1000));
    assert_eq!(program.counted("ncp_gateway_dropped_clients_total{reason=\"too_long\"}"), 1.0);
}

#[test]
fn a_client_that_takes_no_replies_is_dropped_and_that_is_said() {
    let large = " ".repeat(8 << 20);
    let service = service::start(move |line| {
        let id = json(line.as_bytes())["session_id"].as_str().unwrap().to_owned();
        Does::Reply(observation(&id, 1) + if id == "large" { &large } else { "" })
    });
    let program = Program::start(service.address(), &[("NCP_WS_SEND_TIMEOUT_MS", "500")]);
    let (mut slow, mut other) = (connect(&program), connect(&program));
    for _ in 0..4 {
        send(&mut slow, &step("large", 1.0));
    }
    until("it is dropped", || program.counted("ncp_gateway_dropped_clients_total{reason=\"slow\"}") == 1.0);
    assert!(program.events().iter().any(|event| event["reason"] == "slow" && event["level"] == "WARN"));
    send(&mut other, &step("s", 1.0));
    assert_eq!(json(&receive(&mut other))["session_id"], "s", "another client does not notice");
    // Whatever of it was under way, the connection ends.
    let ended = loop {
        match slow.read() {
            Ok(_) => {}
            Err(ended) => break ended,
        }
    };
    let is_time_out = matches!(&ended, Error::Io(error) if error.kind() == io::ErrorKind::WouldBlock);
    assert!(!is_time_out, "{ended}");
}

#[test]
fn a_client_with_many_requests_and_no_replies_is_read_no_further() {
    const QUEUED: usize = 32;
    let service = service::start(|_| Does::Nothing);
    let program = Program::start(service.address(), &[]);
    let mut socket = connect(&program);
    for number in 0..3 * QUEUED {
        send(&mut socket, &step(&format!("s{number}"), 1.0));
    }
    until("those that have room are asked", || service.lines().len() >= QUEUED);
    thread::sleep(Duration::from_millis(500));
    // One is taken out of the queue to be waited for.
    assert!(service.lines().len() <= QUEUED + 1, "{}", service.lines().len());
}

#[test]
fn a_page_of_another_host_is_turned_away_unless_it_is_named() {
    let service = service::reference();
    let program = Program::start(service.address(), &[("NCP_WS_ORIGINS", "https://lab.example,https://b.example")]);
    let refused = connect_from(&program, Some("https://evil.example"));
    assert!(refused.as_ref().is_err_and(|error| error.contains("403")), "{refused:?}");
    assert_eq!(program.counted("ncp_gateway_dropped_clients_total{reason=\"origin\"}"), 1.0);
    for origin in ["https://lab.example", "http://localhost:5173"] {
        let mut socket = connect_from(&program, Some(origin)).unwrap();
        send(&mut socket, &open(&origin.len().to_string()));
        assert_eq!(json(&receive(&mut socket))["ok"], true);
    }
}
