//! Beyond the seed: frames, identity, keys, planes, replies. What a peer sent comes with its length,
//! since it may hold a NUL.

use std::ffi::c_char;
use std::mem::MaybeUninit;

use ncp_spec::contract;
use ncp_spec::keys::{self, Keys};
use ncp_spec::plane::{Plane, Qos};
use ncp_spec::version::check_version;
use ncp_spec::{ErrorCode, reply, wire};

use crate::abi::{Refusal, Text, bytes, entry, required, sized, text_out, yes};
use crate::seed::{kind_of, status_code};

/// The version of the functions that this library offers beyond the 14 of every NCP build: 1. A program
/// that loads a library at run time asks for it before it uses them.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_extension_version() -> i32 {
    entry(|| Ok(1))
}

/// The version of this library itself.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_library_version() -> *mut c_char {
    entry(|| text_out(env!("CARGO_PKG_VERSION")))
}

/// Like ncp_check_version, for a version that a peer sent.
///
/// # Safety
/// The version has that many bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ncp_check_version_n(version: *const c_char, version_len: usize, strict: i32) -> i32 {
    entry(|| {
        // SAFETY: as this function demands.
        let version = unsafe { sized(version, version_len, "version")? };
        let version = required(version, "version")?;
        Ok(yes(check_version(version, strict != 0)?))
    })
}

/// Like ncp_contract_status, for a hash that a peer sent. NULL of length 0: it sent none.
///
/// # Safety
/// The hash has that many bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ncp_contract_status_n(hash: *const c_char, hash_len: usize) -> i32 {
    entry(|| {
        // SAFETY: as this function demands.
        let hash = unsafe { sized(hash, hash_len, "hash")? };
        Ok(status_code(contract::contract_status(hash)))
    })
}

/// The strict opt-in: 1 if the peer's hash is ours, -1 if not or if there is none.
///
/// # Safety
/// The hash has that many bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ncp_verify_contract(hash: *const c_char, hash_len: usize) -> i32 {
    entry(|| {
        // SAFETY: as this function demands.
        let hash = unsafe { sized(hash, hash_len, "hash")? };
        contract::verify_contract(hash)?;
        Ok(1)
    })
}

/// The version gate, then the status of the contract: 1, 0 or 2 as ncp_contract_status; -1 if the version
/// is refused.
///
/// # Safety
/// The version and the hash have that many bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ncp_negotiate(
    version: *const c_char,
    version_len: usize,
    hash: *const c_char,
    hash_len: usize,
) -> i32 {
    entry(|| {
        // SAFETY: as this function demands.
        let (version, hash) = unsafe { (sized(version, version_len, "version")?, sized(hash, hash_len, "hash")?) };
        let version = required(version, "version")?;
        Ok(status_code(contract::negotiate(version, hash)?))
    })
}

/// Reads a frame of one kind, as strictly as the wire does, and writes it again with every field. NULL is a
/// frame that is rejected; an empty string one that was read, but that no frame can hold.
///
/// # Safety
/// The frame has that many bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ncp_decode(kind: Text<'_>, frame: *const u8, frame_len: usize) -> *mut c_char {
    entry(|| {
        // SAFETY: as this function demands.
        let frame = unsafe { bytes(frame, frame_len, "frame")? };
        let message = wire::decode(kind_of(kind)?, frame)?;
        text_out(message.encode().unwrap_or_default())
    })
}

/// Writes the frame of this kind whose fields a program set: a JSON object, named and nested as on the
/// wire. A field that is left out has the default of a program, so the mode of a command is "active".
/// NULL is a message that no frame can hold.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_encode(kind: Text<'_>, fields: Text<'_>) -> *mut c_char {
    entry(|| {
        let fields = fields.required("fields")?;
        text_out(wire::build(kind_of(kind)?, fields.as_bytes())?.encode()?)
    })
}

/// All fields of a message of which a program set some, as in ncp_encode, but unchecked: a number that JSON
/// lacks may stand there as "NaN", "Infinity" or "-Infinity".
#[unsafe(no_mangle)]
pub extern "C" fn ncp_build(kind: Text<'_>, fields: Text<'_>) -> *mut c_char {
    entry(|| {
        let fields = fields.required("fields")?;
        text_out(wire::build(kind_of(kind)?, fields.as_bytes())?.fields())
    })
}

