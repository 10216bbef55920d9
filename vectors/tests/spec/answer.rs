//! What the executable specification answers to a call.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use ncp_spec::bulk::{self, Block, Column, ColumnData, Dtype};
use ncp_spec::contract::{contract_status, negotiate, verify_contract};
use ncp_spec::keys::{self, KeyError, Keys};
use ncp_spec::plane::Plane;
use ncp_spec::reply::{check_reply, check_reply_strict};
use ncp_spec::version::check_version;
use ncp_spec::wire::{self, Kind};
use serde_json::{Value, json};

/// The result, or the error in words.
pub(crate) type Answer = Result<Value, String>;

pub(crate) fn answer(call: &str, args: &Value) -> Answer {
    let text = |name: &str| args[name].as_str();
    let given = |name: &str| text(name).unwrap_or_else(|| panic!("{call} without {name}"));
    match call {
        "decode" => decode(args),
        "encode" => {
            let kind = Kind::parse(given("kind")).unwrap();
            let message = wire::build(kind, args["fields"].to_string().as_bytes()).map_err(words)?;
            Ok(json!({ "text": message.encode().map_err(words)? }))
        }
        "version.check" => {
            let compatible = check_version(given("version"), args["strict"].as_bool().unwrap());
            Ok(json!({ "compatible": compatible.map_err(words)? }))
        }
        "contract.status" => Ok(json!({ "status": contract_status(text("peer_hash")).as_str() })),
        "contract.verify" => verify_contract(text("peer_hash")).map(|()| json!({})).map_err(words),
        "negotiate" => {
            let status = negotiate(given("version"), text("contract_hash")).map_err(words)?;
            Ok(json!({ "contract": status.as_str() }))
        }
        "key.build" => Ok(json!({ "key": key(args).map_err(words)? })),
        "key.match" => {
            let matches = keys::matches(given("pattern"), given("key")).map_err(words)?;
            Ok(json!({ "matches": matches }))
        }
        "plane.qos" => {
            let qos = Plane::parse(given("plane")).unwrap().qos();
            Ok(json!({
                "congestion": qos.congestion.as_str(),
                "priority": qos.priority.as_str(),
                "express": qos.express,
            }))
        }
        "bulk.decode" => {
            let block = bytes(given("block"));
            let columns = Block::parse(&block).map_err(words)?.to_columns();
            Ok(json!({ "columns": columns.iter().map(column_out).collect::<Value>() }))
        }
        "bulk.encode" => {
            let columns: Vec<Column> = args["columns"].as_array().unwrap().iter().map(column_in).collect();
            Ok(json!({ "block": STANDARD.encode(bulk::encode(&columns).map_err(words)?) }))
        }
        "observation.pack" => {
            let senders = longs_in(&args["senders"]);
            let block = bulk::pack(&doubles_in(&args["times"]), &doubles_in(&args["values"]), &senders);
            Ok(json!({ "block": STANDARD.encode(block.map_err(words)?) }))
        }
        "observation.unpack" => {
            let (times, values, senders) = bulk::unpack(&bytes(given("block"))).map_err(words)?;
            Ok(json!({
                "times": doubles_out(&times),
                "values": doubles_out(&values),
                "senders": longs_out(&senders),
            }))
        }
        "reply.check" => {
            let request = wire::decode_any(given("request").as_bytes()).expect("a request is a frame");
            let check = if strict(args) { check_reply_strict } else { check_reply };
            check(&request, given("reply").as_bytes()).map(|_| json!({})).map_err(words)
        }
        _ => panic!("{call} is no call of this level"),
    }
}

/// What the spec reads in a frame, as the spec writes it.
pub(crate) fn decode(args: &Value) -> Answer {
    let kind = Kind::parse(args["kind"].as_str().unwrap()).unwrap();
    let frame = match args["text"].as_str() {
        Some(text) => text.as_bytes().to_vec(),
        None => bytes(args["base64"].as_str().unwrap()),
    };
    let decode = if strict(args) { wire::decode_strict } else { wire::decode };
    let message = decode(kind, &frame).map_err(words)?;
    // What was read can be written: only then is there an answer at all.
    Ok(json!({ "text": message.encode().expect("what was read can be written") }))
}

