//! The library: its functions by name, and what they hand over.

#![expect(unsafe_code, reason = "a function of a library is what its header says, and nothing can check that")]
#![warn(clippy::undocumented_unsafe_blocks)]

use std::ffi::{CStr, CString, c_char, c_void};
use std::path::{Path, PathBuf};
use std::ptr::{NonNull, null};

use ncp_adapter::CallError;
use ncp_adapter::value::{Column, Data};

/// The version of the functions beyond the seed that this adapter knows.
const EXTENSION: i32 = 1;

/// A loaded library.
pub(crate) struct Library {
    library: libloading::Library,
    prefix: String,
    /// Whether it says that it offers more than the seed's functions. Only then are those looked for: in
    /// another library, the same name may be another function.
    pub(crate) extended: bool,
}

/// Why a library cannot be put under test.
#[derive(Debug, thiserror::Error)]
pub(crate) enum LoadError {
    #[error("cannot load {}: {source}", path.display())]
    Load { path: PathBuf, source: libloading::Error },
    #[error("{} exports no {name}: is it a build of NCP?", path.display())]
    Foreign { path: PathBuf, name: String },
}

impl Library {
    /// Loads the library whose functions' names begin with `prefix`.
    ///
    /// # Errors
    /// It cannot be loaded, or cannot free its strings.
    pub(crate) fn load(path: &Path, prefix: &str) -> Result<Self, LoadError> {
        // SAFETY: its initialisers run, as those of any library under test.
        let library = unsafe { libloading::Library::new(path) }
            .map_err(|source| LoadError::Load { path: path.to_owned(), source })?;
        let mut library = Self { library, prefix: prefix.to_owned(), extended: false };
        if !library.exports("string_free") {
            return Err(LoadError::Foreign { path: path.to_owned(), name: format!("{prefix}string_free") });
        }
        let version = library.symbol::<unsafe extern "C" fn() -> i32>("extension_version");
        // SAFETY: the function of this name takes nothing and returns an integer.
        library.extended = version.is_some_and(|version| unsafe { version() } == EXTENSION);
        Ok(library)
    }

    /// Whether it exports a function of this name.
    pub(crate) fn exports(&self, name: &str) -> bool {
        self.symbol::<unsafe extern "C" fn()>(name).is_some()
    }

    /// One of the seed's functions. `F` has to be its type.
    fn seed<F: Copy>(&self, name: &str) -> Result<F, CallError> {
        self.symbol(name).ok_or(CallError::Unsupported)
    }

    /// One of the functions beyond the seed. `F` has to be its type.
    fn more<F: Copy>(&self, name: &str) -> Result<F, CallError> {
        if !self.extended {
            return Err(CallError::Unsupported);
        }
        self.seed(name)
    }

    fn symbol<F: Copy>(&self, name: &str) -> Option<F> {
        let name = format!("{}{name}", self.prefix);
        // SAFETY: whoever asks names the function's type as the header has it.
        let symbol = unsafe { self.library.get::<F>(name.as_bytes()) };
        symbol.ok().map(|symbol| *symbol)
    }

    /// Takes over a text that the library returned; null is its refusal.
    fn taken(&self, text: *mut c_char) -> Result<String, CallError> {
        let Some(text) = NonNull::new(text) else {
            return Err(self.refusal());
        };
        // SAFETY: what a function of the library returns is a C string, and is freed once.
        let bytes = unsafe { CStr::from_ptr(text.as_ptr()) }.to_bytes().to_vec();
        if let Some(free) = self.symbol::<unsafe extern "C" fn(*mut c_char)>("string_free") {
            // SAFETY: as above.
            unsafe { free(text.as_ptr()) };
        }
        String::from_utf8(bytes).map_err(|_| CallError::internal("the library returned a text that is not UTF-8"))
    }

    /// A return code: what the library says with it, or its refusal.
    pub(crate) fn code(&self, code: i32) -> Result<i32, CallError> {
        if code == -1 {
            return Err(self.refusal());
        }
        Ok(code)
    }

