//! The line bridge, with clients over Zenoh.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use ncp_spec::wire::{MAX_FRAME_BYTES, MAX_OBSERVATION_BYTES};

use crate::program::Program;
use crate::service::{self, Does, Service};
use crate::{close, error, json, observation, open, step, until};

/// The session that a line names.
fn session(line: &str) -> String {
    json(line.as_bytes())["session_id"].as_str().unwrap().to_owned()
}

#[test]
fn a_session_is_opened_stepped_and_closed_through_the_gateway() {
    let service = service::reference();
    let program = Program::start(service.address(), &[]);
    let client = program.client();
    assert_eq!(client.json(&open("s"))["ok"], true);
    assert_eq!(client.json(&step("s", 2.5))["sim_time_ms"], 2.5);
    assert_eq!(client.json(&close("s"))["ok"], true);
    assert_eq!(client.json(&step("s", 1.0))["kind"], "error");
    let connections: Vec<usize> = service.lines().iter().map(|(connection, _)| *connection).collect();
    assert_eq!(connections, [0; 4], "a client alone has one connection");
}

/// `[NCP-TRANS-003] [NCP-TRANS-004]`
#[test]
fn a_line_feed_in_a_request_smuggles_no_second_one() {
    let service = service::reference();
    let program = Program::start(service.address(), &[]);
    let client = program.client();
    let spaced = step("s", 1.0).replace(':', ":\n\r\n").replace(',', "\n,\t");
    assert!(error(&client.ask(&spaced)).contains("not open"));
    let lines = service.lines();
    assert_eq!(lines.len(), 1, "{lines:?}");
    assert_eq!(json(lines[0].1.as_bytes()), json(step("s", 1.0).as_bytes()));

    let two = format!("{}\n{}", close("s"), close("t"));
    assert!(error(&client.ask(&two)).contains("something follows"));
    assert!(error(&client.ask("{\"kind\":\"step_request\",\"session_id\":\"a\nb\"}")).contains("rejected"));
    assert_eq!(service.lines().len(), 1, "what is no single request is not forwarded");
}

