//! The generated schemas: fresh on disk, valid, self-contained, and as strict as the text.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that cannot go on has failed")]

use std::{collections::BTreeMap, fs, path::Path};

use jsonschema::Validator;
use ncp_proto::{
    DESCRIPTOR_SET, PROJECTION_TEXT,
    contract::Contract,
    schema::{GAPS, gap, generate, generate_from},
};
use ncp_spec::WIRE_VERSION;
use proptest::prelude::*;
use serde_json::{Value, json};

const SCHEMAS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../schemas");

#[test]
fn the_schemas_on_disk_are_what_the_contract_generates() {
    let stale: Vec<_> = generate()
        .into_iter()
        .filter(|(name, text)| fs::read_to_string(Path::new(SCHEMAS).join(name)).ok().as_ref() != Some(text))
        .map(|(name, _)| format!("schemas/{name}"))
        .collect();
    assert!(stale.is_empty(), "stale, if the change is meant run `cargo xtask generate`: {stale:?}");
}

#[test]
fn every_schema_on_disk_is_generated_or_written_by_hand() {
    let generated: Vec<_> = generate().into_iter().map(|(name, _)| name).collect();
    let by_hand = ["vector-file.schema.json", "result.schema.json", "gate.schema.json"];
    let strays: Vec<_> = fs::read_dir(SCHEMAS)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| name.ends_with(".json") && !generated.contains(name) && !by_hand.contains(&name.as_str()))
        .collect();
    assert_eq!(strays, Vec::<String>::new());
}

#[test]
fn there_is_a_schema_for_each_kind_and_the_error_frame() {
    let contract = Contract::current().unwrap();
    let mut kinds: Vec<_> = contract.kinds().map(|(kind, ..)| format!("{kind}.schema.json")).collect();
    kinds.push("error.schema.json".to_owned());
    assert_eq!(generate().into_iter().map(|(name, _)| name).collect::<Vec<_>>(), kinds);
    assert_eq!(kinds.len(), 15);
}

#[test]
fn every_schema_is_a_valid_schema_that_refers_to_nothing_outside_itself() {
    let by_hand = fs::read_to_string(Path::new(SCHEMAS).join("vector-file.schema.json")).unwrap();
    for (name, text) in generate().into_iter().chain([("vector-file.schema.json".to_owned(), by_hand)]) {
        let schema: Value = serde_json::from_str(&text).unwrap();
        jsonschema::draft202012::meta::validate(&schema).unwrap_or_else(|error| panic!("{name}: {error}"));
        for reference in references(&schema) {
            let pointer = reference.strip_prefix('#').unwrap_or_else(|| panic!("{name}: {reference}"));
            assert!(schema.pointer(pointer).is_some(), "{name}: {reference}");
        }
    }
}

#[test]
fn the_smallest_frame_of_each_kind_is_accepted_and_each_lack_in_it_rejected() {
    let schemas = Schemas::new();
    for (kind, frame) in smallest() {
        schemas.accept(kind, &frame);
        for member in frame.as_object().unwrap().keys() {
            let mut lacking = frame.clone();
            lacking.as_object_mut().unwrap().remove(member);
            schemas.reject(kind, &lacking);
        }
    }
}

#[test]
fn a_frame_of_another_kind_is_rejected() {
    let schemas = Schemas::new();
    for (kind, frame) in smallest() {
        for other in schemas.0.keys() {
            assert_eq!(schemas.0[other].is_valid(&frame), *other == kind, "{frame} as {other}");
        }
    }
}

#[test]
fn unknown_members_are_ignored_at_every_level() {
    let schemas = Schemas::new();
    for (kind, mut frame) in smallest() {
        frame["later"] = json!({"deep": [null, {"kind": 3}]});
        schemas.accept(kind, &frame);
    }
    schemas.accept("sensor_frame", &json!({"kind": "sensor_frame", "channels": {"a": {"data": [1], "later": {}}}}));
}