    /// Why the library refused, as far as it says.
    fn refusal(&self) -> CallError {
        let said = |name| {
            let function = self.more::<unsafe extern "C" fn() -> *const c_char>(name).ok()?;
            // SAFETY: it takes nothing, and lends a C string that is copied at once.
            let text = NonNull::new(unsafe { function() }.cast_mut())?;
            // SAFETY: as above.
            let text = unsafe { CStr::from_ptr(text.as_ptr()) };
            Some(text.to_string_lossy().into_owned())
        };
        CallError::refused(
            said("last_error_code").unwrap_or_else(|| "invalid".to_owned()),
            said("last_error").unwrap_or_else(|| "the library refused".to_owned()),
        )
    }
}

/// What the library says for yes or no.
pub(crate) fn yes(code: i32) -> Result<bool, CallError> {
    match code {
        0 => Ok(false),
        1 => Ok(true),
        _ => Err(CallError::internal(format_args!("the library returned {code} for yes or no"))),
    }
}

/// A text as C has it. One with a NUL has no such form, so that the call cannot be made.
pub(crate) fn c(text: &str) -> Result<CString, CallError> {
    CString::new(text).map_err(|_| CallError::Unsupported)
}

/// A C string or null.
fn or_null(text: Option<&CString>) -> *const c_char {
    text.map_or(null(), |text| text.as_ptr())
}

/// A sized text, or null and 0.
fn sized(text: Option<&str>) -> (*const c_char, usize) {
    text.map_or((null(), 0), |text| (text.as_ptr().cast(), text.len()))
}

/// A double, or null.
fn optional(double: Option<&f64>) -> *const f64 {
    double.map_or(null(), std::ptr::from_ref)
}

/// Calls a function of the library by its name and its C type.
macro_rules! call {
    ($library:expr, $which:ident $name:literal ($($value:expr => $type:ty),* $(,)?) -> $result:ty) => {{
        let function = $library.$which::<unsafe extern "C" fn($($type),*) -> $result>($name)?;
        // SAFETY: the type is that of the header, and what the pointers lend lives to the end of the call.
        unsafe { function($($value),*) }
    }};
}

/// The seed's 14 functions. A library that offers more is asked in the same words.
impl Library {
    /// A text that takes no argument: `version`, `contract_hash`, `default_realm`, `library_version`.
    pub(crate) fn constant(&self, name: &str) -> Result<String, CallError> {
        let function = self.seed::<unsafe extern "C" fn() -> *mut c_char>(name)?;
        // SAFETY: all functions of these names are of this type.
        self.taken(unsafe { function() })
    }

    pub(crate) fn check_version(&self, version: &str, strict: bool) -> Result<i32, CallError> {
        let strict = i32::from(strict);
        if self.extended {
            let (start, len) = sized(Some(version));
            let code = call!(self, more "check_version_n"
                (start => *const c_char, len => usize, strict => i32) -> i32);
            return self.code(code);
        }
        let version = c(version)?;
        let code = call!(self, seed "check_version"
            (version.as_ptr() => *const c_char, strict => i32) -> i32);
        self.code(code)
    }

    pub(crate) fn contract_status(&self, hash: Option<&str>) -> Result<i32, CallError> {
        if self.extended {
            let (start, len) = sized(hash);
            let code = call!(self, more "contract_status_n"
                (start => *const c_char, len => usize) -> i32);
            return self.code(code);
        }
        let hash = hash.map(c).transpose()?;
        let code = call!(self, seed "contract_status"
            (or_null(hash.as_ref()) => *const c_char) -> i32);
        self.code(code)
    }

