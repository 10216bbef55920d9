//! The conversation of `peers/PROTOCOL.md`, held with the real program.

#![expect(clippy::unwrap_used, clippy::panic, reason = "a test may fail that way")]

use std::io::{BufRead, BufReader, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, ExitStatus, Stdio};
use std::thread;

use ncp_text::{CONTRACT_HASH, WIRE_VERSION};
use serde_json::{Value, json};

const PROTOCOL: &str = include_str!("../../PROTOCOL.md");

/// The section of the protocol page with this heading, its number aside.
fn section(heading: &str) -> &'static str {
    let mut sections = PROTOCOL.split("\n## ");
    let section = sections
        .find(|section| section.split_once(". ").is_some_and(|(_, rest)| rest.starts_with(&format!("{heading}\n"))));
    section.unwrap_or_else(|| panic!("PROTOCOL.md has no section {heading:?}"))
}

/// The program, started, with its ends of the conversation.
struct Peer {
    child: Child,
    requests: ChildStdin,
    answers: BufReader<ChildStdout>,
}

impl Peer {
    fn start() -> Self {
        let mut child = Command::new(env!("CARGO_BIN_EXE_ncp-peer-rust"))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let requests = child.stdin.take().unwrap();
        let answers = BufReader::new(child.stdout.take().unwrap());
        Self { child, requests, answers }
    }

    /// Sends a request and waits for its answer, with standard input still open.
    fn ask(&mut self, request: &Value) -> Value {
        self.send(&format!("{request}\n"));
        self.next_answer()
    }

    fn send(&mut self, text: &str) {
        self.requests.write_all(text.as_bytes()).unwrap();
        self.requests.flush().unwrap();
    }

    fn next_answer(&mut self) -> Value {
        let mut line = String::new();
        self.answers.read_line(&mut line).unwrap();
        serde_json::from_str(&line).unwrap_or_else(|error| panic!("{error}: {line:?}"))
    }

    /// Ends the input; gives how the program ended and what it printed since.
    fn end(self) -> (ExitStatus, String, String) {
        drop(self.requests);
        let answers: String = self.answers.lines().map(|line| line.unwrap() + "\n").collect();
        let output = self.child.wait_with_output().unwrap();
        (output.status, answers, String::from_utf8(output.stderr).unwrap())
    }
}

/// The result of one call; a refusal is a panic.
fn result(call: &str, args: &Value) -> Value {
    let answer = Peer::start().ask(&json!({"id": 1, "call": call, "args": args}));
    assert!(answer["result"].is_object(), "{call} {args}: {answer}");
    answer["result"].clone()
}

/// The error code of one call; a result is a panic.
fn refusal(call: &str, args: &Value) -> String {
    let answer = Peer::start().ask(&json!({"id": 1, "call": call, "args": args}));
    let code = answer["error"]["code"].as_str();
    code.unwrap_or_else(|| panic!("{call} {args}: {answer}")).to_owned()
}

/// Frames are compared as JSON: how a number is spelled is the peer's own affair.
fn with_parsed_text(mut result: Value) -> Value {
    if let Some(text) = result["text"].as_str() {
        result["text"] = serde_json::from_str(text).unwrap();
    }
    result
}

#[test]
fn the_transcript_of_the_protocol_page_is_what_this_peer_says() {
    let lines = |arrow| {
        let lines = section("A transcript").lines().filter_map(move |line| line.strip_prefix(arrow));
        let filled = lines.map(|line| line.replace("{version}", WIRE_VERSION).replace("{hash}", CONTRACT_HASH));
        filled.map(|line| serde_json::from_str::<Value>(&line).unwrap()).collect::<Vec<_>>()
    };
    let (requests, answers) = (lines("→ "), lines("← "));
    assert_eq!(requests.len(), answers.len());
    assert!(!requests.is_empty());

    let mut peer = Peer::start();
    for request in &requests {
        let answer = peer.ask(request);
        let printed = answers.iter().find(|answer| answer["id"] == request["id"]).unwrap();
        assert_eq!(answer["id"], request["id"]);
        if request["call"] == "describe" {
            // Another peer's name and roles, but the same contract.
            for member in ["wire_version", "contract_hash"] {
                assert_eq!(answer["result"][member], printed["result"][member]);
            }
        } else if printed["error"].is_object() {
            assert_eq!(answer["error"]["code"], printed["error"]["code"], "{request}");
        } else if printed["result"].is_object() {
            let [is, printed] = [&answer, printed].map(|answer| with_parsed_text(answer["result"].clone()));
            assert_eq!(is, printed, "{request}");
        } else {
            // The peer of the page lacks what this one has.
            assert_eq!(printed["unsupported"], true);
            assert!(answer["result"].is_object(), "{request}: {answer}");
        }
    }
}

