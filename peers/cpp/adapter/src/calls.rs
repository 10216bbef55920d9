//! The calls (PROTOCOL.md, section 3): one function each, named after its call. Those with a trace are in
//! [`traces`].
//!
//! A library that offers only the seed's functions is asked what they can express, and nothing else: what
//! would need a guess is unsupported.

use std::borrow::Cow;
use std::collections::BTreeMap;

use serde::Deserialize;
use serde_json::value::RawValue;
use serde_json::{Value, json};

use crate::library::{Column, Data, Library, broken};
use crate::traces;
use crate::value::{self, Bytes, Double, Long};

/// The peer: a library, and what it says about itself.
pub(crate) struct Peer<'a> {
    pub(crate) library: &'a Library,
    pub(crate) name: &'a str,
    pub(crate) language: &'a str,
    /// The roles that it claims, with commas between them; else those whose functions it exports.
    pub(crate) roles: Option<&'a str>,
    /// Whether it claims the reference networks.
    pub(crate) reference_networks: bool,
}

/// Why a call has no result.
#[derive(Debug)]
pub(crate) enum CallError {
    /// The library refused; or it, or the request, broke a rule (`internal`).
    Refused { code: String, message: String },
    /// The library has no such function, or its function cannot express the call.
    Unsupported,
}

impl CallError {
    /// The arguments are none that PROTOCOL.md allows: the library was not asked.
    pub(crate) fn misfit(what: impl std::fmt::Display) -> Self {
        broken(&format!("the arguments do not fit PROTOCOL.md: {what}"))
    }
}

impl Peer<'_> {
    /// Carries out the call of this name.
    ///
    /// # Errors
    /// See [`CallError`].
    pub(crate) fn answer(&self, call: &str, args: &RawValue) -> Result<Value, CallError> {
        let library = self.library;
        match call {
            "describe" => self.describe(),
            "decode" => decode(library, &parse(args)?),
            "encode" => encode(library, &parse(args)?),
            "version.check" => version_check(library, &parse(args)?),
            "contract.status" => contract_status(library, &parse(args)?),
            "contract.verify" => contract_verify(library, &parse(args)?),
            "negotiate" => negotiate(library, &parse(args)?),
            "key.build" => key_build(library, &parse(args)?),
            "key.match" => key_match(library, &parse(args)?),
            "plane.qos" => plane_qos(library, &parse(args)?),
            "bulk.decode" => bulk_decode(library, &parse(args)?),
            "bulk.encode" => bulk_encode(library, &parse(args)?),
            "observation.pack" => observation_pack(library, parse(args)?),
            "observation.unpack" => observation_unpack(library, &parse(args)?),
            "reply.check" => reply_check(library, &parse(args)?),
            "governor.run" => traces::governor_run(library, &parse(args)?),
            "watchdog.run" => traces::watchdog_run(library, &parse(args)?),
            "buffer.run" => traces::buffer_run(library, &parse(args)?),
            "horizon.max_len" => traces::horizon_max_len(library, &parse(args)?),
            "link.run" => traces::link_run(library, &parse(args)?),
            "codec.encode" => traces::codec_encode(library, &parse(args)?),
            "codec.decode" => traces::codec_decode(library, &parse(args)?),
            "reflex.step" => traces::reflex_step(library, &parse(args)?),
            "loop.run" => traces::loop_run(library, &parse(args)?),
            "session.run" => traces::session_run(library, &parse(args)?),
            _ => Err(CallError::Unsupported),
        }
    }

    fn describe(&self) -> Result<Value, CallError> {
        let library = self.library;
        let roles: Vec<&str> = match self.roles {
            Some(roles) => roles.split(',').map(str::trim).collect(),
            None => ROLES
                .iter()
                .filter(|(_, functions)| functions.iter().any(|name| library.exports(name)))
                .map(|(role, _)| *role)
                .collect(),
        };
        let version = if library.extended { library.constant("library_version")? } else { "unknown".to_owned() };
        Ok(json!({
            "name": self.name,
            "version": version,
            "language": self.language,
            "wire_version": library.constant("version")?,
            "contract_hash": library.constant("contract_hash")?,
            "roles": roles,
            "reference_networks": self.reference_networks,
        }))
    }
}

