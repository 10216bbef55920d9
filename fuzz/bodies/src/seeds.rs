//! The first inputs of every target, made of the golden vectors.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use ncp_spec::bulk::{Column, ColumnData};
use ncp_spec::wire::{CommandFrame, Frame, Kind, build, decode};
use serde_json::Value;

use crate::action_buffer::{self, Arrival, Damage};
use crate::governor::{self, Channel, Command, Govern, KindName, ModeName, Name, Spec, Unit};
use crate::plain::write;
use crate::session;
use crate::{bulk, codec, edges, frame, link_monitor, proto};

/// The longest seed of a vector in bytes: a corpus is to be quick.
const MOST_BYTES: usize = 4_096;

/// Lines of peers: every form of an answer, and every way to miss it.
const ANSWERS: [&str; 10] = [
    r#"{"id":1,"unsupported":true}"#,
    r#"{"id":2,"error":{"code":"type","message":"seq: 1.0 is no integer"}}"#,
    r#"{"id":3,"error":{"code":"internal"}}"#,
    r#"{"id":4,"result":{"text":"\u00e9\ud83d\ude00","a":[1,-0.5e3,true,null]}}"#,
    r#"{"result":{},"id":18446744073709551615,"note":[]}"#,
    r#"{"id":5,"result":{},"unsupported":true}"#,
    r#"{"id":6,"unsupported":false}"#,
    r#"{"id":7,"error":{"message":"no code"}}"#,
    r#"{"id":8}"#,
    r#"{"id":"9","result":{}}"#,
];

/// By target, its seeds.
pub type Seeds = BTreeMap<&'static str, BTreeSet<Vec<u8>>>;

/// Those seeds that a corpus keeps whatever they reach: for every call and rule the first case that is
/// accepted and the first that is rejected. What an input *means* is no edge in a program's flow.
///
/// # Errors
/// A folder or a file that cannot be read.
pub fn essential(root: &Path) -> io::Result<Seeds> {
    let mut seen = BTreeSet::new();
    let mut cases = cases(root)?;
    cases.retain(|case| {
        let rejected = case["expect"].get("reject").is_some();
        let (call, rule) = (text(&case["call"]), text(&case["requirements"][0]));
        seen.insert((call, rule, rejected))
    });
    let mut seeds = of_cases(&cases);
    let answers = ANSWERS.map(|line| line.as_bytes().to_vec());
    seeds.entry("peer_protocol").or_default().extend(answers);
    at_edges(&mut seeds);
    Ok(seeds)
}

/// The seeds that the vectors in `root` give.
///
/// # Errors
/// A folder or a file that cannot be read.
pub fn seeds(root: &Path) -> io::Result<Seeds> {
    let mut seeds = of_cases(&cases(root)?);
    let mut add = |target: &'static str, seed: Vec<u8>| {
        if seed.len() <= MOST_BYTES {
            seeds.entry(target).or_default().insert(seed);
        }
    };
    for line in ANSWERS {
        add("peer_protocol", line.as_bytes().to_vec());
    }
    let whole = fs::read_to_string(root.join("proto/ncp.proto"))?;
    for part in whole.split("\n\n") {
        add("canonical_proto", part.as_bytes().to_vec());
    }
    for text in ["a = \"http://x /* y */\"; // z", "a = \"\\\"//\"; '\\''", "syntaxes\noptional x\n/*/ b */ c"] {
        add("canonical_proto", text.as_bytes().to_vec());
    }
    add("session", session::seed());
    at_edges(&mut seeds);
    Ok(seeds)
}

/// The frames at the edges of what may be, the long ones too, for those targets that look at frames
/// alone.
fn at_edges(seeds: &mut Seeds) {
    for (kind, text) in edges::frames() {
        for target in ["frame_decode", "frame_roundtrip"] {
            let seed = frame::join(kind, text.as_bytes());
            seeds.entry(target).or_default().insert(seed);
        }
    }
}

