//! What decoding allocates, counted by the allocator itself, for every directory that the harnesses draw.
#![allow(unsafe_code, reason = "a global allocator is an unsafe trait")]
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

use ncp_proofs::provers::native::{Enumerate, Native};
use ncp_readers::properties::bulk::block;
use ncp_spec::bulk::{Block, Column, unpack};

/// Counts the bytes for which each thread asks, so that tests may run side by side.
struct Counting;

thread_local! {
    static BYTES: Cell<usize> = const { Cell::new(0) };
}

// SAFETY: every call goes unchanged to the system's allocator.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        BYTES.set(BYTES.get() + layout.size());
        unsafe { System.alloc(layout) }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        BYTES.set(BYTES.get() + layout.size());
        unsafe { System.alloc_zeroed(layout) }
    }

    unsafe fn realloc(&self, old: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        BYTES.set(BYTES.get() + size);
        unsafe { System.realloc(old, layout, size) }
    }

    unsafe fn dealloc(&self, old: *mut u8, layout: Layout) {
        unsafe { System.dealloc(old, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Runs `work`, and returns its result and all bytes that it asked for.
fn counted<T>(work: impl FnOnce() -> T) -> (T, usize) {
    let before = BYTES.get();
    let result = work();
    (result, BYTES.get() - before)
}

/// Without optimisation, directories of one column and headers; with it, all of up to three columns.
const COLUMNS: usize = if cfg!(debug_assertions) { 1 } else { 3 };

#[test]
fn the_count_sees_what_is_allocated() {
    assert_eq!(counted(|| vec![1_u8; 1000]).1, 1000);
}

/// [NCP-BULK-024]
#[test]
fn no_directory_makes_the_decoder_allocate_more_than_the_block_has() {
    for property in ["bulk/header", "bulk/entry", "bulk/directories"] {
        let mut native = Native::new(Enumerate::new(&[], &[], COLUMNS));
        let (mut blocks, mut accepted) = (0_u64, 0_u64);
        loop {
            let block = block(property, &mut native).unwrap();
            blocks += 1;
            let (view, bytes) = counted(|| Block::parse(&block));
            // An error may say what it found; a view of so few columns needs nothing.
            assert_eq!(bytes, 0, "{block:?}");
            let (_, bytes) = counted(|| unpack(&block).is_ok());
            assert!(bytes <= block.len(), "{bytes} bytes of {block:?}");
            if let Ok(view) = view {
                accepted += 1;
                let (columns, bytes) = counted(|| view.to_columns());
                let own = columns.len() * size_of::<Column>();
                assert!(bytes <= block.len() + own, "{bytes} bytes of {block:?}");
            }
            if !native.draw.advance() {
                break;
            }
        }
        println!("{property}: {blocks} blocks, {accepted} accepted");
        assert!(blocks > accepted && accepted > 0, "{property}");
    }
}