/// The roles, each with the functions of which one shows that a library is meant to play it.
const ROLES: [(&str, &[&str]); 4] = [
    ("commander", &["govern", "governor_new"]),
    ("body", &["buffer_new", "watchdog_new"]),
    ("server", &["service_new"]),
    ("observer", &["validate", "decode"]),
];

#[derive(Deserialize)]
struct DecodeArgs<'a> {
    #[serde(borrow)]
    kind: Cow<'a, str>,
    #[serde(borrow)]
    text: Option<Cow<'a, str>>,
    base64: Option<Bytes>,
}

fn decode(library: &Library, args: &DecodeArgs<'_>) -> Result<Value, CallError> {
    let frame = match (&args.text, &args.base64) {
        (Some(text), None) => text.as_bytes(),
        (None, Some(Bytes(bytes))) => bytes,
        _ => return Err(CallError::misfit("decode takes either text or base64")),
    };
    if library.extended {
        let text = library.decode(&args.kind, frame)?;
        // Nothing is the frame that was read, but that none can hold.
        return Ok(if text.is_empty() { json!({}) } else { json!({ "text": text }) });
    }
    seed_kind(&args.kind)?;
    Ok(json!({ "text": library.validate(&args.kind, frame)? }))
}

#[derive(Deserialize)]
struct EncodeArgs<'a> {
    #[serde(borrow)]
    kind: Cow<'a, str>,
    #[serde(borrow)]
    fields: &'a RawValue,
}

fn encode(library: &Library, args: &EncodeArgs<'_>) -> Result<Value, CallError> {
    if library.extended {
        let text = library.encode(&args.kind, args.fields.get())?;
        return Ok(json!({ "text": text }));
    }
    // The seed has a function from JSON to JSON (PROTOCOL.md, `encode`).
    seed_kind(&args.kind)?;
    let frame = frame(library, &args.kind, args.fields)?;
    let text = library.validate(&args.kind, frame.as_bytes())?;
    Ok(json!({ "text": text }))
}

/// The error frame is none of the contract's messages, so the seed need not know it.
fn seed_kind(kind: &str) -> Result<(), CallError> {
    if kind == "error" {
        return Err(CallError::Unsupported);
    }
    Ok(())
}

/// The frame of these fields, for a function that takes frames.
///
/// # Errors
/// Unsupported if the fields say what no frame says: a number that JSON lacks; or leave out what a program
/// has another default for than the wire.
pub(crate) fn frame(library: &Library, kind: &str, fields: &RawValue) -> Result<String, CallError> {
    let members = expressible(fields)?;
    // [NCP-WIRE-038] and the hash, which a program advertises and the wire does not suppose.
    let differs = match kind {
        "command_frame" => Some("mode"),
        "open_session" | "session_opened" => Some("contract_hash"),
        _ => None,
    };
    if differs.is_some_and(|name| !members.contains_key(name)) {
        return Err(CallError::Unsupported);
    }
    let mut frame = format!(r#"{{"kind":"{kind}""#);
    if !members.contains_key("ncp_version") {
        frame += &format!(r#","ncp_version":{}"#, Value::from(library.constant("version")?));
    }
    for (name, value) in members.iter().filter(|(name, _)| *name != "kind") {
        frame += &format!(",{}:{value}", Value::from(name.as_str()));
    }
    Ok(frame + "}")
}

/// The members of an object that holds only what JSON can say.
///
/// # Errors
/// Unsupported if a string in it may stand for a number that JSON lacks.
pub(crate) fn expressible(object: &RawValue) -> Result<BTreeMap<String, &RawValue>, CallError> {
    fn is_plain(value: &Value) -> bool {
        match value {
            Value::String(text) => value::NAMES.iter().all(|(name, _)| name != text),
            Value::Array(items) => items.iter().all(is_plain),
            Value::Object(members) => members.values().all(is_plain),
            _ => true,
        }
    }

    if !is_plain(&parse(object)?) {
        return Err(CallError::Unsupported);
    }
    parse(object)
}

#[derive(Deserialize)]
struct VersionArgs<'a> {
    #[serde(borrow)]
    version: Cow<'a, str>,
    strict: bool,
}

fn version_check(library: &Library, args: &VersionArgs<'_>) -> Result<Value, CallError> {
    let code = library.check_version(&args.version, args.strict)?;
    Ok(json!({ "compatible": yes(code)? }))
}

#[derive(Deserialize)]
struct HashArgs<'a> {
    #[serde(borrow)]
    peer_hash: Option<Cow<'a, str>>,
}

