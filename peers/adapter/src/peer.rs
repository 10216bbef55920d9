//! The calls: what an adapter implements, and how a request finds it.

use crate::args::{self, parse};
use crate::error::CallError;
use crate::json::Raw;
use crate::reply::{Arrays, Description, Qos, Reply, StepReply};
use crate::value::{Bytes, Column, Fields};

/// An implementation of NCP, a method a call. PROTOCOL.md says what each is about.
///
/// A method that is left out is answered as unsupported. One that refuses names the code of its reason; a panic is
/// answered as `internal`.
#[expect(clippy::missing_errors_doc, reason = "PROTOCOL.md says with each call when it is refused")]
pub trait Peer {
    /// Why the implementation refuses: [`CallError`], or an own type that `?` makes of the implementation's errors.
    type Error: From<CallError> + Into<CallError>;

    /// `describe`: what the peer says about itself.
    fn describe(&self) -> Result<Description<'_>, Self::Error>;

    /// `decode`: what the encoder writes for the frame that was read, or `None` if the encoder refuses it.
    fn decode(&self, _: &args::Decode<'_>) -> Result<Option<String>, Self::Error> {
        unsupported()
    }

    /// `encode`: the frame.
    fn encode(&self, _: &args::Encode<'_>) -> Result<String, Self::Error> {
        unsupported()
    }

    /// `version.check`: whether the versions are compatible.
    fn version_check(&self, _: &args::VersionCheck<'_>) -> Result<bool, Self::Error> {
        unsupported()
    }

