//! What crosses the boundary: texts, bytes, handles, errors. And nothing else: no panic does.

use std::any::Any;
use std::cell::RefCell;
use std::ffi::{CStr, CString, c_char};
use std::fmt::Display;
use std::marker::PhantomData;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::ptr;

use ncp_spec::ErrorCode;
use ncp_spec::bulk::BulkError;
use ncp_spec::contract::{ContractError, NegotiateError};
use ncp_spec::control::{LoopError, ReflexError};
use ncp_spec::keys::KeyError;
use ncp_spec::reply::ReplyError;
use ncp_spec::version::VersionError;
use ncp_spec::wire::{DecodeError, EncodeError};

/// Why a call failed.
#[derive(Debug)]
pub(crate) struct Refusal {
    pub(crate) code: ErrorCode,
    pub(crate) message: String,
}

impl Refusal {
    pub(crate) fn new(code: ErrorCode, message: impl Display) -> Self {
        let message = message.to_string();
        Self { code, message }
    }

    fn null(what: &str) -> Self {
        Self::new(ErrorCode::Missing, format_args!("{what} is NULL"))
    }
}

macro_rules! refusals {
    ($($error:ty),+) => {$(
        impl From<$error> for Refusal {
            fn from(error: $error) -> Self {
                Self::new(error.code(), error)
            }
        }
    )+};
}

impl From<serde_json::Error> for Refusal {
    fn from(error: serde_json::Error) -> Self {
        let code = match error.classify() {
            serde_json::error::Category::Data => ErrorCode::Type,
            _ => ErrorCode::Malformed,
        };
        Self::new(code, error)
    }
}

refusals! {
    BulkError, ContractError, DecodeError, EncodeError, KeyError, LoopError, NegotiateError, ReflexError, ReplyError,
    VersionError
}

/// The body of every exported function: what it returns, or, when it fails or panics, the value that
/// says so to C. The reason is then what `ncp_last_error` gives.
pub(crate) fn entry<T: Failed>(call: impl FnOnce() -> Result<T, Refusal>) -> T {
    // What a panic leaves half done in a handle is never used again: see `Handle`.
    let refusal = match catch_unwind(AssertUnwindSafe(call)) {
        Ok(Ok(value)) => return value,
        Ok(Err(refusal)) => refusal,
        Err(payload) => {
            let why = format!("panic: {}", what_was_said(&*payload));
            // Dropping a stranger's payload could panic again, outside of the guard.
            std::mem::forget(payload);
            Refusal::new(ErrorCode::Internal, why)
        }
    };
    remember(&refusal);
    T::FAILED
}

fn what_was_said(payload: &(dyn Any + Send)) -> &str {
    let text = payload.downcast_ref::<&str>().copied();
    let text = text.or_else(|| payload.downcast_ref::<String>().map(String::as_str));
    text.unwrap_or("without a message")
}

/// What a function returns when it failed.
pub(crate) trait Failed {
    const FAILED: Self;
}

impl Failed for () {
    const FAILED: Self = ();
}

impl Failed for i32 {
    const FAILED: Self = -1;
}

impl Failed for usize {
    const FAILED: Self = 0;
}

impl<T> Failed for *mut T {
    const FAILED: Self = ptr::null_mut();
}

impl<T> Failed for *const T {
    const FAILED: Self = ptr::null();
}

impl<T> Failed for Option<Box<T>> {
    const FAILED: Self = None;
}

/// `true` as 1, `false` as 0.
pub(crate) fn yes(answer: bool) -> i32 {
    i32::from(answer)
}

thread_local! {
    /// The code and the message of the last failure on this thread.
    static LAST: RefCell<Option<(CString, CString)>> = const { RefCell::new(None) };
}

fn remember(refusal: &Refusal) {
    let code = c_string(refusal.code.as_str().to_owned());
    let message = c_string(refusal.message.clone());
    // A thread that is about to end has no place left for it. What stood there is dropped last.
    let _ = LAST.try_with(|last| last.try_borrow_mut().map(|mut last| last.replace((code, message))));
}

/// Why the last call on this thread that failed did so, in words, or NULL if none has failed. It is
/// lent: the next failure on this thread ends it, so copy what is to last.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_last_error() -> *const c_char {
    last(|(_, message)| message)
}

/// The same reason in one word: malformed, type, kind, missing, value, provenance, limit, version,
/// contract, key, block, non_finite, reply, invalid; or internal, which is a defect of this library.
/// Lent like the message.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_last_error_code() -> *const c_char {
    last(|(code, _)| code)
}

fn last(which: impl FnOnce(&(CString, CString)) -> &CString) -> *const c_char {
    let stored = LAST.try_with(|last| {
        let last = last.try_borrow().ok()?;
        Some(which(last.as_ref()?).as_ptr())
    });
    stored.ok().flatten().unwrap_or(ptr::null())
}