#[test]
fn each_field_rejects_every_wrong_json_type_and_takes_null_only_where_it_is_optional() {
    let contract = Contract::current().unwrap();
    let schemas = Schemas::new();
    for (kind, frame) in smallest().into_iter().filter(|(kind, _)| *kind != "error") {
        let (_, message, projected) = contract.kinds().find(|(name, ..)| *name == kind).unwrap();
        for field in &message.fields {
            let projection = &projected.fields[&field.name];
            let mut fits = 0;
            for value in [json!(null), json!(true), json!(3), json!(1.5), json!("text"), json!([]), json!({})] {
                let mut frame = frame.clone();
                frame[&field.name] = value.clone();
                let valid = schemas.0[kind].is_valid(&frame);
                if value.is_null() {
                    assert_eq!(valid, projection.ty.nullable, "{kind}.{}", field.name);
                } else if valid {
                    fits += 1;
                }
            }
            // A number field takes both numbers; a pin may take none of the samples, and so may
            // what needs members.
            let most = if projection.ty.shape.to_string() == "number" { 2 } else { 1 };
            assert!(fits <= most, "{kind}.{} takes {fits} JSON types", field.name);
        }
    }
}

#[test]
fn the_pins_hold() {
    let schemas = Schemas::new();
    let observation = |pin: &str, value: Value| json!({"kind": "observation_frame", "session_id": "s", pin: value});
    let opened =
        |pin: &str, value: Value| json!({"kind": "session_opened", "session_id": "s", "provenance": {pin: value}});
    for (pin, pinned) in [("calibrated_posterior", false), ("is_simulation_output", true)] {
        schemas.accept("observation_frame", &observation(pin, json!(pinned)));
        schemas.accept("session_opened", &opened(pin, json!(pinned)));
        for wrong in [json!(!pinned), json!(null), json!(0), json!(1), json!("true"), json!("false")] {
            schemas.reject("observation_frame", &observation(pin, wrong.clone()));
            schemas.reject("session_opened", &opened(pin, wrong));
        }
    }
    schemas.accept("session_opened", &json!({"kind": "session_opened", "session_id": "s", "provenance": null}));
}

#[test]
fn a_session_id_must_be_a_segment() {
    let schemas = Schemas::new();
    let frame = |id: &str| json!({"kind": "close_session", "session_id": id});
    for id in ["uav3", "a.b", "...", "a@b", "-", "Zürich", "神経", "🧠", &"x".repeat(256)] {
        schemas.accept("close_session", &frame(id));
    }
    for id in [
        "",
        "a/b",
        "a*",
        "$",
        "a#",
        "a?",
        "a b",
        "a\t",
        "a\n",
        "\n",
        "a\u{b}",
        "a\r",
        "a\0",
        "\u{7f}",
        "a\u{85}",
        "@a",
        ".",
        "..",
        &"x".repeat(257),
    ] {
        schemas.reject("close_session", &frame(id));
    }
    // Only a required one: elsewhere it is any string.
    schemas.accept("link_status", &json!({"kind": "link_status", "session_id": ""}));
    schemas.accept("error", &json!({"kind": "error", "error": "", "session_id": "a/b"}));
}

#[test]
fn enums_keep_read_or_reject_what_they_do_not_know() {
    let schemas = Schemas::new();
    let with_sim_mode =
        |mode: Value| json!({"kind": "open_session", "session_id": "s", "network": {}, "sim": {"mode": mode}});
    let with_role = |role: Value| json!({"kind": "capabilities", "controller_id": "c", "role": role});
    for mode in ["stream", "batch"] {
        schemas.accept("open_session", &with_sim_mode(json!(mode)));
    }
    for mode in [json!("Stream"), json!(""), json!("replay"), json!(1), json!(null)] {
        schemas.reject("open_session", &with_sim_mode(mode));
    }
    for text in ["plant", "PLANT", "", "observer"] {
        schemas.accept("capabilities", &with_role(json!(text)));
        schemas.accept("command_frame", &json!({"kind": "command_frame", "mode": text}));
    }
    schemas.reject("capabilities", &with_role(json!(2)));
    schemas.reject("command_frame", &json!({"kind": "command_frame", "mode": 2}));
}

