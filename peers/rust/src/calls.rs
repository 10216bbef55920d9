//! The calls (PROTOCOL.md, section 3): one function each, named after its call. Those with a trace are in
//! [`traces`].

use std::borrow::Cow;
use std::collections::BTreeMap;

use ncp_spec::bulk::{self, Block, BulkError, Column, ColumnData, Dtype};
use ncp_spec::contract::{self, ContractError, NegotiateError};
use ncp_spec::control::{LoopError, ReflexError};
use ncp_spec::keys::{self, KeyError, Keys};
use ncp_spec::plane::{Plane, Qos};
use ncp_spec::reply::{self, ReplyError};
use ncp_spec::version::{self, VersionError};
use ncp_spec::wire::{self, DecodeError, DecodeProblem, EncodeError, Kind, Message};
use ncp_spec::{CONTRACT_HASH, ErrorCode, WIRE_VERSION};
use serde::{Deserialize, Serialize, Serializer};
use serde_json::value::RawValue;

use crate::traces::{self, StepReply};
use crate::value::{Bytes, Double, Fields, Long};

/// Carries out the call of this name.
///
/// # Errors
/// The refusal of `ncp-spec`; [`CallError::Unsupported`] for a name that is none of the
/// calls; `internal` for arguments that PROTOCOL.md does not allow.
pub(crate) fn answer(call: &str, args: &RawValue) -> Result<Reply, CallError> {
    match call {
        "describe" => Ok(describe()),
        "decode" => decode(&parse(args)?),
        "encode" => encode(&parse(args)?),
        "version.check" => version_check(&parse(args)?),
        "contract.status" => Ok(contract_status(&parse(args)?)),
        "contract.verify" => contract_verify(&parse(args)?),
        "negotiate" => negotiate(&parse(args)?),
        "key.build" => key_build(&parse(args)?),
        "key.match" => key_match(&parse(args)?),
        "plane.qos" => plane_qos(&parse(args)?),
        "bulk.decode" => bulk_decode(&parse(args)?),
        "bulk.encode" => bulk_encode(&parse(args)?),
        "observation.pack" => observation_pack(parse(args)?),
        "observation.unpack" => observation_unpack(&parse(args)?),
        "reply.check" => reply_check(&parse(args)?),
        "governor.run" => traces::governor_run(&parse(args)?),
        "watchdog.run" => traces::watchdog_run(&parse(args)?),
        "buffer.run" => traces::buffer_run(&parse(args)?),
        "horizon.max_len" => Ok(traces::horizon_max_len(&parse(args)?)),
        "link.run" => traces::link_run(&parse(args)?),
        "codec.encode" => traces::codec_encode(parse(args)?),
        "codec.decode" => traces::codec_decode(parse(args)?),
        "reflex.step" => traces::reflex_step(&parse(args)?),
        "loop.run" => traces::loop_run(&parse(args)?),
        "session.run" => traces::session_run(&parse(args)?),
        _ => Err(CallError::Unsupported),
    }
}

/// Why a call has no result.
#[derive(Debug)]
pub(crate) enum CallError {
    /// `ncp-spec` refused.
    Refused {
        /// The reason.
        code: ErrorCode,
        /// The reason in words.
        message: String,
    },
    /// The peer does not know the call.
    Unsupported,
}

impl CallError {
    /// The arguments are none that PROTOCOL.md allows. Nothing of `ncp-spec` was asked, so
    /// this must not count as its refusal: `internal` never satisfies a case.
    pub(crate) fn misfit(what: &impl std::fmt::Display) -> Self {
        let message = format!("the arguments do not fit PROTOCOL.md: {what}");
        Self::Refused { code: ErrorCode::Internal, message }
    }
}

macro_rules! refusal {
    ($($error:ty),+) => {$(
        impl From<$error> for CallError {
            fn from(error: $error) -> Self {
                Self::Refused { code: error.code(), message: error.to_string() }
            }
        }
    )+};
}

refusal!(BulkError, ContractError, DecodeError, EncodeError, KeyError, NegotiateError, ReplyError, VersionError);

impl From<ReflexError> for CallError {
    fn from(error: ReflexError) -> Self {
        Self::Refused { code: ErrorCode::Value, message: error.to_string() }
    }
}