/// A C string; `NUL`s, which only an error message could hold, are shown as such.
fn c_string(text: String) -> CString {
    CString::new(text).unwrap_or_else(|error| {
        let text = String::from_utf8_lossy(&error.into_vec()).replace('\0', "\u{2400}");
        CString::new(text).unwrap_or_default()
    })
}

/// Hands a text over to the caller, who frees it with `ncp_string_free`.
///
/// # Errors
/// It holds a NUL, so that C would see only its beginning.
pub(crate) fn text_out(text: impl Into<String>) -> Result<*mut c_char, Refusal> {
    CString::new(text.into()).map(CString::into_raw).map_err(|error| Refusal::new(ErrorCode::Internal, error))
}

/// Frees what [`text_out`] handed over.
///
/// # Safety
/// The text is null, or came from this library and is not used again.
pub(crate) unsafe fn free_text(text: *mut c_char) {
    if !text.is_null() {
        // SAFETY: it came from `CString::into_raw`, once.
        drop(unsafe { CString::from_raw(text) });
    }
}

/// A C string that the caller lends for the time of the call, or null: in C, `const char *`.
///
/// Only a C caller makes one, and by the header's rules: it is null, or it ends with a NUL and stays
/// as it is until the call returns.
#[repr(transparent)]
#[derive(Clone, Copy)]
pub struct Text<'a>(*const c_char, PhantomData<&'a CStr>);

impl<'a> Text<'a> {
    /// What the string says, if there is one.
    ///
    /// # Errors
    /// It is not UTF-8.
    pub(crate) fn optional(self, what: &str) -> Result<Option<&'a str>, Refusal> {
        if self.0.is_null() {
            return Ok(None);
        }
        // SAFETY: it is not null, so it is a C string that lives as long as the call.
        let text = unsafe { CStr::from_ptr(self.0) };
        match text.to_str() {
            Ok(text) => Ok(Some(text)),
            Err(error) => Err(Refusal::new(ErrorCode::Malformed, format_args!("{what} is not UTF-8: {error}"))),
        }
    }

    /// What the string says.
    ///
    /// # Errors
    /// It is null, or not UTF-8.
    pub(crate) fn required(self, what: &str) -> Result<&'a str, Refusal> {
        self.optional(what)?.ok_or_else(|| Refusal::null(what))
    }
}

#[cfg(test)]
impl<'a> From<&'a CStr> for Text<'a> {
    fn from(text: &'a CStr) -> Self {
        Self(text.as_ptr(), PhantomData)
    }
}

#[cfg(test)]
impl Text<'_> {
    pub(crate) const NULL: Self = Self(ptr::null(), PhantomData);
}

/// What is required of the caller, and is there.
///
/// # Errors
/// It is null.
pub(crate) fn required<T>(pointer: Option<T>, what: &str) -> Result<T, Refusal> {
    pointer.ok_or_else(|| Refusal::null(what))
}

/// The items that the caller lends. Null is right only for none of them.
///
/// # Errors
/// Null for at least one item; not aligned for its type; more than memory can hold.
///
/// # Safety
/// If not null, `items` points to `count` items that stay as they are for `'a`.
pub(crate) unsafe fn items<'a, T>(items: *const T, count: usize, what: &str) -> Result<&'a [T], Refusal> {
    if count == 0 {
        return Ok(&[]);
    }
    if items.is_null() {
        return Err(Refusal::null(what));
    }
    let wrong = |why| Err(Refusal::new(ErrorCode::Invalid, format_args!("{what} {why}")));
    if !items.is_aligned() {
        return wrong("is not aligned for the type of its values");
    }
    if count > isize::MAX as usize / size_of::<T>().max(1) {
        return wrong("is larger than memory");
    }
    // SAFETY: not null, aligned, not too large; the caller vouches for the rest.
    Ok(unsafe { std::slice::from_raw_parts(items, count) })
}

/// The bytes that the caller lends.
///
/// # Errors
/// They are null, even if there are none.
///
/// # Safety
/// As for [`items`].
pub(crate) unsafe fn bytes<'a>(start: *const u8, len: usize, what: &str) -> Result<&'a [u8], Refusal> {
    if start.is_null() {
        return Err(Refusal::null(what));
    }
    // SAFETY: the caller vouches for it.
    unsafe { items(start, len, what) }
}

/// A text of known length that the caller lends, or null for none.
///
/// # Errors
/// It is not UTF-8, or null with a length.
///
/// # Safety
/// As for [`items`].
pub(crate) unsafe fn sized<'a>(text: *const c_char, len: usize, what: &str) -> Result<Option<&'a str>, Refusal> {
    if text.is_null() && len == 0 {
        return Ok(None);
    }
    // SAFETY: the caller vouches for it.
    let bytes = unsafe { bytes(text.cast::<u8>(), len, what)? };
    match str::from_utf8(bytes) {
        Ok(text) => Ok(Some(text)),
        Err(error) => Err(Refusal::new(ErrorCode::Malformed, format_args!("{what} is not UTF-8: {error}"))),
    }
}