#[test]
fn integers_stay_within_what_a_double_holds_and_other_numbers_do_not_count_as_integers() {
    let schemas = Schemas::new();
    let frame = |seq: Value| json!({"kind": "sensor_frame", "seq": seq});
    for seq in [json!(9_007_199_254_740_991_i64), json!(-9_007_199_254_740_991_i64), json!(0)] {
        schemas.accept("sensor_frame", &frame(seq));
    }
    for seq in [
        json!(9_007_199_254_740_992_i64),
        json!(-9_007_199_254_740_992_i64),
        json!(u64::MAX),
        json!(1e300),
        json!(0.5),
        json!("1"),
    ] {
        schemas.reject("sensor_frame", &frame(seq));
    }
    let sizes =
        |size: Value| json!({"kind": "open_session", "session_id": "s", "network": {"population_sizes": {"p": size}}});
    schemas.accept("open_session", &sizes(json!(1)));
    schemas.reject("open_session", &sizes(json!(9_007_199_254_740_992_i64)));
}

#[test]
fn maps_and_arrays_are_bounded_but_numeric_arrays_are_not() {
    let schemas = Schemas::new();
    let map = |entries: usize| -> Value {
        (0..entries).map(|index| (index.to_string(), json!({}))).collect::<serde_json::Map<_, _>>().into()
    };
    let frame = |channels, steps: usize| {
        json!({"kind": "command_frame", "channels": channels,
        "horizon": vec![json!({}); steps]})
    };
    schemas.accept("command_frame", &frame(map(4096), 4096));
    schemas.reject("command_frame", &frame(map(4097), 0));
    schemas.reject("command_frame", &frame(map(0), 4097));
    schemas.reject("command_frame", &json!({"kind": "command_frame", "horizon": [map(4097)]}));
    let numbers = json!({"kind": "observation_frame", "session_id": "s", "records": {"p": {"times": vec![0.5; 5000],
        "senders": vec![7; 5000]}}});
    schemas.accept("observation_frame", &numbers);
    let recordables = |count: usize| {
        json!({"kind": "open_session", "session_id": "s", "network": {},
        "record": {"targets": [{"recordables": vec!["w"; count]}]}})
    };
    schemas.accept("open_session", &recordables(4096));
    schemas.reject("open_session", &recordables(4097));
}

#[test]
fn each_limit_of_the_projection_bounds_what_it_is_named_for() {
    let projection = PROJECTION_TEXT
        .replacen("\"integer\": 9007199254740991", "\"integer\": 3", 1)
        .replacen("\"entries\": 4096", "\"entries\": 1", 1)
        .replacen("\"items\": 4096", "\"items\": 2", 1)
        .replacen("\"segment_bytes\": 256", "\"segment_bytes\": 4", 1);
    let schemas = Schemas::of(generate_from(&Contract::new(DESCRIPTOR_SET, &projection).unwrap()));
    let command = |channels: Value, steps: usize, seq: i64| {
        json!({"kind": "command_frame", "seq": seq,
        "channels": channels, "horizon": vec![json!({}); steps]})
    };
    schemas.accept("command_frame", &command(json!({"a": {}}), 2, -3));
    schemas.reject("command_frame", &command(json!({"a": {}, "b": {}}), 2, -3));
    schemas.reject("command_frame", &command(json!({"a": {}}), 3, -3));
    schemas.reject("command_frame", &command(json!({"a": {}}), 2, -4));
    schemas.reject("command_frame", &command(json!({"a": {}}), 2, 4));
    schemas.accept("close_session", &json!({"kind": "close_session", "session_id": "uav3"}));
    schemas.reject("close_session", &json!({"kind": "close_session", "session_id": "uav33"}));
}

#[test]
fn a_stimulus_frame_inside_a_request_may_leave_out_what_the_request_says() {
    let schemas = Schemas::new();
    let step = |stimulus: Value| json!({"kind": "step_request", "session_id": "s", "stimulus": stimulus});
    for stimulus in [
        json!(null),
        json!({}),
        json!({"kind": "stimulus_frame", "session_id": "s", "ncp_version": WIRE_VERSION,
            "values": {"p": {"data": [1.0]}}}),
    ] {
        schemas.accept("step_request", &step(stimulus));
    }
    for stimulus in [
        json!({"kind": "sensor_frame"}),
        json!({"session_id": "a/b"}),
        json!({"ncp_version": 5}),
        json!({"values": [1]}),
        json!([]),
    ] {
        schemas.reject("step_request", &step(stimulus));
    }
    schemas.reject("stimulus_frame", &json!({"kind": "stimulus_frame"}));
}

