// Counts what is allocated, for `ncp_fuzz_bodies::memory`. A program that includes this file has the
// allocator; it stands apart because an allocator is an unsafe trait.

use std::alloc::{GlobalAlloc, Layout, System};

struct Counting;

// SAFETY: every call goes unchanged to the system's allocator.
#[allow(unsafe_code, reason = "a global allocator is an unsafe trait")]
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ncp_fuzz_bodies::memory::note(layout.size());
        unsafe { System.alloc(layout) }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        ncp_fuzz_bodies::memory::note(layout.size());
        unsafe { System.alloc_zeroed(layout) }
    }

    unsafe fn realloc(&self, old: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        ncp_fuzz_bodies::memory::note(size);
        unsafe { System.realloc(old, layout, size) }
    }

    unsafe fn dealloc(&self, old: *mut u8, layout: Layout) {
        unsafe { System.dealloc(old, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;