impl From<LoopError> for CallError {
    fn from(error: LoopError) -> Self {
        Self::Refused { code: ErrorCode::Value, message: error.to_string() }
    }
}

/// What a call gives, in the members that PROTOCOL.md lists with it.
#[derive(Debug, Serialize)]
#[serde(untagged)]
pub(crate) enum Reply {
    Description {
        name: &'static str,
        version: &'static str,
        language: &'static str,
        wire_version: &'static str,
        contract_hash: &'static str,
        roles: [&'static str; 4],
        reference_networks: bool,
    },
    Frame {
        text: String,
    },
    Compatible {
        compatible: bool,
    },
    Status {
        status: &'static str,
    },
    Negotiated {
        contract: &'static str,
    },
    Key {
        key: String,
    },
    Matches {
        matches: bool,
    },
    Qos {
        congestion: &'static str,
        priority: &'static str,
        express: bool,
    },
    Columns {
        #[serde(serialize_with = "columns_out")]
        columns: Vec<Column>,
    },
    Block {
        block: Bytes,
    },
    Arrays {
        times: Vec<Double>,
        values: Vec<Double>,
        senders: Vec<Long>,
    },
    Steps {
        steps: Vec<StepReply>,
    },
    Len {
        len: usize,
    },
    Rates {
        rates: BTreeMap<String, Double>,
    },
    Command {
        command: Fields,
    },
    Replies {
        replies: Vec<String>,
    },
    Nothing {},
}

fn describe() -> Reply {
    Reply::Description {
        name: "rust",
        version: env!("CARGO_PKG_VERSION"),
        language: "Rust",
        wire_version: WIRE_VERSION,
        contract_hash: CONTRACT_HASH,
        roles: ["commander", "body", "server", "observer"],
        reference_networks: true,
    }
}

#[derive(Deserialize)]
struct DecodeArgs<'a> {
    #[serde(borrow)]
    kind: Cow<'a, str>,
    #[serde(borrow)]
    text: Option<Cow<'a, str>>,
    base64: Option<Bytes>,
    #[serde(default)]
    strict: bool,
}

fn decode(args: &DecodeArgs<'_>) -> Result<Reply, CallError> {
    let frame = match (&args.text, &args.base64) {
        (Some(text), None) => text.as_bytes(),
        (None, Some(Bytes(bytes))) => bytes,
        _ => return Err(CallError::misfit(&"decode takes either text or base64")),
    };
    let kind = kind(&args.kind)?;
    let message = if args.strict { wire::decode_strict(kind, frame)? } else { wire::decode(kind, frame)? };
    // The frame was read, whatever the encoder says to it.
    Ok(message.encode().map_or(Reply::Nothing {}, |text| Reply::Frame { text }))
}

#[derive(Deserialize)]
struct EncodeArgs<'a> {
    #[serde(borrow)]
    kind: Cow<'a, str>,
    #[serde(borrow)]
    fields: &'a RawValue,
}

fn encode(args: &EncodeArgs<'_>) -> Result<Reply, CallError> {
    let message = build(kind(&args.kind)?, args.fields.get())?;
    Ok(Reply::Frame { text: message.encode()? })
}

/// The message of these fields.
pub(crate) fn build(kind: Kind, fields: &str) -> Result<Message, CallError> {
    wire::build(kind, fields.as_bytes()).map_err(|error| match error.problem() {
        // A program that names such a field does not even compile.
        DecodeProblem::NoSuchField | DecodeProblem::NotAnObject => CallError::misfit(&error),
        _ => error.into(),
    })
}

#[derive(Deserialize)]
struct VersionArgs<'a> {
    #[serde(borrow)]
    version: Cow<'a, str>,
    strict: bool,
}

fn version_check(args: &VersionArgs<'_>) -> Result<Reply, CallError> {
    let compatible = version::check_version(&args.version, args.strict)?;
    Ok(Reply::Compatible { compatible })
}

#[derive(Deserialize)]
struct HashArgs<'a> {
    #[serde(borrow)]
    peer_hash: Option<Cow<'a, str>>,
}

fn contract_status(args: &HashArgs<'_>) -> Reply {
    Reply::Status { status: contract::contract_status(args.peer_hash.as_deref()).as_str() }
}

