//! What those see who watch the gateway.

use std::io::{Read, Write};
use std::net::{SocketAddr, TcpStream};

use crate::program::Program;
use crate::service;
use crate::{observation, open, step, until};

/// The status line and the body.
pub(crate) fn get(address: SocketAddr, path: &str) -> (String, String) {
    let mut stream = TcpStream::connect(address).unwrap();
    write!(stream, "GET {path} HTTP/1.1\r\nHost: gateway\r\nConnection: close\r\n\r\n").unwrap();
    let mut reply = String::new();
    stream.read_to_string(&mut reply).unwrap();
    let (head, body) = reply.split_once("\r\n\r\n").unwrap();
    (head.lines().next().unwrap().to_owned(), body.to_owned())
}

#[test]
fn health_says_whether_the_service_can_be_reached() {
    let service = service::reference();
    let program = Program::start(service.address(), &[]);
    let health = || get(program.address("http"), "/healthz");
    assert_eq!(health(), ("HTTP/1.1 200 OK".to_owned(), "ok\n".to_owned()));
    service::die(service);
    until("it notices", || health().0.contains("503"));
    assert!(health().1.contains("cannot be reached"));
}

#[test]
fn requests_error_frames_bytes_and_times_are_counted() {
    let service = service::reference();
    let program = Program::start(service.address(), &[]);
    let client = program.client();
    let asked = program.counted("ncp_gateway_requests_total{front=\"Zenoh\"}");
    client.ask(&open("s"));
    client.ask(&step("s", 1.0));
    client.ask(&step("t", 1.0));
    client.ask("no frame");
    assert_eq!(program.counted("ncp_gateway_requests_total{front=\"Zenoh\"}"), asked + 4.0);
    assert_eq!(program.counted("ncp_gateway_request_duration_seconds_count{front=\"Zenoh\"}"), asked + 4.0);
    assert_eq!(program.counted("ncp_gateway_error_frames_total{cause=\"service\"}"), 1.0);
    assert_eq!(program.counted("ncp_gateway_error_frames_total{cause=\"request_rejected\"}"), 1.0);
    let sent: usize = [open("s"), step("s", 1.0), step("t", 1.0)].iter().map(|line| line.len() + 1).sum();
    assert!((program.counted("ncp_gateway_bridge_bytes_total{direction=\"to_service\"}") - sent as f64).abs() < 6.0);
    let received = program.counted("ncp_gateway_bridge_bytes_total{direction=\"from_service\"}");
    assert!(received > observation("s", 1).len() as f64, "{received}");
    assert_eq!(program.counted("ncp_gateway_connections_total"), 1.0);
    assert_eq!(program.counted("ncp_gateway_in_flight"), 0.0);
    assert!(program.events().iter().any(|event| event["cause"] == "request_rejected"), "the log says it, too");
}
