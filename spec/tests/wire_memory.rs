//! What decoding a frame may take, counted by the allocator itself. `[NCP-WIRE-070]`
#![allow(unsafe_code, reason = "a global allocator is an unsafe trait")]
#![allow(clippy::expect_used, clippy::panic, reason = "helpers of tests may panic as tests may")]

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::time::{Duration, Instant};

use ncp_spec::ErrorCode;
use ncp_spec::wire::{DecodeError, Message, decode_any};

/// Counts what each thread holds, so that tests may run side by side.
struct Counting;

thread_local! {
    static HELD: Cell<isize> = const { Cell::new(0) };
    static PEAK: Cell<isize> = const { Cell::new(0) };
}

fn count(change: isize) {
    let held = HELD.get() + change;
    HELD.set(held);
    PEAK.set(PEAK.get().max(held));
}

// SAFETY: every call goes unchanged to the system's allocator.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count(layout.size() as isize);
        unsafe { System.alloc(layout) }
    }

    unsafe fn realloc(&self, old: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        // The worst case: the old block is there until the new one is filled.
        count(size as isize);
        let new = unsafe { System.realloc(old, layout, size) };
        count(-(layout.size() as isize));
        new
    }

    unsafe fn dealloc(&self, old: *mut u8, layout: Layout) {
        count(-(layout.size() as isize));
        unsafe { System.dealloc(old, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Decodes, and says how many bytes were held at the peak, for each byte of the frame.
fn decode_counted(frame: &str) -> (Result<Message, DecodeError>, f64) {
    let before = HELD.get();
    PEAK.set(before);
    let result = decode_any(frame.as_bytes());
    (result, (PEAK.get() - before) as f64 / frame.len() as f64)
}

fn accepted(frame: &str, bound: f64) {
    let (result, ratio) = decode_counted(frame);
    let shown: String = frame.chars().take(60).collect();
    eprintln!("{ratio:6.1} bytes a byte: {shown} … {}", frame.len());
    result.unwrap_or_else(|error| panic!("{shown}: {error}"));
    assert!(ratio <= bound, "{shown}: {ratio} bytes a byte");
}

fn rejected(frame: &str, code: ErrorCode, bound: f64) {
    let (result, ratio) = decode_counted(frame);
    let shown: String = frame.chars().take(60).collect();
    eprintln!("{ratio:6.1} bytes a byte: {shown} … {}", frame.len());
    assert_eq!(result.expect_err(&shown).code(), code, "{shown}");
    assert!(ratio <= bound, "{shown}: {ratio} bytes a byte");
}

fn observation(members: &str) -> String {
    format!(r#"{{"kind":"observation_frame","session_id":"s",{members}}}"#)
}

fn list(count: usize, item: impl Fn(usize) -> String) -> String {
    let mut list = String::new();
    for nth in 0..count {
        list.push_str(if nth == 0 { "" } else { "," });
        list.push_str(&item(nth));
    }
    list
}

#[test]
fn the_count_sees_what_is_held_at_the_peak() {
    let before = HELD.get();
    PEAK.set(before);
    drop(vec![0_u8; 1_000]);
    drop(vec![0_u8; 500]);
    assert_eq!((PEAK.get() - before, HELD.get() - before), (1_000, 0));
}

/// A double or an integer takes eight bytes, and two on the wire.
#[test]
fn long_arrays_of_numbers_are_held_once() {
    let numbers = list(10_000_000, |_| "0".to_owned());
    for array in ["times", "values", "senders"] {
        accepted(&observation(&format!(r#""records":{{"p":{{"{array}":[{numbers}]}}}}"#)), 4.1);
    }
    // Of long numbers, eight bytes are still eight.
    let long = list(500_000, |_| "0.12345678901234567".to_owned());
    accepted(&observation(&format!(r#""records":{{"p":{{"times":[{long}]}}}}"#)), 0.5);
    // Many short ones, each the shortest that takes two allocations.
    let short = list(4_096, |nth| format!(r#""{nth}":{{"times":[0,0,0,0,0]}}"#));
    accepted(&observation(&format!(r#""records":{{{short}}}"#)), 16.0);
    // And numbers that never end.
    rejected(&observation(&format!(r#""records":{{"p":{{"times":[{numbers}"#)), ErrorCode::Malformed, 4.1);
    let commas = ",".repeat(10_000_000);
    rejected(&observation(&format!(r#""records":{{"p":{{"times":[0,0,0,0{commas}"#)), ErrorCode::Malformed, 8.1);
}

/// An ignored name takes eight bytes, and seven on the wire at least if there are many.
#[test]
fn ignored_members_are_held_as_their_places_only() {
    let members = list(1_000_000, |nth| format!(r#""{nth:x}":0"#));
    accepted(&observation(&members), 4.0);
    accepted(&observation(&format!(r#""x":[{{{members}}}]"#)), 4.0);
    let escaped = list(200_000, |nth| format!(r#""\u0061{nth:x}":"\u0061""#));
    accepted(&observation(&escaped), 4.0);
    let long = "a".repeat(20_000_000);
    accepted(&observation(&format!(r#""x":"{long}","{long}":0"#)), 0.1);
    accepted(&observation(&format!(r#""x":"\n{long}""#)), 3.1);
    accepted(&observation(&format!(r#""x":[{}]"#, list(5_000_000, |_| "{}".to_owned()))), 0.1);
}

/// The smallest messages and entries, as many as there may be.
#[test]
fn small_messages_are_held_within_a_constant() {
    let objects = list(4_096, |_| "{}".to_owned());
    let open = r#""kind":"open_session","session_id":"s","network":{}"#;
    accepted(&format!(r#"{{{open},"bindings":[{objects}]}}"#), 64.0);
    accepted(&format!(r#"{{{open},"record":{{"targets":[{objects}]}}}}"#), 64.0);
    accepted(&format!(r#"{{{open},"stimulus":{{"targets":[{objects}]}}}}"#), 64.0);
    accepted(&format!(r#"{{"kind":"capabilities","controller_id":"c","sensor_channels":[{objects}]}}"#), 64.0);
    let command = r#""kind":"command_frame""#;
    accepted(&format!(r#"{{{command},"horizon":[{objects}]}}"#), 64.0);
    let channels = list(4_096, |nth| format!(r#""{nth:x}":{{}}"#));
    accepted(&format!(r#"{{{command},"channels":{{{channels}}}}}"#), 64.0);
    accepted(&observation(&format!(r#""records":{{{channels}}}"#)), 64.0);
    for entries in [r#"{"":{}}"#, r#"{"":{},"a":{}}"#, r#"{"":{},"a":{},"b":{}}"#] {
        accepted(&format!(r#"{{{command},"horizon":[{}]}}"#, list(4_096, |_| entries.to_owned())), 64.0);
    }
    let strings = list(4_096, |_| r#""""#.to_owned());
    accepted(&format!(r#"{{{open},"record":{{"targets":[{{"recordables":[{strings}]}}]}}}}"#), 64.0);
    accepted(r#"{"kind":"link_status"}"#, 0.1);
}

#[test]
fn a_frame_too_long_is_rejected_unread() {
    let long = format!(r#"{{"kind":"observation_frame","x":"{}"}}"#, "a".repeat(64 << 20));
    rejected(&long, ErrorCode::Limit, 0.1);
}

#[test]
fn a_million_names_are_compared_in_time() {
    let began = Instant::now();
    let mut members = list(1_000_000, |nth| format!(r#""{nth:x}":0"#));
    assert!(decode_any(observation(&members).as_bytes()).is_ok());
    // The first name once more, at the end and in another spelling.
    members.push_str(r#","\u0030":0"#);
    let repeated = decode_any(observation(&members).as_bytes()).expect_err("a repeated name");
    assert_eq!((repeated.code(), repeated.path()), (ErrorCode::Malformed, "0"));
    // Long names that differ at their ends only.
    let prefix = "a".repeat(1_000);
    let members = list(20_000, |nth| format!(r#""{prefix}{nth}":0"#));
    assert!(decode_any(observation(&members).as_bytes()).is_ok());
    assert!(began.elapsed() < Duration::from_secs(60), "{:?}", began.elapsed());
}