fn of_cases(cases: &[Value]) -> Seeds {
    let mut seeds = Seeds::new();
    let mut add = |target: &'static str, seed: Vec<u8>| {
        if seed.len() <= MOST_BYTES {
            seeds.entry(target).or_default().insert(seed);
        }
    };
    for case in cases {
        let args = &case["args"];
        match case["call"].as_str().unwrap_or_default() {
            "decode" => of_frame(args, &mut add),
            // What is encoded there is decoded here.
            "encode" => {
                let kind = args["kind"].as_str().and_then(Kind::parse);
                let fields = args["fields"].to_string();
                let message = kind.and_then(|kind| build(kind, fields.as_bytes()).ok());
                if let Some(Ok(frame)) = message.map(|message| message.encode()) {
                    of_frame(&serde_json::json!({"kind": args["kind"], "text": frame}), &mut add);
                }
            }
            "reply.check" => {
                for name in ["request", "reply"] {
                    add("peer_protocol", text(&args[name]).into_bytes());
                    add("session", text(&args[name]).into_bytes());
                }
            }
            "bulk.decode" | "observation.unpack" => {
                let block = STANDARD.decode(text(&args["block"])).unwrap_or_default();
                add("bulk_decode", block.clone());
                add("bulk_memory", block);
            }
            "bulk.encode" => add("bulk_roundtrip", write(&bulk::Columns(columns(&args["columns"])))),
            "key.match" => {
                add("keys", [text(&args["pattern"]), text(&args["key"])].join("\n").into_bytes());
            }
            "key.build" => {
                let names = ["session", "name", "realm"].map(|name| text(&args[name]));
                let mut names = names.into_iter().filter(|name| !name.is_empty());
                if let Some(name) = names.next() {
                    add("keys", [name, names.next().unwrap_or_default()].join("\n").into_bytes());
                }
            }
            "version.check" | "negotiate" => add("version", text(&args["version"]).into_bytes()),
            "contract.verify" => add("version", text(&args["peer_hash"]).into_bytes()),
            "governor.run" => add("governor_trace", write(&governor_trace(args))),
            "buffer.run" => add("action_buffer_trace", write(&buffer_trace(args))),
            "watchdog.run" => add("action_buffer_trace", write(&watchdog_trace(args))),
            "link.run" => add("link_monitor_trace", write(&link_trace(args))),
            "codec.encode" | "codec.decode" => add("codec", write(&codec_run(args))),
            "session.run" => {
                let requests: Vec<_> = list(&args["requests"]).iter().map(text).collect();
                add("session", requests.join("\n").into_bytes());
            }
            _ => {}
        }
        // The case itself, as a peer might answer it.
        if case["requirements"][0] == "NCP-VER-001" || case["call"] == "plane.qos" {
            let answer = serde_json::json!({"id": 7, "result": args});
            add("peer_protocol", answer.to_string().into_bytes());
        }
    }
    seeds
}

/// The words of frames, as libFuzzer's dictionaries want them.
#[must_use]
pub fn dictionary() -> String {
    let mut words: BTreeSet<String> = BTreeSet::new();
    let tables = Kind::ALL.into_iter().map(Kind::table).chain(ncp_spec::wire::NESTED);
    for table in tables {
        words.extend(table.fields.iter().map(|field| format!("\\\"{}\\\":", field.name)));
    }
    words.extend(Kind::ALL.map(|kind| format!("\\\"kind\\\":\\\"{kind}\\\"")));
    let others = [
        "null",
        "true",
        "false",
        "-0",
        "-0.0",
        "1e309",
        "5e-324",
        "9007199254740991",
        "9007199254740992",
        "\\\"mode\\\":\\\"estop\\\"",
        "\\\"mode\\\":\\\"active\\\"",
        "\\\\ud800",
        "\\\\u0000",
        "{}",
        "[]",
        ",",
        "\\\"\\\"",
        "\\\"V_m\\\"",
        "\\\"spikes\\\"",
        "\\\"stream\\\"",
        "\\\"pose_position\\\"",
        "\\\"velocity_setpoint\\\"",
        "\\\"m/s\\\"",
        "\\\"id\\\":7,",
        ",\\\"result\\\":{}",
        "\\\"error\\\":{\\\"code\\\":\\\"type\\\"}",
        ",\\\"unsupported\\\":true",
        "ncp.reference.lif",
        "ncp.reference.rate",
        "current_pA",
        "builtin",
    ];
    words.extend(others.map(str::to_owned));
    let lines: Vec<_> = words.iter().map(|word| format!("\"{word}\"\n")).collect();
    format!(
        "# The words of frames and of peers' answers, from the tables of the text: made by `ncp-fuzz seed`.\n{}",
        lines.concat()
    )
}

fn cases(root: &Path) -> io::Result<Vec<Value>> {
    let mut cases = Vec::new();
    for area in sorted(&root.join("vectors/corpus"))? {
        if !area.is_dir() {
            continue;
        }
        for file in sorted(&area)? {
            if file.extension().is_some_and(|extension| extension == "json") {
                let text = fs::read(&file)?;
                let value: Value = serde_json::from_slice(&text).map_err(io::Error::other)?;
                cases.extend(list(&value["cases"]).iter().cloned());
            }
        }
    }
    Ok(cases)
}

fn sorted(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut paths = Vec::new();
    for entry in fs::read_dir(folder)? {
        paths.push(entry?.path());
    }
    paths.sort();
    Ok(paths)
}

