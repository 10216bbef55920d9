//! The calls (PROTOCOL.md, section 3): one method each, named after its call. Those with a trace are in
//! [`traces`].

use ncp_adapter::reply::{Arrays, Description, Qos, StepReply};
use ncp_adapter::value::{self, Double, Fields, Long};
use ncp_adapter::{CallError, Peer, args};
use ncp_spec::bulk::{self, Block, Column, ColumnData};
use ncp_spec::keys::{self, Keys};
use ncp_spec::plane::Plane;
use ncp_spec::wire::{self, Kind};
use ncp_spec::{CONTRACT_HASH, ErrorCode, WIRE_VERSION, contract, reply, version};

use crate::refusal::Refusal;
use crate::traces;
use crate::value::{build, kind};

/// The executable specification as a peer.
pub(crate) struct Specification;

impl Peer for Specification {
    type Error = Refusal;

    fn describe(&self) -> Result<Description<'_>, Refusal> {
        Ok(Description {
            name: "rust".into(),
            version: env!("CARGO_PKG_VERSION").into(),
            language: "Rust".into(),
            wire_version: WIRE_VERSION.into(),
            contract_hash: CONTRACT_HASH.into(),
            roles: ["commander", "body", "server", "observer"].map(Into::into).into(),
            reference_networks: true,
        })
    }

    fn decode(&self, args: &args::Decode<'_>) -> Result<Option<String>, Refusal> {
        let (frame, kind) = (args.frame()?, kind(&args.kind)?);
        let message = if args.strict { wire::decode_strict(kind, frame)? } else { wire::decode(kind, frame)? };
        // The frame was read, whatever the encoder says to it.
        Ok(message.encode().ok())
    }

    fn encode(&self, args: &args::Encode<'_>) -> Result<String, Refusal> {
        Ok(build(kind(&args.kind)?, args.fields.get())?.encode()?)
    }

    fn version_check(&self, args: &args::VersionCheck<'_>) -> Result<bool, Refusal> {
        Ok(version::check_version(&args.version, args.strict)?)
    }

    fn contract_status(&self, args: &args::Contract<'_>) -> Result<&'static str, Refusal> {
        Ok(contract::contract_status(args.peer_hash.as_deref()).as_str())
    }

    fn contract_verify(&self, args: &args::Contract<'_>) -> Result<(), Refusal> {
        Ok(contract::verify_contract(args.peer_hash.as_deref())?)
    }

    fn negotiate(&self, args: &args::Negotiate<'_>) -> Result<&'static str, Refusal> {
        Ok(contract::negotiate(&args.version, args.contract_hash.as_deref())?.as_str())
    }

    fn key_build(&self, args: &args::KeyBuild<'_>) -> Result<String, Refusal> {
        use args::KeyKind::{Command, CommandGlob, FleetGlob, Observation, Rpc, Sensor, SensorGlob, SessionGlob};

        let keys = Keys::new(args.realm.as_deref())?;
        let name = args.name.as_deref();
        Ok(match args.key {
            Rpc => match &args.verb {
                Some(verb) => keys.rpc_verb(verb_in(verb)?)?,
                None => keys.rpc()?,
            },
            Sensor => keys.sensor(args.session()?, name)?,
            Command => keys.command(args.session()?, name)?,
            Observation => keys.observation(args.session()?)?,
            SensorGlob => keys.sensor_glob(args.session()?)?,
            CommandGlob => keys.command_glob(args.session()?)?,
            SessionGlob => keys.session_glob(args.session()?)?,
            FleetGlob => keys.fleet_glob()?,
        })
    }

    fn key_match(&self, args: &args::KeyMatch<'_>) -> Result<bool, Refusal> {
        Ok(keys::matches(&args.pattern, &args.key)?)
    }

    fn plane_qos(&self, args: &args::PlaneQos<'_>) -> Result<Qos<'_>, Refusal> {
        let qos = Plane::parse(&args.plane).ok_or_else(|| CallError::misfit("not a plane"))?.qos();
        let (congestion, priority) = (qos.congestion.as_str().into(), qos.priority.as_str().into());
        Ok(Qos { congestion, priority, express: qos.express })
    }

    fn bulk_decode(&self, block: &[u8]) -> Result<Vec<value::Column>, Refusal> {
        Ok(Block::parse(block)?.to_columns().into_iter().map(column_out).collect())
    }

    fn bulk_encode(&self, columns: Vec<value::Column>) -> Result<Vec<u8>, Refusal> {
        let columns: Vec<Column> = columns.into_iter().map(column_in).collect();
        Ok(bulk::encode(&columns)?)
    }

    fn observation_pack(&self, args: args::Arrays) -> Result<Vec<u8>, Refusal> {
        let (times, values) = (value::doubles(args.times), value::doubles(args.values));
        Ok(bulk::pack(&times, &values, &value::longs(args.senders))?)
    }

    fn observation_unpack(&self, block: &[u8]) -> Result<Arrays, Refusal> {
        let (times, values, senders) = bulk::unpack(block)?;
        Ok(Arrays {
            times: times.into_iter().map(Double).collect(),
            values: values.into_iter().map(Double).collect(),
            senders: senders.into_iter().map(Long).collect(),
        })
    }

    fn reply_check(&self, args: &args::ReplyCheck<'_>) -> Result<(), Refusal> {
        // The client sent this request, so it is one: only the reply is on trial.
        let request = wire::decode_any(args.request.as_bytes())
            .map_err(|error| CallError::misfit(format_args!("the request: {error}")))?;
        if args.strict {
            reply::check_reply_strict(&request, args.reply.as_bytes())?;
        } else {
            reply::check_reply(&request, args.reply.as_bytes())?;
        }
        Ok(())
    }

    fn governor_run(&self, args: &args::Governor<'_>) -> Result<Vec<StepReply>, Refusal> {
        traces::governor_run(args)
    }

    fn watchdog_run(&self, args: &args::Watchdog<'_>) -> Result<Vec<StepReply>, Refusal> {
        traces::watchdog_run(args)
    }

    fn buffer_run(&self, args: &args::Buffer<'_>) -> Result<Vec<StepReply>, Refusal> {
        traces::buffer_run(args)
    }

    fn horizon_max_len(&self, args: &args::Horizon) -> Result<usize, Refusal> {
        Ok(traces::horizon_max_len(args))
    }

    fn link_run(&self, args: &args::Link<'_>) -> Result<Vec<StepReply>, Refusal> {
        traces::link_run(args)
    }

    fn codec_encode(&self, args: &args::CodecEncode<'_>) -> Result<Fields, Refusal> {
        traces::codec_encode(args)
    }

    fn codec_decode(&self, args: &args::CodecDecode<'_>) -> Result<Fields, Refusal> {
        traces::codec_decode(args)
    }

    fn reflex_step(&self, args: &args::Reflex<'_>) -> Result<Fields, Refusal> {
        traces::reflex_step(args)
    }

    fn loop_run(&self, args: &args::Loop<'_>) -> Result<Vec<StepReply>, Refusal> {
        traces::loop_run(args)
    }

    fn session_run(&self, args: &args::Session<'_>) -> Result<Vec<String>, Refusal> {
        traces::session_run(args)
    }
}

/// The kind of this name. One that NCP does not have cannot even be named to [`Keys::rpc_verb`].
fn verb_in(name: &str) -> Result<Kind, Refusal> {
    Kind::parse(name).ok_or_else(|| Refusal::new(ErrorCode::Key, format_args!("{name:?} is not a kind")))
}

fn column_in(value::Column { name, data }: value::Column) -> Column {
    let data = match data {
        value::Data::F32(values) => ColumnData::F32(values),
        value::Data::F64(values) => ColumnData::F64(values),
        value::Data::I32(values) => ColumnData::I32(values),
        value::Data::I64(values) => ColumnData::I64(values),
    };
    Column::new(name, data)
}

fn column_out(Column { name, data, .. }: Column) -> value::Column {
    let data = match data {
        ColumnData::F32(values) => value::Data::F32(values),
        ColumnData::F64(values) => value::Data::F64(values),
        ColumnData::I32(values) => value::Data::I32(values),
        ColumnData::I64(values) => value::Data::I64(values),
    };
    value::Column { name, data }
}
