//! The 14 functions that every C build of NCP exports, unchanged.
//!
//! JSON goes in and out as it is on the wire. Strings that are returned belong to the caller, who frees
//! them with `ncp_string_free`; NULL is an error.

use std::ffi::c_char;

use ncp_spec::contract::{self, ContractStatus};
use ncp_spec::keys::{DEFAULT_REALM, Keys};
use ncp_spec::safety::SafetyGovernor;
use ncp_spec::version::check_version;
use ncp_spec::wire::{self, Frame as _, Kind, Mode};
use ncp_spec::{CONTRACT_HASH, ErrorCode, WIRE_VERSION};

use crate::abi::{Refusal, Text, entry, free_text, text_out, yes};
use crate::json;

/// The version of the wire, such as "1.2".
#[unsafe(no_mangle)]
pub extern "C" fn ncp_version() -> *mut c_char {
    entry(|| text_out(WIRE_VERSION))
}

/// The realm that a NULL realm stands for.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_default_realm() -> *mut c_char {
    entry(|| text_out(DEFAULT_REALM))
}

/// Whether a peer of this version can be talked to: 1 yes, 0 no, -1 error. With strict other than 0,
/// "no" is an error.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_check_version(version: Text<'_>, strict: i32) -> i32 {
    entry(|| {
        let version = version.required("version")?;
        Ok(yes(check_version(version, strict != 0)?))
    })
}

/// The hash of the contract that this library keeps.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_contract_hash() -> *mut c_char {
    entry(|| text_out(CONTRACT_HASH))
}

/// How a peer's hash relates to ours: 1 it matches, 0 it is not advertised (NULL), 2 it differs. -1 is a
/// hash that is not UTF-8.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_contract_status(peer_hash: Text<'_>) -> i32 {
    entry(|| {
        let hash = peer_hash.optional("peer_hash")?;
        Ok(status_code(contract::contract_status(hash)))
    })
}

/// The key of the control RPC.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_key_rpc(realm: Text<'_>) -> *mut c_char {
    entry(|| text_out(keys(realm)?.rpc()?))
}

/// The key of a session's sensor stream.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_key_sensor(realm: Text<'_>, session: Text<'_>) -> *mut c_char {
    entry(|| text_out(keys(realm)?.sensor(session.required("session")?, None)?))
}

/// The key of a session's command stream.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_key_command(realm: Text<'_>, session: Text<'_>) -> *mut c_char {
    entry(|| text_out(keys(realm)?.command(session.required("session")?, None)?))
}

/// The key of a session's observations.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_key_observation(realm: Text<'_>, session: Text<'_>) -> *mut c_char {
    entry(|| text_out(keys(realm)?.observation(session.required("session")?)?))
}

/// The rates in Hz by population, a JSON object, for a codec and a sensor_frame. For a sensor that is not
/// there, see ncp_codec_encode.
///
/// The codec is that of every NCP build: an object with encoder and decoder, arrays of mappings with population,
/// channel (of a decoder command_channel) and, if need be, component, value_range, rate_range_hz, unit; members
/// that are not known are ignored. Or it is one as ncp_codec_new takes it.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_encode_rates(codec: Text<'_>, sensor: Text<'_>) -> *mut c_char {
    entry(|| {
        let codec = json::codec(codec.required("codec")?)?;
        let sensor = json::received_sensor(sensor.required("sensor")?)?;
        text_out(json::rates_out(&codec.encode(Some(&sensor)))?)
    })
}

/// The command_frame for a codec and rates. A NULL frame_id is "world", a NULL mode "active"; a mode that
/// is not known, or not UTF-8, is an error.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_decode_command(
    codec: Text<'_>,
    rates: Text<'_>,
    t: f64,
    seq: i64,
    frame_id: Text<'_>,
    mode: Text<'_>,
) -> *mut c_char {
    entry(|| {
        let codec = json::codec(codec.required("codec")?)?;
        let rates = json::rates(rates.required("rates")?)?;
        let (frame_id, mode) = stamp(frame_id, mode)?;
        text_out(codec.decode(&rates, t, seq, frame_id, mode).encode()?)
    })
}

/// What may be sent of a command_frame, under limits, at now_s, in the light of a sensor_frame (or NULL)
/// that was received at last_sensor_s (negative: none yet), both in seconds on one clock. The decision
/// stands alone; a latch needs ncp_governor. On NULL send nothing, so that the plant holds.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_govern(
    limits: Text<'_>,
    command: Text<'_>,
    now_s: f64,
    sensor: Text<'_>,
    last_sensor_s: f64,
) -> *mut c_char {
    entry(|| {
        let mut governor = SafetyGovernor::new(&json::limits(limits.required("limits")?)?);
        let mut command = json::received_command(command.required("command")?)?;
        let sensor = sensor.optional("sensor")?.map(json::received_sensor);
        let sensor = sensor.transpose()?;
        // Not `>= 0`: a NaN is a time that was read, and stale.
        let last_sensor_s = if last_sensor_s < 0.0 { None } else { Some(last_sensor_s) };
        governor.govern(&mut command, now_s, sensor.as_ref(), last_sensor_s);
        text_out(command.encode()?)
    })
}

/// Reads a frame of one kind as strictly as the wire does, and writes it again with every field. NULL is a
/// frame that is rejected. For a frame that may hold a NUL, as one from a network, use ncp_decode.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_validate(kind: Text<'_>, json: Text<'_>) -> *mut c_char {
    entry(|| {
        let kind = kind_of(kind)?;
        let message = wire::decode(kind, json.required("json")?.as_bytes())?;
        text_out(message.encode()?)
    })
}

/// Frees a string that this library returned. NULL is nothing.
///
/// # Safety
/// The string came from this library, and is not used again.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ncp_string_free(string: *mut c_char) {
    entry(|| {
        // SAFETY: as this function demands.
        unsafe { free_text(string) };
        Ok(())
    });
}

/// The code of a status, as `ncp_contract_status` gives it.
pub(crate) const fn status_code(status: ContractStatus) -> i32 {
    match status {
        ContractStatus::Match => 1,
        ContractStatus::NotAdvertised => 0,
        ContractStatus::Mismatch => 2,
    }
}

/// The kind of this name.
pub(crate) fn kind_of(kind: Text<'_>) -> Result<Kind, Refusal> {
    let name = kind.required("kind")?;
    Kind::parse(name).ok_or_else(|| Refusal::new(ErrorCode::Kind, format_args!("{name:?} is not a kind")))
}

/// The frame and the mode that a command is to have, with the seed's defaults for NULL.
pub(crate) fn stamp(frame_id: Text<'_>, mode: Text<'_>) -> Result<(String, Mode), Refusal> {
    let frame_id = frame_id.optional("frame_id")?.unwrap_or("world");
    let mode = match mode.optional("mode")? {
        None => Mode::Active,
        Some(name) => {
            Mode::parse(name).ok_or_else(|| Refusal::new(ErrorCode::Value, format_args!("{name:?} is not a mode")))?
        }
    };
    Ok((frame_id.to_owned(), mode))
}

fn keys(realm: Text<'_>) -> Result<Keys, Refusal> {
    Ok(Keys::new(realm.optional("realm")?)?)
}