    /// One of the four keys of the seed.
    pub(crate) fn seed_key(&self, key: &str, realm: Option<&str>, session: Option<&str>) -> Result<String, CallError> {
        let realm = realm.map(c).transpose()?;
        let session = session.map(c).transpose()?;
        let name = match key {
            "rpc" | "sensor" | "command" | "observation" => format!("key_{key}"),
            _ => return Err(CallError::Unsupported),
        };
        // To a function that takes a realm alone, the second argument is nothing.
        type Key = unsafe extern "C" fn(*const c_char, *const c_char) -> *mut c_char;
        let function = self.seed::<Key>(&name)?;
        // SAFETY: the type is that of the header, and both texts live to the end of the call.
        self.taken(unsafe { function(or_null(realm.as_ref()), or_null(session.as_ref())) })
    }

    pub(crate) fn encode_rates(&self, codec: &str, sensor: &str) -> Result<String, CallError> {
        let (codec, sensor) = (c(codec)?, c(sensor)?);
        self.taken(call!(self, seed "encode_rates"
            (codec.as_ptr() => *const c_char, sensor.as_ptr() => *const c_char) -> *mut c_char))
    }

    pub(crate) fn decode_command(&self, args: &Decode<'_>) -> Result<String, CallError> {
        let (codec, rates) = (c(args.codec)?, c(args.rates)?);
        let (frame_id, mode) = (c(args.frame_id)?, c(args.mode)?);
        self.taken(call!(self, seed "decode_command" (
            codec.as_ptr() => *const c_char,
            rates.as_ptr() => *const c_char,
            args.t => f64,
            args.seq => i64,
            frame_id.as_ptr() => *const c_char,
            mode.as_ptr() => *const c_char,
        ) -> *mut c_char))
    }

    pub(crate) fn govern(
        &self,
        limits: &str,
        command: &str,
        now_s: f64,
        sensor: Option<&str>,
        last_sensor_s: f64,
    ) -> Result<String, CallError> {
        let (limits, command) = (c(limits)?, c(command)?);
        let sensor = sensor.map(c).transpose()?;
        self.taken(call!(self, seed "govern" (
            limits.as_ptr() => *const c_char,
            command.as_ptr() => *const c_char,
            now_s => f64,
            or_null(sensor.as_ref()) => *const c_char,
            last_sensor_s => f64,
        ) -> *mut c_char))
    }

    /// `validate`, for a frame of any bytes but NUL.
    pub(crate) fn validate(&self, kind: &str, frame: &[u8]) -> Result<String, CallError> {
        let kind = c(kind)?;
        let frame = CString::new(frame).map_err(|_| CallError::Unsupported)?;
        self.taken(call!(self, seed "validate"
            (kind.as_ptr() => *const c_char, frame.as_ptr() => *const c_char) -> *mut c_char))
    }
}

/// The arguments of `decode_command`.
pub(crate) struct Decode<'a> {
    pub(crate) codec: &'a str,
    pub(crate) rates: &'a str,
    pub(crate) t: f64,
    pub(crate) seq: i64,
    pub(crate) frame_id: &'a str,
    pub(crate) mode: &'a str,
}

/// What a library may offer beyond the seed, without a state.
impl Library {
    pub(crate) fn verify_contract(&self, hash: Option<&str>) -> Result<i32, CallError> {
        let (start, len) = sized(hash);
        self.code(call!(self, more "verify_contract"
            (start => *const c_char, len => usize) -> i32))
    }

    pub(crate) fn negotiate(&self, version: &str, hash: Option<&str>) -> Result<i32, CallError> {
        let (version, version_len) = sized(Some(version));
        let (hash, hash_len) = sized(hash);
        self.code(call!(self, more "negotiate" (
            version => *const c_char, version_len => usize,
            hash => *const c_char, hash_len => usize,
        ) -> i32))
    }

    pub(crate) fn decode(&self, kind: &str, frame: &[u8]) -> Result<String, CallError> {
        let kind = c(kind)?;
        self.taken(call!(self, more "decode" (
            kind.as_ptr() => *const c_char, frame.as_ptr() => *const u8, frame.len() => usize,
        ) -> *mut c_char))
    }