fn contract_verify(args: &HashArgs<'_>) -> Result<Reply, CallError> {
    contract::verify_contract(args.peer_hash.as_deref())?;
    Ok(Reply::Nothing {})
}

#[derive(Deserialize)]
struct NegotiateArgs<'a> {
    #[serde(borrow)]
    version: Cow<'a, str>,
    #[serde(borrow)]
    contract_hash: Option<Cow<'a, str>>,
}

fn negotiate(args: &NegotiateArgs<'_>) -> Result<Reply, CallError> {
    let status = contract::negotiate(&args.version, args.contract_hash.as_deref())?;
    Ok(Reply::Negotiated { contract: status.as_str() })
}

#[derive(Deserialize)]
struct KeyArgs<'a> {
    key: KeyKind,
    #[serde(borrow)]
    realm: Option<Cow<'a, str>>,
    #[serde(borrow)]
    verb: Option<Cow<'a, str>>,
    #[serde(borrow)]
    session: Option<Cow<'a, str>>,
    #[serde(borrow)]
    name: Option<Cow<'a, str>>,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "snake_case")]
enum KeyKind {
    Rpc,
    Sensor,
    Command,
    Observation,
    SensorGlob,
    CommandGlob,
    SessionGlob,
    FleetGlob,
}

fn key_build(args: &KeyArgs<'_>) -> Result<Reply, CallError> {
    let keys = Keys::new(args.realm.as_deref())?;
    let session = || {
        let session = args.session.as_deref();
        session.ok_or_else(|| CallError::misfit(&"this key is built from a session"))
    };
    let name = args.name.as_deref();
    let key = match args.key {
        KeyKind::Rpc => match &args.verb {
            Some(verb) => keys.rpc_verb(verb_in(verb)?)?,
            None => keys.rpc()?,
        },
        KeyKind::Sensor => keys.sensor(session()?, name)?,
        KeyKind::Command => keys.command(session()?, name)?,
        KeyKind::Observation => keys.observation(session()?)?,
        KeyKind::SensorGlob => keys.sensor_glob(session()?)?,
        KeyKind::CommandGlob => keys.command_glob(session()?)?,
        KeyKind::SessionGlob => keys.session_glob(session()?)?,
        KeyKind::FleetGlob => keys.fleet_glob()?,
    };
    Ok(Reply::Key { key })
}

/// The kind of this name. One that NCP does not have cannot even be named to [`Keys::rpc_verb`].
fn verb_in(name: &str) -> Result<Kind, CallError> {
    Kind::parse(name)
        .ok_or_else(|| CallError::Refused { code: ErrorCode::Key, message: format!("{name:?} is not a kind") })
}

#[derive(Deserialize)]
struct MatchArgs<'a> {
    #[serde(borrow)]
    pattern: Cow<'a, str>,
    #[serde(borrow)]
    key: Cow<'a, str>,
}

fn key_match(args: &MatchArgs<'_>) -> Result<Reply, CallError> {
    Ok(Reply::Matches { matches: keys::matches(&args.pattern, &args.key)? })
}

#[derive(Deserialize)]
struct PlaneArgs<'a> {
    #[serde(borrow)]
    plane: Cow<'a, str>,
}

fn plane_qos(args: &PlaneArgs<'_>) -> Result<Reply, CallError> {
    let plane = Plane::parse(&args.plane).ok_or_else(|| CallError::misfit(&"not a plane"))?;
    let Qos { congestion, priority, express } = plane.qos();
    Ok(Reply::Qos { congestion: congestion.as_str(), priority: priority.as_str(), express })
}

#[derive(Deserialize)]
struct BlockArgs {
    block: Bytes,
}

fn bulk_decode(args: &BlockArgs) -> Result<Reply, CallError> {
    let Bytes(block) = &args.block;
    Ok(Reply::Columns { columns: Block::parse(block)?.to_columns() })
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
    /// Parsed once the dtype is known, which may stand behind it.
    #[serde(borrow)]
    data: &'a RawValue,
}

fn bulk_encode(args: &ColumnsArgs<'_>) -> Result<Reply, CallError> {
    let columns: Vec<Column> = args.columns.iter().map(column_in).collect::<Result<_, _>>()?;
    Ok(Reply::Block { block: Bytes(bulk::encode(&columns)?) })
}