/// What a client does with a reply: 1 it is accepted, -1 it does not fit the request, or reports a failure.
///
/// # Safety
/// The request and the reply have that many bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ncp_check_reply(
    request: *const u8,
    request_len: usize,
    reply: *const u8,
    reply_len: usize,
) -> i32 {
    entry(|| {
        // SAFETY: as this function demands.
        let (request, reply) = unsafe { (bytes(request, request_len, "request")?, bytes(reply, reply_len, "reply")?) };
        let request = wire::decode_any(request).map_err(|error| {
            // It is the caller's own, so that the reply was never judged.
            Refusal::new(ErrorCode::Internal, format_args!("the request: {error}"))
        })?;
        reply::check_reply(&request, reply)?;
        Ok(1)
    })
}

/// A key or key expression: rpc, sensor, command, observation, sensor_glob, command_glob, session_glob,
/// fleet_glob. A NULL realm is the default one. rpc and fleet_glob have no session; sensor and command may
/// have a name.
///
/// # Safety
/// The texts have that many bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ncp_key(
    key: Text<'_>,
    realm: *const c_char,
    realm_len: usize,
    session: *const c_char,
    session_len: usize,
    name: *const c_char,
    name_len: usize,
) -> *mut c_char {
    entry(|| {
        // SAFETY: as this function demands.
        let (realm, session, name) = unsafe {
            (sized(realm, realm_len, "realm")?, sized(session, session_len, "session")?, sized(name, name_len, "name")?)
        };
        let keys = Keys::new(realm)?;
        let session = || required(session, "session");
        text_out(match key.required("key")? {
            "rpc" => keys.rpc()?,
            "sensor" => keys.sensor(session()?, name)?,
            "command" => keys.command(session()?, name)?,
            "observation" => keys.observation(session()?)?,
            "sensor_glob" => keys.sensor_glob(session()?)?,
            "command_glob" => keys.command_glob(session()?)?,
            "session_glob" => keys.session_glob(session()?)?,
            "fleet_glob" => keys.fleet_glob()?,
            other => {
                let why = format_args!("{other:?} is not the name of a key");
                return Err(Refusal::new(ErrorCode::Invalid, why));
            }
        })
    })
}

/// Whether a key expression matches a key: 1 yes, 0 no, -1 if one of them is none.
///
/// # Safety
/// The texts have that many bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ncp_key_matches(
    pattern: *const c_char,
    pattern_len: usize,
    key: *const c_char,
    key_len: usize,
) -> i32 {
    entry(|| {
        // SAFETY: as this function demands.
        let (pattern, key) = unsafe { (sized(pattern, pattern_len, "pattern")?, sized(key, key_len, "key")?) };
        let (pattern, key) = (required(pattern, "pattern")?, required(key, "key")?);
        Ok(yes(keys::matches(pattern, key)?))
    })
}

/// How a plane is sent. The texts live as long as the program.
#[repr(C)]
pub struct PlaneQos {
    /// "block" or "drop".
    pub congestion: *const c_char,
    /// "Data", "DataHigh" or "RealTime".
    pub priority: *const c_char,
    /// Whether messages are sent at once, without batching.
    pub express: bool,
}

/// How a plane is sent: control (the RPC), perception, action, observation. 1, or -1 for another name.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_plane_qos(plane: Text<'_>, qos: Option<&mut MaybeUninit<PlaneQos>>) -> i32 {
    entry(|| {
        let (name, out) = (plane.required("plane")?, required(qos, "qos")?);
        let unknown = || Refusal::new(ErrorCode::Invalid, format_args!("{name:?} is not a plane"));
        let Qos { congestion, priority, express } = Plane::parse(name).ok_or_else(unknown)?.qos();
        out.write(PlaneQos { congestion: word(congestion.as_str())?, priority: word(priority.as_str())?, express });
        Ok(1)
    })
}

/// A word of the specification as a C string.
fn word(word: &'static str) -> Result<*const c_char, Refusal> {
    [c"block", c"drop", c"Data", c"DataHigh", c"RealTime"]
        .into_iter()
        .find(|known| known.to_bytes() == word.as_bytes())
        .map(|known| known.as_ptr())
        .ok_or_else(|| Refusal::new(ErrorCode::Internal, format_args!("{word:?} has no C string")))
}
