//! The strict profile (chapter 12.1): what changes once both ends have agreed upon it.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may panic as tests may")]

use std::sync::{Arc, Mutex};

use ncp_spec::bus::{BusError, LocalBus, NeuroSimClient};
use ncp_spec::keys::{KeyError, Keys};
use ncp_spec::reply::{check_reply, check_reply_strict};
use ncp_spec::resilience::{ActionBuffer, Received};
use ncp_spec::session::{ReferenceBackend, SessionService};
use ncp_spec::wire::{
    CloseSession, CommandFrame, Frame, Kind, Message, Mode, NetworkRef, OpenSession, StepRequest, decode, decode_any,
    decode_any_strict, decode_strict,
};
use ncp_spec::{ErrorCode, WIRE_VERSION};
use proptest::prelude::*;

const REQUESTS: [Kind; 4] = [Kind::OpenSession, Kind::StepRequest, Kind::RunRequest, Kind::CloseSession];

/// A frame of a kind with its required fields and these members before them.
fn frame(kind: Kind, version: Option<&str>, seq: i64) -> String {
    let version = version.map_or(String::new(), |v| format!(r#""ncp_version":"{v}","#));
    let required = r#""session_id":"s","controller_id":"c","network":{},"duration_ms":1,"error":"no""#;
    format!(r#"{{{version}"kind":"{kind}",{required},"seq":{seq}}}"#)
}

fn command(mode: &str, version: Option<&str>, seq: i64) -> String {
    let version = version.map_or(String::new(), |v| format!(r#""ncp_version":"{v}","#));
    let channels = format!(r#"{{"a":{{"data":[{seq}]}}}}"#);
    format!(r#"{{{version}"kind":"command_frame","seq":{seq},"mode":"{mode}","ttl_ms":250,"channels":{channels}}}"#)
}

/// What the plant does, told by the seq of the command that it follows.
fn followed(buffer: &mut ActionBuffer, now_s: f64) -> Option<f64> {
    buffer.active(now_s).map(|channels| channels.get("a").unwrap().data[0])
}

/// `[NCP-STRICT-002] [NCP-STRICT-003] [NCP-STRICT-012]`
#[test]
fn every_kind_but_the_error_frame_needs_a_compatible_version() {
    for kind in Kind::ALL {
        let own = frame(kind, Some(WIRE_VERSION), 1);
        assert_eq!(decode_strict(kind, own.as_bytes()), decode(kind, own.as_bytes()));
        let absent = frame(kind, None, 1);
        let other = frame(kind, Some("0.4"), 1);
        let malformed = frame(kind, Some("0.4.0"), 1);
        for (unfit, code) in
            [(absent, ErrorCode::Missing), (other, ErrorCode::Version), (malformed, ErrorCode::Version)]
        {
            let read = decode_any_strict(unfit.as_bytes());
            if kind == Kind::Error {
                assert!(read.is_ok());
            } else {
                let error = read.unwrap_err();
                assert_eq!((error.code(), error.path()), (code, "ncp_version"));
            }
            assert!(decode_any(unfit.as_bytes()).is_ok());
        }
    }
}

/// `[NCP-STRICT-004] [NCP-STRICT-012]`
#[test]
fn a_command_is_stamped_from_1_on_and_nothing_else_is() {
    for kind in Kind::ALL {
        for seq in [0, -1] {
            let unstamped = frame(kind, Some(WIRE_VERSION), seq);
            let read = decode_strict(kind, unstamped.as_bytes());
            if kind == Kind::CommandFrame {
                let error = read.unwrap_err();
                assert_eq!((error.code(), error.path()), (ErrorCode::Value, "seq"));
            } else {
                assert!(read.is_ok());
            }
        }
    }
    for mode in ["active", "hold", "init", "estop", "dance"] {
        let unstamped = command(mode, Some(WIRE_VERSION), 0);
        assert!(CommandFrame::decode_strict(unstamped.as_bytes()).is_err());
    }
    let absent = format!(r#"{{"ncp_version":"{WIRE_VERSION}","kind":"command_frame","mode":"active"}}"#);
    assert!(CommandFrame::decode_strict(absent.as_bytes()).is_err());
}

/// `[NCP-STRICT-001] [NCP-STRICT-006]`
#[test]
fn there_is_a_control_key_for_each_kind_of_request_and_no_other() {
    let keys = Keys::new(Some("engram/ncp")).unwrap();
    for kind in Kind::ALL {
        let key = keys.rpc_verb(kind);
        if REQUESTS.contains(&kind) {
            assert_eq!(key.unwrap(), format!("engram/ncp/rpc/{kind}"));
        } else {
            assert_eq!(key.unwrap_err(), KeyError::NoRequest(kind));
        }
    }
}

/// `[NCP-STRICT-002]`
#[test]
fn a_strict_client_accepts_no_reply_without_a_version() {
    let request = Message::from(CloseSession { session_id: "s".into(), ..CloseSession::default() });
    let without = br#"{"kind":"session_closed","session_id":"s"}"#;
    assert!(check_reply(&request, without).is_ok());
    assert!(check_reply_strict(&request, without).is_err());
    let with = format!(r#"{{"ncp_version":"{WIRE_VERSION}","kind":"session_closed","session_id":"s"}}"#);
    assert!(check_reply_strict(&request, with.as_bytes()).is_ok());
}

/// `[NCP-STRICT-010]`
#[test]
fn an_estop_latches_a_strict_plant_whatever_it_lacks() {
    let own = Some(WIRE_VERSION);
    for estop in [
        command("estop", own, 6),
        command("estop", own, 5),
        command("estop", own, 0),
        command("estop", own, -1),
        command("estop", None, 6),
        command("estop", Some("0.4"), 6),
        r#"{"kind":"command_frame","mode":"estop"}"#.to_owned(),
    ] {
        let mut buffer = ActionBuffer::strict();
        buffer.on_frame(command("active", own, 5).as_bytes(), 1.0).unwrap();
        let received = buffer.on_frame(estop.as_bytes(), 1.0);
        assert_eq!(received, Ok(Received::Stopped), "{estop}");
        buffer.on_frame(command("active", own, 7).as_bytes(), 1.0).unwrap();
        assert_eq!(followed(&mut buffer, 1.0), None);
    }
}

/// `[NCP-STRICT-004] [NCP-STRICT-005] [NCP-STRICT-011]`
#[test]
fn a_decoded_command_meets_the_same_plant_as_its_frame() {
    let decoded = |mode, seq| CommandFrame { mode, seq, ..CommandFrame::default() };
    let mut buffer = ActionBuffer::strict();
    for unstamped in [0, -1] {
        let received = buffer.on_command(decoded(Mode::Active, unstamped), 1.0);
        assert_eq!(received, Received::Dropped);
    }
    assert_eq!(buffer.on_command(decoded(Mode::Active, 5), 1.0), Received::Accepted);
    for (mode, seq) in [(Mode::Hold, 5), (Mode::Hold, 0), (Mode::Init, 4), (Mode::Active, 5)] {
        assert_eq!(buffer.on_command(decoded(mode, seq), 1.0), Received::Dropped);
        assert!(buffer.active(1.0).is_some());
    }
    assert_eq!(buffer.on_command(decoded(Mode::Hold, 6), 1.0), Received::Held);
    assert_eq!(buffer.on_command(decoded(Mode::Estop, 0), 1.0), Received::Stopped);
}

fn arrivals() -> impl Strategy<Value = Vec<(String, f64)>> {
    let versions = prop_oneof![
        4 => Just(Some(WIRE_VERSION)),
        1 => Just(None),
        1 => Just(Some("0.4")),
        1 => Just(Some("x")),
    ];
    let modes = prop_oneof![4 => Just("active"), 2 => Just("hold"), 1 => Just("init"), 1 => Just("dance")];
    let arrival = (versions, modes, -2_i64..12, 0.0..0.25_f64);
    proptest::collection::vec(arrival, 1..24).prop_map(|arrivals| {
        let mut now_s = 0.0;
        let sent = arrivals.into_iter().map(|(version, mode, seq, later_s)| {
            now_s += later_s;
            (command(mode, version, seq), now_s)
        });
        sent.collect()
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4_000))]

    /// `[NCP-STRICT-005] [NCP-STRICT-011]`
    #[test]
    fn what_a_strict_plant_does_not_take_might_as_well_never_have_come(arrivals in arrivals()) {
        let mut all = ActionBuffer::strict();
        let mut taken = ActionBuffer::strict();
        let mut last_seq = 0;
        for (text, now_s) in arrivals {
            let received = all.on_frame(text.as_bytes(), now_s);
            let fits = CommandFrame::decode(text.as_bytes()).is_ok_and(|command| {
                command.ncp_version == WIRE_VERSION && text.contains("ncp_version") && command.seq > last_seq
            });
            if fits {
                last_seq = CommandFrame::decode(text.as_bytes()).unwrap().seq;
                taken.on_frame(text.as_bytes(), now_s).unwrap();
            } else {
                prop_assert!(received.is_err() || received == Ok(Received::Dropped));
            }
            prop_assert_eq!(followed(&mut all, now_s), followed(&mut taken, now_s));
        }
    }
}

fn opening(version: Option<&str>) -> String {
    let version = version.map_or(String::new(), |v| format!(r#""ncp_version":"{v}","#));
    format!(r#"{{{version}"kind":"open_session","session_id":"s","network":{{"ref":"ncp.reference.rate"}}}}"#)
}

fn reply(text: &str) -> Message {
    decode_any_strict(text.as_bytes()).unwrap()
}

/// `[NCP-STRICT-008] [NCP-STRICT-009]`
#[test]
fn a_strict_server_carries_out_nothing_without_a_version() {
    let mut service = SessionService::strict(ReferenceBackend);
    for version in [None, Some("0.4"), Some("x")] {
        let Message::SessionOpened(opened) = reply(&service.serve(opening(version).as_bytes())) else {
            panic!("an opening is answered with session_opened");
        };
        assert!(!opened.ok && opened.error.is_some());
        assert_eq!(service.open_sessions().len(), 0);
    }
    service.serve(opening(Some(WIRE_VERSION)).as_bytes());
    for kind in [Kind::StepRequest, Kind::RunRequest, Kind::CloseSession] {
        for version in [None, Some("0.4")] {
            let refused = reply(&service.serve(frame(kind, version, 1).as_bytes()));
            assert_eq!(refused.kind(), Kind::Error);
        }
    }
    let Message::ObservationFrame(first) =
        reply(&service.serve(frame(Kind::StepRequest, Some(WIRE_VERSION), 1).as_bytes()))
    else {
        panic!("the session is still open");
    };
    assert_eq!(first.seq, 1);
}

/// `[NCP-STRICT-007]`
#[test]
fn a_request_at_the_key_of_another_kind_is_not_carried_out() {
    for kind in REQUESTS {
        for verb in REQUESTS.into_iter().filter(|verb| *verb != kind) {
            let mut service = SessionService::strict(ReferenceBackend);
            if kind != Kind::OpenSession {
                service.serve_at(Kind::OpenSession, opening(Some(WIRE_VERSION)).as_bytes());
            }
            let open_before = service.open_sessions().len();
            let request = match kind {
                Kind::OpenSession => opening(Some(WIRE_VERSION)),
                _ => frame(kind, Some(WIRE_VERSION), 1),
            };
            let refused = reply(&service.serve_at(verb, request.as_bytes()));
            assert_eq!(refused.kind(), Kind::Error);
            assert_eq!(service.open_sessions().len(), open_before);
            let done = reply(&service.serve_at(kind, request.as_bytes()));
            assert_ne!(done.kind(), Kind::Error);
        }
    }
}

/// `[NCP-STRICT-001] [NCP-STRICT-007]`
#[test]
fn a_strict_client_reaches_a_strict_server_at_the_keys_of_the_kinds() {
    let bus = LocalBus::new();
    let keys = Keys::new(None).unwrap();
    let service = Arc::new(Mutex::new(SessionService::strict(ReferenceBackend)));
    let serving: Vec<_> = REQUESTS
        .into_iter()
        // Nobody answers at the key of run_request.
        .filter(|verb| *verb != Kind::RunRequest)
        .map(|verb| {
            let service = Arc::clone(&service);
            let serve = move |request: &[u8]| {
                let reply = service.lock().unwrap().serve_at(verb, request);
                reply.into_bytes()
            };
            bus.serve(&keys.rpc_verb(verb).unwrap(), serve).unwrap()
        })
        .collect();
    let open = || OpenSession {
        session_id: "s".into(),
        network: NetworkRef { reference: "ncp.reference.rate".into(), ..NetworkRef::default() },
        ..OpenSession::default()
    };
    let step = || StepRequest { session_id: "s".into(), ..StepRequest::default() };
    let mut lenient = NeuroSimClient::new(bus.clone(), None).unwrap();
    assert!(matches!(lenient.open(open()), Err(BusError::NoServer { .. })));
    let mut client = NeuroSimClient::strict(bus.clone(), None).unwrap();
    client.open(open()).unwrap();
    assert_eq!(client.step(step()).unwrap().seq, 1);
    assert!(client.close("s").unwrap().unwrap().ok);
    drop(serving);
}