fn contract_status(library: &Library, args: &HashArgs<'_>) -> Result<Value, CallError> {
    let code = library.contract_status(args.peer_hash.as_deref())?;
    Ok(json!({ "status": status(code)? }))
}

fn contract_verify(library: &Library, args: &HashArgs<'_>) -> Result<Value, CallError> {
    library.verify_contract(args.peer_hash.as_deref())?;
    Ok(json!({}))
}

#[derive(Deserialize)]
struct NegotiateArgs<'a> {
    #[serde(borrow)]
    version: Cow<'a, str>,
    #[serde(borrow)]
    contract_hash: Option<Cow<'a, str>>,
}

fn negotiate(library: &Library, args: &NegotiateArgs<'_>) -> Result<Value, CallError> {
    let code = library.negotiate(&args.version, args.contract_hash.as_deref())?;
    Ok(json!({ "contract": status(code)? }))
}

fn status(code: i32) -> Result<&'static str, CallError> {
    match code {
        1 => Ok("match"),
        0 => Ok("not_advertised"),
        2 => Ok("mismatch"),
        _ => Err(broken(&format!("the library returned the status {code}"))),
    }
}

pub(crate) fn yes(code: i32) -> Result<bool, CallError> {
    match code {
        0 => Ok(false),
        1 => Ok(true),
        _ => Err(broken(&format!("the library returned {code} for yes or no"))),
    }
}

#[derive(Deserialize)]
struct KeyArgs<'a> {
    #[serde(borrow)]
    key: Cow<'a, str>,
    #[serde(borrow)]
    realm: Option<Cow<'a, str>>,
    #[serde(borrow)]
    session: Option<Cow<'a, str>>,
    #[serde(borrow)]
    name: Option<Cow<'a, str>>,
}

fn key_build(library: &Library, args: &KeyArgs<'_>) -> Result<Value, CallError> {
    let (realm, session) = (args.realm.as_deref(), args.session.as_deref());
    let key = match args.name.as_deref() {
        name if library.extended => library.key(&args.key, realm, session, name)?,
        Some(_) => return Err(CallError::Unsupported),
        None => library.seed_key(&args.key, realm, session)?,
    };
    Ok(json!({ "key": key }))
}

#[derive(Deserialize)]
struct MatchArgs<'a> {
    #[serde(borrow)]
    pattern: Cow<'a, str>,
    #[serde(borrow)]
    key: Cow<'a, str>,
}

fn key_match(library: &Library, args: &MatchArgs<'_>) -> Result<Value, CallError> {
    let code = library.key_matches(&args.pattern, &args.key)?;
    Ok(json!({ "matches": yes(code)? }))
}

#[derive(Deserialize)]
struct PlaneArgs<'a> {
    #[serde(borrow)]
    plane: Cow<'a, str>,
}

fn plane_qos(library: &Library, args: &PlaneArgs<'_>) -> Result<Value, CallError> {
    let (congestion, priority, express) = library.plane_qos(&args.plane)?;
    Ok(json!({ "congestion": congestion, "priority": priority, "express": express }))
}

#[derive(Deserialize)]
struct BlockArgs {
    block: Bytes,
}

fn bulk_decode(library: &Library, args: &BlockArgs) -> Result<Value, CallError> {
    let Bytes(block) = &args.block;
    let columns = library.block_columns(block)?;
    let columns: Vec<Value> = columns
        .iter()
        .map(|Column { name, data }| {
            let (dtype, data) = match data {
                Data::F32(values) => ("f32", doubles_out(values.iter().copied().map(f64::from))),
                Data::F64(values) => ("f64", doubles_out(values.iter().copied())),
                Data::I32(values) => ("i32", json!(values)),
                Data::I64(values) => ("i64", longs_out(values)),
            };
            json!({ "name": name, "dtype": dtype, "data": data })
        })
        .collect();
    Ok(json!({ "columns": columns }))
}

#[derive(Deserialize)]
struct ColumnsArgs<'a> {
    #[serde(borrow)]
    columns: Vec<ColumnArgs<'a>>,
}

#[derive(Deserialize)]
struct ColumnArgs<'a> {
    name: String,
    #[serde(borrow)]
    dtype: Cow<'a, str>,
    #[serde(borrow)]
    data: &'a RawValue,
}