#[test]
fn a_horizon_is_an_array_of_channel_maps_without_a_wrapper() {
    let schemas = Schemas::new();
    schemas.accept("command_frame", &json!({"kind": "command_frame", "horizon": [{"v": {"data": [1, 2.5]}}, {}]}));
    // A wrapped step would be a map with a channel named `channels`, whose value is no
    // ChannelValue.
    schemas
        .reject("command_frame", &json!({"kind": "command_frame", "horizon": [{"channels": {"data": {"data": [1]}}}]}));
}

#[test]
fn the_block_of_a_bulk_observation_is_padded_base64() {
    let schemas = Schemas::new();
    let frame = |block: &str| json!({"kind": "bulk_observation", "block": block});
    for block in ["", "TkNQQg==", "TkNQ", "+/8="] {
        schemas.accept("bulk_observation", &frame(block));
    }
    for block in ["TkNQQg", "TkNQQg=", "-_8=", "TkNQ\n", "TkNQ====", "=", "T kN"] {
        schemas.reject("bulk_observation", &frame(block));
    }
}

#[test]
fn every_gap_is_in_the_readme_of_the_schemas() {
    let readme = fs::read_to_string(Path::new(SCHEMAS).join("README.md")).unwrap();
    for each in GAPS {
        let requirements: Vec<_> = each
            .requirements
            .iter()
            .map(|id| if id.ends_with('-') { format!("{id}*") } else { (*id).to_owned() })
            .collect();
        let row = format!("| {} | {} | {} |", each.name, requirements.join(", "), each.reason);
        assert!(readme.contains(&row), "{row}");
    }
    let rows = readme
        .lines()
        .skip_while(|line| !line.starts_with("| gap |"))
        .skip(2)
        .take_while(|line| line.starts_with('|'))
        .count();
    assert_eq!(rows, GAPS.len());
}

#[test]
fn a_gap_is_found_by_the_requirement_and_there_is_none_for_what_a_schema_says() {
    assert_eq!(gap("NCP-WIRE-007").map(|gap| gap.name), Some("duplicate-members"));
    assert_eq!(gap("NCP-BULK-012").map(|gap| gap.name), Some("block"));
    for said in [
        "NCP-WIRE-020",
        "NCP-WIRE-021",
        "NCP-WIRE-027",
        "NCP-WIRE-011",
        "NCP-WIRE-031",
        "NCP-PROV-001",
        "NCP-WIRE-0071",
        "NCP-WIRE-",
    ] {
        assert_eq!(gap(said), None, "{said}");
    }
}

#[test]
fn a_vector_file_is_accepted_with_every_relation_and_template() {
    let validator = vector_file_validator();
    let texts = [
        json!("{}"),
        json!({"$repeat": "[", "times": 65}),
        json!({"$count": ["\"k", "\":1,"], "times": 5000}),
        json!({"$concat": ["{\"a\":\"", {"$repeat": "x", "times": 10}, "\"}"]}),
        json!({"$base64": {"$concat": ["a", {"$repeat": "b", "times": 0}]}}),
    ];
    let mut cases: Vec<Value> = texts
        .iter()
        .map(|text| case("decode", json!({"kind": "error", "text": text}), json!({"reject": "malformed"})))
        .collect();
    let column = json!([{"name": "a", "dtype": "f64", "data": [1, "NaN", "-0"]}, {"name": "b", "dtype": "i64",
        "data": ["-1", "0"]}, {"name": "c", "dtype": "i32", "data": [3]}]);
    cases.extend([
        case("decode", json!({"kind": "command_frame", "base64": "e30="}), json!({"accept": true})),
        case(
            "decode",
            json!({"kind": "command_frame", "text": "{}"}),
            json!({"relation": "message", "text": "{}", "ignore": ["/stimulus/session_id"]}),
        ),
        case(
            "encode",
            json!({"kind": "command_frame", "fields": {"t": "NaN", "channels": {"a": {"data": ["-0"]}}}}),
            json!({"relation": "encoding", "text": "{}"}),
        ),
        case("bulk.encode", json!({"columns": column}), json!({"relation": "bytes", "base64": "e30="})),
        case(
            "observation.pack",
            json!({"times": [1.5], "values": ["Infinity"], "senders": ["7"]}),
            json!({"relation": "columns", "columns": column}),
        ),
        case("bulk.decode", json!({"block": "e30="}), json!({"relation": "json", "value": {"columns": []}})),
        case(
            "key.build",
            json!({"key": "sensor", "realm": null, "session": "s", "name": null}),
            json!({"relation": "json", "value": {"key": "k"}}),
        ),
        case("key.build", json!({"key": "rpc", "realm": "a/b"}), json!({"accept": true})),
        case("negotiate", json!({"version": WIRE_VERSION, "contract_hash": null}), json!({"reject": "version"})),
    ]);
    let file = json!({"format": 1, "area": "wire", "name": "frames", "about": "Frames.",
        "notes": {"lenient-integers": "A bug.", "L01": "A finding."}, "cases": cases});
    let errors: Vec<_> =
        validator.iter_errors(&file).map(|error| format!("{}: {error}", error.instance_path())).collect();
    assert_eq!(errors, Vec::<String>::new());
}