fn of_frame(args: &Value, add: &mut impl FnMut(&'static str, Vec<u8>)) {
    let Some(kind) = args["kind"].as_str().and_then(Kind::parse) else {
        return;
    };
    let bytes = match args.get("text") {
        Some(given) => text(given).into_bytes(),
        None => STANDARD.decode(text(&args["base64"])).unwrap_or_default(),
    };
    let input = frame::join(kind, &bytes);
    for target in ["frame_decode", "frame_roundtrip", "validate_vs_schema", "proto_vs_json"] {
        add(target, input.clone());
    }
    if let Ok(message) = decode(kind, &bytes)
        && let Ok(binary) = ncp_proto::convert::to_binary(&message)
    {
        add("proto_vs_json", proto::join(kind, &binary));
    }
}

/// A text or a template; empty if it is long.
fn text(value: &Value) -> String {
    if let Some(text) = value.as_str() {
        return text.to_owned();
    }
    let times = value["times"].as_u64().and_then(|times| usize::try_from(times).ok()).unwrap_or(0);
    if let Some(part) = value["$repeat"].as_str() {
        let fits = part.len().checked_mul(times).is_some_and(|len| len <= MOST_BYTES);
        return if fits { part.repeat(times) } else { "-".repeat(MOST_BYTES + 1) };
    }
    if let Some([before, after]) = value["$count"].as_array().map(Vec::as_slice) {
        let [before, after] = [before, after].map(|text| text.as_str().unwrap_or_default());
        let fits = (before.len() + after.len() + 20).checked_mul(times).is_some_and(|len| len <= MOST_BYTES);
        let counted = || (0..times).map(|nth| format!("{before}{nth}{after}")).collect();
        return if fits { counted() } else { "-".repeat(MOST_BYTES + 1) };
    }
    if let Some(parts) = value["$concat"].as_array() {
        return parts.iter().map(text).collect();
    }
    if value.get("$base64").is_some() {
        return STANDARD.encode(text(&value["$base64"]));
    }
    String::new()
}

fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

/// A double, by a number or by its name.
fn double(value: &Value) -> Option<f64> {
    match value.as_str() {
        Some("NaN") => Some(f64::NAN),
        Some("Infinity") => Some(f64::INFINITY),
        Some("-Infinity") => Some(f64::NEG_INFINITY),
        Some("-0") => Some(-0.0),
        _ => value.as_f64(),
    }
}

fn integer(value: &Value) -> i64 {
    value.as_i64().or_else(|| value.as_str()?.parse().ok()).unwrap_or_default()
}

fn columns(value: &Value) -> Vec<Column> {
    let of = |column: &Value| {
        let data = list(&column["data"]);
        let doubles = || data.iter().filter_map(double);
        let integers = || data.iter().map(integer);
        #[expect(clippy::cast_possible_truncation)]
        let data = match column["dtype"].as_str() {
            Some("f32") => ColumnData::F32(doubles().map(|value| value as f32).collect()),
            Some("f64") => ColumnData::F64(doubles().collect()),
            Some("i32") => ColumnData::I32(integers().map(|value| value as i32).collect()),
            _ => ColumnData::I64(integers().collect()),
        };
        Column::new(text(&column["name"]), data)
    };
    list(value).iter().map(of).collect()
}

fn governor_trace(args: &Value) -> governor::Trace {
    let limits = &args["limits"];
    let specs = |name: &str| {
        let specs = list(&args["capabilities"][name]).iter();
        specs
            .map(|spec| Spec {
                name: Name::of(spec["name"].as_str().unwrap_or_default()),
                kind: KindName::of(spec["kind"].as_str().unwrap_or("scalar")),
                unit: spec["unit"].as_str().map(Unit::of),
                size: spec["size"].as_i64(),
            })
            .collect::<Vec<_>>()
    };
    let negotiated = args["capabilities"].is_object();
    governor::Trace {
        max_speed_mps: double(&limits["max_speed_mps"]),
        geofence_radius_m: double(&limits["geofence_radius_m"]),
        command_timeout_ms: double(&limits["command_timeout_ms"]).unwrap_or(500.0),
        negotiated: negotiated.then(|| (specs("sensor_channels"), specs("command_channels"))),
        steps: list(&args["steps"])
            .iter()
            .map(|step| match step["op"].as_str() {
                Some("note_link") => governor::Step::NoteLink(step["burst"] == true),
                Some("reset") => governor::Step::Reset(()),
                _ => governor::Step::Govern(Govern {
                    command: command(&step["command"]),
                    now_s: double(&step["now_s"]).unwrap_or(0.0),
                    sensor: step["sensor"].is_object().then(|| channels(&step["sensor"]["channels"])),
                    last_sensor_s: double(&step["last_sensor_s"]),
                }),
            })
            .collect(),
    }
}

fn command(fields: &Value) -> Command {
    Command {
        mode: ModeName::of(fields["mode"].as_str().unwrap_or("active")),
        seq: integer(&fields["seq"]),
        ttl_ms: double(&fields["ttl_ms"]).unwrap_or(200.0),
        channels: channels(&fields["channels"]),
        horizon: list(&fields["horizon"]).iter().map(channels).collect(),
        horizon_dt_ms: double(&fields["horizon_dt_ms"]),
    }
}

fn channels(map: &Value) -> Vec<Channel> {
    let members = map.as_object().into_iter().flatten();
    members
        .map(|(name, channel)| Channel {
            name: Name::of(name),
            data: list(&channel["data"]).iter().filter_map(double).collect(),
            unit: channel["unit"].as_str().map(Unit::of),
        })
        .collect()
}

fn buffer_trace(args: &Value) -> action_buffer::Trace {
    let steps = list(&args["steps"]).iter().map(|step| {
        let now_s = double(&step["now_s"]).unwrap_or(0.0);
        match step["op"].as_str() {
            Some("reset") => action_buffer::Step::Reset(()),
            Some("active") => action_buffer::Step::Active(now_s),
            _ => {
                let text = text(&step["text"]);
                let read = CommandFrame::decode(text.as_bytes()).ok();
                let damage = read.is_none().then_some(Damage("mode twice"));
                let command = read.unwrap_or_default();
                let mode = if damage.is_some() && text.contains("estop") { "estop" } else { command.mode.as_str() };
                action_buffer::Step::Command(Arrival {
                    now_s,
                    mode: ModeName::of(mode),
                    seq: command.seq,
                    ttl_ms: command.ttl_ms,
                    steps: u8::try_from(command.horizon.len()).unwrap_or(u8::MAX),
                    dt_ms: command.horizon_dt_ms,
                    damage: damage.or(Some(Damage("nothing"))),
                })
            }
        }
    });
    action_buffer::Trace { steps: steps.collect() }
}

fn watchdog_trace(args: &Value) -> action_buffer::Trace {
    let steps = list(&args["steps"]).iter().map(|step| {
        let now_s = double(&step["now_s"]).unwrap_or(0.0);
        match step["op"].as_str() {
            Some("reset") => action_buffer::Step::Reset(()),
            Some("should_hold") => action_buffer::Step::Active(now_s),
            _ => action_buffer::Step::Command(Arrival {
                now_s,
                mode: ModeName("active"),
                seq: integer(&step["seq"]),
                ttl_ms: double(&step["ttl_ms"]).unwrap_or(200.0),
                steps: 0,
                dt_ms: None,
                damage: None,
            }),
        }
    });
    action_buffer::Trace { steps: steps.collect() }
}

fn link_trace(args: &Value) -> link_monitor::Trace {
    let arrivals = list(&args["steps"]).iter().take(48);
    link_monitor::Trace {
        ref_loss: double(&args["ref_loss"]).unwrap_or(0.05),
        threshold: double(&args["threshold"]).unwrap_or(5.0),
        arrivals: arrivals.map(|step| link_monitor::Arrival::Seq(integer(&step["seq"]))).collect(),
    }
}

fn codec_run(args: &Value) -> codec::Run {
    let range = |value: &Value, low, high| {
        let at = |nth: usize, default| double(&value[nth]).unwrap_or(default);
        (at(0, low), at(1, high))
    };
    let ties = ["encoders", "decoders"].into_iter().flat_map(|side| list(&args["codec"][side]));
    let ties = ties.map(|tie| codec::Tie {
        channel: codec::Name::of(tie["channel"].as_str().unwrap_or_default()),
        component: u8::try_from(integer(&tie["component"])).unwrap_or(u8::MAX),
        population: codec::Name::of(tie["population"].as_str().unwrap_or_default()),
        value_range: range(&tie["value_range"], -1.0, 1.0),
        rate_range: range(&tie["rate_range"], 0.0, 200.0),
    });
    let members = |value: &Value| {
        let members = value.as_object().into_iter().flatten();
        members.map(|(name, value)| (codec::Name::of(name), value.clone())).collect::<Vec<_>>()
    };
    let sensor = members(&args["sensor"]["channels"])
        .into_iter()
        .map(|(name, channel)| (name, list(&channel["data"]).iter().filter_map(double).collect()));
    let rates = members(&args["rates"]).into_iter();
    codec::Run {
        ties: ties.collect(),
        sensor: args["sensor"].is_object().then(|| sensor.collect()),
        rates: rates.filter_map(|(name, rate)| Some((name, double(&rate)?))).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_template_stands_for_the_text_that_the_runner_makes_of_it() {
        let parts = r#"[{"$repeat":"ab","times":2},{"$count":["<",">"],"times":3},{"$base64":"any"}]"#;
        let template: Value = serde_json::from_str(&format!("{{\"$concat\":{parts}}}")).unwrap();
        assert_eq!(text(&template), "abab<0><1><2>YW55");
    }
}