fn bulk_encode(library: &Library, args: &ColumnsArgs<'_>) -> Result<Value, CallError> {
    let columns = args
        .columns
        .iter()
        .map(|ColumnArgs { name, dtype, data }| {
            let data = match &**dtype {
                "f32" => {
                    let doubles = doubles_in(parse(data)?);
                    Data::F32(doubles.into_iter().map(|value| value as f32).collect())
                }
                "f64" => Data::F64(doubles_in(parse(data)?)),
                "i32" => Data::I32(parse(data)?),
                "i64" => Data::I64(longs_in(parse(data)?)),
                _ => return Err(CallError::misfit("not a dtype")),
            };
            let name = name.clone();
            Ok(Column { name, data })
        })
        .collect::<Result<Vec<_>, _>>()?;
    Ok(json!({ "block": value::base64(&library.block_encode(&columns)?) }))
}

#[derive(Deserialize)]
struct ArraysArgs {
    times: Vec<Double>,
    values: Vec<Double>,
    senders: Vec<Long>,
}

fn observation_pack(library: &Library, args: ArraysArgs) -> Result<Value, CallError> {
    let (times, values) = (doubles_in(args.times), doubles_in(args.values));
    let block = library.observation_pack(&times, &values, &longs_in(args.senders))?;
    Ok(json!({ "block": value::base64(&block) }))
}

fn observation_unpack(library: &Library, args: &BlockArgs) -> Result<Value, CallError> {
    let (times, values, senders) = library.observation_unpack(&args.block.0)?;
    Ok(json!({
        "times": doubles_out(times.into_iter()),
        "values": doubles_out(values.into_iter()),
        "senders": longs_out(&senders),
    }))
}

#[derive(Deserialize)]
struct ReplyArgs<'a> {
    #[serde(borrow)]
    request: Cow<'a, str>,
    #[serde(borrow)]
    reply: Cow<'a, str>,
}

fn reply_check(library: &Library, args: &ReplyArgs<'_>) -> Result<Value, CallError> {
    library.check_reply(&args.request, &args.reply)?;
    Ok(json!({}))
}

pub(crate) fn parse<'a, T: Deserialize<'a>>(args: &'a RawValue) -> Result<T, CallError> {
    serde_json::from_str(args.get()).map_err(CallError::misfit)
}

/// A JSON text of the library, as a part of an answer.
pub(crate) fn json(text: &str) -> Result<Value, CallError> {
    serde_json::from_str(text).map_err(|error| broken(&format!("the library returned no JSON: {error}")))
}

fn doubles_in(values: Vec<Double>) -> Vec<f64> {
    values.into_iter().map(|Double(value)| value).collect()
}

fn longs_in(values: Vec<Long>) -> Vec<i64> {
    values.into_iter().map(|Long(value)| value).collect()
}

fn doubles_out(values: impl Iterator<Item = f64>) -> Value {
    values.map(value::shown).collect()
}

fn longs_out(values: &[i64]) -> Value {
    values.iter().map(ToString::to_string).collect()
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test fails by panicking")]
mod tests {
    use super::*;

    fn raw(text: &str) -> &RawValue {
        serde_json::from_str(text).unwrap()
    }

    #[test]
    fn fields_with_a_number_that_json_lacks_are_unsupported_at_any_depth() {
        for text in [r#"{"t":"NaN"}"#, r#"{"channels":{"c":{"data":[1.0,"-Infinity"]}}}"#, r#"{"a":[[{"b":"-0"}]]}"#] {
            let refused = expressible(raw(text)).unwrap_err();
            assert!(matches!(refused, CallError::Unsupported), "{text}");
        }
        let members = expressible(raw(r#"{"t":1e400,"frame_id":"world","NaN":1}"#));
        assert!(members.is_err(), "a number beyond a double is none that JSON readers share");
        assert_eq!(expressible(raw(r#"{"seq":1,"NaN":2}"#)).unwrap().len(), 2);
    }

    #[test]
    fn a_code_that_is_neither_yes_nor_no_is_the_librarys_fault() {
        assert!(yes(1).unwrap() && !yes(0).unwrap());
        for code in [2, -2, i32::MAX] {
            let CallError::Refused { code, .. } = yes(code).unwrap_err() else {
                unreachable!();
            };
            assert_eq!(code, "internal");
        }
    }
}