    pub(crate) fn encode(&self, kind: &str, fields: &str) -> Result<String, CallError> {
        let (kind, fields) = (c(kind)?, c(fields)?);
        self.taken(call!(self, more "encode"
            (kind.as_ptr() => *const c_char, fields.as_ptr() => *const c_char) -> *mut c_char))
    }

    pub(crate) fn build(&self, kind: &str, fields: &str) -> Result<String, CallError> {
        let (kind, fields) = (c(kind)?, c(fields)?);
        self.taken(call!(self, more "build"
            (kind.as_ptr() => *const c_char, fields.as_ptr() => *const c_char) -> *mut c_char))
    }

    pub(crate) fn check_reply(&self, request: &str, reply: &str) -> Result<i32, CallError> {
        self.code(call!(self, more "check_reply" (
            request.as_ptr() => *const u8, request.len() => usize,
            reply.as_ptr() => *const u8, reply.len() => usize,
        ) -> i32))
    }

    pub(crate) fn key(
        &self,
        key: &str,
        realm: Option<&str>,
        session: Option<&str>,
        name: Option<&str>,
    ) -> Result<String, CallError> {
        let key = c(key)?;
        let (realm, realm_len) = sized(realm);
        let (session, session_len) = sized(session);
        let (name, name_len) = sized(name);
        self.taken(call!(self, more "key" (
            key.as_ptr() => *const c_char,
            realm => *const c_char, realm_len => usize,
            session => *const c_char, session_len => usize,
            name => *const c_char, name_len => usize,
        ) -> *mut c_char))
    }

    pub(crate) fn key_matches(&self, pattern: &str, key: &str) -> Result<i32, CallError> {
        let (pattern, pattern_len) = sized(Some(pattern));
        let (key, key_len) = sized(Some(key));
        self.code(call!(self, more "key_matches" (
            pattern => *const c_char, pattern_len => usize,
            key => *const c_char, key_len => usize,
        ) -> i32))
    }

    pub(crate) fn plane_qos(&self, plane: &str) -> Result<(String, String, bool), CallError> {
        #[repr(C)]
        struct PlaneQos {
            congestion: *const c_char,
            priority: *const c_char,
            express: bool,
        }

        let plane = c(plane)?;
        let mut qos = PlaneQos { congestion: null(), priority: null(), express: false };
        self.code(call!(self, more "plane_qos"
            (plane.as_ptr() => *const c_char, &raw mut qos => *mut PlaneQos) -> i32))?;
        let word = |text: *const c_char| {
            if text.is_null() {
                return Err(CallError::internal("the library left a word of the plane out"));
            }
            // SAFETY: the library put a lasting C string there.
            let text = unsafe { CStr::from_ptr(text) };
            Ok(text.to_string_lossy().into_owned())
        };
        Ok((word(qos.congestion)?, word(qos.priority)?, qos.express))
    }

    pub(crate) fn max_horizon_len(&self, ttl_ms: f64, dt_ms: f64) -> Result<usize, CallError> {
        Ok(call!(self, more "max_horizon_len" (ttl_ms => f64, dt_ms => f64) -> usize))
    }
}

/// A column, as `ncp.h` has it.
#[repr(C)]
struct RawColumn {
    name: *const c_char,
    name_len: usize,
    dtype: i32,
    rows: usize,
    data: *const c_void,
}

/// The three arrays of an observation.
pub(crate) type Arrays = (Vec<f64>, Vec<f64>, Vec<i64>);

/// Blocks.
impl Library {
    pub(crate) fn block_columns(&self, block: &[u8]) -> Result<Vec<Column>, CallError> {
        let view = call!(self, more "block_parse"
            (block.as_ptr() => *const u8, block.len() => usize) -> *mut c_void);
        let view = self.object(view, "block_free")?;
        let count = call!(self, more "block_columns" (view.pointer() => *mut c_void) -> usize);
        (0..count).map(|index| self.block_column(&view, index)).collect()
    }