#[test]
fn a_trace_and_its_pattern_are_checked_to_their_leaves() {
    let validator = vector_file_validator();
    let hold = json!({"op": "should_hold", "now_s": "NaN"});
    let run = |steps: Value, pattern: Value| {
        case(
            "watchdog.run",
            json!({"steps": steps}),
            json!({"relation": "pattern", "value": pattern, "tolerance": 1e-9, "or_reject": true}),
        )
    };
    let pattern = json!({"steps": [
        {"hold": true, "note": null}, {}, {"$error": true}, {"$any": [1, {"$exact": {"a": []}}]},
        {"$json": {"a": {"$range": [0, "Infinity"]}}}, {"$anything": true},
        {"data": [{"$double": 0.5}, {"$double": "-0"}]},
        {"$beginning": [{"a": 1}, {"$item": {"a": [{"$item": 0, "times": 9}]}, "times": 300}]},
        {"$item": {"hold": true}, "times": 1}, {"$items": [{"hold": true}, {}], "times": 9},
    ]});
    let limits = || json!({"max_speed_mps": "-Infinity"});
    for case in [
        run(json!([hold, {"op": "reset"}]), pattern),
        run(json!([{"$items": [hold, {"op": "reset"}], "times": 9, "plus": [{}, {"now_s": 0.5}]}]), json!(1)),
        case(
            "governor.run",
            json!({"limits": limits(), "capabilities": null, "steps": [
                {"op": "govern", "command": {"horizon": [{}, {"$item": {}, "times": 9}]}, "now_s": 1, "sensor": null,
                    "last_sensor_s": null},
                {"op": "note_link", "burst": true},
            ]}),
            json!({"accept": true}),
        ),
        case(
            "buffer.run",
            json!({"steps": [{"op": "command", "text": {"$repeat": "[", "times": 9}, "now_s": 0}, {"op": "active",
                "now_s": 0}]}),
            json!({"accept": true}),
        ),
        case("codec.encode", json!({"codec": "uav", "sensor": null}), json!({"accept": true})),
        case(
            "loop.run",
            json!({"period_ms": 50, "limits": limits(), "config": {"kp": 1}, "steps": [{"op": "tick", "now_s": 0}]}),
            json!({"accept": true}),
        ),
        case("session.run", json!({"requests": ["{}"]}), json!({"accept": true})),
    ] {
        let errors: Vec<_> = validator
            .iter_errors(&with_note(&case))
            .map(|error| format!("{}: {error}", error.instance_path()))
            .collect();
        assert_eq!(errors, Vec::<String>::new());
    }
    for wrong in [
        run(json!([{"op": "should_hold"}]), json!(1)),
        run(json!([{"op": "should_hold", "now": 0}]), json!(1)),
        run(json!([{"op": "sing", "now_s": 0}]), json!(1)),
        run(json!([hold]), json!({"$eror": true})),
        run(json!([hold]), json!({"a": [{"$error": false}]})),
        run(json!([hold]), json!({"$error": true, "a": 1})),
        run(json!([hold]), json!({"$any": []})),
        run(json!([hold]), json!({"$beginning": []})),
        run(json!([hold]), json!({"$exact": {"$any": [1]}})),
        run(json!([hold]), json!({"$range": [0]})),
        run(json!([hold]), json!({"$double": true})),
        run(json!([hold]), json!({"$repeat": "x", "times": 3})),
        run(json!([hold]), json!({"$item": 1, "times": 3})),
        run(json!([hold]), json!({"$any": [{"$item": 1, "times": 3}]})),
        run(json!([hold]), json!([{"$item": 1, "times": 0}])),
        run(json!([hold]), json!([{"$items": 1, "times": 2}])),
        run(json!([hold]), json!([{"$items": [], "times": 2}])),
        run(json!([{"$items": [hold], "times": 2, "plus": {"now_s": 1}}]), json!(1)),
        run(json!([{"$items": [hold], "times": 2, "plus": [{}]}]), json!(1)),
        case("horizon.max_len", json!({"ttl_ms": 1}), json!({"accept": true})),
        case("codec.encode", json!({"codec": "usv", "sensor": null}), json!({"accept": true})),
        case("link.run", json!({"steps": []}), json!({"accept": true})),
        case("session.run", json!({"requests": [1]}), json!({"accept": true})),
        case("session.run", json!({"requests": ["{}"]}), json!({"relation": "json", "value": 1, "tolerance": 1})),
    ] {
        assert!(!validator.is_valid(&with_note(&wrong)), "{wrong}");
    }
}