#[test]
fn every_call_of_the_protocol_page_is_known() {
    let headings = ["Calls", "Calls with a trace"]
        .into_iter()
        .flat_map(|heading| section(heading).lines())
        .filter_map(|line| line.strip_prefix("### "));
    let calls: Vec<&str> = headings.flat_map(|line| line.split('`').skip(1).step_by(2)).collect();
    assert!(calls.contains(&"describe") && calls.contains(&"session.run"), "{calls:?}");
    let mut peer = Peer::start();
    for call in calls {
        let answer = peer.ask(&json!({"id": 1, "call": call, "args": {}}));
        assert!(answer.get("unsupported").is_none(), "{call}: {answer}");
    }
}

#[test]
fn an_unknown_call_is_unsupported_whatever_its_arguments() {
    let mut peer = Peer::start();
    for args in [json!({}), json!(null), json!([1, "x"])] {
        let answer = peer.ask(&json!({"id": 9, "call": "govern.run", "args": args}));
        assert_eq!(answer, json!({"id": 9, "unsupported": true}));
    }
}

#[test]
fn the_members_of_a_request_may_stand_in_any_order_and_be_escaped() {
    let mut peer = Peer::start();
    let escaped = WIRE_VERSION.replace('.', r"\u002e");
    peer.send(&format!(
        r#" {{"args":{{"strict": false, "version": "{escaped}"}}, "call": "version\u002echeck", "more":[], "id": 3}} "#
    ));
    peer.send("\r\n");
    assert_eq!(peer.next_answer(), json!({"id": 3, "result": {"compatible": true}}));
}

#[test]
fn a_line_that_is_no_request_is_reported_and_costs_nothing_else() {
    let mut peer = Peer::start();
    for garbage in ["garbage\n", "{\"id\":1}\n", "\u{0}\n", "\n", "[]\n"] {
        peer.send(garbage);
    }
    peer.requests.write_all(b"\xff\xfe\n").unwrap();
    let answer = peer.ask(&json!({"id": 2, "call": "version.check", "args": {"version": "0.4", "strict": false}}));
    assert_eq!(answer, json!({"id": 2, "result": {"compatible": false}}));
    let (status, answers, log) = peer.end();
    assert!(status.success());
    assert_eq!(answers, "");
    assert_eq!(log.lines().count(), 5, "{log}");
    assert!(log.lines().all(|line| line.starts_with("not a request: ")), "{log}");
}

#[test]
fn the_end_of_the_input_ends_the_program_with_code_0() {
    let (status, answers, log) = Peer::start().end();
    assert_eq!((status.code(), answers.as_str(), log.as_str()), (Some(0), "", ""));
}