    fn block_column(&self, view: &Object<'_>, index: usize) -> Result<Column, CallError> {
        let mut column = RawColumn { name: null(), name_len: 0, dtype: 0, rows: 0, data: null() };
        self.code(call!(self, more "block_column" (
            view.pointer() => *mut c_void, index => usize, &raw mut column => *mut RawColumn,
        ) -> i32))?;
        let size = if matches!(column.dtype, 1 | 3) { 4 } else { 8 };
        // SAFETY: the view lends as many bytes as it says, until it is freed.
        let (name, data) =
            unsafe { (lent(column.name.cast(), column.name_len), lent(column.data.cast(), column.rows * size)) };
        let Ok(name) = String::from_utf8(name.to_vec()) else {
            return Err(CallError::internal("the library lent a name that is not UTF-8"));
        };
        let data = match column.dtype {
            1 => Data::F32(values(data, f32::from_le_bytes)),
            2 => Data::F64(values(data, f64::from_le_bytes)),
            3 => Data::I32(values(data, i32::from_le_bytes)),
            4 => Data::I64(values(data, i64::from_le_bytes)),
            _ => return Err(CallError::internal("the library named a dtype that there is not")),
        };
        Ok(Column { name, data })
    }

    pub(crate) fn block_encode(&self, columns: &[Column]) -> Result<Vec<u8>, CallError> {
        let columns: Vec<RawColumn> = columns
            .iter()
            .map(|Column { name, data }| {
                let (dtype, rows, data): (_, _, *const c_void) = match data {
                    Data::F32(values) => (1, values.len(), values.as_ptr().cast()),
                    Data::F64(values) => (2, values.len(), values.as_ptr().cast()),
                    Data::I32(values) => (3, values.len(), values.as_ptr().cast()),
                    Data::I64(values) => (4, values.len(), values.as_ptr().cast()),
                };
                RawColumn { name: name.as_ptr().cast(), name_len: name.len(), dtype, rows, data }
            })
            .collect();
        let mut len = 0;
        let block = call!(self, more "block_encode" (
            columns.as_ptr() => *const RawColumn, columns.len() => usize, &raw mut len => *mut usize,
        ) -> *mut u8);
        self.taken_bytes(block, len)
    }

    pub(crate) fn observation_pack(
        &self,
        times: &[f64],
        values: &[f64],
        senders: &[i64],
    ) -> Result<Vec<u8>, CallError> {
        let mut len = 0;
        let block = call!(self, more "observation_pack" (
            times.as_ptr() => *const f64, times.len() => usize,
            values.as_ptr() => *const f64, values.len() => usize,
            senders.as_ptr() => *const i64, senders.len() => usize,
            &raw mut len => *mut usize,
        ) -> *mut u8);
        self.taken_bytes(block, len)
    }

    pub(crate) fn observation_unpack(&self, block: &[u8]) -> Result<Arrays, CallError> {
        let arrays = call!(self, more "observation_unpack"
            (block.as_ptr() => *const u8, block.len() => usize) -> *mut c_void);
        let arrays = self.object(arrays, "arrays_free")?;
        let (mut times, mut values, mut senders) = (0, 0, 0);
        let of = arrays.pointer();
        let first = call!(self, more "arrays_times"
            (of => *mut c_void, &raw mut times => *mut usize) -> *const f64);
        let second = call!(self, more "arrays_values"
            (of => *mut c_void, &raw mut values => *mut usize) -> *const f64);
        let third = call!(self, more "arrays_senders"
            (of => *mut c_void, &raw mut senders => *mut usize) -> *const i64);
        // SAFETY: the arrays lend as many values as they say, until they are freed.
        Ok(unsafe { (lent(first, times).to_vec(), lent(second, values).to_vec(), lent(third, senders).to_vec()) })
    }