#[test]
fn a_vector_file_with_a_mistake_is_rejected() {
    let validator = vector_file_validator();
    let decode = || json!({"kind": "error", "text": "{}"});
    let accept = || json!({"accept": true});
    let wrong = [
        case("decode", json!({"kind": "error"}), accept()),
        case("decode", json!({"kind": "error", "text": "{}", "base64": ""}), accept()),
        case("decode", json!({"kind": "nonsense", "text": "{}"}), accept()),
        case("decode", json!({"kind": "error", "text": {"$repeat": "x"}}), accept()),
        case("decode", json!({"kind": "error", "text": {"$count": ["x"], "times": 3}}), accept()),
        case("decode", json!({"kind": "error", "text": {"$reapet": "x", "times": 3}}), accept()),
        case("decode", decode(), json!({"accept": false})),
        case("decode", decode(), json!({"reject": "internal"})),
        case("decode", decode(), json!({"reject": "type", "accept": true})),
        case("decode", decode(), json!({"relation": "bytes", "base64": ""})),
        case("decode", decode(), json!({"relation": "message", "value": {}})),
        case("decode", decode(), json!({"relation": "message", "text": "{}", "ignore": ["stimulus"]})),
        case("encode", json!({"kind": "error", "fields": {"kind": "error"}}), accept()),
        case("encode", json!({"kind": "error", "fields": {"error": {"$concta": ["a"]}}}), accept()),
        case("bulk.encode", json!({"columns": [{"name": "a", "dtype": "i64", "data": [1]}]}), accept()),
        case("bulk.encode", json!({"columns": []}), json!({"relation": "encoding", "text": ""})),
        case("key.build", json!({"key": "rpc", "realm": null, "session": "s"}), accept()),
        case("key.build", json!({"key": "sensor", "realm": null}), accept()),
        case("key.build", json!({"key": "observation", "realm": null, "session": "s", "name": "n"}), accept()),
        case("governor.run", json!({}), accept()),
    ];
    for case in &wrong {
        assert!(!validator.is_valid(&file_of(case)), "{case}");
    }
    let good = case("decode", decode(), accept());
    assert!(validator.is_valid(&file_of(&good)));
    for (pointer, value) in [
        ("/cases/0/id", json!("wire/Frames/x")),
        ("/cases/0/id", json!("frames")),
        ("/cases/0/roles", json!([])),
        ("/cases/0/roles", json!(["pilot"])),
        ("/cases/0/requirements", json!(["WIRE-1"])),
        ("/cases/0/flags", json!(["Lenient"])),
        ("/cases/0/why", json!("")),
        ("/cases/0/title", json!(" padded")),
        ("/cases", json!([])),
        ("/format", json!(2)),
        ("/notes", json!({"flag": 1})),
    ] {
        let mut broken = file_of(&good);
        *broken.pointer_mut(pointer).unwrap() = value;
        assert!(!validator.is_valid(&broken), "{pointer}");
    }
}