/// The columns of a block, as the peer protocol writes them.
pub(crate) fn columns_of(block: &str) -> Result<Value, String> {
    let block = bytes(block);
    let columns = Block::parse(&block).map_err(words)?.to_columns();
    Ok(columns.iter().map(column_out).collect())
}

fn strict(args: &Value) -> bool {
    args["strict"] == true
}

fn words(error: impl std::fmt::Display) -> String {
    error.to_string()
}

fn bytes(base64: &str) -> Vec<u8> {
    STANDARD.decode(base64).expect("base64")
}

fn key(args: &Value) -> Result<String, KeyError> {
    let keys = Keys::new(args["realm"].as_str())?;
    let session = args["session"].as_str().unwrap_or_default();
    let name = args["name"].as_str();
    match args["key"].as_str().unwrap() {
        "rpc" => match args["verb"].as_str() {
            Some(verb) => keys.rpc_verb(Kind::parse(verb).unwrap_or(Kind::Error)),
            None => keys.rpc(),
        },
        "sensor" => keys.sensor(session, name),
        "command" => keys.command(session, name),
        "observation" => keys.observation(session),
        "sensor_glob" => keys.sensor_glob(session),
        "command_glob" => keys.command_glob(session),
        "session_glob" => keys.session_glob(session),
        "fleet_glob" => keys.fleet_glob(),
        other => panic!("{other} is no key"),
    }
}

fn column_in(column: &Value) -> Column {
    let data = &column["data"];
    let data = match Dtype::parse(column["dtype"].as_str().unwrap()).unwrap() {
        Dtype::F32 => ColumnData::F32(doubles_in(data).into_iter().map(|value| value as f32).collect()),
        Dtype::F64 => ColumnData::F64(doubles_in(data)),
        Dtype::I32 => {
            let values = data.as_array().unwrap().iter();
            ColumnData::I32(values.map(|value| i32::try_from(value.as_i64().unwrap()).unwrap()).collect())
        }
        Dtype::I64 => ColumnData::I64(longs_in(data)),
    };
    Column::new(column["name"].as_str().unwrap(), data)
}

fn column_out(column: &Column) -> Value {
    let data = match &column.data {
        ColumnData::F32(values) => doubles_out(&values.iter().map(|value| f64::from(*value)).collect::<Vec<_>>()),
        ColumnData::F64(values) => doubles_out(values),
        ColumnData::I32(values) => json!(values),
        ColumnData::I64(values) => longs_out(values),
    };
    json!({ "name": column.name, "dtype": column.data.dtype().as_str(), "data": data })
}

fn doubles_in(values: &Value) -> Vec<f64> {
    let double = |value: &Value| match value.as_str() {
        Some("NaN") => f64::NAN,
        Some("Infinity") => f64::INFINITY,
        Some("-Infinity") => f64::NEG_INFINITY,
        Some("-0") => -0.0,
        _ => value.as_f64().expect("a double"),
    };
    values.as_array().expect("doubles").iter().map(double).collect()
}

fn doubles_out(values: &[f64]) -> Value {
    let double = |value: &f64| match value {
        value if value.is_nan() => json!("NaN"),
        value if value.is_infinite() => json!(if *value > 0.0 { "Infinity" } else { "-Infinity" }),
        value if value.to_bits() == (-0.0_f64).to_bits() => json!("-0"),
        value => json!(value),
    };
    values.iter().map(double).collect()
}

fn longs_in(values: &Value) -> Vec<i64> {
    let long = |value: &Value| value.as_str().expect("a string of digits").parse().expect("an i64");
    values.as_array().expect("integers").iter().map(long).collect()
}

fn longs_out(values: &[i64]) -> Value {
    values.iter().map(|value| json!(value.to_string())).collect()
}