    fn taken_bytes(&self, bytes: *mut u8, len: usize) -> Result<Vec<u8>, CallError> {
        if bytes.is_null() {
            return Err(self.refusal());
        }
        // SAFETY: the library wrote as many bytes as it says.
        let copy = unsafe { lent(bytes.cast_const(), len) }.to_vec();
        call!(self, more "bytes_free" (bytes => *mut u8, len => usize) -> ());
        Ok(copy)
    }
}

/// # Safety
/// If there are any, the pointer lends that many items for `'a`.
unsafe fn lent<'a, T>(items: *const T, count: usize) -> &'a [T] {
    if items.is_null() || count == 0 {
        return &[];
    }
    // SAFETY: the caller vouches for it.
    unsafe { std::slice::from_raw_parts(items, count) }
}

/// The values of little-endian bytes.
fn values<T, const N: usize>(bytes: &[u8], read: impl Fn([u8; N]) -> T) -> Vec<T> {
    let (values, _) = bytes.as_chunks::<N>();
    values.iter().map(|value| read(*value)).collect()
}

/// An object of the library, which is freed with its owner.
pub(crate) struct Object<'a> {
    library: &'a Library,
    pointer: NonNull<c_void>,
    free: &'static str,
}

impl Object<'_> {
    fn pointer(&self) -> *mut c_void {
        self.pointer.as_ptr()
    }
}

impl Drop for Object<'_> {
    fn drop(&mut self) {
        if let Ok(free) = self.library.more::<unsafe extern "C" fn(*mut c_void)>(self.free) {
            // SAFETY: the object is this library's, and is not used again.
            unsafe { free(self.pointer()) };
        }
    }
}

/// Report of a link, as `ncp.h` has it.
#[repr(C)]
#[derive(Default)]
pub(crate) struct LinkReport {
    pub(crate) last_seq: i64,
    pub(crate) received: i64,
    pub(crate) lost: i64,
    pub(crate) loss_rate: f64,
    pub(crate) burst: bool,
}

/// The objects. A step takes its object first.
impl Library {
    fn object(&self, pointer: *mut c_void, free: &'static str) -> Result<Object<'_>, CallError> {
        let pointer = NonNull::new(pointer).ok_or_else(|| self.refusal())?;
        Ok(Object { library: self, pointer, free })
    }

    pub(crate) fn governor(&self, limits: &str) -> Result<Object<'_>, CallError> {
        let limits = c(limits)?;
        let governor = call!(self, more "governor_new"
            (limits.as_ptr() => *const c_char) -> *mut c_void);
        self.object(governor, "governor_free")
    }