#[derive(Deserialize)]
struct ArraysArgs {
    times: Vec<Double>,
    values: Vec<Double>,
    senders: Vec<Long>,
}

fn observation_pack(args: ArraysArgs) -> Result<Reply, CallError> {
    let (times, values) = (doubles_in(args.times), doubles_in(args.values));
    let block = bulk::pack(&times, &values, &longs_in(args.senders))?;
    Ok(Reply::Block { block: Bytes(block) })
}

fn observation_unpack(args: &BlockArgs) -> Result<Reply, CallError> {
    let Bytes(block) = &args.block;
    let (times, values, senders) = bulk::unpack(block)?;
    Ok(Reply::Arrays {
        times: times.into_iter().map(Double).collect(),
        values: values.into_iter().map(Double).collect(),
        senders: senders.into_iter().map(Long).collect(),
    })
}

#[derive(Deserialize)]
struct ReplyArgs<'a> {
    #[serde(borrow)]
    request: Cow<'a, str>,
    #[serde(borrow)]
    reply: Cow<'a, str>,
    #[serde(default)]
    strict: bool,
}

fn reply_check(args: &ReplyArgs<'_>) -> Result<Reply, CallError> {
    // The client sent this request, so it is one: only the reply is on trial.
    let request = wire::decode_any(args.request.as_bytes())
        .map_err(|error| CallError::misfit(&format_args!("the request: {error}")))?;
    if args.strict {
        reply::check_reply_strict(&request, args.reply.as_bytes())?;
    } else {
        reply::check_reply(&request, args.reply.as_bytes())?;
    }
    Ok(Reply::Nothing {})
}

pub(crate) fn parse<'a, T: Deserialize<'a>>(args: &'a RawValue) -> Result<T, CallError> {
    serde_json::from_str(args.get()).map_err(|error| CallError::misfit(&error))
}

/// The kind of this name.
pub(crate) fn kind(name: &str) -> Result<Kind, CallError> {
    Kind::parse(name).ok_or_else(|| CallError::misfit(&format_args!("{name:?} is not a kind")))
}

fn column_in(column: &ColumnArgs<'_>) -> Result<Column, CallError> {
    let unknown = || CallError::misfit(&format_args!("{:?} is not a dtype", column.dtype));
    let data = match Dtype::parse(&column.dtype).ok_or_else(unknown)? {
        Dtype::F32 => {
            let doubles: Vec<Double> = parse(column.data)?;
            ColumnData::F32(doubles.into_iter().map(|Double(value)| value as f32).collect())
        }
        Dtype::F64 => ColumnData::F64(doubles_in(parse(column.data)?)),
        Dtype::I32 => ColumnData::I32(parse(column.data)?),
        Dtype::I64 => ColumnData::I64(longs_in(parse(column.data)?)),
    };
    Ok(Column::new(column.name.clone(), data))
}

fn columns_out<S: Serializer>(columns: &[Column], serializer: S) -> Result<S::Ok, S::Error> {
    #[derive(Serialize)]
    struct ColumnReply<'a> {
        name: &'a str,
        dtype: &'static str,
        data: Data<'a>,
    }

    struct Data<'a>(&'a ColumnData);

    impl Serialize for Data<'_> {
        fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
            match self.0 {
                ColumnData::F32(values) => serializer.collect_seq(values.iter().map(|value| Double(f64::from(*value)))),
                ColumnData::F64(values) => serializer.collect_seq(values.iter().copied().map(Double)),
                ColumnData::I32(values) => serializer.collect_seq(values),
                ColumnData::I64(values) => serializer.collect_seq(values.iter().copied().map(Long)),
            }
        }
    }

    serializer.collect_seq(columns.iter().map(|column| ColumnReply {
        name: &column.name,
        dtype: column.data.dtype().as_str(),
        data: Data(&column.data),
    }))
}

fn doubles_in(values: Vec<Double>) -> Vec<f64> {
    values.into_iter().map(|Double(value)| value).collect()
}

fn longs_in(values: Vec<Long>) -> Vec<i64> {
    values.into_iter().map(|Long(value)| value).collect()
}