#[test]
fn the_last_request_may_lack_its_line_feed() {
    let mut peer = Peer::start();
    peer.send(r#"{"id":1,"call":"contract.status","args":{"peer_hash":null}}"#);
    let (status, answers, _) = peer.end();
    assert!(status.success());
    assert_eq!(answers, "{\"id\":1,\"result\":{\"status\":\"not_advertised\"}}\n");
}

#[test]
fn a_thousand_requests_in_flight_are_each_answered_once() {
    let Peer { child, mut requests, answers } = Peer::start();
    let writer = thread::spawn(move || {
        for id in 0..1000 {
            let args = json!({"key": "sensor", "realm": null, "session": format!("s{id}"), "name": null});
            writeln!(requests, "{}", json!({"id": id, "call": "key.build", "args": args})).unwrap();
        }
    });
    let mut seen: Vec<u64> = answers
        .lines()
        .map(|line| {
            let answer: Value = serde_json::from_str(&line.unwrap()).unwrap();
            let id = answer["id"].as_u64().unwrap();
            assert_eq!(answer["result"]["key"], format!("ncp/session/s{id}/sensor"));
            id
        })
        .collect();
    writer.join().unwrap();
    seen.sort_unstable();
    assert!(seen.into_iter().eq(0..1000));
    assert!(child.wait_with_output().unwrap().status.success());
}

#[test]
fn a_frame_of_64_mib_is_read_and_one_byte_more_is_a_limit() {
    const LIMIT: usize = 64 << 20;
    let head = r#"{"kind":"observation_frame","session_id":"s","records":{}"#;
    let ask = |len: usize| {
        let text = format!("{head}{}}}", " ".repeat(len - head.len() - 1));
        assert_eq!(text.len(), len);
        let mut peer = Peer::start();
        let args = json!({"kind": "observation_frame", "text": text});
        peer.ask(&json!({"id": 1, "call": "decode", "args": args}))
    };
    let read = ask(LIMIT);
    assert!(read["result"]["text"].as_str().unwrap().contains(r#""session_id":"s""#), "{read}");
    assert_eq!(ask(LIMIT + 1)["error"]["code"], "limit");
}

#[test]
fn frames_that_are_not_utf_8_arrive_as_bytes() {
    // `{"kind":"error","error":"` 0xff `"}`
    let broken = "eyJraW5kIjoiZXJyb3IiLCJlcnJvciI6Iv8ifQ==";
    assert_eq!(refusal("decode", &json!({"kind": "error", "base64": broken})), "malformed");
    // `{"kind":"error","error":"x"}`
    let sound = "eyJraW5kIjoiZXJyb3IiLCJlcnJvciI6IngifQ==";
    let text = result("decode", &json!({"kind": "error", "base64": sound}))["text"].clone();
    let text: Value = serde_json::from_str(text.as_str().unwrap()).unwrap();
    assert_eq!(text["error"], "x");
}

#[test]
fn encode_sets_what_is_named_and_leaves_the_programs_defaults() {
    let text = |kind: &str, fields: Value| -> Value {
        let result = result("encode", &json!({"kind": kind, "fields": fields}));
        serde_json::from_str(result["text"].as_str().unwrap()).unwrap()
    };
    let setpoint = json!({"v": {"data": [1.5, "-0"], "unit": null}});
    let fields = json!({"seq": 7, "channels": {"v": {"data": [1.5, "-0"]}}, "horizon": [setpoint]});
    let frame = text("command_frame", fields);
    assert_eq!(frame["mode"], "active");
    assert_eq!(frame["seq"], 7);
    assert_eq!(frame["ttl_ms"], 200.0);
    assert_eq!(frame["horizon"][0], frame["channels"]);
    assert!(frame["channels"]["v"]["data"][1].as_f64().unwrap().is_sign_negative());

    let frame = text("open_session", json!({"session_id": "s", "sim": {"dt_ms": 0.5}, "network": {"ref": "n"}}));
    assert_eq!(frame["contract_hash"], CONTRACT_HASH);
    assert_eq!((&frame["sim"]["dt_ms"], &frame["sim"]["chunk_ms"]), (&json!(0.5), &json!(10.0)));
    assert_eq!((&frame["network"]["kind"], &frame["network"]["ref"]), (&json!("builtin"), &json!("n")));

    let frame = text("error", json!({"error": "busy"}));
    assert_eq!(frame, json!({"kind": "error", "error": "busy"}));
}

#[test]
fn what_the_encoder_refuses_reaches_it() {
    for (fields, code) in [
        (json!({"t": "Infinity"}), "non_finite"),
        (json!({"channels": {"v": {"data": ["NaN"]}}}), "non_finite"),
        (json!({"seq": 9_007_199_254_740_992_i64}), "value"),
        (json!({"seq": -9_007_199_254_740_992_i64}), "value"),
        (json!({"seq": "7"}), "type"),
    ] {
        assert_eq!(refusal("encode", &json!({"kind": "command_frame", "fields": fields})), code);
    }
}

#[test]
fn arguments_that_the_page_does_not_allow_are_never_taken_for_a_refusal() {
    for (call, args) in [
        ("decode", json!({"kind": "command_frame"})),
        ("decode", json!({"kind": "command_frame", "text": "{}", "base64": "e30="})),
        ("decode", json!({"kind": "no_such_kind", "text": "{}"})),
        ("decode", json!({"kind": "command_frame", "base64": "!"})),
        ("encode", json!({"kind": "command_frame", "fields": {"no_such_field": 1}})),
        ("encode", json!({"kind": "command_frame", "fields": []})),
        ("key.build", json!({"key": "sensor", "realm": null})),
        ("key.build", json!({"key": "no_such_key", "realm": null})),
        ("plane.qos", json!({"plane": "no_such_plane"})),
        ("bulk.encode", json!({"columns": [{"name": "x", "dtype": "f16", "data": []}]})),
        ("bulk.encode", json!({"columns": [{"name": "x", "dtype": "i64", "data": [1]}]})),
        ("observation.pack", json!({"times": [], "values": ["nan"], "senders": []})),
        ("reply.check", json!({"request": "no frame", "reply": "{}"})),
        ("negotiate", json!({"version": 5, "contract_hash": null})),
    ] {
        assert_eq!(refusal(call, &args), "internal", "{call} {args}");
    }
}

#[test]
fn version_and_contract_calls_answer_as_their_chapter_says() {
    let own = CONTRACT_HASH;
    let other = "2cf0763ad61e4f1c";
    assert_eq!(refusal("version.check", &json!({"version": "0.4", "strict": true})), "version");
    assert_eq!(result("contract.status", &json!({"peer_hash": other})), json!({"status": "mismatch"}));
    assert_eq!(result("contract.verify", &json!({"peer_hash": own})), json!({}));
    assert_eq!(refusal("contract.verify", &json!({"peer_hash": other})), "contract");
    assert_eq!(
        result("negotiate", &json!({"version": WIRE_VERSION, "contract_hash": own})),
        json!({"contract": "match"})
    );
    assert_eq!(refusal("negotiate", &json!({"version": "1", "contract_hash": own})), "version");
}

#[test]
fn key_and_plane_calls_answer_as_their_chapter_says() {
    let build = |key, name| json!({"key": key, "realm": "a/b", "session": "s", "name": name});
    for (key, name, built) in [
        ("rpc", None, "a/b/rpc"),
        ("sensor", Some("front"), "a/b/session/s/sensor/front"),
        ("command", None, "a/b/session/s/command"),
        ("observation", None, "a/b/session/s/observation"),
        ("sensor_glob", None, "a/b/session/s/sensor/**"),
        ("command_glob", None, "a/b/session/s/command/**"),
        ("session_glob", None, "a/b/session/s/**"),
        ("fleet_glob", None, "a/b/session/**"),
    ] {
        assert_eq!(result("key.build", &build(key, name)), json!({"key": built}));
    }
    assert_eq!(refusal("key.build", &build("sensor", Some("a/b"))), "key");
    assert_eq!(
        result("key.match", &json!({"pattern": "ncp/session/**", "key": "ncp/session"})),
        json!({"matches": true})
    );
    assert_eq!(
        result("plane.qos", &json!({"plane": "action"})),
        json!({"congestion": "drop", "priority": "RealTime", "express": true})
    );
}

#[test]
fn columns_survive_a_block() {
    let columns = json!({"columns": [
        {"name": "f", "dtype": "f32", "data": [0.5, "NaN", "-0", f64::from(0.1_f32)]},
        {"name": "d", "dtype": "f64", "data": ["Infinity", "-Infinity", 5e-324, 0.1]},
        {"name": "i", "dtype": "i32", "data": [i32::MIN, 0, i32::MAX]},
        {"name": "l", "dtype": "i64", "data": ["-9223372036854775808", "9223372036854775807"]},
        {"name": "", "dtype": "i64", "data": []},
    ]});
    let block = result("bulk.encode", &columns);
    assert_eq!(result("bulk.decode", &block), columns);
    assert_eq!(refusal("bulk.decode", &json!({"block": "TkNQQg=="})), "block");
}

#[test]
fn an_observation_survives_its_block() {
    let arrays = json!({"times": [1.5, 2.5, 9.0], "values": [], "senders": ["7", "7", "9"]});
    let block = result("observation.pack", &arrays);
    assert!(block["block"].as_str().unwrap().starts_with("TkNQQgEAAgBoAAAA"), "{block}");
    assert_eq!(result("observation.unpack", &block), arrays);
    let uneven = json!({"times": [1.0], "values": [1.0, 2.0], "senders": []});
    assert_eq!(refusal("observation.pack", &uneven), "block");
}

#[test]
fn a_reply_is_held_against_its_request() {
    let frame = |kind: &str| json!({"ncp_version": WIRE_VERSION, "kind": kind, "session_id": "s"});
    let request = frame("close_session").to_string();
    let reply = |ok: bool| {
        let mut reply = frame("session_closed");
        reply["ok"] = json!(ok);
        reply.to_string()
    };
    assert_eq!(result("reply.check", &json!({"request": request, "reply": reply(true)})), json!({}));
    assert_eq!(refusal("reply.check", &json!({"request": request, "reply": reply(false)})), "reply");
}

#[test]
fn a_governor_remembers_its_latch_and_shows_every_field_of_the_frame() {
    let command = json!({"seq": 7, "t": "NaN", "channels": {"velocity_setpoint": {"data": [3, 4, 0], "unit": "m/s"}}});
    let at = |x: f64| {
        json!({"op": "govern", "now_s": 1, "last_sensor_s": 1, "command": command,
            "sensor": {"channels": {"pose_position": {"data": [x, 0, 0], "unit": "m"}}}})
    };
    let args = json!({
        "limits": {"max_speed_mps": 5, "geofence_radius_m": 10},
        "capabilities": null,
        "steps": [at(0.0), {"op": "note_link", "burst": false}, at(11.0), at(0.0), {"op": "reset"}, at(0.0)],
    });
    let steps = result("governor.run", &args)["steps"].clone();
    let built = result("encode", &json!({"kind": "command_frame", "fields": {}}))["text"].clone();
    let mut frame: Value = serde_json::from_str(built.as_str().unwrap()).unwrap();
    frame["seq"] = json!(7);
    frame["t"] = json!("NaN");
    frame["channels"] = json!({"velocity_setpoint": {"data": [3.0, 4.0, 0.0], "unit": "m/s"}});
    assert_eq!(frame["mode"], "active");
    assert_eq!(steps[0]["frame"], frame);
    assert_eq!(steps[1], json!({}));
    let modes: Vec<&Value> = [2, 3, 5].iter().map(|step| &steps[*step]["frame"]["mode"]).collect();
    assert_eq!(modes, ["estop", "estop", "active"]);
}

#[test]
fn a_governor_is_built_for_the_channels_that_were_negotiated() {
    let args = |unit: &str| {
        json!({
            "limits": {"max_speed_mps": 1},
            "capabilities": {
                "sensor_channels": [],
                "command_channels": [{"name": "velocity_setpoint", "kind": "vec3", "unit": unit}],
            },
            "steps": [{"op": "govern", "now_s": 1, "last_sensor_s": 1, "sensor": null,
                "command": {"channels": {"velocity_setpoint": {"data": [1, 0, 0], "unit": "m/s"}}}}],
        })
    };
    for (unit, mode) in [("m/s", "active"), ("km/h", "hold")] {
        let steps = result("governor.run", &args(unit))["steps"].clone();
        assert_eq!(steps[0]["frame"]["mode"], mode, "{unit}");
    }
}

#[test]
fn a_refused_step_is_an_entry_and_the_trace_goes_on() {
    let frame = r#"{"kind":"command_frame","seq":1,"mode":"active","ttl_ms":100,"channels":{"a":{"data":[-0.0,1]}}}"#;
    let malformed_estop = "eyJraW5kIjoiY29tbWFuZF9mcmFtZSIsIm1vZGUiOiJlc3RvcCIsInNlcSI6IngifQ==";
    let args = json!({"steps": [
        {"op": "active", "now_s": 0},
        {"op": "command", "text": "{", "now_s": 0},
        {"op": "command", "text": frame, "now_s": 0},
        {"op": "active", "now_s": 0.05},
        {"op": "command", "base64": malformed_estop, "now_s": 0.06},
        {"op": "active", "now_s": 0.07},
    ]});
    let mut steps = result("buffer.run", &args)["steps"].clone();
    assert_eq!(steps[1]["error"]["code"], "malformed");
    steps[1] = json!(null);
    assert_eq!(
        steps,
        json!([
            {"channels": null}, null, {}, {"channels": {"a": {"data": ["-0", 1.0], "unit": null}}}, {},
            {"channels": null},
        ])
    );
}

#[test]
fn a_watchdog_a_link_and_a_horizon_are_asked_by_steps_and_numbers() {
    let args = json!({"steps": [
        {"op": "should_hold", "now_s": 0},
        {"op": "command", "now_s": 0, "ttl_ms": "Infinity", "seq": 1},
        {"op": "should_hold", "now_s": 0},
        {"op": "command", "now_s": 0, "ttl_ms": 100, "seq": 2},
        {"op": "should_hold", "now_s": 0.1},
        {"op": "reset"},
        {"op": "should_hold", "now_s": 0.1},
    ]});
    assert_eq!(
        result("watchdog.run", &args)["steps"],
        json!([{"hold": true}, {}, {"hold": true}, {}, {"hold": false}, {}, {"hold": true}])
    );
    let args =
        json!({"ref_loss": 0, "threshold": null, "steps": [{"op": "frame", "seq": 1}, {"op": "frame", "seq": 8}]});
    assert_eq!(
        result("link.run", &args)["steps"][1],
        json!({"last_seq": 8, "received": 2, "lost": 6, "loss_rate": 0.75, "burst": true})
    );
    assert_eq!(result("horizon.max_len", &json!({"ttl_ms": 200, "dt_ms": 60})), json!({"len": 3}));
}

#[test]
fn a_codec_and_a_reflex_turn_frames_into_rates_and_commands() {
    let sensor = json!({"channels": {"pose_error": {"data": [2, "NaN"], "unit": "m"}}});
    assert_eq!(
        result("codec.encode", &json!({"codec": "uav", "sensor": sensor})),
        json!({"rates": {"err_x": 200.0, "err_y": 100.0, "err_z": 100.0}})
    );
    let codec = json!({"encoders": [], "decoders": [
        {"channel": "a", "component": 1, "population": "p", "value_range": [0, 10], "unit": "m"},
    ]});
    let args = json!({"codec": codec, "rates": {"p": 50}, "t": 2, "seq": 3, "frame_id": "f", "mode": "hold"});
    let command = result("codec.decode", &args)["command"].clone();
    assert_eq!(command["channels"], json!({"a": {"data": [0.0, 2.5], "unit": "m"}}));
    assert_eq!((&command["seq"], &command["mode"]), (&json!(3), &json!("hold")));

    let sensor = json!({"channels": {"pose_position": {"data": [1, 0, -1], "unit": "m"}}});
    let args = json!({"config": {"target": [0, 0, 1], "max_speed": 1.25}, "sensor": sensor});
    assert_eq!(
        result("reflex.step", &args)["command"]["channels"]["velocity_setpoint"]["data"],
        json!([-1.0, -0.0, 1.25])
    );
    assert_eq!(refusal("reflex.step", &json!({"config": {"kp": "NaN"}, "sensor": null})), "value");
}

#[test]
fn a_loop_and_a_server_run_as_a_whole() {
    let sensor = |seq| {
        let channels = json!({"pose_position": {"data": [1, 0, 0]}});
        json!({"op": "sensor", "now_s": 1, "sensor": {"seq": seq, "channels": channels}})
    };
    let mut args = json!({"period_ms": 150, "limits": {}, "config": {}, "steps": [
        {"op": "tick", "now_s": 0}, sensor(5), sensor(4), {"op": "tick", "now_s": 1.1}, {"op": "reset"},
    ]});
    let steps = result("loop.run", &args)["steps"].clone();
    assert_eq!(steps[0]["command"]["mode"], "hold");
    let command = &steps[3]["command"];
    assert_eq!((&command["mode"], &command["seq"], &command["ttl_ms"]), (&json!("active"), &json!(5), &json!(300.0)));
    assert_eq!((&steps[3]["status"]["seq"], &steps[3]["status"]["safety_ok"]), (&json!(2), &json!(true)));
    args["period_ms"] = json!(0);
    assert_eq!(refusal("loop.run", &args), "value");

    let network = json!({"kind": "builtin", "ref": "ncp.reference.rate"});
    let open = json!({"ncp_version": WIRE_VERSION, "kind": "open_session", "session_id": "s", "network": network});
    let close = json!({"kind": "close_session", "session_id": "s"});
    let requests = [&close, &open, &close].map(Value::to_string);
    let replies = result("session.run", &json!({"requests": requests}))["replies"].clone();
    let ok = |nth: usize| {
        let reply: Value = serde_json::from_str(replies[nth].as_str().unwrap()).unwrap();
        reply["ok"].clone()
    };
    assert_eq!([ok(0), ok(1), ok(2)], [json!(false), json!(true), json!(true)]);
}

#[test]
fn a_step_that_the_protocol_page_does_not_allow_is_no_refusal_of_the_implementation() {
    for (call, args) in [
        ("watchdog.run", json!({"steps": [{"op": "sing"}]})),
        ("watchdog.run", json!({"steps": [{"op": "should_hold"}]})),
        ("buffer.run", json!({"steps": [{"op": "command", "now_s": 0}]})),
        ("governor.run", json!({"limits": {"max_sped": 1}, "steps": []})),
        ("codec.encode", json!({"codec": "usv", "sensor": null})),
    ] {
        assert_eq!(refusal(call, &args), "internal", "{call} {args}");
    }
}