    pub(crate) fn governor_of(&self, capabilities: &str) -> Result<Object<'_>, CallError> {
        let capabilities = c(capabilities)?;
        let governor = call!(self, more "governor_from_capabilities"
            (capabilities.as_ptr() => *const c_char) -> *mut c_void);
        self.object(governor, "governor_free")
    }

    pub(crate) fn governor_govern(
        &self,
        governor: &Object<'_>,
        command: &str,
        now_s: f64,
        sensor: Option<&str>,
        last_sensor_s: Option<f64>,
    ) -> Result<String, CallError> {
        let command = c(command)?;
        let sensor = sensor.map(c).transpose()?;
        self.taken(call!(self, more "governor_govern" (
            governor.pointer() => *mut c_void,
            command.as_ptr() => *const c_char,
            now_s => f64,
            or_null(sensor.as_ref()) => *const c_char,
            optional(last_sensor_s.as_ref()) => *const f64,
        ) -> *mut c_char))
    }

    pub(crate) fn governor_note_link(&self, governor: &Object<'_>, burst: bool) -> Result<i32, CallError> {
        self.code(call!(self, more "governor_note_link"
            (governor.pointer() => *mut c_void, i32::from(burst) => i32) -> i32))
    }

    pub(crate) fn governor_reset(&self, governor: &Object<'_>) -> Result<i32, CallError> {
        self.code(call!(self, more "governor_reset" (governor.pointer() => *mut c_void) -> i32))
    }

    pub(crate) fn watchdog(&self) -> Result<Object<'_>, CallError> {
        let watchdog = call!(self, more "watchdog_new" () -> *mut c_void);
        self.object(watchdog, "watchdog_free")
    }

    pub(crate) fn watchdog_on_command(
        &self,
        watchdog: &Object<'_>,
        now_s: f64,
        ttl_ms: f64,
        seq: i64,
    ) -> Result<i32, CallError> {
        self.code(call!(self, more "watchdog_on_command" (
            watchdog.pointer() => *mut c_void, now_s => f64, ttl_ms => f64, seq => i64,
        ) -> i32))
    }

    pub(crate) fn watchdog_should_hold(&self, watchdog: &Object<'_>, now_s: f64) -> Result<i32, CallError> {
        self.code(call!(self, more "watchdog_should_hold"
            (watchdog.pointer() => *mut c_void, now_s => f64) -> i32))
    }

    pub(crate) fn watchdog_reset(&self, watchdog: &Object<'_>) -> Result<i32, CallError> {
        self.code(call!(self, more "watchdog_reset" (watchdog.pointer() => *mut c_void) -> i32))
    }

    pub(crate) fn buffer(&self) -> Result<Object<'_>, CallError> {
        let buffer = call!(self, more "buffer_new" () -> *mut c_void);
        self.object(buffer, "buffer_free")
    }

    pub(crate) fn buffer_on_frame(&self, buffer: &Object<'_>, frame: &[u8], now_s: f64) -> Result<i32, CallError> {
        self.code(call!(self, more "buffer_on_frame" (
            buffer.pointer() => *mut c_void,
            frame.as_ptr() => *const u8,
            frame.len() => usize,
            now_s => f64,
        ) -> i32))
    }

    pub(crate) fn buffer_active(&self, buffer: &Object<'_>, now_s: f64) -> Result<Option<String>, CallError> {
        let mut channels: *mut c_char = std::ptr::null_mut();
        let code = self.code(call!(self, more "buffer_active" (
            buffer.pointer() => *mut c_void, now_s => f64, &raw mut channels => *mut *mut c_char,
        ) -> i32))?;
        if code == 0 {
            return Ok(None);
        }
        self.taken(channels).map(Some)
    }

    pub(crate) fn buffer_reset(&self, buffer: &Object<'_>) -> Result<i32, CallError> {
        self.code(call!(self, more "buffer_reset" (buffer.pointer() => *mut c_void) -> i32))
    }

    pub(crate) fn link(&self, ref_loss: Option<f64>, threshold: Option<f64>) -> Result<Object<'_>, CallError> {
        let link = call!(self, more "link_new" (
            optional(ref_loss.as_ref()) => *const f64, optional(threshold.as_ref()) => *const f64,
        ) -> *mut c_void);
        self.object(link, "link_free")
    }

    pub(crate) fn link_on_frame(&self, link: &Object<'_>, seq: i64) -> Result<LinkReport, CallError> {
        self.code(call!(self, more "link_on_frame"
            (link.pointer() => *mut c_void, seq => i64) -> i32))?;
        let mut report = LinkReport::default();
        self.code(call!(self, more "link_report"
            (link.pointer() => *mut c_void, &raw mut report => *mut LinkReport) -> i32))?;
        Ok(report)
    }

    pub(crate) fn codec(&self, codec: &str) -> Result<Object<'_>, CallError> {
        let codec = c(codec)?;
        let codec = call!(self, more "codec_new" (codec.as_ptr() => *const c_char) -> *mut c_void);
        self.object(codec, "codec_free")
    }

    pub(crate) fn codec_encode(&self, codec: &Object<'_>, sensor: Option<&str>) -> Result<String, CallError> {
        let sensor = sensor.map(c).transpose()?;
        self.taken(call!(self, more "codec_encode" (
            codec.pointer() => *mut c_void, or_null(sensor.as_ref()) => *const c_char,
        ) -> *mut c_char))
    }

    pub(crate) fn codec_decode(&self, args: &Decode<'_>) -> Result<String, CallError> {
        let codec = self.codec(args.codec)?;
        let (rates, frame_id, mode) = (c(args.rates)?, c(args.frame_id)?, c(args.mode)?);
        self.taken(call!(self, more "codec_decode" (
            codec.pointer() => *mut c_void,
            rates.as_ptr() => *const c_char,
            args.t => f64,
            args.seq => i64,
            frame_id.as_ptr() => *const c_char,
            mode.as_ptr() => *const c_char,
        ) -> *mut c_char))
    }

    pub(crate) fn reflex_step(&self, config: &str, now_s: f64, sensor: Option<&str>) -> Result<String, CallError> {
        let config = c(config)?;
        let sensor = sensor.map(c).transpose()?;
        let reflex = call!(self, more "reflex_new" (config.as_ptr() => *const c_char) -> *mut c_void);
        let reflex = self.object(reflex, "reflex_free")?;
        self.taken(call!(self, more "reflex_step" (
            reflex.pointer() => *mut c_void,
            now_s => f64,
            or_null(sensor.as_ref()) => *const c_char,
        ) -> *mut c_char))
    }

    pub(crate) fn control_loop(&self, period_ms: f64, limits: &str, config: &str) -> Result<Object<'_>, CallError> {
        let (limits, config) = (c(limits)?, c(config)?);
        let control = call!(self, more "loop_new" (
            period_ms => f64,
            limits.as_ptr() => *const c_char,
            config.as_ptr() => *const c_char,
        ) -> *mut c_void);
        self.object(control, "loop_free")
    }

    pub(crate) fn loop_on_sensor(&self, control: &Object<'_>, sensor: &str, now_s: f64) -> Result<i32, CallError> {
        let sensor = c(sensor)?;
        self.code(call!(self, more "loop_on_sensor" (
            control.pointer() => *mut c_void, sensor.as_ptr() => *const c_char, now_s => f64,
        ) -> i32))
    }

    /// The command and the status of a tick.
    pub(crate) fn loop_tick(
        &self,
        control: &Object<'_>,
        now_s: f64,
        took_ms: f64,
    ) -> Result<(String, String), CallError> {
        let mut command: *mut c_char = std::ptr::null_mut();
        let mut status: *mut c_char = std::ptr::null_mut();
        self.code(call!(self, more "loop_tick" (
            control.pointer() => *mut c_void,
            now_s => f64,
            took_ms => f64,
            &raw mut command => *mut *mut c_char,
            &raw mut status => *mut *mut c_char,
        ) -> i32))?;
        let (command, status) = (self.taken(command), self.taken(status));
        Ok((command?, status?))
    }

    pub(crate) fn loop_reset(&self, control: &Object<'_>) -> Result<i32, CallError> {
        self.code(call!(self, more "loop_reset" (control.pointer() => *mut c_void) -> i32))
    }

    pub(crate) fn service(&self) -> Result<Object<'_>, CallError> {
        let service = call!(self, more "service_new" () -> *mut c_void);
        self.object(service, "service_free")
    }

    pub(crate) fn service_serve(&self, service: &Object<'_>, request: &str) -> Result<String, CallError> {
        self.taken(call!(self, more "service_serve" (
            service.pointer() => *mut c_void,
            request.as_ptr() => *const u8,
            request.len() => usize,
        ) -> *mut c_char))
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test fails by panicking")]
mod tests {
    use super::*;

    #[test]
    fn a_code_that_is_neither_yes_nor_no_is_the_librarys_fault() {
        assert!(yes(1).unwrap() && !yes(0).unwrap());
        for code in [2, -2, i32::MAX] {
            assert!(yes(code).unwrap_err().is_internal());
        }
    }
}