    /// `contract.status`: the name of the status.
    fn contract_status(&self, _: &args::Contract<'_>) -> Result<&'static str, Self::Error> {
        unsupported()
    }

    /// `contract.verify`: the hash is accepted.
    fn contract_verify(&self, _: &args::Contract<'_>) -> Result<(), Self::Error> {
        unsupported()
    }

    /// `negotiate`: the name of the contract's status.
    fn negotiate(&self, _: &args::Negotiate<'_>) -> Result<&'static str, Self::Error> {
        unsupported()
    }

    /// `key.build`: the key.
    fn key_build(&self, _: &args::KeyBuild<'_>) -> Result<String, Self::Error> {
        unsupported()
    }

    /// `key.match`: whether the pattern matches the key.
    fn key_match(&self, _: &args::KeyMatch<'_>) -> Result<bool, Self::Error> {
        unsupported()
    }

    /// `plane.qos`: how the plane is sent.
    fn plane_qos(&self, _: &args::PlaneQos<'_>) -> Result<Qos<'_>, Self::Error> {
        unsupported()
    }

    /// `bulk.decode`: the columns of the block.
    fn bulk_decode(&self, _: &[u8]) -> Result<Vec<Column>, Self::Error> {
        unsupported()
    }

    /// `bulk.encode`: the block of the columns.
    fn bulk_encode(&self, _: Vec<Column>) -> Result<Vec<u8>, Self::Error> {
        unsupported()
    }

    /// `observation.pack`: the block of the arrays.
    fn observation_pack(&self, _: args::Arrays) -> Result<Vec<u8>, Self::Error> {
        unsupported()
    }

    /// `observation.unpack`: the arrays of the block.
    fn observation_unpack(&self, _: &[u8]) -> Result<Arrays, Self::Error> {
        unsupported()
    }

    /// `reply.check`: the reply is accepted.
    fn reply_check(&self, _: &args::ReplyCheck<'_>) -> Result<(), Self::Error> {
        unsupported()
    }

    /// `governor.run`: an entry a step.
    fn governor_run(&self, _: &args::Governor<'_>) -> Result<Vec<StepReply>, Self::Error> {
        unsupported()
    }

    /// `watchdog.run`: an entry a step.
    fn watchdog_run(&self, _: &args::Watchdog<'_>) -> Result<Vec<StepReply>, Self::Error> {
        unsupported()
    }

    /// `buffer.run`: an entry a step.
    fn buffer_run(&self, _: &args::Buffer<'_>) -> Result<Vec<StepReply>, Self::Error> {
        unsupported()
    }

    /// `horizon.max_len`: the most steps of a horizon.
    fn horizon_max_len(&self, _: &args::Horizon) -> Result<usize, Self::Error> {
        unsupported()
    }

    /// `link.run`: an entry a step.
    fn link_run(&self, _: &args::Link<'_>) -> Result<Vec<StepReply>, Self::Error> {
        unsupported()
    }

    /// `codec.encode`: the rates, a double a population.
    fn codec_encode(&self, _: &args::CodecEncode<'_>) -> Result<Fields, Self::Error> {
        unsupported()
    }

    /// `codec.decode`: the fields of the command.
    fn codec_decode(&self, _: &args::CodecDecode<'_>) -> Result<Fields, Self::Error> {
        unsupported()
    }

    /// `reflex.step`: the fields of the command.
    fn reflex_step(&self, _: &args::Reflex<'_>) -> Result<Fields, Self::Error> {
        unsupported()
    }

    /// `loop.run`: an entry a step.
    fn loop_run(&self, _: &args::Loop<'_>) -> Result<Vec<StepReply>, Self::Error> {
        unsupported()
    }

    /// `session.run`: a reply a request.
    fn session_run(&self, _: &args::Session<'_>) -> Result<Vec<String>, Self::Error> {
        unsupported()
    }
}

fn unsupported<T, E: From<CallError>>() -> Result<T, E> {
    Err(CallError::Unsupported.into())
}

/// Carries out the call of this name.
///
/// # Errors
/// The refusal of the peer; [`CallError::Unsupported`] for a name that is none of the calls; `internal` for arguments
/// that PROTOCOL.md does not allow.
pub(crate) fn answer<'p, P: Peer>(peer: &'p P, call: &str, args: Raw<'_>) -> Result<Reply<'p>, CallError> {
    carried_out(peer, call, args).map_err(P::Error::into)
}

fn carried_out<'p, P: Peer>(peer: &'p P, call: &str, args: Raw<'_>) -> Result<Reply<'p>, P::Error> {
    let steps = |steps| Reply::Steps { steps };
    let block = |block| Reply::Block { block: Bytes(block) };
    let command = |command| Reply::Command { command };
    let nothing = |()| Reply::Nothing {};
    match call {
        "describe" => peer.describe().map(Reply::Description),
        "decode" => {
            let text = peer.decode(&parse(args)?)?;
            Ok(text.map_or(Reply::Nothing {}, |text| Reply::Frame { text }))
        }
        "encode" => peer.encode(&parse(args)?).map(|text| Reply::Frame { text }),
        "version.check" => peer.version_check(&parse(args)?).map(|compatible| Reply::Compatible { compatible }),
        "contract.status" => peer.contract_status(&parse(args)?).map(|status| Reply::Status { status }),
        "contract.verify" => peer.contract_verify(&parse(args)?).map(nothing),
        "negotiate" => peer.negotiate(&parse(args)?).map(|contract| Reply::Negotiated { contract }),
        "key.build" => peer.key_build(&parse(args)?).map(|key| Reply::Key { key }),
        "key.match" => peer.key_match(&parse(args)?).map(|matches| Reply::Matches { matches }),
        "plane.qos" => peer.plane_qos(&parse(args)?).map(Reply::Qos),
        "bulk.decode" => {
            let args::Block { block: Bytes(block) } = parse(args)?;
            peer.bulk_decode(&block).map(|columns| Reply::Columns { columns })
        }
        "bulk.encode" => {
            let args::Columns { columns } = parse(args)?;
            peer.bulk_encode(columns).map(block)
        }
        "observation.pack" => peer.observation_pack(parse(args)?).map(block),
        "observation.unpack" => {
            let args::Block { block: Bytes(block) } = parse(args)?;
            peer.observation_unpack(&block).map(Reply::Arrays)
        }
        "reply.check" => peer.reply_check(&parse(args)?).map(nothing),
        "governor.run" => peer.governor_run(&parse(args)?).map(steps),
        "watchdog.run" => peer.watchdog_run(&parse(args)?).map(steps),
        "buffer.run" => peer.buffer_run(&parse(args)?).map(steps),
        "horizon.max_len" => peer.horizon_max_len(&parse(args)?).map(|len| Reply::Len { len }),
        "link.run" => peer.link_run(&parse(args)?).map(steps),
        "codec.encode" => peer.codec_encode(&parse(args)?).map(|rates| Reply::Rates { rates }),
        "codec.decode" => peer.codec_decode(&parse(args)?).map(command),
        "reflex.step" => peer.reflex_step(&parse(args)?).map(command),
        "loop.run" => peer.loop_run(&parse(args)?).map(steps),
        "session.run" => peer.session_run(&parse(args)?).map(|replies| Reply::Replies { replies }),
        _ => unsupported(),
    }
}