/// `[NCP-TRANS-005]`
#[test]
fn a_reply_that_is_cut_short_or_no_json_or_answers_something_else_is_an_error_frame() {
    let whole = observation("s", 1);
    let service = service::start(move |line| match session(line).as_str() {
        // Whole but for the line feed: nothing tells it from the beginning of a longer one.
        "cut" => Does::Cut(whole.replace("\"s\"", "\"cut\"")),
        "half" => Does::Cut(whole[..20].to_owned()),
        "nothing" => Does::Cut(String::new()),
        "junk" => Does::Reply("Traceback (most recent call last):".to_owned()),
        "pins" => Does::Reply(r#"{"kind":"observation_frame","session_id":"pins","calibrated_posterior":true}"#.into()),
        "other" => Does::Reply(observation("s", 1)),
        "kind" => Does::Reply(close("kind").replace("close_session", "session_closed")),
        "failure" => Does::Reply(r#"{"kind":"error","error":"no","session_id":"other"}"#.to_owned()),
        id => Does::Reply(observation(id, 1)),
    });
    let program = Program::start(service.address(), &[]);
    let client = program.client();
    for (id, says, cause) in [
        ("cut", "before its reply was whole", "cut"),
        ("half", "before its reply was whole", "cut"),
        ("nothing", "before its reply was whole", "cut"),
        ("junk", "rejected", "reply_rejected"),
        ("pins", "rejected", "reply_rejected"),
        ("other", "not one to this", "misfit"),
        ("kind", "not one to this", "misfit"),
        ("failure", "not one to this", "misfit"),
    ] {
        let counter = format!("ncp_gateway_error_frames_total{{cause=\"{cause}\"}}");
        let before = program.counted(&counter);
        let reply = client.ask(&step(id, 1.0));
        assert!(error(&reply).contains(says), "{id}: {}", String::from_utf8_lossy(&reply));
        assert_eq!(json(&reply)["session_id"], id);
        assert_eq!(program.counted(&counter), before + 1.0, "{id}");
        assert_eq!(client.json(&step("fine", 1.0))["session_id"], "fine", "after {id}");
    }
    let mut connections: Vec<usize> = service.lines().iter().map(|(connection, _)| *connection).collect();
    connections.dedup();
    assert_eq!(connections, (0..=8).collect::<Vec<_>>(), "each costs its connection, and no other");
    assert_eq!(program.counted("ncp_gateway_reconnects_total"), 8.0);
}

/// `[NCP-TRANS-001]`
#[test]
fn a_reply_arrives_byte_for_byte() {
    let reply = r#" {"kind" : "observation_frame","session_id":"s","sim_time_ms":1.50,"mood":"good"} "#;
    let service = service::start(move |_| Does::Reply(reply.to_owned()));
    let program = Program::start(service.address(), &[]);
    assert_eq!(String::from_utf8_lossy(&program.client().ask(&step("s", 1.0))), reply);
}

/// `[NCP-TRANS-007]`
#[test]
fn a_slow_session_holds_up_no_other() {
    let service = service::start(|line| match session(line).as_str() {
        "slow" => Does::Late(Duration::from_secs(4), observation("slow", 1)),
        id => Does::Reply(observation(id, 1)),
    });
    let program = Program::start(service.address(), &[]);
    let (slow, fast) = (program.client(), program.client());
    thread::scope(|scope| {
        let slow = scope.spawn(|| slow.json(&step("slow", 1.0)));
        until("the slow one is asked", || !service.lines().is_empty());
        for number in 0..10 {
            assert_eq!(fast.json(&step("fast", 1.0))["session_id"], "fast", "{number}");
        }
        assert!(!slow.is_finished(), "ten steps beside it were answered first");
        assert_eq!(slow.join().unwrap()["session_id"], "slow");
    });
}

/// `[NCP-SESS-036]`
#[test]
fn the_requests_of_one_session_reach_the_service_in_their_order_one_at_a_time() {
    const REQUESTS: usize = 20;
    let (inside, most) = (AtomicUsize::new(0), std::sync::Arc::new(AtomicUsize::new(0)));
    let seen = std::sync::Arc::clone(&most);
    let service = service::start(move |line| {
        seen.fetch_max(inside.fetch_add(1, Ordering::SeqCst) + 1, Ordering::SeqCst);
        thread::sleep(Duration::from_millis(5));
        inside.fetch_sub(1, Ordering::SeqCst);
        Does::Reply(observation(&session(line), 1))
    });
    let program = Program::start(service.address(), &[]);
    // Messages of one WebSocket come in their order; those of several queries need not.
    let mut socket = crate::websocket::connect(&program);
    for number in 0..REQUESTS {
        crate::websocket::send(&mut socket, &step("s", number as f64));
    }
    for _ in 0..REQUESTS {
        assert_eq!(json(&crate::websocket::receive(&mut socket))["session_id"], "s");
    }
    let asked = service.lines().into_iter().map(|(_, line)| json(line.as_bytes())["advance_ms"].as_f64().unwrap());
    assert_eq!(asked.collect::<Vec<_>>(), (0..REQUESTS).map(|number| number as f64).collect::<Vec<_>>());
    assert_eq!(most.load(Ordering::SeqCst), 1);
}

/// `[NCP-TRANS-006]`
#[test]
fn a_service_that_does_not_answer_is_given_up_before_its_client_gives_up() {
    let service = service::start(|_| Does::Nothing);
    let program = Program::start(service.address(), &[]);
    let client = program.client();
    let began = Instant::now();
    // The client waits for 10 s, and would panic.
    let reply = client.ask(&step("s", 1.0));
    assert!(error(&reply).contains("no reply of the simulation service within 8s; the request may have been carried"));
    assert!(began.elapsed() >= Duration::from_secs(8));
    assert_eq!(program.counted("ncp_gateway_error_frames_total{cause=\"timed_out\"}"), 1.0);
}

#[test]
fn a_late_reply_is_never_the_next_ones() {
    let late = Duration::from_millis(1_500);
    let service = service::start(move |line| match session(line).as_str() {
        "late" => Does::Late(late, observation("s", 13)),
        id => Does::Reply(observation(id, 1)),
    });
    let program = Program::start(service.address(), &[("NCP_BRIDGE_TIMEOUT_MS", "1000")]);
    let client = program.client();
    assert!(error(&client.ask(&step("late", 1.0))).contains("no reply"));
    let began = Instant::now();
    while began.elapsed() < 2 * late {
        assert_eq!(client.json(&step("s", 1.0))["seq"], 1);
        thread::sleep(Duration::from_millis(50));
    }
    let first = service.lines().into_iter().filter(|(connection, _)| *connection == 0);
    assert_eq!(first.count(), 1, "the connection of the late reply is not used again");
}

#[test]
fn a_request_whose_time_ran_out_in_the_queue_is_not_forwarded() {
    let service = service::start(|_| Does::Nothing);
    let program = Program::start(service.address(), &[("NCP_BRIDGE_TIMEOUT_MS", "1500")]);
    let mut socket = crate::websocket::connect(&program);
    crate::websocket::send(&mut socket, &step("s", 1.0));
    crate::websocket::send(&mut socket, &step("s", 2.0));
    assert!(error(&crate::websocket::receive(&mut socket)).contains("may have been carried out"));
    assert!(error(&crate::websocket::receive(&mut socket)).contains("was not carried out"));
    assert_eq!(service.lines().len(), 1);
}

#[test]
fn a_dead_service_is_an_error_frame_and_one_that_comes_back_is_found() {
    let service = service::reference();
    let program = Program::start(service.address(), &[]);
    let client = program.client();
    assert_eq!(client.json(&open("s"))["ok"], true);
    let address = service::die(service);
    let began = Instant::now();
    for _ in 0..3 {
        assert!(error(&client.ask(&step("s", 1.0))).contains("cannot be reached"));
    }
    assert!(began.elapsed() < Duration::from_secs(5), "nobody waits for the dead");

    let service = Service::reference(address).unwrap();
    assert_eq!(client.json(&open("s"))["ok"], true);
    assert_eq!(client.json(&step("s", 1.0))["sim_time_ms"], 1.0);
    assert_eq!(service.lines().len(), 2);
    assert_eq!(program.counted("ncp_gateway_reconnects_total"), 1.0);
    assert!(program.says("connected to the service again"));
}

#[test]
fn a_request_that_died_with_the_service_is_not_sent_again() {
    let service = service::start(|_| Does::Cut(String::new()));
    let program = Program::start(service.address(), &[]);
    assert!(error(&program.client().ask(&step("s", 1.0))).contains("may have been carried out"));
    assert_eq!(service.lines().len(), 1);
}

#[test]
fn what_is_longer_than_a_frame_is_not_carried_in_either_direction() {
    let service = service::start(|line| {
        let padding = if session(line) == "long" { MAX_OBSERVATION_BYTES } else { 2 * MAX_FRAME_BYTES };
        Does::Reply(observation(&session(line), 1) + &" ".repeat(padding))
    });
    // So many bytes take their time on a machine that is at other work.
    let patient = [("NCP_BRIDGE_TIMEOUT_MS", "60000"), ("NCP_QUERY_TIMEOUT_MS", "60001")];
    let program = Program::start(service.address(), &patient);
    let mut socket = crate::websocket::connect(&program);
    let mut ask = |request: &str| {
        crate::websocket::send(&mut socket, request);
        crate::websocket::receive(&mut socket)
    };
    let too_long = error(&ask(&step("long", 1.0)));
    assert!(too_long.contains("more than 67108864 bytes"), "{too_long}");
    assert_eq!(json(&ask(&step("short", 1.0)))["session_id"], "short");

    let too_long = error(&ask(&(step("s", 1.0) + &" ".repeat(MAX_FRAME_BYTES))));
    assert!(too_long.contains("more than 1048576"), "{too_long}");
    assert_eq!(json(&ask(&step("s", 1.0)))["session_id"], "s");
    assert_eq!(service.lines().len(), 3);
}

/// `[NCP-TRANS-010]`
#[test]
fn a_gateway_that_is_told_to_end_answers_what_is_in_flight_takes_nothing_new_and_ends_with_0() {
    let service = service::start(|line| match session(line).as_str() {
        "slow" => Does::Late(Duration::from_secs(2), observation("slow", 1)),
        id => Does::Reply(observation(id, 1)),
    });
    let mut program = Program::start(service.address(), &[]);
    let mut socket = crate::websocket::connect(&program);
    let client = program.client();
    thread::scope(|scope| {
        let in_flight = scope.spawn(|| client.json(&step("slow", 1.0)));
        crate::websocket::send(&mut socket, &step("fast", 1.0));
        until("both are asked", || service.lines().len() == 2);
        program.terminate();
        until("it stops", || program.says("stopping"));
        assert_eq!(in_flight.join().unwrap()["session_id"], "slow");
    });
    assert_eq!(json(&crate::websocket::receive(&mut socket))["session_id"], "fast");
    // What comes now is not read: the socket is closed, and says that the gateway goes away.
    crate::websocket::try_send(&mut socket, &step("new", 1.0));
    assert_eq!(crate::websocket::closed(&mut socket), Some(1001));
    assert_eq!(program.wait().code(), Some(0));
    assert_eq!(service.lines().len(), 2, "nothing new is taken");
}