/// An object that lives between calls.
///
/// A panic within it leaves it half changed. From then on it does nothing but fail, which holds the
/// plant, until it is freed.
pub(crate) struct Handle<T> {
    value: T,
    broken: bool,
}

impl<T> Handle<T> {
    pub(crate) const fn new(value: T) -> Self {
        let broken = false;
        Self { value, broken }
    }

    /// Does something with the object.
    ///
    /// # Errors
    /// An earlier call panicked; or what `f` fails with.
    pub(crate) fn with<R>(&mut self, f: impl FnOnce(&mut T) -> Result<R, Refusal>) -> Result<R, Refusal> {
        if self.broken {
            let why = "the object is broken: an earlier call panicked within it";
            return Err(Refusal::new(ErrorCode::Internal, why));
        }
        self.broken = true;
        let result = f(&mut self.value);
        self.broken = false;
        result
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The reason of the last failure on this thread.
    fn said() -> (String, String) {
        let read = |text: *const c_char| {
            // SAFETY: both are lent and read at once.
            unsafe { CStr::from_ptr(text) }.to_str().unwrap().to_owned()
        };
        (read(ncp_last_error_code()), read(ncp_last_error()))
    }

    #[test]
    #[allow(clippy::panic, reason = "the panic is what is tested")]
    fn a_panic_becomes_the_failure_of_the_call_and_says_so() {
        extern "C" fn panics() -> i32 {
            entry(|| panic!("forced {}", "here"))
        }
        assert_eq!(panics(), -1);
        let (code, message) = said();
        assert_eq!((code.as_str(), message.as_str()), ("internal", "panic: forced here"));
    }

    #[test]
    #[allow(clippy::panic, reason = "the panic is what is tested")]
    fn an_object_within_which_a_call_panicked_only_fails_from_then_on() {
        let mut handle = Handle::new(7);
        assert_eq!(entry(|| handle.with(|value| Ok(*value))), 7);
        let refused = entry(|| handle.with(|_| Err::<i32, _>(Refusal::null("it"))));
        assert_eq!(refused, -1);
        assert_eq!(entry(|| handle.with(|value| Ok(*value))), 7, "a refusal breaks nothing");
        assert_eq!(entry(|| handle.with(|_| -> Result<i32, Refusal> { panic!() })), -1);
        assert_eq!(entry(|| handle.with(|value| Ok(*value))), -1);
        assert!(said().1.contains("broken"));
    }

    #[test]
    fn an_error_message_with_a_nul_is_told_to_its_end() {
        assert_eq!(entry(|| Err::<i32, _>(Refusal::new(ErrorCode::Key, "a\0b"))), -1);
        assert_eq!(said(), ("key".to_owned(), "a\u{2400}b".to_owned()));
    }

    #[test]
    fn a_thread_without_a_failure_has_no_last_error() {
        std::thread::spawn(|| {
            assert!(ncp_last_error().is_null());
            assert!(ncp_last_error_code().is_null());
        })
        .join()
        .unwrap();
    }

    #[test]
    fn null_stands_for_no_items_and_only_for_none() {
        // SAFETY: nothing is read through a null pointer.
        unsafe {
            assert!(items::<f64>(ptr::null(), 0, "it").unwrap().is_empty());
            assert!(items::<f64>(ptr::null(), 1, "it").is_err());
            assert!(bytes(ptr::null(), 0, "it").is_err());
            assert_eq!(sized(ptr::null(), 0, "it").unwrap(), None);
            assert!(sized(ptr::null(), 1, "it").is_err());
        }
    }

    #[test]
    fn items_that_are_not_aligned_or_larger_than_memory_are_refused() {
        let values = [1.0_f64, 2.0];
        // SAFETY: neither is read: both are refused by address and count alone.
        unsafe {
            let askew = values.as_ptr().cast::<u8>().add(1).cast::<f64>();
            assert!(items(askew, 1, "it").is_err());
            assert!(items(values.as_ptr(), usize::MAX / 4, "it").is_err());
        }
    }

    /// Every exported function runs within [`entry`], so that none lets a panic out; those few that
    /// do not, cannot panic.
    #[test]
    fn every_exported_function_runs_within_the_guard() {
        const BARE: [&str; 2] = ["ncp_last_error", "ncp_last_error_code"];
        let sources = [
            include_str!("abi.rs"),
            include_str!("bulk.rs"),
            include_str!("control.rs"),
            include_str!("safety.rs"),
            include_str!("seed.rs"),
            include_str!("session.rs"),
            include_str!("wire.rs"),
        ];
        let mut seen = 0;
        for exported in sources.iter().flat_map(|source| source.split("#[unsafe(no_mangle)]\npub ").skip(1)) {
            let (_, signature) = exported.split_once("fn ").unwrap();
            let name = signature.split('(').next().unwrap();
            let (_, body) = signature.split_once("{\n").unwrap();
            let guarded = body.trim_start().starts_with("entry(");
            assert!(guarded || BARE.contains(&name), "{name}");
            seen += 1;
        }
        assert!(seen > 60, "{seen}");
    }
}