proptest! {
    /// [NCP-WIRE-031] [NCP-KEY-020]
    #[test]
    fn a_session_id_satisfies_the_schema_exactly_if_it_is_a_segment_but_for_its_bytes(
        id in "[ -~\u{7f}-\u{a1}é神@.*/]{0,6}",
    ) {
        let schema: Value = serde_json::from_str(&generate().into_iter().find(|(name,
            _)| name == "close_session.schema.json").unwrap().1).unwrap();
        let frame = json!({"kind": "close_session", "session_id": id});
        prop_assert_eq!(jsonschema::draft202012::is_valid(&schema, &frame),
            ncp_spec::keys::validate_segment(&id).is_ok());
    }
}

/// The validators of all kinds, from the generated texts.
struct Schemas(BTreeMap<String, Validator>);

impl Schemas {
    fn new() -> Self {
        Self::of(generate())
    }

    fn of(files: Vec<(String, String)>) -> Self {
        let validator = |text: &str| jsonschema::draft202012::new(&serde_json::from_str(text).unwrap()).unwrap();
        Self(files.into_iter().map(|(name, text)| (name.replace(".schema.json", ""), validator(&text))).collect())
    }

    #[track_caller]
    fn accept(&self, kind: &str, frame: &Value) {
        if let Err(error) = self.0[kind].validate(frame) {
            panic!("{kind}, at {}: {error}", error.instance_path());
        }
    }

    #[track_caller]
    fn reject(&self, kind: &str, frame: &Value) {
        assert!(
            !self.0[kind].is_valid(frame),
            "{kind} accepts {}",
            frame.to_string().chars().take(300).collect::<String>()
        );
    }
}

/// A frame a kind, with the required members and nothing else.
fn smallest() -> Vec<(&'static str, Value)> {
    vec![
        ("open_session", json!({"kind": "open_session", "session_id": "s", "network": {}})),
        ("session_opened", json!({"kind": "session_opened", "session_id": "s"})),
        ("stimulus_frame", json!({"kind": "stimulus_frame", "session_id": "s"})),
        ("step_request", json!({"kind": "step_request", "session_id": "s"})),
        ("run_request", json!({"kind": "run_request", "session_id": "s", "duration_ms": 5})),
        ("observation_frame", json!({"kind": "observation_frame", "session_id": "s"})),
        ("bulk_observation", json!({"kind": "bulk_observation"})),
        ("close_session", json!({"kind": "close_session", "session_id": "s"})),
        ("session_closed", json!({"kind": "session_closed", "session_id": "s"})),
        ("capabilities", json!({"kind": "capabilities", "controller_id": "c"})),
        ("sensor_frame", json!({"kind": "sensor_frame"})),
        ("command_frame", json!({"kind": "command_frame"})),
        ("control_status", json!({"kind": "control_status"})),
        ("link_status", json!({"kind": "link_status"})),
        ("error", json!({"kind": "error", "error": "no"})),
    ]
}

fn vector_file_validator() -> Validator {
    let text = fs::read_to_string(Path::new(SCHEMAS).join("vector-file.schema.json")).unwrap();
    jsonschema::draft202012::new(&serde_json::from_str(&text).unwrap()).unwrap()
}

#[expect(clippy::needless_pass_by_value, reason = "literals read better")]
fn case(call: &str, args: Value, expect: Value) -> Value {
    json!({
        "id": "wire/frames/x", "title": "It is so.", "requirements": ["NCP-WIRE-001"], "flags": ["lenient-integers"],
            "roles": ["body"],
        "call": call, "args": args, "expect": expect, "why": "It says so.",
    })
}

/// A file whose only possible mistake is its case.
fn with_note(case: &Value) -> Value {
    let mut file = file_of(case);
    file["notes"] = json!({"lenient-integers": "A bug."});
    file
}

fn file_of(case: &Value) -> Value {
    json!({"format": 1, "area": "wire", "name": "frames", "about": "Frames.", "notes": {}, "cases": [case]})
}

fn references(schema: &Value) -> Vec<&str> {
    match schema {
        Value::Object(members) => {
            let here = members.get("$ref").and_then(Value::as_str);
            here.into_iter().chain(members.values().flat_map(references)).collect()
        }
        Value::Array(items) => items.iter().flat_map(references).collect(),
        _ => Vec::new(),
    }
}
