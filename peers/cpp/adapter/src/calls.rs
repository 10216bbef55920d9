//! The calls (PROTOCOL.md, section 3): one method each, named after its call. Those with a trace are in
//! [`traces`].

use ncp_adapter::reply::{Arrays, Description, Qos, StepReply};
use ncp_adapter::value::{self, Column, Double, Fields, Long};
use ncp_adapter::{CallError, args};

use crate::library::{Library, yes};
use crate::{seed, traces};

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

/// The roles, each with the functions of which one shows that a library is meant to play it.
const ROLES: [(&str, &[&str]); 4] = [
    ("commander", &["govern", "governor_new"]),
    ("body", &["buffer_new", "watchdog_new"]),
    ("server", &["service_new"]),
    ("observer", &["validate", "decode"]),
];

impl ncp_adapter::Peer for Peer<'_> {
    type Error = CallError;

    fn describe(&self) -> Result<Description<'_>, CallError> {
        let library = self.library;
        let version = if library.extended { library.constant("library_version")? } else { "unknown".to_owned() };
        Ok(Description {
            name: self.name.into(),
            version: version.into(),
            language: self.language.into(),
            wire_version: library.constant("version")?.into(),
            contract_hash: library.constant("contract_hash")?.into(),
            roles: match self.roles {
                Some(roles) => roles.split(',').map(|role| role.trim().into()).collect(),
                None => ROLES
                    .iter()
                    .filter(|(_, functions)| functions.iter().any(|name| library.exports(name)))
                    .map(|(role, _)| (*role).into())
                    .collect(),
            },
            reference_networks: self.reference_networks,
        })
    }

    fn decode(&self, args: &args::Decode<'_>) -> Result<Option<String>, CallError> {
        let frame = args.frame()?;
        if self.library.extended {
            let text = self.library.decode(&args.kind, frame)?;
            // Nothing is the frame that was read, but that none can hold.
            return Ok(Some(text).filter(|text| !text.is_empty()));
        }
        self.library.validate(seed::kind(&args.kind)?, frame).map(Some)
    }

    fn encode(&self, args: &args::Encode<'_>) -> Result<String, CallError> {
        if self.library.extended {
            return self.library.encode(&args.kind, args.fields.get());
        }
        // The seed has a function from JSON to JSON (PROTOCOL.md, `encode`).
        let kind = seed::kind(&args.kind)?;
        self.library.validate(kind, seed::frame(self.library, kind, args.fields)?.as_bytes())
    }

    fn version_check(&self, args: &args::VersionCheck<'_>) -> Result<bool, CallError> {
        yes(self.library.check_version(&args.version, args.strict)?)
    }

    fn contract_status(&self, args: &args::Contract<'_>) -> Result<&'static str, CallError> {
        status(self.library.contract_status(args.peer_hash.as_deref())?)
    }

    fn contract_verify(&self, args: &args::Contract<'_>) -> Result<(), CallError> {
        self.library.verify_contract(args.peer_hash.as_deref()).map(drop)
    }

    fn negotiate(&self, args: &args::Negotiate<'_>) -> Result<&'static str, CallError> {
        status(self.library.negotiate(&args.version, args.contract_hash.as_deref())?)
    }

    fn key_build(&self, args: &args::KeyBuild<'_>) -> Result<String, CallError> {
        let (key, realm, session) = (args.key.as_str(), args.realm.as_deref(), args.session.as_deref());
        match args.name.as_deref() {
            name if self.library.extended => self.library.key(key, realm, session, name),
            Some(_) => Err(CallError::Unsupported),
            None => self.library.seed_key(key, realm, session),
        }
    }

    fn key_match(&self, args: &args::KeyMatch<'_>) -> Result<bool, CallError> {
        yes(self.library.key_matches(&args.pattern, &args.key)?)
    }

    fn plane_qos(&self, args: &args::PlaneQos<'_>) -> Result<Qos<'_>, CallError> {
        let (congestion, priority, express) = self.library.plane_qos(&args.plane)?;
        Ok(Qos { congestion: congestion.into(), priority: priority.into(), express })
    }

    fn bulk_decode(&self, block: &[u8]) -> Result<Vec<Column>, CallError> {
        self.library.block_columns(block)
    }

    fn bulk_encode(&self, columns: Vec<Column>) -> Result<Vec<u8>, CallError> {
        self.library.block_encode(&columns)
    }

    fn observation_pack(&self, args: args::Arrays) -> Result<Vec<u8>, CallError> {
        let (times, values) = (value::doubles(args.times), value::doubles(args.values));
        self.library.observation_pack(&times, &values, &value::longs(args.senders))
    }

    fn observation_unpack(&self, block: &[u8]) -> Result<Arrays, CallError> {
        let (times, values, senders) = self.library.observation_unpack(block)?;
        Ok(Arrays {
            times: times.into_iter().map(Double).collect(),
            values: values.into_iter().map(Double).collect(),
            senders: senders.into_iter().map(Long).collect(),
        })
    }

    fn reply_check(&self, args: &args::ReplyCheck<'_>) -> Result<(), CallError> {
        self.library.check_reply(&args.request, &args.reply).map(drop)
    }

    fn governor_run(&self, args: &args::Governor<'_>) -> Result<Vec<StepReply>, CallError> {
        traces::governor_run(self.library, args)
    }

    fn watchdog_run(&self, args: &args::Watchdog<'_>) -> Result<Vec<StepReply>, CallError> {
        traces::watchdog_run(self.library, args)
    }

    fn buffer_run(&self, args: &args::Buffer<'_>) -> Result<Vec<StepReply>, CallError> {
        traces::buffer_run(self.library, args)
    }

    fn horizon_max_len(&self, args: &args::Horizon) -> Result<usize, CallError> {
        self.library.max_horizon_len(args.ttl_ms.0, args.dt_ms.0)
    }

    fn link_run(&self, args: &args::Link<'_>) -> Result<Vec<StepReply>, CallError> {
        traces::link_run(self.library, args)
    }

    fn codec_encode(&self, args: &args::CodecEncode<'_>) -> Result<Fields, CallError> {
        traces::codec_encode(self.library, args)
    }

    fn codec_decode(&self, args: &args::CodecDecode<'_>) -> Result<Fields, CallError> {
        traces::codec_decode(self.library, args)
    }

    fn reflex_step(&self, args: &args::Reflex<'_>) -> Result<Fields, CallError> {
        traces::reflex_step(self.library, args)
    }

    fn loop_run(&self, args: &args::Loop<'_>) -> Result<Vec<StepReply>, CallError> {
        traces::loop_run(self.library, args)
    }

    fn session_run(&self, args: &args::Session<'_>) -> Result<Vec<String>, CallError> {
        traces::session_run(self.library, args)
    }
}

fn status(code: i32) -> Result<&'static str, CallError> {
    match code {
        1 => Ok("match"),
        0 => Ok("not_advertised"),
        2 => Ok("mismatch"),
        _ => Err(CallError::internal(format_args!("the library returned the status {code}"))),
    }
}
