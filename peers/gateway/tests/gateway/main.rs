//! The program, started, between clients and a scripted simulation service, all on loopback.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test that cannot go on has failed")]

mod grpc;
mod http;
mod line;
mod program;
mod service;
mod start;
mod websocket;

use std::thread;
use std::time::{Duration, Instant};

use ncp_spec::WIRE_VERSION;

/// How long something may take that takes no time on an idle machine.
const LONG: Duration = Duration::from_secs(30);

fn until(what: &str, mut is_so: impl FnMut() -> bool) {
    let began = Instant::now();
    while !is_so() {
        assert!(began.elapsed() < LONG, "{what}: not within {LONG:?}");
        thread::sleep(Duration::from_millis(5));
    }
}

fn open(session: &str) -> String {
    let network = r#"{"kind":"builtin","ref":"ncp.reference.rate"}"#;
    format!(r#"{{"kind":"open_session","ncp_version":"{WIRE_VERSION}","session_id":"{session}","network":{network}}}"#)
}

fn step(session: &str, advance_ms: f64) -> String {
    format!(
        r#"{{"kind":"step_request","ncp_version":"{WIRE_VERSION}","session_id":"{session}","advance_ms":{advance_ms}}}"#
    )
}

fn close(session: &str) -> String {
    format!(r#"{{"kind":"close_session","ncp_version":"{WIRE_VERSION}","session_id":"{session}"}}"#)
}

fn observation(session: &str, seq: i64) -> String {
    format!(r#"{{"kind":"observation_frame","ncp_version":"{WIRE_VERSION}","session_id":"{session}","seq":{seq}}}"#)
}

fn json(frame: &[u8]) -> serde_json::Value {
    serde_json::from_slice(frame).unwrap_or_else(|error| panic!("{error}: {}", String::from_utf8_lossy(frame)))
}

/// What an error frame says; it is about a session, if it says so.
fn error(frame: &[u8]) -> String {
    let frame = json(frame);
    assert_eq!(frame["kind"], "error", "{frame}");
    frame["error"].as_str().unwrap().to_owned()
}
